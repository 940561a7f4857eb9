# SPDX-License-Identifier: Apache-2.0
"""Bodies and nodes that several cards hold and drive in directions that are askew to each other, and bodies whose inertia couples what is
driven with what is free."""
import math
import unittest

import lsda
from nugget_command import CommandTest

HEAD = "*KEYWORD\n*CONTROL_TERMINATION\n2e-3\n*CONTROL_ENERGY\n2,2,2,2\n*CONTROL_TIMESTEP\n0,0,0,0,0,99\n*DEFINE_CURVE\n99\n0,2e-6\n1,2e-6\n"
HEAD += "".join(f"*DATABASE_{name}\n1e-4,2\n" for name in ("GLSTAT", "NODOUT", "SPCFORC"))
CURVES = "*DEFINE_CURVE\n1\n0,0\n1e-3,400\n1,400\n*DEFINE_CURVE\n2\n0,0\n1,0\n*DEFINE_CURVE\n3\n0,100\n1,100\n*DEFINE_CURVE\n4\n0,-60\n1,-60\n"

# A brick whose axes of inertia are those of no direction that is driven.
CORNERS = [(0, 0, 0), (12, 2, 1), (11, 8, 3), (-1, 6, 2), (1, -1, 5), (13, 1, 6), (12, 7, 8), (0, 5, 7)]
BODY = "*SECTION_SOLID\n1,1\n*PART\nbody\n1,1,1\n*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n*NODE\n" + "".join(
    f"{i + 1},{x},{y},{z}\n" for i, (x, y, z) in enumerate(CORNERS)) + "*DATABASE_HISTORY_NODE\n1,7\n"
RIGID = "*MAT_RIGID\n1,7.85e-9,210000,0.3\n{},\n\n"


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


