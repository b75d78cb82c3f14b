// Whole chunks of a table, past HDF5's own way of writing and reading them. That way compresses with zlib, and compares
// the hundred column names of the row's type in memory with those in the file at each call: more than half of the
// recorder's work, and of what a reader waits for. The file is the same.
//
// Failures are RecordingFailure; the caller holds the HDF5 lock.
#pragma once

#include <vector>

#include "core/session/recording_hdf5.h"

namespace fyd::session {

/// Whether the table's chunks are of the size and packing this program gives them.
[[nodiscard]] bool hasOurChunks(hid_t set, const TableLayout& layout);

/// @param first_row a chunk's first. @param rows a chunk's, or fewer for the last one, which is filled up with zeros
void writeChunk(hid_t set, const TableLayout& layout, std::uint64_t first_row, std::span<const std::byte> rows);

/// @param first_row a chunk's first. @param chunk room for all of its rows
void readChunk(hid_t set, const TableLayout& layout, std::uint64_t first_row, std::span<std::byte> chunk);

}  // namespace fyd::session
