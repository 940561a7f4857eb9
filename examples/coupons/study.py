# SPDX-License-Identifier: Apache-2.0
"""Runs the coupons and sets them beside three-dimensional models of solids (CalculiX).

    python3 examples/coupons/study.py NUGGET FOLDER [NAME...]

Writes FOLDER/NAME.k and runs them into FOLDER/NAME (all, or those named; finished runs are not repeated), then prints the tables and writes
FOLDER/curves.csv and, where Python has matplotlib, FOLDER/curves.svg.
"""
import bisect
import json
import pathlib
import re
import subprocess
import sys

import make

# Force [N] over displacement of the grip [mm], work [N mm] up to the last one, elastic stiffness [N/mm]: models of 20-node bricks, two
# layers a sheet, sheets yielding at 300 with a plastic modulus of 1500, elastic nugget, large displacements.
SOLIDS = {
    "lap": ([(.05, 3244), (.1, 5846), (.15, 7368), (.2, 8186), (.3, 9132), (.5, 10203), (.75, 11050), (1, 11704), (1.5, 12669),
             (2, 13331)], 21982, 62500),
    "peel": ([(.5, 233), (1, 385), (2, 563), (3, 692), (4, 812), (6, 972), (8, 1093), (10, 1213), (12, 1344)], 10810, 472),
    "cross": ([(.5, 251), (1, 524), (2, 1040), (3, 1420), (4, 1800), (6, 2611), (8, 3463)], 14365, 490),
}
# The same lap coupon with an elastic square of 40/7 mm merged instead of the circle: half of it, 1,040 bricks.
SQUARE = [(.05, 3296), (.1, 5898), (.15, 7481), (.2, 8381), (.3, 9417), (.5, 10768), (.75, 12014)]
ACROSS = ("five", "seven", "nine", "eleven", "thirteen", "fifteen")  # elements of the lap coupon
MIDDLE = {"lap": 0.5, "peel": 4.0, "cross": 4.0}  # displacement at which meshes are compared


def column(path, pattern):
    """{time: value}: `pattern` finds the value in lines after one with the time."""
    rows, time = {}, 0.0
    for line in path.read_text(encoding="ascii").splitlines():
        at = re.search(r"at time\s*=?\s*([-+.\dE]+)", line)
        found = re.search(pattern, line)
        if at:
            time = float(f"{float(at[1]):.4e}")  # files give it with five to eight digits
        elif found and time not in rows:
            rows[time] = float(found[1])
    return rows


class Curve:
    """Force in the grip over its displacement."""

    def __init__(self, kind, results):
        number = r"\s*([-+]?\d\.\d+E[-+]\d+)"
        skip = r"(?:\s*[-+]?\d\.\d+E[-+]\d+)" + "{%d}" % (make.PULL[kind] - 1)
        force = column(results / "spcforc", r"force\s+resultants?\s*=?" + skip + number)
        grip = column(results / "nodout", r"^\s*\d+" + skip + number)
        self.times = sorted(force.keys() & grip.keys())
        self.points = [(grip[t], -force[t]) for t in self.times]
        self.weld = json.loads((results / "summary.json").read_text(encoding="utf-8"))["weld"][0]

    def force(self, u):
        at = bisect.bisect_left(self.points, (u, -1e30))
        if at in (0, len(self.points)):
            return self.points[-1][1] if at else 0.0
        (a, f), (b, g) = self.points[at - 1], self.points[at]
        return f + (g - f) * (u - a) / (b - a)

    def work(self, until):
        points = [p for p in self.points if p[0] < until] + [(until, self.force(until))]
        return sum(0.5 * (f + g) * (b - a) for (a, f), (b, g) in zip(points, points[1:]))

    def stiffness(self):
        """Slope of the least-squares line through the origin."""
        return sum(u * f for u, f in self.points) / sum(u * u for u, _ in self.points)

    def force_at_failure(self):
        """In the grip, just before the weld goes; the sheets spring back afterwards."""
        return self.points[bisect.bisect_left(self.times, self.weld["failure_time"]) - 1][1]


def run(nugget, folder, names):
    curves = {}
    for name, deck in make.decks().items():
        if names and name not in names:
            continue
        results = folder / name
        if not (results / "summary.json").exists():
            deck.write(folder / f"{name}.k")
            command = [nugget, "run", folder / f"{name}.k", "-o", results, "-j1", "--quiet"]
            done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
            if done.returncode:
                sys.exit(f"{name}: {done.stderr}")
        curves[name] = Curve(name.split("_")[0], results)
    return curves


