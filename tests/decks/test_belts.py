# SPDX-License-Identifier: Apache-2.0
"""Seat belts against what can be worked out by hand: their curves, exp(mu theta) at slip rings, the curves of retractors."""
import math
import re
import unittest

from few_elements import card, curve, nodes
from repeated_runs import RepeatedRuns

STIFF = 1e5  # tension over strain of the straight belts
LEAST, FED = 5.0, 20.0


def material(*, mpul=1e-9, unloading=0, loading=11):
    return "*MAT_SEATBELT\n" + card(1, mpul, loading, unloading, LEAST) + "*SECTION_SEATBELT\n" + card(1) + "*PART\nbelt\n" + card(1, 1, 1)


def belts(*rows):
    """(id, node, node, retractor, slack)"""
    return "*ELEMENT_SEATBELT\n" + "".join(f"{e:8}{1:8}{a:8}{b:8}{r:8}{s:16}\n" for e, a, b, r, s in rows)


def deck(text, end=1e-2, interval=1e-4):
    straight = curve(11, (0.0, 0.0), (1.0, STIFF))
    return f"*KEYWORD\n*CONTROL_TERMINATION\n{card(end)}*DATABASE_SBTOUT\n{card(interval, 3)}{straight}{text}*END\n"


def driven(node, dof, *points, identity=21):
    """A node whose displacement follows these points."""
    return "*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + card(node, dof, 2, identity) + curve(identity, *points)


def held(*members):
    return "*BOUNDARY_SPC_NODE\n" + "".join(card(n, 0, 1, 1, 1, 1, 1, 1) for n in members)


class SeatBelts(RepeatedRuns):
    def run_deck(self, text):
        self.nugget("run", self.write(text).name, "-o", "run", "--quiet")
        times, time = [], {}
        for line in self.read("run/sbtout").splitlines():
            if not line.startswith((" time", " belt", " slip ring", " retractor")):
                continue
            numbers = [float(n) for n in re.findall(r"[-+]?\d[\d.]*(?:E[-+]\d+)?", line)]
            if line.startswith(" time"):
                time = {"time": numbers[0]}
                times.append(time)
            else:
                time[line.split()[0], int(numbers[0])] = numbers[1:]
        return times

    def state(self, times, time):
        return min(times, key=lambda s: abs(s["time"] - time))

    def tension(self, times, belt, time):
        return self.state(times, time)["belt", belt][0]

    def refused(self, text, message):
        self.assertIn(message, self.nugget("check", self.write(text).name, expect=1).stderr)


class Curves(SeatBelts):
    def test_loading_and_unloading(self):
        """A belt of 100 mm with 2 mm of slack is stretched, let go, and stretched again. Up to 500 N both ways go along the loading curve."""
        curves = curve(12, (0.0, 0.0), (0.05, 500.0), (0.1, 2000.0)) + curve(13, (0.0, 0.0), (0.04, 2000.0))
        way = [(0.0, 0.0), (1e-3, 2.0 + 4.08), (2e-3, 2.0 + 2.04), (4e-3, 2.0 + 8.16), (5e-3, 2.0 + 7.14), (6e-3, 2.0 + 4.08), (8e-3, 2.0 + 9.18), (1.0, 11.18)]
        text = material(loading=12, unloading=13) + curves + nodes([(0, 0, 0), (100, 0, 0)]) + belts((1, 1, 2, 0, 2.0)) + held(1) + driven(2, 1, *way)
        times = self.run_deck(deck(text, end=8.5e-3))
        # at 8 %: 500 + 3/5 of 1500 = 1400, which the unloading curve has at 2.8 %: moved by 5.2 %
        for time, force in ((3e-4, 0.0), (1e-3, 400.0), (2e-3, 200.0), (4e-3, 1400.0), (5e-3, 900.0), (6e-3, 0.0), (8e-3, 1700.0)):
            self.assertAlmostEqual(self.tension(times, 1, time), force, delta=6.0, msg=f"at {time}")

    def test_a_mass_that_swings(self):
        """m v stretches the belt by v / omega and comes back with all of it: omega^2 = STIFF / (100 m). Damping takes little of a light belt."""
        mass, speed = 1e-3, 1000.0
        omega = math.sqrt(STIFF / 100.0 / mass)
        text = material() + nodes([(0, 0, 0), (100, 0, 0)]) + belts((1, 1, 2, 0, 0.0)) + held(1) + f"*ELEMENT_MASS\n{1:8}{2:8}{mass:16}\n"
        text += "*INITIAL_VELOCITY_NODE\n" + card(2, speed) + "*DATABASE_NODOUT\n" + card(1e-4) + "*DATABASE_HISTORY_NODE\n" + card(2) + "*DATABASE_GLSTAT\n" + card(1e-4)
        times = self.run_deck(deck(text, end=1.5 * math.pi / omega))
        peak = max(times, key=lambda s: s["belt", 1][0])
        self.assertAlmostEqual(peak["belt", 1][0], STIFF / 100.0 * speed / omega, delta=5.0)
        self.assertAlmostEqual(peak["time"], 0.5 * math.pi / omega, delta=1.1e-4)
        summary = self.json("run/summary.json")
        self.assertAlmostEqual(summary["energy"]["kinetic"], 0.5 * mass * speed**2, delta=3.0)
        self.assertAlmostEqual(summary["energy"]["ratio"], 1.0, delta=1e-3)


