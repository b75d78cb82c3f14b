// From the touches that arrive to the arm's target at each tick.
//
// A touch is delayed by its picture's age and the network, the tool by the arm's own lag. x and y are dated with the
// picture, the depth with the sending. A predictor (core/teleop) for each of the two gives the finger's position when
// the arm gets there: now + lead. The correction by a new touch is smoothed (SmoothOutput), so that the target is
// continuous and has a velocity, with which the motion limits add no lag (MotionLimiter).
//
// A prediction ends when the finger is lifted, when no touch came for `patience`, or when the link is not running; it
// goes no further than `furthest` beyond the newest date. The target then comes to rest in the time of the smoothing,
// and the next touch begins anew from there. Interruptions are handled by TouchMapping.
//
// Without a predictor it is the thesis' way [thesis §4.2]: a share of the old target is kept at each touch. The lag then
// depends on the rate of the touches.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "core/protocol/robot_end.h"
#include "core/protocol/touch_mapping.h"
#include "core/teleop/prediction/predictor.h"
#include "core/teleop/prediction/predictor_choice.h"
#include "core/teleop/prediction/smooth_output.h"

namespace fyd::device {

struct TouchReferenceSettings {
  protocol::TouchMappingSettings mapping;
  std::optional<teleop::PredictorChoice> predictor = teleop::PredictorChoice::experts;  ///< nothing: the thesis' way
  double smooth_ms = 10.0;        ///< time constant of corrections, 0…1000
  double patience_ms = 150.0;     ///< without a touch, 1…10 000
  double furthest_ms = 250.0;     ///< beyond the newest date, lead included, 0…1000
  std::optional<double> lead_ms;  ///< 0…500; nothing: the arm's own lag
};

/// By its name: "thesis" or one of teleop::kPredictorNames. @return an error with the names
[[nodiscard]] Result<std::optional<teleop::PredictorChoice>> followingNamed(std::string_view name);
/// @return an error that names the setting, its value and its range
[[nodiscard]] Result<void> checkReference(const TouchReferenceSettings& settings);

struct MovingTarget {
  Vec3 position_mm;
  Vec3 velocity_mm_s;  ///< 0 in the thesis' way
};

/// Recent quality of the prediction, for the operator.
struct ReferenceFigures {
  double error_mm = 0.0;    ///< RMS difference, along the cloth, between predicted and later seen positions of the
                            ///< finger; over about a second
  double horizon_ms = 0.0;  ///< from the newest date to the date that the target is for
};

class TouchReference {
 public:
  /// @param settings as checkReference accepts them
  /// @param arm_lag_s the lead where the settings give none
  TouchReference(const TouchReferenceSettings& settings, double arm_lag_s);

  /// The target is at rest there.
  void reset(const Vec3& position_mm);
  /// The target is at rest there after an interruption, when the arm follows again.
  void resume(const Vec3& position_mm);
  /// Takes a received datagram. @param commanded_mm where the arm stands, for a connection that begins or had a gap
  void take(const protocol::RobotReception& reception, const protocol::RobotCounters& counters,
            const Vec3& commanded_mm, Instant now);

  /// At each tick, in the order of time. @param phase of the robot end's connection
  [[nodiscard]] MovingTarget at(Instant now, protocol::RobotPhase phase);

  /// The position that the newest touch maps to, without prediction.
  [[nodiscard]] const Vec3& arrived_mm() const { return arrived_mm_; }
  [[nodiscard]] ReferenceFigures figures() const;

 private:
  /// x and y, or z.
  struct Part {
    std::unique_ptr<teleop::Predictor> predictor;
    std::size_t first = 0;  // axis
    std::size_t axes = 1;
    bool led = false;
    double taken_s = 0.0;  // of the newest message
  };
  /// A past target along the cloth.
  struct Said {
    double time_s = 0.0;
    double x_mm = 0.0, y_mm = 0.0;
  };

  [[nodiscard]] double seconds(Instant when);
  void follow(const protocol::RobotReception& reception, Instant now);
  void lead(Part& part, Instant date, const Vec3& position_mm);
  void rest(Part& part);
  void judge(double date_s, const Vec3& seen_mm);

  TouchReferenceSettings settings_;
  double lead_s_;
  protocol::TouchMapping mapping_;
  std::array<Part, 2> parts_;
  teleop::SmoothOutput smooth_;
  teleop::Position held_mm_{};  // rest position of the parts without a prediction
  teleop::Position target_mm_{};
  std::optional<Instant> origin_;  // of seconds
  std::optional<Instant> heard_;
  std::uint64_t gaps_ = 0;  // in the stream of touches, so far
  Vec3 arrived_mm_;
  std::array<Said, 512> said_{};  // the last ticks' targets along the cloth, a ring
  std::size_t ticks_ = 0;
  double squares_mm2_ = 0.0;
  double horizon_s_ = 0.0;
};

}  // namespace fyd::device
