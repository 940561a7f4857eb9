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

    def test_masses_at_the_nodes_of_parts_weigh_with_them(self):
        """Of the box, at a corner and beside it on a node that it takes along, and of the cube. Sabotage: elements alone weigh, and the box with
        its masses fell with 0.8 of the acceleration. A mass that belongs to no part stays, and so do the masses of parts that are not named."""
        for parts in ((50,), (900,), (50, 900)):
            sets = "*SET_PART_LIST\n" + card(5) + card(*parts)
            more = nodes([(9, 1, 0.5)], 3001) + "*CONSTRAINED_EXTRA_NODES_NODE\n" + card(50, 3001)
            more += "*ELEMENT_MASS\n" + "".join(f"{n:8}{n:8}{1.0:16}\n" for n in (2003, 3001, 1002)) + "*DATABASE_MATSUM\n" + card(0.02, 1)
            for cards in ("".join("*LOAD_GRAVITY_PART\n" + card(part_id, 3, 0, 10.0) for part_id in parts),
                          sets + "*LOAD_BODY_PARTS\n" + card(5) + "*LOAD_BODY_Z\n" + card(1, 10.0),
                          sets + "*LOAD_BODY_GENERALIZED_SET_PART\n" + card(5, 0, 1) + card(0.0, 0.0, 10.0)):
                self.write(masses([(0, 0, 0)], more + cards, box=True))
                self.nugget("run", "model.k", "-o", "out", "--quiet")
                last = self.glstat("out/glstat")[-1]
                falling = (8.0 + 2.0) * (50 in parts) + (1.0 + 1.0) * (900 in parts)
                self.assertAlmostEqual(last["external work"], 0.5 * falling * (10.0 * END) ** 2, delta=2e-3 * falling)
                self.assert_near(self.nodout()[-1][1][3:], [0.0, 0.0, 0.0], 1e-12)

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

    def test_rotations_that_nodes_do_not_have_are_told(self):
        """A rotation of nodes of bricks, a moment at an end of a spring. Sabotage: motions are not looked at, a spring turns its nodes."""
        spring = "*SECTION_DISCRETE\n" + card(60, 0) + "\n*MAT_SPRING_ELASTIC\n" + card(60, 1.0) + part(60, 60, 60)
        spring += f"*ELEMENT_DISCRETE\n{60:8}{60:8}{1:8}{2:8}\n*DAMPING_PART_MASS\n" + card(60, 1)
        cards = "*SET_NODE_LIST\n" + card(3) + card(1001, 1002) + "*BOUNDARY_PRESCRIBED_MOTION_SET\n" + card(3, 5, 0, 1, 3.0)
        self.write(masses([(0, 0, 0), (1, 0, 0)], spring + cards + "*LOAD_NODE_POINT\n" + card(1, 6, 1, 3.0)))
        told = self.nugget("check", "model.k").stderr
        self.assertIn("*BOUNDARY_PRESCRIBED_MOTION_SET dof = 5: 2 of 2 nodes (the first is 1001) have no rotation: the motion has no effect there", told)
        self.assertIn("*LOAD_NODE_POINT dof = 6: 1 of 1 nodes (the first is 1) have no rotation: the moment has no effect there", told)
        self.assertIn("*DAMPING_PART_MASS pid = 60: part 60 is of springs or dampers, which have no mass: this does not damp it", told)
        turning = spring.replace(card(60, 0), card(60, 1))
        self.write(masses([(0, 0, 0), (1, 0, 0)], turning + "*LOAD_NODE_POINT\n" + card(1, 6, 1, 3.0) + "*ELEMENT_INERTIA\n"
                          + "".join(f"{n + 70:8}{n:8}\n" + card(1.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0) for n in (1, 2))))
        self.assertNotIn("have no rotation", self.nugget("check", "model.k").stderr)


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


