# SPDX-License-Identifier: Apache-2.0
"""Discrete beams (ELFORM 6) driven along given ways: their forces in elout against the law's own, worked out here.

Sabotage that this catches: MAT_074 and 121 along the r axis of the triad instead of the line of their nodes, a spring that stands still
taken for one that loads, IUR without the force of loading up to there.
"""
import math
import unittest

import lsda
from nugget_command import CommandTest


def card(*values):
    return "".join(f"{v:10g}" if isinstance(v, float) else f"{v:10}" for v in values) + "\n"


def curve(number, *points):
    return "*DEFINE_CURVE\n" + card(number) + "".join(f"{x:20.8g}{y:20.8g}\n" for x, y in points)


class DiscreteBeams(CommandTest):
    def force(self, material, second, ways, end, scoor=0.0, by_velocity=False, cable=()):
        """[(time, axial force)] of a beam from the origin to `second`, whose second node goes the `ways` in x, y, z."""
        deck = ("*KEYWORD\n*CONTROL_TERMINATION\n" + card(end) + material + "*SECTION_BEAM\n" + card(1, 6, 1.0, 2, 0, scoor) +
                card(1e-3, 1e-3, 0, *cable) + "*PART\nbeam\n" + card(1, 1, 1) + "*NODE\n")
        for node, (x, y, z) in enumerate(((0, 0, 0), second), start=1):
            deck += f"{node:8}{x:16}{y:16}{z:16}\n"
        deck += "*ELEMENT_BEAM\n" + "".join(f"{v:8}" for v in (1, 1, 1, 2)) + "\n*BOUNDARY_SPC_NODE\n" + card(1, 0, 1, 1, 1, 1, 1, 1)
        for freedom, way in enumerate(ways, start=1):
            deck += curve(90 + freedom, *way) + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + card(2, freedom, 0 if by_velocity else 2, 90 + freedom)
        deck += curve(80, (0, 1e-3), (9, 1e-3)) + "*CONTROL_TIMESTEP\n" + card(0, 0.9, 0, 0, 0, 80)
        deck += "*DATABASE_HISTORY_BEAM\n" + card(1) + "*DATABASE_ELOUT\n" + card(end / 100, 2) + "*END\n"
        self.nugget("run", self.write(deck))
        found = lsda.read(self.folder / "binout0000")
        states = sorted({key.rsplit("/", 1)[0] for key in found if key.startswith("elout/beam/d") and key.endswith("/axial")})
        return [(found[f"{state}/time"][0], found[f"{state}/axial"][0]) for state in states]

    def test_springs_act_between_their_nodes(self):
        # From (3, 4, 0) to (-6, 8, 1), each direction in its own way.
        ways = [((0, 0), (0.6, -5), (1, -9)), ((0, 0), (0.4, -1), (1, 4)), ((0, 0), (0.5, 2), (1, 1))]

        def place(way, time):
            for (t0, u0), (t1, u1) in zip(way, way[1:]):
                if time <= t1 or t1 == 1:
                    return u0 + (u1 - u0) * (time - t0) / (t1 - t0)

        laws = ("*MAT_074\n" + card(1, 1.0, 100.0) + "\n", "*MAT_121\n" + card(1, 1.0) + card(7) + "\n" + curve(7, (0, 0), (1, 100)))
        for law in laws:
            for scoor in (0.0, -1.0):
                path = self.force(law, (3, 4, 0), ways, 1.0, scoor)
                self.assertGreater(len(path), 90)
                for time, force in path:
                    length = math.hypot(*(x + place(way, time) for x, way in zip((3, 4, 0), ways)))
                    # elout has the force and time of one state; the way's corners are met within a step of 1e-3.
                    self.assertAlmostEqual(force, 100 * (length - 5), delta=2.5, msg=f"{law} {scoor} {time}")

    def test_cables_pull_and_never_push(self):
        """max(F0 + K (L - L0), 0), L0 the length at the start less OFFSET, K = E CA / L0, or -E, or CA times the curve of strain; the cable
        breaks at its strain or force. Sabotage: the length at the start for L0; a spring for the cable."""
        still, there_and_back = ((0, 0), (9, 0)), ((0, 0), (0.4, 0.5), (1, -0.5))
        place = lambda time: 0.5 * time / 0.4 if time < 0.4 else 0.5 - (time - 0.4) / 0.6  # noqa: E731
        cases = [("210.0", "", 0.0, 0.0, 2.0), ("210.0", "", 3.0, 0.0, 2.0), ("210.0", "", 0.0, 0.2, 2.0), ("210.0", "", 0.0, -0.1, 2.0),
                 ("-50.0", "", 1.0, 0.1, 0.0), ("", "7", 2.0, 0.3, 2.0)]
        for modulus, curve_id, preload, offset, area in cases:
            with self.subTest(E=modulus, LCID=curve_id, F0=preload, OFFSET=offset):
                law = f"*MAT_CABLE_DISCRETE_BEAM\n{1:10}{1.0:10}{modulus:>10}{curve_id:>10}{preload:10}\n"
                law += curve(7, (-1, -30), (0, 0), (0.05, 20), (1, 60)) if curve_id else ""
                unstretched = 5.0 - offset
                path = self.force(law, (3, 0, 4), [(*[(t, 0.6 * u) for t, u in there_and_back],), still, (*[(t, 0.8 * u) for t, u in there_and_back],)],
                                  1.0, cable=(area, offset))
                self.assertGreater(len(path), 90)
                for time, force in path:
                    strain = (place(time) + offset) / unstretched
                    pull = (preload + area * (400 * strain if 0 <= strain <= 0.05 else 20 + (strain - 0.05) * 40 / 0.95 if strain > 0 else 30 * strain)
                            if curve_id else preload + (50.0 if modulus == "-50.0" else 210.0 * area / unstretched) * strain * unstretched)
                    self.assertAlmostEqual(force, max(pull, 0.0), delta=0.5, msg=time)
        steady = [((0, 0), (1, 1)), still, still]
        for limit, at_length in ((card(0, "", "", 0.1), 5.5), (card(0, "", "", "", 63.0), 5.75)):
            law = "*MAT_071\n" + card(1, 1.0, 210.0, "", "", "", "", 1) + limit
            path = self.force(law, (5, 0, 0), steady, 1.0, cable=(2.0, 0.0))
            last = max(time for time, force in path if force > 0.0)
            self.assertAlmostEqual(5.0 + last, at_length, delta=0.02)

    def test_a_net_of_cables_that_catches_a_mass(self):
        """Stretched by OFFSET and F0, driven far out of its plane: energy is kept to 1e-4. Sabotage: cables taken for welds that
        nothing holds; forces along the lines of the start."""
        cells, middle = 4, 13
        deck = ("*KEYWORD\n*CONTROL_TERMINATION\n" + card(0.02) + "*DATABASE_GLSTAT\n" + card(1e-3) + "*DATABASE_NODOUT\n" + card(1e-3)
                + "*DATABASE_HISTORY_NODE\n" + card(middle) + "*MAT_071\n" + card(1, 7.85e-9, 1e5, 0, 20.0) + "*SECTION_BEAM\n" + card(1, 6)
                + card(200.0, 1.0, 0, 2.0, 0.05) + "*PART\ncables\n" + card(1, 1, 1) + "*NODE\n")
        number = lambda i, j: 1 + i + (cells + 1) * j  # noqa: E731
        nodes = [(i, j) for j in range(cells + 1) for i in range(cells + 1)]
        deck += "".join(f"{number(i, j):8}{100 * i:16}{100 * j:16}{0:16}\n" for i, j in nodes) + "*ELEMENT_BEAM\n"
        pairs = [(number(i, j), number(i + 1, j)) for i, j in nodes if i < cells] + [(number(i, j), number(i, j + 1)) for i, j in nodes if j < cells]
        deck += "".join(f"{e:8}{1:8}{a:8}{b:8}\n" for e, (a, b) in enumerate(pairs, 1)) + "*BOUNDARY_SPC_NODE\n"
        deck += "".join(card(number(i, j), 0, 1, 1, 1, 1, 1, 1) for i, j in nodes if i in (0, cells) or j in (0, cells))
        deck += f"*ELEMENT_MASS\n{1:8}{middle:8}{1e-4:16}\n*INITIAL_VELOCITY_NODE\n" + card(middle, 0, 0, -5000.0) + "*END\n"
        run = self.nugget("run", self.write(deck), "--quiet")
        self.assertNotIn("weld", run.stderr)
        energy = self.json("summary.json")["energy"]
        self.assertAlmostEqual(energy["ratio"], 1.0, delta=1e-4)
        self.assertAlmostEqual(energy["ratio_without_step_change"], 1.0, delta=1e-3)
        lowest = min(float(line.split()[3]) for line in self.read("nodout").splitlines() if line.split()[:1] == [str(middle)] and len(line.split()) > 6)
        self.assertLess(lowest, -10.0)

    def test_a_cable_needs_its_area_and_length(self):
        still = ((0, 0), (9, 0))
        law = "*MAT_071\n" + card(1, 1.0, 210.0)
        for cable, second, told in (((), (5, 0, 0), "the stiffness of a cable is that of its area (CA)"),
                                    ((2.0, 5.0), (5, 0, 0), "is a cable of length 5, of which OFFSET 5 leaves no unstretched length")):
            with self.subTest(told), self.assertRaises(AssertionError) as refused:
                self.force(law, second, [still, still, still], 1.0, cable=cable)
            self.assertIn(told, str(refused.exception))

    def test_what_stands_still_stays_on_the_curve_of_unloading(self):
        law = ("*MAT_119\n" + card(1, 1.0, 0, 0, 1) + card(7) + card(8) + "\n\n\n\n\n" + curve(7, (0, 0), (1, 100)) + curve(8, (0, 0), (1, 20)))
        still = ((0, 0), (9, 0))
        way = ((0, 1), (1, 1), (1.0001, -1), (1.5, -1), (1.5001, 0), (9, 0))
        path = self.force(law, (0, 0, 0), [way, still, still], 2.0, by_velocity=True)
        held = [force for time, force in path if time > 1.55]
        self.assertGreater(len(held), 20)
        for force in held:
            self.assertAlmostEqual(force, 20 * 0.5, delta=0.1)

    def test_displaced_at_the_start_it_has_been_loaded(self):
        law = ("*MAT_119\n" + card(1, 1.0, 200.0, 0, 2) + card(7) + card(8) + "\n\n\n\n" + card(0.5) + curve(7, (0, 0), (1, 100)) +
               curve(8, (0, 0), (1, 20)))
        still = ((0, 0), (9, 0))
        path = self.force(law, (0, 0, 0), [((0, -1), (9, -1)), still, still], 0.4, by_velocity=True)
        self.assertGreater(len(path), 90)
        for time, force in path:
            displacement = 0.5 - time
            self.assertAlmostEqual(force, max(20 * displacement, 50 - 200 * time), delta=0.5, msg=time)

    def test_disbout_has_motions_forces_and_axes(self):
        """A linear beam of no length in axes turned by 30 degrees about z: node 2 goes (3, 1, 2) and turns by 0.02 about x."""
        stiffness = (100.0, 50.0, 20.0, 4.0e3, 5.0e3, 6.0e3)
        deck = ("*KEYWORD\n*CONTROL_TERMINATION\n" + card(1.0) + "*MAT_066\n" + card(1, 1.0, *stiffness) + card(0.0) + card(0.0) +
                "*SECTION_BEAM\n" + card(1, 6, 1.0, 2, 0, -1.0) + card(1e-3, 1e-3, 5) + "*PART\nbeam\n" + card(7, 1, 1) +
                f"*NODE\n{1:8}{0:16}{0:16}{0:16}\n{2:8}{0:16}{0:16}{0:16}\n*ELEMENT_BEAM\n" + "".join(f"{v:8}" for v in (31, 7, 1, 2)) +
                "\n*BOUNDARY_SPC_NODE\n" + card(1, 0, 1, 1, 1, 1, 1, 1) + "*DEFINE_COORDINATE_VECTOR\n" + card(5, 3.0**0.5, 1.0, 0.0, -1.0, 3.0**0.5, 0.0))
        way = (3.0, 1.0, 2.0, 0.02)
        for freedom, u in zip((1, 2, 3, 5), way):
            deck += curve(90 + freedom, (0.0, 0.0), (0.5, u), (9.0, u)) + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + card(2, freedom, 2, 90 + freedom)
        deck += "*BOUNDARY_SPC_NODE\n" + card(2, 0, 0, 0, 0, 0, 1, 1) + curve(80, (0, 1e-3), (9, 1e-3)) + "*CONTROL_TIMESTEP\n" + card(0, 0.9, 0, 0, 0, 80)
        self.nugget("run", self.write(deck + "*DATABASE_HISTORY_BEAM\n" + card(31) + "*DATABASE_DISBOUT\n" + card(0.1, 3) + "*END\n"))
        cosine, sine = math.cos(math.radians(30)), 0.5
        motion = (way[0] * cosine + way[1] * sine, way[1] * cosine - way[0] * sine, way[2], way[3] * cosine, -way[3] * sine, 0.0)
        found = lsda.read(self.folder / "binout0000")
        last = max(key.rsplit("/", 1)[0] for key in found if key.startswith("disbout/d"))
        names = ("r_dis_axial", "r_dis_ns", "r_dis_nt", "axial_rot", "rot_s", "rot_t"), ("rslt_axial", "rslt_ns", "rslt_nt", "torsion", "moment_s", "moment_t")
        for k, u in enumerate(motion):
            self.assertAlmostEqual(found[f"{last}/{names[0][k]}"][0], u, delta=0.002 * max(motion[3 * (k // 3):3 * (k // 3) + 3]))
            self.assertAlmostEqual(found[f"{last}/{names[1][k]}"][0], stiffness[k] * u, delta=0.002 * stiffness[k] * abs(motion[3 * (k // 3)]))
        for axis, expected in (("axial", (cosine, sine, 0.0)), ("s_dir", (-sine, cosine, 0.0)), ("t_dir", (0.0, 0.0, 1.0))):
            for direction, value in zip("xyz", expected):
                self.assertAlmostEqual(found[f"{last}/{axis}_{direction}"][0], value, delta=1e-6)
        self.assertEqual([found[f"{last}/{name}"][0] for name in ("nelb", "matid", "mtype")], [31, 7, 66])
        text = self.read("disbout").split("d i s c r e t e  b e a m")[-1]
        self.assertIn(" beam/truss # =      31      part ID  =         7      material type=      66\n", text)
        rows = [[float(v) for v in line.split()] for line in text.splitlines() if line.startswith("           ")]
        self.assertEqual([len(row) for row in rows], [6, 6, 3, 3, 3])
        for row, expected in zip(rows, (motion, [k * u for k, u in zip(stiffness, motion)])):
            for value, right in zip(row, expected):
                self.assertAlmostEqual(value, right, delta=0.003 * max(abs(e) for e in expected))


if __name__ == "__main__":
    unittest.main()
