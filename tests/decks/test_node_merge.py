# SPDX-License-Identifier: Apache-2.0
"""*NODE_MERGE_SET: meshes that only touch become one. The answer is that of the same mesh written with shared nodes."""
import unittest

import lsda
from nugget_command import CommandTest

HEAD = """*KEYWORD
*CONTROL_TERMINATION
2e-4
*DATABASE_GLSTAT
2e-5,2
*DATABASE_NODOUT
2e-5,2
*SECTION_SHELL
1,2,0.8333,3
1.0,1.0,1.0,1.0
*SECTION_SOLID
2,1
*SECTION_BEAM
3,1,1.0,2,0
3.0,3.0,3.0,3.0
*MAT_ELASTIC
1,7.85e-9,210000,0.3
*PART

1,1,1
*PART

2,2,1
*PART

3,3,1
*DEFINE_CURVE
1
0,30.0
1,30.0
"""


def deck(shared, gap=0.0, tolerance=None, extra="", sets="*SET_NODE_GENERAL\n9\nALL\n*NODE_MERGE_SET\n9\n"):
    """A sheet of two halves, a brick below one, a beam across; `shared`: each place has one node, else each piece has its own."""
    nodes, by_place, cards = [], {}, [HEAD]

    def node(piece, p):
        key = p if shared else (piece, p)
        if key not in by_place:
            by_place[key] = len(nodes) + 1
            nodes.append(tuple(a + (gap if piece == "right" else 0.0) for a in p))
        return by_place[key]

    shells = []
    for piece, x in (("left", 0.0), ("right", 30.0)):
        for j in range(3):
            for i in range(3):
                shells.append([node(piece, (x + 10 * (i + a), 10.0 * (j + b), 0.0)) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))])
    brick = [node("brick", (40.0 + a, 10.0 + b, c)) for c in (-10.0, 0.0) for a, b in ((0, 0), (10, 0), (10, 10), (0, 10))]
    beam = [node("beam", (0.0, 0.0, 0.0)), node("beam", (60.0, 30.0, 0.0))]
    third = node("third", (0.0, 0.0, 50.0))
    cards.append("*ELEMENT_SHELL\n" + "\n".join(f"{k + 1},1," + ",".join(map(str, s)) for k, s in enumerate(shells)))
    cards.append(f"*ELEMENT_SOLID\n101,2,{','.join(map(str, brick))}\n*ELEMENT_BEAM\n102,3,{beam[0]},{beam[1]},{third}")
    # By ids of nodes that are merged: a support, a load, a mass, a history, a start; a set that names one place twice.
    right, left = node("right", (30.0, 0.0, 0.0)), node("left", (30.0, 0.0, 0.0))
    cards.append(f"*BOUNDARY_SPC_NODE\n{beam[0]},0,1,1,1\n*LOAD_NODE_POINT\n{brick[6]},3,1,10.0\n*ELEMENT_MASS\n201,{brick[5]},1e-6")
    cards.append(f"*DATABASE_HISTORY_NODE\n{left}\n*INITIAL_VELOCITY_NODE\n{beam[1]},0,0,3000.0")
    cards.append(f"*SET_NODE_LIST\n1\n{left},{right}\n*LOAD_NODE_SET\n1,3,1,5.0\n*SET_SEGMENT\n2\n{','.join(map(str, brick[4:]))}")
    cards.append("*LOAD_SEGMENT_SET\n2,1,0.1")
    if not shared:
        cards.append(sets + (f"*NODE_MERGE_TOLERANCE\n{tolerance}\n" if tolerance is not None else "") + extra)
    cards.append("*NODE\n" + "\n".join(f"{k + 1},{x},{y},{z}" for k, (x, y, z) in enumerate(nodes)) + "\n*END\n")
    return "\n".join(cards)


class NodeMerge(CommandTest):
    def energies(self, name, text):
        run = self.nugget("run", self.write(text, f"{name}.k").name, "-o", name, "-j1", "--quiet")
        found = lsda.read(self.folder / name / "binout0000")
        states = lsda.states(found, "glstat")
        return run.stderr, {"kinetic": [s["kinetic_energy"][0] for s in states], "internal": [s["internal_energy"][0] for s in states],
                            "work": [s["external_work"][0] for s in states],
                            "z": [s["z_displacement"][0] for s in lsda.states(found, "nodout")]}

    def compare(self, found, expected):
        for quantity, values in expected.items():
            size = max(map(abs, values))
            self.assertGreater(size, 0.0, quantity)
            for a, b in zip(values, found[quantity], strict=True):
                self.assertAlmostEqual(a / size, b / size, delta=1e-9, msg=quantity)

    def test_pieces_become_one(self):
        expected = self.energies("shared", deck(True))[1]
        words, found = self.energies("merged", deck(False))
        self.compare(found, expected)
        # 4 places of the two halves, 4 of the brick, 2 of the beam
        self.assertIn("*NODE_MERGE_SET nsid = 9: 10 of 43 nodes are merged with others within 0.0001144", words)  # 1e-5 150 / (2 sqrt(43))

    def test_tolerance(self):
        expected = self.energies("shared", deck(True))[1]
        moved = self.energies("near", deck(False, gap=1e-7, tolerance=1e-3))[1]
        for quantity, values in expected.items():  # the gap is 1e-8 of an element
            for a, b in zip(values, moved[quantity], strict=True):
                self.assertAlmostEqual(a, b, delta=1e-5 * max(map(abs, values)))
        words = self.energies("apart", deck(False, gap=0.01, tolerance=1e-3))[0]
        self.assertIn("1 of 43 nodes are merged", words)  # one end of the beam: all else touches the half that is moved away

    def test_only_nodes_of_the_set(self):
        words = self.energies("one", deck(False, sets="*SET_NODE_LIST_GENERATE\n9\n1,16\n*NODE_MERGE_SET\n9\n"))[0]
        self.assertIn("0 of 16 nodes are merged", words)
        self.assertIn("warning", words)

    def test_elements_that_would_lose_a_side(self):
        run = self.nugget("check", self.write(deck(False, tolerance=10.5)).name, expect=1)
        for what in ("shell 1", "solid 101"):
            self.assertIn(f"{what} would lose a side: two of its nodes are merged", run.stderr)

    def test_old_name_of_relaxation(self):
        text = deck(True).replace("*DEFINE_CURVE\n1\n", "*DEFINE_CURVE\n1,2\n").replace("*PART", "*CONTROL_DAMPING\n20,0.3,0.9\n*PART", 1)
        words, found = self.energies("old", text)
        self.assertRegex(words, r"warning: \*CONTROL_DAMPING: an old name: read as \*CONTROL_DYNAMIC_RELAXATION")
        self.assertEqual(found, self.energies("new", text.replace("CONTROL_DAMPING", "CONTROL_DYNAMIC_RELAXATION"))[1])
        self.assertNotEqual(found, self.energies("other", text.replace("20,0.3,0.9", "20,0.3,0.8"))[1])


if __name__ == "__main__":
    unittest.main()
