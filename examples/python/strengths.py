# SPDX-License-Identifier: Apache-2.0
"""A study of welds: the largest force and how many welds fail, over the bending moment that a weld carries.

    python3 strengths.py MODEL.k FOLDER
"""
import sys

import nugget

model, folder = sys.argv[1:]
moments, forces, failed = [3000.0, 4000.0, 5000.0, 6000.0, 7000.0], [], []
print("  moment  force  failed")
for moment in moments:
    deck = nugget.read(model)
    for weld in deck.cards("MAT_SPOTWELD"):
        weld["mss"] = weld["mtt"] = moment
    r = nugget.run(deck.write(f"{folder}/moment{moment:.0f}.k"), directory=f"{folder}/moment{moment:.0f}", threads=2)
    spcforc = r.history("spcforc")
    forces.append(abs(r.sae_filter(spcforc.times, spcforc["z_resultant"], 600)[1]).max())
    failed.append(r.welds["failed"].sum())
    print(f"{moment:8.0f} {forces[-1]:6.0f} {failed[-1]:7}")
nugget.plot({"largest force": (moments, forces)}, abscissa="bending strength of a weld [N mm]",
            ordinate="force [N]").save(f"{folder}/strengths.svg")
nugget.plot({"failed welds": (moments, failed)}, abscissa="bending strength of a weld [N mm]", ordinate="failed welds",
            points=["failed welds"]).save(f"{folder}/failed.svg")
