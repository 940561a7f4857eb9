# SPDX-License-Identifier: Apache-2.0
"""What sub-cycling gains and costs: the same deck without and with *CONTROL_SUBCYCLE_K_L, in turn, one thread.

    python3 bench/subcycling.py [--nugget build/nugget] [--work build-bench/subcycling] [--repeat 2] [--shells 20000] [DECK ...]

body: a row of sills as of bench/body.py, but of 10 mm shells 0.7 to 0.9 mm thick, whose weld beams have less than a tenth of the
sheets' step, thrown at a wall with 10 m/s in one contact with itself. tube: a square tube of 10 mm shells with a band of
1.25 mm ones, crushed at a wall by a mass. Further decks are taken as they are (../shared/decks/car6/...). Printed is user time, the
least of the runs, and how far energies are from those of the run without.
"""
import argparse
import json
import pathlib
import shutil
import sys

import body
from modes import measure

ROOT = pathlib.Path(__file__).resolve().parent.parent
FORMS = ("", "16_1", "16_4", "16_8")


def write_body(nugget, work, shells):
    body.SIZE, body.THICKNESS = 10.0, {"hat": 0.8, "floor": 0.9, "third": 0.7}
    body.sills(work, shells, shells // 75, 1e-3)
    measure([nugget, "weld", "points.csv", "body.k", "-o", "welded.k", "-j1"], work)
    body.write_crash(work, "*DATABASE_GLSTAT\n   2.0E-05\n")
    text = (work / "crash.k").read_text(encoding="ascii").splitlines(keepends=True)
    at = next(i for i, line in enumerate(text) if line.startswith("*DATABASE_SWFORC"))  # by `nugget weld`: every step
    text[at:at + 3] = ["*DATABASE_SWFORC\n", "   2.0E-06\n"]
    (work / "body_crash.k").write_text("".join(text), encoding="ascii")
    return work / "body_crash.k"


def write_tube(work):
    """100 mm square, 1.5 mm thick, 12 x 10 + 8 x 1.25 + 12 x 10 mm long, in its middle; mm, t, s."""
    places = [0.0]
    for size, count in ((10.0, 12), (1.25, 8), (10.0, 12)):
        for _ in range(count):
            places.append(places[-1] + size)
    around = [(10.0 * i, 0.0) for i in range(10)] + [(100.0, 10.0 * i) for i in range(10)] + [(100.0 - 10.0 * i, 100.0) for i in range(10)] \
        + [(0.0, 100.0 - 10.0 * i) for i in range(10)]
    n = len(around)
    text = ["*KEYWORD\n*CONTROL_TERMINATION\n     0.005\n*CONTROL_ENERGY\n         2         2         2         2\n*DATABASE_GLSTAT\n   1.0E-04\n",
            "*PART\ntube\n         1         1         1\n*SECTION_SHELL\n         1         2    0.8333         5\n       1.5       1.5       1.5       1.5\n",
            "*MAT_PIECEWISE_LINEAR_PLASTICITY\n         1  7.85e-09  210000.0       0.3     300.0    1000.0\n       0.0\n\n\n",
            "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n         0\n       0.1       0.1\n\n",
            "*INITIAL_VELOCITY_GENERATION\n         1         2            -8.0e3       0.0       0.0\n*RIGIDWALL_PLANAR\n         0\n"
            "     -0.01       0.0       0.0       1.0       0.0       0.0       0.1\n*SET_PART_LIST\n         1\n         1\n*NODE\n"]
    for i, x in enumerate(places):
        for j, (y, z) in enumerate(around):
            bend = 0.5 if (i // 3 + j // 10) % 2 else -0.5  # where it folds
            text.append(f"{n * i + j + 1:8d}{x:16.5f}{y + bend * (0 < i < 12):16.5f}{z:16.5f}\n")
    text.append("*ELEMENT_SHELL\n")
    for i in range(len(places) - 1):
        for j in range(n):
            corners = (n * i + j + 1, n * (i + 1) + j + 1, n * (i + 1) + (j + 1) % n + 1, n * i + (j + 1) % n + 1)
            text.append(f"{n * i + j + 1:8d}{1:8d}" + "".join(f"{c:8d}" for c in corners) + "\n")
    last = n * (len(places) - 1)
    text.append("*ELEMENT_MASS\n" + "".join(f"{k + 1:8d}{last + k + 1:8d}{1e-3:16.4g}\n" for k in range(n)) + "*END\n")
    (work / "tube.k").write_text("".join(text), encoding="ascii")
    return work / "tube.k"


def compare(nugget, deck, work, repeat):
    if deck.parent != work:  # with what it includes
        shutil.copytree(deck.parent, work / deck.stem, dirs_exist_ok=True)
        deck = work / deck.stem / deck.name
    text = deck.read_text(encoding="latin-1")
    at = text.upper().rindex("*END")
    base = None
    for form in FORMS:
        name = deck.with_name(f"{deck.stem}_subcycled.k")
        name.write_text(text[:at] + (f"*CONTROL_SUBCYCLE_{form}\n" if form else "") + text[at:], encoding="latin-1")
        try:
            seconds = min(measure([nugget, "run", str(name), "-o", "results", "-j1", "--quiet"], work)[0] for _ in range(repeat))
        except SystemExit:  # rigid welds are refused beside L above 1
            print(f"{'':<14}{form:<9}   refused")
            continue
        summary = json.loads((work / "results" / "summary.json").read_text(encoding="utf-8"))
        energy = summary["energy"]
        base = base or (seconds, energy)
        periods = ", ".join(f"{p['cycles']}: " + " ".join(f"{count} {kind}s" for kind, count in p["elements"].items()) for p in summary.get("subcycling", []))
        print(f"{deck.stem if not form else '':<14}{form or 'without':<9}{summary['cycles']:>8} cycles{seconds:9.2f} s {seconds / base[0]:6.2f}  ratio {energy['ratio']:.4f}  "
              + "  ".join(f"{key} {energy[key] / base[1][key] - 1.0:+.1%}" for key in ("kinetic", "internal"))
              + f"  failed welds {sum(w['failed'] for w in summary['weld'])}  {periods}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--nugget", type=pathlib.Path, default=ROOT / "build" / "nugget")
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build-bench" / "subcycling")
    parser.add_argument("--repeat", type=int, default=2)
    parser.add_argument("--shells", type=int, default=20_000)
    parser.add_argument("decks", nargs="*", type=pathlib.Path, metavar="DECK")
    arguments = parser.parse_args()
    nugget, work = str(arguments.nugget.resolve()), arguments.work.resolve()
    work.mkdir(parents=True, exist_ok=True)
    for deck in arguments.decks or [write_body(nugget, work, arguments.shells), write_tube(work)]:
        compare(nugget, deck.resolve(), work, arguments.repeat)
    return 0


if __name__ == "__main__":
    sys.exit(main())
