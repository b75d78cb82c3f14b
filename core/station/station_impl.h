// What a Station holds: its parts, and what travels between the operator's thread and the haptic loop.
// Read by station.cpp (opening, the operator's side) and station_loop.cpp (the haptic loop's side) only.
#pragma once

#include <cmath>

#include "core/base/latest_value.h"
#include "core/base/ring.h"
#include "core/pipeline/pipeline.h"
#include "core/scene/scene_stage.h"
#include "core/session/recorded_device.h"
#include "core/sim/touchpad_world.h"
#include "core/station/camera_thread.h"
#include "core/station/haptic_loop.h"
#include "core/station/in_process_robot.h"
#include "core/station/link_thread.h"
#include "core/station/station.h"
#include "core/station/touchpad_thread.h"
#include "core/station/window_watch.h"

namespace fyd::station {

inline constexpr std::size_t kTelemetryCapacity = 30'000;  // 30 s for a window that is busy

struct TimedEvent {
  Instant when{};
  pipeline::Event event;
};

/// Sum of squares of an error, as it grows.
struct ErrorSum {
  double squares = 0.0;
  std::uint64_t count = 0;
  void add(double squared) {
    squares += squared;
    ++count;
  }
  [[nodiscard]] double rms() const {
    return count == 0 ? pipeline::kNone : std::sqrt(squares / static_cast<double>(count));
  }
};

struct Station::Impl {
  Impl(const StationOptions& options, const pipeline::LocalModel& local,
       std::shared_ptr<sim::TouchpadWorld> simulated_world, std::unique_ptr<device::Touchpad> opened_touchpad,
       const std::shared_ptr<session::PlaybackStart>& playback);

  void cycle(Instant now, std::uint64_t missed_cycles);
  void takeLink();
  void takeOperator();
  void fitInputDelay();
  void onPicture(const CameraView& view);
  void compareWithTruth(const pipeline::TelemetrySample& sample);
  /// What the recorder asks for while the operator's thread waits for it, and of the link once a second.
  [[nodiscard]] session::StationSource recorderSource();

  // the operator's thread
  Profile profile;  // with every change asked for
  std::vector<Parameter> bound;
  const Parameter* input_delay = findParameter(bound, "texture.input_delay_ms");

  // the haptic loop's
  pipeline::Pipeline pipeline;
  pipeline::Inputs inputs;
  std::uint64_t losses_seen = 0;
  HapticLoop loop;
  StepTimes step_times;
  DeviceTestRunner device_test;
  session::Recorder recorder;
  std::jthread loop_thread;

  // parts
  std::shared_ptr<sim::TouchpadWorld> world;  // none with a real touchpad
  TouchpadThread touchpad;
  CameraThread camera;
  std::unique_ptr<LinkThread> link;  // none without a robot
  std::unique_ptr<InProcessRobot> robot;
  std::shared_ptr<scene::SceneStage> stage;  // none without a scene in this process
  std::string predictor;                     // of that one
  bool simulated_camera;

  // between threads
  Ring<pipeline::OperatorCommand> commands{64};
  Ring<pipeline::ParameterChange> changes{256};
  std::atomic<bool> stop_requested{false};
  WindowWatch window;
  Ring<pipeline::TelemetrySample> telemetry{kTelemetryCapacity};
  std::atomic<std::uint64_t> telemetry_lost{0};
  Ring<TimedEvent> events{1024};
  std::atomic<std::uint32_t> lacks{0};
  mutable LatestValue<pipeline::TareValues> tare;
  std::atomic<std::uint64_t> tares{0};

  mutable std::mutex truth_mutex;
  ErrorSum finger_error;
  ErrorSum indentation_error;
  ErrorSum felt_g;
};

}  // namespace fyd::station
