# SPDX-License-Identifier: Apache-2.0
"""`nugget fit`: strengths out of curves that a formula made, with scatter and without, and what it refuses.

The forces come from the formula of OPT 0 without moments, not from a simulation. Sabotage that this catches: the load of the weld taken at the
peak of the unbroken run instead of at the measured force, a card whose strengths stand in the wrong fields, specimens mixed up.
"""
import csv
import io
import math
import random
import re
import unittest

from nugget_command import CommandTest

NRR, NRS = 5200.0, 8300.0


def card(nrr=3000.0, nrs=3000.0, mss=0.0, name="MAT_SPOTWELD", head=""):
    field = lambda x: f"{x:10.4g}"  # noqa: E731
    return (f"*KEYWORD\n*{name}\n{head}$ the weld\n" + f"{7:10d}" + "".join(map(field, (7.85e-9, 210000.0, 0.3, 3000.0, 1000.0))) + "\n$ strengths\n"
            + "".join(map(field, (0.0, nrr, nrs, nrs, 0.0, mss, mss))) + f"{3:10d}\n*END\n")


def force(angle):
    return 1.0 / math.hypot(math.sin(math.radians(angle)) / NRR, math.cos(math.radians(angle)) / NRS)


def curves(peaks, header="test,sample,displacement,force"):
    """Curves that rise to a peak and fall, of {(test, sample): peak}."""
    lines = [header]
    for (test, sample), peak in peaks.items():
        lines += [f"{test},{sample},{0.1 * i:.2f},{peak * (1.0 - ((i - 8) / 8.0) ** 2):.3f}" for i in range(13)]
    return "\n".join(lines) + "\n"


