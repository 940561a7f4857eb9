# SPDX-License-Identifier: Apache-2.0
"""secforc, elout and nodfor of a small welded deck, as the files that an engineer opens."""
import math
import re
import unittest

from lap_joint import deck
from nugget_command import CommandTest

CARDS = """\
*DATABASE_SECFORC
  5.00e-06         3
*DATABASE_ELOUT
  5.00e-06         3
*DATABASE_NODFOR
  5.00e-06         3
*DATABASE_NODAL_FORCE_GROUP
         1
*DATABASE_HISTORY_SHELL_ID
        11 at the clamp
*DATABASE_HISTORY_BEAM
        31
*DATABASE_CROSS_SECTION_PLANE_ID
        71lower sheet
        81       3.0       0.0       0.0       4.0       0.0       0.0
       0.0       0.0       0.0
*SET_PART_LIST
        81
         1
*DATABASE_EXTENT_BINARY
         0         0         3         1
         0         0         4
*DATABASE_GLSTAT
"""


class Histories(CommandTest):
    @classmethod
    def text(cls):
        return deck(("*DATABASE_GLSTAT\n", CARDS), ("*DATABASE_SWFORC\n  1.00e-06", "*DATABASE_SWFORC\n  5.00e-06"))

    def test_files_of_a_lap_joint(self):
        self.write(self.text())
        self.nugget("run", "model.k", "--quiet")

        section = self.read("secforc")
        self.assertIn("       71     lower sheet", section)
        states = re.findall(r"^ +71 +(\S+)((?: +\S+){4})\n.{27}((?: +\S+){4})\n {27}((?: +\S+){4})\n", section, re.M)
        self.assertEqual(len(states), 5)
        force, _, centroid = ([float(x) for x in columns.split()] for columns in states[-1][1:])
        self.assertGreater(force[0], 100.0, "the lower sheet is in tension")
        self.assertAlmostEqual(force[3], math.hypot(*force[:3]), delta=1e-3 * force[3])
        self.assertAlmostEqual(centroid[0], 3.0, delta=0.01)
        self.assertAlmostEqual(centroid[1], 9.0, delta=0.01)
        self.assertAlmostEqual(centroid[3], 18.0 * 1.2, delta=0.05)

        elements = self.read("elout")
        self.assertIn("       11     at the clamp", elements)
        shells = re.findall(r"^ +11- +1\n((?: +\d-  0 \w+ +.*\n){3})", elements, re.M)
        self.assertEqual(len(shells), 5, "three layers at each time")
        self.assertEqual(len(re.findall(r"^ lower ipt", elements, re.M)), 5)
        beams = re.findall(r"beam/truss # = +31 +part ID  = +3 +material type= +100\n\n resultants.*\n((?: +\S+){6})\n",
                           elements)
        self.assertEqual(len(beams), 5)
        axial, shear_s, shear_t = (float(x) for x in beams[-1].split()[:3])
        weld = self.read("swforc").splitlines()[-1].split()
        self.assertAlmostEqual(axial, float(weld[1]), delta=2e-3 * abs(axial) + 1e-9)
        self.assertAlmostEqual(math.hypot(shear_s, shear_t), float(weld[2]), delta=2e-3 * float(weld[2]))

        groups = self.read("nodfor")
        total = re.findall(r"xtotal= *(\S+)", groups)
        self.assertEqual(len(total), 5)
        self.assertLess(float(total[-1]), -100.0, "the clamp holds the sheet back")

        binary = (self.folder / "binout0000").read_bytes()
        for branch in ("secforc", "nodfor", "elout/shell", "elout/beam"):
            self.assertIn(f"/{branch}/d000005".encode(), binary)

    def test_an_interval_far_below_the_step_writes_every_cycle(self):
        """And the run ends. Sabotage: marks that are counted up one by one."""
        self.write(self.text().replace("*DATABASE_SWFORC\n  5.00e-06", "*DATABASE_SWFORC\n  1.00e-30"))
        self.nugget("run", "model.k", "--quiet", "--max-cycles", 20)
        self.assertEqual(self.read("swforc").count("constraint #"), 21)

    def test_strains_reach_d3plot(self):
        self.write(self.text())
        self.nugget("run", "model.k", "--quiet")
        plain = self.folder / "plain"
        self.write(self.text().replace("         0         0         3         1\n", "         0         0         3         0\n"),
                   "plain/model.k")
        self.nugget("run", "model.k", "--quiet", cwd=plain)
        size = {folder: sum(f.stat().st_size for f in folder.glob("d3plot*")) for folder in (self.folder, plain)}
        self.assertGreater(size[self.folder], size[plain])


if __name__ == "__main__":
    unittest.main()
