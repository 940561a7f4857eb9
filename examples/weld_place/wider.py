# SPDX-License-Identifier: Apache-2.0
"""How far the joint (--weld-tie joint) reaches: cross tension and stacks of three sheets beside lap and peel, unlike and skewed meshes, and
welds that fail. Three: the middle sheet is pulled, the others are held; through: the outer ones are pulled apart over a free middle one.

    python3 examples/weld_place/wider.py NUGGET FOLDER [COUPON [SIZE ...]]

Each coupon on square meshes, with a second sheet of other elements (unlike) and on skewed meshes, three places of the weld in its element,
tied by the element under it and with a joint: elastic stiffness, forces beyond yield, peak force and work of a weld that fails, over those of
solids (solids.py, CalculiX); energy: work up to the last displacement of a weld that holds. Writes FOLDER/wider.csv and FOLDER/wider.svg, prints the ranges and where they keep to the aims, and the errors
over what `nugget check` says of the weld: hold_by_area. Finished runs are not repeated; all take a quarter of an hour on two cores.
"""
import concurrent.futures
import csv
import json
import math
import os
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import study  # noqa: E402
from solids import COUPONS, DISPLACEMENTS, PULL, REACH, STRENGTH, energy  # noqa: E402

SIZES = (5.0, 8.0)
PLACES = ((0.5, 0.5), (0.25, 0.25), (0.0, 0.0))
MESHES = ("square", "unlike", "skewed")
TIES = ("segment", "joint")
COLOURS = {"segment": "#c33", "joint": "#181"}
AIMS = {"lap": 0.05, "three": 0.05, "through": 0.05, "peel": 0.12, "cross": 0.12, "force": 0.08, "failure": 0.06}
# By solids.py, its finer mesh: stiffness, N/mm; forces, N; work up to STRENGTH of the last of them and up to the last displacement,
# N mm.
SOLIDS = {
    ("book", "lap"): (61990.0, (5457.0, 7802.0, 8856.0), 1910.0, 3363.0),
    ("book", "peel"): (771.0, (363.0, 574.0, 706.0), 544.0, 987.0),
    ("book", "cross"): (1105.0, (561.0, 1034.0, 1271.0), 762.0, 1130.0),
    ("book", "three"): (129700.0, (9460.0, 12512.0, 14289.0), 3244.0, 5505.0),
    ("book", "through"): (28570.0, (2825.0, 4957.0, 5643.0), 1126.0, 2048.0),
    ("mild", "lap"): (40130.0, (2732.0, 3773.0, 4441.0), 1072.0, 1659.0),
    ("mild", "peel"): (223.0, (103.0, 163.0, 201.0), 155.0, 281.0),
    ("mild", "cross"): (324.0, (167.0, 314.0, 407.0), 256.0, 345.0),
    ("mild", "three"): (84570.0, (4258.0, 5962.0, 6914.0), 1598.0, 2632.0),
    ("mild", "through"): (18560.0, (1590.0, 2373.0, 2868.0), 707.0, 1026.0),
    ("strong", "lap"): (31540.0, (3489.0, 6060.0, 6519.0), 997.0, 2483.0),
    ("strong", "peel"): (112.0, (56.0, 112.0, 205.0), 169.0, 217.0),
    ("strong", "cross"): (165.0, (87.0, 197.0, 349.0), 191.0, 225.0),
    ("strong", "three"): (66700.0, (6254.0, 8196.0, 8902.0), 1512.0, 3564.0),
    ("strong", "through"): (14600.0, (1793.0, 3942.0, 4797.0), 1017.0, 1584.0),
}


def reference(coupon, kind, what):
    stiffness, forces, work, whole = SOLIDS[coupon, kind]
    if what in ("stiffness", "energy"):
        return stiffness if what == "stiffness" else whole
    if what in ("peak", "work"):
        return STRENGTH * forces[-1] if what == "peak" else work
    return forces[DISPLACEMENTS[kind].index(float(what.split()[-2]))]


def aim(kind, what):
    return AIMS[kind] if what == "stiffness" else AIMS["failure"] if what in ("energy", "peak", "work") else AIMS["force"]


def curve(kind, results):
    """[(displacement, force)] of the grip, over time; where it goes back a little, what went before counts."""
    number = r"\s*([-+]?\d\.\d+E[-+]\d+)"
    skip = r"(?:\s*[-+]?\d\.\d+E[-+]\d+)" + "{%d}" % (PULL[kind] - 1)
    reaction = study.column(results / "spcforc", r"force\s+resultants?\s*=?" + skip + number)
    grip = study.column(results / "nodout", r"^\s*\d+" + skip + number)
    points = []
    for t in sorted(reaction.keys() & grip.keys()):
        if not points or grip[t] > points[-1][0]:
            points.append((grip[t], abs(reaction[t])))
    return points


