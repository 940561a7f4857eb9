# SPDX-License-Identifier: Apache-2.0
"""Fields that hold what they should not, found by changing one field of a deck after the other: each is said once, at its
place, and nothing that is read goes without an effect or a word."""
import unittest

import lap_joint
from few_elements import BRICK, CORNERS, SOLID, card, curve, nodes, part
from nugget_command import CommandTest

HEAD = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(1e-6)
STEEL = "*MAT_ELASTIC\n" + card(1, 7.85e-9, 210000.0, 0.3)
PLASTIC = "  7.85e-09  210000.0       0.3     300.0    1000.0\n       0.0       0.0\n\n\n"  # of the lap joint's sheets
BLOCK = part(1) + SOLID + nodes(CORNERS) + BRICK


def brick(*cards, material=STEEL, block=BLOCK):
    return HEAD + material + block + "".join(cards) + "*END\n"


class MistakenFields(CommandTest):
    def lines(self, text, severity, code):
        """The errors, or warnings, of a deck."""
        self.write(text)
        said = self.nugget("check", "model.k", expect=code).stderr.splitlines()
        return [line for line in said if f": {severity}: " in line]

    def one_error(self, text, *expected):
        errors = self.lines(text, "error", 1)
        self.assertEqual(len(errors), 1, errors)
        for part_of_it in expected:
            self.assertIn(part_of_it, errors[0])

    def test_points_of_a_yield_curve_behind_an_empty_one(self):
        """Sabotage: the table ends at the first empty point, and those behind it are dropped."""
        def sheets(strains, stresses):
            return lap_joint.deck((PLASTIC, PLASTIC[:-2] + card(*strains) + card(*stresses)))
        self.assertEqual(self.lines(sheets((0.0, 0.1, 0.2), (300.0, 350.0, 380.0)), "error", 0), [])
        self.one_error(sheets((0.0, 0.1, "", 0.2), (300.0, 350.0, "", 380.0)),
                       "es4 = 380.0: point 4 stands behind point 3, which is empty")
        self.one_error(sheets(("", 0.1, 0.2), ("", 350.0, 380.0)), "es2 = 350.0: point 2 stands behind point 1, which is empty")
        self.one_error(sheets((0.0, 0.1, "", 0.2), (300.0, 350.0)), "eps4 = 0.2: point 4 stands behind point 3, which is empty")

    def test_the_other_side_of_a_single_surface(self):
        contact = "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n{}\n\n"
        self.assertEqual(self.lines(brick(contact.format(card(1, 0, 3))), "warning", 0), [])
        warnings = self.lines(brick(contact.format(card(1, 1, 3, 3))), "warning", 0)
        self.assertEqual(len(warnings), 1, warnings)
        self.assertIn("surfb = 1: no effect: a single surface has no other side", warnings[0])

    def test_sides_of_a_contact_are_refused_once(self):
        contact = "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n{}\n\n"
        self.one_error(brick(contact.format(card(1, 1, "x", 3))), "surfatyp = x: is not a whole number")
        self.one_error(brick(contact.format(card(1, 1, 3, 9))), "surfbtyp = 9: expected 0 to 7")
        self.one_error(brick(contact.format(card(1, 1, 3, 3, 0, -1))), "sbboxid = -1: a box that moves on is not built")

    def test_a_part_whose_material_cannot_be_read_is_refused_once(self):
        self.one_error(brick(block=BLOCK.replace(part(1), part(1, 1, "steel"))), "mid = steel: an alphanumeric id")
        self.one_error(brick(block=BLOCK.replace(part(1), part(1, "1.5"))), "secid = 1.5: expected a whole number")
        self.one_error(brick(block=BLOCK.replace(part(1), part(1, 1, 0))), "part 1 has elements, but no material")

    def test_what_an_unread_id_may_have_been(self):
        errors = self.lines(brick(material=STEEL.replace(card(1, 7.85e-9)[:10], f"{'1x':>10}")), "error", 1)
        self.assertEqual(len(errors), 2, errors)
        self.assertTrue(any("mid = 1: material 1 is not defined [correct the id of the material that could not be read]" in e
                            for e in errors), errors)
        self.one_error(brick(block=BLOCK.replace(part(1), part(1, 1, 7))), "mid = 7: material 7 is not defined")
        self.assertNotIn("could not be read", self.read("findings.json"))

    def test_a_missing_system_of_velocities_is_said_once(self):
        of_set = "*SET_NODE_LIST\n" + card(1) + card(1, 2) + "*INITIAL_VELOCITY\n" + card(1, 0, 0, 0, 7)
        self.one_error(brick(of_set + card(1.0, 0, 0, 0, 0, 2.0)), "icid = 7: coordinate system 7 is not defined")
        self.one_error(brick("*INITIAL_VELOCITY_NODE\n" + card(1, 1.0, 0, 0, 0, 0, 0, 7)), "icid = 7: coordinate system 7 is not defined")
        generation = "*INITIAL_VELOCITY_GENERATION\n" + card(0, 0, 3.0, 1.0, 0, 0, 0, 7)
        self.one_error(brick(generation + card(0, 0, 0, 0, 0, 1.0)), "icid = 7: coordinate system 7 is not defined")

    def test_a_missing_node_of_an_axis_is_said_once(self):
        generation = "*INITIAL_VELOCITY_GENERATION\n" + card(0, 0, 3.0)
        self.one_error(brick(generation + card(0, 0, 0, -999, 99, 2)), "ny = 99: node 99 is not defined")
        self.assertEqual(self.lines(brick(generation + card(0, 0, 0, -999, 1, 2)), "error", 0), [])

    def test_an_id_below_0_is_whole(self):
        """Sabotage: -1.5 is the coordinate system 1."""
        def layers(aopt):
            return ("*MAT_ORTHOTROPIC_ELASTIC\n" + card(1, 7.85e-9, 1e5, 1e5, 1e5, 0.3, 0.3, 0.3) + card(4e4, 4e4, 4e4, aopt) +
                    "\n\n*DEFINE_COORDINATE_VECTOR\n" + card(1, 1, 0, 0, 0, 1, 0))
        self.assertEqual(self.lines(brick(material=layers("-1")), "error", 0), [])
        self.one_error(brick(material=layers("-1.5")), "aopt = -1.5: expected a whole number: below 0 it stands for an id")
        self.one_error(brick(material=layers("2147483648")), "aopt = 2147483648: only 0, 2, 3 and the id of a coordinate system")

    def test_a_tensor_of_inertia_names_its_keyword(self):
        body = "*PART_INERTIA\nbody\n" + card(1, 1, 1) + card(0.5, 0.5, 0.5, 1.0) + card(1.0, 9.0, 0, 1.0, 0, 1.0) + card("")
        inertia = BLOCK.replace(part(1), body)
        rigid = "*MAT_RIGID\n" + card(1, 7.85e-9, 210000.0, 0.3) + "\n\n"
        self.one_error(brick(material=rigid, block=inertia), "error: *PART_INERTIA: the tensor of inertia of rigid part 1")

    def test_statics_beyond_the_range_of_results(self):
        """d3plot holds single precision. Sabotage: an infinite displacement, and normal termination."""
        def deck(load):
            return ("*KEYWORD\n*CONTROL_TERMINATION\n" + card(1.0) + curve(77, (0.0, 1.0), (10.0, 1.0)) +
                    "*CONTROL_IMPLICIT_GENERAL\n" + card(1, 1.0) + "*CONTROL_IMPLICIT_SOLUTION\n" + card(1) + STEEL + BLOCK +
                    "*BOUNDARY_SPC_NODE\n" + "".join(card(n, 0, 1, 1, 1) for n in (1, 2, 3, 4)) +
                    "*LOAD_NODE_POINT\n" + card(5, 3, 77, load) + "*END\n")
        self.write(deck(100.0))
        self.nugget("run", "model.k", "--quiet", "-o", "sound")
        for load, what in (("1e30", "the strain energy"), ("1e60", "the displacement of node"), ("1e300", "the displacement of node")):
            self.write(deck(load))
            said = self.nugget("run", "model.k", "--quiet", "-o", "out", expect=3).stderr
            self.assertIn(what, said)
            self.assertIn("is no number that results can hold", said)
            self.assertIn("E r r o r   t e r m i n a t i o n", self.read("out/run.log"))


if __name__ == "__main__":
    unittest.main()
