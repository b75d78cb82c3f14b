#include "core/protocol/fri_codec.h"

#include <cmath>

#include "core/base/message.h"
#include "core/protocol/byte_io.h"

namespace fyd::protocol {
namespace {

// One list of fields for each message, used by a writer and by a reader, so that the two cannot disagree.

class Put {
 public:
  explicit Put(std::span<std::uint8_t> out) : to_(out) {}
  void operator()(std::uint16_t value) { to_.u16(value); }
  void operator()(std::uint32_t value) { to_.u32(value); }
  void operator()(std::int32_t value) { to_.u32(static_cast<std::uint32_t>(value)); }
  void operator()(float value) { to_.f32(value); }
  template <class Enum>
  void choice(const Enum& value, Enum /*last*/) {
    to_.u16(static_cast<std::uint16_t>(value));
  }
  void padding() { to_.u16(0); }
  template <class T, std::size_t N>
  void operator()(const std::array<T, N>& values) {
    for (const T value : values) (*this)(value);
  }

 private:
  ByteWriter to_;
};

class Take {
 public:
  explicit Take(Bytes in) : from_(in) {}
  void operator()(std::uint16_t& value) { value = from_.u16(); }
  void operator()(std::uint32_t& value) { value = from_.u32(); }
  void operator()(std::int32_t& value) { value = static_cast<std::int32_t>(from_.u32()); }
  void operator()(float& value) {
    value = from_.f32();
    finite_ = finite_ && std::isfinite(value);
  }
  template <class Enum>
  void choice(Enum& value, Enum last) {
    const std::uint16_t read = from_.u16();
    known_ = known_ && read <= static_cast<std::uint16_t>(last);
    value = static_cast<Enum>(read);
  }
  void padding() { static_cast<void>(from_.u16()); }
  template <class T, std::size_t N>
  void operator()(std::array<T, N>& values) {
    for (T& value : values) (*this)(value);
  }
  [[nodiscard]] FriRefusal verdict() const {
    if (!from_.complete()) return FriRefusal::wrong_size;
    if (!known_) return FriRefusal::unknown_value;
    return finite_ ? FriRefusal::none : FriRefusal::not_finite;
  }

 private:
  ByteReader from_;
  bool finite_ = true;
  bool known_ = true;
};

template <class Walk, class Krl>
void walkKrl(Walk& walk, Krl& krl) {
  walk(krl.reals);
  walk(krl.integers);
  walk(krl.booleans);
  walk.padding();
}

template <class Walk, class Measurement>
void walkMeasurement(Walk& walk, Measurement& m) {
  walkKrl(walk, m.krl);
  walk(m.time_s);
  walk.choice(m.state, FriState::command);
  walk.choice(m.quality, FriQuality::perfect);
  walk(m.measurement_period_s);
  walk(m.command_period_s);
  walk(m.safety_limits);
  walk(m.answer_rate);
  walk(m.latency_s);
  walk(m.jitter_s);
  walk(m.miss_rate);
  walk(m.misses);
  walk(m.power);
  walk.choice(m.control, FriControl::joint_impedance);
  walk(m.error);
  walk(m.warning);
  walk(m.temperatures_C);
  walk(m.joints);
  walk(m.frame);
  walk(m.commanded_joints);
  walk(m.joint_offsets);
  walk(m.commanded_frame);
  walk(m.frame_offset);
  walk(m.torques);
  walk(m.external_torques);
  walk(m.force_torque);
  walk(m.jacobian);
  walk(m.mass);
  walk(m.gravity);
}

template <class Walk, class Command>
void walkCommand(Walk& walk, Command& c) {
  walkKrl(walk, c.krl);
  walk(c.flags);
  walk(c.joints);
  walk(c.frame);
  walk(c.torques);
  walk(c.force_torque);
  walk(c.joint_stiffness);
  walk(c.joint_damping);
  walk(c.cartesian_stiffness);
  walk(c.cartesian_damping);
}

void putHeader(Put& put, const FriHeader& header, std::size_t size, std::uint16_t id) {
  put(header.sequence);
  put(header.reflected);
  put(static_cast<std::uint16_t>(size));
  put(id);
}

FriRefusal takeHeader(Take& take, FriHeader& header, std::size_t size, std::uint16_t id) {
  std::uint16_t size_read = 0;
  std::uint16_t id_read = 0;
  take(header.sequence);
  take(header.reflected);
  take(size_read);
  take(id_read);
  if (id_read != id) return FriRefusal::wrong_id;
  return size_read == size ? FriRefusal::none : FriRefusal::wrong_size_field;
}

}  // namespace

std::array<std::uint8_t, kFriMeasurementSize> encodeFriMeasurement(const FriMeasurement& measurement) {
  std::array<std::uint8_t, kFriMeasurementSize> out{};
  Put put(out);
  putHeader(put, measurement.header, kFriMeasurementSize, kFriMeasurementId);
  walkMeasurement(put, measurement);
  return out;
}

std::array<std::uint8_t, kFriCommandSize> encodeFriCommand(const FriCommand& command) {
  std::array<std::uint8_t, kFriCommandSize> out{};
  Put put(out);
  putHeader(put, command.header, kFriCommandSize, kFriCommandId);
  walkCommand(put, command);
  return out;
}

FriRefusal decodeFriMeasurement(Bytes datagram, FriMeasurement& out) {
  if (datagram.size() != kFriMeasurementSize) return FriRefusal::wrong_size;
  Take take(datagram);
  const FriRefusal refusal = takeHeader(take, out.header, kFriMeasurementSize, kFriMeasurementId);
  if (refusal != FriRefusal::none) return refusal;
  walkMeasurement(take, out);
  return take.verdict();
}

FriRefusal decodeFriCommand(Bytes datagram, FriCommand& out) {
  if (datagram.size() != kFriCommandSize) return FriRefusal::wrong_size;
  Take take(datagram);
  const FriRefusal refusal = takeHeader(take, out.header, kFriCommandSize, kFriCommandId);
  if (refusal != FriRefusal::none) return refusal;
  walkCommand(take, out);
  return take.verdict();
}

std::string_view toString(FriState state) {
  switch (state) {
    case FriState::off: return sentence("off");
    case FriState::monitor: return sentence("monitor");
    case FriState::command: return sentence("command");
  }
  return sentence("unknown");
}

std::string_view toString(FriQuality quality) {
  switch (quality) {
    case FriQuality::unacceptable: return sentence("unacceptable");
    case FriQuality::bad: return sentence("bad");
    case FriQuality::good: return sentence("good");
    case FriQuality::perfect: return sentence("perfect");
  }
  return sentence("unknown");
}

std::string_view toString(FriControl control) {
  switch (control) {
    case FriControl::other: return sentence("other");
    case FriControl::position: return sentence("position");
    case FriControl::cartesian_impedance: return sentence("Cartesian impedance");
    case FriControl::joint_impedance: return sentence("joint impedance");
  }
  return sentence("unknown");
}

std::string_view toString(FriRefusal refusal) {
  switch (refusal) {
    case FriRefusal::none: return sentence("none");
    case FriRefusal::wrong_size: return sentence("wrong size");
    case FriRefusal::wrong_size_field: return sentence("wrong size field");
    case FriRefusal::wrong_id: return sentence("wrong id");
    case FriRefusal::unknown_value: return sentence("unknown state, quality or strategy");
    case FriRefusal::not_finite: return sentence("number not finite");
  }
  return sentence("unknown");
}

}  // namespace fyd::protocol
