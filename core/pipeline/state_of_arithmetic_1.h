// Converts pipeline states saved by revision a4d2b6a to today's format (state_format.h).
//
// That format named neither parameters nor modules: it held the parameters' values in the order of that program's list,
// which the recording's profile gives, then the modules, each in its version 1. The recordings of arithmetic 1 hold
// such states; states of earlier revisions are refused.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/profile_text.h"

namespace fyd::pipeline {

[[nodiscard]] bool isStateOfArithmetic1(std::string_view state);

/// @param listed the parameters of the profile that was recorded beside it, in its order; others may follow the step's
/// @return the same state in today's format; an error for bytes that are damaged or of another revision
[[nodiscard]] Result<std::string> convertStateOfArithmetic1(std::string_view state,
                                                            std::span<const ProfileEntry> listed);

}  // namespace fyd::pipeline
