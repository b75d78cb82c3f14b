"""Contact against Hooke's law on bodies whose shape is known, scenes from files."""
import math
import os

import numpy as np
import pytest
from conftest import ROOT

import fyd

# A box of 100 × 100 × 40 mm, its top at z = 0.
CORNERS_mm = np.array([[x, y, z] for z in (-40, 0) for x, y in ((-50, -50), (50, -50), (50, 50), (-50, 50))], float)
FACES = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
TRIANGLES = np.array([triangle for a, b, c, d in FACES for triangle in ((a, b, c), (a, c, d))])


@pytest.fixture
def box():
    return fyd.Mesh(CORNERS_mm, TRIANGLES)


def obj():
    return "".join(f"v {x} {y} {z}\n" for x, y, z in CORNERS_mm) + "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in TRIANGLES)


def press(depth_mm):
    """Straight down at one place."""
    return np.stack([np.full_like(depth_mm, 12.3), np.full_like(depth_mm, -7.1), -depth_mm], axis=1)


def test_a_mesh_has_its_measures(box):
    assert box.volume_mm3 == pytest.approx(100 * 100 * 40)
    assert box.area_mm2 == pytest.approx(2 * 100 * 100 + 4 * 100 * 40)
    assert (box.holes, box.pieces) == (0, 1)
    assert np.array_equal(np.sort(box.vertices_mm, axis=0), np.sort(CORNERS_mm, axis=0))
    vertices = box.vertices_mm
    assert np.shares_memory(vertices, box.vertices_mm) and not vertices.flags.writeable
    del box
    assert vertices.shape == (8, 3)  # it keeps the mesh


def test_none_is_no_mesh():
    """A null mesh that was touched ended the process."""
    for touched in (lambda: fyd.Contact(None), lambda: fyd.Contact(mesh=None), lambda: fyd.Mesh.vertices_mm.fget(None),
                    lambda: fyd.Mesh.triangles.fget(None)):
        with pytest.raises(TypeError):
            touched()


@pytest.mark.parametrize("model", ["facet", "proxy", "vicinity"])
def test_a_press_is_hooke_s_law(box, model):
    depth_mm = np.arange(-2, 3, 0.05)
    contact = fyd.Contact(box, contact=model, stiffness_N_per_mm=0.8)
    force_N = contact.run(press(depth_mm))
    np.testing.assert_allclose(force_N[:, 2], 0.8 * np.maximum(depth_mm, 0), atol=1e-3)
    np.testing.assert_allclose(force_N[:, :2], 0, atol=1e-3)
    assert (contact.run([[math.nan, 0, 0], [math.inf, 0, 0]]) == 0).all()


def test_a_mesh_file_is_read_in_its_unit(tmp_path):
    path = tmp_path / "box.obj"
    path.write_text(obj())
    assert fyd.Mesh.open(path).volume_mm3 == fyd.Mesh.open(os.fsencode(path)).volume_mm3 == pytest.approx(100 * 100 * 40)
    for no_path in (7, None, ["box.obj"]):
        with pytest.raises(TypeError, match="str, bytes or os.PathLike"):
            fyd.Mesh.open(no_path)
        with pytest.raises(TypeError, match="str, bytes or os.PathLike"):
            fyd.Scene.open(no_path)
    assert fyd.Mesh.open(path.as_posix(), "cm").volume_mm3 == pytest.approx(1000 * 100 * 100 * 40)
    with pytest.raises(fyd.InvalidValue, match="ell.*mm, cm"):
        fyd.Mesh.open(path.as_posix(), "ell")
    with pytest.raises(fyd.Error, match="nowhere.obj"):
        fyd.Mesh.open("nowhere.obj")
    path.write_text("once upon a time")
    with pytest.raises(fyd.Error, match="box.obj"):
        fyd.Mesh.open(path.as_posix())


