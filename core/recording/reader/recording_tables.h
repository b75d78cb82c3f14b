// The committed rows of a recording, block by block: found through the commits, checked against their CRC32C when
// first read, kept in a cache of bounded size. Failures are RecordingFailure; the caller holds the HDF5 lock.
//
// When no recorder is running, every commit row is checked once: damaged ones are replaced, in memory, by what can be
// proven of them (recording_mend.h), so that rows after a damaged commit stay readable.
#pragma once

#include <list>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/recording/file/recording_table.h"

namespace fyd::recording {

/// The rows of one table over some neighbouring commits, as this program lays them out (layoutOf).
struct RecordingBlock {
  std::uint64_t first = 0;
  std::uint64_t count = 0;
  std::vector<std::byte> bytes;
  [[nodiscard]] bool holds(std::uint64_t row) const { return row >= first && row - first < count; }
};

class RecordingTables {
 public:
  /// @param growing a recorder is running: uncommitted rows are no damage
  /// @param damaged a table that HDF5 cannot open is one whose every row is unreadable, but for the telemetry's
  RecordingTables(hid_t file, bool growing, bool damaged = false);

  /// Takes in what was committed since. @return whether there was news
  bool refresh();

  [[nodiscard]] std::uint64_t commits() const { return commit_count_; }
  /// The last commit that can be trusted.
  [[nodiscard]] const CommitRow& last() const { return last_; }
  [[nodiscard]] std::uint64_t rows(Table table) const { return last_.rows[indexOf(table)]; }
  /// Rows in the file, committed or not.
  [[nodiscard]] std::uint64_t present(Table table) const {
    return unopened_[indexOf(table)].empty() ? tables_[indexOf(table)].rows() : rows(table);
  }
  [[nodiscard]] CommitRow commit(std::uint64_t number) const;
  /// Numbers of the commit rows that are damaged, rising; none while it grows.
  [[nodiscard]] const std::vector<std::uint64_t>& damagedCommits() const { return damaged_; }
  /// The first commit at which the table has more than `row` rows.
  [[nodiscard]] std::uint64_t commitOf(Table table, std::uint64_t row) const;

  /// The block with `row`; stays valid as long as the pointer is held.
  [[nodiscard]] std::shared_ptr<const RecordingBlock> block(Table table, std::uint64_t row) const;

  /// What stands in the row. @tparam T the struct that the table's rows describe
  template <class T>
  void read(Table table, std::uint64_t index, T& out) const {
    const RecordingBlock& in = blockAt(table, index);
    if (!fromRow(in.bytes.data() + (index - in.first) * kShape<T>.bytes, out))
      failHard("{}: row {} has a list that counts more than it can hold", layoutOf(table).path, index);
  }
  template <class T>
  [[nodiscard]] T value(Table table, std::uint64_t index) const {
    T out;
    read(table, index, out);
    return out;
  }
  /// false: it was recorded before there was this table.
  [[nodiscard]] bool has(Table table) const {
    return tables_[indexOf(table)].isOpen() || !unopened_[indexOf(table)].empty();
  }
  /// Columns, with their tables, that this program has and the file has not, and the other way round.
  [[nodiscard]] std::vector<std::string> missingColumns() const;
  [[nodiscard]] std::vector<std::string> unknownColumns() const;
  [[nodiscard]] std::string bytes(Table table, std::uint64_t first, std::uint64_t count) const;

  /// The first row after the damaged block that holds `row`.
  [[nodiscard]] std::uint64_t rowAfterDamage(Table table, std::uint64_t row) const;

 private:
  using Key = std::uint64_t;
  using Cached = std::pair<Key, std::shared_ptr<const RecordingBlock>>;

  const RecordingBlock& blockAt(Table table, std::uint64_t row) const;
  std::shared_ptr<const RecordingBlock> load(Table table, std::uint64_t first_commit, std::uint64_t end_commit) const;
  [[nodiscard]] std::vector<std::byte> readCommits(std::uint64_t first, std::uint64_t count) const;
  CommitRow storedCommit(std::uint64_t number) const;
  std::optional<CommitRow> soundCommit(std::uint64_t number) const;
  void readEachCommit(RecordingBlock& block) const;
  std::shared_ptr<const RecordingBlock> commitBlock(std::uint64_t number) const;
  void remember(Key key, std::shared_ptr<const RecordingBlock> block) const;
  bool findLast();
  void lookAtCommits(hid_t file);

  std::array<Hdf5Table, kTableCount> tables_;
  std::array<Message, kTableCount> unopened_;  ///< why a table cannot be opened; empty: it is open, or not there
  Hdf5Table commit_table_;
  std::uint64_t commit_count_ = 0;
  CommitRow last_;
  bool growing_;
  std::vector<std::uint64_t> damaged_;
  std::unordered_map<std::uint64_t, CommitRow> mended_;

  mutable std::list<Cached> newest_first_;
  mutable std::unordered_map<Key, std::list<Cached>::iterator> cache_;
  mutable std::size_t cached_bytes_ = 0;
  mutable std::array<std::shared_ptr<const RecordingBlock>, kTableCount> recent_;
};

}  // namespace fyd::recording
