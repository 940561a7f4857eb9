# SPDX-License-Identifier: Apache-2.0
"""The same bits with one, two and three threads, in every result file."""
import random
import re
import subprocess
import sys
import unittest

from fabric_bag import pillow
from few_elements import card
from lap_joint import deck
from nugget_command import SOURCE
from repeated_runs import LANES, RepeatedRuns, with_lanes


def cubes_on_a_sheet(n=5):
    """Four elastic cubes of 10 mm on a corner of a sheet of n x n shells, whose nodes they share, in random motion, TSSFAC at its default."""
    node = lambda i, j, k: 1 + i + (n + 1) * (j + (n + 1) * k)  # noqa: E731
    chance = random.Random(7)
    corners = [(i, j) for j in range(n) for i in range(n)]
    nodes = [(node(i, j, k), 10.0 * i, 10.0 * j, 10.0 * k) for k in (0, 1) for j in range(n + 1) for i in range(n + 1) if k == 0 or max(i, j) <= 2]
    return "\n".join([
        "*KEYWORD", "*CONTROL_TERMINATION", "2.0e-4", "*DATABASE_GLSTAT", "1.0e-5", "*DATABASE_BINARY_D3PLOT", "1.0e-4",
        "*MAT_ELASTIC", "1,7.85e-9,2.1e5,0.3", "*SECTION_SOLID", "1,1", "*SECTION_SHELL", "2,2,0.8333,2", "1.0,1.0,1.0,1.0",
        "*PART", "cubes", "1,1,1", "*PART", "sheet", "2,2,1", "*NODE", *(f"{i},{x},{y},{z}" for i, x, y, z in nodes),
        "*ELEMENT_SOLID",
        *(f"{1 + e},1,{','.join(str(node(i + a, j + b, k)) for k in (0, 1) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)))}"
          for e, (i, j) in enumerate(corners) if max(i, j) < 2),
        "*ELEMENT_SHELL",
        *(f"{1001 + e},2,{','.join(str(node(i + a, j + b, 0)) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)))}" for e, (i, j) in enumerate(corners)),
        "*INITIAL_VELOCITY_NODE", *(f"{i},{','.join(f'{chance.uniform(-1, 1):.6f}' for _ in range(3))}" for i, *_ in nodes), "*END", ""])


class SameBits(RepeatedRuns):
    def test_double_hat_welds_contact_wall_and_rigid_sled(self):
        subprocess.run([sys.executable, str(SOURCE / "examples" / "double_hat" / "make.py"), str(self.folder)], check=True)
        files = self.compare("double_hat.k", "--until", "2.0e-4")
        self.assertLessEqual({"d3plot", "d3plot01", "swforc", "glstat", "matsum", "nodout", "rwforc", "rbdout"}, set(files))
        self.assertGreater(len(files["swforc"]), 10000)

    def test_a_bag_of_fabric(self):
        for form, leaks in ((0, ""), (12, card(0, 0.02, 0.5, 0.1, "", 12, 2))):
            with self.subTest(form):
                text = pillow(9, form=form)
                self.write(text.replace(card(0, "", "", "", "", form), leaks) if leaks else text)
                files = self.compare("model.k", "--until", "2.0e-3")
                self.assertLessEqual({"d3plot", "glstat", "abstat"}, set(files))

    def test_bricks_beside_shells_under_the_assembled_step(self):
        """Which elements that step counts must not depend on how many stand in a block: here shells beside cubes."""
        text = cubes_on_a_sheet()
        self.compare(self.write(text))

    def test_lanes_by_request(self):
        model = self.write(deck())
        self.nugget("run", model, "--quiet", "--max-cycles", 2)
        self.assertEqual(self.json("summary.json")["lanes"], LANES[-1])
        run = self.nugget("run", model, "--quiet", env=with_lanes(5), expect=2)
        self.assertIn("NUGGET_LANES is '5', expected 4 (AVX2) or 8 (AVX-512)", run.stderr)

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

    def test_bricks_whose_steps_are_equal_but_for_rounding(self):
        """Which of them glstat names at cycle 3399 must not depend on how many stand in a block."""
        self.compare(self.shared("decks/box_drop/main.k"), "--max-cycles", 3600)


if __name__ == "__main__":
    unittest.main()
