# SPDX-License-Identifier: Apache-2.0
"""Values of a deck changed in its text: what was changed, and every other byte as it was."""
import os
import unittest

import nugget
from lap_joint import CARDS, deck, mesh
from nugget_command import CommandTest

SECOND_WELD = (f"{31:8d}{3:8d}{301:8d}{302:8d}{0:8d}\n",
               f"{31:8d}{3:8d}{301:8d}{302:8d}{0:8d}\n$ the second one\n{32:8d}{3:8d}{303:8d}{304:8d}{0:8d}\n")
ITS_NODES = (f"{302:8d}{9.0:16.4f}{9.0:16.4f}{1.2:16.4f}\n",
             f"{302:8d}{9.0:16.4f}{9.0:16.4f}{1.2:16.4f}\n{303:8d}{15.0:16.4f}{9.0:16.4f}{0.0:16.4f}\n"
             f"{304:8d}{15.0:16.4f}{9.0:16.4f}{1.2:16.4f}\n")
WITH_PARAMETER = ("*PART\nlower sheet", "*PARAMETER\nR    thick       1.2I      nip         3\n*PARAMETER_EXPRESSION\n"
                  "R   double  2.0*thick\n*PART\nlower sheet")


class Changes(CommandTest):
    def setUp(self):
        super().setUp()
        before = os.getcwd()
        os.chdir(self.folder)
        self.addCleanup(os.chdir, before)

    def lines(self, name):
        return (self.folder / name).read_bytes().split(b"\n")

    def changed(self, old, new):
        """{number of a line: its new text} where both have as many lines."""
        before, after = self.lines(old), self.lines(new)
        self.assertEqual(len(before), len(after))
        return {i: b.decode() for i, (a, b) in enumerate(zip(before, after), 1) if a != b}

    def refused(self, text, what, *arguments, error=ValueError):
        with self.assertRaisesRegex(error, text):
            what(*arguments)

    def test_a_field(self):
        (self.folder / "model.k").write_bytes(deck().replace("lap joint", "Überlappung").replace("\n", "\r\n").encode("latin-1"))
        d = nugget.read("model.k")
        weld = d.card("MAT_SPOTWELD", 3)
        self.assertEqual((weld["nrr"], weld["mid"], weld["ro"], weld["dt"]), (8000.0, 3, 7.85e-9, None))
        self.assertEqual((weld.keyword, weld.line, weld.id, weld.text("ro")), ("*MAT_SPOTWELD", 46, 3, "7.85e-09"))
        weld["nrr"] = 9000.5
        d.card("MAT_024", 1)["sigy"] = 345
        self.assertEqual(weld["nrr"], 9000.5)
        new = d.write("new.k")
        changed = self.changed("model.k", "new.k")
        self.assertEqual(changed, {38: "         1  7.85e-09  210000.0       0.3     345.0    1000.0\r",
                                   47: "       0.0    9000.5    6000.0    6000.0    9000.0    7000.0    7000.0\r"})
        self.assertEqual(new.card("MAT_SPOTWELD", 3)["nrr"], 9000.5)
        self.assertAlmostEqual(nugget.run(new, directory="out").welds["peak_failure"][0] /
                               nugget.run("model.k", directory="before").welds["peak_failure"][0], 1.0, 2)

    def test_fields_that_cannot_be_changed(self):
        self.write(deck())
        d = nugget.read("model.k")
        weld = d.card("*MAT_SPOTWELD")
        self.refused("model.k:46: \\*MAT_SPOTWELD has no field 'strength' in its lines; there are: mid, ro, ",
                     weld.__setitem__, "strength", 1.0)
        self.refused("\\*MAT_SPOTWELD mid, which has 10 columns = 1.5: expected a whole number", weld.__setitem__, "mid", 1.5)
        self.refused("nrr, .* = -1.23456e-05: it does not fit with five digits", weld.__setitem__, "nrr", -1.23456e-5)
        self.refused("'12345678901' has 11 characters, and the field 10 columns", weld.__setitem__, "nrr", "12345678901")
        self.refused("has 3 fields 'o', which are not told apart by name", d.card("DEFINE_CURVE", 1).__setitem__, "o", 7)
        self.refused("there is no MAT_SPOTWELD 4; there are those of 3", d.card, "MAT_SPOTWELD", 4, error=LookupError)
        self.refused("3 cards are PART: ", d.card, "PART", error=LookupError)
        self.refused("there is no MAT_RIGID", d.card, "MAT_RIGID", 4, error=LookupError)
        self.assertFalse(d.is_changed)
        self.refused("model.k would be overwritten; give another name", d.write, "model.k")

    def test_what_was_changed_is_checked(self):
        self.write(deck())
        d = nugget.read("model.k")
        d.card("MAT_024", 1)["pr"] = 0.7
        self.refused("has changes that are not written", lambda: nugget.run(d, directory="out"))
        with self.assertRaises(nugget.DeckError) as raised:
            d.write("new.k")
        self.assertEqual([(f.file, f.field) for f in raised.exception.findings if f.severity == "error"], [("new.k", "pr")])

    def test_parameters(self):
        self.write(deck(WITH_PARAMETER, ("       1.2       1.2       1.2       1.2", "    &thick    &thick    &thick    &thick"),
                        ("         1         2    0.8333         3", "         1         2    0.8333      &nip")))
        d = nugget.read("model.k")
        self.assertEqual(dict(d.parameters), {"thick": 1.2, "nip": 3, "double": 2.4})
        section = d.card("SECTION_SHELL", 1)
        self.assertEqual((section["t1"], section.text("t1"), section["nip"]), (1.2, "&thick", 3))
        d.parameters["THICK"] = 1.0 / 0.7
        d.parameters["nip"] = 5
        self.assertEqual(d.parameters["nip"], 5)
        new = d.write("new.k")
        line, = self.changed("model.k", "new.k").values()
        self.assertEqual(line, "R    thick 1.4285714I      nip         5")
        self.assertAlmostEqual(new.parts[1].thickness, 1.4285714, 12)
        self.assertEqual(new.card("SECTION_SHELL", 1)["nip"], 5)
        self.refused("'double' is computed by an expression", d.parameters.__setitem__, "double", 3.0)
        self.refused("there is no parameter 'width'; there are: double, nip, thick", d.parameters.__setitem__, "width", 3.0)
        self.refused("'nip', which has 10 columns = 2.5: expected a whole number", d.parameters.__setitem__, "nip", 2.5)

    def test_a_weld_removed(self):
        self.write(deck(SECOND_WELD, ITS_NODES))
        d = nugget.read("model.k")
        self.assertEqual(d.welds["id"].tolist(), [31, 32])
        self.refused("there is no weld 33", d.remove_weld, 33)
        d.remove_weld(31)
        new = d.write("new.k")
        self.assertEqual(new.welds["id"].tolist(), [32])
        before = self.lines("model.k")
        self.assertEqual(self.lines("new.k"), [line for line in before if line != SECOND_WELD[0].encode().rstrip(b"\n")])
        d.remove_weld(32)
        self.assertIn(b"$ the second one\n*END\n", d._changes.write("none.k") and (self.folder / "none.k").read_bytes())

    def test_a_weld_moved(self):
        self.write(deck(SECOND_WELD, ITS_NODES))
        d = nugget.read("model.k")
        d.move_weld(31, (4.0, 8.0, 0.6))
        new = d.write("new.k")
        self.assertEqual(len(self.changed("model.k", "new.k")), 2)
        self.assertEqual([new.welds[31][c] for c in "xyz"], [4.0, 8.0, 0.6])
        self.assertEqual([new.welds[32][c] for c in "xyz"], [15.0, 9.0, 0.6])
        self.assertEqual(new.coordinates[new.node(302)].tolist(), [4.0, 8.0, 1.2])
        self.assertTrue(new.welds[31]["tied"])

    def test_a_weld_on_nodes_of_its_sheet_does_not_move(self):
        self.write(deck((f"{31:8d}{3:8d}{301:8d}{302:8d}{0:8d}", f"{31:8d}{3:8d}{106:8d}{302:8d}{0:8d}")))
        d = nugget.read("model.k", skip_unsupported=False)
        self.refused("node 106 of weld 31 is one of shell 1[0-9] too, which would move with it", d.move_weld, 31, (4.0, 8.0, 0.6))

    def test_included_files(self):
        self.write(CARDS + "*INCLUDE\nmesh/joint.k\n*END\n")
        self.write("*KEYWORD\n" + mesh() + "*END\n", "mesh/joint.k")
        d = nugget.read("model.k")
        d.card("MAT_SPOTWELD", 3)["nrr"] = 9000
        d.write("stronger.k")
        self.assertEqual(self.files(), ["mesh", "model.k", "stronger.k"])
        self.assertEqual(len(self.changed("model.k", "stronger.k")), 1)
        d.move_weld(31, (4.0, 8.0, 0.6))
        (self.folder / "new").mkdir()
        new = d.write("new/moved.k")
        self.assertEqual(self.files("new"), ["moved.k", "moved_joint.k"])
        self.assertEqual(len(self.changed("mesh/joint.k", "new/moved_joint.k")), 2)
        self.assertEqual(sorted(self.changed("model.k", "new/moved.k").values()),
                         ["       0.0    9000.0    6000.0    6000.0    9000.0    7000.0    7000.0", "moved_joint.k"])
        self.assertEqual((new.welds[31]["x"], new.card("MAT_SPOTWELD", 3)["nrr"]), (4.0, 9000.0))

    def test_files_that_a_transform_changes_or_that_are_included_twice(self):
        section = "*KEYWORD\n*SECTION_BEAM\n         7         9       1.0         2       1.0\n       6.0       6.0       0.0       0.0\n*END\n"
        self.write(section, "section.k")
        transform = "*INCLUDE_TRANSFORM\nsection.k\n\n         0         0       100\n       1.0       1.0      10.0\n\n"
        self.write(deck(("*PART\nlower", transform + "*PART\nlower")))
        d = nugget.read("model.k")
        of_file = [c for c in d.cards("SECTION_BEAM") if c.file.endswith("section.k")]
        self.refused("ts1 stands in .*section.k, which \\*INCLUDE_TRANSFORM gives other ids or units",
                     of_file[0].__setitem__, "ts1", 5.0)
        self.write("*KEYWORD\n*DATABASE_ELOUT\n  1.00e-06\n*END\n", "twice.k")
        self.write(deck(("*PART\nlower", "*INCLUDE\ntwice.k\ntwice.k\n*PART\nlower")))
        d = nugget.read("model.k")
        self.refused("twice.k, which is included more than once", d.cards("DATABASE_ELOUT")[0].__setitem__, "dt", 1e-5)

    def test_welds_placed_are_those_of_the_command(self):
        self.write(deck(("*END\n", "*END\n")))
        self.write("x,y,z,diameter,parts,class\n4.0,12.0,0.6,5.0,1+2,\n15.0,9.0,0.6,,,\n", "points.csv")
        self.nugget("weld", "points.csv", "model.k", "-o", "command.k", "--material", "nrr=9000.0,nrs=7000.0")
        points = [{"x": 4.0, "y": 12.0, "z": 0.6, "diameter": 5.0, "parts": (1, 2)}, (15.0, 9.0, 0.6)]
        placed = nugget.place_welds(points, "model.k", "module.k", material={"nrr": 9000.0, "nrs": 7000.0})
        self.assertEqual(self.read("module.k").replace("module.k", ""), self.read("command.k").replace("command.k", ""))
        self.assertEqual((placed.welds.count, placed.welds["diameter"].tolist()[1]), (3, 5.0))
        self.refused("form 'ring', expected beam, solid, solid4, solid8, solid16, interpolation",
                     lambda: nugget.place_welds(points, "model.k", "none.k", form="ring"))
        self.refused("no welds were placed", lambda: nugget.place_welds([(99.0, 99.0, 0.0)], "model.k", "none.k"))
        self.refused("point 0: 'width' is none of x, y, z,",
                     lambda: nugget.place_welds([{"x": 1.0, "width": 2.0}], "model.k", "none.k"))


if __name__ == "__main__":
    unittest.main()
