# SPDX-License-Identifier: Apache-2.0
"""What must not matter: where a model lies, how it is turned, which hand it has, its units, its numbers, and whether *INCLUDE_TRANSFORM does
all that. Two sheets of rate-dependent steel, joined by weld beams and a brick, of which one end is thrown up, are hit by a third and run into
a wall; two rigid bars on a joint tumble on a wall beside springs and damped strips, and a block of rubber is thrown. The same deck written otherwise must give
the same energies and forces."""
import math
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

    def of(self, value, mass=0, length=0, time=0):
        """A value in t, mm, s of a dimension."""
        return f"{value * self.mass**mass * self.length**length * self.time**time:.16g}"

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


# Fields whose dimension another field, or the size of the number, decides: constants of torsional springs (DRO 1), SIGY of 018 (a strain up to
# 0.02), COEF of damping by stiffness (a time below 0). And bounds from tensors, which must not know the global axes: of what turns a body on a
# wall, of the stretch of rubber.
LAWS = {31: ("SPRING_ELASTIC", lambda c, l: [c.of(500 * l * l, 1, 2 if l > 1 else 0, -2)]),
        32: ("DAMPER_VISCOUS", lambda c, l: [c.of(0.02 * l * l, 1, 2 if l > 1 else 0, -1)]),
        33: ("SPRING_ELASTOPLASTIC", lambda c, l: [c.of(500 * l * l, 1, 2 if l > 1 else 0, -2), c.of(50 * l * l, 1, 2 if l > 1 else 0, -2),
                                                   c.of(2 * l, 1, 2 if l > 1 else 1, -2)]),
        34: ("SPRING_MAXWELL", lambda c, l: [c.of(500 * l * l, 1, 2 if l > 1 else 0, -2), c.of(100 * l * l, 1, 2 if l > 1 else 0, -2),
                                             c.of(20000, 0, 0, -1)])}


class Cards(list):
    """Keywords of a deck, and its nodes."""

    def __init__(self, case):
        self.case, self.nodes = case, []

    def node(self, p):
        self.nodes.append(f"{self.case.first + len(self.nodes)},{self.case.place(p)}")
        return self.case.first + len(self.nodes) - 1

    def add(self, keyword, *lines):
        self.append("\n".join([f"*{keyword}", *(",".join(map(str, line)) + "," for line in lines)]))

    def text(self, end, *databases):
        self.add("CONTROL_TERMINATION", (self.case.of(end, 0, 0, 1),))
        self.add("CONTROL_ENERGY", (2, 2, 2, 2))
        for name in databases:
            self.add(f"DATABASE_{name}", (self.case.of(end / 10, 0, 0, 1), 2))
        return "\n".join(["*KEYWORD", *self, "*NODE", *self.nodes, "*END"]) + "\n"


