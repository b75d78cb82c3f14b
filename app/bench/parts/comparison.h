// Every subject's rows in one shape: what it cost and how far off it was, and both as a multiple of the baseline of the
// same group of the same run. Computed from the cells of the tables, so a figure stands in one place.
#pragma once

#include <vector>

#include "app/bench/parts/table.h"

namespace fyd::bench {

/// A row of `tables` each: subject, case, what, baseline, cost with unit and ratio, error with unit and ratio.
[[nodiscard]] Table comparisonOf(const std::vector<Table>& tables);

/// A method of one table over all of its groups: the medians, and of how many rows. Its columns are the table's own.
/// What never came (kNever) counts as longer than everything; with it there is no multiple of the baseline.
[[nodiscard]] Table summaryOf(const Table& table);

/// Error against cost of each subject that has both, as multiples of the baseline's (SVG); empty when none has.
[[nodiscard]] std::string pictureOf(const std::vector<Table>& tables);

}  // namespace fyd::bench
