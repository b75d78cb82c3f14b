"""What a newcomer sees of installer/common.sh while packages are installed and the program is built."""
import os
import pathlib
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["FYD_SOURCE_DIR"])

PROJECT = """cmake_minimum_required(VERSION 3.25)
project(small LANGUAGES CXX)
add_library(small one.cpp two.cpp three.cpp)
target_compile_options(small PRIVATE -Wall)
"""
PRESETS = """{"version": 6,
 "configurePresets": [{"name": "release", "generator": "Ninja", "binaryDir": "${sourceDir}/build"}],
 "buildPresets": [{"name": "release", "configurePreset": "release"}]}
"""


class Installer(unittest.TestCase):
    def bash(self, commands, **options):
        script = f"set -euo pipefail; source {SOURCE}/installer/common.sh; {commands}"
        return subprocess.run(["bash", "-c", script], capture_output=True, text=True, timeout=120, **options)

    def project(self, folder, two="int two() { return 2; }"):
        files = {"CMakeLists.txt": PROJECT, "CMakePresets.json": PRESETS, "one.cpp": "int one() { return 1; }",
                 "two.cpp": two, "three.cpp": "int three() { return 3; }"}
        for name, text in files.items():
            (pathlib.Path(folder) / name).write_text(text + "\n")

    def test_a_build_shows_how_far_it_is_and_about_how_long_it_takes(self):
        with tempfile.TemporaryDirectory() as folder:
            self.project(folder)
            done = self.bash(f"root={folder}; build release")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertRegex(done.stdout, r"\[ 1/4 \] about \d+ (s|min) left")
            again = self.bash(f"root={folder}; build release")
            self.assertEqual(again.stdout, "== Building preset release\n")

    def test_a_terminal_sees_every_step(self):
        with tempfile.TemporaryDirectory() as folder:
            self.project(folder)
            done = subprocess.run(["script", "--quiet", "--return", "--command",
                                   f"bash -c 'set -euo pipefail; source {SOURCE}/installer/common.sh; root={folder}; build release'",
                                   "/dev/null"], capture_output=True, text=True, timeout=120)
            self.assertEqual(done.returncode, 0, done.stdout)
            for step in range(1, 5):
                self.assertIn(f"[ {step}/4 ]", done.stdout)

    def test_a_warning_is_passed_on(self):
        with tempfile.TemporaryDirectory() as folder:
            self.project(folder, two="int two() { int unused = 0; return 2; }")
            done = self.bash(f"root={folder}; build release")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("unused variable", done.stdout)

    def test_an_error_ends_the_script_and_is_shown(self):
        with tempfile.TemporaryDirectory() as folder:
            self.project(folder, two="int two() { return missing; }")
            done = self.bash(f"root={folder}; build release; echo not reached")
            self.assertNotEqual(done.returncode, 0)
            self.assertIn("missing", done.stdout)
            self.assertNotIn("not reached", done.stdout)

    def test_the_time_left_follows_from_the_steps_already_made(self):
        lines = "".join(f"[ {step}/400 ] Building {step}.cpp\n" for step in (1, 200))
        # An unset SECONDS is a variable like any other: no time passes.
        done = self.bash("unset SECONDS; SECONDS=0; nproc() { echo 2; }; show_building", input=lines)
        # 20 steps of 2.6 s on 2 processors are 26 s, assumed until known: 26 s · 399 / 21
        self.assertEqual(done.stdout, "[ 1/400 ] about 8 min left\n")

    def test_packages_show_what_is_fetched_and_installed(self):
        status = "dlstatus:1:12.5:Retrieving file 1 of 3\nnoise\npmerror:/x.deb:0:is damaged\n"
        done = self.bash("show_installing", input=status)
        self.assertEqual(done.stdout, "[ 12 % ] Retrieving file 1 of 3\n/x.deb: 0:is damaged\n".replace("0:", ""))

    def test_a_preset_says_what_is_built_whatever_was_left_out_before(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.25)\nproject(small NONE)\n"
                                                                 "option(FYD_BUILD_TESTS \"\" ON)\noption(FYD_BUILD_BENCHMARKS \"\" ON)\n")
            (pathlib.Path(folder) / "CMakePresets.json").write_text((SOURCE / "CMakePresets.json").read_text())
            for preset, words, tests, benchmarks in (
                    ("release", ["-DFYD_BUILD_TESTS=OFF", "-DFYD_BUILD_BENCHMARKS=OFF"], "OFF", "OFF"),
                    ("release", [], "ON", "ON"), ("package", [], "OFF", "OFF"), ("branches", [], "ON", "OFF")):
                done = subprocess.run(["cmake", "--preset", preset, *words], cwd=folder, capture_output=True, text=True, timeout=120)
                self.assertEqual(done.returncode, 0, done.stderr)
                cache = (pathlib.Path(folder) / "build" / preset / "CMakeCache.txt").read_text()
                self.assertIn(f"FYD_BUILD_TESTS:BOOL={tests}\n", cache)
                self.assertIn(f"FYD_BUILD_BENCHMARKS:BOOL={benchmarks}\n", cache)


if __name__ == "__main__":
    unittest.main()
