# SPDX-License-Identifier: Apache-2.0
"""What a run says of its energies at the end: work of bulk viscosity; what is compared with the internal energy."""
import math
import random
import unittest

from nugget_command import CommandTest

SIDE = 10.0


def bar(count, velocity, cards, bulk=""):
    """Steel cubes in a bar along z that moves along z only, held at its foot; `velocity`: of the nodes of each height."""
    places = [(k, i, x, y) for k in range(count + 1) for i, (x, y) in enumerate(((0, 0), (1, 0), (1, 1), (0, 1)), 1)]
    text = "*KEYWORD\n" + cards + bulk + "*PART\nbar\n1,1,1\n*SECTION_SOLID\n1,1\n*MAT_ELASTIC\n1,7.85e-9,2.1e5,0.3\n*NODE\n"
    text += "".join(f"{4 * k + i},{SIDE * x},{SIDE * y},{SIDE * k}\n" for k, i, x, y in places)
    text += "*INITIAL_VELOCITY_NODE\n" + "".join(f"{4 * k + i},0,0,{velocity(k):.9f}\n" for k, i, *_ in places)
    text += "*BOUNDARY_SPC_NODE\n" + "".join(f"{4 * k + i},0,1,1,{int(k == 0)}\n" for k, i, *_ in places)
    text += "*ELEMENT_SOLID\n" + "".join(f"{k + 1},1,{','.join(str(4 * k + i) for i in range(1, 9))}\n" for k in range(count))
    return text + "*END\n"


class AlternatingVelocities(CommandTest):
    def test_a_square_shell_alone_at_the_default_step(self):
        """Both directions of a free square swell together, by c sqrt(1 + nu) over its side: 0.877 of the formula's step is its limit. The
        velocities alternate, and a kinetic energy of -4e53 balances an internal one of 4e53. Sabotage: only what is made is looked at."""
        text = ("*KEYWORD\n*CONTROL_TERMINATION\n1e-3\n*CONTROL_TIMESTEP\n0,{}\n*SECTION_SHELL\n1,{}\n1.\n*MAT_ELASTIC\n1,7.8e-9,2.1e5,0.3\n"
                "*PART\np\n1,1,1\n*NODE\n1,0,0,0\n2,10,0,0\n3,10,10,0\n4,0,10,0\n*ELEMENT_SHELL\n1,1,1,2,3,4\n"
                "*INITIAL_VELOCITY_NODE\n1,10.,5.,100.\n*END\n")
        for elform in (2, 16):
            self.write(text.format(0.9, elform))
            self.assertIn("the run is unstable", self.nugget("run", "model.k", "--quiet", expect=3).stderr)
            self.write(text.format(0.85, elform))
            self.nugget("run", "model.k", "--quiet")


class BulkViscosity(CommandTest):
    def test_all_that_a_bar_loses_goes_against_it(self):
        """An elastic bar without anything else that damps comes to rest: at TSSFAC 0.9 and from velocities at random, whose vibrations take
        a few steps each. Sabotage: the pressure after the step alone, which books 1.9 times the energy."""
        draw = random.Random(3)
        speeds = [draw.uniform(-1, 1) for _ in range(11)]
        self.write(bar(10, lambda k: speeds[k] if k else 0.0, "*CONTROL_TERMINATION\n2.0e-2\n*CONTROL_TIMESTEP\n0,0.9\n"))
        self.nugget("run", "model.k", "--quiet")
        energy = self.json("summary.json")["energy"]
        self.assertLess(energy["kinetic"], 1e-3 * energy["initial"])
        self.assertAlmostEqual(energy["bulk_viscosity"] / energy["initial"], 1.0, delta=2e-3)
        self.assertIn(f"of the internal energy by bulk viscosity {energy['bulk_viscosity']:.5e}", self.read("run.log"))

    def test_tetrahedra_book_theirs(self):
        """The same bar of tetrahedra of each formulation with four nodes or ten has books of its own: not 0, and not more than the internal
        energy. A cube in six tetrahedra, one bar each."""
        for elform in (10, 4):
            text = bar(1, lambda k: float(k), "*CONTROL_TERMINATION\n2.0e-4\n*CONTROL_TIMESTEP\n0,0.5\n")
            six = ((1, 2, 3, 7), (1, 3, 4, 7), (1, 4, 8, 7), (1, 8, 5, 7), (1, 5, 6, 7), (1, 6, 2, 7))
            head = text[: text.index("*ELEMENT_SOLID")].replace("*SECTION_SOLID\n1,1", f"*SECTION_SOLID\n1,{elform}")
            self.write(head + "*ELEMENT_SOLID\n" + "".join(f"{e},1,{a},{b},{c},{d},{d},{d},{d},{d}\n" for e, (a, b, c, d) in enumerate(six, 1)) + "*END\n")
            self.nugget("run", "model.k", "--quiet")
            energy = self.json("summary.json")["energy"]
            self.assertGreater(energy["bulk_viscosity"], 0.05 * energy["initial"])
            self.assertLess(energy["bulk_viscosity"], 1.02 * energy["initial"])


