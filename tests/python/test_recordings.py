"""A recording read by the module and by h5py, which knows nothing of it: the same to the bit."""
import math
import os
import struct
import subprocess
import sys
import zlib

import h5py
import numpy as np
import pytest
from conftest import GOLDEN, changed_copy, program

import fyd


def read_by_h5py(path, table):
    with h5py.File(path, "r") as file:
        units = [unit.decode() for unit in file[table].attrs["units"]]
        rows = file[table][:]
        return rows, dict(zip(rows.dtype.names, units))


def assert_same_bits(ours, theirs):
    """Flags are bool here and a byte there; every other type is the same."""
    assert ours.dtype == theirs.dtype or (ours.dtype == bool and theirs.dtype == np.uint8)
    assert ours.tobytes() == np.ascontiguousarray(theirs).tobytes()


def assert_reads_as_h5py(path):
    theirs, units = read_by_h5py(path, "telemetry")
    with fyd.open(path) as recording:
        telemetry = recording.telemetry
        assert set(theirs.dtype.names) <= set(telemetry)
        for name in theirs.dtype.names:
            assert_same_bits(telemetry[name], theirs[name])
            assert telemetry.units[name] == units[name]
        assert telemetry.rows == len(theirs) == recording.info.rows
        together = fyd.open(path).telemetry.load()
        for name in theirs.dtype.names:
            assert_same_bits(together[name], theirs[name])


def test_a_path_with_a_null_byte_is_no_other_files_path():
    for opened in (fyd.open, fyd.Mesh.open, fyd.Scene.open):
        with pytest.raises(ValueError, match="null byte"):
            opened("classic.h5\0more")


def test_a_golden_recording_reads_as_h5py_reads_it(golden):
    assert_reads_as_h5py(golden)


def test_a_fresh_recording_reads_as_h5py_reads_it(session):
    assert_reads_as_h5py(session)
    theirs, _ = read_by_h5py(session, "telemetry")
    with fyd.open(session) as recording:
        assert set(theirs.dtype.names) == set(recording.telemetry)  # nothing of today's is missing in it
        assert recording.info.operator == "Zoë"
        assert recording.info.missing_columns == []


def test_events_are_those_of_the_file(golden):
    theirs, units = read_by_h5py(golden, "events")
    with fyd.open(golden) as recording:
        columns = recording.event_columns
        assert len(theirs) > 0
        for name in theirs.dtype.names:
            if name == "index":  # counted as this program counts its parameters
                continue
            assert_same_bits(columns[name], theirs[name])
            assert columns.units[name] == units[name]
        assert [int(event.kind) for event in recording.events] == theirs["kind"].tolist()
        assert [event.when_ns for event in recording.events] == theirs["when_ns"].tolist()


def test_notes_are_those_of_the_file():
    with h5py.File(GOLDEN / "changes.h5") as file:
        index = file["notes/index"][:]
        text = file["notes/text"][:].tobytes()
        started = file.attrs["started_ns"]
    with fyd.open(GOLDEN / "changes.h5") as recording:
        notes = recording.notes
    assert len(notes) == len(index) > 1
    for note, row in zip(notes, index):
        assert note.text == text[row["text_start"]:row["text_start"] + row["text_bytes"]].decode()
        assert int(note.kind) == row["kind"]
        assert note.time_s == pytest.approx((int(row["when_ns"]) - int(started)) * 1e-9, abs=1e-9)
    assert {note.kind for note in notes} == {fyd.NoteKind.note, fyd.NoteKind.bookmark}


def test_the_link_is_that_of_the_file(session):
    theirs, units = read_by_h5py(session, "link")
    with fyd.open(session) as recording:
        for name in theirs.dtype.names:
            assert_same_bits(recording.link[name], theirs[name])
            assert recording.link.units[name] == units[name]


def test_what_is_asked_for_twice_is_the_same_memory(classic):
    first, second = classic.telemetry["force_N"], classic.telemetry["force_N"]
    assert np.shares_memory(first, second)
    assert first.flags.c_contiguous and not first.flags.writeable
    with pytest.raises(ValueError):
        first[0] = 1.0


