// The calibrations that a profile has: how old each is, and how a new one is accepted.
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "app/console/page.h"
#include "core/calibration/calibration_record.h"

namespace fyd::console {

struct PartState {
  enum class Kind {
    never,
    fine,
    ageing,
    old,
    changed,
    outdated  ///< what it rests on was calibrated since
  };
  Kind kind = Kind::never;
  QString words;
};

/// Usable, but to be done again: shown in amber, and in the readiness list.
[[nodiscard]] constexpr bool isDoubtful(PartState::Kind kind) {
  using enum PartState::Kind;
  return kind == ageing || kind == old || kind == outdated;
}

/// Of the newest record of this procedure and sensor, and of what it rests on.
/// @param today "2026-11-21" or longer
[[nodiscard]] PartState partStateOf(const std::vector<calibration::CalibrationRecord>& records,
                                    const std::string& procedure, int sensor, station::Profile profile,
                                    const std::string& today);

/// "2026-11-21T20:15:00Z"
[[nodiscard]] std::string nowUtc();

struct AcceptedWords {
  std::string who;
  std::string conditions;
};

/// Writes record and profile, then begins the session anew with the new values. For a time when nothing can move.
/// What went well and what did not is told; @return whether the files were written
[[nodiscard]] bool acceptCalibration(const PageContext& context, const calibration::CalibrationResult& result,
                                     int sensor, const AcceptedWords& words);

/// Writes the newest calibration of a part, with the one before it, as a PDF beside the profile, and tells where.
/// @return why not, in words; empty when it is written
[[nodiscard]] QString writeCalibrationReport(const PageContext& context, const std::string& procedure, int sensor);

}  // namespace fyd::console
