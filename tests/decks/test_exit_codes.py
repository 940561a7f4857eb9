# SPDX-License-Identifier: Apache-2.0
"""Each exit code of docs/reference/contract.md, by a run that really ends that way, and what it leaves behind."""
import os
import re
import resource
import signal
import subprocess
import time
import unittest

from lap_joint import deck, edited
from nugget_command import NUGGET, CommandTest

# A soft block of one brick, whose top is driven onto its bottom; what happens on the way is up to the speed and to the limits.
BLOCK = """\
*KEYWORD
*CONTROL_TERMINATION
  1.00e-03         0       0.0       0.0
*CONTROL_TIMESTEP
       0.0       0.9
*DATABASE_GLSTAT
  1.00e-05
*DATABASE_BINARY_D3PLOT
  1.00e-05
*PART
block
         1         1         1
*SECTION_SOLID
         1         1
*MAT_ELASTIC
         1  1.00e-09      10.0       0.0
*BOUNDARY_SPC_SET
         1         0         1         1         1
*SET_NODE_LIST
         1
         1         2         3         4
*BOUNDARY_PRESCRIBED_MOTION_SET
         2         3         0         1      -1.0
*SET_NODE_LIST
         2
         5         6         7         8
*DEFINE_CURVE
         1
                 0.0             20000.0
                 1.0             20000.0
*NODE
       1             0.0             0.0             0.0
       2            10.0             0.0             0.0
       3            10.0            10.0             0.0
       4             0.0            10.0             0.0
       5             0.0             0.0            10.0
       6            10.0             0.0            10.0
       7            10.0            10.0            10.0
       8             0.0            10.0            10.0
*ELEMENT_SOLID
       1       1       1       2       3       4       5       6       7       8
*END
"""
SPEED = ("                 0.0             20000.0\n                 1.0             20000.0\n",
         "                 0.0            150000.0\n                 1.0            150000.0\n")
LIMITS = "  1.00e-03         0       0.0       0.0\n"
LONG = [("  2.00e-05\n*CONTROL_TIMESTEP", "  2.00e+03\n*CONTROL_TIMESTEP"),
        ("*DATABASE_BINARY_D3PLOT\n  5.00e-06", "*DATABASE_BINARY_D3PLOT\n  1.00e-03"),
        ("*DATABASE_GLSTAT\n  5.00e-06", "*DATABASE_GLSTAT\n  1.00e-03"),
        ("*DATABASE_MATSUM\n  5.00e-06", "*DATABASE_MATSUM\n  1.00e-03"),
        ("*DATABASE_NODOUT\n  5.00e-06", "*DATABASE_NODOUT\n  1.00e-03"),
        ("*DATABASE_SWFORC\n  1.00e-06", "*DATABASE_SWFORC\n  1.00e-03")]


