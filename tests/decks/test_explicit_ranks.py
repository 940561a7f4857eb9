# SPDX-License-Identifier: Apache-2.0
"""Explicit runs over several ranks of mpirun: the same bytes as one process, whatever acts; restart files; ranks that end; the partition."""
import os
import re
import signal
import subprocess
import sys
import time
import unittest

from fabric_bag import pillow
from few_elements import card, curve
from lap_joint import deck as lap_joint
from nugget_command import SOURCE
from repeated_runs import FOREVER, LANES, with_lanes
from runs_over_ranks import RunsOverRanks
from shared_out import block, stacks_of_bricks, switched_tube, tube, weak_double_hat
from test_breaking_metals import torn
from test_composites import plates
from test_nodal_contact_forces import falling
from under_mpirun import ENVIRONMENT, MPIRUN, ranks_in


@unittest.skipUnless(MPIRUN, "mpirun is not installed")
class ExplicitRanks(RunsOverRanks):
    def test_four_and_eight_lanes(self):
        """Each number of lanes that this processor has, over ranks, against four of one process."""
        model = self.write(tube())
        self.nugget("run", model, "-o", "one", "--quiet", env=with_lanes(4))
        reference = self.bits("one")
        for lanes in LANES:
            self.over(2, "run", model, "-o", f"lanes{lanes}", "--quiet", lanes=lanes)
            self.assertEqual(self.json(f"lanes{lanes}/summary.json")["lanes"], lanes)
            self.assertEqual(self.bits(f"lanes{lanes}"), reference)

    def test_a_bag_whose_contact_covers_porous_fabric(self):
        """Threads by Green's strain; a floor that covers what leaks. Sabotage: a rank that knows of its own contact forces only, so that each has a gas of
        its own."""
        text = pillow(8, form=12, end=3e-3)
        form, places = card(0, "", "", "", "", 12), ((-50, -50), (250, -50), (250, 250), (-50, 250))
        floor = "*PART\nfloor\n" + card(2, 2, 2) + "*SECTION_SHELL\n" + card(2, 2) + card(1, 1, 1, 1) + "*MAT_RIGID\n" + card(2, 1e-9, 1000, 0.3) + card(1, 7, 7)
        floor += "\n*NODE\n" + "".join(f"{k:8}{x:16.6f}{y:16.6f}{-8.0:16.6f}\n" for k, (x, y) in enumerate(places, 9001))
        floor += "*ELEMENT_SHELL\n" + "".join(f"{v:8}" for v in (9001, 2, 9001, 9002, 9003, 9004)) + "\n"
        floor += "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n" + card(0) + card(0.1) + card("")
        leaked = {}
        for option in (1, 2):
            deck = text.replace(form, card(0, 0.02, 0.5, "", "", 12, option)).replace("*END\n", floor + "*END\n")
            if option == 2:
                self.compare_ranks(deck)
            else:
                self.nugget("run", self.write(deck), "-o", "one", "--quiet")
            leaked[option] = float(re.search(r"gas 7: a mass of (\S+) has leaked through fabric", self.log("one"))[1])
        self.assertLess(leaked[2], 0.99 * leaked[1])
        self.assertIn("FTORQ and at porous fabric", self.log("r3_2"))

    def log(self, folder):
        return self.read(f"{folder}/run.log")

    def test_shells_with_supports_motions_and_loads(self):
        """Nodes are shared out as well, with what holds and drives them: only those of loads and histories are followed by all. Sabotage: reactions that do not
        come to the first rank."""
        summary = self.compare_ranks(tube(), ranks=((2, 1), (3, 2), (4, 1), (7, 1)))
        self.assertLessEqual({"d3plot", "glstat", "matsum", "nodout", "elout", "spcforc", "secforc", "bndout", "binout0000"}, set(self.files("one")))
        self.assertIn("elements and nodes are shared out", self.log("r7_1"))
        self.assertEqual(sum(rank["elements"] for rank in summary["rank"]), 720)
        # No rank has states but those of its share, the first one of what the section shows, 24 shells in blocks of 8, too.
        more = [rank["states"] - rank["elements"] for rank in summary["rank"]]
        self.assertEqual(more[1:], [0] * 6)
        self.assertTrue(0 <= more[0] <= 24 * 8, more)
        self.assertTrue(all(rank["shared_nodes"] < rank["nodes"] < 700 for rank in summary["rank"]))
        self.assertTrue(all(0.8 < rank["expected_load"] < 1.2 and rank["bytes_per_cycle"] > 1000.0 for rank in summary["rank"]))
        self.assertTrue(all(5.0 < rank["peak_memory_mb"] < 2000.0 for rank in summary["rank"]))
        self.assertEqual(self.log("r7_1").count(" MB of memory at most in the first rank"), 1)

    def test_shells_that_fail_under_mass_scaling(self):
        self.compare_ranks(tube(fail=0.02, mass_step=-1.0e-6, end=8.0e-4))
        self.assertRegex(self.log("one"), r"part 1: \d\d of 720 elements deleted")
        self.assertGreater(self.json("one/summary.json")["mass"]["added"], 0.0)

    def test_forces_of_contacts_by_node(self):
        """The first rank writes what the others press, and where. Sabotage: its own hits alone."""
        self.compare_ranks(falling()[0].text(), ranks=((2, 1), (3, 1)))
        self.compare_ranks(falling("7,1,1", "AUTOMATIC_SINGLE_SURFACE", more=("*CONTACT_FORCE_TRANSDUCER_ID\n9\n1,,3,,,,1\n\n",))[0].text())
        self.assertIn("ncforc", self.files("one"))

    def test_layers_of_fibres_that_fail(self):
        self.compare_ranks(plates(3))
        self.assertGreater(self.json("one/summary.json")["energy"]["eroded"], 0.0)

    def test_metals_that_break(self):
        self.compare_ranks(torn())
        self.assertGreater(self.json("one/summary.json")["energy"]["eroded"], 0.0)

    def test_a_node_whose_way_ends_the_run(self):
        """Node 556, in the middle, comes down; all ranks end in the same cycle."""
        sensor = "*SENSOR_DEFINE_NODE\n" + card(1, 556, 0, 0, 0, "COORD") + "*SENSOR_SWITCH\n" + card(2, "SENSOR", 1, "LT", 125.0, 0, 0.0)
        for end, message in (("*TERMINATION_NODE\n" + card(556, 3, 200.0, 114.0), "node 556 has the z coordinate"),
                             (sensor + "*TERMINATION_SENSOR\n" + card(2), "sensor switch 2 is on")):
            with self.subTest(message):
                summary = self.compare_ranks(tube().replace("*END\n", end + "*END\n"), ranks=((2, 1), (7, 1)))
                self.assertLess(summary["time"], 3.9e-4)
                self.assertIn(message, summary["message"])

    def test_sensors_that_turn_things_on_and_off(self):
        """Forces of a support, a stress, an acceleration; a contact's force, whose pairs the ranks share. Sabotage: a contact's force of one rank's pairs."""
        self.compare_ranks(switched_tube(), ranks=((2, 1), (3, 1)))
        for what in ("turns PRESSURE 43 on", "turns PRESC-MOT 42 off", "turns ELESET 4 off"):
            self.assertIn(what, self.log("r3_1"))
        subprocess.run([sys.executable, str(SOURCE / "examples" / "double_hat" / "make.py"), str(self.folder)], check=True)
        text = (self.folder / "double_hat.k").read_text(encoding="ascii")
        sensors = ("*SENSOR_DEFINE_FORCE\n" + card(1, "CONTACT", 2, "M") + "*SENSOR_SWITCH\n" + card(1, "SENSOR", 1, "GT", 0.5) + card(2, "SENSOR", 1, "GT", 0.7)
                   + "*SENSOR_CONTROL\n" + card(1, "RWALL", 1) + card("ON", 1) + "*TERMINATION_SENSOR\n" + card(2))
        summary = self.compare_ranks(text.replace("*END", sensors + "*END"), "--until", "7.0e-4", ranks=((3, 1),))
        self.assertEqual(summary["message"], "sensor switch 2 is on")
        self.assertIn("turns RWALL 1 off, by switch 1", self.log("r3_1"))

    def test_seat_belts(self):
        """On the tube: a retractor at a node of its base, a slip ring at one of a shell, the end at the top, which comes down. Every rank computes all belts."""
        belts = ("*MAT_SEATBELT\n" + card(5, 1e-7, 91, 92, 3.0) + "*SECTION_SEATBELT\n" + card(5) + "*PART\nbelt\n" + card(5, 5, 5) + curve(91, (0.0, 0.0), (1.0, 1e5))
                 + curve(92, (0.0, 0.0), (0.5, 1e5)) + curve(93, (0.0, 200.0), (5.0, 800.0), (50.0, 900.0)))
        places = {3001: (-30.0, -30.0, 0.0), 3002: (-30.0, -30.0, 0.0), 3003: (-30.0, -30.0, 0.0), 3004: (60.0, -60.0, 75.0), 3005: (75.0, -75.0, 75.0)}
        belts += "*NODE\n" + "".join(f"{n:8}{x:16.9f}{y:16.9f}{z:16.9f}\n" for n, (x, y, z) in places.items())
        rows = ((1, 3001, 3004, 0), (2, 3001, 3002, 8), (3, 3002, 3003, 8), (4, 3004, 721, 0))  # node 721 is at the top
        belts += "*ELEMENT_SEATBELT\n" + "".join(f"{e:8}{5:8}{a:8}{b:8}{r:8}{0.0:16}\n" for e, a, b, r in rows)
        belts += "*ELEMENT_SEATBELT_SENSOR\n" + card(9, 3) + card(2e-4) + "*ELEMENT_SEATBELT_RETRACTOR\n" + card(8, 1, 1, 9) + card(0.0, 0.0, 93, 0, 10.0)
        belts += "*NODE\n" + f"{3006:8}{60.0:16.9f}{-60.0:16.9f}{75.0:16.9f}\n" + "*ELEMENT_MASS\n" + f"{901:8}{3006:8}{1e-3:16}\n"
        belts += "*INITIAL_VELOCITY_NODE\n" + card(3006, 15000.0, -15000.0, 0.0) + "*ELEMENT_SEATBELT_SLIPRING\n" + card(7, 1, 4, 0.2, 3006) + "*DATABASE_SBTOUT\n" + card(1e-5, 3)
        self.compare_ranks(tube().replace("*END\n", belts + "*END\n"), ranks=((2, 1), (3, 1)))
        self.assertIn("seat belts", self.log("r3_1"))
        self.assertIn("retractor 8 has locked", self.log("r3_1"))
        self.assertIn("has come out of retractor 8", self.log("r3_1"))

    def test_subcycling_is_refused(self):
        said = self.over(2, "run", self.write(tube()), "-o", "refused", "--subcycle", expect=1).stderr
        self.assertIn("--subcycle: this run has several ranks", said)
        self.assertEqual(said.count("--subcycle"), 1, "one rank speaks")

    def test_fully_integrated_shells_that_fail(self):
        self.compare_ranks(tube(elform=16, fail=0.02))
        self.assertRegex(self.log("one"), r"part 1: \d\d of 720 elements deleted")

    def test_shells_deleted_for_their_step(self):
        """DTMIN with ERODE: all ranks learn of the step of a shell that one of them computes."""
        self.compare_ranks(tube(dtmin=0.93, end=8.0e-4))
        self.assertRegex(self.log("one"), r"part 1: \d\d of 720 elements deleted")

    def test_a_run_that_ends_in_error(self):
        text = tube(dtmin=0.93, end=8.0e-4).replace("        11\n", "         0\n", 1)
        self.compare_ranks(text, ranks=((2, 1),), expect=3)
        self.assertIn("fell below DTMIN", self.json("r2_1/summary.json")["message"])

    def test_bricks_tetrahedra_and_beams(self):
        for elform in (1, 2):
            with self.subTest(elform):
                self.compare_ranks(block(elform=elform, end=3.0e-5))

    def test_single_precision(self):
        self.compare_ranks(tube(), "--precision", "single", ranks=((2, 1),))

    def test_welds_contact_wall_and_rigid_sled(self):
        """What is not shared out every rank computes whole."""
        subprocess.run([sys.executable, str(SOURCE / "examples" / "double_hat" / "make.py"), str(self.folder)], check=True)
        self.compare_ranks(self.folder / "double_hat.k", "--until", "2.0e-4")
        self.assertRegex(self.log("r2_1"), r"elements and nodes are shared out; every rank computes whole, and moves \d\d nodes for it: rigid bodies\n")

    def test_what_acts_on_nodes_in_contact(self):
        """Each rank follows nodes of its own beside a contact with friction, of edges, with a force transducer, a wall with mass and body loads;
        positions of others come to it. Sabotage: a ghost that is not sent, a hit that does not come to who adds it up, a node left out of a wall's sum."""
        subprocess.run([sys.executable, str(SOURCE / "examples" / "double_hat" / "make.py"), str(self.folder)], check=True)
        text = (self.folder / "double_hat.k").read_text(encoding="ascii")
        smooth, fixed, histories = "       0.0       0.0\n$#    sfsa", "*RIGIDWALL_PLANAR_ID\n", "*DATABASE_RWFORC\n"
        for line in (smooth, fixed, histories, "AUTOMATIC_SINGLE_SURFACE_ID"):
            self.assertIn(line, text)
        rubs = text.replace(smooth, smooth.replace("0.0       0.0", "0.2       0.1"))
        rubs = rubs.replace(histories, "*DATABASE_RCFORC\n" + card(2.0e-6) + "*DATABASE_SLEOUT\n" + card(2.0e-6) + histories)
        rubs = rubs.replace("*END", "*CONTACT_FORCE_TRANSDUCER_PENALTY\n" + card(1, 0, 3) + "\n\n*END")
        loads = "*LOAD_BODY_Z\n" + card(7, 9810.0) + "*LOAD_BODY_RX\n" + card(7, 100.0) + curve(7, (0.0, 1.0), (1.0, 1.0))
        moves = text.replace(fixed, fixed.replace("PLANAR", "PLANAR_MOVING")).replace("       1.0       1.0\n*DEFINE_BOX", "       1.0       1.0\n" + card(0.02, 500.0) + "*DEFINE_BOX")
        self.assertIn("MOVING", moves)
        cases = {"friction and a transducer": rubs, "edges": rubs.replace("AUTOMATIC_SINGLE_SURFACE_ID", "AUTOMATIC_GENERAL_ID"),
                 "a wall with mass": moves, "body loads": text.replace("*END", loads + "*END")}
        for name, deck in cases.items():
            with self.subTest(name):
                summary = self.compare_ranks(deck, "--until", "1.0e-4", ranks=((3, 1),))
                self.assertIn("elements and nodes are shared out", self.log("r3_1"))
                held, whole = [rank["segments"] for rank in summary["rank"]], name in ("friction and a transducer", "edges")
                self.assertTrue(all(segments == 9520 for segments in held) if whole else max(held) < 4000, held)
        said = self.nugget("check", self.write(cases["edges"]), "-n", 2, "-o", "partition").stdout
        self.assertIn(" nodes for it: contact of edges, glue, FTORQ and at porous fabric, rigid bodies\n", said)

    def test_shells_that_fail_in_contact(self):
        """Every rank must know which shells are deleted: they leave the surface. Sabotage: deletions that are not passed on."""
        subprocess.run([sys.executable, str(SOURCE / "examples" / "double_hat" / "make.py"), str(self.folder)], check=True)
        text = (self.folder / "double_hat.k").read_text(encoding="ascii")
        steel = "         1  7.85e-09  210000.0       0.3\n"
        self.assertIn(steel, text)
        self.compare_ranks(text.replace(steel, steel[:-1] + "       0.0       0.0      0.05\n"), "--until", "6.0e-4", ranks=((2, 1),))
        self.assertRegex(self.log("one"), r"part 1: \d+ of 4760 elements deleted")

    def test_bricks_that_break_in_contact(self):
        """Initial penetrations are looked for by all ranks, each in a part of the surface, and removed (IGNORE = 0) or kept; faces come to light as bricks
        are deleted. Sabotage: segments that have come near and are not fetched."""
        for ignore in (0, 1):
            with self.subTest(ignore):
                summary = self.compare_ranks(stacks_of_bricks(ignore=ignore), ranks=((2, 1), (3, 2), (7, 1)))
                for folder in ("r2_1", "r3_2", "r7_1"):
                    self.assertEqual(self.json(f"{folder}/findings.json"), self.json("one/findings.json"))
                self.assertIn("nodes stand in the thickness of a sheet or in a brick at the start", self.log("one"))
                self.assertIn("nodes stand deeper in bricks at the start than contact presses", self.log("one"))
                self.assertRegex(self.log("one"), r"part 1: \d\d+ of 144 elements deleted")
                self.assertLess(max(rank["segments"] for rank in summary["rank"]), 1300)  # of 1,512

    def test_every_kind_of_damping(self):
        subprocess.run([sys.executable, str(SOURCE / "examples" / "double_hat" / "make.py"), str(self.folder)], check=True)
        text = (self.folder / "double_hat.k").read_text(encoding="ascii")
        cards = ("*DAMPING_GLOBAL\n         0      50.0\n*DAMPING_PART_STIFFNESS\n         1      0.05\n"
                 "*DAMPING_FREQUENCY_RANGE\n      0.02     100.0   10000.0\n*DAMPING_FREQUENCY_RANGE_DEFORM\n      0.02     100.0   10000.0\n")
        self.compare_ranks(text.replace("*END", cards + "*END"), "--until", "1.0e-4", ranks=((3, 1),))

    def test_a_weld_that_fails(self):
        self.compare_ranks(lap_joint(("    8000.0    6000.0    6000.0", "    8000.0    1000.0    1000.0")), ranks=((2, 1),))

    def test_welds_that_fail_on_several_ranks(self):
        """Each rank looks at the welds that it computes, beams or clusters of bricks, and passes on which of them fail. Sabotage: news that do not come, or
        in the order of ranks; a tied node that is not moved by all who follow its segment."""
        text, lasting = weak_double_hat(self.folder), "     500.0    1000.0       0.0       0.0\n"
        self.assertIn(lasting, text)
        beams = text.replace(lasting, "     500.0    1000.0       0.0   1.0e-04\n")  # then all at once
        bricks = "*CONTROL_SPOTWELD_BEAM\n         0         0         0         0         0         4\n"
        for name, deck in (("beams", beams), ("bricks", beams.replace("*CONTROL_TERMINATION\n", bricks + "*CONTROL_TERMINATION\n"))):
            with self.subTest(name):
                self.compare_ranks(deck, "--until", "1.1e-4", ranks=((4, 1),))
                failures = re.findall(r"spotweld \w+ failed .*", self.log("one"))
                self.assertEqual(len(failures), 40)
                self.assertGreaterEqual(sum("by failure time" not in failure for failure in failures), 4)
                self.assertEqual(re.findall(r"spotweld \w+ failed .*", self.log("r4_1")), failures)

    def test_a_weld_whose_mass_grows(self):
        """DT of the weld's material adds mass as the weld is squeezed, which gravity pulls at: all ranks must know it as physical. Sabotage: news of scaled
        masses without their physical part."""
        weld, way = "         3  7.85e-09  210000.0       0.3     500.0    1000.0\n", "             1.0e-05               500.0\n             1.0e-01               500.0\n"
        gravity = "*LOAD_BODY_Z\n" + card(7, 9.81e6) + curve(7, (0.0, 1.0), (1.0, 1.0))
        text = lap_joint((weld, weld[:-1] + "   1.0e-06\n"), (way, way.replace("  500.0", "-50000.0")), ("    8000.0    6000.0    6000.0", "   80000.0   60000.0   60000.0"),
                         ("         2         1         0         1\n", "         2         3         0         1\n"), ("*DEFINE_CURVE\n", gravity + "*DEFINE_CURVE\n"))
        mass = self.compare_ranks(text)["mass"]
        self.assertEqual(mass["added"], 0.0)
        self.assertGreater(mass["added_to_welds"], 1e-6)

    def test_a_weld_of_bricks_with_a_joint(self):
        bricks = "*CONTROL_SPOTWELD_BEAM\n         0         0         0         0         0         4\n"
        self.compare_ranks(lap_joint(("*CONTROL_TERMINATION\n", bricks + "*CONTROL_TERMINATION\n")), "--weld-tie", "joint")

    def test_restart_files_with_other_numbers_of_ranks(self):
        """Two ranks, three, one process. In the double hat with contact and a wall."""
        subprocess.run([sys.executable, str(SOURCE / "examples" / "double_hat" / "make.py"), str(self.folder)], check=True)
        for name, text, options in (("tube", tube(fail=0.02, mass_step=-1.0e-6, end=8.0e-4), ()), ("lap joint", lap_joint(), ("--max-cycles", 600)),
                                    ("double hat", self.folder / "double_hat.k", ("--max-cycles", 120))):
            with self.subTest(name):
                model = self.write(text) if isinstance(text, str) else text
                self.nugget("run", model, "-o", "whole", "-j", 1, "--quiet", *options)
                cycles = self.json("whole/summary.json")["cycles"]
                at = cycles // 3
                self.over(2, "run", model, "-o", "cut", "-j", 1, "--quiet", "--checkpoint", f"{at}cycles", "--max-cycles", at + 5)
                self.over(3, "run", "--resume", "cut", "-j", 1, "--quiet", "--max-cycles", 2 * at + 1)
                self.nugget("run", "--resume", "cut", "-j", 2, "--quiet", *(options or FOREVER), env=with_lanes(4))
                self.assertEqual(self.read("cut/run.log").count("Resumed from a restart file"), 2)
                bits = self.bits("whole")
                for file, content in self.bits("cut").items():
                    if not file.startswith("restart"):
                        self.assertTrue(content == bits[file], file)

    def test_each_case_of_a_deck(self):
        text = tube().replace("*CONTROL_TERMINATION\n", "*CASE\n" + f"{1:>10}\n" + "*CASE\n" + f"{2:>10}\n" + "*CONTROL_TERMINATION\n", 1)
        self.write(text)
        run = self.over(2, "run", "model.k", "-o", "out", "-j", 1, "--quiet", "--max-cycles", 5)
        self.assertEqual(run.stdout.count("N o r m a l"), 2)
        self.assertEqual([self.json(f"out/case{c}/summary.json")["ranks"] for c in (1, 2)], [2, 2])

    def test_signals_and_the_death_of_a_rank(self):
        """A signal, to mpirun or to any rank, leaves a restart file from which one process goes on; a rank that is killed ends all."""
        self.write(tube(48, 60, end=1.0))
        for strike, number in (("term to mpirun", signal.SIGTERM), ("term to a rank", signal.SIGTERM), ("kill a rank", signal.SIGKILL)):
            with self.subTest(strike):
                folder = strike.replace(" ", "_")
                with subprocess.Popen(self.command(2, "run", "model.k", "-j", 1, "-o", folder, "--quiet", "--checkpoint", "20cycles"), cwd=self.folder,
                                      env=ENVIRONMENT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as mpirun:
                    deadline = time.monotonic() + 60
                    while not (self.folder / folder / "restart.previous").exists():
                        self.assertLess(time.monotonic(), deadline)
                        self.assertIsNone(mpirun.poll())
                        time.sleep(0.1)
                    ranks = ranks_in(self.folder)
                    self.assertEqual(len(ranks), 2)
                    if strike.endswith("mpirun"):
                        mpirun.send_signal(number)
                    else:
                        os.kill(ranks[-1], number)
                    code = mpirun.wait(30)
                self.assertEqual(ranks_in(self.folder), [])
                if strike == "term to a rank":
                    self.assertEqual(code, 130)
                else:
                    self.assertNotEqual(code, 0)
                before = re.findall(r"cycles\s+(\d+)", self.log(folder))
                self.assertEqual(len(before), 0 if strike == "kill a rank" else 1)
                self.nugget("run", "--resume", folder, "--quiet", "--max-cycles", int(before[0]) + 2 if before else 10, env=with_lanes(4))

    def test_a_file_that_cannot_be_written(self):
        """The first rank finds it, when the others are in the run already, and ends them with the exit code of one process."""
        self.write(tube(end=1.0))
        (self.folder / "out" / "spcforc").mkdir(parents=True)
        run = self.over(2, "run", "model.k", "-o", "out", "-j", 1, "--quiet", expect=4)
        self.assertIn("nugget: cannot write out/spcforc: Is a directory\n", run.stderr)
        self.assertEqual(ranks_in(self.folder), [])

    def test_refusals(self):
        self.write(tube().replace("*SECTION_SHELL\n", "*SECTION_SHEL\n"))
        run = self.over(2, "run", "model.k", "-o", "out", "--quiet", expect=1)
        self.assertEqual(run.stderr.count("the deck is refused; nothing was run"), 1)
        self.write(lap_joint())
        run = self.over(2, "run", "model.k", "-o", "out", "--quiet", "--drop-weld", "all", expect=2)
        self.assertIn("these are many runs, each a process of its own", run.stderr)

    def test_the_partition(self):
        """Of a tube of 24 by 30 shells two ranks cut one ring of 24 nodes, or a few more; of the rings at its ends, held and moved, they share none. Beside the
        cut stand three nodes of histories and five of loads."""
        self.write(tube())
        said = self.nugget("check", "model.k", "-n", 2, "-o", "out").stdout
        rows = [line.split() for line in said.splitlines() if re.match(r"\s+[01]\s+\d+\s+\d+", line)]
        self.assertEqual(sum(int(row[1]) for row in rows), 720)
        for row in rows:
            self.assertAlmostEqual(int(row[1]), 360, delta=12)
            self.assertTrue(24 <= int(row[3]) <= 40 + 8, row)
        self.assertIn("partition.vtu", self.files("out"))
        self.assertIn("elements and nodes are shared out", said)


if __name__ == "__main__":
    unittest.main()
