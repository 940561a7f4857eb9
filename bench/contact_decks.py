# SPDX-License-Identifier: Apache-2.0
"""What contact costs: tube5 and tube5c (without and with contact, nothing touches yet), and a tube crushed into many folds.

    python3 bench/contact_decks.py [--other OLD_NUGGET] [--repeat 3] [--until SHARE] [DECK ...]

`folds` is the tube of examples/tube_crush on its mesh of 2.5 mm, crushed by 120 of 200 mm at 20 m/s. tube5 and tube5c come from
SHARED/bench/gen_impact.py. Every program runs every deck in turn, REPEAT times, on one thread; printed is the least CPU time of a run in ns per
element-cycle, so that a busy machine matters less, and what share of that run contact and elements took. --until: only this share of each
deck's end time (folds form late: give the whole for them). With --other the ratio of the two programs stands beside it.
"""
import argparse
import json
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SPEED, CRUSH = 20000.0, 120.0  # of the folded tube [mm/s, mm]


def write_folds(path):
    sys.path[:0] = [str(ROOT / "examples"), str(ROOT / "examples" / "tube_crush")]
    import crushing  # pylint: disable=import-outside-toplevel,import-error
    import make  # pylint: disable=import-outside-toplevel,import-error
    crushing.SPEED = SPEED
    make.make(2.5, CRUSH).write(path)


def end_time(deck):
    found = re.search(r"\*CONTROL_TERMINATION[^\n]*\n(?:\$[^\n]*\n)*([^\n]{1,10})", deck.read_text(encoding="utf-8"))
    return float(found.group(1))


def run(program, deck, results, until):
    """(ns of CPU per element-cycle, summary)"""
    process = subprocess.Popen([str(program), "run", str(deck), "-o", str(results), "-j1", "--quiet", "--until", str(until)],
                               stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit(f"{program} {deck} ended with status {status}")
    summary = json.loads((results / "summary.json").read_text(encoding="utf-8"))
    work = summary["cycles"] * sum(summary["elements"].values())
    return 1e9 * usage.ru_utime / work, summary


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--nugget", type=pathlib.Path, default=ROOT / "build" / "nugget")
    parser.add_argument("--other", type=pathlib.Path, help="a second program to set beside it")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--until", type=float, default=1.0)
    parser.add_argument("--shared", type=pathlib.Path, default=ROOT.parent / "shared")
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build-bench" / "contact")
    parser.add_argument("decks", nargs="*", help="of tube5, tube5c, folds (all that can be had)")
    arguments = parser.parse_args()
    arguments.work.mkdir(parents=True, exist_ok=True)
    write_folds(arguments.work / "folds.k")
    generator = arguments.shared / "bench" / "gen_impact.py"
    if generator.is_file():
        subprocess.run([sys.executable, str(generator), str(arguments.work)], check=True)
    decks = [arguments.work / f"{name}.k" for name in arguments.decks or ("tube5", "tube5c", "folds")]
    programs = [arguments.nugget] + ([arguments.other] if arguments.other else [])
    print(f"{'deck':<8}" + "".join(f"{'ns':>9}{'elements':>10}{'contact':>9}" for _ in programs) + f"{'ratio':>8}")
    for deck in [d for d in decks if d.is_file()]:
        best = {}
        for _ in range(arguments.repeat):
            for i, program in enumerate(programs):
                ns, summary = run(program.resolve(), deck, arguments.work / f"{deck.stem}_{i}", arguments.until * end_time(deck))
                if i not in best or ns < best[i][0]:
                    best[i] = (ns, summary["seconds"]["phases"])
        line = f"{deck.stem:<8}"
        for ns, phases in best.values():
            whole = sum(phases.values())
            line += f"{ns:9.1f}{phases['elements'] / whole:10.1%}{phases['contact'] / whole:9.1%}"
        print(line + (f"{best[0][0] / best[1][0]:8.3f}" if len(best) > 1 else ""), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
