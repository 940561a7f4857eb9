# SPDX-License-Identifier: Apache-2.0
"""report.html in a headless Chromium, without a network: web/drive.mjs turns it, plays it, clicks welds, sorts and saves tables,
follows links. Skipped where Node, its packages or Chromium are missing."""
import json
import shutil
import subprocess
import unittest

import damaged
from lap_joint import deck
from nugget_command import CommandTest, SOURCE
from test_mode_studies import strips
from test_responses import fields, frf, strip


class InBrowser(CommandTest):
    def drive(self, kind, folder="."):
        node = shutil.which("node")
        if not node or not (SOURCE / "web" / "node_modules" / "playwright-core").exists():
            self.skipTest("no Node, or no packages in web/ (./dev setup)")
        page = "compare.html" if kind.startswith("compare") else "report.html"
        if 'id="run-data"' not in self.read(f"{folder}/{page}"):
            self.skipTest("this program was built without the viewer")
        run = subprocess.run([node, SOURCE / "web" / "drive.mjs", kind, self.folder / folder], capture_output=True, text=True, timeout=240)
        if run.returncode == 77:
            self.skipTest(run.stderr.strip())
        self.assertEqual(run.returncode, 0, run.stderr)
        return json.loads(run.stdout)

    def test_a_run(self):
        self.write(deck())
        self.nugget("run", "model.k", "--quiet")
        self.assertGreater(self.drive("impact")["colours"], 20)

    def test_damage_of_elements_and_of_welds(self):
        for text, value in ((damaged.sheets(), None), (damaged.weld(), "damage")):
            self.write(text)
            self.nugget("run", "model.k", "--quiet")
            found = self.drive("damage")
            self.assertIn("damage", found["fields"])
            self.assertEqual(found["weld"], value)
        self.write(deck())
        self.nugget("run", "model.k", "--quiet")
        self.assertNotIn("damage", self.drive("damage")["fields"])

    def test_a_run_without_webgl(self):
        self.write(deck())
        self.nugget("run", "model.k", "--quiet")
        self.drive("without_webgl")

    def test_modes_of_welded_strips(self):
        self.write(strips())
        self.nugget("modes", "model.k", "-n", 12, "--quiet")
        self.drive("modes")

    def test_a_frequency_response(self):
        self.write(strip(lambda tip: "*CONTROL_IMPLICIT_EIGENVALUE\n" + fields(5) +
                         frf((tip, 0, 3, 3), (0.02,), (tip, 0, 3, 2), (0.0, 300.0, 100)), 20, 2))
        self.nugget("frf", "model.k", "--quiet")
        self.drive("responses")

    def test_a_frequency_response_that_begins_anywhere(self):
        for low in (0.01, 13.7):
            self.write(strip(lambda tip: "*CONTROL_IMPLICIT_EIGENVALUE\n" + fields(5) +
                             frf((tip, 0, 3, 3), (0.02,), (tip, 0, 3, 2), (low, 300.0, 100)), 20, 2))  # pylint: disable=cell-var-from-loop
            self.nugget("frf", "model.k", "--quiet")
            self.drive("responses")

    def test_two_runs(self):
        self.write(deck())
        self.nugget("run", "model.k", "-o", "a", "--quiet")
        self.write(deck().replace("    8000.0    6000.0    6000.0", "      80.0      60.0      60.0"))
        self.nugget("run", "model.k", "-o", "b", "--quiet")
        self.nugget("report", "a", "b")
        self.assertGreater(self.drive("compare", "a")["welds"], 1)

    def test_modes_of_two_runs_are_paired(self):
        """The same strips, stiffer: each mode is most like itself."""
        self.write(strips())
        self.nugget("modes", "model.k", "-n", 10, "-o", "a", "--quiet")
        self.write(strips().replace("210000.0", "240000.0"))
        self.nugget("modes", "model.k", "-n", 10, "-o", "b", "--quiet")
        self.nugget("report", "a", "b")
        elastic = [(a, b, mac) for a, b, mac in self.drive("compare_modes", "a")["pairs"] if a >= 6]
        self.assertEqual(len(elastic), 4)
        for a, b, mac in elastic:
            self.assertEqual(a, b)
            self.assertGreater(mac, 0.99)


if __name__ == "__main__":
    unittest.main()
