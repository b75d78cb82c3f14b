// Rows of a recording by another program as this program has them: columns are found by their names.
#pragma once

#include "core/recording/format/recording_format.h"

namespace fyd::recording {

class RowConversion {
 public:
  RowConversion() = default;
  /// @param stored as the file has it. @param today of the same table
  RowConversion(const TableLayout& stored, const TableLayout& today);

  [[nodiscard]] bool needed() const { return needed_; }
  /// A column that the file faults has the value of a new struct.
  [[nodiscard]] std::vector<std::byte> toToday(std::vector<std::byte> stored_rows) const;
  /// Puts what this program knows of a row into one as the file has it.
  void putBack(std::span<const std::byte> today_row, std::span<std::byte> stored_row) const;

  [[nodiscard]] const std::vector<std::string>& lacking() const { return lacking_; }  ///< columns the file has not
  [[nodiscard]] const std::vector<std::string>& unknown() const { return unknown_; }  ///< that this program has not

 private:
  struct Piece {
    std::size_t stored = 0;
    std::size_t today = 0;
    std::size_t bytes = 0;
  };
  std::vector<Piece> pieces_;
  std::size_t stored_bytes_ = 0;
  std::vector<std::byte> fresh_;
  bool needed_ = false;
  std::vector<std::string> lacking_;
  std::vector<std::string> unknown_;
};

}  // namespace fyd::recording
