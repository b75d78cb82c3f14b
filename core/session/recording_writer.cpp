#include "core/session/recording_writer.h"

#include <unistd.h>

#include <chrono>
#include <cstring>
#include <optional>

#include "core/session/recording_crc.h"
#include "core/session/recording_header.h"
#include "core/session/recording_overview.h"
#include "core/session/recording_place.h"
#include "core/session/recording_rows.h"
#include "core/session/recording_storage.h"
#include "core/session/recording_writer_on_disk.h"

namespace fyd::session {
namespace {

/// A table on disk and the rows that wait for the next commit.
struct GrowingTable {
  Hdf5Table stored;
  std::vector<std::byte> waiting;
  std::uint64_t rows = 0;  ///< stored and waiting
};

/// The last row of a table whose rows follow a value that changes only sometimes.
template <class Row>
using LastRow = std::optional<Row>;

class Hdf5RecordingWriter final : public RecordingWriter {
 public:
  Hdf5RecordingWriter(std::string path, const RecordingHeader& header, std::shared_ptr<DiskCalls> calls)
      : path_(std::move(path)), storage_(partialOf(path_), std::move(calls)) {
    try {
      begin(header);
    } catch (...) {
      ::unlink(partialOf(path_).c_str());  // made this moment, holds nothing: the name is free for the next attempt
      throw;
    }
  }

  ~Hdf5RecordingWriter() override {
    const auto lock = hdf5Lock();
    storage_.abandon();
    dropTables();
  }

  Result<void> append(const StepRecord& record) override {
    if (auto open = stillOpen(); !open) return open;
    putStep(record);
    return rowsOf(Table::telemetry) % kBlockSteps == 0 ? commit() : Result<void>{};
  }

  Result<void> append(const EncodedPicture& picture) override {
    if (auto open = stillOpen(); !open) return open;
    const std::uint64_t start = rowsOf(Table::picture_bytes);
    putBytes(Table::picture_bytes, std::as_bytes(std::span(picture.whole)));
    putBytes(Table::picture_bytes, std::as_bytes(std::span(picture.region)));
    put(Table::pictures, rowOf(picture, start));
    return {};
  }

  Result<void> append(const Note& note) override {
    if (auto open = stillOpen(); !open) return open;
    NoteRow row;
    row.when_ns = nanoseconds(note.when);
    row.text_start = rowsOf(Table::note_text);
    row.text_bytes = static_cast<std::uint32_t>(note.text.size());
    row.kind = static_cast<std::uint8_t>(note.kind);
    putBytes(Table::note_text, std::as_bytes(std::span(note.text)));
    put(Table::notes, row);
    return {};
  }

  Result<void> append(const LinkRow& row) override {
    if (auto open = stillOpen(); !open) return open;
    put(Table::link, rowOf(row));
    return {};
  }

  void countLost(std::uint64_t steps) override { lost_ += steps; }

  Result<void> commit() override {
    if (auto open = stillOpen(); !open) return open;
    auto done = guarded(path_, [&] { writeCommit(false); });
    if (done) done = unlocked([&] { storage_.persist(); });
    if (done) committed_steps_ = rowsOf(Table::telemetry);
    return endUnless(done);
  }

  Result<void> close() override {
    if (auto open = stillOpen(); !open) return open;
    auto closed = guarded(path_, [&] {
      writeCommit(true);
      dropTables();
      storage_.close();
    });
    if (closed) closed = unlocked([&] { storage_.dropJournal(); });
    if (closed) committed_steps_ = rowsOf(Table::telemetry);
    if (closed) closed = renameNew(partialOf(path_), path_);
    if (closed) closed = syncFolder(path_);
    over_ = closed ? "the recording is closed" : closed.error().message;
    return closed;
  }

  std::uint64_t committedSteps() const override { return committed_steps_; }
  std::uint64_t bytes() const override { return storage_.bytes(); }

 private:
  void begin(const RecordingHeader& header) {
    writeHeader(storage_.file(), header);
    for (std::size_t i = 0; i < kTableCount; ++i)
      tables_[i].stored = Hdf5Table::create(storage_.file(), layoutOf(static_cast<Table>(i)));
    commits_ = Hdf5Table::create(storage_.file(), commitLayout());
    storage_.flush();
    storage_.persist();
    storage_.startSwmr();
    writeCommit(false);
    storage_.persist();
  }

  [[nodiscard]] Result<void> stillOpen() const {
    if (!over_.empty()) return fail("{}: nothing more can be recorded: {}", path_, over_);
    return {};
  }

  /// As `guarded`, without HDF5's lock: waiting for the disk holds nobody up.
  template <class Work>
  Result<void> unlocked(Work&& work) {
    try {
      work();
      return {};
    } catch (const RecordingFailure& failure) {
      return fail("{}: {}", path_, failure.what());
    }
  }

  Result<void> endUnless(Result<void> result) {
    if (!result) over_ = result.error().message;
    return result;
  }

  [[nodiscard]] std::uint64_t rowsOf(Table table) const { return tables_[indexOf(table)].rows; }

  void putBytes(Table table, std::span<const std::byte> bytes) {
    GrowingTable& growing = tables_[indexOf(table)];
    growing.waiting.insert(growing.waiting.end(), bytes.begin(), bytes.end());
    growing.rows += bytes.size() / layoutOf(table).row_bytes;
  }

  template <class Row>
  void put(Table table, const Row& row) {
    putBytes(table, std::as_bytes(std::span(&row, 1)));
  }

