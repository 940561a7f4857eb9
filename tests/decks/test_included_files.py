# SPDX-License-Identifier: Apache-2.0
"""What *INCLUDE_TRANSFORM does to a file: ids of every kind move with their definitions, what has a direction turns with
the nodes, values change their units, and what stays behind is named."""
import math
import re
import unittest

import lsda
from few_elements import card, curve
from nugget_command import CommandTest

TURN = 30.0
TURNED = f"*DEFINE_TRANSFORMATION\n         1\nTRANSL,100.,-50.,20.\nROTATE,1.,2.,3.,0.,0.,0.,{TURN}\n"
OFFSETS = card(1000, 2000, 3000, 4000, 5000, 6000, 7000) + card(8000)

# Two rigid bars that spin, each with a tensor of inertia of three different moments.
BAR = """*MAT_RIGID
1,7.85e-9,210000.,0.3


*SECTION_SHELL
1,2,1.0,3
1.0
*NODE
1,0,0,0
2,10,0,0
3,10,10,0
4,0,10,0
*ELEMENT_SHELL
1,1,1,2,3,4
"""
GLOBAL = "*PART_INERTIA\nbar\n1,1,1\n5.,5.,0.,2e-3\n1.0,0.2,0.1,3.0,-0.3,5.0\n0,0,0,10.,20.,40.\n"
LOCAL = GLOBAL.replace("2e-3\n", "2e-3,1\n") + "1.,1.,0.,0.,0.,1.\n"
NODAL = """*NODE
11,0,0,0
12,10,0,0
13,0,10,0
*SET_NODE_LIST
1
11,12,13
*CONSTRAINED_NODAL_RIGID_BODY_INERTIA
1,0,1
5.,5.,0.,2e-3
1.0,0.2,0.1,3.0,-0.3,5.0
0,0,0,10.,20.,40.
"""
NODAL_LOCAL = NODAL.replace("2e-3\n", "2e-3,1\n") + "1.,1.,0.,0.,0.,1.\n"
POINT = """*NODE
11,0,0,0
12,10,0,0
13,0,10,0
*SET_NODE_LIST
1
11,12,13
*CONSTRAINED_NODAL_RIGID_BODY
1,0,1
*ELEMENT_INERTIA
1,11
1.0,0.2,0.1,3.0,-0.3,5.0,1e-3
*ELEMENT_MASS
2,12,1e-3
3,13,1e-3
*INITIAL_VELOCITY_RIGID_BODY
1,0,0,0,10.,20.,40.
"""


