# SPDX-License-Identifier: Apache-2.0
"""Runs the decks of tube_crush or hat_crush and sets them beside the closed form for the mean force.

    python3 examples/crush_study.py tube_crush|hat_crush NUGGET FOLDER [NAME...]

Writes FOLDER/NAME.k and runs them into FOLDER/NAME (all, or those named; finished runs are not repeated), then prints a table and, where Python
has matplotlib, writes FOLDER/curves.svg. A run takes minutes.
"""
import json
import pathlib
import subprocess
import sys

from crushing import SPEED

HERE = pathlib.Path(__file__).resolve().parent
FROM, TO = 20.0, 120.0  # crush over which the mean force is taken [mm]
CLOSED_FORM = {"tube_crush": 28.4, "hat_crush": 22.1}  # kN


def wall_force(folder):
    """[(crush [mm], force [kN])] of rwforc."""
    points = []
    for line in (folder / "rwforc").read_text(encoding="ascii").splitlines():
        words = line.split()
        if len(words) == 6 and words[1] == "1" and "E" in words[0]:
            points.append((SPEED * float(words[0]), float(words[2]) / 1000.0))
    return points


def mean(points, low, high):
    inside = [(d, f) for d, f in points if low <= d <= high]
    work = sum(0.5 * (f + g) * (e - d) for (d, f), (e, g) in zip(inside, inside[1:]))
    return work / (inside[-1][0] - inside[0][0])


def smooth(points, width=2.0):
    """Running mean over `width` mm."""
    n = max(1, round(0.5 * width / (points[1][0] - points[0][0])))
    forces = [f for _, f in points]
    return [(d, sum(forces[max(0, i - n):i + n + 1]) / len(forces[max(0, i - n):i + n + 1])) for i, (d, _) in enumerate(points)]


def peaks(points, apart=12.0):
    """Where the smoothed force is the greatest within `apart` mm on either side: a pair of lobes closes."""
    curve = smooth(points)
    return [d for d, f in curve[1:-1] if d > apart and f == max(g for e, g in curve if abs(e - d) <= apart)]


def main(case, nugget, folder, names):
    folder = pathlib.Path(folder)
    subprocess.run([sys.executable, str(HERE / case / "make.py"), str(folder)], check=True)
    decks = sorted(folder.glob("*.k"))
    curves = {}
    print(f"closed form {CLOSED_FORM[case]} kN, mean from {FROM:g} to {TO:g} mm of crush")
    print("deck         shells   mean [kN]  of closed form  peaks at [mm]         hourglass   ratio   welds failed   ns/element cycle")
    for deck in decks:
        if names and deck.stem not in names:
            continue
        results = folder / deck.stem
        if not (results / "summary.json").exists():
            subprocess.run([nugget, "run", deck.name, "-j1", "--quiet", "-o", deck.stem], cwd=folder, check=True)
        summary = json.loads((results / "summary.json").read_text(encoding="utf-8"))
        energy, points = summary["energy"], wall_force(results)
        force = mean(points, FROM, min(TO, points[-1][0]))
        where = " ".join(f"{d:.0f}" for d in peaks(points))
        failed = sum(1 for w in summary["weld"] if w.get("failed"))
        print(f"{deck.stem:12s} {summary['elements']['shell']:6d} {force:10.1f} {force / CLOSED_FORM[case] - 1:+14.1%}  {where:20s}"
              f" {energy['hourglass'] / energy['internal']:10.1%} {energy['ratio']:9.4f} {failed:6d} of {summary['welds']:3d}"
              f" {summary['ns_per_element_cycle']:12.0f}")
        curves[deck.stem] = smooth(points)
    draw(curves, CLOSED_FORM[case], folder / "curves.svg")


def draw(curves, closed_form, path):
    try:
        import matplotlib
    except ImportError:
        return
    matplotlib.use("svg")
    matplotlib.rcParams["svg.hashsalt"] = "nugget"
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(figsize=(8, 4))
    for name, points in curves.items():
        axes.plot([d for d, _ in points][::6], [f for _, f in points][::6], label=name, linewidth=1.2)
    axes.axhline(closed_form, color="black", linestyle="--", linewidth=1, label="closed form, mean")
    axes.set(xlabel="crush [mm]", ylabel="wall force, mean over 2 mm [kN]", ylim=(0, None), xlim=(0, None))
    axes.legend()
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None})


if __name__ == "__main__":
    if len(sys.argv) < 4 or sys.argv[1] not in CLOSED_FORM:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2], sys.argv[3], sys.argv[4:])
