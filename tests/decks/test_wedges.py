# SPDX-License-Identifier: Apache-2.0
"""Wedges (ELFORM 15): no corner of their triangles differs from the others, however a deck writes them. A block of them, thrown apart and shaken,
and its modes; what each node weighs."""
import random
import unittest

import lsda
from nugget_command import CommandTest

CELLS, SIZE = (2, 2, 1), (5.0, 4.0, 3.0)
STEEL = "7.85e-9,210000.0,0.3"
LAW = f"*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,{STEEL},250.0,1000.0\n\n\n\n"


def block():
    """Nodes, and wedges by their two triangles."""
    draw = random.Random(9)
    number = {}
    nodes = []
    for k in range(CELLS[2] + 1):
        for j in range(CELLS[1] + 1):
            for i in range(CELLS[0] + 1):
                number[i, j, k] = len(nodes) + 1
                nodes.append(tuple(s * n + draw.uniform(-0.5, 0.5) for s, n in zip(SIZE, (i, j, k))))
    wedges = []
    for j in range(CELLS[1]):
        for i in range(CELLS[0]):
            low, up = ([number[i + a, j + b, k] for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))] for k in (0, 1))
            wedges += [([low[n] for n in corner], [up[n] for n in corner]) for corner in ((0, 1, 2), (0, 2, 3))]
    return nodes, wedges


def written(low, up, way):
    """A wedge in one of twelve ways: which corner is the edge, which triangle comes first, as two orders of the card."""
    turn, swapped, other = way % 3, way // 3 % 2, way // 6
    a, b = low[turn:] + low[:turn], up[turn:] + up[:turn]
    if swapped:
        a, b = b[::-1], a[::-1]
    return [a[0], a[1], a[2], a[2], b[0], b[1], b[2], b[2]] if other else [b[0], b[1], a[1], a[0], b[2], b[2], a[2], a[2]]


def deck(ways, cards, section="*SECTION_SOLID\n1,15\n", law=LAW):
    nodes, wedges = block()
    draw = random.Random(3)
    text = f"*KEYWORD\n{cards}*PART\nwedges\n1,1,1\n{section}{law}*NODE\n"
    text += "".join(f"{n},{x:.12g},{y:.12g},{z:.12g}\n" for n, (x, y, z) in enumerate(nodes, 1))
    text += "*INITIAL_VELOCITY_NODE\n"
    text += "".join(f"{n},{','.join(f'{4e4 * draw.uniform(-1, 1) + 4e3 * p:.12g}' for p in x)}\n" for n, x in enumerate(nodes, 1))
    text += "*ELEMENT_SOLID\n" + "".join(f"{e},1,{','.join(map(str, written(*w, ways(e))))}\n" for e, w in enumerate(wedges, 1))
    return text + "*END\n"


RUN = "*CONTROL_TERMINATION\n4e-5\n*DATABASE_GLSTAT\n4e-6\n*CONTROL_TIMESTEP\n,0.6\n"


class Wedges(CommandTest):
    def energies(self, ways, **options):
        self.write(deck(ways, RUN, **options))
        self.nugget("run", "model.k", "-o", "run", "--quiet")
        return [(s["kinetic energy"], s["internal energy"]) for s in self.glstat("run/glstat")]

    def test_numbering(self):
        """Sabotage: wedges as collapsed bricks (0.3 % of the energy)."""
        for options in ({}, {"section": "*SECTION_SOLID\n1,1\n*CONTROL_SOLID\n1\n"}):
            first = self.energies(lambda e: 0, **options)
            self.assertGreater(first[-1][1], 0.1 * first[0][0])
            for ways in (lambda e: 5 * e % 12, lambda e: 7 * e % 12 + 1):
                for a, b in zip(first, self.energies(lambda e, w=ways: w(e) % 12, **options)):
                    for p, q in zip(a, b):
                        self.assertAlmostEqual(p, q, delta=1e-5 * first[0][0])  # glstat has six digits

    def test_modes(self):
        found = []
        for ways in (lambda e: 0, lambda e: 5 * e % 12):
            self.write(deck(ways, "", law=f"*MAT_ELASTIC\n1,{STEEL}\n"))
            self.nugget("modes", "model.k", "-n", "12", "-o", "modes", "--quiet")
            found.append([m["frequency_hz"] for m in self.json("modes/summary.json")["modes"]][6:])
        for a, b in zip(*found):
            self.assertAlmostEqual(b / a, 1.0, delta=1e-7)

    def test_each_node_has_a_sixth(self):
        """What holds the nodes of a prism of 30 mm3 under gravity. Sabotage: an eighth for each of the eight of its card."""
        places = [(x, y, z) for z in (0, 3) for x, y in ((0, 0), (5, 0), (1, 4))]
        for way in range(12):
            text = "*KEYWORD\n*CONTROL_TERMINATION\n1e-6\n*DATABASE_SPCFORC\n1e-7,2\n*LOAD_BODY_Z\n9,1000.0\n*DEFINE_CURVE\n9\n0,1\n1,1\n"
            text += f"*PART\nwedge\n1,1,1\n*SECTION_SOLID\n1,15\n{LAW}*NODE\n"
            text += "".join(f"{n},{','.join(map(str, x))}\n*BOUNDARY_SPC_NODE\n{n},0,1,1,1\n*NODE\n" for n, x in enumerate(places, 1))
            text += f"*ELEMENT_SOLID\n1,1,{','.join(map(str, written([1, 2, 3], [4, 5, 6], way)))}\n*END\n"
            self.write(text)
            self.nugget("run", "model.k", "-o", "run", "--quiet")
            held = lsda.states(lsda.read(self.folder / "run/binout0000"), "spcforc")[-1]["z_force"]
            self.assertEqual(len(held), 6)
            for force in held:
                self.assertAlmostEqual(abs(force) / (7.85e-9 * 30.0 * 1000.0 / 6.0), 1.0, delta=1e-6)


if __name__ == "__main__":
    unittest.main()
