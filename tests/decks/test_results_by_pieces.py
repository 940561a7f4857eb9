# SPDX-License-Identifier: Apache-2.0
"""d3plot and elout of several ranks: the first one writes what the others give it piece by piece, with the bytes of one process, and no rank holds a
state of the whole; what happens when the disk is full or the folder is lost; histories that are due when nothing of elements is."""
import random
import re
import shutil
import subprocess
import time
import unittest

from few_elements import card, curve
from nugget_command import NUGGET
from repeated_runs import DATE, FOREVER, RepeatedRuns, with_lanes
from shared_out import block, tube, weak_double_hat
from test_restart_by_pieces import sheets
from test_thick_shells import plate
from under_mpirun import ENVIRONMENT, MPIRUN, mpirun, ranks_in


def of_all(text, *kinds):
    """elout of all elements of these kinds in place of some."""
    for number, kind in enumerate(kinds, 9001):
        text = re.sub(rf"\*DATABASE_HISTORY_{kind}\n[^*]*", "", text)
        histories = f"*DATABASE_HISTORY_{kind}_SET\n" + card(number) + f"*SET_{kind}_GENERAL\n" + card(number) + "ALL\n"
        text = text.replace("*END", histories + "*END")
    return text


def without(text, *names):
    for name in names:
        text, count = re.subn(rf"\*DATABASE_{name}\n(?:\$.*\n)*[^*]*", "", text)
        assert count, name
    return text


def results_of_sheets(along, across, *, d3plot=None, elout=None, nodout=None, alike=False):
    """The sheets of the restart files with histories of all shells, and of all nodes where nodout is asked for. `d3plot`: an interval; `elout`, `nodout`:
    1 text, 2 binout, 3 both, at the start and the end. No two elements or nodes have the same results, unless they are `alike`, which is read with less
    memory."""
    files = ("*DATABASE_BINARY_D3PLOT\n" + card(d3plot) if d3plot else "") + ("*DATABASE_ELOUT\n" + card(1.0, elout) if elout else "")
    files += "*DATABASE_NODOUT\n" + card(1.0, nodout) if nodout else ""
    draw = random.Random(2)
    files += "" if alike else "*INITIAL_VELOCITY_NODE\n" + "".join(card(n, *(round(draw.uniform(-5e3, 5e3), 1) for _ in range(3))) for n in range(1, 2 * (along + 1) * (across + 1) + 1))
    return of_all(sheets(along, across).replace("*END", files + "*END"), "SHELL", *(["NODE"] if nodout else []))


