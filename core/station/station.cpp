#include "core/station/station.h"

#include <spdlog/spdlog.h>

#include <mutex>

#include <opencv2/core/utility.hpp>

#include "core/base/codecs/codecs.h"
#include "core/base/profile_text.h"
#include "core/device/camera/capture_camera.h"
#include "core/device/stable_name.h"
#include "core/device/touchpad/reading_values.h"
#include "core/scene/scene_stage.h"
#include "core/station/haptic_thread.h"
#include "core/station/in_process_robot.h"
#include "core/station/notice.h"
#include "core/station/profile/touchpad_name.h"
#include "core/station/readiness.h"
#include "core/station/robot_choice.h"
#include "core/station/station_sources.h"

namespace fyd::station {
namespace {

/// Whether nothing outside this process takes part, so that the session's clock may wait for a late computer.
bool clockWaits(const StationOptions& options, const RobotChoice& robot) {
  const bool other_end = robot.listen && !robot.in_process;
  return !options.real_time && options.touchpad == kSimulated && options.motors.empty() && options.camera.empty() &&
         !other_end;
}

recording::StationDescription describeForRecording(const StationOptions& options, bool clock_waits) {
  return {.touchpad = options.touchpad + (options.motors.empty() ? "" : " with " + options.motors),
          .camera = options.camera.empty() ? std::string(kSimulated) : device::withoutSecrets(options.camera),
          .robot = options.robot,
          .lateness = clock_waits ? recording::kLatenessWaits : recording::kLatenessFault};
}

}  // namespace

struct Station::Impl {
  Impl(const StationOptions& options, const pipeline::LocalModel& local, std::shared_ptr<sim::TouchpadWorld> simulated,
       std::unique_ptr<device::Touchpad> opened_touchpad, const std::shared_ptr<replay::PlaybackStart>& playback,
       bool everything_simulated)
      : profile(options.profile),
        bound(bindParameters(profile)),
        motors(options.motors),
        haptic(options.profile.step, local, bound),
        recorder(options.profile.session, options.profile.step, local,
                 describeForRecording(options, everything_simulated), recorderSource()),
        world(std::move(simulated)),
        errors(world, options.camera.empty()),
        simulated_camera(options.camera.empty()),
        clock_waits(everything_simulated),
        touchpad(std::move(opened_touchpad), options.profile.device, everything_simulated),
        camera(options.camera.empty() ? say("simulated camera") : verbatim(device::withoutSecrets(options.camera)),
               cameraOpener(options, world, playback, everything_simulated), options.profile.step.sensing.finger,
               options.profile.device) {
    camera.observe([this](const CameraView& view) { onPicture(view); });
  }

  void onPicture(const CameraView& view);
  /// Of a real one, by the serial number that it has told; empty: none yet.
  [[nodiscard]] std::string nameOfTouchpad() const;
  /// What the recorder's thread asks for when a recording begins, and of the link once a second.
  [[nodiscard]] recording::StationSource recorderSource();

  std::mutex profile_mutex;      // of writing to it, and of reading it on another thread than the operator's
  Profile profile;               // with every change asked for; only the operator's thread writes
  std::vector<Parameter> bound;  // to it
  const std::string motors;      // as in the options
  Message notice;                // of whose calibrated values the profile has; said once
  bool values_set_aside = false;

