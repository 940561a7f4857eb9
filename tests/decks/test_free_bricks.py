# SPDX-License-Identifier: Apache-2.0
"""Bricks with free sides, whose stable step is shorter than V / A_max over the speed of a plane wave: the run finds the limit of what is
assembled, takes a part of it where the deck leaves TSSFAC to it, and warns where the deck gives one."""
import math
import random
import re
import unittest

from nugget_command import CommandTest

SIDE, NU, YOUNG, DENSITY = 10.0, 0.3, 2.1e5, 7.85e-9
Q2, QM = 0.06, 0.1  # linear bulk viscosity, hourglass viscosity: the defaults
ELASTIC = "*MAT_ELASTIC\n1,7.85e-9,2.1e5,{nu}\n"
PLASTIC = "*MAT_024\n1,7.85e-9,2.1e5,{nu},250.0,1000.0\n\n\n\n"


def numbered(nx, ny):
    return lambda i, j, k: i + (nx + 1) * (j + (ny + 1) * k)


def corners(number, i, j, k):
    return [number(i + a, j + b, k + c) for c in (0, 1) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]


def block(nx, ny, nz, tssfac="", nu=NU, end=2e-3, material=ELASTIC, held="", seed=1):
    """Cubes whose nodes get random velocities of 1e-3. `tssfac`: blank is the default; `held`: components of all nodes, as bits of DOFX."""
    draw = random.Random(seed)
    number = numbered(nx, ny)
    places = [(i, j, k) for k in range(nz + 1) for j in range(ny + 1) for i in range(nx + 1)]
    text = f"*KEYWORD\n*CONTROL_TERMINATION\n{end}\n*DATABASE_GLSTAT\n{end / 20:.3g}\n*CONTROL_TIMESTEP\n,{tssfac}\n"
    text += "*PART\ncubes\n7,1,1\n*SECTION_SOLID\n1,1\n" + material.format(nu=nu) + "*NODE\n"
    text += "".join(f"{1 + number(*p)},{SIDE * p[0]},{SIDE * p[1]},{SIDE * p[2]}\n" for p in places)
    text += "*INITIAL_VELOCITY_NODE\n"
    text += "".join(f"{1 + number(*p)},{','.join(f'{1e-3 * draw.uniform(-1, 1):.9f}' for _ in range(3))}\n" for p in places)
    text += "*ELEMENT_SOLID\n"
    cells = [(i, j, k) for k in range(nz) for j in range(ny) for i in range(nx)]
    text += "".join(f"{1 + e},7,{','.join(str(1 + n) for n in corners(number, *c))}\n" for e, c in enumerate(cells))
    if held:
        text += "*BOUNDARY_SPC_NODE\n" + "".join(f"{1 + number(*p)},0,{held}\n" for p in places)
    return text + "*END\n"


