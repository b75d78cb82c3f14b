"""fyd teleop: two simulated desktop arms over a network, one run and the whole table."""
import csv
import math
import os
import unittest

import fyd

TRACE = os.path.join(fyd.DATA, "teleop_1dof", "d_foam.csv")
NETWORK = os.path.join(fyd.DATA, "network", "urban_n8_10ms_01.csv")


class Teleop(fyd.Case):
    def run_of(self, *more):
        return self.json("teleop", "run", "--trace", TRACE, "--period", 10, *more, "--json")

    def test_figures_are_those_of_the_rows(self):
        out = self.path("rows.csv")
        got = self.run_of("--delay", 50, "--predictor", "default", "--coupling", "model", "--out", out)
        with open(out, encoding="ascii") as file:
            rows = [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]
        self.assertEqual(len(rows), round(1000 * got["seconds"]))
        linked = rows[round(len(rows) * (1 - got["linked_percent"] / 100)):]
        errors = [math.dist(*([row[f"{who}_{axis}_mm"] for axis in "xyz"] for who in ("hand", "far"))) for row in linked]
        self.assertAlmostEqual(got["rms_error_mm"], math.sqrt(sum(e * e for e in errors) / len(errors)), 2)
        self.assertAlmostEqual(got["max_error_mm"], max(errors), 2)
        self.assertEqual(got["drag_N"], 0)
        self.assertAlmostEqual(got["packets_per_s"], 100, delta=1)
        self.assertLessEqual(got["datagram_bits"], 640)  # 64 kbit/s · 10 ms

    def test_predicted_is_nearer_than_held_and_less_late(self):
        held, ours = (self.run_of("--delay", 100, "--jitter", 5, "--loss", 10, "--predictor", name) for name in ("order0", "default"))
        self.assertLess(ours["rms_error_mm"], 0.6 * held["rms_error_mm"])
        self.assertLess(ours["added_delay_ms"], 0.5 * held["added_delay_ms"])
        self.assertLess(ours["orientation_rms_deg"], 0.6 * held["orientation_rms_deg"])

    def test_all_couplings_run_against_a_wall_and_repeat_to_the_bit(self):
        for name in ("spring", "tdpa", "model"):
            with self.subTest(name):
                options = ("--delay", 80, "--jitter", 10, "--loss", 20, "--coupling", name, "--wall", 800, "--seed", 3)
                got = self.run_of(*options)
                self.assertEqual(got, self.run_of(*options))
                if name == "model":
                    self.assertGreaterEqual(got["least_energy_J"], -1e-3)

    def test_with_a_deadband_less_is_sent_and_the_rows_show_the_band_held(self):
        out = self.path("rows.csv")
        options = ("--delay", 40, "--jitter", 10, "--loss", 20, "--wall", 500)
        every = self.run_of(*options)
        self.assertIsNone(every["deadband_worst"])
        got = self.run_of(*options, "--deadband", 10, "--out", out)
        self.assertLess(got["packets_per_s"], 60)
        self.assertLess(got["back_packets_per_s"], 100)  # a tenth of 1 kHz
        self.assertEqual(got["packets_without_per_s"], 100)
        self.assertLess(got["rms_error_mm"], 1.5 * every["rms_error_mm"])
        self.assertGreaterEqual(got["least_energy_J"], -1e-3)
        with open(out, encoding="ascii") as file:
            rows = [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]
        known = [row for row in rows if not math.isnan(row["told_x_mm"])]
        forces = [row for row in rows if not math.isnan(row["told_force_N"])]
        self.assertGreater(len(known), 0.8 * len(rows))
        self.assertGreater(len(forces), 0.8 * len(rows))
        self.assertGreater(max(row["far_force_N"] for row in forces), 1)
        for row in known:  # 0.01 mm: the row is the hand, what was sent the device's encoder
            band = max(0.1, 0.10 * 0.05 * abs(row["told_x_mm_per_s"]))
            self.assertLessEqual(abs(row["hand_x_mm"] - row["told_x_mm"]), band + 0.0101, row)
        for row in forces:
            self.assertLessEqual(abs(row["far_force_N"] - row["told_force_N"]), max(0.1, 0.10 * abs(row["told_force_N"])) + 1e-4, row)

    def test_the_rarer_the_messages_the_longer_corrections_take_unless_told(self):
        usual = self.json("teleop", "run", "--trace", TRACE, "--period", 100, "--profile", "lan", "--json")
        short = self.json("teleop", "run", "--trace", TRACE, "--period", 100, "--profile", "lan", "--smooth", 15, "--json")
        self.assertLess(usual["vibration_ratio"], 0.25 * short["vibration_ratio"])
        self.assertEqual(self.run_of("--profile", "lan"), self.run_of("--profile", "lan", "--smooth", 15))

    def test_profiles_by_name_and_by_recording(self):
        self.assertGreater(self.run_of("--profile", "adsl")["linked_percent"], 95)
        recorded = self.run_of("--profile", NETWORK, "--predictor", "order0")
        self.assertGreater(recorded["added_delay_ms"], 10)  # half of about 29 ms, and more
        self.assertLess(recorded["added_delay_ms"], 60)

    def test_two_devices_that_were_never_linked_have_no_errors_instead_of_none(self):
        for options in (("--loss", 100), ("--delay", 60_000)):
            with self.subTest(options):
                got = self.run_of(*options)
                self.assertEqual(got["linked_percent"], 0)
                for key in ("rms_error_mm", "max_error_mm", "believed_rms_mm", "believed_max_mm", "added_delay_ms", "jerk_ratio",
                            "vibration_ratio", "largest_step_mm", "orientation_rms_deg"):
                    self.assertIsNone(got[key], key)

    def test_wrong_usage_is_named(self):
        run = ("teleop", "run", "--trace", TRACE)
        self.assertIn("order2", self.refused(2, *run, "--predictor", "order2"))
        self.assertIn("rope", self.refused(2, *run, "--coupling", "rope"))
        self.assertIn("period 0", self.refused(2, *run, "--period", 0))
        self.assertIn("period 0", self.refused(2, *run, "--period", 0, "--profile", "no.csv"))
        self.assertIn("-5", self.refused(2, *run, "--delay=-5"))
        self.assertIn("wall -1", self.refused(2, *run, "--wall=-1"))
        self.assertIn("deadband -1", self.refused(2, *run, "--deadband=-1"))
        self.assertIn("deadband nan", self.refused(2, *run, "--deadband=nan"))
        self.assertIn("modem", self.refused(2, *run, "--profile", "modem"))
        self.assertIn("own", self.refused(2, *run, "--profile", "lan", "--delay", 5))
        self.assertIn("none.csv", self.refused(1, "teleop", "run", "--trace", self.path("none.csv")))
        self.assertIn("round trip -3", self.refused(1, *run, "--profile", self.write("n.csv", "sent_ms,rtt_ms\n0,5\n10,-3\n")))
        millis = self.write("millis.csv", "t_s,x_mm\n0,0\n60000,1\n")
        self.assertRegex(self.refused(1, "teleop", "run", "--trace", millis), "millis.csv: 60000 s .*3600: are the times in seconds")
        lost = self.write("lost.csv", "t_s,x_mm\n" + "".join(f"{n},nan\n" for n in range(12)))
        for command in (("teleop", "run", "--trace"), ("predict",)):
            self.assertIn(f"{lost}: 12 rows, none of them with a position; expected one and more", self.refused(1, *command, lost))
            for far in ("1e308", "-1e308", "2e9"):
                beyond = self.write("beyond.csv", f"t_s,x_mm\n0,0\n1,{far}\n2,0\n")
                self.assertRegex(self.refused(1, *command, beyond),
                                 r"beyond.csv: row 2: position .* mm; expected one within ±1000000000, or NaN in a gap")
        self.assertIn("seconds", self.refused(2, "teleop", "table", "--seconds", 0))
        self.assertIn("no recordings", self.refused(1, "teleop", "table", "--data", self.path("empty")))

    def test_where_the_tables_picture_cannot_go_is_said_before_the_work(self):
        folder = self.path("data")
        os.makedirs(os.path.join(folder, "network"))
        hand, network = os.path.join(folder, "hand.csv"), os.path.join(folder, "network", "urban.csv")
        os.symlink(TRACE, hand)
        os.symlink(NETWORK, network)
        for out in (hand, network, self.path("new.h5"), folder):
            with self.subTest(out=out):
                self.assertIn(out, self.refused(1, "teleop", "table", "--data", folder, "--out", out))  # and no rows

    def test_a_table_of_a_hand_that_comes_late_has_nothing_to_show(self):
        rows = "".join(f"{n / 10},{'nan' if n < 30 else n}\n" for n in range(60))
        late = self.write("late.csv", "t_s,x_mm\n" + rows)
        said = self.refused(1, "teleop", "table", "--data", self.folder, "--seconds", 1, "--json")
        self.assertIn(f"{late}: 11 rows, none of them with a position", said)

    def test_the_table_has_every_network_period_and_predictor(self):
        folder = self.path("data")
        os.makedirs(os.path.join(folder, "network"))
        with open(TRACE, encoding="ascii") as file, open(os.path.join(folder, "hand.csv"), "w", encoding="ascii") as copy:
            copy.write("".join(file.readlines()[:1500]))
        os.symlink(NETWORK, os.path.join(folder, "network", "urban.csv"))
        picture = self.path("table.svg")
        rows = self.json("teleop", "table", "--data", folder, "--seconds", 2, "--out", picture, "--json")
        keys = {(row["network"], row["period_ms"], row["predictor"]) for row in rows}
        self.assertEqual(len(rows), 4 * 4 * 6)
        self.assertEqual(len(keys), len(rows))
        self.assertEqual({row["network"] for row in rows}, {"lan", "isdn", "adsl", "5g urban"})
        self.assertEqual({row["period_ms"] for row in rows}, {10, 100, 250, 500})
        for row in rows:
            self.assertGreaterEqual(row["least_energy_J"], -1e-3, row)
            self.assertLessEqual(row["packets_per_s"], 1000 / row["period_ms"] + 1)
        with open(picture, encoding="utf-8") as file:
            self.assertIn("adsl, 250 ms", file.read())


if __name__ == "__main__":
    unittest.main()
