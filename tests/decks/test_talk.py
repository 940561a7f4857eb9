# SPDX-License-Identifier: Apache-2.0
"""The figures of S. Bala's talk (examples/talk): every number of their runs beside what the talk or a formula says. docs/verification/talk.md
names these tests; the example of the talk itself, a coupon torn apart, is in examples/test_examples.py.

Sabotage that this catches: a tenth of the torsion lost in the in-plane forces, the exponents of a rigid weld left out, hourglass types 4 and
5 without QM, the rate of the engineering shear for SIGTAU, a tolerance three times as large.
"""
import pathlib
import sys
import unittest

from nugget_command import NUGGET, SOURCE, CommandTest

sys.path.insert(0, str(SOURCE / "examples" / "talk"))
import draw  # noqa: E402
import make  # noqa: E402
import projections  # noqa: E402


class Talk(CommandTest):
    def results(self, name):
        (topic,) = make.topics([name]).values()
        return topic, draw.results_of(NUGGET, pathlib.Path(self.folder), topic)

    def check(self, name):
        topic, results = self.results(name)
        rows = list(topic.rows(results))
        self.assertTrue(rows)
        for what, value, reference, gate, _ in rows:
            self.assertFalse(draw.outside(value, reference, gate), f"{what}: {value}, expected {reference}")

    def test_diameter_and_length_over_thickness(self):
        self.check("thickness")

    def test_rigid_welds(self):
        self.check("rigid")

    def test_torsion(self):
        self.check("torsion")

    def test_hourglass_types_in_bending(self):
        self.check("hourglass")

    def test_time_steps(self):
        self.check("steps")

    def test_eight_projections(self):
        self.check("projections")

    def test_bricks_stand_anywhere(self):
        self.check("forms")

    def test_mesh_below_a_weld(self):
        self.check("meshes")

    def test_stresses_of_a_bar_with_rates(self):
        self.check("toyota")

    def test_list_of_tied_nodes(self):
        """OUTSEG = 1: each weld node with its segment in run.log."""
        m = projections.deck(1)
        m.keyword("CONTROL_CONTACT")
        for fields in ({"slsfac": 0.1}, {"usrstr": 0}, {"sfric": 0.0}, {"ignore": 0, "frceng": 0, "skiprwg": 0, "outseg": 1}):
            m.card(**fields)
        m.write(self.folder / "model.k")
        self.nugget("run", "model.k", "--quiet")
        for node, segment in ((9001, "1006 1007 1011 1010"), (9002, "2006 2007 2011 2010")):
            self.assertIn(f"node {node} on segment {segment} (shell", self.read("run.log"))

    def test_every_figure_has_its_page(self):
        folder = SOURCE / "docs" / "verification"
        pages = "".join(path.read_text(encoding="utf-8") for path in folder.glob("talk_*.md"))
        for topic in make.TOPICS:
            self.assertEqual(pages.count(f"(img/talk_{topic}.svg)"), 1, topic)
            self.assertTrue((folder / "img" / f"talk_{topic}.svg").exists(), topic)

    def test_figures(self):
        """One that is quick; all are drawn in the same way."""
        try:
            import figures
        except ImportError:
            self.skipTest("this Python has no matplotlib")
        topic, results = self.results("torsion")
        figures.save(topic.draw(results), self.folder / "torsion.svg")
        self.assertIn("_WITH_TORSION", self.read("torsion.svg"))


if __name__ == "__main__":
    unittest.main()
