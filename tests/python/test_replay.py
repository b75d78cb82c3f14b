"""Replay, what-if, and the step itself, against what h5py reads of the same recording."""
import math

import h5py
import numpy as np
import pytest
from conftest import GOLDEN

import fyd


def rows_of(path, table="telemetry"):
    with h5py.File(path) as file:
        return file[table][:]


def test_a_replay_is_the_recording_bit_for_bit(golden):
    recorded = rows_of(golden)
    with fyd.open(golden) as recording:
        result = recording.replay()
        assert result.identical and result.different == 0 and not result.what_if
        assert result.steps == result.of == len(recorded)
        for name in set(recorded.dtype.names) - {part.split()[-1] for part in recording.info.missing_columns}:
            assert result.telemetry[name].tobytes() == recorded[name].tobytes(), name


def test_the_replayed_columns_are_views(classic):
    telemetry = fyd.replay(classic).telemetry
    force, depth = telemetry["force_N"], telemetry["indentation_mm"]
    assert force.strides == depth.strides and force.strides[0] > force.itemsize  # of the same rows
    assert force.base is not None and not force.flags.writeable
    del telemetry, depth
    assert np.isfinite(force).any()  # it keeps its memory


def test_another_gain_changes_the_steps(classic):
    result = classic.replay({"control.kp": 3})
    assert result.what_if and not result.identical and result.different > 0
    assert not np.array_equal(result.telemetry["stretch_reference_deg"], classic.telemetry["stretch_reference_deg"])
    # It acts on what is commanded; what was measured is as recorded.
    assert np.array_equal(result.telemetry["force_N"], classic.telemetry["force_N"], equal_nan=True)
    assert classic.replay({"control.kp": 3}, keep_telemetry=False).telemetry == {}
    same = classic.replay({"control.kp": classic.parameters["control.kp"]})
    assert np.array_equal(same.telemetry["stretch_reference_deg"], classic.telemetry["stretch_reference_deg"])


def test_in_a_closed_loop_motors_and_cloth_answer(staircase):
    recorded = rows_of(staircase)
    with fyd.open(staircase) as recording:
        same = recording.replay(closed_loop=True)
        assert same.identical and same.closed_loop and not same.what_if
        soft = {"control.ki": 0.01, "control.kp": 0.1}
        loop, fixed = recording.replay(soft, closed_loop=True), recording.replay(soft)

    def apart(result, name):
        return np.nanmax(np.abs(result.telemetry[name] - recorded[name]))

    assert np.array_equal(fixed.telemetry["force_N"], recorded["force_N"], equal_nan=True)
    assert apart(fixed, "stretch_measured_deg") == 0 and apart(fixed, "stretch_reference_deg") > 0
    assert apart(loop, "stretch_measured_deg") > 1 and apart(loop, "force_N") > 0.01
    # The finger presses as deep as it did; the force's part in the estimated depth moves it a little.
    assert apart(loop, "indentation_mm") < 0.02 * np.nanmax(recorded["indentation_mm"])


def test_the_stiffness_error_is_the_columns_rms(staircase):
    recorded = rows_of(staircase)
    with fyd.open(staircase) as recording:
        loop = recording.replay({"control.kp": 3}, closed_loop=True)
    for percent, columns in ((loop.stiffness_error_recorded_percent, recorded),
                             (loop.stiffness_error_replayed_percent, loop.telemetry)):
        known = (columns["stiffness_observable"] != 0) & (columns["state"] == fyd.SafetyState.active.value)
        with np.errstate(invalid="ignore", divide="ignore"):
            off = (columns["stiffness_N_per_mm"] / columns["target_N_per_mm"] - 1)[known]
        assert percent == pytest.approx(100 * np.sqrt(np.mean(off[np.isfinite(off)] ** 2)), rel=1e-9)
    assert loop.stiffness_error_replayed_percent != loop.stiffness_error_recorded_percent


