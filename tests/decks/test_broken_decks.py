# SPDX-License-Identifier: Apache-2.0
"""What a user sees of a broken deck: each line of standard error, the exit code, findings.json. The texts are kept whole,
so that a change to any of them is seen and judged."""
import unittest

from few_elements import card
from lap_joint import deck
from nugget_command import CommandTest, line_of

CORNERS = ((30, 0, 0), (36, 0, 0), (36, 6, 0), (30, 6, 0), (30, 0, 6), (36, 0, 6), (36, 6, 6), (30, 6, 6))
BRICK_UPSIDE_DOWN = (
    "*PART\nblock\n         4         4         4\n*SECTION_SOLID\n         4         1\n"
    "*MAT_ELASTIC\n         4  7.85e-09  210000.0       0.3\n*NODE\n"
    + "".join(f"{401 + i:8d}{x:16.1f}{y:16.1f}{z:16.1f}\n" for i, (x, y, z) in enumerate(CORNERS))
    + "*ELEMENT_SOLID\n      41       4     405     406     407     408     401     402     403     404\n")
RESULTS_OF_A_RUN = {"summary.json", "glstat", "d3plot", "d3plot01", "swforc"}


class BrokenDecks(CommandTest):
    def check(self, exit_code, changes, lines):
        """Runs the lap joint with the changes made: `lines`, and of a refused deck what is known of its welds behind the findings, without
        another error. `nugget check` must say the same."""
        self.write(deck(*changes))
        told = self.nugget("run", "model.k", "--quiet", "-j", 1, expect=exit_code).stderr.splitlines()
        findings = [line for line in lines if line.startswith("model.k:")]
        of_welds = [line for line in told if line.startswith("model.k:")][len(findings):]
        if exit_code == 1:
            self.assertFalse([line for line in of_welds if ": error: " in line])
            count = lines[-2].split(",")[0]
            self.assertTrue(told[-2].startswith(count + ","), told)
            self.assertEqual([line for line in told if line not in of_welds and line != told[-2]], lines[:-2] + lines[-1:])
        else:
            self.assertEqual(told, lines)
        self.assertEqual(told[:len(findings)], findings)
        self.assertEqual([line_of(f) for f in self.json("findings.json")], findings + of_welds)
        log = self.read("run.log")
        for line in findings + of_welds:
            self.assertIn(line, log)
        self.assertEqual(RESULTS_OF_A_RUN & set(self.files()), set() if exit_code == 1 else RESULTS_OF_A_RUN)
        end = " E r r o r   t e r m i n a t i o n\n" if exit_code == 1 else " N o r m a l    t e r m i n a t i o n\n"
        self.assertTrue(log.endswith(end), log[-200:])

        checked = self.nugget("check", "model.k", "-o", "checked", expect=exit_code).stderr.splitlines()
        self.assertEqual([line for line in checked if line.startswith("model.k:")], findings + of_welds)

    def test_the_deck_itself_is_sound(self):
        self.check(0, [], [
            "model.k:48:1: note: *CONTACT_SPOTWELD 1: 2 nodes tied, none of them moved",
            "model.k: note: *CONTACT_SPOTWELD: no torsion in 1 weld beam: the shells have no stiffness about their "
            "normal to hold it [*CONTACT_SPOTWELD_WITH_TORSION turns it into in-plane forces]",
        ])

    def test_missing_include(self):
        """An include file that is not there."""
        self.check(1, [
            ("*DEFINE_CURVE\n", "*INCLUDE\nbarrier/wall.k\n*DEFINE_CURVE\n"),
        ], [
            "model.k:56: error: *INCLUDE: cannot find the file 'barrier/wall.k'; looked in . [put the file into "
            "one of these folders, or name its folder with *INCLUDE_PATH]",
            "1 error, 0 warnings",
            "the deck is refused; nothing was run",
        ])

    def test_a_deck_without_a_model(self):
        """A small restart deck of LS-DYNA, or one whose mesh is not included: nothing would move, and the run would end normally."""
        self.write("*KEYWORD\n*CONTROL_TERMINATION\n" + card(2.0) + "*END\n")
        for command in ("run", "check"):
            told = self.nugget(command, "model.k", expect=1).stderr
            self.assertIn("model.k: error: there are no nodes: nothing can move [include the mesh;", told)

    def test_what_a_missing_file_may_define_is_counted(self):
        """Nodes, a curve and a material that are not in the deck, and a fault that no file can mend."""
        self.write(deck(("*DEFINE_CURVE\n", "*INCLUDE\nbarrier/wall.k\n*BOUNDARY_SPC_NODE\n" + card(901, 0, 1) + card(902, 0, 1) + card(903, 0, 1) +
                         "*LOAD_NODE_POINT\n" + card(1, 1, 77, 1.0) + "*DEFINE_CURVE\n"),
                        ("  7.85e-09  210000.0       0.3     300.0", "  7.85e-09        1e       0.3     300.0")))
        errors = [line for line in self.nugget("check", "model.k", expect=1).stderr.splitlines() if "error" in line]
        self.assertIn("cannot find the file 'barrier/wall.k'", errors[0])
        self.assertIn("e = 1e: is not a number", errors[1])
        self.assertIn("node 901 is not defined", errors[2])
        self.assertEqual(errors[3], "and 4 more errors that something is not defined, at lines 59, 60, 62: the missing file may hold it "
                                    "[put the file in place first; findings.json has each]")
        self.assertEqual(errors[4:], ["7 errors, 0 warnings"])
        texts = [finding["text"] for finding in self.json("findings.json") if finding["severity"] == "error"]
        self.assertEqual(sum("is not defined" in text for text in texts), 5)

    def test_a_thickness_that_is_no_number_says_nothing_of_the_ties(self):
        self.write(deck(("       1.2       1.2       1.2       1.2", "       1x2       1.2       1.2       1.2")))
        told = self.nugget("check", "model.k", expect=1).stderr.splitlines()
        self.assertIn("t1 = 1x2: is not a number", told[0])
        self.assertEqual([line for line in told if "warning" in line], ["1 error, 0 warnings"])

    def test_cut_number(self):
        """A number cut off by the end of its column."""
        self.check(1, [
            ("  7.85e-09  210000.0       0.3     300.0", "  7.85e-09        1e       0.3     300.0"),
        ], [
            "model.k:38:29: error: *MAT_PIECEWISE_LINEAR_PLASTICITY e = 1e: is not a number (Young's modulus) "
            "[keep the number whole inside its columns, or separate the fields by commas]",
            "1 error, 0 warnings",
            "the deck is refused; nothing was run",
        ])

    def test_a_bad_number_is_told_once(self):
        """No number for the side of a contact: not that it must be given, too."""
        self.check(1, [
            ("*CONTACT_SPOTWELD\n         3         1", "*CONTACT_SPOTWELD\n       3;5         1"),
        ], [
            "model.k:49:8: error: *CONTACT_SPOTWELD surfa = 3;5: is not a whole number (tracked side (SSID); 0 in a single surface "
            "contact: all parts) [keep the number whole inside its columns, or separate the fields by commas]",
            "1 error, 0 warnings",
            "the deck is refused; nothing was run",
        ])

    def test_unknown_ids(self):
        """Ids of nothing: section, material, node set, node of a shell."""
        self.check(1, [
            ("     102     103     107     106", "     102     103     107     999"),
            ("         1         0         1         1         1         1         1         1",
             "         9         0         1         1         1         1         1         1"),
            ("         3         3         3\n", "         3         3         8\n"),
            ("         1         1         1\n*PART", "         1         7         1\n*PART"),
        ], [
            "model.k:107: error: *ELEMENT_SHELL: shell 11: node 999 is not defined [define it by *NODE, or correct its number]",
            "model.k:27:20: error: *PART secid = 7: section 7 is not defined",
            "model.k:33:30: error: *PART mid = 8: material 8 is not defined",
            "model.k:63:10: error: *BOUNDARY_SPC_SET nsid = 9: node set 9 is not defined",
            "4 errors, 0 warnings",
            "the deck is refused; nothing was run",
        ])

    def test_unsupported(self):
        """Five kinds of physics that are not built, all told in one go."""
        self.check(1, [
            ("*SECTION_BEAM\n",
             "*ALE_REFERENCE_SYSTEM\n         1\n*EM_CONTROL\n         1\n*AIRBAG_HYBRID\n"
             "         1\n*CONTROL_THERMAL_SOLVER\n         1\n*ICFD_CONTROL_TIME\n         1\n*SECTION_BEAM\n"),
        ], [
            "model.k:42:1: error: *ALE_REFERENCE_SYSTEM: fluids and large distortions by ALE are not built "
            "[remove it, or run with --skip-unsupported to leave such cards out at your own risk]",
            "model.k:44:1: error: *EM_CONTROL: electromagnetics are not built [remove it, or run with "
            "--skip-unsupported to leave such cards out at your own risk]",
            "model.k:46:1: error: *AIRBAG_HYBRID: this gas of airbags is not built; "
            "built are *AIRBAG_ADIABATIC_GAS_MODEL, _SIMPLE_AIRBAG_MODEL, _SIMPLE_PRESSURE_VOLUME and _WANG_NEFSKE "
            "[remove it, or run with --skip-unsupported to leave such cards out at your own risk]",
            "model.k:48:1: error: *CONTROL_THERMAL_SOLVER: heat conduction is not built [remove it, or run with "
            "--skip-unsupported to leave such cards out at your own risk]",
            "model.k:50:1: error: *ICFD_CONTROL_TIME: fluid flow is not built [remove it, or run with "
            "--skip-unsupported to leave such cards out at your own risk]",
            "5 errors, 0 warnings",
            "the deck is refused; nothing was run",
        ])

    def test_refused_law(self):
        """A law that is not built: the parts that use it are not told that it is undefined."""
        self.check(1, [
            ("*MAT_PIECEWISE_LINEAR_PLASTICITY\n", "*MAT_HILL_90\n"),
        ], [
            "model.k:37:1: error: *MAT_HILL_90: this law is not built; *MAT_3-PARAMETER_BARLAT comes "
            "nearest [remove it, or run with --skip-unsupported to leave such cards out at your own risk]",
            "1 error, 0 warnings",
            "the deck is refused; nothing was run",
        ])

    def test_garbage(self):
        """Letters where a number belongs, a shell with half its nodes."""
        self.check(1, [
            ("       0.0       0.9\n", "       0.0       0.9         0         x\n"),
            ("     103     104     108     107\n", "     103     104\n"),
        ], [
            "model.k:7:40: error: *CONTROL_TIMESTEP tslimt = x: is not a number (softening of shells to hold a "
            "time step: not built; above 0 beside dt2ms: no effect) [write a number there, or leave the field blank for its default]",
            "model.k:108: error: *ELEMENT_SHELL: shell 12: its corners are nodes 103 104 0 0, expected three or "
            "four different ones in sequence [remove it or correct its nodes]",
            "model.k: note: *NODE: node 104 belongs to no element, mass or rigid body",
            "2 errors, 0 warnings",
            "the deck is refused; nothing was run",
        ])

    def test_surplus_column(self):
        """More columns than the card has."""
        self.check(1, [
            ("       6.0       6.0       0.0       0.0\n", "6.0,6.0,0.0,0.0,0.0,0.0,7.0,8.0,9.0\n"),
        ], [
            "model.k:44:25: error: *SECTION_BEAM itoff = 7.0: expected 0 to 1 (1: no torsional stiffness)",
            "model.k:44:29: warning: *SECTION_BEAM: '8.0,9.0' stands behind the last field of this card and is "
            "not read [remove it; check that the card has its right form]",
            "1 error, 1 warning",
            "the deck is refused; nothing was run",
        ])

    def test_surplus_row(self):
        """More rows than the keyword has."""
        self.check(1, [
            ("         0         0         0         0         1\n",
             "         0         0         0         0         1\n       0.0\n       0.0\n       0.0\n"
             "       0.0\n"),
        ], [
            "model.k:16: error: *CONTROL_CONTACT: more data lines than this keyword has cards [remove them, or "
            "give the next definition its own keyword line]",
            "1 error, 0 warnings",
            "the deck is refused; nothing was run",
        ])

    def test_negative_thickness(self):
        """A negative thickness: said at its field, not again at each shell."""
        self.check(1, [
            ("       1.2       1.2       1.2       1.2", "      -1.2      -1.2      -1.2      -1.2"),
        ], [
            "model.k:36:7: error: *SECTION_SHELL t1 = -1.2: expected 0 or more (thickness at node 1)",
            "model.k:36:17: error: *SECTION_SHELL t2 = -1.2: expected 0 or more (thickness at node 2; 0: t1)",
            "model.k:36:27: error: *SECTION_SHELL t3 = -1.2: expected 0 or more (thickness at node 3; 0: t1)",
            "model.k:36:37: error: *SECTION_SHELL t4 = -1.2: expected 0 or more (thickness at node 4; 0: t1)",
            "4 errors, 0 warnings",
            "the deck is refused; nothing was run",
        ])

    def test_untied0(self):
        """A weld in the air, SPOTSTP 0: runs with its end free."""
        self.check(0, [
            ("         0         0         0         0         1\n",
             "         0         0         0         0         0\n"),
            ("     302          9.0000          9.0000          1.2000",
             "     302          9.0000          9.0000          9.0000"),
        ], [
            "model.k:125: warning: *ELEMENT_BEAM: beam weld 31: node 302 at (9, 9, 9): no segment in reach: the "
            "closest, shell 24 of part 2, is 7.8 away, tolerance 4.32, not tied [move the weld to its sheet, or "
            "give SAST = SBST = -6.83 in the contact (tolerance 8.19)]",
            "model.k:12:50: warning: *CONTROL_CONTACT spotstp = 0: beam weld 31 is not tied; it is kept, with "
            "free ends [the warnings on the welds say why; free ends carry no load and may fly off: SPOTSTP = 2 "
            "deletes such welds]",
            "model.k:48:1: note: *CONTACT_SPOTWELD 1: 1 node tied, none of them moved",
            "model.k:125: warning: *ELEMENT_BEAM: beam weld 31: on one sheet only, part 1 (expected: the two "
            "ends are on two different sheets) [see why the other end is not tied]",
            "model.k: note: *CONTACT_SPOTWELD: no torsion in 1 weld beam: the shells have no stiffness about "
            "their normal to hold it [*CONTACT_SPOTWELD_WITH_TORSION turns it into in-plane forces]",
            "0 errors, 3 warnings",
            "warning: 1 of 1 welds are not tied to their sheets and hold nothing [welds.csv says which and why]",
        ])

    def test_untied1(self):
        """A weld in the air, SPOTSTP 1: refused."""
        self.check(1, [
            ("     302          9.0000          9.0000          1.2000",
             "     302          9.0000          9.0000          9.0000"),
        ], [
            "model.k:125: warning: *ELEMENT_BEAM: beam weld 31: node 302 at (9, 9, 9): no segment in reach: the "
            "closest, shell 24 of part 2, is 7.8 away, tolerance 4.32, not tied [move the weld to its sheet, or "
            "give SAST = SBST = -6.83 in the contact (tolerance 8.19)]",
            "model.k:12:50: error: *CONTROL_CONTACT spotstp = 1: beam weld 31 is not tied [the warnings on the "
            "welds say why; SPOTSTP = 2 would delete such welds, 0 and 3 keep them]",
            "model.k:48:1: note: *CONTACT_SPOTWELD 1: 1 node tied, none of them moved",
            "model.k:125: warning: *ELEMENT_BEAM: beam weld 31: on one sheet only, part 1 (expected: the two "
            "ends are on two different sheets) [see why the other end is not tied]",
            "model.k: note: *CONTACT_SPOTWELD: no torsion in 1 weld beam: the shells have no stiffness about their "
            "normal to hold it [*CONTACT_SPOTWELD_WITH_TORSION turns it into in-plane forces]",
            "1 error, 2 warnings",
            "the deck is refused; nothing was run",
        ])

    def test_ties_do_not_hide_what_lies_behind_them(self):
        """A weld in the air with SPOTSTP 1, found when welds are tied, and a contact of nothing, found when it is set up."""
        self.write(deck(
            ("     302          9.0000          9.0000          1.2000",
             "     302          9.0000          9.0000          9.0000"),
            ("*SET_PART_LIST\n", "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n" + card(3, 0, 3) + "\n\n*SET_PART_LIST\n")))
        for command in ("run", "check"):
            with self.subTest(command):
                lines = self.nugget(command, "model.k", "-j", 1, expect=1).stderr.splitlines()
                errors = [line for line in lines if ": error: " in line]
                self.assertEqual(len(errors), 2)
                self.assertIn("spotstp = 1: beam weld 31 is not tied", errors[0])
                self.assertIn("model.k:52:1: error: *CONTACT_AUTOMATIC_SINGLE_SURFACE: the contact has no segments", errors[1])

    def test_untied2(self):
        """A weld in the air, SPOTSTP 2: runs without the weld."""
        self.check(0, [
            ("         0         0         0         0         1\n",
             "         0         0         0         0         2\n"),
            ("     302          9.0000          9.0000          1.2000",
             "     302          9.0000          9.0000          9.0000"),
        ], [
            "model.k:125: warning: *ELEMENT_BEAM: beam weld 31: node 302 at (9, 9, 9): no segment in reach: the "
            "closest, shell 24 of part 2, is 7.8 away, tolerance 4.32, not tied [move the weld to its sheet, or "
            "give SAST = SBST = -6.83 in the contact (tolerance 8.19)]",
            "model.k:12:50: warning: *CONTROL_CONTACT spotstp = 2: beam weld 31 is not tied; it is deleted [the "
            "warnings on the welds say why]",
            "0 errors, 2 warnings",
            "warning: 1 of 1 welds are not tied to their sheets and hold nothing [welds.csv says which and why]",
        ])

    def test_misspelt(self):
        """Two slips of the pen, one of them swapped letters."""
        self.check(1, [
            ("*MAT_SPOTWELD\n", "*MAT_SPOTWLED\n"),
            ("*BOUNDARY_SPC_SET\n", "*BOUNDRY_SPC_SET\n"),
        ], [
            "model.k:45:1: error: *MAT_SPOTWLED: this material is not built; `nugget keywords MAT_` lists what is built "
            "[is it *MAT_SPOTWELD?]",
            "model.k:62:1: error: *BOUNDRY_SPC_SET: not a keyword that this program knows [is it "
            "*BOUNDARY_SPC_SET?]",
            "2 errors, 0 warnings",
            "the deck is refused; nothing was run",
        ])

    def test_duplicate(self):
        """Ids given twice: part, node, shell."""
        self.check(1, [
            ("*DEFINE_CURVE\n", "*PART\nanother\n         2         1         1\n*DEFINE_CURVE\n"),
            ("      12       1     103", "      11       1     103"),
            ("     105          0.0000          6.0000", "     104          0.0000          6.0000"),
        ], [
            "model.k:57: error: *PART: part 2 is defined twice; first at model.k:30 [give one of them another id]",
            "model.k:78: error: *NODE: node 104 is defined twice; first at model.k:77 [give one of them another "
            "id]",
            "model.k:111: error: *ELEMENT_SHELL: shell 11 is defined twice; first at model.k:110 [give one of "
            "them another id]",
            "model.k:109: error: *ELEMENT_SHELL: shell 10: node 105 is not defined [define it by *NODE, or correct its number]",
            "model.k:112: error: *ELEMENT_SHELL: shell 13: node 105 is not defined [define it by *NODE, or correct its number]",
            "model.k:69: error: *SET_NODE_LIST: node 105 is not defined [remove it from the set, or define it]",
            "model.k: note: *NODE: 2 nodes belong to no element, mass or rigid body; the first is node 101",
            "6 errors, 0 warnings",
            "the deck is refused; nothing was run",
        ])

    def test_one_sheet(self):
        """A contact that names one of the two sheets only."""
        self.check(1, [
            ("         1         2\n*DEFINE", "         1\n*DEFINE"),
        ], [
            "model.k:125: warning: *ELEMENT_BEAM: beam weld 31: node 302 at (9, 9, 1.2): the only sheet in "
            "reach, with shell 14 of part 1, holds the weld's other end, not tied [put the other sheet's part on "
            "the reference side (SURFB) of the contact]",
            "model.k:12:50: error: *CONTROL_CONTACT spotstp = 1: beam weld 31 is not tied [the warnings on the "
            "welds say why; SPOTSTP = 2 would delete such welds, 0 and 3 keep them]",
            "model.k:48:1: note: *CONTACT_SPOTWELD 1: 1 node tied, none of them moved",
            "model.k:125: warning: *ELEMENT_BEAM: beam weld 31: on one sheet only, part 1 (expected: the two "
            "ends are on two different sheets) [see why the other end is not tied]",
            "model.k: note: *CONTACT_SPOTWELD: no torsion in 1 weld beam: the shells have no stiffness about their "
            "normal to hold it [*CONTACT_SPOTWELD_WITH_TORSION turns it into in-plane forces]",
            "1 error, 2 warnings",
            "the deck is refused; nothing was run",
        ])

    def test_poisson(self):
        """A Poisson's ratio that no material has."""
        self.check(1, [
            ("         1  7.85e-09  210000.0       0.3", "         1  7.85e-09  210000.0       0.7"),
        ], [
            "model.k:38:38: error: *MAT_PIECEWISE_LINEAR_PLASTICITY pr = 0.7: expected 0 to 0.5 (Poisson's ratio)",
            "1 error, 0 warnings",
            "the deck is refused; nothing was run",
        ])

    def test_inverted(self):
        """A brick with its bottom on top."""
        self.check(1, [
            ("*END\n", BRICK_UPSIDE_DOWN + "*END\n"),
        ], [
            "model.k:143: error: *ELEMENT_SOLID: solid 41 has the volume -216, expected more than 0 (negative "
            "Jacobian) [number its nodes 1-4 around the bottom and 5-8 above them, seen from inside right-handed]",
            "1 error, 0 warnings",
            "the deck is refused; nothing was run",
        ])

    def test_no_section(self):
        """A part without section, and one without material too."""
        self.check(1, [
            ("         2         1         1\n*PART", "         2         0         1\n*PART"),
            ("         3         3         3\n", "         3\n"),
        ], [
            "model.k:30:20: error: *PART: part 2 has elements, but no section [give their ids in SECID and MID]",
            "model.k:33:11: error: *PART: part 3 has elements, but no section and no material [give their ids in "
            "SECID and MID]",
            "2 errors, 0 warnings",
            "the deck is refused; nothing was run",
        ])

    def test_no_end(self):
        """No end time."""
        self.check(1, [
            ("*CONTROL_TERMINATION\n  2.00e-05\n", ""),
        ], [
            "model.k: error: *CONTROL_TERMINATION: no end time is given [give ENDTIM, the time up to which is to "
            "be computed]",
            "1 error, 0 warnings",
            "the deck is refused; nothing was run",
        ])

    def test_a_weld_of_an_empty_set(self):
        """Found by a deck of ones: it read the last node of none. Sabotage: the count after the axis."""
        run = self.refused(("*SECTION_BEAM\n", "*SET_NODE_LIST\n        77\n*CONSTRAINED_GENERALIZED_WELD_SPOT\n        77\n"
                                               "\n*SECTION_BEAM\n"))
        self.assertIn("nsid = 77: a weld joins two nodes or more [add nodes to the set]", run)

    def test_more_points_announced_than_lines(self):
        """Found by a deck of ids: it counted to 2^31. Sabotage: the product of the two counts as an int, 0 here."""
        for announced in ("*INITIAL_STRESS_SOLID\n         12147483647", "*INITIAL_STRESS_SHELL\n         1     65536     65536",
                          "*INITIAL_STRAIN_SHELL\n         1     65536     65536"):
            run = self.refused(("*SECTION_BEAM\n", announced + "\n*SECTION_BEAM\n"))
            self.assertIn("points are announced, but the keyword has only 1 lines", run)

    def test_glue_by_a_curve_without_points(self):
        """Found by mutations: the last point of none was read. Sabotage: no look at the number of points."""
        glue = "*DEFINE_CURVE\n        88\n*CONTACT_TIEBREAK_SURFACE_TO_SURFACE\n" + 3 * ("1".rjust(10) + "2".rjust(10) + "\n")
        run = self.refused(("*SECTION_BEAM\n", glue + "      10.0      10.0        88\n*SECTION_BEAM\n"))
        self.assertIn("curve 88 has no points", run)

    def test_foam_by_a_curve_without_points(self):
        for user in ("*MAT_LOW_DENSITY_FOAM\n        89   1.0e-10       2.0        88\n\n",
                     "*MAT_CRUSHABLE_FOAM\n        89   1.0e-10       2.0       0.0        88\n"):
            run = self.refused(("*SECTION_BEAM\n", "*DEFINE_CURVE\n        88\n" + user + "*SECTION_BEAM\n"))
            self.assertIn("curve 88 has no points", run)

    def test_a_weld_almost_without_diameter(self):
        """Found by mutations: the account of a refused deck's welds threw at a diameter of 5e-309. Sabotage: std::stod."""
        run = self.refused(("       6.0       6.0       0.0       0.0", "    1e-308       0.0       0.0       0.0"),
                           ("*SECTION_BEAM\n", "*ALE_REFERENCE_SYSTEM\n         1\n*SECTION_BEAM\n"))
        self.assertIn("ALE are not built", run)

    def refused(self, *changes):
        self.write(deck(*changes))
        return self.nugget("check", "model.k", expect=1).stderr

    def test_nothing_in_it(self):
        self.write("")
        run = self.nugget("run", "model.k", expect=1)
        self.assertEqual(run.stderr.splitlines(), [
            "model.k: error: the file has no keyword [an LS-DYNA keyword deck starts with *KEYWORD]",
            "1 error, 0 warnings",
            "nothing was run; no file was changed",
        ])

    def test_a_wrong_name_leaves_earlier_results_alone(self):
        self.write(deck())
        self.nugget("run", "model.k", "--quiet")
        before = {name: (self.folder / name).read_bytes() for name in self.files()}
        run = self.nugget("run", "mdoel.k", expect=1)
        self.assertEqual(run.stderr.splitlines(), [
            "mdoel.k: error: cannot read the deck: No such file or directory [check the name of the file]",
            "1 error, 0 warnings",
            "nothing was run; no file was changed",
        ])
        self.assertEqual(before, {name: (self.folder / name).read_bytes() for name in self.files()})

    def test_skip_unsupported_leaves_out_what_nothing_needs(self):
        self.write(deck(("*SECTION_BEAM\n", "*ALE_REFERENCE_SYSTEM\n         1\n*SECTION_BEAM\n")))
        run = self.nugget("run", "model.k", "--skip-unsupported", "--quiet")
        self.assertEqual(run.stderr.splitlines(), [
            "model.k:42:1: warning: *ALE_REFERENCE_SYSTEM: fluids and large distortions by ALE are not built; the cards are "
            "left out",
            "model.k:50:1: note: *CONTACT_SPOTWELD 1: 2 nodes tied, none of them moved",
            "model.k: note: *CONTACT_SPOTWELD: no torsion in 1 weld beam: the shells have no stiffness about their "
            "normal to hold it [*CONTACT_SPOTWELD_WITH_TORSION turns it into in-plane forces]",
            "0 errors, 1 warning",
        ])

    def test_skip_unsupported_cannot_leave_out_what_the_model_needs(self):
        self.write(deck(("*MAT_PIECEWISE_LINEAR_PLASTICITY\n", "*MAT_HILL_90\n")))
        run = self.nugget("run", "model.k", "--skip-unsupported", expect=1)
        self.assertEqual(run.stderr.splitlines()[1:3], [
            f"model.k:{line}:30: error: *PART mid = 1: material 1 is left out, as *MAT_HILL_90 is not "
            "supported [define it by a supported keyword, or remove what needs it]" for line in (27, 30)
        ])


if __name__ == "__main__":
    unittest.main()
