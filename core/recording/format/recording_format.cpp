#include "core/recording/format/recording_format.h"

#include "core/recording/format/step_row.h"

namespace fyd::recording {
namespace {

constexpr std::size_t kPictureChunkBytes = 32'768;

template <class T>
TableLayout compressedSteps(const char* path, std::string_view help, const T& fresh = {}) {
  const auto row = toRow(fresh);
  return {path, help, row.size(), kBlockSteps, true, false, columnsOf<T>(), {row.begin(), row.end()}};
}

template <class T>
TableLayout sometimes(const char* path, std::string_view help) {
  const auto row = toRow(T());
  return {path, help, row.size(), chunkRowsOf(row.size()), false, true, columnsOf<T>(), {row.begin(), row.end()}};
}

/// Values that may come with nearly every step: a block fills several chunks, and only its last is written twice.
template <class T>
TableLayout often(const char* path, std::string_view help) {
  const auto row = toRow(T());
  return {path, help, row.size(), 64, true, false, columnsOf<T>(), {row.begin(), row.end()}};
}

TableLayout plainBytes(const char* path, std::string_view help, std::size_t chunk) {
  return {path, help, 1, chunk, false, false, {}, {}};
}

TableLayout overviewLayout(const char* path, std::string_view help, std::size_t chunk_rows, bool compressed) {
  TableLayout layout{path, help, 0, chunk_rows, compressed, false, {}, {}};
  for (const pipeline::TelemetryField& field : pipeline::telemetryFields())
    for (const char* end : {"_min", "_max"}) {
      layout.columns.push_back({std::string(field.name) + end, ColumnType::f64, std::string(field.unit),
                                layout.row_bytes, 1, std::string(field.help)});
      layout.row_bytes += sizeof(double);
      const auto none = std::bit_cast<std::array<std::byte, sizeof(double)>>(pipeline::kNone);
      layout.fresh.insert(layout.fresh.end(), none.begin(), none.end());
    }
  return layout;
}

template <class V>
struct ItemOf {
  using Type = V;
};
template <class V, std::size_t N>
struct ItemOf<Batch<V, N>> {
  using Type = V;
};

std::array<TableLayout, kTableCount> makeLayouts() {
  std::array<TableLayout, kTableCount> out;
  const auto put = [&](Table table, TableLayout layout) { out[indexOf(table)] = std::move(layout); };
  static constexpr pipeline::Inputs kNothing;
  put(Table::telemetry, compressedSteps<pipeline::TelemetrySample>("/telemetry", "a step"));
  put(Table::steps, compressedSteps("/inputs/steps", "a step: what it was given", WrittenStepRow{kNothing, {}}));
  put(Table::motors, compressedSteps<control::MotorCommand>("/motors", "a step: what the motors were told"));
  forEachOf(kInputTables, [&](auto, const auto& table) {
    using T = typename ItemOf<FieldValue<decltype(table), pipeline::Inputs>>::Type;
    out[table.number] = table.often ? often<T>(table.path, table.help) : sometimes<T>(table.path, table.help);
  });
  put(Table::events, sometimes<EventRow>("/events", "an event of the step"));
  put(Table::notes, sometimes<NoteIndex>("/notes/index", "a note, a bookmark, a trial's mark or an alarm"));
  put(Table::note_text, plainBytes("/notes/text", "a byte of the notes' texts, UTF-8", kSmallChunkBytes));
  put(Table::link, sometimes<LinkRow>("/link", "a second of the robot's link"));
  put(Table::pictures, sometimes<PictureIndex>("/camera/index", "a picture"));
  put(Table::picture_bytes, plainBytes("/camera/bytes", "a byte of the pictures, JPEG and PNG", kPictureChunkBytes));
  constexpr std::string_view kRange = "smallest and largest of each telemetry field over so many steps";
  put(Table::overview_25, overviewLayout("/overview/rows_25", kRange, kBlockSteps / 25, true));
  put(Table::overview_250, overviewLayout("/overview/rows_250", kRange, 8, false));
  put(Table::overview_1000, overviewLayout("/overview/rows_1000", kRange, 8, false));
  put(Table::overview_4000, overviewLayout("/overview/rows_4000", kRange, 8, false));
  put(Table::overview_64000, overviewLayout("/overview/rows_64000", kRange, 8, false));
  return out;
}

}  // namespace

const TableLayout& layoutOf(Table table) {
  static const std::array<TableLayout, kTableCount> kLayouts = makeLayouts();
  return kLayouts[indexOf(table)];
}

const TableLayout& commitLayout() {
  static const TableLayout kLayout = sometimes<CommitRow>("/commits", "a promise of what is complete");
  return kLayout;
}

std::uint32_t bitOfPath(std::string_view path) {
  for (std::size_t i = 0; i < kTableCount; ++i)
    if (path == layoutOf(static_cast<Table>(i)).path) return bitOf(static_cast<Table>(i));
  return 0;
}

std::size_t chunkRowsOf(std::size_t row_bytes) { return std::max<std::size_t>(1, kSmallChunkBytes / row_bytes); }

}  // namespace fyd::recording
