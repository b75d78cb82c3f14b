#include "core/catalogue/catalogue_types.h"

namespace fyd::catalogue {

const char* toString(recording::Wholeness wholeness) {
  switch (wholeness) {
    case recording::Wholeness::whole: return "whole";
    case recording::Wholeness::growing: return "growing";
    case recording::Wholeness::crashed: return "crashed";
    case recording::Wholeness::damaged: return "damaged";
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

}  // namespace fyd::catalogue
