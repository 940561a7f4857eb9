# SPDX-License-Identifier: Apache-2.0
"""Ties: shells that are tied by their translations alone keep their rotations; springs of ties hold rigid bodies."""
import csv
import io
import re
import unittest

from few_elements import card, curve, nodes, part
from lap_joint import deck as lap_joint
from nugget_command import CommandTest

LENGTH, WIDTH, THICKNESS, YOUNG, PRESSURE, SHELLS = 100.0, 5.0, 2.0, 210000.0, 0.002, 20
NUMBER = r"[-+]?\d\.\d+E[-+]\d+"
# What hinges the ends: node and segment, cards of the keyword.
TIES = ("*CONTACT_TIED_NODES_TO_SURFACE\n" + card(1, 2, 4, 3), "*CONTACT_TIED_SURFACE_TO_SURFACE\n" + card(1, 2, 3, 3),
        "*CONTACT_TIED_NODES_TO_SURFACE_CONSTRAINED_OFFSET\n" + card(1, 2, 4, 3))
INTERPOLATIONS = "".join("*CONSTRAINED_INTERPOLATION\n" + card(node, node, 123) +
                         "".join(card(900 + 4 * end + i, 123) for i in range(1, 5))
                         for end, nodes_of_end in ((0, (1, 101)), (1, (SHELLS + 1, SHELLS + 101)))
                         for node in nodes_of_end)


def strip(holds, extra=""):
    """A strip of shells along x, both ends over the middle of a shell whose nodes are held."""
    rows = [[(LENGTH * i / SHELLS, side * WIDTH, 0.0) for i in range(SHELLS + 1)] for side in (0, 1)]
    ends = [[(x + dx, WIDTH / 2 + dy, 0.0) for dx, dy in ((-2, -9), (2, -9), (2, 9), (-2, 9))] for x in (0.0, LENGTH)]
    text = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(0.012) + "*CONTROL_TIMESTEP\n" + card(0.0, 0.9)
    text += nodes(rows[0]) + nodes(rows[1], 101) + nodes(ends[0], 901) + nodes(ends[1], 905)
    shells = [(i, 1, i, i + 1, i + 101, i + 100) for i in range(1, SHELLS + 1)]
    shells += [(91 + e, 2, *range(901 + 4 * e, 905 + 4 * e)) for e in (0, 1)]
    text += "*ELEMENT_SHELL\n" + "".join("".join(f"{field:8}" for field in shell) + "\n" for shell in shells)
    text += part(1) + part(2) + "*SECTION_SHELL\n" + card(1, 2, 0.8333, 3) + card(*[THICKNESS] * 4)
    text += "*MAT_ELASTIC\n" + card(1, "7.85e-9", YOUNG, 0.0)
    text += "*SET_NODE_LIST\n" + card(1) + card(1, 101, SHELLS + 1, SHELLS + 101)
    text += "*SET_NODE_LIST\n" + card(3) + card(*range(901, 909))
    text += "*BOUNDARY_SPC_SET\n" + card(3, 0, 1, 1, 1, 1, 1, 1)
    text += curve(1, (0.0, 1.0), (1.0, 1.0)) + "*SET_SHELL_GENERAL\n" + card(1) + card("PART", 1)
    text += "*LOAD_SHELL_SET\n" + card(1, 1, -PRESSURE) + "*DAMPING_GLOBAL\n" + card(0, 4000.0)
    middle = SHELLS // 2 + 1
    text += "*DATABASE_NODOUT\n" + card(0.012) + "*DATABASE_GLSTAT\n" + card(0.001)
    text += "*DATABASE_HISTORY_NODE\n" + card(middle, middle + 100)
    return text + holds + extra + "*END\n"


class HingedTies(CommandTest):
    # 5/384 and 1/384 q L^4 / EI, per width; what 20 shells of one point make of it is within 1 %.
    CLAMPED = PRESSURE * LENGTH**4 / (384.0 * YOUNG * THICKNESS**3 / 12.0)

    def deflection(self, holds, extra=""):
        self.write(strip(holds, extra))
        self.told = self.nugget("run", "model.k", "-o", "out", "--quiet").stderr
        return float(re.findall(rf"^\s+{SHELLS // 2 + 1}((?:\s*{NUMBER})+)", self.read("out/nodout"), re.M)[-2].split()[2])

    def test_a_tie_of_translations_is_a_hinge(self):
        parts = "*SET_PART_LIST\n" + card(1) + card(1) + "*SET_PART_LIST\n" + card(2) + card(2)
        for tie in TIES:
            with self.subTest(tie=tie):
                found = self.deflection(parts + tie + card(0.0) + card(0.0))
                self.assertAlmostEqual(found / (5.0 * self.CLAMPED), 1.0, delta=0.01)

    def test_an_interpolation_of_translations_is_a_hinge(self):
        self.assertAlmostEqual(self.deflection(INTERPOLATIONS) / (5.0 * self.CLAMPED), 1.0, delta=0.01)

    def test_supports_hold_the_rotations_of_what_is_tied(self):
        parts = "*SET_PART_LIST\n" + card(2) + card(2)
        tie = parts + TIES[0] + card(0.0) + card(0.0)
        found = self.deflection(tie, "*BOUNDARY_SPC_SET\n" + card(1, 0, 0, 0, 1, 1, 1, 1))
        self.assertAlmostEqual(found / self.CLAMPED, 1.0, delta=0.02)
        self.assertIn("the SPC holds its rotations only", self.told)


