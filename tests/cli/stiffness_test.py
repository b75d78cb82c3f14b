"""fyd stiffness and fyd tune: figures, and every wrong value named."""
import unittest

import fyd


# The cloth that is the same everywhere, in the mode whose formula it shares: the loop alone.
IDEAL = ("--cloth", "ideal", "--set", "sensing.indentation_mode=membrane")


class Stiffness(fyd.Case):
    def test_a_nominal_target_is_reached_fast(self):
        # 6 mm deep in the middle the solved cloth gives 0.59 to 0.84 N/mm.
        for target, cloth in ((0.50, "ideal"), (0.60, "ideal"), (0.71, "ideal"), (0.62, "membrane"), (0.70, "membrane"),
                              (0.82, "membrane")):
            where = IDEAL if cloth == "ideal" else ("--cloth", cloth)
            result = self.json("stiffness", "--target", target, *where, "--json")
            self.assertLessEqual(result["settling_s"], 0.6)
            self.assertLessEqual(result["overshoot_pct"], 10)
            self.assertLessEqual(result["steady_error_pct"], 2)
            self.assertIs(result["stable"], True)

    def test_a_softer_cloth_is_learned(self):
        softer = ("stiffness", "--target", 0.45, "--plant-scale", 0.7, *IDEAL, "--json")
        result = self.json(*softer, "--set", "control.measurement_bias=0")
        self.assertLessEqual(result["settling_s"], 3)
        # As shipped, a lasting error of 15 % of the measurement is reckoned with; twice what is beyond it is corrected.
        self.assertLessEqual(self.json(*softer)["steady_error_pct"], 6)
        result = self.json(*softer, "--set", "control.correction=excess")
        self.assertLessEqual(result["steady_error_pct"], 16)
        self.assertGreater(result["steady_error_pct"], 5)
        # On the solved cloth the measurement itself is some per cent off.
        solved = self.json("stiffness", "--target", 0.48, "--plant-scale", 0.7, "--json")
        self.assertLessEqual(solved["steady_error_pct"], 12)

    def test_out_of_reach_is_null_stable_and_told(self):
        result = self.json("stiffness", "--target", 0.9, "--json")
        self.assertIsNone(result["settling_s"])
        self.assertTrue(result["stable"])
        self.assertTrue(result["target_clamped"])
        self.assertAlmostEqual(result["reachable_target_N_per_mm"], 0.84, delta=0.03)
        result = self.json("stiffness", "--target", 0.9, *IDEAL, "--json")
        self.assertAlmostEqual(result["reachable_target_N_per_mm"], 0.715, places=3)

    def test_the_same_seed_gives_the_same_figures_and_the_thesis_others(self):
        unkind = ("--target", 0.6, "--noise", 2, "--delay", 60, "--seed", 5, "--json")
        first = self.json("stiffness", *unkind)
        self.assertEqual(first, self.json("stiffness", *unkind))
        self.assertNotEqual(first, self.json("stiffness", "--controller", "thesis", *unkind))

    def test_the_course_has_a_row_per_millisecond(self):
        self.json("stiffness", "--target", 0.6, "--course", self.path("course.csv"), "--json")
        with open(self.path("course.csv"), encoding="utf-8") as file:
            rows = file.read().splitlines()
        self.assertEqual(rows[0], "time_s,true_N_per_mm,measured_N_per_mm,stretch_deg")
        self.assertEqual(len(rows), 8002)

    def test_wrong_values_are_named(self):
        self.assertIn("--target", self.refused(2, "stiffness"))
        for option, value in (("--target", "nan"), ("--target", "0"), ("--target", "inf")):
            self.assertIn(f"{option} {value}", self.refused(2, "stiffness", option, value))
        for option, value in (("--noise", "-1"), ("--delay", "501"), ("--plant-scale", "9")):
            self.assertIn(f"{option} {value}", self.refused(2, "stiffness", "--target", "0.6", f"{option}={value}"))
            self.assertIn(f"{option} {value}", self.refused(2, "stiffness", "--target", "0.6", f"{option}={value}",
                                                            "--profile", "nowhere.toml"))
        self.assertIn("--seed: -1", self.refused(2, "stiffness", "--target", "0.6", "--seed=-1"))
        for command in (("stiffness", "--target", "0.6"), ("tune",), ("station", "--simulate", "--duration", 0.1)):
            self.assertIn("control.law_", self.refused(2, *command, "--set", "control.law_angle_deg=[1,0]"))
        self.refused(2, "stiffness", "--target", "0.6", "--controller", "fuzzy")
        profile = self.write("p.toml", "[control]\nkp = -1\n")
        self.assertIn("p.toml:2", self.refused(1, "stiffness", "--target", "0.6", "--profile", profile))
        profile = self.write("q.toml", "[control]\nlaw_angle_deg = [20, 45, 45, 90]\n")
        self.assertIn("control.law_angle_deg", self.refused(1, "stiffness", "--target", "0.6", "--profile", profile))


class FormerNames(fyd.Case):
    def test_a_former_name_works_and_the_present_one_is_named(self):
        done = fyd.run("params", "sim.cloth_hysteresis", "--set", "sim.fabric_hysteresis=0.1")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("sim.fabric_hysteresis is called sim.cloth_hysteresis now", done.stderr)
        self.assertIn("sim.cloth_hysteresis = 0.1", done.stdout)
        asked = fyd.run("params", "sim.fabric_hysteresis")
        self.assertIn("sim.fabric_hysteresis is called sim.cloth_hysteresis now", asked.stderr)
        self.assertIn("sim.cloth_hysteresis = 0", asked.stdout)


class Tune(fyd.Case):
    def test_proposes_and_changes_nothing(self):
        proposal = self.json("tune", "--plant-scale", 1.2, "--json")
        self.assertAlmostEqual(proposal["cloth"]["scale"], 1.2, delta=0.08)
        self.assertIs(proposal["applied"], False)
        for side in ("before", "after"):
            self.assertGreater(proposal[side]["ki"], 0)
            self.assertGreaterEqual(proposal[side]["predicted"]["phase_margin_deg"], 60)
            self.assertIs(proposal[side]["simulated"]["stable"], True)

    def test_a_recording_that_says_too_little_is_refused(self):
        rows = "".join(f"{0.01 * i:.2f},40,0.6,1\n" for i in range(500))
        still = self.write("still.csv", "t_s,stretch_measured_deg,stiffness_N_per_mm,stiffness_observable\n" + rows)
        self.assertIn("moves the law by 0.0 %", self.refused(1, "tune", "--recording", still))
        self.assertIn("nothing.csv", self.refused(1, "tune", "--recording", self.path("nothing.csv")))
        for option in ("--plant-scale", "--noise", "--delay", "--friction", "--hysteresis", "--seed"):
            self.assertIn(option, self.refused(2, "tune", "--recording", still, option, 1))
        self.assertIn("--cloth", self.refused(2, "tune", "--recording", still, "--cloth", "membrane"))
        wrong = self.write("wrong.csv", "t_s,stretch_measured_deg\n1,2\n")
        self.assertIn("stiffness_N_per_mm", self.refused(1, "tune", "--recording", wrong))


if __name__ == "__main__":
    unittest.main()
