# SPDX-License-Identifier: Apache-2.0
"""What the tests of the command share: a folder of their own, the program, its findings, its tables."""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
NUGGET = os.environ["NUGGET"]
SOURCE = pathlib.Path(__file__).resolve().parents[2]
SHARED = SOURCE.parent / "shared"


def line_of(finding):
    """A finding of findings.json as the line that standard error shows."""
    place = finding["file"]
    for number in ("line", "column"):
        if finding[number]:
            place += f":{finding[number]}"
    about = finding["keyword"]
    if finding["field"]:
        about += f"{' ' if about else ''}{finding['field']} = {finding['value'] or '(blank)'}"
    remedy = f" [{finding['remedy']}]" if finding["remedy"] else ""
    return f"{place}: {finding['severity']}: {about + ': ' if about else ''}{finding['text']}{remedy}"


class CommandTest(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, text, name="model.k"):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="latin-1")
        return path

    def nugget(self, *arguments, expect=0, **options):
        """Runs the program in the test's folder and checks its exit code."""
        options.setdefault("cwd", self.folder)
        run = subprocess.run([NUGGET, *map(str, arguments)], capture_output=True, text=True, timeout=120, **options)
        self.assertEqual(run.returncode, expect, f"{arguments}\n{run.stderr}\n{run.stdout}")
        return run

    def shared(self, name):
        path = SHARED / name
        if not path.exists():
            self.skipTest(f"{path} is not there")
        return path

    def read(self, name):
        return (self.folder / name).read_text(encoding="utf-8")

    def json(self, name):
        return json.loads(self.read(name))

    def files(self, folder="."):
        return sorted(path.name for path in (self.folder / folder).iterdir())

    def glstat(self, name="glstat"):
        """[{label: value}]: the states of a glstat file."""
        states = []
        for line in self.read(name).splitlines():
            match = re.match(r" (time|[a-z/ ]+?)\.{2,}\s*(\S+)\s*$", line)
            if not match:
                continue
            if match[1] == "time":
                states.append({})
            states[-1][match[1].strip()] = float(match[2])
        return states

    def d3plot(self, folder="."):
        """The d3plot of a folder as VTK's reader sees it."""
        reader = SOURCE / "tests" / "unit" / "output" / "read_d3plot.py"
        run = subprocess.run([sys.executable, str(reader), str(self.folder / folder / "d3plot")], capture_output=True,
                             text=True, timeout=120)
        if run.returncode == 77:
            self.skipTest("this Python has no vtk")
        self.assertEqual(run.returncode, 0, run.stderr)
        seen = json.loads(run.stdout)
        self.assertEqual(seen["complaints"], [])
        return seen
