// Two players fence over real sockets with 30 ms delay and 20 % loss, in virtual time; their forces are compared with
// those without a network.
#include "core/sim/teleop/fencing_end.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "core/sim/network/network_emulator.h"
#include "core/sim/network/network_relay.h"
#include "core/teleop/prediction/predictor_choice.h"
#include "tests/integration/sim/delivered_socket.h"
#include "tests/wait.h"

namespace fyd::sim {
namespace {

constexpr double kFencingTick_s = 0.001;

/// Its datagrams are late or lost before they leave it.
class LateSocket {
 public:
  LateSocket(NetworkSettings network, std::uint64_t seed)
      : emulator_([&] {
          network.seed = seed;
          return network;
        }()) {}

  [[nodiscard]] const protocol::Endpoint& local() const { return socket_.local(); }
  void send(std::span<const std::uint8_t> bytes, LateSocket& to, double t_s) {
    if (!bytes.empty()) {
      ++sent;
      for (const Instant at : emulator_.pass(bytes.size(), instantAt(t_s)).out) {
        under_way_.emplace(toSeconds(at.time_since_epoch()), std::vector(bytes.begin(), bytes.end()));
      }
    }
    for (; !under_way_.empty() && under_way_.begin()->first <= t_s; under_way_.erase(under_way_.begin())) {
      socket_.send(under_way_.begin()->second, to.socket_);
    }
  }
  template <class Take>
  void receive(Take&& take) {
    socket_.receive([&](std::span<const std::uint8_t> bytes, const protocol::Endpoint&) {
      ++received;
      take(bytes);
    });
  }

  [[nodiscard]] protocol::UdpSocket& socket() { return socket_.socket(); }

  int sent = 0, received = 0;

 private:
  NetworkEmulator emulator_;
  DeliveredSocket socket_;
  std::multimap<double, std::vector<std::uint8_t>> under_way_;
};

struct Player {
  Player(const FencingSettings& settings, const NetworkSettings& network, std::uint64_t seed)
      : end(settings), socket(network, seed) {}

  scene::SwordTouch step(const DeviceState& device, LateSocket& other, double now_s) {
    socket.receive([&](auto bytes) { end.receive(bytes, now_s); });
    const scene::SwordTouch touch = end.step(device, now_s);
    socket.send(end.datagram(now_s), other, now_s);
    return touch;
  }

  FencingEnd end;
  LateSocket socket;
};

/// A recorded finger, each coordinate from its mean and by its spread.
class RecordedHand {
 public:
  explicit RecordedHand(const std::string& name) {
    std::ifstream file(std::string(FYD_TEST_DATA "/hand_motion/") + name);
    EXPECT_TRUE(file) << name;
    std::string line;
    std::getline(file, line);
    for (double t_s = 0.0, x = 0.0, y = 0.0, z = 0.0; std::getline(file, line);) {
      EXPECT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf", &t_s, &x, &y, &z), 4);
      at_.push_back({x, y, z});
    }
    Vec3 mean, spread;
    for (const Vec3& each : at_) mean = mean + (1.0 / static_cast<double>(at_.size())) * each;
    for (Vec3& each : at_) {
      each = each - mean;
      spread =
          spread + (1.0 / static_cast<double>(at_.size())) * Vec3{each.x * each.x, each.y * each.y, each.z * each.z};
    }
    for (Vec3& each : at_)
      each = {each.x / std::sqrt(spread.x), each.y / std::sqrt(spread.y), each.z / std::sqrt(spread.z)};
  }
  /// Its rows are 10 ms apart; smooth through four of them.
  [[nodiscard]] Vec3 at(double t_s) const {
    const double place = (t_s < 59.0 ? t_s : 118.0 - t_s) / 0.01;  // to the end and back
    const auto i = std::max<std::size_t>(1, static_cast<std::size_t>(place));
    const double u = place - static_cast<double>(i);
    const Vec3 &a = at_[i - 1], &b = at_[i], &c = at_[i + 1], &d = at_[i + 2];
    return b + (0.5 * u) * ((c - a) + u * (2.0 * a - 5.0 * b + 4.0 * c - d + u * (3.0 * (b - c) + d - a)));
  }

