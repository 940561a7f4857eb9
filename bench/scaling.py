# SPDX-License-Identifier: Apache-2.0
"""How far explicit runs over ranks can go: partitions real bodies, counts what ranks would send each other, and predicts the time of a cycle.

    python3 bench/scaling.py [--nugget build/nugget] [--work build-bench/scaling] [--shells 500000] [--ranks 2 8 64 512 4096]
    python3 bench/scaling.py --runs 1 2 4 --shells 20000          # the same prediction beside runs on this machine

The body is that of bench/body.py: sheets in one contact with themselves, welds, a wall. `nugget check -n N` partitions it; of partition.vtu are counted,
for each rank: elements, nodes, nodes that others have too (shared), ranks that have them (neighbours), bytes that it sends in a cycle (6 doubles for each
element at a shared node, to each other rank that has it), and ghosts: nodes of others within REACH of its own, which contact needs positions and
velocities of; `check` says how many nodes every rank follows besides. From these, costs by element (--costs: elements, contact, motion of nodes, ties and welds
[ns]) and a network (--latency, --bandwidth) two times of a cycle:

  built    what runs do today: elements, contact, nodes, ties and welds shared out, ghosts sent, nine collective agreements a cycle, in every SEARCH cycles the
           positions of all nodes; what every rank follows it moves, and gets the forces on it
  aimed    the same with two agreements a cycle and positions for a search from neighbours alone

--runs: runs of the deck over so many ranks here. What each needs of the processor is what `built` says; where there are more ranks than cores, they share
them. Run nothing else meanwhile. --json FILE, --plot FILE.svg keep the table and draw it.
"""
import argparse
import json
import math
import os
import pathlib
import re
import subprocess
import sys

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from body import ROOT, sills, write_crash

REACH = 15.0           # of contact around a node, three elements [mm]
ROW = 6 * 8            # forces and moments of an element's corner, or of a node [bytes]
GHOST = 6 * 8          # position and velocity of a node
PLACE = 4 * 8          # position of a node on its way to all
SEARCH = 100           # cycles from one search to the next
SUM = 10e-9            # to put the forces on a node of everyone's into a message and out of it [s]
ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")


