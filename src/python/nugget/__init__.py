# SPDX-License-Identifier: Apache-2.0
"""Nugget, the solver for spot-welded sheet metal, from Python.

    import nugget
    deck = nugget.read("model.k")              # checked, tied, audited; DeckError where it is refused
    r = nugget.run(deck, directory="out")      # the same bytes as the command nugget run
    r = nugget.results("out")                  # what a run left there
    r.welds["peak_failure"]                    # numpy arrays
    r.history("swforc")[50002, "axial"]
    r.plot("swforc/50002/axial")               # a notebook shows it

Lengths, masses and times are in the deck's own units.
"""
from ._processor import complaint as _complaint

if _complaint:  # all else would end Python by an illegal instruction
    raise ImportError(_complaint)

from ._changes import Cards, Parameters
from ._deck import Deck, Part, read
from ._elements import Elements
from ._errors import DeckError, RunError
from ._nugget import Finding
from ._nugget import version as __version__
from ._pictures import Picture, plot
from ._results import (BeamState, Channel, History, Modes, Response, Results, ShellState, SolidState, State, States,
                       results, sae_filter)
from ._running import frf, modes, place_welds, resume, run
from ._table import WeldTable

__all__ = ["BeamState", "Cards", "Channel", "Deck", "DeckError", "Elements", "Finding", "History", "Modes",
           "Parameters", "Part", "Picture", "Response", "Results", "RunError", "ShellState", "SolidState", "State",
           "States", "WeldTable", "frf", "modes", "place_welds", "plot", "read", "results", "resume", "run",
           "sae_filter"]