 private:
  std::vector<Vec3> at_;
};

/// Both blades rise towards the other player and meet in the middle; hands and wrists swing across.
/// @param rate_Hz of strokes that are never again as they were; 0: a recorded hand's
DeviceState handAt(double t_s, double rate_Hz, bool first) {
  const double shift = first ? 0.0 : 1.1, turn = first ? 0.025 : 0.018, aside = first ? 0.008 : 0.0;
  if (rate_Hz == 0.0) {
    static const RecordedHand hand("index_tip.csv");  // one hand for both, 23 s apart
    const Vec3 x = hand.at(first ? t_s : t_s + 23.0);
    return {.position_mm = 2.0 * x,
            .velocity_mm_per_s = {},
            .force_N = {},
            .orientation = {0.1 * x.z, -0.25 + 0.02 * x.x, aside + turn * x.y}};
  }
  const double w = 2.0 * M_PI * rate_Hz;
  DeviceState out;
  out.position_mm = {2.0 * std::sin(0.37 * w * t_s + shift), 2.0 * std::sin(0.81 * w * t_s + 2.0 * shift),
                     2.0 * std::sin(0.53 * w * t_s)};
  out.orientation = {.alpha_rad = 0.2 * std::sin(0.3 * w * t_s),
                     .beta_rad = -0.25 + 0.02 * std::sin(0.71 * w * t_s + shift),
                     .gamma_rad = aside + turn * std::sin(w * t_s + shift)};
  return out;
}

scene::Blade bladeOf(const FencingSettings& settings, const DeviceState& hand) {
  return swordOf(settings, hand.position_mm,
                 teleop::fromAngles(hand.orientation.alpha_rad, hand.orientation.beta_rad, hand.orientation.gamma_rad));
}

struct Figures {
  int contacts = 0, found = 0, invented = 0;
  double late_ms = 0.0, latest_ms = 0.0;  ///< mean and largest distance of the instants that were found
  double force_N = 0.0, error_N = 0.0;    ///< RMS while one of both touches: true, and difference
  double largest_step_N = 0.0;            ///< of the force, in a millisecond
};

/// Of one player's force and instants of contact.
Figures compare(const std::vector<scene::SwordTouch>& felt, const std::vector<scene::SwordTouch>& truth,
                double near_s) {
  const auto instants = [](const std::vector<scene::SwordTouch>& touches) {
    std::vector<double> out;
    for (std::size_t i = 0; i < touches.size(); ++i) {
      if (touches[i].began) out.push_back(kFencingTick_s * static_cast<double>(i) - touches[i].began_ago_s);
    }
    return out;
  };
  const std::vector<double> told = instants(felt), was = instants(truth);
  Figures out;
  std::size_t matched = 0;
  for (const double at : was) {
    double best = 1e9;
    for (const double each : told) best = std::min(best, std::abs(each - at));
    ++out.contacts;
    if (best > near_s) continue;
    ++out.found;
    out.late_ms += 1e3 * best;
    out.latest_ms = std::max(out.latest_ms, 1e3 * best);
  }
  for (const double each : told) {
    double best = 1e9;
    for (const double at : was) best = std::min(best, std::abs(each - at));
    matched += best <= near_s;
  }
  out.invented = static_cast<int>(told.size() - matched);
  out.late_ms /= std::max(1, out.found);
  int count = 0;
  for (std::size_t i = 1; i < felt.size(); ++i) {
    out.largest_step_N = std::max(out.largest_step_N, scene::length(felt[i].force_N - felt[i - 1].force_N));
    if (!felt[i].touching && !truth[i].touching) continue;
    ++count;
    out.force_N += scene::squared(truth[i].force_N);
    out.error_N += scene::squared(felt[i].force_N - truth[i].force_N);
  }
  out.force_N = std::sqrt(out.force_N / std::max(1, count));
  out.error_N = std::sqrt(out.error_N / std::max(1, count));
  return out;
}

struct Game {
  FencingSettings settings;
  NetworkSettings network{.delay_ms = 30.0, .loss_percent = 20.0};
  double rate_Hz = 1.0;
};

/// Both players' figures together.
Figures play(const Game& game, double seconds) {
  Player one(game.settings, game.network, 11), other(game.settings, game.network, 12);
  one.end.start(1);
  other.end.start(2);
  scene::SwordState here, there;
  std::vector<scene::SwordTouch> felt[2], truth[2];
  for (int i = 0; i < static_cast<int>((seconds + 3.0) / kFencingTick_s); ++i) {
    const double t_s = kFencingTick_s * i, now_s = 1000.0 + t_s;
    const DeviceState a = handAt(t_s, game.rate_Hz, true), b = handAt(t_s, game.rate_Hz, false);
    const scene::SwordTouch first = one.step(a, other.socket, now_s), second = other.step(b, one.socket, now_s);
    const scene::Blade p = bladeOf(game.settings, a), q = bladeOf(game.settings, b);
    const auto true_first =
        scene::stepSwords(game.settings.swords, here, p, asTheOtherSees(game.settings, q), kFencingTick_s);
    const auto true_second =
        scene::stepSwords(game.settings.swords, there, q, asTheOtherSees(game.settings, p), kFencingTick_s);
    EXPECT_NEAR(scene::length(asTheOtherSees(true_second.force_N) + true_first.force_N), 0.0, 1e-9);
    EXPECT_TRUE(first.force_N.finite() && second.force_N.finite());
    EXPECT_LE(scene::length(first.force_N), game.settings.swords.most_force_N + 1e-9);
    if (t_s < 3.0) continue;  // until they are linked
    EXPECT_EQ(one.end.phase(), TeleopEnd::Phase::linked);
    felt[0].push_back(first);
    felt[1].push_back(second);
    truth[0].push_back(true_first);
    truth[1].push_back(true_second);
  }
  EXPECT_GT(one.socket.received, 0.6 * other.socket.sent);
  const double near_s = 0.25;
  Figures out = compare(felt[0], truth[0], near_s);
  const Figures more = compare(felt[1], truth[1], near_s);
  out.late_ms = (out.late_ms * out.found + more.late_ms * more.found) / std::max(1, out.found + more.found);
  out.latest_ms = std::max(out.latest_ms, more.latest_ms);
  out.contacts += more.contacts;
  out.found += more.found;
  out.invented += more.invented;
  out.force_N = 0.5 * (out.force_N + more.force_N);
  out.error_N = 0.5 * (out.error_N + more.error_N);
  out.largest_step_N = std::max(out.largest_step_N, more.largest_step_N);
  return out;
}

TEST(Fencing, EachEndFindsTheContactsThatAreThereWithoutANetwork) {
  std::printf(
      "30 ms, 20 %% lost, both players, 45 s; force and error RMS while one touches; an instant counts within 250 ms\n"
      "strokes   predictor  period  contacts  found  invented  instant ms (most)  force N  error N  largest step N\n");
  std::map<std::tuple<double, teleop::PredictorChoice, int>, Figures> by;
  using enum teleop::PredictorChoice;
  for (const double rate_Hz : {0.3, 1.0, 0.0}) {
    for (const auto predictor : {order0, order1, experts}) {
      for (const int period_ms : {10, 100, 250, 500}) {
        Game game{.settings = {}, .rate_Hz = rate_Hz};
        game.settings.predictor = predictor;
        game.settings.players.period_s = 1e-3 * period_ms;
        const Figures f = play(game, 45.0);
        std::printf("%-8s  %-9s  %3d ms  %8d  %5d  %8d  %11.1f (%3.0f)  %7.2f  %7.2f  %.2f\n",
                    rate_Hz == 0.0   ? "recorded"
                    : rate_Hz == 1.0 ? "1 Hz"
                                     : "0.3 Hz",
                    std::string(teleop::kPredictorNames[static_cast<std::size_t>(predictor)]).c_str(), period_ms,
                    f.contacts, f.found, f.invented, f.late_ms, f.latest_ms, f.force_N, f.error_N, f.largest_step_N);
        by[{rate_Hz, predictor, period_ms}] = f;
        EXPECT_GE(f.contacts, 20);
        EXPECT_LT(f.largest_step_N, 1.0);
      }
    }
  }
  for (const double rate_Hz : {0.3, 1.0, 0.0}) {
    const auto at = [&](teleop::PredictorChoice choice, int period_ms) { return by.at({rate_Hz, choice, period_ms}); };
    // The paper's: each message 10 ms after the one before, order 1.
    EXPECT_EQ(at(order1, 10).found, at(order1, 10).contacts);
    EXPECT_LT(at(order1, 10).late_ms, 20.0);
    EXPECT_LT(at(order1, 10).error_N, 0.15 * at(order1, 10).force_N);
    EXPECT_GT(at(order0, 10).late_ms, 30.0);  // of the network, which is not predicted
    EXPECT_GT(at(order1, 100).error_N, at(order1, 10).error_N);
    for (const int period_ms : {10, 100, 250, 500}) {
      EXPECT_LT(at(experts, period_ms).error_N, at(order1, period_ms).error_N) << rate_Hz << " " << period_ms;
      EXPECT_LT(at(experts, period_ms).late_ms, at(order0, period_ms).late_ms) << rate_Hz << " " << period_ms;
    }
  }
}

/// Their own y alone moves, as a mass does that a hand pulls with a steady force and holds with friction.
struct PressingHand {
  double y_mm = 0.0, y_mm_per_s = 0.0;