def limit_of(nx, ny, nz, nu=NU):
    """The limit of TSSFAC by the equations of the method, without any of the program: cubes of side, density and modulus 1, lumped masses,
    K of the strains in the middle, the hourglass viscosity at the mean velocity, half the linear bulk viscosity; the largest eigenvalue of
    M^-1 (dt^2 K + 2 dt C) by powers, dt such that it is 4."""
    shear, lame = 0.5 / (1 + nu), nu / ((1 + nu) * (1 - 2 * nu))
    speed = math.sqrt(lame + 2 * shear)
    number = numbered(nx, ny)
    count = (nx + 1) * (ny + 1) * (nz + 1)
    cells = [corners(number, i, j, k) for k in range(nz) for j in range(ny) for i in range(nx)]
    mass = [0.0] * count
    for cell in cells:
        for n in cell:
            mass[n] += 0.125
    gradient = [(0.25 * (2 * a - 1), 0.25 * (2 * b - 1), 0.25 * (2 * c - 1)) for c in (0, 1) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
    rate = 16 * QM * speed  # of the decay of an hourglass of one cube

    def forces(u, dt):
        f = [[0.0] * 3 for _ in u]
        for cell in cells:
            g = [[sum(b[j] * u[n][i] for n, b in zip(cell, gradient)) for j in range(3)] for i in range(3)]
            trace = g[0][0] + g[1][1] + g[2][2]
            s = [[dt * dt * shear * (g[i][j] + g[j][i]) for j in range(3)] for i in range(3)]
            for i in range(3):
                s[i][i] += (dt * dt * lame + 2 * dt * 0.5 * Q2 * speed) * trace
            mean = [sum(u[n][i] for n in cell) / 8 for i in range(3)]
            viscosity = 2 * dt * rate / (1 + rate * dt / 2) / 8
            for n, b in zip(cell, gradient):
                for i in range(3):
                    linear = mean[i] + 2 * sum(g[i][j] * b[j] for j in range(3))
                    f[n][i] += sum(s[i][j] * b[j] for j in range(3)) + viscosity * (u[n][i] - linear)
        return f

    draw = random.Random(1)
    u = [[draw.uniform(-1, 1) for _ in range(3)] for _ in range(count)]
    formula = 1 / (speed * (Q2 + math.sqrt(1 + Q2 * Q2)))
    dt = formula
    for _ in range(6):
        value = 0.0
        for _ in range(400):
            f = forces(u, dt)
            before = value
            value = sum(a * b for x, y in zip(u, f) for a, b in zip(x, y)) / sum(m * a * a for m, x in zip(mass, u) for a in x)
            u = [[a / (m * value) for a in y] for m, y in zip(mass, f)]
            if abs(value - before) < 1e-6 * value:
                break
        dt *= 2 / math.sqrt(value)
        if abs(value - 4) < 1e-4:
            break
    return dt / formula


class Blocks(CommandTest):
    def told_limit(self, text):
        self.write(text)
        told = self.nugget("check", "model.k").stderr
        found = re.search(r"solid (\d+) of part 7 vibrates.*limit of stability is TSSFAC (\S+); the deck has 0.9 \[write TSSFAC (\S+),", told)
        self.assertTrue(found, told)
        return float(found[2]), float(found[3])

    def test_the_limit_is_that_of_the_assembled_cubes(self):
        """Sabotage: nodal masses of single cubes, all of the bulk viscosity, or none of it."""
        for shape in ((1, 1, 1), (6, 1, 1), (2, 2, 1), (5, 5, 1)):
            with self.subTest(shape):
                limit, advice = self.told_limit(block(*shape, 0.9))
                self.assertAlmostEqual(limit / limit_of(*shape), 1.0, delta=0.004)
                self.assertAlmostEqual(advice, 0.9 * limit, delta=0.006)

    def test_pressure_by_an_equation_of_state_is_stiffness(self):
        """Cubes of the same moduli by *MAT_JOHNSON_COOK and an equation of state have the same limit, and a run with the default step keeps
        its energy. Sabotage: a volume that is 1 plus what the tiny motion of the search changes it by."""
        shear, bulk = YOUNG / (2 * (1 + NU)), YOUNG / (3 * (1 - 2 * NU))
        metal = f"*MAT_JOHNSON_COOK\n1,{DENSITY},{shear},{YOUNG},{NU}\n1e5,0,1,0,1,1500,293,1\n4.6e8,-1e9,1\n\n"
        for state in (f"*EOS_LINEAR_POLYNOMIAL\n1,0,{bulk},0,0,0,0,0\n0,1\n", f"*EOS_GRUNEISEN\n1,{math.sqrt(bulk / DENSITY)},1.5,0,0,0,0,0\n1\n",
                      f"*EOS_LINEAR_POLYNOMIAL\n1,0,{bulk},0,0,2.0,2.0,0\n0,1\n"):
            with self.subTest(state.split()[0]):
                def text(tssfac):
                    return block(6, 1, 1, tssfac, material=metal + state).replace("\n7,1,1\n", "\n7,1,1,1\n")
                limit, _ = self.told_limit(text(0.9))
                self.assertAlmostEqual(limit / limit_of(6, 1, 1), 1.0, delta=0.004)
                self.write(text(""))
                self.nugget("run", "model.k", "--quiet")
                self.assertAlmostEqual(self.json("summary.json")["energy"]["ratio_without_step_change"], 1.0, delta=0.05)

    def test_pressure_at_the_start_changes_no_stiffness(self):
        """Steel that begins with pressure (C0, E0, V0) has the same limit, its run with the default step and stiffness-proportional damping
        is stable, and its frequencies are those without. Sabotage: small motions by the law with its pressure: no limit is found, the
        damping is without bound and the frequencies fail. Sabotage: what the pressure may give is no input: the run is called unstable."""
        shear, bulk = YOUNG / (2 * (1 + NU)), YOUNG / (3 * (1 - 2 * NU))
        metal = f"*MAT_JOHNSON_COOK\n1,{DENSITY},{shear},{YOUNG},{NU}\n1e5,0,1,0,1,1500,293,1\n4.6e8,-1e9,1\n\n"

        def text(state, more="", end=2e-3):
            with_state = block(6, 1, 1, "", material=metal + f"*EOS_LINEAR_POLYNOMIAL\n1,{state}\n", end=end)
            return with_state.replace("\n7,1,1\n", "\n7,1,1,1\n").replace("*END\n", more + "*END\n")

        def frequencies(state):
            self.write(text(state, "*CONTROL_IMPLICIT_EIGENVALUE\n12\n"))
            self.nugget("modes", "model.k", "--quiet")
            return [mode["frequency_hz"] for mode in self.json("summary.json")["modes"]][6:]
        at_rest = frequencies(f"0,{bulk},0,0,0,0,0\n0,1")
        for state in (f"20,{bulk},0,0,0,0,0\n0,1", f"0,{bulk},0,0,2.0,2.0,0\n10,1", f"0,{bulk},0,0,0,0,0\n0,0.9999"):
            with self.subTest(state):
                self.write(text(state))
                self.nugget("run", "model.k", "--quiet")
                said = re.search(r"TSSFAC (\d\.\d+) at most", self.read("run.log"))
                self.assertAlmostEqual(float(said[1]) / limit_of(6, 1, 1), 1.0, delta=0.004)
                self.write(text(state, "*DAMPING_PART_STIFFNESS\n7,0.1\n", end=1e-4))
                self.nugget("run", "model.k", "--quiet")
                for own, without in zip(frequencies(state), at_rest):
                    self.assertAlmostEqual(own / without, 1.0, delta=3e-4)

    def test_a_cube_alone_by_its_closed_form(self):
        """Its dilatation: omega^2 = 12 K / (rho a^2); of critical the linear viscosity damps xi = rho Q2 a c omega / 2K, every second step:
        omega dt = sqrt(4 + xi^2) - xi."""
        limit, _ = self.told_limit(block(1, 1, 1, 0.9))
        bulk = YOUNG / (3 * (1 - 2 * NU))
        speed = math.sqrt(YOUNG * (1 - NU) / ((1 + NU) * (1 - 2 * NU)) / DENSITY)
        omega = math.sqrt(12 * bulk / DENSITY) / SIDE
        damped = DENSITY * Q2 * SIDE * speed * omega / (2 * bulk)
        formula = SIDE / speed / (Q2 + math.sqrt(1 + Q2 * Q2))
        self.assertAlmostEqual(limit * formula * omega / (math.sqrt(4 + damped**2) - damped), 1.0, delta=1e-3)

    def test_the_limit_is_sharp(self):
        """A cube alone, half a percent below and above it, for 5000 steps, none of which is cut."""
        limit, _ = self.told_limit(block(1, 1, 1, 0.9))
        self.write(block(1, 1, 1, round(0.995 * limit, 4), end=1.0))
        self.nugget("run", "model.k", "--quiet", "--max-cycles", 5000)
        self.assertAlmostEqual(self.json("summary.json")["energy"]["ratio_without_step_change"], 1.0, delta=0.01)
        self.write(block(1, 1, 1, round(1.005 * limit, 4), end=1.0))
        self.assertRegex(self.nugget("run", "model.k", "--quiet", "--max-cycles", 5000, expect=3).stderr, "the run is unstable|negative volume")

    def test_the_default_step_is_stable(self):
        """Sabotage: the limit told and not taken, which ends with code 3."""
        for shape, nu, material in (((5, 5, 1), NU, ELASTIC), ((20, 20, 1), NU, ELASTIC), ((20, 20, 1), NU, PLASTIC), ((2, 2, 1), NU, ELASTIC),
                                    ((3, 30, 1), NU, ELASTIC), ((6, 6, 6), 0.45, ELASTIC), ((1, 1, 1), NU, ELASTIC)):
            with self.subTest((shape, nu, material)):
                self.write(block(*shape, nu=nu, material=material))
                told = self.nugget("run", "model.k", "--quiet").stderr
                self.assertRegex(told, r"note: \*CONTROL_TIMESTEP.*vibrates, with what is around it, faster")
                energy = self.json("summary.json")["energy"]
                self.assertAlmostEqual(energy["ratio_without_step_change"], 1.0, delta=0.05)  # the last step is cut
                taken = float(re.search(r"the run takes (\S+) \[", told)[1])
                limit = float(re.search(r"TSSFAC (\S+) at most", self.read("run.log"))[1])
                self.assertAlmostEqual(taken, 0.9 * limit, delta=0.002)
                self.assertAlmostEqual(self.first_step(nu) / taken * 0.9, 1.0, delta=0.002)

    def first_step(self, nu):
        """Of the run, over that of the formula at TSSFAC 0.9."""
        speed = math.sqrt(YOUNG * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) / DENSITY)
        return self.json("summary.json")["time_step"]["first"] / (0.9 * SIDE / speed / (Q2 + math.sqrt(1 + Q2 * Q2)))

    def test_what_the_deck_gives_is_obeyed(self):
        """With the energy that the scheme makes booked as change of step, the ratio alone says nothing: the run ends as unstable."""
        for shape in ((5, 5, 1), (20, 20, 1)):
            with self.subTest(shape):
                self.write(block(*shape, 0.9))
                told = self.nugget("run", "model.k", "--quiet", expect=3).stderr
                self.assertRegex(told, r"warning: \*CONTROL_TIMESTEP tssfac = 0.9|warning: \*CONTROL_TIMESTEP")
                self.assertIn("the run is unstable", told)
                self.assertIn("most of it in part 7", told)
                self.assertIn("the run is unstable", self.json("summary.json")["message"])

    def test_where_the_formula_is_right_the_step_is_its_own(self):
        """A block of cubes in all directions, and a row whose sides are held. Sabotage: supports that are left out."""
        for text in (block(6, 6, 6, end=1e-5), block(6, 1, 1, end=1e-5, held="0,1,1")):
            self.write(text)
            self.assertNotIn("vibrates, with what is around it", self.nugget("run", "model.k", "--quiet").stderr)
            self.assertAlmostEqual(self.first_step(NU), 1.0, delta=1e-5)

    def test_it_is_looked_for_again_when_bricks_change_their_shape(self):
        """A flat brick of plastic steel is drawn out along z, in which its nodes are driven, until it is longer than wide. Across it,
        omega^2 = 4 (2 lambda + 2 G) / (rho a^2), faster than the formula knows, damped by 2 (1 - nu) Q2 a / c of the stiffness: x = c dt / a
        with x^2 + 2 (1 - nu) Q2 x = 1 - nu. A resumed run keeps what it takes. Sabotage: never looked again, which ends with code 3; the
        factor left out of the restart file."""
        text = block(1, 1, 1, end=0.03, material="*MAT_024\n1,7.85e-9,2.1e5,{nu},100.0,0.0\n\n\n\n")
        text = text.replace("*END\n", "*DEFINE_CURVE\n1\n0.0,700.0\n0.01,700.0\n0.011,0.0\n1.0,0.0\n")
        text = re.sub(r"(?m)^(\d,\S+,\S+),10.0$", r"\1,3.0", text)
        text += "*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + "".join(f"{n},3,0,1\n" for n in (5, 6, 7, 8))
        text += "*BOUNDARY_SPC_NODE\n" + "".join(f"{n},0,0,0,1\n" for n in (1, 2, 3, 4)) + "*END\n"
        self.write(text)
        self.assertNotIn("vibrates", self.nugget("run", "model.k", "--quiet", "-o", "whole").stderr)
        told = re.findall(r"from time (\S+) on the run takes TSSFAC (\S+) \(solid 1 of part 7\)", self.read("whole/run.log"))
        self.assertTrue(told, self.read("whole/run.log"))
        x = math.sqrt(((1 - NU) * Q2) ** 2 + 1 - NU) - (1 - NU) * Q2
        self.assertAlmostEqual(float(told[-1][1]), 0.9 * x / (math.sqrt(1 + Q2 * Q2) - Q2), delta=0.004)
        self.nugget("run", "model.k", "--quiet", "-o", "parts", "--max-cycles", 16500, "--checkpoint", "16000cycles")
        self.nugget("run", "--resume", "parts", "--max-cycles", 10**6, "--quiet")
        whole, parts = self.json("whole/summary.json"), self.json("parts/summary.json")
        self.assertEqual(whole["cycles"], parts["cycles"])
        self.assertEqual(whole["energy"], parts["energy"])
        self.assertIn(f"takes TSSFAC {told[-1][1]}", self.read("parts/run.log"))

    def test_the_same_bits_for_any_number_of_threads(self):
        self.write(block(20, 20, 1, end=1e-4))
        steps = set()
        for threads in (1, 2, 3):
            self.nugget("run", "model.k", "--quiet", "-j", threads)
            steps.add(self.json("summary.json")["time_step"]["first"])
        self.assertEqual(len(steps), 1)


if __name__ == "__main__":
    unittest.main()
