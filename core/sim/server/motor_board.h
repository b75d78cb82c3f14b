// The original motor board's firmware as seen through its serial protocol. Pure: time is handed in. Not thread-safe.
#pragma once

#include <optional>

#include "core/base/time.h"
#include "core/control/motor_types.h"
#include "core/protocol/qbmove_codec.h"

namespace fyd::sim {

struct MotorBoardOptions {
  std::uint8_t id = protocol::qbmove::kDefaultId;
  int vibration_opcode = 0;  ///< 0: has no vibration command
  int encoder_sign = 1;      ///< −1: as firmware that counts in the opposite direction
};

class MotorBoard {
 public:
  explicit MotorBoard(const MotorBoardOptions& options) : options_(options) {}

  void restart() { *this = MotorBoard(options_); }

  /// @param angle_deg of the two motors now
  /// @return the reply, where the command has one
  [[nodiscard]] std::optional<protocol::QbmoveFrame> handle(const protocol::QbmoveFrame& frame,
                                                            const std::array<double, control::kMotorCount>& angle_deg,
                                                            const std::array<double, control::kMotorCount>& current_mA,
                                                            Instant now);
  /// Expires the watchdog.
  void supervise(Instant now);
  [[nodiscard]] const control::MotorCommand& command() const { return command_; }

 private:
  MotorBoardOptions options_;
  control::MotorCommand command_;
  Duration watchdog_{};  // zero: off
  Instant last_frame_{};
};

}  // namespace fyd::sim