class Fit(CommandTest):
    def fit(self, table, text=None, expect=0):
        self.write(table, "curves.csv")
        self.write(text or card(), "card.k")
        return self.nugget("fit", "curves.csv", "card.k", "-o", "card2.k", expect=expect)

    def test_strengths_from_a_formula(self):
        run = self.fit(curves({(f"ks2_{angle:02d}", ""): force(angle) for angle in (0, 40, 90)}),
                       text=card(name="MAT_SPOTWELD_TITLE", head="the title\n"))
        found = dict(re.findall(r"^ (NRR|NRS = NRT) +(\S+)  95 %", run.stdout, re.M))
        # The forces of the weld are those of the grip, but for what its sheets' motion takes.
        self.assertAlmostEqual(float(found["NRR"]) / NRR, 1.0, delta=0.03)
        self.assertAlmostEqual(float(found["NRS = NRT"]) / NRS, 1.0, delta=0.03)
        lines = self.read("card2.k").splitlines()
        self.assertTrue(any(line.startswith("$ Strengths by nugget fit from curves.csv (3 specimens") for line in lines))
        second = next(line for line in lines[lines.index("$ strengths"):] if not line.startswith("$"))
        fields = [float(second[i:i + 10]) for i in range(0, 80, 10)]
        self.assertAlmostEqual(fields[1] / float(found["NRR"]), 1.0, delta=1e-4)
        self.assertEqual((fields[0], fields[2], fields[4:]), (0.0, fields[3], [0.0, 0.0, 0.0, 3.0]))
        rows = list(csv.DictReader(io.StringIO(self.read("card2_runs/fit.csv"))))
        self.assertEqual(len(rows), 3)
        for row in rows:
            self.assertAlmostEqual(float(row["simulated_force"]) / float(row["measured_force"]), 1.0, delta=0.05)

    def test_scatter_gives_intervals(self):
        noise = random.Random(5)
        peaks = {(f"ks2_{angle:02d}", sample): force(angle) * math.exp(noise.gauss(0.0, 0.04)) for angle in (0, 90) for sample in "ABCD"}
        run = self.fit(curves(peaks))
        for name, truth in (("NRR", NRR), ("NRS = NRT", NRS)):
            value, low, high = map(float, re.search(rf"^ {name} +(\S+)  95 %: (\S+) to (\S+) ", run.stdout, re.M).groups())
            self.assertTrue(low < value < high and low < truth < high, (name, low, value, high))
            # Student's t of 6 degrees of freedom, 2.447, times the scatter over the root of four.
            scatter = 0.01 * float(re.search(r"about its strength: (\S+) %", run.stdout)[1])
            self.assertAlmostEqual(math.log(high / value) / (2.447 * scatter / 2.0), 1.0, delta=0.1)

    def test_interpolation_weld_of_a_known_card(self):
        """RN, RS and ALPHA1 of curves that another card gave; written between commas and in columns, with a title and without.
        Sabotage that this catches: bending added to shear, the factor of the force curve forgotten, a value in another field."""
        def welded(rn, rs, alpha, title="", comma=False):
            rows = [[1, 2, 77, 3.0, 3.0, 150000.0, alpha, 1], [rn, rs, 1.6, 11, 12, 13, 7.85e-9], [60000.0, 2e6, 2e6]]
            line = (lambda row: ",".join(map(str, row))) if comma else (lambda row: "".join(f"{v:>10}" for v in row))
            curve = lambda n, *y: f"*DEFINE_CURVE\n{n:10d}\n" + "".join(f"{x:20.10g}{v:20.10g}\n" for x, v in enumerate(y))  # noqa: E731
            steel = "*MAT_PIECEWISE_LINEAR_PLASTICITY\n" + f"{8:10d}{7.85e-9:10.3g}{210000.0:10.1f}{0.3:10.1f}{300.0:10.1f}{1500.0:10.1f}\n\n\n\n"
            return ("*KEYWORD\n" + steel + "*CONSTRAINED_INTERPOLATION_SPOTWELD" + ("_TITLE\n" + title if title else "") + "\n$ the weld\n"
                    + "\n".join(map(line, rows)) + "\n" + curve(11, 1.5, 1.5) + curve(12, 0.2, 0.1) + curve(13, 0.8, 0.4) + "*END\n")
        self.write(welded(5200.0, 8100.0, 0.2), "truth.k")
        self.nugget("coupon", "truth.k", "-o", "truth", "--only", "ks2_00,ks2_45,ks2_90,coach_peel")
        for options in ({"title": "a name"}, {"comma": True}):
            with self.subTest(**options):
                run = self.fit(self.read("truth/curves.csv"), text=welded(7000.0, 7000.0, 0.1, **options))
                found = dict(re.findall(r"^ (tension|shear|bending) \(\S+\) +(\S+)  95 %", run.stdout, re.M))
                for name, truth in (("tension", 1.5 * 5200.0), ("shear", 1.5 * 8100.0), ("bending", 1.5 * 5200.0 / 0.2)):
                    self.assertAlmostEqual(float(found[name]) / truth, 1.0, delta=0.04, msg=name)
                for row in csv.DictReader(io.StringIO(self.read("card2_runs/fit.csv"))):
                    self.assertAlmostEqual(float(row["simulated_force"]) / float(row["measured_force"]), 1.0, delta=0.03, msg=row["test"])
                after = [line for line in self.read("card2.k").split("$ the weld\n")[1].splitlines() if not line.startswith("$")]
                fields = [[float(f) for f in (line.split(",") if "," in line else [line[i:i + 10] for i in range(0, len(line), 10)])] for line in after[:2]]
                self.assertAlmostEqual(fields[0][6] / 0.2, 1.0, delta=0.05)
                self.assertAlmostEqual(fields[1][0] * 1.5 / float(found["tension"]), 1.0, delta=1e-4)
                self.assertEqual((fields[0][:6], fields[1][2:6]), ([1, 2, 77, 3.0, 3.0, 150000.0], [1.6, 11, 12, 13]))

    def test_damage_of_a_known_card(self):
        """RS of curves that the weld of a known card gave: found again from elsewhere; a curve that stops at its peak tells nothing of it.
        Sabotage that this catches: work before the peak counted, RS written into another field."""
        def damaged(nrr, nrs, rs):
            fields = lambda *values: "".join(f"{v:10.4g}" for v in values)  # noqa: E731
            return ("*KEYWORD\n*MAT_SPOTWELD_DAMAGE-FAILURE\n" + f"{7:10d}" + fields(7.85e-9, 210000.0, 0.3, 500.0, 1000.0) + "\n"
                    + fields(0.0, nrr, nrs, nrs, 0.0, 0.0, 0.0) + f"{3:10d}\n" + f"{rs:10.4g}{0:10d}" + " " * 50 + f"{11:10d}\n*END\n")
        self.write(damaged(NRR, NRS, 0.4), "truth.k")
        self.nugget("coupon", "truth.k", "-o", "truth", "--only", "ks2_00,ks2_90")
        rows = list(csv.DictReader(io.StringIO(self.read("truth/curves.csv"))))
        table = ["test,displacement,force"] + [f"{r['test']},{r['displacement']},{r['force']}" for r in rows]
        ends = {r["test"]: float(r["displacement"]) for r in rows}
        table += [f"{test},{end + 0.002},0" for test, end in ends.items()]
        run = self.fit("\n".join(table) + "\n", damaged(0.8 * NRR, 0.8 * NRS, 0.12))
        value = lambda name: float(re.search(rf"^ {name} +(\S+)  ", run.stdout, re.M)[1])  # noqa: E731
        self.assertAlmostEqual(value("NRR") / NRR, 1.0, delta=0.02)
        self.assertAlmostEqual(value("NRS = NRT") / NRS, 1.0, delta=0.02)
        self.assertAlmostEqual(value("RS") / 0.4, 1.0, delta=0.05)
        last = self.read("card2.k").splitlines()[-2]
        self.assertAlmostEqual(float(last[:10]) / value("RS"), 1.0, delta=1e-4)
        self.assertEqual(last[70:80].strip(), "11")
        for row in csv.DictReader(io.StringIO(self.read("card2_runs/fit.csv"))):
            self.assertAlmostEqual(float(row["simulated_work_after_peak"]) / float(row["measured_work_after_peak"]), 1.0, delta=0.1)
        self.assertIn("RS 0.12 of the card is kept", self.fit(
            "test,displacement,force\nks2_00,0,0\nks2_00,0.1,8300\nks2_90,0,0\nks2_90,6,5200\n", damaged(4000.0, 6000.0, 0.12)).stdout)

    def test_bricks(self):
        """Four bricks carry what the beam does: strengths of a formula are found with them, too."""
        self.write(curves({(f"ks2_{angle:02d}", ""): force(angle) for angle in (0, 90)}), "curves.csv")
        self.write(card(), "card.k")
        run = self.nugget("fit", "curves.csv", "card.k", "-o", "card2.k", "--as", "solid4")
        self.assertIn("as four bricks", run.stdout)
        for name, truth in (("NRR", NRR), ("NRS = NRT", NRS)):
            self.assertAlmostEqual(float(re.search(rf"^ {name} +(\S+)  ", run.stdout, re.M)[1]) / truth, 1.0, delta=0.03)
        self.assertNotIn("warning", run.stdout)

    def test_refusals(self):
        for table, text, word in (
                ("a,b\n1,2\n", None, "curves.csv:1: error: the first line names the columns; expected test, displacement, force"),
                (curves({("ks2_95", ""): 1.0}), None, "curves.csv:2: error: test = ks2_95: expected lap_shear"),
                ("test,displacement,force\nks2_00,0.1,much\n", None, "force = much: expected two numbers"),
                ("test,displacement,force\nks2_00,0.1,-5\n", None, "no force above 0"),
                ("test,displacement,force\n", None, "there is no curve in it"),
                (curves({("ks2_00", ""): 5000.0}), card(nrr=-5.0).replace("*END", "*DEFINE_CURVE\n5\n0.0,3000.0\n1.0,4000.0\n*END"),
                 "strength is a curve over the strain rate"),
                (curves({("ks2_00", ""): 5000.0}), card().replace(f"{3000.0:10.4g}" * 3, f"{3000.0:10.4g}" * 2 + f"{2000.0:10.4g}"),
                 "NRS and NRT, MSS and MTT differ")):
            with self.subTest(word):
                self.assertIn(word, self.fit(table, text, expect=1).stderr)
                self.assertNotIn("card2.k", self.files())
        self.assertRegex(self.fit(curves({("ks2_00", ""): 5000.0}), card(nrr=-5.0), expect=1).stderr, r"card\.k:6:\d+: error: \*MAT_SPOTWELD nrr = -5")
        self.write(card(), "card.k")
        self.assertIn("would be overwritten", self.nugget("fit", "curves.csv", "card.k", "-o", "card.k", expect=2).stderr)

    def test_what_the_tests_do_not_tell(self):
        run = self.fit(curves({("ks2_00", "A"): force(0), ("ks2_00", "B"): force(0)}), expect=1)
        self.assertIn("curves.csv: the tests do not determine NRR", run.stderr)
        run = self.fit(curves({("ks2_00", ""): 1e7}), text=card(nrr=0.0), expect=1)
        self.assertRegex(run.stderr, r"ks2_00: 1e\+07 was measured, but the coupon carries no more than")


if __name__ == "__main__":
    unittest.main()
