// A ball's flight in pieces, each a polynomial of time, and the first time at which a distance vanishes.
#pragma once

#include <cmath>
#include <optional>

#include "core/scene/mesh/vector.h"

namespace fyd::scene {

/// x(t) = c0 + c1·t + c2·t² + c3·t³, 0 ≤ t ≤ length_s; mm.
struct FlightPiece {
  Vec3 c0, c1, c2, c3;
  double length_s = 0.0;

  [[nodiscard]] Vec3 position(double t) const { return c0 + t * (c1 + t * (c2 + t * c3)); }
  [[nodiscard]] Vec3 velocity(double t) const { return c1 + t * (2.0 * c2 + (3.0 * t) * c3); }
  /// The largest acceleration, mm/s²: it changes linearly, so it is largest at one end.
  [[nodiscard]] double mostAcceleration() const {
    return 2.0 * std::max(length(c2), length(c2 + (3.0 * length_s) * c3));
  }
};

/// The next piece of a flight; its length is at most `longest_s`.
/// @param drag_per_mm deceleration over the speed squared. 0: the parabola; else pieces of the classic Runge-Kutta
///        method, of at most 2 ms and a twentieth of the time in which drag halves the speed
[[nodiscard]] FlightPiece flightPiece(const Vec3& position_mm, const Vec3& velocity_mm_per_s, double gravity_mm_per_s2,
                                      double drag_per_mm, double longest_s);

struct Gap {
  double mm = 0.0, rate_mm_per_s = 0.0;
};

/// The first time within 0 … until_s at which `gap(t)`, of two things whose acceleration towards each other is at most
/// `most_mm_per_s2`, is no more than `near_mm` and still shrinks.
template <class GapAt>
[[nodiscard]] std::optional<double> firstMeeting(const GapAt& gap, double until_s, double most_mm_per_s2,
                                                 double near_mm) {
  constexpr double kLeast = 1e-3;   // of until_s: the least step while the two separate from contact
  constexpr int kMostSteps = 2000;  // grazing for a long time takes a few hundred
  double t = 0.0;
  for (int i = 0; i < kMostSteps; ++i) {
    const Gap now = gap(t);
    if (now.mm <= near_mm && now.rate_mm_per_s < 0.0) return t;
    const double mm = std::max(0.0, now.mm), rate = now.rate_mm_per_s;
    // They cannot meet before mm + rate·s − most·s²/2 = 0; of the root's two forms the one without cancellation.
    const double root = std::sqrt(rate * rate + 2.0 * most_mm_per_s2 * mm);
    double safe = until_s;
    if (rate < 0.0) {
      safe = 2.0 * mm / (root - rate);
    } else if (most_mm_per_s2 > 0.0) {
      safe = (rate + root) / most_mm_per_s2;
    }
    if (now.mm <= near_mm) safe = std::max(safe, kLeast * until_s);
    if (!(t + safe < until_s)) {
      const Gap last = gap(until_s);
      if (last.mm <= near_mm && last.rate_mm_per_s < 0.0) return until_s;
      return std::nullopt;
    }
    t += safe;
  }
  return t;
}

}  // namespace fyd::scene
