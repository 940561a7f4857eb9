# SPDX-License-Identifier: Apache-2.0
"""Ties that end while the model moves, on rigid bodies and by springs: mass and energy are what they were."""
import unittest

import lap_joint
from few_elements import SOLID, card, curve, nodes, part
from lap_joint import edited
from nugget_command import CommandTest
from test_swforc import joined_by
from test_weld_tie import MODES
from welded_sheets import Sheets, weld_material

END = 2.0e-5


def welded(form="", cards=(), rigid=False, scale=1.0, at=15.0, weak=False):
    """Two sheets with a weld beam whose tie ends in the middle of the run (`form`: of the contact), or, if it is weak, stays when it has failed."""
    s = Sheets()
    end = 3 * END if weak else END
    s.cards += [f"*CONTROL_TERMINATION\n{end:.3e}", "*CONTROL_ENERGY\n2,2,2,2", f"*DATABASE_GLSTAT\n{END / 40:.3e}", weld_material(2, card="0.0,1500.0") if weak else weld_material(2)]
    sheets = [s.sheet(1.2, 0.0, 0.0, z, 5, 5, 6.0) for z in (0.0, 1.2)]
    if rigid:
        part = next(i for i, card in enumerate(s.cards) if card.startswith(f"*PART\nsheet\n{sheets[1]},"))
        s.cards[part] = s.cards[part].replace(f"{sheets[1]},{sheets[1]},1", f"{sheets[1]},{sheets[1]},9")
        s.cards.append("*MAT_RIGID\n9,7.85e-9,210000.0,0.3\n,\n,")
    welds = s.beam_part(6.0, 2)
    s.beam(welds, (at, at, 0.0), (at, at, 1.2))
    s.part_set(1, [welds])
    s.part_set(2, sheets)
    death = 0.0 if weak or any("ELEMENT_DEATH" in card for card in cards) else END / 2
    s.cards.append(f"*CONTACT_SPOTWELD{form}\n1,2,2,2\n0.0,,,,,,,{death}\n{scale},1.0")
    s.cards += cards
    return s, sheets


class TieEnds(CommandTest):
    def energies(self, s):
        self.write(s.text())
        self.nugget("run", "model.k", "--quiet", "-j", 1)
        self.assertIn("tie ended", self.read("run.log"))
        return self.glstat()

    def all_moving(self, s, spin):
        """Everything moves as one body, slowly enough that it strains next to nothing."""
        s.part_set(3, list(range(1, s.part + 1)))
        s.cards.append(f"*INITIAL_VELOCITY_GENERATION\n3,1,{spin},400.0,-300.0,500.0\n15.0,15.0,0.0,0.6,0.0,0.8")

    def test_a_rigid_body_gives_the_mass_of_a_released_node_back(self):
        """Kinetic energy of a rigid motion goes on as it was. Sabotage: a body that keeps the mass of nodes that it has lost; one whose centre or
        inertia do not follow."""
        for form in ("", "_CONSTRAINED_OFFSET"):
            with self.subTest(form=form):
                s, _ = welded(form, rigid=True, at=12.0)  # over nodes: elsewhere the shares of mass turn by themselves
                self.all_moving(s, 50.0)
                states = self.energies(s)
                for state in states:
                    self.assertAlmostEqual(state["kinetic energy"] / states[0]["kinetic energy"], 1.0, delta=1e-5)

    def test_so_does_one_that_has_nodes_of_the_segment(self):
        """A nodal rigid body has two nodes of the shell that carries the weld, and that shell is deleted."""
        s, sheets = welded(cards=[f"*DEFINE_ELEMENT_DEATH_SHELL\n38,{END / 2}"])
        s.node_set(4, s.row(sheets[1], 2)[2:4] + s.row(sheets[1], 1)[2:3])
        s.cards.append("*CONSTRAINED_NODAL_RIGID_BODY\n77,0,4")
        self.all_moving(s, 0.0)
        states = self.energies(s)
        for state in states:
            self.assertAlmostEqual(state["kinetic energy"] / states[0]["kinetic energy"], 1.0, delta=1e-5)

    def test_so_does_one_that_has_nodes_of_the_disc(self):
        """A weld tied by area over four shells, three nodes of which are a nodal rigid body's; of one shell that is deleted the others take the share.
        Sabotage: arms of the body's nodes out of the places at the start, which a run sets free."""
        s, sheets = welded(cards=["*NUGGET_WELD_TIE\n1", f"*DEFINE_ELEMENT_DEATH_SHELL\n39,{END / 2}"], at=16.0)
        s.node_set(4, s.row(sheets[1], 2)[2:4] + s.row(sheets[1], 1)[2:3])
        s.cards.append("*CONSTRAINED_NODAL_RIGID_BODY\n77,0,4")
        self.all_moving(s, 0.0)
        self.write(s.text())
        self.nugget("run", "model.k", "--quiet", "-j", 1)
        self.assertIn("part 2: 1 of 25 elements deleted", self.read("run.log"))
        states = self.glstat()
        for state in states:
            self.assertAlmostEqual(state["kinetic energy"] / states[0]["kinetic energy"], 1.0, delta=1e-5)

    def test_a_spring_that_ends_under_load_has_done_all_its_work(self):
        """One sheet is thrown off the other. Sabotage: the work of a spring's last force over the step in which it ends is not counted."""
        s, sheets = welded("_PENALTY", scale=0.5)
        s.node_set(5, [n for j in range(6) for n in s.row(sheets[1], j)])
        s.cards.append("*INITIAL_VELOCITY\n5\n2000.0,1000.0,3000.0")
        states = self.energies(s)
        self.assertGreater(max(abs(state["sliding interface energy"]) for state in states), 0.1)
        for state in states:
            self.assertAlmostEqual(state["total energy"] / states[0]["total energy"], 1.0, delta=2e-5)


