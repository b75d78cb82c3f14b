// fyd-console's command line: the station's options in the words of `fyd station`, and the window's own.
#pragma once

#include <QString>
#include <QStringList>
#include <optional>

#include "app/console/trial_run.h"
#include "core/base/error.h"
#include "core/station/station.h"
#include "widgets/theme.h"

namespace fyd::console {

struct Options {
  station::StationOptions station;  ///< without the profile: that is read from `profile`
  QString profile;                  ///< empty: defaults
  QString catalogue;                ///< word of the catalogue of sessions; empty: this user's own
  TrialWords trials;
  QString review;                             ///< recording to review at once; empty: none
  std::optional<widgets::ThemeChoice> theme;  ///< none: as the last time
  QString language;                           ///< empty: as the last time
  QString page;                               ///< place to begin with; empty: as the last time
  QString screenshot;                         ///< empty: none
  double screenshot_after_s = 5.0;
  QString help;  ///< not empty: print this and leave
};

/// @param arguments with the program's name first
/// @return an error naming the option and what was expected
[[nodiscard]] Result<Options> readOptions(const QStringList& arguments);

}  // namespace fyd::console
