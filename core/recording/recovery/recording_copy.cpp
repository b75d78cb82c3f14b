#include "core/recording/recovery/recording_copy.h"

#include <algorithm>
#include <limits>

#include "core/recording/file/recording_header.h"

namespace fyd::recording {
namespace {

constexpr double kStepsCopied = 0.7;  // share of the time; the rest is for the pictures

/// Neighbours that are missing for the same reason are one entry.
class MissingList {
 public:
  /// The step `row` is there, without what the table held for it.
  void addPart(Table table, std::uint64_t row, const std::string& why) {
    if (MissingRows* last = lastOf(table); last != nullptr && last->first + last->count == row && last->why == why)
      ++last->count;
    else
      add({layoutOf(table).path, row, 1, why}, table);
  }
  /// Rows that are gone before `row`.
  void addGone(Table table, std::uint64_t row, std::uint64_t count, const std::string& why) {
    if (MissingRows* last = lastOf(table); last != nullptr && last->first == row && last->why == why)
      last->count += count;
    else
      add({layoutOf(table).path, row, count, why}, table);
  }
  void add(MissingRows rows) { list_.push_back(std::move(rows)); }

  [[nodiscard]] std::vector<MissingRows> take() { return std::move(list_); }

 private:
  void add(MissingRows rows, Table table) {
    last_[indexOf(table)] = list_.size();
    list_.push_back(std::move(rows));
  }
  [[nodiscard]] MissingRows* lastOf(Table table) {
    const auto& last = last_[indexOf(table)];
    return last ? &list_[*last] : nullptr;
  }

  std::vector<MissingRows> list_;
  std::array<std::optional<std::size_t>, kTableCount> last_;
};

class Copy {
 public:
  Copy(const std::string& path, const DamagedRecording& from, RecordingWriter* to)
      : name_(path + ": "), from_(from), to_(to) {
    for (const MissingRows& rows : from_.info().header.missing) {
      if (rows.table == kHeaderTable) missing_.add(rows);
      for (std::size_t i = 0; i < kTableCount; ++i)
        if (rows.table == layoutOf(static_cast<Table>(i)).path) earlier_[i].push_back(&rows);
    }
    for (auto& entries : earlier_)
      std::ranges::stable_sort(entries, {}, [](const MissingRows* rows) { return rows->first; });
  }

  Result<CopyOutcome> run(const Progress& progress) {
    if (auto done = steps(partOf(progress, 0.0, kStepsCopied)); !done) return tl::unexpected(done.error());
    // A write error in any of these makes `close` fail too.
    list(Table::notes, [&](std::uint64_t i) { return copy(from_.note(i)); });
    list(Table::link, [&](std::uint64_t i) { return copy(from_.linkRow(i)); });
    if (auto done = pictures(partOf(progress, kStepsCopied, 1.0)); !done) return tl::unexpected(done.error());
    outcome_.missing = missing_.take();
    return std::move(outcome_);
  }

 private:
  Result<void> steps(const Progress& progress) {
    const TableRows rows = from_.rowsOf(Table::telemetry);
    for (std::uint64_t row = 0; row < rows.committed; ++row) {
      const double done = static_cast<double>(row) / static_cast<double>(rows.committed);
      if (auto told = row % kBlockSteps == 0 ? tellProgress(progress, done) : Result<void>(); !told) return told;
      carryOver(Table::telemetry, row, outcome_.steps);
      const auto record = from_.damagedStep(row, known_);
      if (!record) {
        outcome_.first_lost = outcome_.first_lost || row == 0;
        ++outcome_.lost_steps;
        missing_.addGone(Table::telemetry, outcome_.steps, 1, known_.why(Table::telemetry).text());
        continue;
      }
      if (record->missing != 0) addParts(record->missing, row);
      if (to_ != nullptr)
        if (auto put = to_->append(*record); !put) return put;
      ++outcome_.steps;
    }
    carryOverRest(Table::telemetry, outcome_.steps);
    outcome_.lost_steps += rows.in_file - rows.committed;
    unproven(Table::telemetry, rows, outcome_.steps);
    return {};
  }

