"""fyd station --record and fyd session: a recording from beginning to end, and what breaks it."""
import csv
import os
import resource
import shutil
import unicodedata
import unittest

import fyd

SESSION = ("station", "--simulate")


def recorded(case, path, samples):
    """A session that is being recorded, once so many samples are committed."""
    recorder = fyd.Running(case, *SESSION, "--record", path, "--json")

    def committed():
        info = fyd.run("session", "info", path, "--json")
        return info.returncode == 0 and fyd.json.loads(info.stdout)["committed_samples"] >= samples
    fyd.wait_for(f"{samples} committed samples", committed)
    return recorder


class Recorded(fyd.Case):
    """One recording for all: making it takes as long as it lasts."""

    @classmethod
    def setUpClass(cls):
        cls.kept = fyd.tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.kept.cleanup)
        cls.file = os.path.join(cls.kept.name, "session.h5")
        done = fyd.run(*SESSION, "--duration", 8, "--record", cls.file, "--operator", "Ada", "--subject", "S7",
                       "--notes", "first try", "--tag", "soft", "--tag", "dry", "--json")
        assert done.returncode == 0, done.stderr
        cls.session = fyd.json.loads(done.stdout)

    def test_the_session_says_what_was_recorded(self):
        recording = self.session["recording"]
        self.assertEqual(recording["path"], self.file)
        self.assertTrue(recording["whole"])
        self.assertEqual(recording["lost"], 0)
        self.assertEqual(recording["differences"], 0)
        self.assertLessEqual(recording["samples"], self.session["steps"], "the loop goes on while the file is closed")
        self.assertGreater(recording["pictures"], 30)
        self.assertGreater(recording["bytes"], 100_000)
        self.assertEqual(os.listdir(self.kept.name), ["session.h5"])

    def test_every_step_is_there_from_the_first_on(self):
        self.json("session", "export", self.file, self.path("steps.csv"), "--fields", "step", "--json")
        with open(self.path("steps.csv"), encoding="utf-8") as file:
            steps = [int(row["step [1]"]) for row in csv.DictReader(file)]
        self.assertEqual(steps, list(range(1, self.session["recording"]["samples"] + 1)))

    def test_info_tells_duration_samples_and_who(self):
        info = self.json("session", "info", self.file, "--json")
        self.assertEqual(info["samples"], self.session["recording"]["samples"])
        self.assertEqual(info["committed_samples"], info["samples"])
        self.assertAlmostEqual(info["duration_s"], 8, delta=2)
        self.assertEqual(info["gaps"], 0)
        self.assertEqual(info["frames"], self.session["recording"]["pictures"])
        self.assertGreater(info["events"], 1)
        self.assertEqual(info["health"], "good", info["health_reason"])
        self.assertEqual((info["operator"], info["subject"], info["notes"]), ("Ada", "S7", "first try"))
        self.assertEqual(info["tags"], ["soft", "dry"])
        self.assertIn("[control]", info["profile"])
        self.assertTrue(info["replayable"])

    def test_what_a_file_says_cannot_steer_the_terminal(self):
        steering = "\x1b[2J\x07\x7f\u009b31m\u0085\r"
        file = self.path(f"a{steering}b.h5")
        shutil.copyfile(self.file, file)
        done = fyd.run("session", "info", file)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("/a?[2J???31m??b.h5\n", done.stdout)
        done = fyd.run("session", "info", file + "none")
        self.assertEqual(done.returncode, 1)
        self.assertIn("/a?[2J???31m??b.h5none: ", done.stderr)
        for shown in (done.stdout, done.stderr):
            self.assertFalse([c for c in shown if c != "\n" and unicodedata.category(c) == "Cc"], ascii(shown))

    def test_a_replay_is_identical_and_many_times_faster(self):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        replay = self.json("session", "replay", self.file, "--json")
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        self.assertTrue(replay["identical"], replay)
        self.assertEqual(replay["samples"], self.session["recording"]["samples"])
        self.assertEqual(replay["different"], 0)
        self.assertIsNone(replay["first_difference_s"])
        self.assertGreater(replay["speed_x"], 0)
        # By the processor's time, which other programs do not use up; far less than it does, for a slow machine.
        work_s = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
        self.assertGreater(1e-3 * replay["samples"] / work_s, 5)

    def test_what_if_differs_and_says_which_loop(self):
        out = self.path("what_if.csv")
        # Counts in every state of the touchpad: a busy machine may have held it at its first cycles.
        replay = self.json("session", "replay", "--set", "sensing.ir_noise_mV=40", self.file, "--telemetry", out, "--json")
        self.assertFalse(replay["identical"])
        self.assertEqual(replay["loop"], "open")
        self.assertGreater(replay["different"], 100)
        with open(out, encoding="utf-8") as file:
            self.assertEqual(sum(1 for _ in csv.DictReader(file)), replay["samples"])

    def test_a_wrong_setting_is_named(self):
        for setting, said in (("x", "'x': expected id=value"), ("x=1", "unknown parameter 'x'"),
                              ("control.nothing=1", "control.nothing"), ("control.kp=abc", "control.kp"),
                              ("link.touch_rate_Hz=50", "a replay changes the step's only")):
            # Whichever the recording: none is looked at.
            self.assertIn(said, self.refused(2, "session", "replay", self.path("nowhere.h5"), "--set", setting))

    def test_a_replay_that_cannot_be_leaves_its_table_as_it_was(self):
        kept = self.write("kept.csv", "mine")
        replay = ("session", "replay", self.file, "--telemetry")
        self.refused(2, *replay, kept, "--set", "control.nothing=1")
        for path in (kept, self.path("new.csv")):  # it takes the recorded values to see that these do not go together
            self.assertIn("expected more than", self.refused(1, *replay, path, "--set", "control.travel_maximum_deg=-20"))
        with open(kept, encoding="utf-8") as file:
            self.assertEqual(file.read(), "mine")
        self.assertEqual(os.listdir(self.folder), ["kept.csv"])

    def test_a_recording_drives_a_session_like_a_device(self):
        result = self.json("station", "--touchpad", "recording:" + self.file, "--robot", "none",
                           "--duration", 4, "--json")
        touchpad, camera = result["parts"][0], result["parts"][1]
        self.assertIn("motors are not driven", touchpad["description"])
        self.assertIn("recording", camera["description"])
        self.assertGreater(result["contact_fraction"], 0.02)
        self.assertIn(result["state"], ("Active", "Held"))

    def test_a_file_is_never_written_over(self):
        before = os.path.getsize(self.file)
        self.assertIn(self.file, self.refused(1, *SESSION, "--duration", 1, "--record", self.file))
        self.assertEqual(os.path.getsize(self.file), before)


