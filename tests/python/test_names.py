"""The names that the module has, its stub and its docstrings agree."""
import ast
import enum
import inspect
import os
import re
import subprocess
import sys

import pytest
from conftest import ROOT

import fyd
from fyd import _fyd

PACKAGE = ROOT / "app/python/fyd"
UNIT = re.compile(r"\[[^\]]+\]|Units: \S|`unit` of")


def of_python(name, value):
    """What every Python object has, and what pybind11 adds to every class and enum."""
    if name == "__init__" and value.__doc__.startswith("Initialize self."):  # the module makes it, not the caller
        return True
    return name in ("__module__", "__doc__", "__new__", "__getstate__", "__setstate__", "__entries", "__members__", "__str__",
                    "__dict__", "__weakref__", "__init_subclass__", "__reduce__") or name.startswith("__pybind11")


def names_of_the_module():
    out = set()
    for name, value in vars(_fyd).items():
        if name.startswith("_") and name != "__version__":
            continue
        out.add(name)
        if inspect.isclass(value) and not issubclass(value, Exception):
            out |= {f"{name}.{each}" for each, what in vars(value).items() if not of_python(each, what)}
    return out


def names_of_the_stub():
    out = set()
    for node in ast.parse((PACKAGE / "_fyd.pyi").read_text(encoding="utf-8")).body:
        if isinstance(node, ast.AnnAssign):
            out.add(node.target.id)
        if isinstance(node, ast.FunctionDef):
            out.add(node.name)
        if isinstance(node, ast.ClassDef):
            out.add(node.name)
            for each in node.body:
                if isinstance(each, ast.FunctionDef):
                    out.add(f"{node.name}.{each.name}")
                if isinstance(each, ast.AnnAssign):
                    out.add(f"{node.name}.{each.target.id}")
    return out


def test_every_name_of_the_module_is_in_the_stub_and_the_other_way_round():
    module, stub = names_of_the_module(), names_of_the_stub()
    assert len(module) > 400
    assert module - stub == set() and stub - module == set()


