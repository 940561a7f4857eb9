# SPDX-License-Identifier: Apache-2.0
"""--weld-tie area and *NUGGET_WELD_TIE: what a user gets of run, check, modes and frf, and what is refused."""
import csv
import io
import unittest

from lap_joint import deck, edited
from nugget_command import CommandTest
from repeated_runs import RepeatedRuns

CARD = "*NUGGET_WELD_TIE\n         1\n"
MODES = "*CONTROL_IMPLICIT_GENERAL\n         1       1.0\n*CONTROL_IMPLICIT_EIGENVALUE\n         8\n"


def clusters(count):
    """Bricks in place of the weld beam."""
    return f"*CONTROL_SPOTWELD_BEAM\n         0         0         0         0         0{count:10d}\n"


def layers():
    """The lap joint with a weld of two layers of bricks, 5 x 5 each."""
    nodes, bricks = [], []
    for k in range(3):
        for c, (x, y) in enumerate(((6.5, 6.5), (11.5, 6.5), (11.5, 11.5), (6.5, 11.5))):
            nodes.append(f"{401 + 4 * k + c:8d}{x:16.4f}{y:16.4f}{0.6 * k:16.4f}")
    for k in range(2):
        bricks.append(f"{41 + k:8d}{3:8d}" + "".join(f"{401 + 4 * k + c:8d}" for c in range(8)))
    text = deck(("*SECTION_BEAM\n         3         9       1.0         2       1.0\n       6.0       6.0       0.0       0.0\n",
                 "*SECTION_SOLID\n         3         1\n"))
    beam = text.index("*ELEMENT_BEAM")
    return text[:beam] + "\n".join(["*NODE", *nodes, "*ELEMENT_SOLID", *bricks, "*END", ""])


def assembly():
    """The lap joint with four bricks of ELFORM 2 that yield and fail one by one (EFAIL), an assembly by its card."""
    nodes = [f"{401 + 9 * k + 3 * j + i:8d}{6.5 + 2.5 * i:16.4f}{6.5 + 2.5 * j:16.4f}{1.2 * k:16.4f}"
             for k in range(2) for j in range(3) for i in range(3)]
    bricks = []
    for a in (401, 402, 404, 405):
        base = (a, a + 1, a + 4, a + 3)
        bricks.append(f"{41 + len(bricks):8d}{3:8d}" + "".join(f"{n:8d}" for n in (*base, *(n + 9 for n in base))))
    text = deck(("*SECTION_BEAM\n         3         9       1.0         2       1.0\n       6.0       6.0       0.0       0.0\n",
                 "*SECTION_SOLID\n         3         2\n"), ("     500.0    1000.0\n", "      60.0      10.0\n"),
                ("       0.0    8000.0    6000.0    6000.0    9000.0    7000.0    7000.0", "      0.02"),
                ("  2.00e-05\n*CONTROL_TIMESTEP", "  4.00e-04\n*CONTROL_TIMESTEP"))
    beam = text.index("*ELEMENT_BEAM")
    return text[:beam] + "\n".join(["*NODE", *nodes, "*ELEMENT_SOLID", *bricks, "*DEFINE_HEX_SPOTWELD_ASSEMBLY_4", f"{77:10d}",
                                    "".join(f"{e:10d}" for e in range(41, 45)), "*END", ""])


def with_card(text, card=CARD):
    return edited(text, ("*CONTROL_TERMINATION\n", card + "*CONTROL_TERMINATION\n"))


