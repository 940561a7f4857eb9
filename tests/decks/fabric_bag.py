# SPDX-License-Identifier: Apache-2.0
"""A square bag of two sheets of fabric that share their edges, filled by *AIRBAG_WANG_NEFSKE; mm, t, s."""
from few_elements import card, curve

AMBIENT, DENSITY, CV, CP, FLOW, TEMPERATURE = 0.1, 1.2e-12, 7.175e8, 1.0045e9, 2e-4, 400.0


def pillow(n=8, *, elform=9, side=200.0, end=4e-3, cse=1, form=0, turned=(), more=""):
    """`turned`: shells whose nodes run the other way round."""
    inner = [(i, j) for j in range(1, n) for i in range(1, n)]
    number = {}
    text = "*NODE\n"
    for level, z in ((0, 0.0), (1, 1.0), (2, -1.0)):
        for j in range(n + 1):
            for i in range(n + 1):
                if ((i, j) in inner) == (level > 0):
                    number[i, j, level] = len(number) + 1
                    text += f"{len(number):8}{side * i / n:16.9f}{side * j / n:16.9f}{z:16.9f}\n"
    at = lambda i, j, level: number.get((i, j, level)) or number[i, j, 0]  # noqa: E731
    shells = []
    for level in (1, 2):
        for j in range(n):
            for i in range(n):
                q = [at(i, j, level), at(i + 1, j, level), at(i + 1, j + 1, level), at(i, j + 1, level)]
                shells.append(q if level == 1 else q[::-1])
    text += "*ELEMENT_SHELL\n"
    for e, q in enumerate(shells, 1):
        text += "".join(f"{k:8}" for k in (e, 1, *(q[::-1] if e in turned else q))) + "\n"
    return ("*KEYWORD\n*CONTROL_TERMINATION\n" + card(end) + "*DATABASE_GLSTAT\n" + card(1e-4) + "*DATABASE_ABSTAT\n" + card(1e-4, 3)
            + "*DATABASE_BINARY_D3PLOT\n" + card(end / 4) + "*PART\nbag\n" + card(1, 1, 1) + "*SECTION_SHELL\n" + card(1, elform, "", 4)
            + card(0.3, 0.3, 0.3, 0.3) + "*MAT_FABRIC\n" + card(1, 1e-9, 400.0, 300.0, "", 0.2) + card(20.0, "", "", cse, "", "", "", 0.05)
            + card(0, "", "", "", "", form) + card("") + card("") + "*SET_PART_LIST\n" + card(1) + card(1)
            + "*AIRBAG_WANG_NEFSKE_ID\n" + card(7) + card(1, 1) + card(f"{CV:.5g}", f"{CP:.5g}", TEMPERATURE, 0, 3) + card("") + card(AMBIENT, DENSITY, 1.0)
            + card("") + curve(3, (0.0, FLOW), (1.0, FLOW)) + more + text + "*END\n")
