# SPDX-License-Identifier: Apache-2.0
"""*CONTROL_COARSEN through the command: check, a run with a weld, and what they tell."""
import math
import unittest

from nugget_command import CommandTest
from test_weld_command import large_sheets


class Coarsening(CommandTest):
    def test_a_welded_pair_of_sheets(self):
        self.write(large_sheets("*CONTROL_COARSEN\n         1       8.0\n*INITIAL_VELOCITY_GENERATION\n"
                                "         1         2       0.0       0.0       0.0    1000.0\n\n"), "car/sheets.k")
        self.write("22.5, 22.5, 0.6, 5.0\n", "points.csv")
        self.nugget("weld", "points.csv", "car/sheets.k", "-o", "joined.k")
        self.nugget("check", "joined.k", "-o", "audit")
        (note,) = [f for f in self.json("audit/findings.json") if f["keyword"] == "*CONTROL_COARSEN"]
        self.assertEqual(note["severity"], "note")
        self.assertTrue(note["file"].endswith("sheets.k"))
        self.assertRegex(note["text"], r"^128 shells became 50: 26 times four to one; \d+ nodes are gone, 16 are hanging nodes on the side")
        self.nugget("run", "joined.k", "--quiet", "-o", "results")
        summary = self.json("results/summary.json")
        self.assertEqual(summary["elements"]["shell"], 50)
        self.assertTrue(summary["weld"][0]["tied"])
        mass = 7.85e-9 * 1.2 * (2 * 40 * 40 + math.pi / 4 * 5.0 ** 2)
        self.assertAlmostEqual(summary["mass"]["physical"] / mass, 1.0, 6)
        self.assertAlmostEqual(summary["energy"]["ratio"], 1.0, 6)
        self.assertIn("128 shells became 50", self.read("results/run.log"))


if __name__ == "__main__":
    unittest.main()
