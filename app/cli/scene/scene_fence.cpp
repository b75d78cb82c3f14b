// fyd scene fence: one of two players with a sword each, the other in another process or on another machine.
#include <cmath>
#include <deque>
#include <iostream>
#include <mutex>
#include <numbers>
#include <random>
#include <thread>

#include "app/cli/parts/output_file.h"
#include "app/cli/parts/probe_path.h"
#include "app/cli/parts/process_options.h"
#include "app/cli/parts/quantiles.h"
#include "app/cli/scene/scene_cli.h"
#include "core/base/end_signals.h"
#include "core/protocol/link/described_scene.h"
#include "core/protocol/link/device_message.h"
#include "core/protocol/udp_socket.h"
#include "core/scene/scene_digest.h"
#include "core/sim/gesture_card.h"
#include "core/sim/scene_file.h"
#include "core/sim/teleop/desktop_arm.h"
#include "core/sim/teleop/fencing_end.h"
#include "core/station/haptic_loop.h"
#include "core/teleop/prediction/predictor_choice.h"

namespace fyd::cli {
namespace {

struct FenceOptions {
  std::string scene, listen = "127.0.0.1:0", peer, path, card, predictor = "default", out;
  double strokes_Hz = 0.5, duration_s = 0.0;
  bool json = false;
};

constexpr double kWrist_rad_per_mm = 0.02;           // rotation per sideways motion of the hand
constexpr double kTell_s = 1.0;                      // interval of announcing the scene that this end uses
constexpr double kKept_s = 3.0;                      // history of estimates, compared with later messages
constexpr int kMostDatagrams = 64;                   // a step takes in; a flood must not hold the player up
constexpr std::size_t kMostAges = 1 << 20;           // 17 min of messages; then every new one replaces an old one
constexpr double kClock_s = 4.0 * 365.25 * 86400.0;  // the clock wraps; dates in messages span 8.9 years

/// Seconds of the system clock at the start, then of the monotonic clock. Two machines agree as well as their clocks
/// do.
class SharedClock {
 public:
  [[nodiscard]] double at(Instant now) const { return start_s_ + toSeconds(now - start_); }

 private:
  Instant start_ = Clock::now();
  double start_s_ =
      std::fmod(std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count(), kClock_s);
};

/// Where the player's hand is, at a time from the start.
class Hand {
 public:
  explicit Hand(const FenceOptions& options) : strokes_Hz_(options.strokes_Hz) {
    if (!options.path.empty()) path_ = readProbePath(options.path);
    if (!options.card.empty()) card_ = valueOrFail(sim::readFingerFile(options.card));
  }

  [[nodiscard]] sim::DeviceState at(double t_s) const {
    Vec3 place;
    if (path_) {
      place = alongPath(t_s);
    } else if (card_) {
      const sim::FingerState finger = card_->at(t_s);
      place = {finger.x_mm, finger.y_mm, -finger.indentation_mm};
    } else {
      const double w = 2.0 * std::numbers::pi * strokes_Hz_;
      place = {2.0 * std::sin(0.37 * w * t_s), 4.0 * std::sin(w * t_s), 2.0 * std::sin(0.53 * w * t_s)};
    }
    return {.position_mm = place,
            .velocity_mm_per_s = {},
            .force_N = {},
            .orientation = {0.0, -scene::kBladesRise_rad, kWrist_rad_per_mm * place.y}};
  }

 private:
  [[nodiscard]] Vec3 alongPath(double t_s) const {
    const std::vector<double>& times = path_->time_s;
    const double at_s = times.front() + std::fmod(t_s, std::max(1e-3, times.back() - times.front()));
    const auto after = static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), at_s) - times.begin());
    if (after >= times.size()) return path_->probe_mm.back();
    const double share = (at_s - times[after - 1]) / (times[after] - times[after - 1]);
    return path_->probe_mm[after - 1] + share * (path_->probe_mm[after] - path_->probe_mm[after - 1]);
  }

  double strokes_Hz_;
  std::optional<ProbePath> path_;
  std::optional<sim::FingerPath> card_;
};

struct Figures {
  std::uint64_t sent = 0, received = 0, from_others = 0, not_understood = 0, touching = 0, contacts = 0, steps = 0;
  double largest_force_N = 0.0, first_s = 0.0, last_s = 0.0, squares_mm2 = 0.0;
  std::uint64_t compared = 0;
  std::vector<double> ages_ms;
};

