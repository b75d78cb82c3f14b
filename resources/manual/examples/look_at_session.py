"""Looks at a session: what it holds, each touch, what was reported."""
import sys

import numpy as np

import fyd

with fyd.open(sys.argv[1] if len(sys.argv) > 1 else "session.h5") as recording:
    info = recording.info
    print(f"{info.started_utc}: {info.duration_s:.1f} s, {info.rows} steps, {info.pictures} pictures, {info.wholeness.name}")

    # A column is an array, a value for each step; its unit stands in its name.
    telemetry = recording.telemetry.load(["now_ns", "contact", "force_N", "indentation_mm", "stiffness_N_per_mm"])
    time_s, force_N, contact = recording.time_s, telemetry["force_N"], telemetry["contact"]

    # Where contact begins and ends.
    edges = np.flatnonzero(np.diff(np.concatenate([[False], contact, [False]]).astype(int)))
    for number, (begin, end) in enumerate(zip(edges[::2], edges[1::2]), 1):
        depth_mm = telemetry["indentation_mm"][begin:end]
        print(f"touch {number}: {time_s[begin]:.2f} to {time_s[end - 1]:.2f} s, at most {np.nanmax(force_N[begin:end]):.2f} N "
              f"and {np.nanmax(depth_mm):.1f} mm")

    tell_state = (fyd.EventKind.state_changed, fyd.EventKind.arm_refused)  # the others have no state: 0
    for event in recording.events:
        state = f"  {event.state.name}" if event.kind in tell_state else ""
        print(f"{recording.seconds(event.when_ns):6.2f} s  {event.kind.name}{state}")
    for note in recording.notes:
        print(f"{note.time_s:6.2f} s  {note.kind.name}: {note.text}")
