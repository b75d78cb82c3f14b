#!/usr/bin/python3
"""Trains the perceptron of the learned forecast (core/teleop/prediction/learned_forecast.h) on recorded finger strokes.

  train_strokes.py FOLDER [--leave-out PERSON] [--out FILE] [--epochs N] [--seed I]

FOLDER holds {fitts,paint,write}_p1…4.csv: t_s,x_mm,y_mm, a row of NaN is a lifted finger. With --leave-out the person
takes no part, and the mean error on that person is printed beside holding still: where at least 11 rows of the stroke
are there, at fixed horizons. The file is written for the predictor; strokes.perceptron is that of all people.
"""
import argparse
import csv
import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
import numpy as np

KINDS, PEOPLE = ("fitts", "paint", "write"), (1, 2, 3, 4)
STEP_s, LAGS, KNOTS, HIDDEN = 1 / 60, 10, 12, 64
LEAST_SCALE_mm = 0.05
SCORED = (1, 3, 5)  # knots at 33, 67 and 100 ms


def strokes(path):
    with open(path, encoding="ascii") as file:
        rows = list(csv.reader(file))[1:]
    values = np.array([[float(x) for x in row] for row in rows])
    out, begin = [], 0
    gaps = [*np.flatnonzero(np.isnan(values).any(axis=1)), len(values)]
    for gap in gaps:
        if gap - begin > 1:
            out.append(values[begin:gap])
        begin = gap + 1
    return out


def at(stroke, time_s):
    return np.stack([np.interp(time_s, stroke[:, 0], stroke[:, axis]) for axis in (1, 2)], axis=-1)


def samples(stroke):
    """Inputs and targets at each row, in the frame of the motion; as core/teleop/prediction/learned_forecast.cpp makes them."""
    now = stroke[:, 0]
    lagged = at(stroke, now[:, None] - STEP_s * np.arange(LAGS + 1))
    steps = lagged[:, :-1] - lagged[:, 1:]
    scale = np.sqrt((steps ** 2).sum(axis=(1, 2)) / LAGS) + LEAST_SCALE_mm
    ahead = steps[:, 0:3].sum(axis=1)
    length = np.linalg.norm(ahead, axis=1)
    first = np.where(length[:, None] > 1e-9, ahead / np.maximum(length, 1e-9)[:, None], [1.0, 0.0])
    second = np.stack([-first[:, 1], first[:, 0]], axis=1)
    turn = np.einsum("nki,ni->nk", steps, second)
    second = second * np.where(turn[:, 3:].sum(axis=1) < 0, -1.0, 1.0)[:, None]
    frame = np.stack([first, second], axis=1)
    inputs = np.einsum("nki,nji->nkj", steps, frame) / scale[:, None, None]
    age = np.minimum(now - now[0], LAGS * STEP_s) / (LAGS * STEP_s)
    inputs = np.concatenate([inputs.reshape(len(now), -1), np.log(scale)[:, None], age[:, None]], axis=1)
    then = now[:, None] + STEP_s * np.arange(1, KNOTS + 1)
    targets = at(stroke, then) - stroke[:, None, 1:3]
    targets[then > now[-1] + 1e-9] = np.nan
    return inputs, np.einsum("nki,nji->nkj", targets, frame), scale, np.arange(len(now))


def load(folder, people):
    inputs, targets, scales, rows, kinds = [], [], [], [], []
    for k, kind in enumerate(KINDS):
        for person in people:
            for stroke in strokes(f"{folder}/{kind}_p{person}.csv"):
                i, t, s, r = samples(stroke)
                inputs.append(i), targets.append(t), scales.append(s), rows.append(r), kinds.append(np.full(len(i), k))
    return (np.concatenate(inputs).astype(np.float32), np.concatenate(targets).astype(np.float32),
            np.concatenate(scales).astype(np.float32), np.concatenate(rows), np.concatenate(kinds))


class Perceptron:
    """out = scale · (W3·relu(W2·relu(W1·in + b1) + b2) + L·in + b3)"""
    def __init__(self, inputs, random):
        def layer(rows, columns, gain):
            return (random.standard_normal((rows, columns)) * gain / np.sqrt(rows)).astype(np.float32)
        self.p = [layer(inputs, HIDDEN, 1.4), np.zeros(HIDDEN, np.float32), layer(HIDDEN, HIDDEN, 1.4),
                  np.zeros(HIDDEN, np.float32), layer(HIDDEN, 2 * KNOTS, 0.1), np.zeros(2 * KNOTS, np.float32),
                  np.zeros((inputs, 2 * KNOTS), np.float32)]

    def forward(self, x):
        w1, b1, w2, b2, w3, b3, skip = self.p
        h1 = np.maximum(x @ w1 + b1, 0)
        h2 = np.maximum(h1 @ w2 + b2, 0)
        return h1, h2, h2 @ w3 + b3 + x @ skip

    def gradients(self, x, h1, h2, d):
        w1, b1, w2, b2, w3, b3, skip = self.p
        d2 = (d @ w3.T) * (h2 > 0)
        d1 = (d2 @ w2.T) * (h1 > 0)
        return [x.T @ d1, d1.sum(0), h1.T @ d2, d2.sum(0), h2.T @ d, d.sum(0), x.T @ d]


