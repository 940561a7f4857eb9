# SPDX-License-Identifier: Apache-2.0
"""The filter against the corridor of SAE J211-1: -3 dB at 5/3 of the class, flat below, falling by 24 dB an octave."""
import math
import unittest

import sae


def gain(cfc, hertz, second=1.0):
    """Amplitude in the middle of a long sine of 1."""
    step = 1.0 / (40.0 * max(hertz, cfc))
    times = [second * i * step for i in range(8001)]
    _, y = sae.filtered(times, [math.sin(2.0 * math.pi * hertz * t / second) for t in times], cfc, second)
    return max(abs(v) for v in y[3000:5000])


class Sae(unittest.TestCase):
    def test_corridor_of_each_class(self):
        for cfc, corner in ((60, 100.0), (180, 300.0), (600, 1000.0), (1000, 1650.0)):
            self.assertAlmostEqual(20.0 * math.log10(gain(cfc, corner)), -3.0, delta=0.5, msg=cfc)
            self.assertAlmostEqual(gain(cfc, 0.1 * corner), 1.0, delta=0.01, msg=cfc)
            octave = 20.0 * math.log10(gain(cfc, 8.0 * corner) / gain(cfc, 4.0 * corner))
            self.assertAlmostEqual(octave, -24.0, delta=1.5, msg=cfc)

    def test_times_in_milliseconds(self):
        self.assertAlmostEqual(gain(180, 300.0, 1000.0), gain(180, 300.0), delta=1e-9)

    def test_no_phase_and_uneven_samples(self):
        times = [i * 1e-4 + (5e-5 if i % 3 == 1 else 0.0) for i in range(2001)]
        even, y = sae.filtered(times, [math.sin(2.0 * math.pi * 20.0 * t) for t in times], 180)
        self.assertLess(max(abs(v - math.sin(2.0 * math.pi * 20.0 * t)) for t, v in list(zip(even, y))[200:-200]), 0.01)

    def test_times_that_repeat_are_refused(self):
        for times in ([0.0, 0.001, 0.001, 0.002], [0.0, 0.002, 0.001, 0.003]):
            with self.assertRaisesRegex(ValueError, "ascend"):
                sae.filtered(times, [0.0, 1.0, 2.0, 3.0], 60)

    def test_response_is_that_of_two_butterworth_filters(self):
        """Gain 1/(1 + (W/Wc)^4) of the pass forwards and backwards, W = tan(pi f T), Wc at 2.0775 of the class: the
        bilinear transform of the filter of J211-1, at frequencies from a tenth of the corner to eight times it."""
        for cfc in (60, 180, 600, 1000):
            for hertz in (0.2 * cfc, cfc, 5.0 / 3.0 * cfc, 3.0 * cfc, 8.0 * cfc):
                step = 1.0 / (40.0 * max(hertz, cfc))
                ratio = math.tan(math.pi * hertz * step) / math.tan(math.pi * 2.0775 * cfc * step)
                self.assertAlmostEqual(gain(cfc, hertz), 1.0 / (1.0 + ratio ** 4), delta=0.004, msg=(cfc, hertz))

    def test_nothing_acted_before_the_first_sample(self):
        """A blow of one cycle, then a half sine of 90 that peaks at 6 ms: the blow was no force that had long been there."""
        times = [i * 1e-5 for i in range(2001)]
        force = [90.0 * math.sin(math.pi * t / 0.012) if t < 0.012 else 0.0 for t in times]
        force[0] = 316.0
        _, y = sae.filtered(times, force, 60)
        peak = max(range(len(y)), key=lambda i: abs(y[i]))
        self.assertAlmostEqual(times[peak], 0.006, delta=1e-4)
        self.assertAlmostEqual(y[peak], 90.0, delta=2.5)
        _, y = sae.filtered(times, [5.0] * len(times), 60, before=5.0)
        self.assertLess(max(abs(v - 5.0) for v in y), 1e-9)

    def test_samples_too_far_apart_are_refused(self):
        with self.assertRaises(ValueError):
            sae.filtered([0.0, 0.01, 0.02], [0.0, 1.0, 0.0], 60)


if __name__ == "__main__":
    unittest.main()
