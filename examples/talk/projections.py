# SPDX-License-Identifier: Apache-2.0
"""The eight projections of the talk, each as a deck: where the weld is drawn, what it is tied to, who carries its force.

Two sheets of 3 x 3 shells of 10 mm, 1 mm thick, and a weld beam of 5 mm. All nodes of the upper sheet go 1 um along x, those of the others
stand; so the force of the weld is G A / L times 1 um, and the reactions show its shares.
"""
import readers
from sheets import SHEAR_MODULUS, Model, disc, smooth

DIAMETER, SIZE, SHIFT = 5.0, 10.0, 1.0e-3
WHAT = {1: "over a centroid", 2: "on an edge", 3: "on a corner", 4: "sheets penetrate", 5: "beside its sheet", 6: "another sheet is closest",
        7: "sheets have crossed", 8: "crossed, normals outward"}
ENDS = {1: ((15, 15, 0.2), (15, 15, 0.9)), 2: ((17, 10, 0), (17, 10, 1)), 3: ((10, 10, 0), (10, 10, 1)), 4: ((15, 15, 0), (15, 15, 0.6)),
        5: ((38, 15, 0), (38, 15, 1)), 6: ((33, 15, 0), (33, 15, 2)), 7: ((15, 15, 0), (15, 15, 1)), 8: ((15, 15, 0), (15, 15, 1))}
UPPER = {1: 1.0, 2: 1.0, 3: 1.0, 4: 0.6, 5: 1.0, 6: 2.0, 7: 0.4, 8: 0.4}  # height of the sheet that end 2 belongs to
# What the talk says: length, and the share of each node of the lower sheet (row by row from 1001) that has one.
TALK = {1: (1.0, {1006: 0.25, 1007: 0.25, 1010: 0.25, 1011: 0.25}), 2: (1.0, {1006: 0.3, 1007: 0.7}), 3: (1.0, {1006: 1.0}),
        4: (1.0, {1006: 0.25, 1007: 0.25, 1010: 0.25, 1011: 0.25}), 5: (None, {}), 6: (3.0, {3006: 0.1, 3007: 0.4, 3010: 0.1, 3011: 0.4}),
        7: (None, {}), 8: (None, {})}
MOVED = {1: 0.2, 4: 0.2, 6: 1.0}  # of end 1; the warning tells it


def sheets_of(case):
    """(part, corner, shells along x) of each sheet, all 30 mm wide."""
    lower = 0.6 if case in (7, 8) else 0.0
    all_of_them = [(1, (0, 0, lower), 3), (2, (30 if case == 6 else 0, 0, UPPER[case]), 6 if case == 5 else 3)]
    return all_of_them + ([(3, (15, 0, -1), 3)] if case == 6 else [])


def deck(case):
    crossed = case in (7, 8)
    m = Model(f"Projection, case {case}: {WHAT[case]}", 4.0e-5)
    m.record(4.0e-6, "SPCFORC", "SWFORC")
    m.record(4.0e-5, "BINARY_D3PLOT")
    for pid, corner, along in sheets_of(case):
        m.sheet(pid, 1.0, corner, along, 3, SIZE, turned=case == 8 and pid == 1)
    m.beam_part(9, DIAMETER)
    m.spotweld(9)
    m.beam(9001, 9, *ENDS[case], sheets=(1, 2) if crossed else None)
    m.tie(9, [pid for pid in m.grids])
    if case == 4:
        m.deck.comment("Contact parts the sheets first (IGNORE 0), then the weld is projected.")
        m.deck.keyword("CONTACT_AUTOMATIC_SINGLE_SURFACE")
        m.deck.card(surfa=0)
        m.deck.card(fs=None)
        m.deck.card(sfsa=1.0, sfsb=1.0)
    m.hold(1, [n for pid, nodes in m.grids.items() if pid != 2 for n in nodes])
    m.hold(2, m.grids[2], "yzuvw")
    m.drive(2, 1, smooth(2.0e-5), SHIFT)
    return m.finished()


def decks():
    return {f"projection_{case}": deck(case) for case in WHAT}


def shares(folder):
    """{node: share of the force on the standing sheets}"""
    along = {n: f[0] for n, f in readers.reactions(folder).items() if not 2000 < n < 3000}
    total = sum(along.values())
    return {n: f / total for n, f in along.items() if abs(f) > 1e-6 * abs(total)} if total else {}


