"""What the words of the manual name exists: files, options, parameters, tests, headings; and what it says of the code is
what the code says.

Only English pages are read: tests/translations/manual.py compares the translations with them.
"""
import functools
import glob
import os
import re
import subprocess
import tomllib
import unittest
from pathlib import Path

import block_checks
import manual_blocks

ROOT = Path(os.environ["FYD_SOURCE_DIR"])
BUILD = Path(os.environ["FYD_BUILD_DIR"])
MANUAL = ROOT / "resources/manual"
FOLDERS = ("app", "core", "widgets", "resources", "tests", "installer")


def english():
    return {page: path for page, path in manual_blocks.pages(ROOT).items() if not manual_blocks.is_translated(page)}


def words():
    """(page, line, text between backquotes) of all pages."""
    for page, path in english().items():
        for line, text in manual_blocks.prose_of(path):
            yield page, line, text


def headings(path):
    """As a link names them; the same rule as the window's (app/console/window/manual.cpp)."""
    quoted = False
    for line in path.read_text(encoding="utf-8").split("\n"):
        quoted ^= line.startswith("```")
        match = None if quoted else re.match(r"#{1,6} +(.*?)\s*$", line)
        if match:
            kept = [c for c in match[1].replace("`", "").lower() if c.isalnum() or c in "-_ "]
            yield "".join(kept).replace(" ", "-")


@functools.lru_cache(maxsize=None)
def tests_of_the_sources():
    """Suite -> names of its tests."""
    out = {}
    for path in (ROOT / "tests").rglob("*.cpp"):
        for suite, name in re.findall(r"^TEST(?:_F|_P)?\((\w+),\s*(\w+)\)", path.read_text(encoding="utf-8"), re.MULTILINE):
            out.setdefault(suite, set()).add(name)
    return out


@functools.lru_cache(maxsize=None)
def help_texts():
    """Of every program and subcommand, as one text."""
    programs = os.environ["FYD_PROGRAMS"]
    out = []

    def collect(*chain):
        text = block_checks.help_of(programs, *chain)
        if text is not None:
            out.append(text)
            for name in block_checks.subcommands(text):
                collect(*chain, name)

    collect("fyd")
    for program in ("fyd-console", "fyd-bench", "fyd-window-bench"):
        if (Path(programs) / program).exists():
            collect(program)
    return "\n".join(out)


