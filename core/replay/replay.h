// Runs a recording through the step again: unchanged, to prove that the outputs are the same bit for bit, or with other
// parameters, to see their effect.
//
//   open loop    the recorded inputs are used unchanged: the step's own filters, laws and texture react to the new
//                parameters, the cloth under the finger does not
//   lost inputs  inputs that `recover` could not read count as "nothing new came"; such a replay is never identical
//   closed loop  motors and load cell react to the new commands: both the recorded and the new commands drive a
//                simulated motor, and the difference of the two is added to the recorded encoder counts; the force
//                follows the cloth's stiffness at the new stretch, as identified from the recording. The finger's
//                indentation and the robot's requests are as recorded.
// Stability: stable since 0.1
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/api.h"
#include "core/control/cloth_identification.h"
#include "core/recording/reader/recording.h"

namespace fyd::replay {

struct ReplayOptions {
  std::vector<std::string> settings;  ///< "id=value" of the step's parameters; none: as it was
  bool closed_loop = false;
};

struct ReplayResult {
  bool what_if = false;
  bool closed_loop = false;
  bool from_rest = false;       ///< started without the recorded state: a changed parameter is not live
  bool identical = false;       ///< every recorded step came out the same, bit for bit
  std::uint64_t samples = 0;    ///< steps run
  std::uint64_t of = 0;         ///< steps there were, those included that the recording lost
  std::uint64_t gaps = 0;       ///< steps the recording lost; the replay ends at the first gap
  Message why_not_exact;        ///< what is lost in the recording, so that nothing can be proven; empty: nothing
  std::uint64_t different = 0;  ///< steps
  int arithmetic_recorded = pipeline::kArithmetic;
  /// Set when the recording was made with an older arithmetic, which cannot be reproduced bit for bit: how far a step
  /// may then differ.
  std::optional<pipeline::ArithmeticTolerance> tolerance;
  std::uint64_t beyond_tolerance = 0;  ///< of the different steps
  bool explained = false;              ///< every recorded step was run, and none differs by more than the tolerance
  std::vector<std::string>
      out_of_range;  ///< parameters with a recorded or wanted value beyond today's range, which is used all the same
  std::uint64_t unknown_changes = 0;  ///< recorded changes of parameters or choices that this program does not know
  double first_difference_s = pipeline::kNone;
  std::string first_difference_field;
  double max_abs_difference = 0.0;  ///< in the field's own unit; infinite: a number against NaN
  std::string max_difference_field;
  double stiffness_error_recorded_percent = pipeline::kNone;  ///< RMS, measured against target while observable
  double stiffness_error_replayed_percent = pipeline::kNone;
  double duration_s = 0.0;                        ///< of the replayed part
  double speed_x = 0.0;                           ///< times real time
  std::optional<control::IdentifiedCloth> cloth;  ///< closed loop only
};

/// Called with every step in order, and with the recorded telemetry for comparison.
using ReplayObserver =
    std::function<void(const pipeline::TelemetrySample& replayed, const pipeline::TelemetrySample& recorded)>;

/// Whether each setting is "id=value" of a parameter of the step with a value of its kind, whichever the recording.
[[nodiscard]] FYD_API Result<void> checkSettings(const std::vector<std::string>& settings);

/// @return an error that names a wrong setting, or what is missing in the recording: rows, its state, or (closed loop)
///         touches that identify the cloth
[[nodiscard]] FYD_API Result<ReplayResult> replay(const recording::Recording& recording, const ReplayOptions& options,
                                                  const ReplayObserver& observer = {});

}  // namespace fyd::replay
