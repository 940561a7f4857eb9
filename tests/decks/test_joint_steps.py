# SPDX-License-Identifier: Apache-2.0
"""A model of rigid bodies and joints has no step of its own: how far its joints open."""
import math
import unittest

import lsda
from nugget_command import CommandTest

LENGTH, GRAVITY, END = 250.0, 9810.0, 6.0

# A rod of 250 mm and 1 kg hangs on a hinge about y at the origin, level at first.
DECK = """*KEYWORD
*CONTROL_TERMINATION
{end}
{step}*DATABASE_GLSTAT
0.05
*DATABASE_NODOUT
0.005,2
*DATABASE_HISTORY_NODE
5
*DEFINE_CURVE
9
0.0,1.0
100.0,1.0
*LOAD_BODY_Z
9,{gravity}
*MAT_RIGID
1,1e-9,210000.0,0.3
1.0,7,7

*MAT_RIGID
2,1e-9,210000.0,0.3


*PART_INERTIA
ground
1,0,1
0.0,0.0,0.0,1.0e-3
1.0,0.0,0.0,1.0,0.0,1.0

*PART_INERTIA
rod
2,0,2
125.0,0.0,0.0,1.0e-3
1.0,0.0,0.0,5.2083333,0.0,5.2083333

*CONSTRAINED_EXTRA_NODES_SET
1,1
2,2
*SET_NODE_LIST
1
1,3
*SET_NODE_LIST
2
2,4,5
*NODE
1,0.0,0.0,0.0
2,0.0,0.0,0.0
3,0.0,10.0,0.0
4,0.0,10.0,0.0
5,250.0,0.0,0.0
*CONSTRAINED_JOINT_REVOLUTE_ID
        77the hinge
1,2,3,4
*END
"""


def angle_at(time, steps=20000):
    """Of the compound pendulum, from level: theta'' = 3 g / (2 L) cos(theta); by Runge and Kutta."""
    dt = time / steps
    rate = lambda a, w: (w, 1.5 * GRAVITY / LENGTH * math.cos(a))  # noqa: E731
    a, w = 0.0, 0.0
    for _ in range(steps):
        k1 = rate(a, w)
        k2 = rate(a + 0.5 * dt * k1[0], w + 0.5 * dt * k1[1])
        k3 = rate(a + 0.5 * dt * k2[0], w + 0.5 * dt * k2[1])
        k4 = rate(a + dt * k3[0], w + dt * k3[1])
        a += dt / 6 * (k1[0] + 2 * k2[0] + 2 * k3[0] + k4[0])
        w += dt / 6 * (k1[1] + 2 * k2[1] + 2 * k3[1] + k4[1])
    return a


class Pendulum(CommandTest):
    def opening(self):
        line = next(line for line in self.read("run.log").splitlines() if line.startswith(" joint       77"))
        return float(line.split()[2])

    def test_the_joint_stays_closed(self):
        """With a thousandth of ENDTIM it opened by tens of mm. Sabotage: a step that never falls; joints whose stiffness does not follow."""
        self.write(DECK.format(end=END, gravity=GRAVITY, step=""))
        told = self.nugget("run", "model.k", "--quiet").stderr
        self.assertNotIn("joint 77 opened", told)
        self.assertLess(self.opening(), 3e-3 * LENGTH)
        self.assertAlmostEqual(self.json("summary.json")["energy"]["ratio"], 1.0, delta=0.01)
        states = lsda.states(lsda.read(self.folder / "binout0000"), "nodout")
        for time in (0.1, 0.2, 0.4, 1.0):
            state = min(states, key=lambda s: abs(s["time"][0] - time))
            expected = angle_at(state["time"][0])
            self.assertAlmostEqual(state["x_coordinate"][0] / LENGTH, math.cos(expected), delta=0.02)
            self.assertAlmostEqual(abs(state["z_coordinate"][0]) / LENGTH, abs(math.sin(expected)), delta=0.02)

    def test_a_load_that_comes_later(self):
        """Gravity from 0.5 on, when the step is a thousandth of ENDTIM still: the joint opens by its first swing on the soft spring, and
        closes again. Sabotage: joints that stay as soft as they were."""
        late = DECK.format(end=END, gravity=GRAVITY, step="").replace("0.0,1.0\n100.0,1.0", "0.0,0.0\n0.5,0.0\n0.501,1.0\n100.0,1.0")
        self.write(late)
        self.nugget("run", "model.k", "--quiet", "--max-cycles", 100000)
        self.assertLess(self.opening(), 0.02 * LENGTH)
        self.assertEqual(self.json("summary.json")["time"], END)

    def test_a_joint_that_opens_far_is_told(self):
        """In a model whose step is the deck's own choice: a mass on a spring sets it, and the hinge is soft at it."""
        spring = ("*PART\nspring\n5,5,5\n*SECTION_DISCRETE\n5,0\n\n*MAT_SPRING_ELASTIC\n5,1.0e-4\n*NODE\n6,0.0,500.0,0.0\n7,0.0,600.0,0.0\n"
                  "*ELEMENT_MASS\n1,6,1.0e-3\n2,7,1.0e-3\n*ELEMENT_DISCRETE\n11,5,6,7,0,1.0,0,0.0\n*END\n")
        self.write(DECK.format(end=END, gravity=GRAVITY, step="*DEFINE_CURVE\n8\n0.0,0.006\n100.0,0.006\n*CONTROL_TIMESTEP\n0.0,0.9,0,0.0,0.0,8\n")
                   .replace("*END\n", spring))
        told = self.nugget("run", "model.k", "--quiet").stderr
        self.assertRegex(told, r"warning: joint 77 opened by .* % of its bodies' size: the step is too long for its forces")


