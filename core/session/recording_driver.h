// Lets HDF5 read and write through a JournaledFile instead of the file itself.
#pragma once

#include "core/session/recording_disk.h"
#include "core/session/recording_hdf5.h"

namespace fyd::session {

/// An access property list for `file`, to be used while the caller's pointer stands; the HDF5 file then shares it,
/// because after a failed open HDF5 may keep one we cannot close, and visits it when the process ends. Each HDF5 file
/// is on its own, even when two of one process are the same file. @param find_end the file may be longer than its
/// superblock knows
[[nodiscard]] Handle accessThrough(const std::shared_ptr<JournaledFile>& file, bool find_end = false);

/// What a file opened through `accessThrough` takes on the disk. @throws RecordingFailure for another file
[[nodiscard]] std::uint64_t diskBytes(hid_t file);

}  // namespace fyd::session