def solve(f, low, high):
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if f(middle) > 0 else (low, middle)
    return low


class Rings(SeatBelts):
    def over_a_ring(self, ring, *, way=4.0, more="", back=None):
        """Belt 1 from (0, 0) to the ring at (100, 0), belt 2 from there to (100, 100): a quarter turn. Node 1 is pulled away."""
        text = material() + nodes([(0, 0, 0), (100, 0, 0), (100, 100, 0), (100, 0, 0)]) + belts((1, 1, 2, 0, 0.0), (2, 2, 3, 0, 0.0))
        return deck(text + held(3, 4) + driven(1, 1, *(back or ((0.0, 0.0), (8e-3, -way), (1.0, -way)))) + "*ELEMENT_SEATBELT_SLIPRING\n" + ring + more, end=9e-3)

    def expected(self, way, ratio):
        """Tensions, and what went from belt 2 to belt 1."""
        slip = solve(lambda d: ((100 + way) / (100 + d) - 1) - ratio * (100 / (100 - d) - 1), 0.0, 50.0)
        return STIFF * ((100 + way) / (100 + slip) - 1), STIFF * (100 / (100 - slip) - 1), slip

    def test_friction(self):
        """T1 = T2 exp(mu theta), theta a quarter turn, and both belts together keep their unstretched length."""
        for friction in (0.0, 0.2, 0.5):
            with self.subTest(friction):
                times = self.run_deck(self.over_a_ring(card(5, 1, 2, friction, 4)))
                one, two, slip = self.expected(4.0, math.exp(friction * math.pi / 2))
                for time in (4e-3, 8.5e-3):
                    share = min(1.0, time / 8e-3)
                    one, two, slip = self.expected(4.0 * share, math.exp(friction * math.pi / 2))
                    self.assertAlmostEqual(self.tension(times, 1, time), one, delta=0.004 * one + 1.0)
                    self.assertAlmostEqual(self.tension(times, 2, time), two, delta=0.004 * two + 1.0)
                self.assertAlmostEqual(times[-1]["slip", 5][0], slip, delta=1e-3)
                self.assertAlmostEqual(times[-1]["belt", 1][1] + times[-1]["belt", 2][1], 200.0, delta=1e-3)

    def test_static_friction_ways_and_locking(self):
        quarter = math.pi / 2
        # FC while it slides; when node 1 has come back by half FC alone lets it slide back, FCS 3 at rest does not.
        back = ((0.0, 0.0), (4e-3, -4.0), (5e-3, -4.0), (8e-3, -3.0), (1.0, -3.0))
        slips = {}
        for sticking in (0.0, 3.0):
            times = self.run_deck(self.over_a_ring(card(5, 1, 2, 0.1, 4, "", sticking), back=back))
            self.assertAlmostEqual(self.state(times, 4.5e-3)["slip", 5][0], self.expected(4.0, math.exp(0.1 * quarter))[2], delta=2e-3)
            slips[sticking] = times[-1]["slip", 5][0]
        self.assertAlmostEqual(slips[0.0], solve(lambda d: 1.0 - (100 / (100 - d) - 1) / max(1e-9, (103 / (100 + d) - 1) * math.exp(0.1 * quarter)), 0.5, 1.9), delta=2e-3)
        self.assertAlmostEqual(slips[3.0], self.expected(4.0, math.exp(0.1 * quarter))[2], delta=2e-3)
        # FC < 0: its curve over time.
        times = self.run_deck(self.over_a_ring(card(5, 1, 2, -14, 4), more=curve(14, (0.0, 0.3), (1.0, 0.3))))
        self.assertAlmostEqual(self.tension(times, 1, 8.5e-3), self.expected(4.0, math.exp(0.3 * quarter))[0], delta=8.0)
        # DIRECT 12: from belt 1 to belt 2 only. Belt 1 is stretched alone.
        times = self.run_deck(self.over_a_ring(card(5, 1, 2, 0.0, 4) + card("", "", 12)))
        self.assertAlmostEqual(self.tension(times, 1, 8.5e-3), STIFF * 0.04, delta=1.0)
        # LTIME at half of the way: what is stretched from then on stays in belt 1.
        times = self.run_deck(self.over_a_ring(card(5, 1, 2, 0.0, 4, 4e-3)))
        slip = self.expected(2.0, 1.0)[2]
        self.assertAlmostEqual(self.tension(times, 1, 8.5e-3), STIFF * (104 / (100 + slip) - 1), delta=8.0)
        # DC: between both by the speed of sliding, here 0.25 mm/ms in the mean of both belts.
        times = self.run_deck(self.over_a_ring(card(5, 1, 2, 0.1, 4, "", 0.5) + card("", "", "", 1e-9)))
        self.assertAlmostEqual(self.tension(times, 1, 4e-3) / self.tension(times, 2, 4e-3), math.exp(0.5 * quarter), delta=0.02)

    def test_belts_that_pass(self):
        """Six belts of 20 mm on the far side, whose end a force of 100 N holds back: pulled 60 mm, three of them come through the ring; T1 = T2 exp(mu theta) all the while."""
        far_side = [(100, 20 * i, 0) for i in range(1, 7)]
        text = material(mpul=1e-8) + nodes([(0, 0, 0), (100, 0, 0), *far_side, (100, 0, 0)]) + belts((1, 1, 2, 0, 0.0), *((2 + i, 2 + i, 3 + i, 0, 0.0) for i in range(6)))
        text += f"*ELEMENT_MASS\n{1:8}{8:8}{2e-5:16}\n*LOAD_NODE_POINT\n" + card(8, 2, 15, 1.0) + curve(15, (0.0, 0.0), (1e-2, 100.0), (1.0, 100.0)) + held(9)
        text += driven(1, 1, (0.0, 0.0), (1e-2, 0.0), (2e-2, -2.0), (8e-2, -62.0), (1.0, -62.0)) + "*ELEMENT_SEATBELT_SLIPRING\n" + card(5, 1, 2, 0.2, 9)
        text += "*DAMPING_GLOBAL\n" + card(0, 200.0) + "*BOUNDARY_SPC_NODE\n" + "".join(card(n, 0, 1, 0, 1) for n in (8,)) + "*DATABASE_GLSTAT\n" + card(1e-3)
        times = self.run_deck(deck(text, end=9e-2, interval=1e-3))
        log = self.read("run/run.log")
        self.assertRegex(log, r"belt 2 has passed slip ring 5\n(.*\n)*.*belt 3 has passed slip ring 5\n(.*\n)*.*belt 4 has passed slip ring 5")
        self.assertNotIn("belt 5 has passed", log)
        late = [s for s in times if 3e-2 < s["time"] < 7.8e-2]
        mean = lambda belt: sum(s["belt", belt][0] for s in late) / len(late)  # noqa: E731
        self.assertAlmostEqual(mean(7), 104.0, delta=1.0)  # and what damps the mass: 200/s of 2e-5 at 1000 mm/s
        self.assertAlmostEqual(mean(1), 104.0 * math.exp(0.2 * math.pi / 2), delta=2.0)
        self.assertAlmostEqual(sum(late[-1]["belt", b][1] for b in range(1, 8)), 220.0, delta=0.2)
        self.assertAlmostEqual(self.json("run/summary.json")["energy"]["ratio"], 1.0, delta=0.02)

    def test_what_is_refused(self):
        ring = self.over_a_ring(card(5, 1, 2, 0.0, 4))
        self.refused(ring.replace(f"{1:8}{1:8}{1:8}{2:8}{0:8}{0.0:16}\n", f"{1:8}{1:8}{1:8}{2:8}{0:8}{0.0:16}{3:8}{4:8}\n"), "n3 = 3: belts of shells are not built")
        self.refused(self.over_a_ring(card(5, 1, 2, 0.0, 3)), "the node where both belts meet is not where the ring is")
        self.refused(self.over_a_ring(card(5, 1, 1, 0.0, 4)), "name neighbours that meet at the ring")
        self.refused(self.over_a_ring(card(5, 1, 2, 0.0, 4, "", "", 3)), "onid = 3: the skew of belts at a ring is not built")
        self.refused(self.over_a_ring(card(5, 1, 2, 0.0, 4) + card(0.3)), "k = 0.3: friction by skew, function or normal force is not built")
        self.refused(ring.replace(card(1, 1e-9, 11, 0, LEAST), card(1, 1e-9, 11, 0, 0.0)), "belts at slip rings need a least length")
        self.refused(ring.replace(card(1, 1e-9, 11, 0, LEAST), card(1, 1e-9, 11, 0, LEAST, "", "", 100.0)), "e = 100.0: bending and compression of belts are not built")


