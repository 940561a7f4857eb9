# SPDX-License-Identifier: Apache-2.0
"""Two runs in one plot: the deck as it is, and with welds of half the strength.

    python3 stronger.py MODEL.k FOLDER
"""
import sys

import nugget

model, folder = sys.argv[1:]
deck = nugget.read(model)
before = nugget.run(deck, directory=f"{folder}/before", threads=2)
for weld in deck.cards("MAT_SPOTWELD"):
    for strength in ("nrr", "nrs", "nrt"):
        weld[strength] = 0.5 * weld[strength]
weaker = deck.write(f"{folder}/weaker.k")
after = nugget.run(weaker, directory=f"{folder}/after", threads=2)
print(f"failure time {before.welds['failure_time']} with all, {after.welds['failure_time']} with half of the strength")
before.plot("swforc/*/shear", other=after).save(f"{folder}/stronger.svg")
