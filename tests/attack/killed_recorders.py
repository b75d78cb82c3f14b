#!/usr/bin/python3
"""Recorders of whole stations killed at random moments, without and with readers at work on the growing file; every
second recovery is killed too, and done again. Nothing a reader saw is lost, the file is made whole, HDF5 itself opens
it, and its replay is identical.
  FYD=build/release/bin/fyd tests/attack/killed_recorders.py COUNT SEED
At full length: COUNT 100 (kills without readers, and as many with)."""
import json
import os
import random
import subprocess
import sys
import tempfile
import threading
import time

import h5py
import numpy

FYD = os.environ["FYD"]
LONGEST_WAIT_S = 60.0  # for a station to begin to record


def fyd(*arguments):
    done = subprocess.run([FYD, "session", *arguments, "--json"], capture_output=True, text=True, timeout=120, check=False)
    return done.returncode, json.loads(done.stdout) if done.stdout else {}, done.stderr


class Reader(threading.Thread):
    """Reads what was committed, again and again; `seen` is the most."""

    def __init__(self, look, path):
        super().__init__()
        self.look, self.path = look, path
        self.seen, self.looks, self.wrong = 0, 0, ""
        self.over = threading.Event()

    def run(self):
        while not self.over.is_set():
            try:
                self.seen = max(self.seen, self.look(self.path))
                self.looks += 1
            except AssertionError as wrong:
                self.wrong = str(wrong)
                return
            except OSError:
                time.sleep(0.01)  # HDF5 met the writer in the middle of a page: its readers look again


def by_h5py(path):
    with h5py.File(path + ".partial", "r", swmr=True) as file:
        committed = int(file["commits"][-1]["rows"][0])
        steps = file["telemetry"][:committed]["step"].astype("int64")
        backwards = numpy.flatnonzero(numpy.diff(steps) < 1)
        assert len(backwards) == 0, f"h5py sees step {steps[backwards[0] + 1]} after {steps[backwards[0]]} in row " \
                                    f"{backwards[0] + 1} of {committed}"
        return committed


def by_info(path):
    code, info, error = fyd("info", path)
    assert code == 0, f"info of a growing recording: {error}"
    assert info["wholeness"] in ("growing", "crashed"), info["wholeness"]
    return info["committed_samples"]


def by_verify(path):
    code, checked, error = fyd("verify", path)
    assert code == 0 and checked["intact"], f"verify of a growing recording: {error}"
    return 0


def begun(path, recorder):
    """Waits until something is committed; says how much."""
    end = time.monotonic() + LONGEST_WAIT_S
    while time.monotonic() < end:
        assert recorder.poll() is None, "the station ended by itself"
        code, info, _ = fyd("info", path)
        if code == 0 and info["committed_samples"] > 0:
            return info["committed_samples"]
        time.sleep(0.02)
    raise AssertionError(f"nothing was committed within {LONGEST_WAIT_S} s")


def attack(folder, dice, with_readers, kill_recovery):
    path = os.path.join(folder, "session.h5")
    recorder = subprocess.Popen([FYD, "station", "--simulate", "--record", path],
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    readers = []
    try:
        seen = begun(path, recorder)
        if with_readers:
            readers = [Reader(look, path) for look in (by_h5py, by_info, by_verify)]
            for reader in readers:
                reader.start()
        time.sleep(dice.uniform(0.0, 1.5))
    finally:
        recorder.kill()
        recorder.wait()
        for reader in readers:
            reader.over.set()
        for reader in readers:
            reader.join()
    for reader in readers:
        assert not reader.wrong, reader.wrong
        seen = max(seen, reader.seen)
    code, info, error = fyd("info", path)
    assert code == 0, error
    assert info["wholeness"] == "crashed", info["health_reason"]
    committed = info["committed_samples"]
    assert committed >= seen, f"{committed} steps are left of {seen} that a reader saw"
    code, checked, error = fyd("verify", path)
    assert code == 0 and checked["intact"], error
    if kill_recovery:
        recovery = subprocess.Popen([FYD, "session", "recover", path], stdout=subprocess.DEVNULL,
                                    stderr=subprocess.DEVNULL)
        time.sleep(dice.uniform(0.0, 0.08))
        recovery.kill()
        recovery.wait()
    code, recovered, error = fyd("recover", path)
    assert code == 0 and recovered["result"] == "whole", error
    assert recovered["samples"] == committed, f"{recovered['samples']} steps are left of {committed}"
    code, info, error = fyd("info", path)
    assert code == 0 and info["health"] == ("good" if info["gaps"] == 0 else "gaps"), info["health_reason"] + error
    with h5py.File(path, "r") as file:
        steps = file["telemetry"]["step"].astype("int64")
        jumped = int((numpy.diff(steps) - 1).sum())
        assert len(steps) == committed and numpy.all(numpy.diff(steps) >= 1), "h5py sees other steps"
        assert jumped <= info["gaps"], f"{jumped} steps are missing, {info['gaps']} are counted"
    code, replay, error = fyd("replay", path)
    assert replay["different"] == 0, error
    # A machine that stands still too long for the recorder's ring loses steps, which is counted: a replay ends there.
    assert jumped > 0 or (code == 0 and replay["identical"]), error
    return sum(reader.looks for reader in readers), int(info["gaps"] > 0)


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 1
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else 1
    dice = random.Random(seed)
    looks = gaps = broken = 0
    for with_readers in (False, True):
        for number in range(count):
            with tempfile.TemporaryDirectory() as folder:
                try:
                    looked, gap = attack(folder, dice, with_readers, number % 2 == 1)
                    looks += looked
                    gaps += gap
                except AssertionError as wrong:
                    broken += 1
                    print(f"BROKEN kill {number}, {'with' if with_readers else 'without'} readers: {wrong}", flush=True)
    print(f"{count} kills without and {count} with readers, which looked {looks} times; {gaps} times the machine was too "
          f"busy for the recorder, which counted it: {broken} did not hold")
    return 1 if broken else 0


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as home:
        # What programs keep of a user (the catalogue of sessions, profiles) stays out of the tester's own folders.
        os.environ |= {"XDG_DATA_HOME": os.path.join(home, "data"), "XDG_CONFIG_HOME": os.path.join(home, "config")}
        sys.exit(main())
