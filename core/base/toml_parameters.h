// Tables of a TOML text as parameters: strict, with file, line and what is allowed in every error. Included
// only by the sources of the readers, not by their callers.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "core/base/error.h"
#include "core/base/parameter.h"

namespace fyd {

/// More are refused: each part of a key is a table within a table, and toml++ destroys these by recursion.
inline constexpr std::size_t kMostKeyParts = 16;

/// @return an error with source name and line when it is not TOML, and for a key of more than kMostKeyParts
[[nodiscard]] Result<toml::table> parseToml(std::string_view text, std::string_view source_name);

/// "file:line", as every error of a reader begins.
[[nodiscard]] std::string place(std::string_view source_name, const toml::node& node);

/// A value that was read and checked, not yet stored.
struct TomlAssignment {
  const Parameter* parameter;
  double value = 0.0;
  ParameterList list;
  std::string text;

  void store() const;
};

/// Every key of the table as the parameter `module.key`, added to what was read. An unknown key, a wrong type, a value
/// out of range or not finite is refused.
[[nodiscard]] Result<void> readTable(const toml::table& table, std::string_view module, std::string_view source_name,
                                     std::span<const Parameter> parameters, Ranges ranges, std::string_view listed_by,
                                     std::vector<TomlAssignment>& read);

}  // namespace fyd