def mechanism(c):
    cards = Cards(c)
    node, add = cards.node, cards.add
    steel = (c.of(7.85e-9, 1, -3), c.of(210000, 1, -1, -2), 0.3)
    add("SECTION_SOLID", (1, 1))
    add("MAT_RIGID", (1, *steel), (), ())
    bars = []
    for part, (x, y, z) in ((1, (0.0, 0.0, 0.5)), (2, (12.0, 1.0, 0.75))):
        corners = [(x + a, y + b, z + d) for d in (0.0, 3.0) for a, b in ((0.0, 0.0), (10.0, 0.5), (9.0, 5.0), (0.0, 4.0))]
        bars.append([node(p) for p in corners])
        cards.append(f"*PART\nbar\n{part},1,1")
        add("ELEMENT_SOLID", (c.first + part, part, *bars[-1]))
        joined = node((11.0, 2.0, 2.0))
        add("CONSTRAINED_EXTRA_NODES_NODE", (part, joined))
    add("CONSTRAINED_JOINT_SPHERICAL", (bars[0][-1] + 1, bars[1][-1] + 1))
    add("INITIAL_VELOCITY_RIGID_BODY", (1, c.vector((2000.0, 500.0, -20000.0), c.velocity)), (2, c.vector((2000.0, 500.0, -20000.0), c.velocity)))
    add("RIGIDWALL_PLANAR", (0,), (c.place((0, 0, 0)), c.place((0, 0, 10)), 0.3))
    add("CONTROL_CONTACT", (0.1, 1.0))

    # Pairs of beams end to end, a spring between them, one of each pair thrown and spun.
    add("SECTION_BEAM", (3, 2), (c.of(9, 0, 2), c.of(7, 0, 4), c.of(8, 0, 4), c.of(12, 0, 4)))
    add("MAT_ELASTIC", (3, *steel))
    cards.append("*PART\nbeams\n3,3,3")
    third, springs = node((0.0, 500.0, 300.0)), []
    for dro in (0, 1):
        add("SECTION_DISCRETE", (40 + dro, dro, 0.2, c.of(3000.0, 0, 0 if dro else 1, -1)), ())
        for law, (name, fields) in LAWS.items():
            number = 10 * dro + law
            add(f"MAT_{name}", (number, *fields(c, 5.0 if dro else 1.0)))
            cards.append(f"*PART\nspring\n{number},{40 + dro},{number}")
            y = 20.0 * len(springs)
            a, b, d, e = (node((x, 50.0 + y, z)) for x, z in ((0.0, 0.0), (8.0, 1.0), (11.0, 3.0), (20.0, 2.0)))
            n = c.first + 100 + len(springs)
            add("ELEMENT_BEAM", (n, 3, a, b, third), (n + 50, 3, d, e, third))
            springs.append((n + 100, number, b, d))
            add("ELEMENT_DISCRETE", (n + 100, number, b, d, 0, 1, 0, c.of(0.1, 0, 0 if dro else 1)))
            add("INITIAL_VELOCITY_NODE", (e, c.vector((1500.0, 1000.0, -800.0), c.velocity), c.vector((300.0, -200.0, 100.0), 1 / c.time)))

    add("SECTION_SHELL", (5, 2, 0.8333, 3), [c.of(1.25, 0, 1)] * 4)
    for part, yield_strain in ((5, 0.001), (6, c.of(300, 1, -1, -2))):
        add("MAT_POWER_LAW_PLASTICITY", (part, *steel, c.of(600, 1, -1, -2), 0.2), (yield_strain,))
        cards.append(f"*PART\nstrip\n{part},5,{part}")
        grid = [[node((SIZE * i, 60.0 * part + SIZE * j, 0.25 * i * j)) for i in range(5)] for j in range(4)]
        add("ELEMENT_SHELL", *((c.first + 50 * part + 10 * j + i, part, grid[j][i], grid[j][i + 1], grid[j + 1][i + 1], grid[j + 1][i])
                               for j in range(3) for i in range(4)))
        add("SET_NODE_LIST", (part,), grid[2], grid[3])
        add("INITIAL_VELOCITY", (part,), (c.vector((5000.0, 3000.0, 20000.0), c.velocity),))
        add("DAMPING_PART_STIFFNESS", (part, f"-{c.of(1e-7, 0, 0, 1)}"))
    return cards.text(1e-4, "GLSTAT", "MATSUM", "DEFORC")


def rubber(c):
    """A block whose time step follows from its largest stretch."""
    cards = Cards(c)
    cards.add("SECTION_SOLID", (1, 1))
    cards.add("MAT_BLATZ-KO_RUBBER", (1, c.of(1.2e-9, 1, -3), c.of(20, 1, -1, -2)))
    cards.append("*PART\nrubber\n1,1,1")
    block = [[cards.node((x + 0.4 * z, y + 0.1 * x, z)) for x, y in ((0.0, 0.0), (4.0, 0.0), (4.0, 5.0), (0.0, 5.0))] for z in (0.0, 5.0, 10.5)]
    cards.add("ELEMENT_SOLID", *((c.first + i, 1, *below, *above) for i, (below, above) in enumerate(zip(block, block[1:]))))
    cards.add("SET_NODE_LIST", (1,), block[2])
    cards.add("INITIAL_VELOCITY", (1,), (c.vector((20000.0, 5000.0, 15000.0), c.velocity),))
    cards.add("CONTROL_TIMESTEP", (0, 0.6))
    return cards.text(2e-4, "GLSTAT")


