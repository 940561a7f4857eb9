# SPDX-License-Identifier: Apache-2.0
"""Springs, joints and beams by the command: what the summary counts, deforc, jntforc, glstat, binout's branches."""
import json
import math
import re
import struct
import unittest

from nugget_command import CommandTest

# A rod (rigid, 2 kg, 2 m) hangs on a hinge at the origin; a spring to the ground pulls at its end (2, 0, 0) along z, and a
# truss holds nothing of note beside it.
DECK = """*KEYWORD
*TITLE
springs and joints
*CONTROL_TERMINATION
       0.2
*CONTROL_TIMESTEP
       0.0       0.9         0       0.0       0.0         9
*DEFINE_CURVE
         9
                 0.0               0.001
                10.0               0.001
*MAT_RIGID
         1      1e-9  210000.0       0.3
       1.0         7         7

*MAT_RIGID
         2      1e-9  210000.0       0.3


*PART_INERTIA
ground
         1         0         1
       0.0       0.0       0.0       1.0
       1.0       0.0       0.0       1.0       0.0       1.0

*PART_INERTIA
rod
         2         0         2
       1.0       0.0       0.0       2.0
      0.01       0.0       0.0    0.6667       0.0    0.6667

*CONSTRAINED_EXTRA_NODES_SET
         1         1
         2         2
*SET_NODE_LIST
         1
         1         3
*SET_NODE_LIST
         2
         2         4         5
*NODE
       1             0.0             0.0             0.0
       2             0.0             0.0             0.0
       3             0.0             1.0             0.0
       4             0.0             1.0             0.0
       5             2.0             0.0             0.0
       6             5.0             0.0             0.0
       7             6.0             0.0             0.0
*CONSTRAINED_JOINT_REVOLUTE_ID
        77the hinge
         1         2         3         4
*PART
spring
         5         5         5
*SECTION_DISCRETE
         5         0

*MAT_SPRING_ELASTIC
         5      50.0
*DEFINE_SD_ORIENTATION
         3         0       0.0       0.0       1.0
*ELEMENT_DISCRETE
      11       5       5       0       3             2.0       0             0.0
      12       5       5       0       3             1.0       1             0.0
*PART
truss
         6         6         6
*SECTION_BEAM
         6         3
       1.0
*MAT_ELASTIC
         6       1.0     100.0       0.3
*ELEMENT_BEAM
      21       6       6       7
*DEFINE_CURVE
         1
                 0.0                 1.0
                10.0                 1.0
*LOAD_BODY_Z
         1      9.81
{requests}*END
"""


def requests(binary):
    return "".join(f"*DATABASE_{name}\n       0.1{binary:>10}\n" for name in ("DEFORC", "JNTFORC", "GLSTAT"))


def states(text):
    """[[(label, value)]]: the states of a deforc or jntforc."""
    found = []
    for line in text.splitlines():
        if "...." not in line:
            continue
        label, value = line.strip().split("..", 1)[0], float(line[30:])
        if label == "time":
            found.append([])
        found[-1].append((label, value))
    return found