class Pages(unittest.TestCase):
    def assert_no_faults(self, faults):
        self.assertEqual(faults, [], "\n" + "\n".join(faults))

    def test_the_contents_name_every_page_once(self):
        linked = re.findall(r"\]\(([\w-]+\.md)\)", (MANUAL / "README.md").read_text(encoding="utf-8").split("\n## What was")[0])
        pages = sorted(page for page in english() if page not in ("PROJECT", "README.md"))
        self.assertEqual(sorted(linked), pages)

    def test_every_heading_that_a_link_names_exists(self):
        faults = []
        for page, path in manual_blocks.pages(ROOT).items():
            for target, anchor in re.findall(r"\]\(([^)#\s]*)#([^)\s]+)\)", path.read_text(encoding="utf-8")):
                if "://" in target:
                    continue
                there = (path.parent / target).resolve() if target else path
                # A translated page is linked by the English headings: the window follows their order.
                own = there.parent.parent / there.name if there.parent.name in manual_blocks.TRANSLATIONS else there
                if not there.exists() or anchor not in set(headings(there)) | set(headings(own)):
                    faults.append(f"{page}: {target}#{anchor}")
        self.assert_no_faults(faults)

    def test_every_file_that_is_named_exists(self):
        faults = []
        for page, line, text in words():
            for name in re.findall(r"(?<![\w./-])(?:%s)/[\w./*{},-]+" % "|".join(FOLDERS), text):
                options = [name]
                for part in re.findall(r"\{([^}]*)\}", name):
                    options = [each.replace("{%s}" % part, one) for each in options for one in part.split(",")]
                for each in options:
                    if not glob.glob(str(ROOT / each.rstrip("."))):
                        faults.append(f"{page}:{line}: there is no {each}")
        self.assert_no_faults(faults)

    @unittest.skipIf(os.environ.get("FYD_NOT_BUILT"), "programs that have options are left out of this build")
    def test_every_option_that_is_named_exists(self):
        known = set(re.findall(r"(?<![\w-])--[a-z][\w-]*", help_texts()))
        # of other programs that a page names
        known |= {"--preset", "--build", "--target", "--gtest_filter", "--benchmark_filter", "--test-dir"}
        # and of the project's own scripts
        for path in [*ROOT.glob("resources/**/*.py"), *ROOT.glob("tests/**/*.py")]:
            known |= set(re.findall(r"add_argument\(\"(--[a-z][\w-]*)\"", path.read_text(encoding="utf-8")))
        faults = []
        for page, line, text in words():
            if re.match(r"(\S*/)?(cmake|ctest|git|gcovr|apt|apt-get|dpkg|h5repack|pytest|python3|clang\S*|lintian|mmdebstrap|man|pip|dh\S*|doxygen|pkg-config|valgrind|installer/\S+) ", text):
                continue
            faults += [f"{page}:{line}: no program has {option}: {text}"
                       for option in re.findall(r"(?<![\w-])--[a-z][\w-]*", text) if option not in known]
        self.assert_no_faults(faults)

    @unittest.skipIf(os.environ.get("FYD_NOT_BUILT"), "the window is left out of this build")
    def test_every_option_of_the_window_is_on_its_page(self):
        page = (MANUAL / "operate.md").read_text(encoding="utf-8")
        options = set(re.findall(r"(?<![\w-])--[a-z][\w-]*", block_checks.help_of(os.environ["FYD_PROGRAMS"], "fyd-console"))) - {"--help", "--version"}
        self.assertGreater(len(options), 20)
        missing = [option for option in sorted(options) if not re.search(re.escape(option) + r"(?![\w-])", page)]
        self.assertEqual(missing, [])

    def test_every_command_among_the_words_exists_with_its_options(self):
        """`fyd session list --tag WORD`: the subcommand has the option, not only some other one."""
        class Place:
            programs = os.environ["FYD_PROGRAMS"]

        faults, count = [], 0
        for page, line, text in words():
            if not re.match(r"(\S*/)?fyd(-console|-bench|-window-bench)? [a-z-]", text) or "… -" in text:
                continue
            try:
                # A quotation mark without its partner is the page's own, as in `--notes "…`.
                block_checks.check_options(text.replace('"', "").replace("…", ""), Place)
                count += 1
            except block_checks.NotBuilt:
                pass
            except block_checks.Broken as broken:
                faults.append(f"{page}:{line}: {broken}")
        self.assertGreater(count, 50)
        self.assert_no_faults(faults)

    def test_every_command_of_the_program_is_run_on_some_page(self):
        listed = tomllib.loads((Path(__file__).parent / "blocks.toml").read_text(encoding="utf-8"))["not_run"]
        run = "".join(block.code for block in manual_blocks.all_blocks(ROOT) if block.language in ("sh", "console")
                      and not any(row["page"] == block.page and block.first.startswith(row["first"]) for row in listed))
        list_of_commands = (ROOT / "app/cli/CMakeLists.txt").read_text(encoding="utf-8")
        commands = re.search(r"set\(FYD_COMMANDS ([\w ]+)\)", list_of_commands)[1].split()
        self.assertGreater(len(commands), 15)
        self.assertEqual([name for name in commands if not re.search(rf"\bfyd {name}\b", run)], [])

    def test_every_parameter_that_is_named_exists(self):
        done = subprocess.run([Path(os.environ["FYD_PROGRAMS"]) / "fyd", "params", "--markdown"], capture_output=True, text=True,
                              check=True)
        known = set(re.findall(r"`([a-z_]+\.\w+)`", done.stdout))
        self.assertGreater(len(known), 100)
        groups = {each.split(".")[0] for each in known}
        faults = []
        for page, line, text in words():
            for name in re.findall(r"(?<![\w./-])(?:%s)\.[a-z]\w*[\w*…]*(?![\w*…(])" % "|".join(groups), text):
                if name == "sim.fabric_…" and page == "glossary.md":
                    continue  # an old name, called so there
                if name + "/" in text:  # finger_scale_x/y_mm_per_px
                    name += "_…"
                pattern = re.compile(re.escape(name).replace(r"\*", r"\w*").replace("…", r"\w*").replace("N_", r"(N|\d+)_"))
                if not any(pattern.fullmatch(each) or each.startswith(name) and name.endswith("_") for each in known):
                    if not re.search(r"\.(h|md|cpp|py|toml|csv|h5)$", name):
                        faults.append(f"{page}:{line}: there is no parameter {name}")
        self.assert_no_faults(faults)

    def test_every_name_of_the_code_exists(self):
        """Constants (kSilence_s), qualified names (Pipeline::step), variables of the build (FYD_UNITY)."""
        # pages_self_test.py plants names that do not exist.
        code = block_checks.sources(str(ROOT)) + "\n".join(
            path.read_text(encoding="utf-8") for name in ("CMakeLists.txt", "*.cmake", "*.py", "*.h", "*.cpp", "*.sh")
            for folder in ("tests", "installer") for path in (ROOT / folder).rglob(name)
            if path.name != "pages_self_test.py") + (ROOT / "CMakeLists.txt").read_text()
        known = set(re.findall(r"\w+", code))
        faults = [f"{page}:{line}: the code has no {text}" for page, line, text in words()
                  if re.fullmatch(r"k[A-Z]\w+|FYD_[A-Z_0-9]+|[A-Za-z]\w*(::\w+)+(\(\))?", text)
                  and not set(re.findall(r"\w+", text)) <= known]
        self.assert_no_faults(faults)

    def test_every_test_that_is_named_exists(self):
        known = tests_of_the_sources()
        every = [f"{suite}.{name}" for suite, names in known.items() for name in names]
        faults = []
        for page, line, text in words():
            for filters in re.findall(r"--gtest_filter='?([^'\s`]+)", text):
                for each in re.split(r"[:-]", filters.replace("*.*", "*")):
                    pattern = re.compile(re.escape(each).replace(r"\*", ".*").replace(r"\?", "."))
                    if each and not any(pattern.fullmatch(name) or pattern.fullmatch("Any/" + name) for name in every):
                        faults.append(f"{page}:{line}: no test fits {each}")
            match = re.fullmatch(r"([A-Z]\w*[a-z]\w*)\.([A-Z]\w+)", text)
            if match and match[1] in known and match[2] not in known[match[1]]:
                faults.append(f"{page}:{line}: there is no test {text}")
            if match and match[1] not in known and page == "safety.md":
                faults.append(f"{page}:{line}: there is no test {text}")
        self.assert_no_faults(faults)

    def test_every_test_of_ctest_that_is_named_exists(self):
        done = subprocess.run(["ctest", "-N", "--test-dir", str(BUILD)], capture_output=True, text=True, check=True)
        known = re.findall(r"Test +#\d+: (\S+)", done.stdout)
        self.assertGreater(len(known), 20)
        # and those that another preset has
        for path in (ROOT / "tests").rglob("CMakeLists.txt"):
            known += re.findall(r"add_test\(NAME (\w+) ", path.read_text(encoding="utf-8"))
        faults = [f"{page}:{line}: ctest knows no {text}" for page, line, text in words()
                  if re.fullmatch(r"(attack|cli|architecture|manual|golden|looks|fuzz)_[\w*]+", text)
                  and not any(re.fullmatch(text.replace("*", r"\w*"), each) for each in known)]
        self.assert_no_faults(faults)


