"""What is in the packages of the folder PACKAGES, by the tools that judge such things in Debian."""
import fnmatch
import gzip
import json
import os
import re
import shlex
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

PACKAGES = Path(os.environ["PACKAGES"])
SOURCES = Path(os.environ["FYD_SOURCE_DIR"])
VERSION = os.environ["VERSION"]
PROGRAMS = {"fyd": "usr/bin/fyd", "fyd-console": "usr/bin/fyd-console"}
# The commands as the build is told them, not as the program's help says them.
COMMANDS = re.search(r"set\(FYD_COMMANDS ([\w ]+)\)", (SOURCES / "app/cli/CMakeLists.txt").read_text())[1].split()


def run(*command, **more):
    """@return standard output; AssertionError with what was said when the command fails"""
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False, **more)
    if done.returncode != 0:
        raise AssertionError(f"{command}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


class Package:
    def __init__(self, path, folder):
        self.path, self.name = path, path.name.split("_")[0]
        self.root = folder / self.name
        run("dpkg-deb", "-x", path, self.root)
        text = run("dpkg-deb", "-f", path)
        self.field = dict(re.findall(r"^([\w-]+): ?((?:.*)(?:\n .*)*)", text, re.MULTILINE))

    def depends(self):
        return re.split(r", *", self.field.get("Depends", ""))

    def files(self):
        return [path for path in sorted(self.root.rglob("*")) if path.is_file() and not path.is_symlink()]

    def binaries(self):
        return [file for file in self.files() if file.suffix != ".debug" and file.read_bytes()[:4] == b"\x7fELF"]

    def find(self, pattern):
        return [path for path in sorted(self.root.rglob("*"))
                if fnmatch.fnmatch(str(path.relative_to(self.root)), pattern)]  # glob would not see libfyd.so, whose target is elsewhere


def setUpModule():
    global SCRATCH, ALL
    SCRATCH = tempfile.TemporaryDirectory()
    ALL = {each.name: each for each in (Package(path, Path(SCRATCH.name)) for path in sorted(PACKAGES.glob("*.deb")))}


def tearDownModule():
    SCRATCH.cleanup()


class Contents(unittest.TestCase):
    def test_each_package_holds_its_part(self):
        parts = {
            "fyd-console": ["usr/bin/fyd-console", "usr/share/applications/fyd-console.desktop",
                            "usr/share/applications/fyd-console-review.desktop", "usr/share/mime/packages/fyd-console.xml",
                            "usr/share/icons/hicolor/scalable/apps/fyd-console.svg", "usr/share/metainfo/*.fyd_console.metainfo.xml",
                            "usr/share/man/man1/fyd-console.1.gz", "usr/share/bash-completion/completions/fyd-console"],
            "fyd": ["usr/bin/fyd", "usr/lib/udev/rules.d/70-fyd-touchpad.rules", "usr/share/fyd-console/scenes/fencing.toml",
                    "usr/share/fyd-console/textures/wood.toml", "usr/share/man/man1/fyd.1.gz",
                    "usr/share/bash-completion/completions/fyd"],
            "libfyd0": ["usr/lib/*-linux-gnu*/libfyd.so.0", "usr/lib/*-linux-gnu*/fyd/codecs.so"],
            "libfyd-dev": ["usr/lib/*-linux-gnu*/libfyd.so", "usr/lib/*-linux-gnu*/cmake/Fyd/FydConfig.cmake",
                           "usr/lib/*-linux-gnu*/pkgconfig/fyd.pc", "usr/include/fyd/core/pipeline/pipeline.h"],
        }
        if "python3-fyd" in ALL:  # where the module is built
            parts["python3-fyd"] = ["usr/lib/python3/dist-packages/fyd*"]
        if "fyd-console-dbg" in ALL:  # of a build with debug symbols
            parts["fyd-console-dbg"] = ["usr/lib/debug/.build-id/??/*.debug"]
        self.assertEqual(set(ALL), set(parts))
        for name, files in parts.items():
            for file in [*files, f"usr/share/doc/{name}/copyright", f"usr/share/doc/{name}/changelog.gz",
                         f"usr/share/doc/{name}/changelog.Debian.gz"]:
                self.assertTrue(ALL[name].find(file), f"{name} has no {file}")

    def test_nothing_is_in_two_packages(self):
        seen = {}
        for package in ALL.values():
            for file in package.files():
                where = file.relative_to(package.root)
                self.assertNotIn(where, seen, f"{where} is in {package.name} and {seen.get(where)}")
                seen[where] = package.name

    def test_everything_is_roots_and_only_root_writes(self):
        for package in ALL.values():
            for line in run("dpkg-deb", "-c", package.path).splitlines():
                self.assertRegex(line, r"^(d|-|l)rw(x|-)r.(x|-)r.(x|-) root/root|^lrwxrwxrwx root/root", package.name)

    def test_no_file_names_the_folder_of_the_build(self):
        for package in ALL.values():
            for file in package.files():
                data = file.read_bytes()
                data = gzip.decompress(data) if file.suffix == ".gz" else data
                self.assertNotIn(str(SOURCES).encode() + b"/", data, file)

    def test_binaries_are_stripped(self):
        binaries = [file for package in ALL.values() for file in package.binaries()]
        self.assertGreaterEqual(len(binaries), 3)
        for file in binaries:
            self.assertNotRegex(run("readelf", "-SW", file), r"\.(symtab|debug_info)\b", file)

    def test_the_changelog_and_the_time_are_those_asked_for(self):
        for package in ALL.values():
            text = gzip.decompress((package.root / f"usr/share/doc/{package.name}/changelog.Debian.gz").read_bytes()).decode()
            self.assertRegex(text, rf"^fyd-console \({re.escape(VERSION)}-\w+\) ")
            self.assertIn("Thu, 01 Jan 2026 00:00:00 +0000", text)
            self.assertIn(" 2026-01-01 00:00 ./usr/\n", run("dpkg-deb", "-c", package.path, env=os.environ | {"TZ": "UTC"}))


class Control(unittest.TestCase):
    def test_the_version_and_a_description_of_several_lines(self):
        for package in ALL.values():
            self.assertRegex(package.field["Version"], rf"^{re.escape(VERSION)}-\w+$")
            summary, *rest = package.field["Description"].split("\n")
            self.assertGreaterEqual(len(rest), 4, package.name)
            self.assertLess(len(summary), 80)
            self.assertNotIn(";", package.field["Description"], "what CMake makes of a list")

    def test_packages_of_one_build_belong_together(self):
        same = f"(= {ALL['fyd'].field['Version']})"
        self.assertIn(f"fyd {same}", ALL["fyd-console"].depends())
        for name in ("fyd", "libfyd-dev", *(each for each in ("python3-fyd",) if each in ALL)):
            self.assertIn(f"libfyd0 {same}", ALL[name].depends())

    def test_the_command_line_needs_no_window(self):
        self.assertNotRegex(ALL["fyd"].field["Depends"], "(?i)qt6|qcustomplot")

    def test_each_library_that_a_binary_needs_is_in_a_package_it_depends_on(self):
        cache = {}
        for line in run("/sbin/ldconfig", "-p").splitlines()[1:]:
            name, _, path = line.strip().partition(" => ")
            cache.setdefault(name.split(" ")[0], path)
        checked = 0
        for package in ALL.values():
            depends = {each.split(" ")[0] for each in package.depends()}
            for file in package.binaries():
                for library in re.findall(r"NEEDED +(\S+)", run("objdump", "-p", file)):
                    if library == "libfyd.so.0":
                        self.assertIn("libfyd0", depends, package.name)
                        continue
                    owner = self.owner_of(cache[library])
                    provided = run("dpkg-query", "-W", "-f=${Provides}", owner)  # libspdlog1.10 is asked for as libspdlog1.10-fmt9
                    names = {owner, *re.findall(r"(?:^|, )([^ ,]+)", provided)}
                    self.assertTrue(names & depends, f"{file.name} needs {library} of {owner}")
                    checked += 1
        self.assertGreater(checked, 30)

    @staticmethod
    def owner_of(path):
        real = os.path.realpath(path)
        for each in (real, real.removeprefix("/usr"), path, path.removeprefix("/usr")):
            done = subprocess.run(["dpkg", "-S", each], capture_output=True, text=True, check=False)
            if done.returncode == 0:
                return done.stdout.split(":")[0]
        raise AssertionError(f"{path} belongs to no package")


class ManualPage(unittest.TestCase):
    def test_it_names_each_package_and_no_other(self):
        page = (SOURCES / "resources/manual/installing.md").read_text()
        rows = re.findall(r"^\| `([\w-]+)` \|", page, re.MULTILINE)
        self.assertEqual(set(rows), set(ALL) | {"python3-fyd", "fyd-console-dbg"})
        self.assertLessEqual(set(re.findall(r"\./([\w-]+)_\*\.deb", page)), set(rows))
        purged = re.search(r"^sudo apt-get purge \$\(dpkg-query -W -f='\S+ \S+' (.*?) 2>", page, re.MULTILINE)[1]
        for name in rows:
            self.assertTrue(any(fnmatch.fnmatch(name, each) for each in shlex.split(purged)), name)


class Desktop(unittest.TestCase):
    def test_desktop_files(self):
        files = ALL["fyd-console"].find("usr/share/applications/*.desktop")
        self.assertEqual(len(files), 2)
        for file in files:
            self.assertEqual(run("desktop-file-validate", file), "")
            program = re.search(r"^Exec=(\S+)", file.read_text(), re.MULTILINE)[1]
            self.assertTrue((ALL["fyd-console"].root / "usr/bin" / program).exists())

    def test_the_icon_is_one_that_a_theme_can_show(self):
        icon = ALL["fyd-console"].find("usr/share/icons/hicolor/scalable/apps/*.svg")[0]
        run("xmllint", "--noout", "--nonet", icon)
        for file in ALL["fyd-console"].find("usr/share/applications/*.desktop"):
            self.assertIn(f"\nIcon={icon.stem}\n", file.read_text())

    def test_appstream(self):
        for name in PROGRAMS:
            for file in ALL[name].find("usr/share/metainfo/*.xml"):
                self.assertIn("Validation was successful", run("appstreamcli", "validate", "--no-net", "--pedantic", file))

    def test_each_screenshot_is_a_picture_of_the_manual_in_its_size(self):
        text = ALL["fyd-console"].find("usr/share/metainfo/*.xml")[0].read_text()
        shots = re.findall(r'width="(\d+)" height="(\d+)">[^<]*/images/([\w-]+\.png)<', text)
        self.assertGreaterEqual(len(shots), 3)
        for width, height, name in shots:
            about = run("file", SOURCES / "resources/manual/images" / name)
            self.assertIn(f"{width} x {height}", about)

    def test_udev_rules_and_appstream_name_the_same_adapters(self):
        rules = ALL["fyd"].find("usr/lib/udev/rules.d/*")[0].read_text()
        text = ALL["fyd"].find("usr/share/metainfo/*.xml")[0].read_text()
        self.assertIn("usb:v0403p6001d*", text)
        self.assertEqual(len(re.findall("<modalias>", text)),
                         sum(len(each.split("|")) for each in re.findall(r'idProduct\}=="([^"]+)"', rules)))

    def test_every_udev_rule_holds_for_what_is_plugged_in_already(self):
        rules = ALL["fyd"].find("usr/lib/udev/rules.d/*")[0].read_text()
        self.assertIn("udevadm trigger", rules)  # its events are "change"
        actions = re.findall(r'ACTION=="([^"]*)"', rules)
        self.assertTrue(actions)
        for each in actions:
            self.assertIn("change", each.split("|"))

    def test_mime_type(self):
        source = ALL["fyd-console"].find("usr/share/mime/packages/*.xml")[0]
        run("xmllint", "--noout", "--nonet", source)
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "packages").mkdir()
            shutil.copy(source, Path(folder) / "packages")
            run("update-mime-database", folder)
            globs = (Path(folder) / "globs2").read_text()
        for name in ("*.fyd.h5", "*.h5.partial"):
            self.assertIn(f"50:application/x-fyd-recording:{name}\n", globs)
        review = (ALL["fyd-console"].root / "usr/share/applications/fyd-console-review.desktop").read_text()
        self.assertIn("application/x-fyd-recording;", review)


