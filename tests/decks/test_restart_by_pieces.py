# SPDX-License-Identifier: Apache-2.0
"""Restart files of several ranks: they are written without a rank that holds the state of another one, with the bytes of one process, and each rank takes
its share of one; what happens when the disk is full."""
import re
import subprocess
import sys
import unittest

from few_elements import card
from lap_joint import deck as lap_joint
from nugget_command import NUGGET, SOURCE
from repeated_runs import FOREVER, RepeatedRuns, with_lanes
from shared_out import block, tube
from under_mpirun import ENVIRONMENT, MPIRUN, mpirun, ranks_in

STEEL = "*MAT_PIECEWISE_LINEAR_PLASTICITY\n" + card(1, 7.85e-9, 2.1e5, 0.3, 250.0, 1000.0, 0.0) + card(40.0, 5.0) + card(0.0) + card(0.0)


def sheets(along=300, across=120):
    """Two wavy sheets in contact, of which one comes down: 72,000 shells, no results of elements."""
    nodes, shells = [], []
    for part, z in ((1, 0.0), (2, 1.2)):
        first = 1 + len(nodes)
        nodes += [(5.0 * i, 5.0 * j, z + 0.2 * ((7 * i + 3 * j) % 5)) for j in range(across + 1) for i in range(along + 1)]
        corner = [first + j * (along + 1) + i for j in range(across) for i in range(along)]
        shells += [(part, n, n + 1, n + along + 2, n + along + 1) for n in corner]
    return ("*KEYWORD\n*CONTROL_TERMINATION\n" + card(1.0e-3) + "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n" + card(0) + card(0.1, 0.1) + card(0)
            + "*INITIAL_VELOCITY_GENERATION\n" + card(2, 2, 0.0, 0.0, 0.0, -1.0e4) + card(0)
            + "*PART\nlower\n" + card(1, 1, 1) + "*PART\nupper\n" + card(2, 1, 1) + "*SECTION_SHELL\n" + card(1, 2, 1.0, 5) + card(1.0, 1.0, 1.0, 1.0) + STEEL
            + "*NODE\n" + "".join(f"{k:8}{x:16.6f}{y:16.6f}{z:16.6f}\n" for k, (x, y, z) in enumerate(nodes, 1))
            + "*ELEMENT_SHELL\n" + "".join(f"{k:8}" + "".join(f"{n:8}" for n in e) + "\n" for k, e in enumerate(shells, 1)) + "*END\n")


