# SPDX-License-Identifier: Apache-2.0
"""Welds of bricks by the command: weld beams replaced by clusters, and a public fragment of a car with brick welds."""
import csv
import io
import math
import re
import unittest

from lap_joint import deck, edited
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

    def test_connection_by_functions_of_both_sheets(self):
        """PROPRUL 2: functions whose values by hand are the numbers of PROPRUL 1: the same run. The sheets are 1.2 and 1.0 thick; they yield at 300
        and 450, hardening with H and 0, so that they neck at H exp(-(1 - 300/H) - H/E) and 450 exp(-450/E). Sabotage: the first sheet's
        number for the second; the thickness of the section for that of the shells; strengths without their rate."""
        hardening = 210000.0 * 1000.0 / (210000.0 - 1000.0)
        soft, hard = hardening * math.exp(-(1.0 - 300.0 / hardening) - hardening / 210000.0), 450.0 * math.exp(-450.0 / 210000.0)
        names = "(t1,t2,sy1,sy2,sm1,sm2,r,a,e1,e2)"
        functions = "\n".join(f"*DEFINE_FUNCTION\n{number}\nf{names}={value}" for number, value in (
            (51, "0.5*(sy1+sy2)"), (52, "0.02*(e1+e2)/2.0"), (53, "0.06*(sm1+sm2)*t1*t2"), (54, "0.04*max(sm1,sm2)*(1.0+1e-4*r)*a/25.0"),
            (55, "1.0+min(t1,t2)")))
        yields = 0.5 * (300.0 + 0.002 * hardening + 450.0)
        def deck_of(table):
            s = Sheets()
            s.cards += ["*CONTROL_TERMINATION\n2.0e-5", "*DATABASE_SWFORC\n1.0e-6", "*MAT_PLASTIC_KINEMATIC\n2,7.85e-9,210000.0,0.3,300.0,1000.0,1.0",
                        "*MAT_PIECEWISE_LINEAR_PLASTICITY\n3,7.85e-9,210000.0,0.3,450.0,0.0\n\n\n",
                        "*MAT_SPOTWELD_DAIMLERCHRYSLER\n4,7.85e-9,210000.0,0.3\n\n,,,,7", "*DEFINE_CURVE\n60\n0.0,1.0\n1.0e6,101.0", table]
            sheets = [s.sheet(thickness, 0, 0, z, 3, 3, 6.0) for thickness, z in ((1.2, 0.0), (1.0, 1.1))]
            for part, material in zip(sheets, (2, 3)):
                s.cards = [card.replace(f"*PART\nsheet\n{part},{part},1,", f"*PART\nsheet\n{part},{part},{material},") for card in s.cards]
            bricks = s.brick_part(4)
            s.brick(bricks, 9.0, 9.0, 0.0, 5.0, 1.1)
            s.tie([bricks], sheets)
            s.node_set(1, s.column(sheets[0], 0))
            s.node_set(2, s.column(sheets[1], -1))
            s.cards += ["*BOUNDARY_SPC_SET\n1,0,1,1,1,1,1,1", "*DEFINE_CURVE\n61\n0.0,0.0\n1.0e-5,5000.0\n1.0,5000.0",
                        "*BOUNDARY_PRESCRIBED_MOTION_SET\n2,1,0,61\n2,3,0,61"]
            return s.text()
        tables = {"numbers": f"7,1,0,,0,1\n,{yields:.4f},4200.0,,,{0.06 * (soft + hard) * 1.2:.5f},0.0,{0.04 * soft:.6f}\n2.0,1.0,2.0,0,0,60",
                  "functions": "7,2,0,,0,1\n,51,52,,,53,,54\n55,,55\n" + functions}
        rows = []
        for name, table in tables.items():
            self.write(deck_of("*DEFINE_CONNECTION_PROPERTIES\n" + table), f"{name}.k")
            self.nugget("run", f"{name}.k", "-o", name, "--quiet")
            rows.append(next(csv.DictReader(io.StringIO(self.read(f"{name}/welds.csv")))))
        self.assertEqual(rows[0]["failed"], "yes", rows[0])
        for column in ("peak_shear", "peak_axial", "failure_time", "energy", "peak_failure"):
            self.assertAlmostEqual(float(rows[1][column]) / float(rows[0][column]), 1.0, delta=3e-3, msg=column)
        self.write(self.read("functions.k").replace("0.06*(sm1+sm2)*t1*t2", "60.0*t1"), "turned.k")
        self.assertRegex(self.nugget("check", "turned.k").stderr, r"SN by function 53: (72|60) with the sheet of its first end as sheet 1, (72|60) with the other")

    def test_what_names_the_beam_holds_for_its_bricks(self):
        """Its death, and a cross section through it: secforc and swforc are the same force. Sabotage: the index of the beam that is gone."""
        cards = ("*DEFINE_ELEMENT_DEATH_BEAM\n        31   1.1e-05\n*SET_BEAM\n         7\n        31\n*SET_NODE_LIST\n         8\n       302\n"
                 "*DATABASE_CROSS_SECTION_SET_ID\n         5\n         8         0         7\n*DATABASE_SECFORC\n  1.00e-06\n")
        for bricks in (0, 1, 4):
            with self.subTest(bricks=bricks):
                self.write(deck().replace("*END", f"{cards}*CONTROL_SPOTWELD_BEAM\n{bricks:>60}\n*END"), "lap.k")
                self.nugget("run", "lap.k", "-o", f"out{bricks}", "--quiet")
                (weld,) = self.json(f"out{bricks}/summary.json")["weld"]
                self.assertTrue(weld["failed"])
                self.assertAlmostEqual(weld["failure_time"] / 1.1e-5, 1.0, delta=0.02)
                text = self.read(f"out{bricks}/secforc")
                sections = [float(f) for f in re.findall(r"^ +5 .*?(\S+)$", text, re.M)]
                welds = [None if "failure" in line else math.hypot(float(line.split()[1]), float(line.split()[2]))
                         for line in self.read(f"out{bricks}/swforc").splitlines() if re.match(r" +1 .* ID ", line)]
                self.assertEqual(len(sections), len(welds))
                holding = [(a, b) for a, b in zip(sections, welds) if b is not None]
                self.assertGreater(holding[-1][1], 10.0)
                for a, b in holding:
                    self.assertAlmostEqual(a, b, delta=1e-3 * holding[-1][1])
                self.assertEqual((sections[-1], welds[-1]), (0.0, None))

    def test_the_ends_of_a_leaning_beam_stay_on_their_sheets(self):
        """Its bricks lie across it: at 27 degrees nodes lie off the sheet of their end, and some nearer to the other one. Sabotage: each node by
        itself goes to the closest sheet, as far as a brick reaches."""
        self.write(edited(deck(), (f"{301:8d}{9.0:16.4f}", f"{301:8d}{8.7:16.4f}"), (f"{302:8d}{9.0:16.4f}", f"{302:8d}{9.3:16.4f}"))
                   .replace("*END", f"*CONTROL_SPOTWELD_BEAM\n{4:>60}\n*END"), "lap.k")
        self.nugget("check", "lap.k", "-o", "audit")
        (weld,) = csv.DictReader(io.StringIO(self.read("audit/welds.csv")))
        self.assertEqual((weld["tied"], weld["sheet1"], weld["sheet2"]), ("yes", "1", "2"))
        for i in range(1, 19):
            self.assertIn(f"of part {1 if int(weld[f'node{i}']) < 312 else 2}", weld[f"reason{i}"])

    def held(self, elform, young, rupture, cards, drawn=(0.0, 1.2)):
        """swforc at the end of a weld brick of 5 x 5 between two sheets all of whose nodes are held: [axial, shear]."""
        s = Sheets()
        s.cards += ["*CONTROL_TERMINATION\n5.0e-6", "*DATABASE_SWFORC\n5.0e-7",
                    f"*MAT_SPOTWELD_DAMAGE-FAILURE\n2,7.85e-9,{young},0.3,900.0,1000.0\n0.2\n{rupture}"]
        sheets = [s.sheet(1.0, 0, 0, z, 3, 3, 5.0) for z in (0.0, 1.2)]
        bricks = s.brick_part(2)
        s.cards[-1] = f"*SECTION_SOLID\n{bricks},{elform}"
        s.brick(bricks, 7.5, 7.5, drawn[0], 5.0, drawn[1] - drawn[0])
        s.tie([bricks], sheets)
        s.node_set(9, [n for sheet in sheets for j in range(4) for n in s.row(sheet, j)])
        s.cards += ["*BOUNDARY_SPC_SET\n9,0,1,1,1,1,1,1", cards.replace("BRICK", str(s.element))]
        self.write(s.text())
        run = self.nugget("run", "model.k", "--quiet", expect=1 if "SECTION_PLANE" in cards and young < 0 else 0)
        if run.returncode:
            return run.stderr
        line = [line for line in self.read("swforc").splitlines() if " ID " in line][-1]
        return [float(field) for field in line.split()[1:3]]

    def test_initial_stresses_hold_whatever_the_stress_state_and_the_damage(self):
        """N = A sigma_zz, F = A |(tau_zx, tau_yz)|: nothing moves. Sabotage: stresses in the element alone, of which welds that are damaged or
        have the stresses of their section only know nothing."""
        for elform, points in ((1, 1), (2, 8)):
            stress = f"*INITIAL_STRESS_SOLID\nBRICK,{points}\n" + "10.0,20.0,100.0,5.0,30.0,40.0,0.0\n" * points
            for young in (210000.0, -210000.0):
                for rupture in (0.0, 0.3):
                    with self.subTest(elform=elform, young=young, rupture=rupture):
                        axial, shear = self.held(elform, young, rupture, stress)
                        self.assertAlmostEqual(axial, 2500.0, delta=0.1)
                        self.assertAlmostEqual(shear, 1250.0, delta=0.1)

    def test_a_preload_of_a_cross_section_holds_with_damage(self):
        preload = ("*DEFINE_CURVE\n1\n0.0,100.0\n1.0,100.0\n*DATABASE_CROSS_SECTION_PLANE_ID\n4\n,0.0,0.0,0.6,0.0,0.0,1.0\n\n"
                   "*INITIAL_STRESS_SECTION\n1,4,1")
        for elform in (1, 2):
            with self.subTest(elform=elform):
                axial, shear = self.held(elform, 210000.0, 0.3, preload)
                self.assertAlmostEqual(axial, 2500.0, delta=0.1)
                self.assertAlmostEqual(shear, 0.0, delta=0.1)
        # The plane passes a brick that is drawn short once this stands on its sheets. Sabotage: bricks as drawn.
        axial, _ = self.held(1, 210000.0, 0.3, preload.replace("0.6,0.0,0.0,1.0", "1.0,0.0,0.0,2.0"), drawn=(0.3, 0.8))
        self.assertAlmostEqual(axial, 2500.0, delta=0.1)
        self.assertIn("takes no imposed stress: it is a weld with the stresses of its cross-section only", self.held(1, -210000.0, 0.0, preload))

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
