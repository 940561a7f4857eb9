# SPDX-License-Identifier: Apache-2.0
"""*TERMINATION_NODE, _BODY and _SENSOR end a run when a number leaves its bounds: at the time that uniform motion gives by hand."""
import unittest

from repeated_runs import RepeatedRuns

SPEED = (300.0, -200.0, 600.0)  # 700 mm/s in all
STEP = 1e-5  # a thousandth of the time, where nothing asks for less


def deck(cards):
    """A node with a mass that flies from (1, 2, 3), one that stands at (1, 2, 4), and a rigid brick that flies too; no force acts."""
    corners = [(x, y, z) for z in (10, 20) for x, y in ((0, 0), (10, 0), (10, 10), (0, 10))]
    speed = ",".join(map(str, SPEED))
    return "\n".join([
        "*KEYWORD", "*CONTROL_TERMINATION\n1e-2", "*MAT_RIGID\n1,7.85e-9,210000,0.3\n\n",
        "*SECTION_SOLID\n1,1\n*PART\nbrick\n7,1,1", "*ELEMENT_SOLID\n1,7,11,12,13,14,15,16,17,18", "*ELEMENT_MASS\n2,1,1e-6\n3,2,1e-6",
        f"*INITIAL_VELOCITY_NODE\n1,{speed}", f"*INITIAL_VELOCITY_RIGID_BODY\n7,{speed}", "*DEFINE_VECTOR\n1,0,0,0,0,0,-2",
        "*DEFINE_CURVE\n1\n0,0\n1e-2,100", cards, "*NODE\n1,1,2,3\n2,1,2,4", *(f"{11 + i},{x},{y},{z}" for i, (x, y, z) in enumerate(corners)), "*END", ""])


