#include "core/teleop/expert_predictor.h"

#include <algorithm>
#include <cmath>

#include "core/teleop/plain_predictors.h"

namespace fyd::teleop {
namespace {

constexpr double kLeastStep_s = 0.010;  // Δ of faster messages: a hand moves no faster than this shows
constexpr double kSameStep = 0.05;      // spacings within this share of Δ are Δ
constexpr double kShorterStep = 0.7, kLongerStep = 1.5;
constexpr int kShorterInARow = 3, kLongerInARow = 12;
constexpr double kNewAnchor = 0.7;  // of Δ: messages closer together share one
constexpr int kMostInCentre = 300;  // messages, that the centre of a motion is the mean of
constexpr int kMostSteps = 96;
constexpr int kNodeChoiceEvery = 16;      // anchors
constexpr double kLossMemory = 0.99;      // per settled anchor
constexpr double kBeginLosses = 50.0;     // settled anchors that the initial losses are worth
constexpr int kSharpness = 4;             // the ratio of losses to the power of 2 to this
constexpr double kNoise_mm2 = 0.0009;     // a hand at rest moves by 0.03 mm, and that cannot be known ahead
constexpr double kFirstNoise_mm2 = 0.04;  // a prediction from its noise: 0.2 mm
constexpr double kDoubt = 1.25;           // the share that has come true, times this, is believed
constexpr double kRoom = 1.25;            // the furthest motion seen over a horizon, times this, is the most

// Losses before anything is known, as a share of hold's; in the order of the experts. A stroke is drawn in a plane: of
// a lever or of a hand in the air the perceptron has learnt nothing.
constexpr std::array<double, 5> kBeginLoss = {1.0, 0.5, 0.3, 0.35, 0.35};
constexpr double kBeginLossOutOfPlane = 0.8;

constexpr std::array<ForecastSettings, 2> kMemories = {{
    {.order = 20, .smooth_s = 0.030, .far_lag_cost = 0.05},
    {.order = LinearForecast::kMostOrder, .smooth_s = 0.040, .far_lag_cost = 0.03},
}};

}  // namespace

ExpertPredictor::ExpertPredictor(std::size_t axes, Team team, std::shared_ptr<const StrokeWeights> weights)
    : axes_(axes), team_(team), learned_(std::move(weights)), history_(kLeastStep_s / 4.0) {
  begin(kLeastStep_s);
  step_s_ = 0.0;
}

void ExpertPredictor::begin(double step_s) {
  step_s_ = step_s;
  for (std::size_t e = 0; e < kLinear; ++e) {
    for (LinearForecast& each : linear_[e]) each.begin(kMemories[e], step_s);
  }
  first_of_motion_ = index_ + 1;
  settled_ = settled_ticks_ = index_;
  node_steps_.fill(0);
  furthest_mm_.fill(-1.0);
  went_by_ = went_along_ = 0.0;
  loss_.fill(0.0);
  losses_ = 0.0;
  begin_losses_ = kBeginLosses;
  until_choice_ = 0;
  displaced_ = {};
  weigh();
}

void ExpertPredictor::endMotion() {
  history_.clear();
  first_of_motion_ = index_ + 1;
  settled_ = settled_ticks_ = index_;
  displaced_ = {};
  stale_ = false;
}

void ExpertPredictor::watchStep(double spacing_s) {
  const double fitting_s = std::max(spacing_s, kLeastStep_s);
  if (step_s_ == 0.0) {
    begin(std::abs(fitting_s - kLeastStep_s) < kSameStep * kLeastStep_s ? kLeastStep_s : fitting_s);
    return;
  }
  shorter_ = fitting_s < kShorterStep * step_s_ ? shorter_ + 1 : 0;
  longer_ = fitting_s > kLongerStep * step_s_ ? longer_ + 1 : 0;
  if (shorter_ < kShorterInARow && longer_ < kLongerInARow) return;
  shorter_ = longer_ = 0;
  begin(fitting_s);
}

void ExpertPredictor::watchAge(double age_s) {
  if (!(age_s >= 0.0)) age_s = 0.0;
  if (least_age_s_ < 0.0) {
    least_age_s_ = age_s;
    most_age_s_ = age_s + 0.85 * (step_s_ > 0.0 ? step_s_ : kLeastStep_s);
    return;
  }
  least_age_s_ = age_s < least_age_s_ ? age_s : least_age_s_ + 5e-4 * (age_s - least_age_s_);
  // Towards the age that one tick of twenty exceeds.
  const double step = 0.02 * kLeastStep_s;
  most_age_s_ += age_s > most_age_s_ ? 0.95 * step : -0.05 * step;
}

void ExpertPredictor::watchCentre(const Position& position_mm) {
  in_centre_ = index_ + 1 == first_of_motion_ ? 1 : std::min(in_centre_ + 1, kMostInCentre);
  for (std::size_t a = 0; a < axes_; ++a) centre_mm_[a] += (position_mm[a] - centre_mm_[a]) / in_centre_;
}

void ExpertPredictor::chooseNodes() {
  if (least_age_s_ < 0.0 || step_s_ == 0.0) return;
  if (until_choice_-- > 0) return;
  until_choice_ = kNodeChoiceEvery;
  const auto steps = [this](double age_s) { return static_cast<int>(std::min<double>(kMostSteps, age_s / step_s_)); };
  const int low = std::clamp(steps(least_age_s_ + 0.02 * step_s_), 1, kMostSteps - 1);
  const int high = std::clamp(steps(most_age_s_ + 0.98 * step_s_), low + 1, kMostSteps);
  const std::array<int, kNodes> wanted = {low, high, high - low >= 4 ? (low + high) / 2 : 0};
  if (wanted == node_steps_) return;
  for (std::size_t node = 0; node < kNodes; ++node) {
    if (wanted[node] != node_steps_[node]) furthest_mm_[node] = -1.0;
  }
  node_steps_ = wanted;
  for (auto& expert : linear_) {
    for (LinearForecast& each : expert) each.setNodes(wanted);
  }
  for (Anchor& each : anchors_) each.said_all = false;
}

ExpertPredictor::FeatureSet ExpertPredictor::featuresAt(const DatedPosition& from) const {
  FeatureSet out{};
  Position later = from.position_mm;
  std::size_t place = 0;
  for (std::size_t k = 0; k + 1 < LinearForecast::kMostOrder; ++k) {
    const double date_s = from.date_s - static_cast<double>(k + 1) * step_s_;
    const Position each = history_.at(date_s, place);
    for (std::size_t a = 0; a < axes_; ++a) out[a][k] = later[a] - each[a];
    later = each;
    if (place + 1 >= history_.size() && history_.oldest().date_s > date_s) break;  // nothing further back
  }
  for (std::size_t a = 0; a < axes_; ++a) {
    out[a].back() = LinearForecast::kCentre * (from.position_mm[a] - centre_mm_[a]);
  }
  return out;
}

ExpertPredictor::Opinions ExpertPredictor::opinionsAt(const DatedPosition& from, const FeatureSet& features) {
  Opinions out{};
  const Position slope = newestSlope(history_, std::max(PlainPredictor::kSlopeWindow_s, newestSpacing(history_)));
  if (team_ == Team::all) learned_.look(history_, from);
  for (std::size_t node = 0; node < kNodes; ++node) {
    if (node_steps_[node] == 0) continue;
    const double horizon_s = node_steps_[node] * step_s_;
    const Position learned = learned_.displacement(horizon_s);
    for (std::size_t a = 0; a < axes_; ++a) {
      out[kOrder1][node][a] = slope[a] * horizon_s;
      out[kLearned][node][a] = learned[a];
      for (std::size_t e = 0; e < kLinear; ++e) {
        out[kFirstLinear + e][node][a] = linear_[e][a].forecast(node, features[a]);
      }
    }
  }
  return out;
}

void ExpertPredictor::settleAnchors() {
  const int longest = *std::ranges::max_element(node_steps_);
  if (longest == 0) return;
  const double known_s = history_.newest().date_s - (longest - 0.02) * step_s_;
  const long before = settled_;
  settled_ = std::max(settled_, index_ - static_cast<long>(kKept));
  while (settled_ < index_ && anchor(settled_ + 1).date_s <= known_s) settle(anchor(++settled_));
  if (settled_ != before) weigh();
}

void ExpertPredictor::settle(const Anchor& then) {
  std::array<Position, kNodes> displacement{};
  std::array<std::array<double, kNodes>, kMostAxes> of_axis{};
  for (std::size_t node = 0; node < kNodes; ++node) {
    if (node_steps_[node] == 0) continue;
    const Position now = history_.at(then.date_s + node_steps_[node] * step_s_);
    double squares = 0.0;
    for (std::size_t a = 0; a < axes_; ++a) {
      of_axis[a][node] = displacement[node][a] = now[a] - then.position_mm[a];
      squares += displacement[node][a] * displacement[node][a];
    }
    furthest_mm_[node] = std::max(furthest_mm_[node], std::sqrt(squares));
  }
  for (auto& expert : linear_) {
    for (std::size_t a = 0; a < axes_; ++a) expert[a].learn(then.features[a], of_axis[a]);
  }
  if (!then.said_all) return;
  losses_ = losses_ * kLossMemory + 1.0;
  begin_losses_ *= kLossMemory;
  for (std::size_t e = 0; e < kExperts; ++e) {
    double squares = 0.0;
    for (std::size_t node = 0; node < kNodes; ++node) {
      for (std::size_t a = 0; a < axes_; ++a) {
        const double error = then.said[e][node][a] - displacement[node][a];
        squares += error * error;
      }
    }
    loss_[e] = loss_[e] * kLossMemory + squares;
  }
}

void ExpertPredictor::settleTicks() {
  const double newest_s = history_.newest().date_s;
  settled_ticks_ = std::max(settled_ticks_, index_ - static_cast<long>(kKept));
  for (; settled_ticks_ < index_; ++settled_ticks_) {
    const Anchor& then = anchor(settled_ticks_ + 1);
    if (!then.has_tick) continue;
    if (then.tick_s > newest_s) break;
    if (!history_.knows(then.tick_s, kLongerStep * step_s_)) continue;
    const Position now = history_.at(then.tick_s);
    went_by_ *= kLossMemory;
    went_along_ *= kLossMemory;
    for (std::size_t a = 0; a < axes_; ++a) {
      went_by_ += then.tick_by_mm[a] * then.tick_by_mm[a];
      went_along_ += then.tick_by_mm[a] * (now[a] - then.tick_from_mm[a]);
    }
  }
}

double ExpertPredictor::trust(const Position& by_mm) const {
  // Before much is known: as if it had come true, of motions that are more than noise.
  if (!(losses_ > 0.0)) {
    const double squares = by_mm[0] * by_mm[0] + by_mm[1] * by_mm[1] + by_mm[2] * by_mm[2];
    return squares / (squares + kFirstNoise_mm2);
  }
  const double usual = loss_[kHold] / losses_;
  const double before = 0.5 * begin_losses_ * usual;
  const double by = went_by_ + before + kNoise_mm2;
  return std::clamp(kDoubt * (went_along_ + before * usual / (usual + kNoise_mm2)) / by, 0.0, 1.0);
}

void ExpertPredictor::weigh() {
  weight_.fill(0.0);
  if (team_ == Team::ar) {
    weight_[kFirstLinear] = 1.0;
    return;
  }
  const double unit = losses_ > 0.0 ? loss_[kHold] / losses_ + 1e-9 : 1.0;
  std::array<double, kExperts> total{};
  double least = 0.0;
  for (std::size_t e = 0; e < kExperts; ++e) {
    total[e] = loss_[e] + begin_losses_ * unit * (e == kLearned && axes_ != 2 ? kBeginLossOutOfPlane : kBeginLoss[e]);
    if (e == 0 || total[e] < least) least = total[e];
  }
  double sum = 0.0;
  for (std::size_t e = 0; e < kExperts; ++e) {
    double share = least / total[e];
    for (int doubling = 0; doubling < kSharpness; ++doubling) share *= share;
    weight_[e] = share;
    sum += share;
  }
  for (double& each : weight_) each /= sum;
}

ExpertPredictor::Displacements ExpertPredictor::mixed(const Opinions& opinions) const {
  Displacements out{};
  for (std::size_t node = 0; node < kNodes; ++node) {
    double squares = 0.0;
    for (std::size_t a = 0; a < axes_; ++a) {
      for (std::size_t e = 0; e < kExperts; ++e) out[node][a] += weight_[e] * opinions[e][node][a];
      squares += out[node][a] * out[node][a];
    }
    const double most = kRoom * furthest_mm_[node];
    if (furthest_mm_[node] >= 0.0 && squares > most * most) {
      for (double& each : out[node]) each *= most / std::sqrt(squares);
    }
  }
  return out;
}

void ExpertPredictor::message(double date_s, const Position& position_mm) {
  const bool silent = !history_.empty() && date_s - history_.newest().date_s > kSilence_s;
  if (silent) endMotion();
  const double before_s = history_.empty() ? 0.0 : history_.newest().date_s;
  const bool first = history_.empty();
  const MotionHistory::Taken taken = history_.insert(date_s, position_mm);
  if (taken == MotionHistory::Taken::refused) return;
  stale_ = true;
  if (taken == MotionHistory::Taken::overtaken || first) return;
  watchStep(date_s - before_s);
  if (index_ >= first_of_motion_ && date_s - anchor(index_).date_s < kNewAnchor * step_s_) return;
  watchCentre(position_mm);
  const FeatureSet features = featuresAt(history_.newest());
  for (auto& expert : linear_) {
    for (std::size_t a = 0; a < axes_; ++a) expert[a].watch(features[a][0]);
  }
  settleAnchors();
  settleTicks();
  chooseNodes();
  Anchor& now = anchor(++index_);
  now.date_s = date_s;
  now.position_mm = position_mm;
  now.features = features;
  now.said = opinionsAt(history_.newest(), features);
  now.said_all = true;
  now.has_tick = false;
  displaced_ = mixed(now.said);
  stale_ = false;
}

Position ExpertPredictor::moved(double age_s) const {
  // Lagrange's polynomial through no motion at age 0 and the nodes; beyond the last one its chord goes on, half as far.
  std::array<double, kNodes + 1> at{};
  std::array<const Position*, kNodes + 1> to{};
  static constexpr Position kNothing{};
  to[0] = &kNothing;
  std::size_t points = 1;
  double last_s = 0.0;
  for (std::size_t node = 0; node < kNodes; ++node) {
    if (node_steps_[node] == 0) continue;
    at[points] = node_steps_[node] * step_s_;
    last_s = std::max(last_s, at[points]);
    to[points++] = &displaced_[node];
  }
  const double beyond_s = std::max(0.0, age_s - last_s);
  const double within_s = std::min(age_s, last_s);
  Position out{};
  for (std::size_t i = 1; i < points; ++i) {
    double share = 1.0;
    for (std::size_t k = 0; k < points; ++k) {
      if (k != i) share *= (within_s - at[k]) / (at[i] - at[k]);
    }
    for (std::size_t a = 0; a < axes_; ++a) out[a] += share * (*to[i])[a];
  }
  if (beyond_s > 0.0 && points > 2) {
    const double last = 0.5 * beyond_s / (1.0 + beyond_s / last_s) / (at[2] - at[1]);
    for (std::size_t a = 0; a < axes_; ++a) out[a] += last * ((*to[2])[a] - (*to[1])[a]);
  }
  return out;
}

Position ExpertPredictor::withinHandLimits(Position by, double age_s) const {
  // First what the acceleration allows beyond the newest messages' slope, then the speed.
  const Position slope = newestSlope(history_, std::max(PlainPredictor::kSlopeWindow_s, newestSpacing(history_)));
  const auto shorten = [](Position from, Position to, double most) {
    double squares = 0.0;
    for (std::size_t a = 0; a < kMostAxes; ++a) squares += (to[a] - from[a]) * (to[a] - from[a]);
    if (!(squares > most * most)) return to;
    for (std::size_t a = 0; a < kMostAxes; ++a) to[a] = from[a] + (to[a] - from[a]) * most / std::sqrt(squares);
    return to;
  };
  Position straight{};
  for (std::size_t a = 0; a < kMostAxes; ++a) straight[a] = slope[a] * age_s;
  by = shorten(straight, by, 0.5 * kHandAcceleration_mm_per_s2 * age_s * age_s);
  return shorten({}, by, kHandSpeed_mm_per_s * age_s);
}

Position ExpertPredictor::predict(double time_s) {
  if (history_.empty()) return {};
  const DatedPosition& newest = history_.newest();
  const double age_s = time_s - newest.date_s;
  if (!std::isfinite(age_s)) return newest.position_mm;
  const bool unheard = least_age_s_ < 0.0;
  watchAge(age_s);
  if (unheard) {
    until_choice_ = 0;
    chooseNodes();
  }
  if (age_s <= 0.0) return history_.at(time_s);
  if (stale_ && history_.size() > 1) displaced_ = mixed(opinionsAt(newest, featuresAt(newest)));
  stale_ = false;
  Position out = newest.position_mm;
  const Position by = withinHandLimits(moved(age_s), age_s);
  const double share = trust(by);
  if (index_ >= first_of_motion_) {
    Anchor& now = anchor(index_);
    now.tick_s = time_s;
    now.tick_from_mm = newest.position_mm;
    now.tick_by_mm = by;
    now.has_tick = true;
  }
  for (std::size_t a = 0; a < axes_; ++a) {
    if (std::isfinite(by[a])) out[a] += share * by[a];
  }
  return out;
}

Position ExpertPredictor::velocity(double time_s) const {
  constexpr double kApart_s = 1e-3;
  if (history_.empty()) return {};
  const double age_s = std::max(time_s - history_.newest().date_s, kApart_s);
  if (!std::isfinite(age_s)) return {};
  Position out = moved(age_s);
  const double share = trust(out);
  const Position before = moved(age_s - kApart_s);
  for (std::size_t a = 0; a < kMostAxes; ++a) {
    out[a] = share * (out[a] - before[a]) / kApart_s;
    if (!std::isfinite(out[a])) out[a] = 0.0;
  }
  return out;
}

}  // namespace fyd::teleop
