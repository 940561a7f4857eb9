# SPDX-License-Identifier: Apache-2.0
"""`nugget coupon`: decks that run, forces against the formula of the card, what the card may hold and what is refused.

Sabotage that this catches: the moving grip of KS-2 held across the pull (45 degrees is off), the coupon turned the wrong way, a surface with
axial and shear swapped, the peak taken after the weld has failed, the location node of a rivet on one of the sheets, bricks that are not one
weld.
"""
import csv
import io
import math
import re
import unittest
import xml.etree.ElementTree as xml

from nugget_command import CommandTest

NRR, NRS = 6000.0, 9000.0


def card(nrr=NRR, nrs=NRS, mss=0.0, more="", mid=7, stress=1.0, density=7.85e-9):
    field = lambda x: f"{x:10.4g}"  # noqa: E731
    return ("*KEYWORD\n*MAT_SPOTWELD\n" + f"{mid:10d}" + "".join(map(field, (density, 210000.0 * stress, 0.3, 3000.0 * stress, 1000.0 * stress)))
            + "\n" + "".join(map(field, (0.0, nrr, nrs, nrs, 0.0, mss, mss))) + "\n" + more + "*END\n")


STEEL = "*MAT_PIECEWISE_LINEAR_PLASTICITY\n" + f"{8:10d}{7.85e-9:10.3g}{210000.0:10.1f}{0.3:10.1f}{300.0:10.1f}{1500.0:10.1f}\n\n\n\n"


def curve(number, *points):
    return f"*DEFINE_CURVE\n{number:10d}\n" + "".join(f"{x:20.10g}{y:20.10g}\n" for x, y in points)


def interpolation_weld(parts=(1, 2), more=""):
    """RN 6000, RS 9000, BETA 2, a force that does not harden; breaks at plastic displacements of 0.4 (tension) to 0.8 (shear)."""
    return ("*KEYWORD\n" + STEEL + "*CONSTRAINED_INTERPOLATION_SPOTWELD\n" + f"{parts[0]:10d}{parts[1]:10d}{77:10d}{3.0:10.1f}{3.0:10.1f}{150000.0:10.1f}\n"
            + f"{NRR:10.1f}{NRS:10.1f}{2.0:10.1f}{11:10d}{12:10d}{13:10d}{7.85e-9:10.3g}\n" + f"{60000.0:10.1f}{2e6:10.1f}{2e6:10.1f}\n"
            + curve(11, (0, 1), (1, 1)) + curve(12, (0, 0.2), (1, 0.1)) + curve(13, (0, 0.8), (1, 0.4)) + more + "*END\n")


RIVET = ("*KEYWORD\n" + STEEL + "*CONSTRAINED_SPR2\n" + f"{2:10d}{1:10d}{77:10d}{3.0:10.1f}{6.0:10.1f}{4000.0:10.1f}{6000.0:10.1f}{1.5:10.1f}\n"
         + f"{2.0:10.1f}{0.4:10.1f}{0.5:10.1f}{1.0:10.1f}{1.0:10.1f}{1.0:10.1f}{7.85e-9:10.3g}\n*END\n")


def formula(angle, nrr=NRR, nrs=NRS):
    return 1.0 / math.hypot(math.sin(math.radians(angle)) / nrr, math.cos(math.radians(angle)) / nrs)


