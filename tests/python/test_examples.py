"""The manual's scripts run, and say what the recording holds."""
import re
import subprocess
import sys

import h5py
import numpy as np
from conftest import ROOT, changed_copy

EXAMPLES = ROOT / "resources/manual/examples"


def output_of(name, *arguments):
    done = subprocess.run([sys.executable, EXAMPLES / name, *arguments], capture_output=True, text=True, check=False, cwd=ROOT)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_every_script_is_tried_here():
    assert sorted(path.name for path in EXAMPLES.glob("*.py")) == ["compare_gains.py", "fit_texture.py", "look_at_session.py"]


def test_looking_at_a_session(session):
    text = output_of("look_at_session.py", session)
    with h5py.File(session) as file:
        rows, events = file["telemetry"][:], len(file["events"])
    assert f"{len(rows)} steps" in text and "whole" in text
    begins = np.count_nonzero(np.diff(rows["contact"].astype(int), prepend=0) == 1)
    assert len(re.findall(r"^touch \d", text, re.M)) == begins > 0
    most_N = max(float(each) for each in re.findall(r"at most ([\d.]+) N", text))
    assert abs(most_N - np.nanmax(rows["force_N"][rows["contact"] == 1])) < 0.0051
    assert len(re.findall(r"^ *[\d.]+ s  \w+(?:  \w+)?$", text, re.M)) == events
    said = re.findall(r"^ *[\d.]+ s  (\w+)(  \w+)?$", text, re.M)
    assert {kind for kind, state in said if state} <= {"state_changed", "arm_refused"}
    assert all(state for kind, state in said if kind == "state_changed")


def test_comparing_two_gains(staircase):
    text = output_of("compare_gains.py", staircase)
    assert "the same bit for bit" in text and "not the same" not in text
    different = [int(each) for each in re.findall(r"(\d+) steps differ", text)]
    assert len(different) == 2 and min(different) > 0
    felt = re.findall(r"felt: ([\d.]+) % .*, ([\d.]+) % as recorded; the force off by ([\d.]+) N", text)
    assert len(felt) == 2 and all(float(force_N) > 0 for _, _, force_N in felt)
    assert felt[0][1] == felt[1][1] and felt[0][0] != felt[1][0]


def test_comparing_two_gains_where_steps_were_lost(staircase, tmp_path):
    path = tmp_path / "gap.h5"
    with changed_copy(staircase, path, "telemetry") as file:
        rows = file["telemetry"][:]
        rows["step"][-500:] += 7
        file["telemetry"][:] = rows
        commits = file["commits"][:]
        commits["jumped"][commits["rows"][:, 0] > len(rows) - 500] = 7
        file["commits"][:] = commits
    text = output_of("compare_gains.py", path)
    assert f"{len(rows) - 500} of {len(rows) + 7} steps, not the same bit for bit" in text and "7 steps are lost" in text
    assert len(re.findall(r"steps differ, stretch off by [\d.]+° RMS", text)) == 2
    assert len(re.findall(r"the force off by [\d.]+ N", text)) == 2


def test_fitting_a_texture():
    text = output_of("fit_texture.py")
    rms_g = [float(each) for each in re.findall(r"([\d.]+) g RMS", text)]
    assert len(rms_g) == 3 and rms_g[0] < rms_g[1] < rms_g[2]
    chain, fit = (float(each) for each in re.findall(r"spectral match ([\d.]+)", text))
    assert chain > 0.9 and fit > 0.4  # six bands are all that fit below the 50 Hz of this recording
