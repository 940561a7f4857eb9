# SPDX-License-Identifier: Apache-2.0
"""`nugget coverage FOLDER`: which decks of a folder are accepted, and what refuses the others."""
import unittest

from few_elements import BRICK, CORNERS, SOLID, card, nodes, part
from nugget_command import CommandTest

MESH = SOLID + "*MAT_ELASTIC\n" + card(1, 1.0, 10.0, 0.3) + part(1) + nodes(CORNERS) + BRICK
DECK = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(10.0) + "*INCLUDE\nmesh.inc\n{}*END\n"


class Coverage(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("*KEYWORD\n" + MESH, "decks/mesh.inc")
        self.write("$ comment\n\n" + DECK.format(""), "decks/good.k")
        self.write(DECK.format("*LOAD_WIND\n"), "decks/one.key")
        self.write(DECK.format("*LOAD_WIND\n*AIRBAG_PARTICLE\n"), "decks/two.dyn")
        self.write(DECK.format("").replace("mesh.inc", "nowhere.inc"), "decks/deep/er/broken.k")
        self.write("*KEYWORD\n*LOAD_WIND\n" + MESH, "decks/part.k")
        self.write("no deck\n", "decks/notes.txt")

    def test_table_and_json(self):
        run = self.nugget("coverage", "decks", "-o", "out")
        lines = run.stdout.splitlines()
        self.assertEqual([line.split()[:2] for line in lines[:5]],
                         [["deep/er/broken.k", "refused"], ["good.k", "accepted"], ["one.key", "refused"],
                          ["part.k", "no"], ["two.dyn", "refused"]])
        self.assertIn("*AIRBAG_PARTICLE, *LOAD_WIND", lines[4])
        self.assertEqual(lines[6], "5 decks: 1 accepted, 3 refused, 1 are no model")
        table = {line.rsplit(None, 2)[0]: line.split()[-2:] for line in lines[9:]}
        self.assertEqual(table["*LOAD_WIND"], ["2", "1"])
        self.assertEqual(table["*AIRBAG_PARTICLE"], ["1", "0"])
        self.assertEqual(table["*INCLUDE"], ["1", "1"])
        found = self.json("out/coverage.json")
        self.assertEqual([d["accepted"] for d in found["decks"]], [False, True, False, False, False])
        error = found["decks"][2]["errors"][0]
        self.assertEqual((error["keyword"], error["line"]), ("*LOAD_WIND", 6))
        self.assertTrue((self.folder / "out/good/check.log").exists())

    def test_runs_some_cycles(self):
        run = self.nugget("coverage", "decks", "--cycles", 3, "-o", "out")
        self.assertIn("5 decks: 1 run, 3 refused, 1 are no model", run.stdout)
        self.assertEqual(self.json("out/good/summary.json")["cycles"], 3)

    def test_a_folder_without_decks(self):
        self.write("no deck\n", "empty/notes.txt")
        self.assertIn("no file below empty begins with *KEYWORD", self.nugget("coverage", "empty", expect=2).stderr)
        self.assertIn("is no folder", self.nugget("coverage", "nowhere", expect=2).stderr)


if __name__ == "__main__":
    unittest.main()
