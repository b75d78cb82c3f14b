#!/usr/bin/python3
"""Makes every picture of README and manual: resources/manual/images/make.py [NAME...] [--programs build/release/bin]

Without a name, all of them. Pictures of the window need Debian's pngquant and no display; those of a bench take as long as the
bench.
tests/manual/pictures_test.py fails when a page shows a picture that is not in PICTURES below, or none shows one that is.
"""
import argparse
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

IMAGES = Path(__file__).resolve().parent
ROOT = IMAGES.parents[2]
SMALL, LARGE = "1280x800", "1600x1000"
HAND = "tests/data/hand_motion/index_tip.csv"


class Maker:
    def __init__(self, programs, folder):
        self.programs, self.folder = Path(programs).resolve(), Path(folder)
        # The user's own profile, catalogue and remembered window stay out of the pictures.
        self.environment = os.environ | {
            "HOME": str(self.folder), "XDG_CONFIG_HOME": str(self.folder / "config"), "XDG_DATA_HOME": str(self.folder / "data"),
            "QT_QPA_PLATFORM": "offscreen", "TZ": "UTC"}

    def run(self, program, *arguments):
        path = self.programs / program if (self.programs / program).exists() else program
        subprocess.run([path, *map(str, arguments)], cwd=ROOT, env=self.environment, check=True, stdout=subprocess.DEVNULL,
                       timeout=3600)

    def window(self, name, *arguments, theme="dark", size=SMALL, after=12):
        """The window of a simulated session that is Active, a hand's recorded motion as its finger."""
        chosen = [] if "--robot" in arguments or "--review" in arguments else ["--finger", HAND]
        self.run("fyd-console", "--simulate", *chosen, "--theme", theme, "--language", "en", "--size", size, "--screenshot",
                 IMAGES / name, "--after", after, *arguments)
        self.run("pngquant", "--force", "--skip-if-larger", "--ext", ".png", "256", IMAGES / name)  # a third of the bytes

    def session(self):
        """A recorded session, once for all pictures."""
        path = self.folder / "2026-11-24 S01.h5"
        if not path.exists():
            self.run("fyd", "station", "--simulate", "--duration", 20, "--record", path, "--operator", "R. Lee", "--subject", "S01",
                     "--notes", "foam under the probe", "--tag", "foam", "--json")
        return path

    def bench(self, subject, name):
        self.run("fyd", "bench", subject, "--out", self.folder / subject)
        shutil.copy(self.folder / subject / name, IMAGES / name)


def texture_curve(maker, name):
    maker.run("fyd", "bench", "texture", "--out", maker.folder / "texture")
    maker.run(sys.executable, IMAGES / "texture_curve.py", maker.folder / "texture/texture.csv", IMAGES / name)


PICTURES = {
    # The window. Its places, then what opens beside them.
    "operate-dark.png": lambda m, n: m.window(n, "--page", "operate"),
    "operate-light.png": lambda m, n: m.window(n, "--page", "operate", theme="light"),
    "calibrate.png": lambda m, n: m.window(n, "--page", "calibrate"),
    "review.png": lambda m, n: m.window(n, "--page", "review", "--review", m.session()),
    "devices.png": lambda m, n: m.window(n, "--page", "devices"),
    "tune.png": lambda m, n: m.window(n, "--page", "tune"),
    "first-steps.png": lambda m, n: m.window(n, "--page", "operate", "--open", "first-steps", theme="light"),
    "scene.png": lambda m, n: m.window(n, "--page", "operate", "--robot", "scene:resources/scenes/fencing.toml",
                                       size=LARGE),
    "link.png": lambda m, n: m.window(n, "--page", "operate", "--open", "link", size=LARGE),
    "recording.png": lambda m, n: m.window(n, "--page", "operate", "--open", "recording,log", size=LARGE),
    "manual.png": lambda m, n: m.window(n, "--page", "operate", "--open", "manual", theme="light", size=LARGE),
    # Drawings.
    "architecture.svg": lambda m, n: m.run(sys.executable, IMAGES / "architecture.py", IMAGES / n),
    "membrane_section.svg": lambda m, n: m.run(sys.executable, IMAGES / "membrane_section.py", IMAGES / n),
    # What a bench measured.
    "numbers.svg": lambda m, n: m.run(ROOT / "installer/numbers.sh"),  # and its page, scene_contact.svg and texture_curve.svg
    "predict.svg": lambda m, n: m.bench("predict", n),  # two of its panels need recordings that do not come along: teleop.md
    "scene_contact.svg": lambda m, n: m.bench("scene_contact", n),
    "teleop.svg": lambda m, n: m.run("fyd", "teleop", "table", "--out", IMAGES / n),
    "texture_curve.svg": texture_curve,
}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME", help=", ".join(PICTURES))
    parser.add_argument("--programs", default=ROOT / "build/release/bin")
    options = parser.parse_args()
    unknown = [name for name in options.names if name not in PICTURES]
    if unknown:
        parser.error(f"{', '.join(unknown)}: expected some of {', '.join(PICTURES)}")
    if not shutil.which("pngquant"):
        parser.error("pngquant is not installed: without it the window's pictures are too large (apt install pngquant)")
    with tempfile.TemporaryDirectory() as folder:
        maker = Maker(options.programs, folder)
        for name in options.names or PICTURES:
            PICTURES[name](maker, name)
            print(f"{name}: {(IMAGES / name).stat().st_size // 1024} KiB")


if __name__ == "__main__":
    main()
