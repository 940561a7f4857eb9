# SPDX-License-Identifier: Apache-2.0
"""The weld as a beam and as 1, 4 and 8 bricks, at three places of the mesh: what its place is worth.

The coupon of place.py; RPBHX of *CONTROL_SPOTWELD_BEAM makes bricks of the beam. The talk: beams are sensitive to their place, bricks, perhaps
four, are recommended where failure counts.
"""
from place import SOLIDS, placement, stiffness

FORMS = {"beam": 0, "1 brick": 1, "4 bricks": 4, "8 bricks": 8}


def deck(case, bricks):
    d = placement.make(case, end_time=5.0e-4)
    if bricks:
        d.keyword("CONTROL_SPOTWELD_BEAM")
        d.card(lct=0, lcs=0, t_ort=0, prtflg=0, t_ors=0, rpbhx=bricks)
    return d


def decks():
    return {f"form_{bricks}_{case}": deck(case, bricks) for bricks in FORMS.values() for case in placement.CASES}


def table(results):
    """{form: [stiffness at each place, N/mm]}"""
    return {form: [stiffness(results[f"form_{bricks}_{case}"]) for case in placement.CASES] for form, bricks in FORMS.items()}


def rows(results):
    found = table(results)
    for form, values in found.items():
        for case, value in zip(placement.CASES, values):
            gate = 0.05 if case == "centre" else 0.10 if form != "beam" else float("inf")
            yield f"{form}, {case}: elastic stiffness [N/mm]", value, SOLIDS, gate, "solids (CalculiX)"
    spread = {form: (max(v) - min(v)) / SOLIDS for form, v in found.items()}
    beam = float(spread["beam"] > 3.0 * max(v for form, v in spread.items() if form != "beam"))
    yield "a beam's spread is thrice that of bricks and more", beam, 1.0, 0.0, "the talk: sensitive to location"


def draw(results):
    import figures
    figure, ((axis,),) = figures.grid(1, 1, (6.4, 3.2))
    for i, (label, colour) in enumerate(zip(("centre", "edge", "node"), figures.COLOURS)):
        values = [v[i] / 1e3 for v in table(results).values()]
        axis.bar([k + 0.25 * (i - 1) for k in range(len(values))], values, width=0.23, color=colour, label=label)
    axis.axhline(SOLIDS / 1e3, color="0.3", linestyle="--", linewidth=1.0, label="solids")
    axis.set(xticks=range(len(FORMS)), xticklabels=FORMS, ylabel="stiffness of the coupon, kN/mm", ylim=(0, 85))
    axis.legend(ncols=4, loc="upper left")
    return figure
