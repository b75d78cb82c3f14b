#!/usr/bin/env python3
"""clang-tidy with the repository's .clang-tidy over our sources; any finding is an error.

    python3 tests/tidy/tidy.py                   what changed since the branch left main, and a share of the rest
    python3 tests/tidy/tidy.py --all             the whole tree
    python3 tests/tidy/tidy.py --sample 40       so many units, spread over the tree
    python3 tests/tidy/tidy.py FILE...           the units of these files
    python3 tests/tidy/tidy.py --self-test       whether what is wrong in a unit's file and in its header is found

A unit is what the build compiles at once: files of a folder together, which so read their headers once (FydUnity.cmake).
The share is another one after each commit, so that runs in a row see the whole tree. No unit is begun after --budget
seconds of processor time, and the run says how many it did not look at.

The compile commands are those of the preset `tidy`, which is configured here; of it only precompiled headers are built.
With clang-tidy's own headers (libclang-dev) own_code.cpp is built too:
without it each unit takes two to four times as long.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import time

SOURCE = pathlib.Path(__file__).resolve().parents[2]
BUILD = SOURCE / "build" / "tidy"
SHARE = 4  # units of a run
FIRST = ["core", "app", "widgets", "tests"]
# What the files of a folder include and only a build makes, by its Ninja target.
MADE = {"app/bench/": "fyd_revision", "tests/golden/later/": "tests/golden/later/later/core/pipeline/inputs.h"}
FINDING = re.compile(r"^(\S[^:\n]*):\d+:\d+: (?:warning|error): .*\[([\w.,-]+)\]$", re.M)


def git(*words):
    run = subprocess.run(["git", "-C", SOURCE, *words], capture_output=True, text=True)
    return run.stdout.strip() if run.returncode == 0 else ""


def must(*words):
    run = subprocess.run([str(word) for word in words], cwd=SOURCE, capture_output=True, text=True)
    if run.returncode:
        sys.exit(f"tidy.py: {' '.join(map(str, words))}:\n{run.stdout}{run.stderr}")
    return run.stdout


def processor_s():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


class Tree:
    """The units that the preset compiles, each with its files by their path in the repository."""

    def __init__(self, build):
        self.build = build
        must("cmake", "--preset", "tidy", "-B", build)
        entries = json.loads((build / "compile_commands.json").read_text())
        self.files, self.commands = {}, {}
        for entry in sorted(entries, key=lambda each: "/together/" not in each["file"]):
            path = pathlib.Path(entry["file"])
            if "/together/" in entry["file"]:
                files = re.findall(r'#include "(.*)"', path.read_text())
            elif path.is_relative_to(SOURCE) and not path.is_relative_to(build):
                files = [str(path.relative_to(SOURCE))]
            else:
                continue  # made by moc, rcc or the tests: not ours
            seen = {file for unit in self.files.values() for file in unit}
            if set(files) <= seen:
                continue  # compiled once more with other flags
            self.files[entry["file"]] = files
            self.commands[entry["file"]] = entry
        # One entry a unit: clang-tidy looks at a file once for each that it finds.
        self.database = build / "clang-tidy"
        self.database.mkdir(exist_ok=True)
        (self.database / "compile_commands.json").write_text(json.dumps(list(self.commands.values())))
        self.units = sorted(self.files, key=lambda unit: (self.floor(unit), unit))

    def floor(self, unit):
        top = self.files[unit][0].split("/")[0]
        return FIRST.index(top) if top in FIRST else len(FIRST)

    def of(self, files):
        wanted = [unit for unit in self.units if set(files) & set(self.files[unit])]
        unknown = set(files) - {file for unit in wanted for file in self.files[unit]}
        if unknown:
            sys.exit(f"tidy.py: not compiled by the preset tidy: {', '.join(sorted(unknown))}")
        return wanted

    def changed(self):
        """The units of what changed; of a header those of the file of its name, or of the first that includes it."""
        files = {file for unit in self.units for file in self.files[unit]}
        base = git("merge-base", "HEAD", "origin/main") or git("merge-base", "HEAD", "main")
        out = set()
        for name in git("diff", "--name-only", base).splitlines() if base else []:
            if name in files:
                out.add(name)
            elif name.endswith(".h") and (SOURCE / name).exists():
                own = name[:-2] + ".cpp"
                line = f'#include "{name}"'
                users = [own] if own in files else [f for f in sorted(files) if line in (SOURCE / f).read_text()]
                out.update(users[:1])
        return self.of(out)

    def prepare(self, units, processes):
        """What the units read and is not in the source: precompiled headers, which Ninja would build after the libraries.

        What Qt's moc makes of a file is included by it, but it is not ours: an empty file does instead.
        """
        headers = set()
        for unit in units:
            command = self.commands[unit]["command"]
            headers.update(re.findall(r"-include-pch -Xclang (\S+)", command))
            target = re.search(r" -o (\S+)\.dir/", command)[1].replace("/CMakeFiles/", "/")
            for file in self.files[unit]:
                for moc in re.findall(r'#include "(\w+\.moc)"', (SOURCE / file).read_text()):
                    path = self.build / f"{target}_autogen" / "include" / moc
                    path.parent.mkdir(parents=True, exist_ok=True)
                    path.touch()
        for folder, target in MADE.items():
            if any(file.startswith(folder) for unit in units for file in self.files[unit]):
                must("ninja", "-C", self.build, target)
        with concurrent.futures.ThreadPoolExecutor(processes) as pool:
            list(pool.map(self.precompile, sorted(headers)))

    def precompile(self, header):
        """Each time, for a header in it may have changed; a compiler cache makes it quick."""
        path = pathlib.Path(header).relative_to(self.build)
        command = must("ninja", "-C", self.build, "-t", "commands", "-s", path).splitlines()[-1]
        (self.build / path).parent.mkdir(parents=True, exist_ok=True)
        run = subprocess.run(command, shell=True, cwd=self.build, capture_output=True, text=True)
        if run.returncode:
            sys.exit(f"tidy.py: {command}:\n{run.stdout}{run.stderr}")


def own_code(build):
    """The words that make clang-tidy look at our declarations only, if it can be told so."""
    root = pathlib.Path(must("clang++", "-print-resource-dir").strip()).parents[2]
    if not (root / "include/clang-tidy/ClangTidyCheck.h").exists():
        print("clang-tidy's own headers are not installed (libclang-dev): each unit takes two to four times as long")
        return []
    source, made = SOURCE / "tests/tidy/own_code.cpp", build / "own_code.so"
    if not made.exists() or made.stat().st_mtime < source.stat().st_mtime:
        build.mkdir(parents=True, exist_ok=True)
        cache = ["ccache"] if shutil.which("ccache") else []
        must(*cache, "clang++", "-std=c++17", "-O0", "-fno-rtti", "-fPIC", "-isystem", root / "include", "-c", source, "-o", f"{made}.o")
        must("clang++", "-shared", f"{made}.o", "-o", made)
    return [f"--load={made}", "--checks=fyd-own-code"]


def look(unit, database, words):
    """The findings, each once: its first line and its text."""
    began = time.monotonic()
    run = subprocess.run(["clang-tidy", f"--config-file={SOURCE / '.clang-tidy'}", *words, "-p", database, "--quiet", unit],
                         capture_output=True, text=True, cwd=SOURCE)
    out = {}
    starts = [found.start() for found in FINDING.finditer(run.stdout)] + [len(run.stdout)]
    for start, end in zip(starts, starts[1:]):
        text = run.stdout[start:end]
        found = FINDING.match(text)
        if found[1] == unit and found[2] == "bugprone-suspicious-include":
            continue  # that a unit includes files of ours is its purpose
        if found[1].endswith("/QtCore/qsharedpointer_impl.h") and found[2] == "clang-analyzer-cplusplus.NewDelete":
            continue  # it does not follow Qt's reference counts, and a NOLINT would have to stand in Qt's header
        out[found[0].replace(f"{SOURCE}/", "")] = text.replace(f"{SOURCE}/", "")
    if run.returncode and not starts[:-1]:
        out[unit] = run.stderr
    return unit, out, time.monotonic() - began


WRONG = {
    "core/wrong.h": """#pragma once
