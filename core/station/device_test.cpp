#include "core/station/device_test.h"

#include <algorithm>
#include <cmath>

#include "core/control/motor_mixing.h"

namespace fyd::station {
namespace {

constexpr Duration kLongestGap = std::chrono::milliseconds(20);
constexpr double kOffCourse_deg = 10.0;
constexpr Duration kFirstStep = std::chrono::milliseconds(1100);  // a sweep rests at 0 until 1.5 s

bool identifies(device::DeviceTest test) {
  return test == device::DeviceTest::breakaway || test == device::DeviceTest::chirp;
}

bool has(const pipeline::FaultSet& faults, pipeline::Fault fault) {
  return faults.test(static_cast<std::size_t>(fault));
}

}  // namespace

Message DeviceTestRunner::words(End end) {
  switch (end) {
    case End::none: return {};
    case End::running: return say("running");
    case End::finished: return say("finished");
    case End::released: return say("ended: the button was released");
    case End::operator_acted: return say("ended: the session was stopped or armed");
    case End::state_changed: return say("ended: the session's state changed");
    case End::motors_silent: return say("the motors do not answer");
    case End::steps_missing: return say("ended: the haptic loop stood still");
    case End::off_course:
      return say("ended: a motor did not follow its commanded angle; check its encoder and that it can turn");
    case End::not_now: return say("the motors are in use: stop the session first");
    case End::beyond_limit: return say("a motor stands beyond control.motor_limit_deg: check the encoder's zero");
    case End::beyond_travel:
      return say("the stretch lies outside control.travel_minimum_deg and control.travel_maximum_deg");
    case End::beyond_motors: return say("the motion goes beyond control.motor_limit_deg");
  }
  return {};
}

Result<void> DeviceTestRunner::start(device::DeviceTest test, Instant now, double stretch_deg) {
  const auto index = static_cast<std::size_t>(test);
  if (index >= device::kDeviceTestNames.size()) return fail("device test {}: no test has this number", index);
  stop();
  if (const End refused = refused_now_.load(std::memory_order_relaxed); refused != End::none) {
    return fail("device test '{}': {}", phrase(device::kDeviceTestNames[index]), words(refused));
  }
  if (!std::isfinite(stretch_deg))
    return fail("device test '{}': {}", phrase(device::kDeviceTestNames[index]), words(End::beyond_travel));
  keep(now);
  tape_.restart();
  wanted_stretch_deg_.store(stretch_deg, std::memory_order_relaxed);
  asked_ = (++presses_ << 8U) | static_cast<std::uint32_t>(index) | 0x80U;  // never 0
  request_.store(asked_, std::memory_order_release);
  return {};
}

DeviceTestStatus DeviceTestRunner::status() const {
  DeviceTestStatus out;
  if (asked_ == 0) return out;
  out.test = static_cast<device::DeviceTest>(asked_ & 0x7FU);
  const std::uint64_t outcome = outcome_.load(std::memory_order_acquire);
  const bool taken_up = outcome >> 8U == asked_;
  const End end = taken_up ? static_cast<End>(outcome & 0xFFU) : End::released;
  const bool waiting = !taken_up && request_.load(std::memory_order_relaxed) == asked_;
  out.running = waiting || end == End::running;
  out.progress = taken_up ? progress_.load(std::memory_order_relaxed) : 0.0;
  out.finished = !waiting && end == End::finished;
  out.words = words(waiting ? End::running : end);
  if (!taken_up || !out.running) return out;
  for (std::size_t i = 0; i < out.commanded_deg.size(); ++i) {
    out.commanded_deg[i] = commanded_deg_[i].load(std::memory_order_relaxed);
  }
  out.resting = resting_.load(std::memory_order_acquire);
  return out;
}

DeviceTestRunner::End DeviceTestRunner::refusal(const pipeline::Inputs& inputs, const pipeline::Outputs& outputs) {
  using enum pipeline::SafetyState;
  const pipeline::SafetyState state = outputs.telemetry.state;
  if (has(outputs.faults, pipeline::Fault::motors_stale) || inputs.motors.count == 0) return End::motors_silent;
  return (state == connected || state == ready || state == stopped) && !outputs.motors.active ? End::none
                                                                                              : End::not_now;
}

DeviceTestRunner::End DeviceTestRunner::check(const pipeline::Inputs& inputs, const pipeline::Outputs& outputs,
                                              const std::array<double, control::kMotorCount>& motor_deg) const {
  const bool acted = std::any_of(inputs.commands.begin(), inputs.commands.end(), [](const auto& command) {
    return command.action == pipeline::OperatorAction::stop || command.action == pipeline::OperatorAction::arm;
  });
  if (acted) return End::operator_acted;
  if (outputs.telemetry.state != state_) return End::state_changed;
  if (const End refused = refusal(inputs, outputs); refused != End::none) return refused;
  if (inputs.now - last_step_ > kLongestGap || inputs.now < last_step_) return End::steps_missing;
  const Instant kept{Duration(kept_.load(std::memory_order_relaxed))};
  if (request_.load(std::memory_order_acquire) != seen_ || inputs.now - kept > kHold) return End::released;
  return follows(inputs.now - started_, motor_deg) ? End::running : End::off_course;
}

bool DeviceTestRunner::follows(Duration elapsed, const std::array<double, control::kMotorCount>& motor_deg) const {
  const auto wanted = motion_->anglesAt(elapsed);
  const bool sweep = motion_->test() == device::DeviceTest::sweep;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    double away = wanted[i] - motor_deg[i];
    if (sweep) {
      // Until the first step the motor is on its way to its own zero, and any valid angle is accepted.
      const double turned =
          elapsed < kFirstStep ? 0.0 : std::abs(std::remainder(motor_deg[i] - swept_from_deg_[i], 360.0));
      away = std::isfinite(motor_deg[i]) ? std::abs(wanted[i]) - turned : motor_deg[i];
    }
    if (!(std::abs(away) <= kOffCourse_deg)) return false;
  }
  return true;
}

