# SPDX-License-Identifier: Apache-2.0
"""Mean force of the spot-welded column over the strength of its welds, with the dent in twelve places: what is trend, and what is chance.

    python3 examples/hat_crush/dents.py NUGGET FOLDER [JOBS]

Runs 72 columns, JOBS (1) at a time, minutes each; finished runs are not repeated. Units: mm, t, s, N, MPa; forces in kN.
"""
import concurrent.futures
import json
import pathlib
import statistics
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from crush_study import CLOSED_FORM, FROM, TO, mean, wall_force  # noqa: E402
from make import STRENGTH, make  # noqa: E402

DENTS = tuple(14.0 + 1.5 * i for i in range(12))  # from the front [mm]; an element is 4 mm long


def crush(nugget, folder, dent, strength):
    """Mean force and failed welds of one column."""
    results = folder / f"{strength}_{dent:g}"
    if not (results / "summary.json").exists():
        deck = folder / f"{strength}_{dent:g}.k"
        make(STRENGTH[strength], dent_at=dent).write(deck)
        subprocess.run([nugget, "run", deck.name, "-j1", "--quiet", "-o", results.name], cwd=folder, check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)
    summary = json.loads((results / "summary.json").read_text(encoding="utf-8"))
    if summary["termination"] != "normal":
        sys.exit(f"{results}: {summary['message']}")
    return mean(wall_force(results), FROM, TO), sum(1 for w in summary["weld"] if w.get("failed"))


def main(nugget, folder, jobs=1):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    nugget = pathlib.Path(nugget).resolve()
    cases = [(dent, strength) for dent in DENTS for strength in STRENGTH]
    with concurrent.futures.ThreadPoolExecutor(int(jobs)) as pool:
        found = dict(zip(cases, pool.map(lambda case: crush(nugget, folder, *case), cases)))
    print("mean force [kN], welds failed; dent at   " + "   ".join(f"{name:>10s}" for name in STRENGTH))
    for dent in DENTS:
        print(f"{dent:5.1f} mm {'':30s}" + "   ".join("{:6.1f} {:3d}".format(*found[dent, name]) for name in STRENGTH))
    forces = {name: [found[dent, name][0] for dent in DENTS] for name in STRENGTH}
    print("mean, its standard error" + " " * 15 + "   ".join(
        f"{statistics.mean(f):6.2f} +-{statistics.stdev(f) / len(f) ** 0.5:.2f}" for f in forces.values()))
    print(f"closed form, welds that hold: {CLOSED_FORM['hat_crush']} kN")


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    main(*sys.argv[1:])
