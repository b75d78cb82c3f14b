#include "core/session/catalogue_types.h"

namespace fyd::session {

const char* toString(Wholeness wholeness) {
  switch (wholeness) {
    case Wholeness::whole: return "whole";
    case Wholeness::growing: return "growing";
    case Wholeness::crashed: return "crashed";
    case Wholeness::damaged: return "damaged";
  }
  return "?";
}

const char* toString(FileState state) {
  switch (state) {
    case FileState::present: return "present";
    case FileState::missing: return "missing";
    case FileState::replaced: return "replaced";
  }
  return "?";
}

}  // namespace fyd::session
