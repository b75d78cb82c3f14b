#!/usr/bin/env python3
"""Fails on an include that points upward or in a circle, on Qt in the core, and where the simulated cloth and its
estimator meet.

Modules stand on ranks; a file may include its own module and modules of a lower rank. The folders inside a module have an order
of their own (FOLDERS), and no two files of the project (a header counts as one with its source) include each other in a
circle.
"""
import collections
import pathlib
import re
import sys
import tempfile

import check_main

RANKS = [
    ["core/base"],
    ["core/signal"],
    ["core/sensing", "core/control", "core/texture", "core/scene", "core/teleop", "core/calibration", "core/experiment"],
    ["core/pipeline"],
    ["core/protocol"],
    ["core/device"],
    ["core/sim"],
    ["core/recording"],
    ["core/replay", "core/catalogue", "core/export"],
    ["core/report"],
    ["core/station"],
    ["widgets"],
    ["app/cli", "app/console", "app/python"],
    ["app/bench"],
]
# Modules of the same rank that may look at a neighbour, one way.
NEIGHBOURS = {("core/calibration", "core/sensing"), ("core/calibration", "core/control"), ("core/calibration", "core/texture"),
              ("core/scene", "core/texture")}
# The folders inside a module, lowest first; "" is the module's own folder. Folders of one line stand beside each other.
FOLDERS = {
    "core/base": [[""], ["codecs"]],
    "core/texture": [["felt"], [""]],
    "core/scene": [["mesh"], ["contact", "soft", "gesture"], [""]],
    "core/teleop": [["prediction", "coupling"], [""]],
    "core/calibration": [["fit"], [""]],
    "core/protocol": [[""], ["classic", "link", "registers"]],
    "core/device": [[""], ["touchpad", "camera", "robot"]],
    "core/sim": [[""], ["cloth", "network"], ["touchpad", "robot"], ["server", "teleop", "trial"]],
    "core/recording": [[""], ["format"], ["file"], ["writer", "reader"], ["recovery"]],
    "core/station": [["profile"], [""]],
    "widgets": [["basics"], ["curves"], ["tuning", "scene", "status"], ["devices"], [""]],
    "app/console": [["shell"], ["operate", "calibrate", "review", "tune", "devices"], ["window"], [""]],
    "app/cli": [["parts"], ["session", "texture", "scene", "teleop", "sim"], [""]],
    "app/bench": [["parts"], ["", "window"]],
}
LARGEST_FOLDER = 40  # files
RANK = {module: rank for rank, modules in enumerate(RANKS) for module in modules}
INCLUDE = re.compile(r'^\s*#\s*include\s*["<]([^">]+)[">]')
# The estimator is tested against the simulated cloth, so the two share no formula and no table: the simulation looks at
# the estimator's membrane in one file, for sim.cloth = ideal alone, and what estimates, calibrates or controls does not
# know the tables.
MEMBRANE = "core/sensing/membrane.h"
MEMBRANE_USER = "core/sim/cloth/ideal_shape.h"
ESTIMATORS = ("core/sensing", "core/calibration", "core/control", "core/pipeline")
TABLES = re.compile(r"cloth_table|clothTable|resources/cloths|\.cloth\b(?=[\"'])")
QT = re.compile(r'^\s*#\s*include\s*[<"](Q[A-Z]\w*|Qt\w*/.*|qcustomplot\.h)[>"]')


def module_of(path):
    for module in RANK:
        if path.startswith(module + "/"):
            return module
    return None


def folder_of(path, module):
    inside = path[len(module) + 1:]
    return inside.split("/")[0] if "/" in inside else ""


def rank_inside(module, folder):
    """None: the folder is not in the module's order."""
    for rank, folders in enumerate(FOLDERS.get(module, [[""]])):
        if folder in folders:
            return rank
    return None


def upward(name, included):
    """Why `name` may not include that file; None: it may."""
    module, other = module_of(name), module_of(included)
    if other is None or (module, other) in NEIGHBOURS:
        return None
    if other != module:
        return f"{module} may not include {other}" if RANK[other] >= RANK[module] else None
    mine, theirs = folder_of(name, module), folder_of(included, module)
    if mine == theirs:
        return None
    ranks = rank_inside(module, mine), rank_inside(module, theirs)
    if None in ranks or ranks[1] >= ranks[0]:
        return f"{module}: folder '{mine}' may not include folder '{theirs}'"
    return None


