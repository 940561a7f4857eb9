# SPDX-License-Identifier: Apache-2.0
"""swforc of every kind of weld that a lap joint can have, and what welds.csv says of each."""
import csv
import io
import unittest

from lap_joint import CARDS, deck, edited, mesh
from nugget_command import CommandTest

# Nodes above each other: 106 at (6, 6, 0) of the lower sheet, 206 at (6, 6, 1.2) of the upper one.
NO_BEAM = ("*ELEMENT_BEAM\n" + f"{31:8d}{3:8d}{301:8d}{302:8d}{0:8d}\n", "")


def joined_by(cards):
    """The lap joint with its beam left out and other cards in its place."""
    text = edited(CARDS + mesh() + "*END\n", NO_BEAM, ("*DEFINE_CURVE\n", cards + "*DEFINE_CURVE\n"))
    begin = text.index("*PART\nweld")
    text = text[:begin] + text[text.index("*SECTION_SHELL"):]
    begin = text.index("*SECTION_BEAM")
    text = text[:begin] + text[text.index("*SET_PART_LIST"):]
    return "\n".join(line for line in text.splitlines() if line[:8].strip() not in ("301", "302")) + "\n"


class Swforc(CommandTest):
    def rows(self):
        """[(label, id, axial, shear, time, failure, rest)] of swforc."""
        found = []
        for line in self.read("swforc").splitlines():
            front, label, back = line.partition(" ID ")
            cells = front.split()
            if label and cells[0].isdigit():
                axial, shear, time = map(float, cells[1:4])
                found.append((" ".join(cells[5:]), int(back.split()[0]), axial, shear, time, cells[4], back.split()[1:]))
        return found

    def run_with(self, cards):
        self.write(joined_by(cards))
        self.nugget("run", "model.k", "--quiet")
        (weld,) = csv.DictReader(io.StringIO(self.read("welds.csv")))
        return self.rows(), weld

    def test_a_nodal_rigid_body_between_two_sheets_is_a_weld(self):
        """It moves as a *CONSTRAINED_SPOTWELD that cannot fail, and has the same rows but for its number."""
        spot, weld = self.run_with("*CONSTRAINED_SPOTWELD_ID\n       900\n       106       206\n")
        body, other = self.run_with("*CONSTRAINED_NODAL_RIGID_BODY\n       700         0        90\n*SET_NODE_LIST\n        90\n       106       206\n")
        self.assertEqual({r[:2] for r in spot}, {("constraint/weld", 900)})
        self.assertEqual({r[:2] for r in body}, {("constraint/weld", 700)})
        self.assertEqual([r[2:] for r in spot], [r[2:] for r in body])
        self.assertGreater(max(abs(r[2]) + r[3] for r in spot), 10.0)
        self.assertEqual((other["id"], other["kind"], other["sheet1"], other["sheet2"], other["failed"]), ("700", "rigid", "1", "2", "no"))
        for column in ("peak_axial", "peak_shear", "peak_bending", "length"):
            self.assertEqual(weld[column], other[column], column)

    def test_a_nodal_rigid_body_of_one_sheet_is_none(self):
        self.write(deck(("*DEFINE_CURVE\n", "*CONSTRAINED_NODAL_RIGID_BODY\n       700         0        90\n*SET_NODE_LIST\n        90\n       106       107\n"
                         "*DEFINE_CURVE\n")))
        self.nugget("check", "model.k", "-o", "audit")
        self.assertEqual(len(self.read("audit/welds.csv").splitlines()), 2)

    def test_a_rivet_has_an_axial_force_and_nothing_else(self):
        rows, weld = self.run_with("*CONSTRAINED_RIVET_ID\n       901\n       106       206   1.5e-05\n")
        self.assertEqual({r[:2] for r in rows}, {("constraint/weld", 901)})
        self.assertEqual({r[3] for r in rows}, {0.0})
        self.assertGreater(max(abs(r[2]) for r in rows), 0.0)
        for row in rows:
            self.assertEqual(row[5], "failure" if row[4] > 1.501e-5 else "0.00+00", row)
            if row[4] < 1.5e-5:
                self.assertAlmostEqual(float(row[6][0]), 1.2, delta=1e-9)
            elif row[4] > 1.501e-5:
                self.assertEqual(row[2], 0.0)
        self.assertEqual((weld["kind"], weld["failed"], weld["failure_mode"]), ("rigid", "yes", "failure time"))
        self.assertAlmostEqual(float(weld["failure_time"]) / 1.5e-5, 1.0, delta=0.02)
        self.assertIn("rivet failed  id=     901", self.read("run.log"))

    def test_a_leaning_rivet_is_a_finding(self):
        """106 to 207 leans by 6 mm over 1.2 mm."""
        self.write(joined_by("*CONSTRAINED_RIVET\n       106       207\n"))
        self.nugget("check", "model.k", "-o", "audit")
        (told,) = [f for f in self.json("audit/findings.json") if "degrees off the normal" in f["text"]]
        self.assertTrue(told["text"].startswith("rivet 1: its axis is 78.7 degrees off the normal"), told)
        self.assertEqual(told["keyword"], "*CONSTRAINED_RIVET")

    def test_a_rivet_limits_no_time_step(self):
        steps = []
        for cards in ("*CONSTRAINED_RIVET\n       106       206\n", ""):
            self.write(joined_by(cards))
            self.nugget("run", "model.k", "--quiet")
            steps.append(self.json("summary.json")["time_step"]["first"])
        self.assertEqual(*steps)

    def test_damage_of_welds_that_fade(self):
        """RS far beyond what the joint reaches: some damage. A weld without RS has none to tell."""
        card = ("*MAT_SPOTWELD\n         3  7.85e-09  210000.0       0.3     500.0    1000.0\n"
                "       0.0    8000.0    6000.0    6000.0    9000.0    7000.0    7000.0\n")
        soft = ("*MAT_SPOTWELD_DAMAGE-FAILURE\n         3  7.85e-09  210000.0       0.3      10.0    1000.0\n"
                "    1.0e-5\n       0.1       0.0\n")
        self.write(deck((card, soft)))
        self.nugget("run", "model.k", "--quiet")
        (weld,) = csv.DictReader(io.StringIO(self.read("welds.csv")))
        self.assertTrue(0.0 < float(weld["damage"]) < 1.0, weld["damage"])
        self.write(deck())
        self.nugget("run", "model.k", "--quiet")
        (weld,) = csv.DictReader(io.StringIO(self.read("welds.csv")))
        self.assertEqual(weld["damage"], "")


if __name__ == "__main__":
    unittest.main()