class RunEnds(RepeatedRuns):
    def end(self, cards):
        """The time at which a run ends, and why."""
        self.nugget("run", self.write(deck(cards)).name, "-o", "run", "--quiet")
        summary = self.json("run/summary.json")
        self.assertEqual(summary["termination"], "normal")
        return summary["time"], summary["message"]

    def expect(self, cards, time, message):
        found, why = self.end(cards)
        self.assertGreaterEqual(found, time - 1e-12)
        self.assertLessEqual(found, time + 1.01 * STEP)  # the first cycle beyond
        self.assertRegex(why, message)

    def test_nodes(self):
        self.expect("*TERMINATION_NODE\n1,1,1.9", 0.9 / 300.0, "node 1 has the x coordinate 1.9[0-9]*, beyond 1.9")
        self.expect("*TERMINATION_NODE\n1,2,1.9,1.5", 0.0, "node 1 has the y coordinate 2, beyond 1.9")
        self.expect("*TERMINATION_NODE\n1,2,0,1.5", 0.5 / 200.0, "beyond 1.5")  # 0 is no bound
        self.expect("*TERMINATION_NODE\n1,2,5.0,1.5", 0.5 / 200.0, "node 1 has the y coordinate 1.[0-9]*, beyond 1.5")
        self.expect("*TERMINATION_NODE\n2,1,1.9\n1,3,6.0", 3.0 / 600.0, "node 1 has the z coordinate")

    def test_bodies(self):
        self.expect("*TERMINATION_BODY\n7,3,3.0", 3.0 / 600.0, "rigid body 7 has the z displacement 3[.0-9]*, beyond 3")
        self.expect("*TERMINATION_BODY\n7,4,2.1", 2.1 / 700.0, "rigid body 7 has the whole displacement 2.1[0-9]*, beyond 2.1")
        self.expect("*TERMINATION_BODY\n7,2,1.0,-1.0", 1.0 / 200.0, "rigid body 7 has the y displacement -1.[0-9]*, beyond -1")

    def switch(self, sensor, switch, more="*TERMINATION_SENSOR\n1"):
        return f"{sensor}\n*SENSOR_SWITCH\n1,{switch}\n{more}"

    def test_sensors(self):
        node = "*SENSOR_DEFINE_NODE\n5,1,{},{},0,{}"
        for sensor, switch, time in (
                (node.format(0, 1, "COORD"), "SENSOR,5,LT,-6.0", 3.0 / 600.0),  # along -z: falls from -3
                (node.format(2, 0, "COORD"), "SENSOR,5,GT,2.5", 0.0),
                ("*SENSOR_DEFINE_MISC\n5,TIME", "SENSOR,5,GT,4e-3", 4e-3),
                ("*SENSOR_DEFINE_MISC\n5,CURVE,1", "SENSOR,5,GT,30.0", 3e-3),
                ("", "TIME,0,,2e-3", 2e-3),
                (node.format(0, 0, "VEL"), "SENSOR,5,GT,699.0,0,3e-3", 3e-3)):  # from the start on, for TIMWIN
            with self.subTest(sensor + switch):
                if "2.5" in switch:  # seen from the other node: |(300, -200, 600) t - (0, 0, 1)| is 2.5 at 4.3.. ms
                    a, b, c = 490000.0, -1200.0, 1.0 - 2.5**2
                    time = (-b + (b * b - 4 * a * c) ** 0.5) / (2 * a)
                self.expect(self.switch(sensor, switch), time, "sensor switch 1 is on")

    def test_calculations(self):
        """Of x, y, z of the flying node, 1 + 300 t, 2 - 200 t, 3 + 600 t, as far as each calculation says."""
        sensors = "".join(f"*DEFINE_VECTOR\n{10 + i},0,0,0,{int(i == 0)},{int(i == 1)},{int(i == 2)}\n*SENSOR_DEFINE_NODE\n{i + 1},1,0,{10 + i},0,COORD\n"
                          for i in range(3))
        for calc, terms, bound, logic, time in (
                ("SUM", "1,2,3", 6.0 + 700 * 4e-3, "GT", 4e-3), ("SUM", "1,-2", 0.5, "GT", 1.5 / 500.0),
                ("ABSSUM", "1,2", 3.2, "GT", 2e-3), ("MIN", "1,2", 1.2, "GT", 0.2 / 300.0), ("MAX", "1,2,3", 6.0, "GT", 3.0 / 600.0),
                ("MAXMAG", "1,2", 2.2, "GT", 4e-3), ("MINMAG", "1,2", 1.3, "GT", 0.3 / 300.0),
                ("MULTIPLY", "1,2", (1 + 300 * 5e-3) * (2 - 200 * 5e-3), "GT", None), ("MULTIPLY", "3,-1", 2.9, "LT", 0.1 / 270.0),
                ("SQRE", "3", 25.0, "GT", 2.0 / 600.0), ("SQRTSQRE", "1,2,3", 7.0, "GT", None), ("SQRT", "3", 2.2, "GT", (2.2**2 - 3.0) / 600.0)):
            with self.subTest(calc + terms):
                def value(t, calc=calc):
                    x, y, z = 1 + 300 * t, 2 - 200 * t, 3 + 600 * t
                    return x * y if calc == "MULTIPLY" else (x * x + y * y + z * z) ** 0.5
                if time is None:  # by halves
                    low, high = 0.0, 1e-2 if calc == "SQRTSQRE" else 5e-3
                    if value(0.0) > bound:
                        time = 0.0
                    else:
                        for _ in range(60):
                            mean = (low + high) / 2
                            low, high = (low, mean) if value(mean) > bound else (mean, high)
                        time = high
                if calc == "MULTIPLY" and terms == "3,-1":  # z / x falls from 3: (3 + 600 t) / (1 + 300 t) = 2.9
                    time = 0.1 / (2.9 * 300 - 600)
                if calc == "ABSSUM":  # |x| + |y| = 3 + 100 t
                    time = 0.2 / 100.0
                self.expect(f"{sensors}*SENSOR_DEFINE_CALC-MATH\n9,{calc},{terms}\n" + self.switch("", f"SENSOR,9,{logic},{bound}"), time, "switch 1")

    def test_logic(self):
        times = "".join(f"*SENSOR_SWITCH\n{i},TIME,0,,{t}\n" for i, t in ((1, 1e-3), (2, 3e-3), (3, 5e-3)))
        for terms, time in (("1,2", 3e-3), ("3,-2", 3e-3), ("1,-2,3", 5e-3), ("2,3,-1", 1e-3)):
            with self.subTest(terms):
                self.expect(f"{times}*SENSOR_SWITCH_CALC-LOGIC\n8,{terms}\n*TERMINATION_SENSOR\n8", time, "sensor switch 8 is on")

    def test_a_switch_that_never_is_on(self):
        found, message = self.end(self.switch("*SENSOR_DEFINE_NODE\n5,1,0,0,0,VEL", "SENSOR,5,GT,701.0"))
        self.assertAlmostEqual(found, 1e-2)
        self.assertEqual(message, "")

    def test_restart_within_the_time_that_a_condition_must_hold(self):
        self.resumed(deck(self.switch("*SENSOR_DEFINE_NODE\n5,1,0,0,0,VEL", "SENSOR,5,GT,699.0,0,3e-3")
                          + "\n*DATABASE_GLSTAT\n1e-3\n*DATABASE_BINARY_D3PLOT\n1e-3"), shares=(0.4, 0.8))

    def test_what_is_refused(self):
        node = "*SENSOR_DEFINE_NODE\n5,1,{},{},0,{}"
        for cards, text in (
                (self.switch(node.format(0, 0, "TEMP"), "SENSOR,5,GT,1.0"), "ctype = TEMP: of nodes COORD, VEL and ACC are measured"),
                (self.switch(node.format(2, 1, "VEL"), "SENSOR,5,GT,1.0"), "vid = 1: along a vector only one node is measured"),
                (self.switch("*SENSOR_DEFINE_MISC\n5,MATSUM,INTERNAL,7", "SENSOR,5,GT,1.0"), "mtype = MATSUM: TIME, CURVE, RIGIDBODY, BNDOUT, JNTSTG, RETRACTOR and SLIPRING are measured"),
                (self.switch("*SENSOR_DEFINE_ELEMENT_SET\n5,SOLID,1,XX,STRESS", "SENSOR,5,GT,1.0"), "sensid = 5: no sensor that is built has this id"),
                (self.switch("*SENSOR_DEFINE_MISC\n5,TIME", "SENSOR,5,GT,1.0,3"), "filtrid = 3: filtered sensors are not built"),
                (self.switch("*SENSOR_DEFINE_CALC-MATH\n5,SUM,5", "SENSOR,5,GT,1.0"), "sensor 5 depends on itself"),
                (self.switch("*SENSOR_DEFINE_MISC\n6,TIME\n*SENSOR_DEFINE_CALC-MATH\n5,MAX,-6", "SENSOR,5,GT,1.0"), "a sign has a meaning in SUM and MULTIPLY only"),
                ("*SENSOR_SWITCH_CALC-LOGIC\n1,2\n*SENSOR_SWITCH_CALC-LOGIC\n2,1\n*TERMINATION_SENSOR\n1", "depends on itself"),
                ("*TERMINATION_SENSOR\n4", "swid1 = 4: no sensor switch has this id"),
                ("*TERMINATION_NODE\n1,4,1.0", "stop = 4: an end by contact is not built"),
                ("*TERMINATION_CONTACT\n1", "ends by contact, curve or deleted elements are not built")):
            with self.subTest(text):
                self.assertIn(text, self.nugget("check", self.write(deck(cards)).name, expect=1).stderr)
        # What nothing asks for is passed over.
        self.nugget("check", self.write(deck(node.format(0, 0, "TEMP") + "\n*SENSOR_DEFINE_ELEMENT\n6,TSHELL,1,XX,STRESS\n*SENSOR_DEFINE_MISC\n7,RIGIDBODY,7")).name)


if __name__ == "__main__":
    unittest.main()
