// Implements recording.h and recording_salvage.h over an HDF5 file.
#include "core/recording/reader/recording.h"

#include <set>
#include <string_view>

#include "core/recording/file/picture_decode.h"
#include "core/recording/file/recording_header.h"
#include "core/recording/file/recording_place.h"
#include "core/recording/reader/recorded_profile.h"
#include "core/recording/reader/recording_salvage.h"
#include "core/recording/reader/recording_source.h"
#include "core/recording/reader/recording_span.h"
#include "core/recording/reader/recording_steps.h"
#include "core/recording/reader/recording_tables.h"
#include "core/recording/reader/recording_wholeness.h"

namespace fyd::recording {
namespace {

class Hdf5Recording final : public DamagedRecording {
 public:
  Hdf5Recording(std::string path, bool damaged) : source_(std::make_unique<RecordingSource>(path)) {
    info_.path = std::move(path);
    info_.header = damaged ? salvageHeader(source_->file()) : readHeader(source_->file());
    missing_.emplace(info_.header.missing);
    indices_.emplace(info_.header);
    tables_.emplace(source_->file(), source_->growing(), damaged);
    look();
  }
  ~Hdf5Recording() override {
    const auto lock = hdf5Lock();
    tables_.reset();
    source_->close();
  }

  const RecordingInfo& info() const override { return info_; }

  Result<bool> refresh() override {
    return guarded(info_.path, [&] {
      const Wholeness before = info_.wholeness;
      const std::uint64_t commits = commits_;
      // A failed read means that a write is under way, or that the recorder ended in the middle of one.
      if (source_->recorderEnded() || !takenIn() || source_->recorderEnded()) openAnew();
      look();
      return commits_ != commits || info_.wholeness != before;
    });
  }

  Result<void> telemetry(std::uint64_t first, std::span<pipeline::TelemetrySample> out) const override {
    return reading([&] {
      eachRow(first, out.size(), [&](std::size_t i, const std::byte* row) {
        (void)fromRow(row, out[i]);  // it has no list
      });
    });
  }

  Result<void> field(std::size_t field, std::uint64_t first, std::span<double> out) const override {
    return reading([&] {
      checkField(field);
      eachRow(first, out.size(),
              [&](std::size_t i, const std::byte* row) { out[i] = numberIn(row, telemetryColumn(field)); });
    });
  }

  Result<StepRecord> step(std::uint64_t row) const override {
    return reading([&] {
      StepRecord record = readStep(*tables_, *missing_, row);
      for (pipeline::ParameterChange& change : record.inputs.changes.view()) {
        indices_->translate(change.index, change.value);
      }
      for (pipeline::Event& event : record.events.view()) translate(event);
      return record;
    });
  }

  Result<StepRecord> damagedStep(std::uint64_t row, KnownDamage& known) const override {
    return reading([&] { return readDamagedStep(*tables_, *missing_, row, known); });
  }

  Result<std::uint64_t> rowAt(double time_s) const override {
    return reading([&] { return firstRowAt(*tables_, instantAtSecond(time_s)); });
  }

  Result<Overview> overview(std::size_t field, double from_s, double to_s, std::size_t buckets) const override {
    return reading([&] {
      checkField(field);
      const std::uint64_t first = firstRowAt(*tables_, instantAtSecond(from_s));
      const std::int64_t last_ns = instantAtSecond(to_s);
      const std::uint64_t end = last_ns == std::numeric_limits<std::int64_t>::max() ? tables_->rows(Table::telemetry)
                                                                                    : firstRowAt(*tables_, last_ns + 1);
      return overviewOf(*tables_, info_.header.started, field, first, end, buckets);
    });
  }

  Result<RecordedPicture> pictureAt(double time_s) const override {
    return reading([&] {
      const std::int64_t when_ns = instantAtSecond(time_s);
      std::uint64_t low = 0;
      std::uint64_t high = tables_->rows(Table::pictures);
      while (low < high) {
        const std::uint64_t middle = low + (high - low) / 2;
        if (nanoseconds(tables_->value<PictureIndex>(Table::pictures, middle).taken) > when_ns)
          high = middle;
        else
          low = middle + 1;
      }
      if (low == 0) failHard("no picture was taken up to {} s", time_s);
      return pictureOf(low - 1);
    });
  }

  Result<RecordedPicture> picture(std::uint64_t index) const override {
    return reading([&] { return pictureOf(index); });
  }