class TiedBodies(CommandTest):
    """Two rigid plates of 10 x 10 and 6 x 6, 1 thick and 1 apart, of density 1: the first is pulled with a force of 100."""

    def pulled(self, tie, expect_tied):
        places = [(10.0 * x, 10.0 * y, 0.0) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
        places += [(2.0 + 6.0 * x, 2.0 + 6.0 * y, 1.0) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
        text = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(1.0) + "*CONTROL_TIMESTEP\n" + card(0.0, 0.9, 0, 0.0, 0.0, 9)
        text += curve(9, (0.0, 1e-3), (9.0, 1e-3)) + nodes(places)
        text += "*ELEMENT_SHELL\n" + "".join(f"{i:8}{i:8}" + "".join(f"{4 * i - 4 + k:8}" for k in range(1, 5)) + "\n"
                                             for i in (1, 2))
        text += part(1, 1, 1) + part(2, 1, 2) + "*SECTION_SHELL\n" + card(1, 2) + card(1.0, 1.0, 1.0, 1.0)
        text += "".join("*MAT_RIGID\n" + card(m, 1.0, 1e6, 0.3) + "\n\n" for m in (1, 2))
        text += "".join("*SET_PART_LIST\n" + card(p) + card(p) for p in (1, 2))
        text += tie + card(0.0) + card(0.0) + curve(1, (0.0, 1.0), (9.0, 1.0)) + "*LOAD_RIGID_BODY\n" + card(1, 3, 1, 100.0)
        text += "*DATABASE_NODOUT\n" + card(1.0) + "*DATABASE_GLSTAT\n" + card(1.0)
        self.write(text + "*DATABASE_HISTORY_NODE\n" + card(1, 5) + "*END\n")
        self.told = self.nugget("run", "model.k", "-o", ".", "--quiet").stderr
        way = [float(re.findall(rf"^\s+{node}((?:\s*{NUMBER})+)", self.read("nodout"), re.M)[-2].split()[2])
               for node in (1, 5)]
        mass = 136.0 if expect_tied else 100.0
        self.assertAlmostEqual(way[0], 0.5 * 100.0 / mass, delta=2e-3)
        self.assertAlmostEqual(way[1], 0.5 * 100.0 / mass if expect_tied else 0.0, delta=2e-3)
        self.assertAlmostEqual(self.glstat()[-1]["total energy / initial energy"], 1.0, delta=1e-3)

    def test_springs_hold_one_body_to_another(self):
        for form in ("SURFACE_TO_SURFACE_OFFSET", "SHELL_EDGE_TO_SURFACE_OFFSET", "SHELL_EDGE_TO_SURFACE_BEAM_OFFSET"):
            self.pulled(f"*CONTACT_TIED_{form}\n" + card(2, 1, 3, 3), True)

    def test_constraints_do_not_which_is_told(self):
        self.pulled("*CONTACT_TIED_SURFACE_TO_SURFACE\n" + card(2, 1, 3, 3), False)
        self.assertIn("4 tracked nodes belong to rigid bodies and stay with them, untied", self.told)
        self.assertIn("or use the _OFFSET form, whose springs hold bodies", self.told)


class PenaltyTies(CommandTest):
    """The lap joint tied by each form. Its weld ends stand on the sheets, so no gap tells the forms apart."""

    def peaks(self, form, stiffness=1.0):
        contact = "*CONTACT_SPOTWELD{}\n         3         1         3         2\n       0.0\n{:10.2f}\n"
        self.write(lap_joint((contact.format("", 1.0).replace("      1.00", "       1.0"), contact.format(form, stiffness))))
        self.told = self.nugget("run", "model.k", "--quiet").stderr
        (weld,) = csv.DictReader(io.StringIO(self.read("welds.csv")))
        return {name: float(weld["peak_" + name]) for name in ("axial", "shear", "bending", "force")}

    def test_forms_by_penalty_carry_what_the_constraint_carries(self):
        expected = self.peaks("")
        self.assertGreater(expected["shear"], 100.0)
        for form in ("_CONSTRAINED_OFFSET", "_BEAM_OFFSET", "_OFFSET", "_PENALTY"):
            with self.subTest(form):
                found = self.peaks(form)
                for name, value in expected.items():
                    self.assertAlmostEqual(found[name] / value, 1.0, delta=1e-9, msg=name)
                self.assertEqual("by the constraint that springs stand for" in self.told, form != "_CONSTRAINED_OFFSET")
                self.assertNotIn("of what a constraint would", self.told)

    def test_weak_springs_are_warned_of_in_check_and_run(self):
        expected = self.peaks("")
        self.assertLess(self.peaks("_BEAM_OFFSET", 0.5)["shear"], 0.95 * expected["shear"])
        warning = "warning: *CONTACT_SPOTWELD_BEAM_OFFSET 1: 2 of 2 nodes tied by springs carry less than 95 % of what a constraint would"
        self.assertIn(warning, self.told)
        self.assertIn(warning, self.nugget("check", "model.k", "-o", "audit").stderr)


if __name__ == "__main__":
    unittest.main()
