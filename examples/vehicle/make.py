# SPDX-License-Identifier: Apache-2.0
"""Writes a small car that runs into a wall, in the files in which public vehicle models come:

    python3 examples/vehicle/make.py FOLDER

    run.key         what is computed: speed, controls, results, contact, gravity, ground; includes the others
    welded.k        the body: sheets.k, to which `nugget weld points.csv sheets.k -o welded.k` adds the spot welds
    chassis.key     rails, bumper, engine, wheels with tyres, suspension, and how they hang together
    equipment.key   occupants and other masses, starting velocities, accelerometers, cross sections, part sets
    wall.key        a wall at the origin; run.key moves it in front of the car

The body is that of examples/body, with front rails, an engine and wheels that roll. The car drives along -x; the ground is z = 0. Units: mm, t, s,
N, MPa. No dependencies; the same bytes at every call.
"""
import importlib.util
import math
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from writer import Deck, field  # noqa: E402

spec = importlib.util.spec_from_file_location("body_in_white", HERE.parent / "body" / "make.py")
body_in_white = importlib.util.module_from_spec(spec)
spec.loader.exec_module(body_in_white)

SPEED = 15646.4                 # 35 mph
RAISED = 260.0                  # of the body above the ground
FRONT = body_in_white.INSET * 2  # x of the body's front wall
RAIL_Y, RAIL_Z, RAIL_LENGTH, RAIL_START = 300.0, 330.0, 928.0, -900.0  # in line with the members of the floor
DIAMETER = 6.0                  # of a weld
RADIUS, RIM, HALF_WIDTH = 280.0, 180.0, 90.0  # of a tyre
AXLES = ((-450.0, 620.0), (1600.0, 840.0))  # x, y of the wheels' centres
PRESSURE = 0.24                 # in the tyres, above the air's

# Parts from 101 on, and their sections; 100 and below are the body's.
RAIL_OUT, RAIL_IN, BUMPER, ENGINE, RAIL_WELDS, MOUNTS, SPRINGS, DAMPERS = range(101, 109)
TYRE, RIM_PART, KNUCKLE, SENSORS = 111, 121, 131, 141  # of wheels the first of four each
STEEL, STRONG, RIGID_STEEL, RIGID_ENGINE, RUBBER, WELD_STEEL, MOUNT, SPRING, DAMPER = range(101, 110)
SHEETS, ALL, GROUND_SETS, BODIES = 150, 151, 160, 200  # sets of parts, of nodes; nodal rigid bodies
SENSOR_NODES = 200001


class Chassis:
    """Nodes, shared where they meet within a group, and elements of all kinds."""

    def __init__(self, body):
        self.at = {n: (x, y, z + RAISED) for n, (x, y, z) in body.nodes.items()}
        self.known, self.next = {}, 100001
        self.group_of = {n: "body" for n in self.at}
        self.shells, self.solids, self.beams, self.springs, self.tied_to = {}, {}, {}, {}, []

    def node(self, group, *place):
        key = (group, *(round(c, 3) for c in place))
        if key not in self.known:
            self.known[key] = self.free(*place)
            self.group_of[self.known[key]] = group
        return self.known[key]

    def free(self, *place):
        """One that nothing shares."""
        self.at[self.next] = tuple(place)
        self.next += 1
        return self.next - 1

    def near(self, group, low, high):
        """Nodes of a group in a box."""
        return [n for n, g in self.group_of.items() if g == group and all(a <= c <= b for a, c, b in zip(low, self.at[n], high))]

    def closest(self, nodes, place):
        return min(nodes, key=lambda n: math.dist(self.at[n], place))

    def shell(self, part, *corners):
        self.shells[100001 + len(self.shells)] = (part, corners)

    def sheet(self, part, group, origin, u, v, columns, rows):
        """A parallelogram of columns x rows shells."""
        def corner(i, j):
            return self.node(group, *(o + a * i / columns + b * j / rows for o, a, b in zip(origin, u, v)))
        for i in range(columns):
            for j in range(rows):
                self.shell(part, corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1))

    def block(self, part, group, low, high, counts):
        """Bricks."""
        def corner(*steps):
            return self.node(group, *(a + (b - a) * s / n for a, b, s, n in zip(low, high, steps, counts)))
        ring = ((0, 0), (1, 0), (1, 1), (0, 1))
        for i in range(counts[0]):
            for j in range(counts[1]):
                for k in range(counts[2]):
                    self.solids[100001 + len(self.solids)] = (part, [corner(i + a, j + b, k + c) for c in (0, 1) for a, b in ring])

    def spring(self, part, a, b):
        self.springs[100001 + len(self.springs)] = (part, a, b)


