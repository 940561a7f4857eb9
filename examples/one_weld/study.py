# SPDX-License-Identifier: Apache-2.0
"""Runs the decks of one weld and sets them beside the formulas of the book.

    python3 examples/one_weld/study.py NUGGET FOLDER

Writes FOLDER/NAME.k, runs them into FOLDER/NAME (finished runs are not repeated), prints how far each weld that failed was from its
formula, and draws, where Python has matplotlib, FOLDER/weld_failure.svg and FOLDER/weld_damage.svg.
"""
import csv
import math
import pathlib
import sys

import make
from writer import run

WHAT = {0: "OPT 0, resultants", 1: "OPT 1, stresses", 4: "OPT 4, stress intensity", 5: "OPT 5, structural stress", 11: "OPT 11, direction"}


def at_failure(results):
    """(axial, shear) of the weld when it failed; None where it held."""
    (weld,) = csv.DictReader((results / "welds.csv").read_text(encoding="ascii").splitlines())
    return (float(weld["last_axial"]), float(weld["last_shear"])) if weld["failed"] == "yes" else None


def curve(results):
    """[(length, axial force)] of the weld while it holds."""
    points = []
    for line in (results / "swforc").read_text(encoding="ascii").splitlines():
        if "spotweld beam  ID" in line and "failure time" not in line:
            front, back = line.split("spotweld beam  ID")
            points.append((float(back.split()[1]), float(front.split()[1])))
    return points


def failure_value(option, n, f):
    """The failure functions, with moments left out (docs/theory/failure.md); f is the shear force along s."""
    d, t, tension = make.DIAMETER, make.THICKNESS, max(n, 0.0)
    if option == 0:
        return math.sqrt((tension / make.NORMAL) ** 2 + (f / make.SHEAR) ** 2)
    if option == 1:
        return math.sqrt((tension / make.NORMAL) ** 2 + (f / make.SHEAR_1) ** 2)
    if option == 4:
        one = math.sqrt(3) * f / (2 * math.pi * d * math.sqrt(t)) + 5 * math.sqrt(2) * tension / (3 * math.pi * d * math.sqrt(t))
        return math.hypot(one, 2 * f / (math.pi * d * math.sqrt(t))) / make.STRESS_INTENSITY
    if option == 5:  # around the nugget the sheet's stress is largest where the shear force presses; in the nugget a principal stress
        sheet = f / (math.pi * d * t) + 1.744 * tension / t**2
        sigma, tau = 4 * tension / (math.pi * d**2), 16 * f / (3 * math.pi * d**2)
        return max(sheet, sigma / 2 + math.hypot(sigma / 2, tau)) / make.STRUCTURAL
    angle, total = math.degrees(math.atan2(abs(n), f)), math.hypot(n, f)
    for (a, u), (b, v) in zip(make.CURVE_11, make.CURVE_11[1:]):
        if n >= 0 and a <= angle <= b:
            return total / (u + (v - u) * (angle - a) / (b - a))
    return 0.0  # compression has no curve


def surface(option):
    """[(shear, axial)] where the failure value is 1."""
    points = []
    for degrees in range(-40, 91):
        n, f = math.sin(math.radians(degrees)), math.cos(math.radians(degrees))
        value = failure_value(option, n, f)  # of order 1 in the load for every OPT
        if value > 0:
            points.append((f / value, n / value))
    return points


def point_of(strain, name):
    """Axial force at a logarithmic strain: the formulas of docs/manual/weld_damage.md for damage point by point over strain."""
    rupture, beta, option, strength = make.FADES[name]
    young, slope = make.YOUNG, make.HARDENING
    plastic = max(0.0, (strain * young - make.YIELD) / (young + slope))
    if option == 1 and plastic > make.EFAIL:
        plastic = strain - (make.YIELD + slope * make.EFAIL) / young
    damage = max(0.0, (plastic - make.EFAIL) / (rupture - make.EFAIL)) if rupture else float(plastic >= make.EFAIL)
    held = min(plastic, make.EFAIL) if option == 1 else plastic
    left = math.exp(-beta * damage) if beta else 1.0 - damage
    return 0.0 if damage >= 1 else left * min(young * strain, make.YIELD + slope * held) * make.AREA


