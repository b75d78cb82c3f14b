"""Compares two gains on one session: what would the step have commanded?"""
import sys

import numpy as np

import fyd

with fyd.open(sys.argv[1] if len(sys.argv) > 1 else "session.h5") as recording:
    same = recording.replay()
    print(f"as it was: {same.steps} steps, {'the same' if same.identical else 'not the same'} bit for bit, "
          f"{same.speed_x:.0f} times real time")

    gain = recording.parameters["control.kp"]
    what = fyd.Parameters.info("control.kp")
    print(f"control.kp: {what.help} It was {gain:g}; {what.allowed}.")
    for factor in (0.5, 2.0):
        other = recording.replay({"control.kp": factor * gain})
        # The recorded inputs are used unchanged: the difference is what the law commands, not what the cloth would do.
        off_deg = other.telemetry["stretch_reference_deg"] - recording.telemetry["stretch_reference_deg"]
        print(f"control.kp = {factor * gain:g}: {other.different} steps differ, stretch off by {np.sqrt(np.mean(off_deg**2)):.3f}° "
              f"RMS, {np.abs(off_deg).max():.3f}° at most")
