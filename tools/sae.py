# SPDX-License-Identifier: Apache-2.0
"""Channel frequency classes of SAE J211-1 (ISO 6487): the filter of crash signals.

A second-order Butterworth filter run forwards and backwards (J211-1, appendix C), so that no phase is shifted; -3 dB at
5/3 of the class: CFC 60 at 100 Hz, 180 at 300 Hz, 600 at 1000 Hz, 1000 at 1650 Hz.
"""
import math

CLASSES = (60, 180, 600, 1000)


def evenly(times, values):
    """The signal at as many times, evenly spaced, on straight lines between its samples."""
    for before, after in zip(times, times[1:]):
        if not after > before:
            raise ValueError(f"times must ascend; {after:g} follows {before:g} (rows of several walls or contacts in one "
                             "file, or times with too few digits: take binout)")
    step = (times[-1] - times[0]) / (len(times) - 1)
    even, k = [], 0
    for i in range(len(times)):
        t = min(times[0] + i * step, times[-1])
        while k < len(times) - 2 and times[k + 1] < t:
            k += 1
        share = (t - times[k]) / (times[k + 1] - times[k])
        even.append(values[k] + share * (values[k + 1] - values[k]))
    return [times[0] + i * step for i in range(len(times))], even


def once(values, before, a, b):
    """y(n) = a0 x(n) + a1 x(n-1) + a2 x(n-2) + b1 y(n-1) + b2 y(n-2); the signal was `before` until its start."""
    x1 = x2 = y1 = y2 = before
    out = []
    for x in values:
        y = a[0] * x + a[1] * x1 + a[2] * x2 + b[0] * y1 + b[1] * y2
        x1, x2, y1, y2 = x, x1, y, y1
        out.append(y)
    return out


def filtered(times, values, cfc, second=1.0, before=0.0):
    """Evenly spaced times and the signal of class `cfc` there; `second` is one second in the unit of the times.

    Until the first time the signal was `before`: nothing acted before a run began, and a first sample that is the blow
    of one cycle must not count as a force that had long been there.
    """
    times, values = evenly(times, values)
    step = (times[1] - times[0]) / second
    if cfc * 2.0775 * step >= 0.5:
        raise ValueError(f"CFC {cfc} needs samples closer than {0.5 / (cfc * 2.0775):.3g} s; these are {step:.3g} s apart")
    w = math.tan(math.pi * 2.0775 * cfc * step)
    c = 1.0 + math.sqrt(2.0) * w + w * w
    a = (w * w / c, 2.0 * w * w / c, w * w / c)
    b = (-2.0 * (w * w - 1.0) / c, (-1.0 + math.sqrt(2.0) * w - w * w) / c)
    forth = once(values, before, a, b)
    return times, once(forth[::-1], forth[-1], a, b)[::-1]
