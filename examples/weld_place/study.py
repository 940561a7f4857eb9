# SPDX-License-Identifier: Apache-2.0
"""How much of a weld's stiffness and strength depends on where it stands in the mesh, by each form of tie.

    python3 examples/weld_place/study.py NUGGET FOLDER [--bricks N] [COUPON [SIZE ...]]

A lap and a peel coupon, elements of 3 to 10 mm, seven places of the weld in its element, tied by the element under it, by area
and with a joint (--weld-tie area, joint): stiffness by linear statics, forces beyond yield by explicit runs, over those of solids
(solids.py, CalculiX); two materials and nuggets (solids.COUPONS). Writes FOLDER/place.csv and FOLDER/place.svg and prints a table.
--bricks 1, 4 or 8: welds of so many bricks in place of beams. Finished runs are not repeated; all take about an hour on two cores.
"""
import csv
import json
import math
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from solids import COUPONS, DISPLACEMENTS, MOVING, POISSON, PULL, REACH, YOUNG, extents  # noqa: E402
from writer import Deck  # noqa: E402

SIZES = (3.0, 5.0, 6.0, 8.0, 10.0)
# Share of an element by which the weld lies beyond a mesh line, along and across the sheets.
PLACES = ((0.5, 0.5), (0.25, 0.5), (0.5, 0.25), (0.25, 0.25), (0.0, 0.5), (0.5, 0.0), (0.0, 0.0))
FORMS = ("segment", "area", "joint")
COLOURS = ("#c33", "#16a", "#181")  # of the forms
DURATION = {"lap": 0.004, "peel": 0.012, "cross": 0.012, "three": 0.004, "through": 0.004}  # [s]
# By solids.py: stiffness of its finer mesh, N/mm; its forces at the displacements above, N.
SOLIDS = {
    ("book", "lap"): (61850.0, (5457.0, 7802.0, 8856.0)),
    ("book", "peel"): (766.0, (363.0, 574.0, 706.0)),
    ("mild", "lap"): (40130.0, (2732.0, 3773.0, 4441.0)),
    ("mild", "peel"): (223.0, (103.0, 163.0, 201.0)),
}


def mesh_lines(low, high, size, share):
    """From low to high, `size` apart about the weld at 0, which lies `share` of an element beyond a line."""
    count = math.ceil((high - low) / size) + 1
    inner = [(i - share) * size for i in range(-count, count)]
    return [low] + [x for x in inner if low + 0.4 * size < x < high - 0.4 * size] + [high]


UNLIKE = 1.4  # size of the elements of the second sheet over that of the others
SKEW = 0.2    # how far nodes inside are moved, in sizes


def mesh(kind, size, place, thickness, form="square"):
    """Nodes, shells, held nodes, pulled nodes. The weld is at the origin. `form`: square, unlike (the second sheet has larger elements, and
    the weld elsewhere in them) or skewed (nodes inside are moved by SKEW of the size)."""
    nodes, shells, held, pulled = {}, {}, [], []
    for sheet, (left, right, half) in enumerate(extents(kind)):
        own, share = (UNLIKE * size, (place[1] + 0.3, place[0] + 0.4)) if form == "unlike" and sheet == 1 else (size, place)
        # The cross's second sheet goes along y, and half is how far it goes there.
        along = mesh_lines(-left, right, own, share[0] % 1.0)
        across = mesh_lines(-half, half, own, share[1] % 1.0)
        number = lambda i, j: 10000 * (sheet + 1) + i * len(across) + j  # noqa: B023, E731
        for i, x in enumerate(along):
            for j, y in enumerate(across):
                inside = form == "skewed" and 0 < i < len(along) - 1 and 0 < j < len(across) - 1
                dx, dy = (SKEW * size * math.sin(7.0 * i + 12.0 * j + sheet), SKEW * size * math.cos(11.0 * i + 5.0 * j + sheet)) if inside else (0, 0)
                nodes[number(i, j)] = (x + dx, y + dy, (sheet - 0.5) * thickness)
        for i in range(len(along) - 1):
            for j in range(len(across) - 1):
                shells[len(shells) + 1] = (sheet + 1, (number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)))
        reach = REACH[kind] - 1e-6
        ends = [number(i, j) for i, x in enumerate(along) for j, y in enumerate(across) if max(abs(x), abs(y)) > reach]
        (pulled if sheet == MOVING[kind] else held).extend(ends)
    return nodes, shells, held, pulled


