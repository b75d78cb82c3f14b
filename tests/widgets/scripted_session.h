// A session that plays what a test scripts and notes what it was asked, and a window on it.
#pragma once

#include <stdexcept>

#include "app/console/devices/devices_page.h"
#include "app/console/window/main_window.h"
#include "core/station/profile/touchpad_name.h"
#include "tests/widgets/wait.h"

namespace fyd::tests {

class ScriptedSession : public console::Session {
 public:
  void start() override {}
  void shutDown() override { ++shut_downs; }
  bool command(const pipeline::OperatorCommand& command) override {
    commands.push_back(command);
    return takes_commands;
  }
  void requestStop() override {
    ++stops;
    stopDeviceTest();  // as a station's does
  }
  void windowAlive() override { ++beats; }
  Result<void> setParameter(std::string_view id, double value) override {
    if (refuses) return fail("{}: refused by the script", id);
    auto bound = bindParameters(profile);
    findParameter(bound, id)->set(value);
    changes.emplace_back(std::string(id), value);
    return {};
  }
  station::Profile currentProfile() const override { return profile; }
  std::size_t takeTelemetry(std::span<pipeline::TelemetrySample> out) override {
    const std::size_t count = std::min(out.size(), telemetry.size());
    std::copy_n(telemetry.begin(), count, out.begin());
    telemetry.erase(telemetry.begin(), telemetry.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }
  std::uint64_t telemetryLost() const override { return 0; }
  std::vector<station::Notice> takeNotices() override { return std::exchange(notices, {}); }
  station::CameraView cameraView() const override { return view; }
  station::StationStatus status() const override { return now; }
  std::vector<station::ReadinessLine> readiness() const override { return lines; }
  std::vector<device::DeviceReport> devices() const override { return reports; }
  Result<void> startDeviceTest(device::DeviceTest test, double stretch_deg) override {
    if (refuses) return fail("device test: refused by the script");
    tests.push_back(test);
    stretches.push_back(stretch_deg);
    test_status = {.running = true, .test = test, .progress = 0.0, .words = fyd::say("running")};
    return {};
  }
  void keepDeviceTest() override { ++keeps; }
  void stopDeviceTest() override {
    ++test_stops;
    if (test_status.running)
      test_status = {.test = test_status.test, .words = fyd::say("ended: the button was released")};
  }
  station::DeviceTestStatus deviceTestStatus() const override { return test_status; }
  std::vector<texture::SweepRow> deviceTestSweep() override { return sweep; }
  Result<void> startRecording(const recording::RecordingRequest& request) override {
    waitForDisk();
    if (disk_throws) throw std::runtime_error("bad disk by the script");
    if (refuses) return fail("{}: refused by the script", request.path);
    recordings.push_back(request);
    if (!recording_ends) recorder = {.state = recording::RecorderState::recording, .path = request.path};
    return {};
  }
  Result<void> stopRecording() override {
    waitForDisk();
    ++recording_stops;
    recorder.state = recording::RecorderState::idle;
    if (refuses) return fail("{}: refused by the script", recorder.path);
    return {};
  }
  Result<void> note(recording::NoteKind kind, const std::string& text) override {
    if (refuses) return fail("the note: refused by the script");
    notes.emplace_back(kind, text);
    return {};
  }
  recording::RecorderStatus recorderStatus() const override { return recorder; }
  void moveSimulatedFinger(double x_mm, double y_mm, double indentation_mm) override {
    finger = {x_mm, y_mm, indentation_mm};
  }
  void releaseSimulatedFinger() override { finger.clear(); }
  void playSimulatedFinger(const sim::FingerPath& path) override { played.push_back(path); }
  std::string fingerFile() const override { return finger_file; }
  bool simulated() const override { return station::isSimulated(profile.calibrated_on); }
  std::shared_ptr<scene::SceneStage> scene() const override { return stage; }
  console::ConnectionWords connection() const override { return present; }
  bool isOpen() const override { return open; }
  Check checkOf(const console::ConnectionWords& wanted) const override {
    ++checks;
    return [this, wanted] {
      while (reads_long) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      if (check_throws) throw std::runtime_error("bad check by the script");
      std::vector<station::ConnectionProblem> problems;
      if (wanted.robot == "scene:bad.toml") {
        problems.push_back({.part = device::Part::robot, .message = verbatim("bad.toml: bad by the script")});
      }
      if (wanted.touchpad == "modbus-tcp:bad") {
        problems.push_back({.part = device::Part::touchpad, .message = verbatim("bad by the script")});
      }
      return problems;
    };
  }
  std::function<Arrival()> leaveFor(const console::ConnectionWords& wanted) override {
    const bool was_open = std::exchange(open, false);
    return [this, wanted, was_open]() -> Arrival {
      while (opens_long) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      if (opening_throws) throw std::runtime_error("bad opening by the script");
      return [this, wanted, was_open]() -> Result<void> {
        asked.push_back(wanted);
        open = !refuses || was_open;
        if (refuses) return fail("127.0.0.1:3490: refused by the script");
        present = wanted;
        if (arrives_with) profile = *std::exchange(arrives_with, std::nullopt);
        return {};
      };
    };
  }
  Result<void> beginAnew(const station::Profile& wanted) override {
    ++begun_anew;
    if (refuses) {
      open = open && !loses_former;
      return fail("the station: refused by the script");
    }
    profile = wanted;
    return {};
  }

  void waitForDisk() const {
    for (int ms = 0; disk_waits && ms < kPatience_ms; ++ms) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

  [[nodiscard]] int count(pipeline::OperatorAction action) const {
    return static_cast<int>(std::ranges::count_if(commands, [&](const auto& c) { return c.action == action; }));
  }
  void say(pipeline::SafetyState state) {
    pipeline::TelemetrySample sample;
    sample.now = instantAt(++seconds * 0.001);
    sample.state = state;
    telemetry.push_back(sample);
  }

  /// Its touchpad is the simulated one until a test says another.
  station::Profile profile = [] {
    station::Profile out;
    out.calibrated_on = station::kSimulatedTouchpad;
    return out;
  }();
  std::vector<pipeline::OperatorCommand> commands;
  std::vector<std::pair<std::string, double>> changes;
  std::vector<pipeline::TelemetrySample> telemetry;
  std::vector<station::Notice> notices;
  station::CameraView view;
  station::StationStatus now;
  std::vector<station::ReadinessLine> lines = {{.what = fyd::say("Motors answer"), .ok = true}};
  std::vector<double> finger;
  std::vector<sim::FingerPath> played;  ///< what the simulated finger was given to do
  std::string finger_file;              ///< that the session was started with
  std::vector<device::DeviceReport> reports;
  std::vector<device::DeviceTest> tests;
  std::vector<double> stretches;  ///< asked for with each of them
  station::DeviceTestStatus test_status;
  std::vector<fyd::texture::SweepRow> sweep;  ///< what the loop saw of the device test
  int keeps = 0;
  int test_stops = 0;
  recording::RecorderStatus recorder;
  std::vector<recording::RecordingRequest> recordings;
  std::vector<std::pair<recording::NoteKind, std::string>> notes;
  int recording_stops = 0;
  int stops = 0;
  int beats = 0;
  int shut_downs = 0;
  double seconds = 0;
  bool takes_commands = true;
  bool refuses = false;
  bool loses_former = false;  ///< a session that cannot be begun anew stays closed
  console::ConnectionWords present;
  std::vector<console::ConnectionWords> asked;
  mutable int checks = 0;  ///< choices that were asked about beforehand
  bool open = true;
  std::atomic<bool> reads_long = false;  ///< a check takes until this is false
  std::atomic<bool> opens_long = false;  ///< other devices are opened only when this is false
  std::atomic<bool> disk_waits = false;  ///< a recording begins or ends only when this is false
  std::atomic<bool> check_throws = false, opening_throws = false, disk_throws = false;
  std::atomic<bool> recording_ends = false;      ///< a recording that has begun ends at once
  std::optional<station::Profile> arrives_with;  ///< of the next devices
  int begun_anew = 0;
  std::shared_ptr<scene::SceneStage> stage;  ///< a scene where the robot stands
};

struct Fixture {
  Fixture() {
    auto made = std::make_unique<ScriptedSession>();
    session = made.get();
    window = std::make_unique<console::MainWindow>(std::move(made), folder.filePath(QStringLiteral("profile.toml")));
    window->show();
    window->activateWindow();
    (void)QTest::qWaitForWindowActive(window.get(), kPatience_ms);
  }
  widgets::TuningRow* row(const char* id) const { return window->operate()->tuning()->row(QLatin1String(id)); }
  QTemporaryDir folder;
  ScriptedSession* session;
  std::unique_ptr<console::MainWindow> window;
};

}  // namespace fyd::tests
