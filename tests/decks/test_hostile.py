# SPDX-License-Identifier: Apache-2.0
"""What a machine does to a run: full disks and terminals, closed streams, signals, files that go; and decks with numbers at
the edges of what a number can be. It is told, with a code that says so; nothing ends without a word."""
import pathlib
import re
import resource
import signal
import subprocess
import time
import unittest

import lap_joint
from nugget_command import NUGGET, CommandTest

END = "  2.00e-05"


def long_deck():
    """The lap joint to a thousand times its end time, with results as often."""
    return lap_joint.deck((END, "  2.00e-02"))


class Hostile(CommandTest):
    def start(self, *arguments, **options):
        run = subprocess.Popen([NUGGET, *map(str, arguments)], cwd=self.folder, text=True, stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, **options)
        self.addCleanup(run.wait)
        self.addCleanup(run.kill)
        return run

    def wait_for(self, name):
        for _ in range(500):
            if (self.folder / name).exists() and (self.folder / name).stat().st_size > 0:
                return
            time.sleep(0.01)
        self.fail(f"{name} was not written")

    def test_a_limit_of_file_sizes(self):
        self.write(lap_joint.deck())
        run = self.start("run", "model.k", "--quiet", "-o", "out",
                         preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096)))
        error = run.communicate(timeout=60)[1]
        self.assertEqual(run.returncode, 4, error)
        self.assertRegex(error, r"cannot write out/\S+: File too large")

    def test_streams_that_are_closed_or_full(self):
        self.write(lap_joint.deck())
        for redirection, code, told in (("2>&-", 4, ""), (">&-", 4, ""), ("2>/dev/full", 4, ""), (">/dev/full", 4, ""),
                                        (">&- 2>&-", 4, ""), ("2>&1 | head -c 1 > seen", 0, "")):
            with self.subTest(redirection):
                command = f"set -o pipefail; {NUGGET} run model.k -o out {redirection}"
                run = subprocess.run(["bash", "-c", command], cwd=self.folder, capture_output=True, text=True, timeout=60)
                self.assertEqual(run.returncode, code, run.stderr)
                self.assertEqual(self.json("out/summary.json")["termination"], "normal")
        run = subprocess.run(f"{NUGGET} run model.k --quiet -o out > /dev/full", shell=True, cwd=self.folder,
                             capture_output=True, text=True, timeout=60)
        self.assertIn("cannot write to standard output: No space left on device", run.stderr)

    def test_signals_of_batch_systems(self):
        self.write(long_deck())
        for number in (signal.SIGHUP, signal.SIGXCPU, signal.SIGUSR1, signal.SIGTERM):
            with self.subTest(number.name):
                folder = number.name
                run = self.start("run", "model.k", "--quiet", "-o", folder)
                self.wait_for(f"{folder}/glstat")
                run.send_signal(number)
                error = run.communicate(timeout=60)[1]
                self.assertEqual(run.returncode, 130, error)
                self.assertIn(f"interrupted by {number.name}", error)
                self.assertTrue((self.folder / folder / "restart").exists())

    def test_stop_after(self):
        self.write(lap_joint.deck((END, "  2.00e+02")))
        run = self.nugget("run", "model.k", "--quiet", "--stop-after", "0.5s", "-o", "out", expect=130)
        self.assertIn("interrupted by --stop-after at time", run.stderr)
        self.assertTrue((self.folder / "out/restart").exists())
        run = self.nugget("run", "model.k", "--stop-after", "soon", expect=2)
        self.assertIn("'soon', expected a time of the clock such as 55min, 90s or 2h", run.stderr)

    def test_a_result_that_is_removed(self):
        self.write(long_deck())
        run = self.start("run", "model.k", "--quiet", "-o", "out")
        self.wait_for("out/glstat")
        (self.folder / "out/glstat").unlink()
        error = run.communicate(timeout=60)[1]
        self.assertEqual(run.returncode, 4, error)
        self.assertIn("cannot write out/glstat: the file was removed while the run wrote to it", error)

    def test_drafts_do_not_follow_links(self):
        self.write(lap_joint.deck())
        self.write("mine", "precious")
        (self.folder / "out").mkdir()
        for name in ("summary.json.part", "report.html.part", "restart.part", "run.log.part"):
            (self.folder / "out" / name).symlink_to("../precious")
        self.nugget("run", "model.k", "--quiet", "--checkpoint", "20cycles", "-o", "out")
        self.assertEqual(self.read("precious"), "mine")

    def test_an_end_in_the_past(self):
        self.write(lap_joint.deck())
        self.nugget("run", "model.k", "--quiet", "--checkpoint", "40cycles", "-o", "out")
        before = self.read("out/glstat")
        run = self.nugget("run", "--resume", "out", "--until", "1e-6", expect=1)
        self.assertIn("--until 1e-06 lies before the restart file", run.stderr)
        self.assertEqual(self.read("out/glstat"), before)

    def test_a_restart_file_of_another_build(self):
        self.write(lap_joint.deck())
        self.nugget("run", "model.k", "--quiet", "--checkpoint", "20cycles", "-o", "out")
        self.assertTrue((self.folder / "out/restart.previous").exists())
        other = self.folder / "other"
        other.write_bytes(pathlib.Path(NUGGET).read_bytes() + b"\0")
        other.chmod(0o755)
        run = subprocess.run([other, "run", "--resume", "out"], cwd=self.folder, capture_output=True, text=True, timeout=60)
        self.assertEqual(run.returncode, 1, run.stderr)
        self.assertRegex(run.stderr, r"out/restart: it was written by another build")


