// What the window needs of a station; the real one stands behind it, and in the window's tests a scripted one.
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/station/station.h"

namespace fyd::console {

/// All functions from the window's thread; meanings as in station::Station.
class Session {
 public:
  virtual ~Session() = default;
  virtual void start() = 0;
  virtual void shutDown() = 0;

  [[nodiscard]] virtual bool command(const pipeline::OperatorCommand& command) = 0;
  virtual void requestStop() = 0;
  [[nodiscard]] virtual Result<void> setParameter(std::string_view id, double value) = 0;
  [[nodiscard]] virtual station::Profile currentProfile() const = 0;

  virtual std::size_t takeTelemetry(std::span<pipeline::TelemetrySample> out) = 0;
  [[nodiscard]] virtual std::uint64_t telemetryLost() const = 0;
  [[nodiscard]] virtual std::vector<station::Notice> takeNotices() = 0;
  [[nodiscard]] virtual station::CameraView cameraView() const = 0;
  [[nodiscard]] virtual station::StationStatus status() const = 0;
  [[nodiscard]] virtual std::vector<station::ReadinessLine> readiness() const = 0;

  virtual void moveSimulatedFinger(double x_mm, double y_mm, double indentation_mm) = 0;
  virtual void releaseSimulatedFinger() = 0;
  [[nodiscard]] virtual bool simulated() const = 0;
};

/// The session of a station that was opened.
[[nodiscard]] std::unique_ptr<Session> makeSession(std::unique_ptr<station::Station> station);

}  // namespace fyd::console
