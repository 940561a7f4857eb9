# SPDX-License-Identifier: Apache-2.0
"""*INCLUDE_TRANSFORM that mirrors: the file behaves as its mirror image. The same file is run plain and mirrored at an oblique plane; every
node of the second run must be where the mirror image of the first is. What has a sense of turning is refused by name."""
import unittest

import lsda
from nugget_command import CommandTest

NORMAL, POINT = (2 / 7, 3 / 7, 6 / 7), (3.0, -1.0, 2.0)  # a unit vector
END = 1.5e-4


def mirrored(p, of_place=True):
    d = 2 * sum(n * (a - (b if of_place else 0)) for n, a, b in zip(NORMAL, p, POINT))
    return tuple(a - d * n for a, n in zip(p, NORMAL))


def master(file="inner.k", line=None):
    head = POINT[0] + NORMAL[0], POINT[1] + NORMAL[1], POINT[2] + NORMAL[2]
    line = line or "MIRROR," + ",".join(f"{a:.17g}" for a in (*POINT, *head))
    return f"*KEYWORD\n*INCLUDE_TRANSFORM\n{file}\n\n\n\n1,\n*DEFINE_TRANSFORMATION\n1,\n{line}\n*END\n"


class File:
    """A file with something of each kind of element, in general position: no symmetry hides a wrong sign."""

    def __init__(self):
        self.cards, self.nodes, self.seed = ["*KEYWORD", f"*CONTROL_TERMINATION\n{END}", f"*DATABASE_NODOUT\n{END / 5},2"], [], 1

    def random(self):
        self.seed = self.seed * 1103515245 + 12345 & 0x7FFFFFFF
        return self.seed / 0x7FFFFFFF - 0.5

    def add(self, keyword, *lines):
        self.cards.append("\n".join([f"*{keyword}", *(",".join(map(str, line)) + "," for line in lines)]))

    def node(self, p, spread=1.0):
        self.nodes.append([a + spread * self.random() for a in p])
        return len(self.nodes)

    def box(self, x, y, z):
        """A distorted block of eight nodes with its first corner near a place."""
        return [self.node((x + a, y + b, z + c)) for c in (0, 10) for a, b in ((0, 0), (10, 0), (10, 10), (0, 10))]

    def flat_box(self, x, y, z):
        """The same with corners in planes: for axes by nodes."""
        corners = [self.node((x + a, y + b, z + c), 0) for c in (0, 10) for a, b in ((0, 0), (10, 1), (9, 10), (2, 8))]
        return corners

    def quads(self, part, x, y, z, n=2, extra=lambda e, corners: []):
        grid = [[self.node((x + 10 * i, y + 10 * j, z)) for i in range(n + 1)] for j in range(n + 1)]
        rows, first = [], 100 * part
        for j in range(n):
            for i in range(n):
                corners = [grid[j][i], grid[j][i + 1], grid[j + 1][i + 1], grid[j + 1][i]]
                if i == j == 0:  # one as two triangles
                    for three in (corners[:3], (corners[0], *corners[2:])):
                        rows.append((first + len(rows) + 1, part, *three, three[2]))
                else:
                    rows.append((first + len(rows) + 1, part, *corners))
        return rows

    def text(self):
        lines = [f"{i + 1}," + ",".join(f"{a:.15g}" for a in x) for i, x in enumerate(self.nodes)]
        speeds = [f"{i + 1}," + ",".join(f"{20000 * self.random():.15g}" for _ in range(3)) for i in range(len(self.nodes))]
        return "\n".join([*self.cards, f"*SET_NODE_LIST_GENERATE\n999\n1,{len(lines)}", "*DATABASE_HISTORY_NODE_SET\n999",
                          "*INITIAL_VELOCITY_NODE", *speeds, "*NODE", *lines, "*END"]) + "\n"


STEEL = (7.85e-9, 210000, 0.3)
FIBRES = [(1.6e-9, 120000, 9000, 9000, 0.02, 0.02, 0.3), (5000, 4000, 3000)]


def orthotropic(f, material, aopt, vectors=(), beta=0.0):
    a, v, d = vectors if vectors else ((0, 0, 0), (0, 0, 0), (0, 0, 0))
    f.add("MAT_ORTHOTROPIC_ELASTIC", (material, *FIBRES[0]), (*FIBRES[1], aopt), (0, 0, 0, *a), (*v, *d, beta))