class Retractors(SeatBelts):
    def out_of_a_retractor(self, sensor, *, law=card(0.0, 0.0, 12, 0, FED), way=((0.0, 0.0), (1e-2, 50.0), (1.0, 50.0)), more="", end=1.2e-2, sensors=(1,)):
        """A belt of 30 mm comes out of a retractor at (0, 0) in which four more are wound up; its end is pulled away."""
        text = material(mpul=1e-11) + nodes([(30, 0, 0), (0, 0, 0), (0, 0, 0), (0, 0, 0), (0, 0, 0), (0, 0, 0), (0, 0, 0)])
        text += belts((1, 1, 2, 0, 0.0), *((2 + i, 2 + i, 3 + i, 7, 0.0) for i in range(4))) + held(7) + driven(1, 1, *way) + more
        text += curve(12, (0.0, 200.0), (10.0, 1200.0), (50.0, 1200.0)) + curve(13, (0.0, 0.0), (2.0, 1200.0)) + "*ELEMENT_SEATBELT_SENSOR\n" + sensor
        return deck(text + "*ELEMENT_SEATBELT_RETRACTOR\n" + card(7, 7, 1, *sensors) + law, end=end)

    NEVER = card(1, 3) + card(1.0)

    def test_the_first_tension_while_it_is_free(self):
        times = self.run_deck(self.out_of_a_retractor(self.NEVER))
        for time in (4e-3, 8e-3, 1.15e-2):
            self.assertAlmostEqual(self.state(times, time)["retractor", 7][1], 200.0, delta=1.0)
            pulled = 5000.0 * min(time, 1e-2)
            self.assertAlmostEqual(self.state(times, time)["retractor", 7][0], (30 + pulled) / (1 + 200.0 / STIFF) - 30, delta=0.01)
        self.assertRegex(self.read("run/run.log"), r"belt 2 has come out of retractor 7\n(.*\n)*.*belt 3 has come out of retractor 7")
        out = [times[-1]["belt", b][1] for b in (1, 2, 3, 4, 5)]
        self.assertAlmostEqual(sum(out), 80 / (1 + 200.0 / STIFF), delta=0.01)
        for belt in (1, 2, 3, 4):
            self.assertAlmostEqual(times[-1]["belt", belt][0], 200.0, delta=1.0)

    def locked(self, way, at):
        """Tension `way` after it has locked, where 30 + at was out: T of the belt = F(u)."""
        length = 30.0 + at
        u = solve(lambda u: STIFF * ((length + way) / (length / (1 + 200.0 / STIFF) + u) - 1) - min(1200.0, 200.0 + 100.0 * u), 0.0, 60.0)
        return min(1200.0, 200.0 + 100.0 * u)

    def test_locked(self):
        """From 3 ms on, where 15 mm are out: along the loading curve, which ends in a plateau of 1200 N."""
        times = self.run_deck(self.out_of_a_retractor(card(1, 3) + card(3e-3)))
        for time in (4e-3, 5e-3, 8e-3):
            self.assertAlmostEqual(self.state(times, time)["retractor", 7][1], self.locked(5000.0 * (time - 3e-3), 15.0), delta=8.0)
        self.assertIn("retractor 7 has locked", self.read("run/run.log"))

    def test_delay_and_free_way(self):
        """A sensor at 1 ms, 1 ms later 10 mm more: locked where 20 mm are out."""
        times = self.run_deck(self.out_of_a_retractor(card(1, 3) + card(1e-3), law=card(1e-3, 10.0, 12, 0, FED)))
        self.assertAlmostEqual(self.state(times, 3.8e-3)["retractor", 7][1], 200.0, delta=1.0)
        self.assertAlmostEqual(self.state(times, 5e-3)["retractor", 7][1], self.locked(5.0, 20.0), delta=10.0)

    def test_unloading(self):
        """After 8 ms the end comes back by 4 mm: along the unloading curve, 600 N a mm, down to the first tension."""
        way = ((0.0, 0.0), (8e-3, 40.0), (1e-2, 39.5), (1.2e-2, 36.0), (1.0, 36.0))
        times = self.run_deck(self.out_of_a_retractor(card(1, 3) + card(3e-3), law=card(0.0, 0.0, 12, 13, FED), way=way, end=1.4e-2))
        before = self.state(times, 8e-3)["retractor", 7]
        self.assertAlmostEqual(before[1], 1200.0, delta=1.0)
        after = self.state(times, 1e-2)["retractor", 7]
        self.assertAlmostEqual(after[1], 1200.0 - 600.0 * (before[0] - after[0]), delta=3.0)
        self.assertLess(after[1], 1100.0)
        self.assertAlmostEqual(times[-1]["retractor", 7][1], 200.0, delta=1.0)

    def test_a_belt_that_goes_in(self):
        """The end comes nearer by 28 mm: the retractor reels in with its first tension, and belts go in again."""
        way = ((0.0, 0.0), (6e-3, 40.0), (1.8e-2, 2.0), (1.0, 2.0))
        times = self.run_deck(self.out_of_a_retractor(self.NEVER, way=way, end=2e-2))
        self.assertRegex(self.read("run/run.log"), r"belt 3 has come out of retractor 7\n(.*\n)*.*belt 3 has gone into retractor 7")
        self.assertAlmostEqual(times[-1]["retractor", 7][1], 200.0, delta=1.0)
        self.assertAlmostEqual(times[-1]["retractor", 7][0], 32 / (1 + 200.0 / STIFF) - 30, delta=0.01)

    def test_sensors(self):
        """Distance, pull-out, rate of pull-out, an acceleration, and a switch lock it at times that are known."""
        def when(sensor, **options):
            self.run_deck(self.out_of_a_retractor(sensor, **options))
            return float(re.search(r"time (\S+): retractor 7 has locked", self.read("run/run.log"))[1])
        self.assertAlmostEqual(when(card(1, 4) + card(1, 7, 60.0)), 6e-3, delta=2e-5)
        self.assertAlmostEqual(when(card(1, 4) + card(1, 7, 0.0, 31.0)), 0.0, delta=2e-5)
        self.assertAlmostEqual(when(card(1, 5) + card(7, 20.0)), 4e-3, delta=4e-5)
        self.assertAlmostEqual(when(card(1, 2) + card(7, 4000.0, 2e-3)), 2e-3, delta=1e-4)
        # the end from rest: 1/2 a t^2 with a = 1e6 from 2 ms on
        points = [(round(i * 1e-4, 6), round(0.5e6 * (max(0, i - 20) * 1e-4)**2, 6)) for i in range(60)]
        self.assertAlmostEqual(when(card(1, 1) + card(1, 1, 2e5, 0.0), way=(*points, (1.0, points[-1][1]))), 2.1e-3, delta=1.5e-4)
        switch = "*SENSOR_SWITCH\n" + card(1, "TIME", 0, "", 5e-3) + "*SENSOR_CONTROL\n" + card(3, "BELTRETRA", 7) + card("OFF", 1)
        self.assertAlmostEqual(when(self.NEVER, more=switch, sensors=()), 5e-3, delta=2e-5)

    def test_what_switches_see(self):
        """A run ends by a tension, an elongation, a pull-out, a rate of it and a retractor's force, at times that are known."""
        steady = 200.0 / STIFF
        for sensor, above, time in (("*SENSOR_DEFINE_MISC\n" + card(5, "RETRACTOR", "PULLOUT", 7), 20.0, (50.0 * (1 + steady) - 30) / 5000.0),
                                    ("*SENSOR_DEFINE_MISC\n" + card(5, "RETRACTOR", "", 7), 4500.0, 0.0),
                                    ("*SENSOR_DEFINE_MISC\n" + card(5, "RETRACTOR", "FORCE", 7), 205.0, 3e-3),
                                    ("*SENSOR_DEFINE_ELEMENT\n" + card(5, "SEATBELT", 1, "", "FORCE"), 600.0, 3.84e-3)):
            with self.subTest(sensor):
                switch = sensor + "*SENSOR_SWITCH\n" + card(1, "SENSOR", 5, "GT", above, 0, 1e-4 if above > 4000 else 0.0) + "*TERMINATION_SENSOR\n" + card(1)
                self.nugget("run", self.write(self.out_of_a_retractor(card(1, 3) + card(3e-3), more=switch)).name, "-o", "run", "--quiet")
                summary = self.json("run/summary.json")
                self.assertEqual(summary["message"], "sensor switch 1 is on")
                self.assertAlmostEqual(summary["time"], time, delta=3e-4)
        ring = Rings.over_a_ring(self, card(5, 1, 2, 0.2, 4), more="*SENSOR_DEFINE_MISC\n" + card(5, "SLIPRING", "FSB2", 5) + "*SENSOR_SWITCH\n" + card(1, "SENSOR", 5, "GT", 800.0)
                                 + "*TERMINATION_SENSOR\n" + card(1))
        self.nugget("run", self.write(ring).name, "-o", "run", "--quiet")
        share = solve(lambda s: 800.0 - Rings.expected(self, 4.0 * s, math.exp(0.1 * math.pi))[1], 0.0, 1.0)
        self.assertAlmostEqual(self.json("run/summary.json")["time"], 8e-3 * share, delta=5e-5)

    def test_what_is_refused(self):
        for text, message in ((self.out_of_a_retractor(self.NEVER, sensors=(9,)), "sid1 = 9: seat belt sensor 9 is not defined"),
                              (self.out_of_a_retractor(self.NEVER, law=card(0.0, 0.0, 12, 0, FED, 13)), "lcfl = 13: load limiters by switches are not built"),
                              (self.out_of_a_retractor(self.NEVER, law=card(0.0, 0.0, 12, 0, 0.0)), "lfed"),
                              (self.out_of_a_retractor(self.NEVER, law=card(0.0, 0.0, 14, 0, FED), more=curve(14, (0.0, 5.0), (1.0, 2.0))), "expected tensions of 0 and more that do not fall"),
                              (self.out_of_a_retractor(self.NEVER).replace(f"{3:8}{1:8}{3:8}{4:8}{7:8}", f"{3:8}{1:8}{5:8}{4:8}{7:8}"), "does not go on from the one that comes out of it")):
            with self.subTest(message):
                self.refused(text, message)


