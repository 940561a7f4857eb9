# SPDX-License-Identifier: Apache-2.0
"""*CONSTRAINED_INTERPOLATION_SPOTWELD: what a user gets of check, run and modes, on any number of threads and after a restart."""
import csv
import io
import math
import unittest

import lsda
from lap_joint import edited
from nugget_command import CommandTest
from repeated_runs import RepeatedRuns
from test_statics import LINEAR
from test_swforc import joined_by

MODES = "*CONTROL_IMPLICIT_GENERAL\n         1       1.0\n*CONTROL_IMPLICIT_EIGENVALUE\n         8\n"


def fields(*values):
    return "".join(f"{v:>10}" for v in values) + "\n"


def curve(number, *points):
    return "*DEFINE_CURVE\n" + fields(number) + "".join(f"{x:20}{y:20}\n" for x, y in points)


def spr3(strength=6000.0, last=(1,), head=None, begins=0.001):
    """The lap joint with one weld at (9, 9) in place of its beam."""
    cards = (f"*NODE\n{401:8d}{9.0:16.4f}{9.0:16.4f}{0.6:16.4f}\n*SET_NODE_LIST\n" + fields(77) + fields(401)
             + "*CONSTRAINED_INTERPOLATION_SPOTWELD\n" + (head or fields(1, 2, 77, 2.4, 3.0, 1e5, 0.2, *last))
             + fields(1.2, 1.0, 2.0, 71, 72, 73, 7.85e-9) + fields(0, 5e5, 5e5)
             + curve(71, (0.0, strength), (1.0, strength)) + curve(72, (0.0, begins), (1.0, begins))
             + curve(73, (0.0, 2 * begins), (1.0, 2 * begins)))
    return joined_by(cards)


