# SPDX-License-Identifier: Apache-2.0
"""A barrier: a block of honeycomb behind a face sheet, crushed by a rigid impactor. And what its cards may say."""
import json
import math
import unittest

import lsda
from few_elements import BRICK, CORNERS, card, curve, nodes
from nugget_command import CommandTest

PLATEAU = 0.34  # MPa
HEIGHT, WIDTH, DEPTH = 450.0, 650.0, 1000.0  # of the block: along the impact, across
AREA = WIDTH * DEPTH


def honeycomb(law="026", curves=(7, 0, 0, 7), rate=0, core=(200.0, 100.0, 100.0, 50.0, 50.0, 50.0), mu=0.001, bulk=0, axes=(2, ""),
              a=(0, 0, 1), d=(1, 0, 0), tsef="", ssef="", v=("", "", ""), vf=0.2, density=2.6e-11):
    return (f"*MAT_{law}\n" + card(1, density, 1000.0, 0.3, 50.0, vf, mu, bulk) + card(*curves, 0, 0, 0, rate)
            + card(*core, *axes) + card("", "", "", *a) + card(*d, tsef, ssef, *v))


def barrier(mass, speed, end, limit=((0.0, PLATEAU), (1.0, PLATEAU)), cells=(4, 5, 9), **law):
    """The block stands on the held nodes at z = 0; its face shares its nodes with a sheet of 1 mm; the impactor is 10 mm above it."""
    nx, ny, nz = cells
    places, index = [], {}

    def node(x, y, z):
        places.append((x, y, z))
        return len(places)

    for k in range(nz + 1):
        for j in range(ny + 1):
            for i in range(nx + 1):
                index[i, j, k] = node(i * WIDTH / nx, j * DEPTH / ny, k * HEIGHT / nz)
    solids, sheet = [], []
    for k in range(nz):
        for j in range(ny):
            for i in range(nx):
                solids.append([index[i + x, j + y, k + z] for x, y, z in CORNERS])
    for j in range(ny):
        for i in range(nx):
            sheet.append([index[i + x, j + y, nz] for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))])
    z = HEIGHT + 10.0
    plate = [node(x * WIDTH / 2 - 25.0 + 25.0 * x, y * DEPTH / 2 - 25.0 + 25.0 * y, z) for y in range(3) for x in range(3)]
    shells = [[plate[3 * j + i] for i, j in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))] for j in range(2) for i in range(2)]
    area = (WIDTH + 50.0) * (DEPTH + 50.0)

    def row(*ids):
        return "".join(f"{n:8}" for n in ids) + "\n"

    held = "".join(card(index[i, j, 0], 0, 1, 1, 1) for j in range(ny + 1) for i in range(nx + 1))
    text = ("*KEYWORD\n" + honeycomb(**law) + curve(7, *limit)
            + "*MAT_PIECEWISE_LINEAR_PLASTICITY\n" + card(2, 2.7e-9, 70000.0, 0.33, 100.0, 500.0) + "\n\n\n"
            + "*MAT_RIGID\n" + card(3, f"{mass / area:.4e}", 210000.0, 0.3) + card(1.0, 4, 7) + "\n"
            + "*SECTION_SOLID\n" + card(1, 1) + "*SECTION_SHELL\n" + card(2, 2, 1.0, 3) + card(1.0, 1.0, 1.0, 1.0)
            + "*PART\nblock\n" + card(1, 1, 1) + "*PART\nface sheet\n" + card(2, 2, 2) + "*PART\nimpactor\n" + card(3, 2, 3)
            + "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n" + card(3, 2, 3, 3) + "\n\n"
            + "*BOUNDARY_SPC_NODE\n" + held
            + "*INITIAL_VELOCITY_RIGID_BODY\n" + card(3, 0.0, 0.0, -speed)
            + "*CONTROL_TERMINATION\n" + card(end) + "*CONTROL_ENERGY\n" + card(2, 2, 2, 2)
            + "*DATABASE_GLSTAT\n" + card(f"{end / 100.0:.3e}", 2) + "*DATABASE_RCFORC\n" + card(f"{end / 1000.0:.3e}", 2)
            + "*DATABASE_RBDOUT\n" + card(f"{end / 1000.0:.3e}", 2)
            + nodes(places)
            + "*ELEMENT_SOLID\n" + "".join(row(e + 1, 1) + row(*n) for e, n in enumerate(solids))
            + "*ELEMENT_SHELL\n" + "".join(row(e + 1001, 2, *n) for e, n in enumerate(sheet))
            + "".join(row(e + 2001, 3, *n) for e, n in enumerate(shells)) + "*END\n")
    return text