class Bodies(CommandTest):
    def test_files_of_springs_and_joints(self):
        self.write(DECK.format(requests=requests(1)))
        self.nugget("run", "model.k", "-o", "out", "--quiet")
        summary = self.json("out/summary.json")
        self.assertEqual(summary["elements"], {"shell": 0, "solid": 0, "beam": 1, "discrete": 2})
        self.assertAlmostEqual(summary["energy"]["ratio"], 1.0, delta=1e-3)

        deforc = states(self.read("out/deforc"))
        self.assertEqual(len(deforc), 3)
        last = dict(deforc[-1])
        self.assertEqual(last["spring/damper number"], 11)  # PF = 1 leaves the other one out
        self.assertEqual(len(deforc[-1]), 7)
        # It stretches as the end of the rod goes down (its node goes towards -z, the ground stays): tension, S K d.
        self.assertGreater(last["change in length"], 0.01)
        self.assertAlmostEqual(last["resultant force"], 100.0 * last["change in length"], delta=1e-3)
        self.assertAlmostEqual(last["z-force"], last["resultant force"], delta=1e-4)

        joint = dict(states(self.read("out/jntforc"))[-1])
        self.assertEqual(joint["joint ID"], 77)
        self.assertIn("the hinge", self.read("out/jntforc"))
        self.assertAlmostEqual(joint["y-moment"], 0.0, delta=1e-6)
        self.assertGreater(joint["z-force"], 0.0)
        glstat = self.glstat("out/glstat")[-1]
        self.assertGreater(glstat["spring and damper energy"], 0.0)
        self.assertIn("joint internal energy", glstat)
        self.assertRegex(self.read("out/run.log"), r"joint +77 +\d\.\d+e-")

    def test_the_same_in_binout(self):
        self.write(DECK.format(requests=requests(2)))
        self.nugget("run", "model.k", "-o", "out", "--quiet")
        data = (self.folder / "out/binout0000").read_bytes()
        for name in (b"/deforc/d000002", b"/jntforc/joints/d000002", b"resultant_moment", b"joint_internal_energy"):
            self.assertIn(name, data)

    def test_walls_have_their_own_numbers(self):
        """By _ID where the card has one, else the place in the deck, or the next that is free."""
        wall = "{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}\n"
        deck = (
            "*KEYWORD\n*TITLE\ntwo walls\n*CONTROL_TERMINATION\n1e-5\n*CONTROL_TIMESTEP\n0,0.6\n*MAT_ELASTIC\n1,7.85e-9,210000.,0.3\n*SECTION_SOLID\n1,1\n"
            "*PART\nbrick\n1,1,1\n*INITIAL_VELOCITY_GENERATION\n1,2,0.0,-1000.0,0.0,0.0\n\n"
            "*NODE\n1,0.,0.,0.\n2,10.,0.,0.\n3,10.,10.,0.\n4,0.,10.,0.\n5,0.,0.,10.\n6,10.,0.,10.\n7,10.,10.,10.\n8,0.,10.,10.\n"
            "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n"
            "*RIGIDWALL_PLANAR\n0\n" + wall.format(50, 0, 0, 49, 0, 0) + "\n"
            "*RIGIDWALL_PLANAR_ID\n2,floor\n0\n" + wall.format(0, 0, 0, 1, 0, 0) + "\n"
            "*RIGIDWALL_PLANAR\n0\n" + wall.format(60, 0, 0, 59, 0, 0) + "\n"
            "*DATABASE_RWFORC\n1e-6,3\n*END\n"
        )
        self.write(deck)
        self.nugget("run", "model.k", "-o", "out", "--quiet")
        text = self.read("out/rwforc")
        rows = [line.split() for line in text.splitlines() if re.match(r" +\d\.\d+E", line)]
        self.assertEqual([row[1] for row in rows[-3:]], ["1", "2", "3"])
        self.assertGreater(max(float(row[2]) for row in rows if row[1] == "2"), 0.0)
        self.assertRegex(text, r"\n +2 +floor")
        self.write(deck.replace("2,floor", "42,floor"))
        self.nugget("run", "model.k", "-o", "other", "--quiet")
        text = self.read("other/rwforc")
        rows = [line.split() for line in text.splitlines() if re.match(r" +\d\.\d+E", line)]
        self.assertEqual([row[1] for row in rows[-3:]], ["1", "42", "3"])
        self.assertRegex(text, r"\n +42 +floor")
        ids = struct.pack("<3i", 1, 42, 3)
        self.assertIn(ids, (self.folder / "other/binout0000").read_bytes())

    def test_stiffness_of_a_joint_and_the_springs_asked_for(self):
        stiffness = (
            "*DEFINE_COORDINATE_SYSTEM\n1,0.0,0.0,0.0,1.0,0.0,0.0\n0.0,1.0,0.0\n"
            "*DEFINE_CURVE\n20\n-10.0,-100.0\n10.0,100.0\n"
            "*CONSTRAINED_JOINT_STIFFNESS_GENERALIZED\n7,1,2,1,1\n0,20,0\n\n\n*DATABASE_HISTORY_DISCRETE\n12\n"
        )
        for binary in (1, 2):
            self.write(DECK.format(requests=requests(binary) + stiffness))
            self.nugget("run", "model.k", "-o", f"out{binary}", "--quiet")
        spring = dict(states(self.read("out1/deforc"))[-1])
        self.assertEqual(spring["spring/damper number"], 12)
        self.assertEqual(len(states(self.read("out1/deforc"))[-1]), 7)
        row = dict(states(self.read("out1/jntforc"))[-1])
        self.assertEqual(row["joint stiffness id number"], 7)
        angle = math.radians(row["theta (degrees)"])
        self.assertGreater(angle, 0.01)
        # The hinge gives way a little.
        self.assertAlmostEqual(2.0 * math.sin(angle), spring["change in length"], delta=0.01 * spring["change in length"])
        self.assertAlmostEqual(row["theta-moment-total"], 10.0 * angle, delta=1e-4)
        self.assertEqual(row["phi moment-total"], 0.0)
        self.assertAlmostEqual(row["joint energy"], 5.0 * angle * angle, delta=1e-3 * angle)
        data = (self.folder / "out2/binout0000").read_bytes()
        for name in (b"/jntforc/type1/d000002", b"/jntforc/joints/d000002", b"joint_extra2"):
            self.assertIn(name, data)

    def test_modes_with_springs_and_joints(self):
        linear = "*CONTROL_IMPLICIT_GENERAL\n         1       1.0\n*CONTROL_IMPLICIT_EIGENVALUE\n         7\n"
        self.write(DECK.format(requests=linear))
        self.nugget("run", "model.k", "-o", "out", "--quiet")
        modes = json.loads(self.read("out/summary.json"))["modes"]
        # The truss moves freely along itself, and is held across, where nothing resists (decision 0164); the rod swings on
        # springs of 150 at 2 about its hinge; the truss stretches.
        self.assertRegex(self.read("out/run.log"), r"\b4 directions of nodes are held, since nothing resists motion in them")
        expected = 0.0, math.sqrt(150 * 4 / (0.6667 + 2)), 20.0
        for mode, omega in zip(modes, expected):
            self.assertAlmostEqual(2 * math.pi * mode["frequency_hz"], omega, delta=1e-3 * omega + 1e-2)

    def test_linear_statics_with_a_hinge(self):
        """A load of 30 less its weight at the rod's middle: the springs of 150 at its end and the hinge carry half each."""
        linear = ("*CONTROL_IMPLICIT_GENERAL\n         1       1.0\n*CONTROL_IMPLICIT_SOLUTION\n         1\n"
                  "*BOUNDARY_SPC_NODE\n" + "".join(f"{n:10d}         0         1         1         1\n" for n in (6, 7)) +
                  "*LOAD_RIGID_BODY\n         2         3         8\n*DEFINE_CURVE\n         8\n"
                  "                 0.0                30.0\n                 1.0                30.0\n"
                  "*DATABASE_JNTFORC\n       0.1         1\n")
        self.write(DECK.format(requests=linear))
        self.nugget("run", "model.k", "-o", "out", "--quiet")
        log = self.read("out/run.log")
        largest = re.search(r"largest displacement +(\S+) at node +(\d+)", log)
        load = 30.0 - 2.0 * 9.81
        self.assertAlmostEqual(float(largest[1]), 0.5 * load / 150.0, delta=1e-6)
        self.assertEqual(largest[2], "5")
        self.assertAlmostEqual(dict(states(self.read("out/jntforc"))[-1])["z-force"], -0.5 * load, delta=1e-3)


if __name__ == "__main__":
    unittest.main()
