#!/usr/bin/env python3
"""Fails on a fork() in the tests whose child does not ask to end with its parent (PR_SET_PDEATHSIG) within the next lines: an
endless one would outlive a test that is killed or fails. check_children.py TESTS | check_children.py --self-test
"""
import pathlib
import re
import sys
import tempfile

import check_main

FORK = re.compile(r"\bv?fork\(\)")
NEAR = 5  # lines


def problems(root):
    found, children = [], 0
    for file in sorted(path for path in root.rglob("*") if path.suffix in (".h", ".cpp")):
        lines = file.read_text(encoding="utf-8").splitlines()
        for number, line in enumerate(lines):
            if not FORK.search(line):
                continue
            children += 1
            if not any("PR_SET_PDEATHSIG" in each for each in lines[number:number + NEAR + 1]):
                found.append(f"{file.relative_to(root)}:{number + 1}: a child that may outlive the test: no PR_SET_PDEATHSIG within "
                             f"{NEAR} lines; tests/child_process.h has one that asks for it")
    if not children:
        found.append(f"{root}: no fork() at all was found")
    return found


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        (root / "good.h").write_text("id = ::fork();\nif (id == 0) {\n  ::prctl(PR_SET_PDEATHSIG, SIGKILL);\n")
        assert problems(root) == []
        (root / "late.cpp").write_text("id = ::fork();\n" + "\n" * NEAR + "::prctl(PR_SET_PDEATHSIG, SIGKILL);\n")
        assert [line.split(": ")[0] for line in problems(root)] == ["late.cpp:1"]
    with tempfile.TemporaryDirectory() as folder:
        assert len(problems(pathlib.Path(folder))) == 1
    return []


if __name__ == "__main__":
    check_main.end(self_test() if sys.argv[1] == "--self-test" else problems(pathlib.Path(sys.argv[1])))
