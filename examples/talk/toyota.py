# SPDX-License-Identifier: Apache-2.0
"""Failure by the stresses of a bar (Toyota), with strengths over the strain rate: a weld pulled and sheared at four rates.

One elastic weld beam of 6 mm, one node held, the other one driven: along the axis until sigma = N / A reaches SIGAX of the rate, and across
until tau = V / A reaches SIGTAU of the rate.
"""
import math

import readers
from sheets import POISSON, SHEAR_MODULUS, YOUNG, Model, disc, smooth

DIAMETER, LENGTH = 6.0, 1.5
RATES = (1.0, 10.0, 100.0, 500.0)  # effective strain rates [1/s]
SIGAX = [(0.1, 300.0), (1.0, 350.0), (10.0, 420.0), (100.0, 500.0), (1000.0, 620.0)]
SIGTAU = [(0.1, 200.0), (1.0, 230.0), (10.0, 280.0), (100.0, 330.0), (1000.0, 420.0)]


def strength(curve, rate):
    for (a, u), (b, v) in zip(curve, curve[1:]):
        if a <= rate <= b:
            return u + (v - u) * (rate - a) / (b - a)
    raise ValueError(rate)


def deck(rate, sheared):
    """`rate`: the effective one, of a bar's strain, or of the engineering shear over sqrt 3."""
    speed = rate * LENGTH * (math.sqrt(3.0) if sheared else 1.0)
    strain = strength(SIGTAU, rate) / SHEAR_MODULUS / math.sqrt(3.0) if sheared else strength(SIGAX, rate) / YOUNG
    duration = 1.3 * strain / rate
    m = Model(f"A weld at {rate:g} 1/s", duration, step=duration / 2000.0)
    m.record(duration / 500.0, "SWFORC")
    m.beam_part(9, DIAMETER)
    m.deck.keyword("MAT_SPOTWELD_DAMAGE-FAILURE")
    m.deck.card(mid=9, ro=7.85e-9, e=YOUNG, pr=POISSON, sigy=1.0e6, eh=0.0)
    m.deck.card(efail=0.0, sigax=-70.0, sigtau=-71.0)
    m.deck.card(rs=0.0, opt=1.0)
    m.deck.curve(70, SIGAX)
    m.deck.curve(71, SIGTAU)
    m.beam(9001, 9, (0, 0, 0), (0, 0, LENGTH))
    m.hold(1, [9001])
    m.hold(2, [9002], "yuvw" if sheared else "xyuvw")
    m.drive(2, 1 if sheared else 3, [(0.0, 1.0), (1.0, 1.0)], speed, vad=0)
    return m.finished()


def decks():
    return {f"toyota_{'shear' if sheared else 'pull'}_{rate:g}": deck(rate, sheared) for sheared in (False, True) for rate in RATES}


def rows(results):
    for name, column, curve in (("pull", "last_axial", SIGAX), ("shear", "last_shear", SIGTAU)):
        for rate in RATES:
            weld = readers.weld(results[f"toyota_{name}_{rate:g}"])
            yield f"{name} at {rate:g} 1/s: stress at failure [MPa]", float(weld[column]) / disc(DIAMETER), strength(curve, rate), 5e-3, "the curve"


def draw(results):
    import figures
    figure, ((strain, over),) = figures.grid(1, 2, (9.6, 3.4))
    for rate, colour in zip(RATES, figures.COLOURS):
        history = readers.swforc(results[f"toyota_pull_{rate:g}"])[::10]
        strain.plot([1e3 * rate * row[0] for row in history], [row[1] / disc(DIAMETER) for row in history], color=colour, label=f"{rate:g} 1/s")
        strain.plot(1e3 * rate * history[-1][0], history[-1][1] / disc(DIAMETER), "x", color=colour)
    strain.set(xlabel="strain, 1/1000", ylabel="axial stress, MPa", xlim=(0, None), ylim=(0, None))
    strain.legend()
    for name, column, curve, colour in (("pull", "last_axial", SIGAX, figures.BLUE), ("shear", "last_shear", SIGTAU, figures.RED)):
        fine = [0.1 * 10 ** (i / 50.0) for i in range(200)]
        over.plot(fine, [strength(curve, r) for r in fine], color=colour, linewidth=1.0, label="SIGAX" if name == "pull" else "SIGTAU")
        over.plot(RATES, [float(readers.weld(results[f"toyota_{name}_{r:g}"])[column]) / disc(DIAMETER) for r in RATES], "o", color=colour,
                  markersize=4)
    over.set(xlabel="strain rate, 1/s", ylabel="stress at failure, MPa", xscale="log", ylim=(0, None))
    over.legend(loc="upper left")
    return figure
