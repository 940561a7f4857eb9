# SPDX-License-Identifier: Apache-2.0
"""What the module raises."""
from __future__ import annotations

import pathlib
from typing import Sequence

from ._nugget import Finding


class DeckError(ValueError):
    """A deck that is refused. As text: what the command prints."""

    def __init__(self, text: str, findings: Sequence[Finding]) -> None:
        super().__init__(text.rstrip("\n"))
        #: all of them, warnings and notes too
        self.findings = list(findings)


class RunError(RuntimeError):
    """A run that ended in an error termination. As text: why. What was written up to there can be read:
    nugget.results(error.directory)."""

    def __init__(self, text: str, directory: pathlib.Path) -> None:
        super().__init__(text.rstrip("\n"))
        self.directory = directory