struct Addresses {
  protocol::Endpoint own;
  std::optional<protocol::Endpoint> peer;
};

Addresses addressesOf(const FenceOptions& options) {
  Addresses out{.own = endpointOrUsageError("--listen", options.listen), .peer = {}};
  if (options.peer.empty()) return out;
  out.peer = partnerOrUsageError("--peer", options.peer);
  requireOneFamily({"--listen", out.own}, {"--peer", *out.peer});
  return out;
}

class Player {
 public:
  /// @param out of the rows; none: null
  Player(const FenceOptions& options, const Addresses& addresses, const sim::FencingSettings& settings,
         std::string digest, std::unique_ptr<OutputFile> out)
      : settings_(settings),
        digest_(std::move(digest)),
        socket_(valueOrFail(protocol::UdpSocket::open(addresses.own))),
        peer_(addresses.peer),
        hand_(options),
        end_(settings),
        out_(std::move(out)) {
    end_.start(static_cast<std::uint16_t>(std::random_device{}()));
    if (out_) {
      rows_ =
          "t_s,own_grip_x_mm,own_grip_y_mm,own_grip_z_mm,other_grip_x_mm,other_grip_y_mm,other_grip_z_mm,"
          "force_x_N,force_y_N,force_z_N,touching\n";
    }
  }

  [[nodiscard]] const protocol::Endpoint& local() const { return socket_.local(); }

  void step(Instant now) {
    const double now_s = clock_.at(now);
    if (figures.steps++ == 0) began_s_ = now_s;
    for (int taken = 0; taken < kMostDatagrams; ++taken) {
      const auto got = socket_.receive(buffer_, Duration::zero());
      if (!got) break;
      take(std::span<const std::uint8_t>(buffer_).first(got->size), got->from, now_s);
    }
    const scene::SwordTouch touch = end_.step(hand_.at(now_s - began_s_), now_s);
    if (linked()) {
      ever_linked_ = true;
      remember(now_s);
    }
    to_compare_.clear();
    figures.touching += touch.touching ? 1 : 0;
    figures.contacts += touch.began ? 1 : 0;
    figures.largest_force_N = std::max(figures.largest_force_N, touch.force_N.norm());
    say(end_.datagram(now_s));
    if (now_s >= tell_s_) {
      tell_s_ = now_s + kTell_s;
      const std::string words = protocol::describedWith("FYD fencing", digest_);
      say({reinterpret_cast<const std::uint8_t*>(words.data()), words.size()});
    }
    if (!out_) return;
    const Vec3 &own = end_.own().grip_mm, &other = end_.other().grip_mm, &f = touch.force_N;
    const std::string row = fmt::format("{:.6f},{},{},{},{},{},{},{},{},{},{}\n", now_s - began_s_, own.x, own.y, own.z,
                                        other.x, other.y, other.z, f.x, f.y, f.z, touch.touching ? 1 : 0);
    const std::lock_guard lock(rows_mutex_);
    rows_ += row;
  }

  /// Those of the steps so far, from any thread but that of the steps: a slow disk must not hold the player up.
  void writeRows() {
    if (!out_) return;
    std::string rows;
    {
      const std::lock_guard lock(rows_mutex_);
      rows.swap(rows_);
    }
    if (!rows.empty()) out_->write(rows);
    out_->flush();
  }
  /// @throws Failure when not all rows reached the file
  void closeRows() {
    if (out_) out_->close();
  }

  void farewell() {
    end_.stop();
    for (int i = 0; i < sim::TeleopEnd::kFarewells; ++i) {
      std::this_thread::sleep_for(fromSeconds(settings_.players.period_s));
      say(end_.datagram(clock_.at(Clock::now())));
    }
  }

  [[nodiscard]] protocol::SceneCopies scenes() const {
    return there_ ? protocol::compareScenes(digest_, *there_) : protocol::SceneCopies::none;
  }
  [[nodiscard]] bool linked() const { return end_.phase() == sim::TeleopEnd::Phase::linked; }
  [[nodiscard]] bool everLinked() const { return ever_linked_; }
  /// What the first message that was dated too far from now says of the clocks; empty: none was.
  [[nodiscard]] const Message& otherClock() const { return other_clock_; }

  Figures figures;

