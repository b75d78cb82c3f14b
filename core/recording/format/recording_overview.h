// The min/max pyramid of the telemetry, built while rows are appended, so that a curve of an hour is drawn without
// reading all of its rows.
#pragma once

#include <vector>

#include "core/recording/format/recording_format.h"

namespace fyd::recording {

/// Smallest and largest of every field over some rows; a value that is no number is left out, NaN when none is one.
class OverviewRow {
 public:
  OverviewRow() { clear(); }
  void clear();
  void take(const pipeline::TelemetrySample& sample);
  void take(const OverviewRow& finer);
  [[nodiscard]] std::span<const double> values() const { return values_; }  ///< low, high of each field in turn

 private:
  std::vector<double> values_;
};

/// Hands out each level's row the moment it is complete.
class OverviewBuilder {
 public:
  template <class Put>  // put(Table, span<const double>)
  void take(const pipeline::TelemetrySample& sample, Put&& put) {
    levels_[0].take(sample);
    ++rows_;
    for (std::size_t level = 0; level < levels_.size() && rows_ % kOverviewRows[level] == 0; ++level) {
      put(kOverviewTables[level], levels_[level].values());
      if (level + 1 < levels_.size()) levels_[level + 1].take(levels_[level]);
      levels_[level].clear();
    }
  }

 private:
  std::array<OverviewRow, kOverviewRows.size()> levels_;
  std::uint64_t rows_ = 0;
};

}  // namespace fyd::recording
