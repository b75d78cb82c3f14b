// States as revision a4d2b6a saved them, turned into the form of today (state_seal.h).
//
// They named neither parameters nor modules: the parameters' values stood in the order of the program's own list, which
// the recording's profile tells, then the modules, each in its version 1. What they held is exactly that of the first
// recordings (arithmetic 1); other revisions before it are refused.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/profile_text.h"

namespace fyd::pipeline {

[[nodiscard]] bool isStateOfArithmetic1(std::string_view state);

/// @param listed the parameters of the profile that was recorded beside it, in its order; others may follow the step's
/// @return the same state in the form of today; an error for bytes that are damaged or of another revision
[[nodiscard]] Result<std::string> convertStateOfArithmetic1(std::string_view state,
                                                            std::span<const ProfileEntry> listed);

}  // namespace fyd::pipeline
