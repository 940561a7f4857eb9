# SPDX-License-Identifier: Apache-2.0
"""The welds of a deck before anything runs: findings, and how far each weld is from the edge of its sheets.

    python3 audit.py MODEL.k FOLDER
"""
import sys

import nugget

model, folder = sys.argv[1:]
deck = nugget.read(model)
print(deck)
for finding in deck.findings:
    print(finding)
welds = deck.welds
for weld in welds.rows():
    print(f"weld {weld['id']}: d = {weld['diameter']}, parts {weld['parts']}, "
          f"edge distance {weld['edge_distance']:.1f}")
nugget.plot({"edge distance": (welds["z"], welds["edge_distance"]), "diameter": (welds["z"], welds["diameter"])},
            points=("edge distance",), abscissa="z [mm]", ordinate="[mm]").save(f"{folder}/audit.svg")
