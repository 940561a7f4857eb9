# SPDX-License-Identifier: Apache-2.0
"""Writes centre.k, edge.k and corner.k: one lap-shear coupon, three meshes.

    python3 examples/weld_placement/make.py FOLDER

Two strips of 100 x 40 x 1.5 mm overlap by 40 mm and are held together by one spot weld of 6 mm in the middle of the
overlap. The coupon is the same in all three decks; only the mesh lines move by half an element, so that the weld stands
over the centre of an element, on the middle of an element's edge, or on a node. Units: mm, t, s, N, MPa.

Also writes placed/sheets.k, the first coupon without its weld, and placed/points.csv, where the weld is to be, for

    nugget weld placed/points.csv placed/sheets.k -o placed/welded.k --as solid4
"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from coupon import DIAMETER, THICKNESS, controls, grips, sheets, weld  # noqa: E402
from writer import Deck  # noqa: E402

STRIP, WIDTH, OVERLAP, GRIP = 100.0, 40.0, 40.0, 30.0
SIZE = WIDTH / 7.0   # of an element: about the diameter of the weld
STRENGTH = 9000.0    # of the weld, in tension and in shear
SPEED, RAMP, END_TIME = 200.0, 1.0e-3, 4.0e-3  # the grip's speed, the time to reach it, and the end

UPPER, LOWER, WELD = 1, 2, 3

# Over what the weld stands: is it between two mesh lines along x, and along y?
CASES = {"centre": (True, True), "edge": (False, True), "corner": (False, False)}
WHAT = {"centre": "the centre of an element", "edge": "the middle of an element's edge", "corner": "a node"}


def lines(half, between):
    """Mesh lines over [-half, half] with spacing SIZE; 0 lies between two of them, or on one."""
    offset = SIZE / 2.0 if between else 0.0
    inner = [offset + i * SIZE for i in range(100) if offset + i * SIZE < half - SIZE / 4.0] + [half]
    return sorted({-x for x in inner} | set(inner))


def strip(part, case, nodes, shells):
    """One strip; returns the nodes in its grip. The upper one reaches to -x, the lower one is its mirror image."""
    between_x, between_y = CASES[case]
    side = 1.0 if part == UPPER else -1.0
    far, grip_edge, overlap_edge = -(STRIP - OVERLAP / 2.0), -(STRIP - OVERLAP / 2.0 - GRIP), -OVERLAP / 2.0
    xs = [far + i * GRIP / 5 for i in range(5)]
    xs += [grip_edge + i * (overlap_edge - grip_edge) / 5 for i in range(5)]
    xs += lines(OVERLAP / 2.0, between_x)
    ys = lines(WIDTH / 2.0, between_y)
    first = 1000 * part
    number = lambda i, j: first + i * len(ys) + j + 1  # noqa: E731
    for i, x in enumerate(xs):
        for j, y in enumerate(ys):
            nodes[number(i, j)] = (side * x, side * y, side * THICKNESS / 2.0)
    for i in range(len(xs) - 1):
        for j in range(len(ys) - 1):
            corners = (number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1))
            shells[first + (i * (len(ys) - 1)) + j + 1] = (part, corners)
    return [number(i, j) for i, x in enumerate(xs) for j in range(len(ys)) if x < grip_edge + 1.0e-6]


def make(case, welded=True, end_time=END_TIME):
    nodes, shells = {}, {}
    held = strip(UPPER, case, nodes, shells)
    pulled = strip(LOWER, case, nodes, shells)
    if welded:
        nodes[3001] = (0.0, 0.0, THICKNESS / 2.0)
        nodes[3002] = (0.0, 0.0, -THICKNESS / 2.0)

    d = Deck()
    d.keyword("KEYWORD")
    d.keyword("TITLE")
    d.text(f"Lap-shear coupon, weld over {WHAT[case]}")
    d.comment(f"""
One spot weld of {DIAMETER:g} mm holds two strips of {STRIP:g} x {WIDTH:g} x {THICKNESS:g} mm together. The last {GRIP:g} mm of each strip are
in a grip: the left one stays, the right one is pulled along x. In this deck the weld stands over
{WHAT[case]}. Units: mm, t, s, N, MPa.
""")
    controls(d, end_time)
    for name, interval in (("GLSTAT", 4.0e-5), ("SWFORC", 1.0e-5), ("NODOUT", 1.0e-5), ("BINARY_D3PLOT", 2.0e-4)):
        d.keyword("DATABASE_" + name)
        d.card(dt=interval)
    d.comment("A node of the moving grip: its x-displacement is the elongation of the coupon.")
    d.keyword("DATABASE_HISTORY_NODE")
    d.ids([pulled[0]])

    sheets(d, {UPPER: "upper strip", LOWER: "lower strip"})
    if welded:
        weld(d, WELD, [UPPER, LOWER], f"Strong enough not to yield; fails at {STRENGTH:g} N.", sigy=2000.0, nrr=STRENGTH, nrs=STRENGTH)
    grips(d, held, pulled, 1, [(0.0, 0.0), (RAMP, 1.0), (1.0, 1.0)], SPEED)

    d.nodes(nodes)
    d.shells(shells)
    if welded:
        d.beams({3001: (WELD, (3001, 3002))})
    return d


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for case in CASES:
        make(case).write(folder / f"{case}.k")
    (folder / "placed").mkdir(exist_ok=True)
    make("centre", welded=False).write(folder / "placed" / "sheets.k")
    (folder / "placed" / "points.csv").write_text(f"x, y, z, diameter, parts\n0, 0, 0, {DIAMETER:g}, {UPPER}+{LOWER}\n",
                                                  encoding="ascii")
