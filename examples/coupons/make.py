# SPDX-License-Identifier: Apache-2.0
"""Writes the three coupons in which spot welds are tested: lap shear, coach peel, cross tension.

    python3 examples/coupons/make.py FOLDER

For each coupon: the weld as a beam, as 1, 4 and 8 bricks, on nine elements across the sheets (lap_beam.k, lap_1.k, ...); the beam on seven,
whose elements are as large as the weld (lap_seven.k, and elastic: lap_elastic.k), of lap shear also on 5, 11, 13 and 15, and on 21 with a
rigid square as large as one of seven (lap_patch.k); one whose weld fails (lap_fails.k, peel_fails.k); and the beam over the centre of an element, on an edge and on a node of meshes of 3, 5 and 8 mm (lap_3mm_edge.k, ...). study.py runs them and draws
the curves. Units: mm, t, s, N, MPa.
"""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from coupon import THICKNESS, controls, grips, sheets, weld as weld_part  # noqa: E402
from writer import Deck, main  # noqa: E402

LOWER, UPPER, WELD = 1, 2, 3  # parts
PATCH = {"lap": 40.0, "peel": 40.0, "cross": 48.0}  # side of the square that both sheets share, the weld in its middle
STROKE = {"lap": 2.0, "peel": 12.0, "cross": 8.0}   # of the moving grip
DURATION = {"lap": 0.01, "peel": 0.06, "cross": 0.04}  # slow against the coupon's own vibration
PULL = {"lap": 1, "peel": 3, "cross": 3}            # degree of freedom of the moving grip
WELDS = {"beam": 0, "1": 1, "4": 4, "8": 8}         # bricks that replace the beam (RPBHX)
OVERS = {"centre": (1, 1), "edge": (1, 0), "corner": (0, 0)}  # odd or even number of elements along and across the patch


def spread(a, b, size):
    """Mesh lines from a to b, b left out, about `size` apart."""
    count = max(1, round(abs(b - a) / size))
    return [a + i * (b - a) / count for i in range(count)]


def cells(width, size, odd):
    """The odd or even number of elements that comes closest to `size`."""
    return min(range(2 - odd, 200, 2), key=lambda n: abs(width / n - size))


def sheet(path, across, first, part, nodes, shells):
    """A sheet swept over the points (x, y, z) of `path`, each moved along the vectors of `across`. Returns number(i, j)."""
    number = lambda i, j: first + i * len(across) + j  # noqa: E731
    for i, p in enumerate(path):
        for j, a in enumerate(across):
            nodes[number(i, j)] = tuple(u + v for u, v in zip(p, a))
    for i in range(len(path) - 1):
        for j in range(len(across) - 1):
            shells[len(shells) + 1] = (part, (number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)))
    return lambda wanted: [number(i, j) for i, p in enumerate(path) if wanted(p) for j in range(len(across))]


def mesh(kind, size, over):
    """Nodes, shells, held nodes, pulled nodes. The weld is at the origin, its sheets at z = -t/2 and t/2."""
    nodes, shells = {}, {}
    odd = OVERS[over]
    half, z = PATCH[kind] / 2.0, THICKNESS / 2.0
    along = [-half + i * 2.0 * half / cells(2.0 * half, size, odd[0]) for i in range(cells(2.0 * half, size, odd[0]) + 1)]
    across = [-half + i * 2.0 * half / cells(2.0 * half, size, odd[1]) for i in range(cells(2.0 * half, size, odd[1]) + 1)]
    size = along[1] - along[0]
    if kind == "lap":  # the lower strip reaches to -x, the upper one is its mirror image; 30 mm of each are in a grip
        s = spread(-80.0, -50.0, size) + spread(-50.0, -half, size) + along
        held = sheet([(x, 0.0, -z) for x in s], [(0.0, y, 0.0) for y in across], 1001, LOWER, nodes, shells)
        pulled = sheet([(-x, 0.0, z) for x in s], [(0.0, -y, 0.0) for y in across], 4001, UPPER, nodes, shells)
        grip = lambda p: abs(p[0]) > 50.0 - 1e-6  # noqa: E731
    elif kind == "peel":  # two angles, leg on leg, with arms of 60 mm
        arm = spread(-60.0, 0.0, size)
        held = sheet([(-half, 0.0, h - z) for h in arm] + [(x, 0.0, -z) for x in along], [(0.0, y, 0.0) for y in across], 1001,
                     LOWER, nodes, shells)
        pulled = sheet([(-half, 0.0, z - h) for h in arm] + [(x, 0.0, z) for x in along], [(0.0, -y, 0.0) for y in across],
                       4001, UPPER, nodes, shells)
        grip = lambda p: abs(p[2]) > 60.0  # noqa: E731
    else:  # two strips of 120 mm, one along x, the other along y
        s = spread(-60.0, -40.0, size) + spread(-40.0, -half, size) + along
        s += [-x for x in reversed(spread(-60.0, -40.0, size) + spread(-40.0, -half, size))]
        held = sheet([(x, 0.0, -z) for x in s], [(0.0, y, 0.0) for y in across], 1001, LOWER, nodes, shells)
        pulled = sheet([(0.0, y, z) for y in s], [(-x, 0.0, 0.0) for x in across], 4001, UPPER, nodes, shells)
        grip = lambda p: max(abs(p[0]), abs(p[1])) > 40.0 - 1e-6  # noqa: E731
    return nodes, shells, held(grip), pulled(grip)


