# SPDX-License-Identifier: Apache-2.0
"""Contacts whose nodes stand in each other at the start: sheets with hanging nodes, segment-based contact, meshes much finer
than they are thick."""
import math
import unittest

from few_elements import card, nodes, part
from nugget_command import CommandTest

# A shell of 8 mm beside two by two of 4 mm: node 7 hangs on the side from 2 to 3.
PLACES = ((0, 0, 0), (8, 0, 0), (8, 8, 0), (0, 8, 0), (12, 0, 0), (16, 0, 0), (8, 4, 0), (12, 4, 0), (16, 4, 0), (12, 8, 0),
          (16, 8, 0))
SHELLS = ((1, 2, 3, 4), (2, 5, 8, 7), (5, 6, 9, 8), (7, 8, 10, 3), (8, 9, 11, 10))


def shells(corners, pid=1, first=1):
    return "*ELEMENT_SHELL\n" + "".join(f"{first + i:8}{pid:8}" + "".join(f"{n:8}" for n in c) + "\n" for i, c in enumerate(corners))


def contact(soft, thickness=0.0):
    return "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n" + card(0) + card(0) + card(1.0, 1.0, thickness) + card(soft)


def deck(*blocks, thickness=1.0, end=2e-4):
    return "".join(["*KEYWORD\n*CONTROL_TERMINATION\n", card(end), "*CONTROL_ENERGY\n", card(2, 2, 2, 2), "*DATABASE_GLSTAT\n",
                    card(end / 20), "*MAT_ELASTIC\n", card(1, 7.85e-9, 210000.0, 0.3), "*SECTION_SHELL\n", card(1, 2, 0.833, 2),
                    card(*[thickness] * 4), part(1), *blocks, "*END\n"])


