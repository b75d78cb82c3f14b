// Turns rows into columns on disk, for formats that store columns, without the recording in memory.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "core/base/error.h"

namespace fyd::exports {

/// An unlinked temporary file of `columns` × `rows` doubles in a folder, mapped for reading.
class ColumnStore {
 public:
  ColumnStore(std::size_t columns, std::size_t rows) : columns_(columns), rows_(rows) {}
  ColumnStore(const ColumnStore&) = delete;
  ColumnStore& operator=(const ColumnStore&) = delete;
  ~ColumnStore();

  /// @return an error when the folder cannot be written
  [[nodiscard]] Result<void> open(const std::string& folder);
  [[nodiscard]] Result<void> put(std::size_t column, std::size_t first_row, std::span<const double> values);
  /// After the last `put`: makes the columns readable as memory.
  [[nodiscard]] Result<void> map();
  [[nodiscard]] const double* column(std::size_t index) const { return mapped_ + index * rows_; }

 private:
  std::size_t columns_;
  std::size_t rows_;
  int file_ = -1;
  const double* mapped_ = nullptr;
};

}  // namespace fyd::exports
