// One player of the tele-gesture paper's game of swords: the player's own sword, the other player's as predicted for
// now, and the force of their contact on the own hand, at 1 kHz.
//
// The players are connected as two linked devices (teleop_end.h): each sends its device's position and orientation,
// x, y, z, α, β, γ, and a date; the received ones are predicted to now and smoothed, position and direction alike. The
// device's coupling exerts no force here: only the swords touch.
//
// Each player is at the origin of an own frame, with the other `players.apart_mm` away along x, facing it: the other's
// x and y are reversed. A sword's grip is at `players.scale` times the device's position, its blade along the device's
// own x.
#pragma once

#include "core/scene/gesture/swords.h"
#include "core/sim/teleop/teleop_end.h"
#include "core/teleop/prediction/predictor_choice.h"

namespace fyd::sim {

struct FencingSettings {
  scene::SwordParameters swords;
  scene::FencingParameters players;
  teleop::PredictorChoice predictor = teleop::PredictorChoice::experts;  ///< the paper's is order1
  std::optional<double> smooth_s;                                        ///< as of TeleopEndSettings
};

/// Where a player's sword is, in the player's own frame and in the other's.
[[nodiscard]] scene::Blade swordOf(const FencingSettings& settings, const Vec3& device_mm,
                                   const teleop::Orientation& turned);
[[nodiscard]] scene::Blade asTheOtherSees(const FencingSettings& settings, const scene::Blade& blade);
[[nodiscard]] Vec3 asTheOtherSees(const Vec3& force_N);

class FencingEnd {
 public:
  /// @param settings whose parameters checkParameters accepts
  explicit FencingEnd(const FencingSettings& settings);

  /// As of TeleopEnd.
  void start(std::uint16_t session) {
    link_.start(session);
    stepped_s_.reset();
    state_ = {};
  }
  void stop() { link_.stop(); }
  void receive(std::span<const std::uint8_t> datagram, double now_s);
  [[nodiscard]] std::span<const std::uint8_t> datagram(double now_s) { return link_.datagram(now_s); }
  [[nodiscard]] TeleopEnd::Phase phase() const { return link_.phase(); }

  /// A millisecond. Nothing is touched while the players are not linked, or the device measures nothing.
  /// @param device its measured force is not used
  [[nodiscard]] scene::SwordTouch step(const DeviceState& device, double now_s);

  /// As of the last step.
  [[nodiscard]] const scene::Blade& own() const { return state_.local; }
  [[nodiscard]] const scene::Blade& other() const { return state_.distant; }

 private:
  /// The other player's blade, as predicted for now.
  [[nodiscard]] scene::Blade believed(double now_s);

  FencingSettings settings_;
  TeleopEnd link_;
  scene::SwordState state_;
  bool corrected_ = true;  ///< a message has come since the last step
  std::optional<double> stepped_s_;
  teleop::SmoothOutput smooth_{0.0};
  teleop::Position along_mm_{}, along_mm_per_s_{};  ///< the other blade, as predicted
};

}  // namespace fyd::sim