def rows(results):
    for case in WHAT:
        folder, (length, carried) = results[f"projection_{case}"], TALK[case]
        weld = readers.weld(folder)
        yield f"case {case}: tied", float(weld["tied"] == "yes"), float(length is not None), 0.0, "the talk"
        yield f"case {case}: number in welds.csv", float(weld["case1"]), float(case), 0.0, "the talk"
        if length is None:
            yield f"case {case}: force on its own sheet [N]", sum(abs(f[0]) for f in readers.reactions(folder).values()), 0.0, 1e-9, "the talk"
            continue
        if case in MOVED:
            yield f"case {case}: end 1 moved by [mm]", float(weld["moved1"]), MOVED[case], 2e-3, "half of the penetration, or to the sheet"
        yield f"case {case}: length [mm]", float(weld["length"]), length, 1e-3, "(t1 + t2)/2, or between the sheets"
        yield f"case {case}: force [N]", readers.swforc(folder)[-1][2], SHEAR_MODULUS * disc(DIAMETER) * SHIFT / length, 2e-3, "G A u / L"
        found = shares(folder)
        for node in sorted(found.keys() | carried.keys()):
            yield f"case {case}: share of node {node}", found.get(node, 0.0), carried.get(node, 0.0), 1e-6, "bilinear functions"


def draw_plan(axis, case, carried):
    """From above: the lower sheet's mesh, the weld, and where it is tied the nodes that carry, with their shares."""
    import figures
    for i in range(4):
        axis.plot((0, 30), (10 * i, 10 * i), (10 * i, 10 * i), (0, 30), color="0.4", linewidth=0.8)
    for node, share in carried.items():
        x, y = SIZE * ((node - 1001) % 4), SIZE * ((node - 1001) // 4)
        axis.plot(x, y, "o", color=figures.BLUE, markersize=3 + 6 * share)
        axis.annotate(f"{share:.4g}", (x, y), xytext=(4, 4), textcoords="offset points", fontsize=8, color=figures.BLUE)
    axis.plot(*ENDS[case][0][:2], "o", color=figures.RED, markersize=6, markerfacecolor=figures.RED if carried else "none")
    axis.set(aspect="equal", xlim=(-3, 33), ylim=(-3, 33))


def draw_side(axis, case, sheets, ends, tied):
    """Along y: {part: (from, to, height)} of sheets with their thickness, and of crossed ones their normals; heights are enlarged."""
    import figures
    for pid, (low, high, z) in sheets.items():
        colour = {1: figures.BLUE, 2: figures.GREEN, 3: figures.GREY}[pid]
        axis.fill_between((low, high), z - 0.5, z + 0.5, color=colour, alpha=0.25, linewidth=0)
        axis.plot((low, high), (z, z), color=colour, linewidth=0.8, linestyle="--")
        if case >= 7:
            up = -1.2 if case == 8 and pid == 1 else 1.2
            axis.annotate("", (low + 4 * pid, z + up), (low + 4 * pid, z), arrowprops={"arrowstyle": "->", "color": colour})
    axis.plot(*zip(*ends), color=figures.RED, linewidth=2)
    for end, holds in zip(ends, tied):
        axis.plot(*end, "o", color=figures.RED, markersize=5, markerfacecolor=figures.RED if holds else "w")
    axis.set(xlim=(-2, 62 if case in (5, 6) else 32), ylim=(-1.8, 2.8))


def drawn(case):
    """Sheets and weld of the deck, as draw_side takes them."""
    sheets = {pid: (corner[0], corner[0] + SIZE * along, corner[2]) for pid, corner, along in sheets_of(case)}
    return sheets, [(end[0], end[2]) for end in ENDS[case]], (False, False)


def after(case, folder):
    """The same as they stand in the first state, and which end is tied."""
    import figures
    x, shells, beams = figures.first_state(folder)
    heights = {(round(min(x[n][0] for n in ring)), round(x[ring[0]][2], 4)) for ring in shells}
    sheets = {pid: (low, high, min((h for start, h in heights if start == low), key=lambda h: abs(h - z)))  # noqa: B023
              for pid, (low, high, z) in drawn(case)[0].items()}
    weld = readers.weld(folder)
    return sheets, [(x[n][0], x[n][2]) for n in beams[0]], [bool(weld[f"segment{i}"]) for i in (1, 2)]


def draw(results):
    import figures
    figure, axes = figures.grid(4, 4, (9.6, 7.2))
    for case in WHAT:
        before, then = axes[2 * ((case - 1) // 4)][(case - 1) % 4], axes[2 * ((case - 1) // 4) + 1][(case - 1) % 4]
        folder = results[f"projection_{case}"]
        if case <= 3:
            draw_plan(before, case, {})
            draw_plan(then, case, shares(folder))
        else:
            draw_side(before, case, *drawn(case))
            draw_side(then, case, *after(case, folder))
        before.set_title(f"{case}  {WHAT[case]}", fontsize=9)
        for axis in (before, then):
            axis.set(xticks=[], yticks=[], frame_on=False)
    for row, name in enumerate(("in the deck", "in the run") * 2):
        axes[row][0].set_ylabel(name)
    return figure