def over_an_edge(c):
    """A sheet whose end falls beside the edge of a block of bricks: the edge is the closest of two of its faces, whose stiffnesses differ."""
    cards = Cards(c)
    cards.add("SECTION_SOLID", (1, 1))
    cards.add("SECTION_SHELL", (2, 2, 0.8333, 3), [c.of(1.25, 0, 1)] * 4)
    cards.add("MAT_PLASTIC_KINEMATIC", (1, c.of(7.85e-9, 1, -3), c.of(210000, 1, -1, -2), 0.3, c.of(300, 1, -1, -2), c.of(1500, 1, -1, -2), 1), ())
    cards.append("*PART\nblock\n1,1,1\n*PART\nsheet\n2,2,1")
    block = [[[cards.node((5.0 * i, 4.0 * j, 6.0 * k)) for i in range(5)] for j in range(3)] for k in range(2)]
    sheet = [[cards.node((5.5 * i + 3.75 - 1.25 * j, 5.5 * j + 1.25 * i + 0.5, 7.0 + 0.125 * i * j)) for i in range(4)] for j in range(2)]
    ring = ((0, 0), (0, 1), (1, 1), (1, 0))
    bricks = [[layer[j + b][i + a] for layer in block for b, a in ring] for j in range(2) for i in range(4)]
    shells = [[sheet[b][i + a] for b, a in ring] for i in range(3)]
    for keyword, part, elements in (("ELEMENT_SOLID", 1, bricks), ("ELEMENT_SHELL", 2, shells)):
        cards.add(keyword, *((c.first + n, part, *nodes) for n, nodes in enumerate(elements)))
    cards.add("INITIAL_VELOCITY_NODE", *((n, c.vector((1000.0, 0.0, -8000.0), c.velocity)) for row in sheet for n in row))
    cards.add("CONTACT_AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE", (2, 1, 3, 3), (0.2, 0.2), ())
    cards.add("CONTROL_TIMESTEP", (0, 0.7))
    return cards.text(2e-4, "GLSTAT", "RCFORC")


