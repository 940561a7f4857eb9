# SPDX-License-Identifier: Apache-2.0
"""*CONSTRAINED_RIGID_BODY_STOPPERS: a body that flies or is pulled goes no farther and no faster than its bounds; what it loses is the work
of the stop."""
import math
import unittest

import lsda
from repeated_runs import RepeatedRuns

SIDE, DENSITY, END = 10.0, 7.85e-9, 1e-2
MASS = DENSITY * SIDE**3
CENTRE = (5.0, 5.0, 15.0)


def deck(cards, speed=(0, 0, 0)):
    corners = [(x, y, z) for z in (10, 20) for x, y in ((0, 0), (10, 0), (10, 10), (0, 10))]
    return "\n".join([
        "*KEYWORD", f"*CONTROL_TERMINATION\n{END}", "*CONTROL_ENERGY\n2,2,2,2", "*DATABASE_RBDOUT\n1e-4,2", "*DATABASE_GLSTAT\n1e-4",
        f"*MAT_RIGID\n1,{DENSITY},210000,0.3\n\n", "*SECTION_SOLID\n1,1\n*PART\nbrick\n7,1,1", "*ELEMENT_SOLID\n1,7,11,12,13,14,15,16,17,18",
        f"*INITIAL_VELOCITY_RIGID_BODY\n7,{speed[0]},{speed[1]},{speed[2]}", cards,
        "*NODE", *(f"{11 + i},{x},{y},{z}" for i, (x, y, z) in enumerate(corners)), "*END", ""])


def level(number, *points):
    return "\n".join([f"*DEFINE_CURVE\n{number}", *(f"{t},{y}" for t, y in points)]) + "\n"


def stopper(most=0, least=0, fastest=0, direction=1, vector=0, birth=0, death=0):
    return f"*CONSTRAINED_RIGID_BODY_STOPPERS\n7,{most},{least},0,0,{fastest},{direction},{vector}\n{birth},{death}\n"


