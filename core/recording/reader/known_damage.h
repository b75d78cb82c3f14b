// Damage of a recording that was met while it is read for recovery.
#pragma once

#include <array>

#include "core/recording/format/recording_format.h"

namespace fyd::recording {

/// The last damage found in each table. Many steps meet the same damage, and finding it anew each time takes long.
class KnownDamage {
 public:
  [[nodiscard]] bool has(Table table, std::uint64_t row) const {
    const Stretch& known = stretches_[indexOf(table)];
    return row >= known.first && row < known.end;
  }
  void add(Table table, std::uint64_t first, std::uint64_t end, Message why) {
    stretches_[indexOf(table)] = {first, end, std::move(why)};
  }
  [[nodiscard]] const Message& why(Table table) const { return stretches_[indexOf(table)].why; }

 private:
  struct Stretch {
    std::uint64_t first = 0;
    std::uint64_t end = 0;
    Message why;
  };
  std::array<Stretch, kTableCount> stretches_;
};

}  // namespace fyd::recording