class Recording(fyd.Case):
    def test_it_is_there_while_it_grows_and_whole_after_an_interrupt(self):
        path = self.path("quick.h5")
        recorder = recorded(self, path, 500)
        self.assertTrue(os.path.exists(path + ".partial"))
        recorder.stop()
        self.assertFalse(os.path.exists(path + ".partial"))
        info = self.json("session", "info", path, "--json")
        self.assertGreaterEqual(info["samples"], 500)
        self.assertEqual(info["wholeness"], "whole")

    def test_a_folder_that_is_not_there_is_an_error_at_once(self):
        # At once: nobody would see the end of this session.
        self.assertIn("/nowhere", self.refused(1, *SESSION, "--duration", 1e6, "--record", "/nowhere/a.h5"))

    def test_a_subject_is_a_code_and_never_a_name(self):
        for name in ("Anna Rossi", "<b>", "Größe", 33 * "S"):
            path = self.path("named.h5")
            said = self.refused(2, *SESSION, "--duration", 1e6, "--record", path, "--subject", name)
            self.assertIn(f'subject "{name}": expected a code', said)
            self.assertFalse(os.path.exists(path))

    def test_words_for_a_recording_need_one(self):
        self.assertIn("--record", self.refused(2, *SESSION, "--duration", 1, "--operator", "Ada"))