class BesideAStriker(CommandTest):
    def test_the_change_of_step_is_compared_with_the_internal_energy(self):
        """A cube vibrates undamped and its step jumps; a mass that flies by has fifteen times the energy and hides what the change took.
        Sabotage: compared with all of the energy only."""
        cards = "*CONTROL_TERMINATION\n1.02e-4\n*CONTROL_TIMESTEP\n0,0.9,0,0.0,0.0,1\n"
        cards += "*DEFINE_CURVE\n1\n0.0,1.5e-7\n5.0e-5,1.5e-7\n5.01e-5,1.2e-6\n1.0,1.2e-6\n"
        still = bar(1, lambda k: float(k), cards, "*CONTROL_BULK_VISCOSITY\n0.0,1.0e-9\n")
        flying = "*NODE\n99,500.0,0.0,0.0\n*ELEMENT_MASS\n99,99,1.0e-6\n*INITIAL_VELOCITY_NODE\n99,0,0,{speed}\n*END\n"
        energy_of_the_cube = 0.5 * 0.5 * 7.85e-9 * SIDE**3
        for share, expected in ((0.0, True), (15.0, True), (1000.0, False)):
            speed = (2 * share * energy_of_the_cube / 1.0e-6) ** 0.5
            self.write(still.replace("*END\n", flying.format(speed=f"{speed:.6f}")))
            told = self.nugget("run", "model.k", "--quiet").stderr
            energy = self.json("summary.json")["energy"]
            self.assertGreater(abs(energy["step_change"]), 0.1 * energy["internal"], energy)
            if share == 15.0:
                self.assertLess(abs(energy["step_change"]), 0.05 * energy["initial"])
            (self.assertIn if expected else self.assertNotIn)("the change of the time step took", told)


def glued(option, turn, slide=1e-3, end=2e-3):
    """Two sheets that touch, 1 mm apart, the upper glued to the lower (TIEBREAK). Up to a quarter of `end` the upper slides by `slide`
    along x, from then on both turn about the axis y of the lower by `turn`."""
    def sheet(part, z, first):
        places = "".join(f"{first + 3 * j + i},{10.0 * i - 10.0},{10.0 * j},{z}\n" for j in range(3) for i in range(3))
        shells = "".join(f"{first + 2 * j + i},{part},{first + 3 * j + i},{first + 3 * j + i + 1},{first + 3 * j + i + 4},{first + 3 * j + i + 3}\n"
                         for j in range(2) for i in range(2))
        return places, shells
    low, high = sheet(1, 0.0, 1), sheet(2, 1.0, 101)
    first, drive = 0.25 * end, "*BOUNDARY_PRESCRIBED_MOTION_SET\n"
    motions = [f"2,1,2,1,{slide},0,{first}\n"] + [f"{n},{dof},2,3,1,0,{first}\n" for n, dof in ((1, 1), (1, 3), (2, 3))]
    motions += [f"{n},10,2,2,{turn},0,1e20,{first}\n0,0\n" for n in (1, 2)]
    sets = "".join(f"*SET_NODE_LIST\n{n}\n{','.join(str(k + a) for a in range(1, 9))}\n{k + 9}\n" for n, k in ((1, 0), (2, 100)))
    return ("*KEYWORD\n*CONTROL_TERMINATION\n" + f"{end}\n*CONTROL_ENERGY\n2,2,2,2\n*DATABASE_GLSTAT\n{end / 20}\n*DATABASE_RCFORC\n{end / 20}\n"
            "*PART\nlow\n1,1,1\n*PART\nhigh\n2,1,1\n*SECTION_SHELL\n1,2\n1.0\n*MAT_ELASTIC\n1,7.85e-9,2.1e5,0.3\n"
            f"*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK\n2,1,3,3\n\n\n{option}\n" + sets
            + f"*DEFINE_CURVE\n1\n0,0\n{first},1\n1,1\n*DEFINE_CURVE\n2\n0,0\n{end - first},1\n*DEFINE_CURVE\n3\n0,0\n1,0\n"
            + "".join(drive + m for m in motions) + "*NODE\n" + low[0] + high[0] + "*ELEMENT_SHELL\n" + low[1] + high[1] + "*END\n")


class ContactThatGives(CommandTest):
    def test_glue_without_a_lever_gives_energy_when_its_sheets_turn(self):
        """The shear F of OPTION 1 has no lever of the gap h: turned by the angle a, the pair gives F h a, while the ratio stays at 1. With
        OPTION -1 it keeps F s / 2, s the slide. Sabotage: no warning at the end; one where nothing is given."""
        for option, gives in ((1, True), (-1, False)):
            self.write(glued(option, -0.5))
            run = self.nugget("run", "model.k", "--quiet")
            energy = self.json("summary.json")["energy"]
            last = [line.split() for line in self.read("rcforc").splitlines() if line.split()[:1] == ["slave"]][-1]
            force = math.hypot(float(last[5]), float(last[9]))
            self.assertAlmostEqual(energy["contact"] / (0.5e-3 * force - gives * 0.5 * force), 1.0, delta=5e-3)
            self.assertAlmostEqual(energy["ratio"], 1.0, delta=1e-3)
            said = [line for line in run.stderr.splitlines() if "of energy that they never got" in line]
            self.assertEqual(len(said), int(gives), run.stderr)
            self.assertEqual(" contacts gave " in self.read("run.log"), gives)
            self.assertEqual('id="check-contact">look at it' in self.read("report.html"), gives)
        self.write(glued(1, 0.5))  # what it takes is no one's gain
        self.assertNotIn("that they never got", self.nugget("run", "model.k", "--quiet").stderr)


if __name__ == "__main__":
    unittest.main()
