# SPDX-License-Identifier: Apache-2.0
"""Results of a run, read from its folder."""
from __future__ import annotations

import csv
import dataclasses
import functools
import html
import json
import os
import pathlib
from typing import Any, Callable, Iterator, Sequence, overload

import numpy as np

from . import _nugget
from ._arrays import Array
from ._elements import Elements
from ._pictures import Picture, picture_of, plot_channels
from ._table import WeldTable


@dataclasses.dataclass(frozen=True)
class Channel:
    """One quantity of one entity over the times of its history."""

    entity: str  #: `weld 50002`, `node 17`; empty where the file is of the whole model
    title: str  #: of the entity, where the file has a legend
    quantity: str  #: `axial`, `x_force`, `internal_energy`
    unit: str  #: `N`; empty where the units are not known
    values: Array  #: one for each time

    def _is_of(self, entity: int | str) -> bool:
        return str(entity) in (self.entity, self.entity.rpartition(" ")[2], self.title)


class History:
    """A history file of a run: `glstat`, `swforc`, ...

        swforc = r.history("swforc")
        swforc.times                    # one for each state
        swforc[50002, "axial"]          # by the entity's id, its name ("weld 50002") or its title
        glstat["kinetic_energy"]        # where the file is of the whole model
        swforc.of_all("axial")          # a column for each of swforc.entities
    """

    def __init__(self, name: str, times: Array, channels: Sequence[Channel]) -> None:
        self.name = name
        self.times = times
        self.channels = list(channels)

    @property
    def entities(self) -> list[str]:
        """What it holds values of: `weld 50001`, `weld 50002`, ...; empty for one of the whole model."""
        return [name for name in dict.fromkeys(c.entity for c in self.channels) if name]

    @property
    def quantities(self) -> list[str]:
        return list(dict.fromkeys(c.quantity for c in self.channels))

    def unit(self, quantity: str) -> str:
        """Of a quantity, `N`; empty for a number, and where the units of the deck are not known."""
        return self._found(self.channels, quantity)[0].unit

    def __getitem__(self, key: str | tuple[int | str, str]) -> Array:
        if isinstance(key, str):
            found = self._found(self.channels, key)
            if len(found) > 1:
                raise LookupError(f"{self.name} has {key} of {len(found)} entities: give one, as in "
                                  f"[{found[0].entity.rpartition(' ')[2]}, '{key}'], or of_all('{key}')")
            return found[0].values
        entity, quantity = key
        of_entity = [c for c in self.channels if c._is_of(entity)]
        if not of_entity:
            raise LookupError(f"{self.name} has no entity '{entity}'; there are: {', '.join(self.entities) or 'none'}")
        return self._found(of_entity, quantity)[0].values

    def of_all(self, quantity: str) -> Array:
        """A row for each time and a column for each of `entities`; NaN where an entity lacks the quantity."""
        found = {c.entity: c.values for c in self._found(self.channels, quantity)}
        missing = np.full(len(self.times), np.nan)
        return np.column_stack([found.get(entity, missing) for entity in self.entities or [""]])

    def _found(self, channels: list[Channel], quantity: str) -> list[Channel]:
        found = [c for c in channels if c.quantity == quantity]
        if not found:
            names = dict.fromkeys(c.quantity for c in channels)
            raise LookupError(f"{self.name} has no quantity '{quantity}'; there are: {', '.join(names)}")
        return found

    def __repr__(self) -> str:
        return f"<{self.name}: {len(self.times)} times, {len(self.entities)} entities, {', '.join(self.quantities)}>"


@dataclasses.dataclass(frozen=True)
class ShellState:
    """Shells at one time, in the order of States.shells. Stresses xx yy zz xy yz zx in global axes."""

    stress: Array  #: shell, layer, component; layers as d3plot has them: middle, bottom, top where there are 3
    plastic_strain: Array  #: shell, layer
    thickness: Array
    deleted: Array  #: bools
    internal_energy: Array  #: per volume
    mx: Array  #: bending moments per length, in the shell's axes
    my: Array
    mxy: Array
    qx: Array  #: transverse shear per length
    qy: Array
    nx: Array  #: membrane forces per length
    ny: Array
    nxy: Array


@dataclasses.dataclass(frozen=True)
class SolidState:
    """Bricks at one time, in the order of States.solids. Stresses xx yy zz xy yz zx in global axes."""

    stress: Array  #: solid, component
    plastic_strain: Array
    deleted: Array  #: bools


@dataclasses.dataclass(frozen=True)
class BeamState:
    """Beams, weld beams among them, at one time, in the order of States.beams."""

    axial: Array  #: forces, in the beam's axes
    shear_s: Array
    shear_t: Array
    moment_s: Array
    moment_t: Array
    torsion: Array
    deleted: Array  #: bools


