// What the catalogue knows of a recording, and how one asks it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/session/recording.h"

namespace fyd::session {

/// How the file stood when it was last looked at.
enum class FileState : std::uint8_t {
  present,
  missing,  ///< not at its path nor in the known folders
  replaced  ///< its path holds something else now
};

/// All texts are UTF-8 without control characters; only `notes` may hold line ends and tabs.
struct CatalogueEntry {
  std::string id;           ///< of the recording, 1 to 64 letters, digits and dashes
  std::string path;         ///< absolute, as `station` sees it
  std::string station;      ///< host that put it in; only this one looks after the file
  std::string started_utc;  ///< ISO 8601
  double duration_s = 0.0;
  std::string operator_name;
  std::string subject;            ///< code, never a name
  std::vector<std::string> tags;  ///< sorted when read back
  std::string notes;
  std::string touchpad;  ///< words of the station's options
  std::string robot;
  std::uint64_t samples = 0;
  std::uint64_t gaps = 0;  ///< samples lost
  std::uint64_t events = 0;
  Wholeness wholeness = Wholeness::whole;
  std::string health;                 ///< one word, see healthOf
  std::uint64_t bytes = 0;            ///< of the file
  std::int64_t file_modified_ns = 0;  ///< since 1970; with `bytes` it tells whether the file changed
  FileState file_state = FileState::present;
};

enum class SessionOrder : std::uint8_t { started, duration, operator_name, subject, bytes, path };

/// Empty fields ask for nothing. Letters' case never matters in `text` and `tags`.
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

[[nodiscard]] const char* toString(Wholeness wholeness);
[[nodiscard]] const char* toString(FileState state);

}  // namespace fyd::session
