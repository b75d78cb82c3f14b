// The step's parameters in a recording, whichever version recorded it: their values, the state that saves them, and the
// indices by which its rows name them. The profile is the whole station's: parameters of other modules, and those this
// version no longer has, are ignored. A parameter newer than the recording gets ParameterInfo::before_it_was.
// Stability: may change
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/api.h"
#include "core/base/error.h"
#include "core/pipeline/local_model.h"
#include "core/pipeline/parameters.h"
#include "core/recording/recording_types.h"

namespace fyd::recording {

/// Values outside today's ranges are accepted where possible (core/base/parameter.h, Ranges::mark).
/// @return an error when the text is damaged or a value is not possible
[[nodiscard]] FYD_API Result<pipeline::Parameters> recordedParameters(const RecordingHeader& header);

/// The recorded state in the form that Pipeline::restoreState reads.
[[nodiscard]] FYD_API Result<std::string> recordedState(const RecordingHeader& header);

/// Turns indices of parameters and of choices' words, as the recording's program counted them, into this program's.
class FYD_API RecordedIndices {
 public:
  /// The index of a parameter that this program does not know.
  static constexpr std::uint16_t kUnknown = 0xFFFF;

  explicit RecordedIndices(const RecordingHeader& header);

  /// The same parameter's index today; kUnknown when there is none, or not that word.
  void translate(std::uint16_t& index, double& value) const;

 private:
  struct Entry {
    std::uint16_t index = kUnknown;
    std::vector<std::uint16_t> words;  ///< of a choice
  };
  std::vector<Entry> entries_;  ///< none: the indices are this program's own
};

/// The stored surface or virtual scene that was touched; empty when there was none.
[[nodiscard]] FYD_API Result<pipeline::LocalModel> recordedLocalModel(const RecordingHeader& header);

}  // namespace fyd::recording
