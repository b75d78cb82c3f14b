"""The code blocks of README.md and of every page of the manual, found as any Markdown reader finds them.

The first word after a block's fence is its language; what follows says what it is: ```text diagram, ```toml scene,
```cpp examples/predictor.cpp (the block is that file).
"""
import dataclasses
import os
from pathlib import Path

from markdown_it import MarkdownIt

TRANSLATIONS = ("it", "fr")


@dataclasses.dataclass
class Block:
    page: str  # "PROJECT" is the README of the project; others as below resources/manual: "it/operate.md"
    line: int  # of its first line of code, from 1
    language: str  # "": the fence names none; None: no fence, only indented
    what: str
    code: str

    @property
    def first(self):
        return self.code.split("\n", 1)[0]

    @property
    def kind(self):
        return f"{self.language} {self.what}".strip() if self.language == "text" else self.language

    def __str__(self):
        return f"{self.page}:{self.line}"


def pages(root):
    """Name -> path, the project's README first, called PROJECT."""
    manual = Path(root) / "resources/manual"
    out = {"PROJECT": Path(root) / "README.md"}
    for path in sorted(manual.rglob("*.md")):
        out[path.relative_to(manual).as_posix()] = path
    return out


def blocks_of(page, path):
    text = path.read_text(encoding="utf-8")
    lines = text.split("\n")
    parser = MarkdownIt("commonmark").enable("table")
    for token in parser.parse(text):
        if token.type == "fence":
            # An open fence swallows the rest of the page, and no reader says so.
            if lines[token.map[1] - 1].strip(" ~`") or token.map[1] - token.map[0] < 2:
                raise SyntaxError(f"{page}:{token.map[0] + 1}: this fence is never closed")
            language, _, what = token.info.strip().partition(" ")
            yield Block(page, token.map[0] + 2, language, what.strip(), token.content)
        elif token.type == "code_block":
            yield Block(page, token.map[0] + 1, None, "", token.content)


def all_blocks(root):
    return [block for page, path in pages(root).items() for block in blocks_of(page, path)]


def prose_of(path):
    """The words between backquotes, outside of blocks, with their line."""
    parser = MarkdownIt("commonmark").enable("table")
    for token in parser.parse(path.read_text(encoding="utf-8")):
        for child in token.children or []:
            if child.type == "code_inline":
                yield (token.map[0] + 1 if token.map else 0), child.content


def is_translated(page):
    return os.path.dirname(page) in TRANSLATIONS
