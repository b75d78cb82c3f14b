// Predicts a hand's present orientation from messages of past ones, by rotation vectors instead of Euler angles.
//
// From message to message the shortest rotation is taken as a vector along its axis in the hand's own frame, and these
// vectors are summed to a path in three dimensions, scaled with 100 mm per rad (a fingertip moves about as much). A
// predictor of positions extrapolates this path, and the predicted vector is applied to the newest orientation. So
// there is no discontinuity at ±180° and no gimbal lock, and a quaternion and its negative are the same. Between two
// messages a hand must turn by less than half a turn.
#pragma once

#include "core/teleop/prediction/motion_history.h"
#include "core/teleop/prediction/predictor_choice.h"

namespace fyd::teleop {

struct Orientation {
  double w = 1.0, x = 0.0, y = 0.0, z = 0.0;  ///< unit quaternion
};

/// From one to the other, 0 … 180°.
[[nodiscard]] double angle_deg(const Orientation& from, const Orientation& to);
/// By α about x, then β about y, then γ about z, all of the outer frame, rad.
[[nodiscard]] Orientation fromAngles(double alpha, double beta, double gamma);

class OrientationPredictor {
 public:
  static constexpr double kMillimetresPerRadian = 100.0;

  /// @param period_s as in PredictorSetup
  OrientationPredictor(PredictorChoice choice, double period_s)
      : predictor_(makePredictor(choice, {.axes = 3, .period_s = period_s})) {}

  /// As Predictor::message. A quaternion whose length is not within 1 ± 0.1 is ignored; others are normalised.
  void message(double date_s, const Orientation& orientation);
  /// @return a unit quaternion; no rotation before the first message of a motion
  [[nodiscard]] Orientation predict(double time_s);
  void endMotion() {
    predictor_->endMotion();
    count_ = 0;
  }

 private:
  /// A message, and the sum of the rotation vectors up to it.
  struct PathPoint {
    double date_s = 0.0;
    Orientation orientation;
    Position path_mm{};
  };
  static constexpr std::size_t kCapacity = 64;
  [[nodiscard]] const PathPoint& back(std::size_t i) const { return path_[(end_ + kCapacity - 1 - i) % kCapacity]; }

  std::unique_ptr<Predictor> predictor_;
  std::array<PathPoint, kCapacity> path_{};  ///< ring, by date
  std::size_t end_ = 0, count_ = 0;
};

}  // namespace fyd::teleop
