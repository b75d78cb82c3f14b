#!/usr/bin/env python3
"""Fails on an installed header without its line on stability, on one whose comments point at a file that is not
installed, and on one that does not compile alone against the installed tree:
PREFIX=… LIBDIR=… CXX=… check_headers.py LIST | check_headers.py --self-test.
"""
import concurrent.futures
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

FILE = re.compile(r"[\w./-]*\w\.(?:h|cpp)\b")
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


def absent_files(name, text, installed):
    """Files of which a comment speaks to a reader who does not have them."""
    named = {file for comment in re.findall(r"//(.*)", text) for file in FILE.findall(comment)}
    return [f"{name}: a comment points at {file}, which is not installed: name what is meant"
            for file in sorted(named) if not any(f"/{each}".endswith(f"/{file}") for each in installed)]


def others(folder, name, found=None):
    """What a header includes of other libraries, itself or through ours."""
    found = {} if found is None else found
    if name not in found:
        found[name] = None
        for line in re.findall(r'^#include ["<]([^">]+)[">]', (folder / name).read_text(encoding="utf-8"), re.M):
            if (folder / line).exists():
                others(folder, line, found)
            elif "/" in line:  # of the standard library none stands in a folder
                found[line] = None
    return tuple(each for each in found if not (folder / each).exists())


def compile_problem(compiler, flags, name):
    source = f'#include "{name}"\n'
    done = subprocess.run([compiler, *flags, "-fsyntax-only", "-x", "c++", "-"], input=source,
                          capture_output=True, text=True)
    return None if done.returncode == 0 else f"{name} does not compile alone:\n{done.stderr}"


def precompiled(compiler, flags, libraries, place):
    """The flags by which what a header includes of other libraries is read but once for all that include the same."""
    head = place / "head.h"
    place.mkdir()
    head.write_text("".join(f"#include <{each}>\n" for each in libraries))
    subprocess.run([compiler, *flags, "-w", "-x", "c++-header", head, "-o", f"{head}.gch"], check=True)
    return [*flags, "-Winvalid-pch", "-Werror=invalid-pch", "-include", str(head)]


def check(listed):
    prefix = pathlib.Path(os.environ["PREFIX"])
    folder = prefix / "include" / "fyd"
    installed = sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*.h"))
    wanted = sorted(pathlib.Path(listed).read_text().split())
    found = []
    if installed != wanted or len(wanted) < 50:
        found.append(f"{len(installed)} headers are installed, {len(wanted)} are listed: {set(installed) ^ set(wanted)}")
    found += [why for name in installed if (why := stability_problem(name, (folder / name).read_text(encoding="utf-8")))]
    found += [why for name in installed
              for why in absent_files(name, (folder / name).read_text(encoding="utf-8"), installed)]
    environment = os.environ | {"PKG_CONFIG_PATH": str(prefix / os.environ["LIBDIR"] / "pkgconfig")}
    flags = shlex.split(subprocess.run(["pkg-config", "--cflags", "fyd"], env=environment, check=True, capture_output=True,
                                       text=True).stdout)
    alone = [name for name in installed if not is_list((folder / name).read_text(encoding="utf-8"))]
    compiler = os.environ["CXX"]
    sets = {}
    for name in alone:
        sets.setdefault(tuple(sorted(others(folder, name))), []).append(name)
    with tempfile.TemporaryDirectory() as scratch, concurrent.futures.ThreadPoolExecutor(2) as pool:
        places = {libraries: pathlib.Path(scratch) / str(i) for i, libraries in enumerate(sets)}
        ready = dict(zip(sets, pool.map(lambda each: precompiled(compiler, flags, each, places[each]), sets)))
        tasks = [(name, ready[libraries]) for libraries, names in sets.items() for name in names]
        found += filter(None, pool.map(lambda task: compile_problem(compiler, task[1], task[0]), tasks))
    return found


def self_test():
    assert stability_problem("a.h", "// A.\n// Stability: stable since 0.1\n#pragma once\n") is None
    assert stability_problem("a.h", "// A.\n#pragma once\n// Stability: may change\n")
    assert stability_problem("a.h", "// A.\n// Stability: perhaps\n#pragma once\n")
    assert is_list("// Several times: no\n// #pragma once.\nFAULT(a)\n") and not is_list("// A.\n#pragma once\n")
    assert stability_problem("a.h", "// A.\n// Stability: may change\nint a;\n")
    installed = ["core/a.h", "core/b/c_list.h"]
    assert absent_files("core/a.h", '// As in c_list.h (core/a.h), "b/c_list.h".\n#include "d.h"\n', installed) == []
    for text in ("int a;  ///< see a.cpp\n", "// b/a.h\n", "// list.h\n", "/// core/d.h,\n"):
        assert len(absent_files("core/a.h", text, installed)) == 1, text
    assert compile_problem("c++", [], "no_such_header.h")


if __name__ == "__main__":
    self_test()
    problems = check(sys.argv[1])
    print("\n".join(problems) or "every installed header says how stable it is, points at no absent file, and compiles alone")
    sys.exit(1 if problems else 0)
