# SPDX-License-Identifier: Apache-2.0
"""Instructions that kernels take, counted by valgrind: a guard against a kernel that grows, which no clock is steady enough for.

    tests/guard/instructions.py NUGGET COMPILER            fails where a count has grown by more than 5 % over counts.json
    tests/guard/instructions.py NUGGET COMPILER --renew    writes counts.json anew

Per element and cycle: two runs of a deck, of few and of more cycles, divided by the cycles and elements between; what is written and read once drops out.
`contact`, `strains` (STRFLG) and `energies` (their balance in each cycle) are a deck with it less the same without. A welded rail of 9,536 shells is checked (reading, ties, contact, audit) and run for one cycle (the same,
with its files and its page). One thread, four lanes. COMPILER, e.g. `GNU 12`, must be that of the counts: others count otherwise. Exit code 77: nothing to count with.
"""
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(ROOT / "examples"))
sys.dont_write_bytecode = True
from writer import Deck  # pylint: disable=wrong-import-position

COUNTS = HERE / "counts.json"
GROWTH = 1.05
FEW, MORE = 10, 40
SIDE, BRICKS, EDGE = 30, 10, 5.0  # shells along a plate, bricks along a block, their size [mm]


def head(deck, strains=False, energies=False):
    deck.keyword("KEYWORD")
    if energies:  # nodout is due in each cycle, and ENDENG has the energies looked at with whatever is due
        deck.keyword("DATABASE_HISTORY_NODE")
        deck.card(id1=1)
        deck.keyword("DATABASE_NODOUT")
        deck.card(dt=1e-12)
    if strains:
        deck.keyword("DATABASE_EXTENT_BINARY")
        deck.card(neiph=0, neips=0, maxint=3, strflg=1)
    deck.keyword("CONTROL_TERMINATION")
    deck.card(endtim=1.0, endcyc=0, dtmin=0.0, endeng=1e6 if energies else 0.0)
    deck.keyword("CONTROL_TIMESTEP")
    deck.card(dtinit=0.0, tssfac=0.7)
    deck.keyword("MAT_PIECEWISE_LINEAR_PLASTICITY")
    deck.card(mid=1, ro=7.85e-9, e=210000.0, pr=0.3, sigy=300.0, etan=1000.0)
    deck.text("")
    deck.text("")
    deck.text("")


def motion(deck, nodes):
    """Waves of 40 m/s, so that elements yield and each lane has work of its own."""
    deck.keyword("INITIAL_VELOCITY_NODE")
    for n in nodes:
        deck.card(nid=n, vx=4e4 * (n * 37 % 19 / 9 - 1), vy=4e4 * (n * 53 % 23 / 11 - 1), vz=4e4 * (n * 71 % 29 / 14 - 1))


def plates(elform, layers=1, contact=False, strains=False, energies=False):
    """`layers` plates above each other, 1.2 thick and 1.21 apart: contact has each node near the other plate."""
    deck = Deck()
    head(deck, strains, energies)
    deck.part("plates", pid=1, secid=1, mid=1)
    deck.keyword("SECTION_SHELL")
    deck.card(secid=1, elform=elform, shrf=0.8333, nip=3)
    deck.card(t1=1.2, t2=1.2, t3=1.2, t4=1.2)
    if contact:
        deck.keyword("CONTACT_AUTOMATIC_SINGLE_SURFACE")
        deck.card(surfa=0, surfb=0, surfatyp=5)
        deck.text("")
        deck.text("")
    row = SIDE + 1
    points = [(i * EDGE, j * EDGE, 1.21 * k) for k in range(layers) for j in range(row) for i in range(row)]
    deck.nodes({n + 1: point for n, point in enumerate(points)})
    first = [k * row * row + j * row + i + 1 for k in range(layers) for j in range(SIDE) for i in range(SIDE)]
    deck.shells({e + 1: (1, (n, n + 1, n + row + 1, n + row)) for e, n in enumerate(first)})
    motion(deck, range(1, len(points) + 1))
    return deck, len(first)


