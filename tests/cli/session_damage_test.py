"""Bits turned in a closed recording: info, verify, replay, export and recover say the same of the same file."""
import csv
import json
import os
import random
import shutil
import subprocess
import unittest

import fyd

PLACES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "hdf5_places.py")
SYSTEM_PYTHON = "/usr/bin/python3"  # Debian's own, which has Debian's h5py
COMMIT_ROWS = 40  # where a commit's counts of rows begin


def places(file, *table):
    return json.loads(subprocess.run([SYSTEM_PYTHON, PLACES, file, *table], capture_output=True, check=True).stdout)


def turn_bit(file, byte, bit):
    with open(file, "r+b") as disk:
        disk.seek(byte)
        was = disk.read(1)[0]
        disk.seek(byte)
        disk.write(bytes([was ^ 1 << bit]))


class Damage(fyd.Case):
    @classmethod
    def setUpClass(cls):
        cls.kept = fyd.tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.kept.cleanup)
        cls.good = os.path.join(cls.kept.name, "session.h5")
        done = fyd.run("station", "--simulate", "--duration", 4, "--record", cls.good, "--json")
        assert done.returncode == 0, done.stderr
        cls.samples = json.loads(done.stdout)["recording"]["samples"]
        cls.commits = places(cls.good, "commits")

    def setUp(self):
        super().setUp()
        self.file = shutil.copy(self.good, self.path("session.h5"))

    def said(self, command, code):
        done = fyd.run("session", command, self.file, "--json")
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return json.loads(done.stdout)

    def test_turned_bits_in_the_last_commits_are_told_and_cost_nothing(self):
        dice = random.Random(5)
        for row in self.commits["rows"][-2:]:
            turn_bit(self.file, row + COMMIT_ROWS + dice.randrange(100), dice.randrange(8))
        info = self.said("info", 0)
        self.assertEqual((info["wholeness"], info["health"]), ("damaged", "damaged"))
        self.assertIn("session recover", info["health_reason"])
        verified = self.said("verify", 1)
        self.assertFalse(verified["intact"])
        self.assertEqual((verified["wholeness"], verified["damaged_commits"]), ("damaged", 2))
        self.assertEqual(self.said("replay", 0)["samples"], self.samples)  # both rows can be mended: nothing is missing
        self.assertEqual(self.said("recover", 0)["samples"], self.samples)
        self.assertTrue(self.said("verify", 0)["intact"])
        self.assertEqual(self.said("info", 0)["health"], "good")
        self.assertTrue(self.said("replay", 0)["identical"])

    def test_rows_that_no_commit_proves_are_missing_from_no_export_without_a_word(self):
        with open(self.file, "r+b") as disk:
            for row in self.commits["rows"][-2:]:  # the very last may hold no step
                disk.seek(row)
                disk.write(bytes(self.commits["row_bytes"]))
        info = self.said("info", 0)
        self.assertEqual(info["samples"], self.samples)
        behind = self.samples - info["committed_samples"]
        self.assertGreaterEqual(behind, 250)
        self.assertEqual(info["health"], "damaged")
        self.assertFalse(self.said("verify", 1)["intact"])
        replay = self.said("replay", 1)
        self.assertFalse(replay["identical"])
        self.assertEqual(replay["of"], self.samples)
        self.assertIn("no sound commit", replay["why_not_exact"])
        self.assertIn("recover", self.refused(1, "session", "export", self.file, self.path("all.csv")))
        self.assertFalse(os.path.exists(self.path("all.csv")))
        recovered = self.said("recover", 3)
        self.assertEqual((recovered["samples"], recovered["lost_samples"]), (self.samples - behind, behind))
        self.assertTrue(self.said("verify", 0)["intact"])
        info = self.said("info", 0)
        self.assertEqual((info["gaps"], info["health"]), (behind, "gaps"))
        replay = self.said("replay", 1)  # what is left comes out the same, and is not the session
        self.assertEqual([replay[key] for key in ("identical", "different", "samples", "of")],
                         [False, 0, self.samples - behind, self.samples])
        self.assertIn({"table": "/telemetry", "first": self.samples - behind, "count": behind},
                      [{key: rows[key] for key in ("table", "first", "count")} for rows in info["missing"]])
        exported = self.json("session", "export", self.file, self.path("left.csv"), "--json")
        self.assertEqual((exported["health"], exported["health_reason"]), (info["health"], info["health_reason"]))
        with open(self.path("left.csv"), encoding="utf-8") as file:
            self.assertEqual(sum(1 for _ in csv.DictReader(file)), self.samples - behind)

    def test_a_table_that_cannot_be_opened_costs_no_step_and_no_other_table(self):
        headers = places(self.file)
        self.assertGreater(len(headers), 15)
        needed = {"telemetry", "commits"}  # without these nothing is proven
        tried = 0
        for table, byte in headers.items():
            with self.subTest(table=table):
                shutil.copy(self.good, self.file)
                turn_bit(self.file, byte + 12, 2)  # HDF5 proves the header of a table by a checksum, and opens it no more
                self.assertEqual(fyd.run("session", "verify", self.file).returncode, 1)
                if table in needed:
                    self.assertEqual(fyd.run("session", "recover", self.file).returncode, 1)
                    continue
                if fyd.run("session", "info", self.file).returncode == 0:
                    continue
                tried += 1
                remade = table.startswith("overview/")  # what is shown from far away
                done = fyd.run("session", "recover", self.file, "--json")
                self.assertIn(done.returncode, (0,) if remade else (0, 3), done.stdout + done.stderr)
                said = json.loads(done.stdout)
                self.assertEqual((said["samples"], said["lost_samples"]), (self.samples, 0))
                self.assertTrue(self.said("verify", 0)["intact"])
                missing = {rows["table"] for rows in self.said("info", 0)["missing"]}
                told = {"camera/bytes": "camera/index", "notes/text": "notes/index"}.get(table, table)  # by the rows they are of
                self.assertLessEqual(missing, {"/" + told, "/header"}, table)
                if remade:
                    self.assertEqual(missing, set())
                    self.assertTrue(self.said("replay", 0)["identical"])
                os.remove(self.file + ".damaged")
        self.assertGreater(tried, 12)

    def test_a_turned_bit_in_a_table_of_one_row_costs_no_step(self):
        rows = places(self.file, "inputs/motor_reference")["rows"]
        self.assertEqual(len(rows), 1)
        turn_bit(self.file, rows[0] + 9, 2)
        self.assertFalse(self.said("verify", 1)["intact"])
        for name in (self.file, self.file + ".partial"):
            if name != self.file:
                shutil.move(self.file, name)  # found by the other name, too
            said = self.refused(1, "session", "replay", self.file)
            self.assertEqual(said.count(self.file), 1, said)
            self.assertIn(f"{name}: /inputs/motor_reference: rows 0 to 1 are damaged", said)
        shutil.move(self.file + ".partial", self.file)
        recovered = self.said("recover", 3)
        self.assertEqual((recovered["samples"], recovered["lost_samples"]), (self.samples, 0))
        info = self.said("info", 0)
        self.assertEqual([(rows["table"], rows["count"]) for rows in info["missing"]],
                         [("/inputs/motor_reference", self.samples)])
        self.assertEqual(info["health"], "gaps")
        self.assertIn("/inputs/motor_reference", info["why_no_exact_replay"])
        self.assertTrue(self.said("verify", 0)["intact"])
        replay = self.said("replay", 1)
        self.assertFalse(replay["identical"])
        self.assertIn("/inputs/motor_reference is lost", replay["why_not_exact"])
        self.assertEqual(replay["samples"], self.samples)

    def test_a_copy_that_broke_off_is_told_and_what_was_copied_is_saved(self):
        whole = os.path.getsize(self.file)
        os.truncate(self.file, 1 + whole * 6 // 10)
        missing = whole - os.path.getsize(self.file)
        info = self.said("info", 0)
        self.assertEqual((info["wholeness"], info["health"]), ("damaged", "damaged"))
        self.assertIn(f"cut short: its last {missing} of {whole} bytes are missing", info["health_reason"])
        verified = self.said("verify", 1)
        self.assertEqual((verified["intact"], verified["missing_bytes"]), (False, missing))
        recovered = self.said("recover", 3)
        self.assertEqual(recovered["samples"] + recovered["lost_samples"], self.samples)
        self.assertGreater(recovered["samples"], self.samples // 4)
        self.assertEqual(os.path.getsize(self.file + ".damaged"), whole - missing)
        self.assertTrue(self.said("verify", 0)["intact"])
        self.assertEqual(self.said("info", 0)["health"], "gaps")
        columns = []
        for number, name in enumerate((self.good, self.file)):
            made = fyd.run("session", "export", name, self.path(f"{number}.csv"), "--fields", "step,force_N")
            self.assertEqual(made.returncode, 0, made.stderr)
            with open(self.path(f"{number}.csv"), newline="") as rows:
                columns.append(list(csv.reader(rows)))
        self.assertEqual(len(columns[1]), 1 + recovered["samples"])
        self.assertEqual(columns[0][:len(columns[1])], columns[1])


if __name__ == "__main__":
    unittest.main()
