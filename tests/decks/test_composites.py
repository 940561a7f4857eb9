# SPDX-License-Identifier: Apache-2.0
"""Plates of fibres at angles, of MAT_022, 054, 055 and 058, struck so that plies crack, fibres tear and shells go: the same bits with any number of
threads and lanes and across a restart, and energies that close."""
import unittest

import lsda
from repeated_runs import RepeatedRuns

ELASTIC = "{},1.52e-9,127e3,8.41e3,8.41e3,0.0205,0.0205,0.3\n4.21e3,4.21e3,4.21e3,,{}\n"
LAWS = (("*MAT_022\n" + ELASTIC.format(1, 0) + "\n\n154.0,2200.0,48.9,199.0,1e-9\n"),
        ("*MAT_054\n" + ELASTIC.format(2, 2) + ",,,1.0\n,,,0,1.0,,0.05,0.06\n1e-9,1e-9,0.8,0.5,1.5,0.02,-0.015,0.2\n"
         "1470.0,2200.0,199.0,48.9,154.0,54,0.3\n\n0.1,0.4,0.3,0.5,0.6,30\n"),
        ("*MAT_055\n" + ELASTIC.format(3, 3) + "\n0,1.0,0\n\n1470.0,2200.0,199.0,48.9,154.0,55\n"),
        *("*MAT_058\n{},1.52e-9,127e3,8.41e3,8.41e3,0.0205,{}\n4.21e3,4.21e3,4.21e3,0.05,0.6,0.05,0.6,0.8\n{},0,0.1,1,{}\n,,,1\n,,,0,1\n"
          "0.015,0.02,0.03,0.008,0.08\n1470.0,2200.0,199.0,48.9,100.0\n".format(4 + k, "40.0,0.012" if fs < 0 else "0,0", "2.0" if fs else "0", fs)
          for k, fs in enumerate((-1, 0, 1))))
FORMULATIONS = (2, 16, 17)


def plates(n=4, speed=200000.0):
    """A plate of each law in each formulation, held at one side and struck at its middle."""
    cards = ["*KEYWORD", "*CONTROL_TERMINATION", "4e-4", "*CONTROL_ENERGY", "2,2,2,2", "*DATABASE_GLSTAT", "5e-6", "*DATABASE_BINARY_D3PLOT",
             "5e-5", *LAWS]
    nodes, shells, starts = [], [], []
    for i in range(len(LAWS)):
        for k, elform in enumerate(FORMULATIONS):
            part, first = 10 * (i + 1) + k, len(nodes) + 1
            plies = [(i + 1, 0.3, angle, 0) for angle in (0, 45, -45, 90, 90, 0)]
            lines = ["{},{},{},{},{},{},{},{}".format(*a, *b) for a, b in zip(plies[::2], plies[1::2])]
            cards.append(f"*PART_COMPOSITE\nplate\n{part},{elform}\n" + "\n".join(lines))
            corner = {(a, b): first + a + (n + 1) * b for b in range(n + 1) for a in range(n + 1)}
            for (a, b), node in corner.items():
                nodes.append((node, 60 * i + 10 * a + 1.3 * (b % 2), 60 * k + 10 * b + 0.9 * (a % 2), 0))
                if a == 0:
                    cards.append(f"*BOUNDARY_SPC_NODE\n{node},0,1,1,1,1,1,1")
                elif a >= n // 2:
                    starts.append((node, 0.15 * speed * a / n, 0, speed * (a + b % 2) / n))
            for b in range(n):
                for a in range(n):
                    c = [corner[a, b], corner[a + 1, b], corner[a + 1, b + 1], corner[a, b + 1]]
                    for e in ([[*c[:3], c[2]], [c[0], c[2], c[3], c[3]]] if elform == 17 else [c]):
                        shells.append((len(shells) + 1, part, *e))
    for name, lines in (("NODE", nodes), ("ELEMENT_SHELL", shells), ("INITIAL_VELOCITY_NODE", starts)):
        cards += [f"*{name}", *(",".join(f"{x:.10g}" for x in line) for line in lines)]
    return "\n".join([*(c.rstrip("\n") if c.startswith("*PART") else c.removesuffix("\n") for c in cards), "*END", ""])


