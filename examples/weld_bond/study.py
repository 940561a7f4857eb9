# SPDX-License-Identifier: Apache-2.0
"""Runs the decks of weld_bond and tabulates what welds, adhesive, and both are worth.

    python3 examples/weld_bond/study.py NUGGET FOLDER

Writes and runs the decks in FOLDER. Of the lap joint: stiffness between 2 and 6 kN; until the weld breaks, or to the end where there is none, the
highest force and the work; of the hat: its lowest frequencies. Then the same of the bonded lap joint by each law of adhesive.
"""
import json
import pathlib
import re
import subprocess
import sys

from make import JOINTS, LAP, LAWS

HERE = pathlib.Path(__file__).resolve().parent
LOW, HIGH = 2.0, 6.0  # kN


def forces(folder):
    """[(pull [mm], force [kN])] of spcforc while weld and tie hold; the pull is slow for a tenth of the time and even from then on."""
    welds = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["weld"]
    until = min((w["failure_time"] for w in welds if w["failed"]), default=LAP["end"])
    # Of a tie that has failed nothing is left but the vibration of the strips.
    if parted := re.search(r"failed, node \d+ first at time=\S+, the last at time=(\S+)", (folder / "run.log").read_text(encoding="utf-8")):
        until = min(until, float(parted[1]))
    points, time = [], None
    for line in (folder / "spcforc").read_text(encoding="ascii").splitlines():
        if found := re.search(r"output at time\s*=\s*(\S+)", line):
            time = float(found[1])
            if time > until:
                break
        elif (found := re.search(r"force resultants\s*=\s*(\S+)", line)) and time is not None:
            share = time / LAP["end"]
            pull = LAP["reach"] * (0.2 * share if share < 0.1 else 0.02 + (share - 0.1) / 0.9 * 0.98)
            points.append((pull, abs(float(found[1])) / 1000.0))
    return points


def stiffness(points):
    """Least squares of the rising branch [kN/mm]."""
    rise = []
    for pull, force in points:
        if force > HIGH:
            break
        if force >= LOW:
            rise.append((pull, force))
    n, x, y = len(rise), sum(p for p, _ in rise), sum(f for _, f in rise)
    return (n * sum(p * f for p, f in rise) - x * y) / (n * sum(p * p for p, _ in rise) - x * x)


def work(points):
    """[J]"""
    return sum(0.5 * (f + g) * (b - a) for (a, f), (b, g) in zip(points, points[1:]))


def main(nugget, folder):
    folder = pathlib.Path(folder)
    subprocess.run([sys.executable, str(HERE / "make.py"), str(folder)], check=True)
    print("           stiffness [kN/mm]  highest force [kN]   at [mm]   work [J]   lowest frequencies of the hat [Hz]")
    for joint in JOINTS:
        lap, hat = folder / f"lap_{joint}", folder / "modes" / f"hat_{joint}"
        subprocess.run([nugget, "run", f"{lap}.k", "-o", str(lap), "--quiet"], check=True, capture_output=True)
        subprocess.run([nugget, "modes", f"{hat}.k", "-o", str(hat), "--quiet"], check=True, capture_output=True)
        points = forces(lap)
        at, highest = max(points, key=lambda p: p[1])
        modes = json.loads((hat / "summary.json").read_text(encoding="utf-8"))["modes"]
        flexible = " ".join(f"{m['frequency_hz']:8.1f}" for m in modes[6:9])
        print(f"{joint:10s} {stiffness(points):18.1f} {highest:19.2f} {at:9.2f} {work(points):10.1f}   {flexible}")
    print("law")
    for law in LAWS:
        lap = folder / "laws" / f"lap_{law}"
        subprocess.run([nugget, "run", f"{lap}.k", "-o", str(lap), "--quiet"], check=True, capture_output=True)
        points = forces(lap)
        at, highest = max(points, key=lambda p: p[1])
        print(f"{law:10s} {stiffness(points):18.1f} {highest:19.2f} {at:9.2f} {work(points):10.1f}")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