class ManPages(unittest.TestCase):
    def pages(self):
        return [file for name in PROGRAMS for file in ALL[name].find("usr/share/man/man1/*.1.gz")]

    def test_a_page_for_each_program_and_command(self):
        self.assertEqual({file.name.removesuffix(".1.gz") for file in self.pages()},
                         set(PROGRAMS) | {f"fyd-{command}" for command in COMMANDS})

    def test_man_has_no_warning(self):
        for file in self.pages():
            done = subprocess.run(["man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", file], capture_output=True,
                                  check=False, env=os.environ | {"MANWIDTH": "80", "MANROFFSEQ": ""})
            self.assertEqual((done.returncode, done.stderr), (0, b""), file.name)

    def test_each_page_has_a_name_that_whatis_understands(self):
        for file in self.pages():
            self.assertRegex(run("lexgrog", file), rf'"{re.escape(file.name.removesuffix(".1.gz"))} - \w')

    def test_every_option_of_the_help_is_in_the_page(self):
        text = run("man", "-E", "UTF-8", "-l", ALL["fyd"].root / "usr/share/man/man1/fyd-session.1.gz", env=os.environ | {"MANWIDTH": "200"})
        fyd = ALL["fyd"].root / PROGRAMS["fyd"]
        options = set(re.findall(r"(?<!\S)--[a-z-]+(?= |$)", run(fyd, "session", "list", "--help"), re.MULTILINE))
        self.assertGreater(len(options), 10)
        self.assertEqual({option for option in options if option not in text}, set())


    def test_the_help_is_read_the_same_in_every_locale(self):
        script = "import sys, command_lines; print(ascii(command_lines.read(sys.argv[1], 'station')))"
        said = [run("/usr/bin/python3", "-c", script, ALL["fyd"].root / PROGRAMS["fyd"], cwd=SOURCES / "installer/package",
                    env=os.environ | {"LC_ALL": locale, "PYTHONCOERCECLOCALE": "0", "PYTHONUTF8": "0", "PYTHONDONTWRITEBYTECODE": "1"})
                for locale in ("C.UTF-8", "C")]
        self.assertIn("\\u", said[0])  # there is something that ASCII has not
        self.assertEqual(said[1], said[0])


