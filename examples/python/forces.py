# SPDX-License-Identifier: Apache-2.0
"""Runs a deck and shows the forces in its welds.

    python3 forces.py MODEL.k FOLDER
"""
import sys

import nugget

model, folder = sys.argv[1:]
r = nugget.run(model, directory=f"{folder}/run", threads=2)
swforc = r.history("swforc")
for weld in swforc.entities:
    print(f"{weld}: largest shear force {swforc[weld, 'shear'].max():.0f} {swforc.unit('shear')}")
r.plot("swforc/*/shear", "swforc/*/axial", "glstat/*energy").save(f"{folder}/forces.svg")
