# SPDX-License-Identifier: Apache-2.0
"""Explicit free vibration has the frequencies of `nugget modes`: the same deck, started with the velocities of a mode."""
import cmath
import math
import struct
import unittest

from nugget_command import CommandTest
from test_mode_studies import strips


def cantilever():
    """A-54: a strip 200 x 20 x 2 of steel, held at one end, 40 x 4 shells."""
    nodes, shells = ["*NODE"], ["*ELEMENT_SHELL"]
    for j in range(5):
        nodes += [f"{1 + 41 * j + i:8d}{5.0 * i:16.6f}{5.0 * j:16.6f}{0.0:16.6f}" for i in range(41)]
    for j in range(4):
        for i in range(40):
            a = 1 + 41 * j + i
            shells.append(f"{1 + 40 * j + i:8d}{1:8d}{a:8d}{a + 1:8d}{a + 42:8d}{a + 41:8d}")
    held = "".join(f"{1 + 41 * j:10d}" for j in range(5))
    return "\n".join(["*KEYWORD\n*CONTROL_TERMINATION\n       1.0\n*PART\nstrip\n         1         1         1",
                      "*SECTION_SHELL\n         1        16  0.833333         3\n       2.0       2.0       2.0       2.0",
                      "*MAT_ELASTIC\n         1  7.85e-09  210000.0       0.3",
                      "*BOUNDARY_SPC_SET\n         1         0         1         1         1         1         1         1",
                      f"*SET_NODE_LIST\n         1\n{held}", *nodes, *shells, "*END"]) + "\n"


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
        """A-62: the bending modes of A-54; gate .3 %."""
        self.agree(cantilever(), [1, 2], 123, 83, 3e-3)

    def test_impulse_on_a_cantilever(self):
        """A-62: the third bending mode in the spectrum of a damped explicit response, gate .3 %, and its decay, 2 %."""
        alpha, tip = 100.0, 123
        self.write(cantilever())
        self.nugget("modes", "model.k", "-n", 6, "-o", "modes", "--quiet", "-j", "1")
        expected = min((mode["frequency_hz"] for mode in self.json("modes/summary.json")["modes"]),
                       key=lambda f: abs(f - 732.09))
        start = "".join(f"{1 + 41 * j + 40:10d}{0.0:10.3e}{0.0:10.3e}{10.0:10.3e}\n" for j in range(5))
        cards = (f"*CONTROL_TERMINATION\n{0.03:10.4e}\n*DAMPING_GLOBAL\n{0:10d}{alpha:10.4g}\n"
                 f"*DATABASE_NODOUT\n{1e-5:10.4e}\n*DATABASE_HISTORY_NODE\n{tip:10d}\n*INITIAL_VELOCITY_NODE\n{start}")
        self.write(cantilever().replace("*CONTROL_TERMINATION\n       1.0\n", cards), "explicit.k")
        self.nugget("run", "explicit.k", "-o", "explicit", "--quiet", "-j", "1")
        signal, time = [], None
        for line in self.read("explicit/nodout").splitlines():
            if "at time" in line:
                time = float(line.split("at time")[1].strip(" )")) if "n o d a l" in line else None
            elif time is not None and line.split()[:1] == [str(tip)]:
                signal.append((time, float(line.split()[6])))  # velocity along z
                time = None

        def spectrum(frequency, begin, length):
            """Of the part of the signal under a Hann window."""
            part = [(t - begin, v) for t, v in signal if begin <= t <= begin + length]
            return abs(sum(v * (1.0 - math.cos(2.0 * math.pi * t / length)) * cmath.exp(-2j * math.pi * frequency * t)
                           for t, v in part))

        low, high = 0.9 * expected, 1.1 * expected
        while high - low > 1e-5 * expected:  # one peak in between
            a, b = low + 0.382 * (high - low), low + 0.618 * (high - low)
            low, high = (low, b) if spectrum(a, 0.0, 0.02) > spectrum(b, 0.0, 0.02) else (a, high)
        found = 0.5 * (low + high)
        self.assertAlmostEqual(found / expected, 1.0, delta=3e-3)
        rate = math.log(spectrum(found, 0.0, 0.02) / spectrum(found, 0.01, 0.02)) / 0.01
        print(f"mode 3: modes {expected:.4f}, explicit {found:.4f}, {100 * (found / expected - 1):+.3f} %; "
              f"share of critical {rate / (2 * math.pi * found):.6f}, alpha / 2 omega {alpha / (4 * math.pi * found):.6f}")
        self.assertAlmostEqual(rate / (0.5 * alpha), 1.0, delta=0.02)


if __name__ == "__main__":
    unittest.main()