def test_nobody_writes_into_a_column_by_its_base(classic):
    """It is in everybody's hands: who asks next gets the same memory."""
    first = classic.telemetry["force_N"]
    before = first[0]
    assert not first.base.flags.writeable
    with pytest.raises(ValueError):
        first.base[0] = 99
    with pytest.raises(ValueError):
        first.flags.writeable = True
    assert classic.telemetry["force_N"][0] == before or math.isnan(before)
    assert all(not each.base.flags.writeable for each in classic.telemetry.load().values())


def test_one_name_is_one_column(classic):
    assert classic.telemetry.load("force_N") is classic.telemetry
    with pytest.raises(KeyError, match="force_lbs: telemetry has no such column"):
        classic.telemetry.load("force_lbs")


def test_recordings_are_compared_as_objects(classic):
    with fyd.open(GOLDEN / "classic.h5") as other:
        assert classic.telemetry == classic.telemetry and classic.telemetry != other.telemetry
        assert classic.telemetry != dict(other.telemetry) and len({classic.telemetry, other.telemetry}) == 2
    columns = classic.event_columns
    assert columns == columns and columns != classic.event_columns and len({columns}) == 1


def test_arrays_stay_when_the_file_is_closed():
    with fyd.open(GOLDEN / "classic.h5") as recording:
        force = recording.telemetry["force_N"]
        before = force.copy()
    assert np.array_equal(force, before, equal_nan=True)
    with pytest.raises(fyd.Error, match="classic.h5: is closed"):
        _ = recording.telemetry["finger_x_mm"]
    recording.close()  # once more does nothing


def test_what_is_open_at_the_end_says_nothing():
    program = f"import h5py, fyd; open = fyd.open({str(GOLDEN / 'classic.h5')!r}); open.telemetry['force_N']"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


def test_a_flag_selects_rows(classic):
    contact = classic.telemetry["contact"]
    assert contact.dtype == bool
    assert len(classic.telemetry["force_N"][contact]) == np.count_nonzero(contact) > 0


def test_time_counts_from_the_start(classic):
    time_s = classic.time_s
    assert time_s[0] == 0.0
    assert time_s[-1] == pytest.approx(classic.info.duration_s, abs=1e-9)
    assert "start to its last row" in fyd.RecordingInfo.duration_s.__doc__
    row = classic.row_at(0.5)
    assert row == np.searchsorted(time_s, 0.5)
    assert classic.row_at(1e9) == classic.info.rows
    with pytest.raises(fyd.Error, match="NaN"):
        classic.row_at(float("nan"))


def test_rows_are_chosen_by_the_names_of_their_numbers(classic):
    state, kind = classic.telemetry["state"], classic.event_columns["kind"]
    active = state == fyd.SafetyState.active
    assert active.dtype == bool and active.any() and not active.all()
    assert np.array_equal(active, state == int(fyd.SafetyState.active)) and np.array_equal(~active, state != fyd.SafetyState.active)
    assert np.array_equal(active, np.isin(state, [fyd.SafetyState.active])) and (fyd.SafetyState.active == state).sum() == active.sum()
    assert (kind == fyd.EventKind.state_changed).any() and fyd.Fault.none == 0 == fyd.Fault.none
    assert state[active][0] == fyd.SafetyState.active and {fyd.SafetyState.active: 1}[fyd.SafetyState.active] == 1
    for another in ("active", None, 1.5, fyd.LinkPhase.paused, fyd.SafetyState):
        assert fyd.SafetyState.active != another and not fyd.SafetyState.active == another
    assert int(fyd.LinkPhase.paused) == int(fyd.SafetyState.active)
    stored = (fyd.SafetyState, fyd.LinkPhase, fyd.OperatorAction, fyd.RobotCommand, fyd.FingerReason, fyd.NoteKind,
              fyd.Fault, fyd.EventKind)
    assert all("files store the number" in each.__doc__ for each in stored)
    for each in (value for enum in stored for value in enum.__members__.values()):
        assert each == int(each) and not each != int(each) and each != int(each) + 1 and np.uint8(int(each)) == each


