// Perceptual deadband: sends only changes that can be felt, and tells the receiver which values it may rely on.
//
// A sample is sent when a channel has left the band around the receiver's extrapolation of the last sample (Weber):
//
//   a level (a force)     |x − sent| > max(floor, fraction · |sent|)
//   a place that moves    |x − (sent + slope · t)| > max(floor, fraction · |slope| · kContinued_s)
//
// so a position is extrapolated at the speed it was sent with, and the speed may be wrong by the fraction for 50 ms.
// Without a change a sample is sent 20, 40, 80 … ms after the last one, at most `refresh` apart. Samples are numbered,
// and a packet carries the last few of them, so a lost packet is made up for by a later one.
//
// For any moment the receiver gives the value by the last sample before it, and sets `known` when no sample up to that
// moment is missing. Where it is known the error is at most the band, whatever was lost, reordered or duplicated.
// 150 ms after a moment nearly every value is known at 20 % loss.
// Stability: may change
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/base/api.h"
#include "core/base/batch.h"

namespace fyd::teleop {

struct FYD_API DeadbandChannel {
  double fraction = 0.10;  ///< of the value sent last, 0 … 1
  double floor = 0.0;      ///< in the channel's unit, 0 and more: smaller differences are never sent
  bool moves = false;      ///< a position, extrapolated with its slope; otherwise a level, which stays

  static constexpr double kContinued_s = 0.050;

  /// Largest distance of the true value from the extrapolation of a sample.
  [[nodiscard]] double band(double value, double slope) const;
};

inline constexpr std::size_t kMostDeadbandChannels = 6;
using DeadbandValues = std::array<double, kMostDeadbandChannels>;
using DeadbandChannels = std::array<DeadbandChannel, kMostDeadbandChannels>;

struct FYD_API DeadbandSample {
  std::uint32_t number = 0;  ///< from 1
  double date_s = 0.0;
  DeadbandValues value{};
  DeadbandValues slope{};  ///< per second; 0 for levels

  /// The values extrapolated to a moment after it.
  [[nodiscard]] DeadbandValues at(double time_s) const;
};

inline constexpr std::size_t kMostDeadbandHistory = 8;
using DeadbandPacket = Batch<DeadbandSample, kMostDeadbandHistory>;  ///< the newest last

class FYD_API DeadbandSender {
 public:
  static constexpr double kFirstRepeat_s = 0.020, kRefresh_s = 0.100;

  /// @param channels the values of unused ones are 0
  /// @param history samples in a packet, 1 … kMostDeadbandHistory; what is beyond counts as the nearest
  explicit DeadbandSender(const DeadbandChannels& channels, double refresh_s = kRefresh_s,
                          std::size_t history = kMostDeadbandHistory)
      : channels_(channels),
        refresh_s_(refresh_s),
        history_(std::clamp<std::size_t>(history, 1, kMostDeadbandHistory)) {}

  /// Whenever a packet might be sent, in the order of time. A value that is not finite counts as the last one, a slope
  /// as 0. @param must something else has changed that is to be sent at once
  /// @return what to send now, if anything
  [[nodiscard]] std::optional<DeadbandPacket> step(double time_s, const DeadbandValues& values,
                                                   const DeadbandValues& slopes = {}, bool must = false);
  /// Replaces the newest sample by its values after the message's quantisation: the band is around what the receiver
  /// reads.
  void told(const DeadbandValues& values, const DeadbandValues& slopes);

 private:
  DeadbandChannels channels_;
  double refresh_s_;
  std::size_t history_;
  std::array<DeadbandSample, kMostDeadbandHistory> samples_{};  ///< by number
  std::uint32_t newest_ = 0;
  double repeat_s_ = 0.0;  ///< after the newest
};

class FYD_API DeadbandReceiver {
 public:
  /// In any order, any number of times. Samples that are not finite, or numbered far ahead, are ignored.
  void receive(const DeadbandPacket& packet);

  struct Answer {
    DeadbandValues value{};
    DeadbandValues slope{};
    bool known = false;  ///< no sample before that moment is missing
  };
  /// The values for this moment; zeros and not known before the first sample.
  [[nodiscard]] Answer at(double time_s) const;
  /// A position between two samples: the cubic curve with both their values and slopes, limited to the band around the
  /// value of `at`; its error is at most twice the band, and mostly far less.
  /// @return nothing where it is not known, or there is no such channel
  [[nodiscard]] std::optional<double> place(double time_s, std::size_t channel, const DeadbandChannel& as_sent) const;

 private:
  static constexpr std::uint32_t kKept = 512;
  [[nodiscard]] const DeadbandSample& kept(std::uint32_t number) const { return samples_[number % kKept]; }
  /// The newest one that has arrived of those up to a moment; null: none.
  [[nodiscard]] const DeadbandSample* before(double time_s) const;
  /// The next one; null: it has not arrived.
  [[nodiscard]] const DeadbandSample* after(const DeadbandSample& sample) const;

  std::array<DeadbandSample, kKept> samples_{};  ///< number 0: nothing
  std::uint32_t newest_ = 0;
};

}  // namespace fyd::teleop
