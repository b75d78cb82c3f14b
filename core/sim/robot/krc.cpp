#include "core/sim/robot/krc.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fyd::sim {
namespace {

using protocol::FriQuality;
using protocol::FriState;

constexpr Vec3 kStart_m{0.5, 0.0, 0.3};
constexpr protocol::FriJoints kJoints = {0.0F, 0.52F, 0.0F, -1.57F, 0.0F, 1.05F, 0.0F};
constexpr protocol::FriJoints kJointOffsets = {0.01F, 0.0F, 0.0F, -0.01F, 0.0F, 0.0F, 0.02F};
constexpr float kMirrorTolerance_rad = 1e-5F;
constexpr double kLeastLeap_mm = 1.0;
constexpr Duration kPublishEvery = std::chrono::milliseconds(50);
constexpr std::uint16_t kAllDrives = 0x7F;
constexpr std::uint32_t kImpedanceFlags =
    protocol::fri_flag::kFrame | protocol::fri_flag::kCartesianStiffness | protocol::fri_flag::kCartesianDamping;

protocol::FriFrame frameAt(const Vec3& arm_mm) {
  const auto metres = [](double start, double mm) { return static_cast<float>(start + 0.001 * mm); };
  return {1, 0,  0,  metres(kStart_m.x, -arm_mm.y),  //
          0, -1, 0,  metres(kStart_m.y, -arm_mm.x),  //
          0, 0,  -1, metres(kStart_m.z, arm_mm.z)};
}

Vec3 armAt(const protocol::FriFrame& frame) {
  return {-1000.0 * (frame[7] - kStart_m.y), -1000.0 * (frame[3] - kStart_m.x), 1000.0 * (frame[11] - kStart_m.z)};
}

bool mirrors(const protocol::FriJoints& joints) {
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (std::abs(joints[i] - (kJoints[i] + kJointOffsets[i])) > kMirrorTolerance_rad) return false;
  }
  return true;
}

}  // namespace

Result<std::unique_ptr<Krc>> Krc::open(const KrcOptions& options) {
  if (!(options.period_ms >= 1.0 && options.period_ms <= 100.0)) {
    return fail("KRC: period {} ms; expected 1 to 100", options.period_ms);
  }
  if (options.remote.port == 0) {
    return fail("KRC: the remote's address {} has no port to send to", protocol::toString(options.remote));
  }
  if (options.remote.v6 != options.bind.v6) {
    return fail("KRC: {} cannot reach {}: both must be IPv4 or both IPv6", protocol::toString(options.bind),
                protocol::toString(options.remote));
  }
  if (!(options.jump_limit_mm_s > 0.0)) return fail("KRC: leap {} mm/s; expected more than 0", options.jump_limit_mm_s);
  auto socket = protocol::UdpSocket::open(options.bind);
  if (!socket) return tl::unexpected(socket.error());
  return std::unique_ptr<Krc>(new Krc(options, std::move(*socket)));
}

Krc::Krc(const KrcOptions& options, protocol::UdpSocket socket)
    : options_(options), socket_(std::move(socket)), arm_(options.arm), buffer_(protocol::kMaximumDatagram) {
  std::ranges::stable_sort(options_.modes, {}, &TimedMode::at_s);
  const auto period_s = static_cast<float>(0.001 * options.period_ms);
  measurement_.measurement_period_s = period_s;
  measurement_.command_period_s = period_s;
  measurement_.power = kAllDrives;
  measurement_.control = protocol::FriControl::cartesian_impedance;
  measurement_.joints = kJoints;
  measurement_.commanded_joints = kJoints;
  measurement_.joint_offsets = kJointOffsets;
  measurement_.temperatures_C.fill(30.0F);
  now_.local = socket_.local();
  shown_ = now_;
}

void Krc::run(const std::stop_token& stop, Duration limit) {
  began_ = good_since_ = Clock::now();
  const Duration period = fromSeconds(0.001 * options_.period_ms);
  Instant due = began_;
  for (Instant now = began_; !stop.stop_requested() && now - began_ < limit; now = Clock::now()) {
    moveArm(now);
    chooseMode(now);
    send(now);
    if (now - published_ >= kPublishEvery) publish(now);
    due = std::max(due + period, now);  // missed periods are not made up for
    receiveUntil(due);
    mark(answered_);
  }
  publish(Clock::now());
}

KrcStatus Krc::status() const {
  const std::lock_guard lock(mutex_);
  return shown_;
}

void Krc::moveArm(Instant now) {
  const auto readings = arm_.exchange(target_mm_, now);
  if (!readings) return;  // the codec accepts finite targets only
  now_.position_mm = readings->position_mm;
  now_.force_N = readings->force_N;
  now_.largest_force_N = std::max(now_.largest_force_N, readings->force_N);
  now_.lowest_z_mm = std::min(now_.lowest_z_mm, readings->position_mm.z);
  measurement_.frame = frameAt(readings->position_mm);
  measurement_.commanded_frame = frameAt(target_mm_);
  measurement_.force_torque = {0, 0, static_cast<float>(readings->force_N), 0, 0, 0};
  measurement_.krl.reals[0] = static_cast<float>(readings->acceleration_g.x);
  measurement_.krl.reals[1] = static_cast<float>(readings->acceleration_g.y);
  measurement_.krl.reals[2] = static_cast<float>(readings->acceleration_g.z);
}

