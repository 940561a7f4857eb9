# SPDX-License-Identifier: Apache-2.0
"""`nugget modes --drop-weld` and `--compare` on two strips with three welds."""
import csv
import struct
import unittest

from nugget_command import CommandTest

CARDS = """\
*KEYWORD
*CONTROL_TERMINATION
       1.0
*PART
lower
         1         1         1
*PART
upper
         2         1         1
*PART
weld
         3         3         3
*SECTION_SHELL
         1        16  0.833333         3
       1.5       1.5       1.5       1.5
*MAT_ELASTIC
         1  7.85e-09  210000.0       0.3
*SECTION_BEAM
         3         9       1.0         2       1.0
       6.0       6.0
*MAT_SPOTWELD
         3  7.85e-09  210000.0       0.3     400.0    1000.0

*CONTACT_SPOTWELD
         3         1         3         2


*SET_PART_LIST
         1
         1         2
"""


def strips(places=(30.0, 90.0, 150.0), along=27, across=3):
    """Two strips 180 x 20 of that many shells with welds at the places along them."""
    nodes, shells, beams = [], [], []
    for part in (1, 2):
        first = 1000 * part
        row = along + 1
        for j in range(across + 1):
            for i in range(row):
                nodes.append(f"{first + row * j + i:8d}{180 / along * i:16.6f}{20 / across * j:16.6f}{1.5 * (part - 1):16.6f}")
        for j in range(across):
            for i in range(along):
                a = first + row * j + i
                shells.append(f"{first + along * j + i:8d}{part:8d}{a:8d}{a + 1:8d}{a + row + 1:8d}{a + row:8d}")
    for x in places:
        weld = 5000 + int(x)
        nodes += [f"{weld:8d}{x:16.6f}{10.0:16.6f}{0.0:16.6f}", f"{weld + 500:8d}{x:16.6f}{10.0:16.6f}{1.5:16.6f}"]
        beams.append(f"{weld:8d}{3:8d}{weld:8d}{weld + 500:8d}")
    nodes.sort()
    return "\n".join([CARDS + "*NODE", *nodes, "*ELEMENT_SHELL", *shells, "*ELEMENT_BEAM", *beams, "*END"]) + "\n"


def in_double_precision(folder, words):
    """A d3eigv family rewritten with words of 8 bytes, as LS-DYNA leaves it in double precision."""
    data = (folder / "d3eigv").read_bytes()
    control = struct.unpack("<64i", data[:256])
    nodes, solids, beams, shells, numbering = control[16], control[23], control[28], control[31], control[39]
    whole = control[10:14] + struct.unpack("<i", struct.pack("<i", 0)) + control[15:]
    out = b" " * 80 + struct.pack(f"<{len(whole)}q", *whole)
    out += struct.pack(f"<{3 * nodes}d", *struct.unpack(f"<{3 * nodes}f", data[256:256 + 12 * nodes]))
    rest = 9 * solids + 6 * beams + 5 * shells + numbering
    begin = 256 + 12 * nodes
    out += struct.pack(f"<{rest}q", *struct.unpack(f"<{rest}i", data[begin:begin + 4 * rest]))
    words.mkdir()
    (words / "d3eigv").write_bytes(out)
    for path in folder.glob("d3eigv[0-9]*"):
        data = path.read_bytes()
        (words / path.name).write_bytes(struct.pack(f"<{len(data) // 4}d", *struct.unpack(f"<{len(data) // 4}f", data)))