def shells(f):
    f.add("SECTION_SHELL", (1, 2, 0.8333, 3, 0, 0, 0), (1.5, 1.5, 1.5, 1.5, 0.4))
    f.add("SECTION_SHELL", (2, 16, 0.8333, 3), (1.5, 1.5, 1.5, 1.5))
    f.add("MAT_PIECEWISE_LINEAR_PLASTICITY", (1, *STEEL, 300, 1000), (), (), ())
    orthotropic(f, 2, 0, beta=25.0)
    orthotropic(f, 3, 2, ((1, 0.4, 0.2), (0, 0, 0), (0.1, 1, 0.3)))
    orthotropic(f, 4, 3, ((0, 0, 0), (0.3, 1, 0.2), (0, 0, 0)), 35.0)
    f.add("MAT_3-PARAMETER_BARLAT", (5, 2.7e-9, 70000, 0.33, 1, 400, 200), (8, 1.6, 1.2, 2.2), (2,), (0, 0, 0, 1, 0.3, 0.1), (0, 0, 0, 0.2, 1, 0))
    for part, section, material in ((1, 1, 1), (2, 1, 2), (3, 2, 3), (4, 1, 4), (5, 1, 5)):
        f.cards.append(f"*PART\nsheet\n{part},{section},{material}")
        f.add("ELEMENT_SHELL", *f.quads(part, 40 * part, 0, 0))
    f.cards.append("*PART\nsheet\n6,1,1\n*PART\nsheet\n7,1,2")
    for part, option, values in ((6, "THICKNESS", (1.0, 1.4, 2.0, 1.2)), (7, "BETA", (1.0, 1.4, 2.0, 1.2, 70.0))):
        rows = f.quads(part, 40 * part, 0, 0)
        f.add(f"ELEMENT_SHELL_{option}", *(line for row in rows for line in (row, values)))
    f.cards.append("*PART_COMPOSITE\nlaminate\n8,2\n2,0.4,30,,3,0.5,-65\n2,0.6,10,,4,0.3,80")
    f.add("ELEMENT_SHELL", *f.quads(8, 40 * 8, 0, 0))


def bricks(f):
    f.add("SECTION_SOLID", (11, 1))
    f.add("SECTION_SOLID", (12, -1))
    f.add("SECTION_SOLID", (13, 10))
    f.add("SECTION_SOLID", (14, 16))
    f.add("SECTION_SOLID", (15, 13))
    f.add("MAT_ELASTIC", (11, *STEEL))
    orthotropic(f, 12, 0)
    orthotropic(f, 13, 2, ((1, 0.4, 0.2), (0, 0, 0), (0.1, 1, 0.3)))
    orthotropic(f, 14, 3, ((0, 0, 0), (0.3, 1, 0.2), (0, 0, 0)))
    f.add("HOURGLASS", (11, 6, 0.5))
    for part, section, material in ((11, 11, 11), (12, 11, 12), (13, 12, 13), (14, 12, 14), (15, 13, 12), (16, 14, 13), (17, 15, 11)):
        f.cards.append(f"*PART\nblock\n{part},{section},{material},0,{11 if section == 11 else 0}")
    y = 60
    block = [f.box(40 * k, y, 0) for k in range(6)]
    f.add("ELEMENT_SOLID", (1101, 11, *block[0]), (1102, 11, *(block[1][k] for k in (0, 1, 2, 3, 4, 4, 7, 7))),
          (1103, 11, *(block[2][k] for k in (0, 1, 2, 2, 4, 5, 6, 6))), (1301, 13, *block[3]), (1401, 14, *block[4]))
    f.add("ELEMENT_SOLID", (1201, 12, *f.flat_box(240, y, 0)))
    four = [[f.node((300 + a + 30 * k, y + b, c)) for a, b, c in ((0, 0, 0), (10, 0, 0), (0, 10, 0), (0, 0, 10))] for k in range(3)]
    f.add("ELEMENT_SOLID", (1501, 15, *four[0], *[four[0][3]] * 4))
    f.add("ELEMENT_SOLID", (1701, 17, *four[2], *[four[2][3]] * 4))
    amid = [f.node([(f.nodes[four[1][a] - 1][i] + f.nodes[four[1][b] - 1][i]) / 2 for i in range(3)], 0)
            for a, b in ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))]
    f.add("ELEMENT_SOLID", (1601, 16), (*four[1], *amid))


