#include "widgets/curves/curve_buffer.h"

#include <algorithm>
#include <cmath>

namespace fyd::widgets {
namespace {

constexpr float kNoSample = std::numeric_limits<float>::quiet_NaN();
constexpr std::size_t kBufferBlock = 65536;  // 16^4: the entries of every level divide the ring evenly

std::size_t roundUp(std::size_t capacity) {
  return std::max<std::size_t>(1, (capacity + kBufferBlock - 1) / kBufferBlock) * kBufferBlock;
}

}  // namespace

CurveBuffer::CurveBuffer(std::size_t channels, std::size_t capacity, double longest_step_s)
    : times_(roundUp(capacity)), channels_(std::max<std::size_t>(1, channels)), longest_step_s_(longest_step_s) {
  hole_.assign(channels_.size(), kNoSample);
  for (Channel& channel : channels_) {
    channel.values.assign(times_.size(), kNoSample);
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
  const std::size_t position = head_;
  times_[position] = time_s;
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    Channel& channel = channels_[c];
    channel.values[position] = values[c];
    for (std::size_t level = 1; level <= kLevels; ++level) {
      Extent& extent = channel.levels[level - 1][position >> (kShift * level)];
      const std::size_t mask = (std::size_t{1} << (kShift * level)) - 1;
      if ((position & mask) == 0) extent = Extent{};  // an entry's first sample overwrites the last round
      extent.add(values[c]);
    }
  }
  ++next_;
  if (++head_ == times_.size()) head_ = 0;
}

void CurveBuffer::clear() {
  next_ = 0;
  head_ = 0;
}

double CurveBuffer::firstTime_s() const {
  return empty() ? std::numeric_limits<double>::quiet_NaN() : timeOf(oldest());
}
double CurveBuffer::lastTime_s() const {
  return empty() ? std::numeric_limits<double>::quiet_NaN() : timeOf(next_ - 1);
}

float CurveBuffer::last(std::size_t channel) const {
  if (empty()) return kNoSample;
  const float value = channels_[channel].values[positionOf(next_ - 1)];
  return std::isfinite(value) ? value : kNoSample;
}

// Galloping search: steps that double, then bisection. Drawing asks for one column after the other, so the next is
// near.
std::uint64_t CurveBuffer::firstNotBefore(double time_s, std::uint64_t from) const {
  std::uint64_t to = from;
  for (std::uint64_t step = 1; to < next_ && timeOf(to) < time_s; step *= 2) {
    from = to + 1;
    to = std::min(next_, to + step);
  }
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

double CurveBuffer::valueAt(std::size_t channel, double time_s) const {
  if (!std::isfinite(time_s) || empty() || time_s > lastTime_s() + longest_step_s_) return kNoSample;
  const std::uint64_t after = firstNotBefore(std::nextafter(time_s, std::numeric_limits<double>::infinity()), oldest());
  if (after == oldest()) return kNoSample;
  return channels_[channel].values[positionOf(after - 1)];
}

CurveRows CurveBuffer::rows(std::span<const std::size_t> channels, double from_s, double to_s) const {
  CurveRows out;
  out.values.resize(channels.size());
  if (!std::isfinite(from_s) || !std::isfinite(to_s)) return out;
  for (std::uint64_t i = firstNotBefore(from_s, oldest()); i < next_ && timeOf(i) <= to_s; ++i) {
    out.time_s.push_back(timeOf(i));
    const std::size_t position = positionOf(i);
    for (std::size_t c = 0; c < channels.size(); ++c) {
      out.values[c].push_back(channels_[channels[c]].values[position]);
    }
  }
  return out;
}

CurveBuffer::Extent CurveBuffer::extent(const Channel& channel, std::uint64_t from, std::uint64_t to) const {
  Extent result;
  while (from < to) {
    // The largest entry that starts here and ends before `to`; the ring's size is a multiple of every entry's.
    std::size_t level = 0;
    while (level < kLevels) {
      const std::uint64_t wider = std::uint64_t{1} << (kShift * (level + 1));
      if (from % wider != 0 || from + wider > to) break;
      ++level;
    }
    const std::size_t position = positionOf(from);
    if (level > 0) {
      result.add(channel.levels[level - 1][position >> (kShift * level)]);
      from += std::uint64_t{1} << (kShift * level);
      continue;
    }
    // Samples up to the start of the next entry are contiguous.
    const std::uint64_t entry = std::uint64_t{1} << kShift;
    const auto run = static_cast<std::size_t>(std::min(to, from - from % entry + entry) - from);
    for (const float value : std::span(channel.values).subspan(position, run)) result.add(value);
    from += run;
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
    // The search starts where the last column ended.
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
