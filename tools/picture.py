# SPDX-License-Identifier: Apache-2.0
"""Draws the last state of a d3plot family as an SVG: shells and the skin of bricks coloured by plastic strain,
welds as dots, failed ones red.

    tools/picture.py FOLDER PICTURE.svg [--view X,Y,Z] [--up X,Y,Z] [--width PIXELS]

Needs numpy. Reads the subset of the d3plot format that nugget writes (docs/manual/results.md).
"""
import argparse
import pathlib

import numpy as np


FACES = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))  # of a brick, outward


def skin(solids, alive):
    """The faces that one living brick alone has, and the brick of each."""
    faces, owner = {}, {}
    for e in np.flatnonzero(alive):
        for face in FACES:
            nodes = [solids[e][c] for c in face]
            key = tuple(sorted(set(nodes)))
            if len(key) < 3:
                continue
            faces[key] = None if key in faces else nodes
            owner[key] = e
    kept = [k for k, nodes in faces.items() if nodes is not None]
    return np.array([faces[k] for k in kept], int).reshape(-1, 4), np.array([owner[k] for k in kept], int)


def states(folder, files=slice(None)):
    """Of each state in these files of the family: coordinates; facets of living shells and of the skin of bricks, with their plastic strain;
    beams, which of them live; time."""
    words = np.fromfile(folder / "d3plot", dtype="<i4")
    numnp, nglbv, nel8, nv3d = words[16], words[18], words[23], words[27]
    nel2, nv1d, nel4, nv2d = words[28], words[30], words[31], words[33]
    at = 64 + 3 * numnp
    solids = words[at:at + 9 * nel8].reshape(-1, 9)[:, :8] - 1
    at += 9 * nel8
    beams = words[at:at + 6 * nel2].reshape(-1, 6)[:, :2] - 1
    at += 6 * nel2
    shells = words[at:at + 5 * nel4].reshape(-1, 5)[:, :4] - 1
    size = 1 + nglbv + 9 * numnp + nel8 * nv3d + nel2 * nv1d + nel4 * nv2d + nel8 + nel4 + nel2
    known = None  # which bricks lived, and their skin
    for name in sorted(folder.glob("d3plot[0-9]*"), key=lambda p: (len(p.name), p.name))[files]:
        data = np.fromfile(name, dtype="<f4")
        for state in data[:data.size // size * size].reshape(-1, size):
            if state[0] == -999999.0:
                break
            x = state[1 + nglbv:1 + nglbv + 3 * numnp].reshape(-1, 3).astype(float)
            at = 1 + nglbv + 9 * numnp
            solid_strain = state[at:at + nel8 * nv3d].reshape(nel8, nv3d)[:, 6] if nel8 else np.zeros(0)
            at += nel8 * nv3d + nel2 * nv1d
            strain = state[at:at + nel4 * nv2d].reshape(nel4, nv2d)[:, [6, 13, 20]].max(axis=1) if nel4 else np.zeros(0)
            at += nel4 * nv2d
            bricks = state[at:at + nel8] != 0
            if known is None or not np.array_equal(known[0], bricks):
                known = bricks, *skin(solids, bricks)
            faces, owner = known[1:]
            at += nel8
            alive = state[at:at + nel4] != 0
            at += nel4
            yield (x, np.concatenate([shells[alive].reshape(-1, 4), faces]), np.concatenate([strain[alive], solid_strain[owner]]), beams,
                   state[at:at + nel2] != 0, float(state[0]))


def read(folder, first=False):
    """The last state, or the first one, without its time."""
    one_file = list(states(folder, slice(1) if first else slice(-1, None)))
    return one_file[0 if first else -1][:5]


def colour(share):
    stops = np.array([[196, 205, 214], [94, 148, 190], [120, 190, 120], [250, 200, 60], [214, 62, 42]], float)
    place = share * (len(stops) - 1)
    i = min(int(place), len(stops) - 2)
    return stops[i] + (place - i) * (stops[i + 1] - stops[i])


def visible(p, shells, order, width, height):
    """Those of `order` (back to front) that cover a pixel of the finished picture."""
    owner = np.full((height, width), -1)
    for e in order:
        q = p[shells[e]]
        low = np.maximum(np.floor(q.min(axis=0)).astype(int), 0)
        high = np.minimum(np.ceil(q.max(axis=0)).astype(int) + 1, [width, height])
        u, v = np.meshgrid(np.arange(low[0], high[0]), np.arange(low[1], high[1]))
        side = [(b[0] - a[0]) * (v - a[1]) - (b[1] - a[1]) * (u - a[0]) for a, b in zip(q, np.roll(q, -1, axis=0))]
        inside = np.all(np.array(side) >= -1.0, axis=0) | np.all(np.array(side) <= 1.0, axis=0)
        owner[low[1]:high[1], low[0]:high[0]][inside] = e
    seen = set(np.unique(owner).tolist())
    return [e for e in order if e in seen]


def draw(folder, width, view, up):
    x, shells, strain, beams, beam_alive = read(folder)
    towards = view / np.linalg.norm(view)
    right = np.cross(up, towards)
    right /= np.linalg.norm(right)
    top = np.cross(towards, right)
    p = np.stack([x @ right, -(x @ top)], axis=1)
    depth = x @ towards
    used = np.unique(shells)
    low, high = p[used].min(axis=0), p[used].max(axis=0)
    scale = (width - 40) / (high[0] - low[0])
    p = (p - low) * scale + 20
    height = int((high[1] - low[1]) * scale + 40)
    most = max(np.percentile(strain, 99), 1e-6)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}">',
           '<rect width="100%" height="100%" fill="#fff"/><g stroke="#0004" stroke-width=".3">']
    for e in visible(p, shells, np.argsort(depth[shells].mean(axis=1)), width, height):
        a, b = x[shells[e][2]] - x[shells[e][0]], x[shells[e][3]] - x[shells[e][1]]
        normal = np.cross(a, b)
        light = 0.55 + 0.45 * abs(normal @ (0.8 * towards + 0.6 * top)) / (np.linalg.norm(normal) or 1.0)
        r, g, b = (light * colour(min(strain[e] / most, 1.0))).astype(int) // 8 * 8
        q = np.round(p[shells[e]]).astype(int)
        steps = " ".join(f"{u} {v}" for u, v in np.diff(q, axis=0))
        out.append(f'<path fill="#{r:02x}{g:02x}{b:02x}" d="M{q[0][0]} {q[0][1]}l{steps}z"/>')
    out.append("</g>")
    for (i, j), alive in zip(beams, beam_alive):
        u, v = 0.5 * (p[i] + p[j])
        out.append(f'<circle cx="{u:.0f}" cy="{v:.0f}" r="4" fill="{"#123" if alive else "#e00"}" stroke="#fff"/>')
    return "\n".join(out + ["</svg>", ""])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("picture", type=pathlib.Path)
    parser.add_argument("--view", default="1,-0.35,0.55", help="direction from the model to the eye")
    parser.add_argument("--up", default="0,1,0")
    parser.add_argument("--width", type=int, default=1000)
    a = parser.parse_args()
    vector = lambda text: np.array([float(c) for c in text.split(",")])
    a.picture.write_text(draw(a.folder, a.width, vector(a.view), vector(a.up)), encoding="utf-8")


if __name__ == "__main__":
    main()
