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


@pytest.fixture(scope="session")
def session(tmp_path_factory):
    """Made now, by the program that is tested."""
    path = tmp_path_factory.mktemp("made") / "session.h5"
    done = program("station", "--simulate", "--duration", 5, "--record", path, "--operator", "Zoë")
    assert done.returncode == 0, done.stderr
    return path


@pytest.fixture(scope="session")
def staircase(tmp_path_factory):
    """Says how its cloth answers: its target goes up and down. That of `session` hardly moves, and then it depends on what a
    computer's threads met whether half of what was measured is explained."""
    folder = tmp_path_factory.mktemp("staircase")
    maker = Path(os.environ["FYD"]).with_name("record_golden")
    done = subprocess.run([maker, folder, "staircase", "unused.toml"], capture_output=True, text=True, timeout=PATIENCE_s,
                          check=False)
    assert done.returncode == 0, done.stderr
    return folder / "staircase.h5"


@pytest.fixture(params=["changes.h5", "classic.h5", "surface.h5", "tare.h5"])
def golden(request):
    return GOLDEN / request.param


@pytest.fixture
def classic():
    with fyd.open(GOLDEN / "classic.h5") as recording:
        yield recording
