# SPDX-License-Identifier: Apache-2.0
"""Natural modes as arrays: frequencies, effective masses, and how alike two shapes are (MAC).

    python3 shapes.py MODEL.k FOLDER
"""
import sys

import nugget
import numpy as np

model, folder = sys.argv[1:]
r = nugget.modes(model, directory=f"{folder}/modes", count=6)
modes = r.modes()
for number, (frequency, mass) in enumerate(zip(modes.frequencies, modes.effective_mass), 1):
    print(f"mode {number}: {frequency:8.1f} Hz, effective mass in x {mass[0]:.3g}")
flat = modes.shapes.reshape(len(modes), -1)
products = flat @ flat.T
mac = products ** 2 / np.outer(products.diagonal(), products.diagonal())
print(np.array2string(mac, precision=2, suppress_small=True))
r.picture(state=1).save(f"{folder}/shapes.svg")
