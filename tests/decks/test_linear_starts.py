# SPDX-License-Identifier: Apache-2.0
"""Linear analyses of what a deck begins with: laws that pull otherwise than they push, springs with offsets, clearances and preloads, nodes that
are driven beside oblique supports, cards that take no part. Closed forms, a mass on springs."""
import csv
import math
import unittest

import lsda
from few_elements import CORNERS
from nugget_command import CommandTest

HEAD = "*KEYWORD\n*CONTROL_TERMINATION\n1.0,\n*DEFINE_CURVE\n77,\n0.0,1.0\n10.0,1.0\n"
STATICS = "*CONTROL_IMPLICIT_GENERAL\n1,1.0,\n*CONTROL_IMPLICIT_SOLUTION\n1,\n"


def spring(first, law, fields, offset=0.0, clearance=0.0, curve="", z=10.0, vector=0):
    """A spring from node 1 at the origin to node `first`, held 10 above it (or at z)."""
    return (f"*SECTION_DISCRETE\n{first},0,0,0,{clearance},\n,\n*PART\nspring\n{first},{first},{first}\n*MAT_SPRING_{law}\n{first},{fields},\n"
            f"*ELEMENT_DISCRETE\n{first},{first},1,{first},{vector},1.0,0,{offset}\n*NODE\n{first},0.0,0.0,{z}\n"
            f"*BOUNDARY_SPC_NODE\n{first},0,1,1,1\n{curve}")


def mass_on(*springs, held="1,1,0"):
    """A mass of 2 at the origin that moves along z."""
    return HEAD + "".join(springs) + f"*ELEMENT_MASS\n1,1,2.0\n*NODE\n1,0.0,0.0,0.0\n*BOUNDARY_SPC_NODE\n1,0,{held}\n*END\n"


def cable(first, place, preload=0.0, offset=0.0, stiffness=100.0):
    """A cable from node 1 at the origin to a held node."""
    x, y, z = place
    return (f"*SECTION_BEAM\n{first},6,1.0,0,0,2\n1.0,1e-6,0,3.0,{offset}\n*PART\ncable\n{first},{first},{first}\n"
            f"*MAT_CABLE_DISCRETE_BEAM\n{first},1e-9,{-stiffness},0,{preload}\n*ELEMENT_BEAM\n{first},{first},1,{first},\n"
            f"*NODE\n{first},{x},{y},{z}\n*BOUNDARY_SPC_NODE\n{first},0,1,1,1\n")


