# SPDX-License-Identifier: Apache-2.0
"""A whole vehicle, set up as public models are: welds placed into its body, wheels that roll, walls that take its momentum."""
import csv
import re
import subprocess
import sys
import unittest

import lsda
from nugget_command import SOURCE, CommandTest

SPEED = 15646.4


class Vehicle(CommandTest):
    def setUp(self):
        super().setUp()
        subprocess.run([sys.executable, str(SOURCE / "examples" / "vehicle" / "make.py"), str(self.folder)], check=True)
        self.nugget("weld", "points.csv", "sheets.k", "-o", "welded.k", "--material", "nrr=9000,nrs=7000,nrt=7000")

    def test_it_rolls_into_the_wall(self):
        """At the start wheels roll: what touches the ground stands still. Sabotage: spins the other way round. Walls take what the car's momentum loses;
        gravity has no part along x. Sabotage: a part that does not move, a wall beside the car."""
        text = self.read("run.key")
        for name, interval in (("RWFORC", "1e-6"), ("GLSTAT", "8e-4"), ("NODOUT", "1e-5")):
            text, count = re.subn(rf"(\*DATABASE_{name}\n(?:\$.*\n)*).*\n", rf"\g<1>{interval},2\n", text)
            self.assertEqual(count, 1)
        self.write(text, "run.key")
        self.nugget("run", "run.key", "-o", "run", "-j", 2, "--until", "1.6e-3", "--quiet")
        summary = self.json("run/summary.json")
        self.assertEqual((summary["welds"], summary["weld"][0]["failed"]), (1541, False))
        self.assertAlmostEqual(summary["energy"]["ratio"], 1.0, delta=2e-4)
        self.assertFalse([f["text"] for f in self.json("run/findings.json") if f["severity"] == "error"])

        # Of many welds those that are far from failing are drawn small, and not behind sheets. Sabotage: one size for all.
        self.nugget("picture", "run", "-o", "car.svg", "--view=-0.7,0.7,-0.35", "--up", "z")
        welds = re.findall(r'r="([\d.]+)" fill="([^"]+)" stroke="[^"]+" stroke-width="[\d.]+"><title>weld (\d+)', (self.folder / "car.svg").read_text())
        with open(self.folder / "run" / "welds.csv") as file:
            rows = list(csv.DictReader(file))
        value = {int(w["id"]): float(w["peak_failure"]) for w in rows}
        early = {int(w["id"]) for w in rows if float(w["peak_failure_time"]) < 1.5e-3}  # before the state that is drawn
        for radius, fill, weld in welds:
            if int(weld) in early:
                self.assertEqual(float(radius) < 3.0, value[int(weld)] < 0.5 and fill != "none", weld)
        self.assertTrue(200 < len(welds) < 1541)
        self.assertTrue({int(w) for _, _, w in welds} >= {w for w in early if value[w] >= 0.5})
        # Those of parts that are left out are not drawn. Sabotage: all of them.
        self.nugget("picture", "run", "-o", "rails.svg", "--part", "101,104")
        welds = {int(w) for w in re.findall(r"<title>weld (\d+)", self.read("rails.svg"))}
        self.assertTrue(welds and welds <= {int(w["id"]) for w in rows if "101" in (w["sheet1"], w["sheet2"])})

        start = self.d3plot("run")["states"][0]
        ground, speeds = 0, []
        for block in start["blocks"]:
            velocities = block["point_arrays"]["Velocity"]
            speeds += [v[0] for v in velocities]
            for (x, _, z), v in zip(block["points"], velocities):
                if z < 1.001 and x > -900.0:
                    ground += 1
                    self.assertLess(abs(v[0]), 1e-3 * SPEED)
        self.assertGreaterEqual(ground, 4 * 5)
        self.assertAlmostEqual(min(speeds), -2.0 * SPEED, delta=0.01 * SPEED)  # the tops of the wheels

        files = lsda.read(self.folder / "run" / "binout0000")
        speed = [state["global_x_velocity"][0] for state in lsda.states(files, "glstat")]
        mass = summary["mass"]["physical"] + summary["mass"]["added"]
        self.assertAlmostEqual(speed[0], -SPEED, delta=1e-3 * SPEED)
        forces = lsda.states(files, "rwforc/forces")
        times = [state["time"][0] for state in forces]
        pushed = [sum(state["x_force"]) for state in forces]
        impulse = sum(0.5 * (b - a) * (f + g) for a, b, f, g in zip(times, times[1:], pushed, pushed[1:]))
        self.assertGreater(impulse, 0.005 * mass * SPEED)
        self.assertAlmostEqual(mass * (speed[-1] - speed[0]), impulse, delta=0.02 * impulse)


if __name__ == "__main__":
    unittest.main()
