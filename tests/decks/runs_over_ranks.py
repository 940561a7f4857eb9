# SPDX-License-Identifier: Apache-2.0
"""Explicit runs over several ranks of mpirun, which must leave the same bits as one process."""
import subprocess

from repeated_runs import RepeatedRuns, with_lanes
from under_mpirun import ENVIRONMENT, mpirun


class RunsOverRanks(RepeatedRuns):
    def command(self, ranks, *arguments):
        return mpirun(ranks, *arguments)

    def over(self, ranks, *arguments, expect=0, lanes=None):
        environment = dict(ENVIRONMENT, **({"NUGGET_LANES": str(lanes)} if lanes else {}))
        run = subprocess.run(self.command(ranks, *arguments), capture_output=True, text=True, timeout=200, cwd=self.folder, env=environment)
        self.assertEqual(run.returncode, expect, f"{ranks} ranks: {arguments}\n{run.stderr}\n{run.stdout}")
        return run

    def compare_ranks(self, text, *options, ranks=((2, 1), (3, 2)), expect=0):
        """One process with one thread against these ranks and threads; the summary of the last."""
        model = self.write(text) if isinstance(text, str) else text
        self.nugget("run", model, "-o", "one", "-j", 1, "--quiet", *options, env=with_lanes(4), expect=expect)
        reference = self.bits("one")
        for count, threads in ranks:
            folder = f"r{count}_{threads}"
            run = self.over(count, "run", model, "-o", folder, "-j", threads, "--quiet", *options, expect=expect)
            self.assertEqual(run.stdout.count("t e r m i n a t i o n"), 1)  # one rank speaks
            bits = self.bits(folder)
            self.assertEqual(sorted(bits), sorted(reference))
            for name, content in bits.items():
                self.assertTrue(content == reference[name], f"{name} differs with {count} ranks of {threads} threads")
            summary, alone = self.json(f"{folder}/summary.json"), self.json("one/summary.json")
            self.assertEqual((summary["ranks"], len(summary["rank"]), summary["threads"]), (count, count, threads))
            for quantity in ("cycles", "time", "time_step", "mass", "energy", "termination", "message", "weld"):
                self.assertEqual(summary[quantity], alone[quantity], quantity)
        return summary
