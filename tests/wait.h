// Waits of the tests: for something that must come, with an end, and saying in vain for what.
#pragma once

#include <chrono>
#include <string_view>
#include <thread>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace fyd {

/// Nothing that a test waits for takes so long on a machine that does anything else: it does not come.
inline constexpr std::chrono::seconds kPatience{60};

/// Looks every two milliseconds.
/// @param what in words: "waited 60 s for WHAT in vain"
/// @return whether `holds` came true within `patience`
template <class Holds>
[[nodiscard]] testing::AssertionResult comesTrue(std::string_view what, Holds&& holds,
                                                 std::chrono::nanoseconds patience = kPatience) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (!holds()) {
    // The last look is after the end: a machine that stood still meanwhile proves nothing.
    if (std::chrono::steady_clock::now() >= end) {
      if (holds()) break;
      return testing::AssertionFailure() << fmt::format("waited {} s for {} in vain",
                                                        std::chrono::duration<double>(patience).count(), what);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return testing::AssertionSuccess();
}

}  // namespace fyd
