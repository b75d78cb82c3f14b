"""The code blocks of README.md and of the manual run, or are listed with the reason why not.

The blocks are found in the pages themselves. Each page has a scratch folder, in which its blocks run one after another; sessions are shortened (FYD_MANUAL_AS_WRITTEN=1: not). What stands in blocks.toml is assumed, replaced
or left out, each with its reason. FYD_MANUAL_PAGES="PROJECT scenes.md" runs these pages only.
"""
import collections
import os
import shutil
import subprocess
import sys
import tempfile
import time
import tomllib
import unittest
from pathlib import Path

import block_checks as checks
import manual_blocks

# What a fence may say, with what is done.
LANGUAGES = ("sh", "console", "toml", "json", "python", "cpp", "cmake", "matlab", "text")
NOT_CODE = {"diagram": checks.check_diagram, "formula": checks.check_formula, "folders": checks.check_folders,
            "vectors": checks.check_vectors}
HOW = ("run", "checked", "not built")


class Book:
    """The pages of a tree and what blocks.toml says of them."""

    def __init__(self, root, programs, build, listed, as_written=False):
        self.root, self.programs, self.build, self.as_written = Path(root), Path(programs), build, as_written
        self.listed = listed
        self.used = set()
        self.faults = []
        self.counts = collections.Counter()

    def rows(self, kind, block):
        for i, row in enumerate(self.listed.get(kind, [])):
            if row["page"] == block.page and ("first" not in row or block.first.startswith(row["first"])):
                yield i, row

    def row(self, kind, block):
        for i, row in self.rows(kind, block):
            self.used.add((kind, i))
            return row
        return None

    def read(self, only=()):
        pages = {}
        for page, path in manual_blocks.pages(self.root).items():
            try:
                pages[page] = list(manual_blocks.blocks_of(page, path))
            except SyntaxError as error:
                self.faults.append(str(error))
        for page, blocks in pages.items():
            if only and page not in only:
                continue
            started = time.monotonic()
            if manual_blocks.is_translated(page):
                self.compare(page, blocks, pages.get(os.path.basename(page), []))
            elif blocks:
                self.run_page(page, blocks)
            if time.monotonic() - started > 1:
                print(f"  {page}: {time.monotonic() - started:.1f} s", file=sys.stderr)
        if not only:
            self.faults += [f"blocks.toml: [[{kind}]] {row.get('page', row.get('file'))}, {row.get('first', row.get('old', ''))!r}: no such block"
                            for kind, rows in self.listed.items() for i, row in enumerate(rows)
                            if (kind, i) not in self.used]
        return self

    def compare(self, page, blocks, english):
        """A translation has the English page's code, which runs there."""
        if [each.code for each in blocks] != [each.code for each in english]:
            self.faults.append(f"{page}: its code is not that of {os.path.basename(page)}")
        self.counts["in a translation, the same", "checked"] += len(blocks)

    def run_page(self, page, blocks):
        with tempfile.TemporaryDirectory() as folder:
            place = checks.Place(folder, self.root, self.programs, self.as_written)
            code = "".join(block.code for block in blocks)
            for i, row in enumerate(self.listed.get("assumed", [])):
                if row.get("page", page) == page and self.asks_for(row, code):
                    self.used.add(("assumed", i))
                    status, _, err = place.run(["bash", "-c", "set -e\n" + row["run"]])
                    if status != 0:
                        self.faults.append(f"blocks.toml: what {page} takes for granted: {err}")
            for i, block in enumerate(blocks):
                try:
                    self.counts[block.kind or "without language", self.do(block, blocks[:i], place)] += 1
                except checks.NotBuilt:
                    self.counts[block.kind, "not built"] += 1
                except checks.Broken as broken:
                    self.faults.append(f"{block}: {block.first}\n    {str(broken).strip()}")

    @staticmethod
    def asks_for(row, code):
        """A row with a file is for every page whose code names the file and does not make it."""
        return "file" not in row or row["file"] in code and f"--record {row['file']}" not in code

    def do(self, block, before, place):
        if not block.language:
            raise checks.Broken("names no language: write one of " + ", ".join(LANGUAGES) + " after the fence")
        code = block.code
        for i, row in enumerate(self.listed.get("replaced", [])):
            if row["page"] == block.page and row["old"] in code:
                self.used.add(("replaced", i))
                code = code.replace(row["old"], row["new"])
        left_out = self.row("not_run", block)
        if left_out:
            return self.instead(left_out, block, place)
        made = self.row("output", block)
        if made:
            _, out, err = place.run(["bash", "-c", made["command"]])
            checks.compare(code.split("\n"), [line.rstrip() for line in (out + err).split("\n")], made["command"])
            return "run"
        return self.execute(block, code, before, place)

    def execute(self, block, code, before, place):
        what = block.what
        if block.language == "sh":
            return checks.run_shell(code, place)
        if block.language == "console":
            return checks.run_console(code, what, place)
        if block.language == "toml":
            return checks.run_toml(code, what, place)
        if block.language == "json":
            return checks.run_json(code)
        if block.language == "cmake":
            return checks.check_cmake(code, place)
        if block.language == "python":
            earlier = "".join(each.code for each in before if each.language == "python")
            if what.startswith("examples/"):
                checks.check_example(code, what, self.root)
            return checks.run_python(code, earlier, place)
        if block.language == "cpp":
            if what.startswith("examples/"):
                return checks.check_example(code, what, self.root)
            return checks.compile_cpp(code, place, checks.core_command(self.build))
        if block.language == "text" and what == "synopsis":
            return checks.check_options(code, place)
        if block.language == "text" and what == "gesture":
            return checks.run_gesture(code, place)
        if block.language == "text" and what in NOT_CODE:
            return NOT_CODE[what](code, str(self.root))
        raise checks.Broken(f"{block.language} {what}: nothing runs this, and blocks.toml does not list it")

    def instead(self, row, block, place):
        if not row.get("why"):
            raise checks.Broken("blocks.toml gives no reason")
        how = {"options": lambda: checks.check_options(block.code, place),
               "scripts": lambda: checks.check_scripts(block.code, str(self.root)),
               "presets": lambda: checks.check_presets(block.code, str(self.root)),
               "words": lambda: checks.check_words(row["words"], block.code, str(self.root))}
        if row.get("check") not in how:
            raise checks.Broken(f"blocks.toml: check = {row.get('check')!r}: expected one of {', '.join(how)}")
        return how[row["check"]]()

    def table(self):
        languages = sorted({language for language, _ in self.counts})
        rows = [(language, [self.counts[language, how] for how in HOW]) for language in languages]
        rows.append(("all", [sum(counts) for counts in zip(*(counts for _, counts in rows))]))
        return "\n".join(f"{name:<28}" + "".join(f"{count:>6} {how}" for count, how in zip(counts, HOW)) for name, counts in rows)