def block(ihq, strains=False):
    deck = Deck()
    head(deck, strains)
    deck.part("block", pid=1, secid=1, mid=1, eosid=0, hgid=1)
    deck.keyword("SECTION_SOLID")
    deck.card(secid=1, elform=1)
    deck.keyword("HOURGLASS")
    deck.card(hgid=1, ihq=ihq, qm=0.1)
    row = BRICKS + 1
    points = [(i * EDGE, j * EDGE, k * EDGE) for k in range(row) for j in range(row) for i in range(row)]
    deck.nodes({n + 1: point for n, point in enumerate(points)})
    row_up = row * row
    first = [k * row_up + j * row + i + 1 for k in range(BRICKS) for j in range(BRICKS) for i in range(BRICKS)]
    below = [(n, n + 1, n + row + 1, n + row) for n in first]
    deck.solids({e + 1: (1, (*corners, *(c + row_up for c in corners))) for e, corners in enumerate(below)})
    motion(deck, range(1, len(points) + 1))
    return deck, len(first)


def instructions(folder, *command):
    words = ["valgrind", "--tool=cachegrind", "--cache-sim=no", "--cachegrind-out-file=/dev/null", *map(str, command), "-o", str(folder / "results"), "-j", "1"]
    run = subprocess.run(words, capture_output=True, text=True, env={**os.environ, "NUGGET_LANES": "4"}, check=False)
    count = re.search(r"I +refs: +([\d,]+)", run.stderr)
    if run.returncode != 0 or not count:
        raise SystemExit(f"{' '.join(words)} ended with {run.returncode}:\n{run.stderr[-2000:]}")
    return int(count[1].replace(",", ""))


def per_element_and_cycle(nugget, made, folder):
    deck, elements = made
    path = folder / "deck.k"
    deck.write(path)
    few, more = (instructions(folder, nugget, "run", path, "--quiet", "--max-cycles", cycles) for cycles in (FEW, MORE))
    return (more - few) / (MORE - FEW) / elements


def count(nugget, folder):
    counts = {"shell, ELFORM 2": per_element_and_cycle(nugget, plates(2), folder),
              "shell, ELFORM 16": per_element_and_cycle(nugget, plates(16), folder),
              "brick, hourglass 2": per_element_and_cycle(nugget, block(2), folder),
              "brick, hourglass 6": per_element_and_cycle(nugget, block(6), folder)}
    with_strains = {"shell": ("shell, ELFORM 2", plates(2, strains=True)), "brick": ("brick, hourglass 2", block(2, strains=True))}
    for kind, (without, made) in with_strains.items():
        counts[f"strains of a {kind}"] = per_element_and_cycle(nugget, made, folder) - counts[without]
    counts["energies of a shell"] = per_element_and_cycle(nugget, plates(2, energies=True), folder) - counts["shell, ELFORM 2"]
    free, touching = (per_element_and_cycle(nugget, plates(2, 2, contact), folder) for contact in (False, True))
    counts["contact, of a shell"] = touching - free
    sys.path.insert(0, str(ROOT / "examples" / "double_hat"))
    subprocess.run([sys.executable, str(ROOT / "examples" / "double_hat" / "make.py"), str(folder / "rail")], check=True, stdout=subprocess.DEVNULL)
    rail = folder / "rail" / "double_hat.k"
    counts["check of a rail"] = instructions(folder, nugget, "check", rail)
    counts["one cycle of a rail"] = instructions(folder, nugget, "run", rail, "--quiet", "--max-cycles", 1)
    return {name: round(value) for name, value in counts.items()}


def main():
    nugget, compiler = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
    if not shutil.which("valgrind"):
        print("no valgrind: ./dev setup installs it")
        return 77
    kept = json.loads(COUNTS.read_text(encoding="utf-8")) if COUNTS.exists() else {}
    renew = "--renew" in sys.argv
    if kept.get("compiler") != compiler and not renew:
        print(f"counts.json is of {kept.get('compiler')}, this program of {compiler}")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        counts = count(nugget, pathlib.Path(folder))
    if renew:
        COUNTS.write_text(json.dumps({"compiler": compiler, "counts": counts}, indent=2) + "\n", encoding="utf-8")
    grown = []
    for name, value in counts.items():
        before = kept.get("counts", {}).get(name)
        print(f"{name:<22} {value:>14,} {'' if before is None else f'{value / before:8.3f} of what it was'}")
        if before is None or value > GROWTH * before:
            grown.append(name)
    if grown and not renew:
        print(f"more than {GROWTH} of what it was: {', '.join(grown)}; if that is meant: {shlex.join(sys.argv)} --renew")
    return 1 if grown and not renew else 0


if __name__ == "__main__":
    sys.exit(main())
