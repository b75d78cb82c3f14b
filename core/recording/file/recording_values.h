// Single values of a recording's HDF5 file: texts, bytes, and numbers of the root group. Failures are RecordingFailure;
// the caller holds the HDF5 lock.
#pragma once

#include <string>

#include "core/recording/file/recording_hdf5.h"

namespace fyd::recording {

inline constexpr std::uint64_t kLongestText = 64U << 20U;
/// Single texts, and numbers of the root group; absent or of another kind: RecordingFailure.
void writeText(hid_t file, const char* path, const std::string& text);
[[nodiscard]] std::string readText(hid_t file, const char* path);
/// A list of bytes, no text.
void writeBytes(hid_t file, const char* path, const std::string& bytes);
[[nodiscard]] std::string readBytes(hid_t file, const char* path, std::uint64_t most = kLongestText);
void writeNumber(hid_t file, const char* attribute, std::int64_t value);
[[nodiscard]] std::int64_t readNumber(hid_t file, const char* attribute);

}  // namespace fyd::recording