class Completion(unittest.TestCase):
    @staticmethod
    def offered(program, *words):
        """What bash offers after these words; the last one is being typed."""
        file = ALL[program].root / "usr/share/bash-completion/completions" / program
        quoted = " ".join(f"'{word}'" for word in (program, *words))
        script = (f". '{file}'; COMP_WORDS=({quoted}); COMP_CWORD={len(words)}; _{program.replace('-', '_')}; "
                  'printf "%s\\n" "${COMPREPLY[@]}"')
        return run("bash", "--norc", "-euc", script).split()

    def test_bash_understands_it(self):
        for program in PROGRAMS:
            run("bash", "-n", ALL[program].root / "usr/share/bash-completion/completions" / program)

    def test_each_command_is_offered(self):
        self.assertEqual(set(self.offered("fyd", "")), set(COMMANDS))

    def test_a_beginning_is_completed(self):
        self.assertEqual(self.offered("fyd", "sta"), ["station"])
        self.assertEqual(self.offered("fyd", "session", "rec"), ["recover"])
        self.assertEqual(self.offered("fyd-console", "--them"), ["--theme"])

    def test_commands_within_a_command_and_their_options(self):
        self.assertIn("replay", self.offered("fyd", "session", ""))
        self.assertIn("--telemetry", self.offered("fyd", "session", "replay", "a.h5", "--"))
        self.assertNotIn("--telemetry", self.offered("fyd", "session", "--"))

    def test_words_that_an_option_takes(self):
        self.assertEqual(set(self.offered("fyd", "session", "list", "--health", "g")), {"good", "gaps", "growing"})

    def test_a_file_is_left_to_bash(self):
        self.assertEqual(self.offered("fyd", "station", "--profile", ""), [])


