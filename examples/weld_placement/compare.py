# SPDX-License-Identifier: Apache-2.0
"""Reads what `nugget run` wrote for centre.k, edge.k and corner.k and prints the three welds side by side.

    python3 examples/weld_placement/compare.py RESULTS [CASE ...]     (with RESULTS/CASE; without them centre, edge, corner)

The weld may be a beam, a brick or an assembly of bricks, as `nugget weld --as solid4` makes it of placed/. Also writes RESULTS/histories.csv: time, elongation of the coupon, force and length of the weld, for plotting.
"""
import pathlib
import re
import sys

CASES = ("centre", "edge", "corner")
REFERENCE = 62.5  # kN/mm, elastic stiffness of this coupon as a model of three-dimensional solids (CalculiX, C3D20R)


def read_swforc(path):
    """[(time, axial force, shear force, length)] of the only weld up to its failure, and the time of that or None."""
    rows, welds = [], set()
    for line in path.read_text(encoding="ascii").splitlines():
        row = re.match(r"\s*\d+\s+(\S+)\s+(\S+)\s+(\S+)\s.*spotweld (beam|solid|assmy)\s+ID\s+(\d+)(.*)", line)
        if not row:
            continue
        axial, shear, time, _, weld, tail = row.groups()
        welds.add(weld)
        if len(welds) > 1:
            sys.exit(f"{path}: welds {', '.join(sorted(welds))}; this script compares coupons of one weld (bricks of one weld: "
                     "*DEFINE_HEX_SPOTWELD_ASSEMBLY)")
        if "failure time=" in tail:
            return rows, float(tail.split("=")[1])
        rows.append((float(time), float(axial), float(shear), float(tail.split()[0])))
    if not rows:
        sys.exit(f"{path}: no weld beam, brick or assembly")
    return rows, None


def read_nodout(path):
    """[(time, x-displacement)] of the only node. The block of rotations that follows each time is passed over."""
    rows, time, wanted = [], 0.0, False
    for line in path.read_text(encoding="ascii").splitlines():
        at = re.search(r"at time\s*([-+.\dE]+)", line)
        row = re.match(r"\s*\d+\s*([-+]?\d\.\d+E[-+]\d+)", line)
        if at:
            time = float(at.group(1))
        elif "nodal point" in line:
            wanted = "x-disp" in line
        elif row and wanted:
            rows.append((time, float(row.group(1))))
    return rows


def interpolate(rows, at):
    for (t0, u0), (t1, u1) in zip(rows, rows[1:]):
        if t0 <= at <= t1:
            return u0 + (u1 - u0) * (at - t0) / (t1 - t0)
    return rows[-1][1]


def slope(points):
    """Of the least-squares line through (x, y); None of fewer than two x."""
    n = len(points)
    if len({x for x, _ in points}) < 2:
        return None
    mx, my = sum(x for x, _ in points) / n, sum(y for _, y in points) / n
    return sum((x - mx) * (y - my) for x, y in points) / sum((x - mx) ** 2 for x, _ in points)


def column(value, form):
    return f"{value:{form}}" if value is not None else f"{'none':>{form.split('.')[0]}}"


def main(results, cases=CASES):
    print(f"{'weld over':<12}{'stiffness':>10}{'of solids':>10}{'peak force':>12}{'elongation':>12}{'weld length':>13}{'failure':>10}")
    print(f"{'':<12}{'kN/mm':>10}{'%':>10}{'kN':>12}{'at it, mm':>12}{'at it, mm':>13}{'ms':>10}")
    csv = ["case,time,elongation,axial,shear,length"]
    for case in cases:
        grip = read_nodout(results / case / "nodout")
        histories, failure = read_swforc(results / case / "swforc")
        weld = [(t, interpolate(grip, t), axial, shear, length) for t, axial, shear, length in histories]
        csv += [f"{case},{t:.6e},{u:.6e},{axial:.6e},{shear:.6e},{length:.6e}" for t, u, axial, shear, length in weld]
        elastic = [(u, shear) for _, u, _, shear, _ in weld if 300.0 < shear < 2000.0]
        stiffness = slope(elastic)
        share = None if stiffness is None else 100.0 * stiffness / 1000.0 / REFERENCE
        _, u, _, shear, length = max(weld, key=lambda row: row[3])
        print(f"{case:<12}" + column(None if stiffness is None else stiffness / 1000.0, "10.1f") + column(share, "10.0f")
              + f"{shear / 1000.0:12.2f}{u:12.3f}{length:13.4f}" + column(1000.0 * failure if failure else None, "10.3f"))
    (results / "histories.csv").write_text("\n".join(csv) + "\n", encoding="ascii")
    print(f"histories: {results / 'histories.csv'}")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(pathlib.Path(sys.argv[1]), sys.argv[2:] or CASES)
