# SPDX-License-Identifier: Apache-2.0
"""Hourglass types 1 to 6 in bending: a bar of two bricks under a couple that rises and stays.

10 x 10 x 100 mm along z, its root simply held, so that the tip bends by M L^2 / 2 E I. The root's nodes keep their plane.
"""
import readers
from sheets import POISSON, YOUNG, Model, smooth

SIDE, LENGTH, BRICKS = 10.0, 100.0, 2
RISE, END = 12.0e-3, 18.0e-3  # [s]
EXACT = LENGTH**2 / (2.0 * YOUNG * SIDE**4 / 12.0)  # deflection for a couple of 1 N mm
# Name: ELFORM, IHQ, QM, couple [N mm].
BARS = {"hourglass_1": (1, 1, 0.1, 20.0), "hourglass_2": (1, 2, 0.1, 20.0), "hourglass_3": (1, 3, 0.1, 20.0),
        "hourglass_4": (1, 4, 0.1, 1e4), "hourglass_4_small": (1, 4, 0.01, 1e3),
        "hourglass_5": (1, 5, 0.1, 1e4), "hourglass_5_small": (1, 5, 0.01, 1e3), "hourglass_6": (1, 6, 1.0, 1e4),
        "hourglass_6_small": (1, 6, 0.1, 1e3), "hourglass_full": (2, 1, 0.1, 1e4)}


def deck(name):
    elform, ihq, qm, couple = BARS[name]
    m = Model(f"A bar of bricks in bending: ELFORM {elform}, hourglass type {ihq}, QM {qm:g}", END, tssfac=0.6)
    m.record(END / 200.0, "NODOUT", "GLSTAT")
    m.brick_part(9, elform, ihq, qm)
    m.elastic(9)
    planes = m.prism(9, 9001, (-SIDE / 2, SIDE / 2), (-SIDE / 2, SIDE / 2), [LENGTH * k / BRICKS for k in range(BRICKS + 1)])
    root, tip = planes[0], planes[-1]
    m.hold(1, root, "z")
    m.hold(2, [root[0]], "xy")
    m.hold(3, [root[1]], "y")
    m.watch(tip)
    m.deck.curve(1, smooth(RISE))
    m.deck.keyword("LOAD_NODE_POINT")
    for node in tip:
        side = 1.0 if m.nodes[node][0] > 0.0 else -1.0
        m.deck.card(nid=node, dof=3, lcid=1, sf=-0.5 * couple / SIDE * side)
    return m.finished()


def decks():
    return {name: deck(name) for name in BARS}


def history(name, folder):
    """[(time, deflection of the tip over that of the closed form)]"""
    tip = list(readers.nodout(folder).values())
    exact = EXACT * BARS[name][3]
    return [(at[0][0], sum(node[1][0] for node in at) / 4.0 / exact) for at in zip(*tip)]


def rows(results):
    over = {name: history(name, folder) for name, folder in results.items()}
    last = {name: h[-1][1] for name, h in over.items()}
    middle = {name: min(h, key=lambda p: abs(p[0] - 0.5 * (RISE + END)))[1] for name, h in over.items()}
    yield "type 6, QM 1: deflection over M L²/2EI", last["hourglass_6"], 1.0, 5e-3, "closed form"
    yield "type 6, QM 0.1: the same", last["hourglass_6_small"], 10.0, 5e-2, "closed form, over QM"
    for ihq in (4, 5):
        yield (f"type {ihq}: deflection for QM 0.01 over that for 0.1", last[f"hourglass_{ihq}_small"] / last[f"hourglass_{ihq}"], 10.0, 5e-2,
               "the talk: QM is a scale factor")
        yield f"type {ihq}: at rest in the end", last[f"hourglass_{ihq}"] / middle[f"hourglass_{ihq}"], 1.0, 5e-2, "the talk: a stiffness"
    for ihq in (1, 2, 3):
        gains = [over[f"hourglass_{ihq}"][i][1] for i in (140, 170, 200)]
        yield f"type {ihq}: bent in the last sixth over the one before", (gains[2] - gains[1]) / (gains[1] - gains[0]), 1.0, 0.1, "the talk: velocities only, so it creeps"
    yield "ELFORM 2: deflection over M L²/2EI", last["hourglass_full"], 1.0 / locking(), 5e-2, "bending and parasitic shear"


def locking():
    """Bending stiffness of a brick of ELFORM 2 over E I: with one pressure and free sides bending takes G I, and the shear that a straight-sided
    brick gets from bending G A L_e^2 / 12."""
    return (1.0 + (LENGTH / BRICKS / SIDE)**2) / (2.0 * (1.0 + POISSON))


def draw(results):
    import figures
    figure, ((slow, fast),) = figures.grid(1, 2, (9.6, 3.4))
    for name, label, colour in (("hourglass_6", "type 6, QM 1", figures.BLUE), ("hourglass_5", "type 5, QM 0.1", figures.GREEN),
                                ("hourglass_4_small", "type 4, QM 0.01", figures.RED), ("hourglass_full", "ELFORM 2", figures.GREY)):
        slow.plot(*zip(*[(1e3 * t, u) for t, u in history(name, results[name])[::2]]), color=colour, label=label, linewidth=1.2)
    for name, label, colour in (("hourglass_1", "type 1, QM 0.1", figures.BLUE), ("hourglass_3", "type 3, QM 0.1", figures.RED)):
        fast.plot(*zip(*[(1e3 * t, u) for t, u in history(name, results[name])[::2]]), color=colour, label=label, linewidth=1.2,
                  linestyle="-" if name == "hourglass_1" else "--")
    slow.axhline(1.0, color="0.3", linestyle="--", linewidth=1.0)
    for axis in (slow, fast):
        axis.set(xlabel="time, ms", ylabel="deflection over M L²/2EI", ylim=(0, None))
        axis.legend(loc="upper left")
    slow.set(yscale="log", ylim=(0.05, 20))
    return figure