@dataclasses.dataclass(frozen=True)
class State:
    """The model at one time. Arrays of nodes are in the order of States.node_ids, in single precision as d3plot is."""

    time: float
    coordinates: Array
    displacement: Array
    velocity: Array
    acceleration: Array
    shells: ShellState
    solids: SolidState
    beams: BeamState


class _Family:
    """What d3plot and d3eigv have alike: the model."""

    def __init__(self, directory: pathlib.Path, modes: bool) -> None:
        self._file = _nugget.D3plot(str(directory), modes)
        geometry = self._file.geometry()
        self._times: Array = geometry["times"]
        self.title: str = geometry["title"]
        self.node_ids: Array = geometry["node_ids"]  #: ascending
        self.coordinates: Array = geometry["coordinates"]  #: at the start; a row for each node
        self.parts: dict[int, str] = geometry["parts"]  #: title by id
        self.shells = Elements(*geometry["shells"], node_ids=self.node_ids)
        self.solids = Elements(*geometry["solids"], node_ids=self.node_ids)
        self.beams = Elements(*geometry["beams"], node_ids=self.node_ids)

    def node(self, node_id: int) -> int:
        """Where a node stands in arrays of nodes, by its id."""
        place = int(np.searchsorted(self.node_ids, node_id))
        if place == len(self.node_ids) or self.node_ids[place] != node_id:
            raise LookupError(f"there is no node {node_id}")
        return place


class States(_Family, Sequence[State]):
    """The states of d3plot: `states.times`, `states[0]`, `states[-1]`, `for state in states`. Each is read when it is
    asked for."""

    def __init__(self, directory: pathlib.Path) -> None:
        super().__init__(directory, modes=False)

    @property
    def times(self) -> Array:
        return self._times

    def __len__(self) -> int:
        return len(self._times)

    @overload
    def __getitem__(self, number: int) -> State: ...
    @overload
    def __getitem__(self, number: slice) -> list[State]: ...
    def __getitem__(self, number: int | slice) -> State | list[State]:
        if isinstance(number, slice):
            return [self[i] for i in range(*number.indices(len(self)))]
        at = number + len(self) if number < 0 else number
        if not 0 <= at < len(self):
            raise IndexError(f"there is no state {number}: there are {len(self)}")
        read = self._file.state(at)
        return State(time=read["time"], coordinates=read["coordinates"],
                     displacement=read["coordinates"] - self.coordinates, velocity=read["velocity"],
                     acceleration=read["acceleration"], shells=ShellState(**read["shells"]),
                     solids=SolidState(**read["solids"]), beams=BeamState(**read["beams"]))

    def at(self, time: float) -> State:
        """The state whose time is nearest."""
        return self[int(np.argmin(np.abs(self._times - time)))]

    def __repr__(self) -> str:
        return f"<{len(self)} states of {len(self.node_ids)} nodes, {len(self.shells)} shells, " \
               f"{len(self.solids)} solids, {len(self.beams)} beams>"


class Modes(_Family):
    """Natural modes, from summary.json and d3eigv."""

    def __init__(self, directory: pathlib.Path, reports: list[dict[str, Any]]) -> None:
        super().__init__(directory, modes=True)
        #: of each mode [Hz]
        self.frequencies = np.array([report["frequency_hz"] for report in reports], dtype=float)
        #: a row for each mode: factors, and masses, of translations x y z and rotations x y z
        self.participation = np.array([report["participation"] for report in reports], dtype=float)
        self.effective_mass = np.array([report["effective_mass"] for report in reports], dtype=float)

    def __len__(self) -> int:
        return len(self.frequencies)

    @functools.cached_property
    def shapes(self) -> Array:
        """mode, node, x y z: displacements as d3eigv has them. It holds coordinates in single precision, so that they
        are exact to some 1e-7 of the model's size."""
        return np.stack([self._file.state(i)["coordinates"] - self.coordinates for i in range(len(self._times))])


@dataclasses.dataclass(frozen=True)
class Response:
    """One response over frequency: a row for each frequency."""

    name: str  #: `node 17 z`, or the panel of radiated power
    quantity: str  #: `acceleration`, `power`
    frequencies: Array
    amplitude: Array
    phase: Array  #: degrees; NaN of radiated power
    values: Array  #: complex; of radiated power the amplitude
    case: int = 0  #: of several load cases, from 1


def _rows(path: pathlib.Path) -> list[dict[str, str]]:
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def _numbers(rows: list[dict[str, str]], column: str) -> Array:
    return np.array([float(row[column]) if row[column] else np.nan for row in rows])


def _groups(rows: list[dict[str, str]],
            columns: Sequence[str]) -> Iterator[tuple[tuple[str, ...], list[dict[str, str]]]]:
    groups: dict[tuple[str, ...], list[dict[str, str]]] = {}
    for row in rows:
        groups.setdefault(tuple(row.get(column, "") for column in columns), []).append(row)
    yield from groups.items()


