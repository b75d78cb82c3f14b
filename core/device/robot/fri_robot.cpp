#include "core/device/robot/fri_robot.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/device/robot/fri_check.h"

namespace fyd::device {
namespace {

using protocol::FriControl;
using protocol::FriFrame;
using protocol::FriQuality;
using protocol::FriRefusal;
using protocol::FriState;

constexpr double kMillimetres = 1000.0;
constexpr int kMostAtOnce = 64;  // datagrams in one exchange, so that a flood cannot block it
constexpr double kFurthestYield_m = 0.03;
constexpr int kForceReadings = 100;
constexpr Duration kPeerGone = std::chrono::seconds(1);
constexpr int kNeverTaken = 100;

double largest(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// Spacing of floats at that magnitude: the rounding error of a place that is sent, or added up, as float.
double resolution(double size_m) {
  const auto size = static_cast<float>(size_m);
  return std::nextafter(size, HUGE_VALF) - size;
}

bool sameHost(const protocol::Endpoint& a, const protocol::Endpoint& b) {
  return a.v6 == b.v6 && a.address == b.address && a.scope == b.scope;
}

}  // namespace

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

Message FriRobot::description() const { return say("KUKA LWR over FRI on {}", protocol::toString(socket_.local())); }

bool FriRobot::keepLimits(const MotionLimits& limits) {
  const Vec3 place = limiter_.position_mm();
  limiter_ = MotionLimiter(limits);
  limiter_.reset(place);
  return true;
}

Result<RobotReadings> FriRobot::exchange(const Vec3& target_mm, Instant now) {
  const bool good_target = target_mm.finite();
  const bool informed = std::exchange(followed_, false);
  began_ = false;
  if (now - heard_at_ > settings_.silence) moving_ = false;
  if (now - impossible_at_ > settings_.silence) impossible_ = {};
  receive(informed && good_target && !stopping_ ? std::optional(target_mm) : std::nullopt, now);
  if (!good_target) {
    return fail("KRC: target ({}, {}, {}) mm: expected three finite numbers", target_mm.x, target_mm.y, target_mm.z);
  }
  if (!follows(now) || !(informed || limiter_.atRest())) return reasonNotToFollow(now);
  followed_ = true;
  return readings();
}

// The newest measurement is answered with the motion, those before it with a halt.
void FriRobot::receive(const std::optional<Vec3>& target_mm, Instant now) {
  bool waiting = false;
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
    const bool same_session = heard_ && *peer_ == received->from && now - heard_at_ < kPeerGone;
    const auto ahead = static_cast<std::int16_t>(incoming_.header.sequence - newest_.header.sequence);
    if (same_session && ahead <= 0) {
      ++counters_.out_of_order;
      continue;
    }
    auto possible = checkMeasurement(incoming_);
    if (possible && same_session) possible = checkStep(newest_, incoming_, ahead);
    if (!possible) {
      ++counters_.impossible;
      impossible_ = std::move(possible.error().message);
      impossible_at_ = now;
      continue;
    }
    if (waiting) answer(target_mm, false);
    peer_ = received->from;
    take(same_session ? ahead : 0, now);
    waiting = true;
  }
  if (waiting) answer(target_mm, true);
}

bool FriRobot::accept(const protocol::Endpoint& from, Instant now) {
  if (settings_.krc && !sameHost(*settings_.krc, from)) return false;
  return !peer_ || *peer_ == from || now - heard_at_ >= kPeerGone;
}

/// @param ahead measurements since the last one taken; 0: another session
void FriRobot::take(int ahead, Instant now) {
  newest_ = incoming_;
  impossible_ = {};
  ++counters_.measurements;
  if (ahead == 0) {
    tick_.reset();
    moving_ = false;
  }
  tick_.take(newest_);
  if (!heard_) origin_m_ = placeIn(newest_.commanded_frame);
  heard_ = true;
  heard_at_ = now;
  if (force_count_ < kForceReadings && (force_count_ == 0 || newest_.state != FriState::command)) {
    force_sum_N_ += pressedUp_N();
    ++force_count_;
  }
  if (moving_) compareWithSent(ahead);
}

// FRI's part of the motion is contained in the commanded frame or, as with the joints, in the offset beside it. Which
// of the two is learnt from the first answer that shows in one only.
void FriRobot::compareWithSent(int ahead) {
  const Vec3 sent_m = placeIn(command_.frame);
  const Vec3 alone_m = placeIn(newest_.commanded_frame);
  const Vec3 offset_m = placeIn(newest_.frame_offset);
  const Vec3 together_m = alone_m + offset_m;
  const double same_m = resolution(std::max({largest(sent_m), largest(alone_m), largest(offset_m)}));
  const bool shows_alone = largest(alone_m - sent_m) <= same_m;
  const bool shows_together = largest(together_m - sent_m) <= same_m;
  if (!in_offset_ && shows_alone != shows_together) in_offset_ = shows_together;
  const Vec3 stands_m = in_offset_.value_or(false) ? together_m : alone_m;
  const bool taken = in_offset_.value_or(false) ? shows_together : shows_alone;
  if (!taken) {
    ++counters_.not_taken;
    not_taken_in_a_row_ = std::min(not_taken_in_a_row_ + 1, kNeverTaken);
  } else if (largest(stands_m - stood_m_) > same_m) {
    not_taken_in_a_row_ = 0;
  }
  stood_m_ = stands_m;
  if (!((stands_m - sent_m).norm() <= kFurthestYield_m)) {
    moving_ = false;  // the arm was moved otherwise: command mode begins anew there
  } else if (!taken) {
    limiter_.reset(placeOf(stands_m));
  } else if (ahead != 1) {
    limiter_.stand();
  }
}

bool FriRobot::obeys() const {
  return newest_.state == FriState::command && newest_.control == FriControl::cartesian_impedance && newest_.error == 0;
}

/// @param target_mm nothing: come to rest
void FriRobot::answer(const std::optional<Vec3>& target_mm, bool in_time) {
  command_.header.reflected = newest_.header.sequence;
  ++command_.header.sequence;
  command_.flags = protocol::fri_flag::kJoints;
  for (std::size_t i = 0; i < command_.joints.size(); ++i) {
    command_.joints[i] = newest_.commanded_joints[i] + newest_.joint_offsets[i];
  }
  // In command mode under a wrong control strategy, or before the quality is good, no frame is commanded: the mirrored
  // joints hold the arm.
  if (obeys() && (moving_ || newest_.quality >= FriQuality::good)) {
    command_.flags =
        protocol::fri_flag::kFrame | protocol::fri_flag::kCartesianStiffness | protocol::fri_flag::kCartesianDamping;
    move(target_mm, in_time);
  } else {
    moving_ = false;
  }
  const auto bytes = protocol::encodeFriCommand(command_);
  if (socket_.send(bytes, *peer_) == protocol::SendOutcome::sent) {
    ++counters_.answers;
  } else {
    ++counters_.send_failures;
  }
}

void FriRobot::move(const std::optional<Vec3>& target_mm, bool in_time) {
  if (!std::exchange(moving_, true)) {
    hold();
    return;
  }
  if (!in_time) {
    limiter_.stand();
  } else if (target_mm && !began_ && newest_.quality >= FriQuality::good) {
    limiter_.advance(*target_mm, tick_.seconds(), velocity_mm_s_);
  } else {
    limiter_.brake(tick_.seconds());
  }
  aimAt(limiter_.position_mm());
}

void FriRobot::hold() {
  ++counters_.command_entries;
  began_ = true;
  not_taken_in_a_row_ = 0;
  const double apart_m = (placeIn(newest_.commanded_frame) - placeIn(newest_.frame)).norm();
  held_frame_ = apart_m <= kFurthestYield_m ? newest_.commanded_frame : newest_.frame;
  command_.frame = held_frame_;
  in_offset_.reset();
  stood_m_ = placeIn(held_frame_);
  limiter_.reset(placeOf(stood_m_));
}

void FriRobot::aimAt(const Vec3& place_mm) {
  const Vec3 place_m = origin_m_ + settings_.axes.toBase((1.0 / kMillimetres) * place_mm);
  command_.frame = held_frame_;
  command_.frame[3] = static_cast<float>(place_m.x);
  command_.frame[7] = static_cast<float>(place_m.y);
  command_.frame[11] = static_cast<float>(place_m.z);
}

Vec3 FriRobot::placeOf(const Vec3& base_m) const {
  return settings_.axes.toTouchpad(kMillimetres * (base_m - origin_m_));
}

double FriRobot::pressedUp_N() const {
  return settings_.axes.toTouchpad({newest_.force_torque[0], newest_.force_torque[1], newest_.force_torque[2]}).z;
}

RobotReadings FriRobot::readings() const {
  const double rest_N = force_count_ > 0 ? force_sum_N_ / force_count_ : 0.0;
  return {.position_mm = placeOf(placeIn(newest_.frame)),
          .force_N = std::max(pressedUp_N() - rest_N, 0.0),
          .acceleration_g = {newest_.krl.reals[0], newest_.krl.reals[1], newest_.krl.reals[2]},
          .taken = heard_at_,
          .commanded_mm = limiter_.position_mm()};
}

bool FriRobot::follows(Instant now) const {
  return heard_ && now - heard_at_ <= settings_.silence && impossible_.empty() && moving_ && !began_ &&
         newest_.quality >= FriQuality::good && not_taken_in_a_row_ < kNeverTaken;
}

tl::unexpected<Error> FriRobot::reasonNotToFollow(Instant now) const {
  if (!impossible_.empty()) return fail(impossible_);
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
        phrase(protocol::toString(newest_.quality)));
  }
  if (began_) return fail("KRC: command mode has just begun, the arm holds");
  if (newest_.quality < FriQuality::good) {
    return fail("KRC link quality {}: {:.0f} % of its measurements answered; expected good or perfect",
                phrase(protocol::toString(newest_.quality)),
                100.0 * std::clamp(static_cast<double>(newest_.answer_rate), 0.0, 1.0));
  }
  if (newest_.error != 0) {
    return fail("KRC reports drive errors {:#04x}: acknowledge them on the controller", newest_.error);
  }
  if (newest_.control != FriControl::cartesian_impedance) {
    return fail("KRC control strategy {}: expected Cartesian impedance", phrase(protocol::toString(newest_.control)));
  }
  if (not_taken_in_a_row_ >= kNeverTaken) {
    return fail("KRC: none of the last {} answers shows in its commanded frame; expected the place that was commanded",
                kNeverTaken);
  }
  return fail("KRC: the arm is coming to rest");
}

}  // namespace fyd::device
