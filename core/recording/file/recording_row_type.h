// The columns of a table's rows as a type of HDF5, both ways. Failures are RecordingFailure; the caller holds the HDF5
// lock.
#pragma once

#include "core/recording/file/recording_hdf5.h"
#include "core/recording/format/recording_format.h"

namespace fyd::recording {

/// What this program's rows of a table are in the file.
[[nodiscard]] Handle rowType(const TableLayout& layout);

/// How the file has a table. @throws RecordingFailure, as Hdf5Table::open
[[nodiscard]] TableLayout storedLayout(hid_t set, const TableLayout& today);

}  // namespace fyd::recording
