"""Recordings as NumPy has them: columns by name, read once and grown with the file."""
from __future__ import annotations

import atexit
import os
import weakref
from collections.abc import Iterable, Iterator, Mapping
from types import TracebackType
from typing import Any

import numpy as np
import numpy.typing as npt

from fyd import _fyd

Array = npt.NDArray[Any]

_opened: weakref.WeakSet[_fyd.RecordingFile] = weakref.WeakSet()


@atexit.register
def _close_all() -> None:
    """What is still open is closed while h5py's lock can be had, and kept: later, as modules go, it cannot. The compiled
    half keeps its exceptions, and so what they hold, for the life of the process. Units: none.
    """
    files = list(_opened)
    for file in files:
        file.close()
    setattr(_fyd.Error, "_closed_at_the_end", files)


def _known(name: str) -> None:
    if name not in _fyd.TELEMETRY_DTYPES:
        raise KeyError(f"{name}: telemetry has no such column; it has {', '.join(_fyd.TELEMETRY_NAMES)}")


class Columns(Mapping[str, Array]):
    """Arrays of one length by name, with their units."""

    def __init__(self, arrays: Mapping[str, Array], units: Mapping[str, str], help: Mapping[str, str]) -> None:
        """Units: those of `units`."""
        self._arrays = dict(arrays)
        self.units = dict(units)
        self.help = dict(help)

    def __getitem__(self, name: str) -> Array:
        return self._arrays[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._arrays)

    def __len__(self) -> int:
        return len(self._arrays)

    # As an object: a mapping compares its values by ==, of which an array has no one answer.
    __eq__ = object.__eq__
    __hash__ = object.__hash__

    def __repr__(self) -> str:
        return f"Columns({', '.join(f'{name} [{self.units[name]}]' for name in self)})"


class Telemetry(Mapping[str, Array]):
    """The telemetry of a recording: telemetry["force_N"] is an array with a value for each step.

    A column is read from the file when it is first asked for, once; after Recording.refresh() only its new rows are. The
    array is a read-only view of what was read: no copy, and one that is held keeps its length. NaN: no value.
    """

    def __init__(self, file: _fyd.RecordingFile) -> None:
        """Units: those of `units`."""
        self._file = file
        self._rows = file.info().rows
        self._kept: dict[str, tuple[Array, int]] = {}  # the memory, and how much of it is read
        self.units: dict[str, str] = dict(_fyd.TELEMETRY_UNITS)
        self.help: dict[str, str] = dict(_fyd.TELEMETRY_HELP)

    @property
    def rows(self) -> int:
        """How many steps each column has [1]"""
        return self._rows

    def load(self, names: Iterable[str] | None = None) -> Telemetry:
        """Reads these columns, or all, in one pass over the file: quicker than one by one. One name alone is one column.
        Units: those of `units`.
        """
        if isinstance(names, str):  # an iterable of letters otherwise
            names = [names]
        self._read(list(_fyd.TELEMETRY_NAMES if names is None else names))
        return self

    def _read(self, names: list[str]) -> dict[str, Array]:
        """These columns, all of one length: what refresh() finds meanwhile, in another thread, is the next read's."""
        for name in names:
            _known(name)
        rows = self._rows
        out: dict[str, Array] = {}
        taken: dict[str, tuple[Array, int]] = {}
        by_first: dict[int, list[str]] = {}  # columns may have been read at different times
        for name in dict.fromkeys(names):
            none = (np.empty(0, _fyd.TELEMETRY_DTYPES[name]), 0)
            memory, read = self._kept.get(name, none)
            if read < rows:
                # Taken out: a thread that asks meanwhile reads into memory of its own. No lock, for who waits for one may
                # hold h5py's, which the reading needs.
                memory, read = self._kept.pop(name, none)
            if memory.size < rows:
                # The first time as many as there are; a file that grows gets room for as many again.
                larger = np.empty(rows if read == 0 else max(rows, 2 * memory.size), memory.dtype)
                larger[:read] = memory[:read]
                memory = larger
            if read < rows:
                taken[name] = (memory, read)
                by_first.setdefault(read, []).append(name)
                # Read only but while it is read into: a view's `base` leads to it, and through it to all views.
                memory.flags.writeable = True
            out[name] = memory[:rows]
        try:
            for first, together in by_first.items():
                self._file.read_into(together, first, [out[name][first:] for name in together])
                for name in together:
                    taken[name] = (taken[name][0], rows)
        finally:
            for memory, _ in taken.values():
                memory.flags.writeable = False
            self._kept.update(taken)
        return out

    def __getitem__(self, name: str) -> Array:
        view = self._read([name])[name]
        view.flags.writeable = False
        return view

    def __contains__(self, name: object) -> bool:
        return name in _fyd.TELEMETRY_DTYPES

    def __iter__(self) -> Iterator[str]:
        return iter(_fyd.TELEMETRY_NAMES)

    def __len__(self) -> int:
        return len(_fyd.TELEMETRY_NAMES)

    # As Columns.
    __eq__ = object.__eq__
    __hash__ = object.__hash__

    def __repr__(self) -> str:
        return f"Telemetry({self._rows} rows of {len(self)} columns)"


