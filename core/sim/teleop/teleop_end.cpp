#include "core/sim/teleop/teleop_end.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/sim/teleop/desktop_arm.h"
#include "core/teleop/coupling/coupling_choice.h"
#include "core/teleop/prediction/predictor_choice.h"

namespace fyd::sim {
namespace {

using teleop::Position;

constexpr double kClosing_mm_per_s = 50.0;
constexpr double kBrake_N_s_per_m = 5.0;

constexpr std::size_t kForces = 3;  // the first channel of the force
constexpr int kMostTold = 64;       // positions given to the predictor at once, after a silence

Position positionFrom(const Vec3& v) { return {v.x, v.y, v.z}; }

/// Whether a state can be a measurement: finite, and within the range of a device on a table.
bool isMeasurement(const DeviceState& device) {
  for (std::size_t a = 0; a < 3; ++a) {
    const double at_m = 1e-3 * positionFrom(device.position_mm)[a],
                 v = 1e-3 * positionFrom(device.velocity_mm_per_s)[a];
    if (!teleop::isPlace(at_m) || !(std::abs(v) <= teleop::kFastest_m_per_s)) return false;
    if (!std::isfinite(positionFrom(device.force_N)[a])) return false;
  }
  return true;
}

teleop::DeadbandChannels channelsOf(double share) {
  teleop::DeadbandChannels out{};
  for (std::size_t a = 0; a < 3; ++a) {
    out[a] = {.fraction = share, .floor = TeleopEnd::kPlaceFloor_mm, .moves = true};
    out[kForces + a] = {.fraction = share, .floor = TeleopEnd::kForceFloor_N};
  }
  return out;
}

teleop::DeadbandValues values(const Vec3& place, const Vec3& force) {
  return {place.x, place.y, place.z, force.x, force.y, force.z};
}

}  // namespace

TeleopEnd::TeleopEnd(const TeleopEndSettings& settings)
    : settings_(settings),
      code_(*protocol::PositionCode::make(DesktopArm::workspace())),
      turning_(settings.predictor, settings.period_s),
      smooth_(0.0),
      channels_(channelsOf(settings.deadband)),
      sender_(channels_, kRefresh_s, protocol::DeviceMessage::kEarlier + 1) {}

void TeleopEnd::start(std::uint16_t session) {
  session_ = session;
  phase_ = Phase::waiting;
  next_s_ = -1e300;
  farewells_ = 0;
  ended_.reset();
}

void TeleopEnd::stop() {
  if (phase_ == Phase::stopped) return;
  phase_ = Phase::stopped;
  farewells_ = kFarewells;
}

void TeleopEnd::link(const protocol::DeviceMessage& first, double now_s) {
  other_session_ = first.session;
  for (auto& each : couplings_) {
    each = settings_.at_hand ? teleop::makeHandEnd(settings_.coupling, settings_.coupling_settings)
                             : teleop::makeFarEnd(settings_.coupling, settings_.coupling_settings);
  }
  predictor_ = teleop::makePredictor(settings_.predictor, {.axes = 3, .period_s = settings_.period_s});
  turning_ = teleop::OrientationPredictor(settings_.predictor, settings_.period_s);
  smooth_ = teleop::SmoothOutput(
      settings_.smooth_s.value_or(teleop::defaultSmoothing_s(settings_.period_s, now_s - first.date_s)));
  receiver_ = {};
  fed_s_.reset();
  newest_ = first;
  apart_known_ = false;
  phase_ = Phase::linked;
}

void TeleopEnd::receive(std::span<const std::uint8_t> datagram, double now_s) {
  const auto message = protocol::decodeDeviceMessage(datagram, code_);
  if (!message || phase_ == Phase::stopped) return;
  if (ended_ == message->session) return;         // overtaken by the farewell
  if (message->date_s > now_s + kLost_s) return;  // a wrong date: it would stay the newest for that long
  if (!message->running) {
    ended_ = message->session;
    if (phase_ == Phase::linked && message->session == other_session_) phase_ = Phase::waiting;
    return;
  }
  const bool another = message->session != other_session_;
  if (phase_ == Phase::linked && another && message->date_s < newest_.date_s) return;  // overtaken by a new start
  heard_s_ = now_s;
  if (phase_ != Phase::linked || another) link(*message, now_s);
  if (message->date_s >= newest_.date_s) newest_ = *message;
  hear(*message);
  turning_.message(message->date_s, teleop::fromAngles(message->orientation.alpha_rad, message->orientation.beta_rad,
                                                       message->orientation.gamma_rad));
}

void TeleopEnd::hear(const protocol::DeviceMessage& message) {
  if (message.number > 0) {
    teleop::DeadbandPacket packet;
    auto number = message.number - static_cast<std::uint32_t>(message.earlier.size());
    const auto add = [&](const protocol::DeviceSample& each) {
      static_cast<void>(packet.push({.number = number++,
                                     .date_s = each.date_s,
                                     .value = values(each.position_mm, each.force_N),
                                     .slope = values(each.velocity_mm_per_s, {})}));
    };
    for (const protocol::DeviceSample& each : message.earlier) add(each);
    add({message.date_s, message.position_mm, message.velocity_mm_per_s, message.force_N});
    receiver_.receive(packet);
    // The positions that a message each period would have carried, to within the band.
    if (fed_s_) {
      const double from_s = std::max(*fed_s_, message.date_s - kMostTold * settings_.period_s);
      double date_s = from_s + settings_.period_s;
      while (date_s < message.date_s - 0.5 * settings_.period_s) {  // half a period: no rounding adds a step
        std::array<std::optional<double>, 3> at;
        for (std::size_t a = 0; a < at.size(); ++a) at[a] = receiver_.place(date_s, a, channels_[a]);
        if (at[0] && at[1] && at[2]) predictor_->message(date_s, {*at[0], *at[1], *at[2]});
        date_s += settings_.period_s;
      }
    }
    fed_s_ = std::max(fed_s_.value_or(message.date_s), message.date_s);
  }
  predictor_->message(message.date_s, positionFrom(message.position_mm));
}

Vec3 TeleopEnd::step(const DeviceState& device, double now_s) {
  if (isMeasurement(device)) device_ = device;
  if (phase_ == Phase::linked && now_s - heard_s_ > settings_.lost_s.value_or(kLost_s)) phase_ = Phase::lost;
  if (!isMeasurement(device)) {
    if (phase_ == Phase::linked) {
      constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
      // They learn that no force is exerted, or they would count its work as long as nothing is measured.
      for (const auto& each : couplings_) static_cast<void>(each->step({.time_s = now_s, .position_m = kUnknown}));
    }
    return {};
  }
  const Vec3& v = device.velocity_mm_per_s;
  if (phase_ != Phase::linked) {
    const double most = settings_.coupling_settings.most_force_N;
    const auto brake = [&](double speed) { return std::clamp(-1e-3 * kBrake_N_s_per_m * speed, -most, most); };
    return settings_.at_hand ? Vec3{} : Vec3{brake(v.x), brake(v.y), brake(v.z)};
  }
  const Position own = positionFrom(device.position_mm), speed = positionFrom(v), force = positionFrom(device.force_N);
  other_mm_ = smooth_.step(now_s, predictor_->predict(now_s), predictor_->velocity(now_s));
  other_orientation_ = turning_.predict(now_s);
  if (!apart_known_) {
    for (std::size_t a = 0; a < 3; ++a) apart_mm_[a] = own[a] - other_mm_[a];
    apart_known_ = true;
    stepped_s_ = now_s;
  }
  const double closer_mm = kClosing_mm_per_s * std::clamp(now_s - stepped_s_, 0.0, 0.01);
  stepped_s_ = now_s;
  Position out{};
  for (std::size_t a = 0; a < 3; ++a) {
    apart_mm_[a] -= std::clamp(apart_mm_[a], -closer_mm, closer_mm);
    teleop::CouplingMessage message = newest_.axes[a];
    message.date_s = now_s;
    message.position_m = 1e-3 * (other_mm_[a] + apart_mm_[a]);
    couplings_[a]->receive(message);
    out[a] = couplings_[a]->step(
        {.time_s = now_s, .position_m = 1e-3 * own[a], .velocity_m_per_s = 1e-3 * speed[a], .measured_N = force[a]});
    if (settings_.at_hand) out[a] = -out[a];  // the coupling's force pushes the hand back
  }
  return {out[0], out[1], out[2]};
}

/// Whether the surface differs from the last one sent by more than the deadband.
bool TeleopEnd::surfaceIsAnother(const protocol::DeviceMessage& message) const {
  const double share = settings_.deadband;
  for (std::size_t a = 0; a < message.axes.size(); ++a) {
    const teleop::CouplingMessage &now = message.axes[a], &told = told_axes_[a];
    if (now.knows_surface != told.knows_surface) return true;
    if (!now.knows_surface) continue;
    const double moved_N = told.stiffness_N_per_m * std::abs(now.surface_m - told.surface_m);
    if (std::abs(now.stiffness_N_per_m - told.stiffness_N_per_m) > share * told.stiffness_N_per_m) return true;
    if (moved_N > std::max(kForceFloor_N, share * std::abs(positionFrom(message.force_N)[a]))) return true;
  }
  return false;
}

std::span<const std::uint8_t> TeleopEnd::datagram(double now_s) {
  if (phase_ == Phase::stopped && farewells_ == 0) return {};
  const bool feels = settings_.deadband > 0.0 && phase_ == Phase::linked;  // checks for changes at each call
  if (!feels && now_s < next_s_ - 1e-9) return {};
  protocol::DeviceMessage message{.session = session_,
                                  .running = phase_ != Phase::stopped,
                                  .date_s = now_s,
                                  .position_mm = device_.position_mm,
                                  .orientation = device_.orientation,
                                  .force_N = device_.force_N,
                                  .tells_energy = settings_.coupling == teleop::CouplingChoice::tdpa,
                                  .velocity_mm_per_s = device_.velocity_mm_per_s,
                                  .earlier = {},
                                  .axes = {}};
  if (phase_ == Phase::linked) {
    for (std::size_t a = 0; a < 3; ++a) message.axes[a] = couplings_[a]->message();
  }
  if (settings_.deadband > 0.0) {
    const auto packet = sender_.step(now_s, values(device_.position_mm, device_.force_N),
                                     values(device_.velocity_mm_per_s, {}), !feels || surfaceIsAnother(message));
    if (!packet) return {};
    for (const teleop::DeadbandSample& each : *packet) {
      const auto &x = each.value, &v = each.slope;
      message.number = each.number;
      if (each.number == packet->view().back().number) break;
      static_cast<void>(
          message.earlier.push({each.date_s, {x[0], x[1], x[2]}, {v[0], v[1], v[2]}, {x[3], x[4], x[5]}}));
    }
    told_axes_ = message.axes;
  }
  next_s_ = std::max(next_s_ + settings_.period_s, now_s + 0.5 * settings_.period_s);
  if (!message.running) --farewells_;
  const auto out = std::span<const std::uint8_t>(bytes_).first(encode(message, code_, bytes_));
  if (message.number > 0) {
    const auto read = protocol::decodeDeviceMessage(out, code_);
    if (read) sender_.told(values(read->position_mm, read->force_N), values(read->velocity_mm_per_s, {}));
  }
  return out;
}

teleop::CouplingTelemetry TeleopEnd::telemetry() const {
  teleop::CouplingTelemetry out;
  for (const auto& each : couplings_) {
    if (!each) continue;
    out.energy_J += each->telemetry().energy_J;
    out.dissipated_J += each->telemetry().dissipated_J;
  }
  return out;
}

}  // namespace fyd::sim
