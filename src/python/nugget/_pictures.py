# SPDX-License-Identifier: Apache-2.0
"""Plots and pictures that a notebook shows."""
from __future__ import annotations

import os
from typing import Mapping, Sequence

import numpy as np

from . import _nugget
from ._arrays import Array


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


def plot_channels(directory: str, channels: Sequence[str], over: str, cfc: int, other: str) -> Picture:
    try:
        return Picture(_nugget.plot(directory, list(channels), over, cfc, other))
    except RuntimeError as error:
        raise LookupError(str(error)) from None


def picture_of(directory: str, options: _nugget.PictureOptions) -> Picture:
    try:
        return Picture(_nugget.picture(directory, options))
    except RuntimeError as error:
        raise LookupError(f"{directory}: {error}") from None


def plot(curves: Mapping[str, tuple[Sequence[float] | Array, Sequence[float] | Array]], *, abscissa: str = "",
         ordinate: str = "", log_x: bool = False, log_y: bool = False, points: Sequence[str] = ()) -> Picture:
    """Curves of one's own in one plot: (x, y) by name. `abscissa`, `ordinate`: names of the axes. `points`: names of
    those that are drawn as points."""
    traces = []
    for name, (x, y) in curves.items():
        if len(x) != len(y):
            raise ValueError(f"'{name}' has {len(x)} abscissas and {len(y)} ordinates")
        traces.append((name, np.asarray(x, dtype=float), np.asarray(y, dtype=float), name in points))
    return Picture(_nugget.plot_curves(traces, abscissa, ordinate, log_x, log_y))
