#include "core/device/fri_robot.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fyd::device {
namespace {

using protocol::FriControl;
using protocol::FriFrame;
using protocol::FriQuality;
using protocol::FriRefusal;
using protocol::FriState;

constexpr double kMillimetres = 1000.0;
constexpr int kMostAtOnce = 64;  // datagrams in one exchange, so that a flood cannot keep it
constexpr double kFurthestYield_m = 0.03;
constexpr int kForceReadings = 100;
constexpr Duration kPeerGone = std::chrono::seconds(1);
constexpr std::array<std::size_t, 3> kTranslation = {3, 7, 11};

Vec3 translation(const FriFrame& frame) {
  return {frame[kTranslation[0]], frame[kTranslation[1]], frame[kTranslation[2]]};
}

bool sameHost(const protocol::Endpoint& a, const protocol::Endpoint& b) {
  return a.v6 == b.v6 && a.address == b.address && a.scope == b.scope;
}

double component(const Vec3& v, int axis) { return axis == 1 ? v.x : (axis == 2 ? v.y : v.z); }

}  // namespace

Vec3 AxisMap::toBase(const Vec3& ours) const {
  const auto along = [&](int axis) { return std::copysign(1.0, axis) * component(ours, std::abs(axis)); };
  return {along(base_from_ours[0]), along(base_from_ours[1]), along(base_from_ours[2])};
}

Vec3 AxisMap::toOurs(const Vec3& base) const {
  std::array<double, 3> ours{};
  for (int i = 0; i < 3; ++i) {
    const int axis = base_from_ours[static_cast<std::size_t>(i)];
    ours[static_cast<std::size_t>(std::abs(axis) - 1)] = std::copysign(1.0, axis) * component(base, i + 1);
  }
  return {ours[0], ours[1], ours[2]};
}

Result<AxisMap> parseAxisMap(std::string_view text) {
  const auto wrong = [&] { return fail("axes \"{}\": expected x, y and z once each, such as -y,-x,z", text); };
  AxisMap map;
  std::array<bool, 3> used{};
  std::string_view rest = text;
  for (std::size_t i = 0; i < 3; ++i) {
    const int sign = rest.starts_with('-') ? -1 : 1;
    if (sign < 0) rest.remove_prefix(1);
    if (rest.empty() || rest[0] < 'x' || rest[0] > 'z') return wrong();
    const int axis = rest[0] - 'x';
    if (std::exchange(used[static_cast<std::size_t>(axis)], true)) return wrong();
    map.base_from_ours[i] = sign * (axis + 1);
    rest.remove_prefix(1);
    if (i < 2) {
      if (!rest.starts_with(',')) return wrong();
      rest.remove_prefix(1);
    }
  }
  if (!rest.empty()) return wrong();
  return map;
}

Result<std::unique_ptr<FriRobot>> FriRobot::open(const FriSettings& settings) {
  auto socket = protocol::UdpSocket::open(settings.bind);
  if (!socket) return tl::unexpected(socket.error());
  return std::unique_ptr<FriRobot>(new FriRobot(settings, std::move(*socket)));
}

FriRobot::FriRobot(const FriSettings& settings, protocol::UdpSocket socket)
    : settings_(settings), socket_(std::move(socket)), buffer_(protocol::kMaximumDatagram) {
  command_.cartesian_stiffness.fill(settings.stiffness_N_per_m);
  std::fill(command_.cartesian_stiffness.begin() + 3, command_.cartesian_stiffness.end(),
            settings.rotation_stiffness_Nm_per_rad);
  command_.cartesian_damping.fill(settings.damping);
}

std::string FriRobot::description() const {
  return fmt::format("KUKA LWR over FRI on {}", protocol::toString(socket_.local()));
}

Result<RobotReadings> FriRobot::exchange(const Vec3& target_mm, Instant now) {
  const bool good_target = target_mm.finite();
  holding_ = std::exchange(began_, false);
  if (now - heard_at_ > settings_.silence) moving_ = false;
  for (int i = 0; i < kMostAtOnce; ++i) {
    const auto received = socket_.receive(buffer_, Duration::zero());
    if (!received) break;
    if (!accept(received->from, now)) {
      ++counters_.wrong_peer;
      continue;
    }
    const FriRefusal refusal = protocol::decodeFriMeasurement({buffer_.data(), received->size}, incoming_);
    if (refusal != FriRefusal::none) {
      ++counters_.refused[static_cast<std::size_t>(refusal)];
      continue;
    }
    const bool same_session = peer_ && *peer_ == received->from;
    const auto ahead = static_cast<std::int16_t>(incoming_.header.sequence - newest_.header.sequence);
    if (same_session && ahead <= 0 && now - heard_at_ < kPeerGone) {
      ++counters_.out_of_order;
      continue;
    }
    peer_ = received->from;
    take(target_mm, now);
  }
  if (!good_target) {
    return fail("KRC: target ({}, {}, {}) mm: expected three finite numbers", target_mm.x, target_mm.y, target_mm.z);
  }
  if (!heard_ || now - heard_at_ > settings_.silence || !moving_ || began_) return reasonNotToFollow(now);
  return readings();
}

