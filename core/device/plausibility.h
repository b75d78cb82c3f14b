// Readings that a sensor cannot mean: a stuck distance sensor is told of, an encoder that jumps is withheld. Pure.
//
//   stuck   a code repeated for longer than device.stuck_sensor_s while each other sensor changed its own at least ten
//           times. A real sensor's noise (25 mV are 31 codes) never does that. The codes go on as they are: the step
//           leaves a stuck sensor out by itself (core/sensing) and may have enough others.
//   jump    an encoder further from its last reading than 1000 °/s and 5° allow: no geared motor does that. The motors'
//           readings are withheld until the command has been inactive, or for a second while it is; the new angle is
//           believed then. After half a second without readings there is nothing to compare with.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/device/device_parameters.h"
#include "core/device/touchpad.h"

namespace fyd::device {

class Plausibility {
 public:
  explicit Plausibility(const DeviceParameters& parameters = {});

  /// @param active whether the command of this exchange wants the motors on
  [[nodiscard]] TouchpadReadings check(const TouchpadReadings& readings, bool active, Instant now);
  /// What is not believed and why; empty: nothing.
  [[nodiscard]] std::string complaint() const;

 private:
  struct Sensor {
    std::uint16_t code = 0;
    Instant changed{};
    std::array<int, sensing::kMaximumIrSensors> changes_when_it_changed{};  ///< of each other sensor
    int changes = 0;
    bool stuck = false;
  };
  void checkSensors(const Timed<sensing::IrCounts>& ir);
  void checkEncoders(const Timed<control::MotorFeedback>& motors, bool active, Instant now);

  Duration stuck_after_;
  std::array<Sensor, sensing::kMaximumIrSensors> sensors_{};
  std::uint64_t last_ir_ = 0;
  std::size_t sensor_count_ = 0;
  std::optional<Timed<control::MotorFeedback>> believed_;  // what the next one is compared with
  Timed<control::MotorFeedback> handed_on_;
  std::uint64_t last_motors_ = 0;
  bool jumped_ = false;
  Instant jumped_at_{};
  std::string jump_;
};

}  // namespace fyd::device
