#include "core/sim/finger_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fyd::sim {
namespace {

struct Pose {
  double time_s, x_mm, y_mm, indentation_mm;
};

// Held presses, a pulsed press, strokes to and fro, a deep press: t_s, x_mm, y_mm, indentation_mm (0: lifted).
constexpr std::array<Pose, 25> kDemonstration = {{
    {0.0, -25, 10, 0},  {0.5, -25, 10, 0},  {0.9, -25, 10, 5}, {1.6, -25, 10, 5}, {2.0, -25, 10, 0},
    {2.4, 20, -12, 0},  {2.8, 20, -12, 6},  {3.4, 20, -12, 6}, {3.7, 20, -12, 3}, {4.2, 20, -12, 6},
    {4.6, 20, -12, 0},  {5.0, -35, 5, 0},   {5.4, -35, 5, 4},  {7.4, 35, 5, 4},   {9.0, -30, -15, 4.5},
    {10.2, 10, -20, 3}, {10.6, 10, -20, 0}, {11.0, 0, 0, 0},   {11.5, 0, 0, 2},   {12.1, 0, 0, 7},
    {13.0, 0, 0, 7},    {13.5, 0, 0, 0},    {13.9, 30, 22, 0}, {14.3, 30, 22, 4}, {15.5, -10, 22, 4.5},
}};
constexpr double kDemonstrationEnd_s = 16.0;
constexpr double kDemonstrationStep_s = 0.01;

/// Negative: above the cloth; NaN: not known.
double depthOf_mm(const FingerPath::Knot& knot) {
  return knot.state.lifted ? -knot.above_mm : knot.state.indentation_mm;
}

/// From 0 to 1 with zero speed and acceleration at both ends, as a hand moves (minimum jerk).
double minimumJerk(double u) { return u * u * u * (10.0 + u * (6.0 * u - 15.0)); }

FingerState pressed(double x_mm, double y_mm, double indentation_mm) {
  const bool lifted = !(indentation_mm > 0.0);
  return {.x_mm = x_mm, .y_mm = y_mm, .indentation_mm = lifted ? 0.0 : indentation_mm, .lifted = lifted};
}

}  // namespace

FingerPath FingerPath::demonstration() {
  FingerPath path;
  std::size_t segment = 0;
  for (int i = 0; i * kDemonstrationStep_s < kDemonstrationEnd_s; ++i) {
    const double t = i * kDemonstrationStep_s;
    while (segment + 2 < kDemonstration.size() && kDemonstration[segment + 1].time_s <= t) ++segment;
    const Pose& a = kDemonstration[segment];
    const Pose& b = kDemonstration[segment + 1];
    const double share = minimumJerk(std::clamp((t - a.time_s) / (b.time_s - a.time_s), 0.0, 1.0));
    const double end = std::clamp((t - b.time_s) / 0.4, 0.0, 1.0);  // after the last pose: let go
    // Lifted until the next of the steps of 10 ms, as it always was: sessions of it are the same bit for bit.
    path.knots_.push_back(
        {t,
         pressed(a.x_mm + (b.x_mm - a.x_mm) * share, a.y_mm + (b.y_mm - a.y_mm) * share,
                 (a.indentation_mm + (b.indentation_mm - a.indentation_mm) * share) * (1.0 - minimumJerk(end))),
         std::numeric_limits<double>::quiet_NaN()});
  }
  path.duration_s_ = kDemonstrationEnd_s;
  return path;
}

FingerPath FingerPath::constant(double x_mm, double y_mm, double indentation_mm) {
  const auto clean = [](double value, double limit) {
    return std::isfinite(value) ? std::clamp(value, -limit, limit) : 0.0;
  };
  FingerPath path;
  path.knots_.push_back({0.0, pressed(clean(x_mm, kUsableHalfWidth_mm), clean(y_mm, kUsableHalfDepth_mm),
                                      std::min(indentation_mm, kDeepestPress_mm))});
  return path;
}

FingerState FingerPath::at(double time_s) const {
  const Knot& first = knots_.front();
  if (knots_.size() == 1 || !(time_s > 0.0)) return first.state;
  if (!loops_ && time_s >= duration_s_) {
    FingerState gone = knots_.back().state;
    gone.lifted = true;
    gone.indentation_mm = 0.0;
    return gone;
  }
  const double t = std::fmod(time_s, duration_s_);
  const auto after = std::upper_bound(knots_.begin(), knots_.end(), t,
                                      [](double time, const Knot& knot) { return time < knot.time_s; });
  const Knot& a = *(after - 1);
  if (after == knots_.end()) {  // the pause before the path repeats
    FingerState waiting = a.state;
    if (t > a.time_s) {
      waiting.lifted = true;
      waiting.indentation_mm = 0.0;
    }
    return waiting;
  }
  const double from_mm = depthOf_mm(a), to_mm = depthOf_mm(*after);
  if (std::isnan(from_mm) || std::isnan(to_mm)) return a.state;
  const double share = (t - a.time_s) / (after->time_s - a.time_s);
  const auto mix = [share](double from, double to) { return from + (to - from) * share; };
  return pressed(mix(a.state.x_mm, after->state.x_mm), mix(a.state.y_mm, after->state.y_mm), mix(from_mm, to_mm));
}

FingerPath FingerPath::played(double speed, bool loop) const {
  FingerPath out = *this;
  for (Knot& knot : out.knots_) knot.time_s /= speed;
  out.duration_s_ = knots_.back().time_s / speed + (duration_s_ - knots_.back().time_s);
  out.loops_ = loop;
  return out;
}

}  // namespace fyd::sim
