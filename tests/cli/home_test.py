"""Tests that are started by hand leave nothing in the tester's own folders, whatever the programs keep of a user there."""
import os
import subprocess
import unittest

import fyd

SYSTEM_PYTHON = "/usr/bin/python3"  # Debian's, which has Debian's h5py
ATTACKS = os.path.join(os.environ["FYD_SOURCE_DIR"], "tests", "attack")
CLI = os.path.dirname(__file__)
WINDOW = os.environ.get("TEST_WINDOW")


class Home(fyd.Case):
    def left(self, *command, **more):
        """What the command leaves in an empty home, of a user who set none of XDG's folders."""
        home = self.path("home")
        os.mkdir(home)
        environment = {name: value for name, value in os.environ.items() if not name.startswith("XDG_")} | {"HOME": home}
        done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=fyd.PATIENCE, check=False, **more)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return os.listdir(home)

    def test_a_recording_enters_the_users_catalogue(self):
        command = [fyd.PROGRAM, "station", "--simulate", "--duration", "1", "--record", self.path("a.h5")]
        self.assertEqual(self.left(*command), [".local"])

    def test_the_hostile_files_leave_nothing(self):
        script = "import sys, hostile_files; hostile_files.record(sys.argv[1])"
        self.assertEqual(self.left(SYSTEM_PYTHON, "-c", script, self.folder, cwd=ATTACKS), [])

    def test_tests_of_the_command_line_leave_nothing(self):
        script = "import sys, fyd; sys.exit(fyd.run('station', '--simulate', '--duration', 1, '--record', sys.argv[1]).returncode)"
        self.assertEqual(self.left(SYSTEM_PYTHON, "-c", script, self.path("a.h5"), cwd=CLI), [])

    @unittest.skipUnless(WINDOW, "built without the window")
    def test_what_the_windows_tests_keep_and_save_is_gone_with_them(self):
        window = ("env", "QT_QPA_PLATFORM=offscreen", WINDOW)
        self.assertEqual(self.left(*window, "ConsoleTest", "armingTakesAHoldAndNothingElseArms"), [])


if __name__ == "__main__":
    unittest.main()
