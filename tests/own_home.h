// A home of its own for a test that is a whole program with a window.
#pragma once

#include "tests/temporary_folder.h"

namespace fyd {

/// The user's home until the test ends, empty at its start: what is kept of a user stays out of the tester's own. To be
/// made before the application.
class OwnHome : public Folder {
 public:
  OwnHome() {
    ::setenv("HOME", path().c_str(), 1);
    // Their defaults are below it.
    for (const char* name : {"XDG_CACHE_HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME"}) ::unsetenv(name);
  }
};

}  // namespace fyd
