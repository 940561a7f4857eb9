# SPDX-License-Identifier: Apache-2.0
"""Shells that vibrate faster than the formula of their step knows: alone or in pairs, thick ones with nodes off the mid-surface, thick
triangles, slanted ones with ISDO 2. At the default TSSFAC the run takes a part of the limit of what is assembled."""
import math
import random
import re
import unittest

from nugget_command import CommandTest

YOUNG, DENSITY, SIDE = 2.1e5, 7.85e-9, 10.0


def sheet(nx=1, ny=1, *, elform=2, t=1.0, nu=0.3, ratio=1.0, skew=0.0, warp=0.0, triangles=0, nloc=0, isdo=0, tssfac="", head=""):
    """Shells of SIDE by ratio SIDE whose nodes get random velocities and spins. `triangles`: 1 or 2 in each rectangle instead of it."""
    draw = random.Random(1)
    text = f"*KEYWORD\n*CONTROL_TERMINATION\n1.0\n*CONTROL_TIMESTEP\n,{tssfac},{isdo}\n{head}"
    text += f"*PART\nsheet\n7,1,1\n*SECTION_SHELL\n1,{elform}\n{t},{t},{t},{t},{nloc}\n*MAT_ELASTIC\n1,{DENSITY},{YOUNG},{nu}\n*NODE\n"
    number = lambda i, j: 1 + i + (nx + 1) * j
    places = [(i, j) for j in range(ny + 1) for i in range(nx + 1)]
    text += "".join(f"{number(i, j)},{SIDE * (i + skew * ratio * j):.9g},{SIDE * ratio * j:.9g},{SIDE * warp * ((i + j) % 2):.9g}\n" for i, j in places)
    text += "*INITIAL_VELOCITY_NODE\n"
    text += "".join(f"{number(*p)},{','.join(f'{1e-3 * draw.uniform(-1, 1):.9f}' for _ in range(6))}\n" for p in places)
    text += "*ELEMENT_SHELL\n"
    shells = []
    for j in range(ny):
        for i in range(nx):
            q = [number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)]
            shells += [q] if not triangles else [[q[0], q[1], q[2], q[2]], [q[0], q[2], q[3], q[3]]][:triangles]
    return text + "".join(f"{e},7,{','.join(map(str, q))}\n" for e, q in enumerate(shells, 1)) + "*END\n"


def step_of_formula(nu=0.3):
    """L/c of a square."""
    return SIDE * math.sqrt(DENSITY * (1 - nu * nu) / YOUNG)


class Shells(CommandTest):
    def ratio_after(self, cycles):
        """Of energies without what the changing step made; no step is cut."""
        self.nugget("run", "model.k", "--quiet", "--max-cycles", cycles)
        return self.json("summary.json")["energy"]["ratio_without_step_change"]

    def limit(self, text):
        self.write(text)
        told = self.nugget("check", "model.k").stderr
        found = re.search(r"shell \d+ of part 7 vibrates.*limit of stability is TSSFAC (\S+); the deck has", told)
        self.assertTrue(found, told)
        return float(found[1])

    def test_a_square_alone_by_its_closed_form(self):
        """It swells and shrinks: omega^2 = 4 (1 + nu) c^2 / L^2, whatever the thickness and the rule of integration. Sabotage: nodal masses
        of a sheet."""
        for elform in (2, 16, 5, 9):
            for t, nu in ((0.5, 0.3), (10.0, 0.3), (1.0, 0.45)):
                with self.subTest((elform, t, nu)):
                    self.assertAlmostEqual(self.limit(sheet(elform=elform, t=t, nu=nu, tssfac=0.9)), 1 / math.sqrt(1 + nu), delta=2e-3)

    def test_bulk_viscosity_counts_half(self):
        """4 = dt^2 K/M + 2 dt (C/M) / 2 of the shell that swells at the rate e: K/M = 4 (1 + nu) c^2 / L^2; Q2 of TYPE -1 does the work
        Q2 t rho L c (2e)^2 L^2 a time, M v^2 = rho t L^4 e^2 / 2, so that C/M = 8 Q2 c / L. Sabotage: all of it in every step, or none."""
        q, nu = 0.5, 0.3
        limit = self.limit(sheet(nu=nu, tssfac=0.9, head=f"*CONTROL_BULK_VISCOSITY\n1.5,{q},-1\n"))
        a, b = 4 * (1 + nu), 8 * q
        self.assertAlmostEqual(limit, (-b + math.sqrt(b * b + 16 * a)) / (2 * a), delta=2e-3)

    def test_the_limit_is_sharp(self):
        """Half a percent below and above it."""
        limit = self.limit(sheet(tssfac=0.9))
        self.write(sheet(tssfac=round(0.995 * limit, 4)))
        self.assertAlmostEqual(self.ratio_after(5000), 1.0, delta=0.01)
        self.write(sheet(tssfac=round(1.005 * limit, 4)))
        self.assertIn("the run is unstable", self.nugget("run", "model.k", "--quiet", expect=3).stderr)

    def test_the_default_step_is_stable(self):
        """Each grew without bound at 0.9. Sabotage: the limit told and not taken."""
        cases = [dict(elform=e, **more) for e in (2, 16, 5, 9) for more in (dict(), dict(t=0.1), dict(t=10.0), dict(nu=0.45), dict(skew=0.5), dict(warp=0.1))]
        cases += [dict(nx=5, ny=5, elform=e, skew=1.0, isdo=2) for e in (2, 16)] + [dict(nx=5, skew=1.0, isdo=2)]
        cases += [dict(elform=4, triangles=1, ratio=2.0, nu=0.45), dict(elform=17, triangles=1, ratio=2.0, nu=0.45), dict(elform=4, triangles=1, t=10.0)]
        cases += [dict(nx=5, ny=5, elform=4, triangles=2, t=10.0), dict(nx=5, ny=5, elform=17, triangles=2, t=10.0, nloc=1)]
        for case in cases:
            with self.subTest(case):
                self.write(sheet(**case))
                told = self.nugget("check", "model.k").stderr
                self.assertRegex(told, r"note: \*CONTROL_TIMESTEP.*shell \d+ of part 7 vibrates, with what is around it, faster")
                self.assertAlmostEqual(self.ratio_after(5000), 1.0, delta=0.01)

    def test_strips_and_sheets_keep_their_step(self):
        """0.9 L/c to the last digit. Sabotage: 0.9 of the limit whatever it is, 0.83 to 0.9."""
        for elform in (2, 16, 5, 9):
            for nx, ny, t in ((5, 1, 0.1), (5, 1, 10.0), (2, 2, 1.0), (20, 3, 1.0)):
                with self.subTest((elform, nx, ny, t)):
                    self.write(sheet(nx, ny, elform=elform, t=t))
                    self.assertNotIn("vibrates", self.nugget("check", "model.k").stderr)
                    self.assertAlmostEqual(self.ratio_after(3000), 1.0, delta=0.01)
                    self.assertAlmostEqual(self.json("summary.json")["time_step"]["first"] / (0.9 * step_of_formula()), 1.0, delta=1e-5)

    def test_a_neighbour_slows_it_down(self):
        """A support does, too. Sabotage: supports left out."""
        text = sheet().replace("*END\n", "*BOUNDARY_SPC_NODE\n1,0,1,1,1,1,1,1\n2,0,1,1,1,1,1,1\n*END\n")
        self.write(text)
        self.assertNotIn("vibrates", self.nugget("check", "model.k").stderr)
        self.assertAlmostEqual(self.ratio_after(3000), 1.0, delta=0.01)


if __name__ == "__main__":
    unittest.main()
