# SPDX-License-Identifier: Apache-2.0
"""Mass scaling of welds that yield, fade and fail between free sheets: what momentum it brings, and that failure loses none."""
import unittest

import lsda
from nugget_command import CommandTest
from welded_sheets import Sheets

SPEED, STEP = 20000.0, -6.0e-7


def free_sheets(bricks, option, damage, boost=0.0, start_only=0, strength=600.0):
    """A sheet moves off another one that two welds hold it to; no part of it is held. Weld beams, or `bricks` in place of each."""
    s = Sheets()
    s.cards[0] = "*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,7.85e-9,210000.0,0.3,300.0,1000.0\n\n\n"
    s.cards += ["*CONTROL_TERMINATION\n2.0e-5", "*DATABASE_MATSUM\n1.0e-6,2", "*DATABASE_GLSTAT\n1.0e-6,2",
                f"*CONTROL_TIMESTEP\n0.0,0.9,0,0.0,{STEP},0,0,{start_only}",
                f"*MAT_SPOTWELD_DAMAGE-FAILURE\n2,7.85e-9,210000.0,0.3,400.0,1000.0\n0.05,{strength},400.0,400.0\n0.3,{option},0.0,,0,0.0,,{damage}"]
    sheets = [s.sheet(1.2, 0.0, 0.0, z, 6, 6, 6.0) for z in (0.0, 1.2)]
    welds = s.beam_part(6.0, 2)
    for x, y in ((14.0, 16.0), (25.0, 22.0)):
        s.beam(welds, (x, y, 0.0), (x, y, 1.2))
    if bricks:
        s.cards.append(f"*CONTROL_SPOTWELD_BEAM\n,,,,,{bricks}")
    s.tie([welds], sheets)
    for number, sheet, velocity in ((1, sheets[1], (3000.0 + boost, 2000.0, 12000.0)), (2, sheets[0], (boost, 0.0, 0.0))):
        s.node_set(number, [n for j in range(7) for n in s.row(sheet, j)])
        s.cards.append(f"*INITIAL_VELOCITY\n{number}\n{velocity[0]},{velocity[1]},{velocity[2]}")
    return s.text()


class AddedMass(CommandTest):
    def run_it(self, name, **options):
        """[(momentum along x, added mass)] by state, and the row of the weld that fails first."""
        self.write(free_sheets(**options), f"{name}.k")
        self.nugget("run", f"{name}.k", "-o", name, "--quiet", "-j1")
        found = lsda.read(self.folder / name / "binout0000")
        states = zip(lsda.states(found, "matsum"), lsda.states(found, "glstat"), strict=True)
        return [(sum(of_parts["x_momentum"]), of_all["added_mass"][0]) for of_parts, of_all in states]

    def test_it_moves_with_its_nodes(self):
        """Four bricks that are flattened: mass is added in flight, and momentum grows. In a frame that moves at V all is the same, and the momentum
        larger by the mass times V, of the added mass as well. Sabotage: nodes are slowed down when their mass grows; mass that stays at rest."""
        rest, moving = (self.run_it(name, bricks=4, option=1, damage=11, boost=boost) for name, boost in (("rest", 0.0), ("moving", SPEED)))
        grown = rest[-1][1] - rest[0][1]
        self.assertGreater(grown, 1e-3 * rest[0][1])
        self.assertGreater(rest[-1][0] / rest[0][0], 1.001)
        mass = (moving[0][0] - rest[0][0]) / SPEED
        for (p, added), (q, also_added) in zip(rest, moving, strict=True):
            self.assertAlmostEqual(added / also_added, 1.0, delta=1e-9)
            self.assertAlmostEqual((q - p) / SPEED / (mass + added - rest[0][1]), 1.0, delta=1e-9)

    def test_none_is_added_where_the_deck_says_so(self):
        """MS1ST = 1. Sabotage: it is not obeyed."""
        states = self.run_it("start", bricks=4, option=1, damage=11, start_only=1)
        self.assertEqual(len({added for _, added in states}), 1)
        for momentum, _ in states:
            self.assertAlmostEqual(momentum / states[0][0], 1.0, delta=1e-12)

    def test_failure_loses_none(self):
        """Welds that fail in their first cycles, at once or by damage, with all the mass that they were given. Sabotage: it goes with the elements."""
        for bricks in (0, 1, 4):
            with self.subTest(bricks=bricks):
                states = self.run_it(f"fails{bricks}", bricks=bricks, option=0, damage=0)
                self.assertTrue(all(weld["failed"] for weld in self.json(f"fails{bricks}/summary.json")["weld"]))
                self.assertGreater(states[0][1], 1e-6)
                for momentum, added in states:
                    self.assertEqual(added, states[0][1])
                    self.assertAlmostEqual(momentum / states[0][0], 1.0, delta=1e-12)


if __name__ == "__main__":
    unittest.main()
