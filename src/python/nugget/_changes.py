# SPDX-License-Identifier: Apache-2.0
"""Values of a deck's cards and parameters, to be read and changed in its text."""
from __future__ import annotations

from typing import Iterator, Mapping, MutableMapping, Union

from . import _nugget

Value = Union[int, float, str, None]  #: None: a blank field


class Cards:
    """The cards of one keyword that belong together: one material, one section, one contact.

        weld = deck.card("MAT_SPOTWELD", 3)
        weld["nrr"]                    # as `nugget keywords MAT_SPOTWELD` names its fields; None: blank
        weld["nrr"] = 9000.0           # in the text: deck.write() writes it
    """

    def __init__(self, changes: _nugget.DeckChanges, number: int) -> None:
        self._changes, self._number = changes, number

    @property
    def keyword(self) -> str:
        """As written, with its star."""
        return self._changes.keyword(self._number)

    @property
    def file(self) -> str:
        return self._changes.place(self._number)[0]

    @property
    def line(self) -> int:
        """Of its first card, from 1."""
        return self._changes.place(self._number)[1]

    @property
    def fields(self) -> list[str]:
        """Names of the fields in its lines."""
        return self._changes.fields(self._number)

    @property
    def id(self) -> Value:
        """Its first field: of materials, sections, parts, curves their id."""
        return self[self.fields[0]]

    def __getitem__(self, field: str) -> Value:
        """The number or text in a field, parameters replaced."""
        return self._changes.value(self._number, field)

    def __setitem__(self, field: str, value: int | float | str) -> None:
        """A number is written with as many digits as fit, five at least; a text as it is. ValueError for what cannot be
        changed, by name."""
        if isinstance(value, str):
            self._changes.set_text(self._number, field, value)
        else:
            self._changes.set_number(self._number, field, value)

    def text(self, field: str) -> str:
        """What stands in a field, trimmed: `&thick` of a parameter."""
        return self._changes.text(self._number, field)

    def __repr__(self) -> str:
        return f"<{self.keyword} at {self.file}:{self.line}>"


class Parameters(MutableMapping[str, Union[int, float, str]]):
    """The *PARAMETER of a deck by name, small or capital letters alike: deck.parameters["thick"] = 1.5."""

    def __init__(self, changes: _nugget.DeckChanges) -> None:
        self._changes = changes

    def _all(self) -> Mapping[str, int | float | str]:
        return self._changes.parameters()

    def __getitem__(self, name: str) -> int | float | str:
        found = self._all()
        if name.lower() not in found:
            raise LookupError(f"there is no parameter '{name}'; there are: {', '.join(found) or 'none'}")
        return found[name.lower()]

    def __setitem__(self, name: str, value: int | float | str) -> None:
        """ValueError for one that is computed by an expression, or defined more than once."""
        if isinstance(value, str):
            self._changes.set_parameter_text(name, value)
        else:
            self._changes.set_parameter_number(name, value)

    def __delitem__(self, name: str) -> None:
        raise TypeError(f"the parameter '{name}' cannot be taken out of the text")

    def __iter__(self) -> Iterator[str]:
        return iter(self._all())

    def __len__(self) -> int:
        return len(self._all())

    def __repr__(self) -> str:
        return f"<parameters {dict(self._all())}>"
