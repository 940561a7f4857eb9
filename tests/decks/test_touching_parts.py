# SPDX-License-Identifier: Apache-2.0
"""*CONTACT_AUTOMATIC_SINGLE_SURFACE_TIED by the command: what check prints, what modes find, what is refused."""
import math
import unittest

from nugget_command import CommandTest
from under_mpirun import ENVIRONMENT, MPIRUN, mpirun

LENGTH, WIDTH, THICKNESS, YOUNG, DENSITY = 200.0, 20.0, 2.0, 210000.0, 7.85e-9
ROOTS = (4.730040745, 7.853204624, 10.99560784)


def card(*values):
    return "".join(f"{v:>10}" for v in values) + "\n"


def bending(height):
    """Of a free beam, Hz."""
    return [r * r / (2 * math.pi * LENGTH ** 2) * height * math.sqrt(YOUNG / 12 / DENSITY) for r in ROOTS]


def plates(gap=0.0, close=0.05, contact="", extra="", along=(40, 27), across=(2, 2), implicit=True):
    """Two strips on each other, free in space."""
    text = "*KEYWORD\n*CONTROL_IMPLICIT_GENERAL\n" + card(int(implicit), 1.0) + "*CONTROL_IMPLICIT_EIGENVALUE\n" + card(20)
    text += "*CONTROL_TERMINATION\n" + card("1.0e-5") + "*MAT_ELASTIC\n" + card(1, DENSITY, YOUNG, 0.0)
    text += contact or ("*CONTACT_AUTOMATIC_SINGLE_SURFACE_TIED_ID\n" + card(7) + card(0, 0, 5) + "\n\n" + card(close))
    nodes = shells = ""
    last_node = last_shell = 0
    for part in (1, 2):
        text += "*SECTION_SHELL\n" + card(part, 16, 0.8333, 5) + card(*[THICKNESS] * 4) + "*PART\nplate\n" + card(part, part, 1)
        n, m, first = along[part - 1], across[part - 1], last_node + 1
        node = lambda i, j: first + j * (n + 1) + i  # noqa: B023, E731
        for j in range(m + 1):
            for i in range(n + 1):
                last_node += 1
                nodes += f"{last_node:8}{LENGTH * i / n:16.9g}{WIDTH * j / m:16.9g}{(part - 1) * (THICKNESS + gap):16.9g}\n"
        for j in range(m):
            for i in range(n):
                last_shell += 1
                shells += "".join(f"{v:8}" for v in (last_shell, part, node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1))) + "\n"
    return text + extra + "*NODE\n" + nodes + "*ELEMENT_SHELL\n" + shells + "*END\n"


