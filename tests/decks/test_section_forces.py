# SPDX-License-Identifier: Apache-2.0
"""secforc between two sheets: the section is cut with welds where these are held, so that what passes it balances."""
import math
import unittest

import lsda
from nugget_command import CommandTest
from repeated_runs import RepeatedRuns
from welded_sheets import Sheets

LIGHT = 7.85e-11  # of welds: their own mass takes 0.3 % of what passes
END = 3.0e-5
SPR3 = ("*CONSTRAINED_INTERPOLATION_SPOTWELD\n{lower},{upper},77,2.4,3.0,1.0e5,0.0\n1.0,1.0,2.0,71,0,0,7.85e-10\n0,2.0e5,2.0e5\n"
        "*DEFINE_CURVE\n71\n0.0,1.0e5\n1.0,1.0e5")
SPR2 = ("*CONSTRAINED_SPR2\n{lower},{upper},77,2.4,6.0,1.0e5,1.0e5,1.0\n1.0,0.5,0.5,0.8,0.8,0.8,7.85e-10")
WELDS = ("beam", "brick", "four bricks", "kept gap", "SPR3", "SPR2")


def welded(weld, heights=(1.0,), low=0.2, high=0.9, cards=()):
    """A sheet moves away from the one that a weld at (14, 16) holds it to; the weld is drawn from `low` to `high`, the sheets lie at 0 and 1.2."""
    s = Sheets()
    s.cards += [f"*CONTROL_TERMINATION\n{END}", "*DATABASE_SWFORC\n1.0e-7,2", "*DATABASE_SECFORC\n1.0e-7,2", "*DATABASE_MATSUM\n1.0e-7,2",
                f"*MAT_SPOTWELD\n2,{LIGHT},210000.0,0.3,5.0e4,1000.0\n1.0e6", *cards]
    for height in heights:
        s.cards.append(f"*DATABASE_CROSS_SECTION_PLANE\n0,0.0,0.0,{height},0.0,0.0,{height + 8.0}\n")
    sheets = [s.sheet(1.2, 0.0, 0.0, z, 5, 5, 6.0) for z in (0.0, 1.2)]
    if weld in ("SPR2", "SPR3"):
        s.cards.append({"SPR2": SPR2, "SPR3": SPR3}[weld].format(lower=sheets[0], upper=sheets[1]))
        s.node_set(77, [s.add_node(14.0, 16.0, 0.5 * (low + high))])
    else:
        if weld == "brick":
            welds = s.brick_part(2)
            s.brick(welds, 14.0, 16.0, low, 5.0, high - low)
        else:
            welds = s.beam_part(6.0, 2)
            s.beam(welds, (14.0, 16.0, low), (14.0, 16.0, high))
        if weld == "four bricks":
            s.cards.append("*CONTROL_SPOTWELD_BEAM\n,,,,,4")
        s.tie([welds], sheets, form="_CONSTRAINED_OFFSET" if weld == "kept gap" else "")
    s.node_set(1, [n for j in range(6) for n in s.row(sheets[1], j)])
    s.cards.append("*INITIAL_VELOCITY\n1\n300.0,200.0,900.0")
    return s.text(), sheets