void Krc::chooseMode(Instant now) {
  const bool good = now_.quality >= FriQuality::good;
  if (!good) good_since_ = now;
  const double at_s = toSeconds(now - began_);
  for (; next_mode_ < options_.modes.size() && options_.modes[next_mode_].at_s <= at_s; ++next_mode_) {
    mode_is_timed_ = true;
    enter(options_.modes[next_mode_].mode, now);
  }
  if (mode_is_timed_) return;
  if (now_.mode == FriState::command && !good) {
    ++now_.counters.command_losses;
    enter(FriState::monitor, now);
  } else if (now_.mode == FriState::monitor && now - good_since_ >= fromSeconds(options_.monitor_for_s) && good) {
    enter(FriState::command, now);
  }
}

void Krc::enter(FriState mode, Instant now) {
  if (mode == now_.mode) return;
  now_.mode = mode;
  good_since_ = now;
  obeyed_ = false;
  if (mode == FriState::command) ++now_.counters.command_entries;
}

void Krc::send(Instant now) {
  ++measurement_.header.sequence;
  measurement_.time_s = static_cast<float>(toSeconds(now - began_));
  measurement_.state = now_.mode;
  measurement_.quality = now_.quality;
  measurement_.answer_rate = static_cast<float>(now_.answer_rate);
  measurement_.latency_s = static_cast<float>(0.001 * now_.latency_ms);
  measurement_.miss_rate = 1.0F - measurement_.answer_rate;
  answered_ = false;
  sent_at_ = now;
  ++now_.counters.measurements;
  const auto bytes = protocol::encodeFriMeasurement(measurement_);
  if (socket_.send(bytes, options_.remote) != protocol::SendOutcome::sent) ++now_.counters.send_failures;
}

void Krc::receiveUntil(Instant deadline) {
  do {
    const auto received = socket_.receive(buffer_, std::max(deadline - Clock::now(), Duration::zero()));
    if (!received) return;
    if (!(received->from == options_.remote)) {
      ++now_.counters.wrong_peer;
    } else if (decodeFriCommand({buffer_.data(), received->size}, incoming_) != protocol::FriRefusal::none) {
      ++now_.counters.refused;
    } else {
      judge(incoming_, Clock::now());
    }
  } while (Clock::now() < deadline);
}

void Krc::judge(const protocol::FriCommand& command, Instant now) {
  const auto behind = static_cast<std::uint16_t>(measurement_.header.sequence - command.header.reflected);
  if (behind == 0 && !answered_) {
    answered_ = true;
    ++now_.counters.answers;
    now_.latency_ms = toMilliseconds(now - sent_at_);
    measurement_.header.reflected = command.header.sequence;
    obey(command);
  } else if (behind > 0 && behind < now_.counters.measurements && behind < 0x8000) {
    ++now_.counters.late_answers;
  } else {
    ++now_.counters.wrong_echoes;
  }
}

void Krc::obey(const protocol::FriCommand& command) {
  if (now_.mode != FriState::command) {
    if ((command.flags & protocol::fri_flag::kJoints) == 0 || !mirrors(command.joints)) ++now_.counters.wrong_mirrors;
    return;
  }
  if ((command.flags & kImpedanceFlags) != kImpedanceFlags) {
    ++now_.counters.wrong_flags;
    return;
  }
  const Vec3 wanted_mm = armAt(command.frame);
  const double force_over_stiffness_mm = (wanted_mm - target_mm_).norm();
  const double since_s = obeyed_ ? toSeconds(sent_at_ - obeyed_at_) : 0.0;
  if (force_over_stiffness_mm > kLeastLeap_mm + options_.jump_limit_mm_s * since_s) {
    ++now_.counters.leaps;
    ++now_.counters.command_losses;
    enter(FriState::monitor, sent_at_);
    return;
  }
  if (since_s > 0.0) now_.fastest_mm_s = std::max(now_.fastest_mm_s, force_over_stiffness_mm / since_s);
  obeyed_ = true;
  obeyed_at_ = sent_at_;
  now_.travelled_mm += force_over_stiffness_mm;
  target_mm_ = wanted_mm;
  now_.stiffness_N_per_m = command.cartesian_stiffness[2];
  now_.rotation_stiffness_Nm_per_rad = command.cartesian_stiffness[3];
  now_.damping = command.cartesian_damping[2];
}

void Krc::mark(bool answered) {
  marks_[next_mark_] = answered;
  next_mark_ = (next_mark_ + 1) % kWindow;
  // Before the window is full, the measurements not yet sent count as unanswered: the quality starts low.
  now_.answer_rate = static_cast<double>(std::ranges::count(marks_, true)) / kWindow;
  if (now_.answer_rate >= 0.98) {
    now_.quality = FriQuality::perfect;
  } else if (now_.answer_rate >= 0.90) {
    now_.quality = FriQuality::good;
  } else {
    now_.quality = now_.answer_rate >= 0.50 ? FriQuality::bad : FriQuality::unacceptable;
  }
}

void Krc::publish(Instant now) {
  published_ = now;
  now_.seconds = toSeconds(now - began_);
  const std::lock_guard lock(mutex_);
  shown_ = now_;
}

}  // namespace fyd::sim
