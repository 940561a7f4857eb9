# SPDX-License-Identifier: Apache-2.0
"""Each script of examples/python runs on a deck of examples, says something and leaves an SVG; what it says is so."""
import re
import subprocess
import sys
import unittest
import xml.etree.ElementTree as xml

from nugget_command import SOURCE, CommandTest

SCRIPTS = SOURCE / "examples" / "python"


class Gallery(CommandTest):
    @classmethod
    def setUpClass(cls):
        cls.seen = set()

    @classmethod
    def tearDownClass(cls):
        missing = {path.stem for path in SCRIPTS.glob("*.py")} - cls.seen
        if missing:
            raise AssertionError(f"no test runs {sorted(missing)}")

    def out(self, script, example="weld_placement", deck="centre"):
        """What the script prints."""
        self.seen.add(script)
        subprocess.run([sys.executable, SOURCE / "examples" / example / "make.py", self.folder / "decks"], check=True,
                       capture_output=True)
        (self.folder / "out").mkdir()
        ran = subprocess.run([sys.executable, SCRIPTS / f"{script}.py", self.folder / "decks" / f"{deck}.k",
                              self.folder / "out"], capture_output=True, text=True, timeout=250)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertEqual(xml.parse(self.folder / "out" / f"{script}.svg").getroot().tag,
                         "{http://www.w3.org/2000/svg}svg")
        return ran.stdout

    def numbers(self, text, pattern):
        return [float(number) for number in re.findall(pattern, text)]

    def test_audit(self):
        said = self.out("audit", "double_hat", "double_hat")
        self.assertEqual(len(self.numbers(said, r"weld \d+: d = (6.0)")), 40)

    def test_forces(self):
        force, = self.numbers(self.out("forces"), r"largest shear force (\d+) N")
        self.assertAlmostEqual(force / max(self.column("out/run/welds.csv", "peak_shear")), 1.0, 2)

    def column(self, name, column):
        return [float(word) for word in self.words(name, column)]

    def words(self, name, column):
        head, *rows = [line.split(",") for line in self.read(name).splitlines()]
        return [row[head.index(column)] for row in rows]

    def test_over_displacement(self):
        force, at = self.numbers(self.out("over_displacement"), r"(?:force|at) ([\d.]+)")
        self.assertAlmostEqual(force / max(self.column("out/run/welds.csv", "peak_shear")), 1.0, delta=0.1)
        self.assertGreater(at, 0.1)

    def test_stronger(self):
        before, after = self.numbers(self.out("stronger"), r"\[([\d.e-]+)\]")
        self.assertLess(after, before)

    def test_thickness(self):
        forces = self.numbers(self.out("thickness"), r"mm: (\d+) N")
        self.assertEqual((len(forces), sorted(forces)), (4, forces))

    def test_strengths(self):
        said = self.out("strengths", "peel", "peel")
        rows = [tuple(map(float, row)) for row in re.findall(r"^ +(\d+) +(\d+) +(\d+)$", said, re.M)]
        forces, failed = [row[1] for row in rows], [row[2] for row in rows]
        self.assertEqual((len(rows), sorted(forces), sorted(failed, reverse=True)), (5, forces, failed))
        self.assertEqual(failed[-1], sum(verdict == "yes" for verdict in self.words("out/moment7000/welds.csv", "failed")))
        self.assertLess(failed[-1], failed[0])

    def test_missing_weld(self):
        said = self.out("missing_weld", "weld_bond", "modes/hat_welded")
        whole, less = self.numbers(said, r": +([\d.]+) Hz,"), self.numbers(said, r"([\d.]+) Hz without")
        self.assertEqual(len(whole), 10)
        self.assertTrue(all(b <= a + 0.1 for a, b in zip(whole, less)), (whole, less))
        self.assertLess(sum(less), sum(whole))

    def test_place(self):
        self.assertEqual(sorted(re.findall(r"at y = ([-\d.]+), tied: (\w+)", self.out("place"))),
                         [("-8.0", "True"), ("8.0", "True")])

    def test_first_failure(self):
        said = self.out("first_failure")
        self.assertIn("normal termination; failed: [", said)

    def test_states(self):
        self.assertRegex(self.out("states"), r"most plastic strain 0\.\d+ in shell \d+ of part [12]; ")

    def test_shapes(self):
        said = self.out("shapes")
        frequencies = self.numbers(said, r"([\d.]+) Hz")
        self.assertEqual((len(frequencies), sorted(frequencies)), (6, frequencies))


if __name__ == "__main__":
    unittest.main()
