"""The touchpad's Modbus ends against independent programs (mbpoll, pymodbus), and whole sessions over real protocols."""
import os
import re
import signal
import socket
import subprocess
import sys

import fyd

PEER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "pymodbus_peer.py")


def peer_python():
    """The interpreter that has Debian's pymodbus, which need not be the first in the path."""
    for python in (sys.executable, "/usr/bin/python3"):
        if subprocess.run([python, "-c", "import pymodbus"], stderr=subprocess.DEVNULL, check=False).returncode == 0:
            return python
    raise RuntimeError("python3-pymodbus is not installed (installer/test.sh does)")


def free_port():
    return fyd.free_port(kind=socket.SOCK_STREAM)


def listens(port):
    with socket.socket() as probe:
        return probe.connect_ex(("127.0.0.1", port)) == 0


class Simulator:
    """fyd sim touchpad; `stop` returns its summary."""

    def __init__(self, case, *options, rtu=False, qbmove=False, camera=False):
        self.port = free_port()
        self.rtu, self.qbmove = case.path("rtu"), case.path("qbmove")
        self.camera_port = free_port()
        arguments = ["sim", "touchpad", "--modbus-tcp", f"127.0.0.1:{self.port}", "--json", *options]
        arguments += ["--modbus-rtu", self.rtu] if rtu else []
        arguments += ["--qbmove", self.qbmove] if qbmove else []
        arguments += ["--camera-mjpeg", f"127.0.0.1:{self.camera_port}"] if camera else []
        self.running = fyd.Running(case, *arguments)
        fyd.wait_for("the simulated touchpad to listen", lambda: listens(self.port))
        if camera:
            fyd.wait_for("the simulated camera to listen", lambda: listens(self.camera_port))
        self.camera = f"http://127.0.0.1:{self.camera_port}/"
        self.tcp = f"modbus-tcp:127.0.0.1:{self.port}"

    def stop(self):
        return self.running.stop(signal.SIGTERM)


def mbpoll(*arguments):
    done = subprocess.run(["mbpoll", "-0", "-1", "-a", "1", *map(str, arguments)], capture_output=True, text=True, timeout=fyd.PATIENCE, check=False)
    values = [int(v, 0) for v in re.findall(r"^\[\d+\]:\s+(\S+)", done.stdout, re.M)]
    return values, done.stdout + done.stderr