class TouchingParts(CommandTest):
    def frequencies(self, folder):
        found = []
        for line in self.read(f"{folder}/run.log").splitlines():
            words = line.split()
            if len(words) == 6 and words[0].isdigit() and "rigid" not in line:
                found.append(float(words[1]))
        return found

    def test_modes_are_those_of_one_plate(self):
        self.write(plates())
        run = self.nugget("check", "model.k", "-o", "audit")
        pair = "part 1 on part 2: 123 nodes from (0, 0, 0) to (200, 20, 0), surfaces touching"
        self.assertIn("ties parts that touch, distances [mm]:\n " + pair, run.stdout)
        self.nugget("modes", "model.k", "-o", "modes")
        self.assertEqual(self.read("modes/run.log").count("rigid motion"), 6)
        self.assertIn(pair, self.read("modes/run.log"))
        found = self.frequencies("modes")
        for expected in bending(2 * THICKNESS):
            self.assertLess(min(abs(f - expected) for f in found), 5e-3 * expected)

    def test_apart_they_are_two(self):
        self.write(plates(gap=0.3))
        run = self.nugget("check", "model.k", "-o", "audit")
        self.assertIn("no parts touch (CLOSE 0.05): nothing is tied", run.stderr)
        self.nugget("modes", "model.k", "-o", "modes")
        self.assertEqual(self.read("modes/run.log").count("rigid motion"), 12)
        first = self.frequencies("modes")[0]
        self.assertLess(abs(first - bending(THICKNESS)[0]), 5e-3 * first)

    def test_ranks_and_threads_change_nothing(self):
        self.write(plates())
        self.nugget("modes", "model.k", "-o", "one", "-j1")
        self.nugget("modes", "model.k", "-o", "two", "-j2")
        self.assertEqual((self.folder / "one/d3eigv01").read_bytes(), (self.folder / "two/d3eigv01").read_bytes())
        if MPIRUN is None:
            self.skipTest("there is no mpirun")
        import subprocess
        for ranks in (2, 3):
            done = subprocess.run(mpirun(ranks, "modes", "model.k", "-o", f"ranks{ranks}", "-j1"), cwd=self.folder, env=ENVIRONMENT,
                                  capture_output=True, text=True, timeout=120)
            self.assertEqual(done.returncode, 0, done.stderr)
            for one, other in zip(self.frequencies("one"), self.frequencies(f"ranks{ranks}"), strict=True):
                self.assertLess(abs(one - other), 1e-6 * one)

    def test_what_is_refused(self):
        keyword = "*CONTACT_AUTOMATIC_SINGLE_SURFACE_TIED\n"
        for contact, expected in (
                (keyword + card(0, 0, 5) + "\n\n" + card(-1.0), "close = -1.0: expected 0 or more"),
                (keyword + card(0, 0, 5) + "\n" + card("", "", -1.0) + card(0.1), "sast = -1"),
                (keyword + card(1, 0, 4) + "\n\n" + card(0.1), "surfatyp = 4"),
                (keyword + card(0, 0, 5) + card(*[""] * 6, 1.0) + "\n" + card(0.1), "bt = 1")):
            with self.subTest(expected):
                self.write(plates(contact=contact))
                run = self.nugget("check", "model.k", "-o", "audit", expect=1)
                self.assertIn(expected, run.stderr)

    def test_a_card_of_options_is_none_of_close(self):
        self.write(plates(contact="*CONTACT_AUTOMATIC_SINGLE_SURFACE_TIED\n" + card(0, 0, 5) + "\n\n" + card(2, 0.1, 0)))
        self.assertIn("stands behind the last field of this card", self.nugget("check", "model.k", "-o", "audit").stderr)

    def test_an_explicit_run_does_not_have_it(self):
        self.write(plates(implicit=False))
        for command in ("check", "run"):
            run = self.nugget(command, "model.k", "-o", command, expect=1)
            self.assertIn("an explicit run does not have it", run.stderr)
        self.nugget("modes", "model.k", "-o", "modes")

    def test_statics(self):
        """Clamped at one end, bent at the other: F L^3 / (3 E I)."""
        row = 41
        held = "".join(f"{1 + j * row + offset:10}{0:10}" + "".join(f"{1:10}" for _ in range(6)) + "\n"
                       for offset in (0, 123) for j in range(3))
        load = "*LOAD_NODE_POINT\n" + "".join(card(row * (j + 1), 3, 1, share) for j, share in enumerate((0.25, 0.5, 0.25)))
        extra = ("*BOUNDARY_SPC_NODE\n" + held + load + "*DEFINE_CURVE\n" + card(1) + f"{0:20}{1:20}\n{1:20}{1:20}\n"
                 "*CONTROL_IMPLICIT_SOLUTION\n" + card(1) + "*DATABASE_NODOUT\n" + card(1.0) + "*DATABASE_HISTORY_NODE\n" + card(82))
        self.write(plates(along=(40, 40), across=(2, 2), extra=extra).replace("*CONTROL_IMPLICIT_EIGENVALUE\n" + card(20), ""))
        self.nugget("run", "model.k", "-o", "statics")
        row = [line for line in self.read("statics/nodout").splitlines() if line.split()[:1] == ["82"]][-2]  # the last has its rotations
        moved = float(row.split()[3])
        expected = LENGTH ** 3 / (3 * YOUNG * WIDTH * (2 * THICKNESS) ** 3 / 12)
        self.assertLess(abs(moved - expected), 1e-3 * expected, (moved, expected))


if __name__ == "__main__":
    unittest.main()
