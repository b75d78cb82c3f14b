#include "core/protocol/classic/classic_codec.h"

#include <algorithm>
#include <cmath>

#include "core/base/message.h"

namespace fyd::protocol {
namespace {

constexpr int kOverflow = 65'536;         // what a 16-bit number wraps at
constexpr int kLargestReadable = 65'535;  // no 16-bit sender can mean more
constexpr std::size_t kFieldDigits = 5;

// ---- writing ----

int rounded(double value) {
  if (std::isnan(value)) return 0;
  return static_cast<int>(std::lround(std::clamp<double>(value, -kClassicMaximumCount, kClassicMaximumCount)));
}

int truncated(double value) {
  return static_cast<int>(std::clamp<double>(value, -kClassicMaximumCount, kClassicMaximumCount));
}

class Writer {
 public:
  explicit Writer(std::uint8_t* to) : to_(to) {}

  void character(char c) { *to_++ = static_cast<std::uint8_t>(c); }
  void digits(int value, int count) {
    for (int i = count - 1; i >= 0; --i, value /= 10) to_[i] = static_cast<std::uint8_t>('0' + value % 10);
    to_ += count;
  }
  /// s'ddddd
  void field(int value) {
    character(value < 0 ? '1' : '0');
    character('\'');
    digits(std::abs(value), kFieldDigits);
  }
  void vector(const Vec3& position_mm) {
    const Vec3 p = position_mm.finite() ? position_mm : Vec3{};
    field(truncated(p.x));
    character(':');
    field(truncated(p.y));
    character(':');
    field(truncated(p.z));
    character(':');
  }
  void end() {
    character('.');
    character('\n');
  }

 private:
  std::uint8_t* to_;
};

// ---- reading ----

Bytes withoutPadding(Bytes packet) {
  while (!packet.empty() && packet.back() == 0) packet = packet.first(packet.size() - 1);
  return packet;
}

class Reader {
 public:
  explicit Reader(Bytes packet) : packet_(packet) {}

  [[nodiscard]] ClassicRefusal refusal() const { return refusal_; }
  [[nodiscard]] bool ok() const { return refusal_ == ClassicRefusal::none; }
  [[nodiscard]] bool ranOut() const { return ran_out_; }
  [[nodiscard]] bool sawLongField() const { return saw_long_field_; }

  void literal(char expected, ClassicRefusal why) {
    const int got = next();
    if (ok() && got != expected) refusal_ = why;
  }

  /// One of the characters from first to last, as its distance from first.
  int character(char first, char last, ClassicRefusal why) {
    const int got = next();
    if (!ok()) return 0;
    if (got < first || got > last) {
      refusal_ = why;
      return 0;
    }
    return got - first;
  }

  int digits(std::size_t count) {
    int value = 0;
    for (std::size_t i = 0; i < count; ++i) value = 10 * value + character('0', '9', ClassicRefusal::digit);
    return value;
  }

  /// s'ddddd, or s'-ddddd: a magnitude that overflowed 16 bits.
  int field() {
    const int sign = character('0', '1', ClassicRefusal::sign);
    literal('\'', ClassicRefusal::separator);
    int magnitude = 0;
    if (ok() && at_ < packet_.size() && packet_[at_] == '-') {
      ++at_;
      saw_long_field_ = true;
      magnitude = kOverflow - digits(kFieldDigits);
      if (ok() && (magnitude <= kClassicMaximumCount || magnitude == kOverflow)) refusal_ = ClassicRefusal::range;
    } else {
      magnitude = digits(kFieldDigits);
    }
    if (ok() && magnitude > kLargestReadable) refusal_ = ClassicRefusal::range;
    if (!ok()) return 0;
    return sign == 1 ? -magnitude : magnitude;
  }

  /// x:y:z: with the closing separator.
  Vec3 vector() {
    Vec3 v;
    for (double* component : {&v.x, &v.y, &v.z}) {
      *component = field();
      literal(':', ClassicRefusal::separator);
    }
    return v;
  }

  /// The closing marks, either of which a cut may have taken, and then nothing more.
  void end() {
    for (const char mark : {'.', '\n'}) {
      if (ok() && at_ < packet_.size()) literal(mark, ClassicRefusal::mark);
    }
    nothingMore();
  }
  void nothingMore() {
    if (ok() && at_ < packet_.size()) refusal_ = ClassicRefusal::size;
  }

