# SPDX-License-Identifier: Apache-2.0
"""ncforc: forces of contacts by node, against rcforc, the motion that they make, and the faces that they press."""
import re
import unittest

import lsda
from nugget_command import CommandTest
from repeated_runs import RepeatedRuns
from welded_sheets import Sheets

SIZE, THICKNESS, END = 6.0, 1.2, 2.0e-5


def falling(sides="7,1,1", kind="AUTOMATIC_SURFACE_TO_SURFACE", ncforc="*DATABASE_NCFORC\n1.0e-6,3", more=(), end=END):
    """A sheet of 4 x 4 falls onto one of 6 x 6 below it, which begins at (-6, -6). `sides`: id of the contact, SAPR, SBPR."""
    number, print_a, print_b = sides.split(",")
    s = Sheets()
    s.cards += [f"*CONTROL_TERMINATION\n{end}", ncforc, "*DATABASE_RCFORC\n1.0e-6,3", "*DATABASE_MATSUM\n1.0e-6,2", *more]
    upper = s.sheet(THICKNESS, 0.0, 0.0, 1.25, 4, 4, SIZE)
    lower = s.sheet(THICKNESS, -6.0, -6.0, 0.0, 6, 6, SIZE)
    second = "0,3,0" if "SINGLE" in kind else f"{lower},3,3"
    s.cards.append(f"*CONTACT_{kind}_ID\n{number},the floor\n{upper},{second},0,0,{print_a},{print_b}\n0.0\n\n".replace(f"{upper},0,3,0", "0,0,5,0"))
    s.node_set(1, [n for j in range(5) for n in s.row(upper, j)])
    s.cards.append("*INITIAL_VELOCITY\n1\n2000.0,0.0,-9000.0")
    return s, upper, lower


