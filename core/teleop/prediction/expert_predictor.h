// The default predictor: several experts, weighted by their recent errors on this hand.
//
// Experts: hold; the paper's order 1; two linear forecasts that learn online, with a medium and a long memory
// (linear_forecast.h); and a perceptron trained on other people's strokes (learned_forecast.h), with a last layer that
// is learnt for this hand (personal_layer.h). Each predicts the hand's position at the horizons in use. As soon as the
// true one is known, its squared error is added to its loss, with exponential forgetting over a hundred messages. An
// expert's weight is (smallest loss / its loss)^16: close to selecting the best one, but without a jump when another
// takes over. Initial losses are preset, with the weight of fifty messages.
//
// Only the horizons in use are computed (horizons.h), with polynomial interpolation between them. The predicted
// displacement is limited to 1.25 times the largest one seen over that horizon, or, before one is known, seen in the
// motion so far. It is finally scaled by the share of recent predictions that came true (trust.h), so that it is 0 on
// noise.
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
  enum class Team : std::uint8_t { all, ar };  ///< ar: only one linear forecast, with the medium memory

  ExpertPredictor(std::size_t axes, Team team, std::shared_ptr<const StrokeWeights> weights);

  void message(double date_s, const Position& position_mm) override;
  [[nodiscard]] Position predict(double time_s) override;
  [[nodiscard]] Position velocity(double time_s) const override;
  void endMotion() override;

  /// A hand moves no faster (the fastest throws and blows), measured from the newest message and its slope.
  static constexpr double kHandSpeed_mm_per_s = 10'000.0, kHandAcceleration_mm_per_s2 = 200'000.0;

  static constexpr std::size_t kNodes = LinearForecast::kNodes;
  using Displacements = std::array<Position, kNodes>;  ///< over each node's horizon, mm

 private:
  static constexpr std::size_t kLinear = 2;
  static constexpr std::size_t kHold = 0, kOrder1 = 1, kLearned = 2, kFirstLinear = 3;
  static constexpr std::size_t kExperts = kFirstLinear + kLinear;
  static constexpr std::size_t kKept = 128;  ///< anchors: more than the longest horizon has
  using FeatureSet = std::array<LinearForecast::Features, kMostAxes>;
  using Opinions = std::array<Displacements, kExperts>;

  struct Anchor {
    double date_s = 0.0;
    Position position_mm{};
    FeatureSet features{};
    Opinions said{};
    StrokeForecast learned;  ///< without the personal layer
    double tick_s = 0.0;     ///< the last tick before the next anchor, the position it started from and where it went
    Position tick_from_mm{};
    Position tick_by_mm{};
    bool has_tick = false;
    bool said_all = false;  ///< for all horizons in use now
  };

  void begin(double step_s);
  void watchCentre(const Position& position_mm);
  void chooseNodes();
  void keepFurthest(const Horizons::Steps& before, const Horizons::Steps& wanted);
  void settleAnchors();
  void settle(const Anchor& then);
  void settleTicks();
  [[nodiscard]] double believed(const Position& by_mm) const;
  [[nodiscard]] FeatureSet featuresAt(const DatedPosition& from) const;
  [[nodiscard]] Opinions opinionsAt(const DatedPosition& from, const FeatureSet& features,
                                    StrokeForecast& learned) const;
  [[nodiscard]] Displacements mixed(const Opinions& opinions) const;
  void weigh();
  [[nodiscard]] Position moved(double age_s) const;
  [[nodiscard]] Position withinHandLimits(Position by, double age_s) const;
  [[nodiscard]] Anchor& anchor(long index) { return anchors_[static_cast<std::size_t>(index) % kKept]; }

  std::size_t axes_;
  Team team_;
  std::array<std::array<LinearForecast, kMostAxes>, kLinear> linear_{};
  LearnedForecast learned_;
  PersonalLayer personal_;
  MotionHistory history_;
  std::array<Anchor, kKept> anchors_{};
  long index_ = 0;            ///< of the newest anchor; 0: none
  long first_of_motion_ = 1;  ///< anchor with which this motion began
  long settled_ticks_ = 0;    ///< the newest anchor whose tick is settled
  long settled_ = 0;          ///< the newest anchor whose future over all horizons is known
  Position centre_mm_{};      ///< the running mean of this motion
  int in_centre_ = 0;         ///< messages in it
  Horizons horizons_;
  Trust trust_;
  std::array<double, kNodes> furthest_mm_{};  ///< largest motion over this node's horizon; −1: not known yet
  std::array<double, kExperts> loss_{};
  std::array<double, kExperts> weight_{};
  double losses_ = 0.0;        ///< effective number of anchors in loss_
  double begin_losses_ = 0.0;  ///< remaining weight of the initial losses
  bool stale_ = false;         ///< displaced_ is not of the newest message
  Displacements displaced_{};
};

}  // namespace fyd::teleop