def make(kind, weld="beam", size=None, over="centre", elastic=False, nrr=0.0, nrs=0.0, stroke=None, hourglass=0.05, square=None):
    """A coupon. `weld`: beam, or the number of bricks; `size`: of the elements on the patch, by default a ninth of it; `hourglass`: QH;
    `square`: side of a rigid square in both sheets below the weld; such a coupon is pulled as fast, but only to `stroke`."""
    nodes, shells, held, pulled = mesh(kind, size or PATCH[kind] / 9.0, over)
    stroke = stroke or STROKE[kind]
    duration = DURATION[kind] * (stroke / STROKE[kind] if square else 1.0)
    nodes[7001], nodes[7002] = (0.0, 0.0, -THICKNESS / 2.0), (0.0, 0.0, THICKNESS / 2.0)

    d = Deck()
    d.keyword("KEYWORD")
    d.keyword("TITLE")
    d.text(f"{kind} coupon, weld as {weld if weld == 'beam' else weld + ' bricks'}, over the {over} of an element")
    controls(d, duration, hourglass)
    d.comment("istupd = 1: the sheets thin as they stretch.")
    d.keyword("CONTROL_SHELL")
    d.card(wrpang=20.0, esort=0, irnxx=-1, istupd=1)
    if WELDS[weld]:
        d.comment(f"Each weld beam becomes {weld} bricks of the same total cross-section.")
        d.keyword("CONTROL_SPOTWELD_BEAM")
        d.card(lct=0, lcs=0, t_ort=0, prtflg=0, t_ors=0, rpbhx=WELDS[weld])
    for name, interval in (("GLSTAT", duration / 100.0), ("SWFORC", duration / 1000.0), ("NODOUT", duration / 1000.0),
                           ("SPCFORC", duration / 1000.0), ("BINARY_D3PLOT", duration / 10.0)):
        d.keyword("DATABASE_" + name)
        d.card(dt=interval)
    d.comment("A node of the moving grip.")
    d.keyword("DATABASE_HISTORY_NODE")
    d.ids([pulled[0]])

    sheets(d, {LOWER: "lower sheet", UPPER: "upper sheet"}, elastic)
    weld_part(d, WELD, [LOWER, UPPER], "The nugget does not yield; dt is the step to which its density is scaled.", sigy=20000.0,
              nrr=nrr, nrs=nrs, dt=5.0e-7)
    rise = [i / 20.0 for i in range(21)]
    curve = [(0.2 * duration * s, 0.5 - 0.5 * math.cos(math.pi * s)) for s in rise] + [(2.0 * duration, 1.0)]
    d.comment("The velocity rises smoothly over the first fifth of the time.")
    grips(d, held, pulled, PULL[kind], curve, stroke / (0.9 * duration))

    if square:
        d.comment("A rigid square around the weld in each sheet.")
        for number, z in ((11, -THICKNESS / 2.0), (12, THICKNESS / 2.0)):
            inside = lambda x: x[2] == z and max(abs(x[0]), abs(x[1])) < 0.5 * square + 1e-6  # noqa: B023, E731
            d.node_set(number, [n for n, x in nodes.items() if inside(x) and n < 7001])
            d.keyword("CONSTRAINED_NODAL_RIGID_BODY")
            d.card(pid=number, cid=0, nsid=number)

    d.nodes(nodes)
    d.shells(shells)
    d.beams({7001: (WELD, (7001, 7002))})
    return d


def decks():
    """{name: deck} of the whole study."""
    study = {}
    for kind in PATCH:
        for weld in WELDS:
            study[f"{kind}_{weld}"] = make(kind, weld)
        study[f"{kind}_seven"] = make(kind, size=PATCH[kind] / 7.0, hourglass=0.01)
        study[f"{kind}_elastic"] = make(kind, size=PATCH[kind] / 7.0, elastic=True, stroke=0.02 * STROKE[kind])
        for size in (3, 5, 8):
            for over in OVERS:
                study[f"{kind}_{size}mm_{over}"] = make(kind, size=float(size), over=over)
    for name, across in (("five", 5), ("nine", 9), ("eleven", 11), ("thirteen", 13), ("fifteen", 15)):
        study[f"lap_{name}"] = make("lap", size=PATCH["lap"] / across, hourglass=0.01)
    study["lap_patch"] = make("lap", size=PATCH["lap"] / 21.0, hourglass=0.01, square=PATCH["lap"] / 7.0, stroke=0.8)
    study["lap_fails"] = make("lap", nrs=9000.0)
    study["peel_fails"] = make("peel", nrr=800.0)
    return study


if __name__ == "__main__":
    main(__doc__, decks)
