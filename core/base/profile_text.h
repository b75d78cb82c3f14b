// A profile is TOML text: one table per room, one key per parameter. Reading is strict: an unknown key,
// a wrong type, a value out of range or not finite is refused with file, line and what is allowed,
// and then nothing at all is changed.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/parameter.h"

namespace fyd {

/// Stores every key of `text` into the bound parameters; parameters that are not named keep their value.
/// @param source_name stands before the line number in messages, usually the file's name
[[nodiscard]] Result<void> parseProfile(std::string_view text, std::string_view source_name,
                                        std::span<const Parameter> parameters);

/// Every parameter with its unit and range as a comment, in the form parseProfile reads back equal.
[[nodiscard]] std::string formatProfile(std::span<const Parameter> parameters);

}  // namespace fyd