def beams(f):
    f.add("SECTION_BEAM", (21, 1, 1.0, 2, 0), (4.0, 4.0, 3.0, 3.0, 0.5, 0.7))
    f.add("SECTION_BEAM", (22, 2), (9, 7, 12, 12))
    for part in (21, 22):
        f.cards.append(f"*PART\nbeam\n{part},{part},11")
        chain, third = [f.node((20 * k, 90 + part, 5 * k)) for k in range(4)], f.node((30, 200, 90))
        f.add("ELEMENT_BEAM", *((100 * part + k, part, a, b, third) for k, (a, b) in enumerate(zip(chain, chain[1:]))))
    a, b = f.node((0, 140, 0)), f.node((20, 145, 5))
    f.add("ELEMENT_BEAM_ORIENTATION", (2190, 21, a, b), (0.3, 0.2, 1.0))
    f.add("SECTION_DISCRETE", (23, 0, 0.2, 3000.0), ())
    f.add("MAT_SPRING_ELASTIC", (23, 500))
    f.add("DEFINE_SD_ORIENTATION", (23, 0, 0.4, 0.3, 0.8))
    f.cards.append("*PART\nspring\n23,23,23")
    f.add("ELEMENT_DISCRETE", (2301, 23, a, 1, 23, 1, 0, 0.1), (2302, 23, b, 2, 0, 1, 0, 0.1))
    f.add("ELEMENT_INERTIA", (2401, a), (0.02, 0, 0, 0.02, 0, 0.02, 0.001))


def loads(f):
    """Pressures by faces of each kind, on the shells of part 1 and the first brick, in a gas too; a bounded wall; local supports."""
    f.add("DEFINE_CURVE", (1,), (0, 20.0), (1, 20.0))
    rows = {int(row.split(",")[0]): [int(n) for n in row.split(",")[2:6]] for card in f.cards if card.startswith("*ELEMENT_SHELL\n")
            for row in card.split("\n")[1:]}
    f.add("LOAD_SEGMENT", (1, 1.0, 0, *rows[103]), (1, 1.0, 0, *rows[101]))
    f.add("SET_SEGMENT", (1,), rows[104], rows[102])
    f.add("SET_SEGMENT_GENERAL", (2,), ("SEG", *rows[403]), ("SEG", *rows[404]))
    f.add("LOAD_SEGMENT_SET", (1, 1, 2.0), (2, 1, 3.0))
    f.add("LOAD_SHELL_ELEMENT", (203, 1, 1.0))
    brick = next([int(n) for n in row.split(",")[2:10]] for card in f.cards if card.startswith("*ELEMENT_SOLID\n1101")
                 for row in card.split("\n")[1:2])
    f.add("LOAD_SEGMENT", (1, 1.0, 0, *brick[:4]))
    f.add("LOAD_SEGMENT_NONUNIFORM", (1, 0, 1.0, 0, 0, 0.3, 0.2, 0.9), rows[303], (1, 2, 3, 4))
    f.add("LOAD_BODY_VECTOR", (1, 1e5), (0.2, 0.3, 0.9))
    # The wall reaches 25 along m = n x l: of part 5, over x 200 to 220, it catches some nodes and not others.
    f.add("RIGIDWALL_PLANAR_FINITE", (0,), (190, 8, -0.8, 190, 8, 9, 0.2), (190, 100, -0.8, 40, 25))
    f.add("DEFINE_COORDINATE_VECTOR", (1, 1, 0.2, 0.1, 0, 1, 0.3))
    f.add("BOUNDARY_SPC_NODE", (rows[801][0], 1, 1, 0, 1, 0, 1, 0))
    f.add("DEFINE_VECTOR", (1, 0, 0, 0, 0.3, 1, 0.5))
    f.add("DEFINE_CURVE", (2,), (0, 3000.0), (1, 3000.0))
    f.add("BOUNDARY_PRESCRIBED_MOTION_NODE", (rows[802][1], 4, 0, 2, 1.0, 1))
    f.add("SET_PART_LIST", (1,), (1, 2, 3))
    f.add("DATABASE_CROSS_SECTION_PLANE", (1, 45.0, 0, -20, 46, 0, -20), (45.0, 100, -20, 12.0, 60.0))
    f.add("DATABASE_SECFORC", (END / 5, 2))