class Coupon(CommandTest):
    def coupon(self, *options, text=None, expect=0):
        self.write(text or card(), "weld.k")
        return self.nugget("coupon", "weld.k", "-o", "out", *options, expect=expect)

    def table(self, name):
        return list(csv.DictReader(io.StringIO(self.read(f"out/{name}.csv"))))

    def test_ks2_lies_on_the_surface_of_the_card(self):
        run = self.coupon("--only", "ks2_00,ks2_45,ks2_90")
        self.assertIn("default: a steel of 300 MPa yield stress", run.stdout)
        for row in self.table("surface"):
            expected = formula(float(row["angle"]))
            self.assertAlmostEqual(float(row["force"]) / expected, 1.0, delta=1e-5)
        rows = self.table("coupon")
        self.assertEqual([r["test"] for r in rows], ["ks2_00", "ks2_45", "ks2_90"])
        for row in rows:
            expected = formula(float(row["angle"]))
            with self.subTest(row["test"]):
                self.assertEqual(row["failed"], "yes")
                self.assertAlmostEqual(float(row["peak_force"]) / expected, 1.0, delta=0.05)
                self.assertAlmostEqual(float(row["load"]) / expected, 1.0, delta=0.05)
                # The weld turns with its sheets; its own force is on the surface at its own angle.
                self.assertAlmostEqual(float(row["load_angle"]), float(row["angle"]), delta=6.0)
                self.assertAlmostEqual(float(row["load"]) / float(row["surface_at_load"]), 1.0, delta=0.01)
                last = [r for r in self.table("curves") if r["test"] == row["test"]][-1]
                self.assertGreater(float(last["force"]), 0.5 * expected)  # not beyond failure
        picture = xml.fromstring(self.read("out/coupon.svg"))
        self.assertEqual(len(list(picture.iter("{http://www.w3.org/2000/svg}circle"))), 3)
        page = self.read("out/coupon.html")
        self.assertEqual(re.findall(r'<tr class="coupon" id="(\w+)">', page), ["ks2_00", "ks2_45", "ks2_90"])
        self.assertIn("report.html", self.files("out/ks2_45"))

    def test_sixteen_bricks_are_one_weld(self):
        self.coupon("--only", "ks2_45,lap_shear", "--as", "solid16")
        for row in self.table("coupon"):
            self.assertEqual(row["failed"], "yes")
            self.assertAlmostEqual(float(row["peak_force"]) / formula(float(row["angle"])), 1.0, delta=0.05)
        (weld,) = csv.DictReader(io.StringIO(self.read("out/ks2_45/welds.csv")))
        self.assertEqual((weld["kind"], weld["tied"]), ("assembly", "yes"))
        area = 0.25 * math.pi * 5.0**2 * 1.5
        self.assertAlmostEqual(float(weld["diameter"]) ** 2 * math.pi / 4 / area, 1.0, delta=1e-3)

    def test_interpolation_weld_and_rivet_lie_on_the_surfaces_of_their_cards(self):
        """RN LCF and RS LCF of the interpolation weld, FN and FT of the rivet are what pure tension and pure shear carry."""
        for text, normal, shear in ((interpolation_weld(), NRR, NRS), (RIVET, 4000.0, 6000.0)):
            with self.subTest(text.split("CONSTRAINED_")[1][:4]):
                run = self.coupon("--only", "ks2_00,ks2_45,ks2_90", text=text)
                self.assertIn(" of the card, diameter 6", run.stdout)
                rows = {row["test"]: row for row in self.table("coupon")}
                for test, expected in (("ks2_00", shear), ("ks2_90", normal)):
                    self.assertEqual(rows[test]["failed"], "yes")
                    self.assertAlmostEqual(float(rows[test]["surface_force"]) / expected, 1.0, delta=1e-3)
                    self.assertAlmostEqual(float(rows[test]["peak_force"]) / expected, 1.0, delta=0.02)
                    # What stands in the weld is what it carried at the peak, not the nothing that is left at its rupture.
                    self.assertAlmostEqual(float(rows[test]["load"]) / expected, 1.0, delta=0.02)
                both = rows["ks2_45"]
                self.assertLess(float(both["surface_force"]), 0.9 * shear)
                self.assertAlmostEqual(float(both["peak_force"]) / float(both["surface_force"]), 1.0, delta=0.05)
        for row in self.table("surface"):
            self.assertGreaterEqual(float(row["force"]), 3999.0)

    def test_moments_take_their_share(self):
        """Coach peel bends its weld: with MSS and MTT it fails below the surface of the forces."""
        self.coupon("--only", "coach_peel", text=card(nrr=3000.0, mss=4000.0))
        (row,) = self.table("coupon")
        self.assertEqual((row["failed"], row["failure_mode"]), ("yes", "bending moment"))
        self.assertLess(float(row["peak_force"]), 0.8 * float(row["surface_force"]))
        terms = (float(row["axial"]) / 3000.0) ** 2 + (float(row["shear"]) / NRS) ** 2 + (float(row["bending"]) / 4000.0) ** 2
        self.assertAlmostEqual(terms, 1.0, delta=0.02)

    def test_all_decks_are_sound(self):
        run = self.coupon("--decks")
        self.assertIn("10 decks in out; nothing was run", run.stdout)
        decks = [name for name in self.files("out") if name.endswith(".k")]
        self.assertEqual(len(decks), 10)
        for name in decks:
            with self.subTest(name):
                self.nugget("check", f"out/{name}", "-o", "audit")
                self.assertEqual([f["text"] for f in self.json("audit/findings.json") if f["severity"] == "error"], [])
                (weld,) = csv.DictReader(io.StringIO(self.read("audit/welds.csv")))
                self.assertEqual((weld["tied"], weld["sheet1"], weld["sheet2"], weld["case1"], weld["case2"]), ("yes", "1", "2", "1", "1"))
                self.assertAlmostEqual(float(weld["diameter"]), 5.0 * 1.5 ** 0.5, 3)

    def test_the_card_brings_sheets_and_section(self):
        sheets = ("*SECTION_SHELL\n         3         2\n       1.0\n*SECTION_SHELL\n         4        16\n       2.0\n*MAT_ELASTIC\n"
                  "         8  7.85e-09  210000.0       0.3\n*SECTION_BEAM\n         5         9       1.0         2       1.0\n       7.0       7.0\n")
        run = self.coupon("--decks", "--only", "lap_shear", text=card(more=sheets))
        self.assertIn("lower sheet: thickness 1 (section 3 of the card), material 8 of the card", run.stdout)
        self.assertIn("upper sheet: thickness 2 (section 4 of the card), material 8 of the card", run.stdout)
        self.assertIn("diameter 7 (section 5 of the card)", run.stdout)
        other = self.coupon("--decks", "--only", "lap_shear", "--diameter", "5", text=card(more=sheets))
        self.assertIn("diameter 5 (as asked for; 7 in section 5 of the card, whose strengths are taken as they stand)", other.stdout)
        self.coupon("--decks", "--only", "lap_shear", text=card(more=sheets))
        self.nugget("check", "out/lap_shear.k", "-o", "audit")
        (weld,) = csv.DictReader(io.StringIO(self.read("audit/welds.csv")))
        self.assertEqual(float(weld["diameter"]), 7.0)
        self.assertAlmostEqual(float(weld["length"]), 1.5, 6)

    def test_other_units_give_the_same(self):
        """kN, mm, ms, kg: the same forces in kN, a thousandth of those in N."""
        self.coupon("--only", "ks2_30")
        (newton,) = self.table("coupon")
        self.coupon("--only", "ks2_30", text=card(nrr=6.0, nrs=9.0, stress=1e-3, density=7.85e-6))
        (kilonewton,) = self.table("coupon")
        self.assertAlmostEqual(float(kilonewton["peak_force"]) / (1e-3 * float(newton["peak_force"])), 1.0, delta=0.02)

    def test_no_file_of_that_name_elsewhere_takes_its_place(self):
        """*INCLUDE looks in the current folder first: there, ../weld.k is another card than beside the deck."""
        self.write(card(nrr=1.0, nrs=1.0), "weld.k")
        self.write(card(), "inner/weld.k")
        (self.folder / "inner" / "a").mkdir()
        self.nugget("coupon", "../weld.k", "-o", "b/c", "--only", "ks2_90", cwd=self.folder / "inner" / "a")
        (row,) = csv.DictReader(io.StringIO(self.read("inner/a/b/c/coupon.csv")))
        self.assertAlmostEqual(float(row["peak_force"]) / NRR, 1.0, delta=0.05)

    def test_refusals(self):
        for text, word in ((card() + "*NODE\n1,0.,0.,0.\n", "1 nodes and 0 parts in it, expected materials"),
                           (card().replace("*END\n", "") + card(mid=9)[9:], "2 *MAT_SPOTWELD in it: 7, 9, expected one"),
                           ("*KEYWORD\n*END\n", "0 *MAT_SPOTWELD in it, expected one"),
                           (card(density=1.0), "the units are not recognised"),
                           (interpolation_weld((11, 2)), "joins parts 11 and 2, expected 1 and 2"),
                           (interpolation_weld(more=card()[9:]), "1 *MAT_SPOTWELD and 1 welds or rivets that are cards of their own in it: 7, "),
                           (interpolation_weld().replace(STEEL, ""), "correct RO and E of the sheets' material")):
            with self.subTest(word):
                self.assertIn(word, self.coupon(text=text.replace("*END\n", "") + "*END\n", expect=1).stderr)
        broken = card().replace("       0.3", "       0.7")
        run = self.coupon(text=broken, expect=1)
        self.assertRegex(run.stderr, r"weld\.k:3:\d+: error: \*MAT_SPOTWELD pr = 0\.7")
        for option in (("--diameter", 5), ("--as", "beam")):
            self.assertIn("[leave out --diameter and --as]", self.coupon(*option, text=interpolation_weld(), expect=1).stderr)
        self.write("test,displacement,force\nks2_45,0,0\nks2_45,1,5000\n", "measured.csv")
        self.write(RIVET, "rivet.k")
        self.assertIn("not for a rivet", self.nugget("fit", "measured.csv", "rivet.k", "-o", "fitted.k", expect=1).stderr)
        self.coupon("--only", "ks2_50", expect=2)
        self.coupon("--thickness", "1,2,3", expect=2)


if __name__ == "__main__":
    unittest.main()
