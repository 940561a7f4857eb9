# SPDX-License-Identifier: Apache-2.0
"""*SENSOR_DEFINE_... measure what can be worked out by hand, and *SENSOR_CONTROL turns things on and off at those times."""
import math
import unittest

from few_elements import CORNERS, card, curve, nodes, part
from repeated_runs import RepeatedRuns
from shared_out import switched_tube

STEP = 1e-5
MASS, RATE = 2e-3, 4e3  # of a mass that a force pushes, which grows by so much in a second: acceleration 2e6 t
SWITCH = "*TERMINATION_SENSOR\n1"


def history(text):
    """{node: [(time, x displacement, y, z)]} of a nodout file."""
    rows, time = {}, 0.0
    for line in text.splitlines():
        if "at time" in line:
            time = float(line.split("at time")[1].split()[0])
        elif len(line) > 40 and line[:10].strip().isdigit() and "e" not in line[:10]:
            values = [float(line[10 + 12 * i:22 + 12 * i]) for i in range(3)]
            rows.setdefault(int(line[:10]), []).append((time, *values))
    return rows


class Sensors(RepeatedRuns):
    def end(self, text):
        self.nugget("run", self.write(text).name, "-o", "run", "--quiet")
        summary = self.json("run/summary.json")
        self.assertEqual(summary["termination"], "normal")
        return summary["time"], summary["message"]

    def expect(self, text, time, tolerance=2.1 * STEP):
        found, why = self.end(text)
        self.assertIn("sensor switch 1 is on", why)
        self.assertAlmostEqual(found, time, delta=tolerance)

    def places(self, text):
        """{node: [(time, displacement)]}"""
        self.nugget("run", self.write(text).name, "-o", "run", "--quiet")
        return history(self.read("run/nodout"))

    def refused(self, text, *messages):
        said = self.nugget("check", self.write(text).name, expect=1).stderr
        for message in messages:
            self.assertIn(message, said)


def deck(cards, end=1e-2, step=STEP):
    """A mass at node 1, (0, 0, 0), free to move; what else there is, `cards` say."""
    return "\n".join(["*KEYWORD", f"*CONTROL_TERMINATION\n{end}", f"*CONTROL_TIMESTEP\n0,0.9,0,0,0,9\n", f"*ELEMENT_MASS\n1,1,{MASS}",
                      f"*DEFINE_CURVE\n1\n0,0\n1,{RATE}", f"*DEFINE_CURVE\n2\n0,1\n1,1", f"*DEFINE_CURVE\n9\n0,{step}\n1,{step}",
                      f"*DATABASE_NODOUT\n1e-3", "*DATABASE_HISTORY_NODE\n1", cards, "*NODE\n1,0,0,0", "*END", ""])


def switch(sensor, above, logic="GT", more=""):
    return f"{sensor}\n*SENSOR_SWITCH\n1,SENSOR,5,{logic},{above}{more}"


