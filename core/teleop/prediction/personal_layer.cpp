#include "core/teleop/prediction/personal_layer.h"

#include <algorithm>
#include <cmath>

namespace fyd::teleop {
namespace {

constexpr float kBegin = 1.0F / 200.0F;
constexpr float kForgetting = 0.9998F;  // per message
constexpr float kUsualError = 0.1F;     // of the motion's scale
constexpr float kMostCovariance = 1.0F;

}  // namespace

void PersonalLayer::begin() {
  weights_ = {};
  beginCovariance();
}

void PersonalLayer::beginCovariance() {
  covariance_.fill(0.0F);
  for (std::size_t i = 0; i < kInputs; ++i) covariance_[i * kInputs + i] = kBegin;
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
  float seen = 0.0F;
  for (std::size_t i = 0; i < kInputs; ++i) seen += inputs[i] * gain[i];
  const InPlane& far = differences[Horizons::kLongest];
  const float unusual = kUsualError + std::sqrt(far[0] * far[0] + far[1] * far[1]);
  const float per = 1.0F / (kForgetting * unusual + seen);
  if (!(seen >= 0.0F) || !std::isfinite(per) || !std::isfinite(unusual)) {
    if (!(seen >= 0.0F) || !std::isfinite(seen)) beginCovariance();
    return;
  }
  const Differences said = (*this)(inputs);
  Differences errors{};
  for (std::size_t node = 0; node < errors.size(); ++node) {
    for (std::size_t axis = 0; axis < 2; ++axis)
      errors[node][axis] = (differences[node][axis] - said[node][axis]) * per;
  }
  for (std::size_t i = 0; i < kInputs; ++i) {
    for (std::size_t node = 0; node < errors.size(); ++node) {
      for (std::size_t axis = 0; axis < 2; ++axis) weights_[i][node][axis] += gain[i] * errors[node][axis];
    }
  }
  constexpr float kBack = 1.0F / kForgetting;
  float largest = 0.0F;
  for (std::size_t k = 0; k < kInputs; ++k) {
    float* row = covariance_.data() + k * kInputs;
    const float share = gain[k] * per;
    for (std::size_t i = 0; i < kInputs; ++i) row[i] = (row[i] - share * gain[i]) * kBack;
    largest = std::max(largest, row[k]);
  }
  if (!(largest < kMostCovariance)) beginCovariance();
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
