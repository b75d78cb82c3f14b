#include "core/device/robot/robot_runner.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace fyd::device {
namespace {

constexpr Duration kVirtualStep = std::chrono::milliseconds(1);
constexpr Duration kLateness = std::chrono::milliseconds(2);  // of this loop, where the clock waits for it
constexpr Duration kLongestBraking = std::chrono::seconds(5);
constexpr Duration kPublishEvery = std::chrono::milliseconds(50);

std::unique_ptr<protocol::RobotEnd> makeEnd(const RobotRunnerOptions& options) {
  if (options.key) return std::make_unique<protocol::LinkRobotEnd>(options.secure, *options.key, options.touchpad);
  return std::make_unique<protocol::ClassicRobotEnd>(options.link, options.touchpad);
}

}  // namespace

Result<std::unique_ptr<RobotRunner>> RobotRunner::open(const RobotRunnerOptions& options,
                                                       std::unique_ptr<Robot> robot) {
  if (!(options.rate_Hz >= 1.0 && options.rate_Hz <= 10'000.0)) {
    return fail("robot end: {} states a second; expected 1 to 10000", options.rate_Hz);
  }
  if (options.touchpad.port == 0) {
    return fail("robot end: the touchpad's address {} has no port to call", protocol::toString(options.touchpad));
  }
  if (options.touchpad.v6 != options.bind.v6) {
    return fail("robot end: {} cannot call {}: both must be IPv4 or both IPv6", protocol::toString(options.bind),
                protocol::toString(options.touchpad));
  }
  if (auto limits = checkLimits(options.limits); !limits) return fail("robot end: {}", limits.error().message);
  if (auto good = checkReference(options.reference); !good) return fail("robot end: {}", good.error().message);
  if (auto good = checkProbe(options.probe); !good) return fail("robot end: {}", good.error().message);
  if (!(options.known_stiffness_N_per_mm >= 0.0)) {
    return fail("robot end: known stiffness {} N/mm; expected 0 or more", options.known_stiffness_N_per_mm);
  }
  auto socket = protocol::UdpSocket::open(options.bind);
  if (!socket) return tl::unexpected(socket.error());
  std::unique_ptr<RobotRunner> made(new RobotRunner(options, std::move(robot), std::move(*socket)));
  made->prepareAhead();
  return made;
}

RobotRunner::RobotRunner(const RobotRunnerOptions& options, std::unique_ptr<Robot> robot, protocol::UdpSocket socket)
    : options_(options),
      robot_(std::move(robot), options.limits),
      end_(makeEnd(options)),
      socket_(std::move(socket)),
      preparation_(options.probe, options.probe_material, options.known_stiffness_N_per_mm),
      reference_(options.reference, robot_.lag_s()),
      buffer_(protocol::kMaximumDatagram) {
  std::ranges::stable_sort(options_.commands, {}, &TimedCommand::at_s);
  now_.description = robot_.description();
  now_.local = socket_.local();
}

// Virtual time starts so far in the past that the preparation ends before the present time, from which `run` goes on.
void RobotRunner::prepareAhead() {
  if (robot_.inVirtualTime()) {
    constexpr double kSettling_s = 10.0;  // the way back, and the rest
    const Instant end = Clock::now();
    Instant virtual_now = end - fromSeconds(options_.probe.time_limit_s + kSettling_s);
    for (; !now_.prepared && virtual_now < end; virtual_now += kVirtualStep) {
      prepareStep(kVirtualStep, virtual_now);
    }
  }
  shown_ = now_;
}

void RobotRunner::prepareStep(Duration tick, Instant now) {
  exchangeWithRobot({.position_mm = preparation_.target(), .velocity_mm_s = {}}, tick, now);
  if (robot_.following()) {
    preparation_.succeeded(now_.readings, now);
  } else {
    preparation_.failed(now);
  }
  now_.prepared = preparation_.finished();
  now_.probe_outcome = preparation_.outcome();
  now_.probed_stiffness_N_per_mm = preparation_.stiffness_N_per_mm();
  reference_.reset(preparation_.target());
}

void RobotRunner::run(const std::stop_token& stop, Duration limit) {
  began_ = Clock::now();
  const Duration period = fromSeconds(1.0 / options_.rate_Hz);
  Instant due = began_;
  std::optional<Instant> braking_since;
  std::optional<ClockHold> hold(std::in_place, options_.clock_waits);
  for (Instant now = began_;; now = Clock::now()) {
    const bool closed = end_->phase() == protocol::RobotPhase::closed;
    if (closed || stop.stop_requested() || now - began_ >= limit) {
      if (!now_.prepared) {
        preparation_.abort();
      } else if (!braking_since) {
        braking_since = now;
        robot_.comeToRest();
      }
    }
    if (now_.prepared) {
      exchangeWithRobot(reference_.at(now, end_->phase()), period, now);
      // The loop ends only when the arm has braked: without commands in mid-motion it would stop abruptly.
      if (braking_since && (robot_.atRest() || !robot_.following() || now - *braking_since > kLongestBraking)) break;
      queueCommands(now);
      sendDue(now);
    } else {
      prepareStep(period, now);
    }
    if (now - published_ >= kPublishEvery) publish(now);
    due += period;
    if (now > due) {
      const auto behind = (now - due) / period;
      now_.missed_cycles += static_cast<std::uint64_t>(behind + 1);
      due += period * behind;
    }
    hold->until(due + kLateness);
    receiveUntil(due);
  }
  hold.reset();
  if (options_.farewell > Duration::zero()) sayFarewell();
  publish(Clock::now());
}

bool RobotRunner::command(pipeline::RobotCommand command) { return asked_.push(command); }

RobotRunnerStatus RobotRunner::status() const {
  const std::lock_guard lock(mutex_);
  return shown_;
}

void RobotRunner::exchangeWithRobot(const MovingTarget& target, Duration tick, Instant now) {
  now_.target_mm = target.position_mm;
  auto readings = robot_.exchange(target.position_mm, toSeconds(tick), now, target.velocity_mm_s);
  if (!readings) {
    ++now_.robot_errors;
    now_.robot_problem = std::move(readings.error().message);
    return;
  }
  if (robot_.resumed() && now_.robot_errors > 0) {
    ++now_.robot_resumed;
    now_.robot_problem = {};
  }
  now_.readings = *readings;
  if (robot_.resumed()) reference_.resume(robot_.commanded_mm());
}

bool RobotRunner::queue(pipeline::RobotCommand command) {
  if (!end_->command(command)) return false;
  leaving_ = leaving_ || command == pipeline::RobotCommand::disconnect;
  return true;
}

void RobotRunner::queueCommands(Instant now) {
  pipeline::RobotCommand asked{};
  while (asked_.pop(asked)) now_.commands_lost += queue(asked) ? 0 : 1;
  if (now_.connections == 0) return;
  const double since_s = toSeconds(now - connected_);
  for (; next_command_ < options_.commands.size(); ++next_command_) {
    if (options_.commands[next_command_].at_s > since_s) break;
    if (!queue(options_.commands[next_command_].command)) break;
  }
}

void RobotRunner::sendDue(Instant now) {
  // What the arm last said is old: the touchpad is to miss the robot, and not to act on that.
  if (!robot_.following() && !leaving_) return;
  const protocol::RobotReport report{
      .acceleration_g = now_.readings.acceleration_g - preparation_.restAcceleration_g(),
      .robot = {.stiffness_N_per_mm = now_.readings.stiffness_N_per_mm.value_or(now_.probed_stiffness_N_per_mm),
                .position_mm = now_.readings.position_mm,
                .button = false,
                .force_N = now_.readings.force_N},
      .motor_reference = options_.motor_reference,
      .acceleration_taken = now_.readings.taken};
  for (const protocol::Datagram& datagram : end_->tick(now, report)) {
    if (socket_.send(datagram.bytes, datagram.to) != protocol::SendOutcome::sent) ++now_.send_failures;
  }
}

void RobotRunner::receiveUntil(Instant deadline) {
  for (;;) {
    const auto received = socket_.receive(buffer_, std::max(deadline - Clock::now(), Duration::zero()));
    if (!received) return;
    const auto reception = end_->handle({buffer_.data(), received->size}, received->from, Clock::now());
    if (reception.connected && now_.connections++ == 0) connected_ = Clock::now();
    if (reception.touch) now_.touch = *reception.touch;
    reference_.take(reception, end_->counters(), robot_.commanded_mm(), Clock::now());
    if (Clock::now() >= deadline) return;
  }
}

void RobotRunner::sayFarewell() {
  if (end_->phase() != protocol::RobotPhase::running && end_->phase() != protocol::RobotPhase::paused) return;
  if (!queue(pipeline::RobotCommand::disconnect)) return;
  const Instant give_up = Clock::now() + options_.farewell;
  for (Instant now = Clock::now(); now < give_up; now = Clock::now()) {
    if (end_->phase() == protocol::RobotPhase::closed) return;
    if (end_->phase() == protocol::RobotPhase::closing && !end_->replyDue()) return;
    if (end_->phase() != protocol::RobotPhase::closing || options_.key) sendDue(now);
    receiveUntil(now + kVirtualStep);
  }
}

void RobotRunner::publish(Instant now) {
  published_ = now;
  now_.phase = end_->phase();
  now_.counters = end_->counters();
  now_.touchpad = end_->boardText();
  now_.problem = end_->problem();
  now_.seconds = toSeconds(now - began_);
  now_.targets_refused = robot_.refused();
  now_.arrived_mm = reference_.arrived_mm();
  now_.reference = reference_.figures();
  const std::lock_guard lock(mutex_);
  shown_ = now_;
}

}  // namespace fyd::device
