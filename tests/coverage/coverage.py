#!/usr/bin/env python3
"""How much of the core its tests run: lines of all of it, and every branch of safety, protocols and recorder.

    cmake --preset branches && cmake --build --preset branches && ctest --preset branches
    python3 tests/coverage/coverage.py build/branches

That counts the three parts, which alone are unoptimised. Each process leaves its counts in counts/PROGRAM/PROCESS of
the build folder (remove them to begin anew). With the preset coverage everything is unoptimised, which takes hours, and
the lines of the whole core are counted too.

Branches that only an exception takes do not count (gcovr --exclude-throw-branches), nor do those behind such a one
(gcov.py beside this file), nor those that the compiler made of a closing brace. A branch that no test takes stands in
unreached.toml with the reason; one that does not stand there, one that stands there as open (a test could take it, and
none does), and a row there that fits none any more are errors. So is a line rate below the limit.

    python3 tests/coverage/coverage.py --rows

looks, without any build, whether the line of each row there stands in its file, as often as the row says.
"""

import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib

SOURCE = pathlib.Path(__file__).resolve().parents[2]
LEAST_LINES = 0.90  # of the core
EVERY_BRANCH = {
    "safety": r"core/pipeline/(safety|input_health|pipeline|pipeline_outputs|touch_motion)\.(cpp|h)",
    "protocol": r"core/protocol/.*",
    "recorder": r"core/recording/(writer|file)/.*|core/recording/packed_step\..*",
}


def add_up(program, out, folder):
    """Puts one program's counts, those of its processes together, into `out`. A process that was killed as it wrote has
    none."""
    processes = sorted(program.iterdir())
    total, lost = processes[0], 0
    for number, process in enumerate(processes[1:]):
        both = folder / str(number)
        run = subprocess.run(["gcov-tool", "merge", "--output", both, total, process], capture_output=True, text=True)
        good = run.returncode == 0 and not run.stderr
        lost += not good
        unused = both if not good else total if total.parent == folder else None
        total = both if good else total
        if unused:
            shutil.rmtree(unused, ignore_errors=True)
    shutil.copytree(total, out)
    print(f"{program.name}: {len(processes)} processes" + (f", the counts of {lost} are lost" if lost else ""), flush=True)


def counted(build):
    """gcovr's report of what all programs ran, as JSON; gcov.py asks gcov about each program's counts."""
    programs = sorted((build / "counts").glob("*"))
    if not programs:
        sys.exit(f"coverage.py: {build}: nothing was counted; expected the preset coverage or branches, built and run")
    out = build / "coverage.json"
    with tempfile.TemporaryDirectory() as temporary:
        added = pathlib.Path(temporary) / "added"
        added.mkdir()

        def added_one(program):
            folder = pathlib.Path(temporary) / program.name
            folder.mkdir()
            add_up(program, added / program.name, folder)

        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            list(pool.map(added_one, programs))
        run = subprocess.run(
            ["gcovr", "--root", SOURCE, "--object-directory", build, "--filter", f"{SOURCE}/core/",
             "--exclude-throw-branches", "--exclude-unreachable-branches", "--gcov-ignore-parse-errors", "-j", "2",
             "--gcov-executable", pathlib.Path(__file__).with_name("gcov.py"), "--json", out,
             build / "core", build / "tests", build / "app"],
            capture_output=True, text=True, env={**os.environ, "FYD_ADDED_COUNTS": str(added)})
    if run.returncode:
        sys.exit(f"coverage.py: gcovr: {run.stderr[-2000:]}")
    return json.loads(out.read_text())["files"]


def misplaced(rows):
    """What is wrong with where the rows say a line stands."""
    out = []
    for row in rows:
        file, times = SOURCE / row["file"], row.get("times", 1)
        found = sum(row["line"] in line for line in file.read_text().splitlines()) if file.exists() else 0
        if found != times:
            out.append(f"unreached.toml: {row['file']}: '{row['line']}' stands in {found} lines, expected {times}")
    return out


