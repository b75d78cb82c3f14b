#include "core/sim/teleop/teleop_run.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/portable_math.h"
#include "core/sim/teleop/desktop_arm.h"

namespace fyd::sim {
namespace {

using teleop::Position;
using teleop::Trace;

constexpr double kStep_s = 0.001;
constexpr int kParts = 10;  // of a step, for the mechanics
constexpr double kHand_kg = 0.5, kHand_N_per_m = 1000.0, kHand_N_s_per_m = 30.0;
constexpr double kRoom = 0.9;  // of the workspace
constexpr double kWallDamping_N_s_per_m = 1.0;
constexpr double kRadiansPerMillimetre = 0.02;  // how the hand turns as it moves
constexpr int kMostDelay_ms = 2000, kDelayEvery = 5;
constexpr double kDateStep_s = 1e-6;  // of a message
constexpr double kBeyond = 1.2;
constexpr int kBeyond_ms = 50;

Vec3 vectorOf(const Position& p) { return {p[0], p[1], p[2]}; }
Position positionOf(const Vec3& v) { return {v.x, v.y, v.z}; }

double square(const Position& a, const Position& b) {
  return math::square(a[0] - b[0]) + math::square(a[1] - b[1]) + math::square(a[2] - b[2]);
}

/// The recording at 1 kHz about the middle of the workspace; gaps are interpolated linearly.
struct Recorded {
  std::vector<Position> at_mm;
  double scale = 1.0;
};

Recorded resampled(const Trace& trace) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < trace.time_s.size(); ++i) {
    if (!trace.gap(i)) rows.push_back(i);
  }
  Recorded out;
  if (rows.empty()) return out;
  Position low = trace.position_mm[rows.front()], high = low;
  for (const std::size_t row : rows) {
    for (std::size_t a = 0; a < low.size(); ++a) {
      low[a] = std::min(low[a], trace.position_mm[row][a]);
      high[a] = std::max(high[a], trace.position_mm[row][a]);
    }
  }
  const Position side = positionOf(DesktopArm::kWorkspace_mm);
  for (std::size_t a = 0; a < side.size(); ++a) {
    if (high[a] > low[a]) out.scale = std::min(out.scale, kRoom * side[a] / (high[a] - low[a]));
  }
  const double start_s = trace.time_s[rows.front()];
  const auto ticks = static_cast<std::size_t>(std::llround((trace.time_s[rows.back()] - start_s) / kStep_s)) + 1;
  std::size_t next = 1;
  for (std::size_t i = 0; i < ticks; ++i) {
    const double t = start_s + kStep_s * static_cast<double>(i);
    while (next + 1 < rows.size() && trace.time_s[rows[next]] <= t) ++next;
    const std::size_t after = rows[std::min(next, rows.size() - 1)],
                      before = rows[std::min(next, rows.size() - 1) - (rows.size() > 1 ? 1 : 0)];
    const double span = trace.time_s[after] - trace.time_s[before];
    const double share = span > 0.0 ? std::clamp((t - trace.time_s[before]) / span, 0.0, 1.0) : 1.0;
    Position& at = out.at_mm.emplace_back();
    for (std::size_t a = 0; a < at.size(); ++a) {
      const double there =
          trace.position_mm[before][a] + share * (trace.position_mm[after][a] - trace.position_mm[before][a]);
      at[a] = out.scale * (there - 0.5 * (low[a] + high[a]));
    }
  }
  return out;
}

template <class Item>
class Way {
 public:
  explicit Way(const NetworkSettings& settings) : emulator_(settings) {}
  void send(const Item& item, std::size_t bytes, double now_s) {
    const Passage passage = emulator_.pass(bytes, instantAt(now_s));
    for (const Instant at : passage.out) underway_.emplace(toSeconds(at.time_since_epoch()), item);
  }
  template <class Take>
  void deliver(double now_s, Take&& take) {
    for (; !underway_.empty() && underway_.begin()->first <= now_s + 1e-9; underway_.erase(underway_.begin())) {
      take(underway_.begin()->second);
    }
  }

 private:
  NetworkEmulator emulator_;
  std::multimap<double, Item> underway_;
};

using DatagramBytes = std::vector<std::uint8_t>;

