# SPDX-License-Identifier: Apache-2.0
"""The coupons of study.py as solids for CalculiX (ccx, another program): 20-node bricks with a circular nugget, half of each by symmetry.

    python3 examples/weld_place/solids.py FOLDER [COUPON [CCX]]

Runs the coupons on two meshes and prints stiffness and forces of each, and the work up to the force at which the weld of
wider.py fails: what study.py and wider.py compare with. Some ten minutes.
"""
import math
import pathlib
import re
import subprocess
import sys

# Thickness of each sheet, diameter of the nugget, first yield stress, plastic modulus; "mild" is thinner,
# yields sooner and hardens more, "strong" thinner still, of twice the yield stress and hardens little.
COUPONS = {"book": (1.5, 6.0, 300.0, 1500.0), "mild": (1.0, 5.0, 200.0, 2000.0), "strong": (0.8, 4.5, 600.0, 600.0)}
THICKNESS, DIAMETER, YIELD, PLASTIC = COUPONS["book"]
WIDTH = 40.0
OVERLAP = 20.0                               # from the weld to the end of a sheet
REACH = {"lap": 50.0, "peel": 25.0, "cross": 30.0, "three": 50.0, "through": 50.0}  # from the weld to the grips
PULL = {"lap": 1, "peel": 3, "cross": 3, "three": 1, "through": 1}                  # degree of freedom of the moving grip
MOVING = {"lap": 1, "peel": 1, "cross": 1, "three": 1, "through": 2}                # sheet whose grip moves; the others are held
# Where forces are compared: displacements of the grip.
DISPLACEMENTS = {"lap": (0.1, 0.3, 0.5), "peel": (0.5, 1.0, 2.0), "cross": (0.5, 1.0, 1.5), "three": (0.1, 0.3, 0.5),
                 "through": (0.1, 0.3, 0.5)}
STRENGTH = 0.9  # of the force at the last of these, at which the weld fails
YOUNG, POISSON = 210000.0, 0.3
STROKE = {"lap": 0.6, "peel": 2.2, "cross": 1.65, "three": 0.6, "through": 0.6}
BOX = 8.0  # half the side of the square around the nugget from which on the mesh is rectangular


def block(corner_map, nu, nv, power=1.0):
    """(2 nu + 1) x (2 nv + 1) points of a patch: corners, middles of sides, middles. `power` crowds them towards v = 0."""
    return [[corner_map(i / (2.0 * nu), (j / (2.0 * nv)) ** power) for j in range(2 * nv + 1)] for i in range(2 * nu + 1)]


def half_ring(m):
    """Directions of a half turn, from -x over +y to +x: 4 m elements, as points on a square of half side 1 and on a circle of radius 1."""
    points = []
    for k in range(8 * m + 1):
        s = k / (8 * m) * 4.0  # along the square's border: 1 up, 2 across, 1 down
        square = (-1.0, s) if s <= 1.0 else (s - 2.0, 1.0) if s <= 3.0 else (1.0, 4.0 - s)
        angle = math.pi * (1.0 - k / (8 * m))
        points.append((square, (math.cos(angle), math.sin(angle))))
    return points


def extents(kind):
    """Of each sheet, from below: how far it goes from the weld to -x, to x, to both sides of that. Through: a free piece between
    two sheets that are pulled apart."""
    half, reach = WIDTH / 2.0, REACH[kind]
    left, right = (reach, OVERLAP, half), (OVERLAP, reach, half)
    return {"lap": (left, right), "peel": (left, left), "three": (left, right, left), "through": (left, (OVERLAP, OVERLAP, half), right),
            "cross": ((reach, reach, half), (half, half, reach))}[kind]


