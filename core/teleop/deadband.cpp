#include "core/teleop/deadband.h"

#include <algorithm>
#include <cmath>

namespace fyd::teleop {
namespace {

constexpr std::uint32_t kMostAhead = 100'000;  // samples: a larger gap is an error, not a silence

bool finite(const DeadbandValues& values) {
  return std::ranges::all_of(values, [](double x) { return std::isfinite(x); });
}

}  // namespace

double DeadbandChannel::band(double value, double slope) const {
  return std::max(floor, fraction * (moves ? std::abs(slope) * kContinued_s : std::abs(value)));
}

DeadbandValues DeadbandSample::at(double time_s) const {
  DeadbandValues out = value;
  for (std::size_t i = 0; i < out.size(); ++i) out[i] += slope[i] * (time_s - date_s);
  return out;
}

std::optional<DeadbandPacket> DeadbandSender::step(double time_s, const DeadbandValues& values,
                                                   const DeadbandValues& slopes, bool must) {
  if (!std::isfinite(time_s)) return std::nullopt;
  const DeadbandSample& last = samples_[newest_ % samples_.size()];
  const DeadbandValues believed = last.at(time_s);
  DeadbandSample now{.number = newest_ + 1, .date_s = time_s, .value = believed, .slope = {}};
  bool changed = newest_ == 0 || must;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    const double band = channels_[i].band(last.value[i], last.slope[i]);
    changed = changed || !(std::abs(values[i] - believed[i]) <= band);
    now.value[i] = values[i];
    if (channels_[i].moves && std::isfinite(slopes[i])) now.slope[i] = slopes[i];
  }
  if (changed) {
    repeat_s_ = std::min(kFirstRepeat_s, refresh_s_);
  } else if (time_s - last.date_s < repeat_s_) {
    return std::nullopt;
  } else {
    repeat_s_ = std::min(2.0 * repeat_s_, refresh_s_);
  }
  ++newest_;
  samples_[newest_ % samples_.size()] = now;
  DeadbandPacket packet;
  const auto count = static_cast<std::uint32_t>(std::min<std::size_t>(newest_, history_));
  for (std::uint32_t n = newest_ - count + 1; n <= newest_; ++n)
    static_cast<void>(packet.push(samples_[n % samples_.size()]));
  return packet;
}

void DeadbandSender::told(const DeadbandValues& values, const DeadbandValues& slopes) {
  if (newest_ == 0 || !finite(values) || !finite(slopes)) return;
  samples_[newest_ % samples_.size()].value = values;
  samples_[newest_ % samples_.size()].slope = slopes;
}

void DeadbandReceiver::receive(const DeadbandPacket& packet) {
  std::uint32_t last = 0;
  for (const DeadbandSample& each : packet) {
    if (each.number <= last || !std::isfinite(each.date_s) || !finite(each.value) || !finite(each.slope)) return;
    last = each.number;
  }
  if (newest_ > 0 && last > newest_ && last - newest_ > kMostAhead) return;
  for (const DeadbandSample& each : packet) {
    if (newest_ >= kKept && each.number <= newest_ - kKept) continue;  // its slot holds a newer one
    samples_[each.number % kKept] = each;
    newest_ = std::max(newest_, each.number);
  }
}

const DeadbandSample* DeadbandReceiver::before(double time_s) const {
  const std::uint32_t oldest = newest_ >= kKept ? newest_ - kKept + 1 : 1;
  for (std::uint32_t n = newest_; n >= oldest && std::isfinite(time_s); --n) {
    if (kept(n).number == n && kept(n).date_s <= time_s) return &kept(n);
  }
  return nullptr;
}

const DeadbandSample* DeadbandReceiver::after(const DeadbandSample& sample) const {
  const DeadbandSample& next = kept(sample.number + 1);
  return sample.number < newest_ && next.number == sample.number + 1 ? &next : nullptr;
}

DeadbandReceiver::Answer DeadbandReceiver::at(double time_s) const {
  const DeadbandSample* last = before(time_s);
  if (last == nullptr) return {};
  // Between two consecutive samples all is known. A next one that is missing may have been sent before this moment.
  const bool known = after(*last) != nullptr || time_s == last->date_s;
  return {.value = last->at(time_s), .slope = last->slope, .known = known};
}

std::optional<double> DeadbandReceiver::place(double time_s, std::size_t channel,
                                              const DeadbandChannel& as_sent) const {
  if (channel >= kMostDeadbandChannels) return std::nullopt;
  const DeadbandSample* last = before(time_s);
  const DeadbandSample* next = last != nullptr ? after(*last) : nullptr;
  if (next == nullptr || !(next->date_s > last->date_s)) return std::nullopt;
  const double span_s = next->date_s - last->date_s, s = (time_s - last->date_s) / span_s;
  const double from = last->value[channel], to = next->value[channel];
  const double out = from * (1.0 + 2.0 * s) * (1.0 - s) * (1.0 - s) + to * s * s * (3.0 - 2.0 * s) +
                     span_s * s * (1.0 - s) * ((1.0 - s) * last->slope[channel] - s * next->slope[channel]);
  const double straight = last->at(time_s)[channel], band = as_sent.band(from, last->slope[channel]);
  if (!std::isfinite(out) || !std::isfinite(straight)) return std::nullopt;
  return std::clamp(out, straight - band, straight + band);
}

}  // namespace fyd::teleop
