#include "core/sim/teleop_end.h"

#include <algorithm>
#include <cmath>

#include "core/sim/desktop_arm.h"

namespace fyd::sim {
namespace {

using teleop::Position;

constexpr double kClosing_mm_per_s = 50.0;
constexpr double kBrake_N_s_per_m = 5.0;

Position positionOf(const Vec3& v) { return {v.x, v.y, v.z}; }

}  // namespace

TeleopEnd::TeleopEnd(const TeleopEndSettings& settings)
    : settings_(settings),
      code_(*protocol::PositionCode::make(DesktopArm::workspace())),
      turning_(settings.predictor, settings.period_s),
      smooth_(settings.smooth_s) {}

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

void TeleopEnd::link(const DeviceMessage& first) {
  other_session_ = first.session;
  for (auto& each : couplings_) {
    each = settings_.at_hand ? teleop::makeHandEnd(settings_.coupling, settings_.coupling_settings)
                             : teleop::makeFarEnd(settings_.coupling, settings_.coupling_settings);
  }
  predictor_ = teleop::makePredictor(settings_.predictor, {.axes = 3, .period_s = settings_.period_s});
  turning_ = teleop::OrientationPredictor(settings_.predictor, settings_.period_s);
  smooth_.reset();
  newest_ = first;
  apart_known_ = false;
  phase_ = Phase::linked;
}

void TeleopEnd::receive(std::span<const std::uint8_t> datagram, double now_s) {
  const auto message = decodeDeviceMessage(datagram, code_);
  if (!message || phase_ == Phase::stopped) return;
  if (ended_ == message->session) return;  // overtaken by the farewell
  if (!message->running) {
    ended_ = message->session;
    if (phase_ == Phase::linked && message->session == other_session_) phase_ = Phase::waiting;
    return;
  }
  heard_s_ = now_s;
  if (phase_ != Phase::linked || message->session != other_session_) link(*message);
  if (message->date_s >= newest_.date_s) newest_ = *message;
  predictor_->message(message->date_s, positionOf(message->position_mm));
  turning_.message(message->date_s, teleop::fromAngles(message->orientation.alpha_rad, message->orientation.beta_rad,
                                                       message->orientation.gamma_rad));
}

Vec3 TeleopEnd::step(const DeviceState& device, double now_s) {
  device_ = device;
  if (phase_ == Phase::linked && now_s - heard_s_ > kLost_s) phase_ = Phase::lost;
  const Vec3& v = device.velocity_mm_per_s;
  if (phase_ != Phase::linked) {
    return settings_.at_hand ? Vec3{} : (-1e-3 * kBrake_N_s_per_m) * v;
  }
  const Position own = positionOf(device.position_mm), speed = positionOf(v), force = positionOf(device.force_N);
  other_mm_ = smooth_.step(now_s, predictor_->predict(now_s), predictor_->velocity(now_s));
  other_orientation_ = turning_.predict(now_s);
  if (!apart_known_) {
    for (std::size_t a = 0; a < 3; ++a) apart_mm_[a] = settings_.at_hand ? 0.0 : own[a] - other_mm_[a];
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

std::span<const std::uint8_t> TeleopEnd::datagram(double now_s) {
  if (phase_ == Phase::stopped && farewells_ == 0) return {};
  if (now_s < next_s_ - 1e-9) return {};
  next_s_ = std::max(next_s_ + settings_.period_s, now_s + 0.5 * settings_.period_s);
  DeviceMessage message{.session = session_,
                        .running = phase_ != Phase::stopped,
                        .date_s = now_s,
                        .position_mm = device_.position_mm,
                        .orientation = device_.orientation,
                        .force_N = device_.force_N,
                        .tells_energy = settings_.coupling == teleop::CouplingChoice::tdpa,
                        .axes = {}};
  if (!message.running) --farewells_;
  if (phase_ == Phase::linked) {
    for (std::size_t a = 0; a < 3; ++a) message.axes[a] = couplings_[a]->message();
  }
  return std::span<const std::uint8_t>(bytes_).first(encode(message, code_, bytes_));
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
