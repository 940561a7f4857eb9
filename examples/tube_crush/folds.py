# SPDX-License-Identifier: Apache-2.0
"""Why the tube's mean force is what it is: a quarter of it with symmetry planes, on several meshes and with other contact, integration and
hardening, and for each run the mean force, the length of a fold and the share of it that is crushed.

    python3 examples/tube_crush/folds.py NUGGET FOLDER [NAME...]

Finished runs are not repeated. Units: mm, t, s, N, MPa.
"""
import json
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import crushing  # noqa: E402
from crush_study import FROM, TO, mean, wall_force  # noqa: E402
from make import DENT_AT, DENT_DEPTH, DENT_REACH, LENGTH, SIDE, THICKNESS, TUBE, YIELD  # noqa: E402

CRUSH = 120.0
FIRST_FOLD = 55.0  # crests that stood below this height belong to the first fold, which the wall flattens [mm]
BOUND = 9.56 * YIELD * SIDE ** (1 / 3) * THICKNESS ** (5 / 3) / 1000.0  # closed form without effective distance [kN]
# Side of the elements, and what differs.
RUNS = {
    "5": (5.0, {}, {}),
    "2p5": (2.5, {}, {}),
    "1p7": (5.0 / 3.0, {}, {}),
    "2p5_thin": (2.5, {}, {"thickness": 0.2}),
    "2p5_smooth": (2.5, {}, {"friction": 0.0}),
    "2p5_stiff": (2.5, {}, {"stiffness": 10.0}),
    "2p5_points": (2.5, {"points": 9}, {}),
    "2p5_full": (2.5, {"elform": 16}, {}),
    "5_hardens": (5.0, {"tangent": 500.0}, {}),
    "2p5_hardens": (2.5, {"tangent": 500.0}, {}),
}


def quarter(size):
    """Nodes, shells, and the columns of nodes at the middles of both walls."""
    half, along = round(SIDE / 2 / size), round(LENGTH / size)
    n = 2 * half + 1
    nodes, shells = {}, {}
    number = lambda j, k: j * n + k + 1  # noqa: E731
    for j in range(along + 1):
        z = LENGTH * j / along
        d = crushing.dent(z, DENT_AT, DENT_REACH, DENT_DEPTH)
        for k in range(n):
            s = SIDE / 2 * (k - half) / half  # from the corner, along either wall
            x, y = (SIDE / 2 + s, -SIDE / 2 + d) if k < half else (SIDE / 2 + d, -SIDE / 2 + s)
            nodes[number(j, k)] = (SIDE / 2, -SIDE / 2, z) if k == half else (x, y, z)
    for j in range(along):
        for k in range(n - 1):
            shells[len(shells) + 1] = (TUBE, (number(j, k), number(j, k + 1), number(j + 1, k + 1), number(j + 1, k)))
    columns = [[number(j, k) for j in range(along)] for k in (0, n - 1)]
    return nodes, shells, columns, [number(along, k) for k in range(n)]


def deck(size, sheet, contact):
    nodes, shells, columns, rear = quarter(size)
    d = crushing.begin("A quarter of the square tube, axial crush", f"Elements of {size:.2f} mm.", CRUSH)
    crushing.sheets(d, THICKNESS, YIELD, [(TUBE, "tube")], **sheet)
    crushing.cap(d, nodes, shells, rear, LENGTH, SIDE)
    crushing.wall_and_contact(d, LENGTH, [TUBE], **contact)
    for sid, column, fixed in ((5, columns[0], (1, 0, 0, 0, 1, 1)), (6, columns[1], (0, 1, 0, 1, 0, 1))):
        d.node_set(sid, column)
        d.keyword("BOUNDARY_SPC_SET")
        d.card(nsid=sid, cid=0, **dict(zip(("dofx", "dofy", "dofz", "dofrx", "dofry", "dofrz"), fixed)))
    d.keyword("DATABASE_NODOUT")
    d.card(dt=CRUSH / crushing.SPEED / 60)
    d.keyword("DATABASE_HISTORY_NODE")
    d.ids(columns[0] + columns[1])
    d.nodes(nodes)
    d.shells(shells)
    return d, columns


def last_places(nodout):
    """{node: (x, y, z)} at the end."""
    places = {}
    for line in nodout.read_text(encoding="ascii").splitlines():
        words = line.split()
        if len(words) == 13 and words[0].isdigit():
            places[int(words[0])] = tuple(float(w) for w in words[10:13])
    return places


def crests(column, places, axis):
    """[(height at first, height now)] where the wall's middle stands out or in the most."""
    out = [abs(places[n][axis]) - SIDE / 2 for n in column]
    return [(LENGTH * i / len(column), places[n][2]) for i, n in enumerate(column)
            if 0 < i < len(column) - 1 and 3.0 < abs(out[i]) >= abs(out[i - 1]) and abs(out[i]) > abs(out[i + 1])]


def fold(columns, places):
    """(length of a fold, share of it that is crushed), the mean over both walls."""
    found = []
    for column, axis in zip(columns, (1, 0)):
        beyond = [c for c in crests(column, places, axis) if c[0] > FIRST_FOLD]
        if len(beyond) > 1:
            (first, now), (last, end) = beyond[0], beyond[-1]
            found.append(((last - first) / (len(beyond) - 1), 1.0 - (end - now) / (last - first)))
    return [sum(values) / len(found) for values in zip(*found)]


def main(nugget, folder, names):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    print(f"closed form without effective distance {BOUND:.1f} kN")
    print("run            mean [kN]   fold [mm]   crushed   mean x crushed [kN]   energy ratio")
    for name, (size, sheet, contact) in RUNS.items():
        if names and name not in names:
            continue
        d, columns = deck(size, sheet, contact)
        d.write(folder / f"{name}.k")
        results = folder / name
        if not (results / "summary.json").exists():
            subprocess.run([nugget, "run", f"{name}.k", "-j1", "--quiet", "-o", name], cwd=folder, check=True)
        ratio = json.loads((results / "summary.json").read_text(encoding="utf-8"))["energy"]["ratio"]
        force = 4.0 * mean(wall_force(results), FROM, TO - 1e-6)
        length, share = fold(columns, last_places(results / "nodout"))
        print(f"{name:12s} {force:11.2f} {length:11.1f} {share:9.2f} {force * share:21.2f} {ratio:14.6f}", flush=True)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2], sys.argv[3:])
