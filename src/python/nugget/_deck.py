# SPDX-License-Identifier: Apache-2.0
"""A deck, read and checked."""
from __future__ import annotations

import dataclasses
import functools
import os
import pathlib
from typing import Any, Sequence

import numpy as np

from . import _nugget
from ._arrays import Array
from ._changes import Cards, Parameters
from ._elements import Elements
from ._errors import DeckError
from ._table import WeldTable

WELD_TIES = ("", "area", "joint")


def expect_weld_tie(form: str) -> None:
    if form not in WELD_TIES:
        raise ValueError(f"weld_tie '{form}', expected area or joint")


@dataclasses.dataclass(frozen=True)
class Part:
    """A part of a deck. Values are in the deck's units."""

    id: int
    title: str
    kind: str  #: of its elements: shell, solid, beam, discrete; empty where it has none
    section: int  #: id
    elform: int
    thickness: float  #: of its section, of shells; else NaN
    material: int  #: id
    law: str  #: keyword of its material, `MAT_PIECEWISE_LINEAR_PLASTICITY`
    density: float
    young: float
    poisson: float


class Deck:
    """A deck as it is understood: read, checked, its welds tied and audited. Nothing was run.

        deck = nugget.read("model.k")
        deck.findings                  # what there is to say of it
        deck.parts[2].thickness        # by id
        deck.shells.nodes              # numpy arrays
        deck.welds["diameter"]
        deck.card("MAT_SPOTWELD", 3)["nrr"] = 9000.0
        stronger = deck.write("stronger.k")
    """

    def __init__(self, path: pathlib.Path, checked: _nugget.CheckedDeck, options: dict[str, Any]) -> None:
        self.path = path
        self._checked = checked
        self._options = options  # of read()

    @property
    def title(self) -> str:
        return self._checked.title

    @property
    def files(self) -> list[str]:
        """All files that were read, by their whole paths, the master file first."""
        return self._checked.files

    @property
    def findings(self) -> list[_nugget.Finding]:
        """Warnings and notes. A deck with errors is not read: DeckError has those."""
        return self._checked.findings

    @property
    def units(self) -> str:
        """Length, mass, time, as recognised from density and Young's modulus of the sheets: `mm, t, s`; empty where
        they are not."""
        return self._checked.units

    @property
    def end_time(self) -> float:
        return self._checked.end_time

    @property
    def keywords(self) -> dict[str, int]:
        """How often each keyword stands in the deck."""
        return self._checked.keywords

    @functools.cached_property
    def parts(self) -> dict[int, Part]:
        """By id, in deck order."""
        return {row["id"]: Part(**row) for row in self._checked.parts}

    @functools.cached_property
    def node_ids(self) -> Array:
        """Ascending."""
        return self._checked.node_ids

    @functools.cached_property
    def coordinates(self) -> Array:
        """A row x y z for each of `node_ids`."""
        return self._checked.coordinates

    def node(self, node_id: int) -> int:
        """Where a node stands in arrays of nodes, by its id."""
        place = int(np.searchsorted(self.node_ids, node_id))
        if place == len(self.node_ids) or self.node_ids[place] != node_id:
            raise LookupError(f"there is no node {node_id}")
        return place

    @functools.cached_property
    def shells(self) -> Elements:
        return Elements(*self._checked.shells, node_ids=self.node_ids)

    @functools.cached_property
    def shell_thickness(self) -> Array:
        """Of each of `shells`, at the start."""
        return self._checked.shell_thickness

    @functools.cached_property
    def solids(self) -> Elements:
        """Of tetrahedra of ten nodes, the corners."""
        return Elements(*self._checked.solids, node_ids=self.node_ids)

    @functools.cached_property
    def beams(self) -> Elements:
        return Elements(*self._checked.beams, node_ids=self.node_ids)

    @functools.cached_property
    def welds(self) -> WeldTable:
        """What `nugget check` writes to welds.csv: where each weld was tied, and its audit."""
        return WeldTable(self._checked.welds)

    # ---- changes of the text

    @functools.cached_property
    def _changes(self) -> _nugget.DeckChanges:
        return _nugget.DeckChanges(self._checked)

    @property
    def is_changed(self) -> bool:
        """Values of its text were changed. What else this object shows is the deck as it was read."""
        return "_changes" in self.__dict__ and not self._changes.empty

    @property
    def parameters(self) -> Parameters:
        """Its *PARAMETER by name, to be read and changed."""
        return Parameters(self._changes)

    def cards(self, keyword: str) -> list[Cards]:
        """All cards of a keyword, under any of its names and options: `MAT_024` finds
        *MAT_PIECEWISE_LINEAR_PLASTICITY_TITLE. The mesh (*NODE, *ELEMENT_...) is not in cards but in arrays."""
        return [Cards(self._changes, number) for number in self._changes.cards_of(keyword)]

    def card(self, keyword: str, id: int | None = None) -> Cards:
        """The one of a keyword with this id, which is its first field; without an id the only one. LookupError where
        there is none, or more than one."""
        found = [cards for cards in self.cards(keyword) if id is None or cards.id == id]
        if len(found) == 1:
            return found[0]
        what = keyword if id is None else f"{keyword} {id}"
        if found:
            raise LookupError(f"{len(found)} cards are {what}: {', '.join(map(repr, found))}")
        ids = ", ".join(str(cards.id) for cards in self.cards(keyword))
        raise LookupError(f"there is no {what}" + (f"; there are those of {ids}" if ids else ""))

    def remove_weld(self, weld_id: int) -> None:
        """Takes the elements of a weld out of the text. ValueError for welds that are no elements."""
        self._changes.remove_weld(weld_id)

    def move_weld(self, weld_id: int, to: Sequence[float]) -> None:
        """Moves the nodes of a weld so that their middle stands at `to`; the sheets that it is tied to are those that
        are found there. ValueError where other elements share its nodes."""
        self._changes.move_weld(weld_id, tuple(to))

    def move_node(self, node_id: int, to: Sequence[float]) -> None:
        """Gives a node another place in the text."""
        self._changes.move_node(node_id, tuple(to))

    def write(self, path: str | os.PathLike[str]) -> Deck:
        """Writes the changed deck as another one and reads that: DeckError where what was changed is refused (the files
        stay for a look). All that was not changed is there byte for byte. Included files that changed, or include one
        that did, stand beside it as <its name>_<their name>; others are included where they are. ValueError where a
        file of this deck would be overwritten."""
        self._changes.write(os.fspath(path))
        return read(path, **self._options)

    def __repr__(self) -> str:
        return f"<{self.path}: {len(self.parts)} parts, {len(self.node_ids)} nodes, {len(self.shells)} shells, " \
               f"{len(self.solids)} solids, {len(self.beams)} beams, {self.welds.count} welds>"


def read(deck: str | os.PathLike[str], *, case: int = 0, weld_tie: str = "", weld_law: str = "",
         skip_unsupported: bool = False) -> Deck:
    """Reads and checks a deck, ties its welds and audits them; runs nothing. DeckError, with all findings, where it is
    refused. `case`: its *CASE. `weld_tie`, `weld_law`, `skip_unsupported`: as of `nugget check`."""
    expect_weld_tie(weld_tie)
    options = {"case": case, "weld_tie": weld_tie, "weld_law": weld_law, "skip_unsupported": skip_unsupported}
    checked = _nugget.CheckedDeck(os.fspath(deck), case, weld_tie, os.fspath(weld_law), skip_unsupported)
    if checked.errors:
        raise DeckError(f"{checked.listing}\nthe deck is refused", checked.findings)
    return Deck(pathlib.Path(deck), checked, options)
