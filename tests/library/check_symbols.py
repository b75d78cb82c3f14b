#!/usr/bin/env python3
"""Compares what libfyd.so exports with what its headers mark with FYD_API: PREFIX=… LIBDIR=… check_symbols.py.

A symbol that no header marks is an error, and so is a marked class or function without a symbol.
"""
import os
import pathlib
import re
import subprocess
import sys

NAMESPACE = re.compile(r"^namespace ([\w:]+) \{")
CLASS = re.compile(r"^ *(?:class|struct) FYD_API (\w+)")
FUNCTION = re.compile(r"FYD_API (?:[^(;=]*?[\s&*>])?((?:[\w]+::)*\w+|operator[^\s(]+)\(")
SPECIAL = re.compile(r"^(?:typeinfo for |typeinfo name for |vtable for |VTT for |(?:non-)?virtual thunk to |guard variable for )")


def marked(text):
    """Qualified classes and functions that a header marks."""
    classes, functions, space = set(), set(), ""
    lines = text.split("\n")
    for number, line in enumerate(lines):
        if match := NAMESPACE.match(line):
            space = match.group(1) + "::"
        elif line.startswith("}  // namespace"):
            space = ""
        elif "FYD_API" in line and not line.startswith(("#", "//")):
            if match := CLASS.match(line):
                classes.add(space + match.group(1))
                continue
            statement = line
            while "(" not in statement:
                number += 1
                statement += " " + lines[number].strip()
            functions.add(space + FUNCTION.search(statement).group(1))
    return classes, functions


def qualified(symbol):
    """The demangled name without its arguments, and of a template without what it returns."""
    name = SPECIAL.sub("", symbol)
    depth, start, i = 0, 0, 0
    while i < len(name):
        if name.startswith("operator", i) and depth == 0:
            return name[start:i] + re.match(r"operator *(\(\)|[^\s(<]+|<=?>?|[\w ]+)", name[i:]).group(0).replace(" ", "")
        character = name[i]
        if character == "<":
            depth += 1
        elif character == ">":
            depth -= 1
        elif depth == 0 and character == " ":
            start = i + 1
        elif depth == 0 and character in "([":
            return name[start:i]
        i += 1
    return name[start:]


def problems(symbols, classes, functions):
    used, found = set(), []
    for symbol in symbols:
        name = re.sub(r"<.*", "", qualified(symbol))
        owner = next((c for c in classes if name == c or name.startswith(c + "::")), None)
        if owner is None and name not in functions:
            found.append(f"exported, but no header marks it with FYD_API: {symbol}")
        used.add(owner or name)
    found += [f"marked with FYD_API, but not exported: {name}" for name in sorted((classes | functions) - used)]
    return found


def check():
    prefix = pathlib.Path(os.environ["PREFIX"])
    classes, functions = set(), set()
    for path in (prefix / "include" / "fyd").rglob("*.h"):
        of_class, of_function = marked(path.read_text(encoding="utf-8"))
        classes |= of_class
        functions |= of_function
    library = prefix / os.environ["LIBDIR"] / "libfyd.so"
    names = subprocess.run(["nm", "-D", "--defined-only", "--format=just-symbols", library], check=True, capture_output=True,
                           text=True).stdout
    names = "\n".join(name.split("@")[0] for name in names.split() if name != "FYD_0" and not name.startswith("FYD_0@"))
    symbols = subprocess.run(["c++filt"], input=names, check=True, capture_output=True, text=True).stdout.split("\n")
    symbols = [symbol for symbol in symbols if symbol]
    print(f"{len(symbols)} symbols of {len(classes)} classes and {len(functions)} functions")
    found = problems(symbols, classes, functions)
    soname = subprocess.run(["readelf", "-d", library], check=True, capture_output=True, text=True).stdout
    if "[libfyd.so.0]" not in soname:
        found.append("SONAME is not libfyd.so.0")
    return found


def self_test():
    classes, functions = marked("namespace fyd::a {\nclass FYD_API B final : public C {\n};\n"
                                "[[nodiscard]] FYD_API std::optional<D> make(int x);\n"
                                "[[nodiscard]] FYD_API std::unique_ptr<E>\nlong_one(int);\n}  // namespace fyd::a\n"
                                "extern template FYD_API std::vector<fyd::P> fyd::bind(fyd::a::B& b);\n")
    assert classes == {"fyd::a::B"}, classes
    assert functions == {"fyd::a::make", "fyd::a::long_one", "fyd::bind"}, functions
    good = ["fyd::a::B::B(int)", "vtable for fyd::a::B", "fyd::a::B::operator=(fyd::a::B const&)", "fyd::a::make(int)",
            "fyd::a::long_one(int)", "std::vector<fyd::P, std::allocator<fyd::P> > fyd::bind<fyd::a::B>(fyd::a::B&)",
            "fyd::a::B::step[abi:cxx11]()"]
    assert problems(good, classes, functions) == []
    assert len(problems(good + ["fyd::a::hidden(int)"], classes, functions)) == 1
    assert len(problems(good + ["std::vector<fyd::P>::vector()"], classes, functions)) == 1
    assert len(problems(good[:3], classes, functions)) == 3


if __name__ == "__main__":
    self_test()
    failures = check()
    print("\n".join(failures) or "exactly what the headers mark is exported")
    sys.exit(1 if failures else 0)
