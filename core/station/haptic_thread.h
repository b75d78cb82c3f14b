// The haptic thread: 1 kHz. Each cycle reads what the other threads provide, runs the step, and hands its outputs to
// motors, link, recorder, scene and window.
#pragma once

#include <atomic>
#include <thread>
#include <vector>

#include "core/base/latest_value.h"
#include "core/base/ring.h"
#include "core/pipeline/pipeline.h"
#include "core/recording/writer/recorder.h"
#include "core/scene/scene_stage.h"
#include "core/station/camera_thread.h"
#include "core/station/device_test.h"
#include "core/station/haptic_loop.h"
#include "core/station/lateness.h"
#include "core/station/link_thread.h"
#include "core/station/motor_release.h"
#include "core/station/touchpad_thread.h"
#include "core/station/window_watch.h"

namespace fyd::station {

struct TimedEvent {
  Instant when{};
  pipeline::Event event;
  Lateness lateness;  ///< of a change of state
};

class HapticThread {
 public:
  /// What a cycle reads from and writes to; outlives the thread.
  struct Neighbours {
    TouchpadThread& touchpad;
    CameraThread& camera;
    LinkThread* link = nullptr;          ///< none without a robot
    scene::SceneStage* stage = nullptr;  ///< none without a scene in this process
    recording::Recorder& recorder;
    bool waits = false;  ///< everything is simulated: the clock waits for this thread, and a late window is no fault
  };

  /// @param parameters the profile's, by whose indices changes are asked for
  HapticThread(const pipeline::Parameters& step, const pipeline::LocalModel& local,
               std::span<const Parameter> parameters);
  ~HapticThread() { shutDown(); }
  void start(const Neighbours& neighbours);
  void shutDown();

  Ring<pipeline::OperatorCommand> commands{64};  ///< written by the operator's thread
  Ring<pipeline::ParameterChange> changes{256};  ///< written by the operator's thread
  Ring<pipeline::TelemetrySample> telemetry{kTelemetryCapacity};
  Ring<TimedEvent> events{1024};
  WindowWatch window;
  DeviceTestRunner device_test;

  /// Takes effect in the next step, ahead of everything queued; from any thread.
  void requestStop() { stop_requested_.store(true, std::memory_order_release); }
  [[nodiscard]] std::uint64_t telemetryLost() const { return telemetry_lost_.load(std::memory_order_relaxed); }
  /// Everything that is missing for Active.
  [[nodiscard]] pipeline::FaultSet faults() const { return {faults_.load(std::memory_order_relaxed)}; }
  /// The newest tare since the start, for one reader; null before the first.
  [[nodiscard]] const pipeline::TareValues* tare() const;
  [[nodiscard]] LoopStatus status() const;

 private:
  static constexpr std::size_t kTelemetryCapacity = 30'000;  // 30 s, for a window that reads late

  void cycle(const Neighbours& neighbours, Instant now, std::uint64_t missed_cycles);
  void takeDevices(const Neighbours& neighbours);
  void takeLink(LinkThread* link);
  void takeOperator();
  void fitInputDelay(LinkThread* link);
  void publish(const Neighbours& neighbours, const pipeline::Outputs& outputs);

  // its thread's
  pipeline::Pipeline pipeline_;
  pipeline::Inputs inputs_;
  SeenPhase link_phase_;
  MotorRelease release_;
  const std::uint16_t input_delay_index_;
  const double longest_input_delay_ms_;

  HapticLoop loop_;
  bool waits_ = false;
  Duration waited_before_{};  // by the clock, before the session began
  StepTimes step_times_;
  LatenessMeter lateness_;
  std::atomic<bool> stop_requested_{false};
  std::atomic<std::uint64_t> telemetry_lost_{0};
  std::atomic<std::uint32_t> faults_{0};
  mutable LatestValue<pipeline::TareValues> tare_;
  std::atomic<std::uint64_t> tares_{0};
  std::jthread thread_;
};

}  // namespace fyd::station
