# SPDX-License-Identifier: Apache-2.0
"""Writes the decks of S. Bala's talk on deformable spot welds: what each of its figures shows.

    python3 examples/talk/make.py FOLDER

One file beside this for each figure has its decks, what the talk or a formula says of them, and how it is drawn; draw.py runs them all.
Units: mm, t, s, N, MPa.
"""
import importlib
import pathlib
import sys

TOPICS = ("thickness", "rigid", "torsion", "hourglass", "steps", "projections", "place", "forms", "meshes", "toyota")


def topics(names=()):
    return {name: importlib.import_module(name) for name in names or TOPICS}


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for topic in topics().values():
        for name, deck in topic.decks().items():
            deck.write(folder / f"{name}.k")
