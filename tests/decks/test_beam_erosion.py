# SPDX-License-Identifier: Apache-2.0
"""*MAT_ADD_EROSION on beams: bars of ELFORM 1 and 3 pulled at a constant speed go when the closed form of a bar says so; of a bent beam the
points of the cross-section are counted."""
import math
import unittest

from nugget_command import CommandTest

E, NU, LENGTH, SPEED, END = 210000.0, 0.3, 10.0, 4000.0, 2e-4
STEEL = f"1,7.85e-9,{E},{NU}"
ELASTIC, PLASTIC = f"*MAT_001\n{STEEL}\n", f"*MAT_024\n{STEEL},300.0\n\n\n\n"


def bars(material, first="", second="", elform=1, a=(2 / 7, 3 / 7, 6 / 7)):
    """A bar pulled along a line, held in all other directions."""
    nodes = [(1, 0, 0, 0), (2, *(LENGTH * x for x in a)), (3, 50, 9, 0)]
    section = {1: "2.0,2.0,2.0,2.0", 2: "4.0,1.3,1.3,2.0", 3: "4.0"}[elform]
    return "\n".join([
        "*KEYWORD", f"*CONTROL_TERMINATION\n{END}\n*CONTROL_TIMESTEP\n0,0.05", f"*DATABASE_GLSTAT\n{END / 2000:g}", material + f"*MAT_ADD_EROSION\n1,{first}\n{second}",
        f"*SECTION_BEAM\n1,{elform},1.0,2,0\n{section}\n*PART\nbar\n1,1,1\n*ELEMENT_BEAM\n1,1,1,2,3", "*DEFINE_CURVE\n1\n0,1\n1,1",
        "*BOUNDARY_SPC_NODE\n1,0,1,1,1,1,1,1\n*BOUNDARY_SPC_NODE\n2,0,0,0,0,1,1,1",
        f"*DEFINE_VECTOR\n1,0,0,0,{a[0]},{a[1]},{a[2]}\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n2,-4,0,1,{SPEED},1",
        "*NODE", *(",".join(map(str, n)) for n in nodes), "*END", ""])


class BeamErosion(CommandTest):
    def deleted(self, text):
        """Time at which the beam goes, to a cycle; nothing where it stays."""
        self.nugget("run", self.write(text).name, "--quiet")
        return next((state["time"] for state in self.glstat() if state["eroded internal energy"] > 0.0), None)

    def test_bars(self):
        def at_strain(strain):
            return LENGTH * math.expm1(strain) / SPEED
        for name, material, first, second, expected in (
                ("MXEPS", ELASTIC, "", "0,0,0,0.05", at_strain(0.05)),
                ("SIGVM", ELASTIC, "", "0,0,2100.0", at_strain(0.01)),
                ("SIGP1", ELASTIC, "", "0,2100.0", at_strain(0.01)),
                ("MNPRES", ELASTIC, "", "-700.0", at_strain(0.01)),
                ("VOLEPS", ELASTIC, "0,0,0,0,0.008", "", at_strain(0.02)),  # (1 - 2 nu) of the strain
                ("EPSSH", ELASTIC, "", "0,0,0,0,0.0195", at_strain(0.03)),  # (1 + nu) / 2 of the strain
                ("FAILTM", ELASTIC, "", "0,0,0,0,0,0,0,7e-5", 7e-5),
                ("MXEPS of a bar that yields", PLASTIC, "", "0,0,0,0.06", at_strain(0.06)),
                ("EFFEPS below 0: plastic strain", PLASTIC, "0,0,0,-0.04", "", at_strain(0.04 + 300.0 / E)),
                ("the first of two", PLASTIC, "0,0,0,-0.04", "0,0,0,0.03", at_strain(0.03)),
                ("EPSSH of a bar that yields", PLASTIC, "", "0,0,0,0,0.03",  # 3/4 of the plastic strain, (1 + nu) / 2 of the elastic
                 at_strain((0.03 - 0.65 * 300.0 / E) / 0.75 + 300.0 / E))):
            with self.subTest(name):
                for elform in (1, 3):
                    time = self.deleted(bars(material, first, second, elform))
                    self.assertIsNotNone(time)
                    self.assertAlmostEqual(time, expected, delta=0.01 * expected + 4e-7)  # two cycles

    def test_energy_of_what_went(self):
        """What the bar held is eroded: the strain energy of 250 MPa."""
        self.deleted(bars(ELASTIC, "", "0,0,250.0"))
        held = 0.5 * 250.0**2 / E * 4.0 * LENGTH
        last = self.glstat()[-1]
        self.assertAlmostEqual(last["eroded internal energy"], held, delta=0.02 * held)
        self.assertAlmostEqual(last["total energy / initial energy"], 1.0, delta=0.02)

    def test_points_of_a_bent_beam(self):
        """2 x 2 points of a square, two of them pulled: with NUMFIP 1 and 2 it goes when they reach MXEPS, with 3 it stays."""
        def bent(points):
            rate = 40.0
            text = bars(ELASTIC, f"0,0,0,0,0,{points}", "0,0,0,0.0002", a=(1, 0, 0))
            turning = f"*BOUNDARY_PRESCRIBED_MOTION_NODE\n2,7,0,1,{rate}\n"
            text = text[:text.index("*DEFINE_VECTOR")] + turning + text[text.index("*NODE\n1,"):]
            text = text.replace("*BOUNDARY_SPC_NODE\n2,0,0,0,0,1,1,1", "*BOUNDARY_SPC_NODE\n2,0,1,0,1,1,1,0")
            return self.deleted(text), 0.0002 * LENGTH * math.sqrt(3.0) / rate  # points at 1/sqrt(3) from the middle, half a side of 1
        for points in (1, 2):
            time, expected = bent(points)
            self.assertIsNotNone(time)
            self.assertAlmostEqual(time, expected, delta=0.02 * expected)
        self.assertIsNone(bent(3)[0])

    def test_what_is_refused(self):
        for first, second, more, reason in (
                ("0,0,0,0,0,-50", "0,0,0,0.05", "", "NUMFIP of *MAT_ADD_EROSION as a percentage of layers is not built for beams"),
                ("", "\n\n0,0,0.1", "", "EPSTHIN of *MAT_ADD_EROSION is a limit of layers: a beam has none")):
            run = self.nugget("check", self.write(bars(ELASTIC, first, second) + more).name, expect=1)
            self.assertIn(reason, run.stderr)
        run = self.nugget("check", self.write(bars(ELASTIC, "", "0,0,0,0.05", 2)).name, expect=1)
        self.assertIn("resultant beams (ELFORM 2) are elastic here", run.stderr)


if __name__ == "__main__":
    unittest.main()