def circles(includes):
    """Groups of files that include each other in a circle. @param includes file without ending -> files without ending"""
    index, low, stack, found = {}, {}, [], []

    def visit(node):
        index[node] = low[node] = len(index)
        stack.append(node)
        for other in sorted(includes.get(node, ())):
            if other not in index:
                visit(other)
                low[node] = min(low[node], low[other])
            elif other in stack:
                low[node] = min(low[node], index[other])
        if low[node] == index[node]:
            group = stack[stack.index(node):]
            del stack[stack.index(node):]
            if len(group) > 1:
                found.append(sorted(group))

    for node in sorted(includes):
        if node not in index:
            visit(node)
    return found


def problems(root):
    found = []
    includes = collections.defaultdict(set)
    folders = collections.Counter()
    for file in sorted(p for top in ("core", "widgets", "app") for p in (root / top).rglob("*") if p.suffix in (".h", ".cpp")):
        name = file.relative_to(root).as_posix()
        module = module_of(name)
        folders[name.rpartition("/")[0]] += 1
        if module is None:
            if name.count("/") > 1:
                found.append(f"{name}: stands in no known module")
            continue
        if rank_inside(module, folder_of(name, module)) is None:
            found.append(f"{name}: stands in no known folder of {module}")
        for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
            if module.startswith("core/") and QT.match(line):
                found.append(f"{name}:{number}: Qt in the core: {line.strip()}")
            if module in ESTIMATORS and TABLES.search(line):
                found.append(f"{name}:{number}: the tables of the simulated cloth are not for {module}: {line.strip()}")
            match = INCLUDE.match(line)
            if not match:
                continue
            included = match.group(1)
            if included == MEMBRANE and module == "core/sim" and name != MEMBRANE_USER:
                found.append(f"{name}:{number}: only {MEMBRANE_USER} may look at the estimator's membrane")
            if why := upward(name, included):
                found.append(f"{name}:{number}: {why}: {line.strip()}")
            if (stem := name.rpartition(".")[0]) != (other := included.rpartition(".")[0]) and module_of(included):
                includes[stem].add(other)
    found += [f"circle of includes: {' '.join(group)}" for group in circles(includes)]
    found += [f"{folder}: {count} files; a folder holds at most {LARGEST_FOLDER}"
              for folder, count in sorted(folders.items()) if count > LARGEST_FOLDER]
    return found


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        cases = {
            "core/base/a.h": '#include "core/pipeline/x.h"\n',
            "core/pipeline/b.h": "#include <QString>\n",
            "core/sensing/c.h": '#include "core/control/x.h"\n',
            "core/attic/d.h": "\n",
            "core/sim/e.h": '#include "core/sensing/membrane.h"\n',
            "core/sensing/f.cpp": 'const auto text = clothTableText("frame_sphere8");\n',
            "core/recording/file/g.h": '#include "core/recording/writer/x.h"\n',
            "core/recording/shed/h.h": "\n",
            "core/sim/cloth/ideal_shape.h": '#include "core/sensing/membrane.h"\n',
            "core/station/good.h": '#include "core/base/a.h"\n#include "core/station/profile/x.h"\n#include <vector>\n',
            "core/signal/one.cpp": '#include "core/signal/one.h"\n#include "core/signal/two.h"\n',
            "core/signal/two.h": '#include "core/signal/one.h"\n',
        }
        good = {"core/station/good.h", "core/sim/cloth/ideal_shape.h", "core/signal/one.cpp", "core/signal/two.h"}
        cases |= {f"core/control/many_{i}.h": "\n" for i in range(LARGEST_FOLDER + 1)}
        good |= {f"core/control/many_{i}.h" for i in range(LARGEST_FOLDER + 1)}
        for name, text in cases.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text)
        for top in ("widgets", "app"):
            (root / top).mkdir()
        found = problems(root)
        flagged = {line.split(":")[0] for line in found}
        assert flagged == set(cases) - good | {"circle of includes", "core/control"}, found
        assert "circle of includes: core/signal/one core/signal/two" in found, found
    return []


if __name__ == "__main__":
    check_main.end(self_test() if sys.argv[1] == "--self-test" else problems(pathlib.Path(sys.argv[1])))