class Hardening(unittest.TestCase):
    def test_programs_and_library(self):
        strict = {ALL[name].root / path for name, path in PROGRAMS.items()} | set(ALL["libfyd0"].find("usr/lib/*/libfyd.so.0.*"))
        self.assertEqual(len(strict), 3)
        files = {file for package in ALL.values() for file in package.binaries()}
        self.assertLess(strict, files)
        for file in files:
            # Debian 12 compiles nothing with the processor's control flow protection. Fails where a protection is not found.
            said = run("hardening-check", "--nocfprotection", file)
            # What calls none of the functions that could be protected has "unknown".
            yes = "yes" if file in strict else "(yes|unknown)"
            for what in ("Position Independent Executable", "Stack protected", "Fortify Source functions",
                         "Read-only relocations", "Immediate binding", "Stack clash protection"):
                self.assertRegex(said, rf"{what}: {yes}", file)


class DebugSymbols(unittest.TestCase):
    def test_they_stand_where_gdb_looks_and_name_the_line(self):
        """A program of our own: what the tests pack has no symbols."""
        with tempfile.TemporaryDirectory() as folder:
            source, program = Path(folder) / "one.c", Path(folder) / "one"
            source.write_text("int added(int a) {\n  return a + 1;\n}\nint main(void) { return added(-1); }\n")
            run("gcc", "-g1", "-O0", "-Wl,--build-id", "-o", program, source)
            address = re.search(r"^(\w+) T added$", run("nm", program), re.MULTILINE)[1]
            run(SOURCES / "installer/package/debug_symbols.sh", folder, program)
            build_id = re.search(r"Build ID: (\w+)", run("readelf", "-n", program))[1]
            symbols = Path(folder) / "lib/debug/.build-id" / build_id[:2] / f"{build_id[2:]}.debug"
            self.assertEqual(run("addr2line", "-e", symbols, address).strip(), f"{source}:1")
            run("strip", program)
            self.assertIn("??", run("addr2line", "-e", program, address))

    def test_they_are_the_same_with_a_compiler_cache_as_without(self):
        presets = json.loads((SOURCES / "CMakePresets.json").read_text())["configurePresets"]
        flags = next(each for each in presets if each["name"] == "package")["cacheVariables"]["CMAKE_CXX_FLAGS_RELEASE"].split()
        with tempfile.TemporaryDirectory() as folder:
            source = Path(folder) / "one.cpp"
            source.write_text("int added(int a) { return a + 1; }\n")
            objects = []
            for more in ([], ["-fpch-preprocess"]):  # ccache adds this where a precompiled header is used
                run("g++", *flags, *more, "-c", source, "-o", Path(folder) / "one.o")
                objects.append((Path(folder) / "one.o").read_bytes())
            self.assertIn(b"one.cpp", objects[0])  # there are symbols
            self.assertEqual(*objects)


