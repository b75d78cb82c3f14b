"""fyd bench --all: every subject in one run, as text, Markdown, CSV, JSON and pictures. What it measures is not judged."""
import csv
import json
import os
import re
import resource
import subprocess
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import fyd

SUBJECTS = sorted(path.stem for path in (Path(os.environ["FYD_SOURCE_DIR"]) / "app/bench").glob("*.cpp") if path.stem != "main")


@fyd.needs_bench
class Bench(fyd.Case):
    def test_all_subjects_are_run_and_written(self):
        out = Path(self.path("out"))
        done = fyd.run("bench", "--all", "--quick", "--out", out, "--runs", 2, "--data", fyd.DATA, timeout=1500)
        self.assertEqual(done.returncode, 0, done.stderr)
        page = (out / "numbers.md").read_text(encoding="utf-8")
        self.assertEqual(sorted(re.findall(r"^## (\w+)$", page, re.MULTILINE)), SUBJECTS)
        for name in ("date", "processor", "cores", "memory", "version", "revision", "compiler", "build type", "flags"):
            self.assertRegex(page, rf"(?m)^\| {name} \| [^|]+ \|$")
        self.assertIn("--quick", page)
        with open(out / "numbers.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        measured = {row["subject"] for row in rows}
        self.assertLessEqual(set(SUBJECTS) - measured, {"window"})
        if "window" not in measured:
            self.assertIn("fyd-window-bench", page)
        # Each subject but those that say so has a baseline, and its ratio is 1.
        for subject in measured:
            baselines = [row for row in rows if row["subject"] == subject and row["what"] == row["baseline"]]
            self.assertTrue(baselines, f"{subject} has no baseline")
            self.assertLessEqual({row["cost / baseline"] for row in baselines}, {"1", "—"}, subject)
        self.assertEqual([row for row in rows if "FAILED" in row["what"] or row["cost"] in ("", "—") and row["error"] in ("", "—")],
                         [], "a row without a figure")
        for subject in measured:
            with self.subTest(subject=subject):
                with open(out / f"{subject}.csv", encoding="utf-8", newline="") as file:
                    table = list(csv.reader(file))
                self.assertEqual({len(line) for line in table}, {len(table[0])}, "cells of a row")
                self.assertEqual(len(table) - 1, sum(row["subject"] == subject for row in rows))
                markdown = (out / f"{subject}.md").read_text(encoding="utf-8")
                self.assertEqual(len(re.findall(r"^\| ", markdown, re.MULTILINE)), len(table))
        tree = ElementTree.parse(out / "numbers.svg")
        self.assertGreater(len(tree.findall(".//{http://www.w3.org/2000/svg}circle")), 5)

    def test_a_table_as_text_has_what_its_json_has(self):
        done = fyd.run("bench", "calibration", "--quick", "--text")
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = self.json("bench", "calibration", "--quick", "--json")[0]["rows"]
        lines = done.stdout.split("\n")
        self.assertTrue(lines[1].startswith("codes"), lines[1])
        for row, line in zip(rows, lines[2:]):
            self.assertTrue(line.startswith(row["codes"] + "  "), line)
            self.assertIn(row["method"], line)

    def test_a_copy_of_bytes_allocates_nothing(self):
        rows = self.json("bench", "link", "--quick", "--json")[0]["rows"]
        copies = [row for row in rows if "baseline" in row["operation"]]
        self.assertEqual([float(row["allocations"]) for row in copies], [0] * 4)

    def test_what_is_read_of_a_recording_is_there(self):
        rows = self.json("bench", "recording", "--quick", "--json")[0]["rows"]
        self.assertIn("1000 steps in order, for replay", [row["what"] for row in rows])
        self.assertFalse([row["what"] for row in rows if "FAILED" in row["what"]])

    def test_what_the_recorder_costs_is_of_a_recorder_that_records(self):
        rows = self.json("bench", "recorder", "--quick", "--json")[0]["rows"]
        self.assertFalse([row["what"] for row in rows if "FAILED" in row["what"]])
        self.assertGreater(float(rows[-1]["written (kB/s)"]), 0)

    def test_a_recording_that_could_not_be_made_is_no_result(self):
        def no_file_may_grow():
            resource.setrlimit(resource.RLIMIT_FSIZE, (0, 0))
        for subject, failed in (("recorder", ("push to the recorder", "simulated station, recorded")), ("replay", ("recording",))):
            with self.subTest(subject=subject):
                done = subprocess.run([fyd.PROGRAM, "bench", subject, "--quick", "--json"], capture_output=True, text=True,
                                      timeout=fyd.PATIENCE, check=True, preexec_fn=no_file_may_grow)
                names = [row["what"] for row in json.loads(done.stdout)[0]["rows"]]
                for name in failed:
                    self.assertTrue(any(each.startswith(name + " (FAILED: ") for each in names), names)

    def test_a_folder_without_recordings_is_named(self):
        for subject in ("predict", "deadband"):
            self.assertIn(self.folder, self.refused(1, "bench", subject, "--quick", "--data", self.folder))

    def test_where_it_is_to_write_is_judged_before_it_measures(self):
        file = self.write("file", "")
        self.assertIn(file, self.refused(1, "bench", "step", "--quick", "--out", file, "--json"))

    def test_what_was_measured_is_printed_though_a_file_of_it_cannot_be_written(self):
        os.makedirs(self.path("out/step.md"))
        done = fyd.run("bench", "step", "--quick", "--out", self.path("out"), "--json")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertTrue(json.loads(done.stdout)["result"][0]["rows"])

    def test_what_does_not_go_together_is_refused(self):
        self.assertIn("--out", self.refused(2, "bench", "--all"))
        self.refused(2, "bench", "step", "--all", "--out", self.path("out"))
        self.refused(2, "bench", "step", "--text", "--json")


if __name__ == "__main__":
    unittest.main()
