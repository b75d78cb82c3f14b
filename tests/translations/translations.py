#!/usr/bin/env python3
"""The window's translations: resources/translations/fyd_<language>.ts against what the sources say.

check   fails when a text of the window or anything that the core says is missing, unfinished or no longer said in a
        language, when a translation loses a value (%1, {:.2f}) or a key (Ctrl+R), when a message of the core is places
        only or has an English value, or when a parameter that the window shows has a help that is not marked
update  enters new texts as unfinished and takes away those that are no longer said
"""
import argparse
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from xml.sax.saxutils import escape

PLURALS = {"en": 2, "it": 2, "fr": 2}  # as Qt 6.4 counts them
SOURCES = ["widgets", "app/console"]
# What the core says stands in these calls (core/base/message.h), and where it may be said.
CALLS = ["sentence", "say", "fail", "failHard"]
SPEAKERS = ["core", *SOURCES]


def found(root, lupdate, sources, options):
    with tempfile.TemporaryDirectory() as folder:
        ts = Path(folder) / "all_it.ts"
        # A list that is read several times stands in no namespace, and lupdate passes over what does.
        lists = Path(folder) / "lists.h"
        texts = [path.read_text(encoding="utf-8") for s in sources for path in sorted((root / s).rglob("*.h"))]
        lists.write_text("\n".join(f"namespace fyd {{\n{text}\n}}" for text in texts
                                   if not re.search("^#pragma once", text, re.MULTILINE)), encoding="utf-8")
        subprocess.run([lupdate, "-silent", "-locations", "none", "-I", str(root), *options, *[str(root / s) for s in sources],
                        str(lists), "-ts", str(ts)], check=True, capture_output=True)
        return {key: message.get("numerus") == "yes" for key, message in messages(ts)}


def said(root, lupdate):
    """Texts of the sources: (text, comment) -> whether it has plurals. The class that says it does not matter.

    A value that is a literal would be lupdate's comment on the text, and the window would not find it: the comment goes.
    """
    aliases = [word for call in CALLS for word in ("-tr-function-alias", f"tr+={call}")]
    of_window = found(root, lupdate, SOURCES, [])
    of_core = found(root, lupdate, SPEAKERS, aliases).keys() - of_window.keys()
    return {(text, ""): False for text, _ in of_core} | of_window


def messages(ts):
    for message in ElementTree.parse(ts).iter("message"):
        yield (message.findtext("source") or "", message.findtext("comment") or ""), message


def kept(ts):
    """(text, comment) -> list of forms; an empty form is unfinished."""
    if not ts.exists():
        return {}
    out = {}
    for key, message in messages(ts):
        translation = message.find("translation")
        forms = [form.text or "" for form in translation.findall("numerusform")] or [translation.text or ""]
        out[key] = [""] if translation.get("type") else forms
    return out


def write(ts, language, texts, known):
    lines = ['<?xml version="1.0" encoding="utf-8"?>', "<!DOCTYPE TS>",
             f'<TS version="2.1" language="{language}" sourcelanguage="en">', "<context>", "    <name>FYD</name>"]
    for key in sorted(texts):
        forms = known.get(key, [""])
        plural = texts[key]
        unfinished = "" if all(forms) else ' type="unfinished"'
        lines.append("    <message numerus=\"yes\">" if plural else "    <message>")
        lines.append(f"        <source>{escape(key[0])}</source>")
        if key[1]:
            lines.append(f"        <comment>{escape(key[1])}</comment>")
        body = "".join(f"<numerusform>{escape(f)}</numerusform>" for f in forms) if plural else escape(forms[0])
        lines.append(f"        <translation{unfinished}>{body}</translation>")
        lines.append("    </message>")
    ts.write_text("\n".join([*lines, "</context>", "</TS>", ""]), encoding="utf-8")


def places(text):
    """Number and spec of each of fmt's places: "{1:.2f}" -> (1, ".2f")."""
    matches = re.findall(r"\{(\d*)(?::([^{}]*))?\}", text.replace("{{", "").replace("}}", ""))
    return sorted((int(number or i), spec) for i, (number, spec) in enumerate(matches))


def values(text):
    text = text.replace("Maj+", "Shift+")  # what a French keyboard and Qt's own French call it
    return sorted(re.findall(r"%L?[0-9n]+", text)), places(text), sorted(re.findall(r"(?:Ctrl|Shift|Alt)\+(?:Shift\+)?\w|\bF\d\b", text))


