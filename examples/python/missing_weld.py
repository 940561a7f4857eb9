# SPDX-License-Identifier: Apache-2.0
"""What a weld does for the natural frequencies: with it, and without.

    python3 missing_weld.py MODEL.k FOLDER
"""
import sys

import nugget

model, folder = sys.argv[1:]
deck = nugget.read(model)
whole = nugget.modes(deck, directory=f"{folder}/whole", count=10).modes()
deck.remove_weld(int(deck.welds["id"][0]))
less = nugget.modes(deck.write(f"{folder}/less.k"), directory=f"{folder}/less", count=10).modes()
for number, (a, b) in enumerate(zip(whole.frequencies, less.frequencies), 1):
    print(f"mode {number}: {a:8.1f} Hz, {b:8.1f} Hz without it")
modes = range(1, len(whole) + 1)
nugget.plot({"all welds": (modes, whole.frequencies), "one missing": (modes, less.frequencies)}, abscissa="mode",
            ordinate="frequency [Hz]", points=("all welds", "one missing")).save(f"{folder}/missing_weld.svg")
