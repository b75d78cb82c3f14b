"""With --json a failed command prints {"error": {kind, format, values, text}}: every command that has --json."""
import json
import os
import re
import tempfile
import unittest

from fyd import DATA, run

KINDS = {"command", "input", "device", "link", "recording", "calibration", "algorithm", "simulation", "station"}


def commands(path=()):
    """Every command without subcommands, as a list of words, with its help."""
    text = run(*path, "--help").stdout
    below = re.search(r"^Subcommands:\n((?:  .*\n?)+)", text, re.MULTILINE)
    names = re.findall(r"^  ([a-z][\w-]*)", below[1], re.MULTILINE) if below else []
    if not names:
        yield list(path), text
    for name in names:
        yield from commands((*path, name))


def filled(format_, values):
    """Python's places are fmt's: the text again, from its parts."""
    shown = [value["text"] if isinstance(value, dict) else value for value in values]
    return format_.format(*shown)


class JsonErrors(unittest.TestCase):
    def error_of(self, code, *arguments):
        done = run(*arguments)
        self.assertEqual(done.returncode, code, (arguments, done.stdout, done.stderr))
        document = json.loads(done.stdout)
        error = document["error"]
        self.assertEqual(list(error), ["kind", "format", "values", "text"], arguments)
        self.assertIn(error["kind"], KINDS, arguments)
        self.assertEqual(filled(error["format"], error["values"]), error["text"], arguments)
        return document, error, done.stderr

    def test_every_command_with_json_says_wrong_usage_in_it(self):
        with_json = [path for path, text in commands() if "--json" in text]
        self.assertGreater(len(with_json), 25)
        for path in with_json:
            with self.subTest(" ".join(path)):
                document, error, said = self.error_of(2, *path, "--json", "--no-such-option")
                self.assertEqual(list(document), ["error"])
                self.assertEqual(error["kind"], "command")
                self.assertIn(error["text"].splitlines()[0], said)

    def test_what_fails_says_its_parts(self):
        nowhere = os.path.join(DATA, "no-such-file")
        for arguments, kind, what in (
                (("session", "info", nowhere, "--json"), "input", nowhere),
                (("session", "verify", nowhere, "--json"), "input", nowhere),
                (("session", "replay", nowhere, "--json"), "input", nowhere),
                (("session", "recover", nowhere, "--json"), "recording", nowhere),
                (("session", "export", nowhere, nowhere + ".csv", "--json"), "input", nowhere),
                (("calibrate", "load-cell", nowhere, "--json"), "input", nowhere),
                (("station", "--simulate", "--profile", nowhere, "--json"), "input", nowhere),
                (("station", "--simulate", "--set", "control.kd=x", "--json"), None, "control.kd"),
                (("params", "--profile", nowhere, "--json"), "input", nowhere),
                (("texture", "render", nowhere, "--json"), "input", nowhere)):
            with self.subTest(" ".join(arguments)):
                code = 2 if kind is None else 1
                document, error, said = self.error_of(code, *arguments)
                self.assertEqual(list(document), ["error"])
                self.assertEqual(error["kind"], kind or "command")
                self.assertIn(what, error["text"])
                self.assertEqual(said, f"fyd: {error['text']}\n")

    def test_a_number_stays_a_number_and_a_reason_a_message(self):
        _, error, _ = self.error_of(2, "station", "--simulate", "--set", "control.kp=-1.5", "--json")
        self.assertEqual(error["format"], "--set {}")
        inner = error["values"][0]
        self.assertEqual((inner["kind"], inner["format"]), ("input", "{} = {}: expected {}"))
        self.assertEqual(inner["values"][:2], ["control.kp", -1.5])
        self.assertEqual(inner["values"][2]["format"], "a number from {} to {}{}")

    def test_a_result_that_is_there_stays_beside_the_error(self):
        with tempfile.TemporaryDirectory() as folder:
            empty = os.path.join(folder, "no.jpg")
            with open(empty, "wb"):
                pass
            document, error, _ = self.error_of(1, "finger", empty, "--json")
            self.assertEqual([each["image"] for each in document["result"]], [empty])
            self.assertEqual(error["kind"], "device")
        document, error, _ = self.error_of(1, "devices", "--camera", "/no/such/camera", "--json")
        self.assertFalse(document["asked"][0]["answers"])
        self.assertEqual(error["text"], "not every device that was asked answers")

    def test_without_json_nothing_stands_on_standard_output(self):
        done = run("session", "info", os.path.join(DATA, "no-such-file"))
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertTrue(done.stderr.startswith("fyd: "))


if __name__ == "__main__":
    unittest.main()
