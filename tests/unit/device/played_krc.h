// A fake robot controller (KRC) in virtual time, over real sockets. It has its own tick, takes the answer to each
// measurement if it came before the next one, and otherwise stops. It judges the commanded motion only by differences
// of its positions from tick to tick.
//
// A tick without a command stops the arm at once, which the robot end cannot prevent. That tick is counted (`held`) and
// not judged for acceleration and jerk. The arm is then at rest, and the next motion has to start from rest (or, where
// the arm reversed in that tick, to continue from its true difference).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <queue>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "core/device/robot/following_robot.h"
#include "core/device/robot/fri_robot.h"

namespace fyd::device {

struct PlayedKrcOptions {
  double tick_s = 0.005;
  double stated_s = 0.0;    ///< tick period that it reports, s; 0: the true one
  bool stamps = true;       ///< its measurements carry its time
  bool in_offset = false;   ///< what FRI commands stands in the frame's offset instead of the commanded frame
  double exchange_s = 0.0;  ///< cycle of the robot end; 0: a third of the tick, at most 1 ms
  double delay_s = 0.0;     ///< of each message, and
  double jitter_s = 0.0;    ///< up to that much more
  double loss = 0.0;        ///< share, each way
  double late = 0.0;        ///< share of messages that take up to five ticks more, each way
  double pause = 0.0;       ///< share of the robot end's cycles that take up to ten ticks more
  double nonsense = 0.0;    ///< share of measurements with finite but implausible numbers
  MotionLimits limits;
  std::uint64_t seed = 1;
  Vec3 tool_m{0.05, 0.02, 0.03};  ///< near the base, where a float of metres resolves 1e-8 m
};

struct PlayedKrcJudgement {
  std::uint64_t ticks = 0;  ///< in command mode
  std::uint64_t held = 0;   ///< of them without a command, while the arm moved
  double speed_mm_s = 0.0;  ///< largest
  double acceleration_mm_s2 = 0.0;
  double jerk_mm_s3 = 0.0;
  double travelled_mm = 0.0;
  Vec3 farthest_mm;  ///< from the start, along the base's axes
  std::uint64_t exchanges_failed = 0;
  std::string last_problem;
};

class FakeKrc {
 public:
  explicit FakeKrc(const PlayedKrcOptions& options)
      : options_(options), random_(options.seed), socket_(protocol::UdpSocket::open(any()).value()) {
    auto robot = FriRobot::open({.bind = any()}).value();
    fri = robot.get();
    followed.emplace(std::move(robot), options.limits);
    if (options_.exchange_s <= 0.0) options_.exchange_s = std::min(options.tick_s / 3.0, 0.001);
    measurement.control = protocol::FriControl::cartesian_impedance;
    measurement.quality = protocol::FriQuality::perfect;
    measurement.state = protocol::FriState::monitor;
    const auto stated = static_cast<float>(options.stated_s > 0.0 ? options.stated_s : options.tick_s);
    measurement.measurement_period_s = measurement.command_period_s = stated;
    commanded_ = {1, 0, 0,  static_cast<float>(options.tool_m.x), 0, -1, 0, static_cast<float>(options.tool_m.y),
                  0, 0, -1, static_cast<float>(options.tool_m.z)};
    programmed_ = measurement.frame = commanded_;
  }

  /// Runs for a time of its own clock. `target` is asked at each cycle of the robot end.
  void run(double seconds, const std::function<Vec3(double)>& target) {
    const double until = time_s_ + seconds;
    while (time_s_ < until) {
      if (next_tick_s_ <= next_exchange_s_) {
        time_s_ = next_tick_s_;
        tick();
        next_tick_s_ = static_cast<double>(++ticks_) * options_.tick_s;
      } else {
        time_s_ = next_exchange_s_;
        exchange(target(time_s_));
        next_exchange_s_ = time_s_ + options_.exchange_s * (0.7 + 0.6 * share()) +
                           (share() < options_.pause ? 10.0 * options_.tick_s * share() : 0.0);
      }
    }
  }
  [[nodiscard]] double time_s() const { return time_s_; }
  /// Where it was commanded last, from the start, along the base's axes.
  [[nodiscard]] Vec3 commanded_mm() const { return 1000.0 * (placeOf(commanded_) - options_.tool_m); }
  /// Largest error of the n-th difference due to the resolution of positions, mm/sⁿ.
  [[nodiscard]] double resolution(int n) const {
    const double largest_m =
        std::max({std::abs(options_.tool_m.x), std::abs(options_.tool_m.y), std::abs(options_.tool_m.z)}) + 0.07;
    const double half_step_mm =
        500.0 * (std::nextafter(static_cast<float>(largest_m), HUGE_VALF) - static_cast<float>(largest_m));
    return std::sqrt(3.0) * std::pow(2.0, n) * half_step_mm / std::pow(options_.tick_s, n);
  }
  /// The limits that were violated, as text; empty: none.
  [[nodiscard]] std::string violation() const {
    const MotionLimits& l = options_.limits;
    std::string out = broken_;
    const auto judge = [&out](const char* what, double value, double limit) {
      if (!(value <= limit)) out += fmt::format("{} {:.6g}, limit {:.6g}; ", what, value, limit);
    };
    judge("speed", judgement.speed_mm_s, l.speed_mm_s + resolution(1));
    judge("acceleration", judgement.acceleration_mm_s2, l.acceleration_mm_s2 + resolution(2));
    judge("jerk", judgement.jerk_mm_s3, l.jerk_mm_s3 + resolution(3));
    judge("base x", judgement.farthest_mm.x, l.workspace_mm.y + resolution(0));  // base X = −y
    judge("base y", judgement.farthest_mm.y, l.workspace_mm.x + resolution(0));
    judge("base z", judgement.farthest_mm.z, l.workspace_mm.z + resolution(0));
    return out;
  }

