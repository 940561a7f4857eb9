# SPDX-License-Identifier: Apache-2.0
"""A run that is cut short and gone on with writes the same bytes as one that is not: decks of all kinds of state; what a user
is told; what is refused."""
import os
import re
import signal
import subprocess
import sys
import time
import unittest

import contact_models as plates
import test_bodies
import test_histories
from lap_joint import deck as lap_joint
from lap_joint import edited
from nugget_command import NUGGET, SOURCE
from repeated_runs import FOREVER, RepeatedRuns

WEAK = ("    8000.0    6000.0    6000.0", "    8000.0    1000.0    1000.0")


def damaged_weld():
    """Fades after its failure function has been reached, by the mean of five cycles."""
    return lap_joint(WEAK, ("*MAT_SPOTWELD\n", "*MAT_SPOTWELD_DAMAGE-FAILURE\n"), (
        "    7000.0    7000.0\n*CONTACT", "    7000.0    7000.0         5\n"
        "      0.02       0.0       0.0       0.0       0.0       0.0       0.0        -1\n"
        "        10\n*CONTACT"))


def with_cards(text, cards):
    return edited(text, ("*KEYWORD\n", "*KEYWORD\n" + cards))


class Restart(RepeatedRuns):
    # ---- the same bytes, deck by deck

    def test_a_weld_that_fails_before_or_after(self):
        summary = self.resumed(lap_joint(WEAK), shares=(0.1, 0.3, 0.5, 0.7, 0.9))
        self.assertTrue(summary["weld"][0]["failed"])
        self.assertTrue(0.2 < summary["weld"][0]["failure_time"] / summary["time"] < 0.8)

    def test_a_weld_with_filter_and_damage(self):
        """And mean accelerations in nodout, from the output before the restart file on."""
        self.resumed(with_cards(damaged_weld(), "*CONTROL_OUTPUT\n,,,1\n"), "--until", "4e-5", shares=(0.2, 0.4, 0.6, 0.8))
        self.assertIn("begins to be damaged", self.read("whole/run.log"))

    def test_binout_histories_strains_and_files_of_one_state(self):
        text = edited(test_histories.Histories.text(), ("         0         0         4\n", "         0         1         4\n"))
        self.resumed(text)
        self.assertIn("binout0000", self.files("whole"))
        self.assertIn("d3plot04", self.files("whole"))

    def test_joints_springs_and_beams(self):
        self.resumed(test_bodies.DECK.format(requests=test_bodies.requests(3)))

    def test_friction(self):
        self.resumed(plates.plates(plates.sliding(fs=0.2), {3: -20.0, 1: 200.0}, 1.0e-4))

    def test_glue_that_fails(self):
        glue = plates.sliding("AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK", option=2, nfls=10.0, sfls=10.0)
        self.resumed(plates.plates(glue, {3: 30.0, 1: 10.0}, 2.0e-4))

    def test_tie_that_begins_later(self):
        """Cut before and after its birth. Sabotage: that it waits is not kept."""
        def tie(d):
            d.keyword("CONTACT_TIED_NODES_TO_SURFACE")
            d.card(surfa=plates.UPPER, surfb=plates.LOWER, surfatyp=3, surfbtyp=3)
            d.card(fs=0.0, fd=0.0, dc=0.0, vc=0.0, vdc=0.0, penchk=0, bt=1.0e-4, dt=0.0)
            d.card(sfsa=1.0, sfsb=1.0)
        self.resumed(plates.plates(tie, {3: 30.0, 1: 10.0}, 2.0e-4), shares=(0.3, 0.7))

    def test_mass_scaling_and_damping(self):
        cards = ("*DAMPING_FREQUENCY_RANGE\n      0.05    1000.0   50000.0\n"
                 "*DAMPING_PART_STIFFNESS\n         1      0.05\n"
                 "*DAMPING_GLOBAL\n         0     500.0\n")
        text = edited(with_cards(lap_joint(WEAK), cards),
                      ("*CONTROL_TIMESTEP\n       0.0       0.9\n", "*CONTROL_TIMESTEP\n       0.0       0.9         0       0.0  -6.0e-07\n"))
        self.assertGreater(self.resumed(text)["mass"]["added"], 0.0)

    def test_sheets_that_erode(self):
        """The sheets tear around the weld; ties end, and the weld goes with its sheet."""
        text = edited(lap_joint(), ("     300.0    1000.0\n       0.0       0.0\n", "     300.0    1000.0     0.005\n       0.0       0.0\n"))
        self.resumed(text, "--until", "6e-5")
        self.assertGreater(self.glstat("whole/glstat")[-1]["kinetic energy"], 0.0)

    def test_double_hat(self):
        """Welds, contact with itself, a wall, a rigid sled, beyond the first failures."""
        subprocess.run([sys.executable, str(SOURCE / "examples" / "double_hat" / "make.py"), str(self.folder)], check=True)
        self.resumed(self.folder / "double_hat.k", "--until", "2.0e-4", shares=(0.5,))

    def test_folds_with_edges_against_edges(self):
        subprocess.run([sys.executable, str(SOURCE / "examples" / "hat_crush" / "make.py"), str(self.folder)], check=True)
        text = (self.folder / "hat_poor.k").read_text(encoding="ascii")
        general = text.replace("CONTACT_AUTOMATIC_SINGLE_SURFACE_ID", "CONTACT_AUTOMATIC_GENERAL_INTERIOR_ID")
        self.resumed(general, "--until", "3.0e-4", shares=(0.7,))

    def test_a_different_state_gives_other_bytes(self):
        """The comparison can fail."""
        self.write(lap_joint(), "a.k")
        self.write(lap_joint(("             1.0e-05               500.0", "             1.0e-05               500.1")), "b.k")
        self.nugget("run", "a.k", "-o", "a", "--quiet")
        self.nugget("run", "b.k", "-o", "b", "--quiet")
        with self.assertRaises(self.failureException):
            self.same("a", "b")

    # ---- killed, interrupted

    def start(self, *arguments):
        run = subprocess.Popen([NUGGET, "run", *map(str, arguments)], cwd=self.folder, stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True)
        self.addCleanup(run.communicate)
        self.addCleanup(run.kill)
        return run

    def wait_for(self, what, seconds=30.0):
        deadline = time.monotonic() + seconds
        while not what():
            self.assertLess(time.monotonic(), deadline, "it did not come")
            time.sleep(0.01)

    @staticmethod
    def long(end):
        return lap_joint(WEAK, ("  2.00e-05\n*CONTROL_TIMESTEP", f"  {end}\n*CONTROL_TIMESTEP"))

    def test_killed_at_any_time(self):
        self.write(self.long("4.00e-04"))
        self.nugget("run", "model.k", "-o", "whole", "--quiet", "-j", 1)
        run = self.start("model.k", "-o", "cut", "--quiet", "-j", "1", "--checkpoint", "20cycles")
        self.wait_for(lambda: (self.folder / "cut/restart.previous").exists())
        for _ in range(4):
            time.sleep(0.05)
            run.kill()
            run.wait()
            run = self.start("--resume", "cut", "--quiet", "-j", "1")
        self.assertEqual(run.wait(timeout=60), 0)
        self.same("cut", "whole")

    def test_interrupted_by_the_keyboard(self):
        self.write(self.long("4.00e-03"))
        self.nugget("run", "model.k", "-o", "whole", "--quiet", "-j", 1)
        run = self.start("model.k", "-o", "cut", "--quiet", "-j", "1")
        self.wait_for(lambda: (self.folder / "cut/glstat").exists() and len(self.glstat("cut/glstat")) > 2)
        os.kill(run.pid, signal.SIGINT)
        _, error = run.communicate(timeout=20)
        self.assertEqual(run.returncode, 130, error)
        self.assertRegex(error, r"interrupted by the user at time \S+, cycle \d+; results up to there are kept; to go on: "
                                r"nugget run --resume cut\n")
        self.assertIn("to go on: nugget run --resume cut", self.json("cut/summary.json")["message"])
        cycle = self.json("cut/summary.json")["cycles"]
        self.nugget("run", "--resume", "cut", "--quiet")
        self.same("cut", "whole")
        self.assertIn(f"cycle {cycle}, ", re.search(r" Resumed from a restart file, .*", self.read("cut/run.log"))[0])

    def test_from_another_folder_to_a_later_end(self):
        """The deck is found where it was; what the command line says anew counts."""
        self.write(lap_joint(), "decks/model.k")
        (self.folder / "elsewhere").mkdir()
        self.nugget("run", "model.k", "-o", "../cut", "--quiet", "--checkpoint", "20cycles", "--until", "1e-5",
                    cwd=self.folder / "decks")
        self.nugget("run", "--resume", "../cut", "--quiet", "--until", "1.5e-5", cwd=self.folder / "elsewhere")
        summary = self.json("cut/summary.json")
        self.assertEqual((summary["deck"], summary["time"]), ("model.k", 1.5e-5))
        self.assertEqual(self.files("elsewhere"), [])

        (self.folder / "decks").rename(self.folder / "moved")
        run = self.nugget("run", "--resume", "cut", expect=1)
        self.assertIn("name the deck: nugget run MODEL.k --resume DIR", run.stderr)
        self.nugget("run", "moved/model.k", "--resume", "cut", "--quiet")

    def test_in_model_time_and_minutes(self):
        self.write(lap_joint())
        self.nugget("run", "model.k", "--quiet", "--checkpoint", "8e-6")
        time_of = lambda name: float(re.search(rb'"time":([^,]+)', (self.folder / name).read_bytes())[1])  # noqa: E731
        self.assertAlmostEqual(time_of("restart"), 1.6e-5, delta=2e-7)
        self.assertAlmostEqual(time_of("restart.previous"), 0.8e-5, delta=2e-7)
        self.nugget("run", "model.k", "--quiet", "--checkpoint", "0.0000000001min")
        self.assertTrue((self.folder / "restart").exists())
        self.nugget("run", "model.k", "--quiet")
        self.assertFalse((self.folder / "restart").exists(), "a new run takes the old restart files away")

    # ---- what is refused

    def refused(self, text, *arguments, expect=1):
        run = self.nugget("run", *arguments, expect=expect)
        self.assertIn(text, run.stderr)

    def test_refusals(self):
        self.write(lap_joint())
        (self.folder / "empty").mkdir()
        self.refused("there is no restart file in", "--resume", "empty")
        self.assertEqual(self.files("empty"), [])
        self.nugget("run", "model.k", "-o", "cut", "--quiet", "--checkpoint", "20cycles", "--max-cycles", 70)
        before = self.results("cut")

        newest = self.folder / "cut/restart"
        whole = newest.read_bytes()
        newest.write_bytes(whole[:len(whole) // 2])
        run = self.nugget("run", "--resume", "cut", "--quiet", *FOREVER)
        self.assertIn("the restart file is not whole: it was cut off", run.stderr)
        self.assertIn("the one before it is taken, ", run.stderr)
        newest.write_bytes(whole)

        self.write(lap_joint(("             1.0e-05               500.0", "             1.0e-05               500.1")))
        after = self.results("cut")
        self.refused("is not what it was when the restart file was written", "--resume", "cut")
        self.assertEqual(self.results("cut"), after, "nothing was changed")
        self.assertNotEqual(before["summary.json"], after["summary.json"])
        self.write(lap_joint())
        (self.folder / "cut/glstat").unlink()
        self.refused("glstat is gone", "--resume", "cut")
        (self.folder / "cut/glstat").write_text("x")
        self.refused("glstat has 1 bytes, fewer than the ", "--resume", "cut")

    def test_wrong_command_lines(self):
        self.write(lap_joint())
        for arguments, word in ((("model.k", "--checkpoint", "soon"), "'soon', expected e.g. 500cycles"),
                                (("model.k", "--checkpoint", "1.5cycles"), "'1.5cycles', expected"),
                                (("--resume", ".", "-o", "there"), "--output"),
                                ((), "model is required")):
            self.refused(word, *arguments, expect=2)


if __name__ == "__main__":
    unittest.main()
