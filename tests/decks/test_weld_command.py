# SPDX-License-Identifier: Apache-2.0
"""`nugget weld`: from a list of points to a deck that passes `nugget check` and runs."""
import csv
import math
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


def large_sheets(before="", after=""):
    """Two sheets of 8 x 8 shells of 5 mm, 1.2 apart."""
    nodes, shells = "*NODE\n", "*ELEMENT_SHELL\n"
    for sheet in (1, 2):
        for j in range(9):
            for i in range(9):
                nodes += f"{1000 * sheet + 9 * j + i:8d}{5.0 * i:16.6f}{5.0 * j:16.6f}{1.2 * (sheet - 1):16.6f}\n"
        for j in range(8):
            for i in range(8):
                n = 1000 * sheet + 9 * j + i
                shells += "".join(f"{v:8d}" for v in (n, sheet, n, n + 1, n + 10, n + 9)) + "\n"
    text = sheets()
    begin, end = text.index("*NODE"), text.index("*END")
    text = re.sub(r"\*(BOUNDARY|DATABASE_HISTORY|LOAD|SET)[^\n]*\n[^*]*", "", text[:begin]) + before
    return text + nodes + shells + after + "*END\n"


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
        self.assertEqual([line.split(": ", 2)[1] for line in run.stderr.splitlines()], ["note", "note"], run.stderr)
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

    def test_sheets_without_an_end_time(self):
        """A mesh as a modeller leaves it; the run is described elsewhere."""
        mesh, count = re.subn(r"\*CONTROL_TERMINATION\n[^*]*", "", sheets())
        self.assertEqual(count, 1)
        self.write(LIST, "points.csv")
        self.write(mesh, "mesh.k")
        self.nugget("weld", "points.csv", "mesh.k", "-o", "welded.k")
        self.assertNotIn("*DATABASE_SWFORC", self.read("welded.k"))  # sabotage: a second one beside that of the run
        self.assertIn("no end time is given", self.nugget("check", "welded.k", "-o", "audit", expect=1).stderr)
        self.write(self.read("welded.k").replace("*INCLUDE", "*CONTROL_TERMINATION\n   2.0e-05\n*INCLUDE"), "ended.k")
        self.nugget("check", "ended.k", "-o", "audit")

    def test_strengths_over_the_diameter(self):
        """The same strengths for 4 and 6 mm are warned of; --scale-strength brings them to each weld's diameter."""
        points = "9,9,0.6,6.0\n9,4.5,0.5,4.0\n"
        strengths = ("--material", "nrr=9000,nrs=7200,nrt=7200,mrr=27000,mss=27000,mtt=27000")
        run = self.place(*strengths, points=points)
        self.assertIn("welds of diameters 4 to 6 have the same strengths, the smallest those of the largest: NRR = 9000, ",
                      run.stderr)
        run = self.place(*strengths, "--scale-strength", "6", points=points)
        self.assertIn("welds of diameter 4 have NRR = 4000, NRS = 3200, NRT = 3200, MRR = 8000, MSS = 8000, MTT = 8000, scaled "
                      "from diameter 6", run.stderr)
        self.assertNotIn("warning", run.stderr)
        self.nugget("check", "joined.k", "-o", "audit")
        self.assertEqual([f for f in self.json("audit/findings.json") if f["severity"] == "error"], [])
        for options, text in ((("--scale-strength", "6"), "no strength is given"),
                              ((*strengths, "--scale-strength", "-6"), "'-6', expected a length above 0")):
            self.assertIn(text, self.place(*options, points=points, expect=2).stderr)
        self.nugget("weld", "--stack", "1.2:440,1.5:590", "-o", "card.k", "--scale-strength", "6", expect=2)

    def test_bricks(self):
        for form, count in (("solid", 1), ("solid4", 4), ("solid8", 8), ("solid16", 16)):
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

    def test_interpolation(self):
        """A force law between the sheets, with the elastic stiffnesses of a round bar and the strengths that are given."""
        run = self.place("--as", "interpolation", "--material", "nrr=8000,nrs=6000,mss=16000,upf=0.1,upr=0.3",
                         points="9,9,0.6,6.0\n")
        self.assertEqual(run.stdout, "1 of 1 spots placed as 1 interpolation spot weld; joined.k\n")
        card = self.read("joined.k").split("*CONSTRAINED_INTERPOLATION_SPOTWELD\n")[1].splitlines()
        join, flow, stiffness = ([float(line[i:i + 10]) for i in range(0, len(line), 10)] for line in card[1:6:2])
        length, area = 1.2, math.pi * 9.0
        for got, expected in ((join[3], length), (join[4], 3.0), (join[5], 210000.0 * area / length), (join[6], 0.5),
                              (flow[0], 8000.0), (flow[1], 6000.0), (stiffness[0], 210000.0 / 2.6 * area / length),
                              (stiffness[1], 210000.0 * math.pi * 6.0 ** 4 / 64.0 / length)):
            self.assertAlmostEqual(got, expected, delta=1e-5 * expected)
        summary = self.run_it()
        (weld,) = summary["weld"]
        self.assertTrue(weld["tied"])
        self.assertAlmostEqual(weld["diameter"], 6.0, 6)
        self.assertAlmostEqual(summary["energy"]["ratio"], 1.0, 4)
        self.assertGreater(weld["peak"]["shear"], 100.0)
        # The joint has the stiffnesses of the beam that is tied in the same way.
        self.place(points="9,9,0.6,6.0\n")
        self.nugget("run", "joined.k", "--quiet", "--weld-tie", "area", "-o", "results")
        (beam,) = self.json("results/summary.json")["weld"]
        self.assertAlmostEqual(weld["peak"]["shear"] / beam["peak"]["shear"], 1.0, delta=0.05)
        for material, text in (("nrr=8000", "NRR and NRS need each other"),
                               ("mss=8000", "MSS and MRR count beside NRR and NRS only"),
                               ("nrr=8000,nrs=6000,upf=0.3", "UPR, above it, is where the weld breaks")):
            self.assertIn(text, self.place("--as", "interpolation", "--material", material, expect=1).stderr)
        self.assertIn("'tfail' is no field of --as interpolation",
                      self.place("--as", "interpolation", "--material", "tfail=1", expect=2).stderr)

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

    def adaptable(self, before="", after=""):
        """joined.k: the weld over a node of two sheets in an included file."""
        self.write(large_sheets(before, after), "car/sheets.k")
        self.write("20, 20, 0.6, 5.0\n", "points.csv")
        self.nugget("weld", "points.csv", "car/sheets.k", "-o", "joined.k")

    def test_adapt(self):
        self.adaptable()
        run = self.nugget("weld", "--adapt", "joined.k", "-o", "adapted.k")
        lines = run.stdout.splitlines()
        self.assertEqual(len(lines), 6, run.stdout)
        for line in lines[1:3]:
            self.assertRegex(line, r"^ +beam weld \d+ +[12] +\d+ +1\.00 +0\.00 +5 +5 +5 +36 +3\.54  Jacobian 1\.00 -> 0\.9")
        self.assertTrue(lines[3].startswith("2 of 2 ends of welds stand over a new element; 72 nodes moved; "), lines[3])
        self.assertEqual(lines[4:], ["adapted.k", "adapted_sheets.k"])
        self.assertIn("$ Nodes moved by nugget weld --adapt:\n$ " + lines[0], self.read("adapted.k"))
        old, new = (self.read(name).splitlines() for name in ("car/sheets.k", "adapted_sheets.k"))
        changed = [pair for pair in zip(old, new, strict=True) if pair[0] != pair[1]]
        self.assertEqual(len(changed), 72)
        for before, after in changed:
            self.assertEqual((before[:8], before[56:]), (after[:8], after[56:]))
        for name, place in (("joined.k", 1.0), ("adapted.k", 0.0)):
            self.nugget("check", name, "-o", "audit")
            with open(self.folder / "audit/welds.csv", encoding="utf-8") as file:
                (weld,) = csv.DictReader(file)
            for end in ("1", "2"):
                self.assertAlmostEqual(abs(float(weld["xi" + end])), place, 6)
                self.assertAlmostEqual(abs(float(weld["eta" + end])), place, 6)

    def coarse(self, extra="", keyword="*KEYWORD\n", x=35.0, y=35.0):
        """joined.k: a weld of 6 mm on two sheets of 7 x 7 elements of 10 mm; the weld's nodes are 901 and 902."""
        text = keyword + "*CONTROL_TERMINATION\n    1.0E-6\n*MAT_ELASTIC\n         1   7.85E-9  210000.0       0.3\n"
        nodes = shells = ""
        for part in (1, 2):
            text += f"*SECTION_SHELL\n{part:10}         2\n" + f"{1.5:10}" * 4 + f"\n*PART\nsheet\n{part:10}{part:10}{1:10}\n"
            number = lambda i, j: 100 * part + 8 * j + i  # noqa: B023, E731
            nodes += "".join(f"{number(i, j):8}{10.0 * i:16}{10.0 * j:16}{1.5 * (part - 1):16}\n" for j in range(8) for i in range(8))
            for j in range(7):
                for i in range(7):
                    corners = number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)
                    shells += "".join(f"{v:8}" for v in (100 * part + 7 * j + i, part, *corners)) + "\n"
        text += "*SECTION_BEAM\n         3         9       1.0         2       1.0\n       6.0       6.0\n*PART\nweld\n         3         3         3\n"
        text += "*MAT_SPOTWELD\n         3   7.85E-9  210000.0       0.3     300.0\n\n*SET_PART_LIST\n         1\n         1         2\n"
        text += "*CONTACT_SPOTWELD\n         3         1         3         2\n\n\n" + extra + "*NODE\n" + nodes
        text += f"{901:8}{x:16}{y:16}{0.0:16}\n{902:8}{x:16}{y:16}{1.5:16}\n*ELEMENT_SHELL\n" + shells
        self.write(text + f"*ELEMENT_BEAM\n{5001:8}{3:8}{901:8}{902:8}\n*END\n", "joined.k")

    def divided(self, **deck):
        self.coarse(**deck)
        run = self.nugget("weld", "--adapt", "--divide", "joined.k", "-o", "adapted.k")
        self.nugget("check", "adapted.k", "-o", "audit")
        return run.stdout

    def test_divide(self):
        for x, y in ((35.0, 35.0), (38.0, 33.0), (40.0, 35.0), (40.0, 40.0)):
            with self.subTest((x, y)):
                out = self.divided(x=x, y=y)
                self.assertRegex(out, r"(?m)^ +beam weld 5001 .* 0\.00 +10 +6 +6 .* divided, Jacobian 1\.00 -> 0\.[67]")
                self.assertIn("; 2 elements divided into five; shortest shell for the time step ", out)
                new = self.read("adapted.k").splitlines()
                at = new.index("*ELEMENT_SHELL")
                ids = [int(line[:8]) for line in new[at + 1:new.index("*ELEMENT_BEAM")]]
                self.assertEqual(len(ids), len(set(ids)))
                self.assertEqual(sorted(set(ids))[-8:], list(range(5002, 5010)))  # behind the beam's
                with open(self.folder / "audit/welds.csv", encoding="utf-8") as file:
                    (weld,) = csv.DictReader(file)
                self.assertLess(max(abs(float(weld[k])) for k in ("xi1", "eta1", "xi2", "eta2")), 1e-6)
                self.nugget("run", "adapted.k", "-o", "results", "--quiet")

    def test_divide_keeps_sets_right(self):
        by_part = "*SET_SHELL_GENERAL\n         5\nPART               1\n*SET_NODE_GENERAL\n         6\nPART               1         2\n"
        self.assertIn("2 elements divided", self.divided(extra=by_part))
        for extra, why in (
                ("*SET_SHELL_LIST\n         5\n       124       125\n", "a list of shells names it"),
                ("*DATABASE_HISTORY_SHELL\n       124\n", "a card names it"),
                ("*SET_SEGMENT\n         5\n       127       128       136       135\n", "a segment names it"),
                ("*SET_NODE_LIST\n         5\n       127       128       136       135\n", "lists name its nodes"),
                ("*SET_NODE_LIST_GENERATE\n         5\n       100       163\n", "with pieces of it node set 5 has other members"),
                ("*SET_SHELL_LIST_GENERATE\n         5\n       100       148\n", "with pieces of it shell set 5 has other members"),
                ("*INITIAL_STRESS_SHELL\n       124         1         1\n       0.0       1.0       1.0       1.0       0.0       0.0       0.0       0.0\n",
                 "it has initial stress")):
            with self.subTest(why):
                out = self.divided(extra=extra)
                self.assertIn("not divided: " + why, out)
                self.assertIn("; 1 element divided into five", out)

    def test_divide_in_other_formats(self):
        self.assertIn("2 elements divided", self.divided(keyword="*KEYWORD\n$ a remark\n"))
        text = self.read("joined.k")
        lines, inside = [], False
        for line in text.splitlines():
            inside = line in ("*NODE", "*ELEMENT_SHELL") if line.startswith("*") else inside
            plain = inside and not line.startswith("*")
            width = [8, 16, 16, 16] if plain and "." in line else [8] * 6
            cells, at = [], 0
            for w in width:
                cells.append(line[at:at + w].strip())
                at += w
            lines.append(",".join(cells) if plain else line)
        self.write("\n".join(lines) + "\n", "commas.k")
        run = self.nugget("weld", "--adapt", "--divide", "commas.k", "-o", "divided.k")
        self.assertIn("2 elements divided", run.stdout)
        self.nugget("check", "divided.k", "-o", "audit")
        self.nugget("weld", "--divide", "commas.k", "-o", "divided.k", expect=2)

    def test_adapt_leaves_what_must_stay(self):
        self.adaptable(before="*DATABASE_HISTORY_NODE\n" + "".join(f"{n:10d}" for n in range(1001, 1009)) + "\n")
        run = self.nugget("weld", "--adapt", "car/sheets.k", "-o", "adapted.k", expect=1)
        self.assertIn("car/sheets.k: error: the deck has no weld [place welds first: ", run.stderr)
        self.assertNotIn("adapted.k", self.files())
        self.nugget("weld", "--adapt", "joined.k", "-o", "joined.k", expect=2)
        self.nugget("weld", "--adapt", "points.csv", "joined.k", "-o", "adapted.k", expect=2)

    def test_adapt_refuses_what_would_change_a_set(self):
        """The box ends at x = 20: the middle node leaves it."""
        self.adaptable(before="*DEFINE_BOX\n         1      -1.0      20.5      -1.0      41.0      -1.0       0.1\n"
                              "*SET_SHELL_GENERAL\n         7\nBOX                1\n")
        run = self.nugget("weld", "--adapt", "joined.k", "-o", "adapted.k", expect=1)
        self.assertIn("the new deck does not say the same as the old one: shell set 7 has other members", run.stderr)
        self.assertNotIn("adapted.k", self.files())
        self.assertNotIn("adapted_sheets.k", self.files())

    def test_wrong_command_lines(self):
        for option, text in (("strength=1", "'strength' is no field of *MAT_SPOTWELD"), ("sigy=much", "expected sigy=NUMBER")):
            self.assertIn(text, self.place("--material", option, expect=2).stderr)
        self.place("--as", "solid12", expect=2)
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
