# SPDX-License-Identifier: Apache-2.0
"""What must not matter: where a model lies, how it is turned, which hand it has, its units and its numbers. Two sheets of rate-dependent
steel, joined by weld beams and a brick, of which one end is thrown up, are hit by a third and run into a wall; the same deck written
otherwise must give the same energies and weld forces."""
import unittest

import lsda
from nugget_command import CommandTest

SIZE, ALONG, ACROSS = 5.0, 12, 6
END, STATES = 3e-4, 30


def product(turn, p):
    return tuple(sum(turn[i][j] * p[j] for j in range(3)) for i in range(3))


class Case:
    """How a deck is written: a turn, a shift [mm], units as multiples of t, mm and s, and the first number of nodes and elements."""

    def __init__(self, turn=((1, 0, 0), (0, 1, 0), (0, 0, 1)), shift=(0, 0, 0), mass=1.0, length=1.0, time=1.0, first=1, mirrored=False):
        self.turn, self.shift, self.first, self.mirrored = turn, shift, first, mirrored
        self.mass, self.length, self.time = 1.0 / mass, 1.0 / length, 1.0 / time
        self.force = self.mass * self.length / self.time**2
        self.energy = self.force * self.length
        self.stress = self.force / self.length**2
        self.velocity = self.length / self.time

    def place(self, p):
        return ",".join(f"{self.length * (a + b):.16g}" for a, b in zip(product(self.turn, p), self.shift))

    def vector(self, v, scale):
        return ",".join(f"{scale * a:.16g}" for a in product(self.turn, v))


def deck(c):
    nodes, shells, sets = [], [], {}

    def node(p):
        nodes.append(f"{c.first + len(nodes)},{c.place(p)}")
        return c.first + len(nodes) - 1

    def sheet(part, x, z, along, chosen):
        grid = [[node((x + SIZE * i, SIZE * j + (1.75 if part == 3 else 0.0), z)) for i in range(along + 1)] for j in range(ACROSS + 1)]
        for j in range(ACROSS):
            for i in range(along):
                corners = [grid[j][i], grid[j][i + 1], grid[j + 1][i + 1], grid[j + 1][i]]
                if c.mirrored:
                    corners = [corners[k] for k in (0, 3, 2, 1)]
                shells.append(f"{c.first + len(shells)},{part}," + ",".join(map(str, corners)))
        sets[part] = [n for row in grid for i, n in enumerate(row) if chosen(i)]

    sheet(1, 0.0, 0.0, ALONG, lambda i: False)
    sheet(2, 20.0, 2.0, ALONG, lambda i: i > ALONG - 4)
    sheet(3, 21.25, 5.0, 3, lambda i: True)
    beams = []  # with a third node: without it the global axes say where a beam's 2 x 2 points lie
    for y in (7.0, 22.0):
        a, b = node((27.0, y, 0.0)), node((27.0, y, 2.0))
        beams.append(f"{c.first + 10000 + len(beams)},4,{a},{b},{c.first}")
    corners = [(x, y, z) for z in (0.0, 2.0) for x, y in ((40.0, 12.0), (45.0, 12.0), (45.0, 17.0), (40.0, 17.0))]
    brick = [node(p) for p in corners]
    if c.mirrored:  # so that its first edge goes along the same line
        brick = [brick[k] for k in (1, 0, 3, 2, 5, 4, 7, 6)]
    steel = f"{7.85e-9 * c.mass / c.length**3:.16g},{210000.0 * c.stress:.16g},0.3"
    s, cards = c.stress, ["*KEYWORD"]
    cards += ["*CONTROL_TERMINATION", f"{END * c.time:.16g}", "*CONTROL_ENERGY\n2,2,2,2", "*CONTROL_HOURGLASS\n4,0.05"]
    for name in ("GLSTAT", "SWFORC", "RCFORC"):
        cards += [f"*DATABASE_{name}", f"{END / STATES * c.time:.16g},2"]
    for part in (1, 2, 3):
        cards.append(f"*PART\nsheet\n{part},1,1")
    cards.append("*PART\nbeams\n4,4,4\n*PART\nbrick\n5,5,5,0,5\n*HOURGLASS\n5,6,1.0")
    cards.append("*SECTION_SHELL\n1,2,0.8333,3\n" + ",".join([f"{1.2 * c.length:.16g}"] * 4))
    cards.append(f"*SECTION_BEAM\n4,9,1.0,2,1\n{5.0 * c.length:.16g},{5.0 * c.length:.16g}\n*SECTION_SOLID\n5,1")
    cards.append(f"*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,{steel},{300 * s:.16g},{1000 * s:.16g}\n{40.4 / c.time:.16g},5.0\n\n")
    welds = f"{steel},{400 * s:.16g},{1000 * s:.16g}"
    cards.append(f"*MAT_SPOTWELD\n4,{welds}\n0.0,{1500 * c.force:.16g},{2000 * c.force:.16g},{2000 * c.force:.16g}\n*MAT_SPOTWELD\n5,{welds}\n")
    cards.append("*SET_PART_LIST\n1\n1,2\n*CONTACT_SPOTWELD\n4,1,3,2\n\n\n*CONTACT_SPOTWELD\n5,1,3,2\n\n")
    cards.append("*SET_PART_LIST\n2\n1,2,3\n*CONTACT_AUTOMATIC_SINGLE_SURFACE\n2,0,2,0\n0.2,0.2\n")
    cards.append(f"*RIGIDWALL_PLANAR\n0\n{c.place((0, 0, -0.25))},{c.place((0, 0, 9.75))},0.3")
    for part, v in ((2, (-4000.0, 0.0, 12000.0)), (3, (0.0, 0.0, -40000.0))):
        rows = [",".join(map(str, sets[part][i:i + 8])) for i in range(0, len(sets[part]), 8)]
        cards += [f"*SET_NODE_LIST\n{part}", *rows, f"*INITIAL_VELOCITY\n{part}", c.vector(v, c.velocity)]
    cards += ["*NODE", *nodes, "*ELEMENT_SHELL", *shells, "*ELEMENT_BEAM", *beams]
    cards += ["*ELEMENT_SOLID", f"{c.first + 20000},5," + ",".join(map(str, brick)), "*END"]
    return "\n".join(cards) + "\n"


