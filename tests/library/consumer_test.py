#!/usr/bin/env python3
"""Builds tests/consumer against the installed library, through CMake and one of its programs through pkg-config too, and
runs it: PREFIX=… LIBDIR=… CXX=… CMAKE=… consumer_test.py SOURCES BUILD RECORDING.

What the replay read of the recording is compared with what h5py reads.
"""
import os
import pathlib
import shlex
import shutil
import subprocess
import sys
import unittest

import h5py
import numpy

SOURCES, BUILD, RECORDING = (pathlib.Path(argument) for argument in sys.argv[-3:])
PREFIX = pathlib.Path(os.environ["PREFIX"])
LIBRARY = PREFIX / os.environ["LIBDIR"]


def run(*command, **more):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, **more)
    if done.returncode != 0:
        raise AssertionError(f"{command}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


class Consumer(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(BUILD, ignore_errors=True)
        run(os.environ["CMAKE"], "-G", "Ninja", "-S", SOURCES, "-B", BUILD, f"-DCMAKE_PREFIX_PATH={PREFIX}",
            f"-DCMAKE_CXX_COMPILER={os.environ['CXX']}", "-DCMAKE_BUILD_TYPE=Debug")
        run(os.environ["CMAKE"], "--build", BUILD, "-j2")

    def test_a_texture(self):
        run(BUILD / "texture")

    def test_a_stiffness_loop(self):
        run(BUILD / "stiffness")

    def test_a_prediction(self):
        run(BUILD / "prediction")

    def test_a_contact(self):
        run(BUILD / "contact")

    def test_a_replay(self):
        rows, force_N = run(BUILD / "replay", RECORDING).split()
        with h5py.File(RECORDING) as file:
            column = file["telemetry"]["force_N"]
        self.assertEqual(int(rows), len(column))
        self.assertGreater(float(force_N), 0.0)
        self.assertAlmostEqual(float(force_N), float(numpy.nansum(column)), delta=1e-9 * float(force_N))

    def test_through_pkg_config(self):
        environment = os.environ | {"PKG_CONFIG_PATH": str(LIBRARY / "pkgconfig")}
        flags = shlex.split(run("pkg-config", "--cflags", "--libs", "fyd", env=environment))
        strict = ["-Wall", "-Wextra", "-Werror"]
        run(os.environ["CXX"], SOURCES / "texture.cpp", "-o", BUILD / "texture_pkg_config", *strict, *flags)
        run(BUILD / "texture_pkg_config", env=os.environ | {"LD_LIBRARY_PATH": str(LIBRARY)})
        run(os.environ["CXX"], "-fsyntax-only", SOURCES / "replay.cpp", *strict, *flags)  # it has OpenCV's headers

    def test_a_caller_for_this_very_processor_copies_a_soft_body(self):
        """What a class holds must not be aligned otherwise there: the copy is compiled into the caller."""
        environment = os.environ | {"PKG_CONFIG_PATH": str(LIBRARY / "pkgconfig")}
        flags = shlex.split(run("pkg-config", "--cflags", "--libs", "fyd", env=environment))
        run(os.environ["CXX"], "-O2", "-march=native", SOURCES / "soft.cpp", "-o", BUILD / "soft_native", *flags)
        run(BUILD / "soft_native", env=os.environ | {"LD_LIBRARY_PATH": str(LIBRARY)})

    def test_another_minor_version_is_refused(self):
        folder = BUILD / "other"
        folder.mkdir()
        (folder / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.25)\nproject(other LANGUAGES CXX)\n"
                                               "find_package(Fyd 0.9 REQUIRED)\n")
        with self.assertRaisesRegex(AssertionError, "Could not find a configuration file"):
            run(os.environ["CMAKE"], "-S", folder, "-B", folder / "build", f"-DCMAKE_PREFIX_PATH={PREFIX}")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
