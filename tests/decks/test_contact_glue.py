# SPDX-License-Identifier: Apache-2.0
"""Contacts that glue (TIEBREAK, ties that fail or begin later), by what they do to two small plates."""
import unittest

from contact_models import LOWER, SIDE, UPPER, ContactTest, plate, plates, sliding
from writer import Deck


class Glue(ContactTest):
    def test_glue_holds_to_its_strength_in_tension_and_shear(self):
        """Sabotage: the area of the segment instead of the node's; glue on both sides."""
        for dof, strength, component in ((3, "nfls", 3), (1, "sfls", 1)):
            glue = {"option": 2, "nfls": 0.0, "sfls": 0.0, strength: 10.0}
            text = plates(sliding("AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK", **glue), {dof: 30.0}, 2.0e-4)
            self.run_deck(text)
            force = [abs(row[component]) for row in self.rows()]
            self.assertAlmostEqual(max(force) / (10.0 * SIDE * SIDE), 1.0, delta=0.05)
            self.assertEqual(force[-1], 0.0)

    def test_glue_tells_what_it_holds(self):
        """Findings and run.log. Sabotage: the first failure's time is the last one's; no warning where nothing touches."""
        glued = "AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK"
        said = self.run_deck(plates(sliding(glued, option=3, nfls=10.0, sfls=10.0), {3: 30.0, 1: 10.0}, 2.0e-4))
        self.assertIn("25 nodes of SURFA are glued to SURFB at the start", said.stdout + said.stderr + self.read("run.log"))
        events = self.read("run.log").split("Events")[1]
        self.assertRegex(events, r"glue of contact 1: 25 nodes at the start, 0 later; 25 failed, node \d+ first at time=\S+, the last at")

    def glued_block(self, side, form="AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK_ID"):
        """A block of 10 x 10 x 5 (bricks of 2.5) on a plate of 6 x 6 shells, glued with 20 MPa that fall to nothing over
        0.05 mm, and drawn off slowly: the energy that the glue takes up."""
        text = "*KEYWORD\n*CONTROL_TERMINATION\n    1.0E-3\n*CONTROL_TIMESTEP\n                 0.6\n"
        text += "*PART\nblock\n         1         1         1\n*PART\nplate\n         2         2         1\n"
        text += "*SECTION_SOLID\n         1         2\n*SECTION_SHELL\n         2         2\n       1.0\n"
        text += "*MAT_ELASTIC\n         1  7.85E-09  210000.0       0.3\n*NODE\n"
        at = {}
        for k in range(3):
            for j in range(5):
                for i in range(5):
                    at[i, j, k] = len(at) + 1
                    text += f"{len(at):8}{2.5 * i:16}{2.5 * j:16}{0.5 + 2.5 * k:16}\n"
        for j in range(7):
            for i in range(7):
                text += f"{101 + 7 * j + i:8}{-5 + 20 * i / 6:16.9f}{-5 + 20 * j / 6:16.9f}{0.0:16}\n"
        text += "*ELEMENT_SOLID\n"
        for e in range(32):
            i, j, k = e % 4, e // 4 % 4, e // 16
            corners = [at[i + a, j + b, k + c] for c in (0, 1) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
            text += "".join(f"{n:8}" for n in (e + 1, 1, *corners)) + "\n"
        text += "*ELEMENT_SHELL\n"
        for e in range(36):
            a = 101 + 7 * (e // 6) + e % 6
            text += "".join(f"{n:8}" for n in (101 + e, 2, a, a + 1, a + 8, a + 7)) + "\n"
        text += "*SET_NODE_GENERAL\n         1\nPART               2\n*BOUNDARY_SPC_SET\n         1         0"
        text += 6 * "         1" + "\n*SET_NODE_LIST_GENERATE\n         2\n        51        75\n"
        text += "*SET_NODE_LIST_GENERATE\n         3\n         1        25\n"
        text += "*BOUNDARY_SPC_SET\n         2         0         1         1\n"
        text += "*BOUNDARY_PRESCRIBED_MOTION_SET\n         2         3         0         1     100.0\n"
        text += "*DEFINE_CURVE\n         1\n0.,0.\n1e-4,1.\n1.,1.\n"
        text += f"*CONTACT_{form}\n         1glue\n{side}\n\n\n         6      20.0      15.0      0.05\n*END\n"
        self.write(text)
        self.nugget("run", "model.k", "-o", ".", "--quiet")
        return self.json("summary.json")["energy"]["contact"]

    def test_glue_of_a_block_counts_the_face_that_is_glued_alone(self):
        # 1/2 20 0.05 100 = 50: the sides of the block, which meet the face at its rim, are no part of the joint.
        self.assertAlmostEqual(self.glued_block("         1         2         3         3"), 50.0, delta=0.5)

    def test_glued_nodes_of_a_set_stand_for_their_own_face(self):
        # Not for the plate's segments, 11.1 each, in the place of 4 at the mean.
        form = "AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE_TIEBREAK_ID"
        self.assertAlmostEqual(self.glued_block("         3         2         4         3", form), 50.0, delta=0.5)

    def late(self, name, birth, fs=0.0, **more):
        def write(d):
            d.keyword("CONTACT_" + name)
            d.card(surfa=UPPER, surfb=LOWER, surfatyp=3, surfbtyp=3)
            d.card(fs=fs, fd=fs, dc=0.0, vc=0.0, vdc=0.0, penchk=0, bt=birth, dt=0.0)
            d.card(sfsa=1.0, sfsb=1.0)
            if more:
                d.card(**more)
        return write

    def test_ties_that_fail_or_begin_later(self):
        """What is told, and refused. Sabotage: ties with BT of every kind as springs."""
        said = self.run_deck(plates(self.late("TIED_NODES_TO_SURFACE", 1e-4), {3: 30.0}, 2.0e-4))
        self.assertIn("touches SURFB at BT = 0.0001 is held there by springs", said.stdout + said.stderr + self.read("run.log"))
        self.assertIn("glue of contact 1: 0 nodes at the start, 25 later; 0 failed", self.read("run.log"))
        rows = self.rows()
        self.assertEqual({row[3] for row in rows if row[0] < 0.99e-4}, {0.0})
        self.assertGreater(abs(rows[-1][3]), 0.0)

        def refused(contact, word):
            self.write(plates(contact, {3: 10.0}, 2e-4))
            self.assertIn(word, self.nugget("check", "model.k", expect=1).stderr)
        refused(self.late("TIED_SURFACE_TO_SURFACE_FAILURE", 0.0), "fs = 0.0: the stress at which the tie fails must be given")
        refused(self.late("TIED_NODES_TO_SURFACE_FAILURE", 0.0, 1.0), "*CONTACT_TIEBREAK_NODES_TO_SURFACE")
        refused(self.late("TIED_SHELL_EDGE_TO_SURFACE", 1e-4), "a tie of rotations that begins later is not built")

    def test_strengths_of_a_failing_tie_have_units(self):
        """In Pa, of a file in m, kg, s. Sabotage: FS as a number."""
        deck = Deck()
        self.late("TIED_SURFACE_TO_SURFACE_FAILURE", 0.0, 1.0e7)(deck)
        (self.folder / "tie.k").write_text("*KEYWORD\n" + "\n".join(deck.lines) + "\n*END\n")

        def include(d):
            d.text("*INCLUDE_TRANSFORM\ntie.k\n" + f"{0:>10}" * 7 + f"\n{0:>10}\n{1e-3:>10}{1.0:>10}{1e3:>10}\n{0:>10}")
        self.run_deck(plates(include, {3: 30.0}, 2.0e-4))
        self.assertAlmostEqual(max(abs(row[3]) for row in self.rows()) / (10.0 * SIDE * SIDE), 1.0, delta=0.05)

    def test_glue_in_modes_is_warned_of(self):
        text = plates(sliding("AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK", option=2, nfls=1.0, sfls=1.0), {3: 30.0}, 1.0)
        self.write(text.replace("*KEYWORD\n", "*KEYWORD\n*CONTROL_IMPLICIT_GENERAL\n         1       1.0\n*CONTROL_IMPLICIT_EIGENVALUE\n         1\n"))
        self.nugget("modes", "model.k", "--quiet")
        self.assertIn("glue takes no part in linear analyses", str(self.json("findings.json")))

    def test_cards_of_glue(self):
        """What is refused, by field. Sabotage: a curve that begins with anything is taken as a factor."""
        glued = "AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK"
        for option in (0, 12, 15, -9, -4):
            self.write(plates(sliding(glued, option=option, nfls=1.0, sfls=1.0), {3: 10.0}, 1e-4))
            self.assertIn("expected 1 to 11, 13 or 14", self.nugget("check", "model.k", expect=1).stderr)

        def refused(card, word, extra=None):
            self.write(plates(sliding(glued, **card), {3: 10.0}, 1e-4, extra=extra))
            self.assertIn(word, self.nugget("check", "model.k", expect=1).stderr)
        refused(dict(option=9, nfls=1.0, sfls=1.0, param=1.0, eraten=1.0), "erates = (blank): must be given with OPTION 9")
        refused(dict(option=7, nfls=1.0, sfls=1.0, param=0.0, eraten=1.0), "erates = (blank): must be given with OPTION 7")
        refused(dict(option=7, nfls=1.0, sfls=1.0, param=90.0, eraten=1.0, erates=1.0), "param = 90")
        refused(dict(option=6, nfls=1.0, sfls=1.0, param=-1.0), "param = -1")
        refused(dict(option=4, nfls=1.0, sfls=0.0, param=1.0), "sfls = 0")
        refused(dict(option=2, nfls=1.0, sfls=1.0, param=0.5), "param = 0.5")
        refused(dict(option=5, nfls=4.0, sfls=0), "sfls")
        refused(dict(option=5, nfls=4.0, sfls=99), "expected 1 (a factor on NFLS) or NFLS itself",
                lambda d: d.curve(99, [(0.0, 3.0), (1.0, 0.0)]))


if __name__ == "__main__":
    unittest.main()
