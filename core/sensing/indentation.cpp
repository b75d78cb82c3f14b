#include "core/sensing/indentation.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/portable_math.h"

namespace fyd::sensing {
namespace {

constexpr std::uint32_t kFewestForMembrane = 2;  // so that one can contradict the other
constexpr double kInconsistent = 4.0;            // squared standard deviations
constexpr std::uint32_t kStuckReadings = 60;     // 1 s at 60 Hz without one changed count …
constexpr double kStuckTravel_counts = 200.0;    // … while the others went this far
constexpr double kSeenDepthShare = 0.3;          // weight of a new reading: time constant 50 ms
constexpr double kLowest_mm = -20.0;
constexpr double kHighest_mm = 100.0;
constexpr double kLargestSigma_mm = 1e3;

std::uint32_t bitsBelow(std::uint32_t count) { return count >= 32 ? ~0U : (1U << count) - 1U; }

double at(const ParameterList& list, std::size_t i, double otherwise) {
  return i < list.size() && std::isfinite(list[i]) ? list[i] : otherwise;
}

}  // namespace

IndentationEstimator::IndentationEstimator(const IndentationParameters& parameters) { configure(parameters); }

void IndentationEstimator::configure(const IndentationParameters& parameters) {
  const bool mode_changed = parameters.mode != parameters_.mode;
  parameters_ = parameters;
  sensor_count_ = static_cast<std::uint32_t>(parameters.sensors());
  for (std::size_t i = 0; i < sensor_count_; ++i) {
    positions_[i] = {parameters.ir_x_mm[i], parameters.ir_y_mm[i]};
    curves_[i] = IrDistance(parameters.ir_curve_mm[i].view(), static_cast<int>(at(parameters.ir_lowest_code, i, 524)),
                            static_cast<int>(at(parameters.ir_highest_code, i, 3408)), parameters.ir_curve_form[i]);
  }
  membrane_ = Membrane(parameters.frame_half_width_mm, parameters.frame_half_depth_mm, parameters.finger_radius_mm);
  cloth_ = ContactCloth(parameters);
  filter_.configure(parameters.holding_mm_per_sqrt_s, parameters.moving_mm_per_sqrt_s);
  plane_mask_ = bitsBelow(sensor_count_);
  plane_.solve(std::span(positions_).first(sensor_count_), plane_mask_, parameters.ir_condition_limit);
  condition_number_ = plane_.conditionNumber();
  shapes_known_ = false;
  if (mode_changed) reset();
}

void IndentationEstimator::setMaximumAges(Duration ir, Duration finger) {
  ir_maximum_age_ = ir;
  finger_maximum_age_ = finger;
}

double IndentationEstimator::placeFactor() const {
  const bool known = parameters_.mode == IndentationMode::contact && touched_ && estimate_.available;
  return known ? 1.0 / relative_compliance_ : std::numeric_limits<double>::quiet_NaN();
}

void IndentationEstimator::tare(std::span<const double> offset_mm) {
  parameters_.ir_offset_mm.clear();
  for (std::size_t i = 0; i < std::min<std::size_t>(sensor_count_, offset_mm.size()); ++i) {
    if (!parameters_.ir_offset_mm.push(offset_mm[i])) break;
  }
}

void IndentationEstimator::restartTouch() {
  filter_.restart();
  fusion_.restart();
  smoother_.restart();
  seen_depth_mm_ = 0.0;
}

void IndentationEstimator::reset() {
  restartTouch();
  touched_ = false;
  last_count_ = 0;
  unchanged_ = {};
  others_travel_ = {};
  readings_ = {};
  estimate_ = {};
  // What only contact mode learns: after it, the other modes would go on with the last finger's.
  relative_compliance_ = 1.0;
  relative_sigma_ = kShapeError;
  log_compliance_sigma_ = 0.0;
}

IndentationEstimate IndentationEstimator::step(Instant now, const Timed<IrCounts>& ir,
                                               const Timed<FingerDetection>& finger, const Timed<double>& force_N) {
  fusion_.takeForce(force_N);
  estimate_.sensors = sensor_count_;
  estimate_.available = false;
  if (ir.freshness(now, ir_maximum_age_) != Freshness::fresh) {
    estimate_.valid = {};
    estimate_.distance_mm.fill(std::numeric_limits<double>::quiet_NaN());
    estimate_.reason = IndentationReason::ir_stale;
    return estimate_;
  }
  const bool new_readings = ir.count != last_count_;
  const double dt_s = toSeconds(ir.taken - estimate_.taken);
  last_count_ = ir.count;
  if (new_readings) readSensors(ir.value);
  estimate_.taken = ir.taken;
  estimate_.count = ir.count;

  const FingerDetection& seen = finger.value;
  if (finger.freshness(now, finger_maximum_age_) != Freshness::fresh ||
      (seen.contact && !(std::isfinite(seen.x_mm) && std::isfinite(seen.y_mm)))) {
    estimate_.reason = IndentationReason::finger_stale;
    return estimate_;
  }
  const bool new_touch = seen.contact && !touched_;
  touched_ = seen.contact;
  estimate_.touched = seen.contact;
  if (!touched_) {
    estimate_.indentation_mm = 0.0;
    estimate_.sigma_mm = 0.0;
    estimate_.available = enoughSensors();
    estimate_.reason = estimate_.available ? IndentationReason::untouched : IndentationReason::too_few_sensors;
    return estimate_;
  }
  if (new_touch) restartTouch();
  if (new_readings || new_touch) {
    if (!enoughSensors()) {
      estimate_.reason = IndentationReason::too_few_sensors;
    } else if (parameters_.mode == IndentationMode::thesis) {
      stepThesis(seen);
    } else {
      if (parameters_.mode == IndentationMode::contact) {
        updateContact(new_touch ? 0.0 : dt_s, ir.taken, seen);
      } else {
        updateMembrane(new_touch ? 0.0 : dt_s, ir.taken, seen);
      }
      readFilters(now);
    }
  } else if (parameters_.mode != IndentationMode::thesis && was_readable_) {
    readFilters(now);
  } else {
    estimate_.available = was_available_;
    estimate_.reason = last_reason_;
  }
  was_available_ = estimate_.available;
  was_readable_ = estimate_.reason != IndentationReason::too_few_sensors;
  last_reason_ = estimate_.reason;
  return estimate_;
}

void IndentationEstimator::readSensors(const IrCounts& counts) {
  noticeStuck(counts);
  for (std::size_t i = 0; i < sensor_count_; ++i) {
    readSensor(i, i < counts.size() ? counts[i] : std::numeric_limits<double>::quiet_NaN());
  }
}

void IndentationEstimator::readSensor(std::size_t i, double code) {
  Reading& r = readings_[i];
  const double offset = at(parameters_.ir_offset_mm, i, std::numeric_limits<double>::quiet_NaN());
  r.ir = curves_[i].read(code);
  const bool stuck = unchanged_[i] >= kStuckReadings && others_travel_[i] >= kStuckTravel_counts;
  r.used = r.ir.valid && !stuck && std::isfinite(offset);
  r.z_mm = r.ir.distance_mm - offset;
  r.sigma_mm = std::max(r.ir.slope_mm_per_V * parameters_.ir_noise_mV * 1e-3, 0.01);
  estimate_.valid[i] = r.used;
  estimate_.distance_mm[i] = r.ir.distance_mm;
}

void IndentationEstimator::noticeStuck(const IrCounts& counts) {
  const std::size_t count = std::min<std::size_t>(sensor_count_, counts.size());
  double largest_move = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    largest_move = std::max(largest_move, std::abs(static_cast<double>(counts[i]) - last_codes_[i]));
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (counts[i] == last_codes_[i]) {
      unchanged_[i] = std::min(unchanged_[i] + 1, kStuckReadings);
      others_travel_[i] = std::min(others_travel_[i] + largest_move, kStuckTravel_counts);
    } else {
      unchanged_[i] = 0;
      others_travel_[i] = 0.0;
    }
    last_codes_[i] = counts[i];
  }
}