/// The path's longest delay, without jitter and queue.
double delay_s(const NetworkSettings& way) {
  double most_ms = way.delay_ms;
  for (const double each : way.trace.delay_ms) most_ms = std::isfinite(each) ? std::max(most_ms, each) : most_ms;
  return 1e-3 * most_ms;
}

/// Compares an end's knowledge of the other one, some time later, with the true value.
class Told {
 public:
  Told(const TeleopEnd& end, std::size_t channel, double later_s)
      : end_(end), channel_(channel), later_(static_cast<std::size_t>(std::llround(later_s / kStep_s))) {}

  /// Each step; only those at which both are linked are asked about: an end that is not linked sends a message each
  /// period, whatever leaves the band meanwhile.
  /// @return the step that is asked about and the answer, if it is known
  std::optional<std::pair<std::size_t, teleop::DeadbandReceiver::Answer>> step(double truth, bool linked) {
    truth_.push_back(linked ? truth : std::nan(""));
    if (truth_.size() <= later_) return std::nullopt;
    const std::size_t asked = truth_.size() - 1 - later_;
    if (std::isnan(truth_[asked])) return std::nullopt;
    const auto answer = end_.told(kStep_s * static_cast<double>(asked) + kDateStep_s);
    asked_ += 1.0;
    if (!answer.known) return std::nullopt;
    known_ += 1.0;
    const double band = end_.channels()[channel_].band(answer.value[channel_], answer.slope[channel_]);
    worst_ = std::max(worst_, std::abs(truth_[asked] - answer.value[channel_]) / band);
    return std::pair{asked, answer};
  }
  [[nodiscard]] double share() const { return asked_ > 0.0 ? known_ / asked_ : std::nan(""); }
  [[nodiscard]] double worst() const { return known_ > 0.0 ? worst_ : std::nan(""); }

 private:
  const TeleopEnd& end_;
  std::size_t channel_;
  std::size_t later_;
  std::vector<double> truth_;  ///< NaN: not both linked
  double asked_ = 0.0, known_ = 0.0, worst_ = 0.0;
};

/// Delay of the far motion behind the hand's: the first minimum of their mean squared distance over the shift.
double delayOf(const std::vector<TeleopRow>& rows, std::size_t from) {
  double best = std::numeric_limits<double>::infinity();
  int delay_ms = 0;
  const int most = std::min<int>(kMostDelay_ms, static_cast<int>((rows.size() - from) / 2));
  for (int by = 0; by <= most; by += by < 100 ? 1 : 5) {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = from + static_cast<std::size_t>(most); i < rows.size(); i += kDelayEvery, ++count) {
      sum += square(rows[i].far_mm, rows[i - static_cast<std::size_t>(by)].hand_mm);
    }
    if (sum > kBeyond * best && by > delay_ms + kBeyond_ms) break;  // a later minimum is another swing's
    if (count == 0 || !(sum < best)) continue;
    best = sum;
    delay_ms = by;
  }
  return delay_ms;
}

}  // namespace

