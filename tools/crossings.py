# SPDX-License-Identifier: Apache-2.0
"""Counts the edges that pass through facets in the last state of a d3plot family: where a contact has let a node through.

    tools/crossings.py FOLDER [--first]

Facets are shells (in two triangles each) and the skin of bricks; an edge and a facet that share a node are left out, and
so are edges that only touch. --first looks at the first state, where a mesh may cross itself already. Needs numpy.
"""
import argparse
import pathlib

import numpy as np

import picture


def edges_of(facets):
    """Each edge once, as pairs of nodes."""
    pairs = np.concatenate([facets[:, [a, (a + 1) % 4]] for a in range(4)])
    pairs = np.sort(pairs[pairs[:, 0] != pairs[:, 1]], axis=1)
    return np.unique(pairs, axis=0)


def near(low_a, high_a, low_b, high_b, cell):
    """Pairs (a, b) of boxes that fall into one cell of a grid; b after b, a few thousand at a time."""
    place = lambda x: np.floor(x / cell).astype(int)
    bins = {}
    for i, (low, high) in enumerate(zip(place(low_a), place(high_a))):
        for key in np.ndindex(*(high - low + 1)):
            bins.setdefault(tuple(low + key), []).append(i)
    for j, (low, high) in enumerate(zip(place(low_b), place(high_b))):
        found = set()
        for key in np.ndindex(*(high - low + 1)):
            found.update(bins.get(tuple(low + key), ()))
        for i in found:
            if np.all(low_a[i] <= high_b[j]) and np.all(low_b[j] <= high_a[i]):
                yield i, j


def crossings(x, facets):
    """(edge, triangle) pairs that cross, as node numbers."""
    quads = facets[facets[:, 3] != facets[:, 2]]
    triangles = np.concatenate([facets[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    edges = edges_of(facets)
    a, b = x[edges[:, 0]], x[edges[:, 1]]
    t = x[triangles]
    cell = 2.0 * np.mean(np.linalg.norm(b - a, axis=1))
    pairs = np.array(list(near(np.minimum(a, b), np.maximum(a, b), t.min(axis=1), t.max(axis=1), cell)), int).reshape(-1, 2)
    e, f = edges[pairs[:, 0]], triangles[pairs[:, 1]]
    apart = np.all(e[:, :, None] != f[:, None, :], axis=(1, 2))
    pairs, e, f = pairs[apart], e[apart], f[apart]
    p, q, (u, v, w) = x[e[:, 0]], x[e[:, 1]], (x[f[:, k]] for k in range(3))
    volume = lambda k, l, m, n: np.einsum("ij,ij->i", np.cross(l - k, m - k), n - k)
    sides = volume(p, u, v, w) * volume(q, u, v, w) < 0.0
    turns = np.stack([volume(p, q, u, v), volume(p, q, v, w), volume(p, q, w, u)], axis=1)
    inside = np.all(turns > 0.0, axis=1) | np.all(turns < 0.0, axis=1)
    return e[sides & inside], f[sides & inside]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--first", action="store_true")
    a = parser.parse_args()
    x, facets = picture.read(a.folder, 0 if a.first else -1)[:2]
    edges, _ = crossings(x, facets)
    print(f"{len(edges)} crossings of edges and facets, {len(np.unique(edges, axis=0))} different edges of {len(edges_of(facets))}")


if __name__ == "__main__":
    main()
