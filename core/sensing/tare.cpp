#include "core/sensing/tare.h"

#include <algorithm>
#include <cmath>

#include "core/base/message.h"
#include "core/sensing/indentation.h"

namespace fyd::sensing {
namespace {

constexpr double kSlowest_Hz = 20.0;
constexpr double kGrace_s = 1.0;

}  // namespace

std::string_view toString(TareState state) {
  switch (state) {
    case TareState::idle: return sentence("idle");
    case TareState::running: return sentence("running");
    case TareState::done: return sentence("done");
    case TareState::touched: return sentence("the cloth was touched");
    case TareState::invalid_sensor: return sentence("a sensor is outside its span");
    case TareState::unsteady: return sentence("readings too unsteady");
    case TareState::too_slow: return sentence("too few readings in time");
  }
  return sentence("unknown");
}

void Tare::Sum::add(double value) {
  ++count;
  const double from_old = value - mean;
  mean += from_old / count;
  squares += from_old * (value - mean);
}

double Tare::Sum::spread() const { return count > 1 ? std::sqrt(squares / (count - 1)) : 0.0; }

void Tare::start(Instant now, std::uint32_t samples) {
  *this = {};
  wanted_ = std::clamp(samples, 1U, 10'000U);
  deadline_ = now + fromSeconds(wanted_ / kSlowest_Hz + kGrace_s);
  state_ = TareState::running;
}

TareState Tare::step(Instant now, const IndentationEstimate& estimate, const Timed<double>& force_N) {
  if (state_ != TareState::running) return state_;
  if (now > deadline_) return state_ = TareState::too_slow;
  if (estimate.touched) return state_ = TareState::touched;
  if (estimate.reason == IndentationReason::ir_stale || estimate.reason == IndentationReason::finger_stale) {
    return state_;  // wait for picture and readings
  }

  if (estimate.count != last_ir_) {
    last_ir_ = estimate.count;
    sensors_ = estimate.sensors;
    for (std::size_t i = 0; i < sensors_; ++i) {
      if (!std::isfinite(estimate.distance_mm[i])) return state_ = TareState::invalid_sensor;
      distances_[i].add(estimate.distance_mm[i]);
    }
  }
  if (force_N.count != last_force_) {
    last_force_ = force_N.count;
    if (!std::isfinite(force_N.value)) return state_ = TareState::invalid_sensor;
    force_.add(force_N.value);
  }
  if (sensors_ > 0 && distances_[0].count >= wanted_ && force_.count >= std::max(1U, wanted_ / 4)) finish();
  return state_;
}

void Tare::finish() {
  state_ = TareState::done;
  result_.sensors = sensors_;
  for (std::size_t i = 0; i < sensors_; ++i) {
    result_.offset_mm[i] = distances_[i].mean;
    result_.spread_mm[i] = distances_[i].spread();
    if (result_.spread_mm[i] > kLargestSpread_mm) state_ = TareState::unsteady;
  }
  result_.force_N = force_.mean;
  result_.force_spread_N = force_.spread();
  if (result_.force_spread_N > kLargestSpread_N) state_ = TareState::unsteady;
}

}  // namespace fyd::sensing
