# SPDX-License-Identifier: Apache-2.0
"""A rigid disc pulled in its plane in a plate of 20-node bricks, by CalculiX (ccx): how a sheet slips that two welds pull the same way.

    python3 examples/weld_place/disc.py FOLDER [CCX]

Prints force over d t yield stress at slips over d (what is left of the displacement without the elastic part), for plates that harden by 0.1 to
10 yield stresses a unit of plastic strain: what the joints of stacks have of a sheet in the middle. Some two minutes.
"""
import pathlib
import re
import subprocess
import sys

import solids

# Thickness, diameter, first yield stress, plastic modulus.
PLATES = {"perfect": (1.5, 6.0, 300.0, 30.0), "book": (1.5, 6.0, 300.0, 1200.0), "mild": (1.0, 5.0, 200.0, 2000.0), "strong": (0.8, 4.5, 600.0, 600.0)}
SLIPS = (0.0003, 0.0013, 0.0033, 0.0066, 0.017, 0.03, 0.06, 0.09, 0.12)
STROKE, FREE, HELD, HALF = 0.8, 50.0, 60.0, 50.0  # how far the plate goes to -x, x, to both sides


class Plate(solids.Solids):
    def __init__(self, m):
        self.kind, self.nodes, self.place, self.elements, self.sheets = "disc", {}, [], [], ((FREE, HELD, HALF),)
        for patch in solids.planform(m, FREE, HELD, HALF):
            self.add(patch, 0, max(2, m // 2))

    def text(self, plastic):
        out = ["*NODE,NSET=ALL"] + [f"{n + 1},{x:.9g},{y:.9g},{z:.9g}" for n, (x, y, z) in enumerate(self.place)]
        out.append("*ELEMENT,TYPE=C3D20R,ELSET=EALL")
        for e, nodes in enumerate(self.elements):
            out += [",".join(map(str, [e + 1, *nodes[:9]])) + ",", ",".join(map(str, nodes[9:]))]
        half = -0.5 * solids.THICKNESS  # the plane in the middle stays plane
        sets = {"HELD": lambda x, y, z: x > HELD - 1e-6, "DISC": lambda x, y, z: x * x + y * y < (0.5 * solids.DIAMETER) ** 2 + 1e-3,
                "MIDDLE": lambda x, y, z: abs(y) < 1e-9, "PLANE": lambda x, y, z: abs(z - half) < 1e-6}
        for name, holds in sets.items():
            members = [n + 1 for n, place in enumerate(self.place) if holds(*place)]
            out.append(f"*NSET,NSET={name}")
            out += [",".join(map(str, members[i:i + 12])) + "," for i in range(0, len(members), 12)]
        out += ["*MATERIAL,NAME=STEEL", "*ELASTIC", f"{solids.YOUNG},{solids.POISSON}"]
        if plastic:
            out += ["*PLASTIC", f"{solids.YIELD},0.", f"{solids.YIELD + solids.PLASTIC},1."]
        out += ["*SOLID SECTION,ELSET=EALL,MATERIAL=STEEL", "*BOUNDARY", "HELD,1,3,0.", "DISC,2,2,0.", "MIDDLE,2,2,0.", "PLANE,3,3,0."]
        out += ["*STEP,NLGEOM,INC=1000" if plastic else "*STEP", "*STATIC"] + (["0.02,1.,1e-6,0.04"] if plastic else [])
        out += ["*BOUNDARY", f"DISC,1,1,{-STROKE if plastic else -1e-3}", "*NODE PRINT,NSET=DISC,TOTALS=ONLY", "RF", "*END STEP", ""]
        return "\n".join(out)


def solve(name, plastic, folder, ccx):
    """[(displacement, force)] of the whole plate."""
    job = f"disc_{name}_{'plastic' if plastic else 'elastic'}"
    data = folder / f"{job}.dat"
    if not data.exists():
        (folder / f"{job}.inp").write_text(Plate(3).text(plastic), encoding="ascii")
        subprocess.run([ccx, job], cwd=folder, capture_output=True, check=True)
    curve, time = [], 0.0
    for line in data.read_text(encoding="ascii").splitlines():
        at = re.search(r"and time\s+([-+.\dE]+)", line)
        if at:
            time = float(at[1])
        elif re.match(r"\s+[-+.\dE]+\s+[-+.\dE]+\s+[-+.\dE]+\s*$", line):
            curve.append((time * (STROKE if plastic else 1e-3), -2.0 * float(line.split()[0])))
    return curve


def main(folder, ccx="ccx"):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    for name, plate in PLATES.items():
        solids.THICKNESS, solids.DIAMETER, solids.YIELD, solids.PLASTIC = plate
        (u, f), = solve(name, False, folder, ccx)
        unit = solids.DIAMETER * solids.THICKNESS * solids.YIELD
        slips = [((v - g * u / f) / solids.DIAMETER, g / unit) for v, g in solve(name, True, folder, ccx)]
        print(f"{name}, hardening by {solids.PLASTIC / solids.YIELD:g} yield stresses: " +
              ", ".join(f"{solids.force(slips, s):.3f} at {s:g}" for s in SLIPS))


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    main(*sys.argv[1:])
