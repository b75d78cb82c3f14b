#!/usr/bin/python3
"""Draws architecture.svg from the includes of the sources: python3 architecture.py OUT.svg

A box is a folder, a row a rank of tests/architecture/check_includes.py. An arrow goes from a folder to one that it includes;
one that follows from others (a uses b, b uses c) is left out, so that the picture can be read.
"""
import functools
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tests/architecture"))
import check_includes as RULES  # noqa: E402 - its folder is known only now

WIDTH, ROW, BOX, HIGH, LEFT = 980, 62, 112, 30, 96
FLOORS = [("app", "#dfe7f5", "programs"), ("widgets", "#dfe7f5", "Qt widgets"), ("core/station", "#f6e3cf", "decides when"),
          ("core/report", "#e4efdc", "talks to the world"), ("core/pipeline", "#f3f0d8", "computes"), ("core/signal", "#ececec", "")]


@functools.cache
def included():
    """Folder -> the folders that its files include."""
    out = {module: set() for row in RULES.RANKS for module in row}
    for module, uses in out.items():
        for path in sorted((ROOT / module).rglob("*")):
            if path.suffix not in (".h", ".cpp"):
                continue
            for line in path.read_text(encoding="utf-8").split("\n"):
                match = RULES.INCLUDE.match(line)
                to = match and RULES.module_of(match[1])
                if to and to != module:
                    uses.add(to)
    return out


def reaches(start, goal, without):
    """Whether there is a way that does not begin with the direct one."""
    open_, seen = [each for each in included()[start] if each != without], set()
    while open_:
        at = open_.pop()
        if at == goal:
            return True
        if at not in seen:
            seen.add(at)
            open_ += included()[at]
    return False


def arrows():
    return [(start, goal) for start, goals in included().items() for goal in sorted(goals) if not reaches(start, goal, goal)]


def floor_of(module):
    rank = RULES.RANK[module]
    if module.startswith("app"):
        return 0
    if module == "widgets":
        return 1
    if module == "core/station":
        return 2
    return 3 if rank >= RULES.RANK["core/protocol"] else 4 if rank >= RULES.RANK["core/sensing"] else 5


def main():
    rows = list(reversed(RULES.RANKS))
    place = {}
    for i, row in enumerate(rows):
        step = (WIDTH - LEFT - 20) / len(row)
        for j, module in enumerate(row):
            place[module] = (LEFT + step * (j + 0.5), 40 + ROW * i)
    height = 20 + ROW * len(rows)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" font-family="sans-serif" font-size="13">',
           f'<rect width="{WIDTH}" height="{height}" fill="#ffffff"/>']
    for number, (_, colour, words) in enumerate(FLOORS):
        ys = [place[module][1] for module in place if floor_of(module) == number]
        top, bottom = min(ys) - 27, max(ys) + 29
        out.append(f'<rect x="6" y="{top}" width="{WIDTH - 12}" height="{bottom - top}" rx="6" fill="{colour}"/>')
        if words:
            out.append(f'<text x="14" y="{(top + bottom) / 2 + 4:.0f}" fill="#333" font-size="11">{words}</text>')
    for start, goal in arrows():
        (x1, y1), (x2, y2) = place[start], place[goal]
        y1, y2 = y1 + HIGH / 2, y2 - HIGH / 2
        if y2 < y1:  # beside each other: a bow below both
            y = y1 + 5
            out.append(f'<path d="M{x1 + 12:.0f} {y1:.0f}C{x1 + 12:.0f} {y + 20:.0f} {x2 + 12:.0f} {y + 20:.0f} {x2 + 12:.0f} {y:.0f}"'
                       f' stroke="#666" fill="none"/><path d="M{x2 + 12:.0f} {y1:.0f}l-4 8h8z" fill="#666"/>')
            continue
        out.append(f'<path d="M{x1:.0f} {y1:.0f}C{x1:.0f} {y1 + 24:.0f} {x2:.0f} {y2 - 24:.0f} {x2:.0f} {y2 - 5:.0f}" stroke="#666"'
                   f' fill="none"/><path d="M{x2:.0f} {y2:.0f}l-4 -8h8z" fill="#666"/>')
    for module, (x, y) in place.items():
        name = module.removeprefix("core/")
        out.append(f'<rect x="{x - BOX / 2:.0f}" y="{y - HIGH / 2:.0f}" width="{BOX}" height="{HIGH}" rx="4" fill="#ffffff" stroke="#444"/>'
                   f'<text x="{x:.0f}" y="{y + 4:.0f}" text-anchor="middle" fill="#111">{name}</text>')
    out.append("</svg>\n")
    Path(sys.argv[1]).write_text("\n".join(out), encoding="utf-8")


if __name__ == "__main__":
    main()
