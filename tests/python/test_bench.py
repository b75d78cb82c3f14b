"""The benchmark of reading runs, and finds the same bits; how long it takes is no matter here."""
import subprocess
import sys

from conftest import GOLDEN, ROOT


def test_it_finds_no_difference():
    done = subprocess.run([sys.executable, ROOT / "tests/python/bench_reading.py", GOLDEN / "classic.h5", "--runs", "2"],
                          capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    table = [line.split("|") for line in done.stdout.split("\n") if line.startswith(("| one", "| four", "| all"))]
    assert [row[-2].strip() for row in table] == ["0", "0", "0"]
