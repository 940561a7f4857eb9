# SPDX-License-Identifier: Apache-2.0
"""Runs of a few welds through three and four sheets, as beams and as bricks, and of what *CONTROL_CONTACT says of welds."""
import csv
import io
import re
import unittest

from lap_joint import deck as lap_joint
from nugget_command import CommandTest
from welded_sheets import Sheets, weld_material

PULL = 400.0  # N, on each pulled sheet


def stack(count, bricks=False, shared=False):
    """`count` sheets of 1.2 mm on each other, one weld through all of them in the middle of an element. The outer sheets are held at
    their left edges, the others pulled at their right ones: half of the pull goes through each of the two outer welds, nothing
    through the one between two pulled sheets. `shared`: the beams of the stack share their nodes."""
    gap = 1.2
    s = Sheets()
    s.cards += ["*CONTROL_TERMINATION\n1.0e-3", "*CONTROL_TIMESTEP\n0.0,0.9,0,0.0,-4.0e-7",
                "*CONTROL_CONTACT\n0.1\n0\n0.0\n0,0,0,0,1", "*DATABASE_SWFORC\n1.0e-5", "*DATABASE_SPCFORC\n1.0e-5", "*DATABASE_GLSTAT\n1.0e-5",
                weld_material(2), "*DEFINE_CURVE\n1\n0.0,0.0\n6.0e-4,1.0\n1.0,1.0"]
    sheets = [s.sheet(1.2, 0.0, 0.0, i * gap, 5, 5, 6.0) for i in range(count)]
    welds = s.brick_part(2) if bricks else s.beam_part(6.0, 2)
    nodes = None
    for i in range(count - 1):
        if bricks:
            s.brick(welds, 15.0, 15.0, i * gap, 5.3174, gap)
        elif not shared:
            s.beam(welds, (15.0, 15.0, i * gap), (15.0, 15.0, (i + 1) * gap))
        else:
            nodes = nodes or s.add_node(15.0, 15.0, 0.0)
            above = s.add_node(15.0, 15.0, (i + 1) * gap)
            s.element += 1
            s.beams.append(f"{s.element},{welds},{nodes},{above}")
            nodes = above
    s.tie([welds], sheets)
    s.node_set(1, s.column(sheets[0], 0) + s.column(sheets[-1], 0))
    s.cards.append("*BOUNDARY_SPC_SET\n1,0,1,1,1,1,1,1")
    pulled = [n for sheet in sheets[1:-1] for n in s.column(sheet, -1)]
    s.node_set(2, pulled)
    s.cards.append("*BOUNDARY_SPC_SET\n2,0,0,1,1,1,1,1")
    s.cards.append(f"*LOAD_NODE_SET\n2,1,1,{PULL * (count - 2) / len(pulled)}")
    # Sheets follow their load without swinging: they lose what they move in some tens of their own periods.
    s.cards.append("*DATABASE_BINARY_D3PLOT\n1.0e-3")
    return s.text()


