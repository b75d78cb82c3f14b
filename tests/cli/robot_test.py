"""fyd robot, fyd sim krc and fyd sim network: processes that meet over real sockets, and every wrong option named."""
import socket
import time
import unittest

import fyd


class Processes(fyd.Case):
    def start(self, *arguments):
        return fyd.Running(self, *arguments)

    def touchpad(self, touch=b"?0'00010:0'00005:1'00001:0'05000.\n"):
        """A touchpad of few lines: answers every ACK with the info and every state with one touch.
        Returns its address, and what serves as long as a robot runs and returns the states it sent."""
        answering = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        answering.bind(("127.0.0.1", 0))
        answering.settimeout(0.05)
        self.addCleanup(answering.close)

        def serve(robot):
            states = []
            until = time.monotonic() + fyd.PATIENCE
            while robot.runs():
                self.assertLess(time.monotonic(), until, f"waited {fyd.PATIENCE} s for the robot's end in vain: {robot.log()}")
                try:
                    packet, caller = answering.recvfrom(2000)
                except TimeoutError:
                    continue
                if packet.startswith(b"ACK"):
                    for part in (b"00005", b"board", b"^010^0'00000^0'00000"):
                        answering.sendto(part, caller)
                elif packet.startswith(b"?"):
                    states.append(packet)
                    answering.sendto(touch, caller)
            return states

        return f"127.0.0.1:{answering.getsockname()[1]}", serve


class Arm(Processes):
    def test_a_simulated_arm_follows_the_touch_within_its_limits(self):
        address, serve = self.touchpad()
        robot = self.start("robot", "--connect", address, "--bind", "127.0.0.2:0", "--stiffness", 0.6, "--duration", 2, "--scale", "2,1", "--workspace", "15,25,70", "--json")
        states = serve(robot)
        result = robot.result()
        self.assertGreater(len(states), 50)
        self.assertEqual(result["probe"], "measured")
        self.assertAlmostEqual(result["stiffness_N_per_mm"], 0.6, delta=0.02)
        self.assertAlmostEqual(result["position_mm"][0], 15, delta=0.5, msg="twice 10 mm, held at the workspace's edge")
        self.assertAlmostEqual(result["position_mm"][1], 10, delta=0.5, msg="twice 5 mm")
        self.assertEqual(result["robot_errors"], 0)

    def test_without_a_probe_the_known_stiffness_is_told(self):
        address, serve = self.touchpad()
        robot = self.start("robot", "--connect", address, "--bind", "127.0.0.2:0", "--no-probe", "--known-stiffness", 0.4321, "--duration", 1, "--json")
        states = serve(robot)
        self.assertEqual(robot.result()["probe"], "skipped")
        self.assertIn(b":0'04321.\n", states[-1])


