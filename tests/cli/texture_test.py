"""fyd texture render, fit and felt: figures beside what follows from their definitions."""
import math
import os
import random
import unittest

import fyd

PLANT = {"breakaway_percent": 5, "free_speed_deg_s": 207, "time_constant_ms": 15, "roller_radius_mm": 10,
         "resonance_Hz": 70, "damping": 0.3, "resonance_Hz_per_deg": 1}


class Texture(fyd.Case):
    def accelerations(self, rate_Hz=1000, samples=4000, slow_g=0.0, noise_g=1.0):
        noise = random.Random(4)
        path = self.path("in.csv")
        with open(path, "w", encoding="utf-8") as file:
            file.write("t_s,ax,ay,az\n")
            for n in range(samples):
                slow, x, y = slow_g * math.sin(0.2 * n), noise.gauss(0, noise_g), noise.gauss(0, noise_g)
                file.write(f"{n / rate_Hz},{slow + x},{0.5 * slow + y},{1 + 0.3 * slow}\n")
        return path

    def edges(self, *options):
        source = self.accelerations(slow_g=1, noise_g=0.1)
        return self.json("texture", "render", source, "--filter", "none", *options, "--json")["edge_jump_ratio"]

    def test_what_is_wrong_by_itself_is_said_before_files_are_opened(self):
        render, fit = ("texture", "render", "nowhere"), ("texture", "fit", "nowhere")
        for option, value in (("--frame", "0"), ("--hop", "0"), ("--hop", "7")):
            self.assertRegex(self.refused(2, *render, option, value), "0: expected a whole number|hop = 7")
        for option, value in (("--force", "nan"), ("--force", "0"), ("--speed", "inf"), ("--speed", "nan"), ("--speed", "-1")):
            self.assertIn(f"{option}: {value}: expected a number", self.refused(2, *fit, f"{option}={value}"))
        self.assertIn("nowhere", self.refused(1, *fit, "--speed", 40, "--force", 1))

    def test_a_corner_that_the_rate_does_not_hold_is_refused(self):
        source = self.accelerations(rate_Hz=100)
        said = self.refused(2, "texture", "render", source, "--rate", 100, "--corner", 90000)
        self.assertIn("--corner 90000 Hz: expected at most 49 Hz", said)
        self.refused(2, "texture", "render", source, "--corner", 49.5)
        self.json("texture", "render", source, "--corner", 40, "--json")

    def test_edges_of_frames_are_sought_where_they_are(self):
        # The thesis' program is silent for a sample between two blocks: into that sample its slow signal jumps.
        for frame in (16, 32, 64):
            self.assertGreater(self.edges("--method", "dft321_thesis", "--frame", frame), 1.5, frame)
        self.assertGreater(self.edges("--method", "dft321"), 0)
        for method in ("single", "soc", "magnitude", "principal", "recolour"):
            self.assertIsNone(self.edges("--method", method), f"{method} has no frames")

    def felt(self, *options, **plant):
        path = self.path("plant.toml")
        with open(path, "w", encoding="utf-8") as file:
            file.writelines(f"{key} = {value}\n" for key, value in (PLANT | plant).items())
        figures = self.json("texture", "felt", self.accelerations(), "-o", self.path("out.csv"), "--mapping", "symmetric",
                            "--plant", path, "--json", *options)
        del figures["ns_per_sample"]
        return figures

    def test_a_resonance_found_at_another_stretch_is_the_same_cloth(self):
        stretch = ("--stretch", 30)
        self.assertEqual(self.felt(*stretch, stretch_deg=45, resonance_Hz=70), self.felt(*stretch, stretch_deg=60, resonance_Hz=85))
        self.assertNotEqual(self.felt(*stretch, stretch_deg=45, resonance_Hz=70), self.felt(*stretch, stretch_deg=45, resonance_Hz=85))

    def test_a_finger_feels_what_the_cloth_passes_on(self):
        levels = [self.felt(cloth_gain=gain)["level_g"] for gain in (1, 2, 0.5)]
        self.assertGreater(levels[0], 1e-4)
        self.assertAlmostEqual(levels[1] / levels[0], 2, delta=1e-6)
        self.assertAlmostEqual(levels[2] / levels[0], 0.5, delta=1e-6)

    def test_what_was_fitted_can_be_played(self):
        model = self.path("fitted.toml")
        for rate_Hz, options in ((20000, ()), (1000, ("--speed", 1))):
            source = self.accelerations(rate_Hz, 8000)
            fitted = self.json("texture", "fit", source, "-o", model, *options, "--json")
            self.assertGreater(fitted["bands"], 3)
            played = self.json("texture", "play", model, "--speed", 40, "--force", 1, "-o", self.path("signal.csv"), "--json")
            self.assertGreater(played["rms_g"], 0)

    def test_more_samples_than_a_signal_may_have_are_refused_at_once(self):
        said = self.refused(1, "texture", "play", "wood", "--speed", 40, "--force", 1, "-o", self.path("signal.csv"),
                            "--duration", 3600, "--rate", 100000)
        self.assertIn("3600 s at 100000 Hz are 360000000 samples: expected at most 10000000", said)
        self.assertFalse(os.path.exists(self.path("signal.csv")))

    def test_times_in_milliseconds_are_not_taken_for_seconds(self):
        millis = self.accelerations(rate_Hz=1)
        hours = self.accelerations_of_hours()
        for command in (("render",), ("contact",), ("fit",), ("felt", "-o", self.path("out.csv"))):
            with self.subTest(command[0]):
                said = self.refused(1, "texture", command[0], millis, *command[1:])
                self.assertIn(f"{millis}: 1 rows a second; expected 10 and more: are the times in seconds?", said)
                said = self.refused(1, "texture", command[0], hours, *command[1:])
                self.assertIn(f"{hours}: 200000 s from the first row to the last; expected at most 86400: are the times "
                              "in seconds?", said)
        self.assertFalse(os.path.exists(self.path("out.csv")))

    def accelerations_of_hours(self):
        """200 s at 20 kHz, told in milliseconds, and most of it lost."""
        return self.write("hours.csv", "t_s,ax,ay,az\n0,0,0,1\n0.05,0,0,1\n0.1,0,0,1\n200000,0,0,1\n")

    def test_a_table_of_too_many_samples_is_named(self):
        source = self.write("long.csv", "t_s,ax,ay,az\n0,0,0,1\n0.001,0,0,1\n0.002,0,0,1\n20000,0,0,1\n")
        for command in (("render",), ("contact",), ("fit",), ("felt", "-o", self.path("out.csv"))):
            with self.subTest(command[0]):
                said = self.refused(1, "texture", command[0], source, *command[1:])
                self.assertIn(f"{source}: 20000 s at 1000 Hz are 20000001 samples: expected at most 10000000", said)

    def test_a_corner_is_for_the_filter_that_has_one_to_choose(self):
        for name in ("thesis", "none"):
            said = self.refused(2, "texture", "render", "nowhere", "--filter", name, "--corner", 20)
            self.assertIn(f"--corner 20 Hz: filter {name} has none to choose; expected --filter default", said)


if __name__ == "__main__":
    unittest.main()
