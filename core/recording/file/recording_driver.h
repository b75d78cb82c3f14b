// Lets HDF5 read and write through a JournaledFile instead of the file itself.
#pragma once

#include "core/recording/file/recording_disk.h"
#include "core/recording/file/recording_hdf5.h"

namespace fyd::recording {

/// An access property list for `file`, to be used while the caller's pointer is valid; the HDF5 file then shares
/// ownership, because after a failed open HDF5 may keep an open file that cannot be closed, and uses it when the
/// process ends. Each HDF5 file is separate, even when two of one process are the same file. @param find_end the file
/// may be longer than its superblock says
[[nodiscard]] Handle accessThrough(const std::shared_ptr<JournaledFile>& file, bool find_end = false);

/// Bytes on the disk of a file opened through `accessThrough`. @throws RecordingFailure for another file
[[nodiscard]] std::uint64_t diskBytes(hid_t file);

}  // namespace fyd::recording