  FriRobot* fri = nullptr;
  std::optional<FollowingRobot> followed;
  protocol::FriMeasurement measurement;
  PlayedKrcJudgement judgement;
  double monitor_s = 0.1;  ///< until command mode
  bool answers_obeyed = true;

 private:
  struct Message {
    double arrives_s = 0.0;
    std::uint64_t order = 0;
    std::vector<std::uint8_t> bytes;
    bool operator<(const Message& other) const {
      return arrives_s != other.arrives_s ? arrives_s > other.arrives_s : order > other.order;
    }
  };

  static protocol::Endpoint any() { return protocol::parseEndpoint("127.0.0.1:0").value(); }
  static Vec3 placeOf(const protocol::FriFrame& frame) { return {frame[3], frame[7], frame[11]}; }
  double share() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }
  std::optional<double> arrival() {
    const double under_way_s = options_.delay_s + options_.jitter_s * share();
    const double late_s = share() < options_.late ? 5.0 * options_.tick_s * share() : 0.0;
    if (share() < options_.loss) return std::nullopt;
    return time_s_ + under_way_s + late_s;
  }

  void tick() {
    // What has come until now; only the answer to the last measurement counts.
    bool commanded = false;
    while (!answers_.empty() && answers_.top().arrives_s <= time_s_) {
      protocol::FriCommand command;
      static_cast<void>(decodeFriCommand(answers_.top().bytes, command));  // read once when it was sent
      answers_.pop();
      measurement.header.reflected = command.header.sequence;
      if (command.header.reflected != measurement.header.sequence || !answers_obeyed) continue;
      if (measurement.state != protocol::FriState::command || (command.flags & 0x100U) == 0) continue;
      next_ = command.frame;
      commanded = true;
    }
    if (measurement.state == protocol::FriState::command) judge(commanded ? next_ : commanded_, commanded);
    if (time_s_ >= monitor_s && measurement.state == protocol::FriState::monitor) {
      measurement.state = protocol::FriState::command;
    }
    ++measurement.header.sequence;
    if (options_.stamps) measurement.time_s = static_cast<float>(time_s_);
    measurement.commanded_frame = options_.in_offset ? programmed_ : commanded_;
    for (const std::size_t i : {3U, 7U, 11U}) {
      if (options_.in_offset) measurement.frame_offset[i] = commanded_[i] - programmed_[i];
      measurement.frame[i] += 0.2F * (commanded_[i] - measurement.frame[i]);
    }
    const bool spoilt = share() < options_.nonsense;
    if (spoilt) nonsense_.insert(measurement.header.sequence);
    if (const auto arrives = arrival()) {
      const auto bytes = protocol::encodeFriMeasurement(spoilt ? spoiled() : measurement);
      measurements_.push({*arrives, ++order_, {bytes.begin(), bytes.end()}});
    }
  }

  /// Sets one quantity to a random implausible value.
  protocol::FriMeasurement spoiled() {
    protocol::FriMeasurement m = measurement;
    const auto size = static_cast<float>(std::pow(10.0, 1.0 + 37.0 * share()));  // 10 … 1e38
    const float value = random_() % 2 == 0 ? size : -size;
    const auto joint = static_cast<std::size_t>(random_() % 7);
    switch (random_() % 9) {
      case 0: m.joints[joint] = value; break;
      case 1: m.commanded_joints[joint] = value; break;
      case 2: m.joint_offsets[joint] = value; break;
      case 3: m.frame.fill(0.0F); break;
      case 4: m.commanded_frame.fill(0.0F); break;
      case 5: m.commanded_frame[4 * (random_() % 3) + 3] = value; break;
      case 6: m.frame[random_() % 12] = value; break;
      case 7: m.frame_offset[4 * (random_() % 3) + 3] = value; break;
      default: m.force_torque[random_() % 3] = 200.0F * value; break;
    }
    return m;
  }