void DeviceTestRunner::end(End why) {
  motion_.reset();
  outcome_.store((std::uint64_t{seen_} << 8U) | static_cast<std::uint64_t>(why), std::memory_order_release);
}

void DeviceTestRunner::begin(const pipeline::Inputs& inputs, const pipeline::Outputs& outputs,
                             const control::ControlParameters& parameters,
                             const std::array<double, control::kMotorCount>& motor_deg) {
  if (const End refused = refusal(inputs, outputs); refused != End::none) {
    end(refused);
    return;
  }
  const auto test = static_cast<device::DeviceTest>(seen_ & 0x7FU);
  const double stretch_deg = wanted_stretch_deg_.load(std::memory_order_relaxed);
  const bool within = test == device::DeviceTest::sweep || std::ranges::all_of(motor_deg, [&](double angle) {
                        return std::abs(angle) <= parameters.motor_limit_deg;
                      });
  if (!within) {  // checked here, because an error with a text would allocate
    end(End::beyond_limit);
    return;
  }
  if (device::goesToStretch(test) &&
      !(stretch_deg >= parameters.travel_minimum_deg && stretch_deg <= parameters.travel_maximum_deg)) {
    end(End::beyond_travel);
    return;
  }
  const double furthest_deg = test == device::DeviceTest::sweep ? device::kSweepTop_deg
                              : device::goesToStretch(test)     ? stretch_deg
                                                                : 0.0;
  if (furthest_deg > parameters.motor_limit_deg) {
    end(End::beyond_motors);
    return;
  }
  const auto planned = device::TestMotion::plan(test, motor_deg, parameters.motor_limit_deg, stretch_deg);
  if (!planned) {
    end(End::not_now);
    return;
  }
  motion_ = *planned;
  started_ = last_step_ = inputs.now;
  state_ = outputs.telemetry.state;
  outcome_.store((std::uint64_t{seen_} << 8U) | static_cast<std::uint64_t>(End::running), std::memory_order_release);
}

std::optional<control::MotorCommand> DeviceTestRunner::step(const pipeline::Inputs& inputs,
                                                            const pipeline::Outputs& outputs,
                                                            const control::ControlParameters& parameters) {
  refused_now_.store(refusal(inputs, outputs), std::memory_order_relaxed);
  const control::RollerAngles rollers = control::rollerAngles(inputs.motors.value, parameters);
  const double nowhere = std::numeric_limits<double>::quiet_NaN();
  const std::array<double, control::kMotorCount> motor_deg = {
      rollers.valid ? rollers.stretch_deg + rollers.translation_deg : nowhere,
      rollers.valid ? rollers.translation_deg - rollers.stretch_deg : nowhere};
  if (motion_) {
    if (const End why = check(inputs, outputs, motor_deg); why != End::running) {
      end(why);
      return std::nullopt;  // at least one step with the motors off before another press is taken up
    }
  } else if (const std::uint32_t asked = request_.load(std::memory_order_acquire); asked != 0 && asked != seen_) {
    seen_ = asked;
    begin(inputs, outputs, parameters, motor_deg);
  }
  if (!motion_) return std::nullopt;
  last_step_ = inputs.now;
  const Duration elapsed = inputs.now - started_;
  progress_.store(toSeconds(elapsed) / toSeconds(motion_->length()), std::memory_order_relaxed);
  if (elapsed < kFirstStep) swept_from_deg_ = motor_deg;
  const auto angles = motion_->anglesAt(elapsed);
  for (std::size_t i = 0; i < angles.size(); ++i) commanded_deg_[i].store(angles[i], std::memory_order_relaxed);
  resting_.store(motion_->restsAt(elapsed), std::memory_order_release);
  const auto command = motion_->at(elapsed);
  if (command && identifies(motion_->test())) {
    tape_.add(inputs, *command, motion_->experimentAt(elapsed), elapsed, rollers.stretch_deg);
  }
  if (!command) end(End::finished);
  return command;
}

}  // namespace fyd::station
