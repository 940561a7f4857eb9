# SPDX-License-Identifier: Apache-2.0
"""*CONTROL_SUBCYCLE and nugget run --subcycle: closed forms of a bar and of weights that rest, the single-rate run, the same
bits for any number of threads and lanes and across a restart, what is refused."""
import math
import re
import unittest

from few_elements import card, curve
from lap_joint import CARDS as LAP_JOINT
from repeated_runs import FOREVER, RepeatedRuns

DENSITY, MODULUS = 7.85e-9, 2.1e5


def strip(sizes, cards="", poisson=0.0, end=1e-4, elform=2, speeds=None, width=10.0):
    """A strip of shells 1 mm thick along x, one shell wide: lengths of its shells. `speeds`: of a node by its x [mm/s]."""
    xs = [0.0]
    for size in sizes:
        xs.append(xs[-1] + size)
    text = ["*KEYWORD\n*CONTROL_TERMINATION\n", card(f"{end:.4g}"), "*CONTROL_ENERGY\n", card(2, 2, 2, 2), "*DATABASE_GLSTAT\n", card(f"{end / 20:.3g}"),
            "*PART\nstrip\n", card(1, 1, 1), "*SECTION_SHELL\n", card(1, elform, 0.8333, 3), card(1.0, 1.0, 1.0, 1.0),
            "*MAT_ELASTIC\n", card(1, DENSITY, MODULUS, poisson), "*NODE\n"]
    for i, x in enumerate(xs):
        text += [f"{2 * i + 1 + j:8d}{x:16.8g}{width * j:16.8g}{0.0:16.8g}\n" for j in (0, 1)]
    text.append("*ELEMENT_SHELL\n")
    text += ["".join(f"{n:8d}" for n in (i + 1, 1, 2 * i + 1, 2 * i + 3, 2 * i + 4, 2 * i + 2)) + "\n" for i in range(len(sizes))]
    if speeds:
        text.append("*INITIAL_VELOCITY_NODE\n")
        text += [card(2 * i + 1 + j, f"{speeds(x):.5g}", 0, 0) for i, x in enumerate(xs) for j in (0, 1)]
    return "".join(text) + cards + "*END\n"


GRADED = [10.0] * 8 + [1.25] * 8 + [10.0] * 8


