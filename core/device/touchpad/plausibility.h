// Implausible readings: a stuck distance sensor is reported, an encoder that jumps or does not follow its motor is
// withheld. Pure.
//
//   stuck   a code repeated for longer than device.stuck_sensor_s while each other sensor changed its own at least ten
//           times. A real sensor's noise (25 mV are 31 codes) excludes that. The codes are passed on unchanged: the
//           step leaves out a stuck sensor by itself (core/sensing) and may have enough others.
//   jump    an encoder further from its last reading than 1000 °/s and 5° allow: no geared motor does that. After half
//           a second without readings there is nothing to compare with.
//   still   an encoder that has not changed by a single count for a second while its motor's reference is more than 10°
//           from where it was at the last change: a frozen register, a torn cable, a motor without supply or held fast.
//
// After a jump or a standstill the motors' readings are withheld until the command has been inactive, or for a second
// while it is; the new angle is accepted then.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/device/device_parameters.h"
#include "core/device/touchpad/touchpad.h"

namespace fyd::device {

class Plausibility {
 public:
  explicit Plausibility(const DeviceParameters& parameters = {});

  /// @param command of this exchange, as sent to the motors; inactive for those that do not follow it (a recording's)
  [[nodiscard]] TouchpadReadings check(const TouchpadReadings& readings, const control::MotorCommand& command,
                                       Instant now);
  /// Which readings are implausible and why; empty: none.
  [[nodiscard]] Message complaint() const;
  /// Why the motors' readings were last withheld, until a command that turns active; or empty.
  [[nodiscard]] const Message& whyWithheld() const { return why_; }

 private:
  struct Sensor {
    std::uint16_t code = 0;
    Instant changed{};
    std::array<int, sensing::kMaximumIrSensors> changes_when_it_changed{};  ///< of each other sensor
    int changes = 0;
    bool stuck = false;
  };
  void checkSensors(const Timed<sensing::IrCounts>& ir);
  void checkEncoders(const Timed<control::MotorFeedback>& motors, const control::MotorCommand& command, Instant now);
  void checkTravel(const Timed<control::MotorFeedback>& motors, Instant now);
  void checkFollowing(const Timed<control::MotorFeedback>& motors, const control::MotorCommand& command, Instant now);
  void disbelieve(Message why, Instant now);

  Duration stuck_after_;
  std::array<Sensor, sensing::kMaximumIrSensors> sensors_{};
  std::uint64_t last_ir_ = 0;
  std::size_t sensor_count_ = 0;
  std::optional<Timed<control::MotorFeedback>> believed_;  // last plausible one: the next is compared with it
  Timed<control::MotorFeedback> handed_on_;
  std::uint64_t last_motors_ = 0;
  /// Where a motor was sent when its encoder last changed, and since when it has been sent further.
  struct Standstill {
    std::uint16_t counts = 0;
    double reference_deg = 0.0;
    std::optional<Instant> sent_further;
  };
  std::array<Standstill, control::kMotorCount> standstill_{};
  bool following_ = false;  // the motors are on: standstill_ is valid
  bool was_active_ = false;
  bool disbelieved_ = false;
  Instant disbelieved_at_{};
  Message why_;
};

}  // namespace fyd::device
