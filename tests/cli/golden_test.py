"""The golden recordings (tests/data/recordings): made by older programs, still opened, verified, exported and replayed."""
import csv
import hashlib
import lzma
import os
import pathlib
import re
import shutil
import unittest

import fyd

GOLDEN = pathlib.Path(fyd.DATA) / "recordings"
KINDS = {"arithmetic_1": 1, "arithmetic_2": 2, "vibration": 2}  # the arithmetic that each was recorded with


GAINS = "Gains and calibration in use"  # those that are not the program's own: a new default adds a row


def parts(html):
    """What a report says outside its style and its curves: heading -> text."""
    text = re.sub(r"<(style|svg)\b.*?</\1>", " ", html, flags=re.DOTALL)
    sections = re.split(r"<h2[^>]*>([^<]*)</h2>", text)
    return {"": sections[0], **dict(zip(sections[1::2], sections[2::2]))}


def numbers(html):
    return re.findall(r"-?\d+(?:\.\d+)?", re.sub(r"<[^>]*>", " ", html))


def gains(html):
    return {tuple(re.findall(r"<td>([^<]*)</td>", row)[:2]) for row in html.split("<tr>")[2:]}


class Golden(fyd.Case):
    def each(self, check):
        """Calls check(folder, name, file) with a copy of each recording that may be worked on, whole."""
        for kind in KINDS:
            folder = GOLDEN / kind
            for file in sorted([*folder.glob("*.h5"), *folder.glob("*.h5.partial")]):
                name = file.name.removesuffix(".partial").removesuffix(".h5")
                with self.subTest(recording=f"{kind}/{name}"):
                    copy = self.path(f"{kind}-{file.name}")
                    shutil.copy(file, copy)
                    if copy.endswith(".partial"):
                        self.assertEqual(self.json("session", "recover", copy, "--json")["result"], "whole")
                        copy = copy.removesuffix(".partial")
                    check(folder, name, copy)

    def test_they_are_those_that_were_made(self):
        for kind in KINDS:
            lines = (GOLDEN / kind / "SHA256SUMS").read_text().splitlines()
            self.assertEqual({line.split()[1] for line in lines} | {"SHA256SUMS"}, set(os.listdir(GOLDEN / kind)))
            for line in lines:
                expected, name = line.split()
                self.assertEqual(hashlib.sha256((GOLDEN / kind / name).read_bytes()).hexdigest(), expected, name)

    def test_written_anew_by_todays_program_they_lack_what_they_lacked_and_replay_as_before(self):
        def check(folder, name, file):
            said = [self.json("session", "info", file, "--json")["lacking_columns"], self.replayed(file)]
            os.truncate(file, os.path.getsize(file) - 1000)  # of the file's last index: no row
            self.assertEqual(self.json("session", "recover", file, "--json")["result"], "whole")
            self.assertTrue(os.path.exists(file + ".damaged"))
            self.assertEqual([self.json("session", "info", file, "--json")["lacking_columns"], self.replayed(file)], said)
            self.assertTrue(said[0])
        self.each(check)

    def replayed(self, file):
        said = self.json("session", "replay", file, "--json")
        del said["speed_x"]
        return said

    def test_they_open_and_are_whole(self):
        def check(folder, name, file):
            info = self.json("session", "info", file, "--json")
            self.assertGreater(info["committed_samples"], 1000)
            self.assertTrue(self.json("session", "verify", file, "--json")["intact"])

        self.each(check)

    def test_they_export_the_same_values(self):
        def check(folder, name, file):
            self.json("session", "export", file, self.path("out.csv"), "--force", "--json")
            with lzma.open(folder / f"{name}.csv.xz", "rt", newline="") as old, open(self.path("out.csv"), newline="") as new:
                old_rows, new_rows = list(csv.DictReader(old)), list(csv.DictReader(new))
            self.assertEqual(len(new_rows), len(old_rows))
            for before, after in zip(old_rows, new_rows):
                self.assertEqual({column: after[column] for column in before}, before)
            self.assertEqual(pathlib.Path(self.path("out.events.csv")).read_text(),
                             (folder / f"{name}.events.csv").read_text())

        self.each(check)

    def test_their_reports_say_the_same_figures(self):
        def check(folder, name, file):
            out = self.path(f"{folder.name}-{name}.html")
            self.json("session", "report", file, out, "--json")
            now, then = (parts(pathlib.Path(file).read_text()) for file in (out, folder / f"{name}.html"))
            self.assertEqual(list(now), list(then))
            self.assertGreater(len(gains(then[GAINS])), 3)
            self.assertLessEqual(gains(then[GAINS]), gains(now[GAINS]))
            for heading in then:
                if heading != GAINS:
                    self.assertEqual(numbers(now[heading]), numbers(then[heading]), heading)

        self.each(check)

    def test_they_replay(self):
        def check(folder, name, file):
            result = self.json("session", "replay", file, "--json")
            self.assertEqual((result["samples"], result["gaps"]), (result["of"], 0))
            self.assertEqual(KINDS[folder.name], result["arithmetic_recorded"])
            if KINDS[folder.name] == result["arithmetic_replayed"]:
                self.assertTrue(result["identical"], result)
            else:
                self.assertEqual(result["tolerance"]["beyond"], 0, result)
                self.assertLess(result["max_abs_difference"], 1e-12)

        self.each(check)

    def test_one_commands_vibration(self):
        with lzma.open(GOLDEN / "vibration" / "vibration.csv.xz", "rt", newline="") as file:
            duties = [row["vibration_duty_percent [%]"] for row in csv.DictReader(file)]
        self.assertGreater(sum(float(duty or 0) > 1 for duty in duties), 300)

    def test_their_profiles_load(self):
        def check(folder, name, file):
            if (folder / f"{name}.toml").exists():
                done = fyd.run("params", "--profile", folder / f"{name}.toml")
                self.assertEqual(done.returncode, 0, done.stderr)

        self.each(check)


if __name__ == "__main__":
    unittest.main()