def in_a_network_of_its_own():
    """Starts this program anew where nothing else uses the pages' ports; where that is not allowed, goes on as it is."""
    unshare = ["unshare", "-n"] if os.geteuid() == 0 else ["unshare", "-rn"]
    if "FYD_MANUAL_NETWORK" in os.environ or not shutil.which("ip"):
        return
    if subprocess.run([*unshare, "ip", "link", "set", "lo", "up"], capture_output=True, check=False).returncode == 0:
        os.environ["FYD_MANUAL_NETWORK"] = "own"
        os.execvp(unshare[0], [*unshare, "sh", "-c", 'ip link set lo up && exec "$@"', "sh", sys.executable, *sys.argv])


class Blocks(unittest.TestCase):
    def test_every_block_runs_or_is_listed_with_its_reason(self):
        root = os.environ["FYD_SOURCE_DIR"]
        listed = tomllib.loads((Path(__file__).parent / "blocks.toml").read_text(encoding="utf-8"))
        book = Book(root, os.environ["FYD_PROGRAMS"], os.environ["FYD_BUILD_DIR"], listed,
                    bool(os.environ.get("FYD_MANUAL_AS_WRITTEN")))
        only = os.environ.get("FYD_MANUAL_PAGES", "").split()
        book.read(only)
        print("\n" + book.table(), file=sys.stderr)
        self.assertEqual(book.faults, [], "\n" + "\n".join(book.faults))
        if not only:
            self.assertEqual(sum(book.counts.values()), len(manual_blocks.all_blocks(root)))


if __name__ == "__main__":
    in_a_network_of_its_own()
    unittest.main()
