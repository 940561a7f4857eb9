# SPDX-License-Identifier: Apache-2.0
"""Natural modes of a spot-welded hat and of a plate: nugget against CalculiX on the same mesh, in one run.

    python3 bench/modes.py [--nugget build/nugget] [--hat 0.005,0.0038,0.0017] [--plate 160x100,200x124] [--modes 30] [--ccx ccx]

The meshes come from ../shared/bench/gen_nvh.py. Prints seconds of processor time, memory and their ratios; both programs run
on one thread. The hat of nugget is free and held together by rigid bodies, that of CalculiX clamped and held by beams:
as much work, but not the same frequencies. Sizes are lists: a hat of 0.0038 has about 100,000 equations, one of 0.0017 about
500,000. `--ccx ""` leaves CalculiX out.
"""
import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
GENERATOR = ROOT.parent / "shared" / "bench" / "gen_nvh.py"


def measure(command, folder):
    """Processor seconds and peak memory in MB of a command."""
    with subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                          env=dict(os.environ, OMP_NUM_THREADS="1")) as process:
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        sys.exit(f"{' '.join(map(str, command))} failed")
    return used.ru_utime + used.ru_stime, used.ru_maxrss / 1024.0


def ask(folder, name, modes):
    """Puts another number of modes in the place of the generator's 30."""
    for file, before, after in ((f"{name}.k", f"*CONTROL_IMPLICIT_EIGENVALUE\n{30:10d}", f"*CONTROL_IMPLICIT_EIGENVALUE\n{modes:10d}"),
                                (f"{name}_s4.inp", "*FREQUENCY\n30", f"*FREQUENCY\n{modes}")):
        text = (folder / file).read_text(encoding="utf-8")
        if before not in text:
            sys.exit(f"{file}: no request for 30 modes")
        (folder / file).write_text(text.replace(before, after), encoding="utf-8")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--nugget", default=ROOT / "build" / "nugget", type=pathlib.Path)
    parser.add_argument("--ccx", default="ccx")
    parser.add_argument("--hat", default="0.005")
    parser.add_argument("--plate", default="160x100")
    parser.add_argument("--modes", type=int, default=30)
    arguments = parser.parse_args()
    if not GENERATOR.exists():
        sys.exit(f"{GENERATOR} is not there; nothing to measure")
    with tempfile.TemporaryDirectory() as folder:
        cases = [(f"hat {size}", ["weld", size]) for size in arguments.hat.split(",") if size]
        cases += [(f"plate {size}", ["plate", *size.split("x")]) for size in arguments.plate.split(",") if size]
        for title, words in cases:
            name = words[0]
            subprocess.run([sys.executable, GENERATOR, *words, name], cwd=folder, check=True, stdout=subprocess.DEVNULL)
            ask(pathlib.Path(folder), name, arguments.modes)
            ours = measure([arguments.nugget.resolve(), "run", f"{name}.k", "-o", name, "-j", "1", "--quiet"], folder)
            log = (pathlib.Path(folder) / name / "run.log").read_text(encoding="utf-8")
            equations = re.search(r"(\d+) equations", log)[1]
            print(f"{title:14} {equations:>7} equations  nugget {ours[0]:7.2f} s {ours[1]:6.0f} MB", end="", flush=True)
            if not arguments.ccx:
                print()
                continue
            theirs = measure([arguments.ccx, f"{name}_s4"], folder)
            print(f"   CalculiX {theirs[0]:7.2f} s {theirs[1]:6.0f} MB   "
                  f"ratios {theirs[0] / ours[0]:.1f} in time, {theirs[1] / ours[1]:.1f} in memory")


if __name__ == "__main__":
    main()
