# SPDX-License-Identifier: Apache-2.0
"""Measures what a cycle of one element costs, by kind, formulation, layers and law: the table of src/system/element_cost.cpp.

    python3 bench/element_costs.py [--nugget build/nugget] [--repeat 3] [NAME ...]

Each line is a run of one thread of some thousand elements in random motion, small enough for elastic strains or large enough for
plastic ones; printed are ns of the phase `elements` by element and cycle, the least of REPEAT runs. It has in it what nodes
cost to gather. Run nothing else meanwhile.
"""
import argparse
import json
import os
import pathlib
import random
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
ELASTIC = "*MAT_ELASTIC\n1,7.85e-9,2.1e5,0.3\n"
PLASTIC = "*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,7.85e-9,2.1e5,0.3,250.0,1000.0\n\n\n\n"
SIZE = 10.0


def sheet(elform, layers, triangles, n=80):
    number = lambda i, j: 1 + i + (n + 1) * j  # noqa: E731
    places = [(SIZE * i, SIZE * j, 0.0) for j in range(n + 1) for i in range(n + 1)]
    quads = [(number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)) for j in range(n) for i in range(n)]
    if triangles:
        quads = [t for a, b, c, d in quads for t in ((a, b, c, c), (a, c, d, d))]
    section = f"*SECTION_SHELL\n1,{elform},0.8333,{layers}\n1.0,1.0,1.0,1.0\n"
    return places, section, "*ELEMENT_SHELL\n" + "".join(f"{e},1,{','.join(map(str, q))}\n" for e, q in enumerate(quads, 1))


def block(elform, tetrahedra, n=16):
    number = lambda i, j, k: 1 + i + (n + 1) * (j + (n + 1) * k)  # noqa: E731
    places = [(SIZE * i, SIZE * j, SIZE * k) for k in range(n + 1) for j in range(n + 1) for i in range(n + 1)]
    corners = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
    cells = [[number(i + a, j + b, k + c) for a, b, c in corners] for k in range(n) for j in range(n) for i in range(n)]
    if tetrahedra:
        six = ((0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6))
        cells = [[c[t[0]], c[t[1]], c[t[2]], *5 * [c[t[3]]]] for c in cells for t in six]
    return places, f"*SECTION_SOLID\n1,{elform}\n", "*ELEMENT_SOLID\n" + "".join(f"{e},1,{','.join(map(str, c))}\n" for e, c in enumerate(cells, 1))


def thick_sheet(elform, layers, n=80):
    number = lambda i, j, k: 1 + i + (n + 1) * (j + (n + 1) * k)  # noqa: E731
    places = [(SIZE * i, SIZE * j, 2.0 * k) for k in (0, 1) for j in range(n + 1) for i in range(n + 1)]
    corners = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
    cells = [[number(i + a, j + b, c) for a, b, c in corners] for j in range(n) for i in range(n)]
    return places, f"*SECTION_TSHELL\n1,{elform},1.0,{layers}\n", "*ELEMENT_TSHELL\n" + "".join(f"{e},1,{','.join(map(str, c))}\n" for e, c in enumerate(cells, 1))


def rods(elform, n=4000):
    places = [(SIZE * i, 0.0, 0.0) for i in range(n + 1)] + [(0.0, 100.0, 0.0)]
    section = f"*SECTION_BEAM\n1,{elform}\n" + ("3.0,3.0,3.0,3.0\n" if elform == 1 else "10.0\n")
    return places, section, "*ELEMENT_BEAM\n" + "".join(f"{e},1,{e},{e + 1},{n + 2}\n" for e in range(1, n + 1))


KINDS = {f"shell {form}{' triangle' if tri else ''}, {layers} layers": (lambda f=form, la=layers, t=tri: sheet(f, la, t))
         for form, tri, layers in ((2, False, 3), (2, False, 5), (2, False, 9), (16, False, 3), (16, False, 5), (4, True, 3), (17, True, 3), (5, False, 1), (9, False, 1))}
KINDS |= {f"solid {form}": (lambda f=form, t=form in (10, 13, 4): block(f, t)) for form in (1, 2, -1, -2, 10, 13, 4)}
KINDS |= {f"thick shell {form}, {layers} layers": (lambda fo=form, la=layers: thick_sheet(fo, la)) for form in (3, 5) for layers in (2, 3, 5, 9)}
KINDS |= {f"beam {form}": (lambda f=form: rods(f)) for form in (1, 3)}


def deck(made, law, speed):
    places, section, elements = made
    draw = random.Random(1)
    text = "*KEYWORD\n*CONTROL_TERMINATION\n1.0\n*CONTROL_TIMESTEP\n0.0,0.5\n*PART\npart\n1,1,1\n" + section + law + "*NODE\n"
    text += "".join(f"{i},{x},{y},{z}\n" for i, (x, y, z) in enumerate(places, 1)) + elements + "*INITIAL_VELOCITY_NODE\n"
    return text + "".join(f"{i},{','.join(f'{speed * draw.uniform(-1, 1):.6g}' for _ in range(3))}\n" for i in range(1, len(places) + 1)) + "*END\n"


def measure(nugget, text, cycles, precision, repeat):
    """ns by element and cycle, of the phase of elements."""
    with tempfile.TemporaryDirectory() as folder:
        model = pathlib.Path(folder) / "model.k"
        model.write_text(text, encoding="ascii")
        least = float("inf")
        for _ in range(repeat):
            subprocess.run([nugget, "run", model, "-j", "1", "--max-cycles", str(cycles), "--precision", precision, "--quiet", "-o", folder], check=False,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env={**os.environ, "NUGGET_LANES": "4"})
            path = pathlib.Path(folder) / "summary.json"
            if not path.exists():
                return None
            summary = json.loads(path.read_text(encoding="utf-8"))
            elements = summary["elements"]
            count = sum(elements.values()) if isinstance(elements, dict) else elements
            least = min(least, 1e9 * summary["seconds"]["phases"]["elements"] / (count * summary["cycles"]))
        return least


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", help="parts of names, e.g. 'shell 2'")
    parser.add_argument("--nugget", default=ROOT / "build" / "nugget")
    parser.add_argument("--repeat", type=int, default=3)
    asked = parser.parse_args()
    print(f"{'ns by element and cycle':<28}{'elastic':>10}{'plastic':>10}{'single':>10}")
    for name, make in KINDS.items():
        if asked.names and not any(part in name for part in asked.names):
            continue
        made = make()
        found = [measure(asked.nugget, deck(made, law, speed), 100, precision, asked.repeat)
                 for law, speed, precision in ((ELASTIC, 1.0, "double"), (PLASTIC, 3.0e4, "double"), (PLASTIC, 3.0e4, "single"))]
        print(f"{name:<28}" + "".join(f"{f:>10.1f}" if f is not None else f"{'-':>10}" for f in found), flush=True)


if __name__ == "__main__":
    main()
