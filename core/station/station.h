// The threads around the step: which backends, which robot, supervision.
//
//   device thread  exchanges with the touchpad          ─▶ latest-value slot ─▶ ┐
//   camera thread  takes pictures, detects the finger   ─▶ latest-value slot ─▶ ├─ haptic loop: Pipeline::step, 1 kHz
//   link thread    speaks with the robot, answers it    ─▶ slot and rings    ─▶ ┘    └▶ motor command, touch, telemetry
//
// The window, the headless runner and the tests hold a Station and see this header and what it includes.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/device/device_report.h"
#include "core/pipeline/inputs.h"
#include "core/pipeline/outputs.h"
#include "core/recording/writer/recorder.h"
#include "core/sim/finger_path.h"
#include "core/station/camera_view.h"
#include "core/station/device_test.h"
#include "core/station/haptic_loop.h"
#include "core/station/link_status.h"
#include "core/station/notice.h"
#include "core/station/readiness.h"
#include "core/station/simulation_errors.h"
#include "core/station/station_options.h"

namespace fyd::scene {
class SceneStage;
}

namespace fyd::station {

struct StationStatus {
  std::vector<device::DeviceReport> parts;  ///< touchpad, camera, robot; what they share, without values
  LoopStatus loop;
  LinkStatus link;
};

class Station {
 public:
  /// Opens devices and sockets; threads start with `start`.
  /// @return an error when an option is wrong or a port is taken. A missing camera is no error: it is retried and
  /// shown.
  [[nodiscard]] static Result<std::unique_ptr<Station>> open(const StationOptions& options);

  Station(const Station&) = delete;
  Station& operator=(const Station&) = delete;
  ~Station();  ///< stops the motors and joins the threads

  void start();
  /// Motors off, robot told, threads joined; idempotent.
  void shutDown();

  /// From one thread (the operator's). @return false when the queue is full: nothing was asked.
  [[nodiscard]] bool command(const pipeline::OperatorCommand& command);
  /// Takes effect in the next step, ahead of everything queued; from any thread.
  void requestStop();
  /// Heartbeat of a window that drives the session, often and from its own thread. After the first call, a pause longer
  /// than 0.5 s leads from rendering to Held; later calls do not arm again. A session without a window never calls
  /// this.
  void windowAlive();
  /// Checks against the parameter's description, then queues the change; from the operator's thread.
  [[nodiscard]] Result<void> setParameter(std::string_view id, double value);
  /// The profile with every change that an operator made since (including tare); from the operator's thread.
  [[nodiscard]] Profile currentProfile() const;

  /// Moves telemetry into `out`, oldest first; one consumer. @return how many
  std::size_t takeTelemetry(std::span<pipeline::TelemetrySample> out);
  /// Samples lost because the consumer was too slow.
  [[nodiscard]] std::uint64_t telemetryLost() const;
  /// Moves notices out, oldest first; one consumer.
  [[nodiscard]] std::vector<Notice> takeNotices();

  /// Copies of the newest; from any thread.
  [[nodiscard]] CameraView cameraView() const;
  [[nodiscard]] StationStatus status() const;
  [[nodiscard]] std::vector<ReadinessLine> readiness() const;
  [[nodiscard]] SimulationTruth simulationTruth() const;
  /// The touchpad, its motor board where it has one of its own, and the camera, with live values a few times a second.
  [[nodiscard]] std::vector<device::DeviceReport> devices() const;

  /// A small, slow motion on an operator's held button, from the operator's thread; see device_test.h for what ends it.
  /// While the button is held `keepDeviceTest` has to be called at least every 0.5 s; its release is `stopDeviceTest`.
  /// @param stretch_deg where device::DeviceTest::stretch and chirp go; the others ignore it
  /// @return an error when it may not run now: the session holds the motors, or they do not answer
  [[nodiscard]] Result<void> startDeviceTest(device::DeviceTest test, double stretch_deg = 0.0);
  void keepDeviceTest();
  void stopDeviceTest();
  [[nodiscard]] DeviceTestStatus deviceTestStatus() const;
  /// Rows that the device tests breakaway and chirp have measured so far, at 1 kHz. While one runs, to be called from
  /// the operator's thread at least every 10 s, or rows are lost.
  [[nodiscard]] std::vector<texture::SweepRow> deviceTestSweep();

  /// Recording, from one thread, the operator's or another. The file starts up to
  /// session.pre_trigger_s (10 s by default) before this call.
  /// @return an error at once when the file cannot be made, or one is being recorded; nothing then changes
  [[nodiscard]] Result<void> startRecording(const recording::RecordingRequest& request);
  /// Closes the file: it is whole when this returns without an error.
  [[nodiscard]] Result<void> stopRecording();
  /// A line of the recording's log. @return an error while nothing is recorded: the line is then not kept
  [[nodiscard]] Result<void> note(recording::NoteKind kind, const std::string& text);
  [[nodiscard]] recording::RecorderStatus recorderStatus() const;

  /// Simulation only: the finger goes where the mouse says until released; no effect on a real touchpad.
  void moveSimulatedFinger(double x_mm, double y_mm, double indentation_mm);
  void releaseSimulatedFinger();
  /// Simulation only: what the finger does while nobody moves it, from its beginning.
  void playSimulatedFinger(const sim::FingerPath& path);
  [[nodiscard]] bool simulated() const;

  /// The scene where the robot stands, for one thread that draws it; null where there is none in this process.
  [[nodiscard]] std::shared_ptr<scene::SceneStage> scene() const;

 private:
  struct Impl;
  explicit Station(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace fyd::station
