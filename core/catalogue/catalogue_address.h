// Selects a catalogue by the word after --catalogue, and gives the paths of this user's own files.
//
//   (empty), sqlite            SQLite at $XDG_DATA_HOME/fyd-console/sessions.sqlite
//   sqlite:PATH, PATH          SQLite there; a bare PATH holds a '/' or ends in .sqlite
//   postgresql:host=… dbname=… user=…   libpq's words, or postgresql://user@host/database
//   none                       no catalogue
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace fyd::catalogue {

struct CatalogueAddress {
  enum class Kind : std::uint8_t { none, sqlite, postgresql };
  Kind kind = Kind::sqlite;
  std::string target;  ///< absolute path, or libpq's words with every value quoted
  std::string name;    ///< for messages: the path, or host and database
  std::string key;     ///< the same for every spelling of the same words; the key of waiting entries
};

/// @return an error for an unknown word, and for one that contains a password: the word appears in logs and in lists of
/// processes, so libpq must find the password itself ($PGPASSFILE, ~/.pgpass, $PGPASSWORD, a service file)
[[nodiscard]] Result<CatalogueAddress> parseCatalogueAddress(std::string_view word);

/// Whether it is this user's own catalogue, which a word left out means.
[[nodiscard]] bool isDefault(const CatalogueAddress& address);

/// $XDG_DATA_HOME/fyd-console or ~/.local/share/fyd-console; not created.
[[nodiscard]] std::string catalogueFolder();
/// Entries that could not be delivered wait here.
[[nodiscard]] std::string pendingPath();
/// This host's name.
[[nodiscard]] std::string stationName();

}  // namespace fyd::catalogue
