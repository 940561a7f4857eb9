# SPDX-License-Identifier: Apache-2.0
"""nugget run --precision single: near the answers of double precision, the same bits for any number of threads and lanes and
across a restart, in any units; what is of single precision is said, and what cannot be is refused."""
import re
import unittest

from few_elements import CORNERS, card, curve, nodes, part
from lap_joint import deck as lap_joint
from repeated_runs import FOREVER, RepeatedRuns
from test_same_bits import cubes_on_a_sheet

SINGLE = ("--precision", "single")
# Length, mass and time of a unit in mm, t, s.
UNITS = {"mm": (1.0, 1.0, 1.0), "m": (1e3, 1e-3, 1.0), "um": (1e-3, 1e-12, 1e-6)}


def struck(elform=2, ihq=6, units="mm", beside="", at=0.0, rates=False):
    """A clamped sheet of 8 x 8 shells of 5 mm, MAT_024, struck in its middle, and beside it two columns of three bricks that are
    thrown against a held end, one of MAT_003, one elastic: all flow, but the elastic one. `at`: where the origin is. `rates`: with C and P."""
    length, mass, time = UNITS[units]
    density, stress, speed = mass / length**3, mass / length / time**2, length / time
    node, shell, brick = [], [], []
    for j in range(9):
        node += [(1 + 9 * j + i, 5.0 * i, 5.0 * j, 0.0) for i in range(9)]
    for j in range(8):
        shell += [(1 + 8 * j + i, 1, *(1 + 9 * (j + b) + i + a for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)))) for i in range(8)]
    for c in (0, 1):
        first = 101 + 20 * c
        node += [(first + 4 * k + a, 60.0 + 20.0 * c + 4.0 * x, 4.0 * y, 4.0 * k)
                 for k in range(4) for a, (x, y) in enumerate(((0, 0), (1, 0), (1, 1), (0, 1)))]
        brick += [(101 + 10 * c + k, 2 + c, *(first + 4 * k + a for a in range(8))) for k in range(3)]
    edge = [i for i, x, y, _ in node if i < 100 and (x in (0.0, 40.0) or y in (0.0, 40.0))]
    middle = [i for i, x, y, _ in node if i < 100 and 15.0 <= x <= 25.0 and 15.0 <= y <= 25.0]
    steel = (f"{7.85e-9 / density:.6g}", f"{2.1e5 / stress:.6g}", 0.3)
    numbers = lambda ids: "".join(card(*ids[i:i + 8]) for i in range(0, len(ids), 8))  # noqa: E731
    return "".join([
        "*KEYWORD\n*CONTROL_TERMINATION\n", card(f"{2e-4 / time:.6g}"), "*DATABASE_GLSTAT\n", card(f"{1e-5 / time:.6g}"),
        "*DATABASE_BINARY_D3PLOT\n", card(f"{1e-4 / time:.6g}"), "*CONTROL_SHELL\n", card(20, 0, 0, 1), "*CONTROL_ENERGY\n", card(2),
        "*SECTION_SHELL\n", card(1, elform, 0.8333, 5), card(*4 * [f"{1.0 / length:.6g}"]), "*SECTION_SOLID\n", card(2, 1),
        "*HOURGLASS\n", card(1, ihq, 1.0 if ihq == 6 else 0.1),
        "*MAT_PIECEWISE_LINEAR_PLASTICITY\n", card(1, *steel, f"{300.0 / stress:.6g}", f"{1000.0 / stress:.6g}"),
        card(f"{40.4 * time:.6g}", 5) if rates else card(), card(), card(),
        "*MAT_PLASTIC_KINEMATIC\n", card(2, *steel, f"{300.0 / stress:.6g}", f"{1000.0 / stress:.6g}", 0.5), card(), "*MAT_ELASTIC\n", card(3, *steel),
        "*PART\nsheet\n", card(1, 1, 1), "*PART\nbricks\n", card(2, 2, 2, 0, 1), "*PART\nelastic\n", card(3, 2, 3, 0, 1),
        "*NODE\n", *(f"{i:8d}" + "".join(f"{(at + c) / length:16.9g}" for c in x) + "\n" for i, *x in node),
        "*ELEMENT_SHELL\n", *("".join(f"{n:8d}" for n in e) + "\n" for e in shell),
        "*ELEMENT_SOLID\n", *("".join(f"{n:8d}" for n in e[:2]) + "\n" + "".join(f"{n:8d}" for n in e[2:]) + "\n" for e in brick),
        "*SET_NODE_LIST\n", card(1), numbers([*edge, 101, 102, 103, 104, 121, 122, 123, 124]),
        "*BOUNDARY_SPC_SET\n", card(1, 0, *6 * [1]), "*SET_NODE_LIST\n", card(2), numbers(middle),
        "*SET_NODE_LIST\n", card(3), numbers([*range(105, 117), *range(125, 137)]),
        "*INITIAL_VELOCITY\n", card(2), card(0, 0, f"{-6e4 / speed:.6g}"),
        "*INITIAL_VELOCITY\n", card(3), card(f"{2e3 / speed:.6g}", 0, f"{-2e4 / speed:.6g}"), beside, "*END\n"])


