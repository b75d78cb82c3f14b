// Accepts a calibration into the profile, and writes its report.
#pragma once

#include <QImage>
#include <QString>
#include <cstdint>
#include <string>
#include <vector>

#include "app/console/shell/page.h"
#include "core/calibration/calibration_record.h"

namespace fyd::console {

struct AcceptedWords {
  std::string who;
  std::string conditions;
  QImage picture = {};     ///< of the fit; the record keeps it as a file beside it
  bool simulated = false;  ///< the points are not readings of a real touchpad
};

enum class Acceptance : std::uint8_t {
  refused,
  written,   ///< in the profile; the session goes on with the former values
  in_force,  ///< in the profile, and the session has them (also where nothing changes)
};

/// Writes record and profile, then begins the session anew with the new values. Only while nothing can move. Success
/// and failure are shown as notices.
/// @param result must not change when the session is heard in between
[[nodiscard]] Acceptance acceptCalibration(const PageContext& context, const calibration::CalibrationResult& result,
                                           int sensor, const AcceptedWords& words);

/// Who made the newest calibration beside the profile, on whichever touchpad; empty: nobody said so.
[[nodiscard]] QString lastWhoCalibrated(const PageContext& context);

/// Writes the newest calibration of a part, with the one before it, as a PDF beside the profile, and shows its path.
/// @return why not, in words; empty when it is written
[[nodiscard]] QString writeCalibrationReport(const PageContext& context, const std::string& procedure, int sensor);

}  // namespace fyd::console
