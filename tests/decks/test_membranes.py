# SPDX-License-Identifier: Apache-2.0
"""Membranes and fabric as a deck has them: what the result files hold, and what is refused."""
import math
import re
import unittest

import lsda
from fabric_bag import AMBIENT, CP, DENSITY, FLOW, TEMPERATURE, pillow
from few_elements import card, curve, part
from nugget_command import CommandTest

YOUNG, POISSON = 1000.0, 0.25


def sheet(*, elform=9, nip=4, law=f"*MAT_ELASTIC\n{card(1, 1e-9, YOUNG, POISSON)}", more="", section=None, end=0.02):
    """2 x 2 shells of 10 mm, pulled by 0.1 mm along x between edges that hold x only."""
    places = [(10.0 * i, 10.0 * j) for j in range(3) for i in range(3)]
    text = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(end) + part(1) + (section or "*SECTION_SHELL\n" + card(1, elform, "", nip) + card(0.5, 0.5, 0.5, 0.5))
    text += law + "*NODE\n" + "".join(f"{k:8}{x:16.6f}{y:16.6f}{0.0:16.6f}\n" for k, (x, y) in enumerate(places, 1))
    text += "*ELEMENT_SHELL\n" + "".join("".join(f"{v:8}" for v in (e, 1, a, a + 1, a + 4, a + 3)) + "\n" for e, a in enumerate((1, 2, 4, 5), 1))
    for nodes, held in (((1, 4, 7), (1, 0, 0)), ((3, 6, 9), (0, 0, 1)), ((1,), (0, 1, 1)), ((2, 4, 5, 7, 8), (0, 0, 1))):
        text += "*BOUNDARY_SPC_NODE\n" + "".join(card(n, 0, *held, 0, 0, 0) for n in nodes)
    text += "*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + "".join(card(n, 1, 2, 9, 0.1) for n in (3, 6, 9))
    text += curve(9, (0.0, 0.0), (0.5 * end, 1.0), (1.0, 1.0)) + "*DAMPING_GLOBAL\n" + card(0, 3000.0)
    return text + more + "*END\n"


