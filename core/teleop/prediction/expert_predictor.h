// The default predictor: several experts, weighted by their recent errors on this hand.
//
// Experts: hold; the paper's order 1; two linear forecasts that learn online, with a medium and a long memory
// (linear_forecast.h); and a perceptron trained on other people's strokes (learned_forecast.h), with a last layer that
// is learnt for this hand (personal_layer.h). Each predicts the hand's displacement over the horizons in use. As soon
// as the true displacement is known, an expert's squared error is added to its loss, with exponential forgetting over
// a hundred messages. Its weight is (smallest loss / its loss)^16: close to selecting the best expert, but without a jump
// when another one becomes the best. Initial losses are preset, with the weight of fifty messages.
//
// Only the horizons in use are computed (horizons.h), with polynomial interpolation between them. The predicted
// displacement is limited to 1.25 times the largest one observed over that horizon or, before one is known, to 1.25
// times the distance travelled in the motion so far. Finally it is multiplied by a factor 0 … 1 that follows from
// recent predictions and outcomes (trust.h) and goes to 0 on noise.
#pragma once

#include <array>
#include <memory>

#include "core/teleop/prediction/horizons.h"
#include "core/teleop/prediction/learned_forecast.h"
#include "core/teleop/prediction/linear_forecast.h"
#include "core/teleop/prediction/motion_history.h"
#include "core/teleop/prediction/personal_layer.h"
#include "core/teleop/prediction/trust.h"

namespace fyd::teleop {

class ExpertPredictor final : public Predictor {
 public:
  enum class ExpertSet : std::uint8_t { all, ar };  ///< ar: only the linear forecast with the medium memory

  ExpertPredictor(std::size_t axes, ExpertSet experts, std::shared_ptr<const StrokeWeights> weights);

  void message(double date_s, const Position& position_mm) override;
  [[nodiscard]] Position predict(double time_s) override;
  [[nodiscard]] Position velocity(double time_s) const override;
  void endMotion() override;

  /// Limits of a prediction, relative to the newest message and its slope: those of the fastest throws and blows.
  static constexpr double kLargestHandSpeed_mm_per_s = 10'000.0, kLargestHandAcceleration_mm_per_s2 = 200'000.0;

  static constexpr std::size_t kNodes = LinearForecast::kNodes;
  using Displacements = std::array<Position, kNodes>;  ///< over each node's horizon, mm

 private:
  static constexpr std::size_t kLinear = 2;
  static constexpr std::size_t kHold = 0, kOrder1 = 1, kLearned = 2, kFirstLinear = 3;
  static constexpr std::size_t kExperts = kFirstLinear + kLinear;
  static constexpr std::size_t kAnchorCapacity = 128;  ///< more anchors than within the longest horizon
  using FeatureSet = std::array<LinearForecast::Features, kMostAxes>;
  using Forecasts = std::array<Displacements, kExperts>;

  /// A message and what was forecast from it, kept until the outcome is known.
  struct Anchor {
    double date_s = 0.0;
    Position position_mm{};
    FeatureSet features{};
    Forecasts forecasts{};
    StrokeForecast learned;  ///< without the personal layer
    /// Last tick before the next anchor, the newest position at that time, and the displacement predicted.
    double tick_s = 0.0;
    Position tick_origin_mm{};
    Position tick_displacement_mm{};
    bool has_tick = false;
    bool forecasts_complete = false;  ///< `forecasts` has all horizons that are in use now
  };

  void begin(double step_s);
  void updateCentre(const Position& position_mm);
  void chooseNodes();
  /// Sets largest_mm_ for new nodes from the nearest old ones.
  void transferLargest(const Horizons::Steps& before, const Horizons::Steps& wanted);
  /// Evaluates the anchors for which the displacements over all horizons are known by now.
  void evaluateAnchors();
  /// Trains the learning experts on an anchor and adds the errors of its forecasts to the losses.
  void evaluate(const Anchor& then);
  /// Passes predictions of past ticks, and the true displacements, to trust_.
  void evaluateTicks();
  [[nodiscard]] double trustFactor(const Position& by_mm) const;
  [[nodiscard]] FeatureSet featuresAt(const DatedPosition& from) const;
  [[nodiscard]] Forecasts forecastsAt(const DatedPosition& from, const FeatureSet& features,
                                      StrokeForecast& learned) const;
  /// Weighted mean of the experts, limited.
  [[nodiscard]] Displacements combined(const Forecasts& forecasts) const;
  void updateWeights();
  /// Interpolates displacements_.
  [[nodiscard]] Position displacementAt(double age_s) const;
  [[nodiscard]] Position withinHandLimits(Position by, double age_s) const;
  [[nodiscard]] Anchor& anchor(long index) { return anchors_[static_cast<std::size_t>(index) % kAnchorCapacity]; }

  std::size_t axes_;
  ExpertSet experts_;
  std::array<std::array<LinearForecast, kMostAxes>, kLinear> linear_{};
  LearnedForecast learned_;
  PersonalLayer personal_;
  MotionHistory history_;
  std::array<Anchor, kAnchorCapacity> anchors_{};
  long index_ = 0;            ///< of the newest anchor; 0: none
  long first_of_motion_ = 1;  ///< anchor with which this motion began
  long evaluated_ticks_ = 0;  ///< the newest anchor whose tick is evaluated
  long evaluated_ = 0;        ///< the newest anchor that is evaluated
  Position centre_mm_{};      ///< the running mean of this motion
  int centre_count_ = 0;      ///< messages in centre_mm_, limited
  Horizons horizons_;
  Trust trust_;
  std::array<double, kNodes> largest_mm_{};  ///< largest motion over this node's horizon; −1: not known yet
  std::array<double, kExperts> loss_{};
  std::array<double, kExperts> weight_{};
  double loss_count_ = 0.0;          ///< effective number of anchors in loss_
  double initial_loss_count_ = 0.0;  ///< remaining weight of the initial losses
  bool stale_ = false;               ///< displacements_ are not those of the newest message
  Displacements displacements_{};
};

}  // namespace fyd::teleop
