# SPDX-License-Identifier: Apache-2.0
"""Decks whose lines are sound and whose whole is not: cards that stand twice or say nothing, elements without a size, and
what `nugget check` says of them beside `nugget run`. Found by dropping, doubling and swapping the lines of 1200 decks."""
import unittest

import lap_joint
from few_elements import BRICK, CORNERS, SOLID, card, curve, nodes, part
from nugget_command import CommandTest

HEAD = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(1e-6)
STEEL = "*MAT_ELASTIC\n" + card(1, 7.85e-9, 210000.0, 0.3)
BLOCK = part(1) + SOLID + nodes(CORNERS) + BRICK
HELD = "*BOUNDARY_SPC_NODE\n" + "".join(card(n, 0, 1, 1, 1) for n in (1, 2, 3, 4))
IMPLICIT = "*CONTROL_IMPLICIT_GENERAL\n" + card(1, 1.0) + "*CONTROL_IMPLICIT_SOLUTION\n" + card(1)


def brick(*cards, head=HEAD):
    return head + STEEL + BLOCK + "".join(cards) + "*END\n"


class MistakenStructure(CommandTest):
    def said(self, text, severity, code=0):
        """The errors, or warnings, of a deck; the check and a short run must agree on all findings."""
        self.write(text)
        check = self.nugget("check", "model.k", "-o", "checked", expect=code).stderr.splitlines()
        run = self.nugget("run", "model.k", "-o", "out", "--quiet", "--max-cycles", 2, expect=code).stderr.splitlines()
        findings = [line for line in check if line.startswith("model.k")]
        self.assertEqual([line for line in run if line.startswith("model.k")], findings)
        return [line for line in findings if f": {severity}: " in line]

    def one(self, text, severity, *expected, code=0):
        lines = self.said(text, severity, code)
        self.assertEqual(len(lines), 1, lines)
        for part_of_it in expected:
            self.assertIn(part_of_it, lines[0])

    def test_controls_that_stand_twice(self):
        """Sabotage: the last one counts without a word."""
        again = "*CONTROL_TIMESTEP\n" + card(0.0, 0.6)
        self.assertEqual(self.said(brick(again, again), "warning"), [])
        self.one(brick(again, "*CONTROL_TIMESTEP\n" + card(0.0, 0.5)), "warning",
                 "*CONTROL_TIMESTEP: stands a second time, with other lines; first at model.k:")

    def test_loads_and_masses_that_stand_twice(self):
        """Sabotage: they act twice without a word."""
        load = "*LOAD_NODE_POINT\n" + card(5, 3, 77, 1.0)
        ramp = curve(77, (0.0, 1.0), (1.0, 1.0))
        self.assertEqual(self.said(brick(ramp, load, "*LOAD_NODE_POINT\n" + card(6, 3, 77, 1.0)), "warning"), [])
        self.one(brick(ramp, load, load), "warning", "*LOAD_NODE_POINT: this line stands again as at model.k:", "both count")
        self.one(brick(ramp, load + load.splitlines(True)[1]), "warning", "this line stands again as at model.k:")
        mass = "*ELEMENT_MASS\n" + f"{1:8}{5:8}{1e-9:16}\n"
        self.one(brick(mass, mass), "warning", "*ELEMENT_MASS: this line stands again")
        contact = "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n" + card(0) + "\n\n"
        self.one(brick(contact, contact), "warning", "stands with the same lines again as at model.k:")

    def test_stresses_of_what_is_rigid(self):
        """Sabotage: they are left out without a word."""
        stress = "*INITIAL_STRESS_SOLID\n" + card(1, 1) + card(1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 0.0)
        self.assertEqual(self.said(brick(stress), "warning"), [])
        rigid = STEEL.replace("*MAT_ELASTIC", "*MAT_RIGID") + card(0) + "\n"
        self.one(HEAD + rigid + BLOCK + stress + "*END\n", "warning", "*INITIAL_STRESS_SOLID: solid 1 belongs to a rigid part, and has no stress")

    def test_the_same_file_at_two_places_is_no_mistake(self):
        """Lines of other transformations are other lines."""
        self.write("*KEYWORD\n*ELEMENT_MASS\n" + f"{1:8}{1:8}{1e-9:16}\n" + "*END\n", "mass.k")
        twice = "".join("*INCLUDE_TRANSFORM\nmass.k\n" + card(i, i) + "\n\n\n" for i in (0, 1))
        self.assertEqual(self.said(brick(twice), "warning"), [])

    def test_a_keyword_without_a_line(self):
        for keyword in ("*BOUNDARY_SPC_NODE", "*LOAD_NODE_POINT", "*CONTROL_ENERGY", "*DATABASE_GLSTAT"):
            self.one(brick(keyword + "\n"), "warning", keyword + ": no line follows it: it says nothing")
        self.one(brick("*BOUNDARY_SPC_NODE\n\n"), "warning", "no line follows it")
        self.assertEqual(self.said(brick("*CONTROL_ENERGY\n\n"), "warning"), [])  # a card of defaults
        self.assertEqual(self.said(brick("*NODE\n*ELEMENT_SHELL\n"), "warning"), [])  # an empty list, as programs write it

    def test_elements_that_are_there_twice(self):
        twin = "       2       1\n       2       3       4       1       6       7       8       5\n"
        self.one(brick(twin), "warning", "*ELEMENT_SOLID: solid 2 has the part and the nodes of solid 1: both count")
        weld = f"{31:8}{3:8}{301:8}{302:8}{0:8}\n"
        lines = self.said(lap_joint.deck((weld, weld + weld.replace("      31", "      32", 1))), "warning")
        self.assertEqual(sum("beam 32 has the part and the nodes of beam 31" in line for line in lines), 1, lines)

    def test_two_nodes_of_a_shell_at_one_place(self):
        """Sabotage: a side without a length, and two nodes that move apart."""
        place = f"{102:8}{6.0:16.4f}{0.0:16.4f}{0.0:16.4f}"
        lines = self.said(lap_joint.deck((place, place.replace("6.0000", "0.0000"))), "warning")
        self.assertEqual(sum("its nodes 101 and 102 are at one place" in line for line in lines), 1, lines)

    def test_a_belt_without_a_length_and_its_retractor(self):
        """Sabotage: the refused belt has an index, and no place in the list: the program ends by a signal."""
        belt = ("*KEYWORD\n*CONTROL_TERMINATION\n" + card(0.01) + curve(11, (0.0, 0.0), (1.0, 1e5)) + curve(12, (0.0, 200.0), (10.0, 1200.0)) +
                "*MAT_SEATBELT\n" + card(1, 1e-9, 11, 0, 5.0) + "*SECTION_SEATBELT\n" + card(1) + part(1) +
                nodes(((0, 0, 0), (0, 0, 0))) + "*ELEMENT_SEATBELT\n" + f"{1:8}{1:8}{1:8}{2:8}{0:8}{0.0:16}\n" +
                "*ELEMENT_SEATBELT_SENSOR\n" + card(1, 3) + card(1.0) + "*ELEMENT_SEATBELT_RETRACTOR\n" + card(7, 2, 1, 1) +
                card(0.0, 0.0, 12, 0, 20.0) + "*END\n")
        self.one(belt, "error", "*ELEMENT_SEATBELT n2 = 2: both nodes are at one place", code=1)

    def test_a_case_without_a_number(self):
        """Sabotage: the case 0 is asked for, which means each case, without end."""
        for head in ("*CASE\n", "*CASE\n\n"):
            self.write(brick("*CASE_BEGIN_1\n*CASE_END_1\n", head="*KEYWORD\n" + head + "*CONTROL_TERMINATION\n" + card(1e-6)))
            for command in ("run", "check"):
                told = self.nugget(command, "model.k", expect=1).stderr
                self.assertIn("model.k:2:1: error: *CASE: CASEID must be a whole number above 0", told)
                self.assertIn("1 error, 0 warnings", told)

    def test_what_is_defined_without_an_id_is_said_once(self):
        self.one(brick("*DEFINE_CURVE\n"), "error", "lcid", "must be given, but the keyword ends after 0 data line(s)", code=1)
        missing = brick().replace("*PART\npart\n" + card(1, 1, 1), "*PART\npart\n" + card("", 1, 1) + "part\n" + card("", 1, 1))
        lines = self.said(missing, "error", 1)
        self.assertFalse([line for line in lines if "defined twice" in line], lines)

    def test_a_rigid_part_whose_elements_are_refused(self):
        rigid = brick().replace(STEEL, "*MAT_RIGID\n" + card(1, 7.85e-9, 210000.0, 0.3) + "\n\n")
        self.one(rigid.replace(nodes(CORNERS), nodes(CORNERS[:7])), "error", "node 8 is not defined", code=1)

    def test_a_curve_of_steps_below_0(self):
        """Sabotage: time runs backwards."""
        for step in (-1.0, 0.0):
            steps = curve(80, (0.0, step), (1.0, step)) + "*CONTROL_TIMESTEP\n" + card(0.0, 0.9, 0, 0, 0.0, 80)
            self.one(brick(steps), "error", "lctm = 80: a largest time step of this curve is not above 0", code=1)

    def test_a_run_that_would_have_no_end(self):
        """Sabotage: a step of 1e-150 is no 0, and the run goes on for ever."""
        spring = ("*KEYWORD\n*CONTROL_TERMINATION\n" + card(1.0) + "*MAT_074\n" + card(1, "1e-300", 100.0) + "\n*SECTION_BEAM\n" +
                  card(1, 6, 1.0, 2) + card(1e-3, 1e-3) + part(1) + nodes(((0, 0, 0), (3, 4, 0))) +
                  "*ELEMENT_BEAM\n" + "".join(f"{v:8}" for v in (1, 1, 1, 2)) + "\n*INITIAL_VELOCITY_NODE\n" + card(2, 1.0) + "*END\n")
        self.write(spring)
        said = self.nugget("run", "model.k", "-o", "out", "--quiet", expect=3).stderr
        self.assertRegex(said, r"the time step \S+ of beam 1 of part 1 would take \S+ cycles to the end time 1")
        self.assertRegex(self.nugget("check", "model.k", "-o", "checked", expect=1).stderr,
                         r"model\.k:5: error: a run would have no end: the time step \S+ of beam 1 of part 1")
        self.nugget("run", "model.k", "-o", "out", "--quiet", "--max-cycles", 3)
        self.write(spring.replace(card(1.0), card(1.0, 5), 1))
        self.nugget("run", "model.k", "-o", "out", "--quiet")

    def test_the_last_balance_counts(self):
        """Sabotage: a run whose external work is no number ends normally, with energies of null in summary.json."""
        pushed = curve(77, (0.0, 0.0), (1.0, 0.0)) + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + card(5, 3, 0, 77, 1.0)
        self.write(brick("*CONTROL_TIMESTEP\n" + card(1e-8, 0.9), pushed.replace(f"{0.0:20}\n{1.0:20}", f"{'1e300':>20}\n{1.0:20}"),
                         head="*KEYWORD\n*CONTROL_TERMINATION\n" + card(1e-8)))
        self.nugget("run", "model.k", "-o", "out", "--quiet", expect=3)
        self.assertEqual(self.json("out/summary.json")["termination"], "error")

    def test_a_contact_that_is_refused_is_the_only_fault(self):
        self.write(lap_joint.deck(("*CONTACT_SPOTWELD\n", "*CONTACT_SPOTWELD_WITH_TORSON\n")))
        told = self.nugget("check", "model.k", expect=1).stderr
        self.assertIn("[is it *CONTACT_SPOTWELD_WITH_TORSION?]", told)
        self.assertNotIn("no contact tracks it", told)
        self.assertIn("1 weld, none has a sheet: *CONTACT_SPOTWELD_WITH_TORSON is refused", told)

    def test_energies_that_the_deck_would_leave_out(self):
        step = "*CONTROL_TIMESTEP\n" + card(0.0, 0.6)
        self.assertEqual(self.said(brick(step, "*CONTROL_ENERGY\n" + card(1, 2, 2, 2)), "note"), [])
        self.one(brick(step, "*CONTROL_ENERGY\n" + card(2, 2, 1)), "note", "*CONTROL_ENERGY slnten = 1: not obeyed: it is computed")


