"""Recordings for the tests: golden ones, and one that is made once, by the program."""
import os
import shutil
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path

import h5py
import pytest

import fyd

ROOT = Path(os.environ["FYD_SOURCE_DIR"])
GOLDEN = ROOT / "tests/data/recordings/arithmetic_2"
PATIENCE_s = 120
TABLES = {"telemetry": 0, "notes/text": 15}  # places in a commit, as resources/manual/recording-format.md has them

sys.path.append(str(ROOT / "tests/attack"))
import hostile_bytes  # noqa: E402  (checksums)


@contextmanager
def changed_copy(source, path, *tables):
    """A copy that h5py may change in its header and these tables; the checksums of both are right again at the end."""
    shutil.copy(source, path)
    with h5py.File(path, "r+") as file:
        yield file
        hostile_bytes.seal_header(file)
        commits = file["commits"]
        for table in tables:
            rows, first, place = file[table][:], 0, TABLES[table]
            for number in range(len(commits)):
                commit = commits[number:number + 1]
                last = int(commit["rows"][0][place])
                if last > first:
                    commit["crc"][0][place] = hostile_bytes.crc32c(rows[first:last].tobytes())
                commits[number:number + 1] = hostile_bytes.sealed(commit)
                first = last


def program(*arguments):
    return subprocess.run([os.environ["FYD"], *map(str, arguments)], capture_output=True, text=True, timeout=PATIENCE_s,
                          check=False)


@pytest.fixture(scope="session", autouse=True)
def own_home(tmp_path_factory):
    """What the program keeps of a user stays out of the tester's own folders."""
    home = tmp_path_factory.mktemp("home")
    os.environ |= {"XDG_DATA_HOME": str(home / "data"), "XDG_CONFIG_HOME": str(home / "config")}


def made_now(folder):
    """A session of the program that is tested."""
    path = folder / "session.h5"
    done = program("station", "--simulate", "--duration", 5, "--record", path, "--operator", "Zoë")
    assert done.returncode == 0, done.stderr
    return path


@pytest.fixture(scope="session")
def session(tmp_path_factory):
    return made_now(tmp_path_factory.mktemp("made"))


@pytest.fixture(scope="session")
def telling_session(tmp_path_factory):
    """One that says how its cloth answers. Its target is nearly constant, so the arming alone moves the stretch; threads
    of a busy machine meet it at other moments, and then half of what was measured is not explained."""
    refusals = []
    for _ in range(10):
        path = made_now(tmp_path_factory.mktemp("telling"))
        with fyd.open(path) as recording:
            try:
                recording.replay(closed_loop=True)
                return path
            except fyd.Error as error:
                assert "excitation" in str(error)
                refusals.append(str(error))
    raise AssertionError(f"none of ten sessions says how its cloth answers: {refusals}")


@pytest.fixture(params=["changes.h5", "classic.h5", "surface.h5", "tare.h5"])
def golden(request):
    return GOLDEN / request.param


@pytest.fixture
def classic():
    with fyd.open(GOLDEN / "classic.h5") as recording:
        yield recording
