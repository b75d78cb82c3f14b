#!/usr/bin/env python3
"""Checks that numbers with decimals reach the window by widgets/basics/number_text.h, which writes the decimal sign of
the language: check_numbers.py ROOT | --self-test.

QString::number and QString::arg write a point in every language. Files are written with a point, and not by Qt here.
"""

import pathlib
import re
import sys

FOLDERS = ["app/console", "widgets"]
ALLOWED = {
    "widgets/basics/number_text.cpp": "puts the sign of the language in place of the point",
    "app/console/review/review_exports.cpp": "names of files",
    "app/console/calibrate/calibrate_fit_panel.cpp": "rounds the numbers of a text, and puts the sign in",
}
DIGITS = r"'[efg]'(?!, 0\))"  # without decimals there is no sign
FORMS = [re.compile(r"QString::number\([^;]*?,\s*" + DIGITS), re.compile(r"\.arg\([^;]*?,\s*\d+,\s*" + DIGITS),
         re.compile(r"\.setNum\([^;]*?,\s*" + DIGITS)]


def problems(path, text):
    if path in ALLOWED:
        return []
    found = sorted({match.start() for form in FORMS for match in form.finditer(text)})
    return [f"{path}:{text.count(chr(10), 0, at) + 1}: a decimal sign that is always a point; use numberText" for at in found]


def check(root):
    out = []
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*.cpp")):
            out += problems(str(path.relative_to(root)), path.read_text(encoding="utf-8"))
    return out


def self_test():
    assert problems("widgets/a.cpp", "x\nQString::number(rate, 'f', 1)") == ["widgets/a.cpp:2: a decimal sign that is always a point; use numberText"]
    assert problems("widgets/a.cpp", "tr(\"%1 N\").arg(force, 0, 'f', 2)")
    assert not problems("widgets/a.cpp", "QString::number(count) + tr(\"%1\").arg(count)")
    assert not problems("widgets/a.cpp", "tr(\"%1 %\").arg(share, 0, 'f', 0)")
    assert not problems("widgets/basics/number_text.cpp", "QString::number(value, 'f', 1)")
    return []


if __name__ == "__main__":
    failures = self_test() if sys.argv[1] == "--self-test" else check(pathlib.Path(sys.argv[1]))
    print("\n".join(failures) or "all numbers have the decimal sign of the language")
    sys.exit(1 if failures else 0)