def on_assemblies(c):
    """Two sheets of a steel with Cowper and Symonds' rates on two assemblies of four bricks each that lie askew in the plane."""
    cards = Cards(c)
    steel = (c.of(7.85e-9, 1, -3), c.of(210000, 1, -1, -2), 0.3)
    cards.add("SECTION_SHELL", (1, 16, 0.8333, 3), [c.of(1.25, 0, 1)] * 4)
    cards.add("SECTION_SOLID", (3, 1))
    cards.add("HOURGLASS", (3, 6, 1.0))
    cards.add("MAT_PIECEWISE_LINEAR_PLASTICITY", (1, *steel, c.of(300, 1, -1, -2), c.of(1000, 1, -1, -2)), (c.of(40, 0, 0, -1), 5.0), (), ())
    cards.add("MAT_SPOTWELD", (3, *steel, c.of(400, 1, -1, -2), c.of(1000, 1, -1, -2)), ())
    shells = []
    for part, (x, y, z) in ((1, (0.0, 0.0, 0.0)), (2, (1.0, 1.25, 1.5))):
        cards.append(f"*PART\nsheet\n{part},1,1")
        grid = [[cards.node((x + 5.0 * i + 0.25 * (j % 2), y + 5.5 * j, z)) for i in range(7)] for j in range(5)]
        shells += [(part, grid[j][i], grid[j][i + 1], grid[j + 1][i + 1], grid[j + 1][i]) for j in range(4) for i in range(6)]
    cards.add("INITIAL_VELOCITY_NODE", *((n, c.vector((12000.0, 6000.0 + 500.0 * j, 4000.0 + 1500.0 * i), c.velocity)) for j, row in enumerate(grid) for i, n in enumerate(row)))
    cards.add("ELEMENT_SHELL", *((c.first + e, *shell) for e, shell in enumerate(shells)))
    cards.append("*PART\nweld\n3,3,3,0,3")
    bricks = []
    for x, y, u, v in ((12.0, 10.0, (1.25, 0.75), (-0.5, 1.0)), (20.0, 15.0, (0.75, 1.25), (-1.0, 0.5))):
        at = {(i, j, k): cards.node((x + i * u[0] + j * v[0], y + i * u[1] + j * v[1], 1.5 * k)) for k in (0, 1) for j in (-1, 0, 1) for i in (-1, 0, 1)}
        bricks += [[at[i + a, j + b, k] for k in (0, 1) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))] for j in (-1, 0) for i in (-1, 0)]
    cards.add("ELEMENT_SOLID", *((c.first + 1000 + e, 3, *brick) for e, brick in enumerate(bricks)))
    cards.add("SET_PART_LIST", (1,), (1, 2))
    cards.add("CONTACT_SPOTWELD", (3, 1, 3, 2), (), ())
    return cards.text(1.5e-4, "GLSTAT", "SWFORC")


def beside_supports(c):
    """A sheet between a wall with mass and a cylinder, with friction; edges of it are held and driven askew to both."""
    cards = Cards(c)
    cards.add("SECTION_SHELL", (1, 2, 0.8333, 3), [c.of(1.25, 0, 1)] * 4)
    cards.add("MAT_PLASTIC_KINEMATIC", (1, c.of(7.85e-9, 1, -3), c.of(210000, 1, -1, -2), 0.3, c.of(300, 1, -1, -2), c.of(1500, 1, -1, -2), 1), ())
    cards.append("*PART\nsheet\n1,1,1")
    grid = [[cards.node((5.0 * i, 5.5 * j + 0.25 * i, 2.0 + 0.0625 * i * j)) for i in range(7)] for j in range(5)]
    cards.add("ELEMENT_SHELL", *((c.first + 10 * j + i, 1, grid[j][i], grid[j][i + 1], grid[j + 1][i + 1], grid[j + 1][i]) for j in range(4) for i in range(6)))
    cards.add("INITIAL_VELOCITY_NODE", *((n, c.vector((3000.0, 2000.0 + 100.0 * j, -20000.0 + 1000.0 * i), c.velocity)) for j, row in enumerate(grid) for i, n in enumerate(row)))
    cards.add("DEFINE_COORDINATE_SYSTEM", (1, c.place((0, 0, 0)), c.place((8, 2, 4))), (c.place((-2, 8, 0)),))
    cards.add("DEFINE_VECTOR", (2, 0, 0, 0, c.vector((6.0, 4.0, -4.0), c.length)))
    cards.add("SET_NODE_LIST", (1,), [row[0] for row in grid])
    cards.add("SET_NODE_LIST", (2,), grid[0][1:])
    cards.add("SET_NODE_LIST", (3,), [row[6] for row in grid[1:]])
    cards.add("BOUNDARY_SPC_SET", (1, 1, 1, 0, 0, 0, 0, 0), (2, 1, 0, 1, 1, 0, 0, 0))
    cards.add("DEFINE_CURVE", (1,), (0, c.of(9000, 0, 1, -1)), (c.of(1, 0, 0, 1), c.of(9000, 0, 1, -1)))
    cards.add("BOUNDARY_PRESCRIBED_MOTION_SET", (3, 4, 0, 1, 1.0, 2))
    cards.add("RIGIDWALL_PLANAR_MOVING", (0,), (c.place((0, 0, 0.5)), c.place((0.5, -1.0, 10.5)), 0.3), (c.of(3e-6, 1), c.of(5000, 0, 1, -1)))
    cards.add("RIGIDWALL_GEOMETRIC_CYLINDER", (0,), (c.place((2, 9, -7)), c.place((12, 12, -6.75)), 0.2), (c.of(8, 0, 1), c.of(20, 0, 1)))
    return cards.text(2e-4, "GLSTAT", "RWFORC")