class LinearStarts(CommandTest):
    def first(self, text, mode=0, *arguments):
        self.write(text)
        self.nugget("modes", "model.k", "-n", mode + 1, "-o", "modes", "--quiet", "-j", 1, *arguments)
        return self.json("modes/summary.json")["modes"][mode]["frequency_hz"]

    def assert_stiffness(self, text, stiffness, delta=1e-6):
        """Of the mass of 2."""
        self.assertAlmostEqual(2.0 * (2.0 * math.pi * self.first(text)) ** 2 / stiffness, 1.0, delta=delta)

    def column(self, material):
        """A cube of 1 that carries a mass of 2 and moves along z alone, in which it has stress across it only by its law."""
        nodes = "".join(f"{i + 1},{x},{y},{z}\n" for i, (x, y, z) in enumerate(CORNERS))
        masses = "".join(f"{i + 1},{i + 1},0.5\n" for i in range(4, 8))
        held = "".join(f"{i + 1},0,1,1,{int(i < 4)}\n" for i in range(8)) + "*SET_NODE_LIST\n8,\n5,6,7,8,\n*CONSTRAINED_NODE_SET\n8,3,\n"
        return (HEAD + material + "*SECTION_SOLID\n1,2\n*PART\nfoam\n1,1,1\n*NODE\n" + nodes + "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n"
                + "*ELEMENT_MASS\n" + masses + "*BOUNDARY_SPC_NODE\n" + held + "*END\n")

    def test_foam_that_pulls_otherwise_than_it_pushes(self):
        """1000 in tension, 100 under compression: the mean. By the slope of one side alone the matrix is not even definite."""
        foam = "*DEFINE_CURVE\n1,\n0.0,0.0\n0.1,10.0\n0.6,60.0\n*MAT_LOW_DENSITY_FOAM\n1,1e-12,1000.0,1,1e20,1.0,0.0,0.0\n\n"
        self.assert_stiffness(self.column(foam), 550.0, delta=1e-4)

    def test_rubber_whose_test_has_a_kink(self):
        """500 in tension, 600 under compression, between them a bulk modulus that lets the volume stay: 550, held across 4/3 G and K."""
        rubber = ("*DEFINE_CURVE\n1,\n-0.8,-800.0\n-0.1,-60.0\n0.0,0.0\n0.1,50.0\n2.0,400.0\n"
                  "*MAT_SIMPLIFIED_RUBBER/FOAM\n1,1e-12,5000.0,0.1,0,0\n1.0,1.0,1.0,1\n")
        self.assert_stiffness(self.column(rubber), 5000.0 + 4.0 / 3.0 * 550.0 / 3.0, delta=1e-5)

    def test_a_block_of_foam_has_modes(self):
        """Bent, sheared and drawn at once: the matrix is positive."""
        nodes, bricks = "", ""
        number = lambda i, j, k: 1 + i + 3 * j + 9 * k  # noqa: E731
        for k in range(6):
            for j in range(3):
                nodes += "".join(f"{number(i, j, k)},{i + 0.1 * k},{1.1 * j + 0.05 * i * k},{2.0 * k}\n" for i in range(3))
        for k in range(5):
            for j in range(2):
                for i in range(2):
                    corners = ",".join(str(number(i + a, j + b, k + c)) for a, b, c in CORNERS)
                    bricks += f"{1 + i + 2 * j + 4 * k},1,{corners}\n"
        held = "".join(f"{n},0,1,1,1\n" for n in range(1, 10))
        foam = "*DEFINE_CURVE\n1,\n0.0,0.0\n0.1,10.0\n0.6,60.0\n*MAT_LOW_DENSITY_FOAM\n1,1e-9,1000.0,1,1e20,1.0,0.0,0.0\n\n"
        text = (HEAD + foam + "*SECTION_SOLID\n1,2\n*PART\nfoam\n1,1,1\n*NODE\n" + nodes + "*ELEMENT_SOLID\n" + bricks
                + "*BOUNDARY_SPC_NODE\n" + held + "*END\n")
        lower, upper = (self.first(text.replace("1000.0,1,", f"{e},1,").replace("0.1,10.0\n0.6,60.0", f"0.1,{0.1 * e}\n0.6,{0.6 * e}"))
                        for e in (100.0, 1000.0))
        self.assertTrue(lower < self.first(text) < upper)

    def test_springs_with_an_offset(self):
        """A curve of slope 10, beyond 1 of slope 50: the slope is that of where the spring stands at the start."""
        curve = "*DEFINE_CURVE\n5,\n-3.0,-110.0\n-1.0,-10.0\n1.0,10.0\n3.0,110.0\n"
        for offset, stiffness in ((0.0, 10.0), (2.0, 50.0), (-2.5, 50.0)):
            with self.subTest(offset):
                self.assert_stiffness(mass_on(spring(11, "NONLINEAR_ELASTIC", "5,0", offset, curve=curve)), stiffness)

    def test_springs_with_a_clearance(self):
        """No force until compressed by 0.5: beside one of 7 nothing is added, unless the spring begins beyond that."""
        beside = spring(12, "ELASTIC", "7.0")
        for offset, stiffness in ((0.0, 7.0), (-0.4, 7.0), (-0.6, 17.0)):
            with self.subTest(offset):
                self.assert_stiffness(mass_on(spring(11, "ELASTIC", "10.0", offset, 0.5), beside), stiffness)

    def test_statics_has_the_forces_of_offsets_and_preloads(self):
        """A spring of 10 that begins 0.3 too long pulls against another of 20; so does a cable with F0."""
        for name, first, moved in (("offset", spring(11, "ELASTIC", "10.0", 0.3), 0.1),
                                   ("preload", cable(11, (0, 0, 10), 6.0, stiffness=40.0), 0.1),
                                   ("cable offset", cable(11, (0, 0, 10), 0.0, 0.15, 40.0), 0.1)):
            with self.subTest(name):
                text = mass_on(STATICS, first, spring(12, "ELASTIC", "20.0"), "*DATABASE_HISTORY_NODE\n1,\n*DATABASE_NODOUT\n1.0,2\n")
                self.write(text)
                self.nugget("run", "model.k", "-o", "out", "--quiet")
                last = lsda.states(lsda.read(self.folder / "out/binout0000"), "nodout")[-1]
                self.assertAlmostEqual(last["z_displacement"][0], moved, delta=1e-9)
                held = [line.split() for line in self.read("out/run.log").splitlines() if "forces of supports" in line][0]
                self.assertAlmostEqual(float(held[5]), 0.0, delta=1e-9)  # what one pulls the other holds

    def test_preloads_stiffen(self):
        """A mass between two cables of length 10 under 6: omega^2 = 2 F0 / (L m) across, with IGS 1 alone."""
        ends = cable(11, (0, 0, 10), 6.0) + cable(12, (0, 0, -10), 6.0)
        general = "*CONTROL_IMPLICIT_GENERAL\n1,1.0,,,{}\n*CONTROL_IMPLICIT_EIGENVALUE\n3,\n"
        self.assert_stiffness(mass_on(ends, general.format(1), held="0,1,0"), 2.0 * 6.0 / 10.0)
        self.assert_stiffness(mass_on(ends, general.format(2), held="0,1,0"), 200.0)
        up = "*DEFINE_SD_ORIENTATION\n4,0,0.0,0.0,1.0\n"
        for vector, stiffness in ((0, 2.0 * 6.0 / 10.0), (4, 20.0)):  # one along its nodes, one along z wherever they go
            springs = "".join(spring(k, "ELASTIC", "10.0", 0.6, z=z, vector=vector) for k, z in ((11, 10.0), (12, -10.0)))
            self.assert_stiffness(mass_on(up, springs, general.format(1), held="0,1,0"), stiffness)

    def test_a_node_driven_beside_an_oblique_support(self):
        """It slides on a slope of 45 degrees: driven by 1 along x it moves by 1 along z too, and never off the slope."""
        slope = "*DEFINE_COORDINATE_VECTOR\n4,0.0,1.0,0.0,1.0,0.0,-1.0,\n"  # x is y; the normal of the slope is in the plane x z
        frf = "*CONTROL_IMPLICIT_EIGENVALUE\n2,\n*FREQUENCY_DOMAIN_FRF\n1,0,1,7,\n0.0,\n1,0,7,2,\n0.1,0.2,2,\n"
        text = (HEAD + slope + frf + spring(11, "ELASTIC", "10.0") + "*ELEMENT_MASS\n1,1,2.0\n*NODE\n1,0.0,0.0,0.0\n"
                "*BOUNDARY_SPC_NODE\n1,4,1,1,0\n*END\n")
        self.write(text)
        self.nugget("frf", "model.k", "-o", "frf", "--quiet")
        with open(self.folder / "frf/frf.csv", newline="", encoding="utf-8") as file:
            moved = {row["direction"]: float(row["real"]) for row in csv.DictReader(file)}
        self.assertAlmostEqual(moved["x"], 1.0, delta=1e-9)
        self.assertAlmostEqual(moved["y"], 0.0, delta=1e-9)
        self.assertAlmostEqual(abs(moved["z"]), 1.0, delta=1e-9)
        self.write(text.replace("1,4,1,1,0\n", "1,0,1,1,0\n"))
        said = self.nugget("frf", "model.k", "-o", "frf", "--quiet", expect=1).stderr
        self.assertIn("node 1 is to be driven in a direction in which *BOUNDARY_SPC holds it", said)

    def slender(self, cards):
        """A cantilever of steel, 1000 long, round, 2 thick, of 20 resultant beams from node 1 to node 21."""
        nodes = "".join(f"{i + 1},{50.0 * i},0.0,0.0\n" for i in range(21)) + "30,0.0,500.0,0.0\n"
        beams = "".join(f"{i},1,{i},{i + 1},30\n" for i in range(1, 21))
        area, moment = math.pi, 0.25 * math.pi
        self.write(HEAD + f"*SECTION_BEAM\n1,2,1.0\n{area},{moment},{moment},{2 * moment},{area}\n*MAT_ELASTIC\n1,7.85e-9,210000.0,0.3\n"
                   "*PART\nbar\n1,1,1\n*NODE\n" + nodes + "*ELEMENT_BEAM\n" + beams + "*BOUNDARY_SPC_NODE\n1,0,1,1,1,1,1,1\n30,0,1,1,1,1,1,1\n"
                   "*CONTROL_IMPLICIT_EIGENVALUE\n2,\n" + cards + "*END\n")
        self.nugget("frf", "model.k", "-o", "frf", "--quiet")
        with open(self.folder / "frf/frf.csv", newline="", encoding="utf-8") as file:
            return float(next(csv.DictReader(file))["real"])

    def test_static_answers_of_slender_structures(self):
        """At rest two modes and a residual vector are the whole answer: L^3 / 3 EI; a driven end takes the middle along by 5/16."""
        frf = "*FREQUENCY_DOMAIN_FRF\n21,0,3,{},\n0.01,\n{},0,3,2,\n0.0,0.1,2,\n"
        flexibility = 1000.0**3 / (3.0 * 210000.0 * 0.25 * math.pi)
        self.assertAlmostEqual(self.slender(frf.format(3, 21)) / flexibility, 1.0, delta=1e-4)  # the shear of a beam: 3e-6
        self.assertAlmostEqual(self.slender(frf.format(7, 11)), 5.0 / 16.0, delta=1e-4)

    def test_what_takes_no_part_is_named(self):
        deck = mass_on(spring(11, "ELASTIC", "10.0"), "*DAMPING_GLOBAL\n0,5.0,\n*LOAD_NODE_POINT\n1,3,77,1.0,\n*INITIAL_VELOCITY\n0\n0.,0.,1.,\n"
                       "*RIGIDWALL_PLANAR\n0\n0,0,-5,0,0,10,0.3\n")
        frf = "*CONTROL_IMPLICIT_EIGENVALUE\n2,\n*FREQUENCY_DOMAIN_FRF\n1,0,3,3,\n0.02,\n1,0,7,2,\n0.1,0.2,2,\n"
        self.write(deck.replace("*END", frf + "*END"))
        said = self.nugget("frf", "model.k", "-o", "frf", "--quiet").stderr
        self.assertIn("warning: *FREQUENCY_DOMAIN_FRF: *DAMPING_GLOBAL takes no part in it", said)
        self.assertIn("at rest: 1 rigid wall, 1 load over time, initial velocities take no part", said)
        self.write(deck)
        self.assertIn("1 load over time", self.nugget("modes", "model.k", "-n", 1, "-o", "modes", "--quiet").stderr)

    def test_springs_of_one_rigid_body_share_its_step(self):
        """A block that 7 springs hold at its corners: each alone would allow a step at which they together are unstable."""
        ends = ((1, 2, 3), (-2, 1, 2), (3, -1, 1), (1, -3, 2), (-1, -1, -3), (2, 2, -1), (-3, 1, -2))
        text = "*KEYWORD\n*CONTROL_TERMINATION\n0.02,\n*SECTION_SOLID\n1,1\n*MAT_RIGID\n1,7.85e-9,2.1e5,0.3\n\n\n*PART\nblock\n1,1,1\n"
        text += "*SECTION_DISCRETE\n2,0,\n,\n*MAT_SPRING_ELASTIC\n2,500.0,\n*PART\nsprings\n2,2,2\n*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n*NODE\n"
        text += "".join(f"{i + 1},{10.0 * x},{8.0 * y},{6.0 * z}\n" for i, (x, y, z) in enumerate(CORNERS))
        text += "".join(f"{i + 11},{10.0 * CORNERS[i][0] + 10 * a},{8.0 * CORNERS[i][1] + 10 * b},{6.0 * CORNERS[i][2] + 10 * c}\n"
                        for i, (a, b, c) in enumerate(ends))
        text += "*ELEMENT_DISCRETE\n" + "".join(f"{i + 11},2,{i + 1},{i + 11},\n" for i in range(7))
        text += "*BOUNDARY_SPC_NODE\n" + "".join(f"{i + 11},0,1,1,1\n" for i in range(7)) + "*INITIAL_VELOCITY\n0\n50.,80.,-30.,\n*END\n"
        fastest = self.first(text, 5)
        self.nugget("run", "model.k", "-o", "run", "--quiet")
        summary = self.json("run/summary.json")
        self.assertLess(summary["time"] / summary["cycles"], 0.9 * 1.001 / (math.pi * fastest))


if __name__ == "__main__":
    unittest.main()
