// The haptic loop's side of the station: what each cycle takes from the other threads and hands back.
#include <opencv2/imgcodecs.hpp>

#include "core/sim/picture.h"
#include "core/station/station_impl.h"

namespace fyd::station {

void Station::Impl::takeLink() {
  inputs.robot.accelerations.clear();
  inputs.robot.commands.clear();
  if (!link) return;
  const LinkSnapshot& snapshot = link->snapshot.read();
  inputs.robot.phase = snapshot.losses == losses_seen ? snapshot.phase : pipeline::LinkPhase::lost;
  losses_seen = snapshot.losses;
  inputs.robot.state = snapshot.state;
  inputs.robot.motor_reference = snapshot.motor_reference;
  pipeline::AccelerationSample sample;
  while (!inputs.robot.accelerations.full() && link->accelerations.pop(sample)) {
    (void)inputs.robot.accelerations.push(sample);
  }
  pipeline::RobotCommand command{};
  while (!inputs.robot.commands.full() && link->commands.pop(command)) (void)inputs.robot.commands.push(command);
}

void Station::Impl::takeOperator() {
  inputs.commands.clear();
  inputs.changes.clear();
  if (stop_requested.exchange(false, std::memory_order_acq_rel)) {
    (void)inputs.commands.push({.action = pipeline::OperatorAction::stop});
  }
  if (window.fellSilent(inputs.now)) {
    (void)inputs.commands.push({.action = pipeline::OperatorAction::fell_silent});
  }
  pipeline::OperatorCommand command;
  while (!inputs.commands.full() && commands.pop(command)) (void)inputs.commands.push(command);
  pipeline::ParameterChange change;
  while (!inputs.changes.full() && changes.pop(change)) (void)inputs.changes.push(change);
}

// Batches of accelerations need the texture to wait for them; a change of a parameter, so that a replay knows of it.
void Station::Impl::fitInputDelay() {
  if (!link || input_delay == nullptr || inputs.changes.full()) return;
  const double needed_ms = std::min(link->snapshot.read().sample_delay_ms, input_delay->info.maximum);
  if (needed_ms <= pipeline.parameters().texture.input_delay_ms) return;
  (void)inputs.changes.push({.index = static_cast<std::uint16_t>(input_delay - bound.data()), .value = needed_ms});
}

void Station::Impl::cycle(Instant now, std::uint64_t missed_cycles) {
  inputs.now = now;
  inputs.missed_cycles = missed_cycles;
  inputs.finger = camera.finger.read();
  const device::TouchpadReadings& readings = touchpad.readings.read();
  inputs.ir = readings.ir;
  inputs.bridge = readings.bridge;
  inputs.motors = readings.motors;
  takeLink();
  takeOperator();
  fitInputDelay();

  const Instant before = Clock::now();
  const pipeline::Outputs& outputs = pipeline.step(inputs);
  step_times.add(Clock::now() - before);

  const auto tested = device_test.step(inputs, outputs, pipeline.parameters().control);
  const control::MotorCommand& motors = tested ? *tested : outputs.motors;
  touchpad.command.write({.command = motors, .given = now});
  (void)touchpad.duties.push(motors.vibration_duty_percent);  // full only while the device is silent
  if (link) {
    link->announcement.write(
        {.touch = outputs.touch, .taken = now, .k_vib = pipeline.parameters().texture.k_vib, .motors = outputs.motors});
  }
  if (stage) stage->show(*pipeline.scene());
  if (!telemetry.push(outputs.telemetry)) telemetry_lost.fetch_add(1, std::memory_order_relaxed);
  for (const pipeline::Event& event : outputs.events) {
    (void)events.push({.when = now, .event = event});
    if (event.kind != pipeline::EventKind::tare_done) continue;
    tare.write(outputs.tare);
    tares.fetch_add(1, std::memory_order_release);
  }
  recorder.push({.inputs = inputs, .outputs = outputs});
  lacks.store(static_cast<std::uint32_t>(outputs.lacks.to_ulong()), std::memory_order_relaxed);
}

void Station::Impl::onPicture(const CameraView& view) {
  recorder.offerPicture(view.picture, view.region, view.finger, view.taken, view.number);
  if (link && link->wantsImages()) {
    std::vector<std::uint8_t> encoded;
    cv::imencode(".jpg", view.picture, encoded);
    link->offerImage(std::move(encoded));
  }
  if (!world || !simulated_camera || !view.finger.contact) return;
  const sim::WorldSnapshot truth = world->truthAt(view.taken);
  if (truth.finger.lifted) return;
  const sim::Spot spot = sim::seenSpot(truth, world->parameters());
  const double dx = view.finger.x_mm - spot.x_mm;
  const double dy = view.finger.y_mm - spot.y_mm;
  const std::lock_guard lock(truth_mutex);
  finger_error.add(dx * dx + dy * dy);
}

void Station::Impl::compareWithTruth(const pipeline::TelemetrySample& sample) {
  if (!world || !sample.contact) return;
  const sim::WorldSnapshot truth = world->truthAt(sample.now);
  if (truth.finger.lifted) return;
  const double error = sample.indentation_mm - truth.finger.indentation_mm;
  const std::lock_guard lock(truth_mutex);
  if (std::isfinite(error)) indentation_error.add(error * error);
  if (sample.state == pipeline::SafetyState::active) felt_g.add(truth.felt_g * truth.felt_g);
}

}  // namespace fyd::station
