#include "core/teleop/prediction/personal_layer.h"

#include <algorithm>
#include <cmath>

namespace fyd::teleop {
namespace {

constexpr float kInitialVariance = 1.0F / 200.0F;  // of P
constexpr float kForgetting = 0.9998F;             // per message
constexpr float kErrorFloor = 0.1F;                // in the motion's scale; the 0.1 of the weight
constexpr float kLargestLayerVariance = 1.0F;      // of P: above it P has diverged

}  // namespace

void PersonalLayer::begin() {
  weights_ = {};
  beginCovariance();
}

void PersonalLayer::beginCovariance() {
  covariance_.fill(0.0F);
  for (std::size_t i = 0; i < kInputs; ++i) covariance_[i * kInputs + i] = kInitialVariance;
}

void PersonalLayer::setNodes(const Horizons::Steps& before, const Horizons::Steps& steps) {
  const auto old_weights = weights_;
  for (std::size_t node = 0; node < steps.size(); ++node) {
    for (Differences& each : weights_) each[node] = {};
    const std::size_t old = LinearForecast::nearest(before, steps[node]);
    if (steps[node] == 0 || old == before.size()) continue;
    for (std::size_t i = 0; i < kInputs; ++i) weights_[i][node] = old_weights[i][old];
  }
}

void PersonalLayer::learn(const Inputs& inputs, const Differences& differences) {
  Inputs gain{};
  for (std::size_t k = 0; k < kInputs; ++k) {  // P is symmetric: its rows are its columns
    const float* row = covariance_.data() + k * kInputs;
    for (std::size_t i = 0; i < kInputs; ++i) gain[i] += inputs[k] * row[i];
  }
  float input_variance = 0.0F;
  for (std::size_t i = 0; i < kInputs; ++i) input_variance += inputs[i] * gain[i];
  const PlaneVector& longest = differences[Horizons::kLongestNode];
  const float error_scale = kErrorFloor + std::sqrt(longest[0] * longest[0] + longest[1] * longest[1]);
  const float normaliser = 1.0F / (kForgetting * error_scale + input_variance);
  if (!(input_variance >= 0.0F) || !std::isfinite(normaliser) || !std::isfinite(error_scale)) {
    if (!(input_variance >= 0.0F) || !std::isfinite(input_variance)) beginCovariance();
    return;
  }
  const Differences forecasts = (*this)(inputs);
  Differences errors{};
  for (std::size_t node = 0; node < errors.size(); ++node) {
    for (std::size_t axis = 0; axis < 2; ++axis)
      errors[node][axis] = (differences[node][axis] - forecasts[node][axis]) * normaliser;
  }
  for (std::size_t i = 0; i < kInputs; ++i) {
    for (std::size_t node = 0; node < errors.size(); ++node) {
      for (std::size_t axis = 0; axis < 2; ++axis) weights_[i][node][axis] += gain[i] * errors[node][axis];
    }
  }
  constexpr float kInflation = 1.0F / kForgetting;
  float largest = 0.0F;
  for (std::size_t k = 0; k < kInputs; ++k) {
    float* row = covariance_.data() + k * kInputs;
    const float share = gain[k] * normaliser;
    for (std::size_t i = 0; i < kInputs; ++i) row[i] = (row[i] - share * gain[i]) * kInflation;
    largest = std::max(largest, row[k]);
  }
  if (!(largest < kLargestLayerVariance)) beginCovariance();
}

PersonalLayer::Differences PersonalLayer::operator()(const Inputs& inputs) const {
  Differences out{};
  for (std::size_t i = 0; i < kInputs; ++i) {
    for (std::size_t node = 0; node < out.size(); ++node) {
      for (std::size_t axis = 0; axis < 2; ++axis) out[node][axis] += weights_[i][node][axis] * inputs[i];
    }
  }
  return out;
}

}  // namespace fyd::teleop
