# SPDX-License-Identifier: Apache-2.0
"""A cell of bricks that repeats in two directions (*CONSTRAINED_LINEAR_GLOBAL) and is sheared by its driven reference nodes until it
flows: the same bytes with any number of threads, lanes and ranks and across a restart; its stress; what is refused."""
import subprocess
import unittest

from few_elements import CORNERS, card, nodes, part
from repeated_runs import RepeatedRuns
from under_mpirun import ENVIRONMENT, MPIRUN, mpirun

STEEL = "*MAT_PIECEWISE_LINEAR_PLASTICITY\n" + card(1, 7.85e-9, 2.1e5, 0.3, 250.0, 1000.0) + card(0.0) + card(0.0) + card(0.0)
SIDE, END = 8.0, 4e-4


def cell(n=4, *, more="", end=END, strain=0.02):
    """n^3 bricks, u(right) - u(left) = u(A) and u(upper) - u(lower) = u(B); A is driven along x, and along y both."""
    number = lambda i, j, k: 1 + i + (n + 1) * (j + (n + 1) * k)  # noqa: E731
    h = SIDE / n
    places = [(h * i, h * j, h * k) for k in range(n + 1) for j in range(n + 1) for i in range(n + 1)]
    bricks = [[number(i + a, j + b, k + c) for a, b, c in CORNERS] for k in range(n) for j in range(n) for i in range(n)]
    a, b = len(places) + 1, len(places) + 2
    places += [(0.0, 0.0, 50.0), (0.0, 0.0, 60.0)]
    text = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(end) + "*CONTROL_ENERGY\n" + card(2, 2, 2, 2)
    text += "".join(f"*DATABASE_{name}\n" + card(end / 20, 3) for name in ("GLSTAT", "MATSUM", "NODOUT", "ELOUT", "BNDOUT"))
    text += "*DATABASE_BINARY_D3PLOT\n" + card(end / 4) + STEEL + "*SECTION_SOLID\n" + card(1, 1) + part(1)
    text += "*DEFINE_CURVE\n" + card(1) + f"{0.0:20}{0.0:20}\n{0.8 * end:20}{1.0:20}\n{10 * end:20}{1.0:20}\n"
    for node, dof, size in ((a, 1, strain * SIDE), (b, 1, 0.5 * strain * SIDE)):
        text += "*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + card(node, dof, 2, 1, size)
    text += "*BOUNDARY_SPC_NODE\n" + card(a, 0, 0, 1, 1) + card(b, 0, 0, 1, 1) + card(number(0, 0, 0), 0, 1, 1, 1)
    equations = []
    for k in range(n + 1):
        for one in range(n + 1):
            equations += [(number(n, one, k), number(0, one, k), a), (number(one, n, k), number(one, 0, k), b)]
    count = 0
    for first, second, reference in equations:
        for dof in (1, 2, 3):
            count += 1
            text += "*CONSTRAINED_LINEAR_GLOBAL\n" + card(count) + card(first, dof, 1.0) + card(second, dof, -1.0) + card(reference, dof, -1.0)
    text += more + "*DATABASE_HISTORY_SOLID\n" + card(1, n * n * n) + "*DATABASE_HISTORY_NODE\n" + card(number(n, n, n), number(n, 0, 0), number(0, n, 0))
    text += nodes(places) + "*ELEMENT_SOLID\n" + "".join(f"{e:8}{1:8}" + "".join(f"{i:8}" for i in q) + "\n" for e, q in enumerate(bricks, 1))
    return text + "*END\n"