  Result<EncodedPicture> encodedPicture(std::uint64_t index) const override {
    return reading([&] { return encodedOf(index); });
  }

  Result<std::vector<EventRow>> events() const override {
    return all<EventRow>(Table::events, [&](std::uint64_t i) {
      auto row = tables_->value<EventRow>(Table::events, i);
      translate(row.event);
      return row;
    });
  }
  Result<std::vector<LinkRow>> linkRows() const override {
    return all<LinkRow>(Table::link, [&](std::uint64_t i) { return tables_->value<LinkRow>(Table::link, i); });
  }
  Result<std::vector<Note>> notes() const override {
    std::uint64_t end = 0;  // of the texts so far: many notes of one text would take the square of the file's length
    return all<Note>(Table::notes, [&](std::uint64_t i) {
      const auto row = tables_->value<NoteIndex>(Table::notes, i);
      if (i == 0) end = 0;
      if (row.text_start < end)
        failHard("{}: row {} says that its text begins at byte {}; expected {} or more, behind the text before it",
                 layoutOf(Table::notes).path, i, row.text_start, end);
      Note note = noteOf(i);
      end = row.text_start + row.text_bytes;
      return note;
    });
  }

  Result<Note> note(std::uint64_t index) const override {
    return reading([&] { return noteOf(index); });
  }
  Result<LinkRow> linkRow(std::uint64_t index) const override {
    return reading([&] { return tables_->value<LinkRow>(Table::link, index); });
  }
  TableRows rowsOf(Table table) const override { return {tables_->rows(table), tables_->present(table)}; }

 private:
  /// Runs `work`, which reads, and repeats it when it fails because the recorder ended in the middle of a write: what
  /// is incomplete in its place is complete in the journal.
  template <class Work>
  auto reading(Work&& work) const -> Result<decltype(work())> {
    auto result = guarded(info_.path, work);
    if (result || !source_->recorderEnded()) return result;
    if (const auto anew = guarded(info_.path, [&] { openAnew(); }); !anew) return tl::unexpected(anew.error());
    return guarded(info_.path, work);
  }

  /// @return whether what was committed since could be read
  [[nodiscard]] bool takenIn() const {
    try {
      (void)tables_->refresh();
      return true;
    } catch (const RecordingFailure&) {
      return false;
    }
  }

  /// Opens the file again, with the journal of the ended recorder. When this fails, the old one stays open.
  void openAnew() const {
    auto source = source_->again();
    tables_ = RecordingTables(source->file(), source->growing());
    source_ = std::move(source);
  }

  /// Of an event that names a parameter, as this program counts them.
  void translate(pipeline::Event& event) const {
    if (event.namesParameter()) indices_->translate(event.index, event.value);
  }

  void look() {
    commits_ = tables_->commits();
    judge(*source_, *tables_, info_);
    info_.duration_s =
        info_.committed_samples == 0 ? 0.0 : secondsInto(info_, Instant(Duration(tables_->last().latest_ns)));
    info_.bytes = source_->bytes();
    info_.missing_columns = tables_->missingColumns();
    std::set<std::string_view> named(info_.missing_columns.begin(), info_.missing_columns.end());
    std::vector<std::string> more;  // apart: the names in the set stay where they are
    for (const std::string& column : info_.header.lacking)
      if (named.insert(column).second) more.push_back(column);
    info_.missing_columns.insert(info_.missing_columns.end(), more.begin(), more.end());
    info_.unknown_columns = tables_->unknownColumns();
  }

  /// Saturates, because a recording's start is arbitrary.
  [[nodiscard]] std::int64_t instantAtSecond(double time_s) const {
    if (std::isnan(time_s)) failHard("NaN is no time");
    const auto sum = WideTime{nanoseconds(info_.header.started)} + fromSeconds(time_s).count();
    constexpr auto kLeast = std::numeric_limits<std::int64_t>::min();
    constexpr auto kMost = std::numeric_limits<std::int64_t>::max();
    return sum < kLeast ? kLeast : sum > kMost ? kMost : static_cast<std::int64_t>(sum);
  }

  /// Without a sum, which could overflow: the four numbers are arbitrary.
  static bool isInside(const cv::Rect& region, const cv::Size& whole) {
    return region.x >= 0 && region.y >= 0 && region.width > 0 && region.height > 0 && region.width <= whole.width &&
           region.height <= whole.height && region.x <= whole.width - region.width &&
           region.y <= whole.height - region.height;
  }