class InitialPenetrations(CommandTest):
    def run_deck(self, text):
        self.write(text)
        return self.nugget("run", "model.k", "--quiet", "-j", 1)

    def test_a_hanging_node_does_not_stand_in_the_shell_on_whose_side_it_hangs(self):
        """The sheet is thicker than its shells are long, and is pulled. Sabotage: segments that do not know what hangs on their
        sides; nodes were moved out of the sheet by half its thickness, and its own contact pressed it apart."""
        sheet = [nodes(PLACES), shells(SHELLS), "*CONSTRAINED_ADAPTIVITY\n", card(7, 2, 3), "*INITIAL_VELOCITY_NODE\n",
                 *(card(n, 1000.0, 200.0, 300.0) for n in (6, 9, 11))]
        for soft in (0, 1):
            run = self.run_deck(deck(*sheet, contact(soft, thickness=6.0)))
            self.assertNotIn("stand in the thickness", run.stderr)
            states = self.glstat()
            self.assertEqual({s["sliding interface energy"] for s in states}, {0.0})
            self.assertGreater(states[-1]["internal energy"], 0.0)

    def test_segment_based_contact_moves_no_nodes(self):
        """Two sheets 0.6 mm apart, 1 mm thick. Sabotage: IGNORE 0 obeyed with SOFT 2 too."""
        lower = [(4.0 * i, 4.0 * j, 0.0) for j in range(3) for i in range(3)]
        upper = [(x + 1.0, y + 1.0, 0.6) for x, y, _ in lower]
        corners = [(a, a + 1, a + 4, a + 3) for a in (1, 2, 4, 5)]
        sheets = [nodes(lower + upper), shells(corners), shells([[n + 9 for n in c] for c in corners], first=11)]
        for soft, told in ((1, "they were moved out (IGNORE = 0)"), (2, "the overlap is kept and gives no force (SOFT = 2)")):
            run = self.run_deck(deck(*sheets, contact(soft)))
            self.assertIn(told, run.stderr + self.read("run.log"))
            self.assertEqual({s["kinetic energy"] for s in self.glstat()}, {0.0})

    def test_sheets_that_go_through_each_other_are_named(self):
        """A sheet of 4 x 4 stands across another one, 0.05 beside a row of its nodes; three of its edges go through, and one of the other's. Sabotage:
        crossings not looked for, or looked for in one sheet."""
        flat = [(4.0 * i, 4.0 * j, 0.0) for j in range(5) for i in range(5)]
        across = [(4.0 * i + 2.0, 8.05, 4.0 * j - 2.0) for j in range(3) for i in range(3)]
        squares = [(5 * j + i, 5 * j + i + 1, 5 * j + i + 6, 5 * j + i + 5) for j in range(4) for i in range(1, 5)]
        corners = [(a, a + 1, a + 4, a + 3) for a in (26, 27, 29, 30)]
        sheets = [nodes(flat + across), shells(squares), shells(corners, first=101)]
        crossing = (r"5 edges of shells go through other shells at the start, which nothing pulls out again; the first is from node 12 to 17, "
                    r"near \(4, 10, 0\), through shell 10[13]")
        self.write(deck(*sheets, contact(2)))
        self.assertRegex(self.nugget("check", "model.k", "-o", "audit").stderr, crossing)
        self.nugget("run", "model.k", "--quiet", "-j", 1)
        self.assertRegex(self.read("run.log"), crossing)
        beside = [(x, y + 30.0, z) for x, y, z in across]
        self.write(deck(nodes(flat + beside), *sheets[1:], contact(2)))
        self.assertNotIn("go through", self.nugget("check", "model.k", "-o", "audit").stderr)

    def test_where_nodes_are_moved_does_not_depend_on_their_numbers(self):
        """Three curved sheets of unlike meshes, 1 mm thick and 0.6 mm apart, the upper two thrown. Sabotage: of the shells that a node stands in
        the first in their order moves it."""
        def surface(x, y):
            return 3.0 * math.sin(0.12 * x) * math.cos(0.1 * y)

        places, corners = [], []
        for nx, ny, above in ((8, 6, 0.0), (7, 5, 0.6), (6, 7, 1.2)):
            first = len(places)
            places += [(x, y, surface(x, y) + above) for y in (30.0 * j / ny for j in range(ny + 1)) for x in (40.0 * i / nx for i in range(nx + 1))]
            corners += [(a, a + 1, a + nx + 2, a + nx + 1) for a in (first + j * (nx + 1) + i for j in range(ny) for i in range(nx))]
        thrown = range(9 * 7, len(places))
        found = []
        for number in (lambda n: n + 1, lambda n: len(places) - n):
            in_order = sorted((number(n), p) for n, p in enumerate(places))
            quads = sorted((number(e), c) for e, c in enumerate(corners))
            run = self.run_deck(deck(nodes(p for _, p in in_order), shells([[number(n) for n in c] for _, c in quads]), contact(0),
                                     "*INITIAL_VELOCITY_NODE\n", *(card(number(n), 500.0, 300.0, -2000.0) for n in thrown), end=5e-5))
            self.assertIn("they were moved out (IGNORE = 0)", run.stderr)
            found.append([(s["internal energy"], s["sliding interface energy"]) for s in self.glstat()])
        largest = max(i for i, _ in found[0])
        for (i, c), (j, d) in zip(*found):
            self.assertAlmostEqual(i, j, delta=1e-4 * largest)
            self.assertAlmostEqual(c, d, delta=1e-4 * largest)

    def test_sheets_finer_than_thick_that_were_moved_apart_make_no_energy(self):
        """Shells of 2 mm beside some of 8 mm whose sides they do not share, in a contact that sees 8 mm of thickness: nodes are
        moved out of the shells, these are folded up, and nothing moves. Sabotage: the depth of a pair that is another one because
        its foot is; 5e10 of energy were made."""
        places = [(0, 0), (8, 0), (8, 8), (0, 8), (8, -8), (0, -8), (0, 16), (8, 16)]
        number = {p: i + 1 for i, p in enumerate(places)}
        corners = [(1, 2, 3, 4), (6, 5, 2, 1), (4, 3, 8, 7)]
        for y in range(-8, 18, 2):
            for x in range(8, 26, 2):
                number.setdefault((x, y), len(number) + 1)
        corners += [[number[p] for p in ((x, y), (x + 2, y), (x + 2, y + 2), (x, y + 2))] for y in range(-8, 16, 2)
                    for x in range(8, 24, 2)]
        sheet = [nodes((x, y, 0) for x, y in number), shells(corners)]
        for soft in (0, 1):
            run = self.run_deck(deck(*sheet, contact(soft, thickness=8.0)))
            self.assertIn("they were moved out (IGNORE = 0)", run.stderr)
            self.assertLess(max(s["kinetic energy"] + s["internal energy"] for s in self.glstat()), 1e-9)

    def test_shells_are_no_thicker_than_their_sides_allow_in_single_surface_contact(self):
        """Two sheets of 1 mm whose shells are 1 mm wide, 0.7 mm apart: with SSTHK 0 they are 0.4 mm thick for the contact and do not
        touch. Sabotage: no limit; a limit on thicknesses that a card gives; on contacts of two surfaces; the mean side in place of the
        shortest."""
        lower = [(1.0 * i, 1.5 * j, 0.0) for j in range(3) for i in range(3)]
        upper = [(x + 0.5, y + 0.75, 0.7) for x, y, _ in lower]
        corners = [(a, a + 1, a + 4, a + 3) for a in (1, 2, 4, 5)]
        sheets = [nodes(lower + upper), shells(corners), shells([[n + 9 for n in c] for c in corners], pid=2, first=11), part(2)]
        full = "*CONTROL_CONTACT\n" + card(0.1) + card(0, 0, 0, 0, 4.0, 1)
        two = "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n" + card(1, 2, 3, 3) + card(0) + card(1.0, 1.0)
        overlap, thin = "0.3 deep in shell", "8 shells are thinner for this contact than they are, 0.4 of their shortest side (SSTHK = 0): 0.4 in place of 1"
        for blocks, overlaps, told in (([contact(1)], False, True), ([contact(1), full], True, False),
                                       ([contact(1, thickness=1.0)], True, False), ([two], True, False)):
            self.write(deck(*sheets, *blocks))
            said = self.nugget("check", "model.k").stderr
            self.assertEqual(overlap in said, overlaps, said)
            self.assertEqual(thin in said, told, said)


if __name__ == "__main__":
    unittest.main()
