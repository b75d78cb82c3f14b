#include "core/teleop/prediction/learned_forecast.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/portable_math.h"
#include "core/teleop/prediction/stroke_weights.h"

namespace fyd::teleop {
namespace {

constexpr double kLeastScale_mm = 0.05;
constexpr std::size_t kHeadingSteps = 3;  // newest steps whose sum is the first axis
constexpr double kLeastLength_mm = 1e-9;  // of a vector that has a direction

constexpr std::size_t kIn = StrokeWeights::kInputs, kHid = StrokeWeights::kHidden, kOut = StrokeWeights::kOutputs;
// Offset of each part in the file: W1 b1 W2 b2 W3 b3 L; matrices with one row per input.
constexpr std::size_t kW1 = 0, kB1 = kW1 + kIn * kHid, kW2 = kB1 + kHid, kB2 = kW2 + kHid * kHid, kW3 = kB2 + kHid,
                      kB3 = kW3 + kHid * kOut, kDirect = kB3 + kOut, kNumbers = kDirect + kIn * kOut;

/// out += in · matrix, row by row: this order lets the compiler vectorise without reordering any sum.
template <std::size_t kRows, std::size_t kColumns>
void addProduct(const std::array<float, kRows>& in, const float* matrix, std::array<float, kColumns>& out) {
  for (std::size_t i = 0; i < kRows; ++i) {
    const float x = in[i];
    if (x == 0.0F) continue;
    const float* row = matrix + i * kColumns;
    for (std::size_t k = 0; k < kColumns; ++k) out[k] += x * row[k];
  }
}

template <std::size_t kSize>
std::array<float, kSize> copied(const float* from) {
  std::array<float, kSize> out{};
  std::copy_n(from, kSize, out.begin());
  return out;
}

double dot(const Position& a, const Position& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double normalize(Position& v) {
  const double length = std::sqrt(dot(v, v));
  for (double& each : v) each = length > kLeastLength_mm ? each / length : 0.0;
  return length;
}

}  // namespace

Result<std::shared_ptr<const StrokeWeights>> StrokeWeights::parse(std::string_view text) {
  auto out = std::make_shared<StrokeWeights>();
  std::array<std::size_t, 3> shape{};
  std::size_t read = 0;
  const char* at = text.data();
  const char* end = at + text.size();
  while (at != end) {
    if (*at == '#') {
      at = std::find(at, end, '\n');
      continue;
    }
    if (*at == ' ' || *at == '\n' || *at == '\r') {
      ++at;
      continue;
    }
    float number = 0.0F;
    const auto [after, problem] = std::from_chars(at, end, number);
    const bool ended = after == end || std::string_view(" \n\r#").find(*after) != std::string_view::npos;
    const bool tame = read < shape.size() ? std::isfinite(number) : std::abs(number) <= kLargestWeight;
    if (problem != std::errc() || !ended || !tame) {
      return fail("perceptron: number {} is \"{}\"; expected one from {} to {}", read + 1,
                  std::string(at, std::find_if(at, end, [](char c) { return c == ' ' || c == '\n'; })), -kLargestWeight,
                  kLargestWeight);
    }
    at = after;
    if (read < shape.size()) {
      const bool count = number >= 0.0F && number < 1e6F && number == std::floor(number);
      shape[read] = count ? static_cast<std::size_t>(number) : 0;
    } else {
      out->numbers_.push_back(number);
    }
    ++read;
  }
  if (shape != std::array<std::size_t, 3>{kIn, kHid, kOut} || out->numbers_.size() != kNumbers) {
    return fail("perceptron: {} inputs, {} hidden units, {} outputs and {} weights; expected {}, {}, {} and {}",
                shape[0], shape[1], shape[2], out->numbers_.size(), kIn, kHid, kOut, kNumbers);
  }
  return out;
}

std::shared_ptr<const StrokeWeights> StrokeWeights::builtIn() {
  static const std::shared_ptr<const StrokeWeights> weights = parse(strokeWeightsText()).value();
  return weights;
}

StrokeWeights::Outputs StrokeWeights::operator()(const Inputs& inputs, Hidden& second) const {
  const float* w = numbers_.data();
  auto first = copied<kHid>(w + kB1);
  addProduct(inputs, w + kW1, first);
  for (float& each : first) each = std::max(each, 0.0F);
  second = copied<kHid>(w + kB2);
  addProduct(first, w + kW2, second);
  for (float& each : second) each = std::max(each, 0.0F);
  auto out = copied<kOut>(w + kB3);
  addProduct(second, w + kW3, out);
  addProduct(inputs, w + kDirect, out);
  return out;
}

StrokeForecast LearnedForecast::forecastFrom(const MotionHistory& history, const DatedPosition& from) const {
  StrokeForecast out;
  std::array<Position, StrokeWeights::kLags> steps{};
  Position later = from.position_mm, ahead{}, before{};
  std::size_t search_index = 0;
  double squares = 0.0;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const Position each = history.at(from.date_s - static_cast<double>(k + 1) * kStep_s, search_index);
    for (std::size_t a = 0; a < kMostAxes; ++a) {
      steps[k][a] = later[a] - each[a];
      (k < kHeadingSteps ? ahead : before)[a] += steps[k][a];
    }
    squares += dot(steps[k], steps[k]);
    later = each;
  }
  if (normalize(ahead) <= kLeastLength_mm) ahead = {1.0, 0.0, 0.0};
  const double along = dot(before, ahead);
  for (std::size_t a = 0; a < kMostAxes; ++a) before[a] -= along * ahead[a];
  normalize(before);
  const double scale_mm = std::sqrt(squares / static_cast<double>(steps.size())) + kLeastScale_mm;
  if (!std::isfinite(scale_mm)) return out;
  out.scale_mm_ = scale_mm;
  out.ahead_ = ahead;
  out.across_ = before;
  StrokeWeights::Inputs inputs{};
  for (std::size_t k = 0; k < steps.size(); ++k) {
    inputs[2 * k] = static_cast<float>(dot(steps[k], ahead) / scale_mm);
    inputs[2 * k + 1] = static_cast<float>(dot(steps[k], before) / scale_mm);
  }
  constexpr double kLongest_s = static_cast<double>(StrokeWeights::kLags) * kStep_s;
  inputs[kIn - 2] = static_cast<float>(math::log(scale_mm));
  inputs[kIn - 1] = static_cast<float>(std::min(from.date_s - history.oldest().date_s, kLongest_s) / kLongest_s);
  const StrokeWeights::Outputs outputs = (*weights_)(inputs, out.hidden_);
  for (std::size_t k = 0; k < StrokeWeights::kKnots; ++k) {
    for (std::size_t a = 0; a < kMostAxes; ++a) {
      out.knots_[k + 1][a] = scale_mm * (static_cast<double>(outputs[2 * k]) * ahead[a] +
                                         static_cast<double>(outputs[2 * k + 1]) * before[a]);
    }
  }
  return out;
}

std::array<float, 2> StrokeForecast::toMotionFrame(const Position& mm) const {
  return {static_cast<float>(dot(mm, ahead_) / scale_mm_), static_cast<float>(dot(mm, across_) / scale_mm_)};
}

Position StrokeForecast::fromMotionFrame(const std::array<float, 2>& in_plane) const {
  Position out{};
  for (std::size_t a = 0; a < kMostAxes; ++a) {
    out[a] = scale_mm_ * (static_cast<double>(in_plane[0]) * ahead_[a] + static_cast<double>(in_plane[1]) * across_[a]);
  }
  return out;
}

Position StrokeForecast::displacement(double horizon_s) const {
  // Cubic Lagrange interpolation of the four knots around the horizon; linear beyond the last knot.
  constexpr double kLast = StrokeWeights::kKnots;
  const double knot = std::min(horizon_s / LearnedForecast::kStep_s, kLast);
  const auto first = static_cast<std::size_t>(std::clamp(knot - 1.0, 0.0, kLast - 3.0));
  const double u = knot - static_cast<double>(first);
  const std::array<double, 4> share = {-(u - 1) * (u - 2) * (u - 3) / 6, u * (u - 2) * (u - 3) / 2,
                                       -u * (u - 1) * (u - 3) / 2, u * (u - 1) * (u - 2) / 6};
  const double beyond = 0.5 * std::max(0.0, horizon_s / LearnedForecast::kStep_s - kLast);
  Position out{};
  for (std::size_t a = 0; a < kMostAxes; ++a) {
    for (std::size_t i = 0; i < share.size(); ++i) out[a] += share[i] * knots_[first + i][a];
    out[a] += beyond * (knots_[StrokeWeights::kKnots][a] - knots_[StrokeWeights::kKnots - 1][a]);
  }
  return out;
}

}  // namespace fyd::teleop
