"""Files made to hurt: every command that opens a recording ends soon, in little memory, with an error that names the
file, and gives away nothing of other files.

    FYD=build/release/bin/fyd /usr/bin/python3 tests/attack/hostile_files.py [FILES] [SEED]

60 files (the full length) go through every command; without an argument one file of each kind goes through those that
read the most. Linux; needs h5py and numpy. Which kinds there are: hostile_kinds.py.
"""
import os
import random
import resource
import stat
import subprocess
import sys
import tempfile
import time

import hostile_kinds

FYD = os.environ["FYD"]
# What programs keep of a user (the catalogue of sessions, profiles) stays out of the tester's own folders.
HOME = tempfile.TemporaryDirectory()
os.environ |= {"XDG_DATA_HOME": os.path.join(HOME.name, "data"), "XDG_CONFIG_HOME": os.path.join(HOME.name, "config")}
SECRET = b"root:x:0:0:what another user keeps for himself:"
MOST_MEMORY = 1 << 30       # bytes that a command may really use; a usual one takes some 60 MB
MOST_WAIT_s = 120           # far beyond any sound end: a command that hangs is stopped here

QUICK = ("info", "verify", "recover", "add")
EVERY = QUICK + ("replay", "csv", "mat", "mcap", "mkv", "avi", "html", "pdf", "list", "touchpad", "camera", "store")


def arguments(command, file, folder):
    """What is run, in a folder of its own; `file` is a copy there."""
    out = os.path.join(folder, "out")
    catalogue = ["--catalogue", "sqlite:" + os.path.join(folder, "catalogue.db")]
    if command in ("info", "verify", "recover", "replay"):
        return ["session", command, file]
    if command in ("csv", "mat", "mcap", "mkv", "avi"):
        return ["session", "export", file, f"{out}.{command}"]
    if command in ("html", "pdf"):
        return ["session", "report", file, f"{out}.{command}"]
    if command == "add":
        return ["session", "add", os.path.dirname(file), *catalogue]
    if command == "list":
        return ["session", "list", os.path.dirname(file)]
    if command == "store":
        os.mkdir(out)
        return ["session", "store", file, out, *catalogue]
    source = ["--touchpad", "recording:" + file] if command == "touchpad" else ["--simulate", "--camera", "recording:" + file]
    return ["station", *source, "--robot", "none", "--duration", "1"]


def limits():
    os.setsid()
    resource.setrlimit(resource.RLIMIT_FSIZE, (1 << 30, 1 << 30))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def run(words, folder):
    """Ends also what hangs. @return exit code (None: stopped), what it said, most memory, seconds"""
    with tempfile.TemporaryFile() as said:
        start = time.monotonic()
        process = subprocess.Popen([FYD, *words], stdin=subprocess.DEVNULL, stdout=said, stderr=said, cwd=folder,
                                   preexec_fn=limits)
        while time.monotonic() - start < MOST_WAIT_s:
            done, status, usage = os.wait4(process.pid, os.WNOHANG)
            if done:
                process.returncode = os.waitstatus_to_exitcode(status)
                break
            time.sleep(0.005)
        else:
            process.kill()
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = None
        said.seek(0)
        return process.returncode, said.read(), usage.ru_maxrss * 1024, time.monotonic() - start


def holds_secret(folder, hostile):
    """Whether anything but the hostile file and the bait got the secret."""
    for name in os.listdir(folder):
        path = os.path.join(folder, name)
        if path == hostile or name in hostile_kinds.BAIT:
            continue
        if os.path.isdir(path):
            if holds_secret(path, hostile):
                return True
        elif stat.S_ISREG(os.lstat(path).st_mode) and os.path.getsize(path) < 1 << 28:
            with open(path, "rb") as made:
                if SECRET in made.read():
                    return True
    return False


def problems_of(command, kind, seed, good):
    """Makes the file anew for the command, in a folder of its own. @return what is wrong, and figures"""
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "secret"), "wb") as bait:
            bait.write(SECRET * 1000)
        os.mkdir(os.path.join(folder, "in"))
        file = os.path.join(folder, "in", "hostile.h5")
        readable = kind(random.Random(seed), good, file, os.path.join(folder, "secret"))
        code, said, memory, seconds = run(arguments(command, file, folder), folder)
        problems = []
        if code is None:
            problems.append(f"did not end within {MOST_WAIT_s} s")
        elif code < 0:
            problems.append(f"died of signal {-code}")
        elif code not in (0, 1, 2, 3):
            problems.append(f"exit code {code}")
        elif code == 0 and command == "verify" and not readable:
            problems.append("verified as intact")
        elif code != 0 and b"hostile.h5" not in said and command not in ("touchpad", "camera"):
            problems.append("the error names no file")
        if memory > MOST_MEMORY:
            problems.append(f"took {memory >> 20} MB")
        if SECRET in said or holds_secret(folder, file):
            problems.append("gave another file away")
        for entry in hostile_kinds.BAIT:
            if entry == "secret" and os.path.getsize(os.path.join(folder, entry)) != len(SECRET) * 1000:
                problems.append("changed another file")
        return problems, code, said, memory, seconds


def record(folder):
    """A sound recording with pictures, some notes and a robot."""
    file = os.path.join(folder, "good.h5")
    done = subprocess.run([FYD, "station", "--simulate", "--duration", "3", "--record", file, "--notes",
                           "good", "--tag", "attack"], capture_output=True, text=True, check=False, timeout=120)
    assert done.returncode == 0, done.stderr
    return file


def main():
    kinds = hostile_kinds.ALL
    full = len(sys.argv) > 1
    files = max(int(sys.argv[1]) if full else 0, len(kinds))
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else 1
    commands = EVERY if full else QUICK
    wrong, slowest, most = 0, 0.0, 0
    with tempfile.TemporaryDirectory() as folder:
        good = record(folder)
        for i in range(files):
            kind = kinds[i % len(kinds)]
            for command in commands:
                problems, code, said, memory, seconds = problems_of(command, kind, seed + i, good)
                slowest, most = max(slowest, seconds), max(most, memory)
                if full and command == "verify" or problems:
                    words = said.decode(errors="replace").strip().splitlines()
                    print(f"{kind.__name__} (seed {seed + i}), {command}: exit {code}, {seconds:.2f} s, {memory >> 20} MB: "
                          f"{words[-1][:300] if words else ''}")
                for problem in problems:
                    print(f"  FAILED: {problem}")
                    wrong += 1
                sys.stdout.flush()
    print(f"{files} files, {len(kinds)} kinds, {len(commands)} commands: slowest {slowest:.1f} s, most memory {most >> 20} MB, "
          f"{wrong} failed")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
