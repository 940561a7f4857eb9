# SPDX-License-Identifier: Apache-2.0
"""A run that others look at and speak to while it goes: status.out, nugget watch, d3kil; and what it says at its end."""
import subprocess
import time
import unittest

from lap_joint import deck, edited
from nugget_command import NUGGET, CommandTest

LONG = ("2.00e-05", "1.00e+02")  # an end that is not reached


class WatchedRuns(CommandTest):
    def start(self, *changes):
        self.write(deck(LONG, *changes))
        run = subprocess.Popen([NUGGET, "run", "model.k", "-o", "run", "-j1", "--quiet"], cwd=self.folder, stderr=subprocess.PIPE,
                               stdout=subprocess.PIPE, text=True)
        self.addCleanup(run.communicate)
        self.addCleanup(run.kill)
        self.wait_for(lambda: self.cycle() > 0)
        return run

    def wait_for(self, condition, seconds=30):
        end = time.monotonic() + seconds
        while not condition():
            self.assertLess(time.monotonic(), end, "it took too long")
            time.sleep(0.05)

    def status(self):
        lines = self.read("run/status.out").splitlines() if (self.folder / "run" / "status.out").exists() else []
        return {line[1:21].strip(): line[21:] for line in lines}

    def cycle(self):
        return int(self.status().get("cycle", "0"))

    def switch(self, word):
        """Asks for it, and waits until it is taken."""
        draft = self.folder / "draft"
        draft.write_text(word + "\n", encoding="ascii")
        draft.rename(self.folder / "run" / "d3kil")
        self.wait_for(lambda: not (self.folder / "run" / "d3kil").exists())

    def states(self):
        return sum(path.stat().st_size for path in (self.folder / "run").glob("d3plot[0-9]*"))

    def test_sw1_stops_with_a_restart_file(self):
        run = self.start()
        self.switch("SW1.")
        _, error = run.communicate(timeout=30)
        self.assertEqual(run.returncode, 130, error)
        self.assertIn("interrupted by d3kil at time", error)
        self.assertIn("restart", self.files("run"))
        self.assertNotIn("status.out", self.files("run"))
        cycles = self.json("run/summary.json")["cycles"]
        self.nugget("run", "--resume", "run", "--max-cycles", cycles + 10)
        self.assertEqual(self.json("run/summary.json")["termination"], "normal")

    def test_sw3_writes_a_restart_file_and_goes_on(self):
        run = self.start()
        self.assertNotIn("restart", self.files("run"))
        self.switch("sw3")
        self.wait_for(lambda: "restart" in self.files("run"))
        cycle = self.cycle()
        self.wait_for(lambda: self.cycle() > cycle)
        self.assertIsNone(run.poll())

    def test_sw4_writes_a_state_that_is_not_due(self):
        run = self.start(("*DATABASE_BINARY_D3PLOT\n  5.00e-06", "*DATABASE_BINARY_D3PLOT\n  5.00e+01"))
        before = self.states()
        self.switch("sw4")
        self.wait_for(lambda: self.states() > before)
        self.assertIsNone(run.poll())
        self.switch("sw1")
        run.communicate(timeout=30)
        times = [state["time"] for state in self.d3plot("run")["states"]]
        self.assertEqual(len(times), 3)  # the first, the one asked for, the last
        self.assertEqual(times, sorted(times))

    def test_sw4_leaves_the_states_that_are_due_where_they_were(self):
        """The rhythm of d3plot is that of the deck, whatever was asked for between."""
        run = self.start(("*DATABASE_BINARY_D3PLOT\n  5.00e-06", "*DATABASE_BINARY_D3PLOT\n  2.00e-03"))
        self.switch("sw4")
        self.wait_for(lambda: float(self.status()["time"]) > 7e-3)
        self.switch("sw1")
        run.communicate(timeout=30)
        times = [state["time"] for state in self.d3plot("run")["states"]]
        for mark in (0.0, 2e-3, 4e-3, 6e-3):
            self.assertTrue(any(abs(t - mark) < 2e-6 for t in times), (mark, times))

    def test_sw2_and_what_is_none(self):
        run = self.start()
        self.switch("sw2")
        self.switch("sw9")
        self.switch("sw1")
        _, error = run.communicate(timeout=30)
        self.assertRegex(error, r"d3kil: t \S+  dt \S+  cycle \d+")
        self.assertIn("d3kil says 'sw9', expected sw1", error)

    def test_a_switch_of_an_earlier_run_stops_nothing(self):
        self.write(deck())
        (self.folder / "run").mkdir()
        self.write("sw1\n", "run/d3kil")
        self.nugget("run", "model.k", "-o", "run")

    def test_watch_follows_to_the_end(self):
        run = self.start()
        seen = self.nugget("watch", "run", "--once").stdout
        self.assertRegex(seen, r"model.k  running  \d+\.\d % in \d+:\d\d")
        self.assertRegex(seen, r"internal energy +\|[ ▁▂▃▄▅▆▇█]{60}\| now ")
        self.switch("sw1")
        run.communicate(timeout=30)
        self.assertIn("model.k  interrupted", self.nugget("watch", "run", expect=130).stdout)

    def test_watch_says_when_a_run_is_silent(self):
        self.start().kill()
        status = self.folder / "run" / "status.out"
        self.wait_for(lambda: "updated" in self.status())
        updated = int(self.status()["updated"])
        status.write_text(status.read_text(encoding="ascii").replace(str(updated), str(updated - 1000)), encoding="ascii")
        self.assertRegex(self.nugget("watch", "run", "--once").stdout, r"no sign of life for 1\d\d\d s")

    def test_watch_of_a_run_that_ended(self):
        self.write(deck())
        self.nugget("run", "model.k", "-o", "run")
        seen = self.nugget("watch", "run").stdout
        self.assertIn("model.k  normal  100.0 %", seen)
        energies = [s["internal energy"] for s in self.glstat("run/glstat")]
        self.assertIn(f"now {energies[-1]:.4g}", seen)
        self.assertLess(len(energies), 60)  # fewer than columns: none of them is left blank
        self.assertRegex(seen, r"internal energy +\|[▁▂▃▄▅▆▇█]{60}\|")

    def test_watch_of_no_run(self):
        self.assertIn("no status.out", self.nugget("watch", ".", expect=2).stderr)

    def test_what_matters_is_said_at_the_end(self):
        self.write(deck())
        said = self.nugget("run", "model.k", "-o", "holds").stderr
        weld, = self.json("holds/summary.json")["weld"]
        self.assertRegex(said, rf"welds: 0 of 1 failed; nearest to it {weld['id']} at \(9, 9, 0.6\) mm, failure value 0\.\d+ at \S+ s")
        self.assertRegex(said, r"energy: kinetic \S+ N mm, internal \S+ N mm")
        self.write(edited(deck(), ("    8000.0    6000.0    6000.0", "      80.0      60.0      60.0")))
        said = self.nugget("run", "model.k", "-o", "fails").stderr
        weld, = self.json("fails/summary.json")["weld"]
        self.assertIn(f"welds: 1 of 1 failed, first {weld['id']} at (9, 9, 0.6) mm at {weld['failure_time']:.4g} s by {weld['failure_mode']}", said)
        quiet = self.nugget("run", "model.k", "-o", "fails", "--quiet").stderr
        self.assertNotIn("welds: 1 of 1", quiet)


if __name__ == "__main__":
    unittest.main()