  void addParts(std::uint32_t lost, std::uint64_t row) {
    if ((lost & bitOf(Table::steps)) != 0) lost &= ~(kInputsOfStep | bitOf(Table::events));  // implied by /inputs/steps
    for (std::size_t i = 0; i < kTableCount; ++i)
      if (const auto table = static_cast<Table>(i); (lost & bitOf(table)) != 0)
        missing_.addPart(table, outcome_.steps, whyOf(table, row));
  }

  [[nodiscard]] std::string whyOf(Table table, std::uint64_t row) {
    const auto& entries = earlier_[indexOf(table)];
    std::size_t& next = explained_[indexOf(table)];
    while (next < entries.size() && row >= entries[next]->first && row - entries[next]->first >= entries[next]->count)
      ++next;
    if (next < entries.size() && row >= entries[next]->first) return entries[next]->why;
    return known_.why(table).text();
  }

  Result<void> pictures(const Progress& progress) {
    const auto all = static_cast<double>(from_.info().frames);
    Result<void> told;
    list(Table::pictures, [&](std::uint64_t i) -> Result<void> {
      if (told) told = tellProgress(progress, static_cast<double>(i) / all);
      if (!told) return {};
      if (auto put = copy(from_.encodedPicture(i)); !put) return put;
      if (to_ != nullptr && i % 100 == 99) (void)to_->commit();
      return {};
    });
    return told;
  }

  /// Each row that can be read; the others are gone.
  template <class CopyRow>
  void list(Table table, CopyRow&& copy_row) {
    const TableRows rows = from_.rowsOf(table);
    std::uint64_t copied = 0;
    for (std::uint64_t i = 0; i < rows.committed; ++i) {
      carryOver(table, i, copied);
      if (const auto done = copy_row(i); done)
        ++copied;
      else
        missing_.addGone(table, copied, 1, withoutName(done.error().text()));
    }
    carryOverRest(table, copied);
    unproven(table, rows, copied);
  }

  template <class Row>
  Result<void> copy(const Result<Row>& row) {
    if (!row) return tl::unexpected(row.error());
    if (to_ != nullptr) (void)to_->append(*row);
    return {};
  }

  [[nodiscard]] std::string withoutName(const std::string& message) const {
    return message.starts_with(name_) ? message.substr(name_.size()) : message;
  }

  void unproven(Table table, const TableRows& rows, std::uint64_t copied) {
    if (rows.in_file > rows.committed)
      missing_.addGone(table, copied, rows.in_file - rows.committed, "no sound commit proves them");
  }

  /// What an earlier recovery lost before this row, and not yet told.
  void carryOver(Table table, std::uint64_t row, std::uint64_t copied) {
    const auto& entries = earlier_[indexOf(table)];
    std::size_t& next = carried_[indexOf(table)];
    for (; next < entries.size() && entries[next]->first <= row; ++next)
      missing_.addGone(table, copied, entries[next]->count, entries[next]->why);
  }

  /// What it lost at the end, or behind what can be proven now.
  void carryOverRest(Table table, std::uint64_t copied) {
    carryOver(table, std::numeric_limits<std::uint64_t>::max(), copied);
  }

  std::string name_;  // what errors begin with
  const DamagedRecording& from_;
  RecordingWriter* to_;
  KnownDamage known_;
  std::array<std::vector<const MissingRows*>, kTableCount> earlier_;  // of an earlier recovery, by row
  // Rows come in order, and of entries there may be very many: those before these places are done with.
  std::array<std::size_t, kTableCount> carried_{};
  std::array<std::size_t, kTableCount> explained_{};
  MissingList missing_;
  CopyOutcome outcome_;
};

}  // namespace

Result<CopyOutcome> copyReadable(const std::string& path, const DamagedRecording& from, RecordingWriter* to,
                                 const Progress& progress) {
  return Copy(path, from, to).run(progress);
}

}  // namespace fyd::recording
