"""The test of the blocks finds what is wrong: each kind of broken block is planted in a page of its own."""
import os
import tempfile
import unittest
from pathlib import Path

from blocks_test import Book

ROOT = Path(os.environ["FYD_SOURCE_DIR"])
GOOD = "```sh\nfyd --version\n```\n"


class Planted(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        for name in ("tests", "installer", "core", "app", "widgets", "CMakePresets.json", "CMakeLists.txt"):
            (self.root / name).symlink_to(ROOT / name)
        (self.root / "resources/manual/it").mkdir(parents=True)
        (self.root / "README.md").write_text("# Project\n", encoding="utf-8")

    def write(self, name, text):
        (self.root / "resources/manual" / name).write_text(text, encoding="utf-8")

    def faults(self, text, **listed):
        self.write("page.md", "# Page\n\n" + text)
        self.book = Book(self.root, os.environ["FYD_PROGRAMS"], os.environ["FYD_BUILD_DIR"], listed).read()
        return "\n".join(self.book.faults)

    def block(self, info, code, **listed):
        return self.faults(f"Words.\n\n```{info}\n{code}\n```\n", **listed)

    def test_good_blocks_are_counted_and_pass(self):
        found = self.faults(GOOD + "\n```json\n{}\n```\n\n```console\n$ fyd --version\nfyd …\n```\n")
        self.assertEqual(found, "")
        self.assertEqual(self.book.counts, {("sh", "run"): 1, ("json", "run"): 1, ("console", "run"): 1})

    def test_a_fence_without_language_and_code_without_fence(self):
        self.assertIn("names no language", self.block("", "fyd --version"))
        self.assertIn("names no language", self.faults("Words.\n\n    fyd --version\n"))
        self.assertIn("nothing runs this", self.block("perl", "1"))
        self.assertIn("nothing runs this", self.block("text poem", "roses"))

    def test_a_fence_within_a_list_is_found_too(self):
        self.assertIn("exit code 1", self.faults("1. Do:\n\n   ```sh\n   false\n   ```\n"))

    def test_a_fence_that_is_never_closed(self):
        self.assertIn("never closed", self.faults("```sh\nfyd --version\n\nWords.\n"))

    def test_a_command_that_fails(self):
        self.assertIn("exit code 2", self.block("sh", "fyd station --no-such-option"))
        self.assertIn("exit code 1", self.block("sh", "fyd session info nothing.h5 && true"))
        self.assertIn("exit code 1", self.block("sh", "false | cat"))
        self.assertIn("exit code 1", self.block("sh", "for each in 1 2; do\n  [ $each = 1 ]\ndone"))
        self.assertIn("does not understand", self.block("sh", "for each in 1 2; do"))

    def test_a_command_in_the_background_that_fails(self):
        self.assertIn("exit code 2", self.block("sh", "fyd station --no-such-option &\nfyd --version"))

    def test_output_that_is_another(self):
        self.assertIn("expected", self.block("console", "$ fyd --version\nfyd 99.0.0"))
        self.assertIn("exit code 2", self.block("console", "$ fyd station --no-such\n…expected…"))
        self.assertEqual(self.block("console refused", "$ fyd station --no-such\n…not expected…"), "")
        self.assertIn("nothing is shown", self.block("console", "$ fyd --version\n…"))
        self.assertIn("which command", self.block("console", "fyd 0.1.0"))

    def test_a_synopsis_with_an_option_or_a_command_that_is_not_there(self):
        self.assertEqual(self.block("text synopsis", "fyd session export FILE OUT.csv [--from S] [--json]"), "")
        self.assertIn("has no option --until", self.block("text synopsis", "fyd session export FILE [--until S]"))
        self.assertIn("no such command", self.block("text synopsis", "fyd divine FILE [--json]"))
        self.assertIn("no command", self.block("text synopsis", ""))

    def test_tables_that_the_program_refuses(self):
        self.assertEqual(self.block("toml profile", "[control]\nkp = 12.0"), "")
        self.assertIn("no TOML", self.block("toml profile", "[control"))
        self.assertIn("kq", self.block("toml profile", "[control]\nkq = 12.0"))
        self.assertIn("expected one of", self.block("toml", "a = 1"))

    def test_json_that_is_none(self):
        self.assertIn("no JSON", self.block("json", "{"))

    def test_cpp_that_does_not_compile(self):
        self.assertEqual(self.block("cpp", '#include "core/control/pid.h"\nfyd::control::Pid* pid = nullptr;'), "")
        self.assertIn("no_such_name", self.block("cpp", "int a = no_such_name;"))

    def test_an_example_that_is_not_the_file(self):
        (self.root / "resources/manual/examples").mkdir()
        self.write("examples/a.cpp", "int a;\n")
        self.assertEqual(self.block("cpp examples/a.cpp", "int a;"), "")
        self.assertIn("differs", self.block("cpp examples/a.cpp", "int b;"))
        self.assertIn("there is no", self.block("cpp examples/b.cpp", "int b;"))

    def test_python_that_raises(self):
        self.assertEqual(self.faults("```python\nimport math\ntwo = 2\n```\n\n```python\nprint(two * math.pi)\n```\n"), "")
        self.assertIn("ZeroDivisionError", self.block("python", "1 / 0"))

    def test_cmake_that_does_not_parse(self):
        self.assertIn("Parse error", self.block("cmake", "find_package(Fyd"))

    def test_figures_and_names_that_the_code_does_not_have(self):
        self.assertEqual(self.block("text formula", "F = 1004.8805 · value"), "")
        self.assertIn("1004.8806", self.block("text formula", "F = 1004.8806 · value"))
        self.assertEqual(self.block("text diagram", "a ─▶ Pipeline::step"), "")
        self.assertIn("no Pipeline::zigzag", self.block("text diagram", "a ─▶ Pipeline::zigzag"))
        self.assertEqual(self.block("text folders", "core/protocol    classic/ link/"), "")
        self.assertIn("no folder modern/", self.block("text folders", "core/protocol    modern/"))
        self.assertIn("no folder core/magic", self.block("text folders", "core/magic    does all"))
        self.assertIn("words", self.block("text vectors", "words\n  baba"))

    def test_a_translation_with_other_code(self):
        self.write("it/page.md", "```sh\nfyd --help\n```\n")
        self.assertIn("it/page.md", self.faults(GOOD))

    def test_a_row_of_the_list_without_a_block_a_reason_or_a_check(self):
        row = {"page": "page.md", "first": "fyd station", "why": "takes minutes", "check": "options"}
        self.assertIn("no such block", self.faults(GOOD, not_run=[row]))
        self.assertEqual(self.block("sh", "fyd station", not_run=[row]), "")
        self.assertIn("no reason", self.block("sh", "fyd station", not_run=[row | {"why": ""}]))
        self.assertIn("expected one of", self.block("sh", "fyd station", not_run=[row | {"check": "none"}]))
        self.assertIn("no option", self.block("sh", "fyd station --no-such", not_run=[row]))
        script = {"page": "page.md", "why": "installs", "check": "scripts"}
        self.assertEqual(self.block("sh", "A=1 installer/run.sh  # builds\nsudo apt install x", not_run=[script]), "")
        self.assertIn("is no program", self.block("sh", "installer/walk.sh", not_run=[script]))
        preset = script | {"check": "presets"}
        self.assertEqual(self.block("sh", "cmake --build --preset asan --target test_pipeline", not_run=[preset]), "")
        self.assertIn("no buildPresets", self.block("sh", "cmake --build --preset asam", not_run=[preset]))
        self.assertIn("no target", self.block("sh", "cmake --build --preset asan --target test_kitchen", not_run=[preset]))
        self.assertIn("no such block", self.faults(GOOD, replaced=[{"page": "page.md", "old": "a", "new": "b"}]))
        self.assertIn("no such block", self.faults(GOOD, assumed=[{"page": "other.md", "run": "true"}]))
        self.assertEqual(self.block("sh", "cat a.txt", assumed=[{"file": "a.txt", "run": "touch a.txt"}]), "")


if __name__ == "__main__":
    unittest.main()
