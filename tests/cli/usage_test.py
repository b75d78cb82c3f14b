"""Words that mean nothing, values that are no numbers, names that are empty: each is named, and nothing is done."""
import os
import subprocess
import unittest

import fyd

CONSOLE = os.path.join(os.path.dirname(fyd.PROGRAM), "fyd-console")
needs_window = unittest.skipUnless(os.path.exists(CONSOLE), "built without the window")


class Usage(fyd.Case):
    def test_a_word_that_is_no_command_is_named_beside_those_that_are(self):
        self.assertRegex(self.refused(2, "nosuch"), '"nosuch" is no command; expected one of .*station')
        self.assertRegex(self.refused(2, "session", "lst"), 'session: "lst" is none of its commands; .*list')
        self.assertIn("nosuch", self.refused(2, "nosuch", "--json"))

    def test_names_stand_where_a_choice_is_wrong(self):
        said = self.refused(2, "session", "list", "--sort", "foo")
        self.assertRegex(said, "foo not in {.*duration.*}")
        self.assertNotRegex(said, "[0-9]")

    def window_refuses(self, code, *words):
        """What fyd-console says on standard error of words that it ends with `code`."""
        done = subprocess.run([CONSOLE, *words], capture_output=True, text=True, check=False, timeout=fyd.PATIENCE,
                              env=dict(os.environ, QT_QPA_PLATFORM="offscreen"))
        self.assertEqual((done.returncode, done.stdout), (code, ""), done.stderr)
        return done.stderr

    @staticmethod
    def wrong_words(recording):
        """(words of a station, of `fyd` and of the window, what is said of them)"""
        real = ("--touchpad", "modbus-tcp:127.0.0.1:1")
        camera, key = ("--camera", "/nowhere/camera"), ("--key", "/nowhere/lab.key")
        played = ("--touchpad", "recording:/nowhere/a.h5")
        scene = "scene:/nowhere/s.toml"
        simulated = ("--simulate", "--robot")
        return (
            (("--touchpad", "foo"), "touchpad 'foo': expected"),  # and not that its camera is missing
            (("--touchpad", "modbus-tcp:127.0.0.1:1,serial="), "expected a serial number of 1 to 16 characters"),
            (("--simulate", "--motors", "foo"), "motors 'foo': expected qbmove:TTY"),
            (real, "camera: none given"),
            ((*real, *camera, "--finger", "/nowhere/f.csv"), "finger '/nowhere/f.csv': only the simulated touchpad"),
            ((*played, "--finger", "/nowhere/f.csv"), "finger '/nowhere/f.csv': only the simulated touchpad"),
            ((*played, "--motors", "qbmove:/dev/null"), "a recording drives no motors"),
            ((*simulated, "foo"), "robot 'foo': expected"),
            ((*simulated, "link:127.0.0.1:0"), "needs a key file"),
            ((*simulated, "link:foo", *key), 'address "foo": no port'),
            ((*simulated, "none", *key), "takes no key file"),
            ((*simulated, "simulated:foo"), "foo"),
            ((*simulated, "classic:foo"), 'address "foo": no port'),
            ((*simulated, scene, "--scene", "other.toml"), "the robot is a scene already"),
            (("--simulate", "--catalogue", "nonsense"), "catalogue 'nonsense': expected sqlite:PATH"),
            (("--simulate", "--record", recording, "--subject", "Anna Rossi"), "expected a code"))

    def test_a_stations_words_are_judged_before_anything_is_looked_at(self):
        for words, said in self.wrong_words(self.path("a.h5")):
            with self.subTest(words=words):
                self.assertIn(said, self.refused(2, "station", "--duration", 1, "--profile", "/nowhere/lab.toml", *words))
        self.assertEqual(os.listdir(self.folder), [])

    @needs_window
    def test_the_window_judges_the_same_words_in_the_same_way(self):
        for words, said in self.wrong_words(self.path("a.h5")):
            with self.subTest(words=words):
                self.assertIn(said, self.window_refuses(2, "--profile", "/nowhere/lab.toml", *words))
        self.assertEqual(os.listdir(self.folder), [])

    @needs_window
    def test_what_a_file_says_is_no_wrong_usage_for_both(self):
        pad = self.write("pad.toml", '[station]\ntouchpad = "pad"\n')
        for words, said in ((("--finger", "/nowhere/f.csv"), "/nowhere/f.csv"), (("--profile", "/nowhere/lab.toml"), "/nowhere/lab.toml"),
                            (("--scene", "/nowhere/s.toml"), "/nowhere/s.toml"), (("--robot", "scene:/nowhere/s.toml"), "/nowhere/s.toml"),
                            (("--robot", "link:127.0.0.1:0", "--key", "/nowhere/lab.key"), "/nowhere/lab.key")):
            with self.subTest(words=words):
                self.assertIn(said, self.refused(1, "station", "--duration", 1, "--simulate", *words))
                self.assertIn(said, self.window_refuses(1, "--simulate", *words))
        self.assertIn("touchpad 'pad': expected", self.window_refuses(1, "--profile", pad))
        self.assertIn("/nowhere/a.h5", self.window_refuses(1, "--simulate", "--review", "/nowhere/a.h5"))

    def test_a_profiles_word_is_no_wrong_usage(self):
        for number, word in enumerate(('robot = "robby"', 'touchpad = "pad"', 'motors = "maxon"')):
            profile = self.write(f"{number}.toml", f"[station]\n{word}\n")
            self.assertIn(word.split('"')[1], self.refused(1, "station", "--duration", 1, "--profile", profile))

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

    def test_what_a_robot_would_take_no_notice_of_is_refused(self):
        robot = ("robot", "--connect", "127.0.0.1:1", "--duration", 0.1)
        for words, named in ((("--arm", "kuka:127.0.0.1:0", "--stiffness", 3), "--stiffness"),
                             (("--scene", "echography", "--material", "foam"), "--material"),
                             (("--no-probe", "--probe-force", 3), "--probe-force"), (("--state-rate", 50), "--state-rate"),
                             (("--link", "--key", "/nowhere/k", "--waits", "wired"), "--waits")):
            with self.subTest(words=words):
                self.assertIn(named, self.refused(2, *robot, *words))

    def test_two_outputs_at_once_are_refused(self):
        self.refused(2, "params", "--markdown", "--json")
        self.refused(2, "sim", "touchpad", "--print-map", "--json")
        self.assertIn("--set", self.refused(2, "params", "--markdown", "--set", "control.kp=0.25"))
        saved = ("--save", self.path("p.toml"))
        self.assertEqual(fyd.run("params", "--markdown", "--set", "control.kp=0.25", *saved).returncode, 0)

    def test_help_that_cannot_be_written_is_no_success(self):
        for words in (["--help"], ["--version"], ["session", "--help"], ["session", "list", "--help"]):
            with self.subTest(words=words), open("/dev/full", "w", encoding="utf-8") as full:
                done = subprocess.run([fyd.PROGRAM, *words], stdout=full, stderr=subprocess.PIPE, text=True, check=False,
                                      timeout=fyd.PATIENCE)
                self.assertEqual(done.returncode, 1)
                self.assertIn("standard output: not all", done.stderr)
            self.assertEqual(fyd.run(*words).returncode, 0)

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
