#include "core/session/packed_step.h"

#include <cstring>
#include <type_traits>

namespace fyd::session {
namespace {

struct Head {
  std::uint32_t bytes = 0;  // of the whole packed step
  std::uint32_t accelerations = 0;
  std::uint32_t robot_commands = 0;
  std::uint32_t commands = 0;
  std::uint32_t changes = 0;
  std::uint32_t events = 0;
  pipeline::LinkPhase phase = pipeline::LinkPhase::none;
  Instant now{};
  std::uint64_t missed_cycles = 0;
  Timed<sensing::FingerDetection> finger;
  Timed<sensing::IrCounts> ir;
  Timed<sensing::BridgeReading> bridge;
  Timed<control::MotorFeedback> motors;
  Timed<pipeline::RobotState> robot;
  Timed<pipeline::RobotMotorReference> motor_reference;
  control::MotorCommand command;
  pipeline::TelemetrySample telemetry;
};
static_assert(std::is_trivially_copyable_v<Head>);
static_assert(sizeof(Head) <= kLargestPackedStep);

template <class T, std::size_t Capacity>
std::byte* put(std::byte* to, const Batch<T, Capacity>& from) {
  static_assert(std::is_trivially_copyable_v<T>);
  std::memcpy(to, from.items.data(), from.size() * sizeof(T));
  return to + from.size() * sizeof(T);
}

template <class T, std::size_t Capacity>
const std::byte* get(const std::byte* from, std::uint32_t count, Batch<T, Capacity>& to) {
  to.count = count;
  std::memcpy(to.items.data(), from, count * sizeof(T));
  return from + count * sizeof(T);
}

}  // namespace

std::size_t packStep(const StepView& step, std::span<std::byte> out) noexcept {
  const pipeline::Inputs& in = step.inputs;
  std::byte* to = out.data() + sizeof(Head);
  to = put(to, in.robot.accelerations);
  to = put(to, in.robot.commands);
  to = put(to, in.commands);
  to = put(to, in.changes);
  to = put(to, step.outputs.events);
  const auto bytes = static_cast<std::size_t>(to - out.data());
  const Head head{.bytes = static_cast<std::uint32_t>(bytes),
                  .accelerations = in.robot.accelerations.count,
                  .robot_commands = in.robot.commands.count,
                  .commands = in.commands.count,
                  .changes = in.changes.count,
                  .events = step.outputs.events.count,
                  .phase = in.robot.phase,
                  .now = in.now,
                  .missed_cycles = in.missed_cycles,
                  .finger = in.finger,
                  .ir = in.ir,
                  .bridge = in.bridge,
                  .motors = in.motors,
                  .robot = in.robot.state,
                  .motor_reference = in.robot.motor_reference,
                  .command = step.outputs.motors,
                  .telemetry = step.outputs.telemetry};
  std::memcpy(out.data(), &head, sizeof(Head));
  return bytes;
}

std::size_t packedHeadSize() noexcept { return sizeof(Head); }

std::size_t packedSize(std::span<const std::byte> packed) noexcept {
  if (packed.size() < sizeof(Head)) return 0;
  std::uint32_t bytes = 0;
  std::memcpy(&bytes, packed.data() + offsetof(Head, bytes), sizeof(bytes));
  return bytes;
}

void unpackStep(std::span<const std::byte> packed, StepRecord& out) noexcept {
  Head head;
  std::memcpy(&head, packed.data(), sizeof(Head));
  pipeline::Inputs& in = out.inputs;
  in.now = head.now;
  in.missed_cycles = head.missed_cycles;
  in.finger = head.finger;
  in.ir = head.ir;
  in.bridge = head.bridge;
  in.motors = head.motors;
  in.robot.phase = head.phase;
  in.robot.state = head.robot;
  in.robot.motor_reference = head.motor_reference;
  out.motors = head.command;
  out.telemetry = head.telemetry;
  const std::byte* from = packed.data() + sizeof(Head);
  from = get(from, head.accelerations, in.robot.accelerations);
  from = get(from, head.robot_commands, in.robot.commands);
  from = get(from, head.commands, in.commands);
  from = get(from, head.changes, in.changes);
  get(from, head.events, out.events);
}

}  // namespace fyd::session
