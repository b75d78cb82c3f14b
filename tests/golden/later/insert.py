"""Writes copies of some of the core's files with a parameter, enumerators and inputs inserted in the middle, as a later
release may have them.

usage: insert.py PROJECT OUT | insert.py --list    (the names of the files)
"""
import pathlib
import shutil
import sys

# What must stand exactly once in a file -> what stands there in the later release.
CHANGES = {
    # A parameter in the middle of the step's: what was felt before there was it is what its value of 1 gives.
    "core/pipeline/parameters.h": {
        "  double motion_depth_scale = 1.0;\n":
            "  double inserted_gain = 2.0;\n"
            "  double motion_depth_scale = 1.0;\n",
        '    v.real("pipeline.motion_depth_scale", ':
            '    v.real("pipeline.inserted_gain", inserted_gain,\n'
            '           {.name = "Inserted", .minimum = 0, .maximum = 4, .help = "Inserted.", .live = true,\n'
            '            .before_it_was = 1.0});\n'
            '    v.real("pipeline.motion_depth_scale", ',
    },
    "core/pipeline/pipeline_outputs.cpp": {
        "                                 .depth_scale = step.motion_depth_scale,\n":
            "                                 .depth_scale = step.motion_depth_scale * step.inserted_gain,\n",
    },
    # A fault in the middle of the order of urgency: one line, with a number of its own.
    "core/pipeline/fault_list.h": {
        "FAULT(bridge_stale, ":
            'FAULT(inserted, 16, always, load_cell, signal, sentence("inserted"), sentence("Nothing."), false)\n'
            "FAULT(bridge_stale, ",
    },
    # An event in the middle of the list: one line, with a number of its own.
    "core/pipeline/event_list.h": {
        "EVENT(tare_failed, ":
            'EVENT(inserted, 99, "inserted", information, false, plain, say("Inserted."), std::string())\n'
            "EVENT(tare_failed, ",
    },
    # Inputs: a field in the middle of the finger detection, a number among the step's own, a value with its own table.
    "core/sensing/finger_types.h": {
        "  double x_px = 0.0;\n": "  double inserted_mm2 = 2.5;\n  double x_px = 0.0;\n",
        '        Field("x_px", ':
            '        Field("inserted_mm2", "mm²", "inserted", &F::inserted_mm2),\n        Field("x_px", ',
    },
    "core/pipeline/inputs.h": {
        "struct RobotInputs {\n":
            "struct Inserted {\n  double value_K = 3.5;\n  static constexpr auto fields() {\n"
            '    return std::tuple(Field("value_K", "K", "inserted", &Inserted::value_K));\n  }\n};\n\n'
            "struct RobotInputs {\n",
        "  std::uint64_t missed_cycles = 0;\n":
            "  double inserted_K = 4.5;\n  Timed<Inserted> inserted;\n  std::uint64_t missed_cycles = 0;\n",
        '        Field("missed_cycles", ':
            '        Field("inserted_K", "K", "inserted", &Inputs::inserted_K),\n        Field("missed_cycles", ',
        '        InputTable("/inputs/ir", ':
            '        InputTable("/inputs/inserted", 24, "inserted", &Inputs::inserted),\n'
            '        InputTable("/inputs/ir", ',
    },
}


def main():
    if sys.argv[1:] == ["--list"]:
        print(";".join(CHANGES), end="")
        return
    project, out = map(pathlib.Path, sys.argv[1:])
    shutil.rmtree(out, ignore_errors=True)  # of a list that was longer
    for name, places in CHANGES.items():
        text = (project / name).read_text(encoding="utf-8")
        for now, later in places.items():
            if text.count(now) != 1:
                sys.exit(f"insert.py: {name}: {now!r} stands {text.count(now)} times; expected once")
            text = text.replace(now, later)
        file = out / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")


main()