def test_an_overview_loses_no_spike(classic):
    touch = classic.telemetry["touch_z_mm"]
    for wrong, named in (((0.0, 10.0, 0), "buckets: 0"), ((10.0, 0.0, 20), "from_s: 10; expected at most to_s = 0"),
                         ((math.nan, 1.0, 20), "from_s: nan")):
        with pytest.raises(fyd.InvalidValue, match=named):
            classic.overview("touch_z_mm", *wrong)
    with pytest.raises(KeyError, match="nope: telemetry has no such column; it has "):
        classic.overview("nope", 0.0, 10.0, 20)
    start_s, low, high = classic.overview("touch_z_mm", 0.0, 10.0, 20)
    assert 0 < len(start_s) <= 20
    assert low.min() == touch.min() and high.max() == touch.max()


def test_a_step_has_its_inputs(classic):
    with h5py.File(GOLDEN / "classic.h5") as file:
        steps, bridge = file["inputs/steps"][:], file["inputs/bridge"][:]
    row = 700
    step = classic.step(row)
    assert step.inputs.now_ns == steps["now_ns"][row]
    assert step.inputs.bridge.value_mV_per_V == bridge["value_mV_per_V"][steps["bridge_row"][row]]
    assert step.telemetry.force_N == classic.telemetry["force_N"][row]
    assert step.telemetry.units["force_N"] == "N"


# -- pictures ------------------------------------------------------------------------------------------------------