 private:
  void say(std::span<const std::uint8_t> bytes) {
    if (!bytes.empty() && peer_ && socket_.send(bytes, *peer_) == protocol::SendOutcome::sent) ++figures.sent;
  }

  void take(std::span<const std::uint8_t> bytes, const protocol::Endpoint& from, double now_s) {
    if (peer_ && !(from == *peer_)) {
      ++figures.from_others;
      return;
    }
    const std::string_view words(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (const std::string_view digest = protocol::describedScene(words); !digest.empty()) {
      peer_ = from;
      there_ = digest;
      return;
    }
    const auto message = protocol::decodeDeviceMessage(bytes, code_);
    if (!message) {
      ++figures.not_understood;
      return;
    }
    peer_ = from;
    end_.receive(bytes, now_s);
    if (!message->running) return;
    if (figures.received++ == 0) figures.first_s = message->date_s;
    figures.last_s = std::max(figures.last_s, message->date_s);
    const double age_ms = 1e3 * (now_s - message->date_s);
    if (other_clock_.empty() && std::abs(age_ms) > 1e3 * sim::TeleopEnd::kLost_s) {
      const double apart_s = 1e-3 * std::abs(age_ms);
      other_clock_ =
          age_ms < 0.0
              ? fyd::say("the other player's clock is {:.1f} s ahead of this one; set both", apart_s)
              : fyd::say("the other player's clock is {:.1f} s behind this one, or the network is slow", apart_s);
      std::cerr << fmt::format("{}\n", other_clock_);
    }
    if (figures.ages_ms.size() < kMostAges) {
      figures.ages_ms.push_back(age_ms);
    } else {
      figures.ages_ms[figures.received % kMostAges] = age_ms;
    }
    to_compare_.push_back(*message);
  }

  void remember(double now_s) {
    believed_.emplace_back(now_s, end_.other().grip_mm);
    while (now_s - believed_.front().first > kKept_s) believed_.pop_front();
    for (const protocol::DeviceMessage& message : to_compare_) compare(message);
  }

  /// Compares the position in a message with the estimate for its date.
  void compare(const protocol::DeviceMessage& message) {
    const auto then = std::ranges::lower_bound(believed_, message.date_s, {}, &std::pair<double, Vec3>::first);
    if (then == believed_.end() || then == believed_.begin()) return;
    const Vec3 was = sim::asTheOtherSees(settings_, sim::swordOf(settings_, message.position_mm, {})).grip_mm;
    const double apart_mm = (then->second - was).norm();
    figures.squares_mm2 += apart_mm * apart_mm;
    ++figures.compared;
  }

  sim::FencingSettings settings_;
  std::string digest_;
  protocol::UdpSocket socket_;
  std::optional<protocol::Endpoint> peer_;
  protocol::PositionCode code_ = *protocol::PositionCode::make(sim::DesktopArm::workspace());
  Hand hand_;
  sim::FencingEnd end_;
  SharedClock clock_;
  double began_s_ = 0.0, tell_s_ = 0.0;
  bool ever_linked_ = false;
  Message other_clock_;
  std::optional<std::string> there_;
  std::deque<std::pair<double, Vec3>> believed_;
  std::vector<protocol::DeviceMessage> to_compare_;  // of this step
  std::unique_ptr<OutputFile> out_;
  std::mutex rows_mutex_;
  std::string rows_;  // not written yet
  std::vector<std::uint8_t> buffer_ = std::vector<std::uint8_t>(protocol::kMaximumDatagram);
};

nlohmann::ordered_json fencingSummary(Player& player, const sim::FencingSettings& settings, std::uint64_t missed) {
  Figures& f = player.figures;
  const double expected = 1.0 + std::round((f.last_s - f.first_s) / settings.players.period_s);
  const Quantiles ages = f.ages_ms.empty() ? Quantiles{NAN, NAN, NAN} : quantiles(f.ages_ms);
  return {
      {"linked", player.everLinked()},
      {"steps", f.steps},
      {"missed_cycles", missed},
      {"datagrams_sent", f.sent},
      {"messages_received", f.received},
      {"loss_percent",
       jsonNumber(f.received == 0 ? NAN : std::max(0.0, 100.0 * (1.0 - static_cast<double>(f.received) / expected)))},
      {"age_median_ms", jsonNumber(ages.p50)},
      {"age_p99_ms", jsonNumber(ages.p99)},
      {"datagrams_from_others", f.from_others},
      {"datagrams_not_understood", f.not_understood},
      {"scenes", protocol::kSceneCopies[static_cast<std::size_t>(player.scenes())]},
      {"contacts", f.contacts},
      {"contact_s", 1e-3 * static_cast<double>(f.touching)},
      {"largest_force_N", f.largest_force_N},
      {"other_grip_error_mm_rms",
       jsonNumber(f.compared == 0 ? NAN : std::sqrt(f.squares_mm2 / static_cast<double>(f.compared)))}};
}

void fence(const FenceOptions& options) {
  const auto predictor = teleop::predictorNamed(options.predictor);
  if (!predictor) throw UsageError(about("--predictor", predictor.error().message));
  const Addresses addresses = addressesOf(options);
  const scene::LoadedScene file = valueOrFail(sim::openScene(options.scene));
  if (!file.description.swords) throw Failure(say("{}: no [swords] to fence with", options.scene));
  const sim::FencingSettings settings{
      .swords = *file.description.swords, .players = file.description.fencing, .predictor = *predictor};
  std::unique_ptr<OutputFile> out;
  if (!options.out.empty()) {
    out = std::make_unique<OutputFile>(options.out, std::vector{options.scene, options.path, options.card});
  }
  Player player(options, addresses, settings, digestOf(file), std::move(out));
  std::cerr << fmt::format("fencing on {} with {}\n", protocol::toString(player.local()),
                           options.peer.empty() ? "whoever speaks first" : options.peer);
  station::HapticLoop loop;
  bool linked = false;
  auto scenes = protocol::SceneCopies::none;
  const auto play = [&](const std::stop_token& stop) {
    std::stop_source ended;
    const std::stop_callback interrupted(stop, [&ended] { ended.request_stop(); });
    const Instant start = Clock::now();
    loop.run(ended.get_token(), false, [&](Instant now, std::uint64_t /*missed*/) {
      player.step(now);
      if (player.linked() != std::exchange(linked, player.linked())) {
        std::cerr << (linked ? "the other player is there\n" : "the other player is gone\n");
      }
      if (const auto copies = player.scenes(); copies != std::exchange(scenes, copies)) {
        std::cerr << protocol::toString(copies) << '\n';
      }
      // The signal is looked at here as well: whoever else does may be held up by the file.
      const bool over = options.duration_s > 0.0 && toSeconds(now - start) >= options.duration_s;
      if (over || endSignal() != 0) ended.request_stop();
    });
    player.farewell();
  };
  runUntilInterrupted(play, [&player] { player.writeRows(); });
  player.writeRows();
  if (!player.everLinked()) {
    const std::string& whom = options.peer.empty() ? options.listen : options.peer;
    if (!player.otherClock().empty()) throw Failure(about(whom, player.otherClock()));
    throw Failure(say("{}: no other player answered", whom));
  }
  printSummary(fencingSummary(player, settings, loop.missedCycles()), options.json);
  player.closeRows();
}

}  // namespace

