# SPDX-License-Identifier: Apache-2.0
"""Writes double_hat.k: a spot-welded rail of two hats, run into a rigid wall by the sled behind it.

    python3 examples/double_hat/make.py FOLDER

Units: mm, t, s, N, MPa. No dependencies; the same bytes at every call.
"""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from writer import Deck, main  # noqa: E402

LENGTH = 700.0       # of the rail, along z; the wall stands at z = 0
TOP, WEB, FLANGE = 60.0, 40.0, 18.0
THICKNESS = 1.2
GAP = 1.3            # between the mid-surfaces of the two flanges: two half thicknesses and 0.1 of air
SIZE = 5.0           # of an element along the rail, on top and web; the flange has three of 6 mm across
PITCH = 35.0         # between welds
DIAMETER = 6.0       # of a weld
SPEED = 12000.0      # 12 m/s = 43 km/h
SLED_MASS = 0.080    # 80 kg
DENT_AT, DENT_REACH, DENT_DEPTH = 25.0, 15.0, 2.0  # the trigger: a dent across tops and webs, where the first fold starts
END_TIME = 0.010

UPPER, LOWER, SLED, WELDS = 1, 2, 3, 4  # parts, and their sections and materials


def profile():
    """Half a section from flange edge to flange edge: [(x, height above the flange, in which wall)]."""
    walls = [((1, 0), FLANGE, 3, "flange"), ((0, 1), WEB, 8, "left web"), ((1, 0), TOP, 12, "top"),
             ((0, -1), WEB, 8, "right web"), ((1, 0), FLANGE, 3, "flange")]
    x, h = -(FLANGE + TOP / 2.0), 0.0
    points = [(x, h, "flange")]
    for (dx, dh), width, count, name in walls:
        for i in range(count):
            x += dx * width / count
            h += dh * width / count
            points.append((x, h, name if i < count - 1 else "corner"))
    return points[:-1] + [(points[-1][0], 0.0, "flange")]


def dented(x, h, z, wall):
    """The trigger: the top goes in, the webs go out. Corners stay, so that the dent turns them into the first hinge."""
    r = abs(z - DENT_AT) / DENT_REACH
    depth = DENT_DEPTH * 0.5 * (1.0 + math.cos(math.pi * r)) if r < 1.0 else 0.0
    if wall == "top":
        return x, h - depth
    if wall in ("left web", "right web"):
        out = depth * math.sin(math.pi * h / WEB)
        return (x - out if wall == "left web" else x + out), h
    return x, h


def rail():
    """Nodes and shells of both hats; the rear edge."""
    nodes, shells, rear = {}, {}, []
    section = profile()
    rows = round(LENGTH / SIZE)
    for part, side in ((UPPER, 1.0), (LOWER, -1.0)):
        first = 10000 * part
        number = lambda j, k: first + j * len(section) + k + 1  # noqa: E731
        for j in range(rows + 1):
            z = j * LENGTH / rows
            for k, (x, h, wall) in enumerate(section):
                x, h = dented(x, h, z, wall)
                nodes[number(j, k)] = (x, side * (h + GAP / 2.0), z)
        for j in range(rows):
            for k in range(len(section) - 1):
                corners = (number(j, k), number(j + 1, k), number(j + 1, k + 1), number(j, k + 1))
                if side < 0.0:  # normals point out of the rail on both sides
                    corners = corners[::-1]
                shells[len(shells) + 1] = (part, corners)
        rear += [number(rows, k) for k in range(len(section))]
    return nodes, shells, rear


def sled(nodes, shells):
    """A rigid plate behind the rail; returns its area."""
    first, cells, width, height = 30000, 4, 100.0, 100.0
    number = lambda i, j: first + i * (cells + 1) + j + 1  # noqa: E731
    for i in range(cells + 1):
        for j in range(cells + 1):
            nodes[number(i, j)] = (width * (i / cells - 0.5), height * (j / cells - 0.5), LENGTH + 10.0)
    for i in range(cells):
        for j in range(cells):
            shells[len(shells) + 1] = (SLED, (number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)))
    return width * height


def welds(nodes):
    """A row of weld beams along the middle of each flange, wherever the mesh lines may be."""
    beams = {}
    count = int((LENGTH - PITCH / 2.0) / PITCH) + 1
    for x in (-(TOP / 2.0 + FLANGE / 2.0), TOP / 2.0 + FLANGE / 2.0):
        for i in range(count):
            n = 40000 + 2 * len(beams) + 1
            z = PITCH / 2.0 + i * PITCH
            nodes[n] = (x, GAP / 2.0, z)
            nodes[n + 1] = (x, -GAP / 2.0, z)
            beams[50001 + len(beams)] = (WELDS, (n, n + 1))
    return beams