def test_a_closed_loop_needs_touches_that_identify_the_cloth(classic):
    with pytest.raises(fyd.Error, match=r"closed loop.*1\.22 s; expected at least 100 over 2 s") as caught:
        classic.replay({"control.kp": 3}, closed_loop=True)
    assert not isinstance(caught.value, fyd.InvalidValue)  # the setting is right, the recording too short


@pytest.mark.parametrize("settings, words", [({"control.kp": float("nan")}, "control.kp"),
                                             ({"control.kp": float("inf")}, "control.kp"),
                                             ({"control.kp": "many"}, "control.kp.*many"),
                                             ({"texture.method": "sum"}, "texture.method.*sum.*dft321"),
                                             ({"control.no_such": 1}, "control.no_such"),
                                             ({"sim.cloth": "ideal"}, "sim.cloth")])
def test_a_wrong_setting_is_named(classic, settings, words):
    with pytest.raises(fyd.InvalidValue, match=words):
        classic.replay(settings)
    assert classic.replay().identical


def test_what_is_no_recording_or_no_settings_is_named(classic):
    for wrong in ("s.h5", None, classic._file):
        with pytest.raises(TypeError, match="expected a Recording, as fyd.open gives it"):
            fyd.replay(wrong)
    for wrong in ("ab", b"ab", 3, ["control.kp"]):
        with pytest.raises(TypeError, match="settings: .*expected a mapping of id to value"):
            classic.replay(wrong)


def test_the_step_gives_what_was_recorded(golden):
    """Step by step, from the state before the first row."""
    recorded = rows_of(golden)
    with fyd.open(golden) as recording:
        missing = {part.split()[-1] for part in recording.info.missing_columns}
        pipeline = recording.pipeline()
        for row in range(0, 1200):
            out = pipeline.step(recording.step(row).inputs)
            if row % 50 == 0:
                for name, value in out.telemetry.as_dict().items():
                    if name not in missing:
                        assert np.array_equal(float(value), float(recorded[name][row]), equal_nan=True), (row, name)


def test_the_step_is_pure(classic):
    """From the same state and inputs comes the same, whatever was stepped between."""
    pipeline = classic.pipeline()
    for row in range(600):
        pipeline.step(classic.step(row).inputs)
    state = pipeline.save_state()
    inputs = classic.step(600).inputs
    first = repr(pipeline.step(inputs).telemetry)
    for row in range(601, 700):
        pipeline.step(classic.step(row).inputs)
    assert repr(pipeline.step(inputs, state).telemetry) == first
    other = classic.pipeline()
    assert repr(other.step(inputs, state).telemetry) == first


def test_a_state_that_is_none_is_refused_and_changes_nothing(classic):
    pipeline = classic.pipeline()
    state = pipeline.save_state()
    for wrong in (b"", b"once upon a time", state[:-1], state + b"\0", state[:200] + b"\x55" + state[201:]):
        with pytest.raises(fyd.Error):
            pipeline.restore_state(wrong)
        with pytest.raises(fyd.Error):
            pipeline.step(fyd.Inputs(), wrong)
    assert pipeline.save_state() == state
    with pytest.raises(fyd.Error):
        fyd.Pipeline(fyd.Parameters({"texture.sample_rate_Hz": 500})).restore_state(state)


