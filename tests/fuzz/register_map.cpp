// Registers and motor-board bytes of any content: refused, or well-formed and stable when written and read again.
#include <cmath>

#include "core/protocol/qbmove_codec.h"
#include "core/protocol/registers/drive_state.h"
#include "core/protocol/registers/register_codec.h"
#include "tests/fuzz/fuzz.h"

using namespace fyd;
using namespace fyd::protocol;

namespace {

template <std::size_t Size>
std::array<std::uint16_t, Size> take(fuzz::Input& input) {
  std::array<std::uint16_t, Size> out{};
  for (std::uint16_t& word : out) word = static_cast<std::uint16_t>((input.byte() << 8U) | input.byte());
  return out;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  const std::uint8_t what = input.byte() % 4;
  if (what == 0) {
    DeviceState state;
    if (decode(take<kStateRegisters>(input), state) != StateProblem::none) return 0;
    fuzz::require(driveStateOf(state.status_word).has_value());
    for (const double duty : state.motors.position_duty_percent) fuzz::require(std::abs(duty) <= 100.0);
    DeviceState again;
    fuzz::require(decode(encode(state), again) == StateProblem::none && encode(again) == encode(state));
  } else if (what == 1) {
    const std::size_t count = input.byte() % (kCommandRegisters + 2U);
    const auto registers = take<kCommandRegisters + 1U>(input);
    DeviceCommand command;
    if (!decode({registers.data(), count}, command)) return 0;
    CommandRegisters once{};
    const std::size_t written = encode(command, once);
    DeviceCommand again;
    fuzz::require(written <= count && decode({once.data(), written}, again));
    for (const DutyPair& pair : again.duties) fuzz::require(std::abs(pair[0]) <= 100 && std::abs(pair[1]) <= 100);
  } else if (what == 2) {
    const DeviceIdentity identity = decodeIdentity(take<kIdentityRegisters>(input));
    fuzz::require(identity.serialText().size() <= identity.serial.size());
    Drive drive;
    while (!input.empty()) {
      const std::uint8_t word = input.byte();
      const bool was_fault = drive.state() == DriveState::fault;
      if (word == 0xFE)
        drive.fail(DriveFault::heartbeat);
      else
        drive.control(word);
      fuzz::require(!was_fault || !drive.energised());
      fuzz::require((drive.state() == DriveState::fault) == (drive.fault() != DriveFault::none));
    }
  } else {
    QbmoveParser parser;
    while (!input.empty()) {
      const auto frame = parser.push(input.byte());
      if (!frame) continue;
      QbmoveParser fresh;
      std::optional<QbmoveFrame> back;
      for (const std::uint8_t byte : encode(*frame)) back = fresh.push(byte);
      fuzz::require(back && back->command == frame->command && back->payload.size() == frame->payload.size());
    }
  }
  return 0;
}
