"""fyd scene: meshes checked, scenes explained and run, against surfaces that are known without triangles."""
import csv
import math
import os
import resource
import signal
import socket
import struct
import subprocess
import threading
import unittest

import fyd

DEEP = 1.0  # mm
K = 2 * math.pi / 20


def height(x, y):
    return 2 * math.sin(K * x) * math.sin(K * y)


def normal(x, y):
    n = (-2 * K * math.cos(K * x) * math.sin(K * y), -2 * K * math.sin(K * x) * math.cos(K * y), 1)
    size = math.sqrt(sum(v * v for v in n))
    return tuple(v / size for v in n)


def bumpy_obj(n, size=100.0, scale=1.0):
    lines = []
    for i in range(n + 1):
        for j in range(n + 1):
            x, y = size * (i / n - 0.5), size * (j / n - 0.5)
            lines.append(f"v {scale * x!r} {scale * y!r} {scale * height(x, y)!r}")
    for i in range(n):
        for j in range(n):
            a, b, c, d = (1 + i * (n + 1) + j, 1 + (i + 1) * (n + 1) + j, 2 + (i + 1) * (n + 1) + j, 2 + i * (n + 1) + j)
            lines += [f"f {a} {b} {c}", f"f {a} {c} {d}"]
    return "\n".join(lines) + "\n"


CUBE = ("v 0 0 0\nv 10 0 0\nv 0 10 0\nv 10 10 0\nv 0 0 10\nv 10 0 10\nv 0 10 10\nv 10 10 10\n"
        "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n")


