# SPDX-License-Identifier: Apache-2.0
"""Bodies held, merged or sharing nodes; dampers beyond their curve; relaxation by DRTERM; bricks turned inside out."""
import math
import re
import unittest

from few_elements import CORNERS, SOLID, card, curve, nodes, part
from nugget_command import CommandTest

RUN = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(0.01) + "*DATABASE_GLSTAT\n" + card(0.01)
STEP = "*CONTROL_TIMESTEP\n" + card(0.0, 0.9, 0, 0.0, 0.0, 9) + curve(9, (0, 1e-4), (10, 1e-4))
FALL = "*LOAD_BODY_Z\n" + card(1, 100.0) + curve(1, (0, 1.0), (10, 1.0))
MERGE = "*CONSTRAINED_RIGID_BODIES\n" + card(1, 2)


def cube(body, at, first=None):
    """A cube of 1 in its own part, with nodes 8 (body - 1) + 1 ... where no others are given."""
    own = range(8 * body - 7, 8 * body + 1) if first is None else first
    text = "" if first else nodes([(at + x, y, z) for x, y, z in CORNERS], 8 * body - 7)
    return text + "*ELEMENT_SOLID\n" + "".join(f"{i:8}" for i in (body, body, *own)) + "\n"


def rigid(material, cmo=0, con1=0, con2=0):
    return "*MAT_RIGID\n" + card(material, 1.0, 2e5, 0.3) + card(float(cmo), con1, con2) + "\n"


def inertia(body, *velocity):
    return ("*PART_INERTIA\nbody\n" + card(body, 1, body) + card(0.5, 0.5, 0.5, 3.0) +
            card(2.0, 0.0, 0.0, 3.0, 0.0, 4.0) + card(*velocity))


