# SPDX-License-Identifier: Apache-2.0
"""The force of a coupon over its elongation, as a testing machine draws it, raw and filtered.

    python3 over_displacement.py MODEL.k FOLDER
"""
import sys

import nugget
import numpy as np

model, folder = sys.argv[1:]
r = nugget.run(model, directory=f"{folder}/run", threads=2)
swforc, nodout = r.history("swforc"), r.history("nodout")
grip = nodout.entities[0]
times, force = r.sae_filter(swforc.times, swforc.of_all("shear")[:, 0], 1000)
elongation = np.interp(times, nodout.times, nodout[grip, "x_displacement"])
raw = np.interp(swforc.times, nodout.times, nodout[grip, "x_displacement"])
print(f"largest force {force.max():.0f} N at {elongation[force.argmax()]:.3f} mm")
nugget.plot({"as written": (raw, swforc.of_all("shear")[:, 0]), "CFC 1000": (elongation, force)},
            abscissa="elongation [mm]", ordinate="force [N]").save(f"{folder}/over_displacement.svg")