std::uint32_t IndentationEstimator::usedMask() const {
  std::uint32_t mask = 0;
  for (std::size_t i = 0; i < sensor_count_; ++i) mask |= readings_[i].used ? 1U << i : 0U;
  return mask;
}

bool IndentationEstimator::enoughSensors() {
  const std::uint32_t mask = usedMask();
  if (parameters_.mode != IndentationMode::thesis) {
    return static_cast<std::uint32_t>(std::popcount(mask)) >= kFewestForMembrane;
  }
  if (mask != plane_mask_) {
    plane_.solve(std::span(positions_).first(sensor_count_), mask, parameters_.ir_condition_limit);
    plane_mask_ = mask;
  }
  return plane_.usable();
}

void IndentationEstimator::updateMembrane(double dt_s, Instant taken, const FingerDetection& finger) {
  updateShapes(finger.x_mm, finger.y_mm);
  std::array<IndentationFilter::Measurement, kMaximumIrSensors> measurements;
  std::size_t count = 0;
  for (std::size_t i = 0; i < sensor_count_; ++i) {
    const Reading& r = readings_[i];
    if (r.used) measurements[count++] = {.z_mm = -r.z_mm, .h = shapes_[i], .sigma_mm = r.sigma_mm};
  }
  fusion_.update(dt_s, taken, std::span(measurements).first(count));
  filter_.update(dt_s, std::span(measurements).first(count));
  fusion_.compare(dt_s, filter_.value_mm(), filter_.sigma_mm());
}