class Recording:
    """A recording: whole, still growing in another process, or left behind by a crash. Only what was committed and whose
    checksum is right is read.

    `with fyd.open(path) as recording:` closes it at the end; the arrays that were read stay.
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        """Opens FILE or FILE.partial; FILE alone also finds FILE.partial beside it. Units: none."""
        self.path = os.fspath(path)
        self._file = _fyd.RecordingFile(os.fsencode(path))
        _opened.add(self._file)
        self._telemetry = Telemetry(self._file)
        self._started_ns = self._file.info().started_ns

    def __enter__(self) -> Recording:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"fyd.open({self.path!r})"

    def close(self) -> None:
        """Closes the file; the arrays that were read stay. Units: none."""
        self._file.close()

    def refresh(self) -> bool:
        """Takes in what was committed since; whether there was news. Arrays from before keep their length. Units: none."""
        news = self._file.refresh()
        self._telemetry._rows = self._file.info().rows
        return news

    @property
    def info(self) -> _fyd.RecordingInfo:
        """The summary, as of the last refresh [s] and [byte], in its names"""
        return self._file.info()

    @property
    def telemetry(self) -> Telemetry:
        """Columns by name, a value for each step [each in its unit]"""
        return self._telemetry

    @property
    def time_s(self) -> Array:
        """Time of each step, from the recording's start [s]"""
        time_s: Array = self.seconds(self._telemetry["now_ns"])
        return time_s

    def seconds(self, when_ns: Any) -> Any:
        """Time from the recording's start [s] for a time of the station's clock [ns], a number or an array."""
        return (when_ns - self._started_ns) * 1e-9

    @property
    def events(self) -> list[_fyd.EventRow]:
        """What the steps reported, in their order [each in its unit]"""
        return self._file.events()

    @property
    def event_columns(self) -> Columns:
        """The events as arrays [each in its unit]"""
        return Columns(self._file.event_columns(), _fyd.EventRow.units, _fyd.EventRow.help)

    @property
    def notes(self) -> list[_fyd.Note]:
        """Notes, bookmarks, trials' markers and alarms, in their order [s], in their names"""
        return self._file.notes()

    @property
    def link(self) -> Columns:
        """The robot's link, once a second [each in its unit]"""
        return Columns(self._file.link_columns(), _fyd.LinkRow.units, _fyd.LinkRow.help)

    @property
    def parameters(self) -> _fyd.Parameters:
        """The step's parameters at the first row [each in its unit]"""
        return self._file.parameters()

    def row_at(self, time_s: float) -> int:
        """The first row at or after time_s [s] from the recording's start; the number of rows when there is none."""
        return self._file.row_at(time_s)

    def step(self, row: int) -> _fyd.RecordedStep:
        """What went into the step of this row and what came out. Units: those of its values."""
        return self._file.step(row)

    def pipeline(self) -> _fyd.Pipeline:
        """The step as it stood before the first row. Stepped with the recorded inputs it gives what was recorded, bit for
        bit, where no row is lost (`info.gaps`, `info.why_not_exact`) and `info.arithmetic` is this library's; for other
        recordings replay() keeps the last inputs where some are lost, and tells what differs. Units: none.
        """
        return _fyd.Pipeline.of(self._file)

    def overview(self, name: str, from_s: float, to_s: float, buckets: int) -> tuple[Array, Array, Array]:
        """Smallest and largest of a column between from_s and to_s [s], in at most so many buckets, one or more: (start of
        each bucket [s], smallest, largest [the column's unit]). No spike is lost.
        """
        _known(name)
        start_s, low, high = self._file.overview(name, from_s, to_s, buckets)
        return start_s, low, high

    def picture(self, index: int) -> _fyd.Picture:
        """A picture by its number in the recording, from 0. Units: [s], [px]."""
        return self._file.picture(index)

    def picture_at(self, time_s: float) -> _fyd.Picture:
        """The newest picture at time_s [s] from the recording's start."""
        return self._file.picture_at(time_s)

    def replay(self, settings: Mapping[str, Any] | None = None, *, closed_loop: bool = False,
               keep_telemetry: bool = True) -> _fyd.ReplayResult:
        """Runs it through the step again: unchanged, which proves the outputs bit for bit, or with other parameters
        (`settings`, id to value). closed_loop: motors and load cell react to the new commands. keep_telemetry: whether
        `telemetry` of the result has the replayed columns. Other threads go on meanwhile. Units: those of the columns.
        """
        if settings is not None and not hasattr(settings, "keys"):
            raise TypeError(f"settings: {settings!r}: expected a mapping of id to value")
        return _fyd.replay(self._file, dict(settings or {}), closed_loop, keep_telemetry)


def open(path: str | os.PathLike[str]) -> Recording:
    """Opens a recording, FILE or FILE.partial; FILE alone also finds FILE.partial beside it. Units: none."""
    return Recording(path)


def replay(recording: Recording, settings: Mapping[str, Any] | None = None, *, closed_loop: bool = False,
           keep_telemetry: bool = True) -> _fyd.ReplayResult:
    """As Recording.replay. Units: those of the columns."""
    if not isinstance(recording, Recording):
        raise TypeError(f"{recording!r}: expected a Recording, as fyd.open gives it")
    return recording.replay(settings, closed_loop=closed_loop, keep_telemetry=keep_telemetry)
