#!/usr/bin/env python3
"""The cloth's finite elements against what they must obey: refinement, energy, the thesis' four points, and Laplace's
membrane in the limit of a flat disc that hardly presses."""
import sys
from pathlib import Path

import numpy as np
from scipy.sparse import lil_matrix
from scipy.sparse.linalg import spsolve

sys.path.insert(0, sys.argv[1])
from cloth_solver import HALF_X, HALF_Y, MODULUS, POISSON, Cloth, Finger, solve  # noqa: E402

failures = []


def check(what, value, expected, tolerance):
    good = abs(value - expected) <= tolerance
    print(f"{'ok  ' if good else 'FAIL'} {what}: {value:.5g}, expected {expected:.5g} ± {tolerance:.2g}")
    if not good:
        failures.append(what)


def laplace_disc(radius, tension):
    """Force per depth of Laplace's membrane under a level disc in the middle, by finite differences of a quarter."""
    h = 0.25
    nx, ny = round(HALF_X / h), round(HALF_Y / h)
    index = np.arange(nx * ny).reshape(nx, ny)  # nodes at i·h, j·h; the last ones before the frame
    matrix, right = lil_matrix((nx * ny, nx * ny)), np.zeros(nx * ny)
    inside = np.hypot(*np.meshgrid(np.arange(nx) * h, np.arange(ny) * h, indexing="ij")) <= radius + 1e-9
    for i in range(nx):
        for j in range(ny):
            k = index[i, j]
            if inside[i, j]:
                matrix[k, k], right[k] = 1.0, 1.0
                continue
            matrix[k, k] = 4.0
            for a, b in ((abs(i - 1), j), (i + 1, j), (i, abs(j - 1)), (i, j + 1)):
                if a < nx and b < ny:
                    matrix[k, index[a, b]] -= 1.0
    u = np.zeros((nx + 1, ny + 1))
    u[:-1, :-1] = spsolve(matrix.tocsr(), right).reshape(nx, ny)
    # Twice the energy of the whole is four quarters; differences along the mirror lines count half.
    dx, dy = np.diff(u, axis=0) ** 2, np.diff(u, axis=1) ** 2
    dx[:, 0] *= 0.5
    dy[0] *= 0.5
    return 4 * tension * (dx.sum() + dy.sum())


# The four points of the thesis, by a mesh of its own.
for stretch, stiffness in ((1.310, 0.501), (1.337, 0.550), (1.402, 0.673), (1.423, 0.715)):
    pressed = solve(Finger("sphere", 8.0), (0, 0), 3.0, stretch)
    check(f"stiffness at pre-stretch {stretch}", pressed.force / 3.0, stiffness, 0.003 * stiffness)

# Half the step changes little.
coarse = solve(Finger("sphere", 8.0), (22, -3), [2.0, 5.0], 1.35)
fine = solve(Finger("sphere", 8.0), (22, -3), [2.0, 5.0], 1.35, fine=0.25, coarse=3.0, growth=1.25)
for a, b in zip(coarse, fine):
    check(f"force at {a.depth} mm, coarse and fine", a.force, b.force, 0.004 * b.force)
    check(f"area at {a.depth} mm, coarse and fine", a.area, b.area, 0.05 * b.area)
    check(f"sensor at {a.depth} mm, coarse and fine", a.deflection[1], b.deflection[1], 0.01)

# What the finger's way put in is in the cloth: four edges, two edges, sticking (which loses nothing: it never slides back).
for name, options in (("four edges", {}), ("rollers", dict(edges="rollers", stretch=1.65)), ("2:1", dict(ratio=2.0))):
    options = dict(stretch=1.337) | options
    depths = np.linspace(0, 4, 17)[1:]
    run = solve(Finger("sphere", 8.0), (10, 5), list(depths), **options)
    force = np.array([0.0] + [p.force for p in run])
    work = np.concatenate([[0], depths])
    check(f"energy, {name}", run[-1].energy, np.trapz(force, work), 0.005 * run[-1].energy)

# A flat disc of 7 mm, a hundredth of a millimetre deep, is Laplace's membrane under the cloth's tension.
stretch = 1.337
tension = MODULUS / (1 - POISSON) * (stretch**2 - 1) / 2
pressed = solve(Finger("disc", 7.0), (0, 0), 0.01, stretch)
linear = laplace_disc(7.0, tension)
check("stiffness of a disc 0.01 mm deep", pressed.force / 0.01, linear, 0.01 * linear)

# Under tension the sides know each other: mirrored fingers feel the same.
left, right = (solve(Finger("sphere", 8.0), (x, 12), 4.0, 1.337) for x in (-20, 20))
check("mirrored force", left.force, right.force, 1e-6)
check("mirrored sensor", left.deflection[0], right.deflection[2], 1e-4)

# A cloth between rollers bears no compression: nowhere is its smaller principal stress below nothing.
cloth = Cloth(Finger(), (0, 0), 1.65, "rollers")
cloth.press(4.0)
f = np.einsum("egai,eac->egci", cloth.dn, cloth.nodes[cloth.quads])
e = np.stack([0.5 * ((f[..., 0] ** 2).sum(-1) - 1), 0.5 * ((f[..., 1] ** 2).sum(-1) - 1), (f[..., 0] * f[..., 1]).sum(-1)], -1)
s = cloth._stress(e)[1]
least = 0.5 * (s[..., 0] + s[..., 1]) - np.hypot(0.5 * (s[..., 0] - s[..., 1]), s[..., 2])
check("least principal stress between rollers, N/mm", min(least.min(), 0.0), 0.0, 1e-4)

print(f"{'0 passed' if failures else '1 passed'}, {len(failures)} failed")
sys.exit(1 if failures else 0)
