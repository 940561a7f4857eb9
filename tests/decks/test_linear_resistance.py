# SPDX-License-Identifier: Apache-2.0
"""What resists motion in linear analyses, and what does not: springs askew to the axes, loads where nothing resists, forces at the arms of rigid
bodies under preload, masses that a given body stands for. Closed forms, and the same structure turned."""
import csv
import math
import unittest

import lsda
from nugget_command import CommandTest

HEAD = "*KEYWORD\n*CONTROL_TERMINATION\n1.0,\n*DEFINE_CURVE\n77,\n0.0,1.0\n10.0,1.0\n"
STATICS = "*CONTROL_IMPLICIT_GENERAL\n1,1.0,\n*CONTROL_IMPLICIT_SOLUTION\n1,\n"
PRELOAD = "*CONTROL_IMPLICIT_GENERAL\n1,1.0,,,1\n*CONTROL_IMPLICIT_EIGENVALUE\n{},\n"
STATIC_PRELOAD = PRELOAD.format(-8) + "*CONTROL_IMPLICIT_SOLUTION\n1,\n*DEFINE_CURVE\n8,\n0.0,0.0\n1.0,9.0\n"
MASS, STIFFNESS = 2.0, 10.0
WAYS = {"along z": (0.0, 0.0, 1.0), "in a plane": (0.0, 0.6, 0.8), "askew": (2.0 / 7.0, 3.0 / 7.0, 6.0 / 7.0)}


def spring(number, first, place, law="ELASTIC", fields=f"{STIFFNESS}", offset=0.0):
    """From a node to one that is held."""
    x, y, z = place
    return (f"*SECTION_DISCRETE\n{number},0,\n,\n*PART\nspring\n{number},{number},{number}\n*MAT_SPRING_{law}\n{number},{fields},\n"
            f"*ELEMENT_DISCRETE\n{number},{number},{first},{number},0,1.0,0,{offset}\n*NODE\n{number},{x},{y},{z}\n"
            f"*BOUNDARY_SPC_NODE\n{number},0,1,1,1\n")


def mass_on_a_spring(way, *cards):
    """At the origin, on a spring of length 10."""
    return (HEAD + spring(11, 1, [10.0 * c for c in way]) + f"*ELEMENT_MASS\n1,1,{MASS}\n*NODE\n1,0.0,0.0,0.0\n"
            + "*DATABASE_HISTORY_NODE\n1,\n*DATABASE_NODOUT\n1.0,2\n" + "".join(cards) + "*END\n")


def force(vector, node=1):
    return "*LOAD_NODE_POINT\n" + "".join(f"{node},{i + 1},77,{f}\n" for i, f in enumerate(vector) if f != 0.0)


def body(nodes, half, *cards, inertia=50.0):
    """A rigid body of mass 2 along x from -half to half, about whose middle it has one moment of inertia in all directions."""
    return (HEAD + f"*SET_NODE_LIST\n1,\n{','.join(map(str, nodes))}\n*CONSTRAINED_NODAL_RIGID_BODY_INERTIA\n50,0,1\n0.0,0.0,0.0,{MASS},0\n"
            f"{inertia},0.0,0.0,{inertia},0.0,{inertia}\n0.0,0.0,0.0,0.0,0.0,0.0\n*NODE\n1,{-half},0.0,0.0\n2,{half},0.0,0.0\n"
            + "".join(cards) + "*END\n")


def mechanism():
    """Two bricks with one edge in common, one of them held."""
    nodes = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1), (2, 0, 1), (2, 1, 1), (1, 0, 2), (1, 1, 2), (2, 0, 2), (2, 1, 2)]
    return HEAD + STATICS + (
        "*SECTION_SOLID\n21,1\n*MAT_ELASTIC\n21,7.85e-9,210000.0,0.3\n*PART\nbricks\n21,21,21\n*ELEMENT_SOLID\n1,21,1,2,3,4,5,6,7,8\n"
        "2,21,6,9,10,7,11,13,14,12\n*NODE\n" + "".join(f"{i},{x},{y},{z}\n" for i, (x, y, z) in enumerate(nodes, 1)) +
        "*LOAD_NODE_POINT\n13,3,77,2.0\n*BOUNDARY_SPC_NODE\n" + "".join(f"{i},0,1,1,1\n" for i in range(1, 5)) + "*END\n")