def rail(c, side):
    """Two profiles that open towards each other, welded along their flanges of three elements."""
    y, length = side * RAIL_Y, RAIL_LENGTH
    for part, out in ((RAIL_OUT, side), (RAIL_IN, -side)):
        web = [(0.8, -70.0), (0.8, -40.0), (40.0, -40.0), (40.0, 40.0), (0.8, 40.0), (0.8, 70.0)]
        for (a, low), (b, high), count in zip(web, web[1:], (3, 4, 8, 4, 3)):
            c.sheet(part, f"rail {side}", (RAIL_START, y + out * a, RAIL_Z + low), (length, 0, 0), (0, out * (b - a), high - low), 93, count)
    for k in range(1, 24):
        for z in (RAIL_Z - 55.0, RAIL_Z + 55.0):
            ends = [c.free(RAIL_START + 40.0 * k + 3.0, y + sign * side * 0.8, z) for sign in (1, -1)]
            c.beams[100001 + len(c.beams)] = (RAIL_WELDS, ends)


def bumper(c):
    x, z, width = RAIL_START - 10.0, RAIL_Z - 60.0, 1200.0
    for origin, v in (((x, -600, z), (0, 0, 120)), ((x - 60, -600, z), (0, 0, 120)), ((x - 60, -600, z), (60, 0, 0)),
                      ((x - 60, -600, z + 120), (60, 0, 0))):
        c.sheet(BUMPER, "bumper", origin, (0, width, 0), v, 60, 6 if v[2] else 3)


def wheel(c, k, x, y):
    """A tyre on a rigid rim, which turns on a rigid knuckle. The faces of tyre and rim enclose the tyre's gas."""
    around, group, side = 32, f"wheel {k}", 1 if y > 0 else -1

    def on(radius, at, i):
        angle = 2.0 * math.pi * (i % around) / around
        return c.node(group, x + radius * math.cos(angle), at, RADIUS + 1.0 + radius * math.sin(angle))
    for i in range(around):
        for j in range(4):
            a, b = (y + HALF_WIDTH * (0.5 * n - 1.0) for n in (j, j + 1))
            c.shell(TYRE + k, on(RADIUS, a, i), on(RADIUS, b, i), on(RADIUS, b, i + 1), on(RADIUS, a, i + 1))
            c.shell(RIM_PART + k, on(RIM, a, i), on(RIM, a, i + 1), on(RIM, b, i + 1), on(RIM, b, i))
        middle = 0.5 * (RADIUS + RIM)
        for low, high in ((RIM, middle), (middle, RADIUS)):
            a, b = y - HALF_WIDTH, y + HALF_WIDTH
            c.shell(TYRE + k, on(low, a, i), on(high, a, i), on(high, a, i + 1), on(low, a, i + 1))
            c.shell(TYRE + k, on(low, b, i), on(low, b, i + 1), on(high, b, i + 1), on(high, b, i))
    inside = y - side * 140.0
    c.block(KNUCKLE + k, group + " knuckle", (x - 40, inside - 20, RADIUS - 39), (x + 40, inside + 20, RADIUS + 41), (2, 1, 2))
    return inside