class EdgesOfNumbers(CommandTest):
    """Each number of the lap joint's cards, one after the other."""

    def outcome(self, text, what):
        self.write(text)
        run = subprocess.run([NUGGET, "run", "model.k", "--quiet", "--max-cycles", "60", "-o", "out"], cwd=self.folder,
                             capture_output=True, text=True, timeout=60)
        self.assertIn(run.returncode, (0, 1, 3), f"{what}\n{run.stderr}")
        if run.returncode == 1:
            self.assertRegex(run.stderr, r"model\.k(:\d+)*: error: ", what)
        elif run.returncode == 0:
            energy = self.json("out/summary.json")["energy"]
            self.assertNotIn(None, energy.values(), what)
        return run

    def test_each_number_of_the_cards(self):
        text = lap_joint.deck()
        cards = text[:text.index("*NODE")]
        numbers = [m for m in re.finditer(r"(?m)(?<=[ \n])-?\d+\.?\d*(?:e[+-]?\d+)?(?= |$)", cards)
                   if not cards[:m.start()].rpartition("\n")[2].startswith(("*", "$"))]
        self.assertGreater(len(numbers), 60)
        for match in numbers:
            for value in ("1e-320", "1e300", "-1", "-1e300", "1e-300"):
                width = max(10, len(value))
                start = max(0, match.end() - 10)
                if "\n" in cards[start:match.end()]:
                    start = cards.rindex("\n", 0, match.end()) + 1
                changed = text[:start] + value.rjust(match.end() - start) + text[match.end():]
                if len(value) > match.end() - start:
                    continue
                line = text[:match.start()].count("\n") + 1
                run = self.outcome(changed, f"line {line}: {match[0]} -> {value}")
                if value == "1e-320":
                    self.assertEqual(run.returncode, 1, f"line {line}: {match[0]} -> {value}")

    def refusals(self, *changes):
        """The errors of the lap joint with the changes made."""
        self.write(lap_joint.deck(*changes))
        run = self.nugget("check", "model.k", expect=1)
        return [line for line in run.stderr.splitlines() if ": error: " in line]

    def test_as_many_layers_as_no_memory_holds(self):
        extent = "*DATABASE_EXTENT_BINARY\n         0         0  99999999\n"
        errors = self.refusals(("*PART\nlower", extent + "*PART\nlower"))
        self.assertEqual(len(errors), 1, errors)
        self.assertRegex(errors[0], r"model\.k:\d+:\d+: error: \*DATABASE_EXTENT_BINARY maxint = 99999999: expected -1000 to 1000")

    def test_more_frequencies_than_can_be_computed(self):
        request = ("*FREQUENCY_DOMAIN_FRF\n       216         0         3         3\n      0.02\n"
                   "       216         0         3         2\n       1.0     300.0  99999999\n")
        errors = self.refusals(("*PART\nlower", request + "*PART\nlower"))
        self.assertRegex(errors[0], r"model\.k:\d+:\d+: error: \*FREQUENCY_DOMAIN_FRF nfreq = 99999999: expected 1 to 1000000")

    def test_an_end_time_of_zero_has_its_place(self):
        errors = self.refusals((END, "       0.0"))
        self.assertEqual(len(errors), 1, errors)
        self.assertIn("model.k:5:8: error: *CONTROL_TERMINATION: no end time is given", errors[0])

    def test_an_end_time_that_is_no_number_is_refused_once(self):
        """Sabotage: that none is given, which is not so, beside it."""
        errors = self.refusals((END, "  x.00e-04"))
        self.assertEqual(len(errors), 1, errors)
        self.assertIn("*CONTROL_TERMINATION endtim = x.00e-04: is not a number", errors[0])

    def test_a_tie_that_begins_later_is_told_beside_the_step(self):
        """Both at once, each with its field; the tie was told when all else was mended."""
        errors = self.refusals(("       0.0       0.9\n", "       0.0       0.9         0    1.0e-7\n"),
                               ("         3         1         3         2\n       0.0\n",
                                "         3         1         3         2\n" + "       0.0" * 6 + "    1.0e-5\n"))
        self.assertEqual(len(errors), 2, errors)
        self.assertIn("*CONTROL_TIMESTEP tslimt = 1.0e-7: ", errors[0])
        self.assertIn("*CONTACT_SPOTWELD bt = 1.0e-5: a tie of rotations that begins later is not built", errors[1])


if __name__ == "__main__":
    unittest.main()
