# SPDX-License-Identifier: Apache-2.0
"""What the tests of installation share: the build, a temporary prefix, the program in it, away from its build and its user."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
SOURCE = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ["NUGGET_BUILD"])
CMAKE = os.environ["NUGGET_CMAKE"]

# A sheet of three shells.
SHELLS = """*KEYWORD
*NODE
       1             0.0             0.0             0.0
       2            10.0             0.0             0.0
       3            10.0            10.0             0.0
       4             0.0            10.0             0.0
       5            20.0             0.0             0.0
       6            20.0            10.0             0.0
       7            30.0             0.0             0.0
       8            30.0            10.0             0.0
*ELEMENT_SHELL
       1       1       1       2       3       4
       2       1       2       5       6       3
       3       1       5       7       8       6
*PART
sheet
         1         1         1
*SECTION_SHELL
         1         2
       1.0       1.0       1.0       1.0
*MAT_ELASTIC
         1   7.85e-9     210e3       0.3
*CONTROL_TERMINATION
    1.0e-6
*END
"""


def call(*command, expect=0, **options):
    run = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=500, **options)
    if run.returncode != expect:
        raise AssertionError(f"{command}: code {run.returncode}, expected {expect}\n{run.stdout}\n{run.stderr}")
    return run


class InstallTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "work").mkdir()

    def bare(self, program, *arguments, expect=0):
        """Runs a program with no environment at all, in an empty folder."""
        return call("env", "-i", program, *arguments, expect=expect, cwd=self.folder / "work")

    def looks_installed(self, usr):
        """The files that a prefix must have, but for those that Debian has elsewhere; and the program knows its version."""
        for name in ("bin/nugget", "bin/nugget-mpi", "share/man/man1/nugget.1.gz", "share/man/man1/nugget-run.1.gz",
                     "share/man/man1/nugget-mpi.1.gz", "share/bash-completion/completions/nugget", "include/nugget/model/nugget_weld_law.h",
                     "share/nugget/examples/double_hat/make.py", "share/nugget/examples/double_hat/double_hat.k"):
            self.assertTrue((usr / name).is_file(), name)
        for name in ("nugget-avx512", "nugget-mpi-avx512"):
            self.assertEqual((usr / "bin" / name).exists(), (BUILD / name).exists())
        self.assertEqual([path.name for path in usr.rglob("*") if path.name.startswith(("test_", "__pycache__"))], [])
        self.assertRegex(self.bare(usr / "bin/nugget", "--version").stdout, r"^nugget \d+\.\d+\.\d+\n$")
        self.assertEqual(self.bare(usr / "bin/nugget", "--completion", "bash").stdout,
                         (usr / "share/bash-completion/completions/nugget").read_text())

    def module_runs(self, usr):
        """The module of Python from a prefix: a run, and its resumption by the program."""
        if not (BUILD / "python" / "nugget").is_dir():
            self.skipTest("the module of Python is not built")
        (self.folder / "work" / "sheet.k").write_text(SHELLS)
        script = ("import sys; sys.dont_write_bytecode = True; import nugget; "
                  "r = nugget.run('sheet.k', directory='out', checkpoint='1cycles', until=1e-4, max_cycles=3); print(r.summary['cycles'])")
        run = call("env", "-i", f"PYTHONPATH={usr / 'lib/python3/dist-packages'}", "/usr/bin/python3", "-c", script, cwd=self.folder / "work")
        self.assertEqual(run.stdout.split(), ["3"])
        self.bare(usr / "bin/nugget", "run", "--resume", "out", "--max-cycles", "5")
        self.assertIn('"cycles": 5', (self.folder / "work" / "out" / "summary.json").read_text())

    def demo_runs(self, usr, folder):
        """`nugget demo` from a prefix, with its deck made to end after some 30 cycles."""
        deck = usr / "share/nugget/examples/double_hat/double_hat.k"
        text = deck.read_text()
        lines = text.splitlines()
        lines[lines.index("*CONTROL_TERMINATION") + 1:] = self.short_end(lines)
        deck.write_text("\n".join(lines) + "\n")
        run = self.bare(usr / "bin/nugget", "demo", "-o", folder)
        self.assertIn(f"nugget run {deck}", run.stderr)
        self.assertIn(f"results in {self.folder / 'work' / folder}\n", run.stdout)
        named = [line.split()[0] for line in run.stdout.split("results in")[1].splitlines()[1:]]
        self.assertEqual(named, ["report.html", "welds.csv", "d3plot", "run.log"])
        for name in named:
            self.assertTrue((self.folder / "work" / folder / name).is_file(), name)
        self.assertEqual(len((self.folder / "work" / folder / "welds.csv").read_text().splitlines()), 41)

    @staticmethod
    def short_end(lines):
        """The lines from the end time on, with an end after about 30 cycles."""
        rest = lines[lines.index("*CONTROL_TERMINATION") + 1:]
        number = next(i for i, line in enumerate(rest) if not line.startswith("$"))
        return [*rest[:number], "    2.0e-5", *rest[number + 1:]]
