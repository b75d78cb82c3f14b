"""fyd predict: what is sent, when it is scored, and that nothing looks ahead. The reference is written from the manual."""
import csv
import math
import os
import unittest

import fyd

TELEOP = os.path.join(fyd.DATA, "teleop_1dof", "d_foam.csv")
FITTS = os.path.join(fyd.DATA, "strokes", "fitts_p2.csv")
INDEX = os.path.join(fyd.DATA, "hand_motion", "index_tip.csv")


def names():
    """Every predictor, as the program itself lists them."""
    return fyd.run("predict", TELEOP, "--predictor", "none").stderr.strip().split("expected one of ")[1].split(", ")


def rows_of(path):
    with open(path, encoding="ascii") as file:
        return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]


def messages(rows, period, delay):
    """(row, when it arrives) without jitter and loss."""
    if period == 0:
        return [(row, row["t_s"] + delay) for row in rows]
    out, at, n = [], 0, 0
    while rows[0]["t_s"] + n * period <= rows[-1]["t_s"] + 1e-6:
        now = rows[0]["t_s"] + n * period
        while at + 1 < len(rows) and rows[at + 1]["t_s"] <= now + 1e-6:
            at += 1
        out.append((rows[at], now + delay))
        n += 1
    return out


def of_order(order, rows, column, period, delay):
    """The paper's order 0 and 1 at each scored row, for a period of 10 ms and more."""
    sent, arrived, out = messages(rows, period, delay), [], []
    for row in rows:
        while sent and sent[0][1] <= row["t_s"] + 1e-6:
            arrived.append(sent.pop(0)[0])
        if not arrived:
            continue
        value = arrived[-1][column]
        if order and len(arrived) > 1:
            span = arrived[-1]["t_s"] - arrived[-2]["t_s"]
            value += order * (arrived[-1][column] - arrived[-2][column]) / span * (row["t_s"] - arrived[-1]["t_s"])
        out.append((row["t_s"], row[column], value))
    return out