def _responses(path: pathlib.Path) -> list[Response]:
    columns = ("node", "direction", "response", "case")
    return [Response(name=f"node {node} {direction}", quantity=quantity, frequencies=_numbers(rows, "frequency"),
                     amplitude=_numbers(rows, "amplitude"), phase=_numbers(rows, "phase"),
                     values=_numbers(rows, "real") + 1j * _numbers(rows, "imaginary"), case=int(case or 0))
            for (node, direction, quantity, case), rows in _groups(_rows(path), columns)]


def _powers(path: pathlib.Path) -> list[Response]:
    out = []
    for (panel,), rows in _groups(_rows(path), ("panel",)):
        power = _numbers(rows, "power")
        out.append(Response(name=panel, quantity="power", frequencies=_numbers(rows, "frequency"), amplitude=power,
                            phase=np.full(len(power), np.nan), values=power.astype(complex)))
    return out


class Results:
    """What a run left in a folder. Each file is read when it is first asked for."""

    def __init__(self, directory: str | os.PathLike[str]) -> None:
        self.directory = pathlib.Path(directory)
        try:
            #: summary.json, see docs/reference/contract.md
            self.summary: dict[str, Any] = json.loads((self.directory / "summary.json").read_text(encoding="utf-8"))
        except (OSError, ValueError) as error:
            raise FileNotFoundError(f"{self.directory} holds no results of a run: there is no summary.json that can be "
                                    f"read ({error})") from None

    @property
    def termination(self) -> str:
        """`normal`, `error` or `interrupted`."""
        return str(self.summary["termination"])

    @property
    def units(self) -> str:
        """`mm, t, s`; empty where they are not known."""
        return str(self.summary["units"])

    @property
    def second(self) -> float | None:
        """One second in the run's unit of time; None where its units are not known."""
        return _nugget.second_in(self.units)

    @functools.cached_property
    def findings(self) -> list[_nugget.Finding]:
        """What was found in the deck (findings.json)."""
        path = self.directory / "findings.json"
        if not path.exists():
            return []
        return [_nugget.Finding(**each) for each in json.loads(path.read_text(encoding="utf-8"))]

    @functools.cached_property
    def welds(self) -> WeldTable:
        """welds.csv, by column."""
        path = self.directory / "welds.csv"
        return WeldTable(path.read_text(encoding="utf-8") if path.exists() else "")

    @property
    def histories(self) -> list[str]:
        """Names of the histories that are there and can be read."""
        return _nugget.histories_in(str(self.directory))

    def history(self, name: str) -> History:
        """A history file by its name, from binout or as text, whichever there is."""
        read = _nugget.read_history(str(self.directory), name, self.units)
        if read is None:
            raise LookupError(f"{self.directory} has no history '{name}' that can be read; there are: "
                              f"{', '.join(self.histories) or 'none'} [*DATABASE_{name.upper()} asks for one]")
        times, channels = read
        return History(name, times, [Channel(*each) for each in channels])

    def states(self) -> States:
        """The states of d3plot."""
        self._expect("d3plot", "*DATABASE_BINARY_D3PLOT asks for states")
        return States(self.directory)

    def modes(self) -> Modes:
        """Natural modes: frequencies and shapes."""
        self._expect("d3eigv", "`nugget modes`, or *CONTROL_IMPLICIT_EIGENVALUE, leaves it")
        return Modes(self.directory, self.summary["modes"])

    def frf(self) -> list[Response]:
        """Frequency response functions (frf.csv)."""
        self._expect("frf.csv", "*FREQUENCY_DOMAIN_FRF asks for them")
        return _responses(self.directory / "frf.csv")

    def ssd(self) -> list[Response]:
        """Steady-state responses (ssd.csv)."""
        self._expect("ssd.csv", "*FREQUENCY_DOMAIN_SSD asks for them")
        return _responses(self.directory / "ssd.csv")

    def erp(self) -> list[Response]:
        """Radiated power, by panel (erp.csv)."""
        self._expect("erp.csv", "*FREQUENCY_DOMAIN_SSD_ERP asks for it")
        return _powers(self.directory / "erp.csv")

    @property
    def channels(self) -> str:
        """What plot() can show: a list, file by file, of entities, quantities with units, times or frequencies."""
        return _nugget.channels(str(self.directory))

    def plot(self, *channels: str, over: str = "", cfc: int = 0,
             other: str | os.PathLike[str] | Results = "") -> Picture:
        """Curves of histories and responses as a plot: `swforc/50002/axial`, `glstat/*energy`, `frf`; FILE,
        FILE/QUANTITY, FILE/ENTITY or FILE/ENTITY/QUANTITY with the wildcards * and ?. Those of one unit share their
        axes. `over`: a channel that takes the place of time. `cfc`: filtered to that class of SAE J211. `other`:
        another run, whose curves are drawn too. LookupError, with what there is, for a name that finds nothing."""
        if not channels:
            raise ValueError(f"plot() needs a channel; there are:\n{self.channels}")
        _expect_class(cfc, or_none=True)
        directory = other.directory if isinstance(other, Results) else other
        return plot_channels(str(self.directory), channels, over, cfc, os.fspath(directory))

    def picture(self, *, field: str = "", state: int | None = None, time: float | None = None, weld: int = 0,
                parts: Sequence[int] = (), view: tuple[float, float, float] = (0.6, -0.7, 0.45),
                up: tuple[float, float, float] = (0.0, 0.0, 1.0), scale: float = 1.0,
                range: tuple[float, float] | None = None, edges: bool = True, shapes: bool = False,
                width: int = 1440, height: int = 960) -> Picture:
        """The model at a state of d3plot, or a natural mode. `state`: from 1, or the mode; `time`: the state nearest to
        it; neither: the last. `field`: plastic_strain, von_mises_stress, thickness, damage, displacement or part.
        `weld`: the id of one to look at from near. `view`: from the model to the eye. `scale`: of displacements.
        `range`: of the colours. `shapes`: facets as shapes that can be scaled, as `nugget picture` writes to an .svg,
        instead of pixels. LookupError for what is not there."""
        if field and field not in _nugget.picture_fields():
            raise ValueError(f"field '{field}', expected {', '.join(_nugget.picture_fields())}")
        if state is not None and time is not None:
            raise ValueError("give a state or a time, not both")
        options = _nugget.PictureOptions()
        options.field, options.weld, options.parts, options.scale = field, weld, list(parts), scale
        options.edges, options.shapes, options.width, options.height = edges, shapes, width, height
        options.state = state or 0
        options.time = np.inf if time is None else time
        options.range = range or (0.0, 0.0)
        options.look_towards(view)
        options.put_up(up)
        return picture_of(str(self.directory), options)

    def sae_filter(self, times: Array, values: Array, cfc: int) -> tuple[Array, Array]:
        """sae_filter() of a history of this run."""
        if self.second is None:
            raise ValueError(f"the units of {self.directory} are not known, so that nothing says how long a second is: "
                             f"give it, nugget.sae_filter(times, values, cfc, second)")
        return sae_filter(times, values, cfc, self.second)

    def _expect(self, name: str, remedy: str) -> None:
        if not (self.directory / name).exists():
            raise LookupError(f"{self.directory} has no {name} [{remedy}]")

    def __repr__(self) -> str:
        return f"<results in {self.directory}: {self.termination} termination, time {self.summary['time']:g}, " \
               f"{self.summary['cycles']} cycles>"

    def _repr_html_(self) -> str:
        """What a notebook shows: how the run ended, the model, its energies or its responses, as far as they are there."""
        shown = [f"<p><b>{html.escape(self.summary.get('title') or self.summary['deck'])}</b>: {self.termination} termination"
                 f"{'; ' + html.escape(self.summary['message']) if self.summary['message'] else ''}; {self.welds.count} welds</p>"]
        energies = ("glstat/kinetic_energy", "glstat/internal_energy", "glstat/total_energy")
        pictures: tuple[Callable[[], Picture], ...] = (lambda: self.picture(width=900, height=600),
                                                       lambda: self.plot(*energies), lambda: self.plot("frf"))
        for make in pictures:
            try:
                shown.append(make().svg)
            except LookupError:
                continue
        return "\n".join(shown)


def results(directory: str | os.PathLike[str]) -> Results:
    """The results that a run left in a folder. FileNotFoundError where there are none."""
    return Results(directory)


def _expect_class(cfc: int, or_none: bool = False) -> None:
    classes = _nugget.channel_classes
    if cfc not in classes and not (or_none and cfc == 0):
        raise ValueError(f"channel frequency class {cfc}, expected {', '.join(map(str, classes))}")


def sae_filter(times: Array, values: Array, cfc: int, second: float, *,
               before: float = 0.0) -> tuple[Array, Array]:
    """Times and values of a history filtered to a channel frequency class of SAE J211-1 (60, 180, 600 or 1000): -3 dB
    at 5/3 of the class in hertz, no shift of phase. `second`: one second in the unit of `times`. `before`: the value
    until the first time. The times that come back are evenly spaced, as many. ValueError where times do not ascend, are
    fewer than three or lie too far apart for the class."""
    _expect_class(cfc)
    if len(times) != len(values):
        raise ValueError(f"{len(times)} times and {len(values)} values")
    try:
        return _nugget.sae_filter(times, values, cfc, second, before)
    except RuntimeError as error:
        raise ValueError(str(error)) from None
