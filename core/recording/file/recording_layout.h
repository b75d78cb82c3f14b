// Whether a file is built as this program builds recordings, asked before a row or a text of it is read.
//
// HDF5 lets a file say that its values lie in another file, behind a pipe, in a hundred other datasets, or in one chunk
// of a gigabyte. A recording has none of this: everything stands in the file itself, in chunks of this program's size
// and packing, and counts no more rows than its bytes can hold. So time and memory of its readers are bounded by the
// file's length.
//
// Failures are RecordingFailure and name the object; the caller holds the HDF5 lock.
#pragma once

#include "core/recording/file/recording_disk.h"
#include "core/recording/file/recording_hdf5.h"
#include "core/recording/format/recording_format.h"

namespace fyd::recording {

/// Before HDF5 sees the file: its first bytes are a superblock as the recorder writes it.
void checkStart(const JournaledFile& disk);
/// Bytes that a closed recording says to have, after checkStart; 0: it was not closed, and may say more than was written.
[[nodiscard]] std::uint64_t closedLength(const JournaledFile& disk);

/// A table's dataset, and how its rows are laid out. Every reader of rows opens it here.
struct OpenedTable {
  Handle set;
  TableLayout stored;
};
[[nodiscard]] OpenedTable openTable(hid_t file, const TableLayout& layout);
/// The dataset of a text or of bytes. Every reader of one opens it here.
[[nodiscard]] Handle openValue(hid_t file, const char* path);

/// Rows that a table which cannot be opened may have: of those that are read row by row no more than the file has room for.
[[nodiscard]] std::uint64_t mostUnopened(hid_t file, Table table);

/// Rows that commit `number` can count: the recorder writes one after 250 steps at the latest.
[[nodiscard]] std::uint64_t mostRows(Table table, std::uint64_t number);
/// Whether a commit's row counts are within mostRows() and agree with each other.
[[nodiscard]] bool countsArePlausible(const CommitRow& row);

}  // namespace fyd::recording
