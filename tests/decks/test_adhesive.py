# SPDX-License-Identifier: Apache-2.0
"""Adhesive of cohesive bricks: what its cards may say, its results, ties to sheets of another mesh, its modes, units."""
import math
import unittest

import lsda
from few_elements import card, curve, nodes
from nugget_command import CommandTest

EN, ET, GIC, GIIC, T, S = 1.0e4, 4.0e3, 2.0, 6.0, 40.0, 30.0


def mixed(ro="3.e-10", roflg=1, intfail=1, en=EN, et=ET, gic=GIC, giic=GIIC, xmu=1.0, t=T, s=S, und="", utd="", gamma="", name="MIXED_MODE"):
    return f"*MAT_COHESIVE_{name}\n" + card(1, ro, roflg, intfail, en, et, gic, giic) + card(xmu, t, s, und, utd, gamma)


def elastic(ro="3.e-10", roflg=1, intfail=1, et=ET, en=EN, fn="", ft=""):
    return "*MAT_COHESIVE_ELASTIC\n" + card(1, ro, roflg, intfail, et, en, fn, ft)


def layer(thick, emod=2000.0, gmod=800.0, tension=(2.0, "", "", 20.0, "", "", 0.3), shear=(6.0, "", "", 15.0, "", "", 0.4), more=""):
    return ("*MAT_COHESIVE_MIXED_MODE_ELASTOPLASTIC_RATE\n" + card(1, "1.e-9", 0, 1, emod, gmod, thick, "") + card(*tension) + card(*shear) + more)


def scaled(ro="3.e-10", roflg=1, intfail=1, sigmax=T, nls=0.1, tls=0.15, lamda=(0.2, 1.0, 2.0), stfsf=1.0):
    return "*MAT_COHESIVE_TH\n" + card(1, ro, roflg, intfail, sigmax, nls, tls, "") + card(*lamda, stfsf)


def general(points=((0.0, 0.0), (0.1, 1.0), (0.4, 0.7), (1.0, 0.0)), tes=0, xmu=1.0, stfsf="", tslc2="", gic=GIC, t=T):
    return ("*MAT_COHESIVE_GENERAL\n" + card(1, "3.e-10", 1, 1, tes, 80, gic, GIIC) + card(xmu, t, S, stfsf, tslc2)
            + curve(80, *points))


def arup(extra=2, thkdir=0, edot2="", shrmax=S, sht_sl="", bthk=0.3, more="", tenmax=T):
    return ("*MAT_ARUP_ADHESIVE\n" + card(1, "1.e-9", 3000.0, 0.3, tenmax, GIC, shrmax, GIIC) + card(2.0, 2.0, "", sht_sl, "", edot2, thkdir, extra)
            + more + (card(bthk) if extra >= 2 else ""))


def row(*ids):
    return "".join(f"{n:8}" for n in ids) + "\n"


def element(identity, corners):
    return row(identity, 1) + row(*corners)


def section(elform=19, cohoff=""):
    return "*SECTION_SOLID\n" + card(1, elform, "", "", "", "", cohoff)


