# SPDX-License-Identifier: Apache-2.0
"""swforc of every kind of weld that a lap joint can have, and what welds.csv says of each."""
import csv
import io
import math
import unittest

import lsda
from lap_joint import CARDS, deck, edited, mesh
from nugget_command import CommandTest

# Nodes above each other: 106 at (6, 6, 0) of the lower sheet, 206 at (6, 6, 1.2) of the upper one.
NO_BEAM = ("*ELEMENT_BEAM\n" + f"{31:8d}{3:8d}{301:8d}{302:8d}{0:8d}\n", "")


def joined_by(cards):
    """The lap joint with its beam left out and other cards in its place."""
    text = edited(CARDS + mesh() + "*END\n", NO_BEAM, ("*DEFINE_CURVE\n", cards + "*DEFINE_CURVE\n"),
                  ("       0.0       0.9\n", "       0.0       0.1\n"))  # steps much smaller than the times that are compared
    begin = text.index("*PART\nweld")
    text = text[:begin] + text[text.index("*SECTION_SHELL"):]
    begin = text.index("*SECTION_BEAM")
    text = text[:begin] + text[text.index("*SET_PART_LIST"):]
    return "\n".join(line for line in text.splitlines() if line[:8].strip() not in ("301", "302")) + "\n"


def six_kinds():
    """The lap joint with a beam, a brick, an assembly of two, a spotweld, a generalized spot and a rivet, and swforc in both forms. The
    rivet and the spotweld end at 1e-5, the beam's weld is of OPT -2."""
    nodes, bricks, number = [], [], {}
    for z in (0.0, 1.2):
        for y in (1.8, 4.2):
            for x in (1.8, 4.2):
                number["one", x, y, z] = 401 + len(nodes)
                nodes.append((401 + len(nodes), x, y, z))
    for z in (0.0, 1.2):
        for y in (13.8, 16.2):
            for x in (12.8, 15.0, 17.2):
                number["two", x, y, z] = 601 + len(nodes)
                nodes.append((601 + len(nodes), x, y, z))
    for e, part, kind, (a, b), (c, d) in ((501, 4, "one", (1.8, 4.2), (1.8, 4.2)), (511, 5, "two", (12.8, 15.0), (13.8, 16.2)),
                                          (512, 5, "two", (15.0, 17.2), (13.8, 16.2))):
        corners = [number[kind, x, y, z] for z in (0.0, 1.2) for x, y in ((a, c), (b, c), (b, d), (a, d))]
        bricks.append(f"{e:8d}{part:8d}" + "".join(f"{n:8d}" for n in corners))
    ids = lambda *values: "".join(f"{v:>10}" for v in values) + "\n"  # noqa: E731
    cards = "*NODE\n" + "".join(f"{n:8d}{x:16.4f}{y:16.4f}{z:16.4f}\n" for n, x, y, z in nodes)
    cards += "*ELEMENT_SOLID\n" + "\n".join(bricks) + "\n"
    cards += "*PART\none brick\n" + ids(4, 4, 4, 0, 4) + "*PART\ntwo bricks\n" + ids(5, 4, 4, 0, 4) + "*SECTION_SOLID\n" + ids(4, 1)
    cards += "*HOURGLASS\n" + ids(4, 6, 1.0) + "*DEFINE_HEX_SPOTWELD_ASSEMBLY\n" + ids(777) + ids(511, 512)
    cards += "*MAT_SPOTWELD\n" + ids(4, 7.85e-9, 210000.0, 0.3, 500.0, 1000.0) + ids(0.0, 8000.0, 6000.0, 6000.0)
    cards += "*SET_PART_LIST\n" + ids(9) + ids(3, 4, 5)
    cards += "*CONSTRAINED_SPOTWELD_ID\n" + ids(900) + ids(114, 214, 8000.0, 6000.0, 2.0, 2.0, 1e-5)
    cards += "*CONSTRAINED_GENERALIZED_WELD_SPOT_ID\n" + ids(901) + ids(90) + ids(1e20, 0.0, 1e3, 1e3, 2.0, 2.0)
    cards += "*SET_NODE_LIST\n" + ids(90) + ids(103, 203) + "*CONSTRAINED_RIVET_ID\n" + ids(902) + ids(102, 202, 1e-5)
    watched = ("*MAT_SPOTWELD\n         3  7.85e-09  210000.0       0.3     500.0    1000.0\n"
               "       0.0    8000.0    6000.0    6000.0    9000.0    7000.0    7000.0\n")
    return deck(("*DEFINE_CURVE\n", cards + "*DEFINE_CURVE\n"), ("*SPOTWELD\n         3         1         3".replace("*", "*CONTACT_"),
                                                                  "*CONTACT_SPOTWELD\n         9         1         2"),
                ("*DATABASE_SWFORC\n  1.00e-06\n", "*DATABASE_SWFORC\n  2.00e-06         3\n"),
                (watched, watched.replace("SPOTWELD", "SPOTWELD_DAMAGE-FAILURE") + "       0.0      -2.0\n"))


