# SPDX-License-Identifier: Apache-2.0
"""Torsion of a weld becomes in-plane forces of the sheet: a beam without and with the treatment, a brick without any.

Two sheets of 3 x 3 shells of 10 mm, 1 mm thick, a weld of 6 mm over the middle. The lower one is held at all its nodes, the upper one is
turned by 1e-4 about the weld's axis.
"""
import math

import readers
from sheets import SHEAR_MODULUS, Model, disc, smooth

DIAMETER, LENGTH, ANGLE, SIZE = 6.0, 1.0, 1.0e-4, 10.0
TORQUE = SHEAR_MODULUS * math.pi * DIAMETER**4 / 32.0 * ANGLE / LENGTH  # of the beam, G J / L times the angle
SQUARE = SHEAR_MODULUS * disc(DIAMETER)**2 / 6.0 * ANGLE / LENGTH  # of a brick of the same area
MIDDLE = (1006, 1007, 1011, 1010)  # corners of the middle shell
FORMS = {"torsion_plain": "beam, CONTACT_SPOTWELD", "torsion_with": "beam, _WITH_TORSION", "torsion_brick": "brick, CONTACT_SPOTWELD"}


def deck(name):
    m = Model(f"Torsion: {FORMS[name]}", 2.0e-4)
    m.record(2.0e-6, "SPCFORC", "SWFORC")
    m.hold(1, m.sheet(1, 1.0, (0, 0, 0), 3, 3, SIZE))
    turned = m.sheet(2, 1.0, (0, 0, LENGTH), 3, 3, SIZE)
    m.hold(2, turned, "zuvw")
    for i, node in enumerate(turned):
        x, y, _ = m.nodes[node]
        m.deck.node_set(3 + i, [node])
        m.drive(3 + i, 1, smooth(1.0e-4), -ANGLE * (y - 15))
        m.drive(3 + i, 2, smooth(1.0e-4), ANGLE * (x - 15))
    m.spotweld(9)
    if name == "torsion_brick":
        m.brick_part(9)
        half = 0.5 * math.sqrt(disc(DIAMETER))
        m.prism(9, 9001, (15 - half, 15 + half), (15 - half, 15 + half), (0.0, LENGTH))
    else:
        m.beam_part(9, DIAMETER)
        m.beam(9001, 9, (15, 15, 0), (15, 15, LENGTH))
    m.tie(9, [1, 2], "_WITH_TORSION" if name == "torsion_with" else "")
    return m.finished()


def decks():
    return {name: deck(name) for name in FORMS}


def forces(folder):
    """{node of the sheet: (place from the weld's axis, force of its support)}"""
    return {n: ((SIZE * ((n - 1001) % 4) - 15.0, SIZE * ((n - 1001) // 4) - 15.0), f) for n, f in readers.reactions(folder).items() if n < 2000}


def torque(folder):
    """About the weld's axis, of the supports of the sheet."""
    return sum(x * f[1] - y * f[0] for (x, y), f in forces(folder).values())


def rows(results):
    plain, treated, brick = results.values()
    yield "beam, plain: moment on the sheet [N mm]", torque(plain), 0.0, 1e-9, "shells have no drilling stiffness"
    yield "beam, with torsion: moment on the sheet [N mm]", -torque(treated), TORQUE, 1e-3, "G J / L times the angle"
    edge = TORQUE / (2.0 * math.sqrt(2.0) * SIZE)
    for node in MIDDLE:
        yield f"beam, with torsion: force at node {node} [N]", math.hypot(*forces(treated)[node][1]), edge, 1e-3, "M / (2 √2 a)"
    told = abs(readers.swforc(brick)[-1][5])
    yield "brick: moment on the sheet over the weld's", abs(torque(brick)) / told, 1.0, 1e-3, "equilibrium"
    yield "brick: moment on the sheet [N mm]", abs(torque(brick)), SQUARE, 1e-3, "G a⁴/6 / L times the angle, a brick in twist"


def draw(results):
    import figures
    figure, (axes,) = figures.grid(1, 3, (9.6, 3.4))
    longest = max(math.hypot(*f[:2]) for folder in results.values() for _, f in forces(folder).values())
    for axis, (name, folder) in zip(axes, results.items()):
        for i in range(4):
            axis.plot((-15, 15), (10 * i - 15,) * 2, (10 * i - 15,) * 2, (-15, 15), color="0.6", linewidth=0.8)
        for (x, y), (fx, fy, _) in forces(folder).values():
            if math.hypot(fx, fy) > 1e-6 * longest:  # what the weld does to the sheet: against the support
                axis.annotate("", (x - 9 * fx / longest, y - 9 * fy / longest), (x, y), arrowprops={"arrowstyle": "->", "color": figures.BLUE})
        axis.add_patch(figures.circle((0, 0), DIAMETER / 2.0))
        axis.set(aspect="equal", xticks=[], yticks=[], xlim=(-19, 19), ylim=(-19, 19), frame_on=False,
                 title=f"{FORMS[name]}\nmoment on the sheet {abs(torque(folder)):.0f} N mm")
    return figure
