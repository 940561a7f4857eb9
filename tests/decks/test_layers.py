# SPDX-License-Identifier: Apache-2.0
"""A laminated windshield, glued to a frame and hit by a ball: layers with laws of their own, from the deck to the results."""
import math
import unittest

import lsda
from few_elements import card, nodes
from nugget_command import CommandTest

GLASS, FILM = 2.1, 0.76  # mm
NX, NY, SIZE = 16, 12, 25.0
MATERIALS = ("*MAT_ELASTIC\n" + card(1, 2.5e-9, 70000.0, 0.23) + "*MAT_ADD_EROSION\n" + card(1, "", "", "", "", "", -100) + card("", 60.0) + "\n" * 3
             + "*MAT_PIECEWISE_LINEAR_PLASTICITY\n" + card(2, 1.1e-9, 300.0, 0.45, 15.0, 10.0, 1.5) + "\n" * 3)


def pane(elform=16, contact=False):
    """Glass, film, glass, each glass as two layers."""
    return (f"*PART_COMPOSITE{'_CONTACT' * contact}\nwindshield\n" + card(1, elform, 0.8333) + card(*[""] * 6, 1.0) * contact
            + card(1, GLASS / 2, "", "", 1, GLASS / 2) + card(2, FILM, "", "", 1, GLASS / 2) + card(1, GLASS / 2))


