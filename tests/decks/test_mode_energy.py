# SPDX-License-Identifier: Apache-2.0
"""Shares of parts and welds in the strain energy of modes (mode_energy.csv), with welds of every kind that has elements, and beside a joint's
stiffness."""
import csv
import unittest

from nugget_command import CommandTest

STEEL = "*MAT_ELASTIC\n1,7.85e-9,2.1e5,0.3\n"
SPOTS = ((17.0, 9.0), (31.0, 12.0), (25.0, 4.0))
HEIGHT = 1.5


def sheets():
    """Two strips of 4 x 2 shells, one above the other, the lower one clamped at its left edge."""
    text = "*KEYWORD\n*CONTROL_TERMINATION\n1.0,\n" + STEEL + "*SECTION_SHELL\n1,16\n1.5,1.5,1.5,1.5\n*PART\nlower\n1,1,1\n*PART\nupper\n2,1,1\n*NODE\n"
    shells = ""
    for sheet, z in enumerate((0.0, HEIGHT)):
        number = lambda i, j: 1 + 100 * sheet + i + 5 * j  # noqa: E731, B023
        text += "".join(f"{number(i, j)},{12.0 * i + 3.0 * sheet},{10.0 * j},{z}\n" for j in range(3) for i in range(5))
        shells += "".join(f"{1 + 100 * sheet + i + 4 * j},{sheet + 1},{number(i, j)},{number(i + 1, j)},{number(i + 1, j + 1)},{number(i, j + 1)}\n"
                          for j in range(2) for i in range(4))
    return text + "*ELEMENT_SHELL\n" + shells + "*BOUNDARY_SPC_NODE\n" + "".join(f"{n},0,1,1,1,1,1,1\n" for n in (1, 6, 11)) + "*SET_PART_LIST\n9,\n1,2\n"


WELD_STEEL = "*MAT_SPOTWELD\n5,7.85e-9,2.1e5,0.3,400.0,1000.0\n,\n"
TIE = "*PART\nwelds\n5,5,5\n*CONTACT_SPOTWELD\n5,9,3,2\n0.,\n1.,\n"


def line_welds(section, material):
    nodes = "".join(f"{301 + 2 * k + end},{x},{y},{end * HEIGHT}\n" for k, (x, y) in enumerate(SPOTS) for end in (0, 1))
    return section + material + TIE + "*NODE\n" + nodes + "*ELEMENT_BEAM\n" + "".join(f"{301 + k},5,{301 + 2 * k},{302 + 2 * k},0\n" for k in range(len(SPOTS)))


def brick_welds():
    nodes, bricks = "", ""
    for k, (x, y) in enumerate(SPOTS):
        first = 301 + 8 * k
        corners = [(x + a, y + b, z) for z in (0.0, HEIGHT) for a, b in ((-2, -2), (2, -2), (2, 2), (-2, 2))]
        nodes += "".join(f"{first + i},{p[0]},{p[1]},{p[2]}\n" for i, p in enumerate(corners))
        bricks += f"{301 + k},5," + ",".join(str(first + i) for i in range(8)) + "\n"
    return "*SECTION_SOLID\n5,1\n" + WELD_STEEL + TIE + "*NODE\n" + nodes + "*ELEMENT_SOLID\n" + bricks


def point_welds(card):
    nodes = "".join(f"{301 + k},{x},{y},{0.5 * HEIGHT}\n" for k, (x, y) in enumerate(SPOTS))
    return "*NODE\n" + nodes + "*SET_NODE_LIST\n8,\n301,302,303\n" + card


KINDS = {
    "beams": line_welds("*SECTION_BEAM\n5,9\n5.0,5.0,0.0,0.0\n", WELD_STEEL),
    "bricks": brick_welds(),
    "discrete beams": line_welds("*SECTION_BEAM\n5,6,1.0,0,0,2.0\n1.0,1e-6,0,0.0\n", "*MAT_LINEAR_ELASTIC_DISCRETE_BEAM\n5,1e-7,2e5,8e4,8e4,1e6,2e6,2e6\n,\n"),
    "self-piercing rivets": point_welds("*CONSTRAINED_SPR2\n2,1,8,3.0,6.0,5000.0,4000.0,2.0\n3.0,0.5,0.5,0.7,0.7,1.0,7.85e-9\n"),
    "interpolation spot welds": point_welds("*DEFINE_CURVE\n61,\n0.0,3000.0\n5.0,5000.0\n*CONSTRAINED_INTERPOLATION_SPOTWELD\n"
                                            "2,1,8,3.0,6.0,1e5,0.0,1\n1.0,1.0,2.0,61,0,0,7.85e-9\n1.2e5,3e6,5e6\n"),
}