def suspension(c, d, k, x, y, inside):
    """The wheel turns on its knuckle, which slides up and down in the strut: a spring and a damper hold it."""
    def same_place(*place):
        return [c.free(*place), c.free(*place)]
    axle = same_place(x, y, RADIUS + 1.0) + same_place(x, inside, RADIUS + 1.0)
    strut = [same_place(x + dx, inside, RADIUS + 1.0 + dz) for dx, dz in ((0, 0), (0, 250), (50, 0))]
    if x < 0:
        holder = c.near(f"rail {1 if y > 0 else -1}", (x - 60, -1e9, 0), (x + 60, 1e9, 1e9))
    else:
        low, high = sorted(math.copysign(v, y) for v in (480.0, 601.0))
        holder = c.near("body", (x - 60, low, RAISED), (x + 60, high, RAISED + 150))
    rigid_nodes(d, BODIES + 10 + k, holder + [pair[0] for pair in strut])
    for body, nodes in ((RIM_PART + k, axle[0::2]), (KNUCKLE + k, axle[1::2] + [pair[1] for pair in strut])):
        d.node_set(300 + body, nodes)
        d.keyword("CONSTRAINED_EXTRA_NODES_SET")
        d.card(pid=body, nsid=300 + body)
    for name, number, nodes in (("REVOLUTE", 1, axle), ("TRANSLATIONAL", 2, [n for pair in strut for n in pair])):
        d.keyword(f"CONSTRAINED_JOINT_{name}_ID")
        d.text(f"{10 * (k + 1) + number:10d}")
        d.ids(nodes)
    for part in (SPRINGS, DAMPERS):
        c.spring(part, strut[0][1], strut[1][0])


def rigid_nodes(d, number, nodes):
    d.keyword("CONSTRAINED_NODAL_RIGID_BODY")
    d.card(pid=number, cid=0, nsid=number)
    d.node_set(number, nodes)


def part_set(d, number, parts):
    d.keyword("SET_PART_LIST")
    d.card(sid=number)
    d.ids(parts)


def steel(d, number, yields):
    d.keyword("MAT_PIECEWISE_LINEAR_PLASTICITY")
    d.card(mid=number, ro=7.89e-9, e=210000.0, pr=0.3, sigy=yields, etan=0.0, fail=0.0)
    d.card(c=80.0, p=4.5, lcss=number, lcsr=0, vp=1.0)
    d.text("")
    d.text("")
    d.curve(number, [(0.0, yields), (0.1, 1.3 * yields), (0.3, 1.55 * yields), (1.0, 1.85 * yields)])


def shell_section(d, number, t):
    d.keyword("SECTION_SHELL")
    d.card(secid=number, elform=2, shrf=1.0, nip=3)
    d.card(t1=t, t2=t, t3=t, t4=t)


def sheets(body):
    """The body without its welds."""
    d = Deck()
    d.keyword("KEYWORD")
    steel(d, 1, 180.0)
    kinds = {kind: n for n, kind in enumerate(body_in_white.THICKNESS, start=1)}
    for kind, number in kinds.items():
        shell_section(d, number, body_in_white.THICKNESS[kind])
    for number, (title, kind) in body.parts.items():
        d.part(title, pid=number, secid=kinds[kind], mid=1)
    d.nodes(body.nodes)
    d.shells(body.shells)
    return d


def rigid(d, number, density):
    d.keyword("MAT_RIGID")
    d.card(mid=number, ro=density, e=210000.0, pr=0.3)
    d.card(cmo=0.0)
    d.text("")


