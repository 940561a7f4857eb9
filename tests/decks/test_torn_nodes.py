# SPDX-License-Identifier: Apache-2.0
"""Nodes that are tied until the mesh tears (*CONSTRAINED_TIED_NODES_FAILURE): as one mesh until then, torn where closed forms say."""
import math
import re
import subprocess
import unittest

from few_elements import CORNERS, card, curve, nodes
from repeated_runs import RepeatedRuns
from under_mpirun import ENVIRONMENT, MPIRUN, mpirun

E, NU, DENSITY, YIELD, HARDENING, RAMP = 70000.0, 0.3, 2.7e-9, 100.0, 350.0, 5e-4


def metal(number, first=YIELD):
    """True stress `first` + HARDENING times the plastic strain."""
    tangent = E * HARDENING / (E + HARDENING)
    return "*MAT_PIECEWISE_LINEAR_PLASTICITY\n" + card(number, DENSITY, E, NU, first, f"{tangent:.6f}") + card(0.0) + card(0.0) + card(0.0)


class Mesh:
    """Columns of shells, or bricks, along x, `lengths` long, in `rows` along y. Nodes of the lines in `cuts` (1: after the first column) stand there
    once for each side; `exploded`: each element has nodes of its own throughout. `shared`: no node stands anywhere twice; the answer."""

    def __init__(self, lengths, cuts=(), rows=1, width=4.0, materials=None, solid=False, exploded=False, shared=False):
        self.materials = materials or [1] * len(lengths)
        self.solid, self.places, self.elements, known, at = solid, [], [], {}, [0.0]
        for length in lengths:
            at.append(at[-1] + length)
        for k in range(len(lengths)):
            for j in range(rows):
                def node(i, m, h):
                    side = sum(1 for c in cuts if c <= k) if i in cuts else 0
                    key = (i, m, h) if shared else (i, m, h, k, j) if exploded else (i, m, h, side)
                    if key not in known:
                        self.places.append((at[i], width * m, width * h))
                        known[key] = len(self.places)
                    return known[key]
                self.elements.append((k, [node(k + a, j + b, c) for a, b, c in CORNERS[:8 if solid else 4]]))
        self.length, self.width = at[-1], width * rows

    def where(self, **place):
        return [n for n, p in enumerate(self.places, 1) if all(abs(p["xyz".index(a)] - value) < 1e-6 for a, value in place.items())]

    def groups(self):
        at = {}
        for n, p in enumerate(self.places, 1):
            at.setdefault(p, []).append(n)
        return [group for group in at.values() if len(group) > 1]

    def text(self, end, *more, eppf=None, one_set=False, states=40):
        end, eppf = float(f"{end:.4e}"), eppf and round(eppf, 6)
        text = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(end) + "*CONTROL_ENERGY\n" + card(2, 2, 2, 2)
        text += "".join(f"*DATABASE_{name}\n" + card(f"{end / states:.3e}", 3) for name in ("GLSTAT", "NODOUT", "SPCFORC", "ELOUT"))
        text += "*DATABASE_BINARY_D3PLOT\n" + card(f"{end / 4:.3e}") + metal(1) + metal(2, 1000.0)
        text += "*SECTION_SOLID\n" + card(1, 1) if self.solid else "*SECTION_SHELL\n" + card(1, 2, 0.833333, 3) + card(1.0, 1.0, 1.0, 1.0)
        for part, material in enumerate(self.materials, 1):
            text += "*PART\npart\n" + card(part, 1, material)
        text += nodes(self.places)
        if self.solid:
            text += "*ELEMENT_SOLID\n" + "".join(f"{e:8}{k + 1:8}\n" + "".join(f"{n:8}" for n in q) + "\n" for e, (k, q) in enumerate(self.elements, 1))
        else:
            text += "*ELEMENT_SHELL\n" + "".join(f"{e:8}{k + 1:8}" + "".join(f"{n:8}" for n in q) + "\n" for e, (k, q) in enumerate(self.elements, 1))
        kind = 1 if self.solid else 0
        if eppf is not None and one_set:
            text += "*SET_NODE_GENERAL\n" + card(99) + card("ALL") + "*CONSTRAINED_TIED_NODES_FAILURE\n" + card(99, eppf, kind)
        elif eppf is not None:
            cards = ""
            for k, group in enumerate(self.groups(), 100):
                text += "*SET_NODE_LIST\n" + card(k) + card(*group)
                cards += card(k, eppf, kind)
            text += "*CONSTRAINED_TIED_NODES_FAILURE\n" + cards
        return text + "".join(more) + "*END\n"

    def pulled(self, speed, plane_strain=False):
        """The left end is held along x, the right one pulled at a speed that it comes to over RAMP; free to become narrower, or, in plane strain, not."""
        left, right = set(self.where(x=0.0)), set(self.where(x=self.length))
        bottom, base = set(self.where(y=0.0)), set(self.where(z=0.0))
        text = "*BOUNDARY_SPC_NODE\n"
        for n in range(1, len(self.places) + 1):
            held = (n in left, plane_strain or n in bottom, n in base)
            text += card(n, 0, *map(int, held), 1, 1, 1)
        text += curve(1, (0.0, 0.0), (RAMP, 1.0), (1.0, 1.0)) + "*SET_NODE_LIST\n" + card(1)
        right = sorted(right)
        text += "".join(card(*right[i:i + 8]) for i in range(0, len(right), 8))
        return text + "*BOUNDARY_PRESCRIBED_MOTION_SET\n" + card(1, 1, 0, 1, speed)


