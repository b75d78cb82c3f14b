"""Files that the manual's commands take for granted: python3 assumed.py calibration|sensing|scenes"""
import math
import random
import struct
import sys
import zlib


def write(name, text):
    with open(name, "w", encoding="utf-8") as file:
        file.write(text)


def csv(name, header, rows):
    write(name, header + "\n" + "".join(",".join(f"{v:.9g}" for v in row) + "\n" for row in rows))


def calibration():
    noise = random.Random(1)
    # A falling curve of a distance sensor, and a load cell's straight line.
    csv("ir.csv", "adc,distance_mm", [(round(4096 / 3.3 * 2.9 / (1 + d / 60) + noise.gauss(0, 2)), d)
                                      for d in range(40, 301, 20) for _ in range(4)])
    csv("load-cell.csv", "value,force_N", [((g + 20.2512) / 1004.8805 + noise.gauss(0, 0.001), g * 9.80665e-3)
                                           for g in (0, 100, 200, 300, 400, 500, 600, 700, 600, 400, 200, 0)])


def grey_png(name, width, height, value_at):
    rows = b"".join(b"\0" + bytes(value_at(x, y) for x in range(width)) for y in range(height))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    with open(name, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0))
                   + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def sensing():
    for name, x0 in (("picture.png", 150), ("other.jpg", 120)):  # decoders look at the contents, not at the name
        grey_png(name, 320, 240, lambda x, y, x0=x0: 60 if math.hypot(x - x0, y - 120) < 18 else 245)
    csv("presses.csv", "adc1,adc2,adc3,x_mm,y_mm,area_mm2,bridge_mV_per_V",
        [(900, 905, 910, 0, 0, 60, 0.2), (950, 955, 960, 5, -3, 80, 0.3)])


def scenes():
    n, size = 20, 100.0
    height = {(i, j): 2 * math.sin(0.3 * (i - n / 2) * size / n) * math.sin(0.3 * (j - n / 2) * size / n)
              for i in range(n + 1) for j in range(n + 1)}
    lines = [f"v {size * (i / n - 0.5):.6g} {size * (j / n - 0.5):.6g} {z:.6g}" for (i, j), z in height.items()]
    for i in range(n):
        for j in range(n):
            a, b, c, d = (1 + i * (n + 1) + j, 1 + (i + 1) * (n + 1) + j, 2 + (i + 1) * (n + 1) + j, 2 + i * (n + 1) + j)
            lines += [f"f {a} {b} {c}", f"f {a} {c} {d}"]
    write("bumpy.obj", "\n".join(lines) + "\n")


{"calibration": calibration, "sensing": sensing, "scenes": scenes}[sys.argv[1]]()