class Subcycling(RepeatedRuns):
    def run_with(self, text, card_name="*CONTROL_SUBCYCLE_16_1", name="model", expect=0, options=()):
        self.write(text.replace("*END\n", f"{card_name}\n*END\n") if card_name else text, f"{name}.k")
        return self.nugget("run", f"{name}.k", "-o", name, "--quiet", *options, expect=expect)

    def nodout(self, folder):
        """{node: [(time, displacement x, velocity x, acceleration x)]}."""
        rows, time = {}, None
        for line in self.read(f"{folder}/nodout").splitlines():
            found = re.search(r"at time +([\d.E+-]+)", line)
            if found:
                time = float(found[1])
            numbers = re.match(r" *(\d+)((?: *-?\d\.\d+E[+-]\d+){12})", line)
            if numbers:
                v = [float(n) for n in re.findall(r"-?\d\.\d+E[+-]\d+", numbers[2])]
                rows.setdefault(int(numbers[1]), []).append((time, v[0], v[3], v[6]))
        return rows

    def test_a_bar_with_small_elements_rings_as_its_wave_speed_asks(self):
        """First axial mode of a free bar: u = V/w cos(pi x/L) sin w t, w = pi c/L."""
        length, speed = sum(GRADED), 100.0
        omega = math.pi * math.sqrt(MODULUS / DENSITY) / length
        for elform in (2, 16):
            with self.subTest(elform=elform):
                end = 4.5 * math.pi / omega
                self.run_with(strip(GRADED, "*DATABASE_NODOUT\n" + card(f"{end / 45:.3g}") + "*DATABASE_HISTORY_NODE\n" + card(1) + "*CONTROL_BULK_VISCOSITY\n" + card("1e-9", "1e-9", 1),
                                    end=end, elform=elform, speeds=lambda x: speed * math.cos(math.pi * x / length)))
                periods = {p["cycles"]: p["elements"] for p in self.json("model/summary.json")["subcycling"]}
                self.assertEqual(periods, {1: {"shell": 10}, 4: {"shell": 14}})
                rows = self.nodout("model")[1]
                self.assertGreater(len(rows), 40)
                for time, way, velocity, acceleration in rows:
                    self.assertAlmostEqual(way * omega / speed, math.sin(omega * time), delta=0.015)
                    self.assertAlmostEqual(velocity / speed, math.cos(omega * time), delta=0.02)
                    self.assertAlmostEqual(acceleration / speed / omega, -math.sin(omega * time), delta=0.06)
                # Nodes between long and short periods zigzag with the force; where there is none, nothing is missing.
                ratios = [float(r) for r in re.findall(r"total energy / initial energy\.+ +(\S+)", self.read("model/glstat"))]
                self.assertLess(max(ratios), 1.0001)
                self.assertGreater(min(ratios), 0.988)
                self.assertGreater(max(ratios[-10:]), 0.999)

    def test_weights_rest_on_supports_and_walls(self):
        """Means over a period: a strip that hangs, and one that stands on a wall, damped, press with their weight."""
        weight = 981e4 * DENSITY * sum(GRADED) * 10.0
        rest = ("*DAMPING_GLOBAL\n" + card(0, 2e4) + "*LOAD_BODY_X\n" + card(7, 981e4) + curve(7, (0, 1), (1, 1)) + "*DATABASE_SPCFORC\n" + card(1e-5)
                + "*DATABASE_RWFORC\n" + card(1e-5))
        self.run_with(strip(GRADED, rest + "*BOUNDARY_SPC_NODE\n" + "".join(card(n, 0, *6 * [1]) for n in (1, 2)), end=2e-3), name="hung")
        force = [float(f) for f in re.findall(r"force resultants *= *(-?\d\.\d+E[+-]\d+)", self.read("hung/spcforc"))]
        self.assertAlmostEqual(force[-1] / weight, 1.0, delta=2e-3)
        self.assertAlmostEqual(force[-5] / weight, 1.0, delta=2e-3)
        self.run_with(strip(GRADED, rest + "*RIGIDWALL_PLANAR\n" + card(0) + card("-0.01", 0, 0, "0.5"), end=2e-3), name="standing")
        pressed = [float(row.split()[2]) for row in self.read("standing/rwforc").splitlines() if re.match(r" +\d\.\d+E[+-]\d+ +\d+ ", row)]
        self.assertAlmostEqual(abs(pressed[-1]) / weight, 1.0, delta=2e-3)
        self.assertAlmostEqual(abs(pressed[-5]) / weight, 1.0, delta=2e-3)

    @staticmethod
    def lap_joint(cards=""):
        """A lap joint of 11 x 11 shells of 10 mm a sheet, whose weld beam of 1.2 mm has a sixth of their step."""
        node, shell = [], []
        for part, z in ((1, 0.0), (2, 1.2)):
            node += [(1000 * part + 12 * j + i, 10.0 * i, 10.0 * j, z) for j in range(12) for i in range(12)]
            shell += [(500 * part + 11 * j + i, part, *(1000 * part + 12 * (j + b) + i + a for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))))
                      for j in range(11) for i in range(11)]
        node += [(1, 55.0, 55.0, 0.0), (2, 55.0, 55.0, 1.2)]
        ends = [[i for i, x, _, z in node if x == place and z == height and i > 2] for place, height in ((0.0, 0.0), (110.0, 1.2))]
        text = LAP_JOINT.split("*SET_NODE_LIST")[0].replace("       216\n", card(1)).replace("  2.00e-05", "  2.00e-04")
        text += "".join("*SET_NODE_LIST\n" + card(n) + "".join(card(*ids[i:i + 8]) for i in (0, 8)) for n, ids in ((1, ends[0]), (2, ends[1])))
        text += "*NODE\n" + "".join(f"{i:8d}{x:16.4f}{y:16.4f}{z:16.4f}\n" for i, x, y, z in node)
        text += "*ELEMENT_SHELL\n" + "".join("".join(f"{n:8d}" for n in e) + "\n" for e in shell)
        return text + "*ELEMENT_BEAM\n" + "".join(f"{n:8d}" for n in (1, 3, 1, 2, 0)) + "\n" + cards + "*END\n"

    def test_a_weld_carries_what_it_does_in_each_cycle(self):
        text = self.lap_joint()
        self.run_with(text, "", "whole")
        self.run_with(text, name="parted")
        periods = {p["cycles"]: p["elements"] for p in self.json("parted/summary.json")["subcycling"]}
        self.assertEqual(periods[1]["beam"], 1, periods)
        self.assertIn("forces every 4 cycles    224 shells", self.read("parted/run.log"))
        self.assertEqual(list(periods), [1], "the weld has failed: no shell needs another step")
        whole, parted = (self.json(f"{name}/summary.json") for name in ("whole", "parted"))
        for key in ("kinetic", "internal"):
            self.assertAlmostEqual(parted["energy"][key] / whole["energy"][key], 1.0, delta=0.02, msg=key)
        one, other = whole["weld"][0], parted["weld"][0]
        self.assertAlmostEqual(other["failure_time"] / one["failure_time"], 1.0, delta=0.005)
        self.assertAlmostEqual(other["peak"]["shear"] / one["peak"]["shear"], 1.0, delta=0.005)
        self.assertAlmostEqual(parted["energy"]["ratio"], 1.0, delta=0.002)

    def test_rigid_welds_and_rivets_carry_what_they_do_in_each_cycle(self):
        """Beside weld beam 1 a rigid weld, which so gets the number 2 and fails, and a rivet: the shells at their nodes have forces in each cycle, so
        that failure and forces are those of the run without sub-cycling."""
        text = self.lap_joint("*CONSTRAINED_SPOTWELD\n" + card(1039, 2039, 400.0, 400.0, 1, 1) + "*CONSTRAINED_RIVET\n" + card(1104, 2104))
        self.run_with(text, "", "whole")
        self.run_with(text, name="parted")
        self.assertIn("forces every 4 cycles", self.read("parted/run.log"))
        whole, parted = (self.json(f"{name}/summary.json") for name in ("whole", "parted"))
        failed = [re.findall(r"constraint/weld failed +id= +2 .* (at node.*)", self.read(f"{name}/run.log")) for name in ("whole", "parted")]
        self.assertEqual(failed, [["at node 1039 by shear force"]] * 2)
        _, one, vibrating = whole["weld"]
        _, other, too = parted["weld"]
        self.assertAlmostEqual(other["failure_time"] / one["failure_time"], 1.0, delta=0.002)
        self.assertAlmostEqual(other["peak"]["shear"] / one["peak"]["shear"], 1.0, delta=0.01)
        # What the rivet carries is how the sheets vibrate across: 28 of the 6,000 N that the joint does.
        self.assertAlmostEqual(too["peak"]["axial"] / vibrating["peak"]["axial"], 1.0, delta=0.1)
        self.assertAlmostEqual(parted["energy"]["ratio"], 1.0, delta=0.002)

    def test_same_bits_and_restart(self):
        text = strip(GRADED, "*DATABASE_BINARY_D3PLOT\n" + card(2e-5), 0.3, speeds=lambda x: 1e4 * math.sin(x))
        text = text.replace("*END\n", "*CONTROL_SUBCYCLE_8_2\n*CONTACT_AUTOMATIC_SINGLE_SURFACE\n" + card(0) + card() + card() + "*END\n")
        self.compare(self.write(text))
        self.compare(self.write(text), "--precision", "single")
        self.resumed(text)

    def test_the_option_is_the_card(self):
        text = strip(GRADED, "", 0.3, speeds=lambda x: 1e4 * math.sin(x))
        self.run_with(text, name="card")
        self.run_with(text, "", "option", options=("--subcycle",))
        self.assertEqual(self.read("card/glstat"), self.read("option/glstat"))
        self.run_with(text, "*CONTROL_SUBCYCLE\n" + card(2, 1).rstrip("\n"), "fields")
        self.assertEqual(max(p["cycles"] for p in self.json("fields/summary.json")["subcycling"]), 2)
        self.assertIn("forces every 2 cycles    14 shells", self.read("fields/run.log"))
        self.write(text)
        self.nugget("run", "model.k", "-o", "begun", "--quiet", "--checkpoint", "20cycles", "--max-cycles", 30)
        said = self.nugget("run", "--resume", "begun", "--quiet", "--subcycle", *FOREVER, expect=1)
        self.assertIn("--subcycle: the run was begun without", said.stderr)

    def test_what_is_refused_and_said(self):
        text = strip(GRADED, speeds=lambda x: 10.0)
        for name, cards, what in (("damping", "*DAMPING_PART_STIFFNESS\n" + card(1, 0.05), "stiffness damping of part 1"),
                                  ("relaxation", "*CONTROL_DYNAMIC_RELAXATION\n" + card("", "", "", "", "", "", "", 1), "a dynamic relaxation"),
                                  ("welds", "*CONSTRAINED_SPOTWELD\n" + card(1, 4, 10, 10, 1, 1), "rigid welds and L 2")):
            with self.subTest(name):
                for command in ("run", "check"):
                    self.write(text.replace("*END\n", cards + "*CONTROL_SUBCYCLE_16_2\n*END\n"))
                    said = self.nugget(command, "model.k", "-o", f"{name}_{command}", expect=1)
                    self.assertRegex(said.stderr, rf"model.k:\d+:\d+: error: \*CONTROL_SUBCYCLE: this run has {what}")
        for card_name in ("*CONTROL_SUBCYCLE_4_16", "*CONTROL_SUBCYCLE\n         3"):
            self.assertIn("expected powers of two from 1 to 64, L not above K", self.run_with(text, card_name, expect=1).stderr)
        self.assertIn("mass scaling of parts", self.run_with(text, "*CONTROL_SUBCYCLE_MASS_SCALED_PART\n         1", expect=1).stderr)
        said = self.run_with(strip([10.0] * 4, speeds=lambda x: 10.0)).stderr
        self.assertIn("no element allows twice the step of the run", said)


if __name__ == "__main__":
    unittest.main()
