# SPDX-License-Identifier: Apache-2.0
"""Runs in the process of Python."""
from __future__ import annotations

import json
import os
import pathlib
import tempfile
from typing import Any, Callable, Iterable, Mapping, Sequence

from . import _nugget
from ._deck import Deck, expect_weld_tie, read
from ._errors import DeckError, RunError
from ._results import Results

#: Of run(): time, end time, cycle, energy ratio, failed welds. False stops the run.
Progress = Callable[[float, float, int, float, int], "bool | None"]

NORMAL, REFUSED, WRONG_COMMAND, ERROR_TERMINATION, CANNOT_WRITE, INTERRUPTED = 0, 1, 2, 3, 4, 130


def _path_of(deck: str | os.PathLike[str] | Deck) -> str:
    if not isinstance(deck, Deck):
        return os.fspath(deck)
    if deck.is_changed:
        raise ValueError(f"{deck.path} has changes that are not written: new = deck.write(\"new.k\")")
    return os.fspath(deck.path)


def _expect_one_case(deck: str, case: int) -> None:
    numbers = _nugget.case_numbers(deck)
    if numbers and case == 0:
        raise ValueError(f"{deck} has the cases {', '.join(map(str, numbers))}: give one, case={numbers[0]}")


def _stamp(path: pathlib.Path) -> tuple[int, int] | None:
    """What is another one when the file was written anew, which takes its place by another file."""
    try:
        stat = path.stat()
    except OSError:
        return None
    return stat.st_ino, stat.st_mtime_ns


class _Command:
    """One command in a folder, and what becomes of it."""

    def __init__(self, deck: str, directory: str | os.PathLike[str], case: int, skip_unsupported: bool) -> None:
        self.deck, self.directory = deck, pathlib.Path(directory)
        self.case, self.skip_unsupported = case, skip_unsupported
        self._findings = self.directory / "findings.json"
        self._before = _stamp(self._findings)

    def end(self, code: int, text: str) -> Results:
        """The results, or what says why there are none."""
        if code == REFUSED:
            self._refuse(text)
        if code == WRONG_COMMAND:
            raise ValueError(text.strip())
        if code == ERROR_TERMINATION:
            message = Results(self.directory).summary["message"] if (self.directory / "summary.json").exists() else text
            raise RunError(message, self.directory)
        if code == CANNOT_WRITE:
            raise OSError(text.strip())
        results = Results(self.directory)
        if code == INTERRUPTED and results.summary["message"].startswith("interrupted by the user"):
            raise KeyboardInterrupt(results.summary["message"])
        return results

    def _refuse(self, text: str) -> None:
        if _stamp(self._findings) == self._before:  # there is no such deck, or no restart file that can be gone on with
            if self.deck:
                read(self.deck, case=self.case, skip_unsupported=self.skip_unsupported)
            raise RunError(text.strip(), self.directory)
        found = json.loads(self._findings.read_text(encoding="utf-8"))
        raise DeckError(text, [_nugget.Finding(**each) for each in found])


def _arguments(deck: str, directory: str | os.PathLike[str], threads: int, case: int, weld_tie: str,
               skip_unsupported: bool) -> _nugget.RunArguments:
    expect_weld_tie(weld_tie)
    if threads < 0:
        raise ValueError(f"threads = {threads}, expected 1 or more, or 0 for all cores")
    arguments = _nugget.RunArguments()
    arguments.deck, arguments.directory, arguments.threads = deck, os.fspath(directory), threads
    arguments.load_case, arguments.weld_tie, arguments.skip_unsupported = case, weld_tie, skip_unsupported
    return arguments


def _put_ends(arguments: _nugget.RunArguments, until: float | None, max_cycles: int | None, checkpoint: str,
              stop_after: float | None) -> None:
    for name, value in (("until", until), ("max_cycles", max_cycles), ("stop_after", stop_after)):
        if value is not None and not value > 0:
            raise ValueError(f"{name} = {value}, expected more than 0")
        setattr(arguments, name, value or 0)
    if checkpoint and not _nugget.says_checkpoints(checkpoint):
        raise ValueError(f"checkpoint '{checkpoint}', expected e.g. 500cycles, 10min or a model time above 0")
    arguments.checkpoint = checkpoint


def run(deck: str | os.PathLike[str] | Deck, *, directory: str | os.PathLike[str] = ".", threads: int = 0,
        until: float | None = None, max_cycles: int | None = None, progress: Progress | None = None, case: int = 0,
        weld_tie: str = "", weld_law: str = "", checkpoint: str = "", stop_after: float | None = None,
        skip_unsupported: bool = False, precision: str = "double", subcycle: bool = False) -> Results:
    """Runs a deck as `nugget run` does, in this process, and gives its results. Other threads of Python go on
    meanwhile; a second run waits until the first has ended.

    `progress(time, end_time, cycle, energy_ratio, failed_welds)` is called at the start, five times a second and at the
    end of an explicit run. Where it gives False the run stops after that cycle, with a restart file: the results say
    `interrupted`, and nugget.resume() goes on. So it does where `progress` raises; that exception is raised again.
    Ctrl-C stops the run likewise and raises KeyboardInterrupt. `stop_after`: seconds of the clock. `precision`: single
    or double, `subcycle`: sub-cycling, as of `nugget run`.

    DeckError where the deck is refused; RunError where it ends in an error termination, with the folder; OSError
    where a result cannot be written.
    """
    if precision not in ("single", "double"):
        raise ValueError(f"precision '{precision}', expected single or double")
    path = _path_of(deck)
    _expect_one_case(path, case)
    arguments = _arguments(path, directory, threads, case, weld_tie, skip_unsupported)
    arguments.precision = precision
    arguments.subcycle = subcycle
    _put_ends(arguments, until, max_cycles, checkpoint, stop_after)
    arguments.weld_law = os.fspath(weld_law)
    return _Command(path, directory, case, skip_unsupported).end(*_nugget.run(arguments, progress))


