# SPDX-License-Identifier: Apache-2.0
"""Forces of a rigid wall on areas of its face (SSID of *RIGIDWALL_PLANAR_FORCES) and on sets of nodes (*RIGIDWALL_FORCE_TRANSDUCER): against walls
of their own for each block that falls, one of them rigid; the same turned and in other units; over threads, ranks and a restart."""
import re
import unittest

import lsda
from repeated_runs import RepeatedRuns
from runs_over_ranks import RunsOverRanks
from test_invariance import Cards, Case, oblique
from under_mpirun import MPIRUN

END = 6e-5
AREAS = ((-1, -1, 13, 13), (19, -1, 33, 13), (39, -1, 53, 13))  # under each of three blocks; of the last one a triangle, too


def blocks(c, walls_of_their_own=False):
    """Three blocks, one of them rigid, hit a wall with friction askew."""
    cards = Cards(c)
    add, node = cards.add, cards.node
    add("SECTION_SOLID", (1, 1))
    add("HOURGLASS", (1, 4, 0.05))
    add("MAT_PLASTIC_KINEMATIC", (1, c.of(7.85e-9, 1, -3), c.of(210000, 1, -1, -2), 0.3, c.of(300, 1, -1, -2), c.of(1500, 1, -1, -2), 1), ())
    add("MAT_RIGID", (2, c.of(7.85e-9, 1, -3), c.of(210000, 1, -1, -2), 0.3), (), ())
    add("CONTROL_CONTACT", (0.1, 1.0))
    elements = []
    for b in range(3):
        cards.append(f"*PART\nblock\n{b + 1},1,{2 if b == 2 else 1},0,1")
        at = {(i, j, k): node((20.0 * b + 4.0 * i, 4.0 * j, 0.25 + 0.125 * b + 4.0 * k + 0.125 * i)) for k in range(3) for j in range(4) for i in range(4)}
        ring = ((0, 0), (1, 0), (1, 1), (0, 1))
        elements += [(b + 1, *(at[i + u, j + v, k + w] for w in (0, 1) for u, v in ring)) for k in range(2) for j in range(3) for i in range(3)]
        rows = list(at.values())
        add("SET_NODE_LIST", (b + 1,), *(rows[i:i + 8] for i in range(0, len(rows), 8)))
        speed = c.vector((2000.0, 1000.0, -20000.0 - 2000.0 * b), c.velocity)
        add("INITIAL_VELOCITY_RIGID_BODY", (b + 1, speed)) if b == 2 else add("INITIAL_VELOCITY_NODE", *((n, speed) for n in rows))
    add("ELEMENT_SOLID", *((c.first + e, *row) for e, row in enumerate(elements)))
    plane = ((c.place((0, 0, 0)), c.place((0, 0, 10)), 0.3))
    if walls_of_their_own:
        for b in range(3):
            add("RIGIDWALL_PLANAR_ID", (11 + b, f"block {b + 1}"), (b + 1,), plane)
        return cards.text(END, "GLSTAT", "RWFORC")
    corners = [[node((x, y, 0.0)) for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))] for x0, y0, x1, y1 in AREAS]
    a, b, d, e = corners[2]
    add("SET_SEGMENT", (7,), corners[0], corners[1], (a, b, d, d), (a, d, e, e))
    add("SET_NODE_LIST", (8,), sum(corners, []))
    cards.append("*RIGIDWALL_PLANAR_FORCES_ID\n5,barrier\n0,8")
    cards.append(",".join(map(str, plane)) + "\n0,7")
    for b in (2, 1, 0):
        cards.append(f"*RIGIDWALL_FORCE_TRANSDUCER\n{31 + b},5\nnodes of block {b + 1}\n{b + 1}")
    text = cards.text(END, "GLSTAT", "RWFORC")
    return re.sub(r"(\*DATABASE_RWFORC\n[^,]*),2", r"\1,3", text)


