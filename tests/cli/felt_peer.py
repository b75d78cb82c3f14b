#!/usr/bin/python3
"""A finger at the end of motors, rollers and cloth, written from the requirement, not from the program: what it feels of
the duties that `fyd texture felt` commands.

  felt_peer.py inputs FOLDER      writes NAME.csv (t_s,ax,ay,az) of each signal and prints their names
  felt_peer.py judge FOLDER       reads jobs.json: a list of {"out": CSV of the program, "in": name, plant…}; prints a list of
                                  figures
  felt_peer.py sweep FOLDER FILE  reads FOLDER/plant.json and writes FILE, a sweep for `fyd texture identify`

The plant itself stands in felt_plant.cpp, which the build makes: $FELT_PLANT.
"""
import ctypes
import json
import os
import sys

import numpy as np
from scipy import signal

PLANT = ctypes.CDLL(os.environ["FELT_PLANT"])

MATERIALS = {  # wave length mm, amplitude g; rough g. Others than the program's own.
    "cork": ([(3.1, .20), (1.2, .24), (.55, .12)], .05),
    "canvas": ([(1.5, .10), (.75, .30), (.38, .15)], .07),
    "plank": ([(2.2, .40), (.9, .50), (.5, .35)], .10),
    "lino": ([(1.9, .05), (.8, .08), (.4, .05)], .02),
}
STROKES = ((25, .7), (35, 2.0), (55, 1.2))
BANDS = {"band_50_140": (50, 140, .08), "band_70_220": (70, 220, .3), "band_90_180": (90, 180, .8)}
LEVELS = (.02, .05, .1, .2, .5, 1., 2.)


def band(low, high, rms, seconds=4, seed=11):
    n = int(seconds * 1000)
    f = np.fft.rfftfreq(n, 1e-3)
    rng = np.random.default_rng(seed)
    x = np.fft.irfft((rng.standard_normal(len(f)) + 1j * rng.standard_normal(len(f))) * ((f > low) & (f < high)), n)
    return x * rms / x.std()


def material(name, speed, force, seconds=4, seed=1):
    waves, rough = MATERIALS[name]
    rng = np.random.default_rng(seed)
    t = np.arange(int(seconds * 1000)) / 1000
    v = speed * (1 + .25 * np.sin(2 * np.pi * .6 * t + seed))
    f = force * (1 + .25 * np.sin(2 * np.pi * .5 * t + 2 * seed))
    place = np.cumsum(v) / 1000
    b, a = signal.butter(2, 200 / 500)
    out = np.zeros((len(t), 3))
    for axis in range(3):
        share = (.8, .5, 1.)[axis]
        for length, amplitude in waves:
            out[:, axis] += share * amplitude * np.sin(2 * np.pi * place / length + rng.uniform(0, 6.28))
        out[:, axis] += signal.lfilter(b, a, share * rough * rng.standard_normal(len(t)))
    return out * (v / (v + 30) * np.sqrt(f))[:, None]


def three(x):
    return np.column_stack([.5 * x, .3 * x, .81 * x])


def inputs():
    out = {f"{m}_{v}": material(m, v, f, seed=i + 3 * j)
           for j, m in enumerate(MATERIALS) for i, (v, f) in enumerate(STROKES)}
    out |= {name: three(band(*b)) for name, b in BANDS.items()}
    out |= {f"level_{level}": three(band(70, 180, level, seed=5)) for level in LEVELS}
    rng = np.random.default_rng(9)
    out["silence"] = .003 * rng.standard_normal((4000, 3))
    knock = np.zeros(3000)
    t = np.arange(60) / 1000
    knock[2000:2060] = .1 * np.sin(2 * np.pi * 120 * t) * np.exp(-t / .012)
    out["tap"] = three(knock)
    faint = band(70, 180, .02, seconds=3, seed=8)
    out["faint_then_tap"] = three(faint + 10 * knock)
    out["far"] = three(band(150, 350, .3, seed=7))
    return out


def plant(duty, b, f0, damping=.3, friction=1.15, sliding=.75, presliding=0., alive=1., slack=False):
    """duty (samples, runs, 2) in %; b in %, f0 in Hz, one a run -> finger in g, motor angles in degrees"""
    samples, runs, _ = duty.shape
    duty, b, f0 = (np.ascontiguousarray(each, float) for each in (duty, np.broadcast_to(b, runs), np.broadcast_to(f0, runs)))
    constants = np.array([damping, friction, sliding, presliding, alive, slack], float)
    finger, angles = np.empty((samples, runs)), np.empty((samples, runs, 2))
    number = ctypes.c_size_t
    PLANT.feltPlant(constants.ctypes, number(samples), number(runs), duty.ctypes, b.ctypes, f0.ctypes, finger.ctypes, angles.ctypes)
    return finger, angles


