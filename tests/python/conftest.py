"""Recordings for the tests: golden ones, and one that is made once, by the program."""
import os
import subprocess
from pathlib import Path

import pytest

import fyd

ROOT = Path(os.environ["FYD_SOURCE_DIR"])
GOLDEN = ROOT / "tests/data/recordings/arithmetic_2"
PATIENCE_s = 120


def program(*arguments):
    return subprocess.run([os.environ["FYD"], *map(str, arguments)], capture_output=True, text=True, timeout=PATIENCE_s,
                          check=False)


@pytest.fixture(scope="session", autouse=True)
def own_home(tmp_path_factory):
    """What the program keeps of a user stays out of the tester's own folders."""
    home = tmp_path_factory.mktemp("home")
    os.environ |= {"XDG_DATA_HOME": str(home / "data"), "XDG_CONFIG_HOME": str(home / "config")}


@pytest.fixture(scope="session")
def session(tmp_path_factory):
    """Made now, by the program that is tested."""
    path = tmp_path_factory.mktemp("made") / "session.h5"
    done = program("station", "--simulate", "--duration", 5, "--record", path, "--operator", "Zoë")
    assert done.returncode == 0, done.stderr
    return path


@pytest.fixture(params=["changes.h5", "classic.h5", "surface.h5", "tare.h5"])
def golden(request):
    return GOLDEN / request.param


@pytest.fixture
def classic():
    with fyd.open(GOLDEN / "classic.h5") as recording:
        yield recording
