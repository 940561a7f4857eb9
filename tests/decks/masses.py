# SPDX-License-Identifier: Apache-2.0
"""Decks of free masses and a rigid box, and what nodout says of them."""
import re

from few_elements import CORNERS, card, curve, nodes, part
from nugget_command import CommandTest

STEP, END, MASS = 0.001, 0.1, 2.0
NUMBER = r"[-+]?\d\.\d+E[-+]\d+"


def masses(places, cards, box=False):
    """Free masses, steps of one length, an elastic cube far away that gives the model an element; a rigid box 4 x 2 x 1 as
    part 50 with its own axes, if asked for."""
    far = [(100 + x, 100 + y, 100 + z) for x, y, z in CORNERS]
    text = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(END)
    text += "*CONTROL_TIMESTEP\n" + card(0.0, 0.6, 0, 0.0, 0.0, 99) + curve(99, (0, STEP), (1000, STEP))
    text += curve(1, (0, 1), (1, 1)) + curve(2, (0, 0), (1, 0))
    text += nodes(far, 1001) + nodes(places)
    text += f"*ELEMENT_SOLID\n{1:8}{900:8}\n" + "".join(f"{1001 + i:8}" for i in range(8)) + "\n"
    text += part(900, 900, 900) + "*SECTION_SOLID\n" + card(900, 1) + "*MAT_ELASTIC\n" + card(900, 1.0, 1.0, 0.3)
    text += "*ELEMENT_MASS\n" + "".join(f"{i + 1:8}{i + 1:8}{MASS:16}\n" for i in range(len(places)))
    shown = list(range(1, len(places) + 1))
    if box:
        text += nodes([(4 * x, 2 * y, z) for x, y, z in CORNERS], 2001)
        text += f"*ELEMENT_SOLID\n{50:8}{50:8}\n" + "".join(f"{2001 + i:8}" for i in range(8)) + "\n"
        text += part(50, 900, 50) + "*MAT_RIGID\n" + card(50, 1.0, 1.0, 0.3) + "\n" + card(8)
        text += "*DEFINE_COORDINATE_VECTOR\n" + card(8, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0)
        shown.append(2001)
    for name in ("NODOUT", "SPCFORC", "BNDOUT", "GLSTAT", "RBDOUT"):
        text += f"*DATABASE_{name}\n" + card(0.02, 1)
    return text + "*DATABASE_HISTORY_NODE\n" + card(*shown) + cards + "*END\n"


class MassesTest(CommandTest):
    def run_deck(self, *arguments, **options):
        self.write(masses(*arguments, **options))
        return self.nugget("run", "model.k", "-o", "out", "--quiet").stderr

    def nodout(self):
        """[{node: displacement and velocity}]"""
        states = []
        for line in self.read("out/nodout").splitlines():
            if "nodal point" in line:
                states.append({})
            match = re.match(rf"\s*(\d+)((?:\s*{NUMBER})+)", line)
            if match:
                states[-1][int(match[1])] = [float(x) for x in re.findall(NUMBER, match[2])][:6]
        return states

    def assert_near(self, found, expected, delta):
        for one, other in zip(found, expected, strict=True):
            self.assertAlmostEqual(one, other, delta=delta)

    def energies(self):
        last = self.glstat("out/glstat")[-1]
        return last["external work"], last["kinetic energy"]
