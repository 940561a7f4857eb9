# SPDX-License-Identifier: Apache-2.0
"""A small welded deck that runs: two sheets of 3 x 3 shells, 1.2 thick, joined by one weld beam; mm, t, s.

The left edge of the lower sheet is held, the right edge of the upper one is pulled. Cards stand before the mesh, so that
a test that edits the mesh does not move the lines of the cards.
"""

CARDS = """\
*KEYWORD
*TITLE
lap joint of two sheets and one weld
*CONTROL_TERMINATION
  2.00e-05
*CONTROL_TIMESTEP
       0.0       0.9
*CONTROL_CONTACT
       0.1
         0
       0.0
         0         0         0         0         1
*DATABASE_GLSTAT
  5.00e-06
*DATABASE_MATSUM
  5.00e-06
*DATABASE_SWFORC
  1.00e-06
*DATABASE_NODOUT
  5.00e-06
*DATABASE_HISTORY_NODE
       216
*DATABASE_BINARY_D3PLOT
  5.00e-06
*PART
lower sheet
         1         1         1
*PART
upper sheet
         2         1         1
*PART
weld
         3         3         3
*SECTION_SHELL
         1         2    0.8333         3
       1.2       1.2       1.2       1.2
*MAT_PIECEWISE_LINEAR_PLASTICITY
         1  7.85e-09  210000.0       0.3     300.0    1000.0
       0.0       0.0


*SECTION_BEAM
         3         9       1.0         2       1.0
       6.0       6.0       0.0       0.0
*MAT_SPOTWELD
         3  7.85e-09  210000.0       0.3     500.0    1000.0
       0.0    8000.0    6000.0    6000.0    9000.0    7000.0    7000.0
*CONTACT_SPOTWELD
         3         1         3         2
       0.0
       1.0
*SET_PART_LIST
         1
         1         2
*DEFINE_CURVE
         1
                 0.0                 0.0
             1.0e-05               500.0
             1.0e-01               500.0
*BOUNDARY_PRESCRIBED_MOTION_SET
         2         1         0         1
*BOUNDARY_SPC_SET
         1         0         1         1         1         1         1         1
*SET_NODE_LIST
         1
       101       105       109       113
*SET_NODE_LIST
         2
       204       208       212       216
"""


def mesh():
    """Both sheets from 0 to 18 in x and y, 1.2 apart; the weld in the middle of the middle element."""
    nodes, shells = [], []
    for part, z in ((1, 0.0), (2, 1.2)):
        for j in range(4):
            for i in range(4):
                nodes.append(f"{100 * part + 4 * j + i + 1:8d}{6.0 * i:16.4f}{6.0 * j:16.4f}{z:16.4f}")
        for j in range(3):
            for i in range(3):
                a = 100 * part + 4 * j + i + 1
                shells.append(f"{10 * part + 3 * j + i:8d}{part:8d}" + "".join(f"{n:8d}" for n in (a, a + 1, a + 5, a + 4)))
    nodes += [f"{301:8d}{9.0:16.4f}{9.0:16.4f}{0.0:16.4f}", f"{302:8d}{9.0:16.4f}{9.0:16.4f}{1.2:16.4f}"]
    return "\n".join(["*NODE", *nodes, "*ELEMENT_SHELL", *shells, "*ELEMENT_BEAM", f"{31:8d}{3:8d}{301:8d}{302:8d}{0:8d}"]) + "\n"


def edited(text, *changes):
    """The text with each (old, new) made, where old must stand in it exactly once."""
    for old, new in changes:
        if text.count(old) != 1:
            raise AssertionError(f"{old!r} stands {text.count(old)} times in the deck, expected once")
        text = text.replace(old, new)
    return text


def deck(*changes):
    return edited(CARDS + mesh() + "*END\n", *changes)