def test_a_session_by_hand_becomes_ready_and_active():
    """Inputs made here, not read: sensors live, a finger that does not press, the target by hand."""
    pipeline = fyd.Pipeline()
    inputs = fyd.Inputs(missed_cycles=0)
    states = []
    for step in range(1, 400):
        inputs.now_ns = step * 1_000_000
        if step % 10 == 1:
            inputs.finger.set(inputs.now_ns, contact=False, reason=fyd.FingerReason.no_finger)
            inputs.ir.set(inputs.now_ns, counts=[1500, 1500, 1500])
            inputs.bridge.set(inputs.now_ns, value_mV_per_V=0.02)
            inputs.motors.set(inputs.now_ns, encoder_counts=(0, 0))
        action = {20: fyd.OperatorAction.target_by_hand, 200: fyd.OperatorAction.arm, 300: fyd.OperatorAction.stop}.get(step)
        inputs.commands = [] if action is None else [fyd.OperatorCommand(action=action, value=0.6)]
        out = pipeline.step(inputs)
        states.append(out.telemetry.state)
        if step == 10:
            assert fyd.Fault.no_target in out.faults or fyd.Fault.robot_waiting in out.faults
        if action == fyd.OperatorAction.arm:
            assert out.faults == [], [fyd.fault_text(fault) for fault in out.faults]
    assert list(dict.fromkeys(states)) == [fyd.SafetyState.disconnected, fyd.SafetyState.connected, fyd.SafetyState.ready,
                                           fyd.SafetyState.active, fyd.SafetyState.stopped] or \
        list(dict.fromkeys(states)) == [fyd.SafetyState.connected, fyd.SafetyState.ready, fyd.SafetyState.active,
                                        fyd.SafetyState.stopped]


