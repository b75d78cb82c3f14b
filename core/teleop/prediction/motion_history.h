// The last messages of a motion, in the order of their dates.
// Stability: may change
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/base/api.h"
#include "core/teleop/prediction/predictor.h"

namespace fyd::teleop {

struct DatedPosition {
  double date_s = 0.0;
  Position position_mm{};
};

class FYD_API MotionHistory {
 public:
  static constexpr std::size_t kCapacity = 256;
  enum class Insertion : std::uint8_t { newest, out_of_order, refused };

  /// @param least_spacing_s closer messages are thinned, so that the history covers a longer time: a message replaces
  ///        the previous one if that is closer to its own predecessor
  explicit MotionHistory(double least_spacing_s = 0.0) : least_spacing_s_(least_spacing_s) {}

  /// Largest coordinate accepted: squares and sums of such values cannot overflow.
  static constexpr double kLargestCoordinate_mm = 1e9;

  /// Whether a message is finite and not too far away.
  [[nodiscard]] static bool valid(double date_s, const Position& position_mm);
  /// Refuses a message that is not finite or too far away, that has the date of another, or that is older than all
  /// kept.
  Insertion insert(double date_s, const Position& position_mm);
  void clear() { count_ = 0; }

  [[nodiscard]] bool empty() const { return count_ == 0; }
  [[nodiscard]] std::size_t size() const { return count_; }
  /// The i-th newest; 0 is the newest.
  [[nodiscard]] const DatedPosition& back(std::size_t i) const { return at_[(end_ + kCapacity - 1 - i) % kCapacity]; }
  [[nodiscard]] const DatedPosition& newest() const { return back(0); }
  [[nodiscard]] const DatedPosition& oldest() const { return back(count_ - 1); }

  /// Linear interpolation between the two messages around `time_s`; outside of all, the nearest one.
  /// @param search_index index of `back` where the search starts; set to where it ended, for a next call with an
  ///        earlier time
  [[nodiscard]] Position at(double time_s, std::size_t& search_index) const;
  /// Whether the messages around `time_s` are no further apart than this, so that `at` does not interpolate over a gap.
  [[nodiscard]] bool hasCloseMessages(double time_s, double largest_spacing_s) const;
  [[nodiscard]] Position at(double time_s) const {
    std::size_t search_index = 0;
    return at(time_s, search_index);
  }

 private:
  [[nodiscard]] DatedPosition& slot(std::size_t i) { return at_[(end_ + kCapacity - 1 - i) % kCapacity]; }

  double least_spacing_s_;
  std::array<DatedPosition, kCapacity> at_{};
  std::size_t end_ = 0;
  std::size_t count_ = 0;
};

}  // namespace fyd::teleop
