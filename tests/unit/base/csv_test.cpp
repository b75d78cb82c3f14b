// Reading of CSV: columns by name, line numbers in errors, refusal of damaged text.
#include "core/base/csv.h"

#include <gtest/gtest.h>

namespace fyd {
namespace {

TEST(Csv, ReadsTheWantedColumnsWhateverTheirOrder) {
  const auto table = parseCsv("y,x,note\n1,2,a\n-3.5e2,nan,\"b,c\"\n", "f.csv", {"x", "y"});
  ASSERT_TRUE(table) << table.error().text();
  EXPECT_EQ(table->rows(), 2U);
  EXPECT_EQ(table->values[0][0], 2.0);
  EXPECT_TRUE(std::isnan(table->values[0][1]));
  EXPECT_EQ(table->values[1][1], -350.0);
  EXPECT_EQ(table->lines[1], 3U);
}

TEST(Csv, BlankLinesKeepTheLineNumbersTrue) {
  const auto table = parseCsv("x\r\n\r\n1\r\n\r\ntwo\r\n", "f.csv", {"x"});
  ASSERT_FALSE(table);
  EXPECT_EQ(table.error().text(), "f.csv:5: column x: 'two' is not a number");
}

TEST(Csv, ACarriageReturnAloneEndsALineToo) {
  const auto table = parseCsv("x\r\r1\rtwo", "f.csv", {"x"});
  ASSERT_FALSE(table);
  EXPECT_EQ(table.error().text(), "f.csv:4: column x: 'two' is not a number");
}

TEST(Csv, NamesWhatIsWrong) {
  const auto message = [](std::string_view text) {
    const auto table = parseCsv(text, "f.csv", {"t", "x"});
    return table ? std::string("no error") : table.error().text();
  };
  EXPECT_EQ(message(""), "f.csv: empty; expected a header with t,x");
  EXPECT_EQ(message("t,x\n"), "f.csv: a header but no rows");
  EXPECT_EQ(message("t,y\n1,2\n"), "f.csv:1: no column 'x'; expected t,x");
  EXPECT_EQ(message("t,x\n1\n"), "f.csv:2: 1 fields; the header has 2");
  EXPECT_EQ(message("t,x\n1,\n"), "f.csv:2: column x: '' is not a number");
  EXPECT_EQ(message("t,x\n1,1e999\n"), "f.csv:2: column x: '1e999' is not a number");
}

TEST(Csv, ANameThatIsAskedForStandsInTheHeaderOnce) {
  const auto twice = parseCsv("x,t,x\n1,2,3\n", "f.csv", {"t", "x"});
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.error().text(), "f.csv:1: column 'x' stands there more than once; expected each name once");
  EXPECT_TRUE(parseCsv("x,t,x\n1,2,3\n", "f.csv", {"t"})) << "which of the others is meant is no question";
}

TEST(Csv, MoreColumnsThanATableHasAreRefused) {
  const auto table = [](std::size_t columns) {
    std::string text(columns - 1, ',');
    return parseCsv("x" + text + "\n1" + text + "\n", "f.csv", {"x"});
  };
  EXPECT_TRUE(table(kMostCsvColumns));
  const auto wide = table(kMostCsvColumns + 1);
  ASSERT_FALSE(wide);
  EXPECT_EQ(wide.error().text(), "f.csv:1: more than 1000 columns; expected a table of measurements");
}

TEST(Csv, AnUnclosedQuoteIsRefused) { EXPECT_FALSE(parseCsv("x\n\"1\n", "f.csv", {"x"})); }

}  // namespace
}  // namespace fyd
