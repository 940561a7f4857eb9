# SPDX-License-Identifier: Apache-2.0
"""The generators write what they say: legal columns, unique ids, welds where they belong, the same bytes each time."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).parent


def generate(name):
    """{deck name: its text}"""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.executable, str(HERE / name / "make.py"), folder], check=True)
        return {path.stem: path.read_text(encoding="ascii") for path in sorted(pathlib.Path(folder).glob("*.k"))}


class Mesh:
    """Nodes, shells and beams, read back from their columns."""

    def __init__(self, text):
        self.nodes, self.shells, self.beams = {}, {}, {}
        keyword = ""
        for line in text.splitlines():
            if line.startswith("*"):
                keyword = line[1:]
            elif keyword == "NODE" and not line.startswith("$"):
                self.add(self.nodes, line[:8], [float(line[8 + 16 * i : 24 + 16 * i]) for i in range(3)])
            elif keyword in ("ELEMENT_SHELL", "ELEMENT_BEAM") and not line.startswith("$"):
                table = self.shells if keyword == "ELEMENT_SHELL" else self.beams
                self.add(table, line[:8], [int(line[i : i + 8]) for i in range(8, len(line), 8)])

    @staticmethod
    def add(table, text, value):
        if int(text) in table:
            raise AssertionError(f"id {text} twice")
        table[int(text)] = value

    def corners(self, shell):
        return [self.nodes[n] for n in self.shells[shell][1:5]]

    def sides(self, shell):
        a, b, c, d = self.corners(shell)
        return [length(minus(b, a)), length(minus(c, b)), length(minus(d, c)), length(minus(a, d))]

    def shells_at(self, point):
        """[(part, a, b)]: rectangular shells that hold the point, with its coordinates 0..1 along their first two sides."""
        found = []
        for shell, (part, *_) in self.shells.items():
            origin, right, _, up = self.corners(shell)
            e, f, r = minus(right, origin), minus(up, origin), minus(point, origin)
            a, b = dot(r, e) / dot(e, e), dot(r, f) / dot(f, f)
            off = length(minus(r, [a * x + b * y for x, y in zip(e, f)]))
            if off < 1e-6 and -1e-9 <= a <= 1 + 1e-9 and -1e-9 <= b <= 1 + 1e-9:
                found.append((part, a, b))
        return found


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def length(a):
    return dot(a, a) ** 0.5


class Examples(unittest.TestCase):
    def check_text(self, text):
        lines = text.splitlines()
        self.assertEqual((lines[0], lines[-1]), ("*KEYWORD", "*END"))
        for number, line in enumerate(lines, start=1):
            if not line.startswith("$"):
                self.assertLessEqual(len(line), 80, f"line {number}")

    def test_the_same_bytes_each_time(self):
        for name in ("double_hat", "weld_placement", "talk", "tube_crush", "hat_crush", "weld_bond"):
            self.assertEqual(generate(name), generate(name))

    def test_double_hat(self):
        (text,) = generate("double_hat").values()
        self.check_text(text)
        mesh = Mesh(text)
        self.assertTrue(5000 <= len(mesh.shells) <= 15000, len(mesh.shells))
        self.assertTrue(40 <= len(mesh.beams) <= 80, len(mesh.beams))
        for shell in mesh.shells:
            if mesh.shells[shell][0] in (1, 2):
                self.assertTrue(all(3.5 < side < 6.5 for side in mesh.sides(shell)), f"shell {shell}")
        for part, upper, lower, _ in mesh.beams.values():
            self.assertEqual(part, 4)
            self.assertEqual({p for p, _, _ in mesh.shells_at(mesh.nodes[upper])}, {1})
            self.assertEqual({p for p, _, _ in mesh.shells_at(mesh.nodes[lower])}, {2})
            self.assertTrue(all(node not in shell for shell in mesh.shells.values() for node in (upper, lower)))

    def test_crushed_columns(self):
        for name, parts in (("tube_crush", {1}), ("hat_crush", {1, 3})):
            for case, text in generate(name).items():
                self.check_text(text)
                mesh = Mesh(text)
                self.assertEqual({shell[0] for shell in mesh.shells.values()}, parts | {2}, case)
                for part, upper, lower, _ in mesh.beams.values():
                    self.assertEqual({p for p, _, _ in mesh.shells_at(mesh.nodes[upper])}, {1}, case)
                    self.assertEqual({p for p, _, _ in mesh.shells_at(mesh.nodes[lower])}, {3}, case)

    def test_weld_placement(self):
        decks = generate("weld_placement")
        shared = {"centre": 1, "edge": 2, "corner": 4}  # how many shells of a strip hold the weld node
        self.assertEqual(set(decks), set(shared))
        for case, text in decks.items():
            self.check_text(text)
            mesh = Mesh(text)
            ((_, upper, lower, _),) = mesh.beams.values()
            for node, part in ((upper, 1), (lower, 2)):
                under = mesh.shells_at(mesh.nodes[node])
                self.assertEqual([p for p, _, _ in under], [part] * shared[case], case)
                if case == "centre":
                    self.assertAlmostEqual(under[0][1], 0.5, 6)
                    self.assertAlmostEqual(under[0][2], 0.5, 6)
            self.assertTrue(all(2.5 < side < 6.5 for shell in mesh.shells for side in mesh.sides(shell)), case)


@unittest.skipUnless("NUGGET" in os.environ, "set NUGGET to the program to run the decks")
class Runs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def nugget(self, *arguments):
        run = subprocess.run([os.environ["NUGGET"], *map(str, arguments)], capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run.stderr

    def test_no_deck_gives_a_warning(self):
        for name in ("double_hat", "weld_placement", "tube_crush", "hat_crush", "weld_bond"):
            for case, text in generate(name).items():
                deck = self.folder / f"{case}.k"
                deck.write_text(text, encoding="ascii")
                self.assertNotIn("warning", self.nugget("check", deck, "-o", self.folder / case), case)

    def test_the_rail_starts_with_all_its_energy(self):
        (text,) = generate("double_hat").values()
        deck = self.folder / "double_hat.k"
        deck.write_text(text, encoding="ascii")
        self.nugget("run", deck, "-o", self.folder, "--until", "2e-4", "--quiet")
        summary = json.loads((self.folder / "summary.json").read_text(encoding="utf-8"))
        self.assertAlmostEqual(summary["energy"]["ratio"], 1.0, 3)
        self.assertGreater(summary["energy"]["internal"], 0.01 * summary["energy"]["initial"])
        self.assertEqual(sum(weld["tied"] for weld in summary["weld"]), 40)

    def test_the_first_fold_of_a_tube(self):
        deck = self.folder / "tube_5.k"
        deck.write_text(generate("tube_crush")["tube_5"], encoding="ascii")
        self.nugget("run", deck, "-o", self.folder, "--until", "2e-3", "--quiet")  # 10 mm
        energy = json.loads((self.folder / "summary.json").read_text(encoding="utf-8"))["energy"]
        self.assertAlmostEqual(energy["ratio"], 1.0, 2)
        self.assertLess(energy["hourglass"], 0.05 * energy["internal"])
        # Half a peak force and more, half the mean one and more; less than squashing the whole section at yield.
        self.assertTrue(0.5 * 28400 * 10 < energy["internal"] < 300 * 300 * 10, energy)

    def test_a_weld_over_the_centre_is_as_stiff_as_one_of_solids(self):
        for case, text in generate("weld_placement").items():
            deck = self.folder / f"{case}.k"
            deck.write_text(text, encoding="ascii")
            self.nugget("run", deck, "-o", self.folder / case, "--quiet")
        table = subprocess.run([sys.executable, str(HERE / "weld_placement" / "compare.py"), str(self.folder)],
                               check=True, capture_output=True, text=True).stdout
        share = {line.split()[0]: float(line.split()[2]) for line in table.splitlines()[2:5]}
        self.assertTrue(95.0 <= share["centre"] <= 105.0, table)
        self.assertTrue(share["corner"] < share["edge"] - 10.0 < share["centre"] - 20.0, table)

    def test_a_bonded_lap_bears_its_strength_times_its_area(self):
        """20 MPa on 14 x 38 mm while the adhesive yields, 2 % more by what the overlap bends; then it parts."""
        subprocess.run([sys.executable, str(HERE / "weld_bond" / "make.py"), str(self.folder)], check=True)
        sys.path.insert(0, str(HERE / "weld_bond"))
        import study
        self.nugget("run", self.folder / "lap_bonded.k", "-o", self.folder / "bonded", "--quiet")
        points = study.forces(self.folder / "bonded")
        self.assertAlmostEqual(max(force for _, force in points) / (20e-3 * 14.0 * 38.0), 1.0, delta=0.03)
        self.assertLess(max(force for pull, force in points if pull > 1.5), 1.0)
        self.nugget("check", self.folder / "modes" / "hat_both.k", "-o", self.folder / "hat")
        for deck in (self.folder / "laws").glob("*.k"):
            self.assertNotIn("warning", self.nugget("check", deck, "-o", self.folder / deck.stem), deck.stem)

    def test_the_weld_can_be_placed_by_the_program(self):
        make = HERE / "weld_placement" / "make.py"
        subprocess.run([sys.executable, str(make), str(self.folder)], check=True)
        placed = self.folder / "placed"
        self.nugget("weld", placed / "points.csv", placed / "sheets.k", "-o", placed / "welded.k", "--material",
                    "sigy=2000,nrr=9000,nrs=9000,nrt=9000")
        for deck in (placed / "welded.k", self.folder / "centre.k"):
            self.nugget("run", deck, "-o", self.folder / deck.stem, "--until", "1e-3", "--quiet")
        ours, theirs = (json.loads((self.folder / name / "summary.json").read_text(encoding="utf-8"))["weld"][0]
                        for name in ("welded", "centre"))
        self.assertEqual(ours["diameter"], theirs["diameter"])
        self.assertEqual(ours["length"], theirs["length"])
        self.assertAlmostEqual(ours["peak"]["shear"] / theirs["peak"]["shear"], 1.0, 6)



class FirstJoint(unittest.TestCase):
    def check(self, text, folder):
        (pathlib.Path(folder) / "joint.k").write_text(text, encoding="ascii")
        run = subprocess.run([os.environ["NUGGET"], "check", "joint.k"], cwd=folder, capture_output=True, text=True)
        return run.returncode, run.stderr

    def test_three_mistakes_and_no_other(self):
        text = generate("first_joint")["joint"]
        with tempfile.TemporaryDirectory() as folder:
            code, said = self.check(text, folder)
            self.assertEqual(code, 1)
            self.assertIn("material 4 is not defined", said)
            self.assertIn("no end time is given", said)
            self.assertIn("node 9004 at (57.5, 27.5, 12)", said)
            self.assertIn("2 errors", said)
            lines = text.splitlines()
            lines[32] = lines[32][:29] + "1"
            lines[6] = "     0.002"
            lines = [line.replace("12.000000", " 1.200000") if line.startswith("    9004") else line for line in lines]
            code, said = self.check("\n".join(lines) + "\n", folder)
            self.assertEqual(code, 0, said)
            self.assertNotIn("warning", said)


if __name__ == "__main__":
    unittest.main()
