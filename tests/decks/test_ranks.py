# SPDX-License-Identifier: Apache-2.0
"""Two ranks of mpirun: frequencies, responses and displacements of one process; refusals, exit codes, ranks that die."""
import os
import shutil
import signal
import subprocess
import time
import unittest

from nugget_command import NUGGET, CommandTest
from test_linear_resistance import mechanism
from test_mode_studies import strips
from test_responses import fields, frf, strip
from test_statics import statics
from under_mpirun import ENVIRONMENT, MPIRUN, mpirun, ranks_in

MODES = "*CONTROL_IMPLICIT_EIGENVALUE\n" + fields(5)  # asked for, though a direct solution does without


@unittest.skipUnless(MPIRUN, "mpirun is not installed")
class Ranks(CommandTest):
    def command(self, *arguments):
        return mpirun(2, *arguments)

    def two(self, *arguments, expect=0):
        run = subprocess.run(self.command(*arguments), capture_output=True, text=True, timeout=120, cwd=self.folder, env=ENVIRONMENT)
        self.assertEqual(run.returncode, expect, f"{arguments}\n{run.stderr}\n{run.stdout}")
        return run

    def both(self, *arguments):
        """The same command by one process into `one` and by two ranks into `two`; what the latter printed."""
        self.nugget(*arguments, "-o", "one", "--quiet")
        run = self.two(*arguments, "-o", "two", "--quiet")
        self.assertEqual(run.stdout.count("N o r m a l"), 1)  # one rank speaks
        self.assertEqual([self.json(f"{folder}/summary.json")["ranks"] for folder in ("one", "two")], [1, 2])
        self.assertIn("\n ranks    2\n", self.read("two/run.log"))
        self.assertEqual(self.files("one"), self.files("two"))
        return run

    def same(self, one, two, within=1e-9):
        self.assertEqual(len(one), len(two))
        for a, b in zip(one, two):
            self.assertAlmostEqual(b / a, 1.0, delta=within)

    def test_frequencies(self):
        self.write(strips())
        self.both("modes", "model.k", "-n", 30)
        one, two = ([mode["frequency_hz"] for mode in self.json(f"{folder}/summary.json")["modes"]] for folder in ("one", "two"))
        self.same(one[6:], two[6:])
        self.assertLess(max(two[:6]), 1e-3 * two[6])  # rigid motions
        self.assertIn("no mode was missed", self.read("two/run.log"))
        self.assertIn("memory of the solver", self.read("two/run.log"))

    def test_memory_of_the_first_rank_falls(self):
        """Lanczos vectors and factor are shared out; 60 modes of a plate of 90 x 60 shells."""
        self.write(strip(lambda tip: MODES, 90, 60))
        self.both("modes", "model.k", "-n", 60, "-j", 1)
        one, two = (self.json(f"{folder}/summary.json") for folder in ("one", "two"))
        self.same(*([mode["frequency_hz"] for mode in summary["modes"]][6:] for summary in (one, two)))
        self.assertLess(two["peak_memory_mb"], one["peak_memory_mb"] - 20.0)

    def test_memory_that_runs_out_on_one_rank_ends_all(self):
        self.write(strip(lambda tip: MODES, 90, 60))
        codes = set()
        for rank in (0, 1):
            for megabytes in (420, 480, 540, 600):
                limit = ["bash", "-c", f'[ $OMPI_COMM_WORLD_RANK = {rank} ] && ulimit -v {1024 * megabytes}; exec "$@"', "_", NUGGET]
                command = [word for each in self.command("modes", "model.k", "-n", 60, "-j", 1, "-o", "out", "--quiet")
                           for word in (limit if each == NUGGET else [each])]
                run = subprocess.run(command, capture_output=True, text=True, timeout=60, cwd=self.folder, env=ENVIRONMENT)
                if "mpi_init" in run.stderr.lower():  # too little for MPI itself
                    continue
                codes.add(run.returncode)
                self.assertIn(run.returncode, (0, 3), run.stderr)
                self.assertEqual(run.returncode == 3, "not enough memory" in run.stderr, run.stderr)
        self.assertIn(3, codes)

    def test_direct_response(self):
        self.write(strip(lambda tip: MODES + frf((tip, 0, 3, 3), (0, 0, 0, 20.0, 2e-5), (tip, 0, 3, 1), (1.0, 401.0, 9)), 20, 2))
        self.both("frf", "model.k", "--direct")
        one, two = ([r["peak"]["amplitude"] for r in self.json(f"{folder}/summary.json")["responses"]] for folder in ("one", "two"))
        self.same(one, two)

    def test_statics(self):
        self.write(statics())
        self.both("run", "model.k")
        one, two = (self.json(f"{folder}/summary.json") for folder in ("one", "two"))
        self.same([one["energy"]["internal"], one["weld"][0]["peak"]["shear"]],
                  [two["energy"]["internal"], two["weld"][0]["peak"]["shear"]])

    def test_exit_codes(self):
        self.assertIn("there is no command", self.two("mode", "model.k", expect=2).stderr)
        self.two("modes", "missing.k", expect=1)
        free = statics(("         1         0         1         1         1         1         1         1\n",
                        "         1         0         1         1         0         0         0         0\n"))
        self.write(free)
        self.assertEqual(self.two("run", "model.k", "-o", "out", "--quiet", expect=1).stderr.count("is not held"), 1)
        self.write(mechanism())
        self.assertEqual(self.two("run", "model.k", "-o", "out", "--quiet", expect=3).stderr.count("is not held"), 1)
        self.assertEqual(self.two("--version").stdout.count("nugget"), 1)

    def test_no_rank_stays_behind(self):
        """Ctrl-C at mpirun, and the death of a rank that only answers."""
        self.write(strip(lambda tip: MODES + frf((tip, 0, 3, 3), (0, 0, 0, 20.0, 2e-5), (tip, 0, 3, 1), (1.0, 400.0, 100000)), 40, 4))
        for strike in ("interrupt", "kill a rank"):
            folder = strike.replace(" ", "_")
            with subprocess.Popen(self.command("frf", "model.k", "--direct", "-o", folder, "--quiet"), cwd=self.folder, env=ENVIRONMENT,
                                  stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as mpirun:
                deadline = time.monotonic() + 60
                while "run.log" not in (self.files(folder) if (self.folder / folder).exists() else []):
                    self.assertLess(time.monotonic(), deadline)
                    self.assertIsNone(mpirun.poll())
                    time.sleep(0.1)
                ranks = ranks_in(self.folder)
                self.assertEqual(len(ranks), 2)
                if strike == "interrupt":
                    mpirun.send_signal(signal.SIGINT)
                else:
                    os.kill(ranks[-1], signal.SIGKILL)
                self.assertNotEqual(mpirun.wait(60), 0)
            self.assertEqual(ranks_in(self.folder), [])
            self.assertNotIn("summary.json", self.files(folder))

    def test_the_program_with_mpi_is_missing(self):
        alone = self.folder / "nugget"
        shutil.copy(NUGGET, alone)
        run = subprocess.run([alone, "modes", "model.k"], capture_output=True, text=True, timeout=60,
                             env=dict(os.environ, OMPI_COMM_WORLD_SIZE="2"))
        self.assertEqual(run.returncode, 2)
        self.assertIn(f"which need {self.folder.resolve()}/nugget-mpi", run.stderr)

    def test_another_mpirun(self):
        """nugget-mpi alone would be many copies of itself, each the first rank."""
        run = self.nugget("modes", "model.k", expect=2, env=dict(ENVIRONMENT, PMI_SIZE="2"))
        self.assertIn("the mpirun that started this is not that of the MPI", run.stderr)


if __name__ == "__main__":
    unittest.main()
