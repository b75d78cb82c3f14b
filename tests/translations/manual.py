#!/usr/bin/env python3
"""The manual's translations: resources/manual/<language>/PAGE.md against the English resources/manual/PAGE.md.

check          fails when a translated page has other headings, paragraphs, list items, tables, numbers, code, links or
               pictures than the English one, does not call what the window has in **bold** or *italics* as the
               window's translation (resources/translations) does, or was made from another English text than today's
stamp PAGE...  for it/operate.md: "I looked at what changed in operate.md, and it/operate.md now says it". Enters the
               present English text's hash into the first line of the translation
"""
import argparse
import collections
import hashlib
import re
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

# What a language's contents page says of a page that is in English only.
ENGLISH_ONLY = {"it": "in inglese", "fr": "en anglais"}
STAMP = "<!-- translated from: %s -->"
# Keys of a shortcut, as Qt and so the window's menus name them.
KEYS = {"Invio": "Return", "Maj": "Shift", "Retour": "Return", "Effacement": "Backspace"}
EMPHASIS = re.compile(r"\*\*(?!\s)([^*]+?)\*\*|(?<![\w*])\*(?![\s*])([^*]+?)\*")


def read(path):
    return path.read_text(encoding="utf-8")


def hash_of(page):
    return hashlib.sha256(page.read_bytes()).hexdigest()[:16]


def plain(text):
    return " ".join(text.split())


class Section:
    """A heading and what stands under it, in the parts that a translation must not change."""

    def __init__(self, level, heading):
        self.level, self.heading = level, heading
        self.code, self.links, self.numbers, self.rows, self.parts = ([] for _ in range(5))
        self.emphasised = []

    def read(self, lines):
        prose, row_of_prose = [""], []
        fenced = indented = False
        for line in lines:
            if line.startswith("```"):
                fenced = not fenced
                continue
            # Four blanks after an empty line begin code, unless they go on with a list.
            indented = line.startswith("    ") and (indented or not prose[-1] and not self.in_list(prose))
            if fenced or indented:
                self.code.append(line.strip())
            elif line.startswith("|"):
                if not re.fullmatch(r"[|: -]+", line):
                    row_of_prose.append(line)
            elif re.match(r"\s*([-*]|\d+\.) ", line):
                prose.append(re.sub(r"^\s*([-*]|\d+\.) ", "\0 ", line))
            elif not line.strip():
                prose.append("")
            else:
                prose[-1] += " " + line
        self.parts = [part for part in prose if part]
        for row in row_of_prose:
            text = self.take(row)
            self.rows.append((len(re.findall(r"(?<!\\)\|", text)) - 1, sorted(self.numbers_of(text)), plain(row)))
        for text in [self.heading, *self.parts]:
            self.numbers += self.numbers_of(self.take(text))

    @staticmethod
    def in_list(prose):
        return any(part.startswith("\0") for part in prose[-2:])

    def take(self, text):
        """Takes code, links and emphasis out. @return what is left, of a link its words"""
        self.code += [plain(code) for code in re.findall(r"`([^`]+)`", text)]
        text = re.sub(r"`[^`]+`", "", text)
        self.links += [re.sub(r"^(\.\./)+", "", link) for link in re.findall(r"\]\(([^)]*)\)", text)]
        text = re.sub(r"\]\([^)]*\)", "]", text)
        self.emphasised += [plain(one or other) for one, other in EMPHASIS.findall(text)]
        return text

    @staticmethod
    def numbers_of(text):
        return re.findall(r"\d+(?:[.,]\d+)*", text)


def sections(text):
    out, lines, fenced = [], [], False
    for line in text.split("\n"):
        fenced ^= line.startswith("```")
        match = None if fenced else re.match(r"(#{1,6}) +(.*)", line)
        if match:
            if out:
                out[-1].read(lines)
            out.append(Section(len(match[1]), match[2].strip()))
            lines = []
        else:
            lines.append(line)
    if out:
        out[-1].read(lines)
    return out


def differences(what, english, translated):
    missing = collections.Counter(english) - collections.Counter(translated)
    extra = collections.Counter(translated) - collections.Counter(english)
    if missing:
        yield f"{what} missing: " + ", ".join(map(repr, missing.elements()))
    if extra:
        yield f"{what} not in the English page: " + ", ".join(map(repr, extra.elements()))


def english_keys(code):
    return "+".join(KEYS.get(key, key) for key in code.split("+")) if re.fullmatch(r"(\w+\+)*\w+", code) else code


def window_words(root, language):
    """English text of the window -> how the window says it in the language."""
    out = collections.defaultdict(set)
    for message in ElementTree.parse(root / f"resources/translations/fyd_{language}.ts").iter("message"):
        translation = message.find("translation")
        forms = [form.text or "" for form in translation.findall("numerusform")] or [translation.text or ""]
        out[plain(message.findtext("source"))].update(plain(form) for form in forms)
    return out