class LinearAnalyses(CommandTest):
    """What `nugget run` refuses of a linear analysis, `nugget check` refuses with the same findings."""

    def both(self, text, code=1):
        self.write(text)
        check = self.nugget("check", "model.k", "-o", "checked", expect=code).stderr
        run = self.nugget("run", "model.k", "-o", "out", "--quiet", expect=code).stderr
        findings = [line for line in check.splitlines() if line.startswith("model.k")]
        self.assertEqual([line for line in run.splitlines() if line.startswith("model.k")], findings)
        return "\n".join(findings)

    def test_motions_against_supports(self):
        """Sabotage: the check does not look, and the statics of a preload takes one of both without a word."""
        drive = curve(77, (0.0, 0.0), (1e-6, 1.0)) + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + card(1, 1, 2, 77, 1.0)
        statics = brick(HELD, drive, IMPLICIT)
        modes = curve(80, (0.0, 0.0), (1e-6, 2.0)) + "*CONTROL_IMPLICIT_EIGENVALUE\n" + card(-80) + "*END\n"
        preloaded = statics.replace("*END\n", modes).replace(card(1, 1.0), card(1, 1.0, 0, 0, 1))
        for deck in (statics, preloaded):
            self.assertIn("it drives a node in a direction that an SPC or another motion prescribes otherwise", self.both(deck))

    def test_welds_of_a_refused_deck(self):
        """Sabotage: the check knows of the welds, and the run of a linear analysis does not."""
        cards = IMPLICIT + "*CONTROL_IMPLICIT_EIGENVALUE\n" + card(3)
        found = self.both(lap_joint.deck(("*DATABASE_GLSTAT\n", cards + "*DATABASE_GLSTAT\n"),
                                         ("  7.85e-09  210000.0       0.3     300.0", "  7.85e-09        1e       0.3     300.0")))
        self.assertIn("1 weld, each on two sheets", found)

    def test_modes_behind_a_run_are_refused_before_it(self):
        """Sabotage: rivets are no part of linear analyses, which shows when the run of hours is over."""
        after = ("*CONTROL_IMPLICIT_GENERAL\n" + card(6, 1.0) + "*CONTROL_IMPLICIT_EIGENVALUE\n" + card(-5) +
                 curve(5, (0.0, 0.0), (1e-6, 3.0)))
        self.write(brick(HELD, after))
        self.nugget("run", "model.k", "-o", "sound", "--quiet")
        self.assertIn("modes", self.files("sound"))
        self.assertIn("rivets are not built in linear analyses", self.both(brick(HELD, after, "*CONSTRAINED_RIVET\n" + card(5, 6))))
        self.assertNotIn("glstat", self.files("out"))


