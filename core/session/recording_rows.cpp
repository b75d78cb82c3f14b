#include "core/session/recording_rows.h"

namespace fyd::session {
namespace {

/// A number that this program does not know stays what it is: it is shown as unknown and does nothing.
template <class Enum>
Enum word(std::uint8_t value) {
  static_assert(std::is_same_v<std::underlying_type_t<Enum>, std::uint8_t>);
  return static_cast<Enum>(value);
}

template <class Row, class T>
Row timed(const Timed<T>& value) {
  Row row;
  row.count = value.count;
  row.taken_ns = nanoseconds(value.taken);
  return row;
}

template <class Row, class T>
void takeTime(const Row& row, Timed<T>& value) {
  value.count = row.count;
  value.taken = instantOf(row.taken_ns);
}

template <class Row>
void putFinger(const sensing::FingerDetection& finger, Row& row) {
  row.area_px = finger.area_px;
  row.x_px = finger.x_px;
  row.y_px = finger.y_px;
  row.x_mm = finger.x_mm;
  row.y_mm = finger.y_mm;
  row.quality = finger.quality;
  row.contact = finger.contact ? 1 : 0;
  row.reason = static_cast<std::uint8_t>(finger.reason);
}

template <class Row>
Result<void> takeFinger(const Row& row, sensing::FingerDetection& finger) {
  finger = {.contact = row.contact != 0,
            .area_px = row.area_px,
            .x_px = row.x_px,
            .y_px = row.y_px,
            .x_mm = row.x_mm,
            .y_mm = row.y_mm,
            .quality = row.quality,
            .reason = word<sensing::FingerReason>(row.reason)};
  return {};
}

}  // namespace

FingerRow rowOf(const Timed<sensing::FingerDetection>& value) {
  auto row = timed<FingerRow>(value);
  putFinger(value.value, row);
  return row;
}

IrRow rowOf(const Timed<sensing::IrCounts>& value) {
  auto row = timed<IrRow>(value);
  row.counts = value.value.items;
  row.sensors = std::min<std::uint32_t>(value.value.count, sensing::kMaximumIrSensors);
  return row;
}

BridgeRow rowOf(const Timed<sensing::BridgeReading>& value) {
  auto row = timed<BridgeRow>(value);
  row.value_mV_per_V = value.value.value_mV_per_V;
  return row;
}

MotorFeedbackRow rowOf(const Timed<control::MotorFeedback>& value) {
  auto row = timed<MotorFeedbackRow>(value);
  row.encoder_counts = value.value.encoder_counts;
  row.current_mA = value.value.current_mA;
  row.position_duty_percent = value.value.position_duty_percent;
  row.position_duty_known = value.value.position_duty_known ? 1 : 0;
  return row;
}

RobotStateRow rowOf(const Timed<pipeline::RobotState>& value) {
  auto row = timed<RobotStateRow>(value);
  row.stiffness_N_per_mm = value.value.stiffness_N_per_mm;
  row.x_mm = value.value.position_mm.x;
  row.y_mm = value.value.position_mm.y;
  row.z_mm = value.value.position_mm.z;
  row.button = value.value.button ? 1 : 0;
  return row;
}

MotorReferenceRow rowOf(const Timed<pipeline::RobotMotorReference>& value) {
  auto row = timed<MotorReferenceRow>(value);
  row.first_ticks = value.value.first_ticks;
  row.second_ticks = value.value.second_ticks;
  return row;
}

MotorRow rowOf(const control::MotorCommand& command) {
  MotorRow row;
  row.vibration_duty_percent = command.vibration_duty_percent;
  row.reference_ticks = command.reference_ticks;
  row.active = command.active ? 1 : 0;
  return row;
}

AccelerationRow rowOf(const pipeline::AccelerationSample& sample) {
  return {nanoseconds(sample.taken), sample.acceleration_g.x, sample.acceleration_g.y, sample.acceleration_g.z};
}

CommandRow rowOf(const pipeline::OperatorCommand& command) {
  CommandRow row;
  row.value = command.value;
  row.action = static_cast<std::uint8_t>(command.action);
  return row;
}

RobotCommandRow rowOf(pipeline::RobotCommand command) { return {static_cast<std::uint8_t>(command)}; }

ChangeRow rowOf(const pipeline::ParameterChange& change) {
  ChangeRow row;
  row.value = change.value;
  row.index = change.index;
  return row;
}

EventTableRow rowOf(const EventRow& event) {
  EventTableRow row;
  row.when_ns = nanoseconds(event.when);
  row.value = event.event.value;
  row.kind = static_cast<std::uint8_t>(event.event.kind);
  row.state = static_cast<std::uint8_t>(event.event.state);
  row.lack = static_cast<std::uint8_t>(event.event.lack);
  row.index = event.event.index;
  return row;
}

LinkTableRow rowOf(const LinkRow& link) {
  return {nanoseconds(link.when), link.round_trip_ms, link.jitter_ms, link.loss_percent,
          link.states_received,   link.touches_sent,  link.refused};
}

PictureRow rowOf(const EncodedPicture& picture, std::uint64_t bytes_start) {
  PictureRow row;
  row.taken_ns = nanoseconds(picture.taken);
  row.number = picture.number;
  row.bytes_start = bytes_start;
  row.whole_bytes = static_cast<std::uint32_t>(picture.whole.size());
  row.region_bytes = static_cast<std::uint32_t>(picture.region.size());
  row.region_x_px = picture.region_px.x;
  row.region_y_px = picture.region_px.y;
  row.region_width_px = picture.region_px.width;
  row.region_height_px = picture.region_px.height;
  putFinger(picture.finger, row);
  return row;
}

Result<void> valueOf(const FingerRow& row, Timed<sensing::FingerDetection>& value) {
  takeTime(row, value);
  return takeFinger(row, value.value);
}

Result<void> valueOf(const IrRow& row, Timed<sensing::IrCounts>& value) {
  if (row.sensors > sensing::kMaximumIrSensors) return fail("distance sensors: {} of them", row.sensors);
  takeTime(row, value);
  value.value.items = row.counts;
  value.value.count = row.sensors;
  return {};
}

Result<void> valueOf(const BridgeRow& row, Timed<sensing::BridgeReading>& value) {
  takeTime(row, value);
  value.value.value_mV_per_V = row.value_mV_per_V;
  return {};
}

Result<void> valueOf(const MotorFeedbackRow& row, Timed<control::MotorFeedback>& value) {
  takeTime(row, value);
  value.value.encoder_counts = row.encoder_counts;
  value.value.current_mA = row.current_mA;
  value.value.position_duty_percent = row.position_duty_percent;
  value.value.position_duty_known = row.position_duty_known != 0;
  return {};
}

Result<void> valueOf(const RobotStateRow& row, Timed<pipeline::RobotState>& value) {
  takeTime(row, value);
  value.value = {row.stiffness_N_per_mm, {row.x_mm, row.y_mm, row.z_mm}, row.button != 0};
  return {};
}

Result<void> valueOf(const MotorReferenceRow& row, Timed<pipeline::RobotMotorReference>& value) {
  takeTime(row, value);
  value.value = {row.first_ticks, row.second_ticks};
  return {};
}

Result<void> valueOf(const MotorRow& row, control::MotorCommand& command) {
  command = {row.reference_ticks, row.vibration_duty_percent, row.active != 0};
  return {};
}

Result<void> valueOf(const AccelerationRow& row, pipeline::AccelerationSample& sample) {
  sample = {instantOf(row.taken_ns), {row.x_g, row.y_g, row.z_g}};
  return {};
}

Result<void> valueOf(const CommandRow& row, pipeline::OperatorCommand& command) {
  command = {word<pipeline::OperatorAction>(row.action), row.value};
  return {};
}

Result<void> valueOf(const RobotCommandRow& row, pipeline::RobotCommand& command) {
  command = word<pipeline::RobotCommand>(row.command);
  return {};
}

Result<void> valueOf(const ChangeRow& row, pipeline::ParameterChange& change) {
  change = {row.index, row.value};
  return {};
}

Result<void> valueOf(const EventTableRow& row, EventRow& event) {
  event = {instantOf(row.when_ns),
           {word<pipeline::EventKind>(row.kind), word<pipeline::SafetyState>(row.state), word<pipeline::Lack>(row.lack),
            row.index, row.value}};
  return {};
}

Result<void> valueOf(const LinkTableRow& row, LinkRow& link) {
  link = {instantOf(row.when_ns), row.round_trip_ms, row.jitter_ms, row.loss_percent,
          row.states_received,    row.touches_sent,  row.refused};
  return {};
}

Result<void> valueOf(const PictureRow& row, sensing::FingerDetection& finger) { return takeFinger(row, finger); }

}  // namespace fyd::session
