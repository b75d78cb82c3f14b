// Sends only what can be felt, and tells the receiver what it may rely on.
//
// A change is sent when a channel has left the band around what was sent last: |x − sent| > max(floor, fraction ·
// |sent|) (Weber). Changes are numbered; a packet carries the last kHistory of them and the date up to which nothing
// else has changed, so a lost packet is made up for by any later one. A packet is repeated 20, 40, 80 … ms after the
// last one, at most `refresh` apart.
//
// The receiver answers for a moment: with the value sent then, and with `known` when every change up to that moment has
// arrived. Where it is known the error is at most the band, whatever was lost, shuffled or doubled: what is missing is
// said, never guessed. A receiver that asks 100 ms back knows nearly all of it at 20 % loss.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/base/batch.h"

namespace fyd::teleop {

struct DeadbandChannel {
  double fraction = 0.10;  ///< of the value sent last, 0 … 1
  double floor = 0.0;      ///< in the channel's unit, 0 and more: smaller differences are never sent

  /// How far the true value may be from the one that was sent.
  [[nodiscard]] double band(double sent) const;
};

inline constexpr std::size_t kMostDeadbandChannels = 6;
using DeadbandValues = std::array<double, kMostDeadbandChannels>;
using DeadbandChannels = std::array<DeadbandChannel, kMostDeadbandChannels>;

struct DeadbandChange {
  std::uint32_t number = 0;  ///< from 1
  double date_s = 0.0;
  DeadbandValues value{};
};

struct DeadbandPacket {
  static constexpr std::size_t kHistory = 8;
  double date_s = 0.0;                      ///< up to here nothing changed after the last change
  Batch<DeadbandChange, kHistory> changes;  ///< the newest last
};

class DeadbandSender {
 public:
  static constexpr double kFirstRepeat_s = 0.020, kRefresh_s = 0.100;

  /// @param channels of those that are not used the values are 0
  explicit DeadbandSender(const DeadbandChannels& channels, double refresh_s = kRefresh_s)
      : channels_(channels), refresh_s_(refresh_s) {}

  /// At each step, in the order of time. A value that is not finite counts as the last one.
  /// @return what to send now, if anything
  [[nodiscard]] std::optional<DeadbandPacket> step(double time_s, const DeadbandValues& values);

 private:
  DeadbandChannels channels_;
  double refresh_s_;
  std::array<DeadbandChange, DeadbandPacket::kHistory> changes_{};  ///< by number
  std::uint32_t newest_ = 0;
  double sent_s_ = 0.0;
  double repeat_s_ = 0.0;  ///< after sent_s_
};

class DeadbandReceiver {
 public:
  /// In any order, any number of times. What is not finite, or numbered far ahead, is passed over.
  void receive(const DeadbandPacket& packet);

  struct Answer {
    DeadbandValues value{};
    bool known = false;  ///< nothing before that moment is missing
  };
  /// What was sent for this moment; zeros and not known before the first change.
  [[nodiscard]] Answer at(double time_s) const;

 private:
  static constexpr std::uint32_t kKept = 128;
  [[nodiscard]] const DeadbandChange& kept(std::uint32_t number) const { return changes_[number % kKept]; }

  std::array<DeadbandChange, kKept> changes_{};  ///< number 0: nothing
  std::uint32_t newest_ = 0;                     ///< the newest change that is known
  double unchanged_until_s_ = 0.0;               ///< after it
};

}  // namespace fyd::teleop
