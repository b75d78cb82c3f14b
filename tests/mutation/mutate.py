#!/usr/bin/env python3
"""Mutation check: does a test notice when the code is wrong?

Each mutant of mutants.toml is one change of one file: an operator turned, a line dropped, two calls exchanged. The
changed copy is compiled alone, linked before the rest and run with the tests that must notice. A mutant that they do
not notice is a survivor; one with a reason ("survives") changes nothing that a test could see, and must survive.

    python3 tests/mutation/mutate.py BUILD [--quick] [--only WORD]

It fails when a mutant survives without a reason, dies in spite of one, does not compile, or does not apply because the
source has changed: then the mutant is written anew.
"""

import argparse
import json
import pathlib
import shlex
import subprocess
import sys
import time
import tomllib

SOURCE = pathlib.Path(__file__).resolve().parents[2]
LONGEST_RUN_s = 120  # a mutant that hangs is noticed, too


def fail(words):
    sys.exit(f"mutate.py: {words}")


class Program:
    """One test program of CMakeLists.txt: how its objects are compiled, how it is linked and run."""

    def __init__(self, build, name, settings):
        self.build = build
        self.name = name
        self.arguments = settings.get("arguments", [])
        self.recompiled = settings.get("recompiled", {})
        entries = json.loads((build / "compile_commands.json").read_text())
        self.entries = {}
        for entry in entries:
            # Not "output": CMake 3.25 does not write it.
            entry["command"] = shlex.split(entry["command"])
            entry["output"] = entry["command"][entry["command"].index("-o") + 1]
            if f"/{name}.dir/" in entry["output"]:
                path = pathlib.Path(entry["file"]).resolve().relative_to(SOURCE)
                self.entries[str(path)] = entry
        if not self.entries:
            fail(f"{build}: knows no program {name}; expected a build folder configured with FYD_BUILD_TESTS")
        said = subprocess.run(["ninja", "-C", build, name], capture_output=True, text=True)
        if said.returncode:
            fail(f"{name} is not built:\n{said.stdout}{said.stderr}")
        line = subprocess.run(
            ["ninja", "-C", build, "-t", "commands", "-s", f"bin/{name}"], capture_output=True, text=True, check=True
        ).stdout.strip()
        # ": && COMMAND && :", as CMake writes it
        self.link = shlex.split(line.split("&&")[1])
        self.place = build / "mutation" / name
        self.place.mkdir(parents=True, exist_ok=True)

    def test(self, program):
        """Whether the tests pass, and the first line that says why not."""
        try:
            run = subprocess.run(
                [program, "--gtest_brief=1", "--gtest_fail_fast", *self.arguments],
                capture_output=True, text=True, errors="replace", timeout=LONGEST_RUN_s)
        except subprocess.TimeoutExpired:
            return False, f"hangs for {LONGEST_RUN_s} s"
        if run.returncode == 0:
            return True, ""
        failed = [line for line in run.stdout.splitlines() if line.startswith("[  FAILED  ]")]
        return False, failed[0][13:].split(",")[0].split(" (")[0] if failed else f"exit code {run.returncode}"

    def compiled(self, entry, source, out, shadow):
        command = list(entry["command"])
        at = command.index("-o")
        command[at + 1] = str(out)
        if "-MF" in command:
            command[command.index("-MF") + 1] = str(out) + ".d"
        command[command.index("-c") + 1] = str(source)
        # The changed header is found before the right one, and what a mutant makes unused is no error.
        command[at:at] = ["-w", *(["-iquote", str(shadow)] if shadow else [])]
        run = subprocess.run(command, cwd=entry["directory"], capture_output=True, text=True)
        return run.returncode == 0, run.stderr

    def of(self, file, text):
        """Compiles and runs with `text` in place of the file. @return (compiled, passed, words)"""
        changed = self.place / file
        changed.parent.mkdir(parents=True, exist_ok=True)
        changed.write_text(text)
        header = file.endswith(".h")
        objects = {}
        for name in self.recompiled.get(file, []) if header else [file]:
            out = self.place / (name.replace("/", "_") + ".o")
            entry = self.entries[name]
            good, words = self.compiled(
                entry, SOURCE / name if header else changed, out, self.place if header else None)
            if not good:
                return False, False, words
            objects[entry["output"]] = str(out)
        changed.unlink()
        program = self.place / "program"
        link = [objects.get(word, word) for word in self.link]
        link[link.index("-o") + 1] = str(program)
        run = subprocess.run(link, cwd=self.build, capture_output=True, text=True)
        if run.returncode:
            return False, False, run.stdout + run.stderr
        return True, *self.test(program)


def mutated(mutant):
    text = (SOURCE / mutant["file"]).read_text()
    found = text.count(mutant["old"])
    if found != 1:
        return None, f"does not apply: {mutant['old']!r} stands {found} times in {mutant['file']}, expected once"
    return text.replace(mutant["old"], mutant["new"]), ""


def main():
    arguments = argparse.ArgumentParser(description="Does a test notice when the code is wrong?")
    arguments.add_argument("build", type=pathlib.Path, help="a build folder with tests")
    arguments.add_argument("--quick", action="store_true", help="only those with a quick program, for each change")
    arguments.add_argument("--only", default="", help="only mutants of files whose name holds this")
    chosen = arguments.parse_args()
    listed = tomllib.loads((pathlib.Path(__file__).parent / "mutants.toml").read_text())
    mutants = listed["mutant"]
    for mutant in mutants:
        if not set(mutant) <= {"program", "file", "old", "new", "quick", "survives"}:
            fail(f"mutants.toml: unknown words in {mutant}")
    wrong = [f"{m['file']}: {mutated(m)[1]}" for m in mutants if mutated(m)[0] is None]  # of all, also when quick
    wanted = [m for m in mutants if chosen.only in m["file"] and (m.get("quick") or not chosen.quick)]
    programs = {}
    killed, excused = 0, 0
    began = time.monotonic()
    for mutant in wanted:
        text, problem = mutated(mutant)
        if text is None:
            continue
        name = mutant["quick"] if chosen.quick else mutant["program"]
        if name not in programs:
            programs[name] = Program(chosen.build.resolve(), name, listed["program"].get(name, {}))
            good, words = programs[name].test(chosen.build.resolve() / "bin" / name)
            if not good:
                fail(f"{name} fails without any mutant: {words}")
        since = time.monotonic()
        compiled, passed, words = programs[name].of(mutant["file"], text)
        change = f"{mutant['file']}: {' '.join(mutant['old'].split())!r} -> {' '.join(mutant['new'].split())!r}"
        reason = mutant.get("survives")
        if not compiled:
            wrong.append(f"{change}: does not compile:\n{words[-800:]}")
            verdict = "not compiled"
        elif passed and not reason:
            wrong.append(f"{change}: SURVIVES, no test notices")
            verdict = "SURVIVES"
        elif passed:
            excused += 1
            verdict = f"survives, as said: {reason}"
        elif reason:
            wrong.append(f"{change}: noticed by {words}, though it is said to survive: {reason}")
            verdict = f"noticed by {words}, though said to survive"
        else:
            killed += 1
            verdict = f"noticed by {words}"
        print(f"{time.monotonic() - since:5.1f} s  {change}: {verdict}", flush=True)
    print(f"{len(wanted)} mutants in {time.monotonic() - began:.0f} s: {killed} noticed, {excused} survive with a reason, "
          f"{len(wrong)} wrong")
    for line in wrong:
        print(f"WRONG {line}")
    return 1 if wrong or not killed else 0


if __name__ == "__main__":
    sys.exit(main())