void addSceneFence(CLI::App& scene) {
  auto options = std::make_shared<FenceOptions>();
  CLI::App* command =
      scene.add_subcommand("fence", "One of two players with swords; the other is another fyd scene fence");
  command
      ->add_option("scene", options->scene,
                   "Scene file with [swords], or the name of one that comes along; both players hold a copy")
      ->required();
  command->add_option("--listen", options->listen, "Own address, HOST:PORT; port 0: any")->capture_default_str();
  command->add_option("--peer", options->peer, "The other player's address, HOST:PORT; left out: whoever speaks first");
  auto* path =
      command->add_option("--path", options->path, "What the hand does: CSV with t_s, x_mm, y_mm, z_mm; repeats");
  auto* card = command->add_option("--card", options->card, "What the hand does: a gesture card")->excludes(path);
  command->add_option("--strokes", options->strokes_Hz, "Without those: strokes from side to side, so many a second")
      ->check(numberFrom(0.0, 10.0))
      ->excludes(path)
      ->excludes(card)
      ->capture_default_str();
  command->add_option("--predictor", options->predictor, "order0, order1, hybrid, kalman, ar or default")
      ->capture_default_str();
  command->add_option("-o,--out", options->out, "CSV to write, a row each millisecond");
  addRunOptions(*command, options->duration_s, options->json, "Ctrl-C");
  command->callback([options] { fence(*options); });
}

}  // namespace fyd::cli
