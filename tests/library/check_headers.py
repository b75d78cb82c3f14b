#!/usr/bin/env python3
"""Fails on an installed header without its line on stability, and on one that does not compile alone against the
installed tree: PREFIX=… LIBDIR=… CXX=… check_headers.py LIST | check_headers.py --self-test.
"""
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys

STABILITY = re.compile(r"^// Stability: (stable since \d+\.\d+|may change)$", re.M)


def is_list(text):
    """Whether others include it several times, for the lines of a list: it does not stand alone."""
    return "\n#pragma once\n" not in text and "no #pragma once" in re.sub(r"\n// ", " ", text)


def stability_problem(name, text):
    head = re.match(r"(//.*\n)*", text).group(0)
    if "\n#pragma once\n" not in text and not is_list(text):
        return f"{name}: no #pragma once"
    if len(STABILITY.findall(head)) != 1:
        return f"{name}: its head comment needs one line '// Stability: stable since …' or '// Stability: may change'"
    return None


def compile_problem(compiler, flags, name):
    source = f'#include "{name}"\n'
    done = subprocess.run([compiler, *flags, "-fsyntax-only", "-x", "c++", "-"], input=source,
                          capture_output=True, text=True)
    return None if done.returncode == 0 else f"{name} does not compile alone:\n{done.stderr}"


def check(listed):
    prefix = pathlib.Path(os.environ["PREFIX"])
    folder = prefix / "include" / "fyd"
    installed = sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*.h"))
    wanted = sorted(pathlib.Path(listed).read_text().split())
    found = []
    if installed != wanted or len(wanted) < 50:
        found.append(f"{len(installed)} headers are installed, {len(wanted)} are listed: {set(installed) ^ set(wanted)}")
    found += [why for name in installed if (why := stability_problem(name, (folder / name).read_text(encoding="utf-8")))]
    environment = os.environ | {"PKG_CONFIG_PATH": str(prefix / os.environ["LIBDIR"] / "pkgconfig")}
    flags = subprocess.run(["pkg-config", "--cflags", "fyd"], env=environment, check=True, capture_output=True,
                           text=True).stdout.split()
    alone = [name for name in installed if not is_list((folder / name).read_text(encoding="utf-8"))]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        found += filter(None, pool.map(lambda name: compile_problem(os.environ["CXX"], flags, name), alone))
    return found


def self_test():
    assert stability_problem("a.h", "// A.\n// Stability: stable since 0.1\n#pragma once\n") is None
    assert stability_problem("a.h", "// A.\n#pragma once\n// Stability: may change\n")
    assert stability_problem("a.h", "// A.\n// Stability: perhaps\n#pragma once\n")
    assert is_list("// Several times: no\n// #pragma once.\nFAULT(a)\n") and not is_list("// A.\n#pragma once\n")
    assert stability_problem("a.h", "// A.\n// Stability: may change\nint a;\n")
    assert compile_problem("c++", [], "no_such_header.h")


if __name__ == "__main__":
    self_test()
    problems = check(sys.argv[1])
    print("\n".join(problems) or "every installed header says how stable it is and compiles alone")
    sys.exit(1 if problems else 0)
