# SPDX-License-Identifier: Apache-2.0
"""Which initial velocity counts, what loads weigh, turn and follow, and solids that are turned inside out."""
import math
import re
import unittest

from few_elements import card, curve, nodes, part
from masses import END, NUMBER, MassesTest, masses
from nugget_command import CommandTest

CENTER = (2.0, 1.0, 0.5)  # of the rigid box of 4 x 2 x 1 of masses.py
# Solids of one element: formulation, corners, places of the nodes.
TETRAHEDRON = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
MIDDLES = [(0.5, 0, 0), (0.5, 0.5, 0), (0, 0.5, 0), (0, 0, 0.5), (0.5, 0, 0.5), (0, 0.5, 0.5)]
WEDGE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0.5, 0, 1), (0.5, 1, 1)]
SOLIDS = [(form, (1, 2, 3, 4, 4, 4, 4, 4), TETRAHEDRON) for form in (1, 4, 10, 13)]
SOLIDS += [(16, tuple(range(1, 11)), TETRAHEDRON + MIDDLES)]
SOLIDS += [(form, (1, 2, 3, 4, 5, 5, 6, 6), WEDGE) for form in (1, 2, -1)]
SOLIDS += [(form, (1, 2, 3, 4, 5, 5, 5, 5), WEDGE[:5]) for form in (1, 2)]


def of_mass(text, mass, velocity=(0.0, 0.0, 0.0)):
    """The same deck, the box with a mass of its own (that of its mesh is 8)."""
    before = part(50, 900, 50)
    assert before in text
    given = card(*CENTER, mass) + card(mass, 0.0, 0.0, mass, 0.0, mass) + card(*velocity, 0.0, 0.0, 0.0)
    return text.replace(before, before.replace("*PART\n", "*PART_INERTIA\n") + given)


class Starts(MassesTest):
    def velocities(self, text):
        self.write(text)
        self.told = self.nugget("run", "model.k", "-o", "out", "--quiet").stderr
        return {node: values[3:] for node, values in self.nodout()[0].items()}

    def test_a_node_comes_before_sets_wherever_it_stands(self):
        cards = "*INITIAL_VELOCITY_NODE\n" + card(1, 5.0) + "*INITIAL_VELOCITY\n" + card(0) + card(1.0)
        found = self.velocities(masses([(0, 0, 0), (1, 0, 0)], cards))
        self.assert_near(found[1] + found[2], [5.0, 0.0, 0.0, 1.0, 0.0, 0.0], 1e-12)

    def test_a_body_comes_before_its_nodes(self):
        cards = "*INITIAL_VELOCITY_RIGID_BODY\n" + card(50, 0.0, 3.0) + "*INITIAL_VELOCITY_NODE\n" + card(2001, 5.0)
        self.assert_near(self.velocities(masses([(0, 0, 0)], cards, box=True))[2001], [0.0, 3.0, 0.0], 1e-12)

    def test_constrained_nodes_of_a_part(self):
        """A nodal rigid body joins a corner of the cube (part 900, 1/8 of its mass of 1) with a mass of 2 that belongs to
        no part: it starts with their momentum, or with IVATN 1 as the part."""
        for ivatn, expected in ((0, 0.125 / 2.125 * 3.0), (1, 3.0)):
            cards = "*SET_NODE_LIST\n" + card(7) + card(1, 1001)
            cards += "*CONSTRAINED_NODAL_RIGID_BODY\n" + card(70, 0, 7)
            cards += "*INITIAL_VELOCITY_GENERATION\n" + card(900, 2, 0.0, 3.0, 0.0, 0.0, ivatn) + card(0, 0, 0, 0, 0, 1)
            found = self.velocities(masses([(100.0, 100.0, 100.0)], cards))
            self.assertAlmostEqual(found[1][0], expected, delta=1e-5)

    def test_bodies_that_irigid_names(self):
        """With a set of another node: by IRIGID a part set, whose centre must lie in the box; -1 all those, -2 all."""
        sets = "*SET_NODE_LIST\n" + card(7) + card(1) + "*SET_PART_LIST\n" + card(8) + card(50)
        sets += "*DEFINE_BOX\n" + card(4, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0)  # holds node 2001, not the centre
        sets += "*DEFINE_BOX\n" + card(5, 1.0, 3.0, -1.0, 3.0, -1.0, 1.0)  # holds the centre, not node 2001
        for box, irigid, taken in ((0, 0, 0), (0, 8, 1), (4, 8, 0), (5, 8, 1), (0, -1, 1), (4, -1, 0), (5, -1, 1),
                                   (4, -2, 1)):
            cards = sets + "*INITIAL_VELOCITY\n" + card(7, 0, box, irigid) + card(1.0)
            found = self.velocities(of_mass(masses([(0, 0, 0)], cards, box=True), 100.0, (0.0, 9.0, 0.0)))
            self.assert_near(found[2001], [1.0, 0.0, 0.0] if taken else [0.0, 9.0, 0.0], 1e-12)

    def test_phase_beside_dynamic_relaxation(self):
        for phase, times in ((0, 1), (1, 0)):
            cards = "*INITIAL_VELOCITY_GENERATION\n" + card(0, 3, 0.0, 1.0) + card(0, 0, 0, 0, 0, 1, phase)
            cards += "*CONTROL_DYNAMIC_RELAXATION\n" + card(250, 0.001, 0.995, 0.0, 0.0, 0, 0.0, 1)
            self.write(masses([(0, 0, 0)], cards))
            told = self.nugget("check", "model.k")
            self.assertEqual((told.stdout + told.stderr).count("the velocity begins after dynamic relaxation"), times)