def deck(coupon, kind, size, place, plastic, bricks=0, form="square", strength=0.0):
    """`bricks`: 1, 4 or 8 in place of the weld beam. `strength`: force at which a weld fails, whatever its direction; 0: none."""
    thickness, diameter, first_yield, modulus = COUPONS[coupon]
    nodes, shells, held, pulled = mesh(kind, size, place, thickness, form)
    sheets = len(extents(kind))
    for sheet in range(sheets):
        nodes[7001 + sheet] = (0.0, 0.0, (sheet - 0.5) * thickness)
    duration, stroke = DURATION[kind], 1.05 * DISPLACEMENTS[kind][-1]
    d = Deck()
    d.keyword("KEYWORD")
    d.keyword("TITLE")
    d.text(f"{coupon}: {kind} coupon, {size:g} mm, weld {place[0]:g} and {place[1]:g} of an element beyond a mesh line")
    if not plastic:
        d.keyword("CONTROL_IMPLICIT_GENERAL")
        d.card(imflag=1, dt0=1.0)
        d.keyword("CONTROL_IMPLICIT_SOLUTION")
        d.card(nsolvr=1)
    d.keyword("CONTROL_TERMINATION")
    d.card(endtim=duration if plastic else 1.0)
    d.keyword("CONTROL_HOURGLASS")
    d.card(ihq=4, qh=0.01)
    d.keyword("CONTROL_ENERGY")
    d.card(hgen=2)
    d.keyword("CONTROL_SHELL")
    d.card(wrpang=20.0, esort=0, irnxx=-1, istupd=1 if plastic else 0)
    for pid in range(1, sheets + 1):
        d.part("sheet", pid=pid, secid=1, mid=1)
    d.keyword("SECTION_SHELL")
    d.card(secid=1, elform=2, shrf=0.8333, nip=5)
    d.card(t1=thickness, t2=thickness, t3=thickness, t4=thickness)
    if plastic:
        d.keyword("MAT_PIECEWISE_LINEAR_PLASTICITY")
        d.card(mid=1, ro=7.85e-9, e=YOUNG, pr=POISSON, sigy=first_yield, etan=YOUNG * modulus / (YOUNG + modulus))
        for _ in range(3):
            d.card(blank=None)
    else:
        d.keyword("MAT_ELASTIC")
        d.card(mid=1, ro=7.85e-9, e=YOUNG, pr=POISSON)
    d.part("weld", pid=9, secid=3, mid=3)
    d.keyword("SECTION_BEAM")
    d.card(secid=3, elform=9, shrf=1.0, qr=2, cst=1.0)
    d.card(ts1=diameter, ts2=diameter)
    d.keyword("MAT_SPOTWELD")
    d.card(mid=3, ro=7.85e-9, e=YOUNG, pr=POISSON, sigy=20000.0, eh=1000.0, dt=4.0e-7)
    d.card(efail=0.0, nrr=strength, nrs=strength, nrt=strength)
    if bricks:
        d.keyword("CONTROL_SPOTWELD_BEAM")
        d.card(lct=0, lcs=0, t_ort=0, prtflg=0, t_ors=0, rpbhx=bricks)
    d.keyword("SET_PART_LIST")
    d.card(sid=1)
    d.ids(range(1, sheets + 1))
    d.keyword("CONTACT_SPOTWELD")
    d.card(surfa=9, surfb=1, surfatyp=3, surfbtyp=2)
    d.card(fs=None)
    d.card(sfsa=None)
    d.node_set(1, held)
    d.node_set(2, pulled)
    free = [0 if dof == PULL[kind] else 1 for dof in (1, 2, 3)]
    d.keyword("BOUNDARY_SPC_SET")
    d.card(nsid=1, cid=0, dofx=1, dofy=1, dofz=1, dofrx=1, dofry=1, dofrz=1)
    d.card(nsid=2, cid=0, dofx=free[0], dofy=free[1], dofz=free[2], dofrx=1, dofry=1, dofrz=1)
    d.keyword("BOUNDARY_PRESCRIBED_MOTION_SET")
    d.card(nsid=2, dof=PULL[kind], vad=0 if plastic else 2, lcid=1, sf=stroke / (0.9 * duration) if plastic else 1.0e-3)
    if plastic:
        rise = [i / 20.0 for i in range(21)]
        d.curve(1, [(0.2 * duration * s, 0.5 - 0.5 * math.cos(math.pi * s)) for s in rise] + [(2.0 * duration, 1.0)])
        for name in ("SPCFORC", "NODOUT"):
            d.keyword("DATABASE_" + name)
            d.card(dt=duration / 400.0)
        d.keyword("DATABASE_HISTORY_NODE")
        d.ids([pulled[0]])
    else:
        d.curve(1, [(0.0, 0.0), (1.0, 1.0)])
    d.nodes(nodes)
    d.shells(shells)
    d.beams({7001 + k: (9, (7001 + k, 7002 + k)) for k in range(sheets - 1)})
    return d


