# SPDX-License-Identifier: Apache-2.0
"""Tetrahedra of ten nodes through the commands: a cantilever in modes, frequency response, statics and impact, its files,
and the same made of four-node tetrahedra by *ELEMENT_SOLID_TET4TOTET10."""
import unittest

from nugget_command import CommandTest

PIECES = ((0, 1, 3, 7), (0, 3, 2, 7), (0, 2, 6, 7), (0, 6, 4, 7), (0, 4, 5, 7), (0, 5, 1, 7))
EDGES = ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))
CUBES = 4
SIDE = 10.0


def row(*values, width=10):
    return "".join(f"{v:>{width}}" if not isinstance(v, float) else f"{v:{width}.6g}" for v in values)


class TenNodes(CommandTest):
    def mesh(self):
        """Corners, four-node tetrahedra and nodes amid edges, in the order in which edges first appear."""
        place = {}
        for k in (0, 1):
            for j in (0, 1):
                for i in range(CUBES + 1):
                    place[len(place) + 1] = (SIDE * i, SIDE * j, SIDE * k)
        corner = {x: n for n, x in place.items()}
        tetrahedra = [[corner[SIDE * (i + (b & 1)), SIDE * (b >> 1 & 1), SIDE * (b >> 2)] for b in piece]
                      for i in range(CUBES) for piece in PIECES]
        amid = {}
        for four in tetrahedra:
            for i, j in EDGES:
                edge = tuple(sorted((four[i], four[j])))
                if edge not in amid:
                    amid[edge] = len(place) + 1
                    place[amid[edge]] = tuple(0.5 * (a + b) for a, b in zip(place[edge[0]], place[edge[1]]))
        return place, tetrahedra, amid

    def deck(self, control, made=False, elform=16):
        place, tetrahedra, amid = self.mesh()
        lines = ["*KEYWORD", *control, "*MAT_ELASTIC", row(1, 7.85e-9, 210000.0, 0.3), "*SECTION_SOLID", row(1, elform),
                 "*PART", "bar", row(1, 1, 1), "*NODE"]
        corners = {n for four in tetrahedra for n in four}
        lines += [f"{n:8d}" + row(*x, width=16) for n, x in place.items() if not made or n in corners]
        lines.append("*ELEMENT_SOLID_TET4TOTET10" if made else "*ELEMENT_SOLID")
        for e, four in enumerate(tetrahedra, 1):
            nodes = four if made else four + [amid[tuple(sorted((four[i], four[j])))] for i, j in EDGES]
            lines += [row(e, 1, width=8), row(*nodes, width=8)]
        # The clamp is chosen by place, so that it has the nodes amid edges too.
        lines += ["*DEFINE_BOX", row(1, -1.0, 1.0, -1.0, 11.0, -1.0, 11.0), "*BOUNDARY_SPC_SET", row(1, 0, 1, 1, 1),
                  "*SET_NODE_GENERAL", row(1), row("BOX", 1), "*END"]
        return "\n".join(lines) + "\n"

    def frequencies(self):
        return [float(line.split()[3]) for line in self.read("eigout").splitlines()
                if line.split()[:1] and line.split()[0].isdigit() and len(line.split()) == 5]

    MODES = ("*CONTROL_IMPLICIT_GENERAL", row(1, 1.0), "*CONTROL_IMPLICIT_EIGENVALUE", row(4))

    def test_modes_and_their_file(self):
        """A square bar bends alike in both directions; d3eigv has corners only, which every reader knows."""
        self.write(self.deck(self.MODES))
        self.nugget("modes", "model.k")
        given = self.frequencies()
        self.assertEqual(len(given), 4)
        self.assertAlmostEqual(given[1] / given[0], 1.0, delta=0.01)
        self.write(self.deck(self.MODES, made=True))
        run = self.nugget("modes", "model.k")
        self.assertEqual(self.frequencies(), given)
        self.assertIn("nodes are made amid edges, 21 to ", run.stderr)
        self.assertIn("sets that list nodes do not have them", run.stderr)

    def test_impact_and_its_file(self):
        """A bar that hits a wall bounces; VTK sees four-node tetrahedra that move."""
        control = ["*CONTROL_TERMINATION", row(2.0e-5), "*DATABASE_BINARY_D3PLOT", row(1.0e-5), "*DATABASE_GLSTAT",
                   row(1.0e-6), "*INITIAL_VELOCITY_GENERATION", row(1, 2, 0.0, 0.0, 0.0, -5000.0), "",
                   "*DATABASE_ELOUT", row(1.0e-5), "*DATABASE_HISTORY_SOLID", row(1), "*RIGIDWALL_PLANAR", row(0),
                   row(0.0, 0.0, -0.01, 0.0, 0.0, 1.0)]
        text = self.deck(control).replace("*BOUNDARY_SPC_SET\n" + row(1, 0, 1, 1, 1) + "\n", "")
        self.write(text)
        self.nugget("run", "model.k", "--quiet")
        states = self.glstat()
        self.assertGreater(states[-1]["internal energy"], 0.0)
        for state in states:
            self.assertAlmostEqual(state["total energy / initial energy"], 1.0, delta=0.02)
        seen = self.d3plot()
        self.assertEqual(seen["solids"], 6 * CUBES)
        self.assertGreater(len(seen["states"]), 1)

    def test_what_is_computed_otherwise_is_said(self):
        said = {17: "solid formulation 17, a tetrahedron composed of smaller ones"}
        for elform, text in said.items():
            self.write(self.deck([*self.MODES, "*CONTROL_SOLID", row(0, 0, 5), "*CONTROL_OUTPUT", row(0), row(0, 0, 1)],
                                 elform=elform))
            run = self.nugget("modes", "model.k")
            self.assertIn(text, run.stderr)
            self.assertIn("tetrahedra of ten nodes have four points here", run.stderr)
            self.assertIn("d3plot has the corners of tetrahedra of ten nodes", run.stderr)
        self.write(self.deck(self.MODES, elform=10))
        run = self.nugget("modes", "model.k", expect=1)
        self.assertIn("solid 1 has 10 nodes, which formulation 10 does not", run.stderr)


if __name__ == "__main__":
    unittest.main()
