// Batches of duty cycles as the touchpad plays them: one after the other at their rate.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <span>

#include "core/base/time.h"
#include "core/protocol/registers/register_codec.h"

namespace fyd::sim {

class VibrationQueue {
 public:
  static constexpr Duration kHold = std::chrono::milliseconds(10);     ///< of the last duty, then zero
  static constexpr Duration kLongest = std::chrono::milliseconds(48);  ///< waiting; older duties are dropped

  void push(std::span<const protocol::DutyPair> duties, double rate_Hz, Instant now) {
    const Duration step = fromSeconds(1.0 / rate_Hz);
    Instant at = std::max(now, waiting_.empty() ? current_.until : waiting_.back().until);
    for (const protocol::DutyPair& duty : duties) {
      waiting_.push_back({.duty = duty, .from = at, .until = at + step});
      at += step;
    }
    if (at - now <= kLongest) return;
    const Duration early = at - now - kLongest;
    while (!waiting_.empty() && waiting_.front().until <= now + early) {
      waiting_.pop_front();
      ++lost_;
    }
    for (Entry& entry : waiting_) {
      entry.from -= early;
      entry.until -= early;
    }
  }

  /// The duty at `now`, which must not decrease from call to call.
  [[nodiscard]] protocol::DutyPair at(Instant now) {
    while (!waiting_.empty() && waiting_.front().from <= now) {
      current_ = waiting_.front();
      waiting_.pop_front();
    }
    return now < current_.until + kHold ? current_.duty : protocol::DutyPair{};
  }

  void clear() {
    waiting_.clear();
    current_ = {};
  }
  [[nodiscard]] std::size_t waiting() const { return waiting_.size(); }
  [[nodiscard]] std::uint16_t lost() const { return lost_; }

 private:
  struct Entry {
    protocol::DutyPair duty{};
    Instant from{};
    Instant until{};
  };
  std::deque<Entry> waiting_;
  Entry current_;
  std::uint16_t lost_ = 0;
};

}  // namespace fyd::sim