struct Wrong { virtual int value() { return 0; } virtual ~Wrong() = default; };
struct Worse : Wrong { virtual int value(); };  // modernize-use-override
""",
    "core/wrong.cpp": """#include "core/wrong.h"
#include <string>
#include <utility>
int Worse::value() { std::string a = "a"; std::string b = std::move(a); return int(a.size() + b.size()); }  // bugprone-use-after-move
template <class T> T turned(T end) { for (T x = 0; x < end; x += 1) end -= x; return end; }
double turnedOnce() { return turned(3.0); }  // clang-analyzer-security.FloatLoopCounter, two lines above
""",
    "unit.cpp": '#include "core/wrong.cpp"\n',
}


def self_test(build):
    words = own_code(build)
    place = build / "self_test"
    for name, text in WRONG.items():
        (place / name).parent.mkdir(parents=True, exist_ok=True)
        (place / name).write_text(text)
    unit = str(place / "unit.cpp")
    (place / "compile_commands.json").write_text(json.dumps(
        [{"directory": str(place), "command": f"clang++ -std=c++20 -I{place} -c {unit}", "file": unit}]))
    _, found, _ = look(unit, place, words)
    text = "\n".join(found)
    wanted = [("wrong.h:3", "modernize-use-override"), ("wrong.cpp:4", "bugprone-use-after-move"),
              ("wrong.cpp:5", "clang-analyzer-security.FloatLoopCounter")]
    lost = [check for where, check in wanted
            if not re.search(rf"{re.escape(where)}:\d+: warning: .*\[{re.escape(check)}", text)]
    print(text if not lost else f"not found: {', '.join(lost)}; found:\n{text}")
    return 1 if lost else 0


def main():
    arguments = argparse.ArgumentParser(description="clang-tidy over our sources")
    arguments.add_argument("files", nargs="*")
    arguments.add_argument("--all", action="store_true")
    arguments.add_argument("--sample", type=int, default=0)
    arguments.add_argument("--budget", type=float, default=float("inf"), help="seconds of processor time until no more unit is begun")
    arguments.add_argument("-j", type=int, default=os.cpu_count())
    arguments.add_argument("--self-test", action="store_true")
    chosen = arguments.parse_args()
    if chosen.self_test:
        return self_test(BUILD)
    tree = Tree(BUILD)
    units = tree.units
    if chosen.files:
        wanted = tree.of(chosen.files)
    elif chosen.all:
        wanted = units
    elif chosen.sample:
        wanted = units[:: max(1, len(units) // chosen.sample)][: chosen.sample]
    else:
        wanted = tree.changed()
        turn = int(git("rev-list", "--count", "HEAD") or 0) * SHARE
        wanted += [unit for unit in dict.fromkeys(units[(turn + k) % len(units)] for k in range(SHARE)) if unit not in wanted]
    tree.prepare(wanted, chosen.j)
    words = own_code(tree.build)
    began = time.monotonic()
    found, looked = {}, []
    left = iter(wanted)
    with concurrent.futures.ThreadPoolExecutor(chosen.j) as pool:
        running = set()
        while True:
            while len(running) < chosen.j and processor_s() < chosen.budget:
                unit = next(left, None)
                if unit is None:
                    break
                running.add(pool.submit(look, unit, tree.database, words))
            if not running:
                break
            done, running = concurrent.futures.wait(running, return_when=concurrent.futures.FIRST_COMPLETED)
            for each in done:
                unit, findings, seconds = each.result()
                looked.append(unit)
                print(f"{len(looked)}/{len(wanted)} {seconds:.0f} s {unit.replace(f'{SOURCE}/', '')}", flush=True)
                for first, text in findings.items():
                    if first not in found:
                        found[first] = text
                        print(text, flush=True)
    files = sum(len(tree.files[unit]) for unit in looked)
    everything = sum(len(tree.files[unit]) for unit in units)
    print(f"{files} files of {everything}, in {len(looked)} units of {len(units)}: {len(found)} findings; "
          f"{time.monotonic() - began:.0f} s, {processor_s():.0f} s of processor time with what was built for it")
    if len(looked) < len(wanted):
        print(f"not looked at within {chosen.budget:.0f} s: {len(wanted) - len(looked)} units")
    return 1 if found or not looked else 0


if __name__ == "__main__":
    sys.exit(main())
