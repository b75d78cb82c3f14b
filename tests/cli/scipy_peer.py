"""An independent program for the tests of the fits: numpy and scipy on the same samples, answers as JSON.

  scipy_peer.py load-cell FILE.csv                 line by scipy.stats.linregress, errors and held-out error by weight
  scipy_peer.py camera FILE.csv                    a line for each axis
  scipy_peer.py ir FILE.csv FORM COEFFICIENTS_JSON the curve evaluated at each row; polynomial refitted with the weights
  scipy_peer.py stiffness FILE.csv                 slopes of each angle with one offset for all
"""
import json
import sys

import numpy
import scipy.optimize
import scipy.stats


def read(path):
    table = numpy.genfromtxt(path, delimiter=",", names=True)
    return {name: numpy.atleast_1d(table[name]) for name in table.dtype.names}


def line(x, y):
    fit = scipy.stats.linregress(x, y)
    return [fit.slope, fit.intercept, fit.stderr, fit.intercept_stderr]


def load_cell(samples):
    x, y = samples["value"], samples["force_N"]
    slope, intercept, slope_error, intercept_error = line(x, y)
    held_out = []
    for weight in numpy.unique(y):  # up to ten weights: one at a time
        rest = y != weight
        part = numpy.polyfit(x[rest], y[rest], 1)
        held_out.extend(y[~rest] - numpy.polyval(part, x[~rest]))
    residual = y - slope * x - intercept
    return {
        "coefficients": [slope, intercept],
        "standard_errors": [slope_error, intercept_error],
        "rmse": float(numpy.sqrt(numpy.mean(residual**2))),
        "max_residual": float(numpy.max(numpy.abs(residual))),
        "held_out_rmse": float(numpy.sqrt(numpy.mean(numpy.square(held_out)))),
    }


def camera(samples):
    x = line(samples["x_px"], samples["x_mm"])
    y = line(samples["y_px"], samples["y_mm"])
    return {"coefficients": [x[0], y[0], x[1], y[1]], "standard_errors": [x[2], y[2], x[3], y[3]]}


def stiffness(samples):
    angles = numpy.unique(samples["angle_deg"])
    design = numpy.zeros((len(samples["force_N"]), len(angles) + 1))
    for column, angle in enumerate(angles):
        rows = samples["angle_deg"] == angle
        design[rows, column] = samples["indentation_mm"][rows]
    design[:, -1] = 1
    found, _, _, _ = numpy.linalg.lstsq(design, samples["force_N"], rcond=None)
    freedom = design.shape[0] - design.shape[1]
    sigma2 = numpy.sum((samples["force_N"] - design @ found) ** 2) / freedom
    errors = numpy.sqrt(numpy.diag(sigma2 * numpy.linalg.inv(design.T @ design)))
    return {"slopes": found[:-1].tolist(), "offset": found[-1], "errors": errors.tolist(),
            "t": scipy.stats.t.ppf(0.975, freedom)}


def infrared(samples, form, coefficients):
    volts = 3.3 * samples["adc"] / 4096
    distance = samples["distance_mm"]
    printed = numpy.polynomial.Polynomial([790.712, -1885.623, 2208.604, -1338.297, 399.54, -46.327])
    inside = numpy.round(numpy.clip(samples["adc"], 524, 3408))
    slope = numpy.abs(printed.deriv()(3.3 * inside / 4096))
    root_weight = 1 / numpy.sqrt(0.5**2 + (slope * 0.010) ** 2)

    def inverse(parameters):
        return parameters[0] / (volts + parameters[1]) + parameters[2]

    if form == "inverse":
        found = scipy.optimize.least_squares(lambda p: (inverse(p) - distance) * root_weight, [120, 0.05, 0],
                                             x_scale=[100, 0.1, 1], xtol=1e-14, ftol=1e-14, gtol=1e-14).x
        predicted = inverse(coefficients)
        refitted = inverse(found)
    else:
        degree = len(coefficients) - 1
        fit = numpy.polynomial.Polynomial.fit(volts, distance, degree, w=root_weight)
        predicted = numpy.polynomial.Polynomial(coefficients)(volts)
        refitted = fit(volts)
    return {"predicted": predicted.tolist(), "refitted": refitted.tolist()}


def main(arguments):
    samples = read(arguments[2])
    if arguments[1] == "ir":
        answer = infrared(samples, arguments[3], json.loads(arguments[4]))
    else:
        answer = {"load-cell": load_cell, "camera": camera, "stiffness": stiffness}[arguments[1]](samples)
    print(json.dumps(answer))


if __name__ == "__main__":
    main(sys.argv)