class Measured(Sensors):
    def test_acceleration_of_a_node(self):
        """F / m = 2e6 t."""
        push = "*LOAD_NODE_POINT\n1,1,1,1.0\n*DEFINE_VECTOR\n7,0,0,0,-1,0,0\n"
        self.expect(deck(push + switch("*SENSOR_DEFINE_NODE\n5,1,0,0,0,ACC", 8e3) + "\n" + SWITCH), 4e-3)
        self.expect(deck(push + switch("*SENSOR_DEFINE_NODE\n5,1,0,7,0,ACC", -8e3, "LT") + "\n" + SWITCH), 4e-3)

    def test_reactions_of_a_support_and_of_a_motion(self):
        push = "*LOAD_NODE_POINT\n1,1,1,1.0\n*BOUNDARY_SPC_NODE_ID\n31,held\n1,0,1,1,1\n"
        for along, value, logic in (("X", -16.0, "LT"), ("M", 16.0, "GT"), ("7", 16.0, "GT")):
            with self.subTest(along):
                self.expect(deck(push + "*DEFINE_VECTOR\n7,0,0,0,-3,0,0\n" + switch(f"*SENSOR_DEFINE_FORCE\n5,SPC,31,{along}", value, logic) + "\n" + SWITCH), 4e-3)
        driven = f"*BOUNDARY_PRESCRIBED_MOTION_NODE_ID\n32,driven\n1,1,1,1,500.0\n"  # acceleration 500 * 4000 t
        self.expect(deck(driven + switch("*SENSOR_DEFINE_FORCE\n5,PRESC-MOT,32,X", 16.0) + "\n" + SWITCH), 4e-3)
        # work: m v^2 / 2 with v = 1e6 t^2
        self.expect(deck(driven + switch("*SENSOR_DEFINE_MISC\n5,BNDOUT,,32", 0.5 * MASS * 16.0**2) + "\n" + SWITCH), 4e-3)

    def test_force_of_a_wall(self):
        wall = "*RIGIDWALL_PLANAR_ID\n33\n0,0,0,0,0\n0.0,0,0,-1,0,0\n*LOAD_NODE_POINT\n1,1,1,1.0\n"
        self.expect(deck(wall + switch("*SENSOR_DEFINE_FORCE\n5,RWALL,33,X", -16.0, "LT") + "\n" + SWITCH), 4e-3)

    def test_functions_of_sensors(self):
        """a b + 1 with a = t and b = 1e3 t."""
        sensors = ("*DEFINE_CURVE\n3\n0,0\n1,1000\n*SENSOR_DEFINE_MISC\n6,TIME\n*SENSOR_DEFINE_MISC\n7,CURVE,,3\n"
                   "*DEFINE_FUNCTION\n8,product\nf(a, b) = a * b + 1.0\n*SENSOR_DEFINE_FUNCTION\n5,8,6,7")
        self.expect(deck(switch(sensors, 1.016) + "\n" + SWITCH), 4e-3)

    def test_delay(self):
        """On at 3 ms, 2 ms later; the condition ends in between."""
        sensor = "*DEFINE_CURVE\n3\n0,0\n3e-3,1\n4e-3,0\n*SENSOR_DEFINE_MISC\n5,CURVE,3"
        self.expect(deck(switch(sensor, 0.5, more=",0,0,2e-3") + "\n" + SWITCH), 3.5e-3)

    def test_rigid_bodies(self):
        """A brick of mass 7.85e-6 under a force that grows by 0.0157 in a second: a = 2e3 t, v = 1e3 t^2, d = 1000/3 t^3; it turns at 300/s."""
        body = ("*MAT_RIGID\n1,7.85e-9,210000,0.3\n\n\n*SECTION_SOLID\n1,1\n*PART\nbrick\n7,1,1\n*ELEMENT_SOLID\n1,7,11,12,13,14,15,16,17,18\n*NODE\n"
                + "\n".join(f"{11 + i},{10 * x},{10 * y},{10 * z}" for i, (x, y, z) in enumerate(CORNERS))
                + "\n*DEFINE_CURVE\n3\n0,0\n1,0.0157\n*LOAD_RIGID_BODY\n7,3,3\n*INITIAL_VELOCITY_RIGID_BODY\n7,0,0,0,0,0,300\n")
        for which, value, time in (("TZ,D", 1000.0 / 3 * 6e-3**3, 6e-3), ("TZ,V", 1e3 * 6e-3**2, 6e-3), ("TZ,A", 12.0, 6e-3), ("RZ,V", 299.0, 0.0)):
            with self.subTest(which):
                self.expect(deck(body + switch(f"*SENSOR_DEFINE_MISC\n5,RIGIDBODY,,7,{which}", value) + "\n" + SWITCH), time)
        self.refused(deck(body + switch("*SENSOR_DEFINE_MISC\n5,RIGIDBODY,,7,RX,D", 1.0) + "\n" + SWITCH), "i3 = D: expected D (of TX, TY, TZ), V or A")


    def test_angle_of_a_joint_stiffness(self):
        """A body turns at 300/s about z against one that stands: 50 degrees at 2.909 ms, and 17189 degrees a second."""
        def brick(first, x):
            return "".join(f"{first + i},{x + 10 * a - 5},{10 * b - 5},{10 * c - 5}\n" for i, (a, b, c) in enumerate(CORNERS))
        bodies = ("*MAT_RIGID\n1,7.85e-9,210000,0.3\n1,7,7\n\n*MAT_RIGID\n2,7.85e-9,210000,0.3\n\n\n*SECTION_SOLID\n1,1\n*PART\na\n7,1,1\n*PART\nb\n8,1,2\n*ELEMENT_SOLID\n"
                  "1,7,11,12,13,14,15,16,17,18\n2,8,21,22,23,24,25,26,27,28\n*NODE\n" + brick(11, 30) + brick(21, 50)
                  + "*INITIAL_VELOCITY_RIGID_BODY\n8,0,0,0,0,0,300\n*DEFINE_COORDINATE_SYSTEM\n1,0.0,0.0,0.0,1.0,0.0,0.0\n0.0,1.0,0.0\n*DEFINE_CURVE\n20\n-10.0,-1e-9\n10.0,1e-9\n"
                  "*CONSTRAINED_JOINT_STIFFNESS_GENERALIZED\n9,7,8,1,1\n0,0,20\n\n\n")
        for which, above, time in (("PSI", 50.0, math.radians(50.0) / 300.0), ("PSIR", 17000.0, 0.0)):
            with self.subTest(which):
                self.expect(deck(bodies + switch(f"*SENSOR_DEFINE_MISC\n5,JNTSTG,{which},9", above) + "\n" + SWITCH), time)


