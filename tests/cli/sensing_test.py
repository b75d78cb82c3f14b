"""fyd finger and fyd sense."""
import math
import unittest

import fyd

CLOTH = 210


class Finger(fyd.Case):
    def picture(self, name, discs=(), cloth=CLOTH, width=320, height=240):
        """A grey PGM with dark discs (x, y, radius)."""
        rows = bytearray([cloth]) * (width * height)
        for x, y, radius in discs:
            for v in range(height):
                for u in range(width):
                    if math.hypot(u - x, v - y) <= radius:
                        rows[v * width + u] = 70
        with open(self.path(name), "wb") as file:
            file.write(b"P5 %d %d 255\n" % (width, height) + rows)
        return self.path(name)

    def test_each_picture_stands_on_its_own_in_the_order_given(self):
        paths = [
            self.picture("left.pgm", [(106, 120, 15)]),
            self.picture("black.pgm", cloth=0),
            self.picture("white.pgm", cloth=255),
            self.picture("right.pgm", [(194, 90, 15)]),
            self.picture("small.pgm", width=20, height=20),
        ]
        found = self.json("finger", *paths, "--json")
        self.assertEqual([entry["contact"] for entry in found], [True, False, False, True, False])
        self.assertEqual([entry["reason"] for entry in found],
                         ["found", "black picture", "saturated", "found", "no picture"])
        self.assertAlmostEqual(found[0]["x_px"], 106, delta=0.05)
        self.assertAlmostEqual(found[0]["x_mm"], -20, delta=0.05)
        self.assertAlmostEqual(found[3]["y_mm"], 14, delta=0.05)
        self.assertAlmostEqual(found[3]["area_px"], 709, delta=14)
        for key in ("x_px", "y_px", "x_mm", "y_mm"):
            self.assertIsNone(found[1][key])
        self.assertEqual(found[3], self.json("finger", paths[3], "--json")[0])

    def test_a_file_that_is_no_picture_is_named_and_the_others_are_answered(self):
        good = self.picture("good.pgm", [(150, 120, 15)])
        bad = self.write("bad.png", "no picture")
        done = fyd.run("finger", bad, good, "missing.png", "--json")
        self.assertEqual(done.returncode, 1)
        self.assertIn("bad.png", done.stderr)
        self.assertIn("missing.png", done.stderr)
        self.assertIn('"contact": true', done.stdout)

    def test_the_profile_sets_region_and_scale(self):
        path = self.picture("one.pgm", [(194, 90, 15)])
        profile = self.write("p.toml", "[sensing]\nfinger_scale_x_mm_per_px = 1.0\n")
        self.assertAlmostEqual(self.json("finger", path, "--profile", profile, "--json")[0]["x_mm"], 44, delta=0.1)
        self.refused(1, "finger", path, "--profile", self.write("bad.toml", "[sensing]\nroi_width_px = 3\n"))
        self.refused(2, "finger")


class Sense(fyd.Case):
    def test_the_thesis_polynomial_without_a_profile(self):
        result = self.json("sense", "--adc", "1241,1600,2000", "--at", "0,0", "--bridge", "0.8", "--json")
        for distance, code in zip(result["distance_mm"], (1241, 1600, 2000)):
            v = 3.3 * code / 4096
            expected = 10 * (-4.6327 * v**5 + 39.954 * v**4 - 133.8297 * v**3 + 220.8604 * v**2 - 188.5623 * v + 79.0712)
            self.assertAlmostEqual(distance, expected, places=6)
        self.assertEqual(result["valid"], [True, True, True])
        self.assertAlmostEqual(result["force_N"], 7.68501, places=4)
        self.assertAlmostEqual(result["stiffness_N_per_mm"], result["force_N"] / result["indentation_mm"], places=9)

    def test_the_thesis_plane_on_request(self):
        result = self.json("sense", "--adc", "1700,1650,1720", "--at", "11,9", "--json", "--set",
                           "sensing.indentation_mode=thesis")
        z = [d - 100 for d in result["distance_mm"]]
        plane = 9 * z[0] / 20 + z[1] / 10 + 9 * z[2] / 20 - 11 * z[0] / 44 + 11 * z[2] / 44 - 9 * z[0] / 60 + 9 * z[1] / 30 - 9 * z[2] / 60
        self.assertAlmostEqual(result["indentation_mm"], -plane, places=9)

    def test_null_for_what_is_invalid(self):
        result = self.json("sense", "--adc", "0,4095,1700", "--at", "0,0", "--bridge", "9", "--json")
        self.assertEqual(result["distance_mm"][:2], [None, None])
        self.assertEqual(result["valid"], [False, False, True])
        for key in ("indentation_mm", "sigma_mm", "force_N", "stiffness_N_per_mm"):
            self.assertIsNone(result[key])
        one_missing = self.json("sense", "--adc", "1700,4095,1700", "--at", "0,0", "--json")
        self.assertIsNotNone(one_missing["indentation_mm"])
        self.assertIsNone(one_missing["force_N"])
        for odd in ("nan", "inf", "-5", "1e300", "1e-310"):
            self.assertIsNone(self.json("sense", "--adc", f"{odd},1700,1700", "--at", "0,0", "--json")["distance_mm"][0])
            self.json("sense", "--adc", "1700,1700,1700", "--at", f"{odd},0", "--bridge", odd, "--json")

    def test_wrong_usage_is_refused(self):
        self.refused(2, "sense", "--adc", "1,2", "--at", "0,0")
        self.refused(2, "sense", "--adc", "1,2,x", "--at", "0,0")
        self.refused(2, "sense", "--adc", "1,2,3", "--at", "0")
        self.refused(2, "sense", "--adc", "1,2,3")


if __name__ == "__main__":
    unittest.main()