def table(head, rows):
    widths = [max(len(str(row[i])) for row in [head, *rows]) for i in range(len(head))]
    for row in [head, ["-" * w for w in widths], *rows]:
        print("| " + " | ".join(str(cell).rjust(w) for cell, w in zip(row, widths)) + " |")
    print()


def report(curves):
    for kind, (reference, work, stiffness) in SOLIDS.items():
        welds = [w for w in ("seven", *make.WELDS) if f"{kind}_{w}" in curves]
        rows = [[f"{u:g}", f] + [f"{curves[f'{kind}_{w}'].force(u):.0f}" for w in welds] for u, f in reference]
        rows.append(["work", work] + [f"{curves[f'{kind}_{w}'].work(reference[-1][0]):.0f}" for w in welds])
        if welds:
            table([f"{kind}, mm", "solids"] + welds, rows)
        if f"{kind}_elastic" in curves:
            print(f"{kind}: elastic stiffness {curves[f'{kind}_elastic'].stiffness():.0f} N/mm, solids {stiffness}\n")
        meshes = [(size, over) for size in (3, 5, 8) for over in make.OVERS if f"{kind}_{size}mm_{over}" in curves]
        if meshes:
            at = MIDDLE[kind]
            solids = dict(reference)[at]
            values = {m: curves[f"{kind}_{m[0]}mm_{m[1]}"].force(at) for m in meshes}
            table([f"{kind}: force at {at:g} mm, of solids", *make.OVERS],
                  [[f"{size} mm"] + [f"{100.0 * values[size, over] / solids:.0f} %" for over in make.OVERS if (size, over) in values]
                   for size in (3, 5, 8)])
    meshes = [n for n in ACROSS if f"lap_{n}" in curves]
    if meshes:
        table(["lap, mm", "solids"] + meshes,
              [[f"{u:g}", f] + [f"{curves[f'lap_{n}'].force(u):.0f} ({100.0 * curves[f'lap_{n}'].force(u) / f - 100.0:+.1f} %)" for n in meshes]
               for u, f in SOLIDS["lap"][0]])
    if "lap_patch" in curves:
        table(["lap, square, mm", "solids", "rigid square on 21"], [[f"{u:g}", f, f"{curves['lap_patch'].force(u):.0f}"] for u, f in SQUARE])
    for name in ("lap_fails", "peel_fails"):
        if name in curves:
            print(f"{name}: by {curves[name].weld['failure_mode']} at {curves[name].force_at_failure():.0f} N in the grip")


def draw(curves, path):
    import matplotlib
    matplotlib.use("svg")
    from matplotlib import pyplot
    matplotlib.rcParams.update({"svg.hashsalt": "nugget", "font.size": 9})
    figure, axes = pyplot.subplots(1, 3, figsize=(11, 3.6))
    for axis, (kind, (reference, _, _)) in zip(axes, SOLIDS.items()):
        for weld in make.WELDS:
            if f"{kind}_{weld}" in curves:
                points = curves[f"{kind}_{weld}"].points[::10]
                label = "weld beam" if weld == "beam" else f"{weld} brick" + "s" * (weld != "1")
                axis.plot([u for u, _ in points], [f / 1000.0 for _, f in points], linewidth=1.2, label=label)
        axis.plot([u for u, _ in reference], [f / 1000.0 for _, f in reference], "ko", markersize=4, label="solids (CalculiX)")
        axis.set(title={"lap": "lap shear", "peel": "coach peel", "cross": "cross tension"}[kind], xlabel="grip displacement, mm",
                 ylabel="force, kN", xlim=(0, None), ylim=(0, None))
    axes[0].legend(frameon=False)
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None})


def main(nugget, folder, *names):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    curves = run(nugget, folder, names)
    report(curves)
    lines = ["name,displacement,force"] + [f"{n},{u:.6e},{f:.6e}" for n, c in curves.items() for u, f in c.points]
    (folder / "curves.csv").write_text("\n".join(lines) + "\n", encoding="ascii")
    try:
        draw(curves, folder / "curves.svg")
    except ImportError:
        print("no curves.svg: this Python has no matplotlib")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
