#include "core/station/connection_check.h"

#include <memory>

#include "core/device/camera/camera_source.h"
#include "core/device/touchpad/touchpad_source.h"
#include "core/replay/recorded_camera.h"
#include "core/replay/recorded_touchpad.h"
#include "core/sim/scene_file.h"
#include "core/station/robot_choice.h"
#include "core/station/station_sources.h"

namespace fyd::station {
namespace {

using device::Part;

Result<void> askTouchpad(const std::string& source, const device::DeviceParameters& parameters) {
  if (source == kSimulated) return {};
  if (const auto recording = replay::recordingOf(source)) {
    const auto played = replay::RecordedTouchpad::open(*recording, std::make_shared<replay::PlaybackStart>());
    if (!played) return tl::unexpected(played.error());
    return {};
  }
  const auto touchpad = device::openTouchpad(source, parameters);
  if (!touchpad) return tl::unexpected(touchpad.error());
  // A busy machine or line may lose one answer.
  constexpr int kAttempts = 3;
  for (int attempt = 1;; ++attempt) {
    const auto readings = (*touchpad)->exchange({}, Clock::now());
    if (readings) return {};
    if (attempt == kAttempts) return tl::unexpected(readings.error());
  }
}

Result<void> askMotors(const SourceParameters& wanted, bool free, const device::DeviceParameters& parameters) {
  if (wanted.motors.empty()) return {};
  if (replay::recordingOf(wanted.touchpad)) return fail("motors '{}': a recording drives no motors", wanted.motors);
  if (!free) return {};
  const auto board = device::openMotorBoard(wanted.motors, parameters);
  if (!board) return tl::unexpected(board.error());
  if (const auto feedback = (*board)->exchange({}); !feedback) return tl::unexpected(feedback.error());
  return {};
}

Result<void> askCamera(const SourceParameters& wanted, const device::DeviceParameters& parameters) {
  if (wanted.camera.empty()) {
    if (wanted.touchpad == kSimulated || replay::recordingOf(wanted.touchpad)) return {};
    if (!device::openTouchpad(wanted.touchpad, parameters)) return {};  // no touchpad's name: that is what is wrong
    return fail("camera: none given; only the simulated touchpad has a simulated camera");
  }
  if (const auto recording = replay::recordingOf(wanted.camera)) {
    const auto played = replay::RecordedCamera::open(*recording, std::make_shared<replay::PlaybackStart>());
    if (!played) return tl::unexpected(played.error());
    return {};
  }
  const auto camera = device::openCamera(wanted.camera, parameters);
  if (!camera) return tl::unexpected(camera.error());
  if (const auto frame = (*camera)->next(); !frame) return tl::unexpected(frame.error());
  return {};
}

Result<void> askRobot(const SourceParameters& wanted) {
  const auto choice = readRobotChoice(wanted.robot, wanted.key_file);
  if (!choice) return tl::unexpected(choice.error());
  if (choice->scene.empty()) return {};
  if (const auto scene = sim::openScene(choice->scene); !scene) return tl::unexpected(scene.error());
  return {};
}

}  // namespace

std::vector<ConnectionProblem> checkConnection(const SourceParameters& wanted, const SourceParameters& in_use,
                                               const device::DeviceParameters& parameters) {
  std::vector<ConnectionProblem> problems;
  const auto look = [&](Part part, const Result<void>& answer) {
    if (!answer) problems.push_back({.part = part, .message = answer.error().message});
  };
  if (wanted.touchpad != in_use.touchpad) look(Part::touchpad, askTouchpad(wanted.touchpad, parameters));
  look(Part::motor_board, askMotors(wanted, wanted.motors != in_use.motors, parameters));
  if (wanted.camera.empty() || wanted.camera != in_use.camera) look(Part::camera, askCamera(wanted, parameters));
  if (wanted.robot != in_use.robot || wanted.key_file != in_use.key_file) look(Part::robot, askRobot(wanted));
  return problems;
}

}  // namespace fyd::station
