#!/usr/bin/env python3
"""gcov for gcovr, without the branches of what only an exception reaches (catch blocks, destructors while unwinding).

gcov knows these blocks, but says so only of those that never ran (`$$$$$`). So it is also asked about the object
without its counts, where nothing ran, and what it says there is left out of the counted answer.
"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ONLY_EXCEPTIONS = "$$$$$"
CREATED = re.compile(r"^Creating '(.*)'", re.MULTILINE)


def structure(text):
    """Of each line of gcov's answer: block's line and number, "branch N", or nothing; and whether its block is marked."""
    kinds, marked, exceptional = [], [], False
    for line in text.splitlines():
        block = re.match(r"\s*(\S+):\s*(\d+-block\s+\d+)", line)
        branch = re.match(r"branch\s+\d+", line)
        if block:
            exceptional = block[1].rstrip("*") == ONLY_EXCEPTIONS
        elif not branch and re.match(r"\s*\S+:\s*\d+:", line):
            exceptional = False  # the next source line
        kinds.append(block[2] if block else branch[0] if branch else None)
        marked.append(exceptional)
    return kinds, marked


def without_exceptions(counted, never_run):
    """The counted answer for one source file without the branches whose blocks the other marks."""
    kinds, _ = structure(counted)
    wanted = [(kind, mark) for kind, mark in zip(*structure(never_run)) if kind]
    if [kind for kind in kinds if kind] != [kind for kind, _ in wanted]:
        return None
    marks = iter(mark for _, mark in wanted)
    lines = counted.splitlines(keepends=True)
    return "".join(line for line, kind in zip(lines, kinds) if not (kind and next(marks) and kind.startswith("branch")))


def main():
    arguments = sys.argv[1:]
    data = next((pathlib.Path(each) for each in arguments if each.endswith((".gcda", ".gcno"))), None)
    if data is None:
        return subprocess.run(["gcov", *arguments]).returncode
    never_run = {}
    with tempfile.TemporaryDirectory() as folder:  # gcov reads the counts beside the notes, and here are none
        notes = pathlib.Path(folder) / data.with_suffix(".gcno").name
        shutil.copy(data.with_suffix(".gcno"), notes)
        options = [each for each in arguments if each.startswith("--") and each != "--object-directory"]
        told = subprocess.run(["gcov", "--all-blocks", *options, notes], capture_output=True, text=True, check=True)
        for name in CREATED.findall(told.stdout):
            never_run[name] = pathlib.Path(name).read_text()  # the next answer takes its place
    counted = subprocess.run(["gcov", "--all-blocks", *arguments], capture_output=True, text=True)
    sys.stderr.write(counted.stderr)
    for name in CREATED.findall(counted.stdout):
        answer = pathlib.Path(name)
        left = without_exceptions(answer.read_text(), never_run[name])
        if left is None:
            sys.exit(f"gcov.py: {data}: {name}: its blocks are others without the counts")
        answer.write_text(left)
    sys.stdout.write(counted.stdout)
    return counted.returncode


if __name__ == "__main__":
    sys.exit(main())