class MirroredFiles(CommandTest):
    def run_deck(self, name, text):
        self.nugget("run", self.write(text, f"{name}.k").name, "-o", name, "-j1", "--quiet")
        return lsda.read(self.folder / name / "binout0000")

    def refusal(self, text, deck=None):
        self.write("*KEYWORD\n" + text + "\n*END\n", "inner.k")
        return self.nugget("check", self.write(deck or master(), "outer.k").name, expect=1).stderr

    def test_every_kind_of_element(self):
        f = File()
        shells(f), bricks(f), beams(f), loads(f)
        text = f.text()
        self.write(text, "inner.k")
        plain, image = self.run_deck("plain", text), self.run_deck("image", master())
        self.assertEqual(plain["nodout/metadata/ids"], image["nodout/metadata/ids"])
        last, other = (lsda.states(found, "nodout")[-1] for found in (plain, image))
        for n in range(len(f.nodes)):
            at, turned = ([state[f"{axis}_displacement"][n] for axis in "xyz"] for state in (last, other))
            for a, b in zip(mirrored(at, False), turned):
                self.assertAlmostEqual(a, b, delta=1e-9, msg=f"node {n + 1}")
        # Nothing stood still, and the loads did something.
        self.assertGreater(min(max(abs(last[f"{axis}_displacement"][n]) for axis in "xyz") for n in range(len(f.nodes))), 1e-3)
        first, second = (lsda.states(found, "secforc")[-1] for found in (plain, image))
        force, turned = ([state[f"{axis}_force"][0] for axis in "xyz"] for state in (first, second))
        self.assertGreater(max(map(abs, force)), 1.0)
        for a, b in zip(mirrored(force, False), turned):
            self.assertAlmostEqual(a, b, delta=1e-6 * max(map(abs, force)))

    def test_scale_below_zero_is_a_mirror_too(self):
        f = File()
        shells(f)
        text = f.text()
        self.write(text, "inner.k")
        plain, image = self.run_deck("plain", text), self.run_deck("image", master(line="SCALE,1,-1,1"))
        last, other = (lsda.states(found, "nodout")[-1] for found in (plain, image))
        for axis, sign in (("x", 1), ("y", -1), ("z", 1)):
            for a, b in zip(last[f"{axis}_displacement"], other[f"{axis}_displacement"]):
                self.assertAlmostEqual(sign * a, b, delta=1e-9)

    def test_twice_mirrored_is_as_written(self):
        f = File()
        f.add("MAT_ELASTIC", (11, *STEEL))
        shells(f), beams(f)
        text = f.text()
        self.write(text, "inner.k")
        self.write(master(), "middle.k")
        plain, image = self.run_deck("plain", text), self.run_deck("image", master("middle.k").replace("\n1,\n*DEFINE", "\n2,\n*DEFINE").replace(
            "TRANSFORMATION\n1,", "TRANSFORMATION\n2,"))
        last, other = (lsda.states(found, "nodout")[-1] for found in (plain, image))
        for axis in "xyz":
            for a, b in zip(last[f"{axis}_displacement"], other[f"{axis}_displacement"]):
                self.assertAlmostEqual(a, b, delta=1e-9)

    def test_what_turns_is_refused(self):
        turning = "a sense of turning is not known in a file that \\*INCLUDE_TRANSFORM mirrors"
        mesh = "*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n"
        vector = "*DEFINE_VECTOR\n1,0,0,0,1,0,0\n*DEFINE_COORDINATE_VECTOR\n1,1,0,0,0,1,0\n*DEFINE_CURVE\n1\n0,0\n1,1\n"
        for text, field, reason in (
                ("*INITIAL_VELOCITY_NODE\n1,0,0,0,3.0\n", "vxr = 3.0", turning),
                ("*INITIAL_VELOCITY\n\n0,0,0,0,3.0\n", "vyr = 3.0", turning),
                ("*INITIAL_VELOCITY_GENERATION\n0,0,5.0,\n0,0,0,0,0,1\n", "omega = 5.0", turning),
                (vector + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,8,2,1,1.0,1\n", "dof = 8", turning),
                (vector + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,5,2,1,1.0,-1\n", "dof = 5", turning),
                (vector + "*LOAD_NODE_POINT\n1,4,1,1.0,0,2,3,4\n", "dof = 4", turning),
                (vector + "*LOAD_NODE_POINT\n1,5,1,1.0,1\n", "dof = 5", turning),
                (vector + "*ELEMENT_INERTIA\n1,1,1\n1,0.2,0,1,0,1,1\n", "csid = 1", "products of inertia in local axes are not built"),
                ("*SECTION_DISCRETE\n1,1\n\n*MAT_SPRING_ELASTIC\n1,1\n*PART\n\n1,1,1\n*ELEMENT_DISCRETE\n1,1,1,2\n", "pid = 1", turning)):
            with self.subTest(text):
                self.assertRegex(self.refusal(mesh + text), f"inner.k:[0-9:]+: error: .*{field}.*: {reason}")
        for keyword in ("CONSTRAINED_JOINT_GEARS", "CONSTRAINED_JOINT_STIFFNESS_GENERALIZED", "CONSTRAINED_GLOBAL", "NODE_TRANSFORM",
                        "BOUNDARY_PRESCRIBED_MOTION_RIGID_LOCAL", "FREQUENCY_DOMAIN_FRF", "CONSTRAINED_GENERALIZED_WELD_FILLET"):
            with self.subTest(keyword):
                self.assertRegex(self.refusal(f"{mesh}*{keyword}\n1\n"),
                                 rf"inner.k:7:1: error: \*{keyword}: is not built in a file that \*INCLUDE_TRANSFORM mirrors")

    def test_discrete_beams_are_refused(self):
        text = ("*NODE\n1,0,0,0\n2,10,0,0\n3,0,10,0\n*PART\n\n1,1,1\n*ELEMENT_BEAM\n1,1,1,2,3\n*SECTION_BEAM\n1,6\n1.0,1.0\n"
                "*MAT_LINEAR_ELASTIC_DISCRETE_BEAM\n1,1e-9,100.0\n")
        self.assertIn("beam 1 is a discrete one (ELFORM 6), which is not built in a file", self.refusal(text))

    def test_left_handed_systems_are_refused(self):
        self.write("*KEYWORD\n*END\n", "inner.k")
        self.assertRegex(self.refusal("*NODE\n1,0,0,0", master(line="MIRROR,0,0,0,1,0,0,1")), "A7 = 1 of MIRROR, left-handed")

    def test_axes_of_another_hand_are_refused(self):
        """Elements in the mirrored file, the material in the main file, and the other way round; bricks whose nodes 1 to 4 are not in a plane."""
        f = File()
        f.add("SECTION_SHELL", (1, 2, 0.8333, 3), (1.5, 1.5, 1.5, 1.5))
        f.add("SECTION_SOLID", (2, 1))
        orthotropic(f, 1, 0, beta=25.0)
        orthotropic(f, 2, 0)
        f.cards.append("*PART\nsheet\n1,1,1\n*PART\nblock\n2,2,2")
        material, f.cards = f.cards[3:], ["*KEYWORD"]
        f.add("ELEMENT_SHELL", *f.quads(1, 0, 0, 0))
        mesh = "\n".join(f.cards[1:] + ["*NODE"] + [f"{i + 1}," + ",".join(map(str, x)) for i, x in enumerate(f.nodes)])
        cards = "\n".join(material)
        self.assertRegex(self.refusal(mesh, master().replace("*END", cards)), "mirrors elements of part 1 and not its material axes")
        self.assertRegex(self.refusal(cards, master().replace("*END", mesh)), "mirrors the material axes of part 1 and not all of its elements")
        f.add("ELEMENT_SOLID", (9, 2, *f.box(0, 0, 50)))
        mesh = "\n".join(f.cards[1:] + ["*NODE"] + [f"{i + 1}," + ",".join(map(str, x)) for i, x in enumerate(f.nodes)])
        self.assertRegex(self.refusal(mesh + "\n" + cards), r"solid 9: axes by its nodes \(AOPT 0\) in a file that .* need its nodes 1 to 4 in a plane")


if __name__ == "__main__":
    unittest.main()