@unittest.skipUnless(MPIRUN, "mpirun is not installed")
class RestartByPieces(RepeatedRuns):
    def over(self, ranks, *arguments, expect=0, full=None):
        """`full`: a rank for which no file may be longer than so many kilobytes: (rank, kilobytes)."""
        command = mpirun(ranks, *arguments, "-j", 1, "--quiet")
        if full:
            limit = ["bash", "-c", f'trap "" XFSZ; [ $OMPI_COMM_WORLD_RANK = {full[0]} ] && ulimit -f {full[1]}; exec "$@"', "_", NUGGET]
            command = [word for each in command for word in (limit if each == NUGGET else [each])]
        run = subprocess.run(command, capture_output=True, text=True, timeout=280, cwd=self.folder, env=dict(ENVIRONMENT, NUGGET_LANES="4"))
        self.assertEqual(run.returncode, expect, f"{ranks} ranks: {arguments}\n{run.stderr}\n{run.stdout}")
        return run

    def double_hat(self):
        subprocess.run([sys.executable, str(SOURCE / "examples" / "double_hat" / "make.py"), str(self.folder)], check=True)
        return "double_hat.k"

    def restart(self, folder, name="restart"):
        """The bytes of a restart file, but for what the clock has measured, the day and the checksum."""
        text = bytearray((self.folder / folder / name).read_bytes())
        clock = text.index(b"\5\0\0\0\0\0\0\0clock") + 13
        text[clock:clock + 56] = bytes(56)  # seconds of six phases, and of all
        text[-16:-8] = bytes(8)
        return re.sub(rb'"date":"[^"]*"', b"", text)

    def decks(self):
        """With the cycles at which they are cut: elements that are deleted and whose mass is scaled, welds, contact and a wall."""
        weight = "*LOAD_BODY_Z\n2,1e6\n"  # of nodes, less what mass scaling adds
        yield "tube", tube(fail=0.02, mass_step=-1.0e-6, end=8.0e-4).replace("*END", weight + "*END"), 300, ()
        yield "lap joint", lap_joint(), 60, ("--max-cycles", 600)
        yield "bricks", block(8), 40, ()
        yield "double hat", self.double_hat(), 60, ("--max-cycles", 120)

    def test_the_bytes_of_one_process(self):
        """Sabotage: pieces in the order of ranks; a rank's own values where another one gives them."""
        for name, text, at, _ in self.decks():
            with self.subTest(name):
                model = self.write(text) if text.startswith("*") else text
                options = ("--checkpoint", f"{at}cycles", "--max-cycles", at + 5)
                self.nugget("run", model, "-o", "one", "-j", 1, "--quiet", *options, env=with_lanes(4))
                one = self.restart("one")
                for ranks in (2, 3):
                    self.over(ranks, "run", model, "-o", "some", *options)
                    some = self.restart("some")
                    first = next((i for i, (a, b) in enumerate(zip(one, some)) if a != b), min(len(one), len(some)))
                    self.assertTrue(one == some, f"{ranks} ranks differ from byte {first} of {len(one)} and {len(some)} on")

    def test_other_numbers_of_ranks_go_on(self):
        """One process, three ranks, two, four."""
        for name, text, at, options in self.decks():
            with self.subTest(name):
                model = self.write(text) if text.startswith("*") else text
                self.nugget("run", model, "-o", "whole", "-j", 1, "--quiet", *options, env=with_lanes(4))
                whole = self.bits("whole")
                self.nugget("run", model, "-o", "cut", "-j", 1, "--quiet", "--checkpoint", f"{at // 3}cycles", "--max-cycles", at // 3 + 3, env=with_lanes(4))
                self.over(3, "run", "--resume", "cut", "--max-cycles", 2 * at // 3 + 3)
                self.over(2, "run", "--resume", "cut", "--max-cycles", at + 3)
                self.over(4, "run", "--resume", "cut", *(options or FOREVER))
                self.assertEqual(self.read("cut/run.log").count("Resumed from a restart file"), 3)
                for file, content in self.bits("cut").items():
                    if not file.startswith("restart"):
                        self.assertTrue(content == whole[file], file)

    def test_no_rank_holds_the_state_of_another(self):
        """The most memory of each of three ranks, with restart files and without, and of a run that goes on from one. Sabotage: states that come to the first
        rank; ranks that read all."""
        self.write(sheets())
        peaks = {}
        for folder, options in (("plain", ()), ("writes", ("--checkpoint", "3cycles"))):
            self.over(3, "run", "model.k", "-o", folder, "--max-cycles", 5, *options)
            peaks[folder] = [rank["peak_memory_mb"] for rank in self.json(f"{folder}/summary.json")["rank"]]
        size = (self.folder / "writes" / "restart").stat().st_size / 1e6
        self.over(3, "run", "--resume", "writes", "--max-cycles", 8)
        peaks["reads"] = [rank["peak_memory_mb"] for rank in self.json("writes/summary.json")["rank"]]
        print(f"a restart file of {size:.0f} MB; most memory of ranks [MB]: {peaks}")
        self.assertGreater(size, 60.0)
        for folder, share in (("writes", 0.2), ("reads", 0.4)):  # of the file; METIS has more to do where sheets rest on each other
            for plain, with_file in zip(peaks["plain"], peaks[folder]):
                self.assertLess(with_file, plain + share * size, folder)

    def test_the_disk_is_full(self):
        """While the first rank writes the second restart file; the one before it is there, and goes on. Other ranks write nothing, so their disk may be full."""
        self.write(tube(end=1.0))
        self.over(3, "run", "model.k", "-o", "out", "--checkpoint", "20cycles", "--max-cycles", 25)
        before = self.restart("out")
        kilobytes = len(before) // 1024 // 2
        run = self.over(3, "run", "--resume", "out", "--checkpoint", "30cycles", "--max-cycles", 40, full=(0, kilobytes), expect=4)
        self.assertIn("restart.part: File too large", run.stderr)
        self.assertEqual(ranks_in(self.folder), [])
        self.assertFalse((self.folder / "out" / "restart.part").exists())
        self.assertTrue(self.restart("out") == before)
        self.over(3, "run", "--resume", "out", "--checkpoint", "30cycles", "--max-cycles", 40, full=(1, 1))
        self.assertEqual(self.json("out/summary.json")["cycles"], 40)

    def elsewhere(self, *arguments, expect=1):
        """A run by two ranks, of which the second one stands in the folder `elsewhere`."""
        place = ["bash", "-c", f'[ $OMPI_COMM_WORLD_RANK = 1 ] && cd {self.folder}/elsewhere; exec "$@"', "_", NUGGET]
        command = [word for each in mpirun(2, *arguments, "-j", 1, "--quiet") for word in (place if each == NUGGET else [each])]
        run = subprocess.run(command, capture_output=True, text=True, timeout=60, cwd=self.folder, env=dict(ENVIRONMENT, NUGGET_LANES="4"))
        self.assertEqual(run.returncode, expect, f"{run.stderr}\n{run.stdout}")
        self.assertEqual(ranks_in(self.folder) + ranks_in(self.folder / "elsewhere"), [])
        return run.stderr

    def test_a_folder_that_one_rank_does_not_see(self):
        """All end before anything is computed, also where what stands there is damaged, or of another cycle. Sabotage: a rank that leaves before the agreement."""
        self.write(tube(end=1.0))
        self.nugget("run", "model.k", "-o", "out", "-j", 1, "--quiet", "--checkpoint", "20cycles", "--max-cycles", 25, env=with_lanes(4))
        other = self.folder / "elsewhere"
        other.mkdir()
        (other / "model.k").write_bytes((self.folder / "model.k").read_bytes())
        before = self.bits("out")
        lost = "rank 1 does not have the restart file of the first one [all ranks read it by the same name: it must stand in a folder that all machines see]"
        self.assertIn(lost, self.elsewhere("run", "--resume", "out"))
        subprocess.run(["cp", "-r", self.folder / "out", other], check=True)
        damaged = bytearray((other / "out" / "restart").read_bytes())
        damaged[len(damaged) // 2] ^= 1
        (other / "out" / "restart").write_bytes(damaged)
        self.assertIn(lost, self.elsewhere("run", "--resume", "out"))
        self.nugget("run", "model.k", "-o", "elsewhere/out", "-j", 1, "--quiet", "--checkpoint", "10cycles", "--max-cycles", 15, env=with_lanes(4))
        self.assertIn(lost, self.elsewhere("run", "--resume", "out"))
        self.assertEqual(self.bits("out"), before)


if __name__ == "__main__":
    unittest.main()