class ModeStudies(CommandTest):
    def frequencies(self, folder):
        return [mode["frequency_hz"] for mode in self.json(f"{folder}/summary.json")["modes"]]

    def test_every_weld_on_its_own(self):
        self.write(strips())
        run = self.nugget("modes", "model.k", "-n", 12, "-o", "all", "--drop-weld", "all", "--quiet")
        self.assertIn("Welds by the mode that falls most", run.stdout)
        drops = self.json("all/summary.json")["drop_weld"]
        self.assertEqual(sorted(drop["welds"][0] for drop in drops), [5030, 5090, 5150])
        falls = [drop["without_hz"] / drop["frequency_hz"] for drop in drops]
        self.assertEqual(falls, sorted(falls))
        for drop in drops:  # all three were solved anew, being the worst three
            self.assertAlmostEqual(drop["without_hz"] / drop["solved_hz"], 1.0, delta=2e-3)
        with open(self.folder / "all" / "weld_drop.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 3 * 6)  # six of the twelve are rigid motions

    def test_welds_of_a_stretched_strip(self):
        """Preload by stress (IGS 1): estimates without a weld against solving anew, which differ from those at rest."""
        clamped = "*BOUNDARY_SPC_NODE\n" + "".join(
            f"{1000 * part + 28 * j + i:10d}{0:10d}" + 6 * "         1" + "\n"
            for part in (1, 2) for j in range(4) for i in (0, 27))
        stress = "".join(f"{e:10d}{1:10d}{1:10d}\n{0.0:10.1f}{400.0:10.1f}\n" for e in range(1000, 1081))
        preload = ("*CONTROL_IMPLICIT_GENERAL\n         1       1.0         2         1         1\n"
                   "*CONTROL_IMPLICIT_EIGENVALUE\n        12\n*INITIAL_STRESS_SHELL\n" + stress)
        found = {}
        for name, cards in (("rest", ""), ("stretched", preload)):
            self.write(strips().replace("*SET_PART_LIST", clamped + cards + "*SET_PART_LIST", 1))
            self.nugget("modes", "model.k", "-n", 12, "-o", name, "--drop-weld", "all", "--quiet")
            found[name] = self.json(f"{name}/summary.json")
        drops = found["stretched"]["drop_weld"]
        self.assertEqual(len(drops), 3)
        for drop in drops:
            self.assertAlmostEqual(drop["without_hz"] / drop["solved_hz"], 1.0, delta=2e-3)
        bending = [found[name]["modes"][0]["frequency_hz"] for name in ("rest", "stretched")]
        self.assertGreater(bending[1], 1.05 * bending[0])

    def test_welds_together_are_as_the_deck_without_them(self):
        self.write(strips())
        self.write(strips((90.0,)), "fewer.k")
        self.nugget("modes", "model.k", "-n", 12, "-o", "drop", "--drop-weld", "5030,5150", "--quiet")
        self.nugget("modes", "fewer.k", "-n", 12, "-o", "fewer", "--quiet")
        solved = {}
        with open(self.folder / "drop" / "weld_drop.csv", newline="", encoding="utf-8") as file:
            for row in csv.DictReader(file):
                self.assertEqual(row["weld"], "5030+5150")
                if row["solved"]:
                    solved[row["mode"]] = float(row["solved"])
        fewer = self.frequencies("fewer")
        self.assertTrue(solved)
        for frequency in solved.values():
            self.assertLess(min(abs(frequency / f - 1.0) for f in fewer if f > 1.0), 1e-6)

    def test_the_least_welds_that_keep_the_first_mode(self):
        """Of seven welds; against decks that never had the welds that went: the first frequency, and that none more can go.

        Sabotage that this catches: a search that goes on below the share, that stops early, or that names other welds than it solved."""
        places = (15.0, 45.0, 75.0, 90.0, 105.0, 135.0, 165.0)
        self.write(strips(places))
        self.nugget("modes", "model.k", "-n", 12, "-o", "search", "--least-welds", 0.9, "--quiet")
        whole = self.frequencies("search")[6]
        with open(self.folder / "search" / "least_welds.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(sorted(int(r["weld"]) for r in rows), [5000 + int(x) for x in places])
        left = [float(r["weld"]) - 5000.0 for r in rows if r["goes"] == "no"]
        last = [float(r["first_frequency"]) for r in rows if r["goes"] == "yes"][-1]
        self.assertLess(len(left), len(places))

        def first(remaining):
            self.write(strips(tuple(sorted(remaining))), "fewer.k")
            self.nugget("modes", "fewer.k", "-n", 9, "-o", "fewer", "--quiet")
            return next((f for f in self.frequencies("fewer")[6:7] if f > 1.0), 0.0)

        self.assertAlmostEqual(first(left) / last, 1.0, 6)
        self.assertGreaterEqual(last, 0.9 * whole)
        for x in left:
            self.assertLess(first([y for y in left if y != x]), 0.9 * whole)
        self.nugget("modes", "model.k", "--least-welds", 1.5, expect=2)
        self.assertIn("--least-welds", self.nugget("modes", "model.k", "--fmin", 10.0, "--least-welds", 0.9, expect=2).stderr)

    def test_comparison_with_another_run(self):
        self.write(strips())
        self.write(strips((90.0,)), "fewer.k")
        self.nugget("modes", "model.k", "-n", 12, "-o", "whole", "--quiet")
        run = self.nugget("modes", "fewer.k", "-n", 12, "-o", "fewer", "--compare", "whole", "--quiet")
        self.assertIn("Compared with whole over 226 nodes", run.stdout)
        in_double_precision(self.folder / "whole", self.folder / "double")
        self.nugget("modes", "model.k", "-n", 12, "-o", "same", "--compare", "double", "--quiet")
        with open(self.folder / "same" / "mac.csv", newline="", encoding="utf-8") as file:
            table = list(csv.reader(file))
        self.assertEqual(len(table), 2 + 12)
        for i in range(6, 12):
            self.assertAlmostEqual(float(table[2 + i][2 + i]), 1.0, delta=1e-4)
            self.assertAlmostEqual(float(table[1][2 + i]) / float(table[2 + i][1]), 1.0, delta=1e-6)

    def test_what_cannot_be_done_is_said(self):
        self.write(strips())
        for words, complaint in (
                (["--drop-weld", "17"], "there is no weld 17"),
                (["--drop-weld", "5030,x"], "'x' is no weld"),
                (["--drop-weld", "all", "--fmin", "10"], "it needs the lowest modes"),
                (["--compare", "nowhere"], "nowhere/d3eigv is not there")):
            run = self.nugget("modes", "model.k", "-n", 8, "-o", "out", *words, "--quiet", expect=2)
            self.assertIn(complaint, run.stderr)
        (self.folder / "bad").mkdir()
        (self.folder / "bad" / "d3eigv").write_bytes(b"no d3eigv" * 100)
        run = self.nugget("modes", "model.k", "-n", 8, "-o", "out", "--compare", "bad", "--quiet", expect=2)
        self.assertIn("is not a d3eigv", run.stderr)


if __name__ == "__main__":
    unittest.main()
