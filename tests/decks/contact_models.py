# SPDX-License-Identifier: Apache-2.0
"""Small models in which a contact is seen by what it does: two plates, of which one moves; two bars that cross."""
import sys

from nugget_command import SOURCE, CommandTest

sys.path.insert(0, str(SOURCE / "examples"))
from writer import Deck  # noqa: E402

SIDE = 20.0  # of the plates; 4 x 4 shells of 5 mm, 1 mm thick
LOWER, UPPER = 1, 2


def plate(deck, part, z, first):
    nodes = {first + 5 * j + i: (5.0 * i, 5.0 * j, z) for j in range(5) for i in range(5)}
    shells = {}
    for j in range(4):
        for i in range(4):
            a = first + 5 * j + i
            shells[first + 4 * j + i] = (part, (a, a + 1, a + 6, a + 5))
    return nodes, shells


def plates(contact, motion, end, gap=1.0, parts="PART", options=(), extra=None):
    """A fixed elastic plate, and a rigid one above it that moves: `motion` {degree of freedom: velocity}."""
    d = Deck()
    d.keyword("KEYWORD")
    d.keyword("CONTROL_TERMINATION")
    d.card(endtim=end)
    d.keyword("CONTROL_ENERGY")
    d.card(hgen=2, rwen=2, slnten=2, rylen=2)
    for name in ("GLSTAT", "RCFORC", "SLEOUT"):
        d.keyword("DATABASE_" + name)
        d.card(dt=end / 100)
    for pid in (LOWER, UPPER):
        d.keyword(parts)
        d.text("plate")
        d.card(pid=pid, secid=1, mid=pid)
        for card in options:
            d.card(**card)
    d.keyword("SECTION_SHELL")
    d.card(secid=1, elform=2, shrf=0.8333, nip=2)
    d.card(t1=1.0, t2=1.0, t3=1.0, t4=1.0)
    d.keyword("MAT_ELASTIC")
    d.card(mid=LOWER, ro=7.85e-9, e=210000.0, pr=0.3)
    d.keyword("MAT_RIGID")
    d.card(mid=UPPER, ro=7.85e-9, e=210000.0, pr=0.3)
    d.card(cmo=1.0, con1=0, con2=7)
    d.card(lco=None)
    lower, low_shells = plate(d, LOWER, 0.0, 1)
    upper, high_shells = plate(d, UPPER, gap, 101)
    d.node_set(1, lower)
    d.keyword("BOUNDARY_SPC_SET")
    d.card(nsid=1, cid=0, dofx=1, dofy=1, dofz=1, dofrx=1, dofry=1, dofrz=1)
    for dof, speed in motion.items():
        d.keyword("BOUNDARY_PRESCRIBED_MOTION_RIGID")
        d.card(pid=UPPER, dof=dof, vad=0, lcid=dof, sf=speed)
        d.curve(dof, [(0.0, 1.0), (1.0, 1.0)])
    contact(d)
    if extra:
        extra(d)
    d.nodes({**lower, **upper})
    d.shells({**low_shells, **high_shells})
    return "\n".join(d.lines + ["*END"]) + "\n"


def sliding(name="AUTOMATIC_SURFACE_TO_SURFACE", fs=0.0, boxes=(0, 0), penmax=None, sfs=1.0, **card4):
    def write(d):
        d.keyword("CONTACT_" + name)
        d.card(surfa=UPPER, surfb=LOWER, surfatyp=3, surfbtyp=3, saboxid=boxes[0], sbboxid=boxes[1])
        d.card(fs=fs, fd=fs)
        d.card(sfsa=sfs, sfsb=sfs)
        if card4:
            d.card(**card4)
        if penmax is not None:
            d.card(soft=0)
            d.card(penmax=penmax)
    return write


BARS = ["*KEYWORD", "*CONTROL_TERMINATION", "3.0e-4", "*DATABASE_GLSTAT", "1.0e-5", "*MAT_ELASTIC", "1,7.85e-9,210000.0,0.3",
        "*SECTION_BEAM", "1,1,1.0,2,1", "4.0,4.0,0.0,0.0", "*NODE", "1,-10,0,0", "2,0.5,0,0", "3,10,0,0", "4,0,-10,4.2", "5,0,0.5,4.2",
        "6,0,10,4.2", "7,50,50,50", "*ELEMENT_BEAM", "1,1,1,2,7", "2,1,2,3,7", "3,2,4,5,7", "4,2,5,6,7", "*INITIAL_VELOCITY_NODE",
        *(f"{n},4000.0,0.0,-4000.0" for n in (4, 5, 6))]  # crossing, of two parts that meet obliquely
BAR_PARTS = ["*PART", "", "1,1,1", "*PART", "", "2,1,1"]


class ContactTest(CommandTest):
    def rows(self, name="rcforc", side="slave"):
        """[(time, x, y, z)] of the force on a side."""
        found = []
        for line in self.read(name).splitlines():
            words = line.split()
            if words and words[0] == side:
                found.append(tuple(float(words[i]) for i in (3, 5, 7, 9)))
        return found

    def run_deck(self, text):
        self.write(text)
        return self.nugget("run", "model.k", "--quiet", "-j", 1)