def chassis(c):
    d = Deck()
    d.keyword("KEYWORD")
    steel(d, STRONG, 280.0)
    rigid(d, RIGID_STEEL, 7.89e-9)
    rigid(d, RIGID_ENGINE, 2.5e-9)
    d.keyword("MAT_ELASTIC")
    d.card(mid=RUBBER, ro=1.1e-9, e=600.0, pr=0.45)
    d.keyword("MAT_SPOTWELD")
    d.card(mid=WELD_STEEL, ro=7.89e-9, e=210000.0, pr=0.3, sigy=500.0, eh=1000.0)
    d.card(efail=0.0, nrr=12000.0, nrs=9000.0, nrt=9000.0)
    for number, t in ((RAIL_OUT, 1.4), (BUMPER, 2.5), (TYRE, 6.0), (RIM_PART, 4.0)):
        shell_section(d, number, t)
    d.keyword("SECTION_SOLID")
    d.card(secid=ENGINE, elform=1)
    d.weld_section(RAIL_WELDS, DIAMETER)
    d.keyword("SECTION_DISCRETE")
    d.card(secid=MOUNTS)
    d.text("")
    d.keyword("MAT_SPRING_ELASTIC")
    d.card(mid=MOUNT, k=2000.0)
    d.keyword("MAT_SPRING_NONLINEAR_ELASTIC")
    d.card(mid=SPRING, lcd=SPRING)
    d.curve(SPRING, [(-150.0, -9000.0), (-80.0, -2400.0), (0.0, 0.0), (80.0, 2400.0), (150.0, 9000.0)])
    d.keyword("MAT_DAMPER_VISCOUS")
    d.card(mid=DAMPER, dc=1.0)
    for title, number, section, law in (("rails, outside", RAIL_OUT, RAIL_OUT, STRONG), ("rails, inside", RAIL_IN, RAIL_OUT, STRONG),
                                        ("bumper", BUMPER, BUMPER, STRONG), ("engine", ENGINE, ENGINE, RIGID_ENGINE),
                                        ("welds of the rails", RAIL_WELDS, RAIL_WELDS, WELD_STEEL), ("engine mounts", MOUNTS, MOUNTS, MOUNT),
                                        ("springs", SPRINGS, MOUNTS, SPRING), ("dampers", DAMPERS, MOUNTS, DAMPER)):
        d.part(title, pid=number, secid=section, mid=law)
    for k in range(4):
        for title, first, section, law in (("tyre", TYRE, TYRE, RUBBER), ("rim", RIM_PART, RIM_PART, RIGID_STEEL),
                                           ("knuckle", KNUCKLE, ENGINE, RIGID_STEEL)):
            d.part(f"{title} {k + 1}", pid=first + k, secid=section, mid=law)

    for side in (1, -1):
        rail(c, side)
    bumper(c)
    c.block(ENGINE, "engine", (-700, -200, 330), (-250, 200, 680), (9, 8, 7))
    d.tie_welds(RAIL_WELDS, SHEETS, (RAIL_OUT, RAIL_IN), title="welds of the rails", number=101)
    for side in (1, -1):
        y, end = side * RAIL_Y, RAIL_START + RAIL_LENGTH
        box = ((-1e9, y - 45, RAIL_Z - 75), (1e9, y + 45, RAIL_Z + 75))
        front = c.near(f"rail {side}", (RAIL_START - 1, -1e9, 0), (RAIL_START + 1, 1e9, 1e9))
        rear = c.near(f"rail {side}", (end - 1, -1e9, 0), (end + 1, 1e9, 1e9))
        rigid_nodes(d, BODIES + (1 if side > 0 else 2), front + c.near("bumper", (RAIL_START - 11, *box[0][1:]), (RAIL_START, *box[1][1:])))
        rigid_nodes(d, BODIES + (3 if side > 0 else 4), rear + c.near("body", (FRONT - 60, *box[0][1:]), (FRONT + 60, *box[1][1:])))
        for x in (-650.0, -300.0):
            hole = (x, side * (RAIL_Y - 40.0), RAIL_Z)
            c.spring(MOUNTS, c.closest(c.near("engine", (-1e9,) * 3, (1e9,) * 3), hole), c.closest(c.near(f"rail {side}", (-1e9,) * 3, (1e9,) * 3), hole))
    for k, (x, y) in enumerate((x, side * y) for x, y in AXLES for side in (1, -1)):
        suspension(c, d, k, x, y, wheel(c, k, x, y))
        part_set(d, 120 + k, (TYRE + k, RIM_PART + k))
        d.keyword("AIRBAG_SIMPLE_PRESSURE_VOLUME_ID")
        d.text(f"{k + 1:10d}")
        d.card(sid=120 + k, sidtyp=1, rbid=0, vsca=1.0, psca=1.0)
        d.card(cn=PRESSURE, beta=1.0)
    own = {n: place for n, place in c.at.items() if n > 100000}
    d.nodes(own)
    d.shells(c.shells)
    d.solids(c.solids)
    d.beams(c.beams)
    d.keyword("ELEMENT_DISCRETE")
    d.lines += [f"{e:8d}{p:8d}{a:8d}{b:8d}" for e, (p, a, b) in c.springs.items()]
    return d