class LinearResistance(CommandTest):
    def frequencies(self, text, *arguments, command="modes"):
        self.write(text)
        self.nugget(command, "model.k", *arguments, "-o", "modes", "--quiet")
        return [mode["frequency_hz"] for mode in self.json("modes/summary.json")["modes"]]

    def assert_squares(self, text, squares, delta=1e-6, **options):
        """Of the circular frequencies."""
        found = self.frequencies(text, **options)
        self.assertEqual(len(found), len(squares), found)
        for one, square in zip(found, sorted(squares)):
            self.assertAlmostEqual((2.0 * math.pi * one) ** 2 / square, 1.0, delta=delta)

    def displacement(self, text):
        self.write(text)
        self.nugget("run", "model.k", "-o", "out", "--quiet")
        last = lsda.states(lsda.read(self.folder / "out/binout0000"), "nodout")[-1]
        return [last[f"{axis}_displacement"][0] for axis in "xyz"]

    def test_a_spring_that_lies_askew(self):
        """Across it nothing resists, whichever way it lies: one mode, and statics along it. Sabotage: rows of zeros alone."""
        for name, way in WAYS.items():
            with self.subTest(name):
                self.assert_squares(mass_on_a_spring(way), [STIFFNESS / MASS])
                moved = self.displacement(mass_on_a_spring(way, STATICS, force([5.0 * c for c in way])))
                for found, c in zip(moved, way):
                    self.assertAlmostEqual(found, 0.5 * c, delta=1e-9)

    def test_springs_in_a_plane_that_lies_askew(self):
        """Two at right angles: across their plane nothing resists."""
        for second in ((0.0, 0.8, -0.6), (1.0, 0.0, 0.0)):
            with self.subTest(second):
                other = spring(12, 1, [10.0 * c for c in second], fields="40.0")
                self.assert_squares(mass_on_a_spring(WAYS["in a plane"], other), [STIFFNESS / MASS, 40.0 / MASS])

    def test_a_load_that_nothing_resists(self):
        """Statics refuses it by its line. Sabotage: the load is gone, and the reactions do not hold it."""
        for name, way, load, words in (
                ("along z", WAYS["along z"], [5.0, 0.0, 2.0], "nothing resists a force along (1 0 0) at node 1, and nothing holds it"),
                ("askew", WAYS["in a plane"], [0.0, 0.0, 2.0], "nothing resists a force along (0 -0.8 0.6) at node 1, and nothing holds it")):
            with self.subTest(name):
                text = mass_on_a_spring(way, STATICS, force(load))
                line = text.split("*LOAD_NODE_POINT")[0].count("\n") + 2
                for command in ("run", "check"):
                    self.write(text)
                    said = self.nugget(command, "model.k", "-o", command, expect=1).stderr
                    self.assertIn(f"model.k:{line}: error: *LOAD_NODE: {words}", said)
        self.write(mass_on_a_spring(WAYS["along z"], STATICS, "*LOAD_BODY_X\n77,5.0\n*LOAD_BODY_Z\n77,-5.0\n"))
        said = self.nugget("run", "model.k", "-o", "out", "--quiet").stderr
        self.assertIn("warning: *LOAD_BODY: nothing resists a force along (-1 0 0) at node 1, and nothing holds it", said)

    def test_loads_on_what_is_not_there(self):
        """A node of its own, and a moment on a node that only a spring knows."""
        lone = "*NODE\n99,5.0,5.0,5.0\n" + force([0.0, 0.0, 2.0], node=99)
        for cards, words in ((lone, "node 99 carries a load, but belongs to no element, mass or rigid body"),
                             ("*LOAD_NODE_POINT\n1,5,77,3.0\n", "node 1 carries a moment, but nothing there can turn")):
            self.write(mass_on_a_spring(WAYS["along z"], STATICS, cards))
            self.assertIn("error: *LOAD_NODE: " + words, self.nugget("run", "model.k", "-o", "out", expect=1).stderr)
        self.write(mass_on_a_spring(WAYS["along z"], lone, "*INITIAL_VELOCITY\n0,\n0.0,0.0,1.0,\n"))
        self.assertIn("warning: *LOAD_NODE: node 99 is loaded, but belongs to no element", self.nugget("run", "model.k", "-o", "out").stderr)

    def test_responses_where_nothing_resists(self):
        frf = "*CONTROL_IMPLICIT_EIGENVALUE\n2,\n*FREQUENCY_DOMAIN_FRF\n1,0,{},3,\n0.02,\n{},0,{},2,\n0.1,0.2,2,\n"
        deck = lambda load, node, wanted: self.write(mass_on_a_spring(WAYS["along z"], "*NODE\n99,5.0,5.0,5.0\n", frf.format(load, node, wanted)))  # noqa: E731
        deck(1, 1, 3)
        said = self.nugget("frf", "model.k", "-o", "frf", "--quiet", expect=1).stderr
        self.assertIn("error: *FREQUENCY_DOMAIN_FRF: nothing resists motion along (1 0 0) at node 1, which is held there (AUTOSPC)", said)
        deck(3, 99, 3)
        said = self.nugget("frf", "model.k", "-o", "frf", "--quiet", expect=1).stderr
        self.assertIn("error: *FREQUENCY_DOMAIN_FRF: node 99 belongs to no element, mass or rigid body: it has no motion", said)
        deck(3, 1, 1)
        said = self.nugget("frf", "model.k", "-o", "frf", "--quiet").stderr
        self.assertIn("nothing resists motion of node 1 along (1 0 0), which is held there (AUTOSPC)", said)
        deck(3, 1, 3)
        self.assertNotIn("resists motion of", self.nugget("frf", "model.k", "-o", "frf", "--quiet").stderr)
        with open(self.folder / "frf/frf.csv", newline="", encoding="utf-8") as file:
            row = next(csv.DictReader(file))
        omega2, square = (2.0 * math.pi * 0.1) ** 2, STIFFNESS / MASS
        wanted = 1.0 / (MASS * complex(square - omega2, 2.0 * 0.02 * math.sqrt(square * omega2)))
        self.assertAlmostEqual(float(row["amplitude"]) / abs(wanted), 1.0, delta=1e-6)

    def test_what_moves_freely_is_named(self):
        """Two masses and a spring between them that nothing holds."""
        text = HEAD + STATICS + (
            "*SECTION_DISCRETE\n11,0,\n,\n*PART\nspring\n11,11,11\n*MAT_SPRING_ELASTIC\n11,10.0,\n*ELEMENT_DISCRETE\n11,11,1,2,\n*ELEMENT_MASS\n"
            "1,1,2.0\n2,2,2.0\n*NODE\n1,0.0,0.0,0.0\n2,0.0,0.0,9.0\n*LOAD_NODE_POINT\n1,3,77,2.0\n*END\n")
        self.write(text)
        for command in ("check", "run"):
            said = self.nugget(command, "model.k", "-o", "out", expect=1).stderr
            self.assertRegex(said, r"is not held: node [12] and what .* \(2 unknowns\) can move as a rigid body in 1 way, along \(0 0 -?1\)")

    def test_each_of_the_bodies_that_nothing_holds_is_found(self):
        """Three bricks: one held, one by a spring of a billionth of its stiffness at each of six places, one by five of these. Sabotage: a motion
        that little resists counts as free; the ways of a body are those of its planes apart."""
        corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
        places = ((1, 1), (1, 2), (1, 3), (2, 2), (2, 3), (4, 3))  # corner and direction: each takes one motion
        nodes, bricks, springs = "", "", ""
        for b, held in enumerate((6, 6, 5)):
            first = 1 + 10 * b
            nodes += "".join(f"{first + i},{x + 5 * b},{y},{z}\n" for i, (x, y, z) in enumerate(corners))
            bricks += f"{b + 1},21," + ",".join(str(first + i) for i in range(8)) + "\n"
            if b > 0:
                for corner, direction in places[:held]:
                    springs += f"{100 * b + 10 * corner + direction},22,{first + corner - 1},0,{direction}\n"
        text = HEAD + STATICS + (
            "*SECTION_SOLID\n21,1\n*MAT_ELASTIC\n21,7.85e-9,210000.0,0.3\n*PART\nbricks\n21,21,21\n*SECTION_DISCRETE\n22,0,\n,\n"
            "*MAT_SPRING_ELASTIC\n22,1e-4,\n*PART\nsprings\n22,22,22\n" +
            "".join(f"*DEFINE_SD_ORIENTATION\n{d},0,{','.join('1.0' if d == i else '0.0' for i in (1, 2, 3))}\n" for d in (1, 2, 3)) +
            f"*ELEMENT_SOLID\n{bricks}*ELEMENT_DISCRETE\n{springs}*NODE\n{nodes}*LOAD_NODE_POINT\n7,3,77,2.0\n*BOUNDARY_SPC_NODE\n" +
            "".join(f"{i},0,1,1,1\n" for i in range(1, 5)) + "*END\n")
        self.write(text)
        said = self.nugget("check", "model.k", expect=1).stderr
        self.assertRegex(said, r"node 2\d and what .* \(24 unknowns\) can move as a rigid body in 1 way, along \(.*\) there \[")
        self.write(text.replace(springs[springs.index("211,"):], ""))
        self.assertIn("in 6 ways", self.nugget("check", "model.k", expect=1).stderr)

    def test_a_mechanism_ends_the_run(self):
        """One brick swings about an edge of the other: that is seen by the solver alone."""
        self.write(mechanism())
        said = self.nugget("run", "model.k", "-o", "out", expect=3).stderr
        self.assertRegex(said, r"it moves most at node (1[34]|11|12)")

    def test_a_body_between_stretched_springs(self):
        """About its middle 2 F a (a + L) / L: the ends swing out by the arm, too. Sabotage: F a^2 / L of the springs alone."""
        tension, half, length = 6.0, 4.0, 10.0
        ends = [spring(11 + i, 1 + i, (x, 0.0, 0.0), offset=tension / STIFFNESS) for i, x in enumerate((-half - length, half + length))]
        turning = 2.0 * tension * half * (half + length) / length
        for inertia in (50.0, 7.0):
            squares = [2.0 * STIFFNESS / MASS, 2.0 * tension / length / MASS, 2.0 * tension / length / MASS, turning / inertia, turning / inertia]
            self.assert_squares(body((1, 2), half, *ends, PRELOAD.format(9), inertia=inertia), squares)

    def test_a_body_that_a_load_stretches(self):
        """A spring at one end, a force that stays at the other, and two soft springs across that let statics find it. Sabotage: loads have no arm."""
        pull, half, length, inertia, soft = 6.0, 4.0, 10.0, 50.0, 1e-3
        guides = spring(13, 1, (-half, 8.0, 0.0), fields=soft) + spring(14, 2, (half, 8.0, 0.0), fields=soft)
        cards = (spring(11, 1, (-half - length, 0.0, 0.0)), guides, STATIC_PRELOAD, f"*LOAD_NODE_POINT\n2,1,77,{pull}\n")
        found = [(2.0 * math.pi * f) ** 2 for f in self.frequencies(body((1, 2), half, *cards), command="run")]
        displaced, coupled = 2.0 * soft + pull / length, -pull * half / length
        turned = pull * half**2 / length + 2.0 * pull * half + 2.0 * soft * half**2
        a, b, c = displaced / MASS, turned / inertia, coupled**2 / (MASS * inertia)
        for sign in (-1.0, 1.0):
            square = 0.5 * (a + b) + sign * math.sqrt(0.25 * (a - b) ** 2 + c)
            self.assertLess(min(abs(one / square - 1.0) for one in found), 1e-6, (square, found))

    def test_a_rigid_end_is_an_end_that_is_very_stiff(self):
        """A strip pulled by its far end, three eighths of it rigid, or of shells a thousand times as stiff. Sabotage: the rigid end without its arms
        has 76 Hz, not 97."""
        def strip(material):
            number = lambda i, j: 1 + i + 17 * j  # noqa: E731
            text = HEAD + STATIC_PRELOAD + "*MAT_ELASTIC\n1,7.85e-9,2.1e5,0.3\n" + material + "*SECTION_SHELL\n1,16\n1.5,1.5,1.5,1.5\n"
            text += "".join(f"*PART\nstrip\n{p},1,{p}\n" for p in (1, 2))
            text += "*NODE\n" + "".join(f"{number(i, j)},{10.0 * i},{10.0 * j},0.0\n" for j in range(3) for i in range(17))
            text += "*ELEMENT_SHELL\n" + "".join(
                f"{1 + i + 16 * j},{1 + (i >= 10)},{number(i, j)},{number(i + 1, j)},{number(i + 1, j + 1)},{number(i, j + 1)}\n"
                for j in range(2) for i in range(16))
            text += "*BOUNDARY_SPC_NODE\n" + "".join(f"{number(0, j)},0,1,1,1,1,1,1\n" for j in range(3))
            return self.frequencies(text + f"*LOAD_NODE_POINT\n{number(16, 1)},1,77,400.0\n*END\n", command="run")
        rigid, stiff = strip("*MAT_RIGID\n2,7.85e-9,2.1e5,0.3\n,\n,\n"), strip("*MAT_ELASTIC\n2,7.85e-9,2.1e8,0.3\n")
        self.assertAlmostEqual(rigid[0] / stiff[0], 1.0, delta=2e-3)
        self.assertAlmostEqual(rigid[1] / stiff[1], 1.0, delta=2e-2)

    def test_a_pendulum_on_a_joint(self):
        """It hangs by a hinge of stiffness 100 from a body that is held: k + m g l about the hinge. Sabotage: joints have no arm."""
        weight, arm, stiffness, inertia = 300.0, 5.0, 100.0, 40.0
        text = HEAD + STATIC_PRELOAD + "*NODE\n1,0.0,0.0,0.0\n2,0.0,0.0,0.0\n3,1.0,0.0,0.0\n4,0.0,0.0,-9.0\n5,0.0,1.0,0.0\n"
        for pid, nodes, height, held in ((50, "1,3,5", 0.0, "1.0,7,7"), (60, "2,4", -arm, "0.0,0,0")):
            text += (f"*SET_NODE_LIST\n{pid},\n{nodes}\n*CONSTRAINED_NODAL_RIGID_BODY_INERTIA_SPC\n{pid},0,{pid}\n{held},\n0.0,0.0,{height},{MASS},0\n"
                     f"{inertia},0.0,0.0,{inertia},0.0,{inertia}\n0.0,0.0,0.0,0.0,0.0,0.0\n")
        text += ("*CONSTRAINED_JOINT_SPHERICAL\n1,2,0,0,0,0,1.0\n*DEFINE_COORDINATE_SYSTEM\n4,0.,0.,0.,1.,0.,0.\n0.,1.,0.\n"
                 f"*DEFINE_CURVE\n9,\n0.0,0.0\n1.0,{stiffness}\n*CONSTRAINED_JOINT_STIFFNESS_GENERALIZED\n1,50,60,4,4\n9,9,9\n,\n,\n"
                 f"*LOAD_RIGID_BODY\n60,3,77,{-weight}\n*END\n")
        swinging = (stiffness + weight * arm) / (inertia + MASS * arm**2)
        found = [(2.0 * math.pi * f) ** 2 for f in self.frequencies(text, command="run")][:3]
        for one, square in zip(found, sorted((swinging, swinging, stiffness / inertia))):
            self.assertAlmostEqual(one / square, 1.0, delta=1e-4)  # the joint's own compliance

    def test_a_free_strip_that_is_long_and_thin(self):
        """10 m of 5 x 1.5 mm, held nowhere: Euler's beam of free ends across its thickness and its width. Round-off moves its rigid motions by more
        than the shift behind which they are sought. Sabotage: 'the structure is not stable'."""
        length, width, thickness, young, density, along = 1e4, 5.0, 1.5, 2.1e5, 7.85e-9, 200
        text = HEAD + f"*MAT_ELASTIC\n1,{density},{young},0.3\n*SECTION_SHELL\n1,16\n" + ",".join([f"{thickness}"] * 4) + "\n*PART\nstrip\n1,1,1\n*NODE\n"
        text += "".join(f"{1 + i + (along + 1) * j},{length * i / along},{0.5 * width * j},0.0\n" for j in range(3) for i in range(along + 1))
        text += "*ELEMENT_SHELL\n"
        for j in range(2):
            for i in range(along):
                a = 1 + i + (along + 1) * j
                text += f"{1 + i + along * j},1,{a},{a + 1},{a + along + 2},{a + along + 1}\n"
        found = self.frequencies(text + "*END\n", "-n", 10)
        self.assertLess(found[5], 0.1 * found[6])
        bent = lambda root, height: root**2 / (2.0 * math.pi * length**2) * math.sqrt(young * height**2 / 12.0 / density)  # noqa: E731
        for one, expected in zip(found[6:], sorted((bent(4.730041, thickness), bent(7.853205, thickness), bent(10.995608, thickness), bent(4.730041, width)))):
            self.assertAlmostEqual(one / expected, 1.0, delta=2e-3)

    def test_a_given_mass_stands_for_what_is_tied_to_the_body(self):
        """As in a run: the modes have the mass that the run has. Sabotage: the nodes of the tie add theirs."""
        plate = lambda first, x, y: "".join(f"{first + i},{a},{b},{c}\n" for i, (a, b, c) in enumerate((x, y[0], y[1], y[2])))  # noqa: E731
        text = (HEAD.replace("1.0,\n*DEFINE", "1e-6,\n*DEFINE") + "*MAT_ELASTIC\n1,7.85e-9,2.1e5,0.3\n*MAT_RIGID\n2,7.85e-9,2.1e5,0.3\n,\n,\n"
                "*SECTION_SHELL\n1,16\n1.5,1.5,1.5,1.5\n*PART_INERTIA\nrigid\n1,1,2\n20.0,20.0,0.0,1e-4,0\n0.03,0.0,0.0,0.06,0.0,0.09\n"
                "0.0,0.0,0.0,0.0,0.0,0.0\n*PART\nupright\n2,1,1\n*NODE\n" + plate(1, (0, 0, 0), ((40, 0, 0), (40, 40, 0), (0, 40, 0)))
                + plate(11, (10, 10, 0), ((30, 15, 0), (30, 15, 20), (10, 10, 20))) + "*ELEMENT_SHELL\n1,1,1,2,3,4\n2,2,11,12,13,14\n"
                "*SET_NODE_LIST\n9,\n11,12\n*CONTACT_TIED_SHELL_EDGE_TO_SURFACE\n9,1,4,3\n0.\n1.\n*END\n")
        self.frequencies(text, "-n", 8)
        mass = sum(mode["effective_mass"][0] for mode in self.json("modes/summary.json")["modes"][:6])
        self.nugget("run", "model.k", "-o", "run", "--quiet")
        self.assertAlmostEqual(mass / self.json("run/summary.json")["mass"]["physical"], 1.0, delta=1e-6)

    def test_a_spring_whose_loading_curve_has_a_kink(self):
        """S06, 10 in tension and 20 under compression: the mean, as of other springs."""
        curve = "*DEFINE_CURVE\n9,\n-1.0,-20.0\n0.0,0.0\n1.0,10.0\n"
        text = mass_on_a_spring(WAYS["along z"], curve).replace("*MAT_SPRING_ELASTIC\n11,10.0,", "*MAT_SPRING_GENERAL_NONLINEAR\n11,9,9,1.0,5.0,-5.0")
        self.assert_squares(text, [15.0 / MASS])

    def test_statics_says_what_relaxes(self):
        deck = mass_on_a_spring(WAYS["along z"], STATICS, force((0.0, 0.0, 2.0)))
        self.write(deck.replace("*MAT_SPRING_ELASTIC\n11,10.0,", "*MAT_SPRING_MAXWELL\n11,10.0,2.0,1.0"))
        said = self.nugget("run", "model.k", "-o", "out", "--quiet").stderr
        self.assertIn("material 11 (*MAT_SPRING_MAXWELL): linear statics takes the stiffness at once (G0, K0)", said)
        self.write(deck)
        self.assertNotIn("stiffness at once", self.nugget("run", "model.k", "-o", "out", "--quiet").stderr)


if __name__ == "__main__":
    unittest.main()