def make(nugget, work, shells):
    """The body's deck in a folder of its own; how many shells it has."""
    folder = work / str(shells)
    folder.mkdir(parents=True, exist_ok=True)
    count, _ = sills(folder, shells, max(1, shells // 100), 1.0)
    for command in (["weld", "points.csv", "body.k", "-o", "welded.k"],):
        subprocess.run([nugget, *command], cwd=folder, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    write_crash(folder)
    return folder, count


def read_partition(path):
    """Positions of nodes, and of each corner of an element its node, its element and its rank."""
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    ends = vtk_to_numpy(grid.GetCells().GetOffsetsArray())
    nodes = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    element = numpy.repeat(numpy.arange(len(ends) - 1), numpy.diff(ends))
    rank = vtk_to_numpy(grid.GetCellData().GetArray("rank"))
    kept = rank[element] >= 0  # what every rank computes sends nothing
    return vtk_to_numpy(grid.GetPoints().GetData()), nodes[kept], rank[element][kept], rank


def count(path, ranks):
    """What each of `ranks` has and sends: a dictionary of arrays over ranks."""
    points, node, owner, rank = read_partition(path)
    pairs, corners = numpy.unique(node.astype(numpy.int64) * ranks + owner, return_counts=True)
    at, of = pairs // ranks, pairs % ranks
    have = numpy.bincount(at, minlength=len(points))  # ranks that have a node
    shared = have[at] > 1
    sent = numpy.bincount(of, weights=corners * (have[at] - 1) * ROW, minlength=ranks)
    # Neighbours: ranks that meet at a node. `at` ascends, so those that have it stand together.
    meet = set()
    for step in range(1, int(have.max(initial=1))):
        same = at[step:] == at[:-step]
        meet.update(zip(of[:-step][same].tolist(), of[step:][same].tolist()))
    neighbours = numpy.zeros(ranks, int)
    for a, b in meet:
        neighbours[a] += 1
        neighbours[b] += 1
    # Ghosts, by cells as wide as contact reaches: nodes in and around the cells that a rank has, less its own.
    cell = numpy.floor((points - points.min(axis=0)) / REACH).astype(numpy.int64) + 1
    size = cell.max(axis=0) + 2
    place = (cell[:, 0] * size[1] + cell[:, 1]) * size[2] + cell[:, 2]
    cells, held = numpy.unique(place[have > 0], return_counts=True)
    own = numpy.unique(place[at] * ranks + of)
    around = [(i * size[1] + j) * size[2] + k for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1)]
    reached = numpy.unique(numpy.concatenate([own + step * ranks for step in around]))
    where = numpy.searchsorted(cells, reached // ranks)
    found = (where < len(cells)) & (cells[numpy.minimum(where, len(cells) - 1)] == reached // ranks)
    in_reach = numpy.bincount(reached[found] % ranks, weights=held[where[found]], minlength=ranks)
    nodes = numpy.bincount(of, minlength=ranks)
    return {"elements": numpy.bincount(rank[rank >= 0], minlength=ranks), "nodes": nodes, "shared": numpy.bincount(of[shared], minlength=ranks),
            "neighbours": neighbours, "bytes": sent, "ghosts": numpy.maximum(in_reach - nodes, 0.0)}


def predict(arguments, all_elements, ranks, counts, of_all):
    """Seconds of a cycle: as built, and with fewer agreements and searches among neighbours; `of_all`: nodes that every rank follows."""
    element, contact, motion, ties = (1e-9 * cost * all_elements for cost in arguments.costs)
    if ranks == 1:
        whole = element + contact + motion + ties
        return {"built": whole, "aimed": whole}
    most = {name: float(values.max()) for name, values in counts.items()}
    latency, bandwidth = 1e-6 * arguments.latency, 1e9 * arguments.bandwidth
    agreement = math.ceil(math.log2(ranks)) * latency
    forces = most["neighbours"] * latency + most["bytes"] / bandwidth
    ghosts = most["neighbours"] * latency + GHOST * most["ghosts"] / bandwidth
    all_nodes = counts["nodes"].sum() - counts["shared"].sum() / 2  # as nearly all shared nodes have two ranks
    nodes = most["nodes"] / all_nodes
    own = element * most["elements"] / all_elements + contact * nodes + forces + ghosts
    sums = of_all * (ROW / bandwidth + SUM)
    places = PLACE * all_nodes / bandwidth / SEARCH
    own += (motion + ties) * nodes
    return {"built": own + motion * of_all / all_nodes + sums + places + 9 * agreement, "aimed": own + 2 * agreement}


def run_here(nugget, folder, ranks, cycles):
    """Seconds of a cycle by the clock, and of contact, of the first rank: between a fifth of the cycles and all."""
    figures = []
    for limit in (cycles // 5, cycles):
        command = ["mpirun", "--oversubscribe", "--bind-to", "none", "-n", str(ranks)] if ranks > 1 else []
        subprocess.run([*command, nugget, "run", "crash.k", "-o", f"run{ranks}", "-j", "1", "--quiet", "--max-cycles", str(limit)], cwd=folder,
                       check=True, env=ENVIRONMENT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        summary = json.loads((folder / f"run{ranks}" / "summary.json").read_text(encoding="utf-8"))
        phases = summary["seconds"]["phases"]
        figures.append((sum(phases.values()), phases))
    between = cycles - cycles // 5
    return (figures[1][0] - figures[0][0]) / between, {name: (figures[1][1][name] - figures[0][1][name]) / between for name in figures[1][1]}


def draw(rows, path):
    import matplotlib
    matplotlib.use("svg")
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(figsize=(7.0, 4.5))
    for shells in sorted({row["shells"] for row in rows}):
        of = [row for row in rows if row["shells"] == shells]
        whole = of[0]["whole"]
        for name, style in (("built", ":"), ("aimed", "-")):
            axes.plot([row["ranks"] for row in of], [whole / row[name] for row in of], style + "o", label=f"{shells:,} shells, {name}")
    ranks = sorted({row["ranks"] for row in rows})
    axes.plot(ranks, ranks, color="0.7", label="ideal")
    axes.set(xscale="log", yscale="log", xlabel="ranks", ylabel="times as fast as one rank")
    axes.legend()
    figure.savefig(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--nugget", type=pathlib.Path, default=ROOT / "build" / "nugget")
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build-bench" / "scaling")
    parser.add_argument("--shells", type=int, nargs="+", default=[500_000])
    parser.add_argument("--ranks", type=int, nargs="+", default=[2, 4, 8, 16, 64, 256, 1024, 4096])
    parser.add_argument("--costs", type=float, nargs=4, default=[75.0, 122.0, 8.2, 5.3], metavar="NS",
                        help="elements, contact, motion, ties and welds, by element (docs/evidence/performance.md, Explicit runs over ranks)")
    parser.add_argument("--latency", type=float, default=2.0, help="of a message [microseconds]")
    parser.add_argument("--bandwidth", type=float, default=10.0, help="of each rank [GB/s]")
    parser.add_argument("--runs", type=int, nargs="+", default=[])
    parser.add_argument("--cycles", type=int, default=250, help="of each run")
    parser.add_argument("--json", type=pathlib.Path)
    parser.add_argument("--plot", type=pathlib.Path)
    arguments = parser.parse_args()
    nugget, rows = str(arguments.nugget.resolve()), []
    if arguments.runs:
        arguments.ranks = arguments.runs
    for shells in arguments.shells:
        folder, elements = make(nugget, arguments.work, shells)
        measured = {ranks: run_here(nugget, folder, ranks, arguments.cycles) for ranks in arguments.runs}
        if 1 in measured:
            phases = measured[1][1]
            arguments.costs = [1e9 * phases.get(name, 0.0) / elements for name in ("elements", "contact", "motion", "constraints")]
        print(f"{elements} shells; costs {', '.join(f'{c:.1f}' for c in arguments.costs)} ns")
        print(f"{'ranks':>6}{'elements':>10}{'nodes':>8}{'shared':>8}{'neighbours':>11}{'ghosts':>8}{'kB sent':>9}"
              f"{'built ms':>11}{'times':>7}{'aimed ms':>11}{'times':>7}" + ("   run ms" if measured else ""))
        whole = predict(arguments, elements, 1, {}, 0)["built"]
        for ranks in arguments.ranks:
            counts, of_all = {}, 0
            if ranks > 1:
                said = subprocess.run([nugget, "check", "crash.k", "-n", str(ranks), "-o", "partition", "-j", "2"], cwd=folder, check=True, capture_output=True, text=True).stdout
                counts = count(folder / "partition" / "partition.vtu", ranks)
                moved = re.search(r"moves (\d+) nodes for it", said)
                of_all = int(moved[1]) if moved else 0
            time = predict(arguments, elements, ranks, counts, of_all)
            most = {name: int(values.max()) for name, values in counts.items()}
            row = {"shells": elements, "ranks": ranks, "whole": whole, **{f"most_{name}": value for name, value in most.items()}, **time}
            line = f"{ranks:6}" + "".join(f"{most.get(name, 0):{width}}" for name, width in (("elements", 10), ("nodes", 8), ("shared", 8), ("neighbours", 11), ("ghosts", 8)))
            line += f"{most.get('bytes', 0) / 1e3:9.0f}" + "".join(f"{1e3 * time[name]:11.3f}{whole / time[name]:7.1f}" for name in ("built", "aimed"))
            if ranks in measured:
                row["run"] = measured[ranks][0]
                at_once = max(1.0, ranks / os.cpu_count())
                row["built here"] = time["built"] * at_once
                line += f"{1e3 * row['run']:9.3f}" + (f" (predicted {1e3 * row['built here']:.3f}: {ranks} ranks on {os.cpu_count()} cores)" if at_once > 1.0 else "")
            print(line, flush=True)
            rows.append(row)
    if arguments.json:
        arguments.json.write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")
    if arguments.plot:
        draw(rows, arguments.plot)
    return 0


if __name__ == "__main__":
    sys.exit(main())