  void step(double pull_N, double felt_N) {
    constexpr double kMass_kg = 0.3, kHeld_N_s_per_m = 10.0;
    y_mm_per_s += (pull_N + felt_N - 1e-3 * kHeld_N_s_per_m * y_mm_per_s) / kMass_kg * 1e3 * kFencingTick_s;
    y_mm += y_mm_per_s * kFencingTick_s;
  }
  [[nodiscard]] DeviceState device() const {
    return {
        .position_mm = {0.0, y_mm, 0.0}, .velocity_mm_per_s = {0.0, y_mm_per_s, 0.0}, .orientation = {0.0, -0.25, 0.0}};
  }
};

TEST(Fencing, TwoHandsThatPressFeelEachOtherAsLongAsThePlayersAreLinked) {
  for (const auto predictor : {teleop::PredictorChoice::order1, teleop::PredictorChoice::experts}) {
    for (const int period_ms : {10, 100}) {
      FencingSettings settings;
      settings.players.scale = 1.0;
      settings.predictor = predictor;
      settings.players.period_s = 1e-3 * period_ms;
      const NetworkSettings network{.delay_ms = 30.0, .loss_percent = 20.0};
      Player one(settings, network, 11), other(settings, network, 12);
      one.end.start(1);
      other.end.start(2);
      PressingHand a{.y_mm = -4.0}, b{.y_mm = -4.0};  // each to its right of the other
      double force_N = 0.0, squared_N2 = 0.0, most_mm = 0.0;
      constexpr int kTicks = 20'000, kLast = 5000;
      for (int i = 0; i < kTicks; ++i) {
        const double now_s = 1000.0 + kFencingTick_s * i;
        const auto first = one.step(a.device(), other.socket, now_s);
        const auto second = other.step(b.device(), one.socket, now_s);
        const double pull_N = i < 2000 ? 0.0 : std::min(1.0, 1e-3 * (i - 2000));
        a.step(pull_N, first.force_N.y);
        b.step(pull_N, second.force_N.y);
        most_mm = std::max(most_mm, a.y_mm + b.y_mm);
        if (i < kTicks - kLast) continue;
        force_N += first.force_N.y / kLast;
        squared_N2 += first.force_N.y * first.force_N.y / kLast;
      }
      const double swing_N = std::sqrt(std::max(0.0, squared_N2 - force_N * force_N));
      std::printf("%-8s %3d ms: %.2f N felt, %.3f N of it swinging; at most %.1f mm deep\n",
                  std::string(teleop::kPredictorNames[static_cast<std::size_t>(predictor)]).c_str(), period_ms, force_N,
                  swing_N, most_mm);
      EXPECT_NEAR(force_N, -1.0, 0.05);  // what they press with
      EXPECT_LT(most_mm, 30.0);
      // Order 1 swings at a message each 10 ms: its slope is of as short a time.
      if (predictor == teleop::PredictorChoice::experts) {
        EXPECT_LT(swing_N, 0.02) << period_ms;
      }
    }
  }
}

/// The time constant depends on the age of the first message, here 0.4 s.
TEST(Fencing, ACorrectionOfTheDirectionTakesAsLongAsOneOfThePosition) {
  FencingSettings settings;
  settings.predictor = teleop::PredictorChoice::order0;
  settings.players.period_s = 0.5;
  FencingEnd one(settings), other(settings);
  one.start(1);
  other.start(2);
  const auto toldAt = [&](double now_s, const DeviceState& device) {
    static_cast<void>(other.step(device, now_s));
    const auto bytes = other.datagram(now_s);
    return std::vector<std::uint8_t>(bytes.begin(), bytes.end());
  };
  const std::vector<std::uint8_t> first = toldAt(1000.0, {});
  const std::vector<std::uint8_t> moved =
      toldAt(1000.5, {.position_mm = {0.0, 10.0, 0.0}, .orientation = {.gamma_rad = 0.02}});
  ASSERT_FALSE(first.empty() || moved.empty());
  double now_s = 1000.4;
  const auto believedAfter = [&](int milliseconds) {
    for (int i = 0; i < milliseconds; ++i, now_s += kFencingTick_s) static_cast<void>(one.step({}, now_s));
    EXPECT_EQ(one.phase(), TeleopEnd::Phase::linked);
    return one.other();
  };
  one.receive(first, now_s);
  const scene::Blade before = believedAfter(500);
  one.receive(moved, now_s);
  const double tau_s = teleop::defaultSmoothing_s(settings.players.period_s, 0.4);
  const scene::Blade meanwhile = believedAfter(static_cast<int>(std::lround(tau_s / kFencingTick_s)));
  const scene::Blade after = believedAfter(1500);
  const auto left = [](double from, double at, double to) { return (at - to) / (from - to); };
  const auto along = [](const scene::Blade& blade) { return blade.tip_mm.y - blade.grip_mm.y; };
  const double of_position = left(before.grip_mm.y, meanwhile.grip_mm.y, after.grip_mm.y);
  EXPECT_NEAR(of_position, 2.0 / M_E, 0.02);
  EXPECT_NEAR(left(along(before), along(meanwhile), along(after)), of_position, 0.02);
}

TEST(Fencing, WhoIsNotLinkedOrMeasuresNothingFeelsNothing) {
  const FencingSettings settings;
  Player one(settings, {}, 1), other(settings, {}, 2);
  PressingHand a{.y_mm = -4.0}, b{.y_mm = -4.0};
  double now_s = 1000.0;
  scene::SwordTouch first, second;
  const auto run = [&](int milliseconds, bool other_talks = true) {
    for (int i = 0; i < milliseconds; ++i, now_s += kFencingTick_s) {
      first = one.step(a.device(), other.socket, now_s);
      if (other_talks) second = other.step(b.device(), one.socket, now_s);
    }
  };
  a.y_mm = b.y_mm = 2.0;  // across each other, before anybody is there
  one.end.start(1);
  run(500);
  EXPECT_EQ(first.force_N, Vec3{});
  other.end.start(2);
  run(500);
  EXPECT_EQ(one.end.phase(), TeleopEnd::Phase::linked);
  EXPECT_EQ(first.force_N, Vec3{});  // they were so when they met
  one.end.stop();
  a.y_mm = b.y_mm = -4.0;
  run(100);
  one.end.start(3);
  run(500);
  EXPECT_EQ(first.force_N, Vec3{});
  a.y_mm = b.y_mm = 0.5;
  run(500);
  // 2 · 0.5 mm · 5 deep, across a blade that rises by 0.25 rad
  EXPECT_NEAR(first.force_N.y, -2.5, 0.1);
  EXPECT_NEAR(second.force_N.y, -2.5, 0.1);
  a.y_mm = std::nan("");
  run(10);
  EXPECT_EQ(first.force_N, Vec3{});
  EXPECT_NE(first.refusal, scene::Refusal::none);
  EXPECT_NEAR(second.force_N.y, -2.5, 0.1);
  a.y_mm = 0.5;
  run(1);
  EXPECT_NEAR(first.force_N.y, -2.5, 0.1);
  run(600, false);  // the other vanishes
  EXPECT_EQ(one.end.phase(), TeleopEnd::Phase::lost);
  EXPECT_EQ(first.force_N, Vec3{});
  run(500);
  EXPECT_EQ(one.end.phase(), TeleopEnd::Phase::linked);
  other.end.stop();
  run(100);
  EXPECT_EQ(first.force_N, Vec3{});
  EXPECT_EQ(second.force_N, Vec3{});
}

/// Real time, two threads and a relay between them, each with a clock of its own beat.
TEST(Fencing, TwoThreadsFenceThroughABadNetwork) {
  FencingSettings settings;
  NetworkSettings bad{.delay_ms = 30.0, .loss_percent = 20.0};
  Player one(settings, {}, 1), other(settings, {}, 2);
  auto relay = NetworkRelay::open({.listen = protocol::parseEndpoint("127.0.0.1:0").value(),
                                   .forward = other.socket.local(),
                                   .path = {.forward = bad, .backward = bad}})
                   .value();
  const std::jthread between([&](const std::stop_token& stop) { relay->run(stop); });
  struct Seen {
    std::atomic<double> force_N{0.0};
    std::atomic<bool> linked{false};
  } here, there;
  std::atomic<double> y_mm{-4.0};
  const auto playing = [&](Player& player, Seen& seen, bool calls) {
    return [&, calls](const std::stop_token& stop) {
      std::optional<protocol::Endpoint> to;
      if (calls) to = relay->local();
      player.end.start(calls ? 1 : 2);
      std::array<std::uint8_t, 4096> buffer{};
      while (!stop.stop_requested()) {
        const double now_s = toSeconds(std::chrono::steady_clock::now().time_since_epoch());
        while (const auto got = player.socket.socket().receive(buffer, Duration::zero())) {
          if (!calls) to = got->from;
          player.end.receive(std::span<const std::uint8_t>(buffer).first(got->size), now_s);
        }
        const auto touch = player.end.step(PressingHand{.y_mm = y_mm}.device(), now_s);
        if (const auto bytes = player.end.datagram(now_s); to && !bytes.empty()) {
          static_cast<void>(player.socket.socket().send(bytes, *to));
        }
        seen.force_N = touch.force_N.y;
        seen.linked = player.end.phase() == TeleopEnd::Phase::linked;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    };
  };
  const std::jthread first(playing(one, here, true)), second(playing(other, there, false));
  ASSERT_TRUE(comesTrue("both players to be linked", [&] { return here.linked && there.linked; }));
  // Apart for a second and across each other for a second: who is late for one finds the next.
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_TRUE(comesTrue("both to feel the other's sword",
                        [&] {
                          y_mm = std::fmod(toSeconds(std::chrono::steady_clock::now() - begin), 2.0) < 1.0 ? -4.0 : 0.5;
                          return std::abs(here.force_N + 2.5) < 0.1 && std::abs(there.force_N + 2.5) < 0.1;
                        }))
      << here.force_N << " N and " << there.force_N << " N, expected -2.5";
}

}  // namespace
}  // namespace fyd::sim
