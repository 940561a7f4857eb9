# SPDX-License-Identifier: Apache-2.0
"""nugget.read(): a deck against its own text, and against what `nugget check` prints and writes."""
import os
import unittest

import numpy as np
import nugget
from lap_joint import deck
from nugget_command import CommandTest


class Decks(CommandTest):
    def setUp(self):
        super().setUp()
        before = os.getcwd()
        os.chdir(self.folder)
        self.addCleanup(os.chdir, before)

    def test_mesh_is_that_of_the_text(self):
        text = deck()
        self.write(text)
        d = nugget.read("model.k")
        lines = text.split("*NODE\n")[1].split("*")[0].splitlines()
        self.assertEqual(d.node_ids.tolist(), [int(line[:8]) for line in lines])
        self.assertEqual(d.coordinates.tolist(), [[float(line[c:c + 16]) for c in (8, 24, 40)] for line in lines])
        lines = text.split("*ELEMENT_SHELL\n")[1].split("*")[0].splitlines()
        self.assertEqual(d.shells.ids.tolist(), [int(line[:8]) for line in lines])
        self.assertEqual(d.shells.parts.tolist(), [int(line[8:16]) for line in lines])
        self.assertEqual(d.shells.nodes.tolist(), [[int(line[c:c + 8]) for c in range(16, 48, 8)] for line in lines])
        self.assertEqual(d.beams.nodes.tolist(), [[301, 302]])
        self.assertEqual(d.coordinates[d.beams.node_index[0]].tolist(), [[9.0, 9.0, 0.0], [9.0, 9.0, 1.2]])
        self.assertEqual((len(d.solids), d.solids.nodes.shape), (0, (0, 8)))
        self.assertEqual(d.shell_thickness.tolist(), 18 * [1.2])
        with self.assertRaisesRegex(LookupError, "there is no node 7"):
            d.node(7)

    def test_parts_units_and_keywords(self):
        self.write(deck())
        d = nugget.read("model.k")
        self.assertEqual({p.id: (p.title, p.kind, p.section, p.elform, p.material, p.law) for p in d.parts.values()},
                         {1: ("lower sheet", "shell", 1, 2, 1, "MAT_PIECEWISE_LINEAR_PLASTICITY"),
                          2: ("upper sheet", "shell", 1, 2, 1, "MAT_PIECEWISE_LINEAR_PLASTICITY"),
                          3: ("weld", "beam", 3, 9, 3, "MAT_SPOTWELD")})
        self.assertEqual((d.parts[1].thickness, d.parts[1].young, d.parts[1].density), (1.2, 210000.0, 7.85e-9))
        self.assertTrue(np.isnan(d.parts[3].thickness))
        self.assertEqual((d.title, d.units, d.end_time), ("lap joint of two sheets and one weld", "mm, t, s", 2e-5))
        self.assertEqual(d.files, [str(self.folder / "model.k")])
        self.assertEqual((d.keywords["*PART"], d.keywords["*SET_NODE_LIST"]), (3, 2))

    def test_welds_and_findings_are_those_of_the_check(self):
        self.write(deck())
        checked = self.nugget("check", "model.k", "-o", "checked")
        d = nugget.read("model.k")
        told = nugget.WeldTable(self.read("checked/welds.csv"))
        self.assertEqual((d.welds.count, d.welds["id"].tolist(), d.welds["parts"].tolist()), (1, [31], [(1, 2)]))
        for name in ("diameter", "length", "moved1", "edge_distance", "mass"):
            self.assertEqual(d.welds[name].tolist(), told[name].tolist(), name)
        self.assertEqual((d.welds[31]["case1"], d.welds[31]["segment2"]), (1, "206 207 211 210"))
        lines = checked.stderr.splitlines()
        for finding in d.findings:
            self.assertIn(str(finding), lines)
        self.assertEqual([(f.line, f.severity, f.keyword) for f in d.findings], [(48, "note", "*CONTACT_SPOTWELD 1")])

    def test_refused_deck_raises_all_findings_as_printed(self):
        self.write(deck(("       0.3     300.0", "       0.7     300.0"), ("         1         2    0.8333         3",
                                                                          "         1        99    0.8333         3")))
        checked = self.nugget("check", "model.k", expect=1)
        with self.assertRaises(nugget.DeckError) as raised:
            nugget.read("model.k")
        lines = str(raised.exception).splitlines()
        printed = checked.stderr.splitlines()
        errors = [f for f in raised.exception.findings if f.severity == "error"]
        self.assertEqual([(f.line, f.keyword, f.field, f.value) for f in errors],
                         [(38, "*MAT_PIECEWISE_LINEAR_PLASTICITY", "pr", "0.7"),
                          (35, "*SECTION_SHELL", "elform", "99")])
        for finding in errors:
            self.assertIn(str(finding), printed)
            self.assertIn(str(finding), lines)
        self.assertEqual(lines[-2:], ["2 errors, 0 warnings", "the deck is refused"])

    def test_no_deck(self):
        with self.assertRaisesRegex(nugget.DeckError, "nowhere.k: error: ") as raised:
            nugget.read("nowhere.k")
        self.assertEqual([f.severity for f in raised.exception.findings], ["error"])
        with self.assertRaisesRegex(ValueError, "weld_tie 'point', expected area or joint"):
            nugget.read("nowhere.k", weld_tie="point")


if __name__ == "__main__":
    unittest.main()
