// How old each part's calibration is, and the lines of the readiness list about those that are ageing, old or rest on
// an older one of another part. A part that was never calibrated gets no line there, because a first session would
// have one for every part; the place "Calibrate" shows it.
#pragma once

#include <QDateTime>
#include <QString>
#include <string>
#include <vector>

#include "app/console/shell/page.h"
#include "core/calibration/calibration_record.h"
#include "widgets/status/readiness_list.h"

namespace fyd::console {

struct PartState {
  enum class Kind {
    never,
    fine,
    ageing,
    old,
    changed,
    outdated  ///< a calibration that it depends on was repeated since
  };
  Kind kind = Kind::never;
  QString words;
};

/// Usable, but to be done again: shown in amber, and in the readiness list.
[[nodiscard]] constexpr bool isDoubtful(PartState::Kind kind) {
  using enum PartState::Kind;
  return kind == ageing || kind == old || kind == outdated;
}

/// From the newest record of this procedure and sensor, and from those that it depends on.
/// @param today "2026-11-21" or longer
[[nodiscard]] PartState partStateOf(const std::vector<calibration::CalibrationRecord>& records,
                                    const std::string& procedure, int sensor, station::Profile profile,
                                    const std::string& today);

/// "2026-11-21T20:15:00Z"
[[nodiscard]] std::string nowUtc();

/// The readiness rows of all parts.
/// @param today "2026-11-21" or longer
[[nodiscard]] std::vector<widgets::ReadinessRow> ageingRows(const std::vector<calibration::CalibrationRecord>& records,
                                                            const station::Profile& profile, const std::string& today);

/// Reads the records again when their file has changed. The rows also depend on the date and on the values in force.
class CalibrationAges {
 public:
  explicit CalibrationAges(const PageContext& context) : context_(context) {}
  [[nodiscard]] std::vector<widgets::ReadinessRow> rows();

 private:
  PageContext context_;
  QDateTime changed_;  ///< no date: there was no file
  std::vector<calibration::CalibrationRecord> records_;
};

}  // namespace fyd::console
