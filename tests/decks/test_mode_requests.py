# SPDX-License-Identifier: Apache-2.0
"""*CONTROL_IMPLICIT_EIGENVALUE and IGS as a deck asks for them: intervals, centre, preload by stress and by load."""
import json
import math
import re
import struct
import unittest

from nugget_command import CommandTest

LENGTH, WIDTH, HEIGHT, YOUNG, DENSITY = 200.0, 20.0, 2.0, 210000.0, 7.85e-9
INERTIA = WIDTH * HEIGHT ** 3 / 12
EULER = math.pi ** 2 * YOUNG * INERTIA / LENGTH ** 2
ALONG, ACROSS = 24, 2


def frequency(n, force=0.0):
    """Bending frequency of a beam on two supports under an axial force."""
    wave = n * math.pi / LENGTH
    return wave * math.sqrt((YOUNG * INERTIA * wave ** 2 + force) / (DENSITY * WIDTH * HEIGHT)) / (2 * math.pi)


def card(*values):
    return "".join(f"{v:>10}" for v in values) + "\n"


def beam(eigenvalue, igs=2, extra="", load=0.0):
    """A strip of shells in plane bending, its right support sliding; `load` pulls there at ENDTIM."""
    row = ALONG + 1
    node = lambda i, j: 1 + j * row + i
    text = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(2.0)
    text += "*CONTROL_IMPLICIT_GENERAL\n" + card(1, 2.0, 2, 1, igs) + "*CONTROL_IMPLICIT_EIGENVALUE\n" + eigenvalue
    text += "*PART\nstrip\n" + card(1, 1, 1) + "*SECTION_SHELL\n" + card(1, 16, 0.833333, 2) + card(*[HEIGHT] * 4)
    text += "*MAT_ELASTIC\n" + card(1, DENSITY, YOUNG, 0.0) + "*NODE\n"
    for j in range(ACROSS + 1):
        for i in range(row):
            text += f"{node(i, j):8d}{LENGTH * i / ALONG:16.8f}{WIDTH * j / ACROSS:16.8f}{0:16.8f}\n"
    text += "*ELEMENT_SHELL\n"
    for j in range(ACROSS):
        for i in range(ALONG):
            corners = node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)
            text += "".join(f"{v:8d}" for v in (1 + j * ALONG + i, 1, *corners)) + "\n"
    text += "*BOUNDARY_SPC_NODE\n"
    for j in range(ACROSS + 1):
        for i in range(row):
            text += card(node(i, j), 0, int(i == 0), 1, int(i in (0, ALONG)), 1, 0, 1)
    if load:
        text += "*LOAD_NODE_POINT\n"
        for j in range(ACROSS + 1):
            share = 0.5 / ACROSS if j in (0, ACROSS) else 1 / ACROSS
            text += card(node(ALONG, j), 1, 7, f"{0.5 * load * share:.6g}")
        text += "*DEFINE_CURVE\n" + card(7) + "                 0.0                 0.0\n                 2.0                 2.0\n"
    return text + extra + "*END\n"


