// Ticks, commands and datagrams in any order: the robot's end never sends but what the protocol allows.
#include "core/protocol/classic/classic_robot_end.h"

#include "tests/fuzz/fuzz.h"

using namespace fyd;
using namespace fyd::protocol;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  Endpoint touchpad;
  touchpad.port = kClassicPort;
  ClassicRobotEnd end({}, touchpad);
  Instant now = instantAt(1.0);
  while (!input.empty()) {
    const std::uint8_t what = input.byte();
    if (what < 96) {
      now += std::chrono::milliseconds(what);
      for (const Datagram& datagram : end.tick(now, {})) {
        fuzz::require(isAck(datagram.bytes) || decodeState(datagram.bytes).ok() ||
                      decodeMotorReference(datagram.bytes).ok());
      }
    } else if (what < 108) {
      static_cast<void>(end.command(static_cast<pipeline::RobotCommand>(what - 96)));
    } else {
      Endpoint from = touchpad;
      if (what == 255) ++from.address[0];
      const auto got = end.handle(input.bytes(), from);
      if (got.touch) fuzz::require(got.touch->position_mm.finite() && got.touch->force_N >= 0.0);
      if (got.image) fuzz::require(!end.image().empty() && end.image().size() <= kClassicMaximumImage);
    }
  }
  const RobotCounters& c = end.counters();
  fuzz::require(c.touches + c.missed_replies <= c.states);
  return 0;
}
