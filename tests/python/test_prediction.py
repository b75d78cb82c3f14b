"""Predictors on motions whose course is known."""
import math

import numpy as np
import pytest

import fyd


def test_order_0_holds_and_order_1_goes_on():
    """[tele-gesture paper] on an even motion of 40 mm/s."""
    hold, line, hybrid = (fyd.Predictor(name, axes=1, period_s=0.01) for name in ("order0", "order1", "hybrid"))
    for i in range(100):
        for each in (hold, line, hybrid):
            each.message(0.01 * i, [40 * 0.01 * i])
    late_s = 0.99 + 0.05
    assert hold.predict(late_s)[0] == pytest.approx(40 * 0.99)
    assert line.predict(late_s)[0] == pytest.approx(40 * late_s, abs=1e-6)
    assert hybrid.predict(late_s)[0] == pytest.approx(40 * (0.99 + late_s) / 2, abs=1e-6)
    assert line.velocity(late_s)[0] == pytest.approx(40, abs=1e-6)
    line.end_motion()


@pytest.mark.parametrize("name", fyd.PREDICTORS)
def test_every_predictor_is_finite_whatever_comes(name):
    predictor = fyd.Predictor(name, axes=3)
    assert (predictor.predict(1.0) == 0).all()
    for date_s, position_mm in [(0, [0, 0, 0]), (math.nan, [1, 1, 1]), (0.01, [math.nan, 0, 0]), (0.02, [1e300, 0, 0]),
                                (math.inf, [1, 1, 1]), (0.03, [1, 2, 3]), (0.03, [1, 2, 3]), (0.01, [0, 0, 0])]:
        predictor.message(date_s, position_mm)
    for time_s in (0.05, 10.0, math.nan, math.inf, -1e9):
        assert np.isfinite(predictor.predict(time_s)).all() and np.isfinite(predictor.velocity(time_s)).all()


def test_the_trial_of_order_0_is_the_motion_as_it_was():
    """A message each row, so that what is predicted is the row that far back: computed here by NumPy."""
    time_s = np.arange(3000) * 0.001
    position_mm = np.stack([30 * np.sin(6 * time_s), 20 * np.cos(4 * time_s)], axis=1)
    trial = fyd.predict_trial(time_s, position_mm, "order0", period_ms=1, delay_ms=50)
    rows = trial["row"].astype(int)
    back = rows[100] - int(np.argmin(np.abs(position_mm[:, 0] - trial["position_mm"][100, 0])
                                     + np.abs(position_mm[:, 1] - trial["position_mm"][100, 1])))
    assert back in (50, 51)
    assert np.array_equal(trial["position_mm"][100:], position_mm[rows[100:] - back])
    error = np.linalg.norm(trial["position_mm"] - position_mm[rows], axis=1)
    assert trial["rms_mm"] == pytest.approx(np.sqrt(np.mean(error**2)), rel=1e-9)
    assert trial["max_mm"] == pytest.approx(error.max(), rel=1e-9)
    better = fyd.predict_trial(time_s, position_mm, "default", period_ms=10, delay_ms=50)
    assert better["rms_mm"] < 0.5 * fyd.predict_trial(time_s, position_mm, "order0", period_ms=10, delay_ms=50)["rms_mm"]


def test_a_ratio_to_nothing_is_nan():
    time_s = np.arange(2000) * 0.001
    still = fyd.predict_trial(time_s, np.zeros((2000, 1)))
    assert np.isnan(still["vibration_ratio"]) and np.isnan(still["jerk_ratio"]) and still["rms_mm"] == 0
    slow = fyd.predict_trial(time_s * 10, 30 * np.sin(5 * time_s)[:, None])
    assert np.isnan(slow["vibration_ratio"]) and np.isfinite(slow["jerk_ratio"])  # 100 rows a second


@pytest.mark.parametrize("network", [{"loss_percent": 100}, {"delay_ms": 5000}])
def test_where_no_message_arrives_no_predictor_is_without_an_error(network):
    time_s = np.arange(2000) * 0.001
    trial = fyd.predict_trial(time_s, np.sin(5 * time_s)[:, None] * 30, **network)
    assert len(trial["row"]) == 0 and trial["position_mm"].shape == (0, 1)
    figures = [value for name, value in trial.items() if name not in ("row", "position_mm")]
    assert len(figures) == 6 and np.isnan(figures).all()


def test_the_same_seed_gives_the_same_network():
    time_s = np.arange(2000) * 0.001
    path = np.sin(5 * time_s)[:, None] * 30
    first, same, other = (fyd.predict_trial(time_s, path, jitter_ms=20, loss_percent=20, seed=seed) for seed in (1, 1, 2))
    assert np.array_equal(first["position_mm"], same["position_mm"])
    assert not np.array_equal(first["position_mm"], other["position_mm"])


def test_what_is_not_possible_is_named():
    time_s, path = np.arange(100) * 0.01, np.zeros((100, 1))
    for wrong in (0, 4, -1):
        with pytest.raises(fyd.InvalidValue, match="axes"):
            fyd.Predictor(axes=wrong)
    with pytest.raises(fyd.InvalidValue, match="crystal.*order0"):
        fyd.Predictor("crystal ball")
    with pytest.raises(fyd.InvalidValue, match="period_s"):
        fyd.Predictor(period_s=math.nan)
    with pytest.raises(fyd.InvalidValue, match=r"position_mm.*\(2,\).*\(3,\)"):
        fyd.Predictor(axes=3).message(0, [1, 2])
    with pytest.raises(fyd.InvalidValue, match="position_mm"):
        fyd.predict_trial(time_s, np.zeros((99, 1)))
    with pytest.raises(fyd.InvalidValue, match="axes"):
        fyd.predict_trial(time_s, np.zeros((100, 4)))
    with pytest.raises(fyd.InvalidValue, match="delay"):
        fyd.predict_trial(time_s, path, delay_ms=math.nan)
    with pytest.raises(fyd.InvalidValue, match="loss"):
        fyd.predict_trial(time_s, path, loss_percent=101)
    with pytest.raises(fyd.InvalidValue, match="smooth_s"):
        fyd.predict_trial(time_s, path, smooth_s=-1)
    with pytest.raises(fyd.InvalidValue, match="^99000000 s .*86400.*seconds"):
        fyd.predict_trial(1e6 * np.arange(100), path)  # microseconds
    with pytest.raises(fyd.InvalidValue, match="0.1 ms: 864000001 messages in 86400 s"):
        fyd.predict_trial([0, 86400], [[0], [1]], period_ms=0.1)
    with pytest.raises(fyd.InvalidValue, match="86400"):
        fyd.predict_trial([-1e300, 1e300], path[:2])
    with pytest.raises(fyd.InvalidValue):
        fyd.predict_trial(time_s[::-1], path)
    with pytest.raises(fyd.InvalidValue):
        fyd.predict_trial([0.0], [[0.0]])
