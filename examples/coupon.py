# SPDX-License-Identifier: Apache-2.0
"""What the decks of coupons share: two sheets of a steel that yields at 300 MPa, one spot weld between them, two grips. mm, t, s, N, MPa."""
THICKNESS, DIAMETER = 1.5, 6.0  # of the sheets, of the weld


def controls(d, end_time, hourglass=0.05):
    d.keyword("CONTROL_TERMINATION")
    d.card(endtim=end_time)
    d.keyword("CONTROL_TIMESTEP")
    d.card(dtinit=0.0, tssfac=0.9)
    d.keyword("CONTROL_ENERGY")
    d.card(hgen=2, rwen=2, slnten=2, rylen=2)
    d.keyword("CONTROL_HOURGLASS")
    d.card(ihq=4, qh=hourglass)
    d.comment("spotstp = 1: a weld that finds no sheet is an error.")
    d.keyword("CONTROL_CONTACT")
    d.card(slsfac=0.1)
    d.card(usrstr=0)
    d.card(sfric=0.0)
    d.card(ignore=0, frceng=0, skiprwg=0, outseg=1, spotstp=1)


def sheets(d, titles, elastic=False):
    """Parts {pid: title}, all of section and material 1."""
    for pid, title in titles.items():
        d.part(title, pid=pid, secid=1, mid=1)
    d.keyword("SECTION_SHELL")
    d.card(secid=1, elform=2, shrf=0.8333, nip=5)
    d.card(t1=THICKNESS, t2=THICKNESS, t3=THICKNESS, t4=THICKNESS)
    if elastic:
        d.keyword("MAT_ELASTIC")
        d.card(mid=1, ro=7.85e-9, e=210000.0, pr=0.3)
        return
    d.comment("etan is the slope of stress over total strain; the plastic slope is 1500.")
    d.keyword("MAT_PIECEWISE_LINEAR_PLASTICITY")
    d.card(mid=1, ro=7.85e-9, e=210000.0, pr=0.3, sigy=300.0, etan=1489.36)
    d.card(c=0.0)
    d.card(eps1=None)
    d.card(es1=None)


def weld(d, pid, joined, what, sigy, nrr, nrs, **more):
    """A part of weld beams that does not yield below `sigy`, tied to the parts `joined` (set 1); `what` is said of its material, `more`
    are fields behind EH."""
    d.part("spot weld", pid=pid, secid=pid, mid=pid)
    d.weld_section(pid, DIAMETER)
    d.comment(what)
    d.keyword("MAT_SPOTWELD")
    d.card(mid=pid, ro=7.85e-9, e=210000.0, pr=0.3, sigy=sigy, eh=1000.0, **more)
    d.card(efail=0.0, nrr=nrr, nrs=nrs, nrt=nrs)
    d.tie_welds(pid, 1, joined, title="weld to sheets")


def grips(d, held, pulled, along, curve, scale):
    """Nothing turns in the grips, and only one moves, along degree of freedom `along` with `scale` times the velocity `curve`."""
    d.comment("The grips: nothing turns in them, and only one moves, along the pull.")
    d.node_set(1, held)
    d.node_set(2, pulled)
    free = [0 if dof == along else 1 for dof in (1, 2, 3)]
    d.keyword("BOUNDARY_SPC_SET")
    d.card(nsid=1, cid=0, dofx=1, dofy=1, dofz=1, dofrx=1, dofry=1, dofrz=1)
    d.card(nsid=2, cid=0, dofx=free[0], dofy=free[1], dofz=free[2], dofrx=1, dofry=1, dofrz=1)
    d.comment("vad = 0: curve 1 is a velocity; sf scales it.")
    d.keyword("BOUNDARY_PRESCRIBED_MOTION_SET")
    d.card(nsid=2, dof=along, vad=0, lcid=1, sf=scale)
    d.curve(1, curve)
