# SPDX-License-Identifier: Apache-2.0
"""Nugget, the solver for spot-welded sheet metal, from Python.

    import nugget
    r = nugget.results("out")                  # what a run left there
    r.welds["peak_failure"]                    # numpy arrays
    r.history("swforc")[50002, "axial"]

Lengths, masses and times are in the deck's own units.
"""
from ._elements import Elements
from ._nugget import Finding
from ._nugget import version as __version__
from ._results import (BeamState, Channel, History, Modes, Response, Results, ShellState, SolidState, State, States,
                       results, sae_filter)
from ._table import WeldTable

__all__ = ["BeamState", "Channel", "Elements", "Finding", "History", "Modes", "Response", "Results", "ShellState",
           "SolidState", "State", "States", "WeldTable", "results", "sae_filter"]
