"""Filters and spectra against SciPy, textures against what their definitions give."""
import math
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
import scipy.signal
from conftest import ROOT

import fyd

RANDOM = np.random.default_rng(20261125)


@pytest.mark.parametrize("corner_Hz, rate_Hz", [(78, 1000), (5, 1000), (400, 1000), (100, 3200)])
def test_the_high_pass_is_butterworth(corner_Hz, rate_Hz):
    b, a = fyd.high_pass(corner_Hz, rate_Hz)
    wanted_b, wanted_a = scipy.signal.butter(2, corner_Hz, "high", fs=rate_Hz)
    np.testing.assert_allclose(b, wanted_b, rtol=1e-12)
    np.testing.assert_allclose(a, wanted_a, rtol=1e-10, atol=1e-12)


def test_the_sum_of_components_is_scipy_s_filter_summed():
    accelerations_g = RANDOM.normal(size=(4000, 3)) + [0.1, -0.2, 1.0]
    ours = fyd.TextureChain(fyd.Parameters({"texture.method": "soc", "texture.corner_Hz": 78})).run(accelerations_g)
    b, a = scipy.signal.butter(2, 78, "high", fs=1000)
    # The first reading counts as rest.
    theirs = scipy.signal.lfilter(b, a, accelerations_g - accelerations_g[0], axis=0).sum(axis=1)
    np.testing.assert_allclose(ours, theirs, atol=1e-12)


def test_in_pieces_it_is_the_same():
    accelerations_g = RANDOM.normal(size=(1000, 3))
    whole = fyd.TextureChain().run(accelerations_g)
    chain = fyd.TextureChain()
    pieces = np.concatenate([chain.run(part) for part in np.array_split(accelerations_g, 7)])
    assert np.array_equal(whole, pieces)


def test_dft321_has_the_energy_of_the_three_axes():
    """Of each block of whole frames, by its definition."""
    chain = fyd.TextureChain(fyd.Parameters({"texture.filter": "none", "texture.frame": "64", "texture.hop": "frame"}))
    accelerations_g = RANDOM.normal(size=(64 * 20, 3))
    signal_g = chain.run(np.vstack([accelerations_g, np.zeros((chain.delay_samples, 3))]))[chain.delay_samples:]
    blocks = (accelerations_g**2).sum(axis=1).reshape(20, 64).sum(axis=1)
    np.testing.assert_allclose((signal_g**2).reshape(20, 64).sum(axis=1), blocks, rtol=1e-9)


def test_a_gap_is_silence_and_no_nan():
    accelerations_g = RANDOM.normal(size=(300, 3))
    accelerations_g[100:150] = np.nan
    signal_g = fyd.TextureChain(fyd.Parameters({"texture.method": "soc"})).run(accelerations_g)
    assert np.isfinite(signal_g).all() and (signal_g[100:150] == 0).all()
    for beyond_g in (math.inf, -math.inf, 1e200, -1001):
        accelerations_g[7, 1] = beyond_g
        with pytest.raises(fyd.InvalidValue, match="row 7.*-1000 to 1000"):
            fyd.TextureChain().run(accelerations_g)


@pytest.mark.parametrize("wrong", [np.zeros(3), np.zeros((3, 4)), np.zeros((2, 3, 3)), 5.0])
def test_another_shape_is_named(wrong):
    with pytest.raises(fyd.InvalidValue, match="accelerations_g"):
        fyd.TextureChain().run(wrong)
    with pytest.raises(fyd.InvalidValue, match="accelerations_g"):
        fyd.fit_surface(wrong)
    with pytest.raises(fyd.InvalidValue, match="accelerations_g"):
        fyd.spectral_match(wrong, np.zeros(3))


@pytest.mark.parametrize(
    "numbers, told",
    [
        (np.ones(600) * 1j, "complex128"),
        ([1j] * 600, "complex128"),
        (["1.5"] * 600, "<U3"),
        (np.full(600, "2026", "M8[Y]"), "datetime64"),
        (np.ma.masked_greater(np.arange(600.0), 300.0), "a mask hides some"),
        (np.array(["1.5"] * 600, object), "an array with '1.5'"),
        ([1.5] * 599 + [None], "an array with None"),
        (np.array([1j] * 600, object), "an array with 1j"),
        (np.array([np.datetime64("2026")] * 600, object), "an array with numpy.datetime64"),
    ],
)
def test_what_would_be_left_out_in_silence_is_refused(numbers, told):
    with pytest.raises(TypeError, match=told):
        fyd.welch(numbers, 1000.0, 256)