def windshield(layers=pane(), end=3e-3, speed=6e3, control="", extra=""):
    """The pane over a steel frame that holds it by a tied contact of its border; a rigid ball of 4 kg comes from above. mm, t, s."""
    places = [(i * SIZE, j * SIZE, 0.0) for j in range(NY + 1) for i in range(NX + 1)]
    at = {(i, j): 1 + j * (NX + 1) + i for j in range(NY + 1) for i in range(NX + 1)}
    shells = [(1, [at[i, j], at[i + 1, j], at[i + 1, j + 1], at[i, j + 1]]) for j in range(NY) for i in range(NX)]
    # The frame: a strip of one row under the border, its own nodes 3.5 mm lower.
    frame = {}
    border = [(i, j) for j in range(NY) for i in range(NX) if i in (0, NX - 1) or j in (0, NY - 1)]
    for i, j in border:
        for x, y in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
            if (x, y) not in frame:
                places.append((x * SIZE, y * SIZE, -3.5))
                frame[x, y] = len(places)
        shells.append((2, [frame[i, j], frame[i + 1, j], frame[i + 1, j + 1], frame[i, j + 1]]))
    # The ball: the lower half of a sphere of 80 mm.
    radius, height, rings = 80.0, 80.0 + 4.0, 6
    middle = (0.5 * NX * SIZE, 0.5 * NY * SIZE)
    places.append((*middle, height - radius))
    pole, ball = len(places), {}
    for k in range(1, rings + 1):
        angle = 0.5 * math.pi * k / rings
        for m in range(16):
            turn = 2.0 * math.pi * m / 16
            places.append((middle[0] + radius * math.sin(angle) * math.cos(turn), middle[1] + radius * math.sin(angle) * math.sin(turn),
                           height - radius * math.cos(angle)))
            ball[k, m] = len(places)
    for m in range(16):
        shells.append((3, [pole, ball[1, (m + 1) % 16], ball[1, m], ball[1, m]]))
        shells += [(3, [ball[k, m], ball[k, (m + 1) % 16], ball[k + 1, (m + 1) % 16], ball[k + 1, m]]) for k in range(1, rings)]
    area = 2.0 * math.pi * radius * radius
    held = "".join(card(n, 0, 1, 1, 1, 1, 1, 1) for (x, y), n in frame.items() if x in (0, NX) or y in (0, NY))
    border_nodes = [at[x, y] for x, y in frame]
    node_set = "*SET_NODE_LIST\n" + card(5) + "".join(card(*border_nodes[k:k + 8]) for k in range(0, len(border_nodes), 8))
    return ("*KEYWORD\n" + MATERIALS + layers + "*MAT_ELASTIC\n" + card(3, 7.85e-9, 210000.0, 0.3)
            + "*MAT_RIGID\n" + card(4, f"{4e-3 / area:.4e}", 210000.0, 0.3) + card(1.0, 4, 7) + "\n"
            + "*SECTION_SHELL\n" + card(2, 16, 0.8333, 3) + card(1.5, 1.5, 1.5, 1.5) + "*SECTION_SHELL\n" + card(3, 2) + card(1, 1, 1, 1)
            + "*PART\nframe\n" + card(2, 2, 3) + "*PART\nball\n" + card(3, 3, 4)
            + node_set + "*CONTACT_TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET\n" + card(5, 2, 4, 3) + "\n\n"
            + "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n" + card(3, 1, 3, 3) + "\n\n"
            + "*BOUNDARY_SPC_NODE\n" + held + "*INITIAL_VELOCITY_RIGID_BODY\n" + card(3, 0.0, 0.0, -speed)
            + "*CONTROL_TERMINATION\n" + card(end) + "*CONTROL_ENERGY\n" + card(2, 2, 2, 2) + control
            + "*DATABASE_GLSTAT\n" + card(f"{end / 50.0:.3e}", 3) + "*DATABASE_ELOUT\n" + card(f"{end / 50.0:.3e}", 2)
            + "*DATABASE_HISTORY_SHELL\n" + card(NX // 2 + NX * (NY // 2)) + "*DATABASE_EXTENT_BINARY\n" + card(0, 0, 5) + "\n"
            + "*DATABASE_BINARY_D3PLOT\n" + card(f"{end / 4.0:.3e}") + extra + nodes(places)
            + "*ELEMENT_SHELL\n" + "".join("".join(f"{n:8}" for n in (e + 1, part, *of)) + "\n" for e, (part, of) in enumerate(shells)) + "*END\n")


class Windshield(CommandTest):
    def hit(self, *arguments, **options):
        self.write(windshield(*arguments, **options))
        self.nugget("run", "model.k", "--quiet")
        return self.glstat()

    def test_is_hit(self):
        """The glass breaks under the ball, the film holds: no energy from nothing, and all layers in the results."""
        for elform in (2, 16):
            states = self.hit(pane(elform))
            for state in states:
                self.assertLess(abs(state["total energy / initial energy"] - 1.0), 0.02, (elform, state["time"]))
            self.assertLess(states[-1]["kinetic energy"], 0.95 * states[0]["kinetic energy"])
            self.assertIn("*PART_COMPOSITE of 1 1 2 1 1", self.read("run.log"))
            shell = lsda.states(lsda.read(self.folder / "binout0000"), "elout/shell")[-1]
            stress = shell["sig_xx"]
            self.assertEqual(len(stress), 5)
            self.assertEqual(stress[:2], [0.0] * 2, "the lower glass is broken under the ball")
            self.assertNotEqual(stress[2], 0.0, "the film bears")

    def test_ends_the_same_with_any_threads(self):
        self.write(windshield(end=6e-4))
        for threads in (1, 2):
            self.nugget("run", "model.k", "-o", f"t{threads}", "-j", threads, "--quiet")
        for name in ("glstat", "binout0000"):
            one, two = ((self.folder / f"t{n}" / name).read_bytes() for n in (1, 2))
            self.assertTrue(one == two, name)

    def test_thickness_and_mass_come_with_an_include_in_metres(self):
        """The same pane written in m, kg, s and included with its units: the same frequencies."""
        def strip(layers, material, size, part):
            places = [(i * size, j * size, 0.0) for j in range(3) for i in range(21)]
            shells = "".join("".join(f"{n:8}" for n in (20 * j + i + 1, part, *(1 + i + 21 * j + k for k in (0, 1, 22, 21)))) + "\n"
                             for j in range(2) for i in range(20))
            held = "".join(card(1 + 21 * j, 0, 1, 1, 1, 1, 1, 1) for j in range(3))
            return material + layers + nodes(places) + "*ELEMENT_SHELL\n" + shells + "*BOUNDARY_SPC_NODE\n" + held

        control = "*CONTROL_IMPLICIT_GENERAL\n" + card(1, 1) + "*CONTROL_IMPLICIT_EIGENVALUE\n" + card(3)
        def frequencies(text):
            self.write(text)
            self.nugget("modes", "model.k", "--quiet")
            return [float(line.split()[3]) for line in self.read("eigout").splitlines() if len(line.split()) == 5 and line.split()[0].isdigit()][:3]

        layers = "*PART_COMPOSITE\nstrip\n" + card(1, 16, 0.8333) + "{}"
        ours = strip(layers.format(card(1, 1.0, "", "", 2, 0.5) + card(1, 2.0)),
                     "*MAT_ELASTIC\n" + card(1, 2.5e-9, 70000.0, 0.23) + "*MAT_ELASTIC\n" + card(2, 1.1e-9, 300.0, 0.4), 10.0, 1)
        metres = strip(layers.format(card(1, 0.001, "", "", 2, 0.0005) + card(1, 0.002)),
                       "*MAT_ELASTIC\n" + card(1, 2500.0, "7e10", 0.23) + "*MAT_ELASTIC\n" + card(2, 1100.0, "3e8", 0.4), 0.01, 1)
        here = frequencies("*KEYWORD\n" + control + ours + "*END\n")
        self.write("*KEYWORD\n" + metres + "*END\n", "inner.k")
        there = frequencies("*KEYWORD\n" + control + "*INCLUDE_TRANSFORM\ninner.k\n" + card(100, 100, 100, 100) + "\n" + card(1e-3, 1.0, 1e3) + "\n" * 2
                            + "*END\n")
        self.assertEqual(len(here), 3)
        for one, two in zip(here, there):
            self.assertAlmostEqual(two / one, 1.0, 6)

    def test_check_tells(self):
        told = self.nugget("check", self.write(windshield(pane().replace(card(2, FILM, "", "", 1, GLASS / 2), card(2, "", "", "", 1, GLASS / 2)))), expect=1)
        self.assertIn("*PART_COMPOSITE thick1 = (blank): a layer without a thickness", told.stderr)
        told = self.nugget("check", self.write(windshield(pane().replace(card(2, FILM, "", "", 1, GLASS / 2), card(8, FILM, 30.0, "", 4, GLASS / 2)))), expect=1)
        self.assertIn("material 8 is not defined", told.stderr)
        self.assertIn("*MAT_RIGID is not a law of a shell's layers", told.stderr)


if __name__ == "__main__":
    unittest.main()