class IncludedFiles(CommandTest):
    def deck(self, file, offsets="\n\n", units="\n", transformation=0, more="", end="1e-6"):
        self.write(f"*KEYWORD\n{file}*END\n", "inner.k")
        self.write(f"*KEYWORD\n*CONTROL_TERMINATION\n{end}\n*DATABASE_GLSTAT\n{end}\n*CONTROL_ENERGY\n2,2,2,2\n{more}"
                   f"*INCLUDE_TRANSFORM\ninner.k\n{offsets}{units}{card(transformation)}{TURNED}*END\n")

    def check(self):
        self.nugget("check", "model.k")
        return [(f["severity"], f["keyword"], f["field"], f["text"]) for f in self.json("findings.json")]

    def kinetic(self):
        self.nugget("run", "model.k", "--quiet")
        return self.glstat()[0]["kinetic energy"]

    # ---- directions

    def test_tensors_of_inertia_turn_with_the_file(self):
        tensor = [[1.0, 0.2, 0.1], [0.2, 3.0, -0.3], [0.1, -0.3, 5.0]]
        spin = [10.0, 20.0, 40.0]
        def energy(w):
            return 0.5 * sum(w[i] * tensor[i][j] * w[j] for i in range(3) for j in range(3))
        h = math.sqrt(0.5)
        along = [h * (spin[0] + spin[1]), spin[2], h * (spin[0] - spin[1])]  # in x' = (1 1 0), y' = z, z' = (1 -1 0)
        for name, file, expected in (("part", BAR + GLOBAL, energy(spin)), ("part, local", BAR + LOCAL, energy(along)),
                                     ("nodal", NODAL, energy(spin)), ("nodal, local", NODAL_LOCAL, energy(along))):
            for transformation in (0, 1):
                with self.subTest(name, transformation=transformation):
                    self.deck(file, transformation=transformation)
                    self.assertAlmostEqual(self.kinetic() / expected, 1.0, 4)

    def test_point_inertia_turns_with_the_file(self):
        energies = []
        for transformation in (0, 1):
            self.deck(POINT, transformation=transformation)
            energies.append(self.kinetic())
        # about the centre of the three masses of 1e-3 at (0 0), (10 0), (0 10), and the tensor
        masses = 0.5 * 1e-3 * sum((20 * 0 - 40 * (y - 10 / 3)) ** 2 + (40 * (x - 10 / 3)) ** 2 +
                                  (10 * (y - 10 / 3) - 20 * (x - 10 / 3)) ** 2 for x, y in ((0, 0), (10, 0), (0, 10)))
        tensor = 0.5 * (100 * 1 + 400 * 3 + 1600 * 5 + 2 * (200 * 0.2 + 400 * 0.1 - 800 * 0.3))
        for energy in energies:
            self.assertAlmostEqual(energy / (masses + tensor), 1.0, 4)

    def test_axes_of_materials_turn_with_the_file(self):
        nodes = "".join(f"{10 * j + i + 1},{10.0 * i},{10.0 * j},0\n" for j in range(5) for i in range(7))
        shells = "".join(f"{10 * j + i + 1},1,{10 * j + i + 1},{10 * j + i + 2},{10 * j + i + 12},{10 * j + i + 11}\n"
                         for j in range(4) for i in range(6))
        held = "".join(f"{10 * j + 1},0,1,1,1,1,1,1\n" for j in range(5))
        plate = ("*PART\nplate\n1,1,1\n*SECTION_SHELL\n1,16,0.8333,3\n1.0\n*MAT_ORTHOTROPIC_ELASTIC\n"
                 "1,1.5e-9,150000.,9000.,9000.,0.02,0.02,0.3\n5000.,3000.,5000.,{aopt}\n0,0,0,1.,0.4,0.\n{v},0.,1.,0.\n"
                 f"*NODE\n{nodes}*ELEMENT_SHELL\n{shells}*BOUNDARY_SPC_NODE\n{held}")
        for aopt, v in ((2, "0,0,0"), (3, "1.,0.4,0.")):
            first = []
            for transformation in (0, 1):
                self.deck(plate.format(aopt=aopt, v=v), transformation=transformation)
                self.nugget("modes", "model.k", "-n", "3")
                table = re.findall(r"^\s+\d+\s+\S+\s+\S+\s+(\S+)\s+\S+", self.read("eigout"), re.M)
                first.append([float(f) for f in table[:3]])
            self.assertTrue(first[0], "no frequencies in eigout")
            for a, b in zip(*first):
                self.assertAlmostEqual(a / b, 1.0, 5)

    def test_local_axes_of_rigid_parts_turn_with_the_file(self):
        file = BAR.replace("1,7.85e-9,210000.,0.3\n\n\n", "1,7.85e-9,210000.,0.3\n\n1.,1.,0.,0.,0.,1.\n") + (
            "*PART\nbar\n1,1,1\n" + "*DATABASE_HISTORY_NODE\n1\n"
            "*BOUNDARY_PRESCRIBED_MOTION_RIGID_LOCAL\n1,1,0,9,100.\n")
        more = curve(9, (0.0, 1.0), (1.0, 1.0)) + "*DATABASE_NODOUT\n1e-6\n"
        self.deck(file, transformation=1, more=more)
        self.nugget("run", "model.k", "--quiet")
        velocity = None
        for line in self.read("nodout").splitlines():
            fields = line.split()
            if len(fields) == 13 and fields[0] == "1":
                velocity = [float(x) for x in fields[4:7]]
        axis, n = [1 / math.sqrt(14.0) * x for x in (1.0, 2.0, 3.0)], [math.sqrt(0.5), math.sqrt(0.5), 0.0]
        c, s = math.cos(math.radians(TURN)), math.sin(math.radians(TURN))
        dot = sum(a * b for a, b in zip(axis, n))
        cross = [axis[1] * n[2] - axis[2] * n[1], axis[2] * n[0] - axis[0] * n[2], axis[0] * n[1] - axis[1] * n[0]]
        for i in range(3):
            self.assertAlmostEqual(velocity[i], 100.0 * (c * n[i] + s * cross[i] + (1 - c) * dot * axis[i]), 3)

    def test_axes_of_cross_sections_move_by_their_kind(self):
        nodes = "".join(f"{10 * j + i + 1},{10.0 * i},{10.0 * j},0\n" for j in range(2) for i in range(3))
        strip = ("*PART\nstrip\n3,1,1\n*SECTION_SHELL\n1,2,0.8333,3\n1.0\n*MAT_ELASTIC\n1,7.85e-9,210000.,0.3\n"
                 f"*NODE\n{nodes}*ELEMENT_SHELL\n1,3,1,2,12,11\n2,3,2,3,13,12\n*SET_PART_LIST\n1\n3\n"
                 "*DEFINE_COORDINATE_VECTOR\n9,0.,1.,0.,-1.,0.,0.\n*SET_NODE_LIST\n2\n3,13\n*INITIAL_VELOCITY\n2\n5000.,0.,0.\n")
        plane = "*DATABASE_CROSS_SECTION_PLANE_ID\n1,plane\n1,15.,-5.,-5.,16.,-5.,-5.\n,,,,,9,2\n"
        by_set = ("*SET_SHELL_LIST\n5\n2\n*SET_NODE_LIST\n6\n2,12\n"
                  "*DATABASE_CROSS_SECTION_SET_ID\n1,set\n6,0,0,5,0,0,9,2\n")
        for name, section in (("plane", plane), ("set", by_set)):
            with self.subTest(name):
                self.deck(strip + section, OFFSETS, transformation=1, more="*DATABASE_SECFORC\n1e-6,2\n")
                self.nugget("run", "model.k", "--quiet")
                state = lsda.states(lsda.read(self.folder / "binout0000"), "secforc")[-1]
                # Pulled along the strip, which is the second axis of the system with its sign turned.
                self.assertGreater(abs(state["y_force"][0]), 1.0)
                self.assertLess(abs(state["x_force"][0]) + abs(state["z_force"][0]), 1e-3 * abs(state["y_force"][0]))

    def test_a_scale_does_not_speed_up(self):
        self.write("*KEYWORD\n" + NODAL.replace("0,0,0,10.,20.,40.", "100.,0,0") + "*END\n", "inner.k")
        self.write("*KEYWORD\n*CONTROL_TERMINATION\n1e-6\n*DATABASE_GLSTAT\n1e-6\n*INCLUDE_TRANSFORM\ninner.k\n\n\n\n1\n"
                   "*DEFINE_TRANSFORMATION\n1\nSCALE,2.,2.,2.\n*END\n")
        self.assertAlmostEqual(self.kinetic() / (0.5 * 2e-3 * 100.0**2), 1.0, 4)
        self.assertTrue(any("scales nodes and points of the file" in f[3] for f in self.check()))

    def test_what_keeps_to_the_global_axes_is_named(self):
        file = BAR.replace("4,0,10,0", "4,0,10,0,1,0").replace("0.3\n\n\n", "0.3\n1,1,0\n\n") + "*PART\nbar\n1,1,1\n" + (
            "*NODE\n5,20,0,0\n6,30,0,0\n*ELEMENT_MASS\n1,5,1.\n2,6,1.\n*BOUNDARY_SPC_NODE\n5,0,1\n"
            "*BOUNDARY_PRESCRIBED_MOTION_NODE\n6,1,0,9\n*LOAD_NODE_POINT\n5,2,9\n*CONSTRAINED_GLOBAL\n1,0,1,20.\n")
        more = curve(9, (0.0, 1.0), (1.0, 1.0))
        wanted = {"*NODE", "*MAT_RIGID", "*BOUNDARY_SPC_NODE", "*BOUNDARY_PRESCRIBED_MOTION_NODE", "*LOAD_NODE_POINT",
                  "*CONSTRAINED_GLOBAL"}
        for transformation, keywords in ((1, wanted), (0, set())):
            self.deck(file, transformation=transformation, more=more)
            told = {f[1] for f in self.check() if f[0] == "warning" and "along the global axes" in f[3]}
            self.assertEqual(told, keywords)

    def test_a_box_moves_with_its_file(self):
        file = ("*NODE\n1,0,0,0\n2,10,0,0\n*ELEMENT_MASS\n1,1,1.\n2,2,1.\n*DEFINE_BOX\n1,-1,1,-1,1,-1,1\n"
                "*SET_NODE_GENERAL\n1\nBOX,1\n*INITIAL_VELOCITY\n1\n3.0\n")
        self.write(f"*KEYWORD\n{file}*END\n", "inner.k")
        self.write("*KEYWORD\n*CONTROL_TERMINATION\n1e-6\n*DATABASE_GLSTAT\n1e-6\n*INCLUDE_TRANSFORM\ninner.k\n\n\n\n1\n"
                   "*DEFINE_TRANSFORMATION\n1\nTRANSL,500.,0.,0.\n*CONTROL_TIMESTEP\n1e-7,0.9,0,0,0\n*END\n")
        self.assertAlmostEqual(self.kinetic(), 4.5, 6)
        self.deck(file, transformation=1)
        self.assertIn("a box cannot be turned or scaled with its include",
                      self.nugget("check", "model.k", expect=1).stderr)

    # ---- ids

    def test_ids_of_every_kind_move(self):
        interpolation = "*NODE\n21,3,3,1\n*ELEMENT_MASS\n5,21,1.\n"
        cases = {
            "irigid": BAR + GLOBAL + "*SET_PART_LIST\n3\n1\n*INITIAL_VELOCITY\n0,0,0,3\n1.,0,0\n",
            "axis by nodes": BAR + "*PART\nbar\n1,1,1\n*INITIAL_VELOCITY_GENERATION\n1,2,10.\n0,0,0,-999,1,2\n",
            "interpolation by nodes": BAR + "*PART\nbar\n1,1,1\n" + interpolation +
                                      "*CONSTRAINED_INTERPOLATION\n1,21,123\n1\n2\n3\n",
            "interpolation by a set": BAR + "*PART\nbar\n1,1,1\n" + interpolation +
                                      "*SET_NODE_LIST\n4\n1,2,3\n*CONSTRAINED_INTERPOLATION\n1,21,123,,1\n4\n",
            "accelerometer": BAR + "*PART\nbar\n1,1,1\n" + curve(8, (0.0, 1.0), (1.0, 1.0)) +
                             "*ELEMENT_SEATBELT_ACCELEROMETER\n1,1,2,4,8\n",
            "material axes": BAR.replace("*MAT_RIGID\n1,7.85e-9,210000.,0.3\n\n\n",
                                         "*MAT_ORTHOTROPIC_ELASTIC\n1,1.5e-9,150000.,9000.,9000.,0.02,0.02,0.3\n"
                                         "5000.,3000.,5000.,-7\n\n\n*DEFINE_COORDINATE_VECTOR\n7,1,0,0,0,1,0\n") +
                             "*PART\nbar\n1,1,1\n",
            "layers": BAR.replace("1,2,1.0,3\n", "1,2,1.0,2,1,-5\n") + "*PART\nbar\n1,1,1\n*INTEGRATION_SHELL\n5,2,1\n",
        }
        weld = ("*PART\nweld\n2,2,2\n*SECTION_BEAM\n2,9,1.0,2,1\n5.,5.\n*NODE\n31,5,5,0\n32,5,5,1\n"
                "*ELEMENT_BEAM\n1,2,31,32\n")
        cases["weld strength"] = weld + curve(8, (0.0, 100.0), (10.0, 200.0)) + (
            "*MAT_SPOTWELD\n2,7.85e-9,210000.,0.3,400.,1000.\n0,-8\n")
        cases["weld table"] = weld + (
            "*MAT_SPOTWELD_DAMAGE-FAILURE\n2,7.85e-9,210000.,0.3,400.,1000.\n\n0,10,8\n"
            "*DEFINE_SPOTWELD_FAILURE\n8,0,1.183,0.003,0.046,2.,2.\n*DEFINE_SPOTWELD_FAILURE\n9,0,1.183,0.003,0.046,2.,2.\n")
        for name, file in cases.items():
            with self.subTest(name):
                for offsets in ("\n\n", OFFSETS):
                    self.deck(file, offsets=offsets)
                    missing = [f for f in self.check() if "not defined" in f[3]]
                    self.assertEqual(missing, [])

    # ---- units

    def test_an_id_below_zero_has_no_unit(self):
        weld = ("*PART\nweld\n2,2,2\n*SECTION_BEAM\n2,9,1.0,2,1\n5.,5.\n*NODE\n31,5,5,0\n32,5,5,1\n"
                "*ELEMENT_BEAM\n1,2,31,32\n*MAT_SPOTWELD\n2,7.85e-9,210000.,0.3,-8,1000.\n0,-9\n")
        self.deck(weld, units="1000.,0.001,10.\n", more=curve(8, (0.0, 300.0), (1.0, 400.0)) + curve(9, (0.0, 1.0), (1.0, 2.0)))
        self.check()

    def test_decay_of_friction_is_a_time_over_a_length(self):
        for keyword in ("CONTACT_AUTOMATIC_SINGLE_SURFACE", "PART"):
            row = re.search(r"^ +\S+ +dc .*$", self.nugget("keywords", keyword).stdout, re.M)[0]
            self.assertRegex(row, r"L\^-1 T\b")

    def test_dyna_inc_is_named(self):
        self.deck(NODAL, units=",,,,1\n")
        self.assertTrue(any(f[2] == "incout1" for f in self.check()))


