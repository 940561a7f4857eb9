# SPDX-License-Identifier: Apache-2.0
"""What a run leaves in its folder, and the command's options."""
import contextlib
import csv
import io
import math
import pathlib
import re
import subprocess
import unittest

from lap_joint import deck, edited
from nugget_command import NUGGET, CommandTest

RESULTS = ["d3plot", "d3plot01", "findings.json", "glstat", "matsum", "nodout", "report.html", "run.log", "summary.json", "swforc", "units.csv",
           "welds.csv"]

NUMBER, COUNT, TEXT, FLAG = float, int, str, bool
PROJECTION = {"node": COUNT, "segment": [COUNT], "xi": NUMBER, "eta": NUMBER, "moved": NUMBER, "case": COUNT, "reason": TEXT}
WELD = {"id": COUNT, "kind": TEXT, "part": COUNT, "parts": [COUNT], "diameter": NUMBER, "length": NUMBER, "tied": FLAG,
        "projection": [PROJECTION], "added_mass": NUMBER, "failed": FLAG, "failure_time": (NUMBER, type(None)),
        "failure_mode": TEXT, "peak": {"axial": NUMBER, "shear": NUMBER, "bending": NUMBER, "torsion": NUMBER}}
SUMMARY = {
    "version": TEXT, "deck": TEXT, "termination": TEXT, "message": TEXT, "nodes": COUNT,
    "elements": {"shell": COUNT, "solid": COUNT, "beam": COUNT, "discrete": COUNT}, "parts": COUNT, "welds": COUNT,
    "cycles": COUNT, "time": NUMBER, "time_step": {"first": NUMBER, "smallest": NUMBER, "controlling": TEXT},
    "mass": {"physical": NUMBER, "added": NUMBER, "added_to_welds": NUMBER},
    "energy": {"kinetic": NUMBER, "internal": NUMBER, "hourglass": NUMBER, "contact": NUMBER, "damping": NUMBER,
               "external": NUMBER, "eroded": NUMBER, "initial": NUMBER, "ratio": NUMBER},
    "seconds": {"read": NUMBER, "setup": NUMBER, "solve": NUMBER, "output": NUMBER,
                "phases": {"elements": NUMBER, "contact": NUMBER}},
    "ns_per_element_cycle": NUMBER, "peak_memory_mb": NUMBER, "threads": COUNT, "lanes": COUNT, "ranks": COUNT, "weld": [WELD], "modes": []}


def misfits(value, shape, where="summary"):
    """Where a value of summary.json is not as docs/reference/contract.md says; keys beyond it are allowed."""
    if isinstance(shape, dict):
        if not isinstance(value, dict):
            return [f"{where} is no object"]
        found = [f"{where}.{key} is missing" for key in shape if key not in value]
        return found + [m for key in shape if key in value for m in misfits(value[key], shape[key], f"{where}.{key}")]
    if isinstance(shape, list):
        if not isinstance(value, list):
            return [f"{where} is no list"]
        return [m for i, v in enumerate(value) for s in shape for m in misfits(v, s, f"{where}[{i}]")]
    return [] if isinstance(value, shape) and (shape is FLAG or value is not True) else [f"{where} = {value!r}, expected {shape}"]