class InterpolationSpotwelds(CommandTest):
    def row(self, folder):
        return next(csv.DictReader(io.StringIO(self.read(f"{folder}/welds.csv"))))

    def test_holds_and_is_reported(self):
        self.write(edited(spr3(), ("*DATABASE_SWFORC\n  1.00e-06\n", "*DATABASE_SWFORC\n  1.00e-06         3\n")))
        check = self.nugget("check", "model.k", "-o", "check")
        self.assertIn("1 interpolation spot weld", check.stdout)
        self.assertIn("1 weld, with the ids of the location nodes: beam 401 of part 3, with nodes 402 to 403, made for it", check.stderr)
        self.assertNotIn("belongs to no element", check.stderr)
        self.assertGreater(float(self.row("check")["hold_by_area"]), 0.5)
        self.nugget("run", "model.k", "-o", "out")
        row = self.row("out")
        self.assertEqual((row["id"], row["sheet1"], row["sheet2"], row["tied"]), ("401", "1", "2", "yes"))
        self.assertEqual(float(row["diameter"]), 6.0)
        self.assertGreater(float(row["peak_shear"]), 100.0)
        lines = [line for line in self.read("out/swforc").splitlines() if "nonnodal cnst  ID        401" in line]
        self.assertGreater(len(lines), 10)
        self.assertAlmostEqual(max(float(line.split()[2]) for line in lines) / float(row["peak_shear"]), 1.0, delta=0.2)
        states = lsda.read(self.folder / "out/binout0000")
        self.assertEqual(list(states["swforc/metadata/types"]), [4])
        self.assertIn("of *CONSTRAINED_INTERPOLATION_SPOTWELD among them: 1", self.read("out/run.log"))

    def test_breaks(self):
        self.write(spr3(strength=200.0, begins=1e-4))
        self.nugget("run", "model.k", "-o", "out")
        row = self.row("out")
        self.assertTrue(row["failure_mode"].startswith("rupture at mode mixity"), row)
        self.assertEqual(float(row["damage"]), 1.0)
        self.assertGreater(float(row["failure_time"]), 0.0)
        self.assertIn("interpolation spot weld failed  id=     401", self.read("out/run.log"))
        self.assertLess(float(row["peak_shear"]), 200.1)

    def test_modes_know_its_stiffness(self):
        first = []
        for name, stiff in (("stiff", 1e5), ("soft", 1e2)):
            head = fields(1, 2, 77, 2.4, 3.0, stiff, 0.2, 1)
            self.write(edited(spr3(head=head), ("*TITLE\n", MODES + "*TITLE\n")), f"{name}.k")
            self.nugget("modes", f"{name}.k", "-o", name, "-n", "4")
            first.append(self.json(f"{name}/summary.json")["modes"][0]["frequency_hz"])
        self.assertGreater(first[0], 1.05 * first[1])

    def test_statics_knows_its_force(self):
        """All of the pull goes through the one weld: its force is the reaction. Sabotage: no force, shown as 0."""
        self.write(edited(spr3(), ("*TITLE\n", LINEAR + "*TITLE\n"), ("         2         1         0         1\n",
                                                                      "         2         1         2         1    1.0e-05\n")))
        self.nugget("run", "model.k", "-o", "out", "--quiet")
        held = [line for line in self.read("out/run.log").splitlines() if "forces of supports" in line][0].split()
        force = math.hypot(*map(float, held[3:6]))
        row = self.row("out")
        self.assertGreater(force, 1.0)
        self.assertAlmostEqual(float(row["peak_force"]) / force, 1.0, delta=1e-6)
        self.assertEqual((row["peak_failure"], row["last_failure"]), ("", ""))
        (line,) = {line for line in self.read("out/swforc").splitlines() if "nonnodal cnst  ID        401" in line and "1.00000E-05" not in line[:12]
                   and float(line.split()[3]) > 0.0}
        self.assertAlmostEqual(math.hypot(*map(float, line.split()[1:3])) / force, 1.0, delta=1e-5)

    def test_parameters_as_functions(self):
        """MODEL 11: functions of both sheets whose values by hand are those of a card of MODEL 1: the same run. The sheets are 1.2 thick, yield
        at 300 with a tangent modulus of 1000 and neck at the hardening modulus H = E Et / (E - Et), at H exp(-(1 - 300/H) - H/E).
        Sabotage: yield and strength, or thickness and area, in each other's place."""
        hardening = 210000.0 * 1000.0 / (210000.0 - 1000.0)
        necking = hardening * math.exp(-(1.0 - 300.0 / hardening) - hardening / 210000.0)
        yields = 300.0 + 0.002 * hardening

        def text(model, stiff, alpha, rn, rs, beta, more=""):
            head = fields(1, 2, 77, 2.4, 3.0, stiff, alpha, model)
            return edited(spr3(strength=200.0, begins=1e-4, head=head),
                          (fields(1.2, 1.0, 2.0, 71, 72, 73, 7.85e-9), fields(rn, rs, beta, 71, 72, 73, 7.85e-9)), ("*END", more + "*END"))
        names = "(t1,t2,sy1,sy2,sm1,sm2,r,a,e1,e2)"
        functions = "".join(f"*DEFINE_FUNCTION\n{number:10}\nf{names}={value}\n" for number, value in (
            (51, "e1*a/(30.0*(t1+t2))"), (52, "0.1*t1+0.05*e2/e1"), (53, "1.2*sy1/sy2*sm2/500.0"), (54, "min(sy1,sy2)/300.0"), (55, "1.0+t2")))
        area = math.pi * 9.0
        self.write(text(1, f"{210000.0 * area / 72.0:.3f}", 0.17, f"{1.2 * necking / 500.0:.7f}", f"{yields / 300.0:.7f}", 2.2), "numbers.k")
        self.write(text(11, 51, 52, 53, 54, 55, functions), "functions.k")
        rows = []
        for name in ("numbers", "functions"):
            self.nugget("run", f"{name}.k", "-o", name, "--quiet")
            rows.append(self.row(name))
        self.assertTrue(rows[0]["failure_mode"].startswith("rupture at mode mixity"), rows[0])
        for column in ("peak_shear", "peak_axial", "failure_time", "energy"):
            self.assertAlmostEqual(float(rows[1][column]) / float(rows[0][column]), 1.0, delta=2e-3, msg=column)
        for wrong, told in (("(t2,t1)=t1", "its arguments are (t2, t1)"), (f"{names}=r", "it asks for r"),
                            (f"{names}=-1.0", "it gives -1 for these sheets")):
            self.write(text(11, 51, 52, 53, 54, 55, functions.replace(f"{names}=min(sy1,sy2)/300.0", wrong)), "wrong.k")
            self.assertIn(f"rs = 54: {told}", self.nugget("check", "wrong.k", expect=1).stderr)

    def test_what_is_refused(self):
        self.write(spr3(last=(2,)))
        run = self.nugget("run", "model.k", "-o", "out", expect=1)
        self.assertIn("CONSTRAINED_INTERPOLATION_SPOTWELD model = 2: SPR4 is not built; expected 1, 3 or 11", run.stderr)

    def test_sheet_out_of_reach(self):
        self.write(spr3(head=fields(1, 2, 77, 0.5, 3.0, 1e5, 0.2)))
        """The deck's SPOTSTP is 1."""
        run = self.nugget("check", "model.k", "-o", "out", expect=1)
        self.assertIn("*CONSTRAINED_INTERPOLATION_SPOTWELD: interpolation spot weld 401: node 402", run.stderr)
        self.assertIn("is 0.6 away, tolerance 0.5", run.stderr)


class RepeatedJoints(RepeatedRuns):
    def test_any_number_of_threads(self):
        self.compare(self.write(spr3(strength=300.0)))

    def test_resumed_while_damaged(self):
        self.resumed(spr3(strength=300.0), shares=(0.5,))


if __name__ == "__main__":
    unittest.main()
