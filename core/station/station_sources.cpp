#include "core/station/station_sources.h"

#include "core/base/whole_file.h"
#include "core/device/camera/camera_source.h"
#include "core/device/touchpad/modbus_link.h"
#include "core/device/touchpad/touchpad_source.h"
#include "core/replay/recorded_camera.h"
#include "core/replay/recorded_touchpad.h"
#include "core/scene/felt_scene.h"
#include "core/sim/gesture_card.h"
#include "core/sim/resources.h"
#include "core/sim/scene_file.h"
#include "core/sim/touchpad/simulated_camera.h"
#include "core/sim/touchpad/simulated_touchpad.h"
#include "core/station/profile/touchpad_name.h"
#include "core/station/robot_choice.h"

namespace fyd::station {
namespace {

Result<std::optional<texture::SurfaceModel>> readSurface(const std::string& given) {
  if (given.empty()) return std::nullopt;
  const std::string path = sim::findResource(given, "textures");
  const auto text = readWholeFile(path);
  if (!text) return tl::unexpected(text.error());
  auto model = texture::parseSurface(*text, path);
  if (!model) return tl::unexpected(model.error());
  return std::move(*model);
}

/// The touchpad's word, and those that depend on it.
Result<void> checkTouchpadWords(const StationOptions& options) {
  if (options.touchpad.empty() || options.touchpad == kSimulated) return {};
  const bool recorded = replay::recordingOf(options.touchpad).has_value();
  if (!recorded) {  // before a camera is missing
    if (auto named = device::checkTouchpadSource(options.touchpad); !named) return named;
    if (options.camera.empty()) return fail("camera: none given; only the simulated touchpad has a simulated camera");
  }
  if (!options.finger_csv.empty()) {
    return fail("finger '{}': only the simulated touchpad has a simulated finger", options.finger_csv);
  }
  if (recorded && !options.motors.empty()) return fail("motors '{}': a recording drives no motors", options.motors);
  return {};
}

/// Those of the robot, and of the scene beside it.
Result<void> checkRobotWords(const StationOptions& options) {
  if (options.robot.empty()) return {};
  const auto choice = parseRobotChoice(options.robot, options.key_file);
  if (!choice) return tl::unexpected(choice.error());
  if (!options.scene.empty() && !choice->scene.empty()) {
    return fail("scene '{}': the robot is a scene already, '{}'", options.scene, choice->scene);
  }
  return {};
}

}  // namespace

Result<void> checkWords(const StationOptions& options) {
  if (auto good = checkTouchpadWords(options); !good) return good;
  if (!options.motors.empty()) {
    if (auto good = device::checkMotorsName(options.motors); !good) return good;
  }
  if (auto good = checkRobotWords(options); !good) return good;
  if (options.record) return recording::checkSubject(options.record->subject);
  return {};
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

std::string touchpadOf(const StationOptions& asked) {
  const StationOptions options = withProfileSources(asked);
  if (options.touchpad == kSimulatedTouchpad) return touchpadName(kSimulatedTouchpad, options.motors);
  if (replay::recordingOf(options.touchpad)) return std::string(kPlayedTouchpad);
  const auto serial = device::readSerial(options.touchpad, options.profile.device);
  if (!serial) return {};
  const std::string where = options.touchpad.substr(0, options.touchpad.find(','));
  return touchpadName(serial->empty() ? where : std::string(kSerialTouchpad) + *serial, options.motors);
}

Result<TouchpadProfile> bindToTouchpad(StationOptions& options) {
  const std::string touchpad = touchpadOf(options);
  TouchpadProfile bound = withDefaultsFor(options.profile, touchpad);
  const std::string& owner = options.profile.calibrated_on;
  if (!options.profile_file.empty() && (owner.empty() || owner != touchpad)) {
    auto loaded = loadProfileFor(options.profile_file, touchpad);
    if (!loaded) return tl::unexpected(loaded.error());
    copyCalibratedValues(loaded->profile, bound.profile);
    bound.notice = loaded->notice;
    bound.set_aside = loaded->set_aside;
  }
  options.profile = bound.profile;
  const std::string serial = serialIn(options.profile.calibrated_on);
  const bool demanded = options.touchpad.find(device::kSerialDemand) != std::string::npos;
  if (!serial.empty() && !demanded) options.touchpad.append(device::kSerialDemand).append(serial);
  return bound;
}

Result<std::unique_ptr<device::Touchpad>> openTouchpad(const StationOptions& options,
                                                       const std::shared_ptr<sim::TouchpadWorld>& world,
                                                       const std::shared_ptr<replay::PlaybackStart>& playback) {
  if (world)
    return device::withMotors(std::make_unique<sim::SimulatedTouchpad>(world), options.motors, options.profile.device);
  if (const auto recording = replay::recordingOf(options.touchpad)) {
    return replay::RecordedTouchpad::open(*recording, playback);
  }
  auto touchpad = device::openTouchpad(options.touchpad, options.profile.device);
  if (!touchpad) return touchpad;
  return device::withMotors(std::move(*touchpad), options.motors, options.profile.device);
}

CameraThread::Opener cameraOpener(const StationOptions& options, const std::shared_ptr<sim::TouchpadWorld>& world,
                                  const std::shared_ptr<replay::PlaybackStart>& playback, bool clock_waits) {
  return [source = options.camera, world, device = options.profile.device, playback,
          clock_waits]() -> Result<std::unique_ptr<device::Camera>> {
    if (source.empty()) return std::make_unique<sim::SimulatedCamera>(world, clock_waits);
    if (const auto recording = replay::recordingOf(source)) return replay::RecordedCamera::open(*recording, playback);
    return device::openCamera(source, device);
  };
}

}  // namespace fyd::station
