# SPDX-License-Identifier: Apache-2.0
"""Runs that look sound and are not what their writer meant: it is said."""
import unittest

import lap_joint
from few_elements import BRICK, CORNERS, SOLID, card, curve, nodes, part
from nugget_command import CommandTest
from welded_sheets import Sheets

MESH = SOLID + "*MAT_ELASTIC\n" + card(1, 1.0, 10.0, 0.3) + part(1) + nodes(CORNERS) + BRICK
HEAD = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(0.01)


class SilentMistakes(CommandTest):
    def test_nothing_moves(self):
        self.write(HEAD + MESH + "*END\n")
        self.assertIn("warning: nothing moved", self.nugget("run", "model.k", "--quiet").stderr)
        self.assertIn("warning: nothing moved", self.read("run.log"))

    def test_a_velocity_along_a_held_direction(self):
        held = MESH.replace("*MAT_ELASTIC\n" + card(1, 1.0, 10.0, 0.3),
                            "*MAT_RIGID\n" + card(1, 1.0, 10.0, 0.3) + card(1, 5, 7) + "\n")
        self.assertIn("*MAT_RIGID", held)
        for vx, vy, said in ((0.0, 1.0, True), (1.0, 0.0, False)):  # CON1 5: y and z are held
            with self.subTest(vx=vx):
                self.write(HEAD + held + "*INITIAL_VELOCITY_GENERATION\n" + card(0, 0, 0, vx, vy, 0) + card("") + "*END\n")
                self.assertEqual("nothing moved" in self.nugget("run", "model.k", "--quiet").stderr, said)

    def test_collapsed_quads(self):
        for triangles, esort, elform, said in ((5, 0, 2, "warning"), (1, 0, 2, "note"), (0, 0, 2, None), (5, 1, 2, None), (5, 0, 4, None)):
            s = Sheets(shells=elform)
            s.cards += ["*CONTROL_TERMINATION\n1.0e-6", f"*CONTROL_SHELL\n20.0,{esort}"]
            s.sheet(1.0, 0.0, 0.0, 0.0, 5, 4, 5.0)
            if elform == 4:
                triangles = len(s.shells)
            for i in range(triangles):
                e, part, a, b, c, _ = s.shells[i].split(",")
                s.shells[i] = f"{e},{part},{a},{b},{c},{c}"
            self.write(s.text())
            run = self.nugget("check", "model.k").stderr
            with self.subTest(triangles=triangles, esort=esort, elform=elform):
                line = f"{said}: *PART: part 1: {triangles} of its 20 shells are quadrilaterals with two corners at one node"
                self.assertEqual("two corners at one node" in run, said is not None, run)
                self.assertTrue(said is None or line in run, run)

    def test_welds_that_hold_nothing(self):
        far = lap_joint.deck()
        self.write(far)
        self.assertNotIn("are not tied", self.nugget("run", "model.k", "--quiet", "--max-cycles", 5).stderr)
        spotstp = "         0         0         0         0         {}\n"
        loose = far.replace(spotstp.format(1), spotstp.format(3))
        moved = [line.replace(line[40:56], f"{30.0:16.6f}") if line.startswith("     302") else line
                 for line in loose.splitlines(keepends=True)]
        self.write("".join(moved))
        run = self.nugget("run", "model.k", "--quiet", "--max-cycles", 5)
        self.assertIn("warning: 1 of 1 welds are not tied to their sheets", run.stderr)

    def test_a_displacement_that_does_not_begin_with_0(self):
        drive = "*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + card(1, 1, 2, 1) + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + card(2, 1, 2, 2)
        for first, said in ((0.0, False), (0.1, True)):
            self.write(HEAD + MESH + curve(1, (0.0, first), (1.0, 0.2)) + curve(2, (0.0, 0.0), (1.0, 0.2)) + drive + "*END\n")
            run = self.nugget("run", "model.k", "--quiet", "--max-cycles", 3).stderr
            self.assertEqual("curve 1 begins with the displacement 0.1: that is where the motion finds what it drives" in run, said, run)
            self.assertNotIn("curve 2 begins", run)

    def test_a_joint_stiffness_at_the_global_origin(self):
        """The displacement of a translational stiffness is that of its systems' origins."""
        bodies = (SOLID + "*MAT_RIGID\n" + card(1, 1.0, 10.0, 0.3) + "\n\n" + part(1) + part(2) + nodes(CORNERS) + BRICK +
                  "*NODE\n" + "".join(f"{i + 9:8}{x + 1.5:16.9f}{y:16.9f}{z:16.9f}\n" for i, (x, y, z) in enumerate(CORNERS)) +
                  "*ELEMENT_SOLID\n       2       2\n" + "".join(f"{i:8}" for i in range(9, 17)) + "\n")
        stiffness = "*CONSTRAINED_JOINT_STIFFNESS_{}\n" + card(1, 1, 2, 1) + card(1) + "\n\n" + curve(1, (-1.0, -1.0), (1.0, 1.0))
        vectors = "*DEFINE_COORDINATE_VECTOR\n" + card(1, 1, 0, 0, 0, 1, 0)
        points = "*DEFINE_COORDINATE_SYSTEM\n" + card(1, 1, 0, 0, 2, 0, 0) + card(1, 1, 0)
        for form, system, said in (("TRANSLATIONAL", vectors, True), ("TRANSLATIONAL", points, False), ("GENERALIZED", vectors, False)):
            with self.subTest(form, said=said):
                self.write(HEAD + bodies + system + stiffness.format(form) + "*END\n")
                run = self.nugget("run", "model.k", "--quiet", "--max-cycles", 3).stderr
                self.assertEqual("coordinate system 1 of *DEFINE_COORDINATE_VECTOR has the global origin" in run, said, run)

    def test_an_include_file_of_the_same_name_elsewhere(self):
        self.write(HEAD + "*INCLUDE\nmesh.inc\n*END\n", "deck/model.k")
        self.write(MESH, "deck/mesh.inc")
        self.assertNotIn("of that name", self.nugget("check", "deck/model.k", "-o", "a").stderr)
        self.write(MESH, "mesh.inc")
        said = self.nugget("check", "deck/model.k", "-o", "b").stderr
        self.assertIn(f"{(self.folder / 'mesh.inc').resolve()} is read; another file of that name stands beside the "
                      "deck, deck/mesh.inc", said)

    def test_files_by_their_whole_paths(self):
        self.write(HEAD + "*INCLUDE\nmesh.inc\n*END\n", "deck/model.k")
        self.write(MESH, "deck/mesh.inc")
        self.nugget("run", "deck/model.k", "--quiet", "-o", "out")
        files = [str(self.folder / "deck" / name) for name in ("model.k", "mesh.inc")]
        self.assertEqual(self.json("out/summary.json")["files"], files)
        self.assertIn("Files read\n\n " + "\n ".join(files), self.read("out/run.log"))

    def test_a_brick_whose_part_is_missing_is_one_finding(self):
        """It stands alone, as welds do, but nothing holds it. Sabotage: each of
        its nodes is an untied weld."""
        alone = ("*NODE\n" + "".join(f"{900 + i:8d}{60.0 + x:16.4f}{y:16.4f}{z:16.4f}\n" for i, (x, y, z) in enumerate(CORNERS))
                 + "*ELEMENT_SOLID\n      90      77" + "".join(f"{900 + i:8d}" for i in range(8)) + "\n")
        self.write(lap_joint.deck().replace("*END", alone + "*END"))
        run = self.nugget("check", "model.k", expect=1)
        told = [line for line in run.stderr.splitlines() if "arning" in line or "error" in line]
        self.assertIn("part 77 is not defined; 1 of its elements", run.stderr)
        self.assertFalse([line for line in told if "weld 90" in line or "brick" in line], run.stderr)
        self.assertIn("1 weld, each on two sheets", run.stderr)  # the deck's own beam
        self.write(HEAD + MESH + alone + "*END\n")
        run = self.nugget("check", "model.k", expect=1)
        self.assertEqual(run.stderr.count("\n"), 2, run.stderr)  # the finding, and how many

    def test_fields_for_bricks_on_weld_beams(self):
        """TRUE_T corrects single bricks, ASFF is about assemblies. Sabotage: read, and not a word."""
        weld = "*MAT_SPOTWELD_DAMAGE-FAILURE\n2,7.85e-9,210000.0,0.3,500.0,1000.0\n0.2,8000.0,6000.0,6000.0\n,,,{},{}"
        for true_t, asff in (("1.1", "1"), ("", "0")):
            s = Sheets()
            s.cards += ["*CONTROL_TERMINATION\n2.0e-5", weld.format(true_t, asff)]
            sheets = [s.sheet(1.2, 0.0, 0.0, z, 5, 5, 6.0) for z in (0.0, 1.2)]
            beams, bricks = s.beam_part(6.0, 2), s.brick_part(2)
            s.beam(beams, (8.0, 16.0, 0.0), (8.0, 16.0, 1.2))
            s.brick(bricks, 20.0, 16.0, 0.0, 5.0, 1.2)
            s.tie([beams, bricks], sheets)
            self.write(s.text())
            run = self.nugget("check", "model.k")
            self.assertEqual(run.stderr.count("TRUE_T = 1.1 of its material corrects single bricks, but part 3 has beams"), int(asff), run.stderr)
            self.assertEqual(run.stderr.count("ASFF = 1 of its material is about assemblies of bricks, but part 3"), int(asff))
            self.assertNotIn("but part 4", run.stderr)


if __name__ == "__main__":
    unittest.main()
