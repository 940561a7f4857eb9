# SPDX-License-Identifier: Apache-2.0
"""Writes panel.k: a panel with a spot-welded stiffener, its natural modes and its response to a force over frequency.

    python3 examples/panel/make.py FOLDER

Units: mm, t, s, N, MPa. No dependencies; the same bytes at every call.
"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from writer import Deck, main  # noqa: E402

SIZE = 6.0                                  # of an element: that of a weld
ACROSS, ALONG = 50, 67                      # elements of the panel: 300 x 402 mm
PANEL_T, HAT_T = 1.0, 1.2
FLANGE, WEB, TOP = 3, 3, 4                  # elements of the hat's section
HAT_AT = 17                                 # element of the panel at which the hat begins: not in the middle
PITCH, FIRST = 6, 2                         # welds every so many elements, from this one on: not the same at both ends
DIAMETER = 6.0
FORCE_AT, FELT_AT = (10, 20), (40, 45)      # nodes (across, along) on either side of the stiffener
MODES, FMAX, STEPS, DAMPING = 30, 500.0, 1000, 0.02

PANEL, HAT, WELDS = 1, 2, 3                 # parts, and their sections and materials


def panel_node(i, j):
    return 1 + j * (ACROSS + 1) + i


def hat_section():
    """(y, z) of the hat's nodes, its flanges on the panel."""
    points = [(HAT_AT * SIZE, 0.0)]
    for count, dy, dz in ((FLANGE, 1, 0), (WEB, 0, 1), (TOP, 1, 0), (WEB, 0, -1), (FLANGE, 1, 0)):
        for _ in range(count):
            y, z = points[-1]
            points.append((y + dy * SIZE, z + dz * SIZE))
    gap = 0.5 * (PANEL_T + HAT_T)
    return [(y, z + gap) for y, z in points]


def sheets():
    nodes = {panel_node(i, j): (j * SIZE, i * SIZE, 0.0) for j in range(ALONG + 1) for i in range(ACROSS + 1)}
    shells = {}
    for j in range(ALONG):
        for i in range(ACROSS):
            corners = (panel_node(i, j), panel_node(i, j + 1), panel_node(i + 1, j + 1), panel_node(i + 1, j))
            shells[len(shells) + 1] = (PANEL, corners)
    section, first = hat_section(), 10001
    for j in range(ALONG + 1):
        for k, (y, z) in enumerate(section):
            nodes[first + j * len(section) + k] = (j * SIZE, y, z)
    for j in range(ALONG):
        for k in range(len(section) - 1):
            a = first + j * len(section) + k
            shells[len(shells) + 1] = (HAT, (a, a + len(section), a + len(section) + 1, a + 1))
    return nodes, shells


def welds(nodes):
    """A beam in the middle of each flange, over centres of elements of both sheets."""
    beams = {}
    last = hat_section()[-1][0]
    for y in ((HAT_AT + FLANGE / 2.0) * SIZE, last - 0.5 * FLANGE * SIZE):
        for j in range(FIRST, ALONG, PITCH):
            n = 20001 + 2 * len(beams)
            x = (j + 0.5) * SIZE
            nodes[n], nodes[n + 1] = (x, y, 0.0), (x, y, 0.5 * (PANEL_T + HAT_T))
            beams[30001 + len(beams)] = (WELDS, (n, n + 1))
    return beams


def make():
    nodes, shells = sheets()
    beams = welds(nodes)
    edge = [panel_node(i, j) for j in range(ALONG + 1) for i in range(ACROSS + 1) if i in (0, ACROSS) or j in (0, ALONG)]
    d = Deck()
    d.keyword("KEYWORD")
    d.keyword("TITLE")
    d.text(f"Panel with a spot-welded stiffener, {len(beams)} welds")
    d.comment(f"""
A panel of {ALONG * SIZE:g} x {ACROSS * SIZE:g} x {PANEL_T:g} mm on simple supports, and a hat profile that {len(beams)} spot welds hold to it. A force of 1 N acts
on one side of the stiffener, the acceleration is felt on the other. Units: mm, t, s, N, MPa.

---- what to compute: natural modes, then the response by them -------------------------------------------------""")
    d.comment("imflag = 1: no explicit run. neig: so many modes, from the lowest.")
    d.keyword("CONTROL_IMPLICIT_GENERAL")
    d.card(imflag=1, dt0=1.0)
    d.keyword("CONTROL_IMPLICIT_EIGENVALUE")
    d.card(neig=MODES)
    d.keyword("CONTROL_TERMINATION")
    d.card(endtim=1.0)
    d.comment(f"From node n1 to node n2. vad1 = 3: a nodal force along z (dof1 = 3). dampf: {DAMPING:g} of the critical damping in each mode.\n"
              "vad2 = 1: the acceleration along z. fspace = 2: frequencies gathered at the natural ones, where the peaks are.")
    d.keyword("FREQUENCY_DOMAIN_FRF")
    d.card(n1=panel_node(*FORCE_AT), n1typ=0, dof1=3, vad1=3)
    d.card(dampf=DAMPING)
    d.card(n2=panel_node(*FELT_AT), n2typ=0, dof2=3, vad2=1)
    d.card(fmin=50.0, fmax=FMAX, nfreq=STEPS, fspace=2)

    d.comment("\n---- the sheets ------------------------------------------------------------------------------------------------")
    for pid, title, t in ((PANEL, "panel", PANEL_T), (HAT, "stiffener", HAT_T)):
        d.part(title, pid=pid, secid=pid, mid=PANEL)
        d.keyword("SECTION_SHELL")
        d.card(secid=pid, elform=16, shrf=0.8333, nip=2)
        d.card(t1=t, t2=t, t3=t, t4=t)
    d.keyword("MAT_ELASTIC")
    d.card(mid=PANEL, ro=7.85e-9, e=210000.0, pr=0.3)
    d.comment("The edges of the panel do not move; they may turn.")
    d.keyword("BOUNDARY_SPC_SET")
    d.card(nsid=1, cid=0, dofx=1, dofy=1, dofz=1, dofrx=0, dofry=0, dofrz=0)
    d.node_set(1, edge)

    d.comment("\n---- the welds -------------------------------------------------------------------------------------------------")
    d.part("spot welds", pid=WELDS, secid=WELDS, mid=WELDS)
    d.weld_section(WELDS, DIAMETER)
    d.comment("In vibration a weld is elastic; it has no strengths here.")
    d.keyword("MAT_SPOTWELD")
    d.card(mid=WELDS, ro=7.85e-9, e=210000.0, pr=0.3, sigy=500.0, eh=1000.0)
    d.card(efail=0.0)
    d.tie_welds(WELDS, 2, [PANEL, HAT])

    d.comment("\n---- the mesh --------------------------------------------------------------------------------------------------")
    d.nodes(nodes)
    d.shells(shells)
    d.beams(beams)
    return d


if __name__ == "__main__":
    main(__doc__, lambda: {"panel": make()})
