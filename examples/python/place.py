# SPDX-License-Identifier: Apache-2.0
"""Places a second weld beside the one that a deck has, and moves the first.

    python3 place.py MODEL.k FOLDER
"""
import sys

import nugget

model, folder = sys.argv[1:]
deck = nugget.read(model)
first = deck.welds[int(deck.welds["id"][0])]
deck.move_weld(first["id"], (first["x"], first["y"] - 8.0, first["z"]))
moved = deck.write(f"{folder}/moved.k")
spot = {"x": first["x"], "y": first["y"] + 8.0, "z": first["z"], "diameter": first["diameter"]}
both = nugget.place_welds([spot], moved, f"{folder}/both.k")
for weld in both.welds.rows():
    print(f"weld {weld['id']} at y = {weld['y']:.1f}, tied: {weld['tied']}")
r = nugget.run(both, directory=f"{folder}/run", threads=2, until=1e-3)
r.picture(field="von_mises_stress").save(f"{folder}/place.svg")
