#include "core/sim/server/motor_board.h"

#include <algorithm>
#include <cmath>

namespace fyd::sim {
namespace {

namespace qb = protocol::qbmove;

constexpr int kWatchdogUnit_ms = 20;

std::int16_t whole(double value) {
  return static_cast<std::int16_t>(std::lround(std::clamp(value, -32768.0, 32767.0)));
}

}  // namespace

std::optional<protocol::QbmoveFrame> MotorBoard::handle(const protocol::QbmoveFrame& frame,
                                                        const std::array<double, control::kMotorCount>& angle_deg,
                                                        const std::array<double, control::kMotorCount>& current_mA,
                                                        Instant now) {
  if (frame.id != options_.id && frame.id != qb::kBroadcast) return std::nullopt;
  last_frame_ = now;
  std::optional<protocol::QbmoveFrame> reply;
  const auto answer = [&](std::initializer_list<std::int16_t> values) {
    reply = protocol::qbmoveFrame(frame.command, {values.begin(), values.size()});
  };
  const auto first = frame.at(0);
  const auto second = frame.at(1);
  switch (frame.command) {
    case qb::kPing: answer({}); break;
    case qb::kActivate:
      command_.active = !frame.payload.empty() && frame.payload[0] != qb::kMotorsOff;
      command_.vibration_duty_percent = {};
      break;
    case qb::kGetActivate:
      reply = protocol::qbmoveByteFrame(frame.command, command_.active ? qb::kMotorsOn : qb::kMotorsOff);
      break;
    case qb::kSetInputs:
      if (first && second) command_.reference_ticks = {*first, *second};
      break;
    case qb::kGetMeasurements: {
      const double ticks = options_.encoder_sign * control::kTicksPerDegree;
      answer({whole(angle_deg[0] * ticks), whole(angle_deg[1] * ticks),
              whole(0.5 * (angle_deg[0] + angle_deg[1]) * ticks)});
      break;
    }
    case qb::kGetCurrents: answer({whole(current_mA[0]), whole(current_mA[1])}); break;
    case qb::kSetWatchdog:
      if (!frame.payload.empty()) watchdog_ = std::chrono::milliseconds(kWatchdogUnit_ms * frame.payload[0]);
      break;
    default:
      if (options_.vibration_opcode != 0 && frame.command == options_.vibration_opcode && first && second) {
        command_.vibration_duty_percent = {std::clamp<double>(*first, -100.0, 100.0),
                                           std::clamp<double>(*second, -100.0, 100.0)};
      }
  }
  if (reply) reply->id = options_.id;
  return frame.id == qb::kBroadcast ? std::nullopt : reply;
}

void MotorBoard::supervise(Instant now) {
  if (watchdog_ == Duration::zero() || now - last_frame_ <= watchdog_) return;
  command_.active = false;
  command_.vibration_duty_percent = {};
}

}  // namespace fyd::sim
