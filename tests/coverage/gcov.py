#!/usr/bin/env python3
"""gcov for gcovr: what several programs ran of one object, each counted for itself (coverage.py adds up its processes).

gcov says which branch only an exception takes, but of no block that never ran: so of each line of its answers that of
the program counts that ran it most often, and no report of one program alone is added to another's.

Left out are the branches of what only an exception reaches (catch blocks, destructors while unwinding). gcov knows these
blocks, but says so only of those that never ran (`$$$$$`). So it is also asked about the object without its counts.
"""

import os
import pathlib
import re
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


def often(line):
    """How often gcov's line says that it was run; -1 where it says that it never was."""
    times = re.match(r"\s*(\d+)\*?:|(?:branch|call)\s+\d+ (?:taken|returned) (\d+)", line)
    return int(times[1] or times[2]) if times else -1


def of_all(answers):
    """Of each line of gcov's answers about the same object that of the program that ran it most often."""
    if len({len(answer) for answer in answers}) != 1:
        return None
    return "".join(max(lines, key=often) for lines in zip(*answers))


def answers(notes, options, counts=None):
    """gcov's text for each source file of one object, with the counts of one program, or none."""
    with tempfile.TemporaryDirectory() as folder:  # gcov reads the counts beside the notes
        beside = pathlib.Path(folder)
        (beside / notes.name).symlink_to(notes)
        if counts:
            (beside / counts.name).symlink_to(counts)
        told = subprocess.run(["gcov", "--all-blocks", *options, beside / notes.name], capture_output=True, text=True)
        sys.stderr.write(told.stderr if counts else "")
        return told.stdout, {name: pathlib.Path(name).read_text() for name in CREATED.findall(told.stdout)}


def main():
    arguments = sys.argv[1:]
    notes = next((pathlib.Path(each) for each in arguments if each.endswith(".gcno")), None)
    if notes is None:
        return subprocess.run(["gcov", *arguments]).returncode
    notes = notes.resolve()
    options = [each for each in arguments if each.startswith("--") and each != "--object-directory"]
    said, never_run = answers(notes, options)
    programs = [answers(notes, options, counts)[1]
                for added in pathlib.Path(os.environ["FYD_ADDED_COUNTS"]).iterdir()
                for counts in [added / notes.with_suffix(".gcda").relative_to("/")] if counts.exists()]
    for name, text in never_run.items():
        counted = of_all([each[name].splitlines(keepends=True) for each in [never_run, *programs]])
        left = counted and without_exceptions(counted, text)
        if left is None:
            sys.exit(f"gcov.py: {notes}: {name}: its blocks are others without the counts")
        pathlib.Path(name).write_text(left)
    sys.stdout.write(said)
    return 0


if __name__ == "__main__":
    sys.exit(main())
