"""Every picture of README and manual is made by resources/manual/images/make.py, and is small."""
import importlib.util
import os
import re
import struct
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import manual_blocks

ROOT = Path(os.environ["FYD_SOURCE_DIR"])
IMAGES = ROOT / "resources/manual/images"
LARGEST_bytes = 130_000  # they are compiled into the window


def made():
    spec = importlib.util.spec_from_file_location("make", IMAGES / "make.py")
    make = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(make)
    return set(make.PICTURES)


def shown():
    """Name -> the pages that show it."""
    out = {}
    for page, path in manual_blocks.pages(ROOT).items():
        for words, target in re.findall(r"!\[([^\]]*)\]\(([^)\s]+)\)", path.read_text(encoding="utf-8")):
            picture = (path.parent / target).resolve()
            assert picture.parent == IMAGES, f"{page}: {target}: expected a picture in resources/manual/images"
            assert words, f"{page}: {target}: says nothing to those who do not see it"
            out.setdefault(picture.name, []).append(page)
    return out


class Pictures(unittest.TestCase):
    def test_each_that_is_shown_is_made_and_each_that_is_made_is_there_and_shown(self):
        there = {path.name for path in IMAGES.iterdir() if path.suffix in (".png", ".svg")}
        self.assertEqual(made(), there)
        self.assertEqual(set(shown()), there)

    def test_each_is_small_and_is_what_its_name_says(self):
        for path in IMAGES.iterdir():
            with self.subTest(picture=path.name):
                if path.suffix == ".png":
                    head = path.read_bytes()[:24]
                    self.assertEqual(head[:8], b"\x89PNG\r\n\x1a\n")
                    self.assertLessEqual(max(struct.unpack(">II", head[16:24])), 1600)
                elif path.suffix == ".svg":
                    tree = ElementTree.parse(path).getroot()
                    # Dark words on the page's own dark ground could not be read.
                    ground = tree.find("{http://www.w3.org/2000/svg}rect")
                    self.assertIn(ground.get("fill"), ("#fff", "#ffffff", "white"))
                if path.suffix in (".png", ".svg"):
                    self.assertLess(path.stat().st_size, LARGEST_bytes)

    def test_the_drawings_are_those_of_today(self):
        for name in ("architecture", "membrane_section"):
            with self.subTest(drawing=name), tempfile.TemporaryDirectory() as folder:
                new = Path(folder) / "new.svg"
                subprocess.run(["/usr/bin/python3", IMAGES / f"{name}.py", new], check=True, timeout=120)
                self.assertEqual(new.read_text(encoding="utf-8"), (IMAGES / f"{name}.svg").read_text(encoding="utf-8"),
                                 f"run: resources/manual/images/make.py {name}.svg")


if __name__ == "__main__":
    unittest.main()
