# SPDX-License-Identifier: Apache-2.0
"""Modes of laws that know strain rates: a structure at rest has those of rest, in seconds as in microseconds."""
import unittest

from nugget_command import CommandTest

NODES = [(x + 0.3 * z, y + 0.2 * x, z) for z in (0.0, 3.0, 7.0) for x, y in ((0.0, 0.0), (5.0, 0.5), (5.5, 4.0), (0.0, 4.0))]
BRICKS = [range(1, 9), range(5, 13)]


def curve(number, stress, *points):
    return f"*DEFINE_CURVE\n{number},0,1.0,{stress!r}\n" + "".join(f"{a!r},{b!r}\n" for a, b in points)


def table(rate, first, last):
    return f"*DEFINE_TABLE_2D\n9\n{first / rate!r},7\n{last / rate!r},8\n"


def foam(mass, stress, rate):
    text = f"*MAT_083\n1,{5e-11 * mass!r},{2.0 * stress!r},0,0,0,,9\n0,1.0\n\n\n\n" + table(rate, 0.0, 4000.0)
    return text + curve(7, stress, (0, 0), (0.05, 0.1), (0.5, 0.15), (0.9, 0.95)) + curve(8, stress, (0, 0), (0.05, 0.3), (0.5, 0.35), (0.9, 1.55))


def rubber(mass, stress, rate):
    """By a test of nominal stresses, over the rate in loading and unloading."""
    text = f"*MAT_181\n1,{1.2e-9 * mass!r},{50.0 * stress!r},,,\n1,1,1,9,1\n" + table(rate, 10.0, 4000.0)
    tests = [[(l - 1.0, a * (l * l - 1.0 / l) * (0.4 + 0.1 / l) / l) for l in (0.4 + 0.05 * k for k in range(40))] for a in (2.0, 3.0)]
    return text + curve(7, stress, *tests[0]) + curve(8, stress, *tests[1])


class ModeUnits(CommandTest):
    def frequencies(self, law, elform, time, per_mass):
        """In units of 1/s. `time`: units of it in a second; `per_mass`: units of mass in a tonne. Lengths are in mm."""
        text = f"*KEYWORD\n*PART\nblock\n1,1,1\n*SECTION_SOLID\n1,{elform}\n" + law(per_mass, per_mass / time**2, time)
        text += "*NODE\n" + "".join(f"{n},{','.join(map(repr, x))}\n" for n, x in enumerate(NODES, 1))
        text += "*ELEMENT_SOLID\n" + "".join(f"{e},1,{','.join(map(str, n))}\n" for e, n in enumerate(BRICKS, 1)) + "*END\n"
        self.write(text)
        self.nugget("modes", "model.k", "-n", "14", "-o", "modes", "--quiet")
        return [m["frequency_hz"] * time for m in self.json("modes/summary.json")["modes"]][6:]

    def test_units_of_time(self):
        """Sabotage: a stiffness from a step at the speed of one unit of length in one of time (foam: 0.3 % in ms, 41 % in microseconds)."""
        for law in (foam, rubber):
            for elform in (1, 2, -1):
                seconds = self.frequencies(law, elform, 1.0, 1.0)
                for time, per_mass in ((1e3, 1e3), (1e6, 1e6)):  # kg mm ms; g mm us
                    with self.subTest(law.__name__, elform=elform, time=time):
                        for a, b in zip(seconds, self.frequencies(law, elform, time, per_mass)):
                            self.assertAlmostEqual(b / a, 1.0, delta=1e-5)


if __name__ == "__main__":
    unittest.main()
