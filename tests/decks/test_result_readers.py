# SPDX-License-Identifier: Apache-2.0
"""What VTK's vtkLSDynaReader (the reader of ParaView) sees of a run, against the deck and against the ASCII histories."""
import re
import subprocess
import sys
import unittest

from lap_joint import deck
from nugget_command import SOURCE, CommandTest


class ResultReaders(CommandTest):
    def nodout(self):
        """{time: {node: (displacement, coordinates)}}"""
        states, now = {}, None
        for line in self.read("nodout").splitlines():
            cells = line.split()
            if head := re.search(r"at time\s+(\S+)\s*\)", line):
                now = states.setdefault(float(head[1]), {})
            elif len(cells) == 13 and cells[0].isdigit():
                numbers = [float(c) for c in cells[1:]]
                now[int(cells[0])] = (numbers[:3], numbers[9:])
        return states

    def blocks(self, seen, index):
        return {block["name"]: block for block in seen["states"][index]["blocks"]}

    def at_nodout(self, seen):
        """Compares each node of nodout, to its five digits, at each time that both files have; returns how many that were.
        VTK 9.1 packs two node ids into one number, so a node is known by where it stood at the start."""
        compared = 0
        histories = self.nodout()
        starts = {node: place for node, (_, place) in histories[0.0].items()}
        for state in seen["states"]:
            for time, nodes in histories.items():
                if abs(time - state["time"]) > 1e-6 * max(time, 1e-30):
                    continue
                for node, (displacement, place) in nodes.items():
                    found = [(block["point_arrays"]["Deflected Coordinates"][i], block["point_arrays"]["Deflection"][i])
                             for block in state["blocks"] for i, x in enumerate(block["points"])
                             if max(abs(a - b) for a, b in zip(x, starts[node])) < 1e-3]
                    self.assertTrue(found, f"node {node} is in no part")
                    compared += 1
                    for seen_place, moved in found:
                        for a, b in zip((*seen_place, *moved), (*place, *displacement)):
                            self.assertAlmostEqual(a, b, delta=5.1e-5 * abs(b) + 1e-4)
        return compared

    def test_double_hat(self):
        make = SOURCE / "examples" / "double_hat" / "make.py"
        subprocess.run([sys.executable, str(make), str(self.folder)], check=True)
        self.nugget("run", "double_hat.k", "--max-cycles", 200, "--quiet")
        seen = self.d3plot()
        self.assertEqual((seen["nodes"], seen["shells"], seen["beams"], seen["solids"]), (9975, 9536, 40, 0))
        self.assertEqual(seen["parts"], ["upper hat", "lower hat", "sled", "spot welds"])
        times = [state["time"] for state in seen["states"]]
        self.assertEqual(len(times), 2)
        self.assertEqual(times[0], 0.0)
        self.assertAlmostEqual(times[1] / self.json("summary.json")["time"], 1.0, 6)
        start = self.blocks(seen, 0)
        self.assertEqual({name: len(block["cells"]) for name, block in start.items()},
                         {"upper hat": 4760, "lower hat": 4760, "sled": 16, "spot welds": 40})
        self.assertEqual([u for (u,) in start["spot welds"]["cell_arrays"]["UserIds"]], list(range(50001, 50041)))
        # Coordinates and element corners as they stand in the deck.
        text = self.read("double_hat.k")
        nodes = {int(m[1]): [float(m[i]) for i in (2, 3, 4)]
                 for m in re.finditer(r"(?m)^ *(\d+) +(-?\d+\.\d+) +(-?\d+\.\d+) +(-?\d+\.\d+)$", text)}
        shells = {int(line[:8]): [int(line[i : i + 8]) for i in range(16, 48, 8)]
                  for line in text.split("*ELEMENT_SHELL\n")[1].split("*")[0].splitlines() if not line.startswith("$")}
        self.assertEqual((len(nodes), len(shells)), (9975, 9536))
        compared = 0
        for block in start.values():
            for (user,), cell in zip(block["cell_arrays"]["UserIds"], block["cells"]):
                for point, node in zip(cell, shells.get(user, [])):
                    compared += 1
                    for a, b in zip(block["points"][point], nodes[node]):
                        self.assertAlmostEqual(a, b, delta=1e-4)
        self.assertEqual(compared, 4 * 9536)
        self.assertGreaterEqual(self.at_nodout(seen), 4)

    def test_lap_joint_whose_weld_fails(self):
        self.write(deck(("    8000.0    6000.0    6000.0", "    8000.0    1000.0    1000.0")))
        self.nugget("run", "model.k", "--quiet")
        failure = self.json("summary.json")["weld"][0]["failure_time"]
        seen = self.d3plot()
        self.assertEqual(seen["title"], "lap joint of two sheets and one weld")
        self.assertEqual((seen["nodes"], seen["shells"], seen["beams"]), (34, 18, 1))
        self.assertEqual(len(seen["states"]), 5)
        alive_and_dead = set()
        for state in seen["states"]:
            for block in state["blocks"]:
                dead = block["name"] == "weld" and state["time"] > failure
                alive_and_dead.add((block["name"], dead))
                self.assertEqual({d for (d,) in block["cell_arrays"]["vtkGhostType"]}, {float(dead)})
        self.assertIn(("weld", False), alive_and_dead)
        self.assertIn(("weld", True), alive_and_dead)
        self.assertEqual(self.at_nodout(seen), 5)

    def test_single_hex(self):
        self.nugget("run", self.shared("decks/single_hex/single_hex_tension.k"), "--quiet")
        seen = self.d3plot()
        self.assertEqual((seen["nodes"], seen["solids"], seen["parts"]), (8, 1, ["Single hex part"]))
        self.assertEqual(len(seen["states"]), 11)  # LS-DYNA's d3plot beside the deck has 11 too
        for k, state in enumerate(seen["states"]):
            self.assertAlmostEqual(state["time"], 0.1 * k, delta=2e-4)
            (block,) = state["blocks"]
            self.assertEqual(block["cells"], [[0, 1, 2, 3, 4, 5, 6, 7]])
            self.assertEqual(block["points"][6], [1.0, 1.0, 1.0])
        # At the end the static answer, F L / (E A) = 0.01 / 210, on all four loaded nodes.
        for node in (4, 5, 6, 7):
            self.assertAlmostEqual(block["point_arrays"]["Deflection"][node][2] / (0.01 / 210.0), 1.0, 2)


if __name__ == "__main__":
    unittest.main()
