# SPDX-License-Identifier: Apache-2.0
"""What a run says of its energies at the end: work of bulk viscosity; what is compared with the internal energy."""
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


if __name__ == "__main__":
    unittest.main()