def stretched(material, strain, corners=CORNERS, elform=1, extra="", curves=(7,), end=1e-3):
    """A cube of 1 mm: each corner goes where the strain `strain(x, y, z)` of the start takes it, steadily; stress in elout."""
    goes = [strain(*place) for place in corners]
    moves = "".join(card(i + 1, axis + 1, 2, 90, f"{u:.3e}") for i, us in enumerate(goes) for axis, u in enumerate(us) if u)
    held = "".join(card(i + 1, 0, *(int(not u) for u in us)) for i, us in enumerate(goes))
    return ("*KEYWORD\n" + material + "*SECTION_SOLID\n" + card(1, elform) + "*PART\nbrick\n" + card(1, 1, 1) + nodes(corners) + BRICK
            + ("*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + moves) * bool(moves) + "*BOUNDARY_SPC_NODE\n" + held + curve(90, (0.0, 0.0), (end, 1.0), (1.0, 1.0 / end))
            + "*CONTROL_TERMINATION\n" + card(end) + "*DATABASE_ELOUT\n" + card(end, 3) + "*DATABASE_HISTORY_SOLID\n" + card(1)
            + extra + "*END\n")


class Crush(CommandTest):
    """The block under the impactor."""

    def crush(self, *arguments, **options):
        """(times, depth, force on the impactor, glstat). Plate and sheet are 1 mm thick, so they meet after 9 mm."""
        self.write(barrier(*arguments, **options))
        self.nugget("run", "model.k", "--quiet")
        found = lsda.read(self.folder / "binout0000")
        body, force = lsda.states(found, "rbdout"), lsda.states(found, "rcforc")
        return ([s["time"][0] for s in body], [-s["global_dz"][0] - 9.0 for s in body], [abs(s["z_force"][0]) for s in force],
                self.glstat())

    def expect_balance(self, states):
        for state in states:
            self.assertLess(abs(state["total energy / initial energy"] - 1.0), 1e-3, state["time"])

    def test_stops_where_the_plateau_has_taken_all_its_energy(self):
        """1 t at 10 m/s: depth m v^2 / (2 s A); the mean force over the time of the crush is s A. Sabotage: limits 3 % lower."""
        time, depth, force, states = self.crush(1.0, 1e4, 0.06)
        self.expect_balance(states)
        expected = 0.5 * 1.0 * 1e8 / (PLATEAU * AREA)
        self.assertLess(abs(max(depth) / expected - 1.0), 0.01, (max(depth), expected))
        during = [f for d, f, t in zip(depth, force, time) if d > 0.1 * expected and t < time[depth.index(max(depth))] * 0.95]
        mean = sum(during) / len(during)
        self.assertLess(abs(mean / (PLATEAU * AREA) - 1.0), 0.01, mean)

    def test_a_rising_curve(self):
        """s = s0 + k e over the volumetric strain e: the depth where the integral has taken all."""
        rise = 0.3
        _, depth, _, states = self.crush(1.0, 1e4, 0.06, limit=((0.0, PLATEAU), (1.0, PLATEAU + rise)))
        self.expect_balance(states)
        energy = 0.5e8 / (AREA * HEIGHT)  # s0 e + k e^2 / 2
        e = (math.sqrt(PLATEAU ** 2 + 2.0 * rise * energy) - PLATEAU) / rise
        self.assertLess(abs(max(depth) / (e * HEIGHT) - 1.0), 0.01, (max(depth), e * HEIGHT))

    def test_compacted_it_stops_hard(self):
        """2 t: the plateau takes 80 % of the height, then what is left is taken elastically by 90 mm of solid, whose modulus in
        uniaxial strain is K + 4 G / 3. Sabotage: no compacted branch."""
        _, depth, _, states = self.crush(2.0, 1e4, 0.08)
        self.expect_balance(states)
        crushed = 0.8 * HEIGHT
        left = 0.5 * 2.0 * 1e8 - PLATEAU * AREA * crushed
        modulus = 1000.0 * 0.7 / (1.3 * 0.4)
        more = math.sqrt(2.0 * left / (modulus * AREA / (HEIGHT - crushed)))
        self.assertLess(abs(max(depth) / (crushed + more) - 1.0), 0.01, (max(depth), crushed + more))

    def test_same_bits_by_threads(self):
        text = barrier(1.0, 1e4, 0.02, cells=(3, 3, 4))
        self.write(text)
        for threads in (1, 2):
            self.nugget("run", "model.k", "-o", f"t{threads}", "-j", threads, "--quiet")
        for name in ("glstat", "binout0000"):
            one, two = ((self.folder / f"t{n}" / name).read_bytes() for n in (1, 2))
            self.assertTrue(one == two, name)


class Law(CommandTest):
    """One brick."""

    def stress(self, deck):
        self.write(deck)
        self.nugget("run", "model.k", "--quiet")
        last = lsda.states(lsda.read(self.folder / "binout0000"), "elout/solid")
        return {name: values[0] for name, values in last[-1].items() if name.startswith("sig")}

    def along(self, x=0.0, y=0.0, z=0.0):
        return lambda a, b, c: (a * x, b * y, c * z)

    def test_moduli_by_the_axes(self):
        """AOPT 0, 2, 3 and a coordinate system; the strain 1e-4 along x meets the modulus of the axis that lies there."""
        wide = curve(7, (0.0, 1.0), (1.0, 1.0))
        system = "*DEFINE_COORDINATE_SYSTEM\n" + card(5, 0, 0, 0, 0, 1, 0) + card(0, 0, 1) + ""
        for what, law, expected in (
                ("nodes", {"axes": (0, "")}, 200.0),
                ("vectors", {"axes": (2, ""), "a": (0, 1, 0), "d": (1, 0, 0)}, 100.0),
                ("cross", {"axes": (3, ""), "v": (1, 0, 0)}, 100.0),   # normal z: a = x cross z = -y, b = x
                ("cross", {"axes": (3, ""), "v": (0, 1, 0)}, 200.0),
                ("system", {"axes": (-5, "")}, 70.0)):
            law = honeycomb(core=(200.0, 100.0, 70.0, 50.0, 50.0, 50.0), mu=1e-9, **law)
            seen = self.stress(stretched(law + wide + (system if what == "system" else ""), self.along(x=1e-4)))
            self.assertAlmostEqual(seen["sig_xx"] / (1e-4 * expected), 1.0, delta=2e-3, msg=what)

    def test_axes_turn_with_an_include(self):
        """A brick turned by 40 degrees about z with its vectors a and d, stretched along its side. Sabotage: vectors as written."""
        cosine, sine = math.cos(math.radians(40.0)), math.sin(math.radians(40.0))
        law = honeycomb(mu=1e-9, a=(1, 0, 0), d=(0, 1, 0)) + curve(7, (0.0, 1.0), (1.0, 1.0))
        self.write("*KEYWORD\n" + law + "*SECTION_SOLID\n" + card(1, 1) + "*PART\nbrick\n" + card(1, 1, 1) + nodes(CORNERS) + BRICK
                   + "*END\n", "brick.k")
        moves = "".join(card(i + 1, axis, 2, 90, f"{1e-3 * way:.3e}") for i, place in enumerate(CORNERS) if place[0]
                        for axis, way in ((1, cosine), (2, sine)))
        held = "".join(card(i + 1, 0, 1 - place[0], 1 - place[0], 1) for i, place in enumerate(CORNERS))
        seen = self.stress(
            "*KEYWORD\n*INCLUDE_TRANSFORM\nbrick.k\n" + card(*7 * [0]) + card(0) + card(1, 1, 1, 1) + card(5) + "*DEFINE_TRANSFORMATION\n"
            + card(5) + "ROTATE    " + card(0, 0, 1, 0, 0, 0, 40.0) + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + moves
            + "*BOUNDARY_SPC_NODE\n" + held + curve(90, (0.0, 0.0), (1e-3, 1.0), (1.0, 1000.0)) + "*CONTROL_TERMINATION\n" + card(1e-3)
            + "*DATABASE_ELOUT\n" + card(1e-3, 3) + "*DATABASE_HISTORY_SOLID\n" + card(1) + "*END\n")
        for name, expected in (("sig_xx", cosine ** 2), ("sig_yy", sine ** 2), ("sig_xy", cosine * sine)):
            self.assertAlmostEqual(seen[name], 0.2 * expected, delta=2e-4)

    def test_formulation_0_looks_up_engineering_strains(self):
        """MAT_126, crushed to half: 0.5 of engineering strain, ln 2 = 0.693 of logarithmic strain."""
        rising = curve(7, (0.0, 0.1), (1.0, 1.1))
        law = honeycomb("126", mu=1e-9, axes=(2, ""), a=(1, 0, 0), d=(0, 1, 0))
        for elform, strain in ((0, 0.5), (1, math.log(2.0))):
            seen = self.stress(stretched(law + rising, self.along(x=-0.5), elform=elform))
            self.assertAlmostEqual(seen["sig_xx"], -(0.1 + strain), delta=2e-3)

    def test_torn_bricks_are_deleted(self):
        """TSEF and SSEF at a strain of 0.1; what is crushed by 0.5 stays. Sabotage: the shear of a crush counted."""
        wide = curve(7, (0.0, 1.0), (1.0, 1.0))
        pull, shear, crush = self.along(x=0.5), (lambda x, y, z: (0.5 * y, 0.0, 0.0)), self.along(x=-0.5)
        for tsef, ssef, strain, time in ((0.1, 0.0, pull, (math.exp(0.1) - 1.0) / 0.5), (0.0, 0.1, shear, 0.2), (0.1, 0.1, crush, None)):
            law = honeycomb(mu=1e-9, a=(1, 0, 0), d=(0, 1, 0), tsef=tsef, ssef=ssef)
            self.write(stretched(law + wide, strain, end=1e-2, extra="*DATABASE_GLSTAT\n" + card(1e-4, 2)))
            self.nugget("run", "model.k", "--quiet")
            gone = [state["time"] for state in self.glstat() if state["eroded internal energy"] > 0.0]
            if time is None:
                self.assertEqual(gone, [])
            else:
                self.assertAlmostEqual(gone[0], time * 1e-2, delta=1.5e-4)

    def test_modes_have_no_viscosity(self):
        """A bar of 10 bricks held at one end, moving along it only: sqrt(E / density) / (4 L), E of the uncrushed core, or of MAT_063;
        both with a tenth of critical damping. Sabotage: the viscous stress, which made it 5 % faster."""
        places = [(i, y, z) for i in range(11) for y, z in ((0, 0), (1, 0), (1, 1), (0, 1))]
        bricks = "".join(f"{i + 1:8}{1:8}\n" + "".join(f"{4 * i + k:8}" for k in (1, 5, 6, 2, 4, 8, 7, 3)) + "\n" for i in range(10))
        held = "".join(card(n + 1, 0, int(n < 4), 1, 1) for n in range(44))
        for law in (honeycomb(a=(1, 0, 0), d=(0, 1, 0), mu=0.1) + curve(7, (0.0, 1.0), (1.0, 1.0)),
                    "*MAT_063\n" + card(1, 2.6e-11, 200.0, 0.0, 7, 1.0, 0.1) + curve(7, (0.0, 1.0), (0.5, 1.0), (0.6, 21.0))):
            self.write("*KEYWORD\n" + law + "*SECTION_SOLID\n" + card(1, 1) + "*PART\nbar\n" + card(1, 1, 1) + nodes(places)
                       + "*ELEMENT_SOLID\n" + bricks + "*BOUNDARY_SPC_NODE\n" + held + "*CONTROL_TERMINATION\n" + card(1e-6) + "*END\n")
            self.nugget("modes", "model.k", "-n", 1, "-o", "modes", "--quiet")
            first = self.json("modes/summary.json")["modes"][0]["frequency_hz"]
            self.assertAlmostEqual(first / (math.sqrt(200.0 / 2.6e-11) / 40.0), 1.0, delta=2e-3)


class Cards(CommandTest):
    def findings(self, material, expect):
        self.write(stretched(material, lambda x, y, z: (0.0, 0.0, 0.0)))
        self.nugget("check", "model.k", expect=1 if expect == "error" else 0)
        return [f for f in json.loads(self.read("findings.json")) if f["severity"] == expect]

    def expect(self, material, field, words, severity="error"):
        found = self.findings(material, severity)
        self.assertTrue(any(f["field"].lower() == field and words in f["text"] and f["line"] for f in found), (field, words, found))

    def test_what_the_cards_may_not_say(self):
        flat = curve(7, (0.0, 1.0), (1.0, 1.0))
        self.assertEqual(self.findings(honeycomb() + flat, "warning"), [])
        self.assertEqual(self.findings(honeycomb() + curve(7, (0.1, 1.0), (1.0, 1.0)), "warning"), [])
        self.expect(honeycomb(vf=1.0) + flat, "vf", "between 0 and 1")
        self.expect(honeycomb() + curve(7, (0.1, 1.0), (0.8, 1.0)), "lca", "neither over the relative volume")
        self.expect(honeycomb() + curve(7, (0.0, -1.0), (0.8, -1.0)), "lca", "below 0")
        self.expect(honeycomb() + curve(7, (0.0, 1.0), (0.5, 0.1)), "lca", "before the material is compacted")
        self.expect(honeycomb() + curve(7, (0.0, 0.1), (0.1, 0.1), (0.11, 90.0), (1.0, 91.0)), "lca", "lags", "warning")
        self.expect(honeycomb() + curve(7, (0.5, 1.0), (1.0, 1.0)), "lca", "VF is 0.2", "warning")
        self.expect(honeycomb(axes=(1, "")) + flat, "aopt", "only 0, 2, 3")
        self.expect(honeycomb(axes=(2, 2)) + flat, "macf", "")
        self.expect(honeycomb(axes=(3, ""), v=(0, 0, 1)) + flat, "mid", "normal to its midway surface")
        self.expect(honeycomb(curves=(7, 8, 0, 0)) + flat, "lcb", "not defined")
        modified = honeycomb("126")
        self.assertEqual(self.findings(modified + flat, "warning"), [])
        self.expect(modified.replace("         7         0         0         7", "        -7         0         0         7") + flat, "lca", "not built")
        self.expect(honeycomb("126", rate=-1) + flat, "lcsr", "not built")

    def test_formulation_0_of_bricks(self):
        flat = curve(7, (0.0, 1.0), (1.0, 1.0))
        second = ("*SECTION_SOLID\n" + card(2, 1) + "*PART\nother\n" + card(2, 2, 1) + BRICK.replace("       1       1\n", "       2       2\n"))
        for law, expected, refused in (("026", "as a blank field is", 0), ("126", "curves over engineering strains", 1)):
            self.write(stretched(honeycomb(law) + flat, lambda x, y, z: (0.0, 0.0, 0.0), elform=0))
            self.nugget("check", "model.k")
            self.assertIn(expected, json.loads(self.read("findings.json"))[0]["text"])
            self.write(stretched(honeycomb(law) + flat, lambda x, y, z: (0.0, 0.0, 0.0), elform=0, extra=second))
            self.nugget("check", "model.k", expect=refused)
            self.assertEqual("give each its own material" in self.read("findings.json"), bool(refused))


if __name__ == "__main__":
    unittest.main()