  static void checkField(std::size_t field) {
    if (field >= pipeline::telemetryFields().size())
      failHard("field {} of {}", field, pipeline::telemetryFields().size());
  }

  template <class Use>
  void eachRow(std::uint64_t first, std::size_t count, Use&& use) const {
    if (first > tables_->rows(Table::telemetry) || count > tables_->rows(Table::telemetry) - first)
      failHard("rows {}+{} of {}", first, count, tables_->rows(Table::telemetry));
    for (std::size_t i = 0; i < count;) {
      const auto block = tables_->block(Table::telemetry, first + i);
      for (; i < count && block->holds(first + i); ++i) {
        use(i, block->bytes.data() + (first + i - block->first) * layoutOf(Table::telemetry).row_bytes);
      }
    }
  }

  [[nodiscard]] Note noteOf(std::uint64_t index) const {
    const auto row = tables_->value<NoteIndex>(Table::notes, index);
    return {row.when, row.kind, tables_->bytes(Table::note_text, row.text_start, row.text_bytes)};
  }

  template <class Value, class Read>
  Result<std::vector<Value>> all(Table table, Read&& read) const {
    return reading([&] {
      std::vector<Value> values;  // not reserved: the row count may be wrong
      for (std::uint64_t i = 0; i < tables_->rows(table); ++i) values.push_back(read(i));
      return values;
    });
  }

  [[nodiscard]] EncodedPicture encodedOf(std::uint64_t index) const {
    const auto row = tables_->value<PictureIndex>(Table::pictures, index);
    EncodedPicture picture{.taken = row.taken,
                           .number = row.number,
                           .whole = {},
                           .region = {},
                           .region_px = row.region_px,
                           .finger = row.finger};
    const std::string whole = tables_->bytes(Table::picture_bytes, row.bytes_start, row.whole_bytes);
    const std::string region =
        tables_->bytes(Table::picture_bytes, row.bytes_start + row.whole_bytes, row.region_bytes);
    picture.whole.assign(whole.begin(), whole.end());
    picture.region.assign(region.begin(), region.end());
    return picture;
  }

  [[nodiscard]] RecordedPicture pictureOf(std::uint64_t index) const {
    const EncodedPicture stored = encodedOf(index);
    RecordedPicture picture{.time_s = secondsInto(info_, stored.taken),
                            .number = stored.number,
                            .whole = decodePicture(wholeAt(index), "the whole picture"),
                            .region = decodePicture(stored.region, "the region"),
                            .region_px = stored.region_px,
                            .finger = stored.finger};
    if (isInside(picture.region_px, picture.whole.size()) && picture.region.size() == picture.region_px.size() &&
        picture.region.type() == picture.whole.type())
      picture.region.copyTo(picture.whole(picture.region_px));
    return picture;
  }

  /// The newest JPEG up to that picture; nothing when none is near.
  [[nodiscard]] std::vector<std::uint8_t> wholeAt(std::uint64_t index) const {
    for (std::uint64_t back = 0; back <= std::min(index, kFarthestWhole); ++back) {
      const auto row = tables_->value<PictureIndex>(Table::pictures, index - back);
      if (row.whole_bytes == 0) continue;
      const std::string bytes = tables_->bytes(Table::picture_bytes, row.bytes_start, row.whole_bytes);
      return {bytes.begin(), bytes.end()};
    }
    return {};
  }

  RecordingInfo info_;
  std::uint64_t commits_ = 0;  // that info_ describes
  mutable std::unique_ptr<RecordingSource> source_;
  std::optional<MissingParts> missing_;
  std::optional<RecordedIndices> indices_;
  mutable std::optional<RecordingTables> tables_;
};

}  // namespace

Result<std::unique_ptr<Recording>> Recording::open(const std::string& path) {
  return openedAsItIs(path, [](const std::string& found) -> std::unique_ptr<Recording> {
    return std::make_unique<Hdf5Recording>(found, false);
  });
}

Result<std::unique_ptr<DamagedRecording>> DamagedRecording::open(const std::string& path) {
  return guarded(path,
                 [&]() -> std::unique_ptr<DamagedRecording> { return std::make_unique<Hdf5Recording>(path, true); });
}

std::vector<std::string> missingTables(const StepRecord& record) {
  std::vector<std::string> paths;
  for (std::size_t i = 0; i < kTableCount; ++i) {
    const auto table = static_cast<Table>(i);
    if ((record.missing & bitOf(table)) != 0) paths.emplace_back(layoutOf(table).path);
  }
  return paths;
}

}  // namespace fyd::recording
