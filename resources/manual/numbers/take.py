#!/usr/bin/python3
"""Puts what `fyd bench --all --out DIR` measured into the manual and the README: resources/manual/numbers/take.py DIR

numbers.md and its picture, those of scene_contact and texture, numbers.csv and stability.csv beside this file, the table of
stability.md, and the figures that the README quotes. A run in which something was not measured is refused. installer/numbers.sh
measures and runs this. tests/manual/numbers_test.py reads the pages with the functions below.
"""
import csv
import math
import re
import shutil
import subprocess
import sys
from pathlib import Path

NUMBERS = Path(__file__).resolve().parent
MANUAL = NUMBERS.parent
README = MANUAL.parents[1] / "README.md"
STABILITY = MANUAL / "stability.md"

# What the README quotes: words, and the row of numbers.md.
QUOTED = [
    ("most steps of 1 kHz: an acceleration, no new picture or distances", "step", "default"),
    ("the finger in a picture", "detector", "adaptive (default)"),
    ("indentation and stiffness of new distances, cloth calibrated", "indentation", "contact and force, cloth calibrated"),
    ("stiffness loop, until it has settled, cloth calibrated", "controller", "cloth calibrated"),
    ("nearest point of a mesh", "scene", "walk with certificate"),
    ("where the hand is now, over a late network; its constants were chosen on these recordings", "predict", "default"),
    ("three axes of vibration to one, 31 ms late", "texture", "dft321, frame 32, hop 16"),
]


def rows_of(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def number(cell):
    """NaN for a cell that holds none."""
    try:
        return math.inf if cell == "∞" else float(cell)
    except ValueError:
        return math.nan


def not_measured(rows):
    """Rows of numbers.csv that say that they failed, or have neither a cost nor an error."""
    return [f"{row['subject']}: {row['what']}" for row in rows
            if "FAILED" in row["what"] or math.isnan(number(row["cost"])) and math.isnan(number(row["error"]))]


def cells(line):
    return [each.replace("\\|", "|").strip() for each in re.split(r"(?<!\\)\|", line.strip())[1:-1]]


def tables_of(text):
    """Heading -> (columns, rows as lists) of the first table below it."""
    out, heading, table = {}, "", []
    for line in [*text.split("\n"), "# "]:
        if line.startswith("|"):
            table.append(cells(line))
            continue
        if table and heading not in out:
            out[heading] = (table[0], table[2:])
        table = []
        if line.startswith("#"):
            heading = line.lstrip("# ")
    return out


def markdown(columns, rows):
    lines = [columns, ["---"] * len(columns), *rows]
    return "".join("| " + " | ".join(cell.replace("|", "\\|") for cell in line) + " |\n" for line in lines)


def readme_table(page):
    """Of the words and the figures that numbers.md has for them."""
    tables, rows = tables_of(page), []
    for words, subject, what in QUOTED:
        columns, all_rows = tables[subject]
        row = next((row for row in all_rows if row[0].split(" (the")[0] == what), None)
        if row is None:
            raise SystemExit(f"numbers.md: {subject} has no row {what!r}; it has {', '.join(r[0] for r in all_rows)}")

        def with_unit(at):
            unit = re.search(r"\(([^)]*)\)$", columns[at])
            return f"{row[at]} {unit[1]}" if unit else row[at]

        cost, error = columns.index("× baseline") - 1, columns.index("error × baseline") - 1
        rows.append([words, with_unit(cost), row[cost + 1], with_unit(error), row[error + 1]])
    return ["what", "cost", "× baseline", "error", "× baseline"], rows


def stability_table(rows):
    """One line for each case, of stability.csv's two."""
    out = []
    for naive, ours in zip(rows[::2], rows[1::2]):
        assert naive["hard case"] == ours["hard case"], naive["hard case"]

        def figure(row):
            return f"{row['error']} {row['unit']}".strip()

        out.append([naive["hard case"], naive["truth"], naive["how"], figure(naive), ours["how"], figure(ours),
                    f"{ours['ours at most']} {ours['unit']}".strip()])
    return ["hard case", "truth", "a naive implementation", "its error", "ours", "its error", "at most"], out


def with_table(text, heading, table):
    """The text with the first table below this heading replaced."""
    pattern = re.compile(rf"(^#+ {re.escape(heading)}\n(?:(?!\|).*\n)*)(?:\|.*\n)+", re.MULTILINE)
    new, count = pattern.subn(lambda match: match[1] + markdown(*table), text, count=1)
    if count != 1:
        raise SystemExit(f"there is no table below {heading!r}")
    return new


def main():
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    folder = Path(sys.argv[1])
    if missing := not_measured(rows_of(folder / "numbers.csv")):
        raise SystemExit(f"{folder}/numbers.csv: expected figures in every row, not measured: {'; '.join(missing)}")
    shutil.copy(folder / "numbers.md", MANUAL / "numbers.md")
    for name in ("numbers.svg", "scene_contact.svg"):
        shutil.copy(folder / name, MANUAL / "images" / name)
    subprocess.run([sys.executable, MANUAL / "images/texture_curve.py", folder / "texture.csv",
                    MANUAL / "images/texture_curve.svg"], check=True)
    for name in ("numbers.csv", "stability.csv"):
        shutil.copy(folder / name, NUMBERS / name)
    README.write_text(with_table(README.read_text(encoding="utf-8"), "Measured", readme_table(
        (MANUAL / "numbers.md").read_text(encoding="utf-8"))), encoding="utf-8")
    STABILITY.write_text(with_table(STABILITY.read_text(encoding="utf-8"), "The cases", stability_table(
        rows_of(NUMBERS / "stability.csv"))), encoding="utf-8")


if __name__ == "__main__":
    main()
