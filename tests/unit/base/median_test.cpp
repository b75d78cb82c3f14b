// Median and checksums against values worked out by hand or by another library.
#include "core/base/median.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/checksum.h"
#include "tests/reference_crc.h"

namespace fyd {
namespace {

TEST(Median, OfOddEvenOneAndNone) {
  EXPECT_EQ(median({3.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(median({4.0, 1.0, 3.0, 2.0}), 2.5);
  EXPECT_EQ(median({7.0}), 7.0);
  EXPECT_TRUE(std::isnan(median({})));
  EXPECT_EQ(median({4.0, 1.0, 3.0, 2.0}, Middle::lower), 2.0);
  EXPECT_EQ(median({4.0, 1.0, 3.0, 2.0}, Middle::upper), 3.0);
  EXPECT_EQ(median({1e9, 0.001}, Middle::lower), 0.001);
  EXPECT_EQ(median({3.0, 1.0, 2.0}, Middle::lower), 2.0);
  EXPECT_TRUE(std::isnan(median({}, Middle::lower)));
  EXPECT_EQ(median({1e308, 1.7e308}), 1.35e308) << "their sum overflows, their middle does not";
}

std::span<const std::byte> bytesOf(std::string_view text) { return std::as_bytes(std::span(text)); }

TEST(Checksum, GivesThePublishedCheckValues) {
  EXPECT_EQ(crc32c(bytesOf("123456789")), 0xE3069283U);
  EXPECT_EQ(crc32(bytesOf("123456789")), 0xCBF43926U);
  EXPECT_EQ(crc32c({}), 0U);
  EXPECT_EQ(crc32({}), 0U);
}

TEST(Checksum, AgreesWithBoostAtEveryLengthAndAlignment) {
  std::mt19937 random(3);
  std::vector<std::byte> bytes(4100);
  for (auto& b : bytes) b = static_cast<std::byte>(random());
  for (std::size_t first = 0; first < 9; ++first) {
    for (const std::size_t count : {0U, 1U, 7U, 8U, 9U, 63U, 64U, 65U, 1023U, 4000U}) {
      const auto part = std::span(bytes).subspan(first, count);
      EXPECT_EQ(crc32c(part), referenceCrc32c(part)) << first << ' ' << count;
    }
  }
}

}  // namespace
}  // namespace fyd
