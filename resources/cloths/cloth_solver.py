"""The cloth of the touchpad, pressed by a rigid finger: finite strain, finite elements, Newton's method.

It shares no formula with the estimator of the program (core/sensing): it is the truth the estimator is tested against.

Lengths in mm, forces in N. x right, y back, the cloth lies in z = 0, depth and deflection count downwards (pressing is
positive). The frame is 2·HALF_X × 2·HALF_Y.

    cloth      a rest sheet smaller than the frame, stretched into it: the pre-stretch is geometry. St. Venant–Kirchhoff
               energy of the Green strain in the rest plane, plane stress, per rest area:
                 W = ½ (C11 E11² + 2 C12 E11 E22 + C22 E22² + 4 G E12²)
               modulus = E·h in N/mm; `ratio` makes it orthotropic: Ex = E √ratio, Ey = E / √ratio.
    edges      "frame": four edges held. "rollers": x = ±HALF_X held at the rest width, the other two free and drawn in.
               A cloth bears no compression: where the smaller principal stress would be negative the energy is relaxed
               (tension field); only for ratio 1. A part in 10⁴ of the stiffness is left, so that slack cloth stays in place.
    finger     sphere or tilted capsule: all the points nearer than `radius` to a point or a segment. Contact is a stiff
               penalty at the nodes; it slides without friction or sticks where it first touched.
               Flat disc: the cloth under it goes down with it, so there is no contact to look for.
"""
from dataclasses import dataclass

import numpy as np
from scipy.interpolate import RegularGridInterpolator
from scipy.sparse import csc_matrix
from scipy.sparse.linalg import splu

HALF_X, HALF_Y = 50.0, 35.0
MODULUS = 0.5  # E·h, N/mm
POISSON = 0.3
SENSORS = np.array([(-22.0, -3.0), (0.0, 27.0), (22.0, -3.0)])
PENALTY = 50.0  # N/mm³: a pressure of 0.1 N/mm² sinks in by 2 µm
WHOLE_STEPS = 10  # of Newton's method, before it gives up or searches along each step
SLACK = 1e-4  # share of the stiffness that wrinkled cloth keeps


@dataclass(frozen=True)
class Finger:
    """shape "sphere" (radius), "capsule" (radius; length of the axis, tilt of the axis from the cloth, both along −y:
    the tip is deepest and the finger rises towards the user), "disc" (flat, radius; what lies under it sticks to it)."""

    shape: str = "sphere"
    radius: float = 8.0
    length: float = 30.0
    tilt_deg: float = 30.0

    def gap(self, p, place, depth):
        """p: n × 3, z upwards. @return gap (n), its gradient (n × 3), its second derivative (n × 3 × 3)"""
        r = self.radius
        d = p - np.array([place[0], place[1], -depth + r])
        axis = None
        if self.shape == "capsule":
            t = np.deg2rad(self.tilt_deg)
            axis = np.array([0.0, -np.cos(t), np.sin(t)])
            along = np.clip(d @ axis, 0.0, self.length)
            side = (along > 0) & (along < self.length)
            d = d - along[:, None] * axis
        length = np.sqrt((d * d).sum(1))
        n = d / np.maximum(length, 1e-12)[:, None]
        h = np.eye(3)[None] - n[:, :, None] * n[:, None, :]
        if axis is not None:
            h = h - side[:, None, None] * (axis[:, None] * axis[None, :])[None]
        return length - r, n, h / np.maximum(length, 1e-12)[:, None, None]


def graded(low, high, centre, fine, reach, coarse, growth):
    """Grid from low to high: steps of about `fine` within `reach` of centre, growing to `coarse`."""
    def outwards(distance):
        s, step = [0.0], fine
        while s[-1] < distance - 1e-9:
            if s[-1] >= reach:
                step = min(step * growth, coarse)
            s.append(s[-1] + step)
        return np.array(s) * (distance / s[-1]) if distance > 0 else np.array([0.0])
    left = centre - outwards(centre - low)[::-1]
    right = centre + outwards(high - centre)
    return np.concatenate([left[:-1], right])


