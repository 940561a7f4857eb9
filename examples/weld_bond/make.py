# SPDX-License-Identifier: Apache-2.0
"""Writes a lap joint and a hat profile whose flanges are spot welded, bonded, or both: lap_welded.k, lap_bonded.k, lap_both.k to run, and
modes/hat_*.k for their frequencies; laws/lap_*.k: the bonded lap joint by each law of adhesive, and by a tie that fails.

    python3 examples/weld_bond/make.py FOLDER

Units: mm, t, s, N, MPa. No dependencies; the same bytes at every call.
"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from writer import Deck  # noqa: E402

THICKNESS, GLUE = 1.2, 0.3    # of a sheet, of the adhesive
APART = THICKNESS + GLUE      # mid-surfaces
SHEET_SIZE, GLUE_SIZE = 5.0, 3.5  # of elements: adhesive need not match the sheets
MARGIN = 1.0                  # between the edge of a flange and the adhesive
LOWER, UPPER, ADHESIVE, WELDS = 1, 2, 3, 4  # parts
JOINTS = ("welded", "bonded", "both")
LAWS = ("240", "169", "138", "186", "185", "tie")
# Strengths in tension and shear, energies, moduli over GLUE; the plateau in shear has 0.7 of the energy.
STRENGTH, SHEAR, ENERGY, SHEAR_ENERGY, MODULUS, SHEAR_MODULUS, PLATEAU = 30.0, 20.0, 3.0, 12.0, 2000.0, 750.0, 0.7
LAP = {"length": 100.0, "width": 40.0, "overlap": 16.0, "reach": 2.0, "end": 1.0e-2}
HAT = {"length": 400.0, "top": 60.0, "web": 50.0, "flange": 20.0, "pitch": 50.0}


class Mesh:
    def __init__(self):
        self.nodes, self.shells, self.solids, self.beams = {}, {}, {}, {}

    def node(self, x, y, z):
        self.nodes[len(self.nodes) + 1] = (x, y, z)
        return len(self.nodes)

    def grid(self, across, along, place):
        """Node (i, j) at place(across[i], along[j])."""
        return [[self.node(*place(a, y)) for a in across] for y in along]

    def sheet(self, part, across, along, place):
        rows = self.grid(across, along, place)
        for one, other in zip(rows, rows[1:]):
            for i in range(len(one) - 1):
                self.shells[len(self.shells) + 1] = (part, (one[i], one[i + 1], other[i + 1], other[i]))
        return rows

    def glue(self, x, y):
        """Cohesive bricks between the mid-surfaces of the sheets, on nodes of their own."""
        low, high = (self.grid(spread(*x, GLUE_SIZE), spread(*y, GLUE_SIZE), lambda a, b, z=z: (a, b, z)) for z in (0.0, APART))
        for j in range(len(low) - 1):
            for i in range(len(low[0]) - 1):
                self.solids[500001 + len(self.solids)] = (ADHESIVE, tuple(g[j + b][i + a] for g in (low, high) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))))

    def weld(self, x, y):
        self.beams[700001 + len(self.beams)] = (WELDS, (self.node(x, y, 0.0), self.node(x, y, APART)))


def spread(low, high, size):
    count = max(1, round((high - low) / size))
    return [low + (high - low) * i / count for i in range(count + 1)]


def adhesive(d, law):
    """The law's cards. 138 and the tie have no plateau; 185 has one energy, here that of the shear."""
    share = PLATEAU / (2.0 - PLATEAU)  # of the separation at failure
    last = 2.0 * SHEAR_ENERGY / ((1.0 + share) * SHEAR)
    first = SHEAR / (SHEAR_MODULUS / GLUE) / last
    common = {"mid": ADHESIVE, "ro": 1.2e-9, "roflg": 0, "intfail": 1}
    if law == "240":
        d.keyword("MAT_COHESIVE_MIXED_MODE_ELASTOPLASTIC_RATE")
        d.card(**common, emod=MODULUS, gmod=SHEAR_MODULUS, thick=GLUE)
        d.card(g1c_0=ENERGY, g1c_inf=None, edot_g1=None, t0=STRENGTH, t1=None, edot_t=None, fg1=0.5)
        d.card(g2c_0=SHEAR_ENERGY, g2c_inf=None, edot_g2=None, s0=SHEAR, s1=None, edot_s=None, fg2=PLATEAU)
    elif law == "169":
        d.keyword("MAT_ARUP_ADHESIVE")
        d.card(mid=ADHESIVE, ro=1.2e-9, e=MODULUS, pr=0.3333, tenmax=STRENGTH, gcten=ENERGY, shrmax=SHEAR, gcshr=SHEAR_ENERGY)
        d.card(pwrt=2.0, pwrs=2.0, shrp=share, sht_sl=0.0, edot0=1.0, edot2=0.0, thkdir=1, extra=2)
        d.card(bthk=GLUE)
    elif law == "138":
        d.keyword("MAT_COHESIVE_MIXED_MODE")
        d.card(**common, en=MODULUS / GLUE, et=SHEAR_MODULUS / GLUE, gic=ENERGY, giic=SHEAR_ENERGY)
        d.card(xmu=1.0, t=STRENGTH, s=SHEAR)
    elif law == "186":
        d.keyword("MAT_COHESIVE_GENERAL")
        d.card(**common, tes=0, tslc=20, gic=ENERGY, giic=SHEAR_ENERGY)
        d.card(xmu=1.0, t=STRENGTH, s=SHEAR, stfsf=0.0)
        d.curve(20, [(0.0, 0.0), (first, 1.0), (first + share, 1.0), (1.0, 0.0)])
    elif law == "185":
        d.keyword("MAT_COHESIVE_TH")
        d.card(**common, sigmax=STRENGTH, nls=SHEAR / STRENGTH * last, tls=last)
        d.card(lamda1=first, lamda2=first + share, lamdaf=1.0, stfsf=1.0)


