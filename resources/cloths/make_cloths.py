#!/usr/bin/python3
"""Makes the tables of the simulated cloths (*.cloth beside this script) with cloth_solver.py: see there for the physics.

    make_cloths.py           every table
    make_cloths.py NAME…     these, e.g. frame_sphere8

A table holds, for places x × y (a quarter of the cloth; both signs of y where the finger is not symmetric) and for depths:
    force      N, area mm², centre of the contact mm beside the finger's tip, at two stretches. A stretch is named by the
               stiffness that it gives to a sphere of 8 mm pressed 3 mm deep in the middle ("reference stiffness", N/mm),
               because that is what the thesis measured (stretch angle to stiffness)
    shape      deflection per depth around the finger, mean of the two stretches (they differ by < 0.3 %), on a grid −1…1 of
               t, the same in x and y: distance from the finger = c·t + (D − c)·t³, D the distance from the finger to
               the edge on that side, c = min(NEAR, D)
"""
import argparse
import sys
from pathlib import Path

import numpy as np

from cloth_solver import HALF_X, HALF_Y, Cloth, Finger

DEPTHS = [0.5, 1.0, 2.0, 3.5, 5.5, 8.0]
NEAR = 10.0
SHAPE = np.linspace(-1.0, 1.0, 15)
MESH = {"sphere": dict(fine=0.35, reach=3.0), "capsule": dict(fine=0.35, reach=3.0), "disc": dict(fine=0.5)}
FINGERS = {"sphere8": Finger("sphere", 8.0), "disc7": Finger("disc", 7.0), "capsule8": Finger("capsule", 8.0)}
# x and y to where a sphere of 8 mm goes down to 8 mm without touching the frame; stretches beyond those that 0° and 120° of the motors need (0.46 and 0.76 N/mm); y_edge: where the morphed grid ends
CLOTHS = {"frame": dict(stretches=(1.28, 1.45), x=[0, 15, 28, 37, 41.5], y=[0, 12, 21, 27], y_edge=HALF_Y),
          "rollers": dict(stretches=(1.58, 1.82), x=[0, 15, 28, 37, 41.5], y=[0, 9, 16, 22], y_edge=29.0)}
DISC = {"x": [0, 14, 24, 31, 35, 38], "y": {"frame": [0, 9, 15, 19, 23], "rollers": [0, 7, 12, 16, 18]}}  # its rim keeps off the edges
CAPSULE_FRONT = {"frame": [-19, -10], "rollers": [-22, -16, -9]}  # it rises towards −y: farther in front it lies on the frame
NAMES = ["frame_sphere8", "rollers_sphere8", "frame_disc7", "frame_capsule8", "rollers_disc7", "rollers_capsule8"]


def distances(t, room):
    near = min(NEAR, room)
    return near * t + (room - near) * t**3


def around(place, y_edge):
    """The points of the shape's grid about a finger at place."""
    def axis(at, edge):
        return np.array([at + np.sign(t) * distances(abs(t), edge - np.sign(t) * at) for t in SHAPE])
    x, y = np.meshgrid(axis(place[0], HALF_X), axis(place[1], y_edge), indexing="ij")
    return np.stack([x.ravel(), y.ravel()], 1)


def reference(edges, stretch):
    return Cloth(FINGERS["sphere8"], (0, 0), stretch, edges, **MESH["sphere"]).press(3.0).force / 3.0


def column(finger, place, stretch, edges, depths=DEPTHS, points=None):
    cloth = Cloth(finger, place, stretch, edges, **MESH[finger.shape])
    out = []
    for depth in depths:
        pressed = cloth.press(float(depth))
        if out and pressed.force <= out[-1][0][0]:
            raise RuntimeError(f"force falls to {pressed.force:g} N at {depth} mm, {place}: the finger touches the frame, or no equilibrium")
        shape = pressed.shape(points) / depth if points is not None else None
        out.append(([pressed.force, pressed.area, *(pressed.centroid - place)], shape))
    return out


def numbers(values, scale):
    return " ".join(str(int(v)) for v in np.rint(np.ravel(values) * scale)) + "\n"


def make(name, folder):
    edges, finger_name = name.split("_")
    cloth, finger = CLOTHS[edges], FINGERS[finger_name]
    xs, ys = (DISC["x"], DISC["y"][edges]) if finger.shape == "disc" else (cloth["x"], cloth["y"])
    if finger.shape == "capsule":
        ys = CAPSULE_FRONT[edges] + ys
    kinds, shapes = [], []
    for x in xs:
        for y in ys:
            points = around((x, y), cloth["y_edge"])
            both = [column(finger, (x, y), s, edges, points=points) for s in cloth["stretches"]]
            kinds.append([[c[0] for c in b] for b in both])
            shapes.append([0.5 * (a[1] + b[1]) for a, b in zip(*both)])
            print(name, x, y, file=sys.stderr, flush=True)
    kinds = np.array(kinds)  # place, stretch, depth, quantity
    with open(folder / f"{name}.cloth", "w") as out:
        out.write(f"fyd-cloth 1\nmade by resources/cloths/make_cloths.py; do not edit\n")
        out.write(f"finger {finger.shape} {finger.radius:g}\nhalf {HALF_X:g} {cloth['y_edge']:g}\nnear {NEAR:g}\n")
        out.write("reference " + " ".join(f"{reference(edges, s):.5f}" for s in cloth["stretches"]) + "\n")
        out.write("x " + " ".join(f"{x:g}" for x in xs) + "\ny " + " ".join(f"{y:g}" for y in ys) + "\n")
        out.write("depth " + " ".join(f"{d:g}" for d in DEPTHS) + f"\nshape {len(SHAPE)}\n")
        for place, shape in zip(kinds, shapes):
            for q, scale in enumerate((1e4, 1e2, 1e3, 1e3)):  # force, area, centre x and y
                out.write(numbers(place[:, :, q], scale))
            out.write(numbers(shape, 1e4))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--folder", type=Path, default=Path(__file__).parent)
    arguments = parser.parse_args()
    for name in arguments.names or NAMES:
        if name not in NAMES:
            parser.error(f"no table is called {name}: {', '.join(NAMES)}")
        make(name, arguments.folder)


if __name__ == "__main__":
    main()
