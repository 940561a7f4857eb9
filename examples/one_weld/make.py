# SPDX-License-Identifier: Apache-2.0
"""Writes decks of one weld beam without sheets: one node held, the other driven. Each failure function and each form of damage
has its own deck.

    python3 examples/one_weld/make.py FOLDER

fails_OPT_ANGLE.k: an elastic weld loaded at an angle (0 shear, 90 tension, below 0 compression) until its failure function ends it.
fades_NAME.k: a weld pulled beyond its failure strain. study.py runs them and draws the curves. Units: mm, t, s, N, MPa.
"""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from writer import Deck, main  # noqa: E402

DIAMETER, LENGTH, YOUNG = 6.0, 1.5, 210000.0
YIELD, HARDENING, EFAIL, RUPTURE = 400.0, 1000.0, 0.2, 0.3
THICKNESS = 1.0       # ZT of OPT 4 and 5
NORMAL, SHEAR = 8000.0, 6000.0  # strengths of OPT 0; those of the other OPT give the same in pure tension
SHEAR_1 = 7000.0      # of OPT 1 in pure shear
AREA = 0.25 * math.pi * DIAMETER**2
CURVE_11 = [(0.0, 6000.0), (30.0, 6200.0), (60.0, 7000.0), (90.0, NORMAL)]  # allowed force over the angle
STRESS_INTENSITY = 5.0 * math.sqrt(2.0) * NORMAL / (3.0 * math.pi * DIAMETER * math.sqrt(THICKNESS))
STRUCTURAL = 1.744 * NORMAL / THICKNESS**2

OPTIONS = {0: dict(efail=0.0, nrr=NORMAL, nrs=SHEAR, nrt=SHEAR),
           1: dict(efail=0.0, sigax=NORMAL / AREA, sigtau=SHEAR_1 / AREA),
           4: dict(efail=0.0, zd=DIAMETER, zt=THICKNESS),
           5: dict(efail=0.0, zd=DIAMETER, zt=THICKNESS, zt2=THICKNESS),
           11: dict(efail=0.0, lct=11, lcc=0)}
LIMIT = {4: STRESS_INTENSITY, 5: STRUCTURAL}  # FVAL
ANGLES = range(-30, 91, 10)

# Name: RS, BETA, DMGOPT, and the axial strength that ends (DMGOPT 10 and 12: begins to fade) the weld; none: EFAIL does.
FADES = {"efail": (0.0, 0.0, 0, 0.0), "dmgopt0": (RUPTURE, 0.0, 0, 0.0), "beta": (RUPTURE, 3.0, 0, 0.0),
         "dmgopt1": (RUPTURE, 0.0, 1, 0.0), "dmgopt2": (2.0e-5, 0.0, 2, 0.0), "dmgopt10": (RUPTURE, 0.0, 10, 15000.0),
         "dmgopt12": (2.0e-5, 0.0, 12, 15000.0)}


def weld(title, velocity, duration, step):
    """Everything but the material; `velocity`: (along, across) of node 2, whose spins are held."""
    d = Deck()
    d.keyword("KEYWORD")
    d.keyword("TITLE")
    d.text(title)
    d.keyword("CONTROL_TERMINATION")
    d.card(endtim=duration)
    d.keyword("CONTROL_TIMESTEP")
    d.card(dtinit=0.0, tssfac=0.9, isdo=0, tslimt=0.0, dt2ms=0.0, lctm=3)
    d.curve(3, [(0.0, step), (1.0, step)])
    d.keyword("CONTROL_ENERGY")
    d.card(hgen=2, rwen=2, slnten=2, rylen=2)
    d.keyword("DATABASE_SWFORC")
    d.card(dt=duration / 500.0)
    d.keyword("DATABASE_GLSTAT")
    d.card(dt=duration / 50.0)
    d.part("weld", pid=1, secid=1, mid=1)
    d.weld_section(1, DIAMETER)
    d.keyword("BOUNDARY_SPC_NODE")
    d.card(nid=1, cid=0, dofx=1, dofy=1, dofz=1, dofrx=1, dofry=1, dofrz=1)
    d.card(nid=2, cid=0, dofx=0, dofy=1, dofz=0, dofrx=1, dofry=1, dofrz=1)
    d.curve(1, [(0.0, 0.0), (0.02 * duration, 1.0), (1.0, 1.0)])
    d.keyword("BOUNDARY_PRESCRIBED_MOTION_NODE")
    d.card(nid=2, dof=3, vad=0, lcid=1, sf=velocity[0])
    d.card(nid=2, dof=1, vad=0, lcid=1, sf=velocity[1])
    d.nodes({1: (0.0, 0.0, 0.0), 2: (0.0, 0.0, LENGTH)})
    d.beams({1: (1, (1, 2))})
    return d


def material(d, first, second, third):
    d.keyword("MAT_SPOTWELD_DAMAGE-FAILURE")
    d.card(mid=1, ro=7.8e-9, e=YOUNG, pr=0.3, **first)
    d.card(**second)
    d.card(**third)


def fails(option, angle):
    """An elastic weld whose force has the direction `angle` from the start: shear is 2.6 times softer than tension."""
    stiffness = YOUNG * AREA / LENGTH, YOUNG / 2.6 * AREA / LENGTH
    duration, force = 1.0e-4, (2.0 if option == 5 else 1.3) * NORMAL  # at the end, did the weld hold
    phi = math.radians(angle)
    velocity = [round(force * part / k / duration, 5) for part, k in zip((math.sin(phi), math.cos(phi)), stiffness)]
    d = weld(f"OPT {option}, {angle} degrees", velocity, duration, 1.0e-8)
    material(d, dict(sigy=1.0e6, eh=0.0), OPTIONS[option], dict(rs=0.0, opt=float(option), fval=LIMIT.get(option, 0.0)))
    if option == 11:
        d.curve(11, CURVE_11)
    return d


def fades(name):
    rupture, beta, option, strength = FADES[name]
    duration, strain = 1.0e-4, 0.36
    d = weld(f"damage: {name}", (LENGTH * (math.exp(strain) - 1.0) / duration, 0.0), duration, 2.0e-8)
    second = dict(efail=0.0 if strength else EFAIL, nrr=strength)
    third = dict(rs=rupture, opt=0.0, fval=0.0, true_t=0.0, asff=0, beta=beta, _unused=None, dmgopt=float(option))
    material(d, dict(sigy=YIELD, eh=HARDENING), second, third)
    return d


def decks():
    """{name: deck}"""
    all_decks = {f"fails_{o}_{a}": fails(o, a) for o in OPTIONS for a in ANGLES}
    return {**all_decks, **{f"fades_{name}": fades(name) for name in FADES}}


if __name__ == "__main__":
    main(__doc__, decks)
