#include "core/sim/trial/reach_trial.h"

#include <algorithm>
#include <deque>

#include "core/protocol/classic/classic_robot_end.h"
#include "core/protocol/classic/classic_touchpad_end.h"
#include "core/protocol/link/link_robot_end.h"
#include "core/protocol/link/link_touchpad_end.h"
#include "core/sim/robot/robot_arm.h"

namespace fyd::sim {
namespace {

using protocol::Datagram;
using protocol::Endpoint;

const Endpoint kTouchpad{.address = {127, 0, 0, 1}, .port = 3490};
const Endpoint kRobot{.address = {127, 0, 0, 1}, .port = 3491};
constexpr double kTick_s = 1e-3;
constexpr int kWarmUp = 1500;  // ticks: the handshake, the first readings, arming

/// One direction of the network: datagrams come out when they are due.
class ReachWay {
 public:
  explicit ReachWay(const NetworkSettings& settings) : emulator_(settings) {}

  void put(const Datagram& datagram, Instant now) {
    for (const Instant due : emulator_.pass(datagram.bytes.size(), now).out) {
      const auto place = std::ranges::find_if(under_way_, [due](const UnderWay& other) { return other.due > due; });
      under_way_.insert(place, {due, {datagram.bytes.begin(), datagram.bytes.end()}});
    }
  }
  template <class Take>
  void deliver(Instant now, Take&& take) {
    while (!under_way_.empty() && under_way_.front().due <= now) {
      const UnderWay next = std::move(under_way_.front());
      under_way_.pop_front();
      take(protocol::Bytes(next.bytes), next.due);
    }
  }

 private:
  struct UnderWay {
    Instant due{};
    std::vector<std::uint8_t> bytes;
  };
  NetworkEmulator emulator_;
  std::deque<UnderWay> under_way_;
};

struct Ends {
  std::unique_ptr<protocol::TouchpadEnd> touchpad;
  std::unique_ptr<protocol::RobotEnd> robot;
};

Ends makeEnds(bool secured) {
  if (!secured) {
    return {std::make_unique<protocol::ClassicTouchpadEnd>(protocol::LinkParameters{}),
            std::make_unique<protocol::ClassicRobotEnd>(protocol::ClassicRobotSettings{}, kTouchpad)};
  }
  const protocol::LinkKey key = protocol::LinkKey::generate();
  return {std::make_unique<protocol::LinkTouchpadEnd>(protocol::LinkParameters{}, key),
          std::make_unique<protocol::LinkRobotEnd>(protocol::LinkRobotSettings{}, key, kTouchpad)};
}

}  // namespace

Result<std::vector<ReachRow>> reach(const ReachSettings& settings) {
  for (const NetworkSettings& way : {settings.network.forward, settings.network.backward}) {
    if (auto good = checkNetwork(way); !good) return tl::unexpected(good.error());
  }
  if (auto good = device::checkLimits(settings.limits); !good) return tl::unexpected(good.error());
  Lockstep touchpad(settings.touchpad);
  Ends ends = makeEnds(settings.secured);
  ReachWay to_touchpad(settings.network.forward);
  ReachWay to_robot(settings.network.backward);
  device::FollowingRobot robot(std::make_unique<RobotArm>(settings.touchpad.sim), settings.limits);
  device::TouchReference reference(settings.reference, robot.lag_s());
  const protocol::TouchMappingSettings& mapping = settings.reference.mapping;
  const pipeline::StepParameters& step = settings.touchpad.parameters.step;
  const Vec3 scale{mapping.scale_xy * step.motion_scale, mapping.scale_xy * step.motion_scale,
                   mapping.scale_z * step.motion_depth_scale};
  std::vector<ReachRow> rows;
  const auto ticks = static_cast<int>(settings.seconds / kTick_s);
  for (int tick = 0; tick < ticks; ++tick) {
    if (tick == kWarmUp) (void)touchpad.next.commands.push({.action = pipeline::OperatorAction::arm});
    const pipeline::Outputs& outputs = touchpad.step();
    const Instant now = touchpad.next.now;
    const protocol::TouchpadAnswer answer{
        .touch = outputs.touch, .taken = now, .info = {}, .board_text = "trial", .image = {}};
    to_touchpad.deliver(now, [&](protocol::Bytes bytes, Instant /*due*/) {
      for (const Datagram& reply : ends.touchpad->handle(bytes, kRobot, now, answer).replies) to_robot.put(reply, now);
    });
    for (const Datagram& datagram : ends.touchpad->advance(now, answer)) to_robot.put(datagram, now);

    const device::MovingTarget target = reference.at(now, ends.robot->phase());
    const auto readings = robot.exchange(target.position_mm, kTick_s, now, target.velocity_mm_s);
    if (!readings) return tl::unexpected(readings.error());
    const protocol::RobotReport report{.robot = {.position_mm = readings->position_mm},
                                       .acceleration_taken = readings->taken};
    for (const Datagram& datagram : ends.robot->tick(now, report)) to_touchpad.put(datagram, now);
    to_robot.deliver(now, [&](protocol::Bytes bytes, Instant /*due*/) {
      const protocol::RobotReception reception = ends.robot->handle(bytes, kTouchpad, now);
      reference.take(reception, ends.robot->counters(), robot.commanded_mm(), now);
    });

    const FingerState finger = touchpad.world().truth().finger;
    const Vec3 touch = outputs.touch.position_mm;
    rows.push_back({.t_s = touchpad.time_s(),
                    .finger_mm = {scale.x * finger.x_mm, scale.y * finger.y_mm, -scale.z * finger.indentation_mm},
                    .touch_mm = {mapping.scale_xy * touch.x, mapping.scale_xy * touch.y, mapping.scale_z * touch.z},
                    .told_mm = robot.commanded_mm(),
                    .tool_mm = readings->position_mm,
                    .touching = !finger.lifted && outputs.touch.in_contact});
  }
  return rows;
}

}  // namespace fyd::sim
