// Reads a whole recording: judges its commits, and checks every block against the CRC32C it was committed with.
#pragma once

#include <cstdint>
#include <string>

#include "core/base/error.h"
#include "core/recording/progress.h"
#include "core/recording/reader/recording_health.h"

namespace fyd::recording {

struct Verification {
  Wholeness wholeness = Wholeness::whole;
  std::uint64_t commits = 0;
  std::uint64_t damaged_commits = 0;
  std::uint64_t unproven_rows = 0;  ///< of all tables, at their ends, which no sound commit proves
  std::uint64_t missing_bytes = 0;  ///< at the end of a closed recording that was cut short
  std::uint64_t blocks = 0;         ///< checked: one table's rows over one or some commits
  std::uint64_t bytes = 0;          ///< of rows
  std::uint64_t damaged = 0;        ///< blocks
  /// Which commits and rows, or which table and rows and both checksums; empty when nothing is damaged.
  Message first_damage;
  Health health;  ///< as of `info`, with what was found here

  [[nodiscard]] bool intact() const {
    return damaged == 0 && damaged_commits == 0 && unproven_rows == 0 && missing_bytes == 0;
  }
};

/// @return an error when the file cannot be opened as a recording at all, or `progress` ended it
[[nodiscard]] Result<Verification> verify(const std::string& path, const Progress& progress = {});

}  // namespace fyd::recording
