# SPDX-License-Identifier: Apache-2.0
"""Sheets and blocks of MAT_089, 105, 107, 124 and 224, and blocks of 061, torn: the same bits with any number of threads and lanes and across a restart, and
energies that close."""
import unittest

import lsda
from repeated_runs import RepeatedRuns

LAWS = ("*MAT_105\n1,7.85e-9,2.1e5,0.3,300.0,500.0,0,0\n40.0,5.0\n0.01,0.05,0.4\n\n",
        "*MAT_107\n2,7.85e-9,2.1e5,0.3,,0.9,4.52e8\n5e-4,293.0,1800.0,,0,1\n400.0,200.0,0.4,0.012,1.0\n50.0,30.0\n1.0,60.0\n1700.0,1e4",
        "*MAT_061\n3,7.85e-9,2.0e4,4.0e3,1.0e3,2e-5,1",
        "*MAT_124\n4,7.85e-9,2.1e5,0.3,,,0.2\n21,22,23,24\n100.0,50.0\n*DEFINE_CURVE\n21\n0,500\n1,900\n*DEFINE_CURVE\n22\n0,300\n1,700\n"
        "*DEFINE_CURVE\n23\n0,1\n20000,1.5\n*DEFINE_CURVE\n24\n0,1\n1000,1.2\n50000,1.4",
        "*MAT_089\n5,7.85e-9,2.1e5,0.3\n,,25\n0,0,0,26\n*DEFINE_CURVE\n25\n0,0\n0.002,400\n0.1,500\n1,900\n*DEFINE_CURVE\n26\n0,0.3\n15,0.15",
        "*MAT_224\n6,7.85e-9,2.1e5,0.3,4.52e8,293.0,0.9,2\n60,63,66,69,70,71\n*DEFINE_TABLE\n60\n1\n100000\n*DEFINE_CURVE\n61\n0,400\n1,800\n"
        "*DEFINE_CURVE\n62\n0,500\n1,900\n*DEFINE_TABLE\n63\n293\n793\n*DEFINE_CURVE\n64\n0,1\n*DEFINE_CURVE\n65\n0,0.5\n*DEFINE_TABLE\n66\n-1\n1\n"
        "*DEFINE_CURVE\n67\n-0.6667,0.1\n0.3333,0.5\n*DEFINE_CURVE\n68\n-0.6667,0.15\n-0.3333,0.2\n0.3333,0.6\n*DEFINE_CURVE\n69\n0,1\n50000,0.8\n"
        "*DEFINE_CURVE\n70\n293,1\n793,2\n*DEFINE_CURVE\n71\n1,1.2\n3,0.8")
SECTIONS = ((1, "SHELL", 2, (1, 2, 4, 5, 6)), (2, "SHELL", 16, (1, 2, 4, 5, 6)), (3, "SOLID", 1, (1, 2, 3, 4, 5, 6)), (4, "SOLID", 2, (1, 2, 3, 4, 5, 6)))


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

    def test_strain_at_failure_of_tables(self):
        """MAT_224: squares and cubes of three sizes, pulled slowly: the plastic strain at which each fails is LCF's of uniaxial tension, written at -1/3, times
        LCI's of its side. Sabotage: LCF read at +1/3; LCI without the element's size; NUMINT not obeyed."""
        law = ("*MAT_TABULATED_JOHNSON_COOK\n1,7.85e-9,2.1e5,0.3,,,,1\n11,0,12,0,0,13\n*DEFINE_CURVE\n11\n0,400\n1,500\n"
               "*DEFINE_CURVE\n12\n-0.6667,0.2\n-0.3333,0.25\n0.3333,0.8\n*DEFINE_CURVE\n13\n1,1.2\n5,0.4")
        for kind, elform in (("SHELL", 2), ("SHELL", 16), ("SOLID", 1), ("SOLID", 2), ("SOLID", -1)):
            section = f"*SECTION_{kind}\n1,{elform}" + (",0.8333,3\n1.0,1.0,1.0,1.0" if kind == "SHELL" else "")
            cards = ["*KEYWORD", "*CONTROL_TERMINATION", "1e-3", law, section, "*PART\np\n1,1,1", "*DEFINE_CURVE\n9\n0,1\n1,1",
                     f"*DATABASE_HISTORY_{kind}\n1,2,3", "*DATABASE_ELOUT\n1e-6,2"]
            nodes, elements = [], []
            for e, side in enumerate((1.0, 2.0, 4.0), 1):
                first, levels = len(nodes) + 1, 2 if kind == "SOLID" else 1
                for c in range(levels):
                    for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                        nodes.append((len(nodes) + 1, 20 * e + side * a, side * b, side * c))
                        cards.append(f"*BOUNDARY_SPC_NODE\n{len(nodes)},0,{1 - a},{1 - b},{1 - c},1,1,1")
                        if a:
                            cards.append(f"*BOUNDARY_PRESCRIBED_MOTION_NODE\n{len(nodes)},1,0,9,{500.0 * side}")
                elements.append((e, 1, *range(first, len(nodes) + 1)))
            cards += ["*NODE", *(",".join(f"{x:.10g}" for x in row) for row in nodes), f"*ELEMENT_{kind}", *(",".join(map(str, row)) for row in elements), "*END", ""]
            self.write("\n".join(cards))
            self.nugget("run", "model.k", "-o", "run", "--quiet")
            found = [state["plastic_strain" if kind == "SHELL" else "yield"] for state in lsda.states(lsda.read(self.folder / "run" / "binout0000"), f"elout/{kind.lower()}")]
            per = max(len(row) for row in found) // 3
            for e, factor in enumerate((1.2, 1.0, 0.6)):
                last = max(max(row[per * e:per * (e + 1)]) for row in found if len(row) == 3 * per)
                self.assertAlmostEqual(last, 0.25 * factor, delta=0.004, msg=(kind, elform, e))


if __name__ == "__main__":
    unittest.main()