YOUNG, POISSON = 2.1e5, 0.3


def element_deck(kind, cards, rate=1.0, end=4e-4):
    """One element of 10 mm that is stretched along z by `rate` mm a second, held across; a spring and a bar beside it."""
    material = "*MAT_ELASTIC\n" + card(1, 7.85e-9, YOUNG, POISSON)
    places = [(10 * x, 10 * y, 10 * z) for x, y, z in CORNERS] + [(50, 0, 0), (50, 0, 10), (60, 0, 0), (60, 0, 10), (70, 0, 0)]
    text = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(end) + material + nodes(places)
    if kind == "brick":
        text += "*SECTION_SOLID\n" + card(1, 1) + part(1) + "*ELEMENT_SOLID\n" + "".join(f"{n:8}" for n in (1, 1, *range(1, 9))) + "\n"
    if kind == "shell":  # in the plane x = 0
        text += "*SECTION_SHELL\n" + card(1, 2, 0.8333, 3) + card(1, 1, 1, 1) + part(1) + "*ELEMENT_SHELL\n" + "".join(f"{n:8}" for n in (1, 1, 1, 4, 8, 5)) + "\n"
    text += "*SECTION_BEAM\n" + card(2, 3) + card(7.0) + part(2, 2) + "*ELEMENT_BEAM\n" + "".join(f"{n:8}" for n in (2, 2, 9, 10, 13)) + "\n"
    text += "*SECTION_DISCRETE\n" + card(3, 0) + "\n*MAT_SPRING_ELASTIC\n" + card(3, 500.0) + "*PART\nspring\n" + card(3, 3, 3)
    text += "*ELEMENT_DISCRETE\n" + "".join(f"{n:8}" for n in (3, 3, 11, 12)) + "\n*ELEMENT_MASS\n" + "".join(f"{e:8}{n:8}{1e-6:16}\n" for e, n in ((1, 11), (2, 12)))
    top, base = (5, 6, 7, 8, 10, 12), (1, 2, 3, 4, 9, 11)
    for identity, members in ((1, top), (2, base)):
        text += "*SET_NODE_LIST\n" + card(identity) + card(*members)
    text += "*BOUNDARY_PRESCRIBED_MOTION_SET\n" + card(1, 3, 0, 1, rate) + "*BOUNDARY_SPC_SET\n" + card(1, 0, 1, 1, 0, 1, 1, 1) + card(2, 0, 1, 1, 1, 1, 1, 1)
    return text + curve(1, (0.0, 1.0), (1.0, 1.0)) + cards + "\n*TERMINATION_SENSOR\n" + card(1) + "*END\n"