class SafetyTable(unittest.TestCase):
    """safety.md shows the transition table of core/pipeline/safety.h."""

    def test_the_page_has_the_table_of_the_code(self):
        code = (ROOT / "core/pipeline/safety.h").read_text(encoding="utf-8")
        events = re.findall(r"^  (\w+),\s+///<", code[code.index("enum class SafetyEvent"):code.index("kSafetyEventCount")],
                            re.MULTILINE)
        table = code[code.index("kTable = {{"):code.index("}};")]
        rows = {name: [each.strip() for each in cells.split(",")]
                for cells, name in re.findall(r"^ +\{([^}]*)\},\s+// (\w+)$", table, re.MULTILINE)}
        self.assertEqual((len(rows), len(events)), (6, 7))
        page = (MANUAL / "safety.md").read_text(encoding="utf-8")
        expected = ["| state | " + " | ".join(events) + " |", "|---" * (len(events) + 1) + "|"]
        expected += [f"| {name} | " + " | ".join("**" + to + "**" if to != name else "·" for to in cells) + " |"
                     for name, cells in rows.items()]
        self.assertIn("\n".join(expected), page, "put this table into safety.md:\n" + "\n".join(expected))

    def test_the_page_lists_every_fault(self):
        faults = re.findall(r"^FAULT\((\w+), (\d+), (\w+), .*?sentence\(\"([^\"]+)\"\)",
                            (ROOT / "core/pipeline/fault_list.h").read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
        self.assertGreater(len(faults), 10)
        when = {"always": "always", "robot": "with a robot's target", "rendering": "while rendering"}
        page = (MANUAL / "safety.md").read_text(encoding="utf-8")
        expected = "\n".join(f"| {number} | {what} | {when[need]} |" for _, number, need, what in faults)
        self.assertIn(expected, page, "put these rows into safety.md:\n" + expected)


class Window(unittest.TestCase):
    """Each place, panel and dialog of the window has its section."""

    def test_every_place_and_panel_has_a_heading(self):
        named = re.findall(r'\{"[\w:]+", "([\w-]+\.md)(?:#([\w-]+))?"\}',
                           (ROOT / "app/console/window/manual.cpp").read_text(encoding="utf-8"))
        self.assertGreater(len(named), 30)
        for page, anchor in named:
            with self.subTest(page=page, anchor=anchor):
                self.assertTrue((MANUAL / page).exists())
                if anchor:
                    self.assertIn(anchor, set(headings(MANUAL / page)))

    def test_the_page_of_screens_has_every_place_and_panel(self):
        page = (MANUAL / "screens.md").read_text(encoding="utf-8")
        places = re.findall(r'\{"\w+", QT_TRANSLATE_NOOP\("Commands", "([^"]+)"\), "[\w-]+", "([^"]+)"',
                            (ROOT / "app/console/window/places.cpp").read_text(encoding="utf-8"))
        self.assertGreaterEqual(len(places), 5)
        for name, keys in places:
            self.assertIn(f"\n### {name} ({keys})\n", page)
        panels = re.search(r"kPanelNames = \{([^}]*)\}", (ROOT / "app/console/shell/options.h").read_text(encoding="utf-8"))[1]
        for name in re.findall(r'"([^"]+)"', panels):
            self.assertIn(f"\n| {name.replace('-', ' ')} |", page)

    def test_the_keys_of_every_command_are_named(self):
        """CommandInfo{id, menu, text, icon, keys} wherever it stands in the window's sources."""
        text = r'(?:QT_TRANSLATE_NOOP\("Commands",\s*)?"([^"]*)"\)?'
        command = re.compile(r'\{"([a-z_]+\.\w+)",\s*' + text + r",\s*" + text + r',\s*"[\w-]*",\s*"([^"]*)"', re.DOTALL)
        commands = [match for path in (ROOT / "app/console").rglob("*.cpp")
                    for match in command.findall(path.read_text(encoding="utf-8"))]
        self.assertGreater(len(commands), 30)
        manual = " ".join(path.read_text(encoding="utf-8") for page, path in english().items() if page != "PROJECT")
        missing = [f"{name}: {words} ({keys})" for name, _, words, keys in commands
                   if keys and not re.search(rf"(?<![\w+]){re.escape(keys)}(?![\w+])", manual)]
        self.assertEqual(missing, [], "no page names their keys")


if __name__ == "__main__":
    unittest.main()