def until_failure(kind, results):
    """Largest force of the grip until the last weld fails (through: one), and its work up to there; of a weld that does not fail, none."""
    number = r"\s*([-+]?\d\.\d+E[-+]\d+)"
    skip = r"(?:\s*[-+]?\d\.\d+E[-+]\d+)" + "{%d}" % (PULL[kind] - 1)
    reaction = study.column(results / "spcforc", r"force\s+resultants?\s*=?" + skip + number)
    grip = study.column(results / "nodout", r"^\s*\d+" + skip + number)
    welds = json.loads((results / "summary.json").read_text(encoding="utf-8"))["weld"]
    failed = [weld["failure_time"] for weld in welds if weld["failed"]]
    if len(failed) < (1 if kind == "through" else len(welds)):  # through: one after the other
        return math.nan, math.nan
    end = max(failed)
    peak, work, before = 0.0, 0.0, (0.0, 0.0)
    for t in sorted(reaction.keys() & grip.keys()):
        if t > end:
            break
        now = (grip[t], abs(reaction[t]))
        work += 0.5 * (now[1] + before[1]) * (now[0] - before[0])
        peak = max(peak, now[1])
        before = now
    return peak, work


def hold(nugget, path):
    """The larger of the reaches of the weld's ends that `nugget check` gives."""
    results = path.with_name(path.stem + "_check")
    if not (results / "welds.csv").exists():
        subprocess.run([str(nugget), "check", str(path), "-o", str(results), "--weld-tie", "joint"], capture_output=True, check=True)
    with open(results / "welds.csv", encoding="utf-8") as file:
        return max(float(row["hold_by_area"]) for row in csv.DictReader(file))


def case(nugget, folder, coupon, kind, mesh, size, number):
    """Rows of one coupon on one mesh."""
    place, name = PLACES[number], f"{coupon}_{kind}_{mesh}_{size:g}_{number}"
    welds = len(study.extents(kind)) - 1 if kind == "three" else 1  # that share the force
    decks = {"elastic": (False, 0.0), "plastic": (True, 0.0), "failing": (True, STRENGTH * SOLIDS[coupon, kind][1][-1] / welds)}
    rows = []
    for what, (plastic, strength) in decks.items():
        path = folder / f"{name}_{what}.k"
        study.deck(coupon, kind, size, place, plastic, form=mesh, strength=strength).write(path)
        reach = hold(nugget, path) if what == "elastic" else reach
        for tie in TIES:
            results = study.run(nugget, path, tie)
            found = {}
            if what == "elastic":
                found["stiffness"] = study.stiffness(results)
            elif what == "plastic":
                found = {f"force at {u:g} mm": f for u, f in zip(DISPLACEMENTS[kind], study.forces(kind, results))}
                found["energy"] = energy(curve(kind, results), DISPLACEMENTS[kind][-1])
            else:
                found["peak"], found["work"] = until_failure(kind, results)
            rows += [{"coupon": coupon, "kind": kind, "mesh": mesh, "size": size, "along": place[0], "across": place[1], "tie": tie,
                      "hold": reach, "what": quantity, "value": value, "over_solids": value / reference(coupon, kind, quantity)}
                     for quantity, value in found.items()]
    return rows


def cells(rows, tie):
    over = [r["over_solids"] for r in rows if r["tie"] == tie]
    held = [o for o in over if not math.isnan(o)]
    return (f"{100 * min(held):.0f} … {100 * max(held):.0f}" if held else "") + (f" ({len(over) - len(held)} hold)" if len(held) < len(over) else "")


def table(rows):
    """Markdown: a line for each quantity, a column for each mesh and size; last, how much of it keeps to the aim with a joint."""
    columns = sorted({(MESHES.index(r["mesh"]), r["size"]) for r in rows})
    print("| | tied by | " + " | ".join(f"{MESHES[m]}, {size:g} mm" for m, size in columns) + " | aim | within |")
    print("|---" * (len(columns) + 4) + "|")
    for coupon, kind, what in dict.fromkeys((r["coupon"], r["kind"], r["what"]) for r in rows):
        of = [r for r in rows if (r["coupon"], r["kind"], r["what"]) == (coupon, kind, what)]
        for tie in TIES:
            line = [cells([r for r in of if (MESHES.index(r["mesh"]), r["size"]) == c], tie) for c in columns]
            within = ""
            if tie == "joint":
                joined = [r for r in of if r["tie"] == tie]
                within = f"{sum(abs(r['over_solids'] - 1.0) <= aim(kind, what) for r in joined)} of {len(joined)}"
            print(f"| {coupon}, {kind}, {what} | {tie} | " + " | ".join(line) + f" | {100 * aim(kind, what):.0f} % | {within} |")


