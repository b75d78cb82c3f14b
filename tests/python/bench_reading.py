#!/usr/bin/env python3
"""How quickly a recording is read, beside h5py on the same file, and by how much the values differ:
PYTHONPATH=build/release/python /usr/bin/python3 tests/python/bench_reading.py FILE [--runs N]

Each run opens the file anew; both read it out of the system's cache. Medians, and ratios to h5py of the same run: more
than 1 is quicker than h5py. h5py checks no checksum; this library checks the CRC32C of every block.
"""
import argparse
import statistics
import time

import h5py
import numpy as np

import fyd

COLUMNS = ("force_N", "indentation_mm", "stretch_reference_deg", "now_ns")


def one_by_h5py(path):
    with h5py.File(path, "r") as file:
        return {"force_N": file["telemetry"]["force_N"]}


def one_by_fyd(path):
    with fyd.open(path) as recording:
        return {"force_N": recording.telemetry["force_N"]}


def four_by_h5py(path):
    with h5py.File(path, "r") as file:
        rows = file["telemetry"][COLUMNS]  # in one pass
        return {name: np.ascontiguousarray(rows[name]) for name in COLUMNS}


def four_by_fyd(path):
    with fyd.open(path) as recording:
        telemetry = recording.telemetry.load(COLUMNS)
        return {name: telemetry[name] for name in COLUMNS}


def all_by_h5py(path):
    with h5py.File(path, "r") as file:
        rows = file["telemetry"][:]
        return {name: np.ascontiguousarray(rows[name]) for name in rows.dtype.names}


def all_by_fyd(path):
    with fyd.open(path) as recording:
        return dict(recording.telemetry.load())


def timed(read, path):
    start = time.perf_counter()
    values = read(path)
    return time.perf_counter() - start, values


def difference(ours, theirs):
    """Columns that do not have the same bits."""
    return sum(ours[name].tobytes() != theirs[name].tobytes() for name in theirs)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("file")
    parser.add_argument("--runs", type=int, default=15)
    arguments = parser.parse_args()
    rows = fyd.open(arguments.file).info.rows
    print(f"{rows} rows, {arguments.runs} runs")
    print("| read | h5py, ms | fyd, ms | ratio | columns that differ |\n|---|---|---|---|---|")
    for what, theirs, ours in (("one column", one_by_h5py, one_by_fyd), ("four columns", four_by_h5py, four_by_fyd),
                               ("all columns", all_by_h5py, all_by_fyd)):
        taken, ratios, differ = ([], []), [], 0
        for _ in range(arguments.runs):
            (slow_s, expected), (quick_s, values) = timed(theirs, arguments.file), timed(ours, arguments.file)
            taken[0].append(1e3 * slow_s)
            taken[1].append(1e3 * quick_s)
            ratios.append(slow_s / quick_s)
            differ += difference(values, expected)
        print(f"| {what} | {statistics.median(taken[0]):.1f} | {statistics.median(taken[1]):.1f} | "
              f"{statistics.median(ratios):.2f} ({min(ratios):.2f} to {max(ratios):.2f}) | {differ} |")


if __name__ == "__main__":
    main()
