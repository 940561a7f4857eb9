#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Counts the edges that pass through facets in the last state of a d3plot family: where a contact has let something through.

    tools/crossings.py FOLDER [--first | --passed]

Facets are shells and the skin of bricks, bilinear as contact sees them; an edge and a facet that share a node are left out, and so are edges
that only touch. --first looks at the first state, where a mesh may cross itself already. --passed goes through all states and names the nodes
that went through a facet between one state and the next; edges that cross without one have passed other edges. Needs numpy.
"""
import argparse
import pathlib

try:
    import numpy as np
except ModuleNotFoundError:
    raise SystemExit("tools/crossings.py needs numpy: ./dev setup installs python3-numpy, for the system's own /usr/bin/python3")

import states


def edges_of(facets):
    """Each edge once, as pairs of nodes."""
    pairs = np.concatenate([facets[:, [a, (a + 1) % 4]] for a in range(4)])
    pairs = np.sort(pairs[pairs[:, 0] != pairs[:, 1]], axis=1)
    return np.unique(pairs, axis=0)


def near(low_a, high_a, low_b, high_b, most=4_000_000):
    """Pairs (a, b) of boxes that meet, about `most` candidates at a time: along the longest axis of all, from the lowest b that may reach a."""
    axis = np.argmax(high_b.max(axis=0) - low_b.min(axis=0))
    order = np.argsort(low_b[:, axis], kind="stable")
    starts = low_b[order, axis]
    begin = np.searchsorted(starts, low_a[:, axis] - np.max(high_b[:, axis] - low_b[:, axis]))
    count = np.maximum(np.searchsorted(starts, high_a[:, axis], side="right") - begin, 0)
    parts = np.searchsorted(np.cumsum(count), np.arange(most, count.sum() + most, most), side="right")
    for chosen in np.split(np.arange(len(low_a)), parts):
        n = count[chosen]
        a = np.repeat(chosen, n)
        b = order[np.repeat(begin[chosen] - np.cumsum(n) + n, n) + np.arange(n.sum())]
        meet = np.all((low_a[a] <= high_b[b]) & (low_b[b] <= high_a[a]), axis=1)
        yield a[meet], b[meet]


def crossings(x, facets):
    """(edge, facet) pairs that cross, as node numbers. A point of the facet on the edge's line: two bilinear equations, one quadratic
    (S. Ramsey, K. Potter, C. Hansen, Journal of Graphics Tools 9 (2004))."""
    edges = edges_of(facets)
    p, q, c = x[edges[:, 0]], x[edges[:, 1]], x[facets]
    found = [np.zeros((0, 2), int)]
    with np.errstate(divide="ignore", invalid="ignore"):
        for e, f in near(np.minimum(p, q), np.maximum(p, q), c.min(axis=1), c.max(axis=1)):
            apart = np.all(edges[e][:, :, None] != facets[f][:, None, :], axis=(1, 2))
            e, f = e[apart], f[apart]
            along = q[e] - p[e]
            length = np.einsum("ij,ij->i", along, along)
            least = np.eye(3)[np.argmin(np.abs(along), axis=1)]
            across = [np.cross(along, least)]
            across.append(np.cross(along, across[0]) / np.sqrt(length)[:, None])
            corner = [c[f, k] - p[e] for k in range(4)]
            # Along either direction across the edge: A uv + B u + C v + D = 0.
            (A, B, C, D), (A2, B2, C2, D2) = (
                [np.einsum("ij,ij->i", r, d) for r in (corner[0] - corner[1] + corner[2] - corner[3], corner[1] - corner[0],
                                                       corner[3] - corner[0], corner[0])] for d in across)
            square, linear, constant = A * C2 - A2 * C, A * D2 - A2 * D + B * C2 - B2 * C, B * D2 - B2 * D
            root = np.sqrt(linear**2 - 4.0 * square * constant)
            stable = -0.5 * (linear + np.where(linear < 0.0, -root, root))
            cross = np.zeros(len(e), bool)
            for v in (stable / square, constant / stable):
                one, other = A * v + B, A2 * v + B2
                u = -np.where(np.abs(one) > np.abs(other), (C * v + D) / one, (C2 * v + D2) / other)
                point = sum(w[:, None] * r for w, r in zip(((1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v), corner))
                share = np.einsum("ij,ij->i", point, along) / length
                cross |= (u > 0.0) & (u < 1.0) & (v > 0.0) & (v < 1.0) & (share > 0.0) & (share < 1.0)
            found.append(np.stack([e[cross], f[cross]], axis=1))
    pairs = np.concatenate(found)
    return edges[pairs[:, 0]], facets[pairs[:, 1]]


def feet(x, c, steps=12):
    """Where points x stand over the bilinear facets c: u and v, both in 0..1 on the facet, and the height above it."""
    u = np.full(len(x), 0.5)
    v = u.copy()
    for _ in range(steps):
        r = x - sum(w[:, None] * c[:, k] for k, w in enumerate(((1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v)))
        a = (1 - v)[:, None] * (c[:, 1] - c[:, 0]) + v[:, None] * (c[:, 2] - c[:, 3])
        b = (1 - u)[:, None] * (c[:, 3] - c[:, 0]) + u[:, None] * (c[:, 2] - c[:, 1])
        aa, ab, bb, ra, rb = (np.einsum("ij,ij->i", *pair) for pair in ((a, a), (a, b), (b, b), (r, a), (r, b)))
        size = aa * bb - ab * ab
        u = np.clip(u + (bb * ra - ab * rb) / size, -1.0, 2.0)
        v = np.clip(v + (aa * rb - ab * ra) / size, -1.0, 2.0)
    normal = np.cross(a, b)
    return u, v, np.einsum("ij,ij->i", r, normal) / np.linalg.norm(normal, axis=1)


def passed(before, after, facets):
    """(node, facet) pairs of which the node stands over the facet in both states, on the one side and then on the other."""
    nodes = np.unique(facets)
    found = [np.zeros((0, 5), int)]
    low, high = np.minimum(before, after), np.maximum(before, after)
    with np.errstate(divide="ignore", invalid="ignore"):
        for n, f in near(low[nodes], high[nodes], low[facets].min(axis=1), high[facets].max(axis=1)):
            n = nodes[n]
            other = np.all(facets[f] != n[:, None], axis=1)
            n, f = n[other], f[other]
            side = None
            for x in (before, after):
                u, v, height = feet(x[n], x[facets[f]])
                on = (u >= 0.0) & (u <= 1.0) & (v >= 0.0) & (v <= 1.0)
                n, f, was, side = n[on], f[on], side if side is None else side[on], height[on] > 0.0
            through = was != side
            found.append(np.concatenate([n[through, None], facets[f[through]]], axis=1))
    return np.concatenate(found)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    which = parser.add_mutually_exclusive_group()
    which.add_argument("--first", action="store_true")
    which.add_argument("--passed", action="store_true")
    a = parser.parse_args()
    if not a.passed:
        x, facets = states.read(a.folder, a.first)[:2]
        edges, _ = crossings(x, facets)
        print(f"{len(edges)} crossings of edges and facets, {len(np.unique(edges, axis=0))} different edges of {len(edges_of(facets))}")
        return
    before, count, events = None, 0, 0
    for x, facets, *_, time in states.states(a.folder):
        for node, *corners in passed(before, x, facets) if before is not None else ():
            events += 1
            print(f"by {time:g} the node in place {node + 1} has passed the facet of the nodes in places {', '.join(str(c + 1) for c in corners)}")
        before, count = x, count + 1
    print(f"{events} times a node passed a facet, in {count} states")


if __name__ == "__main__":
    main()
