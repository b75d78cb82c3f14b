"""fyd session list, add, store, tag, notes, forget: the catalogue as an operator meets it."""
import os
import shutil
import sqlite3
import unittest

import fyd

NOTES = "first try'; DROP TABLE sessions; --"


class Catalogue(fyd.Case):
    """Two recordings for all; each test has copies and a catalogue of its own."""

    @classmethod
    def setUpClass(cls):
        cls.kept = fyd.tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.kept.cleanup)
        os.environ["XDG_DATA_HOME"] = cls.kept.name
        for name, operator, subject, tag in (("a.h5", "Ada", "S7", "soft"),
                                             ("b.h5", "Müller", "S8", "dry")):
            done = fyd.run("station", "--simulate", "--duration", 1.5, "--record",
                           os.path.join(cls.kept.name, name), "--operator", operator, "--subject", subject,
                           "--notes", NOTES, "--tag", tag, "--json")
            assert done.returncode == 0, done.stderr

    def setUp(self):
        super().setUp()
        self.data = self.path("data")
        os.mkdir(self.data)
        for name in ("a.h5", "b.h5"):
            shutil.copy2(os.path.join(self.kept.name, name), self.data)
        self.a = os.path.join(self.data, "a.h5")
        self.file = self.path("catalogue.sqlite")
        self.word = ("--catalogue", "sqlite:" + self.file)

    def list(self, *filters):
        return self.json("session", "list", *self.word, "--json", *filters)

    def ids(self, *filters):
        return [s["id"] for s in self.list(*filters)["sessions"]]

    def test_add_list_and_search(self):
        self.assertEqual(self.json("session", "add", self.data, *self.word, "--json")["added"], 2)
        self.assertEqual(self.json("session", "add", self.a, *self.word, "--json")["known"], 1)
        listed = self.list("--sort", "operator", "--ascending")
        self.assertEqual(listed["found"], 2)
        ada, mueller = listed["sessions"]
        self.assertEqual((ada["operator"], ada["notes"], ada["tags"]), ("Ada", NOTES, ["soft"]))
        self.assertEqual(ada["subject"], "S7")
        self.assertEqual((ada["health"], ada["wholeness"], ada["gaps"]), ("good", "whole", 0))
        self.assertEqual(ada["path"], os.path.realpath(self.a))
        self.assertEqual(ada["bytes"], os.path.getsize(self.a))
        self.assertGreater(ada["samples"], 500)
        self.assertEqual(self.ids("--text", "MÜLLER first"), [mueller["id"]])
        self.assertEqual(self.ids("--tag", "soft"), [ada["id"]])
        self.assertEqual(self.ids("--tag", "soft", "--tag", "dry"), [])
        self.assertEqual(self.ids("--subject", ada["subject"]), [ada["id"]])
        self.assertEqual(len(self.ids("--since", ada["started_utc"][:10])), 2)
        self.assertEqual(self.ids("--until", "2020-01-01"), [])
        self.assertEqual(len(self.ids("--limit", 1)), 1)

        table = fyd.run("session", "list", *self.word).stdout.splitlines()
        self.assertEqual(len(table), 4)
        self.assertEqual(len({line.index(name) for line, name in zip(table[1:3], ("Müller", "Ada"))}), 1, table)

    def test_a_folder_is_listed_without_writing(self):
        listed = self.json("session", "list", self.data, "--json", "--text", "ada")
        self.assertEqual([s["operator"] for s in listed["sessions"]], ["Ada"])
        self.assertEqual(sorted(os.listdir(self.data)), ["a.h5", "b.h5"])
        self.assertFalse(os.path.exists(self.file))

    def test_a_folders_list_says_what_it_leaves_out(self):
        copy = os.path.join(self.data, "z.h5")
        shutil.copy2(self.a, copy)
        listed = self.json("session", "list", self.data, "--json")
        self.assertEqual((listed["found"], listed["copies"]), (2, [os.path.realpath(copy)]))
        rubbish = os.path.join(self.data, "rubbish.h5")
        with open(rubbish, "wb") as file:
            file.write(b"x" * 1000)
        for command in ("list", "add"):
            with self.subTest(command=command):
                done = fyd.run("session", command, self.data, *(self.word if command == "add" else ()))
                self.assertEqual(done.returncode, 1)
                self.assertIn("copy, left out: " + os.path.realpath(copy), done.stdout)
                self.assertIn("not read: ", done.stdout)
                self.assertIn("rubbish.h5", done.stderr)
        done = fyd.run("session", "list", self.data, "--json")
        self.assertEqual(done.returncode, 1)
        self.assertIn("rubbish.h5", done.stdout)

    def test_a_link_to_a_recording_is_read_with_its_reviews_tags(self):
        folder = self.path("links")
        os.mkdir(folder)
        link = os.path.join(folder, "link.h5")
        os.symlink(self.a, link)
        with open(self.a + ".notes.json", "w", encoding="utf-8") as file:
            file.write('{"notes": [{"time_s": 0.5, "kind": "note", "text": "seen later"}], "tags": ["reviewed"]}')
        self.json("session", "add", link, *self.word, "--json")
        entry = self.list()["sessions"][0]
        self.assertEqual((entry["path"], entry["tags"]), (os.path.realpath(self.a), ["reviewed"]))
        self.assertIn("seen later", entry["notes"])

    def test_notes_and_tags_stay_when_the_file_is_read_again(self):
        self.json("session", "add", self.a, *self.word, "--json")
        id_ = self.ids()[0]
        self.assertEqual(self.json("session", "notes", id_[:8], "wool, wet", *self.word, "--json")["notes"], "wool, wet")
        tags = self.json("session", "tag", self.a, "--add", "pilot", "--remove", "soft", *self.word, "--json")["tags"]
        self.assertEqual(tags, ["pilot"])
        self.json("session", "add", self.a, *self.word, "--json")
        self.assertEqual(self.ids("--text", "wet", "--tag", "pilot"), [id_])
        self.assertIn("no tag 'soft'", self.refused(1, "session", "tag", id_, "--remove", "soft", *self.word))
        tags = self.json("session", "tag", id_, "--add", "Pilot", "--remove", "PILOT", *self.word, "--json")["tags"]
        self.assertEqual(tags, ["Pilot"])
        self.json("session", "forget", id_, *self.word, "--json")
        self.assertEqual(self.ids(), [])
        self.assertTrue(os.path.exists(self.a))

    def test_store_moves_the_file_and_its_entry(self):
        share = self.path("share")
        os.mkdir(share)
        with open(self.a, "rb") as file:
            content = file.read()
        done = self.json("session", "store", self.a, share, *self.word, "--json")
        self.assertFalse(os.path.exists(self.a))
        with open(done["path"], "rb") as file:
            self.assertEqual(file.read(), content)
        entry = self.list()["sessions"][0]
        self.assertEqual((entry["path"], entry["file_state"]), (done["path"], "present"))
        self.assertEqual(self.list("--check")["changes"], [])

        b = os.path.join(self.data, "b.h5")
        self.assertIn("stays at", self.refused(1, "session", "store", b, self.path("nowhere"), *self.word))
        shutil.copy(b, os.path.join(share, "other.h5"))
        os.rename(os.path.join(share, "other.h5"), os.path.join(share, "b.h5"))
        with open(os.path.join(share, "b.h5"), "ab") as file:
            file.write(b"x")
        self.assertIn("another file of this name", self.refused(1, "session", "store", b, share, *self.word))
        self.assertTrue(os.path.exists(b))

    def test_files_that_moved_are_found(self):
        self.json("session", "add", self.data, *self.word, "--json")
        os.mkdir(os.path.join(self.data, "2026"))
        os.rename(self.a, os.path.join(self.data, "2026", "renamed.h5"))
        os.remove(os.path.join(self.data, "b.h5"))
        changes = {c["change"]: c for c in self.list("--check")["changes"]}
        self.assertEqual(set(changes), {"moved", "missing"})
        self.assertTrue(changes["moved"]["new_path"].endswith("2026/renamed.h5"))
        self.assertIn("[missing]", fyd.run("session", "list", *self.word).stdout)

    def test_a_catalogue_that_is_not_there_is_not_made_by_looking_at_it(self):
        folder = self.path("new")
        absent = ("--catalogue", f"sqlite:{folder}/sessions.sqlite")
        for command in (["list"], ["list", "--check"], ["tag", "abcd", "--add", "x"], ["notes", "abcd", "x"],
                        ["forget", "abcd"]):
            with self.subTest(command=command):
                said = self.refused(1, "session", *command, *absent)
                self.assertIn(f"{folder}/sessions.sqlite: there is no catalogue; `fyd session add` makes one", said)
                self.assertFalse(os.path.exists(folder))
        self.json("session", "add", self.a, *absent, "--json")
        self.assertEqual(self.json("session", "list", *absent, "--json")["found"], 1)

    def test_this_users_own_catalogue_is_empty_before_anything_is_in_it(self):
        for word in ((), ("--catalogue", "sqlite")):
            environment = os.environ | {"XDG_DATA_HOME": self.path("home" + str(len(word)))}
            done = fyd.subprocess.run([fyd.PROGRAM, "session", "list", "--json", *word], env=environment, check=False,
                                      capture_output=True, text=True, timeout=fyd.PATIENCE)
            self.assertEqual((done.returncode, fyd.json.loads(done.stdout)["found"]), (0, 0), done.stderr)

    def test_the_own_catalogues_advice_needs_no_name(self):
        os.makedirs(self.path("fyd-console"))
        own = self.path("fyd-console/sessions.sqlite")
        shutil.copy(self.catalogue_of_a(), own)
        with open(own, "r+b") as file:
            file.write(b"x" * 1000)
        done = fyd.subprocess.run([fyd.PROGRAM, "session", "list"], env=os.environ | {"XDG_DATA_HOME": self.folder},
                                  check=False, capture_output=True, text=True, timeout=fyd.PATIENCE)
        self.assertEqual(done.returncode, 1)
        self.assertIn("`fyd session list --rebuild FOLDER`", done.stderr)

    def catalogue_of_a(self):
        self.json("session", "add", self.a, *self.word, "--json")
        return self.file

    def test_a_damaged_catalogue_is_said_and_rebuilt(self):
        self.json("session", "add", self.data, *self.word, "--json")
        with open(self.file, "r+b") as file:
            file.write(b"x" * 1000)
        said = self.refused(1, "session", "list", *self.word)
        self.assertIn("damaged", said)
        self.assertIn(f"`fyd session list --rebuild FOLDER --catalogue 'sqlite:{self.file}'`", said)
        rebuilt = self.json("session", "list", self.data, *self.word, "--rebuild", "--json")
        self.assertTrue(os.path.exists(rebuilt["moved_aside"]))
        self.assertEqual(rebuilt["scan"]["added"], 2)
        self.assertEqual(len(self.ids()), 2)

    def test_what_is_no_catalogue_is_neither_written_nor_moved(self):
        self.write("notes.sqlite", "no database\n" * 1000)
        other = sqlite3.connect(self.path("other.sqlite"))
        other.execute("CREATE TABLE mine (x)")
        other.commit()
        other.close()
        for path, why in ((self.a, "is no catalogue"), (self.path("notes.sqlite"), "is no catalogue"),
                          (self.path("other.sqlite"), "is another program's database")):
            with open(path, "rb") as file:
                before = file.read()
            for more in ([], ["--rebuild"]):
                said = self.refused(1, "session", "list", *more, "--catalogue", f"sqlite:{path}")
                self.assertIn(f"{path}: {why}", said)
            with open(path, "rb") as file:
                self.assertEqual(file.read(), before)
        self.assertEqual([name for name in os.listdir(self.data) + os.listdir(self.folder) if "damaged" in name], [])

    def test_a_folder_after_a_tag_is_a_folder(self):
        self.assertEqual(self.json("session", "list", "--tag", "soft", self.data, "--json")["found"], 1)

    def test_a_locked_catalogue_names_its_holder(self):
        self.json("session", "add", self.a, *self.word, "--json")
        holder = sqlite3.connect(self.file, isolation_level=None)
        self.addCleanup(holder.close)
        holder.execute("BEGIN IMMEDIATE")
        said = self.refused(1, "session", "notes", self.a, "x", *self.word)
        self.assertIn("locked", said)
        self.assertIn(f"process {os.getpid()}", said)
        self.assertEqual(len(self.ids()), 1, "reading goes on")

    def test_what_is_no_recording_is_named(self):
        text = self.write("c.h5", "no recording")
        done = fyd.run("session", "add", text, *self.word)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr.count(text), 1, done.stderr)
        done = fyd.run("session", "list", self.data)
        self.assertEqual(done.stderr, "")
        shutil.copy(text, self.data)
        done = fyd.run("session", "list", self.data)
        self.assertEqual(done.stderr.count(self.data), 1, done.stderr)
        self.refused(2, "session", "list", self.data, *self.word)

    def test_words_that_mean_nothing_are_refused_before_anything_is_opened(self):
        for command in (["list"], ["list", "--rebuild"], ["add", self.a], ["store", self.a, self.folder],
                        ["tag", self.a, "--add", "x"], ["notes", self.a, "x"], ["forget", self.a]):
            with self.subTest(command=command):
                said = self.refused(2, "session", *command, "--catalogue", "mysql:x")
                self.assertIn("catalogue 'mysql:x': expected sqlite:PATH", said)
        for words, said in ((["list", "--since", "yesterday"], "time 'yesterday': expected UTC"),
                            (["list", "--until", "2026-02-30"], "time '2026-02-30': expected UTC"),
                            (["list", "--text", "\x1b[2J"], "control character"),
                            (["list", "--tag", "a\nb"], "control character"),
                            (["tag", self.a, "--add", "a\nb"], "control character"),
                            (["list", "--rebuild", "--check"], "--check"),
                            (["list", "--rebuild", "--since", "2026-01-01"], "--since"),
                            (["list", "--rebuild", "--limit", "1"], "--limit")):
            with self.subTest(words=words):
                self.assertIn(said, self.refused(2, "session", *words, *self.word))
        self.assertFalse(os.path.exists(self.file))

    def test_a_folder_that_cannot_be_read_again_is_named(self):
        for json in ([], ["--json"]):
            done = fyd.run("session", "list", self.path("nowhere"), "--rebuild", *self.word, *json)
            self.assertEqual(done.returncode, 1, done.stdout)
            self.assertIn("nowhere", done.stderr)
            self.assertIn("nowhere", done.stdout)

    def test_a_password_is_refused_and_an_absent_server_named(self):
        said = self.refused(2, "session", "list", "--catalogue", "postgresql:host=127.0.0.1 port=1 password=hunter2")
        self.assertNotIn("hunter2", said)
        self.assertIn(".pgpass", said)
        os.environ["PGPASSWORD"] = "hunter2"
        self.addCleanup(os.environ.pop, "PGPASSWORD")
        said = self.refused(1, "session", "add", self.a, "--catalogue", "postgresql:host=127.0.0.1 port=1 dbname=fyd")
        self.assertNotIn("hunter2", said)
        self.assertIn("127.0.0.1", said)

    def test_a_note_cannot_steer_the_terminal(self):
        self.json("session", "add", self.a, *self.word, "--json")
        self.assertIn("control character", self.refused(2, "session", "notes", self.a, "\x1b[2J", *self.word))


if __name__ == "__main__":
    unittest.main()
