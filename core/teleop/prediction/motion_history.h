// The last messages of a motion, in the order of their dates.
#pragma once

#include <array>
#include <cstddef>

#include "core/teleop/prediction/predictor.h"

namespace fyd::teleop {

struct DatedPosition {
  double date_s = 0.0;
  Position position_mm{};
};

class MotionHistory {
 public:
  static constexpr std::size_t kMost = 256;
  enum class Taken : std::uint8_t { newest, overtaken, refused };

  /// @param finest_s messages closer together than this are thinned, so that the history reaches further back: the
  ///        newest takes the place of the one before it
  explicit MotionHistory(double finest_s = 0.0) : finest_s_(finest_s) {}

  /// Largest coordinate accepted: squares and sums of such values cannot overflow.
  static constexpr double kFurthest_mm = 1e9;

  /// Refuses a message that is not finite or too far away, that has the date of another, or that is older than all
  /// kept.
  Taken insert(double date_s, const Position& position_mm);
  void clear() { count_ = 0; }

  [[nodiscard]] bool empty() const { return count_ == 0; }
  [[nodiscard]] std::size_t size() const { return count_; }
  /// The i-th newest, from 0.
  [[nodiscard]] const DatedPosition& back(std::size_t i) const { return at_[(end_ + kMost - 1 - i) % kMost]; }
  [[nodiscard]] const DatedPosition& newest() const { return back(0); }
  [[nodiscard]] const DatedPosition& oldest() const { return back(count_ - 1); }

  /// Linear between the two messages around `time_s`; the first or last one outside of them.
  /// @param from where the search starts (an index of `back`); set to where it ended, for later calls with earlier
  /// times
  [[nodiscard]] Position at(double time_s, std::size_t& from) const;
  /// Whether the messages around `time_s` are no further apart than this, so that `at` does not bridge a gap.
  [[nodiscard]] bool knows(double time_s, double apart_s) const;
  [[nodiscard]] Position at(double time_s) const {
    std::size_t from = 0;
    return at(time_s, from);
  }

 private:
  [[nodiscard]] DatedPosition& slot(std::size_t i) { return at_[(end_ + kMost - 1 - i) % kMost]; }

  double finest_s_;
  std::array<DatedPosition, kMost> at_{};
  std::size_t end_ = 0;
  std::size_t count_ = 0;
};

}  // namespace fyd::teleop
