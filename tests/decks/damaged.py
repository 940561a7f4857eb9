# SPDX-License-Identifier: Apache-2.0
"""Decks whose elements or weld are damaged, for what shows it."""
from few_elements import card
from lap_joint import deck


def sheets(histories=3, law=True):
    """A shell of 1 mm with GISSMO's damage D = (p / 0.4)^2, pulled at 1000 of its lengths a second; without `law` whole."""
    fields = lambda *values: card(*values)  # noqa: E731
    gissmo = ("*MAT_ADD_DAMAGE_GISSMO\n" + fields(1, "", 1) + fields(11, 0.2, 2.0, "", 1.0) + fields("") + "*DEFINE_CURVE\n"
              + fields(11) + f"{0:20}{0.4:20}\n{1:20}{0.4:20}\n")
    corners = ((1, 0, 0), (2, 4, 0), (3, 4, 4), (4, 0, 4))
    return ("*KEYWORD\n*MAT_024\n" + fields(1, 7.85e-9, 210000.0, 0.3, 250.0) + "\n\n\n" + (gissmo if law else "")
            + "*SECTION_SHELL\n" + fields(1, 2, "", 3) + fields(*[1.0] * 4) + "*PART\nstrip\n" + fields(1, 1, 1) + "*NODE\n"
            + "".join(f"{n:8}{x:16}{y:16}{0:16}\n" for n, x, y in corners) + "*ELEMENT_SHELL\n"
            + "".join(f"{n:8}" for n in (1, 1, 1, 2, 3, 4)) + "\n*BOUNDARY_SPC_NODE\n"
            + "".join(fields(n, 0, int(n in (1, 4)), int(n in (1, 2)), 1, 1, 1, 1) for n in (1, 2, 3, 4))
            + "*DEFINE_CURVE\n" + fields(99) + f"{0:20}{1:20}\n{1:20}{1:20}\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n"
            + "".join(fields(n, 1, 0, 99, 4000.0) for n in (2, 3)) + "*CONTROL_TERMINATION\n" + fields(3e-4)
            + "*DATABASE_BINARY_D3PLOT\n" + fields(1e-4) + "*DATABASE_EXTENT_BINARY\n" + fields(0, histories, 3) + "*END\n")


def weld():
    """The lap joint, whose weld reaches its strength at once and fades over 1e-4: it is damaged at the end, not failed."""
    return deck(("*MAT_SPOTWELD\n", "*MAT_SPOTWELD_DAMAGE-FAILURE\n"),
                ("       0.0    8000.0    6000.0    6000.0    9000.0    7000.0    7000.0\n",
                 "       0.0      80.0      60.0      60.0    9000.0    7000.0    7000.0\n"
                 + card("1.0e-4", "0.0", "", "", "", "", "", 12)))
