# SPDX-License-Identifier: Apache-2.0
"""Writes the axial crush of a spot-welded top-hat column with welds of several strengths: hat_sound.k, hat_half.k, ...

    python3 examples/hat_crush/make.py FOLDER [CRUSH [DENT_AT]]

CRUSH: by how many mm, 120 if not given. DENT_AT: how far from the front the dent stands, 20 mm if not given. Units: mm, t, s, N, MPa. No dependencies; the same bytes at every call.
"""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import crushing  # noqa: E402

TOP, WEB, FLANGE, THICKNESS = 60.0, 48.0, 18.0, 1.2
LENGTH = 288.0
SIZE = 4.0            # of an element; the flange has four of 4.5 mm across
GAP = THICKNESS       # between the mid-surfaces of flange and plate: they touch
PITCH, DIAMETER = 36.0, 6.0
YIELD = 300.0
DENT_AT, DENT_REACH, DENT_DEPTH = 20.0, 15.0, 0.75
HAT, PLATE, WELDS = 1, 3, 4  # parts; 2 is the pushing end
# Strength of a weld in tension and in shear [N]; None: it does not fail.
STRENGTH = {"sound": None, "good": (3000.0, 4500.0), "fair": (2000.0, 3000.0), "weak": (1500.0, 2250.0), "poor": (1000.0, 1500.0), "bad": (300.0, 450.0)}


def line(points, counts):
    """Points along straight walls, each with the wall it is inside of, or None at a corner or an edge."""
    found = [(*points[0], None)]
    for w, ((xa, ya), (xb, yb), count) in enumerate(zip(points, points[1:], counts)):
        for i in range(1, count + 1):
            s = i / count
            found.append((xa + s * (xb - xa), ya + s * (yb - ya), w if i < count else None))
    return found


def sheets(dent_at):
    """Nodes, shells and rear edge of hat and plate. The dent goes in on the top and out on webs and plate."""
    n = lambda width: round(width / SIZE)  # noqa: E731
    a, b = TOP / 2.0, TOP / 2.0 + FLANGE
    hat = line([(-b, 0.0), (-a, 0.0), (-a, WEB), (a, WEB), (a, 0.0), (b, 0.0)],
               [n(FLANGE), n(WEB), n(TOP), n(WEB), n(FLANGE)])
    plate = line([(-b, -GAP), (-a, -GAP), (a, -GAP), (b, -GAP)], [n(FLANGE), n(TOP), n(FLANGE)])
    rows = round(LENGTH / SIZE)
    nodes, shells, rear = {}, {}, []
    for part, section in ((HAT, hat), (PLATE, plate)):
        first = 10000 * part
        number = lambda j, k: first + j * len(section) + k + 1  # noqa: E731,B023
        for j in range(rows + 1):
            z = LENGTH * j / rows
            d = crushing.dent(z, dent_at, DENT_REACH, DENT_DEPTH)
            for k, (x, y, wall) in enumerate(section):
                if part == HAT and wall == 2:
                    y -= d
                elif part == HAT and wall in (1, 3):
                    x += d * (-1.0 if wall == 1 else 1.0) * math.sin(math.pi * y / WEB)
                elif part == PLATE and wall == 1:
                    y += d * math.sin(math.pi * (x + a) / TOP) * -1.0
                nodes[number(j, k)] = (x, y, z)
        for j in range(rows):
            for k in range(len(section) - 1):
                shells[len(shells) + 1] = (part, (number(j, k), number(j, k + 1), number(j + 1, k + 1), number(j + 1, k)))
        rear += [number(rows, k) for k in range(len(section))]
    return nodes, shells, rear


def welds(nodes):
    beams = {}
    for x in (-(TOP + FLANGE) / 2.0, (TOP + FLANGE) / 2.0):
        for i in range(round(LENGTH / PITCH)):
            n = 800001 + 2 * len(beams)
            z = PITCH / 2.0 + i * PITCH
            nodes[n], nodes[n + 1] = (x, 0.0, z), (x, -GAP, z)
            beams[700001 + len(beams)] = (WELDS, (n, n + 1))
    return beams


def make(strength, crush=120.0, dent_at=DENT_AT):
    nodes, shells, rear = sheets(dent_at)
    beams = welds(nodes)
    perimeter = 2.0 * (TOP + WEB + 2.0 * FLANGE)
    mean = 8.22 * YIELD * THICKNESS ** (5 / 3) * perimeter ** (1 / 3) / 1000.0
    says = "that do not fail" if strength is None else f"of {strength[0]:g} N in tension, {strength[1]:g} N in shear"
    d = crushing.begin(f"Top-hat column, axial crush, welds {says}",
                       f"""
A hat {TOP:g} x {WEB:g} with flanges of {FLANGE:g} mm and a closing plate, {THICKNESS:g} mm thick, {len(beams)} spot welds every {PITCH:g} mm.
Mean force of the closed form (White and Jones), welds that hold: 8.22 sigma0 t^(5/3) L^(1/3) = {mean:.1f} kN.""",
                       crush, step=4.0e-7)
    crushing.sheets(d, THICKNESS, YIELD, [(HAT, "hat"), (PLATE, "plate")])
    crushing.cap(d, nodes, shells, rear, LENGTH, TOP)
    d.comment("One beam a weld, tied to the sheets wherever the mesh lines may be.")
    d.part("spot welds", pid=WELDS, secid=WELDS, mid=WELDS)
    d.weld_section(WELDS, DIAMETER)
    d.keyword("MAT_SPOTWELD")
    d.card(mid=WELDS, ro=7.85e-9, e=210000.0, pr=0.3, sigy=1000.0, eh=1000.0, dt=0.0, tfail=0.0)
    normal, shear = strength or (0.0, 0.0)
    d.card(efail=0.0, nrr=normal, nrs=shear, nrt=shear, mrr=0.0, mss=0.0, mtt=0.0, nf=0.0)
    d.keyword("SET_PART_LIST")
    d.card(sid=1)
    d.ids([HAT, PLATE])
    d.tie_welds(WELDS, 1)
    d.keyword("DATABASE_SWFORC")
    d.card(dt=crush / crushing.SPEED / 240)
    crushing.wall_and_contact(d, LENGTH, [HAT, PLATE, WELDS], sheets=[HAT, PLATE])
    d.nodes(nodes)
    d.shells(shells)
    d.beams(beams)
    return d


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3, 4):
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for name, strength in STRENGTH.items():
        make(strength, *(float(a) for a in sys.argv[2:])).write(folder / f"hat_{name}.k")
