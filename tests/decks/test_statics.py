# SPDX-License-Identifier: Apache-2.0
"""Linear statics by the command: files, stresses, weld forces, refusals, directions that nothing resists."""
import unittest

import lap_joint
from nugget_command import CommandTest

LINEAR = """*CONTROL_IMPLICIT_GENERAL
         1       1.0
*CONTROL_IMPLICIT_SOLUTION
         1
"""


def statics(*changes):
    """The lap joint as a linear solution: its end is pulled by 500 times 1e-5 at the end time."""
    return lap_joint.deck(("*TITLE\n", LINEAR + "*TITLE\n"),
                          ("         2         1         0         1\n", "         2         1         2         1    1.0e-05\n"),
                          *changes)


class Statics(CommandTest):
    def run_statics(self, text, **options):
        self.write(text)
        return self.nugget("run", "model.k", "-o", "out", "--quiet", **options)

    def test_what_a_user_gets(self):
        run = self.run_statics(statics())
        self.assertIn("Linear statics at the end time", run.stdout)
        for name in ("d3plot", "swforc", "nodout", "welds.csv", "run.log", "summary.json"):
            self.assertIn(name, self.files("out"))
        weld = self.json("out/summary.json")["weld"][0]
        held = [line for line in self.read("out/run.log").splitlines() if "forces of supports" in line][0].split()
        force = abs(float(held[3]))
        self.assertGreater(force, 1.0)
        # One weld carries all of it.
        self.assertAlmostEqual(weld["peak"]["shear"] / force, 1.0, delta=1e-3)

    def test_the_plot_has_stresses(self):
        self.run_statics(statics())
        seen = self.d3plot("out")
        self.assertEqual(len(seen["states"]), 2)

    def test_a_free_structure_is_told(self):
        text = statics(("         1         0         1         1         1         1         1         1\n",
                        "         1         0         1         1         0         0         0         0\n"))
        run = self.run_statics(text, expect=1)
        self.assertRegex(run.stderr, r"the structure is not held: node \d+ and what .* can move as a rigid body in \d ways")

    def test_a_nonlinear_run_is_refused(self):
        run = self.run_statics(statics(("*CONTROL_IMPLICIT_SOLUTION\n         1\n", "*CONTROL_IMPLICIT_SOLUTION\n        12\n")), expect=1)
        self.assertIn("nonlinear implicit solutions are not built", run.stderr)

    def test_a_check_says_what_the_run_refuses(self):
        """Sabotage: the check of a linear deck looks at it as at an explicit run, and finds nothing."""
        spin = "*LOAD_BODY_RX\n         1       1.0\n*SET_NODE_LIST\n         1\n"
        tracted = ("*LOAD_SEGMENT_NONUNIFORM\n1,1.0,,,,1.0\n101,102,106,105\n1.,1.,1.,1.\n")
        text = statics(("*SET_NODE_LIST\n         1\n", tracted + spin))
        for command in ("run", "check"):
            with self.subTest(command):
                self.write(text)
                said = self.nugget(command, "model.k", "-o", command, expect=1).stderr
                self.assertIn("centrifugal forces (*LOAD_BODY_RX, _RY, _RZ) are not built in linear statics", said)
                self.assertIn("*LOAD_SEGMENT_NONUNIFORM: this load is not built in linear statics", said)
        self.write(statics())
        self.assertIn("linear statics: materials are elastic", self.nugget("check", "model.k", "-o", "sound").stderr)

    def test_directions_without_resistance_are_counted(self):
        """A weld beam of discrete-beam kind is not needed: a brick's lone node does it."""
        node = "*NODE\n     900             1.0             1.0            50.0\n*ELEMENT_MASS\n     900     900          1.0e-6\n"
        self.run_statics(statics(("*SET_NODE_LIST\n         1\n", node + "*SET_NODE_LIST\n         1\n")))
        self.assertIn("3 directions of nodes are held", self.read("out/run.log"))


if __name__ == "__main__":
    unittest.main()