def planform(m, left, right, half):
    """Patches of a sheet from x = -left to right, y from 0 to half its width, as grids of points."""
    radius, core = DIAMETER / 2.0, 0.5 * DIAMETER / 2.0
    ring = half_ring(m)
    at = lambda points, u: points[round(u * 8 * m)]  # noqa: E731
    mix = lambda a, b, v: ((1 - v) * a[0] + v * b[0], (1 - v) * a[1] + v * b[1])  # noqa: E731
    inner = [(core * s[0], core * s[1]) for s, _ in ring]
    circle = [(radius * c[0], radius * c[1]) for _, c in ring]
    box = [(BOX * s[0], BOX * s[1]) for s, _ in ring]
    patches = [block(lambda u, v: (core * (2 * u - 1), core * v), 2 * m, m),
               block(lambda u, v: mix(at(inner, u), at(circle, u), v), 4 * m, max(1, m // 2)),
               block(lambda u, v: mix(at(circle, u), at(box, u), v), 4 * m, 2 * m, 1.4)]
    outer = max(m, round(m * (half - BOX) / 12.0))
    rows = ((0.0, BOX, m, 1.0), (BOX, half, outer, 1.3))
    for low, high, count, power in rows:
        for sign, end in ((-1.0, left), (1.0, right)):
            n = max(2, round(m * (end - BOX) / 10.0))
            patches.append(block(lambda u, v: (sign * (BOX + (end - BOX) * u ** 1.3), low + (high - low) * v), n, count, power))  # noqa: B023
    patches.append(block(lambda u, v: (BOX * (2 * u - 1), BOX + (half - BOX) * v), 2 * m, outer, 1.3))
    return patches


class Solids:
    def __init__(self, kind, m):
        self.kind, self.nodes, self.place, self.elements = kind, {}, [], []  # place: of each node
        layers = max(2, m // 2)
        self.sheets = extents(kind)
        for sheet, size in enumerate(self.sheets):
            for patch in planform(m, *size):
                self.add(patch, sheet, layers)

    def node(self, x, y, z, sheet):
        between = any(abs(z - k * THICKNESS) < 1e-9 for k in range(len(self.sheets) - 1))
        merged = between and x * x + y * y < (0.5 * DIAMETER) ** 2 + 1e-6
        key = (round(x, 5) + 0.0, round(y, 5) + 0.0, round(z, 5) + 0.0, -1 if merged else sheet)
        if key not in self.nodes:
            self.nodes[key] = len(self.nodes) + 1
            self.place.append((x, y, z))
        return self.nodes[key]

    def add(self, patch, sheet, layers):
        heights = [(sheet - 1) * THICKNESS + k * THICKNESS / (2 * layers) for k in range(2 * layers + 1)]
        number = lambda i, j, k: self.node(*patch[i][j], heights[k], sheet)  # noqa: E731
        corners = ((0, 0), (2, 0), (2, 2), (0, 2))
        sides = ((1, 0), (2, 1), (1, 2), (0, 1))
        for i in range(0, len(patch) - 1, 2):
            for j in range(0, len(patch[0]) - 1, 2):
                (ax, ay), (bx, by), (cx, cy) = patch[i][j], patch[i + 2][j], patch[i][j + 2]
                turned = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) < 0.0
                flip = (lambda places: [(b, a) for a, b in places]) if turned else list
                for k in range(0, 2 * layers, 2):
                    ring = [[number(i + a, j + b, k + up) for a, b in flip(places)]
                            for up, places in ((0, corners), (2, corners), (0, sides), (2, sides), (1, corners))]
                    self.elements.append([n for part in ring for n in part])

    def text(self, plastic):
        out = ["*NODE,NSET=ALL"] + [f"{n + 1},{x:.9g},{y:.9g},{z:.9g}" for n, (x, y, z) in enumerate(self.place)]
        out.append("*ELEMENT,TYPE=C3D20R,ELSET=EALL")
        for e, nodes in enumerate(self.elements):
            out += [",".join(map(str, [e + 1, *nodes[:9]])) + ",", ",".join(map(str, nodes[9:]))]
        grip = REACH[self.kind] - 1e-6
        ends = [(sheet, n) for (x, y, _, sheet), n in self.nodes.items() if max(abs(x), y) > grip]
        sets = {"HELD": [n for sheet, n in ends if sheet != MOVING[self.kind]], "PULLED": [n for sheet, n in ends if sheet == MOVING[self.kind]],
                "MIDDLE": [n for (_, y, _, _), n in self.nodes.items() if abs(y) < 1e-9]}
        for name, nodes in sets.items():
            out.append(f"*NSET,NSET={name}")
            out += [",".join(map(str, nodes[i:i + 12])) + "," for i in range(0, len(nodes), 12)]
        out += ["*MATERIAL,NAME=STEEL", "*ELASTIC", f"{YOUNG},{POISSON}"]
        if plastic:
            out += ["*PLASTIC", f"{YIELD},0.", f"{YIELD + PLASTIC},1."]
        out += ["*SOLID SECTION,ELSET=EALL,MATERIAL=STEEL", "*BOUNDARY", "HELD,1,3,0.", "MIDDLE,2,2,0."]
        stroke = STROKE[self.kind] if plastic else 1e-3
        axis = PULL[self.kind]
        out += ["*STEP,NLGEOM,INC=1000" if plastic else "*STEP", "*STATIC"]
        if plastic:
            out.append("0.02,1.,1e-6,0.04")
        out += ["*BOUNDARY"] + [f"PULLED,{dof},{dof},{stroke if dof == axis else 0.}" for dof in (1, 2, 3)]
        return "\n".join(out + ["*NODE PRINT,NSET=PULLED,TOTALS=ONLY", "RF", "*END STEP", ""])


def solve(kind, m, plastic, folder, ccx="ccx"):
    """[(displacement, force)] of the whole coupon."""
    name = f"{kind}_{m}_{'plastic' if plastic else 'elastic'}"
    data = folder / f"{name}.dat"
    if not data.exists():
        (folder / f"{name}.inp").write_text(Solids(kind, m).text(plastic), encoding="ascii")
        done = subprocess.run([ccx, name], cwd=folder, capture_output=True, text=True)
        (folder / f"{name}.log").write_text(done.stdout, encoding="utf-8")
    stroke, axis, curve, time = (STROKE[kind] if plastic else 1e-3), PULL[kind], [], 0.0
    for line in data.read_text(encoding="ascii").splitlines():
        at = re.search(r"and time\s+([-+.\dE]+)", line)
        if at:
            time = float(at[1])
        elif re.match(r"\s+[-+.\dE]+\s+[-+.\dE]+\s+[-+.\dE]+\s*$", line):
            curve.append((time * stroke, 2.0 * float(line.split()[axis - 1])))
    return curve


def force(curve, displacement):
    points = [(0.0, 0.0), *curve]
    for (a, f), (b, g) in zip(points, points[1:]):
        if a <= displacement <= b:
            return f + (g - f) * (displacement - a) / (b - a)
    return math.nan


def work(curve, strength):
    """Up to the displacement at which the force reaches `strength`."""
    points, done = [(0.0, 0.0), *curve], 0.0
    for (a, f), (b, g) in zip(points, points[1:]):
        if g >= strength:
            return done + 0.5 * (f + strength) * (b - a) * (strength - f) / (g - f)
        done += 0.5 * (f + g) * (b - a)
    return math.nan


def energy(curve, displacement):
    """Work up to a displacement."""
    points = [(u, f) for u, f in [(0.0, 0.0), *curve] if u < displacement] + [(displacement, force(curve, displacement))]
    return sum(0.5 * (f + g) * (b - a) for (a, f), (b, g) in zip(points, points[1:]))


def main(folder, coupon="book", ccx="ccx"):
    global THICKNESS, DIAMETER, YIELD, PLASTIC
    THICKNESS, DIAMETER, YIELD, PLASTIC = COUPONS[coupon]
    folder = pathlib.Path(folder) / coupon
    folder.mkdir(parents=True, exist_ok=True)
    for kind in REACH:
        for m in (2, 3):
            (u, f), = solve(kind, m, False, folder, ccx)
            print(f"{kind}, {len(Solids(kind, m).elements)} bricks: stiffness {f / u:.0f} N/mm", flush=True)
    for kind, places in DISPLACEMENTS.items():
        for m in (2, 3):
            curve = solve(kind, m, True, folder, ccx)
            strength = STRENGTH * force(curve, places[-1])
            print(f"{kind}, {len(Solids(kind, m).elements)} bricks: " +
                  ", ".join(f"{force(curve, u):.0f} N at {u:g} mm" for u in places) +
                  f"; {energy(curve, places[-1]):.0f} N mm up to there, {work(curve, strength):.0f} N mm up to {strength:.0f} N", flush=True)


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3, 4):
        sys.exit(__doc__)
    main(*sys.argv[1:])