class Membranes(CommandTest):
    def states(self, branch):
        return lsda.states(lsda.read(self.folder / "binout0000"), branch)

    def test_a_pulled_sheet_in_elout(self):
        """sigma = E ln(1 + u/L) in one layer, whatever NIP. Sabotage: NIP layers, or the three columns next to the one that is pulled."""
        request = "*DATABASE_ELOUT\n" + card(0.002, 2) + "*DATABASE_HISTORY_SHELL\n" + card(1, 4)
        for elform in (5, 9):
            with self.subTest(elform):
                self.write(sheet(elform=elform, more=request))
                self.nugget("run", "model.k", "--quiet")
                last = self.states("elout/shell")[-1]
                self.assertEqual(len(last["sig_xx"]), 2)  # a layer of each of two shells
                for value in last["sig_xx"]:
                    self.assertAlmostEqual(value, YOUNG * 0.1 / 20.05, delta=0.01 * YOUNG * 0.1 / 20.0)
                for name in ("sig_yy", "sig_xy", "sig_yz", "sig_zx"):
                    for value in last[name]:
                        self.assertAlmostEqual(value, 0.0, delta=0.01 * YOUNG * 0.1 / 20.0)

    def test_a_bag_keeps_its_books(self):
        """The gas has what it had and what flowed in; what it gave is the work on the fabric and on the air outside. Sabotage: the faces of
        one sheet, the enthalpy of the inflow."""
        end = 4e-3
        self.write(pillow(end=end))
        self.nugget("run", "model.k", "--quiet")
        first, last = self.text_states()
        self.assertAlmostEqual(last["total_mass"] - first["total_mass"], FLOW * end, delta=2e-3 * FLOW * end)
        self.assertGreater(last["volume"], 5.0 * first["volume"])
        energy = self.json("summary.json")["energy"]
        self.assertAlmostEqual(energy["ratio"], 1.0, delta=0.02)
        given = first["internal_energy"] + FLOW * end * CP * TEMPERATURE - last["internal_energy"]
        outside = AMBIENT * (last["volume"] - first["volume"])
        self.assertAlmostEqual(given, outside + energy["external"], delta=0.01 * given)
        self.assertAlmostEqual(first["total_mass"], DENSITY * first["volume"], delta=1e-3 * DENSITY * first["volume"])

    def text_states(self):
        states = self.states("abstat")
        one = lambda s: {k: v[0] if isinstance(v, (list, tuple)) else v for k, v in s.items()}  # noqa: E731
        return one(states[0]), one(states[-1])

    def refused(self, text, *words, command=("check",)):
        self.write(text)
        told = self.nugget(*command, "model.k", expect=1).stderr
        for word in words:
            self.assertIn(word, told)

    def test_what_is_refused(self):
        fabric = lambda *third: ("*MAT_FABRIC\n" + card(1, 1e-9, 400.0, 300.0, "", 0.2) + card(20.0, "", "", 1) + card(*third)  # noqa: E731
                                 + card("") + card(""))
        self.refused(sheet(elform=2, law=fabric(0)), "*MAT_FABRIC is a law of membranes, but the shells have ELFORM 2", "write ELFORM 9 or 5")
        self.refused(sheet(law=fabric(0, "", "", "", "", 24)), "formulation 24 of the fabric (nominal stress over nominal strain")
        self.refused(sheet(law=fabric(0, "", "", "", "", 7)), "there is no such formulation of the fabric")
        by_curves = lambda curves, *more: sheet(law=fabric(0, "", "", "", "", 14) + card(*curves), more="".join(more))  # noqa: E731
        straight, falling = curve(11, (0.0, 0.0), (0.2, 100.0)), curve(12, (0.0, 0.0), (0.1, 20.0), (0.2, 10.0))
        self.refused(by_curves((11,)), "lca = 11: curve 11 is not defined")
        self.write(by_curves((12,), falling))
        self.assertIn("warning: *MAT_FABRIC lca = 12: curve 12: the force of a thread, S sqrt(1 + 2 E), falls behind the strain 0.1",
                      self.nugget("check", "model.k").stderr)
        self.refused(by_curves((0, 0, 12), falling), "lcab = 12: curve 12: the stress falls after the strain 0.1")
        self.refused(by_curves((0, 13), curve(13, (0.0, 1.0), (0.1, 20.0))), "lcb = 13: curve 13: it does not begin at 0, 0")
        self.refused(by_curves((11, 0, 0, 14), straight, curve(14, (0.0, 0.0), (0.1, 90.0), (0.2, 100.0))), "lcua = 14: curve 14 gives more energy back than loading")
        self.refused(by_curves((0, 0, 0, 0, 0, 0, 0.5)), "*MAT_FABRIC rl = 0.5")
        self.refused(sheet(law=fabric(0, "", "", "", "", -14) + card("") + card("", "", 0.2)), "*MAT_FABRIC h = 0.2")
        self.refused(sheet(law=fabric(0, 0.5, 1.0, "", "", 0, 5)), "fvopt = 5: leakage as through a porous medium is not built: its formula is not public")
        self.refused(sheet(law=fabric(0, "", "", "", "", 0, -1)), "fvopt = -1: leakage by the gaps between the threads (FVOPT below 0) is not built")
        self.refused(sheet(more="*MAT_ADD_AIRBAG_POROSITY_LEAKAGE\n" + card(1, 0.5, 1.0, "", 6)), "*MAT_ADD_AIRBAG_POROSITY_LEAKAGE fvopt = 6")
        self.refused(sheet(more="*MAT_ADD_AIRBAG_POROSITY_LEAKAGE\n" + card(9, 0.5, 1.0, "", 1)), "*MAT_ADD_AIRBAG_POROSITY_LEAKAGE mid = 9")
        self.refused(sheet(law="*MAT_FABRIC\n" + card(1, 1e-9, 400.0, 300.0) + card(0) + card(0) + card("") + card("")), "needs its shear modulus")
        self.refused(sheet().replace(part(1), "*PART_COMPOSITE\nlayers\n" + card(1, 9) + card(1, 0.2, 0, "", 1, 0.3)),
                     "membranes (ELFORM 9) with layers of different materials are not built")

    def test_a_thread_whose_force_stays(self):
        """Stress over Green's strain falls where a thread's force stays. Sabotage: refused because S falls."""
        yields = curve(11, *((round(0.5 * (l * l - 1.0), 9), round(s / l, 9)) for l, s in ((1.0, 0.0), (1.002, 40.0), (1.01, 40.0), (1.5, 40.0))))
        law = "*MAT_FABRIC\n" + card(1, 1e-9, 400.0, 300.0) + card(20.0) + card(0, "", "", "", "", 14) + card("") + card("") + card(11)
        self.write(sheet(law=law, more=yields + "*DATABASE_SPCFORC\n" + card(0.002)))
        self.assertNotIn("the force of a thread", self.nugget("run", "model.k", "--quiet").stderr)
        held = [line.split() for line in self.read("spcforc").splitlines() if "force resultants" in line]
        self.assertAlmostEqual(abs(float(held[-1][3])), 40.0 * 0.5 * 20.0, delta=0.01 * 400.0)

    def test_step_of_a_square_alone_with_damping(self):
        """It swells and shrinks as an undamped one, omega^2 = 4 (1 + nu) c^2 / L^2; DAMP shortens the formula's step and the limit alike.
        Sabotage: the viscous stress counted once, as in the forces of a step."""
        for damping in (0.0, 0.3):
            law = "*MAT_FABRIC\n" + card(1, 1e-9, 400.0, "", "", 0.3) + card("", "", "", 0, "", "", "", damping) + card(0) + card("") + card("")
            text = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(1.0) + "*CONTROL_TIMESTEP\n" + card("", 0.9) + part(1) + "*SECTION_SHELL\n" + card(1, 9)
            text += card(0.5, 0.5, 0.5, 0.5) + law + "*NODE\n"
            text += "".join(f"{k:8}{x:16.6f}{y:16.6f}{0.0:16.6f}\n" for k, (x, y) in enumerate(((0, 0), (9, 0), (9, 9), (0, 9)), 1))
            self.write(text + "*ELEMENT_SHELL\n" + "".join(f"{v:8}" for v in (1, 1, 1, 2, 3, 4)) + "\n*END\n")
            found = re.search(r"limit of stability is TSSFAC (\S+);", self.nugget("check", "model.k").stderr)
            self.assertAlmostEqual(float(found[1]), 1 / math.sqrt(1.3), delta=2e-3)

    def test_step_of_a_stretched_fabric(self):
        """Drawn to 1.5 times its length and width: a shell of the same mass and thickness and 2.25 times the area, taut by C eps, so that
        (L/c)^2 grows by 2.25 / 2.25 / (1 + (1 + nu) eps), eps = ln 1.5. Sabotage: the density at the start."""
        law = "*MAT_FABRIC\n" + card(1, 1e-9, 400.0, "", "", 0.3) + card("", "", "", 1) + card(0) + card("") + card("")
        text = sheet(law=law, end=0.01)
        text = text[:text.index("*BOUNDARY_SPC_NODE")] + "".join(
            "*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + card(3 * j + i + 1, dof, 2, 9, 10.0 * k - 5.0) for j in range(3) for i in range(3)
            for dof, k in ((1, 0.5 * i), (2, 0.5 * j)) if k != 0.5)
        text += "*BOUNDARY_SPC_NODE\n" + "".join(card(n, 0, int(n in (2, 8)), int(n in (4, 6)), 1, 0, 0, 0) for n in range(1, 10))
        self.write(text + curve(9, (0.0, 0.0), (0.005, 1.0), (1.0, 1.0)) + "*DATABASE_GLSTAT\n" + card(0.001, 2) + "*END\n")
        self.nugget("run", "model.k", "--quiet")
        steps = [s["time_step"][0] for s in self.states("glstat")]
        self.assertAlmostEqual(steps[-2] / steps[0], 1 / math.sqrt(1 + 1.3 * math.log(1.5)), delta=3e-3)

    def test_leakage_of_the_fabric(self):
        """OPT asks for it. What is there, what flowed in and what leaked by run.log add up, and so do the flows of abstat. Sabotage: a mass that
        leaks and is not taken from the gas."""
        with_opt = pillow(4).replace(card(AMBIENT, DENSITY, 1.0), card(AMBIENT, DENSITY, 1.0, "", "", "", 1))
        _, told = self.abstat(with_opt)
        self.assertIn("opt = 1: nothing leaks: no fabric of this gas has FLC and FAC", told)
        tight = self.text_states()[1]
        form = card(0, "", "", "", "", 0)
        leaking = with_opt.replace(form, card(0, 0.02, 0.5, "", "", 0))
        self.assertNotEqual(leaking, with_opt)
        _, told = self.abstat(leaking)
        self.assertRegex(told, r"gas leaks through 32 shells of fabric with an area of 8\d{4}")
        first, last = self.text_states()
        leaked = float(re.search(r"gas 7: a mass of (\S+) has leaked through fabric and 0 has left otherwise", (self.folder / "run.log").read_text())[1])
        self.assertGreater(leaked, 0.05 * tight["total_mass"])
        inflow = tight["total_mass"] - first["total_mass"]
        self.assertAlmostEqual(last["total_mass"] + leaked, first["total_mass"] + inflow, delta=1e-3 * inflow)
        flows = [s["dm_dt_out"][0] for s in self.states("abstat")]
        self.assertAlmostEqual(1e-4 * (sum(flows) - 0.5 * flows[-1]), leaked, delta=0.08 * leaked)  # rows of single steps
        # Faces by segments, each begun at another of its nodes.
        shells = [list(map(int, line.split()))[2:] for line in leaking[leaking.index("*ELEMENT_SHELL\n"):].split("\n") if re.fullmatch(r"( *\d+){6}", line)]
        segments = "*SET_SEGMENT\n" + card(2) + "".join(card(*q[i % 4:], *q[:i % 4]) for i, q in enumerate(shells))
        self.abstat(leaking.replace("*AIRBAG_WANG_NEFSKE_ID\n" + card(7) + card(1, 1), segments + "*AIRBAG_WANG_NEFSKE_ID\n" + card(7) + card(2, 0)))
        self.assertAlmostEqual(self.text_states()[1]["total_mass"], last["total_mass"], delta=1e-9 * last["total_mass"])
        # The fields of the fabric count before OPT; those of *MAT_ADD_AIRBAG_POROSITY_LEAKAGE before both.
        same, _ = self.abstat(pillow(4).replace(form, card(0, 0.02, 0.5, "", "", 0, 1)))
        again, _ = self.abstat(with_opt.replace(form, card(0, 0.5, 0.5, "", "", 0, 3)).replace("*SET_PART_LIST", "*MAT_ADD_AIRBAG_POROSITY_LEAKAGE\n"
                                                                                                   + card(1, 0.02, 0.5, "", 1) + "*SET_PART_LIST"))
        self.assertEqual(again, same)

    def test_leakage_that_no_gas_obeys(self):
        """Of the gases only that of Wang and Nefske leaks through fabric."""
        text = pillow(4).replace(card(0, "", "", "", "", 0), card(0, 0.02, 0.5, "", "", 0, 2))
        start, end = text.index("*AIRBAG_WANG_NEFSKE_ID"), text.index("*DEFINE_CURVE")
        simple = "*AIRBAG_SIMPLE_AIRBAG_MODEL_ID\n" + card(7) + card(1, 1) + card("7.175E+08", "1.0045E+09", 400, 3, "", "", AMBIENT, DENSITY) + card("")
        self.write(text[:start] + simple + text[end:])
        self.assertIn("fvopt = 2: nothing leaks: no *AIRBAG_WANG_NEFSKE has shells of this material", self.nugget("check", "model.k").stderr)

    def test_linear_analyses_have_no_membranes(self):
        """Nothing holds them across their plane."""
        self.write(sheet())
        told = self.nugget("modes", "model.k", "-n", 3, expect=1).stderr
        self.assertIn("part 1 is of membranes (ELFORM 9), which linear analyses do not have", told)

    def abstat(self, text):
        self.write(text)
        told = self.nugget("run", "model.k", "--quiet").stderr
        return (self.folder / "abstat").read_text(), told

    def test_faces_are_turned_to_agree_with_their_neighbours(self):
        """One shell, or one of the two sheets, seen from its other side: the gas is the same but for rounding. Sabotage: the faces of the
        smaller part left as they are, whose volume counts against that of the others."""
        _, told = self.abstat(pillow(4))
        self.assertNotIn("disagree", told)
        straight = self.text_states()
        for turned, words in (((6,), "disagree at 4 edges, the first from node"), (range(17, 33), "disagree at 16 edges")):
            _, told = self.abstat(pillow(4, turned=turned))
            for state, expected in zip(self.text_states(), straight):
                for name in ("volume", "pressure", "total_mass"):
                    self.assertAlmostEqual(state[name], expected[name], delta=1e-3 * expected[name], msg=name)
            self.assertIn("the normals of neighbours " + words, told)
            self.assertIn(f"{len(turned)} faces are taken the other way round, the first shell {turned[0]}", told)

    def test_a_part_that_gives_energy_ends_the_run(self):
        """A step that is too long for fabric under pressure: what the vibrations have, the elements gave, and no sum of the balance shows it.
        Sabotage: only what the change of the step makes is looked at; the run then ends normally."""
        self.write(pillow(8, cse=0, more="*CONTROL_TIMESTEP\n" + card("", 2.2)))
        told = self.nugget("run", "model.k", "--quiet", expect=3).stderr
        self.assertRegex(told, r"the run is unstable: part 1 has given \S+ more energy than it ever got, by time \S+, cycle 101: its internal energy is below 0")

    def test_a_gas_that_expands_gives_what_it_had(self):
        """E0 of an equation of state is energy at the start that the balance counts from 0. Sabotage: bricks of any law looked at."""
        corners = [(x, y, z) for z in (0, 10) for x, y in ((0, 0), (10, 0), (10, 10), (0, 10))]
        text = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(3e-5) + "*PART\ngas\n" + card(1, 1, 1, 1) + "*SECTION_SOLID\n" + card(1, 1)
        text += "*MAT_NULL\n" + card(1, 1.2e-9, 0.0, 0.0) + "*EOS_LINEAR_POLYNOMIAL\n" + card(1, 0, 0, 0, 0, 0.4, 0.4, 0) + card(2.5, 1.0) + "*NODE\n"
        text += "".join(f"{k:8}" + "".join(f"{x:16.3f}" for x in place) + "\n" for k, place in enumerate(corners, 1))
        self.write(text + "*ELEMENT_SOLID\n" + "".join(f"{v:8}" for v in (1, 1, *range(1, 9))) + "\n*END\n")
        self.nugget("run", "model.k", "--quiet")
        self.assertLess(self.json("summary.json")["energy"]["internal"], -10.0)

    def test_fields_that_change_nothing(self):
        """A ratio of Poisson's that would make the stiffness unsymmetric, and leakage of which FLC or FAC is 0. Sabotage: PRAB for PRBA."""
        straight, _ = self.abstat(pillow(4))
        moduli, form = card(1, 1e-9, 400.0, 300.0, "", 0.2), card(0, "", "", "", "", 0)
        same, told = self.abstat(pillow(4).replace(moduli, card(1, 1e-9, 400.0, 300.0, "", 0.2, 0.5)))
        self.assertEqual(same, straight)
        self.assertIn("prab = 0.5: not obeyed: PRBA EA/EB is 0.2667", told)
        leak = "*MAT_ADD_AIRBAG_POROSITY_LEAKAGE\n" + card(1, "", 1.0, "", 2)
        same, told = self.abstat(pillow(4, more=leak).replace(form, card(0, 0.5, "", "", "", 0, 2)))
        self.assertEqual(same, straight)
        self.assertEqual(told.count("nothing leaks through this fabric: FLC or FAC is 0"), 2)

    def test_an_inverted_bag_is_turned(self):
        self.write(pillow(4, turned=range(1, 33)))
        told = self.nugget("check", "model.k").stderr
        self.assertIn("all normals point into the volume: its faces are taken the other way round", told)


if __name__ == "__main__":
    unittest.main()
