"""The command line of a program, read from its own help texts: CLI11's of fyd, Qt's of fyd-console."""
import dataclasses
import os
import re
import subprocess
from pathlib import Path


@dataclasses.dataclass
class Argument:
    names: list  # of an option its spellings, of a positional its one name
    value: str   # as the help shows it; empty: a switch
    help: str

    @property
    def choices(self):
        """The words that are possible, where the help lists them."""
        listed = re.search(r"\{([^{}]*)\}", self.value)
        return listed[1].split(",") if listed else []


@dataclasses.dataclass
class Command:
    words: list
    summary: str
    usage: str
    positionals: list
    options: list
    commands: list

    def all(self):
        yield self
        for command in self.commands:
            yield from command.all()


def entries(text, title):
    """(left column, right column) of the section with this title."""
    out, inside = [], False
    for line in text.split("\n"):
        if re.match(r"\S", line):
            inside = line == title + ":"
        elif inside and re.match(r"  \S", line):
            left, _, right = re.sub(r" {2,}", "\0", line.strip(), count=1).partition("\0")
            out.append([left, right])
        elif inside and line.strip():
            out[-1][1] = f"{out[-1][1]} {line.strip()}".strip()
    return out


def argument(left, right):
    """"-o,--output TEXT REQUIRED", "-h, --help", "--key <FILE>", "folder TEXT"."""
    match = re.match(r"(-[^\s,]+(?:, ?-[^\s,]+)*|[^\s-]\S*)(?: (.*))?$", left)
    return Argument(re.split(r", ?", match[1]), (match[2] or "").replace("<", "").replace(">", ""), right)


def read(program, *words):
    """@raise RuntimeError a program that gives no help"""
    done = subprocess.run([program, *words, "--help"], capture_output=True, encoding="utf-8", check=False,
                          env=os.environ | {"QT_QPA_PLATFORM": "offscreen", "LC_ALL": "C.UTF-8"})
    text = done.stdout
    usage = re.search(r"^Usage: (.*)$", text, re.MULTILINE)
    if done.returncode != 0 or not usage:
        raise RuntimeError(f"{program} {' '.join(words)} --help: exit code {done.returncode}: {done.stderr or text}")
    name = Path(program).name
    prose = [line for line in text[:text.find("\nOptions:")].split("\n") if line and not line.startswith("Usage: ")]
    return Command([name, *words], prose[0].removeprefix("FYD Console: ").rstrip("."), usage[1], [argument(*each) for each in entries(text, "Positionals")],
                   [argument(*each) for each in entries(text, "Options")],
                   [read_subcommand(program, [*words, each], summary) for each, summary in entries(text, "Subcommands")])


def read_subcommand(program, words, summary):
    # fyd-bench, to which this one hands its help on, is in no package.
    if words == ["bench"]:
        return Command([Path(program).name, *words], summary, "fyd bench [SUBJECT]...", [], [], [])
    return read(program, *words)
