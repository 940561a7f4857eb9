# SPDX-License-Identifier: Apache-2.0
"""What another mesh around the weld does to a coupon's stiffness: as meshed, with nodes moved, with elements divided.

    python3 examples/weld_place/adapted.py NUGGET FOLDER [SIZE ...]

The lap and peel coupons of study.py, seven places of the weld in its element, tied by the element under it: stiffness by linear
statics over that of solids, in percent, least to largest, as meshed, by `nugget weld --adapt`, by `--adapt --divide`; then the share
of the time step of the shells that is left, at least. A few minutes on two cores.
"""
import argparse
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from study import PLACES, SOLIDS, deck, run, stiffness  # noqa: E402

SIZES = (6.0, 8.0, 10.0, 14.0)
MESHES = {"as meshed": None, "moved": ["--adapt"], "divided": ["--adapt", "--divide"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("nugget", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("sizes", type=float, nargs="*", default=SIZES, metavar="SIZE")
    arguments = parser.parse_args()
    nugget, folder = arguments.nugget.resolve(), arguments.folder
    folder.mkdir(parents=True, exist_ok=True)
    for kind in ("lap", "peel"):
        for size in arguments.sizes:
            cells, steps = [], []
            for name, options in MESHES.items():
                found = []
                for number, place in enumerate(PLACES):
                    stem = f"{kind}_{size:g}_{number}"
                    path = folder / f"{stem}.k"
                    deck("book", kind, size, place, False).write(path)
                    if options:
                        changed = folder / f"{stem}_{name}.k"
                        done = subprocess.run([nugget, "weld", *options, path, "-o", changed], capture_output=True, text=True)
                        if done.returncode:
                            sys.exit(done.stderr)
                        now, was = re.search(r"time step ([\d.eE+-]+), was ([\d.eE+-]+)", done.stdout).groups()
                        steps.append((name, float(now) / float(was)))
                        path = changed
                    found.append(100.0 * stiffness(run(nugget, path, "segment")) / SOLIDS["book", kind][0])
                cells.append(f"{min(found):.0f} … {max(found):.0f}")
            left = [f"{min(s for n, s in steps if n == name):.2f}" for name, options in MESHES.items() if options]
            print(f"{kind} {size:g} mm | " + " | ".join(cells + left))


if __name__ == "__main__":
    main()