class Precision(RepeatedRuns):
    def energies(self, folder):
        energy = self.json(f"{folder}/summary.json")["energy"]
        return {name: energy[name] for name in ("kinetic", "internal", "hourglass", "ratio")}

    def both(self, text, name="model"):
        """Energies at the end of a run of double and of one of single precision."""
        self.write(text, f"{name}.k")
        for precision in ("double", "single"):
            self.nugget("run", f"{name}.k", "-o", f"{name}_{precision}", "--quiet", "--precision", precision)
        return self.energies(f"{name}_double"), self.energies(f"{name}_single")

    def test_energies_are_those_of_double_precision(self):
        for elform, ihq in ((2, 2), (2, 5), (16, 6)):
            with self.subTest(elform=elform, ihq=ihq):
                double, single = self.both(struck(elform, ihq))
                self.assertGreater(double["internal"], 1.5 * double["kinetic"], "they yield")
                whole = double["internal"] + double["kinetic"]
                for name in ("kinetic", "internal", "hourglass"):
                    self.assertLess(abs(single[name] - double[name]), 2e-6 * whole, name)
                self.assertLess(abs(single["ratio"] - 1.0), 1e-6)
                self.assertNotEqual(single["internal"], double["internal"], "it is of single precision")

    def test_any_units(self):
        """Stresses in Pa to the seventh power, or lengths to the power of 24, are no floats."""
        for elform, ihq, rates in ((2, 2, False), (2, 6, True), (16, 6, True)):
            energies = []
            for units, (length, mass, time) in UNITS.items():
                self.write(struck(elform, ihq, units, rates=rates))
                self.nugget("run", "model.k", "-o", "out", "--quiet", *SINGLE)
                energy = self.energies("out")
                energies.append([energy[name] * mass * length**2 / time**2 for name in ("kinetic", "internal", "hourglass")])
            for other in energies[1:]:
                for one, two in zip(energies[0], other):
                    self.assertLess(abs(one - two), 1e-5 * sum(energies[0]), energies)

    def test_far_from_the_origin(self):
        """A hundred metres away a float of a place would have steps of 8 micrometres: of the strains at yield, a hundredth of them is left."""
        here, there = self.both(struck(), "here")[1], self.both(struck(at=1e5), "there")[1]
        whole = here["internal"] + here["kinetic"]
        for name in ("kinetic", "internal", "hourglass"):
            self.assertLess(abs(there[name] - here[name]), 2e-6 * whole, name)

    def test_same_bits(self):
        self.compare(self.write(struck(2, 5)), *SINGLE)
        self.compare(self.write(struck(16, 6)), *SINGLE)

    def test_same_bits_under_the_assembled_step_and_beside_welds(self):
        self.compare(self.write(cubes_on_a_sheet()), *SINGLE)
        self.compare(self.write(lap_joint(("     300.0    1000.0\n       0.0       0.0\n", "     300.0    1000.0     0.005\n       0.0       0.0\n"))), *SINGLE)

    def test_same_bits_with_damping_and_mass_scaling(self):
        text = struck(beside="*DAMPING_PART_STIFFNESS\n" + card(1, 0.05) + "*DAMPING_FREQUENCY_RANGE_DEFORM\n" + card(0.02, 100.0, 10000.0))
        text = text.replace("*SECTION_SHELL\n", "*CONTROL_TIMESTEP\n" + card(0, "", 0, 0, -7e-7) + "*SECTION_SHELL\n", 1)
        self.compare(self.write(text), *SINGLE)
        self.assertGreater(self.json("t1/summary.json")["mass"]["added"], 0.0)

    def test_restart(self):
        self.resumed(struck(2, 6), *SINGLE, shares=(0.3, 0.8))

    def test_another_precision_is_refused_at_a_restart(self):
        self.write(struck())
        for begun, other in (("single", "double"), ("double", "single")):
            self.nugget("run", "model.k", "-o", begun, "--quiet", "--precision", begun, "--checkpoint", "20cycles", "--max-cycles", 30)
            said = self.nugget("run", "--resume", begun, "--quiet", "--precision", other, *FOREVER, expect=1)
            self.assertIn(f"--precision {other}: the run was begun with {begun} precision", said.stderr)
            self.nugget("run", "--resume", begun, "--quiet", "--precision", begun, *FOREVER)
            self.assertEqual(self.json(f"{begun}/summary.json")["precision"], begun)

    def test_what_is_said(self):
        self.write(lap_joint())
        self.nugget("run", "model.k", "-o", "double", "--quiet")
        summary = self.json("double/summary.json")
        self.assertEqual(summary["precision"], "double")
        self.assertNotIn("Precision", self.read("double/run.log"))
        said = self.nugget("run", "model.k", "-o", "single", *SINGLE).stderr
        summary = self.json("single/summary.json")
        self.assertEqual((summary["precision"], summary["elements_by_precision"]), ("single", {"single": 18, "double": 1}))
        log = re.search(r"Precision of the elements.*?\n\n(.*?)\n\n", self.read("single/run.log"), re.S)[1]
        self.assertEqual([line.split() for line in log.splitlines()],
                         ["single:".split(), *(["part", part, "9", "shells", "ELFORM", "2,", "*MAT_PIECEWISE_LINEAR_PLASTICITY"] for part in "12"),
                          "double, as they have no kernel in single precision:".split(), "part 3 1 beams ELFORM 9, *MAT_SPOTWELD".split()])
        self.assertIn("--precision single: 1 of 19 elements have no kernel in single precision", said)
        self.assertIn("18 of 19 elements in single precision", said)
        page = self.read("single/report.html")
        self.assertIn('id="run-precision">single<', page)
        self.assertIn('id="elements_by_precision-double">1<', page)
        self.assertIn("--precision", self.nugget("run", "--help").stdout)

    def test_what_is_built_for_double_only_stays_double(self):
        """Triangles, and bricks of ELFORM 2: the same bits in both."""
        text = struck()
        shells = [line for line in text.splitlines() if re.fullmatch(r"( +\d+){6}", line)]
        for line in shells:  # every quadrilateral becomes a triangle
            nodes = re.findall(r".{8}", line)
            text = text.replace(line, "".join([*nodes[:5], nodes[4]]))
        text = text.replace("*SECTION_SOLID\n" + card(2, 1), "*SECTION_SOLID\n" + card(2, 2)).replace(card(1, 2, 0.8333, 5), card(1, 4, 0.8333, 5))
        self.write(text)
        self.nugget("run", "model.k", "-o", "a", "--quiet", "-j", 1)
        said = self.nugget("run", "model.k", "-o", "b", "--quiet", "-j", 1, *SINGLE)
        self.assertIn("no element of this deck has a kernel in single precision", said.stderr)
        self.assertEqual(self.bits("a")["glstat"], self.bits("b")["glstat"])
        self.assertEqual(self.json("b/summary.json")["elements_by_precision"]["single"], 0)

    def test_many_cycles_are_warned_of(self):
        """A shell that is stretched evenly over 320,000 cycles takes an energy that is wrong by no more than a percent; it is said."""
        cycles, step = 320000, 1e-7
        speed = 1e-3 / (cycles * step)
        self.write("".join([
            "*KEYWORD\n*CONTROL_TERMINATION\n", card(f"{cycles * step:.6g}"), "*CONTROL_TIMESTEP\n", card(0, 0.9, 0, 0, 0, 1), curve(1, (0, step), (1, step)),
            "*MAT_ELASTIC\n", card(1, 7.85e-9, 2.1e5, 0), "*SECTION_SHELL\n", card(1, 2), card(1, 1, 1, 1), part(1), nodes(CORNERS[:4]),
            "*ELEMENT_SHELL\n", "".join(f"{n:8d}" for n in (1, 1, 1, 2, 3, 4)), "\n*SET_NODE_LIST\n", card(1), card(1, 4), "*SET_NODE_LIST\n", card(2), card(2, 3),
            "*BOUNDARY_SPC_SET\n", card(1, 0, *6 * [1]), "*BOUNDARY_PRESCRIBED_MOTION_SET\n", card(2, 1, 0, 2), curve(2, (0, speed), (1, speed)), "*END\n"]))
        energy = {}
        for precision in ("double", "single"):
            said = self.nugget("run", "model.k", "-o", precision, "-j", 1, "--precision", precision, "--quiet").stderr
            self.assertEqual("cycles in single precision: stresses that are built up evenly over more than 300000" in said, precision == "single", said)
            energy[precision] = self.energies(precision)["internal"]
        self.assertAlmostEqual(energy["double"], 0.5 * 2.1e5 * 1e-3**2, delta=1e-3 * energy["double"])
        self.assertLess(abs(energy["single"] / energy["double"] - 1.0), 0.01)

    def test_what_cannot_be(self):
        implicit = "*CONTROL_IMPLICIT_GENERAL\n" + card(1) + "*CONTROL_IMPLICIT_EIGENVALUE\n" + card(4)
        self.write(struck(beside=implicit))
        self.assertIn("this deck asks for an implicit solution", self.nugget("run", "model.k", *SINGLE, expect=2).stderr)
        self.write(struck(beside=implicit.replace(card(1), card(6), 1)))
        self.assertIn("this deck asks for modes after the run (IMFLAG 6)", self.nugget("run", "model.k", *SINGLE, expect=2).stderr)
        self.assertIn("'half', expected single or double", self.nugget("run", "model.k", "--precision", "half", expect=2).stderr)


if __name__ == "__main__":
    unittest.main()