class Stacks(CommandTest):
    def run_stack(self, text):
        """({weld id: shear over time}, reaction over time, rows of welds.csv)"""
        self.write(text)
        self.nugget("run", "model.k", "--quiet")
        shear, times = {}, []
        for line in self.read("swforc").splitlines():
            match = re.match(r"\s+\d+\s+(\S+)\s+(\S+)\s+(\S+)\s+\S+\s+(?:spotweld|constraint).*ID\s+(\d+)", line)
            if match:
                shear.setdefault(int(match[4]), []).append(float(match[2]))
                times.append(float(match[3]))
        welds = list(csv.DictReader(io.StringIO(self.read("welds.csv"))))
        summary = self.json("summary.json")
        self.assertAlmostEqual(summary["energy"]["ratio"], 1.0, delta=2e-3)
        return shear, welds

    def mean(self, values):
        """Over the second half of the plateau: what swings is a swing about the static answer."""
        last = values[-len(values) // 4:]
        return sum(last) / len(last)

    def test_three_sheets_share_the_pull_between_two_welds(self):
        for bricks in (False, True):
            with self.subTest(bricks=bricks):
                shear, welds = self.run_stack(stack(3, bricks))
                (a, b) = shear.values()
                self.assertEqual([w["stack_sheets"] for w in welds], ["3", "3"])
                self.assertEqual([(w["sheet1"], w["sheet2"]) for w in welds], [("1", "2"), ("2", "3")])
                for x, y in zip(a, b):
                    self.assertAlmostEqual(x, y, delta=1e-6 * PULL)
                self.assertAlmostEqual(self.mean(a) / (PULL / 2), 1.0, delta=0.02)

    def test_four_sheets_load_the_outer_welds_only(self):
        for bricks in (False, True):
            with self.subTest(bricks=bricks):
                shear, welds = self.run_stack(stack(4, bricks))
                (a, middle, c) = shear.values()
                self.assertEqual([w["stack_sheets"] for w in welds], ["4"] * 3)
                for x, m, y in zip(a, middle, c):
                    self.assertAlmostEqual(x, y, delta=1e-6 * PULL)
                    self.assertAlmostEqual(m, 0.0, delta=1e-6 * PULL)
                self.assertAlmostEqual(self.mean(a) / PULL, 1.0, delta=0.02)

    def test_beams_that_share_their_nodes_are_the_same_stack(self):
        apart, _ = self.run_stack(stack(3))
        shared, welds = self.run_stack(stack(3, shared=True))
        self.assertEqual([w["stack_sheets"] for w in welds], ["3", "3"])
        for x, y in zip(apart.values(), shared.values()):
            self.assertAlmostEqual(self.mean(x), self.mean(y), delta=0.01 * PULL)


class BeamsInLine(CommandTest):
    def test_a_beam_that_would_have_no_length_is_refused(self):
        """Two beams in line between two sheets: the node between them is tied by the first beam to the sheet of the second one's end. The run
        ended in its first cycle, which a check did not say. Sabotage: a warning."""
        s = Sheets()
        s.cards += ["*CONTROL_TERMINATION\n1.0e-5", weld_material(2)]
        sheets = [s.sheet(1.2, 0.0, 0.0, z, 5, 5, 6.0) for z in (0.0, 1.2)]
        welds = s.beam_part(6.0, 2)
        below, middle, above = (s.add_node(15.0, 15.0, z) for z in (0.0, 0.6, 1.2))
        s.beams += [f"901,{welds},{below},{middle}", f"902,{welds},{middle},{above}"]
        s.tie([welds], sheets)
        self.write(s.text())
        for command in ("check", "run"):
            run = self.nugget(command, "model.k", "-o", command, expect=1)
            self.assertIn("beam weld 902 has no length where its nodes have been moved to at the start, and so no time step", run.stderr)


class ControlContact(CommandTest):
    def penetrations(self, spothin, radii):
        """How many nodes the contact finds in the thickness of the two sheets, which are 0.6 mm apart at a thickness of 1.2."""
        text = lap_joint(("*CONTROL_CONTACT\n       0.1\n", f"*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,0,5\n0.0\n1.0\n*CONTROL_CONTACT\n       0.1\n"),
                         ("       0.0\n         0         0         0         0         1\n",
                          f"       0.0\n         0         0         0         0         1         0{spothin:10.2f}\n"
                          f"         0         0         0       0.0       0.0         0{radii:10.1f}\n"))
        text = text.replace("             1.2000", "             0.6000").replace("          1.2000", "          0.6000")
        self.write(text)
        self.nugget("check", "model.k", "-o", "audit")
        found = [f["text"] for f in self.json("audit/findings.json")]
        counts = [int(m[1]) for t in found if (m := re.match(r"(\d+) nodes stand in the thickness", t))]
        return counts[0] if counts else 0

    def test_spothin_thins_the_shells_at_a_weld_in_contact(self):
        """At 0.4 times 1.2 mm the shells within SWRADF radii of the weld, here all, are clear of each other."""
        self.assertGreater(self.penetrations(0.0, 5.0), 0)
        self.assertEqual(self.penetrations(0.4, 5.0), 0)
        self.assertGreater(self.penetrations(0.4, 0.0), 0, "only the one shell that the weld is tied to")
        self.assertGreater(self.penetrations(0.6, 5.0), 0, "0.72 mm")

    def test_spotstp_3_keeps_an_untied_weld_and_runs(self):
        text = lap_joint(("         0         0         0         0         1\n", "         0         0         0         0         3\n"),
                         ("     302          9.0000          9.0000          1.2000", "     302          9.0000          9.0000          9.2000"))
        self.write(text)
        run = self.nugget("run", "model.k", "--quiet")
        self.assertIn("spotstp = 3: beam weld 31 is not tied; it is kept, with free ends", run.stderr)
        (weld,) = self.json("summary.json")["weld"]
        self.assertEqual((weld["tied"], weld["failed"], weld["peak"]["shear"]), (False, False, 0.0))


if __name__ == "__main__":
    unittest.main()
