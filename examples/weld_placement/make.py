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
from writer import Deck  # noqa: E402

STRIP, WIDTH, OVERLAP, GRIP = 100.0, 40.0, 40.0, 30.0
THICKNESS = 1.5
SIZE = WIDTH / 7.0   # of an element: about the diameter of the weld
DIAMETER = 6.0
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


def weld(d):
    """The weld's part, section, material and contact."""
    d.part("spot weld", pid=WELD, secid=WELD, mid=WELD)
    d.keyword("SECTION_BEAM")
    d.card(secid=WELD, elform=9, shrf=1.0, qr=2, cst=1.0)
    d.card(ts1=DIAMETER, ts2=DIAMETER, tt1=0.0, tt2=0.0)
    d.comment(f"Strong enough not to yield; fails at {STRENGTH:g} N.")
    d.keyword("MAT_SPOTWELD")
    d.card(mid=WELD, ro=7.85e-9, e=210000.0, pr=0.3, sigy=2000.0, eh=1000.0)
    d.card(efail=0.0, nrr=STRENGTH, nrs=STRENGTH, nrt=STRENGTH)
    d.keyword("CONTACT_SPOTWELD_ID")
    d.text(f"{1:10d}weld to strips")
    d.card(surfa=WELD, surfb=1, surfatyp=3, surfbtyp=2)
    d.card(fs=None)
    d.card(sfsa=None)
    d.keyword("SET_PART_LIST")
    d.card(sid=1)
    d.ids([UPPER, LOWER])


def make(case, welded=True):
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
    d.keyword("CONTROL_TERMINATION")
    d.card(endtim=END_TIME)
    d.keyword("CONTROL_TIMESTEP")
    d.card(dtinit=0.0, tssfac=0.9)
    d.keyword("CONTROL_ENERGY")
    d.card(hgen=2, rwen=2, slnten=2, rylen=2)
    d.keyword("CONTROL_HOURGLASS")
    d.card(ihq=4, qh=0.05)
    d.comment("spotstp = 1: a weld that finds no sheet is an error.")
    d.keyword("CONTROL_CONTACT")
    d.card(slsfac=0.1)
    d.card(usrstr=0)
    d.card(sfric=0.0)
    d.card(ignore=0, frceng=0, skiprwg=0, outseg=1, spotstp=1)
    for name, interval in (("GLSTAT", 4.0e-5), ("SWFORC", 1.0e-5), ("NODOUT", 1.0e-5), ("BINARY_D3PLOT", 2.0e-4)):
        d.keyword("DATABASE_" + name)
        d.card(dt=interval)
    d.comment("A node of the moving grip: its x-displacement is the elongation of the coupon.")
    d.keyword("DATABASE_HISTORY_NODE")
    d.ids([pulled[0]])

    d.part("upper strip", pid=UPPER, secid=1, mid=1)
    d.part("lower strip", pid=LOWER, secid=1, mid=1)
    d.keyword("SECTION_SHELL")
    d.card(secid=1, elform=2, shrf=0.8333, nip=5)
    d.card(t1=THICKNESS, t2=THICKNESS, t3=THICKNESS, t4=THICKNESS)
    d.comment("etan is the slope of stress over total strain; the plastic slope is 1500.")
    d.keyword("MAT_PIECEWISE_LINEAR_PLASTICITY")
    d.card(mid=1, ro=7.85e-9, e=210000.0, pr=0.3, sigy=300.0, etan=1489.36)
    d.card(c=0.0)
    d.card(eps1=None)
    d.card(es1=None)

    if welded:
        weld(d)

    d.comment("The grips.")
    d.node_set(1, held)
    d.node_set(2, pulled)
    d.keyword("BOUNDARY_SPC_SET")
    d.card(nsid=1, cid=0, dofx=1, dofy=1, dofz=1, dofrx=1, dofry=1, dofrz=1)
    d.card(nsid=2, cid=0, dofx=0, dofy=1, dofz=1, dofrx=1, dofry=1, dofrz=1)
    d.comment("vad = 0: curve 1 is a velocity; sf scales it.")
    d.keyword("BOUNDARY_PRESCRIBED_MOTION_SET")
    d.card(nsid=2, dof=1, vad=0, lcid=1, sf=SPEED)
    d.curve(1, [(0.0, 0.0), (RAMP, 1.0), (1.0, 1.0)])

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
