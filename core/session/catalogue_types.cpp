#include "core/session/catalogue_types.h"

namespace fyd::session {

const char* toString(Wholeness wholeness) {
  switch (wholeness) {
    case Wholeness::whole: return "whole";
    case Wholeness::growing: return "growing";
    case Wholeness::crashed: return "crashed";
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

std::string healthWord(Wholeness wholeness, std::uint64_t gaps) {
  if (wholeness == Wholeness::crashed) return "damaged";
  if (gaps > 0) return "gaps";
  return wholeness == Wholeness::growing ? "growing" : "good";
}

}  // namespace fyd::session
