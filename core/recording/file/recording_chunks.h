// Writes and reads whole chunks of a table directly (H5Dwrite_chunk, H5Dread_chunk). H5Dwrite and H5Dread compress with
// zlib, and compare the hundred column names of the row's type in memory with those in the file at each call: more than
// half of the recorder's work, and of a reader's waiting time. The file format is the same.
//
// Failures are RecordingFailure; the caller holds the HDF5 lock.
#pragma once

#include <vector>

#include "core/recording/file/recording_hdf5.h"
#include "core/recording/format/recording_format.h"

namespace fyd::recording {

/// Whether the table's chunks are of the size and packing this program gives them.
[[nodiscard]] bool hasOurChunks(hid_t set, const TableLayout& layout);

/// @param first_row a chunk's first. @param rows a chunk's, or fewer for the last one, which is filled up with zeros
void writeChunk(hid_t set, const TableLayout& layout, std::uint64_t first_row, std::span<const std::byte> rows);

/// @param first_row a chunk's first. @param chunk room for all of its rows
void readChunk(hid_t set, const TableLayout& layout, std::uint64_t first_row, std::span<std::byte> chunk);

}  // namespace fyd::recording
