#include "core/device/robot/touch_reference.h"

#include "core/teleop/prediction/predictor_choice.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fyd::device {
namespace {

constexpr std::string_view kThesis = "thesis";
constexpr double kShortestSpacing_s = 0.0075;  // between messages to a predictor: a hand is slower
constexpr double kClockLeap_s = 0.5;           // of dates, backwards: the other end's clock was restarted
constexpr double kForgetting = 0.93;           // factor of the old squared errors per message, at about 30 a second

}  // namespace

Result<std::optional<teleop::PredictorChoice>> followingNamed(std::string_view name) {
  if (name == kThesis) return std::optional<teleop::PredictorChoice>();
  const auto found = teleop::predictorNamed(name);
  if (found) return std::optional(*found);
  return fail("predictor \"{}\": expected one of {}, {}", name, kThesis, fmt::join(teleop::kPredictorNames, ", "));
}

Result<void> checkReference(const TouchReferenceSettings& settings) {
  const auto within = [](double value, double least, double most) { return value >= least && value <= most; };
  if (!within(settings.smooth_ms, 0.0, 1000.0)) {
    return fail("smoothing of {} ms: expected 0 to 1000", settings.smooth_ms);
  }
  if (!within(settings.patience_ms, 1.0, 10'000.0)) {
    return fail("patience of {} ms: expected 1 to 10000", settings.patience_ms);
  }
  if (!within(settings.furthest_ms, 0.0, 1000.0)) {
    return fail("a prediction of {} ms at most: expected 0 to 1000", settings.furthest_ms);
  }
  if (settings.lead_ms && !within(*settings.lead_ms, 0.0, 500.0)) {
    return fail("lead of {} ms: expected 0 to 500", *settings.lead_ms);
  }
  return {};
}

TouchReference::TouchReference(const TouchReferenceSettings& settings, double arm_lag_s)
    : settings_(settings),
      lead_s_(settings.lead_ms ? 1e-3 * *settings.lead_ms : arm_lag_s),
      mapping_(settings.mapping),
      smooth_(1e-3 * settings.smooth_ms) {
  parts_[0].axes = 2;
  parts_[1].first = 2;
  if (!settings.predictor) return;
  for (Part& part : parts_) part.predictor = teleop::makePredictor(*settings.predictor, {.axes = part.axes});
}

double TouchReference::seconds(Instant when) {
  if (!origin_) origin_ = when;
  return toSeconds(when - *origin_);
}

void TouchReference::reset(const Vec3& position_mm) {
  mapping_.reset(position_mm);
  if (!position_mm.finite()) return;
  for (Part& part : parts_) {
    part.led = false;
    if (part.predictor) part.predictor->endMotion();
  }
  held_mm_ = target_mm_ = {position_mm.x, position_mm.y, position_mm.z};
  arrived_mm_ = position_mm;
  ticks_ = 0;
  smooth_.reset();
}

void TouchReference::resume(const Vec3& position_mm) {
  reset(position_mm);
  mapping_.resume(position_mm);
}

void TouchReference::take(const protocol::RobotReception& reception, const protocol::RobotCounters& counters,
                          const Vec3& commanded_mm, Instant now) {
  if (reception.connected) resume(commanded_mm);
  if (!reception.touch) return;
  const std::uint64_t gaps = counters.lost + counters.missed_replies;
  // Messages were lost: motion in between was not followed, so start anew from where the arm stands.
  if (std::exchange(gaps_, gaps) != gaps) resume(commanded_mm);
  if (settings_.predictor) {
    follow(reception, now);
  } else {
    mapping_.apply(*reception.touch);
    arrived_mm_ = mapping_.target();
  }
}

void TouchReference::follow(const protocol::RobotReception& reception, Instant now) {
  const protocol::TouchGoal goal = mapping_.goal(*reception.touch);
  heard_ = now;
  if (!goal.depth) return;
  arrived_mm_.z = goal.position_mm.z;
  if (reception.touch->in_contact) {
    lead(parts_[1], reception.touch_sent, goal.position_mm);
  } else {  // a predictor forgets a press within seconds only, and the tool would go on pressing
    rest(parts_[1]);
    held_mm_[2] = goal.position_mm.z;
  }
  if (goal.along) {
    arrived_mm_ = goal.position_mm;
    lead(parts_[0], reception.touch_seen, goal.position_mm);
  } else {
    rest(parts_[0]);
  }
}

void TouchReference::lead(Part& part, Instant date, const Vec3& position_mm) {
  const double date_s = seconds(date);
  if (part.led && date_s < part.taken_s - kClockLeap_s) part.predictor->endMotion();
  if (part.led && date_s >= part.taken_s - kClockLeap_s && date_s < part.taken_s + kShortestSpacing_s) return;
  part.led = true;
  part.taken_s = date_s;
  const std::array<double, 3> p{position_mm.x, position_mm.y, position_mm.z};
  teleop::Position at{};
  std::copy_n(p.begin() + static_cast<std::ptrdiff_t>(part.first), part.axes, at.begin());
  part.predictor->message(date_s, at);
  if (part.first == 0) judge(date_s, position_mm);
}

/// Ends the prediction at the place where the smoothed target comes to rest without reversing: e(t) = −v·τ·exp(−t/τ).
void TouchReference::rest(Part& part) {
  if (!std::exchange(part.led, false)) return;
  part.predictor->endMotion();
  for (std::size_t axis = part.first; axis < part.first + part.axes; ++axis) {
    held_mm_[axis] = target_mm_[axis] + smooth_.velocity_mm_per_s()[axis] * 1e-3 * settings_.smooth_ms;
  }
}

MovingTarget TouchReference::at(Instant now, protocol::RobotPhase phase) {
  if (!settings_.predictor) return {.position_mm = mapping_.target(), .velocity_mm_s = {}};
  const double now_s = seconds(now);
  const bool linked = phase == protocol::RobotPhase::running || phase == protocol::RobotPhase::paused;
  if (!linked || !heard_ || now - *heard_ > fromSeconds(1e-3 * settings_.patience_ms)) {
    for (Part& part : parts_) rest(part);
  }
  teleop::Position position = held_mm_;
  teleop::Position velocity{};
  horizon_s_ = 0.0;
  for (Part& part : parts_) {
    if (!part.led) continue;
    const double latest_s = part.taken_s + 1e-3 * settings_.furthest_ms;
    const double time_s = std::min(now_s + lead_s_, latest_s);
    const teleop::Position there = part.predictor->predict(time_s);
    const teleop::Position moves = time_s < latest_s ? part.predictor->velocity(time_s) : teleop::Position{};
    std::copy_n(there.begin(), part.axes, position.begin() + static_cast<std::ptrdiff_t>(part.first));
    std::copy_n(moves.begin(), part.axes, velocity.begin() + static_cast<std::ptrdiff_t>(part.first));
    if (part.first == 0) horizon_s_ = time_s - part.taken_s;
  }
  if (ticks_ == 0) static_cast<void>(smooth_.step(now_s, target_mm_, {}));  // from where the arm stands
  target_mm_ = smooth_.step(now_s, position, velocity);
  said_[ticks_++ % said_.size()] = {now_s + lead_s_, target_mm_[0], target_mm_[1]};
  const teleop::Position& v = smooth_.velocity_mm_per_s();
  return {.position_mm = {target_mm_[0], target_mm_[1], target_mm_[2]}, .velocity_mm_s = {v[0], v[1], v[2]}};
}

/// Compares the seen position with the target that was given for its date.
void TouchReference::judge(double date_s, const Vec3& seen_mm) {
  const std::size_t known = std::min(ticks_, said_.size());
  for (std::size_t back = 1; back <= known; ++back) {
    const Said& then = said_[(ticks_ - back) % said_.size()];
    if (then.time_s > date_s) continue;
    const double dx = then.x_mm - seen_mm.x;
    const double dy = then.y_mm - seen_mm.y;
    squares_mm2_ = kForgetting * squares_mm2_ + (1.0 - kForgetting) * (dx * dx + dy * dy);
    return;
  }
}

ReferenceFigures TouchReference::figures() const {
  return {.error_mm = std::sqrt(squares_mm2_), .horizon_ms = 1e3 * horizon_s_};
}

}  // namespace fyd::device
