#!/usr/bin/python3
"""Puts the files of resources/manual/examples into the pages that show them: python3 tests/manual/update_examples.py

A page names the file after the fence's language: ```cpp examples/predictor.cpp
"""
import re
from pathlib import Path

MANUAL = Path(__file__).resolve().parents[2] / "resources/manual"

for page in sorted(MANUAL.glob("*.md")):
    text = page.read_text(encoding="utf-8")
    new = re.sub(r"^(```\w+ (examples/\S+)\n).*?^(?=```)",
                 lambda match: match[1] + (MANUAL / match[2]).read_text(encoding="utf-8"), text,
                 flags=re.MULTILINE | re.DOTALL)
    if new != text:
        page.write_text(new, encoding="utf-8")
        print(page.name)