def figures(finger, wanted):
    f, p = signal.welch(finger, 1000, "hann", 512, 256, detrend=False)
    _, q = signal.welch(wanted, 1000, "hann", 512, 256, detrend=False)
    above = f >= 20
    p, q = np.sqrt(p[above]), np.sqrt(q[above])
    match = 1 - np.abs(p * q.sum() / p.sum() - q).sum() / q.sum() if p.sum() > 1e-9 and q.sum() > 1e-9 else 0.
    centres = 1000 * 2. ** (np.arange(-16, -3) / 3)
    f = f[above]
    bands = [(f >= c * 2 ** (-1 / 6)) & (f < c * 2 ** (1 / 6)) for c in centres]
    power = [np.array([(y[i] ** 2).sum() + 1e-18 for i in bands if i.any()]) for y in (p, q)]
    weight = np.sqrt(power[1])
    apart = 10 * np.log10(power[0] / power[1])
    apart = apart - (apart * weight).sum() / weight.sum()
    sos = signal.butter(2, 10, fs=1000, output="sos")
    envelope = [np.sqrt(np.maximum(signal.sosfiltfilt(sos, y ** 2), 0)) for y in (finger, wanted)]
    lag = int(np.argmax([abs(np.dot(finger[k:], wanted[:len(wanted) - k])) for k in range(50)]))
    return {"match": match, "thirds_dB": float((np.abs(apart) * weight).sum() / weight.sum()),
            "envelope": float(np.corrcoef(envelope)[0, 1]) if min(np.std(e) for e in envelope) > 1e-12 else 0.,
            "level_g": float(np.sqrt((finger ** 2).mean())), "lag_ms": lag}


def judge(folder):
    jobs = json.load(open(f"{folder}/jobs.json", encoding="utf-8"))
    tables = [np.loadtxt(job["out"], delimiter=",", skiprows=1) for job in jobs]
    out = [None] * len(jobs)
    kinds = {}
    for i, (job, table) in enumerate(zip(jobs, tables)):  # runs of one kind and length go together
        kinds.setdefault((json.dumps(job.get("plant", {}), sort_keys=True), len(table)), []).append(i)
    for (kind, _), which in kinds.items():
        duty = np.stack([tables[i][:, 3:5] for i in which], 1)
        finger, angles = plant(duty, [jobs[i]["b"] for i in which], [jobs[i]["f0"] for i in which], **json.loads(kind))
        for j, i in enumerate(which):
            stretch = (angles[:, j, 0] - angles[:, j, 1]) / 2
            begin = 500 if len(finger) > 3500 else 0
            out[i] = figures(finger[begin:, j], tables[i][begin:, 1]) | {
                "duty_rms": [float(v) for v in np.sqrt((duty[:, j] ** 2).mean(0))],
                "duty_peak": float(np.abs(duty[:, j]).max()), "peak_g": float(np.abs(finger[1990:, j]).max()),
                "limited": float(tables[i][:, 5].mean()),
                "first_duty": int(np.argmax(np.abs(duty[:, j, 0]) > 1)),
                "stretch_moved": float(np.abs(stretch - stretch[0]).max())}
    print(json.dumps(out))


def sweep(folder, file):
    p = json.load(open(f"{folder}/plant.json", encoding="utf-8"))
    rng = np.random.default_rng(4)
    experiments = []  # duty, stretch, resonance, whether an accelerometer is read
    t = np.arange(8000) / 1000
    for motor in (0, 1):
        for sign in (1, -1):
            duty = np.zeros((len(t), 2))
            duty[:, motor] = sign * 5 * t
            experiments.append((duty, 45, p["f0"][0], False))
    for stretch, f0 in zip(p["stretch"], p["f0"]):
        phase = 2 * np.pi * (8 * t + (350 - 8) * t ** 2 / 16)
        x = np.round(90 * np.sin(phase) * np.minimum(1, t / .1), 4)
        experiments.append((np.column_stack([x, x]), stretch, f0, p.get("accelerometer", True)))
    finger, angles = plant(np.stack([e[0] for e in experiments], 1), p["b"], [e[2] for e in experiments], damping=p["zeta"],
                           sliding=p.get("sliding", .75))
    rows = []
    for i, (duty, stretch, _, accelerometer) in enumerate(experiments):
        turned = angles[:, i] + np.array([stretch, -stretch]) + rng.uniform(0, .0879)
        counts = np.floor(turned / 360 * 4096).astype(int) % 4096
        g = finger[:, i] + .002 * rng.standard_normal(len(t)) + 1.
        for n in range(len(t) if i >= 4 else p.get("ramp_samples", len(t))):
            rows.append(f"{9 * i + t[n]:.3f},{i + 1},{stretch},{duty[n, 0]:.4f},{duty[n, 1]:.4f},{counts[n, 0]},"
                        f"{counts[n, 1]},{g[n] if accelerometer else ''}")
    with open(file, "w", encoding="utf-8") as out:
        out.write("t_s,part,stretch_deg,duty1_percent,duty2_percent,encoder1_counts,encoder2_counts,acceleration_g\n")
        out.write("\n".join(rows) + "\n")


if __name__ == "__main__":
    if sys.argv[1] == "inputs":
        made = inputs()
        for name, axes in made.items():
            np.savetxt(f"{sys.argv[2]}/{name}.csv", np.column_stack([np.arange(len(axes)) / 1000, axes + [0, 0, 1]]),
                       delimiter=",", header="t_s,ax,ay,az", comments="", fmt="%.9g")
        print(json.dumps(list(made)))
    elif sys.argv[1] == "judge":
        judge(sys.argv[2])
    else:
        sweep(sys.argv[2], sys.argv[3])
