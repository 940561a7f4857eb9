# SPDX-License-Identifier: Apache-2.0
"""A column of an I-section (*INTEGRATION_BEAM) that is hit amid and flows, with a brace of points of the user: the same bytes with any
number of threads, lanes and ranks and across a restart; its energy; what elout has of its points; in a mirrored file."""
import subprocess
import unittest

import lsda
from few_elements import card, nodes, part
from repeated_runs import RepeatedRuns
from under_mpirun import ENVIRONMENT, MPIRUN, mpirun

STEEL = "*MAT_PIECEWISE_LINEAR_PLASTICITY\n" + card(1, 7.85e-9, 2.0e5, 0.3, 355.0, 1000.0) + card(1300.0, 5.0) + card(0.0) + card(0.0)
END = 4e-3


def column(count=20, *, erosion=True, speed=60000.0, end=END):
    """3 m of I-section held at both ends, its middle third hit along the web's normal, and three braces."""
    height = 3000.0
    places = [(0.0, 0.0, height * i / count) for i in range(count + 1)] + [(100.0, 0.0, 1500.0)]
    third = len(places)
    beams = [(1, i + 1, i + 2, third) for i in range(count)]
    places += [(0.0, 800.0, 0.0), (0.0, 800.0, height), (800.0, 0.0, 100.0)]
    beams += [(2, third + 1, count // 3 + 1, third + 3), (2, third + 2, 2 * count // 3 + 1, third + 3)]
    held = [1, count + 1, third + 1, third + 2]
    text = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(end) + "*CONTROL_ENERGY\n" + card(2, 2, 2, 2)
    text += "".join(f"*DATABASE_{name}\n" + card(end / 20, 3) for name in ("GLSTAT", "MATSUM", "NODOUT", "ELOUT"))
    text += "*DATABASE_BINARY_D3PLOT\n" + card(end / 4) + "*DATABASE_EXTENT_BINARY\n" + card("") + card("", "", 24)
    text += STEEL + ("*MAT_ADD_EROSION\n" + card(1, "", "", "", -0.02) + card("") if erosion else "")
    text += "*SECTION_BEAM\n" + card(1, 1, 0.0, -1) + card(0.0) + card(2, 1, 1.0, -2, 2) + card(60.0, 60.0, 40.0, 40.0)
    text += "*INTEGRATION_BEAM\n" + card(1, 0, 0.0, 1) + card(173.2, 15.7, 363.4, 9.1)
    text += "*INTEGRATION_BEAM\n" + card(2, 3, 0.5) + card(-0.8, -0.8, 0.4) + card(0.8, -0.8, 0.3) + card(-0.8, 0.8, 0.3)
    text += part(1) + part(2, 2) + nodes(places) + "*ELEMENT_BEAM\n"
    text += "".join(f"{e:8}" + "".join(f"{n:8}" for n in row) + "\n" for e, row in enumerate(beams, 1))
    text += "*BOUNDARY_SPC_NODE\n" + "".join(card(n, 0, 1, 1, 1, 1, 1, 1) for n in (*held, third, third + 3))
    text += "*INITIAL_VELOCITY_NODE\n" + "".join(card(n, 0.3 * speed, speed, 0.0) for n in range(count // 3 + 2, 2 * count // 3 + 1))
    return text + "*DATABASE_HISTORY_BEAM\n" + card(count // 2, count + 1) + "*DATABASE_HISTORY_NODE\n" + card(count // 2 + 1) + "*END\n"


class BeamSections(RepeatedRuns):
    def test_same_bits_and_restart(self):
        self.write(column(end=2e-3))
        files = self.compare("model.k")
        self.assertLessEqual({"d3plot", "d3plot01", "glstat", "matsum", "elout", "nodout"}, set(files))
        self.assertIn("eroded", self.read("t1/run.log") + self.read("t1/glstat"))
        self.resumed(column(end=2e-3), shares=(0.5,))

    @unittest.skipUnless(MPIRUN, "mpirun is not installed")
    def test_same_bits_over_ranks(self):
        self.write(column())
        self.nugget("run", "model.k", "-o", "one", "-j", 1, "--quiet")
        run = subprocess.run(mpirun(2, "run", "model.k", "-o", "two", "-j", 1, "--quiet"), capture_output=True, text=True, timeout=200,
                             cwd=self.folder, env=ENVIRONMENT)
        self.assertEqual(run.returncode, 0, run.stderr + run.stdout)
        self.assertEqual(self.bits("one"), self.bits("two"))

    def test_energy_closes_and_points_are_listed(self):
        self.write(column(erosion=False))
        self.nugget("run", "model.k", "-o", "run", "--quiet")
        states = self.glstat("run/glstat")
        for state in states:
            self.assertAlmostEqual(state["total energy / initial energy"], 1.0, delta=0.01)
        self.assertGreater(states[-1]["internal energy"], 0.3 * states[0]["kinetic energy"])
        # 24 points of the I-section and 3 of the user's: elout numbers them.
        last = self.read("run/elout").split("e l e m e n t")[-1]
        for point in (1, 24):
            self.assertRegex(last, rf"(?m)^\s+{point}\s")
        self.assertNotRegex(last, r"(?m)^\s+25\s")

    def test_mirrored(self):
        """An angle, which no mirror leaves as it is, in a file that is mirrored: each node is the image of its own."""
        inner = column(erosion=False)
        angle = "*INTEGRATION_BEAM\n" + card(1, 0, 0.0, 3) + card(173.2, 15.7, 363.4, 9.1, 0.5, -1.0)
        inner = inner[:inner.index("*SECTION_BEAM")] + "*SECTION_BEAM\n" + card(1, 1, 0.0, -1) + card(0.0) + angle + part(1) + \
            "*PART\nother\n" + card(2, 1, 1) + inner[inner.index("*NODE"):]
        master = "*KEYWORD\n*INCLUDE_TRANSFORM\ninner.k\n\n\n\n1,\n*DEFINE_TRANSFORMATION\n1,\nSCALE,-1,1,1\n*END\n"
        self.write(inner, "inner.k")
        self.write(master)
        self.nugget("run", "inner.k", "-o", "plain", "--quiet")
        self.nugget("run", "model.k", "-o", "image", "--quiet")
        plain, image = (lsda.states(lsda.read(self.folder / name / "binout0000"), "nodout")[-1] for name in ("plain", "image"))
        moved = abs(plain["x_displacement"][0])
        self.assertGreater(moved, 1.0)
        for axis, sign in (("x", -1), ("y", 1), ("z", 1)):
            self.assertAlmostEqual(image[f"{axis}_displacement"][0], sign * plain[f"{axis}_displacement"][0], delta=1e-6 * moved)


if __name__ == "__main__":
    unittest.main()
