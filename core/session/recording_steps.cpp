#include "core/session/recording_steps.h"

#include <algorithm>

#include "core/session/recording_rows.h"
#include "core/session/recording_telemetry_row.h"

namespace fyd::session {
namespace {

std::uint32_t bitOf(const std::string& path) {
  for (std::size_t i = 0; i < kTableCount; ++i)
    if (path == layoutOf(static_cast<Table>(i)).path) return session::bitOf(static_cast<Table>(i)) & kPartsOfStep;
  return 0;
}

void expect(const Result<void>& result) {
  if (!result) throw RecordingFailure(result.error().message);
}

/// Fills a record table by table; with `known`, what cannot be read becomes missing instead of an error.
class StepReader {
 public:
  StepReader(const RecordingTables& tables, std::uint32_t missing, KnownDamage* known)
      : tables_(tables), known_(known) {
    record_.missing = missing;
  }

  template <class Row, class Value>
  void take(Table table, std::uint64_t index, Value& value) {
    part(
        table, index, 1, [&] { expect(valueOf(tables_.row<Row>(table, index), value)); }, value);
  }

  template <class Row, class Items>
  void takeAll(Table table, std::uint64_t first, std::uint64_t count, Items& items) {
    const auto read = [&] {
      if (count > Items::capacity()) failHard("{}: {} in one step", layoutOf(table).path, count);
      for (std::uint64_t i = 0; i < count; ++i) expect(valueOf(tables_.row<Row>(table, first + i), items.items[i]));
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
      if (!known_->has(table, first)) known_->add(table, first, first + 1, failure.what());
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
      known_->add(table, row, row < tables_.rows(table) ? tables_.rowAfterDamage(table, row) : row + 1, failure.what());
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
  record.telemetry = sampleOf(tables.row<TelemetryRow>(Table::telemetry, row));
  reader.take<MotorRow>(Table::motors, row, record.motors);

  StepRow at;
  pipeline::Inputs& in = record.inputs;
  const auto read_at = [&] {
    at = tables.row<StepRow>(Table::steps, row);
  };
  reader.part(Table::steps, row, 1, read_at, at);
  if ((record.missing & bitOf(Table::steps)) != 0) {
    record.missing |= kInputsOfStep | bitOf(Table::events);
    in.now = record.telemetry.now;
    in.robot.phase = record.telemetry.link;
    return record;
  }
  in.now = instantOf(at.now_ns);
  in.missed_cycles = at.missed_cycles;
  in.robot.phase = static_cast<pipeline::LinkPhase>(at.phase);
  reader.take<FingerRow>(Table::finger, at.finger_row, in.finger);
  reader.take<IrRow>(Table::ir, at.ir_row, in.ir);
  reader.take<BridgeRow>(Table::bridge, at.bridge_row, in.bridge);
  reader.take<MotorFeedbackRow>(Table::motor_feedback, at.motor_feedback_row, in.motors);
  reader.take<RobotStateRow>(Table::robot_state, at.robot_state_row, in.robot.state);
  reader.take<MotorReferenceRow>(Table::motor_reference, at.motor_reference_row, in.robot.motor_reference);
  reader.takeAll<AccelerationRow>(Table::accelerations, at.accelerations_row, at.accelerations, in.robot.accelerations);
  reader.takeAll<CommandRow>(Table::commands, at.commands_row, at.commands, in.commands);
  reader.takeAll<RobotCommandRow>(Table::robot_commands, at.robot_commands_row, at.robot_commands, in.robot.commands);
  reader.takeAll<ChangeRow>(Table::changes, at.changes_row, at.changes, in.changes);
  const auto read_events = [&] {
    for (std::uint64_t i = 0; i < at.events; ++i) {
      EventRow event;
      expect(valueOf(tables.row<EventTableRow>(Table::events, at.events_row + i), event));
      if (!record.events.push(event.event)) failHard("row {}: {} events", row, at.events);
    }
  };
  reader.part(Table::events, at.events_row, at.events, read_events, record.events);
  return record;
}

}  // namespace

MissingParts::MissingParts(std::span<const MissingRows> missing) {
  for (const MissingRows& rows : missing) {
    const std::uint32_t bit = bitOf(rows.table);
    if (bit == 0 || rows.count == 0) continue;
    const std::uint64_t end = rows.first + std::min(rows.count, kNoRow - rows.first);
    from_.try_emplace(end, at(end));
    for (auto here = from_.try_emplace(rows.first, at(rows.first)).first; here->first != end; ++here)
      here->second |= bit;
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

}  // namespace fyd::session