def decode_png(data):
    """Grey, 8 bits, not interlaced [RFC 2083], written here."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colour, _, _, interlaced = struct.unpack(">IIBBBBB", body)
            assert (depth, colour, interlaced) == (8, 0, 0)
        packed += body if kind == b"IDAT" else b""
        at += 12 + length
    raw, out = zlib.decompress(packed), np.zeros((height, width), np.int64)
    for y in range(height):
        how, line = raw[y * (width + 1)], raw[y * (width + 1) + 1:(y + 1) * (width + 1)]
        for x, byte in enumerate(line):
            left = out[y, x - 1] if x else 0
            up = out[y - 1, x] if y else 0
            corner = out[y - 1, x - 1] if x and y else 0
            paeth = min((left, up, corner), key=lambda each: abs(left + up - corner - each))
            out[y, x] = (byte + (0, left, up, (left + up) // 2, paeth)[how]) % 256
    return out.astype(np.uint8)


def test_a_picture_is_the_file_s_to_the_pixel(classic):
    with h5py.File(GOLDEN / "classic.h5") as file:
        index, stored = file["camera/index"][5], file["camera/bytes"]
        start = int(index["bytes_start"]) + int(index["whole_bytes"])
        region = decode_png(stored[start:start + int(index["region_bytes"])].tobytes())
    picture = classic.picture(5)
    assert np.array_equal(picture.region, region)
    x, y, width, height = picture.region_px
    assert np.array_equal(picture.whole[y:y + height, x:x + width], region)
    assert (width, height) == (index["region_width_px"], index["region_height_px"])
    assert picture.finger.x_mm == index["x_mm"]
    assert classic.picture_at(picture.time_s).number == picture.number
    with pytest.raises(fyd.Error, match="1000"):
        classic.picture(1000)


# -- what is no recording ------------------------------------------------------------------------------------------

def test_a_file_that_is_not_there_is_named(tmp_path):
    with pytest.raises(fyd.Error, match="nowhere.h5"):
        fyd.open(tmp_path / "nowhere.h5")


def test_what_is_no_recording_is_named(tmp_path):
    text = tmp_path / "letter.h5"
    text.write_text("Dear reader")
    with pytest.raises(fyd.Error, match="letter.h5"):
        fyd.open(text)
    other = tmp_path / "other.h5"
    with h5py.File(other, "w") as file:
        file["numbers"] = np.arange(10)
    with pytest.raises(fyd.Error, match="other.h5"):
        fyd.open(other)
    with pytest.raises(fyd.Error):
        fyd.open(tmp_path)


def fixed_text(file, name, text):
    """Any bytes, which h5py would not write as a string."""
    if name in file:
        del file[name]
    kind = h5py.h5t.C_S1.copy()
    kind.set_size(len(text))
    kind.set_strpad(h5py.h5t.STR_NULLPAD)
    kind.set_cset(h5py.h5t.CSET_UTF8)
    made = h5py.h5d.create(file.id, name.encode(), kind, h5py.h5s.create(h5py.h5s.SCALAR))
    made.write(h5py.h5s.ALL, h5py.h5s.ALL, np.array(text, f"S{len(text)}"), mtype=kind)


def test_bytes_that_are_no_text_are_shown_all_the_same(tmp_path):
    path = os.path.join(os.fsencode(tmp_path), b"x\xff.h5")
    with changed_copy(GOLDEN / "changes.h5", path, "notes/text") as file:
        for name, text in (("operator", b"Zo\xeb"), ("notes", b"Zo\xeb"), ("tags", b"Zo\xeb\n")):
            fixed_text(file, f"header/{name}", text)
        file["notes/text"][1:2] = 0xFF
    with fyd.open(os.fsdecode(path)) as recording:
        assert (recording.info.operator, recording.info.notes, recording.info.tags) == ("Zo�", "Zo�", ["Zo�"])
        notes = recording.notes
    assert notes[0].text[1] == "�" and "�" not in notes[0].text[2:] + notes[1].text
    with pytest.raises(fyd.Error, match="x�.h5: is closed"):
        _ = recording.telemetry["finger_x_mm"]
    with pytest.raises(fyd.Error, match="y�.h5"):
        fyd.open(os.fsdecode(path.replace(b"x", b"y")))


def test_a_reason_that_is_no_text_is_shown_all_the_same(tmp_path):
    path = tmp_path / "lost.h5"
    with changed_copy(GOLDEN / "classic.h5", path) as file:
        fixed_text(file, "header/missing", b"/inputs/ir 3 1 \xff\n")
    with fyd.open(path) as recording:
        assert "/inputs/ir" in recording.info.why_not_exact and "�" in recording.info.why_not_exact
        assert recording.replay().why_not_exact == recording.info.why_not_exact


@pytest.mark.parametrize("arithmetic", [1, 2])
def test_a_parameter_that_changed_is_named(arithmetic):
    """The file's own numbers are those of its profile's lines, the library's those of its parameters."""
    path = GOLDEN.with_name(f"arithmetic_{arithmetic}") / "changes.h5"
    with h5py.File(path) as file:
        events, changes, profile = file["events"][:], file["inputs/changes"][:], file["header/profile"][()].decode()
    lines, module = [], ""
    for line in profile.splitlines():
        module = line.strip("[]") if line.startswith("[") else module
        lines += [f"{module}.{line.split(' =')[0]}"] if " = " in line and not line.startswith(("[", "#")) else []
    named = [lines[row["index"]] if row["kind"] in (4, 5) else None for row in events]
    known = list(fyd.Parameters())
    assert len(set(named)) > 4
    with fyd.open(path) as recording:
        assert [event.id for event in recording.events] == named
        assert [known[event.index] for event in recording.events if event.id] == [each for each in named if each]
        steps = [recording.step(row) for row in range(recording.info.rows)]
    assert [event.id for step in steps for event in step.events] == named
    assert [change.id for step in steps for change in step.inputs.changes] == [lines[row["index"]] for row in changes]
    assert fyd.ParameterChange(index=65535).id is None and fyd.ParameterChange(index=0).id == known[0]


