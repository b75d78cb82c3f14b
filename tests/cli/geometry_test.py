"""Where the window's controls stand: STOP and Arm at one place whatever is open, and on the screen at 200 %."""
import json
import os
import subprocess
import unittest

import fyd

CONSOLE = os.path.join(os.path.dirname(fyd.PROGRAM), "fyd-console")


def console(*arguments):
    environment = dict(os.environ, QT_QPA_PLATFORM="offscreen", LC_ALL="C.UTF-8")
    return subprocess.run([CONSOLE, "--language", "en", *arguments], capture_output=True, text=True, env=environment,
                          timeout=fyd.PATIENCE, check=False)


def rectangles(*arguments):
    done = console("--simulate", "--dump-geometry", *arguments)
    assert done.returncode == 0, done.stderr
    dumped = json.loads(done.stdout)
    window = dumped["window"]
    controls = {each["id"]: (each["x"], each["y"], each["width"], each["height"]) for each in dumped["controls"]}
    return (window["width"], window["height"]), controls


@unittest.skipUnless(os.path.exists(CONSOLE), "built without the window")
class Geometry(fyd.Case):
    def test_stop_and_arm_stand_still_whatever_opens(self):
        for size, scale in (("1280x720", "1"), ("960x540", "2")):
            shut, controls = rectangles("--size", size, "--scale", scale)
            self.assertEqual("{}x{}".format(*shut), size)
            for panels in ("recording", "link", "manual", "log", "recording,link,manual"):
                with self.subTest(size=size, panels=panels):
                    window, opened = rectangles("--size", size, "--scale", scale, "--open", panels)
                    self.assertEqual(window, shut)
                    self.assertGreater(len(opened), len(controls), "the panel is seen")
                    for name in ("stop_button", "arm_button"):
                        self.assertEqual(opened[name], controls[name])
                        x, y, width, height = opened[name]
                        self.assertTrue(x >= 0 and y >= 0 and x + width <= window[0] and y + height <= window[1])

    def test_wrong_words_are_refused_with_what_was_expected(self):
        for option, value, expected in (("--open", "kitchen", "recording"), ("--scale", "9", "0.5 to 4"),
                                        ("--size", "big", "WIDTHxHEIGHT"), ("--size", "0x0", "WIDTHxHEIGHT")):
            done = console("--dump-geometry", option, value)
            self.assertEqual(done.returncode, 2)
            self.assertIn(value, done.stderr)
            self.assertIn(expected, done.stderr)


if __name__ == "__main__":
    unittest.main()
