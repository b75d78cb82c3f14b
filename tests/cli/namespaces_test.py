"""Touchpad and robot in two network namespaces joined by a virtual cable: interface down, network unreachable, port
closed, a line so slow that the socket's buffer fills; both ends on the authors' own port."""
import os
import subprocess
import unittest

import fyd

STATION, ROBOT = "10.77.0.1", "10.77.0.2"
PORT = 3490  # of the authors' program, at both ends: possible on one machine only with two namespaces


def quiet(*command):
    return subprocess.run(command, capture_output=True, text=True, check=False)


def namespaces_are_allowed():
    return quiet(*UNSHARE, "true").returncode == 0


# Without root, a user namespace of one's own gives the right to make network namespaces in it.
UNSHARE = ["unshare", "-n"] if os.geteuid() == 0 else ["unshare", "-rn"]


@unittest.skipUnless(namespaces_are_allowed(), "this system allows no network namespaces")
class TwoHosts(fyd.Case):
    def setUp(self):
        super().setUp()
        self.pad = self.sleeper(UNSHARE)
        self.arm = self.sleeper([*self.inside(self.pad), "unshare", "-n"])
        self.on(self.pad, "ip", "link", "add", "cable", "type", "veth", "peer", "name", "plug", "netns", str(self.arm))
        for host, device, address in ((self.pad, "cable", STATION), (self.arm, "plug", ROBOT)):
            self.on(host, "ip", "link", "set", "lo", "up")
            self.on(host, "ip", "address", "add", address + "/24", "dev", device)
            self.on(host, "ip", "link", "set", device, "up")

    def sleeper(self, prefix):
        """A process that keeps a namespace alive; returns its number once the namespace is its own."""
        mine = os.readlink("/proc/self/ns/net") if prefix == UNSHARE else os.readlink(f"/proc/{self.pad}/ns/net")
        process = subprocess.Popen([*prefix, "sleep", "600"])
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        # nsenter and unshare go over into "sleep" without a new process
        fyd.wait_for("the namespace", lambda: os.readlink(f"/proc/{process.pid}/ns/net") != mine
                     and self.name(process.pid) == "sleep")
        return process.pid

    @staticmethod
    def name(pid):
        with open(f"/proc/{pid}/comm", encoding="utf-8") as file:
            return file.read().strip()

    @staticmethod
    def inside(pid):
        user = [] if os.geteuid() == 0 else ["-U", "--preserve-credentials"]
        return ["nsenter", "-t", str(pid), *user, "-n"]

    def on(self, pid, *command):
        done = quiet(*self.inside(pid), *command)
        self.assertEqual(done.returncode, 0, f"{command}: {done.stderr}")

    def start(self, pid, *arguments):
        return fyd.Running(self, *arguments, prefix=self.inside(pid))

    def robot(self, *options):
        return self.start(self.arm, "robot", "--connect", f"{STATION}:{PORT}", "--bind", f"{ROBOT}:{PORT}", "--no-probe",
                          "--known-stiffness", 0.6, *options, "--json")

    def session(self, protocol, *robot_options):
        """Station and robot end as two processes; returns both once the touchpad has rendered for a while."""
        secure_station, secure_robot = [], []
        if protocol == "link":
            key = self.path("lab.key")
            if not os.path.exists(key):
                self.json("link", "keygen", key, "--json")
            secure_station, secure_robot = ["--key", key], ["--link", "--key", key]
        self.telemetry = fyd.Telemetry(self)
        station = self.start(self.pad, "station", "--simulate", "--robot", f"{protocol}:{STATION}:{PORT}",
                             *secure_station, "--telemetry", self.telemetry.path, "--json")
        robot = self.robot(*secure_robot, *robot_options)
        station.await_log("Active")
        self.telemetry.wait_for("the first steps", lambda row: True)
        self.telemetry.pass_steps(500)
        station.held_early()
        return station, robot

    def robot_is_heard(self):
        self.telemetry.wait_for("the robot to be heard again", lambda row: row["link"] == fyd.Telemetry.RUNNING)
        self.telemetry.pass_steps(1000)

    def cable_comes_out(self, protocol):
        station, robot = self.session(protocol)
        self.on(self.pad, "ip", "link", "set", "cable", "down")
        station.await_log("Held")
        self.telemetry.pass_steps(1000)
        self.on(self.pad, "ip", "link", "set", "cable", "up")
        self.robot_is_heard()
        at_end, arm = station.stop(), robot.stop()
        self.assertEqual(at_end["state"], "Held", "a link that returns never re-arms the touchpad")
        self.assertEqual(station.log().count("Active"), 1)
        return at_end, arm

    @fyd.some_tries
    def test_interface_down_holds_the_secured_session(self):
        at_end, arm = self.cable_comes_out("link")
        self.assertEqual(at_end["link_protocol"], "FYD Link, sealed")
        self.assertGreater(arm["touches_received"], 30)

    @fyd.some_tries
    def test_interface_down_holds_the_classic_session_on_the_authors_port(self):
        at_end, arm = self.cable_comes_out("classic")
        self.assertGreater(arm["touches_received"], 100)
        self.assertGreater(at_end["state_messages_received"], 100)

    @fyd.some_tries
    def test_a_robot_whose_port_closed_and_a_route_that_is_gone(self):
        station, robot = self.session("classic")
        robot.process.kill()  # every reply now comes back as "port unreachable"
        station.await_log("Held")
        again = self.robot()
        self.robot_is_heard()
        self.on(self.arm, "ip", "address", "del", ROBOT + "/24", "dev", "plug")  # sending fails at the robot itself
        self.telemetry.wait_for("the robot to be lost", lambda row: row["link"] == fyd.Telemetry.LOST)
        self.telemetry.pass_steps(1000)
        arm = again.stop()
        self.assertGreaterEqual(arm["connections"], 1)
        self.assertGreater(arm["send_failures"], 0)
        self.assertEqual(station.stop()["state"], "Held")
        self.assertEqual(station.log().count("Active"), 1)

    @fyd.some_tries
    def test_a_line_so_slow_that_the_sockets_buffer_fills(self):
        station, robot = self.session("link", "--rate", 1000, "--state-rate", 1000)
        slow = ("dev", "plug", "root", "tbf", "rate", "2kbit", "burst", "2000", "limit", "10000000")
        shaped = quiet(*self.inside(self.arm), "tc", "qdisc", "add", *slow)
        if shaped.returncode != 0:
            self.skipTest("no traffic shaping here: " + shaped.stderr)
        station.await_log("Held")
        self.telemetry.pass_steps(3000)
        self.on(self.arm, "tc", "qdisc", "del", "dev", "plug", "root")
        self.robot_is_heard()
        at_end, arm = station.stop(), robot.stop()
        fyd.not_held_by_the_machine(at_end)
        self.assertGreater(arm["send_failures"], 0, "the buffer did fill")
        self.assertEqual(at_end["state"], "Held")
        self.assertEqual(at_end["reason"], "the robot is silent")
        self.assertEqual(station.log().count("Active"), 1)


if __name__ == "__main__":
    unittest.main()
