# SPDX-License-Identifier: Apache-2.0
"""Welds written otherwise: which node of a beam is the first, where a brick begins, what its numbers are. Nothing of that is physics."""
import csv
import math
import unittest

import lsda
from nugget_command import CommandTest
from welded_sheets import STEEL, Sheets, weld_material


class WeldInvariance(CommandTest):
    def run_thrown(self, s, sheets, name):
        """The rows of the welds after a run in which the lower sheet is held by its edge and the other edge of the upper one is thrown."""
        s.node_set(1, s.column(sheets[0], 0))
        s.node_set(2, s.column(sheets[1], -1) + s.column(sheets[1], -2))
        s.cards += ["*BOUNDARY_SPC_SET\n1,0,1,1,1,1,1,1", "*INITIAL_VELOCITY\n2\n9000.0,6000.0,18000.0"]
        self.write(s.text(), f"{name}.k")
        self.nugget("run", f"{name}.k", "-o", name, "-j1", "--quiet")
        with (self.folder / name / "welds.csv").open() as file:
            return list(csv.DictReader(file))

    def run_lap(self, name, exchanged):
        """A lap joint of 1.2 and 1.5 mm whose upper sheet is thrown up and along, on two welds with OPT 5."""
        s = Sheets()
        s.cards += ["*CONTROL_TERMINATION\n6.0e-5", "*DATABASE_GLSTAT\n5.0e-6,2",
                    f"*MAT_SPOTWELD_DAMAGE-FAILURE\n2,{STEEL},400.0,1000.0\n0.2\n0.0,5,300.0"]
        sheets = [s.sheet(1.2, 0.0, 0.0, 0.0, 10, 5, 5.0), s.sheet(1.5, 26.0, 1.0, 2.0, 10, 5, 5.0)]
        welds = s.beam_part(5.0, 2)
        for x, y in ((31.0, 7.0), (43.0, 16.0)):
            ends = [(x, y, 0.0), (x, y, 2.0)]
            s.beam(welds, *(reversed(ends) if exchanged else ends))
        s.tie([welds], sheets)
        welds = self.run_thrown(s, sheets, name)
        last = lsda.states(lsda.read(self.folder / name / "binout0000"), "glstat")[-1]
        return welds, {q: last[q][0] for q in ("kinetic_energy", "internal_energy", "eroded_internal_energy")}

    def test_ends_of_beams_exchanged_opt_5(self):
        """Sabotage: both sheets with the signs of the first one."""
        (given, energies), (other, other_energies) = self.run_lap("given", False), self.run_lap("other", True)
        other_name = {"stress in sheet 1": "stress in sheet 2", "stress in sheet 2": "stress in sheet 1"}
        for a, b in zip(given, other):
            self.assertEqual((a["failed"], b["failed"]), ("yes", "yes"))
            self.assertEqual(a["failure_mode"], other_name.get(b["failure_mode"], b["failure_mode"]))
            self.assertAlmostEqual(float(b["failure_time"]) / float(a["failure_time"]), 1.0, 9)
        for q, energy in energies.items():
            self.assertAlmostEqual(other_energies[q] / energy, 1.0, 7, q)

    def run_placed(self, name, turn):
        """Welds that `nugget weld` places as beams, which yield: sheets of rectangles, turned. Energies and forces of the welds."""
        def turned(p):
            return [sum(a * b for a, b in zip(row, p)) for row in turn]
        s = Sheets()
        s.cards += ["*CONTROL_TERMINATION\n6.0e-5", "*DATABASE_GLSTAT\n5.0e-6,2", "*DATABASE_SWFORC\n5.0e-6,2"]
        sheets = [s.sheet(1.2, 0.0, 0.0, 0.0, 10, 5, 5.0), s.sheet(1.5, 26.0, 1.0, 2.0, 10, 5, 5.0)]
        for i, node in enumerate(s.nodes):
            n, x, y, z = (float(value) for value in node.split(","))
            s.nodes[i] = f"{n:.0f}," + ",".join(f"{a:.16g}" for a in turned((1.1 * x, y, z)))
        s.node_set(1, s.column(sheets[0], 0))
        s.node_set(2, s.column(sheets[1], -1) + s.column(sheets[1], -2))
        s.cards += ["*BOUNDARY_SPC_SET\n1,0,1,1,1,1,1,1", "*INITIAL_VELOCITY\n2\n" + ",".join(f"{a:.16g}" for a in turned((9000.0, 6000.0, 18000.0)))]
        self.write(s.text(), f"{name}/sheets.k")
        points = "".join(",".join(f"{a:.16g}" for a in turned(p)) + ",5.0\n" for p in ((34.0, 7.0, 1.0), (47.0, 16.0, 1.0)))
        self.write("x, y, z, diameter\n" + points, f"{name}/points.csv")
        self.nugget("weld", f"{name}/points.csv", f"{name}/sheets.k", "-o", f"{name}/joined.k", "--as", "beam", "--material", "sigy=60")
        self.nugget("run", f"{name}/joined.k", "-o", f"{name}/out", "-j1", "--quiet")
        found = lsda.read(self.folder / name / "out" / "binout0000")
        energies = [state[q][0] for state in lsda.states(found, "glstat") for q in ("kinetic_energy", "internal_energy")]
        forces = [f for state in lsda.states(found, "swforc") for q in ("axial", "shear") for f in state[q]]
        return energies, forces

    def test_welds_placed_on_turned_sheets(self):
        """Sabotage: placed beams without a direction across them."""
        c, s = math.cos(math.radians(30.0)), math.sin(math.radians(30.0))
        drawn = self.run_placed("drawn", ((1, 0, 0), (0, 1, 0), (0, 0, 1)))
        for name, turn in (("about the welds", ((c, -s, 0), (s, c, 0), (0, 0, 1))), ("askew", ((c, -s * s, s * c), (s, c * s, -c * c), (0, c, s)))):
            other = self.run_placed(name.replace(" ", "_"), turn)
            for a, b in zip(drawn, other):  # a list is not written with all digits, nor are its welds
                self.assertLess(max(abs(x - y) for x, y in zip(a, b)), 1e-5 * max(map(abs, a)), name)

    def brick_lap(self, name, first, exchanged, weld):
        """The same sheets, warped, on one brick: its first corner, and whether it begins on the upper sheet."""
        s = Sheets()
        s.cards += ["*CONTROL_TERMINATION\n4.0e-5", "*DATABASE_GLSTAT\n4.0e-6,2", weld, f"*MAT_ELASTIC\n3,{STEEL}"]
        sheets = [s.sheet(1.2, 0.0, 0.0, 0.0, 10, 5, 5.0), s.sheet(1.5, 26.0, 1.0, 2.0, 10, 5, 5.0)]
        s.cards = [card.replace(f"*PART\nsheet\n{sheets[1]},{sheets[1]},1", f"*PART\nsheet\n{sheets[1]},{sheets[1]},3") for card in s.cards]
        part = s.brick_part(2)
        faces = [[s.add_node(x, y, z) for x, y in ((35.5, 8.5), (40.0, 8.5), (40.0, 13.0), (35.5, 13.0))] for z in (0.0, 2.0)]
        if exchanged:
            faces = [[face[k] for k in (0, 3, 2, 1)] for face in reversed(faces)]
        s.element += 1
        s.solids.append(f"{s.element},{part}," + ",".join(str(face[(first + k) % 4]) for face in faces for k in range(4)))
        for i, node in enumerate(s.nodes):
            n, x, y, z = (float(value) for value in node.split(","))
            s.nodes[i] = f"{n:.0f},{x:.9g},{y:.9g},{z + 0.006 * x * y:.9g}"
        s.tie([part], sheets)
        return self.run_thrown(s, sheets, name)[0]

    def test_records_of_equal_rank(self):
        """Sabotage: of equal RANK the record of the sheet where the brick begins."""
        connection = ("*DEFINE_CONNECTION_PROPERTIES\n7,0,0,0\n,300.0,1000.0,1e10\n"
                      "1.0\n1,320.0,900.0,1e10,,110.0,140.0,80.0\n2.0,1.5,2.0\n3,350.0,800.0,1e10,,225.0,255.0,185.0\n2.0,1.5,1.8")
        weld = f"*MAT_SPOTWELD_DAIMLERCHRYSLER\n2,{STEEL},,,,1e20\n0.2\n0,0,0,0,7\n{connection}"
        found = [self.brick_lap(f"rank{k}", 0, k == 1, weld) for k in (0, 1)]
        self.assertEqual([w["failed"] for w in found], ["yes", "yes"])
        self.assertAlmostEqual(float(found[1]["failure_time"]) / float(found[0]["failure_time"]), 1.0, 9)
        self.assertEqual(found[0]["failure_mode"], found[1]["failure_mode"])

    def test_the_audit_of_a_brick_by_its_first_corner(self):
        """Sabotage: the shell below its first node is that of the end."""
        found = [self.brick_lap(f"corner{first}{turned}", first, turned == 1, weld_material(2)) for first in range(4) for turned in (0, 1)]
        for column in ("angle", "element_ratio", "flange_elements", "edge_distance", "added_mass_ratio"):
            self.assertNotEqual(found[0][column], "", column)
            for other in found[1:]:
                self.assertAlmostEqual(float(other[column]), float(found[0][column]), 9, column)

    def test_the_audit_of_a_rigid_weld_by_the_numbers_of_shells(self):
        """Sabotage: the first shell at a node is that of the end."""
        found = []
        for backwards in (False, True):
            s = Sheets()
            s.cards += ["*CONTROL_TERMINATION\n1.0e-6"]
            sheets = [s.sheet(1.2, 0.0, 0.0, z, 6, 6, 5.0) for z in (0.0, 2.0)]
            for i, node in enumerate(s.nodes):
                n, x, y, z = (float(value) for value in node.split(","))
                s.nodes[i] = f"{n:.0f},{x:.9g},{y:.9g},{z + 0.006 * x * y + 0.0004 * x * x * y:.9g}"
            if backwards:
                numbers = [shell.split(",", 1)[0] for shell in s.shells]
                s.shells = [f"{n},{shell.split(',', 1)[1]}" for n, shell in zip(numbers, reversed(s.shells))]
            s.cards.append(f"*CONSTRAINED_SPOTWELD\n{s.row(sheets[0], 3)[3]},{s.row(sheets[1], 3)[3]}")
            self.write(s.text(), f"weld{backwards}.k")
            self.nugget("check", f"weld{backwards}.k", "-o", f"weld{backwards}")
            with (self.folder / f"weld{backwards}" / "welds.csv").open() as file:
                found.append(next(csv.DictReader(file)))
        self.assertAlmostEqual(float(found[0]["angle"]), float(found[1]["angle"]), 9)

    def test_numbers_of_rigid_welds_and_rivets(self):
        """Sabotage: each kind counts from 1."""
        s = Sheets()
        s.cards += ["*CONTROL_TERMINATION\n2.0e-6", "*DATABASE_SWFORC\n1.0e-6,2", weld_material(2)]
        sheets = [s.sheet(1.2, 0.0, 0.0, z, 6, 6, 5.0) for z in (0.0, 2.0)]
        s.element = 1  # of beams their own count
        beams = s.beam_part(5.0, 2)
        s.beam(beams, (8.0, 8.0, 0.0), (8.0, 8.0, 2.0))  # beam 2
        s.tie([beams], sheets)
        at = [(s.row(sheets[0], j)[4], s.row(sheets[1], j)[4]) for j in range(1, 6)]
        s.cards += [f"*CONSTRAINED_SPOTWELD\n{a},{b}" for a, b in at[:2]] + [f"*CONSTRAINED_RIVET\n{a},{b}" for a, b in at[2:4]]
        self.write(s.text())
        run = self.nugget("run", "model.k", "-o", "out", "--quiet")
        self.assertNotIn("has the number", run.stderr)
        ids = lsda.read(self.folder / "out" / "binout0000")["swforc/metadata/ids"]
        self.assertEqual(len(ids), 5)
        self.assertEqual(sorted(ids), sorted(set(ids)), ids)
        self.write(s.text().replace("*CONSTRAINED_RIVET", "*CONSTRAINED_RIVET_ID\n2", 1))
        self.assertIn("a rivet has the number 2, which a weld beam has, too", self.nugget("check", "model.k").stderr)

    def test_a_beam_and_a_brick_with_one_number(self):
        for first, said in ((0, True), (50, False)):
            s = Sheets()
            s.cards += ["*CONTROL_TERMINATION\n1.0e-6", weld_material(2)]
            sheets = [s.sheet(1.2, 0.0, 0.0, z, 6, 6, 5.0) for z in (0.0, 1.2)]
            beams, bricks = s.beam_part(5.0, 2), s.brick_part(2)
            s.element = 100
            s.beam(beams, (8.0, 8.0, 0.0), (8.0, 8.0, 1.2))
            s.element = 100 + first
            s.brick(bricks, 20.0, 16.0, 0.0, 5.0, 1.2)
            s.tie([beams, bricks], sheets)
            self.write(s.text())
            run = self.nugget("check", "model.k").stderr
            self.assertEqual("1 weld has the number of another one: beam weld 101 and solid weld 101" in run, said, run)

    def test_subcycling_of_rigid_bodies_alone(self):
        """Sabotage: the longest period of no groups, which ended the program."""
        s = Sheets()
        s.cards += ["*CONTROL_TERMINATION\n1.0e-4", "*CONTROL_SUBCYCLE\n8,8", f"*MAT_RIGID\n1,{STEEL}\n0\n"]
        s.cards.remove(f"*MAT_ELASTIC\n1,{STEEL}")
        part = s.sheet(1.2, 0.0, 0.0, 0.0, 2, 2, 5.0)
        s.node_set(1, s.row(part, 0) + s.row(part, 1) + s.row(part, 2))
        s.cards += ["*INITIAL_VELOCITY\n1\n9000.0,6000.0,18000.0", "*DATABASE_GLSTAT\n1.0e-5,2"]
        self.write(s.text())
        self.nugget("run", "model.k", "-o", "out", "--quiet")
        states = lsda.states(lsda.read(self.folder / "out" / "binout0000"), "glstat")
        self.assertAlmostEqual(states[-1]["kinetic_energy"][0] / states[0]["kinetic_energy"][0], 1.0, 9)


if __name__ == "__main__":
    unittest.main()
