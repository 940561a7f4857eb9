# SPDX-License-Identifier: Apache-2.0
"""*CONSTRAINED_SPR2: what a user gets of check, run and modes, and after a restart."""
import csv
import io
import unittest

from lap_joint import edited
from nugget_command import CommandTest
from repeated_runs import RepeatedRuns
from test_interpolation_spotwelds import MODES
from test_swforc import joined_by


def fields(*values):
    return "".join(f"{v:>10}" for v in values) + "\n"


def riveted(displacement=1.0, force=5000.0, more=""):
    """The lap joint with one rivet at (9, 9) in place of its beam, which is gone at a displacement."""
    return joined_by(f"*NODE\n{401:8d}{9.0:16.4f}{9.0:16.4f}{0.6:16.4f}\n*SET_NODE_LIST\n" + fields(77) + fields(401)
                     + "*CONSTRAINED_SPR2\n" + fields(1, 2, 77, 2.4, 6.0, 0.6 * force, force, displacement)
                     + fields(displacement, 0.4, 0.5, 0.8, 0.8, 0.8, 7.85e-9) + more)


class SelfPiercingRivets(CommandTest):
    def row(self, folder):
        return next(csv.DictReader(io.StringIO(self.read(f"{folder}/welds.csv"))))

    def test_holds_and_is_reported(self):
        self.write(riveted())
        self.nugget("run", "model.k", "-o", "out")
        row = self.row("out")
        self.assertEqual((row["id"], row["sheet1"], row["sheet2"], row["tied"], row["failed"]), ("401", "1", "2", "yes", "no"))
        self.assertTrue(0.0 < float(row["damage"]) < 1.0, row["damage"])
        self.assertEqual(row["damage"][:6], row["peak_failure"][:6])
        self.assertIn("effective displacement", row["last_terms"])
        lines = [line for line in self.read("out/swforc").splitlines() if "nonnodal cnst  ID        401" in line]
        self.assertGreater(len(lines), 10)

    def test_breaks(self):
        self.write(riveted(displacement=0.002, force=200.0))
        self.nugget("run", "model.k", "-o", "out")
        row = self.row("out")
        self.assertEqual((row["failed"], float(row["damage"])), ("yes", 1.0))
        self.assertIn("self-piercing rivet failed  id=     401", self.read("out/run.log"))
        self.assertLess(float(row["peak_shear"]), 200.01)

    def test_modes_know_its_stiffness(self):
        first = []
        for name, force in (("stiff", 1e5), ("soft", 1e1)):
            self.write(edited(riveted(force=force), ("*TITLE\n", MODES + "*TITLE\n")), f"{name}.k")
            self.nugget("modes", f"{name}.k", "-o", name, "-n", "8")
            first.append(self.json(f"{name}/summary.json")["modes"][5]["frequency_hz"])
        self.assertGreater(first[0], 1.05 * first[1])

    def test_what_is_refused(self):
        self.write(riveted(more=fields(8.0, 8.0) + fields(2)))
        run = self.nugget("run", "model.k", "-o", "out", expect=1)
        self.assertIn("*CONSTRAINED_SPR2 xpid1 = 2", run.stderr)


class RepeatedRivets(RepeatedRuns):
    def test_resumed_while_damaged(self):
        self.resumed(riveted(displacement=0.02), shares=(0.5,))


if __name__ == "__main__":
    unittest.main()
