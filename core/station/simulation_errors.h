// Measurement errors against the true values of the simulated touchpad.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>

#include "core/pipeline/telemetry.h"
#include "core/station/camera_view.h"

namespace fyd::sim {
class TouchpadWorld;
}

namespace fyd::station {

/// True values of the simulated touchpad; for error figures only.
struct SimulationTruth {
  bool available = false;
  double finger_error_mm_rms = 0.0;       ///< detected against true contact at the picture's time
  double indentation_error_mm_rms = 0.0;  ///< estimated against true, in contact
  double felt_g_rms = 0.0;                ///< acceleration of the finger by the vibration, in contact while Active
};

class SimulationErrors {
 public:
  /// @param world null: a real touchpad, without known true values
  /// @param simulated_camera the pictures are of this world
  SimulationErrors(std::shared_ptr<sim::TouchpadWorld> world, bool simulated_camera);
  /// From the camera thread.
  void addPicture(const CameraView& view);
  /// From the operator's thread.
  void addSample(const pipeline::TelemetrySample& sample);
  [[nodiscard]] SimulationTruth truth() const;

 private:
  /// Sum of squares of an error, as it grows.
  struct ErrorSum {
    double squares = 0.0;
    std::uint64_t count = 0;
    void add(double squared);
    [[nodiscard]] double rms() const;  ///< NaN before the first
  };

  std::shared_ptr<sim::TouchpadWorld> world_;
  bool simulated_camera_;
  mutable std::mutex mutex_;
  ErrorSum finger_;
  ErrorSum indentation_;
  ErrorSum felt_g_;
};

}  // namespace fyd::station
