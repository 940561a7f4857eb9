# SPDX-License-Identifier: Apache-2.0
"""nugget study: a deck for each line of a table of its parameters; what was interrupted or is there already; one table."""
import csv
import os
import signal
import subprocess
import time
import unittest

from lap_joint import deck
from nugget_command import CommandTest, NUGGET
from test_mode_studies import strips

STRENGTH = ("    8000.0    6000.0    6000.0", "    8000.0      &nrs      &nrs")
PARAMETERS = "*PARAMETER\nRthick          1.2\nR nrs         6000.0\nI count            3\n"
THICK = ("       1.2       1.2       1.2       1.2", "    &thick    &thick    &thick    &thick")


def varied(*changes):
    return deck(("*CONTROL_TERMINATION\n", PARAMETERS + "*CONTROL_TERMINATION\n"), STRENGTH, THICK, *changes)


class Study(CommandTest):
    def rows(self, folder="s"):
        with open(self.folder / folder / "study.csv", newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def plan(self, table, *settings):
        self.write("\n".join(["# a plan", "deck: model.k", *settings, table]), "plan.csv")

    def study(self, *options, expect=0):
        return self.nugget("study", "plan.csv", "-o", "s", "--quiet", *options, expect=expect)

    def test_each_run_is_that_of_the_deck_with_its_values(self):
        self.write(varied())
        self.plan("run,thick,nrs\nweak,1.2,60\nas_is,,\nthick,1.5,6000\n", "result: pull = swforc/*/axial:max", "result: glstat/time_step:min")
        told = self.study().stdout
        self.assertRegex(told, r"run +thick +nrs +ended +internal energy \[N mm\].*pull \[N\]")
        rows = self.rows()
        self.assertEqual([row["run"] for row in rows], ["weak", "as_is", "thick"])
        self.assertEqual([row["exit_code"] for row in rows], ["0"] * 3)
        self.assertEqual([row["welds failed"] for row in rows], ["1", "0", "0"])
        self.assertGreater(float(rows[0]["first failure"]), 0.0)
        self.assertEqual(rows[1]["first failure"], "")
        for row, thick, nrs in zip(rows, ("1.2", "1.2", "1.5"), ("60", "6000", "6000")):
            self.write(varied().replace("Rthick          1.2", f"Rthick          {thick}").replace("R nrs         6000.0", f"R nrs         {nrs}"), "one.k")
            self.nugget("run", "one.k", "-o", "one", "--quiet", "-j", 1)
            summary = self.json("one/summary.json")
            self.assertAlmostEqual(float(row["internal energy"]) / summary["energy"]["internal"], 1.0, delta=1e-8)
            highest = float(self.nugget("plot", "one", "swforc/*/axial").stdout.splitlines()[1].split()[-3])
            self.assertAlmostEqual(float(row["pull"]) / highest, 1.0, delta=1e-5)
        with open(self.folder / "s" / "units.csv", newline="", encoding="utf-8") as file:
            units = {row["column"]: row["unit"] for row in csv.DictReader(file)}
        self.assertEqual((units["pull"], units["first failure"], units["internal energy"], units["energy ratio"]), ("N", "s", "N mm", "-"))
        page = self.read("s/study.html")
        self.assertIn('href="weak/report.html"', page)
        self.assertEqual(self.read("s/study.svg").count("pull [N]"), 2)  # over thick and over nrs

    def test_what_is_there_is_kept_and_what_has_changed_is_run_again(self):
        self.write(varied())
        self.plan("thick\n1.0\n1.1\n")
        self.study()
        stamps = [os.stat(self.folder / "s" / name / "summary.json").st_mtime_ns for name in ("001", "002")]
        self.plan("thick\n1.0\n1.3\n1.4\n")
        self.assertIn("1 of 3 runs are there already", self.study().stdout)
        self.assertEqual(os.stat(self.folder / "s" / "001" / "summary.json").st_mtime_ns, stamps[0])
        self.assertNotEqual(os.stat(self.folder / "s" / "002" / "summary.json").st_mtime_ns, stamps[1])
        time.sleep(0.02)
        self.write(varied(("  2.00e-05", "  1.00e-05")))
        self.assertNotIn("there already", self.study().stdout)
        self.assertEqual(len(self.rows()), 3)

    def test_an_include_that_has_changed_is_seen(self):
        whole = varied()
        at = whole.index("*NODE")
        self.write(whole[:at] + "*INCLUDE\nmesh.k\n*END\n")
        self.write("*KEYWORD\n" + whole[at:], "mesh.k")
        self.plan("thick\n1.0\n")
        self.study()
        self.assertIn("1 of 1 runs are there already", self.study().stdout)
        time.sleep(0.02)
        self.write("*KEYWORD\n$ changed\n" + whole[at:], "mesh.k")
        self.assertNotIn("there already", self.study().stdout)

    def test_an_interrupted_study_goes_on_where_it_was(self):
        """SIGTERM to the study alone: its runs leave restart files; the end is that of runs that nothing interrupted."""
        self.write(varied(("  2.00e-05", "  2.00e-02"), ("*DATABASE_GLSTAT\n  5.00e-06", "*DATABASE_GLSTAT\n  1.00e-04"), ("*DATABASE_MATSUM\n  5.00e-06\n", ""),
                          ("*DATABASE_SWFORC\n  1.00e-06", "*DATABASE_SWFORC\n  1.00e-04"), ("*DATABASE_NODOUT\n  5.00e-06", "*DATABASE_NODOUT\n  1.00e-04"),
                          ("*DATABASE_BINARY_D3PLOT\n  5.00e-06", "*DATABASE_BINARY_D3PLOT\n  1.00e-02")))
        self.plan("thick\n1.0\n1.1\n1.2\n")
        words = [NUGGET, "study", "plan.csv", "-o", "s", "--quiet", "-j", "2"]
        process = subprocess.Popen(words, cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        deadline = time.monotonic() + 60
        while not all((self.folder / "s" / name / "glstat").exists() for name in ("001", "002")) and time.monotonic() < deadline:
            time.sleep(0.01)
        process.send_signal(signal.SIGTERM)
        out, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130, err)
        self.assertIn("the same command goes on", err)
        self.assertTrue((self.folder / "s" / "001" / "restart").exists())
        self.assertFalse((self.folder / "s" / "003" / "summary.json").exists())
        self.study()
        self.assertIn("Resumed from a restart file", self.read("s/001/run.log"))
        again = self.rows()
        for name in ("001", "002", "003"):
            self.nugget("run", f"s/{name}/model.k", "-o", f"whole_{name}", "--quiet", "-j", 1)
            self.assertEqual(self.read(f"whole_{name}/glstat"), self.read(f"s/{name}/glstat"))
        self.assertEqual([row["exit_code"] for row in again], ["0"] * 3)

    def test_options_of_each_run(self):
        self.write(varied())
        self.plan("thick\n1.0\n", "options: --max-cycles 7")
        self.study()
        self.assertEqual(self.json("s/001/summary.json")["cycles"], 7)
        self.assertIn("1 of 1 runs are there already", self.study().stdout)
        self.plan("thick\n1.0\n", "options: --max-cycles 9")
        self.assertNotIn("there already", self.study().stdout)
        self.assertEqual(self.json("s/001/summary.json")["cycles"], 9)
        self.plan("thick\n1.0\n", "options: -o elsewhere")
        self.assertIn("plan.csv:3: error: options: -o cannot be given here", self.study(expect=1).stderr)

    def test_decks_alone(self):
        self.write(varied())
        self.plan("thick\n1.0\n1.1\n")
        self.assertIn("2 of 2 runs are to be made", self.study("--decks").stdout)
        commands = self.read("s/runs.txt").splitlines()
        self.assertFalse((self.folder / "s" / "001" / "summary.json").exists())
        for command in commands:
            self.nugget(*command.split()[1:], "--quiet")
        self.assertIn("2 of 2 runs are there already", self.study().stdout)
        self.assertEqual([row["exit_code"] for row in self.rows()], ["0", "0"])

    def test_modes(self):
        asked = "*CONTROL_IMPLICIT_GENERAL\n         1\n*CONTROL_IMPLICIT_EIGENVALUE\n        12\n*PARAMETER\nR     e    210000.0\n"
        self.write(strips().replace("  210000.0", "        &e").replace("*KEYWORD\n", "*KEYWORD\n" + asked, 1))
        self.plan("e\n210000\n52500\n")
        self.study()
        stiff, soft = self.rows()
        for i in range(1, 6):
            self.assertAlmostEqual(float(soft[f"frequency {i}"]) / float(stiff[f"frequency {i}"]), 0.5, delta=1e-6)

    def test_all_that_is_wrong_with_a_table_is_said_before_anything_runs(self):
        self.write(varied())
        self.plan("run,thick,nr,count\na b,1.0,1,2\nc,x,2,3,4\nc,1.0,,2.5\n")
        told = self.study(expect=1).stderr
        for words in ("plan.csv:3: error: 'nr': the deck has no such *PARAMETER [name one of these: count, nrs, thick]", "plan.csv:4: error: run = 'a b'",
                      "plan.csv:5: error: thick = x: expected a number", "plan.csv:5: error: 5 values, expected 4", "plan.csv:6: error: a second run 'c'",
                      "plan.csv:6: error: count = 2.5: expected a whole number", "the study is refused; nothing was run"):
            self.assertIn(words, told)
        self.plan("thick\n1.0\n", "result: rcforc/1/x", "result: swforc/1/axial")
        self.assertIn("plan.csv: error: result: rcforc/1/x: the deck writes no rcforc [give *DATABASE_RCFORC]", self.study(expect=1).stderr)
        self.plan("thick\n1.0\n", "result: glstat/time_step:most", "cfc: 61")
        told = self.study(expect=1).stderr
        self.assertIn("expected peak, max, min, last or mean", told)
        self.assertIn("plan.csv:4: error: cfc: '61', expected 60, 180, 600 or 1000", told)
        self.write("thick\n1.0\n", "plan.csv")
        self.assertIn("the plan names no deck", self.study(expect=1).stderr)
        self.write("deck: model.k\nthick\n", "plan.csv")
        self.assertIn("there is no run in it", self.study(expect=1).stderr)
        self.assertFalse((self.folder / "s").exists() and any((self.folder / "s").iterdir()))
        self.plan("thick\n1.0\n", "result: glstat/nothing")
        self.assertIn("no channel 'glstat/nothing'", self.study(expect=2).stderr)

    def test_a_run_that_fails_is_said(self):
        self.write(varied())
        self.plan("thick\n1.0\n0.0\n")
        told = self.study(expect=3).stderr
        self.assertIn("run 002 ended with exit code 1", told)
        self.assertEqual([row["exit_code"] for row in self.rows()], ["0", "1"])
        self.assertEqual(self.rows()[1]["internal energy"], "")


if __name__ == "__main__":
    unittest.main()