  void judge(const protocol::FriFrame& frame, bool commanded) {
    const double h = options_.tick_s;
    const Vec3 step_mm = 1000.0 * (placeOf(frame) - placeOf(commanded_));
    commanded_ = frame;
    ++judgement.ticks;
    const Vec3 velocity = (1.0 / h) * step_mm;
    const Vec3 acceleration = (1.0 / h) * (velocity - velocity_);
    if (!commanded) {
      if (velocity_.norm() > 0.0) ++judgement.held;
      velocity_ = acceleration_ = {};
      turned_ = acceleration;
      return;
    }
    double jerk = (1.0 / h * (acceleration - acceleration_)).norm();
    if (turned_) jerk = std::min(jerk, (1.0 / h * (acceleration - *turned_)).norm());
    turned_.reset();
    judgement.speed_mm_s = std::max(judgement.speed_mm_s, velocity.norm());
    judgement.acceleration_mm_s2 = std::max(judgement.acceleration_mm_s2, acceleration.norm());
    judgement.jerk_mm_s3 = std::max(judgement.jerk_mm_s3, jerk);
    judgement.travelled_mm += step_mm.norm();
    const Vec3 from_start = commanded_mm();
    Vec3& far = judgement.farthest_mm;
    far = {std::max(far.x, std::abs(from_start.x)), std::max(far.y, std::abs(from_start.y)),
           std::max(far.z, std::abs(from_start.z))};
    velocity_ = velocity;
    acceleration_ = acceleration;
  }

  void exchange(const Vec3& target_mm) {
    while (!measurements_.empty() && measurements_.top().arrives_s <= time_s_) {
      if (socket_.send(measurements_.top().bytes, fri->local()) != protocol::SendOutcome::sent)
        broken_ += "no network; ";
      measurements_.pop();
    }
    const auto readings = followed->exchange(target_mm, options_.exchange_s, instantAt(100.0 + time_s_));
    if (!readings) {
      ++judgement.exchanges_failed;
      judgement.last_problem = readings.error().text();
    }
    std::array<std::uint8_t, 1000> buffer{};
    while (const auto received = socket_.receive(buffer, Duration::zero())) {
      inspect({buffer.data(), received->size});
      if (const auto arrives = arrival()) {
        answers_.push({*arrives, ++order_, {buffer.begin(), buffer.begin() + static_cast<long>(received->size)}});
      }
    }
  }

  /// Checks every answer, including those that the network loses.
  void inspect(protocol::Bytes bytes) {
    protocol::FriCommand command;
    if (decodeFriCommand(bytes, command) != protocol::FriRefusal::none) broken_ += "answer unreadable; ";
    if (nonsense_.contains(command.header.reflected)) broken_ += "answered what no arm measures; ";
    for (const float joint : command.joints) {
      if (!(std::abs(joint) < 7.0F)) broken_ += fmt::format("joint {} mirrored; ", joint);
    }
    if ((command.flags & 0x100U) == 0) return;
    const double away_m = (placeOf(command.frame) - options_.tool_m).norm();
    if (!(away_m < 0.1)) broken_ += fmt::format("commanded {} m away; ", away_m);
  }

  PlayedKrcOptions options_;
  std::mt19937_64 random_;
  protocol::UdpSocket socket_;
  std::priority_queue<Message> measurements_;
  std::priority_queue<Message> answers_;
  protocol::FriFrame commanded_{};   // where the arm is told to be
  protocol::FriFrame programmed_{};  // where the program on the controller left it
  protocol::FriFrame next_{};
  Vec3 velocity_;
  Vec3 acceleration_;
  std::optional<Vec3> turned_;        // the acceleration of a tick without a command, from the positions
  std::set<std::uint16_t> nonsense_;  // sequence numbers; no run is long enough for them to repeat
  std::string broken_;
  std::uint64_t order_ = 0;
  std::uint64_t ticks_ = 0;
  double time_s_ = 0.0;
  double next_tick_s_ = 0.0;
  double next_exchange_s_ = 0.0;
};

/// Targets that jump within the workspace and beyond, one in 20 of them NaN.
class WildTargets {
 public:
  explicit WildTargets(std::uint64_t seed) : random_(seed) {}
  Vec3 operator()(double time_s) {
    if (time_s >= next_s_) {
      std::uniform_real_distribution<double> place(-90.0, 90.0);
      target_mm_ = {place(random_), place(random_), place(random_)};
      if (random_() % 20 == 0) target_mm_.y = std::nan("");
      next_s_ = time_s + std::uniform_real_distribution<double>(0.005, 0.5)(random_);
    }
    return target_mm_;
  }

 private:
  std::mt19937_64 random_;
  Vec3 target_mm_;
  double next_s_ = 0.0;
};

}  // namespace fyd::device
