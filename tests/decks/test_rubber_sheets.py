# SPDX-License-Identifier: Apache-2.0
"""Sheets of rubber, of every law and shell, thrown apart so that they stretch far: the same bits with any number of threads and lanes and across
a restart, and energies that close at steps that follow the stiffness reached."""
import random
import unittest

from repeated_runs import RepeatedRuns


def nominal(factor):
    return "\n".join(f"{l - 1.0:.6f},{factor * (l * l - 1.0 / l) * (0.4 + 0.1 / l) / l:.9f}" for l in (0.4 + 0.05 * k for k in range(60)))


LAWS = ("*MAT_027\n{},1.2e-9,0.49,0.4,0.1\n\n", "*MAT_007\n{},1.2e-9,1.0\n", "*MAT_077_H\n{},1.2e-9,0.49\n0.4,0.1\n",
        "*MAT_077_O\n{},1.2e-9,0.49\n0.3\n4.0\n", "*MAT_181\n{},1.2e-9,50.0\n1,1,1,7\n",
        # over the rate, with less on the way back; as foam; a series that relaxes
        "*MAT_181\n{},1.2e-9,50.0\n1,1,1,9\n0,0.5\n", "*MAT_181\n{},1.2e-9,50.0\n1,1,1,9,,,,0.3\n", "*MAT_076\n{},1.2e-9,50.0\n\n0.4,0\n0.6,5000\n")
FORMULATIONS = (2, 4, 5, 9, 16, 17)


def sheets(n=3, speed=30000.0):
    """A small square of each law in each formulation, side by side."""
    chance = random.Random(3)
    cards = ["*KEYWORD", "*CONTROL_TERMINATION", "6e-4", "*CONTROL_SHELL", ",,,1", "*CONTROL_ENERGY", "2,2,2,2", "*DATABASE_GLSTAT", "2e-5",
             "*DATABASE_BINARY_D3PLOT", "2e-4", f"*DEFINE_CURVE\n7\n{nominal(2.0)}", f"*DEFINE_CURVE\n8\n{nominal(3.0)}",
             "*DEFINE_TABLE_2D\n9\n10.0,7\n10000.0,8"]
    nodes, elements, starts = [], [], []
    for i, law in enumerate(LAWS):
        cards.append(law.format(i + 1).rstrip("\n") + ("\n" if "027" not in law else "\n\n"))
    for k, elform in enumerate(FORMULATIONS):
        cards.append(f"*SECTION_SHELL\n{k + 1},{elform},0.8333,3\n1.0,1.0,1.0,1.0")
    for i in range(len(LAWS)):
        for k, elform in enumerate(FORMULATIONS):
            part, first = 10 * (i + 1) + k, len(nodes) + 1
            cards.append(f"*PART\nsheet\n{part},{k + 1},{i + 1}")
            for b in range(n + 1):
                for a in range(n + 1):
                    nodes.append((40 * i + 5 * a + chance.uniform(-1, 1), 40 * k + 5 * b + chance.uniform(-1, 1), 0.3 * chance.random()))
                    starts.append([speed * (2 * a / n - 1) + 3000 * chance.random(), speed * (1 - 1.4 * b / n), 3000 * chance.random()])
            for b in range(n):
                for a in range(n):
                    c = [first + a + (n + 1) * b, first + a + 1 + (n + 1) * b, first + a + 1 + (n + 1) * (b + 1), first + a + (n + 1) * (b + 1)]
                    for corners in ([[*c[:3], c[2]], [c[0], c[2], c[3], c[3]]] if elform in (4, 17) else [c]):
                        elements.append((len(elements) + 1, part, *corners))
    rows = {"NODE": [(j + 1, *x) for j, x in enumerate(nodes)], "ELEMENT_SHELL": elements,
            "INITIAL_VELOCITY_NODE": [(j + 1, *v) for j, v in enumerate(starts)]}
    cards += ["\n".join([f"*{name}", *(",".join(f"{x:.10g}" for x in row) for row in lines)]) for name, lines in rows.items()]
    return "\n".join([*cards, "*END", ""])


class RubberSheets(RepeatedRuns):
    def test_same_bits_and_restart(self):
        self.write(sheets(2))
        self.compare("model.k")
        self.resumed(sheets(2), shares=(0.3, 0.7))

    def test_energy_closes_far_from_rest(self):
        self.write(sheets())
        self.nugget("run", "model.k", "-o", "run", "--quiet")
        states = self.glstat("run/glstat")
        for state in states:
            self.assertAlmostEqual(state["total energy / initial energy"], 1.0, delta=0.01)
        # Most of the motion has become stretch at some time: a law that is linear, or a step too long, would not close.
        self.assertGreater(max(s["internal energy"] for s in states), 0.25 * states[0]["kinetic energy"])


if __name__ == "__main__":
    unittest.main()
