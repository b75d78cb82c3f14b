"""fyd station: whole sessions, and every bad input named."""
import contextlib
import csv
import math
import os
import re
import signal
import socket
import subprocess
import threading
import time
import unittest

import fyd

SESSION = ("station", "--simulate")


class Sessions(fyd.Case):
    def test_a_recorded_hand_drives_a_whole_session(self):
        finger = os.path.join(fyd.DATA, "hand_motion", "index_tip.csv")
        out = self.path("telemetry.csv")
        result = self.json(*SESSION, "--duration", 5, "--finger", finger, "--telemetry", out, "--json")
        self.assertEqual(result["state"], "Active")
        self.assertGreater(result["steps"], 1000)
        self.assertGreater(result["contact_fraction"], 0.2)
        self.assertLess(result["contact_fraction"], 1.0)
        self.assertLess(result["finger_error_mm_rms"], 0.5)
        self.assertLess(result["indentation_error_mm_rms"], 3.0)
        self.assertEqual(result["touch_messages_sent"], result["state_messages_received"])
        self.assertGreater(result["state_messages_received"], 100)
        self.assertLessEqual(result["pwm_abs_max"], 100)
        self.assertAlmostEqual(result["stiffness_target_N_per_mm"], 0.62, delta=0.03)
        for key in ("missed_cycles", "step_ns_p50", "step_ns_p99", "stiffness_measured_N_per_mm"):
            self.assertIn(key, result)
        with open(out, encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertGreater(len(rows), 1000)
        times = [float(row["t_s"]) for row in rows]
        self.assertEqual(times, sorted(times))

    def test_what_the_finger_feels_is_a_figure_of_the_session(self):
        felt = self.json(*SESSION, "--duration", 3, "--json")["vibration"]
        # How much is felt is judged in virtual time (step_session_test): a loaded machine may hold this session.
        self.assertEqual(felt["plant"], "not identified")
        self.assertEqual(set(felt), {"plant", "felt_g_rms", "felt_level_dB", "felt_g_rms_simulated",
                                     "duty_rms_percent", "dead_share", "clipped_share"})

    def test_where_nothing_is_felt_the_level_ends_where_that_of_the_telemetry_does(self):
        felt = self.json(*SESSION, "--robot", "none", "--duration", 3, "--json")["vibration"]
        if felt["felt_g_rms"] is None:
            self.skipTest("a loaded machine held the session before the finger touched")
        self.assertAlmostEqual(felt["felt_level_dB"], -120)

    def test_the_energy_of_the_finger_and_what_the_robot_tells_stand_beside_the_target(self):
        for coupling in ("direct", "model"):
            out = self.path(coupling + ".csv")
            result = self.json(*SESSION, "--duration", 6, "--telemetry", out, "--json", "--set", "pipeline.coupling=" + coupling)
            self.assertEqual(result["state"], "Active")
            self.assertEqual(result["coupling"], coupling)
            with open(out, encoding="utf-8") as file:
                rows = list(csv.DictReader(file))
            told = [float(row["robot_stiffness_N_per_mm"]) for row in rows]
            self.assertEqual(told[-1], result["robot_stiffness_N_per_mm"])
            self.assertTrue(all(math.isnan(float(row["robot_force_N"])) for row in rows), "the classic protocol has no place for it")
            pressed = [float(row["finger_energy_mJ"]) for row in rows if row["contact"] == "1" and row["state"] == "3"]
            self.assertGreater(max(pressed), 1.0)
            self.assertLessEqual(result["least_finger_energy_mJ"], min(pressed) + 1e-9)
            # A robot whose material stays the same: nothing to withhold, by whichever coupling.
            self.assertLess(abs(result["coupling_withheld_mJ"]), 0.5)

    def test_where_everything_is_simulated_the_clock_waits_for_a_late_computer(self):
        telemetry, recording = fyd.Telemetry(self), self.path("late.h5")
        session = fyd.Running(self, *SESSION, "--telemetry", telemetry.path, "--record", recording, "--json")
        session.await_log("Active")
        session.process.send_signal(signal.SIGSTOP)  # the whole computer stands still, as far as the session sees
        time.sleep(1.0)
        session.process.send_signal(signal.SIGCONT)
        telemetry.pass_steps(1500)
        result = session.stop()
        self.assertEqual((result["state"], result["reason"]), ("Active", ""))
        self.assertEqual(result["missed_cycles"], 0)
        self.assertEqual(result["lateness"], "waits")
        self.assertGreater(result["waited_s"], 0.8)
        self.assertEqual(self.json("session", "info", recording, "--json")["lateness"], "waits")
        replayed = self.json("session", "replay", recording, "--json")
        self.assertEqual(replayed["lateness"], "waits")
        self.assertTrue(replayed["identical"])

    def test_without_a_robot_the_target_is_set_by_hand(self):
        result = self.json(*SESSION, "--robot", "none", "--duration", 1, "--json", "--set", "pipeline.hand_target_N_per_mm=0.7")
        self.assertEqual(result["stiffness_target_N_per_mm"], 0.7)
        self.assertEqual(result["state_messages_received"], 0)

    def test_a_camera_that_announces_a_picture_of_gigabytes_gets_no_room_for_it(self):
        block = b"\xff\xd8" + bytes(65_534)
        taken = []  # bytes, of each connection

        def endless(client, number):
            with client, contextlib.suppress(OSError):
                client.recv(4096)
                client.sendall(b"HTTP/1.0 200 OK\r\nContent-Type: multipart/x-mixed-replace; boundary=b\r\n\r\n"
                               b"--b\r\nContent-Type: image/jpeg\r\nContent-Length: 2000000000\r\n\r\n")
                while taken[number] < 1e9:
                    client.sendall(block)
                    taken[number] += len(block)

        def serve():
            with contextlib.suppress(OSError):  # closed, at the end
                while True:
                    client = server.accept()[0]
                    taken.append(0)
                    threading.Thread(target=endless, args=(client, len(taken) - 1), daemon=True).start()

        with socket.create_server(("127.0.0.1", 0)) as server:
            threading.Thread(target=serve, daemon=True).start()
            address = f"http://127.0.0.1:{server.getsockname()[1]}/"
            station = subprocess.Popen([fyd.PROGRAM, *SESSION, "--robot", "none", "--catalogue", "none", "--camera", address],
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            try:
                fyd.wait_for("300 MB to be taken", lambda: sum(taken) > 300e6)
            finally:
                station.terminate()
                _, status, used = os.wait4(station.pid, 0)
                station.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(station.returncode, 0)
        self.assertLess(max(taken) / 1e6, 200, "MB of one picture")
        self.assertLess(used.ru_maxrss / 1024, 1000, "MB")

    def test_a_missing_camera_is_shown_and_the_session_never_arms(self):
        result = self.json(*SESSION, "--camera", "nowhere.avi", "--duration", 1, "--json")
        self.assertEqual(result["state"], "Connected")
        camera = next(part for part in result["parts"] if part["name"] == "Camera")
        self.assertFalse(camera["ok"])
        self.assertIn("nowhere.avi", camera["problem"])

    def test_the_option_of_old_command_lines_is_taken_and_said_to_be_of_no_use(self):
        done = fyd.run(*SESSION, "--headless", "--duration", 0.5, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertGreater(fyd.json.loads(done.stdout)["steps"], 0)
        self.assertIn("--headless is not needed", done.stderr)
        self.assertNotIn("--headless", fyd.run("station", "--help").stdout)

    def test_what_it_says_with_nowhere_to_say_it_reaches_no_file(self):
        out = self.path("telemetry.csv")
        done = subprocess.run(["bash", "-c", 'exec "$0" "$@" <&- >&- 2>&-', fyd.PROGRAM, *SESSION, "--duration", "2",
                               "--telemetry", out], check=False, timeout=fyd.PATIENCE)
        self.assertEqual(done.returncode, 1, "its result could not be printed")
        with open(out, encoding="utf-8") as file:
            widths = {line.count(",") for line in file}
        self.assertEqual(len(widths), 1, "each line is a row")

    def test_an_interrupt_ends_it_with_its_result(self):
        session = fyd.Running(self, *SESSION, "--json")
        session.await_log("Ready")
        self.assertGreater(session.stop()["steps"], 0)


class TwoProcesses(fyd.Case):
    @fyd.some_tries
    def test_a_robot_in_its_own_process_holds_a_session_without_a_missed_reply(self):
        port = fyd.free_port()
        address = f"127.0.0.1:{port}"
        station = fyd.Running(self, *SESSION, "--robot", "classic:" + address, "--json")
        fyd.wait_for_udp("127.0.0.1", port)
        # A second for a reply, as the authors' wireless robot: a busy machine's pauses are no missed replies.
        robot = self.json("sim", "robot", "--connect", address, "--bind", "127.0.0.2:0", "--waits", "wireless",
                          "--duration", 4, "--json")
        station.await_log("Held")
        session = station.stop()
        self.assertGreater(robot["states_sent"], 500)
        self.assertEqual(robot["missed_replies"], 0)
        self.assertEqual(session["touch_messages_sent"], session["state_messages_received"])
        self.assertGreater(session["state_messages_received"], 500)
        fyd.not_held_by_the_machine(session)
        self.assertEqual(session["state"], "Held", "the robot went away while rendering: latched")
        self.assertIn("robot", session["reason"])

    def test_beside_a_robot_of_another_process_a_late_computer_is_a_fault_and_called_so(self):
        port = fyd.free_port()
        address = f"127.0.0.1:{port}"
        recording = self.path("late.h5")
        station = fyd.Running(self, *SESSION, "--robot", "classic:" + address, "--record", recording, "--json")
        fyd.wait_for_udp("127.0.0.1", port)  # the authors' wireless robot says its ACK once
        robot = fyd.Running(self, "sim", "robot", "--connect", address, "--waits", "wireless", "--json")
        station.await_log("Active")
        station.process.send_signal(signal.SIGSTOP)
        time.sleep(0.7)
        station.process.send_signal(signal.SIGCONT)
        station.await_log("Held")
        fyd.wait_for("the computer to be named", lambda: "this computer was late" in station.log())
        self.assertNotIn("cable", station.log())
        result = station.stop()
        robot.stop()
        self.assertEqual(result["state"], "Held")
        self.assertEqual((result["lateness"], result["waited_s"]), ("fault", 0))
        self.assertEqual(self.json("session", "info", recording, "--json")["lateness"], "fault")

    def test_a_taken_port_is_named(self):
        port = fyd.free_port()
        fyd.Running(self, *SESSION, "--robot", f"classic:127.0.0.1:{port}")
        fyd.wait_for_udp("127.0.0.1", port)
        self.assertIn(f"127.0.0.1:{port}", self.refused(1, *SESSION, "--robot", f"classic:127.0.0.1:{port}", "--duration", 1))


class BadInput(fyd.Case):
    def finger(self, text):
        return self.refused(1, *SESSION, "--duration", 1, "--finger", self.write("finger.csv", text))

    def test_a_finger_recording_is_refused_with_file_and_line(self):
        self.assertIn("no column 'z_mm'", self.finger("t_s,x_mm,y_mm\n0,1,2\n"))
        self.assertIn("finger.csv:3: column x_mm: 'wide' is not a number", self.finger("t_s,x_mm,y_mm,z_mm\n0,1,2,3\n1,wide,2,3\n"))
        self.assertIn("finger.csv:3", self.finger("t_s,x_mm,y_mm,z_mm\n0,1,2,3\n1,nan,2,3\n"))
        self.assertIn("finger.csv:3", self.finger("t_s,x_mm,y_mm,z_mm\n1,1,2,3\n0,1,2,3\n"))
        self.assertIn("no rows", self.finger("t_s,x_mm,y_mm,z_mm\n"))
        self.assertIn("empty", self.finger(""))

    def test_a_row_of_nan_is_a_lifted_finger(self):
        path = self.write("finger.csv", "t_s,x_mm,y_mm,z_mm\n0,nan,nan,nan\n100,nan,nan,nan\n")
        self.assertEqual(self.json(*SESSION, "--duration", 1, "--finger", path, "--json")["contact_fraction"], 0)

    def test_a_million_rows_load(self):
        rows = "".join(f"{i / 1000:.3f},{i % 40},{i % 25},{-(i % 8)}\n" for i in range(1_000_000))
        path = self.write("finger.csv", "t_s,x_mm,y_mm,z_mm\n" + rows)
        self.assertIn("steps", self.json(*SESSION, "--duration", 1, "--finger", path, "--json"))

    def test_wrong_usage_exits_with_2(self):
        self.refused(2, "station", "--duration", "soon")
        self.refused(2, *SESSION, "--set", "control.kp")
        self.refused(2, *SESSION, "--set", "control.nothing=1")
        self.assertIn("control.kp", self.refused(2, *SESSION, "--set", "control.kp=nan"))
        self.assertIn("robby", self.refused(2, *SESSION, "--robot", "robby"))
        self.refused(2, "nothing")
        self.refused(2)

    def test_a_failed_operation_exits_with_1(self):
        self.assertIn("nowhere.toml", self.refused(1, *SESSION, "--profile", "nowhere.toml"))
        self.assertIn("/proc/nowhere.csv", self.refused(1, *SESSION, "--duration", 1, "--telemetry", "/proc/nowhere.csv"))

    def test_a_session_that_does_not_begin_leaves_nothing_and_destroys_nothing(self):
        record = ("--duration", 1, "--record", self.path("a.h5"))
        self.assertIn("/nowhere/t.csv", self.refused(1, *SESSION, *record, "--telemetry", "/nowhere/t.csv"))
        kept, nowhere = self.write("kept.csv", "mine"), ("--duration", 1, "--record", "/nowhere/a.h5")
        self.assertIn("/nowhere: ", self.refused(1, *SESSION, *nowhere, "--telemetry", kept))
        self.assertIn("/nowhere: ", self.refused(1, *SESSION, *nowhere, "--telemetry", self.path("new.csv")))
        self.assertEqual(os.listdir(self.folder), ["kept.csv"])
        with open(kept, encoding="utf-8") as file:
            self.assertEqual(file.read(), "mine")
        self.json(*SESSION, "--duration", 1, "--telemetry", kept, "--json")
        with open(kept, encoding="utf-8") as file:
            self.assertTrue(file.readline().startswith("t_s,"), "nothing of the old file stays")


class Parameters(fyd.Case):
    def test_every_parameter_is_listed_with_unit_range_default_and_help(self):
        for parameter in self.json("params", "--json"):
            self.assertRegex(parameter["id"], r"^[a-z]+\.[a-zA-Z0-9_]+$")
            self.assertTrue(parameter["help"])
            self.assertTrue(parameter["unit"])

    def test_a_profile_is_written_and_read_back(self):
        path = self.path("mine.toml")
        self.json("params", "--set", "control.kp=0.25", "--save", path, "--json")
        kp = self.json("params", "control.kp", "--profile", path, "--json")
        self.assertEqual(kp[0]["value"], "0.25")

    def test_a_parameter_that_there_is_not_is_refused_before_anything_is_written(self):
        self.assertIn("'nosuch'", self.refused(2, "params", "nosuch", "--save", self.path("p.toml")))
        self.assertEqual(os.listdir(self.folder), [])
        self.assertIn("'nosuch'", self.refused(2, "params", "nosuch", "--markdown"))
        *_, row = fyd.run("params", "control.kp", "--markdown").stdout.splitlines()
        self.assertTrue(row.startswith("| `control.kp` |"), row)

    def test_a_setting_must_agree_with_the_values_of_the_touchpad_that_is_used(self):
        profile = self.write("lab.toml", '[calibration]\ntouchpad = "serial:A7"\n[control]\nlaw_angle_deg = [20, 45, 60, 75, 90]\n'
                                         "law_stiffness_N_per_mm = [0.5, 0.55, 0.6, 0.65, 0.7]\n")
        self.write("lab.simulated.toml", "[control]\nlaw_angle_deg = [20, 45, 60, 90]\nlaw_stiffness_N_per_mm = [0.5, 0.55, 0.65, 0.7]\n")
        session = (*SESSION, "--profile", profile, "--robot", "none", "--duration", 0.2, "--set")
        self.json(*session, "control.law_stiffness_N_per_mm=[0.4,0.5,0.6,0.7]", "--json")
        self.assertIn("--set: control.law_stiffness_N_per_mm: 5 values for 4 angles",
                      self.refused(2, *session, "control.law_stiffness_N_per_mm=[0.4,0.5,0.6,0.65,0.7]"))

    def test_a_wrong_profile_is_refused_with_line_and_range(self):
        path = self.write("wrong.toml", "[control]\nkp = -1.0\n")
        self.assertRegex(self.refused(1, "params", "--profile", path), re.escape("wrong.toml:2: control.kp = -1: expected a number from 0"))
        half = self.write("half.toml", "[control]\nkp = ")
        self.assertIn("half.toml:2", self.refused(1, "params", "--profile", half))


if __name__ == "__main__":
    unittest.main()