class TiesToBricks(CommandTest):
    def test_a_node_falls_when_its_brick_is_deleted(self):
        """Two bricks are held, a point mass is tied to the upper face of each, everything is under gravity; one of the bricks is deleted. Its mass
        falls from then on, the other one stays. Sabotage: ties to bricks last for ever."""
        places = [(x, y, z) for x in (0.0, 10.0, 20.0) for y in (0.0, 10.0) for z in (0.0, 10.0)]
        corner = lambda i, j, k: 1 + 4 * i + 2 * j + k
        bricks = "".join(f"{e:8}{1:8}\n" + "".join(f"{corner(e - 1 + i, j, k):8}" for k in (0, 1) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))) + "\n"
                         for e in (1, 2))
        for contact in ("TIED_NODES_TO_SURFACE", "TIED_NODES_TO_SURFACE_OFFSET", "TIED_NODES_TO_SURFACE_CONSTRAINED_OFFSET"):
            with self.subTest(contact):
                text = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(1e-3) + part(1) + SOLID + "*MAT_ELASTIC\n" + card(1, 7.85e-9, 2.1e5, 0.3)
                text += nodes(places + [(4.0, 6.0, 10.0), (14.0, 6.0, 10.0)]) + "*ELEMENT_SOLID\n" + bricks
                text += "*BOUNDARY_SPC_NODE\n" + "".join(card(n, 0, 1, 1, 1) for n in range(1, 13))
                text += "*ELEMENT_MASS\n" + "".join(f"{100 + n:8}{n:8}{1e-6:16}\n" for n in (13, 14)) + "*SET_NODE_LIST\n" + card(5) + card(13, 14)
                text += f"*CONTACT_{contact}\n" + card(5, 1, 4, 3) + "\n\n" + "*LOAD_BODY_Z\n" + card(9, 1000.0) + curve(9, (0.0, 1.0), (1.0, 1.0))
                text += "*DEFINE_ELEMENT_DEATH_SOLID\n" + card(2, 4e-4) + "*DATABASE_HISTORY_NODE\n" + card(13, 14) + "*DATABASE_NODOUT\n" + card(1e-3)
                self.write(text + "*END\n")
                self.nugget("run", "model.k", "--quiet")
                self.assertRegex(self.read("run.log"), r"tie ended  node=14 .* with brick 2\n")
                self.assertNotIn("tie ended  node=13 ", self.read("run.log"))
                speed = {int(line[:10]): float(line[70:82]) for line in self.read("nodout").splitlines() if line[:10].strip() in ("13", "14") and len(line) > 120}
                self.assertAlmostEqual(speed[14], -1000.0 * 6e-4, delta=0.01)
                self.assertAlmostEqual(speed[13], 0.0, delta=0.01)


class ErodedKineticEnergy(CommandTest):
    def test_each_corner_of_a_sheet_counts(self):
        """One of four shells of a sheet in flight is deleted, and the node at its corner has no elements any more. Sabotage: the first node in the
        program's own order, with which it fills the lists of elements that have fewer nodes than others, has elements for ever."""
        found = []
        for shell in (1, 2, 3, 4):
            s = Sheets()
            s.cards += ["*CONTROL_TERMINATION\n4.0e-6", "*CONTROL_ENERGY\n2,2,2,2", "*DATABASE_GLSTAT\n1.0e-6",
                        f"*DEFINE_ELEMENT_DEATH_SHELL\n{shell},1.5e-6", "*INITIAL_VELOCITY\n0\n300.0,400.0,-500.0"]
            s.sheet(1.0, 0.0, 0.0, 0.0, 2, 2, 6.0)
            self.write(s.text())
            self.nugget("run", "model.k", "--quiet")
            found.append(self.glstat()[-1]["eroded kinetic energy"])
        self.assertGreater(found[3], 0.0)
        for energy in found:
            self.assertAlmostEqual(energy / found[3], 1.0, delta=1e-6)


