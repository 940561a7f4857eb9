#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What single precision does to answers: the tables of docs/evidence/precision.md.

    tools/precision.py cases TEST_VERIFY [FILTER]     every verification case in both precisions, its error beside its gate
    tools/precision.py decks NUGGET FOLDER [NAME...]  public decks (../shared/decks) to their ends
    tools/precision.py car6 NUGGET FOLDER [RUNS]      RUNS (6) of car6 in each, its bumper 3 mm thick to within 0.3 um
    tools/precision.py rest NUGGET FOLDER             200,000 cycles of a loaded model at rest
    tools/precision.py slow NUGGET FOLDER             a shell and a brick that are stretched in up to 4,000,000 cycles

FOLDER takes the results; a run that is there already is not repeated. decks and car6 need numpy.
"""
import collections
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import binout

ROOT = pathlib.Path(__file__).resolve().parents[1]
SHARED = ROOT.parent / "shared" / "decks"
PRECISIONS = ("double", "single")


def run(nugget, deck, folder, precision):
    """summary.json of a run of one thread."""
    if not (folder / "summary.json").exists():
        subprocess.run([nugget, "run", deck, "-o", folder, "-j1", "--quiet", "--precision", precision], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return json.loads((folder / "summary.json").read_text(encoding="utf-8"))


# ---- verification


def rows_and_failures(test_verify, precision, pattern):
    """{(case, what, which of these): (error, gate)}, and the tests that fail."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "rows"
        environment = {**os.environ, "NUGGET_VERIFICATION_ROWS": str(path), "NUGGET_PRECISION": precision}
        said = subprocess.run([test_verify, f"--gtest_filter={pattern}", "--gtest_brief=1"], env=environment, capture_output=True, text=True).stdout
        found, count = {}, collections.Counter()
        for line in path.read_text(encoding="utf-8").splitlines():
            case, what, _, _, error, gate = line.split("\t")
            count[case, what] += 1
            found[case, what, count[case, what]] = (float(error), float(gate))
        return found, sorted(set(re.findall(r"\[  FAILED  \] (\w+\.\w+)", said)))


def cases(test_verify, pattern="*"):
    double, failed_double = rows_and_failures(test_verify, "double", pattern)
    single, failed_single = rows_and_failures(test_verify, "single", pattern)
    changed = {key for key in double if key in single and single[key] != double[key]}
    print(f"{len(double)} values, of which {len(changed)} differ; {sum(e > g for e, g in double.values())} outside their gates in double precision, "
          f"{sum(e > g for e, g in single.values())} in single.\n")
    print("| case | values that differ | largest error over gate: double | single |\n|---|---|---|---|")
    for case in sorted({key[0] for key in changed}):
        keys = [key for key in changed if key[0] == case]
        worst = [max(of[key][0] / max(of[key][1], 1e-300) for key in keys) for of in (double, single)]
        print(f"| {case} | {len(keys)} | {worst[0]:.2g} | {worst[1]:.2g} |")
    print("\n| outside its gate in single precision | error: double | single | gate |\n|---|---|---|---|")
    for key, (error, gate) in single.items():
        if error > gate:
            print(f"| {key[0]}: {key[1]} | {100 * double[key][0]:.2g} % | {100 * error:.2g} % | {100 * gate:.2g} % |")
    for name in failed_single:
        print(f"- fails{' in double precision, too' if name in failed_double else ''}: {name}")


# ---- public decks


def public_decks(nugget, folder, *names):
    import decks
    of = {name: deck for name, (deck, _) in decks.DECKS.items()}
    of |= {"car6": "car6/main_v223.k", "single_hex": "single_hex/single_hex_tension.k"}
    print("| deck | precision | elements in single | cycles | energy ratio | kinetic | internal | hourglass | solution [s] |\n|---|---|---|---|---|---|---|---|---|")
    for name, deck in of.items():
        if names and name not in names:
            continue
        for precision in PRECISIONS:
            s = run(nugget, SHARED / deck, pathlib.Path(folder) / f"{name}_{precision}", precision)
            e, elements = s["energy"], sum(s["elements"].values())
            print(f"| {name} | {precision} | {s.get('elements_by_precision', {}).get('single', 0):,} of {elements:,} | {s['cycles']:,} | {e['ratio']:.7f} | "
                  f"{e['kinetic']:.6g} | {e['internal']:.6g} | {e['hourglass']:.4g} | {s['seconds']['solve']:.1f} |", flush=True)