bool FriRobot::accept(const protocol::Endpoint& from, Instant now) {
  if (settings_.krc && !sameHost(*settings_.krc, from)) return false;
  return !peer_ || *peer_ == from || now - heard_at_ >= kPeerGone;
}

void FriRobot::take(const Vec3& target_mm, Instant now) {
  newest_ = incoming_;
  ++counters_.measurements;
  if (!heard_) origin_m_ = translation(newest_.commanded_frame);
  heard_ = true;
  heard_at_ = now;
  if (force_count_ < kForceReadings && (force_count_ == 0 || newest_.state != FriState::command)) {
    force_sum_N_ += pressedUp_N();
    ++force_count_;
  }
  answer(target_mm);
}

bool FriRobot::mayMove() const {
  return newest_.state == FriState::command && newest_.control == FriControl::cartesian_impedance &&
         newest_.error == 0 && newest_.quality >= FriQuality::good;
}

void FriRobot::answer(const Vec3& target_mm) {
  command_.header.reflected = newest_.header.sequence;
  ++command_.header.sequence;
  command_.flags = protocol::fri_flag::kJoints;
  for (std::size_t i = 0; i < command_.joints.size(); ++i) {
    command_.joints[i] = newest_.commanded_joints[i] + newest_.joint_offsets[i];
  }
  if (!mayMove()) {
    moving_ = false;
    // In command mode under a wrong strategy or with a failing line nothing new is asked for: the mirrored joints hold.
  } else {
    command_.flags =
        protocol::fri_flag::kFrame | protocol::fri_flag::kCartesianStiffness | protocol::fri_flag::kCartesianDamping;
    if (!moving_) {
      hold();
    } else if (!began_ && !holding_ && target_mm.finite()) {
      aimAt(target_mm, command_.frame);
    }
    moving_ = true;
  }
  const auto bytes = protocol::encodeFriCommand(command_);
  if (socket_.send(bytes, *peer_) == protocol::SendOutcome::sent) {
    ++counters_.answers;
  } else {
    ++counters_.send_failures;
  }
}

void FriRobot::hold() {
  ++counters_.command_entries;
  began_ = true;
  const double apart_m = (translation(newest_.commanded_frame) - translation(newest_.frame)).norm();
  held_frame_ = apart_m <= kFurthestYield_m ? newest_.commanded_frame : newest_.frame;
  command_.frame = held_frame_;
}

void FriRobot::aimAt(const Vec3& target_mm, FriFrame& frame) const {
  const Vec3 place = origin_m_ + settings_.axes.toBase((1.0 / kMillimetres) * target_mm);
  frame = held_frame_;
  frame[kTranslation[0]] = static_cast<float>(place.x);
  frame[kTranslation[1]] = static_cast<float>(place.y);
  frame[kTranslation[2]] = static_cast<float>(place.z);
}

Vec3 FriRobot::placeOf(const FriFrame& frame) const {
  return settings_.axes.toOurs(kMillimetres * (translation(frame) - origin_m_));
}

double FriRobot::pressedUp_N() const {
  return settings_.axes.toOurs({newest_.force_torque[0], newest_.force_torque[1], newest_.force_torque[2]}).z;
}

RobotReadings FriRobot::readings() const {
  const double rest_N = force_count_ > 0 ? force_sum_N_ / force_count_ : 0.0;
  return {.position_mm = placeOf(newest_.frame),
          .force_N = std::max(pressedUp_N() - rest_N, 0.0),
          .acceleration_g = {newest_.krl.reals[0], newest_.krl.reals[1], newest_.krl.reals[2]},
          .taken = heard_at_,
          .commanded_mm = placeOf(command_.frame)};
}

tl::unexpected<Error> FriRobot::reasonNotToFollow(Instant now) const {
  if (!heard_) {
    return fail("KRC: nothing heard on {}; expected a measurement every 1 to 100 ms: is FRI open on the controller?",
                protocol::toString(socket_.local()));
  }
  if (now - heard_at_ > settings_.silence) {
    return fail("KRC silent for {:.0f} ms; expected a measurement every 1 to 100 ms: cable, or FRI closed",
                toMilliseconds(now - heard_at_));
  }
  if (newest_.state == FriState::off) return fail("KRC off: open FRI in the program on the controller");
  if (newest_.state == FriState::monitor) {
    return fail(
        "KRC in monitor mode: the arm holds; link quality {}; the program on the controller starts command mode",
        protocol::toString(newest_.quality));
  }
  if (began_) return fail("KRC: command mode has just begun, the arm holds");
  if (newest_.quality < FriQuality::good) {
    return fail("KRC link quality {}: {:.0f} % of its measurements answered; expected good or perfect",
                protocol::toString(newest_.quality), 100.0F * newest_.answer_rate);
  }
  if (newest_.error != 0) {
    return fail("KRC reports drive errors {:#04x}: acknowledge them on the controller", newest_.error);
  }
  return fail("KRC control strategy {}: expected Cartesian impedance", protocol::toString(newest_.control));
}

}  // namespace fyd::device
