# SPDX-License-Identifier: Apache-2.0
"""Welds of bricks by the command: weld beams replaced by clusters, and a public fragment of a car with brick welds."""
import csv
import io
import unittest

from lap_joint import deck
from nugget_command import CommandTest
from welded_sheets import Sheets, weld_material


class BrickWelds(CommandTest):
    def replaced_by(self, bricks):
        self.write(deck().replace("*END", f"*CONTROL_SPOTWELD_BEAM\n{bricks:>60}\n*END"), "lap.k")
        self.nugget("run", "lap.k", "-o", f"out{bricks}", "--quiet")
        return self.json(f"out{bricks}/summary.json"), self.read(f"out{bricks}/swforc"), self.read(f"out{bricks}/run.log")

    def test_weld_beams_become_bricks(self):
        for bricks, label, kind in ((1, "spotweld solid ID", "solid"), (4, "spotweld assmy ID", "assembly"),
                                    (8, "spotweld assmy ID", "assembly")):
            with self.subTest(bricks=bricks):
                summary, swforc, log = self.replaced_by(bricks)
                self.assertEqual(summary["elements"]["beam"], 0)
                self.assertEqual(summary["elements"]["solid"], bricks)
                (weld,) = summary["weld"]
                self.assertEqual(weld["kind"], kind)
                self.assertTrue(weld["tied"])
                self.assertAlmostEqual(weld["diameter"], 6.0, delta=1e-3)  # the area of the beam
                self.assertGreater(weld["peak"]["shear"], 0.0)
                rows = [line for line in swforc.splitlines() if label in line]
                self.assertTrue(rows)
                self.assertIn(f"{label}   {weld['id']:>8}"[:28], rows[-1])
                self.assertRegex(log, rf"weld +{weld['id']} of part +3, A = 28.274 mm2:" + r"( \d+)" * bricks + r"\n")

    def test_a_brick_turned_inside_out_gives_no_nan(self):
        """One end of the weld has no area. Sabotage: its centre divided by that."""
        s = Sheets()
        s.cards += ["*CONTROL_TERMINATION\n2.0e-6", "*DATABASE_SWFORC\n1.0e-7", weld_material(2)]
        sheets = [s.sheet(1.0, 0, 0, z, 3, 3, 5.0) for z in (0.0, 1.2)]
        bricks = s.brick_part(2)
        s.brick(bricks, 3.0, 3.0, 0.0, 4.0, 1.2)
        s.solids[-1] = ",".join([*s.solids[-1].split(",")[:2], "3", *s.solids[-1].split(",")[3:]])
        s.tie([bricks], sheets)
        self.write(s.text())
        self.nugget("run", "model.k", "--quiet")
        for name in ("swforc", "welds.csv"):
            self.assertNotRegex(self.read(name), r"(?i)\bnan\b")

    def test_the_fragment_with_brick_welds_says_that_they_have_no_sheets(self):
        """99 parts without section and material: given both, every brick is a weld that nothing tracks."""
        lines = self.shared("decks/hex_weld_fragment/rkrwelds.key").read_text(encoding="ascii").splitlines()
        parts = 0
        for i, line in enumerate(lines):
            if not line.startswith("*PART"):
                continue
            part = int(lines[i + 4][:10])
            lines[i + 4] = f"{part:>10}{1:>10}{max(part, 2):>10}{0:>10}{1:>10}"
            parts += 1
        self.assertEqual(parts, 99)
        cards = "*SECTION_SOLID\n         1         1\n*HOURGLASS\n         1         6       1.0\n*CONTROL_TERMINATION\n       1.0\n"
        self.write("\n".join(lines).replace("*END", cards + "*END"), "fragment.k")
        self.nugget("check", "fragment.k", "-o", "audit")
        welds = list(csv.DictReader(io.StringIO(self.read("audit/welds.csv"))))
        self.assertEqual(len(welds), 1019)
        self.assertEqual({w["kind"] for w in welds}, {"solid"})
        self.assertEqual({w["tied"] for w in welds}, {"no"})
        self.assertEqual({w["reason1"] for w in welds}, {"no contact tracks it"})
        found = self.json("audit/findings.json")
        # One part is no weld: its bricks are a mesh.
        self.assertEqual(sum("more than the 16 that one weld may have" in f["text"] for f in found), 1)


if __name__ == "__main__":
    unittest.main()
