// What a test gives where a number is expected.
#pragma once

#include <limits>

namespace fyd {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

}  // namespace fyd
