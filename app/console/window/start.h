// What a start of the window opens: which devices, from the options, from what the window remembers and from the
// profile, in this order; and what happens when they cannot be opened.
#pragma once

#include <QString>
#include <memory>

#include "app/console/shell/options.h"
#include "app/console/shell/session.h"
#include "app/console/window/window_memory.h"

namespace fyd::console {

struct Start {
  station::StationOptions station;
  /// No option says which devices there are, only the user's own profile and memory do: one that is missing does not keep
  /// the window from opening.
  bool devices_remembered = false;
  bool first = false;  ///< no option, no memory, no profile: somebody new to it
};

/// @param profile_path of the profile, which need not be there unless an option names it
/// @return an error when the profile cannot be read
[[nodiscard]] Result<Start> readStart(const Options& options, const QString& profile_path, const WindowMemory& memory);

struct OpenedStart {
  std::unique_ptr<Session> session;
  Message missing;  ///< why the session is closed; empty: it is open
};

/// @return an error when devices that an option names cannot be opened
[[nodiscard]] Result<OpenedStart> openStart(const Start& start);

}  // namespace fyd::console
