# SPDX-License-Identifier: Apache-2.0
"""Runs the neutral benchmark decks and prints ns per element-cycle, with --radioss beside OpenRadioss on the same machine.

    python3 bench/run_decks.py [--nugget build/nugget] [--shared ../shared] [--kernels kernels.json] [DECK ...]
    python3 bench/run_decks.py --against OLD/nugget [--repeat 3] [--single] [--max-cycles N] [--nugget ...] [DECK ...]
    python3 bench/run_decks.py --radioss STARTER ENGINE [--nugget ...] [--until SHARE] [--repeat 2] [DECK ...]

The decks come from SHARED/bench/gen_impact.py and SHARED/decks (car6), which are not part of this repository; without them
there is nothing to run and the program says so. One thread (and tube3 on two), one deck after the other: run nothing else meanwhile. KERNELS is the JSON output of
nugget_bench; its STREAM and FMA peaks are printed with the table, because a figure means little without its machine.

--against: another build of Nugget and this one in turn, REPEAT times each, one thread: of each the least, whole and by phase, and their ratio (below 1:
this one is faster). --single: this one with --precision single; --against build/nugget --single compares the precisions. With
--max-cycles N the last line of a deck is user time, of N cycles less that of N/4, so without reading and report: for machines that others use.
NUGGET_LANES=4 in the environment keeps both from taking eight lanes (docs/decisions/0094); OLD:4 or OLD:8 sets it for OLD alone.

--radioss: both programs in one run, in turn, REPEAT times, one thread each, to SHARE of each deck's end time; printed is user time by element-cycle, and in
the whole, as the programs' steps differ. Of OpenRadioss it is the engine's alone, without animations; of Nugget it is all. RAD_CFG_PATH and LD_LIBRARY_PATH
are OpenRadioss's own and are taken from the environment. car6 is left out: OpenRadioss's reader refuses it.
"""
import argparse
import itertools
import json
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
DECKS = ("tube3", "tube3_16", "tube5", "tube5_cp", "tube5_table", "tube5_123", "tube5_erosion", "tube5_gissmo", "tube5c", "hex_ihq2", "hex_ihq6", "weld", "car6")


def with_full_integration(deck):
    """tube3 with ELFORM 16."""
    text = deck.read_text(encoding="utf-8")
    section = re.search(r"\*SECTION_SHELL\n([^\n]*)\n", text)
    fields = section[1].split(",") if "," in section[1] else re.findall(r".{1,10}", section[1])
    fields[1] = "16"
    text = text[:section.start(1)] + ",".join(field.strip() for field in fields) + text[section.end(1):]
    deck.with_name("tube3_16.k").write_text(text, encoding="utf-8")


def with_other_cards(deck):
    """tube5 with what most body sheets have: C and P of mild steel, a table of curves over the logarithm of the rate; and with
    what lets them fail, by limits that nothing reaches."""
    text = deck.read_text(encoding="utf-8")
    begin = text.index("*MAT_PIECEWISE_LINEAR_PLASTICITY")
    end = text.index("*", begin + 1)

    def put(name, rates, more="", law="PIECEWISE_LINEAR_PLASTICITY"):
        card = f"*MAT_{law}\n1,7.85e-9,2.1e5,0.3,300.0,1000.0\n{rates}\n\n\n{more}"
        deck.with_name(name).write_text(text[:begin] + card + text[end:], encoding="utf-8")

    put("tube5_cp.k", "40.4,5.0")
    logarithms = {101: -6.9, 102: 0.0, 103: 2.3, 104: 4.6, 105: 6.9}
    points = ((0.0, 300.0), (0.01, 330.0), (0.05, 390.0), (0.1, 430.0), (0.2, 480.0), (1.0, 600.0))
    table = "*DEFINE_TABLE_2D\n100\n" + "".join(f"{rate},{curve}\n" for curve, rate in logarithms.items())
    for i, curve in enumerate(logarithms):
        table += f"*DEFINE_CURVE\n{curve}\n" + "".join(f"{x},{y * (1.0 + 0.05 * i)}\n" for x, y in points)
    put("tube5_table.k", "0,0,100", table)
    put("tube5_123.k", "0,0,0,0,0,0.8,3.0", law="MODIFIED_PIECEWISE_LINEAR_PLASTICITY")
    put("tube5_erosion.k", "0,0", "*MAT_ADD_EROSION\n1\n0,0,0,3.0\n")
    fracture = "".join(f"{triaxiality},{strain}\n" for triaxiality, strain in ((-0.67, 9.0), (0.0, 4.0), (0.33, 3.0), (0.67, 2.0)))
    put("tube5_gissmo.k", "0,0", f"*MAT_ADD_DAMAGE_GISSMO\n1,0,1\n200,0,2.0,0,2.0\n0\n*DEFINE_CURVE\n200\n{fracture}")


