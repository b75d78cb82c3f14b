// fyd-console's command line: the station's options, named as in `fyd station`, and the window's own.
#pragma once

#include <QString>
#include <QStringList>
#include <optional>

#include "core/base/error.h"
#include "core/station/station.h"
#include "widgets/basics/theme.h"

namespace fyd::console {

/// An experiment's trials.
struct TrialWords {
  QStringList conditions;  ///< none: no trials
  int repetitions = 1;
  std::uint64_t seed = 1;
};

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
  QString help;  ///< not empty: print this and exit
};

/// @param arguments with the program's name first; @param places words that --page may name
/// @return an error naming the option and what was expected
[[nodiscard]] Result<Options> readOptions(const QStringList& arguments, const QStringList& places);

}  // namespace fyd::console
