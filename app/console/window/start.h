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
  Message damaged_profile;  ///< why the user's own profile cannot be read: nothing is opened; empty: it can, or is none
  bool first = false;       ///< no option, no memory, no profile: somebody new to it
};

/// @param profile_path of the profile, which need not be there unless an option names it
/// @return an error when a profile cannot be read that an option names, or that belongs to devices an option names
[[nodiscard]] Result<Start> readStart(const Options& options, const QString& profile_path, const WindowMemory& memory);

struct OpenedStart {
  std::unique_ptr<Session> session;
  Message missing;  ///< why the session is closed; empty: it is open
};

/// @return an error when devices that an option names cannot be opened
[[nodiscard]] Result<OpenedStart> openStart(const Start& start);

}  // namespace fyd::console
