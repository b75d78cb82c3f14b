// What a damaged recording still gives, for `recover`.
#pragma once

#include "core/recording/reader/known_damage.h"
#include "core/recording/reader/recording.h"

namespace fyd::recording {

struct TableRows {
  std::uint64_t committed = 0;
  std::uint64_t in_file = 0;  ///< with those that no commit proves
};

/// A recording that is read row by row, whatever is wrong with it.
class DamagedRecording : public Recording {
 public:
  /// As Recording::open, but a damaged header is taken as far as it can be read, and its `missing` says so.
  [[nodiscard]] static Result<std::unique_ptr<DamagedRecording>> open(const std::string& path);

  /// What cannot be read of it is named in its `missing`, and why in `known`. @return an error when its telemetry cannot
  [[nodiscard]] virtual Result<StepRecord> damagedStep(std::uint64_t row, KnownDamage& known) const = 0;
  [[nodiscard]] virtual Result<Note> note(std::uint64_t index) const = 0;
  [[nodiscard]] virtual Result<LinkRow> linkRow(std::uint64_t index) const = 0;
  /// One picture as it stands in the file, not decoded.
  [[nodiscard]] virtual Result<EncodedPicture> encodedPicture(std::uint64_t index) const = 0;
  [[nodiscard]] virtual TableRows rowsOf(Table table) const = 0;
};

}  // namespace fyd::recording
