// Kalman filter on Singer's model: an acceleration that decays (a' = −a/τ + noise), observed through noisy messages.
//
// [Singer 1970]
// State per axis: position, velocity, acceleration. Every axis has the same dates, hence the same covariance. A message
// older than the newest one is ignored.
// Stability: may change
#pragma once

#include "core/base/api.h"
#include "core/teleop/prediction/predictor.h"

namespace fyd::teleop {

class FYD_API KalmanPredictor final : public Predictor {
 public:
  static constexpr double kAccelerationTimeConstant_s = 0.050;  ///< τ
  static constexpr double kAccelerationRms_mm_per_s2 = 3000.0;  ///< of a hand
  static constexpr double kPositionNoise_mm = 0.02;             ///< standard deviation of a message's position

  void message(double date_s, const Position& position_mm) override;
  [[nodiscard]] Position predict(double time_s) override;
  [[nodiscard]] Position velocity(double time_s) const override;
  void endMotion() override { begun_ = false; }

 private:
  struct State {
    Position x{}, v{}, a{};
  };
  [[nodiscard]] State stateAfter(double by_s) const;

  bool begun_ = false;
  double date_s_ = 0.0;
  State state_;
  std::array<std::array<double, 3>, 3> covariance_{};
};

}  // namespace fyd::teleop