class Stoppers(RepeatedRuns):
    def places(self, cards, speed=(0, 0, 0)):
        """[(time, place, velocity)] of the body's centre, and the last state of glstat."""
        return self.places_of(deck(cards, speed))

    def places_of(self, text, spins=False):
        self.nugget("run", self.write(text).name, "-o", "run", "--quiet")
        states = lsda.states(lsda.read(self.folder / "run" / "binout0000"), "rbdout")
        energies = self.glstat("run/glstat")
        start, most = energies[0]["total energy"], max(state["kinetic energy"] for state in energies)
        for state in energies:
            self.assertAlmostEqual(state["total energy"], start + state["external work"], delta=1e-5 * most)
        place, velocity = ("global_rd", "global_rv") if spins else ("global_", "global_v")
        return [(s["time"][0], [s[place + a][0] for a in "xyz"], [s[velocity + a][0] for a in "xyz"]) for s in states], energies[-1]

    def test_a_wall(self):
        """Thrown against it: there at once, and there it stays; along the wall nothing changes."""
        for most, bound in ((1, 6.0), (-1, 1.0)):  # a coordinate, a displacement
            states, last = self.places(level(1, (0, bound), (1, bound)) + stopper(most=most), (400.0, 300.0, 0.0))
            for time, place, velocity in states:
                self.assertAlmostEqual(place[0], min(CENTRE[0] + 400.0 * time, 6.0), delta=1e-9)
                self.assertAlmostEqual(place[1], CENTRE[1] + 300.0 * time, delta=1e-9)
                if abs(time - 1.0 / 400.0) > 2e-5:  # two steps, between which it is the mean
                    self.assertAlmostEqual(velocity[0], 400.0 if time < 1.0 / 400.0 else 0.0, delta=1e-6)
            self.assertAlmostEqual(last["external work"], -0.5 * MASS * 400.0**2, delta=1e-3 * 0.5 * MASS * 400.0**2)

    def test_bounds_of_a_file_that_is_moved(self):
        """Coordinates are not moved with the file; displacements need not be."""
        for most, said in ((1, True), (-1, False)):
            self.write(deck(level(1, (0, 6.0), (1, 6.0)) + stopper(most=most)), "inner.k")
            self.write("*KEYWORD\n*INCLUDE_TRANSFORM\ninner.k\n0,0,0,0,0,0,0\n0\n\n5\n*DEFINE_TRANSFORMATION\n5\nTRANSL,100,0,0\n*END\n", "outer.k")
            run = self.nugget("run", "outer.k", "-o", "moved", "--quiet", "--max-cycles", 2).stderr
            self.assertEqual("lcmax = 1: bounds by coordinate are those of the main deck" in run, said, run)

    def test_from_below_along_a_vector(self):
        cards = "*DEFINE_VECTOR\n3,0,0,0,0,3,4\n" + level(2, (0, -2.0), (1, -2.0)) + stopper(least=-2, direction=4, vector=3)
        states, _ = self.places(cards, (0.0, -300.0, -400.0))
        for time, place, _velocity in states:
            along = 0.6 * (place[1] - CENTRE[1]) + 0.8 * (place[2] - CENTRE[2])
            self.assertAlmostEqual(along, max(-500.0 * time, -2.0), delta=1e-9)

    def test_a_wall_that_moves_and_ends(self):
        """It comes in at 200 mm/s from 2 mm away and pushes; after 6 ms it is gone, and the body flies on with its speed."""
        cards = level(1, (0, 7.0), (1e-2, 5.0)) + stopper(most=1, death=6e-3)
        states, last = self.places(cards, (100.0, 0.0, 0.0))
        met = 2.0 / 300.0  # 5 + 100 t = 7 - 200 t
        self.assertGreater(met, 6e-3)
        self.assertAlmostEqual(states[-1][1][0], 6.0, delta=1e-9)  # never met
        cards = level(1, (0, 6.0), (1e-2, 4.0)) + stopper(most=1, death=6e-3)
        states, last = self.places(cards, (100.0, 0.0, 0.0))
        met = 1.0 / 300.0
        for time, place, velocity in states:
            if time < met - 1e-5:
                self.assertAlmostEqual(velocity[0], 100.0, delta=1e-6)
            elif time > met + 3e-5:
                self.assertAlmostEqual(velocity[0], -200.0, delta=1e-6)
                self.assertAlmostEqual(place[0], 6.0 - 200.0 * time, delta=1e-9)  # also behind 6 ms
        self.assertAlmostEqual(last["external work"], 0.5 * MASS * (200.0**2 - 100.0**2), delta=1e-3 * MASS * 200.0**2)

    def test_too_fast_from_the_start(self):
        """Thrown at 400 mm/s where 100 are allowed: the loss is work of the stop."""
        states, last = self.places(level(1, (0, 100.0), (1, 100.0)) + stopper(fastest=1), (400.0, 0.0, 0.0))
        self.assertAlmostEqual(states[-1][1][0], CENTRE[0] + 100.0 * END, delta=1e-9)
        self.assertAlmostEqual(last["external work"], -0.5 * MASS * (400.0**2 - 100.0**2), delta=1e-6 * MASS * 400.0**2)

    def test_the_greatest_speed(self):
        """Pulled by a constant force: F t / m up to 100 mm/s, then even motion; the force's work goes into the stop."""
        force = MASS * 20000.0
        cards = (level(1, (0, 100.0), (1, 100.0)) + level(2, (0, 1.0), (1, 1.0)) + stopper(fastest=1, birth=1e-3)
                 + f"*LOAD_RIGID_BODY\n7,1,2,{force}\n")
        states, last = self.places(cards)
        for time, place, velocity in states:
            self.assertAlmostEqual(velocity[0], min(20000.0 * time, 100.0), delta=0.21)  # a step of 1e-5 s
        self.assertAlmostEqual(states[-1][1][0], CENTRE[0] + 0.25 + 100.0 * (END - 5e-3), delta=2e-3)
        self.assertAlmostEqual(last["external work"], 0.5 * MASS * 100.0**2, delta=1e-2 * MASS * 100.0**2)

    def angles(self, cards, spin, box=(SIDE, SIDE, SIDE)):
        """[(time, angle about z, spin about z)] of a box that turns, and the states of glstat; nodes tell the angle."""
        a, b, c = box
        text = deck(cards).replace("*INITIAL_VELOCITY_RIGID_BODY\n7,0,0,0", f"*INITIAL_VELOCITY_RIGID_BODY\n7,0,0,0,0,0,{spin}")
        corners = [(x, y, z) for z in (10, 10 + c) for x, y in ((0, 0), (a, 0), (a, b), (0, b))]
        text = text[:text.index("*NODE\n")] + "*NODE\n" + "\n".join(f"{11 + i},{x},{y},{z}" for i, (x, y, z) in enumerate(corners)) + "\n*END\n"
        self.nugget("run", self.write(text).name, "-o", "run", "--quiet")
        states = lsda.states(lsda.read(self.folder / "run" / "binout0000"), "rbdout")
        energies = self.glstat("run/glstat")
        start, most = energies[0]["total energy"], max(state["kinetic energy"] for state in energies)
        for state in energies:
            self.assertAlmostEqual(state["total energy"], start + state["external work"], delta=1e-4 * most)
        return [(s["time"][0], s["global_rdz"][0], s["global_rvz"][0]) for s in states], energies

    def test_a_stop_of_turning(self):
        """A box that turns about z stops at an angle, by a place or by a displacement; what it had is the work of the stop."""
        inertia = MASS * (SIDE**2 + SIDE**2) / 4  # of eight masses at the corners
        for most in (1, -1):
            states, energies = self.angles(level(1, (0, 0.5), (1, 0.5)) + stopper(most=most, direction=7), 200.0)
            for time, angle, spin in states:
                self.assertAlmostEqual(angle, min(200.0 * time, 0.5), delta=1e-6)
                if abs(time - 0.5 / 200.0) > 2e-5:
                    self.assertAlmostEqual(spin, 200.0 if time < 0.5 / 200.0 else 0.0, delta=1e-6)
            self.assertAlmostEqual(energies[-1]["external work"], -0.5 * inertia * 200.0**2, delta=2e-3 * 0.5 * inertia * 200.0**2)

    def test_a_stop_that_turns_back_and_a_greatest_spin(self):
        cards = level(1, (0, 0.5), (1e-2, -0.5)) + stopper(most=1, direction=7)
        states, _ = self.angles(cards, 100.0)
        met = 0.5 / 200.0  # 100 t = 0.5 - 100 t
        for time, angle, _spin in states:
            self.assertAlmostEqual(angle, 100.0 * time if time < met else 0.5 - 100.0 * time, delta=1e-6)
        states, _ = self.angles(level(1, (0, 30.0), (1, 30.0)) + stopper(fastest=1, direction=7), 100.0)
        self.assertAlmostEqual(states[-1][1], 30.0 * END, delta=30.0 * 2e-5)

    def test_a_stop_about_an_axis_of_no_symmetry(self):
        """Stopped about an axis askew to its own, a box gets a torque about that axis only: momentum across it stays."""
        n = (0.6, 0.0, 0.8)
        cards = "*DEFINE_VECTOR\n3,0,0,0,3,0,4\n" + level(1, (0, 1e-3), (1, 1e-3)) + stopper(most=1, direction=8, vector=3)
        states, energies = self.angles(cards, 50.0, box=(20.0, 6.0, 10.0))
        # 50 rad/s about z are 40 about n: met after 1e-3/40 s, when the box has hardly turned.
        mass = DENSITY * 20 * 6 * 10
        inertia = [mass * (6**2 + 10**2) / 4, mass * (20**2 + 10**2) / 4, mass * (20**2 + 6**2) / 4]  # of eight masses at the corners
        ease = sum(a * a / i for a, i in zip(n, inertia))
        loss = 0.5 * 40.0**2 / ease
        after = next(state for state in energies if state["time"] > 1.5e-4)
        self.assertAlmostEqual(after["external work"], -loss, delta=0.02 * loss)

    def test_a_body_that_is_beyond_its_bound(self):
        """It is not carried back, which in one step would make it fly on at 1e5 mm/s: it goes no farther, and may come back by itself."""
        beyond = level(1, (0, 4.0), (1, 4.0))
        said = self.nugget("check", self.write(deck(beyond + stopper(most=1))).name).stderr
        self.assertIn("body 7 starts 1 beyond the bound of LCMAX: it goes no farther, and is not carried back", said)
        for speed, x in ((40.0, CENTRE[0]), (-40.0, CENTRE[0] - 40.0 * END)):
            states, last = self.places(beyond + stopper(most=1), (speed, 300.0, 0.0))
            self.assertAlmostEqual(states[-1][1][0], x, delta=1e-9)
            self.assertAlmostEqual(states[-1][1][1], CENTRE[1] + 300.0 * END, delta=1e-9)
            self.assertAlmostEqual(last["external work"], -0.5 * MASS * 40.0**2 if speed > 0 else 0.0, delta=1e-3 * MASS * 40.0**2)
        # it has passed the bound when the stopper begins, which then moves away with 50 mm/s
        cards = level(1, (0, 6.0), (5e-3, 6.0), (1e-2, 6.25)) + stopper(most=1, birth=5e-3)
        states, last = self.places(cards, (400.0, 0.0, 0.0))
        for time, place, _velocity in states:
            self.assertAlmostEqual(place[0], CENTRE[0] + 400.0 * min(time, 5e-3) + 50.0 * max(0.0, time - 5e-3), delta=400.0 * 1.1e-5)
        self.assertAlmostEqual(last["external work"], 0.5 * MASS * (50.0**2 - 400.0**2), delta=1e-2 * MASS * 400.0**2)

    def test_beside_constraints_of_the_body(self):
        """A slide along x with a stop across it: the stop pushes along the slide; y stays as CON1 says."""
        cards = "*DEFINE_VECTOR\n3,0,0,0,1,1,0\n" + level(2, (0, 0.8), (1, 0.8)) + stopper(most=-2, direction=4, vector=3)
        slide = deck(cards, (400.0, 0.0, 0.0)).replace("210000,0.3\n\n\n", "210000,0.3\n1,5,0\n\n")
        states, last = self.places_of(slide)
        for time, place, _velocity in states:
            self.assertAlmostEqual(place[0], min(CENTRE[0] + 400.0 * time, CENTRE[0] + 0.8 * math.sqrt(2.0)), delta=1e-9)
            self.assertAlmostEqual(place[1], CENTRE[1], delta=1e-12)
        self.assertAlmostEqual(last["external work"], -0.5 * MASS * 400.0**2, delta=1e-6 * MASS * 400.0**2)

    def test_a_hinge_of_a_body_that_is_askew(self):
        """A hinge about z by CON2, whose body has products of inertia: the stop brings it to rest, all its energy is the stop's work."""
        n = (1.0 / math.sqrt(5.0), 0.0, 2.0 / math.sqrt(5.0))  # an axis askew to the hinge sees 2/sqrt(5) of the angle
        for axis, vector, of_hinge in ((7, 0, 1.0), (8, 3, n[2])):
            cards = "*DEFINE_VECTOR\n3,0,0,0,1,0,2\n" + level(1, (0, 0.1), (1, 0.1)) + stopper(most=1, direction=axis, vector=vector)
            hinge = deck(cards).replace("210000,0.3\n\n\n", "210000,0.3\n1,7,4\n\n").replace("7,0,0,0\n", "7,0,0,0,0,0,40\n")
            hinge = hinge.replace("12,10,0,10", "12,14,-3,8").replace("17,10,10,20", "17,15,13,26")
            states, last = self.places_of(hinge, spins=True)
            for time, angle, spin in states:
                self.assertAlmostEqual(angle[2], min(40.0 * time, 0.1 / of_hinge), delta=1e-6)
                for across in (0, 1):
                    self.assertAlmostEqual(spin[across], 0.0, delta=1e-9)
            self.assertAlmostEqual(last["external work"], -self.glstat("run/glstat")[0]["kinetic energy"], delta=1e-6)

    def test_beside_prescribed_motions(self):
        """Driven across, it is stopped along; where the motion goes against the stop, the stop counts."""
        ramp = "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n7,{},0,9,100.\n" + level(9, (0, 1.0), (1, 1.0))
        cards = "*DEFINE_VECTOR\n3,0,0,0,1,1,0\n" + level(2, (0, 0.8), (1, 0.8)) + stopper(most=-2, direction=4, vector=3)
        states, _ = self.places(cards + ramp.format(2), (400.0, 100.0, 0.0))
        reach = 0.8 * math.sqrt(2.0)
        for time, place, _velocity in states:
            self.assertAlmostEqual(place[0] - CENTRE[0], min(400.0 * time, reach - 100.0 * time), delta=1e-9)
            self.assertAlmostEqual(place[1] - CENTRE[1], 100.0 * time, delta=1e-9)
        states, last = self.places(level(2, (0, 0.8), (1, 0.8)) + stopper(most=-2) + ramp.format(1), (100.0, 0.0, 0.0))
        self.assertAlmostEqual(states[-1][1][0], CENTRE[0] + 0.8, delta=1e-9)
        self.assertAlmostEqual(last["external work"], -0.5 * MASS * 100.0**2, delta=1e-6 * MASS * 100.0**2)

    def test_two_stops_at_one_time(self):
        """In the corner of x <= 0 and y <= x the throw (10, 20) ends: it is a sum of the two normals with factors above 0."""
        cards = ("*DEFINE_VECTOR\n3,0,0,0,-1,1,0\n" + level(1, (0, 0.0), (1, 0.0)) + level(2, (0, 1e-30), (1, 1e-30))
                 + stopper(most=-2, direction=1) + stopper(most=-2, direction=4, vector=3))
        for first, second in ((0, 1), (1, 0)):
            blocks = cards.split("*CONSTRAINED_RIGID_BODY_STOPPERS\n")
            stops = ["*CONSTRAINED_RIGID_BODY_STOPPERS\n" + b for b in blocks[1:]]
            states, last = self.places(blocks[0] + stops[first] + stops[second], (10.0, 20.0, 5.0))
            for _time, place, _velocity in states:
                self.assertAlmostEqual(place[0], CENTRE[0], delta=1e-9)
                self.assertAlmostEqual(place[1], CENTRE[1], delta=1e-9)
            self.assertAlmostEqual(last["external work"], -0.5 * MASS * 500.0, delta=1e-6 * MASS * 500.0)

    def test_restart(self):
        turning = deck(level(1, (0, 0.5), (1e-2, -0.5)) + stopper(most=1, direction=7, death=6e-3))
        self.resumed(turning.replace("*INITIAL_VELOCITY_RIGID_BODY\n7,0,0,0", "*INITIAL_VELOCITY_RIGID_BODY\n7,0,0,0,0,0,100.0"), shares=(0.2, 0.5))
        self.resumed(deck(level(1, (0, 6.0), (1e-2, 4.0)) + stopper(most=1, death=6e-3), (100.0, 0, 0)), shares=(0.2, 0.5, 0.8))

    def test_what_is_refused(self):
        curve = level(1, (0, 6.0), (1, 6.0))
        for cards, text in ((curve + stopper(most=1, direction=8), "DIR 8 needs a vector"),
                            (curve + "*CONSTRAINED_RIGID_BODY_STOPPERS\n7,1,0,3,0,0,1\n\n", "psidmx = 3: bodies that stop with another one"),
                            (curve + stopper(most=1, direction=4), "DIR 4 needs a vector"), (stopper(most=-9), "lcmax = -9: curve 9 is not defined")):
            self.assertIn(text, self.nugget("check", self.write(deck(cards)).name, expect=1).stderr)
        self.assertIn("no bound is given: it stops nothing", self.nugget("check", self.write(deck(stopper())).name).stderr)


if __name__ == "__main__":
    unittest.main()