class NodalContactForces(CommandTest):
    def run_deck(self, s, name="model", expect=0):
        self.write(s.text(), f"{name}.k")
        return self.nugget("run", f"{name}.k", "-o", name, "--quiet", expect=expect)

    def binout(self, name="model"):
        return lsda.read(self.folder / name / "binout0000")

    def test_nodes_of_a_side_add_up_to_rcforc(self):
        """Each side lists its own nodes, the sums are those of rcforc, and what the upper side gets in all is its change of momentum. Sabotage: forces of
        the cycle before; one side for both."""
        s, upper, lower = falling()
        self.run_deck(s)
        found = self.binout()
        self.assertEqual(found["ncforc/slave_000007/metadata/ids"], list(range(1, 26)))
        self.assertEqual(found["ncforc/master_000007/metadata/ids"], list(range(26, 75)))
        self.assertEqual(found["ncforc/slave_000007/metadata/legend"].strip(), "the floor")
        states = {side: lsda.states(found, f"ncforc/{side}_000007") for side in ("slave", "master")}
        sums = lsda.states(found, "rcforc")
        self.assertEqual(len(states["slave"]), len(sums))
        largest = max(abs(f) for r in sums for f in r["z_force"])
        self.assertGreater(largest, 100.0)
        for place, side in enumerate(("slave", "master")):
            for state, total in zip(states[side], sums):
                self.assertEqual(state["time"], total["time"])
                for axis in "xyz":
                    self.assertAlmostEqual(sum(state[f"{axis}_force"]), total[f"{axis}_force"][place], delta=1e-9 * largest)
        motion = lsda.states(found, "matsum")
        place = found["matsum/metadata/ids"].index(upper)
        times = [r["time"][0] for r in sums]
        forces = [sum(r["z_force"]) for r in states["slave"]]
        impulse = sum(0.5 * (a + b) * (t - u) for a, b, u, t in zip(forces, forces[1:], times, times[1:]))
        change = motion[-1]["z_momentum"][place] - motion[0]["z_momentum"][place]
        self.assertAlmostEqual(impulse / change, 1.0, delta=0.05)

    def test_pressure_is_force_over_the_share_of_the_faces(self):
        """Flat sheets, hardly bent: an inner node has the area of one face, one at an edge half of it, at a corner a quarter. Sabotage: the whole of each
        face at a node."""
        s, _, _ = falling(end=8.0e-6)
        self.run_deck(s)
        last = lsda.states(self.binout(), "ncforc/slave_000007")[-1]
        pressed = 0
        for node in range(25):
            column, row = node % 5, node // 5
            share = (0.5 if column in (0, 4) else 1.0) * (0.5 if row in (0, 4) else 1.0)
            force = abs(last["z_force"][node])
            pressed += force > 1.0
            self.assertAlmostEqual(last["pressure"][node] * share * SIZE**2, force, delta=2e-3 * force + 1e-9)
        self.assertEqual(pressed, 25)
        self.assertAlmostEqual(last["x"][12], 12.0 + 2000.0 * 8.0e-6, delta=0.01)
        self.assertAlmostEqual(last["z"][12], 1.25 - 9000.0 * 8.0e-6, delta=0.02)

    def test_the_text_says_the_same(self):
        s, _, _ = falling("7,1,0")
        self.run_deck(s)
        text, found = self.read("model/ncforc"), self.binout()
        self.assertNotIn("ncforc/master_000007/metadata/ids", found)
        self.assertNotIn("master side", text)
        self.assertRegex(text, r"        7     the floor")
        blocks = re.findall(r"forces \(t=(\S+)\) for interface         7 slave  side\n\n.*\n.*\n((?:.+\n)+)", text)
        states = lsda.states(found, "ncforc/slave_000007")
        self.assertEqual(len(blocks), len(states))
        for (time, lines), state in zip(blocks, states):
            self.assertAlmostEqual(float(time), state["time"][0], delta=1e-5 * END)
            rows = [[float(v) for v in line.split()] for line in lines.splitlines()]
            self.assertEqual([int(r[0]) for r in rows[::2]], list(range(1, 26)))
            for node, (forces, place) in enumerate(zip(rows[::2], rows[1::2])):
                for value, name in zip(forces[1:] + place, ("x_force", "y_force", "z_force", "pressure", "x", "y", "z")):
                    self.assertAlmostEqual(value, state[name][node], delta=1e-5 * abs(state[name][node]) + 1e-12)

    def test_plot_and_table_have_it(self):
        """From text or binout. Sabotage: files whose branches depend on the model are not read."""
        for kind in (1, 2):
            with self.subTest(kind):
                self.run_deck(falling(ncforc=f"*DATABASE_NCFORC\n1.0e-6,{kind}")[0])
                self.nugget("convert", "model", "--to", "csv")
                rows = [line for line in self.read("model/histories.csv").splitlines() if line.startswith("ncforc,contact 7 reference side node 50,")]
                self.assertEqual({row.split(",")[2] for row in rows}, {"the floor"})
                self.assertEqual({row.split(",")[3] for row in rows}, {"x_force", "y_force", "z_force", "pressure", "x", "y", "z"})
                self.nugget("plot", "model", "ncforc/contact 7 tracked side node 13/z_force", "-o", "force.svg")
                self.assertIn("</svg>", self.read("force.svg"))

    def test_transducers_and_single_surfaces(self):
        """A transducer has the nodes of its surface and what all contacts put on them; a surface in contact with itself all nodes, whose forces
        balance. Sabotage: a transducer that sees no contact."""
        s, upper, lower = falling("7,0,1", "AUTOMATIC_SINGLE_SURFACE",
                                  more=(f"*CONTACT_FORCE_TRANSDUCER_PENALTY_ID\n9,of the sheet\n1,,3,,,,1\n\n\n",))
        self.run_deck(s)
        found = self.binout()
        self.assertEqual(found["ncforc/slave_000009/metadata/ids"], list(range(1, 26)))
        self.assertEqual(found["ncforc/slave_000007/metadata/ids"], list(range(1, 75)))
        sums = lsda.states(found, "rcforc")
        place = [i for i, n in enumerate(found["rcforc/metadata/ids"]) if n == 9][0]
        largest = max(abs(r["z_force"][place]) for r in sums)
        self.assertGreater(largest, 100.0)
        for of_all, of_sheet, total in zip(lsda.states(found, "ncforc/slave_000007"), lsda.states(found, "ncforc/slave_000009"), sums):
            self.assertAlmostEqual(sum(of_sheet["z_force"]), total["z_force"][place], delta=1e-9 * largest)
            self.assertEqual(of_sheet["z_force"], of_all["z_force"][:25])
            self.assertAlmostEqual(sum(of_all["z_force"]), 0.0, delta=1e-9 * largest)

    def test_what_is_not_there_is_said(self):
        s, _, _ = falling("7,0,0")
        run = self.run_deck(s, "none")
        self.assertIn("no contact asks for its forces by node", run.stderr)
        self.assertNotIn("ncforc", self.files("none"))
        s, upper, lower = falling("7,1,1")
        s.cards.append(f"*CONTACT_FORCE_TRANSDUCER_ID\n9\n{upper},{lower},3,3,,,1\n\n\n")
        run = self.run_deck(s, "two")
        self.assertIn("ncforc lacks contact 9", run.stderr)
        self.assertFalse(any(name.startswith("ncforc/slave_000009") for name in self.binout("two")))
        self.assertIn("slave_ID, master_ID", self.nugget("keywords", "DATABASE_NCFORC").stdout)


class RepeatedNodalForces(RepeatedRuns):
    def test_any_number_of_threads(self):
        self.compare(self.write(falling()[0].text()))

    def test_resumed(self):
        self.resumed(falling()[0].text(), shares=(0.5,))


if __name__ == "__main__":
    unittest.main()
