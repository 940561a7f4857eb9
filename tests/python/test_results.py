# SPDX-License-Identifier: Apache-2.0
"""nugget.results(): what the module reads, against the files' own text, VTK's reader of d3plot, and closed forms."""
import csv
import math
import unittest

import numpy as np
import nugget
from lap_joint import deck
from nugget_command import CommandTest
from test_responses import frf, strip

FAILS = ("    8000.0    6000.0    6000.0", "    8000.0     600.0     600.0")  # its shear strength

EIGENVALUES = "*CONTROL_IMPLICIT_EIGENVALUE\n         5\n"


class Results(CommandTest):
    def run_deck(self, *changes):
        self.write(deck(*changes))
        self.nugget("run", "model.k", "-o", "out", "--quiet")
        return nugget.results(self.folder / "out")

    def cells(self, name):
        with open(self.folder / "out" / name, newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def test_summary_and_findings(self):
        r = self.run_deck()
        self.assertEqual(r.summary, self.json("out/summary.json"))
        self.assertEqual((r.termination, r.units, r.second), ("normal", "mm, t, s", 1.0))
        findings = self.json("out/findings.json")
        self.assertEqual([(f.line, f.severity, f.keyword, f.text) for f in r.findings],
                         [(f["line"], f["severity"], f["keyword"], f["text"]) for f in findings])
        self.assertIn("model.k:48:1: note: *CONTACT_SPOTWELD 1: 2 nodes tied", str(r.findings[0]))

    def test_welds_are_the_cells_of_welds_csv(self):
        r = self.run_deck(FAILS)
        row, = self.cells("welds.csv")
        self.assertEqual(r.welds.count, 1)
        for name in ("peak_shear", "failure_time", "energy", "diameter", "time_step"):
            self.assertEqual(r.welds[name].tolist(), [float(row[name])], name)
        self.assertEqual((row["tied"], row["failed"], row["pitch_ratio"]), ("yes", "yes", ""))
        self.assertEqual((r.welds["tied"].tolist(), r.welds["failed"].tolist()), ([True], [True]))
        self.assertTrue(np.isnan(r.welds["pitch_ratio"][0]))
        self.assertEqual(r.welds["parts"][0], (1, 2))
        self.assertEqual(r.welds["failure_course"][0].tolist(), [float(v) for v in row["failure_course"].split()])
        self.assertEqual(r.welds[31]["remarks"], row["remarks"])
        with self.assertRaisesRegex(LookupError, "there is no weld 32"):
            r.welds[32]
        with self.assertRaisesRegex(LookupError, "no column 'strength'; there are: id, kind, "):
            r.welds["strength"]

    def test_histories_are_the_numbers_of_their_text(self):
        r = self.run_deck()
        self.assertEqual(r.histories, ["glstat", "matsum", "nodout", "swforc"])
        glstat = r.history("glstat")
        text = self.glstat("out/glstat")
        self.assertEqual(len(glstat.times), len(text))
        for label in ("kinetic energy", "internal energy", "total energy"):
            values = [state[label + "."] if label + "." in state else state[label] for state in text]
            np.testing.assert_allclose(glstat[label.replace(" ", "_")], values, rtol=1e-5)
        self.assertEqual(glstat.unit("internal_energy"), "N mm")
        swforc = r.history("swforc")
        self.assertEqual(swforc.entities, ["weld 31"])
        self.assertEqual(swforc[31, "shear"].tolist(), swforc["weld 31", "shear"].tolist())
        # swforc samples the force, welds.csv has the largest of all cycles, which here is the last one.
        self.assertAlmostEqual(swforc[31, "shear"].max() / float(self.cells("welds.csv")[0]["peak_shear"]), 1.0, 3)
        of_parts = r.history("matsum").of_all("internal_energy")
        self.assertEqual(of_parts.shape, (5, 3))
        np.testing.assert_allclose(of_parts.sum(axis=1), glstat["internal_energy"], rtol=1e-4)
        self.assertEqual(r.history("matsum")["upper sheet", "internal_energy"].tolist(), of_parts[:, 1].tolist())

    def test_what_is_not_there_is_refused_by_name(self):
        r = self.run_deck()
        swforc = r.history("swforc")
        for what, text in ((lambda: r.history("elout"), r"no history 'elout' .*there are: glstat, .* \[\*DATABASE_ELOUT"),
                           (lambda: swforc[32, "axial"], "no entity '32'; there are: weld 31"),
                           (lambda: swforc[31, "force"], "no quantity 'force'; there are: axial, "),
                           (lambda: r.history("matsum")["mass"], r"mass of 3 entities: give one, as in \[1, 'mass'\]"),
                           (r.modes, r"no d3eigv \[`nugget modes`"), (r.frf, "no frf.csv"),
                           (lambda: r.states().node(7), "there is no node 7")):
            with self.assertRaisesRegex(LookupError, text):
                what()
        with self.assertRaisesRegex(FileNotFoundError, "nowhere holds no results of a run"):
            nugget.results(self.folder / "nowhere")

    def test_states_are_those_that_vtk_reads(self):
        r = self.run_deck(FAILS)
        states, seen = r.states(), self.d3plot("out")
        np.testing.assert_allclose(states.times, [state["time"] for state in seen["states"]], rtol=1e-6)
        self.assertEqual((len(states.node_ids), len(states.shells), len(states.beams)), (34, 18, 1))
        self.assertEqual(states.shells.nodes[states.shells.index(14)].tolist(), [106, 107, 111, 110])
        self.assertEqual(states.parts, {1: "lower sheet", 2: "upper sheet", 3: "weld"})
        blocks = {block["name"]: block for block in seen["states"][-1]["blocks"]}
        last = states[-1]
        for part, name in ((1, "lower sheet"), (2, "upper sheet")):
            arrays, block = blocks[name]["cell_arrays"], states.shells.parts == part
            self.assertEqual(states.shells.ids[block].tolist(), [u for (u,) in arrays["UserIds"]])
            np.testing.assert_allclose(last.shells.thickness[block], [t for (t,) in arrays["Thickness"]], rtol=1e-6)
            stresses = [array for title, array in arrays.items() if title.startswith("Stress")]
            self.assertEqual(len(stresses), 3, sorted(arrays))
            for layer in range(3):
                self.assertTrue(any(np.allclose(last.shells.stress[block, layer], stress, rtol=1e-6, atol=1e-6)
                                    for stress in stresses), layer)
            for (i, point) in enumerate(blocks[name]["points"]):
                place = int(np.argmin(np.abs(states.coordinates - point).sum(axis=1)))
                np.testing.assert_allclose(last.displacement[place],
                                           blocks[name]["point_arrays"]["Deflection"][i], atol=1e-6)
        self.assertGreater(np.abs(last.shells.stress).max(), 1.0)
        self.assertEqual((states[0].beams.deleted.tolist(), last.beams.deleted.tolist()), ([False], [True]))
        self.assertEqual(states.at(9e-6).time, states.times[2])
        self.assertEqual([s.time for s in states[1:3]], states.times[1:3].tolist())
        with self.assertRaisesRegex(IndexError, "no state 9"):
            states[9]

    def test_modes_of_a_cantilever(self):
        self.write(strip(lambda tip: EIGENVALUES))
        self.nugget("modes", "model.k", "-n", 3, "-o", "out")
        modes = nugget.results(self.folder / "out").modes()
        # A beam 200 long, 2 thick: f = 1.8751^2 / (2 pi l^2) sqrt(E t^2 / (12 rho)).
        closed = 1.8751 ** 2 / (2.0 * math.pi * 200.0 ** 2) * math.sqrt(210000.0 * 4.0 / (12.0 * 7.85e-9))
        self.assertAlmostEqual(modes.frequencies[0] / closed, 1.0, delta=0.01)
        self.assertEqual(modes.shapes.shape, (3, 81 * 9, 3))
        along = modes.coordinates[:, 0]
        shape = modes.shapes[0][:, 2]
        middle, tip = shape[np.isclose(along, 100.0)].mean(), shape[np.isclose(along, 200.0)].mean()
        self.assertAlmostEqual(middle / tip, 0.3395, delta=0.003)
        self.assertAlmostEqual(np.abs(modes.shapes[:, np.isclose(along, 0.0)]).max(), 0.0, 6)
        self.assertEqual(modes.effective_mass.shape, (3, 6))

    def test_frequency_response_is_that_of_frf_csv(self):
        self.write(strip(lambda tip: EIGENVALUES + frf((tip, 0, 3, 3), (0.02,), (tip, 0, 3, 2), (5.0, 200.0, 40))))
        self.nugget("frf", "model.k", "-o", "out")
        response, = nugget.results(self.folder / "out").frf()
        rows = self.cells("frf.csv")
        self.assertEqual((response.name, response.quantity), (f"node {rows[0]['node']} {rows[0]['direction']}",
                                                              rows[0]["response"]))
        self.assertEqual(response.frequencies.tolist(), [float(row["frequency"]) for row in rows])
        self.assertEqual(response.values.real.tolist(), [float(row["real"]) for row in rows])
        np.testing.assert_allclose(np.abs(response.values), response.amplitude, rtol=1e-7)
        np.testing.assert_allclose(np.degrees(np.angle(response.values)), response.phase, atol=1e-6)

    def test_filter_is_that_of_the_norm(self):
        times = np.arange(0.0, 0.5, 1e-5)
        inner = slice(10000, 40000)
        for frequency, gain in ((10.0, 1.0), (100.0, 10.0 ** (-3.0 / 20.0)), (1000.0, 0.0)):
            at, values = nugget.sae_filter(times, np.sin(2.0 * np.pi * frequency * times), 60, 1.0)
            self.assertEqual(len(at), len(times))
            self.assertAlmostEqual(np.abs(values[inner]).max(), gain, delta=0.01, msg=frequency)
        at, values = nugget.sae_filter(1e3 * times, np.sin(2.0 * np.pi * 100.0 * times), 60, 1e3)  # in ms
        self.assertAlmostEqual(np.abs(values[inner]).max(), 10.0 ** (-3.0 / 20.0), delta=0.01)
        with self.assertRaisesRegex(ValueError, "61, expected 60, 180, 600, 1000"):
            nugget.sae_filter(times, times, 61, 1.0)


if __name__ == "__main__":
    unittest.main()