class OfElements(Sensors):
    def test_stresses_of_a_brick(self):
        """Strain t / 10 across nothing: stress lambda + 2 mu along, lambda across."""
        shear, lame = YOUNG / (2 * (1 + POISSON)), YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON))
        strain = 2e-5
        for component, modulus in (("ZZ", lame + 2 * shear), ("XX", lame), ("VM", 2 * shear), ("HYDR", lame + 2 / 3 * shear), ("PRIN1", lame + 2 * shear),
                                   ("PRIN3", lame), ("MAXS", shear)):
            with self.subTest(component):
                text = element_deck("brick", switch(f"*SENSOR_DEFINE_ELEMENT\n5,SOLID,1,{component},STRESS", modulus * strain))
                self.expect(text, 2e-4, 2.2e-6)

    def test_stresses_of_a_shell(self):
        """E / (1 - nu^2) along (y of the axes of elout), nu of it across; (SF v)^PWR."""
        plane = YOUNG / (1 - POISSON**2)
        for component, layer, value, more in (("YY", "TOP", plane, ""), ("XX", "2", POISSON * plane, ""), ("YY", "BOT", (0.01 * plane * 2e-5)**2 / 2e-5, ",0.01,2.0")):
            with self.subTest(component + layer):
                self.expect(element_deck("shell", switch(f"*SENSOR_DEFINE_ELEMENT\n5,SHELL,1,{component},STRESS,{layer}{more}", value * 2e-5)), 2e-4, 3e-6)

    def test_springs_bars_and_failure(self):
        for sensor, value in (("DISC-ELE,3,,FORCE", 500 * 2e-4), ("DISC-ELE,3,,DLEN", 2e-4), ("BEAM,2,AXIAL,FORCE", YOUNG * 7.0 * 2e-5)):
            with self.subTest(sensor):
                self.expect(element_deck("brick", switch(f"*SENSOR_DEFINE_ELEMENT\n5,{sensor}", value)), 2e-4, 2.2e-6)
        dies = "*DEFINE_ELEMENT_DEATH_BEAM\n" + card(2, 2e-4)
        self.expect(element_deck("brick", dies + switch("*SENSOR_DEFINE_ELEMENT\n5,BEAM,2,,FAIL", 0.5)), 2e-4, 3e-6)

    def test_what_is_refused(self):
        for sensor, text in (("TSHELL,1,XX,STRESS", "etype = TSHELL: of SOLID, SHELL, BEAM, DISC-ELE and SEATBELT is measured"),
                             ("SOLID,1,XX,STRAIN", "ctype = STRAIN: STRESS of bricks and shells is measured"),
                             ("BEAM,2,AXIAL,MOMENT", "ctype = MOMENT: STRESS of bricks"), ("SOLID,9,XX,STRESS", "elemid = 9: no SOLID has this id")):
            with self.subTest(sensor):
                self.refused(element_deck("brick", switch(f"*SENSOR_DEFINE_ELEMENT\n5,{sensor}", 1.0)), text)
        self.refused(element_deck("shell", switch("*SENSOR_DEFINE_ELEMENT\n5,SHELL,1,XX,STRESS,4", 1.0)), "layer = 4: the shell has 3 layers")


def times(*values):
    return "".join(f"*SENSOR_SWITCH\n{i},TIME,0,,{t}\n" for i, t in enumerate(values, 1))


def control(what, switches, start="ON", offset=0, repeat=0, word=""):
    return f"*SENSOR_CONTROL\n3,{what},{offset},{repeat},{word}\n{start},{switches}\n"


