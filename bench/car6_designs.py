# SPDX-License-Identifier: Apache-2.0
"""Runs designs of car6 that its author ran with LS-DYNA, and compares trends: does each parameter move each result as it does there?

    python3 bench/car6_designs.py DESIGNS [--nugget build/nugget] [--shared ../shared] [--count 120] [--near 12] [--work FOLDER]

DESIGNS is the folder LHS/9param of github.com/dbrizard/GSA-car-crash (GPL-3; not part of this repository), with LHS-120_X.csv (nine parameters a
row) and LHS-120_Y_fmax, _dmax, _vfin, _IE.csv (LS-DYNA R10.1). Finished runs in FOLDER are not repeated. The table has, for each result, the
coefficient of correlation over the designs, the median difference, and the change that each parameter causes over its range: the slopes of a
linear regression times the range, LS-DYNA / Nugget. Last comes how far LS-DYNA's own designs (these and LHS-330) scatter about a fit with the
squares of the parameters. With --near, designs are drawn within 1 % of the base design instead, and compared with LS-DYNA's base runs plus that fit's slopes.
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys

import numpy

ROOT = pathlib.Path(__file__).resolve().parent.parent
RESULTS = ("fmax", "dmax", "vfin", "IE")  # of LS-DYNA
BASE = {"tbumper": 3, "trailb": 2, "trailf": 5, "yrailb": 400, "tgrill": 1, "thood": 1, "ybumper": 400, "yrailf": 400, "ybody": 400}
BASE_RUNS = (773e3, -642.8, -711.0, 1.2037e8)  # means of LS-DYNA's five
COLUMNS = RESULTS + ("fmax, mean of three samples",)  # ours; the last beside LS-DYNA's fmax


def write_deck(folder, source, parameters):
    """A copy of the car with these parameters; its histories as text, which this script reads."""
    folder.mkdir(parents=True, exist_ok=True)
    text = (source / "car6_crash_v223.k").read_text(encoding="latin-1")
    text = re.sub(r"(\*DATABASE_(?:RWFORC|MATSUM|NODOUT)\n\$[^\n]*\n *\S+ +)2", r"\g<1>1", text)
    (folder / "car6_crash_v223.k").write_text(text, encoding="latin-1")
    cards = "".join(f"*PARAMETER\nr{name},{value:.10g}\n" for name, value in parameters.items())
    (folder / "main.k").write_text(f"*KEYWORD\n{cards}*INCLUDE\ncar6_crash_v223.k\n*END\n", encoding="ascii")
    return folder / "main.k"


def finished(folder):
    summary = folder / "summary.json"
    return summary.is_file() and json.loads(summary.read_text(encoding="utf-8"))["termination"] == "normal"


def results_of(folder):
    """The author's four results: largest x-force of the second wall, last x-displacement of node 605, last x-velocity of part 1, internal energy;
    and the largest mean of three samples of the force in a row, which the blow of a single node in a single cycle does not rule."""
    force = numpy.array([float(line.split()[3]) for line in (folder / "rwforc").read_text().splitlines() if re.match(r"\s*\S+\s+2\s+[-\d]", line)])
    node = [line for line in (folder / "nodout").read_text().splitlines() if line[:10].strip() == "605"]
    displacement = next(float(line[10:22]) for line in reversed(node) if len(line) > 120)
    material = (folder / "matsum").read_text()
    velocity = float(re.findall(r"mat\.#=\s*1\s.*?x-rbv=\s*(\S+)", material, re.DOTALL)[-1])
    energy = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["energy"]["internal"]
    return force.max(), displacement, velocity, energy, numpy.convolve(force, numpy.ones(3) / 3.0, "valid").max()


def slopes(designs, results):
    """Change of the result over the range of each parameter, by least squares."""
    scaled = (designs - designs.min(axis=0)) / numpy.ptp(designs, axis=0)
    return numpy.linalg.lstsq(numpy.column_stack([scaled, numpy.ones(len(scaled))]), results, rcond=None)[0][:-1]


def run(nugget, deck, folder):
    """Whether the run ended well; its states are not kept."""
    done = subprocess.run([str(nugget), "run", str(deck), "-o", str(folder), "-j1", "--quiet"], capture_output=True, text=True)
    for state in folder.glob("d3plot*"):
        state.unlink()
    if done.returncode != 0:
        print(f"{folder.name}: exit code {done.returncode}: {done.stderr.strip().splitlines()[0]}")
    return done.returncode == 0


def own_fit(folder, names):
    """LS-DYNA's results over the relative changes of the parameters from the base design and their squares, by least squares: slopes, values at the
    base, standard deviations about the fit."""
    base = numpy.array([BASE[name] for name in names])
    designs = numpy.vstack([numpy.loadtxt(folder / f"LHS-{n}_X.csv", delimiter=",") for n in (120, 330)]) / base - 1.0
    results = numpy.vstack([numpy.column_stack([numpy.loadtxt(folder / f"LHS-{n}_Y_{r}.csv", delimiter=",") for r in RESULTS]) for n in (120, 330)])
    terms = numpy.column_stack([designs, designs**2, numpy.ones(len(designs))])
    fit = numpy.linalg.lstsq(terms, results, rcond=None)[0]
    return fit[: len(names)], fit[-1], (results - terms @ fit).std(axis=0)


def compare_near(arguments, names, source, slopes_of_fit):
    random, differences = numpy.random.default_rng(1), []
    for number in range(arguments.near):
        change = 0.01 * (2.0 * random.random(len(names)) - 1.0)
        folder = arguments.work / f"near{number + 1:03d}"
        if not finished(folder):
            deck = write_deck(folder, source, {name: BASE[name] * (1.0 + c) for name, c in zip(names, change)})
            if not run(arguments.nugget, deck, folder):
                continue
        ours, theirs = numpy.array(results_of(folder)), numpy.array(BASE_RUNS) + change @ slopes_of_fit
        differences.append(ours / numpy.append(theirs, theirs[0]) - 1.0)
    differences = 100.0 * numpy.array(differences)
    print(f"{len(differences)} designs within 1 % of the base\n\n| | " + " | ".join(COLUMNS) + " |\n|---|" + "---|" * len(COLUMNS))
    print("| mean difference and its standard error | " + " | ".join(
        f"{d.mean():+.1f} ± {d.std(ddof=1) / len(d) ** 0.5:.1f} %" for d in differences.T) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("designs", type=pathlib.Path, metavar="DESIGNS")
    parser.add_argument("--nugget", type=pathlib.Path, default=ROOT / "build" / "nugget")
    parser.add_argument("--shared", type=pathlib.Path, default=ROOT.parent / "shared")
    parser.add_argument("--count", type=int, default=120)
    parser.add_argument("--near", type=int, default=0)
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build-bench" / "car6")
    arguments = parser.parse_args()
    source = arguments.shared / "decks" / "car6"
    if not source.is_dir():
        sys.exit(f"{source} is absent: nothing to run")
    problem = (arguments.designs / "LHS-120_problem.txt").read_text(encoding="utf-8")
    names = re.findall(r"'(\w+)'", problem.split("'names': [")[1].split("]")[0])
    fit, at_base, scatter = own_fit(arguments.designs, names)
    if arguments.near:
        return compare_near(arguments, names, source, fit)
    designs = numpy.loadtxt(arguments.designs / "LHS-120_X.csv", delimiter=",")[: arguments.count]
    theirs = numpy.column_stack([numpy.loadtxt(arguments.designs / f"LHS-120_Y_{result}.csv", delimiter=",") for result in RESULTS + ("fmax",)])

    rows, ours = [], []
    for number, design in enumerate(designs):
        folder = arguments.work / f"{number + 1:03d}"
        if not finished(folder):
            deck = write_deck(folder, source, dict(zip(names, design)))
            if not run(arguments.nugget, deck, folder):
                continue
        rows.append(number)
        ours.append(results_of(folder))
    ours, theirs, designs = numpy.array(ours), theirs[rows], designs[rows]

    print(f"{len(rows)} designs\n\n| | " + " | ".join(COLUMNS) + " |\n|---|" + "---|" * len(COLUMNS))
    print("| correlation | " + " | ".join(f"{numpy.corrcoef(theirs[:, k], ours[:, k])[0, 1]:.3f}" for k in range(len(COLUMNS))) + " |")
    print("| median difference | " + " | ".join(f"{100 * numpy.median(ours[:, k] / theirs[:, k] - 1):+.1f} %" for k in range(len(COLUMNS))) + " |")
    changes = [(slopes(designs, theirs[:, k]), slopes(designs, ours[:, k])) for k in range(len(COLUMNS))]
    for parameter, name in enumerate(names):
        print(f"| {name} | " + " | ".join(f"{a[parameter]:.3g} / {b[parameter]:.3g}" for a, b in changes) + " |")
    print("| LS-DYNA's fit at the base, scatter about it | " + " | ".join(f"{a:.4g} ± {b:.2g}" for a, b in zip(at_base, scatter)) + " | |")


if __name__ == "__main__":
    main()
