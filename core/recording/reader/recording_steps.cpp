#include "core/recording/reader/recording_steps.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "core/recording/format/step_row.h"

namespace fyd::recording {
namespace {

/// Fills a record table by table; with `known`, what cannot be read becomes missing instead of an error.
class StepReader {
 public:
  StepReader(const RecordingTables& tables, std::uint32_t missing, KnownDamage* known)
      : tables_(tables), known_(known) {
    record_.missing = missing;
  }

  template <class Value>
  void take(Table table, std::uint64_t index, Value& value) {
    part(
        table, index, 1, [&] { tables_.read(table, index, value); }, value);
  }

  template <class Items>
  void takeAll(Table table, std::uint64_t first, std::uint64_t count, Items& items) {
    const auto read = [&] {
      if (count > Items::capacity()) failHard("{}: {} in one step", layoutOf(table).path, count);
      for (std::uint64_t i = 0; i < count; ++i) tables_.read(table, first + i, items.items[i]);
      items.count = static_cast<std::uint32_t>(count);
    };
    part(table, first, count, read, items);
  }

  /// Rows [first, first + count) of the table, read by `read` into `value`.
  template <class Read, class Value>
  void part(Table table, std::uint64_t first, std::uint64_t count, Read&& read, Value& value) {
    if ((record_.missing & bitOf(table)) != 0) return;
    if (known_ == nullptr) return read();
    try {
      for (std::uint64_t i = 0; i < std::min<std::uint64_t>(count, kMostOfAStep); ++i) checkBlock(table, first + i);
      read();
    } catch (const RecordingFailure& failure) {
      if (!known_->has(table, first)) known_->add(table, first, first + 1, failure.message);
      record_.missing |= bitOf(table);
      value = Value();
    }
  }

  /// Finds a damaged block once, not for each of its rows.
  void checkBlock(Table table, std::uint64_t row) {
    if (known_->has(table, row)) throw RecordingFailure(known_->why(table));
    try {
      (void)tables_.block(table, row);
    } catch (const RecordingFailure& failure) {
      known_->add(table, row, row < tables_.rows(table) ? tables_.rowAfterDamage(table, row) : row + 1,
                  failure.message);
      throw;
    }
  }

  [[nodiscard]] StepRecord& record() { return record_; }

 private:
  static constexpr std::uint64_t kMostOfAStep = 256;  // a count is a byte

  const RecordingTables& tables_;
  KnownDamage* known_;
  StepRecord record_;
};

StepRecord read(const RecordingTables& tables, std::uint32_t missing, std::uint64_t row, KnownDamage* known) {
  StepReader reader(tables, missing, known);
  StepRecord& record = reader.record();
  if (known != nullptr) reader.checkBlock(Table::telemetry, row);
  tables.read(Table::telemetry, row, record.telemetry);
  reader.take(Table::motors, row, record.motors);

  ReadStepRow at{record.inputs, {}};
  const auto read_at = [&] { tables.read(Table::steps, row, at); };
  reader.part(Table::steps, row, 1, read_at, record.inputs);
  if ((record.missing & bitOf(Table::steps)) != 0) {
    record.missing |= kInputsOfStep | bitOf(Table::events);
    record.inputs.now = record.telemetry.now;
    record.inputs.robot.phase = record.telemetry.link;
    return record;
  }
  forEachOf(kInputTables, [&](auto i, const auto& input) {
    const auto table = static_cast<Table>(input.number);
    if (!tables.has(table)) return;  // recorded before there was this input
    auto& value = input.of(record.inputs);
    if constexpr (kIsList<std::remove_cvref_t<decltype(value)>>)
      reader.takeAll(table, at.places.row[i], at.places.count[i], value);
    else
      reader.take(table, at.places.row[i], value);
  });
  const std::uint64_t first_event = at.places.row[kInputTableCount];
  const std::uint64_t events = at.places.count[kInputTableCount];
  const auto read_events = [&] {
    for (std::uint64_t i = 0; i < events; ++i)
      if (!record.events.push(tables.value<EventRow>(Table::events, first_event + i).event))
        failHard("row {}: {} events", row, events);
  };
  reader.part(Table::events, first_event, events, read_events, record.events);
  return record;
}

}  // namespace

MissingParts::MissingParts(std::span<const MissingRows> missing) {
  // Where an entry begins or ends, in the order of the rows: entries may overlap, and a file may hold very many.
  struct Edge {
    std::uint64_t row;
    std::uint32_t bits;
    bool begins;
  };
  std::vector<Edge> edges;
  for (const MissingRows& rows : missing) {
    const std::uint32_t bits = bitOfPath(rows.table) & kPartsOfStep;
    if (bits == 0 || rows.count == 0) continue;
    edges.push_back({rows.first, bits, true});
    edges.push_back({rows.first + std::min(rows.count, kNoRow - rows.first), bits, false});
  }
  std::ranges::sort(edges, {}, &Edge::row);
  std::array<std::int64_t, std::numeric_limits<std::uint32_t>::digits> open{};  // entries that cover the row, by bit
  for (const Edge& edge : edges) {
    std::uint32_t covered = 0;
    for (std::size_t i = 0; i < open.size(); ++i) {
      const std::uint32_t bit = std::uint32_t{1} << i;
      if ((edge.bits & bit) != 0) open[i] += edge.begins ? 1 : -1;
      if (open[i] > 0) covered |= bit;
    }
    from_.insert_or_assign(from_.end(), edge.row, covered);
  }
}

std::uint32_t MissingParts::at(std::uint64_t row) const {
  const auto after = from_.upper_bound(row);
  return after == from_.begin() ? 0 : std::prev(after)->second;
}

StepRecord readStep(const RecordingTables& tables, const MissingParts& missing, std::uint64_t row) {
  return read(tables, missing.at(row), row, nullptr);
}

StepRecord readDamagedStep(const RecordingTables& tables, const MissingParts& missing, std::uint64_t row,
                           KnownDamage& known) {
  return read(tables, missing.at(row), row, &known);
}

}  // namespace fyd::recording
