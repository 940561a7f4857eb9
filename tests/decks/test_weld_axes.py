# SPDX-License-Identifier: Apache-2.0
"""Welds whose strengths differ between s and t, in linear statics; welds between two layers of one part."""
import csv
import unittest

import lsda
from nugget_command import CommandTest
from welded_sheets import Sheets, weld_material

NRS, NRT = 8000.0, 2000.0
LINEAR = "*CONTROL_IMPLICIT_GENERAL\n1,1.0\n*CONTROL_IMPLICIT_SOLUTION\n1\n*CONTROL_TERMINATION\n1.0"
AXES = {"third node": (1.0, 2.0, 0.0), "none": None}


def pulled(direction, towards, cards=(LINEAR,)):
    """The left edge of a sheet is held, a node of the one on it is pulled by 100 along x or y. `towards`: from the weld to its third node."""
    s = Sheets(16)
    s.cards += [*cards, weld_material(2, card=f"0.0,0.0,{NRS},{NRT}")]
    sheets = [s.sheet(1.2, 0.0, 0.0, z, 5, 5, 6.0) for z in (0.0, 1.2)]
    welds = s.beam_part(6.0, 2)
    s.beam(welds, (15.0, 15.0, 0.0), (15.0, 15.0, 1.2))
    if towards:
        s.beams[-1] += f",{s.add_node(15.0 + towards[0], 15.0 + towards[1], towards[2])}"
    s.tie([welds], sheets)
    s.node_set(1, s.row(sheets[0], 0) + s.row(sheets[0], -1))
    s.cards.append("*BOUNDARY_SPC_SET\n1,0,1,1,1,1,1,1")
    s.cards.append("*DEFINE_CURVE\n1\n0.0,1.0\n1.0,1.0")
    s.cards.append(f"*LOAD_NODE_POINT\n{s.row(sheets[1], 3)[3]},{direction},1,100.0")
    return s


def thrown(one_part):
    """A sheet is thrown off another one, to which a weld beam holds it: two parts, or one."""
    s = Sheets()
    s.cards += ["*CONTROL_TERMINATION\n2.0e-5", "*DATABASE_SWFORC\n1.0e-6,2", weld_material(2)]
    sheets = [s.sheet(1.2, 0.0, 0.0, z, 5, 5, 6.0) for z in (0.0, 1.2)]
    if one_part:
        s.shells = [f"{e},{sheets[0]},{nodes}" for e, part, nodes in (shell.split(",", 2) for shell in s.shells)]
    welds = s.beam_part(6.0, 2)
    s.beam(welds, (14.0, 16.0, 0.2), (14.0, 16.0, 0.9))
    s.tie([welds], sheets[:1] if one_part else sheets)
    s.node_set(1, [n for j in range(6) for n in s.row(sheets[1], j)])
    s.cards.append("*INITIAL_VELOCITY\n1\n300.0,200.0,900.0")
    return s.text()


class WeldAxes(CommandTest):
    def failure_value(self, s, name):
        self.write(s.text(), f"{name}.k")
        self.nugget("run", f"{name}.k", "-o", name, "--quiet")
        with open(self.folder / name / "welds.csv", encoding="utf-8", newline="") as file:
            weld, = csv.DictReader(file)
        return float(weld["peak_failure"]), float(weld["peak_shear"])

    def test_statics_judge_a_weld_in_its_own_axes(self):
        """The weld alone carries the 100. Without a third node s is x; with one it is towards that. Sabotage: any two normals of the axis."""
        for direction, along in ((1, (1.0, 0.0)), (2, (0.0, 1.0))):
            for name, towards in AXES.items():
                with self.subTest(direction=direction, axes=name):
                    s = (towards[0] / 5**0.5, towards[1] / 5**0.5) if towards else (1.0, 0.0)
                    of_s, of_t = 100.0 * (along[0] * s[0] + along[1] * s[1]), 100.0 * (along[1] * s[0] - along[0] * s[1])
                    value, shear = self.failure_value(pulled(direction, towards), f"x{direction}{name[0]}")
                    self.assertAlmostEqual(shear, 100.0, delta=1e-6)
                    self.assertAlmostEqual(value / ((of_s / NRS)**2 + (of_t / NRT)**2), 1.0, delta=1e-6)


class LayersOfOnePart(CommandTest):
    def test_a_weld_between_them_carries_what_one_between_two_parts_does(self):
        """Sabotage: two places of one part are never two sheets."""
        forces = []
        for name, one_part in (("two", False), ("one", True)):
            self.write(thrown(one_part), f"{name}.k")
            run = self.nugget("run", f"{name}.k", "-o", name, "--quiet", "-j1")
            self.assertNotIn("not tied", run.stderr)
            states = lsda.states(lsda.read(self.folder / name / "binout0000"), "swforc")
            forces.append([(s["axial"], s["shear"], s["resultant_moment"]) for s in states])
        self.assertGreater(max(axial[0] for axial, _, _ in forces[0]), 100.0)
        self.assertEqual(forces[0], forces[1])

    def test_the_audit_counts_its_layers(self):
        """Sabotage: the sheets of a spot are parts."""
        self.write(thrown(True))
        self.assertIn("spots: 1 through 2 sheets", self.nugget("check", "model.k").stdout)

    def test_welds_are_placed_between_them(self):
        """As beams, that hold; not as interpolation spot welds, which name two parts. Sabotage: one place for each part."""
        s = Sheets()
        s.cards.append("*CONTROL_TERMINATION\n2.0e-5")
        sheets = [s.sheet(1.2, 0.0, 0.0, z, 5, 5, 6.0) for z in (0.0, 1.2)]
        s.shells = [f"{e},{sheets[0]},{nodes}" for e, _, nodes in (shell.split(",", 2) for shell in s.shells)]
        self.write(s.text(), "box.k")
        self.write("14,16,0.5\n20,12,0.9\n", "points.csv")
        run = self.nugget("weld", "points.csv", "box.k", "-o", "welded.k")
        self.assertEqual(run.stdout, "2 of 2 spots placed as 2 beams; welded.k\n")
        self.assertIn("spots: 2 through 2 sheets", self.nugget("check", "welded.k").stdout)
        run = self.nugget("weld", "points.csv", "box.k", "-o", "other.k", "--as", "interpolation", expect=1)
        self.assertIn("two layers of part 1 are no two sheets for *CONSTRAINED_INTERPOLATION_SPOTWELD", run.stderr)

    def test_a_weld_goes_with_the_shell_of_either_layer(self):
        """SPOTDEL 1. Sabotage: a weld goes when all its ties into a part are gone."""
        for shell in (13, 38):  # in the middle of the lower and of the upper layer
            with self.subTest(shell=shell):
                cards = (f"*SET_SHELL_LIST\n7\n{shell}\n*DEFINE_ELEMENT_DEATH_SHELL_SET\n7,1.0e-5\n"
                         "*CONTROL_CONTACT\n\n\n\n0,0,0,0,0,1\n*END")
                self.write(thrown(True).replace("*END", cards))
                self.nugget("run", "model.k", "-o", "out", "--quiet")
                self.assertIn("by deleted sheet", self.read("out/run.log"))


if __name__ == "__main__":
    unittest.main()
