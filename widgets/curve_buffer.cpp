#include "widgets/curve_buffer.h"

#include <algorithm>
#include <cmath>

namespace fyd::widgets {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr std::size_t kBlock = 65536;  // 16^4: every level divides the ring without a rest

std::size_t roundUp(std::size_t capacity) {
  return std::max<std::size_t>(1, (capacity + kBlock - 1) / kBlock) * kBlock;
}

}  // namespace

void CurveBuffer::Extent::add(float value) {
  if (!std::isfinite(value)) {
    gap = true;
    return;
  }
  minimum = std::min(minimum, value);
  maximum = std::max(maximum, value);
}

void CurveBuffer::Extent::add(const Extent& other) {
  minimum = std::min(minimum, other.minimum);
  maximum = std::max(maximum, other.maximum);
  gap = gap || other.gap;
}

CurveBuffer::CurveBuffer(std::size_t channels, std::size_t capacity, double longest_step_s)
    : times_(roundUp(capacity)), channels_(std::max<std::size_t>(1, channels)), longest_step_s_(longest_step_s) {
  hole_.assign(channels_.size(), kNaN);
  for (Channel& channel : channels_) {
    channel.values.assign(times_.size(), kNaN);
    for (std::size_t level = 1; level <= kLevels; ++level) {
      channel.levels.emplace_back(times_.size() >> (kShift * level));
    }
  }
}

bool CurveBuffer::append(double time_s, std::span<const float> values) {
  if (!std::isfinite(time_s) || values.size() != channels_.size()) return false;
  if (!empty()) {
    const double last_s = lastTime_s();
    if (time_s <= last_s) return false;
    // Just after the last sample, so that the line ends where the data end.
    if (time_s - last_s > longest_step_s_) store(last_s + 0.5 * longest_step_s_, hole_);
  }
  store(time_s, values);
  return true;
}

void CurveBuffer::store(double time_s, std::span<const float> values) {
  const auto position = static_cast<std::size_t>(next_ % times_.size());
  times_[position] = time_s;
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    Channel& channel = channels_[c];
    channel.values[position] = values[c];
    for (std::size_t level = 1; level <= kLevels; ++level) {
      Extent& extent = channel.levels[level - 1][position >> (kShift * level)];
      const std::size_t mask = (std::size_t{1} << (kShift * level)) - 1;
      if ((position & mask) == 0) extent = Extent{};  // the first sample of an entry forgets the ring's last round
      extent.add(values[c]);
    }
  }
  ++next_;
}

void CurveBuffer::clear() { next_ = 0; }

double CurveBuffer::firstTime_s() const {
  return empty() ? std::numeric_limits<double>::quiet_NaN() : timeOf(oldest());
}
double CurveBuffer::lastTime_s() const {
  return empty() ? std::numeric_limits<double>::quiet_NaN() : timeOf(next_ - 1);
}

float CurveBuffer::last(std::size_t channel) const {
  if (empty()) return kNaN;
  const float value = channels_[channel].values[static_cast<std::size_t>((next_ - 1) % times_.size())];
  return std::isfinite(value) ? value : kNaN;
}

std::uint64_t CurveBuffer::firstNotBefore(double time_s, std::uint64_t from) const {
  std::uint64_t to = next_;
  while (from < to) {
    const std::uint64_t middle = from + (to - from) / 2;
    if (timeOf(middle) < time_s) {
      from = middle + 1;
    } else {
      to = middle;
    }
  }
  return from;
}

CurveBuffer::Extent CurveBuffer::extent(const Channel& channel, std::uint64_t from, std::uint64_t to) const {
  Extent result;
  while (from < to) {
    // The largest entry that starts here and ends in time; the ring's size is a multiple of every entry's.
    std::size_t level = 0;
    while (level < kLevels) {
      const std::uint64_t wider = std::uint64_t{1} << (kShift * (level + 1));
      if (from % wider != 0 || from + wider > to) break;
      ++level;
    }
    const auto position = static_cast<std::size_t>(from % times_.size());
    if (level == 0) {
      result.add(channel.values[position]);
    } else {
      result.add(channel.levels[level - 1][position >> (kShift * level)]);
    }
    from += std::uint64_t{1} << (kShift * level);
  }
  return result;
}

void CurveBuffer::decimate(std::size_t channel, double from_s, double to_s, std::size_t columns,
                           std::vector<CurveColumn>& out) const {
  out.clear();
  if (columns == 0 || !std::isfinite(from_s) || !std::isfinite(to_s) || to_s <= from_s) return;
  const double width_s = (to_s - from_s) / static_cast<double>(columns);
  const double first_column = std::floor(from_s / width_s);
  std::uint64_t from = firstNotBefore(first_column * width_s, oldest());
  for (std::size_t i = 0; i <= columns; ++i) {
    const double left_s = (first_column + static_cast<double>(i)) * width_s;
    if (left_s > to_s) break;
    // Within a picture the search starts where the last column ended.
    const std::uint64_t to = firstNotBefore(left_s + width_s, from);
    CurveColumn column{.time_s = left_s + 0.5 * width_s};
    if (from < to) {
      const Extent found = extent(channels_[channel], from, to);
      column.empty = false;
      column.gap = found.gap;
      if (found.minimum <= found.maximum) {
        column.minimum = found.minimum;
        column.maximum = found.maximum;
      }
    }
    out.push_back(column);
    from = to;
  }
}

}  // namespace fyd::widgets
