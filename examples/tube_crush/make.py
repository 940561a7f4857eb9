# SPDX-License-Identifier: Apache-2.0
"""Writes the axial crush of a square tube on several meshes: tube_5.k, tube_4.k, tube_2p5.k, tube_2.k.

    python3 examples/tube_crush/make.py FOLDER [CRUSH]

CRUSH: by how many mm, 120 if not given. Units: mm, t, s, N, MPa. No dependencies; the same bytes at every call.
"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import crushing  # noqa: E402

SIDE, THICKNESS, LENGTH = 50.0, 1.5, 200.0
YIELD = 300.0
SIZES = {"5": 5.0, "4": 50.0 / 12.0, "2p5": 2.5, "2": 50.0 / 26.0}
DENT_AT, DENT_REACH, DENT_DEPTH = 20.0, 15.0, 0.75
TUBE = 1


def tube(size):
    """Nodes, shells, rear edge. The dent goes in on two opposite walls and out on the others; corners stay."""
    across, along = round(SIDE / size), round(LENGTH / size)
    ring = []
    for k in range(across):
        s = SIDE * k / across
        ring.append((s - SIDE / 2, -SIDE / 2, 0))
    for k in range(across):
        ring.append((SIDE / 2, SIDE * k / across - SIDE / 2, 1))
    for k in range(across):
        ring.append((SIDE / 2 - SIDE * k / across, SIDE / 2, 2))
    for k in range(across):
        ring.append((-SIDE / 2, SIDE / 2 - SIDE * k / across, 3))
    nodes, shells = {}, {}
    n = len(ring)
    number = lambda j, k: j * n + k % n + 1  # noqa: E731
    for j in range(along + 1):
        z = LENGTH * j / along
        for k, (x, y, wall) in enumerate(ring):
            corner = k % across == 0
            d = 0.0 if corner else crushing.dent(z, DENT_AT, DENT_REACH, DENT_DEPTH)
            if wall % 2 == 0:
                y -= d if y > 0 else -d
            else:
                x += d if x > 0 else -d
            nodes[number(j, k)] = (x, y, z)
    for j in range(along):
        for k in range(n):
            shells[len(shells) + 1] = (TUBE, (number(j, k), number(j, k + 1), number(j + 1, k + 1), number(j + 1, k)))
    return nodes, shells, [number(along, k) for k in range(n)]


def make(size, crush=120.0, elform=2):
    nodes, shells, rear = tube(size)
    d = crushing.begin(
        f"Square tube {SIDE:g} x {SIDE:g} x {THICKNESS:g}, axial crush, elements of {size:.2f} mm",
        f"Mean force of the closed form (Wierzbicki and Abramowicz): 13.06 sigma0 c^(1/3) h^(5/3) = "
        f"{13.06 * YIELD * SIDE ** (1 / 3) * THICKNESS ** (5 / 3) / 1000:.1f} kN.", crush)
    crushing.sheets(d, THICKNESS, YIELD, [(TUBE, "tube")], elform)
    crushing.cap(d, nodes, shells, rear, LENGTH, SIDE)
    crushing.wall_and_contact(d, LENGTH, [TUBE])
    d.nodes(nodes)
    d.shells(shells)
    return d


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for name, size in SIZES.items():
        make(size, float(sys.argv[2]) if len(sys.argv) == 3 else 120.0).write(folder / f"tube_{name}.k")