class Composites(RepeatedRuns):
    def test_same_bits_and_restart(self):
        self.write(plates(2))
        self.compare("model.k")
        self.resumed(plates(2), shares=(0.3, 0.7))

    def test_energy_closes_while_plies_fail(self):
        self.write(plates())
        self.nugget("run", "model.k", "-o", "run", "--quiet")
        states = self.glstat("run/glstat")
        for state in states:
            self.assertAlmostEqual(state["total energy / initial energy"], 1.0, delta=0.01)
        self.assertGreater(states[-1]["eroded internal energy"], 0.05 * states[-1]["internal energy"])

    def test_layers_beside_a_deleted_shell_are_weaker(self):
        """Three squares pulled along their fibres: 2 shares an edge with 1, which is deleted at the start, 3 stands alone. Sabotage: SOFT of the whole part;
        of no one."""
        nodes = [(10 * x, y) for y in (0, 10, 20, 40, 50) for x in (0, 1)]
        law = "*MAT_054\n1,1.52e-9,127e3,8.41e3,8.41e3,0,0,0\n4.21e3,4.21e3,4.21e3,,2\n,,,1.0\n,,,0,1.0\n1e-12,,0.6\n1470.0,2200.0,199.0,48.9,154.0,54"
        cards = ["*KEYWORD", "*CONTROL_TERMINATION", "1e-3", law, "*SECTION_SHELL\n1,2,,2\n1,1,1,1", "*PART\np\n1,1,1", "*NODE"]
        cards += [f"{k},{x},{y},0" for k, (x, y) in enumerate(nodes, 1)]
        cards += ["*ELEMENT_SHELL", *(f"{e},1,{n},{n + 1},{n + 3},{n + 2}" for e, n in ((1, 1), (2, 3), (3, 7)))]
        for k, (x, _) in enumerate(nodes, 1):
            cards.append(f"*BOUNDARY_SPC_NODE\n{k},0,{int(x == 0)},1,1,1,1,1")
            if x > 0:
                cards.append(f"*BOUNDARY_PRESCRIBED_MOTION_NODE\n{k},1,0,9,250.0")
        cards += ["*DEFINE_CURVE\n9\n0,1\n1,1", "*DEFINE_ELEMENT_DEATH_SHELL\n1,1e-5", "*DATABASE_HISTORY_SHELL\n2,3", "*DATABASE_ELOUT\n1e-6,2", "*END", ""]
        self.write("\n".join(cards))
        self.nugget("run", "model.k", "-o", "run", "--quiet")
        stress = [state["sig_xx"] for state in lsda.states(lsda.read(self.folder / "run" / "binout0000"), "elout/shell")]
        layers = len(stress[0]) // 2
        for first, strength in ((0, 0.6 * 2200.0), (layers, 2200.0)):
            self.assertAlmostEqual(max(max(row[first:first + layers]) for row in stress), strength, delta=0.005 * strength)

    def test_each_strength_is_reached(self):
        """MAT_058: squares pulled, pressed and sheared, along a and across, of two formulations and with each surface: the greatest stress is the strength, and
        in the end what SLIM leaves of it. Sabotage: XC read for XT; E11T without effect; SLIMT1 for SLIMC1."""
        strengths = (2200.0, 1470.0, 60.0, 199.0, 100.0)
        for elform in (2, 16):
            for fs in (-1, 0, 1):
                law = ("*MAT_058\n{},1.52e-9,127e3,8.41e3,8.41e3,0,0,0\n4.21e3,4.21e3,4.21e3,0.1,0.5,0.2,0.6,0.7\n0,0,0,1,{}\n\n,,,,,,{}\n"
                       "0.015,0.02,0.03,0.01,0.03\n1470.0,2200.0,199.0,60.0,100.0")
                cards = ["*KEYWORD", "*CONTROL_TERMINATION", "1e-3", law.format(1, fs, 0), law.format(2, fs, 90), "*DEFINE_CURVE\n9\n0,1\n1,1",
                         f"*SECTION_SHELL\n1,{elform},,3\n1,1,1,1", "*PART\np\n1,1,1", "*PART\nq\n2,1,2", "*DATABASE_HISTORY_SHELL\n1,2,3,4,5", "*DATABASE_ELOUT\n2e-6,2"]
                nodes, elements = [], []
                for e, speed in enumerate((600.0, -600.0, 600.0, -600.0, 1200.0), 1):
                    first, sheared = len(nodes) + 1, e == 5
                    for a, b in ((0, 0), (10, 0), (10, 10), (0, 10)):
                        nodes.append((len(nodes) + 1, 20 * e + a, b, 0))
                        cards.append(f"*BOUNDARY_SPC_NODE\n{len(nodes)},0,{int(a == 0 and not sheared)},{int(sheared)},1,1,1,1")
                        if sheared:
                            cards.append(f"*BOUNDARY_PRESCRIBED_MOTION_NODE\n{len(nodes)},1,0,9,{speed if b else 0.0}")
                        elif a:
                            cards.append(f"*BOUNDARY_PRESCRIBED_MOTION_NODE\n{len(nodes)},1,0,9,{speed}")
                    elements.append((e, 2 if e in (3, 4) else 1, *range(first, first + 4)))
                cards += ["*NODE", *(",".join(map(str, n)) for n in nodes), "*ELEMENT_SHELL", *(",".join(map(str, n)) for n in elements), "*END", ""]
                self.write("\n".join(cards))
                self.nugget("run", "model.k", "-o", "run", "--quiet")
                states = lsda.states(lsda.read(self.folder / "run" / "binout0000"), "elout/shell")
                for e, (strength, left) in enumerate(zip(strengths, (0.1, 0.5, 0.2, 0.6, 0.7))):
                    stress = [abs(state["sig_xy" if e == 4 else "sig_xx"][3 * e]) for state in states]
                    self.assertAlmostEqual(max(stress), strength, delta=0.01 * strength, msg=(elform, fs, e))
                    if e < 4:  # a sheared square turns
                        self.assertAlmostEqual(stress[-1], left * strength, delta=0.02 * strength, msg=(elform, fs, e))

    def test_axes_of_a_coordinate_system(self):
        """Layers of a material whose axes a coordinate system gives, written before and behind it: as with the vectors of AOPT 2, whether the layers are
        those of *PART_COMPOSITE or the angles of a section. Sabotage: layers take the law before it has its axes, and lie along the sides of the shells."""
        system = "*DEFINE_COORDINATE_VECTOR\n7,0.6,0.8,0,-0.8,0.6,0"
        layers = {"composite": "*PART_COMPOSITE\nplate\n1,2\n1,0.3,0,0,1,0.3,45\n1,0.3,-45,0,1,0.3,90",
                  "angles": "*PART\nplate\n1,1,1\n*SECTION_SHELL\n1,2,,4,,,1\n1.2,1.2,1.2,1.2\n0,45,-45,90"}
        for name, part in layers.items():
            found = []
            for aopt, axes, behind in (("2", ",,,0.6,0.8,0", False), ("-7", "", False), ("-7", "", True)):
                law = f"*MAT_022\n1,1.52e-9,127e3,8.41e3,8.41e3,0.0205,0.0205,0.3\n4.21e3,4.21e3,4.21e3,,{aopt}\n{axes}\n\n154.0,2200.0,48.9,199.0,1e-9"
                cards = ["*KEYWORD", "*CONTROL_TERMINATION", "5e-5", "*DATABASE_GLSTAT\n5e-6,2", part, law]
                cards.insert(4 if behind else 6, system)
                cards += ["*NODE", *(f"{1 + a + 4 * b},{10 * a + b},{10 * b},{0.1 * a * b:.2g}" for b in range(4) for a in range(4))]
                cards += ["*ELEMENT_SHELL", *(f"{1 + a + 3 * b},1,{1 + a + 4 * b},{2 + a + 4 * b},{6 + a + 4 * b},{5 + a + 4 * b}" for b in range(3) for a in range(3))]
                cards += ["*INITIAL_VELOCITY_NODE", *(f"{1 + a + 4 * b},{9000 * a},{4000 * b - 3000 * a},{2000 * a * b}" for b in range(4) for a in range(4))]
                self.write("\n".join([*cards, "*END", ""]))
                self.nugget("run", "model.k", "-o", "run", "-j1", "--quiet")
                found.append([state["internal_energy"][0] for state in lsda.states(lsda.read(self.folder / "run" / "binout0000"), "glstat")])
            for other in found[1:]:
                for a, b in zip(found[0], other):
                    self.assertAlmostEqual(a, b, delta=1e-9 * max(found[0]), msg=name)

    def test_modes_are_those_of_the_elastic_plate(self):
        found = []
        for law in (LAWS[0], LAWS[1], LAWS[3].replace("\n4,", "\n1,", 1), "*MAT_002\n" + ELASTIC.format(1, 0) + "\n\n"):
            cards = ["*KEYWORD", "*CONTROL_IMPLICIT_GENERAL\n1,1.0", "*CONTROL_IMPLICIT_EIGENVALUE\n9", law.replace("\n2,", "\n1,", 1).removesuffix("\n"),
                     "*PART_COMPOSITE\nplate\n1,16", "1,0.3,0,0,1,0.3,45", "1,0.3,-45,0,1,0.3,90", "*NODE"]
            cards += [f"{1 + a + 7 * b},{10 * a},{10 * b},0" for b in range(7) for a in range(7)]
            cards += ["*ELEMENT_SHELL", *(f"{1 + a + 6 * b},1,{1 + a + 7 * b},{2 + a + 7 * b},{9 + a + 7 * b},{8 + a + 7 * b}" for b in range(6) for a in range(6))]
            self.write("\n".join([*cards, "*END", ""]))
            self.nugget("modes", "model.k", "-n", 9, "-o", "modes", "--quiet")
            found.append([mode["frequency_hz"] for mode in self.json("modes/summary.json")["modes"]][6:])
        self.assertEqual(len(found[0]), 3)
        for own in found[:3]:
            for value, elastic in zip(own, found[3]):
                self.assertAlmostEqual(value / elastic, 1.0, delta=1e-9)


if __name__ == "__main__":
    unittest.main()
