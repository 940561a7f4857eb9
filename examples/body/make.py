# SPDX-License-Identifier: Apache-2.0
"""Writes body.k, a small body in white without doors and glass, and points.csv, where its spot welds are to be.

    python3 examples/body/make.py FOLDER [PITCH [SIZE]]

for

    nugget weld points.csv body.k -o welded.k

A cabin of 2.0 x 1.2 x 1.0 m of six walls. Each is a flat sheet; a second one is formed to a frame around its openings and
along its members, flanged to the first all round, so that pillars, sills, rails and bows are closed sections as in a car. Floor,
roof, front and rear have flanges along their edges which are welded to the neighbours. PITCH between welds: 60 mm; SIZE of the
elements: 20 mm, as is usual for noise and vibration; a flange is one element. Units: mm, t, s, N, MPa. No dependencies; the same bytes at every call.
"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from writer import Deck  # noqa: E402

LENGTH, WIDTH, HEIGHT = 2000.0, 1200.0, 1000.0
MEMBER = 120.0       # width of a member with its flanges
DEPTH = 50.0         # of a closed section
INSET = 40.0         # of floor, roof, front and rear from the ends of the sides
DIAMETER = 6.0
THICKNESS = {"side inner": 1.2, "side outer": 1.0, "floor": 1.0, "floor frame": 1.5, "roof": 0.9, "roof frame": 1.2,
             "front": 1.0, "front frame": 1.2, "rear": 1.0, "rear frame": 1.2}


class Body:
    def __init__(self, pitch, size):
        self.size, self.every = size, max(1, round(pitch / size))
        self.nodes, self.shells, self.parts, self.points = {}, {}, {}, []

    def count(self, length):
        return round(length / self.size)

    def part(self, title, kind):
        self.parts[len(self.parts) + 1] = (title, kind)
        return len(self.parts)

    def sheet(self, part, cells, place, is_raised=lambda i, j: False):
        """Shells over cells (i, j), nodes where place(i, j) puts them. A cell with one node up or one down is two triangles."""
        made = {}
        for i, j in sorted(cells):
            corners = []
            for node in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
                if node not in made:
                    made[node] = len(self.nodes) + 1
                    self.nodes[made[node]] = place(*node)
                corners.append(made[node])
            up = [is_raised(*node) for node in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))]
            if sum(up) % 2 == 0:
                self.shells[len(self.shells) + 1] = (part, tuple(corners))
                continue
            odd = up.index(sum(up) == 1)
            a, b, c, d = corners[odd:] + corners[:odd]
            self.shells[len(self.shells) + 1] = (part, (d, a, b, b))
            self.shells[len(self.shells) + 1] = (part, (b, c, d, d))

    def welds(self, first, second, cells, place):
        """Points in the middle of cells, a pitch apart; place(i, j) is that of its corner."""
        for i, j in sorted(cells):
            if (i + j) % self.every == 0:
                x, y, z = (0.5 * (a + b) for a, b in zip(place(i, j), place(i + 1, j + 1)))
                self.points.append((x, y, z, first, second))

    def wall(self, name, kind, skin, frame, place):
        """A flat sheet over `skin` and one that is formed over `frame`; place(i, j, out) with the distance out of the flat sheet."""
        flat = self.part(name, kind)
        self.sheet(flat, skin, lambda i, j: place(i, j, 0.0))
        formed_kind = "side outer" if kind == "side inner" else f"{kind} frame"
        formed = self.part(f"{name} frame", formed_kind)
        touching = 0.5 * (THICKNESS[kind] + THICKNESS[formed_kind])

        def is_inside(i, j):
            """Whether a node is farther from the frame's edges than the flange."""
            return all((i + a, j + b) in frame for a in (-2, -1, 0, 1) for b in (-2, -1, 0, 1))

        self.sheet(formed, frame, lambda i, j: place(i, j, DEPTH if is_inside(i, j) else touching), is_inside)
        rim = {(i, j) for i, j in frame if any((i + a, j + b) not in frame for a in (-1, 0, 1) for b in (-1, 0, 1))}
        self.welds(flat, formed, rim & skin, lambda i, j: place(i, j, 0.5 * touching))
        return flat

    def flange(self, part, other, cells, place, gap):
        """A strip of cells (k, 0) bent off the edge of a sheet, welded to another one that lies `gap` away: place(k, l) is on the strip,
        place(k, l, out) out of it. Its nodes on the edge are those of the sheet."""
        known = {node: n for n, node in self.nodes.items()}
        made = {}
        for k in cells:
            corners = []
            for node in ((k, 0), (k + 1, 0), (k + 1, 1), (k, 1)):
                if node not in made:
                    at = place(*node)
                    made[node] = known.get(at) or len(self.nodes) + 1
                    self.nodes[made[node]] = at
                corners.append(made[node])
            self.shells[len(self.shells) + 1] = (part, tuple(corners))
        self.welds(part, other, {(k, 0) for k in cells}, lambda k, m: place(k, m, 0.5 * gap))


def grid(columns, rows, openings=()):
    """Cells of columns x rows without those in the openings (i0, i1, j0, j1)."""
    return {(i, j) for i in range(columns) for j in range(rows)
            if not any(a <= i < b and c <= j < d for a, b, c, d in openings)}


