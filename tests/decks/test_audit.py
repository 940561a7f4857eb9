# SPDX-License-Identifier: Apache-2.0
"""What `nugget check` says of welds: every check of the audit on one bad deck, none of them on a good one, and as much of the
truth as there is about decks that are refused."""
import collections
import csv
import io
import math
import re
import unittest

from lap_joint import deck as lap_joint
from nugget_command import CommandTest
from welded_sheets import Sheets, weld_material

NOTES = {"pitch", "step", "mass"}  # in the table and in welds.csv, but no findings
CHECKS = NOTES | {"sheets", "stack", "length", "stretch", "twin", "thickness", "diameter", "angle", "edge", "flange", "mesh", "aspect"}


def good_deck():
    """Sound welds of 5 mm in sheets of 1 mm, soft enough not to govern the step: beams through two and four sheets, a brick."""
    s = Sheets()
    s.cards += ["*CONTROL_TERMINATION\n1.0e-5", weld_material(2, young=2000.0)]
    gap = 1.02
    two = [s.sheet(1.0, 0, 0, i * gap, 8, 8, 5.0) for i in range(2)]
    four = [s.sheet(1.0, 100, 0, i * gap, 8, 8, 5.0) for i in range(4)]
    welds = s.beam_part(5.0, 2)
    for x in (12.5, 27.5):
        s.beam(welds, (x, 17.5, 0), (x, 17.5, gap))
    bricked = [s.sheet(1.0, 200, 0, i * gap, 8, 8, 5.0) for i in range(2)]
    bricks = s.brick_part(2)
    s.brick(bricks, 217.5, 17.5, 0.0, 4.43, gap)
    for i in range(3):
        s.beam(welds, (117.5, 17.5, i * gap), (117.5, 17.5, (i + 1) * gap))
    s.tie([welds, bricks], two + four + bricked)
    s.part_set(1, two + four + bricked)
    s.cards.append("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n1,0,2\n0.1\n1.0")
    return s.text()


def bad_deck():
    """A patch of sheets for each check, every 200 mm in x; the weld of each by the name of the check."""
    s = Sheets()
    s.cards += ["*CONTROL_TERMINATION\n1.0e-5", weld_material(2), weld_material(3, dt=2e-6)]
    sheets, weld = [], {}
    normal, thin, heavy, bricks = s.beam_part(5.0, 2), s.beam_part(2.0, 2), s.beam_part(5.0, 3), s.brick_part(2)

    def patch(thicknesses=(1.0, 1.0), heights=(0.0, 1.0), nx=8, ny=8, size=5.0):
        x = 200.0 * len(weld)
        sheets.extend(s.sheet(t, x, 0, z, nx, ny, size) for t, z in zip(thicknesses, heights))
        return x

    def spot(x, y=17.5, part=normal, bottom=0.0, top=1.0, lean=0.0):
        return s.beam(part, (x, y, bottom), (x + lean, y, top))

    x = patch((1.0,), (0.0,))
    weld["sheets"] = spot(x + 17.5, top=30.0)
    x = patch((1.0,) * 5, (0.0, 1.0, 2.0, 3.0, 4.0))
    weld["stack"] = spot(x + 17.5)
    for z in (1.0, 2.0, 3.0):
        spot(x + 17.5, bottom=z, top=z + 1)
    x = patch(heights=(0.0, 10.0))
    weld["length"] = spot(x + 17.5, top=10.0)
    x = patch(heights=(0.0, 1.8))
    weld["stretch"] = spot(x + 17.5, bottom=0.4, top=1.4)
    x = patch()
    spot(x + 17.5)
    weld["twin"] = spot(x + 17.6)
    x = patch((0.3, 1.0), (0.0, 0.65))
    weld["thickness"] = spot(x + 17.5, top=0.65)
    x = patch()
    weld["diameter"] = spot(x + 17.5, part=thin)
    x = patch()
    weld["angle"] = spot(x + 17.5, lean=0.5)
    x = patch()
    weld["edge"] = spot(x + 2.0)
    x = patch(nx=8, ny=2, size=7.0)
    weld["flange"] = spot(x + 24.5, 7.0)
    x = patch()
    spot(x + 17.5)
    weld["pitch"] = spot(x + 23.5)
    x = patch(nx=4, ny=4, size=20.0)
    weld["mesh"] = spot(x + 50.0, 50.0)
    x = patch((0.4, 0.4), (0.0, 0.4))
    weld["aspect"] = s.brick(bricks, x + 17.5, 17.5, 0.0, 4.43, 0.4)
    x = patch()
    weld["step"] = spot(x + 17.5)
    x = patch()
    weld["mass"] = spot(x + 17.5, part=heavy)
    s.tie([normal, bricks], sheets, 1)
    s.tie([thin, heavy], sheets, 2)
    s.part_set(1, [*sheets, normal])
    s.cards.append("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n1,0,2\n0.1\n1.0")
    return s.text(), weld


