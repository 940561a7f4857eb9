# SPDX-License-Identifier: Apache-2.0
"""nugget plot and nugget picture: what they draw stands in the files of the run; what cannot be drawn is refused."""
import csv
import io
import re
import struct
import unittest
import xml.etree.ElementTree as ElementTree

import damaged
from lap_joint import deck
from nugget_command import SOURCE, CommandTest
from test_mode_studies import strips

SVG = "{http://www.w3.org/2000/svg}"


def size_of_png(path):
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", path
    return struct.unpack(">II", data[16:24])


class Pictures(CommandTest):
    def svg(self, name):
        return ElementTree.fromstring(self.read(name))

    def run_deck(self, text=None, folder="."):
        self.write(text or deck())
        self.nugget("run", "model.k", "-o", folder, "--quiet")

    def extremes(self, *arguments):
        """{channel: (lowest, at, highest, at, last)} as printed."""
        lines = self.nugget("plot", *arguments).stdout.splitlines()[1:]
        return {re.split(r" {2,}", line)[0]: tuple(map(float, line.split()[-5:])) for line in lines}


class Plot(Pictures):
    def test_extremes_are_those_of_the_file(self):
        self.run_deck()
        rows = [line.split() for line in self.read("swforc").splitlines() if "spotweld beam" in line]
        weld, = self.json("summary.json")["weld"]
        shears = [(float(r[2]), float(r[3])) for r in rows]
        seen = self.extremes(".", f"swforc/{weld['id']}/shear")[f"swforc/weld {weld['id']}/shear N"]
        self.assertAlmostEqual(seen[2] / max(shears)[0], 1.0, 5)
        self.assertAlmostEqual(seen[3] / max(shears)[1], 1.0, 4)
        self.assertAlmostEqual(seen[4] / shears[-1][0], 1.0, 5)

    def test_a_curve_runs_through_the_values(self):
        self.run_deck()
        self.nugget("plot", ".", "glstat/internal_energy", "-o", "energy.svg")
        line, = self.svg("energy.svg").iter(SVG + "polyline")
        points = [tuple(map(float, p.split(","))) for p in line.get("points").split()]
        energies = [s["internal energy"] for s in self.glstat()]
        self.assertEqual(len(points), len(energies))
        up = [points[0][1] - v for _, v in points]  # pixels over the first value
        for pixels, energy in zip(up, energies):
            self.assertAlmostEqual(pixels / up[-1], (energy - energies[0]) / (energies[-1] - energies[0]), delta=0.005)

    def test_curves_of_other_units_have_axes_of_their_own(self):
        self.run_deck()
        self.nugget("plot", ".", "glstat/*_energy", "swforc/axial", "-o", "both.svg")
        root = self.svg("both.svg")
        self.assertEqual(len(root.findall(SVG + "g")), 2)
        words = [t.text for t in root.iter(SVG + "text")]
        self.assertIn("[N mm]", words)
        self.assertIn("axial [N]", words)
        self.assertEqual(words.count("time [s]"), 2)

    def test_force_over_displacement(self):
        self.run_deck()
        self.nugget("plot", ".", "swforc/shear", "--over", "nodout/216/x_displacement", "-o", "over.svg")
        words = [t.text for t in self.svg("over.svg").iter(SVG + "text")]
        self.assertIn("nodout/node 216/x_displacement [mm]", words)
        far = self.extremes(".", "nodout/216/x_displacement")["nodout/node 216/x_displacement mm"][4]
        shear = self.extremes(".", "swforc/shear", "--over", "nodout/216/x_displacement")
        (_, _, _, at, _), = shear.values()
        self.assertGreater(far, 0.0)
        self.assertLessEqual(at, far)

    def test_filtered_signal_is_lower(self):
        self.run_deck(deck().replace("2.00e-05", "2.00e-03"))
        raw, = self.extremes(".", "swforc/axial").values()
        filtered, = self.extremes(".", "swforc/axial", "--cfc", 600).values()
        self.assertLess(filtered[2] - filtered[0], raw[2] - raw[0])

    def test_two_runs(self):
        self.run_deck(folder="a")
        self.run_deck(deck().replace("210000.0", "190000.0"), folder="b")
        seen = self.extremes("a", "glstat/internal_energy", "--with", "b", "-o", "both.png")
        self.assertEqual(set(seen), {"glstat/internal_energy N mm", "b: glstat/internal_energy N mm"})
        self.assertEqual(len({v[4] for v in seen.values()}), 2)
        self.assertEqual(size_of_png(self.folder / "both.png")[0], 1440)

    def test_what_there_is_is_listed(self):
        self.run_deck()
        listed = self.nugget("plot", ".").stdout
        for word in ("swforc:", "axial [N]", "glstat:", "node 216", "over time [s]"):
            self.assertIn(word, listed)

    def test_refusals_say_what_there_is(self):
        self.run_deck()
        self.assertIn("axial [N]", self.nugget("plot", ".", "swforc/7/axial", expect=2).stderr)
        self.assertIn("glstat:", self.nugget("plot", ".", "gltsat", expect=2).stderr)
        self.assertIn(".svg or .png", self.nugget("plot", ".", "glstat", "-o", "a.pdf", expect=2).stderr)
        self.assertIn("summary.json", self.nugget("plot", "nowhere", expect=2).stderr)
        self.assertIn("expected one", self.nugget("plot", ".", "swforc/axial", "--over", "glstat", expect=2).stderr)

    def test_samples_too_far_apart_for_the_filter(self):
        self.run_deck(deck().replace("2.00e-05", "2.00e-03").replace("*DATABASE_GLSTAT\n  5.00e-06", "*DATABASE_GLSTAT\n  1.00e-03"))
        refused = self.nugget("plot", ".", "glstat/internal_energy", "--cfc", 600, expect=2).stderr
        self.assertIn("glstat/internal_energy: CFC 600 needs samples closer than 0.000401 s", refused)

    def test_a_folder_that_cannot_be_written(self):
        self.run_deck()
        self.write("", "file")
        self.assertIn("file", self.nugget("plot", ".", "glstat", "-o", "file/a.svg", expect=4).stderr)