def car6(nugget, folder, runs="6"):
    sys.path.insert(0, str(ROOT / "bench"))
    import car6_designs as designs
    import numpy
    count, results = int(runs), {}
    for precision in PRECISIONS:
        results[precision] = []
        for i in range(count):
            thickness = 3.0 + 6e-4 * (i / max(1, count - 1) - 0.5)
            here = pathlib.Path(folder) / f"{precision}{i}"
            if not (here / "summary.json").exists():
                deck = designs.write_deck(here, SHARED / "car6", {**designs.BASE, "tbumper": thickness})
                run(nugget, deck, here, precision)
            results[precision].append(designs.results_of(here))
    names = ("largest force, one sample [N]", "displacement [mm]", "velocity [mm/s]", "internal energy [N mm]", "largest force, three samples [N]")
    print("| quantity | double: mean ± deviation | single: mean ± deviation | single less double, in standard errors |\n|---|---|---|---|")
    for k, name in enumerate(names):
        of = [numpy.array([r[k] for r in results[p]]) for p in PRECISIONS]
        error = numpy.sqrt(sum(values.var(ddof=1) / count for values in of))
        print(f"| {name} | {of[0].mean():.6g} ± {of[0].std(ddof=1):.2g} | {of[1].mean():.6g} ± {of[1].std(ddof=1):.2g} | {(of[1].mean() - of[0].mean()) / error:+.1f} |")


# ---- at rest


def lines(rows):
    return "".join(",".join(f"{value:.10g}" if isinstance(value, float) else str(value) for value in row) + "\n" for row in rows)


