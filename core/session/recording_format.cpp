#include "core/session/recording_format.h"

#include "core/session/recording_telemetry_row.h"

namespace fyd::session {
namespace {

template <class T>
constexpr ColumnType columnTypeOf() {
  if constexpr (std::is_same_v<T, std::uint8_t>) return ColumnType::u8;
  if constexpr (std::is_same_v<T, std::uint16_t>) return ColumnType::u16;
  if constexpr (std::is_same_v<T, std::uint32_t>) return ColumnType::u32;
  if constexpr (std::is_same_v<T, std::uint64_t>) return ColumnType::u64;
  if constexpr (std::is_same_v<T, std::int16_t>) return ColumnType::i16;
  if constexpr (std::is_same_v<T, std::int32_t>) return ColumnType::i32;
  if constexpr (std::is_same_v<T, std::int64_t>) return ColumnType::i64;
  if constexpr (std::is_same_v<T, double>) return ColumnType::f64;
}

template <class T>
struct Member {
  using Type = T;
  static constexpr std::size_t kCount = 1;
};
template <class T, std::size_t N>
struct Member<std::array<T, N>> {
  using Type = T;
  static constexpr std::size_t kCount = N;
};

template <class T>
Column columnOf(const char* name, const char* unit, std::size_t offset) {
  return {name, columnTypeOf<typename Member<T>::Type>(), unit, offset, Member<T>::kCount};
}

#define COLUMN(Row, member, unit) columnOf<decltype(Row::member)>(#member, unit, offsetof(Row, member))

constexpr std::size_t kTelemetryChunk = kBlockSteps;
constexpr std::size_t kSmallChunkBytes = 4'096;  // written again with each commit while it is the last: keep it small
constexpr std::size_t kPictureChunkBytes = 32'768;

template <class Row>
TableLayout compressedSteps(const char* path, std::vector<Column> columns) {
  return {path, sizeof(Row), kTelemetryChunk, true, std::move(columns)};
}

template <class Row>
TableLayout sometimes(const char* path, std::vector<Column> columns) {
  return {path, sizeof(Row), std::max<std::size_t>(1, kSmallChunkBytes / sizeof(Row)), false, std::move(columns)};
}

/// Values that may come with nearly every step: a block fills several chunks, and only its last is written twice.
template <class Row>
TableLayout often(const char* path, std::vector<Column> columns) {
  return {path, sizeof(Row), 64, true, std::move(columns)};
}

TableLayout telemetryLayout() {
  std::vector<Column> columns{COLUMN(TelemetryRow, now_ns, "ns")};
  std::vector<Column> known{COLUMN(TelemetryRow, t_s, "s"), COLUMN(TelemetryRow, step, "1")};
#define X(member) known.push_back(COLUMN(TelemetryRow, member, ""));
  FYD_TELEMETRY_DOUBLES(X)
  FYD_TELEMETRY_BYTES(X)
#undef X
  // In the order of telemetryFields(), so that a field's index finds its column.
  for (const pipeline::TelemetryField& field : pipeline::telemetryFields()) {
    const auto column = std::find_if(known.begin(), known.end(), [&](const Column& c) { return c.name == field.name; });
    if (column == known.end()) continue;  // a test compares the counts
    column->unit = field.unit;
    columns.push_back(*column);
  }
  return compressedSteps<TelemetryRow>("/telemetry", std::move(columns));
}

TableLayout overviewLayout(const char* path, std::size_t chunk_rows, bool compressed) {
  TableLayout layout{path, 0, chunk_rows, compressed, {}};
  for (const pipeline::TelemetryField& field : pipeline::telemetryFields())
    for (const char* end : {"_min", "_max"}) {
      layout.columns.push_back(
          {std::string(field.name) + end, ColumnType::f64, std::string(field.unit), layout.row_bytes, 1});
      layout.row_bytes += sizeof(double);
    }
  return layout;
}

std::vector<Column> stepColumns() {
  return {COLUMN(StepRow, now_ns, "ns"),
          COLUMN(StepRow, missed_cycles, "1"),
          COLUMN(StepRow, finger_row, "1"),
          COLUMN(StepRow, ir_row, "1"),
          COLUMN(StepRow, bridge_row, "1"),
          COLUMN(StepRow, motor_feedback_row, "1"),
          COLUMN(StepRow, robot_state_row, "1"),
          COLUMN(StepRow, motor_reference_row, "1"),
          COLUMN(StepRow, accelerations_row, "1"),
          COLUMN(StepRow, commands_row, "1"),
          COLUMN(StepRow, robot_commands_row, "1"),
          COLUMN(StepRow, changes_row, "1"),
          COLUMN(StepRow, events_row, "1"),
          COLUMN(StepRow, accelerations, "1"),
          COLUMN(StepRow, commands, "1"),
          COLUMN(StepRow, robot_commands, "1"),
          COLUMN(StepRow, changes, "1"),
          COLUMN(StepRow, events, "1"),
          COLUMN(StepRow, phase, "1")};
}

template <class Row>
std::vector<Column> fingerColumns(std::vector<Column> columns) {
  for (const Column& column :
       {COLUMN(Row, area_px, "px"), COLUMN(Row, x_px, "px"), COLUMN(Row, y_px, "px"), COLUMN(Row, x_mm, "mm"),
        COLUMN(Row, y_mm, "mm"), COLUMN(Row, quality, "1"), COLUMN(Row, contact, "1"), COLUMN(Row, reason, "1")})
    columns.push_back(column);
  return columns;
}

template <class Row>
std::vector<Column> timedColumns(std::initializer_list<Column> values) {
  std::vector<Column> columns{COLUMN(Row, count, "1"), COLUMN(Row, taken_ns, "ns")};
  columns.insert(columns.end(), values);
  return columns;
}

std::vector<Column> pictureColumns() {
  auto columns = fingerColumns<PictureRow>(
      {COLUMN(PictureRow, taken_ns, "ns"), COLUMN(PictureRow, number, "1"), COLUMN(PictureRow, bytes_start, "byte")});
  for (const Column& column : {COLUMN(PictureRow, whole_bytes, "byte"), COLUMN(PictureRow, region_bytes, "byte"),
                               COLUMN(PictureRow, region_x_px, "px"), COLUMN(PictureRow, region_y_px, "px"),
                               COLUMN(PictureRow, region_width_px, "px"), COLUMN(PictureRow, region_height_px, "px")})
    columns.push_back(column);
  return columns;
}

std::array<TableLayout, kTableCount> makeLayouts() {
  return {
      telemetryLayout(),
      compressedSteps<StepRow>("/inputs/steps", stepColumns()),
      compressedSteps<MotorRow>("/motors", {COLUMN(MotorRow, vibration_duty_percent, "%"),
                                            COLUMN(MotorRow, reference_ticks, "tick"), COLUMN(MotorRow, active, "1")}),
      sometimes<FingerRow>("/inputs/finger", fingerColumns<FingerRow>(timedColumns<FingerRow>({}))),
      sometimes<IrRow>("/inputs/ir",
                       timedColumns<IrRow>({COLUMN(IrRow, counts, "ADC code"), COLUMN(IrRow, sensors, "1")})),
      sometimes<BridgeRow>("/inputs/bridge", timedColumns<BridgeRow>({COLUMN(BridgeRow, value_mV_per_V, "mV/V")})),
      often<MotorFeedbackRow>(
          "/inputs/motor_feedback",
          timedColumns<MotorFeedbackRow>(
              {COLUMN(MotorFeedbackRow, current_mA, "mA"), COLUMN(MotorFeedbackRow, position_duty_percent, "%"),
               COLUMN(MotorFeedbackRow, encoder_counts, "count"), COLUMN(MotorFeedbackRow, position_duty_known, "1")})),
      often<RobotStateRow>(
          "/inputs/robot_state",
          timedColumns<RobotStateRow>({COLUMN(RobotStateRow, stiffness_N_per_mm, "N/mm"),
                                       COLUMN(RobotStateRow, x_mm, "mm"), COLUMN(RobotStateRow, y_mm, "mm"),
                                       COLUMN(RobotStateRow, z_mm, "mm"), COLUMN(RobotStateRow, button, "1")})),
      sometimes<MotorReferenceRow>("/inputs/motor_reference",
                                   timedColumns<MotorReferenceRow>({COLUMN(MotorReferenceRow, first_ticks, "tick"),
                                                                    COLUMN(MotorReferenceRow, second_ticks, "tick")})),
      often<AccelerationRow>("/inputs/accelerations",
                             {COLUMN(AccelerationRow, taken_ns, "ns"), COLUMN(AccelerationRow, x_g, "g"),
                              COLUMN(AccelerationRow, y_g, "g"), COLUMN(AccelerationRow, z_g, "g")}),
      sometimes<CommandRow>("/inputs/commands", {COLUMN(CommandRow, value, "1"), COLUMN(CommandRow, action, "1")}),
      sometimes<RobotCommandRow>("/inputs/robot_commands", {COLUMN(RobotCommandRow, command, "1")}),
      sometimes<ChangeRow>("/inputs/changes", {COLUMN(ChangeRow, value, "1"), COLUMN(ChangeRow, index, "1")}),
      sometimes<EventTableRow>("/events", {COLUMN(EventTableRow, when_ns, "ns"), COLUMN(EventTableRow, value, "1"),
                                           COLUMN(EventTableRow, kind, "1"), COLUMN(EventTableRow, state, "1"),
                                           COLUMN(EventTableRow, lack, "1"), COLUMN(EventTableRow, index, "1")}),
      sometimes<NoteRow>("/notes/index", {COLUMN(NoteRow, when_ns, "ns"), COLUMN(NoteRow, text_start, "byte"),
                                          COLUMN(NoteRow, text_bytes, "byte"), COLUMN(NoteRow, kind, "1")}),
      TableLayout{"/notes/text", 1, kSmallChunkBytes, false, {}},
      sometimes<LinkTableRow>("/link", {COLUMN(LinkTableRow, when_ns, "ns"), COLUMN(LinkTableRow, round_trip_ms, "ms"),
                                        COLUMN(LinkTableRow, jitter_ms, "ms"), COLUMN(LinkTableRow, loss_percent, "%"),
                                        COLUMN(LinkTableRow, states_received, "1"),
                                        COLUMN(LinkTableRow, touches_sent, "1"), COLUMN(LinkTableRow, refused, "1")}),
      sometimes<PictureRow>("/camera/index", pictureColumns()),
      TableLayout{"/camera/bytes", 1, kPictureChunkBytes, false, {}},
      overviewLayout("/overview/rows_25", kBlockSteps / 25, true),
      overviewLayout("/overview/rows_250", 8, false),
      overviewLayout("/overview/rows_1000", 8, false),
      overviewLayout("/overview/rows_4000", 8, false),
      overviewLayout("/overview/rows_64000", 8, false),
  };
}

}  // namespace

const TableLayout& layoutOf(Table table) {
  static const std::array<TableLayout, kTableCount> kLayouts = makeLayouts();
  return kLayouts[indexOf(table)];
}

const TableLayout& commitLayout() {
  static const TableLayout kLayout = sometimes<CommitRow>(
      "/commits", {COLUMN(CommitRow, number, "1"), COLUMN(CommitRow, utc_ns, "ns"), COLUMN(CommitRow, latest_ns, "ns"),
                   COLUMN(CommitRow, jumped, "1"), COLUMN(CommitRow, lost, "1"), COLUMN(CommitRow, rows, "1"),
                   COLUMN(CommitRow, crc, "1"), COLUMN(CommitRow, closed, "1"), COLUMN(CommitRow, own_crc, "1")});
  return kLayout;
}

}  // namespace fyd::session