class Deletion(CommandTest):
    """A brick that is squeezed flat in 0.1, and shells of which a corner each is driven across a diagonal in turn."""

    def run_of(self, cards, elements, end, expect=0):
        text = "*KEYWORD\n" + curve(1, (0, -10), (1, -10)) + "*MAT_ELASTIC\n" + card(1, 1.0, 1.0e6, 0.0)
        self.write(text + cards + elements + "*END\n")
        self.nugget("run", "model.k", "-o", "out", "--quiet", expect=expect)
        return self.json("out/summary.json")["message"], self.read("out/run.log")

    def squeezed(self, cards, dtmin=0.0, expect=0):
        brick = nodes([(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))])
        brick += f"*ELEMENT_SOLID\n{1:8}{1:8}" + "".join(f"{n:8}" for n in range(1, 9)) + "\n" + part(1)
        brick += "*SECTION_SOLID\n" + card(1, 1) + "*SET_NODE_LIST\n" + card(1) + card(1, 2, 3, 4)
        brick += "*SET_NODE_LIST\n" + card(2) + card(5, 6, 7, 8) + "*BOUNDARY_SPC_SET\n" + card(1, 0, 1, 1, 1)
        brick += card(2, 0, 1, 1) + "*BOUNDARY_PRESCRIBED_MOTION_SET\n" + card(2, 3, 0, 1)
        # A mass that goes on when the brick has gone.
        brick += nodes([(9, 9, 9)], 9) + f"*ELEMENT_MASS\n{1:8}{9:8}{1.0:16}\n"
        brick += "*CONTROL_BULK_VISCOSITY\n" + card(1e-9, 1e-9)
        return self.run_of(cards, brick + "*CONTROL_TERMINATION\n" + card(0.12, 0, dtmin), 0.12, expect)

    def test_a_brick_squeezed_flat_is_deleted_before_time_stands_still(self):
        """Its step goes with its height, so its volume never becomes negative. Without DTMIN it goes when nothing is left of
        the step. Sabotage: no limit without DTMIN (the run ends in error)."""
        step = "*CONTROL_TIMESTEP\n" + card(0.0, 0.5, 0, 0.0, 0.0, 0)[:-1]
        message, _ = self.squeezed(step + "\n", expect=3)
        self.assertIn("too small to go on", message)
        message, log = self.squeezed(step + card(1))
        self.assertRegex(log, r"time 0\.09999\d*: solid 1 of part 1 is deleted, its step fell to nothing")

    def test_psfail_lets_solids_go_below_dtmin(self):
        """Documented: the criterion of the step is for all solids, that of the volume for the parts of PSFAIL. The step goes
        with the height: at 0.3 of it, time 0.07. Sabotage: ERODE alone counts (the run ends in error)."""
        cards = "*CONTROL_TIMESTEP\n" + card(0.0, 0.1) + "*SET_PART_LIST\n" + card(7) + card(1)
        _, log = self.squeezed(cards + "*CONTROL_SOLID\n" + card(0, 0, 0, 0, 7), dtmin=0.3)
        self.assertRegex(log, r"time 0\.070\d*: solid 1 of part 1 is deleted, its step fell below DTMIN")

    def test_a_weld_that_erosion_takes_has_not_failed_by_strain(self):
        """A weld beam that is pressed together, elastic or with EFAIL. Sabotage: dead elements mean plastic strain."""
        beam = nodes([(0, 0, 0), (0, 0, 1), (9, 9, 9)]) + f"*ELEMENT_BEAM\n{1:8}{1:8}{1:8}{2:8}{0:8}\n" + part(1, 1, 2)
        beam += "*SECTION_BEAM\n" + card(1, 9, 1.0, 2, 1) + card(1.0, 1.0) + f"*ELEMENT_MASS\n{1:8}{3:8}{1.0:16}\n"
        beam += "*BOUNDARY_SPC_NODE\n" + card(1, 0, *6 * [1]) + card(2, 0, 1, 1, 0, 1, 1, 1)
        beam += "*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + card(2, 3, 0, 1) + "*CONTROL_TERMINATION\n" + card(0.08, 0, 0.5)
        beam += "*CONTROL_TIMESTEP\n" + card(0.0, 0.5, 0, 0.0, 0.0, 0, 100)
        for stress, strain, mode in (("1e9", 0.0, "distortion"), ("1e9", 0.05, "distortion"), ("1e3", 0.05, "plastic strain")):
            law = "*MAT_SPOTWELD\n" + card(2, 1.0, 1.0e6, 0.0, stress, 0.0) + card(strain)
            self.run_of(law, beam, 0.08)
            weld = self.json("out/summary.json")["weld"][0]
            self.assertEqual((weld["failed"], weld["failure_mode"]), (True, mode), (stress, strain))

    def crossed(self, card_4, expect=0):
        """A corner moves by (-5, -5) s along the diagonal of the unit shell, s = 1, 0.9, 0.8: it is on the other diagonal at
        0.05, 0.0556 and 0.0625."""
        text = "*CONTROL_TERMINATION\n" + card(0.07) + "*CONTROL_TIMESTEP\n" + card(0.0, 0.2)
        text += "*SECTION_SHELL\n" + card(1, 16 if card_4.startswith(10 * " ") else 2) + card(*4 * [0.1]) + part(1)
        text += "*CONTROL_SHELL\n" + card(20.0) + "\n\n" + card_4
        for k in range(3):
            first = 4 * k + 1
            text += nodes([(0, 3 * k, 0), (1, 3 * k, 0), (1, 3 * k + 1, 0), (0, 3 * k + 1, 0)], first)
            text += f"*ELEMENT_SHELL\n{k + 1:8}{1:8}" + "".join(f"{first + i:8}" for i in range(4)) + "\n"
            text += "*BOUNDARY_SPC_NODE\n" + "".join(card(first + i, 0, *6 * [1]) for i in (0, 1, 3))
            text += card(first + 2, 0, 0, 0, 1, 1, 1, 1) + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n"
            text += "".join(card(first + 2, dof, 0, 1, 1.0 - 0.1 * k) for dof in (1, 2))
        return self.run_of("", text, 0.07, expect)

    def test_so_many_failed_shells_end_the_run(self):
        """Documented: NFAIL1, NFAIL4 above 2 delete, and end the run when so many have failed. Sabotage: 3 as 1."""
        for name, field in (("NFAIL1", lambda n: card(n)), ("NFAIL4", lambda n: card("", n))):
            message, log = self.crossed(field(3), expect=3)
            self.assertIn(f"3 shells have failed by time 0.0625", message)
            self.assertIn(f"{name} = 3 ends the run", message)
            self.assertEqual(log.count("is deleted, a corner of it has turned inside out"), 3)
            for other in (1, 4):
                message, log = self.crossed(field(other))
                self.assertEqual(message, "")
                self.assertEqual(log.count("is deleted, a corner of it has turned inside out"), 3)

    def test_kinds_to_erode(self):
        for kinds, refused in ((0, False), (11, False), (101, False), (2, True), (7, True), (20, True), (1111, True)):
            self.write("*KEYWORD\n*CONTROL_TIMESTEP\n" + card(0.0, 0.9, 0, 0.0, 0.0, 0, kinds) + "*END\n")
            told = self.nugget("check", "model.k", expect=1).stderr
            self.assertEqual(f"erode = {kinds}: expected 1 (solids), 10 (shells)" in told, refused, told)


if __name__ == "__main__":
    unittest.main()