class Cantilever:
    """Elements along x, held at x = 0: shells of 5 x 5 x 1, or bricks of 5 x 5 x 5, of steel (mm, t, s)."""

    def __init__(self, part, first, length, across, high=0):
        self.part, self.first, self.length, self.across, self.high = part, first, length, across, high
        y = 100.0 * part
        self.nodes = [(self.node(i, j, k), 5.0 * i, y + 5.0 * j, 5.0 * k) for k in range(high + 1) for j in range(across + 1) for i in range(length + 1)]
        ring = ((0, 0), (1, 0), (1, 1), (0, 1))
        layers = range(high) if high else (0,)
        self.elements = [(first + e, part, *(self.node(i + a, j + b, k + c) for c in ((0, 1) if high else (0,)) for a, b in ring))
                         for e, (k, j, i) in enumerate((k, j, i) for k in layers for j in range(across) for i in range(length))]

    def node(self, i, j, k):
        return self.first + i + (self.length + 1) * (j + (self.across + 1) * k)

    def held(self):
        return [n for n, x, _, _ in self.nodes if x == 0.0]

    def tip(self):
        return self.node(self.length, self.across // 2, self.high // 2)

    def text(self, section):
        kind = "SOLID" if self.high else "SHELL"
        return "".join([f"*PART\ncantilever {self.part}\n{self.part},{self.part},1,,{self.part}\n", section,
                        "*NODE\n", lines(self.nodes), f"*ELEMENT_{kind}\n", lines(self.elements)])


PERIOD = 0.0121  # of the sheet's first mode, rho L^4 / E t^2
STEP = 6.5e-7
REST = (4.0 * PERIOD, 4.0 * PERIOD + 200000 * STEP)


def at_rest(damped):
    """Two sheets and a bar, held at one end, under forty times their weight; damped until they rest, and to the end or no longer."""
    parts = [Cantilever(1, 1001, 20, 4), Cantilever(2, 2001, 20, 4), Cantilever(3, 3001, 12, 2, 2)]
    shell = "*SECTION_SHELL\n{0},{1},0.8333,3\n1.,1.,1.,1.\n*HOURGLASS\n{0},{2},0.05\n"
    sections = [shell.format(1, 2, 4), shell.format(2, 16, 4), "*SECTION_SOLID\n3,1\n*HOURGLASS\n3,6,1.0\n"]
    end = 1000.0 if damped else 0.0
    return "".join([
        f"*KEYWORD\n*CONTROL_TERMINATION\n{REST[1]:.8g}\n*CONTROL_ENERGY\n2\n*CONTROL_TIMESTEP\n0.,0.9,,,,1\n*DEFINE_CURVE\n1\n0.,{STEP}\n1.,{STEP}\n",
        f"*DATABASE_GLSTAT\n{PERIOD / 50:.6g},2\n*DATABASE_NODOUT\n{PERIOD / 50:.6g},2\n*DATABASE_HISTORY_NODE\n", ",".join(str(p.tip()) for p in parts) + "\n",
        "*MAT_ELASTIC\n1,7.85e-9,2.1e5,0.3\n", *(p.text(s) for p, s in zip(parts, sections)),
        "*SET_NODE_LIST\n1\n", *(",".join(map(str, p.held()[i:i + 8])) + "\n" for p in parts for i in range(0, len(p.held()), 8)),
        "*BOUNDARY_SPC_SET\n1,0,1,1,1,1,1,1\n",
        f"*LOAD_BODY_Z\n2\n*DEFINE_CURVE\n2\n0.,0.\n{PERIOD:.6g},3.9e5\n1.,3.9e5\n",
        f"*DAMPING_GLOBAL\n3\n*DEFINE_CURVE\n3\n0.,1000.\n{REST[0] - 0.2 * PERIOD:.6g},1000.\n{REST[0]:.6g},{end}\n1.,{end}\n", "*END\n"])


def rest(nugget, folder):
    pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
    print("| damping | precision | cycles at rest | deflection and its range [mm]: ELFORM 2 | ELFORM 16 | bricks | kinetic over internal energy, at most | energy ratio |\n"
          "|---|---|---|---|---|---|---|---|")
    for damped in (True, False):
        deck = pathlib.Path(folder) / f"rest{'_damped' * damped}.k"
        deck.write_text(at_rest(damped), encoding="ascii")
        for precision in PRECISIONS:
            out = deck.with_suffix(f".{precision}")
            s = run(nugget, deck, out, precision)
            file = out / "binout0000"
            kinetic, internal = ([v[0] for t, v in binout.history(file, "glstat", name) if t >= REST[0]] for name in ("kinetic_energy", "internal_energy"))
            z = [v for t, v in binout.history(file, "nodout", "z_displacement") if t >= REST[0]]
            tips = [f"{values[0]:.6g}, {max(values) - min(values):.2g}" for values in zip(*z)]
            cycles = round(s["cycles"] * (REST[1] - REST[0]) / REST[1])
            print(f"| {'kept' if damped else 'off'} | {precision} | {cycles:,} | {' | '.join(tips)} | {max(k / i for k, i in zip(kinetic, internal)):.2g} | "
                  f"{s['energy']['ratio']:.7f} |", flush=True)


# ---- slowly


def stretched(cycles):
    """A shell and a brick of 1 mm, stretched evenly to 200 MPa in so many cycles."""
    time = cycles * 1e-7
    cube = [(10 + a + 4 * k, float(x), float(y), float(k)) for k in (0, 1) for a, (x, y) in enumerate(((0, 0), (1, 0), (1, 1), (0, 1)))]
    sheet = [(n - 9, x, y, 5.0) for n, x, y, z in cube if z == 0.0]
    speed = 200.0 / 2.1e5 / time
    return "".join([
        f"*KEYWORD\n*CONTROL_TERMINATION\n{time:.10g}\n*CONTROL_TIMESTEP\n0.,0.9,,,,3\n*DEFINE_CURVE\n3\n0.,1e-7\n{10 * time:.10g},1e-7\n",
        f"*DATABASE_ELOUT\n{time / 10:.10g},2\n*DATABASE_HISTORY_SHELL\n1\n*DATABASE_HISTORY_SOLID\n2\n",
        "*MAT_ELASTIC\n1,7.85e-9,2.1e5,0.0\n*SECTION_SHELL\n1,2,0.8333,2\n1.,1.,1.,1.\n*SECTION_SOLID\n2,1\n*PART\nsheet\n1,1,1\n*PART\nbrick\n2,2,1\n",
        "*NODE\n", lines(sheet + cube), "*ELEMENT_SHELL\n1,1,1,2,3,4\n*ELEMENT_SOLID\n2,2,10,11,12,13,14,15,16,17\n",
        "*SET_NODE_LIST\n1\n1,4,10,13,14,17\n*BOUNDARY_SPC_SET\n1,0,1,1,1,1,1,1\n*SET_NODE_LIST\n2\n2,3,11,12,15,16\n*BOUNDARY_SPC_SET\n2,0,0,1,1,1,1,1\n",
        f"*BOUNDARY_PRESCRIBED_MOTION_SET\n2,1,0,4\n*DEFINE_CURVE\n4\n0.,{speed:.10g}\n{10 * time:.10g},{speed:.10g}\n*END\n"])


def slow(nugget, folder):
    pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
    print("| cycles to 200 MPa | strain a cycle | shell: stress, double | single | brick: stress, double | single |\n|---|---|---|---|---|---|")
    for cycles in (10000, 100000, 400000, 1000000, 4000000):
        deck = pathlib.Path(folder) / f"slow{cycles}.k"
        deck.write_text(stretched(cycles), encoding="ascii")
        ends = []
        for precision in PRECISIONS:
            out = deck.with_suffix(f".{precision}")
            run(nugget, deck, out, precision)
            found = binout.variables(out / "binout0000")
            last = max(key.split("/")[3] for key in found if key.startswith("/elout/shell/d"))
            ends.append((found[f"/elout/shell/{last}/sig_xx"][0], found[f"/elout/solid/{last}/sig_xx"][0]))
        (shell, brick), (shell_single, brick_single) = ends
        print(f"| {cycles:,} | {200.0 / 2.1e5 / cycles:.1e} | {shell:.6g} | {shell_single:.6g} ({100 * (shell_single / shell - 1):+.1g} %) | "
              f"{brick:.6g} | {brick_single:.6g} ({100 * (brick_single / brick - 1):+.1g} %) |", flush=True)


TABLES = {"cases": cases, "decks": public_decks, "car6": car6, "rest": rest, "slow": slow}

if __name__ == "__main__":
    if len(sys.argv) < 3 or sys.argv[1] not in TABLES:
        sys.exit(__doc__)
    TABLES[sys.argv[1]](*sys.argv[2:])
