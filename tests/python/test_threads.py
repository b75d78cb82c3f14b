"""Long work is done without the interpreter's lock: another thread of Python goes on meanwhile.

Python hands the lock over by itself only after the switch interval, which is made longer than any test: what the other
thread did between two looks, it did because the lock was given up.
"""
import subprocess
import sys
import threading
import time

import h5py
import numpy as np
import pytest
from conftest import GOLDEN, ROOT

import fyd


@pytest.mark.parametrize("work", ["file.replay()", "fyd.welch(noise, 1000.0)"])
def test_a_thread_that_works_when_the_interpreter_ends_ends_with_it(work):
    script = f"""
import threading, time
import numpy as np
import fyd
file, noise, worked = fyd.open({str(GOLDEN / "classic.h5")!r}), np.random.default_rng(1).standard_normal(100_000), threading.Event()
def run():
    while True:
        {work}
        worked.set()
threading.Thread(target=run, daemon=True).start()
assert worked.wait(60)
time.sleep(0.05)
print("done")
"""
    for _ in range(4):
        done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=120)
        assert (done.returncode, done.stdout) == (0, "done\n"), done.stderr  # it may say that the file is closed by then


class Other:
    """A thread that counts, and gives up the lock after each step."""

    def __enter__(self):
        self.interval = sys.getswitchinterval()
        sys.setswitchinterval(1e6)
        self.count, self.ends = 0, False
        self.thread = threading.Thread(target=self.run, daemon=True)
        self.thread.start()
        while self.count == 0:
            time.sleep(0.001)
        return self

    def run(self):
        while not self.ends:
            self.count += 1
            time.sleep(0)

    def __exit__(self, *_):
        self.ends = True
        sys.setswitchinterval(self.interval)
        self.thread.join()

    def steps_during(self, work):
        before = self.count
        work()
        return self.count - before


def scene_run():
    scene = fyd.Scene.open(str(ROOT / "resources/scenes/echography.toml"))
    path = np.tile([1.0, 2.0, -1.0], (400_000, 1))
    times = np.arange(len(path)) * 0.001

    def work():
        scene.reset()
        scene.run(path, times)

    return work


def contact_run():
    mesh = fyd.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
    contact = fyd.Contact(mesh)
    path = np.full((300_000, 3), 0.1)
    return lambda: contact.run(path)


def replay_of_golden():
    recording = fyd.open(GOLDEN / "classic.h5")
    return lambda: [recording.replay() for _ in range(5)]


def read_of_golden():
    recording = fyd.open(GOLDEN / "classic.h5")
    return lambda: [fyd.Telemetry(recording._file).load() for _ in range(200)]


def chain_run():
    chain, noise = fyd.TextureChain(), np.random.default_rng(1).normal(size=(300_000, 3))
    return lambda: chain.run(noise)


def texture_run():
    surface = fyd.Surface.from_text((ROOT / "resources/textures/wood.toml").read_text())
    texture, speed, force = fyd.VirtualTexture(surface), np.full(200_000, 40.0), np.ones(200_000)
    return lambda: texture.run(speed, force)


def detections():
    detector, pictures = fyd.FingerDetector(), [np.full((240, 320), 200, np.uint8)] * 300
    return lambda: detector.detect_all(pictures)


def prediction():
    time_s = np.arange(20_000) * 0.001
    path = np.sin(time_s)[:, None]
    return lambda: fyd.predict_trial(time_s, path)


def noise_g():
    return np.random.default_rng(1).normal(size=(200_000, 3))


def fit_of_a_surface():
    accelerations_g = noise_g()
    return lambda: fyd.fit_surface(accelerations_g)


def spectrum():
    signal = noise_g().ravel()
    return lambda: fyd.welch(signal)


def match():
    accelerations_g = noise_g()
    return lambda: fyd.spectral_match(accelerations_g, accelerations_g[:, 0])


def plane(n=150):
    """n × n squares of two triangles."""
    x, y = (each.ravel() for each in np.mgrid[0:n + 1, 0:n + 1])
    corner = ((n + 1) * np.arange(n)[:, None] + np.arange(n)).ravel()
    low, high = (np.stack([corner + a, corner + b, corner + c], axis=1) for a, b, c in ((0, n + 1, 1), (1, n + 1, n + 2)))
    return np.stack([x, y, 0 * x], axis=1).astype(float), np.concatenate([low, high])


def mesh():
    vertices_mm, triangles = plane()
    return lambda: fyd.Mesh(vertices_mm, triangles)


@pytest.fixture(scope="module")
def mesh_file(tmp_path_factory):
    path = tmp_path_factory.mktemp("mesh") / "plane.obj"
    vertices_mm, triangles = plane()
    path.write_text("".join(f"v {x} {y} {z}\n" for x, y, z in vertices_mm)
                    + "".join(f"f {a} {b} {c}\n" for a, b, c in triangles + 1))
    path.with_suffix(".toml").write_text('[[body]]\nmesh = "plane.obj"\ncontact = "facet"\n')
    return path


LONG = [replay_of_golden, read_of_golden, chain_run, texture_run, detections, prediction, scene_run, contact_run,
        fit_of_a_surface, spectrum, match, mesh]


@pytest.mark.parametrize("made", LONG)
def test_another_thread_goes_on(made):
    work = made()
    with Other() as other:
        assert any(other.steps_during(work) > 0 for _ in range(50))  # busy processors may let it wait


@pytest.mark.parametrize("opened, ending", [(fyd.Mesh.open, ".obj"), (fyd.Scene.open, ".toml")])
def test_another_thread_goes_on_while_a_file_is_read(mesh_file, opened, ending):
    path = str(mesh_file.with_suffix(ending))
    with Other() as other:
        assert any(other.steps_during(lambda: opened(path)) > 0 for _ in range(50))


def test_work_that_keeps_the_lock_is_seen_to_keep_it():
    """The measure itself: NumPy's sort of Python objects never gives the lock up."""
    numbers = list(np.random.default_rng(1).normal(size=300_000))
    with Other() as other:
        assert all(other.steps_during(lambda: sorted(numbers)) == 0 for _ in range(5))


def test_one_object_in_two_threads_takes_turns():
    """A detector and a recording are for one thread at a time: the others wait, and the results are right."""
    recording = fyd.open(GOLDEN / "classic.h5")
    wanted = recording.telemetry["force_N"].tobytes()
    problems = []

    def read():
        for _ in range(5):
            if fyd.Telemetry(recording._file)["force_N"].tobytes() != wanted or not recording.replay().identical:
                problems.append("other values")

    threads = [threading.Thread(target=read) for _ in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert problems == []


def test_h5py_reads_meanwhile():
    """Both use one HDF5, which is not thread-safe: each waits for the other."""
    with h5py.File(GOLDEN / "classic.h5") as file:
        wanted = file["telemetry"][:].tobytes()
    problems, ends = [], threading.Event()

    def by_h5py():
        while not ends.is_set():
            with h5py.File(GOLDEN / "classic.h5") as file:
                if file["telemetry"][:].tobytes() != wanted:
                    problems.append("h5py read other values")

    other = threading.Thread(target=by_h5py)
    other.start()
    try:
        for _ in range(30):
            with fyd.open(GOLDEN / "changes.h5") as recording:
                recording.telemetry.load()
    finally:
        ends.set()
        other.join()
    assert problems == []
