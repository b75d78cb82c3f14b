"""fyd texture render and fit: figures beside what follows from their definitions."""
import math
import random
import unittest

import fyd


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

    def test_edges_of_frames_are_sought_where_they_are(self):
        # The thesis' program is silent for a sample between two blocks: into that sample its slow signal jumps.
        for frame in (16, 32, 64):
            self.assertGreater(self.edges("--method", "dft321_thesis", "--frame", frame), 1.5, frame)
        self.assertGreater(self.edges("--method", "dft321"), 0)
        for method in ("single", "soc", "magnitude", "principal", "recolour"):
            self.assertIsNone(self.edges("--method", method), f"{method} has no frames")

    def test_what_was_fitted_can_be_played(self):
        model = self.path("fitted.toml")
        for rate_Hz, options in ((20000, ()), (1000, ("--speed", 1))):
            source = self.accelerations(rate_Hz, 8000)
            fitted = self.json("texture", "fit", source, "-o", model, *options, "--json")
            self.assertGreater(fitted["bands"], 3)
            played = self.json("texture", "play", model, "--speed", 40, "--force", 1, "-o", self.path("signal.csv"), "--json")
            self.assertGreater(played["rms_g"], 0)


if __name__ == "__main__":
    unittest.main()
