# SPDX-License-Identifier: Apache-2.0
"""What the axial crush examples share: a profile pushed at constant speed against a rigid wall at z = 0, and what to
write about it."""
import math

from writer import Deck

SPEED = 5000.0     # 5 m/s
SHEET, CAP = 1, 2  # section and material of the sheets; part of the pushing end


def dent(z, centre, reach, depth):
    """The trigger: how far a wall stands off its plane at height z."""
    r = abs(z - centre) / reach
    return depth * 0.5 * (1.0 + math.cos(math.pi * r)) if r < 1.0 else 0.0


def begin(title, note, crush, step=None):
    """Control cards and histories of a crush by `crush` mm; `step`: DT2MS, where short weld beams would dictate it."""
    end = crush / SPEED
    d = Deck()
    d.keyword("KEYWORD")
    d.keyword("TITLE")
    d.text(title)
    d.comment(note)
    d.keyword("CONTROL_TERMINATION")
    d.card(endtim=end)
    if step:
        d.comment("Weld beams are short; a negative dt2ms adds mass only to what is below it.")
        d.keyword("CONTROL_TIMESTEP")
        d.card(dtinit=0.0, tssfac=0.9, isdo=0, tslimt=0.0, dt2ms=-step)
    d.keyword("CONTROL_ENERGY")
    d.card(hgen=2, rwen=2, slnten=2, rylen=2)
    d.comment("Stiffness form, a small coefficient: folds are pressed flat, so hourglass energy is what to watch in glstat.")
    d.keyword("CONTROL_HOURGLASS")
    d.card(ihq=4, qh=0.03)
    for name, interval in (("GLSTAT", end / 240), ("MATSUM", end / 240), ("RWFORC", end / 2400),
                           ("RCFORC", end / 240), ("SLEOUT", end / 240), ("BINARY_D3PLOT", end / 30)):
        d.keyword("DATABASE_" + name)
        d.card(dt=interval)
    return d


def sheets(d, thickness, yield_stress, parts, elform=2, points=5, tangent=0.0):
    """Section and material of the sheets: elastic, perfectly plastic but for a tangent modulus."""
    for pid, title in parts:
        d.part(title, pid=pid, secid=SHEET, mid=SHEET)
    d.keyword("SECTION_SHELL")
    d.card(secid=SHEET, elform=elform, shrf=0.8333, nip=points)
    d.card(t1=thickness, t2=thickness, t3=thickness, t4=thickness)
    d.comment("Elastic, perfectly plastic, no rate: what the closed form assumes.")
    d.keyword("MAT_PIECEWISE_LINEAR_PLASTICITY")
    d.card(mid=SHEET, ro=7.85e-9, e=210000.0, pr=0.3, sigy=yield_stress, etan=tangent)
    d.card(c=0.0)
    d.card(eps1=None)
    d.card(es1=None)


def cap(d, nodes, shells, rear, z, width):
    """A rigid plate at the rear edge that pushes it towards the wall at constant speed; turns nowhere."""
    first = 900000
    corners = ((-1, -1), (1, -1), (1, 1), (-1, 1))
    for i, (x, y) in enumerate(corners):
        nodes[first + i] = (0.5 * width * x, 0.5 * width * y, z)
    shells[max(shells) + 1] = (CAP, tuple(first + i for i in range(4)))
    d.comment("The pushing end: a rigid plate with the rear edge fixed to it, moved along z alone.")
    d.part("pushing end", pid=CAP, secid=CAP, mid=CAP)
    d.keyword("SECTION_SHELL")
    d.card(secid=CAP, elform=2, shrf=0.8333, nip=2)
    d.card(t1=10.0, t2=10.0, t3=10.0, t4=10.0)
    d.keyword("MAT_RIGID")
    d.card(mid=CAP, ro=7.85e-9, e=210000.0, pr=0.3)
    d.card(cmo=1.0, con1=4, con2=7)
    d.card(lco=None)
    d.keyword("CONSTRAINED_EXTRA_NODES_SET")
    d.card(pid=CAP, nsid=1)
    d.node_set(1, rear)
    d.keyword("BOUNDARY_PRESCRIBED_MOTION_RIGID")
    d.card(pid=CAP, dof=3, vad=0, lcid=9, sf=-SPEED)
    d.curve(9, [(0.0, 1.0), (1.0, 1.0)])


def wall_and_contact(d, rear_z, parts, sheets=None, friction=0.2, stiffness=1.0, thickness=1.0):
    """Everything moves at the speed of the pushing end; the front meets the wall, the folds meet each other, with these
    factors on their stiffness and thickness."""
    d.keyword("SET_PART_LIST")
    d.card(sid=2)
    d.ids(sheets or parts)
    d.comment("ssthk = 1: folds are as thick on a fine mesh as on a coarse one.")
    d.keyword("CONTROL_CONTACT")
    d.card(slsfac=0.1)
    d.card(usrstr=0, usrfrc=0, nsbcs=0, interm=0, xpene=4.0, ssthk=1)
    d.comment("Folds do not pass through each other.")
    d.keyword("CONTACT_AUTOMATIC_SINGLE_SURFACE_ID")
    d.text(f"{2:10d}folds")
    d.card(surfa=2, surfb=0, surfatyp=2, surfbtyp=0)
    d.card(fs=friction, fd=friction)
    d.card(sfsa=stiffness, sfsb=stiffness, **({} if thickness == 1.0 else {"sast": 0.0, "sbst": 0.0, "sfsat": thickness, "sfsbt": thickness}))
    d.comment("fric = 1: what has arrived at the wall does not slide.")
    d.keyword("RIGIDWALL_PLANAR_ID")
    d.text(f"{1:10d}wall")
    d.card(nsid=0, nsidex=0, boxid=1)
    d.card(xt=0.0, yt=0.0, zt=0.0, xh=0.0, yh=0.0, zh=1.0, fric=1.0)
    d.keyword("DEFINE_BOX")
    d.card(boxid=1, xmn=-200.0, xmx=200.0, ymn=-200.0, ymx=200.0, zmn=-1.0, zmx=rear_z - 0.5)
    d.keyword("INITIAL_VELOCITY_GENERATION")
    d.card(id=0, styp=1, omega=0.0, vx=0.0, vy=0.0, vz=-SPEED)
    d.card(xc=0.0, yc=0.0, zc=0.0, nx=0.0, ny=0.0, nz=0.0)
