#include "core/protocol/link/link_codec.h"

#include "core/protocol/link/link_fields.h"

namespace fyd::protocol {
namespace {

using fields::count;
using fields::finished;
using fields::held;
using fields::within;

constexpr std::uint8_t kTypeBits = 5;
constexpr std::uint8_t kTypeMask = (1U << kTypeBits) - 1;

// Flags of a touch.
constexpr std::uint8_t kForce = 1;
constexpr std::uint8_t kIndentation = 2;
constexpr std::uint8_t kOrientation = 4;
// Flags of a state; kOrientation as well.
constexpr std::uint8_t kMotorReference = 1;

constexpr double kMost16 = 65'535.0;
constexpr double kTouchAge_s = 10e-6;
constexpr double kSampleAge_s = 4e-6;
constexpr double kTouchForce_N = 0.2e-3;
constexpr double kRobotForce_N = 1e-3;
constexpr double kIndentation_mm = 1e-3;
constexpr double kCountsPerG = 6553.0;
constexpr double kMostCounts = 32'767.0;
constexpr std::size_t kSampleSize = 8;

void envelope(ByteWriter& out, LinkMessage type, std::uint8_t flags, LinkTime sent_us) {
  out.u8(static_cast<std::uint8_t>(static_cast<std::uint8_t>(type) | (flags << kTypeBits)));
  out.u48(sent_us);
}

/// A coded position and one flag below it, in as few bytes as hold them.
std::size_t positionSize(unsigned bits_per_axis) { return (3 * bits_per_axis + 1 + 7) / 8; }

void writePosition(ByteWriter& out, const PositionCode& code, const Vec3& position_mm, bool flag) {
  const std::uint64_t packed = (code.encode(position_mm) << 1) | (flag ? 1U : 0U);
  const std::size_t size = positionSize(code.bitsPerAxis());
  for (std::size_t i = 0; i < size; ++i) out.u8(static_cast<std::uint8_t>(packed >> (8 * i)));
}

bool readPosition(ByteReader& in, const PositionCode& code, Vec3& position_mm, bool& flag) {
  const Bytes bytes = in.bytes(positionSize(code.bitsPerAxis()));
  std::uint64_t packed = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) packed |= std::uint64_t{bytes[i]} << (8 * i);
  flag = (packed & 1U) != 0;
  const auto position = code.decode(packed >> 1);
  if (position) position_mm = *position;
  return position.has_value();
}

std::int16_t acceleration(double g) {
  if (std::isnan(g)) return 0;
  return static_cast<std::int16_t>(std::clamp(std::round(g * kCountsPerG), -kMostCounts, kMostCounts));
}

template <class T>
LinkDecoded<T> refused(LinkRefusal refusal) {
  return {.refusal = refusal};
}

}  // namespace

std::size_t touchMessageSize(unsigned bits_per_axis, const TouchFields& fields) {
  return kLinkEnvelope + 2 + 2 + positionSize(bits_per_axis) + (fields.force ? 2 : 0) + (fields.indentation ? 2 : 0) +
         (fields.orientation ? 6 : 0);
}

std::size_t encodeLink(const LinkTouch& touch, const PositionCode& code, LinkTime sent_us,
                       std::span<std::uint8_t> out) {
  ByteWriter writer(out);
  const auto flags =
      static_cast<std::uint8_t>((touch.force_N ? kForce : 0) | (touch.indentation_mm ? kIndentation : 0) |
                                (touch.orientation ? kOrientation : 0));
  envelope(writer, LinkMessage::touch, flags, sent_us);
  writer.u16(touch.sequence);
  writer.u16(static_cast<std::uint16_t>(count(touch.age_s, kTouchAge_s, kMost16)));
  const bool known = touch.position_mm.finite();
  writePosition(writer, code, known ? touch.position_mm : Vec3{}, touch.in_contact && known);
  if (touch.force_N) writer.u16(static_cast<std::uint16_t>(count(*touch.force_N, kTouchForce_N, kMost16)));
  if (touch.indentation_mm) {
    writer.u16(static_cast<std::uint16_t>(count(*touch.indentation_mm, kIndentation_mm, kMost16)));
  }
  if (touch.orientation) fields::writeOrientation(writer, *touch.orientation);
  return writer.size();
}

LinkDecoded<LinkTouch> decodeTouch(const LinkEnvelope& message, const PositionCode& code) {
  ByteReader in(message.body);
  LinkTouch touch;
  touch.sequence = in.u16();
  touch.age_s = kTouchAge_s * in.u16();
  const bool good = readPosition(in, code, touch.position_mm, touch.in_contact);
  if ((message.flags & kForce) != 0) touch.force_N = kTouchForce_N * in.u16();
  if ((message.flags & kIndentation) != 0) touch.indentation_mm = kIndentation_mm * in.u16();
  if ((message.flags & kOrientation) != 0) touch.orientation = fields::readOrientation(in);
  return finished(in, touch, good);
}