def run(nugget, deck, results, threads, environment=None, options=()):
    """summary.json of a run, or the reason why there is none."""
    command = [str(nugget), "run", str(deck), "-o", str(results), "-j", str(threads), "--quiet", *options]
    done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, env=environment)
    summary = results / "summary.json"
    if done.returncode != 0 or not summary.is_file():
        reason = (done.stderr.strip() or done.stdout.strip() or "no summary.json").splitlines()[0]
        return None, f"exit code {done.returncode}: {reason}"
    return json.loads(summary.read_text(encoding="utf-8")), ""


def against(arguments, names):
    """Two builds of Nugget in turn on each deck: the least time of each, ns per element-cycle."""
    old, _, lanes = arguments.against.partition(":")
    programs = {"before": (old, lanes, ()), "now": (str(arguments.nugget), "", ("--precision", "single") if arguments.single else ())}
    limits = (arguments.max_cycles // 4, arguments.max_cycles) if arguments.max_cycles else (0,)
    print(f"{'deck':<12}{'phase':<12}{'before':>10}{'now':>10}{'ratio':>8}   (ns per element-cycle, one thread, least of {arguments.repeat} runs in turn)")
    for name in names:
        deck, least, work = arguments.work / f"{name}.k", {}, {}
        for _ in range(arguments.repeat):
            for limit, (label, (program, own_lanes, options)) in itertools.product(limits, programs.items()):
                environment = {**os.environ, "NUGGET_LANES": own_lanes} if own_lanes else None
                options = (*options, "--max-cycles", str(limit)) if limit else options
                before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
                summary, reason = run(program, deck, arguments.work / f"{name}_{label}", 1, environment, options)
                if summary is None:
                    sys.exit(f"{name} {label}: {reason}")
                work[limit] = summary["cycles"] * sum(summary["elements"].values()) * 1e-9
                times = {limit: resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before}
                if limit == limits[-1]:
                    phases = summary["seconds"]["phases"]
                    times |= {"all": summary["ns_per_element_cycle"], **{phase: phases[phase] / work[limit] for phase in ("elements", "contact", "motion")}}
                for key, value in times.items():
                    least[key, label] = min(value, least.get((key, label), value))
        if len(limits) == 2 and work[limits[1]] > work[limits[0]]:
            for label in programs:
                least["user", label] = (least[limits[1], label] - least[limits[0], label]) / (work[limits[1]] - work[limits[0]])
        for phase in ("all", "elements", "contact", "motion", "user"):
            before, now = least.get((phase, "before"), 0.0), least.get((phase, "now"), 0.0)
            if before > 0.5:
                print(f"{name if phase == 'all' else '':<12}{phase:<12}{before:>10.1f}{now:>10.1f}{now / before:>8.2f}", flush=True)
    return 0


def user_time(command, folder, log):
    """Seconds of user time of a command, run in a folder with its output in a file there; a command that fails ends the program."""
    folder.mkdir(parents=True, exist_ok=True)
    with open(folder / log, "wb") as file:
        process = subprocess.Popen([str(c) for c in command], cwd=folder, stdin=subprocess.DEVNULL, stdout=file, stderr=subprocess.STDOUT)
        _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit(f"{' '.join(str(c) for c in command)}: status {status}, see {folder / log}")
    return usage.ru_utime


def end_time(deck):
    found = re.search(r"\*CONTROL_TERMINATION[^\n]*\n(?:\$[^\n]*\n)*([^\n]{1,10})", deck.read_text(encoding="utf-8"))
    return float(found.group(1))


def run_radioss(starter, engine, deck, folder, until):
    """(user seconds of the engine, cycles) of a deck read by OpenRadioss's own reader."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    shutil.copy(deck, folder)
    user_time([starter, "-i", deck.name, "-np", "1"], folder, "starter.log")
    commands = folder / f"{deck.stem}_0001.rad"
    blocks = re.split(r"\n(?=/)", commands.read_text(encoding="utf-8"))  # what the starter wrote for the engine, without its animations
    kept = [b for b in blocks if not b.startswith(("/ANIM", "/RUN", "/H3D"))]
    commands.write_text(f"/RUN/{deck.stem}/1\n{until:.10g}\n" + "\n".join(kept) + "\n", encoding="utf-8")
    seconds = user_time([engine, "-i", commands.name, "-nt", "1"], folder, "engine.log")
    listing = (folder / f"{deck.stem}_0001.out").read_text(encoding="utf-8", errors="replace")
    cycles = re.search(r"TOTAL NUMBER OF CYCLES\s*:\s*(\d+)", listing)
    if not cycles or "NORMAL TERMINATION" not in listing:
        sys.exit(f"{deck.stem}: OpenRadioss did not come to its end, see {folder / 'engine.log'}")
    return seconds, int(cycles.group(1))


def side_by_side(arguments, names):
    """Nugget and OpenRadioss in turn on each deck."""
    most = resource.getrlimit(resource.RLIMIT_STACK)[1]
    resource.setrlimit(resource.RLIMIT_STACK, (most, most))  # its engine keeps element groups on the stack
    starter, engine = arguments.radioss
    print(f"{'deck':<12}{'cycles':>16}{'user s':>18}{'ns':>18}{'ratio by ns':>14}{'in the whole':>14}   (Nugget, OpenRadioss)")
    for name in names:
        deck = arguments.work / f"{name}.k"
        until = arguments.until * end_time(deck)
        for _ in range(arguments.repeat):
            results = arguments.work / name
            ours = user_time([arguments.nugget, "run", deck, "-o", results, "-j1", "--quiet", "--until", until], results, "nugget.out")
            summary = json.loads((results / "summary.json").read_text(encoding="utf-8"))
            cycles, elements = summary["cycles"], sum(summary["elements"].values())
            theirs, steps = run_radioss(starter, engine, deck, arguments.work / f"{name}_radioss", until)
            a, b = 1e9 * ours / cycles / elements, 1e9 * theirs / steps / elements
            print(f"{name:<12}{cycles:>8}{steps:>8}{ours:>9.2f}{theirs:>9.2f}{a:>9.0f}{b:>9.0f}{b / a:>14.1f}{theirs / ours:>14.1f}", flush=True)
    return 0


def peaks(path):
    """Lines on the machine: the results in nugget_bench's output whose names speak of STREAM or FMA."""
    if not path or not path.is_file():
        return []
    lines = []
    for result in json.loads(path.read_text(encoding="utf-8"))["benchmarks"]:
        if re.search("stream|fma|peak", result["name"], re.IGNORECASE):
            if "bytes_per_second" in result:
                lines.append(f"{result['name']}: {result['bytes_per_second'] / 1e9:.1f} GB/s")
            if "items_per_second" in result:
                lines.append(f"{result['name']}: {result['items_per_second'] / 1e9:.1f} G/s")
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--nugget", type=pathlib.Path, default=ROOT / "build" / "nugget")
    parser.add_argument("--shared", type=pathlib.Path, default=ROOT.parent / "shared")
    parser.add_argument("--kernels", type=pathlib.Path)
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build-bench" / "decks", help="where decks and results go")
    parser.add_argument("--radioss", nargs=2, type=pathlib.Path, metavar=("STARTER", "ENGINE"),
                        help="run OpenRadioss on the same decks, in turn with Nugget")
    parser.add_argument("--against", metavar="OLD[:LANES]", help="another build of Nugget, in turn with this one")
    parser.add_argument("--single", action="store_true", help="with --against: this build in single precision")
    parser.add_argument("--max-cycles", type=int, metavar="N", help="with --against: of each run")
    parser.add_argument("--until", type=float, default=1.0, metavar="SHARE", help="with --radioss: of each deck's end time (1)")
    parser.add_argument("--repeat", type=int, default=2, help="with --radioss and --against: how often (2)")
    parser.add_argument("decks", nargs="*", metavar="DECK", help=f"of {', '.join(DECKS)} (all)")
    arguments = parser.parse_args()
    generator = arguments.shared / "bench" / "gen_impact.py"
    if not generator.is_file():
        print(f"{generator} is not there: no decks to run")
        return 0
    unknown = set(arguments.decks) - set(DECKS)
    if unknown:
        parser.error(f"no deck named {', '.join(sorted(unknown))}")
    arguments.work.mkdir(parents=True, exist_ok=True)
    subprocess.run([sys.executable, str(generator), str(arguments.work)], check=True)
    with_other_cards(arguments.work / "tube5.k")
    with_full_integration(arguments.work / "tube3.k")
    if arguments.against:
        return against(arguments, [name for name in arguments.decks or DECKS if name != "car6"])
    if arguments.radioss:
        arguments.radioss = [program.resolve() for program in arguments.radioss]
        arguments.nugget, arguments.work = arguments.nugget.resolve(), arguments.work.resolve()
        return side_by_side(arguments, [name for name in arguments.decks or DECKS if name != "car6"])

    failures = 0
    print(f"{'deck':<12}{'cycles':>10}{'seconds':>10}{'ns':>10}   (ns per element-cycle, one thread)")
    runs = [(name, 1) for name in arguments.decks or DECKS]
    if ("tube3", 1) in runs:
        runs.append(("tube3", 2))
    for name, threads in runs:
        deck = arguments.work / f"{name}.k"
        if name == "car6":
            deck = arguments.shared / "decks" / "car6" / "main_v223.k"
        summary, reason = run(arguments.nugget, deck, arguments.work / name, threads)
        label = name if threads == 1 else f"{name} -j{threads}"
        if summary is None:
            failures += 1
            print(f"{label:<12}  {reason}")
            continue
        print(f"{label:<12}{summary['cycles']:>10}{summary['seconds']['solve']:>10.1f}{summary['ns_per_element_cycle']:>10.1f}", flush=True)
    for line in peaks(arguments.kernels):
        print(line)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
