"""What a newcomer sees of installer/common.sh while packages are installed and the program is built."""
import os
import pathlib
import re
import shlex
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
    def setUp(self):
        self.folder = self.enterContext(tempfile.TemporaryDirectory(suffix=" of a newcomer"))  # a path may have spaces

    def script(self, commands):
        """A bash that knows common.sh and runs the commands, for the project in self.folder."""
        common, root = shlex.quote(f"{SOURCE}/installer/common.sh"), shlex.quote(self.folder)
        return ["bash", "-c", f"set -euo pipefail; source {common}; root={root}; {commands}"]

    def bash(self, commands, **options):
        return subprocess.run(self.script(commands), capture_output=True, text=True, timeout=120, **options)

    def project(self, two="int two() { return 2; }"):
        files = {"CMakeLists.txt": PROJECT, "CMakePresets.json": PRESETS, "one.cpp": "int one() { return 1; }",
                 "two.cpp": two, "three.cpp": "int three() { return 3; }"}
        for name, text in files.items():
            (pathlib.Path(self.folder) / name).write_text(text + "\n")

    def test_a_build_shows_how_far_it_is_and_about_how_long_it_takes(self):
        self.project()
        done = self.bash("build release")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"\[ 1/4 \] about \d+ (s|min) left")
        again = self.bash("build release")
        self.assertEqual(again.stdout, "== Building preset release\n")

    def test_a_terminal_sees_every_step(self):
        self.project()
        done = subprocess.run(["script", "--quiet", "--return", "--command", shlex.join(self.script("build release")), "/dev/null"],
                              capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stdout)
        for step in range(1, 5):
            self.assertIn(f"[ {step}/4 ]", done.stdout)

    def test_a_warning_is_passed_on(self):
        self.project(two="int two() { int unused = 0; return 2; }")
        done = self.bash("build release")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("unused variable", done.stdout)

    def test_an_error_ends_the_script_and_is_shown(self):
        self.project(two="int two() { return missing; }")
        done = self.bash("build release; echo not reached")
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

    @staticmethod
    def architectures():
        """This machine's and another one."""
        own = subprocess.run(["dpkg", "--print-architecture"], capture_output=True, text=True, check=True).stdout.strip()
        return own, "i386" if own != "i386" else "amd64"

    def missing(self, *statuses):
        """What install_packages would install, of packages that dpkg's list has so. A status: (name, architecture, words)"""
        folder = pathlib.Path(self.folder)
        (folder / "installer").mkdir()
        (folder / "installer/packages.txt").write_text("# a comment\nrun one\nrun two\nrun three\ntest four\n")
        admin = folder / "dpkg"
        (admin / "updates").mkdir(parents=True)
        (admin / "info").mkdir()
        (admin / "info/format").write_text("1\n")
        (admin / "arch").write_text("\n".join(self.architectures()) + "\n")
        (admin / "status").write_text("".join(
            f"Package: {name}\nStatus: {words}\nArchitecture: {architecture}\n"
            f"Multi-Arch: {'foreign' if architecture == 'all' else 'same'}\nMaintainer: a <a@example.org>\nVersion: 1\n"
            "Description: one\n\n" for name, architecture, words in statuses))
        # Neither root nor sudo: it says what is missing, and installs nothing.
        done = self.bash("id() { echo 1; }; command() { return 1; }; install_packages run",
                         env=os.environ | {"DPKG_ADMINDIR": str(admin)})
        if done.returncode == 0:
            return []
        return re.fullmatch(r"These packages are missing .*: (.*)\n", done.stderr)[1].split()

    def test_missing_is_what_is_not_installed_for_this_machine(self):
        (own, other), installed = self.architectures(), "install ok installed"
        self.assertEqual(self.missing(("one", other, installed), ("two", own, "deinstall ok config-files"),
                                      ("four", own, installed)), ["one", "two", "three"])

    def test_held_packages_and_those_of_two_architectures_are_installed(self):
        (own, other), installed = self.architectures(), "install ok installed"
        self.assertEqual(self.missing(("one", own, "hold ok installed"), ("two", own, installed), ("two", other, installed),
                                      ("three", "all", installed)), [])

    def test_a_script_of_a_package_can_write_as_it_is_installed(self):
        """The real apt-get and dpkg, on a list of packages, a root and a repository of their own."""
        place = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))  # apt's configuration wants a path without spaces
        for path in ("debs", "root", "dpkg/updates", "dpkg/info", "apt/lists/partial", "apt/cache/archives/partial", "apt/etc/conf.d",
                     "apt/etc/preferences.d", "apt/log", "bin"):
            (place / path).mkdir(parents=True)
        package = pathlib.Path(self.folder) / "talks"
        (package / "DEBIAN").mkdir(parents=True)
        (package / "DEBIAN/control").write_text("Package: talks\nVersion: 1\nArchitecture: all\nMaintainer: a <a@example.org>\n"
                                                "Description: says something as it is installed\n")
        script = package / "DEBIAN/postinst"
        script.write_text(f"#!/bin/sh\nset -e\necho something\necho \"$1\" >{place}/installed\n")
        script.chmod(0o755)
        subprocess.run(["dpkg-deb", "--root-owner-group", "-b", package, place / "debs"], check=True, capture_output=True)
        listing = subprocess.run(["dpkg-scanpackages", "-m", "."], cwd=place / "debs", check=True, capture_output=True, text=True).stdout
        (place / "debs/Packages").write_text(listing)
        (place / "dpkg/status").write_text("")
        (place / "apt/etc/sources.list").write_text(f"deb [trusted=yes] file:{place}/debs ./\n")
        (place / "apt.conf").write_text(
            f'Dir::Etc "{place}/apt/etc"; Dir::Etc::parts "{place}/apt/etc/conf.d"; Dir::State "{place}/apt"; Dir::Log "{place}/apt/log";\n'
            f'Dir::Cache "{place}/apt/cache"; Dir::State::status "{place}/dpkg/status"; APT::Sandbox::User "";\n'
            f'DPkg::Options {{ "--instdir={place}/root"; "--admindir={place}/dpkg"; "--log={place}/dpkg/log"; "--force-not-root";\n'
            '  "--force-script-chrootless"; "--force-bad-path"; };\n')
        # As the real one does, this sudo closes all descriptors above 2.
        sudo = place / "bin/sudo"
        sudo.write_text("#!/bin/bash\nfor fd in {3..9}; do eval \"exec $fd>&-\"; done\nexec \"$@\"\n")
        sudo.chmod(0o755)
        (pathlib.Path(self.folder) / "installer").mkdir()
        (pathlib.Path(self.folder) / "installer/packages.txt").write_text("run talks\n")
        environment = os.environ | {"APT_CONFIG": str(place / "apt.conf"), "DPKG_ADMINDIR": str(place / "dpkg"),
                                    "PATH": f"{place}/bin:{os.environ['PATH']}"}
        for user in (0, 1):
            (place / "dpkg/status").write_text("")
            (place / "installed").unlink(missing_ok=True)
            done = self.bash(f"id() {{ echo {user}; }}; install_packages run", env=environment)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertTrue((place / "installed").is_file(), done.stdout + done.stderr)
            self.assertRegex(done.stdout, r"== Installing 1 packages and what they need: talks\n\[ \d+ % \] \S+")
            self.assertNotIn("something", done.stdout)

    def test_a_header_of_another_comment_is_compiled_anew(self):
        """What the compiler cache is told (FydFlags.cmake), with the cache itself and a precompiled header."""
        cache = {name: value for name, value in re.findall(r"(CCACHE_\w+)=([^;\"\s]+)", (SOURCE / "installer/cmake/FydFlags.cmake").read_text())}
        folder = pathlib.Path(self.folder)
        environment = os.environ | cache | {"CCACHE_DIR": str(folder / "cache")}
        environment.pop("CCACHE_DISABLE", None)
        (folder / "all.h").write_text('#include "own.h"\n')
        command = ["ccache", "g++", "-Winvalid-pch", "-MD", "-MF", "made.d"]
        for comment, value in (("once", 1), ("anew", 2)):  # comments of one length: preprocessed, the headers are the same
            (folder / "own.h").write_text(f"#pragma once\n// {comment}\nstruct Own {{ int a; }};\n")
            (folder / "unit.cpp").write_text(f'#include "own.h"\nOwn made() {{ return {{{value}}}; }}\n')
            for words in (["-x", "c++-header", "-c", "all.h", "-o", "all.h.gch"], ["-include", "all.h", "-c", "unit.cpp", "-o", "unit.o"]):
                done = subprocess.run([*command, *words], cwd=folder, env=environment, capture_output=True, text=True, timeout=120)
                self.assertEqual(done.returncode, 0, done.stderr)
        counts = subprocess.run(["ccache", "--print-stats"], env=environment, check=True, capture_output=True, text=True).stdout
        self.assertRegex(counts, r"(?m)^cache_miss\t4$")  # the cache was asked

    def test_an_exported_CDPATH_changes_nothing(self):
        done = subprocess.run(["bash", "-c", 'source installer/common.sh; printf %s "$root"'], cwd=SOURCE,
                              env=os.environ | {"CDPATH": "."}, capture_output=True, text=True, timeout=120)
        self.assertEqual(pathlib.Path(done.stdout).resolve(), SOURCE.resolve())

    def test_a_preset_says_what_is_built_whatever_was_left_out_before(self):
        (pathlib.Path(self.folder) / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.25)\nproject(small NONE)\n"
                                                                  "option(FYD_BUILD_TESTS \"\" ON)\noption(FYD_BUILD_BENCHMARKS \"\" ON)\n"
                                                                  "set(FYD_BUILD_PYTHON AUTO CACHE STRING \"\")\n")
        (pathlib.Path(self.folder) / "CMakePresets.json").write_text((SOURCE / "CMakePresets.json").read_text())
        left_out = ["-DFYD_BUILD_TESTS=OFF", "-DFYD_BUILD_BENCHMARKS=OFF", "-DFYD_BUILD_PYTHON=OFF"]
        for preset, words, tests, benchmarks, python in (
                ("release", left_out, "OFF", "OFF", "OFF"), ("release", [], "ON", "ON", "AUTO"),
                ("package", [], "OFF", "OFF", "ON"), ("branches", [], "ON", "OFF", "AUTO")):
            done = subprocess.run(["cmake", "--preset", preset, *words], cwd=self.folder, capture_output=True, text=True, timeout=120)
            self.assertEqual(done.returncode, 0, done.stderr)
            cache = (pathlib.Path(self.folder) / "build" / preset / "CMakeCache.txt").read_text()
            self.assertIn(f"FYD_BUILD_TESTS:BOOL={tests}\n", cache)
            self.assertIn(f"FYD_BUILD_BENCHMARKS:BOOL={benchmarks}\n", cache)
            self.assertRegex(cache, rf"(?m)^FYD_BUILD_PYTHON:\w+={python}$")


if __name__ == "__main__":
    unittest.main()
