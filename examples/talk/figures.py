# SPDX-License-Identifier: Apache-2.0
"""What the figures of the talk share: matplotlib without a screen, small SVG files, the nodes of a d3plot."""
import pathlib
import sys

import matplotlib
import matplotlib.patches
from matplotlib.figure import Figure

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
import states  # noqa: E402

matplotlib.rcParams.update({"svg.hashsalt": "nugget", "svg.fonttype": "none", "font.family": "sans-serif", "font.size": 9,
                            "axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False, "path.simplify_threshold": 0.5})
BLUE, RED, GREEN, GREY = "#1f5f99", "#c04020", "#3c8c3c", "#888888"
COLOURS = (BLUE, RED, GREEN, "#7a4fa0", "#b08020")


def grid(rows, columns, size, **options):
    """A figure and its axes, always as rows of rows."""
    figure = Figure(figsize=size, layout="constrained")
    return figure, figure.subplots(rows, columns, squeeze=False, **options)


def save(figure, path):
    figure.savefig(path, metadata={"Date": None, "Creator": None})


def first_state(folder):
    """Places of the nodes, corners of the shells and ends of the beams, as a run begins."""
    x, shells, _, beams, _ = states.read(folder, first=True)
    return x, shells, beams


def state_at(folder, time):
    """As first_state, of the state nearest to a time."""
    x, shells, _, beams, _, _ = min(states.states(folder), key=lambda state: abs(state[5] - time))
    return x, shells, beams


def circle(centre, radius):
    return matplotlib.patches.Circle(centre, radius, color=RED, alpha=0.5, linewidth=0)