def faults(language, texts, known):
    for key, plural in texts.items():
        forms = known.get(key)
        if forms is None:
            yield f"{language}: missing: {key[0]!r}"
        elif not all(forms) or plural and len(forms) != PLURALS[language]:
            yield f"{language}: unfinished: {key[0]!r}"
        elif not plural and values(key[0]) != values(forms[0]):
            yield f"{language}: {forms[0]!r} has other values or keys than {key[0]!r}"
    for key in known.keys() - texts.keys():
        yield f"{language}: no longer said: {key[0]!r}"


def calls(text):
    """(name, arguments as they stand) of each of CALLS."""
    for match in re.finditer(rf"(?<![\w.>:])({'|'.join(CALLS)})\(", text):
        depth, quoted, start, out, at = 0, False, match.end(), [], match.end()
        while at < len(text):
            c = text[at]
            if quoted:
                at += c == "\\"
                quoted = c != '"'
            elif c == '"':
                quoted = True
            elif c in "([{":
                depth += 1
            elif c in ")]}" and depth == 0 or c == "," and depth == 0:
                out.append(text[start:at].strip())
                start = at + 1
                if c != ",":
                    break
            elif c in ")]}":
                depth -= 1
            at += 1
        yield match[1], out, text.count("\n", 0, match.start()) + 1


# English that a message must not take for a value: it is a message itself (`say`, `phrase`), or the words of others.
ENGLISH = re.compile(r'"[^"]*[a-z] [a-z][^"]*"|\.text\(\)|\bwhat\(\)|\bstrerror\(|\.message\(\)|\bdescription\(\)$')
OWN = re.compile(r"\b(?:say|phrase|verbatim|about|listed|explained|systemReason|fmt::join)\(")


def wrong_calls(root, texts):
    """A literal that lupdate did not find; a value that is itself English; a format of places only."""
    for path in sorted(path for folder in SPEAKERS for path in (root / folder).rglob("*.[ch]*")):
        if path.name in ("message.h", "error.h"):
            continue
        source = path.read_text(encoding="utf-8")
        for name, arguments, line in calls(re.sub(r"//[^\n]*", lambda comment: " " * len(comment[0]), source)):
            parts = re.findall(r'"((?:[^"\\]|\\.)*)"', arguments[0])
            where = f"{path.relative_to(root)}:{line}"
            if not re.fullmatch(r'(?:"(?:[^"\\]|\\.)*"\s*)+', arguments[0]):
                continue  # a message, or a function of the same name
            text = "".join(parts).replace('\\"', '"')
            if (text, "") not in texts:
                yield f"{where}: lupdate does not find {text!r}"
            if not re.search(r"[^\W\d_]", re.sub(r"\{[^}]*\}", "", text)):
                yield f"{where}: {text!r} has places only: nothing to translate"
            for value in arguments[1:]:
                if ENGLISH.search(value) and not OWN.search(value):
                    yield f"{where}: the value {value!r} is English: say(…), phrase(…) or, of others, verbatim(…)"


def untold_help(root, texts):
    """The help of each parameter of the step (core/pipeline/parameters.h), as the manual's table has it, is translated."""
    rows = re.findall(r"^\| `(pipeline|sensing|control|texture)\.(\w+)` \|(?:[^|]*\|){3} (.+) \|$",
                      (root / "resources/manual/parameters.md").read_text(encoding="utf-8"), re.MULTILINE)
    if len(rows) < 50:
        yield f"parameters.md: only {len(rows)} parameters of the step found"
    for room, name, text in rows:
        if (text, "") not in texts:
            yield f"the help of {room}.{name} is no sentence(…): {text!r}"
    for path in [path for room in ("pipeline", "sensing", "control", "texture") for path in (root / "core" / room).glob("*.h")]:
        text = path.read_text(encoding="utf-8")
        for name in re.findall(r'\.name = ("[^"]*")', text) if "void describe(" in text else []:
            yield f"{path.name}: the name of a parameter is no sentence(…): {name}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("task", choices=["check", "update"])
    parser.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[2])
    parser.add_argument("--lupdate", default="/usr/lib/qt6/bin/lupdate")
    options = parser.parse_args()
    texts = said(options.root, options.lupdate)
    found = []
    for language in PLURALS:
        # English needs its plurals only.
        own = {key: plural for key, plural in texts.items() if plural or language != "en"}
        ts = options.root / "resources/translations" / f"fyd_{language}.ts"
        if options.task == "update":
            write(ts, language, own, kept(ts))
        found += faults(language, own, kept(ts))
    found += wrong_calls(options.root, texts)
    found += untold_help(options.root, texts)
    if options.task == "check" and len(texts) < 100:
        found.append(f"only {len(texts)} texts found in the sources: is lupdate the right one?")
    print("\n".join(found) if found else f"{len(texts)} texts, complete in {', '.join(PLURALS)}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
