// The recording that is shown, as others read it again on threads of their own: by its path, where another program may
// have put another recording meanwhile.
#pragma once

#include <QString>
#include <string>

#include "core/recording/reader/recording.h"

namespace fyd::console {

struct ShownRecording {
  QString path;    ///< empty: none
  std::string id;  ///< in its header

  [[nodiscard]] bool isNone() const { return path.isEmpty(); }
  /// To be asked before anything is made of the file at `path` or written beside it.
  [[nodiscard]] Result<void> isStillThere() const { return recording::expectRecording(path.toStdString(), id); }
};

}  // namespace fyd::console
