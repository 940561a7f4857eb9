# SPDX-License-Identifier: Apache-2.0
"""A rank of a run is killed at any time: the others end within seconds, and the run goes on from its restart file with any number of ranks to the bytes
of a run that nobody disturbed. NUGGET_KILLS=100 in the environment does so a hundred times."""
import os
import random
import signal
import subprocess
import sys
import time
import unittest

from nugget_command import SOURCE
from repeated_runs import RepeatedRuns, with_lanes
from under_mpirun import ENVIRONMENT, MPIRUN, mpirun, ranks_in

KILLS = int(os.environ.get("NUGGET_KILLS", "3"))
CYCLES = 500


@unittest.skipUnless(MPIRUN, "mpirun is not installed")
class KilledRanks(RepeatedRuns):
    def start(self, ranks, *arguments):
        command = mpirun(ranks, "run", *arguments, "-j", 1, "--quiet", "--max-cycles", CYCLES)
        return subprocess.Popen(command, cwd=self.folder, env=ENVIRONMENT, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)

    def finish(self, run):
        """What it said, at most five minutes later."""
        with run:
            said = run.communicate(timeout=300)[1]
        self.assertEqual(run.returncode, 0, said)

    def left(self, folder):
        return self.files(folder) if (self.folder / folder).is_dir() else []

    def test_nothing_is_lost(self):
        subprocess.run([sys.executable, str(SOURCE / "examples" / "double_hat" / "make.py"), str(self.folder)], check=True)
        model = "double_hat.k"
        self.nugget("run", model, "-o", "whole", "-j", 1, "--quiet", "--max-cycles", CYCLES, env=with_lanes(4))
        whole = self.bits("whole")
        draw = random.Random(KILLS)
        begin = time.monotonic()
        self.finish(self.start(3, model, "-o", "undisturbed"))
        lasts = time.monotonic() - begin
        struck = slowest = resumed = 0
        for kill in range(KILLS):
            with self.subTest(kill=kill), self.start(3, model, "-o", f"k{kill}", "--checkpoint", "50cycles") as run:
                time.sleep(draw.uniform(0.0, lasts))
                ranks = ranks_in(self.folder)
                if ranks and run.poll() is None:
                    os.kill(draw.choice(ranks), signal.SIGKILL)
                    begin = time.monotonic()
                    said, code = run.communicate(timeout=30)[1], run.returncode
                    while ranks_in(self.folder):  # mpirun does not wait for what it kills
                        self.assertLess(time.monotonic() - begin, 30.0)
                        time.sleep(0.05)
                    slowest = max(slowest, time.monotonic() - begin)
                    struck += code != 0
                    if code != 0:
                        self.assertIn("killed", said.lower())
                else:
                    run.communicate(timeout=300)
                if "summary.json" not in self.left(f"k{kill}"):
                    if "restart" not in self.left(f"k{kill}"):
                        continue  # killed before the first one: there is nothing to lose
                    resumed += 1
                    self.finish(self.start(draw.randint(1, 3), "--resume", f"k{kill}"))
                bits = self.bits(f"k{kill}")
                for name, content in whole.items():
                    self.assertTrue(bits[name] == content, name)
        print(f"{KILLS} runs: a rank killed in {struck}, others ended within {slowest:.1f} s, {resumed} gone on with from a restart file")
        self.assertGreater(struck, 0)


if __name__ == "__main__":
    unittest.main()
