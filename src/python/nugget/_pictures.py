# SPDX-License-Identifier: Apache-2.0
"""Plots and pictures that a notebook shows."""
from __future__ import annotations

import os
from typing import Sequence

from . import _nugget


class Picture:
    """A plot of curves or a picture of the model, as SVG. A notebook shows it; save() writes it."""

    def __init__(self, svg: str) -> None:
        self.svg = svg  #: the whole document

    def _repr_svg_(self) -> str:
        return self.svg

    def save(self, file: str | os.PathLike[str], *, width: int = 1440) -> None:
        """Writes an .svg, or a .png `width` pixels wide."""
        name = os.fspath(file)
        if not _nugget.is_picture_name(name):
            raise ValueError(f"{name}: a picture is an .svg or a .png")
        try:
            _nugget.write_picture(name, self.svg, width)
        except RuntimeError as error:
            raise OSError(str(error)) from None

    def __repr__(self) -> str:
        return f"<picture, {len(self.svg)} characters of SVG>"


def plot(directory: str, channels: Sequence[str], over: str, cfc: int, other: str) -> Picture:
    try:
        return Picture(_nugget.plot(directory, list(channels), over, cfc, other))
    except RuntimeError as error:
        raise LookupError(str(error)) from None


def picture(directory: str, options: _nugget.PictureOptions) -> Picture:
    try:
        return Picture(_nugget.picture(directory, options))
    except RuntimeError as error:
        raise LookupError(f"{directory}: {error}") from None
