# SPDX-License-Identifier: Apache-2.0
"""Welds written otherwise: which node of a beam is the first, where a brick begins, what its numbers are. Nothing of that is physics."""
import csv
import unittest

import lsda
from nugget_command import CommandTest
from welded_sheets import STEEL, Sheets, weld_material


class WeldInvariance(CommandTest):
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
        s.node_set(1, s.column(sheets[0], 0))
        s.node_set(2, s.column(sheets[1], -1) + s.column(sheets[1], -2))
        s.cards += ["*BOUNDARY_SPC_SET\n1,0,1,1,1,1,1,1", "*INITIAL_VELOCITY\n2\n9000.0,6000.0,18000.0"]
        self.write(s.text(), f"{name}.k")
        self.nugget("run", f"{name}.k", "-o", name, "-j1", "--quiet")
        with (self.folder / name / "welds.csv").open() as file:
            welds = list(csv.DictReader(file))
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


if __name__ == "__main__":
    unittest.main()
