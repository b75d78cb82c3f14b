#include "app/console/shell/session.h"

#include <mutex>

#include "core/station/station_sources.h"

namespace fyd::console {
namespace {

class StationSession : public Session {
 public:
  StationSession(station::StationOptions options, std::unique_ptr<station::Station> station)
      : options_(std::move(options)), finger_csv_(options_.finger_csv), station_(std::move(station)) {
    options_.record.reset();  // used once, at the start: other devices do not start it again
  }

  void start() override {
    if (station_) station_->start();
  }
  void shutDown() override {
    const std::lock_guard lock(stays_);
    if (station_) station_->shutDown();
  }
  bool command(const pipeline::OperatorCommand& command) override { return station_ && station_->command(command); }
  void requestStop() override {
    if (station_) station_->requestStop();
  }
  void windowAlive() override {
    if (station_) station_->windowAlive();
  }
  Result<void> setParameter(std::string_view id, double value) override {
    if (!station_) return fail("{}: the session is closed", id);
    return station_->setParameter(id, value);
  }
  station::Profile currentProfile() const override { return station_ ? station_->currentProfile() : options_.profile; }
  std::size_t takeTelemetry(std::span<pipeline::TelemetrySample> out) override {
    return station_ ? station_->takeTelemetry(out) : 0;
  }
  std::uint64_t telemetryLost() const override { return station_ ? station_->telemetryLost() : 0; }
  std::vector<station::Notice> takeNotices() override {
    return station_ ? station_->takeNotices() : std::vector<station::Notice>{};
  }
  station::CameraView cameraView() const override { return station_ ? station_->cameraView() : station::CameraView{}; }
  station::StationStatus status() const override { return station_ ? station_->status() : station::StationStatus{}; }
  std::vector<station::ReadinessLine> readiness() const override {
    return station_ ? station_->readiness() : std::vector<station::ReadinessLine>{};
  }
  std::vector<device::DeviceReport> devices() const override {
    return station_ ? station_->devices() : std::vector<device::DeviceReport>{};
  }

  Result<void> startDeviceTest(device::DeviceTest test, double stretch_deg) override {
    if (!station_) return fail("device test: the session is closed");
    return station_->startDeviceTest(test, stretch_deg);
  }
  void keepDeviceTest() override {
    if (station_) station_->keepDeviceTest();
  }
  void stopDeviceTest() override {
    if (station_) station_->stopDeviceTest();
  }
  station::DeviceTestStatus deviceTestStatus() const override {
    return station_ ? station_->deviceTestStatus() : station::DeviceTestStatus{};
  }
  std::vector<texture::SweepRow> deviceTestSweep() override {
    return station_ ? station_->deviceTestSweep() : std::vector<texture::SweepRow>{};
  }

  Result<void> startRecording(const recording::RecordingRequest& request) override {
    const std::lock_guard lock(stays_);
    if (!station_) return fail("{}: the session is closed", request.path);
    return station_->startRecording(request);
  }
  Result<void> stopRecording() override {
    const std::lock_guard lock(stays_);
    if (!station_) return fail("the session is closed");
    return station_->stopRecording();
  }
  Result<void> note(recording::NoteKind kind, const std::string& text) override {
    if (!station_) return fail("{}: not kept, the session is closed", text);
    return station_->note(kind, text);
  }
  recording::RecorderStatus recorderStatus() const override {
    return station_ ? station_->recorderStatus() : recording::RecorderStatus{};
  }

  void moveSimulatedFinger(double x_mm, double y_mm, double indentation_mm) override {
    if (station_) station_->moveSimulatedFinger(x_mm, y_mm, indentation_mm);
  }
  void releaseSimulatedFinger() override {
    if (station_) station_->releaseSimulatedFinger();
  }
  void playSimulatedFinger(const sim::FingerPath& path) override {
    finger_ = path;
    if (station_) station_->playSimulatedFinger(path);
  }
  std::string fingerFile() const override { return finger_csv_; }
  bool simulated() const override { return station_ && station_->simulated(); }
  std::shared_ptr<scene::SceneStage> scene() const override { return station_ ? station_->scene() : nullptr; }

