# SPDX-License-Identifier: Apache-2.0
"""Writes peel.k: a strip that a row of spot welds holds to a base is peeled off from one end.

    python3 examples/peel/make.py FOLDER

Units: mm, t, s, N, MPa. No dependencies; the same bytes at every call.
"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from writer import Deck, main  # noqa: E402

SIZE = 6.0                             # of an element: that of a weld
ALONG, ACROSS = 40, 5                  # elements of a strip: 240 x 30 mm
THICKNESS, DIAMETER = 1.2, 6.0
FIRST, PITCH, COUNT = 6, 5, 7          # welds: from this element on, every so many, in the middle of the strip
SPEED, RAMP, END_TIME = 5000.0, 2.0e-3, 16.0e-3

BASE, STRIP, WELDS = 1, 2, 3           # parts


def sheet(part, z, nodes, shells):
    """One of the two; returns its nodes in row i along."""
    number = lambda i, j: 1000 * part + i * (ACROSS + 1) + j + 1  # noqa: E731
    for i in range(ALONG + 1):
        for j in range(ACROSS + 1):
            nodes[number(i, j)] = (i * SIZE, j * SIZE, z)
    for i in range(ALONG):
        for j in range(ACROSS):
            shells[1000 * part + i * ACROSS + j + 1] = (part, (number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)))
    return lambda i: [number(i, j) for j in range(ACROSS + 1)]


def make():
    nodes, shells, beams = {}, {}, {}
    base, upper = sheet(BASE, 0.0, nodes, shells), sheet(STRIP, THICKNESS, nodes, shells)
    for k in range(COUNT):
        n, x, y = 3001 + 2 * k, (FIRST + k * PITCH + 0.5) * SIZE, 0.5 * ACROSS * SIZE
        nodes[n], nodes[n + 1] = (x, y, 0.0), (x, y, THICKNESS)
        beams[5001 + k] = (WELDS, (n, n + 1))
    d = Deck()
    d.keyword("KEYWORD")
    d.keyword("TITLE")
    d.text(f"A strip peeled off its base, {COUNT} spot welds in a row")
    d.comment(f"""
A strip of {ALONG * SIZE:g} x {ACROSS * SIZE:g} x {THICKNESS:g} mm lies on a base that does not move, held to it by {COUNT} welds. One end is pulled up by
{SPEED / 1000:g} m/s: the welds fail one after the other, as a zip opens. Units: mm, t, s, N, MPa.
""")
    d.keyword("CONTROL_TERMINATION")
    d.card(endtim=END_TIME)
    d.comment("Short weld beams get mass, so that they do not dictate the time step.")
    d.keyword("CONTROL_TIMESTEP")
    d.card(dtinit=0.0, tssfac=0.9, isdo=0, tslimt=0.0, dt2ms=-8.0e-7)
    d.keyword("CONTROL_ENERGY")
    d.card(hgen=2, rwen=2, slnten=2, rylen=2)
    d.comment("binary = 2: into binout, with all digits of the times.")
    for name, interval in (("GLSTAT", 1.0e-4), ("SPCFORC", 2.0e-5), ("SWFORC", 2.0e-5)):
        d.keyword("DATABASE_" + name)
        d.card(dt=interval, binary=2)
    d.keyword("DATABASE_BINARY_D3PLOT")
    d.card(dt=5.0e-4)
    for pid, title in ((BASE, "base"), (STRIP, "strip")):
        d.part(title, pid=pid, secid=1, mid=1)
    d.keyword("SECTION_SHELL")
    d.card(secid=1, elform=2, shrf=0.8333, nip=5)
    d.card(t1=THICKNESS, t2=THICKNESS, t3=THICKNESS, t4=THICKNESS)
    d.comment("A mild steel; etan is the slope of stress over total strain.")
    d.keyword("MAT_PIECEWISE_LINEAR_PLASTICITY")
    d.card(mid=1, ro=7.85e-9, e=210000.0, pr=0.3, sigy=300.0, etan=1489.36)
    d.card(c=0.0)
    d.card(eps1=None)
    d.card(es1=None)
    d.part("spot welds", pid=WELDS, secid=2, mid=2)
    d.weld_section(2, DIAMETER)
    d.comment("mss, mtt: the bending moments that a weld carries.")
    d.keyword("MAT_SPOTWELD")
    d.card(mid=2, ro=7.85e-9, e=210000.0, pr=0.3, sigy=2000.0, eh=1000.0)
    d.card(efail=0.0, nrr=4000.0, nrs=8000.0, nrt=8000.0, mrr=0.0, mss=5000.0, mtt=5000.0)
    d.tie_welds(WELDS, 1, [BASE, STRIP])
    d.comment("The base is held, one end of the strip moves up without turning, free along the strip.")
    d.node_set(1, [n for i in range(ALONG + 1) for n in base(i)])
    d.node_set(2, upper(0))
    d.keyword("BOUNDARY_SPC_SET")
    d.card(nsid=1, cid=0, dofx=1, dofy=1, dofz=1, dofrx=1, dofry=1, dofrz=1)
    d.card(nsid=2, cid=0, dofx=0, dofy=1, dofz=0, dofrx=1, dofry=1, dofrz=1)
    d.keyword("BOUNDARY_PRESCRIBED_MOTION_SET")
    d.card(nsid=2, dof=3, vad=0, lcid=1, sf=SPEED)
    d.curve(1, [(0.0, 0.0), (RAMP, 1.0), (1.0, 1.0)])
    d.nodes(nodes)
    d.shells(shells)
    d.beams(beams)
    return d


if __name__ == "__main__":
    main(__doc__, lambda: {"peel": make()})
