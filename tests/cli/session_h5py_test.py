"""A recording is an HDF5 file like any other: Debian's h5py opens it as it is and finds names and units."""
import json
import os
import subprocess
import unittest

import fyd

FOLDER = os.path.dirname(os.path.abspath(__file__))
PEER = os.path.join(FOLDER, "h5py_peer.py")
LISTING = os.path.join(FOLDER, "h5py_listing.py")
SYSTEM_PYTHON = "/usr/bin/python3"  # Debian's own, which has Debian's h5py


def look(*arguments):
    peer = subprocess.run([SYSTEM_PYTHON, PEER, *arguments], capture_output=True, text=True, check=False, timeout=fyd.PATIENCE)
    assert peer.returncode == 0, peer.stderr
    return json.loads(peer.stdout)


class OpenedByH5py(fyd.Case):
    @classmethod
    def setUpClass(cls):
        cls.kept = fyd.tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.kept.cleanup)
        cls.file = os.path.join(cls.kept.name, "session.h5")
        done = fyd.run("station", "--simulate", "--duration", 3, "--record", cls.file,
                       "--operator", "Zoë", "--json")
        assert done.returncode == 0, done.stderr
        cls.samples = json.loads(done.stdout)["recording"]["samples"]
        cls.seen = look(cls.file)

    def test_telemetry_has_a_row_for_each_step(self):
        self.assertEqual(self.seen["rows"], self.samples)
        self.assertEqual(self.seen["steps_in_order"], True)

    def test_its_tables_columns_and_attributes_are_those_of_the_format(self):
        """Other people's programs read them by these names, types and offsets."""
        listing = subprocess.run([SYSTEM_PYTHON, LISTING, self.file], capture_output=True, text=True, check=True).stdout
        with open(os.path.join(fyd.DATA, "recordings", "layout.txt"), encoding="utf-8") as kept:
            self.assertEqual(listing.splitlines(), kept.read().splitlines(),
                             "after a new input: h5py_listing.py FILE, and put it into layout.txt; no name and no type may go")

    def test_every_column_has_its_unit(self):
        self.assertEqual(self.seen["units"]["force_N"], "N")
        self.assertEqual(self.seen["units"]["indentation_mm"], "mm")
        self.assertEqual(self.seen["units"]["now_ns"], "ns")
        self.assertEqual(self.seen["units"]["stretch_reference_deg"], "°")

    def test_the_header_is_text(self):
        self.assertEqual(self.seen["operator"], "Zoë")
        self.assertIn("[control]", self.seen["profile"])

    def test_the_last_commit_closes_and_counts_all_rows(self):
        self.assertEqual(self.seen["closed"], 1)
        self.assertEqual(self.seen["committed_rows"], self.samples)

    def test_the_overview_has_the_extremes_of_its_rows(self):
        self.assertTrue(self.seen["overview_true"])


class OpenedByH5pyBeforeItIsWhole(fyd.Case):
    def test_while_it_grows_and_after_its_recorder_was_killed(self):
        path = self.path("growing.h5")
        recorder = fyd.Running(self, "station", "--simulate", "--record", path, "--operator", "Ada")

        def grown():
            info = fyd.run("session", "info", path, "--json")
            return info.returncode == 0 and json.loads(info.stdout)["committed_samples"] >= 500
        fyd.wait_for("500 committed samples", grown)
        first, second = look("--growing", path + ".partial")
        self.assertGreaterEqual(first["rows"], 500)
        self.assertGreater(second["rows"], first["rows"])
        self.assertTrue(second["steps_in_order"])
        recorder.process.kill()
        recorder.process.wait()
        left, again = look("--shared", path + ".partial")
        self.assertGreaterEqual(left["rows"], second["rows"])
        self.assertEqual(again, left)
        self.assertTrue(left["steps_in_order"])
        # As h5py itself sees it, recovery takes the writer's mark away.
        self.assertEqual(self.json("session", "recover", path, "--json")["result"], "whole")
        self.assertGreaterEqual(look(path)["committed_rows"], left["rows"])


if __name__ == "__main__":
    unittest.main()
