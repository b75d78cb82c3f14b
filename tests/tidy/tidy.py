#!/usr/bin/env python3
"""clang-tidy with the repository's .clang-tidy over our sources; any finding is an error.

    python3 tests/tidy/tidy.py                   what changed since the branch left main, and a share of the rest
    python3 tests/tidy/tidy.py --all             the whole tree
    python3 tests/tidy/tidy.py --sample 40       so many files, spread over the tree
    python3 tests/tidy/tidy.py FILE...           these

The share is another one after each commit, so that runs in a row see the whole tree. It stops taking files after
--budget seconds and says how many it did not look at. Its compile commands are those of the preset `tidy`, which it
configures itself; the window's files also need what Qt's moc makes of them, which is built.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import time

SOURCE = pathlib.Path(__file__).resolve().parents[2]
BUILD = SOURCE / "build" / "tidy"
SHARES = 60  # of the tree: a run looks at one of them


def git(*words):
    run = subprocess.run(["git", "-C", SOURCE, *words], capture_output=True, text=True)
    return run.stdout.strip() if run.returncode == 0 else ""


def configured():
    """The .cpp of ours that the preset compiles, by their path in the repository."""
    if not (BUILD / "compile_commands.json").exists():
        run = subprocess.run(["cmake", "--preset", "tidy"], cwd=SOURCE, capture_output=True, text=True)
        if run.returncode:
            sys.exit(f"tidy.py: the preset tidy cannot be configured:\n{run.stdout}{run.stderr}")
    files = set()
    for entry in json.loads((BUILD / "compile_commands.json").read_text()):
        path = pathlib.Path(entry["file"]).resolve()
        if path.is_relative_to(SOURCE) and not path.is_relative_to(SOURCE / "build"):
            files.add(str(path.relative_to(SOURCE)))
    return sorted(files)


def changed(files):
    """Of a header the file of its name, or the first that includes it."""
    base = git("merge-base", "HEAD", "origin/main") or git("merge-base", "HEAD", "main")
    names = git("diff", "--name-only", base).splitlines() if base else []
    out = []
    for name in names:
        if name in files:
            out.append(name)
        elif name.endswith(".h") and (SOURCE / name).exists():
            own = name[:-2] + ".cpp"
            users = [own] if own in files else [f for f in files if f'#include "{name}"' in (SOURCE / f).read_text()]
            out += users[:1]
    return sorted(set(out))


def make_mocs(files):
    """What Qt's moc makes of a window's file is included by it."""
    if not any(re.search(r'#include ".*\.moc"', (SOURCE / file).read_text()) for file in files):
        return
    said = subprocess.run(["ninja", "-C", BUILD, "-t", "targets", "all"], capture_output=True, text=True).stdout
    targets = sorted(set(re.findall(r"^(\S*_autogen): phony", said, re.M)))
    if targets:
        subprocess.run(["ninja", "-C", BUILD, *targets], stdout=subprocess.DEVNULL, check=True)


def tidy(file):
    began = time.monotonic()
    run = subprocess.run(
        ["clang-tidy", "-p", BUILD, "--quiet", "--warnings-as-errors=*", SOURCE / file],
        capture_output=True, text=True, cwd=SOURCE)
    words = run.stdout.replace(f"{SOURCE}/", "")
    if run.returncode and not words:
        words = run.stderr
    return file, run.returncode == 0, words, time.monotonic() - began


def main():
    arguments = argparse.ArgumentParser(description="clang-tidy over our sources")
    arguments.add_argument("files", nargs="*")
    arguments.add_argument("--all", action="store_true")
    arguments.add_argument("--sample", type=int, default=0)
    arguments.add_argument("--budget", type=float, default=float("inf"), help="seconds until no more file is begun")
    arguments.add_argument("-j", type=int, default=os.cpu_count())
    chosen = arguments.parse_args()
    files = configured()
    if unknown := [file for file in chosen.files if file not in files]:
        sys.exit(f"tidy.py: not compiled by the preset tidy: {', '.join(unknown)}")
    if chosen.files:
        wanted = chosen.files
    elif chosen.all:
        wanted = files
    elif chosen.sample:
        wanted = files[:: max(1, len(files) // chosen.sample)][: chosen.sample]
    else:
        first = changed(files)
        turn = int(git("rev-list", "--count", "HEAD") or 0) % SHARES
        wanted = first + [file for file in files[turn::SHARES] if file not in first]
    make_mocs(wanted)
    began = time.monotonic()
    found, looked, spent = 0, 0, 0.0
    left = iter(wanted)
    with concurrent.futures.ThreadPoolExecutor(chosen.j) as pool:
        running = set()
        while True:
            while len(running) < chosen.j and time.monotonic() - began < chosen.budget:
                file = next(left, None)
                if file is None:
                    break
                running.add(pool.submit(tidy, file))
            if not running:
                break
            done, running = concurrent.futures.wait(running, return_when=concurrent.futures.FIRST_COMPLETED)
            for each in done:
                file, good, words, seconds = each.result()
                looked += 1
                spent += seconds
                if not good:
                    found += 1
                    print(f"{file}:\n{words}", flush=True)
    print(f"{looked} files of {len(wanted)} chosen, {len(files)} in the tree: {found} with findings; "
          f"{time.monotonic() - began:.0f} s, {spent / max(1, looked):.1f} s a file")
    if looked < len(wanted):
        print(f"not looked at within {chosen.budget:.0f} s: {len(wanted) - looked} files")
    return 1 if found or not looked else 0


if __name__ == "__main__":
    sys.exit(main())
