// How late this computer was in the last second: said beside a fault that a late computer may have caused, so that no
// cable is blamed for it.
#pragma once

#include <array>
#include <cstdint>

#include "core/base/message.h"
#include "core/base/time.h"
#include "core/pipeline/safety.h"

namespace fyd::station {

struct Lateness {
  double missed_percent = 0.0;  ///< of the haptic cycles of the last second, 0 to 100
  double longest_gap_ms = 0.0;  ///< between two steps of that second; 1 when it was on time
  /// Whether it is worth naming: 1 % of the cycles, or a gap of 10 ms.
  [[nodiscard]] bool worthNaming() const { return missed_percent >= 1.0 || longest_gap_ms >= 10.0; }
};

/// Whether a late computer gives this fault, too.
[[nodiscard]] bool mayBeLateness(pipeline::Fault fault);

/// "this computer was late: 7.2 % of the haptic cycles of that second were missed, ..."; empty when it was not.
[[nodiscard]] Message describe(const Lateness& lateness);

/// One call for each step.
class LatenessMeter {
 public:
  /// @param missed_cycles since the start of the loop
  void add(Instant now, std::uint64_t missed_cycles);
  [[nodiscard]] Lateness lastSecond() const;

 private:
  static constexpr std::size_t kSecond = 1000;  // cycles
  struct Step {
    Instant when{};
    std::uint64_t missed_cycles = 0;
  };
  std::array<Step, kSecond + 1> steps_{};  // ring
  std::size_t count_ = 0;
};

}  // namespace fyd::station
