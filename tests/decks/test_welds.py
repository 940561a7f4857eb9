# SPDX-License-Identifier: Apache-2.0
"""`nugget welds`: energy through welds against the energies of what hangs on them, margins, times of failure, ranks.

Sabotage that this catches: work of one end only, or of the sum of both ends; forces without those of the last cycle; an archive without the
work; a ranking that sorts the other way.
"""
import csv
import io
import re
import unittest

from lap_joint import deck
from nugget_command import CommandTest

MASS = 18.0 * 18.0 * 1.2 * 7.85e-9 + 0.5 * 3.14159265358979 * 9.0 * 1.2 * 7.85e-9  # upper sheet and half the weld
STRONG = ("       0.0    8000.0    6000.0    6000.0    9000.0    7000.0    7000.0\n", "       0.0   80000.0   60000.0   60000.0\n")


def driven(speed):
    """All of the lower sheet in x to `speed` within 0.8 ms, smoothly; nothing holds the upper one but the weld."""
    curve = "".join(f"{1e-3 * i / 50:20.10e}{speed * s * s * (3 - 2 * s):20.10e}\n" for i in range(51) for s in [min(i / 40, 1.0)])
    nodes = "".join(f"{n:10d}" + ("\n" if (n - 100) % 8 == 0 else "") for n in range(101, 117))
    return deck(("  2.00e-05\n*CONTROL_TIMESTEP", "  1.00e-03\n*CONTROL_TIMESTEP"), STRONG,
                ("                 0.0                 0.0\n             1.0e-05               500.0\n             1.0e-01               500.0\n", curve),
                ("         2         1         0         1\n", "         1         1         0         1\n"),
                ("         1         0         1         1         1         1         1         1\n",
                 "         1         0         0         1         1         1         1         1\n"),
                ("         1\n       101       105       109       113\n", "         1\n" + nodes))


def bricks(*corners):
    """The lap joint with its beam replaced by bricks between those corners in the plane."""
    grid = sorted({x for a, b in corners for x in (a[0], b[0])}), sorted({y for a, b in corners for y in (a[1], b[1])})
    number = {(x, y, z): 401 + 100 * (z > 0.0) + 10 * i + j for i, x in enumerate(grid[0]) for j, y in enumerate(grid[1]) for z in (0.0, 1.2)}
    text = "".join(f"{n:8d}{x:16.4f}{y:16.4f}{z:16.4f}\n" for (x, y, z), n in number.items()) + "*ELEMENT_SOLID\n"
    for e, ((a, b), (c, d)) in enumerate(corners):
        ring = [(a, b), (c, b), (c, d), (a, d)]
        text += f"{901 + e:8d}{3:8d}" + "".join(f"{number[x, y, z]:8d}" for z in (0.0, 1.2) for x, y in ring) + "\n"
    return deck(("*ELEMENT_BEAM\n" + f"{31:8d}{3:8d}{301:8d}{302:8d}{0:8d}\n", "*NODE\n" + text), STRONG,
                (f"{301:8d}{9.0:16.4f}{9.0:16.4f}{0.0:16.4f}\n{302:8d}{9.0:16.4f}{9.0:16.4f}{1.2:16.4f}\n", ""),
                ("*PART\nweld\n         3         3         3\n", "*PART\nweld\n         3         3         3         0         3\n"),
                ("*SECTION_BEAM\n         3         9       1.0         2       1.0\n       6.0       6.0       0.0       0.0\n",
                 "*SECTION_SOLID\n         3         1\n*HOURGLASS\n         3         6       1.0\n"))


