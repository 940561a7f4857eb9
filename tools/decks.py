# SPDX-License-Identifier: Apache-2.0
"""Runs the public decks of ../shared/decks to their ends; prints the table of docs/evidence/decks.md and draws the last states.

    tools/decks.py NUGGET FOLDER [NAME...]

Results go to FOLDER/NAME, pictures to FOLDER/NAME.svg; a run that is there already is not repeated. Needs numpy.
"""
import json
import pathlib
import subprocess
import sys

import crossings
import states

DECKS = {  # name: deck, direction from the model to the eye
    "ball_plate": ("ball_plate/ball_plate.k", "1,-0.7,0.6"),
    "box_drop": ("box_drop/main.k", "1,-0.7,0.4"),
    "tensile_test": ("tensile_test/zug_test3_RS.k", "0.3,-0.6,1"),
    "bumper_beam": ("bumper_beam/Bumper_Beam_AP_meshed.k", "-1,-0.7,0.5"),
}
HEAD = """\
| deck | end | cycles | energy ratio | internal | hourglass | share | crossings | contact, share of time |
|---|---|---|---|---|---|---|---|---|"""


def row(name, folder):
    s = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    e, phases = s["energy"], s["seconds"]["phases"]
    x, facets = states.read(folder)[:2]
    edges, _ = crossings.crossings(x, facets)
    share = 100.0 * e["hourglass"] / e["internal"] if e["internal"] else 0.0
    contact = 100.0 * phases["contact"] / s["seconds"]["solve"]
    return (f"| {name} | {s['termination']}, {s['time']:g} | {s['cycles']:,} | {e['ratio']:.5f} | {e['internal']:.5g} | {e['hourglass']:.4g} | "
            f"{share:.1f} % | {len(edges)} | {contact:.0f} % |")


def main(nugget, folder, *names):
    shared = pathlib.Path(__file__).resolve().parents[2] / "shared" / "decks"
    print(HEAD)
    for name, (deck, view) in DECKS.items():
        if names and name not in names:
            continue
        out = pathlib.Path(folder) / name
        if not (out / "summary.json").exists():
            subprocess.run([nugget, "run", shared / deck, "-o", out, "-j1", "--quiet"], check=True, stderr=subprocess.DEVNULL)
        print(row(name, out), flush=True)
        subprocess.run([nugget, "picture", out, "-o", pathlib.Path(folder) / f"{name}.svg", f"--view={view}"], check=True)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