def test_the_stub_is_the_one_the_module_makes():
    done = subprocess.run([sys.executable, ROOT / "app/python/make_stubs.py", "--check"], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def test_mypy_knows_the_module_by_its_stub(tmp_path):
    """The Python half and a user's program pass mypy's strict check; wrong use does not."""
    environment = os.environ | {"MYPYPATH": os.environ["PYTHONPATH"]}
    user = tmp_path / "user.py"
    user.write_text("import fyd\n\nwith fyd.open('session.h5') as recording:\n"
                    "    force = recording.telemetry['force_N']\n    late: float = recording.info.duration_s\n"
                    "    found = fyd.FingerDetector().detect(recording.picture(0).whole)\n    at: float = found.x_mm\n")
    strict = subprocess.run([sys.executable, "-m", "mypy", "--strict", "--cache-dir", tmp_path / "cache", "-p", "fyd"],
                            capture_output=True, text=True, env=environment, cwd=tmp_path)
    assert strict.returncode == 0, strict.stdout + strict.stderr
    command = [sys.executable, "-m", "mypy", "--strict", "--cache-dir", tmp_path / "cache", user]
    good = subprocess.run(command, capture_output=True, text=True, env=environment, cwd=tmp_path)
    assert good.returncode == 0, good.stdout + good.stderr
    user.write_text("import fyd\n\nfyd.open('session.h5').info.duration_s.upper()\nfyd.high_pass('low')\n")
    wrong = subprocess.run(command, capture_output=True, text=True, env=environment, cwd=tmp_path)
    assert wrong.stdout.count("error:") >= 2, wrong.stdout


def test_all_is_what_there_is():
    assert sorted(fyd.__all__) == sorted(set(fyd.__all__))
    assert all(hasattr(fyd, name) for name in fyd.__all__)
    inside = {"EventRow", "LinkRow", "RecordingFile", "TELEMETRY_NAMES", "TELEMETRY_UNITS", "TELEMETRY_HELP",
              "TELEMETRY_DTYPES", "replay"}
    public = {name for name in vars(_fyd) if not name.startswith("_")}
    assert public - inside <= set(fyd.__all__)


def documented():
    """(name, docstring) of every public function, method and property."""
    for name in fyd.__all__:
        value = getattr(fyd, name)
        if inspect.isclass(value):
            yield name, value.__doc__, False
            for each, what in vars(value).items():
                is_enum = hasattr(value, "__members__")
                if each.startswith("_") and each != "__init__" or is_enum or issubclass(value, (enum.Enum, Exception)) or \
                        of_python(each, what):
                    continue
                if isinstance(what, property):
                    yield f"{name}.{each}", what.__doc__ or what.fget.__doc__, True
                elif callable(what) or isinstance(what, staticmethod):
                    yield f"{name}.{each}", getattr(what, "__func__", what).__doc__, True
        elif callable(value):
            yield name, value.__doc__, True


def test_every_docstring_says_its_units():
    faults, count = [], 0
    for name, doc, with_unit in documented():
        count += 1
        said = "\n".join(line for line in (doc or "").split("\n") if " -> " not in line).strip()
        if len(said) < 3:
            faults.append(f"{name}: no docstring")
        elif with_unit and not UNIT.search(said):
            faults.append(f"{name}: no unit in: {said}")
    assert count > 300
    assert faults == []


def test_columns_and_values_have_the_units_of_one_description(classic):
    assert fyd.TelemetrySample.units == classic.telemetry.units
    assert fyd.TelemetrySample.help == classic.telemetry.help
    assert list(classic.step(0).telemetry.as_dict()) == list(classic.telemetry)


def test_nothing_else_of_the_library_is_seen():
    """Hidden: another C++ module of the process, or libfyd, never meets our symbols."""
    names = subprocess.run(["nm", "-D", "--defined-only", "--format=just-symbols", _fyd.__file__], check=True,
                           capture_output=True, text=True).stdout.split()
    assert "PyInit__fyd" in names
    ours = subprocess.run(["c++filt"], input="\n".join(names), check=True, capture_output=True, text=True).stdout
    assert [name for name in ours.split("\n") if name.startswith("fyd::")] == []


@pytest.mark.parametrize("name", ["Error", "InvalidValue"])
def test_errors_are_python_s(name):
    error = getattr(fyd, name)
    assert issubclass(error, fyd.Error) and issubclass(error, Exception) and error.__module__ == "fyd"
    assert issubclass(fyd.InvalidValue, ValueError)


def test_numbers_that_stand_for_words_are_those_of_the_headers():
    """Each is listed in its header and once more for Python, but for those that have one list for both (*_list.h)."""
    headers = "\n".join(file.read_text(encoding="utf-8") for file in sorted((ROOT / "core").rglob("*.h")))
    looked = []
    for name, value in vars(_fyd).items():
        if not inspect.isclass(value) or not hasattr(value, "__members__"):
            continue
        body = re.search(rf"enum class {name}\b[^{{;]*\{{(.*?)\}};", headers, re.DOTALL)[1]
        if "#include" in body:
            continue
        words = re.findall(r"^ *(\w+)", re.sub(r"//.*", "", body).replace(",", "\n"), re.MULTILINE)
        assert words == [each for each, _ in sorted(value.__members__.items(), key=lambda item: int(item[1]))], name
        looked.append(name)
    assert len(looked) >= 6


def test_a_number_that_stands_for_no_word_is_told():
    enums = [value for value in vars(_fyd).values() if inspect.isclass(value) and hasattr(value, "__members__")]
    assert len(enums) >= 8
    for each in enums:
        assert all(each(int(value)) == value for value in each.__members__.values())
        with pytest.raises(ValueError, match=f"^250: no {each.__name__}$"):
            each(250)
