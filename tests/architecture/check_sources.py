#!/usr/bin/env python3
"""Checks that comments cite sources by the keys of resources/manual/sources.md: check_sources.py ROOT | --self-test.

A citation is "[key]" or "[key place]" in a comment, such as [thesis §4.1.4] or [RFC 8949]. Each needs a row of the page,
and each row a citation. Citations in another form, and pages outside the repository, are errors.
"""

import pathlib
import re
import sys

PAGE = "resources/manual/sources.md"
FOLDERS = ["core", "app", "widgets", "tests"]
PLACE = r"(?: (?:§|Eq\. |Table )[^\]]*)?"
OTHER_FORMS = [
    (re.compile(r"(?<!\[)\bthesis,? \(?§"), "[thesis §…]"),
    (re.compile(r"(?<!\[)\bRFC \d+"), "[RFC …]"),
    (re.compile(r"\b[A-Z][a-z]+(?: and [A-Z][a-z]+| et al\.?)?,? \((?:19|20)\d\d\)"), "[Author year]"),
    (re.compile(r"\b[A-Z][a-z]+ and [A-Z][a-z]+ (?:19|20)\d\d\b"), "[Author year]"),
    (re.compile(r"[Ff]act sheet|FACTS\.md"), "a key of " + PAGE),
]


def keys_of(page):
    """The first column of every table, without heads and rules."""
    rows = [line.split("|")[1].strip() for line in page.splitlines() if line.startswith("| ")]
    return [row for row in rows if row != "key"]


def comments_of(path, text):
    """(line number, comment) of a source file; enough for citations, which no string literal holds."""
    mark = "#" if path.suffix == ".py" else "//"
    for number, line in enumerate(text.splitlines(), 1):
        start = line.find(mark)
        if start >= 0:
            yield number, line[start:]


def check(keys, files):
    """files: (path, text). Returns the errors."""
    errors = [f"{PAGE}: the key '{key}' stands twice" for key in set(keys) if keys.count(key) > 1]
    cited = set()
    known = re.compile(r"\[(" + "|".join(re.escape(key) for key in keys) + r")" + PLACE + r"\]")
    looks_like = re.compile(r"\[((?:[A-Z][a-z]+ (?:19|20)\d\d|RFC \d+|thesis|tele-gesture|authors' program))" + PLACE + r"\]")
    for path, text in files:
        for number, comment in comments_of(path, text):
            cited.update(known.findall(comment))
            for key in looks_like.findall(comment):
                if key not in keys:
                    errors.append(f"{path}:{number}: '{key}' has no row in {PAGE}")
            for form, wanted in OTHER_FORMS:
                if found := form.search(comment):
                    errors.append(f"{path}:{number}: '{found.group()}' is cited in another form; expected {wanted}")
    errors += [f"{PAGE}: nothing cites '{key}'" for key in keys if key not in cited]
    return errors


def self_test():
    keys = keys_of("| key | source |\n|---|---|\n| thesis | a |\n| Lee 2001 | b |\n")
    assert keys == ["thesis", "Lee 2001"], keys
    file = pathlib.Path("a.h")
    good = "// by [thesis §4.1.4] and [Lee 2001], a[2001] is code"
    assert check(keys, [(file, good)]) == []
    for bad in ["// (thesis §4.1)", "// Lee (2001)", "// [Kim 2002]", "// RFC 1950", "// fact sheet §2"]:
        assert len(check(keys, [(file, good + "\n" + bad)])) == 1, bad
    assert len(check(keys, [(file, "// [Lee 2001]")])) == 1  # nothing cites the thesis
    assert len(check(keys + ["thesis"], [(file, good)])) == 1


def main():
    if sys.argv[1] == "--self-test":
        return self_test()
    root = pathlib.Path(sys.argv[1])
    paths = [path for folder in FOLDERS for path in sorted((root / folder).rglob("*"))
             if path.suffix in (".h", ".cpp", ".in", ".py") and path.name != "check_sources.py"]
    files = [(path.relative_to(root), path.read_text()) for path in paths]
    errors = check(keys_of((root / PAGE).read_text()), files)
    print("\n".join(errors) or f"{len(files)} files cite sources by their keys")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