class WallAreas(RepeatedRuns):
    def forces(self, name, text):
        self.nugget("run", self.write(text, f"{name}.k").name, "-o", name, "-j1", "--quiet")
        return lsda.read(self.folder / name / "binout0000")

    def test_as_walls_of_their_own(self):
        """Sabotage: forces of nodes of rigid bodies left out; a set of the nodes that come after."""
        apart, whole = self.forces("apart", blocks(Case(), True)), self.forces("whole", blocks(Case()))
        own, wall = lsda.states(apart, "rwforc/forces"), lsda.states(whole, "rwforc/forces")
        sets, areas = lsda.states(whole, "rwforc/transducer"), lsda.states(whole, "rwforc/wall001")
        self.assertEqual(list(whole["rwforc/transducer/metadata/ids"]), [33, 32, 31])
        self.assertEqual(list(whole["rwforc/transducer/metadata/nodeset"]), [3, 2, 1])
        self.assertEqual(list(whole["rwforc/transducer/metadata/rigidwall"]), [5, 5, 5])
        self.assertEqual(list(whole["rwforc/wall001/metadata/ids"]), [1, 2, 3, 4])
        self.assertGreater(len(own), 8)
        largest = max(abs(f) for state in own for f in state["z_force"])
        for one, all_, of_sets, of_areas in zip(own, wall, sets, areas, strict=True):
            for axis in "xyz":
                forces = one[f"{axis}_force"]
                parts = of_areas[f"{axis}_force"]
                for b in range(3):
                    self.assertAlmostEqual(of_sets[f"{axis}_force"][2 - b] / largest, forces[b] / largest, delta=1e-6)
                    self.assertAlmostEqual((parts[b] if b < 2 else parts[2] + parts[3]) / largest, forces[b] / largest, delta=1e-6)
                self.assertAlmostEqual(sum(parts) / largest, all_[f"{axis}_force"][0] / largest, delta=1e-6)
                self.assertAlmostEqual(of_areas[f"total_{axis}"][0] / largest, sum(parts) / largest, delta=1e-6)
        for b in range(3):  # each of them presses
            self.assertGreater(max(state["z_force"][b] for state in own), 0.05 * largest)
        self.assertTrue(all(max(state["z_force"][k] for state in areas) > 0.0 for k in range(4)))
        text = self.read("whole/rwforc")
        self.assertIn("r i g i d   w a l l   n o d e   s e t   f o r c e   s u m m a t i o n s", text)
        self.assertEqual(text.count("                seg#    \n"), len(own))
        self.assertIn("nodes of block 2", text)
        plotted = self.nugget("plot", "whole", "rwforc").stdout
        rows = {re.split(r" {2,}", line)[0]: line.split() for line in plotted.splitlines()}
        for name, values in (("area 2/z_force", [s["z_force"][1] for s in areas]), ("areas/total_z", [s["total_z"][0] for s in areas])):
            self.assertAlmostEqual(float(rows[f"rwforc/wall 5 {name} N"][-3]) / max(values), 1.0, delta=1e-5)

    def test_invariance(self):
        reference = self.forces("reference", blocks(Case()))
        for case in (Case(turn=oblique()), Case(mass=1e-3, length=1e3), Case(mass=1e-6, time=1e-3), Case(first=1234567)):
            found = self.forces("other", blocks(case))
            for branch in ("rwforc/transducer", "rwforc/wall001"):
                for ours, theirs in zip(lsda.states(found, branch), lsda.states(reference, branch), strict=True):
                    for i in range(3):
                        size = [sum(s[f"{axis}_force"][i] ** 2 for axis in "xyz") ** 0.5 for s in (ours, theirs)]
                        self.assertAlmostEqual(size[0] / case.force, size[1], delta=1.0)

    def test_same_bits_and_restart(self):
        text = blocks(Case())
        self.compare(self.write(text))
        self.resumed(text, shares=(0.5,))

    def test_refused(self):
        text = blocks(Case())
        for change, finding in (((",5\nnodes of block 2", ",6\nnodes of block 2"), "no wall has this number"), (("\n31,5", "\n32,5"), "another transducer"),
                                (("\n0,7\n", "\n0,77\n"), "77")):
            self.assertIn(change[0], text)
            run = self.nugget("check", self.write(text.replace(*change)), expect=1)
            self.assertIn(finding, run.stdout + run.stderr)


@unittest.skipUnless(MPIRUN, "mpirun is not installed")
class WallAreasOverRanks(RunsOverRanks):
    def test_ranks(self):
        self.compare_ranks(blocks(Case()))


if __name__ == "__main__":
    unittest.main()
