#include "core/recording/writer/recording_writer.h"

#include <unistd.h>

#include <chrono>
#include <cstring>
#include <new>
#include <optional>

#include "core/base/checksum.h"
#include "core/recording/file/recording_disk.h"
#include "core/recording/file/recording_header.h"
#include "core/recording/file/recording_place.h"
#include "core/recording/file/recording_storage.h"
#include "core/recording/file/recording_table.h"
#include "core/recording/format/recording_overview.h"
#include "core/recording/format/step_row.h"
#include "core/recording/writer/recording_writer.h"

namespace fyd::recording {
namespace {

/// A table on disk and the rows that wait for the next commit.
struct GrowingTable {
  Hdf5Table stored;
  std::vector<std::byte> waiting;
  std::uint64_t rows = 0;  ///< stored and waiting
};

class Hdf5RecordingWriter final : public RecordingWriter {
 public:
  Hdf5RecordingWriter(std::string path, const RecordingHeader& header, std::shared_ptr<DiskCalls> calls)
      : path_(std::move(path)), storage_(partialOf(path_), std::move(calls)) {
    try {
      begin(header);
    } catch (...) {
      ::unlink(partialOf(path_).c_str());  // just made and empty: removing it frees the name for the next attempt
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
    put(Table::pictures, PictureIndex{.taken = picture.taken,
                                      .number = picture.number,
                                      .bytes_start = start,
                                      .finger = picture.finger,
                                      .whole_bytes = static_cast<std::uint32_t>(picture.whole.size()),
                                      .region_bytes = static_cast<std::uint32_t>(picture.region.size()),
                                      .region_px = picture.region_px});
    return {};
  }

  Result<void> append(const Note& note) override {
    if (auto open = stillOpen(); !open) return open;
    put(Table::notes, NoteIndex{.when = note.when,
                                .text_start = rowsOf(Table::note_text),
                                .text_bytes = static_cast<std::uint32_t>(note.text.size()),
                                .kind = note.kind});
    putBytes(Table::note_text, std::as_bytes(std::span(note.text)));
    return {};
  }

  Result<void> append(const LinkRow& row) override {
    if (auto open = stillOpen(); !open) return open;
    put(Table::link, row);
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
    if (closed) closed = checkSafe();
    if (closed) closed = renameNew(partialOf(path_), path_);
    if (closed) closed = syncFolder(path_);
    over_ = closed ? say("the recording is closed") : closed.error().message;
    return closed;
  }

  std::uint64_t committedSteps() const override { return committed_steps_; }
  std::uint64_t bytes() const override { return storage_.bytes(); }
  bool safe() const override { return storage_.isStill(partialOf(path_)); }
  Result<void> checkSafe() const override {
    if (safe()) return {};
    return fail("{}: it is not the file any more that was written", partialOf(path_));
  }

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

  /// As `guarded`, without HDF5's lock, so that waiting for the disk does not block other threads.
  template <class Work>
  Result<void> unlocked(Work&& work) {
    try {
      work();
      return {};
    } catch (const RecordingFailure& failure) {
      return fail(about(path_, failure.message));
    } catch (const std::bad_alloc&) {
      return fail("{}: out of memory", path_);
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

  template <class T>
  void put(Table table, const T& value) {
    putBytes(table, toRow(value));
  }

  /// @return the row that holds the value, a new one only when any bit of it changed
  template <class T>
  std::uint64_t follow(Table table, const T& value) {
    const auto row = toRow(value);
    std::vector<std::byte>& last = last_rows_[indexOf(table)];
    if (!std::ranges::equal(last, row)) {
      putBytes(table, row);
      last.assign(row.begin(), row.end());
    }
    return rowsOf(table) - 1;
  }

  StepPlaces putInputs(const StepRecord& record) {
    StepPlaces at;
    const auto lost = [&](Table table) { return (record.missing & bitOf(table)) != 0; };
    forEachOf(kInputTables, [&](auto i, const auto& input) {
      const auto table = static_cast<Table>(input.number);
      const auto& value = input.of(record.inputs);
      if constexpr (kIsList<std::remove_cvref_t<decltype(value)>>) {
        if (!lost(table)) at.row[i] = rowsOf(table);
        at.count[i] = static_cast<std::uint8_t>(value.size());
        for (const auto& item : value.view()) put(table, item);
      } else if (!lost(table)) {
        at.row[i] = follow(table, value);
      }
    });
    if (!lost(Table::events)) at.row[kInputTableCount] = rowsOf(Table::events);
    at.count[kInputTableCount] = static_cast<std::uint8_t>(record.events.size());
    for (const pipeline::Event& event : record.events.view()) put(Table::events, EventRow{record.telemetry.now, event});
    return at;
  }

  void putStep(const StepRecord& record) {
    const std::uint64_t step = record.telemetry.step;
    if (last_step_ && step > *last_step_ + 1) jumped_ += step - *last_step_ - 1;
    last_step_ = step;
    latest_ns_ = std::max(latest_ns_, nanoseconds(record.telemetry.now));
    put(Table::steps, WrittenStepRow{record.inputs, putInputs(record)});
    put(Table::motors, record.motors);
    put(Table::telemetry, record.telemetry);
    overview_.take(record.telemetry,
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
  Message over_;  // why nothing more can be recorded
  RecordingStorage storage_;
  std::array<GrowingTable, kTableCount> tables_;
  Hdf5Table commits_;
  OverviewBuilder overview_;
  std::array<std::vector<std::byte>, kTableCount> last_rows_;  // of tables that follow a value
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
  if (auto synced = syncFolder(path); !synced) {
    writer->reset();
    ::unlink(partialOf(path).c_str());  // it holds no step yet: removing it frees the name for the next attempt
    return tl::unexpected(synced.error());
  }
  return writer;
}

Result<std::unique_ptr<RecordingWriter>> RecordingWriter::create(const std::string& path,
                                                                 const RecordingHeader& header) {
  return createRecording(path, header, std::make_shared<DiskCalls>());
}

}  // namespace fyd::recording