def train(data, epochs, seed, batch=256, rate=2e-3, decay=1e-3):
    inputs, targets, scales, _, kinds = data
    random = np.random.default_rng(seed)
    known = ~np.isnan(targets[:, :, 0])
    usual = np.ones((len(KINDS), KNOTS), np.float32)  # of holding still: what an error is measured by
    for k in range(len(KINDS)):
        for knot in range(KNOTS):
            moved = targets[(kinds == k) & known[:, knot], knot]
            if len(moved):
                usual[k, knot] = np.linalg.norm(moved, axis=1).mean()
    share = np.array([1 / np.count_nonzero(kinds == k) if (kinds == k).any() else 0 for k in range(len(KINDS))])
    weight = (share[kinds] * len(kinds) / len(KINDS))[:, None] / usual[kinds] * known
    weight = np.minimum(weight, np.quantile(weight[weight > 0], 0.999)).astype(np.float32)
    filled = np.nan_to_num(targets)
    net = Perceptron(inputs.shape[1], random)
    first, second = [np.zeros_like(p) for p in net.p], [np.zeros_like(p) for p in net.p]
    average, count, step = [np.zeros_like(p, dtype=np.float64) for p in net.p], 0, 0
    total = epochs * (len(inputs) // batch)
    for epoch in range(epochs):
        order = random.permutation(len(inputs))
        for b in range(len(inputs) // batch):
            pick = order[b * batch:(b + 1) * batch]
            x, scale = inputs[pick], scales[pick][:, None, None]
            h1, h2, out = net.forward(x)
            error = out.reshape(-1, KNOTS, 2) * scale - filled[pick]
            length = np.sqrt((error ** 2).sum(axis=2, keepdims=True) + 1e-4)
            d = (error / length * weight[pick][:, :, None] * scale).reshape(len(pick), -1) / len(pick)
            step += 1
            now = rate * 0.5 * (1 + np.cos(np.pi * step / total)) + 1e-5
            for i, g in enumerate(net.gradients(x, h1, h2, d)):
                first[i] = 0.9 * first[i] + 0.1 * g
                second[i] = 0.999 * second[i] + 0.001 * g * g
                move = first[i] / (1 - 0.9 ** step) / (np.sqrt(second[i] / (1 - 0.999 ** step)) + 1e-8)
                net.p[i] -= (now * (move + decay * 10 * net.p[i])).astype(np.float32)
            if step > 0.8 * total:
                count += 1
                for i, p in enumerate(net.p):
                    average[i] += p
    net.p = [(a / count).astype(np.float32) for a in average]
    return net


def report(net, data):
    inputs, targets, scales, rows, kinds = data
    out = net.forward(inputs)[2].reshape(-1, KNOTS, 2) * scales[:, None, None]
    for k, kind in enumerate(KINDS):
        line = kind
        for knot in SCORED:
            use = (kinds == k) & ~np.isnan(targets[:, knot, 0]) & (rows >= 10)
            hold = np.linalg.norm(targets[use, knot], axis=1).mean()
            mine = np.linalg.norm(out[use, knot] - targets[use, knot], axis=1).mean()
            line += f"   {1e3 * STEP_s * (knot + 1):.0f} ms {mine:.3f} mm of {hold:.3f} ({mine / hold:.3f})"
        print(line, flush=True)


def write(net, path):
    with open(path, "w", encoding="ascii") as file:
        file.write("# made by train_strokes.py: inputs, hidden units, outputs; then W1 b1 W2 b2 W3 b3 and the direct weights\n")
        file.write(f"{net.p[0].shape[0]} {HIDDEN} {2 * KNOTS}\n")
        for p in net.p:
            for row in np.atleast_2d(p):
                file.write(" ".join(f"{x:.5g}" for x in row) + "\n")


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("folder")
    parser.add_argument("--leave-out", type=int, choices=PEOPLE)
    parser.add_argument("--out")
    parser.add_argument("--epochs", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    trained = train(load(given.folder, [p for p in PEOPLE if p != given.leave_out]), given.epochs, given.seed)
    if given.leave_out:
        report(trained, load(given.folder, [given.leave_out]))
    if given.out:
        write(trained, given.out)
