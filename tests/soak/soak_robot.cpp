#include "tests/soak/soak_robot.h"

#include <algorithm>
#include <limits>

#include "core/protocol/classic/classic_robot_end.h"
#include "core/protocol/classic/classic_touchpad_end.h"
#include "core/protocol/link/link_robot_end.h"
#include "core/protocol/link/link_touchpad_end.h"
#include "core/sim/robot/robot_arm.h"

namespace fyd::soak {
namespace {

using std::chrono::milliseconds;

constexpr double kCalmDelay_ms = 2.0;
constexpr double kTick_s = 0.001;
// The cap of a lost link (100 ms), what was under way when it was cut, and the time of a few cycles.
constexpr Duration kLostAfter = milliseconds(250);

protocol::Endpoint address(int host) { return *protocol::parseEndpoint(fmt::format("10.0.0.{}:4490", host)); }
const protocol::Endpoint kRobot = address(1);
const protocol::Endpoint kTouchpad = address(100);
const protocol::Endpoint kStranger = address(66);

enum class Fault : std::uint8_t { cut, storm, damage, restart, stiffness, command, reference, stranger };
constexpr std::array<const char*, 8> kFaultNames = {
    "network cut",          "network storm", "datagrams damaged",          "restart",
    "impossible stiffness", "command",       "motor reference of its own", "stranger's datagrams"};

std::string nameOf(Fault fault, Protocol protocol) {
  return fmt::format("robot {}, {}", kFaultNames[static_cast<std::size_t>(fault)],
                     protocol == Protocol::link ? "FYD Link" : "classic");
}

}  // namespace

SoakRobot::SoakRobot(Protocol protocol, int seed)
    : protocol_(protocol), seed_(seed), random_(static_cast<std::uint64_t>(seed)) {
  if (protocol_ == Protocol::none) return;
  if (protocol_ == Protocol::link) {
    touchpad_ = std::make_unique<protocol::LinkTouchpadEnd>(protocol::LinkParameters{}, key_);
  } else {
    touchpad_ = std::make_unique<protocol::ClassicTouchpadEnd>(protocol::LinkParameters{});
  }
  answer_.board_text = "soak";
  weather(kCalmDelay_ms, 0.5, 0.0);
  startRobot();
}

void SoakRobot::startRobot() {
  ++starts_;
  sim::SimParameters arm;
  arm.seed = seed_;
  arm_ = std::make_unique<device::FollowingRobot>(std::make_unique<sim::RobotArm>(arm), device::MotionLimits{});
  reference_ = std::make_unique<device::TouchReference>(device::TouchReferenceSettings{}, arm_->lag_s());
  reference_->reset({});
  if (protocol_ == Protocol::link) {
    robot_ = std::make_unique<protocol::LinkRobotEnd>(protocol::LinkRobotSettings{}, key_, kTouchpad);
  } else {
    robot_ = std::make_unique<protocol::ClassicRobotEnd>(protocol::ClassicRobotSettings{.ack_retry = milliseconds(100)},
                                                         kTouchpad);
  }
}

void SoakRobot::weather(double delay_ms, double jitter_ms, double loss_percent) {
  sim::NetworkSettings settings;
  settings.delay_ms = delay_ms;
  settings.jitter_ms = jitter_ms;
  settings.loss_percent = loss_percent;
  settings.reorder_percent = loss_percent > 0.0 ? 10.0 : 0.0;
  settings.duplicate_percent = loss_percent > 0.0 ? 10.0 : 0.0;
  settings.seed = random_();
  there_.emplace(settings);
  settings.seed = random_();
  back_.emplace(settings);
}

void SoakRobot::post(std::span<const protocol::Datagram> datagrams, bool to_touchpad, Instant now) {
  for (const protocol::Datagram& datagram : datagrams) {
    const sim::Passage passage = (to_touchpad ? *there_ : *back_).pass(datagram.bytes.size(), now);
    for (const Instant arrival : passage.out.view()) {
      Flight flight{.arrival = arrival,
                    .number = number_++,
                    .to_touchpad = to_touchpad,
                    .from = to_touchpad ? kRobot : kTouchpad,
                    .bytes = {datagram.bytes.begin(), datagram.bytes.end()}};
      if (!flight.bytes.empty() && std::uniform_real_distribution<>(0.0, 1.0)(random_) < damaged_share_) {
        if (random_() % 4 == 0) flight.bytes.resize(random_() % flight.bytes.size());
        if (!flight.bytes.empty()) {
          flight.bytes[random_() % flight.bytes.size()] ^= static_cast<std::uint8_t>(1U << (random_() % 8));
        }
      }
      flights_.push(std::move(flight));
    }
  }
}

void SoakRobot::deliver(Instant now, pipeline::Inputs& inputs) {
  while (!flights_.empty() && flights_.top().arrival <= now) {
    const Flight flight = flights_.top();
    flights_.pop();
    if (!flight.to_touchpad) {
      const auto got = robot_->handle(flight.bytes, flight.from, now);
      reference_->take(got, robot_->counters(), arm_->commanded_mm(), now);
      continue;
    }
    const protocol::TouchpadReception& got = touchpad_->handle(flight.bytes, flight.from, now, answer_);
    if (got.session_started) {
      inputs.robot.state = {};
      inputs.robot.motor_reference = {};
    }
    was_lost_ = was_lost_ || got.was_lost;
    if (got.state) inputs.robot.state.set(*got.state, now);
    for (const auto& sample : got.accelerations) (void)inputs.robot.accelerations.push(sample);
    if (got.command != pipeline::RobotCommand::none) (void)inputs.robot.commands.push(got.command);
    if (got.motor_reference) inputs.robot.motor_reference.set(*got.motor_reference, now);
    post(got.replies.view(), false, now);
  }
}

void SoakRobot::moveArm(Instant now) {
  const device::MovingTarget target = reference_->at(now, robot_->phase());
  const auto moved = arm_->exchange(target.position_mm, kTick_s, now, target.velocity_mm_s);
  if (!moved) return;
  readings_ = *moved;
  if (arm_->resumed()) reference_->resume(arm_->commanded_mm());
}

void SoakRobot::advance(Instant now, const pipeline::Outputs& outputs, pipeline::Inputs& inputs) {
  if (protocol_ == Protocol::none) return;
  if (!calm_ && now >= calm_again_) {
    calm_ = true;
    damaged_share_ = 0.0;
    stiffness_N_per_mm_ = 0.62;
    weather(kCalmDelay_ms, 0.5, 0.0);
  }
  answer_.touch = outputs.touch;
  answer_.taken = outputs.telemetry.now;
  answer_.info.reference_ticks = {static_cast<double>(outputs.motors.reference_ticks[0]),
                                  static_cast<double>(outputs.motors.reference_ticks[1])};
  deliver(now, inputs);
  moveArm(now);
  const protocol::RobotReport report{.acceleration_g = readings_.acceleration_g - Vec3{0.0, 0.0, 1.0},
                                     .robot = {.stiffness_N_per_mm = stiffness_N_per_mm_,
                                               .position_mm = readings_.position_mm,
                                               .button = false,
                                               .force_N = readings_.force_N},
                                     .motor_reference = motor_reference_,
                                     .acceleration_taken = now};
  post(robot_->tick(now, report), true, now);
  if (robot_->phase() == protocol::RobotPhase::closed) startRobot();
  post(touchpad_->advance(now, answer_), false, now);
  inputs.robot.phase = was_lost_ ? pipeline::LinkPhase::lost : touchpad_->phase();
  was_lost_ = false;
}

std::optional<Deadline> SoakRobot::disturb(Chance& chance, Instant now, Figures& figures) {
  if (protocol_ == Protocol::none) return std::nullopt;
  const Duration lasts = milliseconds(20 + chance.below(1500));
  const bool was_calm = calm_;
  const auto until_then = [&] {
    calm_ = false;
    calm_again_ = std::max(calm_again_, now + lasts);
  };
  const auto fault = static_cast<Fault>(chance.below(kFaultNames.size()));
  if (fault == Fault::storm && !was_calm) return std::nullopt;  // a cut stays one until it ends: its deadline says so
  ++figures.faults[nameOf(fault, protocol_)];
  switch (fault) {
    case Fault::cut:
      weather(kCalmDelay_ms, 0.0, 100.0);
      until_then();
      if (!was_calm || touchpad_->phase() != pipeline::LinkPhase::running) return std::nullopt;
      return Deadline{.name = "robot network cut", .until = now + kLostAfter, .ends = now + lasts, .of_robot = true};
    case Fault::storm:
      weather(chance.between(1.0, 60.0), chance.between(0.0, 30.0), chance.between(1.0, 60.0));
      until_then();
      break;
    case Fault::damage:
      damaged_share_ = chance.between(0.01, 0.5);
      until_then();
      break;
    case Fault::restart: startRobot(); break;
    case Fault::stiffness: {
      constexpr std::array<double, 4> kWrong = {std::numeric_limits<double>::quiet_NaN(),
                                                std::numeric_limits<double>::infinity(), -1.0, 1e9};
      stiffness_N_per_mm_ = kWrong[static_cast<std::size_t>(chance.below(4))];
      until_then();
      break;
    }
    case Fault::command: (void)robot_->command(static_cast<pipeline::RobotCommand>(1 + chance.below(11))); break;
    case Fault::reference:
      (void)robot_->command(pipeline::RobotCommand::motor_reference_on);
      motor_reference_ = {.first_ticks = chance.between(-1e5, 1e5), .second_ticks = chance.between(-1e5, 1e5)};
      break;
    case Fault::stranger:
      for (int i = 0; i < 50; ++i) {
        Flight flight{.arrival = now + milliseconds(chance.below(500)),
                      .number = number_++,
                      .to_touchpad = true,
                      .from = chance.once(2) ? kStranger : kRobot,
                      .bytes = {}};
        flight.bytes.resize(static_cast<std::size_t>(chance.below(200)));
        for (auto& byte : flight.bytes) byte = static_cast<std::uint8_t>(chance.below(256));
        flights_.push(std::move(flight));
      }
      break;
  }
  return std::nullopt;
}

void SoakRobot::nameFaults(Figures& figures) {
  for (std::size_t i = 0; i < kFaultNames.size(); ++i) {
    for (const Protocol over : {Protocol::classic, Protocol::link}) figures.faults[nameOf(static_cast<Fault>(i), over)];
  }
}

}  // namespace fyd::soak