class RigidBodies(CommandTest):
    def run_deck(self, *texts):
        self.write(RUN + "".join(texts) + "*END\n")
        return self.nugget("run", "model.k", "-o", ".", "--threads", 1).stderr

    def warnings(self):
        return [f["text"] for f in self.json("findings.json") if f["severity"] == "warning"]

    def test_a_held_body_does_not_start_with_what_it_is_held_against(self):
        start = "*INITIAL_VELOCITY_RIGID_BODY\n" + card(1, 7.0, 8.0, 0.0, 0.0, 2.0, 3.0)
        said = self.run_deck(STEP, part(1), SOLID, rigid(1, 1, 1, 2), cube(1, 0.0), start)
        first, last = self.glstat()[0], self.glstat()[-1]
        # The lumped cube: mass 1, moments of inertia 8 (1/8) (1/4 + 1/4). Velocity 8 along y and spin 3 about z remain.
        for state in (first, last):
            self.assertAlmostEqual(state["kinetic energy"], 0.5 * 64.0 + 0.5 * 0.5 * 9.0, delta=1e-3)
            self.assertAlmostEqual(state["total energy / initial energy"], 1.0, delta=1e-6)
        self.assertNotIn("energy ratio ended", said)

    def test_what_ends_with_a_merger_is_told(self):
        self.run_deck(STEP, FALL, part(1), part(2, 1, 2), SOLID, rigid(1), rigid(2, 1, 7, 7), cube(1, 0.0),
                      cube(2, 3.0), MERGE)
        self.assertEqual(self.warnings(), ["rigid part 2 is held, which ends with the merger: both move as rigid "
                                           "part 1 is held"])
        self.assertAlmostEqual(self.glstat()[-1]["global z velocity"], -1.0, delta=0.011)

    def test_the_same_supports_and_the_leads_motion(self):
        self.run_deck(STEP, inertia(1, 1.0), inertia(2, 2.0), SOLID, rigid(1, 1, 2, 7), rigid(2, 1, 2, 7),
                      cube(1, 0.0), cube(2, 3.0), MERGE)
        self.assertEqual(self.warnings(), ["the initial velocity of rigid part 2 does not count: both have that of "
                                           "rigid part 1"])

    def test_neighbours_are_held_by_what_holds_either(self):
        shared = (2, 9, 10, 3, 6, 11, 12, 7)
        more = nodes([(2, 0, 0), (2, 1, 0), (2, 0, 1), (2, 1, 1)], 9)
        for first, second in ((rigid(1), rigid(2, 1, 7, 7)), (rigid(1, 1, 7, 7), rigid(2))):
            self.run_deck(STEP, FALL, part(1), part(2, 1, 2), SOLID, first, second, cube(1, 0.0), more,
                          cube(2, 1.0, shared))
            self.assertEqual(self.glstat()[-1]["kinetic energy"], 0.0)

    # A cube may slide along a, 30 degrees up from x in the plane of x and z, and nothing else: CMO -1. It falls.
    AXES = "*DEFINE_COORDINATE_VECTOR\n" + card(7, 0.8660254, 0.0, 0.5, 0.0, 1.0, 0.0)

    def assert_slides_along_the_axis(self):
        last = self.glstat()[-1]
        speed = -100.0 * 0.5 * 0.01
        for axis, share in (("x", 0.75 ** 0.5), ("y", 0.0), ("z", 0.5)):
            self.assertAlmostEqual(last[f"global {axis} velocity"], speed * share, delta=0.011)

    def test_a_nodal_body_is_held_in_local_axes(self):
        body = "*CONSTRAINED_NODAL_RIGID_BODY_SPC_INERTIA\n" + card(9, 0, 3) + card(-1.0, 7, "011111") + \
            card(0.5, 0.5, 0.5, 1.0) + card(0.5, 0.0, 0.0, 0.5, 0.0, 0.5) + card(0.0)
        members = "*SET_NODE_LIST\n" + card(3) + card(*range(1, 9))
        elastic = "*MAT_ELASTIC\n" + card(1, 1.0, 2e5, 0.3)
        self.run_deck(STEP, FALL, part(1), SOLID, elastic, cube(1, 0.0), self.AXES, body, members)
        # Mass 1, 100 sin 30 along the axis for 0.01. Free along z it would have four times as much, along x nothing.
        last = self.glstat()[-1]
        self.assertAlmostEqual(last["kinetic energy"], 0.5 * 0.5**2, delta=2e-3)
        self.assertAlmostEqual(last["global x velocity"], -0.5 * 0.75**0.5, delta=0.011)

    def test_the_global_velocity_counts_what_belongs_to_no_part(self):
        """Masses 1, 3 and 4 with momenta 8 along x, 12 along y and 8 along z. Sabotage: the parts alone."""
        body = "*CONSTRAINED_NODAL_RIGID_BODY_INERTIA\n" + card(9, 0, 3) + card(0.5, 0.5, 0.5, 1.0) + \
            card(0.5, 0.0, 0.0, 0.5, 0.0, 0.5) + card(8.0)
        members = "*SET_NODE_LIST\n" + card(3) + card(*range(1, 9))
        elastic = "*MAT_ELASTIC\n" + card(1, 1.0, 2e5, 0.3)
        point = "*NODE\n" + f"{99:8}{9.0:16}{9.0:16}{9.0:16}\n" + f"*ELEMENT_MASS\n{7:8}{99:8}{4.0:16}\n" + \
            "*INITIAL_VELOCITY_NODE\n" + card(99, 0.0, 0.0, 2.0)
        self.run_deck(STEP, part(1), SOLID, elastic, cube(1, 0.0), body, members, inertia(2, 0.0, 4.0), rigid(2),
                      cube(2, 3.0), point)
        for state in self.glstat():
            for axis, speed in zip("xyz", (1.0, 1.5, 1.0)):
                self.assertAlmostEqual(state[f"global {axis} velocity"], speed, delta=1e-5)

    def test_the_axes_of_supports_have_the_offset_of_their_include(self):
        held = part(1) + SOLID + rigid(1, -1, 7, "011111") + cube(1, 0.0) + self.AXES
        self.write("*KEYWORD\n" + held + "*END\n", "held.k")
        self.run_deck(STEP, FALL, "*INCLUDE_TRANSFORM\nheld.k\n" + card(0, 0, 0, 0, 0, 0, 100) + "\n\n\n")
        self.assert_slides_along_the_axis()

    def test_what_local_supports_need(self):
        self.write(RUN + part(1) + SOLID + rigid(1, -1, 0, 111111) + cube(1, 0.0) + "*END\n")
        self.assertIn("con1 = 0: CMO -1 needs the coordinate system of its directions",
                      self.nugget("run", "model.k", "-o", ".", expect=1).stderr)
        self.write(RUN + part(1) + SOLID + rigid(1, -1, 7, 21111) + self.AXES + cube(1, 0.0) + "*END\n")
        self.assertIn("expected six digits, each 0 or 1", self.nugget("run", "model.k", "-o", ".", expect=1).stderr)