class Invariance(CommandTest):
    def histories(self, name, case):
        """{quantity: one number a state} in mm, t, s."""
        self.nugget("run", self.write(deck(case), f"{name}.k").name, "-o", name, "-j1", "--quiet")
        found = lsda.read(self.folder / name / "binout0000")
        states = lsda.states(found, "glstat")
        self.assertEqual(len(states), STATES + 1)
        values = {q: [s[q][0] / case.energy for s in states]
                  for q in ("kinetic_energy", "internal_energy", "sliding_interface_energy", "stonewall_energy", "hourglass_energy")}
        for q in ("axial", "shear"):
            for weld in range(3):
                values[f"{q} of weld {weld}"] = [s[q][weld] / case.force for s in lsda.states(found, "swforc")]
        return values

    def expect_same(self, case):
        reference, found = self.histories("reference", Case()), self.histories("other", case)
        for quantity, expected in reference.items():
            size = max(map(abs, expected))
            self.assertGreater(size, 0.0, quantity)
            for a, b in zip(expected, found[quantity]):
                self.assertAlmostEqual(b / size, a / size, delta=1e-7, msg=quantity)

    def test_turned(self):
        # About (1, 2, 2)/3 by the angle of cosine 0.6 and sine 0.8.
        n, k, s = (1 / 3, 2 / 3, 2 / 3), 0.6, 0.8
        cross = ((0, -n[2], n[1]), (n[2], 0, -n[0]), (-n[1], n[0], 0))
        self.expect_same(Case(turn=tuple(tuple((i == j) * k + (1 - k) * n[i] * n[j] + s * cross[i][j] for j in range(3)) for i in range(3))))

    def test_mirrored(self):
        self.expect_same(Case(turn=((-1, 0, 0), (0, 1, 0), (0, 0, 1)), mirrored=True))

    def test_far_away(self):
        # The deck's places are multiples of 1/4 mm: the shift rounds none of them.
        self.expect_same(Case(shift=(4096.0, -2048.0, 1024.0)))

    def test_in_other_units(self):
        for units in ({"mass": 1e-3, "length": 1e3}, {"mass": 1e-3, "time": 1e-3}, {"mass": 1e-6, "time": 1e-3}):  # kg m s, kg mm ms, g mm ms
            self.expect_same(Case(**units))

    def test_with_other_numbers(self):
        self.expect_same(Case(first=1234567))


if __name__ == "__main__":
    unittest.main()