def test_no_command_is_out_of_bounds_whatever_comes_in():
    """A finger presses, the session is Active, and every other step brings a value that no sensor gives."""
    pipeline = fyd.Pipeline()
    inputs = fyd.Inputs(missed_cycles=0)
    hostile = [float("nan"), float("inf"), -float("inf"), 1e308, -1e308]
    kinds = ["finger", "bridge", "robot", "acceleration"]
    ticks_at_limit = round(4200 / 90 * pipeline.parameters["control.motor_limit_deg"])
    active, duties = dict.fromkeys(kinds, 0), set()
    for step in range(1, 2000):
        now = inputs.now_ns = step * 1_000_000
        touching = step > 250
        if step % 10 == 1:
            inputs.finger.set(now, contact=touching, x_mm=1.0, y_mm=2.0, area_px=3000.0, area_mm2=150.0,
                              reason=fyd.FingerReason.found if touching else fyd.FingerReason.no_finger)
            inputs.ir.set(now, counts=[1680, 1660, 1680] if touching else [1630, 1630, 1630])
            inputs.bridge.set(now, value_mV_per_V=0.15 if touching else 0.02)
            inputs.motors.set(now, encoder_counts=(0, 0))
            inputs.robot_state.set(now, stiffness_N_per_mm=0.6)
        inputs.accelerations = [fyd.AccelerationSample(taken_ns=now, x_g=0.5 * math.sin(step), y_g=0.0, z_g=0.0)]
        value = hostile[step // 2 % 5]
        kind = kinds[step // 10 % 4]
        wild = step % 2 == 0
        if wild and kind == "finger":
            inputs.finger.set(now, contact=True, x_mm=value, y_mm=value, area_px=value, reason=fyd.FingerReason.found)
        elif wild and kind == "bridge":
            inputs.bridge.set(now, value_mV_per_V=value)
        elif wild and kind == "robot":
            inputs.robot_state.set(now, stiffness_N_per_mm=value, x_mm=value)
        elif wild:
            inputs.accelerations = [fyd.AccelerationSample(taken_ns=now, x_g=value, y_g=value, z_g=value)]
        action = {20: fyd.OperatorAction.target_by_hand, 200: fyd.OperatorAction.arm}.get(step)
        inputs.commands = [] if action is None else [fyd.OperatorCommand(action=action, value=0.6)]
        out = pipeline.step(inputs)
        assert all(np.isfinite(out.touch_mm)) and np.isfinite(out.telemetry.t_s)
        assert all(abs(duty) <= 100 for duty in out.motors.vibration_duty_percent)
        assert all(abs(ticks) <= ticks_at_limit for ticks in out.motors.reference_ticks)
        if wild and out.telemetry.state == fyd.SafetyState.active:
            active[kind] += 1
            duties.add(out.motors.vibration_duty_percent)
    assert min(active.values()) > 100  # of 225 steps each
    assert len(duties) > 50  # the motors are driven


def test_inputs_of_a_wrong_type_or_number_are_named():
    inputs = fyd.Inputs()
    with pytest.raises(TypeError, match="x_mm.*'here'"):
        inputs.finger.x_mm = "here"
    with pytest.raises(TypeError, match="x_inch.*x_mm"):
        inputs.finger.set(0, x_inch=1)
    inputs.bridge.set(5, value_mV_per_V=0.2)
    before = inputs.bridge.as_dict()
    with pytest.raises(TypeError, match="typo.*value_mV_per_V"):
        inputs.bridge.set(7, value_mV_per_V=0.1, typo=1)
    with pytest.raises(TypeError, match="value_mV_per_V"):
        inputs.bridge.set(7, value_mV_per_V="much")
    assert inputs.bridge.as_dict() == before  # nothing of it was taken
    with pytest.raises(TypeError, match="now_ns"):
        fyd.Inputs(now_ns=1.5)
    with pytest.raises(fyd.InvalidValue, match="counts: 9 items; at most 8"):
        inputs.ir.counts = [1] * 9
    with pytest.raises(fyd.InvalidValue, match="encoder_counts: 3 items; expected 2"):
        inputs.motors.encoder_counts = [1, 2, 3]
    with pytest.raises(TypeError, match="encoder_counts"):
        inputs.motors.encoder_counts = [70_000, 0]
    with pytest.raises(fyd.InvalidValue, match="commands: 17 items; at most 16"):
        inputs.commands = [fyd.OperatorCommand()] * 17
    assert inputs.ir.counts == () and inputs.commands == ()


def test_outputs_have_a_copy_of_their_own():
    outputs = fyd.Pipeline().step(fyd.Inputs(now_ns=1_000_000))
    other = outputs.copy()
    assert repr(other.telemetry) == repr(outputs.telemetry) and other.faults == outputs.faults
    assert [repr(event) for event in other.events] == [repr(event) for event in outputs.events]
    other.telemetry.touch_z_mm = 7.5
    assert outputs.telemetry.touch_z_mm != 7.5


def test_inputs_are_real_numbers_of_which_nothing_is_left_out():
    inputs = fyd.Inputs()
    for wrong in (np.complex128(1 + 2j), "1", np.str_("1"), None, np.timedelta64(1, "s"), np.ma.masked):
        with pytest.raises(TypeError):
            inputs.bridge.value_mV_per_V = wrong
        with pytest.raises(TypeError):
            inputs.now_ns = wrong
    for wrong in (np.ma.masked_greater([1, 2], 1), np.array([1.5, 2], np.float32), np.array(["1", "2"]), ["1", "2"],
                  np.array([1j, 2])):
        with pytest.raises(TypeError):
            inputs.ir.counts = wrong
    with pytest.raises(TypeError, match="a mask hides some"):
        inputs.motors.set(0, current_mA=np.ma.array([1.0, 2.0], mask=[True, False]))
    assert inputs.ir.counts == () and inputs.now_ns == 0 and inputs.motors.current_mA == (0, 0)
    inputs.ir.counts = np.ma.array([1, 2], np.uint16)
    inputs.motors.set(np.int64(5), current_mA=np.array([1.5, 2], np.float32), encoder_counts=np.array([3, 4], np.uint16))
    assert inputs.ir.counts == (1, 2) and inputs.motors.current_mA == (1.5, 2) and inputs.motors.encoder_counts == (3, 4)


@pytest.mark.parametrize("name, one", [("commands", fyd.OperatorCommand(action=fyd.OperatorAction.stop)),
                                       ("changes", fyd.ParameterChange(index=1, value=2)),
                                       ("accelerations", fyd.AccelerationSample(z_g=1)),
                                       ("robot_commands", fyd.RobotCommand.resume)])
def test_a_list_of_the_inputs_is_set_as_a_whole(name, one):
    """What is appended would go into a copy, and a stop would never arrive."""
    inputs = fyd.Inputs()
    with pytest.raises(AttributeError):
        getattr(inputs, name).append(one)
    setattr(inputs, name, [one])
    setattr(inputs, name, (*getattr(inputs, name), one))
    assert [repr(each) for each in getattr(inputs, name)] == [repr(one)] * 2
