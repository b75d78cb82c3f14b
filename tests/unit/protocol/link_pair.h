// Both ends of FYD Link over a random simulated network, in virtual time.
#pragma once

#include <cstring>
#include <fstream>
#include <functional>
#include <map>
#include <queue>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/protocol/link/link_robot_end.h"
#include "core/protocol/link/link_touchpad_end.h"

namespace fyd::protocol {

using Packet = std::vector<std::uint8_t>;

/// tests/data/protocol/link_vectors.txt
inline const std::map<std::string, std::string>& vectors() {
  static const std::map<std::string, std::string> all = [] {
    std::map<std::string, std::string> out;
    std::ifstream file(FYD_TEST_DATA "/protocol/link_vectors.txt");
    for (std::string line; std::getline(file, line);) {
      const std::size_t space = line.find(' ');
      if (!line.starts_with('#') && space != std::string::npos) out[line.substr(0, space)] = line.substr(space + 1);
    }
    return out;
  }();
  return all;
}
inline Packet vectorBytes(const std::string& name) {
  const std::string& text = vectors().at(name);
  Packet out;
  for (std::size_t i = 0; i + 1 < text.size(); i += 2) {
    out.push_back(static_cast<std::uint8_t>(std::stoi(text.substr(i, 2), nullptr, 16)));
  }
  return out;
}

inline LinkKey testKey(std::uint8_t first = 0) {
  SecretBytes<16> code;
  for (std::size_t i = 0; i < 16; ++i) code.data()[i] = static_cast<std::uint8_t>(first + i);
  return LinkKey::fromCode(code);
}

// Random bytes from a fixed seed: the same in every run, different in every call.
inline void seededRandom(std::span<std::uint8_t> out) {
  static std::mt19937_64 generator(7);
  for (auto& byte : out) byte = static_cast<std::uint8_t>(generator());
}

inline Endpoint linkAddress(int host, int port = 4490) {
  return parseEndpoint(fmt::format("10.0.0.{}:{}", host, port)).value();
}

struct Weather {
  double delay_ms = 1.0;
  double jitter_ms = 0.0;  ///< additional delay, uniform from 0 to this
  double loss = 0.0;
  double reorder = 0.0;  ///< share of datagrams held back by 30 ms
  double duplicate = 0.0;
};

/// One touchpad, one robot, a wire each way. A step is 1 ms.
class LinkPair {
 public:
  explicit LinkPair(const LinkParameters& parameters = {}, LinkRobotSettings settings = {},
                    const LinkKey& robot_key = testKey())
      : touchpad(parameters, testKey(), seededRandom), robot(settings, robot_key, kTouchpad, seededRandom) {
    answer.touch = {.position_mm = {10, -5, -2.5}, .in_contact = true, .force_N = 1.0};
    answer.info = {.k_vib = 1.5, .reference_ticks = {4200, -4200}};
    answer.board_text = "board";
    report.robot = {.stiffness_N_per_mm = 0.62, .position_mm = {1, 2, -3}, .force_N = 1.5};
  }

  void step() {
    now += std::chrono::milliseconds(1);
    deliver();
    if (robot_alive) post(robot.tick(now + robot_clock, report), kRobot);
    answer.taken = now;
    if (touchpad_alive) post(touchpad.advance(now + touchpad_clock, answer), kTouchpad);
    if (on_step) on_step();
  }
  void run(double seconds) {
    for (int i = 0; i < static_cast<int>(1e3 * seconds); ++i) step();
  }
  bool runUntil(const std::function<bool()>& done, double seconds) {
    for (int i = 0; i < static_cast<int>(1e3 * seconds) && !done(); ++i) step();
    return done();
  }
  bool connect() {
    return runUntil(
        [&] { return touchpad.phase() == pipeline::LinkPhase::running && robot.phase() == RobotPhase::running; }, 20);
  }
  void giveTouchpad(Bytes datagram, const Endpoint& from = kRobot) {
    const auto& got = touchpad.handle(datagram, from, now + touchpad_clock, answer);
    see(got);
    post(got.replies.view(), kTouchpad);
  }
  RobotReception giveRobot(Bytes datagram, const Endpoint& from = kTouchpad) {
    return robot.handle(datagram, from, now + robot_clock);
  }

  static inline const Endpoint kRobot = linkAddress(1);
  static inline const Endpoint kTouchpad = linkAddress(100);

  Weather weather;
  Instant now = instantAt(1000.0);
  Duration robot_clock = std::chrono::seconds(5000);  // offset of its clock
  Duration touchpad_clock{};
  bool robot_alive = true;
  bool touchpad_alive = true;
  bool cut = false;      // nothing arrives
  bool stalled = false;  // sent messages wait
  LinkTouchpadEnd touchpad;
  LinkRobotEnd robot;
  TouchpadAnswer answer;
  RobotReport report;
  std::function<void()> on_step;
  std::function<void(const Packet&, const Endpoint&)> on_sent;  // bytes and their sender
  std::function<bool(const Packet&, const Endpoint&)> lost_on_the_way;

  std::vector<texture::AccelerationSample> samples;
  std::vector<pipeline::RobotCommand> commands;
  std::vector<pipeline::RobotMotorReference> references;
  std::uint64_t states = 0;
  pipeline::RobotState state;  // the newest
  std::uint64_t touches = 0;
  std::uint64_t sessions = 0;
  std::uint64_t images = 0;
  bool keep_samples = false;

 private:
  struct Flight {
    Instant arrival;
    std::uint64_t number;
    Endpoint from;
    Endpoint to;
    Packet bytes;
    bool operator<(const Flight& other) const {
      return std::pair(arrival, number) > std::pair(other.arrival, other.number);
    }
  };

  double chance() { return std::uniform_real_distribution<>(0.0, 1.0)(random_); }
  void post(std::span<const Datagram> datagrams, const Endpoint& from) {
    for (const Datagram& datagram : datagrams) {
      const Packet bytes(datagram.bytes.begin(), datagram.bytes.end());
      if (on_sent) on_sent(bytes, from);
      if (cut || (lost_on_the_way && lost_on_the_way(bytes, from)) || chance() < weather.loss) continue;
      double delay_ms = weather.delay_ms + weather.jitter_ms * chance();
      if (chance() < weather.reorder) delay_ms += 30.0;
      const Instant arrival = now + fromSeconds(1e-3 * delay_ms);
      flights_.push({arrival, number_++, from, datagram.to, bytes});
      if (chance() < weather.duplicate) flights_.push({arrival, number_++, from, datagram.to, bytes});
    }
  }
  void deliver() {
    while (!stalled && !flights_.empty() && flights_.top().arrival <= now) {
      const Flight flight = flights_.top();
      flights_.pop();
      if (flight.to == kTouchpad && touchpad_alive) giveTouchpad(flight.bytes, flight.from);
      if (flight.to == kRobot && robot_alive) {
        const auto got = giveRobot(flight.bytes, flight.from);
        touches += got.touch ? 1 : 0;
        images += got.image ? 1 : 0;
      }
    }
  }
  void see(const TouchpadReception& got) {
    states += got.state ? 1 : 0;
    if (got.state) state = *got.state;
    sessions += got.session_started ? 1 : 0;
    if (got.command != pipeline::RobotCommand::none) commands.push_back(got.command);
    if (got.motor_reference) references.push_back(*got.motor_reference);
    if (keep_samples) samples.insert(samples.end(), got.accelerations.begin(), got.accelerations.end());
  }

  std::mt19937_64 random_{11};
  std::priority_queue<Flight> flights_;
  std::uint64_t number_ = 0;
};

}  // namespace fyd::protocol
