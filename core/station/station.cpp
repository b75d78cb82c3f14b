#include "core/station/station.h"

#include <fstream>
#include <iterator>
#include <opencv2/core/utility.hpp>

#include "core/device/camera_source.h"
#include "core/device/touchpad_source.h"
#include "core/scene/felt_scene.h"
#include "core/session/recorded_camera.h"
#include "core/session/recorded_touchpad.h"
#include "core/sim/gesture_card.h"
#include "core/sim/scene_file.h"
#include "core/sim/simulated_camera.h"
#include "core/sim/simulated_touchpad.h"
#include "core/station/notice.h"
#include "core/station/robot_choice.h"
#include "core/station/station_impl.h"

namespace fyd::station {
namespace {

constexpr std::string_view kSimulated = "simulated";

Result<std::optional<texture::SurfaceModel>> readSurface(const std::string& path) {
  if (path.empty()) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  if (!file) return fail("{}: cannot be opened for reading", path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  auto model = texture::parseSurface(text, path);
  if (!model) return tl::unexpected(model.error());
  return std::move(*model);
}

Result<pipeline::LocalModel> readLocalModel(const std::string& surface, const std::string& scene, double rate_Hz) {
  pipeline::LocalModel local;
  auto stored = readSurface(surface);
  if (!stored) return tl::unexpected(stored.error());
  local.surface = std::move(*stored);
  if (scene.empty()) return local;
  auto felt = sim::openFeltScene(scene, rate_Hz);
  if (!felt) return tl::unexpected(felt.error());
  local.scene = std::make_shared<const scene::FeltScene>(std::move(*felt));
  return local;
}

Result<sim::FingerPath> readFinger(const std::string& path) {
  if (path.empty()) return sim::FingerPath::demonstration();
  return sim::readFingerFile(path);
}

Result<std::unique_ptr<device::Touchpad>> makeTouchpad(const StationOptions& options,
                                                       const std::shared_ptr<sim::TouchpadWorld>& world,
                                                       const std::shared_ptr<session::PlaybackStart>& playback) {
  if (world)
    return device::withMotors(std::make_unique<sim::SimulatedTouchpad>(world), options.motors, options.profile.device);
  if (options.camera.empty()) return fail("camera: none given; only the simulated touchpad has a simulated camera");
  if (!options.finger_csv.empty()) {
    return fail("finger '{}': only the simulated touchpad has a simulated finger", options.finger_csv);
  }
  if (const auto recording = session::recordingOf(options.touchpad)) {
    if (options.motors.empty()) return session::RecordedTouchpad::open(*recording, playback);
    return fail("motors '{}': a recording drives no motors", options.motors);
  }
  auto touchpad = device::openTouchpad(options.touchpad, options.profile.device);
  if (!touchpad) return touchpad;
  return device::withMotors(std::move(*touchpad), options.motors, options.profile.device);
}

session::StationDescription describeForRecording(const StationOptions& options) {
  return {.touchpad = options.touchpad + (options.motors.empty() ? "" : " with " + options.motors),
          .camera = options.camera.empty() ? std::string(kSimulated) : options.camera,
          .robot = options.robot};
}

}  // namespace

StationOptions withProfileSources(StationOptions options) {
  const SourceParameters& sources = options.profile.sources;
  if (options.touchpad.empty()) {
    options.touchpad = sources.touchpad;
    if (options.motors.empty()) options.motors = sources.motors;
    if (options.camera.empty()) options.camera = sources.camera;
  }
  if (options.robot.empty()) {
    options.robot = sources.robot;
    if (options.key_file.empty()) options.key_file = sources.key_file;
  }
  return options;
}

Station::Impl::Impl(const StationOptions& options, const pipeline::LocalModel& local,
                    std::shared_ptr<sim::TouchpadWorld> simulated_world,
                    std::unique_ptr<device::Touchpad> opened_touchpad,
                    const std::shared_ptr<session::PlaybackStart>& playback)
    : profile(options.profile),
      bound(bindParameters(profile)),
      pipeline(options.profile.step, local),
      recorder(options.profile.session, options.profile.step, local, describeForRecording(options), recorderSource()),
      world(std::move(simulated_world)),
      touchpad(std::move(opened_touchpad), options.profile.device),
      camera(
          options.camera.empty() ? say("simulated camera") : verbatim(options.camera),
          [source = options.camera, shared = world, device = options.profile.device,
           playback]() -> Result<std::unique_ptr<device::Camera>> {
            if (source.empty()) return std::make_unique<sim::SimulatedCamera>(shared);
            if (const auto recording = session::recordingOf(source)) {
              return session::RecordedCamera::open(*recording, playback);
            }
            return device::openCamera(source, device);
          },
          options.profile.step.sensing.finger, options.profile.device),
      simulated_camera(options.camera.empty()) {
  camera.observe([this](const CameraView& view) { onPicture(view); });
}

Station::Station(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Station::~Station() { shutDown(); }

Result<std::unique_ptr<Station>> Station::open(const StationOptions& asked) {
  StationOptions options = withProfileSources(asked);
  if (options.camera.empty() && session::recordingOf(options.touchpad)) options.camera = options.touchpad;
  cv::setNumThreads(1);  // replay must not depend on how many cores there are
  auto finger = readFinger(options.finger_csv);
  if (!finger) return tl::unexpected(finger.error());
  auto checked = control::checkControlParameters(options.profile.step.control);
  if (!checked) return tl::unexpected(checked.error());
  const auto choice = readRobotChoice(options.robot, options.key_file);
  if (!choice) return tl::unexpected(choice.error());
  if (!options.scene.empty() && !choice->scene.empty()) {
    return fail("scene '{}': the robot is a scene already, '{}'", options.scene, choice->scene);
  }
  auto local =
      readLocalModel(options.surface, options.scene + choice->scene, options.profile.step.texture.sample_rate_Hz);
  if (!local) return tl::unexpected(local.error());

  std::shared_ptr<sim::TouchpadWorld> world;
  if (options.touchpad == kSimulated) {
    world = std::make_shared<sim::TouchpadWorld>(options.profile.sim, std::move(*finger), Clock::now());
  }
  const auto playback = std::make_shared<session::PlaybackStart>();
  auto touchpad = makeTouchpad(options, world, playback);
  if (!touchpad) return tl::unexpected(touchpad.error());

  auto impl = std::make_unique<Impl>(options, *local, std::move(world), std::move(*touchpad), playback);
  if (choice->listen) {
    auto link = LinkThread::open(*choice->listen, options.profile.link, choice->key,
                                 local->scene ? local->scene->digest() : std::string{});
    if (!link) return tl::unexpected(link.error());
    impl->link = std::move(*link);
  } else if (!local->scene) {
    (void)impl->commands.push(
        {.action = pipeline::OperatorAction::target_by_hand, .value = options.profile.step.step.hand_target_N_per_mm});
  }
  if (choice->in_process) {
    auto robot = InProcessRobot::open(impl->link->local(), options.profile.sim, choice->predictor);
    if (!robot) return tl::unexpected(robot.error());
    impl->robot = std::move(*robot);
    impl->predictor = choice->predictor;
  }
  if (local->scene) impl->stage = std::make_shared<scene::SceneStage>(local->scene->loaded());
  impl->recorder.start();
  if (options.record) {
    if (auto begun = impl->recorder.begin(*options.record); !begun) return tl::unexpected(begun.error());
  }
  return std::unique_ptr<Station>(new Station(std::move(impl)));
}

void Station::start() {
  impl_->touchpad.start();
  impl_->camera.start();
  if (impl_->link) impl_->link->start();
  if (impl_->robot) impl_->robot->start();
  impl_->loop_thread = std::jthread([impl = impl_.get()](const std::stop_token& stop) {
    impl->loop.run(stop, [impl](Instant now, std::uint64_t missed_cycles) { impl->cycle(now, missed_cycles); });
  });
}

void Station::shutDown() {
  if (impl_->robot) impl_->robot->shutDown();
  if (impl_->loop_thread.joinable()) {
    impl_->loop_thread.request_stop();
    impl_->loop_thread.join();
  }
  impl_->touchpad.shutDown();
  impl_->camera.shutDown();
  if (impl_->link) impl_->link->shutDown();
  impl_->recorder.shutDown();
}

bool Station::command(const pipeline::OperatorCommand& command) { return impl_->commands.push(command); }

void Station::windowAlive() { impl_->window.alive(Clock::now()); }

void Station::requestStop() { impl_->stop_requested.store(true, std::memory_order_release); }

Result<void> Station::setParameter(std::string_view id, double value) {
  const Parameter* parameter = findParameter(impl_->bound, id);
  if (parameter == nullptr) return fail("unknown parameter '{}'", id);
  if (!parameter->info.live) return fail("{} cannot change while the station runs", id);
  if (auto checked = checkParameter(*parameter, value); !checked) return tl::unexpected(checked.error());
  const auto index = static_cast<std::uint16_t>(parameter - impl_->bound.data());
  if (!impl_->changes.push({.index = index, .value = value})) return fail("{}: too many changes at once", id);
  parameter->set(value);
  if (id.starts_with("sensing.finger_")) impl_->camera.configure(impl_->profile.step.sensing.finger);
  return {};
}

Profile Station::currentProfile() const {
  Profile profile = impl_->profile;
  if (impl_->tares.load(std::memory_order_acquire) > 0) {
    const pipeline::TareValues& tare = impl_->tare.read();
    profile.step.sensing.indentation.ir_offset_mm = tare.ir_offset_mm;
    profile.step.sensing.load_cell.zero_N = tare.force_zero_N;
  }
  return profile;
}

std::size_t Station::takeTelemetry(std::span<pipeline::TelemetrySample> out) {
  const std::size_t taken = impl_->telemetry.pop(out.data(), out.size());
  for (const pipeline::TelemetrySample& sample : out.first(taken)) impl_->compareWithTruth(sample);
  return taken;
}

std::uint64_t Station::telemetryLost() const { return impl_->telemetry_lost.load(std::memory_order_relaxed); }

std::vector<Notice> Station::takeNotices() {
  std::vector<Notice> out;
  TimedEvent event;
  while (impl_->events.pop(event)) {
    out.push_back({.when = event.when, .event = event.event, .message = describeEvent(event.event, impl_->bound)});
    // What the robot's operator changed belongs to the profile as well.
    if (event.event.kind == pipeline::EventKind::parameter_changed && event.event.index < impl_->bound.size()) {
      impl_->bound[event.event.index].set(event.event.value);
    }
  }
  return out;
}

CameraView Station::cameraView() const { return impl_->camera.view(); }

StationStatus Station::status() const {
  const Instant now = Clock::now();
  StationStatus out;
  out.parts = {impl_->touchpad.status(now), impl_->camera.status(now)};
  if (impl_->link) {
    out.parts.push_back(impl_->link->part(now));
    out.link = impl_->link->status();
    if (impl_->robot) {
      const sim::SimulatedRobotStatus robot = impl_->robot->status();
      out.link.led = LedArm{.predictor = impl_->predictor,
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
  const StepTimes::Figures times = impl_->step_times.figures();
  out.loop = {.steps = impl_->loop.cycles(),
              .missed_cycles = impl_->loop.missedCycles(),
              .step_ns_p50 = times.p50_ns,
              .step_ns_p99 = times.p99_ns,
              .real_time = impl_->loop.realTime()};
  return out;
}

SimulationTruth Station::simulationTruth() const {
  const std::lock_guard lock(impl_->truth_mutex);
  return {.available = impl_->world != nullptr,
          .finger_error_mm_rms = impl_->finger_error.rms(),
          .indentation_error_mm_rms = impl_->indentation_error.rms(),
          .felt_g_rms = impl_->felt_g.rms()};
}

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

}  // namespace fyd::station