Contact IndentationEstimator::contactOf(const FingerDetection& finger) const {
  const Contact seen{.x_mm = finger.x_mm, .y_mm = finger.y_mm, .area_mm2 = finger.area_mm2};
  if (parameters_.mode != IndentationMode::contact) return seen;
  Contact on_cloth = withoutPerspective(seen, seen_depth_mm_, parameters_.camera_height_mm);
  const double radius = on_cloth.area_mm2 > 0.0 ? std::sqrt(on_cloth.area_mm2 / std::numbers::pi) : 0.0;
  const double x = std::max(0.0, parameters_.frame_half_width_mm - radius);
  const double y = std::max(0.0, parameters_.frame_half_depth_mm - radius);
  on_cloth.x_mm = std::clamp(on_cloth.x_mm, -x, x);
  on_cloth.y_mm = std::clamp(on_cloth.y_mm, -y, y);
  return on_cloth;
}

void IndentationEstimator::updateContact(double dt_s, Instant taken, const FingerDetection& finger) {
  // Depth changes the place, place the compliance, and compliance the depth: near the frame this feedback is unstable
  // without the low-pass.
  seen_depth_mm_ += kSeenDepthShare * (estimate_.indentation_mm - seen_depth_mm_);
  cloth_.press(contactOf(finger), estimate_.indentation_mm);
  relative_compliance_ = cloth_.relativeCompliance();
  log_compliance_sigma_ = cloth_.logComplianceSigma();
  const double depth = filter_.value_mm();
  std::array<IndentationFilter::Measurement, kMaximumIrSensors> alone;
  std::array<IndentationFilter::Measurement, kMaximumIrSensors> with_force;
  std::array<double, kMaximumIrSensors> weights{};
  double information = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < sensor_count_; ++i) {
    const Reading& r = readings_[i];
    if (!r.used) continue;
    const double sigma = math::hypot(r.sigma_mm, depth * cloth_.shareSigma(i));
    alone[count] = {.z_mm = -r.z_mm, .h = cloth_.share(i), .sigma_mm = sigma};
    with_force[count] = {.z_mm = -r.z_mm, .h = cloth_.share(i) * relative_compliance_, .sigma_mm = sigma};
    ++count;
    weights[i] = cloth_.share(i) / (sigma * sigma);
    information += weights[i] * cloth_.share(i);
  }
  for (double& weight : weights) weight = information > 0.0 ? weight / information : 0.0;
  relative_sigma_ = cloth_.weightedSigma(std::span(weights).first(sensor_count_));
  fusion_.update(dt_s, taken, std::span(with_force).first(count));
  filter_.update(dt_s, std::span(alone).first(count));
  fusion_.compare(dt_s, filter_.value_mm() / relative_compliance_, filter_.sigma_mm() / relative_compliance_);
}

void IndentationEstimator::readFilters(Instant now) {
  const bool fused = fusion_.usable(now);
  const double value = fused ? relative_compliance_ * fusion_.indentation_mm() : filter_.value_mm();
  const double sigma = fused ? relative_compliance_ * fusion_.sigma_mm() : filter_.sigma_mm();
  const double relative_sigma = fused && parameters_.mode == IndentationMode::contact
                                    ? math::hypot(relative_sigma_, log_compliance_sigma_)
                                    : relative_sigma_;
  const double shape_error = relative_sigma * value;
  const double excess = std::max(1.0, filter_.disagreement());
  estimate_.indentation_mm = std::clamp(value, kLowest_mm, kHighest_mm);
  estimate_.sigma_mm = std::min(std::sqrt(sigma * sigma * excess + shape_error * shape_error), kLargestSigma_mm);
  estimate_.available = estimate_.sigma_mm <= parameters_.sigma_limit_mm;
  if (!estimate_.available) {
    estimate_.reason = IndentationReason::uncertain;
  } else if (excess > kInconsistent) {
    estimate_.reason = IndentationReason::inconsistent;
  } else {
    estimate_.reason =
        usedMask() == bitsBelow(sensor_count_) ? IndentationReason::measured : IndentationReason::some_invalid;
  }
}

