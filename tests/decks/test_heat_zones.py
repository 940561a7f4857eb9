# SPDX-License-Identifier: Apache-2.0
"""*DEFINE_HAZ_PROPERTIES and *DEFINE_HAZ_TAILOR_WELDED_BLANK: a strip that is softened along a line yields at the factor times the
yield stress, and breaks there. Sabotage: the factor on another part's shells; on the first yield only; on the strain not at all."""
import re
import unittest

from few_elements import card, curve, nodes, part
from nugget_command import CommandTest
from test_interpolation_spotwelds import spr3
from test_spr2 import riveted

LENGTH, WIDTH, THICKNESS, YIELD, SHELLS = 50.0, 5.0, 1.0, 300.0, 10
NUMBER = r"[-+]?\d\.\d+E[-+]\d+"


def strip(haz, failure=0.0, law="*MAT_PIECEWISE_LINEAR_PLASTICITY\n", hardening=1.0, speed=100.0, end=2e-3):
    """One row of shells along x, pulled at its right end to 0.3 % in 2e-3."""
    places = [(LENGTH * i / SHELLS, y, 0.0) for y in (0.0, WIDTH) for i in range(SHELLS + 1)]
    text = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(end) + nodes(places) + part(1)
    text += "*ELEMENT_SHELL\n" + "".join("".join(f"{f:8}" for f in (i, 1, i, i + 1, i + SHELLS + 2, i + SHELLS + 1)) + "\n"
                                         for i in range(1, SHELLS + 1))
    text += "*SECTION_SHELL\n" + card(1, 2, 0.8333, 3) + card(*[THICKNESS] * 4)
    text += law + card(1, "7.85e-9", 210000.0, 0.3, YIELD, hardening, failure or "") + "\n\n\n"
    text += "*BOUNDARY_SPC_NODE\n" + card(1, 0, 1, 1, 1, 1, 1, 1) + card(SHELLS + 2, 0, 1, 0, 1, 1, 1, 1)
    pulled = (SHELLS + 1, 2 * SHELLS + 2)
    text += "*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + "".join(card(n, 1, 0, 9) for n in pulled)
    text += curve(9, (0.0, 0.0), (1e-3, speed), (1.0, speed)) + "*DATABASE_SPCFORC\n" + card(end / 50.0)
    text += "*SET_NODE_LIST\n" + card(7) + card(6, SHELLS + 7)  # the line across x = 25
    return text + haz + "*END\n"


def zone(curves, more="*DEFINE_HAZ_TAILOR_WELDED_BLANK\n" + card(3, 7)):
    return "*DEFINE_HAZ_PROPERTIES_TITLE\nsoft\n" + card(4, 1, 1, 0) + card(*curves) + more


class HeatZones(CommandTest):
    def force(self):
        """Of the supports along x at the end."""
        return abs(float(re.findall(rf"force resultants\s*=\s*({NUMBER})", self.read("spcforc"))[-1]))

    def test_the_limit_force_has_the_factor(self):
        for haz, factor in (("", 1.0), (zone((0, 0, 0, 0, 0, 0, 8, 0)) + curve(8, (0.0, 0.75), (100.0, 0.75)), 0.75)):
            for law in ("*MAT_PIECEWISE_LINEAR_PLASTICITY\n", "*MAT_PLASTIC_KINEMATIC\n"):
                self.write(strip(haz, law=law, hardening=500.0))
                self.nugget("run", "model.k", "--quiet")
                self.assertAlmostEqual(self.force() / (factor * YIELD * WIDTH * THICKNESS), 1.0, delta=0.01)

    def test_the_strip_breaks_in_the_soft_line(self):
        """The factor falls from 1 at 10 mm to 0.8 at the line: the two shells beside it yield, and fail at 0.75 of FAIL."""
        curves = curve(8, (0.0, 0.8), (10.0, 1.0)) + curve(18, (0.0, 0.75), (5.0, 0.75), (10.0, 1.0))
        self.write(strip(zone((0, 0, 0, 0, 0, 0, 8, 18)) + curves, failure=0.3))
        self.nugget("run", "model.k", "--quiet", "--until", 4e-2)
        told = [f["text"] for f in self.json("findings.json") if f["keyword"] == "*DEFINE_HAZ_PROPERTIES"]
        self.assertEqual(told, ["zone 4 changes 4 shells; least factor 0.852 on the yield stress, 0.75 on the strain at failure"])
        self.assertRegex(self.read("run.log"), r"part 1: [12] of 10 elements deleted")

    def test_what_cannot_be_softened_is_refused(self):
        for haz, law, told in ((zone((0, 0, 0, 0, -8, 0)) + curve(8, (0.0, 1.0), (1.0, 1.0)), None, "isc = -8: these welds have no diameter"),
                               (zone((0, 0, 99)), None, "isb = 99: curve 99 is not defined"),
                               (zone((0, 0, 0, 0, 0, 0, 8)) + curve(8, (0.0, 1.0), (1.0, 1.0)), "*MAT_ELASTIC\n", "part 1 is of *MAT_ELASTIC")):
            self.write(strip(haz, **({"law": law} if law else {})))
            self.assertIn(told, self.nugget("check", "model.k", "-o", "audit", expect=1).stderr)

    def test_interpolation_spot_welds_are_said_to_soften_nothing(self):
        """Rivets, which are cold, need no word. Sabotage: neither weld is looked at."""
        for name, text, said in (("spr3", spr3(), True), ("spr2", riveted(), False)):
            with self.subTest(name):
                haz = "*DEFINE_HAZ_PROPERTIES\n" + card(4, 1, 1, 0) + card(0, 0, 8) + curve(8, (0.0, 0.8), (10.0, 1.0))
                self.write(text.replace("*END", haz + "*END"))
                run = self.nugget("check", "model.k", "-o", "audit")
                self.assertEqual("zone 4 is not softened around 1 interpolation spot weld, first 401" in run.stderr, said, run.stderr)


if __name__ == "__main__":
    unittest.main()