class RunFiles(CommandTest):
    def test_files_of_a_run(self):
        self.write(deck())
        self.nugget("run", "model.k", "--quiet")
        self.assertEqual(self.files(), sorted([*RESULTS, "model.k"]))

    def test_memory_of_a_run(self):
        """As the system says of the process while it runs; the report and its viewer are made after the summary and take more."""
        self.write(deck())
        run = subprocess.Popen([NUGGET, "run", "model.k", "--quiet"], cwd=self.folder)
        seen = 0.0
        while not (self.folder / "summary.json").exists() and run.poll() is None:
            with contextlib.suppress(OSError):
                status = pathlib.Path(f"/proc/{run.pid}/status").read_text(encoding="utf-8")
                seen = max([seen, *(1024e-6 * float(line.split()[1]) for line in status.splitlines() if line.startswith("VmHWM"))])
        self.assertEqual(run.wait(), 0)
        peak = self.json("summary.json")["peak_memory_mb"]
        self.assertLessEqual(seen, peak + 1.0)
        self.assertGreater(seen, peak - 10.0)
        self.assertIn(f" {peak:.0f} MB of memory at most\n", self.read("run.log"))

    def test_energy_when_the_weld_that_holds_the_step_fails(self):
        """The step grows fivefold; without the account of it the ratio is off by 4 %."""
        self.write(deck(("  2.00e-05\n*CONTROL_TIMESTEP", "  6.00e-05\n*CONTROL_TIMESTEP"),
                        ("6000.0    6000.0    9000.0", "2000.0    2000.0    9000.0")))
        self.nugget("run", "model.k", "--quiet")
        summary = self.json("summary.json")
        self.assertTrue(summary["weld"][0]["failed"])
        self.assertAlmostEqual(summary["energy"]["ratio"], 1.0, delta=1e-6)
        self.assertGreater(abs(summary["energy"]["step_change"]), 0.03 * summary["energy"]["external"])

    def test_summary_has_the_keys_and_types_of_the_contract(self):
        self.assertEqual(misfits({"id": 1.5}, {"id": COUNT, "tied": FLAG}),
                         ["summary.tied is missing", f"summary.id = 1.5, expected {int}"])
        self.write(deck())
        self.nugget("run", "model.k", "--quiet", "-j", 2)
        summary = self.json("summary.json")
        self.assertEqual(misfits(summary, SUMMARY), [])
        self.assertEqual((summary["nodes"], summary["elements"]["shell"], summary["elements"]["beam"], summary["parts"],
                          summary["welds"], summary["threads"], summary["termination"], summary["time"]),
                         (34, 18, 1, 3, 1, 2, "normal", 2e-5))
        sheets, weld = 2 * 18.0 ** 2 * 1.2 * 7.85e-9, 9 * 3.141592653589793 * 1.2 * 7.85e-9
        self.assertAlmostEqual(summary["mass"]["physical"] / (sheets + weld), 1.0, 9)
        self.assertAlmostEqual(summary["energy"]["ratio"], 1.0, 4)
        self.assertEqual(summary["time_step"]["controlling"], "beam 31 of part 3")
        (joint,) = summary["weld"]
        self.assertEqual((joint["id"], joint["kind"], joint["part"], joint["parts"], joint["diameter"], joint["tied"]),
                         (31, "beam", 3, [1, 2], 6.0, True))
        self.assertEqual([(p["node"], p["segment"], p["case"]) for p in joint["projection"]],
                         [(301, [106, 107, 111, 110], 1), (302, [206, 207, 211, 210], 1)])
        self.assertGreater(joint["peak"]["shear"], 100.0)

    def test_run_log(self):
        self.write(deck(("       0.0       0.9\n", "       0.0       0.9         0       0.0  -5.0e-07\n")))
        self.nugget("run", "model.k", "--quiet")
        log, summary = self.read("run.log"), self.json("summary.json")
        self.assertTrue(log.startswith("nugget "))
        self.assertTrue(log.endswith("\n N o r m a l    t e r m i n a t i o n\n"), log[-100:])
        for pattern in (r"\*CONTACT_SPOTWELD +1 used", r"\*ELEMENT_SHELL +1 used",       # keyword summary
                        r"nodes 34, shells 18, solids 0, beams 1, parts 3",              # model
                        r"2 +9  shell, ELFORM 2, 3 layers, t = 1.2 mm +\*MAT_PIECEWISE_LINEAR_PLASTICITY +upper sheet",
                        r"Welds: 1, tied at all their nodes: 1; tied nodes: 2", r"case 1 +2 nodes",  # ties
                        r"added to welds +" + re.escape(f"{summary['mass']['added_to_welds']:.6e}"),
                        r"part +3 +" + re.escape(f"{summary['mass']['added']:.6e}"),
                        rf"cycles +{summary['cycles']}\n", r"elements +\d+\.\d+ +\d+\.\d %", r"ns per element and cycle"):
            self.assertRegex(log, pattern)
        self.assertGreater(summary["mass"]["added_to_welds"], 0.0)
        self.assertAlmostEqual(summary["weld"][0]["added_mass"], summary["mass"]["added"], 15)

    def test_the_ledger_names_what_is_ignored_and_left_out(self):
        self.write(deck(("*SECTION_BEAM\n", "*CONTROL_CPU\n     100.0\n*EM_CONTROL\n         1\n*SECTION_BEAM\n")))
        self.nugget("run", "model.k", "--quiet", "--skip-unsupported")
        log = self.read("run.log")
        self.assertRegex(log, r"\*CONTROL_CPU +1 ignored +\S.*\(model\.k:42\)")
        self.assertRegex(log, r"\*EM_CONTROL +1 refused +\S.*\(model\.k:44\)")

    def test_the_element_that_controls_the_step_is_named(self):
        """Nine shells do not fill their blocks of lanes."""
        self.write(deck(("     215         12.0000         18.0000          1.2000", "     215         12.0000         14.0000          1.2000"),
                        ("*CONTACT_SPOTWELD\n         3         1         3         2\n       0.0\n       1.0\n", ""),
                        ("         3         3         3\n", "         3         3         3\n"),
                        ("*ELEMENT_BEAM\n      31       3     301     302       0\n", "")))
        self.nugget("run", "model.k", "--quiet")
        controlling = self.json("summary.json")["time_step"]["controlling"]
        self.assertIn(controlling, ("shell 27 of part 2", "shell 28 of part 2"))
        words = controlling.split()
        self.assertRegex(self.read("glstat"), rf"is controlled by shell +{words[1]} of part +2\n")

    def test_welds_csv(self):
        self.write(deck())
        self.nugget("run", "model.k", "--quiet")
        (row,) = csv.DictReader(io.StringIO(self.read("welds.csv")))
        summary = self.json("summary.json")["weld"][0]
        self.assertEqual([row[name] for name in ("id", "kind", "part", "sheet1", "sheet2", "tied", "node1", "case1", "segment2",
                                                 "failed", "failure_time")],
                         ["31", "beam", "3", "1", "2", "yes", "301", "1", "206 207 211 210", "no", ""])
        self.assertEqual(float(row["peak_shear"]), summary["peak"]["shear"])

    def test_a_weld_that_fails(self):
        self.write(deck(("    8000.0    6000.0    6000.0", "    8000.0    1000.0    1000.0")))
        self.nugget("run", "model.k", "--quiet")
        weld = self.json("summary.json")["weld"][0]
        self.assertTrue(weld["failed"])
        self.assertAlmostEqual(weld["peak"]["shear"], 1000.0, delta=100.0)
        (row,) = csv.DictReader(io.StringIO(self.read("welds.csv")))
        self.assertEqual((row["failed"], float(row["failure_time"])), ("yes", weld["failure_time"]))
        (event,) = re.findall(r"spotweld beam failed +id= +31 time= *(\S+)", self.read("run.log"))
        self.assertAlmostEqual(float(event) / weld["failure_time"], 1.0, 5)
        # The plot shows the beam up to its failure and not after.
        for state in self.d3plot()["states"]:
            (beams,) = (b for b in state["blocks"] if b["name"] == "weld")
            self.assertEqual(beams["cell_arrays"]["vtkGhostType"], [[float(state["time"] > weld["failure_time"])]])

    def test_results_of_an_earlier_run_are_removed(self):
        self.write(deck())
        self.nugget("run", "model.k", "--quiet")
        self.write("mine", "notes.txt")
        (self.folder / "d3plot02").write_bytes(b"left over")
        self.write(deck(("*DATABASE_SWFORC\n  1.00e-06\n", "")))
        self.nugget("run", "model.k", "--quiet")
        self.assertEqual(self.files(), sorted([*(f for f in RESULTS if f != "swforc"), "model.k", "notes.txt"]))
        # A refused deck does not leave results that belong to another one.
        self.write(deck(("*CONTROL_TERMINATION\n  2.00e-05\n", "")))
        self.nugget("run", "model.k", expect=1)
        self.assertEqual(self.files(), ["findings.json", "model.k", "notes.txt", "run.log"])

    def test_folder_of_the_results(self):
        self.write(deck(), "decks/model.k")
        self.nugget("run", "decks/model.k", "-o", "a/new/folder", "--quiet")
        self.assertEqual(self.files(), ["a", "decks"])
        self.assertEqual(self.files("a/new/folder"), RESULTS)
        self.nugget("run", "decks/model.k", "--quiet")  # without -o: here, not beside the deck
        self.assertEqual(self.files("decks"), ["model.k"])
        self.assertIn("d3plot", self.files())

    def test_ls_dyna_spelling(self):
        self.write(deck())
        said = self.nugget("run", "i=model.k", "ncpu=2", "memory=20m").stderr
        self.assertIn("memory=20m: not needed", said)
        self.assertEqual(self.json("summary.json")["threads"], 2)
        self.nugget("run", "i=model.k", "ncpu=-1")
        self.assertEqual(self.json("summary.json")["threads"], 1)

    def test_units_that_are_given(self):
        """A deck of scaled density is none of a metal in any units: then, and only then, they have to be given."""
        self.write(edited(deck(), ("         1  7.85e-09  210000.0       0.3     300.0", "         1  7.85e-10  210000.0       0.3     300.0"),
                          ("         3  7.85e-09  210000.0", "         3  7.85e-10  210000.0")))
        self.nugget("run", "model.k", "-o", "unknown")
        self.assertEqual(self.json("unknown/summary.json")["units"], "")
        self.assertIn("units not recognised: give --units", self.read("unknown/run.log"))
        said = self.nugget("run", "model.k", "-o", "given", "--units", "mm, t, s")
        self.assertEqual(self.json("given/summary.json")["units"], "mm, t, s")
        self.assertIn("units mm, t, s (force N, stress MPa), as given", self.read("given/run.log"))
        self.assertIn("kinetic", said.stderr)
        self.assertRegex(said.stderr, r"internal \S+ N mm")
        self.assertEqual((self.folder / "unknown/d3plot01").read_bytes(), (self.folder / "given/d3plot01").read_bytes())

    def test_units_that_are_not_those_of_the_deck_are_warned_of(self):
        self.write(deck())
        said = self.nugget("check", "model.k", "--units", "mm, kg, ms").stderr
        self.assertIn('warning: --units "mm, kg, ms", but density and Young\'s modulus are those of a metal in "mm, t, s"', said)
        self.assertIn("not in", self.nugget("check", "model.k", "--units", "mm", expect=2).stderr)

    def test_until_and_max_cycles(self):
        self.write(deck())
        self.nugget("run", "model.k", "--until", "1e-5", "--quiet")
        self.assertEqual(self.json("summary.json")["time"], 1e-5)
        run = self.nugget("run", "model.k", "--max-cycles", 7, "--quiet")
        summary = self.json("summary.json")
        self.assertEqual((summary["cycles"], summary["termination"], summary["message"]), (7, "normal", "stopped after 7 cycles"))
        self.assertIn("stopped after 7 cycles\n", run.stderr)
        self.assertAlmostEqual(self.glstat()[-1]["time"] / summary["time"], 1.0, 5)  # the last state is written

    def test_progress(self):
        self.write(deck())
        lines = self.nugget("run", "model.k").stderr.splitlines()
        progress = [line for line in lines if " cycle " in line]
        self.assertRegex(progress[-1], r"^100 %  t 2\.0000e-05  dt \S+  cycle \d+  energy 1\.000\d  welds failed 0/1  left 0:00$")
        self.assertNotIn("\r", "".join(lines))  # no bar where there is no terminal
        quiet = self.nugget("run", "model.k", "--quiet")
        self.assertEqual({line.split()[1] for line in quiet.stderr.splitlines()}, {"note:"})  # findings, and no more

    def test_keywords(self):
        table = self.nugget("keywords").stdout
        for keyword, verdict in (("MAT_SPOTWELD", "used"), ("CONTROL_CPU", "ignored"), ("ICFD_*", "refused")):
            self.assertRegex(table, rf"(?m)^\*{re.escape(keyword)} +{verdict}\b")
        self.assertRegex(self.nugget("keywords", "*database_swforc").stdout, r"swforc +torsion +M L\^2 T\^-2 +torsional moment")
        one = self.nugget("keywords", "MAT_024").stdout
        self.assertTrue(one.startswith("*MAT_PIECEWISE_LINEAR_PLASTICITY: used\nalso written: *MAT_024\n"), one)
        self.assertRegex(one, r"31-40 +pr +real .*0 to 0\.5 .*Poisson's ratio")
        anywhere = self.nugget("keywords", "spotweld").stdout
        self.assertTrue(anywhere.startswith("*...SPOTWELD...: used are\n"), anywhere)
        self.assertLess({"  *CONTACT_SPOTWELD", "  *MAT_SPOTWELD"}, set(anywhere.splitlines()))
        self.assertIn("is it *MAT_SPOTWELD?", self.nugget("keywords", "MAT_SPOTWLED").stdout)

    def test_check_audits_and_runs_nothing(self):
        self.write(deck(("     302          9.0000          9.0000          1.2000", "     302         11.0000          9.0000          1.2000")))
        run = self.nugget("check", "model.k", "-o", "audit")
        self.assertEqual(self.files("audit"), ["check.log", "findings.json", "units.csv", "welds.csv"])
        self.assertIn("degrees off the normal of its first sheet", run.stderr)
        self.assertRegex(run.stdout, r"(?m)^ angle +degrees to normal +59 +59 +! +1 +31: 59$")
        self.assertRegex(run.stdout, r"(?m)^ +31 +beam +3 +6 +\S+ +yes  1\+2 +angle: its axis is ")
        self.assertIn(" angle     degrees to normal", self.read("audit/check.log"))
        (row,) = csv.DictReader(io.StringIO(self.read("audit/welds.csv")))
        self.assertIn("angle", row["remarks"])
        self.assertAlmostEqual(float(row["angle"]), math.degrees(math.atan(2.0 / 1.2)), 6)
        self.assertEqual((row["stack_sheets"], row["aspect_ratio"]), ("2", ""))

    def test_check_leaves_the_results_of_a_run_alone(self):
        self.write(deck())
        self.nugget("run", "model.k", "--quiet")
        before = {name: (self.folder / name).read_bytes() for name in self.files()}
        run = self.nugget("check", "model.k")
        self.assertIn("holds the results of a run and was left as it is", run.stderr)
        self.assertEqual(self.files("check"), ["check.log", "findings.json", "units.csv", "welds.csv"])
        self.assertEqual({name: (self.folder / name).read_bytes() for name in self.files() if name != "check"}, before)
        # A run clears away what a check left, as it does with what a run left.
        self.nugget("check", "model.k", "-o", "other")
        self.nugget("run", "model.k", "-o", "other", "--quiet")
        self.assertEqual(self.files("other"), RESULTS)
        self.assertIn(" diameter  d / 5 sqrt(t)", self.read("other/run.log"))

    def test_what_a_weld_takes_for_a_target_step(self):
        """L = 1.2, d = 6: step 2.320e-7; for 1e-6 the mass times 18.58, or E' = L^2 rho / DT^2."""
        self.write(deck())
        run = self.nugget("check", "model.k", "--target-step", "1e-6")
        self.assertRegex(run.stdout, r"Time step 1e-06 s: 1 of 1 welds have a smaller one")
        (row,) = csv.DictReader(io.StringIO(self.read("welds.csv")))
        mass = 7.85e-9 * math.pi * 9.0 * 1.2
        factor = 210000.0 / 7.85e-9 * (1e-6 / 1.2) ** 2
        self.assertAlmostEqual(float(row["target_mass"]) / (mass * (factor - 1.0)), 1.0, 9)
        self.assertAlmostEqual(float(row["target_young"]) / (1.2 ** 2 * 7.85e-9 / 1e-12), 1.0, 9)
        self.assertRegex(run.stdout, rf"(?m)^ +31 +2\.32e-07 +\S+ +\S+ +{factor:.4g} +1\.13e\+04 +2\.1e\+05$")
        self.nugget("check", "model.k", "--target-step", "0", expect=2)

    def test_version_and_help(self):
        self.assertRegex(self.nugget("--version").stdout, r"^nugget \d+\.\d+\.\d+\n$")
        self.assertIn("check", self.nugget("--help").stdout)
        self.assertIn("--max-cycles", self.nugget("run", "--help").stdout)


if __name__ == "__main__":
    unittest.main()
