// How an error of a fit is written, wherever it is shown.
#include <gtest/gtest.h>

#include "core/calibration/calibration_result.h"

namespace fyd::calibration {
namespace {

TEST(CalibrationErrorText, HasTwoSignificantDigitsAndNoExponent) {
  EXPECT_EQ(errorWithUnit(0.001489, "N").text(), "0.0015 N");
  EXPECT_EQ(errorWithUnit(1.2345, "mm").text(), "1.2 mm");
  EXPECT_EQ(errorWithUnit(0.3, "deg").text(), "0.30 deg");
  EXPECT_EQ(errorWithUnit(12345.6, "mm").text(), "12346 mm");
  EXPECT_EQ(errorWithUnit(1e-12, "N").text(), "0.000000 N");
  EXPECT_EQ(errorWithUnit(0.0, "N").text(), "0 N");
}

}  // namespace
}  // namespace fyd::calibration
