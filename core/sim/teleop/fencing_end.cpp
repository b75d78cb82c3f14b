#include "core/sim/teleop/fencing_end.h"

#include "core/teleop/coupling/coupling_choice.h"

#include <algorithm>

namespace fyd::sim {
namespace {

constexpr double kPeriodsUntilLost = 4.0;

TeleopEndSettings linkOf(const FencingSettings& settings) {
  TeleopEndSettings out;
  out.coupling = teleop::CouplingChoice::spring;
  out.predictor = settings.predictor;
  out.smooth_s = settings.smooth_s;
  out.period_s = settings.players.period_s;
  out.lost_s = std::max(TeleopEnd::kLost_s, kPeriodsUntilLost * settings.players.period_s);
  return out;
}

/// The device's own x axis, a unit vector.
Vec3 forward(const teleop::Orientation& q) {
  return {1.0 - 2.0 * (q.y * q.y + q.z * q.z), 2.0 * (q.x * q.y + q.w * q.z), 2.0 * (q.x * q.z - q.w * q.y)};
}

}  // namespace

scene::Blade swordOf(const FencingSettings& settings, const Vec3& device_mm, const teleop::Orientation& turned) {
  const Vec3 grip = settings.players.scale * device_mm;
  return {grip, grip + settings.swords.length_mm * forward(turned)};
}

Vec3 asTheOtherSees(const Vec3& force_N) { return {-force_N.x, -force_N.y, force_N.z}; }

scene::Blade asTheOtherSees(const FencingSettings& settings, const scene::Blade& blade) {
  return scene::seenByTheOther(settings.players, blade);
}

FencingEnd::FencingEnd(const FencingSettings& settings) : settings_(settings), link_(linkOf(settings)) {}

void FencingEnd::receive(std::span<const std::uint8_t> datagram, double now_s) {
  link_.receive(datagram, now_s);
  corrected_ = true;
}

scene::Blade FencingEnd::believed(double now_s) {
  const double length_mm = settings_.swords.length_mm, dt_s = now_s - stepped_s_.value_or(now_s);
  const Vec3 along = length_mm * forward(link_.otherOrientation());
  const teleop::Position predicted{along.x, along.y, along.z};
  // Rate of change of the predicted direction, without the jump at a new message.
  if (!corrected_ && dt_s > 0.0) {
    for (std::size_t a = 0; a < predicted.size(); ++a) along_mm_per_s_[a] = (predicted[a] - along_mm_[a]) / dt_s;
  }
  along_mm_ = predicted;
  corrected_ = false;
  const teleop::Position smoothed = smooth_.step(now_s, predicted, along_mm_per_s_);
  const Vec3 direction = scene::unit({smoothed[0], smoothed[1], smoothed[2]});
  const teleop::Position& at = link_.other_mm();
  const Vec3 grip = settings_.players.scale * Vec3{at[0], at[1], at[2]};
  return asTheOtherSees(settings_, {grip, grip + length_mm * direction});
}

scene::SwordTouch FencingEnd::step(const DeviceState& device, double now_s) {
  static_cast<void>(link_.step(device, now_s));
  if (link_.phase() != TeleopEnd::Phase::linked) {
    state_ = {};
    stepped_s_.reset();
    return {};
  }
  if (!stepped_s_) {
    smooth_ = teleop::SmoothOutput(link_.smoothing_s());
    along_mm_per_s_ = {};
    corrected_ = true;
  }
  const auto& angles = device.orientation;
  const scene::Blade own =
      swordOf(settings_, device.position_mm, teleop::fromAngles(angles.alpha_rad, angles.beta_rad, angles.gamma_rad));
  const scene::Blade other = believed(now_s);
  const double dt_s = stepped_s_ ? now_s - *stepped_s_ : 1e-3;
  stepped_s_ = now_s;
  return scene::stepSwords(settings_.swords, state_, own, other, dt_s);
}

}  // namespace fyd::sim
