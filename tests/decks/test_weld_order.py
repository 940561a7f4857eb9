# SPDX-License-Identifier: Apache-2.0
"""Sheets that penetrate each other in the deck: contact moves them apart, then welds are projected; check, run and modes say the
same of it, in findings, run.log and welds.csv."""
import csv
import io
import unittest

from nugget_command import CommandTest, line_of
from welded_sheets import Sheets, weld_material


def deck(lower, upper, contact="", bricks=False, free=False):
    """Two strips of 1 mm with mid-surfaces at these heights, two welds between them; held at one end or free."""
    s = Sheets(16 if free else 2)
    s.cards += ["*CONTROL_TERMINATION\n1.0e-5", "*CONTROL_CONTACT\n0.1\n0\n0.0\n0,0,0,0,1", weld_material(2)]
    sheets = [s.sheet(1.0, 0.0, 0.0, z, 6, 3, 10.0) for z in (lower, upper)]
    welds = s.brick_part(2) if bricks else s.beam_part(5.0, 2)
    for x in (15.0, 45.0):
        if bricks:
            s.brick(welds, x, 15.0, lower, 4.4311, upper - lower)
        else:
            s.beam(welds, (x, 15.0, lower), (x, 15.0, upper))
    s.tie([welds], sheets)
    if not free:
        s.node_set(1, s.column(sheets[0], 0))
        s.cards.append("*BOUNDARY_SPC_SET\n1,0,1,1,1,1,1,1")
    return s.text().replace("*NODE", contact + "*NODE", 1)


SLIDING = "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n0.0\n1.0,1.0\n"


class WeldOrder(CommandTest):
    def welds(self, folder):
        return list(csv.DictReader(io.StringIO(self.read(f"{folder}/welds.csv"))))

    def test_check_run_and_modes_say_the_same(self):
        """Sabotage: ties before contact in one of the commands."""
        for bricks in (False, True):
            for apart in (0.6, 0.04):
                with self.subTest(bricks=bricks, apart=apart):
                    model = self.write(deck(0.0, apart, SLIDING, bricks))
                    said = {}
                    for command, log in (("check", "check.log"), ("run", "run.log"), ("modes", "run.log")):
                        out = f"{command}{bricks}{apart}"
                        self.nugget(command, model, "-o", out)
                        told = [line_of(f) for f in self.json(f"{out}/findings.json")]
                        said[command] = [line for line in told if "penetrat" in line or "moved out" in line]
                        rows = self.welds(out)
                        self.assertEqual([(r["tied"], r["case1"], r["case2"]) for r in rows], [("yes", "4", "4")] * 2)
                        for r in rows:
                            self.assertAlmostEqual(float(r["length"]), 1.0, delta=1e-3)
                            self.assertAlmostEqual(float(r["moved1"]), 0.5 * (1.0 - apart), delta=1e-3)
                            self.assertIn(f"penetrated each other by {1.0 - apart:.4g}; contact moved this one by", r["reason1"])
                        words = f"penetrated each other by {1.0 - apart:.4g}; contact moved this one by"
                        self.assertTrue(any(words in line and "moved" in line.rsplit("away", 1)[1] for line in said[command]), told)
                        self.assertIn(words, self.read(f"{out}/{log}"))
                    self.assertEqual(said["check"], said["run"])
                    self.assertEqual(said["check"], said["modes"])
                    self.assertEqual(len([line for line in said["run"] if "moved out (IGNORE = 0)" in line]), 1)

    def test_modes_are_those_of_the_sheets_apart(self):
        """The same structure, meshed apart and without contact. Sabotage: modes on the deck's own places."""
        frequencies = []
        for model in (deck(0.0, 0.6, SLIDING, free=True), deck(-0.2, 0.8, free=True), deck(0.0, 0.6, free=True)):
            self.nugget("modes", self.write(model), "-n", 10, "-o", "out")
            frequencies.append([m["frequency_hz"] for m in self.json("out/summary.json")["modes"]][6:])
        for moved, apart in zip(frequencies[0], frequencies[1]):
            self.assertAlmostEqual(moved / apart, 1.0, delta=1e-3)
        self.assertGreater(max(abs(a / b - 1.0) for a, b in zip(frequencies[1], frequencies[2])), 0.02)  # the test can fail


if __name__ == "__main__":
    unittest.main()
