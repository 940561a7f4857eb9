# SPDX-License-Identifier: Apache-2.0
"""Beams in contact with each other and with sheets."""
import unittest

from contact_models import ContactTest
from nugget_command import CommandTest
from writer import Deck


class BeamContacts(ContactTest):
    def test_beams_alone_meet_where_their_thicknesses_say(self):
        """Two crossing bars 5 apart, 4 thick, 1e4 fast: they meet after 1e-4, a tube by TS1, a resultant beam and a truss by
        the root of the area. Sabotage: the diameter from TS1 alone; a contact without segments refused."""
        sections = {1: ("1,1,1.0,2,1", "4.0,4.0,0.0,0.0"), 2: ("1,2,1.0", "16.0,20.0,20.0,40.0"), 3: ("1,3", "16.0")}
        places = [(-10, 0, 0), (0.5, 0, 0), (10, 0, 0), (0, -10, 5), (0, 0.5, 5), (0, 10, 5), (50, 50, 50)]
        for elform, (section, size) in sections.items():
            lines = ["*KEYWORD", "*CONTROL_TERMINATION", "2.0e-4", "*DATABASE_GLSTAT", "1.0e-6", "*PART", "bars", "1,1,1",
                     "*MAT_ELASTIC", "1,7.85e-9,210000.0,0.3", "*SECTION_BEAM", section, size, "*NODE"]
            lines += [f"{i},{x},{y},{z}" for i, (x, y, z) in enumerate(places, 1)]
            lines += ["*ELEMENT_BEAM", "1,1,1,2,7", "2,1,2,3,7", "3,1,4,5,7", "4,1,5,6,7", "*INITIAL_VELOCITY_NODE"]
            lines += [f"{n},0.0,0.0,-10000.0" for n in (4, 5, 6)]
            lines += ["*CONTACT_AUTOMATIC_GENERAL", "0", "0", "0", "*END"]
            with self.subTest(elform):
                self.run_deck("\n".join(lines) + "\n")
                states = self.glstat()
                met = next(s["time"] for s in states if s["sliding interface energy"] > 0.0)
                self.assertAlmostEqual(met, 1.0e-4, delta=3.0e-6)
                self.assertAlmostEqual(self.json("summary.json")["energy"]["ratio"], 1.0, delta=1.0e-3)

    def test_beams_meet_sheets_by_their_nodes(self):
        """A rod of 2 along a plate of 1, its axis 2 above the plate's middle, 5e4 fast: 1e-5. Not with segment-based contact, nor
        where SURFA needs segments. Sabotage: beams in *CONTACT_AUTOMATIC_GENERAL alone."""
        plate = [(5 * i, 5 * j, 0) for j in range(4) for i in range(4)]
        shells = [(4 * j + i + 1, 4 * j + i + 2, 4 * j + i + 6, 4 * j + i + 5) for j in range(3) for i in range(3)]
        lines = ["*KEYWORD", "*CONTROL_TERMINATION", "2.0e-5", "*DATABASE_GLSTAT", "2.0e-7", "*MAT_ELASTIC",
                 "1,7.85e-9,210000.0,0.3", "*PART", "plate", "1,1,1", "*PART", "rod", "2,2,1", "*SECTION_SHELL", "1,2", "1.0",
                 "*SECTION_BEAM", "2,1,1.0,2,1", "2.0,2.0,0.0,0.0", "*NODE"]
        lines += [f"{i},{x},{y},{z}" for i, (x, y, z) in enumerate([*plate, (4, 7, 2), (7.5, 7, 2), (11, 7, 2), (50, 50, 50)], 1)]
        lines += ["*ELEMENT_SHELL"] + [f"{i},1,{a},{b},{c},{d}" for i, (a, b, c, d) in enumerate(shells, 1)]
        lines += ["*ELEMENT_BEAM", "11,2,17,18,20", "12,2,18,19,20", "*INITIAL_VELOCITY_NODE"]
        lines += [f"{n},0.0,0.0,-50000.0" for n in (17, 18, 19)]
        for name, sides, soft, meets in (("GENERAL", "0", 0, True), ("SINGLE_SURFACE", "0", 1, True), ("SINGLE_SURFACE", "0", 2, False),
                                         ("NODES_TO_SURFACE", "2,1,3,3", 0, True), ("SURFACE_TO_SURFACE", "2,1,3,3", 0, False)):
            with self.subTest(name=name, soft=soft):
                self.run_deck("\n".join([*lines, "*CONTACT_AUTOMATIC_" + name, sides, "0", "0", f"{soft}", "*END"]) + "\n")
                met = [s["time"] for s in self.glstat() if s["sliding interface energy"] > 0.0]
                self.assertEqual(bool(met), meets)
                if meets:
                    self.assertAlmostEqual(met[0], 1.0e-5, delta=1.5e-6)


