# SPDX-License-Identifier: Apache-2.0
"""Nodes that supports hold, or motions drive, askew to a wall: both are met, and what each does is counted. Against what a mass on a straight
wire does that meets a wall."""
import math
import pathlib
import re
import unittest

import lsda
from few_elements import card, curve
from masses import MASS, MassesTest

WIRE = (2.0 / 7.0, 3.0 / 7.0, 6.0 / 7.0)
FILES = "*DATABASE_RWFORC\n" + card(0.02, 2) + "*CONTROL_ENERGY\n" + card(2, 2, 2, 2)


def plane(friction=0):
    return "*RIGIDWALL_PLANAR\n" + card(0) + card(0, 0, 0, 0, 0, 1, friction)


def system(x, xy):
    return "*DEFINE_COORDINATE_VECTOR\n" + card(7, *(f"{a:.7f}" for a in (*x, *xy)))


def on_a_wire(speed=0.0):
    """Node 1 can move along the wire only."""
    velocity = "*INITIAL_VELOCITY_NODE\n" + card(1, *(f"{-speed * a:.6f}" for a in WIRE)) if speed else ""
    return system(WIRE, (0, 1, 0)) + "*BOUNDARY_SPC_NODE\n" + card(1, 7, 0, 1, 1) + velocity + FILES


def force(dof, size):
    return "*LOAD_NODE_POINT\n" + card(1, dof, 1, size)


def driven(*direction, speed):
    return "*DEFINE_VECTOR\n" + card(3, 0, 0, 0, *direction) + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + card(1, 4, 0, 5, 1.0, 3) + curve(5, (0, speed), (1, speed))


class WallsBesideSupports(MassesTest):
    def run_masses(self, place, cards):
        self.said = self.run_deck([place], cards)
        self.walls = lsda.states(lsda.read(pathlib.Path(self.folder) / "out" / "binout0000"), "rwforc/forces")
        return self.nodout()[-1][1]

    def expect_balance(self, delta=1e-6):
        self.assertAlmostEqual(self.json("out/summary.json")["energy"]["ratio"], 1.0, delta=delta)
        self.assertNotIn("of the nodes of wall", self.said)

    def test_a_mass_on_a_wire_that_meets_a_wall(self):
        """It stays on the wire, at the wall, which has taken its energy. Sabotage: the wall takes what is along its normal only."""
        last = self.run_masses(tuple(1.4 * a for a in WIRE), on_a_wire(35.0) + plane() + force(1, -10.0))
        self.assert_near(last, [*(-1.4 * a for a in WIRE), 0, 0, 0], 1e-5)
        self.expect_balance()
        # The force across the wire is what the supports have, but for their share of the wall's: N n + S = -F with S across the wire.
        normal = 10.0 * WIRE[0] / WIRE[2]
        self.assertAlmostEqual(self.walls[-1]["normal_force"][0], normal, delta=1e-4)
        self.assertAlmostEqual(self.walls[-1]["z_force"][0], normal, delta=1e-4)
        forces = [float(x) for x in self.read("out/spcforc").split("force resultants")[-1].split("=")[1].split()[:3]]
        self.assert_near(forces, [10.0, 0.0, -normal], 1e-3)
        taken = 0.5 * MASS * 35.0**2 + 10.0 * 1.4 * WIRE[0]
        energy = float(re.findall(r"stonewall energy\.+\s*(\S+) wall", self.read("out/glstat"))[-1])
        self.assertAlmostEqual(energy, taken, delta=1e-3 * taken)

    def test_a_driven_node_that_meets_a_wall_goes_along_it(self):
        """-5 along (3 0 4)/5 is -25/3 along x on the wall. Sabotage: the wall's impulse without what the motion takes up; the wall before the motion."""
        last = self.run_masses((0, 0, 0.2), driven(0.6, 0, 0.8, speed=-5.0) + FILES + plane())
        self.assert_near(last, [-0.15 - 0.05 * 25 / 3, 0, -0.2, -25 / 3, 0, 0], 0.02)
        self.expect_balance()

    def test_friction_along_what_is_left(self):
        """Held along (3 0 4)/5 and pressed on the wall by 10 across that, it has 50/3 from the wall and slides along y. Sabotage: friction by the
        normal force of a free node."""
        slope = system((0.6, 0, 0.8), (0, 1, 0)) + "*BOUNDARY_SPC_NODE\n" + card(1, 7, 1, 0, 0) + FILES + force(1, 8.0) + force(3, -6.0)
        for friction, way in ((0.3, 0.2**2 / (2 * 0.3 * 50 / 3 / MASS)), (1, 0.0), (0, 0.02)):
            with self.subTest(friction):
                last = self.run_masses((0, 0, 0), slope + plane(friction) + "*INITIAL_VELOCITY_NODE\n" + card(1, 0, 0.2, 0))
                self.assert_near(last, [0, way, 0, 0, 0.0 if friction else 0.2, 0], 2e-4)
                self.expect_balance()

    def test_a_wall_with_mass(self):
        """Along its normal the mass on the wire is as heavy as MASS / cos^2. Sabotage: the node's own mass."""
        wall = "*RIGIDWALL_PLANAR_MOVING\n" + card(0) + card(0, 0, 0, 0, 0, 1) + card(6.0, 10.0)
        last = self.run_masses(tuple(0.2 * a for a in WIRE), on_a_wire() + wall)
        speed = 6.0 * 10.0 / (6.0 + MASS / WIRE[2] ** 2)
        self.assert_near(last[3:], [speed / WIRE[2] * a for a in WIRE], 1e-4)
        self.expect_balance(1e-5)

    def test_a_round_wall(self):
        """The mass on the wire ends on the cylinder, where the wire leaves it."""
        wall = "*RIGIDWALL_GEOMETRIC_CYLINDER\n" + card(0) + card(0, -50, 0, 0, 50, 0) + card(0.5, 0)
        self.run_masses(tuple(1.4 * a for a in WIRE), on_a_wire(35.0) + wall)
        last = self.nodout()[-1][1]
        place = [1.4 * a + d for a, d in zip(WIRE, last)]
        self.assertAlmostEqual(math.hypot(place[0], place[2]), 0.5, delta=2e-5)
        self.assertAlmostEqual(place[0] / place[1], 2.0 / 3.0, delta=1e-4)
        self.expect_balance()

    def test_what_is_held_along_the_normal_stays_held(self):
        """Sabotage: the wall wins, and the balance is lost."""
        held = "*BOUNDARY_SPC_NODE\n" + card(1, 0, 1, 1, 1)
        moving = "*RIGIDWALL_PLANAR_MOVING\n" + card(0) + card(0, 0, 0, 0, 0, 1) + card(6.0, 10.0)
        for name, cards, end in (("clamped", held + moving, (0, 0, 0)), ("driven", driven(0, 0, 1, speed=-5.0) + plane(), (0, 0, -0.5))):
            with self.subTest(name):
                last = self.run_masses((0, 0, 0.2), cards + FILES)
                self.assert_near(last[:3], end, 1e-5)
                self.assertIn("1 of the nodes of wall 1, first node 1, are held or driven along its normal, so that it does not stop them", self.said)
                self.assertAlmostEqual(self.json("out/summary.json")["energy"]["ratio"], 1.0, delta=1e-6)
        self.run_masses((0, 0, 0.2), held + plane() + FILES)  # neither moves
        self.expect_balance()


if __name__ == "__main__":
    unittest.main()
