// Runs a recording through the step again: as it was, to prove that it comes out the same bit for bit, or with other
// parameters, to see what they would have done.
//
//   open loop    the recorded inputs go in as they are: the step's own filters, laws and texture change, the cloth
//   under
//                the finger does not answer
//   lost inputs  what `recover` could not read of a step is taken as "nothing new came"; no such replay is identical
//   closed loop  motors and load cell answer to the new commands: both the recorded and the new commands drive a
//                simulated motor, and the difference of the two goes into the recorded encoder counts; the force
//                follows the cloth's stiffness at the new stretch, as identified from the recording. The finger presses
//                as deep, and the robot asks for what it asked for, as recorded.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/control/fabric_identification.h"
#include "core/session/recording.h"

namespace fyd::session {

struct ReplayOptions {
  std::vector<std::string> settings;  ///< "id=value" of the step's parameters; none: as it was
  bool closed_loop = false;
};

struct ReplayResult {
  bool what_if = false;
  bool closed_loop = false;
  bool from_rest = false;       ///< started without the recorded state: a parameter that is not live was changed
  bool identical = false;       ///< every recorded step came out the same, bit for bit
  std::uint64_t samples = 0;    ///< steps run
  std::uint64_t of = 0;         ///< steps recorded
  std::uint64_t gaps = 0;       ///< steps the recording lost; the replay ends at the first gap
  Message why_not_exact;        ///< what of the recording is lost, so that it cannot be proven; empty: nothing
  std::uint64_t different = 0;  ///< steps
  int arithmetic_recorded = pipeline::kArithmetic;
  /// Set when the recording was made with an older arithmetic, whose bits cannot come out again; see step_compare.h.
  std::optional<pipeline::ArithmeticTolerance> tolerance;
  std::uint64_t beyond_tolerance = 0;  ///< of the different steps
  std::vector<std::string>
      out_of_range;  ///< parameters with a recorded or wanted value beyond today's range, taken as it is
  std::uint64_t unknown_changes = 0;  ///< recorded changes of parameters, or words, that this program does not know
  double first_difference_s = pipeline::kNone;
  std::string first_difference_field;
  double max_abs_difference = 0.0;  ///< in the field's own unit; infinite: a number against none
  std::string max_difference_field;
  double stiffness_error_recorded_percent = pipeline::kNone;  ///< RMS, measured against target while observable
  double stiffness_error_replayed_percent = pipeline::kNone;
  double duration_s = 0.0;                          ///< of what was run
  double speed_x = 0.0;                             ///< times real time
  std::optional<control::IdentifiedFabric> fabric;  ///< closed loop only
};

/// Sees every step in order; the recorded telemetry stands beside for comparison.
using ReplayObserver =
    std::function<void(const pipeline::TelemetrySample& replayed, const pipeline::TelemetrySample& recorded)>;

/// @return an error that says what the recording lacks: rows, its state, or (closed loop) what would identify the
/// cloth;
///         or which setting is wrong
[[nodiscard]] Result<ReplayResult> replay(const Recording& recording, const ReplayOptions& options,
                                          const ReplayObserver& observer = {});

}  // namespace fyd::session