std::size_t encodeLink(const LinkState& state, const PositionCode& code, LinkTime sent_us,
                       std::span<std::uint8_t> out) {
  ByteWriter writer(out);
  const auto flags =
      static_cast<std::uint8_t>((state.motor_reference ? kMotorReference : 0) | (state.orientation ? kOrientation : 0));
  envelope(writer, LinkMessage::state, flags, sent_us);
  writer.u16(state.sequence);
  writer.f32(held(state.robot.stiffness_N_per_mm, 0.0, fields::kMaximumStiffness));
  writer.u16(static_cast<std::uint16_t>(count(state.robot.force_N, kRobotForce_N, kMost16)));
  writePosition(writer, code, state.robot.position_mm, state.robot.button);
  if (state.orientation) fields::writeOrientation(writer, *state.orientation);
  if (state.motor_reference) {
    writer.f32(held(state.motor_reference->first_ticks, -fields::kMaximumTicks, fields::kMaximumTicks));
    writer.f32(held(state.motor_reference->second_ticks, -fields::kMaximumTicks, fields::kMaximumTicks));
  }
  writer.u8(static_cast<std::uint8_t>(state.accelerations.size()));
  for (const LinkAcceleration& sample : state.accelerations) {
    writer.u16(static_cast<std::uint16_t>(count(sample.age_s, kSampleAge_s, kMost16)));
    for (const double g : {sample.acceleration_g.x, sample.acceleration_g.y, sample.acceleration_g.z}) {
      writer.u16(static_cast<std::uint16_t>(acceleration(g)));
    }
  }
  return writer.size();
}

LinkDecoded<LinkState> decodeState(const LinkEnvelope& message, const PositionCode& code) {
  ByteReader in(message.body);
  LinkState state;
  if ((message.flags & ~(kMotorReference | kOrientation)) != 0) return refused<LinkState>(LinkRefusal::field);
  state.sequence = in.u16();
  state.robot.stiffness_N_per_mm = in.f32();
  bool good = within(state.robot.stiffness_N_per_mm, 0.0, fields::kMaximumStiffness);
  state.robot.force_N = kRobotForce_N * in.u16();
  good = readPosition(in, code, state.robot.position_mm, state.robot.button) && good;
  if ((message.flags & kOrientation) != 0) state.orientation = fields::readOrientation(in);
  if ((message.flags & kMotorReference) != 0) {
    const double first = in.f32();
    const double second = in.f32();
    state.motor_reference = {.first_ticks = first, .second_ticks = second};
    good = within(first, -fields::kMaximumTicks, fields::kMaximumTicks) &&
           within(second, -fields::kMaximumTicks, fields::kMaximumTicks) && good;
  }
  const std::size_t samples = in.u8();
  if (in.left() != samples * kSampleSize) return refused<LinkState>(LinkRefusal::size);
  if (samples > kMaximumBatch) return refused<LinkState>(LinkRefusal::field);
  for (std::size_t i = 0; i < samples; ++i) {
    const double age_s = kSampleAge_s * in.u16();
    std::array<std::int16_t, 3> counts{};
    for (auto& c : counts) c = static_cast<std::int16_t>(in.u16());
    good = std::ranges::none_of(counts, [](std::int16_t c) { return c < -kMostCounts; }) && good;
    good = state.accelerations.push(
               {.age_s = age_s,
                .acceleration_g = {counts[0] / kCountsPerG, counts[1] / kCountsPerG, counts[2] / kCountsPerG}}) &&
           good;
  }
  return finished(in, state, good);
}

std::size_t encodeLink(const LinkCommand& command, LinkTime sent_us, std::span<std::uint8_t> out) {
  ByteWriter writer(out);
  envelope(writer, LinkMessage::command, 0, sent_us);
  writer.u16(command.id);
  writer.u8(static_cast<std::uint8_t>(command.command));
  return writer.size();
}

LinkDecoded<LinkCommand> decodeCommand(const LinkEnvelope& message) {
  ByteReader in(message.body);
  LinkCommand command;
  command.id = in.u16();
  const std::uint8_t value = in.u8();
  command.command = static_cast<pipeline::RobotCommand>(value);
  const bool known = value >= 1 && value <= static_cast<std::uint8_t>(pipeline::RobotCommand::motor_reference_off);
  return finished(in, command, known && message.flags == 0);
}

