# SPDX-License-Identifier: Apache-2.0
"""units.csv: every number of every table that a command leaves has a quantity and, where the deck's units are recognised, a unit.
Sabotage: a column that is added without a line in src/output/column_units.cpp; forces told as moments; Hz in a deck of ms."""
import csv
import unittest

from lap_joint import deck
from nugget_command import CommandTest, SOURCE
from test_mode_studies import strips
from test_responses import fields, frf, strip

# Ids and words: what they are, their name says.
WORDS = {
    "id", "kind", "part", "sheet1", "sheet2", "tied", "failed", "failure_mode", "last_terms", "remarks", "node", "case", "direction",
    "response", "panel", "mode", "weld", "goes", "without", "exit_code", "test", "sample",
}


class ColumnUnits(CommandTest):
    def units(self, folder="."):
        with open(self.folder / folder / "units.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(list(rows[0]), ["file", "column", "quantity", "unit"])
        return {(row["file"], row["column"]): row for row in rows}

    def holds(self, *files, folder="."):
        """Of these files each column is in units.csv with a unit or is a word; {(file, column): unit}."""
        units = self.units(folder)
        for name in files:
            with open(self.folder / folder / name, newline="", encoding="utf-8") as file:
                for column in next(csv.reader(file)):
                    bare = column.rstrip("0123456789") if name == "welds.csv" else column
                    if bare in WORDS | {"segment", "reason"} or column in WORDS:
                        continue
                    self.assertIn((name, column), units)
                    self.assertTrue(units[name, column]["unit"], (name, column))
        return {key: row["unit"] for key, row in units.items()}

    def test_a_run_and_a_check(self):
        self.write(deck())
        self.nugget("run", "model.k", "-o", "run", "--quiet")
        units = self.holds("welds.csv", folder="run")
        self.assertEqual([units["welds.csv", c] for c in ("x", "peak_axial", "peak_bending", "energy", "failure_time", "added_mass")],
                         ["mm", "N", "N mm", "N mm", "s", "t"])
        self.assertEqual([units["welds.csv", c] for c in ("peak_failure", "angle", "last_strain_rate", "moved2")], ["-", "degree", "1/s", "mm"])
        log = self.read("run/run.log")
        for words in (r"Mass \[t\]", r"first step +\S+ s\n", r"Energy at the end \[N mm\]", r"t = 1.2 mm +\*MAT", r"beam, ELFORM 9, d = 6 mm"):
            self.assertRegex(log, words)
        self.assertRegex(self.nugget("welds", "run").stdout, r"into it \[N mm\] .*failed at \[s\]")
        told = self.nugget("check", "model.k", "-o", "check", "--target-step", "1e-6", "--weld-tie", "joint").stdout
        for words in (r"to free edge \[mm\]", r"time step \[s\]", r"mass of the welds, as given +\S+ t ", r"diameter \[mm\]", r"or E \[MPa\]"):
            self.assertRegex(told, words)
        units = self.holds("welds.csv", folder="check")
        self.assertEqual([units["welds.csv", c] for c in ("target_mass", "target_young", "joint_in_plane", "joint_moment_yield")],
                         ["t", "MPa", "mm/N", "N mm"])

    def test_units_that_are_not_recognised(self):
        self.write(deck().replace("7.85e-09  210000.0", "3.00e+03  210000.0"))
        self.nugget("check", "model.k", "-o", "check")
        units = self.units("check")
        self.assertEqual((units["welds.csv", "x"]["quantity"], units["welds.csv", "x"]["unit"]), ("length", ""))
        self.assertEqual(units["welds.csv", "stretch"]["unit"], "-")

    def test_modes_and_their_studies(self):
        self.write(strips())
        self.nugget("modes", "model.k", "-n", 8, "-o", "whole", "--quiet")
        self.nugget("modes", "model.k", "-n", 8, "-o", "less", "--drop-weld", "all", "--least-welds", "0.5", "--compare", "whole", "--quiet")
        units = self.holds("welds.csv", "mode_energy.csv", "weld_drop.csv", "least_welds.csv", "mac.csv", folder="less")
        self.assertEqual(units["weld_drop.csv", "without"], "Hz")
        self.assertEqual(units["mode_energy.csv", "mode 1"], "-")

    def test_a_response(self):
        self.write(strip(lambda tip: "*CONTROL_IMPLICIT_EIGENVALUE\n" + fields(5) +
                         frf((tip, 0, 3, 3), (0.02,), (tip, 0, 3, 2), (0.0, 300.0, 100)), 20, 2))
        self.nugget("frf", "model.k", "--quiet")
        units = self.holds("frf.csv")
        self.assertEqual((units["frf.csv", "frequency"], units["frf.csv", "phase"]), ("Hz", "degree"))
        for column in ("amplitude", "real", "imaginary"):
            self.assertEqual(units["frf.csv", column], "mm")
        self.assertRegex(self.read("run.log"), r"mode +frequency \[Hz\] +omega\^2 \[1/s2\]")
        self.assertRegex(self.read("run.log"), r"z displacement \[mm\] +\d")
        page = self.read("report.html")
        for words in ("frequency [Hz]", "displacement [mm]", "phase [degree]"):
            self.assertIn(words, page)

    def test_the_next_run_begins_anew(self):
        self.write(strips())
        self.nugget("modes", "model.k", "-n", 4, "--quiet")
        self.assertIn(("mode_energy.csv", "mode 1"), self.units())
        self.write(deck())
        self.nugget("run", "model.k", "--quiet")
        self.assertEqual({file for file, _ in self.units()}, {"welds.csv"})

    def test_names_are_those_of_the_manual(self):
        page = (SOURCE / "docs" / "manual" / "results.md").read_text(encoding="utf-8")
        self.assertIn("units.csv", page)


if __name__ == "__main__":
    unittest.main()
