"""The manual is true: its table of parameters is the program's, and every page it names exists."""
import os
import re
import unittest

import fyd

MANUAL = os.path.join(os.environ["FYD_SOURCE_DIR"], "resources", "manual")


def pages():
    """Names of all, "operate.md" and "it/operate.md"."""
    for folder, _, names in os.walk(MANUAL):
        for name in names:
            if name.endswith(".md"):
                yield os.path.relpath(os.path.join(folder, name), MANUAL)


def page(name):
    with open(os.path.join(MANUAL, name), encoding="utf-8") as file:
        return file.read()


class Manual(fyd.Case):
    def test_the_table_of_parameters_is_the_programs(self):
        table = fyd.run("params", "--markdown").stdout
        self.assertIn(table, page("parameters.md"), "run: fyd params --markdown, and put it into parameters.md")

    def test_the_table_of_a_scenes_keys_is_the_programs(self):
        self.assertIn(fyd.run("scene", "keys").stdout, page("scene-keys.md"), "run: fyd scene keys, and put it into scene-keys.md")

    def test_the_tables_of_a_recordings_columns_are_the_programs(self):
        tables = fyd.run("session", "columns").stdout
        first = tables.splitlines()[0]
        kept = page("recording-columns.md")
        self.assertEqual(kept[kept.index(first):].splitlines(), tables.rstrip().splitlines(),
                         "run: fyd session columns, and put it into recording-columns.md")

    def test_every_page_and_picture_that_is_named_exists(self):
        for name in pages():
            words = re.sub(r"^```.*?^```", "", page(name), flags=re.DOTALL | re.MULTILINE)
            for target in re.findall(r"\]\(([^)#\s]+)", words):
                if "://" not in target:
                    self.assertTrue(os.path.exists(os.path.join(MANUAL, os.path.dirname(name), target)), f"{name} names {target}")

    def test_every_subcommand_that_a_page_or_the_readme_shows_exists(self):
        known = set(re.findall(r"^  (\w+) ", fyd.run("--help").stdout, re.MULTILINE))
        with open(os.path.join(os.environ["FYD_SOURCE_DIR"], "README.md"), encoding="utf-8") as file:
            texts = [file.read()] + [page(name) for name in pages()]
        for text in texts:
            for block in re.findall(r"```.*?```|^    .*$", text, re.DOTALL | re.MULTILINE):
                for command in re.findall(r"(?:^|[/`\s])fyd (\w+)", block):
                    self.assertIn(command, known, block)


if __name__ == "__main__":
    unittest.main()