class ModeEnergy(CommandTest):
    def shares(self, text):
        """{(kind, id): shares by mode}"""
        self.write(text)
        self.nugget("modes", "model.k", "-n", 4, "-o", "modes", "--quiet")
        with open(self.folder / "modes/mode_energy.csv", newline="", encoding="utf-8") as file:
            return {(row["kind"], int(row["id"])): [float(row[f"mode {m}"]) for m in range(1, 5)] for row in csv.DictReader(file)}

    def test_welds_share_what_their_part_has(self):
        """Sabotage: weld beams alone have a share."""
        for name, cards in KINDS.items():
            with self.subTest(name):
                shares = self.shares(sheets() + cards + "*END\n")
                parts = [v for (kind, number), v in shares.items() if kind == "part" and number not in (1, 2)]
                welds = [v for (kind, _), v in shares.items() if kind == "weld"]
                self.assertEqual((len(parts), len(welds)), (1, 3))
                for mode in range(4):
                    self.assertGreater(parts[0][mode], 1e-5)
                    self.assertAlmostEqual(sum(w[mode] for w in welds) / parts[0][mode], 1.0, delta=1e-4)
                    self.assertAlmostEqual(sum(v[mode] for (kind, _), v in shares.items() if kind == "part"), 1.0, delta=1e-4)

    def test_what_joints_hold_is_of_the_whole(self):
        """Two bodies in a row, the first on a spring of 100, the second on the first by a joint's stiffness of 300: of energy k1 u1^2 and
        k2 (u2 - u1)^2 the spring has its part alone. Sabotage: it has all of it."""
        text = ("*KEYWORD\n*CONTROL_TERMINATION\n1.0,\n*SECTION_DISCRETE\n11,0,\n,\n*PART\nspring\n11,11,11\n*MAT_SPRING_ELASTIC\n11,100.0,\n"
                "*ELEMENT_DISCRETE\n11,11,1,11\n*NODE\n1,0.0,0.0,0.0\n2,1.0,0.0,0.0\n3,0.0,0.0,0.0\n4,1.0,0.0,0.0\n11,-9.0,0.0,0.0\n*BOUNDARY_SPC_NODE\n11,0,1,1,1\n"
                "*DEFINE_CURVE\n9,\n0.0,0.0\n1.0,300.0\n*DEFINE_COORDINATE_SYSTEM\n4,0.,0.,0.,1.,0.,0.\n0.,1.,0.\n")
        for pid, nodes in ((50, "1,2"), (60, "3,4")):
            text += (f"*SET_NODE_LIST\n{pid},\n{nodes}\n*CONSTRAINED_NODAL_RIGID_BODY_INERTIA_SPC\n{pid},0,{pid}\n1.0,5,7,\n0.0,0.0,0.0,2.0,0\n"
                     "1.0,0.0,0.0,1.0,0.0,1.0\n0.0,0.0,0.0,0.0,0.0,0.0\n")
        text += "*CONSTRAINED_JOINT_STIFFNESS_TRANSLATIONAL\n1,50,60,4,4\n9,,\n,\n,\n*END\n"
        self.write(text)
        self.nugget("modes", "model.k", "-n", 2, "-o", "modes", "--quiet")
        with open(self.folder / "modes/mode_energy.csv", newline="", encoding="utf-8") as file:
            row = next(row for row in csv.DictReader(file) if row["id"] == "11")
        for mode in (1, 2):
            root = (1400.0**2 - 16.0 * 30000.0) ** 0.5  # of 4 s^2 - (2 * 300 + 2 * 400) s + 300 * 100 = 0, s = omega^2
            square = (1400.0 + (-1 if mode == 1 else 1) * root) / 8.0
            second = 300.0 / (300.0 - 2.0 * square)  # u2 for u1 = 1
            expected = 100.0 / (100.0 + 300.0 * (second - 1.0) ** 2)
            self.assertAlmostEqual(float(row[f"mode {mode}"]), expected, delta=1e-5)


if __name__ == "__main__":
    unittest.main()