def flip_a_bit(source, path, table, row):
    """In the middle of the chunk that begins with this row."""
    with h5py.File(source) as file:
        chunk = file[table].id.read_direct_chunk((row,))[1]
    damaged = bytearray(source.read_bytes())
    assert damaged.count(chunk) == 1
    damaged[damaged.find(chunk) + len(chunk) // 2] ^= 4
    path.write_bytes(damaged)


def test_a_recovered_recording_says_what_is_lost_of_a_step(tmp_path):
    path = tmp_path / "lost.h5"
    flip_a_bit(GOLDEN / "classic.h5", path, "inputs/bridge", 0)
    assert program("session", "recover", path).returncode == 3
    with fyd.open(path) as recording, fyd.open(GOLDEN / "classic.h5") as whole:
        steps = [recording.step(row) for row in range(recording.info.rows)]
        lost = [row for row, step in enumerate(steps) if step.missing]
        assert 0 < len(lost) < len(steps) == whole.info.rows
        assert {steps[row].missing for row in lost} == {("/inputs/bridge",)}
        assert all(steps[row].inputs.bridge.count == 0 for row in lost)
        assert "/inputs/bridge" in recording.info.why_not_exact
        assert not recording.replay().identical
        # Stepped with them it is another session, and `missing` is what tells.
        pipelines = recording.pipeline(), whole.pipeline()
        forces_N = [[pipeline.step(each.step(row).inputs).telemetry.force_N for pipeline, each in
                     zip(pipelines, (recording, whole))] for row in range(lost[-1] + 1)]
        assert not np.array_equal(*np.transpose(forces_N), equal_nan=True)
        assert whole.info.why_not_exact == "" and whole.step(lost[0]).missing == ()


def test_the_arithmetic_of_a_recording_is_told(classic):
    with fyd.open(GOLDEN.with_name("arithmetic_1") / "classic.h5") as older:
        assert older.info.arithmetic == 1 and not older.replay().identical
    assert classic.info.arithmetic == 2 and classic.replay().identical


@pytest.mark.parametrize("share", [0.0, 0.1, 0.5, 0.9, 0.999])
def test_a_truncated_file_gives_an_error_or_right_values(tmp_path, share):
    whole = (GOLDEN / "classic.h5").read_bytes()
    cut = tmp_path / "cut.h5"
    cut.write_bytes(whole[:int(share * len(whole))])
    theirs, _ = read_by_h5py(GOLDEN / "classic.h5", "telemetry")
    try:
        with fyd.open(cut) as recording:
            wholeness, force = recording.info.wholeness, recording.telemetry["force_N"]
    except fyd.Error as error:
        assert "cut.h5" in str(error)
    else:
        assert_same_bits(force, theirs["force_N"][:len(force)])
        assert wholeness != fyd.Wholeness.whole or len(force) == len(theirs)


def test_a_flipped_bit_in_the_telemetry_is_an_error(tmp_path):
    path = tmp_path / "flipped.h5"
    flip_a_bit(GOLDEN / "classic.h5", path, "telemetry", 500)
    recording = fyd.open(path)
    with pytest.raises(fyd.Error, match="flipped.h5.*telemetry"):
        _ = recording.telemetry["force_N"]
    with pytest.raises(fyd.Error, match="flipped.h5.*telemetry"):
        recording.telemetry.load()


def test_what_a_killed_recorder_left_is_read(tmp_path):
    path = tmp_path / "crashed.h5.partial"
    path.write_bytes((GOLDEN / "crashed.h5.partial").read_bytes())
    with fyd.open(path) as recording:
        assert recording.info.wholeness == fyd.Wholeness.crashed
        assert recording.info.rows > 100
        assert np.all(np.diff(recording.telemetry["step"].astype(np.int64)) == 1)


def test_a_column_that_is_not_there_is_a_key_error(classic):
    with pytest.raises(KeyError, match="force_lbs"):
        _ = classic.telemetry["force_lbs"]
    assert "force_lbs" not in classic.telemetry and "force_N" in classic.telemetry
    with pytest.raises(fyd.Error, match="1225"):
        classic.step(1225)


def test_a_column_goes_only_into_an_array_that_fits(classic):
    file = classic._file
    rows = classic.info.rows
    file.read_into(["force_N"], 0, [np.empty(rows)])
    frozen = np.empty(rows)
    frozen.flags.writeable = False
    for wrong in (np.empty(rows, np.float32), np.empty((rows, 1)), np.empty(2 * rows)[::2], frozen):
        with pytest.raises(fyd.InvalidValue, match="force_N"):
            file.read_into(["force_N"], 0, [wrong])
    with pytest.raises(fyd.Error):
        file.read_into(["force_N"], 1, [np.empty(rows)])
    with pytest.raises(fyd.Error):
        file.read_into(["force_N"], 2**64 - 1, [np.empty(rows)])
