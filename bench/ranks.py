# SPDX-License-Identifier: Apache-2.0
"""What ranks give on this machine: the same decks over threads and ranks, in turn.

    python3 bench/ranks.py [--nugget build/nugget] [--shared ../shared] [--work build-bench/ranks] [--repeat 2] [--forms 1x1 ...] [DECK ...]

Decks: tube3, tube5c, hex_ihq6, weld of SHARED/bench/gen_impact.py (without them, only what follows), hat (examples/double_hat), body (the
body of bench/body.py with --shells, --welds, in one contact with itself). Each runs over RANKSxTHREADS of --forms, to which the first is
compared. Printed is by the clock what a cycle takes: what a run to the
deck's number of cycles takes longer in its time loop than one to a fifth of it, the least of --repeat; processor time of all ranks
likewise, as a share of that of one process; of the most loaded rank what it sends in a cycle, the share of its time that it waits and its
memory. Results (d3plot, glstat) of all forms must have the same bytes. Run nothing else meanwhile.

--beside N also runs N programs of one process and one thread beside each other, which share nothing but the machine: how many times as
much they do together as one alone is what the machine has for N ranks.
"""
import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys

import body

ROOT = pathlib.Path(__file__).resolve().parent.parent
CYCLES = {"tube3": 1200, "tube5c": 800, "hex_ihq6": 200, "weld": 600, "hat": 1000, "body": 250}
FORMS = ("1x1", "1x2", "2x1", "4x1")
ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")


def make(nugget, shared, work, shells, welds):
    """Writes the decks; the path of each."""
    work.mkdir(parents=True, exist_ok=True)
    decks = {}
    generator = shared / "bench" / "gen_impact.py"
    if generator.is_file():
        subprocess.run([sys.executable, str(generator), str(work)], check=True, stdout=subprocess.DEVNULL)
    else:
        print(f"{generator} is not there: only decks that are in {work} already, the body and the hat")
    decks = {name: work / f"{name}.k" for name in CYCLES if (work / f"{name}.k").is_file()}
    subprocess.run([sys.executable, str(ROOT / "examples" / "double_hat" / "make.py"), str(work)], check=True, stdout=subprocess.DEVNULL)
    decks["hat"] = work / "double_hat.k"
    folder = work / f"body{shells}"
    if not (folder / "crash.k").is_file():
        folder.mkdir(exist_ok=True)
        body.sills(folder, shells, welds, 1.0)
        subprocess.run([nugget, "weld", "points.csv", "body.k", "-o", "welded.k"], cwd=folder, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        body.write_crash(folder)
    decks["body"] = folder / "crash.k"
    return decks


def run(nugget, deck, out, ranks, threads, cycles):
    """summary.json of a run and the processor time of all of it [s]."""
    shutil.rmtree(out, ignore_errors=True)
    command = [nugget, "run", str(deck), "-o", str(out), "-j", str(threads), "--quiet", "--max-cycles", str(cycles)]
    if ranks > 1:
        bind = "core" if ranks * threads <= os.cpu_count() else "none"
        command = ["mpirun", "--oversubscribe", "--bind-to", bind, "-n", str(ranks)] + command
    before = os.times()
    done = subprocess.run(command, capture_output=True, text=True, env=ENVIRONMENT)
    after = os.times()
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(command)}\n{done.stdout}{done.stderr}")
    user = after.children_user + after.children_system - before.children_user - before.children_system
    return json.loads((out / "summary.json").read_text(encoding="utf-8")), user


def digest(out):
    """Of the results that must not depend on ranks and threads."""
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in sorted(out.iterdir())
            if path.name == "glstat" or path.name.startswith("d3plot")}


def form(text):
    """RANKSxTHREADS as two numbers."""
    ranks, threads = text.split("x")
    return int(ranks), int(threads)