std::size_t encodeLink(const LinkCommandAck& ack, LinkTime sent_us, std::span<std::uint8_t> out) {
  ByteWriter writer(out);
  envelope(writer, LinkMessage::command_ack, 0, sent_us);
  writer.u16(ack.id);
  return writer.size();
}

LinkDecoded<LinkCommandAck> decodeCommandAck(const LinkEnvelope& message) {
  ByteReader in(message.body);
  const LinkCommandAck ack{.id = in.u16()};
  return finished(in, ack, message.flags == 0);
}

std::size_t encodeLink(const LinkHeartbeat& beat, LinkTime sent_us, std::span<std::uint8_t> out) {
  ByteWriter writer(out);
  envelope(writer, LinkMessage::heartbeat, 0, sent_us);
  writer.u48(beat.echo_us);
  writer.u32(beat.held_us);
  return writer.size();
}

LinkDecoded<LinkHeartbeat> decodeHeartbeat(const LinkEnvelope& message) {
  ByteReader in(message.body);
  LinkHeartbeat beat;
  beat.echo_us = in.u48();
  beat.held_us = in.u32();
  return finished(in, beat, message.flags == 0);
}

std::size_t encodeLink(const LinkInfo& info, LinkTime sent_us, std::span<std::uint8_t> out) {
  ByteWriter writer(out);
  envelope(writer, LinkMessage::info, 0, sent_us);
  fields::writeBoard(writer, info.k_vib, info.reference_ticks, info.board_text);
  return writer.size();
}

LinkDecoded<LinkInfo> decodeInfo(const LinkEnvelope& message) {
  ByteReader in(message.body);
  LinkInfo info;
  const bool good = fields::readBoard(in, info.k_vib, info.reference_ticks, info.board_text);
  return finished(in, info, good && message.flags == 0);
}

std::size_t encodeLink(const LinkGoodbye& goodbye, LinkTime sent_us, std::span<std::uint8_t> out) {
  ByteWriter writer(out);
  envelope(writer, LinkMessage::goodbye, 0, sent_us);
  writer.u8(static_cast<std::uint8_t>(goodbye.reason));
  return writer.size();
}

LinkDecoded<LinkGoodbye> decodeGoodbye(const LinkEnvelope& message) {
  ByteReader in(message.body);
  const std::uint8_t reason = in.u8();
  return finished(in, LinkGoodbye{.reason = static_cast<GoodbyeReason>(reason)},
                  reason <= static_cast<std::uint8_t>(GoodbyeReason::operator_left) && message.flags == 0);
}

std::size_t encodeLink(const LinkImageFragment& fragment, LinkTime sent_us, std::span<std::uint8_t> out) {
  ByteWriter writer(out);
  envelope(writer, LinkMessage::image, 0, sent_us);
  writer.u16(fragment.picture);
  writer.u32(fragment.size);
  writer.u16(fragment.index);
  writer.bytes(fragment.bytes);
  return writer.size();
}

LinkDecoded<LinkImageFragment> decodeImageFragment(const LinkEnvelope& message) {
  ByteReader in(message.body);
  LinkImageFragment fragment;
  fragment.picture = in.u16();
  fragment.size = in.u32();
  fragment.index = in.u16();
  fragment.bytes = in.bytes(in.left());
  if (!in.complete()) return refused<LinkImageFragment>(LinkRefusal::size);
  const std::size_t offset = fragment.index * kImageFragment;
  if (fragment.size > kMaximumLinkImage || offset >= fragment.size || message.flags != 0) {
    return refused<LinkImageFragment>(LinkRefusal::field);
  }
  const std::size_t expected = std::min(kImageFragment, fragment.size - offset);
  if (fragment.bytes.size() != expected) return refused<LinkImageFragment>(LinkRefusal::size);
  return {.value = fragment};
}

LinkDecoded<LinkEnvelope> decodeEnvelope(Bytes message) {
  ByteReader in(message);
  const std::uint8_t first = in.u8();
  LinkEnvelope out;
  out.type = static_cast<LinkMessage>(first & kTypeMask);
  out.flags = static_cast<std::uint8_t>(first >> kTypeBits);
  out.sent_us = in.u48();
  if (!in.ok() || message.size() > kMaximumLinkMessage) return refused<LinkEnvelope>(LinkRefusal::size);
  if (out.type < LinkMessage::touch || out.type > LinkMessage::image) {
    return refused<LinkEnvelope>(LinkRefusal::message);
  }
  out.body = in.bytes(in.left());
  return {.value = out};
}

}  // namespace fyd::protocol
