"""Runs the command line for the tests."""
import contextlib
import functools
import itertools
import json
import os
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = os.environ["FYD"]
# What programs keep of a user (the catalogue of sessions, profiles) stays out of the tester's own folders.
HOME = tempfile.TemporaryDirectory()
os.environ |= {"XDG_DATA_HOME": os.path.join(HOME.name, "data"), "XDG_CONFIG_HOME": os.path.join(HOME.name, "config")}
DATA = os.path.join(os.environ["FYD_SOURCE_DIR"], "tests", "data")

# Sanitizers' and the coverage preset build none.
needs_bench = unittest.skipUnless(os.path.exists(os.path.join(os.path.dirname(PROGRAM), "fyd-bench")), "fyd-bench is not built")

# Nothing that a test waits for takes so long on a machine that does anything else: it does not come.
PATIENCE = 120  # s


def run(*arguments, timeout=PATIENCE):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=timeout, check=False)


def wait_for(what, holds, seconds=PATIENCE):
    """Looks until holds() is true and returns what it gave; says in vain what was waited for."""
    end = time.monotonic() + seconds
    while True:
        late = time.monotonic() > end  # the last look is after the end
        found = holds()
        if found:
            return found
        if late:
            raise AssertionError(f"waited {seconds} s for {what} in vain")
        time.sleep(0.02)


def free_port(host="127.0.0.1", kind=socket.SOCK_DGRAM):
    with socket.socket(socket.AF_INET, kind) as probe:
        probe.bind((host, 0))
        return probe.getsockname()[1]


def wait_for_udp(host, port):
    """Until a program of this network namespace listens there: the system says so, no packet is sent."""
    address = f"{int.from_bytes(socket.inet_aton(host), sys.byteorder):08X}:{port:04X}"

    def listens():
        with open("/proc/net/udp", encoding="ascii") as table:
            return any(line.split()[1] == address for line in list(table)[1:])

    wait_for(f"UDP {host}:{port} to be listened on", listens)


class BusyMachine(AssertionError):
    """The machine stood still so long that the station went to safe by itself: the journey proves nothing."""


def not_held_by_the_machine(session):
    """Raises BusyMachine when a session's result says that a haptic loop which stood still or missed cycles held it."""
    if any(late in session["reason"] for late in ("haptic loop stood still", "haptic cycles of one second were missed")):
        raise BusyMachine(session["reason"])


def lateness_of_the_machine(seconds=2.0):
    """How late this machine wakes a process that sleeps a millisecond at a time: the longest gap in ms, the share of
    milliseconds missed in %. By the station's own rule, more than 20 ms or 5 % are no machine for it."""
    begin = last = time.monotonic()
    longest, turns = 0.0, 0
    while last - begin < seconds:
        time.sleep(0.001)
        now = time.monotonic()
        longest, last, turns = max(longest, now - last), now, turns + 1
    a_turn = 0.00125  # sleeping a millisecond takes a little longer on the best of machines
    return 1e3 * longest, 100 * max(0.0, 1 - turns * a_turn / (last - begin))


def some_tries(test):
    """Runs a test of a fyd.Case anew, from its setUp on, when it met a busy machine. The fifth time that is a failure,
    unless a look at the machine itself says that it cannot be otherwise."""
    @functools.wraps(test)
    def again(self):
        for last in (False, False, False, False, True):
            try:
                return test(self)
            except BusyMachine as busy:
                if last:
                    gap_ms, missed_percent = lateness_of_the_machine()
                    if gap_ms > 20 or missed_percent > 5:
                        self.skipTest(f"{busy}, five times; this machine wakes a sleeping process {gap_ms:.0f} ms late and "
                                      f"misses {missed_percent:.0f} % of milliseconds")
                    raise
                self.doCleanups()
                self.setUp()
    return again


class Running:
    """A fyd beside the test. What it says on standard error is read while it runs; its end gives its result."""
    def __init__(self, case, *arguments, prefix=()):
        self.case = case
        self.log_path = case.path(f"log {next(self.numbers)}")
        with open(self.log_path, "w", encoding="utf-8") as log:
            self.process = subprocess.Popen([*prefix, PROGRAM, *map(str, arguments)], stdout=subprocess.PIPE, stderr=log,
                                            text=True)
        case.addCleanup(self.process.stdout.close)
        case.addCleanup(self.process.wait)
        case.addCleanup(self.process.kill)

    numbers = itertools.count()

    def log(self):
        with open(self.log_path, encoding="utf-8") as file:
            return file.read()

    def await_log(self, words):
        def said():
            ended = self.process.poll() is not None
            if words not in self.log() and ended:
                raise AssertionError(f"{words!r} was never said, and it ended with {self.process.returncode}:\n{self.log()}")
            return words in self.log()
        wait_for(f"{words!r} to be said", said)

    def held_early(self):
        """Raises BusyMachine when it is Held before a test has done anything that could."""
        if "Held" in self.log():
            raise BusyMachine("the machine held the session before the test did")

    def runs(self):
        return self.process.poll() is None

    def result(self):
        """Of one that ends by itself."""
        out, _ = self.process.communicate(timeout=PATIENCE)
        self.case.assertEqual(self.process.returncode, 0, self.log())
        return json.loads(out)

    def stop(self, how=signal.SIGINT):
        """Of one that runs until it is interrupted."""
        self.process.send_signal(how)
        return self.result()


class Telemetry:
    """What a `fyd station --telemetry FILE` has written so far: the session as it goes, step by step."""
    RUNNING, LOST = 2, 5  # of the column "link"

    def __init__(self, case):
        self.path = case.path("telemetry.csv")

    def newest(self):
        """The newest whole row, by column; nothing when there is none."""
        with contextlib.suppress(FileNotFoundError), open(self.path, "rb") as file:
            names = file.readline().decode().strip().split(",")
            file.seek(max(file.tell(), os.path.getsize(self.path) - 10_000))
            rows = file.read().split(b"\n")[:-1]
            if rows and rows[-1].count(b",") == len(names) - 1:
                return dict(zip(names, map(float, rows[-1].decode().split(","))))
        return {}

    def wait_for(self, what, holds):
        def seen():
            row = self.newest()
            return bool(row) and holds(row)
        wait_for(what, seen)

    def pass_steps(self, count):
        """What may happen within so many steps has happened then."""
        self.wait_for("the first step", lambda row: True)
        end = self.newest()["step"] + count
        self.wait_for(f"step {end:.0f}", lambda row: row["step"] >= end)


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)
        return self.path(name)

    def json(self, *arguments, **keywords):
        done = run(*arguments, **keywords)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def refused(self, code, *arguments):
        """The operation fails with this exit code; returns what it says on standard error."""
        done = run(*arguments)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        if "--json" in arguments:
            self.assertEqual(list(json.loads(done.stdout)), ["error"])
        else:
            self.assertEqual(done.stdout, "")
        self.assertNotEqual(done.stderr, "")
        return done.stderr

    def of_a_pipe(self, text, *arguments):
        """Runs it with /dev/stdin, a pipe that holds this text, as one of its words, and JSON as its answer."""
        done = subprocess.run([PROGRAM, *map(str, arguments)], input=text, capture_output=True, text=True,
                              timeout=PATIENCE, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)