class Audit(CommandTest):
    def check(self, text, expect=0):
        self.write(text)
        self.nugget("check", "model.k", "-o", "audit", expect=expect)
        return self.welds(), self.json("audit/findings.json"), self.read("audit/check.log")

    def welds(self, folder="audit"):
        return list(csv.DictReader(io.StringIO(self.read(f"{folder}/welds.csv"))))

    def test_every_check_finds_its_weld_in_the_bad_deck(self):
        text, weld = bad_deck()
        self.assertEqual(set(weld), CHECKS)
        welds, found, log = self.check(text)
        remarks = {int(w["id"]): w["remarks"] for w in welds}
        for name, number in weld.items():
            with self.subTest(name):
                self.assertRegex(remarks[number], rf"(^|; ){name}: ")
                # ` name  measured  least  most  mark  remarks  worst welds`: the line of the table counts it.
                line = re.search(rf"(?m)^ {name} .* (!|note) +(\d+)  ", log)
                self.assertIsNotNone(line, log)
                self.assertEqual(line[1], "note" if name in NOTES else "!")
                self.assertEqual(int(line[2]), sum(bool(re.search(rf"(^|; ){name}: ", r)) for r in remarks.values()))
                told = [f for f in found if f["severity"] == "warning" and f"weld {number}: " in f["text"] and "(expected: " in f["text"]]
                self.assertEqual(name in NOTES, not told, told)
        texts = [f["text"] for f in found]
        self.assertTrue([t for t in texts if "in this sliding contact" in t], texts)
        self.assertTrue([t for t in texts if "2 *CONTACT_SPOTWELD contacts, first" in t], texts)

    def test_no_check_speaks_of_the_good_deck(self):
        welds, found, log = self.check(good_deck())
        self.assertEqual([w["remarks"] for w in welds], [""] * 6)
        self.assertEqual([f for f in found if f["severity"] != "note"], [])
        self.assertEqual([f["text"] for f in found if "sliding" in f["text"] or "one is enough" in f["text"]], [])
        self.assertIn("spots: 3 through 2 sheets, 1 through 4 sheets", log)
        for name in CHECKS:
            self.assertRegex(log, rf"(?m)^ {name} .* ok +0 ")

    def test_a_discrete_beam_among_beams_and_springs_is_no_weld(self):
        """Between a beam and a spring; the same beam alone, which hangs on nothing, is one. Sabotage: only shells and bricks
        count as what it belongs to."""
        lines = ["*KEYWORD", "*CONTROL_TERMINATION", "1.0e-6", "*MAT_ELASTIC", "1,7.85e-9,210000.0,0.3",
                 "*MAT_LINEAR_ELASTIC_DISCRETE_BEAM", "2,1.0e-9,100.0,100.0,100.0,100.0,100.0,100.0", "", "", "*MAT_SPRING_ELASTIC", "3,100.0",
                 "*PART", "frame", "1,1,1", "*PART", "bushing", "2,2,2", "*PART", "spring", "3,3,3", "*SECTION_BEAM", "1,1,1.0,2,1",
                 "4.0,4.0,0.0,0.0", "*SECTION_BEAM", "2,6", "10.0,1.0", "*SECTION_DISCRETE", "3,0", "0.0", "*NODE"]
        lines += [f"{i},{10 * i}.0,0.0,0.0" for i in range(1, 5)] + ["9,0.0,50.0,0.0", "*ELEMENT_MASS", "20,3,1.0e-6", "21,4,1.0e-6"]
        frame = ["*ELEMENT_BEAM", "1,1,1,2,9", "*ELEMENT_DISCRETE", "3,3,3,4", "*END"]
        bushing = ["*ELEMENT_BEAM", "2,2,2,3,9"]
        for present, told in ((bushing + frame, False), (bushing + ["*ELEMENT_MASS", "22,1,1.0e-6", "23,2,1.0e-6", "*END"], True)):
            self.write("\n".join(lines + present) + "\n")
            self.assertEqual("no contact tracks it" in self.nugget("check", "model.k").stderr, told)

    def test_a_sliding_contact_that_takes_everything_is_a_note(self):
        text = good_deck().replace("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n1,0,2", "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,0,5")
        _, found, _ = self.check(text)
        (told,) = [f for f in found if "in this sliding contact" in f["text"]]
        self.assertEqual(told["severity"], "note")

    def test_the_audit_tells_the_mass_that_the_run_adds(self):
        """DT of the weld material and DT2MS, alone and together; L = 1.2, d = 6. Together: DT first, physical mass, then DT2MS."""
        step, mass = 1.2 / (210000.0 / 7.85e-9) ** 0.5, 7.85e-9 * math.pi * 9.0 * 1.2
        up = lambda to, of: max((to / step) ** 2 - (of / step) ** 2, 0.0)  # noqa: E731
        for dt, dt2ms in ((5e-7, -1e-6), (1.5e-6, -1e-6), (0.0, -1e-6), (5e-7, 0.0), (5e-7, 1e-6), (0.0, 2e-7)):
            with self.subTest(dt=dt, dt2ms=dt2ms):
                self.write(lap_joint(("       0.0       0.9\n", f"       0.0       0.9         0       0.0{dt2ms:10.1e}\n"),
                                     ("       0.3     500.0    1000.0\n", f"       0.3     500.0    1000.0{dt:10.1e}\n")))
                self.nugget("check", "model.k", "-o", "audit")
                self.nugget("run", "model.k", "-o", "run", "--quiet")
                (audited,), (ran,) = self.welds(), self.welds("run")
                by_dt = mass * up(dt, step)
                by_dt2ms = mass * up(0.9 * abs(dt2ms), max(step, dt))
                if dt2ms == 2e-7:  # above 0 every element gets exactly that step, welds TSSFAC times it: lighter here
                    by_dt2ms = mass * ((0.9 * dt2ms / step) ** 2 - 1.0)
                for welds in (audited, ran):
                    self.assertAlmostEqual(float(welds["mass_by_dt"]) / mass, by_dt / mass, delta=1e-4)
                    self.assertAlmostEqual(float(welds["mass_by_dt2ms"]) / mass, by_dt2ms / mass, delta=1e-4)
                self.assertAlmostEqual(float(ran["added_mass"]) / mass, (by_dt + by_dt2ms) / mass, delta=1e-4)
                summary = self.json("run/summary.json")
                self.assertAlmostEqual(summary["mass"]["added_to_welds"] / mass, (by_dt + by_dt2ms) / mass, delta=1e-4)
                if dt2ms < 0.0:
                    self.assertAlmostEqual(summary["mass"]["added"] / mass, by_dt2ms / mass, delta=1e-4)
                if dt2ms < 0.0 and dt < 9e-7:  # else the weld does not control it
                    self.assertAlmostEqual(summary["time_step"]["first"] / 9e-7, 1.0, delta=1e-6)
                for folder in ("audit", "run"):
                    told = [f for f in self.json(folder + "/findings.json") if f["text"].startswith("DT beside DT2MS")]
                    self.assertEqual(len(told), 1 if dt and dt2ms else 0)
                    if told:
                        self.assertEqual((told[0]["severity"], told[0]["keyword"], told[0]["field"], told[0]["remedy"]),
                                         ("warning", "*MAT_SPOTWELD", "dt", "DT = 0 where DT2MS is used"))

    def test_a_weld_with_a_free_end_is_scaled_as_other_elements(self):
        """To |DT2MS|, not to TSSFAC times it, which would be its very limit. Node 302 is 7.8 above its sheet, out of reach."""
        step, mass = 9.0 / (210000.0 / 7.85e-9) ** 0.5, 7.85e-9 * math.pi * 9.0 * 9.0
        self.write(lap_joint(("       0.0       0.9\n", "       0.0       0.9         0       0.0  -3.0e-06\n"),
                             (f"{302:8d}{9.0:16.4f}{9.0:16.4f}{1.2:16.4f}", f"{302:8d}{9.0:16.4f}{9.0:16.4f}{9.0:16.4f}"),
                             ("         0         0         0         0         1\n*DATABASE_GLSTAT", "         0         0         0         0         0\n*DATABASE_GLSTAT")))
        self.nugget("check", "model.k", "-o", "audit")
        self.nugget("run", "model.k", "-o", "run", "--quiet")
        (audited,), (ran,) = self.welds(), self.welds("run")
        self.assertEqual((ran["tied"], ran["length"]), ("no", "9"))
        for added in (audited["mass_by_dt2ms"], ran["mass_by_dt2ms"], ran["added_mass"]):
            self.assertAlmostEqual(float(added) / mass, (3e-6 / step) ** 2 - 1.0, delta=1e-4)
        self.assertAlmostEqual(self.json("run/summary.json")["time_step"]["first"] / 2.7e-6, 1.0, delta=1e-6)