class Moves(CommandTest):
    def deck(self, line):
        self.write("*KEYWORD\n*CONTROL_TERMINATION\n1e-9\n*CONTROL_TIMESTEP\n0,0.8\n" +
                   BAR.replace("*MAT_RIGID\n1,7.85e-9,210000.,0.3\n\n\n", "*MAT_ELASTIC\n1,7.85e-9,210000.,0.3\n") +
                   "*PART\nbar\n1,1,1\n*SET_NODE_GENERAL\n1\nALL\n"
                   f"*NODE_TRANSFORM\n1,1\n*DEFINE_TRANSFORMATION\n1\n{line}\n*END\n")
        return self.nugget("check", "model.k").stderr

    def test_a_mirror_of_nodes_is_named(self):
        self.assertIn("shells have their normals on the other side", self.deck("MIRROR,0,0,0,1,0,0"))
        self.assertNotIn("mirrors", self.deck("ROTATE,0,0,1,0,0,0,180"))

    def test_the_node_at_the_centre_of_mass_is_moved_first(self):
        """NODEID of *PART_INERTIA, whose part stands before the *NODE_TRANSFORM. Sabotage: where the node was before."""
        self.write("*KEYWORD\n*CONTROL_TERMINATION\n1e-5\n*CONTROL_TIMESTEP\n1e-6\n*DATABASE_RBDOUT\n1e-5\n"
                   "*PART_INERTIA\nbody\n1,1,1\n0,0,0,1.0,0,5\n1.0,0,0,1.0,0,1.0\n0,0,0\n"
                   "*SECTION_SHELL\n1,2\n1,1,1,1\n*MAT_RIGID\n1,7.85e-9,210000.,0.3\n\n\n"
                   "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0.5,0.5,2.0\n*ELEMENT_SHELL\n1,1,1,2,3,4\n"
                   "*SET_NODE_GENERAL\n1\nALL\n*NODE_TRANSFORM\n1,1\n"
                   "*DEFINE_TRANSFORMATION\n1\nTRANSL,10.0,20.0,30.0\n*END\n")
        self.nugget("run", "model.k", "--quiet")
        place = [float(x) for x in re.search(r"coordinates: +(\S+) +(\S+) +(\S+)", self.read("rbdout")).groups()]
        self.assertEqual(place, [10.5, 20.5, 32.0])

    def test_an_angle_of_zero_about_an_axis_through_the_origin(self):
        for axis in ("0,0,1", "1,0,0", "0,1,0", "0,-1,1"):
            self.assertEqual(self.deck(f"ROTATE,{axis},0,0,0,0"), "")