class Kuka(Processes):
    @fyd.some_tries
    def test_robot_end_and_controller_hold_a_session_as_two_processes(self):
        fri = f"127.0.0.1:{fyd.free_port()}"
        address, serve = self.touchpad()
        krc = self.start("sim", "krc", "--remote", fri, "--period", 16, "--monitor-for", 0.2, "--stiffness", 0.6, "--json")
        robot = self.start("robot", "--connect", address, "--bind", "127.0.0.2:0", "--arm", "kuka:" + fri, "--probe-dwell", 0.25, "--duration", 8, "--json")
        states = serve(robot)
        controller = krc.stop()
        self.assertEqual(controller["leaps"], 0, "else the arm itself ended the command mode")
        never_followed = robot.process.returncode != 0 and "link quality" in robot.log()
        arm = None if never_followed else robot.result()
        # Entered once and never left before the robot end's own end: all that is judged below was one stretch.
        if never_followed or controller["command_entries"] > 1 or arm["arm"]["mode"] != "command":
            raise fyd.BusyMachine("a machine that stands still loses the link quality, rightly")
        self.assertEqual(arm["probe"], "measured")
        self.assertAlmostEqual(arm["stiffness_N_per_mm"], 0.6, delta=0.03)
        self.assertGreater(len(states), 100)
        self.assertAlmostEqual(arm["position_mm"][0], 10, delta=0.5)
        self.assertAlmostEqual(arm["position_mm"][1], 5, delta=0.5)
        self.assertEqual(arm["arm"]["mode"], "command")
        self.assertEqual(arm["arm"]["measurements"], arm["arm"]["answers"])
        self.assertEqual(arm["arm"]["impossible_measurements"], 0)
        self.assertEqual((controller["leaps"], controller["wrong_mirrors"], controller["wrong_flags"], controller["wrong_echoes"]), (0, 0, 0, 0))
        self.assertEqual(controller["stiffness_N_per_m"], 1000)
        self.assertAlmostEqual(controller["position_mm"][0], 10, delta=0.5)

    def test_a_controller_that_stays_in_monitor_mode_is_said_in_words(self):
        fri = f"127.0.0.1:{fyd.free_port()}"
        krc = self.start("sim", "krc", "--remote", fri, "--monitor-for", 1000, "--json")
        robot = fyd.run("robot", "--connect", "127.0.0.1:9", "--bind", "127.0.0.2:0", "--arm", "kuka:" + fri, "--duration", 1.5)
        self.assertEqual(robot.returncode, 1)
        self.assertIn("KRC in monitor mode", robot.stderr)
        self.assertEqual(krc.stop()["command_entries"], 0)

    def test_without_a_controller_the_arm_is_not_ready(self):
        robot = fyd.run("robot", "--connect", "127.0.0.1:9", "--bind", "127.0.0.2:0", "--arm", f"kuka:127.0.0.1:{fyd.free_port()}", "--duration", 0.5)
        self.assertEqual(robot.returncode, 1)
        self.assertIn("KRC: nothing heard", robot.stderr)

    def test_a_controller_without_a_robot_end_fails(self):
        krc = fyd.run("sim", "krc", "--remote", f"127.0.0.1:{fyd.free_port()}", "--duration", 0.3)
        self.assertEqual(krc.returncode, 1)
        self.assertIn("no answer", krc.stderr)


class Network(Processes):
    def test_a_classic_session_runs_through_the_relay(self):
        address, serve = self.touchpad()
        relayed = f"127.0.0.1:{fyd.free_port()}"
        relay = self.start("sim", "network", "--listen", relayed, "--forward", address, "--delay", 10, "--jitter", 1, "--loss", 2, "--seed", 7, "--json")
        fyd.wait_for_udp("127.0.0.1", int(relayed.split(":")[1]))
        robot = self.start("sim", "robot", "--connect", relayed, "--bind", "127.0.0.2:0", "--duration", 3, "--json")
        states = serve(robot)
        end, path = robot.result(), relay.stop()
        self.assertEqual(end["connections"], 1)
        self.assertGreater(len(states), 15)
        self.assertGreaterEqual(path["forward"]["delay_ms_min"], 7)
        for direction in ("forward", "backward"):
            d = path[direction]
            self.assertEqual(d["received"], d["delivered"] - d["duplicated"] + d["lost"] + d["queue_full"] + d["send_failures"])
        self.assertEqual(path["callers"], 1)

    def test_a_recorded_delay_is_replayed(self):
        trace = self.write("delays.csv", "delay_ms\n5\nnan\n")
        receiver = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.addCleanup(receiver.close)
        receiver.bind(("127.0.0.1", 0))
        receiver.settimeout(fyd.PATIENCE)
        listen = fyd.free_port()
        relay = self.start("sim", "network", "--listen", f"127.0.0.1:{listen}", "--forward", f"127.0.0.1:{receiver.getsockname()[1]}", "--profile", trace, "--json")
        fyd.wait_for_udp("127.0.0.1", listen)
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as caller:
            for _ in range(11):
                caller.sendto(b"x", ("127.0.0.1", listen))
        for _ in range(6):  # the eleventh arrives as the last: all the others have been decided on
            self.assertEqual(receiver.recv(10), b"x")
        forward = relay.stop()["forward"]
        self.assertEqual((forward["received"], forward["lost"], forward["delivered"]), (11, 5, 6))
        self.assertGreaterEqual(forward["delay_ms_min"], 5)


