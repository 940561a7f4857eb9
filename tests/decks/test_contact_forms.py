# SPDX-License-Identifier: Apache-2.0
"""Fields of sliding contacts, each by what it does to two small plates: friction by part, boxes, PENMAX, eroding bricks,
edges; sleout; and what is refused."""
import math
import re
import resource
import unittest

import lsda
from contact_models import BAR_PARTS, BARS, LOWER, UPPER, ContactTest, plate, plates, sliding


class ContactForms(ContactTest):
    def test_stiffness_for_a_given_step(self):
        """SOFT = 1 with DTSTIF: twice the step, a quarter of the stiffness. Sabotage: DTSTIF not looked at."""
        def pressed(step):
            def cards(d):
                sliding(sfs=1e-4)(d)
                d.card(soft=1, sofscl=0.5)
                d.card(penmax=0.0)
                d.card(igap=1, ignore=0, dprfac=0.0, dtstif=step)
            self.run_deck(plates(cards, {3: -20.0}, 1.0e-5))
            return self.rows()[-1][3]
        self.assertAlmostEqual(pressed(1e-6) / pressed(2e-6), 4.0, delta=0.05)
        self.write(self.read("model.k").replace("     2e-06", "    -2e-06"))
        self.assertIn("dtstif", self.nugget("check", "model.k", expect=1).stderr)

    def test_soft_bricks_that_are_squeezed_push_back(self):
        """*CONTACT_INTERIOR stands in sleout under its id, with what glstat counts; attributes out of range are refused.
        Sabotage: an energy left out of one of the two."""
        def block(psf, fa):
            def cards(d):
                d.keyword("PART")
                d.text("foam")
                d.card(pid=3, secid=3, mid=3)
                d.keyword("SECTION_SOLID")
                d.card(secid=3, elform=1)
                d.keyword("MAT_ELASTIC")
                d.card(mid=3, ro=1e-9, e=1.0, pr=0.0)
                ids = range(1001, 1009)
                d.nodes(dict(zip(ids, [(5.0 * i, 5.0 * j, 10.0 + 2.0 * k) for k in (0, 1) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))])))
                d.keyword("ELEMENT_SOLID")
                d.text(f"{1001:8d}{3:8d}" + "".join(f"{n:8d}" for n in ids))
                d.node_set(2, list(ids)[:4])
                d.keyword("BOUNDARY_SPC_SET")
                d.card(nsid=2, cid=0, dofx=1, dofy=1, dofz=1)
                d.node_set(3, list(ids)[4:])
                d.keyword("BOUNDARY_PRESCRIBED_MOTION_SET")
                d.card(nsid=3, dof=3, vad=2, lcid=77)
                d.curve(77, [(0.0, 0.0), (1.0e-3, -1.8), (1.0, -1.8)])
                d.keyword("SET_PART_LIST")
                d.card(sid=9, da1=psf, da2=fa, da3=100.0)
                d.ids([3])
                d.keyword("CONTACT_INTERIOR_ID")
                d.text(f"{7:10d}foam that is squeezed")
                d.card(psid=9)
            return cards
        self.write(plates(sliding(), {3: 0.0}, 1.0e-3, extra=block(1.0, 0.3)))
        self.nugget("run", "model.k", "--quiet", "-j", 1)
        energy = self.json("summary.json")["energy"]
        self.assertGreater(energy["contact"], 0.0)
        self.assertLess(abs(energy["ratio"] - 1.0), 1.0e-3)
        last = [line.split() for line in self.read("sleout").splitlines() if line.split()[:1] == ["7"]][-1]
        self.assertAlmostEqual(float(last[1]) / energy["contact"], 1.0, delta=1.0e-5)
        self.assertIn("foam that is squeezed", self.read("sleout"))
        self.assertRegex(self.read("run.log"), r"\*CONTACT_INTERIOR_ID +1 used")

        self.write(plates(sliding(), {3: 0.0}, 1.0e-3, extra=block(1.0, 1.5)))
        self.assertIn("Fa below 1", self.nugget("check", "model.k", expect=1).stderr)

    def test_what_is_refused_beside_contacts(self):
        def all_cards(more=0, cparm8=0, shloff=0):
            def write(d):
                sliding()(d)
                for _ in "ABCD":
                    d.card(soft=None)
                d.card(sharec=0, cparm8=cparm8)
                d.card(pstiff=0)
                d.card(unused=None, shloff=shloff)
                for _ in range(more):
                    d.card(soft=0)
            return plates(write, {3: -20.0}, 1.0e-5)
        self.write(all_cards())
        self.assertNotIn("warning", self.nugget("check", "model.k").stderr)
        self.write(all_cards(cparm8=2, shloff=1))
        told = self.nugget("check", "model.k").stderr
        self.assertRegex(told, "warning: .* cparm8 = 2: has an effect in _GENERAL alone")
        self.assertRegex(told, "warning: .* shloff = 1: not obeyed")
        self.write(plates(lambda d: (sliding()(d), sliding("AUTOMATIC_SURFACE_TO_SURFACE_ID\n         1twin")(d)), {3: -20.0}, 1.0e-5))
        self.assertRegex(self.nugget("check", "model.k").stderr, r"warning: .* contact 1 has the number of the one at model.k:\d+")
        self.write(all_cards(more=1))
        self.assertIn("more data lines than this keyword has cards", self.nugget("check", "model.k", expect=1).stderr)

    def test_friction_of_the_parts(self):
        """FS = -1: the mean of both parts', 0.1 and 0.3, so what FS = 0.2 gives. Sabotage: of one part alone."""
        cards = ({"fs": 0.1, "fd": 0.1, "dc": 0.0, "vc": 0.0, "optt": 0.0, "sft": 1.0, "ssf": 1.0},)
        motion = {3: -20.0, 1: 200.0}
        text = plates(sliding(fs=-1.0), motion, 1.0e-4, parts="PART_CONTACT", options=cards)
        first, second = text.index("       0.1       0.1"), text.rindex("       0.1       0.1")
        self.assertNotEqual(first, second)
        self.run_deck(text[:second] + "       0.3       0.3" + text[second + 20:])
        of_parts = self.rows()
        self.assertGreater(-of_parts[-1][1], 0.1 * of_parts[-1][3])
        self.run_deck(plates(sliding(fs=0.2), motion, 1.0e-4))
        self.assertEqual(of_parts, self.rows())

    def test_friction_between_pairs_of_parts(self):
        """FS = -2: of the pair, in whatever order it stands, else the default; the table that FD names, or the first. The same bits as FS
        itself. Sabotage: the default for all; the first part alone counts."""
        motion = {3: -20.0, 1: 200.0}
        self.run_deck(plates(sliding(fs=0.2), motion, 1.0e-4))
        expected = self.rows()
        self.assertLess(expected[-1][1], -0.15 * expected[-1][3])

        def tables(*lines, number=0):
            def write(d):
                d.text("*SET_PART_LIST\n8\n1")
                for line in lines:
                    d.text(line)
                sliding(fs=0.2)(d)
                at = d.lines.index("       0.2       0.2")
                d.lines[at] = f"{-2.0:10}{number:10}"
            return write
        pair, other = "2,8,0.2,0.2,0.0,0.0,PART,PSET", "2,2,0.9,0.9"
        for name, card in {"pair": tables("*DEFINE_FRICTION", "5,0.6,0.6", other, pair),
                           "the other way round": tables("*DEFINE_FRICTION_TITLE", "rubs", "5,0.6,0.6", "1,2,0.2,0.2", other),
                           "default": tables("*DEFINE_FRICTION", "5,0.2,0.2", other),
                           "absent parts": tables("*DEFINE_FRICTION", "5,0.2,0.2,0.0,0.0,1", "7,2,0.9,0.9", "9,1,0.9,0.9,0.0,0.0,PSET"),
                           "by number": tables("*DEFINE_FRICTION", "5,0.6,0.6", "*DEFINE_FRICTION", "6,0.2,0.2", number=6)}.items():
            with self.subTest(name=name):
                self.run_deck(plates(card, motion, 1.0e-4))
                self.assertEqual(self.rows(), expected)
        for card, words in ((tables("*DEFINE_FRICTION", "5,0.6,0.6", number=6), "*DEFINE_FRICTION 6 is not defined"),
                            (tables(), "there is no *DEFINE_FRICTION"),
                            (tables("*DEFINE_FRICTION", "5,0.6,0.6", "7,2,0.9,0.9"), "part 7 is not defined"),
                            (tables("*DEFINE_FRICTION", "5,0.6,0.6", "1,2,0.9,0.9,0.0,0.0,SET"), "expected PART or PSET")):
            with self.subTest(words=words):
                self.write(plates(card, motion, 1.0e-4))
                self.assertIn(words, self.nugget("check", "model.k", expect=1).stderr)

    def test_friction_of_pairs_in_any_order_and_in_an_included_file(self):
        """*DEFINE_FRICTION may follow its contact, and FD moves with IDDOFF as the table does; 1000 parts and 300 pairs of part sets
        are no work. Sabotage: FD looked up while the contact is read; without the offset; all pairs asked for each two parts."""
        nodes, shells, parts = [], [], []
        for k in range(1000):
            x, y = 5.0 * (k % 40), 5.0 * (k // 40)
            nodes += [f"{4 * k + i},{x + a},{y + b},0.0" for i, (a, b) in enumerate(((0, 0), (4, 0), (4, 4), (0, 4)), 1)]
            shells.append(f"{k + 1},{k + 1},{4 * k + 1},{4 * k + 2},{4 * k + 3},{4 * k + 4}")
            parts += ["*PART", "", f"{k + 1},1,1"]
        sets, pairs = [], []
        for i in range(300):
            sets += ["*SET_PART_LIST", f"{i + 1}"] + [",".join(str((i * 7 + j * (i % 11 + 3)) % 1000 + 1) for j in range(row, row + 8)) for row in range(0, 80, 8)]
            pairs.append(f"{i + 1},{i * 13 % 1000 + 1},0.1,0.1,0.0,0.0,PSET,PART")
        inner = "\n".join(["*KEYWORD", "*MAT_ELASTIC", "1,7.85e-9,210000.0,0.3", "*SECTION_SHELL", "1,2", "1.0,1.0,1.0,1.0", *parts, "*NODE", *nodes,
                           "*ELEMENT_SHELL", *shells, *sets, "*CONTACT_AUTOMATIC_SINGLE_SURFACE", "0", "-2.0,5", "0",
                           "*DEFINE_FRICTION", "5,0.2,0.2", *pairs, "*END"]) + "\n"
        self.write(inner, "inner.k")
        self.write("*KEYWORD\n*CONTROL_TERMINATION\n1.0e-7\n*INCLUDE_TRANSFORM\ninner.k\n" + "".join(f"{10000:10}" for _ in range(7))
                   + f"\n{10000:10}\n\n\n*END\n")
        began = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        self.nugget("run", "model.k", "--quiet")
        self.assertLess(resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - began, 10.0)

    def test_energy_of_friction_by_itself(self):
        """In sleout: what friction takes is its force over the way, of nodes and of glue that slides; bars that have met and parted hold
        nothing else. Sabotage: the whole force booked; glue or edges left out."""
        way, down = 200.0, 20.0

        def energies():
            states = lsda.states(lsda.read(self.folder / "binout0000"), "sleout")
            last = states[-1]
            self.assertEqual(last["total_friction"][0], last["friction_energy"][0])
            ascii_rows = [line.split() for line in self.read("sleout").splitlines() if re.match(r" +\d+ ", line)]
            self.assertAlmostEqual(float(ascii_rows[-1][3]), last["friction_energy"][0], delta=1e-4 * abs(last["friction_energy"][0]))
            return last["friction_energy"][0], last["total_energy"][0]

        for name, contact in (("nodes", sliding(fs=0.2)),
                              ("glue", sliding("AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK", fs=0.2, option=4, nfls=1e6, sfls=1e6))):
            with self.subTest(contact=name):
                text = plates(contact, {3: -down, 1: way}, 1.0e-4)
                self.run_deck(re.sub(r"(\*DATABASE_SLEOUT\n(?:\$.*\n)?.{10}).*", r"\g<1>         3", text))
                rows = self.rows()
                work = sum(0.5 * (a[1] + b[1]) * way * (a[0] - b[0]) for a, b in zip(rows, rows[1:]))
                friction, total = energies()
                self.assertGreater(work, 0.0)
                self.assertAlmostEqual(friction / work, 1.0, delta=0.02)
                self.assertGreater(total, 1.05 * friction)  # and the springs are pressed
        kinetic = 0.5 * 2.0 * 4000.0**2  # over the mass of the upper bar
        self.run_deck("\n".join([*BARS, *BAR_PARTS, "*DATABASE_SLEOUT", "1.0e-5,3", "*CONTACT_AUTOMATIC_GENERAL", "0", "0.2,0.2", "0", "*END"]) + "\n")
        friction, total = energies()
        energy = kinetic * 7.85e-9 * 20.0 * math.pi * 4.0
        self.assertGreater(friction, 0.01 * energy)
        self.assertAlmostEqual(friction / energy, total / energy, delta=0.005)

    def test_friction_of_parts_acts_between_edges(self):
        """Crossing bars of two parts that meet obliquely: FS = -1 and -2 as FS. Sabotage: edges without a kind."""
        by_part = ["*PART_CONTACT", "", "1,1,1", "0.1,0.1", "*PART_CONTACT", "", "2,1,1", "0.3,0.3"]
        found = []
        for part, friction, more in ((BAR_PARTS, "0.2,0.2", []), (by_part, "-1.0", []), (BAR_PARTS, "-2.0", ["*DEFINE_FRICTION", "1,0.5,0.5", "1,2,0.2,0.2"]),
                                     (BAR_PARTS, "0.0", [])):
            self.run_deck("\n".join([*BARS, *part, *more, "*CONTACT_AUTOMATIC_GENERAL", "0", friction, "0", "*END"]) + "\n")
            found.append(self.glstat())
        self.assertEqual(found[0], found[1])
        self.assertEqual(found[0], found[2])
        self.assertNotEqual(found[0], found[3])

    def test_a_node_set_has_the_thickness_and_the_friction_of_its_parts(self):
        """The same plates with SURFA as part and as node set. Sabotage: OPTT left out (1.0 thick: they touch at 1.0, not
        at 1.2); a node without segments without friction (half of the mean)."""
        def nodes(fs):
            def write(d):
                d.node_set(9, range(101, 126))
                d.keyword("CONTACT_AUTOMATIC_NODES_TO_SURFACE")
                d.card(surfa=9, surfb=LOWER, surfatyp=4, surfbtyp=3)
                d.card(fs=fs, fd=fs)
                d.card(sfsa=1.0, sfsb=1.0)
            return write
        card = {"fs": 0.2, "fd": 0.2, "dc": 0.0, "vc": 0.0, "optt": 1.2, "sft": 1.0, "ssf": 1.0}
        self.run_deck(plates(nodes(-1.0), {3: -1.0e4}, 1.0e-4, gap=1.5, parts="PART_CONTACT", options=(card,)))
        began = next(row[0] for row in self.rows() if row[3] > 0.0)
        self.assertAlmostEqual(1.5 - 1.0e4 * began, 1.2, delta=0.03)
        found = []
        for fs in (-1.0, 0.2):
            self.run_deck(plates(nodes(fs), {3: -20.0, 1: 200.0}, 1.0e-4, gap=1.2, parts="PART_CONTACT", options=(card,)))
            found.append(self.rows())
        self.assertGreater(-found[0][-1][1], 0.1 * found[0][-1][3])
        self.assertEqual(*found)

    def test_ignore_of_the_mpp_card(self):
        """Keeps plates that overlap where they are, as on card C; other values are told. Sabotage: read past."""
        def contact(ignore, scale=1.0):
            def write(d):
                d.keyword("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MPP")
                d.card(ignore=ignore, bckt=200)
                d.text(f"&                  0{scale:10.1f}")
                d.card(surfa=UPPER, surfb=LOWER, surfatyp=3, surfbtyp=3)
                d.card(fs=0.0)
                d.card(sfsa=1.0)
            return write
        def said(*card):
            self.write(plates(contact(*card), {3: -20.0}, 1.0e-5, gap=0.9))
            return self.nugget("check", "model.k").stderr
        self.assertIn("moved out (IGNORE = 0)", said(0))
        self.assertIn("kept and gives no force (IGNORE = 1)", said(1))
        self.assertIn("kept and gives no force (IGNORE = 2)", said(2))
        self.assertIn("ignore = 3: not built", said(3))
        self.assertNotIn("pensf", said(1))
        self.assertIn("pensf = 2.0: not built", said(1, 2.0))

    def test_attributes_of_sets_are_told_where_a_contact_would_use_them(self):
        """DA1, DA2: glue; DA3, DA4: friction; A1 of a _COLUMN. Sabotage: no warning."""
        def contact(attributes, glue, column=()):
            def write(d):
                d.keyword("SET_NODE_COLUMN")
                d.text("".join(f"{v:>10}" for v in (9, *attributes)))
                for node in range(101, 126):
                    d.text("".join(f"{v:>10}" for v in (node, *column)))
                d.keyword("CONTACT_" + ("TIEBREAK" if glue else "AUTOMATIC") + "_NODES_TO_SURFACE")
                d.card(surfa=9, surfb=LOWER, surfatyp=4, surfbtyp=3)
                d.card(fs=0.0)
                d.card(sfsa=1.0)
                if glue:
                    d.card(nflf=10.0, sflf=10.0, nen=2.0, mes=2.0)
            return write
        for attributes, glue, column, told in (((), True, (), False), ((5.0,), True, (), True), ((5.0,), False, (), False),
                                               ((0, 0, 2.0), False, (), True), ((), True, (7.0,), True)):
            self.write(plates(contact(attributes, glue, column), {3: -20.0}, 1.0e-5))
            self.assertEqual("of set 9 (strengths, scales of friction) are not obeyed" in
                             self.nugget("check", "model.k").stderr, told, (attributes, glue, column))

    def test_a_contact_acts_from_its_birth_to_its_death(self):
        """A plate that is driven at 20 mm/s: k depth from BT on, where what overlaps by then is an offset; and what its
        spring holds at DT stays in the sliding energy. Sabotage: BT + DT; no warning where it never acts."""
        def contact(birth, death):
            def write(d):
                d.keyword("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE")
                d.card(surfa=UPPER, surfb=LOWER, surfatyp=3, surfbtyp=3)
                d.card(fs=0.0, fd=0.0, dc=0.0, vc=0.0, vdc=0.0, penchk=0, bt=birth, dt=death)
                d.card(sfsa=0.001, sfsb=0.001)
            return write
        end, speed = 1.0e-4, 20.0
        self.run_deck(plates(contact(0.0, 0.0), {3: -speed}, end))
        whole = self.rows()
        k = whole[-1][3] / (speed * end)  # mm/s against the plate at rest: its shells hardly move
        birth, death = 0.3 * end, 0.7 * end
        self.run_deck(plates(contact(birth, death), {3: -speed}, end))
        for time, _, _, force in self.rows():
            if time < birth or time > death:
                self.assertEqual(force, 0.0, time)
            elif birth + 0.1 * end < time < death - 0.05 * end:
                self.assertAlmostEqual(force / (k * speed * (time - birth)), 1.0, delta=0.1)
        held = 0.5 * k * (speed * (death - birth)) ** 2
        sliding_energy = re.findall(r"sliding interface energy\.* +(\S+)", self.read("glstat"))
        self.assertAlmostEqual(float(sliding_energy[-1]) / held, 1.0, delta=0.1)
        for times, told in (((1.0, 0.0), "is after the end of the run"), ((5e-5, 2e-5), "is not before DT = 2e-05")):
            self.write(plates(contact(*times), {3: -speed}, end))
            self.assertIn(told, self.nugget("check", "model.k").stderr)

    def test_contact_thickness(self):
        """Where two plates come to touch: at half of both thicknesses. SFSAT leaves SAST as it is, SFT scales the true
        thickness alone. Sabotage: all of them multiplied."""
        def contact(sast, sfsat):
            def write(d):
                d.keyword("CONTACT_AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE")
                d.card(surfa=UPPER, surfb=LOWER, surfatyp=3, surfbtyp=3)
                d.card(fs=0.0)
                d.card(sfsa=1.0, sfsb=1.0, sast=sast, sbst=0.0, sfsat=sfsat, sfsbt=1.0)
            return write
        own, end = {"optt": 0.0, "sft": 1.0}, 2.0e-4
        for sast, sfsat, part, control, thicknesses in (
                (0.0, 1.5, own, {}, 2.5), (1.4, 1.5, own, {}, 2.4), (0.0, 1.0, {"optt": 1.2, "sft": 1.5}, {}, 2.4),
                (0.0, 1.5, {"optt": 1.2, "sft": 1.0}, {}, 3.0), (0.0, 1.0, {"optt": 0.0, "sft": 1.5}, {}, 3.0),
                (0.0, 1.0, own, {"th": 1.2, "th_sf": 2.0}, 2.4), (0.0, 1.0, own, {"th": 0.0, "th_sf": 1.5}, 3.0),
                (0.0, 1.0, {"optt": 1.3, "sft": 1.0}, {"th": 1.2, "th_sf": 0.0}, 2.6)):
            with self.subTest(sast=sast, sfsat=sfsat, part=part, control=control):
                def defaults(d):
                    d.keyword("CONTROL_CONTACT")
                    d.card(slsfac=0.1)
                    d.card(usrstr=0)
                    d.card(sfric=0.0, dfric=0.0, edc=0.0, vfc=0.0, **control)
                self.run_deck(plates(contact(sast, sfsat), {3: -1.0e4}, end, gap=3.0, parts="PART_CONTACT",
                                     options=({"fs": 0.0, "fd": 0.0, "dc": 0.0, "vc": 0.0, **part, "ssf": 1.0},),
                                     extra=defaults))
                began = next(row[0] for row in self.rows() if row[3] > 0.0)
                self.assertAlmostEqual(3.0 - 1.0e4 * began, 0.5 * thicknesses, delta=0.03)

    def test_default_penalty_of_the_parts(self):
        """PEN_SF is SSF of the parts that have none. Sabotage: not heeded; that of a part overwritten."""
        def force(ssf, pen_sf):
            def defaults(d):
                d.keyword("CONTROL_CONTACT")
                d.card(slsfac=0.01)
                d.card(usrstr=0)
                d.card(sfric=0.0, dfric=0.0, edc=0.0, vfc=0.0, th=0.0, th_sf=0.0, pen_sf=pen_sf)
            self.run_deck(plates(sliding(), {3: -20.0}, 1.0e-4, parts="PART_CONTACT", extra=defaults,
                                 options=({"fs": 0.0, "fd": 0.0, "dc": 0.0, "vc": 0.0, "optt": 0.0, "sft": 1.0,
                                           "ssf": ssf},)))
            return self.rows()
        self.assertEqual(force(1.0, 0.5), force(0.5, 0.0))
        self.assertEqual(force(0.25, 0.5), force(0.25, 0.0))
        self.assertNotEqual(force(1.0, 0.0), force(1.0, 0.5))

    def test_fields_that_are_not_obeyed(self):
        def cards(icor=0, soft=0, depth=2):
            def write(d):
                d.keyword("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE")
                d.card(surfa=UPPER, surfb=LOWER, surfatyp=3, surfbtyp=3)
                d.card(fs=0.0, fd=0.0, dc=0.0, vc=0.0, vdc=80.0)
                d.card(sfsa=1.0)
                d.card(soft=soft, sofscl=0.1, lcidab=0, maxpar=1.0, sbopt=2, depth=depth)
                for _ in "BCD":
                    d.card(soft=None)
                d.card(sharec=0, cparm8=0, ipback=0, srnde=0, fricsf=1.0, icor=icor)
            return write
        self.write(plates(cards(icor=1), {3: -20.0}, 1.0e-5))
        self.assertRegex(self.nugget("check", "model.k").stderr, "warning: .* icor = 1: restitution in percent")
        self.write(plates(cards(soft=2, depth=-5), {3: -20.0}, 1.0e-5))
        self.assertRegex(self.nugget("check", "model.k", expect=1).stderr, "error: .* depth = -5: a depth by curve")
        self.write(plates(sliding(), {3: -20.0}, 1.0e-5, parts="PART_CONTACT", options=(
            {"fs": 0.0, "fd": 0.0, "dc": 0.0, "vc": 0.0, "optt": 0.0, "sft": 1.0, "ssf": 1.0, "cparm8": 1},)))
        self.assertRegex(self.nugget("check", "model.k").stderr, "warning: .* cparm8 = 1: not obeyed")

    def test_fields_of_cards_a_and_c_and_of_transducers_that_are_not_obeyed(self):
        """Each by name, at values that differ from the default. Sabotage: no warning."""
        def cards(name="AUTOMATIC_SURFACE_TO_SURFACE", birth=0.0, **given):
            def write(d):
                d.keyword("CONTACT_" + name)
                d.card(surfa=UPPER, surfb=LOWER, surfatyp=3, surfbtyp=3)
                d.card(fs=0.0, fd=0.0, dc=0.0, vc=0.0, vdc=0.0, penchk=0, bt=birth, dt=0.0)
                d.card(sfsa=1.0)
                field = {"maxpar": 1.025, "frcfrq": 1, "igap": 1, "dprfac": 0.0, **given}
                d.card(soft=0, sofscl=0.1, lcidab=0, maxpar=field["maxpar"], sbopt=2, depth=2, bsort=0,
                       frcfrq=field["frcfrq"])
                d.card(penmax=0.0)
                d.card(igap=field["igap"], ignore=0, dprfac=field["dprfac"])
            return write
        def said(*name, **given):
            self.write(plates(cards(*name, **given), {3: -20.0}, 1.0e-5))
            return self.nugget("check", "model.k").stderr
        self.assertEqual(said(), "")
        for field, value, expected in (("maxpar", 1.05, "note: .* maxpar = 1.05: "), ("frcfrq", 10, "note: .* frcfrq = 10: "),
                                       ("dprfac", 0.01, "warning: .* dprfac = 0.01: not built")):
            self.assertRegex(said(**{field: value}), expected)
        self.assertNotIn("igap", said(igap=2))
        self.assertRegex(said("AUTOMATIC_SURFACE_TO_SURFACE_MORTAR", igap=2), "warning: .* igap = 2: not built")
        self.assertNotIn("bt = ", said("FORCE_TRANSDUCER_PENALTY"))
        self.assertRegex(said("FORCE_TRANSDUCER_PENALTY", birth=1e-6), "warning: .* bt = 1e-06: not obeyed")

    def test_only_what_lies_in_the_box(self):
        """A box around a quarter of the upper plate: a quarter of the force, about. Sabotage: the box not looked at."""
        force = {}
        for box in (0, 5):
            def boxed(d):
                d.keyword("DEFINE_BOX")
                d.card(boxid=5, xmn=-1.0, xmx=10.1, ymn=-1.0, ymx=10.1, zmn=-1.0, zmx=2.0)
            self.run_deck(plates(sliding("AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE", boxes=(box, 0)), {3: -20.0}, 1.0e-4,
                                 extra=boxed))
            force[box] = self.rows()[-1][3]
        self.assertGreater(force[0], 0.0)
        self.assertTrue(0.15 < force[5] / force[0] < 0.45, force)

    def test_a_node_too_deep_is_let_go(self):
        """PENMAX = 0.05 thicknesses. Sabotage: the field not obeyed."""
        for penmax, pressed in ((None, True), (0.05, False)):
            self.run_deck(plates(sliding(penmax=penmax), {3: -1000.0}, 1.0e-4))
            force = [row[3] for row in self.rows()]
            self.assertGreater(max(force), 0.0)
            self.assertEqual(force[-1] > 0.0, pressed, penmax)

    def test_a_transducer_with_two_sides_has_what_is_between_them(self):
        """Against the row of the only contact, by glue, nodes and edges. Sabotage: segments of any body count."""
        def third(d):
            """Two transducers, and a plate that nothing touches."""
            for name, a, b in ((11, UPPER, LOWER), (12, LOWER, UPPER), (13, UPPER, 3), (14, UPPER, 0)):
                d.keyword("CONTACT_FORCE_TRANSDUCER_PENALTY_ID")
                d.text(f"{name:10d}")
                d.card(surfa=a, surfb=b, surfatyp=3, surfbtyp=3)
                d.card(fs=None)
                d.card(sfsa=None)
            d.keyword("PART")
            d.text("far away")
            d.card(pid=3, secid=1, mid=LOWER)
            d.nodes({901: (0.0, 0.0, 90.0), 902: (5.0, 0.0, 90.0), 903: (5.0, 5.0, 90.0), 904: (0.0, 5.0, 90.0)})
            d.shells({901: (3, (901, 902, 903, 904))})

        glued = dict(name="AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK", option=2, nfls=10.0, sfls=10.0)
        edges = dict(soft=2, depth=5)
        for contact, motion, gap in ((sliding(fs=0.3), {3: -1000.0, 1: 500.0}, 1.05), (sliding(**glued), {3: 10.0, 1: 5.0}, 1.0),
                                     (sliding(**edges), {3: -1000.0, 1: 500.0, 2: 300.0}, 1.05)):
            self.run_deck(plates(contact, motion, 1.0e-4, gap=gap, extra=third))
            rows = {}
            for line in self.read("rcforc").splitlines():
                words = line.split()
                if words and words[0] in ("slave", "master"):
                    rows.setdefault((words[0], int(words[1])), []).append([float(words[i]) for i in (5, 7, 9)])
            expected = rows["slave", 1]
            self.assertGreater(max(abs(f) for row in expected for f in row), 1.0)

            def expect(key, factor):
                for got, wanted in zip(rows[key], expected, strict=True):
                    for f, g in zip(got, wanted):
                        self.assertAlmostEqual(f, factor * g, delta=2e-5 * max(abs(x) for x in wanted))
            # The contact's SURFA is UPPER.
            expect(("slave", 11), 1.0)
            expect(("master", 11), -1.0)
            expect(("slave", 12), -1.0)
            expect(("slave", 13), 0.0)
            expect(("slave", 14), 1.0)
            self.assertNotIn(("master", 14), rows)

    def test_a_transducer_counts_beams(self):
        """A bar falls on the lower plate: what it feels is the change of its momentum. Sabotage: beams are no part's nodes."""
        mass = 7.85e-9 * math.pi * 0.25 * 2.0**2 * 10.0

        def bar(d):
            for name, a, b in ((11, 3, 0), (12, 3, LOWER), (13, LOWER, 0)):
                d.keyword("CONTACT_FORCE_TRANSDUCER_PENALTY_ID")
                d.text(f"{name:10d}")
                d.card(surfa=a, surfb=b, surfatyp=3, surfbtyp=3)
                d.card(fs=None)
                d.card(sfsa=None)
            d.keyword("DATABASE_NODOUT")
            d.card(dt=4.0e-7)
            d.keyword("DATABASE_HISTORY_NODE")
            d.card(id1=901, id2=902)
            d.keyword("PART")
            d.text("bar")
            d.card(pid=3, secid=3, mid=3)
            d.keyword("SECTION_BEAM")
            d.card(secid=3, elform=1, shrf=1.0, qr=2, cst=1)
            d.card(ts1=2.0, ts2=2.0)
            d.keyword("MAT_NULL")
            d.card(mid=3, ro=7.85e-9, pc=0, mu=0, terod=0, cerod=0, ym=210000.0, pr=0.3)
            for node in (901, 902):
                d.keyword("INITIAL_VELOCITY_NODE")
                d.card(nid=node, vx=0.0, vy=0.0, vz=-1.0e4)
            d.nodes({901: (6.0, 7.0, 1.6), 902: (16.0, 7.0, 1.6), 903: (6.0, 17.0, 1.6)})
            d.keyword("ELEMENT_BEAM")
            d.text(f"{901:8d}{3:8d}{901:8d}{902:8d}{903:8d}")

        def general(d):
            d.keyword("CONTACT_AUTOMATIC_GENERAL")
            d.card(surfa=0)
            d.card(fs=None)
            d.card(sfsa=None)
        self.run_deck(plates(general, {3: 0.0}, 4.0e-5, gap=20.0, extra=bar))
        rows = {}
        for line in self.read("rcforc").splitlines():
            words = line.split()
            if words and words[0] == "slave":
                rows.setdefault(int(words[1]), []).append((float(words[3]), float(words[9])))
        impulse = sum(0.5 * (f + g) * (u - t) for (t, f), (u, g) in zip(rows[11], rows[11][1:]))
        speeds = [float(line[70:82]) for line in self.read("nodout").splitlines() if line[:10].strip() in ("901", "902") and len(line) > 130]
        gained = 0.5 * (speeds[-1] + speeds[-2]) + 1.0e4
        self.assertGreater(gained, 1.0e4)
        self.assertAlmostEqual(impulse / (mass * gained), 1.0, delta=0.05)
        for other, factor in ((12, 1.0), (13, -1.0)):
            for (_, f), (_, g) in zip(rows[other], rows[11], strict=True):
                self.assertAlmostEqual(f, factor * g, delta=1e-4 * max(abs(x) for _, x in rows[11]))

    def test_two_sides_must_be_named(self):
        """Sabotage: a contact of nothing."""
        for field in ("surfa", "surfb"):
            def blank(d):
                d.keyword("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE")
                d.card(**({"surfa": UPPER, "surfb": LOWER, "surfatyp": 3, "surfbtyp": 3} | {field: 0}))
                d.card(fs=None)
                d.card(sfsa=None)
            self.write(plates(blank, {3: 10.0}, 1e-4))
            self.assertIn(f"{field} = 0: must be given [name both sides", self.nugget("check", "model.k", expect=1).stderr)

    def test_sleout_adds_up_to_glstat(self):
        self.run_deck(plates(sliding(), {3: -1000.0}, 5.0e-5))
        lines = self.read("sleout").splitlines()
        total = [float(line.split("=")[1]) for line in lines if "total energy" in line]
        glstat = [float(line.split()[-1]) for line in self.read("glstat").splitlines() if "sliding interface" in line]
        self.assertEqual(len(total), len(glstat))
        self.assertGreater(glstat[-1], 0.0)
        for ours, theirs in zip(total, glstat):
            self.assertAlmostEqual(ours, theirs, delta=1e-5 * max(glstat))
        cycles = [line.split("cycle=")[1].split()[0] for line in lines if "cycle=" in line]
        self.assertEqual(cycles, re.findall(r"dt of cycle *(\d+) is controlled", self.read("glstat")))

    def test_initial_penetrations_are_reported(self):
        """IGNORE of *CONTROL_CONTACT holds. Sabotage: its field not used; a node or shell of another number."""
        for ignore, says in ((0, "they were moved out (IGNORE = 0)"), (1, "gives no force (IGNORE = 1)"),
                             (2, "move node ")):
            def control(d):
                d.keyword("CONTROL_CONTACT")
                d.card(slsfac=0.1)
                d.card(usrstr=0)
                d.card(sfric=0.0)
                d.card(ignore=ignore)
            run = self.run_deck(plates(sliding(), {3: 0.0}, 1.0e-6, gap=0.9, extra=control))
            self.assertIn("nodes stand in the thickness of a sheet or in a brick at the start; the deepest is node ",
                          run.stderr)
            self.assertIn(", 0.1 deep in shell ", run.stderr)
            self.assertIn(says, run.stderr)
            self.assertIn(says, self.read("run.log"))

    def test_mortar_runs_with_a_warning(self):
        run = self.run_deck(plates(sliding("AUTOMATIC_SURFACE_TO_SURFACE_MORTAR"), {3: -1000.0}, 2.0e-5))
        self.assertIn("segments are not integrated against segments", run.stderr)
        self.assertGreater(self.rows()[-1][3], 0.0)

    def test_a_brick_that_dies_lays_its_neighbour_bare(self):
        """A rigid plate is driven through bricks that fail at once when strained. Sabotage: faces between bricks left out."""
        def solids(d):
            d.keyword("PART")
            d.text("block")
            d.card(pid=3, secid=3, mid=3)
            d.keyword("SECTION_SOLID")
            d.card(secid=3, elform=1)
            d.keyword("MAT_PLASTIC_KINEMATIC")
            d.card(mid=3, ro=7.85e-9, e=2000.0, pr=0.3, sigy=5.0, etan=0.0, beta=1.0)
            d.card(src=0.0, srp=0.0, fs=0.2)
            first, wide = 1001, 6  # bricks along either side: more than the plate is wide, so that only faces within are hit
            number = lambda i, j, k: first + (k * (wide + 1) + j) * (wide + 1) + i  # noqa: E731
            every = range(wide + 1)
            d.nodes({number(i, j, k): (5.0 * i - 5.0, 5.0 * j - 5.0, 1.51 + 2.0 * k) for k in range(5) for j in every
                     for i in every})
            d.keyword("ELEMENT_SOLID")
            e = 1001
            for k in range(4):
                for j in range(wide):
                    for i in range(wide):
                        ids = [number(i, j, k), number(i + 1, j, k), number(i + 1, j + 1, k), number(i, j + 1, k)]
                        ids += [n + (wide + 1) ** 2 for n in ids]
                        d.text(f"{e:8d}{3:8d}" + "".join(f"{n:8d}" for n in ids))
                        e += 1
            d.node_set(2, [number(i, j, 4) for j in every for i in every])
            d.keyword("BOUNDARY_SPC_SET")
            d.card(nsid=2, cid=0, dofx=1, dofy=1, dofz=1)

        def contact(name):
            def write(d):
                d.keyword("CONTACT_" + name)
                d.card(surfa=3, surfb=3, surfatyp=4, surfbtyp=3)
                d.card(fs=0.0)
                d.card(sfsa=1.0)
                if name.startswith("ERODING"):
                    d.card(isym=0)
                d.card(soft=1)
                d.node_set(3, [101 + 5 * j + i for j in (1, 2, 3) for i in (1, 2, 3)])
            return write

        late = {}
        for name in ("AUTOMATIC_NODES_TO_SURFACE", "ERODING_NODES_TO_SURFACE"):
            self.run_deck(plates(contact(name), {3: 2000.0}, 3.0e-3, extra=solids))
            force = [abs(row[3]) for row in self.rows()]
            self.assertGreater(max(force), 0.0)
            late[name] = max(force[len(force) // 2:])
        self.assertGreater(late["ERODING_NODES_TO_SURFACE"], 100.0)
        self.assertLess(late["AUTOMATIC_NODES_TO_SURFACE"], 0.05 * late["ERODING_NODES_TO_SURFACE"])


    @staticmethod
    def below_bricks(where):
        """A contact of the moving plate's inner nodes with a layer of rigid bricks, 2 mm deep, whose lower face is at `where`."""
        def contact(d):
            d.keyword("CONTACT_AUTOMATIC_NODES_TO_SURFACE")
            d.card(surfa=3, surfb=3, surfatyp=4, surfbtyp=3)
            d.card(fs=0.0)
            d.card(sfsa=1.0)
            d.node_set(3, [101 + 5 * j + i for j in (1, 2, 3) for i in (1, 2, 3)])
            d.keyword("PART")
            d.text("block")
            d.card(pid=3, secid=3, mid=3)
            d.keyword("SECTION_SOLID")
            d.card(secid=3, elform=1)
            d.keyword("MAT_RIGID")
            d.card(mid=3, ro=7.85e-9, e=210000.0, pr=0.3)
            d.card(cmo=1.0, con1=7, con2=7)
            d.card(lco=None)
            number = lambda i, j, k: 1001 + (k * 7 + j) * 7 + i  # noqa: E731
            d.nodes({number(i, j, k): (5.1 * i - 5.0, 5.1 * j - 5.0, where + 2.0 * k) for k in range(2) for j in range(7)
                     for i in range(7)})
            d.keyword("ELEMENT_SOLID")
            for j in range(6):
                for i in range(6):
                    ids = [number(i, j, 0), number(i + 1, j, 0), number(i + 1, j + 1, 0), number(i, j + 1, 0)]
                    ids += [n + 49 for n in ids]
                    d.text(f"{1001 + 6 * j + i:8d}{3:8d}" + "".join(f"{n:8d}" for n in ids))
        return contact

    def test_springs_dropped_under_load_are_told_and_booked(self):
        """A plate is driven through a layer of bricks: up to the far side it is pressed back, then its springs are dropped. What
        they held stays in the contact and is all that is left there. Sabotage: energies that are not separated; no warning."""
        deep = {}
        for end in (1.2e-3, 2.0e-3):  # 1.9 and 3.5 mm beyond the touch, half a millimetre of it the thickness of the plate
            run = self.run_deck(plates(self.below_bricks(1.51), {3: 2000.0}, end))
            deep[end] = run.stderr
            energy = self.json("summary.json")["energy"]
            left = energy["contact"] - energy["contact_springs"] - energy["contact_lost"]
            self.assertLess(abs(left), 1e-3 * energy["contact"])
        self.assertNotIn("under load", deep[1.2e-3])
        self.assertIn("warning: contact dropped 9 springs under load", deep[2.0e-3])
        self.assertIn("stiffer with SFSA", deep[2.0e-3])
        self.assertGreater(energy["contact_lost"], 0.99 * energy["contact"])
        self.assertRegex(self.read("run.log"), r"contact 1 dropped 9 springs under load, which held \S+; the largest held \S+, at node "
                                               r"1\d\d against node 1\d\d\d, time=")
        self.assertRegex(self.read("run.log"), r"of contact: springs \S+  friction \S+  damping \S+  lost [1-9]")
        self.assertIn('id="check-contact-lost">look at it', self.read("report.html"))

    def test_bricks_that_start_too_deep_in_each_other_are_told(self):
        """Bricks of 2 mm press 0.6 mm deep, half of the plate's thickness more. Sabotage: a check that looks no deeper."""
        for where, told in ((0.6, False), (-0.2, True)):  # the plate's nodes 0.4 and 1.2 mm behind the face, 1 and 0.8 mm from one
            self.write(plates(self.below_bricks(where), {3: 2000.0}, 1e-5))
            run = self.nugget("check", "model.k")
            self.assertEqual("stand deeper in bricks at the start than contact presses, 0.3 of a brick's depth" in run.stderr, told)
        self.assertIn("9 nodes stand deeper", run.stderr)
        self.assertIn("deep in solid 1", run.stderr)


if __name__ == "__main__":
    unittest.main()
