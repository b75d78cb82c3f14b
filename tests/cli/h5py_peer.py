"""An independent reader for the tests of recordings. h5py_peer.py FILE prints what it finds as JSON;
h5py_peer.py --shared FILE opens it as HDF5's readers open a file with a writer, and looks twice; --growing FILE looks
until there is more than at first, for a minute."""
import json
import sys
import time

import h5py
import numpy


def whole(path):
    with h5py.File(path, "r") as file:
        telemetry = file["telemetry"]
        units = [unit.decode() for unit in telemetry.attrs["units"]]
        rows = telemetry[:]
        overview = file["overview/rows_250"][:]
        blocks = rows["touch_z_mm"][: len(overview) * 250].reshape(-1, 250)
        last = file["commits"][-1]
        print(json.dumps({
            "rows": len(rows),
            "steps_in_order": bool(numpy.all(numpy.diff(rows["step"].astype("int64")) == 1)),
            "units": dict(zip(telemetry.dtype.names, units)),
            "operator": file["header/operator"][()].decode(),
            "profile": file["header/profile"][()].decode(),
            "closed": int(last["closed"]),
            "committed_rows": int(last["rows"][0]),
            "overview_true": bool(numpy.array_equal(overview["touch_z_mm_min"], blocks.min(axis=1))
                                  and numpy.array_equal(overview["touch_z_mm_max"], blocks.max(axis=1))),
        }))


def look(file):
    """The telemetry's rows up to the newest commit: what a reader may trust."""
    for name in ("commits", "telemetry"):
        file[name].refresh()
    committed = int(file["commits"][-1]["rows"][0])
    rows = file["telemetry"][:committed]
    return {"rows": committed, "steps_in_order": bool(numpy.all(numpy.diff(rows["step"].astype("int64")) == 1))}


def shared(path, seconds):
    with h5py.File(path, "r", swmr=True) as file:
        first = second = look(file)
        end = time.monotonic() + seconds
        while True:
            late = time.monotonic() >= end
            second = look(file)
            if late or second["rows"] > first["rows"]:
                break
            time.sleep(0.1)
        print(json.dumps([first, second]))


if sys.argv[1] == "--shared":
    shared(sys.argv[2], 0)
elif sys.argv[1] == "--growing":
    shared(sys.argv[2], 60)
else:
    whole(sys.argv[1])
