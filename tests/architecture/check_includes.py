#!/usr/bin/env python3
"""Fails on an include that points upward, on Qt in the core, and where the simulated cloth and its estimator meet.

Rooms stand on ranks; a file may include its own room and rooms of a lower rank.
"""
import pathlib
import re
import sys
import tempfile

RANKS = [
    ["core/base"],
    ["core/signal"],
    ["core/sensing", "core/control", "core/texture", "core/scene", "core/teleop", "core/calibration"],
    ["core/pipeline"],
    ["core/protocol"],
    ["core/device"],
    ["core/sim"],
    ["core/session"],
    ["core/station"],
    ["widgets"],
    ["app/cli", "app/console"],
]
# Rooms of the same rank that may look at a neighbour, one way.
NEIGHBOURS = {("core/calibration", "core/sensing"), ("core/calibration", "core/control"), ("core/calibration", "core/texture"),
              ("core/scene", "core/texture")}
RANK = {room: rank for rank, rooms in enumerate(RANKS) for room in rooms}
INCLUDE = re.compile(r'^\s*#\s*include\s*["<]([^">]+)[">]')
# The estimator is tested against the simulated cloth, so the two share no formula and no table: the simulation looks at
# the estimator's membrane in one file, for sim.cloth = ideal alone, and what estimates, calibrates or controls does not
# know the tables.
MEMBRANE = "core/sensing/membrane.h"
MEMBRANE_USER = "core/sim/ideal_shape.h"
ESTIMATORS = ("core/sensing", "core/calibration", "core/control", "core/pipeline")
TABLES = re.compile(r"cloth_table|clothTable|resources/cloths|\.cloth\b(?=[\"'])")
QT = re.compile(r'^\s*#\s*include\s*[<"](Q[A-Z]\w*|Qt\w*/.*|qcustomplot\.h)[>"]')


def room_of(path):
    for room in RANK:
        if path.startswith(room + "/"):
            return room
    return None


def problems(root):
    found = []
    for file in sorted(p for top in ("core", "widgets", "app") for p in (root / top).rglob("*") if p.suffix in (".h", ".cpp")):
        name = file.relative_to(root).as_posix()
        room = room_of(name)
        if room is None:
            if name.count("/") > 1:
                found.append(f"{name}: stands in no known room")
            continue
        for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
            if room.startswith("core/") and QT.match(line):
                found.append(f"{name}:{number}: Qt in the core: {line.strip()}")
            if room in ESTIMATORS and TABLES.search(line):
                found.append(f"{name}:{number}: the tables of the simulated cloth are not for {room}: {line.strip()}")
            match = INCLUDE.match(line)
            if match and match.group(1) == MEMBRANE and room == "core/sim" and name != MEMBRANE_USER:
                found.append(f"{name}:{number}: only {MEMBRANE_USER} may look at the estimator's membrane")
            other = room_of(match.group(1)) if match else None
            if other is None or other == room or (room, other) in NEIGHBOURS:
                continue
            if RANK[other] >= RANK[room]:
                found.append(f"{name}:{number}: {room} may not include {other}: {line.strip()}")
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
            "core/sim/ideal_shape.h": '#include "core/sensing/membrane.h"\n',
            "core/station/good.h": '#include "core/base/a.h"\n#include <vector>\n',
        }
        for name, text in cases.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text)
        for top in ("widgets", "app"):
            (root / top).mkdir()
        found = problems(root)
        flagged = {line.split(":")[0] for line in found}
        assert flagged == set(cases) - {"core/station/good.h", "core/sim/ideal_shape.h"}, found
    return []


if __name__ == "__main__":
    failures = self_test() if sys.argv[1] == "--self-test" else problems(pathlib.Path(sys.argv[1]))
    for failure in failures:
        print(failure)
    print(f"0 passed, {len(failures)} failed" if failures else "1 passed, 0 failed")
    sys.exit(1 if failures else 0)
