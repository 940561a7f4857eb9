# SPDX-License-Identifier: Apache-2.0
"""What the decks of the talk share: flat sheets, weld beams and bricks between them, ties. mm, t, s, N, MPa."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from writer import Deck  # noqa: E402

YOUNG, POISSON, DENSITY = 210000.0, 0.3, 7.85e-9
SHEAR_MODULUS = YOUNG / (2.0 * (1.0 + POISSON))


def rounded(value):
    """To four digits: what a field of a card holds."""
    return float(f"{value:.4g}")


def disc(diameter):
    return 0.25 * math.pi * diameter**2


class Model:
    """A deck that grows: parts with their sections and materials, nodes and elements, ties."""

    def __init__(self, title, end_time, tssfac=0.9, dt2ms=0.0, step=0.0):
        self.nodes, self.shells, self.beams, self.named, self.solids, self.grids = {}, {}, {}, {}, {}, {}
        self.deck = d = Deck()
        d.keyword("KEYWORD")
        d.keyword("TITLE")
        d.text(title)
        d.keyword("CONTROL_TERMINATION")
        d.card(endtim=rounded(end_time))
        d.keyword("CONTROL_TIMESTEP")
        d.card(dtinit=0.0, tssfac=tssfac, isdo=0, tslimt=0.0, dt2ms=dt2ms, lctm=3 if step else 0)
        if step:
            d.curve(3, [(0.0, step), (1.0, step)])
        d.keyword("CONTROL_ENERGY")
        d.card(hgen=2, rwen=2, slnten=2, rylen=2)

    def record(self, interval, *files):
        for name in files:
            self.deck.keyword("DATABASE_" + name)
            self.deck.card(dt=rounded(interval), binary=2 if name == "SPCFORC" else None)

    def watch(self, nodes):
        self.deck.keyword("DATABASE_HISTORY_NODE")
        self.deck.ids(nodes)

    def sheet(self, pid, thickness, corner, nx, ny, size, turned=False, elform=2):
        """nx times ny squares from `corner` on, normal upward, or down where `turned`. Node and shell ids begin with 1000 times pid."""
        d = self.deck
        d.part(f"sheet {pid}", pid=pid, secid=pid, mid=pid)
        d.keyword("SECTION_SHELL")
        d.card(secid=pid, elform=elform, shrf=0.8333, nip=3)
        d.card(t1=thickness, t2=thickness, t3=thickness, t4=thickness)
        self.elastic(pid)
        number = lambda i, j: 1000 * pid + j * (nx + 1) + i + 1  # noqa: E731
        for j in range(ny + 1):
            for i in range(nx + 1):
                self.nodes[number(i, j)] = (corner[0] + i * size, corner[1] + j * size, corner[2])
        for j in range(ny):
            for i in range(nx):
                ring = (number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1))
                self.shells[1000 * pid + j * nx + i + 1] = (pid, ring[::-1] if turned else ring)
        self.grids[pid] = [number(i, j) for j in range(ny + 1) for i in range(nx + 1)]
        return self.grids[pid]

    def elastic(self, mid):
        self.deck.keyword("MAT_ELASTIC")
        self.deck.card(mid=mid, ro=DENSITY, e=YOUNG, pr=POISSON)

    def spotweld(self, mid, sigy=1.0e6, eh=0.0, dt=0.0, young=YOUNG, **second):
        self.deck.keyword("MAT_SPOTWELD")
        self.deck.card(mid=mid, ro=DENSITY, e=young, pr=POISSON, sigy=sigy, eh=eh, dt=dt)
        self.deck.card(**(second or {"efail": 0.0}))

    def beam_part(self, pid, diameter, qr=2):
        self.deck.part("weld beams", pid=pid, secid=pid, mid=pid)
        self.deck.keyword("SECTION_BEAM")
        self.deck.card(secid=pid, elform=9, shrf=1.0, qr=qr, cst=1.0)
        self.deck.card(ts1=diameter, ts2=diameter, tt1=0.0, tt2=0.0)

    def brick_part(self, pid, elform=1, ihq=6, qm=1.0):
        d = self.deck
        d.part("weld bricks", pid=pid, secid=pid, mid=pid, eosid=0, hgid=pid)
        d.keyword("SECTION_SOLID")
        d.card(secid=pid, elform=elform)
        d.keyword("HOURGLASS")
        d.card(hgid=pid, ihq=ihq, qm=qm)

    def beam(self, eid, pid, first, second, sheets=None):
        """Its nodes are eid and eid + 1; `sheets`: the parts that its ends are to be tied to."""
        self.nodes[eid], self.nodes[eid + 1] = first, second
        if sheets:
            self.named[eid] = (pid, sheets)
        else:
            self.beams[eid] = (pid, (eid, eid + 1))

    def prism(self, pid, first, xs, ys, zs):
        """Bricks between the planes; nodes and bricks from `first` on. Ids of the nodes of each plane of zs."""
        across, along = len(xs), len(xs) * len(ys)
        number = lambda i, j, k: first + k * along + j * across + i  # noqa: E731
        for k, z in enumerate(zs):
            for j, y in enumerate(ys):
                for i, x in enumerate(xs):
                    self.nodes[number(i, j, k)] = (x, y, z)
        for k in range(len(zs) - 1):
            for j in range(len(ys) - 1):
                for i in range(len(xs) - 1):
                    low = [number(i, j, k), number(i + 1, j, k), number(i + 1, j + 1, k), number(i, j + 1, k)]
                    self.solids[first + len(self.solids)] = (pid, (*low, *(n + along for n in low)))
        return [[number(i, j, k) for j in range(len(ys)) for i in range(len(xs))] for k in range(len(zs))]

    def tie(self, welds, sheets, form=""):
        """The weld part tied to the sheets (set 1)."""
        d = self.deck
        d.keyword("SET_PART_LIST")
        d.card(sid=1)
        d.ids(sheets)
        d.keyword("CONTACT_SPOTWELD" + form)
        d.card(surfa=welds, surfb=1, surfatyp=3, surfbtyp=2)
        d.card(fs=None)
        d.card(sfsa=None)

    def hold(self, sid, nodes, dofs="xyzuvw"):
        self.deck.node_set(sid, nodes)
        self.deck.keyword("BOUNDARY_SPC_SET")
        x, y, z, u, v, w = (int(c in dofs) for c in "xyzuvw")
        self.deck.card(nsid=sid, cid=0, dofx=x, dofy=y, dofz=z, dofrx=u, dofry=v, dofrz=w)

    def drive(self, sid, dof, points, scale=1.0, vad=2):
        """Set sid along dof by the curve `points` (number 100 sid + dof) times scale: a displacement (vad 2) or a velocity (0)."""
        lcid = 100 * sid + dof
        self.deck.curve(lcid, [(t, scale * u) for t, u in points])
        self.deck.keyword("BOUNDARY_PRESCRIBED_MOTION_SET")
        self.deck.card(nsid=sid, dof=dof, vad=vad, lcid=lcid)

    def finished(self):
        d = self.deck
        d.nodes(self.nodes)
        if self.shells:
            d.shells(self.shells)
        if self.beams:
            d.beams(self.beams)
        if self.solids:
            d.solids(self.solids)
        if self.named:
            d.keyword("ELEMENT_BEAM_PID")
            d.text("$#   eid     pid      n1      n2      n3")
            for eid, (pid, sheets) in self.named.items():
                d.text(f"{eid:8d}{pid:8d}{eid:8d}{eid + 1:8d}{0:8d}")
                d.text(f"{sheets[0]:8d}{sheets[1]:8d}")
        return d


def smooth(duration, last=1.0e10):
    """A rise from 0 to 1 without a jump of its slope, then 1."""
    rise = [(duration * i / 20.0, 0.5 - 0.5 * math.cos(math.pi * i / 20.0)) for i in range(21)]
    return rise + [(last, 1.0)]
