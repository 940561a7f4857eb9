# SPDX-License-Identifier: Apache-2.0
"""Flat sheets and welds between them, put together as a deck in mm, t, s: for audits, stacks, and other runs of a few welds."""

STEEL = "7.85e-9,210000.0,0.3"


class Sheets:
    def __init__(self, shells=2):
        self.cards, self.nodes, self.shells, self.beams, self.solids = [], [], [], [], []
        self.node = self.element = self.part = 0
        self.grids = {}  # by part: (nodes per row, number of rows, first node)
        self.elform = shells
        self.cards.append(f"*MAT_ELASTIC\n1,{STEEL}")

    def add_node(self, x, y, z):
        self.node += 1
        self.nodes.append(f"{self.node},{x:.9g},{y:.9g},{z:.9g}")
        return self.node

    def add_part(self, title, section, material=1, hourglass=0):
        self.part += 1
        self.cards.append(f"*PART\n{title}\n{self.part},{section or self.part},{material},0,{hourglass}")
        return self.part

    def sheet(self, thickness, x, y, z, nx, ny, size):
        """A sheet of nx times ny squares from (x, y) on; its part."""
        part = self.add_part("sheet", 0)
        self.cards.append(f"*SECTION_SHELL\n{part},{self.elform},0.8333,3\n{thickness},{thickness},{thickness},{thickness}")
        first = self.node + 1
        for j in range(ny + 1):
            for i in range(nx + 1):
                self.add_node(x + i * size, y + j * size, z)
        for j in range(ny):
            for i in range(nx):
                a = first + j * (nx + 1) + i
                self.element += 1
                self.shells.append(f"{self.element},{part},{a},{a + 1},{a + nx + 2},{a + nx + 1}")
        self.grids[part] = (nx + 1, ny + 1, first)
        return part

    def row(self, part, j):
        """Nodes of row j (all with the same y) of a sheet; negative j from the end."""
        columns, rows, first = self.grids[part]
        j %= rows
        return list(range(first + j * columns, first + (j + 1) * columns))

    def column(self, part, i):
        columns, rows, first = self.grids[part]
        return [first + j * columns + i % columns for j in range(rows)]

    def beam_part(self, diameter, material):
        part = self.add_part("weld beams", 0, material)
        self.cards.append(f"*SECTION_BEAM\n{part},9,1.0,2,1\n{diameter},{diameter},0.0,0.0")
        return part

    def beam(self, part, a, b):
        ends = [self.add_node(*a), self.add_node(*b)]
        self.element += 1
        self.beams.append(f"{self.element},{part},{ends[0]},{ends[1]}")
        return self.element

    def brick_part(self, material):
        self.cards.append("*HOURGLASS\n6,6,1.0")
        part = self.add_part("weld bricks", 0, material, 6)
        self.cards.append(f"*SECTION_SOLID\n{part},1")
        return part

    def brick(self, part, x, y, z, side, height):
        corners = [(x + i * side / 2, y + j * side / 2, z + k * height)
                   for k in (0, 1) for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        ids = [self.add_node(*c) for c in corners]
        self.element += 1
        self.solids.append(f"{self.element},{part}," + ",".join(map(str, ids)))
        return self.element

    def part_set(self, number, parts):
        self.cards.append(f"*SET_PART_LIST\n{number}\n" + rows_of_eight(parts))

    def node_set(self, number, nodes):
        self.cards.append(f"*SET_NODE_LIST\n{number}\n" + rows_of_eight(nodes))

    def tie(self, welds, sheets, number=1, form="", thickness=""):
        """*CONTACT_SPOTWELD of weld parts to sheets."""
        self.part_set(100 + 2 * number, welds)
        self.part_set(101 + 2 * number, sheets)
        self.cards.append(f"*CONTACT_SPOTWELD{form}\n{100 + 2 * number},{101 + 2 * number},2,2\n0.0\n1.0,1.0,{thickness},{thickness}")

    def text(self):
        return "\n".join(["*KEYWORD", *self.cards, "*NODE", *self.nodes, "*ELEMENT_SHELL", *self.shells,
                          *(["*ELEMENT_BEAM", *self.beams] if self.beams else []),
                          *(["*ELEMENT_SOLID", *self.solids] if self.solids else []), "*END"]) + "\n"


def rows_of_eight(ids):
    return "\n".join(",".join(map(str, ids[i:i + 8])) for i in range(0, len(ids), 8))


def weld_material(number, young=210000.0, dt=0.0, card="0.0,8000.0,6000.0,6000.0,9000.0,7000.0,7000.0"):
    return f"*MAT_SPOTWELD\n{number},7.85e-9,{young},0.3,500.0,1000.0,{dt}\n{card}"
