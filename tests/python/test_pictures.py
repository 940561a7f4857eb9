# SPDX-License-Identifier: Apache-2.0
"""r.plot() and r.picture(): the SVG that the command draws, shown by a notebook, saved."""
import unittest
import xml.etree.ElementTree as xml

import nugget
from lap_joint import deck
from nugget_command import CommandTest


class Pictures(CommandTest):
    def run_deck(self):
        self.write(deck())
        self.nugget("run", "model.k", "-o", "out", "--quiet")
        return nugget.results(self.folder / "out")

    def texts(self, svg):
        return [element.text for element in xml.fromstring(svg).iter() if element.tag.endswith("text")]

    def test_plot_is_that_of_the_command(self):
        r = self.run_deck()
        for channels, options, python in ((("swforc/31/shear",), (), {}),
                                          (("glstat/*energy", "swforc/shear"), (), {}),
                                          (("swforc/31/shear",), ("--over", "nodout/216/x_displacement"),
                                           {"over": "nodout/216/x_displacement"})):
            self.nugget("plot", "out", *channels, *options, "-o", "command.svg")
            plot = r.plot(*channels, **python)
            self.assertEqual(plot._repr_svg_(), self.read("command.svg"))
        self.assertIn("swforc/weld 31/shear", self.texts(r.plot("swforc/31/shear").svg))
        self.assertIn("swforc: 21 values over time [s]", r.channels)

    def test_two_runs_in_one_plot(self):
        r = self.run_deck()
        self.write(deck(("    8000.0    6000.0    6000.0", "    8000.0     600.0     600.0")))
        self.nugget("run", "model.k", "-o", "weak", "--quiet")
        legend = self.texts(r.plot("swforc/31/shear", other=nugget.results(self.folder / "weak")).svg)
        self.assertEqual(len([text for text in legend if "swforc/weld 31/shear" in (text or "")]), 2)

    def test_saved(self):
        plot = self.run_deck().plot("swforc/31/shear")
        plot.save(self.folder / "plot.svg")
        self.assertEqual(self.read("plot.svg"), plot.svg)
        plot.save(self.folder / "plot.png", width=640)
        png = (self.folder / "plot.png").read_bytes()
        self.assertEqual((png[:4], int.from_bytes(png[16:20], "big")), (b"\x89PNG", 640))
        with self.assertRaisesRegex(ValueError, "plot.pdf: a picture is an .svg or a .png"):
            plot.save("plot.pdf")
        with self.assertRaisesRegex(OSError, "no_such_folder"):
            plot.save(self.folder / "no_such_folder" / "plot.svg")

    def test_picture_is_that_of_the_command(self):
        r = self.run_deck()
        self.nugget("picture", "out", "-o", "command.svg", "--field", "von_mises_stress", "--weld", 31, "--state", 3)
        options = {"field": "von_mises_stress", "weld": 31, "shapes": True}
        picture = r.picture(state=3, **options)
        self.assertTrue(picture._repr_svg_() == self.read("command.svg"))
        self.assertFalse(r.picture(state=4, **options).svg == picture.svg)
        self.assertIn("data:image/png", r.picture().svg)

    def test_a_notebook_shows_the_run(self):
        """Results as the last line of a cell: how it ended, the model, its energies; after `nugget modes` no energies."""
        r = self.run_deck()
        shown = r._repr_html_()
        self.assertIn("lap joint of two sheets and one weld", shown)
        self.assertIn("normal termination; 1 welds", shown)
        self.assertEqual(shown.count("<svg"), 2)
        self.assertIn(r.picture(width=900, height=600).svg, shown)
        self.assertIn(r.plot("glstat/kinetic_energy", "glstat/internal_energy", "glstat/total_energy").svg, shown)
        for path in (self.folder / "out").iterdir():
            if path.name != "summary.json":
                path.unlink()
        self.assertNotIn("<svg", nugget.results(self.folder / "out")._repr_html_())

    def test_refusals(self):
        r = self.run_deck()
        for what, text in ((lambda: r.plot("swforc/31/force"), "no channel 'swforc/31/force', expected FILE/ENTITY/QUANTITY"),
                           (lambda: r.picture(weld=32), "32")):
            with self.assertRaisesRegex(LookupError, text):
                what()
        for what, text in ((r.plot, "needs a channel; there are:\nglstat: "),
                           (lambda: r.plot("swforc", cfc=61), "class 61, expected 60, 180, 600, 1000"),
                           (lambda: r.picture(field="heat"), "field 'heat', expected plastic_strain, ")):
            with self.assertRaisesRegex(ValueError, text):
                what()


if __name__ == "__main__":
    unittest.main()
