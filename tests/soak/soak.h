// What the parts of the soak share: chance, figures, and how it ends when something does not hold.
#pragma once

#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/base/time.h"

namespace fyd::soak {

/// Seeded; the same seed draws the same faults at the same times.
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : random_(seed) {}
  [[nodiscard]] double between(double low, double high) { return std::uniform_real_distribution<>(low, high)(random_); }
  [[nodiscard]] int below(int end) { return std::uniform_int_distribution<>(0, end - 1)(random_); }
  [[nodiscard]] bool once(double in) { return in <= 1.0 || below(static_cast<int>(in)) == 0; }
  template <class T>
  [[nodiscard]] const T& oneOf(const std::vector<T>& list) {
    return list[static_cast<std::size_t>(below(static_cast<int>(list.size())))];
  }
  [[nodiscard]] std::uint64_t number() { return random_(); }

 private:
  std::mt19937_64 random_;
};

/// What happened, over all sessions.
struct Figures {
  std::uint64_t sessions = 0;
  std::uint64_t steps = 0;
  std::uint64_t active_steps = 0;
  std::uint64_t arms = 0;
  std::uint64_t refused_arms = 0;
  std::uint64_t checked_deadlines = 0;  ///< faults that were there alone until Active had to have ended
  double largest_creep_mm = 0.0;        ///< of the arm, from 2.5 s after the end of Active on
  std::uint64_t recordings = 0;         ///< closed, whole and verified
  std::uint64_t failed_recordings = 0;  ///< ended by the disk, recovered and verified
  std::uint64_t recorded_steps = 0;
  std::map<std::string, std::uint64_t> faults;  ///< begun, by their names: "touchpad silence"; each there is, also at 0
  std::map<std::string, std::uint64_t> held;    ///< times, by the cause
};

/// Says what did not hold, where, and ends the program with exit code 1.
[[noreturn]] void broken(const std::string& what);
/// Where it is, for `broken`.
void at(std::uint64_t session, double seconds);

}  // namespace fyd::soak
