"""Signals that end programs: each closes the recording whole, of the command line and of the window."""
import csv
import fcntl
import os
import pty
import resource
import shutil
import signal
import subprocess
import termios
import time
import unittest

import fyd

CONSOLE = os.path.join(os.path.dirname(fyd.PROGRAM), "fyd-console")
MOST_WAIT_s = 60


class Case(fyd.Case):
    def wait_for(self, what, condition):
        start = time.monotonic()
        while time.monotonic() - start < MOST_WAIT_s:
            if condition():
                return
            time.sleep(0.05)
        self.fail(f"{what}: not within {MOST_WAIT_s} s")

    def started(self, program, *words, **keywords):
        """A program that records, once a second of it is on the disk."""
        self.recording = self.path("session.h5")
        process = subprocess.Popen([program, *words, "--simulate", "--record", self.recording], **keywords)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        self.wait_for("a second of recording", lambda: self.committed() >= 1000 or process.poll() is not None)
        return process

    def committed(self):
        info = fyd.run("session", "info", self.recording, "--json")
        return fyd.json.loads(info.stdout)["committed_samples"] if info.returncode == 0 else 0

    def ended(self, process):
        try:
            return process.wait(MOST_WAIT_s)
        except subprocess.TimeoutExpired:
            return self.fail(f"still runs {MOST_WAIT_s} s later")

    def expect_whole(self):
        self.assertFalse(os.path.exists(self.recording + ".partial"), "left as a crashed one")
        self.assertTrue(self.json("session", "verify", self.recording, "--json")["intact"])
        info = self.json("session", "info", self.recording, "--json")
        self.assertEqual(info["wholeness"], "whole")
        self.assertGreaterEqual(info["committed_samples"], 1000)


