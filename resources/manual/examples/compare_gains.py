"""Compares two gains on one session: what would the step have commanded?"""
import sys

import numpy as np

import fyd

with fyd.open(sys.argv[1] if len(sys.argv) > 1 else "session.h5") as recording:
    same = recording.replay()
    print(f"as it was: {same.steps} of {same.of} steps, {'the same' if same.identical else 'not the same'} bit for bit, "
          f"{same.speed_x:.0f} times real time")
    if same.steps < same.of:  # a replay ends at the first step that the recording lost
        print(f"  {same.gaps} steps are lost; the replay ends there")

    gain = recording.parameters["control.kp"]
    what = fyd.Parameters.info("control.kp")
    print(f"control.kp: {what.help} It was {gain:g}; {what.allowed}.")
    for factor in (0.5, 2.0):
        print(f"control.kp = {factor * gain:g}")
        other = recording.replay({"control.kp": factor * gain})
        # The recorded inputs are used unchanged: the difference is what the law commands, not what the cloth would do.
        off_deg = other.telemetry["stretch_reference_deg"] - recording.telemetry["stretch_reference_deg"][:other.steps]
        print(f"  commanded: {other.different} steps differ, stretch off by {np.sqrt(np.mean(off_deg**2)):.3f}° RMS, "
              f"{np.abs(off_deg).max():.3f}° at most")
        try:  # motors and a cloth that answer as the recording's touches say; it must say enough of them
            loop = recording.replay({"control.kp": factor * gain}, closed_loop=True)
        except fyd.Error as refused:
            print(f"  felt: not known: {refused}")
            continue
        print(f"  felt: {loop.stiffness_error_replayed_percent:.2f} % RMS off the target stiffness, "
              f"{loop.stiffness_error_recorded_percent:.2f} % as recorded; the force off by "
              f"{np.nanmax(np.abs(loop.telemetry['force_N'] - recording.telemetry['force_N'][:loop.steps])):.3f} N at most")
