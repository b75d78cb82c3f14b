// The threads around the step: which backends, which robot, supervision.
//
//   device thread  exchanges with the touchpad          ─▶ latest-value slot ─▶ ┐
//   camera thread  takes pictures, detects the finger   ─▶ latest-value slot ─▶ ├─ haptic loop: Pipeline::step, 1 kHz
//   link thread    speaks with the robot, answers it    ─▶ slot and rings    ─▶ ┘    └▶ motor command, touch, telemetry
//
// The window, the headless runner and the tests hold a Station and see only this header.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/base/error.h"
#include "core/device/device_report.h"
#include "core/pipeline/inputs.h"
#include "core/pipeline/outputs.h"
#include "core/protocol/described_scene.h"
#include "core/protocol/touchpad_end.h"
#include "core/sensing/finger_types.h"
#include "core/session/recorder.h"
#include "core/sim/finger_path.h"
#include "core/station/device_test.h"
#include "core/station/profile.h"

namespace fyd::scene {
class SceneStage;
}

namespace fyd::station {

struct StationOptions {
  Profile profile;
  std::string finger_csv;  ///< recording the simulated finger follows; empty: the built-in gesture
  std::string touchpad;    ///< "simulated", "modbus-tcp:HOST:PORT", "modbus-rtu:TTY[:BAUD]" or "recording:FILE": its
                           ///< readings again, motors not driven; empty: the profile's
  std::string motors;      ///< "qbmove:TTY" in place of the touchpad's own motors; empty: its own
  std::string camera;      ///< device index, file, folder, URL, "recording:FILE"; empty: the touchpad's own
  std::string robot;       ///< "simulated[:PREDICTOR]", "scene:FILE", "none", "link:HOST:PORT" or "classic:HOST:PORT"
                           ///< (listens there); empty: the profile's
  std::string key_file;    ///< of FYD Link; "link:" needs one, the others take none
  std::string scene;       ///< file of a scene that is felt here, beside whichever robot; empty: robot's "scene:FILE"
  std::string surface;     ///< file of a stored surface, felt while robot is "none"; empty: none
  std::optional<session::RecordingRequest> record;  ///< recorded from the first step on
};

/// What the options leave open as the profile says it. A touchpad that is named comes with its own motors and camera:
/// those of the profile belong to the profile's touchpad. `Station::open` does this by itself.
[[nodiscard]] StationOptions withProfileSources(StationOptions options);

/// How one part is doing, in words an operator reads.
struct PartStatus {
  device::Part part = device::Part::touchpad;
  Message description;  ///< which one it is
  bool ok = false;
  Message problem;       ///< empty when ok; says what to do otherwise
  double rate_hz = 0.0;  ///< exchanges or pictures in the last second
  double age_ms = 0.0;   ///< of the newest value; NaN before the first
  std::uint64_t errors = 0;
};

struct LoopStatus {
  std::uint64_t steps = 0;
  std::uint64_t missed_cycles = 0;
  double step_ns_p50 = 0.0;  ///< over the last 10 000 steps
  double step_ns_p99 = 0.0;
  bool real_time = false;  ///< SCHED_FIFO granted
};

/// How a robot end leads its arm.
struct LedArm {
  std::string predictor;
  Vec3 arrived_mm;          ///< where the newest touch leads by itself
  Vec3 target_mm;           ///< where the arm is led
  double error_mm = 0.0;    ///< RMS over about a second: where the finger was said to be, and was seen after
  double horizon_ms = 0.0;  ///< predicted, from the newest picture
};

struct LinkStatus {
  Message protocol;      ///< "FYD Link, sealed", "classic, not secured", "scene NAME", "none"
  bool secured = false;  ///< authenticated and encrypted
  std::string local;     ///< address this end listens on
  std::string peer;      ///< empty before the first
  std::uint64_t states_received = 0;
  std::uint64_t touches_sent = 0;
  std::uint64_t refused = 0;        ///< datagrams counted and ignored
  std::uint64_t send_failures = 0;  ///< replies the network did not take
  std::uint64_t samples_lost = 0;   ///< accelerations and commands the loop did not take in time
  pipeline::LinkPhase phase = pipeline::LinkPhase::none;
  protocol::SceneCopies scenes = protocol::SceneCopies::none;  ///< this end's beside the robot's
  protocol::LinkFigures figures;                               ///< round trip, jitter, loss, refusals by reason
  std::optional<LedArm> led;  ///< of the simulated robot in this process; another one keeps it to itself
};

struct StationStatus {
  std::vector<PartStatus> parts;
  LoopStatus loop;
  LinkStatus link;
};

/// One line of the readiness list: what must hold before arming.
struct ReadinessLine {
  Message what;
  bool ok = false;
  Message why;     ///< what is wrong, as a phrase; empty when ok
  Message remedy;  ///< what the operator does about it, as a sentence; empty when ok
  pipeline::Lack lack = pipeline::Lack::none;
};

/// A picture as the detector saw it.
struct CameraView {
  cv::Mat picture;      ///< 8 bit, grey or BGR; empty before the first
  cv::Mat finger_mask;  ///< 8 bit, the region of interest's size; 255 where the detector sees finger
  cv::Rect region;      ///< of interest, in the picture
  sensing::FingerDetection finger;
  Instant taken{};
  std::uint64_t number = 0;
};

/// An event with its time, and as a sentence.
struct Notice {
  Instant when{};
  pipeline::Event event;
  Message message;
};

/// True values of the simulated touchpad; for error figures only.
struct SimulationTruth {
  bool available = false;
  double finger_error_mm_rms = 0.0;       ///< detected against where the contact shows at the picture's own time
  double indentation_error_mm_rms = 0.0;  ///< estimated against true, in contact
  double felt_g_rms = 0.0;                ///< acceleration of the finger by the vibration, in contact while Active
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
  /// Heard by the next step whatever else is queued; from any thread.
  void requestStop();
  /// A window that drives the session says that it still answers: often, from its own thread. From the first call on,
  /// silence for longer than 0.5 s leads out of rendering to Held; its return arms nothing. A session without a window
  /// never calls this.
  void windowAlive();
  /// Checks against the parameter's description, then queues the change; from the operator's thread.
  [[nodiscard]] Result<void> setParameter(std::string_view id, double value);
  /// The profile with every change made since (including tare); from the operator's thread.
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
  /// While the button is held `keepDeviceTest` has to be called at least every 0.3 s; its release is `stopDeviceTest`.
  /// @param stretch_deg where device::DeviceTest::stretch and chirp go; the others ignore it
  /// @return an error when it may not run now: the session holds the motors, or they do not answer
  [[nodiscard]] Result<void> startDeviceTest(device::DeviceTest test, double stretch_deg = 0.0);
  void keepDeviceTest();
  void stopDeviceTest();
  [[nodiscard]] DeviceTestStatus deviceTestStatus() const;
  /// What the device tests breakaway and chirp saw until now, at 1 kHz. While one runs, from the operator's thread and
  /// at least every 10 s; else something is lost.
  [[nodiscard]] std::vector<texture::SweepRow> deviceTestSweep();

  /// Recording, from the operator's thread. The file starts up to 10 s before this call.
  /// @return an error at once when the file cannot be made, or one is being recorded; nothing then changes
  [[nodiscard]] Result<void> startRecording(const session::RecordingRequest& request);
  /// Closes the file: it is whole when this returns without an error.
  [[nodiscard]] Result<void> stopRecording();
  /// A line of the recording's log; dropped while nothing is recorded.
  [[nodiscard]] Result<void> note(session::NoteKind kind, const std::string& text);
  [[nodiscard]] session::RecorderStatus recorderStatus() const;

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
