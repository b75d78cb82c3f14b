"""fyd calibrate as a user meets it: answers, refusals with their lines, the profile and its record; numpy and scipy
compute the same fits beside it."""
import json
import os
import random
import shutil
import subprocess
import unittest

import fyd

PEER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "scipy_peer.py")
SYSTEM_PYTHON = "/usr/bin/python3"  # Debian's own, which has Debian's scipy
THESIS = [790.712, -1885.623, 2208.604, -1338.297, 399.54, -46.327]
TABLE = "adc1,adc2,adc3,x_mm,y_mm,area_mm2,bridge_mV_per_V"
KEYS = ["coefficients", "rmse", "held_out_rmse", "max_residual", "condition_number", "valid_from", "valid_to", "accepted",
        "reason"]


def thesis_mm(volts):
    return sum(c * volts**i for i, c in enumerate(THESIS))


def thesis_adc(distance_mm):
    low, high = 0.3, 2.9
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if thesis_mm(middle) > distance_mm else (low, middle)
    return low * 4096 / 3.3


def peer(*arguments):
    done = subprocess.run([SYSTEM_PYTHON, PEER, *arguments], capture_output=True, text=True, timeout=fyd.PATIENCE, check=False)
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    return json.loads(done.stdout)


class Calibrate(fyd.Case):
    def setUp(self):
        super().setUp()
        self.random = random.Random(2014)

    def csv(self, name, header, rows):
        return self.write(name, header + "\n" + "".join(",".join(f"{v:.17g}" for v in row) + "\n" for row in rows))

    def ir_file(self, noise=3.0, distances=range(40, 301, 20), adc=thesis_adc):
        rows = [(round(adc(d) + self.random.gauss(0, noise)), d) for d in distances for _ in range(4)]
        return self.csv("ir.csv", "adc,distance_mm", rows)

    def load_rows(self):
        grams = [0, 100, 200, 300, 400, 500, 600, 700, 600, 400, 200, 0]
        return [((g + 20.2512) / 1004.8805 + self.random.gauss(0, 0.001), g * 9.80665e-3) for g in grams]

    def refused_json(self, *arguments):
        done = fyd.run("calibrate", *arguments, "--json")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertNotEqual(done.stderr, "")
        found = json.loads(done.stdout)
        self.assertFalse(found["accepted"])
        for key in KEYS:
            self.assertIn(key, found)
        return found

    def close(self, mine, theirs, relative=1e-9):
        self.assertEqual(len(mine), len(theirs))
        for a, b in zip(mine, theirs):
            self.assertLessEqual(abs(a - b), relative * max(1e-6, abs(b)), f"{a} {b}")

    def test_the_load_cell_agrees_with_scipy_and_with_the_thesis(self):
        file = self.csv("cell.csv", "value,force_N", self.load_rows())
        mine, theirs = self.json("calibrate", "load-cell", file, "--json"), peer("load-cell", file)
        for key in KEYS:
            self.assertIn(key, mine)
        self.assertTrue(mine["accepted"], mine["reason"])
        self.close(mine["coefficients"], theirs["coefficients"])
        self.close(mine["standard_errors"], theirs["standard_errors"], 1e-7)
        for key in ["rmse", "max_residual", "held_out_rmse"]:
            self.close([mine[key]], [theirs[key]], 1e-7)
        self.assertAlmostEqual(mine["coefficients"][0], 1.0048805 * 9.80665, delta=0.05)
        self.assertAlmostEqual(mine["coefficients"][1], -0.0202512 * 9.80665, delta=0.02)

    def test_the_camera_agrees_with_scipy(self):
        rows = [(u, v, 0.4545 * (u - 150) + self.random.gauss(0, 0.05), -0.4667 * (v - 120) + self.random.gauss(0, 0.05))
                for u in range(50, 251, 40) for v in range(50, 191, 35)]
        file = self.csv("camera.csv", "x_px,y_px,x_mm,y_mm", rows)
        mine, theirs = self.json("calibrate", "camera", file, "--json"), peer("camera", file)
        self.assertTrue(mine["accepted"], mine["reason"])
        self.assertFalse(mine["rotation_used"])
        self.close(mine["coefficients"], theirs["coefficients"])
        self.close(mine["standard_errors"], theirs["standard_errors"], 1e-7)
        self.assertLess(abs(mine["rotation_deg"]), 0.2)

    def test_marks_that_are_pressed_down_tell_the_cameras_height(self):
        def rows(depths):
            for depth in depths:
                for x in (-40, 0, 40):
                    for y in (-25, 0, 25):
                        nearer = 100 / (100 - depth)
                        yield (150 + x * nearer / 0.45 + self.random.gauss(0, 0.3),
                               120 - y * nearer / 0.47 + self.random.gauss(0, 0.3), x, y, depth)
        header = "x_px,y_px,x_mm,y_mm,depth_mm"
        profile = self.path("height.toml")
        found = self.json("calibrate", "camera", self.csv("deep.csv", header, list(rows((0, 8)))), "--profile", profile, "--json")
        self.assertTrue(found["accepted"], found["reason"])
        self.assertEqual(found["coefficient_names"][4], "camera_height")
        self.assertLess(abs(found["coefficients"][4] - 100), 4 * found["standard_errors"][4])
        self.assertLess(found["standard_errors"][4], 10)
        self.assertIn("sensing.camera_height_mm", [c["id"] for c in found["changes"]])
        with open(profile, encoding="utf-8") as file:
            self.assertIn("camera_height_mm = 9" if found["coefficients"][4] < 100 else "camera_height_mm = 10", file.read())
        done = fyd.run("calibrate", "camera", self.csv("same.csv", header, list(rows((6, 6)))), "--json")
        self.assertEqual(done.returncode, 1)
        self.assertEqual(json.loads(done.stdout)["threshold"], "calibration.camera_height_percent")
        done = fyd.run("calibrate", "camera", self.csv("no.csv", header, [(*row[:4], -3) for row in rows((0, 8))]), "--json")
        self.assertIn("depth_mm", json.loads(done.stdout)["reason"])

    def test_the_stiffness_map_agrees_with_numpy(self):
        law = {20: 0.501, 45: 0.550, 60: 0.673, 90: 0.715}
        rows = [(angle, depth, k * depth + 0.1 + self.random.gauss(0, 0.03)) for angle, k in law.items()
                for depth in [2, 3, 4, 5, 6, 7, 8]]
        file = self.csv("map.csv", "angle_deg,indentation_mm,force_N", rows)
        mine, theirs = self.json("calibrate", "stiffness", file, "--json"), peer("stiffness", file)
        self.assertTrue(mine["accepted"], mine["reason"])
        self.close(mine["coefficients"], theirs["slopes"])
        self.close([mine["force_offset_N"]], [theirs["offset"]])
        self.close([a["high_95"] for a in mine["angles"]],
                   [k + theirs["t"] * e for k, e in zip(theirs["slopes"], theirs["errors"])], 1e-7)
        self.assertEqual([mine["valid_from"], mine["valid_to"]], [20, 90])

    def test_the_distance_curve_agrees_with_scipy(self):
        for name, adc in [("polynomial", thesis_adc), ("inverse", lambda d: (130 / (d + 6) - 0.05) * 4096 / 3.3)]:
            file = self.ir_file(noise=2.0, adc=adc)
            mine = self.json("calibrate", "ir", file, "--json")
            self.assertTrue(mine["accepted"], mine["reason"])
            form = "inverse" if mine["curve"].startswith("inverse") else "polynomial"
            self.assertEqual(form, name)
            theirs = peer("ir", file, form, json.dumps(mine["coefficients"]))
            with open(file, encoding="utf-8") as rows:
                distances = [float(row.split(",")[1]) for row in rows.readlines()[1:]]
            self.close([d - r for d, r in zip(distances, mine["residuals"])], theirs["predicted"], 1e-9)
            if not mine["curve"].startswith("thesis"):
                self.close(theirs["predicted"], theirs["refitted"], 1e-5)

    def test_an_accepted_curve_is_written_and_used_by_sense(self):
        profile = self.path("lab.toml")
        fyd.run("params", "--save", profile)
        volts = 150 / (100 + 10) - 0.02  # what this unit says at 100 mm
        code = round(volts * 4096 / 3.3)
        file = self.ir_file(noise=2.0, adc=lambda d: (150 / (d + 10) - 0.02) * 4096 / 3.3)
        found = self.json("calibrate", "ir", file, "--sensor", 2, "--profile", profile, "--who", "R. Lee", "--conditions",
                          "lamp off", "--json")
        self.assertEqual(found["written_to"], profile)
        self.assertEqual(found["to_do_again"], [
            {"part": "no-touch", "why": "taken with another curve: take it again (Distance sensor 2)"}])
        self.assertNotIn("sensing.ir_offset_mm", [change["id"] for change in found["changes"]])
        table = self.write("table.csv", f"{TABLE}\n{code},{code},{code},0,0,,\n")
        sensed, = self.json("sense", "--table", table, "--profile", profile, "--json")
        self.assertAlmostEqual(sensed["distance_mm"][1], 100, delta=1)
        self.assertGreater(abs(sensed["distance_mm"][0] - 100), 2)
        again = "no-touch: taken with another curve: take it again (Distance sensor 2)"
        sense = ["sense", "--table", table, "--profile", profile]
        self.assertIn(again, fyd.run(*sense).stderr)
        self.assertEqual("", fyd.run(*sense, "--set", "sensing.ir_offset_mm=[100, 99.5, 100]").stderr)  # a tare since
        with open(self.path("lab.calibration.toml"), encoding="utf-8") as record:
            text = record.read()
        for words in ["R. Lee", "lamp off", "sensing.ir2_curve_mm", "format = 2"]:
            self.assertIn(words, text)
        self.json("calibrate", "ir", file, "--sensor", 3, "--profile", profile, "--json")  # a second record is appended
        with open(self.path("lab.calibration.toml"), encoding="utf-8") as record:
            self.assertEqual(record.read().count("procedure"), 2)

    def test_a_refused_result_leaves_the_profile_as_it_is(self):
        profile = self.path("lab.toml")
        fyd.run("params", "--save", profile, "--set", "sensing.force_slope_g=999")
        with open(profile, encoding="utf-8") as file:
            before = file.read()
        rows = self.load_rows()
        rows[4] = (rows[4][0], rows[4][1] + 3)
        found = self.refused_json("load-cell", self.csv("cell.csv", "value,force_N", rows), "--profile", profile)
        self.assertEqual([o["line"] for o in found["outliers"]], [6])
        with open(profile, encoding="utf-8") as file:
            self.assertEqual(file.read(), before)
        self.assertFalse(os.path.exists(self.path("lab.calibration.toml")))

    def test_a_damaged_record_stops_the_writing_before_anything_changes(self):
        profile = self.path("lab.toml")
        fyd.run("params", "--save", profile)
        shutil.copy(profile, self.path("before"))
        self.write("lab.calibration.toml", "format = 99\n")
        file = self.csv("cell.csv", "value,force_N", self.load_rows())
        self.assertIn("format 99", self.refused(1, "calibrate", "load-cell", file, "--profile", profile))
        with open(profile, encoding="utf-8") as a, open(self.path("before"), encoding="utf-8") as b:
            self.assertEqual(a.read(), b.read())

    def test_a_profile_that_is_not_there_is_made(self):
        file = self.csv("cell.csv", "value,force_N", self.load_rows())
        self.json("calibrate", "load-cell", file, "--profile", self.path("new.toml"), "--json")
        table = self.write("table.csv", f"{TABLE}\n1241,1241,1241,0,0,,0.8\n")
        sensed, = self.json("sense", "--table", table, "--profile", self.path("new.toml"), "--json")
        self.assertAlmostEqual(sensed["force_N"], 7.685, delta=0.05)

    def test_bad_rows_are_refused_with_file_and_line(self):
        for value in ["nan", "inf", "-inf", "5000", "-3"]:
            file = self.write("bad.csv", f"adc,distance_mm\n1000,100\n{value},90\n900,110\n")
            found = self.refused_json("ir", file)
            self.assertTrue(found["reason"].startswith(f"{file}:3: adc = "), found["reason"])
        for text, words in [("adc,distance_mm\n1,2\nx,3\n", ":3:"), ("adc\n1\n", "distance_mm"), ("", "empty"),
                            ("adc,distance_mm\n", "no rows"), ("adc,distance_mm\n1e999,3\n", ":2:")]:
            self.assertIn(words, self.refused(1, "calibrate", "ir", self.write("bad.csv", text), "--json"))
        self.assertIn("cannot be read", self.refused(1, "calibrate", "camera", self.path("none.csv")))

    def test_too_few_repeated_and_scattered_points_say_what_to_do(self):
        few = self.csv("few.csv", "adc,distance_mm", [(thesis_adc(d), d) for d in [40, 60, 100, 150]])
        self.assertIn("add points between 150 and 300 mm", self.refused_json("ir", few)["reason"])
        same = self.csv("same.csv", "value,force_N", [(0.1, 0.8)] * 9)
        self.assertIn("add weights between", self.refused_json("load-cell", same)["reason"])
        noise = self.csv("noise.csv", "adc,distance_mm",
                         [(self.random.uniform(500, 3400), d) for d in range(40, 301, 10)])
        self.refused_json("ir", noise)

    def test_encoders_and_rest(self):
        rows = [(a, (4000 + round(a * 4096 / 360)) % 4096, -a, (90 + round(a * 4096 / 360)) % 4096)
                for a in range(-10, 91, 5)]
        found = self.json("calibrate", "encoders", self.csv(
            "e.csv", "first_deg,first_counts,second_deg,second_counts", rows), "--json")
        self.assertEqual([e["inverted"] for e in found["encoders"]], [False, True])
        self.assertAlmostEqual(found["encoders"][0]["zero_counts"], 4000, delta=1)
        rows = [(self.random.gauss(0, 0.01), 0.6, 0.8 + self.random.gauss(0, 0.01)) for _ in range(200)]
        self.assertAlmostEqual(self.json("calibrate", "rest", self.csv("r.csv", "x_g,y_g,z_g", rows), "--json")["magnitude_g"],
                               1, delta=0.01)

    def test_the_report_shows_before_and_after_and_refused_fits(self):
        profile = self.path("lab.toml")
        file = self.csv("cell.csv", "value,force_N", self.load_rows())
        self.json("calibrate", "load-cell", file, "--profile", profile, "--who", "R. Lee", "--json")
        html = self.path("second.html")
        found = self.json("calibrate", "load-cell", file, "--profile", profile, "--who", "M. Neri", "--report", html,
                          "--json")
        self.assertEqual(found["report"], html)
        with open(html, encoding="utf-8") as report:
            text = report.read()
        for words in ["M. Neri", "R. Lee", "residual, N", "sensing.force_slope_g", "held-out error", "<svg"]:
            self.assertIn(words, text)
        pdf = self.path("cell.pdf")
        self.json("calibrate", "load-cell", file, "--report", pdf, "--json")  # no profile: what it would change
        with open(pdf, "rb") as report:
            self.assertTrue(report.read().startswith(b"%PDF"))
        self.assertIn("exists already", self.refused(1, "calibrate", "load-cell", file, "--report", pdf))
        # Judged by the name alone, not after the fit.
        self.assertIn(".html or .pdf", self.refused(2, "calibrate", "load-cell", "nowhere.csv", "--report", self.path("r.doc")))
        with open(profile, encoding="utf-8") as before:
            kept = before.read()
        other = self.csv("other.csv", "value,force_N", [(2 * value, force) for value, force in self.load_rows()])
        records = sorted(os.listdir(os.path.dirname(profile)))
        for name, code in [("r.doc", 2), ("nowhere/r.html", 1)]:  # a report that cannot be leaves the profile as it was
            self.refused(code, "calibrate", "load-cell", other, "--profile", profile, "--report", self.path(name))
            with open(profile, encoding="utf-8") as after:
                self.assertEqual(after.read(), kept, name)
        self.assertEqual(sorted(os.listdir(os.path.dirname(profile))), records)
        few = self.csv("few.csv", "value,force_N", self.load_rows()[:2])
        html = self.path("refused.html")
        self.refused_json("load-cell", few, "--profile", profile, "--report", html)
        with open(html, encoding="utf-8") as report:
            text = report.read()
        self.assertIn("add weights between", text)
        self.assertIn("values in force stay", text)

    def test_wrong_usage(self):
        file = self.ir_file()
        for arguments in [[], ["nothing"], ["ir"], ["ir", file, "--sensor", "9"], ["ir", file, "--sensor", "0"],
                          ["camera", file, "--no-such"]]:
            self.assertEqual(fyd.run("calibrate", *arguments).returncode, 2, arguments)
        profile, cell = self.path("lab.toml"), self.csv("cell.csv", "value,force_N", self.load_rows())
        measured = ("calibrate", "load-cell", cell, "--profile", profile, "--touchpad")
        for name in ["simulatd", "recording", "serial:", "serial:" + 17 * "A", "modbus-tcp:127.0.0.1", "simulated with maxon",
                     "simulated with qbmove:", "modbus-tcp:127.0.0.1:502,serial=A7"]:
            self.assertIn("expected", self.refused(2, *measured, name), name)
            self.assertFalse(os.path.exists(profile), name)
        for name in ["simulated", "serial:" + 16 * "A", "modbus-rtu:/dev/ttyUSB0", "serial:A7 with qbmove:id=B2",
                     "modbus-tcp:127.0.0.1:502 with qbmove:/dev/ttyUSB1"]:
            self.assertTrue(self.json(*measured, name, "--json")["accepted"], name)

    def test_the_text_says_the_verdict_last(self):
        done = fyd.run("calibrate", "ir", self.ir_file())
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(done.stdout.strip().splitlines()[-1].startswith("accepted: "), done.stdout)


if __name__ == "__main__":
    unittest.main()
