#include "core/device/touchpad/plausibility.h"

#include <algorithm>
#include <cmath>

namespace fyd::device {
namespace {

constexpr int kChangesOfTheOthers = 10;
constexpr double kFastestMotor_deg_s = 1000.0;
constexpr double kSlack_deg = 5.0;
constexpr double kSentFurther_deg = 10.0;
constexpr Duration kLongestEncoderStandstill = std::chrono::seconds(1);
constexpr Duration kComparable = std::chrono::milliseconds(500);
constexpr Duration kWithheldWhileInactive = std::chrono::seconds(1);

/// The shorter way round the circle, in degrees.
double travel_deg(std::uint16_t from, std::uint16_t to) {
  constexpr int kTurn = control::kEncoderCountsPerTurn;
  const int counts = ((to - from) % kTurn + kTurn + kTurn / 2) % kTurn - kTurn / 2;
  return std::abs(counts / control::kEncoderCountsPerDegree);
}

}  // namespace

Plausibility::Plausibility(const DeviceParameters& parameters) : stuck_after_(fromSeconds(parameters.stuck_sensor_s)) {}

void Plausibility::checkSensors(const Timed<sensing::IrCounts>& ir) {
  if (ir.count == last_ir_) return;
  const bool first = last_ir_ == 0 || ir.value.size() != sensor_count_;
  last_ir_ = ir.count;
  sensor_count_ = ir.value.size();
  if (first) sensors_ = {};
  for (std::size_t i = 0; i < sensor_count_; ++i) {
    if (!first && sensors_[i].code == ir.value[i]) continue;
    sensors_[i].code = ir.value[i];
    sensors_[i].changed = ir.taken;
    sensors_[i].stuck = false;
    ++sensors_[i].changes;
    for (std::size_t k = 0; k < sensor_count_; ++k) sensors_[i].changes_when_it_changed[k] = sensors_[k].changes;
  }
  if (stuck_after_ <= Duration::zero() || sensor_count_ < 2) return;
  for (std::size_t i = 0; i < sensor_count_; ++i) {
    Sensor& sensor = sensors_[i];
    if (ir.taken - sensor.changed <= stuck_after_) continue;
    bool others_move = true;
    for (std::size_t k = 0; k < sensor_count_; ++k) {
      const bool moves = sensors_[k].changes - sensor.changes_when_it_changed[k] >= kChangesOfTheOthers;
      others_move = others_move && (k == i || moves);
    }
    sensor.stuck = sensor.stuck || others_move;
  }
}

void Plausibility::disbelieve(Message why, Instant now) {
  disbelieved_ = true;
  disbelieved_at_ = now;
  why_ = std::move(why);
}

void Plausibility::checkTravel(const Timed<control::MotorFeedback>& motors, Instant now) {
  if (!believed_ || motors.taken - believed_->taken > kComparable) return;
  const double allowed_deg =
      kSlack_deg + kFastestMotor_deg_s * std::max(0.0, toSeconds(motors.taken - believed_->taken));
  for (std::size_t i = 0; i < control::kMotorCount; ++i) {
    const double moved = travel_deg(believed_->value.encoder_counts[i], motors.value.encoder_counts[i]);
    if (moved <= allowed_deg) continue;
    disbelieve(say("encoder {} jumped by {:.0f}° in {:.0f} ms: check its magnet and cable, then arm again", i + 1,
                   moved, toMilliseconds(motors.taken - believed_->taken)),
               now);
  }
}

void Plausibility::checkFollowing(const Timed<control::MotorFeedback>& motors, const control::MotorCommand& command,
                                  Instant now) {
  const bool first = !following_;
  following_ = command.active;
  if (!following_) return;
  for (std::size_t i = 0; i < control::kMotorCount; ++i) {
    Standstill& still = standstill_[i];
    const double reference_deg = command.reference_ticks[i] / control::kTicksPerDegree;
    if (first || motors.value.encoder_counts[i] != still.counts) {
      still = {.counts = motors.value.encoder_counts[i], .reference_deg = reference_deg, .sent_further = {}};
      continue;
    }
    const double further_deg = std::abs(reference_deg - still.reference_deg);
    if (further_deg <= kSentFurther_deg) {
      still.sent_further.reset();
    } else if (!still.sent_further) {
      still.sent_further = motors.taken;
    } else if (motors.taken - *still.sent_further > kLongestEncoderStandstill) {
      disbelieve(say("encoder {} stands still although its motor was sent {:.0f}° further: check the motors' "
                     "supply and the encoder's cable, then arm again",
                     i + 1, further_deg),
                 now);
    }
  }
}

void Plausibility::checkEncoders(const Timed<control::MotorFeedback>& motors, const control::MotorCommand& command,
                                 Instant now) {
  if (command.active && !was_active_ && !disbelieved_) why_ = {};
  was_active_ = command.active;
  if (disbelieved_ && !command.active && now - disbelieved_at_ > kWithheldWhileInactive) {
    disbelieved_ = false;
    believed_.reset();
  }
  if (motors.count == last_motors_) return;
  last_motors_ = motors.count;
  if (!disbelieved_) checkTravel(motors, now);
  if (!disbelieved_) checkFollowing(motors, command, now);
  if (disbelieved_) {
    following_ = false;
    return;
  }
  believed_ = motors;
  handed_on_.set(motors.value, motors.taken);
}

TouchpadReadings Plausibility::check(const TouchpadReadings& readings, const control::MotorCommand& command,
                                     Instant now) {
  checkSensors(readings.ir);
  checkEncoders(readings.motors, command, now);
  TouchpadReadings out = readings;
  out.motors = handed_on_;
  return out;
}

Message Plausibility::complaint() const {
  if (disbelieved_) return why_;
  for (std::size_t i = 0; i < sensor_count_; ++i) {
    if (!sensors_[i].stuck) continue;
    return say("IR sensor {} is stuck at code {} while the others change: check its cable", i + 1, sensors_[i].code);
  }
  return {};
}

}  // namespace fyd::device
