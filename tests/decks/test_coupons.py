# SPDX-License-Identifier: Apache-2.0
"""The coupons of examples/coupons against three-dimensional models of solids. On elements as
large as the weld: tests/verify/test_coupons.cpp.

Sabotage that this catches: a weld that hands over no moment (peel goes soft), bricks of another cross-section than the beam they replace,
a failure function that sees the grip's force instead of the weld's, shells that yield at another force than solids do.
"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

from nugget_command import NUGGET, SOURCE, CommandTest

sys.path.insert(0, str(SOURCE / "examples" / "coupons"))
import study  # noqa: E402


class Coupons(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)

    def run_all(self, *names):
        return study.run(NUGGET, pathlib.Path(self.folder.name), names)

    def test_elastic_stiffness(self):
        gates = {"lap": 0.05, "peel": 0.20, "cross": 0.20}
        curves = self.run_all(*[f"{kind}_elastic" for kind in gates])
        for kind, gate in gates.items():
            self.assertAlmostEqual(curves[f"{kind}_elastic"].stiffness() / study.SOLIDS[kind][2], 1.0, delta=gate, msg=kind)

    def test_plastic_lap_shear(self):
        reference, work, _ = study.SOLIDS["lap"]
        curve = self.run_all("lap_beam")["lap_beam"]
        for u, force in reference:
            if u > 0.2:
                self.assertAlmostEqual(curve.force(u) / force, 1.0, delta=0.10, msg=u)
        self.assertAlmostEqual(curve.work(reference[-1][0]) / work, 1.0, delta=0.08)

    def test_plastic_lap_shear_with_a_square_nugget(self):
        curve = self.run_all("lap_patch")["lap_patch"]
        for u, force in study.SQUARE:
            self.assertAlmostEqual(curve.force(u) / force, 1.0, delta=0.03, msg=u)

    def test_work_of_peel_and_cross_tension(self):
        for name, curve in self.run_all("peel_beam", "cross_beam").items():
            reference, work, _ = study.SOLIDS[name.split("_")[0]]
            self.assertAlmostEqual(curve.work(reference[-1][0]) / work, 1.0, delta=0.20, msg=name)

    def test_weld_fails_by_the_force_in_the_grip(self):
        curves = self.run_all("lap_fails", "peel_fails")
        self.assertAlmostEqual(curves["lap_fails"].force_at_failure() / 9000.0, 1.0, delta=0.05)
        self.assertAlmostEqual(curves["peel_fails"].force_at_failure() / 800.0, 1.0, delta=0.05)
        self.assertEqual([curves[n].weld["failure_mode"] for n in ("lap_fails", "peel_fails")], ["shear force", "axial force"])

    def test_bricks_start_as_stiff_as_the_solids(self):
        u, force = study.SOLIDS["lap"][0][0]
        for name, curve in self.run_all("lap_1", "lap_4", "lap_8").items():
            self.assertAlmostEqual(curve.force(u) / force, 1.0, delta=0.05, msg=name)


class WeldPlacement(CommandTest):
    """examples/weld_placement/compare.py on the coupon as `nugget weld` makes it of sheets and a point."""

    def compared(self, *cases):
        run = subprocess.run([sys.executable, str(SOURCE / "examples" / "weld_placement" / "compare.py"), str(self.folder), *cases],
                             capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stderr)
        return {line.split()[0]: line.split()[1:] for line in run.stdout.splitlines() if line.split()[0] in cases}

    def test_beams_and_bricks_side_by_side(self):
        """Over the centre of an element all are within 5 % of the solid model: 62.5 kN/mm, as the talk's coupon study has it."""
        subprocess.run([sys.executable, str(SOURCE / "examples" / "weld_placement" / "make.py"), str(self.folder)], check=True)
        forms = ("beam", "solid", "solid4", "solid8")
        for form in forms:
            self.nugget("weld", "placed/points.csv", "placed/sheets.k", "-o", f"{form}.k", "--as", form)
            self.nugget("run", f"{form}.k", "-o", form, "--until", 6e-4, "--quiet")
        rows = self.compared(*forms)
        self.assertEqual(set(rows), set(forms))
        for form, (stiffness, share, *_, failure) in rows.items():
            self.assertAlmostEqual(float(stiffness) / 62.5, 1.0, delta=0.05, msg=form)
            self.assertAlmostEqual(float(share), 100.0, delta=5.0, msg=form)
            self.assertEqual(failure, "none")
        self.assertEqual(len({line.split(",")[0] for line in self.read("histories.csv").splitlines()}), 1 + len(forms))

    def test_a_run_too_short_for_a_stiffness_has_none(self):
        subprocess.run([sys.executable, str(SOURCE / "examples" / "weld_placement" / "make.py"), str(self.folder)], check=True)
        self.nugget("run", "centre.k", "-o", "centre", "--until", 2e-5, "--quiet")
        self.assertEqual(self.compared("centre")["centre"][:2], ["none", "none"])


if __name__ == "__main__":
    unittest.main()
