"""fyd bench stability: ours within its bound on every hard case, and a naive implementation beyond it."""
import json
import math
import unittest

import fyd


def number(value):
    return math.inf if value == "∞" else float(value)


def faults(rows):
    """What is wrong with the bench's rows, a naive one and ours for each case."""
    out = []
    for naive, ours in zip(rows[::2], rows[1::2], strict=True):
        case, most = ours["hard case"], number(ours["ours at most"])
        if (naive["by"], ours["by"]) != ("naive (baseline)", "ours") or naive["hard case"] != case:
            out.append(f"{case}: expected a naive row and ours")
        if not number(ours["error"]) <= most:
            out.append(f"{case}: ours is {ours['error']} {ours['unit']} off, at most {most}")
        if not number(naive["error"]) > max(most, 10.0 * number(ours["error"])):
            out.append(f"{case}: the naive one is only {naive['error']} {naive['unit']} off: not hard")
        if not (naive["how"] and ours["how"] and ours["truth"]):
            out.append(f"{case}: says not what runs and what the truth is")
    return out


@fyd.needs_bench
class Stability(fyd.Case):
    @classmethod
    def setUpClass(cls):
        done = fyd.run("bench", "stability", "--json")
        assert done.returncode == 0, done.stderr
        cls.rows = json.loads(done.stdout)[0]["rows"]

    def test_ours_holds_its_bound_where_a_naive_implementation_does_not(self):
        self.assertEqual(faults(self.rows), [])

    def test_there_are_twenty_cases_and_more_each_once(self):
        cases = [row["hard case"] for row in self.rows[::2]]
        self.assertGreaterEqual(len(cases), 20)
        self.assertEqual(len(cases), len(set(cases)))

    def test_a_worse_result_and_an_easy_case_would_be_found(self):
        worse = [dict(row) for row in self.rows]
        worse[1]["error"] = worse[1]["ours at most"] * 2 + 1e-3
        self.assertRegex("".join(faults(worse)), "ours is")
        easy = [dict(row) for row in self.rows]
        easy[0]["error"] = 0.0
        self.assertRegex("".join(faults(easy)), "not hard")


if __name__ == "__main__":
    unittest.main()
