// Cases in which a naive implementation loses its digits, its stability or its sense: each runs a naive one and our own
// code on the same input, and compares both with a truth that comes from neither.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace fyd::bench {

struct HardCase {
  std::string name;
  std::string naive;  ///< what the naive implementation does
  std::string ours;   ///< what ours does, and its name in the core
  std::string truth;  ///< where the truth comes from
  std::string unit;   ///< of the errors
  double naive_error = 0.0;
  double our_error = 0.0;
  double at_most = 0.0;  ///< what ours is held to; the naive one is beyond, or the case would not be hard
};

inline constexpr double kNotFinite = std::numeric_limits<double>::infinity();

[[nodiscard]] std::vector<HardCase> hardCasesOfSignals();
[[nodiscard]] std::vector<HardCase> hardCasesOfSensing();
[[nodiscard]] std::vector<HardCase> hardCasesOfControl();
[[nodiscard]] std::vector<HardCase> hardCasesOfScenes();
[[nodiscard]] std::vector<HardCase> hardCasesOfTimeAndCodes();

}  // namespace fyd::bench