class SpringsAndRelaxation(CommandTest):
    MASS = (nodes([(0, 0, 0), (1, 0, 0)]) + "*BOUNDARY_SPC_NODE\n" + card(1, 0, 1, 1, 1, 1, 1, 1) +
            card(2, 0, 0, 1, 1, 1, 1, 1) + "*ELEMENT_MASS\n" + f"{1:8}{2:8}{1.0:16}\n" + part(1) +
            "*SECTION_DISCRETE\n" + card(1, 0) + "\n" + f"*ELEMENT_DISCRETE\n{1:8}{1:8}{1:8}{2:8}\n")

    def test_a_damper_whose_end_slope_falls(self):
        law = "*MAT_DAMPER_NONLINEAR_VISCOUS\n" + card(1, 5)
        # From (1, 10) to (2, 8) and on: 0 at a rate of 6.
        for last, told in ((8.0, True), (10.0, False), (12.0, False)):
            self.write(RUN + STEP + self.MASS + law + curve(5, (0, 0.0), (1.0, 10.0), (2.0, last)) + "*END\n")
            said = self.nugget("check", "model.k").stderr
            self.assertEqual("at a rate of 6.02 the force drives the motion" in said, told, said)

    def test_relaxation_that_drterm_ends(self):
        law = "*MAT_SPRING_ELASTIC\n" + card(1, 1000.0)
        self.write(RUN + self.MASS + law + FALL.replace("_Z", "_X") + "*CONTROL_DYNAMIC_RELAXATION\n" +
                   card(250, 1e-3, 0.99, 0.02, 0.0, 0, 0.0, 1) + "*CONTROL_TIMESTEP\n" + card(0.0, 0.01) + "*END\n")
        self.nugget("run", "model.k", "-o", ".", "--threads", 1)
        told = self.json("summary.json")["relaxation"]
        self.assertAlmostEqual(told["time"], 0.02, delta=1e-9)
        # Steps of 0.01 * 2 / sqrt(k/m).
        self.assertEqual(told["cycles"], 32)
        self.assertFalse(told["at_rest"])


class CrushedBricks(CommandTest):
    # A corner of a unit brick of ELFORM 2 is driven by d (1, 1, 1) towards the opposite one, all others are held. At
    # the Gauss point next to it, a = (1 + 1/sqrt(3))/2 along each axis, det J = 1 - 3 a^2 d; of the brick's volume
    # 1 - 3/4 d is left.
    TIME = 1.0 / (3.0 * (0.5 + 0.5 / math.sqrt(3.0)) ** 2) / 1000.0

    def crushed(self, extra, expect):
        held = "*BOUNDARY_SPC_SET\n" + card(1, 0, 1, 1, 1) + "*SET_NODE_LIST\n" + card(1) + card(1, 2, 3, 4, 5, 6, 8)
        drive = curve(1, (0, -1000.0), (1, -1000.0)) + "".join(
            "*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + card(7, axis, 0, 1, 1.0) for axis in (1, 2, 3))
        self.write("*KEYWORD\n*CONTROL_TERMINATION\n" + card(8e-4) + "*DATABASE_GLSTAT\n" + card(1e-5) + part(1) +
                   "*SECTION_SOLID\n" + card(1, 2) + "*MAT_ELASTIC\n" + card(1, 7.8e-9, 2000.0, 0.3) +
                   nodes(CORNERS) + "*ELEMENT_SOLID\n" + "".join(f"{i:8}" for i in (1, 1, *range(1, 9))) + "\n" +
                   held + drive + "*SET_PART_LIST\n" + card(3) + card(1) + extra + "*END\n")
        return self.nugget("run", "model.k", "-o", ".", "--threads", 1, expect=expect).stderr

    def assert_time(self, text, pattern):
        found = re.search(pattern, text)
        self.assertTrue(found, text)
        self.assertAlmostEqual(float(found[1]), self.TIME, delta=2e-6)

    def test_a_point_inside_out_ends_the_run(self):
        self.assert_time(self.crushed("", 3), r"negative volume in solid 1 of part 1 at time (\S+),")

    def test_a_point_inside_out_deletes_the_brick(self):
        for extra in ("*CONTROL_TIMESTEP\n" + card(0.0, 0.5, 0, 0.0, 0.0, 0, 1),
                      "*CONTROL_TIMESTEP\n" + card(0.0, 0.5) + "*CONTROL_SOLID\n" + card(0, 0, 0, 0, 3)):
            self.crushed(extra, 0)
            self.assert_time(self.read("run.log"), r"time (\S+): solid 1 of part 1 is deleted, its volume is negative")
            self.assertAlmostEqual(self.glstat()[-1]["total energy / initial energy"], 1.0, delta=1e-4)


if __name__ == "__main__":
    unittest.main()
