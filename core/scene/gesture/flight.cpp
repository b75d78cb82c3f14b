#include "core/scene/gesture/flight.h"

#include <algorithm>

namespace fyd::scene {
namespace {

constexpr double kLongestPiece_s = 0.002;
constexpr double kShareOfHalving = 0.05;

}  // namespace

FlightPiece flightPiece(const Vec3& x, const Vec3& v, double gravity, double drag, double longest_s) {
  const Vec3 down{0.0, 0.0, -gravity};
  if (!(drag > 0.0)) return {x, v, 0.5 * down, {}, longest_s};
  const auto acceleration = [&](const Vec3& speed) { return down - (drag * length(speed)) * speed; };
  const double speed = length(v);
  const double h = std::min({longest_s, kLongestPiece_s, kShareOfHalving / (drag * speed)});  // 1/0: no limit
  const Vec3 a1 = acceleration(v);
  const Vec3 v2 = v + (0.5 * h) * a1, a2 = acceleration(v2);
  const Vec3 v3 = v + (0.5 * h) * a2, a3 = acceleration(v3);
  const Vec3 v4 = v + h * a3, a4 = acceleration(v4);
  const Vec3 moved = (h / 6.0) * (v + 2.0 * v2 + 2.0 * v3 + v4);
  const Vec3 to = v + (h / 6.0) * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
  // The cubic through both ends with both speeds.
  const double by = 1.0 / h;
  return {x, v, by * (by * (3.0 * moved) - 2.0 * v - to), (by * by) * (v + to - (2.0 * by) * moved), h};
}

}  // namespace fyd::scene