class Scene(fyd.Case):
    def write(self, name, text, mode="w"):
        path = self.path(name)
        with open(path, mode) as file:
            file.write(text)
        return path

    def walk(self, name, places):
        rows = [f"{0.001 * i!r},{x!r},{y!r},{z!r}" for i, (x, y, z) in enumerate(places)]
        return self.write(name, "t_s,x_mm,y_mm,z_mm\n" + "\n".join(rows) + "\n")

    def rows(self, scene, path):
        out = self.path("out.csv")
        summary = self.json("scene", "run", scene, "--path", path, "-o", out, "--json")
        with open(out, encoding="utf-8") as file:
            rows = [{k: float(v) for k, v in row.items()} for row in csv.DictReader(file)]
        return summary, rows

    def bumpy_walk(self):
        places = []
        for i in range(4000):
            way = 0.11 * i
            x, y = 40 * math.sin(way / 40), 40 * math.sin(0.731 * way / 40 + 1)
            places.append(tuple(p - DEEP * n for p, n in zip((x, y, height(x, y)), normal(x, y))))
        return places

    def test_the_least_scene_pushes_as_the_surface_itself_does(self):
        self.write("bumpy.obj", bumpy_obj(71))
        scene = self.write("s.toml", '[[body]]\nmesh = "bumpy.obj"          # relative to this file\nunit = "mm"\n'
                           'stiffness_N_per_mm = 0.5\ncontact = "vicinity"        # nodes | facet | vicinity | proxy\n')
        places = self.bumpy_walk()
        summary, rows = self.rows(scene, self.walk("p.csv", places))
        self.assertEqual(list(rows[0]), ["t_s", "probe_x_mm", "probe_y_mm", "probe_z_mm", "proxy_x_mm", "proxy_y_mm",
                                         "proxy_z_mm", "force_x_N", "force_y_N", "force_z_N", "stiffness_N_per_mm"])
        self.assertEqual((summary["steps"], summary["steps_touching"]), (4000, 4000))
        error = largest_step = true_step = 0.0
        before = before_true = None
        for i, row in enumerate(rows):
            way = 0.11 * i
            true = tuple(0.5 * DEEP * v for v in normal(40 * math.sin(way / 40), 40 * math.sin(0.731 * way / 40 + 1)))
            force = (row["force_x_N"], row["force_y_N"], row["force_z_N"])
            error += math.dist(force, true) / 0.5
            if before:
                largest_step, true_step = max(largest_step, math.dist(force, before)), max(true_step, math.dist(true, before_true))
            before, before_true = force, true
            self.assertEqual(row["stiffness_N_per_mm"], 0.5)
        self.assertLess(error / 4000, 0.02)
        self.assertLess(largest_step, 3 * true_step)

    def test_every_unit_is_the_same_scene(self):
        forces = []
        for unit, scale in (("mm", 1.0), ("m", 1e-3), ("cm", 0.1)):
            self.write("bumpy.obj", bumpy_obj(40, scale=scale))
            scene = self.write("s.toml", f'[[body]]\nmesh = "bumpy.obj"\nunit = "{unit}"\ncontact = "facet"\n')
            forces.append([row["force_z_N"] for row in self.rows(scene, self.walk("p.csv", self.bumpy_walk()[:500]))[1]])
        for other in forces[1:]:
            for a, b in zip(forces[0], other):
                self.assertAlmostEqual(a, b, delta=1e-9)

    def test_a_thin_wall_is_not_crossed_by_a_proxy_at_one_metre_a_second(self):
        self.write("wall.obj", "v -50 -50 0\nv 50 -50 0\nv 50 50 0\nv -50 50 0\nf 1 2 3 4\n"
                   "v -50 -50 -0.05\nv 50 -50 -0.05\nv 50 50 -0.05\nv -50 50 -0.05\nf 8 7 6 5\n")
        scene = self.write("s.toml", '[[body]]\nmesh = "wall.obj"\ncontact = "proxy"\n')
        _, rows = self.rows(scene, self.walk("p.csv", [(0.3, 0.2, 10 - i) for i in range(21)]))
        for row in rows[11:]:
            self.assertGreaterEqual(row["proxy_z_mm"], -1e-6)
            self.assertAlmostEqual(row["force_z_N"], -0.5 * row["probe_z_mm"], delta=1e-5)

    def test_bodies_stand_turned_and_fly(self):
        self.write("cube.obj", CUBE)
        scene = self.write("s.toml", '[[body]]\nmesh = "cube.obj"\ncontact = "facet"\nposition_mm = [100, 0, 0]\n'
                           'turned_deg = [0, 0, 90]\nvelocity_mm_per_s = [-1000, 0, 0]\n')
        # Turned by 90° about z, the cube is from 90 to 100 mm; after 85 ms it is from 5 to 15 mm.
        _, rows = self.rows(scene, self.walk("p.csv", [(6.0, 5.0, 5.0)] * 100))
        self.assertEqual([row["force_x_N"] for row in rows[:80]], [0.0] * 80)
        at_85 = rows[85]
        self.assertAlmostEqual(at_85["force_x_N"], -0.5, delta=1e-9)
        self.assertAlmostEqual(at_85["force_y_N"], 0.0, delta=1e-12)

    def test_of_two_bodies_equally_near_both_push_and_the_first_is_named(self):
        self.write("cube.obj", CUBE)
        body = '[[body]]\nmesh = "cube.obj"\ncontact = "facet"\n'
        scene = self.write("s.toml", body + body)
        _, rows = self.rows(scene, self.walk("p.csv", [(5, 5, 9.0)] * 3))
        self.assertAlmostEqual(rows[-1]["force_z_N"], 1.0, delta=1e-12)
        self.assertAlmostEqual(rows[-1]["stiffness_N_per_mm"], 1.0, delta=1e-12)
        self.assertEqual(rows[-1]["proxy_z_mm"], 10.0)

    def test_explain_says_what_there_will_be_and_no_more(self):
        self.write("cube.obj", CUBE)
        scene = self.write("s.toml", '[scene]\nname = "a cube"\n[[body]]\nmesh = "cube.obj"\ncontact = "facet"\n')
        json = self.json("scene", "explain", scene, "--json")
        self.assertEqual((json["scene"], json["gestures"], len(json["bodies"])), ("a cube", [], 1))
        self.assertEqual((json["bodies"][0]["triangles"], json["bodies"][0]["contact"]), (12, "facet"))
        self.assertLess(json["memory_bytes"], 20_000)
        smooth = self.write("v.toml", '[[body]]\nmesh = "cube.obj"\ncontact = "vicinity"\n')
        self.assertGreater(self.json("scene", "explain", smooth, "--json")["memory_bytes"], json["memory_bytes"],
                           "a facet needs no fitted surface")

    def test_explain_measures_every_body_at_work(self):
        self.write("b.obj", bumpy_obj(24))
        body = '[[body]]\nmesh = "b.obj"\nsoft = true\nspread_mm = 4\nposition_mm = [{}, 0, 0]\n'
        scene = self.write("s.toml", "".join(body.format(x) for x in (0, 200, 400)))
        first, *others = (each["step_median_ns"] for each in self.json("scene", "explain", scene, "--json")["bodies"])
        print("step of three equal soft bodies, ns:", first, *others)
        for other in others:  # a step that does nothing is a hundred times cheaper
            self.assertGreater(other, 0.1 * first)

    def test_check_reports_what_it_mended(self):
        text = CUBE + "v 10 10 10\nf 5 6 9\nf 1 1 2\n"
        json = self.json("scene", "check", self.write("c.obj", text), "--unit", "cm", "--json")
        self.assertEqual((json["triangles"], json["duplicate_vertices"], json["degenerate_triangles"]), (12, 1, 1))
        self.assertEqual((json["duplicate_triangles"], json["flipped_triangles"]), (1, 0))
        self.assertEqual(json["holes"], 0)
        self.assertAlmostEqual(json["volume_mm3"], 1e6, delta=1e-3)
        self.assertEqual(len(json["remarks"]), 3)
        opened = self.json("scene", "check", self.write("o.obj", CUBE.replace("f 5 6 8 7\n", "")), "--json")
        self.assertEqual((opened["holes"], opened["rim_edges"]), (1, 4))

    def test_what_is_wrong_is_named(self):
        cube = self.write("cube.obj", CUBE)
        scene = self.write("s.toml", '[[body]]\nmesh = "cube.obj"\n')
        self.assertIn("s.toml: nowhere", self.refused(1, "scene", "explain",
                                                     self.write("n.toml", '[[body]]\nmesh = "nowhere.obj"\n')).replace(
                                                         self.path("n.toml"), "s.toml").replace(self.path("nowhere"), "nowhere"))
        self.assertIn("expected .obj, .stl or .ply",
                      self.refused(1, "scene", "explain", self.write("self.toml", '[[body]]\nmesh = "self.toml"\n')))
        self.assertIn("it is no file", self.refused(1, "scene", "check", self.make_folder("d.obj")))
        self.assertIn("no whole obj file", self.refused(1, "scene", "check", self.write("e.obj", "hello\n")))
        stl = b" " * 80 + struct.pack("<I", 3) + b"\0" * 70
        self.assertIn("no whole stl file", self.refused(1, "scene", "check", self.write("t.stl", stl, "wb")))
        self.assertIn("p.csv:3: t_s 0: expected a time after the row before",
                      self.refused(1, "scene", "run", scene, "--path", self.write("p.csv", "t_s,x_mm,y_mm,z_mm\n0,0,0,0\n0,1,1,1\n")))
        self.assertIn("p.csv:2: expected three finite numbers",
                      self.refused(1, "scene", "run", scene, "--path", self.write("p.csv", "t_s,x_mm,y_mm,z_mm\n0,nan,0,0\n")))
        self.assertIn("--unit", self.refused(2, "scene", "check", cube, "--unit", "mile"))
        self.assertIn("expected .obj, .stl or .ply", self.refused(2, "scene", "check", "nowhere.xyz"))

    def make_folder(self, name):
        path = self.path(name)
        os.mkdir(path)
        return path