def equipment(c, body):
    """What is hung into a car for a test."""
    d = Deck()
    d.keyword("KEYWORD")
    floor = c.near("body", (100, -590, RAISED + 30), (1900, 590, RAISED + 45))
    d.comment("Occupants, 1 there, 0 not; the rest of a car's mass")
    d.keyword("PARAMETER_EXPRESSION")
    d.text("R SEATED  &DRIVER*0.02+1e-6")
    d.keyword("ELEMENT_MASS")
    for i, (x, y) in enumerate((x, y) for x in (900.0, 950.0) for y in (-300.0, 300.0)):
        d.text(f"{110001 + i:8d}{c.closest(floor, (x, y, RAISED + 40)):8d}&SEATED")
    d.keyword("ELEMENT_MASS_PART")
    titles = {title: number for number, (title, _) in body.parts.items()}
    for title, mass in (("floor", 0.25), ("roof", 0.03), ("rear", 0.08)):
        d.text(f"{titles[title]:8d}{mass:16.5f}")

    own = [RAIL_OUT, RAIL_IN, BUMPER, ENGINE]
    wheels = [first + k for first in (TYRE, RIM_PART) for k in range(4)]
    knuckles = [KNUCKLE + k for k in range(4)]
    part_set(d, ALL, list(body.parts) + own + wheels + knuckles)
    d.comment("All moves; wheels roll.")
    part_set(d, 152, list(body.parts) + own + knuckles + [SENSORS])
    for axle in (0, 1):
        part_set(d, 153 + axle, [first + 2 * axle + k for first in (TYRE, RIM_PART) for k in (0, 1)])
    d.keyword("INITIAL_VELOCITY_GENERATION")
    for number, spin, x in ((152, "0.0", 0.0), (153, "&SPIN", AXLES[0][0]), (154, "&SPIN", AXLES[1][0])):
        d.text(f"{number:10d}{1:10d}{spin:>10}{'&SPEED':>10}{'0.0':>10}{'0.0':>10}")
        d.text("".join(field(v) for v in (x, 0.0, RADIUS + 1.0, 0.0, 1.0, 0.0)))
    for k in range(4):
        d.keyword("SET_NODE_GENERAL")
        d.card(sid=GROUND_SETS + k)
        d.text(f"{'PART':<10}{TYRE + k:10d}{RIM_PART + k:10d}")

    d.comment("An accelerometer on either side: a small brick on the floor")
    d.part("accelerometers", pid=SENSORS, secid=SENSORS, mid=SENSORS)
    d.keyword("SECTION_SOLID")
    d.card(secid=SENSORS)
    d.keyword("MAT_ELASTIC")
    d.card(mid=SENSORS, ro=7.89e-9, e=210000.0, pr=0.3)
    places, bricks = {}, {}
    for k, y in enumerate((-300.0, 300.0)):
        base = SENSOR_NODES + 8 * k
        corners = [(1200.0 + a, y + b, RAISED + 42.0 + h) for h in (0, 25) for a, b in ((0, 0), (25, 0), (25, 25), (0, 25))]
        places.update({base + j: place for j, place in enumerate(corners)})
        bricks[120001 + k] = (SENSORS, list(range(base, base + 8)))
        around = [n for n in floor if abs(c.at[n][0] - 1212) < 40 and abs(c.at[n][1] - y - 12) < 40]
        rigid_nodes(d, BODIES + 21 + k, around + list(range(base, base + 8)))
    d.keyword("ELEMENT_SEATBELT_ACCELEROMETER")
    for k in range(2):
        base = SENSOR_NODES + 8 * k
        d.card(sbacid=k + 1, nid1=base, nid2=base + 1, nid3=base + 3)
    d.keyword("DATABASE_HISTORY_NODE_ID")
    d.text(f"{SENSOR_NODES:10d}left of the floor")
    d.text(f"{SENSOR_NODES + 8:10d}right of the floor")
    d.solids(bricks)
    d.nodes(places)
    for side, name in ((1, "left"), (-1, "right")):
        d.keyword("DATABASE_CROSS_SECTION_PLANE_ID")
        d.text(f"{1 if side > 0 else 2:10d}{name} rail")
        d.card(psid=SHEETS, xct=-155.0, yct=side * RAIL_Y, zct=RAIL_Z, xch=-255.0, ych=side * RAIL_Y, zch=RAIL_Z, radius=180.0)
        d.text("")
    return d