class OurServer(fyd.Case):
    def test_mbpoll_reads_it_over_tcp_and_over_a_serial_line(self):
        simulator = Simulator(self, rtu=True)
        for line in (["-m", "tcp", "-p", simulator.port, "127.0.0.1"], ["-m", "rtu", "-b", "115200", "-P", "none", simulator.rtu]):
            *how, where = line
            values, _ = mbpoll(*how, "-t", "4:hex", "-r", 0, "-c", 15, where)
            self.assertEqual(values[:3], [0x4659, 0x4454, 0x0100])
            self.assertEqual(values[12:], [3, 2, 32])
            values, _ = mbpoll(*how, "-t", "4", "-r", 64, "-c", 26, where)
            self.assertEqual(len(values), 26)
            self.assertEqual(values[0], values[25], "the sequence brackets the block")
            _, said = mbpoll(*how, "-t", "4", "-r", 200, "-c", 2, where)
            self.assertIn("Illegal data address", said)

    def test_functions_that_it_does_not_know_leave_the_next_request_whole(self):
        simulator = Simulator(self)
        good, fydt = "0002 0000 0006 01 03 0000 0002", "0002 0000 0007 01 03 04 46594454"
        for first, answer in (("0001 0000 0005 01 2B 0E0100", "0001 0000 0003 01 AB 01"),  # the device's identity
                              ("0001 0000 0004 01 41 0102", "0001 0000 0003 01 C1 01"),
                              ("0001 0000 0006 01 83 0000 0002", "")):  # an exception's answer is no request
            with socket.create_connection(("127.0.0.1", simulator.port), fyd.PATIENCE) as line:
                line.sendall(bytes.fromhex(first + good))
                expected = bytes.fromhex(answer + fydt)
                got = b""
                while len(got) < len(expected) and (more := line.recv(100)):
                    got += more
                self.assertEqual(got, expected, first)

    def test_a_request_of_another_length_than_it_says_ends_the_connection(self):
        simulator = Simulator(self)
        for length in ("0000", "0005", "0007", "FFFF"):
            with socket.create_connection(("127.0.0.1", simulator.port), fyd.PATIENCE) as line:
                line.sendall(bytes.fromhex("0001 0000" + length + "01 03 0000 0002"))
                self.assertEqual(line.recv(100), b"", length)

    def test_pymodbus_gets_what_the_map_says_and_the_right_exceptions(self):
        simulator = Simulator(self)
        done = subprocess.run([peer_python(), PEER, "client", "127.0.0.1", str(simulator.port)], capture_output=True, text=True, timeout=fyd.PATIENCE, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        found = fyd.json.loads(done.stdout)
        self.assertEqual(found["identity"][:3], [0x4659, 0x4454, 0x0100])
        self.assertEqual(found["state"][1], 0xBEEF, "the nonce written comes back in the same transaction")
        self.assertEqual(found["state"][0], found["state"][25])
        self.assertTrue(-0.1 < found["bridge"] < 7.8, found["bridge"])
        self.assertTrue(all(0 < code < 4096 for code in found["state"][10:13]))
        self.assertEqual(found["coils"], 1)
        self.assertEqual(found["hole"], 2)
        self.assertEqual(found["past_the_end"], 2)
        self.assertEqual(found["read_only"], 2)
        self.assertEqual(found["watchdog_too_short"], 3)
        self.assertEqual(found["watchdog"], 0)
        self.assertEqual(found["watchdog_reads"], [200])
        self.assertEqual(found["second_master"], 6)
        self.assertEqual(found["second_reader"], [0x4659, 0x4454])
        self.assertEqual(simulator.stop()["refused_writes"], 1)


class OurClient(fyd.Case):
    def ask(self, scenario):
        port = free_port()
        server = subprocess.Popen([peer_python(), PEER, "server", str(port), scenario], stderr=subprocess.DEVNULL)
        self.addCleanup(server.wait)
        self.addCleanup(server.kill)
        fyd.wait_for("the touchpad made with pymodbus to listen", lambda: listens(port))
        done = fyd.run("devices", "--json", "--touchpad", f"modbus-tcp:127.0.0.1:{port}", "--set", "device.response_timeout_ms=2000")
        return done.returncode, fyd.json.loads(done.stdout)["asked"][0]

    def test_it_reads_a_touchpad_made_with_pymodbus(self):
        code, answer = self.ask("good")
        self.assertEqual(code, 0, answer)
        self.assertIn("PYMODBUS, firmware 2.3", answer["description"])
        self.assertEqual(answer["values"]["ir_counts"], [1000, 2000, 3000])
        self.assertEqual(answer["values"]["bridge_mV_per_V"], 0.25)
        self.assertEqual(answer["values"]["motors"], "switch-on disabled")

    def test_it_names_what_is_wrong_with_one(self):
        for scenario, said in (("wrong-magic", "not a touchpad"), ("wrong-version", "register map 7.0"), ("short", "exception 2")):
            code, answer = self.ask(scenario)
            self.assertEqual(code, 1)
            self.assertIn(said, answer["problem"])


    def test_one_that_complains_answers(self):
        code, answer = self.ask("warm")
        self.assertEqual(code, 1)
        self.assertIs(answer["answers"], True)
        self.assertIn("let them cool", answer["problem"])
        self.assertIn("PYMODBUS", answer["description"])


class Devices(fyd.Case):
    def test_it_says_why_something_does_not_answer(self):
        done = fyd.run("devices", "--json", "--touchpad", f"modbus-tcp:127.0.0.1:{free_port()}", "--motors", "qbmove:" + self.path("none"))
        self.assertEqual(done.returncode, 1)
        asked = fyd.json.loads(done.stdout)["asked"]
        self.assertIn("nothing listens there", asked[0]["problem"])
        self.assertIn("plugged in", asked[1]["problem"])
        self.assertIn("HOST:PORT", self.refused(2, "devices", "--touchpad", "modbus-tcp:"))
        self.assertIn("--motors: motors 'qbmove:'", self.refused(2, "devices", "--motors", "qbmove:"))
        self.assertIn("--map", self.refused(2, "devices", "--map", "--json").replace("--json", ""))

    def test_all_words_are_judged_before_the_first_device_is_asked(self):
        with socket.create_server(("127.0.0.1", 0)) as touchpad:
            touchpad.settimeout(0.5)
            address = f"modbus-tcp:127.0.0.1:{touchpad.getsockname()[1]}"
            self.assertIn("maxon", self.refused(2, "devices", "--touchpad", address, "--motors", "maxon"))
            with self.assertRaises(TimeoutError):
                touchpad.accept()

    def test_a_board_that_is_named_twice_is_asked_twice(self):
        simulator = Simulator(self, qbmove=True)
        os.symlink(simulator.qbmove, self.path("link"))
        names = ["qbmove:" + simulator.qbmove, "qbmove:" + self.path("link")]
        asked = self.json("devices", "--json", "--set", "device.qbmove_timeout_ms=200", "--motors", names[0], "--motors", names[1])["asked"]
        self.assertEqual([(each["address"], each["answers"]) for each in asked], [(name, True) for name in names])

    def test_it_asks_a_camera_for_a_picture_and_says_what_became_of_its_controls(self):
        simulator = Simulator(self, camera=True)
        done = fyd.run("devices", "--json", "--camera", simulator.camera, "--camera", self.path("none.avi"), "--set", "device.camera_brightness_percent=100")
        self.assertEqual(done.returncode, 1)
        asked = fyd.json.loads(done.stdout)["asked"]
        self.assertTrue(asked[0]["answers"], asked[0])
        self.assertEqual(asked[0]["values"]["picture"], "320 × 240")
        self.assertEqual(asked[0]["values"]["brightness"], "a stream has none")
        self.assertIn("no such file or folder", asked[1]["problem"])

    def test_a_serial_number_that_nothing_has_is_named(self):
        done = fyd.run("devices", "--json", "--motors", "qbmove:id=NOBODY", "--camera", "id=NOBODY")
        asked = fyd.json.loads(done.stdout)["asked"]
        self.assertIn("none is plugged in", asked[0]["problem"])
        self.assertIn("none is plugged in", asked[1]["problem"])

    def test_the_manual_prints_the_map_that_the_code_declares(self):
        page = os.path.join(os.environ["FYD_SOURCE_DIR"], "resources", "manual", "modbus.md")
        with open(page, encoding="utf-8") as file:
            text = file.read()
        table = fyd.run("devices", "--map").stdout
        self.assertIn(table.strip(), text)
        self.assertEqual(table, fyd.run("sim", "touchpad", "--print-map").stdout)


def rendered_long_enough(summary, seconds, result):
    """A machine that held the session says nothing of how long the motors would have been on."""
    if summary["motors_on_s"] <= seconds and result["state"] == "Held":
        raise fyd.BusyMachine(f"held after {summary['motors_on_s']:.1f} s: {result['reason']}")
    assert summary["motors_on_s"] > seconds, summary


class Sessions(fyd.Case):
    def session(self, *options, seconds=4):
        return self.json("station", "--duration", seconds, "--json", *options)

    @fyd.some_tries
    def test_modbus_and_a_camera_stream_close_the_loop(self):
        simulator = Simulator(self, camera=True)
        result = self.session("--touchpad", simulator.tcp, "--camera", simulator.camera, seconds=7)
        self.assertIn(result["state"], ("Active", "Held"))
        self.assertIsNone(result["finger_error_mm_rms"], "nobody knows the truth of a real touchpad")
        self.assertGreater(result["contact_fraction"], 0.2)
        self.assertIn("FYD-SIM-0001", result["parts"][0]["description"])
        summary = simulator.stop()
        rendered_long_enough(summary, 1.0, result)
        self.assertAlmostEqual(summary["vibration_peak_percent"], result["pwm_abs_max"], delta=10)
        self.assertFalse(summary["motors_on"], "the station's end switches them off")

    @fyd.some_tries
    def test_a_serial_touchpad_with_the_original_motor_board(self):
        simulator = Simulator(self, "--qbmove-vibration", "145", rtu=True, qbmove=True, camera=True)
        result = self.session("--touchpad", "modbus-rtu:" + simulator.rtu, "--motors", "qbmove:" + simulator.qbmove,
                              "--camera", simulator.camera, "--set", "device.qbmove_vibration_opcode=145",
                              "--set", "device.qbmove_timeout_ms=20")
        self.assertIn(result["state"], ("Active", "Held"))
        summary = simulator.stop()
        self.assertGreater(summary["motor_board_frames"], 100)
        rendered_long_enough(summary, 0.5, result)

    @fyd.some_tries
    def test_a_touchpad_that_vanishes_holds_and_its_return_does_not_arm(self):
        simulator, telemetry = Simulator(self, camera=True), fyd.Telemetry(self)
        station = fyd.Running(self, "station", "--touchpad", simulator.tcp, "--camera", simulator.camera,
                              "--telemetry", telemetry.path, "--json")
        station.await_log("Active")
        station.held_early()
        simulator.running.process.send_signal(signal.SIGSTOP)
        station.await_log("Held")
        simulator.running.process.send_signal(signal.SIGCONT)
        telemetry.wait_for("the touchpad's return", lambda row: row["motors_age_ms"] < 20)
        telemetry.pass_steps(500)
        result = station.stop()
        self.assertEqual(result["state"], "Held")
        self.assertEqual(station.log().count("Active"), 1)
        self.assertFalse(simulator.stop()["motors_on"])

    def test_a_touchpad_uses_its_own_calibration_only(self):
        profile, rows = self.path("lab.toml"), "".join(f"{(n + 0.2) / 9.0},{n}\n" for n in (0, 1, 2, 3, 4, 5, 4, 2, 0))
        samples = self.write("cell.csv", "value,force_N\n" + rows)
        calibrate = ("calibrate", "load-cell", samples, "--profile", profile, "--json", "--touchpad")

        def said(simulator):
            source = (simulator.tcp, "--camera", simulator.camera) if simulator else ("simulated",)
            done = fyd.run("station", "--touchpad", *source, "--robot", "none", "--profile", profile, "--duration", 0.5, "--json")
            self.assertEqual(done.returncode, 0, done.stderr)
            return done.stderr

        first = Simulator(self, "--serial", "A7", camera=True)
        self.json(*calibrate, "simulated")
        self.assertTrue(os.path.exists(self.path("lab.simulated.toml")))
        with open(profile, encoding="utf-8") as file:
            self.assertIn("force_slope_g = 1004.8805", file.read(), "what the simulation found is not what a real one loads")
        self.assertNotIn("calibrated on", said(first))
        self.json(*calibrate, "serial:A7")
        with open(profile, encoding="utf-8") as file:
            text = file.read()
        self.assertIn('touchpad = "serial:A7"', text.replace("'", '"'))
        self.assertNotIn("force_slope_g = 1004.8805", text)
        self.assertNotIn("calibrated on", said(first))
        self.assertNotIn("calibrated on", said(None))
        other = Simulator(self, "--serial", "B2", camera=True)
        warning = said(other)
        self.assertIn("calibrated on the touchpad with serial number A7, and this is the touchpad with serial number B2", warning)
        self.assertIn("Load cell", warning)

    def test_wrong_choices_are_named(self):
        self.assertIn("--touchpad", self.refused(2, "station"))
        self.assertIn("--simulate", self.refused(2, "station", "--simulate", "--touchpad", "modbus-tcp:127.0.0.1:1"))
        self.assertIn("camera", self.refused(2, "station", "--touchpad", "modbus-tcp:127.0.0.1:1"))
        self.assertIn("qbmove:TTY", self.refused(2, "station", "--simulate", "--motors", "maxon"))
        self.assertIn("late-reply", self.refused(2, "sim", "touchpad", "--modbus-tcp", "127.0.0.1:0", "--fault", "noise@1"))
        self.assertIn("--modbus-rtu", self.refused(2, "sim", "touchpad"))
        port = self.path("port")
        self.assertIn(port, self.refused(2, "sim", "touchpad", "--modbus-rtu", port, "--qbmove", port))
        for option, of in (("--baud", "--modbus-rtu"), ("--qbmove-baud", "--qbmove")):
            for baud in ("12345", "-5", "0"):
                self.assertIn(f"{option}: {baud}: no speed", self.refused(2, "sim", "touchpad", of, port, f"{option}={baud}"))

    def test_a_line_that_another_simulator_made_is_its_own(self):
        first = Simulator(self, rtu=True)
        again = ("sim", "touchpad", "--modbus-rtu", first.rtu, "--duration", 0.1)
        self.assertIn(first.rtu, self.refused(1, *again))
        first.running.process.kill()
        first.running.process.wait()
        self.assertTrue(os.path.islink(first.rtu), "nobody took it away: this test shows nothing")
        self.json(*again, "--json")

    def test_a_finger_may_come_through_a_pipe(self):
        for text in ("t_s,x_mm,y_mm,z_mm\n0,0,0,-1\n1,5,0,-1\n",
                     'format = "FYD gesture 1"\nname = "a"\n---\nt_s,x_mm,y_mm,depth_mm\n0,0,0,1\n1,5,0,1\n'):
            self.of_a_pipe(text, "sim", "touchpad", "--modbus-tcp", "127.0.0.1:0", "--finger", "/dev/stdin",
                           "--duration", 0.1, "--json")


if __name__ == "__main__":
    fyd.unittest.main()
