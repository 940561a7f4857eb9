# SPDX-License-Identifier: Apache-2.0
"""The same bits with one, two and three threads, in every result file."""
import re
import subprocess
import sys
import unittest

from lap_joint import deck
from nugget_command import SOURCE
from repeated_runs import RepeatedRuns


class SameBits(RepeatedRuns):
    def test_double_hat_welds_contact_wall_and_rigid_sled(self):
        subprocess.run([sys.executable, str(SOURCE / "examples" / "double_hat" / "make.py"), str(self.folder)], check=True)
        files = self.compare("double_hat.k", "--until", "2.0e-4")
        self.assertLessEqual({"d3plot", "d3plot01", "swforc", "glstat", "matsum", "nodout", "rwforc", "rbdout"}, set(files))
        self.assertGreater(len(files["swforc"]), 10000)

    def test_every_kind_of_damping(self):
        """Upper hat by stiffness and by deformation, lower hat by deformation, all nodes by two more; and deformation alone."""
        subprocess.run([sys.executable, str(SOURCE / "examples" / "double_hat" / "make.py"), str(self.folder)], check=True)
        text = (self.folder / "double_hat.k").read_text(encoding="ascii")
        cards = ("*DAMPING_GLOBAL\n         0      50.0\n*DAMPING_PART_STIFFNESS\n         1      0.05\n"
                 "*DAMPING_FREQUENCY_RANGE\n      0.02     100.0   10000.0\n*DAMPING_FREQUENCY_RANGE_DEFORM\n      0.02     100.0   10000.0\n")
        self.compare(self.write(text.replace("*END", cards + "*END")), "--until", "1.0e-4")
        glstat = (self.folder / "t1" / "glstat").read_text(encoding="ascii")
        damping = float(re.findall(r"system damping energy\.+ *(\S+)", glstat)[-1])
        self.assertGreater(damping, 0.0)

    def test_folds_with_edges_against_edges(self):
        subprocess.run([sys.executable, str(SOURCE / "examples" / "hat_crush" / "make.py"), str(self.folder)], check=True)
        text = (self.folder / "hat_poor.k").read_text(encoding="ascii")
        general = text.replace("CONTACT_AUTOMATIC_SINGLE_SURFACE_ID", "CONTACT_AUTOMATIC_GENERAL_INTERIOR_ID")
        self.assertNotEqual(general, text)
        self.compare(self.write(general), "--until", "3.0e-4")

    def test_lap_joint_whose_weld_fails(self):
        self.compare(self.write(deck(("    8000.0    6000.0    6000.0", "    8000.0    1000.0    1000.0"))))

    def test_a_different_load_gives_other_bits(self):
        """The comparison can fail."""
        self.write(deck(), "a.k")
        self.write(deck(("             1.0e-05               500.0", "             1.0e-05               500.1")), "b.k")
        self.nugget("run", "a.k", "-o", "a", "--quiet")
        self.nugget("run", "b.k", "-o", "b", "--quiet")
        a, b = self.bits("a"), self.bits("b")
        for name in ("d3plot01", "swforc", "glstat", "matsum", "nodout"):
            self.assertNotEqual(a[name], b[name], name)

    def test_car6(self):
        self.compare(self.shared("decks/car6/main_v223.k"), "--until", "0.005")


if __name__ == "__main__":
    unittest.main()