class SphericalJoint(CommandTest):
    def test_a_joint_that_becomes_stiffer_makes_no_energy(self):
        """A body of 1 kg that spins about its centre starts joined off it to one that is held, or to a free one: the joint parts at once
        and opens too far, so that the step is shortened and the springs become stiffer while they are drawn out. Nothing acts: energy
        is kept. Sabotage: stiffness that rises at once (15, 8 and 3 times the energy, and 133,000 and 245,000 cycles where there are
        10,000 and 20,000 now); the share of the forces by the energy before this step's work."""
        cases = ((1.0, 2.0, 3e-3, "", True, (0.0, 0.0, 1000.0)), (5.0, 20.0, 1e-2, "", True, (0.0, 0.0, 1000.0)),
                 (5.0, 2.0, 3e-3, "", True, (0.0, 0.0, 1000.0)), (13.6, 11.8, 6.92e-3, "1.0,0.01", True, (300.0, 500.0, -800.0)),
                 (55.4, 47.4, 1.17e-3, "1.0,0.3", False, (900.0, -500.0, 300.0)), (22.7, 2.4, 1.79e-3, "1.0,0.01", True, (0.0, 600.0, 700.0)))
        for off, gyration, end, damping, held, spin in cases:
            first = DECK.split("*PART_INERTIA")[0].format(end=end, gravity=0.0, step="").replace("0.05\n", f"{end / 200:.3E}\n")
            bodies = [f"*PART_INERTIA\nbody\n{1 + i},0,{1 + i}\n{x},0.0,0.0,1.0e-3\n{inertia},0.0,0.0,{inertia},0.0,{inertia}\n{motion}\n"
                      for i, (x, inertia, motion) in enumerate(((0.0, 0.4, ""), (50.0 + off, 1e-3 * gyration**2, "0.0,0.0,0.0,{},{},{}".format(*spin))))]
            self.write((first if held else first.replace("1.0,7,7", "")) + "".join(bodies) +
                       "*CONSTRAINED_EXTRA_NODES_SET\n1,1\n2,2\n*SET_NODE_LIST\n1\n1\n*SET_NODE_LIST\n2\n2,5\n*NODE\n1,50.0,0.0,0.0\n"
                       f"2,50.0,0.0,0.0\n5,{50.0 + off},10.0,0.0\n*CONSTRAINED_JOINT_SPHERICAL_ID\n        77ball\n1,2,0,0,0,0,{damping}\n*END\n")
            self.nugget("run", "model.k", "--quiet")
            states = self.glstat()
            most = max(s["kinetic energy"] for s in states) / states[0]["kinetic energy"]
            self.assertLess(most, 1.02, (off, gyration, end))
            self.assertLess(self.json("summary.json")["cycles"], 45000)


if __name__ == "__main__":
    unittest.main()