def single(material, height=0.0, elform=19, corners=range(1, 9), extra="", side=5.0, cohoff=""):
    places = [(side * x, side * y, z) for z in (0.0, height) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
    return (material + section(elform, cohoff) + "*PART\nadhesive\n" + card(1, 1, 1) + nodes(places) + "*ELEMENT_SOLID\n"
            + element(1, corners) + extra)


def pulled(end=2e-4, reach=0.11, direction=3):
    """The upper four nodes go by `reach`, the lower ones stand."""
    held = "".join(card(n, 0, 1, 1, 1) for n in range(1, 5)) + "".join(card(n, 0, *(int(direction != d) for d in (1, 2, 3))) for n in range(5, 9))
    return ("*BOUNDARY_SPC_NODE\n" + held + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + "".join(card(n, direction, 2, 90) for n in range(5, 9))
            + curve(90, (0.0, 0.0), (end, reach)) + "*CONTROL_TERMINATION\n" + card(end) + "*CONTROL_ENERGY\n" + card(2, 2, 2, 2)
            + "*DATABASE_GLSTAT\n" + card(f"{end / 100.0:.3e}", 1) + "*DATABASE_ELOUT\n" + card(f"{end / 400.0:.3e}", 2)
            + "*DATABASE_HISTORY_SOLID\n" + card(1))


def deck(*parts):
    return "*KEYWORD\n" + "".join(parts) + "*END\n"


class Cards(CommandTest):
    def findings(self, *parts, expect=1):
        self.write(deck(*parts, "*CONTROL_TERMINATION\n" + card("1.e-5")))
        self.nugget("check", "model.k", "-o", "audit", expect=expect)
        return self.json("audit/findings.json")

    def assert_refused(self, text, *parts):
        errors = [f for f in self.findings(*parts) if f["severity"] == "error"]
        self.assertEqual(len(errors), 1, errors)
        self.assertIn(text, errors[0]["text"])
        self.assertTrue(errors[0]["remedy"] and errors[0]["line"])
        return errors[0]

    def test_energies_that_the_peak_exceeds(self):
        found = self.assert_refused("too small", single(mixed(gic=0.07)))  # T^2/(2 EN) = 0.08
        self.assertEqual(found["field"], "gic")
        self.assertEqual(self.assert_refused("too small", single(mixed(giic=0.11)))["field"], "giic")
        self.assert_refused("either the highest traction", single(mixed(t="")))
        self.assert_refused("must be given", single(mixed(xmu="0.0")))
        self.assert_refused("whole number", single(mixed(intfail=1.5)))
        self.assertEqual(self.assert_refused("too small", single(layer(0.4, tension=(0.03, "", "", 20.0)), 0.4))["field"], "g1c_0")
        self.assertIn("THICK", self.assert_refused("its strain rates follow", single(layer(""), 0.0))["remedy"])
        self.assertIn("rfiltf", [f["field"] for f in self.findings(single(layer(0.4, more=card(0.5)), 0.4))])

    def test_shapes_of_the_traction(self):
        self.assert_refused("lies before LAMDA1", single(scaled(lamda=(0.5, 0.2, 1.0))))
        self.assert_refused("lies before LAMDA2", single(scaled(lamda=(0.1, 1.2, 1.0))))
        self.assert_refused("must be given", single(scaled(stfsf="")))
        self.assert_refused("is not documented", single(general(tes=2)))
        self.assert_refused("expected three points or more", single(general(((0.0, 0.0), (0.1, 1.0), (0.9, 0.0)))))
        self.assert_refused("highest ordinate is 40", single(general(((0.0, 0.0), (0.1, 40.0), (1.0, 0.0)))))
        self.assert_refused("negative ordinates", single(general(((0.0, 0.0), (0.1, 1.0), (0.5, -0.1), (1.0, 0.0)))))
        self.assert_refused("gets steeper", single(general(((0.0, 0.0), (0.1, 0.2), (0.3, 1.0), (1.0, 0.0)))))
        self.assertEqual(self.findings(single(general(tslc2=80)))[0]["field"], "tslc2")

    def test_arup_adhesive(self):
        self.assert_refused("failure of the interfaces", single(arup(extra=1, more=card(1.0) + card(1.0)), 0.3))
        self.assert_refused("leaves no shear strength", single(arup(sht_sl=0.8), 0.3))
        self.assert_refused("is not above EDOT0", single(arup(edot2=0.5, more=card(1.5)), 0.3))
        self.assert_refused("other faces that lie closer", single(arup(), 6.0))
        self.assert_refused("which bricks of ELFORM 3 do not", single(arup(), 0.3, elform=3))
        self.findings(single(arup(thkdir=1), 6.0), expect=0)
        self.findings(single(arup(tenmax=""), 0.3), expect=0)
        found = self.findings(single(arup(), 0.3, elform=1), expect=0)
        self.assertTrue(any("computed as cohesive bricks (19)" in f["text"] for f in found), found)

    def test_laws_and_bricks_that_do_not_go_together(self):
        self.assert_refused("is no law of adhesive", single("*MAT_ELASTIC\n" + card(1, "7.8e-9", 2.1e5, 0.3), 0.3))
        self.assert_refused("which bricks of ELFORM 1 do not", single(mixed(), 0.3, elform=1))
        self.assert_refused("this law of adhesive is not built", single(mixed(), extra="*MAT_COHESIVE_PAPER\n" + card(7)))
        self.assert_refused("elsewhere than midway", single(mixed(), 1.0, elform=20, cohoff=0.5))
        self.assert_refused("erosion cannot be added", single(mixed(), extra="*MAT_ADD_EROSION\n" + card(1) + card(1, "", 0.2) + "\n"))
        self.assert_refused("which bricks of ELFORM -19 do not", single(mixed(), 0.3, elform=-19))

    def test_shapes(self):
        self.assert_refused("upside down", single(mixed(), 0.3, corners=(5, 6, 7, 8, 1, 2, 3, 4)))
        self.assert_refused("no area midway", single(mixed(), 0.3, corners=(1, 2, 3, 4, 7, 8, 5, 6)))
        self.assertIn("ROFLG = 1", self.assert_refused("has no thickness", single(mixed(ro="1.e-9", roflg=0)))["remedy"])
        self.assert_refused("repeats nodes", single(mixed(), 0.3, corners=(1, 2, 2, 3, 5, 6, 7, 7)))

    def test_a_brick_that_stands_on_its_side_is_warned_of(self):
        """Faces 1-2-6-5 and 4-3-7-8: 5 mm apart, 0.3 mm wide."""
        found = self.findings(single(mixed(ro="1.e-9", roflg=0), 0.3, corners=(5, 6, 2, 1, 8, 7, 3, 4)), expect=0)
        self.assertEqual([f["severity"] for f in found if "may not be those on the sheets" in f["text"]], ["warning"])

    def test_nodes_of_no_shell_under_20(self):
        found = self.findings(single(mixed(), 1.0, elform=20), expect=0)
        self.assertTrue(any("that are of no shell" in f["text"] for f in found), found)


class Pulled(CommandTest):
    def run_single(self, *parts):
        self.write(deck(*parts))
        self.nugget("run", "model.k", "--quiet", "-j", 1)
        return lsda.states(lsda.read(self.folder / "binout0000"), "elout/solid"), self.json("summary.json")

    def test_tractions_stand_in_elout_and_the_brick_is_deleted(self):
        states, summary = self.run_single(single(mixed()), pulled())
        normal = [s["sig_zz"][0] for s in states]
        self.assertAlmostEqual(max(normal), T, delta=0.02 * T)
        self.assertEqual(normal[-1], 0.0)
        self.assertLess(max(abs(s["sig_xx"][0]) + abs(s["sig_yy"][0]) for s in states), 1e-6)
        # T falls in a straight line: halfway between onset 0.004 and failure 0.1.
        near = min(states, key=lambda s: abs(s["time"][0] - 2e-4 * 0.052 / 0.11))
        self.assertAlmostEqual(near["sig_zz"][0], 0.5 * T, delta=0.01 * T)
        self.assertAlmostEqual(summary["energy"]["eroded"], GIC * 25.0, delta=1e-3 * GIC * 25.0)
        self.assertAlmostEqual(summary["energy"]["ratio"], 1.0, delta=1e-6)
        self.assertIn("adhesive of part 1: 1 of 1 bricks deleted", self.read("run.log"))

    def test_und_gives_the_peak(self):
        states, _ = self.run_single(single(mixed(t="", und=0.08)), pulled())
        self.assertAlmostEqual(max(s["sig_zz"][0] for s in states), 2.0 * GIC / 0.08, delta=1.0)

    def test_intfail_0_is_never_deleted(self):
        _, summary = self.run_single(single(mixed(intfail=0)), pulled())
        self.assertAlmostEqual(summary["energy"]["internal"], GIC * 25.0, delta=1e-3 * GIC * 25.0)
        self.assertIn("0 of 1 bricks deleted, largest damage of the others 1.000", self.read("run.log"))

    def test_elastic_bond_fails_by_either_traction(self):
        for direction, limits, name, strength in ((3, {"fn": 25.0}, "sig_zz", 25.0), (1, {"ft": 12.0}, None, 12.0)):
            states, _ = self.run_single(single(elastic(**limits)), pulled(reach=0.01, direction=direction))
            sizes = [s[name][0] if name else math.hypot(s["sig_xx"][0], s["sig_yy"][0]) for s in states]
            self.assertAlmostEqual(max(sizes), strength, delta=0.02 * strength)
            self.assertEqual(sizes[-1], 0.0)

    def test_a_wedge_has_the_energy_of_its_area(self):
        _, summary = self.run_single(single(mixed(), elform=21, corners=(1, 2, 3, 3, 5, 6, 7, 7)), pulled())
        self.assertAlmostEqual(summary["energy"]["eroded"], GIC * 12.5, delta=2e-3 * GIC * 12.5)

    def test_layer_that_yields(self):
        """*MAT_240: trapezoids of the energies; stiffness by THICK, or where it is blank by the brick's own 0.4."""
        for thick, direction, strength, energy in ((0.4, 3, 20.0, 2.0), ("", 3, 20.0, 2.0), (0.4, 1, 15.0, 6.0)):
            states, summary = self.run_single(single(layer(thick), height=0.4), pulled(reach=0.8, direction=direction))
            sizes = [math.sqrt(s["sig_xx"][0] ** 2 + s["sig_yy"][0] ** 2 + s["sig_zz"][0] ** 2) for s in states]
            self.assertAlmostEqual(max(sizes), strength, delta=1e-6 * strength)
            self.assertAlmostEqual(summary["energy"]["eroded"], energy * 25.0, delta=3e-3 * energy * 25.0)
            # The plateau: its share of the energy over the traction.
            share = 0.3 if direction == 3 else 0.4
            flat = sum(size > 0.999999 * strength for size in sizes) / len(sizes) * 0.8
            self.assertAlmostEqual(flat, share * energy / strength, delta=0.8 / 150.0)

    def test_layer_that_hardens_with_its_rate(self):
        """T = |T0| + |T1| ln(rate/EDOT_T) at the steady rate 0.8/2e-4/0.4."""
        tension = (-2.0, 4.0, 1000.0, -20.0, -3.0, 1.0, 0.3)
        states, summary = self.run_single(single(layer(0.4, tension=tension), height=0.4), pulled(reach=0.8))
        rate = 0.8 / 2e-4 / 0.4
        strength = 20.0 + 3.0 * math.log(rate)
        energy = 2.0 + 2.0 * math.exp(-1000.0 / rate)
        self.assertAlmostEqual(max(s["sig_zz"][0] for s in states), strength, delta=1e-3 * strength)
        self.assertAlmostEqual(summary["energy"]["eroded"], energy * 25.0, delta=5e-3 * energy * 25.0)

    def test_traction_along_a_curve(self):
        """*MAT_185 and 186, in tension and in shear: highest traction, energy, deletion."""
        for law, direction, strength, energy in ((scaled(), 3, T, 0.7 * 0.1 * T), (scaled(), 1, T * 0.1 / 0.15, 0.7 * 0.1 * T),
                                                 (general(), 3, T, GIC), (general(), 1, S, GIIC)):
            states, summary = self.run_single(single(law), pulled(reach=0.5, direction=direction))
            sizes = [math.sqrt(s["sig_xx"][0] ** 2 + s["sig_yy"][0] ** 2 + s["sig_zz"][0] ** 2) for s in states]
            self.assertAlmostEqual(max(sizes), strength, delta=0.03 * strength)
            self.assertEqual(sizes[-1], 0.0)
            self.assertAlmostEqual(summary["energy"]["eroded"], energy * 25.0, delta=3e-3 * energy * 25.0)
            self.assertIn("adhesive of part 1: 1 of 1 bricks deleted", self.read("run.log"))

    def test_arup_adhesive_in_plain_bricks(self):
        """ELFORM 1 as 19, in tension and shear; a mode without strength given stays elastic. Sabotage: deleted at the first point."""
        for elform in (1, 19):
            for direction, strength, energy in ((3, T, GIC), (1, S, GIIC)):
                states, summary = self.run_single(single(arup(), 0.3, elform=elform), pulled(reach=0.5, direction=direction))
                sizes = [math.sqrt(s["sig_xx"][0] ** 2 + s["sig_yy"][0] ** 2 + s["sig_zz"][0] ** 2) for s in states]
                self.assertAlmostEqual(max(sizes), strength, delta=0.01 * strength)
                self.assertAlmostEqual(summary["energy"]["eroded"], energy * 25.0, delta=3e-3 * energy * 25.0)
        _, summary = self.run_single(single(arup(tenmax=""), 0.3), pulled(reach=0.1))
        stiffness = 3000.0 * 0.7 / (1.3 * 0.4) / 0.3
        self.assertAlmostEqual(summary["energy"]["internal"] / (0.5 * stiffness * 0.1**2 * 25.0), 1.0, delta=1e-2)

    def test_step_of_a_bond_that_is_stiffer_under_pressure(self):
        """sqrt(2 m/(k A)) with the stiffest, 5 times that of the tension. Sabotage: the stiffness of the tension."""
        first = []
        for stfsf in (1.0, 5.0):
            _, summary = self.run_single(single(scaled(stfsf=stfsf)), pulled())
            first.append(summary["time_step"]["first"])
        self.assertAlmostEqual(first[0] / first[1], math.sqrt(5.0), delta=1e-9)

    def test_units_of_an_included_scaled_bond(self):
        """In m, kg, s, included into mm, t, s. Sabotage: NLS as a number."""
        self.write("*KEYWORD\n" + single(scaled(ro="3.e-1", sigmax="4.e7", nls="1.e-4", tls="1.5e-4"), side=0.005) + "*END\n", "bond.k")
        include = "*INCLUDE_TRANSFORM\nbond.k\n" + card(0, 0, 0, 0, 0, 0, 0) + card(0) + card(1e-3, 1.0, 1e3) + card(0)
        states, summary = self.run_single(include, pulled())
        self.assertAlmostEqual(max(s["sig_zz"][0] for s in states), T, delta=0.02 * T)
        self.assertAlmostEqual(summary["energy"]["eroded"], 0.07 * T * 25.0, delta=1e-3 * 0.07 * T * 25.0)

    def test_mass_scaling(self):
        states, plain = self.run_single(single(mixed()), pulled())
        states, scaled = self.run_single(single(mixed()), pulled(), "*CONTROL_TIMESTEP\n" + card("", 0.9, "", "", "-5.e-7"))
        self.assertAlmostEqual(scaled["time_step"]["first"], 0.9 * 5e-7, delta=1e-12)
        # Two faces of half the mass each on EN and the area, four points apart: sqrt(2 m / (k A)), m and A of a node.
        own = math.sqrt(2.0 * 3e-10 / 8.0 / (EN / 4.0))
        self.assertAlmostEqual(plain["time_step"]["first"], 0.9 * own, delta=1e-3 * own)
        added = plain["mass"]["physical"] * ((5e-7 / own) ** 2 - 1.0)
        self.assertAlmostEqual(scaled["mass"]["added"], added, delta=2e-3 * added)
        self.assertAlmostEqual(scaled["energy"]["eroded"], GIC * 25.0, delta=3e-3 * GIC * 25.0)

    def test_units_of_an_included_file(self):
        """The adhesive in m, kg, s, included into mm, t, s. Sabotage: EN as a stress."""
        self.write("*KEYWORD\n" + single(mixed(ro="3.e-1", en="1.e13", et="4.e12", gic="2.e3", giic="6.e3", t="4.e7", s="3.e7"), side=0.005)
                   + "*END\n", "bond.k")
        include = "*INCLUDE_TRANSFORM\nbond.k\n" + card(0, 0, 0, 0, 0, 0, 0) + card(0) + card(1e-3, 1.0, 1e3) + card(0)
        states, summary = self.run_single(include, pulled())
        self.assertAlmostEqual(max(s["sig_zz"][0] for s in states), T, delta=0.02 * T)
        self.assertAlmostEqual(summary["energy"]["eroded"], GIC * 25.0, delta=1e-3 * GIC * 25.0)
        self.assertAlmostEqual(summary["mass"]["physical"], 25.0 * 3e-10, delta=1e-14)


def sheets(contact, elform, direction, end=4e-4, reach=0.5, law=None, at=(0.0, 1.6), stiffness=1.0):
    """Two sheets of 30 x 30, 3 x 3 shells, 1.6 mm apart; between them 20 x 20 of adhesive, 5 x 5 bricks with nodes of their own
    `at` these heights."""
    places, shells, bricks = [], "", ""

    def grid(count, low, high, z):
        first = len(places) + 1
        step = (high - low) / count
        places.extend((low + step * i, low + step * j, z) for j in range(count + 1) for i in range(count + 1))
        return lambda i, j: first + j * (count + 1) + i

    square = ((0, 0), (1, 0), (1, 1), (0, 1))
    plates = [grid(3, 0.0, 30.0, z) for z in (0.0, 1.6)]
    faces = [grid(5, 4.0, 24.0, z) for z in at]
    for k, plate in enumerate(plates):
        shells += "".join(row(100 * (k + 1) + 3 * j + i, 2 + k, *(plate(i + x, j + y) for x, y in square)) for j in range(3) for i in range(3))
    for j in range(5):
        for i in range(5):
            bricks += element(1 + 5 * j + i, [face(i + x, j + y) for face in faces for x, y in square])
    held = "".join(card(n, 0, 1, 1, 1, 1, 1, 1) for n in range(1, 17))
    held += "".join(card(n, 0, *(int(direction != d) for d in (1, 2, 3)), 1, 1, 1) for n in range(17, 33))
    return deck(law or mixed(), section(elform), "*PART\nadhesive\n" + card(1, 1, 1), "*MAT_ELASTIC\n" + card(2, "7.8e-9", 2.1e5, 0.3),
                "*SECTION_SHELL\n" + card(2, 2) + card(1.0, 1.0, 1.0, 1.0), "*PART\nlower\n" + card(2, 2, 2), "*PART\nupper\n" + card(3, 2, 2),
                nodes(places), "*ELEMENT_SOLID\n" + bricks, "*ELEMENT_SHELL\n" + shells,
                "*SET_PART_LIST\n" + card(1) + card(2, 3), f"*CONTACT_{contact}\n" + card(1, 1, 3, 2) + "\n" + card(stiffness),
                "*BOUNDARY_SPC_NODE\n" + held, "*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + "".join(card(n, direction, 2, 90) for n in range(17, 33)),
                curve(90, (0.0, 0.0), (end, reach)), "*CONTROL_TERMINATION\n" + card(end), "*CONTROL_ENERGY\n" + card(2, 2, 2, 2),
                "*DATABASE_GLSTAT\n" + card(f"{end / 100.0:.3e}", 1), "*DATABASE_BINARY_D3PLOT\n" + card(f"{end / 4.0:.3e}"))


class Tied(CommandTest):
    def expect_energy(self, contact, elform, direction, energy, law=None):
        self.write(sheets(contact, elform, direction, law=law))
        self.nugget("run", "model.k", "--quiet", "-j", 1)
        summary = self.json("summary.json")
        self.assertAlmostEqual(summary["energy"]["eroded"], energy, delta=3e-3 * energy)
        self.assertAlmostEqual(summary["energy"]["ratio"], 1.0, delta=1e-3)
        self.assertIn("adhesive of part 1: 25 of 25 bricks deleted", self.read("run.log"))

    def test_bricks_of_20_tied_to_shells(self):
        self.expect_energy("TIED_SHELL_EDGE_TO_SURFACE", 20, 3, 400.0 * GIC)
        self.expect_energy("TIED_SHELL_EDGE_TO_SURFACE", 20, 1, 400.0 * GIIC)
        self.expect_energy("TIED_SHELL_EDGE_TO_SURFACE", 20, 3, 400.0 * 0.07 * T, law=scaled())
        self.expect_energy("TIED_SHELL_EDGE_TO_SURFACE", 20, 1, 400.0 * GIIC, law=general())

    def test_ties_that_fail_or_begin_later_do_not_hold_it(self):
        for contact, late in (("TIED_NODES_TO_SURFACE", 1e-5), ("TIED_SURFACE_TO_SURFACE_FAILURE", 0.0)):
            tied = f"*CONTACT_{contact}\n" + card(1, 1, 3, 2)
            self.write(sheets(contact, 19, 3).replace(tied + "\n", tied + card(1.0, 1.0, "", "", "", "", late)))
            self.assertIn("part 1 is adhesive, which a tie", self.nugget("check", "model.k", expect=1).stderr)

    def test_bricks_of_19_tied_to_shells(self):
        self.expect_energy("TIED_NODES_TO_SURFACE", 19, 1, 400.0 * GIIC)

    def test_hinges_are_warned_of(self):
        """ELFORM 20 on hinges gives way to shear. Sabotage: told as of any other hinged node, by a note that `run` does not show."""
        for contact, elform, told in (("TIED_NODES_TO_SURFACE", 20, True), ("TIED_NODES_TO_SURFACE", 19, False),
                                      ("TIED_SHELL_EDGE_TO_SURFACE", 20, False)):
            self.write(sheets(contact, elform, 3))
            self.nugget("check", "model.k", "-o", "audit")
            found = [f["text"] for f in self.json("audit/findings.json") if f["severity"] == "warning" and "translations only" in f["text"]]
            self.assertEqual(len(found), int(told), (contact, elform))
            self.assertEqual(["72 nodes" in text and "finds no hold" in text for text in found], [True] * told)

    def told(self, *arguments, **options):
        self.write(sheets(*arguments, **options))
        self.nugget("check", "model.k", "-o", "audit")
        return [(f["severity"], f["text"]) for f in self.json("audit/findings.json") if "of adhesive" in f["text"]]

    def test_springs_are_warned_of(self):
        """They leave a sixth of EN here, where SFSA below 1 asks for them. Sabotage: ties by constraint counted too."""
        for contact, elform in (("TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET", 20), ("TIED_NODES_TO_SURFACE_OFFSET", 19)):
            self.assertEqual(self.told(contact, elform, 3), [])
            ((severity, text),) = self.told(contact, elform, 3, stiffness=0.9)
            self.assertEqual((severity, text.split(":")[0]), ("warning", "72 nodes of adhesive are tied by springs"))
        for contact in ("TIED_SHELL_EDGE_TO_SURFACE", "TIED_SHELL_EDGE_TO_SURFACE_CONSTRAINED_OFFSET"):
            self.assertEqual(self.told(contact, 20, 3), [])

    def test_a_thickness_that_ties_change_is_told(self):
        """Drawn between the faces of the sheets, 0.6 thick, moved onto their mid-surfaces, 1.6 apart. Sabotage: a note where EMOD/THICK follows."""
        between = {"at": (0.5, 1.1)}
        for law, severities in ((layer(""), ["warning"]), (layer(0.6), ["note"]), (mixed(), ["note"])):
            found = self.told("TIED_SHELL_EDGE_TO_SURFACE", 20, 3, law=law, **between)
            self.assertEqual([severity for severity, _ in found], severities)
            self.assertIn("25 bricks of adhesive", found[0][1])
            self.assertIn("1.6 in place of 0.6", found[0][1])
        self.assertEqual(self.told("TIED_SHELL_EDGE_TO_SURFACE_CONSTRAINED_OFFSET", 20, 3, law=layer(""), **between), [])

    def test_any_number_of_threads_gives_the_same_and_d3plot_has_the_tractions(self):
        self.write(sheets("TIED_SHELL_EDGE_TO_SURFACE", 20, 3))
        seen = set()
        for threads in (1, 3):
            self.nugget("run", "model.k", "--quiet", "-j", threads, "-o", f"t{threads}")
            seen.add(self.read(f"t{threads}/glstat").split("time...", 1)[1])
        self.assertEqual(len(seen), 1)
        found = self.d3plot("t1")
        self.assertTrue(found)


class Linear(CommandTest):
    def test_two_free_sheets_bonded_by_tied_bricks_have_six_rigid_motions(self):
        for elform, contact in ((19, "TIED_NODES_TO_SURFACE"), (20, "TIED_SHELL_EDGE_TO_SURFACE")):
            free = sheets(contact, elform, 3).split("*BOUNDARY_SPC_NODE")[0]
            self.write(free + "*CONTROL_IMPLICIT_GENERAL\n" + card(1, 1.0) + "*CONTROL_IMPLICIT_EIGENVALUE\n" + card(8)
                       + "*CONTROL_TERMINATION\n" + card(1.0) + "*END\n")
            self.nugget("modes", "model.k", "--quiet", "-o", "free")
            found = [m["frequency_hz"] for m in self.json("free/summary.json")["modes"]]
            self.assertLess(max(found[:6]), 1e-3 * found[6], elform)

    def test_two_masses_on_the_bond(self):
        """sqrt(k / (m / 2)) of the tension, and of both shears. Sabotage: ET for EN."""
        self.expect_modes(elastic(), ET, EN)
        # The first slopes, whatever the mode and under pressure. Sabotage: the bond as it is in a run.
        slope = T / (0.1 * 0.1)
        self.expect_modes(scaled(stfsf=3.0), slope * (0.1 / 0.15) ** 2, slope)
        self.expect_modes(general(stfsf=3.0), 10.0 * S * 0.515 * S / GIIC, 10.0 * T * 0.515 * T / GIC)

    def expect_modes(self, law, shear, tension):
        mass = 1.0e-6
        self.write(deck(single(law, side=4.0), "*ELEMENT_MASS\n" + "".join(f"{n:8}{n:8}{mass:16.6e}\n" for n in range(1, 9)),
                        "*CONTROL_IMPLICIT_GENERAL\n" + card(1, 1.0), "*CONTROL_IMPLICIT_EIGENVALUE\n" + card(24), "*CONTROL_TERMINATION\n" + card(1.0)))
        self.nugget("modes", "model.k", "--quiet")
        found = [m["frequency_hz"] for m in self.json("summary.json")["modes"]]
        each = 4.0 * mass + 0.5 * 3.0e-10 * 16.0
        for stiffness, times in ((shear, 2), (tension, 1)):
            expected = math.sqrt(stiffness * 16.0 / (0.5 * each)) / (2.0 * math.pi)
            self.assertGreaterEqual(sum(abs(f - expected) < 1e-3 * expected for f in found), times, (expected, found))


if __name__ == "__main__":
    unittest.main()
