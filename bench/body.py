# SPDX-License-Identifier: Apache-2.0
"""Writes a body-like model (500,000 shells, 5,000 welds) and times tie and audit, an impact, or natural modes on it.

    python3 bench/body.py [--nugget build/nugget] [--work build-bench/body] [--shells 500000] [--welds 5000] [--threads 1]
    python3 bench/body.py --study crash [--end 1e-4] ...
    python3 bench/body.py --study cards [--other OLD_NUGGET] --shells 55000 --welds 700 --end 3e-5
    python3 bench/body.py --study growth [--other OLD_NUGGET] [--sizes 20000,100000,500000] [--cycles 5,45] [--repeat 2]
    python3 bench/body.py --study results [--other OLD_NUGGET] [--ranks 1,2,4,8] [--cycles 5]
    python3 bench/body.py --study modes [--modes 50] [--shells 280000] [--welds 800] ...

The body is a row of closed sills: each is a curved hat with flanges, and a floor strip under it, both of 5 mm elements; some
carry a third strip under one flange. For modes the hats are straight and stand on one floor, so that it is one body. Spots
stand along the flanges, three elements wide; `nugget weld` places them, so that the deck is one that a user could have made.
What is timed is `nugget check` as its check.log tells it: reading, then tie and audit together (aim: under 5 s); the impact of
the body against a wall at 10 m/s, all of it in one contact with itself; that impact with one more card that many decks have,
phase by phase, in turn with another program's where one is given; what that impact costs with the size of the body, setup and
memory too (a cycle is what the later of two runs takes longer than the earlier, in processor time of the user); what results that are
as large as the model cost ranks (megabytes of each at most, seconds by the clock, checksums of the files); modes up to their number, files and report included.
"""
import argparse
import math
import json
import os
import pathlib
import re
import subprocess
import sys
import time
import zlib

from modes import measure

ROOT = pathlib.Path(__file__).resolve().parent.parent
SIZE = 5.0                       # of an element
FLANGE, WALL, ROOF = 3, 10, 12   # elements across a flange, a wall, the roof of the hat
THICKNESS = {"hat": 1.2, "floor": 1.5, "third": 1.0}
CURVATURE = 4.0e-4               # of the sill's axis, 1/mm
LENGTH = 250                     # elements along a sill
PITCH = 50                       # elements of the floor from one hat to the next
IMPACT = """*CONTACT_AUTOMATIC_SINGLE_SURFACE
         0
       0.1       0.1

         2
*INITIAL_VELOCITY_GENERATION
         0         2            -1.0e4       0.0       0.0

*RIGIDWALL_PLANAR
         0
      -0.5       0.0       0.0       1.0       0.0       0.0       0.1
*CONTROL_ENERGY
         2         2         2         2
"""
RESULTS = {  # what is as large as the model
    "none": "",
    "d3plot each cycle": "*DATABASE_BINARY_D3PLOT\n   1.0E-12\n",
    "elout, text": "*DATABASE_ELOUT\n       1.0         1\n*DATABASE_HISTORY_SHELL_SET\n         3\n",
    "nodout, both": "*DATABASE_NODOUT\n       1.0         3\n*DATABASE_HISTORY_NODE_SET\n         3\n",
    "elout, binout": "*DATABASE_ELOUT\n       1.0         2\n*DATABASE_HISTORY_SHELL_SET\n         3\n",
}
ALL = {"SHELL": "*SET_SHELL_GENERAL\n         3\nALL\n", "NODE": "*SET_NODE_GENERAL\n         3\nALL\n"}
CARDS = {  # set 2: the sheets
    "none": "",
    "histories every 1e-6": "*DATABASE_HISTORY_NODE\n         1\n" + "".join(f"*DATABASE_{f}\n   1.0E-06\n" for f in ("NODOUT", "RWFORC", "RCFORC")),
    "DAMPING_GLOBAL": "*DAMPING_GLOBAL\n         0      10.0\n",
    "DAMPING_PART_STIFFNESS": "*DAMPING_PART_STIFFNESS_SET\n         2      0.05\n",
    "DAMPING_FREQUENCY_RANGE": "*DAMPING_FREQUENCY_RANGE\n      0.02       1.0     300.0         2\n",
    "DAMPING_FREQUENCY_RANGE_DEFORM": "*DAMPING_FREQUENCY_RANGE_DEFORM\n      0.02       1.0     300.0         2\n",
}