def by_hold(rows):
    """Largest errors with a joint over the reach of the ends."""
    edges = (0.0, 1.7, 2.1, 2.8, 3.3, 4.5)
    print("\n| hold_by_area | " + " | ".join(f"{kind}, {what}" for kind in REACH for what in ("stiffness", "force", "energy")) + " |")
    print("|---" * (1 + 3 * len(REACH)) + "|")
    for low, high in zip(edges, edges[1:]):
        line = []
        for kind in REACH:
            for what in ("stiffness", "force", "energy"):
                over = [r["over_solids"] for r in rows if r["tie"] == "joint" and r["kind"] == kind and r["what"].startswith(what) and
                        low <= r["hold"] < high and not math.isnan(r["over_solids"])]
                line.append(f"{100 * min(over):.0f} … {100 * max(over):.0f}" if over else "")
        if any(line):
            print(f"| {low:g} to {high:g} | " + " | ".join(line) + " |")


def draw(rows, path):
    """A panel for each kind and quantity: a dot a case, in columns of meshes; plain SVG."""
    width, height, left, top = 230, 120, 40, 40
    quantities = ("stiffness", "force", "energy", "peak")
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{4 * (width + left) + 10}" height="{len(REACH) * (height + 46) + 50}" font-family="sans-serif" '
           'font-size="11">', '<rect width="100%" height="100%" fill="white"/>']
    for i, kind in enumerate(REACH):
        for k, what in enumerate(quantities):
            x0, y0, most = left + k * (width + left), top + i * (height + 46), 2.0
            at = lambda over: y0 + height * (1.0 - min(max(over, 0.0), most) / most)  # noqa: B023, E731
            gate = aim(kind, what)
            out.append(f'<text x="{x0}" y="{y0 - 6}">{kind}: {what}, over that of solids</text>')
            out.append(f'<rect x="{x0}" y="{at(1 + gate):.1f}" width="{width - 10}" height="{at(1 - gate) - at(1 + gate):.1f}" fill="#def"/>')
            for level in (0.0, 0.5, 1.0, 1.5, 2.0):
                out.append(f'<line x1="{x0}" x2="{x0 + width - 10}" y1="{at(level):.1f}" y2="{at(level):.1f}" stroke="#ddd"/>')
                out.append(f'<text x="{x0 - 24}" y="{at(level) + 4:.1f}">{level:.1f}</text>')
            for m, mesh in enumerate(MESHES):
                out.append(f'<text x="{x0 + 20 + m * 70}" y="{y0 + height + 14}">{mesh}</text>')
                for n, tie in enumerate(TIES):
                    of = [r for r in rows if (r["kind"], r["mesh"], r["tie"]) == (kind, mesh, tie) and r["what"].startswith(what) and
                          not math.isnan(r["over_solids"])]
                    dots = "".join(f"M{x0 + 12 + m * 70 + n * 30 + 24.0 * j / max(1, len(of)):.1f} {at(r['over_solids']):.1f}h0"
                                   for j, r in enumerate(of))
                    out.append(f'<path d="{dots}" stroke="{COLOURS[tie]}" stroke-width="3.6" stroke-linecap="round" stroke-opacity="0.6"/>')
    for n, (tie, words) in enumerate((("segment", "tied by the element under the weld"), ("joint", "with a joint; band: the aim"))):
        out.append(f'<text x="{left + 230 * n}" y="14" fill="{COLOURS[tie]}">{words}</text>')
    path.write_text("\n".join(out + ["</svg>", ""]), encoding="utf-8")


def main(nugget, folder, coupon="", *sizes):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    cases = [(c, kind, mesh, size, n) for c in ([coupon] if coupon else COUPONS) for kind in REACH for mesh in MESHES
             for size in ([float(s) for s in sizes] or SIZES) for n in range(len(PLACES))]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        rows = [row for one in pool.map(lambda c: case(nugget, folder, *c), cases) for row in one]
    with open(folder / f"wider{coupon}.csv", "w", encoding="ascii", newline="") as file:
        writer = csv.DictWriter(file, rows[0].keys())
        writer.writeheader()
        writer.writerows(rows)
    table(rows)
    by_hold(rows)
    draw(rows, folder / f"wider{coupon}.svg")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