Result<void> checkTeleopRun(const TeleopRunSettings& settings) {
  const auto within = [](double value, double least, double most) { return value >= least && value <= most; };
  if (!within(settings.period_ms, 1.0, 10'000.0)) {
    return fail("period {} ms: expected 1 … 10000", settings.period_ms);
  }
  if (settings.smooth_ms && !within(*settings.smooth_ms, 0.0, 1000.0)) {
    return fail("smoothing {} ms: expected 0 … 1000", *settings.smooth_ms);
  }
  if (!within(settings.deadband_percent, 0.0, 100.0)) {
    return fail("deadband {} %: expected 0 (none) … 100", settings.deadband_percent);
  }
  if (!within(settings.wall_N_per_m, 0.0, 20'000.0)) {
    return fail("wall {} N/m: expected 0 (none) … 20000", settings.wall_N_per_m);
  }
  if (auto good = checkNetwork(settings.path.forward); !good) return good;
  return checkNetwork(settings.path.backward);
}

TeleopFigures runTeleop(const Trace& trace, const TeleopRunSettings& settings, std::vector<TeleopRow>* rows_out) {
  const Recorded recorded = resampled(trace);
  TeleopFigures out{.scale = recorded.scale};
  if (recorded.at_mm.empty()) return out;
  TeleopEndSettings end{.at_hand = true,
                        .coupling = settings.coupling,
                        .coupling_settings = {.stiffness_N_per_m = 1000.0,
                                              .damping_N_s_per_m = std::sqrt(1000.0 * DesktopArm::kMass_kg),
                                              .most_force_N = DesktopArm::kMostForce_N},
                        .predictor = settings.predictor,
                        .smooth_s = settings.smooth_ms ? std::optional(1e-3 * *settings.smooth_ms) : std::nullopt,
                        .period_s = 1e-3 * settings.period_ms,
                        .deadband = 1e-2 * settings.deadband_percent};
  TeleopEnd hand_end(end);
  end.at_hand = false;
  TeleopEnd far_end(end);
  hand_end.start(1);
  far_end.start(2);
  const Vec3 begin = vectorOf(recorded.at_mm.front());
  DesktopArm hand(kHand_kg, begin), far(0.0, begin);
  Way<DatagramBytes> there(settings.path.forward), back(settings.path.backward);
  const double there_s = delay_s(settings.path.forward), back_s = delay_s(settings.path.backward);
  Told told_place(far_end, 0, kQueryDelay_s + there_s), told_force(hand_end, 3, kQueryDelay_s + back_s);
  std::vector<TeleopRow> rows;
  double packets = 0.0, back_packets = 0.0, drag = 0.0, drag_ticks = 0.0, turned = 0.0, held = 0.0, energy_J = 0.0;
  double turned_ticks = 0.0, linked_ticks = 0.0, least_J = 0.0;
  std::size_t first_linked = recorded.at_mm.size();
  Vec3 wall{};
  protocol::Orientation last_heard;
  bool heard = false;
  const auto angles = [](const Vec3& at) {
    return protocol::Orientation{kRadiansPerMillimetre * at.x * 2.0, kRadiansPerMillimetre * at.y,
                                 kRadiansPerMillimetre * (at.x + at.z)};
  };
  const auto code = *protocol::PositionCode::make(DesktopArm::workspace());
  for (std::size_t i = 0; i < recorded.at_mm.size(); ++i) {
    const double t = kStep_s * static_cast<double>(i);
    there.deliver(t, [&](const DatagramBytes& each) {
      far_end.receive(each, t);
      if (const auto message = protocol::decodeDeviceMessage(each, code)) last_heard = message->orientation;
      heard = true;
    });
    back.deliver(t, [&](const DatagramBytes& each) { hand_end.receive(each, t); });
    const protocol::Orientation turn = angles(hand.position_mm());
    const Vec3 felt = hand_end.step({hand.measured_mm(), hand.velocity_mm_per_s(), {}, turn}, t);
    const Vec3 drive = far_end.step({far.measured_mm(), far.velocity_mm_per_s(), wall, {}}, t);
    for (auto* which : {&hand_end, &far_end}) {
      const auto bytes = which->datagram(t);
      if (bytes.empty()) continue;
      out.message_bits = std::max(out.message_bits, 8.0 * static_cast<double>(bytes.size() + 28));
      (which == &hand_end ? packets : back_packets) += 1.0;
      (which == &hand_end ? there : back).send(DatagramBytes(bytes.begin(), bytes.end()), bytes.size(), t);
    }
    const bool linked = far_end.phase() == TeleopEnd::Phase::linked;
    if (linked) {
      first_linked = std::min(first_linked, i);
      linked_ticks += 1.0;
    }
    if (linked && heard) {
      const auto truth = teleop::fromAngles(turn.alpha_rad, turn.beta_rad, turn.gamma_rad);
      turned += math::square(teleop::angle_deg(far_end.otherOrientation(), truth));
      held += math::square(teleop::angle_deg(
          teleop::fromAngles(last_heard.alpha_rad, last_heard.beta_rad, last_heard.gamma_rad), truth));
      turned_ticks += 1.0;
    }
    rows.push_back({.t_s = t,
                    .hand_mm = positionOf(hand.position_mm()),
                    .far_mm = positionOf(far.position_mm()),
                    .wanted_mm = far_end.other_mm(),
                    .hand_force_N = -felt.x,
                    .far_force_N = wall.x});
    if (settings.deadband_percent > 0.0) {
      const bool both = linked && hand_end.phase() == TeleopEnd::Phase::linked;
      if (const auto known = told_place.step(hand.measured_mm().x, both)) {
        rows[known->first].told_x_mm = known->second.value[0];
        rows[known->first].told_x_mm_per_s = known->second.slope[0];
      }
      if (const auto known = told_force.step(wall.x, both)) rows[known->first].told_force_N = known->second.value[3];
    }
    if (wall.x == 0.0) {
      drag += felt.norm();
      drag_ticks += 1.0;
    }
    const Vec3 before = hand.position_mm();
    const Position& want = recorded.at_mm[i];
    const Position& want_before = recorded.at_mm[i > 0 ? i - 1 : 0];
    for (int part = 0; part < kParts; ++part) {
      const double share = static_cast<double>(part) / kParts;
      Position arm{};
      const Position at = positionOf(hand.position_mm()), v = positionOf(hand.velocity_mm_per_s());
      for (std::size_t a = 0; a < arm.size(); ++a) {
        const double speed = (want[a] - want_before[a]) / kStep_s;
        const double target = want_before[a] + share * (want[a] - want_before[a]);
        arm[a] = 1e-3 * (kHand_N_per_m * (target - at[a]) + kHand_N_s_per_m * (speed - v[a]));
      }
      hand.step(felt, vectorOf(arm), kStep_s / kParts);
      const double deep = far.position_mm().x;
      wall.x = settings.wall_N_per_m > 0.0 && deep > 0.0
                   ? std::max(0.0, 1e-3 * (settings.wall_N_per_m * deep +
                                           kWallDamping_N_s_per_m * far.velocity_mm_per_s().x))
                   : 0.0;
      far.step(drive, {-wall.x, 0.0, 0.0}, kStep_s / kParts);
    }
    const Vec3 moved = hand.position_mm() - before;
    energy_J -= 1e-3 * (felt.x * moved.x + felt.y * moved.y + felt.z * moved.z);
    least_J = std::min(least_J, energy_J);
  }
  const auto ticks = static_cast<double>(rows.size());
  out.seconds = kStep_s * ticks;
  out.linked_share = linked_ticks / ticks;
  out.least_energy_J = least_J;
  out.energy_J = energy_J;
  out.dissipated_J = hand_end.telemetry().dissipated_J + far_end.telemetry().dissipated_J;
  out.packets_per_s = packets / out.seconds;
  out.back_packets_per_s = back_packets / out.seconds;
  out.packets_without_per_s = 1e3 / settings.period_ms;
  out.told_share = told_place.share();
  out.told_force_share = told_force.share();
  out.deadband_worst = told_place.worst();
  out.deadband_force_worst = told_force.worst();
  out.drag_N = drag_ticks > 0.0 ? drag / drag_ticks : std::nan("");
  out.orientation_rms_deg = std::sqrt(turned / turned_ticks);
  out.orientation_held_rms_deg = std::sqrt(held / turned_ticks);
  Trace truth{.axes = 3, .time_s = {}, .position_mm = {}};
  teleop::TrialPlan plan;
  std::vector<Position> tool, believed;
  for (std::size_t i = first_linked; i < rows.size(); ++i) {
    plan.ticks.push_back({.row = truth.time_s.size(), .begins = i == first_linked});
    truth.time_s.push_back(rows[i].t_s);
    truth.position_mm.push_back(rows[i].hand_mm);
    tool.push_back(rows[i].far_mm);
    believed.push_back(rows[i].wanted_mm);
  }
  if (tool.size() > 10) {
    const teleop::TrialFigures of_tool = trialFigures(truth, plan, tool),
                               of_belief = trialFigures(truth, plan, believed);
    out.rms_error_mm = of_tool.rms_mm;
    out.max_error_mm = of_tool.max_mm;
    out.believed_rms_mm = of_belief.rms_mm;
    out.believed_max_mm = of_belief.max_mm;
    out.jerk_ratio = of_tool.jerk_ratio;
    out.vibration_ratio = of_tool.vibration_ratio;
    out.largest_step_mm = of_tool.largest_step_mm;
    out.added_delay_ms = delayOf(rows, first_linked);
  }
  if (rows_out) *rows_out = std::move(rows);
  return out;
}

}  // namespace fyd::sim
