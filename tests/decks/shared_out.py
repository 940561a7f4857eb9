# SPDX-License-Identifier: Apache-2.0
"""Decks for runs over several ranks: what is deformable, and supports, motions, loads; no contact, so that nodes are shared out too."""
import random
import subprocess
import sys

from few_elements import CORNERS, card, curve, nodes, part
from nugget_command import SOURCE

STEEL = "*MAT_PIECEWISE_LINEAR_PLASTICITY\n" + card(1, 7.85e-9, 2.1e5, 0.3, 250.0, 1000.0, "{fail}") + card(40.0, 5.0) + card(0.0) + card(0.0)
FILES = ("GLSTAT", "MATSUM", "NODOUT", "ELOUT", "SPCFORC", "SECFORC", "BNDOUT")


def weak_double_hat(folder):
    """The double hat of the examples with welds that fail soon."""
    subprocess.run([sys.executable, str(SOURCE / "examples" / "double_hat" / "make.py"), str(folder)], check=True)
    text = (folder / "double_hat.k").read_text(encoding="ascii")
    strong = "    6000.0    9000.0    9000.0       0.0   20000.0   20000.0       0.0\n"
    assert strong in text
    return text.replace(strong, "     300.0     400.0     400.0       0.0   20000.0   20000.0      10.0\n")


def databases(interval, states, strains=True):
    text = "".join(f"*DATABASE_{name}\n" + card(interval, 3) for name in FILES)
    return text + "*DATABASE_BINARY_D3PLOT\n" + card(states) + ("*DATABASE_EXTENT_BINARY\n" + card("", "", "", 1) if strains else "")