class Crashes(fyd.Case):
    def killed(self):
        path = self.path("killed.h5")
        recorder = recorded(self, path, 1000)
        recorder.process.kill()
        recorder.process.wait()
        return path

    def test_a_killed_recorder_leaves_what_was_committed(self):
        path = self.killed()
        info = self.json("session", "info", path, "--json")
        self.assertEqual(info["path"], path + ".partial")
        self.assertEqual(info["wholeness"], "crashed")
        self.assertNotEqual(info["health"], "good")
        self.assertIn("fyd session recover", info["health_reason"])
        recovered = self.json("session", "recover", path, "--json")
        self.assertEqual(recovered["result"], "whole")
        self.assertGreaterEqual(recovered["samples"], 1000)
        self.assertTrue(self.json("session", "verify", path, "--json")["intact"])
        info = self.json("session", "info", path, "--json")
        self.assertEqual((info["path"], info["health"]), (path, "good"))
        self.assertTrue(self.json("session", "replay", path, "--json")["identical"])

    def test_a_file_of_which_nothing_can_be_read_exits_with_1_and_stays(self):
        path = self.write("gone.h5.partial", "\0" * 5000)
        self.refused(1, "session", "recover", path)
        self.assertEqual(os.path.getsize(path), 5000)

    def test_a_damaged_block_is_found(self):
        path = self.killed()
        self.json("session", "recover", path, "--json")
        with open(path, "r+b") as file:
            data = file.read()
            at = data.index(b"\xff\xd8\xff", len(data) // 4) + 200  # inside a picture
            file.seek(at)
            file.write(bytes([data[at] ^ 0xFF]))
        done = fyd.run("session", "verify", path, "--json")
        self.assertEqual(done.returncode, 1)
        self.assertIn("/camera/bytes", done.stderr)
        recovered = fyd.run("session", "recover", path, "--json")
        self.assertEqual(recovered.returncode, 3, recovered.stderr)
        self.assertTrue(os.path.exists(fyd.json.loads(recovered.stdout)["kept"]))


class BadFiles(fyd.Case):
    def test_what_is_no_recording_is_named(self):
        for command in ("info", "replay"):
            self.assertIn("nothing.h5", self.refused(1, "session", command, self.path("nothing.h5")))
            text = self.write("text.h5", "this is no recording\n" * 50)
            self.assertIn("text.h5", self.refused(1, "session", command, text))
            self.assertIn("empty.h5", self.refused(1, "session", command, self.write("empty.h5", "")))
            self.refused(1, "session", command, self.folder)
            self.refused(2, "session", command)

    def test_a_touchpad_that_is_no_recording_is_named(self):
        self.assertIn("text.h5", self.refused(1, "station", "--touchpad", "recording:" + self.write("text.h5", "x"),
                                              "--duration", 1))


class Trials(fyd.Case):
    def test_every_condition_comes_as_often_as_every_other(self):
        trials = self.json("session", "trials", "--conditions", "a,b,c", "--repetitions", 4, "--seed", 7, "--json")
        self.assertEqual([trial["number"] for trial in trials], list(range(1, 13)))
        for block in range(1, 5):
            self.assertEqual({t["condition"] for t in trials if t["block"] == block}, {"a", "b", "c"})
        again = self.json("session", "trials", "--conditions", "a,b,c", "--repetitions", 4, "--seed", 7, "--json")
        self.assertEqual(trials, again)

    def test_bad_lists_are_wrong_usage(self):
        self.assertIn("'a'", self.refused(2, "session", "trials", "--conditions", "a,a"))
        for words in ("a,,b", "a,", ",a", ","):
            self.assertIn(f"{words}: expected a word", self.refused(2, "session", "trials", "--conditions", words))
        self.refused(2, "session", "trials", "--conditions", "a,b", "--repetitions", 0)
        self.assertIn("--repetitions: -1", self.refused(2, "session", "trials", "--conditions", "a,b", "--repetitions=-1"))
        for option in ("--limit", "--offset"):
            self.assertIn(f"{option}: -1: expected a whole", self.refused(2, "session", "list", self.folder, f"{option}=-1"))
        self.refused(2, "session", "trials")


if __name__ == "__main__":
    unittest.main()
