"""fyd session export and report: files other programs read, checked by readers that are not ours."""
import base64
import csv
import datetime
import os
import resource
import signal
import statistics
import subprocess
import unittest

import fyd
import mcap_peer

SYSTEM_PYTHON = "/usr/bin/python3"  # Debian's own, which has Debian's scipy

READ_MAT = """
import json, sys, numpy, scipy.io
file = scipy.io.loadmat(sys.argv[1], squeeze_me=True, struct_as_record=False)
telemetry, units, header, events = (file[name] for name in ("telemetry", "units", "header", "events"))
print(json.dumps({"names": telemetry._fieldnames, "force_N": [x.hex() for x in telemetry.force_N.tolist()],
                  "step": telemetry.step.tolist(), "units": {n: str(getattr(units, n)) for n in units._fieldnames},
                  "subject": header.subject, "notes": header.notes, "id": header.id,
                  "kinds": [str(k) for k in numpy.atleast_1d(events.kind)],
                  "times": numpy.atleast_1d(events.time_s).tolist()}))
"""


def full_disk():
    """A limit on the size of files stands for the full disk."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (30_000, 30_000))


class Exports(fyd.Case):
    """One recording for all: making it takes as long as it lasts."""

    @classmethod
    def setUpClass(cls):
        cls.kept = fyd.tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.kept.cleanup)
        cls.file = os.path.join(cls.kept.name, "session.h5")
        done = fyd.run("station", "--simulate", "--duration", 6, "--record", cls.file, "--operator", "Ada",
                       "--subject", "S7", "--notes", "<script>Größe 5 µm", "--tag", "soft", "--json")
        assert done.returncode == 0, done.stderr
        info = fyd.run("session", "info", cls.file, "--json")
        assert info.returncode == 0, info.stderr
        cls.info = fyd.json.loads(info.stdout)

    def export(self, name, *options):
        return self.json("session", "export", self.file, self.path(name), *options, "--json")

    def rows(self, name):
        with open(self.path(name), encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def test_csv_holds_every_sample(self):
        result = self.export("a.csv")
        self.assertEqual(result["rows"], self.info["committed_samples"])
        self.assertEqual(result["files"], [self.path("a.csv"), self.path("a.events.csv")])
        rows = self.rows("a.csv")
        self.assertEqual(len(rows), self.info["committed_samples"])
        steps = [int(row["step [1]"]) for row in rows]
        self.assertEqual(steps, sorted(set(steps)))
        # Time 0 is when the recording began; the station's first step came just after, on a busy machine a little later.
        self.assertGreaterEqual(float(rows[0]["time_s [s]"]), 0.0)
        self.assertLess(float(rows[0]["time_s [s]"]), self.info["duration_s"] / 2)
        self.assertAlmostEqual(float(rows[-1]["time_s [s]"]), self.info["duration_s"], delta=0.01)
        self.assertGreater(max(float(row["force_N [N]"]) for row in rows if row["force_N [N]"] != "nan"), 0.1)
        self.assertIn("state changed", {row["kind"] for row in self.rows("a.events.csv")})

    def test_matlab_reads_the_same_values(self):
        self.export("a.csv", "--from", 1, "--to", 3)
        self.export("a.mat", "--from", 1, "--to", 3)
        done = subprocess.run([SYSTEM_PYTHON, "-c", READ_MAT, self.path("a.mat")], capture_output=True, text=True,
                              check=False, timeout=fyd.PATIENCE)
        self.assertEqual(done.returncode, 0, done.stderr)
        mat = fyd.json.loads(done.stdout)
        rows = self.rows("a.csv")
        self.assertEqual([f"{name} [{mat['units'][name]}]" for name in mat["names"]], list(rows[0]))
        self.assertEqual(mat["force_N"], [float(row["force_N [N]"]).hex() for row in rows])
        self.assertEqual(mat["step"], [float(row["step [1]"]) for row in rows])
        self.assertEqual((mat["subject"], mat["notes"], mat["id"]), ("S7", "<script>Größe 5 µm", self.info["id"]))
        self.assertEqual(mat["units"]["stretch_measured_deg"], "°")

    def test_mcap_keeps_to_its_specification(self):
        result = self.export("a.mcap")
        file = mcap_peer.File(self.path("a.mcap"))
        self.assertEqual(len(file.messages), result["messages"])
        telemetry = file.on("/telemetry")
        self.assertEqual(len(telemetry), self.info["committed_samples"])
        self.assertGreater(len(file.chunks), 1)
        times = [message[2] for message in telemetry]
        self.assertEqual(times, sorted(set(times)))
        self.assertEqual([message[1] for message in telemetry], list(range(len(telemetry))))
        for topic in ("/camera", "/log", "/link"):
            times = [message[2] for message in file.on(topic)]
            self.assertEqual(times, sorted(times), topic)
        names = {channel[2]: file.schemas[channel[1]][1] for channel in file.channels.values()}
        self.assertEqual(names, {"/telemetry": "fyd.Telemetry", "/camera": "foxglove.CompressedImage",
                                 "/log": "foxglove.Log", "/link": "fyd.Link"})
        for schema in file.schemas.values():
            self.assertEqual(schema[2], "jsonschema")
            self.assertEqual(fyd.json.loads(schema[3])["type"], "object")
        metadata = {name: texts for _, name, texts in file.metadata.values()}["recording"]
        self.assertEqual((metadata["subject"], metadata["notes"]), ("S7", "<script>Größe 5 µm"))
        self.assertIn(b"[control]", file.attached["profile.toml"])

    def test_mcap_holds_the_values_and_the_time_of_day(self):
        self.export("a.csv", "--fields", "force_N,step", "--from", 2)
        self.export("a.mcap", "--fields", "force_N,step", "--from", 2, "--region")
        file = mcap_peer.File(self.path("a.mcap"))
        rows, messages = self.rows("a.csv"), file.json("/telemetry")
        self.assertEqual(len(rows), len(messages))
        for row, (_, content) in zip(rows, messages):
            self.assertEqual(int(row["step [1]"]), content["step"])
            self.assertEqual(row["force_N [N]"] == "nan", "force_N" not in content)
            if "force_N" in content:
                self.assertEqual(float(row["force_N [N]"]), content["force_N"])
        started = datetime.datetime.fromisoformat(self.info["started_utc"].replace("Z", "+00:00")).timestamp()
        self.assertAlmostEqual(messages[0][0], started + float(rows[0]["time_s [s]"]), delta=0.002)
        pictures = file.json("/camera")
        self.assertGreater(len(pictures), 30)
        for time, picture in pictures:
            self.assertEqual(picture["format"], "png")
            self.assertEqual(base64.b64decode(picture["data"], validate=True)[:8], b"\x89PNG\r\n\x1a\n")
            self.assertAlmostEqual(picture["timestamp"]["sec"] + picture["timestamp"]["nsec"] / 1e9, time, places=5)

    def test_a_damaged_mcap_would_be_noticed(self):
        self.export("a.mcap", "--to", 0.5)
        mcap_peer.File(self.path("a.mcap"))
        with open(self.path("a.mcap"), "rb") as file:
            good = bytearray(file.read())
        for at in (200_000, len(good) - 200, len(good) - 12):
            bad = bytearray(good)
            bad[at] ^= 1
            with open(self.path("b.mcap"), "wb") as file:
                file.write(bad)
            with self.assertRaises(Exception):
                mcap_peer.File(self.path("b.mcap"))

    def test_video_says_when_each_picture_was_taken(self):
        self.export("pictures.mcap")
        taken = [time for time, _ in mcap_peer.File(self.path("pictures.mcap")).json("/camera")]
        rate_hz = 1 / statistics.median(b - a for a, b in zip(taken, taken[1:]))  # a busy machine's camera is slower
        for name, region in (("a.mkv", ()), ("b.avi", ("--region",))):
            result = self.export(name, *region)
            self.assertEqual(result["pictures"] + result["left_out"], self.info["frames"])
            self.assertAlmostEqual(result["rate_hz"], rate_hz, delta=0.05 * rate_hz)
            times = self.rows(name[:-4] + ".times.csv")
            self.assertEqual(len(times), result["pictures"] + result["repeated"])
            self.assertGreater(os.path.getsize(self.path(name)), 10_000)

    def test_reports_are_whole_and_escaped(self):
        self.json("session", "report", self.file, self.path("r.html"), "--json")
        self.json("session", "report", self.file, self.path("r.pdf"), "--json")
        with open(self.path("r.html"), encoding="utf-8") as file:
            html = file.read()
        for text in ("Ada", "S7", "&lt;script&gt;Größe 5 µm", "<svg", "Touches", "control.ki", "Active", "</html>"):
            self.assertIn(text, html)
        self.assertNotIn("<script", html)
        with open(self.path("r.pdf"), "rb") as file:
            pdf = file.read()
        self.assertTrue(pdf.startswith(b"%PDF-") and pdf.rstrip().endswith(b"%%EOF"))

    def test_notes_of_a_review_are_in_exports_and_reports(self):
        beside = self.file + ".notes.json"
        self.addCleanup(os.remove, beside)
        with open(beside, "w", encoding="utf-8") as file:
            fyd.json.dump({"notes": [{"time_s": 2.5, "kind": "note", "text": "squeaks <here>"},
                                     {"time_s": 1.25, "kind": "bookmark", "text": "dent"}]}, file)
        self.export("n.csv")
        noted = [(row["time_s [s]"], row["kind"], row["text"]) for row in self.rows("n.events.csv")
                 if "review" in row["kind"]]
        self.assertEqual(noted, [("1.25", "bookmark in review", "dent"), ("2.5", "note in review", "squeaks <here>")])
        self.json("session", "report", self.file, self.path("n.html"), "--json")
        with open(self.path("n.html"), encoding="utf-8") as file:
            self.assertIn("squeaks &lt;here&gt;", file.read())
        with open(beside, "w", encoding="utf-8") as file:
            file.write("{")
        self.export("broken.csv")
        self.assertIn(("alarm", True), {(row["kind"], beside in row["text"]) for row in self.rows("broken.events.csv")})
        with open(beside, "w", encoding="utf-8") as file:
            fyd.json.dump({"recording_id": "0" * 32, "notes": [{"time_s": 2.5, "kind": "note", "text": "not ours"}]}, file)
        self.export("others.csv")
        texts = [row["text"] for row in self.rows("others.events.csv") if row["kind"] == "alarm"]
        self.assertTrue(any("notes are of another recording" in text for text in texts), texts)
        self.assertNotIn("not ours", str(self.rows("others.events.csv")))

    def test_wrong_wishes_are_refused_and_leave_nothing(self):
        export = ("session", "export", self.file)
        for words, said in ((["a.txt"], ".mcap"), (["a.csv", "--fields", "nothing_N"], "nothing_N"),
                            (["a.csv", "--fields", "force_N,force_N"], "asked for twice"),
                            (["a.csv", "--from", "3", "--to", "1"], "larger"), (["a.mkv", "--from", "nan"], "larger"),
                            (["a.AVI", "--fields", "force_N"], "a video has no fields"),
                            (["a.csv", "--fields", "force_N,"], "force_N,: expected a word before and after each comma"),
                            (["a.csv", "--region"], "a.csv: a table has no pictures"),
                            (["a.mat", "--region"], "a.mat: a table has no pictures")):
            # Whichever the recording: none is looked at.
            said_then = self.refused(2, "session", "export", self.path("nowhere.h5"), self.path(words[0]), *words[1:])
            self.assertIn(said, said_then)
        self.assertIn("no samples", self.refused(1, *export, self.path("a.csv"), "--from", 1000))
        self.assertIn("nowhere.h5", self.refused(1, "session", "export", self.path("nowhere.h5"), self.path("a.csv")))
        self.assertIn("nofolder", self.refused(1, *export, self.path("nofolder/a.csv")))
        self.assertIn(".pdf", self.refused(2, "session", "report", self.file, self.path("r.doc")))
        self.assertEqual(os.listdir(self.folder), [])
        for name in ("a.csv", "a.mat", "a.mcap", "a.mkv", "r.pdf"):
            self.write(name, "mine")
            kind = "report" if name == "r.pdf" else "export"
            self.assertIn("exists already", self.refused(1, "session", kind, self.file, self.path(name)))
            with open(self.path(name), encoding="utf-8") as file:
                self.assertEqual(file.read(), "mine")
        self.export("a.csv", "--force")

    def test_a_full_disk_is_said_and_leaves_nothing(self):
        for name in ("a.csv", "a.mat", "a.mcap", "a.mkv", "a.avi", "r.html", "r.pdf"):
            kind = "report" if name.startswith("r.") else "export"
            done = subprocess.run([fyd.PROGRAM, "session", kind, self.file, self.path(name)], capture_output=True,
                                  text=True, check=False, timeout=fyd.PATIENCE, preexec_fn=full_disk)
            self.assertEqual(os.listdir(self.folder), [], name)
            self.assertEqual(done.returncode, 1, name + done.stdout + done.stderr)
            self.assertIn(name, done.stderr)


if __name__ == "__main__":
    unittest.main()
