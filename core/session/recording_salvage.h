// What a damaged recording still gives, for `recover`.
#pragma once

#include "core/session/recording.h"
#include "core/session/recording_format.h"

namespace fyd::session {

/// The damage of each table that was met last: it is met again by many steps, and each time it takes long to find.
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

/// As Recording::open, but a damaged header is taken as far as it can be read, and its `missing` says so.
[[nodiscard]] Result<std::unique_ptr<Recording>> openDamaged(const std::string& path);

// Of a recording from `openDamaged`:

/// What cannot be read of it is named in its `missing`, and why in `known`. @return an error when its telemetry cannot
[[nodiscard]] Result<StepRecord> damagedStep(const Recording& recording, std::uint64_t row, KnownDamage& known);
[[nodiscard]] Result<Note> note(const Recording& recording, std::uint64_t index);
[[nodiscard]] Result<LinkRow> linkRow(const Recording& recording, std::uint64_t index);
/// One picture as it stands in the file, not decoded.
[[nodiscard]] Result<EncodedPicture> encodedPicture(const Recording& recording, std::uint64_t index);
struct TableRows {
  std::uint64_t committed = 0;
  std::uint64_t in_file = 0;  ///< with those that no commit proves
};
[[nodiscard]] TableRows rowsOf(const Recording& recording, Table table);

}  // namespace fyd::session
