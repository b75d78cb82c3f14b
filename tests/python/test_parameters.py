"""Parameters, against what the program's own `fyd params` says of them."""
import copy
import itertools
import json
import math
import pickle

import numpy as np
import pytest
from conftest import GOLDEN, program

import fyd


@pytest.fixture(scope="module")
def listed():
    return {each["id"]: each for each in json.loads(program("params", "--json").stdout)}


def test_each_is_described_as_the_program_describes_it(listed):
    parameters = fyd.Parameters()
    assert len(parameters) > 100 and set(parameters) <= set(listed)
    for name in parameters:
        info, told = fyd.Parameters.info(name), listed[name]
        assert (info.unit, info.help, info.live) == (told["unit"], told["help"], told["live"])
        if "minimum" in told:
            assert (info.minimum, info.maximum) == (told["minimum"], told["maximum"])
        if info.kind in ("real", "integer"):
            assert info.default == parameters[name] and info.minimum <= info.default <= info.maximum


def test_they_are_a_mapping():
    parameters = fyd.Parameters({"control.kp": 2})
    assert dict(parameters) == dict(parameters.items()) == {name: parameters[name] for name in parameters}
    assert list(parameters.values()) == [parameters[name] for name in parameters.keys()]
    assert parameters.get("control.kp") == 2 and parameters.get("nonsense") is None and parameters.get("nonsense", 7) == 7
    assert "control.kp" in parameters
    assert parameters == fyd.Parameters({"control.kp": 2}) != fyd.Parameters() and parameters != dict(parameters)
    with pytest.raises(TypeError, match="unhashable"):
        hash(parameters)  # it changes
    for no_name in (3, None, "nonsense", ("control.kp",), "\udcff"):
        assert no_name not in parameters


def test_a_value_of_each_kind_is_set_and_read():
    parameters = fyd.Parameters({"control.kp": 2, "texture.method": "soc"})
    assert parameters["control.kp"] == 2.0 and parameters["texture.method"] == "soc"
    parameters["texture.frame"] = 64  # a choice among words that are numbers
    assert parameters["texture.frame"] == "64"
    parameters["sensing.finger_mirror"] = True
    assert parameters["sensing.finger_mirror"] is True
    parameters["control.kp"] = np.float64(1.5)
    parameters["control.kp"] = np.float32(1.5)
    assert parameters["control.kp"] == 1.5
    kinds = {fyd.Parameters.info(name).kind: name for name in parameters}
    lists = kinds["list"]
    before = parameters[lists]
    parameters[lists] = before
    assert parameters[lists] == before and isinstance(before, tuple)
    copy = parameters.copy()
    copy["control.kp"] = 1.0
    assert parameters["control.kp"] == 1.5


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf, -1.0, 1e9])
def test_what_is_not_possible_names_id_value_and_range(value):
    parameters = fyd.Parameters()
    before = parameters["texture.k_vib"]
    with pytest.raises(ValueError, match=r"texture\.k_vib.*0.*10") as caught:
        parameters["texture.k_vib"] = value
    assert isinstance(caught.value, fyd.InvalidValue) and isinstance(caught.value, fyd.Error)
    shown = str(caught.value).lower()
    assert ("nan" if math.isnan(value) else "inf" if math.isinf(value) else f"= {value:.0f}:") in shown
    assert parameters["texture.k_vib"] == before


def test_wrong_kinds_are_told():
    parameters = fyd.Parameters()
    with pytest.raises(fyd.InvalidValue, match="sensing.roi_x_px"):
        parameters["sensing.roi_x_px"] = 1.5
    with pytest.raises(fyd.InvalidValue, match="texture.method.*dft321"):
        parameters["texture.method"] = "everything"
    with pytest.raises(fyd.InvalidValue, match="sensing.finger_mirror"):
        parameters["sensing.finger_mirror"] = 3
    with pytest.raises(fyd.InvalidValue, match="control.kp"):
        parameters["control.kp"] = [1, 2]
    with pytest.raises(TypeError):
        parameters["control.kp"] = None
    with pytest.raises(fyd.InvalidValue, match="no.such"):
        parameters["no.such"] = 1
    with pytest.raises(fyd.InvalidValue, match="no.such"):
        fyd.Parameters({"no.such": 1})


@pytest.mark.parametrize("value", [10**400, -10**400, 10**5000], ids=["large", "negative", "huge"])
def test_an_integer_beyond_any_number_is_named(value):
    with fyd.open(GOLDEN / "classic.h5") as recording:
        for name in ("control.kp", "sensing.roi_x_px", "texture.frame"):
            parameters = fyd.Parameters()
            before = parameters[name]
            with pytest.raises(fyd.InvalidValue, match=f"{name}: an integer of more than 308 digits; expected"):
                parameters[name] = value
            assert parameters[name] == before
            with pytest.raises(fyd.InvalidValue, match=f"{name}: an integer of more than 308 digits; expected"):
                recording.replay({name: value})
        lists = next(name for name in parameters if fyd.Parameters.info(name).kind == "list")
        with pytest.raises(fyd.InvalidValue, match=f"{lists}: an integer"):
            parameters[lists] = [value]


@pytest.mark.parametrize("key", [1, None, b"control.kp", "control.\udcff"])
def test_an_id_is_text(key):
    parameters = fyd.Parameters()
    with pytest.raises(TypeError, match="expected a name, as"):
        fyd.Parameters({key: 2})
    with pytest.raises(TypeError, match="expected a name, as"):
        parameters.update({key: 2})
    with fyd.open(GOLDEN / "classic.h5") as recording, pytest.raises(TypeError, match="expected a name, as"):
        recording.replay({key: 2})
    with pytest.raises(TypeError, match="texture.method.*udcff"):
        parameters["texture.method"] = "\udcff"


