"""An independent reader for the tests of recordings: h5py_peer.py FILE prints what it finds as JSON."""
import json
import sys

import h5py
import numpy

with h5py.File(sys.argv[1], "r") as file:
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