def make():
    nodes, shells, rear = rail()
    sled_area = sled(nodes, shells)
    beams = welds(nodes)
    sled_thickness = 10.0

    d = Deck()
    d.keyword("KEYWORD")
    d.keyword("TITLE")
    d.text("Double hat rail, 40 spot welds, 12 m/s onto a rigid wall")
    d.comment(f"""
Two hat profiles are joined flange to flange by {len(beams)} spot welds every {PITCH:g} mm. A sled of {SLED_MASS * 1000:g} kg is fixed to
the rear end; the front end runs into a rigid wall at z = 0. A dent near the front starts the first fold.
Units: mm, t, s, N, MPa (so a density is in t/mm3, an energy in N mm = mJ).
A blank field takes its default. Lines that begin with $ are comments; $# names the fields of the next card.

---- what to run ---------------------------------------------------------------------------------------------""")
    d.keyword("CONTROL_TERMINATION")
    d.card(endtim=END_TIME)
    d.comment("The weld beams are short, so they would dictate a step of 0.2 us. A negative dt2ms adds mass only to what is\n"
              "below it; the step is tssfac * |dt2ms|. summary.json says how much mass that was, in total and per weld.")
    d.keyword("CONTROL_TIMESTEP")
    d.card(dtinit=0.0, tssfac=0.9, isdo=0, tslimt=0.0, dt2ms=-7.0e-7)
    d.comment("Hourglass, wall and contact energy are part of the energy balance (2).")
    d.keyword("CONTROL_ENERGY")
    d.card(hgen=2, rwen=2, slnten=2, rylen=2)
    d.comment("Stiffness form: the usual choice for thin sheets that fold. Keep an eye on its energy in glstat.")
    d.keyword("CONTROL_HOURGLASS")
    d.card(ihq=4, qh=0.02)
    d.comment("spotstp = 1: a weld that finds no sheet is an error, not a loose part in the car.")
    d.keyword("CONTROL_CONTACT")
    d.card(slsfac=0.1)
    d.card(usrstr=0)
    d.card(sfric=0.0)
    d.card(ignore=0, frceng=0, skiprwg=0, outseg=1, spotstp=1)

    d.comment("\n---- what to write -------------------------------------------------------------------------------------------")
    for name, interval in (("GLSTAT", 1.0e-4), ("MATSUM", 1.0e-4), ("NODOUT", 1.0e-4), ("RBDOUT", 1.0e-4),
                           ("RWFORC", 2.0e-5), ("SWFORC", 2.0e-5), ("BINARY_D3PLOT", 5.0e-4)):
        d.keyword("DATABASE_" + name)
        d.card(dt=interval)
    d.comment("A node at the front, in the middle of the upper top, and one of the sled.")
    d.keyword("DATABASE_HISTORY_NODE")
    d.ids([10000 * UPPER + len(profile()) // 2 + 1, 30013])

    d.comment("\n---- the sheets ----------------------------------------------------------------------------------------------")
    d.part("upper hat", pid=UPPER, secid=UPPER, mid=UPPER)
    d.part("lower hat", pid=LOWER, secid=UPPER, mid=UPPER)
    d.comment("Belytschko-Lin-Tsay shell, three points through the thickness.")
    d.keyword("SECTION_SHELL")
    d.card(secid=UPPER, elform=2, shrf=0.8333, nip=3)
    d.card(t1=THICKNESS, t2=THICKNESS, t3=THICKNESS, t4=THICKNESS)
    d.comment("A micro-alloyed steel: yield stress over plastic strain from curve 1, raised with the strain rate after\n"
              "Cowper and Symonds, 1 + (rate/c)^(1/p). The values are typical, not measured.")
    d.keyword("MAT_PIECEWISE_LINEAR_PLASTICITY")
    d.card(mid=UPPER, ro=7.85e-9, e=210000.0, pr=0.3)
    d.card(c=8000.0, p=8.0, lcss=1)
    d.card(eps1=None)
    d.card(es1=None)
    d.curve(1, [(0.0, 350.0), (0.01, 385.0), (0.02, 408.0), (0.05, 450.0), (0.1, 492.0), (0.2, 540.0), (0.4, 592.0),
                (1.0, 660.0)])

    d.comment("\n---- the sled ------------------------------------------------------------------------------------------------")
    d.comment(f"A rigid plate. Its density is chosen so that it weighs {SLED_MASS * 1000:g} kg. It only moves along z: con1 = 4 holds\n"
              "x and y, con2 = 7 all rotations.")
    d.part("sled", pid=SLED, secid=SLED, mid=SLED)
    d.keyword("SECTION_SHELL")
    d.card(secid=SLED, elform=2, shrf=0.8333, nip=2)
    d.card(t1=sled_thickness, t2=sled_thickness, t3=sled_thickness, t4=sled_thickness)
    d.keyword("MAT_RIGID")
    d.card(mid=SLED, ro=SLED_MASS / (sled_area * sled_thickness), e=210000.0, pr=0.3)
    d.card(cmo=1.0, con1=4, con2=7)
    d.card(lco=None)
    d.comment("The rear edge of the rail belongs to the sled.")
    d.keyword("CONSTRAINED_EXTRA_NODES_SET")
    d.card(pid=SLED, nsid=1)
    d.node_set(1, rear)

    d.comment("\n---- the welds -----------------------------------------------------------------------------------------------")
    d.comment("One beam a weld, from sheet to sheet. Its end nodes are not nodes of the sheets: the tie finds the shell under\n"
              "each and lets it go with the shell's four nodes. So the welds stand where they are needed, not where the mesh is.")
    d.part("spot welds", pid=WELDS, secid=WELDS, mid=WELDS)
    d.comment("elform 9 is the weld beam; cst = 1 a round section; ts the outer, tt the inner diameter.")
    d.weld_section(WELDS, DIAMETER)
    d.comment("The weld fails when (nrr/NRR)^2 + (nrs/NRS)^2 + ... reaches 1: axial force in tension, two shear forces, torsion,\n"
              "two bending moments. A strength of 0 is not considered.")
    d.keyword("MAT_SPOTWELD")
    d.card(mid=WELDS, ro=7.85e-9, e=210000.0, pr=0.3, sigy=500.0, eh=1000.0, dt=0.0, tfail=0.0)
    d.card(efail=0.0, nrr=6000.0, nrs=9000.0, nrt=9000.0, mrr=0.0, mss=20000.0, mtt=20000.0, nf=0.0)
    d.comment("surfa is the part of the welds (type 3), surfb the set of parts with the sheets (type 2).")
    d.tie_welds(WELDS, 1, [UPPER, LOWER])

    d.comment("\n---- contact, wall, start ------------------------------------------------------------------------------------")
    d.comment("The sheets do not pass through each other or themselves.")
    d.keyword("CONTACT_AUTOMATIC_SINGLE_SURFACE_ID")
    d.text(f"{2:10d}sheets with each other")
    d.card(surfa=1, surfb=0, surfatyp=2, surfbtyp=0)
    d.card(fs=0.0, fd=0.0)
    d.card(sfsa=1.0, sfsb=1.0)
    d.comment("The wall: tail at the origin, normal along +z. It stops the nodes of box 1, that is, all but the sled's.\n"
              "fric = 1: what has arrived does not slide.")
    d.keyword("RIGIDWALL_PLANAR_ID")
    d.text(f"{1:10d}barrier")
    d.card(nsid=0, nsidex=0, boxid=1)
    d.card(xt=0.0, yt=0.0, zt=0.0, xh=0.0, yh=0.0, zh=1.0, fric=1.0)
    d.keyword("DEFINE_BOX")
    d.card(boxid=1, xmn=-100.0, xmx=100.0, ymn=-100.0, ymx=100.0, zmn=-1.0, zmx=LENGTH - 1.0)
    d.comment("Everything moves: styp = 1 means a set of parts.")
    d.keyword("INITIAL_VELOCITY_GENERATION")
    d.card(id=2, styp=1, omega=0.0, vx=0.0, vy=0.0, vz=-SPEED)
    d.card(xc=0.0, yc=0.0, zc=0.0, nx=0.0, ny=0.0, nz=0.0)
    d.keyword("SET_PART_LIST")
    d.card(sid=2)
    d.ids([UPPER, LOWER, SLED, WELDS])

    d.comment("\n---- the mesh ------------------------------------------------------------------------------------------------")
    d.nodes(nodes)
    d.shells(shells)
    d.beams(beams)
    return d


if __name__ == "__main__":
    main(__doc__, lambda: {"double_hat": make()})
