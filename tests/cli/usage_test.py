"""Words that mean nothing, values that are no numbers, names that are empty: each is named, and nothing is done."""
import os
import subprocess
import unittest

import fyd


class Usage(fyd.Case):
    def test_a_word_that_is_no_command_is_named_beside_those_that_are(self):
        self.assertRegex(self.refused(2, "nosuch"), '"nosuch" is no command; expected one of .*station')
        self.assertRegex(self.refused(2, "session", "lst"), 'session: "lst" is none of its commands; .*list')
        self.assertIn("nosuch", self.refused(2, "nosuch", "--json"))

    def test_names_stand_where_a_choice_is_wrong(self):
        said = self.refused(2, "session", "list", "--sort", "foo")
        self.assertRegex(said, "foo not in {.*duration.*}")
        self.assertNotRegex(said, "[0-9]")

    def test_a_touchpads_name_is_looked_at_before_its_camera(self):
        self.assertIn("touchpad 'foo': expected", self.refused(1, "station", "--touchpad", "foo", "--duration", 1))

    def test_not_a_number_is_in_no_range(self):
        for command, option in ((("robot", "--connect", "127.0.0.1:1"), "--probe-force"),
                                (("robot", "--connect", "127.0.0.1:1"), "--known-stiffness"),
                                (("robot", "--connect", "127.0.0.1:1"), "--rate"),
                                (("robot", "--connect", "127.0.0.1:1"), "--duration"),
                                (("station", "--simulate"), "--duration"),
                                (("scene", "fence", "fencing"), "--strokes"),
                                (("texture", "play", "x", "--speed", 1, "--force", 1, "-o", "y"), "--duration"),
                                (("gesture", "trim", "x", "-o", "y"), "--from")):
            for value in ("nan", "-nan", "-1", "1e300", "1x"):
                with self.subTest(command=command, value=value):
                    self.assertRegex(self.refused(2, *command, f"{option}={value}"),
                                     f"{option}: {value}: expected a number from [0-9.]+ to [0-9.e+]+")

    def test_an_empty_value_is_not_an_option_left_out(self):
        station = ("station", "--simulate", "--duration", 1)
        for command in ((*station, "--record", ""), (*station, "--telemetry", ""), (*station, "--profile", ""),
                        ("params", "--save", ""), ("stiffness", "--target", 0.6, "--course", ""),
                        ("session", "info", ""), ("session", "forget", ""), ("session", "tag", "", "--add", "x"),
                        ("session", "notes", "", "x")):
            with self.subTest(command=command):
                self.assertIn("empty; leave the option out", self.refused(2, *command))
        self.json(*station, "--record", self.path("a.h5"), "--notes", "", "--json")  # a text may be empty

    def test_a_files_name_that_is_no_utf8_is_printed(self):
        name = os.path.join(os.fsencode(self.folder), b"\xff.h5")
        done = subprocess.run([fyd.PROGRAM, "station", "--simulate", "--duration", "1", "--record", name],
                              capture_output=True, check=False, timeout=fyd.PATIENCE)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(b"\nrecording ", done.stdout)
        self.assertTrue(os.path.exists(name))


if __name__ == "__main__":
    unittest.main()
