# SPDX-License-Identifier: Apache-2.0
"""report.html: one file that needs no other, with the numbers of summary.json."""
import html.parser
import json
import re
import unittest

from lap_joint import deck
from nugget_command import CommandTest

VOID = {"meta", "br", "img", "link", "input", "hr"}


class Page(html.parser.HTMLParser):
    """The text of each element that has an id, table rows, and what the page would load."""

    def __init__(self, text):
        super().__init__()
        self.open, self.by_id, self.rows, self.loads, self.classes = [], {}, [], [], []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.loads += [v for k, v in attributes.items() if k in ("src", "href", "data", "action") and not v.startswith(("#", "data:"))]
        if tag not in VOID:
            self.open.append((tag, attributes.get("id")))
        if tag == "tr":
            self.rows.append([])
            self.classes.append(attributes.get("class", ""))
        if tag in ("td", "th"):
            self.rows[-1].append("")

    def handle_startendtag(self, tag, attributes):
        pass

    def handle_endtag(self, tag):
        assert self.open and self.open[-1][0] == tag, (tag, self.open)
        self.open.pop()

    def handle_data(self, data):
        for _, name in self.open:
            if name:
                self.by_id[name] = self.by_id.get(name, "") + data
        if any(tag in ("td", "th") for tag, _ in self.open):
            self.rows[-1][-1] += data