def torn(log):
    """[(time, free nodes, how many stay tied, mean)] of run.log."""
    found = re.findall(r"tied nodes torn  set= *\d+ time= *(\S+) cycle=\d+ free:((?: \d+)+)(?:, (\d+) stay tied)?, mean (\S+)", log)
    return [(float(time), tuple(map(int, free.split())), int(stay or 0), float(mean)) for time, free, stay, mean in found]


def way(time, speed):
    return speed * (time - 0.5 * RAMP)


class TornNodes(RepeatedRuns):
    def tear(self, text, *options):
        self.write(text)
        self.nugget("run", "model.k", "--quiet", "-j", 1, *options)
        return torn(self.read("run.log"))

    def last(self, node):
        """Displacement and velocity of a node in the last state of nodout."""
        lines = [line for line in self.read("nodout").splitlines() if line[:10].strip() == str(node) and len(line) > 120]
        return [float(lines[-1][10 + 12 * i:22 + 12 * i]) for i in range(6)]

    def test_a_strip_tears_at_its_elongation(self):
        """Uniaxial tension: at a plastic strain p the true stress is s = YIELD + HARDENING p and the length L exp(s / E + p). Shells and bricks. Then
        the part at the pulled end goes on with its speed, and nothing holds it. Sabotage: the strain at the seam of the surfaces or the largest point
        only; nodes that are not released; a release that changes velocities."""
        for solid in (False, True):
            with self.subTest(solid=solid):
                mesh, speed, p = Mesh((10.0, 10.0), cuts=(1,), width=10.0, solid=solid), 500.0, 0.1
                wanted = 20.0 * (math.exp((YIELD + HARDENING * p) / E + p) - 1.0)
                end = wanted / speed + 0.5 * RAMP + 5e-4
                found = self.tear(mesh.text(end, mesh.pulled(speed), "*DATABASE_HISTORY_NODE\n" + card(*mesh.where(x=10.0)), eppf=p))
                self.assertEqual(len(found), 4 if solid else 2)
                for time, free, stay, mean in found:
                    self.assertAlmostEqual(way(time, speed) / wanted, 1.0, delta=0.001)
                    self.assertEqual((len(free), stay), (2, 0))
                    self.assertAlmostEqual(mean, p, delta=2e-4)
                left, right = mesh.groups()[0]
                self.assertGreater(self.last(right)[0] - self.last(left)[0], 0.5 * speed * 5e-4)
                states = self.glstat()
                self.assertAlmostEqual(states[-1]["total energy"] / states[-1]["external work"], 1.0, delta=1e-3)

    def test_the_mean_is_by_volume(self):
        """A strong piece 5 long, which stays elastic, and a weak one three times as long, in plane strain: the force is the same, so at the mean plastic
        strain 0.075 the weak one has 0.1, where the stress is 2/sqrt(3) (YIELD + HARDENING 0.1), its strain sqrt(3)/2 0.1 and what is elastic.
        Sabotage: a mean of the elements alone (0.15), or the largest of them (0.075)."""
        mesh, speed, p = Mesh((5.0, 15.0), cuts=(1,), width=5.0, materials=[2, 1]), 500.0, 0.1
        stress, elastic = 2.0 / math.sqrt(3.0) * (YIELD + HARDENING * p), (1.0 - NU * NU) / E
        wanted = 15.0 * (math.exp(0.5 * math.sqrt(3.0) * p + elastic * stress) - 1.0) + 5.0 * (math.exp(elastic * stress) - 1.0)
        found = self.tear(mesh.text(wanted / speed + RAMP, mesh.pulled(speed, plane_strain=True), eppf=0.75 * p))
        self.assertEqual(len(found), 2)
        for time, _, _, mean in found:
            self.assertAlmostEqual(way(time, speed) / wanted, 1.0, delta=0.002)
            self.assertAlmostEqual(mean, 0.075, delta=2e-4)

    def test_only_elements_beyond_the_strain_let_go(self):
        """Two by two shells, each with nodes of its own, the right ones weak: in the middle the two weak ones let go, the strong ones stay tied.
        Sabotage: all nodes of a place are free at once."""
        mesh, speed = Mesh((10.0, 10.0), rows=2, width=5.0, materials=[2, 1], exploded=True), 500.0
        found = self.tear(mesh.text(4e-3, mesh.pulled(speed, plane_strain=True), eppf=0.05, one_set=True))
        middle = [g for g in mesh.groups() if len(g) == 4][0]
        of_middle = [f for f in found if set(f[1]) <= set(middle)]
        self.assertEqual([(len(free), stay) for _, free, stay, _ in of_middle], [(2, 2)])
        weak = {n for k, q in mesh.elements if k == 1 for n in q}
        self.assertLessEqual(set(of_middle[0][1]), weak)

    def test_until_then_it_is_one_mesh(self):
        """Forces and motions of shells that have nodes of their own each are those of the mesh with common nodes, in a run with contact of the sheet
        with itself, and so are its modes and its statics. Sabotage: contact presses a node off the shells it is tied to; masses that stay at their nodes."""
        ends = []
        contact = "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n" + card(0) + card(0.1) + card("")
        for exploded in (False, True):
            mesh = Mesh((4.0,) * 5, rows=3, exploded=exploded)
            corner = mesh.where(x=mesh.length, y=mesh.width)[0]
            kick = "*SET_NODE_LIST\n" + card(7) + card(*mesh.where(x=8.0, y=4.0)) + "*INITIAL_VELOCITY\n" + card(7) + card(0.0, 0.0, 50000.0)
            self.tear(mesh.text(4e-4, mesh.pulled(2000.0), contact, kick, "*DATABASE_HISTORY_NODE\n" + card(corner), eppf=0.9 if exploded else None, one_set=True))
            states = self.glstat()
            self.assertGreater(states[-1]["internal energy"], 100.0)
            ends.append([*self.last(corner), *(states[-1][name] for name in ("kinetic energy", "internal energy", "external work"))])
            self.assertEqual(states[-1]["sliding interface energy"], 0.0)
            self.assertNotIn("penetrat", self.read("findings.json"))
        for one, other in zip(*ends):
            self.assertAlmostEqual(one, other, delta=2e-5 * max(1.0, abs(one)))

    def test_modes_and_statics_are_those_of_one_mesh(self):
        hz, sag = [], []
        for exploded in (False, True):
            mesh = Mesh((4.0,) * 5, rows=3, exploded=exploded)
            left, tip = mesh.where(x=0.0), mesh.where(x=mesh.length, y=mesh.width)
            held = "*BOUNDARY_SPC_NODE\n" + "".join(card(n, 0, 1, 1, 1, 1, 1, 1) for n in left)
            tied = mesh.text(1e-3, held, eppf=0.1 if exploded else None, one_set=True)
            self.write(tied)
            self.nugget("modes", "model.k", "-n", 6, "--quiet")
            hz.append([mode["frequency_hz"] for mode in self.json("summary.json")["modes"]])
            load = curve(3, (0.0, 1.0), (1.0, 1.0)) + "*LOAD_NODE_POINT\n" + card(tip[-1], 3, 3, 0.5)
            self.write(tied.replace("*END", "*CONTROL_IMPLICIT_GENERAL\n" + card(1, 1e-3) + "*CONTROL_IMPLICIT_SOLUTION\n" + card(1) +
                                    "*DATABASE_HISTORY_NODE\n" + card(tip[0]) + load + "*END"))
            self.nugget("run", "model.k", "--quiet")
            sag.append(self.last(tip[0])[2])
        for one, other in zip(*hz):
            self.assertAlmostEqual(other / one, 1.0, delta=1e-8)
        self.assertGreater(abs(sag[0]), 1e-4)
        self.assertAlmostEqual(sag[1] / sag[0], 1.0, delta=1e-5)

    def test_damage_of_gissmo_counts_in_place_of_the_strain(self):
        """D = p / 0.4 (DMGEXP 1), EPPF 0.3: it tears at a plastic strain of 0.12."""
        mesh, speed, p = Mesh((10.0, 10.0), cuts=(1,), width=10.0), 500.0, 0.12
        gissmo = "*MAT_ADD_DAMAGE_GISSMO\n" + card(1, "", 1) + card(11, 0.9, 1.0, "", 1.0) + card("") + curve(11, (0, 0.4), (1, 0.4))
        wanted = 20.0 * (math.exp((YIELD + HARDENING * p) / E + p) - 1.0)
        found = self.tear(mesh.text(wanted / speed + RAMP, mesh.pulled(speed), gissmo, eppf=0.3))
        self.assertEqual(len(found), 2)
        for time, *_ in found:
            self.assertAlmostEqual(way(time, speed) / wanted, 1.0, delta=0.002)

    def ripped(self):
        """A sheet that may tear anywhere, and does along some of its edges while it is pulled fast."""
        mesh = Mesh((4.0, 4.0, 3.0, 4.0, 4.0), rows=6, exploded=True)
        contact = "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n" + card(0) + card(0.1) + card("")
        return mesh.text(8e-4, mesh.pulled(8000.0), contact, "*DATABASE_HISTORY_NODE\n" + card(1, 40, 80, 100), eppf=0.12, one_set=True)

    def test_same_bits_and_restart(self):
        """While the sheet tears, with any number of threads and lanes, and cut short and gone on with."""
        self.write(self.ripped())
        self.compare("model.k")
        log = self.read("t1/run.log")
        self.assertGreater(len(torn(log)), 5)
        self.resumed(self.ripped(), shares=(0.3, 0.7))

    @unittest.skipUnless(MPIRUN, "mpirun is not installed")
    def test_same_bits_over_ranks(self):
        self.write(self.ripped())
        self.nugget("run", "model.k", "-o", "one", "-j", 1, "--quiet")
        run = subprocess.run(mpirun(3, "run", "model.k", "-o", "three", "-j", 1, "--quiet"), capture_output=True, text=True, timeout=200,
                             cwd=self.folder, env=ENVIRONMENT)
        self.assertEqual(run.returncode, 0, run.stderr + run.stdout)
        self.assertEqual(torn(self.read("one/run.log")), torn(self.read("three/run.log")))
        self.assertEqual(self.bits("one"), self.bits("three"))

    def test_what_is_not_built_is_named(self):
        mesh = Mesh((10.0, 10.0), cuts=(1,), width=10.0)
        pair = mesh.groups()[0]
        good = mesh.text(1e-3, mesh.pulled(100.0), eppf=0.1)
        tie = "*CONSTRAINED_TIED_NODES_FAILURE\n"
        for change, words in ((lambda t: t.replace(card(100, 0.1, 0), card(100, 0.0, 0)), "eppf"),
                              (lambda t: t.replace(card(100, 0.1, 0), card(100, 0.1, 1)), "no solid has node"),
                              (lambda t: t.replace(card(100, 0.1, 0), card(100, 0.1, 2)), "etype"),
                              (lambda t: t.replace(tie, tie + card(100, 0.1, 0)), "is in two sets of tied nodes"),
                              (lambda t: t.replace(tie, "*SET_NODE_LIST\n" + card(98) + card(1, pair[0]) + tie + card(98, 0.1)), "no two nodes of set 98"),
                              (lambda t: t.replace("*END", "*BOUNDARY_SPC_NODE\n" + card(pair[0], 0, 1) + "*END"), "are not held or driven alike")):
            text = change(good)
            self.assertNotEqual(text, good)
            with self.subTest(words):
                self.write(text)
                run = self.nugget("run", "model.k", "--quiet", expect=1)
                self.assertIn(words, run.stderr)
                self.assertIn("TIED_NODES_FAILURE", run.stderr)
        self.write(mesh.text(1e-3, "*SET_NODE_LIST\n" + card(97) + card(pair[0], 1, 4) + "*CONSTRAINED_NODAL_RIGID_BODY\n" + card(97, 0, 97), eppf=0.1))
        self.assertIn("is made dependent twice", self.nugget("run", "model.k", "--quiet", expect=1).stderr)


if __name__ == "__main__":
    unittest.main()
