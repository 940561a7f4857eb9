# SPDX-License-Identifier: Apache-2.0
"""Cards of decks of a few elements, in fixed columns."""

CORNERS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
BRICK = "*ELEMENT_SOLID\n       1       1\n       1       2       3       4       5       6       7       8\n"
SOLID = "*SECTION_SOLID\n         1         1\n"


def card(*fields):
    return "".join(f"{field:>10}" for field in fields) + "\n"


def nodes(places, first=1):
    return "*NODE\n" + "".join(f"{first + i:8}{x:16.9f}{y:16.9f}{z:16.9f}\n" for i, (x, y, z) in enumerate(places))


def curve(identity, *points):
    return "*DEFINE_CURVE\n" + card(identity) + "".join(f"{x:20}{y:20}\n" for x, y in points)


def part(identity, section=1, material=1):
    return "*PART\npart\n" + card(identity, section, material)