def truss(n=40):
    """Discrete beams between a net of shells and held nodes above it, a cross section through the net."""
    draw = random.Random(4)
    number = lambda i, j: 1 + i + (n + 1) * j  # noqa: E731
    places = [(5.0 * i, 5.0 * j, 0.2 * draw.random()) for j in range(n + 1) for i in range(n + 1)]
    shells = [(number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)) for j in range(n) for i in range(n)]
    beams = [(number(i, j), len(places) + 1 + k) for k, (i, j) in enumerate((i, j) for j in range(0, n, 4) for i in range(0, n, 4))]
    places += [(places[a - 1][0] + 1.0, places[a - 1][1], 10.0) for a, _ in beams]
    text = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(4e-4) + "".join(f"*DATABASE_{name}\n" + card(1e-5, 3) for name in ("GLSTAT", "DISBOUT", "SECFORC", "ELOUT"))
    text += "*MAT_ELASTIC\n" + card(1, 7.85e-9, 2.1e5, 0.3) + "*SECTION_SHELL\n" + card(1, 2) + card(1.0, 1.0, 1.0, 1.0) + "*PART\nnet\n" + card(1, 1, 1)
    text += "*MAT_074\n" + card(2, 1e-9, 500.0) + "\n*SECTION_BEAM\n" + card(2, 6, 1.0, 2, 0, 2.0) + card(1e-2, 1e-2, 0) + "*PART\nsprings\n" + card(2, 2, 2)
    text += "*NODE\n" + "".join(f"{k:8}{x:16.6f}{y:16.6f}{z:16.6f}\n" for k, (x, y, z) in enumerate(places, 1))
    text += "*ELEMENT_SHELL\n" + "".join(f"{e:8}{1:8}" + "".join(f"{m:8}" for m in q) + "\n" for e, q in enumerate(shells, 1))
    text += "*ELEMENT_BEAM\n" + "".join(f"{9000 + e:8}{2:8}{a:8}{b:8}\n" for e, (a, b) in enumerate(beams, 1))
    text += "*BOUNDARY_SPC_NODE\n" + "".join(card(b, 0, 1, 1, 1, 1, 1, 1) for _, b in beams)
    text += "*INITIAL_VELOCITY_NODE\n" + "".join(card(k, 0.0, 0.0, -1e4) for k in range(1, (n + 1) ** 2 + 1))
    cut = [number(i, n // 2) for i in range(n + 1)]
    text += "*SET_NODE_LIST\n" + card(7) + "".join(card(*cut[k:k + 8]) for k in range(0, len(cut), 8))
    below = [1 + i + n * (n // 2 - 1) for i in range(n)]
    text += "*SET_SHELL_LIST\n" + card(8) + "".join(card(*below[k:k + 8]) for k in range(0, n, 8)) + "*DATABASE_CROSS_SECTION_SET\n" + card(7, "", "", 8)
    return of_all(text + curve(80, (0.0, 1e-6), (9.0, 1e-6)) + "*CONTROL_TIMESTEP\n" + card(0, 0.9, 0, 0, 0, 80) + "*END\n", "BEAM")


@unittest.skipUnless(MPIRUN, "mpirun is not installed")
class ResultsByPieces(RepeatedRuns):
    def over(self, ranks, *arguments, threads=1, expect=0, full=None):
        """`full`: a rank for which no file may be longer than so many kilobytes: (rank, kilobytes)."""
        command = mpirun(ranks, *arguments, "-j", threads, "--quiet")
        if full:
            limit = ["bash", "-c", f'trap "" XFSZ; [ $OMPI_COMM_WORLD_RANK = {full[0]} ] && ulimit -f {full[1]}; exec "$@"', "_", NUGGET]
            command = [word for each in command for word in (limit if each == NUGGET else [each])]
        run = subprocess.run(command, capture_output=True, text=True, timeout=280, cwd=self.folder, env=dict(ENVIRONMENT, NUGGET_LANES="4"))
        self.assertEqual(run.returncode, expect, f"{ranks} ranks: {arguments}\n{run.stderr}\n{run.stdout}")
        self.assertEqual(ranks_in(self.folder), [])
        return run

    def alone(self, model, *options, folder="one"):
        self.nugget("run", model, "-o", folder, "-j", 1, "--quiet", *options, env=with_lanes(4))
        return self.bits(folder)

    def same(self, folder, reference, what):
        bits = self.bits(folder)
        self.assertEqual(sorted(bits), sorted(reference))
        for name, content in bits.items():
            self.assertTrue(content == reference[name], f"{name} differs: {what}")

    def double_hat(self):
        """With welds of bricks that fail, and shells that do."""
        text, steel = weak_double_hat(self.folder), "         1  7.85e-09  210000.0       0.3\n"
        self.assertIn(steel, text)
        text = text.replace(steel, steel[:-1] + "       0.0       0.0      0.02\n")
        bricks = "*CONTROL_SPOTWELD_BEAM\n         0         0         0         0         0         4\n*DATABASE_ELOUT\n" + card(2.0e-5, 3)
        return of_all(text.replace("*CONTROL_TERMINATION\n", bricks + "*CONTROL_TERMINATION\n"), "SHELL", "SOLID")

    def test_the_bytes_of_one_process(self):
        """Elements that are deleted, under mass scaling, of every kind, welds that fail; d3plot and elout of all. Sabotage: pieces in the order of ranks; one
        at the place of another; strains, or a deletion, of an element that another rank computes."""
        cases = {"tube": (of_all(tube(fail=0.02, mass_step=-1.0e-6, end=8.0e-4), "SHELL"), (), [(n, t) for n in (2, 3, 4, 7) for t in (1, 2)]),
                 "all nodes": (of_all(tube(48, 30, end=2.0e-4).replace("*END", "*CONTROL_OUTPUT\n,,,1\n*END"), "NODE"), (), ((2, 1), (3, 2))),
                 "bricks": (of_all(block(8), "SOLID", "BEAM"), (), ((2, 2), (3, 1))),
                 "ten nodes": (of_all(block(5, elform=2), "SOLID"), (), ((3, 1),)),
                 "thick shells": (plate(12).replace("*END", "*DATABASE_HISTORY_TSHELL\n" + "".join(card(*range(k, k + 8)) for k in range(1, 121, 8)) + "*END"), (),
                                  ((2, 1), (4, 1))),
                 "discrete beams": (truss(), (), ((2, 1), (3, 1))),
                 "double hat": (self.double_hat(), ("--until", "2.4e-4"), ((4, 1),))}
        for name, (text, options, forms) in cases.items():
            model = self.write(text)
            reference = self.alone(model, *options)
            for ranks, threads in forms:
                with self.subTest(name, ranks=ranks, threads=threads):
                    self.over(ranks, "run", model, "-o", "some", *options, threads=threads)
                    self.same("some", reference, f"{name}, {ranks} ranks of {threads} threads")
                    shutil.rmtree(self.folder / "some")
            if name == "tube":
                self.assertRegex(self.read("one/run.log"), r"part 1: \d\d of 720 elements deleted")
                self.assertGreater(len(reference["elout"]), 40 * 720 * 300)
            if name == "double hat":
                self.assertRegex(self.read("one/run.log"), r"spotweld \w+ failed")
                self.assertRegex(self.read("one/run.log"), r"part \d: \d+ of \d+ elements deleted")

    def test_states_of_several_pieces(self):
        """26,400 shells: a state has pieces of a mebibyte, elout blocks of 1,024 rows. Sabotage: the second piece at the place of the first."""
        model = self.write(results_of_sheets(110, 120, d3plot=1.0e-9, elout=3, nodout=3))
        options = ("--max-cycles", 12)
        reference = self.alone(model, *options)
        self.assertGreater(len(reference["d3plot01"]), 4e6)
        for ranks, threads in ((1, 2), (2, 1), (3, 2), (4, 1), (7, 1)):
            with self.subTest(ranks=ranks, threads=threads):
                self.over(ranks, "run", model, "-o", "some", *options, threads=threads)
                self.same("some", reference, f"{ranks} ranks of {threads} threads")

    def test_histories_without_elements(self):
        """What is due when neither d3plot nor elout is comes to the first rank by itself: reactions beside a balance of energies, lengths of welds at the
        start. Sabotage: reactions of which only the energy is sent; lengths before anybody has found them."""
        hat = without(self.double_hat(), "ELOUT", "BINARY_D3PLOT")
        for name, text, options in (("tube", without(tube(), "ELOUT", "SECFORC", "BINARY_D3PLOT"), ()), ("double hat", hat, ("--until", "1.0e-4"))):
            with self.subTest(name):
                model = self.write(text)
                reference = self.alone(model, *options)
                self.assertLessEqual({"spcforc", "bndout"} if name == "tube" else {"swforc", "rwforc"}, set(reference))
                for ranks in (3, 4):
                    self.over(ranks, "run", model, "-o", "some", *options)
                    self.same("some", reference, f"{name}, {ranks} ranks")

    def test_other_numbers_of_ranks_go_on(self):
        """With rotations of nodes that only some ranks follow, added up from the start on. Sabotage: those of the rank that reads."""
        model = self.write(of_all(tube(48, 30, fail=0.02, mass_step=-1.0e-6, end=8.0e-4), "SHELL", "NODE"))
        whole = self.alone(model)
        self.over(3, "run", model, "-o", "cut", "--checkpoint", "100cycles", "--max-cycles", 130)
        self.over(2, "run", "--resume", "cut", "--max-cycles", 230)
        self.nugget("run", "--resume", "cut", "-j", 2, "--quiet", "--max-cycles", 330, env=with_lanes(4))
        self.over(4, "run", "--resume", "cut", *FOREVER)
        self.assertEqual(self.read("cut/run.log").count("Resumed from a restart file"), 3)
        self.same_but_restart("cut", whole)

    def same_but_restart(self, folder, whole):
        for name, content in self.bits(folder).items():
            if not name.startswith("restart"):
                self.assertTrue(content == whole[name], name)

    def test_no_rank_holds_a_state_of_the_whole(self):
        """The most memory of each of three ranks, with d3plot and elout of 72,000 shells and without. Sabotage: states that come to the first rank; rows of
        all elements before any is written."""
        peaks, size = {}, {}
        for name, wanted in (("plain", {}), ("d3plot", {"d3plot": 1.0e-9}), ("text", {"elout": 1}), ("binout", {"elout": 2}),
                             ("nodes", {"nodout": 3})):
            self.write(results_of_sheets(300, 120, alike=True, **wanted))
            self.over(3, "run", "model.k", "-o", name, "--max-cycles", 5)
            peaks[name] = [rank["peak_memory_mb"] for rank in self.json(f"{name}/summary.json")["rank"]]
            size[name] = sum(f.stat().st_size for f in (self.folder / name).iterdir() if re.match("d3plot0|elout|binout|nodout", f.name)) / 1e6
        print(f"files of {size} MB; most memory of ranks [MB]: {peaks}")
        for name, states in (("d3plot", 6), ("text", 2), ("binout", 2), ("nodes", 2)):
            state = size[name] / states
            self.assertGreater(state, 10.0)
            for plain, with_file in zip(peaks["plain"], peaks[name]):
                self.assertLess(with_file, plain + 0.6 * state, name)

    def test_the_disk_is_full(self):
        """Of the first rank: all end with the message and the code of one process, and what was whole before is there. Other ranks write nothing, so their
        disk may be full. Sabotage: a piece that counts before its state is whole; a rank that waits for one that has left."""
        for name, wanted in (("d3plot01", {"d3plot": 1.0e-9}), ("elout", {"elout": 1}), ("binout0000", {"elout": 2})):
            with self.subTest(name):
                model = self.write(results_of_sheets(110, 60, **wanted))
                options = ("--max-cycles", 3)
                reference = self.alone(model, *options)
                kilobytes = int(0.7 * len(reference[name])) // 1024
                run = self.over(3, "run", model, "-o", "out", *options, full=(0, kilobytes), expect=4)
                self.assertIn(f"nugget: cannot write out/{name}: File too large\n", run.stderr)
                self.assertIn("E r r o r   t e r m i n a t i o n", self.read("out/run.log"))
                left = DATE.sub(b"date", (self.folder / "out" / name).read_bytes())
                self.assertGreater(len(left), 0.3 * len(reference[name]))
                if name == "elout":
                    self.assertTrue(reference[name].startswith(left))
                    self.assertEqual(left.count(b"s t r e s s   c a l c u l a t i o n s"), 1)
                shutil.rmtree(self.folder / "out")
                self.over(3, "run", model, "-o", "out", *options, full=(1, 1))
                self.same("out", reference, "a rank whose disk is full")
                shutil.rmtree(self.folder / "out")

    def test_a_folder_that_only_the_first_rank_sees(self):
        model = self.write(of_all(tube(), "SHELL"))
        reference = self.alone(model)
        (self.folder / "elsewhere").mkdir()
        place = ["bash", "-c", f'[ $OMPI_COMM_WORLD_RANK != 0 ] && cd {self.folder}/elsewhere; exec "$@"', "_", NUGGET]
        command = [word for each in mpirun(3, "run", model, "-o", "out", "-j", 1, "--quiet") for word in (place if each == NUGGET else [each])]
        run = subprocess.run(command, capture_output=True, text=True, timeout=120, cwd=self.folder, env=dict(ENVIRONMENT, NUGGET_LANES="4"))
        self.assertEqual(run.returncode, 0, run.stderr)
        self.same("out", reference, "ranks that do not see the folder")
        self.assertEqual(list((self.folder / "elsewhere").iterdir()), [])

    def test_a_folder_that_is_lost(self):
        """It is removed while three ranks run."""
        self.write(of_all(tube(end=1.0).replace(card(0.25), card(1.0e-6)), "SHELL"))
        command = mpirun(3, "run", "model.k", "-o", "out", "-j", 1, "--quiet")
        with subprocess.Popen(command, cwd=self.folder, env=ENVIRONMENT, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as run:
            deadline = time.monotonic() + 60
            while not (self.folder / "out" / "d3plot01").exists():
                self.assertLess(time.monotonic(), deadline)
                time.sleep(0.05)
            shutil.rmtree(self.folder / "out", ignore_errors=True)
            said = run.communicate(timeout=60)[1]
        self.assertEqual(run.returncode, 4, said)
        self.assertRegex(said, r"nugget: cannot write out/\w+: ")
        self.assertEqual(ranks_in(self.folder), [])


if __name__ == "__main__":
    unittest.main()
