# SPDX-License-Identifier: Apache-2.0
"""`nugget weld`: from a list of points to a deck that passes `nugget check` and runs."""
import re
import unittest

from lap_joint import deck
from nugget_command import CommandTest

LIST = "x, y, z, diameter, parts, class\n9, 9, 0.6, , 1+2, inner\n9, 4.5, 0.5, 4.0\n"


def sheets():
    """The lap joint without its weld."""
    text = deck(("*SET_PART_LIST\n         1\n         1         2\n", ""), ("*DATABASE_SWFORC\n  1.00e-06\n", ""),
                ("*PART\nweld\n         3         3         3\n", ""))
    for keyword in ("SECTION_BEAM", "MAT_SPOTWELD", "CONTACT_SPOTWELD", "ELEMENT_BEAM"):
        text, count = re.subn(rf"\*{keyword}\n[^*]*", "", text)
        assert count == 1, keyword
    return re.sub(r" +30[12] .*\n", "", text)


class Weld(CommandTest):
    def place(self, *options, points=LIST, expect=0):
        self.write(sheets(), "car/sheets.k")
        self.write(points, "points.csv")
        return self.nugget("weld", "points.csv", "car/sheets.k", "-o", "joined.k", *options, expect=expect)

    def run_it(self):
        self.nugget("run", "joined.k", "--quiet", "-o", "results")
        return self.json("results/summary.json")

    def test_beams(self):
        run = self.place("--material", "nrr=8000,nrs=6000,nrt=6000", "--material", "inner:sigy=600")
        self.assertEqual(run.stdout, "2 of 2 spots placed as 2 beams; joined.k\n")
        self.assertEqual(run.stderr, "")
        text = self.read("joined.k")
        self.assertIn("*INCLUDE\ncar/sheets.k\n", text)
        self.nugget("check", "joined.k", "-o", "audit")
        self.assertEqual([f for f in self.json("audit/findings.json") if f["severity"] == "error"], [])
        summary = self.run_it()
        inner, other = summary["weld"]
        self.assertAlmostEqual(inner["diameter"], 5.0 * 1.2 ** 0.5, 4)
        self.assertEqual((other["diameter"], other["parts"], other["tied"]), (4.0, [1, 2], True))
        self.assertEqual([(p["xi"], p["eta"], p["moved"]) for p in inner["projection"]], [(0.0, 0.0, 0.0)] * 2)
        self.assertNotEqual(inner["part"], other["part"])
        self.assertGreater(inner["peak"]["shear"], 100.0)
        self.assertAlmostEqual(summary["energy"]["ratio"], 1.0, 4)
        self.assertIn("swforc", self.files("results"))

    def test_bricks(self):
        for form, count in (("solid", 1), ("solid4", 4), ("solid8", 8)):
            with self.subTest(form):
                run = self.place("--as", form, points="9,9,0.6\n")
                self.assertEqual(run.stdout, f"1 of 1 spots placed as {count} brick{'s' * (count > 1)}; joined.k\n")
                summary = self.run_it()
                self.assertEqual(summary["elements"]["solid"], count)
                (weld,) = summary["weld"]
                self.assertAlmostEqual(weld["diameter"], 5.0 * 1.2 ** 0.5, 4)
                self.assertTrue(weld["tied"])
                self.assertEqual(weld["kind"], "solid" if count == 1 else "assembly")
                self.assertAlmostEqual(summary["energy"]["ratio"], 1.0, 4)

    def test_points_without_sheets_are_told(self):
        run = self.place(points=LIST + "30, 9, 0.6\n9, 9, 7\n")
        self.assertEqual(run.stdout, "2 of 4 spots placed as 2 beams; joined.k\n")
        self.assertIn("points.csv:4: warning: the point (30, 9, 0.6): found no sheet, expected two to four sheets; the next is "
                      "part 1, 12.01 away; not placed [", run.stderr)
        self.assertIn("points.csv:5: warning: the point (9, 9, 7): found no sheet", run.stderr)

    def test_refusals_write_nothing(self):
        for points, text in (("9, nine, 0.6\n", "points.csv:1: error: y = nine: expected a number"),
                             ("90, 90, 90\n", "points.csv: error: no point of the list found its sheets"),
                             ("<xmcf>\n", "points.csv:1: error: this is no sound XML")):
            with self.subTest(points):
                run = self.place(points=points, expect=1)
                self.assertIn(text, run.stderr)
                self.assertNotIn("joined.k", self.files())

    def test_wrong_command_lines(self):
        for option, text in (("strength=1", "'strength' is no field of *MAT_SPOTWELD"), ("sigy=much", "expected sigy=NUMBER")):
            self.assertIn(text, self.place("--material", option, expect=2).stderr)
        self.place("--as", "solid16", expect=2)
        before = self.read("car/sheets.k")
        run = self.nugget("weld", "points.csv", "car/sheets.k", "-o", "car/sheets.k", expect=2)
        self.assertIn("would be overwritten", run.stderr)
        self.assertEqual(self.read("car/sheets.k"), before)

    def test_xmcf(self):
        self.place(points="""<?xml version="1.0"?>
<xmcf><version>3.1.1</version><units length="m"/><connection_group id="1">
<connected_to><part index="1" pid="1"/><part index="2" pname="upper sheet"/></connected_to>
<connection_list><connection_0d><loc>0.009 0.009 0.0006</loc><spotweld diameter="0.005"/></connection_0d></connection_list>
</connection_group></xmcf>
""")
        (weld,) = self.run_it()["weld"]
        self.assertEqual((weld["diameter"], weld["parts"]), (5.0, [1, 2]))

    def test_units_that_are_not_known(self):
        self.write(sheets().replace("7.85e-09", "1.00e-07"), "sheets.k")
        self.write("9,9,0.6\n", "points.csv")
        run = self.nugget("weld", "points.csv", "sheets.k", "-o", "joined.k", expect=1)
        self.assertIn("the units of the model are not recognised", run.stderr)
        run = self.nugget("weld", "points.csv", "sheets.k", "-o", "joined.k", "--diameter", "5", expect=1)
        self.assertIn("ro has no default", run.stderr)
        self.nugget("weld", "points.csv", "sheets.k", "-o", "joined.k", "--diameter", "5", "--material",
                    "ro=1e-7,e=2.1e5,sigy=500,eh=1000")
        self.nugget("check", "joined.k")


if __name__ == "__main__":
    unittest.main()