class RefusedDecks(CommandTest):
    """Exit code 1, and an account of the welds all the same."""

    def refused(self, deck, expect=1):
        run = self.nugget("check", deck, "-o", "audit", expect=expect)
        text = (self.folder / "audit" / "welds.csv").read_text(encoding="utf-8")
        return run, list(csv.DictReader(io.StringIO(text))), self.json("audit/findings.json")

    def test_a_sheet_of_a_refused_section_has_no_thickness_to_remark_on(self):
        """The thickness is not known: 0 mm is not what the deck says. Sabotage: 0 taken as the thickness."""
        self.write(lap_joint(("*SECTION_SHELL\n         1         2", "*SECTION_SHELL\n        1x         2")))
        run, welds, found = self.refused("model.k")
        self.assertTrue(any("section 1 is not defined" in f["text"] for f in found))
        self.assertFalse([f for f in found if "too thin" in f["text"] or "usual for sheets" in f["text"]])
        self.assertEqual(welds[0]["tied"], "yes")

    def test_a_deck_refused_for_something_else_is_audited_whole(self):
        """An airbag refuses the deck; its weld is tied, measured and told as without it."""
        self.write(lap_joint())
        self.nugget("check", "model.k", "-o", "sound")
        sound = self.read("sound/welds.csv")
        self.write(lap_joint(("*PART\nlower sheet", "*AIRBAG_HYBRID\n1\n*PART\nlower sheet")))
        run, welds, found = self.refused("model.k")
        self.assertEqual(self.read("audit/welds.csv"), sound)
        self.assertEqual((len(welds), welds[0]["tied"], welds[0]["sheet1"], welds[0]["sheet2"]), (1, "yes", "1", "2"))
        self.assertIn("The deck is refused; what can be said of its welds all the same:", run.stdout)
        self.assertIn(" sheets      each on two sheets\n", run.stdout)
        self.assertTrue([f for f in found if f["text"] == "1 weld, each on two sheets"], found)

    def test_a_run_that_is_refused_says_of_the_welds_what_a_check_says(self):
        """Findings and account. Sabotage: the run that is refused at its first error."""
        for change in (("*PART\nlower sheet", "*AIRBAG_HYBRID\n1\n*PART\nlower sheet"),
                       ("         3         1         3         2\n", "         3        77         3         2\n")):
            with self.subTest(change):
                self.write(lap_joint(change))
                check, _, found = self.refused("model.k")
                run = self.nugget("run", "model.k", "-o", "run", expect=1)
                self.assertEqual(self.json("run/findings.json"), found)
                self.assertEqual(run.stdout, "")
                account = run.stderr[run.stderr.index("The deck is refused; what can be said"):].rstrip()
                self.assertIn(account, check.stdout)
                self.assertIn(account, self.read("run/run.log"))
                self.assertIn("the deck is refused; nothing was run", run.stderr)

    def test_a_sheet_of_a_refused_material_still_carries_its_weld(self):
        self.write(lap_joint(("*MAT_PIECEWISE_LINEAR_PLASTICITY", "*MAT_SOIL_AND_FOAM")))
        _, welds, _ = self.refused("model.k")
        self.assertEqual((welds[0]["tied"], welds[0]["diameter"], welds[0]["length"]), ("yes", "6", "1.2"))

    def test_a_weld_of_a_refused_material_is_presumed(self):
        self.write(lap_joint(("*MAT_SPOTWELD", "*MAT_SOIL_AND_FOAM")))
        run, welds, _ = self.refused("model.k")
        self.assertEqual((len(welds), welds[0]["tied"], welds[0]["remarks"]),
                         (1, "yes", "its part has no material: taken for a weld"))
        self.assertIn("materials   weld part 3 has none in the deck", run.stdout)

    def test_a_contact_that_lost_its_sheets_is_left_out_by_name(self):
        self.write(lap_joint(("         3         1         3         2\n", "         3        77         3         2\n")))
        run, welds, found = self.refused("model.k")
        self.assertEqual((len(welds), welds[0]["tied"]), (1, "no"))
        self.assertIn("contacts    *CONTACT_SPOTWELD 1 left out", run.stdout)
        self.assertFalse([f for f in found if "nothing is tied" in f["text"]], "the missing set has been told")

    def test_what_failure_lacks_is_told_of_a_refused_deck_too(self):
        change = ("*MAT_SPOTWELD\n         3  7.85e-09  210000.0       0.3     500.0    1000.0\n"
                  "       0.0    8000.0    6000.0    6000.0    9000.0    7000.0    7000.0\n",
                  "*MAT_SPOTWELD_DAMAGE-FAILURE\n         3  7.85e-09  210000.0       0.3     500.0    1000.0\n       0.0\n"
                  "       0.0         6       0.0\n*DEFINE_SPOTWELD_RUPTURE_STRESS\n         3     500.0     300.0\n")
        for refuse, expect in ((False, 0), (True, 1)):
            with self.subTest(refuse=refuse):
                more = [("*PART\nlower sheet", "*AIRBAG_HYBRID\n1\n*PART\nlower sheet")] if refuse else []
                self.write(lap_joint(change, *more))
                _, _, found = self.refused("model.k", expect)
                told = [f["text"] for f in found if "OPT 6, but neither sheet" in f["text"]]
                self.assertEqual(len(told), 1, [f["text"] for f in found])

    def test_many_alike_findings_are_summed_up_and_none_is_lost(self):
        parts = "".join(f"*PART\nempty {i}\n{i:10d}         1        99\n" for i in range(1000, 1060))
        self.write(lap_joint(("*SECTION_BEAM", parts + "*SECTION_BEAM")))
        run, _, found = self.refused("model.k")
        missing = [f for f in found if f["text"] == "material 99 is not defined"]
        self.assertEqual(len(missing), 60)
        lines = [line for line in run.stderr.splitlines() if "error: *PART mid" in line]
        self.assertEqual(len(lines), 4)
        self.assertRegex(lines[3], r"and 57 more of this kind, at lines \d+(, \d+){7}, \.\.\. \[findings\.json has each\]")
        self.assertIn("60 errors", run.stderr)

    def test_camry_has_2632_weld_beams_and_no_sheet_for_any(self):
        run, welds, found = self.refused(self.shared("decks/camry_roof_crush_includes/Camry_RC_main.k"))
        self.assertEqual(len(welds), 2632)
        self.assertEqual(collections.Counter(w["part"] for w in welds), {"7": 2235, "5000033": 345, "50000002": 52})
        self.assertEqual({(w["kind"], w["tied"], w["sheet1"], w["sheet2"]) for w in welds}, {("beam", "no", "", "")})
        (told,) = [f for f in found if f["text"].startswith("2632 welds, none has a sheet: ")]
        self.assertIn("the deck has no tie contact, and the files Camry_V1_NoSusAndPowerTrain_impl7.k, "
                      "Camry_V1_NoSusAndPowerTrain_impl7_nodes.k, which *INCLUDE names, are not here", told["text"])
        for line in (" welds       2632 beams\n", " diameters   not known (2632)\n",
                     " sections    weld parts 7, 5000033, 50000002 have none in the deck\n",
                     "2632 welds without a warning, but 2632 have no sheet: most checks could not be made"):
            self.assertIn(line, run.stdout)
        self.assertLess(len(run.stderr.splitlines()), 60)
        self.assertLess(len(run.stdout.splitlines()), 100)

    def test_the_fragment_has_brick_welds_of_99_parts_and_no_sheets(self):
        run, welds, found = self.refused(self.shared("decks/hex_weld_fragment/rkrwelds.key"))
        self.assertEqual({(w["kind"], w["tied"]) for w in welds}, {("solid", "no")})
        self.assertEqual(len([f for f in found if "has elements, but no section and no material" in f["text"]]), 99)
        self.assertIn("and 96 more of this kind, at lines ", run.stderr)
        self.assertIn(" 99 *MAT_SPOTWELD that no part uses\n", run.stdout)
        # Bricks of 4.4 mm side: their area is that of a nugget of 5 mm.
        usual = [w for w in welds if abs(float(w["diameter"]) - 5.0) < 0.02]
        self.assertGreater(len(usual), 0.9 * len(welds))

    def test_bumper_beam_has_78_discrete_beams_on_two_sheets_each(self):
        """Refused or accepted: the audit is the same."""
        path = self.shared("decks/bumper_beam/Bumper_Beam_AP_meshed.k")
        self.write("")
        import subprocess
        from nugget_command import NUGGET
        run = subprocess.run([NUGGET, "check", str(path), "-o", "audit"], cwd=self.folder, capture_output=True, text=True, timeout=120)
        self.assertIn(run.returncode, (0, 1), run.stderr)
        text = (self.folder / "audit" / "welds.csv").read_text(encoding="utf-8")
        welds = list(csv.DictReader(io.StringIO(text)))
        self.assertEqual(len(welds), 78)
        self.assertEqual({(w["kind"], w["tied"]) for w in welds}, {("beam", "yes")})
        self.assertTrue(all(w["sheet1"] and w["sheet2"] and w["sheet1"] != w["sheet2"] for w in welds))


if __name__ == "__main__":
    unittest.main()
