"""An input costs an old recording nothing: a program with three more in the middle replays the golden recordings, and
this one replays that program's."""
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

FYD = os.environ["FYD"]
LATER = os.environ["LATER_PROGRAM"]
GOLDEN = pathlib.Path(os.environ["FYD_SOURCE_DIR"]) / "tests" / "data" / "recordings"
ADDED_SINCE = {"area_mm2", "stiffness_place_factor", "vibration_rms_percent", "vibration_dead_share", "vibration_clipped_share",
               "felt_acceleration_g", "felt_level_dB", "felt_out_of_reach",
               "robot_stiffness_N_per_mm", "robot_force_N", "finger_energy_mJ", "coupling_withheld_mJ", "force_N"}  # by this program, since the oldest was recorded
COLUMNS = ["/camera/index inserted_mm2", "/inputs/finger inserted_mm2", "/inputs/steps inserted_K", "/inputs/steps inserted_row"]


def run(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, (command, done.stderr)
    return json.loads(done.stdout) if done.stdout else None


class LaterInputs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def golden(self, kind, pattern="*.h5"):
        found = sorted((GOLDEN / kind).glob(pattern))
        self.assertTrue(found)
        return [shutil.copy(file, self.folder / f"{kind}-{file.name}") for file in found]

    def test_a_later_program_replays_the_golden_recordings(self):
        for kind in ("arithmetic_1", "arithmetic_2"):
            for file in self.golden(kind):
                with self.subTest(recording=file.name):
                    seen = run(LATER, "replay", file)
                    self.assertTrue(seen["intact"])
                    self.assertEqual(seen["identical"] or kind == "arithmetic_1", True, seen)
                    self.assertEqual(seen["beyond_tolerance"], 0)
                    lacking = sorted(seen["lacking"])
                    self.assertEqual([name for name in lacking if "inserted" in name], sorted(["/inputs/inserted", *COLUMNS]))
                    others = {name.split()[-1].removesuffix("_min").removesuffix("_max")
                              for name in lacking if "inserted" not in name}
                    self.assertEqual(others, ADDED_SINCE)
                    self.assertEqual((seen["values"], seen["count"]), ([2.5, 4.5, 3.5], 0))

    def test_this_program_replays_what_a_later_one_recorded_and_makes_it_whole(self):
        for file in self.golden("arithmetic_2"):
            with self.subTest(recording=file.name):
                out = self.folder / f"later-{file.name}"
                run(LATER, "copy", file, out)
                self.assertEqual(run(FYD, "session", "recover", out, "--json")["result"], "whole")
                self.assertTrue(run(FYD, "session", "verify", out, "--json")["intact"])
                self.assertTrue(run(FYD, "session", "replay", out, "--json")["identical"])
                self.assertEqual(sorted(run(FYD, "session", "info", out, "--json")["unknown_columns"]),
                                 COLUMNS)
                seen = run(LATER, "replay", out)  # what this program added to the file took nothing from it
                self.assertEqual((seen["intact"], seen["identical"], seen["lacking"]), (True, True, []))
                self.assertEqual((seen["values"], seen["count"]), ([100.5, 200.5, 300.5], 1))


if __name__ == "__main__":
    unittest.main()
