// fyd-console's command line: the station's options, named as in `fyd station`, and the window's own.
#pragma once

#include <QSize>
#include <QString>
#include <QStringList>
#include <array>
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

/// Panels of the window that --open names; the docks' names in saved layouts. "first-steps" stands above the places.
inline constexpr std::array kPanelNames = {"recording", "link", "manual", "log", "first-steps"};

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
  bool dump_geometry = false;
  QStringList open;    ///< panels to open: their names, of kPanelNames
  double scale = 0.0;  ///< of everything on the screen; 0: the screen's own
  QSize size;          ///< of the window, logical px; not valid: as the last time
  /// A window of standard looks, whatever the operator changed in it before.
  [[nodiscard]] bool standardWindow() const { return dump_geometry || !screenshot.isEmpty(); }
  QString help;  ///< not empty: print this and exit
};

/// @param arguments with the program's name first; @param places words that --page may name
/// @return an error naming the option and what was expected; the words alone are judged, no file and no device
[[nodiscard]] Result<Options> readOptions(const QStringList& arguments, const QStringList& places);
/// @return an error when the recording to review is not there
[[nodiscard]] Result<void> checkReview(const Options& options);

}  // namespace fyd::console
