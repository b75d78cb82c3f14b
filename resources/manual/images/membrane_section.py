#!/usr/bin/python3
"""Draws membrane_section.svg: python3 membrane_section.py OUT.svg

The section at y = −3 mm of a membrane that hangs in a frame of 100 × 70 mm and is pushed 5 mm down by a disc of 7 mm radius at
(0, −3). Laplace's equation is solved by differences on a grid of 0.5 mm.
"""
import sys

import numpy as np

HALF_X, HALF_Y, RADIUS, DEPTH, SECTION_Y, SENSOR_X = 50.0, 35.0, 7.0, 5.0, -3.0, 22.0
STEP = 0.5
SCALE_X, SCALE_Y, MIDDLE, TOP = 6.4, 34.0, 380.0, 110.0  # pixels for a millimetre, and where 0 is


def solve():
    """Depth along the section as a share of the finger's, at every STEP from −HALF_X on."""
    x = np.arange(-HALF_X, HALF_X + STEP / 2, STEP)
    y = np.arange(-HALF_Y, HALF_Y + STEP / 2, STEP)
    px, py = np.meshgrid(x, y, indexing="ij")
    finger = px**2 + (py - SECTION_Y) ** 2 <= RADIUS**2
    free = ~finger
    free[[0, -1], :] = free[:, [0, -1]] = False
    red = (np.add.outer(np.arange(len(x)), np.arange(len(y))) % 2 == 0) & free
    black = free & ~red
    u = finger.astype(float)
    for _ in range(600):  # successive over-relaxation, red and black points in turn
        for points in (red, black):
            mean = np.zeros_like(u)
            mean[1:-1, 1:-1] = 0.25 * (u[2:, 1:-1] + u[:-2, 1:-1] + u[1:-1, 2:] + u[1:-1, :-2])
            u[points] += 1.97 * (mean[points] - u[points])
    return x, u[:, int(round((SECTION_Y + HALF_Y) / STEP))]


def main():
    x, share = solve()
    depth_at_sensor = DEPTH * float(np.interp(SENSOR_X, x, share))
    left, right = MIDDLE - HALF_X * SCALE_X, MIDDLE + HALF_X * SCALE_X
    sensors = [MIDDLE - SENSOR_X * SCALE_X, MIDDLE + SENSOR_X * SCALE_X]
    rim = [MIDDLE - RADIUS * SCALE_X, MIDDLE + RADIUS * SCALE_X]
    plane, deepest = TOP + SCALE_Y * depth_at_sensor, TOP + SCALE_Y * DEPTH
    curve = " L".join(f"{MIDDLE + SCALE_X * a:.1f},{TOP + SCALE_Y * DEPTH * b:.1f}" for a, b in list(zip(x, share))[::2])
    out = [
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 760 456" font-family="sans-serif" font-size="14" role="img"'
        ' aria-labelledby="title desc">',
        '<title id="title">Cross section of the pushed cloth</title>',
        '<desc id="desc">The membrane hangs from the frame at both ends and is deepest under the finger; the plane through the'
        " distances at the two sensors lies far above the finger's tip.</desc>",
        '<rect width="760" height="456" fill="#ffffff"/>',
        f'<rect x="{left - 22}" y="96" width="22" height="28" rx="11" fill="#8a8f98"/>'
        f'<rect x="{right}" y="96" width="22" height="28" rx="11" fill="#8a8f98"/>',
        f'<text x="{left - 22}" y="86" fill="#333">frame, x = −{HALF_X:.0f} mm</text>'
        f'<text x="{right + 22}" y="86" fill="#333" text-anchor="end">x = {HALF_X:.0f} mm</text>',
        f'<line x1="{left}" y1="{TOP}" x2="{right}" y2="{TOP}" stroke="#8a8f98" stroke-width="1.5" stroke-dasharray="2 5"/>'
        f'<text x="226" y="102" fill="#555" text-anchor="middle">cloth, untouched</text>',
        f'<path d="M{rim[0]:.1f},35 L{rim[0]:.1f},258 Q{rim[0]:.1f},280 348,278.5 L412,278.5 Q{rim[1]:.1f},280 {rim[1]:.1f},258'
        f' L{rim[1]:.1f},35" fill="#f0d9c4" stroke="#b98d66" stroke-width="1.5"/>'
        f'<text x="{MIDDLE}" y="29" fill="#333" text-anchor="middle">finger, disc of radius {RADIUS:.0f} mm</text>',
    ]
    for at, sign in zip(sensors, ("−", "")):
        out.append(f'<line x1="{at:.1f}" y1="382" x2="{at:.1f}" y2="{plane:.1f}" stroke="#b3412e" stroke-width="1.5" stroke-dasharray="7 4"/>'
                   f'<rect x="{at - 16:.1f}" y="382" width="32" height="14" fill="#b3412e"/>'
                   f'<text x="{at:.1f}" y="414" fill="#b3412e" text-anchor="middle">IR sensor, x = {sign}{SENSOR_X:.0f} mm</text>')
    out += [
        f'<line x1="{left}" y1="{plane:.1f}" x2="{right}" y2="{plane:.1f}" stroke="#555" stroke-width="1.5" stroke-dasharray="10 5"/>'
        f'<text x="{right - 6}" y="{plane + 18:.1f}" fill="#333" text-anchor="end">plane through the</text>'
        f'<text x="{right - 6}" y="{plane + 36:.1f}" fill="#333" text-anchor="end">distances: about −{depth_at_sensor:.0f} mm</text>',
        f'<path d="M{curve}" fill="none" stroke="#1f6fb4" stroke-width="3" stroke-linejoin="round"/>'
        f'<text x="{left + 6}" y="195" fill="#1f6fb4">membrane, ∇²u = 0</text>',
        f'<path d="M460,{TOP} V{deepest} M456,{deepest - 8} L460,{deepest} L464,{deepest - 8} M412,{deepest} H476" stroke="#333"'
        f' stroke-width="1.2" fill="none"/><text x="468" y="253" fill="#333">δ = {DEPTH:.0f} mm</text>',
        f'<text x="{left - 22}" y="444" fill="#555">Section at y = −{-SECTION_Y:.0f} mm, finger at (0, −{-SECTION_Y:.0f}) mm; heights drawn 5 times'
        " as large as widths.</text>",
        "</svg>\n"]
    with open(sys.argv[1], "w", encoding="utf-8") as file:
        file.write("\n".join(out))


if __name__ == "__main__":
    main()
