"""A recording that another process is still making."""
import os
import subprocess
import time

import h5py
import numpy as np
import pytest
from conftest import PATIENCE_s

import fyd


def wait_for(what, holds):
    end = time.monotonic() + PATIENCE_s
    while not (found := holds()):
        assert time.monotonic() < end, f"waited for {what} in vain"
        time.sleep(0.05)
    return found


def opened(path):
    try:
        return fyd.open(path)
    except fyd.Error:
        return None


def test_columns_grow_with_the_file(tmp_path):
    path = tmp_path / "growing.h5"
    recorder = subprocess.Popen([os.environ["FYD"], "station", "--simulate", "--duration", "8", "--record", path],
                                stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    recording = wait_for("a first commit", lambda: opened(path))
    assert recording.info.wholeness == fyd.Wholeness.growing
    force = recording.telemetry["force_N"]
    before = force.copy()
    lengths = [len(force)]
    wait_for("more rows", lambda: recording.refresh() and len(recording.telemetry["force_N"]) > lengths[0])
    lengths.append(len(recording.telemetry["force_N"]))
    late = recording.telemetry["finger_age_ms"]  # first asked for now
    assert len(late) == recording.telemetry.rows >= lengths[1]
    # What was held keeps its length and its values.
    assert len(force) == lengths[0] and np.array_equal(force, before, equal_nan=True)

    assert recorder.wait(PATIENCE_s) == 0, recorder.stderr.read()
    wait_for("its end", lambda: recording.refresh() or recording.info.wholeness == fyd.Wholeness.whole)
    assert recording.info.wholeness == fyd.Wholeness.whole
    with h5py.File(path) as file:
        theirs = file["telemetry"][:]
    assert recording.telemetry.rows == len(theirs) > lengths[1]
    for name in theirs.dtype.names:  # some grown, some read at once
        assert recording.telemetry[name].tobytes() == theirs[name].tobytes()
    assert np.array_equal(force, before, equal_nan=True)


def counting(rows):
    """A file whose column holds its rows' numbers, and of which `meanwhile` happens as it is read."""
    file = type("File", (), {"reads": 0})()
    file.meanwhile = lambda: None
    file.info = lambda: type("Info", (), {"rows": rows})()

    def read_into(names, first, arrays):
        file.reads += 1
        file.meanwhile()
        for array in arrays:
            array[:] = np.arange(first, first + len(array))

    file.read_into = read_into
    return file


def test_a_refresh_while_a_column_is_read_leaves_no_row_unread():
    """As from another thread: reading gives up the interpreter's lock."""
    file = counting(rows=5)
    telemetry = fyd.Telemetry(file)

    def refreshed():
        telemetry._rows = 9

    file.meanwhile = refreshed
    assert telemetry["force_N"].tolist() == list(range(5))
    assert telemetry["force_N"].tolist() == list(range(9))
    assert telemetry.rows == 9 and file.reads == 2


def test_a_column_that_two_threads_ask_for_is_right_in_both():
    file = counting(rows=5)
    telemetry, inner = fyd.Telemetry(file), []

    def asked_too():
        file.meanwhile = lambda: None
        telemetry._rows = 9
        inner.append(telemetry["force_N"])

    file.meanwhile = asked_too
    assert telemetry["force_N"].tolist() == list(range(5))
    assert inner[0].tolist() == telemetry["force_N"].tolist() == list(range(9))


def test_what_could_not_be_read_is_read_the_next_time():
    file = counting(rows=5)
    telemetry = fyd.Telemetry(file)
    first = telemetry["force_N"]
    telemetry._rows = 9

    def fails():
        raise fyd.Error("the disk is gone")

    file.meanwhile = fails
    with pytest.raises(fyd.Error, match="gone"):
        _ = telemetry["force_N"]
    file.meanwhile = lambda: None
    assert not first.base.flags.writeable
    assert telemetry["force_N"].tolist() == list(range(9)) and first.tolist() == list(range(5))
    assert not telemetry["force_N"].base.flags.writeable


def test_a_column_is_not_copied_for_each_refresh(tmp_path, monkeypatch):
    """Its memory doubles, so that growing costs a copy for each doubling, not for each refresh."""
    file = type("File", (), {"rows": 0, "reads": 0})()
    file.info = lambda: type("Info", (), {"rows": file.rows})()

    def read_into(names, first, arrays):
        file.reads += 1
        arrays[0][:] = np.arange(first, first + len(arrays[0]))

    file.read_into = read_into
    telemetry = fyd.Telemetry(file)
    memories = set()
    for rows in range(1, 1001):
        file.rows = telemetry._rows = rows
        column = telemetry["force_N"]
        assert column[-1] == rows - 1 and len(column) == rows
        memories.add(column.__array_interface__["data"][0])
        if rows == 10:
            held = column
    assert file.reads == 1000 and len(memories) <= 12
    assert held.tolist() == list(range(10))
