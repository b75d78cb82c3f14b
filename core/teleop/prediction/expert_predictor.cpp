#include "core/teleop/prediction/expert_predictor.h"

#include <algorithm>
#include <cmath>

#include "core/base/portable_math.h"
#include "core/teleop/prediction/plain_predictors.h"

namespace fyd::teleop {
namespace {

constexpr double kAnchorSpacing = 0.7;       // least spacing of anchors, in Δ
constexpr int kCentreMessages = 300;         // length of the running mean that is a motion's centre
constexpr double kLossForgetting = 0.99;     // per evaluated anchor
constexpr double kInitialLossCount = 50.0;   // weight of the initial losses, in evaluated anchors
constexpr int kWeightDoublings = 4;          // weight: (smallest loss / loss)^(2^kWeightDoublings)
constexpr double kDisplacementLimit = 1.25;  // of a prediction, times the largest motion over its horizon

// Initial losses relative to hold's, in the order of the experts. The perceptron was trained on strokes in a plane:
// with one or three axes its initial loss is larger.
constexpr std::array<double, 5> kInitialLoss = {1.0, 0.5, 0.3, 0.35, 0.35};
constexpr double kInitialLossOutOfPlane = 0.8;

/// Medium and long memory.
constexpr std::array<ForecastSettings, 2> kLinearSettings = {{
    {.order = 20, .prior_correlation_s = 0.030, .prior_noise_per_lag = 0.05},
    {.order = LinearForecast::kMostOrder, .prior_correlation_s = 0.040, .prior_noise_per_lag = 0.03},
}};

}  // namespace

ExpertPredictor::ExpertPredictor(std::size_t axes, ExpertSet experts, std::shared_ptr<const StrokeWeights> weights)
    : axes_(axes), experts_(experts), learned_(std::move(weights)), history_(Horizons::kLeastStep_s / 4.0) {
  begin(Horizons::kLeastStep_s);
}

void ExpertPredictor::begin(double step_s) {
  for (std::size_t e = 0; e < kLinear; ++e) {
    for (LinearForecast& each : linear_[e]) each.begin(kLinearSettings[e], step_s);
  }
  first_of_motion_ = index_ + 1;
  evaluated_ = evaluated_ticks_ = index_;
  largest_mm_.fill(-1.0);
  trust_ = {};
  personal_.begin();
  loss_.fill(0.0);
  loss_count_ = 0.0;
  initial_loss_count_ = kInitialLossCount;
  displacements_ = {};
  updateWeights();
}

void ExpertPredictor::endMotion() {
  history_.clear();
  first_of_motion_ = index_ + 1;
  evaluated_ = evaluated_ticks_ = index_;
  displacements_ = {};
  stale_ = false;
}

void ExpertPredictor::updateCentre(const Position& position_mm) {
  centre_count_ = index_ + 1 == first_of_motion_ ? 1 : std::min(centre_count_ + 1, kCentreMessages);
  for (std::size_t a = 0; a < axes_; ++a) centre_mm_[a] += (position_mm[a] - centre_mm_[a]) / centre_count_;
}

void ExpertPredictor::chooseNodes() {
  const Horizons::Steps before = horizons_.steps();
  const Horizons::Steps* wanted = horizons_.choose();
  if (wanted == nullptr) return;
  transferLargest(before, *wanted);
  personal_.setNodes(before, *wanted);
  for (auto& expert : linear_) {
    for (LinearForecast& each : expert) each.setNodes(*wanted);
  }
  for (Anchor& each : anchors_) each.forecasts_complete = false;
}

void ExpertPredictor::transferLargest(const Horizons::Steps& before, const Horizons::Steps& wanted) {
  const auto known_mm = largest_mm_;
  Horizons::Steps known = before;
  for (std::size_t node = 0; node < kNodes; ++node) {
    if (known_mm[node] < 0.0) known[node] = 0;
  }
  for (std::size_t node = 0; node < kNodes; ++node) {
    const std::size_t old = LinearForecast::nearest(known, wanted[node]);
    largest_mm_[node] =
        old == kNodes ? -1.0 : known_mm[old] * std::max(1.0, static_cast<double>(wanted[node]) / known[old]);
  }
}

ExpertPredictor::FeatureSet ExpertPredictor::featuresAt(const DatedPosition& from) const {
  FeatureSet out{};
  Position later = from.position_mm;
  std::size_t search_index = 0;
  for (std::size_t k = 0; k + 1 < LinearForecast::kMostOrder; ++k) {
    const double date_s = from.date_s - static_cast<double>(k + 1) * horizons_.step_s();
    const Position each = history_.at(date_s, search_index);
    for (std::size_t a = 0; a < axes_; ++a) out[a][k] = later[a] - each[a];
    later = each;
    if (search_index + 1 >= history_.size() && history_.oldest().date_s > date_s) break;  // no older messages
  }
  for (std::size_t a = 0; a < axes_; ++a) {
    out[a].back() = LinearForecast::kCentreScale * (from.position_mm[a] - centre_mm_[a]);
  }
  return out;
}

ExpertPredictor::Forecasts ExpertPredictor::forecastsAt(const DatedPosition& from, const FeatureSet& features,
                                                        StrokeForecast& learned) const {
  Forecasts out{};
  const Position slope = newestSlope(history_, std::max(PlainPredictor::kSlopeWindow_s, newestSpacing(history_)));
  if (experts_ == ExpertSet::all) learned = learned_.forecastFrom(history_, from);
  const PersonalLayer::Differences own = personal_(learned.hidden());
  for (std::size_t node = 0; node < kNodes; ++node) {
    if (horizons_.steps()[node] == 0) continue;
    const double horizon_s = horizons_.steps()[node] * horizons_.step_s();
    const Position general = learned.displacement(horizon_s), correction = learned.fromMotionFrame(own[node]);
    for (std::size_t a = 0; a < axes_; ++a) {
      out[kOrder1][node][a] = slope[a] * horizon_s;
      out[kLearned][node][a] = general[a] + correction[a];
      for (std::size_t e = 0; e < kLinear; ++e) {
        out[kFirstLinear + e][node][a] = linear_[e][a].forecast(node, features[a]);
      }
    }
  }
  return out;
}

void ExpertPredictor::evaluateAnchors() {
  const int longest = *std::ranges::max_element(horizons_.steps());
  if (longest == 0) return;
  const double known_s = history_.newest().date_s - (longest - 0.02) * horizons_.step_s();
  const long before = evaluated_;
  evaluated_ = std::max(evaluated_, index_ - static_cast<long>(kAnchorCapacity));
  while (evaluated_ < index_ && anchor(evaluated_ + 1).date_s <= known_s) evaluate(anchor(++evaluated_));
  if (evaluated_ != before) updateWeights();
}

void ExpertPredictor::evaluate(const Anchor& then) {
  std::array<Position, kNodes> displacement{};
  std::array<std::array<double, kNodes>, kMostAxes> of_axis{};
  for (std::size_t node = 0; node < kNodes; ++node) {
    if (horizons_.steps()[node] == 0) continue;
    const Position now = history_.at(then.date_s + horizons_.steps()[node] * horizons_.step_s());
    double squares = 0.0;
    for (std::size_t a = 0; a < axes_; ++a) {
      of_axis[a][node] = displacement[node][a] = now[a] - then.position_mm[a];
      squares += displacement[node][a] * displacement[node][a];
    }
    largest_mm_[node] = std::max(largest_mm_[node], std::sqrt(squares));
  }
  for (auto& expert : linear_) {
    for (std::size_t a = 0; a < axes_; ++a) expert[a].learn(then.features[a], of_axis[a]);
  }
  if (!then.forecasts_complete) return;
  if (experts_ == ExpertSet::all) {
    PersonalLayer::Differences differences{};
    for (std::size_t node = 0; node < kNodes; ++node) {
      if (horizons_.steps()[node] == 0) continue;
      Position apart = then.learned.displacement(horizons_.steps()[node] * horizons_.step_s());
      for (std::size_t a = 0; a < axes_; ++a) apart[a] = displacement[node][a] - apart[a];
      differences[node] = then.learned.toMotionFrame(apart);
    }
    personal_.learn(then.learned.hidden(), differences);
  }
  loss_count_ = loss_count_ * kLossForgetting + 1.0;
  initial_loss_count_ *= kLossForgetting;
  for (std::size_t e = 0; e < kExperts; ++e) {
    double squares = 0.0;
    for (std::size_t node = 0; node < kNodes; ++node) {
      for (std::size_t a = 0; a < axes_; ++a) {
        const double error = then.forecasts[e][node][a] - displacement[node][a];
        squares += error * error;
      }
    }
    loss_[e] = loss_[e] * kLossForgetting + squares;
  }
}

void ExpertPredictor::evaluateTicks() {
  const double newest_s = history_.newest().date_s;
  evaluated_ticks_ = std::max(evaluated_ticks_, index_ - static_cast<long>(kAnchorCapacity));
  for (; evaluated_ticks_ < index_; ++evaluated_ticks_) {
    const Anchor& then = anchor(evaluated_ticks_ + 1);
    if (!then.has_tick) continue;
    if (then.tick_s > newest_s) break;
    if (!history_.hasCloseMessages(then.tick_s, Horizons::kLossSpacing * horizons_.step_s())) continue;
    Position travelled = history_.at(then.tick_s);
    for (std::size_t a = 0; a < kMostAxes; ++a) travelled[a] -= then.tick_origin_mm[a];
    trust_.addOutcome(then.tick_displacement_mm, travelled);
  }
}

double ExpertPredictor::trustFactor(const Position& by_mm) const {
  if (!(loss_count_ > 0.0)) return trust_.initialFactor(by_mm);
  return trust_.factor(loss_[kHold] / loss_count_, initial_loss_count_ / kInitialLossCount,
                       horizons_.agePercentile95_s());
}

void ExpertPredictor::updateWeights() {
  weight_.fill(0.0);
  if (experts_ == ExpertSet::ar) {
    weight_[kFirstLinear] = 1.0;
    return;
  }
  const double unit = loss_count_ > 0.0 ? loss_[kHold] / loss_count_ + 1e-9 : 1.0;
  std::array<double, kExperts> total{};
  double least = 0.0;
  for (std::size_t e = 0; e < kExperts; ++e) {
    total[e] = loss_[e] +
               initial_loss_count_ * unit * (e == kLearned && axes_ != 2 ? kInitialLossOutOfPlane : kInitialLoss[e]);
    if (e == 0 || total[e] < least) least = total[e];
  }
  double sum = 0.0;
  for (std::size_t e = 0; e < kExperts; ++e) {
    // The least itself is 1, also where it is 0: of a hand that never moved. A loss that is no number stays none.
    double share = total[e] == least ? 1.0 : least / total[e];
    for (int doubling = 0; doubling < kWeightDoublings; ++doubling) share *= share;
    weight_[e] = share;
    sum += share;
  }
  for (double& each : weight_) each /= sum;
}

ExpertPredictor::Displacements ExpertPredictor::combined(const Forecasts& forecasts) const {
  Displacements out{};
  double travelled = 0.0;  // distance of the newest message from the motion's oldest, mm
  for (std::size_t a = 0; a < axes_; ++a) {
    travelled += math::square(history_.newest().position_mm[a] - history_.oldest().position_mm[a]);
  }
  travelled = std::sqrt(travelled);
  for (std::size_t node = 0; node < kNodes; ++node) {
    double squares = 0.0;
    for (std::size_t a = 0; a < axes_; ++a) {
      for (std::size_t e = 0; e < kExperts; ++e) out[node][a] += weight_[e] * forecasts[e][node][a];
      squares += out[node][a] * out[node][a];
    }
    const double most = kDisplacementLimit * (largest_mm_[node] < 0.0 ? travelled : largest_mm_[node]);
    if (squares > most * most) {
      for (double& each : out[node]) each *= most / std::sqrt(squares);
    }
  }
  return out;
}

void ExpertPredictor::message(double date_s, const Position& position_mm) {
  if (!MotionHistory::valid(date_s, position_mm)) return;
  const bool silent = !history_.empty() && date_s - history_.newest().date_s > kSilence_s;
  if (silent) endMotion();
  const double before_s = history_.empty() ? 0.0 : history_.newest().date_s;
  const bool first = history_.empty();
  const MotionHistory::Insertion taken = history_.insert(date_s, position_mm);
  if (taken == MotionHistory::Insertion::refused) return;
  stale_ = true;
  if (taken == MotionHistory::Insertion::out_of_order || first) return;
  if (horizons_.updateSpacing(date_s - before_s)) begin(horizons_.step_s());
  if (index_ >= first_of_motion_ && date_s - anchor(index_).date_s < kAnchorSpacing * horizons_.step_s()) return;
  updateCentre(position_mm);
  const FeatureSet features = featuresAt(history_.newest());
  for (auto& expert : linear_) {
    for (std::size_t a = 0; a < axes_; ++a) expert[a].updatePower(features[a][0]);
  }
  double first_mm2 = 0.0, second_mm2 = 0.0;
  for (std::size_t a = 0; a < axes_; ++a) {
    first_mm2 += math::square(features[a][0]);
    second_mm2 += math::square(features[a][0] - features[a][1]);
  }
  trust_.addDifferences(first_mm2, second_mm2);
  evaluateAnchors();
  evaluateTicks();
  chooseNodes();
  Anchor& now = anchor(++index_);
  now.date_s = date_s;
  now.position_mm = position_mm;
  now.features = features;
  now.forecasts = forecastsAt(history_.newest(), features, now.learned);
  now.forecasts_complete = true;
  now.has_tick = false;
  displacements_ = combined(now.forecasts);
  stale_ = false;
}

Position ExpertPredictor::displacementAt(double age_s) const {
  // Lagrange polynomial through 0 at age 0 and the nodes. Beyond the longest node: extrapolated at half the slope
  // between the shortest and the longest node, less with the distance.
  std::array<double, kNodes + 1> at{};
  std::array<const Position*, kNodes + 1> to{};
  static constexpr Position kNothing{};
  to[0] = &kNothing;
  std::size_t points = 1;
  double last_s = 0.0;
  for (std::size_t node = 0; node < kNodes; ++node) {
    if (horizons_.steps()[node] == 0) continue;
    at[points] = horizons_.steps()[node] * horizons_.step_s();
    last_s = std::max(last_s, at[points]);
    to[points++] = &displacements_[node];
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
  // First limit the acceleration relative to motion at the newest slope, then the speed.
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
  by = shorten(straight, by, 0.5 * kLargestHandAcceleration_mm_per_s2 * age_s * age_s);
  return shorten({}, by, kLargestHandSpeed_mm_per_s * age_s);
}

Position ExpertPredictor::predict(double time_s) {
  if (history_.empty()) return {};
  const DatedPosition& newest = history_.newest();
  const double age_s = time_s - newest.date_s;
  if (!std::isfinite(age_s)) return newest.position_mm;
  if (horizons_.updateAge(age_s)) {
    chooseNodes();
    stale_ = true;
  }
  if (age_s <= 0.0) return newest.position_mm;  // the date is in the future: the clocks differ
  if (stale_ && history_.size() > 1) {
    StrokeForecast learned;
    displacements_ = combined(forecastsAt(newest, featuresAt(newest), learned));
  }
  stale_ = false;
  Position out = newest.position_mm;
  const Position by = withinHandLimits(displacementAt(age_s), age_s);
  // Held, and kept from the trust, which would never forget it.
  if (!std::ranges::all_of(by, [](double each) { return std::isfinite(each); })) return out;
  const double share = trustFactor(by);
  if (index_ >= first_of_motion_) {
    Anchor& now = anchor(index_);
    now.tick_s = time_s;
    now.tick_origin_mm = newest.position_mm;
    now.tick_displacement_mm = by;
    now.has_tick = true;
  }
  for (std::size_t a = 0; a < axes_; ++a) out[a] += share * by[a];
  return out;
}

Position ExpertPredictor::velocity(double time_s) const {
  constexpr double kApart_s = 1e-3;
  if (history_.empty()) return {};
  double age_s = time_s - history_.newest().date_s;
  if (!std::isfinite(age_s) || age_s < 0.0) return {};  // the prediction is held there
  age_s = std::max(age_s, kApart_s);
  Position out = displacementAt(age_s);
  const double share = trustFactor(out);
  const Position before = displacementAt(age_s - kApart_s);
  for (std::size_t a = 0; a < kMostAxes; ++a) {
    out[a] = share * (out[a] - before[a]) / kApart_s;
    if (!std::isfinite(out[a])) out[a] = 0.0;
  }
  return out;
}

}  // namespace fyd::teleop
