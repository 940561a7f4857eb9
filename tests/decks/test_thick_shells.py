# SPDX-License-Identifier: Apache-2.0
"""A plate of thick shells that is hit and flows: the same bytes with any number of threads, lanes and ranks and across a restart; what
d3plot and elout have of it; what is refused."""
import random
import struct
import subprocess
import unittest

from few_elements import CORNERS, card, nodes, part
from repeated_runs import RepeatedRuns
from under_mpirun import ENVIRONMENT, MPIRUN, mpirun

STEEL = "*MAT_PIECEWISE_LINEAR_PLASTICITY\n" + card(1, 7.85e-9, 2.1e5, 0.3, 250.0, 1000.0, 0.4) + card(40.0, 5.0) + card(0.0) + card(0.0)


def plate(n=8, *, layers=3, speed=60000.0, end=1.2e-4, contact=True, fail=True, elform=5):
    """n x n thick shells of 5 mm, 1.5 mm thick, with noise in their nodes and a wedge at a corner, held at the rim; a block of bricks
    flies into it, or its own middle does."""
    draw = random.Random(9)
    size, thick = 5.0, 1.5
    number = lambda i, j, k: 1 + i + (n + 1) * (j + (n + 1) * k)  # noqa: E731
    places = [(size * i + 0.5 * draw.uniform(-1, 1), size * j + 0.5 * draw.uniform(-1, 1), thick * k) for k in (0, 1) for j in range(n + 1) for i in range(n + 1)]
    cells = [[number(i + a, j + b, k) for a, b, k in CORNERS] for j in range(n) for i in range(n)]
    first = cells.pop(0)
    cells += [[first[1], first[2], first[3], first[3], first[5], first[6], first[7], first[7]]]
    rim = [number(i, j, k) for k in (0, 1) for j in range(n + 1) for i in range(n + 1) if i in (0, n) or j in (0, n)]
    middle = [number(i, j, k) for k in (0, 1) for j in range(n // 2 - 1, n // 2 + 2) for i in range(n // 2 - 1, n // 2 + 2)]
    text = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(end) + "*CONTROL_ENERGY\n" + card(2, 2, 2, 2)
    text += "".join(f"*DATABASE_{name}\n" + card(end / 20, 3) for name in ("GLSTAT", "MATSUM", "NODOUT", "ELOUT"))
    text += "*DATABASE_BINARY_D3PLOT\n" + card(end / 4) + "*DATABASE_EXTENT_BINARY\n" + card("", "", "", 1)
    text += (STEEL if fail else STEEL.replace(f"{0.4:>10}", f"{0.0:>10}")) + "*SECTION_TSHELL\n" + card(1, elform, "", layers) + part(1)
    text += "*SET_NODE_LIST\n" + card(1) + "".join(card(*rim[k:k + 8]) for k in range(0, len(rim), 8)) + "*BOUNDARY_SPC_SET\n" + card(1, 0, 1, 1, 1)
    text += "*DATABASE_HISTORY_TSHELL\n" + card(n * n // 2 + n // 2, n * n) + "*DATABASE_HISTORY_NODE\n" + card(middle[0])
    bricks = []
    if contact:
        text += "*MAT_ELASTIC\n" + card(2, 7.85e-8, 2.1e5, 0.3) + "*SECTION_SOLID\n" + card(2, 1) + part(2, 2, 2)
        own = lambda i, j, k: len(places) + 1 + i + 3 * (j + 3 * k)  # noqa: E731
        bricks = [[own(i + a, j + b, k + c) for a, b, c in CORNERS] for k in range(2) for j in range(2) for i in range(2)]
        places += [(0.4 * n * size + 4.0 * i, 0.4 * n * size + 4.0 * j, thick + 0.1 + 4.0 * k + 0.2 * i) for k in range(3) for j in range(3) for i in range(3)]
        text += "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n" + card(0) + card(0.1, 0.1) + "\n*INITIAL_VELOCITY_GENERATION\n" + card(2, 2, 0.0, 0.0, 0.0, -speed) + "\n"
    else:
        text += "*INITIAL_VELOCITY_NODE\n" + "".join(card(i, 0.0, 0.0, -speed) for i in middle)
    text += nodes(places) + "*ELEMENT_TSHELL\n" + "".join(f"{e:8}{1:8}" + "".join(f"{i:8}" for i in q) + "\n" for e, q in enumerate(cells, 1))
    if bricks:
        text += "*ELEMENT_SOLID\n" + "".join(f"{e:8}{2:8}" + "".join(f"{i:8}" for i in q) + "\n" for e, q in enumerate(bricks, 501))
    return text + "*END\n"


def thick_layers(folder, thick_shell):
    """Stresses and plastic strains of the layers of a thick shell in the last whole state of d3plot01, by the words that the head counts."""
    head = (folder / "d3plot").read_bytes()
    word = lambda i: struct.unpack_from("<i", head, 4 * i)[0]  # noqa: E731
    names = {16: "nodes", 18: "globals", 23: "solids", 27: "of_solid", 28: "beams", 30: "of_beam", 31: "shells", 33: "of_shell", 36: "maxint", 40: "thick", 42: "of_thick"}
    c = {name: word(i) for i, name in names.items()}
    state = 1 + c["globals"] + 9 * c["nodes"] + c["solids"] * (c["of_solid"] + 1) + c["thick"] * (c["of_thick"] + 1)
    assert c["beams"] == c["shells"] == 0 and c["maxint"] == -10003
    data = (folder / "d3plot01").read_bytes()
    count = 0
    while struct.unpack_from("<f", data, 4 * state * count)[0] != -999999.0:
        count += 1
    begin = state * (count - 1) + 1 + c["globals"] + 9 * c["nodes"] + c["solids"] * c["of_solid"] + thick_shell * c["of_thick"]
    numbers = struct.unpack_from(f"<{c['of_thick']}f", data, 4 * begin)
    return [numbers[7 * k:7 * k + 7] for k in range(3)], numbers[21:]


class ThickShells(RepeatedRuns):
    def test_same_bits_and_restart(self):
        for elform in (5, 1, 2, 3):
            with self.subTest(elform):
                self.write(plate(elform=elform))
                files = self.compare("model.k")
                self.assertLessEqual({"d3plot", "d3plot01", "glstat", "matsum", "elout", "nodout"}, set(files))
                self.resumed(plate(elform=elform), shares=(0.3, 0.7))

    @unittest.skipUnless(MPIRUN, "mpirun is not installed")
    def test_same_bits_over_ranks(self):
        for elform, ranks in ((5, 2), (1, 3), (2, 3), (3, 3)):
            with self.subTest(elform):
                self.write(plate(contact=False, layers=5, elform=elform))
                self.nugget("run", "model.k", "-o", "one", "-j", 1, "--quiet")
                run = subprocess.run(mpirun(ranks, "run", "model.k", "-o", "some", "-j", 1, "--quiet"), capture_output=True, text=True,
                                     timeout=200, cwd=self.folder, env=ENVIRONMENT)
                self.assertEqual(run.returncode, 0, run.stderr + run.stdout)
                self.assertEqual(self.bits("one"), self.bits("some"))

    def test_energy_closes(self):
        for elform in (5, 1, 2, 3):
            with self.subTest(elform):
                self.write(plate(fail=False, elform=elform))
                self.nugget("run", "model.k", "-o", "run", "--quiet")
                states = self.glstat("run/glstat")
                for state in states:
                    self.assertAlmostEqual(state["total energy / initial energy"], 1.0, delta=0.01)
                self.assertGreater(states[-1]["internal energy"], 0.2 * states[0]["kinetic energy"])
                self.assertIn("thk shell", self.read("run/glstat"))

    def test_d3plot_has_the_layers_of_elout(self):
        for elform in (5, 1, 2, 3):
            with self.subTest(elform):
                self.compare_d3plot_with_elout(elform)

    def compare_d3plot_with_elout(self, elform):
        self.write(plate(fail=False, elform=elform))
        self.nugget("run", "model.k", "-o", "run", "--quiet")
        number = 36  # the middle one, 8 x 8 elements
        layers, strains = thick_layers(self.folder / "run", number - 1)
        text = self.read("run/elout").split("e l e m e n t")[-1]
        stress, strain = text.split("strains (global)")
        rows = stress.split(f"{number:8}-{1:7}\n")[1].splitlines()[:3]
        listed = [[float(x) for x in row.split()[3 if "- " in row else 2:]][:6] for row in rows]
        for layer, row in zip(layers, (1, 0, 2)):  # middle, bottom, top
            for ours, theirs in zip(layer, listed[row]):
                self.assertAlmostEqual(ours, theirs, delta=1e-3 * abs(theirs) + 1e-3)
        self.assertGreater(layers[1][6], 0.0)  # it has flowed
        lower = [float(x) for x in strain.split(f"{number:8}-{1:7}\n")[1].splitlines()[0].split("ipt")[1].split()]
        for ours, theirs in zip(strains[:6], lower):
            self.assertAlmostEqual(ours, theirs, delta=1e-3 * abs(theirs) + 1e-6)

    def test_what_is_not_built_is_refused(self):
        for old, new, words in (("*SECTION_TSHELL\n" + card(1, 5, "", 3), "*SECTION_TSHELL\n" + card(1, 6, "", 3), "thick shells of ELFORM 6 are not built"),
                                ("*SECTION_TSHELL\n" + card(1, 5, "", 3), "*SECTION_TSHELL\n" + card(1, 7, "", 3), "thick shells of ELFORM 7 are not built"),
                                ("*END", "*SET_TSHELL_LIST\n" + card(1) + card(1) + "*END", "SET_TSHELL"),
                                ("*END", "*INITIAL_STRESS_SOLID\n" + card(1, 1) + card(*7 * [1.0]) + "*END", "thick shells begin without stress")):
            with self.subTest(words):
                text = plate(4)
                self.assertIn(old, text)
                self.write(text.replace(old, new))
                run = self.nugget("check", "model.k", expect=1)
                self.assertIn(words, run.stdout + run.stderr)

    def test_a_law_of_other_shells_is_one_error(self):
        """Thick shells say which laws they take; that they are solids inside is not said beside it."""
        text = plate(4)
        begin, end = text.index("*MAT_PIECEWISE"), text.index("*SECTION_TSHELL")
        hill = "*MAT_HILL_3R\n1,7.85e-9,2.1e5,0.3,1,1000,250\n1.2,0.8,1.5\n2\n,,,1\n0,0,0,0,1\n"
        self.write(text[:begin] + hill + text[end:])
        said = self.nugget("check", "model.k", expect=1).stderr
        self.assertIn("*MAT_HILL_3R is not built for thick shells", said)
        self.assertNotIn("but the part has solids", said)


if __name__ == "__main__":
    unittest.main()
