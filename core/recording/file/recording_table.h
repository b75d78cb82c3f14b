// One table of a recording in its HDF5 file: rows appended and read. Failures are RecordingFailure; the caller holds
// the HDF5 lock.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/recording/file/recording_hdf5.h"
#include "core/recording/format/recording_conversion.h"

namespace fyd::recording {

/// One growing table.
class Hdf5Table {
 public:
  Hdf5Table() = default;
  static Hdf5Table create(hid_t file, const TableLayout& layout);
  /// @throws RecordingFailure when it is missing, stored otherwise than this program does, or a column of a name this
  /// program knows is of another type. There may be more or fewer columns, at other offsets: `rows()` and what is read
  /// and appended are as in the file; see conversion()
  static Hdf5Table open(hid_t file, const TableLayout& layout);
  [[nodiscard]] bool isOpen() const { return static_cast<bool>(set_); }
  [[nodiscard]] const RowConversion& conversion() const { return conversion_; }
  [[nodiscard]] std::size_t rowBytes() const { return layout_->row_bytes; }
  /// nullptr: the file has no column of this name.
  [[nodiscard]] const Column* column(std::string_view name) const;

  void append(std::span<const std::byte> rows);
  void read(std::uint64_t first, std::uint64_t count, std::span<std::byte> out) const;
  /// Takes in what another process has written.
  void refresh();
  [[nodiscard]] std::uint64_t rows() const { return rows_; }

 private:
  void readExtent();
  void appendChunks(std::span<const std::byte> rows);
  void appendRows(std::span<const std::byte> rows);

  const TableLayout* layout_ = nullptr;  // as the file has it
  std::unique_ptr<const TableLayout> own_;
  RowConversion conversion_;
  Handle set_;
  Handle type_;
  std::uint64_t rows_ = 0;
  bool made_here_ = false;             // and so written chunk by chunk
  std::vector<std::byte> unfinished_;  // the last chunk's rows, while it is not full
};

}  // namespace fyd::recording