class Welds(CommandTest):
    def rows(self, folder="."):
        return list(csv.DictReader(io.StringIO(self.read(f"{folder}/welds.csv"))))

    def ranking(self, *options, folder="."):
        return list(csv.DictReader(io.StringIO(self.nugget("welds", folder, "--csv", *options).stdout)))

    def energy_of_part(self, part, names=("inten", "kinen", "hgeng")):
        """Kinetic, internal and hourglass energy of a part in the last state of matsum."""
        state = re.split(rf" mat\.# *= *{part} ", self.read("matsum"))[-1].split("mat.#")[0]
        found = dict(re.findall(r"(inten|kinen|hgeng) *= *(\S+)", state))
        return sum(float(found[name]) for name in names)

    def test_a_sheet_that_follows_through_its_weld(self):
        for speed in (2000.0, -1000.0):
            with self.subTest(speed):
                self.write(driven(speed))
                self.nugget("run", "model.k", "--quiet")
                (row,) = self.rows()
                self.assertAlmostEqual(float(row["energy_passed"]) / (0.5 * MASS * speed ** 2), 1.0, delta=0.01)
                self.assertLess(abs(float(row["energy"])), 0.01 * float(row["energy_passed"]))

    def test_it_is_the_energy_of_the_sheet_behind_it(self):
        self.write(deck(STRONG))
        forms = {"beam": deck(STRONG), "one brick": bricks(((7.8, 7.8), (10.2, 10.2))),
                 "four": bricks(((7.5, 7.5), (9.0, 9.0)), ((9.0, 7.5), (10.5, 9.0)), ((7.5, 9.0), (9.0, 10.5)), ((9.0, 9.0), (10.5, 10.5)))}
        for form, text in forms.items():
            with self.subTest(form):
                self.write(text)
                self.nugget("run", "model.k", "--quiet")
                (row,) = self.rows()
                through = float(row["energy_passed"])
                self.assertLess(through, 0.0)  # from the upper sheet, which is pulled, to the lower one
                # The weld keeps half of its own energy on this side, about half of its motion too.
                kept = 0.5 * float(row["energy"]) + 0.5 * self.energy_of_part(3, ["kinen"])
                self.assertAlmostEqual(-through / (self.energy_of_part(1) + kept), 1.0, delta=0.003)
                self.assertGreaterEqual(abs(float(row["most_energy_passed"])), abs(through))

    def test_the_failure_value_over_time(self):
        self.write(deck())
        self.nugget("run", "model.k", "--quiet")
        (row,) = self.rows()
        course = [float(value) for value in row["failure_course"].split()]
        self.assertTrue(16 <= len(course) <= 32, course)
        self.assertAlmostEqual(max(course) / float(row["peak_failure"]), 1.0, delta=1e-3)
        at = int(float(row["peak_failure_time"]) / float(row["failure_interval"]))
        self.assertEqual(course[at], max(course))
        (ranked,) = self.ranking()
        self.assertAlmostEqual(float(ranked["margin"]), 1.0 - float(row["peak_failure"]), 12)
        self.assertEqual(ranked["failure_time"], "")

    def test_a_resumed_run_has_the_same_row(self):
        self.write(deck())
        self.nugget("run", "model.k", "-o", "whole", "--quiet")
        self.nugget("run", "model.k", "-o", "parts", "--quiet", "--checkpoint", "17cycles")
        self.nugget("run", "--resume", "parts", "--quiet")
        self.assertEqual(self.read("whole/welds.csv"), self.read("parts/welds.csv"))

    def test_ranks(self):
        """Two welds in a row of pulls: the weaker one fails, the other takes over."""
        weak = "*MAT_SPOTWELD\n         4  7.85e-09  210000.0       0.3     500.0    1000.0\n       0.0    8000.0     300.0     300.0\n"
        self.write(deck((f"{31:8d}{3:8d}{301:8d}{302:8d}{0:8d}\n", f"{31:8d}{3:8d}{301:8d}{302:8d}{0:8d}\n{41:8d}{4:8d}{401:8d}{402:8d}{0:8d}\n"),
                        ("*ELEMENT_SHELL\n", f"{401:8d}{15.0:16.4f}{9.0:16.4f}{0.0:16.4f}\n{402:8d}{15.0:16.4f}{9.0:16.4f}{1.2:16.4f}\n*ELEMENT_SHELL\n"),
                        ("*MAT_SPOTWELD\n", weak + "*PART\nweak weld\n         4         3         4\n*MAT_SPOTWELD\n"),
                        ("*CONTACT_SPOTWELD\n         3         1         3         2\n", "*CONTACT_SPOTWELD\n         9         1         2         2\n"),
                        ("*SET_PART_LIST\n", "*SET_PART_LIST\n         9\n         3         4\n*SET_PART_LIST\n")))
        self.nugget("run", "model.k", "--quiet")
        by_time, by_margin, by_energy = self.ranking("--sort", "failure"), self.ranking("--sort", "margin"), self.ranking()
        self.assertEqual([r["weld"] for r in by_time], ["41", "31"])
        self.assertEqual([r["weld"] for r in by_margin], ["41", "31"])
        self.assertLessEqual(float(by_margin[0]["margin"]), 0.0)
        self.assertGreater(float(by_margin[1]["margin"]), 0.0)
        energies = [abs(float(r["energy_through"])) for r in by_energy]
        self.assertEqual(energies, sorted(energies, reverse=True))
        self.assertEqual([r["rank"] for r in by_energy], ["1", "2"])
        table = self.nugget("welds", ".", "--sort", "failure", "-n", 1).stdout
        self.assertIn("2 welds, 1 failed; first to fail first", table)
        self.assertRegex(table, r"\n +1 +41 +beam +1\+2 .* shear force +[.0-9]*X\n and 1 more \(-n 0 shows all\)\n")

    def test_modes_are_ranked_by_strain_energy(self):
        self.write(deck())
        self.nugget("modes", "model.k", "-n", 4, "--quiet")
        shares = {row["id"]: max(float(row[f"mode {m}"]) for m in range(1, 5)) for row in csv.DictReader(io.StringIO(self.read("mode_energy.csv")))
                  if row["kind"] == "weld"}
        (ranked,) = self.ranking()
        self.assertAlmostEqual(float(ranked["largest_share"]), shares["31"], 12)
        self.assertIn("largest share of the strain energy", self.nugget("welds", ".").stdout)
        self.assertIn("--sort margin: . holds natural modes", self.nugget("welds", ".", "--sort", "margin", expect=2).stderr)

    def test_a_study_of_runs_without_each_weld(self):
        """Two sheets, two welds; only the far one holds the upper sheet's other end: without it the welds part further."""
        two = deck((f"{31:8d}{3:8d}{301:8d}{302:8d}{0:8d}\n", f"{31:8d}{3:8d}{301:8d}{302:8d}{0:8d}\n{41:8d}{3:8d}{401:8d}{402:8d}{0:8d}\n"),
                   ("*ELEMENT_SHELL\n", f"{401:8d}{15.0:16.4f}{9.0:16.4f}{0.0:16.4f}\n{402:8d}{15.0:16.4f}{9.0:16.4f}{1.2:16.4f}\n*ELEMENT_SHELL\n"),
                   STRONG, ("*DATABASE_HISTORY_NODE\n       216\n", "*DATABASE_HISTORY_NODE\n       216       101       202\n"))
        self.write(two)
        table = self.nugget("run", "model.k", "--drop-weld", "all", "--intrusion", "101,202", "--quiet", "-o", "study").stdout
        rows = list(csv.DictReader(io.StringIO(self.read("study/weld_drop.csv"))))
        self.assertEqual(rows[0]["without"], "none")
        self.assertEqual(sorted(r["without"] for r in rows[1:]), ["31", "41"])
        # Each line is that of a run of its own.
        for row in rows:
            drop = [] if row["without"] == "none" else ["--drop-weld", row["without"]]
            self.nugget("run", "model.k", "--quiet", "-o", "alone", "-j", 1, *drop)
            self.assertAlmostEqual(float(row["internal_energy"]) / self.json("alone/summary.json")["energy"]["internal"], 1.0, 8)
            self.assertIn(row["without"], table)
        change = [abs(float(r["intrusion 101-202"]) / float(rows[0]["intrusion 101-202"]) - 1.0) for r in rows[1:]]
        self.assertEqual(change, sorted(change, reverse=True))
        self.assertGreater(change[0], 0.0)
        # Without both, nothing holds the sheets together: as the deck without its welds.
        self.nugget("run", "model.k", "--quiet", "-o", "both", "--drop-weld", "31,41")
        self.assertEqual([r["failure_mode"] for r in self.rows("both")], ["element death"] * 2)
        self.assertIn("not there from the start", self.rows("both")[0]["remarks"])
        self.assertAlmostEqual(float(self.rows("both")[0]["peak_axial"]), 0.0, 6)

    def test_what_cannot_be_taken_out_is_refused(self):
        self.write(deck(STRONG))
        self.assertIn("there is no weld 7", self.nugget("run", "model.k", "--drop-weld", "7", expect=1).stderr)
        self.assertIn("there is no weld 7", self.nugget("run", "model.k", "--drop-weld", "each:7", expect=2).stderr)
        self.assertIn("'x' is no weld", self.nugget("run", "model.k", "--drop-weld", "x", expect=1).stderr)
        self.assertIn("node 101 has no history in global axes",
                      self.nugget("run", "model.k", "--drop-weld", "all", "--intrusion", "101,216", expect=2).stderr)
        self.assertIn("expected two nodes", self.nugget("run", "model.k", "--drop-weld", "all", "--intrusion", "101", expect=2).stderr)

    def test_refusals(self):
        self.assertIn("holds no results of a run", self.nugget("welds", ".", expect=2).stderr)
        self.nugget("welds", ".", "--sort", "age", expect=2)
        text = deck((f"*ELEMENT_BEAM\n{31:8d}{3:8d}{301:8d}{302:8d}{0:8d}\n", ""))
        self.write(re.sub(r"\*CONTACT_SPOTWELD\n[^*]*|\*PART\nweld\n[^*]*", "", text))
        self.nugget("run", "model.k", "--quiet", "--max-cycles", 2)
        self.assertIn("has no welds: nothing to rank", self.nugget("welds", ".", expect=2).stderr)


if __name__ == "__main__":
    unittest.main()