def main():
    arguments = argparse.ArgumentParser(description="How much of the core its tests run")
    arguments.add_argument("build", type=pathlib.Path, nargs="?")
    arguments.add_argument("--list", metavar="PART", help="the unreached branches of a part, as rows for unreached.toml")
    arguments.add_argument("--rows", action="store_true", help="only whether each row of unreached.toml still has its line")
    chosen = arguments.parse_args()
    excused = tomllib.loads((pathlib.Path(__file__).parent / "unreached.toml").read_text()).get("unreached", [])
    if chosen.rows:
        wrong = misplaced(excused)
        print("\n".join(wrong) or f"{len(excused)} rows, each with its line")
        return 1 if wrong or not excused else 0
    if not chosen.build:
        arguments.error("a build folder of the preset coverage or branches was expected")
    files = counted(chosen.build.resolve())
    used = [False] * len(excused)
    wrong = []

    folders = collections.defaultdict(lambda: [0, 0])
    for file in files:
        folder = "/".join(file["file"].split("/")[:2])
        for line in file["lines"]:
            if line.get("gcovr/noncode"):
                continue
            folders[folder][0] += 1
            folders[folder][1] += line["count"] > 0
    print(f"{'folder':24}{'lines':>8}{'run':>8}{'%':>7}")
    for folder, (lines, run) in sorted(folders.items()):
        print(f"{folder:24}{lines:8}{run:8}{100 * run / lines:7.1f}")
    lines = sum(each[0] for each in folders.values())
    run = sum(each[1] for each in folders.values())
    print(f"{'core':24}{lines:8}{run:8}{100 * run / lines:7.1f}")
    if not re.search("^FYD_COVERAGE:.*=all$", (chosen.build / "CMakeCache.txt").read_text(), re.MULTILINE):
        print("a part of the core: its lines are not judged")
    elif run < LEAST_LINES * lines:
        wrong.append(f"{100 * run / lines:.1f} % of the core's lines run, expected {100 * LEAST_LINES:.0f} % at least")

    print(f"\n{'part':12}{'branches':>10}{'taken':>8}{'excused':>9}{'open':>6}{'unnamed':>9}")
    for part, pattern in EVERY_BRANCH.items():
        counted_files, total, taken, named, still_open, unnamed = 0, 0, 0, 0, 0, 0
        for file in files:
            if not re.fullmatch(pattern, file["file"]):
                continue
            counted_files += 1
            text = (SOURCE / file["file"]).read_text().splitlines()
            for line in file["lines"]:
                branches = [b for b in line.get("branches", []) if not b.get("throw")]
                missed = sum(b["count"] == 0 for b in branches)
                total += len(branches)
                taken += len(branches) - missed
                if not missed:
                    continue
                words = text[line["line_number"] - 1].strip()
                rows = [i for i, row in enumerate(excused) if row["file"] == file["file"] and row["line"] in words]
                for i in rows:
                    used[i] = True
                excuses = min(missed, max((excused[i]["branches"] for i in rows), default=0))
                if any(excused[i].get("open", False) for i in rows):
                    still_open += excuses
                else:
                    named += excuses
                if excuses == missed:
                    continue
                unnamed += missed - excuses
                if chosen.list == part:
                    print(f"{file['file']}:{line['line_number']}: {missed} of {len(branches)}: {words}")
                else:
                    wrong.append(f"{file['file']}:{line['line_number']}: {missed} of {len(branches)} branches: {words}")
        print(f"{part:12}{total:10}{taken:8}{named:9}{still_open:6}{unnamed:9}")
        if not counted_files:
            wrong.append(f"{part}: no file was counted, expected those of {pattern}")
        if still_open:
            wrong.append(f"{part}: {still_open} branches are open in unreached.toml, expected a test or a reason")
    for row, was_used in zip(excused, used):
        if not was_used:
            wrong.append(f"unreached.toml: {row['file']}: '{row['line']}' fits no branch that is not taken")
    if chosen.list:
        return 0
    for line in wrong:
        print(f"WRONG {line}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
