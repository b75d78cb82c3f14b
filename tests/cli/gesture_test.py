"""fyd gesture: a card of a golden recording's touch, trimmed, shown, and played again in a session."""
import csv
import io
import os
import tempfile
import unittest

import fyd



def parts_of(path):
    head, body = open(path, encoding="utf-8").read().split("---\n")
    return head, [{name: float(value) for name, value in row.items()} for row in csv.DictReader(io.StringIO(body))]


class Gesture(fyd.Case):
    def test_a_touch_becomes_a_card_that_is_trimmed_and_played(self):
        with tempfile.TemporaryDirectory() as folder:
            recording = os.path.join(folder, "a.fyd")
            card, part = os.path.join(folder, "a.gesture"), os.path.join(folder, "b.gesture")
            self.json("station", "--simulate", "--robot", "none", "--duration", "6", "--record", recording, "--json")
            made = self.json("gesture", "from", recording, "--touch", "1", "-o", card, "--json")
            head, rows = parts_of(card)
            self.assertTrue(head.startswith('format = "FYD gesture 1"\n'))
            self.assertEqual(made["rows"], len(rows))
            self.assertEqual(rows[0]["t_s"], 0)
            # The demonstration's first press: at −25, 10, 5 mm deep, held from 0.9 to 1.6 s.
            deepest = max(rows, key=lambda row: row["depth_mm"])
            self.assertAlmostEqual(deepest["x_mm"], -25, delta=2)
            self.assertAlmostEqual(deepest["y_mm"], 10, delta=2)
            self.assertAlmostEqual(deepest["depth_mm"], 5, delta=1.5)
            self.assertGreater(rows[-1]["t_s"], 0.5)
            spacing = rows[-1]["t_s"] / (len(rows) - 1)
            self.assertGreater(spacing, 0.02, "a row for each picture, not for each step")
            self.json("gesture", "trim", card, "--from", "0.2", "--to", "0.8", "--speed", "2", "--once", "--name",
                      "held", "-o", part, "--json")
            shown = self.json("gesture", "show", part, "--json")
            self.assertEqual((shown["name"], shown["speed"], shown["loop"]), ("held", 2.0, False))
            self.assertLessEqual(shown["seconds"], 0.6)
            played = self.json("station", "--simulate", "--robot", "none", "--finger", card, "--duration", "3", "--json")
            self.assertGreater(played["contact_fraction"], 0.2)

    def test_wrong_words_are_judged_before_a_file_is_opened(self):
        trim, touch = ("gesture", "trim", "nowhere", "-o", "x"), ("gesture", "from", "nowhere", "-o", "x")
        for speed in ("100", "0.01", "nan"):
            self.assertIn("--speed: " + speed, self.refused(2, *trim, "--speed", speed))
        self.assertIn("--from 5 --to 3", self.refused(2, *trim, "--from", 5, "--to", 3))
        self.assertIn("--from 3 --to 3", self.refused(2, *trim, "--from", 3, "--to", 3))
        for name in (201 * "a", "a\nb"):
            self.assertIn("--name", self.refused(2, *trim, "--name", name))
        for command in (trim, touch):
            self.assertIn("--name: empty; leave the option out", self.refused(2, *command, "--name", ""))
        for number in ("0", "-1", "1.5", "99999999999999999999"):
            self.assertIn(f"--touch: {number}: expected a whole number", self.refused(2, *touch, f"--touch={number}"))
        self.assertIn("nowhere", self.refused(1, *touch, "--touch", 1, "--speed", 20, "--name", 200 * "a"))

    def test_what_is_wrong_is_named(self):
        self.assertIn("nowhere", self.refused(1, "gesture", "show", "nowhere"))
        with tempfile.TemporaryDirectory() as folder:
            card = os.path.join(folder, "a.gesture")
            with open(card, "w", encoding="utf-8") as file:
                file.write('format = "FYD gesture 1"\nname = "a"\n---\nt_s,x_mm,y_mm,depth_mm\n0,0,0,1\n1,99,0,1\n')
            self.assertIn("a.gesture:6: x_mm is 99", self.refused(1, "gesture", "show", card))
            self.assertIn("a.gesture:6: x_mm is 99",
                          self.refused(1, "station", "--simulate", "--robot", "none", "--finger", card))


if __name__ == "__main__":
    unittest.main()