class Pretensioners(SeatBelts):
    """A belt of 100 mm between two nodes that are held, one of them a retractor whose tension is 200 N while it is free, 100 N more for each
    mm that comes out once it is locked, 1200 N at most. A sensor at 1 ms, the pretensioner 1 ms later; pull-in over 4 ms."""
    FREE = 100.0 / (1 + 200.0 / STIFF)

    def drawn(self, kind, pull_in, limit=0.0, sensors=(2,), more=""):
        text = material() + nodes([(100, 0, 0), (0, 0, 0)]) + held(1, 2) + belts((1, 1, 2, 0, 0.0))
        text += curve(12, (0.0, 200.0), (10.0, 1200.0), (50.0, 1200.0)) + curve(15, (0.0, 0.0), (4e-3, pull_in), (5e-3, pull_in))
        text += "*ELEMENT_SEATBELT_SENSOR\n" + card(1, 3) + card(1.0) + card(2, 3) + card(1e-3)
        text += "*ELEMENT_SEATBELT_RETRACTOR\n" + card(7, 2, 1, 1) + card(0.0, 0.0, 12, 0, FED)
        return deck(text + "*ELEMENT_SEATBELT_PRETENSIONER\n" + card(4, kind, *sensors) + card(7, 1e-3, 15, limit) + more)

    def of_length(self, length):
        return STIFF * (100.0 / length - 1.0)

    def test_pull_in_behind_the_curve_of_the_retractor(self):
        """Type 1: what is pulled out and the pull-in together make the tension, as on a spool behind a torsion bar."""
        for pull_in in (2.0, 20.0):
            with self.subTest(pull_in):
                times = self.run_deck(self.drawn(1, pull_in))
                self.assertAlmostEqual(self.tension(times, 1, 1.9e-3), 200.0, delta=0.5)
                for time, steps in ((4e-3, 2.0), (9e-3, 0.0)):  # by two steps it may begin later
                    drawn = pull_in * min(1.0, (self.state(times, time)["time"] - 2e-3) / 4e-3)
                    u = solve(lambda u: self.of_length(self.FREE + u - drawn) - min(1200.0, 200.0 + 100.0 * u), 0.0, 60.0)
                    self.assertAlmostEqual(self.tension(times, 1, time), min(1200.0, 200.0 + 100.0 * u), delta=1.0 + steps * pull_in / 4e-3 * 100.0 * 1e-5)
                    self.assertAlmostEqual(self.state(times, time)["retractor", 7][0], self.FREE - 100.0 + u - drawn, delta=0.01 + steps * pull_in / 4e-3 * 1e-5)
                self.assertRegex(self.read("run/run.log"), r"time 0\.002\d*: pretensioner 4 acts\n(.*\n)*.*retractor 7 has locked")
                self.assertAlmostEqual(self.json("run/summary.json")["energy"]["ratio"], 1.0, delta=1e-3)

    def test_pull_in_whatever_the_tension(self):
        """Type 5: the length is what the curve says; then the retractor is locked, its load limit 1200 N."""
        times = self.run_deck(self.drawn(5, 2.0))
        for time in (3e-3, 5.8e-3):
            self.assertAlmostEqual(self.tension(times, 1, time), self.of_length(self.FREE - 2.0 * (time - 2e-3) / 4e-3), delta=4.0)
        self.assertAlmostEqual(self.tension(times, 1, 6.5e-3), self.of_length(self.FREE - 2.0), delta=2.0)
        self.assertAlmostEqual(self.tension(times, 1, 9e-3), 1200.0, delta=1.0)
        # LMTFRC ends it, and the belt keeps that tension
        times = self.run_deck(self.drawn(5, 2.0, limit=900.0))
        self.assertAlmostEqual(self.tension(times, 1, 3e-3), self.of_length(self.FREE - 0.5), delta=4.0)
        for time in (5e-3, 9e-3):
            self.assertAlmostEqual(self.tension(times, 1, time), 900.0, delta=4.0)

    def test_a_switch_makes_it_act(self):
        switch = "*SENSOR_SWITCH\n" + card(1, "TIME", 0, "", 3e-3) + "*SENSOR_CONTROL\n" + card(3, "BELTPRET", 4) + card("OFF", 1)
        self.run_deck(self.drawn(5, 2.0, sensors=(), more=switch))
        self.assertRegex(self.read("run/run.log"), r"time 0\.004\d*: pretensioner 4 acts")

    def on_springs(self, kind, spring, locking):
        """A buckle of 1e-3 t on a spring of 10 N/mm that is stretched by 20 mm; a locking spring beside it."""
        springs = f"{11:8}{2:8}{1:8}{2:8}{0:8}{1.0:16}{0:8}{20.0:16}\n" + (f"{12:8}{3:8}{1:8}{2:8}\n" if locking else "")
        text = nodes([(0, 0, 0), (100, 0, 0)]) + held(1) + "*BOUNDARY_SPC_NODE\n" + card(2, 0, 0, 1, 1, 1, 1, 1)
        text += f"*ELEMENT_MASS\n{1:8}{2:8}{1e-3:16}\n*SECTION_DISCRETE\n" + card(5) + card(0.0)
        text += "*MAT_SPRING_ELASTIC\n" + card(5, 10.0) + "*MAT_SPRING_ELASTIC\n" + card(6, 1e4) + "*PART\nbuckle\n" + card(2, 5, 5)
        text += ("*PART\nlock\n" + card(3, 5, 6) if locking else "") + "*ELEMENT_DISCRETE\n" + springs
        text += "*ELEMENT_SEATBELT_SENSOR\n" + card(2, 3) + card(1e-3) + "*ELEMENT_SEATBELT_PRETENSIONER\n" + card(4, kind, 2) + card(spring, 1e-3)
        text += "*DATABASE_DEFORC\n" + card(1e-4) + "*CONTROL_TIMESTEP\n" + card(0, 0.9, 0, 0, 0, 80) + curve(80, (0.0, 1e-5), (1.0, 1e-5))
        self.nugget("run", self.write(deck(text, end=1.3e-2)).name, "-o", "run", "--quiet")
        found, time, number = {}, 0.0, 0
        for name, value in re.findall(r"^ (time|spring/damper number|change in length|resultant force)\.+ *(\S+)", self.read("run/deforc"), re.M):
            if name == "time":
                time = round(float(value), 4)
            elif name == "spring/damper number":
                number = int(value)
            else:
                found[time, number, name] = float(value)
        return found

    def test_springs_that_move_a_buckle(self):
        """Type 2: the spring has no force until then; type 3: the locking spring has none from then on. Then 20 mm cos(100 t)."""
        for kind, spring, locking, at_rest in ((2, 11, False, 20.0), (3, 12, True, 20.0 - 200.0 / 1e4)):
            with self.subTest(kind):
                found = self.on_springs(kind, spring, locking)
                self.assertAlmostEqual(found[1.9e-3, 11, "change in length"], at_rest, delta=0.021)
                self.assertAlmostEqual(found[1.9e-3, 11, "resultant force"], 0.0 if kind == 2 else 200.0, delta=0.3)
                for time in (7e-3, 1.2e-2):
                    self.assertAlmostEqual(found[time, 11, "change in length"], 20.0 * math.cos(100.0 * (time - 2e-3)), delta=0.12)
                self.assertEqual(found.get((1.2e-2, 12, "resultant force"), 0.0), 0.0)
                self.assertIn("pretensioner 4 acts", self.read("run/run.log"))
                self.assertAlmostEqual(self.json("run/summary.json")["energy"]["ratio"], 1.0, delta=1e-3)

    def test_what_is_refused(self):
        for text, message in ((self.drawn(4, 2.0), "sbprty = 4: this type of pretensioner is not built"),
                              (self.drawn(5, 2.0, sensors=()), "nothing makes it act"),
                              (self.drawn(5, 2.0, sensors=(3,)), "sbsid1 = 3: seat belt sensor 3 is not defined"),
                              (self.drawn(5, -2.0), "expected lengths of 0 and more that do not fall"),
                              (self.drawn(3, 2.0), "sbrid = 7: discrete element 7 is not defined"),
                              (self.drawn(5, 2.0, more=card(5, 1, 2) + card(7, 0.0, 15)), "this retractor has a pretensioner already")):
            with self.subTest(message):
                self.refused(text, message)


class SameBits(SeatBelts):
    def deck(self):
        return Retractors.out_of_a_retractor(self, card(1, 3) + card(6e-3), law=card(0.0, 0.0, 12, 13, FED), more="*DATABASE_GLSTAT\n" + card(1e-4) + "*DATABASE_NODOUT\n" + card(1e-4)
                                       + "*DATABASE_HISTORY_NODE\n" + card(1, 2, 3) + "*DATABASE_BINARY_D3PLOT\n" + card(2e-3))

    def test_threads_and_lanes(self):
        self.compare(self.write(self.deck()))

    def test_restart(self):
        self.resumed(self.deck())

    def test_restart_while_pretensioners_act(self):
        for kind in (1, 5):
            with self.subTest(kind):
                self.resumed(Pretensioners.drawn(self, kind, 2.0, more="*DATABASE_GLSTAT\n" + card(1e-4) + "*DATABASE_BINARY_D3PLOT\n" + card(2e-3)))


if __name__ == "__main__":
    unittest.main()