class Report(CommandTest):
    def page(self, folder="."):
        text = self.read(f"{folder}/report.html")
        page = Page(text)
        self.assertEqual(page.open, [], "every element is closed")
        self.assertEqual(page.loads, [], "nothing is loaded")
        still = re.sub(r"<script.*?</script>", "", text, flags=re.DOTALL)  # the viewer's libraries name addresses, and load none (web/drive.mjs)
        self.assertNotRegex(still.replace("http://www.w3.org/2000/svg", ""), r"https?://|@import|url\(")
        return page, text

    def test_a_run_leaves_a_report_with_the_numbers_of_its_summary(self):
        self.write(deck())
        self.nugget("run", "model.k", "--quiet")
        page, text = self.page()
        summary = self.json("summary.json")
        self.assertEqual(page.by_id["termination"], "normal termination")
        for group in ("energy", "mass", "time_step", "elements"):
            for key, value in summary[group].items():
                shown = page.by_id[f"{group}-{key}"]
                if isinstance(value, str):
                    self.assertEqual(shown, value)
                else:
                    self.assertAlmostEqual(float(shown), value, delta=6e-6 * abs(value), msg=f"{group} {key}")
        self.assertEqual(int(page.by_id["run-cycles"]), summary["cycles"])
        self.assertAlmostEqual(float(page.by_id["run-time"]) / summary["time"], 1.0, 5)
        weld = [row for row, kind in zip(page.rows, page.classes) if kind == "weld"]
        self.assertEqual([row[0] for row in weld], [str(w["id"]) for w in summary["weld"]])
        self.assertEqual(weld[0][2], "1+2")
        self.assertAlmostEqual(float(weld[0][7]) / summary["weld"][0]["peak"]["shear"], 1.0, 5)
        self.assertIn("1 welds: 1 holds", page.by_id["weld-tally"])
        # A curve has as many points as glstat has states.
        curves = re.findall(r'<polyline [^>]*points="([^"]*)"', text)
        self.assertGreaterEqual(len(curves), 3)
        for points in curves:
            self.assertEqual(len(points.split()), len(self.glstat()))
        self.assertIn("no torsion in 1 weld beam", page.by_id["findings"])

    def test_welds_that_failed_come_first(self):
        """A second weld, so weak that it fails, stands behind the first one in the deck."""
        weak = "*PART\nweak\n         4         3         4\n*MAT_SPOTWELD\n         4  7.85e-09  210000.0       0.3     500.0    1000.0\n       0.0       1.0       1.0       1.0\n"
        text = deck(("*SECTION_BEAM\n", weak + "*SECTION_BEAM\n"))
        text = text.replace("         3         1         3         2\n", "         3         1         2         2\n")
        text = text.replace("*DEFINE_CURVE\n", "*SET_PART_LIST\n         3\n         3         4\n*DEFINE_CURVE\n")
        text = text.replace("*ELEMENT_SHELL\n", f"{303:8d}{3.0:16.4f}{3.0:16.4f}{0.0:16.4f}\n{304:8d}{3.0:16.4f}{3.0:16.4f}{1.2:16.4f}\n*ELEMENT_SHELL\n")
        text = text.replace("*END", f"{32:8d}{4:8d}{303:8d}{304:8d}{0:8d}\n*END")
        self.write(text)
        self.nugget("run", "model.k", "--quiet")
        page, _ = self.page()
        weld = [row for row, kind in zip(page.rows, page.classes) if kind == "weld"]
        self.assertEqual([row[0] for row in weld], ["32", "31"])
        failed = next(w for w in self.json("summary.json")["weld"] if w["id"] == 32)
        self.assertTrue(failed["failed"])
        self.assertEqual(weld[0][4], f"failed at {failed['failure_time']:.6g} s by {failed['failure_mode']}")
        self.assertIn("2 welds: 1 failed, 1 holds", page.by_id["weld-tally"])

    def test_what_is_not_sound_is_told(self):
        """The shares of the checks, by hand, from a summary without glstat; and the verdict on either side of each limit. Contact gave what it
        lost and never got."""
        self.write(deck())
        self.nugget("run", "model.k", "--quiet")
        page, _ = self.page()
        verdicts = {name: page.by_id[f"check-{name}"] for name in ("energy", "hourglass", "contact", "contact-lost", "mass")}
        self.assertEqual(set(verdicts.values()), {"in order"})
        (self.folder / "glstat").unlink()
        summary = self.json("summary.json")
        for share, word in ((0.9, "in order"), (1.1, "look at it")):
            summary["energy"].update(internal=200.0, hourglass=20.0 * share, contact=0.0, contact_lost=2.0 * share,
                                     ratio=1.0 - 0.02 * share, initial=1200.0, external=-200.0)
            summary["mass"].update(physical=4.0, added=0.2 * share)
            (self.folder / "summary.json").write_text(json.dumps(summary), encoding="utf-8")
            self.nugget("report", ".")
            page, _ = self.page()
            rows = [row for row, kind in zip(page.rows, page.classes) if kind == "check"]
            self.assertEqual([row[3] for row in rows], [word] * 6)
            found = [float(row[1].split()[0]) for row in rows]
            for value, limit in zip(found, (2.0, 10.0, 10.0, 1.0, 1.0, 5.0)):
                self.assertAlmostEqual(value, limit * share, delta=1e-3 * limit)

    def test_hourglass_energy_has_a_remedy(self):
        """Shells of ELFORM 2 of the upper sheet bend in their hourglass modes: the page names part and remedy, as the terminal does."""
        self.write(deck())
        self.nugget("run", "model.k", "--quiet")
        told = self.json("summary.json")["hourglass"]
        self.assertIn(told["part"], (1, 2))
        self.assertEqual(told["elements"], "shells of ELFORM 2")
        energies = {int(m[1]): float(m[2]) for m in re.finditer(r"mat\.#= *(\d+).*?hgeng= *(\S+)", self.read("matsum").split(" time =")[-1], re.S)}
        self.assertAlmostEqual(told["energy"] / max(energies.values()), 1.0, 4)
        self.assertEqual(energies[told["part"]], max(energies.values()))
        summary = self.json("summary.json")
        summary["energy"].update(internal=1.0, hourglass=1.0)
        (self.folder / "summary.json").write_text(json.dumps(summary), encoding="utf-8")
        (self.folder / "glstat").unlink()
        self.nugget("report", ".")
        page, text = self.page()
        row, = (row for row, kind in zip(page.rows, page.classes) if kind == "check" and row[0].startswith("largest hourglass"))
        self.assertIn(f"part {told['part']} (shells of ELFORM 2): ELFORM 16", row[4])
        self.assertIn("look at it", row[3])
        first = text.split('id="conclusions"')[1].split("</ul>")[0]
        self.assertIn("ELFORM 16", first)

    def test_forces_of_walls_and_contacts_without_scripts(self):
        """Their largest values with unit and time, by the files themselves. Sabotage: a component left out; the last for the largest."""
        self.write(deck(("*DATABASE_GLSTAT\n", "*DATABASE_RWFORC\n  1.00e-06\n*DATABASE_RCFORC\n  1.00e-06\n*DATABASE_GLSTAT\n"),
                        ("*BOUNDARY_PRESCRIBED_MOTION_SET\n         2         1         0         1\n*BOUNDARY_SPC_SET\n         1         0         1         1         1         1         1         1\n",
                         "*INITIAL_VELOCITY\n         0\n    5000.0\n*RIGIDWALL_PLANAR_ID\n         7stop\n         0\n     18.01       0.0       0.0      17.0       0.0       0.0\n")))
        self.nugget("run", "model.k", "--quiet")
        page, text = self.page()
        still = text.split('class="only-static"')[1].split("Is the run sound?")[0]
        self.assertIn("Forces on walls over time", still)
        rows = [line.split() for line in self.read("rwforc").splitlines() if re.match(r" +\S+E[-+]\d+ +7 ", line)]
        sizes = [(sum(float(v) ** 2 for v in row[3:6]) ** 0.5, float(row[0])) for row in rows]
        self.assertGreater(max(sizes)[0], 0.0)
        size, unit, time, second = re.search(r'id="forces-rwforc">\s*<li>wall 7[^:]*: largest (\S+) (\S+) at (\S+) (\S+)</li>', still).groups()
        self.assertAlmostEqual(float(size) / max(sizes)[0], 1.0, 4)
        self.assertAlmostEqual(float(time) / max(sizes)[1], 1.0, 4)
        self.assertEqual((unit, second), ("N", "s"))

    def test_a_model_that_only_flies_is_sound(self):
        """Next to nothing is internal in the first cycles of an impact: shares of that are no reason to look first at them."""
        self.write(deck())
        self.nugget("run", "model.k", "--quiet")
        (self.folder / "glstat").unlink()
        summary = self.json("summary.json")
        for part, word in ((1e-4, "in order"), (1e-1, "look at it")):
            summary["energy"].update(internal=1e-9, hourglass=part * 1e3, contact=-part * 1e3, contact_lost=part * 1e3,
                                     ratio=1.0 - part, initial=1000.0, external=0.0)
            (self.folder / "summary.json").write_text(json.dumps(summary), encoding="utf-8")
            self.nugget("report", ".")
            page, _ = self.page()
            self.assertEqual({page.by_id[f"check-{name}"] for name in ("hourglass", "energy-of-internal", "contact", "contact-lost")}, {word})

    def test_a_run_that_diverged_has_a_report(self):
        """Its energies are null in summary.json. Sabotage: null read as a number, which ends the command."""
        self.write(deck())
        self.nugget("run", "model.k", "--quiet")
        (self.folder / "glstat").unlink()
        summary = self.json("summary.json")
        summary["energy"].update(internal=None, hourglass=None, contact=None, ratio=None)
        (self.folder / "summary.json").write_text(json.dumps(summary), encoding="utf-8")
        self.nugget("report", ".")
        page, _ = self.page()
        self.assertEqual([page.by_id[f"check-{name}"] for name in ("energy", "hourglass", "contact")], ["look at it"] * 3)
        summary.pop("mass")
        (self.folder / "summary.json").write_text(json.dumps(summary), encoding="utf-8")
        self.nugget("report", ".")
        self.assertNotIn("check-energy", self.page()[0].by_id)

    def test_hourglass_energy_that_went_is_seen(self):
        """The largest share over the times of glstat counts, not what is left at the end; beside internal energy that went with elements."""
        self.write(deck(("*CONTROL_TIMESTEP\n", "*CONTROL_ENERGY\n         2\n*CONTROL_TIMESTEP\n")))
        self.nugget("run", "model.k", "--quiet")
        text, count = re.subn(r"(hourglass energy \.+ *)\S+", r"\g<1> 1.00000E+99", self.read("glstat"), count=1)
        self.assertEqual(count, 1)
        (self.folder / "glstat").write_text(text, encoding="utf-8")
        self.nugget("report", ".")
        self.assertEqual(self.page()[0].by_id["check-hourglass"], "look at it")
        text, count = re.subn(r"(eroded internal energy\.+ *)\S+", r"\g<1> 3.00000E+99", text, count=1)
        self.assertEqual(count, 1)
        (self.folder / "glstat").write_text(text.replace("1.00000E+99", "1.40000E+98"), encoding="utf-8")
        self.nugget("report", ".")
        self.assertEqual(self.page()[0].by_id["check-hourglass"], "in order")

    def test_the_command_makes_it_again(self):
        self.write(deck())
        self.nugget("run", "model.k", "-o", "out", "--quiet")
        first = self.read("out/report.html")
        (self.folder / "out" / "report.html").unlink()
        self.nugget("report", "out")
        self.assertEqual(self.read("out/report.html"), first)

    def test_two_runs_side_by_side(self):
        """The same joint, the second time with a weld that is too weak: its verdict changes, and the energies differ."""
        self.write(deck())
        self.nugget("run", "model.k", "-o", "a", "--quiet")
        self.nugget("run", "model.k", "-o", "b", "--quiet", "--until", "1e-5")
        rows = (self.folder / "b" / "welds.csv").read_text(encoding="utf-8").splitlines()
        names, cells = rows[0].split(","), rows[1].split(",")
        cells[names.index("failed")], cells[names.index("failure_time")] = "yes", "5e-06"
        cells[names.index("failure_mode")] = "axial force"
        (self.folder / "b" / "welds.csv").write_text("\n".join([rows[0], ",".join(cells)]) + "\n", encoding="utf-8")
        self.assertIn("a/compare.html", self.nugget("report", "a", "b").stdout)
        page = Page(self.read("a/compare.html"))
        self.assertEqual((page.open, page.loads), ([], []))
        self.assertIn("1 of 1 welds", page.by_id["weld-changes"])
        weld, = [row for row, kind in zip(page.rows, page.classes) if kind == "weld"]
        self.assertEqual(weld[1:3], ["holds", "failed at 5e-06 s by axial force"])
        self.assertIn("B at 1e-05 s", page.by_id["ends-differ"])
        self.assertNotIn("units-differ", page.by_id)
        internal, = [row for row, kind in zip(page.rows, page.classes) if kind == "number" and row[0].startswith("internal")]
        a, b = (self.json(f"{run}/summary.json")["energy"]["internal"] for run in "ab")
        self.assertAlmostEqual(float(internal[1]), a, delta=6e-6 * a)
        self.assertAlmostEqual(float(internal[3].split()[0]), 100.0 * (b - a) / a, delta=0.06)
        self.assertIn("holds no results", self.nugget("report", "a", "nowhere", expect=2).stderr)
        self.nugget("run", "model.k", "-o", "c", "--quiet", "--units", "m, kg, s")
        self.nugget("report", "a", "c")
        page = Page(self.read("a/compare.html"))
        self.assertIn("A mm, t, s, B m, kg, s", page.by_id["units-differ"])
        self.assertNotIn("ends-differ", page.by_id)

    def test_a_folder_without_results_is_told(self):
        run = self.nugget("report", ".", expect=2)
        self.assertIn("holds no results of a run: there is no summary.json", run.stderr)
        self.assertEqual(self.files(), [])

    def test_markup_in_a_deck_is_text_in_the_page(self):
        self.write(deck(("*PART\nlower sheet", "*DATABASE_<SCRIPT>\n1\n*PART\nlower sheet")), "a<b>&.k")
        self.nugget("run", "a<b>&.k", "--quiet")
        page, text = self.page()
        self.assertIn("a&lt;b&gt;&amp;.k", text)
        self.assertNotIn("<SCRIPT>", text)


if __name__ == "__main__":
    unittest.main()
