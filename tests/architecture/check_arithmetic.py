#!/usr/bin/env python3
"""Fails on a function whose bits depend on the processor in what a replay computes again.

The C library chooses exp, log, sin, … by the processor; the modules of the step use core/base/portable_math.h in their
place. Looked for in the compiled objects, so that nothing inlined from a header is missed.

  check_arithmetic.py NM COMPILER OBJECT…
"""
import pathlib
import re
import subprocess
import sys
import tempfile

import check_main

MODULES = ("base", "signal", "sensing", "control", "texture", "teleop", "scene", "pipeline")
# What a replay does not compute again: the finger's detection and a file's mesh are inputs; test signals are for benches.
OUTSIDE = {"finger_adaptive.cpp.o", "finger_detector.cpp.o", "finger_thesis.cpp.o", "blob_measure.cpp.o",
           "test_signals.cpp.o", "mesh_text.cpp.o"}
BY_PROCESSOR = {"exp", "exp2", "exp10", "expm1", "log", "log2", "log10", "log1p", "pow", "sin", "cos", "tan", "sincos",
                "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh", "hypot", "cbrt",
                "erf", "erfc", "tgamma", "lgamma", "fma", "cabs", "carg", "cexp", "clog", "cpow", "csqrt", "csin",
                "ccos"}
FORBIDDEN = BY_PROCESSOR | {name + "f" for name in BY_PROCESSOR}


def undefined(nm, file):
    done = subprocess.run([nm, "--undefined-only", "--format=just-symbols", file], capture_output=True, text=True, check=True)
    return set(done.stdout.split())


def module_of(file):
    """…/fyd_core.dir/MODULE/… or, of files that are compiled together, …/fyd_core.dir/together/fyd_core/MODULE/…."""
    return re.sub(r".*/fyd_core\.dir/(together/fyd_core/)?", "", file.as_posix()).split("/")[0]


def problems(nm, objects):
    found, seen = [], set()
    for file in map(pathlib.Path, objects):
        if (module := module_of(file)) not in MODULES or file.name in OUTSIDE:
            continue
        seen.add(module)
        found += [f"{module}/{file.name}: calls {name}; expected that of core/base/portable_math.h"
                  for name in sorted(undefined(nm, file) & FORBIDDEN)]
    if missing := sorted(set(MODULES) - seen):
        found.append(f"no object of {', '.join(missing)} was given")
    return found


def self_test(nm, compiler):
    with tempfile.TemporaryDirectory() as folder:
        source, out = pathlib.Path(folder) / "a.cpp", pathlib.Path(folder) / "a.o"
        source.write_text("#include <cmath>\ndouble f(double x) { return std::exp(x); }\n")
        subprocess.run([compiler, "-O2", "-c", source, "-o", out], check=True)
        assert "exp" in undefined(nm, out) & FORBIDDEN
    for path in ("/b/core/CMakeFiles/fyd_core.dir/teleop/prediction/a.cpp.o",
                 "/b/core/CMakeFiles/fyd_core.dir/together/fyd_core/teleop/unit_0.cpp.o"):
        assert module_of(pathlib.Path(path)) == "teleop", path


if __name__ == "__main__":
    self_test(sys.argv[1], sys.argv[2])
    check_main.end(problems(sys.argv[1], sys.argv[3:]))
