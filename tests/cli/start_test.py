"""What a start of `fyd` loads, and what it says when the coders of pictures and videos are not installed."""
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

FYD = os.environ["FYD"]


def needed(path):
    """The shared libraries that the loader maps for a program or library, by ldd."""
    return subprocess.run(["ldd", path], check=True, capture_output=True, text=True).stdout


class Start(unittest.TestCase):
    def test_a_start_does_not_load_the_coders(self):
        for heavy in ("libopencv_imgcodecs", "libopencv_videoio", "libgdal", "libavcodec", "libgstreamer"):
            self.assertNotIn(heavy, needed(FYD))

    def test_the_coders_are_those_of_opencv(self):
        coders = list(pathlib.Path(FYD).parents[1].glob("lib/**/fyd/codecs.so"))
        self.assertEqual(len(coders), 1)
        self.assertIn("libopencv_videoio", needed(coders[0]))

    def test_without_coders_a_session_is_refused_and_the_rest_works(self):
        with tempfile.TemporaryDirectory() as folder:
            # A stranger's library stands in the working folder and in the one above the program's.
            coders = next(pathlib.Path(FYD).parents[1].glob("lib/**/fyd/codecs.so"))
            strangers = pathlib.Path(folder) / coders.relative_to(pathlib.Path(FYD).parents[1])
            strangers.parent.mkdir(parents=True)
            shutil.copy(coders, strangers)
            for place in ("elsewhere", "elsewhere/bin"):
                os.makedirs(f"{folder}/{place}", exist_ok=True)
                alone = shutil.copy(FYD, f"{folder}/{place}")
                bare = {"cwd": folder, "capture_output": True, "text": True, "timeout": 60}
                self.assertEqual(subprocess.run([alone, "params", "control.kp"], **bare).returncode, 0)
                refused = subprocess.run([alone, "station", "--simulate", "--robot", "none", "--duration", "1"], **bare)
                self.assertNotEqual(refused.returncode, 0)
                self.assertIn("codecs.so", refused.stderr)
                self.assertIn("cannot be loaded", refused.stderr)


if __name__ == "__main__":
    unittest.main()
