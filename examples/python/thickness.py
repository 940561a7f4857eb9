# SPDX-License-Identifier: Apache-2.0
"""A study over a field of a card: the largest force of a weld over the thickness of its sheets.

    python3 thickness.py MODEL.k FOLDER
"""
import sys

import nugget

model, folder = sys.argv[1:]
thicknesses, forces = [0.8, 1.2, 1.5, 2.0], []
for t in thicknesses:
    deck = nugget.read(model)
    section = deck.cards("SECTION_SHELL")[0]
    for corner in ("t1", "t2", "t3", "t4"):
        section[corner] = t
    r = nugget.run(deck.write(f"{folder}/t{t}.k"), directory=f"{folder}/t{t}", threads=2, until=1e-3)
    forces.append(r.welds["peak_force"].max())
    print(f"{t} mm: {forces[-1]:.0f} N")
nugget.plot({"largest force": (thicknesses, forces)}, abscissa="thickness [mm]",
            ordinate="force [N]").save(f"{folder}/thickness.svg")