FIBRES = ("MAT_022", (1, 1.52e-9, 127e3, 8.41e3, 8.41e3, 0.0205, 0.0205, 0.3), (4.21e3, 4.21e3, 4.21e3, "", 2), (0, 0, 0, 0.6, 0.8, 0.1),
          (0, 0, 0, -0.8, 0.6, 0), (154.0, 2200.0, 48.9, 199.0, 1e-9))
RUBBER = ("MAT_027", (1, 1.2e-9, 0.49, 0.4, 0.1), ())


def triangles(elform, law, first):
    """A sheet of triangles that is sheared and bent. `first`: which node of the e-th triangle stands first on its card."""
    cards = Cards(Case())
    cards.add("SECTION_SHELL", (1, elform, 0.8333, 3), [1.2] * 4)
    cards.add(*law)
    cards.add("CONTROL_SHELL", ("", "", "", 1))
    cards.append("*PART\nsheet\n1,1,1")
    grid = [[cards.node((5.0 * i + 1.25 * j, 5.0 * j - 0.5 * i, 0.25 * i * j)) for i in range(4)] for j in range(3)]
    cells = [(grid[j][i], grid[j][i + 1], grid[j + 1][i + 1], grid[j + 1][i]) for j in range(2) for i in range(3)]
    corners = [c for n in cells for c in (n[:3], (n[0], n[2], n[3]))]
    rows = [tuple(n[(first(e) + k) % 3] for k in range(3)) for e, n in enumerate(corners)]
    cards.add("ELEMENT_SHELL", *((e + 1, 1, *n, n[2]) for e, n in enumerate(rows)))
    speed = 3000.0 if law is RUBBER else 20000.0
    cards.add("INITIAL_VELOCITY_NODE", *((n, speed * (j - 1) + 300 * i, -speed * 0.3 * (i - 1), 0.2 * speed * (i * j % 3 - 1))
                                         for j, row in enumerate(grid) for i, n in enumerate(row)))
    return cards.text(5e-4 if law is RUBBER else 5e-5, "GLSTAT")


def damped(elements, first):
    """A sheet of quadrilaterals or triangles, or a block of bricks, that is sheared under damping of its deformation. `first`: by how many corners the
    e-th card is turned on."""
    cards = Cards(Case())
    cards.add("SECTION_SHELL", (1, 2, 0.8333, 3), [1.25] * 4)
    cards.add("SECTION_SOLID", (2, 2))
    cards.add("CONTROL_SHELL", (20, 1))
    cards.add("MAT_ELASTIC", (1, 7.85e-9, 210000, 0.3))
    cards.add("DAMPING_FREQUENCY_RANGE_DEFORM", (0.02, 1000, 50000))
    cards.append(f"*PART\npart\n1,{2 if elements == 'bricks' else 1},1")
    layers = [[[cards.node((5.0 * i + 1.25 * j, 5.0 * j - 0.5 * i, 0.25 * i * j + 4.0 * k)) for i in range(5)] for j in range(4)]
              for k in range(2 if elements == "bricks" else 1)]
    rings = [[[layer[j + b][i + a] for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))] for layer in layers] for j in range(3) for i in range(4)]
    if elements == "triangles":
        rings = [[half] for (n,) in rings for half in (n[:3], (n[0], n[2], n[3]))]
    rows = [[ring[(k + first(e)) % len(ring)] for ring in both for k in range(len(ring))] for e, both in enumerate(rings)]
    cards.add("ELEMENT_SOLID" if elements == "bricks" else "ELEMENT_SHELL", *((e + 1, 1, *n, *([n[2]] if len(n) == 3 else [])) for e, n in enumerate(rows)))
    cards.add("INITIAL_VELOCITY_NODE", *((n, 300.0 * (5.0 * i - 8.0), 400.0 * (5.0 * j - 6.0) - 900.0 * i, 1000.0 * i)
                                         for layer in layers for j, row in enumerate(layer) for i, n in enumerate(row)))
    return cards.text(1e-4, "GLSTAT")


