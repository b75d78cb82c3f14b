#include "core/station/haptic_thread.h"

#include "core/station/notice.h"

namespace fyd::station {
namespace {

/// Of the board that has the longer one: which of the two drives the motors is not known here.
Duration longestWatchdog(std::span<const Parameter> parameters) {
  const auto ms = [&](std::string_view id) { return findParameter(parameters, id)->value(); };
  return fromSeconds(1e-3 * std::max(ms("device.watchdog_ms"), ms("device.qbmove_watchdog_ms")));
}

}  // namespace

HapticThread::HapticThread(const pipeline::Parameters& step, const pipeline::LocalModel& local,
                           std::span<const Parameter> parameters)
    : pipeline_(step, local),
      release_(longestWatchdog(parameters)),
      input_delay_index_(static_cast<std::uint16_t>(findParameter(parameters, kInputDelay) - parameters.data())),
      longest_input_delay_ms_(parameters[input_delay_index_].info.maximum) {}

void HapticThread::start(const Neighbours& neighbours) {
  waits_ = neighbours.waits;
  waited_before_ = Clock::heldBack();
  thread_ = std::jthread([this, neighbours](const std::stop_token& stop) {
    loop_.run(stop, neighbours.waits,
              [&](Instant now, std::uint64_t missed_cycles) { cycle(neighbours, now, missed_cycles); });
  });
}

void HapticThread::shutDown() {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  thread_.join();
}

const pipeline::TareValues* HapticThread::tare() const {
  return tares_.load(std::memory_order_acquire) > 0 ? &tare_.read() : nullptr;
}

LoopStatus HapticThread::status() const {
  const StepTimes::Figures times = step_times_.figures();
  return {.steps = loop_.cycles(),
          .missed_cycles = loop_.missedCycles(),
          .step_ns_p50 = times.p50_ns,
          .step_ns_p99 = times.p99_ns,
          .real_time = loop_.realTime(),
          .waits = waits_,
          .waited_s = waits_ ? toSeconds(Clock::heldBack() - waited_before_) : 0.0};
}

void HapticThread::takeDevices(const Neighbours& neighbours) {
  inputs_.finger = neighbours.camera.finger.read();
  const device::TouchpadReadings& readings = neighbours.touchpad.readings.read();
  inputs_.ir = readings.ir;
  inputs_.bridge = readings.bridge;
  inputs_.motors = readings.motors;
}

void HapticThread::takeLink(LinkThread* link) {
  inputs_.robot.accelerations.clear();
  inputs_.robot.commands.clear();
  if (link == nullptr) return;
  const LinkSnapshot& snapshot = link->snapshot.read();
  inputs_.robot.phase = link_phase_.next(snapshot);
  inputs_.robot.state = snapshot.state;
  inputs_.robot.motor_reference = snapshot.motor_reference;
  texture::AccelerationSample sample;
  while (!inputs_.robot.accelerations.full() && link->accelerations.pop(sample)) {
    (void)inputs_.robot.accelerations.push(sample);
  }
  pipeline::RobotCommand command{};
  while (!inputs_.robot.commands.full() && link->commands.pop(command)) (void)inputs_.robot.commands.push(command);
}

void HapticThread::takeOperator() {
  inputs_.commands.clear();
  inputs_.changes.clear();
  if (stop_requested_.exchange(false, std::memory_order_acq_rel)) {
    (void)inputs_.commands.push({.action = pipeline::OperatorAction::stop});
  }
  if (!waits_ && window.fellSilent(inputs_.now)) {
    (void)inputs_.commands.push({.action = pipeline::OperatorAction::fell_silent});
  }
  pipeline::OperatorCommand command;
  while (!inputs_.commands.full() && commands.pop(command)) (void)inputs_.commands.push(command);
  pipeline::ParameterChange change;
  while (!inputs_.changes.full() && changes.pop(change)) (void)inputs_.changes.push(change);
}

// Raises texture.input_delay_ms for batched accelerations. It is a parameter change, so that a replay repeats it.
void HapticThread::fitInputDelay(LinkThread* link) {
  if (link == nullptr || inputs_.changes.full()) return;
  const double needed_ms = std::min(link->snapshot.read().sample_delay_ms, longest_input_delay_ms_);
  if (needed_ms <= pipeline_.parameters().texture.input_delay_ms) return;
  (void)inputs_.changes.push({.index = input_delay_index_, .value = needed_ms});
}

void HapticThread::cycle(const Neighbours& neighbours, Instant now, std::uint64_t missed_cycles) {
  inputs_.now = now;
  inputs_.missed_cycles = missed_cycles;
  lateness_.add(now, missed_cycles);
  takeDevices(neighbours);
  takeLink(neighbours.link);
  takeOperator();
  fitInputDelay(neighbours.link);

  const Instant before = Clock::now();
  const pipeline::Outputs& outputs = pipeline_.step(inputs_);
  step_times_.add(Clock::now() - before);
  publish(neighbours, outputs);
}

void HapticThread::publish(const Neighbours& neighbours, const pipeline::Outputs& outputs) {
  const Instant now = inputs_.now;
  const auto tested = device_test.step(inputs_, outputs, pipeline_.parameters().control);
  control::MotorCommand motors = tested ? *tested : outputs.motors;
  const bool released = release_.step(outputs.telemetry.state, inputs_.motors.age(now));
  if (released) motors.active = false;
  neighbours.touchpad.command.write({.command = motors, .given = now, .released = released});
  (void)neighbours.touchpad.duties.push(motors.vibration_duty_percent);  // full only while the device is silent
  if (neighbours.link != nullptr) {
    neighbours.link->announcement.write({.touch = outputs.touch,
                                         .taken = now,
                                         .k_vib = pipeline_.parameters().texture.k_vib,
                                         .motors = outputs.motors});
  }
  if (neighbours.stage != nullptr) neighbours.stage->show(*pipeline_.scene());
  if (!telemetry.push(outputs.telemetry)) telemetry_lost_.fetch_add(1, std::memory_order_relaxed);
  for (const pipeline::Event& event : outputs.events) {
    if (event.kind == pipeline::EventKind::tare_done) {  // who hears of it finds its values
      tare_.write(outputs.tare);
      tares_.fetch_add(1, std::memory_order_release);
    }
    const bool state = event.kind == pipeline::EventKind::state_changed;
    (void)events.push({.when = now, .event = event, .lateness = state ? lateness_.lastSecond() : Lateness{}});
  }
  neighbours.recorder.push({.inputs = inputs_, .outputs = outputs});
  faults_.store(static_cast<std::uint32_t>(outputs.faults.to_ulong()), std::memory_order_relaxed);
}

}  // namespace fyd::station
