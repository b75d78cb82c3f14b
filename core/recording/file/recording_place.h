// Where a recording lies: names, the kind of file system, the lock that a running recorder holds, syncing of folders.
#pragma once

#include <string>

#include "core/base/error.h"

namespace fyd::recording {

[[nodiscard]] std::string partialOf(const std::string& path);
/// FILE, also for FILE.partial: the recording gets that name when it is recovered.
[[nodiscard]] std::string wholeOf(std::string path);
/// `path`, or the unfinished file beside it when only that is there.
[[nodiscard]] std::string existingName(const std::string& path);
/// Where the notes of a recording stand, or would stand: beside it, in FILE.notes.json; those of FILE.partial too, so
/// that they stay with it when it is recovered. Of a link they are those of the file that it leads to. Earlier versions
/// wrote FILE.partial.notes.json, and LINK.notes.json: that is it where only that is there.
[[nodiscard]] std::string reviewNotesPath(const std::string& recording_path);

/// The kind of network share that the folder lies on; nullptr: on none, or it cannot be asked.
[[nodiscard]] const char* networkShareOf(const std::string& folder);
/// @return an error when a recording cannot begin there: no folder, not writable, a network share, a name taken, or notes
///         of another recording that had this name
[[nodiscard]] Result<void> checkPlace(const std::string& path);
/// Syncs the file's folder, so that renamed and new names in it survive a power cut.
[[nodiscard]] Result<void> syncFolder(const std::string& path);
/// Gives the file its new name; never replaces another file.
[[nodiscard]] Result<void> renameNew(const std::string& from, const std::string& to);

/// @param file_descriptor opened for writing; the lock is released with its last close, however the process ends
[[nodiscard]] bool lockAsRecorder(int file_descriptor);
[[nodiscard]] bool recorderRuns(int file_descriptor);

}  // namespace fyd::recording
