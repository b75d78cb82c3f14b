#include "core/teleop/prediction/motion_history.h"

#include <algorithm>
#include <cmath>

namespace fyd::teleop {

bool MotionHistory::valid(double date_s, const Position& position_mm) {
  return std::isfinite(date_s) &&
         std::ranges::all_of(position_mm, [](double x) { return std::abs(x) <= kLargestCoordinate_mm; });
}

MotionHistory::Insertion MotionHistory::insert(double date_s, const Position& position_mm) {
  if (!valid(date_s, position_mm)) return Insertion::refused;
  if (count_ == 0 || date_s > newest().date_s) {
    const bool replaces = count_ > 1 && newest().date_s - back(1).date_s < least_spacing_s_;
    if (!replaces) {
      end_ = (end_ + 1) % kCapacity;
      count_ = std::min(count_ + 1, kCapacity);
    }
    slot(0) = {date_s, position_mm};
    return Insertion::newest;
  }
  std::size_t later = 0;  // messages with a later date
  while (later < count_ && back(later).date_s > date_s) ++later;
  if (later == count_ || back(later).date_s == date_s) return Insertion::refused;
  if (count_ == kCapacity) return Insertion::refused;  // full: older messages are not inserted
  end_ = (end_ + 1) % kCapacity;
  ++count_;
  for (std::size_t i = 0; i < later; ++i) slot(i) = back(i + 1);
  slot(later) = {date_s, position_mm};
  return Insertion::out_of_order;
}

Position MotionHistory::at(double time_s, std::size_t& search_index) const {
  while (search_index + 1 < count_ && back(search_index).date_s > time_s) ++search_index;
  const DatedPosition& before = back(search_index);
  if (search_index == 0 || before.date_s > time_s) return before.position_mm;
  const DatedPosition& after = back(search_index - 1);
  const double share = std::clamp((time_s - before.date_s) / (after.date_s - before.date_s), 0.0, 1.0);
  Position out{};
  for (std::size_t a = 0; a < kMostAxes; ++a) {
    out[a] = before.position_mm[a] + share * (after.position_mm[a] - before.position_mm[a]);
  }
  return out;
}

bool MotionHistory::hasCloseMessages(double time_s, double largest_spacing_s) const {
  std::size_t before = 0;
  while (before < count_ && back(before).date_s > time_s) ++before;
  if (before == count_) return false;
  return before == 0 || back(before - 1).date_s - back(before).date_s <= largest_spacing_s;
}

}  // namespace fyd::teleop
