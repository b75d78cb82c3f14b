// One step of a recording, put together from its tables: as it was, or, for `recover`, as far as it can be read.
#pragma once

#include <map>
#include <span>

#include "core/recording/reader/known_damage.h"
#include "core/recording/reader/recording_tables.h"
#include "core/recording/step_record.h"

namespace fyd::recording {

/// Which parts of which steps the header names as missing.
class MissingParts {
 public:
  explicit MissingParts(std::span<const MissingRows> missing);
  /// As in StepRecord::missing.
  [[nodiscard]] std::uint32_t at(std::uint64_t row) const;

 private:
  std::map<std::uint64_t, std::uint32_t> from_;  // from this row on; before the first nothing is missing
};

/// @throws RecordingFailure when anything of it cannot be read that is not among `missing`
[[nodiscard]] StepRecord readStep(const RecordingTables& tables, const MissingParts& missing, std::uint64_t row);

/// What cannot be read, or was missing before, is named in the record's `missing`, and why in `known`.
/// @throws RecordingFailure when its telemetry cannot be read
[[nodiscard]] StepRecord readDamagedStep(const RecordingTables& tables, const MissingParts& missing, std::uint64_t row,
                                         KnownDamage& known);

}  // namespace fyd::recording
