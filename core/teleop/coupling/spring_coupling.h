// The paper's coupling as printed, and the same with time-domain passivity (coupling.h).
#pragma once

#include <cstdint>
#include <optional>

#include "core/teleop/coupling/coupling.h"

namespace fyd::teleop {

/// One end: force = stiffness · (own position − the other's newest one); at the far end it drives the device, with
/// damping.
class SpringEnd final : public CouplingEnd {
 public:
  enum class Side : std::uint8_t { hand, far };

  SpringEnd(Side side, bool observed, const CouplingSettings& settings)
      : side_(side), observed_(observed), settings_(settings) {}

  void receive(const CouplingMessage& message) override;
  [[nodiscard]] double step(const EndState& state) override;
  [[nodiscard]] CouplingMessage message() const override;
  [[nodiscard]] CouplingTelemetry telemetry() const override;

  /// Upper bound of the power that the other end may report; energy beyond it is not accepted.
  static constexpr double kMostPower_W = 50.0;

 private:
  Side side_;
  bool observed_;
  CouplingSettings settings_;
  bool heard_ = false;
  double heard_date_s_ = 0.0;
  double other_m_ = 0.0;
  std::optional<double> told_J_;  ///< of what the other end tells: as far as it is counted
  double other_energy_J_ = 0.0;   ///< put in there since the first message here
  bool begun_ = false;
  double time_s_ = 0.0, position_m_ = 0.0;
  double force_N_ = 0.0;  ///< of the spring, into the network
  double in_J_ = 0.0;     ///< put into the network here
  double out_J_ = 0.0;    ///< come out of it here
  double dissipated_J_ = 0.0;
};

}  // namespace fyd::teleop
