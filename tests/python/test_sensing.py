"""The finger detector on pictures that NumPy draws: the place is known before it looks."""
import numpy as np
import pytest

import fyd

PARAMETERS = fyd.Parameters()


def millimetres(u_px, v_px):
    """By the manual's formula, with the default scale: no turn, no mirror."""
    return ((u_px - PARAMETERS["sensing.finger_centre_x_px"]) * PARAMETERS["sensing.finger_scale_x_mm_per_px"],
            -(v_px - PARAMETERS["sensing.finger_centre_y_px"]) * PARAMETERS["sensing.finger_scale_y_mm_per_px"])


def picture(u_px, v_px, radius_px=14.0, height=240, width=320):
    """A lit cloth with a dark disc whose edge is soft."""
    v, u = np.mgrid[0:height, 0:width]
    light = 215 - 0.02 * (u - 150) - 0.03 * (v - 120)
    dark = 1 / (1 + np.exp((np.hypot(u - u_px, v - v_px) - radius_px) / 1.2))
    return np.round(light * (1 - 0.6 * dark)).astype(np.uint8)


@pytest.mark.parametrize("place", [(150.0, 120.0), (101.3, 90.7), (201.6, 150.2)])
def test_the_finger_is_where_it_was_drawn(place):
    found = fyd.FingerDetector().detect(picture(*place))
    assert found.contact and found.reason == fyd.FingerReason.found
    assert (found.x_mm, found.y_mm) == pytest.approx(millimetres(*place), abs=0.1)
    assert (found.x_px, found.y_px) == pytest.approx(place, abs=0.2)
    assert found.area_px == pytest.approx(np.pi * 14.0**2, rel=0.1)


def test_without_a_finger_there_is_no_contact():
    v, u = np.mgrid[0:240, 0:320]
    found = fyd.FingerDetector().detect((200 + (u + v) % 7).astype(np.uint8))
    assert not found.contact and found.reason == fyd.FingerReason.no_finger
    assert (found.x_mm, found.y_mm, found.x_px, found.y_px) == (0, 0, 0, 0)
    assert all("without contact 0" in fyd.FingerDetection.help[name] for name in ("x_mm", "y_mm", "x_px", "y_px"))
    assert fyd.FingerDetector().detect(np.zeros((240, 320), np.uint8)).reason == fyd.FingerReason.black_picture
    assert fyd.FingerDetector().detect(np.zeros((0, 320), np.uint8)).reason == fyd.FingerReason.no_picture
    assert fyd.FingerDetector().detect(np.full((5, 5), 200, np.uint8)).reason == fyd.FingerReason.no_picture


def test_any_layout_of_the_same_pixels_gives_the_same():
    dense = picture(120.0, 100.0)
    wanted = repr(fyd.FingerDetector().detect(dense))
    wide = np.zeros((240, 400), np.uint8)
    wide[:, 40:360] = dense
    twice = np.repeat(dense, 2, axis=1)
    for same in (wide[:, 40:360], twice[:, ::2], np.asfortranarray(dense), dense[::-1][::-1], dense.copy()[:, :, None]):
        assert repr(fyd.FingerDetector().detect(same)) == wanted
    upside_down = np.ascontiguousarray(dense[::-1])
    assert repr(fyd.FingerDetector().detect(upside_down[::-1])) == wanted


@pytest.mark.parametrize("mode", ["adaptive", "thesis"])
@pytest.mark.parametrize("colour", [False, True])
def test_rows_that_overlap_or_run_upwards_are_looked_at_as_their_copy(mode, colour):
    """Rows in the memory of other rows, as NumPy's views have them: nothing beyond that memory is read."""
    strip = np.where(np.abs(np.arange(320 + 239) - 200) < 20, 90, 210).astype(np.uint8)
    if colour:
        strip = np.stack([strip, strip // 2, strip // 3 * 2], axis=1)
    slid = np.lib.stride_tricks.sliding_window_view(strip, 320, axis=0)
    slid = np.moveaxis(slid, 2, 1) if colour else slid
    same = np.broadcast_to(strip[:320], (240, *strip[:320].shape))
    for view in (slid, same, slid.copy()[::-1]):
        assert view.shape[:2] == (240, 320)
        detector, of_copy = (fyd.FingerDetector(fyd.Parameters({"sensing.finger_mode": mode})) for _ in range(2))
        for found, wanted in ((detector.detect(view), of_copy.detect(view.copy())),
                              (detector.detect_all([view])["area_px"], of_copy.detect_all([view.copy()])["area_px"])):
            assert repr(found) == repr(wanted)
        assert of_copy.detect(view.copy()).area_px > 0


def test_a_colour_picture_is_looked_at_as_grey():
    grey = picture(120.0, 100.0)
    found = fyd.FingerDetector().detect(np.repeat(grey[:, :, None], 3, axis=2))
    assert (found.x_mm, found.y_mm) == pytest.approx(millimetres(120.0, 100.0), abs=0.1)


@pytest.mark.parametrize("wrong", [np.zeros((240, 320)), np.zeros((240, 320), np.int8), np.zeros((240, 320), bool),
                                   np.zeros(320, np.uint8), np.zeros((240, 320, 4), np.uint8), np.zeros((1, 2, 3, 4), np.uint8),
                                   np.zeros((1, 40_000), np.uint8)])
def test_another_shape_or_type_is_named(wrong):
    with pytest.raises(fyd.InvalidValue, match="picture.*" + str(wrong.shape[-1])):
        fyd.FingerDetector().detect(wrong)


def test_a_picture_with_a_mask_is_refused():
    """What lies beneath it would be looked at."""
    masked = np.ma.array(picture(150.0, 120.0), mask=False)
    assert fyd.FingerDetector().detect(masked).contact
    masked[100:140, 130:170] = np.ma.masked
    with pytest.raises(TypeError, match="a mask hides some"):
        fyd.FingerDetector().detect(masked)
    with pytest.raises(TypeError, match="a mask hides some"):
        fyd.FingerDetector().detect_all([picture(150.0, 120.0), masked])


def test_several_pictures_give_columns():
    places = [(110.0 + 10 * i, 100.0 + 5 * i) for i in range(8)]
    pictures = np.stack([picture(*place) for place in places])
    columns = fyd.FingerDetector().detect_all(pictures)
    one_by_one = fyd.FingerDetector()
    for i, each in enumerate(pictures):
        found = one_by_one.detect(each)
        assert (columns["x_mm"][i], columns["contact"][i]) == (found.x_mm, found.contact)
    assert columns["contact"].dtype == bool and set(columns) == set(fyd.FingerDetection.units)
    assert len(fyd.FingerDetector().detect_all([])["x_mm"]) == 0


def test_the_overlay_shows_the_finger():
    detector = fyd.FingerDetector()
    found = detector.detect(picture(150.0, 120.0))
    x, y, width, height = detector.region_px
    mask = detector.overlay()
    assert mask.shape == (height, width) and mask[int(found.y_px) - y, int(found.x_px) - x] == 255
    assert set(np.unique(mask)) <= {0, 128, 255}
    detector.reset()


def test_its_parameters_are_the_steps():
    thesis = fyd.FingerDetector(fyd.Parameters({"sensing.finger_mode": "thesis"}))
    assert thesis.detect(picture(150.0, 120.0)).contact
