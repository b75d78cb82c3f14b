"""Fits a stored surface to recorded accelerations, renders it for another speed, and says how well it stands for them."""
import sys

import numpy as np

import fyd

# Columns t_s, ax, ay, az; a rate of 100 Hz.
rows = np.loadtxt(sys.argv[1] if len(sys.argv) > 1 else "tests/data/texture_100hz/wood.csv", delimiter=",", skiprows=1)
accelerations_g, rate_Hz = rows[:, 1:4], 1 / np.median(np.diff(rows[:, 0]))
print(f"{len(rows)} rows at {rate_Hz:.0f} Hz")

# Three axes become one signal, by the method that the step uses.
parameters = fyd.Parameters({"texture.sample_rate_Hz": rate_Hz, "texture.filter": "none", "texture.frame": "64"})
chain = fyd.TextureChain(parameters)
signal_g = chain.run(accelerations_g - accelerations_g.mean(axis=0))
match, energy = fyd.spectral_match(accelerations_g - accelerations_g.mean(axis=0), signal_g, chain.delay_samples, rate_Hz)
print(f"{parameters['texture.method']}: spectral match {match:.2f}, {energy:.2f} of the energy")

surface, match = fyd.fit_surface(accelerations_g, rate_Hz, speed_mm_s=40, force_N=1, name="wood, fitted")
print(f"{surface.name}: {len(surface.bands)} bands, spectral match {match:.2f}")
texture = fyd.VirtualTexture(surface)
for speed_mm_s in (20, 40, 80):
    felt_g = texture.run(np.full(5000, speed_mm_s), np.ones(5000))
    print(f"at {speed_mm_s} mm/s: {np.std(felt_g):.4f} g RMS")