void IndentationEstimator::stepThesis(const FingerDetection& finger) {
  const Depth plane = readPlane(finger.x_mm, finger.y_mm);
  estimate_.indentation_mm = std::clamp(smoother_.update(plane.indentation_mm), kLowest_mm, kHighest_mm);
  // Variance that remains after old·0.8 + new·0.2 of independent readings: 0.2/(2 − 0.2) of one reading's.
  constexpr double kNew = 1.0 - ThesisSmoother::kOldShare;
  estimate_.sigma_mm = std::min(std::sqrt(plane.variance_mm2 * kNew / (2.0 - kNew)), kLargestSigma_mm);
  estimate_.available = true;
  estimate_.reason =
      usedMask() == bitsBelow(sensor_count_) ? IndentationReason::measured : IndentationReason::some_invalid;
}

void IndentationEstimator::updateShapes(double x_mm, double y_mm) {
  if (shapes_known_ && x_mm == shapes_x_mm_ && y_mm == shapes_y_mm_) return;
  for (std::size_t i = 0; i < sensor_count_; ++i) {
    shapes_[i] = membrane_.shape(positions_[i].x_mm, positions_[i].y_mm, x_mm, y_mm);
  }
  shapes_x_mm_ = x_mm;
  shapes_y_mm_ = y_mm;
  shapes_known_ = true;
}

IndentationEstimator::Depth IndentationEstimator::readPlane(double x_mm, double y_mm) const {
  const PlaneWeights weights = plane_.weightsAt(x_mm, y_mm);
  Depth out;
  for (std::size_t i = 0; i < sensor_count_; ++i) {
    const Reading& r = readings_[i];
    if (!r.used) continue;
    out.indentation_mm -= weights.weight[i] * r.z_mm;
    out.variance_mm2 += weights.weight[i] * weights.weight[i] * r.sigma_mm * r.sigma_mm;
  }
  return out;
}

IndentationEstimator::Depth IndentationEstimator::readShares() const {
  double information = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < sensor_count_; ++i) {
    const Reading& r = readings_[i];
    if (!r.used) continue;
    const double weight = shapes_[i] / (r.sigma_mm * r.sigma_mm);
    information += weight * shapes_[i];
    sum -= weight * r.z_mm;
  }
  if (!(information > 0.0)) return {.variance_mm2 = std::numeric_limits<double>::infinity()};
  const double value = sum / information;
  return {.indentation_mm = value, .variance_mm2 = 1.0 / information + math::square(kShapeError * value)};
}

IndentationEstimator::Depth IndentationEstimator::readCloth(const Contact& contact) {
  std::array<Drop, kMaximumIrSensors> drops;
  for (std::size_t i = 0; i < sensor_count_; ++i) {
    const Reading& r = readings_[i];
    drops[i] = {.drop_mm = -r.z_mm, .sigma_mm = r.sigma_mm, .used = r.used};
  }
  const ClothDepth found = cloth_.solve(contact, std::span(drops).first(sensor_count_));
  return {.indentation_mm = found.indentation_mm, .variance_mm2 = found.variance_mm2};
}

IndentationEstimate IndentationEstimator::once(const PressReading& press) {
  reset();
  estimate_.sensors = sensor_count_;
  estimate_.touched = true;
  for (std::size_t i = 0; i < sensor_count_; ++i) {
    readSensor(i, i < press.codes.size() ? press.codes[i] : std::numeric_limits<double>::quiet_NaN());
  }
  Depth found{.variance_mm2 = std::numeric_limits<double>::infinity()};
  if (!std::isfinite(press.x_mm) || !std::isfinite(press.y_mm)) {
    estimate_.reason = IndentationReason::finger_stale;
  } else if (!enoughSensors()) {
    estimate_.reason = IndentationReason::too_few_sensors;
  } else if (parameters_.mode == IndentationMode::thesis) {
    found = readPlane(press.x_mm, press.y_mm);
  } else if (parameters_.mode == IndentationMode::membrane) {
    updateShapes(press.x_mm, press.y_mm);
    found = readShares();
  } else {
    found = readCloth({.x_mm = press.x_mm, .y_mm = press.y_mm, .area_mm2 = press.area_mm2});
  }
  if (std::isfinite(found.variance_mm2)) {
    estimate_.indentation_mm = std::clamp(found.indentation_mm, kLowest_mm, kHighest_mm);
    estimate_.sigma_mm = std::min(std::sqrt(found.variance_mm2), kLargestSigma_mm);
    estimate_.available = estimate_.sigma_mm <= parameters_.sigma_limit_mm;
    estimate_.reason = !estimate_.available                     ? IndentationReason::uncertain
                       : usedMask() == bitsBelow(sensor_count_) ? IndentationReason::measured
                                                                : IndentationReason::some_invalid;
  }
  const IndentationEstimate out = estimate_;
  reset();
  return out;
}

}  // namespace fyd::sensing
