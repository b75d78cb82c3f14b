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
        self.assertAlmostEqual(found[3]["area_mm2"], 150.4, delta=3)  # 100/220 mm × 70/150 mm a pixel
        self.assertIsNone(found[1]["area_mm2"])
        for key in ("x_px", "y_px", "x_mm", "y_mm"):
            self.assertIsNone(found[1][key])
        self.assertEqual(found[3], self.json("finger", paths[3], "--json")[0])

    def test_a_file_that_is_no_picture_is_named_and_the_others_are_answered(self):
        good = self.picture("good.pgm", [(150, 120, 15)])
        bad = self.write("bad.png", "no picture")
        done = fyd.run("finger", bad, good, "missing.png", "--json")
        self.assertEqual(done.returncode, 1)
        self.assertIn("bad.png", done.stderr)
        self.assertIn("missing.png: cannot be read: ", done.stderr)
        self.assertIn("it is no file", fyd.run("finger", self.folder).stderr)
        self.assertIn('"contact": true', done.stdout)

    def test_the_profile_sets_region_and_scale(self):
        path = self.picture("one.pgm", [(194, 90, 15)])
        profile = self.write("p.toml", "[sensing]\nfinger_scale_x_mm_per_px = 1.0\n")
        self.assertAlmostEqual(self.json("finger", path, "--profile", profile, "--json")[0]["x_mm"], 44, delta=0.1)
        self.refused(1, "finger", path, "--profile", self.write("bad.toml", "[sensing]\nroi_width_px = 3\n"))
        self.refused(2, "finger")


HEADER = "adc1,adc2,adc3,x_mm,y_mm,area_mm2,bridge_mV_per_V"


def thesis_mm(code):
    v = 3.3 * code / 4096
    return 10 * (-4.6327 * v**5 + 39.954 * v**4 - 133.8297 * v**3 + 220.8604 * v**2 - 188.5623 * v + 79.0712)


class Sense(fyd.Case):
    def sense(self, *rows, settings=()):
        file = self.write("table.csv", "\n".join([HEADER, *rows]) + "\n")
        return self.json("sense", "--table", file, "--json", *(word for each in settings for word in ("--set", each)))

    def test_the_thesis_polynomial_without_a_profile(self):
        result, = self.sense("1241,1600,2000,0,0,40,0.8")
        for distance, code in zip(result["distance_mm"], (1241, 1600, 2000)):
            self.assertAlmostEqual(distance, thesis_mm(code), places=6)
        self.assertEqual(result["valid"], [True, True, True])
        self.assertAlmostEqual(result["force_N"], 7.68501, places=4)
        self.assertAlmostEqual(result["stiffness_N_per_mm"], result["force_N"] / result["indentation_mm"], places=9)
        self.assertGreater(result["indentation_sigma_mm"], 0)

    def test_a_mean_of_codes_keeps_its_fraction(self):
        result, = self.sense("1241.25,1600.5,2000.75,0,0,40,0.8")
        for distance, code in zip(result["distance_mm"], (1241.25, 1600.5, 2000.75)):
            self.assertAlmostEqual(distance, thesis_mm(code), places=6)

    def test_the_thesis_plane_on_request(self):
        result, = self.sense("1700,1650,1720,11,9,,", settings=["sensing.indentation_mode=thesis"])
        z = [d - 100 for d in result["distance_mm"]]
        plane = 9 * z[0] / 20 + z[1] / 10 + 9 * z[2] / 20 - 11 * z[0] / 44 + 11 * z[2] / 44 - 9 * z[0] / 60 + 9 * z[1] / 30 - 9 * z[2] / 60
        self.assertAlmostEqual(result["indentation_mm"], -plane, places=9)

    def test_each_row_stands_on_its_own_in_the_order_given(self):
        rows = ["1700,1650,1720,11,9,40,0.3", "1650,1650,1650,0,0,20,0.2", "1600,1600,1700,20,-3,60,0.4"]
        together = self.sense(*rows)
        self.assertEqual(together, [self.sense(row)[0] for row in rows])
        self.assertEqual(len({entry["indentation_mm"] for entry in together}), 3)

    def test_null_for_what_is_invalid(self):
        result, one_missing = self.sense("0,4095,1700,0,0,40,9", "1700,4095,1700,0,0,40,")
        self.assertEqual(result["distance_mm"][:2], [None, None])
        self.assertEqual(result["valid"], [False, False, True])
        for key in ("indentation_mm", "indentation_sigma_mm", "force_N", "stiffness_N_per_mm"):
            self.assertIsNone(result[key])
        self.assertIsNotNone(one_missing["indentation_mm"])
        self.assertIsNone(one_missing["force_N"])
        self.assertIsNone(one_missing["stiffness_N_per_mm"])
        for odd in ("nan", "inf", "-5", "1e300", "", "5000"):
            sensor, place = self.sense(f"{odd},1700,1700,0,0,40,", f"1700,1700,1700,{odd},0,40,{odd}")
            self.assertIsNone(sensor["distance_mm"][0], odd)
            self.assertIsNone(place["force_N"], odd)
            if odd in ("nan", "inf", ""):
                self.assertIsNone(place["indentation_mm"], odd)

    def test_the_area_counts_and_none_is_an_unknown_one(self):
        wide, narrow, empty, nothing, nan = self.sense(*(f"1650,1650,1650,0,5,{area},0.3" for area in ("60", "10", "", "0", "nan")),
                                                       settings=["sensing.indentation_mode=contact", "sensing.ir_noise_mV=0.1"])
        self.assertGreater(narrow["indentation_mm"], 1.1 * wide["indentation_mm"])
        self.assertEqual(empty, nothing)
        self.assertEqual(empty, nan)
        self.assertGreater(empty["indentation_sigma_mm"], 3 * wide["indentation_sigma_mm"])

    def test_what_is_no_table_is_refused_with_file_and_line(self):
        for text, words in [("", "empty"), (HEADER + "\n", "no rows"), ("adc1,adc2,x_mm\n1,2,3\n", "adc3"),
                            (HEADER + "\n1,2,3,4,5,6\n", ":2:"), (HEADER + "\n1,2,3,4,five,6,7\n", ":2:"),
                            ("A,B,C,x,y,area,bridge\n1,2,3,4,5,6,7\n", "adc1"),
                            (HEADER + "\n1700,1700,1700,0,0,40,\n1700,1700,1700,0,0,-1,\n", ":3: area_mm2 = -1"),
                            (HEADER + "\n1700,1700,1700,0,0,inf,\n", ":2: area_mm2 = inf")]:
            said = self.refused(1, "sense", "--table", self.write("bad.csv", text), "--json")
            self.assertIn(words, said)
            self.assertIn("bad.csv", said)
        self.assertIn("/dev/zero", self.refused(1, "sense", "--table", "/dev/zero", "--json"))  # never ends
        self.refused(1, "sense", "--table", self.path("none.csv"))

    def test_wrong_usage_is_refused(self):
        self.refused(2, "sense")
        self.refused(2, "sense", "--adc", "1,2,3", "--at", "0,0")


if __name__ == "__main__":
    unittest.main()