class Systems(CommandTest):
    def test_curved_axes_are_refused_where_they_would_count(self):
        for kind, word in ((1, "cylindrical"), (2, "spherical")):
            for use in ("*LOAD_NODE_POINT\n1,1,9,1.,7\n", "*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,1,0,9,1.,-7\n"):
                for system in (f"*DEFINE_COORDINATE_SYSTEM\n7,0,0,0,1,0,0\n0,1,0,{kind}\n",
                               f"*DEFINE_COORDINATE_NODES\n7,1,2,3,0,X,{kind}\n"):
                    self.write("*KEYWORD\n*CONTROL_TERMINATION\n1e-6\n*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n*ELEMENT_MASS\n"
                               "1,1,1.\n2,2,1.\n3,3,1.\n" + curve(9, (0.0, 1.0), (1.0, 1.0)) + system + use + "*END\n")
                    self.assertIn(f"coordinate system 7 is {word}", self.nugget("check", "model.k", expect=1).stderr)


class Sets(CommandTest):
    def deck(self, cards):
        parts = "".join(f"*PART\np{p}\n{p},1,1\n*NODE\n" + "".join(
            f"{10 * p + i},{10 * p + 5.0 * (i in (2, 3))},{5.0 * (i in (3, 4))},0\n" for i in (1, 2, 3, 4)) +
            f"*ELEMENT_SHELL\n{p},{p},{10 * p + 1},{10 * p + 2},{10 * p + 3},{10 * p + 4}\n" for p in range(1, 8))
        self.write("*KEYWORD\n*CONTROL_TERMINATION\n1e-9\n*SECTION_SHELL\n1,2,1.,3\n1.\n*MAT_ELASTIC\n1,7.85e-9,210000.,0.3\n"
                   f"{parts}{cards}*END\n")

    def test_all_seven_parts_are_taken_away(self):
        self.deck("*SET_SEGMENT_GENERAL\n1\nALL\nDPART,1,2,3,4,5,6,7\n")
        self.assertIn("segment set 1 has no members", self.nugget("check", "model.k").stderr)

    def test_a_segment_has_four_nodes_and_then_attributes(self):
        self.deck("*SET_SEGMENT_GENERAL\n1\nSEG,11,12,13,14,1.5,2.5\nSHELL,2,0,0,2.5\n")
        self.assertNotIn("not defined", self.nugget("check", "model.k").stderr)

    def test_a_range_that_ends_before_it_begins_is_named(self):
        self.deck("*SET_NODE_LIST_GENERATE\n1\n11,14,24,21\n")
        self.assertIn("the range from 24 to 21 ends before it begins", self.nugget("check", "model.k").stderr)

    def test_ranges_of_each_kind_have_what_is_in_them(self):
        self.deck("*SET_NODE_LIST_GENERATE\n1\n12,22\n*SET_SHELL_LIST_GENERATE\n2\n2,3,6,9\n*SET_PART_LIST_GENERATE\n3\n3,4\n"
                  "*SET_NODE_LIST_GENERATE_INCREMENT\n4\n11,71,30\n*SET_NODE_GENERAL\n5\nSET_SHELL,2\nSET_PART,3\nSET_NODE,1,4\n"
                  "*INITIAL_VELOCITY\n5\n1.,0,0\n*DATABASE_GLSTAT\n1e-9\n")
        self.nugget("run", "model.k", "--quiet")
        nodes = {12, 13, 14, 21, 22} | {11, 41, 71} | {10 * p + i for p in (2, 3, 6, 7, 4) for i in (1, 2, 3, 4)}
        mass = 7.85e-9 * 25.0 / 4.0
        self.assertAlmostEqual(self.glstat()[0]["kinetic energy"] / (0.5 * mass * len(nodes)), 1.0, 5)


if __name__ == "__main__":
    unittest.main()
