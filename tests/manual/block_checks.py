"""What is made of a block of each kind. A check returns what was done with it: "run" or "checked", and raises Broken with
the reason when the block does not hold.
"""
import functools
import json
import os
import re
import shlex
import signal
import subprocess
import tomllib
from pathlib import Path

PYTHON = "/usr/bin/python3"  # Debian's own, which has Debian's h5py and SciPy
PROGRAMS = ("fyd", "fyd-console", "fyd-bench", "fyd-window-bench")
# Programs that run until they are interrupted when no --duration ends them.
ENDLESS = re.compile(r"\bfyd (station|sim (robot|touchpad|network|krc)|robot|scene fence)\b")
PATIENCE_s = 300
# How long these run in a block. That is the tests' own, and a program may need longer on a machine that does other work: an
# arm's controller is ready after a second of answers in time. So a block that fails gets more once.
ENDLESS_s = (3, 30)


class Broken(Exception):
    pass


class NotBuilt(Exception):
    """Its program is left out of this build (FYD_NOT_BUILT), as the benchmarks are where sanitizers are built in."""


class Place:
    """A scratch folder in which a page's commands run as they stand: the project's folders and the built programs are
    where the project's own folder has them, and the programs are on the path too."""

    def __init__(self, folder, root, programs, as_written=False):
        self.folder, self.root, self.programs = Path(folder), Path(root), Path(programs)
        self.as_written = as_written
        for name in ("tests", "resources", "installer", "CMakePresets.json"):
            (self.folder / name).symlink_to(self.root / name)
        (self.folder / "build/release").mkdir(parents=True)
        (self.folder / "build/release/bin").symlink_to(self.programs)
        module = os.environ.get("FYD_PYTHON_PATH", "")
        if module:
            (self.folder / "build/release/python").symlink_to(module)
        home = self.folder / ".home"
        home.mkdir()
        self.environment = os.environ | {
            "PATH": f"{self.programs}:/usr/bin:/bin", "HOME": str(home), "XDG_DATA_HOME": str(home / "data"),
            "XDG_CONFIG_HOME": str(home / "config"), "QT_QPA_PLATFORM": "offscreen",
            "PYTHONPATH": module, "PYTHONDONTWRITEBYTECODE": "1"}

    def run(self, command, **keywords):
        """Ends with everything that it started."""
        process = subprocess.Popen(command, cwd=self.folder, env=self.environment, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True, start_new_session=True, **keywords)
        try:
            out, err = process.communicate(timeout=PATIENCE_s)
        except subprocess.TimeoutExpired:
            raise Broken(f"still runs after {PATIENCE_s} s") from None
        finally:
            try:
                os.killpg(process.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
        return process.returncode, out, err


# -- shell ---------------------------------------------------------------------------------------------------------

def joined(code):
    return code.replace("\\\n", " ")


def shortened(line, as_written=False, endless_s=ENDLESS_s[0]):
    """A command that runs a session for seconds, with its time cut to three tenths; one that runs for ever ends."""
    if as_written and "--duration" in line:
        return line
    line = re.sub(r"--duration (\d+(?:\.\d+)?)", lambda m: f"--duration {max(1.5, 0.3 * float(m[1])):g}", line)
    if ENDLESS.search(line) and "--duration" not in line and "--help" not in line:
        # What stands behind, the touchpad's end as a rule, outlives what is started last.
        end = re.search(r"\s*(&)?\s*(#.*)?$", line)
        line = f"{line[:end.start()]} --duration {endless_s + 2 if end[1] else endless_s}{line[end.start():]}"
    return line


def whole_commands(code):
    """Lines, or several where only they together are a command, as a loop is."""
    command = ""
    for line in joined(code).rstrip("\n").split("\n"):
        command += line
        parsed = subprocess.run(["bash", "-n", "-c", command], capture_output=True, check=False).returncode == 0
        if parsed:
            yield command
        command = "" if parsed else command + "\n"
    if command:
        raise Broken(f"bash does not understand: {command}")


def run_shell(code, place):
    """Each command must succeed: also the first of "a && b", at which set -e would not stop, and what runs behind."""
    if "build/release/python" in code and not os.environ.get("FYD_PYTHON_PATH"):
        raise NotBuilt("fyd for Python")
    for program in os.environ.get("FYD_NOT_BUILT", "").split():
        if re.search(rf"\b{program}\b", code.replace("fyd bench", "fyd-bench")):
            raise NotBuilt(program)
    commands = list(whole_commands(code))
    endless = any(ENDLESS.search(command) for command in commands)
    for endless_s in ENDLESS_s if endless else ENDLESS_s[:1]:
        script = "set -uo pipefail; last= behind=\n"
        for command in commands:
            script += (f"{shortened(command, place.as_written, endless_s)}\nstatus=$?; [ $status = 0 ] || exit $status\n"
                       '[ "${!:-}" = "$last" ] || { last=$!; behind="$behind $!"; }\n')
        script += "for each in $behind; do wait $each || exit $?; done\n"
        status, out, err = place.run(["bash", "-c", script])
        if status == 0:
            return "run"
    raise Broken(f"exit code {status}\n{err[-2000:]}{out[-500:]}")


def run_console(code, what, place):
    """"$ command", and below it what it prints; "…" stands for anything. What stands there must come, in that order.
    ```console refused: the commands must fail."""
    parts = re.split(r"^\$ ", code, flags=re.MULTILINE)
    if len(parts) == 1:
        raise Broken("no line begins with \"$ \": which command prints this?")
    for part in parts[1:]:
        command, *expected = part.rstrip("\n").split("\n")
        status, out, err = place.run(["bash", "-c", shortened(command, place.as_written)])
        if (status != 0) != (what == "refused"):
            raise Broken(f"{command}: exit code {status}\n{err[-2000:]}")
        if not any(line.strip(" …") for line in expected):
            raise Broken(f"{command}: nothing is shown of what it prints")
        printed = [line.rstrip() for line in (out + err).split("\n")]
        compare(expected, printed, f"{command} (exit code {status})")
    return "run"


def compare(expected, printed, command):
    at = 0
    for line in expected:
        if line.strip() in ("…", ""):
            continue
        pattern = re.compile(".*".join(re.escape(part) for part in line.rstrip().split("…")))
        found = next((i for i in range(at, len(printed)) if pattern.fullmatch(printed[i])), None)
        if found is None:
            raise Broken(f"{command}: expected {line!r} in\n" + "\n".join(printed[at:at + 60]))
        at = found + 1


# -- options without running ---------------------------------------------------------------------------------------

@functools.lru_cache(maxsize=None)
def help_of(programs, *words):
    path = Path(programs) / words[0]
    if not path.exists():
        if words[0] in os.environ.get("FYD_NOT_BUILT", "").split():
            raise NotBuilt(words[0])
        raise Broken(f"{words[0]} is not built in {programs}")
    done = subprocess.run([path, *words[1:], "--help"], capture_output=True, text=True, timeout=PATIENCE_s, check=False,
                          env=os.environ | {"QT_QPA_PLATFORM": "offscreen"})
    return done.stdout if done.returncode == 0 else None


def subcommands(text):
    """Those that a help text lists."""
    _, _, listed = text.partition("\nSubcommands:\n")
    return re.findall(r"^  ([\w-]+)(?= |$)", listed, re.MULTILINE)


def check_options(code, place):
    """Every program, subcommand and option of the commands exists."""
    checked = 0
    for line in joined(re.sub(r"\n {4,}", " ", code)).split("\n"):
        line = line.split(" #")[0].strip().rstrip("&").strip()
        line = re.sub(r"^(\S*/)?(?=fyd)", "", line)
        if not line:
            continue
        words = shlex.split(line.replace("[", " ").replace("]", " ").replace("'", ""))
        if words[0] not in PROGRAMS:
            raise Broken(f"{line}: expected one of {', '.join(PROGRAMS)}")
        if words[:2] == ["fyd", "bench"]:
            words[:2] = ["fyd-bench"]
        chain, rest = [words[0]], words[1:]
        while rest and rest[0] in subcommands(help_of(place.programs, *chain) or ""):
            chain.append(rest.pop(0))
        text = help_of(place.programs, *chain)
        if text is None or (chain == ["fyd"] and rest and not rest[0].startswith("-")):
            raise Broken(f"{line}: there is no such command")
        if chain == ["fyd-bench"] and rest and not rest[0].startswith("-") and not re.search(rf"[{{,]{rest[0]}[,}}]", text):
            raise Broken(f"{line}: there is no such subject")
        for option in [word.split("=")[0] for word in rest if re.match(r"--?[a-z]", word)]:
            if not re.search(rf"(?<![\w-]){re.escape(option)}(?![\w-])", text):
                raise Broken(f"{line}: {' '.join(chain)} has no option {option}")
        checked += 1
    if not checked:
        raise Broken("holds no command")
    return "checked"


# -- data ----------------------------------------------------------------------------------------------------------

def run_toml(code, what, place):
    """A table of the program, parsed by the program: "scene", "profile", "surface"."""
    try:
        tomllib.loads(code)
    except tomllib.TOMLDecodeError as error:
        raise Broken(f"no TOML: {error}") from None
    path = place.folder / f"block.{what}.toml"
    path.write_text(code, encoding="utf-8")
    how = {"scene": ["scene", "explain", path], "profile": ["params", "--profile", path],
           "surface": ["texture", "play", path, "--speed", "20", "--force", "1", "-o", place.folder / "played.csv"]}
    if what not in how:
        raise Broken(f"toml {what!r}: expected one of {', '.join(how)} after the language")
    status, _, err = place.run([str(place.programs / "fyd"), *map(str, how[what])])
    if status != 0:
        raise Broken(err)
    return "run"


def run_json(code):
    try:
        json.loads(code)
    except json.JSONDecodeError as error:
        raise Broken(f"no JSON: {error}") from None
    return "run"


def run_gesture(code, place):
    (place.folder / "block.gesture").write_text(code, encoding="utf-8")
    status, _, err = place.run([str(place.programs / "fyd"), "gesture", "show", "block.gesture"])
    if status != 0:
        raise Broken(err)
    return "run"


# -- programs ------------------------------------------------------------------------------------------------------

def compile_cpp(code, place, command):
    """One translation unit, with the flags of the project. @param command of a file of the core, a list of words"""
    source = place.folder / "block.cpp"
    source.write_text(code, encoding="utf-8")
    words = [word for word in command if word not in ("-Winvalid-pch",) and not word.startswith("-o")]
    status, _, err = place.run([*words, "-fsyntax-only", str(source)])
    if status != 0:
        raise Broken(err[-3000:])
    return "run"


def core_command(build):
    """How the build compiles the core, without its precompiled header, input and output."""
    entries = json.loads((Path(build) / "compile_commands.json").read_text(encoding="utf-8"))
    # Many files of the core are compiled as parts of a larger one: any of its commands will do.
    entry = next(each for each in entries if "fyd_core.dir" in each["command"] and "cmake_pch" not in each["file"])
    words = iter(shlex.split(entry["command"]))
    out = []
    for word in words:
        if word in ("-o", "-c", "-include", "-MF", "-MT"):
            next(words)
        elif word not in ("-MD", "-Winvalid-pch") and not word.endswith("ccache"):
            out.append(word)
    return out


def check_example(code, what, root):
    """The block is a file that the build compiles and a test runs (tests/manual/CMakeLists.txt)."""
    path = Path(root) / "resources/manual" / what
    if not path.is_file():
        raise Broken(f"there is no {what} in resources/manual")
    if path.read_text(encoding="utf-8") != code:
        raise Broken(f"differs from resources/manual/{what}; put the file into the page, or the page into the file")
    return "run"


def run_python(code, before, place):
    """@param before the page's earlier blocks: what they define holds here too, as in one session of the interpreter"""
    if re.search(r"^\s*(import|from) fyd\b", before + code, re.MULTILINE) and not os.environ.get("FYD_PYTHON_PATH"):
        raise NotBuilt("fyd for Python")
    # The interpreter is not built with a sanitizer; where the module is, the build says what must be loaded first.
    prefix = ["env", *os.environ.get("FYD_PYTHON_ENVIRONMENT", "").split(), PYTHON]
    status, out, err = place.run([*prefix, "-c", before + code])
    if status != 0:
        raise Broken(f"{err[-2000:]}{out[-500:]}")
    return "run"


def check_cmake(code, place):
    """CMake reads it; what it finds and makes is the business of the test that builds against the installed tree."""
    path = place.folder / "block.cmake"
    path.write_text(f"function(fyd_block)\n{code}\nendfunction()\n", encoding="utf-8")
    status, _, err = place.run(["cmake", "-P", str(path)])
    if status != 0:
        raise Broken(err)
    return "checked"


# -- drawings and figures ------------------------------------------------------------------------------------------

@functools.lru_cache(maxsize=None)
def sources(root):
    """All code of the core, as one text."""
    return "\n".join(path.read_text(encoding="utf-8") for folder in ("core", "app", "widgets")
                     for path in sorted((Path(root) / folder).rglob("*")) if path.suffix in (".h", ".cpp", ".in"))


@functools.lru_cache(maxsize=None)
def digits_in_sources(root):
    return {digits(number) for number in re.findall(r"\d[\d']*\.?\d*", sources(root))}


def digits(number):
    return number.replace("'", "").replace(".", "").lstrip("0").rstrip("0")


def check_formula(code, root):
    """A constant of four digits and more stands in the code too."""
    for number in re.findall(r"\d+\.?\d*", code):
        if len(digits(number)) >= 4 and digits(number) not in digits_in_sources(root):
            raise Broken(f"the constant {number} is in no source")
    return "checked"


def check_folders(code, root):
    """A tree of the project's folders: each exists."""
    for line in code.split("\n"):
        for name in re.findall(r"(?:^| {2,})((?:app|core|widgets|tests|resources|installer)(?:/\w+)*)(?= )", line):
            if not (Path(root) / name).is_dir():
                raise Broken(f"there is no folder {name}")
        first = line.split(" ", 1)[0]
        for name in re.findall(r"(?<![\w/])(\w+)/(?=[ ,;]|$)", line):
            if not any((Path(root) / base / name).is_dir() for base in (first, "core", "app", "widgets", ".")):
                raise Broken(f"{first} has no folder {name}/")
    return "checked"


def check_diagram(code, root):
    """Names of the code in it (Pipeline::step) are in the code."""
    for name in re.findall(r"\b\w+::\w+", code):
        owner, member = name.split("::")
        if not re.search(rf"\b{owner}\b", sources(root)) or not re.search(rf"\b{member}\b", sources(root)):
            raise Broken(f"the code has no {name}")
    return "checked"


def check_vectors(code, root):
    """A name, and below it its value, which is that of tests/data/protocol/link_vectors.txt."""
    given = dict(line.split(" ", 1) for line in (Path(root) / "tests/data/protocol/link_vectors.txt").read_text(
        encoding="utf-8").split("\n") if line and not line.startswith("#"))
    shown = {}
    for line in code.rstrip("\n").split("\n"):
        if line.startswith(" "):
            shown[name] += ("" if name != "words" or not shown[name] else " ") + line.strip()
        else:
            name = line.strip()
            shown[name] = ""
    for name, value in shown.items():
        if given.get(name) != value:
            raise Broken(f"{name} = {value}: link_vectors.txt has {given.get(name)}")
    if set(given) != set(shown):
        raise Broken(f"not shown: {', '.join(sorted(set(given) - set(shown)))}")
    return "checked"


def check_scripts(code, root):
    """Scripts of the project that are not run here: they exist, may be run and are bash."""
    names = re.findall(r"(?:^|[\s/])(installer/[\w.-]+)", code)
    if not names:
        raise Broken("names no script of installer/")
    for name in names:
        path = Path(root) / name
        if not os.access(path, os.X_OK):
            raise Broken(f"{name} is no program")
        done = subprocess.run(["bash", "-n", path], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise Broken(done.stderr)
    return "checked"


def check_presets(code, root):
    presets = json.loads((Path(root) / "CMakePresets.json").read_text(encoding="utf-8"))
    for kind, pattern in (("configurePresets", r"cmake --preset (\w+)"), ("buildPresets", r"--build --preset (\w+)"),
                          ("testPresets", r"ctest --preset (\w+)")):
        for name in re.findall(pattern, code):
            if name not in [each["name"] for each in presets[kind]]:
                raise Broken(f"CMakePresets.json has no {kind} {name}")
    listed = "".join(path.read_text(encoding="utf-8") for path in Path(root).glob("tests/**/CMakeLists.txt"))
    modules = (Path(root) / "CMakeLists.txt").read_text(encoding="utf-8")
    for name in re.findall(r"--target (\S+)", code):
        if name not in listed and not re.search(rf"\b{name.removeprefix('test_')}\b", modules):
            raise Broken(f"there is no target {name}")
    return "checked"


def check_words(words, code, root):
    """Messages that cannot be made here: their words are in the block and in the code."""
    text = re.sub(r'"\s*\n\s*"', "", sources(root))
    for each in words:
        if each not in code or each not in text:
            raise Broken(f"{each!r}: expected in the block and in the code")
    return "checked"
