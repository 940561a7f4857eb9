# SPDX-License-Identifier: Apache-2.0
"""Time step of a weld over its length; mass and stiffness that give it a microsecond.

A weld of 5 mm between two sheets of 3 x 3 shells of 20 mm, thick enough to keep to the weld's length: L = t.
"""
import math

import readers
from sheets import POISSON, YOUNG, Model, disc

DENSITY, DIAMETER, TARGET, TSSFAC = 7.89e-9, 5.0, 1.0e-6, 0.9  # density of the talk's example
LENGTHS = (0.5, 1.0, 1.5, 2.0, 3.0)
SPEED = math.sqrt(YOUNG / DENSITY)


def deck(length, brick=False, dt=0.0, dt2ms=0.0, young=YOUNG):
    m = Model(f"Step of a weld of {length:g} mm", 2.0e-6, TSSFAC, dt2ms)
    m.record(1.0e-6, "GLSTAT", "SWFORC")
    for pid in (1, 2):
        m.sheet(pid, length, (0, 0, (pid - 1) * length), 3, 3, 20.0)
    m.deck.keyword("MAT_SPOTWELD")
    m.deck.card(mid=9, ro=DENSITY, e=young, pr=POISSON, sigy=1.0e6, eh=0.0, dt=dt)
    m.deck.card(efail=0.0)
    if brick:
        m.brick_part(9)
        half = 0.5 * math.sqrt(disc(DIAMETER))
        m.prism(9, 9001, (30 - half, 30 + half), (30 - half, 30 + half), (0.0, length))
    else:
        m.beam_part(9, DIAMETER)
        m.beam(9001, 9, (30, 30, 0), (30, 30, length))
    m.tie(9, [1, 2])
    return m.finished()


def stiffness(length):
    """Young's modulus that gives the target without mass: L^2 rho / dt^2."""
    return round(length**2 * DENSITY / TARGET**2, 4)


def decks():
    found = {}
    for length in LENGTHS:
        found |= {f"step_beam_{length:g}": deck(length), f"step_brick_{length:g}": deck(length, brick=True),
                  f"step_mass_{length:g}": deck(length, dt=TARGET), f"step_soft_{length:g}": deck(length, young=stiffness(length))}
    return found | {"step_dt2ms": deck(0.5, dt2ms=-TARGET), "step_both": deck(0.5, dt=2.0e-7, dt2ms=-TARGET)}


def beam_step(length):
    return length / SPEED


def brick_step(length):
    """V / A_max over Q + sqrt(Q^2 + c^2) with Q = 0.06 c, as of a brick at rest."""
    wave = math.sqrt(YOUNG * (1.0 - POISSON) / ((1.0 + POISSON) * (1.0 - 2.0 * POISSON) * DENSITY))
    return min(length, math.sqrt(disc(DIAMETER))) / wave / (0.06 + math.sqrt(1.0 + 0.06**2))


def step(folder):
    return readers.summary(folder)["time_step"]["first"] / TSSFAC


def rows(results):
    yield "0.5 mm: step, the talk's number [s]", step(results["step_beam_0.5"]), 9.69168e-8, 1e-4, "the talk"
    for length in LENGTHS:
        yield f"{length:g} mm: step of a beam [s]", step(results[f"step_beam_{length:g}"]), beam_step(length), 1e-4, "L / c"
        yield f"{length:g} mm: step of a brick [s]", step(results[f"step_brick_{length:g}"]), brick_step(length), 1e-4, "L_e / (Q + √(Q² + c²))"
        mass = readers.weld(results[f"step_mass_{length:g}"])
        yield (f"{length:g} mm: mass over its own for 1 µs", 1.0 + float(mass["mass_by_dt"]) / float(mass["mass"]), (TARGET / beam_step(length))**2,
               1e-4, "(DT / step)²")
        yield f"{length:g} mm: step with E = L² ρ / DT² [s]", step(results[f"step_soft_{length:g}"]), TARGET, 1e-4, "the talk"
    yield "0.5 mm: E for 1 µs [MPa]", stiffness(0.5), 1972.0, 1e-3, "the talk"
    scaled = readers.weld(results["step_dt2ms"])
    yield ("0.5 mm: mass over its own by DT2MS", 1.0 + float(scaled["mass_by_dt2ms"]) / float(scaled["mass"]),
           (TSSFAC * TARGET / beam_step(0.5))**2, 1e-4, "(DT2MS TSSFAC / step)²")
    yield "0.5 mm: step with DT2MS [s]", step(results["step_dt2ms"]), TARGET, 1e-6, "DT2MS"
    yield "0.5 mm: step with DT beside DT2MS [s]", step(results["step_both"]), TARGET, 1e-6, "DT2MS; a warning says DT = 0"


def draw(results):
    import figures
    figure, ((steps, costs),) = figures.grid(1, 2, (9.6, 3.4))
    lengths = [0.2 + 0.02 * i for i in range(156)]
    for name, formula, colour in (("beam", beam_step, figures.BLUE), ("brick", brick_step, figures.RED)):
        steps.plot(lengths, [1e6 * formula(x) for x in lengths], color=colour, linewidth=1.0, label=name)
        steps.plot(LENGTHS, [1e6 * step(results[f"step_{name}_{x:g}"]) for x in LENGTHS], "o", color=colour, markersize=4)
    costs.plot(lengths, [(TARGET / beam_step(x))**2 for x in lengths], color=figures.BLUE, linewidth=1.0, label="more mass, times")
    masses = [readers.weld(results[f"step_mass_{x:g}"]) for x in LENGTHS]
    costs.plot(LENGTHS, [1.0 + float(w["mass_by_dt"]) / float(w["mass"]) for w in masses], "o", color=figures.BLUE, markersize=4)
    costs.plot(lengths, [YOUNG / (x**2 * DENSITY / TARGET**2) for x in lengths], color=figures.RED, linewidth=1.0, linestyle="--",
               label="less stiffness, divided by")
    steps.set(xlabel="length of the weld, mm", ylabel="step, µs", xlim=(0, 3.3), ylim=(0, None))
    costs.set(xlabel="length of the weld, mm", ylabel="for a step of 1 µs", yscale="log", xlim=(0, 3.3))
    steps.legend()
    costs.legend()
    return figure
