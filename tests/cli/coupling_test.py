"""fyd bench coupling: the figures again, from the rows that were written."""
import csv
import glob
import os
import unittest

import fyd

RUNS = 15
WALL_m = 0.050


@fyd.needs_bench
class Coupling(fyd.Case):
    def test_the_default_coupling_meets_its_goals_in_every_run(self):
        folder = self.path("runs")
        done = fyd.run("bench", "coupling", "--runs", RUNS, "--seed", 11, "--out", folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(f"| model | {RUNS} of {RUNS} |", done.stdout)
        with open(os.path.join(folder, "runs.csv"), encoding="ascii") as file:
            drawn = [row for row in csv.DictReader(file) if row["coupling"] == "model"]
        files = sorted(glob.glob(os.path.join(folder, "run_*.csv")))
        self.assertEqual((len(drawn), len(files)), (RUNS, RUNS))
        for run, path in zip(drawn, files):
            with self.subTest(os.path.basename(path)), open(path, encoding="ascii") as file:
                rows = [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]
                energy = least = 0.0
                for row in rows:
                    energy += row["hand_force_N"] * row["hand_v_m_per_s"] * 1e-3
                    least = min(least, energy)
                self.assertGreaterEqual(least, -1e-3)
                self.assertLessEqual(max(abs(row["hand_force_N"]) for row in rows if row["t_s"] < 1.5), 0.3)
                pressed = [row["hand_x_m"] for row in rows if 6.0 <= row["t_s"] < 7.0]
                self.assertLessEqual(max(pressed) - min(pressed), 0.5e-3)
                rest = min(rows, key=lambda row: abs(row["t_s"] - 10.99))
                self.assertLessEqual(abs(rest["hand_x_m"] - rest["far_x_m"]), 0.5e-3)
                last = rows[-1]
                felt = last["hand_force_N"] / (last["hand_x_m"] - WALL_m)
                self.assertAlmostEqual(felt / float(run["wall_N_per_m"]), 1.0, delta=0.1)
                self.assertGreater(last["hand_force_N"], 0.5)

    def test_a_seed_gives_the_same_again(self):
        def table(seed):
            done = fyd.run("bench", "coupling", "--runs", 2, "--seed", seed)
            self.assertEqual(done.returncode, 0, done.stderr)
            return done.stdout
        self.assertEqual(table(3), table(3))
        self.assertNotEqual(table(3), table(4))

    def test_no_runs_are_refused(self):
        self.assertIn("--runs", self.refused(2, "bench", "coupling", "--runs", "0"))


if __name__ == "__main__":
    unittest.main()
