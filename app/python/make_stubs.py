#!/usr/bin/env python3
"""Writes the type stub of the compiled module, app/python/fyd/_fyd.pyi, from what the module says of itself:
PYTHONPATH=build/release/python /usr/bin/python3 app/python/make_stubs.py

--check compares the file with it instead. pybind11 writes a function's signature into the first line of its docstring;
the names of columns and of parameters' values come from the descriptions, as in the module.
"""
import argparse
import difflib
import inspect
import re
import sys
import textwrap
from pathlib import Path

sys.path.remove(str(Path(__file__).resolve().parent))  # the package's sources, without the compiled half

from fyd import _fyd  # noqa: E402

STUB = Path(__file__).resolve().parent / "fyd/_fyd.pyi"
HEAD = '''# Made by app/python/make_stubs.py from the module; not written by hand.
from collections.abc import Iterator, Sequence
from typing import Any, ClassVar, Optional, Union

import numpy
from numpy.typing import ArrayLike, NDArray

'''
# What Python's object and pybind11's own enums have anyway, and what is not for callers.
INHERITED = {"__module__", "__doc__", "__new__", "__getstate__", "__setstate__", "__reduce__", "__dict__", "__weakref__",
             "__entries", "__members__", "__str__", "__pybind11_module_local_v4_gcc_libstdcpp_cxxabi1017__"}
# What each may be given: more than what it gives.
TAKEN = {"tuple[Any, ...]": "Sequence[Any]"}


def typed(text, given=False):
    """A type as a stub has it. @param given of an argument, which takes what NumPy makes an array of"""
    text = text.replace("fyd._fyd.", "")
    text = re.sub(r"numpy\.ndarray\[(numpy\.\w+)\]", "ArrayLike" if given else r"NDArray[\1]", text)
    text = re.sub(r"numpy\.ndarray\[(bool)\]", "ArrayLike" if given else r"NDArray[numpy.bool_]", text)
    text = re.sub(r"\bnumpy\.ndarray\b", "ArrayLike" if given else "NDArray[Any]", text)
    text = re.sub(r"\bList\[", "list[", text)
    text = re.sub(r"\bTuple\[", "tuple[", text)
    text = re.sub(r"\bdict\b(?!\[)", "dict[str, Any]", text)
    text = re.sub(r"\btuple\b(?!\[)", "tuple[Any, ...]", text)
    text = re.sub(r"\bsequence\b", "Sequence[Any]", text)
    text = re.sub(r"\bobject\b", "Any", text)
    text = re.sub(r"\b[Ii]terator\b", "Iterator[Any]", text)
    return text


def split(arguments):
    """At the commas outside of brackets and strings."""
    out, depth, start = [], 0, 0
    for i, letter in enumerate(arguments):
        depth += (letter in "[({") - (letter in "])}")
        if letter == "," and depth == 0:
            out.append(arguments[start:i].strip())
            start = i + 1
    return [each for each in [*out, arguments[start:].strip()] if each]


def signature(doc):
    """(arguments, result) of the first line of a docstring."""
    match = re.match(r"\w*\((.*)\) -> (.*)$", doc.split("\n", 1)[0])
    if not match:
        raise SystemExit(f"no signature: {doc}")
    arguments = []
    for each in split(match[1]):
        name, colon, rest = each.partition(":")
        kind, equals, default = rest.strip().partition(" = ")
        if name == "self" or name == "arg0" and not arguments:
            arguments.append("self" if not equals else each)
        elif colon:
            kind = typed(kind, given=True)
            if default == "None" and not kind.startswith("Optional["):
                kind = f"Optional[{kind}]"
            arguments.append(f"{name}: {kind}" + (f" = {default}" if equals else ""))
        else:
            arguments.append("**values: Any" if name == "**kwargs" else name)
    return arguments, typed(match[2])


def words(doc):
    """What a docstring says beside the signature."""
    lines = (doc or "").split("\n")
    return "\n".join(lines[1:] if re.match(r"\w*\(.*\) -> ", lines[0]) else lines).strip()


