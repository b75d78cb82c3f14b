#include "app/console/session.h"

namespace fyd::console {
namespace {

class StationSession : public Session {
 public:
  explicit StationSession(std::unique_ptr<station::Station> station) : station_(std::move(station)) {}

  void start() override { station_->start(); }
  void shutDown() override { station_->shutDown(); }
  bool command(const pipeline::OperatorCommand& command) override { return station_->command(command); }
  void requestStop() override { station_->requestStop(); }
  Result<void> setParameter(std::string_view id, double value) override { return station_->setParameter(id, value); }
  station::Profile currentProfile() const override { return station_->currentProfile(); }
  std::size_t takeTelemetry(std::span<pipeline::TelemetrySample> out) override { return station_->takeTelemetry(out); }
  std::uint64_t telemetryLost() const override { return station_->telemetryLost(); }
  std::vector<station::Notice> takeNotices() override { return station_->takeNotices(); }
  station::CameraView cameraView() const override { return station_->cameraView(); }
  station::StationStatus status() const override { return station_->status(); }
  std::vector<station::ReadinessLine> readiness() const override { return station_->readiness(); }
  void moveSimulatedFinger(double x_mm, double y_mm, double indentation_mm) override {
    station_->moveSimulatedFinger(x_mm, y_mm, indentation_mm);
  }
  void releaseSimulatedFinger() override { station_->releaseSimulatedFinger(); }
  bool simulated() const override { return station_->simulated(); }

 private:
  std::unique_ptr<station::Station> station_;
};

}  // namespace

std::unique_ptr<Session> makeSession(std::unique_ptr<station::Station> station) {
  return std::make_unique<StationSession>(std::move(station));
}

}  // namespace fyd::console
