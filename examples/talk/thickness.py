# SPDX-License-Identifier: Apache-2.0
"""Diameter and length of a weld over the thickness of its sheets: what `nugget weld` places, and what `nugget weld --stack` writes.

Two touching sheets of the same thickness, 3 x 3 shells of 10 mm; a list of one point, without a diameter.
"""
import math
import re
import subprocess

import readers
from sheets import Model

THICKNESSES = (0.5, 0.8, 1.0, 1.5, 2.0, 3.0, 4.0)


def deck(thickness):
    """The sheets alone."""
    m = Model(f"Two sheets of {thickness:g} mm", 1.0e-6)
    m.record(1.0e-6, "GLSTAT")
    for pid in (1, 2):
        m.sheet(pid, thickness, (0, 0, (pid - 1) * thickness), 3, 3, 10.0)
    return m.finished()


def decks():
    return {f"sheets_{t:g}": deck(t) for t in THICKNESSES}


def nugget(program, *arguments):
    subprocess.run([str(program), *map(str, arguments)], check=True, capture_output=True)


def prepare(program, folder):
    """Runs of the sheets with the weld that the program places, and cards of their stacks."""
    found = {}
    for thickness in THICKNESSES:
        name = f"sheets_{thickness:g}"
        found[name] = folder / name
        if (found[name] / "summary.json").exists():
            continue
        deck(thickness).write(folder / f"{name}.k")
        (folder / f"{name}.csv").write_text(f"15, 15, {0.5 * thickness:g}\n", encoding="ascii")
        nugget(program, "weld", folder / f"{name}.csv", folder / f"{name}.k", "-o", folder / f"{name}_welded.k")
        nugget(program, "run", folder / f"{name}_welded.k", "-o", found[name], "--quiet")
        nugget(program, "weld", "--stack", f"{thickness:g}:440,{thickness:g}:440", "-o", found[name] / "card.k")
    return found


def diameter_of_card(folder):
    """TS1 of *SECTION_BEAM."""
    text = (folder / "card.k").read_text(encoding="ascii")
    cards = [line for line in text.partition("*SECTION_BEAM")[2].splitlines() if re.match(r"\s*\d", line)]
    return float(cards[1][:10])


def rows(results):
    for thickness, folder in zip(THICKNESSES, results.values()):
        weld = readers.weld(folder)
        yield f"{thickness:g} mm: diameter as placed [mm]", float(weld["diameter"]), 5.0 * math.sqrt(thickness), 1e-4, "5 √t, the talk"
        yield f"{thickness:g} mm: diameter of the card [mm]", diameter_of_card(folder), 5.0 * math.sqrt(thickness), 1e-3, "5 √t, the talk"
        yield f"{thickness:g} mm: length [mm]", float(weld["length"]), thickness, 1e-6, "(t1 + t2)/2"
        told = float("thickness" in weld["remarks"])
        yield f"{thickness:g} mm: the audit has no remark on it", told, 0.0, 0.0, "the talk: sheets of 0.5 to 4 mm"


def draw(results):
    import figures
    figure, ((axis,),) = figures.grid(1, 1, (6.4, 3.4))
    fine = [0.05 * i for i in range(1, 91)]
    welds = [readers.weld(folder) for folder in results.values()]
    axis.axvspan(0.0, 0.5, color="0.9", linewidth=0)
    axis.axvspan(4.0, 4.5, color="0.9", linewidth=0)
    for name, formula, label, colour in (("diameter", lambda t: 5.0 * math.sqrt(t), "diameter, 5 √t", figures.BLUE),
                                         ("length", lambda t: t, "length, t", figures.RED)):
        axis.plot(fine, [formula(t) for t in fine], color=colour, linewidth=1.0, label=label)
        axis.plot(THICKNESSES, [float(w[name]) for w in welds], "o", color=colour, markersize=4)
    axis.set(xlabel="thickness of both sheets, mm", ylabel="mm", xlim=(0, 4.5), ylim=(0, None))
    axis.legend()
    return figure