def failing_tie(d):
    """Between the sheets themselves, without adhesive: SAST and SBST below 0 are its tolerance."""
    d.keyword("CONTACT_TIED_SURFACE_TO_SURFACE_FAILURE_ID")
    d.text(f"{1:10d}upper sheet to lower")
    d.card(surfa=UPPER, surfb=LOWER, surfatyp=3, surfbtyp=3)
    d.card(fs=STRENGTH, fd=SHEAR)
    d.card(sfsa=1.0, sfsb=1.0, sast=-APART, sbst=-APART)


def lap(joint, law="240"):
    """Two strips; the lower one is held at its left end, the upper one pulled at its right end."""
    mesh, width, overlap = Mesh(), LAP["width"], LAP["overlap"]
    end = 2.0 * LAP["length"] - overlap
    lower = mesh.sheet(LOWER, spread(0.0, LAP["length"], SHEET_SIZE), spread(0.0, width, SHEET_SIZE), lambda x, y: (x, y, 0.0))
    upper = mesh.sheet(UPPER, spread(end - LAP["length"], end, SHEET_SIZE), spread(0.0, width, SHEET_SIZE), lambda x, y: (x, y, APART))
    if joint != "welded" and law != "tie":
        mesh.glue((end - LAP["length"] + MARGIN, LAP["length"] - MARGIN), (MARGIN, width - MARGIN))
    if joint != "bonded":
        mesh.weld(0.5 * end, 0.5 * width)
    d = begin(f"Lap joint, {joint}" + (f", law {law}" if law != "240" else ""), LAP["end"])
    if law == "tie":
        failing_tie(d)
    d.comment("The grips hold all but the pull along x.")
    held, pulled = [row[0] for row in lower], [row[-1] for row in upper]
    d.keyword("BOUNDARY_SPC_SET")
    d.card(nsid=1, cid=0, dofx=1, dofy=1, dofz=1, dofrx=1, dofry=1, dofrz=1)
    d.card(nsid=2, cid=0, dofx=0, dofy=1, dofz=1, dofrx=1, dofry=1, dofrz=1)
    d.node_set(1, held)
    d.node_set(2, pulled)
    d.curve(1, [(0.0, 0.0), (0.1 * LAP["end"], 0.02 * LAP["reach"]), (LAP["end"], LAP["reach"])])
    d.keyword("BOUNDARY_PRESCRIBED_MOTION_SET")
    d.card(nsid=2, dof=1, vad=2, lcid=1)
    d.comment("The pull is the sum of the forces at the held end (spcforc).")
    for name, interval in (("SPCFORC", 500), ("GLSTAT", 100), ("SWFORC", 100), ("BINARY_D3PLOT", 20)):
        d.keyword("DATABASE_" + name)
        d.card(dt=LAP["end"] / interval)
    return finish(d, mesh, law)


