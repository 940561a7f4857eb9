# SPDX-License-Identifier: Apache-2.0
"""`nugget tidy`: a deck as it was understood, with the same results."""
import subprocess
import sys
import unittest

import lap_joint
from few_elements import BRICK, CORNERS, SOLID, card, nodes, part
from nugget_command import SOURCE
from repeated_runs import RepeatedRuns

TELLS_THE_FILE = {"summary.json", "findings.json", "run.log", "report.html"}
MESH = SOLID + "*MAT_ELASTIC\n" + card(1, 1.0, 10.0, 0.3) + part(1) + nodes(CORNERS) + BRICK
HEAD = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(0.01)


class Tidy(RepeatedRuns):
    def same_run(self, deck, *options):
        """Tidies, runs both, compares every result; gives the tidied text."""
        self.nugget("tidy", deck, "-o", "tidy/out.k")
        self.nugget("run", deck, "-o", "as_written", "--quiet", *options)
        self.nugget("run", "tidy/out.k", "-o", "tidied", "--quiet", *options)
        a, b = self.bits("as_written"), self.bits("tidied")
        self.assertEqual(sorted(a), sorted(b))
        self.assertLess({"d3plot", "glstat"}, set(a))
        for name in set(a) - TELLS_THE_FILE:
            self.assertTrue(a[name] == b[name], f"{name} differs")
        text = self.read("tidy/out.k")
        self.nugget("tidy", "tidy/out.k", "-o", "again/out.k")
        again = self.read("again/out.k").replace("\nout_out_", "\nout_")  # names of include files
        self.assertEqual(again, text, "a tidy deck stays as it is")
        return text

    def test_the_same_bits_and_names_above_the_values(self):
        text = self.same_run(self.write(lap_joint.deck()))
        lines = text.splitlines()
        at = lines.index("*CONTROL_TIMESTEP")
        self.assertEqual([name for name in lines[at + 1].split()[1:3]], ["dtinit", "tssfac"])
        self.assertEqual([cell.strip() for cell in lines[at + 2].split(",")], ["0.0", "0.9"])
        # Names end where their values end.
        self.assertEqual(lines[at + 1].index("tssfac") + 6, lines[at + 2].index("0.9") + 3)
        self.assertEqual(text.count("nid"), 1 + text.count("nid1"), "rows of a table are named once")

    def test_included_files_parameters_and_transforms(self):
        self.write(HEAD.replace("      0.01", "     &tend") .replace("*KEYWORD\n", "*KEYWORD\n*PARAMETER\nR     tend      0.01\n")
                   + "*DATABASE_GLSTAT\n" + card(0.001) + "*DATABASE_BINARY_D3PLOT\n" + card(0.005)
                   + "*INCLUDE\nmesh.inc\n*INCLUDE_TRANSFORM\nmesh.inc\n" + card(100, 100, 100, 100, 100, 100, 100) + card(100) + "\n\n"
                   + "*INITIAL_VELOCITY_GENERATION\n" + card(0, 0, 0, 1.0, 2.0, 0) + card("") + "*END\n")
        self.write("*KEYWORD\n" + MESH, "mesh.inc")
        text = self.same_run("model.k", "--until", "0.004")
        self.assertIn("$# endtim: &tend = 0.01\n     &tend\n", text)
        self.assertIn("*PARAMETER\nR     tend      0.01\n", text)
        self.assertIn("*INCLUDE\nout_mesh.inc\n", text)
        self.assertIn("*INCLUDE_TRANSFORM\nout_mesh.inc\n", text)
        self.assertIn("$#  nid", self.read("tidy/out_mesh.inc"))
        self.assertNotIn("$#", self.read("mesh.inc"))

    def test_faults_stand_beside_their_lines(self):
        self.write(HEAD + "*LOAD_WIND\n   1   2   3\n" + MESH.replace("      10.0", "     1x.0")
                   + "*CONTROL_TIMESTEP\n       0.0       0.9\n*END\n")
        run = self.nugget("tidy", "model.k", "-o", "out.k", expect=1)
        self.assertIn("*LOAD_WIND", run.stderr)
        text = self.read("out.k")
        self.assertIn("is not a number", text)
        lines = text.splitlines()
        wrong = next(i for i, line in enumerate(lines) if "1x.0" in line and not line.startswith("$"))
        self.assertTrue(lines[wrong - 1].startswith("$# error: e = 1x.0: "), lines[wrong - 1])
        self.assertIn(lines[wrong], (self.folder / "model.k").read_text().splitlines(), "it stays as it is")
        wind = lines.index("*LOAD_WIND")
        self.assertTrue(lines[wind - 1].startswith("$# error: *LOAD_WIND: "))
        self.assertEqual(lines[wind + 1], "   1   2   3")
        self.assertIn("      0.0,      0.9\n", text)

    def test_what_is_not_read_stays(self):
        surplus = card(0.01, "", "", "", "", "", "", "own")
        beyond = card(1, 1.0, 10.0, 0.3).rstrip("\n").ljust(80) + "a remark\n"
        mesh = MESH.replace(card(1, 1.0, 10.0, 0.3), beyond)
        self.write(HEAD.replace(card(0.01), surplus) + "$ a word of the writer\n" + mesh + "*END\n")
        self.nugget("tidy", "model.k", "-o", "out.k")
        text = self.read("out.k")
        self.assertIn("$ a word of the writer\n", text)
        self.assertIn("$# warning: *CONTROL_TERMINATION: 'own' stands behind the last field", text)
        self.assertIn(surplus, text)
        self.assertIn("$# column 81 on is not read: the line stays as it is\n" + beyond, text)

    def test_nothing_is_overwritten(self):
        deck = HEAD + "*INCLUDE\nout_mesh.inc\n*END\n"
        self.write(deck)
        self.write("*KEYWORD\n" + MESH, "out_mesh.inc")
        self.assertIn("would be overwritten", self.nugget("tidy", "model.k", "-o", "model.k", expect=2).stderr)
        self.assertEqual(self.read("model.k"), deck)
        self.nugget("tidy", "nowhere.k", "-o", "out.k", expect=1)
        self.assertFalse((self.folder / "out.k").exists())

    def test_a_double_hat(self):
        subprocess.run([sys.executable, str(SOURCE / "examples/double_hat/make.py"), str(self.folder)], check=True)
        self.same_run("double_hat.k", "--until", "1.0e-4")

    def test_car6(self):
        self.same_run(self.shared("decks/car6/main_v223.k"), "--until", "0.001")

    def test_a_public_specimen(self):
        self.same_run(self.shared("decks/tensile_test/zug_test3_RS.k"), "--max-cycles", "20")


if __name__ == "__main__":
    unittest.main()
