# SPDX-License-Identifier: Apache-2.0
"""Responses over frequency by the command: `nugget frf` by modes and directly, harmonic loads (SSD), files and the page."""
import csv
import math
import unittest

from nugget_command import CommandTest
from test_report import Page

HALF_DECIBEL = 1.0 - 10.0 ** (-1.0 / 40.0)


def fields(*values):
    return "".join(f"{v:>10}" if isinstance(v, str) else f"{v:10.7g}" for v in values) + "\n"


def sheet(length, width, thickness, along, across, young, nu, density, cards, supports):
    """A sheet of shells in the plane z = 0; node(i, j) = 1 + (along + 1) j + i. Supports: freedoms by list of nodes."""
    text = "*KEYWORD\n*CONTROL_TERMINATION\n" + fields(1.0) + "*CONTROL_IMPLICIT_GENERAL\n" + fields(1, 1.0)
    text += "*PART\nsheet\n" + fields(1, 1, 1) + "*SECTION_SHELL\n" + fields(1, 16, 0.833333, 3) + fields(*4 * (thickness,))
    text += "*MAT_ELASTIC\n" + fields(1, f"{density:.4g}", f"{young:.4g}", nu) + cards
    for number, (freedoms, nodes) in enumerate(supports, 101):
        text += "*SET_NODE_LIST\n" + fields(number)
        for k in range(0, len(nodes), 8):
            text += fields(*nodes[k:k + 8])
        text += "*BOUNDARY_SPC_SET\n" + fields(number, 0, *freedoms)
    text += "*NODE\n"
    for j in range(across + 1):
        for i in range(along + 1):
            text += f"{1 + (along + 1) * j + i:8d}{length * i / along:16.8g}{width * j / across:16.8g}{0.0:16.8g}\n"
    text += "*ELEMENT_SHELL\n"
    for j in range(across):
        for i in range(along):
            a = 1 + (along + 1) * j + i
            text += f"{1 + along * j + i:8d}{1:8d}{a:8d}{a + 1:8d}{a + along + 2:8d}{a + along + 1:8d}\n"
    return text + "*END\n"


