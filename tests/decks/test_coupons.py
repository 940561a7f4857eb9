# SPDX-License-Identifier: Apache-2.0
"""The coupons of examples/coupons against three-dimensional models of solids. On elements as
large as the weld: tests/verify/test_coupons.cpp.

Sabotage that this catches: a weld that hands over no moment (peel goes soft), bricks of another cross-section than the beam they replace,
a failure function that sees the grip's force instead of the weld's, shells that yield at another force than solids do.
"""
import pathlib
import sys
import tempfile
import unittest

from nugget_command import NUGGET, SOURCE

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


if __name__ == "__main__":
    unittest.main()
