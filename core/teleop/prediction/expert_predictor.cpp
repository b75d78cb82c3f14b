#include "core/teleop/prediction/expert_predictor.h"

#include <algorithm>
#include <cmath>

#include "core/base/portable_math.h"
#include "core/teleop/prediction/plain_predictors.h"

namespace fyd::teleop {
namespace {

constexpr double kNewAnchor = 0.7;     // of Δ: messages closer together share one
constexpr int kMostInCentre = 300;     // messages in the mean that is the centre of a motion
constexpr double kLossMemory = 0.99;   // per settled anchor
constexpr double kBeginLosses = 50.0;  // settled anchors that the initial losses are worth
constexpr int kSharpness = 4;          // the ratio of losses is raised to the power 2^kSharpness
constexpr double kRoom = 1.25;         // limit of a prediction: this times the largest motion seen over its horizon

// Initial losses as shares of hold's, in the order of the experts. The perceptron was trained on strokes in a plane, so
// motions with one or three axes give it a larger one.
constexpr std::array<double, 5> kBeginLoss = {1.0, 0.5, 0.3, 0.35, 0.35};
constexpr double kBeginLossOutOfPlane = 0.8;

constexpr std::array<ForecastSettings, 2> kMemories = {{
    {.order = 20, .smooth_s = 0.030, .far_lag_cost = 0.05},
    {.order = LinearForecast::kMostOrder, .smooth_s = 0.040, .far_lag_cost = 0.03},
}};

}  // namespace

ExpertPredictor::ExpertPredictor(std::size_t axes, Team team, std::shared_ptr<const StrokeWeights> weights)
    : axes_(axes), team_(team), learned_(std::move(weights)), history_(Horizons::kLeastStep_s / 4.0) {
  begin(Horizons::kLeastStep_s);
}

void ExpertPredictor::begin(double step_s) {
  for (std::size_t e = 0; e < kLinear; ++e) {
    for (LinearForecast& each : linear_[e]) each.begin(kMemories[e], step_s);
  }
  first_of_motion_ = index_ + 1;
  settled_ = settled_ticks_ = index_;
  furthest_mm_.fill(-1.0);
  trust_ = {};
  personal_.begin();
  loss_.fill(0.0);
  losses_ = 0.0;
  begin_losses_ = kBeginLosses;
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

void ExpertPredictor::watchCentre(const Position& position_mm) {
  in_centre_ = index_ + 1 == first_of_motion_ ? 1 : std::min(in_centre_ + 1, kMostInCentre);
  for (std::size_t a = 0; a < axes_; ++a) centre_mm_[a] += (position_mm[a] - centre_mm_[a]) / in_centre_;
}

void ExpertPredictor::chooseNodes() {
  const Horizons::Steps before = horizons_.steps();
  const Horizons::Steps* wanted = horizons_.choose();
  if (wanted == nullptr) return;
  keepFurthest(before, *wanted);
  personal_.setNodes(before, *wanted);
  for (auto& expert : linear_) {
    for (LinearForecast& each : expert) each.setNodes(*wanted);
  }
  for (Anchor& each : anchors_) each.said_all = false;
}

void ExpertPredictor::keepFurthest(const Horizons::Steps& before, const Horizons::Steps& wanted) {
  const auto known_mm = furthest_mm_;
  Horizons::Steps known = before;
  for (std::size_t node = 0; node < kNodes; ++node) {
    if (known_mm[node] < 0.0) known[node] = 0;
  }
  for (std::size_t node = 0; node < kNodes; ++node) {
    const std::size_t old = LinearForecast::nearest(known, wanted[node]);
    furthest_mm_[node] =
        old == kNodes ? -1.0 : known_mm[old] * std::max(1.0, static_cast<double>(wanted[node]) / known[old]);
  }
}

ExpertPredictor::FeatureSet ExpertPredictor::featuresAt(const DatedPosition& from) const {
  FeatureSet out{};
  Position later = from.position_mm;
  std::size_t place = 0;
  for (std::size_t k = 0; k + 1 < LinearForecast::kMostOrder; ++k) {
    const double date_s = from.date_s - static_cast<double>(k + 1) * horizons_.step_s();
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

ExpertPredictor::Opinions ExpertPredictor::opinionsAt(const DatedPosition& from, const FeatureSet& features,
                                                      StrokeForecast& learned) const {
  Opinions out{};
  const Position slope = newestSlope(history_, std::max(PlainPredictor::kSlopeWindow_s, newestSpacing(history_)));
  if (team_ == Team::all) learned = learned_.look(history_, from);
  const PersonalLayer::Differences own = personal_(learned.hidden());
  for (std::size_t node = 0; node < kNodes; ++node) {
    if (horizons_.steps()[node] == 0) continue;
    const double horizon_s = horizons_.steps()[node] * horizons_.step_s();
    const Position usual = learned.displacement(horizon_s), besides = learned.outOfPlane(own[node]);
    for (std::size_t a = 0; a < axes_; ++a) {
      out[kOrder1][node][a] = slope[a] * horizon_s;
      out[kLearned][node][a] = usual[a] + besides[a];
      for (std::size_t e = 0; e < kLinear; ++e) {
        out[kFirstLinear + e][node][a] = linear_[e][a].forecast(node, features[a]);
      }
    }
  }
  return out;
}

void ExpertPredictor::settleAnchors() {
  const int longest = *std::ranges::max_element(horizons_.steps());
  if (longest == 0) return;
  const double known_s = history_.newest().date_s - (longest - 0.02) * horizons_.step_s();
  const long before = settled_;
  settled_ = std::max(settled_, index_ - static_cast<long>(kKept));
  while (settled_ < index_ && anchor(settled_ + 1).date_s <= known_s) settle(anchor(++settled_));
  if (settled_ != before) weigh();
}

void ExpertPredictor::settle(const Anchor& then) {
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
    furthest_mm_[node] = std::max(furthest_mm_[node], std::sqrt(squares));
  }
  for (auto& expert : linear_) {
    for (std::size_t a = 0; a < axes_; ++a) expert[a].learn(then.features[a], of_axis[a]);
  }
  if (!then.said_all) return;
  if (team_ == Team::all) {
    PersonalLayer::Differences differences{};
    for (std::size_t node = 0; node < kNodes; ++node) {
      if (horizons_.steps()[node] == 0) continue;
      Position apart = then.learned.displacement(horizons_.steps()[node] * horizons_.step_s());
      for (std::size_t a = 0; a < axes_; ++a) apart[a] = displacement[node][a] - apart[a];
      differences[node] = then.learned.inPlane(apart);
    }
    personal_.learn(then.learned.hidden(), differences);
  }
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
    if (!history_.knows(then.tick_s, Horizons::kLonger * horizons_.step_s())) continue;
    Position came = history_.at(then.tick_s);
    for (std::size_t a = 0; a < kMostAxes; ++a) came[a] -= then.tick_from_mm[a];
    trust_.settle(then.tick_by_mm, came);
  }
}

double ExpertPredictor::believed(const Position& by_mm) const {
  if (!(losses_ > 0.0)) return trust_.first(by_mm);
  return trust_.now(loss_[kHold] / losses_, begin_losses_ / kBeginLosses, horizons_.mostAge_s());
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
  double came = 0.0;  // in this motion, altogether
  for (std::size_t a = 0; a < axes_; ++a) {
    came += math::square(history_.newest().position_mm[a] - history_.oldest().position_mm[a]);
  }
  came = std::sqrt(came);
  for (std::size_t node = 0; node < kNodes; ++node) {
    double squares = 0.0;
    for (std::size_t a = 0; a < axes_; ++a) {
      for (std::size_t e = 0; e < kExperts; ++e) out[node][a] += weight_[e] * opinions[e][node][a];
      squares += out[node][a] * out[node][a];
    }
    const double most = kRoom * (furthest_mm_[node] < 0.0 ? came : furthest_mm_[node]);
    if (squares > most * most) {
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
  if (horizons_.watchSpacing(date_s - before_s)) begin(horizons_.step_s());
  if (index_ >= first_of_motion_ && date_s - anchor(index_).date_s < kNewAnchor * horizons_.step_s()) return;
  watchCentre(position_mm);
  const FeatureSet features = featuresAt(history_.newest());
  for (auto& expert : linear_) {
    for (std::size_t a = 0; a < axes_; ++a) expert[a].watch(features[a][0]);
  }
  double step_mm2 = 0.0, bend_mm2 = 0.0;
  for (std::size_t a = 0; a < axes_; ++a) {
    step_mm2 += math::square(features[a][0]);
    bend_mm2 += math::square(features[a][0] - features[a][1]);
  }
  trust_.watch(step_mm2, bend_mm2);
  settleAnchors();
  settleTicks();
  chooseNodes();
  Anchor& now = anchor(++index_);
  now.date_s = date_s;
  now.position_mm = position_mm;
  now.features = features;
  now.said = opinionsAt(history_.newest(), features, now.learned);
  now.said_all = true;
  now.has_tick = false;
  displaced_ = mixed(now.said);
  stale_ = false;
}

Position ExpertPredictor::moved(double age_s) const {
  // Lagrange's polynomial through 0 at age 0 and the nodes; beyond the last one linear with half of its chord's slope.
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
  // First the limit of acceleration relative to the newest messages' slope, then the limit of speed.
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
  if (horizons_.watchAge(age_s)) {
    chooseNodes();
    stale_ = true;
  }
  if (age_s <= 0.0) return newest.position_mm;  // dated in the future: the clocks differ
  if (stale_ && history_.size() > 1) {
    StrokeForecast learned;
    displaced_ = mixed(opinionsAt(newest, featuresAt(newest), learned));
  }
  stale_ = false;
  Position out = newest.position_mm;
  const Position by = withinHandLimits(moved(age_s), age_s);
  const double share = believed(by);
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
  const double share = believed(out);
  const Position before = moved(age_s - kApart_s);
  for (std::size_t a = 0; a < kMostAxes; ++a) {
    out[a] = share * (out[a] - before[a]) / kApart_s;
    if (!std::isfinite(out[a])) out[a] = 0.0;
  }
  return out;
}

}  // namespace fyd::teleop