  HapticThread haptic;
  recording::Recorder recorder;
  std::shared_ptr<sim::TouchpadWorld> world;  // none with a real touchpad
  SimulationErrors errors;
  bool simulated_camera;
  bool clock_waits;  // everything is simulated: for a late computer
  TouchpadThread touchpad;
  CameraThread camera;
  std::unique_ptr<LinkThread> link;  // none without a robot
  std::unique_ptr<InProcessRobot> robot;
  std::string predictor;                     // of that one
  std::shared_ptr<scene::SceneStage> stage;  // none without a scene in this process
};

void Station::Impl::onPicture(const CameraView& view) {
  recorder.offerPicture(view.picture, view.region, view.finger, view.taken, view.number);
  if (link && link->wantsImages()) {
    std::vector<std::uint8_t> encoded;
    codecs::encodePicture(".jpg", view.picture, encoded);
    link->offerImage(std::move(encoded));
  }
  errors.addPicture(view);
}

std::string Station::Impl::nameOfTouchpad() const {
  for (const device::DeviceReport& report : touchpad.reports(Clock::now())) {
    const std::string serial = device::serialIn(report);
    if (!serial.empty()) return touchpadName(std::string(kSerialTouchpad) + serial, motors);
  }
  return {};
}

recording::StationSource Station::Impl::recorderSource() {
  return {.profile =
              [this](const pipeline::Parameters& step) {
                Profile recorded = [this] {
                  const std::lock_guard lock(profile_mutex);
                  return profile;
                }();
                recorded.step = step;
                recorded.sources.camera = device::withoutSecrets(recorded.sources.camera);
                return formatProfile(bindParameters(recorded));
              },
          .link = [this]() -> std::optional<recording::LinkRow> {
            if (!link) return std::nullopt;
            const LinkStatus status = link->status();
            return recording::LinkRow{.when = Clock::now(),
                                      .round_trip_ms = status.figures.round_trip_ms,
                                      .jitter_ms = status.figures.jitter_ms,
                                      .loss_percent = status.figures.loss_percent,
                                      .states_received = status.states_received,
                                      .touches_sent = status.touches_sent,
                                      .refused = status.refused};
          }};
}

Station::Station(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Station::~Station() { shutDown(); }

Result<std::unique_ptr<Station>> Station::open(const StationOptions& asked) {
  device::prepareCaptures();
  StationOptions options = withProfileSources(asked);
  if (options.camera.empty() && replay::recordingOf(options.touchpad)) options.camera = options.touchpad;
  if (auto words = checkWords(options); !words) return tl::unexpected(words.error());
  const auto bound = bindToTouchpad(options);
  if (!bound) return tl::unexpected(bound.error());
  if (const auto loaded = codecs::load(); !loaded) return tl::unexpected(loaded.error());  // not in the camera's thread
  cv::setNumThreads(1);  // replay must not depend on how many cores there are
  auto finger = readFinger(options.finger_csv);
  if (!finger) return tl::unexpected(finger.error());
  auto checked = control::checkControlParameters(options.profile.step.control);
  if (!checked) return tl::unexpected(checked.error());
  const auto choice = readRobotChoice(options.robot, options.key_file);
  if (!choice) return tl::unexpected(choice.error());
  auto local =
      readLocalModel(options.surface, options.scene + choice->scene, options.profile.step.texture.sample_rate_Hz);
  if (!local) return tl::unexpected(local.error());

  std::shared_ptr<sim::TouchpadWorld> world;
  if (options.touchpad == kSimulated) {
    world = std::make_shared<sim::TouchpadWorld>(options.profile.sim, std::move(*finger), Clock::now());
  }
  const auto playback = std::make_shared<replay::PlaybackStart>();
  auto touchpad = openTouchpad(options, world, playback);
  if (!touchpad) return tl::unexpected(touchpad.error());

  auto impl = std::make_unique<Impl>(options, *local, std::move(world), std::move(*touchpad), playback,
                                     clockWaits(options, *choice));
  if (choice->listen) {
    auto link = LinkThread::open(*choice->listen, options.profile.link, choice->key,
                                 local->scene ? local->scene->digest() : std::string{});
    if (!link) return tl::unexpected(link.error());
    impl->link = std::move(*link);
  } else if (!local->scene) {
    (void)impl->haptic.commands.push(
        {.action = pipeline::OperatorAction::target_by_hand, .value = options.profile.step.step.hand_target_N_per_mm});
  }
  if (choice->in_process) {
    auto robot = InProcessRobot::open(impl->link->local(), options.profile.sim, choice->predictor, impl->clock_waits);
    if (!robot) return tl::unexpected(robot.error());
    impl->robot = std::move(*robot);
    impl->predictor = choice->predictor;
  }
  impl->notice = bound->notice;
  impl->values_set_aside = bound->set_aside;
  if (local->scene) impl->stage = std::make_shared<scene::SceneStage>(local->scene->loaded());
  impl->recorder.start();
  if (options.record) {
    if (auto begun = impl->recorder.begin(*options.record); !begun) {
      impl->recorder.shutDown();  // before what it asks: a slow disk's answer may still come
      return tl::unexpected(begun.error());
    }
  }
  return std::unique_ptr<Station>(new Station(std::move(impl)));
}

void Station::start() {
  impl_->touchpad.start();
  impl_->camera.start();
  if (impl_->link) impl_->link->start(impl_->clock_waits);
  if (impl_->robot) impl_->robot->start();
  impl_->haptic.start({.touchpad = impl_->touchpad,
                       .camera = impl_->camera,
                       .link = impl_->link.get(),
                       .stage = impl_->stage.get(),
                       .recorder = impl_->recorder,
                       .waits = impl_->clock_waits});
}

void Station::shutDown() {
  requestStop();  // the motors first: the robot may brake for seconds
  if (impl_->robot) impl_->robot->shutDown();
  impl_->haptic.shutDown();
  impl_->touchpad.shutDown();
  impl_->camera.shutDown();
  if (impl_->link) impl_->link->shutDown();
  impl_->recorder.shutDown();
}

bool Station::command(const pipeline::OperatorCommand& command) { return impl_->haptic.commands.push(command); }

void Station::windowAlive() { impl_->haptic.window.alive(Clock::now()); }

void Station::requestStop() { impl_->haptic.requestStop(); }

Result<void> Station::setParameter(std::string_view id, double value) {
  const Parameter* parameter = findParameter(impl_->bound, id);
  if (parameter == nullptr) return fail("unknown parameter '{}'", id);
  if (!parameter->info.live) return fail("{} cannot change while the station runs", id);
  const auto checked = checkParameter(*parameter, value);
  if (!checked) return tl::unexpected(checked.error());
  const auto index = static_cast<std::uint16_t>(parameter - impl_->bound.data());
  if (!impl_->haptic.changes.push({.index = index, .value = *checked})) return fail("{}: too many changes at once", id);
  {
    const std::lock_guard lock(impl_->profile_mutex);
    parameter->set(*checked);
  }
  if (id.starts_with("sensing.finger_")) impl_->camera.configure(impl_->profile.step.sensing.finger);
  return {};
}

Profile Station::currentProfile() const {
  Profile profile = impl_->profile;
  if (const pipeline::TareValues* tare = impl_->haptic.tare()) {
    profile.step.sensing.indentation.ir_offset_mm = tare->ir_offset_mm;
    profile.step.sensing.load_cell.zero_N = tare->force_zero_N;
  }
  if (profile.calibrated_on.empty()) profile.calibrated_on = impl_->nameOfTouchpad();
  return profile;
}

std::size_t Station::takeTelemetry(std::span<pipeline::TelemetrySample> out) {
  const std::size_t taken = impl_->haptic.telemetry.pop(out.data(), out.size());
  for (const pipeline::TelemetrySample& sample : out.first(taken)) impl_->errors.addSample(sample);
  return taken;
}

std::uint64_t Station::telemetryLost() const { return impl_->haptic.telemetryLost(); }

std::vector<Notice> Station::takeNotices() {
  std::vector<Notice> out;
  if (!impl_->notice.empty()) {
    out.push_back({.when = Clock::now(), .event = {}, .message = std::exchange(impl_->notice, {}), .of_step = false});
  }
  TimedEvent event;
  while (impl_->haptic.events.pop(event)) {
    out.push_back({.when = event.when,
                   .event = event.event,
                   .message = describeEvent(event.event, impl_->bound, event.lateness),
                   .lateness = blameOf(event.event, event.lateness)});
    // What the robot's operator changed belongs to the profile as well; what this session's network needs does not.
    if (event.event.kind == pipeline::EventKind::parameter_changed && event.event.index < impl_->bound.size()) {
      const Parameter& changed = impl_->bound[event.event.index];
      const std::lock_guard lock(impl_->profile_mutex);
      if (changed.id != kInputDelay) changed.set(event.event.value);
    }
  }
  return out;
}

CameraView Station::cameraView() const { return impl_->camera.view(); }

StationStatus Station::status() const {
  const Instant now = Clock::now();
  StationStatus out;
  out.parts = {impl_->touchpad.status(now), impl_->camera.status(now)};
  out.parts[0].simulated = simulated();
  out.parts[1].simulated = impl_->simulated_camera;
  if (impl_->link) {
    out.parts.push_back(impl_->link->part(now));
    out.parts[2].simulated = impl_->robot != nullptr;
    out.link = impl_->link->status();
    if (impl_->robot) {
      const device::RobotRunnerStatus robot = impl_->robot->status();
      out.link.led = PredictedArm{.predictor = impl_->predictor,
                                  .arrived_mm = robot.arrived_mm,
                                  .target_mm = robot.target_mm,
                                  .error_mm = robot.reference.error_mm,
                                  .horizon_ms = robot.reference.horizon_ms};
    }
  } else if (impl_->stage) {
    out.link.protocol = say("scene {}", impl_->stage->scene().description.settings.name);
  } else {
    out.link.protocol = say("none");
  }
  out.loop = impl_->haptic.status();
  return out;
}

SimulationTruth Station::simulationTruth() const { return impl_->errors.truth(); }

void Station::moveSimulatedFinger(double x_mm, double y_mm, double indentation_mm) {
  if (!impl_->world) return;
  impl_->world->setFingerOverride(
      sim::FingerState{.x_mm = x_mm, .y_mm = y_mm, .indentation_mm = indentation_mm, .lifted = indentation_mm <= 0.0});
}

void Station::playSimulatedFinger(const sim::FingerPath& path) {
  if (impl_->world) impl_->world->setPath(path);
}

void Station::releaseSimulatedFinger() {
  if (impl_->world) impl_->world->setFingerOverride(std::nullopt);
}

bool Station::simulated() const { return impl_->world != nullptr; }

std::shared_ptr<scene::SceneStage> Station::scene() const { return impl_->stage; }

std::vector<device::DeviceReport> Station::devices() const {
  const Instant now = Clock::now();
  std::vector<device::DeviceReport> out = impl_->touchpad.reports(now);
  out.push_back(impl_->camera.report(now));
  return out;
}

Result<void> Station::startDeviceTest(device::DeviceTest test, double stretch_deg) {
  auto started = impl_->haptic.device_test.start(test, Clock::now(), stretch_deg);
  if (started) spdlog::info("Device test '{}' started", device::kDeviceTestNames[static_cast<std::size_t>(test)]);
  return started;
}

void Station::keepDeviceTest() { impl_->haptic.device_test.keep(Clock::now()); }

void Station::stopDeviceTest() { impl_->haptic.device_test.stop(); }

DeviceTestStatus Station::deviceTestStatus() const { return impl_->haptic.device_test.status(); }

std::vector<texture::SweepRow> Station::deviceTestSweep() { return impl_->haptic.device_test.sweep(); }

Result<void> Station::startRecording(const recording::RecordingRequest& request) {
  return impl_->recorder.begin(request);
}

Result<void> Station::stopRecording() { return impl_->recorder.end(); }

Result<void> Station::note(recording::NoteKind kind, const std::string& text) {
  return impl_->recorder.note(kind, text);
}

recording::RecorderStatus Station::recorderStatus() const { return impl_->recorder.status(); }

std::vector<ReadinessLine> Station::readiness() const {
  std::vector<ReadinessLine> lines = readinessOf(impl_->haptic.faults(), impl_->link != nullptr);
  if (impl_->values_set_aside) {
    lines.push_back({.what = say("Calibrated on this touchpad"),
                     .ok = false,
                     .why = say("the profile's values are another touchpad's: the defaults are used"),
                     .remedy = say("Calibrate this one under Calibrate. It does not keep you from arming.")});
  }
  return lines;
}

}  // namespace fyd::station
