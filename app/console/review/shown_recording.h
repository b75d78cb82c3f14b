// The recording that is shown, as others read it again on threads of their own: by its path, where another program may
// have put another recording meanwhile.
#pragma once

#include <QString>
#include <memory>
#include <string>

#include "core/recording/reader/recording.h"

namespace fyd::console {

struct ShownRecording {
  QString path;    ///< empty: none
  std::string id;  ///< in its header

  [[nodiscard]] bool isNone() const { return path.isEmpty(); }
  /// @return an error when it is no longer there, or another one has its name
  [[nodiscard]] Result<std::unique_ptr<recording::Recording>> open() const;
};

}  // namespace fyd::console