class Predict(fyd.Case):
    def predict(self, trace, *more):
        return self.json("predict", trace, *more, "--json")

    def test_the_papers_predictors_as_a_reference_has_them(self):
        rows = rows_of(TELEOP)
        for name, order in (("order0", 0), ("order1", 1), ("hybrid", 0.5)):
            for period, delay in ((10, 50), (10, 10), (100, 30)):
                with self.subTest(name, period=period, delay=delay):
                    truth = of_order(order, rows, "master_mm", period / 1e3, delay / 1e3)
                    errors = [value - true for _, true, value in truth]
                    got = self.predict(TELEOP, "--predictor", name, "--period", period, "--delay", delay, "--out",
                                       self.path("out.csv"))
                    self.assertEqual(got["ticks"], len(truth))
                    self.assertAlmostEqual(got["rms_error_mm"], math.sqrt(sum(e * e for e in errors) / len(errors)), 6)
                    self.assertAlmostEqual(got["mean_error_mm"], sum(map(abs, errors)) / len(errors), 6)
                    self.assertAlmostEqual(got["max_error_mm"], max(map(abs, errors)), 6)
                    written = rows_of(self.path("out.csv"))
                    self.assertEqual(list(written[0]), ["t_s", "true_master_mm", "predicted_master_mm"])
                    self.assertEqual([row["t_s"] for row in written], [t for t, _, _ in truth])
                    for row, (_, true, value) in zip(written, truth):
                        self.assertAlmostEqual(row["true_master_mm"], true, 9)
                        self.assertAlmostEqual(row["predicted_master_mm"], value, 6)

    def test_nothing_looks_ahead(self):
        """Another future: what is predicted before any of its messages can have arrived stays the same, to the bit."""
        with open(TELEOP, encoding="ascii") as file:
            lines = file.read().splitlines()
        change, delay = 2500, 40
        other = lines[:change + 1]
        for line in lines[change + 1:]:
            cells = line.split(",")
            cells[1] = str(-3 * float(cells[1]) + 7)
            other.append(",".join(cells))
        changed = self.write("changed.csv", "\n".join(other) + "\n")
        self.assertIn("default", names())
        for name in names():
            for smooth in (0, 10):
                with self.subTest(name, smooth=smooth):
                    options = ("--predictor", name, "--period", 10, "--delay", delay, "--jitter", 30, "--loss", 10, "--seed", 5,
                               "--smooth", smooth)
                    self.predict(TELEOP, *options, "--out", self.path("a.csv"))
                    self.predict(changed, *options, "--out", self.path("b.csv"))
                    a, b = rows_of(self.path("a.csv")), rows_of(self.path("b.csv"))
                    from_s = rows_of(TELEOP)[change]["t_s"] + delay / 1e3
                    before = [(x, y) for x, y in zip(a, b) if x["t_s"] < from_s - 1e-6]
                    self.assertGreater(len(before), 2000)
                    for x, y in before:
                        self.assertEqual(x["predicted_master_mm"], y["predicted_master_mm"])
                    self.assertNotEqual(a[-1]["predicted_master_mm"], b[-1]["predicted_master_mm"])

    def test_the_default_is_better_than_the_papers_best(self):
        # Goals on recordings that no constant was chosen on stand in the manual; these are what a change must not lose.
        for trace, period, delay, gain in ((TELEOP, 10, 10, .3), (TELEOP, 10, 50, .4), (TELEOP, 10, 100, .4), (TELEOP, 10, 200, .4),
                                           (INDEX, 10, 10, -.03), (INDEX, 10, 30, 0), (INDEX, 10, 100, .05), (INDEX, 10, 200, .1), (FITTS, 0, 33, .1)):
            with self.subTest(os.path.basename(trace), delay=delay):
                papers = ("order0", "order1", "hybrid")
                got = {name: self.predict(trace, "--predictor", name, "--period", period, "--delay", delay)
                       for name in (*papers, "default")}
                best = min(got[name]["rms_error_mm"] for name in papers)
                self.assertLessEqual(got["default"]["rms_error_mm"], (1 - gain) * best)
                self.assertLessEqual(got["default"]["rms_error_mm"], 1.02 * got["default"]["order0_rms_mm"])
                most = got["default"]["order0_max_mm"]
                self.assertLessEqual(got["default"]["max_error_mm"], max(1.75 * most, most + 1))

    def test_smoothed_it_does_not_buzz(self):
        for delay, smooth, ratio in ((10, 6, 3.5), (50, 15, 3), (100, 20, 2), (200, 14, 2)):
            got = self.predict(TELEOP, "--period", 10, "--delay", delay, "--smooth", smooth)
            self.assertLessEqual(got["largest_step_mm"], 1)
            plain = self.predict(TELEOP, "--period", 10, "--delay", delay)
            self.assertLessEqual(got["vibration_ratio"], 2.5 * ratio)  # one recording; the goal is the median of eight
            self.assertLess(got["vibration_ratio"], 0.5 * plain["vibration_ratio"])

    def test_gaps_columns_and_a_slow_trace(self):
        got = self.predict(FITTS, "--period", 0, "--delay", 33)
        self.assertEqual(got["columns"], ["x_mm", "y_mm"])
        self.assertIsNone(got["vibration_ratio"])
        one = self.predict(FITTS, "--period", 0, "--delay", 33, "--columns", "y_mm", "--out", self.path("y.csv"))
        self.assertEqual(one["columns"], ["y_mm"])
        self.assertEqual(one["ticks"], len(rows_of(self.path("y.csv"))))
        self.assertFalse(any(math.isnan(x) for row in rows_of(self.path("y.csv")) for x in row.values()))

    def test_a_pipe_is_read_once(self):
        options = ("--period", 10, "--delay", 20, "--json")
        with open(TELEOP, encoding="ascii") as file:
            piped = self.of_a_pipe(file.read(), "predict", "/dev/stdin", *options)
        of_a_file = self.json("predict", TELEOP, *options)
        self.assertEqual((piped["columns"], piped["ticks"], piped["rms_error_mm"]),
                         (of_a_file["columns"], of_a_file["ticks"], of_a_file["rms_error_mm"]))

    def test_a_seed_is_a_decimal_number(self):
        options = ("--period", 10, "--delay", 20, "--jitter", 40, "--loss", 20)

        def error(seed):
            return self.predict(TELEOP, *options, "--seed", seed)["rms_error_mm"]
        self.assertEqual(error("010"), error(10))
        self.assertNotEqual(error("010"), error(8))
        for command in (("predict", TELEOP), ("teleop", "run", "--trace", TELEOP), ("teleop", "table"),
                        ("texture", "play", "wood", "--speed", 1, "--force", 1, "-o", "x"),
                        ("session", "trials", "--conditions", "a,b"), ("sim", "touchpad"),
                        ("stiffness", "--target", 0.6), ("robot", "--connect", "127.0.0.1:9")):
            for seed in ("-1", "99999999999999999999", "0x10", "1e3"):
                with self.subTest(command=command, seed=seed):
                    self.assertIn(f"--seed: {seed}: expected a whole number", self.refused(2, *command, f"--seed={seed}"))

    def test_a_seed_gives_the_same_again_and_another_one_another(self):
        options = ("--period", 10, "--delay", 20, "--jitter", 40, "--loss", 20)
        def error(seed):
            return self.predict(TELEOP, *options, "--seed", seed)["rms_error_mm"]
        self.assertEqual(error(1), error(1))
        self.assertNotEqual(error(1), error(2))

    def test_wrong_usage_and_broken_files_are_named(self):
        self.assertIn("order2", self.refused(2, "predict", TELEOP, "--predictor", "order2"))
        self.assertIn("delay -1", self.refused(2, "predict", TELEOP, "--delay", "-1"))
        self.assertIn("nan", self.refused(2, "predict", TELEOP, "--jitter", "nan").lower())
        self.assertIn("loss 120", self.refused(2, "predict", TELEOP, "--loss", "120"))
        self.assertIn("smooth", self.refused(2, "predict", TELEOP, "--smooth", "-3"))
        self.assertIn("z_mm", self.refused(1, "predict", TELEOP, "--columns", "z_mm", "--json"))
        self.assertIn("twice", self.refused(2, "predict", TELEOP, "--columns", "master_mm,master_mm"))
        self.assertIn("one to three", self.refused(2, "predict", TELEOP, "--columns", "a,b,c,d"))
        self.assertIn("t_s is the time", self.refused(2, "predict", TELEOP, "--columns", "t_s"))
        for words in ("master_mm,", ",master_mm", "master_mm,,slave_mm", ","):
            self.assertIn(f"{words}: expected a word before and after each comma",
                          self.refused(2, "predict", TELEOP, "--columns", words))
        for header in ("t_s,x_mm,x_mm", "t_s,t_s,x_mm"):
            twice = self.write("twice.csv", header + "\n0,1,2\n1,2,3\n")
            for columns in ((), ("--columns", "x_mm")):
                self.assertRegex(self.refused(1, "predict", twice, *columns), "twice.csv:1: column '.*' stands there more than once")
        unused = self.write("unused.csv", "t_s,note,note,x_mm\n0,1,2,3\n1,2,3,4\n")
        self.json("predict", unused, "--delay", 0, "--json")  # what is not asked for may be there as often as it likes
        self.assertIn("none.csv", self.refused(1, "predict", self.path("none.csv")))
        self.assertIn("row 2", self.refused(1, "predict", self.write("back.csv", "t_s,x_mm\n1,0\n0.5,0\n")))
        self.assertIn("row 2", self.refused(1, "predict", self.write("inf.csv", "t_s,x_mm\n1,0\n2,inf\n")))
        self.assertIn("1 rows", self.refused(1, "predict", self.write("one.csv", "t_s,x_mm\n1,0\n")))
        micros = self.write("micros.csv", "t_s,x_mm\n0,0\n6e7,1\n")
        self.assertRegex(self.refused(1, "predict", micros), "micros.csv: 60000000 s .*86400: are the times in seconds")
        self.assertIn("86400", self.refused(1, "predict", self.write("huge.csv", "t_s,x_mm\n-1e300,0\n1e300,0\n")))
        self.assertIn("_mm", self.refused(1, "predict", self.write("no.csv", "t_s,x\n1,0\n2,0\n")))
        self.assertIn("no message", self.refused(1, "predict", TELEOP, "--loss", "100"))
        weights = self.write("weights", "22 64 24\n1 2 3\n")
        self.assertIn("3 weights", self.refused(1, "predict", FITTS, "--weights", weights))


if __name__ == "__main__":
    unittest.main()
