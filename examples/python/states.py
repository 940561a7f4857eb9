# SPDX-License-Identifier: Apache-2.0
"""Reads the states of d3plot: plastic strain and deleted elements over time, and a picture of the last state.

    python3 states.py MODEL.k FOLDER
"""
import sys

import nugget
import numpy as np

model, folder = sys.argv[1:]
r = nugget.run(model, directory=f"{folder}/run", threads=2)
states = r.states()
print(states)
largest = [state.shells.plastic_strain.max() for state in states]
last = states[-1]
worst = np.unravel_index(last.shells.plastic_strain.argmax(), last.shells.plastic_strain.shape)[0]
print(f"most plastic strain {largest[-1]:.3f} in shell {states.shells.ids[worst]} "
      f"of part {states.shells.parts[worst]}; {last.shells.deleted.sum()} shells and {last.beams.deleted.sum()} beams are deleted")
nugget.plot({"largest plastic strain": (states.times, largest)}, abscissa="time [s]").save(f"{folder}/strain.svg")
r.picture(scale=5.0, shapes=True).save(f"{folder}/states.svg")
