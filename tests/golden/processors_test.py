"""The golden recordings of today's arithmetic replay bit for bit on processors with and without fused multiply-add.

Run by the emulator qemu-x86_64. A program that calls the C library's exp, log, sin, … in the step fails this on Nehalem:
revision a4d2b6a computed 888 of 1225 steps of its recording `frame512` otherwise there.
"""
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

GOLDEN = pathlib.Path(os.environ["FYD_SOURCE_DIR"]) / "tests" / "data" / "recordings"
PROCESSORS = ("Nehalem", "Haswell")  # the second has fused multiply-add and AVX2


class Processors(unittest.TestCase):
    def test_each_recording_replays_bit_for_bit(self):
        recordings = sorted(file for kind in ("arithmetic_2", "vibration") for file in (GOLDEN / kind).glob("*.h5"))
        self.assertGreaterEqual(len(recordings), 9)
        with tempfile.TemporaryDirectory() as folder:
            for recording in recordings:
                copy = shutil.copy(recording, folder)
                for processor in PROCESSORS:
                    with self.subTest(recording=recording.name, processor=processor):
                        done = subprocess.run(["qemu-x86_64", "-cpu", processor, os.environ["FYD"], "session", "replay", copy,
                                               "--json"], capture_output=True, text=True, timeout=300, check=False)
                        self.assertEqual(done.returncode, 0, done.stderr)
                        self.assertTrue(json.loads(done.stdout)["identical"], done.stdout)


if __name__ == "__main__":
    unittest.main()
