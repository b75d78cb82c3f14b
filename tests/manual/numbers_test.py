"""The page of numbers and that of numerical stability are what was measured, and the README quotes them as they are."""
import importlib.util
import math
import os
import re
import statistics
import subprocess
import unittest
from pathlib import Path

ROOT = Path(os.environ["FYD_SOURCE_DIR"])
MANUAL = ROOT / "resources/manual"
FACTS = ("date", "processor", "cores", "memory", "others at work", "system", "version", "revision", "compiler", "build type",
         "flags", "measuring took")

spec = importlib.util.spec_from_file_location("take", MANUAL / "numbers/take.py")
take = importlib.util.module_from_spec(spec)
spec.loader.exec_module(take)


def subjects():
    """A file of app/bench each."""
    return sorted(path.stem for path in (ROOT / "app/bench").glob("*.cpp") if path.stem != "main")


def median(cells):
    """Of a method whose baseline has no error the multiple is infinite; what never came is longer than everything."""
    values = [math.inf if cell == "never" else take.number(cell) for cell in cells]
    values = [value for value in values if not math.isnan(value)]
    return statistics.median(values) if values else math.nan


def ever(row, rows):
    """Whether it and its baseline came to an end."""
    return "never" not in [row["cost"]] + [each["cost"] for each in rows if all(
        each[column] == value for column, value in
        (("subject", row["subject"]), ("case", row["case"]), ("what", row["baseline"]), ("unit of cost", row["unit of cost"])))]


def differs(shown, expected):
    """Both are rounded to three digits, the median of an even number of rounded values once more."""
    if math.isnan(expected):
        return shown != "—"
    if math.isinf(expected):
        return shown not in ("never", "∞")
    return not abs(take.number(shown) - expected) <= 0.011 * abs(expected)


def page_faults(page, rows):
    """What the page says otherwise than the rows of numbers.csv."""
    out, tables = [], take.tables_of(page)
    for subject in subjects():
        if subject not in tables:
            out.append(f"{subject}: has no table")
            continue
        columns, shown = tables[subject]
        methods = {}
        for row in rows:
            if row["subject"] == subject:
                methods.setdefault((row["what"], row["unit of cost"] if "unit" in columns else ""), []).append(row)
        names = [(row[0], row[columns.index("unit")] if "unit" in columns else "") for row in shown]
        if names != list(methods):
            out.append(f"{subject}: rows {names}, numbers.csv has {list(methods)}")
            continue
        for line, (name, of_method) in zip(shown, methods.items()):
            if int(line[1]) != len(of_method):
                out.append(f"{subject}, {name[0]}: {line[1]} rows, numbers.csv has {len(of_method)}")
            compared = {"× baseline": "cost / baseline", "error × baseline": "error / baseline"}
            for at, column in enumerate(columns[2:], 2):
                if column in compared:
                    all_ended = compared[column] == "error / baseline" or all(ever(row, rows) for row in of_method)
                    expected = median(row[compared[column]] for row in of_method) if all_ended else math.nan
                elif column == "unit":
                    continue
                else:
                    kind = "cost" if at + 1 < len(columns) and "× baseline" in columns[at + 1:at + 3] and \
                        columns[at + 1] != "error × baseline" else "error"
                    if len(of_method) == 1 and line[at] == of_method[0][kind]:
                        continue
                    if line[at] == "—" and len({row["unit of " + kind] for row in of_method}) > 1:
                        continue
                    expected = median(row[kind] for row in of_method)
                if differs(line[at], expected):
                    out.append(f"{subject}, {name[0]}, {column}: {line[at]}, of numbers.csv {expected:.4g}")
    return out


class Numbers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.page = (MANUAL / "numbers.md").read_text(encoding="utf-8")
        cls.rows = take.rows_of(MANUAL / "numbers/numbers.csv")

    def test_the_page_has_every_subject_and_says_what_the_rows_say(self):
        self.assertGreater(len(subjects()), 20)
        self.assertGreater(len(self.rows), 400)
        self.assertEqual(page_faults(self.page, self.rows), [])

    def test_every_row_was_measured(self):
        self.assertEqual(take.not_measured(self.rows), [])
        planted = [{"subject": "a", "what": "b", "cost": "—", "error": "—"}, {"subject": "a", "what": "c", "cost": "", "error": "∞"},
                   {"subject": "a", "what": "d (FAILED: e)", "cost": "1", "error": "0"}]
        self.assertEqual(take.not_measured(planted), ["a: b", "a: d (FAILED: e)"])

    def test_every_subject_of_the_program_is_a_file_here(self):
        program = Path(os.environ["FYD_PROGRAMS"]) / "fyd-bench"
        if not program.exists():
            self.skipTest("fyd-bench is not built")
        text = subprocess.run([program, "--help"], capture_output=True, text=True, check=True).stdout
        self.assertEqual(sorted(re.search(r"\{([\w,]+)\}", text)[1].split(",")), subjects())

    def test_it_names_date_machine_and_build_and_was_not_shortened(self):
        facts = dict(take.tables_of(self.page)["Numbers"][1])
        self.assertEqual(tuple(facts), FACTS)
        self.assertEqual([name for name, value in facts.items() if value in ("", "unknown")], [])
        self.assertRegex(facts["date"], r"^20\d\d-\d\d-\d\d \d\d:\d\d UTC$")
        self.assertRegex(facts["revision"], r"^[0-9a-f]{12}$", "what was measured is a revision without changes")
        self.assertEqual(facts["build type"], "Release")
        if float(facts["others at work"].split()[0]) > 0.25 * int(facts["cores"]):
            self.assertIn("not idle", facts["others at work"])
        self.assertNotIn("--quick", self.page)

    def test_the_readme_quotes_the_page(self):
        columns, rows = take.readme_table(self.page)
        self.assertEqual(take.tables_of((ROOT / "README.md").read_text(encoding="utf-8"))["Measured"], (columns, rows),
                         "run resources/manual/numbers/take.py with the folder of the last run")

    def test_the_table_of_numerical_stability_is_the_one_that_was_run(self):
        expected = take.stability_table(take.rows_of(MANUAL / "numbers/stability.csv"))
        page = (MANUAL / "stability.md").read_text(encoding="utf-8")
        self.assertEqual(take.tables_of(page)["The cases"], tuple(expected))
        self.assertGreaterEqual(len(expected[1]), 20)

    def test_planted_faults_are_found(self):
        columns, rows = take.tables_of(self.page)["step"]
        line = next(row for row in rows if row[0] == "default")
        cell = line[columns.index("p50 (ns)")]
        changed = self.page.replace(f"| {cell} |", f"| {float(cell) * 1.1:.3g} |")
        self.assertRegex("".join(page_faults(changed, self.rows)), "step, default, p50")
        self.assertIn("step: has no table", page_faults(self.page.replace("## step\n", "## stop\n"), self.rows))
        planted = [{**row, "cost": "never"} if row["subject"] == "step" and row["what"] == "default" else row for row in self.rows]
        self.assertRegex("".join(page_faults(self.page, planted)), "step, default, p50.*step, default, × baseline")
        fewer = [row for row in self.rows if row["what"] != "default"]
        self.assertRegex("".join(page_faults(self.page, fewer)), "step: rows")


if __name__ == "__main__":
    unittest.main()
