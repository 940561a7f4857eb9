# SPDX-License-Identifier: Apache-2.0
"""Writes a body-like model (500,000 shells, 5,000 welds) and times tie and audit on it.

    python3 bench/body.py [--nugget build/nugget] [--work build-bench/body] [--shells 500000] [--welds 5000] [--threads 1]

The body is a row of closed sills: each is a curved hat with flanges, and a floor strip under it, both of 5 mm elements; some
carry a third strip under one flange. Spots stand along the flanges, three elements wide; `nugget weld` places them, so that
the deck is one that a user could have made. What is timed is `nugget check` as its check.log tells it: reading, then tie and
audit together. Aim: under 5 s for tie and audit.
"""
import argparse
import math
import pathlib
import re
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
SIZE = 5.0                       # of an element
FLANGE, WALL, ROOF = 3, 10, 12   # elements across a flange, a wall, the roof of the hat
THICKNESS = {"hat": 1.2, "floor": 1.5, "third": 1.0}
CURVATURE = 4.0e-4               # of the sill's axis, 1/mm


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
    def __init__(self, path):
        self.file = open(path, "w", encoding="ascii")
        self.nodes, self.shells, self.node, self.shell, self.part = [], [], 0, 0, 0
        self.parts, self.points = [], []

    def sheet(self, kind, profile, length, origin):
        """Sweeps a profile along a curved axis."""
        self.part += 1
        self.parts.append((self.part, kind))
        first = self.node + 1
        for i in range(length + 1):
            x = SIZE * i
            lift = 0.5 * CURVATURE * (x - 0.5 * SIZE * length) ** 2
            for y, z in profile:
                self.node += 1
                self.nodes.append(f"{self.node:8d}{x + origin[0]:16.5f}{y + origin[1]:16.5f}{z + lift + origin[2]:16.5f}\n")
        across = len(profile)
        for i in range(length):
            for j in range(across - 1):
                a = first + i * across + j
                self.shell += 1
                self.shells.append(f"{self.shell:8d}{self.part:8d}{a:8d}{a + 1:8d}{a + 1 + across:8d}{a + across:8d}\n")

    def spots(self, count, length, y, z, origin):
        for k in range(count):
            x = SIZE * length * (k + 0.5) / count
            lift = 0.5 * CURVATURE * (x - 0.5 * SIZE * length) ** 2
            self.points.append((x + origin[0], y + origin[1], z + lift + origin[2]))

    def write(self):
        f = self.file
        f.write("*KEYWORD\n*TITLE\nbody-like bench of sills\n*CONTROL_TERMINATION\n     0.001\n*CONTROL_TIMESTEP\n       0.0       0.9\n"
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


def make(folder, shells, welds):
    """Writes body.k and points.csv; returns how many shells and points there are."""
    length = 250
    profile = hat_profile()
    floor = len(profile) - 1 - 2 * WALL
    sills = max(1, round(shells / (length * (len(profile) - 1 + floor + 0.25 * FLANGE))))
    per_flange = max(1, round(welds / (2 * sills)))
    body = Body(folder / "body.k")
    gap_floor = 0.5 * (THICKNESS["hat"] + THICKNESS["floor"])
    gap_third = gap_floor + 0.5 * (THICKNESS["floor"] + THICKNESS["third"])
    for sill in range(sills):
        origin = (1300.0 * (sill % 10), 250.0 * (sill // 10), 0.0)
        body.sheet("hat", profile, length, origin)
        body.sheet("floor", strip(floor, -gap_floor), length, origin)
        if sill % 4 == 0:
            body.sheet("third", strip(FLANGE, -gap_third), length, origin)
        for y in (0.5 * FLANGE * SIZE, (floor - 0.5 * FLANGE) * SIZE):
            body.spots(per_flange, length, y, -0.5 * gap_floor, origin)
    body.write()
    with open(folder / "points.csv", "w", encoding="ascii") as f:
        f.write("x,y,z\n")
        f.writelines(f"{x:.4f},{y:.4f},{z:.4f}\n" for x, y, z in body.points)
    return body.shell, len(body.points)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--nugget", type=pathlib.Path, default=ROOT / "build" / "nugget")
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build-bench" / "body")
    parser.add_argument("--shells", type=int, default=500_000)
    parser.add_argument("--welds", type=int, default=5_000)
    parser.add_argument("--threads", type=int, default=1)
    arguments = parser.parse_args()
    arguments.work.mkdir(parents=True, exist_ok=True)
    shells, points = make(arguments.work, arguments.shells, arguments.welds)
    print(f"{shells} shells, {points} spots")
    for title, command in (("nugget weld", ["weld", "points.csv", "body.k", "-o", "welded.k"]),
                           ("nugget check", ["check", "welded.k", "-o", "audit"])):
        start = time.perf_counter()
        done = subprocess.run([str(arguments.nugget.resolve()), *command, "-j", str(arguments.threads)], cwd=arguments.work,
                              capture_output=True, text=True)
        print(f"{title:<14}{time.perf_counter() - start:8.2f} s in all, exit code {done.returncode}")
        if done.returncode != 0:
            print(done.stderr[:2000])
            return 1
    log = (arguments.work / "audit" / "check.log").read_text(encoding="utf-8")
    print(re.search(r"Audit: .*", log)[0])
    print(re.search(r"Seconds: .*", log)[0])
    return 0


if __name__ == "__main__":
    sys.exit(main())
