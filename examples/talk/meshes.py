# SPDX-License-Identifier: Apache-2.0
"""Mesh below a weld: stiffness of a lap coupon over the size of its elements, the weld over a centre, an edge and a node.

The elastic coupon of examples/weld_place by linear statics: sheets of 1.5 mm, a weld beam of 6 mm, tied by the element under it and, with
*NUGGET_WELD_TIE, by its area.
"""
import importlib.util
import pathlib
import sys

import readers

HERE = pathlib.Path(__file__).resolve().parents[1] / "weld_place"
sys.path.insert(0, str(HERE))
spec = importlib.util.spec_from_file_location("place_study", HERE / "study.py")
study = importlib.util.module_from_spec(spec)
spec.loader.exec_module(study)

SIZES = (3.0, 4.0, 6.0, 10.0, 13.0)
PLACES = {"centre": (0.5, 0.5), "edge": (0.5, 0.0), "node": (0.0, 0.0)}
PULL = 1.0e-3  # of the grip [mm]
SOLIDS = study.SOLIDS["book", "lap"][0]


def deck(size, place, area):
    d = study.deck("book", "lap", size, PLACES[place], plastic=False)
    if area:
        d.keyword("NUGGET_WELD_TIE")
        d.card(form=1)
    return d


def decks(sizes=SIZES):
    return {f"mesh_{size:g}_{place}{'_area' if area else ''}": deck(size, place, area)
            for size in sizes for place in PLACES for area in (False, True)}


def stiffness(folder):
    return 2.0 * readers.summary(folder)["energy"]["internal"] / PULL**2


def rows(results):
    found = {name.removeprefix("mesh_"): stiffness(folder) for name, folder in results.items()}
    for name, value in found.items():
        size, _, place = name.partition("_")
        gate = 0.05 if name == "6_centre" else 0.06 if place.endswith("area") and float(size) <= 6.0 else float("inf")
        yield f"{size} mm, {place.replace('_area', ', by area')}: stiffness [N/mm]", value, SOLIDS, gate, "solids (CalculiX)"
    off = {place: abs(found[f"13_{place}"] - SOLIDS) for place in PLACES}
    yield "13 mm: a node is better than a centre", float(off["node"] < off["centre"]), 1.0, 0.0, "the talk: near a node on coarse meshes"
    spread = found["3_centre"] - found["3_node"]
    yield "3 mm: from centre to node still a fifth and more", float(spread > 0.2 * SOLIDS), 1.0, 0.0, "not as the talk: any place on fine meshes"


def draw(results):
    import figures
    figure, (axes,) = figures.grid(1, 2, (9.6, 3.4), sharey=True)
    sizes = [s for s in SIZES if f"mesh_{s:g}_node" in results]
    for axis, form, title in zip(axes, ("", "_area"), ("tied to the element under it", "tied by the nugget's area")):
        for place, colour in zip(PLACES, figures.COLOURS):
            values = [stiffness(results[f"mesh_{s:g}_{place}{form}"]) / 1e3 for s in sizes]
            axis.plot(sizes, values, "o-", color=colour, label=place, linewidth=1.2, markersize=4)
        axis.axhline(SOLIDS / 1e3, color="0.3", linestyle="--", linewidth=1.0, label="solids")
        axis.set_title(title, fontsize=9)
        axis.set(xlabel="size of the elements, mm", ylim=(0, 85))
        axis.legend(ncols=4, loc="lower right", fontsize=8)
    axes[0].set_ylabel("stiffness of the coupon, kN/mm")
    return figure
