// One end of a session of two linked devices: what it does with its device at 1 kHz, and what it sends and receives.
//
// Sockets and clocks are the caller's. The ends are linked while both run and receive each other's messages: an end may
// be started and stopped in any order, any number of times, and may vanish. An end that is not linked exerts no
// coupling force; a far device then only brakes. Received positions are predicted to the present, smoothed, and given
// to the coupling of each axis. Both ends take up the distance between them at the moment of linking at 50 mm/s, so that
// no force begins with a jump.
//
// With a deadband an end sends only what can be felt (teleop/deadband.h): its position and its force, and a changed
// surface; it sends in each millisecond in which something left the band, whatever the line carries. The receiver knows
// values that were not sent to within the band, and gives its predictor a position each period, as without a deadband.
// At most kRefresh_s pass between two messages, which also carry the orientation.
//
// Dates are of one clock at both ends; messages dated more than kLost_s ahead are ignored.
#pragma once

#include "core/protocol/link/device_message.h"
#include "core/teleop/coupling/coupling_choice.h"
#include "core/teleop/deadband.h"
#include "core/teleop/prediction/orientation_predictor.h"
#include "core/teleop/prediction/predictor_choice.h"
#include "core/teleop/prediction/smooth_output.h"

namespace fyd::sim {

struct TeleopEndSettings {
  bool at_hand = true;  ///< otherwise far
  teleop::CouplingChoice coupling = teleop::CouplingChoice::model;
  teleop::CouplingSettings coupling_settings;
  teleop::PredictorChoice predictor = teleop::PredictorChoice::experts;
  std::optional<double> smooth_s;  ///< of corrections; none: defaultSmoothing_s(period, age of the first message)
  double period_s = 0.010;         ///< of messages; with a deadband, of what the predictor is given
  std::optional<double> lost_s;    ///< without a message; none: TeleopEnd::kLost_s
  double deadband = 0.0;           ///< smallest relative difference that can be felt, 0 … 1; 0: a message each period
};

struct DeviceState {
  Vec3 position_mm;
  Vec3 velocity_mm_per_s;
  Vec3 force_N;  ///< measured, on what is touched
  protocol::Orientation orientation;
};

class TeleopEnd {
 public:
  enum class Phase : std::uint8_t { stopped, waiting, linked, lost };
  static constexpr double kLost_s = 0.5;  ///< without a message, unless the settings say another time
  static constexpr int kFarewells = 3;
  /// With a deadband: smaller differences are never sent; ten messages in a row must be lost before the phase is
  /// `lost`.
  static constexpr double kPlaceFloor_mm = 0.1, kForceFloor_N = 0.1, kRefresh_s = 0.1 * kLost_s;

  explicit TeleopEnd(const TeleopEndSettings& settings);

  /// @param session another number with each start
  void start(std::uint16_t session);
  void stop();

  void receive(std::span<const std::uint8_t> datagram, double now_s);
  /// A millisecond. @return the force of the device's motors, N; none for a state that is no measurement (NaN)
  [[nodiscard]] Vec3 step(const DeviceState& device, double now_s);
  /// The datagram to send now, if one is due.
  [[nodiscard]] std::span<const std::uint8_t> datagram(double now_s);

  [[nodiscard]] Phase phase() const { return phase_; }
  /// The other device's predicted position and orientation; while linked.
  [[nodiscard]] const teleop::Position& other_mm() const { return other_mm_; }
  [[nodiscard]] const teleop::Orientation& otherOrientation() const { return other_orientation_; }
  /// Time constant of the corrections of `other_mm`; while linked.
  [[nodiscard]] double smoothing_s() const { return smooth_.timeConstant_s(); }
  /// With a deadband: what is known of the other device at a moment: position (mm) and force (N); and the bands.
  [[nodiscard]] teleop::DeadbandReceiver::Answer told(double date_s) const { return receiver_.at(date_s); }
  [[nodiscard]] const teleop::DeadbandChannels& channels() const { return channels_; }
  /// Over the three axes.
  [[nodiscard]] teleop::CouplingTelemetry telemetry() const;

 private:
  void link(const protocol::DeviceMessage& first, double now_s);
  void hear(const protocol::DeviceMessage& message);
  [[nodiscard]] bool surfaceIsAnother(const protocol::DeviceMessage& message) const;

  TeleopEndSettings settings_;
  protocol::PositionCode code_;
  Phase phase_ = Phase::stopped;
  std::uint16_t session_ = 0, other_session_ = 0;
  std::optional<std::uint16_t> ended_;  ///< the other's session that was stopped
  double heard_s_ = 0.0;
  double next_s_ = -1e300;  ///< of the next datagram
  int farewells_ = 0;
  std::array<std::unique_ptr<teleop::CouplingEnd>, 3> couplings_;
  std::unique_ptr<teleop::Predictor> predictor_;
  teleop::OrientationPredictor turning_;
  teleop::SmoothOutput smooth_;
  teleop::DeadbandChannels channels_;
  teleop::DeadbandSender sender_;
  teleop::DeadbandReceiver receiver_;
  std::optional<double> fed_s_;  ///< date of the last position given to the predictor
  std::array<teleop::CouplingMessage, 3> told_axes_;
  protocol::DeviceMessage newest_;
  DeviceState device_;
  teleop::Position apart_mm_{};
  bool apart_known_ = false;
  double stepped_s_ = 0.0;
  teleop::Position other_mm_{};
  teleop::Orientation other_orientation_;
  std::array<std::uint8_t, protocol::kMostDeviceMessage> bytes_{};
};

}  // namespace fyd::sim