def strip(cards, along=80, across=8):
    """The cantilever of A-54; its tip is the node in the middle of the free edge."""
    clamped = [1 + (along + 1) * j for j in range(across + 1)]
    tip = 1 + (along + 1) * (across // 2) + along
    return sheet(200.0, 20.0, 2.0, along, across, 210000.0, 0.3, 7.85e-9, cards(tip), [((1,) * 6, clamped)])


def frf(excitation, damping, response, frequencies):
    return "*FREQUENCY_DOMAIN_FRF\n" + fields(*excitation) + fields(*damping) + fields(*response) + fields(*frequencies)


class Responses(CommandTest):
    def rows(self, name):
        with open(self.folder / name, newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def amplitudes(self, name):
        return {float(row["frequency"]): float(row["amplitude"]) for row in self.rows(name)}

    def test_tip_of_a_cantilever(self):
        """A-60: eight modes of Euler's beam; half a decibel."""
        def over(*frequencies):
            return strip(lambda tip: "*CONTROL_IMPLICIT_EIGENVALUE\n" + fields(5) +
                         frf((tip, 0, 3, 3), (0.02,), (tip, 0, 3, 2), frequencies))
        self.write(over(0.0, 300.0, 16))
        self.nugget("frf", "model.k", "-o", "wide", "--quiet")
        first, second = (mode["frequency_hz"] for mode in self.json("wide/summary.json")["modes"][:2])
        self.write(over(f"{first:.7g}", f"{second:.7g}", 2), "model.k")
        self.nugget("frf", "model.k", "-o", "peaks", "--quiet")
        wide, peaks = self.amplitudes("wide/frf.csv"), self.amplitudes("peaks/frf.csv")
        at_first, at_second = (peaks[f] for f in sorted(peaks))
        for found, expected in ((wide[0.0], 0.952305), (wide[20.0], 1.22696), (at_first, 23.1118), (wide[100.0], 0.163517),
                                (at_second, 0.589014)):
            self.assertAlmostEqual(found / expected, 1.0, delta=HALF_DECIBEL)
        # LS-DYNA's files hold the same curve.
        lines = self.read("wide/frf_amplitude").splitlines()
        self.assertEqual([lines[0], lines[2], lines[3], lines[-1]], ["Curveplot", "Frequency", "Amplitude", "endcurve"])
        points = [tuple(map(float, line.split())) for line in lines[7:-1]]
        self.assertEqual(len(points), 16)
        for frequency, amplitude in points:
            self.assertAlmostEqual(amplitude / wide[frequency], 1.0, delta=1e-6)
        # And the page, and summary.json.
        page = Page(self.read("wide/report.html"))
        self.assertEqual(page.loads, [])
        peak, = self.json("wide/summary.json")["responses"]
        self.assertEqual((peak["kind"], peak["direction"], peak["response"]), ("frf", "z", "displacement"))
        self.assertAlmostEqual(peak["peak"]["amplitude"] / max(wide.values()), 1.0, delta=1e-8)
        shown, = [row for row, kind in zip(page.rows, page.classes) if kind == "frf"]
        self.assertAlmostEqual(float(shown[3]) / peak["peak"]["amplitude"], 1.0, delta=1e-5)
        modes = [row for row, kind in zip(page.rows, page.classes) if kind == "mode"]
        self.assertAlmostEqual(float(modes[0][1]) / first, 1.0, delta=1e-5)
        self.assertEqual(self.read("wide/report.html").count("<polyline"), 2)  # amplitude and phase
        self.nugget("report", "wide")
        self.assertEqual(Page(self.read("wide/report.html")).rows, page.rows)

    def plate(self, frequencies):
        """NAFEMS 13H: 100 Pa on a simply supported plate, as a steady-state analysis."""
        n = 20
        across = [1 + i for i in range(n + 1)] + [1 + (n + 1) * n + i for i in range(n + 1)]
        along = [1 + (n + 1) * j for j in range(n + 1)] + [1 + (n + 1) * j + n for j in range(n + 1)]
        centre = 1 + (n + 1) * (n // 2) + n // 2
        cards = "*CONTROL_IMPLICIT_EIGENVALUE\n" + fields(4) + "*SET_SEGMENT\n" + fields(5)
        for j in range(n):
            for i in range(n):
                a = 1 + (n + 1) * j + i
                cards += fields(a, a + 1, a + n + 2, a + n + 1)
        cards += "*DEFINE_CURVE\n" + fields(9) + f"{0.0:20}{100.0:20}\n{10.0:20}{100.0:20}\n"
        cards += "*FREQUENCY_DOMAIN_SSD\n" + fields(1) + fields(0.02) + fields(0) + fields(5, 2, 0, 1, 9)
        cards += "*DATABASE_FREQUENCY_ASCII_NODOUT_SSD\n" + fields(*frequencies) + "*DATABASE_HISTORY_NODE\n" + fields(centre)
        return sheet(10.0, 10.0, 0.05, n, n, 200e9, 0.3, 8000.0, cards,
                     [((1, 1, 1, 0, 1, 1), across), ((1, 1, 1, 1, 0, 1), along)])

    def test_plate_under_harmonic_pressure(self):
        """A-61 (NAFEMS 13H): 2.377 Hz, 45.42 mm in the centre."""
        self.write(self.plate((2.377, 9.0, 2)))
        self.nugget("run", "model.k", "--quiet")
        modes = [mode["frequency_hz"] for mode in self.json("summary.json")["modes"]]
        for found, expected in zip(modes, (2.377, 5.961, 5.961, 9.483)):
            self.assertAlmostEqual(found / expected, 1.0, delta=0.02)
        row, = (r for r in self.rows("ssd.csv")
                if (r["direction"], r["response"], float(r["frequency"])) == ("z", "displacement", 2.377))
        self.assertAlmostEqual(1000.0 * float(row["amplitude"]) / 45.42, 1.0, delta=0.02)
        # nodout_ssd: three lines a node; displacement, velocity, acceleration.
        lines = self.read("nodout_ssd").splitlines()
        start = next(i for i, line in enumerate(lines) if "nodal print out for frequency =" in line)
        self.assertAlmostEqual(float(lines[start].split("=")[1]), 2.377, delta=1e-5)
        amplitude = next(line for line in lines if line.startswith(" amplitude  "))
        values = [float(amplitude[12 + 12 * i:24 + 12 * i]) for i in range(9)]
        self.assertAlmostEqual(values[2] / float(row["amplitude"]), 1.0, delta=1e-4)
        omega = 2.0 * math.pi * 2.377
        self.assertAlmostEqual(values[5] / (omega * values[2]), 1.0, delta=1e-3)
        self.assertAlmostEqual(values[8] / (omega * omega * values[2]), 1.0, delta=1e-3)
        self.assertEqual(len([r for r in self.json("summary.json")["responses"] if r["kind"] == "ssd"]), 9)
        self.assertIn("Steady state", self.read("report.html"))

    def test_direct_solution(self):
        damping = (0, 0, 0, 20.0, 2e-5)
        self.write(strip(lambda tip: "*CONTROL_IMPLICIT_EIGENVALUE\n" + fields(12) +
                         frf((tip, 0, 3, 3), damping, (tip, 0, 3, 1), (1.0, 401.0, 9)), 20, 2))
        self.nugget("frf", "model.k", "-o", "modal", "--quiet")
        run = self.nugget("frf", "model.k", "-o", "direct", "--direct", "--quiet")
        self.assertIn("direct solution at each frequency", run.stdout)
        modal, direct = self.amplitudes("modal/frf.csv"), self.amplitudes("direct/frf.csv")
        self.assertEqual(len(direct), 9)
        for frequency, amplitude in direct.items():
            self.assertAlmostEqual(modal[frequency] / amplitude, 1.0, delta=1e-3)
        self.assertNotIn("eigout", self.files("direct"))
        self.assertIn("Frequency response", self.read("direct/report.html"))

    def test_damping_by_modes_is_refused_in_the_direct_solution(self):
        self.write(strip(lambda tip: "*CONTROL_IMPLICIT_EIGENVALUE\n" + fields(5) +
                         frf((tip, 0, 3, 3), (0.02,), (tip, 0, 3, 2), (0.0, 300.0, 16)), 10, 1))
        run = self.nugget("frf", "model.k", "--direct", "--quiet", expect=1)
        self.assertRegex(run.stderr, r"model\.k:\d+:.*\*FREQUENCY_DOMAIN_FRF.*has no matrix.*DMPMAS")
        self.assertNotIn("frf.csv", self.files())

    def test_a_direct_analysis_needs_no_modes(self):
        self.write(strip(lambda tip: "*DEFINE_CURVE\n" + fields(9) + f"{0.0:20}{1.0:20}\n{500.0:20}{1.0:20}\n"
                         "*DAMPING_STRUCTURAL\n" + fields(0.04) +
                         "*FREQUENCY_DOMAIN_SSD_DIRECT\n" + fields(1) + fields(0) + fields(0) + fields(tip, 0, 3, 0, 9) +
                         "*DATABASE_FREQUENCY_ASCII_NODOUT_SSD\n" + fields(0.0, 20.0, 2) +
                         "*DATABASE_HISTORY_NODE\n" + fields(tip), 20, 2))
        self.nugget("run", "model.k", "--quiet")
        still = next(r for r in self.rows("ssd.csv") if (r["direction"], r["response"]) == ("z", "displacement"))
        self.assertAlmostEqual(float(still["amplitude"]) / 0.952381, 1.0, delta=0.02)
        self.assertAlmostEqual(float(still["phase"]), -math.degrees(math.atan(0.04)), delta=1e-6)


if __name__ == "__main__":
    unittest.main()