class SpringsAndTheStep(CommandTest):
    def test_springs_make_no_energy_when_the_step_grows(self):
        """A weld fails, and the step of the shells is five times that of its beam: the springs of its nodes are as stiff as the old one allows.
        Sabotage: a step that grows at once; springs give back a sixth of all energy which they never had."""
        for scale, rigid in ((0.99, False), (1.0, True)):
            with self.subTest(rigid=rigid):
                s, sheets = welded("_PENALTY", rigid=rigid, scale=scale, weak=True)
                if rigid:
                    s.cards.append(f"*INITIAL_VELOCITY_RIGID_BODY\n{sheets[1]},2000.0,1000.0,3000.0")
                else:
                    s.node_set(5, [n for j in range(6) for n in s.row(sheets[1], j)])
                    s.cards.append("*INITIAL_VELOCITY\n5\n2000.0,1000.0,3000.0")
                self.write(s.text())
                self.nugget("run", "model.k", "--quiet", "-j", 1)
                states = self.glstat()
                self.assertGreater(states[-1]["time step"], 4.0 * states[0]["time step"])
                for state in states:
                    self.assertGreater(state["sliding interface energy"], -1e-3 * states[0]["total energy"])


class LinearAnalyses(CommandTest):
    """The lap joint, whose weld ends on shell 14. Without it the upper sheet, whose edge is held along x, has four motions that nothing resists:
    along y and z, and about x and y. Sabotage: ties to shells that are not there."""

    def zero_modes(self, summary):
        modes = [mode["frequency_hz"] for mode in self.json(summary)["modes"]]
        self.assertGreater(modes[-1], 1000.0)
        return sum(frequency < 1.0 for frequency in modes)

    def test_a_shell_that_is_not_there_holds_no_weld(self):
        death = "*DEFINE_ELEMENT_DEATH_SHELL\n        14       0.0\n"
        for cards, options, free in (("", (), 0), (death, (), 4), (death, ("--weld-tie", "area"), 4)):
            with self.subTest(cards=cards, options=options):
                self.write(lap_joint.deck(("*TITLE\n", MODES + cards + "*TITLE\n")))
                run = self.nugget("modes", "model.k", "-o", "out", "-n", 8, "--quiet", *options)
                self.assertEqual(self.zero_modes("out/summary.json"), free)
                self.assertEqual("1 tied nodes are free, first node 301: the shells that would carry them are deleted" in run.stderr, free > 0)

    def test_nor_does_one_that_a_run_before_has_deleted(self):
        after = ("*CONTROL_IMPLICIT_GENERAL\n         6       1.0\n*CONTROL_IMPLICIT_EIGENVALUE\n        -9\n"
                 "*DEFINE_CURVE\n         9\n                 0.0                 0.0\n             2.0e-05                14.0\n")
        for cards, free in (("", 0), ("*DEFINE_ELEMENT_DEATH_SHELL\n        14   1.0e-06\n", 4)):
            with self.subTest(cards=cards):
                self.write(lap_joint.deck(("*TITLE\n", after + cards + "*TITLE\n")))
                self.nugget("run", "model.k", "-o", "out", "--quiet")
                self.assertEqual(self.zero_modes("out/modes/summary.json"), free)
        for fails, free in (("          ", 0), ("   1.0e-06", 4)):
            self.write(edited(joined_by(f"*CONSTRAINED_SPOTWELD_ID\n       900\n       106       206       0.0       0.0       0.0       0.0{fails}\n"),
                              ("*TITLE\n", after + "*TITLE\n")))
            self.nugget("run", "model.k", "-o", "out", "--quiet")
            self.assertEqual(self.zero_modes("out/modes/summary.json"), free)
        dies = ("       0.0\n       1.0\n*SET_PART_LIST", "       0.0       0.0       0.0       0.0       0.0         0       0.0   1.0e-06\n       1.0\n*SET_PART_LIST")
        self.write(lap_joint.deck(("*TITLE\n", after + "*TITLE\n"), dies))
        self.nugget("run", "model.k", "-o", "out", "--quiet")
        self.assertEqual(self.zero_modes("out/modes/summary.json"), 4 + 6)  # and those of the weld beam, which is free at both ends


if __name__ == "__main__":
    unittest.main()