  /// @return the row that holds the value, a new one only when any bit of it changed
  template <class Row>
  std::uint64_t follow(Table table, std::uint32_t lost, const Row& row, LastRow<Row>& last) {
    if ((lost & bitOf(table)) != 0) return kNoRow;
    if (!last || std::memcmp(&*last, &row, sizeof row) != 0) {
      put(table, row);
      last = row;
    }
    return rowsOf(table) - 1;
  }

  [[nodiscard]] std::uint64_t nextRow(Table table, std::uint32_t lost) const {
    return (lost & bitOf(table)) != 0 ? kNoRow : rowsOf(table);
  }

  template <class Items>
  std::uint8_t putAll(Table table, const Items& items) {
    for (const auto& item : items.view()) put(table, rowOf(item));
    return static_cast<std::uint8_t>(items.size());
  }

  void putStep(const StepRecord& record) {
    const pipeline::Inputs& in = record.inputs;
    const std::uint64_t step = record.telemetry.step;
    if (last_step_ && step > *last_step_ + 1) jumped_ += step - *last_step_ - 1;
    last_step_ = step;
    latest_ns_ = std::max(latest_ns_, nanoseconds(record.telemetry.now));

    StepRow row;
    row.now_ns = nanoseconds(in.now);
    row.missed_cycles = in.missed_cycles;
    const std::uint32_t lost = record.missing;
    row.finger_row = follow(Table::finger, lost, rowOf(in.finger), finger_);
    row.ir_row = follow(Table::ir, lost, rowOf(in.ir), ir_);
    row.bridge_row = follow(Table::bridge, lost, rowOf(in.bridge), bridge_);
    row.motor_feedback_row = follow(Table::motor_feedback, lost, rowOf(in.motors), motor_feedback_);
    row.robot_state_row = follow(Table::robot_state, lost, rowOf(in.robot.state), robot_state_);
    row.motor_reference_row = follow(Table::motor_reference, lost, rowOf(in.robot.motor_reference), motor_reference_);
    row.accelerations_row = nextRow(Table::accelerations, lost);
    row.commands_row = nextRow(Table::commands, lost);
    row.robot_commands_row = nextRow(Table::robot_commands, lost);
    row.changes_row = nextRow(Table::changes, lost);
    row.events_row = nextRow(Table::events, lost);
    row.accelerations = putAll(Table::accelerations, in.robot.accelerations);
    row.commands = putAll(Table::commands, in.commands);
    row.robot_commands = putAll(Table::robot_commands, in.robot.commands);
    row.changes = putAll(Table::changes, in.changes);
    for (const pipeline::Event& event : record.events.view())
      put(Table::events, rowOf(EventRow{record.telemetry.now, event}));
    row.events = static_cast<std::uint8_t>(record.events.size());
    row.phase = static_cast<std::uint8_t>(in.robot.phase);
    put(Table::steps, row);
    put(Table::motors, rowOf(record.motors));

    const TelemetryRow telemetry = rowOf(record.telemetry);
    put(Table::telemetry, telemetry);
    overview_.take(telemetry,
                   [&](Table table, std::span<const double> values) { putBytes(table, std::as_bytes(values)); });
  }

  void writeCommit(bool last) {
    CommitRow row;
    row.number = commits_.rows();
    row.utc_ns =
        std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::system_clock::now().time_since_epoch())
            .count();
    row.latest_ns = latest_ns_;
    row.jumped = jumped_;
    row.lost = lost_;
    row.closed = last ? 1 : 0;
    for (std::size_t i = 0; i < kTableCount; ++i) {
      GrowingTable& table = tables_[i];
      row.rows[i] = table.rows;
      row.crc[i] = table.waiting.empty() ? 0 : crc32c(table.waiting);
      table.stored.append(table.waiting);
      table.waiting.clear();
    }
    row.own_crc = crc32c(std::as_bytes(std::span(&row, 1)).first(offsetof(CommitRow, own_crc)));
    commits_.append(std::as_bytes(std::span(&row, 1)));
    storage_.flush();
  }

  void dropTables() {
    for (GrowingTable& table : tables_) table.stored = {};
    commits_ = {};
  }

  std::string path_;
  std::string over_;  // why nothing more can be recorded
  RecordingStorage storage_;
  std::array<GrowingTable, kTableCount> tables_;
  Hdf5Table commits_;
  OverviewBuilder overview_;
  LastRow<FingerRow> finger_;
  LastRow<IrRow> ir_;
  LastRow<BridgeRow> bridge_;
  LastRow<MotorFeedbackRow> motor_feedback_;
  LastRow<RobotStateRow> robot_state_;
  LastRow<MotorReferenceRow> motor_reference_;
  std::optional<std::uint64_t> last_step_;
  std::int64_t latest_ns_ = std::numeric_limits<std::int64_t>::min();
  std::uint64_t jumped_ = 0;
  std::uint64_t lost_ = 0;
  std::uint64_t committed_steps_ = 0;
};

}  // namespace

Result<std::unique_ptr<RecordingWriter>> createRecording(const std::string& path, const RecordingHeader& header,
                                                         std::shared_ptr<DiskCalls> calls) {
  if (auto place = checkPlace(path); !place) return tl::unexpected(place.error());
  auto writer = guarded(path, [&]() -> std::unique_ptr<RecordingWriter> {
    return std::make_unique<Hdf5RecordingWriter>(path, header, std::move(calls));
  });
  if (!writer) return writer;
  if (auto synced = syncFolder(path); !synced) return tl::unexpected(synced.error());
  return writer;
}

Result<std::unique_ptr<RecordingWriter>> RecordingWriter::create(const std::string& path,
                                                                 const RecordingHeader& header) {
  return createRecording(path, header, std::make_shared<DiskCalls>());
}

}  // namespace fyd::session
