# SPDX-License-Identifier: Apache-2.0
"""Result files of decks of a few elements against closed forms, as an engineer checks them: d3plot by VTK's reader, binout
and the ASCII files."""
import math
import re
import unittest

import lsda
from few_elements import BRICK, CORNERS, SOLID, card, curve, nodes, part
from nugget_command import CommandTest

RIGID = "*MAT_RIGID\n         1   7.8e-09    2.1e+5       0.3\n\n\n"
ELASTIC = "*MAT_ELASTIC\n         1   7.8e-09    2.1e+5       0.0\n"


class Outputs(CommandTest):
    def states(self, branch):
        """[{name: values}] of a branch of binout0000, however deep it lies."""
        return lsda.states(lsda.read(self.folder / "binout0000"), branch)

    def run_deck(self, *cards, name="model.k"):
        self.write("*KEYWORD\n" + "".join(cards) + "*END\n", name)
        self.nugget("run", name, "--quiet")

    def warnings(self):
        return [(f["field"], f["text"]) for f in self.json("findings.json") if f["severity"] == "warning"]

    def test_nodes_of_a_turning_body_in_d3plot(self):
        """v = v_c + w x r and a = -w^2 r. Sabotage: d3plot takes the nodes' own rows, as they were half a step before."""
        w, end = 100.0, 0.004
        self.run_deck(nodes(CORNERS), BRICK, part(1), SOLID, RIGID,
                      "*INITIAL_VELOCITY_GENERATION\n", card(1, 2, w, 10.0, 0.0, 0.0), card(.5, .5, .5, 0.0, 0.0, 1.0),
                      "*CONTROL_TERMINATION\n", card(end), "*DATABASE_BINARY_D3PLOT\n", card(0.001))
        states = self.d3plot()["states"]
        self.assertEqual(len(states), 5)
        for state in states:
            block, t = state["blocks"][0], state["time"]
            arrays = block["point_arrays"]
            for i, (x, y, _) in enumerate(block["points"]):
                r = [(x - .5) * math.cos(w * t) - (y - .5) * math.sin(w * t),
                     (x - .5) * math.sin(w * t) + (y - .5) * math.cos(w * t)]
                for seen, exact in zip(arrays["Velocity"][i], (10.0 - w * r[1], w * r[0], 0.0)):
                    self.assertAlmostEqual(seen, exact, delta=1e-3)
                for seen, exact in zip(arrays["Acceleration"][i], (-w * w * r[0], -w * w * r[1], 0.0)):
                    self.assertAlmostEqual(seen, exact, delta=0.1)

    def test_rotation_of_a_body_beyond_half_a_turn(self):
        """Sabotage: the rotation vector of its axes, which begins anew."""
        w, end = 1000.0, 0.01
        self.run_deck(nodes(CORNERS), BRICK, part(1), SOLID, RIGID, "*INITIAL_VELOCITY_GENERATION\n", card(1, 2, w),
                      card(.5, .5, .5, 0.0, 0.0, 1.0), "*CONTROL_TERMINATION\n", card(end), "*DATABASE_RBDOUT\n",
                      card(0.001, 2))
        for state in self.states("rbdout"):
            self.assertAlmostEqual(state["global_rdz"][0], w * state["time"][0], delta=1e-6)

    def test_tied_nodes_in_nodout_and_matsum(self):
        """Two tied bricks under the same acceleration, at the first and the last state too, where steps differ.
        Sabotage: dependent nodes as they were half a step before; velocities by the mean of two unequal steps."""
        upper = [(x, y, z + 1) for x, y, z in CORNERS]
        second = "       2       2\n" + "".join(f"{n:8}" for n in range(11, 19)) + "\n"
        self.run_deck(nodes(CORNERS), nodes(upper, 11), BRICK, second, part(1), part(2), SOLID, ELASTIC,
                      "*CONTACT_TIED_SURFACE_TO_SURFACE\n", card(2, 1, 3, 3), "\n\n", "*LOAD_BODY_Z\n", card(1),
                      curve(1, (0.0, -1e6), (1.0, -1e6)), "*CONTROL_TERMINATION\n", card(1e-4),
                      "*DATABASE_NODOUT\n", card(1e-5, 2), "*DATABASE_MATSUM\n", card(1e-5, 2),
                      "*DATABASE_HISTORY_NODE\n", card(1, 11, 15))
        histories = self.states("nodout")
        self.assertGreaterEqual(len(histories), 11)
        for state in histories:
            for velocity, acceleration in zip(state["z_velocity"], state["z_acceleration"]):
                self.assertAlmostEqual(velocity, 1e6 * state["time"][0], delta=1e-7)
                self.assertAlmostEqual(acceleration / 1e6, 1.0, 9)
        for state in self.states("matsum"):
            for momentum in state["z_momentum"]:
                self.assertAlmostEqual(momentum, 7.8e-9 * 1e6 * state["time"][0], delta=1e-15)

    def test_section_through_tetrahedra(self):
        """A cube of five tetrahedra, written n1 n2 n3 n4 n4 n4 n4 n4: the area of the cut and its centroid.
        Sabotage: the edges of a brick, of which that between n1 and n3 is missing."""
        tetrahedra = ((1, 2, 4, 5), (2, 3, 4, 7), (5, 8, 7, 4), (5, 7, 6, 2), (2, 4, 5, 7))
        elements = "*ELEMENT_SOLID\n"
        for i, t in enumerate(tetrahedra):
            elements += f"{i + 1:8}{1:8}" + "".join(f"{n:8}" for n in (*t, *[t[3]] * 4)) + "\n"
        # x = 0.4, and the hexagon halfway between two opposite corners
        planes = "".join("*DATABASE_CROSS_SECTION_PLANE_ID\n" + card(number, "") + card(0, *tail, *head) + "\n"
                         for number, tail, head in ((7, (.4, .5, .5), (1.4, .5, .5)), (8, (.5, .5, .5), (1.5, 1.5, 1.5))))
        self.run_deck(nodes(CORNERS), elements, part(1), "*SECTION_SOLID\n", card(1, 10), ELASTIC,
                      "*CONTROL_TERMINATION\n", card(1e-7), "*DATABASE_SECFORC\n", card(1e-7, 2), planes)
        state = self.states("secforc")[0]
        for seen, exact in zip(state["area"], (1.0, 0.75 * math.sqrt(3.0))):
            self.assertAlmostEqual(seen, exact, 9)
        for axis, places in (("x", (.4, .5)), ("y", (.5, .5)), ("z", (.5, .5))):
            for seen, exact in zip(state[f"{axis}_centroid"], places):
                self.assertAlmostEqual(seen, exact, 9)

    def test_a_section_without_elements_keeps_its_place(self):
        """Three planes without ids, the second beside the cube: rows 1 to 3 and the third one's area. Sabotage: sections
        without elements are left out."""
        planes = "*DATABASE_CROSS_SECTION_PLANE\n"
        planes += "".join(card(0, x, 0.5, 0.5, x + 1, 0.5, 0.5, r) + "\n" for x, r in ((0.5, 0.0), (9.0, 0.0), (0.25, 0.0)))
        self.run_deck(nodes(CORNERS), BRICK, part(1), SOLID, ELASTIC, "*CONTROL_TERMINATION\n", card(1e-7),
                      "*DATABASE_SECFORC\n", card(1e-7, 3), planes)
        self.assertEqual(self.states("secforc")[0]["area"], [1.0, 0.0, 1.0])
        self.assertEqual(re.findall(r"^ *([123]) ", self.read("secforc"), re.MULTILINE)[:3], ["1", "2", "3"])
        self.assertIn(("xct", "cross section 2 has no elements: its forces are 0"), self.warnings())

    def test_fall_of_what_has_more_mass(self):
        """Mass that DT2MS adds weighs by its share EMSCL, with *LOAD_BODY, its _PARTS and *LOAD_GRAVITY_PART: with 1 all
        falls with g, with 0 by the physical share of the mass. Sabotage: the masses of before."""
        for name, load in (("all", "*LOAD_BODY_Z\n" + card(1)),
                           ("parts", "*LOAD_BODY_Z\n" + card(1) + "*LOAD_BODY_PARTS\n" + card(5) +
                            "*SET_PART_LIST\n" + card(5) + card(1)),
                           ("part", "*LOAD_GRAVITY_PART\n" + card(1, 3, 1, 1.0))):
            for share in (0.0, 0.25, 1.0):
                self.run_deck("*CONTROL_TIMESTEP\n", card(0.0, 0.9, 0, 0.0, -4e-7), card(0.0, 0, 0, 0, 0, 0.0, share), nodes(CORNERS),
                              BRICK, part(1), SOLID, ELASTIC, load, curve(1, (0.0, 9810.0), (1.0, 9810.0)), "*CONTROL_TERMINATION\n",
                              card(1e-4), "*DATABASE_NODOUT\n", card(1e-4, 2), "*DATABASE_HISTORY_NODE\n", card(1))
                mass = self.json("summary.json")["mass"]
                self.assertGreater(mass["added"], mass["physical"])
                falls = (mass["physical"] + share * mass["added"]) / (mass["physical"] + mass["added"])
                last = self.states("nodout")[-1]
                self.assertAlmostEqual(last["z_acceleration"][0] / -9810.0, falls, 6, name)
                self.assertAlmostEqual(last["z_velocity"][0] / -0.981, falls, 6, name)

    def test_reactions_where_nothing_has_mass(self):
        """A spring, one end held and the other driven, neither with mass: k u at both, and the work 1/2 k u^2.
        Sabotage: the reaction as mass times change of velocity."""
        self.run_deck(nodes(((0, 0, 0), (3, 4, 0))), "*ELEMENT_DISCRETE\n       1       1       1       2\n",
                      "*PART\nspring\n", card(1, 1, 1), "*SECTION_DISCRETE\n", card(1, 0), "\n*MAT_SPRING_ELASTIC\n",
                      card(1, 100.0), "*BOUNDARY_SPC_NODE\n", card(1, 0, 1, 1, 1), card(2, 0, 0, 0, 1),
                      "*BOUNDARY_PRESCRIBED_MOTION_NODE\n", card(2, 1, 2, 1, 0.6), card(2, 2, 2, 1, 0.8),
                      curve(1, (0.0, 0.0), (1.0, 2.0)), "*CONTROL_TERMINATION\n", card(1.0),
                      "*DATABASE_SPCFORC\n", card(0.1, 2), "*DATABASE_BNDOUT\n", card(0.1, 2),
                      "*DATABASE_GLSTAT\n", card(0.1, 3))
        held, driven = self.states("spcforc")[-1], self.states("bndout/velocity/nodes")[-1]
        self.assertAlmostEqual(held["x_force"][0], -0.6 * 200.0, delta=1e-6)
        self.assertAlmostEqual(held["y_force"][0], -0.8 * 200.0, delta=1e-6)
        self.assertAlmostEqual(sum(driven["x_force"]), 0.6 * 200.0, delta=1e-6)
        self.assertAlmostEqual(sum(driven["y_force"]), 0.8 * 200.0, delta=1e-6)
        self.assertAlmostEqual(self.glstat()[-1]["external work"], 200.0, delta=0.01)

    def bend(self, curvature, section, extent):
        """A square of 10 mm, 2 mm thick, E = 1000, bent about y; the last state of its elout."""
        strip = "*ELEMENT_SHELL\n" + "".join(f"{n:8}" for n in (1, 1, 1, 2, 3, 4)) + "\n"
        self.run_deck(nodes(((0, 0, 0), (10, 0, 0), (10, 10, 0), (0, 10, 0))), strip, part(1),
                      "*SECTION_SHELL\n", section, card(2.0, 2.0, 2.0, 2.0), "*MAT_ELASTIC\n",
                      card(1, 1e-9, 1000.0, 0.0), "*BOUNDARY_SPC_NODE\n", card(1, 0, 1, 1, 1, 1, 1, 1),
                      card(4, 0, 1, 1, 1, 1, 1, 1), "*BOUNDARY_SPC_SET\n", card(1, 0, 1, 1, 0, 1, 0, 1),
                      "*SET_NODE_LIST\n", card(1), card(2, 3), "*BOUNDARY_PRESCRIBED_MOTION_SET\n",
                      card(1, 6, 2, 1, 10 * curvature), curve(1, (0.0, 0.0), (1e-3, 1.0), (1.0, 1.0)),
                      "*CONTROL_TERMINATION\n", card(2e-3), "*DATABASE_ELOUT\n", card(1e-3, 3),
                      "*DATABASE_HISTORY_SHELL\n", card(1), "*DATABASE_BINARY_D3PLOT\n", card(1e-3),
                      "*DATABASE_EXTENT_BINARY\n", extent, card(0, 0, 0), card(0, 0, 0, 0, 0, 0, "ALL"))
        return self.states("elout/shell")[-1]

    def test_strains_at_the_layers_of_the_section(self):
        """Trapezoidal layers (QR/IRID 1) stand on the faces, and so do the strains. Sabotage: the places of Gauss' rule."""
        bent = 1e-5
        last = self.bend(bent, card(1, 2, 1.0, 3, 1.0, 1), card(0, 0, 3, 1))
        for seen, z in zip(last["sig_xx"], (-1.0, 0.0, 1.0)):
            self.assertAlmostEqual(seen, 1000.0 * bent * z, delta=2e-5)
        self.assertAlmostEqual(last["lower_eps_xx"][0], -bent, delta=2e-8)
        self.assertAlmostEqual(last["upper_eps_xx"][0], bent, delta=2e-8)

    def test_layers_of_a_shell(self):
        """MAXINT 2 of a strip that is bent: the first two of four points, not the middle. And STRFLG 10 asks for no strains."""
        bent = 1e-5
        last = self.bend(bent, card(1, 2, 1.0, 4), card(0, 0, 2, 10))
        places = (-0.8611363115940526, -0.3399810435848563, 0.3399810435848563, 0.8611363115940526)
        exact = [1000.0 * bent * z for z in places]  # half the thickness is 1
        for seen, stress in zip(last["sig_xx"], exact):
            self.assertAlmostEqual(seen, stress, delta=2e-5)
        self.assertNotIn("lower_eps_xx", last)
        cells = self.d3plot()["states"][-1]["blocks"][0]["cell_arrays"]
        stresses = sorted(rows[0][0] for name, rows in cells.items() if "Stress" in name and len(rows[0]) == 6)
        self.assertEqual(len(stresses), 2, list(cells))
        for seen, stress in zip(stresses, exact):
            self.assertAlmostEqual(seen, stress, delta=2e-5)
        self.assertEqual({field for field, _ in self.warnings()} & {"strflg", "intout"}, {"strflg", "intout"})

    def test_moments_and_layers_as_ls_dyna_writes_them(self):
        """Of Gauss's five layers elout has the middle one first; the moment is the integral of -z times the stress.
        Sabotage: from the bottom up; z times the stress."""
        bent = 1e-5
        last = self.bend(bent, card(1, 2, 1.0, 5), card(0, 0, 3, 0))
        places = (0.0, -0.9061798459386640, -0.5384693101056831, 0.5384693101056831, 0.9061798459386640)
        for seen, z in zip(last["sig_xx"], places, strict=True):
            self.assertAlmostEqual(seen, 1000.0 * bent * z, delta=2e-5)
        cells = self.d3plot()["states"][-1]["blocks"][0]["cell_arrays"]
        moment = cells["NormalResultant"][0]  # VTK's word for the first three, which are Mx My Mxy
        self.assertAlmostEqual(moment[0], -1000.0 * bent * 2.0 ** 3 / 12.0, delta=2e-5)

    def test_shear_across_a_shell_is_what_carries_its_force(self):
        """Layers of a square that is sheared across by 1e-4: SHRF G gamma, which makes Q. Sabotage: G gamma."""
        shear = "*ELEMENT_SHELL\n" + "".join(f"{n:8}" for n in (1, 1, 1, 2, 3, 4)) + "\n"
        self.run_deck(nodes(((0, 0, 0), (10, 0, 0), (10, 10, 0), (0, 10, 0))), shear, part(1), "*SECTION_SHELL\n",
                      card(1, 2, 0.75, 2), card(2.0, 2.0, 2.0, 2.0), "*MAT_ELASTIC\n", card(1, 1e-9, 1000.0, 0.0),
                      "*BOUNDARY_SPC_SET\n", card(1, 0, 1, 1, 0, 1, 1, 1), card(2, 0, 1, 1, 1, 1, 1, 1),
                      "*SET_NODE_LIST\n", card(1), card(2, 3), "*SET_NODE_LIST\n", card(2), card(1, 4),
                      "*BOUNDARY_PRESCRIBED_MOTION_SET\n", card(1, 3, 2, 1, 1e-3), curve(1, (0.0, 0.0), (1e-3, 1.0), (1.0, 1.0)),
                      "*CONTROL_TERMINATION\n", card(2e-3), "*DATABASE_ELOUT\n", card(1e-3, 3), "*DATABASE_HISTORY_SHELL\n",
                      card(1), "*DATABASE_BINARY_D3PLOT\n", card(1e-3))
        for stress in self.states("elout/shell")[-1]["sig_zx"]:
            self.assertAlmostEqual(stress, 0.75 * 500.0 * 1e-4, delta=2e-5)
        cells = self.d3plot()["states"][-1]["blocks"][0]["cell_arrays"]
        self.assertAlmostEqual(cells["ShearResultant"][0][0], 0.75 * 500.0 * 1e-4 * 2.0, delta=4e-5)
        self.assertAlmostEqual(cells["Stress"][0][5], 0.75 * 500.0 * 1e-4, delta=2e-5)

    def test_options_that_are_told(self):
        """DELERES and SIGFLG are not obeyed, and the run says so; nothing is said of LCO and EOCS, which are."""
        self.run_deck(nodes(CORNERS), BRICK, part(1), SOLID, "*MAT_RIGID\n", card(1, 7.8e-9, 2.1e5, 0.3), "\n", card(3),
                      "*DEFINE_COORDINATE_VECTOR\n", card(3, .8, -.6, 0.0, .6, .8, 0.0), "*CONTROL_TERMINATION\n",
                      card(1e-4), "*DATABASE_RBDOUT\n", card(1e-4), "*CONTROL_OUTPUT\n", card(0),
                      card(0, 0, 2, 50, 0, 0.0, 0, 1), "*DATABASE_EXTENT_BINARY\n", card(0, 0, 3, 0, 2), card(0), card(0),
                      card(0, 0, 0, 0, 0, 1))
        fields = {field for field, _ in self.warnings()}
        self.assertEqual(fields & {"lco_or_a1", "eocs", "sigflg", "deleres"}, {"sigflg", "deleres"})


if __name__ == "__main__":
    unittest.main()
