// Which parts of which steps the header names as missing: entries may overlap, stand in any order, and be very many.
#include <random>

#include <gtest/gtest.h>

#include "core/recording/reader/recording_steps.h"
#include "tests/processor_time.h"

namespace fyd::recording {
namespace {

MissingRows rowsOf(Table table, std::uint64_t first, std::uint64_t count) {
  return {.table = layoutOf(table).path, .first = first, .count = count, .why = "lost"};
}

TEST(MissingParts, AreThoseOfEveryEntryThatCoversTheRow) {
  constexpr std::array kTables{Table::finger, Table::motors, Table::ir};
  constexpr std::uint64_t kRows = 60;
  std::mt19937 random(3);
  for (int round = 0; round < 200; ++round) {
    std::vector<MissingRows> entries;
    std::array<std::uint32_t, kRows> wanted{};
    for (std::size_t i = 0; i < random() % 12; ++i) {
      const Table table = kTables[random() % kTables.size()];
      const std::uint64_t first = random() % kRows;
      const std::uint64_t count = random() % 5 == 0 ? ~std::uint64_t{0} : random() % 20;
      entries.push_back(rowsOf(table, first, count));
      for (std::uint64_t row = first; row < kRows && row - first < count; ++row) wanted[row] |= bitOf(table);
    }
    const MissingParts parts(entries);
    for (std::uint64_t row = 0; row < kRows; ++row) ASSERT_EQ(parts.at(row), wanted[row]) << round << " row " << row;
  }
}

TEST(MissingParts, ThatBeginEarlierAndEarlierTakeNoLongerThanLaterAndLater) {
  constexpr std::uint64_t kEntries = 20'000;
  std::vector<MissingRows> entries;
  for (std::uint64_t i = 0; i < kEntries; ++i) entries.push_back(rowsOf(Table::finger, i, kEntries - i));
  const auto timeOf = [](std::span<const MissingRows> missing) {
    const double before = processorTime_s();
    const MissingParts parts(missing);
    EXPECT_EQ(parts.at(kEntries - 1), bitOf(Table::finger));
    return processorTime_s() - before;
  };
  const double later_s = timeOf(entries);
  std::ranges::reverse(entries);
  EXPECT_LT(timeOf(entries), 20.0 * later_s) << "each entry once, in whatever order";
}

}  // namespace
}  // namespace fyd::recording