def wall():
    d = Deck()
    d.keyword("KEYWORD")
    d.keyword("RIGIDWALL_PLANAR_FINITE_ID")
    d.text(f"{1:10d}barrier")
    d.card(nsid=0)
    d.card(xt=0.0, yt=-1000.0, zt=50.0, xh=1.0, yh=-1000.0, zh=50.0, fric=0.6)
    d.card(xhev=0.0, yhev=0.0, zhev=50.0, lenl=2000.0, lenm=1200.0)
    d.part("barrier, to be seen", pid=1, secid=1, mid=1)
    shell_section(d, 1, 1.0)
    d.keyword("MAT_RIGID")
    d.card(mid=1, ro=7.89e-12, e=210000.0, pr=0.3)
    d.card(cmo=1.0, con1=7, con2=7)
    d.text("")
    columns, rows = 10, 6
    d.nodes({1 + i + (columns + 1) * j: (0.0, -1000.0 + 200.0 * i, 50.0 + 200.0 * j) for j in range(rows + 1) for i in range(columns + 1)})
    corner = [(1 + i + (columns + 1) * j) for j in range(rows) for i in range(columns)]
    d.shells({e: (1, (n, n + 1, n + columns + 2, n + columns + 1)) for e, n in enumerate(corner, start=1)})
    return d


