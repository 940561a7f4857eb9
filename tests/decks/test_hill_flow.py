# SPDX-License-Identifier: Apache-2.0
"""MAT_103 with Hill's surface, back stress, curves and rates, in shells and bricks that are thrown to and fro: the same bits with any number of
threads, lanes and ranks and across a restart; the same energies turned, mirrored, far away, in other units and with other numbers."""
import unittest

from repeated_runs import RepeatedRuns
from runs_over_ranks import RunsOverRanks
from struck_patches import StruckPatches
from test_invariance import Cards, Case
from under_mpirun import MPIRUN

END = 2e-4
# first card behind PR, hardening, VK (VM 0.2) and constants, of shells and of bricks
LAWS = (((200, 0, "", ""), (80, 20, 50, 3, 90, 35, 40, 6), 15, (0.7, 1.6, 1.1), (0.35, 0.6, 0.5, 1.2, 1.9, 1.6)),
        (("", 2, 8, ""), (), 15, (1.8, 1.3, 2.2), (0.5, 0.4, 0.6, 1.2, 1.6, 1.4)),
        (("", 1, 8, 0.3), (), 0, ("", "", ""), ("",) * 6),
        (("", 4, 9, ""), (), 0, None, (0.35, 0.6, 0.5, 1.2, 1.9, 1.6)))


def patches(c):
    """A square of each law in shells of ELFORM 2 and 16, and a block in bricks of ELFORM 1 and 2."""
    cards = Cards(c)
    add, node = cards.add, cards.node
    number, vectors = c.first, []
    add("DEFINE_CURVE", (8,), *((e / 50, c.of(200 + 80 * (1 - 2.7182818 ** (-0.4 * e)) + 50 * (1 - 2.7182818 ** (-0.06 * e)), 1, -1, -2)) for e in range(31)))
    add("DEFINE_CURVE", (10,), (0, c.of(250, 1, -1, -2)), (0.1, c.of(330, 1, -1, -2)), (1, c.of(400, 1, -1, -2)))
    add("DEFINE_TABLE_2D", (9,), (c.of(1, 0, 0, -1), 8), (c.of(5000, 0, 0, -1), 10))
    add("HOURGLASS", (7, 4, 0.05))
    for k, elform in enumerate((2, 16)):
        add("SECTION_SHELL", (k + 1, elform, 0.8333, 3), [c.of(1.0, 0, 1)] * 4)
        add("SECTION_SOLID", (k + 3, k + 1))
    a, d = (c.vector(v, 1.0) for v in ((0.6, 0.7, 0.2), (-0.5, 0.6, 0.3)))
    shells, solids = [], []
    for i, (first, hardening, vk, ratios, constants) in enumerate(LAWS):
        for kind, shape in ((0, ratios), (1, constants)):
            if shape is None:
                continue
            material = 10 * (i + 1) + kind
            yield_stress = c.of(first[0], 1, -1, -2) if first[0] else ""
            stresses = [c.of(h, 1, -1, -2) if j % 2 == 0 else h for j, h in enumerate(hardening)]
            viscous = (f"{vk * c.stress * c.time ** 0.2:.16g}", 0.2) if vk else ("", "")
            add("MAT_103", (material, c.of(2.7e-9, 1, -3), c.of(70000, 1, -1, -2), 0.33, yield_stress, *first[1:]), stresses, (*viscous, *shape),
                (2,), ("", "", "", a), ("", "", "", d))
            for k in range(2):
                part = 2 * material + k
                cards.append(f"*PART\npatch\n{part},{1 + k + 2 * kind},{material},0,{7 if kind == 0 or k == 0 else 0}")
                deep = 3 if kind else 1
                at = {(x, y, z): node((40.0 * i + 20.0 * k + 4.0 * x + 0.25 * y, 60.0 * kind + 5.0 * y - 0.5 * x, 4.0 * z + (0.25 * x * y if kind == 0 else 0.5 * x)))
                      for z in range(deep) for y in range(3) for x in range(4)}
                ring = ((0, 0), (0, 1), (1, 1), (1, 0)) if c.mirrored else ((0, 0), (1, 0), (1, 1), (0, 1))
                for z in range(deep - 1 or 1):
                    for y in range(2):
                        for x in range(3):
                            if kind:
                                solids.append((part, *(at[x + u, y + v, z + w] for w in (0, 1) for u, v in ring)))
                            else:
                                shells.append((part, *(at[x + u, y + v, 0] for u, v in ring)))
                vectors += [(n, c.vector((12000.0 * (x - 1.5) + 3000.0 * y, 9000.0 * (1 - y) * (x - 1), 6000.0 * (z - 1) + 4000.0 * (x * y % 3 - 1)), c.velocity))
                            for (x, y, z), n in at.items()]
    add("ELEMENT_SHELL", *((number + e, *row) for e, row in enumerate(shells)))
    add("ELEMENT_SOLID", *((number + 1000 + e, *row) for e, row in enumerate(solids)))
    add("INITIAL_VELOCITY_NODE", *vectors)
    return cards.text(END, "GLSTAT", "MATSUM", "ELOUT").replace("*NODE\n", "*DATABASE_BINARY_D3PLOT\n" + c.of(END / 4, 0, 0, 1) + "\n*NODE\n", 1)


class HillFlow(StruckPatches, RepeatedRuns):
    patches = staticmethod(patches)


@unittest.skipUnless(MPIRUN, "mpirun is not installed")
class HillFlowOverRanks(RunsOverRanks):
    def test_ranks(self):
        self.compare_ranks(patches(Case()))


if __name__ == "__main__":
    unittest.main()
