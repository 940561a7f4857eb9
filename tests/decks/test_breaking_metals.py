# SPDX-License-Identifier: Apache-2.0
"""Sheets and blocks of MAT_089, 105, 107 and 124, and blocks of 061, torn: the same bits with any number of threads and lanes and across a restart, and
energies that close."""
import unittest

from repeated_runs import RepeatedRuns

LAWS = ("*MAT_105\n1,7.85e-9,2.1e5,0.3,300.0,500.0,0,0\n40.0,5.0\n0.01,0.05,0.4\n\n",
        "*MAT_107\n2,7.85e-9,2.1e5,0.3,,0.9,4.52e8\n5e-4,293.0,1800.0,,0,1\n400.0,200.0,0.4,0.012,1.0\n50.0,30.0\n1.0,60.0\n1700.0,1e4",
        "*MAT_061\n3,7.85e-9,2.0e4,4.0e3,1.0e3,2e-5,1",
        "*MAT_124\n4,7.85e-9,2.1e5,0.3,,,0.2\n21,22,23,24\n100.0,50.0\n*DEFINE_CURVE\n21\n0,500\n1,900\n*DEFINE_CURVE\n22\n0,300\n1,700\n"
        "*DEFINE_CURVE\n23\n0,1\n20000,1.5\n*DEFINE_CURVE\n24\n0,1\n1000,1.2\n50000,1.4",
        "*MAT_089\n5,7.85e-9,2.1e5,0.3\n,,25\n0,0,0,26\n*DEFINE_CURVE\n25\n0,0\n0.002,400\n0.1,500\n1,900\n*DEFINE_CURVE\n26\n0,0.3\n15,0.15")
SECTIONS = ((1, "SHELL", 2, (1, 2, 4, 5)), (2, "SHELL", 16, (1, 2, 4, 5)), (3, "SOLID", 1, (1, 2, 3, 4, 5)), (4, "SOLID", 2, (1, 2, 3, 4, 5)))


def torn(n=3, speed=150000.0):
    """A bar of n x 2 elements of each law in each element, held at one end and pulled at the other, with a twist."""
    cards = ["*KEYWORD", "*CONTROL_TERMINATION", "8e-5", "*CONTROL_ENERGY", "2,2,2,2", "*DATABASE_GLSTAT", "2e-6", "*DATABASE_BINARY_D3PLOT", "2e-5",
             *LAWS, ""]
    nodes, elements, starts, held = [], {"SHELL": [], "SOLID": []}, [], []
    for section, kind, elform, materials in SECTIONS:
        cards.append(f"*SECTION_{kind}\n{section},{elform}" + (",0.8333,3\n1.0,1.0,1.0,1.0" if kind == "SHELL" else ""))
        for material in materials:
            part, at, levels = 10 * section + material, {}, 1 if kind == "SHELL" else 2
            cards.append(f"*PART\nbar\n{part},{section},{material}")
            for c in range(levels):
                for b in range(3):
                    for a in range(n + 1):
                        at[a, b, c] = len(nodes) + 1
                        nodes.append((len(nodes) + 1, 20 * section + 2 * a + 0.1 * b, 20 * material + 2 * b + 0.2 * (a % 2), 2.0 * c))
                        if a == 0:
                            held.append(at[a, b, c])
                        else:
                            starts.append((at[a, b, c], speed * a / n, 0.1 * speed * (b - 1), 0.1 * speed * (c - 0.5) * a / n))
            for b in range(2):
                for a in range(n):
                    low, high = ([at[a, b, c], at[a + 1, b, c], at[a + 1, b + 1, c], at[a, b + 1, c]] for c in (0, levels - 1))
                    elements[kind].append((sum(map(len, elements.values())) + 1, part, *low, *(high if kind == "SOLID" else ())))
    cards += [f"*BOUNDARY_SPC_NODE\n{node},0,1,1,1,1,1,1" for node in held]
    for name, rows in (("NODE", nodes), ("ELEMENT_SHELL", elements["SHELL"]), ("ELEMENT_SOLID", elements["SOLID"]), ("INITIAL_VELOCITY_NODE", starts)):
        cards += [f"*{name}", *(",".join(f"{x:.10g}" for x in row) for row in rows)]
    return "\n".join([*(c[:-1] if c.endswith("\n") and "MAT_105" not in c else c for c in cards if c), "*END", ""])


class BreakingMetals(RepeatedRuns):
    def test_same_bits_and_restart(self):
        self.write(torn())
        self.compare("model.k")
        self.resumed(torn(), shares=(0.3, 0.7))

    def test_energy_closes(self):
        self.write(torn(5))
        self.nugget("run", "model.k", "-o", "run", "--quiet")
        states = self.glstat("run/glstat")
        for state in states:
            self.assertAlmostEqual(state["total energy / initial energy"], 1.0, delta=0.01)
        self.assertGreater(states[-1]["eroded internal energy"], 0.05 * states[-1]["internal energy"])


if __name__ == "__main__":
    unittest.main()
