// A profile is TOML text: one table per module, one key per parameter. Reading is strict: an unknown key,
// a wrong type, a value out of range or not finite is refused with file, line and what is allowed,
// and then nothing at all is changed.
// Stability: stable since 0.1
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/api.h"
#include "core/base/error.h"
#include "core/base/parameter.h"

namespace fyd {

/// Stores every key of `text` into the bound parameters; parameters that are not named keep their value.
/// @param source_name stands before the line number in messages, usually the file's name
[[nodiscard]] FYD_API Result<void> parseProfile(std::string_view text, std::string_view source_name,
                                                std::span<const Parameter> parameters, Ranges ranges = Ranges::bind);

/// Every parameter with its unit and range as a comment, in the form parseProfile reads back equal.
[[nodiscard]] FYD_API std::string formatProfile(std::span<const Parameter> parameters);

/// One parameter as formatProfile of any program version wrote it.
struct ProfileEntry {
  std::string id;
  bool list = false;
  std::vector<std::string> choices;  ///< of a choice, in that program's order
};

/// The parameters of a text that formatProfile wrote, in its order, which is that of the program's bindParameters: so
/// an index that was written beside it is understood by any later program. Lines that formatProfile never writes are
/// skipped.
[[nodiscard]] FYD_API std::vector<ProfileEntry> profileEntries(std::string_view text);

}  // namespace fyd