def run(nugget, path, form):
    """The results' folder."""
    results = path.with_suffix("").parent / f"{path.stem}_{form}"
    if not (results / "summary.json").exists():
        command = [nugget, "run", path, "-o", results, "-j1", "--quiet"] + (["--weld-tie", form] if form != "segment" else [])
        done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
        if done.returncode:
            sys.exit(f"{path}: {done.stderr}")
    return results


def column(path, pattern):
    rows, time = {}, 0.0
    for line in path.read_text(encoding="ascii").splitlines():
        at = re.search(r"at time\s*=?\s*([-+.\dE]+)", line)
        found = re.search(pattern, line)
        if at:
            time = float(f"{float(at[1]):.4e}")
        elif found and time not in rows:
            rows[time] = float(found[1])
    return rows


def stiffness(results):
    energy = json.loads((results / "summary.json").read_text(encoding="utf-8"))["energy"]["internal"]
    return 2.0 * energy / 1.0e-3 ** 2


def forces(kind, results):
    """At DISPLACEMENTS, the mean over a tenth of each to either side: a straight line through the points there."""
    number = r"\s*([-+]?\d\.\d+E[-+]\d+)"
    skip = r"(?:\s*[-+]?\d\.\d+E[-+]\d+)" + "{%d}" % (PULL[kind] - 1)
    reaction = column(results / "spcforc", r"force\s+resultants?\s*=?" + skip + number)
    grip = column(results / "nodout", r"^\s*\d+" + skip + number)
    found = []
    for at in DISPLACEMENTS[kind]:
        near = [(grip[t] - at, abs(reaction[t])) for t in reaction.keys() & grip.keys() if abs(grip[t] - at) < 0.1 * at]
        mean_u, mean_f = (sum(p[i] for p in near) / len(near) for i in (0, 1))
        slope = sum((u - mean_u) * (f - mean_f) for u, f in near) / sum((u - mean_u) ** 2 for u, _ in near)
        found.append(mean_f - slope * mean_u)
    return found


def study(nugget, folder, coupons, sizes, bricks):
    for coupon in coupons:
        for kind in ("lap", "peel"):
            for plastic in (False, True):
                for size in sizes:
                    for number, place in enumerate(PLACES):
                        welds = f"_{bricks}_bricks" if bricks else ""
                        path = folder / f"{coupon}_{kind}_{'plastic' if plastic else 'elastic'}_{size:g}_{number}{welds}.k"
                        deck(coupon, kind, size, place, plastic, bricks).write(path)
                        for form in FORMS:
                            results = run(nugget, path, form)
                            values = forces(kind, results) if plastic else [stiffness(results)]
                            names = [f"force at {u:g} mm" for u in DISPLACEMENTS[kind]] if plastic else ["stiffness"]
                            solids = SOLIDS[coupon, kind][1] if plastic else [SOLIDS[coupon, kind][0]]
                            for name, value, reference in zip(names, values, solids):
                                yield {"coupon": coupon, "kind": kind, "what": name, "size": size, "along": place[0], "across": place[1],
                                       "form": form, "value": value, "over_solids": value / reference}