class Loads(MassesTest):
    def test_a_part_of_given_mass_weighs_that(self):
        """The mesh of the box has a mass of 8, its card says 100: it falls with the acceleration all the same."""
        parts = "*SET_PART_LIST\n" + card(5) + card(50)
        for cards in ("*LOAD_GRAVITY_PART\n" + card(50, 3, 0, 10.0),
                      parts + "*LOAD_BODY_PARTS\n" + card(5) + "*LOAD_BODY_Z\n" + card(1, 10.0),
                      parts + "*LOAD_BODY_GENERALIZED_SET_PART\n" + card(5, 0, 1) + card(0.0, 0.0, 10.0)):
            self.write(of_mass(masses([(0, 0, 0)], cards, box=True), 100.0))
            self.nugget("run", "model.k", "-o", "out", "--quiet")
            self.assert_near(self.nodout()[-1][2001][3:], [0.0, 0.0, -10.0 * END], 1e-5)

    def test_a_follower_needs_three_nodes_that_span_a_plane(self):
        self.write(masses([(0, 0, 0), (1, 0, 0), (2, 0, 0)], "*LOAD_NODE_POINT\n" + card(1, 4, 1, 3.0, 0, 1, 2, 3)))
        told = self.nugget("check", "model.k", expect=1).stderr
        self.assertIn("*LOAD_NODE_POINT m1 = 1: the three nodes are on a line at the start", told)

    def test_a_moment_that_nothing_turns_by_is_told(self):
        cards = "*SET_NODE_LIST\n" + card(3) + card(1, 1001, 2001) + "*LOAD_NODE_SET\n" + card(3, 5, 1, 3.0)
        cards += "*LOAD_NODE_POINT\n" + card(2001, 6, 1, 3.0)
        self.write(masses([(0, 0, 0)], cards, box=True))
        told = self.nugget("check", "model.k").stderr
        self.assertIn("*LOAD_NODE_SET dof = 5: 2 of 3 nodes (the first is 1) have no rotation", told)
        self.assertEqual(told.count("have no rotation"), 1)


    def test_a_curve_over_the_displacement_is_refused(self):
        """LCID below 0 was read as its size: the force over time."""
        for load in ("*LOAD_RIGID_BODY\n" + card(50, 3, -1, 3.0), "*LOAD_NODE_POINT\n" + card(1, 3, -1, 3.0),
                     "*LOAD_BODY_Z\n" + card(-1, 3.0), "*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + card(1, 3, 0, -1)):
            self.write(masses([(0, 0, 0)], load, box=True))
            self.assertIn("lcid = -1: expected 1 or more", self.nugget("check", "model.k", expect=1).stderr)

    def test_a_segment_that_crosses_itself_is_told(self):
        self.write(masses([(0, 0, 0)], "*LOAD_SEGMENT\n" + card(1, 1.0, 0.0, 1001, 1003, 1002, 1004)))
        told = self.nugget("check", "model.k").stderr
        self.assertIn("1 of 1 segments (the first begins with node 1001) have no area: no pressure acts there", told)

    def test_a_pressure_arrives_and_a_follower_turns_with_its_body(self):
        """A pressure of 1 on the bottom of the box, of area 8, from 0.05 on; a force of 80 along the box's own z while it
        spins about x: v_y = -F/(m w) (1 - cos w t), v_z = F/(m w) sin w t."""
        cards = "*SET_SEGMENT\n" + card(5) + card(2001, 2002, 2003, 2004) + "*LOAD_SEGMENT_SET\n" + card(5, 1, 1.0, 0.05)
        self.run_deck([(0, 50, 0)], cards, box=True)
        self.assertAlmostEqual(self.nodout()[-1][2001][5], -8.0 * (END - 0.05) / 8.0, delta=1e-3)
        spin = 30.0
        cards = "*INITIAL_VELOCITY_RIGID_BODY\n" + card(50, 0.0, 0.0, 0.0, spin)
        cards += "*LOAD_RIGID_BODY\n" + card(50, 4, 1, 80.0, 0, 2001, 2002, 2004)
        self.run_deck([(0, 50, 0)], cards, box=True)
        velocity = re.findall(rf"velocities:\s+{NUMBER}\s+({NUMBER})\s+({NUMBER})", self.read("out/rbdout"))[-2]
        scale = 80.0 / (8.0 * spin)
        self.assert_near([float(v) for v in velocity],
                         [-scale * (1.0 - math.cos(spin * END)), scale * math.sin(spin * END)], 1e-3 * scale)
        work, kinetic = self.energies()
        self.assertAlmostEqual(work + 0.5 * 10.0 * spin**2, kinetic, delta=1e-3 * kinetic)


class InsideOut(CommandTest):
    """The top of one solid of height 1, of a wave speed of 37, is driven down at 300, the other nodes are held: after the
    first step it is inside out."""

    def deck(self, form, corners, places, extra):
        top = [i + 1 for i, place in enumerate(places) if place[2] > 0.4]
        held = [i + 1 for i in range(len(places)) if i + 1 not in top]
        line = "" if len(corners) == 8 else "\n"
        text = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(0.02) + "*DATABASE_GLSTAT\n" + card(0.01) + nodes(places)
        text += "*ELEMENT_SOLID\n" + f"{1:8}{1:8}{line}" + "".join(f"{n:8}" for n in corners) + "\n"
        text += part(1) + "*SECTION_SOLID\n" + card(1, form) + "*MAT_ELASTIC\n" + card(1, 0.001, 1.0, 0.3)
        text += "*SET_NODE_LIST\n" + card(1) + card(*held) + "*SET_NODE_LIST\n" + card(2) + card(*top)
        text += "*BOUNDARY_SPC_SET\n" + card(1, 0, 1, 1, 1, 1, 1, 1) + curve(1, (0, 1), (1, 1))
        return text + "*BOUNDARY_PRESCRIBED_MOTION_SET\n" + card(2, 3, 0, 1, -300.0) + extra + "*END\n"

    def test_what_is_inside_out_is_deleted_before_it_acts(self):
        """External work is what set the nodes moving; nothing is stored or eroded."""
        for form, corners, places in SOLIDS:
            with self.subTest(form=form, nodes=len(places)):
                self.write(self.deck(form, corners, places, "*CONTROL_TIMESTEP\n" + card(0, 0.9, 0, 0, 0, 0, 1)))
                self.nugget("run", "model.k", "-o", ".", "--threads", 1)
                self.assertIn("solid 1 of part 1 is deleted, its volume is negative", self.read("run.log"))
                last = self.glstat()[-1]
                self.assertAlmostEqual(last["total energy / initial energy"], 1.0, delta=1e-6)
                for name in ("internal energy", "eroded internal energy"):
                    self.assertEqual(last[name], 0.0)

    def test_or_ends_the_run(self):
        for form, corners, places in SOLIDS:
            with self.subTest(form=form, nodes=len(places)):
                self.write(self.deck(form, corners, places, ""))
                told = self.nugget("run", "model.k", "-o", ".", "--threads", 1, expect=3).stderr
                self.assertIn("negative volume in solid 1 of part 1", told)
                self.assertAlmostEqual(self.glstat()[-1]["total energy / initial energy"], 1.0, delta=1e-6)

    def test_mass_scaling_leaves_it_alone(self):
        """DT2MS gives no mass to what has no step: that of the start stays, and the last state can be written."""
        self.write(self.deck(*SOLIDS[4], "*CONTROL_TIMESTEP\n" + card(0, 0.9, 0, 0, -0.02)))
        self.nugget("run", "model.k", "-o", ".", "--threads", 1, expect=3)
        first, last = self.glstat()[0], self.glstat()[-1]
        self.assertAlmostEqual(last["time"], 0.9 * 0.02, delta=1e-6)
        self.assertEqual(last["added mass"], first["added mass"])
        self.assertAlmostEqual(last["total energy / initial energy"], 1.0, delta=1e-6)

    def test_neighbours_by_nodal_pressure_go_on(self):
        """ELFORM 13: of two tetrahedra on one face that is held, one is driven inside out; the other, at rest, stays so."""
        places = TETRAHEDRON + [(0, 0, -1)]
        extra = f"*ELEMENT_SOLID\n{2:8}{1:8}" + "".join(f"{n:8}" for n in (1, 3, 2, 5, 5, 5, 5, 5)) + "\n"
        extra += "*CONTROL_TIMESTEP\n" + card(0, 0.9, 0, 0, 0, 0, 1)
        self.write(self.deck(13, SOLIDS[3][1], places, extra))
        self.nugget("run", "model.k", "-o", ".", "--threads", 1)
        self.assertIn("solid 1 of part 1 is deleted, its volume is negative", self.read("run.log"))
        self.assertAlmostEqual(self.glstat()[-1]["internal energy"], 0.0, delta=1e-12)


if __name__ == "__main__":
    unittest.main()