class ModeRequests(CommandTest):
    def frequencies(self, deck, *arguments, command="run"):
        self.nugget(command, self.write(deck), "-o", "out", "--quiet", *arguments)
        self.assertIn("no mode was missed", self.read("out/run.log"))
        return [m["frequency_hz"] for m in json.loads(self.read("out/summary.json"))["modes"]]

    def near(self, found, expected, share=1e-2):
        self.assertEqual(len(found), len(expected), found)
        for f, e in zip(found, expected):
            self.assertAlmostEqual(f / e, 1.0, delta=share)

    # f = 117.3, 469, 1055, 1876, 2931: sabotage by reading LFLAG as RFLAG.
    def test_intervals(self):
        f = [frequency(n) for n in range(1, 7)]
        self.near(self.frequencies(beam(card(3))), f[:3])
        self.near(self.frequencies(beam(card(9, 0.0, 1, 300.0, 1, 2000.0))), f[1:4])
        self.near(self.frequencies(beam(card(2, 0.0, 1, 300.0, 1, 2000.0))), f[1:3])
        self.near(self.frequencies(beam(card(2, 0.0, 1, 300.0))), f[1:3])
        self.near(self.frequencies(beam(card(9, 0.0, 0, 0.0, 1, 1500.0))), f[:3])
        self.near(self.frequencies(beam(card(2, 1000.0))), [f[1], f[2]])
        self.near(self.frequencies(beam(card(2, 1000.0, 1, 600.0))), f[2:4])
        self.near(self.frequencies(beam(card(3)), "-fmin", 300, "-fmax", 2000, command="modes"), f[1:4])

    def test_modes_have_no_end_time(self):
        """The mesh alone: `nugget modes` needs no ENDTIM, which a run does."""
        mesh = re.sub(r"\*CONTROL_[A-Z_]+\n[^*]*", "", beam(card(3)))
        self.assertNotIn("CONTROL", mesh)
        first = self.frequencies(mesh, "-n", 3, command="modes")[0]
        self.assertAlmostEqual(first / frequency(1), 1.0, delta=0.01)
        self.assertIn("no end time is given", self.nugget("run", "model.k", "-o", "run", expect=1).stderr)

    def test_formulations_of_this_analysis(self):
        """ISHELL and ISOLID, value by value."""
        deck = lambda *second: self.write(beam(card(3) + card(*second)))
        plain = self.frequencies(beam(card(3)))
        self.assertEqual(self.frequencies(beam(card(3) + card(0, 0, 16))), plain)
        run = self.nugget("check", deck(0, 0, 18))
        self.assertIn("ishell = 18: computed as 16", run.stdout + run.stderr)
        for second, text in (((0, 0, 25), "ishell = 25"), ((0, 0, 5), "ishell = 5"), ((5, 0, 0), "isolid = 5"), ((0, 1, 0), "ibeam = 1")):
            run = self.nugget("check", deck(*second), expect=1)
            self.assertIn(text, run.stdout + run.stderr)

    def test_isolid(self):
        """A cantilever of one brick through its height: as a fully integrated brick it is stiffer in bending."""
        def bar(elform, isolid):
            text = "*KEYWORD\n*CONTROL_IMPLICIT_GENERAL\n" + card(1, 1.0) + "*CONTROL_IMPLICIT_EIGENVALUE\n" + card(2) + card(isolid)
            text += "*PART\nbar\n" + card(1, 1, 1) + "*SECTION_SOLID\n" + card(1, elform) + "*MAT_ELASTIC\n" + card(1, DENSITY, YOUNG, 0.3)
            text += "*NODE\n"
            for i in range(9):
                for k, (y, z) in enumerate(((0, 0), (10, 0), (10, 10), (0, 10))):
                    text += f"{4 * i + k + 1:8d}{20.0 * i:16.8f}{y:16.8f}{z:16.8f}\n"
            text += "*ELEMENT_SOLID\n"
            for i in range(8):
                text += "".join(f"{v:8d}" for v in (i + 1, 1, *range(4 * i + 1, 4 * i + 9))) + "\n"
            text += "*BOUNDARY_SPC_NODE\n" + "".join(card(n, 0, 1, 1, 1) for n in range(1, 5))
            return text + "*END\n"
        one, full = self.frequencies(bar(1, 0)), self.frequencies(bar(2, 0))
        self.assertGreater(full[0], 1.02 * one[0])
        self.assertEqual(self.frequencies(bar(1, 2)), full)
        self.assertIn("formulation 2 (ISOLID)", self.read("out/run.log"))
        self.assertEqual(self.frequencies(bar(2, 1)), one)
        self.frequencies(bar(2, 0))
        self.assertNotIn("hourglass type 6", self.read("out/run.log"))

    def test_stresses_of_modes(self):
        """MSTRES: the largest bending stress of a mode of a beam on two supports is E t/2 (n pi / L)^2 times its
        amplitude. Sabotage: the stresses of the first mode in all states."""
        for wanted in (0, 1):
            self.frequencies(beam(card(3) + card(0, 0, 0, 0, wanted)))
            with open(self.folder / "out/d3eigv", "rb") as file:
                head = file.read()
            with open(self.folder / "out/d3eigv01", "rb") as file:
                data = file.read()
            control = struct.unpack("<64i", head[:256])
            nodes, globals_, shells, words = control[16], control[18], control[31], control[33]
            # Without stresses d3eigv has thickness and energy of shells only: a fifth of the file.
            self.assertEqual((words, control[43:47]), (33, (1000,) * 4) if wanted else (4, (999, 999, 999, 1000)))
            at_rest = struct.unpack(f"<{3 * nodes}f", head[256:256 + 12 * nodes])
            values = struct.unpack(f"<{len(data) // 4}f", data)
            one_state, rest = divmod(values.index(-999999.0), 3)
            self.assertEqual(rest, 0)
            for mode in range(3):
                state = values[mode * one_state:(mode + 1) * one_state]
                z = [a - b for a, b in zip(state[1 + globals_:][2:3 * nodes:3], at_rest[2::3])]
                records = state[1 + globals_ + 3 * nodes:]
                if not wanted:
                    self.assertEqual({records[e * words + 3] for e in range(shells)}, {0.0})
                    continue
                largest = max(abs(records[e * words + 7 * layer]) for e in range(shells) for layer in range(3))
                wave = (mode + 1) * math.pi / LENGTH
                expected = YOUNG * HEIGHT / 2 / math.sqrt(3) * wave ** 2 * max(map(abs, z))
                self.assertAlmostEqual(largest, expected, delta=0.02 * expected, msg=f"mode {mode + 1}")

    def test_comparison_after_renumbering(self):
        """Nodes with other ids at the same places are compared. Sabotage: ids alone."""
        deck = beam(card(3))
        self.frequencies(deck)
        lines, keyword = [], ""
        for line in deck.splitlines():
            if line.startswith("*"):
                keyword = line
            elif keyword == "*NODE":
                line = f"{int(line[:8]) + 5000:8d}" + line[8:]
            elif keyword == "*ELEMENT_SHELL":
                line = line[:16] + "".join(f"{int(line[i:i + 8]) + 5000:8d}" for i in range(16, 48, 8))
            elif keyword == "*BOUNDARY_SPC_NODE":
                line = f"{int(line[:10]) + 5000:10d}" + line[10:]
            lines.append(line)
        self.write("\n".join(lines) + "\n", "renumbered.k")
        run = self.nugget("modes", "renumbered.k", "-n", 3, "-o", "other", "--compare", "out", "--quiet")
        self.assertIn(f"over {25 * 3} nodes, 75 of them by their places", run.stdout)
        rows = [line.split(",") for line in self.read("other/mac.csv").splitlines()[2:]]
        for i, row in enumerate(rows):
            self.assertAlmostEqual(float(row[2 + i]), 1.0, delta=1e-5)

    def test_an_empty_interval_of_the_command(self):
        run = self.nugget("modes", self.write(beam(card(3))), "-fmin", 500, "-fmax", 100, "-o", "out", expect=2)
        self.assertIn("the interval is empty", run.stderr)

    def test_intervals_that_hold_nothing(self):
        run = self.nugget("run", self.write(beam(card(9, 0.0, 0, 0.0, 1, -5.0))), "-o", "out", expect=1)
        self.assertIn("there are no modes below frequency 0", run.stderr)

    def test_preload_by_stress(self):
        stress = "*INITIAL_STRESS_SHELL\n"
        for e in range(1, ALONG * ACROSS + 1):
            stress += card(e, 1, 1) + card(0, f"{-0.8 * EULER / (WIDTH * HEIGHT):.5f}", 0, 0, 0, 0, 0, 0)
        self.near(self.frequencies(beam(card(2), 1, stress)), [frequency(n, -0.8 * EULER) for n in (1, 2)])
        self.assertIn(f"geometric stiffness of {ALONG * ACROSS} elements", self.read("out/run.log"))
        self.near(self.frequencies(beam(card(2), 2, stress)), [frequency(1), frequency(2)])
        self.assertIn("IGS is 2", self.read("out/findings.json"))

    def test_preload_by_load(self):
        solution = "*CONTROL_IMPLICIT_SOLUTION\n" + card(1)
        curve = "*DEFINE_CURVE\n" + card(8) + "                 0.0                 0.0\n                 2.0                 2.0\n"
        deck = beam(card(-8), 1, solution + curve, 3 * EULER)
        self.near(self.frequencies(deck), [frequency(n, 3 * EULER) for n in (1, 2)])
        self.assertIn("linear statics at time 2", self.read("out/run.log"))
        buckled = self.nugget("run", self.write(beam(card(-8), 1, solution + curve, -1.05 * EULER)), "-o", "out", expect=3)
        self.assertIn("1 eigenvalues are negative", buckled.stderr)

    def test_preload_by_an_explicit_run(self):
        """IMFLAG 6: pulled up slowly and damped until it rests, then modes of what it carries. Sabotage: the stresses of
        time 0; a layer's weight left out."""
        damping = "*DAMPING_GLOBAL\n" + card(0, 4000.0)
        times = "*DEFINE_CURVE\n" + card(8) + "                 0.0                 0.0\n               0.004                 2.0\n"
        deck = beam(card(-8), 1, damping + times, 3 * EULER)
        deck = deck.replace(card(1, 2.0, 2, 1, 1), card(6, 2.0, 2, 1, 1)).replace("*CONTROL_TERMINATION\n" + card(2.0), "*CONTROL_TERMINATION\n" + card(0.004))
        deck = deck.replace("                 2.0                 2.0\n", "               0.002                 2.0\n               1.000                 2.0\n")
        self.nugget("run", self.write(deck), "-o", "out", "--quiet")
        modes = json.loads(self.read("out/modes/summary.json"))["modes"]
        self.near([m["frequency_hz"] for m in modes], [frequency(n, 3 * EULER) for n in (1, 2)])
        self.assertIn("the explicit run at time 0.004", self.read("out/modes/run.log"))
        self.assertGreater(json.loads(self.read("out/summary.json"))["cycles"], 1000)
        self.near(self.frequencies(deck, command="modes"), [frequency(1), frequency(2)])
        self.assertIn("before its explicit run", self.read("out/findings.json"))

    def test_what_has_died_in_the_explicit_run_takes_no_part(self):
        """A mass between two bars, thrown; one bar breaks, and the mass swings on the other. Sabotage: all elements live."""
        mass, area, length = 0.01, 10.0, 100.0
        deck = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(0.001) + "*CONTROL_IMPLICIT_GENERAL\n" + card(6, 0.001)
        deck += "*CONTROL_IMPLICIT_EIGENVALUE\n" + card(-8) + "*DEFINE_CURVE\n" + card(8)
        deck += "                 0.0                 0.0\n               0.001                 1.0\n"
        deck += "*SECTION_BEAM\n" + card(1, 3) + card(area) + "*MAT_ELASTIC\n" + card(1, DENSITY, YOUNG, 0.3)
        deck += "*MAT_PLASTIC_KINEMATIC\n" + card(2, DENSITY, YOUNG, 0.3, 21.0) + card(0.0, 0.0, 0.001)
        deck += "".join(f"*PART\nbar {p}\n" + card(p, 1, p) for p in (1, 2)) + "*NODE\n"
        for n, x in enumerate((0.0, length, 2 * length), start=1):
            deck += f"{n:8d}{x:16.4f}{0:16.4f}{0:16.4f}\n"
        deck += "*ELEMENT_BEAM\n" + "".join("".join(f"{v:8d}" for v in row) + "\n" for row in ((1, 1, 1, 2), (2, 2, 2, 3)))
        deck += "*ELEMENT_MASS\n" + f"{1:8d}{2:8d}{mass:16.6f}\n" + "*BOUNDARY_SPC_NODE\n"
        deck += card(1, 0, 1, 1, 1, 1, 1, 1) + card(2, 0, 0, 1, 1, 1, 1, 1) + card(3, 0, 1, 1, 1, 1, 1, 1)
        deck += "*INITIAL_VELOCITY_NODE\n" + card(2, -500.0) + "*END\n"
        self.nugget("run", self.write(deck), "-o", "out", "--quiet")
        (mode,) = json.loads(self.read("out/modes/summary.json"))["modes"]
        one = math.sqrt(YOUNG * area / length / (mass + 0.5 * DENSITY * area * length)) / (2 * math.pi)
        self.near([mode["frequency_hz"]], [one])

    def test_what_is_refused(self):
        solution = "*CONTROL_IMPLICIT_SOLUTION\n" + card(1)
        late = "*DEFINE_CURVE\n" + card(8) + "                 0.0                 5.0\n                 1.0                 2.0\n"
        run = self.nugget("run", self.write(beam(card(-8), 1, solution + late)), "-o", "out", expect=1)
        self.assertIn("they are built at ENDTIM", run.stderr)
        self.assertIn("asks 2 times for modes", run.stderr)
        run = self.nugget("run", self.write(beam(card(0), 1, solution)), "-o", "out", expect=1)
        self.assertIn("geometric stiffness is built in modes and responses", run.stderr)
        run = self.nugget("run", self.write(beam(card(-9), 1, solution)), "-o", "out", expect=1)
        self.assertIn("there is no curve 9", run.stderr)
        run = self.nugget("run", self.write(beam(card(9)).replace(card(1, 2.0, 2, 1, 2), card(6, 2.0, 2, 1, 2))), "-o", "out", expect=1)
        self.assertIn("the deck does not ask for any", run.stderr)


if __name__ == "__main__":
    unittest.main()
