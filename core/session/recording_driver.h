// Lets HDF5 read and write through a JournaledFile instead of the file itself.
#pragma once

#include "core/session/recording_disk.h"
#include "core/session/recording_hdf5.h"

namespace fyd::session {

/// An access property list for `file`, which must outlive the HDF5 file; each HDF5 file is on its own, even when two
/// of one process are the same file. @param find_end the file may be longer than its superblock knows
[[nodiscard]] Handle accessThrough(JournaledFile& file, bool find_end = false);

}  // namespace fyd::session