class Picture(Pictures):
    def test_shapes_are_the_shells_that_are_seen(self):
        self.run_deck()
        self.nugget("picture", ".", "-o", "a.svg", "--view", "z", "--field", "part", "--part", "2")
        root = self.svg("a.svg")
        self.assertEqual(len(list(root.iter(SVG + "path"))), 9)  # 3 x 3 shells of the upper sheet
        self.assertIn("2 upper sheet", [t.text for t in root.iter(SVG + "text")])
        weld, = self.json("summary.json")["weld"]
        circle, = (c for c in root.iter(SVG + "circle") if c.find(SVG + "title") is not None)
        self.assertEqual(circle.find(SVG + "title").text, f"weld {weld['id']}")

    def test_places_are_those_of_the_nodes(self):
        """A square sheet in the plane of x and y: from above a square, from halfway up lower by sqrt 2."""
        self.run_deck()
        for view, high in (("z", 1.0), ("0,-1,1", 0.5**0.5), ("-1,0,1", 0.5**0.5)):
            self.nugget("picture", ".", "-o", "a.svg", f"--view={view}", "--field", "part", "--part", 2, "--state", 1)
            paths = " ".join(p.get("d") for p in self.svg("a.svg").iter(SVG + "path"))
            seen = [tuple(map(float, p)) for p in re.findall(r"[ML]([-\d.]+) ([-\d.]+)", paths)]
            size = [max(p[k] for p in seen) - min(p[k] for p in seen) for k in (0, 1)]
            self.assertAlmostEqual(size[1] / size[0], high, 2)

    def test_names_of_parts_do_not_run_into_each_other(self):
        """Long titles are shortened, and what has no room is counted."""
        self.run_deck(deck().replace("lower sheet", "a lower sheet of which much is said in its title").replace("upper sheet", "obere Tür, äußeres Blech, große Länge"))
        for width, seen in ((900, ["1 a lower sheet of which much i…", "2 obere Tür, äußeres Blech, …"]), (400, ["1 a lower sheet of which much i…"])):
            self.nugget("picture", ".", "-o", "a.svg", "--field", "part", "--width", width)
            texts = list(self.svg("a.svg").iter(SVG + "text"))
            row = next(t.get("y") for t in texts if t.text == seen[0])
            names = [t for t in texts if t.get("y") == row]
            self.assertEqual([t.text for t in names][:len(seen)], seen)
            ends = [float(t.get("x")) + 6.5 * len(t.text) for t in names]
            for end, after in zip(ends, names[1:]):
                self.assertLess(end, float(after.get("x")) - 11.0)
        self.assertRegex(names[1].text, r"and \d+ more")

    def test_png_of_every_field(self):
        self.run_deck()
        for field in ("plastic_strain", "von_mises_stress", "thickness", "displacement", "part"):
            with self.subTest(field=field):
                self.nugget("picture", ".", "-o", f"{field}.png", "--field", field, "--width", 400, "--height", 300)
                self.assertEqual(size_of_png(self.folder / f"{field}.png"), (400, 300))
        pictures = {(self.folder / f"{f}.png").read_bytes() for f in ("von_mises_stress", "displacement", "part")}
        self.assertEqual(len(pictures), 3)

    def test_a_failed_weld_is_red(self):
        self.run_deck(deck().replace("    8000.0    6000.0    6000.0", "      80.0      60.0      60.0"))
        weld, = self.json("summary.json")["weld"]
        self.assertTrue(weld["failed"])
        for state, red in ((1, False), (5, True)):
            self.nugget("picture", ".", "-o", "a.svg", "--state", state)
            circle, = (c for c in self.svg("a.svg").iter(SVG + "circle") if c.find(SVG + "title") is not None)
            self.assertEqual("#c62828" in (circle.get("fill"), circle.get("stroke")), red)

    def fills(self, *arguments):
        """(colours of facets, of welds, words)"""
        self.nugget("picture", ".", "-o", "a.svg", *arguments)
        root = self.svg("a.svg")
        welds = [c for c in root.iter(SVG + "circle") if c.find(SVG + "title") is not None]
        return ({p.get("fill") for p in root.iter(SVG + "path")}, [c.get("stroke") if c.get("fill") == "none" else c.get("fill") for c in welds],
                " ".join(t.text for t in root.iter(SVG + "text")))

    def test_damage_of_elements(self):
        self.run_deck(damaged.sheets())
        _, _, words = self.fills("--field", "damage")
        self.assertIn("damage", words)
        self.assertIn("1: failed", words)
        largest = self.fills("--field", "damage", "--range", "0,1", "--state", 4)[0]
        self.assertNotEqual(largest, self.fills("--field", "damage", "--range", "0,1", "--state", 1)[0])

    def test_damage_of_a_weld(self):
        """Colours of the ramp by welds.csv, whose damage grows with (t - t_f) / 1e-4."""
        self.run_deck(damaged.weld())
        rows = list(csv.DictReader(io.StringIO(self.read("welds.csv"))))
        share = float(rows[0]["damage"])
        self.assertGreater(share, 0.05)
        self.assertEqual(rows[0]["failed"], "no")
        _, (half,), words = self.fills("--field", "damage", f"--range=0,{2 * share}")
        self.assertEqual(half, "#96c85a")  # the middle of the ramp, [150, 200, 90]
        self.assertIn("damage", words)
        _, (plain,), _ = self.fills("--field", "part")
        self.assertNotEqual(plain, half)

    def test_damage_that_is_not_there(self):
        self.run_deck()
        refused = self.nugget("picture", ".", "-o", "a.svg", "--field", "damage", expect=2).stderr
        for words in ("nothing that is shown has damage", "NEIPH", "welds.csv"):
            self.assertIn(words, refused)

    def test_modes(self):
        self.write(strips())
        self.nugget("modes", "model.k", "-n", 4, "--quiet")
        self.nugget("picture", ".", "-o", "a.svg", "--state", 4)
        words = " ".join(t.text for t in self.svg("a.svg").iter(SVG + "text"))
        self.assertIn("mode 4 of 4", words)
        self.assertIn("no mode 5, expected 1 to 4", self.nugget("picture", ".", "-o", "a.svg", "--state", 5, expect=2).stderr)
        self.assertIn("displacement or part", self.nugget("picture", ".", "-o", "a.svg", "--field", "thickness", expect=2).stderr)

    def test_refusals(self):
        self.run_deck()
        for arguments, words in ((("--part", "9"), "no part 9"), (("--weld", "9"), "no weld 9"), (("--state", "99"), "no state 99"),
                                 (("--view", "up"), "expected an axis"), (("--view", "0,0,0"), "expected an axis")):
            with self.subTest(arguments=arguments):
                self.assertIn(words, self.nugget("picture", ".", "-o", "a.svg", *arguments, expect=2).stderr)
        self.assertNotIn("a.svg", self.files())

    def test_the_page_has_a_picture_where_scripts_do_not_run(self):
        self.run_deck()
        self.assertRegex(self.read("report.html"), r'<img alt="the model"[^>]*src="data:image/svg\+xml;base64,')

    def test_colours_are_those_of_the_viewer(self):
        """Two languages, one scale: the numbers stand in both."""
        script = (SOURCE / "web" / "src" / "colours.js").read_text(encoding="utf-8")
        program = (SOURCE / "src" / "report" / "colours.cpp").read_text(encoding="utf-8")
        numbers = lambda text: [int(n) for n in re.findall(r"\d+", text)]  # noqa: E731
        stops = numbers(re.search(r"STOPS = (.*?);", script)[1])
        self.assertEqual(len(stops), 21)
        self.assertEqual(numbers(re.search(r"stops\{(.*?)\};", program, re.S)[1]), stops)
        for ours, theirs in (("failed", "FAILED"), ("near_failure", "NEAR"), ("safe", "SAFE"), ("plain", "PLAIN")):
            self.assertEqual(numbers(re.search(rf"\b{ours}\{{(.*?)\}}", program)[1]), numbers(re.search(rf"\b{theirs} = \[(.*?)\]", script)[1]))


if __name__ == "__main__":
    unittest.main()
