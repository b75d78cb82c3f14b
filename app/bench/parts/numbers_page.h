// The page of numbers: every subject of one run with the machine and the build that it was made on.
#pragma once

#include <string>
#include <vector>

#include "app/bench/parts/machine.h"
#include "app/bench/parts/table.h"

namespace fyd::bench {

/// Writes numbers.md, numbers.csv (each row in one shape) and numbers.svg into the folder of --out, beside each
/// subject's own files.
void writeNumbersPage(const std::vector<Table>& tables, const std::vector<Fact>& facts);

}  // namespace fyd::bench
