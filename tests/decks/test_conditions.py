# SPDX-License-Identifier: Apache-2.0
"""Supports, motions and initial velocities of masses and a rigid box, against closed forms."""
import math
import re
import unittest

from few_elements import card, curve
from masses import END, MASS, NUMBER, STEP, MassesTest

def system(identity, degrees):
    """Axes turned about z."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return "*DEFINE_COORDINATE_VECTOR\n" + card(identity, f"{c:.7f}", f"{s:.7f}", 0.0, f"{-s:.7f}", f"{c:.7f}", 0.0)


class Conditions(MassesTest):
    def test_oblique_supports_hold_together(self):
        """Two planes of a sector of 10 degrees meet in node 1; node 2 gets its second support between 0.0295 and
        0.0595, so it moves before and after."""
        cards = system(7, 10.0)
        cards += "*BOUNDARY_SPC_NODE\n" + card(1, 0, 0, 1) + card(1, 7, 0, 1) + card(2, 0, 0, 1)
        cards += "*BOUNDARY_SPC_NODE_BIRTH_DEATH\n" + card(2, 7, 0, 1) + card(0.0295, 0.0595)
        cards += "*LOAD_NODE_POINT\n" + "".join(card(n, d, 1, f) for n in (1, 2) for d, f in ((1, 3.0), (2, 7.0)))
        self.run_deck([(0, 0, 0), (1, 0, 0)], cards)
        states = self.nodout()
        self.assert_near(states[-1][1], [0.0] * 6, 1e-12)
        self.assertGreater(states[1][2][3], 0.0)
        self.assert_near(states[2][2][3:], [0.0] * 3, 1e-9)
        self.assertGreater(states[-1][2][3], 0.0)
        self.assert_near([s[2][4] for s in states], [0.0] * len(states), 1e-9)
        # What both hold is the load.
        forces = re.findall(rf"force resultants\s*=\s*({NUMBER})\s+({NUMBER})", self.read("out/spcforc"))
        self.assert_near([float(f) for f in forces[2]], [-6.0, -14.0], 1e-3)
        work, kinetic = self.energies()
        self.assertAlmostEqual(work / kinetic, 1.0, delta=1e-3)

    def test_a_mass_pressed_on_a_wall_from_the_start(self):
        """Nothing moves and no work is done; at a start with a velocity into the wall it takes just that. A wall that begins later stops what
        it finds. Sabotage: the wall's work with the velocity that the force of the first half step gave the mass, which ended as unstable."""
        for speed, birth in ((0.0, 0.0), (-3.0, 0.0), (0.0, 4e-3)):
            with self.subTest((speed, birth)):
                deck = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(0.01) + "*NODE\n" + f"{1:8}{0.0:16.6f}{0.0:16.6f}{0.0:16.6f}\n"
                deck += "*ELEMENT_MASS\n" + f"{1:8}{1:8}{2.0:16.6f}\n" + "*RIGIDWALL_PLANAR\n" + card(0, 0, 0, 0.0, birth) + card(0.0, 0.0, 0.0, 0.0, 0.0, 1.0)
                deck += "*LOAD_NODE_POINT\n" + card(1, 3, 1, -10.0) + curve(1, (0.0, 1.0), (1.0, 1.0))
                deck += "*INITIAL_VELOCITY_NODE\n" + card(1, 0.0, 0.0, speed) if speed else ""
                self.write(deck + "*DATABASE_GLSTAT\n" + card(5e-3, 2) + "*END\n")
                self.nugget("run", "model.k", "--quiet")
                energy = self.json("summary.json")["energy"]
                first = 0.5 * 2.0 * speed**2
                # Free until the wall begins: F^2 t^2 / 2 m, which the wall takes.
                falls = 0.5 * (10.0 * birth)**2 / 2.0
                self.assertAlmostEqual(energy["initial"], first, delta=1e-9)
                self.assertAlmostEqual(energy["external"], falls, delta=0.02 * falls + 1e-12)
                self.assertAlmostEqual(energy["ratio"], 1.0, delta=1e-9)

    def test_rigid_bodies_come_back_from_a_wall(self):
        """A rigid box of 8 and a nodal rigid body of four masses of 2 meet a wall with 10: RWPNAL decides whether they
        come back. The wall's impulse is twice their momentum."""
        places = [(10 + x, y, 0) for x, y in ((0, 0), (2, 0), (2, 2), (0, 2))]
        cards = "*SET_NODE_LIST\n" + card(3) + card(1, 2, 3, 4) + "*CONSTRAINED_NODAL_RIGID_BODY\n" + card(70, 0, 3)
        cards += "*INITIAL_VELOCITY\n" + card(0) + card(0.0, 0.0, -10.0)
        cards += "*RIGIDWALL_PLANAR\n" + card(0) + card(0.0, 0.0, -0.204, 0.0, 0.0, 1.0)
        cards += "*DATABASE_RWFORC\n" + card(STEP, 1)
        for penalty, factor, told in ((0.0, 1.0, "RWPNAL 1"), (1.0, -1.0, None), (-1.0, -1.0, "give the positive number")):
            with self.subTest(penalty):
                told_now = self.run_deck(places, cards + "*CONTROL_CONTACT\n" + card(0.1, penalty), box=True)
                if told:
                    self.assertIn(told, told_now)
                else:
                    self.assertNotIn("rwpnal", told_now.lower())
                last = self.nodout()[-1]
                for node in (1, 2, 3, 4, 2001):
                    self.assert_near(last[node][3:], [0.0, 0.0, -10.0 * factor], 0.1)
                forces = re.findall(rf"^\s*{NUMBER}\s+\d+\s+({NUMBER})", self.read("out/rwforc"), re.MULTILINE)
                self.assertAlmostEqual(sum(map(float, forces)) * STEP, 160.0 * (1.0 - factor), delta=3.2)

    def test_a_motion_beside_an_oblique_support(self):
        """A slider on a plane inclined by 30 degrees is driven along x: it follows the plane. The force for the
        acceleration a = 10 along x is m a (1 + tan^2) along x."""
        cards = system(7, 30.0) + "*BOUNDARY_SPC_NODE\n" + card(1, 7, 0, 1)
        cards += "*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + card(1, 1, 1, 1, 10.0)
        self.run_deck([(0, 0, 0)], cards)
        slope = math.tan(math.radians(30.0))
        x, y, _, vx, vy, _ = self.nodout()[-1][1]
        self.assertAlmostEqual(x, 0.5 * 10 * END**2, delta=1e-9)
        self.assertAlmostEqual(y / x, slope, delta=1e-5)
        self.assertAlmostEqual(vy / vx, slope, delta=1e-5)
        force = float(re.findall(rf"nd#\s+1\s+xforce=\s*({NUMBER})", self.read("out/bndout"))[-1])
        self.assertAlmostEqual(force, MASS * 10 * (1 + slope**2), delta=1e-3)
        work, kinetic = self.energies()
        self.assertAlmostEqual(work, 0.5 * MASS * (10 * END) ** 2 * (1 + slope**2), delta=1e-4)
        self.assertAlmostEqual(work / kinetic, 1.0, delta=1e-3)

    def test_a_body_driven_along_its_own_axis_while_it_turns(self):
        """DOF -4 in the body's axes: v = 1 along its x, nothing across, while it turns by 90 degrees (1.6 in a step, half of
        which its axes lag behind)."""
        cards = "*DEFINE_VECTOR\n" + card(9, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0)
        cards += "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n" + card(50, 7, 0, 1, math.pi / 2 / END)
        cards += "*BOUNDARY_PRESCRIBED_MOTION_RIGID_LOCAL\n" + card(50, -4, 0, 1, 1.0, 9)
        self.run_deck([(0, 50, 0)], cards, box=True)
        text = self.read("out/rbdout")
        moved = re.findall(rf"displacements:\s+({NUMBER})\s+({NUMBER})", text)[-2]
        radius = 1.0 / (math.pi / 2 / END)
        self.assert_near([float(v) for v in moved], [radius, radius], 0.01 * radius)
        velocity = re.findall(rf"velocities:\s+({NUMBER})\s+({NUMBER})", text)[-2]
        self.assert_near([float(v) for v in velocity], [0.0, 1.0], 0.02)

    def test_spin_about_an_axis_through_two_nodes(self):
        """The first of the two nodes is on the axis, whatever XC, YC, ZC say."""
        cards = "*SET_NODE_LIST\n" + card(1) + card(1, 2)
        cards += "*INITIAL_VELOCITY_GENERATION\n" + card(1, 3, 10.0, 0.0, 0.0, 1.0)
        cards += card(7.0, 7.0, 0.0, -999.0, 3, 4)
        self.run_deck([(0, 0, 0), (3, 2, 0), (3, 0, 0), (3, 0, 2)], cards)
        start = self.nodout()[0]
        self.assert_near(start[1][3:], [0.0, -30.0, 1.0], 1e-9)
        self.assert_near(start[2][3:], [-20.0, 0.0, 1.0], 1e-9)

    def test_a_curve_that_ends_with_the_run_is_followed_to_its_end(self):
        """Masses driven by velocity and by displacement, one on a circle, and a wall that pushes one: the last row, whose
        velocities are halfway into a step that is not taken, is like those before; the load ends a round-off before it.
        Sabotage: zero beyond the curve."""
        cards = curve(3, (0, 2), (END, 2)) + curve(4, (0, 0), (END, 2 * END)) + curve(5, (0, -7), (0.09999999999999, -7))
        cards += "*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + card(1, 1, 0, 3) + card(2, 1, 2, 4)
        cards += card(3, 11, 0, 3) + card(0.0, 0.0) + card(4, 11, 2, 4) + card(0.0, 0.0)
        cards += "*LOAD_NODE_POINT\n" + "".join(card(n, 1, 5) for n in (1, 2, 5, 6))
        for wall, (y, quantity, motion) in enumerate(((30, 0, 3), (40, 1, 4)), 1):
            cards += f"*SET_NODE_LIST\n{wall:10}\n{4 + wall:10}\n*RIGIDWALL_GEOMETRIC_FLAT_MOTION_ID\n" + card(wall, "") + card(wall)
            cards += card(0.0, y, 0.0, 1.0, y, 0.0) + card(0.0, y + 1, 0.0, 0.0, 0.0)
            cards += card(motion, quantity, 1.0, 0.0, 0.0)
        cards += "*DATABASE_RWFORC\n" + card(0.02, 1)
        places = [(0, 0, 0), (0, 10, 0), (5, 0, 0), (5, 0, 9), (0, 30, 0), (0, 40, 0)]
        self.run_deck(places, cards)
        before, last = self.nodout()[-2:]
        for node in (1, 2, 5, 6):
            self.assert_near(last[node], [2 * END, 0.0, 0.0, 2.0, 0.0, 0.0], 1e-6)
        for node in (3, 4):
            self.assertAlmostEqual(math.hypot(*last[node][3:5]), 10.0, delta=1e-3)
            self.assertAlmostEqual(math.hypot(*before[node][3:5]), 10.0, delta=1e-3)
        # Motions and walls bear the load of 7 against the way.
        forces = re.findall(rf"nd#\s+([12])\s+xforce=\s*({NUMBER})", self.read("out/bndout"))
        self.assert_near([float(f) for _, f in forces[-2:]], [7.0, 7.0], 1e-6)
        walls = re.findall(rf"^\s*{NUMBER}\s+\d+\s+({NUMBER})", self.read("out/rwforc"), re.MULTILINE)
        self.assert_near([float(f) for f in walls[-2:]], [7.0, 7.0], 1e-6)
        kinetic = [state["kinetic energy"] for state in self.glstat("out/glstat")]
        self.assertAlmostEqual(kinetic[-1], kinetic[-2], delta=1e-3)

    def test_what_ends_before_it_begins_is_told(self):
        cards = "*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + card(1, 1, 0, 1, 1.0, 0, 0.01, 0.05)
        cards += "*BOUNDARY_SPC_NODE_BIRTH_DEATH\n" + card(1, 0, 0, 1) + card(0.05, 0.02)
        told = self.run_deck([(0, 0, 0)], cards)
        self.assertEqual(told.count("it ends before it begins (birth 0.05): the card does nothing"), 2)


if __name__ == "__main__":
    unittest.main()
