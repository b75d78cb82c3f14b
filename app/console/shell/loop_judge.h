// Says of values that are to be used what the model of the stiffness loop says of them. It knows how late this touchpad's
// motors are from the telemetry, and cloth and sensors from auto-tune once that has identified them.
#pragma once

#include <QString>
#include <optional>
#include <span>

#include "core/control/loop_prediction.h"
#include "core/pipeline/telemetry.h"
#include "widgets/tuning/tuning_model.h"

namespace fyd::console {

class LoopJudge {
 public:
  void listen(std::span<const pipeline::TelemetrySample> samples);
  /// Another touchpad is listened to from now on.
  void forget() { motors_age_ms_.reset(); }
  /// What auto-tune identified; none: as the profile describes the sensors.
  void setCloth(const std::optional<control::IdentifiedCloth>& cloth) { cloth_ = cloth; }
  [[nodiscard]] const std::optional<control::IdentifiedCloth>& cloth() const { return cloth_; }

  /// As measured over the last seconds; none: the motors have not answered yet.
  [[nodiscard]] std::optional<control::LoopTiming> timing() const;

  /// @param present the session's control parameters, @param next values that would replace some of them
  /// @return why the loop would be unstable; empty when it would not, or when nothing of the loop changes. While the
  ///         touchpad's own lateness is unknown, only what no touchpad bears is called unstable
  [[nodiscard]] QString doubt(control::ControlParameters present, std::span<const widgets::Setting> next) const;

 private:
  std::optional<control::IdentifiedCloth> cloth_;
  std::optional<double> motors_age_ms_;
};

}  // namespace fyd::console