class Controlled(Sensors):
    def at(self, rows, time, component=1):
        return min(rows, key=lambda row: abs(row[0] - time))[component]

    def test_a_motion_that_begins_and_ends(self):
        """Driven to x = 1e3 (t - 2e-3) from 2 ms on, let go at 5 ms: it flies on with the same velocity. Its support is released at 2 ms."""
        drive = "*BOUNDARY_PRESCRIBED_MOTION_NODE_ID\n32,driven\n1,1,2,3\n*DEFINE_CURVE\n3\n0,0\n1,1000\n"
        rows = self.places(deck(drive + times(2e-3, 5e-3) + control("PRESC-MOT,32", "1,2", "OFF", 1)))[1]
        for time, place in ((1e-3, 0.0), (2e-3, 0.0), (4e-3, 2.0), (8e-3, 6.0)):
            self.assertAlmostEqual(self.at(rows, time), place, delta=2.1e3 * STEP)
        log = self.read("run/run.log")
        self.assertIn("*SENSOR_CONTROL 3 turns PRESC-MOT 32 on, by switch 1", log)
        self.assertIn("*SENSOR_CONTROL 3 turns PRESC-MOT 32 off, by switch 2", log)

    def test_a_motion_that_a_place_ends(self):
        """v = 1e3 until x = 3; then a force of 4 N slows the 2 g: x = 3 + v t - 1/2 2000 t^2."""
        drive = "*BOUNDARY_PRESCRIBED_MOTION_NODE_ID\n32,driven\n1,1,0,2,1000.0\n*LOAD_NODE_POINT\n1,1,2,-4.0\n"
        seen = "*DEFINE_VECTOR\n7,0,0,0,1,0,0\n" + switch("*SENSOR_DEFINE_NODE\n5,1,0,7,0,COORD", 3.0) + "\n"
        rows = self.places(deck(drive + seen + control("PRESC-MOT,32", "1")))[1]
        self.assertAlmostEqual(self.at(rows, 2e-3), 2.0, delta=0.01)
        self.assertAlmostEqual(self.at(rows, 9e-3), 3.0 + 6.0 - 1000.0 * 6e-3**2, delta=0.03)

    def test_a_support_that_lets_go_again_and_again(self):
        """Held, free for 2 ms, and so on (NREP -1): under 4 N it goes 1/2 2000 (2e-3)^2 = 4e-3 each time, from rest."""
        held = "*BOUNDARY_SPC_NODE_ID\n31,held\n1,0,1,1,1\n*LOAD_NODE_POINT\n1,1,2,4.0\n"
        saw = "*DEFINE_CURVE\n3\n0,0\n2e-3,0\n2.00001e-3,1\n4e-3,1\n4.00001e-3,0\n6e-3,0\n6.00001e-3,1\n8e-3,1\n8.00001e-3,0\n1,0\n"
        seen = saw + "*SENSOR_DEFINE_MISC\n5,CURVE,,3\n*SENSOR_SWITCH\n1,SENSOR,5,GT,0.5\n*SENSOR_SWITCH\n2,SENSOR,5,LT,0.5\n"
        rows = self.places(deck(held + seen + control("SPC,31", "1,2", "ON", 0, -1)))[1]
        for time, place in ((1e-3, 0.0), (4e-3, 4e-3), (5e-3, 4e-3), (8e-3, 8e-3), (9.5e-3, 8e-3)):
            self.assertAlmostEqual(self.at(rows, time), place, delta=1e-4)

    def test_a_wall_that_is_not_there_any_more(self):
        """A mass that hits a wall is pressed on it by 4 N, until the wall is turned off: from rest 1/2 2000 t^2."""
        wall = "*RIGIDWALL_PLANAR_ID\n33\n0,0,0,0,0\n0.0,0,0,-1,0,0\n*LOAD_NODE_POINT\n1,1,2,4.0\n*INITIAL_VELOCITY_NODE\n1,100.0\n"
        rows = self.places(deck(wall + times(4e-3) + control("RWALL,33", "1")))[1]
        self.assertAlmostEqual(self.at(rows, 4e-3), 0.0, delta=1e-9)
        self.assertAlmostEqual(self.at(rows, 9e-3), 1000.0 * 5e-3**2, delta=5e-4)
        # One that comes later stops what has not passed yet.
        wall = wall.replace("0.0,0,0,-1,0,0", "0.5,0,0,-1,0,0")
        rows = self.places(deck(wall + times(2e-3) + control("RWALL,33", "1", "OFF")))[1]
        self.assertAlmostEqual(self.at(rows, 1e-3), 0.1 + 1e-3, delta=1e-5)
        self.assertAlmostEqual(self.at(rows, 9e-3), 0.5, delta=1e-9)

    def test_a_pressure(self):
        """On a rigid plate of 100 mm2 and 7.85e-7 t: from 3 ms on p = 1e-3 (t - 3e-3), so d = 1e-1 / m (t - 3e-3)^3 / 6, up to 7 ms."""
        body = ("*MAT_RIGID\n1,7.85e-9,210000,0.3\n\n\n*SECTION_SHELL\n1,2\n1,1,1,1\n*PART\nplate\n7,1,1\n*ELEMENT_SHELL\n1,7,11,12,13,14\n*NODE\n"
                "11,0,0,0\n12,10,0,0\n13,10,10,0\n14,0,10,0\n*DATABASE_HISTORY_NODE\n11\n*DEFINE_CURVE\n3\n0,0\n1,1.0\n*LOAD_SEGMENT_ID\n34\n3,1e-3,0,11,14,13,12\n")
        rows = self.places(deck(body + times(3e-3, 7e-3) + control("PRESSURE,34", "1,2", "OFF", 1)))[11]
        mass = 7.85e-7
        self.assertEqual(self.at(rows, 3e-3, 3), 0.0)
        self.assertAlmostEqual(self.at(rows, 6e-3, 3), 0.1 / mass * 3e-3**3 / 6, delta=1e-5)
        self.assertAlmostEqual(self.at(rows, 1e-2, 3), 0.1 / mass * (4e-3**3 / 6 + 4e-3**2 / 2 * 3e-3), delta=4e-5)

    def test_elements_that_are_deleted(self):
        """A mass on a bar swings by v / omega sin(omega t); when the bar is gone it flies with the velocity of that moment."""
        stiffness = YOUNG * 7.0 / 10.0
        omega = math.sqrt(stiffness / 1e-3)
        away = 0.3 * 2 * math.pi / omega
        text = ("*KEYWORD\n*CONTROL_TERMINATION\n" + card(4e-4) + "*MAT_ELASTIC\n" + card(1, 7.85e-12, YOUNG, POISSON) + nodes([(0, 0, 0), (0, 0, 10), (5, 0, 0)])
                + "*SECTION_BEAM\n" + card(2, 3) + card(7.0) + part(2, 2) + "*ELEMENT_BEAM\n" + "".join(f"{n:8}" for n in (2, 2, 1, 2, 3)) + "\n*ELEMENT_MASS\n"
                + f"{1:8}{2:8}{1e-3:16}\n*INITIAL_VELOCITY_NODE\n" + card(2, 0, 0, 100.0) + "*BOUNDARY_SPC_NODE\n" + card(1, 0, 1, 1, 1) + "*SET_BEAM\n" + card(8) + card(2)
                + "*DATABASE_NODOUT\n" + card(1e-5) + "*DATABASE_HISTORY_NODE\n" + card(2) + times(away) + control("ELESET,8", "1", word="BEAM") + "*END\n")
        rows = self.places(text)[2]
        self.assertAlmostEqual(self.at(rows, 5e-5, 3), 100.0 / omega * math.sin(omega * 5e-5), delta=2e-3)
        self.assertAlmostEqual(self.at(rows, 4e-4, 3), 100.0 / omega * math.sin(omega * away) + 100.0 * math.cos(omega * away) * (4e-4 - away), delta=1e-2)
        self.assertRegex(self.read("run/run.log"), r"beam 2 of part 2 is deleted, as \*SENSOR_CONTROL 3 says")
        self.refused(text.replace("ON,1", "OFF,1"), "elements are deleted once and for good, when turned off")
        self.refused(text.replace(",BEAM", ",DISC"), "estyp = DISC: expected SOLID, SHELL or BEAM")

    def test_a_joint_that_opens(self):
        """A body on an arm of 50 mm turns at 1000/s about a body that stands; when the joint lets go it flies off along the tangent."""
        def brick(first, x):
            return "".join(f"{first + i},{x + 10 * a - 5},{10 * b - 5},{10 * c - 5}\n" for i, (a, b, c) in enumerate(CORNERS))
        bodies = ("*MAT_RIGID\n1,7.85e-9,210000,0.3\n1,7,7\n\n*MAT_RIGID\n2,7.85e-9,210000,0.3\n\n\n*SECTION_SOLID\n1,1\n*PART\na\n7,1,1\n*PART\nb\n8,1,2\n*ELEMENT_SOLID\n"
                  "1,7,11,12,13,14,15,16,17,18\n2,8,21,22,23,24,25,26,27,28\n*NODE\n" + brick(11, 0) + brick(21, 50) + "31,0,0,0\n32,0,0,0\n"
                  "*CONSTRAINED_EXTRA_NODES_NODE\n7,31\n8,32\n*CONSTRAINED_JOINT_SPHERICAL_ID\n35\n31,32\n*INITIAL_VELOCITY_RIGID_BODY\n8,0,50000,0,0,0,1000\n")
        fly = 1e-3
        cards = bodies + "*DATABASE_RBDOUT\n1e-4\n" + times(fly) + control("JOINT,35", "1")
        self.nugget("run", self.write(deck(cards, end=3e-3)).name, "-o", "run", "--quiet")
        text = self.read("run/rbdout")
        place = [float(v) for v in text.split("rigid body")[-1].split("coordinates:")[1].split()[:3]] if "coordinates:" in text else None
        self.assertIsNotNone(place, text[:2000])
        angle = 1000.0 * fly
        # Until then it holds the body by m omega^2 r = 392.5 N: a switch sees 340, and never 440.
        seen = "*SENSOR_DEFINE_FORCE\n5,JOINT,35,M\n*SENSOR_SWITCH\n1,SENSOR,5,GT,{},0,2e-4\n*TERMINATION_SENSOR\n1\n"
        # Its springs swing about that until some 1.5e-3.
        release = "*SENSOR_SWITCH\n2,TIME,0,,2.5e-3\n" + control("JOINT,35", "2")
        self.assertIn("switch 1 is on", self.end(deck(bodies + seen.format(340.0) + release, end=3e-3))[1])
        self.assertEqual(self.end(deck(bodies + seen.format(440.0) + release, end=3e-3))[1], "")
        want = (50 * (math.cos(angle) - math.sin(angle) * 1000 * 2e-3), 50 * (math.sin(angle) + math.cos(angle) * 1000 * 2e-3))
        for found, wanted in zip(place, want):
            self.assertAlmostEqual(found, wanted, delta=2.0)

    def plates(self, cards, gap=1.0):
        """A plate that flies at 1e4 mm/s onto one that is held, `gap` over it."""
        def plate(first, z, size, count):
            return [(size * (i / count - 0.5), size * (j / count - 0.5), z) for j in range(count + 1) for i in range(count + 1)]
        below, above = plate(1, 0.0, 20.0, 4), plate(1, gap + 1.0, 10.0, 2)
        text = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(4e-4) + "*MAT_ELASTIC\n" + card(1, 7.85e-9, YOUNG, POISSON) + "*SECTION_SHELL\n" + card(1, 2) + card(1, 1, 1, 1)
        text += part(1) + part(2) + nodes(below + above) + "*ELEMENT_SHELL\n"
        for first, count, identity in ((1, 4, 1), (26, 2, 2)):
            for j in range(count):
                for i in range(count):
                    n = first + i + (count + 1) * j
                    text += "".join(f"{k:8}" for k in (100 * identity + i + count * j, identity, n, n + 1, n + count + 2, n + count + 1)) + "\n"
        text += "*SET_NODE_LIST\n" + card(1) + "".join(card(*range(k, min(k + 8, 26))) for k in range(1, 26, 8)) + "*BOUNDARY_SPC_SET\n" + card(1, 0, 1, 1, 1, 1, 1, 1)
        text += "*INITIAL_VELOCITY_GENERATION\n" + card(2, 2, 0, 0, 0, -10000.0) + card("")
        text += "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ID\n" + f"{36:10}plates\n" + card(2, 1, 3, 3) + card("") + card("")
        return text + "*DATABASE_NODOUT\n" + card(2e-5) + "*DATABASE_HISTORY_NODE\n" + card(30) + cards + "*END\n"

    def test_a_contact_that_is_turned_on_and_off(self):
        always = self.places(self.plates(""))[30]
        self.assertGreater(self.at(always, 4e-4, 3), -1.5, "it bounces")
        early = self.places(self.plates(times(5e-5) + control("CONTACT,36", "1", "OFF")))[30]  # touches at 1e-4 s
        self.assertEqual(early, always)
        never = self.places(self.plates(times(1.0) + control("CONTACT,36", "1", "OFF")))[30]
        gone = self.places(self.plates(times(5e-5) + control("CONTACT,36", "1")))[30]
        for rows in (never, gone):
            self.assertAlmostEqual(self.at(rows, 4e-4, 3), -4.0, delta=1e-6)

    def test_what_is_refused(self):
        drive = "*BOUNDARY_PRESCRIBED_MOTION_NODE_ID\n32,driven\n1,1,2,1\n"
        for cards, message in (
                (times(1e-3) + control("AIRBAG,1", "1"), "type = AIRBAG: this is not turned on and off"),
                (times(1e-3) + control("CURVE,1", "1"), "control the motion (PRESC-MOT) or the pressure (PRESSURE) that has the curve"),
                (drive + times(1e-3) + control("PRESC-MOT,32", "1", "OFF"), "would begin in the middle of its curve, with a jump"),
                (drive + times(1e-3) + control("PRESC-MOT,33", "1"), "typeid = 33: no *BOUNDARY_PRESCRIBED_MOTION_..._ID has this id"),
                (drive + times(1e-3) + control("PRESC-MOT,32", "2"), "swit1 = 2: no sensor switch has this id"),
                (drive + times(1e-3) + control("PRESC-MOT,32", "1", "MAYBE"), "initstt = MAYBE: expected ON or OFF"),
                (drive + times(1e-3) + control("PRESC-MOT,32", "1", repeat=2), "nrep = 2: editions of the manual differ"),
                (drive + times(1e-3) + control("PRESC-MOT,32", "1").replace("0,0,\n", "0,0,,1\n"), "sidr = 1: switches in dynamic relaxation are not built"),
                (switch("*SENSOR_DEFINE_FORCE\n5,AIRBAG,1,X", 1.0) + "\n" + drive + control("PRESC-MOT,32", "1"), "ftype = AIRBAG: forces of RWALL, SPC, PRESC-MOT, JOINT"),
                (switch("*SENSOR_DEFINE_FORCE\n5,SPC,31,X", 1.0) + "\n" + drive + control("PRESC-MOT,32", "1"), "typeid = 31: no SPC has this id, of *BOUNDARY_SPC_..._ID"),
                (drive + "*BOUNDARY_SPC_NODE_ID\n31,held\n1,0,1\n" + times(1e-3) + control("SPC,31", "1"), "which one counts is not documented")):
            with self.subTest(message):
                self.refused(deck(cards), message)


class SameBits(Sensors):
    TUBE = switched_tube()

    def test_threads_and_lanes(self):
        self.compare(self.write(self.TUBE))
        log = self.read("t1/run.log")
        for what in ("turns PRESSURE 43 on", "turns PRESC-MOT 42 off", "turns ELESET 4 off"):
            self.assertIn(what, log)

    def test_restart(self):
        self.resumed(self.TUBE)


if __name__ == "__main__":
    unittest.main()
