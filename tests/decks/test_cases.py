# SPDX-License-Identifier: Apache-2.0
"""*CASE: several analyses of one deck, each with results of its own."""
import unittest

from few_elements import BRICK, CORNERS, SOLID, card, nodes, part
from nugget_command import CommandTest

VELOCITY = "*INITIAL_VELOCITY_GENERATION\n" + card(1, 2, 0, "{}", 0, 0) + card("")
DECK = ("*KEYWORD\n*CONTROL_TERMINATION\n" + card(0.01) + SOLID + "*MAT_ELASTIC\n" + card(1, 1.0, 10.0, 0.3) + part(1)
        + nodes(CORNERS) + BRICK
        + "*CASE\n" + card(1)[:-1] + "slow\n\n" + card(10)
        + "*CASE\n" + card(2)[:-1] + "\nmemory=20m\n" + card(20)
        + "*CASE_BEGIN_10\n" + VELOCITY.format(1.0) + "*CASE_END_10\n"
        + "*CASE_BEGIN_20\n" + VELOCITY.format(3.0) + "*CASE_END_20\n*END\n")


class Cases(CommandTest):
    def kinetic(self, folder):
        return self.json(folder + "/summary.json")["energy"]["kinetic"]

    def test_each_in_its_folder(self):
        self.write(DECK)
        run = self.nugget("run", "model.k", "--quiet", "-o", "out")
        self.assertIn("case 1 slow, into out/slow\n", run.stderr)
        self.assertIn("case 2, into out/case2\n", run.stderr)
        self.assertEqual(self.files("out"), ["case2", "slow"])
        self.assertAlmostEqual(self.kinetic("out/slow"), 0.5, 9)
        self.assertAlmostEqual(self.kinetic("out/case2"), 4.5, 9)
        self.assertEqual([self.json(f"out/{f}/summary.json")["case"] for f in ("slow", "case2")], [1, 2])
        self.assertIn("model.k, case 2\n", self.read("out/case2/run.log"))

    def test_one_of_them(self):
        self.write(DECK)
        self.nugget("run", "model.k", "--quiet", "--case", 2, "-o", "two")
        self.assertAlmostEqual(self.kinetic("two"), 4.5, 9)
        run = self.nugget("run", "model.k", "--case", 3, "-o", "three", expect=1)
        self.assertIn("there is no case 3 [the deck has 1 (slow), 2]", run.stderr)

    def test_check_goes_through_all(self):
        self.write(DECK.replace("*CASE_END_20", "*LOAD_WIND\n*CASE_END_20"))
        run = self.nugget("check", "model.k", "-o", "audit", expect=1)
        self.assertEqual(self.files("audit"), ["case2", "slow"])
        self.assertEqual([f for f in self.json("audit/slow/findings.json") if f["severity"] == "error"], [])
        self.assertIn("*LOAD_WIND", run.stderr)

    def test_a_kept_state_knows_its_case(self):
        self.write(DECK)
        self.nugget("run", "model.k", "--quiet", "--case", 2, "--until", 0.005, "--checkpoint", "1cycles", "-o", "two")
        self.nugget("run", "--resume", "two", "--until", 0.01, "--quiet")
        self.assertAlmostEqual(self.kinetic("two"), 4.5, 9)

    def test_modes_want_one(self):
        self.write(DECK)
        run = self.nugget("modes", "model.k", expect=1)
        self.assertIn("the deck has the cases 1 (slow), 2 [take one with --case N", run.stderr)
        self.nugget("modes", "model.k", "--case", 1, "-n", 2, "--quiet", "-o", "modes")


if __name__ == "__main__":
    unittest.main()