AXIS, COSINE, SINE = (1 / 3, 2 / 3, 2 / 3), 0.6, 0.8  # the angle is math.atan2(SINE, COSINE)


def oblique():
    n, k, s = AXIS, COSINE, SINE
    cross = ((0, -n[2], n[1]), (n[2], 0, -n[0]), (-n[1], n[0], 0))
    return tuple(tuple((i == j) * k + (1 - k) * n[i] * n[j] + s * cross[i][j] for j in range(3)) for i in range(3))


def included(c, mirrored=False):
    """A deck that brings inner.k, written in t, mm and s, to the turn, shift and units of a case; and mirrors it before."""
    first = "MIRROR,3,2,1,4,4,4\n" if mirrored else ""
    move = ",".join(c.of(a, 0, 1) for a in c.shift)
    turn = ",".join(f"{a:.16g}" for a in AXIS)
    return (f"*KEYWORD\n*INCLUDE_TRANSFORM\ninner.k\n1000,2000,300,400,500,600,700\n800,\n"
            f"{c.mass:.16g},{c.time:.16g},{c.length:.16g}\n1,\n*DEFINE_TRANSFORMATION\n1,\nTRANSL,{move}\n"
            f"ROTATE,{turn},0,0,0,{math.degrees(math.atan2(SINE, COSINE)):.16g}\n{first}*END\n")


