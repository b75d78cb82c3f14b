// The window's interface to a station; implemented by the real one, and by a scripted one in the window's tests.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/station/connection_check.h"
#include "core/station/station.h"

namespace fyd::console {

/// Which touchpad, motors, camera and robot a session has; words as in station::StationOptions.
using ConnectionWords = station::SourceParameters;

/// All functions from the window's thread unless they say otherwise; meanings as in station::Station.
class Session {
 public:
  virtual ~Session() = default;
  virtual void start() = 0;
  virtual void shutDown() = 0;

  [[nodiscard]] virtual bool command(const pipeline::OperatorCommand& command) = 0;
  virtual void requestStop() = 0;
  virtual void windowAlive() = 0;
  [[nodiscard]] virtual Result<void> setParameter(std::string_view id, double value) = 0;
  [[nodiscard]] virtual station::Profile currentProfile() const = 0;

  virtual std::size_t takeTelemetry(std::span<pipeline::TelemetrySample> out) = 0;
  [[nodiscard]] virtual std::uint64_t telemetryLost() const = 0;
  [[nodiscard]] virtual std::vector<station::Notice> takeNotices() = 0;
  [[nodiscard]] virtual station::CameraView cameraView() const = 0;
  [[nodiscard]] virtual station::StationStatus status() const = 0;
  [[nodiscard]] virtual std::vector<station::ReadinessLine> readiness() const = 0;
  [[nodiscard]] virtual std::vector<device::DeviceReport> devices() const = 0;

  [[nodiscard]] virtual Result<void> startDeviceTest(device::DeviceTest test, double stretch_deg) = 0;
  virtual void keepDeviceTest() = 0;
  virtual void stopDeviceTest() = 0;
  [[nodiscard]] virtual station::DeviceTestStatus deviceTestStatus() const = 0;
  [[nodiscard]] virtual std::vector<texture::SweepRow> deviceTestSweep() = 0;

  // These two wait for the disk, up to 30 s, and may run on any thread: the session neither ends nor shuts down meanwhile.
  [[nodiscard]] virtual Result<void> startRecording(const recording::RecordingRequest& request) = 0;
  [[nodiscard]] virtual Result<void> stopRecording() = 0;
  [[nodiscard]] virtual Result<void> note(recording::NoteKind kind, const std::string& text) = 0;
  [[nodiscard]] virtual recording::RecorderStatus recorderStatus() const = 0;

  virtual void moveSimulatedFinger(double x_mm, double y_mm, double indentation_mm) = 0;
  virtual void releaseSimulatedFinger() = 0;
  /// Kept when the session is begun anew.
  virtual void playSimulatedFinger(const sim::FingerPath& path) = 0;
  /// The file it followed at the start; empty: the demonstration.
  [[nodiscard]] virtual std::string fingerFile() const = 0;
  [[nodiscard]] virtual bool simulated() const = 0;
  [[nodiscard]] virtual std::shared_ptr<scene::SceneStage> scene() const = 0;

  [[nodiscard]] virtual ConnectionWords connection() const = 0;
  /// Whether these devices can be had, as far as it can be checked beforehand. The returned function may run on any
  /// thread, takes up to some seconds, and changes nothing.
  using Check = std::function<std::vector<station::ConnectionProblem>()>;
  [[nodiscard]] virtual Check checkOf(const ConnectionWords& wanted) const = 0;
  /// Ends the session and begins another with these devices and the present profile; motors are off then. Only while
  /// nothing can move. The session is closed from this call on. The returned function may run on any thread; the
  /// function that it returns must run on the window's thread and begins the new session; or, with an error, the former
  /// one, if `isOpen`.
  using Arrival = std::function<Result<void>()>;
  [[nodiscard]] virtual std::function<Arrival()> leaveFor(const ConnectionWords& wanted) = 0;
  /// Ends the session and begins another with this profile and the present devices, for values that cannot change while
  /// it runs; motors are off then. Only while nothing can move.
  /// @return an error when it cannot be begun; the former profile is back then, if `isOpen`
  [[nodiscard]] virtual Result<void> beginAnew(const station::Profile& profile) = 0;
  /// False after one of these failed and the former session could not be opened again either, and at a start whose
  /// devices could not be opened.
  [[nodiscard]] virtual bool isOpen() const = 0;
};

/// A session on a station that is opened with these options.
[[nodiscard]] Result<std::unique_ptr<Session>> openSession(const station::StationOptions& options);

/// A closed session with these options: its devices could not be opened. Others can be chosen, or the same tried again.
[[nodiscard]] std::unique_ptr<Session> closedSession(const station::StationOptions& options);

}  // namespace fyd::console
