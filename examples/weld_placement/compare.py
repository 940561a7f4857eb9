# SPDX-License-Identifier: Apache-2.0
"""Reads what `nugget run` wrote for centre.k, edge.k and corner.k and prints the three welds side by side.

    python3 examples/weld_placement/compare.py RESULTS     (with RESULTS/centre, RESULTS/edge, RESULTS/corner)

Also writes RESULTS/histories.csv: time, elongation of the coupon, force and length of the weld, for plotting.
"""
import pathlib
import re
import sys

CASES = ("centre", "edge", "corner")
REFERENCE = 62.5  # kN/mm, elastic stiffness of this coupon as a model of three-dimensional solids (CalculiX, C3D20R)


def read_swforc(path):
    """[(time, axial force, shear force, length)] of the only weld, up to its failure."""
    rows = []
    for line in path.read_text(encoding="ascii").splitlines():
        if "spotweld beam" in line and "failure time" not in line:
            numbers, tail = line.split("spotweld beam")
            _, axial, shear, time = numbers.split()[:4]
            rows.append((float(time), float(axial), float(shear), float(tail.split()[2])))
    return rows


def read_nodout(path):
    """[(time, x-displacement)] of the only node."""
    rows, time = [], None
    for line in path.read_text(encoding="ascii").splitlines():
        match = re.search(r"at time\s*([-+.\dE]+)", line)
        if match:
            time = float(match.group(1))
        elif time is not None and re.match(r"\s*\d+\s*[-+]?\d\.\d+E", line):
            rows.append((time, float(re.match(r"\s*\d+\s*([-+]?\d\.\d+E[-+]\d+)", line).group(1))))
            time = None  # a second block of rotations has the same shape
    return rows


def interpolate(rows, at):
    for (t0, u0), (t1, u1) in zip(rows, rows[1:]):
        if t0 <= at <= t1:
            return u0 + (u1 - u0) * (at - t0) / (t1 - t0)
    return rows[-1][1]


def slope(points):
    """Of the least-squares line through (x, y)."""
    n = len(points)
    mx, my = sum(x for x, _ in points) / n, sum(y for _, y in points) / n
    return sum((x - mx) * (y - my) for x, y in points) / sum((x - mx) ** 2 for x, _ in points)


def main(results):
    print(f"{'weld over':<12}{'stiffness':>12}{'of solids':>12}{'peak force':>12}{'elongation':>12}{'weld length':>14}")
    print(f"{'':<12}{'kN/mm':>12}{'%':>12}{'kN':>12}{'at peak, mm':>12}{'at peak, mm':>14}")
    csv = ["case,time,elongation,axial,shear,length"]
    for case in CASES:
        grip = read_nodout(results / case / "nodout")
        weld = [(t, interpolate(grip, t), axial, shear, length) for t, axial, shear, length in
                read_swforc(results / case / "swforc")]
        csv += [f"{case},{t:.6e},{u:.6e},{axial:.6e},{shear:.6e},{length:.6e}" for t, u, axial, shear, length in weld]
        elastic = [(u, shear) for _, u, _, shear, _ in weld if 300.0 < shear < 2000.0]
        stiffness = slope(elastic) / 1000.0
        _, u, _, shear, length = max(weld, key=lambda row: row[3])
        print(f"{case:<12}{stiffness:12.1f}{100.0 * stiffness / REFERENCE:12.0f}{shear / 1000.0:12.2f}{u:12.3f}{length:14.4f}")
    (results / "histories.csv").write_text("\n".join(csv) + "\n", encoding="ascii")
    print(f"histories: {results / 'histories.csv'}")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(pathlib.Path(sys.argv[1]))