 private:
  int next() {
    if (!ok()) return -1;
    if (at_ >= packet_.size()) {
      ran_out_ = true;
      refusal_ = ClassicRefusal::size;
      return -1;
    }
    return packet_[at_++];
  }

  Bytes packet_;
  std::size_t at_ = 0;
  ClassicRefusal refusal_ = ClassicRefusal::none;
  bool ran_out_ = false;
  bool saw_long_field_ = false;
};

template <class T>
Decoded<T> refused(ClassicRefusal why) {
  return {.value = {}, .refusal = why};
}

template <std::size_t Digits>
Decoded<std::size_t> decodeLength(Bytes packet, std::size_t maximum) {
  Reader reader(withoutPadding(packet));
  const int length = reader.digits(Digits);
  reader.nothingMore();
  if (!reader.ok()) return refused<std::size_t>(reader.refusal());
  if (static_cast<std::size_t>(length) > maximum) return refused<std::size_t>(ClassicRefusal::range);
  return {.value = static_cast<std::size_t>(length)};
}

}  // namespace

std::string_view toString(ClassicRefusal refusal) {
  switch (refusal) {
    case ClassicRefusal::none: return sentence("taken");
    case ClassicRefusal::size: return sentence("wrong size");
    case ClassicRefusal::mark: return sentence("wrong start or end mark");
    case ClassicRefusal::sign: return sentence("wrong sign");
    case ClassicRefusal::digit: return sentence("not a digit");
    case ClassicRefusal::separator: return sentence("wrong separator");
    case ClassicRefusal::command: return sentence("unknown command");
    case ClassicRefusal::button: return sentence("wrong button");
    case ClassicRefusal::range: return sentence("number out of range");
  }
  return sentence("unknown");
}

std::array<std::uint8_t, kClassicStateSize> encodeState(const ClassicState& state) {
  std::array<std::uint8_t, kClassicStateSize> out{};
  Writer writer(out.data());
  writer.character('?');
  writer.character(static_cast<char>('0' + static_cast<int>(state.command)));
  writer.character(',');
  for (const double g : {state.acceleration_g.x, state.acceleration_g.y, state.acceleration_g.z}) {
    writer.field(rounded(g * kClassicCountsPerG));
    writer.character(':');
  }
  writer.character(state.robot.button ? '1' : '0');
  writer.character(',');
  writer.vector(state.robot.position_mm);
  writer.field(std::max(0, rounded(state.robot.stiffness_N_per_mm * kClassicCountsPerStiffness)));
  writer.end();
  return out;
}

Decoded<ClassicState> decodeState(Bytes packet) {
  const Bytes content = withoutPadding(packet);
  Reader reader(content);
  ClassicState state;
  reader.literal('?', ClassicRefusal::mark);
  state.command = static_cast<pipeline::RobotCommand>(reader.character('0', ';', ClassicRefusal::command));
  reader.literal(',', ClassicRefusal::separator);
  state.acceleration_g = (1.0 / kClassicCountsPerG) * reader.vector();
  state.robot.button = reader.character('0', '1', ClassicRefusal::button) == 1;
  reader.literal(',', ClassicRefusal::separator);
  state.robot.position_mm = reader.vector();
  if (!reader.ok()) return refused<ClassicState>(reader.refusal());
  const int stiffness = reader.field();
  reader.end();
  if (reader.ranOut() && reader.sawLongField() && content.size() == kClassicStateSize) {
    state.stiffness_known = false;
    return {.value = state};
  }
  if (!reader.ok()) return refused<ClassicState>(reader.refusal());
  state.robot.stiffness_N_per_mm = std::max(0, stiffness) / kClassicCountsPerStiffness;
  return {.value = state};
}

bool looksLikeState(Bytes packet) {
  if (packet.size() != kClassicStateSize) return false;
  return packet[0] == '?' || (packet[kClassicStateSize - 2] == '.' && packet[kClassicStateSize - 1] == '\n');
}

std::array<std::uint8_t, kClassicTouchSize> encodeTouch(const pipeline::TouchMessage& touch) {
  std::array<std::uint8_t, kClassicTouchSize> out{};
  Writer writer(out.data());
  Vec3 position_mm = touch.position_mm;
  if (!touch.in_contact && position_mm.finite()) position_mm.x = position_mm.y = 0.0;
  writer.character('?');
  writer.vector(position_mm);
  writer.field(std::max(0, rounded(touch.force_N * kClassicCountsPerNewton)));
  writer.end();
  return out;
}

Decoded<pipeline::TouchMessage> decodeTouch(Bytes packet) {
  Reader reader(withoutPadding(packet));
  pipeline::TouchMessage touch;
  reader.literal('?', ClassicRefusal::mark);
  touch.position_mm = reader.vector();
  const int force = reader.field();
  reader.end();
  if (!reader.ok()) return refused<pipeline::TouchMessage>(reader.refusal());
  touch.in_contact = touch.position_mm.x != 0.0 || touch.position_mm.y != 0.0;
  touch.force_N = std::max(0, force) / kClassicCountsPerNewton;
  return {.value = touch};
}

std::array<std::uint8_t, kClassicAckSize> encodeAck() {
  std::array<std::uint8_t, kClassicAckSize> out{};
  out[0] = 'A';
  out[1] = 'C';
  out[2] = 'K';
  return out;
}

bool isAck(Bytes packet) {
  if (packet.size() > kClassicAckSize) return false;
  const Bytes content = withoutPadding(packet);
  return content.size() == 3 && content[0] == 'A' && content[1] == 'C' && content[2] == 'K';
}

std::array<std::uint8_t, kClassicInfoLengthSize> encodeInfoLength(std::size_t length) {
  std::array<std::uint8_t, kClassicInfoLengthSize> out{};
  Writer(out.data()).digits(static_cast<int>(std::min(length, kClassicMaximumBoardText)), kClassicInfoLengthSize);
  return out;
}

Decoded<std::size_t> decodeInfoLength(Bytes packet) {
  return decodeLength<kClassicInfoLengthSize>(packet, kClassicMaximumBoardText);
}

std::array<std::uint8_t, kClassicInfoValuesSize> encodeInfoValues(const TouchpadInfo& info) {
  std::array<std::uint8_t, kClassicInfoValuesSize> out{};
  Writer writer(out.data());
  writer.character('^');
  writer.digits(std::clamp(rounded(10.0 * info.k_vib), 0, 999), 3);
  for (const double ticks : info.reference_ticks) {
    writer.character('^');
    writer.field(rounded(ticks));
  }
  return out;
}

Decoded<TouchpadInfo> decodeInfoValues(Bytes packet) {
  Reader reader(withoutPadding(packet));
  TouchpadInfo info;
  reader.literal('^', ClassicRefusal::mark);
  info.k_vib = reader.digits(3) / 10.0;
  for (double& ticks : info.reference_ticks) {
    reader.literal('^', ClassicRefusal::separator);
    ticks = reader.field();
  }
  reader.nothingMore();
  if (!reader.ok()) return refused<TouchpadInfo>(reader.refusal());
  return {.value = info};
}

std::array<std::uint8_t, kClassicMotorReferenceSize> encodeMotorReference(
    const pipeline::RobotMotorReference& reference) {
  std::array<std::uint8_t, kClassicMotorReferenceSize> out{};
  Writer writer(out.data());
  writer.field(rounded(reference.first_ticks));
  writer.character(':');
  writer.field(rounded(reference.second_ticks));
  writer.end();
  return out;
}

Decoded<pipeline::RobotMotorReference> decodeMotorReference(Bytes packet) {
  Reader reader(withoutPadding(packet));
  pipeline::RobotMotorReference reference;
  reference.first_ticks = reader.field();
  reader.literal(':', ClassicRefusal::separator);
  reference.second_ticks = reader.field();
  reader.end();
  if (!reader.ok()) return refused<pipeline::RobotMotorReference>(reader.refusal());
  return {.value = reference};
}

std::array<std::uint8_t, kClassicImageLengthSize> encodeImageLength(std::size_t length) {
  std::array<std::uint8_t, kClassicImageLengthSize> out{};
  Writer(out.data()).digits(static_cast<int>(std::min(length, kClassicMaximumImage)), kClassicImageLengthSize);
  return out;
}

Decoded<std::size_t> decodeImageLength(Bytes packet) {
  return decodeLength<kClassicImageLengthSize>(packet, kClassicMaximumImage);
}

}  // namespace fyd::protocol