def parts_of(emphasised):
    """Each word of the window by itself: "View → Layouts…" has two."""
    return [part for each in emphasised for part in re.split(r" [→›] ", each)]


def section_faults(english, translated, words):
    yield from differences("code", english.code, map(english_keys, translated.code))
    yield from differences("link or picture", english.links, translated.links)
    yield from differences("number in the text", english.numbers, translated.numbers)
    if len(english.parts) != len(translated.parts):
        yield f"{len(translated.parts)} paragraphs and list items; the English page has {len(english.parts)}"
    if len(english.rows) != len(translated.rows):
        yield f"{len(translated.rows)} rows of tables; the English page has {len(english.rows)}"
    else:
        for own, other in zip(english.rows, translated.rows):
            if own[0] != other[0]:
                yield f"{other[0]} columns where the English page has {own[0]}: {other[2]}"
            yield from (f"{fault}: {other[2]}" for fault in differences("number", own[1], other[1]))
    # A word of the window begins with a capital; "from" and "to" may be anybody's.
    said = collections.Counter(parts_of(translated.emphasised))
    for text, count in collections.Counter(parts_of(english.emphasised)).items():
        if text in words and text[0].isupper() and sum(said[each] for each in words[text]) < count:
            yield (f"the window calls {text!r} " + " or ".join(repr(each) for each in sorted(words[text]))
                   + f": expected {count} × emphasised as in the English page")


def page_faults(page, english_page, words):
    text = read(page)
    expected = STAMP % hash_of(english_page)
    first = text.split("\n", 1)[0]
    if not re.fullmatch(STAMP % "[0-9a-f]{16}", first):
        yield f"the first line is {first!r}; expected {expected!r}"
    elif first != expected:
        yield (f"{english_page.name} has changed since this was translated: see git log -p"
                f" resources/manual/{english_page.name}, mend the"
               f" translation, then run: python3 tests/translations/manual.py stamp {page.parent.name}/{page.name}")
    english, translated = sections(read(english_page)), sections(text)
    for own, other in zip(english, translated):
        if own.level != other.level:
            yield (f"heading {other.heading!r} has level {other.level}; in its place the English page has"
                   f" {own.heading!r}, level {own.level}")
            return
    if len(english) != len(translated):
        yield (f"{len(translated)} headings; the English page has {len(english)}: "
               + ", ".join(each.heading for each in english))
        return
    for own, other in zip(english, translated):
        yield from (f"under {other.heading!r}: {fault}" for fault in section_faults(own, other, words))


def contents_faults(manual, language):
    """The contents say which pages are in English only."""
    for row in [line for line in read(manual / language / "README.md").split("\n") if line.startswith("|")]:
        link = re.search(r"\]\((?:\.\./)*([\w-]+\.md)\)", row)
        if link is None:
            continue
        marked = ENGLISH_ONLY[language] in row
        if marked == (manual / language / link[1]).exists():
            yield f"{link[1]}: " + (f"is translated, but its row says {ENGLISH_ONLY[language]!r}" if marked else
                                    f"is not translated: its row must say {ENGLISH_ONLY[language]!r}")


def check(root):
    manual = root / "resources/manual"
    found, count = [], 0
    for language in ENGLISH_ONLY:
        words = window_words(root, language)
        for page in sorted((manual / language).glob("*.md")):
            count += 1
            english = manual / page.name
            faults = list(page_faults(page, english, words)) if english.exists() else ["there is no such English page"]
            if page.name == "README.md" and english.exists():
                faults += contents_faults(manual, language)
            found += [f"{language}/{page.name}: {fault}" for fault in faults]
    if count == 0:
        found.append(f"no translated page in {manual}")
    print("\n".join(found) if found else f"{count} translated pages are as the English ones")
    return 1 if found else 0


def stamp(root, pages):
    manual = root / "resources/manual"
    for name in pages:
        page = manual / Path(name).parent.name / Path(name).name
        english = manual / page.name
        if page.parent.name not in ENGLISH_ONLY or not page.exists() or not english.exists():
            print(f"{name}: expected a translated page such as it/operate.md")
            return 1
        text = re.sub(r"\A" + STAMP % ".*" + "\n", "", read(page))
        page.write_text(STAMP % hash_of(english) + "\n" + text, encoding="utf-8")
        print(f"{name}: {hash_of(english)}")
    return 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("task", choices=["check", "stamp"])
    parser.add_argument("pages", nargs="*")
    parser.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[2])
    options = parser.parse_args()
    return check(options.root) if options.task == "check" else stamp(options.root, options.pages)


if __name__ == "__main__":
    sys.exit(main())
