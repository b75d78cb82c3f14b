// What a recording says of the step's parameters, whichever program recorded it: their values, the state that saves
// them, and the indices by which its rows name them. The profile is the whole station's; what belongs to other rooms,
// and what this version does not know any more, is passed over; what the recording lacks takes its value before it was.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/pipeline/local_model.h"
#include "core/pipeline/parameters.h"
#include "core/session/recording_types.h"

namespace fyd::session {

/// Values beyond today's ranges are taken where that can be (core/base/parameter.h, Ranges::mark).
/// @return an error when the text is damaged or a value cannot be
[[nodiscard]] Result<pipeline::Parameters> recordedParameters(const RecordingHeader& header);

/// The recorded state in the form that Pipeline::restoreState reads.
[[nodiscard]] Result<std::string> recordedState(const RecordingHeader& header);

/// Turns indices of parameters and of choices' words, as the recording's program counted them, into this program's.
class RecordedIndices {
 public:
  /// Of what this program does not know.
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

/// The stored surface or the scene that was felt; empty when there was none.
[[nodiscard]] Result<pipeline::LocalModel> recordedLocalModel(const RecordingHeader& header);

}  // namespace fyd::session
