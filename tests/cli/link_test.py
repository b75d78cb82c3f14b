"""fyd budget and fyd link; a session over FYD Link in two processes."""
import csv
import math
import os
import stat
import unittest

import fyd


class Budget(fyd.Case):
    def test_the_papers_numbers(self):
        # [tele-gesture Eq. 1]: 160 mm / 0.02 mm = 8000 points, 13 bits; [tele-gesture Eq. 2]: 64 kbit/s · 10 ms = 640 bits.
        result = self.json("budget", "--workspace", "160x130x130", "--precision", 0.02, "--flow", 64000, "--period", 10, "--json")
        self.assertEqual(result["points_per_axis"], 8000)
        self.assertEqual(result["bits_per_axis"], 13)
        self.assertEqual(result["max_message_bits"], 640)
        self.assertGreater(result["message_bits"], 39)

    def test_wrong_numbers_are_refused(self):
        for workspace in ("160x130", "160x0x130", "axbxc", "nanx1x1", ""):
            self.assertNotEqual(fyd.run("budget", "--workspace", workspace, "--precision", 0.02, "--flow", 64000,
                                        "--period", 10).returncode, 0, workspace)
        for precision in ("0", "-1", "nan", "1e-300"):
            self.assertNotEqual(fyd.run("budget", "--workspace", "160x130x130", "--precision", precision, "--flow", 64000,
                                        "--period", 10).returncode, 0, precision)


class Keys(fyd.Case):
    def test_a_key_is_private_and_never_written_over(self):
        path = self.path("lab.key")
        self.json("link", "keygen", path, "--json")
        self.assertEqual(stat.S_IMODE(os.stat(path).st_mode), 0o600)
        self.refused(1, "link", "keygen", path)

    def test_a_session_with_the_key_runs_and_one_without_it_does_not(self):
        good, bad = self.path("good.key"), self.path("bad.key")
        self.json("link", "keygen", good, "--json")
        self.json("link", "keygen", bad, "--json")
        port = fyd.free_port()
        station = fyd.Running(self, "station", "--simulate", "--robot", f"link:127.0.0.1:{port}", "--key", good,
                              "--json", "--telemetry", self.path("telemetry.csv"))
        fyd.wait_for_udp("127.0.0.1", port)
        robot = ("sim", "robot", "--link", "--connect", f"127.0.0.1:{port}", "--bind", "127.0.0.2:0", "--json", "--duration")
        self.assertIn("no touchpad with this key", fyd.run(*robot, 1, "--key", bad).stderr)
        self.assertGreater(self.json(*robot, 3, "--key", good)["touches_received"], 50)
        session = station.stop()
        self.assertGreater(session["state_messages_received"], 50)
        with open(self.path("telemetry.csv"), encoding="utf-8") as file:
            told = [float(row["robot_force_N"]) for row in csv.DictReader(file)]
        self.assertGreater(sum(math.isfinite(force) for force in told), 500, "over FYD Link a robot tells its force")
        with open(good, encoding="utf-8") as file:
            secret = max(file.read().split(), key=len)
        self.assertNotIn(secret, fyd.json.dumps(session) + station.log())


if __name__ == "__main__":
    unittest.main()
