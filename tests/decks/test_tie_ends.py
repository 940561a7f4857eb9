# SPDX-License-Identifier: Apache-2.0
"""Ties that end while the model moves, on rigid bodies and by springs: mass and energy are what they were."""
import unittest

from nugget_command import CommandTest
from welded_sheets import Sheets, weld_material

END = 2.0e-5


def welded(form="", cards=(), rigid=False, scale=1.0, at=15.0):
    """Two sheets with a weld beam; its tie ends in the middle of the run, or not (`form`: of the contact)."""
    s = Sheets()
    s.cards += [f"*CONTROL_TERMINATION\n{END:.3e}", "*CONTROL_ENERGY\n2,2,2,2", f"*DATABASE_GLSTAT\n{END / 40:.3e}", weld_material(2)]
    sheets = [s.sheet(1.2, 0.0, 0.0, z, 5, 5, 6.0) for z in (0.0, 1.2)]
    if rigid:
        part = next(i for i, card in enumerate(s.cards) if card.startswith(f"*PART\nsheet\n{sheets[1]},"))
        s.cards[part] = s.cards[part].replace(f"{sheets[1]},{sheets[1]},1", f"{sheets[1]},{sheets[1]},9")
        s.cards.append("*MAT_RIGID\n9,7.85e-9,210000.0,0.3\n,\n,")
    welds = s.beam_part(6.0, 2)
    s.beam(welds, (at, at, 0.0), (at, at, 1.2))
    s.part_set(1, [welds])
    s.part_set(2, sheets)
    death = 0.0 if any("ELEMENT_DEATH" in card for card in cards) else END / 2
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

    def test_a_spring_that_ends_under_load_has_done_all_its_work(self):
        """One sheet is thrown off the other. Sabotage: the work of a spring's last force over the step in which it ends is not counted."""
        s, sheets = welded("_PENALTY", scale=0.5)
        s.node_set(5, [n for j in range(6) for n in s.row(sheets[1], j)])
        s.cards.append("*INITIAL_VELOCITY\n5\n2000.0,1000.0,3000.0")
        states = self.energies(s)
        self.assertGreater(max(abs(state["sliding interface energy"]) for state in states), 0.1)
        for state in states:
            self.assertAlmostEqual(state["total energy"] / states[0]["total energy"], 1.0, delta=2e-5)


if __name__ == "__main__":
    unittest.main()
