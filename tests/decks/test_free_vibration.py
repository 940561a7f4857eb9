# SPDX-License-Identifier: Apache-2.0
"""Explicit free vibration has the frequencies of `nugget modes`: the same deck, started with the velocities of a mode."""
import cmath
import math
import struct
import unittest

from nugget_command import CommandTest
from test_mode_studies import strips


def cantilever(along=40, across=4):
    """The cantilever strip: 200 x 20 x 2 of steel, held at one end; node 1 + (along + 1) j + i."""
    nodes, shells, row = ["*NODE"], ["*ELEMENT_SHELL"], along + 1
    for j in range(across + 1):
        nodes += [f"{1 + row * j + i:8d}{200.0 * i / along:16.6f}{20.0 * j / across:16.6f}{0.0:16.6f}" for i in range(row)]
    for j in range(across):
        for i in range(along):
            a = 1 + row * j + i
            shells.append(f"{1 + along * j + i:8d}{1:8d}{a:8d}{a + 1:8d}{a + row + 1:8d}{a + row:8d}")
    held = "".join(f"{1 + row * j:10d}" for j in range(across + 1))
    return "\n".join(["*KEYWORD\n*CONTROL_TERMINATION\n       1.0\n*PART\nstrip\n         1         1         1",
                      "*SECTION_SHELL\n         1        16  0.833333         3\n       2.0       2.0       2.0       2.0",
                      "*MAT_ELASTIC\n         1  7.85e-09  210000.0       0.3",
                      "*BOUNDARY_SPC_SET\n         1         0         1         1         1         1         1         1",
                      f"*SET_NODE_LIST\n         1\n{held}", *nodes, *shells, "*END"]) + "\n"


def stressed(stress):
    """The same strip clamped at both ends, under a stress along it; a pressure of 69 N/mm2 would buckle it."""
    ends = "".join(f"{1 + 41 * j + i:10d}{0:10d}" + 6 * f"{1:10d}" + "\n" for j in range(5) for i in (0, 40))
    cards = "*CONTROL_IMPLICIT_GENERAL\n" + f"{0:10d}{1.0:10}{2:10d}{1:10d}{1:10d}\n" + "*BOUNDARY_SPC_NODE\n" + ends + "*INITIAL_STRESS_SHELL\n"
    for e in range(1, 161):
        cards += f"{e:10d}{1:10d}{1:10d}\n{0.0:10}{stress:10.4g}" + 6 * f"{0.0:10}" + "\n"
    return cantilever().replace("*END", cards + "*END")


def shapes(folder):
    """Node ids and, by mode, the motions of the nodes."""
    head = (folder / "d3eigv").read_bytes()
    control = struct.unpack("<64i", head[:256])
    nodes, solids, beams, shells = control[16], control[23], control[28], control[31]
    rest = struct.unpack(f"<{3 * nodes}f", head[256:256 + 12 * nodes])
    begin = 256 + 4 * (3 * nodes + 9 * solids + 6 * beams + 5 * shells + 16)
    ids = struct.unpack(f"<{nodes}i", head[begin:begin + 4 * nodes])
    size = 1 + control[18] + 3 * nodes + solids * control[27] + beams * control[30] + shells * control[33] + solids + beams + shells
    data = (folder / "d3eigv01").read_bytes()
    words = struct.unpack(f"<{len(data) // 4}f", data)
    modes = []
    for state in range(0, len(words) - size + 1, size):
        first = state + 1 + control[18]
        modes.append([words[first + k] - rest[k] for k in range(3 * nodes)])
    return ids, modes