def hat_profile():
    """(y, z) of the hat's nodes across: flange, wall, roof, wall, flange."""
    points, y, z = [(0.0, 0.0)], 0.0, 0.0
    for count, dy, dz in ((FLANGE, 1, 0), (WALL, 0, 1), (ROOF, 1, 0), (WALL, 0, -1), (FLANGE, 1, 0)):
        for _ in range(count):
            y, z = y + dy * SIZE, z + dz * SIZE
            points.append((y, z))
    return points


def strip(count, z):
    return [(SIZE * j, z) for j in range(count + 1)]


class Body:
    def __init__(self, path, curvature):
        self.curvature = curvature
        self.file = open(path, "w", encoding="ascii")
        self.nodes, self.shells, self.node, self.shell, self.part = [], [], 0, 0, 0
        self.parts, self.points = [], []

    def lift(self, x, length):
        return 0.5 * self.curvature * (x - 0.5 * SIZE * length) ** 2

    def sheet(self, kind, profile, length, origin):
        """Sweeps a profile along the axis."""
        self.part += 1
        self.parts.append((self.part, kind))
        first = self.node + 1
        for i in range(length + 1):
            x = SIZE * i
            for y, z in profile:
                self.node += 1
                z += self.lift(x, length)
                self.nodes.append(f"{self.node:8d}{x + origin[0]:16.5f}{y + origin[1]:16.5f}{z + origin[2]:16.5f}\n")
        across = len(profile)
        for i in range(length):
            for j in range(across - 1):
                a = first + i * across + j
                self.shell += 1
                self.shells.append(f"{self.shell:8d}{self.part:8d}{a:8d}{a + 1:8d}{a + 1 + across:8d}{a + across:8d}\n")

    def spots(self, count, length, y, z, origin):
        for k in range(count):
            x = SIZE * length * (k + 0.5) / count
            self.points.append((x + origin[0], y + origin[1], z + self.lift(x, length) + origin[2]))

    def write(self, end):
        f = self.file
        f.write("*KEYWORD\n*TITLE\nbody-like bench of sills\n*CONTROL_TERMINATION\n" + f"{end:10.3g}" + "\n*CONTROL_TIMESTEP\n       0.0       0.9\n"
                "*MAT_PIECEWISE_LINEAR_PLASTICITY\n         1  7.85e-09  210000.0       0.3     300.0    1000.0\n       0.0\n\n\n")
        for number, (kind, t) in enumerate(THICKNESS.items(), start=1):
            f.write(f"*SECTION_SHELL\n{number:10d}         2    0.8333         3\n" + f"{t:10.2f}" * 4 + "\n")
        sections = list(THICKNESS)
        for part, kind in self.parts:
            f.write(f"*PART\n{kind} {part}\n{part:10d}{sections.index(kind) + 1:10d}{1:10d}\n")
        f.write("*NODE\n")
        f.writelines(self.nodes)
        f.write("*ELEMENT_SHELL\n")
        f.writelines(self.shells)
        f.write("*END\n")
        f.close()