def report(folder, results):
    print("name            shear      axial    failure value")
    for option in make.OPTIONS:
        for angle in make.ANGLES:
            load = at_failure(results[f"fails_{option}_{angle}"])
            if load:
                print(f"OPT {option:2d} {angle:4d}  {load[1]:9.1f}  {load[0]:9.1f}  {failure_value(option, *load):10.5f}")
    for name in ("efail", "dmgopt0", "beta", "dmgopt1"):
        worst = max(abs(force - point_of(math.log(length / make.LENGTH), name)) for length, force in curve(results[f"fades_{name}"]))
        print(f"fades_{name}: largest distance from the formula {worst:.1f} N")


def draw(folder, results):
    import matplotlib
    matplotlib.use("svg")
    from matplotlib import pyplot
    matplotlib.rcParams.update({"svg.hashsalt": "nugget", "font.size": 9})
    figure, axis = pyplot.subplots(figsize=(6.2, 4.2))
    for color, (option, label) in zip("C0 C1 C2 C3 C4".split(), WHAT.items()):
        line = surface(option)
        axis.plot([f / 1000 for f, _ in line], [n / 1000 for _, n in line], color, linewidth=1.2, label=label)
        loads = [at_failure(results[f"fails_{option}_{angle}"]) for angle in make.ANGLES]
        axis.plot([f / 1000 for _, f in filter(None, loads)], [n / 1000 for n, _ in filter(None, loads)], color, marker="o",
                  linestyle="", markersize=4)
    axis.axhline(0.0, color="0.7", linewidth=0.8)
    axis.set(xlabel="shear force at failure, kN", ylabel="axial force at failure, kN", xlim=(0, 16), ylim=(-4, 9))
    axis.legend(frameon=False, loc="center right")
    figure.tight_layout()
    figure.savefig(folder / "weld_failure.svg", metadata={"Date": None})

    figure, axes = pyplot.subplots(1, 2, figsize=(9.6, 3.8), sharey=True)
    labels = {"efail": "EFAIL alone", "dmgopt0": "DMGOPT 0", "beta": "DMGOPT 0, BETA 3", "dmgopt1": "DMGOPT 1", "dmgopt2": "DMGOPT 2, RS a time",
              "dmgopt10": "DMGOPT 10", "dmgopt12": "DMGOPT 12, RS a time"}
    for axis, names, title in ((axes[0], ("efail", "dmgopt0", "beta", "dmgopt1", "dmgopt2"), "point by point, from EFAIL on"),
                               (axes[1], ("dmgopt10", "dmgopt12"), "the weld as a whole, from 15 kN on")):
        for name in names:
            points = curve(results[f"fades_{name}"])
            points.append((points[-1][0], 0.0))
            (line,) = axis.plot([u - make.LENGTH for u, _ in points], [n / 1000 for _, n in points], linewidth=1.2, label=labels[name])
            if name in ("dmgopt0", "beta", "dmgopt1"):
                lengths = [make.LENGTH * math.exp(0.2 + 0.01 * i) for i in range(11)]
                axis.plot([u - make.LENGTH for u in lengths], [point_of(math.log(u / make.LENGTH), name) / 1000 for u in lengths],
                          color=line.get_color(), marker="o", linestyle="", markersize=3)
        axis.set(title=title, xlabel="elongation, mm", xlim=(0, None), ylim=(0, None))
        axis.legend(frameon=False, loc="lower left")
    axes[0].set_ylabel("axial force, kN")
    figure.tight_layout()
    figure.savefig(folder / "weld_damage.svg", metadata={"Date": None})


def main(nugget, folder):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    results = {name: run(nugget, folder, name, deck) for name, deck in make.decks().items()}
    report(folder, results)
    try:
        draw(folder, results)
    except ImportError:
        print("no figures: this Python has no matplotlib")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
