// Repairs commit rows whose own checksum is wrong, as far as their content can be proven.
//
//   one bit was flipped       flipping it back, and no other bit, makes the row's own CRC32C right: all of it is known
//   more is wrong with it     what it says of one table is taken when the table's rows have the CRC32C it names; of
//                             the other tables those rows are lost
#pragma once

#include <functional>
#include <span>

#include "core/recording/file/recording_table.h"

namespace fyd::recording {

/// Whether the row is commit `number`, as it was written.
[[nodiscard]] bool intact(const CommitRow& row, std::uint64_t number);

using TableOf = std::function<const Hdf5Table&(Table table)>;

class CommitMender {
 public:
  explicit CommitMender(TableOf tables) : tables_(std::move(tables)) {}

  /// @param found the row as it stands in the file, not intact. @param before the commit before, sound or mended
  /// @param most rows of each table it can have reached
  /// @return its number; row counts from those of `before` to `most`. A block it cannot prove is either left out or
  ///         has a checksum that its rows do not have
  [[nodiscard]] CommitRow mended(const CommitRow& found, std::uint64_t number, const CommitRow& before,
                                 const std::array<std::uint64_t, kTableCount>& most);

 private:
  [[nodiscard]] bool proven(Table table, std::uint64_t first, std::uint64_t end, std::uint32_t crc,
                            std::vector<std::byte>& rows);

  TableOf tables_;
  // Limits on the work of opening a badly damaged file; beyond them nothing is proven.
  std::uint64_t bytes_left_ = 256U << 20U;
  std::uint64_t rows_left_ = 4096;  // commit rows tried by flipping one bit after the other
};

}  // namespace fyd::recording
