// The layout of a recording: which tables it has, what their rows hold and where they stand in the HDF5 file.
// The same is said in plain words in resources/manual/recording-format.md; kFormatVersion changes with either.
//
// Rows are little-endian, without gaps that are not named; instants are nanoseconds of the station's steady clock.
// Counts and indexes of rows are from 0.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/pipeline/inputs.h"
#include "core/session/recording_writer.h"

namespace fyd::session {

static_assert(std::endian::native == std::endian::little, "rows go into the file as they stand in memory");

inline constexpr std::uint32_t kFormatVersion = 1;
inline constexpr const char* kPartialEnding = ".partial";

enum class Table : std::uint8_t {
  telemetry,  ///< a row per step, as the next two
  steps,
  motors,
  finger,  ///< a row whenever the value changed, as the next five
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
  overview_64000
};
inline constexpr std::size_t kTableCount = 24;
inline constexpr std::uint64_t kNoRow = ~std::uint64_t{0};  ///< in StepRow: what stood there is lost
inline constexpr std::array<std::uint32_t, 5> kOverviewRows{25, kBlockSteps, 1'000, 4'000, 64'000};

struct StepRow {
  std::int64_t now_ns = 0;
  std::uint64_t missed_cycles = 0;
  std::uint64_t finger_row = 0;  ///< the value's row in its table, as the next five
  std::uint64_t ir_row = 0;
  std::uint64_t bridge_row = 0;
  std::uint64_t motor_feedback_row = 0;
  std::uint64_t robot_state_row = 0;
  std::uint64_t motor_reference_row = 0;
  std::uint64_t accelerations_row = 0;  ///< the first of this step's, as the next four
  std::uint64_t commands_row = 0;
  std::uint64_t robot_commands_row = 0;
  std::uint64_t changes_row = 0;
  std::uint64_t events_row = 0;
  std::uint8_t accelerations = 0;  ///< how many, as the next four
  std::uint8_t commands = 0;
  std::uint8_t robot_commands = 0;
  std::uint8_t changes = 0;
  std::uint8_t events = 0;
  std::uint8_t phase = 0;
  std::array<std::uint8_t, 2> reserved{};
};

struct MotorRow {
  std::array<double, control::kMotorCount> vibration_duty_percent{};
  std::array<std::int16_t, control::kMotorCount> reference_ticks{};
  std::uint8_t active = 0;
  std::array<std::uint8_t, 3> reserved{};
};

struct FingerRow {
  std::uint64_t count = 0;
  std::int64_t taken_ns = 0;
  double area_px = 0.0;
  double x_px = 0.0;
  double y_px = 0.0;
  double x_mm = 0.0;
  double y_mm = 0.0;
  double quality = 0.0;
  std::uint8_t contact = 0;
  std::uint8_t reason = 0;
  std::array<std::uint8_t, 6> reserved{};
};

struct IrRow {
  std::uint64_t count = 0;
  std::int64_t taken_ns = 0;
  std::array<std::uint16_t, sensing::kMaximumIrSensors> counts{};
  std::uint32_t sensors = 0;
  std::uint32_t reserved = 0;
};

struct BridgeRow {
  std::uint64_t count = 0;
  std::int64_t taken_ns = 0;
  double value_mV_per_V = 0.0;
};

struct MotorFeedbackRow {
  std::uint64_t count = 0;
  std::int64_t taken_ns = 0;
  std::array<double, control::kMotorCount> current_mA{};
  std::array<double, control::kMotorCount> position_duty_percent{};
  std::array<std::uint16_t, control::kMotorCount> encoder_counts{};
  std::uint8_t position_duty_known = 0;
  std::array<std::uint8_t, 3> reserved{};
};

struct RobotStateRow {
  std::uint64_t count = 0;
  std::int64_t taken_ns = 0;
  double stiffness_N_per_mm = 0.0;
  double x_mm = 0.0;
  double y_mm = 0.0;
  double z_mm = 0.0;
  std::uint8_t button = 0;
  std::array<std::uint8_t, 7> reserved{};
};

struct MotorReferenceRow {
  std::uint64_t count = 0;
  std::int64_t taken_ns = 0;
  double first_ticks = 0.0;
  double second_ticks = 0.0;
};

struct AccelerationRow {
  std::int64_t taken_ns = 0;
  double x_g = 0.0;
  double y_g = 0.0;
  double z_g = 0.0;
};

struct CommandRow {
  double value = 0.0;
  std::uint8_t action = 0;
  std::array<std::uint8_t, 7> reserved{};
};

struct RobotCommandRow {
  std::uint8_t command = 0;
};

struct ChangeRow {
  double value = 0.0;
  std::uint16_t index = 0;
  std::array<std::uint16_t, 3> reserved{};
};

struct EventTableRow {
  std::int64_t when_ns = 0;
  double value = 0.0;
  std::uint8_t kind = 0;
  std::uint8_t state = 0;
  std::uint8_t lack = 0;
  std::uint8_t reserved = 0;
  std::uint16_t index = 0;
  std::uint16_t reserved_2 = 0;
};

struct NoteRow {
  std::int64_t when_ns = 0;
  std::uint64_t text_start = 0;  ///< byte in /notes/text
  std::uint32_t text_bytes = 0;
  std::uint8_t kind = 0;
  std::array<std::uint8_t, 3> reserved{};
};

struct LinkTableRow {
  std::int64_t when_ns = 0;
  double round_trip_ms = 0.0;
  double jitter_ms = 0.0;
  double loss_percent = 0.0;
  std::uint64_t states_received = 0;
  std::uint64_t touches_sent = 0;
  std::uint64_t refused = 0;
};

struct PictureRow {
  std::int64_t taken_ns = 0;
  std::uint64_t number = 0;
  std::uint64_t bytes_start = 0;  ///< byte in /camera/bytes: the whole picture, then the region
  double area_px = 0.0;
  double x_px = 0.0;
  double y_px = 0.0;
  double x_mm = 0.0;
  double y_mm = 0.0;
  double quality = 0.0;
  std::uint32_t whole_bytes = 0;
  std::uint32_t region_bytes = 0;
  std::int32_t region_x_px = 0;
  std::int32_t region_y_px = 0;
  std::int32_t region_width_px = 0;
  std::int32_t region_height_px = 0;
  std::uint8_t contact = 0;
  std::uint8_t reason = 0;
  std::array<std::uint8_t, 6> reserved{};
};

/// The promise of the file: rows up to here are complete, and these are their checksums.
struct CommitRow {
  std::uint64_t number = 0;    ///< this row's own index
  std::int64_t utc_ns = 0;     ///< wall clock; for people only
  std::int64_t latest_ns = 0;  ///< largest `now` of the steps so far
  std::uint64_t jumped = 0;    ///< steps missing between neighbours so far
  std::uint64_t lost = 0;      ///< steps the recorder's ring could not take so far
  std::array<std::uint64_t, kTableCount> rows{};
  std::array<std::uint32_t, kTableCount> crc{};  ///< CRC32C of each table's rows since the last commit
  std::uint32_t closed = 0;                      ///< 1: the last one, nothing follows
  std::uint32_t own_crc = 0;                     ///< CRC32C of this row up to here
};

enum class ColumnType : std::uint8_t { u8, u16, u32, u64, i16, i32, i64, f64 };

struct Column {
  std::string name;
  ColumnType type = ColumnType::f64;
  std::string unit;        ///< "1" for plain numbers
  std::size_t offset = 0;  ///< bytes into the row
  std::size_t count = 1;
};

struct TableLayout {
  const char* path = "";
  std::size_t row_bytes = 0;
  std::size_t chunk_rows = 0;
  /// What fills whole chunks with each block, or nearly: a compressed chunk that is written again takes new space.
  bool compressed = false;
  std::vector<Column> columns;  ///< none: plain bytes
};

static_assert(sizeof(CommitRow) == 5 * 8 + kTableCount * 12 + 8, "no unnamed gap");

[[nodiscard]] const TableLayout& layoutOf(Table table);
[[nodiscard]] const TableLayout& commitLayout();

inline constexpr std::array<Table, kOverviewRows.size()> kOverviewTables{
    Table::overview_25, Table::overview_250, Table::overview_1000, Table::overview_4000, Table::overview_64000};
[[nodiscard]] constexpr std::size_t indexOf(Table table) { return static_cast<std::size_t>(table); }
/// As in StepRecord::missing.
[[nodiscard]] constexpr std::uint32_t bitOf(Table table) { return std::uint32_t{1} << indexOf(table); }
[[nodiscard]] constexpr std::uint32_t bitsOf(Table first, Table last) {
  return (bitOf(last) - bitOf(first)) | bitOf(last);
}
inline constexpr std::uint32_t kInputsOfStep = bitsOf(Table::finger, Table::changes);
/// What a step can be without; without its telemetry it is gone.
inline constexpr std::uint32_t kPartsOfStep = bitsOf(Table::steps, Table::events);

}  // namespace fyd::session
