# SPDX-License-Identifier: Apache-2.0
"""Elements of a model as arrays."""
from __future__ import annotations

import numpy as np

from ._arrays import Array


class Elements:
    """Shells, solids or beams: a row each, in ascending order of `ids`."""

    def __init__(self, ids: Array, node_index: Array, parts: Array, *, node_ids: Array) -> None:
        self.ids = ids
        self.node_index = node_index  #: where the nodes stand in arrays of nodes
        self.parts = parts  #: ids of parts
        self._node_ids = node_ids

    @property
    def nodes(self) -> Array:
        """Ids of the nodes: 4 of a shell (a triangle repeats its third), 8 of a solid, 2 of a beam."""
        return self._node_ids[self.node_index] if len(self.ids) else self.node_index

    def index(self, element_id: int) -> int:
        """Where an element stands, by its id."""
        place = int(np.searchsorted(self.ids, element_id))
        if place == len(self.ids) or self.ids[place] != element_id:
            raise LookupError(f"there is no element {element_id} among these")
        return place

    def __len__(self) -> int:
        return len(self.ids)

    def __repr__(self) -> str:
        return f"<{len(self)} elements of {self.node_index.shape[1]} nodes>"
