# SPDX-License-Identifier: Apache-2.0
"""Writes joint.k: two sheets and two spot welds, as someone would write his first deck, with three mistakes.

    python3 examples/first_joint/make.py FOLDER

Two sheets of 80 x 40 x 1.2 mm overlap by 40 mm and are joined by two welds of 6 mm. One end is held, the other is pulled.
What is wrong: the second sheet's part names a material that is not there, the run has no end time, and one end of a weld
lies 12 mm above its sheet instead of 1.2. docs/tutorials/first_deck.md finds all three. Units: mm, t, s, N, MPa.
"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from writer import Deck, main  # noqa: E402

LENGTH, WIDTH, OVERLAP, THICKNESS, SIZE = 80.0, 40.0, 40.0, 1.2, 5.0
DIAMETER, STRENGTH = 6.0, 6000.0
WELDS = {501: (57.5, 12.5), 502: (57.5, 27.5)}  # over centres of elements of both sheets


def sheet(part, x0, z):
    """({id: place}, {id: (part, corners)}) of a sheet from x0 on."""
    columns, rows = round(LENGTH / SIZE), round(WIDTH / SIZE)
    number = lambda i, j: 1000 * part + i * (rows + 1) + j + 1  # noqa: E731
    nodes = {number(i, j): (x0 + i * SIZE, j * SIZE, z) for i in range(columns + 1) for j in range(rows + 1)}
    shells = {1000 * part + i * rows + j + 1: (part, (number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)))
              for i in range(columns) for j in range(rows)}
    return nodes, shells


def make():
    lower, lower_shells = sheet(1, 0.0, 0.0)
    upper, upper_shells = sheet(2, LENGTH - OVERLAP, THICKNESS)
    d = Deck()
    d.keyword("KEYWORD")
    d.keyword("TITLE")
    d.text("My first joint: two sheets, two spot welds")
    d.comment("Units: mm, t, s, N, MPa. MISTAKE 1: there is no end time.")
    d.keyword("CONTROL_TERMINATION")
    d.card(endtim=None)
    d.keyword("CONTROL_TIMESTEP")
    d.card(dtinit=0.0, tssfac=0.9)
    for name, interval in (("GLSTAT", 1.0e-5), ("SWFORC", 2.0e-6), ("NODOUT", 1.0e-5), ("BINARY_D3PLOT", 1.0e-4)):
        d.keyword("DATABASE_" + name)
        d.card(dt=interval)
    d.keyword("DATABASE_HISTORY_NODE")
    d.ids([max(upper)])
    d.comment("MISTAKE 2: there is no material 4.")
    d.part("lower sheet", pid=1, secid=1, mid=1)
    d.part("upper sheet", pid=2, secid=1, mid=4)
    d.part("welds", pid=3, secid=3, mid=3)
    d.keyword("SECTION_SHELL")
    d.card(secid=1, elform=2, shrf=0.8333, nip=3)
    d.card(t1=THICKNESS, t2=THICKNESS, t3=THICKNESS, t4=THICKNESS)
    d.keyword("SECTION_BEAM")
    d.card(secid=3, elform=9, shrf=1.0, qr=2, cst=1.0)
    d.card(ts1=DIAMETER, ts2=DIAMETER)
    d.keyword("MAT_PIECEWISE_LINEAR_PLASTICITY")
    d.card(mid=1, ro=7.85e-9, e=2.1e5, pr=0.3, sigy=300.0, etan=900.0)
    d.text("")
    d.text("")
    d.text("")
    d.keyword("MAT_SPOTWELD")
    d.card(mid=3, ro=7.85e-9, e=2.1e5, pr=0.3, sigy=500.0, eh=1000.0)
    d.card(efail=0.0, nrr=STRENGTH, nrs=STRENGTH, nrt=STRENGTH, mrr=2.0e4, mss=2.0e4, mtt=2.0e4)
    d.keyword("CONTACT_SPOTWELD")
    d.card(ssid=3, msid=1, sstyp=3, mstyp=2)
    d.text("")
    d.text("")
    d.keyword("SET_PART_LIST")
    d.card(sid=1)
    d.ids([1, 2])
    d.keyword("BOUNDARY_SPC_SET")
    d.card(nsid=1, cid=0, dofx=1, dofy=1, dofz=1, dofrx=1, dofry=1, dofrz=1)
    d.node_set(1, [n for n, (x, _, _) in lower.items() if x == 0.0])
    d.keyword("BOUNDARY_PRESCRIBED_MOTION_SET")
    d.card(nsid=2, dof=1, vad=0, lcid=1)
    d.node_set(2, [n for n, (x, _, _) in upper.items() if x == max(x for x, _, _ in upper.values())])
    d.comment("Speed of the pulled edge over time: 1 m/s after 0.1 ms.")
    d.curve(1, [(0.0, 0.0), (1.0e-4, 1000.0), (1.0, 1000.0)])
    d.comment("MISTAKE 3: node 9004 lies 12 mm above the lower sheet, and the upper sheet only 1.2.")
    ends = {}
    for k, (x, y) in enumerate(WELDS.values()):
        ends[9001 + 2 * k] = (x, y, 0.0)
        ends[9002 + 2 * k] = (x, y, 10.0 * THICKNESS if k else THICKNESS)
    d.nodes({**lower, **upper, **ends})
    d.shells({**lower_shells, **upper_shells})
    d.beams({eid: (3, (9001 + 2 * k, 9002 + 2 * k)) for k, eid in enumerate(WELDS)})
    return d


if __name__ == "__main__":
    main(__doc__, lambda: {"joint": make()})
