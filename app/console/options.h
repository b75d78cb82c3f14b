// fyd-console's command line.
#pragma once

#include <QString>
#include <QStringList>

#include "core/base/error.h"
#include "widgets/theme.h"

namespace fyd::console {

struct Options {
  QString finger_csv;                           ///< empty: the built-in gesture
  QString camera;                               ///< empty: simulated
  QString robot = QStringLiteral("simulated");  ///< as StationOptions::robot
  QString key;                                  ///< key file of a "link:" robot
  QString profile;                              ///< empty: defaults
  widgets::ThemeChoice theme = widgets::ThemeChoice::system;
  QString screenshot;  ///< empty: none
  double screenshot_after_s = 5.0;
  QString help;  ///< not empty: print this and leave
};

/// @param arguments with the program's name first
/// @return an error naming the option and what was expected
[[nodiscard]] Result<Options> readOptions(const QStringList& arguments);

}  // namespace fyd::console