class WrongOptions(fyd.Case):
    def test_they_are_named_and_exit_with_2(self):
        robot = ("robot", "--connect", "127.0.0.1:9", "--bind", "127.0.0.2:0")
        self.assertIn("puma", self.refused(2, *robot, "--arm", "puma"))
        self.assertIn("kuka:HOST", self.refused(2, *robot, "--arm", "puma"))
        self.assertIn("--arm", self.refused(2, *robot, "--arm", "kuka:nowhere"))
        self.assertIn("x,x,z", self.refused(2, *robot, "--arm", "kuka:127.0.0.1:0", "--axes", "x,x,z"))
        self.assertIn("--scale", self.refused(2, *robot, "--scale", "1"))
        self.assertIn("--smoothing", self.refused(2, *robot, "--smoothing", "1,1"))
        self.assertIn("--predictor thesis", self.refused(2, *robot, "--smoothing", "0.8,0.9"))
        self.assertIn("--no-probe", self.refused(2, *robot, "--known-stiffness", 0.5))
        self.assertIn("oracle", self.refused(2, *robot, "--predictor", "oracle"))
        for option, wrong, good in (("--axes", "foo", "x,y,z"), ("--krc", "foo", "127.0.0.1")):
            self.assertIn("foo", self.refused(2, *robot, option, wrong))
            self.assertIn(option + " requires --arm", self.refused(2, *robot, option, good))
            self.assertIn(option + " requires --arm", self.refused(2, *robot, option, good, "--scene", "nowhere.toml"))
        self.assertIn("workspace", self.refused(2, *robot, "--link", "--key", "nokey", "--workspace", "1,2"))
        self.assertIn("nokey", self.refused(1, *robot, "--link", "--key", "nokey"))
        self.assertIn("speed limit", self.refused(2, *robot, "--speed-limit", "1e9"))
        self.assertIn("acceleration limit", self.refused(2, *robot, "--acceleration-limit", "1"))
        self.assertIn("jerk limit 5", self.refused(2, *robot, "--jerk-limit", "5"))
        self.assertIn("workspace", self.refused(2, *robot, "--workspace", "35,0,70"))
        self.assertIn("--workspace", self.refused(2, *robot, "--workspace", "35,nan,70"))
        self.assertIn("--key", self.refused(2, *robot, "--link"))
        self.assertIn("--command-at", self.refused(2, *robot, "--command-at", "soon:info"))
        krc = ("sim", "krc", "--remote", "127.0.0.1:9")
        self.assertIn("--period", self.refused(2, *krc, "--period", 0.1))
        self.assertIn("--mode-at", self.refused(2, *krc, "--mode-at", "1:asleep"))
        network = ("sim", "network", "--listen", "127.0.0.1:0", "--forward", "127.0.0.1:9")
        self.assertIn("loss 101 %", self.refused(2, *network, "--loss", 101))
        self.assertIn("modem", self.refused(2, *network, "--profile", "modem"))
        self.assertIn("loss 200 %", self.refused(2, *network, "--profile", "no.csv", "--loss", 200))
        self.assertIn("--delay", self.refused(2, *network, "--profile", "no.csv", "--delay", 5))

    def test_an_end_that_cannot_be_reached_is_wrong_usage(self):
        for option, command in (("--connect", ("robot",)), ("--connect", ("sim", "robot")), ("--remote", ("sim", "krc")),
                                ("--forward", ("sim", "network", "--listen", "127.0.0.1:0"))):
            with self.subTest(command=command):
                self.assertIn(f"{option} 127.0.0.1:0: no port", self.refused(2, *command, option, "127.0.0.1:0"))
        for option, command in (("--connect", ("robot",)), ("--connect", ("sim", "robot")), ("--remote", ("sim", "krc"))):
            with self.subTest(command=command):
                self.assertRegex(self.refused(2, *command, option, "[::1]:3490"),
                                 rf"--bind 127\.0\.0\.\d:\d+ cannot send to {option} \[::1\]:3490: both must be IPv4 or both IPv6")

    def test_a_failed_operation_exits_with_1(self):
        network = ("sim", "network", "--listen", "127.0.0.1:0", "--forward", "127.0.0.1:9", "--profile")
        self.assertIn("nowhere.csv", self.refused(1, *network, "nowhere.csv"))
        self.assertIn("slow.csv:3", self.refused(1, *network, self.write("slow.csv", "delay_ms\n1\nslow\n")))
        self.assertIn("past.csv:3", self.refused(1, *network, self.write("past.csv", "t_s,delay_ms\n0,1\n0,1\n")))


if __name__ == "__main__":
    unittest.main()
