// One end of a session of two linked devices that is told anything among a real peer's messages, late, changed, twice
// and after silences: its force stays finite and within the motor's, and what it sends can be read.
#include <cmath>
#include <limits>
#include <vector>

#include "core/sim/teleop/desktop_arm.h"
#include "core/sim/teleop/teleop_end.h"
#include "core/teleop/coupling/coupling_choice.h"
#include "core/teleop/prediction/predictor_choice.h"
#include "tests/fuzz/fuzz.h"

using namespace fyd;
using namespace fyd::sim;

namespace {

constexpr double kMost_N = 20.0;

DeviceState stateOf(fuzz::Input& in) {
  const auto number = [&](double scale) {
    const std::uint8_t byte = in.byte();
    if (byte == 255) return std::numeric_limits<double>::quiet_NaN();
    if (byte == 254) return 1e300;
    return scale * (byte - 127.0);
  };
  DeviceState out;
  out.position_mm = {number(1.0), number(0.5), 0.0};
  out.velocity_mm_per_s = {number(10.0), 0.0, 0.0};
  out.force_N = {number(0.1), 0.0, 0.0};
  return out;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto code = *protocol::PositionCode::make(DesktopArm::workspace());
  fuzz::Input in(data, size);
  const std::uint8_t mode = in.byte();
  TeleopEndSettings settings{
      .at_hand = (mode & 1) != 0,
      .coupling = static_cast<teleop::CouplingChoice>((mode >> 1) % 3),
      .coupling_settings = {.most_force_N = kMost_N},
      .predictor = (mode & 64) != 0 ? teleop::PredictorChoice::kalman : teleop::PredictorChoice::order1,
      .deadband = (mode & 128) != 0 ? 0.1 : 0.0};
  TeleopEnd end(settings);
  settings.at_hand = !settings.at_hand;
  TeleopEnd peer(settings);
  std::uint16_t session = 1;
  end.start(session++);
  peer.start(session++);
  double now_s = 100.0;
  std::vector<std::uint8_t> sent;
  DeviceState own, others;
  while (!in.empty()) {
    const std::uint8_t op = in.byte();
    now_s += 0.001;
    static_cast<void>(peer.step(others, now_s));
    const auto bytes = peer.datagram(now_s);
    if (!bytes.empty()) sent.assign(bytes.begin(), bytes.end());
    switch (op % 8) {
      case 3: {
        auto changed = sent;
        std::size_t at = in.byte();
        for (const std::uint8_t each : in.bytes()) {
          if (at < changed.size()) changed[at++] ^= each;
        }
        end.receive(changed, now_s);
        break;
      }
      case 4: end.receive(in.bytes(), now_s); break;
      case 5: now_s += 0.010 * in.byte(); break;
      case 6:
        ((op & 8) != 0 ? end : peer).stop();
        if ((op & 16) != 0) ((op & 8) != 0 ? end : peer).start(session++);
        break;
      case 7: ((op & 8) != 0 ? own : others) = stateOf(in); break;
      default: end.receive(sent, now_s); break;
    }
    const Vec3 force = end.step(own, now_s);
    fuzz::require(force.finite());
    for (const double each : {force.x, force.y, force.z}) fuzz::require(std::abs(each) <= kMost_N);
    const auto told = end.datagram(now_s);
    if (told.empty()) continue;
    fuzz::require(protocol::decodeDeviceMessage(told, code).has_value());
    peer.receive(told, now_s);
  }
  return 0;
}
