# SPDX-License-Identifier: Apache-2.0
"""Draws histories over time as an SVG: columns of an ASCII file (rwforc, rcforc ...), or variables of a binout.

    tools/history.py FILE PICTURE.svg COLUMN[:NAME]... [--x TITLE] [--y TITLE] [--cfc CLASS [--second N]]
    tools/history.py FILE PICTURE.svg BRANCH/VARIABLE/NUMBER[:NAME]... [--x TITLE] [--y TITLE]

Columns count from 1; rows are the lines of numbers only, the first number being the time. NUMBER is the place among the
entities of a binout's branch, from 0. tools/binout.py lists branches and variables. --cfc 60, 180, 600 or 1000 filters as
SAE J211 says (tools/sae.py); --second is one second in the unit of the times (1000 for ms).
"""
import argparse
import pathlib

import binout
import sae

COLOURS = ("#1f5f99", "#c8501e", "#3c8c3c", "#7a4fa0")
WIDTH, HEIGHT, LEFT, BOTTOM = 720, 300, 70, 45


def from_binout(path, places):
    """A table as of an ASCII file: time and one column a place."""
    table = []
    for i, place in enumerate(places):
        branch, variable, number = place.rsplit("/", 2)
        for row, (time, values) in enumerate(binout.history(path, branch, variable)):
            if i == 0:
                table.append([time])
            table[row].append(values[int(number)])
    return table


def rows(path):
    for line in path.read_text(encoding="latin-1").splitlines():
        try:
            yield [float(word) for word in line.split()]
        except ValueError:
            continue


def ticks(low, high):
    """Round numbers from `low` to `high`, four to nine of them."""
    step = 10.0 ** len(str(int(high - low)))
    while (high - low) / step < 4:
        step /= 2.0 if f"{step:e}"[0] != "5" else 2.5
    count = int((high - low) / step + 1e-9)
    return [low + i * step for i in range(count + 1)]


def draw(table, columns, x_title, y_title):
    t = [row[0] for row in table]
    curves = [(name, [row[c - 1] for row in table]) for c, name in columns]
    low = min(0.0, min(min(y) for _, y in curves))
    high = max(max(y) for _, y in curves) or 1.0
    u = lambda a: LEFT + (WIDTH - LEFT - 15) * (a - t[0]) / (t[-1] - t[0])
    v = lambda b: 15 + (HEIGHT - BOTTOM - 15) * (high - b) / (high - low)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" font-family="sans-serif" '
           'font-size="12"><rect width="100%" height="100%" fill="#fff"/>']
    for a in ticks(t[0], t[-1]):
        out.append(f'<path d="M{u(a):.1f} {v(low):.1f}v5" stroke="#444"/><text x="{u(a):.1f}" y="{v(low) + 18:.1f}" text-anchor="middle">{a:g}</text>')
    for b in ticks(low, high):
        out.append(f'<path d="M{LEFT} {v(b):.1f}H{WIDTH - 15}" stroke="#ddd"/><text x="{LEFT - 6}" y="{v(b) + 4:.1f}" text-anchor="end">{b:g}</text>')
    for i, (name, y) in enumerate(curves):
        points = " ".join(f"{u(a):.1f},{v(b):.1f}" for a, b in zip(t, y))
        colour = COLOURS[i % len(COLOURS)]
        out.append(f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="1.2"/>')
        if name:
            out.append(f'<text x="{WIDTH - 20}" y="{30 + 16 * i}" text-anchor="end" fill="{colour}">{name}</text>')
    out.append(f'<text x="{(LEFT + WIDTH) / 2:.0f}" y="{HEIGHT - 8}" text-anchor="middle">{x_title}</text>'
               f'<text transform="translate(16 {(HEIGHT - BOTTOM) / 2:.0f}) rotate(-90)" text-anchor="middle">{y_title}</text></svg>')
    return "\n".join(out) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("file", type=pathlib.Path)
    parser.add_argument("picture", type=pathlib.Path)
    parser.add_argument("column", nargs="+")
    parser.add_argument("--x", default="time")
    parser.add_argument("--y", default="")
    parser.add_argument("--cfc", type=int, choices=sae.CLASSES)
    parser.add_argument("--second", type=float, default=1.0)
    a = parser.parse_args()
    asked = [c.partition(":")[::2] for c in a.column]
    if "/" in asked[0][0]:
        table = from_binout(a.file, [place for place, _ in asked])
        columns = [(i + 2, name) for i, (_, name) in enumerate(asked)]
    else:
        columns = [(int(c), name) for c, name in asked]
        table = [row for row in rows(a.file) if len(row) >= max(c for c, _ in columns)]
    if a.cfc:
        times = [row[0] for row in table]
        filtered = [sae.filtered(times, list(values), a.cfc, a.second) for values in list(zip(*table))[1:]]
        table = list(zip(filtered[0][0], *(values for _, values in filtered)))
        for c, name in columns:
            peak = max(table, key=lambda row: abs(row[c - 1]))
            print(f"{name or f'column {c}'}: peak {peak[c - 1]:.6g} at {peak[0]:.6g}, CFC {a.cfc}")
    table = table[::max(1, len(table) // 1000)]  # more points than pixels tell nothing
    a.picture.write_text(draw(table, columns, a.x, a.y), encoding="utf-8")


if __name__ == "__main__":
    main()
