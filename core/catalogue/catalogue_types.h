// The catalogue's entry for a recording, and the filter of a search.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/recording/reader/recording.h"

namespace fyd::catalogue {

/// State of the file when it was last checked.
enum class FileState : std::uint8_t {
  present,
  missing,  ///< not at its path nor in the known folders
  replaced  ///< another file has its path now
};

/// All texts are UTF-8 without control characters; only `notes` may hold line ends and tabs.
struct CatalogueEntry {
  std::string id;           ///< of the recording, 1 to 64 letters, digits and dashes
  std::string path;         ///< absolute, as `station` sees it
  std::string station;      ///< host that added it; only this one checks the file
  std::string started_utc;  ///< ISO 8601
  double duration_s = 0.0;
  std::string operator_name;
  std::string subject;            ///< code, never a name
  std::vector<std::string> tags;  ///< sorted when read back
  std::string notes;
  std::string touchpad;  ///< as in the station's options
  std::string robot;
  std::uint64_t samples = 0;
  std::uint64_t gaps = 0;  ///< samples lost
  std::uint64_t events = 0;
  recording::Wholeness wholeness = recording::Wholeness::whole;
  std::string health;                 ///< one word, see healthOf
  std::uint64_t bytes = 0;            ///< of the file
  std::int64_t file_modified_ns = 0;  ///< since 1970; with `bytes` it shows whether the file changed
  FileState file_state = FileState::present;
};

enum class SessionOrder : std::uint8_t { started, duration, operator_name, subject, bytes, path };

/// Empty fields do not restrict the search. `text` and `tags` are case-insensitive.
struct SessionFilter {
  std::string text;               ///< every word of it, in operator, subject, notes or a tag
  std::vector<std::string> tags;  ///< all of them
  std::string since;              ///< UTC: "2026-11-21", "2026-11-21T14:05", "2026-11-21T14:05:09.250Z"
  std::string until;              ///< the same; the day, minute or second named is included
  std::string operator_name;      ///< exactly; so are the next four
  std::string subject;
  std::string station;
  std::string health;
  std::string id;
  SessionOrder order = SessionOrder::started;
  bool descending = true;
  std::size_t limit = 0;  ///< 0: all
  std::size_t offset = 0;
};

[[nodiscard]] const char* toString(recording::Wholeness wholeness);
[[nodiscard]] const char* toString(FileState state);

}  // namespace fyd::catalogue