def test_a_list_holds_numbers_and_no_more_than_it_may():
    parameters = fyd.Parameters()
    lists = next(name for name in parameters if fyd.Parameters.info(name).kind == "list")
    before = parameters[lists]
    itself = [1.0]
    itself.append(itself)
    for wrong in (itself, [[1.0]], ["1"], [True], [None]):
        with pytest.raises(TypeError):
            parameters[lists] = wrong
    with pytest.raises(fyd.InvalidValue, match=f"{lists}: at most 16 values"):
        parameters[lists] = itertools.repeat(fyd.Parameters.info(lists).minimum)  # without end
    assert parameters[lists] == before


def test_a_list_of_what_would_be_taken_in_silence_is_refused():
    parameters = fyd.Parameters()
    lists = next(name for name in parameters if fyd.Parameters.info(name).kind == "list")
    before = parameters[lists]
    for wrong in (np.array([1 + 2j, 2]), np.array(["1", "2"]), np.array([1, 2], "m8[s]"), np.array(["1", 2], object), b"abc",
                  bytearray(b"abc"), {1: 5, 2: 6}, np.ma.masked_greater([1.0, 2.0], 1.5)):
        with pytest.raises(TypeError):
            parameters[lists] = wrong
    assert parameters[lists] == before


def test_one_value_of_numpy_s_is_what_it_is():
    """NumPy's truth values, texts, dates and complex numbers all say that they are numbers."""
    parameters = fyd.Parameters({"sensing.finger_mirror": np.bool_(True), "control.kp": np.array(1.5),
                                 "texture.method": np.array("soc"), "sensing.roi_x_px": np.array(3)})
    assert parameters["sensing.finger_mirror"] is True and parameters["control.kp"] == 1.5
    assert parameters["texture.method"] == "soc" and parameters["sensing.roi_x_px"] == 3
    parameters["sensing.finger_mirror"] = np.array(False)
    assert parameters["sensing.finger_mirror"] is False
    before = parameters["control.kp"]
    for wrong in (np.bool_(True), True):
        with pytest.raises(fyd.InvalidValue, match="control.kp"):
            parameters["control.kp"] = wrong
    for wrong in (np.complex128(1 + 2j), 1 + 2j, np.array(1j), np.timedelta64(1, "s"), np.datetime64(1, "s"), b"1",
                  np.bytes_(b"1"), np.ma.masked, np.ma.array(1.5, mask=True)):
        with pytest.raises(TypeError):
            parameters["control.kp"] = wrong
    with pytest.raises(fyd.InvalidValue, match="(?i)control.kp.*nan"):
        parameters["control.kp"] = np.array(np.nan)
    assert parameters["control.kp"] == before


def test_a_list_may_be_any_iterable():
    lists = next(name for name in fyd.Parameters() if fyd.Parameters.info(name).kind == "list")
    wanted = (fyd.Parameters.info(lists).minimum,) * 3
    parameters = fyd.Parameters({lists: iter(wanted)})
    assert parameters[lists] == wanted
    parameters[lists] = (value for value in wanted[:2])
    assert parameters[lists] == wanted[:2]
    parameters.update({lists: np.array(wanted), "control.kp": 2.0})
    parameters.update({lists: map(float, wanted)})
    assert parameters[lists] == wanted and parameters["control.kp"] == 2.0


def test_several_are_set_together_or_not_at_all():
    parameters = fyd.Parameters()
    before = parameters["control.kp"]
    with pytest.raises(fyd.InvalidValue, match="texture.k_vib"):
        parameters.update({"control.kp": before + 1, "texture.k_vib": 11})
    assert parameters["control.kp"] == before


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, lambda value: pickle.loads(pickle.dumps(value))])
def test_copies_are_equal_and_their_own(copied):
    parameters = fyd.Parameters({"control.kp": 0.25, "sensing.ir_lowest_code": [11.0, 12.0, 13.0]})
    other = copied(parameters)
    assert other == parameters and dict(other.items()) == dict(parameters.items())
    other["control.kp"] = 0.5
    assert parameters["control.kp"] == 0.25

    sample = fyd.TelemetrySample(touch_z_mm=1.5, state=fyd.SafetyState.active)
    same = copied(sample)
    assert same.as_dict().keys() == sample.as_dict().keys() and repr(same) == repr(sample)
    same.touch_z_mm = 2.0
    assert sample.touch_z_mm == 1.5
    with fyd.open(GOLDEN / "changes.h5") as recording:
        events = recording.events
    assert [repr(copied(event)) for event in events] == [repr(event) for event in events] and events[0].when_ns > 0
    finger = fyd.FingerInput()
    finger.set(5_000_000, x_px=3.0)
    assert repr(copied(finger)) == repr(finger) and copied(finger).count == 1


def test_a_profile_is_read_back_equal():
    parameters = fyd.Parameters({"control.kp": 2.25, "texture.method": "single"})
    again = fyd.Parameters.from_profile(parameters.profile())
    assert all(again[name] == parameters[name] for name in parameters)
    with pytest.raises(fyd.InvalidValue, match=r"mine.toml:2.*control\.kp"):
        fyd.Parameters.from_profile("[control]\nkp = 1e9\n", "mine.toml")
