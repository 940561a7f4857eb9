# SPDX-License-Identifier: Apache-2.0
"""The talk's example: one coupon, the weld over the centre of an element, on its edge and on a node, torn apart.

The decks are those of examples/weld_placement, which `./dev demo weld_placement` runs.
"""
import importlib.util
import math
import pathlib

import readers

spec = importlib.util.spec_from_file_location("placement", pathlib.Path(__file__).resolve().parents[1] / "weld_placement" / "make.py")
placement = importlib.util.module_from_spec(spec)
spec.loader.exec_module(placement)

SOLIDS = 62500.0  # N/mm, elastic stiffness of this coupon of 20-node bricks (CalculiX; docs/evidence/coupons.md)
GRIP = 1000 * placement.LOWER + 1  # a node of the moving grip
SHOWN, SCALE = 1.2e-3, 10.0  # time of the deformed shapes, by how much they are enlarged


def decks():
    return {f"place_{case}": placement.make(case) for case in placement.CASES}


def elongation(folder):
    """[(time, elongation, axial, shear, length)] of the coupon and its weld."""
    grip = readers.nodout(folder)[GRIP]
    at = {f"{time:.4e}": motion[0] for time, motion, _ in grip}
    return [(row[0], at[f"{row[0]:.4e}"], *row[1:4]) for row in readers.swforc(folder) if f"{row[0]:.4e}" in at]


def stiffness(folder):
    """Of the coupon, by least squares over the loads from 300 to 2000 N [N/mm]."""
    points = [(u, shear) for _, u, _, shear, _ in elongation(folder) if 300.0 < shear < 2000.0]
    u, f = (sum(p[i] for p in points) / len(points) for i in (0, 1))
    return sum((a - u) * (b - f) for a, b in points) / sum((a - u) ** 2 for a, _ in points)


def rows(results):
    for name, folder in results.items():
        gate = 0.05 if name == "place_centre" else float("inf")
        yield f"{name}: elastic stiffness [N/mm]", stiffness(folder), SOLIDS, gate, "solids (CalculiX)"
        weld = readers.weld(folder)
        if weld["failed"] == "yes":
            yield f"{name}: force at failure [N]", float(weld["last_force"]), placement.STRENGTH, 0.01, "its card: (N/9000)² + (V/9000)² = 1"


def draw_shape(axis, folder, across, title):
    """The sheets at SHOWN, enlarged, seen along y (across 2) or along z (across 1)."""
    import figures
    (start, shells, beams), (now, _, _) = figures.first_state(folder), figures.state_at(folder, SHOWN)
    x = start + SCALE * (now - start)
    gap = [(math.nan, math.nan)]  # between the outlines of two shells in one line
    for colour, above in ((figures.BLUE, True), (figures.RED, False)):
        shown = [ring for ring in shells if (start[ring[0]][2] > 0.0) == above and abs(x[ring[0]][0]) < 45.0
                 and (across == 1 or max(start[n][1] for n in ring) > 19.9)]
        lines = [point for ring in shown for point in [(round(x[n][0], 2), round(x[n][across], 2)) for n in (*ring, ring[0])] + gap]
        axis.plot(*zip(*lines), color=colour, linewidth=0.5)
    axis.plot(*zip(*[(x[n][0], x[n][across]) for n in beams[0]]), "o-", color="k", linewidth=2, markersize=3)
    axis.set(aspect="equal", xticks=[], yticks=[], xlim=(-35, 40), frame_on=False)
    axis.set_title(title, fontsize=9)


def draw(results):
    import figures
    figure = figures.Figure(figsize=(9.6, 6.6), layout="constrained")
    axes = figure.subplot_mosaic("AABBCC;DDEEFF;GGGHHH", height_ratios=[1.0, 1.3, 2.2])
    for (name, folder), side, top in zip(results.items(), "ABC", "DEF"):
        draw_shape(axes[side], folder, 2, f"weld over {placement.WHAT[name.removeprefix('place_')]}")
        draw_shape(axes[top], folder, 1, "")
    axes["A"].set_ylabel("side view")
    axes["D"].set_ylabel("top view")
    for (name, folder), colour in zip(results.items(), figures.COLOURS):
        points = elongation(folder)[::4]
        label = {"centre": "centre", "edge": "edge", "corner": "node"}[name.removeprefix("place_")]
        axes["G"].plot([1e3 * p[0] for p in points], [1e3 * (p[4] - placement.THICKNESS) for p in points], color=colour, label=label, linewidth=1.2)
        axes["H"].plot([1e3 * p[0] for p in points], [(p[2]**2 + p[3]**2)**0.5 / 1e3 for p in points], color=colour, linewidth=1.2)
    axes["G"].set(xlabel="time, ms", ylabel="length of the weld beyond 1.5 mm, µm")
    axes["H"].set(xlabel="time, ms", ylabel="force of the weld, kN")
    axes["G"].legend()
    return figure