class InASession(fyd.Case):
    def test_a_scene_stands_where_a_robot_stands(self):
        with open(self.path("floor.obj"), "w", encoding="utf-8") as file:
            file.write("v -500 -500 -1\nv 500 -500 -1\nv 500 500 -1\nv -500 500 -1\nf 1 2 3 4\n")
        scene, recording = self.path("s.toml"), self.path("r.fyd")
        texture = os.path.join(os.environ["FYD_SOURCE_DIR"], "resources", "textures", "wood.toml")
        with open(scene, "w", encoding="utf-8") as file:
            file.write(f'[scene]\nname = "floor"\n[[body]]\nmesh = "floor.obj"\nstiffness_N_per_mm = 0.66\ncontact = "facet"\ntexture = "{texture}"\n')
        telemetry = self.path("t.csv")
        result = self.json("station", "--simulate", "--robot", "scene:" + scene, "--duration", "6", "--record", recording,
                           "--telemetry", telemetry, "--json")
        self.assertEqual(result["state"], "Active")
        self.assertEqual((result["link_protocol"], result["touch_messages_sent"]), ("scene floor", 0), "no network lies between")
        with open(telemetry, encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        touched = [row for row in rows if row["state"] == "3" and float(row["robot_force_N"]) > 0]
        self.assertGreater(len(touched), 1000)
        for row in touched[::50]:
            self.assertEqual(float(row["robot_stiffness_N_per_mm"]), 0.66)
            self.assertAlmostEqual(float(row["robot_z_mm"]), -1.0, 9, "the floor's height")
            depth_mm = -1.0 - 3.0 * float(row["touch_z_mm"])
            self.assertAlmostEqual(float(row["robot_force_N"]), 0.66 * depth_mm, 2)
        # The recording holds its scene: its files are not needed any more, and what was felt is computed again.
        os.remove(scene)
        os.remove(self.path("floor.obj"))
        again = self.json("session", "replay", recording, "--json")
        self.assertTrue(again["identical"])
        self.assertIn("s.toml", self.refused(1, "station", "--simulate", "--robot", "scene:" + scene + ".not", "--duration", "1"))

    def copies(self, here, there):
        """What two ends say of their scenes: the touchpad's, the robot's."""
        key = self.path("lab.key")
        if not os.path.exists(key):
            self.json("link", "keygen", key, "--json")
        port = fyd.free_port()
        station = fyd.Running(self, "station", "--simulate", "--robot", f"link:127.0.0.1:{port}", "--key", key,
                              *(["--scene", here] if here else []), "--json")
        fyd.wait_for_udp("127.0.0.1", port)
        robot = self.json("robot", *(["--scene", there] if there else ["--no-probe"]), "--link", "--key", key, "--connect",
                          f"127.0.0.1:{port}", "--bind", "127.0.0.2:0", "--json", "--duration", 1.5)
        session = station.stop()
        return session["scenes"], robot["scenes"], station.log()

    def test_each_end_says_when_its_copy_of_a_scene_is_another_one(self):
        body = '[[body]]\nmesh = "{}"\nstiffness_N_per_mm = 0.5\ncontact = "facet"\n'
        self.write("cube.obj", CUBE)
        self.write("moved.obj", CUBE.replace("v 10 10 10", "v 10 10 10.000001"))
        here = self.write("here.toml", body.format("cube.obj"))
        again = self.write("again.toml", "# a copy\n[scene]\nname = \"copy\"\n" + body.format("cube.obj"))
        stiffer = self.write("stiffer.toml", body.format("cube.obj").replace("0.5", "0.6"))
        moved = self.write("moved.toml", body.format("moved.obj"))
        for there, words in ((again, "same"), (stiffer, "different"), (moved, "different")):
            self.assertEqual(self.copies(here, there)[:2], (words, words), there)
        self.assertEqual(self.copies(here, None)[:2], ("only here", "only there"))
        ours, theirs, log = self.copies(None, here)
        self.assertEqual((ours, theirs), ("only there", "only here"))
        self.assertIn("the other end holds a scene", log)
        self.assertEqual(self.copies(None, None)[:2], ("none", "none"))

    def test_one_scene_at_a_time(self):
        scene = self.write("s.toml", '[[body]]\nmesh = "cube.obj"\n')
        self.write("cube.obj", CUBE)
        self.assertIn("the robot is a scene already",
                      self.refused(2, "station", "--simulate", "--robot", "scene:" + scene, "--scene", scene, "--duration", 1))


class Fencing(fyd.Case):
    """Two players in two processes, a network between them."""
    def scene(self, name, stiffness=0.5):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(f"[swords]\nstiffness_N_per_mm = {stiffness}\n[fencing]\nperiod_s = 0.01\n")
        return self.path(name)

    def fence(self, ours, theirs, *network, first=(), during=lambda port: None):
        ports = [fyd.free_port(), fyd.free_port()]
        relay = fyd.Running(self, "sim", "network", "--listen", f"127.0.0.1:{ports[0]}", "--forward",
                            f"127.0.0.1:{ports[1]}", *network, "--json")
        second = fyd.Running(self, "scene", "fence", theirs, "--listen", f"127.0.0.1:{ports[1]}", "--strokes", 0.6, "--json")
        fyd.wait_for_udp("127.0.0.1", ports[0])
        fyd.wait_for_udp("127.0.0.1", ports[1])
        during(ports[1])
        one = self.json("scene", "fence", ours, "--peer", f"127.0.0.1:{ports[0]}", "--duration", 5, "--json", *first)
        two = second.stop()
        relay.stop()
        return one, two, second.log()

    def test_both_feel_the_blows(self):
        scene, rows = self.scene("s.toml"), self.path("rows.csv")
        for player in self.fence(scene, scene, first=("-o", rows))[:2]:
            self.assertEqual((player["linked"], player["scenes"]), (True, "same"))
            self.assertGreater(player["messages_received"], 300)
            self.assertGreaterEqual(player["contacts"], 2)
            self.assertGreater(player["largest_force_N"], 1.0)
            self.assertLess(player["other_grip_error_mm_rms"], 2.0)
        with open(rows, encoding="utf-8") as file:
            felt = [row for row in csv.DictReader(file) if row["touching"] == "1"]
        self.assertGreater(len(felt), 300)

    def test_a_bad_network_and_hostile_datagrams(self):
        def shout(port):
            with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as out:
                for words in (b"", b"\xff" * 60, b"FYD fencing scene short", b"\0" * 65000):
                    out.sendto(words, ("127.0.0.1", port))
        one, two, _ = self.fence(self.scene("s.toml"), self.scene("s.toml"), "--delay", 30, "--loss", 20, during=shout)
        for player in (one, two):
            self.assertTrue(player["linked"])
            self.assertTrue(8 < player["loss_percent"] < 35, player["loss_percent"])
            self.assertGreater(player["age_median_ms"], 25)
            self.assertLess(player["other_grip_error_mm_rms"], 4.0)
        self.assertGreaterEqual(two["datagrams_not_understood"], 3)

    def test_a_clock_that_is_ahead_is_no_link(self):
        scene, ahead_us = self.scene("s.toml"), 2_000_000
        ports = [fyd.free_port(), fyd.free_port()]
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as between:
            between.bind(("127.0.0.1", 0))
            between.settimeout(0.1)
            one, two = (fyd.Running(self, "scene", "fence", scene, "--listen", f"127.0.0.1:{port}", "--peer",
                                    f"127.0.0.1:{between.getsockname()[1]}", "--json") for port in ports)

            def relay():
                while one.runs():
                    try:
                        words, (_, port) = between.recvfrom(2000)
                    except TimeoutError:
                        continue
                    if port == ports[1] and words[:2] in (b"TD", b"TN"):  # the date: behind magic, flags, session
                        date = int.from_bytes(words[5:11], "little") + ahead_us
                        words = words[:5] + date.to_bytes(6, "little") + words[11:]
                    between.sendto(words, ("127.0.0.1", ports[0] if port == ports[1] else ports[1]))

            relaying = threading.Thread(target=relay)
            relaying.start()
            try:
                one.await_log("clock is")
                two.await_log("the other player is there")
                one.process.send_signal(signal.SIGINT)
                out, _ = one.process.communicate(timeout=fyd.PATIENCE)
            finally:
                one.process.kill()
                relaying.join()
        self.assertEqual(one.process.returncode, 1, out)
        # Less what the message was under way, which is long on a busy machine.
        self.assertRegex(one.log().splitlines()[-1], r"clock is (2\.0|1\.[5-9]) s ahead")
        self.assertEqual(one.log().count("clock is"), 2)  # once while it runs, and why it failed
        two.stop()

    def test_copies_that_differ_are_said(self):
        one, two, log = self.fence(self.scene("a.toml"), self.scene("b.toml", 0.6))
        self.assertEqual((one["scenes"], two["scenes"]), ("different", "different"))
        self.assertIn("different scenes", log)

    def test_a_file_that_cannot_be_written_loses_neither_the_summary_nor_the_end(self):
        scene = self.scene("s.toml")
        self.assertIn("/nowhere/r.csv", self.refused(1, "scene", "fence", scene, "--peer", "127.0.0.1:9", "-o", "/nowhere/r.csv"))
        port = fyd.free_port()
        fyd.Running(self, "scene", "fence", scene, "--listen", f"127.0.0.1:{port}")
        fyd.wait_for_udp("127.0.0.1", port)
        limit = 50_000
        done = subprocess.run([fyd.PROGRAM, "scene", "fence", scene, "--peer", f"127.0.0.1:{port}", "--duration", "2", "-o",
                               self.path("r.csv"), "--json"], capture_output=True, text=True, check=False, timeout=fyd.PATIENCE,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("r.csv: writing failed", done.stderr)
        self.assertEqual(os.path.getsize(self.path("r.csv")), limit, "the limit was never met: this test shows nothing")
        self.assertTrue(fyd.json.loads(done.stdout)["linked"])

    def test_the_rows_stand_in_the_file_while_it_runs(self):
        port, rows = fyd.free_port(), self.path("rows.csv")
        fyd.Running(self, "scene", "fence", self.scene("s.toml"), "--listen", f"127.0.0.1:{port}", "-o", rows)
        fyd.wait_for("rows to be written", lambda: os.path.exists(rows) and os.path.getsize(rows) > 5000)

    def test_what_cannot_be_is_refused(self):
        scene = self.scene("s.toml")
        self.assertIn("no other player", self.refused(1, "scene", "fence", scene, "--peer", "127.0.0.1:9", "--duration", 0.2))
        with open(self.path("n.toml"), "w", encoding="utf-8") as file:
            file.write("[ball]\n")
        self.assertIn("no [swords]", self.refused(1, "scene", "fence", self.path("n.toml"), "--duration", 1))
        self.assertIn("--peer", self.refused(2, "scene", "fence", scene, "--peer", "nowhere"))
        for option, value in (("--peer", "127.0.0.1:0"), ("--peer", "[::1]:9"), ("--listen", "nowhere"), ("--predictor", "foo")):
            self.assertIn(value, self.refused(2, "scene", "fence", "nosuch", option, value))
        self.assertIn("--predictor", self.refused(2, "scene", "fence", scene, "--predictor", "oracle"))
        self.assertIn("--card", self.refused(2, "scene", "fence", scene, "--card", "a", "--path", "b"))


if __name__ == "__main__":
    unittest.main()