def resume(directory: str | os.PathLike[str], *, threads: int = 0, until: float | None = None,
           max_cycles: int | None = None, progress: Progress | None = None, checkpoint: str = "",
           stop_after: float | None = None) -> Results:
    """Goes on with a run from the newest sound restart file in its folder, as run() does. RunError where there is none
    that this build of nugget, command or module, has written, or the deck has changed."""
    arguments = _arguments("", directory, threads, 0, "", False)
    _put_ends(arguments, until, max_cycles, checkpoint, stop_after)
    arguments.resume = os.fspath(directory)
    return _Command("", directory, 0, False).end(*_nugget.run(arguments, progress))


def modes(deck: str | os.PathLike[str] | Deck, *, directory: str | os.PathLike[str] = ".", count: int = 0,
          fmin: float = 0.0, fmax: float = 0.0, threads: int = 0, case: int = 0, weld_tie: str = "",
          skip_unsupported: bool = False) -> Results:
    """Natural modes of a deck as `nugget modes` finds them: `count` of them (0: as the deck says, else 20) between two
    frequencies [cycles/time] (0: the deck's). Raises as run() does."""
    path = _path_of(deck)
    _expect_one_case(path, case)
    arguments = _nugget.ModesArguments()
    arguments.run = _arguments(path, directory, threads, case, weld_tie, skip_unsupported)
    arguments.count, arguments.low, arguments.high = count, fmin, fmax
    return _Command(path, directory, case, skip_unsupported).end(*_nugget.modes(arguments))


def frf(deck: str | os.PathLike[str] | Deck, *, directory: str | os.PathLike[str] = ".", direct: bool = False,
        threads: int = 0, case: int = 0, weld_tie: str = "", skip_unsupported: bool = False) -> Results:
    """The frequency responses that a deck asks for, as `nugget frf` finds them: by modes, or `direct`, one solution for
    each frequency. Raises as run() does."""
    path = _path_of(deck)
    _expect_one_case(path, case)
    arguments = _arguments(path, directory, threads, case, weld_tie, skip_unsupported)
    return _Command(path, directory, case, skip_unsupported).end(*_nugget.frf(arguments, direct))


_COLUMNS = ("x", "y", "z", "diameter", "parts", "class")


def _points_text(points: Iterable[Sequence[float] | Mapping[str, Any]]) -> str:
    lines = [",".join(_COLUMNS)]
    for number, point in enumerate(points):
        named = dict(point) if isinstance(point, Mapping) else dict(zip("xyz", point))
        if unknown := set(named) - set(_COLUMNS):
            raise ValueError(f"point {number}: '{sorted(unknown)[0]}' is none of {', '.join(_COLUMNS)}")
        parts = named.get("parts", "")
        if not isinstance(parts, str):
            named["parts"] = "+".join(str(part) for part in parts)
        lines.append(",".join(str(named.get(column, "")) for column in _COLUMNS))
    return "\n".join(lines) + "\n"


def place_welds(points: str | os.PathLike[str] | Iterable[Sequence[float] | Mapping[str, Any]],
                deck: str | os.PathLike[str] | Deck, output: str | os.PathLike[str], *, form: str = "beam",
                diameter: float = 0.0, reach: float = 0.0, material: Mapping[str, float] | None = None,
                strength_diameter: float = 0.0, skip_unsupported: bool = False) -> Deck:
    """Places welds as `nugget weld` does, writes the deck `output`, which includes `deck`, and reads it. `points`: a
    list of spots (a csv or xMCF file), or rows x, y, z, or dictionaries with the columns of such a list: x, y, z, diameter,
    parts, class. `form`: beam, solid, solid4, solid8, solid16 or interpolation. `material`: fields of
    *MAT_SPOTWELD, or of an interpolation spot weld, for all welds.
    ValueError, with what the command prints, where none could be placed."""
    forms = _nugget.weld_forms()
    if form not in forms:
        raise ValueError(f"form '{form}', expected {', '.join(forms)}")
    path = _path_of(deck)
    with tempfile.TemporaryDirectory() as folder:
        if isinstance(points, (str, os.PathLike)):
            spots = os.fspath(points)
        else:
            spots = os.path.join(folder, "points.csv")
            pathlib.Path(spots).write_text(_points_text(points), encoding="utf-8")
        fields = [",".join(f"{name}={value}" for name, value in material.items())] if material else []
        code, text = _nugget.weld(spots, path, os.fspath(output), form, reach, diameter, fields, strength_diameter,
                                  skip_unsupported)
    if code == CANNOT_WRITE:
        raise OSError(text.strip())
    if code != NORMAL:
        raise ValueError(text.strip())
    return read(output, skip_unsupported=skip_unsupported)
