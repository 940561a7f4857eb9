# SPDX-License-Identifier: Apache-2.0
"""nugget.run(): the command in the process of Python. The same bytes, the same ends."""
import os
import signal
import subprocess
import sys
import threading
import unittest

import nugget
from lap_joint import deck
from repeated_runs import RepeatedRuns

LONG = ("  2.00e-05", "  1.00e-02")
PULLED_APART = ("               500.0\n             1.0e-01               500.0", "               1e7\n             1.0e-01                 1e7")


class Runs(RepeatedRuns):
    def setUp(self):
        super().setUp()
        before = os.getcwd()
        os.chdir(self.folder)
        self.addCleanup(os.chdir, before)

    def test_same_bytes_as_the_command(self):
        self.write(deck())
        self.nugget("run", "model.k", "-o", "command", "-j", 2, "--quiet")
        result = nugget.run("model.k", directory="module", threads=2)
        self.assertEqual(result.termination, "normal")
        self.same("module", "command")
        again = nugget.run(nugget.read("model.k"), directory="again", threads=1)
        self.same("again", "command")
        self.assertEqual(again.welds["peak_shear"].tolist(), result.welds["peak_shear"].tolist())

    def test_single_precision(self):
        self.write(deck())
        self.nugget("run", "model.k", "-o", "command", "-j", 2, "--quiet", "--precision", "single")
        result = nugget.run("model.k", directory="module", threads=2, precision="single")
        self.assertEqual(result.summary["elements_by_precision"], {"single": 18, "double": 1})
        self.same("module", "command")
        with self.assertRaisesRegex(ValueError, "precision 'half', expected single or double"):
            nugget.run("model.k", directory="never", precision="half")

    def test_progress_is_told(self):
        self.write(deck())
        told = []
        result = nugget.run("model.k", directory="out", progress=lambda *numbers: told.append(numbers))
        self.assertGreaterEqual(len(told), 2)
        self.assertEqual(told[0][:3], (0.0, 2e-5, 0))
        time, end, cycle, ratio, failed = told[-1]
        self.assertEqual((time, cycle, failed), (result.summary["time"], result.summary["cycles"], 0))
        self.assertAlmostEqual(ratio, result.summary["energy"]["ratio"], 6)

    def test_stopped_and_resumed(self):
        """As one that ran through."""
        self.write(deck())
        whole = nugget.run("model.k", directory="whole")
        cut = nugget.run("model.k", directory="cut", progress=lambda *_: False)
        self.assertEqual(cut.termination, "interrupted")
        self.assertRegex(cut.summary["message"], "interrupted by its caller at time .*, cycle 1;")
        self.assertIn("restart", self.files("cut"))
        on = nugget.resume("cut")
        self.assertEqual((on.termination, on.summary["cycles"]), ("normal", whole.summary["cycles"]))
        self.same("cut", "whole")
        # The command goes on where the module has stopped, and the other way round.
        nugget.run("model.k", directory="cut", progress=lambda *_: False)
        self.nugget("run", "--resume", "cut", "--quiet")
        self.same("cut", "whole")
        self.nugget("run", "model.k", "-o", "cut", "--quiet", "--checkpoint", "20cycles", "--max-cycles", 30)
        self.assertEqual(nugget.resume("cut", max_cycles=10 ** 9).termination, "normal")
        self.same("cut", "whole")
        # False at the end of a run is none for the next one.
        nugget.run("model.k", directory="out", progress=lambda time, end, *_: time < end)
        self.assertEqual(nugget.run("model.k", directory="out").termination, "normal")

    def test_exception_of_the_callback(self):
        self.write(deck(LONG))

        def fail(*_):
            raise ZeroDivisionError("of the callback")
        with self.assertRaisesRegex(ZeroDivisionError, "of the callback"):
            nugget.run("model.k", directory="out", progress=fail)
        self.assertEqual(nugget.results("out").termination, "interrupted")

    def test_ctrl_c(self):
        self.write(deck(LONG))
        handler = signal.getsignal(signal.SIGINT)
        with self.assertRaisesRegex(KeyboardInterrupt, "interrupted by the user"):
            nugget.run("model.k", directory="out", progress=lambda *_: os.kill(os.getpid(), signal.SIGINT))
        self.assertIn("restart", self.files("out"))
        self.assertEqual(signal.getsignal(signal.SIGINT), handler)
        with self.assertRaises(KeyboardInterrupt):  # the handler of Python is back
            signal.raise_signal(signal.SIGINT)

    def test_other_threads_go_on(self):
        self.write(deck(LONG))
        counted, stop = [0], threading.Event()

        def count():
            while not stop.wait(1e-3):
                counted[0] += 1
        counter = threading.Thread(target=count)
        counter.start()
        seen = []
        nugget.run("model.k", directory="out", max_cycles=20000, threads=1, progress=lambda *_: seen.append(counted[0]))
        stop.set()
        counter.join()
        self.assertGreater(seen[-1] - seen[0], 10)

    def test_ends(self):
        self.write(deck())
        self.assertEqual(nugget.run("model.k", directory="out", max_cycles=7).summary["cycles"], 7)
        self.assertAlmostEqual(nugget.run("model.k", directory="out", until=1e-5).summary["time"], 1e-5, 7)
        for wrong, text in (({"until": -1.0}, "until = -1.0, expected more than 0"), ({"threads": -2}, "threads = -2"),
                            ({"checkpoint": "often"}, "checkpoint 'often', expected e.g. 500cycles")):
            with self.assertRaisesRegex(ValueError, text):
                nugget.run("model.k", directory="out", **wrong)

    def test_refused_deck(self):
        self.write(deck(("       0.3     300.0", "       0.7     300.0")))
        printed = self.nugget("run", "model.k", "-o", "command", "--quiet", expect=1).stderr
        with self.assertRaises(nugget.DeckError) as raised:
            nugget.run("model.k", directory="out")
        self.assertEqual(str(raised.exception), printed.rstrip("\n"))
        self.assertEqual([f.field for f in raised.exception.findings if f.severity == "error"], ["pr"])
        with self.assertRaisesRegex(nugget.DeckError, "nowhere.k"):
            nugget.run("nowhere.k", directory="out")
        with self.assertRaisesRegex(nugget.RunError, "restart"):
            nugget.resume("out")

    def test_error_termination(self):
        self.write(deck(LONG, PULLED_APART))
        code = self.nugget("run", "model.k", "-o", "command", "--quiet", expect=3)
        with self.assertRaises(nugget.RunError) as raised:
            nugget.run("model.k", directory="out")
        self.assertIn(str(raised.exception), code.stderr)
        self.assertEqual(nugget.results(raised.exception.directory).termination, "error")

    def test_folder_that_cannot_be_made(self):
        self.write(deck())
        self.write("a file", "taken")
        with self.assertRaisesRegex(OSError, "cannot write taken"):
            nugget.run("model.k", directory="taken")

    def test_nothing_on_the_terminal(self):
        self.write(deck())
        script = "import nugget; nugget.run('model.k', directory='out'); print('mine')"
        ran = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
        self.assertEqual((ran.stdout, ran.stderr), ("mine\n", ""))


if __name__ == "__main__":
    unittest.main()
