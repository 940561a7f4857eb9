# SPDX-License-Identifier: Apache-2.0
"""What public decks ask for out of habit: contacts of earlier releases, parts that are rigid from the start,
*CONTROL_SOLUTION, fields that are zero and fields that have moved, no *DATABASE_GLSTAT. On decks of our own."""
import unittest

import lap_joint
from contact_models import LOWER, SIDE, UPPER, plates, sliding
from few_elements import card
from nugget_command import CommandTest


def words(*lines):
    def write(d):
        d.lines += lines
    return write


def together(*parts):
    def write(d):
        for part in parts:
            part(d)
    return write


class PublicHabits(CommandTest):
    def run_plates(self, contact, motion=None, end=1.0e-4, expect=0, command="run", **options):
        self.write(plates(contact, motion or {3: -1000.0}, end, **options))
        more = ["--quiet", "-j", 1] if command == "run" else []
        return self.nugget(command, "model.k", *more, expect=expect)

    def pressed(self):
        return [line.split()[9] for line in self.read("rcforc").splitlines() if line.split()[:1] == ["slave"]]

    def test_titles_of_definitions(self):
        """Every *DEFINE_... has a _TITLE."""
        death = {"*DEFINE_ELEMENT_DEATH_SHELL": "*DEFINE_ELEMENT_DEATH_SHELL\n" + card(24, 1.0e-5)}
        death["*DEFINE_ELEMENT_DEATH_SHELL_TITLE"] = death["*DEFINE_ELEMENT_DEATH_SHELL"].replace("SHELL\n", "SHELL_TITLE\nlost\n")
        bits = []
        for text in death.values():
            self.write(lap_joint.deck(("*PART\nlower", text + "*DEFINE_FUNCTION_TITLE\nnot used\n" + card(9) + "f(x)=x*2\n*PART\nlower")))
            self.nugget("run", "model.k", "--quiet")
            bits.append((self.folder / "d3plot01").read_bytes())
        self.assertEqual(bits[0], bits[1])
        self.write(lap_joint.deck())
        self.nugget("run", "model.k", "--quiet")
        self.assertNotEqual(bits[0], (self.folder / "d3plot01").read_bytes(), "something is deleted")

    def test_contacts_of_earlier_releases_press_as_the_automatic_ones(self):
        """Sabotage: the keyword read as a transducer presses with nothing."""
        for old in ("SURFACE_TO_SURFACE", "ONE_WAY_SURFACE_TO_SURFACE", "NODES_TO_SURFACE"):
            self.run_plates(sliding("AUTOMATIC_" + old), gap=1.05)
            expected = self.pressed()
            run = self.run_plates(sliding(old), gap=1.05)
            self.assertEqual(self.pressed(), expected, old)
            self.assertGreater(max(abs(float(force)) for force in expected), 1.0)
            self.assertIn(f"*CONTACT_{old}: computed as the _AUTOMATIC form", run.stderr)
        single = words("*CONTACT_SINGLE_SURFACE", "", "", "")
        run = self.run_plates(single, gap=1.05)
        self.assertIn("*CONTACT_SINGLE_SURFACE: computed as *CONTACT_AUTOMATIC_SINGLE_SURFACE", run.stderr)
        self.assertGreater(self.json("summary.json")["energy"]["contact"], 0.0)

    def pushed(self, *cards, other_part=()):
        """The lower plate free under one nodal force of 50 along z. `other_part`: shells of it that are part 3."""
        load = words("*LOAD_NODE_POINT", f"{1:10d}{3:10d}{7:10d}{50.0:10.1f}", "*DEFINE_CURVE", f"{7:10d}",
                     f"{0.0:20.1f}{1.0:20.1f}", f"{1.0:20.1f}{1.0:20.1f}", "*DATABASE_RBDOUT", f"{2.0e-6:10.2e}",
                     "*PART", "corner", f"{3:10d}{1:10d}{LOWER:10d}")
        text = plates(words(*cards), {1: 0.0}, 2.0e-4, gap=10.0, extra=load)
        text = text[:text.index("*BOUNDARY_SPC_SET")] + text[text.index("*BOUNDARY_PRESCRIBED_MOTION_RIGID"):]
        before, shells = text.split("*ELEMENT_SHELL")
        for shell in other_part:
            shells = shells.replace(f"\n{shell:8d}{LOWER:8d}", f"\n{shell:8d}{3:8d}")
        self.write(before + "*ELEMENT_SHELL" + shells)

    def expect_free_fall(self):
        """The centre goes by F t^2 / 2m and nothing deforms."""
        mass = 7.85e-9 * SIDE * SIDE * 1.0
        self.assertAlmostEqual(self.center_path(LOWER) / (0.5 * 50.0 * 2.0e-4 ** 2 / mass), 1.0, delta=2e-3)
        energy = self.json("summary.json")["energy"]
        self.assertLess(abs(energy["internal"]), 1e-9 * energy["kinetic"])

    def test_a_part_that_is_rigid_from_the_start(self):
        """Sabotage: with another density the path differs; without the card there is no such body."""
        for cards in (["*DEFORMABLE_TO_RIGID", f"{LOWER:10d}"],
                      ["*SET_PART_LIST", f"{5:10d}", f"{LOWER:10d}", "*DEFORMABLE_TO_RIGID", f"{5:10d}{0:10d}      PSET"]):
            self.pushed(*cards)
            self.nugget("run", "model.k", "--quiet", "-j", 1)
            self.expect_free_fall()

    def test_rigid_parts_that_share_a_plane_of_nodes_move_as_one(self):
        """The shell at a corner shares three nodes with the rest; half a plate shares a line, about which it could turn."""
        cards = ["*DEFORMABLE_TO_RIGID", f"{LOWER:10d}", f"{3:10d}"]
        self.pushed(*cards, other_part=[1])
        run = self.nugget("run", "model.k", "--quiet", "-j", 1)
        self.assertIn("rigid part 3 shares nodes with rigid part 1, and moves with it as one", run.stderr)
        self.expect_free_fall()
        self.pushed(*cards, other_part=[9, 10, 11, 12, 13, 14, 15, 16])
        run = self.nugget("check", "model.k", expect=1)
        self.assertIn("belongs to two rigid bodies: rigid part 1 and rigid part 3", run.stderr)

    def center_path(self, body):
        path = None
        for block in self.read("rbdout").split(" rigid body ")[1:]:
            if int(block.split()[0]) == body:
                row = next(line for line in block.splitlines() if "displacements:" in line)
                path = float(row.split()[3])
        return path

    def test_what_cannot_be_made_rigid(self):
        run = self.run_plates(words("*DEFORMABLE_TO_RIGID", f"{LOWER:10d}{UPPER:10d}"), command="check", expect=1)
        self.assertIn("*DEFORMABLE_TO_RIGID lrb = 2: merging into a lead body here is not built", run.stderr)
        run = self.run_plates(words("*DEFORMABLE_TO_RIGID", f"{77:10d}"), command="check", expect=1)
        self.assertIn("part 77 is not defined", run.stderr)
        run = self.run_plates(words("*DEFORMABLE_TO_RIGID_AUTOMATIC", f"{1:10d}"), command="check", expect=1)
        self.assertIn("switching during a run is not built", run.stderr)

    def test_the_structural_solution_may_be_named(self):
        contact = sliding("AUTOMATIC_SURFACE_TO_SURFACE")
        run = self.run_plates(together(contact, words("*CONTROL_SOLUTION", f"{0:10d}{0:10d}{1:10d}{500:10d}")))
        self.assertNotIn("CONTROL_SOLUTION", run.stderr)
        run = self.run_plates(together(contact, words("*CONTROL_SOLUTION", f"{2:10d}")), command="check", expect=1)
        self.assertIn("*CONTROL_SOLUTION soln = 2: only 0 is supported", run.stderr)

    def test_parts_with_the_option_title(self):
        """It has a title line anyway. Sabotage: the option taken away."""
        self.write(lap_joint.deck())
        self.nugget("check", "model.k", "-o", "plain")
        self.write(lap_joint.deck(("*PART\nlower sheet", "*PART_TITLE\nlower sheet")))
        self.nugget("check", "model.k", "-o", "titled")
        self.assertEqual(self.read("titled/welds.csv"), self.read("plain/welds.csv"))

    def test_softening_of_shells_beside_mass_scaling_has_no_effect(self):
        """As in LS-DYNA, where DT2MS switches a TSLIMT above 0 off; alone, or below 0, it is refused."""
        for tslimt, dt2ms, code in (("1.0e-07", "-1.0e-07", 0), ("1.0e-07", "0.0", 1), ("-1.0e-07", "-1.0e-07", 1)):
            self.write(lap_joint.deck(("       0.0       0.9\n", f"       0.0       0.9         0{tslimt:>10}{dt2ms:>10}\n")))
            run = self.nugget("check", "model.k", expect=code)
            self.assertIn("no effect beside DT2MS" if code == 0 else "softening of shells to hold a time step is not built",
                          run.stderr)

    def test_zeros_behind_the_last_field_ask_for_nothing(self):
        contact = sliding("AUTOMATIC_SURFACE_TO_SURFACE")
        for behind, is_told in ((f"{0:10d}", False), ("       0.0", False), (f"{3:10d}", True), ("       0.1", True)):
            card = words("*CONTROL_ACCURACY", f"{0:10d}{1:10d}" + 5 * f"{0:10d}" + behind)
            run = self.run_plates(together(contact, card), command="check")
            self.assertEqual("behind the last field" in run.stderr, is_told, behind)

    def test_distorted_shells_by_the_card_of_release_971(self):
        """A node taken across its shells: with NFAIL1 = 2 on the second card the run stops, as with it on the fourth."""
        contact = sliding("AUTOMATIC_SURFACE_TO_SURFACE")
        plain = "*CONTROL_SHELL\n" + f"{20.0:10.1f}\n"
        old = plain + 5 * f"{'':10}" + f"{2:10d}{2:10d}{0:10d}"
        new = plain + "\n\n" + f"{2:10d}{2:10d}"
        stopped = {}
        for name, card in (("none", plain.rstrip()), ("old", old), ("new", new)):
            text = plates(together(contact, words(*card.split("\n"))), {1: 0.0}, 1.0e-4, gap=10.0)
            # Node 7 is taken across its shells within their plane.
            begin = text.index("*BOUNDARY_SPC_SET")
            held = text[begin:text.index("*BOUNDARY_PRESCRIBED_MOTION_RIGID")]
            motion = "*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + f"{7:10d}{1:10d}{0:10d}{9:10d}{1.5e5:10.1e}\n"
            motion += "*DEFINE_CURVE\n" + f"{9:10d}\n{0.0:20.1f}{1.0:20.1f}\n{1.0:20.1f}{1.0:20.1f}\n"
            edge = "*SET_NODE_LIST\n" + f"{8:10d}\n" + "".join(f"{n:10d}" for n in (1, 5, 21, 25)) + "\n"
            self.write(text.replace(held, edge + "*BOUNDARY_SPC_SET\n" + f"{8:10d}{0:10d}" + 6 * f"{1:10d}" + "\n" + motion))
            self.nugget("run", "model.k", "--quiet", "-j", 1, expect=3 if name != "none" else 0)
            stopped[name] = self.json("summary.json")["message"]
        self.assertNotIn("is distorted", stopped["none"])
        self.assertIn("is distorted", stopped["new"])
        self.assertEqual(stopped["old"], stopped["new"])

    def test_the_report_has_energies_whatever_the_deck_asks_for(self):
        contact = sliding("AUTOMATIC_SURFACE_TO_SURFACE")
        text = plates(contact, {3: -1000.0}, 1.0e-4)
        glstat = text[text.index("*DATABASE_GLSTAT"):text.index("*DATABASE_RCFORC")]
        binary = glstat.rstrip().split("\n")
        binary[-1] += f"{2:10d}"
        self.write(text.replace(glstat, "\n".join(binary) + "\n"))
        self.nugget("run", "model.k", "--quiet", "-j", 1)
        self.assertEqual(len(self.glstat()), 101)
        self.assertIn("kinetic energy", self.read("report.html"))
        self.write(text.replace(glstat, ""))
        self.nugget("run", "model.k", "--quiet", "-j", 1)
        self.assertIn(len(self.glstat()), range(50, 203))
        self.assertIn("kinetic energy", self.read("report.html"))

    def bent(self, hourglass):
        """The lower plate, shells of one layer with no stiffness against bending, blown out of its plane at every other
        node: a pattern of hourglasses alone."""
        text = plates(words("*CONTROL_HOURGLASS", hourglass), {1: 0.0}, 3.0e-4, gap=10.0)
        pattern = [n for n in range(1, 26) if (n - 1) % 2 == 0]
        blow = "*SET_NODE_LIST\n" + f"{8:10d}\n"
        blow += "".join("".join(f"{n:10d}" for n in pattern[i:i + 8]) + "\n" for i in range(0, len(pattern), 8))
        blow += "*INITIAL_VELOCITY\n" + f"{8:10d}\n" + f"{0.0:10.1f}{0.0:10.1f}{2.0e4:10.1f}\n"
        begin = text.index("*BOUNDARY_SPC_SET")
        self.write(text[:begin] + blow + text[text.index("*BOUNDARY_PRESCRIBED_MOTION_RIGID"):])
        return self.nugget("run", "model.k", "-j", 1)

    def test_a_node_that_is_held_and_driven_follows_the_motion(self):
        """So does one that is driven twice, the last card; work is counted once, and an SPC holds again when the motion has
        ended. Sabotage: held and driven in turn in each step (the ratio ends at 0.07)."""
        head = ("*KEYWORD\n*CONTROL_TERMINATION\n1.0e-4\n*PART\nsheet\n1,1,1\n*SECTION_SHELL\n1,2\n1.0\n*MAT_ELASTIC\n1,7.85e-9,210000.0,0.3\n"
                "*NODE\n1,0.0,0.0,0.0\n2,5.0,0.0,0.0\n3,5.0,5.0,0.0\n4,0.0,5.0,0.0\n*ELEMENT_SHELL\n1,1,1,2,3,4\n"
                "*DATABASE_NODOUT\n1.0e-5\n*DATABASE_HISTORY_NODE\n1\n*DEFINE_CURVE\n1\n0.0,0.0\n1.0e-5,1000.0\n1.0,1000.0\n")
        spc, drive = "*BOUNDARY_SPC_NODE\n1,0,1,1,1,1,1,1\n", "*BOUNDARY_PRESCRIBED_MOTION_NODE\n"
        for cards, speed, told in ((spc + drive + "1,1,0,1,1.0\n", 1000.0, "held by an SPC"), (drive + "1,1,0,1,1.0\n" + spc, 1000.0, "held by an SPC"),
                                   (drive + "1,1,0,1,1.0\n1,1,0,1,2.0\n", 2000.0, "driven by two cards"),
                                   (drive + "1,1,0,1,1.0,0,5.0e-5\n1,1,0,1,2.0,0,1.0,5.0e-5\n", 2000.0, None),
                                   (drive + "1,1,0,1,1.0\n" + spc.replace("1,0,1,1", "1,0,0,1"), 1000.0, None)):
            with self.subTest(cards=cards):
                self.write(head + cards + "*END\n")
                said = self.nugget("run", "model.k", "--quiet").stderr
                self.assertEqual([line for line in said.splitlines() if "node 1 is " in line] != [], told is not None, said)
                if told:
                    self.assertRegex(said, rf"warning: \*BOUNDARY_PRESCRIBED_MOTION: node 1 is {told}")
                rows = [line for line in self.read("nodout").splitlines() if line.split()[:1] == ["1"]]
                # columns of 12, the first of 13 behind the node: translations and rotations in turn
                self.assertAlmostEqual(float(rows[-2][46:58]), speed, delta=1.0)
                self.assertAlmostEqual(self.json("summary.json")["energy"]["ratio"], 1.0, delta=2.0e-3)
        # Driven for half of the time: as with an SPC along x that is born then.
        until = drive + "1,1,0,1,1.0,0,5.0e-5\n"
        born = "*BOUNDARY_SPC_NODE_BIRTH_DEATH\n1,0,1\n5.0e-5,1.0e20\n"
        nodout = []
        for cards in (spc + until, born + spc.replace("1,0,1,1", "1,0,0,1") + until):
            self.write(head + cards + "*END\n")
            self.nugget("run", "model.k", "--quiet")
            nodout.append(self.read("nodout"))
        self.assertEqual(*nodout)

    def test_a_run_full_of_hourglasses_is_doubted(self):
        """Sabotage: the limit taken of all energy."""
        run = self.bent(f"{1:10d}{0.1:10.2f}")
        energy = self.json("summary.json")["energy"]
        self.assertGreater(energy["hourglass"], 0.1 * energy["internal"])
        self.assertIn(f"the hourglass energy, {energy['hourglass']:.3g}, is more than a tenth", run.stderr)
        self.assertRegex(run.stderr, r"most of it, \S+, in part 1 \(shells of ELFORM 2\), beside an internal energy of \S+ there "
                         r"\[ELFORM 16 in its \*SECTION_SHELL, or \*HOURGLASS with IHQ 4 and QM 0\.05")
        self.assertIn("the hourglass energy, ", self.read("run.log"))
        run = self.run_plates(sliding("AUTOMATIC_SURFACE_TO_SURFACE"), gap=1.05)
        self.assertNotIn("hourglass energy, ", run.stderr)


if __name__ == "__main__":
    unittest.main()