def test_numbers_of_any_real_kind_are_taken():
    numbers = np.arange(600) % 7
    wanted = fyd.welch(numbers.astype(float), 1000.0, 256)
    assert np.array_equal(fyd.welch([Fraction(int(each)) for each in numbers], 1000.0, 256), wanted)
    assert np.array_equal(fyd.welch([Decimal(int(each)) for each in numbers], 1000.0, 256), wanted)
    for same in (numbers, numbers.astype(np.float32), numbers.astype(object), numbers.tolist(), np.ma.array(numbers),
                 numbers.astype(np.int8)[::-1][::-1]):
        assert np.array_equal(fyd.welch(same, 1000.0, 256), wanted)


@pytest.mark.parametrize("segment", [64, 512, 1000])
def test_welch_is_scipy_s(segment):
    signal = RANDOM.normal(size=5000)
    at_Hz, density = fyd.welch(signal, 2000, segment)
    theirs_Hz, theirs = scipy.signal.welch(signal, 2000, "hann", segment, segment // 2, detrend=False)
    np.testing.assert_allclose(at_Hz, theirs_Hz)
    np.testing.assert_allclose(density, theirs, rtol=1e-9)
    with pytest.raises(fyd.InvalidValue, match="segment"):
        fyd.welch(signal, 1000, 1)


def test_a_surface_s_spectrum_has_its_band():
    """One band at a fixed frequency: its power lies there, and its RMS is the one asked for, at the reference."""
    surface = fyd.Surface()
    surface.name = "tone"
    surface.bands = [fyd.SurfaceBand(frequency_Hz=120, quality=10, rms_g=0.4)]
    signal_g = fyd.VirtualTexture(surface, seed=3).run(np.full(60_000, surface.reference_speed_mm_s),
                                                       np.full(60_000, surface.reference_force_N))[1000:]
    at_Hz, density = scipy.signal.welch(signal_g, 1000, nperseg=2048)
    assert abs(at_Hz[density.argmax()] - 120) < 8
    assert np.sqrt(np.mean(signal_g**2)) == pytest.approx(0.4, rel=0.05)
    slow = fyd.VirtualTexture(surface).run(np.full(2000, 4.0), np.ones(2000))
    assert (slow == 0).all()  # nothing below 5 mm/s
    for none in (math.nan, -1, math.inf, -math.inf):
        assert (fyd.VirtualTexture(surface).run(np.full(500, none), np.ones(500)) == 0).all()
        assert (fyd.VirtualTexture(surface).run(np.full(500, 40.0), np.full(500, none)) == 0).all()
    much, most = (fyd.VirtualTexture(surface).run(np.full(500, speed), np.full(500, force))
                  for speed, force in ((1e9, 1e9), (1000, 20)))
    assert np.array_equal(much, most) and (most != 0).any()
    with pytest.raises(AttributeError):
        surface.bands.append(fyd.SurfaceBand(frequency_Hz=90))  # into a copy


def test_the_same_seed_gives_the_same_noise():
    surface = fyd.Surface.from_text((ROOT / "resources/textures/wood.toml").read_text(), "wood.toml")
    speed, force = np.full(1000, 40.0), np.ones(1000)
    first = fyd.VirtualTexture(surface, seed=7)
    wanted = first.run(speed, force)
    assert np.array_equal(wanted, fyd.VirtualTexture(surface, seed=7).run(speed, force))
    assert not np.array_equal(wanted, fyd.VirtualTexture(surface, seed=8).run(speed, force))
    first.reset()
    assert np.array_equal(wanted, first.run(speed, force))


def test_a_surface_is_read_back_equal():
    for path in sorted(Path(ROOT / "resources/textures").glob("*.toml")):
        surface = fyd.Surface.from_text(path.read_text(), path.name)
        assert fyd.Surface.from_text(surface.text()).text() == surface.text()
        assert surface.bands and surface.name


def test_a_fit_gives_back_the_surface_it_was_made_of():
    surface = fyd.Surface()
    surface.name = "made"
    surface.bands = [fyd.SurfaceBand(frequency_Hz=90, quality=4, rms_g=0.3), fyd.SurfaceBand(frequency_Hz=250, quality=4, rms_g=0.1)]
    signal_g = fyd.VirtualTexture(surface).run(np.full(60_000, 40.0), np.ones(60_000))
    recorded = np.zeros((60_000, 3))
    recorded[:, 2] = signal_g + 1.0  # gravity
    fitted, match = fyd.fit_surface(recorded, 1000, force_N=1.0, name="again")
    assert match > 0.85 and fitted.name == "again"
    again = fyd.VirtualTexture(fitted, seed=99).run(np.full(60_000, 40.0), np.ones(60_000))
    assert np.sqrt(np.mean(again**2)) == pytest.approx(np.sqrt(np.mean(signal_g**2)), rel=0.1)
    assert fyd.spectral_match(recorded - [0, 0, 1.0], again)[0] > 0.85


def test_what_cannot_be_fitted_or_rendered_is_told():
    with pytest.raises(fyd.InvalidValue):
        fyd.fit_surface(np.zeros((10, 3)))
    with pytest.raises(fyd.InvalidValue):
        fyd.fit_surface(np.zeros((1000, 3)))
    with pytest.raises(fyd.InvalidValue, match="sample 5 is 1e"):
        fyd.fit_surface(np.vstack([np.ones((4, 3)), np.full((1000, 3), 1e308)]))
    for rate_Hz in (math.nan, math.inf, 1e300, 0):
        with pytest.raises(fyd.InvalidValue, match="rate = "):
            fyd.fit_surface(RANDOM.normal(size=(1000, 3)), rate_Hz)
    with pytest.raises(fyd.InvalidValue, match="row 3"):
        fyd.fit_surface(np.vstack([np.ones((3, 3)), np.full((1000, 3), np.nan)]))
    with pytest.raises(fyd.InvalidValue, match="mine.toml"):
        fyd.Surface.from_text("name = 3", "mine.toml")
    surface = fyd.Surface()
    with pytest.raises(fyd.InvalidValue):
        fyd.VirtualTexture(surface)  # without a band
    surface = fyd.Surface.from_text((ROOT / "resources/textures/wood.toml").read_text())
    for rate_Hz in (0, -1, math.nan, math.inf, 1e9):
        with pytest.raises(fyd.InvalidValue, match="texture.sample_rate_Hz"):
            fyd.VirtualTexture(surface, rate_Hz)
    with pytest.raises(fyd.InvalidValue, match="force_N"):
        fyd.VirtualTexture(surface).run([1, 2], [1])
    with pytest.raises(fyd.InvalidValue, match="texture.corner_Hz"):
        fyd.high_pass(math.nan)
    with pytest.raises(fyd.InvalidValue, match=r"corner_Hz: 400; expected at most 24\.5, 0\.49 of rate_Hz = 50"):
        fyd.high_pass(400, 50)
    fyd.high_pass(24.5, 50)
    noise = RANDOM.normal(size=(1000, 3))
    for speed_mm_s in (-40, math.nan, 0.5, 1e6):
        with pytest.raises(fyd.InvalidValue, match="speed = .*none when it is unknown"):
            fyd.fit_surface(noise, speed_mm_s=speed_mm_s)
    for change in ({"reference_speed_mm_s": math.nan}, {"reference_speed_mm_s": 0}, {"reference_force_N": -1},
                   {"speed_exponent": math.inf}, {"bands": []}, {"bands": [fyd.SurfaceBand(frequency_Hz=90, rms_g=1e9)]},
                   {"bands": [fyd.SurfaceBand(wavelength_mm=0.4, frequency_Hz=90, rms_g=0.1)]},
                   {"bands": [fyd.SurfaceBand(wavelength_mm=-0.4, frequency_Hz=90, rms_g=0.1)]},
                   {"bands": [fyd.SurfaceBand(wavelength_mm=0.4, frequency_Hz=-90, rms_g=0.1)]}):
        wrong = fyd.Surface.from_text(surface.text())
        fyd.Pipeline(surface=wrong)
        for name, value in change.items():
            setattr(wrong, name, value)
        for taken in (fyd.VirtualTexture, lambda surface: fyd.Pipeline(surface=surface)):
            with pytest.raises(fyd.InvalidValue, match="surface"):
                taken(wrong)


def test_a_signal_matches_itself():
    axes = np.zeros((8000, 3))
    axes[:, 0] = RANDOM.normal(size=8000)
    assert fyd.spectral_match(axes, axes[:, 0]) == pytest.approx((1.0, 1.0))
    assert fyd.spectral_match(axes, 2 * axes[:, 0])[1] == pytest.approx(4.0)
    silent = np.zeros_like(axes)
    assert np.isnan(fyd.spectral_match(silent, axes[:, 0])).all()  # nothing to compare with
    assert np.isnan(fyd.spectral_match(axes, axes[:, 0], len(axes) - 7)).all()
    assert not np.isnan(fyd.spectral_match(axes, axes[:, 0], len(axes) - 8)).any()
    with pytest.raises(fyd.InvalidValue, match="signal_g"):
        fyd.spectral_match(axes, axes[:10, 0])
    for wrong in (math.nan, math.inf, -math.inf):
        signal_g = axes[:, 0].copy()
        signal_g[5] = wrong
        with pytest.raises(fyd.InvalidValue, match=f"signal_g: row 5 is {wrong}; expected finite numbers"):
            fyd.spectral_match(axes, signal_g)
    with pytest.raises(fyd.InvalidValue, match="delay_samples"):
        fyd.spectral_match(axes, axes[:, 0], -1)