def hat(joint):
    """A hat on a closing plate, free at all sides: its first twist tells how stiff the flanges are joined."""
    mesh, length, half = Mesh(), HAT["length"], 0.5 * HAT["top"]
    outer = half + HAT["flange"]
    corners = [(-outer, APART), (-half, APART), (-half, APART + HAT["web"]), (half, APART + HAT["web"]), (half, APART), (outer, APART)]
    profile = [corners[0]]
    for (xa, za), (xb, zb) in zip(corners, corners[1:]):
        steps = spread(0.0, 1.0, SHEET_SIZE / (abs(xb - xa) + abs(zb - za)))[1:]
        profile += [(xa + s * (xb - xa), za + s * (zb - za)) for s in steps]
    along = spread(0.0, length, SHEET_SIZE)
    mesh.sheet(LOWER, spread(-outer, outer, SHEET_SIZE), along, lambda x, y: (x, y, 0.0))
    mesh.sheet(UPPER, profile, along, lambda p, y: (p[0], y, p[1]))
    for side in (-1.0, 1.0):
        inner, edge = side * half, side * outer
        low, high = min(inner, edge), max(inner, edge)
        if joint != "welded":
            mesh.glue((low + MARGIN, high - MARGIN), (MARGIN, length - MARGIN))
        for k in range(round(length / HAT["pitch"]) if joint != "bonded" else 0):
            mesh.weld(0.5 * (inner + edge), (k + 0.5) * HAT["pitch"])
    d = begin(f"Hat profile, {joint}", 1.0)
    d.keyword("CONTROL_IMPLICIT_GENERAL")
    d.card(imflag=1, dt0=1.0)
    d.keyword("CONTROL_IMPLICIT_EIGENVALUE")
    d.card(neig=10)
    return finish(d, mesh)


def begin(title, end):
    d = Deck()
    d.keyword("KEYWORD")
    d.keyword("TITLE")
    d.text(title)
    d.keyword("CONTROL_TERMINATION")
    d.card(endtim=end)
    d.keyword("CONTROL_ENERGY")
    d.card(hgen=2, rwen=2, slnten=2, rylen=2)
    return d


def finish(d, mesh, law="240"):
    d.part("lower sheet", pid=LOWER, secid=1, mid=1)
    d.part("upper sheet", pid=UPPER, secid=1, mid=1)
    d.keyword("SECTION_SHELL")
    d.card(secid=1, elform=16, shrf=0.8333, nip=5)
    d.card(t1=THICKNESS, t2=THICKNESS, t3=THICKNESS, t4=THICKNESS)
    d.keyword("MAT_PIECEWISE_LINEAR_PLASTICITY")
    d.card(mid=1, ro=7.85e-9, e=210000.0, pr=0.3, sigy=400.0, etan=1000.0)
    d.card(c=0.0)
    d.card(eps1=None)
    d.card(es1=None)
    d.keyword("SET_PART_LIST")
    d.card(sid=1)
    d.ids([LOWER, UPPER])
    if mesh.solids:
        d.comment("""
Adhesive. ELFORM 20 joins the mid-surfaces of shells; THICK is what lies between the sheets.
Values like those of a toughened epoxy, of no product.""")
        d.part("adhesive", pid=ADHESIVE, secid=ADHESIVE, mid=ADHESIVE)
        d.keyword("SECTION_SOLID")
        d.card(secid=ADHESIVE, elform=20)
        adhesive(d, law)
        d.keyword("CONTACT_TIED_SHELL_EDGE_TO_SURFACE_ID")
        d.text(f"{1:10d}adhesive to sheets")
        d.card(surfa=ADHESIVE, surfb=1, surfatyp=3, surfbtyp=2)
        d.card(fs=None)
        d.card(sfsa=None)
    if mesh.beams:
        d.comment("Welds of 6 mm that break at 9 kN in shear, 7 kN in tension.")
        d.part("spot welds", pid=WELDS, secid=WELDS, mid=WELDS)
        d.weld_section(WELDS, 6.0)
        d.keyword("MAT_SPOTWELD")
        d.card(mid=WELDS, ro=7.85e-9, e=210000.0, pr=0.3, sigy=1000.0, eh=1000.0, dt=0.0, tfail=0.0)
        d.card(efail=0.0, nrr=7000.0, nrs=9000.0, nrt=9000.0, mrr=0.0, mss=0.0, mtt=0.0, nf=0.0)
        d.tie_welds(WELDS, 1, number=2)
    d.nodes(mesh.nodes)
    d.shells(mesh.shells)
    if mesh.solids:
        d.solids(mesh.solids)
    if mesh.beams:
        d.beams(mesh.beams)
    return d


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    for name in ("modes", "laws"):
        (folder / name).mkdir(parents=True, exist_ok=True)
    for joint in JOINTS:
        lap(joint).write(folder / f"lap_{joint}.k")
        hat(joint).write(folder / "modes" / f"hat_{joint}.k")
    for law in LAWS:
        lap("bonded", law).write(folder / "laws" / f"lap_{law}.k")