class ExitCodes(CommandTest):
    def test_0_normal_termination(self):
        self.write(deck())
        self.assertEqual(self.nugget("run", "model.k").stdout, " N o r m a l    t e r m i n a t i o n\n")

    def test_1_refused(self):
        self.write(deck(("*CONTROL_TERMINATION\n  2.00e-05\n", "")))
        self.assertEqual(self.nugget("run", "model.k", expect=1).stdout, "")
        self.assertEqual(self.files(), ["findings.json", "model.k", "run.log"])

    def test_2_wrong_command_line(self):
        self.write(deck())
        for arguments, word in ((["run"], "model"), ([], "subcommand"), (["fly"], "fly"), (["model.k"], "nugget run MODEL.k"),
                                (["run", "model.k", "--frobnicate"], "nugget run: there is no option '--frobnicate'\n"),
                                (["run", "model.k", "--max-cycle", "3"], "no option '--max-cycle'; is it --max-cycles?"),
                                (["run", "model.k", "--cycles=3"], "no option '--cycles'; is it --max-cycles?"),
                                (["plot", "--overr", "glstat"], "nugget plot: there is no option '--overr'; is it --over?"),
                                (["--versoin"], "nugget: there is no option '--versoin'; is it --version?"), (["chekc"], "is it check?"),
                                (["run", "model.k", "two.k"], "nugget run: 'two.k' is one word too many"),
                                (["run", "model.k", "jobid=a"], "jobid=a"), (["report"], "directory"),
                                (["run", "model.k", "-j", "0"], "'0', expected a whole number of 1 or more"),
                                (["run", "i=model.k", "ncpu=some"], "'some', expected a whole number of 1 or more"),
                                (["run", "model.k", "--until", "soon"], "'soon', expected a time above 0"),
                                (["run", "model.k", "--max-cycles", "1.5"], "'1.5', expected a whole number of 1 or more"),
                                (["run", "model.k", "--checkpoint", "soon"], "'soon', expected e.g. 500cycles"),
                                (["run", "--resume", ".", "-o", "there"], "--output")):
            with self.subTest(arguments):
                run = self.nugget(*arguments, expect=2)
                self.assertIn(word, run.stderr)
                self.assertEqual(run.stdout, "")
        self.assertEqual(self.files(), ["model.k"])

    def test_3_memory_runs_out(self):
        """With room for more and more: from where the program can be loaded (until then libgfortran can overflow the stack in its own
        start, to report that it has no memory) it says what is missing, also in run.log where the run has begun; in the end the run is
        normal. Sabotage: no room for the deck's text taken for a file that cannot be read. OpenBLAS with threads of its own would wait
        for memory."""
        side = 200
        nodes = "".join(f"{j * (side + 1) + i + 1:8}{5.0 * i:16.6f}{5.0 * j:16.6f}{0.0:16.6f}\n" for j in range(side + 1) for i in range(side + 1))
        first = [j * (side + 1) + i + 1 for j in range(side) for i in range(side)]
        shells = "".join(f"{e:8}{1:8}{a:8}{a + 1:8}{a + side + 2:8}{a + side + 1:8}\n" for e, a in enumerate(first, 1))
        self.write("*KEYWORD\n*CONTROL_TERMINATION\n  1.00e-05\n*PART\nplate\n         1         1         1\n"
                   "*SECTION_SHELL\n         1         2\n       1.0\n*MAT_ELASTIC\n         1  7.85e-09  210000.0       0.3\n"
                   f"*DATABASE_GLSTAT\n  1.00e-06\n*NODE\n{nodes}*ELEMENT_SHELL\n{shells}*END\n")

        def in_room(room, *arguments):
            return subprocess.run([NUGGET, *arguments], cwd=self.folder, capture_output=True, text=True, timeout=120,
                                  env=dict(os.environ, OPENBLAS_NUM_THREADS="1"),
                                  preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (room * 10**6,) * 2))

        codes = []
        for room in range(60, 1000, 2):
            if not codes and in_room(room, "--version").returncode != 0:
                continue
            run = in_room(room, "run", "model.k", "-j", "1", "--quiet", "--max-cycles", "3")
            codes.append(run.returncode)
            if run.returncode == 3:
                self.assertIn("nugget: not enough memory for this model [", run.stderr)
                self.assertNotIn("N o r m a l", self.read("run.log") if "run.log" in self.files() else "")
            if run.returncode == 0:
                break
        self.assertEqual(codes[-1], 0)
        self.assertIn(3, codes)
        self.assertLessEqual(set(codes), {0, 3})

    def error_termination(self, text, reason):
        """Runs into an error; the reason stands everywhere, the results up to there are numbers."""
        self.write(text)
        run = self.nugget("run", "model.k", expect=3)
        message = next((line for line in run.stderr.splitlines() if re.fullmatch(reason, line)), None)
        self.assertIsNotNone(message, run.stderr)
        self.assertEqual(run.stdout, " E r r o r   t e r m i n a t i o n\n")
        self.assertTrue(self.read("run.log").endswith(f" {message}\n\n E r r o r   t e r m i n a t i o n\n"))
        summary = self.json("summary.json")
        self.assertEqual((summary["termination"], summary["message"]), ("error", message))
        self.assertLess(summary["time"], 0.99e-2)
        states = self.glstat()
        self.assertGreaterEqual(len(states), 2)
        for values in [*states, summary["energy"]]:
            for name, value in values.items():
                self.assertTrue(isinstance(value, float) and abs(value) < 1e300, f"{name} = {value}")
        seen = self.d3plot()
        self.assertGreaterEqual(len(seen["states"]), 2)
        for state in seen["states"]:
            for block in state["blocks"]:
                for x in block["point_arrays"]["Deflected Coordinates"]:
                    self.assertTrue(all(abs(c) < 1e30 for c in x), f"at {state['time']}: {x}")

    def test_3_negative_volume(self):
        self.error_termination(edited(BLOCK, SPEED), r"negative volume in solid 1 of part 1 at time \S+, cycle \d+ \[.*\]")

    def test_1_check_tries_the_first_cycles(self):
        """A run that would end at its start is refused by the check, which says what the run would; other decks pass."""
        self.write(edited(BLOCK, SPEED))
        told = self.nugget("run", "model.k", "--quiet", "-o", "of_run", expect=3).stderr.splitlines()[-1]
        self.assertRegex(told, r"^negative volume in solid 1 of part 1 at time \S+, cycle [12] \[see what loads, drives and ties its nodes")
        check = self.nugget("check", "model.k", "-o", "of_check", expect=1)
        self.assertIn(f"model.k: error: a run ends at its start: {told} [", check.stderr)
        self.assertEqual(self.files("of_check"), ["check.log", "findings.json"])
        self.write(BLOCK)
        self.nugget("check", "model.k", "-o", "slow")

    def test_3_time_step_below_dtmin(self):
        self.error_termination(edited(BLOCK, (LIMITS, "  1.00e-03         0       0.5       0.0\n")),
                               r"the time step \S+ of solid 1 of part 1 fell below DTMIN times the first step, \S+")

    def test_3_time_stands_still(self):
        self.error_termination(BLOCK, r"the time step \S+ of solid 1 of part 1 is too small to go on from time \S+, cycle \d+")

    def test_3_energy_ratio_beyond_endeng(self):
        self.error_termination(deck(("  2.00e-05\n*CONTROL_TIMESTEP", "  1.00e-03         0       0.0      10.0\n*CONTROL_TIMESTEP"),
                                    ("       0.0       0.9\n", "       0.0       3.0\n")),
                               r"the energy ratio \S+ left the limit ENDENG = 10 %")

    def test_3_solution_that_diverges(self):
        """Elastic, with twice the stable step of the shells; a curve keeps the step there while the shells grow."""
        too_long = "                 0.0             2.0e-06\n                 1.0             2.0e-06\n"
        text = deck(("       0.0       0.9\n", "       0.0      12.0         0       0.0       0.0         2\n"),
                    ("*BOUNDARY_SPC_SET\n", "*DEFINE_CURVE\n         2\n" + too_long + "*BOUNDARY_SPC_SET\n"),
                    ("*MAT_PIECEWISE_LINEAR_PLASTICITY\n", "*MAT_ELASTIC\n"),
                    ("       0.3     300.0    1000.0\n       0.0       0.0\n\n\n*SECTION_BEAM", "       0.3\n*SECTION_BEAM"),
                    ("  2.00e-05\n*CONTROL_TIMESTEP", "  9.90e-03\n*CONTROL_TIMESTEP"))
        self.error_termination(text, r"the solution diverged: .* at time \S+, cycle \d+")

    def test_4_a_file_stands_where_the_folder_should_be(self):
        self.write(deck())
        self.write("not a folder", "results")
        run = self.nugget("run", "model.k", "-o", "results", expect=4)
        self.assertEqual(run.stderr, "nugget: cannot write results: Not a directory\n")
        self.assertEqual(self.read("results"), "not a folder")

    def test_4_a_folder_stands_where_a_result_should_be(self):
        self.write(deck())
        (self.folder / "swforc").mkdir()
        run = self.nugget("run", "model.k", expect=4)
        self.assertIn("nugget: cannot write ./swforc: Is a directory\n", run.stderr)
        self.assertTrue(self.read("run.log").endswith(" cannot write ./swforc: Is a directory\n\n E r r o r   "
                                                      "t e r m i n a t i o n\n"))

    def test_4_the_disk_is_full(self):
        """A limit on the size of files stands in for the disk."""
        self.write(deck())

        def small_disk():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (16000, 16000))

        run = self.nugget("run", "model.k", expect=4, preexec_fn=small_disk)
        self.assertIn("nugget: cannot write ./d3plot01: File too large\n", run.stderr)
        self.assertIn("cannot write ./d3plot01", self.read("run.log"))
        seen = self.d3plot()
        self.assertGreaterEqual(len(seen["states"]), 1)
        self.assertEqual(seen["nodes"], 34)

    def interrupt(self, number):
        self.write(deck(*LONG))
        run = subprocess.Popen([NUGGET, "run", "model.k", "-j", "1"], cwd=self.folder, stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True)
        try:
            deadline = time.monotonic() + 20.0
            while not (self.folder / "glstat").exists() or len(self.glstat()) < 3:
                self.assertLess(time.monotonic(), deadline, "no results yet")
                time.sleep(0.05)
            os.kill(run.pid, number)
            out, error = run.communicate(timeout=20)
        finally:
            run.kill()
        self.assertEqual(run.returncode, 130, error)
        self.assertEqual(out, " I n t e r r u p t e d\n")
        self.assertRegex(error, r"interrupted by (?:the user|SIGTERM) at time \S+, cycle \d+; results up to there are kept; to go on: "
                                r"nugget run --resume \.\n")
        summary = self.json("summary.json")
        self.assertEqual(summary["termination"], "interrupted")
        self.assertTrue(self.read("run.log").endswith(" I n t e r r u p t e d\n"))
        self.assertAlmostEqual(self.glstat()[-1]["time"], summary["time"], delta=1e-5 * summary["time"])
        self.assertAlmostEqual(self.d3plot()["states"][-1]["time"], summary["time"], delta=1e-5 * summary["time"])

    def test_130_interrupted_by_the_keyboard(self):
        self.interrupt(signal.SIGINT)

    def test_130_asked_to_end(self):
        self.interrupt(signal.SIGTERM)


if __name__ == "__main__":
    unittest.main()
