"""Writes headers as a later program may have them: inputs added in the middle of what the step takes.

    insert_inputs.py SOURCE_FOLDER OUT_FOLDER

A field in the middle of the finger detection, a number among the step's own, and a value with a table of its own. The
rest of the program is compiled against them as it is, and must replay what was recorded before.
"""
import pathlib
import sys

INSERTED = {
    "core/sensing/finger_types.h": [
        ("  double x_px = 0.0;\n", "  double inserted_mm2 = 2.5;\n"),
        ('        Field("x_px", ', '        Field("inserted_mm2", "mm²", "inserted", &F::inserted_mm2),\n'),
    ],
    "core/pipeline/inputs.h": [
        ("struct RobotInputs {\n", "struct Inserted {\n  double value_K = 3.5;\n  static constexpr auto fields() {\n"
         '    return std::tuple(Field("value_K", "K", "inserted", &Inserted::value_K));\n  }\n};\n\n'),
        ("  std::uint64_t missed_cycles = 0;\n", "  double inserted_K = 4.5;\n  Timed<Inserted> inserted;\n"),
        ('        Field("missed_cycles", ', '        Field("inserted_K", "K", "inserted", &Inputs::inserted_K),\n'),
        ('        InputTable("/inputs/ir", ', '        InputTable("/inputs/inserted", 24, "inserted", &Inputs::inserted),\n'),
    ],
}

source, out = map(pathlib.Path, sys.argv[1:])
for name, insertions in INSERTED.items():
    text = (source / name).read_text(encoding="utf-8")
    for before, inserted in insertions:
        if text.count(before) != 1:
            sys.exit(f"{name}: {before!r} stands there {text.count(before)} times, not once")
        text = text.replace(before, inserted + before)
    (out / name).parent.mkdir(parents=True, exist_ok=True)
    (out / name).write_text(text, encoding="utf-8")
