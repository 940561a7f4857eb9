# SPDX-License-Identifier: Apache-2.0
"""Runs the neutral benchmark decks and prints ns per element-cycle beside the figures of another code.

    python3 bench/run_decks.py [--nugget build/nugget] [--shared ../shared] [--kernels kernels.json] [DECK ...]

The decks come from SHARED/bench/gen_impact.py and SHARED/decks (car6), which are not part of this repository; without them
there is nothing to run and the program says so. One thread (and tube3 on two), one deck after the other: run nothing else meanwhile. KERNELS is the JSON output of
nugget_bench; its STREAM and FMA peaks are printed with the table, because a figure means little without its machine.
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
DECKS = ("tube3", "tube5", "tube5_cp", "tube5_table", "tube5c", "hex_ihq2", "hex_ihq6", "weld", "car6")


def figures_of_openradioss(readme):
    """{deck: ns per element-cycle}, from the list `tube3 676, tube5 782, ...` in the README beside the generators."""
    match = re.search(r"Measured with OpenRadioss.*", readme.read_text(encoding="utf-8")) if readme.is_file() else None
    return {name: float(ns) for name, ns in re.findall(r"\b(\w+) (\d+)\b", match.group(0))} if match else {}


def with_rates(deck):
    """tube5 with what most body sheets have: C and P of mild steel, and a table of curves over the logarithm of the rate."""
    text = deck.read_text(encoding="utf-8")
    begin = text.index("*MAT_PIECEWISE_LINEAR_PLASTICITY")
    end = text.index("*", begin + 1)

    def put(name, rates, more=""):
        card = f"*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,7.85e-9,2.1e5,0.3,300.0,1000.0\n{rates}\n\n\n{more}"
        deck.with_name(name).write_text(text[:begin] + card + text[end:], encoding="utf-8")

    put("tube5_cp.k", "40.4,5.0")
    logarithms = {101: -6.9, 102: 0.0, 103: 2.3, 104: 4.6, 105: 6.9}
    points = ((0.0, 300.0), (0.01, 330.0), (0.05, 390.0), (0.1, 430.0), (0.2, 480.0), (1.0, 600.0))
    table = "*DEFINE_TABLE_2D\n100\n" + "".join(f"{rate},{curve}\n" for curve, rate in logarithms.items())
    for i, curve in enumerate(logarithms):
        table += f"*DEFINE_CURVE\n{curve}\n" + "".join(f"{x},{y * (1.0 + 0.05 * i)}\n" for x, y in points)
    put("tube5_table.k", "0,0,100", table)


def run(nugget, deck, results, threads):
    """summary.json of a run, or the reason why there is none."""
    command = [str(nugget), "run", str(deck), "-o", str(results), "-j", str(threads), "--quiet"]
    done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True)
    summary = results / "summary.json"
    if done.returncode != 0 or not summary.is_file():
        reason = (done.stderr.strip() or done.stdout.strip() or "no summary.json").splitlines()[0]
        return None, f"exit code {done.returncode}: {reason}"
    return json.loads(summary.read_text(encoding="utf-8")), ""


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
    with_rates(arguments.work / "tube5.k")
    other = figures_of_openradioss(arguments.shared / "bench" / "README.md")
    other.setdefault("car6", 1075.0)  # the README's sentence on car6

    failures = 0
    print(f"{'deck':<12}{'cycles':>10}{'seconds':>10}{'ns':>10}{'OpenRadioss ns':>16}{'ratio':>8}   (ns per element-cycle, one thread)")
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
        ns = summary["ns_per_element_cycle"]
        reference = other.get(name) if threads == 1 else None
        print(f"{label:<12}{summary['cycles']:>10}{summary['seconds']['solve']:>10.1f}{ns:>10.1f}"
              + (f"{reference:>16.0f}{reference / ns if ns else 0.0:>8.1f}" if reference else ""), flush=True)
    for line in peaks(arguments.kernels):
        print(line)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