class Station(Case):
    def start(self, *words, **keywords):
        return self.started(fyd.PROGRAM, "station", *words, stderr=subprocess.DEVNULL, **keywords)

    def test_ctrl_c_a_polite_end_and_a_lost_terminal(self):
        for number, code in ((signal.SIGINT, 0), (signal.SIGTERM, 0), (signal.SIGHUP, 129)):
            with self.subTest(number.name):
                process = self.start(stdout=subprocess.DEVNULL)
                process.send_signal(number)
                self.assertEqual(self.ended(process), code)
                self.expect_whole()
                os.unlink(self.recording)

    def test_its_terminal_is_closed(self):
        master, slave = pty.openpty()
        process = self.start(stdin=slave, stdout=slave, start_new_session=True,
                             preexec_fn=lambda: fcntl.ioctl(0, termios.TIOCSCTTY, 0))
        os.close(slave)
        os.close(master)
        self.assertEqual(self.ended(process), 129)
        self.expect_whole()

    def test_nohup_is_obeyed(self):
        process = self.start(stdout=subprocess.DEVNULL, preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        process.send_signal(signal.SIGHUP)
        before = self.committed()
        self.wait_for("going on after SIGHUP", lambda: self.committed() > before + 500 or process.poll() is not None)
        self.assertIsNone(process.poll())
        process.send_signal(signal.SIGTERM)
        self.assertEqual(self.ended(process), 0)
        self.expect_whole()

    def test_nobody_reads_what_it_prints(self):
        read_end, write_end = os.pipe()
        said = open(self.path("said"), "w+", encoding="utf-8")
        self.addCleanup(said.close)
        process = self.started(fyd.PROGRAM, "station", "--duration", "4", stdout=write_end, stderr=said)
        os.close(write_end)
        os.close(read_end)  # as `| head -1` does after its line
        self.assertEqual(self.ended(process), 1)
        self.expect_whole()
        said.seek(0)
        self.assertIn("standard output", said.read())

    def test_nobody_reads_its_messages(self):
        self.recording = self.path("session.h5")
        shell = subprocess.run(["bash", "-c", '"$0" station --simulate --duration 3 --record "$1" 2>&1 | head -1',
                                fyd.PROGRAM, self.recording], capture_output=True, check=False, timeout=MOST_WAIT_s)
        self.assertEqual(len(shell.stdout.splitlines()), 1)
        self.expect_whole()

    def test_whoever_reads_its_telemetry_may_stop_reading(self):
        process = self.start("--telemetry", "/dev/stdout", stdout=subprocess.PIPE, text=True)
        self.addCleanup(process.stdout.close)
        state = process.stdout.readline().strip().split(",").index("state")
        active, stopped = "3", "5"
        while process.stdout.readline().split(",")[state] != active:
            pass
        for number in (None, signal.SIGINT):  # it is stuck in the pipe by then; then it is told to end
            if number:
                process.send_signal(number)
            before = self.committed()
            self.wait_for("a second to be recorded", lambda end=before + 1000: self.committed() > end)
        process.kill()
        process.wait()
        self.json("session", "recover", self.recording, "--json")
        table = self.path("t.csv")
        self.json("session", "replay", self.recording, "--telemetry", table, "--json")
        with open(table, encoding="utf-8") as file:
            states = [row["state"] for row in csv.DictReader(file)]
        self.assertIn(active, states)
        self.assertEqual(states[-1], stopped)

    def test_a_limit_on_files_is_a_full_disk(self):
        # Ten megabytes stay free, as on a disk: the recording closes whole long before it meets the limit.
        limit = 12_000_000
        self.recording = self.path("session.h5")
        with open("/dev/full", "w", encoding="utf-8") as full:
            done = subprocess.run([fyd.PROGRAM, "station", "--simulate", "--duration", "16", "--record", self.recording,
                                   "--set", "session.smallest_free_MB=10", "--telemetry", "/dev/stdout",
                                   "--catalogue", "sqlite:" + self.path("c.sqlite")],
                                  stdout=full, stderr=subprocess.PIPE, text=True, check=False, timeout=MOST_WAIT_s,
                                  preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("is whole up to here", done.stderr)
        self.assertRegex(done.stderr, "fyd: recording: .*; /dev/stdout: writing failed")
        self.expect_whole()
        listed = self.json("session", "list", "--catalogue", "sqlite:" + self.path("c.sqlite"), "--json")["sessions"]
        self.assertEqual([os.path.basename(each["path"]) for each in listed], ["session.h5"])

    def test_a_file_that_may_not_grow_is_an_error_in_words(self):
        limit = 500_000
        done = subprocess.run([fyd.PROGRAM, "station", "--simulate", "--duration", "4", "--telemetry", self.path("t.csv")],
                              capture_output=True, text=True, check=False, timeout=MOST_WAIT_s,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
        self.assertEqual(done.returncode, 1, done.stderr)
        while_it_ran, at_its_end = done.stderr.split("t.csv: writing failed")[1:]
        self.assertIn("\nfyd: ", while_it_ran)
        self.assertNotIn("\nfyd: ", at_its_end)
        self.assertEqual(os.path.getsize(self.path("t.csv")), limit, "the limit was never met: this test shows nothing")

    def test_a_replay_that_cannot_be_written_whole_leaves_what_was_there(self):
        file = self.write("t.csv", "mine\n")
        replay = ["session", "replay", os.path.join(fyd.DATA, "recordings", "arithmetic_2", "classic.h5"), "--telemetry", file]
        limit = 100_000
        done = subprocess.run([fyd.PROGRAM, *replay], capture_output=True, text=True, check=False, timeout=MOST_WAIT_s,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("t.csv: writing failed: File too large", done.stderr)
        with open(file, encoding="utf-8") as left:
            self.assertEqual(left.read(), "mine\n")
        self.assertEqual(os.listdir(self.folder), ["t.csv"])
        self.assertEqual(fyd.run(*replay).returncode, 0)
        self.assertGreater(os.path.getsize(file), limit)


@unittest.skipUnless(os.path.exists(CONSOLE), "built without the window")
class Window(Case):
    def start(self, display=None, stderr=subprocess.DEVNULL):
        display = display or {"QT_QPA_PLATFORM": "offscreen"}
        home = {name: self.path("home") for name in ("HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_RUNTIME_DIR")}
        os.makedirs(self.path("home"), 0o700, exist_ok=True)
        return self.started(CONSOLE, stdout=subprocess.DEVNULL, stderr=stderr, env=os.environ | home | display)

    def test_each_signal_closes_the_recording(self):
        for number in (signal.SIGTERM, signal.SIGHUP, signal.SIGINT):
            with self.subTest(number.name):
                process = self.start()
                process.send_signal(number)
                self.assertEqual(self.ended(process), 128 + number)
                self.expect_whole()
                os.unlink(self.recording)

    def test_a_logout_sends_two_at_once(self):
        process = self.start()
        os.kill(process.pid, signal.SIGSTOP)  # both wait for it
        process.send_signal(signal.SIGTERM)
        process.send_signal(signal.SIGHUP)
        os.kill(process.pid, signal.SIGCONT)
        self.assertIn(self.ended(process), (128 + signal.SIGTERM, 128 + signal.SIGHUP))
        self.expect_whole()


    @unittest.skipUnless(shutil.which("Xvfb"), "there is no Xvfb to kill")
    def test_the_display_dies(self):
        read_end, write_end = os.pipe()
        server = subprocess.Popen(["Xvfb", "-displayfd", str(write_end), "-screen", "0", "1280x800x24"],
                                  pass_fds=[write_end], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(server.wait)
        self.addCleanup(server.kill)
        os.close(write_end)
        with open(read_end, encoding="ascii") as told:
            display = told.readline().strip()
        said = open(self.path("said"), "w+", encoding="utf-8")
        self.addCleanup(said.close)
        process = self.start({"QT_QPA_PLATFORM": "xcb", "DISPLAY": f":{display}"}, stderr=said)
        server.kill()
        self.assertEqual(self.ended(process), 3)
        self.expect_whole()
        said.seek(0)
        self.assertIn("the display is gone", said.read())


if __name__ == "__main__":
    unittest.main()