def make(pitch, size):
    body = Body(pitch, size)
    nx, ny, nz = body.count(LENGTH), body.count(WIDTH), body.count(HEIGHT)
    m, inset = body.count(MEMBER), body.count(INSET)
    middle = (nx - m) // 2

    # Sides: door openings between sill, pillars and roof rail; one sheet flat, the other formed outwards.
    doors = [(m, middle, m, nz - m), (middle + m, nx - m, m, nz - m)]
    ring = grid(nx, nz, doors)
    sides = {}
    for name, sign in (("left side", -1.0), ("right side", 1.0)):
        sides[sign] = body.wall(name, "side inner", ring, ring,
                                lambda i, j, out, s=sign: (i * size, s * (0.5 * WIDTH + out), j * size))

    def between(value, kind):
        """Across the cabin, no farther than where a flange of this kind touches the sides."""
        most = 0.5 * WIDTH - 0.5 * (THICKNESS[kind] + THICKNESS["side inner"])
        return max(-most, min(most, value))

    def to_sides(part, kind, cells, place):
        """Flanges along both edges; place(k, y, l): l away from the sheet."""
        gap = 0.5 * (THICKNESS[kind] + THICKNESS["side inner"])
        for sign in (-1.0, 1.0):
            edge = between(sign * 0.5 * WIDTH, kind)
            body.flange(part, sides[sign], cells, lambda k, l, out=0.0, s=sign, e=edge: place(k, e + s * out, l * size), gap)

    # Floor and roof: flat sheets; the floor's members are below it, the roof's above.
    nl = nx - 2 * inset
    long_members = [(0, nl, j, j + m) for j in (ny // 5, 4 * ny // 5 - m)]
    cross = [(i, i + m, 0, ny) for i in (0, (nl - m) // 3, 2 * (nl - m) // 3, nl - m)]
    members = {(i, j) for a, b, c, d in long_members + cross for i in range(a, b) for j in range(c, d)}
    bows = grid(nl, ny, [(i + m, i + (nl - m) // 3, m, ny - m) for i in (0, (nl - m) // 3, 2 * (nl - m) // 3)])
    low, high = INSET, HEIGHT - INSET
    level = {"floor": low, "roof": high}
    flat = {}
    for kind, skin, frame, down in (("floor", grid(nl, ny), members, -1.0), ("roof", bows, bows, 1.0)):
        flat[kind] = body.wall(kind, kind, skin, frame,
                               lambda i, j, out, k=kind, s=down: (INSET + i * size, between(j * size - 0.5 * WIDTH, k), level[k] + s * out))
        to_sides(flat[kind], kind, range(2, nl - 2), lambda k, y, l, d=down, z=level[kind]: (INSET + k * size, y, z - d * l))

    # Front and rear: a bulkhead below the windscreen, the frame of the tailgate; flanges to sides, floor and roof.
    rows = nz - 2 * inset
    screen = [(m, ny - m, rows // 2, rows - m)]
    gate = [(m, ny - m, m, rows - m)]
    bar = grid(ny, rows, screen + [(m, ny - m, m, rows // 2 - m)])
    for kind, skin, frame, x, inwards in (("front", grid(ny, rows, screen), bar, 2 * INSET, 1.0),
                                          ("rear", grid(ny, rows, gate), grid(ny, rows, gate), LENGTH - 2 * INSET, -1.0)):
        gaps = {other: 0.5 * (THICKNESS[kind] + THICKNESS[other]) for other in ("floor", "roof")}

        def height(j, g=gaps):
            return max(low + g["floor"], min(high - g["roof"], INSET + j * size))

        wall = body.wall(kind, kind, skin, frame,
                         lambda i, j, out, k=kind, x=x, s=inwards, h=height: (x - s * out, between(i * size - 0.5 * WIDTH, k), h(j)))
        to_sides(wall, kind, range(2, rows - 2), lambda k, y, l, x=x, s=inwards, h=height: (x + s * l, y, h(k)))
        for other, j, sign in (("floor", 0, -1.0), ("roof", rows, 1.0)):
            body.flange(wall, flat[other], range(2, ny - 2),
                        lambda k, l, out=0.0, x=x, s=inwards, z=height(j), n=sign, kd=kind:
                        (x + s * l * size, between(k * size - 0.5 * WIDTH, kd), z + n * out), gaps[other])
    return body


def write(body, folder):
    folder.mkdir(parents=True, exist_ok=True)
    d = Deck()
    d.keyword("KEYWORD")
    d.keyword("TITLE")
    d.text("A small body in white, without doors and glass")
    d.comment("Sheets alone: `nugget weld points.csv body.k -o welded.k` adds the spot welds. Nothing holds the body, so its first six\n"
              "modes are its rigid motions. Units: mm, t, s, N, MPa.")
    d.comment("Of an impact; modes need none, but a deck has one.")
    d.keyword("CONTROL_TERMINATION")
    d.card(endtim=1.0e-3)
    d.keyword("MAT_ELASTIC")
    d.card(mid=1, ro=7.85e-9, e=210000.0, pr=0.3)
    kinds = {kind: n for n, kind in enumerate(THICKNESS, start=1)}
    for kind, secid in kinds.items():
        t = THICKNESS[kind]
        d.keyword("SECTION_SHELL_TITLE")
        d.text(kind)
        d.card(secid=secid, elform=16, shrf=0.8333, nip=2)
        d.card(t1=t, t2=t, t3=t, t4=t)
    for pid, (title, kind) in body.parts.items():
        d.part(title, pid=pid, secid=kinds[kind], mid=1)
    d.nodes(body.nodes)
    d.shells(body.shells)
    d.write(folder / "body.k")
    lines = [f"{x:.4f}, {y:.4f}, {z:.4f}, {DIAMETER:g}, {first}+{second}\n" for x, y, z, first, second in body.points]
    (folder / "points.csv").write_text("x, y, z, diameter, parts\n" + "".join(lines), encoding="ascii")


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3, 4):
        sys.exit(__doc__)
    made = make(*map(float, sys.argv[2:]), *(60.0, 20.0)[len(sys.argv) - 2:])
    write(made, pathlib.Path(sys.argv[1]))
    print(f"{len(made.shells)} shells, {len(made.points)} spots")
