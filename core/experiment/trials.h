// The order of an experiment's trials: every condition equally often, in a random order that a seed reproduces and that
// neither subject nor operator can foresee. Who counts along knows the end of a block, as with every order that is
// balanced block by block.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace fyd::experiment {

enum class TrialOrder : std::uint8_t {
  /// Each block holds every condition once, shuffled; no condition twice in a row. Of two conditions that leaves one
  /// order, in turns: there a block holds each twice (the last of an odd number of repetitions once), shuffled, and a
  /// condition may follow itself.
  permuted_blocks,
  latin_square  ///< row after row of a Williams design: balanced for first-order carry-over
};

struct Trial {
  std::uint32_t number = 0;  ///< from 1
  std::uint32_t block = 0;   ///< from 1
  std::string condition;

  friend bool operator==(const Trial&, const Trial&) = default;
};

inline constexpr std::size_t kMaximumConditions = 64;
inline constexpr std::size_t kMaximumRepetitions = 1000;

/// @return an error for no condition, an empty one or two of the same name, and for numbers out of range
[[nodiscard]] Result<std::vector<Trial>> orderTrials(const std::vector<std::string>& conditions,
                                                     std::size_t repetitions, std::uint64_t seed,
                                                     TrialOrder order = TrialOrder::permuted_blocks);

/// The text of a marker in a recording: "3 soft".
[[nodiscard]] std::string markerText(const Trial& trial);

}  // namespace fyd::experiment