class WeldTie(CommandTest):
    def peak(self, folder):
        return self.json(f"{folder}/summary.json")["weld"][0]["peak"]["shear"]

    def test_option_and_card_are_the_same_and_another_than_none(self):
        self.write(deck(), "plain.k")
        self.write(with_card(deck()), "card.k")
        self.write(with_card(deck(), CARD.replace("1", "0")), "zero.k")
        self.nugget("run", "plain.k", "-o", "plain")
        self.nugget("run", "plain.k", "-o", "option", "--weld-tie", "area")
        self.nugget("run", "card.k", "-o", "card")
        self.nugget("run", "zero.k", "-o", "zero")
        swforc = {name: self.read(f"{name}/swforc").splitlines()[3:] for name in ("plain", "option", "card", "zero")}
        self.assertEqual(swforc["option"], swforc["card"])
        self.assertEqual(swforc["plain"], swforc["zero"])
        self.assertNotEqual(swforc["plain"], swforc["card"])
        self.assertIn("2 weld ends are tied to discs of their sheets", self.read("option/run.log"))

    def test_check_says_what_it_would_change(self):
        self.write(deck(("       6.0       6.0       0.0", "       9.0       9.0       0.0")))  # reaches over its element
        rows = {}
        for folder, *option in (("plain",), ("area", "--weld-tie", "area")):
            run = self.nugget("check", "model.k", "-o", folder, *option)
            self.assertIn("Reach of the welds' forces into the sheets over the nugget's radius", run.stdout)
            rows[folder] = next(csv.DictReader(io.StringIO(self.read(f"{folder}/welds.csv"))))
        for name in ("hold_by_segment", "hold_by_area"):
            self.assertEqual(rows["plain"][name], rows["area"][name])
            self.assertGreater(float(rows["plain"][name]), 0.5)
        self.assertLess(float(rows["plain"]["hold_by_segment"]), float(rows["plain"]["hold_by_area"]))

    def test_check_says_what_such_a_mesh_cannot_give(self):
        """Nuggets of 6 and 3.5 on elements of 6, and one so small that nothing like it was measured."""
        errors = {}
        for diameter in (6.0, 3.5, 1.5):
            self.write(deck(("       6.0       6.0       0.0", f"{diameter:10.1f}{diameter:10.1f}       0.0")))
            run = self.nugget("check", "model.k", "-o", "joint", "--weld-tie", "joint")
            self.assertIn("Welds with joints: 1. By coupons on such meshes their stiffness is within 5 % in lap for", run.stdout)
            row = next(csv.DictReader(io.StringIO(self.read("joint/welds.csv"))))
            errors[diameter] = [row[name] for name in ("error_lap", "error_peel", "error_cross", "error_force")]
        self.assertTrue(all(float(e) > 0.0 for e in errors[6.0]))
        self.assertGreater(float(errors[3.5][2]), float(errors[6.0][2]))
        self.assertEqual(errors[1.5], [""] * 4)
        self.assertIn("1 on elements larger than any that was measured", run.stdout)
        self.nugget("check", "model.k", "-o", "area", "--weld-tie", "area")
        self.assertNotIn("error_peel", self.read("area/welds.csv").splitlines()[0])

    def test_a_joint_by_option_or_card(self):
        """Coarse elements: the joint is softer than the area alone, elastic already, and says so."""
        self.write(deck(), "plain.k")
        self.write(with_card(deck(), CARD.replace("1", "2")), "card.k")
        for folder, file, *option in (("area", "plain.k", "--weld-tie", "area"), ("option", "plain.k", "--weld-tie", "joint"),
                                      ("card", "card.k")):
            self.nugget("run", file, "-o", folder, *option)
        swforc = {name: self.read(f"{name}/swforc").splitlines()[3:] for name in ("area", "option", "card")}
        self.assertEqual(swforc["option"], swforc["card"])
        self.assertNotEqual(swforc["option"], swforc["area"])
        self.assertIn("1 weld beams and 0 welds of bricks have joints", self.read("option/run.log"))
        for folder in ("area", "option"):
            self.assertAlmostEqual(self.json(f"{folder}/summary.json")["energy"]["ratio"], 1.0, delta=1e-3)

    def test_a_joint_lowers_modes(self):
        self.write(edited(deck(), ("*TITLE\n", MODES + "*TITLE\n")))
        first = []
        for form in ("area", "joint"):
            self.nugget("modes", "model.k", "-o", form, "-n", "4", "--weld-tie", form)
            first.append([m["frequency_hz"] for m in self.json(f"{form}/summary.json")["modes"]])
        self.assertTrue(all(joint <= area * (1 + 1e-9) for area, joint in zip(*first)))
        self.assertLess(sum(first[1]), sum(first[0]))

    def test_joints_of_bricks(self):
        """Softer than the area alone, in runs and modes; check has the numbers of the beam in whose place they stand."""
        self.write(deck(), "beam.k")
        self.nugget("check", "beam.k", "-o", "beam", "--weld-tie", "joint")
        beam = next(csv.DictReader(io.StringIO(self.read("beam/welds.csv"))))
        for count in (1, 4, 8):
            with self.subTest(bricks=count):
                self.write(with_card(deck(), clusters(count)))
                self.nugget("check", "model.k", "-o", "check", "--weld-tie", "joint")
                row = next(csv.DictReader(io.StringIO(self.read("check/welds.csv"))))
                for name in ("joint_in_plane", "joint_bending", "joint_normal_yield", "joint_shear_yield", "joint_moment_yield"):
                    self.assertAlmostEqual(float(row[name]) / float(beam[name]), 1.0, delta=1e-3, msg=name)
                for form in ("area", "joint"):
                    self.nugget("run", "model.k", "-o", form, "--weld-tie", form)
                    self.assertAlmostEqual(self.json(f"{form}/summary.json")["energy"]["ratio"], 1.0, delta=1e-3)
                self.assertIn("0 weld beams and 1 welds of bricks have joints", self.read("joint/run.log"))
                self.assertLess(self.peak("joint"), 0.97 * self.peak("area"))
        self.write(edited(with_card(deck(), clusters(8)), ("*TITLE\n", MODES + "*TITLE\n")))
        first = []
        for form in ("area", "joint"):
            self.nugget("modes", "model.k", "-o", "modes_" + form, "-n", "4", "--weld-tie", form)
            first.append([m["frequency_hz"] for m in self.json(f"modes_{form}/summary.json")["modes"]])
        self.assertTrue(all(joint <= area * (1 + 1e-9) for area, joint in zip(*first)))
        self.assertLess(sum(first[1]), sum(first[0]))

    def test_an_assembly_that_yields_and_fails(self):
        self.write(assembly())
        self.nugget("run", "model.k", "-o", "joint", "--weld-tie", "joint")
        self.assertIn("0 weld beams and 1 welds of bricks have joints", self.read("joint/run.log"))
        summary = self.json("joint/summary.json")
        weld, = summary["weld"]
        self.assertEqual((weld["id"], weld["failed"], weld["failure_mode"]), (77, True, "plastic strain"))
        self.assertLess(abs(weld["peak"]["shear"] / (60.0 / 3.0 ** 0.5 * 25.0) - 1.0), 0.05)  # area 25; hardens by a hundredth
        self.assertAlmostEqual(summary["energy"]["ratio"], 1.0, delta=1e-6)

    def test_bricks_that_get_no_joint(self):
        self.write(layers())
        run = self.nugget("run", "model.k", "-o", "layers", "--weld-tie", "joint")
        self.assertIn("1 weld of bricks, tied by area, without a joint, first of assembly weld 41: it has more than one layer of bricks",
                      run.stderr)
        self.write(with_card(deck(), clusters(1) + "*CONTROL_SUBCYCLE\n"))
        run = self.nugget("run", "model.k", "-o", "out", "--weld-tie", "joint", expect=1)
        self.assertIn("this run has joints of welds of bricks", run.stderr)

    def test_modes_and_responses_know_it(self):
        self.write(edited(deck(), ("*TITLE\n", MODES + "*TITLE\n")))
        self.nugget("modes", "model.k", "-o", "plain", "-n", "4")
        self.nugget("modes", "model.k", "-o", "area", "-n", "4", "--weld-tie", "area")
        first = [[m["frequency_hz"] for m in self.json(f"{f}/summary.json")["modes"]] for f in ("plain", "area")]
        self.assertNotEqual(*first)
        self.assertIn("--weld-tie", self.nugget("frf", "--help").stdout)

    def test_what_is_refused(self):
        self.write(deck())
        self.assertIn("expected area or joint", self.nugget("check", "model.k", "--weld-tie", "disc", expect=2).stderr)
        self.nugget("run", "--resume", "out", "--weld-tie", "area", expect=2)
        self.write(with_card(deck(), "*NUGGET_WELD_TIE\n         3\n"))
        run = self.nugget("run", "model.k", "-o", "out", expect=1)
        self.assertIn("NUGGET_WELD_TIE form = 3", run.stderr)


class RepeatedByArea(RepeatedRuns):
    def test_any_number_of_threads(self):
        self.compare(self.write(deck(("    8000.0    6000.0    6000.0", "    8000.0    1000.0    1000.0"))), "--weld-tie", "area")

    def test_any_number_of_threads_with_joints(self):
        self.compare(self.write(deck(("    8000.0    6000.0    6000.0", "    8000.0    1000.0    1000.0"))), "--weld-tie", "joint")

    def test_any_number_of_threads_with_joints_of_bricks(self):
        text = deck(("    8000.0    6000.0    6000.0", "    8000.0    1000.0    1000.0"))
        self.compare(self.write(with_card(text, clusters(4))), "--weld-tie", "joint")

    def test_resumed_with_joints_of_bricks(self):
        self.resumed(with_card(deck(), clusters(8)), "--weld-tie", "joint", shares=(0.5,))

    def test_resumed_with_joints(self):
        self.resumed(deck(), "--weld-tie", "joint", shares=(0.5,))

    def test_resumed_by_area(self):
        """A run that was begun by area goes on by area, though nothing in the deck says so."""
        self.resumed(deck(), "--weld-tie", "area", shares=(0.5,))


if __name__ == "__main__":
    unittest.main()
