#include "app/console/review/review_source.h"

#include <algorithm>
#include <cmath>

namespace fyd::console {
namespace {

constexpr double kLongestStep_s = 0.05;  // a longer time between two samples is a hole
constexpr std::size_t kTime = 0;         // of telemetryFields()

}  // namespace

std::size_t fieldIndex(const char* name) {
  const auto fields = pipeline::telemetryFields();
  const auto found = std::ranges::find(fields, std::string_view(name), &pipeline::TelemetryField::name);
  return static_cast<std::size_t>(found - fields.begin());
}

void ReviewSource::decimate(std::size_t channel, double from_s, double to_s, std::size_t columns,
                            std::vector<widgets::CurveColumn>& out) const {
  out.clear();
  const std::size_t layer = channel / widgets::kCurveChannels;
  const std::size_t quantity = channel % widgets::kCurveChannels;
  if (layer == static_cast<std::size_t>(ReviewLayer::what_if)) {
    if (what_if_ && quantity < what_if_->channels()) what_if_->decimate(quantity, from_s, to_s, columns, out);
    return;
  }
  const Layer& of = layers_[layer];
  if (of.recording == nullptr) return;
  const auto overview =
      of.recording->overview(widgets::curveFields()[quantity], from_s - of.later_by_s, to_s - of.later_by_s, columns);
  if (!overview) {
    problem_ = overview.error().message;
    return;
  }
  const double hole_s =
      std::max(kLongestStep_s, 3.0 * (to_s - from_s) / static_cast<double>(std::max<std::size_t>(1, columns)));
  for (std::size_t i = 0; i < overview->time_s.size(); ++i) {
    const double time_s = overview->time_s[i] + of.later_by_s;
    if (i > 0 && time_s - out.back().time_s > hole_s) {
      out.push_back({.time_s = out.back().time_s + 0.5 * hole_s, .gap = true, .empty = false});
    }
    const recording::MinMax& value = overview->values[i];
    out.push_back({.time_s = time_s,
                   .minimum = static_cast<float>(value.low),
                   .maximum = static_cast<float>(value.high),
                   .gap = std::isnan(value.low),
                   .empty = false});
  }
}

double ReviewSource::valueAt(std::size_t channel, double time_s) const {
  const std::size_t layer = channel / widgets::kCurveChannels;
  const std::size_t field = widgets::curveFields()[channel % widgets::kCurveChannels];
  if (layer >= layers_.size() || layers_[layer].recording == nullptr) return pipeline::kNone;
  const recording::Recording& recording = *layers_[layer].recording;
  const double at_s = time_s - layers_[layer].later_by_s;
  const auto next = recording.rowAt(justAfter(at_s));
  if (!next || *next == 0) return pipeline::kNone;
  double taken_s = pipeline::kNone, value = pipeline::kNone;  // of the last row before, in the clock's time
  for (const auto& [wanted, into] : {std::pair(kTime, &taken_s), std::pair(field, &value)}) {
    if (auto read = recording.field(wanted, *next - 1, {into, 1}); !read) {
      problem_ = read.error().message;
      return pipeline::kNone;
    }
  }
  const double started_s = toSeconds(recording.info().header.started.time_since_epoch());
  return at_s > taken_s - started_s + kLongestStep_s ? pipeline::kNone : value;
}

widgets::CurveRows ReviewSource::rows(std::span<const std::size_t> channels, double from_s, double to_s) const {
  widgets::CurveRows out;
  out.values.resize(channels.size());
  const std::size_t layer = channels.empty() ? layers_.size() : channels.front() / widgets::kCurveChannels;
  if (layer >= layers_.size() || layers_[layer].recording == nullptr) return out;
  const auto& recording = layers_[layer].recording;
  const double later_by_s = layers_[layer].later_by_s;
  const auto first = recording->rowAt(from_s - later_by_s);
  const auto end = recording->rowAt(justAfter(to_s - later_by_s));
  if (!first || !end || *end <= *first) return out;
  std::vector<double> column(static_cast<std::size_t>(*end - *first));
  const auto read = [&](std::size_t field) {
    const auto done = recording->field(field, *first, column);
    if (!done) problem_ = done.error().message;
    return done.has_value();
  };
  if (!read(kTime)) return out;
  const double started_s = toSeconds(recording->info().header.started.time_since_epoch());
  for (const double time_s : column) out.time_s.push_back(time_s - started_s + later_by_s);
  for (std::size_t c = 0; c < channels.size(); ++c) {
    if (!read(widgets::curveFields()[channels[c] % widgets::kCurveChannels])) return {};
    out.values[c].assign(column.begin(), column.end());
  }
  return out;
}

}  // namespace fyd::console