def line_of(name, ranks, threads, found, alone, user_alone):
    seconds, user, phases, summary = found
    line = f"{name:10}{ranks} x {threads}  {1e3 * seconds:8.3f} ms a cycle ({alone / seconds:.2f} x), processor {user / user_alone:.2f}  "
    line += "  ".join(f"{phase} {1e3 * t:.2f}" for phase, t in phases.items() if 1e3 * t >= 0.005)
    each = summary.get("rank", [])
    if each:
        waiting = [rank["waiting"] / max(1e-9, rank["busy"] + rank["waiting"]) for rank in each]
        sent = [rank["bytes_per_cycle"] / 1e3 for rank in each]
        line += f"  [{sent[0]:.0f}, others {max(sent[1:]):.0f} kB, waiting {min(waiting):.0%} to {max(waiting):.0%}"
        line += f", {max(rank['peak_memory_mb'] for rank in each):.0f} MB]"
    else:
        line += f"  [{summary['peak_memory_mb']:.0f} MB]"
    return line


def measure(nugget, deck, out, ranks, threads, cycles):
    short, user_short = run(nugget, deck, out, ranks, threads, cycles // 5)
    long, user_long = run(nugget, deck, out, ranks, threads, cycles)
    between = long["cycles"] - short["cycles"]
    phases = {name: (long["seconds"]["phases"][name] - short["seconds"]["phases"][name]) / between for name in long["seconds"]["phases"]}
    return (long["seconds"]["solve"] - short["seconds"]["solve"]) / between, (user_long - user_short) / between, phases, long


def beside(nugget, deck, folder, count, cycles):
    """Seconds of a cycle of `count` programs at once, of which none knows of the others."""
    with concurrent.futures.ThreadPoolExecutor(count) as pool:
        found = list(pool.map(lambda i: measure(nugget, deck, folder / f"beside{i}", 1, 1, cycles)[0], range(count)))
    return sum(found) / count


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("decks", nargs="*", metavar="DECK")
    parser.add_argument("--nugget", type=pathlib.Path, default=ROOT / "build" / "nugget")
    parser.add_argument("--shared", type=pathlib.Path, default=ROOT.parent / "shared")
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build-bench" / "ranks")
    parser.add_argument("--shells", type=int, default=55_000)
    parser.add_argument("--welds", type=int, default=600)
    parser.add_argument("--cycles", type=int, help="of the longer run, of every deck")
    parser.add_argument("--repeat", type=int, default=2)
    parser.add_argument("--forms", nargs="+", type=form, default=[form(text) for text in FORMS], metavar="RANKSxTHREADS")
    parser.add_argument("--beside", type=int, metavar="N")
    arguments = parser.parse_args()
    nugget = str(arguments.nugget.resolve())
    decks = make(nugget, arguments.shared, arguments.work.resolve(), arguments.shells, arguments.welds)
    unknown = set(arguments.decks) - set(decks)
    if unknown:
        parser.error(f"no deck named {', '.join(sorted(unknown))}; there are {', '.join(decks)}")
    for name, deck in decks.items():
        if arguments.decks and name not in arguments.decks:
            continue
        best, same, others = {}, None, []
        for _ in range(arguments.repeat):
            if arguments.beside:
                others.append(beside(nugget, deck, arguments.work.resolve(), arguments.beside, arguments.cycles or CYCLES[name]))
            for ranks, threads in arguments.forms:
                out = arguments.work.resolve() / "out"
                found = measure(nugget, deck, out, ranks, threads, arguments.cycles or CYCLES[name])
                if same is not None and digest(out) != same:
                    raise SystemExit(f"{name}: results of {ranks} x {threads} have other bytes than those of {arguments.forms[0]}")
                same = digest(out)
                if (ranks, threads) not in best or found[0] < best[ranks, threads][0]:
                    best[ranks, threads] = found
        alone, user_alone = best[arguments.forms[0]][:2]
        for (ranks, threads), found in best.items():
            print(line_of(name, ranks, threads, found, alone, user_alone), flush=True)
        if others:
            print(f"{name:10}{arguments.beside} beside {1e3 * min(others):8.3f} ms a cycle of each ({arguments.beside * alone / min(others):.2f} x together)", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
