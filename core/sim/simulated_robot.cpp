#include "core/sim/simulated_robot.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fyd::sim {
namespace {

constexpr Duration kVirtualStep = std::chrono::milliseconds(1);
constexpr int kRestReadings = 200;
constexpr Duration kPublishEvery = std::chrono::milliseconds(50);

std::unique_ptr<protocol::RobotEnd> makeEnd(const SimulatedRobotOptions& options) {
  if (options.key) return std::make_unique<protocol::LinkRobotEnd>(options.secure, *options.key, options.touchpad);
  return std::make_unique<protocol::ClassicRobotEnd>(options.link, options.touchpad);
}

}  // namespace

Result<std::unique_ptr<SimulatedRobot>> SimulatedRobot::open(const SimulatedRobotOptions& options,
                                                             std::unique_ptr<device::Robot> robot) {
  if (!(options.rate_Hz >= 1.0 && options.rate_Hz <= 10'000.0)) {
    return fail("simulated robot: {} states a second; expected 1 to 10000", options.rate_Hz);
  }
  if (options.touchpad.port == 0) {
    return fail("simulated robot: the touchpad's address {} has no port to call", protocol::toString(options.touchpad));
  }
  if (options.touchpad.v6 != options.bind.v6) {
    return fail("simulated robot: {} cannot call {}: both must be IPv4 or both IPv6", protocol::toString(options.bind),
                protocol::toString(options.touchpad));
  }
  auto socket = protocol::UdpSocket::open(options.bind);
  if (!socket) return tl::unexpected(socket.error());
  std::unique_ptr<SimulatedRobot> made(new SimulatedRobot(options, std::move(robot), std::move(*socket)));
  made->probe();
  return made;
}

SimulatedRobot::SimulatedRobot(const SimulatedRobotOptions& options, std::unique_ptr<device::Robot> robot,
                               protocol::UdpSocket socket)
    : options_(options),
      robot_(std::move(robot)),
      socket_(std::move(socket)),
      end_(makeEnd(options)),
      mapping_(options.mapping),
      buffer_(protocol::kMaximumDatagram) {
  std::ranges::stable_sort(options_.commands, {}, &TimedCommand::at_s);
  now_.description = robot_->description();
  now_.local = socket_.local();
}

// The arm's time runs ahead of the clock here and has stopped short of it when `run` begins.
void SimulatedRobot::probe() {
  constexpr double kSettling_s = 10.0;  // the way back, and the rest
  Instant virtual_now = Clock::now() - fromSeconds(options_.probe.time_limit_s + kSettling_s);
  const auto exchange = [&](const Vec3& target_mm) {
    virtual_now += kVirtualStep;
    const auto readings = robot_->exchange(target_mm, virtual_now);
    if (readings) now_.readings = *readings;
    return readings.has_value();
  };
  if (!exchange({})) ++now_.robot_errors;
  device::MaterialProbe probe(options_.probe, now_.readings.position_mm);
  while (!probe.finished()) {
    if (exchange(probe.step(now_.readings, virtual_now))) continue;
    ++now_.robot_errors;
    probe.abort();
  }
  now_.probe_outcome = probe.outcome();
  now_.probed_stiffness_N_per_mm = probe.stiffness_N_per_mm();

  Vec3 sum_g;
  int taken = 0;
  for (int i = 0; i < kRestReadings; ++i) {
    if (!exchange(probe.target()) || !now_.readings.acceleration_g.finite()) continue;
    sum_g = sum_g + now_.readings.acceleration_g;
    ++taken;
  }
  if (taken > 0) rest_acceleration_g_ = (1.0 / taken) * sum_g;
  mapping_.reset(probe.target());
  shown_ = now_;
}

void SimulatedRobot::run(const std::stop_token& stop, Duration limit) {
  began_ = Clock::now();
  const Duration period = fromSeconds(1.0 / options_.rate_Hz);
  Instant due = began_;
  for (Instant now = began_; !stop.stop_requested() && now - began_ < limit; now = Clock::now()) {
    exchangeWithRobot(now);
    queueCommands(now);
    sendDue(now);
    if (end_->phase() == protocol::RobotPhase::closed) break;
    if (now - published_ >= kPublishEvery) publish(now);
    due += period;
    if (now > due) {
      const auto behind = (now - due) / period;
      now_.missed_cycles += static_cast<std::uint64_t>(behind + 1);
      due += period * behind;
    }
    receiveUntil(due);
  }
  if (options_.farewell > Duration::zero()) sayFarewell();
  publish(Clock::now());
}

bool SimulatedRobot::command(pipeline::RobotCommand command) { return asked_.push(command); }

SimulatedRobotStatus SimulatedRobot::status() const {
  const std::lock_guard lock(mutex_);
  return shown_;
}

void SimulatedRobot::exchangeWithRobot(Instant now) {
  const auto readings = robot_->exchange(mapping_.target(), now);
  if (readings) {
    now_.readings = *readings;
  } else {
    ++now_.robot_errors;
  }
}

void SimulatedRobot::queueCommands(Instant now) {
  pipeline::RobotCommand asked{};
  while (asked_.pop(asked)) now_.commands_lost += end_->command(asked) ? 0 : 1;
  if (now_.connections == 0) return;
  const double since_s = toSeconds(now - connected_);
  for (; next_command_ < options_.commands.size(); ++next_command_) {
    if (options_.commands[next_command_].at_s > since_s) break;
    if (!end_->command(options_.commands[next_command_].command)) break;
  }
}

void SimulatedRobot::sendDue(Instant now) {
  const protocol::RobotReport report{.acceleration_g = now_.readings.acceleration_g - rest_acceleration_g_,
                                     .robot = {.stiffness_N_per_mm = now_.probed_stiffness_N_per_mm,
                                               .position_mm = now_.readings.position_mm,
                                               .button = false},
                                     .motor_reference = options_.motor_reference,
                                     .force_N = now_.readings.force_N,
                                     .acceleration_taken = now_.readings.taken};
  for (const protocol::Datagram& datagram : end_->tick(now, report)) {
    if (socket_.send(datagram.bytes, datagram.to) != protocol::SendOutcome::sent) ++now_.send_failures;
  }
}

void SimulatedRobot::receiveUntil(Instant deadline) {
  for (;;) {
    const auto received = socket_.receive(buffer_, std::max(deadline - Clock::now(), Duration::zero()));
    if (!received) return;
    const auto reception = end_->handle({buffer_.data(), received->size}, received->from, Clock::now());
    if (reception.connected) {
      if (now_.connections++ == 0) connected_ = Clock::now();
      mapping_.reset(now_.readings.position_mm);
    }
    if (reception.touch) {
      now_.touch = *reception.touch;
      mapping_.apply(*reception.touch);
    }
    if (Clock::now() >= deadline) return;
  }
}

void SimulatedRobot::sayFarewell() {
  if (end_->phase() != protocol::RobotPhase::running && end_->phase() != protocol::RobotPhase::paused) return;
  if (!end_->command(pipeline::RobotCommand::disconnect)) return;
  const Instant give_up = Clock::now() + options_.farewell;
  for (Instant now = Clock::now(); now < give_up; now = Clock::now()) {
    if (end_->phase() == protocol::RobotPhase::closed) return;
    if (end_->phase() == protocol::RobotPhase::closing && !end_->replyDue()) return;
    if (end_->phase() != protocol::RobotPhase::closing || options_.key) sendDue(now);
    receiveUntil(now + kVirtualStep);
  }
}

void SimulatedRobot::publish(Instant now) {
  published_ = now;
  now_.phase = end_->phase();
  now_.counters = end_->counters();
  now_.problem = end_->problem();
  now_.seconds = toSeconds(now - began_);
  const std::lock_guard lock(mutex_);
  shown_ = now_;
}

}  // namespace fyd::sim