class Swforc(CommandTest):
    def rows(self):
        """[(label, id, axial, shear, time, failure, rest)] of swforc."""
        found = []
        for line in self.read("swforc").splitlines():
            front, label, back = line.partition(" ID ")
            cells = front.split()
            if label and cells[0].isdigit():
                axial, shear, time = map(float, cells[1:4])
                found.append((" ".join(cells[5:]), int(back.split()[0]), axial, shear, time, cells[4], back.split()[1:]))
        return found

    def run_with(self, cards):
        self.write(joined_by(cards))
        self.nugget("run", "model.k", "--quiet")
        (weld,) = csv.DictReader(io.StringIO(self.read("welds.csv")))
        return self.rows(), weld

    def test_a_nodal_rigid_body_between_two_sheets_is_a_weld(self):
        """It moves as a *CONSTRAINED_SPOTWELD that cannot fail, and has the same rows but for its number."""
        spot, weld = self.run_with("*CONSTRAINED_SPOTWELD_ID\n       900\n       106       206\n")
        body, other = self.run_with("*CONSTRAINED_NODAL_RIGID_BODY\n       700         0        90\n*SET_NODE_LIST\n        90\n       106       206\n")
        self.assertEqual({r[:2] for r in spot}, {("constraint/weld", 900)})
        self.assertEqual({r[:2] for r in body}, {("constraint/weld", 700)})
        self.assertEqual([r[2:] for r in spot], [r[2:] for r in body])
        self.assertGreater(max(abs(r[2]) + r[3] for r in spot), 10.0)
        self.assertEqual((other["id"], other["kind"], other["sheet1"], other["sheet2"], other["failed"]), ("700", "rigid", "1", "2", "no"))
        for column in ("peak_axial", "peak_shear", "peak_bending", "length"):
            self.assertEqual(weld[column], other[column], column)

    def test_a_nodal_rigid_body_of_one_sheet_is_none(self):
        self.write(deck(("*DEFINE_CURVE\n", "*CONSTRAINED_NODAL_RIGID_BODY\n       700         0        90\n*SET_NODE_LIST\n        90\n       106       107\n"
                         "*DEFINE_CURVE\n")))
        self.nugget("check", "model.k", "-o", "audit")
        self.assertEqual(len(self.read("audit/welds.csv").splitlines()), 2)

    def test_a_rivet_has_an_axial_force_and_nothing_else(self):
        rows, weld = self.run_with("*CONSTRAINED_RIVET_ID\n       901\n       106       206   1.5e-05\n")
        self.assertEqual({r[:2] for r in rows}, {("constraint/weld", 901)})
        self.assertEqual({r[3] for r in rows}, {0.0})
        self.assertGreater(max(abs(r[2]) for r in rows), 0.0)
        for row in rows:
            self.assertEqual(row[5], "failure" if row[4] > 1.501e-5 else "0.00000", row)
            if row[4] < 1.5e-5:
                self.assertAlmostEqual(float(row[6][0]), 1.2, delta=1e-9)
            elif row[4] > 1.501e-5:
                self.assertEqual(row[2], 0.0)
        self.assertEqual((weld["kind"], weld["failed"], weld["failure_mode"]), ("rigid", "yes", "failure time"))
        self.assertAlmostEqual(float(weld["failure_time"]) / 1.5e-5, 1.0, delta=0.02)
        self.assertIn("rivet failed  id=     901", self.read("run.log"))

    def test_a_leaning_rivet_is_a_finding(self):
        """106 to 207 leans by 6 mm over 1.2 mm."""
        self.write(joined_by("*CONSTRAINED_RIVET\n       106       207\n"))
        self.nugget("check", "model.k", "-o", "audit")
        (told,) = [f for f in self.json("audit/findings.json") if "degrees off the normal" in f["text"]]
        self.assertTrue(told["text"].startswith("rivet 1: its axis is 78.7 degrees off the normal"), told)
        self.assertEqual(told["keyword"], "*CONSTRAINED_RIVET")

    def test_a_rivet_limits_no_time_step(self):
        steps = []
        for cards in ("*CONSTRAINED_RIVET\n       106       206\n", ""):
            self.write(joined_by(cards))
            self.nugget("run", "model.k", "--quiet")
            steps.append(self.json("summary.json")["time_step"]["first"])
        self.assertEqual(*steps)

    def fillet(self, sigy):
        """A fillet along y between 106 and 206 whose throat of 10 x 2 lies in the plane of the sheets."""
        return self.run_with("*DEFINE_COORDINATE_SYSTEM\n         7       0.0       0.0       0.0       1.0       0.0       0.0\n"
                             "       0.0       1.0       0.0\n*SET_NODE_LIST\n        90\n       206       106\n"
                             "*CONSTRAINED_GENERALIZED_WELD_FILLET_ID\n       901\n        90         7\n"
                             f"                    {sigy:10.3f}       0.8      10.0                 2.0       0.0\n")

    def test_a_fillet_weld_has_the_value_of_its_throat(self):
        """beta sqrt(sigma_n^2 + 3 tau^2) / SIGY, out of the two forces of the same row; and no remark meant for spots."""
        rows, weld = self.fillet(250.0)
        self.assertEqual({r[:2] for r in rows}, {("generalized weld", 901)})
        for _, _, axial, shear, _, failure, _ in rows:
            value = 0.8 * math.sqrt(max(axial, 0.0) ** 2 + 3.0 * shear ** 2) / 20.0 / 250.0
            self.assertAlmostEqual(float(failure), value, delta=6e-6)
        self.assertGreater(max(float(r[5]) for r in rows), 1e-3)
        self.assertEqual((weld["id"], weld["kind"], weld["sheet1"], weld["sheet2"], weld["failed"]), ("901", "rigid", "2", "1", "no"))
        self.assertEqual([f for f in self.json("findings.json") if "rigid weld 901" in f["text"]], [])
        weakest = 250.0 * float(weld["peak_failure"])

        rows, weld = self.fillet(0.5 * weakest)
        self.assertEqual((weld["failed"], rows[-1][5]), ("yes", "failure"))
        self.assertIn("between nodes 106 and 206 by ", self.read("run.log"))
        self.assertIn("generalized weld failed  id=     901", self.read("run.log"))
        ends = float(weld["failure_time"])
        self.assertTrue(all(float(r[5]) < 1.0 for r in rows if r[4] < ends))

    def test_damage_of_welds_that_fade(self):
        """RS far beyond what the joint reaches: some damage. A weld without RS has none to tell."""
        card = ("*MAT_SPOTWELD\n         3  7.85e-09  210000.0       0.3     500.0    1000.0\n"
                "       0.0    8000.0    6000.0    6000.0    9000.0    7000.0    7000.0\n")
        soft = ("*MAT_SPOTWELD_DAMAGE-FAILURE\n         3  7.85e-09  210000.0       0.3      10.0    1000.0\n"
                "    1.0e-5\n       0.1       0.0\n")
        self.write(deck((card, soft)))
        self.nugget("run", "model.k", "--quiet")
        (weld,) = csv.DictReader(io.StringIO(self.read("welds.csv")))
        self.assertTrue(0.0 < float(weld["damage"]) < 1.0, weld["damage"])
        self.write(deck())
        self.nugget("run", "model.k", "--quiet")
        (weld,) = csv.DictReader(io.StringIO(self.read("welds.csv")))
        self.assertEqual(weld["damage"], "")

    def test_damage_over_time(self):
        """DMGOPT 2 with RS of five times the run's length: the mean of the points is less than a fifth at its end."""
        card = ("*MAT_SPOTWELD\n         3  7.85e-09  210000.0       0.3     500.0    1000.0\n"
                "       0.0    8000.0    6000.0    6000.0    9000.0    7000.0    7000.0\n")
        soft = ("*MAT_SPOTWELD_DAMAGE-FAILURE\n         3  7.85e-09  210000.0       0.3      10.0    1000.0\n"
                "    1.0e-5\n   1.0e-04       0.0       0.0       0.0         0       0.0       0.0       2.0\n")
        self.write(deck((card, soft)))
        self.nugget("run", "model.k", "--quiet")
        (weld,) = csv.DictReader(io.StringIO(self.read("welds.csv")))
        self.assertTrue(0.0 < float(weld["damage"]) < 0.2, weld["damage"])

    def test_every_kind_in_both_files(self):
        self.write(six_kinds())
        self.nugget("run", "model.k", "--quiet")
        rows = self.rows()
        self.assertEqual([r[:2] for r in rows[:6]],
                         [("spotweld beam", 31), ("spotweld solid", 501), ("spotweld assmy", 777), ("constraint/weld", 900),
                          ("generalized weld", 901), ("constraint/weld", 902)])
        self.assertEqual(len(rows) % 6, 0)
        self.assertEqual(rows[-3][5], "failure")
        self.assertRegex(self.read("swforc"), r"spotweld beam  ID +31 .* fcmx=\S{7} t=\S{8}\n")

        binary = lsda.read(self.folder / "binout0000")
        self.assertEqual(binary["swforc/metadata/typenames"], "constraint,weld,beam,solid,non nodal, ,solid assembly")
        self.assertEqual(binary["swforc/metadata/ids"], [31, 501, 777, 900, 901, 902])
        self.assertEqual(binary["swforc/metadata/types"], [2, 3, 6, 0, 1, 0])
        states = lsda.states(binary, "swforc")
        self.assertEqual(len(states), len(rows) // 6)
        for i, state in enumerate(states):
            for k, (_, _, axial, shear, time, failure, rest) in enumerate(rows[6 * i:6 * i + 6]):
                self.assertAlmostEqual(state["time"][0], time, delta=1e-5 * time)
                self.assertAlmostEqual(state["axial"][k], axial, delta=1e-5 * abs(axial) + 1e-12)
                self.assertAlmostEqual(state["shear"][k], shear, delta=1e-5 * abs(shear) + 1e-12)
                self.assertEqual(failure == "failure", state["failure_time"][k] > 0.0)
                if k < 3:  # length, moment, torsion
                    for name, text in zip(("length", "resultant_moment", "torsion"), rest):
                        self.assertAlmostEqual(state[name][k], float(text), delta=1e-5 * abs(float(text)) + 1e-12, msg=name)
        self.assertGreater(states[-1]["max_failure"][0], 0.0)
        welds = {w["id"]: w for w in csv.DictReader(io.StringIO(self.read("welds.csv")))}
        self.assertEqual(list(welds), ["31", "501", "777", "900", "901", "902"])
        spot, held, rivet = (welds[i] for i in ("900", "901", "902"))
        self.assertEqual((spot["failed"], spot["failure_mode"], held["failed"]), ("yes", "failure time", "no"))
        for weld in (spot, held):  # both terms have the exponent 2
            normal, shear = (8000.0, 6000.0) if weld is spot else (1000.0, 1000.0)
            value = (max(float(weld["last_axial"]), 0.0) / normal) ** 2 + (float(weld["last_shear"]) / shear) ** 2
            self.assertGreater(value, 0.0)
            self.assertAlmostEqual(float(weld["last_failure"]) / value, 1.0, 9)
            self.assertGreaterEqual(float(weld["peak_failure"]), value)
            self.assertIn("shear force", weld["last_terms"])
            self.assertEqual((weld["last_strain_rate"], weld["energy"]), ("", ""))
        self.assertEqual((rivet["last_shear"], rivet["peak_failure"], rivet["energy"]), ("", "", ""))

    def test_resultant_force_where_it_is_asked_for(self):
        """OPTION1 = 1: sqrt(axial^2 + shear^2) of each weld, in swforc, binout and welds.csv; without it LS-DYNA's own columns."""
        self.write(edited(six_kinds(), ("*DATABASE_SWFORC\n  2.00e-06         3\n", "*DATABASE_SWFORC\n  2.00e-06         3         0         0       1.0\n")))
        self.nugget("run", "model.k", "--quiet")
        rows = self.rows()
        states = lsda.states(lsda.read(self.folder / "binout0000"), "swforc")
        largest = {}
        for i, (_, weld, axial, shear, _, failure, _) in enumerate(rows):
            if failure != "failure":
                self.assertGreaterEqual(float(failure), 0.0)  # Python's own reader takes it
            force = states[i // 6]["resultant_force"][i % 6]
            self.assertAlmostEqual(force, math.hypot(axial, shear), delta=2e-5 * force + 1e-9)
            largest[weld] = max(largest.get(weld, 0.0), force)
        told = [float(line.split("fres=")[1]) for line in self.read("swforc").splitlines() if "fres=" in line]
        self.assertEqual(len(told), len(rows))
        for force, row in zip(told, rows):
            self.assertAlmostEqual(force, math.hypot(row[2], row[3]), delta=2e-5 * force + 1e-9)
        for weld in csv.DictReader(io.StringIO(self.read("welds.csv"))):
            peak = {name: float(weld[f"peak_{name}"]) for name in ("axial", "shear", "force")}
            self.assertGreaterEqual(peak["force"], max(largest[int(weld["id"])], peak["axial"], peak["shear"]) * (1.0 - 1e-5))
            self.assertLessEqual(peak["force"], math.hypot(peak["axial"], peak["shear"]) * (1.0 + 1e-9))
            if weld["last_shear"]:
                self.assertAlmostEqual(float(weld["last_force"]), math.hypot(float(weld["last_axial"]), float(weld["last_shear"])), delta=1e-6)
        self.assertIn("<th>resultant [N]</th>", self.read("report.html"))
        self.assertEqual(self.nugget("check", "model.k").stderr.count("this additional output is not written"), 0)

        self.write(six_kinds())
        self.nugget("run", "model.k", "--quiet")
        self.assertNotIn("fres=", self.read("swforc"))
        self.assertNotIn("resultant_force", lsda.states(lsda.read(self.folder / "binout0000"), "swforc")[0])

    def test_moments_at_both_sheets(self):
        """Pulled along x the weld is sheared in a plane: the moments at its ends are that at mid-length and half its length times the shear
        force, added and taken off."""
        self.write(deck())
        self.nugget("run", "model.k", "--quiet")
        (weld,) = csv.DictReader(io.StringIO(self.read("welds.csv")))
        middle, lever = float(weld["last_bending"]), 0.5 * 1.2 * float(weld["last_shear"])
        ends = sorted((float(weld["last_bending_1"]), float(weld["last_bending_2"])))
        self.assertAlmostEqual(ends[0] / abs(middle - lever), 1.0, delta=1e-3)
        self.assertAlmostEqual(ends[1] / (middle + lever), 1.0, delta=1e-3)

    def test_a_refused_failure_function_is_told_once(self):
        card = ("*MAT_SPOTWELD\n         3  7.85e-09  210000.0       0.3     500.0    1000.0\n"
                "       0.0    8000.0    6000.0    6000.0    9000.0    7000.0    7000.0\n")
        self.write(deck((card, card.replace("SPOTWELD", "SPOTWELD_DAMAGE-FAILURE") + "       0.0       9.0\n")))
        self.nugget("check", "model.k", "-o", "audit", expect=1)
        (error,) = [f for f in self.json("audit/findings.json") if f["severity"] == "error"]
        self.assertIn("OPT 9 (*DEFINE_SPOTWELD_RUPTURE_PARAMETER)", error["text"])


if __name__ == "__main__":
    unittest.main()