class Running(unittest.TestCase):
    """From the unpacked folder, elsewhere than in the project: scenes and surfaces are found beside the program."""

    def test_scenes_and_surfaces_that_come_along(self):
        fyd = ALL["fyd"].root / PROGRAMS["fyd"]
        with tempfile.TemporaryDirectory() as folder:
            self.assertIn("palpation", run(fyd, "scene", "explain", "echography", cwd=folder))
            self.assertIn("Wood", run(fyd, "texture", "play", "wood", "--speed", "40", "--force", "1", "-o", "out.csv", cwd=folder))
            with self.assertRaisesRegex(AssertionError, "nothing_like_this: cannot be read"):
                run(fyd, "scene", "explain", "nothing_like_this", cwd=folder)

    def test_the_coders_of_pictures_stand_where_the_programs_look_for_them(self):
        """Other programs' starts load none of them, so only a session tells."""
        with tempfile.TemporaryDirectory() as folder:
            for name in ("fyd", "libfyd0"):
                shutil.copytree(ALL[name].root, folder, symlinks=True, dirs_exist_ok=True)
            environment = os.environ | {"XDG_DATA_HOME": folder}
            run(Path(folder) / PROGRAMS["fyd"], "station", "--simulate", "--robot", "none", "--duration", "1", env=environment)
            shutil.rmtree(next(Path(folder).glob("usr/lib/*/fyd")))
            with self.assertRaisesRegex(AssertionError, "coders of pictures and videos cannot be loaded"):
                run(Path(folder) / PROGRAMS["fyd"], "station", "--simulate", "--robot", "none", "--duration", "1", env=environment)


class Lintian(unittest.TestCase):
    def test_no_errors_and_no_warnings(self):
        run("lintian", "--allow-root", "--fail-on", "error,warning", *(package.path for package in ALL.values()))

    def test_each_override_has_its_reason(self):
        for path in (SOURCES / "installer/package").glob("*.lintian-overrides"):
            before = ""
            for line in re.sub(r"(?m)^(\w\S*:.*\n)(?=\w)", "", path.read_text()).splitlines():  # of several lines the first has it
                if line and not line.startswith("#"):
                    self.assertTrue(before.startswith("# "), f"{path.name}: {line}: no comment says why")
                before = line


if __name__ == "__main__":
    unittest.main()