def test_a_scene_is_stepped(tmp_path):
    (tmp_path / "box.obj").write_text(obj())
    scene_file = tmp_path / "one.toml"
    scene_file.write_text('[[body]]\nname = "box"\nmesh = "box.obj"\nstiffness_N_per_mm = 0.8\ncontact = "facet"\n')
    scene = fyd.Scene.open(scene_file)
    assert scene.bodies == ["box"]
    depth_mm = np.linspace(-2, 3, 500)
    felt = scene.run(press(depth_mm), np.arange(500) * 0.001)
    np.testing.assert_allclose(felt["force_N"][:, 2], 0.8 * np.maximum(depth_mm, 0), atol=1e-4)
    assert np.array_equal(felt["touching"], felt["depth_mm"] > 0) and felt["touching"].dtype == bool
    assert set(felt["body"][felt["touching"]]) == {0} and set(felt["body"][~felt["touching"]]) == {-1}
    again = fyd.Scene.open(scene_file.as_posix())
    for i in range(500):
        touch = again.step(press(depth_mm)[i], 0.001 * i)
    assert touch.force_N == tuple(felt["force_N"][-1]) and touch.touching and touch.body == 0
    # It can stand in the robot's place.
    out = fyd.Pipeline(scene=scene).step(fyd.Inputs(now_ns=1))
    assert out.telemetry.step == 1
    assert not scene.step([math.nan, 0, 0], 1.0).touching


def test_a_scene_in_a_pipeline_has_the_rate_of_its_steps():
    name = str(ROOT / "resources/scenes/echography.toml")
    half = fyd.Parameters({"texture.sample_rate_Hz": 500})
    with pytest.raises(fyd.InvalidValue, match=r"scene: opened for 500 Hz; expected 1000 Hz, texture\.sample_rate_Hz"):
        fyd.Pipeline(scene=fyd.Scene.open(name, 500))
    with pytest.raises(fyd.InvalidValue, match="scene: opened for 1000 Hz; expected 500 Hz"):
        fyd.Pipeline(half, scene=fyd.Scene.open(name))
    fyd.Pipeline(half, scene=fyd.Scene.open(name, 500)).step(fyd.Inputs(now_ns=1))


def test_a_proxy_goes_on_until_it_is_reset(box):
    """Friction holds it back where the last call left it; after a reset nothing is behind it."""
    contact = fyd.Contact(box, contact="proxy", stiffness_N_per_mm=0.8, static_friction=0.5, kinetic_friction=0.4)
    pressed = [[0, 0, 1], [0, 0, -1]]
    assert contact.run(pressed)[-1] == pytest.approx([0, 0, 0.8], abs=1e-4)
    on = contact.run([[5, 0, -1]])[0]
    assert on[0] < -0.1  # held back
    contact.reset()
    fresh = fyd.Contact(box, contact="proxy", stiffness_N_per_mm=0.8, static_friction=0.5, kinetic_friction=0.4)
    assert np.array_equal(contact.run(pressed), fresh.run(pressed))
    contact.reset()
    assert contact.run([[5, 0, 1], [5, 0, -1]])[-1] == pytest.approx([0, 0, 0.8], abs=1e-4)


def test_another_way_begins_with_a_reset():
    """What comes again at the same times would be felt as the last place of the way before."""
    scene = fyd.Scene.open(str(ROOT / "resources/scenes/echography.toml"))
    way, times = press(np.linspace(-2, 3, 300)), np.arange(300) * 0.001
    first = scene.run(way, times)
    assert first["touching"].any()
    with pytest.raises(fyd.InvalidValue, match=r"time_s: row 0 is 0 s; expected more than 0\.299 s, the last step's, or reset\(\)"):
        scene.run(way, times)
    scene.reset()
    again = scene.run(way, times)
    assert all(first[name].tobytes() == again[name].tobytes() for name in first)
    after = scene.run(way[-2:], [0.3, math.nan])  # goes on; what has no time touches nothing
    assert after["touching"].tolist() == [True, False]
    for wrong, row in (([0.4, 0.4], 1), ([0.5, math.nan, 0.45], 2), ([0.3, 0.6], 0)):
        with pytest.raises(fyd.InvalidValue, match=f"time_s: row {row} is {wrong[row]:g} s"):
            scene.run(way[:len(wrong)], wrong)
    assert scene.run(way[-1:], [0.35])["touching"].all()  # a refused way was not begun
    scene.step(way[-1], 0.7)
    with pytest.raises(fyd.InvalidValue, match=r"more than 0\.7 s"):
        scene.run(way[-1:], [0.65])


