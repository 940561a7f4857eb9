# SPDX-License-Identifier: Apache-2.0
"""`nugget weld --stack`: diameter and strengths against the rules worked out by hand, units, refusals.

Sabotage that this catches: the thicker sheet in the rule of the diameter, strengths of the stronger steel, NRR and NRS in each other's fields.
"""
import math
import unittest

from nugget_command import CommandTest


class Stack(CommandTest):
    def card(self, *options, expect=0):
        run = self.nugget("weld", "--stack", *options, "-o", "card.k", expect=expect)
        if expect:
            return run
        lines = [line for line in self.read("card.k").splitlines() if not line.startswith("$")]
        fields = lambda line: [float(line[i:i + 10]) for i in range(0, len(line), 10)]  # noqa: E731
        at = lines.index("*MAT_SPOTWELD")
        beam = lines.index("*SECTION_BEAM")
        return {"material": fields(lines[at + 1]), "strength": fields(lines[at + 2]), "diameter": fields(lines[beam + 2])[0],
                "sheets": [fields(lines[i + 2])[0] for i, line in enumerate(lines) if line == "*SECTION_SHELL"], "said": run.stdout}

    def test_tearing_and_bearing(self):
        """2.7 sqrt(1.2) 5 sqrt(1.2) 440 = 13.5 1.2 440 = 7128 N; the nugget would bear pi/4 30 440 = 10367 N."""
        c = self.card("1.2:440,1.5:590")
        self.assertAlmostEqual(c["diameter"], 5.0 * math.sqrt(1.2), 5)
        self.assertEqual(c["strength"], [0.0, 5274.72, 7128.0, 7128.0, 0.0, 0.0, 0.0, 0.0])
        self.assertEqual(c["sheets"], [1.2, 1.5])
        self.assertIn("NRS = NRT 7128 N by tearing and bearing of a sheet between sheets 1 and 2", c["said"])

    def test_shear_of_the_nugget(self):
        """Rule 4 and thick sheets: pi/4 16 3 500 = 18850 N; tearing 2.7 4 3 500 = 16200 N still governs; with d = 5 it is pi/4 25 500 = 9817 N."""
        self.assertAlmostEqual(self.card("3:500,3:500", "--rule", "4")["strength"][2], 16200.0, 1)
        self.assertAlmostEqual(self.card("3:500,3:500", "--diameter", "5")["strength"][2], 9817.48, 1)

    def test_unlike_sheets(self):
        """t1 = 3 > 2.5 t = 2: 3.1 0.8 d 300 with d = 5 sqrt(0.8) = 3327 N, 0.7 d^2 300 = 4200 N, 2.7 sqrt(0.8) d 300 = 3240 N."""
        self.assertAlmostEqual(self.card("0.8:300,3:600")["strength"][2], 3240.0, 1)
        self.assertAlmostEqual(self.card("0.8:300,3:600", "--diameter", "3")["strength"][2], 0.7 * 9.0 * 300.0, 1)

    def test_the_weakest_pair_of_three(self):
        c = self.card("1.5:590,1.2:440,0.8:300")
        self.assertEqual(c["sheets"], [1.2, 0.8])
        self.assertAlmostEqual(c["strength"][2], 2.7 * 5.0 * 0.8 * 300.0, 1)

    def test_units_and_a_check_as_coupon(self):
        c = self.card("1.2:440,1.5:590", "--units", "mm, kg, ms")
        self.assertEqual(c["strength"][1:3], [5.27472, 7.128])
        self.assertEqual(c["material"][1:3], [7.85e-6, 210.0])
        run = self.nugget("coupon", "card.k", "-o", "coupons", "--decks")
        self.assertIn("lower sheet: thickness 1.2 (section 1 of the card)", run.stdout)

    def test_refusals(self):
        for stack, word in (("1.2:440", "1 sheets, expected two to four"), ("1.2,1.5", "'1.2', expected THICKNESS:STRENGTH"),
                            ("1.2:440,15:590", "'15:590', expected 0.3 to 6 mm")):
            with self.subTest(stack):
                self.assertIn(word, self.card(stack, expect=2).stderr)
                self.assertNotIn("card.k", self.files())
        self.nugget("weld", "-o", "card.k", expect=2)
        self.nugget("weld", "points.csv", "-o", "card.k", expect=2)
        self.card("1.2:440,1.5:590", "--rule", "6", expect=2)


if __name__ == "__main__":
    unittest.main()