class LinearEquations(RepeatedRuns):
    def test_same_bits_and_restart(self):
        self.write(cell(3))
        files = self.compare("model.k")
        self.assertLessEqual({"d3plot", "glstat", "elout", "nodout", "bndout"}, set(files))
        self.resumed(cell(3), shares=(0.5,))

    @unittest.skipUnless(MPIRUN, "mpirun is not installed")
    def test_same_bits_over_ranks(self):
        self.write(cell())
        self.nugget("run", "model.k", "-o", "one", "-j", 1, "--quiet")
        run = subprocess.run(mpirun(3, "run", "model.k", "-o", "three", "-j", 1, "--quiet"), capture_output=True, text=True, timeout=200,
                             cwd=self.folder, env=ENVIRONMENT)
        self.assertEqual(run.returncode, 0, run.stderr + run.stdout)
        self.assertEqual(self.bits("one"), self.bits("three"))

    def test_corners_keep_apart_and_energy_closes(self):
        """Opposite corners have moved apart by what the reference nodes were driven; all the work is the support's."""
        self.write(cell())
        self.nugget("run", "model.k", "-o", "run", "--quiet")
        last = self.glstat("run/glstat")[-1]
        self.assertAlmostEqual(last["total energy / initial energy"], 1.0, delta=0.01)
        self.assertGreater(last["internal energy"], 50.0)
        self.assertAlmostEqual(last["external work"], last["internal energy"] + last["kinetic energy"], delta=0.02 * last["external work"])

    def test_what_is_refused(self):
        for more, words in (
                ("*CONSTRAINED_NODAL_RIGID_BODY\n" + card(1, 0, 7) + "*SET_NODE_LIST\n" + card(7) + card(1, 2, 6), "an equation cannot move it"),
                ("*CONSTRAINED_LINEAR_GLOBAL\n" + card(999) + card(1, 4, 1.0) + card(2, 4, -1.0), "has no rotary inertia"),
                ("*RIGIDWALL_PLANAR\n" + card(0) + card(0.0, 0.0, -1.0, 0.0, 0.0, 1.0), "is stopped by this wall, too"),
                ("*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + card(2, 3, 2, 1, 0.1, 0, 1e-4), "for a time only"),
                ("*CONTROL_SUBCYCLE\n", "linear equations between nodes")):
            with self.subTest(words):
                self.write(cell(2, more=more))
                run = self.nugget("run", "model.k", expect=1)
                self.assertIn(words, run.stdout + run.stderr)

    def test_nodes_that_move_alike(self):
        """*CONSTRAINED_NODE_SET: one mass of three, which gets the mean of their velocities by mass."""
        text = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(1e-3) + "*CONTROL_TIMESTEP\n" + card(0, 0.9, 0, 0, 0, 8) + "*DATABASE_NODOUT\n" + card(1e-3)
        text += "*DEFINE_CURVE\n" + card(8) + f"{0.0:20}{1e-5:20}\n{1.0:20}{1e-5:20}\n*DATABASE_HISTORY_NODE\n" + card(1, 3)
        text += "*ELEMENT_MASS\n" + "".join(f"{i:8}{i:8}{m:16}\n" for i, m in ((1, 1e-3), (2, 2e-3), (3, 5e-3)))
        text += "*SET_NODE_LIST\n" + card(4) + card(1, 2, 3) + "*CONSTRAINED_NODE_SET\n" + card(4, 4) + "*INITIAL_VELOCITY_NODE\n" + card(1, 800.0, 80.0, 5.0)
        self.write(text + nodes([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (5.0, 3.0, 0.0)]) + "*END\n")
        self.nugget("run", "model.k", "--quiet")
        rows = {}
        for line in self.read("nodout").splitlines():
            words = line.split()
            if len(words) == 13 and words[0] in ("1", "3"):
                rows[words[0]] = [float(w) for w in words[1:4]]
        for node in ("1", "3"):
            self.assertAlmostEqual(rows[node][0], 800.0 / 8 * 1e-3, delta=1e-6)
            self.assertAlmostEqual(rows[node][1], 80.0 / 8 * 1e-3, delta=1e-7)
        self.assertAlmostEqual(rows["1"][2], 5e-3, delta=1e-8)
        self.assertAlmostEqual(rows["3"][2], 0.0, delta=1e-12)


if __name__ == "__main__":
    unittest.main()
