# SPDX-License-Identifier: Apache-2.0
"""Reads the states of a d3plot family that nugget wrote (docs/manual/results.md): what the checks of tools/ and examples/ need of
them. `nugget picture` draws them. Needs numpy.
"""
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