class FreeVibration(CommandTest):
    def explicit_frequency(self, deck, ids, shape, expected, watched, against):
        """Frequency of the difference in z of two nodes, from its zeros over three half periods."""
        largest = max(abs(v) for v in shape)
        # An amplitude of a hundredth of a millimetre: geometry stays that of rest.
        speed = 0.01 * 2.0 * 3.14159265 * expected / largest
        start = ["*INITIAL_VELOCITY_NODE"]
        for k, node in enumerate(ids):
            start.append(f"{node:10d}" + "".join(f"{speed * v:10.3e}" for v in shape[3 * k:3 * k + 3]))
        period = 1.0 / expected
        cards = (f"*DATABASE_NODOUT\n{period / 200:10.4e}\n*DATABASE_HISTORY_NODE\n{watched:10d}{against:10d}\n"
                 f"*CONTROL_TERMINATION\n{1.7 * period:10.4e}\n" + "\n".join(start) + "\n")
        self.write(deck.replace("*CONTROL_TERMINATION\n       1.0\n", cards), "explicit.k")
        self.nugget("run", "explicit.k", "-o", "explicit", "--quiet", "-j", "1")
        signal, time, seen = [], None, {}
        for line in self.read("explicit/nodout").splitlines():
            if "at time" in line:
                if "n o d a l" in line:
                    time, seen = float(line.split("at time")[1].strip(" )")), {}
                continue
            words = line.split()
            if words and words[0] in (str(watched), str(against)) and int(words[0]) not in seen:
                seen[int(words[0])] = float(words[3])
                if len(seen) == 2 and (not signal or signal[-1][0] < time):
                    signal.append((time, seen[watched] - seen[against]))
        zeros = []
        for (t0, a), (t1, b) in zip(signal[2:], signal[3:]):
            if a * b < 0.0:
                zeros.append(t0 + (t1 - t0) * a / (a - b))
        self.assertGreaterEqual(len(zeros), 3, zeros)
        return (len(zeros) - 1) / 2.0 / (zeros[-1] - zeros[0])

    def agree(self, deck, modes, watched, against, gate):
        self.write(deck)
        self.nugget("modes", "model.k", "-n", max(modes), "-o", "modes", "--quiet", "-j", "1")
        expected = [mode["frequency_hz"] for mode in self.json("modes/summary.json")["modes"]]
        ids, motion = shapes(self.folder / "modes")
        for mode in modes:
            found = self.explicit_frequency(deck, ids, motion[mode - 1], expected[mode - 1], watched, against)
            print(f"mode {mode}: modes {expected[mode - 1]:.4f}, explicit {found:.4f}, {100 * (found / expected[mode - 1] - 1):+.3f} %")
            self.assertAlmostEqual(found / expected[mode - 1], 1.0, delta=gate, msg=f"mode {mode}")

    def test_welded_strips(self):
        """First bending of two welded strips, three welds over shells of 4 mm; gate .5 %."""
        self.agree(strips(along=45, across=5), [7], 1000, 1023, 5e-3)

    def test_cantilever(self):
        """The bending modes of the cantilever strip; gate .3 %."""
        self.agree(cantilever(), [1, 2], 123, 83, 3e-3)

    def test_impulse_on_a_cantilever(self):
        """The third bending mode in the spectrum of a damped explicit response, gate .3 %, and its decay, 2 %."""
        alpha, pulse, window, later = 100.0, 1e-3, 0.012, 0.006
        along, across = 60, 6
        tip, deck = (along + 1) * (across // 2 + 1), cantilever(along, across)
        self.write(deck)
        self.nugget("modes", "model.k", "-n", 6, "-o", "modes", "--quiet", "-j", "1")
        expected = min((mode["frequency_hz"] for mode in self.json("modes/summary.json")["modes"]),
                       key=lambda f: abs(f - 732.09))
        # A pulse without corners: a step would shake modes of 50 kHz and more as well, which samples fold onto this one.
        force = [0.5 - 0.5 * math.cos(2.0 * math.pi * k / 40) for k in range(41)]
        cards = (f"*CONTROL_TERMINATION\n{pulse + window + later:10.4e}\n*DAMPING_GLOBAL\n{0:10d}{alpha:10.4g}\n"
                 f"*DATABASE_NODOUT\n{2e-5:10.4e}\n*DATABASE_HISTORY_NODE\n{tip:10d}\n*DEFINE_CURVE\n{9:10d}\n" +
                 "".join(f"{pulse * k / 40:20.10e}{f:20.10e}\n" for k, f in enumerate(force)) +
                 f"*LOAD_NODE_POINT\n{tip:10d}{3:10d}{9:10d}{0.01:10.4g}\n")
        self.write(deck.replace("*CONTROL_TERMINATION\n       1.0\n", cards), "explicit.k")
        self.nugget("run", "explicit.k", "-o", "explicit", "--quiet", "-j", "1")
        signal, time = [], None
        for line in self.read("explicit/nodout").splitlines():
            if "at time" in line and "n o d a l" in line:
                time = float(line.split("at time")[1].strip(" )"))
            elif time is not None and line.split()[:1] == [str(tip)] and (not signal or signal[-1][0] < time):
                signal.append((time, float(line.split()[6])))  # velocity along z; the spins of that time come second

        def spectrum(frequency, begin):
            """Of the part of the signal under a Hann window that begins so long after the pulse."""
            part = [(t - pulse - begin, v) for t, v in signal if 0.0 <= t - pulse - begin <= window]
            return abs(sum(v * (1.0 - math.cos(2.0 * math.pi * t / window)) * cmath.exp(-2j * math.pi * frequency * t)
                           for t, v in part))

        low, high = 0.9 * expected, 1.1 * expected
        while high - low > 1e-5 * expected:  # one peak in between
            a, b = low + 0.382 * (high - low), low + 0.618 * (high - low)
            low, high = (low, b) if spectrum(a, 0.0) > spectrum(b, 0.0) else (a, high)
        found = 0.5 * (low + high)
        rate = math.log(spectrum(found, 0.0) / spectrum(found, later)) / later
        print(f"mode 3: modes {expected:.4f}, explicit {found:.4f}, {100 * (found / expected - 1):+.3f} %; "
              f"share of critical {rate / (2 * math.pi * found):.6f}, alpha / 2 omega {alpha / (4 * math.pi * found):.6f}")
        self.assertAlmostEqual(found / expected, 1.0, delta=3e-3)
        self.assertAlmostEqual(rate / (0.5 * alpha), 1.0, delta=0.02)

    def test_strip_under_stress(self):
        """Geometric stiffness of modes (IGS 1) against the same initial stress in an explicit run; gate .5 %."""
        free = {}
        for stress in (0.0, 100.0, -30.0):
            with self.subTest(stress=stress):
                self.agree(stressed(stress), [1], 103, 83, 5e-3)
                free[stress] = self.json("modes/summary.json")["modes"][0]["frequency_hz"]
        self.assertGreater(free[100.0], 1.4 * free[0.0])
        self.assertLess(free[-30.0], 0.8 * free[0.0])


if __name__ == "__main__":
    unittest.main()
