#!/usr/bin/env python3
"""Writes what a package documents itself with, below --root (such as …/usr): changelog, copyright; of the programs' packages
man pages, completion for bash and AppStream's description. Times are SOURCE_DATE_EPOCH's, so that two runs give the same bytes.
"""
import argparse
import datetime
import email.utils
import gzip
import os
import re
import struct
import time
from pathlib import Path
from xml.sax.saxutils import escape

import command_lines
import completion
import man_pages

ROOT = Path(__file__).resolve().parents[2]
SCREENSHOTS = {  # of resources/manual/images, the first is the one that stores show
    "operate-dark.png": "A session: finger, force, stiffness and texture as they are felt",
    "review.png": "A recording in review",
    "tune.png": "Values of the controller, changed while it runs",
    "calibrate.png": "A calibration with its verdict",
}


def write(path, text, packed=False):
    path.parent.mkdir(parents=True, exist_ok=True)
    data = text.encode()
    path.write_bytes(gzip.compress(data, 9, mtime=0) if packed else data)


def fill(path, values):
    text = path.read_text(encoding="utf-8")
    for name, value in values.items():
        text = text.replace(f"@{name}@", value)
    if left := re.findall(r"@[A-Z]+@", text):
        raise SystemExit(f"{path}: nothing to put in the place of {', '.join(left)}")
    return text


def screenshots(homepage):
    out = []
    for name, caption in SCREENSHOTS.items():
        with open(ROOT / "resources/manual/images" / name, "rb") as file:
            width, height = struct.unpack(">II", file.read(24)[16:])
        kind = "" if out else ' type="default"'
        out.append(f"    <screenshot{kind}>\n      <caption>{escape(caption)}</caption>\n"
                   f'      <image type="source" width="{width}" height="{height}">{homepage}/images/{name}</image>\n'
                   "    </screenshot>")
    return "\n".join(out)


def modaliases():
    """Of the adapters in the udev rules: from these a software centre knows which package a plugged-in device wants."""
    rules = (ROOT / "installer/udev/70-fyd-touchpad.rules").read_text(encoding="utf-8")
    pairs = re.findall(r'ATTRS\{idVendor\}=="(\w+)", ATTRS\{idProduct\}=="([\w|]+)"', rules)
    return "\n".join(f"    <modalias>usb:v{vendor.upper()}p{product.upper()}d*</modalias>"
                     for vendor, products in pairs for product in products.split("|"))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("component")
    for name in ("package", "version", "maintainer", "homepage", "programs", "root"):
        parser.add_argument("--" + name, required=True)
    asked = parser.parse_args()
    os.umask(0o022)
    now = int(os.environ.get("SOURCE_DATE_EPOCH", time.time()))
    day = datetime.datetime.fromtimestamp(now, datetime.timezone.utc)
    version = asked.version.partition("-")[0]
    share, doc = Path(asked.root) / "share", Path(asked.root) / "share/doc" / asked.package
    values = {"VERSION": version, "DATE": f"{day:%Y-%m-%d}", "YEAR": f"{day:%Y}", "MAINTAINER": asked.maintainer,
              "DEVELOPER": email.utils.parseaddr(asked.maintainer)[0], "HOMEPAGE": asked.homepage,
              "SCREENSHOTS": screenshots(asked.homepage), "MODALIASES": modaliases()}

    write(doc / "copyright", fill(ROOT / "installer/package/copyright", values))
    write(doc / "changelog.Debian.gz",
          f"fyd-console ({asked.version}) unstable; urgency=medium\n\n  * Version {version}; what changed stands in changelog.gz"
          f" beside this file.\n\n -- {asked.maintainer}  {email.utils.format_datetime(day)}\n", packed=True)
    write(doc / "changelog.gz", (ROOT / "resources/manual/changelog.md").read_text(encoding="utf-8"), packed=True)

    program, about = {"console": ("fyd-console", "org.example.fyd_console"),
                      "program": ("fyd", "org.example.fyd")}.get(asked.component, (None, None))
    if program:
        command = command_lines.read(str(Path(asked.programs) / program))
        for name, text in man_pages.pages(command, version, values["DATE"]).items():
            write(share / "man/man1" / (name + ".gz"), text, packed=True)
        write(share / "bash-completion/completions" / program, completion.completion(command))
        write(share / "metainfo" / f"{about}.metainfo.xml",
              fill(ROOT / "resources/desktop" / f"{about}.metainfo.xml.in", values))


main()
