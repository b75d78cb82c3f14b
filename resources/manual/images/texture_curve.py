#!/usr/bin/env python3
"""Draws texture_curve.svg from the table of `fyd bench texture --out DIR`: python3 texture_curve.py DIR/texture.csv OUT.svg

For every method and frame the worst spectral match over the synthetic signals at 1 kHz, against its delay.
"""
import csv
import math
import sys

WIDTH, HEIGHT, LEFT, BOTTOM, TOP, RIGHT = 760, 430, 70, 60, 20, 190
DELAYS = [0, 1, 3, 7, 15, 31, 63, 127, 255, 511]
LINES = {  # name: (colour, shape, which rows)
    "dft321, hop = frame/2": ("#1f6fb4", lambda r: r["method"] == "dft321" and 2 * int(r["hop"]) == int(r["frame"])),
    "dft321, blocks": ("#d1720b", lambda r: r["method"] == "dft321" and r["hop"] == r["frame"]),
    "dft321_thesis": ("#8a8a8a", lambda r: r["method"] == "dft321_thesis"),
    "recolour": ("#2a8a3a", lambda r: r["method"] == "recolour"),
    "principal": ("#7a4fa3", lambda r: r["method"] == "principal"),
    "soc": ("#b3262b", lambda r: r["method"].startswith("soc")),
    "single": ("#555555", lambda r: r["method"] == "single"),
}


def x(delay_ms):
    return LEFT + (WIDTH - LEFT - RIGHT) * math.log2(delay_ms + 1) / 9.2


def y(match):
    return TOP + (HEIGHT - TOP - BOTTOM) * (1 - max(match, 0.0))


def worst(rows):
    points = {}
    for row in rows:
        delay = float(row["delay (ms)"])
        points[delay] = min(points.get(delay, 1.0), float(row["spectral match"]))
    return sorted(points.items())


def main():
    with open(sys.argv[1], newline="") as file:
        rows = [row for row in csv.DictReader(file) if "100 Hz" not in row["signal"]]
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" font-family="sans-serif" '
           f'font-size="13"><rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>']
    for match in [0, 0.2, 0.4, 0.6, 0.8, 0.92, 1.0]:
        dash = ' stroke-dasharray="6 4"' if match == 0.92 else ""
        out.append(f'<line x1="{LEFT}" x2="{WIDTH - RIGHT}" y1="{y(match):.1f}" y2="{y(match):.1f}" stroke="#ccc"{dash}/>'
                   f'<text x="{LEFT - 8}" y="{y(match) + 4:.1f}" text-anchor="end">{match}</text>')
    for delay in DELAYS:
        out.append(f'<text x="{x(delay):.1f}" y="{HEIGHT - BOTTOM + 20}" text-anchor="middle">{delay}</text>')
    out.append(f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 15}" text-anchor="middle">delay, ms at 1 kHz</text>'
               f'<text transform="translate(20,{HEIGHT / 2}) rotate(-90)" text-anchor="middle">worst spectral match</text>')
    for i, (name, (colour, chosen)) in enumerate(LINES.items()):
        points = worst(filter(chosen, rows))
        path = " ".join(f"{x(d):.1f},{y(m):.1f}" for d, m in points)
        out.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="2"/>')
        out += [f'<circle cx="{x(d):.1f}" cy="{y(m):.1f}" r="4" fill="{colour}"/>' for d, m in points]
        at = TOP + 20 + 22 * i
        out.append(f'<circle cx="{WIDTH - RIGHT + 20}" cy="{at}" r="5" fill="{colour}"/>'
                   f'<text x="{WIDTH - RIGHT + 32}" y="{at + 4}">{name}</text>')
    out.append("</svg>\n")
    with open(sys.argv[2], "w") as file:
        file.write("\n".join(out))


main()
