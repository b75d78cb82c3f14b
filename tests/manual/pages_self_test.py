"""The tests of pages and pictures find what is wrong: a copy of the manual with one fault of each kind."""
import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(os.environ["FYD_SOURCE_DIR"])
FOLDER = Path(__file__).parent

# A line of a page, and what the tests must say of it. An option is looked for where every program is built.
PLANTED = {
    "`core/pipeline/no_such_file.h`": "there is no core/pipeline/no_such_file.h",
    "[a link](operate.md#no-such-heading)": "operate.md#no-such-heading",
    "`control.no_such_gain`": "there is no parameter control.no_such_gain",
    "`test_pipeline --gtest_filter='SafetyTable.NoSuchTest'`": "no test fits SafetyTable.NoSuchTest",
    "`SafetyTable.NoSuchOne`": "there is no test SafetyTable.NoSuchOne",
    "`kNoSuchConstant_s`": "the code has no kNoSuchConstant_s",
    "`attack_no_such_thing`": "ctest knows no attack_no_such_thing",
    "`fyd session list --until-when`": "fyd session list has no option --until-when",
}


class Planted(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        for path in ROOT.iterdir():
            if path.name in ("core", "app", "widgets", "tests", "installer"):
                (self.root / path.name).symlink_to(path)
        for name in ("README.md", "CMakeLists.txt"):
            shutil.copy(ROOT / name, self.root)
        (self.root / "resources").mkdir()
        for path in (ROOT / "resources").iterdir():
            if path.name != "manual":
                (self.root / "resources" / path.name).symlink_to(path)
        self.manual = self.root / "resources/manual"
        shutil.copytree(ROOT / "resources/manual", self.manual)

    def said(self, test):
        done = subprocess.run(["/usr/bin/python3", FOLDER / test], capture_output=True, text=True, timeout=1800, check=False,
                              env=os.environ | {"FYD_SOURCE_DIR": str(self.root)})
        return done.stderr

    def change(self, name, old, new):
        text = (self.manual / name).read_text(encoding="utf-8")
        self.assertIn(old, text)
        (self.manual / name).write_text(text.replace(old, new, 1), encoding="utf-8")

    def test_faults_in_the_words_are_found(self):
        (self.manual / "planted.md").write_text("# Planted\n\n" + "\n\n".join(PLANTED) + "\n", encoding="utf-8")
        self.change("safety.md", "| held | · |", "| held | **active** |")
        self.change("safety.md", "| 11 | the robot is silent |", "| 11 | the robot sings |")
        self.change("operate.md", "Ctrl+Shift+Y", "Ctrl+Shift+O")
        self.change("screens.md", "Ctrl+Shift+Y", "Ctrl+Shift+O")
        said = self.said("pages_test.py")
        for fault in [*PLANTED.values(), "'planted.md'", "put this table into safety.md", "put these rows into safety.md",
                      "view.layouts: Layouts… (Ctrl+Shift+Y)"]:
            with self.subTest(fault=fault):
                self.assertIn(fault, said)

    def test_pictures_that_are_not_made_or_not_shown_are_found(self):
        images = self.manual / "images"
        shutil.copy(images / "tune.png", images / "unmade.png")
        drawing = images / "architecture.svg"
        drawing.write_text(drawing.read_text(encoding="utf-8").replace(">sensing<", ">guessing<"), encoding="utf-8")
        (images / "device_card.png").write_bytes(b"\x89PNG\r\n\x1a\n" + bytes(200_000))
        said = self.said("pictures_test.py")
        for fault in ("unmade.png", "device_card.png", "make.py architecture.svg", "not less than"):
            with self.subTest(fault=fault):
                self.assertIn(fault, said)


if __name__ == "__main__":
    unittest.main()
