# SPDX-License-Identifier: Apache-2.0
"""Tables of welds: welds.csv as columns of numpy arrays."""
from __future__ import annotations

import csv
import re
from typing import Any, Iterable, Iterator, Mapping

import numpy as np

from ._arrays import Array

_TEXTS = re.compile(r"kind|failure_mode|last_terms|remarks|reason\d*|segment\d*")
_IDS = re.compile(r"id|part|sheet1|node\d+|case\d+")
_FLAGS = ("tied", "failed")


def _column(name: str, cells: list[str]) -> Array:
    if name in _FLAGS:
        return np.array([cell == "yes" for cell in cells], dtype=bool)
    if _IDS.fullmatch(name):
        return np.array([int(cell or 0) for cell in cells], dtype=np.int64)
    if _TEXTS.fullmatch(name):
        return np.array(cells, dtype=object)
    if name == "failure_course":
        courses = np.empty(len(cells), dtype=object)
        courses[:] = [np.array(cell.split(), dtype=float) for cell in cells]
        return courses
    return np.array([float(cell) if cell else np.nan for cell in cells], dtype=float)


def _parts(cells: Iterable[tuple[str, str]]) -> Array:
    rows = [tuple(int(word) for word in " ".join(pair).split()) for pair in cells]
    out = np.empty(len(rows), dtype=object)
    out[:] = rows
    return out


class WeldTable(Mapping[str, Array]):
    """The welds of a deck or of a run, a row each: the columns of welds.csv by their names.

        welds["peak_failure"]          # an array, an entry for each weld
        welds[50002]                   # the weld with that id: {column: value}
        welds["id"][welds["failed"]]   # ids of those that failed

    Columns of numbers hold NaN where welds.csv has an empty cell; `tied` and `failed` are bools; `parts` holds the ids
    of the parts that a weld joins, a tuple for each. What the columns mean: docs/manual/weld_results.md.
    """

    def __init__(self, text: str) -> None:
        rows = list(csv.reader(text.splitlines()))
        names = rows[0] if rows else []
        cells = {name: [row[i] if i < len(row) else "" for row in rows[1:]] for i, name in enumerate(names)}
        self._columns = {name: _column(name, column) for name, column in cells.items() if name != "sheet2"}
        if names:
            self._columns["parts"] = _parts(zip(cells["sheet1"], cells["sheet2"]))

    def __getitem__(self, key: str | int) -> Any:
        if isinstance(key, str):
            if key not in self._columns:
                raise LookupError(f"the welds have no column '{key}'; there are: {', '.join(self._columns)}")
            return self._columns[key]
        found = np.flatnonzero(self._columns["id"] == key) if self._columns else np.empty(0, dtype=int)
        if len(found) == 0:
            raise LookupError(f"there is no weld {key}")
        return {name: column[found[0]] for name, column in self._columns.items()}

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        """How many columns there are; `count` welds."""
        return len(self._columns)

    @property
    def count(self) -> int:
        """How many welds there are."""
        return len(self._columns["id"]) if self._columns else 0

    def rows(self) -> Iterator[dict[str, Any]]:
        """The welds one by one."""
        for i in range(self.count):
            yield {name: column[i] for name, column in self._columns.items()}

    def __repr__(self) -> str:
        return f"<{self.count} welds, columns {', '.join(self._columns)}>"