class Bars(CommandTest):
    """Beams alone in a contact: a bar that flies across another of the same mass hands over its velocity."""
    SPEED = 1.0e4

    def deck(self, name, second_part, mpp="", welds=False):
        """Two bars of 10 mm, 2 mm thick, crossing 0.1 mm from touching; the upper one of `second_part` comes down. With
        `welds` the lower one is a weld between two sheets that hold it."""
        d = Deck()
        d.keyword("KEYWORD")
        d.keyword("CONTROL_TERMINATION")
        d.card(endtim=5.0e-5)
        d.keyword("DATABASE_NODOUT")
        d.card(dt=1.0e-7)
        d.keyword("DATABASE_HISTORY_NODE")
        d.card(id1=1, id2=2, id3=3, id4=4)
        d.keyword("CONTACT_" + name)
        if mpp:
            d.card(ignore=0, bckt=0, lcbckt=0, ns2trk=0, inititr=0, parmax=0, unused=None, cparm8=mpp)
        d.card(surfa=1, surfb=0, surfatyp=2, surfbtyp=0)
        d.card(fs=0.0)
        d.card(sfsa=1.0)
        d.keyword("SET_PART_LIST")
        d.card(sid=1)
        d.card(pid1=1, pid2=2)
        d.keyword("PART")
        d.text("lower")
        d.card(pid=1, secid=9 if welds else 1, mid=9 if welds else 1)
        d.keyword("PART")
        d.text("upper")
        d.card(pid=2, secid=1, mid=1)
        d.keyword("SECTION_BEAM")
        d.card(secid=1, elform=1, shrf=1.0, qr=2, cst=1)
        d.card(ts1=2.0, ts2=2.0)
        d.keyword("MAT_NULL")
        d.card(mid=1, ro=7.85e-9, pc=0, mu=0, terod=0, cerod=0, ym=210000.0, pr=0.3)
        if welds:
            d.keyword("SECTION_BEAM")
            d.card(secid=9, elform=9, shrf=1.0, qr=2, cst=1)
            d.card(ts1=2.0, ts2=2.0)
            d.keyword("MAT_SPOTWELD")
            d.card(mid=9, ro=7.85e-9, e=210000.0, pr=0.3, sigy=1.0e6, eh=1000.0)
            d.card(efail=0.0)
            d.keyword("PART")
            d.text("sheets")
            d.card(pid=5, secid=5, mid=5)
            d.keyword("SECTION_SHELL")
            d.card(secid=5, elform=2, shrf=1.0, nip=2)
            d.card(t1=1.0, t2=1.0, t3=1.0, t4=1.0)
            d.keyword("MAT_ELASTIC")
            d.card(mid=5, ro=7.85e-9, e=210000.0, pr=0.3)
        for node in (3, 4):
            d.keyword("INITIAL_VELOCITY_NODE")
            d.card(nid=node, vx=0.0, vy=0.0, vz=-self.SPEED)
        nodes = {1: (-5.0, 0.0, 0.0), 2: (5.0, 0.0, 0.0), 3: (0.0, -5.0, 2.1), 4: (0.0, 5.0, 2.1)}
        shells = {}
        if welds:
            for side, corner in ((-5.0, 1), (5.0, 2)):
                first = 10 * corner
                nodes |= {first + k: (side, y, z) for k, (y, z) in enumerate(((9.0, 0.0), (9.0, 9.0), (0.0, 9.0)))}
                shells[corner] = (5, (corner, first, first + 1, first + 2))
        d.nodes(nodes)
        if shells:
            d.shells(shells)
        d.keyword("ELEMENT_BEAM")
        d.text(f"{1:8d}{1:8d}{1:8d}{2:8d}")
        d.text(f"{2:8d}{second_part:8d}{3:8d}{4:8d}")
        self.write("\n".join(d.lines + ["*END"]) + "\n")

    def velocities(self):
        """Last velocities along z of the lower and the upper bar."""
        found = {}
        for line in self.read("nodout").splitlines():
            if line[:10].strip().isdigit() and len(line) > 130:
                found[int(line[:10])] = float(line[10 + 5 * 12:10 + 6 * 12])
        return 0.5 * (found[1] + found[2]), 0.5 * (found[3] + found[4])

    def test_beams_alone_press_each_other(self):
        """Elastic impact of equal masses. Sabotage: a contact without segments is left out."""
        self.deck("AUTOMATIC_GENERAL", 2)
        self.nugget("run", "model.k", "--quiet", "-j", 1)
        lower, upper = self.velocities()
        self.assertAlmostEqual(lower, -self.SPEED, delta=0.01 * self.SPEED)
        self.assertAlmostEqual(upper, 0.0, delta=0.01 * self.SPEED)

    def test_cparm8_keeps_beams_of_one_part_apart(self):
        """Sabotage: CPARM8 is read past."""
        for mpp, pressed in ((0, True), (1, False)):
            self.deck("AUTOMATIC_GENERAL_MPP", 1, mpp=str(mpp) if mpp else "0")
            self.nugget("run", "model.k", "--quiet", "-j", 1)
            self.assertAlmostEqual(self.velocities()[1], 0.0 if pressed else -self.SPEED, delta=0.01 * self.SPEED)

    def test_cparm8_lets_weld_beams_take_part(self):
        """The bar bounces off a weld that is held, and passes one that is left out. Sabotage: weld beams never take part."""
        self.deck("AUTOMATIC_GENERAL_MPP", 2, mpp="2", welds=True)
        said = self.nugget("run", "model.k", "--quiet", "-j", 1)
        self.assertNotIn("left out of it here", said.stderr)
        self.assertGreater(self.velocities()[1], -0.5 * self.SPEED)
        self.deck("AUTOMATIC_GENERAL", 2, welds=True)
        said = self.nugget("run", "model.k", "--quiet", "-j", 1)
        self.assertIn("left out of it here", said.stderr)
        self.assertAlmostEqual(self.velocities()[1], -self.SPEED, delta=1e-3 * self.SPEED)

    def test_cparm8_has_few_values(self):
        self.deck("AUTOMATIC_GENERAL_MPP", 2, mpp="3")
        self.assertIn("cparm8 = 3: expected 0, 1 or 2, or 10 more", self.nugget("check", "model.k", expect=1).stderr)


if __name__ == "__main__":
    unittest.main()