def run():
    d = Deck()
    d.keyword("KEYWORD")
    d.keyword("TITLE")
    d.text("A small car against a wall")
    d.comment("Of the car along x; 1: a driver and a passenger are in it.")
    d.keyword("PARAMETER")
    d.text(f"R SPEED   {-SPEED:10.1f}")
    d.text("R DRIVER         1.0")
    d.keyword("PARAMETER_EXPRESSION")
    d.text(f"R SPIN    &SPEED/{RADIUS}")
    d.comment("The body stands on its wheels.")
    d.keyword("DEFINE_TRANSFORMATION")
    d.card(tranid=1)
    d.text(f"{'TRANSL':<10}{0.0:10.1f}{0.0:10.1f}{RAISED:10.1f}")
    d.keyword("INCLUDE_TRANSFORM")
    d.text("welded.k")
    d.lines += ["", "", ""]
    d.card(tranid=1)
    d.keyword("INCLUDE")
    d.text("chassis.key")
    d.keyword("INCLUDE")
    d.text("equipment.key")
    d.comment("The wall, a little in front of the bumper")
    d.keyword("DEFINE_TRANSFORMATION")
    d.card(tranid=2)
    d.text(f"{'TRANSL':<10}{RAIL_START - 80.0:10.1f}{0.0:10.1f}{0.0:10.1f}")
    d.keyword("INCLUDE_TRANSFORM")
    d.text("wall.key")
    d.card(idnoff=1000000, ideoff=1000000, idpoff=1000000, idmoff=1000000, idsoff=1000000, idfoff=1000000, iddoff=1000000)
    d.card(idroff=1000000)
    d.text("")
    d.card(tranid=2)

    d.keyword("CONTROL_TERMINATION")
    d.card(endtim=0.03)
    d.keyword("CONTROL_TIMESTEP")
    d.card(dtinit=0.0, tssfac=0.9, isdo=0, tslimt=0.0, dt2ms=-1.112e-6)
    d.keyword("CONTROL_CONTACT")
    d.card(slsfac=0.1, rwpnal=1.0)
    d.keyword("CONTROL_SHELL")
    d.card(wrpang=20.0, esort=1)
    d.keyword("CONTROL_SOLID")
    d.card(esort=1)
    d.keyword("CONTROL_OUTPUT")
    d.card(npopt=1, neecho=3, nrefup=0, iaccop=1)
    d.keyword("CONTROL_ENERGY")
    d.card(hgen=2, rwen=2, slnten=2, rylen=2)
    d.keyword("CONTROL_ACCURACY")
    d.card(osu=0, inn=2)
    d.keyword("CONTROL_HOURGLASS")
    d.card(ihq=4, qh=0.02)
    for name, interval in (("BINARY_D3PLOT", 2e-3), ("GLSTAT", 1e-4), ("MATSUM", 1e-3), ("SLEOUT", 1e-3), ("RCFORC", 1e-4), ("RWFORC", 1e-4),
                           ("DEFORC", 1e-3), ("ABSTAT", 1e-3), ("JNTFORC", 1e-3), ("NODOUT", 1e-4), ("SECFORC", 1e-4), ("SWFORC", 1e-4)):
        d.keyword(f"DATABASE_{name}")
        d.card(dt=interval)

    d.comment("All against all")
    d.keyword("CONTACT_AUTOMATIC_SINGLE_SURFACE")
    d.card(surfa=ALL, surfb=0, surfatyp=2)
    d.card(fs=0.2, fd=0.1, dc=0.001)
    d.text("")
    d.card(soft=1)
    d.text("")
    d.card(igap=0, ignore=1)

    d.comment("Weight, and the ground under each wheel")
    d.keyword("LOAD_BODY_Z")
    d.card(lcid=1001, sf=9806.0)
    d.curve(1001, [(0.0, 1.0), (5.0, 1.0)])
    for k in range(4):
        d.keyword("RIGIDWALL_PLANAR")
        d.card(nsid=GROUND_SETS + 10 + k)
        d.card(xt=0.0, yt=0.0, zt=0.0, xh=0.0, yh=0.0, zh=1.0, fric=0.9)
        d.keyword("SET_NODE_ADD")
        d.card(sid=GROUND_SETS + 10 + k)
        d.ids([GROUND_SETS + k])
    return d


def decks():
    body = body_in_white.make(60.0, 20.0)
    c = Chassis(body)
    made = {"run.key": run(), "sheets.k": sheets(body), "chassis.key": chassis(c), "equipment.key": equipment(c, body), "wall.key": wall()}
    points = "".join(f"{x:.4f}, {y:.4f}, {z:.4f}, {DIAMETER:g}, {first}+{second}\n" for x, y, z, first, second in body.points)
    return made, "x, y, z, diameter, parts\n" + points


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    made, points = decks()
    for name, deck in made.items():
        deck.write(folder / name)
    (folder / "points.csv").write_text(points, encoding="ascii")
