# SPDX-License-Identifier: Apache-2.0
"""Responses over frequency by the command: `nugget frf` by modes and directly, harmonic loads (SSD), files and the page."""
import csv
import math
import struct
import unittest

from nugget_command import CommandTest
from test_mode_studies import strips
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
    """The cantilever strip; its tip is the node in the middle of the free edge."""
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
        """Eight modes of Euler's beam; half a decibel."""
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

    def test_one_frequency_alone(self):
        """Has what a range has there; which of a range is meant by NFREQ 1 is asked."""
        def over(*frequencies):
            return strip(lambda tip: "*CONTROL_IMPLICIT_EIGENVALUE\n" + fields(3) + frf((tip, 0, 3, 3), (0.02,), (tip, 0, 3, 2), frequencies),
                         along=20, across=2)
        self.write(over(20.0, 300.0, 2))
        self.nugget("frf", "model.k", "-o", "range", "--quiet")
        expected = self.amplitudes("range/frf.csv")[20.0]
        for count in (1, 5):
            self.write(over(20.0, 20.0, count))
            self.assertIn("1 response, at 20 Hz", self.nugget("frf", "model.k", "-o", "alone", "--quiet").stdout)
            self.assertEqual(self.amplitudes("alone/frf.csv"), {20.0: expected})
            self.assertEqual(self.read("alone/report.html").count('<circle cx="'), 2)  # amplitude and phase
        self.write(over(20.0, 300.0, 1))
        self.assertRegex(self.nugget("check", "model.k", expect=1).stderr, r"model.k:\d+:\d+: error: .* nfreq = 1: one frequency of a range")
        self.write(self.plate((2.377, 9.0, 2)))
        self.nugget("run", "model.k", "-o", "range", "--quiet")
        expected = [row for row in self.rows("range/ssd.csv") if float(row["frequency"]) == 2.377]
        self.write(self.plate((2.377, 2.377, 1)))
        self.nugget("run", "model.k", "-o", "alone", "--quiet")
        self.assertEqual(self.rows("alone/ssd.csv"), expected)

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
        """NAFEMS 13H: 2.377 Hz, 45.42 mm in the centre."""
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

    def test_subcases(self):
        """Two excitations out of one computation of modes, and Maxwell's reciprocity between them."""
        nodes = {}

        def cards(tip):
            nodes["tip"], nodes["middle"] = tip, tip - 10
            text = "*CONTROL_IMPLICIT_EIGENVALUE\n" + fields(6) + "*SET_NODE_LIST\n" + fields(50) + fields(tip, tip - 10)
            text += "*FREQUENCY_DOMAIN_FRF_SUBCASE\n" + fields(2) + fields(0.02) + fields(10.0, 200.0, 20)
            for name, node in nodes.items():
                text += f"force at the {name}\n" + fields(node, 0, 3, 3) + fields(50, 1, 3, 2)
            return text
        self.write(strip(cards, 20, 2))
        run = self.nugget("frf", "model.k", "--quiet")
        self.assertIn("case 2: force at the middle", run.stdout)
        self.assertIn("2 residual vectors", run.stdout)
        found = {}
        for row in self.rows("frf.csv"):
            found.setdefault((int(row["case"]), int(row["node"])), []).append(complex(float(row["real"]), float(row["imaginary"])))
        self.assertEqual(len(found), 4)
        for a, b in zip(found[1, nodes["middle"]], found[2, nodes["tip"]]):
            self.assertAlmostEqual(abs(a - b), 0.0, delta=1e-6 * abs(a))
        self.assertGreater(abs(found[1, nodes["tip"]][0]), 2.0 * abs(found[2, nodes["middle"]][0]))
        self.assertEqual([r["case"] for r in self.json("summary.json")["responses"]], [1, 1, 2, 2])
        self.assertIn(f"C-2-N-{nodes['tip']}-z", self.read("frf_amplitude"))
        self.assertIn(f"case 2, node {nodes['tip']} z", self.read("report.html"))

    def test_frequencies_of_the_modes(self):
        """FSPACE 3 and 2: the response at the natural frequencies, and gathered there."""
        deck = strip(lambda tip: "*CONTROL_IMPLICIT_EIGENVALUE\n" + fields(5) +
                     frf((tip, 0, 3, 3), (0.02,), (tip, 0, 3, 2), (10.0, 400.0, "COUNT", "SPACE")), 20, 2)
        natural = None
        for space, count in ((3, 2), (2, 40)):
            self.write(deck.replace("COUNT", f"{count:5d}").replace("SPACE", f"{space:5d}"))
            self.nugget("frf", "model.k", "--quiet")
            natural = [m["frequency_hz"] for m in self.json("summary.json")["modes"] if 10.0 <= m["frequency_hz"] <= 400.0]
            frequencies = list(self.amplitudes("frf.csv"))
            self.assertEqual(len(frequencies), len(natural) if space == 3 else 40)
            for f in natural:
                self.assertLess(min(abs(f - g) for g in frequencies), 1e-6 * f)
        run = self.nugget("frf", "model.k", "--direct", "--quiet", expect=1)
        self.assertIn("FSPACE 2 and 3 ask for frequencies by the modes", run.stderr)

    def d3ssd(self, states):
        """[(frequency, displacements, velocities)] of the first file of states."""
        head = (self.folder / "d3ssd").read_bytes()
        control = struct.unpack("<64i", head[:256])
        self.assertEqual(control[11], 21)
        count, globals_ = control[16], control[18]
        at_rest = struct.unpack(f"<{3 * count}f", head[256:256 + 12 * count])
        data = (self.folder / "d3ssd01").read_bytes()
        words = struct.unpack(f"<{len(data) // 4}f", data)
        one_state, rest = divmod(words.index(-999999.0), states)
        self.assertEqual(rest, 0)
        found = []
        for k in range(0, states * one_state, one_state):
            x = words[k + 1 + globals_:][:3 * count]
            v = words[k + 1 + globals_ + 3 * count:][:3 * count]
            found.append((words[k], [a - b for a, b in zip(x, at_rest)], v))
        return found

    def test_states_of_all_nodes(self):
        """d3ssd: amplitudes, real and imaginary parts; the tip as nodout_ssd has it."""
        tips = []

        def cards(tip):
            tips.append(tip)
            return ("*CONTROL_IMPLICIT_EIGENVALUE\n" + fields(6) + "*DEFINE_CURVE\n" + fields(9) +
                    f"{0.0:20}{100.0:20}\n{500.0:20}{100.0:20}\n" +
                    "*FREQUENCY_DOMAIN_SSD\n" + fields(1) + fields(0.05) + fields(0) + fields(tip, 0, 3, 0, 9) +
                    "*DATABASE_FREQUENCY_ASCII_NODOUT_SSD\n" + fields(20.0, 60.0, 3) + "*DATABASE_HISTORY_NODE\n" + fields(tip) +
                    "*DATABASE_FREQUENCY_BINARY_D3SSD\n" + fields("BINARY") + fields(20.0, 60.0, 3))
        deck = strip(cards, 20, 2)
        parts = {}
        for part in (1, 90, 91):
            self.write(deck.replace("    BINARY", f"{part:10d}"))
            self.nugget("run", "model.k", "--quiet")
            parts[part] = self.d3ssd(3)
            self.assertEqual([round(state[0], 3) for state in parts[part]], [20.0, 40.0, 60.0])
        z = 3 * (tips[0] - 1) + 2
        rows = [r for r in self.rows("ssd.csv") if (r["direction"], r["response"]) == ("z", "displacement")]
        for k, row in enumerate(rows):
            scale = float(row["amplitude"])
            for part, column in ((1, "amplitude"), (90, "real"), (91, "imaginary")):
                self.assertAlmostEqual(parts[part][k][1][z], float(row[column]), delta=1e-4 * scale)
            self.assertAlmostEqual(parts[1][k][2][z] / (2 * math.pi * float(row["frequency"]) * scale), 1.0, delta=1e-4)

    def test_radiated_power(self):
        """ERP of the shells of a cantilever at its first resonance: the velocity is that of its first mode, of which the
        integral of the square is a quarter of the tip's. erp.csv, ERP_abs and ERP_dB hold the same."""
        density, speed = 1.2e-12, 343000.0

        def cards(tip):
            return ("*CONTROL_IMPLICIT_EIGENVALUE\n" + fields(6) + "*DEFINE_CURVE\n" + fields(9) +
                    f"{0.0:20}{1.0:20}\n{500.0:20}{1.0:20}\n" +
                    "*FREQUENCY_DOMAIN_SSD_ERP\n" + fields(1) + fields(0.01) + fields(0, 0, 0, 1) +
                    fields(f"{density:.4g}", speed, 1.0, 1e-9) + fields(1, 0) + fields(tip, 0, 3, 0, 9) +
                    "*DATABASE_FREQUENCY_ASCII_NODOUT_SSD\n" + fields(1.0, 60.0, 2, 3) +
                    "*DATABASE_HISTORY_NODE\n" + fields(tip))
        self.write(strip(cards, 40, 4))
        run = self.nugget("frf", "model.k", "--quiet")
        self.assertIn("Equivalent radiated power", run.stdout)
        row, = self.rows("erp.csv")
        tip = next(r for r in self.rows("ssd.csv") if (r["direction"], r["response"]) == ("z", "velocity"))
        expected = 0.5 * density * speed * 200.0 * 20.0 * float(tip["amplitude"]) ** 2 / 4
        power = float(row["power"])
        self.assertAlmostEqual(power / expected, 1.0, delta=5e-3)
        self.assertAlmostEqual(float(row["decibels"]), 10 * math.log10(power / 1e-9), delta=1e-6)
        for name, value in (("ERP_abs", power), ("ERP_dB", float(row["decibels"]))):
            points = [line.split() for line in self.read(name).splitlines() if len(line.split()) == 2 and line[0] == " "]
            self.assertEqual(len(points), 1, name)
            self.assertAlmostEqual(float(points[0][1]) / value, 1.0, delta=1e-6)
        peak = [r for r in self.json("summary.json")["responses"] if r["kind"] == "erp"]
        self.assertEqual([(r["direction"], r["response"]) for r in peak], [("part 1", "radiated power")])
        self.assertIn('<tr class="erp"><td class="text">part 1</td>', self.read("report.html"))

    def test_subcases_of_harmonic_loads(self):
        """Files for each case, and the two cases in ssd.csv: loads twice as large move the tip twice as far."""
        def cards(tip):
            text = ("*CONTROL_IMPLICIT_EIGENVALUE\n" + fields(6) + "*DEFINE_CURVE\n" + fields(9) +
                    f"{0.0:20}{1.0:20}\n{500.0:20}{1.0:20}\n" +
                    "*FREQUENCY_DOMAIN_SSD_SUBCASE\n" + fields(1) + fields(0.05) + fields(0))
            for name, factor in (("one", 1.0), ("two", 2.0)):
                text += f"{name:10}{'force of ' + name:60}{1:10}\n" + fields(tip, 0, 3, 0, 9, 0, factor)
            return (text + "*DATABASE_FREQUENCY_ASCII_NODOUT_SSD_SUBCASE\n" + fields(20.0, 60.0, 3) +
                    "*DATABASE_HISTORY_NODE\n" + fields(tip) +
                    "*DATABASE_FREQUENCY_BINARY_D3SSD_SUBCASE\n" + fields(1) + fields(20.0, 60.0, 3))
        self.write(strip(cards, 20, 2))
        run = self.nugget("frf", "model.k", "--quiet")
        self.assertIn("case 2: two force of two", run.stdout)
        for name in ("nodout_ssd_one", "nodout_ssd_two", "d3ssd_one", "d3ssd_one01", "d3ssd_two", "d3ssd_two01"):
            self.assertIn(name, self.files())
        found = {}
        for row in self.rows("ssd.csv"):
            found.setdefault(row["case"], []).append(float(row["amplitude"]))
        self.assertEqual(sorted(found), ["1", "2"])
        for a, b in zip(found["1"], found["2"]):
            self.assertAlmostEqual(2 * a, b, delta=1e-8 * abs(b))
        self.assertIn("case 2, node", self.read("report.html"))
        self.write(strip(lambda tip: cards(tip).replace("two  ", "three"), 20, 2))
        self.nugget("frf", "model.k", "--quiet")
        self.assertNotIn("d3ssd_two", self.files())

    def test_page_of_welded_modes(self):
        """Modes with what holds their energy, welds ranked by it and by what the frequencies lose without them."""
        self.write(strips())
        self.nugget("modes", "model.k", "-n", 12, "--drop-weld", "all", "--quiet")
        page = Page(self.read("report.html"))
        self.assertEqual((page.open, page.loads), ([], []))
        modes = [row for row, kind in zip(page.rows, page.classes) if kind == "mode"]
        self.assertEqual([int(row[0]) for row in modes], list(range(1, 13)))
        shares = {(row["kind"], row["id"]): row for row in self.rows("mode_energy.csv")}
        largest = {name[1]: max(float(row[f"mode {i}"]) for i in range(1, 13)) for name, row in shares.items() if name[0] == "weld"}
        ranked = [row for row, kind in zip(page.rows, page.classes) if kind == "weld"]
        self.assertEqual([row[0] for row in ranked], sorted(largest, key=lambda weld: -largest[weld]))
        for weld, share, mode, _ in ranked:
            self.assertAlmostEqual(float(share.split()[0]) / 100.0, largest[weld], delta=1e-5)
            self.assertAlmostEqual(float(shares["weld", weld][f"mode {mode}"]), largest[weld], delta=1e-9)
        worst = self.json("summary.json")["drop_weld"][0]
        drops = page.rows[next(i for i, row in enumerate(page.rows) if row and row[0] == "without") + 1]
        self.assertEqual(drops[0], " ".join(map(str, worst["welds"])))
        self.assertAlmostEqual(float(drops[4]) / worst["without_hz"], 1.0, delta=1e-5)
        self.assertNotIn("Energies over time", self.read("report.html"))


if __name__ == "__main__":
    unittest.main()
