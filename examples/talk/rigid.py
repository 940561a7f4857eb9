# SPDX-License-Identifier: Apache-2.0
"""Rigid welds: two nodes that move as one body, and end brittly (force, time) or ductilely (plastic strain of the sheet).

The coupon of place.py with the mesh that has a node where the weld is, and *CONSTRAINED_SPOTWELD between the two nodes there.
"""
import math

import readers
from place import elongation, placement

NORMAL, SHEAR, TIME, STRAIN, END = 2000.0, 4000.0, 1.2e-3, 0.005, 1.8e-3
# SN, SS, N, M, TF, EP
FAILURE = {"rigid_holds": (0.0, 0.0, 0.0, 0.0, 1.0e20, 1.0e20), "rigid_force": (NORMAL, SHEAR, 2.0, 2.0, 1.0e20, 1.0e20),
           "rigid_time": (0.0, 0.0, 0.0, 0.0, TIME, 1.0e20), "rigid_strain": (0.0, 0.0, 0.0, 0.0, 1.0e20, STRAIN)}
WHAT = {"rigid_holds": "does not fail", "rigid_force": "brittle, by force", "rigid_time": "brittle, at a time", "rigid_strain": "ductile"}


def welded_nodes():
    """Ids of the nodes of the upper and the lower strip at the weld."""
    nodes = {}
    for part in (placement.UPPER, placement.LOWER):
        placement.strip(part, "corner", nodes, {})
    return sorted(n for n, (x, y, _) in nodes.items() if abs(x) + abs(y) < 1e-9)


def deck(name):
    d, pair = placement.make("corner", welded=False, end_time=END), welded_nodes()
    sn, ss, n, m, tf, ep = FAILURE[name]
    d.keyword("CONSTRAINED_SPOTWELD_ID")
    d.card(wid=900)
    d.card(n1=pair[0], n2=pair[1], sn=sn, ss=ss, n=n, m=m, tf=tf, ep=ep)
    d.keyword("DATABASE_HISTORY_NODE")
    d.ids(pair)
    return d


def decks():
    beam = placement.make("centre", end_time=END)
    return {**{name: deck(name) for name in FAILURE}, "rigid_beam": beam}


def hourglass_share(folder):
    """Hourglass energy over the internal energy."""
    energy = readers.summary(folder)["energy"]
    return energy["hourglass"] / energy["internal"]


def strains_around_failure(folder):
    """Largest plastic strain of the shells in the last state before the weld opened and in the first one after it."""
    opened = float(readers.weld(folder)["failure_time"])
    states = [(time, strain.max()) for _, _, strain, _, _, time in readers.states(folder)]
    return max(s for t, s in states if t <= opened), min(s for t, s in states if t > opened)


def rows(results):
    held, by_force, at_time, by_strain, beam = (results[name] for name in (*FAILURE, "rigid_beam"))
    upper, lower = (readers.nodout(held)[n] for n in welded_nodes())
    turned, lever = upper[-1][2][1], placement.THICKNESS
    yield "turning of the lower node over that of the upper", lower[-1][2][1] / turned, 1.0, 1e-4, "one body"
    apart = lever * math.sin(turned)
    yield "its way along x beyond the upper node's [mm]", lower[-1][1][0] - upper[-1][1][0], -apart, 1e-3, "the lever turns with the body"
    weld = readers.weld(by_force)
    n, v = float(weld["last_axial"]), float(weld["last_shear"])
    yield "brittle, by force: (N/SN)² + (V/SS)² at the end", (max(n, 0.0) / NORMAL)**2 + (v / SHEAR)**2, 1.0, 0.01, "the card"
    yield "brittle, at a time: TF [s]", float(readers.weld(at_time)["failure_time"]), TIME, 1e-3, "the card"
    before, after = strains_around_failure(by_strain)
    yield "ductile: strain before it opened is below EP, after above", float(before <= STRAIN <= after), 1.0, 0.0, "the card"
    steps = [readers.summary(folder)["time_step"]["first"] for folder in (held, beam)]
    side = (placement.WIDTH / 7.0 / 2.0) / math.sqrt(210000.0 / (7.85e-9 * (1.0 - 0.3**2)))  # of the half elements at the strips' edges
    yield "step over that of the sheets", steps[0] / (0.9 * side), 1.0, 0.01, "the weld does not control it"
    yield "the step of the beam over that", steps[1] / (0.9 * placement.THICKNESS / math.sqrt(210000.0 / 7.85e-9)), 1.0, 1e-3, "L / c"
    yield "hourglassing is five times that of a beam, or more", float(hourglass_share(held) > 5.0 * hourglass_share(beam)), 1.0, 0.0, "the talk"


def draw(results):
    import figures
    figure, ((force, hourglass),) = figures.grid(1, 2, (9.6, 3.4))
    for (name, what), colour in zip(WHAT.items(), figures.COLOURS):
        points = [(u, math.hypot(n, v) / 1e3) for _, u, n, v, _ in elongation(results[name])][::2]
        if name != "rigid_holds":
            points.append((points[-1][0], 0.0))
        force.plot(*zip(*points), color=colour, label=what, linewidth=1.2)
    force.set(xlabel="elongation of the coupon, mm", ylabel="force of the weld, kN", ylim=(0, 6.5))
    force.legend(ncols=2, loc="upper left")
    shares = [100.0 * hourglass_share(results[name]) for name in ("rigid_holds", "rigid_beam")]
    hourglass.bar(("rigid weld,\non nodes", "weld beam,\nover a centre"), shares, width=0.5, color=figures.BLUE)
    hourglass.set(ylabel="hourglass energy over internal, %")
    return figure
