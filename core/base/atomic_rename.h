// Gives a file another name in one step: another program sees the old name or the new one.
#pragma once

#include <cstdint>
#include <string>
#include <system_error>

namespace fyd {

enum class ExistingFile : std::uint8_t { keep, replace };

/// @param existing keep: `std::errc::file_exists` when the name `to` is taken. On a file system that can neither rename
/// without replacing nor link (a share), another program could take the name in between.
/// @return empty when done
[[nodiscard]] std::error_code renameAtomically(const std::string& from, const std::string& to, ExistingFile existing);

}  // namespace fyd