def tube(around=24, along=30, *, fail=0.0, mass_step=0.0, elform=2, dtmin=0.0, end=4.0e-4):
    """A crushed square tube of thin shells with noise in its nodes: held at one end, driven at the other; a nodal force and a pressure
    beside. A section through it, histories of nodes and shells."""
    draw = random.Random(3)
    side, height = 60.0, 150.0
    number = lambda i, j: 1 + i % around + around * j  # noqa: E731
    def place(i, j):
        corner, along_side = divmod(4 * i, around)
        s = side * (along_side / around - 0.5)
        x, y = ((s, -side / 2), (side / 2, s), (-s, side / 2), (-side / 2, -s))[corner]
        noise = 0.05 if 0 < j < along else 0.0
        return (x + noise * draw.uniform(-1, 1), y + noise * draw.uniform(-1, 1), height * j / along)
    places = [place(i, j) for j in range(along + 1) for i in range(around)]
    shells = [(number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)) for j in range(along) for i in range(around)]
    base, top = [number(i, 0) for i in range(around)], [number(i, along) for i in range(around)]
    def node_set(identity, members):
        return "*SET_NODE_LIST\n" + card(identity) + "".join(card(*members[k:k + 8]) for k in range(0, len(members), 8))
    middle = around * (along // 2)
    text = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(end, "", dtmin or "") + "*CONTROL_TIMESTEP\n" + card(0.0, 0.9, 0, 0.0, mass_step or "", "", 11 if dtmin else "")
    text += databases(end / 40, end / 4) + STEEL.replace("{fail}", str(fail)).replace(f"{'{fail}':>10}", f"{fail:>10}")
    text += f"*SECTION_SHELL\n{card(1, elform, 0.8333, 3)}{card(1.2, 1.2, 1.2, 1.2)}" + part(1) + nodes(places)
    text += "*ELEMENT_SHELL\n" + "".join(f"{e:8}{1:8}" + "".join(f"{n:8}" for n in q) + "\n" for e, q in enumerate(shells, 1))
    text += node_set(1, base) + node_set(2, top) + node_set(3, base + [number(i, 1) for i in range(around)])
    text += "*SET_SHELL_LIST\n" + card(4) + "".join(card(*range(k, min(k + 8, around + 1))) for k in range(1, around + 1, 8))
    text += "*BOUNDARY_SPC_SET\n" + card(1, 0, 1, 1, 1, 1, 1, 1)
    text += "*BOUNDARY_PRESCRIBED_MOTION_SET\n" + card(2, 3, 0, 1, -1.0) + "*BOUNDARY_SPC_SET\n" + card(2, 0, 1, 1, 0, 1, 1, 1)
    text += curve(1, (0.0, 0.0), (0.05 * end, 15000.0), (10.0, 15000.0)) + curve(2, (0.0, 1.0), (10.0, 1.0))
    text += "*LOAD_NODE_POINT\n" + card(middle + 3, 1, 2, 400.0)
    text += "*LOAD_SEGMENT\n" + card(2, 0.5, 0.0, *shells[around * (along // 2) + 5])
    text += "*DATABASE_HISTORY_NODE\n" + card(middle + 1, middle + around // 2, number(2, along - 1)) + "*DATABASE_HISTORY_SHELL\n" + card(1, len(shells) // 2, len(shells))
    text += "*DATABASE_CROSS_SECTION_SET\n" + card(3, "", "", 4)
    return text + "*END\n"


def switched_tube():
    """The tube, in which a pressure, the motion and shells are turned on and off by a force, a stress and an acceleration."""
    text = tube().replace("*BOUNDARY_SPC_SET\n", "*BOUNDARY_SPC_SET_ID\n" + f"{41:10}base\n", 1)
    text = text.replace("*BOUNDARY_PRESCRIBED_MOTION_SET\n", "*BOUNDARY_PRESCRIBED_MOTION_SET_ID\n" + f"{42:10}top\n")
    text = text.replace("*LOAD_SEGMENT\n", "*LOAD_SEGMENT_ID\n" + f"{43:10}side\n")
    sensors = ("*SENSOR_DEFINE_FORCE\n" + card(1, "SPC", 41, "Z") + "*SENSOR_DEFINE_ELEMENT\n" + card(2, "SHELL", 360, "VM", "STRESS", "TOP")
               + "*SENSOR_DEFINE_NODE\n" + card(3, 556, 0, 0, 0, "ACC") + "*SENSOR_DEFINE_CALC-MATH\n" + card(4, "MAX", 3))
    switches = ("*SENSOR_SWITCH\n" + card(1, "SENSOR", 1, "GT", 30000.0) + card(2, "SENSOR", 2, "GT", 400.0, 0, 2e-5)
                + card(3, "SENSOR", 4, "GT", 1e7, 0, 0.0, 5e-5))
    controls = ("*SENSOR_CONTROL\n" + card(1, "PRESSURE", 43, 1) + card("OFF", 1) + card(2, "PRESC-MOT", 42) + card("ON", 2)
                + card(3, "ELESET", 4, 0, 0, "SHELL") + card("ON", 3))
    return text.replace("*END\n", sensors + switches + controls + "*END\n")


def block(n=6, *, elform=1, ihq=6, speed=60000.0, end=6.0e-5):
    """n x n x 2n bricks that fly into supports under their lowest face, with beams along an edge and tetrahedra on top."""
    draw = random.Random(5)
    tall, size = 2 * n, 5.0
    number = lambda i, j, k: 1 + i + (n + 1) * (j + (n + 1) * k)  # noqa: E731
    noise = lambda: 0.2 * draw.uniform(-1, 1)  # noqa: E731
    places = [(size * i + noise(), size * j + noise(), size * k + (noise() if k else 0.0)) for k in range(tall + 1) for j in range(n + 1) for i in range(n + 1)]
    bricks = [[number(i + a, j + b, k + c) for a, b, c in CORNERS] for k in range(tall) for j in range(n) for i in range(n)]
    peak = len(places) + 1
    places.append((size * n / 2, size * n / 2, size * (tall + 1)))
    tets = []
    for j in range(n):
        for i in range(n):
            q = [number(i, j, tall), number(i + 1, j, tall), number(i + 1, j + 1, tall), number(i, j + 1, tall)]
            tets += [(q[0], q[1], q[2], peak), (q[0], q[2], q[3], peak)]
    beams = [(number(0, 0, k), number(0, 0, k + 1), number(1, 0, k)) for k in range(tall)]
    text = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(end) + "*CONTROL_TIMESTEP\n" + card(0.0, 0.8)
    text += databases(end / 30, end / 3, strains=False) + STEEL.replace(f"{'{fail}':>10}", f"{0.0:>10}")
    text += f"*SECTION_SOLID\n{card(1, elform)}*SECTION_SOLID\n{card(2, 10)}*SECTION_BEAM\n{card(3, 1)}{card(2.0, 2.0, 2.0, 2.0)}"
    text += "*HOURGLASS\n" + card(1, ihq, 0.1)
    text += "*PART\nbricks\n" + card(1, 1, 1, 0, 1) + "*PART\ntetrahedra\n" + card(2, 2, 1) + "*PART\nbeams\n" + card(3, 3, 1) + nodes(places)
    text += "*ELEMENT_SOLID\n" + "".join(f"{e:8}{1:8}" + "".join(f"{m:8}" for m in b) + "\n" for e, b in enumerate(bricks, 1))
    text += "".join(f"{10000 + e:8}{2:8}" + "".join(f"{m:8}" for m in (*t, *4 * t[3:])) + "\n" for e, t in enumerate(tets))
    text += "*ELEMENT_BEAM\n" + "".join(f"{20000 + e:8}{3:8}" + "".join(f"{m:8}" for m in b) + "\n" for e, b in enumerate(beams))
    text += "*BOUNDARY_SPC_NODE\n" + "".join(card(number(i, j, 0), 0, 1, 1, 1, 1, 1, 1) for j in range(n + 1) for i in range(n + 1))
    text += "*INITIAL_VELOCITY_NODE\n" + "".join(card(m, 0.0, 0.0, -speed) for m in range((n + 1) ** 2 + 1, len(places) + 1))
    return text + "*DATABASE_HISTORY_SOLID\n" + card(1, len(bricks)) + "*DATABASE_HISTORY_NODE\n" + card(peak, number(n, n, n)) + "*END\n"


def stacks_of_bricks(n=6, *, ignore=0, fail=0.05, speed=2.0e5, end=6.0e-5):
    """Two stacks of bricks that break in an eroding contact: the upper one, askew, starts a little inside the lower one and flies down."""
    draw, size, overlap = random.Random(8), 5.0, 0.3
    text = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(end) + "*CONTROL_TIMESTEP\n" + card(0.0, 0.7) + databases(end / 30, end / 3, strains=False)
    text += STEEL.replace(f"{'{fail}':>10}", f"{fail:>10}") + "*SECTION_SOLID\n" + card(1, 1) + "*HOURGLASS\n" + card(1, 4, 0.05)
    places, bricks = [], []
    for stack, (tall, base) in enumerate(((4, 0.0), (3, 4 * size - overlap))):
        first, shift = len(places) + 1, 0.4 * size * stack
        number = lambda i, j, k: first + i + (n + 1) * (j + (n + 1) * k)  # noqa: E731, B023
        places += [(size * i + shift + 0.3 * draw.random(), size * j + shift + 0.3 * draw.random(), base + size * k + 0.2 * draw.random() * (k > 0))
                   for k in range(tall + 1) for j in range(n + 1) for i in range(n + 1)]
        bricks += [(stack + 1, [number(i + a, j + b, k + c) for a, b, c in CORNERS]) for k in range(tall) for j in range(n) for i in range(n)]
        text += f"*PART\nstack {stack + 1}\n" + card(stack + 1, 1, 1, 0, 1)
    upper = (n + 1) ** 2 * 5 + 1
    text += nodes(places) + "*ELEMENT_SOLID\n" + "".join(f"{e:8}{p:8}" + "".join(f"{m:8}" for m in b) + "\n" for e, (p, b) in enumerate(bricks, 1))
    text += "*BOUNDARY_SPC_NODE\n" + "".join(card(m, 0, 1, 1, 1) for m in range(1, (n + 1) ** 2 + 1))
    text += "*INITIAL_VELOCITY_NODE\n" + "".join(card(m, 0.0, 0.0, -speed) for m in range(upper, len(places) + 1))
    text += "*CONTACT_ERODING_SINGLE_SURFACE\n" + card(0) + card(0.2, 0.2) + card("") + card(0, 1, 1)
    if ignore is not None:
        text += card(1) + card("") + card(ignore)
    text += "*DATABASE_RCFORC\n" + card(end / 30, 3)
    return text + "*DATABASE_HISTORY_SOLID\n" + card(1, len(bricks)) + "*DATABASE_HISTORY_NODE\n" + card(1, len(places)) + "*END\n"