def panels_of(rows):
    return list(dict.fromkeys((r["coupon"], r["kind"], r["what"]) for r in rows))


def table(rows):
    sizes = sorted({r["size"] for r in rows})
    print(f"{'':42}" + "".join(f"{size:g} mm".rjust(14) for size in sizes))
    for panel in panels_of(rows):
        for form in FORMS:
            cells = []
            for size in sizes:
                over = [100.0 * r["over_solids"] for r in rows
                        if (r["coupon"], r["kind"], r["what"]) == panel and (r["form"], r["size"]) == (form, size)]
                cells.append(f"{min(over):.0f} .. {max(over):.0f}" if over else "")
            if any(cells):
                print(f"{', '.join((*panel, form)):42}" + "".join(c.rjust(14) for c in cells))


def draw(rows, path):
    """Points over the size of the elements, a panel for each quantity; plain SVG."""
    width, height, left, top, columns = 250, 150, 46, 26, 4
    panels = panels_of(rows)
    lines = (len(panels) + columns - 1) // columns * (height + 54)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{columns * (width + left)}" height="{lines + 20}" '
           'font-family="sans-serif" font-size="11">', '<rect width="100%" height="100%" fill="white"/>']
    for p, (coupon, kind, what) in enumerate(panels):
        x0, y0 = left + (p % columns) * (width + left), top + (p // columns) * (height + 54)
        most = 2.4
        place = lambda size, over: (x0 + (size - 2.5) / 8.0 * (width - 20), y0 + height * (1.0 - min(over, most) / most))  # noqa: B023, E731
        out.append(f'<text x="{x0}" y="{y0 - 8}">{coupon}, {kind}: {what}, over that of solids</text>')
        for level in (0.0, 0.5, 1.0, 1.5, 2.0):
            y = place(3, level)[1]
            out.append(f'<line x1="{x0}" x2="{x0 + width - 20}" y1="{y:.1f}" y2="{y:.1f}" stroke="{"#444" if level == 1.0 else "#ddd"}"/>')
            out.append(f'<text x="{x0 - 26}" y="{y + 4:.1f}">{level:.1f}</text>')
        for size in sorted({r["size"] for r in rows}):
            out.append(f'<text x="{place(size, 0)[0] - 4:.1f}" y="{y0 + height + 14}">{size:g}</text>')
        for form, colour, shift in zip(FORMS, COLOURS, (-0.16, 0.0, 0.16)):
            for r in rows:
                if (r["coupon"], r["kind"], r["what"], r["form"]) == (coupon, kind, what, form):
                    x, y = place(r["size"] + shift, r["over_solids"])
                    out.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.4" fill="{colour}" fill-opacity="0.6"/>')
        out.append(f'<text x="{x0 + 60}" y="{y0 + height + 28}">size of the elements, mm</text>')
    words = ("tied by the element under the weld", "by area", "by area, with a joint; a dot for each of seven places")
    for i, (text, colour) in enumerate(zip(words, COLOURS)):
        out.append(f'<text x="{left + (0, 240, 320)[i]}" y="{lines + 10}" fill="{colour}">{text}</text>')
    path.write_text("\n".join(out + ["</svg>", ""]), encoding="utf-8")


def main(nugget, folder, *options):
    bricks = int(options[1]) if options[:1] == ("--bricks",) else 0
    coupon, *sizes = options[2 if bricks else 0:] or ("",)
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    rows = list(study(nugget, folder, [coupon] if coupon else COUPONS, [float(s) for s in sizes] or SIZES, bricks))
    with open(folder / f"place{coupon}.csv", "w", encoding="ascii", newline="") as file:
        writer = csv.DictWriter(file, rows[0].keys())
        writer.writeheader()
        writer.writerows(rows)
    table(rows)
    draw(rows, folder / f"place{coupon}.svg")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