class SectionForces(CommandTest):
    def forces(self, folder, row=0):
        """[(x, y, z)] by state."""
        states = lsda.states(lsda.read(self.folder / folder / "binout0000"), "secforc")
        return [tuple(s[f"{axis}_force"][row] for axis in "xyz") for s in states]

    def run_welded(self, weld, name, **options):
        text, sheets = welded(weld, **options)
        self.write(text, f"{name}.k")
        run = self.nugget("run", f"{name}.k", "-o", name, "--quiet", "-j1")
        self.assertNotIn("cross section", run.stderr)
        return sheets

    def test_what_passes_is_what_moves_the_sheet(self):
        """A plane that crosses the weld only once this is held: the force is that of swforc, and its impulse what the upper sheet loses. Sabotage:
        planes go by welds as drawn; by places after the projection alone, where a gap that is kept is no weld's; the parts of rivets, which no PSID
        names, are not cut."""
        for weld in WELDS:
            with self.subTest(weld=weld):
                heights = (0.1,) if weld == "kept gap" else (1.0,)
                sheets = self.run_welded(weld, weld.replace(" ", "_"), heights=heights)
                folder = weld.replace(" ", "_")
                found = lsda.read(self.folder / folder / "binout0000")
                forces = self.forces(folder)
                welds = [math.hypot(s["axial"][0], s["shear"][0]) for s in lsda.states(found, "swforc")]
                largest = max(welds)
                self.assertGreater(largest, 200.0)
                for force, of_weld in zip(forces, welds, strict=True):
                    self.assertAlmostEqual(math.hypot(*force), of_weld, delta=1e-6 * largest)
                times = [s["time"][0] for s in lsda.states(found, "secforc")]
                sums = lsda.states(found, "matsum")
                place = list(found["matsum/metadata/ids"]).index(sheets[1])
                for axis in range(3):
                    impulse = sum(0.5 * (a[axis] + b[axis]) * (t - s) for a, b, s, t in zip(forces, forces[1:], times, times[1:]))
                    lost = sums[0][f"{'xyz'[axis]}_momentum"][place] - sums[-1][f"{'xyz'[axis]}_momentum"][place]
                    self.assertAlmostEqual(impulse / lost, 1.0, delta=0.01)

    def test_where_the_weld_was_drawn_does_not_matter(self):
        """Drawn short, or drawn where it is held: the same forces at the same height, and none below the sheets. Sabotage: the same."""
        drawn = []
        for name, low, high in (("short", 0.2, 0.9), ("whole", 0.0, 1.2)):
            text, _ = welded("beam", heights=(1.0, 0.1, -0.5), low=low, high=high)
            self.write(text, f"{name}.k")
            run = self.nugget("run", f"{name}.k", "-o", name, "--quiet", "-j1")
            self.assertIn("cross section 3 has no elements", run.stderr)
            drawn.append([self.forces(name, row) for row in range(3)])
        self.assertEqual(drawn[0], drawn[1])
        self.assertEqual(drawn[0][0], drawn[0][1])
        self.assertEqual({f for f in drawn[0][2]}, {(0.0, 0.0, 0.0)})

    def test_a_plane_in_the_sheet_does_not_go_by_round_off(self):
        """Its head side begins in the plane: that through the lower sheet cuts nothing, the upper one's the weld. Turned by 30 degrees, the end of
        the weld is projected to a place that is off the plane by round-off. Sabotage: the sign of a height of 1e-16."""
        c, q = math.cos(math.radians(30.0)), math.sin(math.radians(30.0))
        for angle in (0, 30):
            with self.subTest(angle=angle):
                text, _ = welded("beam", heights=())
                lines, turned = text.splitlines(), []
                nodes = False
                for line in lines:
                    if line.startswith("*"):
                        nodes = line == "*NODE"
                    elif nodes and angle:
                        number, x, y, z = line.split(",")
                        line = f"{number},{x},{c * float(y) - q * float(z):.15g},{q * float(y) + c * float(z):.15g}"
                    turned.append(line)
                normal = (0.0, -q, c) if angle else (0.0, 0.0, 1.0)
                planes = ""
                for height in (0.0, 1.2):
                    at = [height * n for n in normal]
                    head = [(height + 5.0) * n for n in normal]
                    planes += "*DATABASE_CROSS_SECTION_PLANE\n0," + ",".join(f"{v:.15g}" for v in at + head) + "\n\n"
                self.write("\n".join(turned).replace("*END", planes + "*END") + "\n", f"a{angle}.k")
                text = self.nugget("check", f"a{angle}.k").stderr
                self.assertIn("cross section 1 has no elements", text)
                self.assertNotIn("cross section 2 has no elements", text)


class RepeatedSections(RepeatedRuns):
    def test_resumed(self):
        self.resumed(welded("four bricks")[0], shares=(0.5,))


if __name__ == "__main__":
    unittest.main()