class Responses(CommandTest):
    def deck(self, modes, first, last=0, highest=1e6):
        return brick(HELD, IMPLICIT, "*CONTROL_IMPLICIT_EIGENVALUE\n" + card(modes) + "*FREQUENCY_DOMAIN_FRF\n" +
                     card(5, 0, 3, 3, 0, 0.0, first, last) + card(0.02) + card(6, 0, 3, 2) + card(1.0, highest, 3))

    def test_a_first_mode_that_is_not_asked_for(self):
        """Sabotage: no mode takes part, and the run ends normally."""
        self.write(self.deck(3, 4))
        for command in ("check", "run"):
            self.assertIn("mdmin = 4: no mode is left: NEIG of *CONTROL_IMPLICIT_EIGENVALUE asks for 3",
                          self.nugget(command, "model.k", "-o", command, expect=1).stderr)

    def test_a_first_mode_that_is_not_there(self):
        """The brick on its held face has twelve modes."""
        self.write(self.deck(40, 20))
        self.assertIn("no mode is left for the response: of the 12 that were found",
                      self.nugget("run", "model.k", "-o", "out", "--quiet", expect=3).stderr)
        summary = self.json("out/summary.json")
        self.assertEqual((summary["termination"], len(summary["modes"])), ("error", 12))

    def test_frequencies_beyond_the_modes(self):
        """A finding, not only a line of the log; none where all modes up to there take part."""
        for last, said in ((1, 1), (0, 0)):
            self.write(self.deck(12, 0, last))
            told = self.nugget("run", "model.k", "-o", "out", "--quiet").stderr
            self.assertEqual(told.count("the response is asked for up to 1e+06"), said, told)
            texts = [f["text"] for f in self.json("out/findings.json") if f["severity"] == "warning"]
            self.assertEqual(sum("it is doubtful above" in t for t in texts), said, texts)


if __name__ == "__main__":
    unittest.main()