class Driven(CommandTest):
    def run_deck(self, text):
        self.write(HEAD + CURVES + text + "*END\n")
        self.nugget("run", "model.k", "--quiet", "-j1")
        found = lsda.read(self.folder / "binout0000")
        return lsda.states(found, "glstat"), lsda.states(found, "nodout")

    def velocity(self, state, i):
        return [state[f"{a}_velocity"][i] for a in "xyz"]

    def test_a_rotation_that_is_driven_at_zero_is_one_that_is_held(self):
        """CON2 3 holds the rotation about z by a moment about z, and so does a motion of speed 0: the same motion of a body that turns about x
        and is free to, whose energy stays. Sabotage: the motion sets the component of the spin and leaves the two others."""
        spin = "*INITIAL_VELOCITY_RIGID_BODY\n1,0,0,0,300,100,0\n"
        energies, held = self.run_deck(RIGID.format("1,0,3") + BODY + spin)
        _, driven = self.run_deck(RIGID.format("") + BODY + spin + "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n1,7,0,2\n")
        kinetic = [state["kinetic_energy"][0] for state in energies]
        self.assertAlmostEqual(kinetic[-1] / kinetic[1], 1.0, 6)
        size = max(abs(x) for state in held for x in self.velocity(state, 1))
        for a, b in zip(held[1:], driven[1:]):
            for x, y in zip(self.velocity(a, 1), self.velocity(b, 1)):
                self.assertAlmostEqual(x / size, y / size, 9)

    def test_the_work_of_a_driven_rotation(self):
        """What drives a body about a vector does the work that the body has as kinetic energy, as it does no other."""
        vector = "*DEFINE_VECTOR\n1,0,0,0,0.3,0.8,-0.5\n"
        for dof in (8, -8, 5):
            with self.subTest(dof=dof):
                energies, _ = self.run_deck(RIGID.format("") + BODY + vector + f"*BOUNDARY_PRESCRIBED_MOTION_RIGID\n1,{dof},0,1,1,1\n")
                for state in energies[2:]:
                    self.assertAlmostEqual(state["external_work"][0] / state["kinetic_energy"][0], 1.0, 4)

    def test_a_motion_against_constraints_of_the_body_is_one_error(self):
        """CON2 holds about y and z, both of which it drives about in part: said once."""
        vector = "*DEFINE_VECTOR\n1,0,0,0,0.3,0.8,-0.5\n"
        self.write(HEAD + CURVES + RIGID.format("1,0,5") + BODY + vector + "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n1,8,0,1,1,1\n*END\n")
        said = self.nugget("check", "model.k", expect=1).stderr
        self.assertEqual(said.count("rigid body 1 is held in the direction in which this drives it in part"), 1, said)

    def test_two_translations_of_a_body_askew_to_each_other(self):
        """Both speeds are met, and the third component stays free. Sabotage: one after the other."""
        vector = "*DEFINE_VECTOR\n1,0,0,0,3,4,0\n*INITIAL_VELOCITY_RIGID_BODY\n1,0,0,50\n"
        drives = "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n1,1,0,3\n1,4,0,4,1,1\n"
        _, states = self.run_deck(RIGID.format("") + BODY + vector + drives)
        for state in states[1:-1]:
            v = self.velocity(state, 0)
            self.assertAlmostEqual(v[0], 100, 6)
            self.assertAlmostEqual(dot(v, (0.6, 0.8, 0)), -60, 6)
            self.assertAlmostEqual(v[2], 50, 6)

    def test_two_motions_of_a_body_in_one_direction(self):
        """The last card counts, and that is said."""
        energies, states = self.run_deck(RIGID.format("") + BODY + "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n1,1,0,4\n1,1,0,3\n")
        self.assertIn("rigid body 1 is driven by two cards in one direction at one time: the last one counts", self.read("run.log"))
        for state in states[1:-1]:
            self.assertAlmostEqual(self.velocity(state, 0)[0], 100, 6)
        for state in energies[1:]:
            self.assertAlmostEqual(state["external_work"][0] / state["kinetic_energy"][0], 1.0, 6)

    # A mass of 1e-6 t on a spring of 1000 N/mm that is held at its other end, held in the directions of a system that is askew.
    MASS = ("*NODE\n1,0,0,0\n2,10,0,0\n*ELEMENT_MASS\n7,1,1e-6\n8,2,1e-6\n*MAT_SPRING_ELASTIC\n1,1000\n*SECTION_DISCRETE\n1,0\n\n*PART\nspring\n1,1,1\n"
            "*ELEMENT_DISCRETE\n1,1,1,2\n*BOUNDARY_SPC_NODE\n2,0,1,1,1\n*DATABASE_HISTORY_NODE\n1\n*DEFINE_COORDINATE_VECTOR\n1,0.8,0.6,0.1,-0.5,0.9,0.2\n"
            "*DEFINE_VECTOR\n1,0,0,0,0.3,0.8,-0.5\n*DEFINE_VECTOR\n2,0,0,0,0.5,-0.2,0.5\n")

    def energies_close(self, states):
        for state in states[1:]:
            total = state["kinetic_energy"][0] + state["internal_energy"][0]
            self.assertAlmostEqual(state["external_work"][0] / total, 1.0, delta=0.02)

    def test_a_motion_of_a_node_that_is_held_all_round(self):
        """The node follows the motion, and the motion and the support together do the work of that. Sabotage: the support stops the node in
        each step before the motion starts it anew, and the motion is booked for that."""
        along = [x / math.sqrt(0.98) for x in (0.3, 0.8, -0.5)]
        for dof in (4, -4):
            with self.subTest(dof=dof):
                energies, states = self.run_deck(self.MASS + "*BOUNDARY_SPC_NODE\n1,1,1,1,1\n" +
                                                 f"*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,{dof},0,1,1,1\n")
                self.energies_close(energies)
                for state in states[2:-1]:
                    v = self.velocity(state, 0)
                    for x, y in zip(v, along):
                        self.assertAlmostEqual(x / dot(v, along), y, 9)

    def test_two_motions_of_a_node_beside_an_oblique_support(self):
        """Two speeds and a support in a third direction, none at right angles: all three are met."""
        energies, states = self.run_deck(self.MASS + "*BOUNDARY_SPC_NODE\n1,1,1\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,4,0,3,1,1\n1,4,0,4,1,2\n")
        unit = [[x / math.sqrt(dot(a, a)) for x in a] for a in ((0.3, 0.8, -0.5), (0.5, -0.2, 0.5), (0.8, 0.6, 0.1))]
        for state in states[1:-1]:
            v = self.velocity(state, 0)
            for along, speed in zip(unit, (100, -60, 0)):
                self.assertAlmostEqual(dot(v, along), speed, 6)
        self.energies_close(energies)

    def test_a_rivet_beside_two_oblique_supports(self):
        """One end slides on the line that two supports, askew to each other, leave it; at the start the other one parts from it, which the
        rivet stops. It keeps its length, and the energy is accounted for. Sabotage: the directions are taken out as they are, so that the
        rivet expects another motion of that end than it gets, and pulls again in the next step."""
        axes = "*DEFINE_COORDINATE_VECTOR\n11,1,0,0,0,1,0\n*DEFINE_COORDINATE_VECTOR\n12,0.6,0.8,0.3,0,0,1\n"
        cards = ("*ELEMENT_MASS\n1,1,3e-6\n2,2,2e-6\n*CONSTRAINED_RIVET\n2,1\n*BOUNDARY_SPC_NODE\n2,11,1\n2,12,1\n"
                 "*NODE\n1,20,5,0\n2,10,0,0\n*DATABASE_HISTORY_NODE\n1,2\n*INITIAL_VELOCITY_NODE\n1,100,300,900\n")
        energies, states = self.run_deck(axes + cards)
        start = energies[0]["kinetic_energy"][0]
        self.assertAlmostEqual(start, 0.5 * 3e-6 * (100.0**2 + 300.0**2 + 900.0**2), 9)
        for state in energies:
            self.assertAlmostEqual(state["total_energy"][0] / start, 1.0, delta=5e-4)
        for state in states:
            line = [state[f"{a}_coordinate"][1] - state[f"{a}_coordinate"][0] for a in "xyz"]
            self.assertAlmostEqual(math.sqrt(dot(line, line)), math.sqrt(125.0), 6)
            self.assertAlmostEqual(state["x_coordinate"][1], 10.0, 9)


if __name__ == "__main__":
    unittest.main()