class Invariance(CommandTest):
    def run_deck(self, name, text):
        self.nugget("run", self.write(text, f"{name}.k").name, "-o", name, "-j1", "--quiet")
        return lsda.read(self.folder / name / "binout0000")

    def histories(self, name, case, text=None):
        """{quantity: one number a state} in mm, t, s."""
        found = self.run_deck(name, text or deck(case))
        states = lsda.states(found, "glstat")
        self.assertEqual(len(states), STATES + 1)
        values = {q: [s[q][0] / case.energy for s in states]
                  for q in ("kinetic_energy", "internal_energy", "sliding_interface_energy", "stonewall_energy", "hourglass_energy")}
        for q in ("axial", "shear"):
            for weld in range(3):
                values[f"{q} of weld {weld}"] = [s[q][weld] / case.force for s in lsda.states(found, "swforc")]
        return values

    def histories_of_mechanism(self, name, case, text=None):
        found = self.run_deck(name, text or mechanism(case))
        values = {q: [state[q][0] / case.energy for state in lsda.states(found, "glstat")]
                  for q in ("kinetic_energy", "internal_energy", "stonewall_energy", "spring_and_damper_energy", "total_energy")}
        for q in ("internal_energy", "kinetic_energy"):
            for i in range(12):
                series = [state[q][i] / case.energy for state in lsda.states(found, "matsum")]
                if max(map(abs, series)) > 0.0:
                    values[f"{q} of part {i}"] = series
        # torsional ones give moments
        kinds, states = found["deforc/metadata/irot"], lsda.states(found, "deforc")
        for i, turns in enumerate(kinds):
            values[f"spring {i}"] = [state["resultant_force"][i] / (case.energy if turns else case.force) for state in states]
            values[f"elongation {i}"] = [state["displacement"][i] / (1.0 if turns else case.length) for state in states]
        return values

    def compare(self, reference, found):
        self.assertEqual(reference.keys(), found.keys())
        for quantity, expected in reference.items():
            size = max(map(abs, expected))
            self.assertGreater(size, 0.0, quantity)
            self.assertEqual(len(expected), len(found[quantity]), quantity)
            for a, b in zip(expected, found[quantity]):
                self.assertAlmostEqual(b / size, a / size, delta=1e-7, msg=quantity)

    def expect_same(self, case):
        self.compare(self.histories("reference", Case()), self.histories("other", case))

    def test_turned(self):
        self.expect_same(Case(turn=oblique()))

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

    def test_included(self):
        self.write(deck(Case()), "inner.k")
        reference = self.histories("reference", Case())
        for units in ({}, {"mass": 1e-3, "length": 1e3}, {"mass": 1e-6, "length": 10.0, "time": 1e-6}):
            case = Case(turn=oblique(), shift=(64.0, -32.0, 16.0), **units)
            for mirrored in (False, True):
                with self.subTest(mirrored=mirrored, **units):
                    self.compare(reference, self.histories("other", case, included(case, mirrored)))

    def test_mechanism(self):
        reference = self.histories_of_mechanism("reference", Case())
        self.write(mechanism(Case()), "inner.k")
        # as 018 reads a stress of up to 0.02 as a strain, none of these units has such a one
        for units in ({}, {"mass": 1e-3, "length": 1e3}, {"mass": 1e-3, "time": 1e-3}):
            case = Case(turn=oblique(), shift=(64.0, -32.0, 16.0), **units)
            for name, text in (("written", None), ("included", included(case))):
                with self.subTest(name, **units):
                    self.compare(reference, self.histories_of_mechanism("other", case, text))
        # in an included file its own number counts
        case = Case(turn=oblique(), mass=1e-6, length=10.0, time=1e-6)
        self.compare(reference, self.histories_of_mechanism("other", case, included(case)))
        self.compare(reference, self.histories_of_mechanism("other", Case(first=123456)))

    def test_first_corner_of_a_brick_weld_on_warped_sheets(self):
        found = []
        for first in range(4):
            cards = Cards(Case())
            steel = (7.85e-9, 210000, 0.3)
            cards.add("SECTION_SHELL", (1, 2, 0.8333, 3), [1.0] * 4)
            cards.add("MAT_ELASTIC", (1, *steel))
            for part, z, warp in ((1, 0.0, 0.75), (2, 2.0, -0.5)):
                cards.append(f"*PART\nsheet\n{part},1,1")
                corners = [cards.node(p) for p in ((0, 0, z + warp), (12, 0, z), (12, 10, z + warp), (0, 10, z))]
                cards.add("ELEMENT_SHELL", (part, part, *corners))
                cards.add("SET_NODE_LIST", (part,), corners)
            faces = [[cards.node((x, y, z)) for x, y in ((3, 3), (8, 3), (8, 7), (3, 7))] for z in (0.5, 1.75)]
            cards.add("SECTION_SOLID", (3, 1))
            cards.add("MAT_SPOTWELD", (3, *steel, 400, 1000), ())
            cards.append("*PART\nweld\n3,3,3,0,3\n*HOURGLASS\n3,6,1.0")
            cards.add("ELEMENT_SOLID", (1, 3, *(face[(first + k) % 4] for face in faces for k in range(4))))
            cards.add("SET_PART_LIST", (1,), (1, 2))
            cards.add("CONTACT_SPOTWELD", (3, 1, 3, 2), (), ())
            cards.add("INITIAL_VELOCITY", (2,), (500, 0, 2000))
            found.append(lsda.states(self.run_deck(f"weld{first}", cards.text(1e-6, "SWFORC")), "swforc")[0]["length"][0])
        for length in found[1:]:
            self.assertAlmostEqual(length, found[0], 10)

    def test_over_an_edge(self):
        """Sabotage: of two segments whose common edge is closest, the one that round-off makes closer, or the first of the list."""
        found = []
        for case in (Case(), Case(turn=oblique()), Case(turn=oblique(), shift=(64.0, -32.0, 16.0))):
            states = lsda.states(self.run_deck("edge", over_an_edge(case)), "glstat")
            found.append({q: [s[q][0] for s in states] for q in ("kinetic_energy", "internal_energy", "sliding_interface_energy")})
        for other in found[1:]:
            self.compare(found[0], other)

    def same_in_cases(self, make, cases, values, *options):
        reference = None
        for case in cases:
            self.nugget("run", self.write(make(case), "model.k").name, "-o", "out", "-j1", "--quiet", *options)
            found = values(lsda.read(self.folder / "out" / "binout0000"), case)
            reference = reference or found
            with self.subTest(turned=case.turn != Case().turn, time=case.time):
                self.compare(reference, found)

    def test_joints_of_assemblies(self):
        """Sabotage: the joint's axes from the global ones; rates of sheets tabulated for seconds; at rest at 1e-12 a unit of time."""
        def values(found, case):
            states, welds = lsda.states(found, "glstat"), lsda.states(found, "swforc")
            out = {q: [s[q][0] / case.energy for s in states] for q in ("kinetic_energy", "internal_energy")}
            return {**out, **{f"{q} of weld {w}": [s[q][w] / case.force for s in welds] for q in ("axial", "shear") for w in (0, 1)}}
        cases = (Case(), Case(turn=oblique()), Case(mass=1e-3, time=1e-3))
        self.same_in_cases(on_assemblies, cases, values, "--weld-tie", "joint")

    def test_walls_beside_supports(self):
        """Sabotage: what the wall does to a node, along the global axes only where it is held."""
        def values(found, case):
            states = lsda.states(found, "glstat")
            for state in states:
                self.assertAlmostEqual(state["energy_ratio"][0], 1.0, delta=2e-3)
            out = {q: [s[q][0] / case.energy for s in states] for q in ("kinetic_energy", "internal_energy", "external_work")}
            return {**out, **{f"wall {w}": [s["normal_force"][w] / case.force for s in lsda.states(found, "rwforc/forces")] for w in (0, 1)}}
        self.same_in_cases(beside_supports, (Case(), Case(turn=oblique(), shift=(64.0, -32.0, 16.0)), Case(mass=1e-3, length=1e3)), values)

    def test_first_node_of_triangles(self):
        """Sabotage: a frame along the first side."""
        for elform in (4, 17, 5):
            for law in (FIBRES, RUBBER)[elform == 5:]:
                with self.subTest(elform=elform, law=law[0]):
                    found = []
                    for first in (lambda e: 0, lambda e: (e + 1) % 3):
                        states = lsda.states(self.run_deck("sheet", triangles(elform, law, first)), "glstat")
                        found.append({q: [s[q][0] for s in states] for q in ("kinetic_energy", "internal_energy")})
                    self.compare(*found)

    def test_first_corner_under_damping_of_deformation(self):
        """Sabotage: axes along the first sides, which turn otherwise than the second ones where the element is sheared."""
        for elements in ("quadrilaterals", "triangles", "bricks"):
            with self.subTest(elements):
                found = []
                for first in (lambda e: 0, lambda e: e % 4):
                    states = lsda.states(self.run_deck("damped", damped(elements, first)), "glstat")
                    found.append({q: [s[q][0] for s in states] for q in ("kinetic_energy", "internal_energy", "system_damping_energy")})
                self.compare(*found)

    def test_rubber(self):
        found = []
        for case in (Case(), Case(turn=oblique())):
            states = lsda.states(self.run_deck("rubber", rubber(case)), "glstat")
            found.append({q: [s[q][0] for s in states] for q in ("kinetic_energy", "internal_energy", "time_step")})
        self.compare(*found)


if __name__ == "__main__":
    unittest.main()