def documented(doc, indent):
    text = words(doc)
    if not text:
        return ["    " * indent + "..."]
    body = textwrap.wrap(text, 118 - 4 * indent)
    if len(body) == 1:
        return ["    " * indent + f'"""{body[0]}"""']
    return ["    " * indent + line for line in ['"""' + body[0], *body[1:], '"""']]


def function(name, doc, indent, static=False):
    arguments, result = signature(doc)
    if static:
        arguments = [each if each != "self" else "arg0: Any" for each in arguments]
    if name == "__eq__" or name == "__ne__":
        arguments = ["self", "other: object"]
    out = ["    " * indent + "@staticmethod"] if static else []
    return [*out, "    " * indent + f"def {name}({', '.join(arguments)}) -> {result}:", *documented(doc, indent + 1)]


def property_of(name, value):
    result = typed(re.match(r".*-> (.*)", value.fget.__doc__.split("\n", 1)[0])[1])
    doc = value.__doc__ if value.__doc__ and "->" not in value.__doc__.split("\n", 1)[0] else words(value.fget.__doc__)
    out = ["    @property", f"    def {name}(self) -> {result}:", *documented(doc, 2)]
    if value.fset is not None:
        out += [f"    @{name}.setter", f"    def {name}(self, value: {TAKEN.get(result, result)}) -> None: ..."]
    return out


def of_class(name, value):
    bases = [each.__name__ for each in value.__bases__ if each.__name__ not in ("object", "pybind11_object")]
    out = [f"class {name}({', '.join(bases)}):" if bases else f"class {name}:", *documented(value.__doc__.split("\n\nMembers")[0], 1)]
    if issubclass(value, Exception):
        return out
    is_enum = hasattr(value, "__members__")
    for member in sorted(vars(value)):
        what = vars(value)[member]
        if member in INHERITED or member.startswith("__pybind11"):
            continue
        if is_enum and member in value.__members__:
            out.append(f"    {member}: ClassVar[{name}]")
        elif is_enum and member in ("name", "value"):
            out += ["    @property", f"    def {member}(self) -> {'str' if member == 'name' else 'int'}: ..."]
        elif isinstance(what, property):
            out += property_of(member, what)
        elif isinstance(what, staticmethod):
            out += function(member, what.__func__.__doc__, 1, static=True)
        elif what is None:  # __hash__ of what has its own equality
            out.append(f"    {member}: ClassVar[None]  # type: ignore[assignment]")
        elif callable(what):
            if what.__doc__.startswith("Initialize self."):  # the module makes it, not the caller
                continue
            out += function(member, what.__doc__, 1)
        elif isinstance(what, dict):
            out.append(f"    {member}: ClassVar[dict[str, str]]")
        else:
            raise SystemExit(f"{name}.{member}: what is {what!r}?")
    return out


def stub():
    out = []
    for name in sorted(vars(_fyd)):
        value = getattr(_fyd, name)
        if name.startswith("_") and name != "__version__":
            continue
        if inspect.isclass(value):
            out += [*of_class(name, value), ""]
        elif callable(value):
            out += [*function(name, value.__doc__, 0), ""]
        elif isinstance(value, dict):
            out += [f"{name}: dict[str, {'numpy.dtype[Any]' if name.endswith('DTYPES') else 'str'}]", ""]
        elif isinstance(value, tuple):
            out += [f"{name}: tuple[str, ...]", ""]
        elif isinstance(value, str):
            out += [f"{name}: str", ""]
        else:
            raise SystemExit(f"{name}: what is {value!r}?")
    return HEAD + "\n".join(out)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--check", action="store_true")
    made = stub()
    if not parser.parse_args().check:
        STUB.write_text(made, encoding="utf-8")
    elif made != STUB.read_text(encoding="utf-8"):
        sys.exit("".join(difflib.unified_diff(STUB.read_text(encoding="utf-8").splitlines(True), made.splitlines(True),
                                              str(STUB), "the module")) + "write it anew: app/python/make_stubs.py")
