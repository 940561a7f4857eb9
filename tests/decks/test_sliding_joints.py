# SPDX-License-Identifier: Apache-2.0
"""Bodies that slide far along their joint: the force of the joint then meets body A at a lever of many times its size."""
import unittest

from few_elements import CORNERS, SOLID, card, nodes, part
from nugget_command import CommandTest

AXIS, ACROSS, PLACE = (0.6, 0.5, 0.3), (-0.5, 0.6, 0.0), (12.0, 2.5, 2.0)


def along(a, way):
    return tuple(p + way * x for p, x in zip(PLACE, a))


def deck(kind, *places, more=""):
    """Two tumbling bars on a joint, thrown apart."""
    bars = [[(o + s * c for o, s, c in zip(origin, size, corner)) for corner in CORNERS]
            for origin, size in (((0, 0, 0), (10.0, 5.0, 3.0)), ((14, 1, 1), (9.0, 6.0, 4.0)))]
    text = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(4e-2) + "*CONTROL_ENERGY\n" + card(2, 2, 2, 2) + "*DATABASE_GLSTAT\n" + card(1e-3) + SOLID
    for p, bar in enumerate(bars, 1):
        text += part(p, 1, p) + "*MAT_RIGID\n" + card(p, 7.85e-9, 2.1e5, 0.3) + "\n\n" + nodes(bar, 10 * p)
        text += f"*ELEMENT_SOLID\n{p:8}{p:8}" + "".join(f"{10 * p + i:8}" for i in range(8)) + "\n"
    pairs = [(101 + 2 * i, 102 + 2 * i) for i in range(len(places))]
    text += nodes([place for place in places for _ in (0, 1)], 101)
    for pair in pairs:
        text += "".join("*CONSTRAINED_EXTRA_NODES_NODE\n" + card(p, n) for p, n in zip((1, 2), pair))
    text += f"*CONSTRAINED_JOINT_{kind}\n" + card(*(n for pair in pairs for n in pair)) + more
    velocities = ((1, 2000.0, 500.0, -1500.0, 300.0, -200.0, 500.0), (2, -500.0, 700.0, 300.0, -100.0, 400.0, 200.0))
    return text + "*INITIAL_VELOCITY_RIGID_BODY\n" + "".join(card(*v) for v in velocities) + "*END\n"


class SlidingJoints(CommandTest):
    def test_bodies_that_slide_far(self):
        """Sabotage: the stiffness that is stable where the joint is at the start; that of a planar joint ended as unstable."""
        second, third = along(AXIS, 8.0), along(ACROSS, 8.0)
        for kind, places, more in (("PLANAR", (PLACE, second), ""), ("CYLINDRICAL", (PLACE, second), ""), ("TRANSLATIONAL", (PLACE, second, third), "")):
            with self.subTest(kind):
                self.write(deck(kind, *places, more=more))
                run = self.nugget("run", "model.k", "-o", "out", "--quiet")
                self.assertNotIn("energy ratio", run.stderr)
                for state in self.glstat("out/glstat"):
                    self.assertAlmostEqual(state["total energy / initial energy"], 1.0, delta=2e-3)


if __name__ == "__main__":
    unittest.main()