@pytest.mark.parametrize("name", ["echography", "fencing", "tennis"])
def test_the_scenes_that_come_along_run(name):
    scene = fyd.Scene.open(str(ROOT / f"resources/scenes/{name}.toml"))
    felt = scene.run(press(np.linspace(-5, 5, 1000)), np.arange(1000) * 0.001)
    assert all(np.isfinite(felt[column]).all() for column in ("force_N", "depth_mm", "stiffness_N_per_mm", "texture_g"))


def test_what_is_not_possible_is_named(box, tmp_path):
    with pytest.raises(fyd.InvalidValue, match="vertices_mm"):
        fyd.Mesh(CORNERS_mm[:, :2], TRIANGLES)
    with pytest.raises(fyd.InvalidValue, match=r"triangles: shape \(12, 2\)"):
        fyd.Mesh(CORNERS_mm, TRIANGLES[:, :2])
    with pytest.raises(fyd.InvalidValue, match="row 0 names vertex 8; expected one of 0 to 7"):
        fyd.Mesh(CORNERS_mm, [[8, 1, 2]])
    with pytest.raises(fyd.InvalidValue, match="row 0 names vertex -1"):
        fyd.Mesh(CORNERS_mm, [[-1, 1, 2]])
    for cut in ([[0, 1, 2.7]], np.array([[0, 1, 2.7]]), [[0, 1, math.nan]], [[0, 1, 1e300]]):
        with pytest.raises(fyd.InvalidValue, match="row 0 names vertex (2.7|nan|1e.300); expected one of 0 to 7"):
            fyd.Mesh(CORNERS_mm, cut)
    assert fyd.Mesh(CORNERS_mm, TRIANGLES.astype(float)).volume_mm3 == fyd.Mesh(CORNERS_mm, TRIANGLES.tolist()).volume_mm3
    with pytest.raises(fyd.InvalidValue):
        fyd.Mesh(np.full((3, 3), np.nan), [[0, 1, 2]])
    for value in (math.nan, -1, 0, 1e9):
        with pytest.raises(fyd.InvalidValue, match="body.stiffness_N_per_mm"):
            fyd.Contact(box, stiffness_N_per_mm=value)
    with pytest.raises(fyd.InvalidValue, match="colour"):
        fyd.Contact(box, colour="red")
    for of_the_body in ("texture", "position_mm", "mass_kg"):  # a scene's, and nothing here would heed them
        with pytest.raises(fyd.InvalidValue, match=f"{of_the_body}: a contact has no such key; expected one of contact, "):
            fyd.Contact(box, **{of_the_body: "1"})
    with pytest.raises(fyd.InvalidValue, match="soft"):
        fyd.Contact(box, soft=True)
    with pytest.raises(fyd.InvalidValue, match="contact"):
        fyd.Contact(box, contact="telepathy")
    with pytest.raises(fyd.InvalidValue, match="automatic"):
        fyd.Contact(box, contact="automatic")
    with pytest.raises(fyd.InvalidValue, match="period_s"):
        fyd.Contact(box).run(press(np.zeros(2)), math.nan)
    with pytest.raises(fyd.InvalidValue, match="probe_mm"):
        fyd.Contact(box).run(np.zeros(3))
    wrong = tmp_path / "wrong.toml"
    wrong.write_text('[[body]]\nmesh = "nowhere.obj"\n')
    with pytest.raises(fyd.Error, match="nowhere.obj"):
        fyd.Scene.open(wrong.as_posix())
    with pytest.raises(fyd.Error, match="absent.toml"):
        fyd.Scene.open("absent.toml")
    scene = fyd.Scene.open(str(ROOT / "resources/scenes/tennis.toml"))
    with pytest.raises(fyd.InvalidValue, match="time_s"):
        scene.run(np.zeros((3, 3)), [0.0])
    with pytest.raises(fyd.InvalidValue, match="probe_mm"):
        scene.step([0, 0], 0.0)
