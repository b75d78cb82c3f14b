// The layout of a recording: which tables it has, what their rows hold and where they stand in the HDF5 file.
// resources/manual/recording-format.md describes it for users. Tables and columns may be added: a reader
// goes by their names. kFormatVersion changes when a program that does not know of a change would read wrongly.
//
// What a row holds is described beside the struct it holds, how it stands there in recording_row.h.
// Counts and indexes of rows are from 0.
#pragma once

#include <algorithm>

#include "core/recording/format/recording_row.h"
#include "core/recording/format/step_row.h"
#include "core/recording/recording_types.h"

namespace fyd::recording {

inline constexpr std::uint32_t kFormatVersion = 1;
inline constexpr const char* kPartialEnding = ".partial";
/// Steps in a committed block, and one bucket of the finest level of the min/max pyramid.
inline constexpr std::size_t kBlockSteps = 250;

enum class Table : std::uint8_t {
  telemetry,  ///< a row per step, as the next two
  steps,
  motors,
  finger,  ///< the inputs' tables (pipeline::Inputs::tables): a row whenever the value changed, as the next five
  ir,
  bridge,
  motor_feedback,
  robot_state,
  motor_reference,
  accelerations,  ///< a row for each one that came
  commands,
  robot_commands,
  changes,
  events,
  notes,
  note_text,
  link,
  pictures,
  picture_bytes,
  overview_25,  ///< smallest and largest of each field over so many rows, as the next four
  overview_250,
  overview_1000,
  overview_4000,
  overview_64000  ///< inputs that came later follow
};
inline constexpr std::size_t kTableCount = std::apply(
    [](const auto&... table) {
      return std::max({static_cast<std::size_t>(Table::overview_64000) + 1, (table.number + 1)...});
    },
    kInputTables);
static_assert(kTableCount <= 32, "StepRecord::missing has a bit for each");
inline constexpr std::array<std::uint32_t, 5> kOverviewRows{25, kBlockSteps, 1'000, 4'000, 64'000};

/// A row of /notes/index.
struct NoteIndex {
  Instant when{};
  std::uint64_t text_start = 0;
  std::uint32_t text_bytes = 0;
  NoteKind kind = NoteKind::note;

  static constexpr auto fields() {
    using N = NoteIndex;
    return std::tuple(Field("when_ns", "ns", "when it was made", &N::when),
                      Field("text_start", "byte", "where its text begins in /notes/text", &N::text_start),
                      Field("text_bytes", "byte", "length of its text", &N::text_bytes),
                      Field("kind", "1", "NoteKind: its number", &N::kind));
  }
};

/// A row of /camera/index.
struct PictureIndex {
  Instant taken{};
  std::uint64_t number = 0;
  std::uint64_t bytes_start = 0;
  sensing::FingerDetection finger;
  std::uint32_t whole_bytes = 0;
  std::uint32_t region_bytes = 0;
  cv::Rect region_px;

  static constexpr auto fields() {
    using P = PictureIndex;
    const auto region = [](auto member) { return inside(&P::region_px, member); };
    return std::tuple_cat(
        std::tuple(Field("taken_ns", "ns", "when it was taken", &P::taken),
                   Field("number", "1", "the camera's", &P::number),
                   Field("bytes_start", "byte", "where it begins in /camera/bytes", &P::bytes_start)),
        part<sensing::FingerDetection>(&P::finger),
        std::tuple(Field("whole_bytes", "byte", "of the whole picture; 0: an earlier one shows it", &P::whole_bytes),
                   Field("region_bytes", "byte", "of the region of interest, which follows", &P::region_bytes),
                   Field("region_x_px", "px", "left edge of the region in the whole picture", region(&cv::Rect::x)),
                   Field("region_y_px", "px", "upper edge of it", region(&cv::Rect::y)),
                   Field("region_width_px", "px", "width of it", region(&cv::Rect::width)),
                   Field("region_height_px", "px", "height of it", region(&cv::Rect::height))));
  }
};

/// One commit: rows up to these counts are complete, with the checksums of those added since the commit before.
struct CommitRow {
  std::uint64_t number = 0;
  std::int64_t utc_ns = 0;
  std::int64_t latest_ns = 0;
  std::uint64_t jumped = 0;
  std::uint64_t lost = 0;
  std::array<std::uint64_t, kTableCount> rows{};
  std::array<std::uint32_t, kTableCount> crc{};
  std::uint32_t closed = 0;
  std::uint32_t own_crc = 0;

  static constexpr auto fields() {
    using C = CommitRow;
    return std::tuple(
        Field("number", "1", "its own row", &C::number),
        Field("utc_ns", "ns", "wall clock, for people only", &C::utc_ns),
        Field("latest_ns", "ns", "largest now_ns of /telemetry so far", &C::latest_ns),
        Field("jumped", "1", "steps missing between neighbours so far", &C::jumped),
        Field("lost", "1", "steps the recorder could not take so far", &C::lost),
        Field("rows", "1", "rows of each table so far, in the tables' order", &C::rows),
        Field("crc", "1", "CRC32C of each table's rows since the commit before; 0 when there are none", &C::crc),
        Field("closed", "1", "1 in the last row of a whole recording", &C::closed),
        Field("own_crc", "1", "CRC32C of this row up to here", &C::own_crc));
  }
};
static_assert(sizeof(CommitRow) == kShape<CommitRow>.bytes, "it is written as it stands in memory");

struct TableLayout {
  const char* path = "";
  std::string_view help;  ///< what a row is
  std::size_t row_bytes = 0;
  std::size_t chunk_rows = 0;
  /// Only where each block fills whole chunks, or nearly: a compressed chunk that is written again takes new space.
  bool compressed = false;
  bool small = false;            ///< its chunks hold as many rows as fit into kSmallChunkBytes
  std::vector<Column> columns;   ///< none: plain bytes
  std::vector<std::byte> fresh;  ///< the row of a new struct: what a column that a recording faults is read as
};
inline constexpr std::size_t kSmallChunkBytes = 4'096;  // written again with each commit while it is the last

[[nodiscard]] const TableLayout& layoutOf(Table table);
[[nodiscard]] const TableLayout& commitLayout();
/// The column of a field (index into telemetryFields()).
[[nodiscard]] inline const Column& telemetryColumn(std::size_t field) {
  return layoutOf(Table::telemetry).columns[field + 1];  // the first is the exact instant, which is no field
}
/// Rows in a chunk of a small table.
[[nodiscard]] std::size_t chunkRowsOf(std::size_t row_bytes);

inline constexpr std::array<Table, kOverviewRows.size()> kOverviewTables{
    Table::overview_25, Table::overview_250, Table::overview_1000, Table::overview_4000, Table::overview_64000};
[[nodiscard]] constexpr std::size_t indexOf(Table table) { return static_cast<std::size_t>(table); }
/// As in StepRecord::missing.
[[nodiscard]] constexpr std::uint32_t bitOf(Table table) { return std::uint32_t{1} << indexOf(table); }
/// 0: there is no such table.
[[nodiscard]] std::uint32_t bitOfPath(std::string_view path);
inline constexpr std::uint32_t kInputsOfStep =
    std::apply([](const auto&... table) { return ((std::uint32_t{1} << table.number) | ...); }, kInputTables);
/// Parts that a readable step may have lost; a step without its telemetry is lost as a whole.
inline constexpr std::uint32_t kPartsOfStep =
    kInputsOfStep | bitOf(Table::steps) | bitOf(Table::motors) | bitOf(Table::events);

}  // namespace fyd::recording