def sills(folder, shells, welds, end):
    """Writes body.k and points.csv of the row of sills; returns how many shells and points there are."""
    profile = hat_profile()
    floor = len(profile) - 1 - 2 * WALL
    number = max(1, round(shells / (LENGTH * (len(profile) - 1 + floor + 0.25 * FLANGE))))
    per_flange = max(1, round(welds / (2 * number)))
    body = Body(folder / "body.k", CURVATURE)
    gap_floor = 0.5 * (THICKNESS["hat"] + THICKNESS["floor"])
    gap_third = gap_floor + 0.5 * (THICKNESS["floor"] + THICKNESS["third"])
    for sill in range(number):
        origin = (1300.0 * (sill % 10), 250.0 * (sill // 10), 0.0)
        body.sheet("hat", profile, LENGTH, origin)
        body.sheet("floor", strip(floor, -gap_floor), LENGTH, origin)
        if sill % 4 == 0:
            body.sheet("third", strip(FLANGE, -gap_third), LENGTH, origin)
        for y in (0.5 * FLANGE * SIZE, (floor - 0.5 * FLANGE) * SIZE):
            body.spots(per_flange, LENGTH, y, -0.5 * gap_floor, origin)
    return finish(folder, body, end)


def panel(folder, shells, welds, end):
    """The same of straight hats on one floor, as long as eight of them are wide."""
    profile = hat_profile()
    width = len(profile) - 1 - 2 * WALL
    hats = 8
    length = max(PITCH, round(shells / (hats * (PITCH + len(profile) - 1))))
    per_flange = max(1, round(welds / (2 * hats)))
    gap = 0.5 * (THICKNESS["hat"] + THICKNESS["floor"])
    body = Body(folder / "body.k", 0.0)
    body.sheet("floor", strip(hats * PITCH, -gap), length, (0.0, 0.0, 0.0))
    for hat in range(hats):
        origin = (0.0, SIZE * (hat * PITCH + 0.5 * (PITCH - width)), 0.0)
        body.sheet("hat", profile, length, origin)
        for y in (0.5 * FLANGE * SIZE, (width - 0.5 * FLANGE) * SIZE):
            body.spots(per_flange, length, y, -0.5 * gap, origin)
    return finish(folder, body, end)


def finish(folder, body, end):
    body.write(end)
    with open(folder / "points.csv", "w", encoding="ascii") as f:
        f.write("x,y,z\n")
        f.writelines(f"{x:.4f},{y:.4f},{z:.4f}\n" for x, y, z in body.points)
    return body.shell, len(body.points)


def write_crash(work, card=""):
    text = (work / "welded.k").read_text(encoding="ascii")
    at = text.rindex("*END")
    (work / "crash.k").write_text(text[:at] + IMPACT + card + text[at:], encoding="ascii")


def cards(programs, work, threads, until):
    """ns per element-cycle of each phase, by the clock, up to a small share of the end, so that results are written seldom."""
    for name, card in CARDS.items():
        write_crash(work, card)
        for program in programs:
            measure([program, "run", "crash.k", "-o", "crash", "-j", str(threads), "--quiet", "--until", str(until)], work)
            summary = json.loads((work / "crash" / "summary.json").read_text(encoding="utf-8"))
            count = summary["cycles"] * sum(summary["elements"].values())
            phases = "  ".join(f"{phase} {1e9 * seconds / count:5.1f}" for phase, seconds in summary["seconds"]["phases"].items())
            print(f"{name:32}{phases}  {program}")


def crash(nugget, work, threads):
    write_crash(work)
    seconds, memory = measure([nugget, "run", "crash.k", "-o", "crash", "-j", str(threads), "--quiet"], work)
    summary = json.loads((work / "crash" / "summary.json").read_text(encoding="utf-8"))
    print(f"nugget run    {seconds:8.1f} s of processor time, {memory:.0f} MB, {summary['cycles']} cycles, "
          f"{summary['ns_per_element_cycle']:.0f} ns per element-cycle (by the clock), "
          f"energy ratio {summary['energy']['ratio']:.6f}")


def growth(programs, work, threads, sizes, cycles, repeat):
    """The impact by size: the least of `repeat` runs of each length, programs in turn."""
    print("  shells  user ns per element-cycle: all  (by the clock: elements contact motion)  setup s  ns a shell   MB  bytes a shell  program")
    for size in sizes:
        shells, _ = sills(work, size, size // 100, 0.1)
        subprocess.run([programs[0], "weld", "points.csv", "body.k", "-o", "welded.k"], cwd=work, capture_output=True, check=True)
        write_crash(work)
        best = {(program, count): None for program in programs for count in cycles}
        for _ in range(repeat):
            for program, count in best:
                arguments = [program, "run", "crash.k", "-o", "crash", "-j", str(threads), "--quiet", "--max-cycles", str(count)]
                process = subprocess.Popen(arguments, cwd=work, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                _, status, usage = os.wait4(process.pid, 0)
                if status != 0:
                    sys.exit(f"{program} failed in {work}: exit status {status}")
                summary = json.loads((work / "crash" / "summary.json").read_text(encoding="utf-8"))
                row = {"user": usage.ru_utime, "memory": usage.ru_maxrss * 1024, "setup": summary["seconds"]["setup"], **summary["seconds"]["phases"]}
                before = best[program, count]
                best[program, count] = row if before is None else {name: min(before[name], value) for name, value in row.items()}
        for program in programs:
            few, more = (best[program, count] for count in cycles)
            count = (cycles[1] - cycles[0]) * sum(summary["elements"].values())
            cost = {name: 1e9 * (more[name] - few[name]) / count for name in ("user", "elements", "contact", "motion")}
            print(f"{shells:8}  {cost['user']:30.1f}  {cost['elements']:24.1f} {cost['contact']:7.1f} {cost['motion']:6.1f}  {few['setup']:7.2f}"
                  f"  {1e9 * few['setup'] / shells:10.0f}  {more['memory'] / 1e6:4.0f}  {more['memory'] / shells:13.0f}  {program}", flush=True)


def results(programs, work, threads, ranks, cycles):
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", NUGGET_LANES="4")
    for name, card in RESULTS.items():
        write_crash(work, card + "".join(members for kind, members in ALL.items() if f"_{kind}_SET" in card))
        files = {}
        for count in ranks:
            for program in programs:
                command = [program, "run", "crash.k", "-o", "crash", "-j", str(threads), "--quiet", "--max-cycles", str(cycles)]
                if count > 1:
                    command = ["mpirun", "--oversubscribe", "--bind-to", "none", "-n", str(count), *command]
                subprocess.run(command, cwd=work, env=environment, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                summary = json.loads((work / "crash" / "summary.json").read_text(encoding="utf-8"))
                peaks = [rank["peak_memory_mb"] for rank in summary.get("rank", [])] or [summary["peak_memory_mb"]]
                of_files = {file.name: zlib.crc32(file.read_bytes()) for file in sorted((work / "crash").iterdir())
                            if re.match("d3plot|elout|nodout|binout", file.name)}
                same = files.setdefault("one", of_files) == of_files
                others = f", others {min(peaks[1:]):.0f} to {max(peaks[1:]):.0f}" if count > 1 else ""
                print(f"{name:20} {count} ranks: first {peaks[0]:.0f} MB{others}; output {summary['seconds']['phases']['output']:.2f} s of "
                      f"{summary['seconds']['solve']:.2f}; {'the same bytes' if same else 'OTHER BYTES'}  {program}", flush=True)


def modes(nugget, work, threads, number):
    seconds, memory = measure([nugget, "modes", "welded.k", "-n", str(number), "-o", "modes", "-j", str(threads), "--quiet"], work)
    log = (work / "modes" / "run.log").read_text(encoding="utf-8")
    print(f"nugget modes  {seconds:8.1f} s of processor time, {memory:.0f} MB")
    print("\n".join(re.findall(r"^ \d+ (?:equations|factorizations).*", log, re.MULTILINE)))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--study", choices=("tie", "crash", "cards", "growth", "results", "modes"), default="tie")
    parser.add_argument("--nugget", type=pathlib.Path, default=ROOT / "build" / "nugget")
    parser.add_argument("--other", type=pathlib.Path)
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build-bench" / "body")
    parser.add_argument("--shells", type=int, default=500_000)
    parser.add_argument("--welds", type=int, default=5_000)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--end", type=float, default=1e-4)
    parser.add_argument("--modes", type=int, default=50)
    parser.add_argument("--sizes", default="20000,100000,500000")
    parser.add_argument("--cycles", default="5,45")
    parser.add_argument("--ranks", default="1,2,4,8")
    parser.add_argument("--repeat", type=int, default=2)
    arguments = parser.parse_args()
    nugget, work = str(arguments.nugget.resolve()), arguments.work
    work.mkdir(parents=True, exist_ok=True)
    programs = [nugget] + ([str(arguments.other.resolve())] if arguments.other else [])
    if arguments.study == "growth":
        whole = lambda text: [int(word) for word in text.split(",")]
        growth(programs, work, arguments.threads, whole(arguments.sizes), whole(arguments.cycles), arguments.repeat)
        return 0
    write = panel if arguments.study == "modes" else sills
    shells, points = write(work, arguments.shells, arguments.welds, arguments.end * (1000.0 if arguments.study == "cards" else 1.0))
    print(f"{shells} shells, {points} spots")
    for title, command in (("nugget weld", ["weld", "points.csv", "body.k", "-o", "welded.k"]),
                           ("nugget check", ["check", "welded.k", "-o", "audit"])):
        start = time.perf_counter()
        done = subprocess.run([nugget, *command, "-j", str(arguments.threads)], cwd=work, capture_output=True, text=True)
        print(f"{title:<14}{time.perf_counter() - start:8.2f} s in all, exit code {done.returncode}")
        if done.returncode != 0:
            print(done.stderr[:2000])
            return 1
    log = (work / "audit" / "check.log").read_text(encoding="utf-8")
    print(re.search(r"Audit: .*", log)[0])
    print(re.search(r"Seconds: .*", log)[0])
    if arguments.study == "crash":
        crash(nugget, work, arguments.threads)
    elif arguments.study == "results":
        whole = lambda text: [int(word) for word in text.split(",")]
        results(programs, work, arguments.threads, whole(arguments.ranks), whole(arguments.cycles)[0])
    elif arguments.study == "cards":
        cards(programs, work, arguments.threads, arguments.end)
    elif arguments.study == "modes":
        modes(nugget, work, arguments.threads, arguments.modes)
    return 0


if __name__ == "__main__":
    sys.exit(main())
