// Rows of another program version: columns are matched by name, at any offset.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/recording/format/recording_conversion.h"

namespace fyd::recording {
namespace {

using testing::ElementsAre;

template <class... Values>
std::vector<std::byte> bytesOf(const Values&... values) {
  std::vector<std::byte> out;
  const auto add = [&out](const auto& value) {
    const auto bytes = std::as_bytes(std::span(&value, 1));
    out.insert(out.end(), bytes.begin(), bytes.end());
  };
  (add(values), ...);
  return out;
}

Column column(std::string name, ColumnType type, std::size_t offset, std::size_t count = 1) {
  return {.name = std::move(name), .type = type, .unit = "1", .offset = offset, .count = count, .help = {}};
}

TableLayout layout(std::size_t row_bytes, std::vector<Column> columns, std::vector<std::byte> fresh = {}) {
  return {.path = "/t", .help = {}, .row_bytes = row_bytes, .columns = std::move(columns), .fresh = std::move(fresh)};
}

const TableLayout kStored = layout(14, {column("kept", ColumnType::f64, 0), column("theirs", ColumnType::u16, 8),
                                        column("list", ColumnType::u16, 10, 2)});
// A column in the middle, and one more item in the list.
const TableLayout kToday = layout(
    22,
    {column("ours", ColumnType::f64, 0), column("kept", ColumnType::f64, 8), column("list", ColumnType::u16, 16, 3)},
    bytesOf(7.5, 0.0, std::uint16_t{9}, std::uint16_t{9}, std::uint16_t{9}));

TEST(RowConversion, FindsColumnsByTheirNamesAndLeavesTheOthersFresh) {
  const RowConversion conversion(kStored, kToday);
  ASSERT_TRUE(conversion.needed());
  EXPECT_THAT(conversion.lacking(), ElementsAre("ours"));
  EXPECT_THAT(conversion.unknown(), ElementsAre("theirs"));
  const auto one = bytesOf(1.25, std::uint16_t{1}, std::uint16_t{2}, std::uint16_t{3});
  auto rows = one;
  const auto two = bytesOf(-2.5, std::uint16_t{4}, std::uint16_t{5}, std::uint16_t{6});
  rows.insert(rows.end(), two.begin(), two.end());
  auto expected = bytesOf(7.5, 1.25, std::uint16_t{2}, std::uint16_t{3}, std::uint16_t{9});
  const auto second = bytesOf(7.5, -2.5, std::uint16_t{5}, std::uint16_t{6}, std::uint16_t{9});
  expected.insert(expected.end(), second.begin(), second.end());
  EXPECT_EQ(conversion.toToday(rows), expected);
}

TEST(RowConversion, PutsBackWhatItKnowsAndKeepsTheRest) {
  auto row = bytesOf(1.25, std::uint16_t{77}, std::uint16_t{2}, std::uint16_t{3});
  RowConversion(kStored, kToday).putBack(bytesOf(0.5, 4.5, std::uint16_t{5}, std::uint16_t{6}, std::uint16_t{7}), row);
  EXPECT_EQ(row, bytesOf(4.5, std::uint16_t{77}, std::uint16_t{5}, std::uint16_t{6}));
}

TEST(RowConversion, OfTheSameColumnsChangesNothing) {
  const RowConversion conversion(kToday, kToday);
  EXPECT_FALSE(conversion.needed());
  EXPECT_TRUE(conversion.lacking().empty() && conversion.unknown().empty());
}

}  // namespace
}  // namespace fyd::recording