  ConnectionWords connection() const override {
    return {.touchpad = options_.touchpad,
            .motors = options_.motors,
            .camera = options_.camera,
            .robot = options_.robot,
            .key_file = options_.key_file};
  }
  bool isOpen() const override { return station_ != nullptr; }
  Check checkOf(const ConnectionWords& wanted) const override;
  std::function<Arrival()> leaveFor(const ConnectionWords& wanted) override;
  Result<void> beginAnew(const station::Profile& profile) override;

 private:
  Result<void> open(const station::StationOptions& options);
  void begin(const station::StationOptions& options, std::unique_ptr<station::Station> station);
  void close();

  station::StationOptions options_;
  std::string finger_csv_;                     // of the start: the simulated touchpad's; others have none
  std::optional<sim::FingerPath> finger_;      // set since the start
  std::unique_ptr<station::Station> station_;  // none: closed
  std::mutex stays_;                           // the station, while another thread waits for its recorder
};

Result<void> StationSession::open(const station::StationOptions& options) {
  auto opened = station::Station::open(options);
  if (!opened) return tl::unexpected(opened.error());
  begin(options, std::move(*opened));
  return {};
}

void StationSession::begin(const station::StationOptions& options, std::unique_ptr<station::Station> station) {
  options_ = options;
  {
    const std::lock_guard lock(stays_);
    station_ = std::move(station);
  }
  if (finger_) station_->playSimulatedFinger(*finger_);
  station_->start();
}

void StationSession::close() {
  if (!station_) return;
  options_.profile = station_->currentProfile();
  station_->requestStop();
  const std::lock_guard lock(stays_);
  station_->shutDown();
  station_.reset();  // its port and devices are free now
}

Session::Check StationSession::checkOf(const ConnectionWords& wanted) const {
  return [wanted, in_use = station_ ? connection() : ConnectionWords{.touchpad = {}, .robot = {}},
          parameters = options_.profile.device] { return station::checkConnection(wanted, in_use, parameters); };
}

std::function<Session::Arrival()> StationSession::leaveFor(const ConnectionWords& wanted) {
  struct Way {
    std::unique_ptr<station::Station> leaving, arriving;
    station::StationOptions former, options;
    Result<void> outcome;
  };
  const auto way = std::make_shared<Way>();
  if (station_) {
    options_.profile = station_->currentProfile();
    station_->requestStop();
    const std::lock_guard lock(stays_);
    way->leaving = std::move(station_);
  }
  way->former = way->options = options_;
  way->options.touchpad = wanted.touchpad;
  way->options.motors = wanted.motors;
  way->options.camera = wanted.camera;
  way->options.robot = wanted.robot;
  way->options.key_file = wanted.key_file;
  way->options.profile.sources = wanted;  // "Save profile" keeps them
  way->options.finger_csv = wanted.touchpad == station::kSimulated ? finger_csv_ : std::string();
  return [this, way]() -> Arrival {
    if (way->leaving) way->leaving->shutDown();
    way->leaving.reset();  // its port and devices are free now
    auto opened = station::Station::open(way->options);
    if (!opened) {
      way->outcome = tl::unexpected(opened.error());
      way->options = way->former;
      opened = station::Station::open(way->former);
      if (!opened) {
        way->outcome = fail("{}; the former devices could not be had again either: {}", way->outcome.error().message,
                            opened.error().message);
      }
    }
    if (opened) way->arriving = std::move(*opened);
    return [this, way]() -> Result<void> {
      if (way->arriving) begin(way->options, std::move(way->arriving));
      return way->outcome;
    };
  };
}

Result<void> StationSession::beginAnew(const station::Profile& profile) {
  close();
  station::StationOptions changed = options_;
  changed.profile = profile;
  auto opened = open(changed);
  if (opened) return {};
  if (const auto again = open(options_); !again) {
    return fail("{}; the former session could not be had again either: {}", opened.error().message,
                again.error().message);
  }
  return opened;
}

}  // namespace

Result<std::unique_ptr<Session>> openSession(const station::StationOptions& asked) {
  const station::StationOptions options = station::withProfileSources(asked);
  auto station = station::Station::open(options);
  if (!station) return tl::unexpected(station.error());
  return std::make_unique<StationSession>(options, std::move(*station));
}

std::unique_ptr<Session> closedSession(const station::StationOptions& options) {
  return std::make_unique<StationSession>(station::withProfileSources(options), nullptr);
}

}  // namespace fyd::console
