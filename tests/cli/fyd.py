"""Runs the command line for the tests."""
import functools
import json
import os
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["FYD"]
# What programs keep of a user (the catalogue of sessions) stays out of the tester's own folders.
HOME = tempfile.TemporaryDirectory()
os.environ["XDG_DATA_HOME"] = HOME.name
DATA = os.path.join(os.environ["FYD_SOURCE_DIR"], "tests", "data")


def run(*arguments, timeout=120):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=timeout, check=False)


class BusyMachine(AssertionError):
    """The machine stood still so long that the station went to safe by itself: the journey proves nothing."""


def not_held_by_the_machine(session):
    """Raises BusyMachine when a session's result says that missed haptic cycles held it."""
    if "haptic cycles" in session["reason"]:
        raise BusyMachine(session["reason"])


def some_tries(test):
    """Runs a test of a fyd.Case anew, from its setUp on, when it met a busy machine; the fifth time that is a failure."""
    @functools.wraps(test)
    def again(self):
        for _ in range(4):
            try:
                return test(self)
            except BusyMachine:
                self.doCleanups()
                self.setUp()
        return test(self)
    return again


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)
        return self.path(name)

    def json(self, *arguments, **keywords):
        done = run(*arguments, **keywords)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def refused(self, code, *arguments):
        """The operation fails with this exit code; returns what it says on standard error."""
        done = run(*arguments)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertNotEqual(done.stderr, "")
        return done.stderr
