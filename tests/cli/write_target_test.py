"""Whatever a command writes goes to a regular file: never in the place of a device or a pipe, through links, with the
mode the file had; or to standard output where it is named."""
import filecmp
import os
import shutil
import stat
import subprocess
import unittest

import fyd

SESSION = ("station", "--simulate", "--duration", 1)


class WriteTargets(fyd.Case):
    @classmethod
    def setUpClass(cls):
        cls.kept = fyd.tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.kept.cleanup)
        cls.recording = os.path.join(cls.kept.name, "session.h5")
        done = fyd.run(*SESSION, "--record", cls.recording)
        assert done.returncode == 0, done.stderr

    def writers(self):
        """name of the file, the command that writes it"""
        signal = self.write("signal.csv", "t_s,ax,ay,az\n" + "".join(f"{i / 1000},{i % 7 / 7},0,1\n" for i in range(2000)))
        yield "profile.toml", lambda to: ("params", "--save", to)
        yield "t.csv", lambda to: (*SESSION, "--telemetry", to)
        yield "course.csv", lambda to: ("stiffness", "--target", 0.6, "--course", to)
        yield "surface.toml", lambda to: ("texture", "fit", signal, "--output", to)
        yield "out.csv", lambda to: ("session", "export", self.recording, to, "--force")
        yield "out.mat", lambda to: ("session", "export", self.recording, to, "--force")
        yield "out.mcap", lambda to: ("session", "export", self.recording, to, "--force")
        yield "out.avi", lambda to: ("session", "export", self.recording, to, "--force")
        yield "out.html", lambda to: ("session", "report", self.recording, to, "--force")
        yield "out.pdf", lambda to: ("session", "report", self.recording, to, "--force")

    def test_a_pipe_and_a_device_are_refused_and_stay(self):
        device = os.stat("/dev/null")
        for name, command in self.writers():
            with self.subTest(name):
                path = self.path(name)
                os.mkfifo(path)
                self.assertIn(f"{name}: is a pipe, not a file", self.refused(1, *command(path)))
                self.assertTrue(stat.S_ISFIFO(os.lstat(path).st_mode))
                os.unlink(path)
                os.symlink("/dev/null", path)
                self.assertIn(f"{name}: is a device, not a file", self.refused(1, *command(path)))
                self.assertTrue(os.path.islink(path))
                self.assertEqual(os.stat("/dev/null").st_ino, device.st_ino)

    def test_a_link_is_followed_and_the_mode_stays(self):
        os.mkdir(self.path("far"))
        for name, command in self.writers():
            with self.subTest(name):
                path, real = self.path(name), self.path(os.path.join("far", name))
                with open(real, "w", encoding="utf-8") as file:
                    file.write("old")
                os.chmod(real, 0o640)
                os.symlink(real, path)
                done = fyd.run(*command(path))
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertTrue(os.path.islink(path))
                with open(real, "rb") as file:
                    self.assertNotEqual(file.read(3), b"old")
                self.assertEqual(stat.S_IMODE(os.stat(real).st_mode), 0o640)

    def test_keys_and_recordings_never_take_another_place(self):
        for name in ("lab.key", "new.h5"):
            os.symlink(self.path("elsewhere"), self.path(name))
        self.assertIn("exists", self.refused(1, "link", "keygen", self.path("lab.key")))
        self.assertIn("exists", self.refused(1, *SESSION, "--record", self.path("new.h5")))
        self.assertFalse(os.path.exists(self.path("elsewhere")))

    def test_a_key_or_notes_behind_a_pipe_hold_nobody_up(self):
        os.mkfifo(self.path("lab.key"))
        self.assertIn("not a regular file",
                      self.refused(1, *SESSION, "--robot", "link:127.0.0.1:0", "--key", self.path("lab.key")))

    def test_a_catalogue_is_a_file(self):
        for to in ("/dev/zero", "pipe"):
            path = self.path("catalogue" + to.replace("/", "-"))
            os.mkfifo(path) if to == "pipe" else os.symlink(to, path)
            for words in (["list"], ["list", "--rebuild"]):
                said = fyd.run("session", *words, "--catalogue", "sqlite:" + path)
                self.assertNotEqual(said.returncode, 0)
            self.assertTrue(os.path.islink(path) or stat.S_ISFIFO(os.stat(path).st_mode))

    def test_standard_output_can_be_named(self):
        done = subprocess.run([fyd.PROGRAM, "stiffness", "--target", "0.6", "--course", "/dev/stdout", "--json"],
                              capture_output=True, text=True, check=False, timeout=120)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(done.stdout.startswith("time_s,true_N_per_mm"))
        kept = os.open(self.path("rows.csv"), os.O_WRONLY | os.O_CREAT)
        done = subprocess.run([fyd.PROGRAM, *map(str, SESSION), "--telemetry", f"/dev/fd/{kept}"], pass_fds=[kept],
                              capture_output=True, text=True, check=False, timeout=120)
        os.close(kept)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("rows.csv"), encoding="utf-8") as file:
            self.assertIn("t_s", file.readline())

    def test_why_a_table_could_not_be_written_is_said(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            done = subprocess.run([fyd.PROGRAM, "stiffness", "--target", "0.6", "--course", "/dev/stdout"], stdout=full,
                                  stderr=subprocess.PIPE, text=True, check=False, timeout=fyd.PATIENCE)
        self.assertEqual(done.returncode, 1)
        self.assertIn("/dev/stdout: writing failed: No space left on device", done.stderr)

    def test_what_a_command_reads_and_recordings_are_never_written_over(self):
        kept = self.path("kept.dat")  # a recording by its bytes
        shutil.copy(self.recording, kept)
        path = self.write("path.csv", "t_s,x_mm,y_mm,z_mm\n0,0,0,1\n0.1,0,0,0\n")
        link = self.path("link.csv")
        os.symlink("path.csv", link)
        table, page, leading = self.path("table.csv"), self.path("page.html"), self.path("leading.mat")
        for name in (table, page):
            shutil.copy(self.recording, name)
        os.symlink("table.csv", leading)
        for to, command in ((table, ("session", "export", table, "--force")),
                            (table, ("session", "export", self.recording, "--force")),
                            (leading, ("session", "export", self.recording, "--force")),
                            (page, ("session", "report", page, "--force")),
                            (page, ("session", "report", self.recording, "--force")),
                            (self.recording, ("session", "replay", self.recording, "--telemetry")),
                            (kept, ("session", "replay", self.recording, "--telemetry")),
                            (kept, ("params", "--save")),
                            (link, ("scene", "run", "echography", "--path", path, "-o")),
                            (path, ("predict", path, "--columns", "x_mm", "--out")),
                            (self.path("new.h5"), ("stiffness", "--target", 0.6, "--course"))):
            with self.subTest(command=command):
                before = None
                if os.path.exists(to):
                    with open(to, "rb") as file:
                        before = file.read()
                self.assertIn("choose another name", self.refused(1, *command, to))
                if before is None:
                    self.assertFalse(os.path.exists(to))
                else:
                    with open(to, "rb") as file:
                        self.assertEqual(file.read(), before)
        for out, beside in (("new.csv", "new.events.csv"), ("new.avi", "new.times.csv")):
            shutil.copy(self.recording, self.path(beside))
            said = self.refused(1, "session", "export", self.recording, self.path(out), "--force")
            self.assertIn(f"{beside}: is, or is named as, a recording", said)
            self.assertFalse(os.path.exists(self.path(out)))
            self.assertTrue(filecmp.cmp(self.recording, self.path(beside), shallow=False))
        new = self.path("new.fyd")
        self.assertIn("choose another name", self.refused(1, *SESSION, "--record", new, "--telemetry", new))
        self.assertFalse(os.path.exists(new) or os.path.exists(new + ".partial"))

    def test_standard_output_is_written_where_it_stands(self):
        """What the file held before stays, and the summary follows the rows."""
        with open(self.path("all"), "w", encoding="utf-8") as file:
            file.write("before\n")
        with open(self.path("all"), "a", encoding="utf-8") as file:
            done = subprocess.run([fyd.PROGRAM, *map(str, SESSION), "--telemetry", "/dev/stdout", "--json"], stdout=file,
                                  stderr=subprocess.PIPE, text=True, check=False, timeout=fyd.PATIENCE)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("all"), encoding="utf-8") as file:
            first, names, *rest = file.read().splitlines()
        self.assertEqual(first, "before")
        rows = rest[:rest.index("{")]
        self.assertGreater(len(rows), 500)
        self.assertEqual({row.count(",") for row in rows}, {names.count(",")})
        self.assertIn("telemetry_lost", "".join(rest[len(rows):]))


if __name__ == "__main__":
    unittest.main()