@dataclass
class Pressed:
    depth: float
    force: float  # N, downwards
    area: float  # mm², of the contact, seen from straight below
    centroid: np.ndarray  # of the contact, mm
    energy: float  # N·mm, of the cloth, less that of the unpressed cloth
    deflection: np.ndarray  # at SENSORS, mm
    shape: object  # shape(points n×2) -> deflection in mm
    iterations: int
    boundary: np.ndarray  # Fourier radii of the contact's edge about the centroid (a0, a1, b1, a2, b2, …)
    nodes: np.ndarray  # n × 3, where the cloth is


class Cloth:
    def __init__(self, finger, place, stretch, edges="frame", ratio=1.0, sticking=False, fine=0.5, reach=None,
                 coarse=5.0, growth=1.35, modulus=MODULUS, poisson=POISSON):
        self.finger, self.place, self.edges, self.sticking = finger, np.asarray(place, float), edges, sticking
        sx, sy = np.broadcast_to(np.asarray(stretch, float), (2,))
        if edges == "rollers":
            if np.ndim(stretch) == 0:
                sy = 1.0
            if ratio != 1.0:
                raise ValueError("free edges need ratio 1 (the tension field is isotropic)")
        if reach is None:
            reach = finger.radius + 1.0 if finger.shape == "disc" else 0.5 * finger.radius
        self.gx = graded(-HALF_X, HALF_X, place[0], fine, reach, coarse, growth)
        self.gy = graded(-HALF_Y, HALF_Y, place[1], fine, reach, coarse, growth)
        nx, ny = len(self.gx), len(self.gy)
        x, y = np.meshgrid(self.gx, self.gy, indexing="ij")
        flat = np.stack([x.ravel(), y.ravel()], 1)
        border = (np.abs(np.abs(flat[:, 0]) - HALF_X) < 1e-9) | (np.abs(np.abs(flat[:, 1]) - HALF_Y) < 1e-9)
        if finger.shape == "disc":  # nodes onto the rim, or the disc's radius would be the grid's
            d = flat - self.place
            rho = np.hypot(d[:, 0], d[:, 1])
            near = (np.abs(rho - finger.radius) < 0.5 * fine) & ~border
            flat[near] = self.place + d[near] * (finger.radius / rho[near])[:, None]
        rest = flat / np.array([sx, sy])
        index = np.arange(nx * ny).reshape(nx, ny)
        self.quads = np.stack([index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]], -1).reshape(-1, 4)
        self.flat, self.rest = flat, rest
        self._elements()
        held = np.abs(np.abs(flat[:, 0]) - HALF_X) < 1e-9
        if edges == "frame":
            held |= np.abs(np.abs(flat[:, 1]) - HALF_Y) < 1e-9
        self.under = np.zeros(len(flat), bool)
        if finger.shape == "disc":
            self.under = ((flat - self.place) ** 2).sum(1) <= (finger.radius + 1e-9) ** 2
            held |= self.under
        self.free = np.flatnonzero(np.repeat(~held, 3))
        ex, ey, v = modulus * np.sqrt(ratio), modulus / np.sqrt(ratio), poisson
        self.modulus, self.poisson = modulus, poisson
        self.c = np.array([[ex, v * np.sqrt(ex * ey), 0], [v * np.sqrt(ex * ey), ey, 0],
                           [0, 0, 0.5 * (1 - v) * np.sqrt(ex * ey)]]) / (1 - v * v)
        self._pattern()
        self.nodes = np.column_stack([flat, np.zeros(len(flat))])
        self.anchor = np.full((len(flat), 3), np.nan)
        self.contact = False
        if edges == "rollers":  # the free edges draw in before anything presses
            self._newton(0.0, first=True)
        self.start = self._membrane(self.nodes, False)[0]
        self.last = None  # the depth and the nodes before the last ones
        self.depth, self.step = 0.0, 1.0

    def _elements(self):
        g = 1 / np.sqrt(3)
        corners = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
        points = g * corners
        dn = np.stack([np.stack([c[0] * (1 + p[1] * c[1]), c[1] * (1 + p[0] * c[0])]) / 4 for p in points for c in corners])
        dn = dn.reshape(4, 4, 2)
        n = np.array([[(1 + p[0] * c[0]) * (1 + p[1] * c[1]) / 4 for c in corners] for p in points])
        xe = self.rest[self.quads]
        jac = np.einsum("gai,eaj->egij", dn, xe)
        det = jac[..., 0, 0] * jac[..., 1, 1] - jac[..., 0, 1] * jac[..., 1, 0]
        assert det.min() > 0, "a cell of the mesh is turned inside out"
        inv = np.linalg.inv(jac)
        self.dn = np.einsum("egji,gai->egaj", inv, dn)  # ∂N/∂X
        self.weight = det
        xf = self.flat[self.quads]
        jf = np.einsum("gai,eaj->egij", dn, xf)
        df = jf[..., 0, 0] * jf[..., 1, 1] - jf[..., 0, 1] * jf[..., 1, 0]
        self.tributary = np.bincount(self.quads.ravel(), (df[:, :, None] * n[None]).sum(1).ravel(), len(self.flat))

    def _pattern(self):
        """Where the elements' entries go in the sparse matrix of the free unknowns."""
        total = 3 * len(self.flat)
        number = np.full(total, -1)
        number[self.free] = np.arange(len(self.free))
        dof = number[(3 * self.quads[:, :, None] + np.arange(3)).reshape(-1, 12)]
        rows, cols = np.repeat(dof, 12, 1).ravel(), np.tile(dof, (1, 12)).ravel()
        nodal = number[3 * np.arange(len(self.flat))[:, None] + np.arange(3)]
        rows = np.concatenate([rows, np.repeat(nodal, 3, 1).ravel()])
        cols = np.concatenate([cols, np.tile(nodal, (1, 3)).ravel()])
        self.keep = np.flatnonzero((rows >= 0) & (cols >= 0))
        m = len(self.free)
        keys = cols[self.keep].astype(np.int64) * m + rows[self.keep]
        unique, self.slot = np.unique(keys, return_inverse=True)
        self.indices = (unique % m).astype(np.int32)
        self.indptr = np.searchsorted(unique, np.arange(m + 1, dtype=np.int64) * m).astype(np.int32)

    def _stress(self, e):
        """e: (…, 3) = E11, E22, 2·E12. @return energy density, stress (…, 3), tangent (…, 3, 3) or the constant one"""
        s = e @ self.c
        w = 0.5 * (s * e).sum(-1)
        if self.edges == "frame":
            return w, s, self.c
        mean, half = 0.5 * (e[..., 0] + e[..., 1]), 0.5 * (e[..., 0] - e[..., 1])
        shear = 0.5 * e[..., 2]
        r = np.maximum(np.hypot(half, shear), 1e-12)
        e1, e2 = mean + r, mean - r
        wrinkled, slack = (e2 + self.poisson * e1 < 0), (e1 <= 0)
        tangent = np.broadcast_to(self.c, e.shape + (3,)).copy()
        if not wrinkled.any():
            return w, s, tangent
        k = np.flatnonzero(wrinkled.ravel())
        c2, s2 = (half / r).ravel()[k], (shear / r).ravel()[k]  # cos 2φ, sin 2φ of the first principal axis
        m = np.stack([0.5 * (1 + c2), 0.5 * (1 - c2), 0.5 * s2], -1)  # n⊗n, dual to (E11, E22, 2·E12)
        q = np.stack([-s2 / 2, s2 / 2, c2 / 2], -1)  # dual to the shear in the principal frame, E12'
        one = np.where(slack.ravel()[k], 0.0, e1.ravel()[k])
        gap = 2 * r.ravel()[k]
        soft = self.modulus * (1 - SLACK)
        w.ravel()[k] = soft * 0.5 * one**2 + SLACK * w.ravel()[k]
        flat_s = s.reshape(-1, 3)
        flat_s[k] = soft * one[:, None] * m + SLACK * flat_s[k]
        flat_t = tangent.reshape(-1, 3, 3)
        stiff = soft * (one > 0)
        flat_t[k] = (stiff[:, None, None] * m[:, :, None] * m[:, None, :]
                     + (soft * one / gap * 2)[:, None, None] * q[:, :, None] * q[:, None, :] + SLACK * flat_t[k])
        return w, flat_s.reshape(s.shape), flat_t.reshape(tangent.shape)

    def _membrane(self, nodes, want_matrix):
        f = np.einsum("egai,eac->egci", self.dn, nodes[self.quads])
        e = np.stack([0.5 * ((f[..., 0] ** 2).sum(-1) - 1), 0.5 * ((f[..., 1] ** 2).sum(-1) - 1),
                      (f[..., 0] * f[..., 1]).sum(-1)], -1)
        w, s, tangent = self._stress(e)
        energy = (w * self.weight).sum()
        s = s * self.weight[..., None]
        second = np.empty(s.shape[:-1] + (2, 2))
        second[..., 0, 0], second[..., 1, 1] = s[..., 0], s[..., 1]
        second[..., 0, 1] = second[..., 1, 0] = s[..., 2]
        ds = self.dn @ second  # e g a i
        force = np.einsum("egai,egci->eac", ds, f)
        gradient = np.bincount((3 * self.quads[:, :, None] + np.arange(3)).ravel(), force.ravel(), 3 * len(nodes))
        if not want_matrix:
            return energy, gradient, None
        ne = len(self.quads)
        b = np.empty((ne, 4, 3, 4, 3))
        n1, n2 = self.dn[..., 0], self.dn[..., 1]
        b[:, :, 0] = n1[..., None] * f[..., None, :, 0]
        b[:, :, 1] = n2[..., None] * f[..., None, :, 1]
        b[:, :, 2] = n1[..., None] * f[..., None, :, 1] + n2[..., None] * f[..., None, :, 0]
        b = b.reshape(ne, 4, 3, 12)
        db = (tangent * self.weight[..., None, None]) @ b if tangent.ndim > 2 else (
            self.weight[..., None, None] * (tangent @ b))
        k = b.reshape(ne, 12, 12).transpose(0, 2, 1) @ db.reshape(ne, 12, 12)
        geometric = (ds.transpose(0, 2, 1, 3).reshape(ne, 4, 8) @
                     self.dn.transpose(0, 1, 3, 2).reshape(ne, 8, 4))
        k5 = k.reshape(ne, 4, 3, 4, 3)
        for c in range(3):
            k5[:, :, c, :, c] += geometric
        return energy, gradient, k

    def _touch(self, nodes, depth):
        """Penalty energy, its gradient per node and second derivative per node."""
        if self.finger.shape == "disc":
            return 0.0, np.zeros_like(nodes), np.zeros((len(nodes), 3, 3)), self.under
        g, n, h = self.finger.gap(nodes, self.place, depth)
        inside = g < 0
        a = PENALTY * self.tributary * inside
        energy = 0.5 * (a * g * g).sum()
        gradient = (a * g)[:, None] * n
        curving = np.maximum(g, -0.01)  # deeper only on the way to the solution, where the full term would upset Newton
        second = a[:, None, None] * (n[:, :, None] * n[:, None, :] + curving[:, None, None] * h)
        if self.sticking:
            stuck = inside & ~np.isnan(self.anchor[:, 0])
            d = np.where(stuck[:, None], nodes - self.anchor - np.array([0, 0, -depth]), 0.0)
            d[:, 2] = 0.0  # in the plane: the normal part is the penalty's
            t = 0.1 * PENALTY * self.tributary * stuck
            energy += 0.5 * (t * (d * d).sum(1)).sum()
            gradient += t[:, None] * d
            second[:, 0, 0] += t
            second[:, 1, 1] += t
        return energy, gradient, second, inside

    def _newton(self, depth, first=False, patient=True):
        """Whole steps first: the set of touching nodes settles fastest so. Then, if `patient`, steps that lower the
        energy."""
        limit = 80 if patient else WHOLE_STEPS
        nodes = self.nodes
        tolerance = 1e-8
        for iteration in range(1, limit + 1):
            energy, gradient, k = self._membrane(nodes, True)
            second = np.zeros((len(nodes), 3, 3))
            if not first:
                e, gr, second, _ = self._touch(nodes, depth)
                energy, gradient = energy + e, gradient + gr.ravel()
            residual = gradient[self.free]
            size = np.abs(residual).max()
            if size < tolerance:
                break
            data = np.concatenate([k.ravel(), second.ravel()])[self.keep]
            matrix = csc_matrix((np.bincount(self.slot, data, len(self.indices)), self.indices, self.indptr),
                                shape=(len(self.free),) * 2)
            step = -splu(matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0,
                         options=dict(SymmetricMode=True)).solve(residual)
            slope = residual @ step
            if slope > 0:
                step, slope = -step, -slope
            t = min(1.0, 4.0 / np.abs(step).max())
            if iteration <= WHOLE_STEPS:
                nodes = nodes.ravel().copy()
                nodes[self.free] += t * step
                nodes = nodes.reshape(-1, 3)
                if np.abs(t * step).max() < 1e-10:
                    break
                continue
            while True:
                trial = nodes.ravel().copy()
                trial[self.free] += t * step
                trial = trial.reshape(-1, 3)
                e = self._membrane(trial, False)[0] + (0.0 if first else self._touch(trial, depth)[0])
                if e <= energy + 1e-4 * t * slope + 1e-12 * abs(energy) or t < 1e-4:
                    break
                t *= 0.5
            nodes = trial
            if np.abs(t * step).max() < 1e-10:
                break
        else:
            raise RuntimeError(f"no equilibrium after {limit} iterations: depth {depth} mm at {self.place}, residual {size:g} N")
        self.nodes = nodes
        return iteration

    def press(self, depth):
        """Presses on, or lets go, from where the finger is, in steps of at most 1 mm, shorter where Newton needs it."""
        iterations = 0
        while True:
            at, before = self.depth, self.nodes
            remaining = depth - at
            to = depth if abs(remaining) <= 1.001 * self.step else at + np.sign(remaining) * self.step
            if self.last is not None and to > at > self.last[0]:
                self.nodes = before + (before - self.last[1]) * (to - at) / (at - self.last[0])
            self.nodes = self.nodes.copy()
            self.nodes[self.under, 2] = -to
            try:
                taken = self._newton(to, patient=self.step < 0.2)
            except RuntimeError:
                if self.step < 0.02:
                    raise
                iterations += WHOLE_STEPS
                self.nodes, self.step = before, 0.5 * min(self.step, abs(remaining))
                continue
            iterations += taken
            if taken <= 6:
                self.step = min(1.0, 1.5 * self.step)
            self.last, self.depth = (at, before), to
            if self.sticking:
                inside = self._touch(self.nodes, to)[3]
                self.anchor[~inside] = np.nan
                new = inside & np.isnan(self.anchor[:, 0])
                self.anchor[new] = self.nodes[new]
            if to == depth:
                return self._result(iterations)

    def shape(self, points):
        """Deflection in mm at points (n × 2) of the frame's plane: the cloth moves sideways too, so its node is looked for."""
        grid = self.nodes.reshape(len(self.gx), len(self.gy), 3)
        at = RegularGridInterpolator((self.gx, self.gy), grid, bounds_error=False, fill_value=None)
        points = np.atleast_2d(np.asarray(points, float))
        q = points.copy()
        for _ in range(30):
            q += points - at(q)[:, :2]
            q = np.clip(q, (-HALF_X, -HALF_Y), (HALF_X, HALF_Y))
        return -at(q)[:, 2]

    def _result(self, iterations):
        energy, gradient, _ = self._membrane(self.nodes, False)
        energy -= self.start
        _, push, _, inside = self._touch(self.nodes, self.depth)
        if self.finger.shape == "disc":
            push = -gradient.reshape(-1, 3) * self.under[:, None]
        force = abs(push[:, 2].sum())
        area, centroid, boundary = self._contact(inside)
        return Pressed(self.depth, force, area, centroid, energy, self.shape(SENSORS), self.shape, iterations, boundary,
                       self.nodes.copy())

    def _contact(self, inside):
        """The contact's edge between the nodes: outside it the gap grows as the square of the distance, so √gap is
        linear in it; r(θ) is fitted as a Fourier sum."""
        if self.finger.shape == "disc":
            r = self.finger.radius
            return np.pi * r * r, self.place.copy(), np.array([r])
        if inside.sum() < 3:
            return 0.0, self.place.copy(), np.array([0.0])
        p = self.nodes[:, :2]
        weight = self.tributary * inside
        centre = (p * weight[:, None]).sum(0) / weight.sum()
        rough = np.sqrt(weight.sum() / np.pi)
        orders = 6 if self.finger.shape == "capsule" else 3
        for _ in range(3):
            d = p - centre
            rho, theta = np.hypot(d[:, 0], d[:, 1]), np.arctan2(d[:, 1], d[:, 0])
            g = self.finger.gap(self.nodes, self.place, self.depth)[0]
            band = (g > 0) & (np.sqrt(np.maximum(g, 0) * self.finger.radius) < max(1.2, 0.35 * rough)) & (
                np.abs(p[:, 0]) < HALF_X - 0.1) & (np.abs(p[:, 1]) < HALF_Y - 0.1)
            if band.sum() < 8 * orders:
                return weight.sum(), centre, np.array([rough])
            root, t, r = np.sqrt(g[band]), theta[band], rho[band]
            basis = np.stack([np.ones_like(t)] + [f(k * t) for k in range(1, orders + 1) for f in (np.cos, np.sin)], 1)
            slope = basis[:, :5] * r[:, None]
            curve = root**2 * 0 + 1  # equal weights
            solution = np.linalg.lstsq(np.column_stack([slope, -basis]) * curve[:, None], root * curve, rcond=None)[0]
            angle = np.linspace(-np.pi, np.pi, 720, endpoint=False)
            b = np.stack([np.ones_like(angle)] + [f(k * angle) for k in range(1, orders + 1) for f in (np.cos, np.sin)], 1)
            edge = np.maximum((b @ solution[5:]) / (b[:, :5] @ solution[:5]), 0.0)
            width = 2 * np.pi / len(angle)
            area = 0.5 * (edge**2).sum() * width
            shift = np.array([(edge**3 * np.cos(angle)).sum(), (edge**3 * np.sin(angle)).sum()]) * width / 3 / area
            centre = centre + shift
            if np.abs(shift).max() < 1e-3:
                break
        boundary = np.concatenate([[edge.mean()], *([2 * (edge * np.cos(k * angle)).mean(), 2 * (edge * np.sin(k * angle)).mean()]
                                                    for k in range(1, orders + 1))])
        return area, centre, boundary


def solve(finger=Finger(), place=(0.0, 0.0), depth=3.0, stretch=1.310, edges="frame", ratio=1.0, **options):
    """One depth or a rising list of depths. @return Pressed, or a list of them"""
    cloth = Cloth(finger, place, stretch, edges, ratio, **options)
    if np.ndim(depth) == 0:
        return cloth.press(float(depth))
    return [cloth.press(float(d)) for d in depth]
