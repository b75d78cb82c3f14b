#include "core/teleop/prediction/prediction_trial.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "core/base/csv.h"
#include "core/base/median.h"
#include "core/signal/welch.h"
#include "core/teleop/prediction/motion_history.h"
#include "core/teleop/prediction/smooth_output.h"

namespace fyd::teleop {
namespace {

constexpr double kSameTime_s = 1e-6;              // tolerance for the rounding of the rows' times
constexpr double kLeastVibrationRate_Hz = 999.0;  // 1 kHz, less the rounding of the rows' times
constexpr int kSegment = 1024;                    // samples per segment of the spectrum: 1 Hz resolution at 1 kHz
constexpr double kLow_Hz = 20.0, kHigh_Hz = 200.0;
constexpr double kLongest_ms = 10'000.0;  // period, delay and jitter

/// Uniform in [0, 1), the same on every machine.
double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

double distance(const Position& a, const Position& b) {
  double squares = 0.0;
  for (std::size_t i = 0; i < kMostAxes; ++i) squares += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(squares);
}

struct Sent {
  TrialMessage message;
  double sent_s;
};

std::vector<Sent> sentMessages(const Trace& trace, const TrialNetwork& network) {
  std::vector<Sent> out;
  std::mt19937_64 random(network.seed);
  const auto send = [&](std::size_t row, double at_s) {
    const double jitter_ms = network.jitter_ms * uniform(random);
    const bool lost = 100.0 * uniform(random) < network.loss_percent;
    if (lost || trace.gap(row)) return;
    out.push_back({{row, at_s + (network.delay_ms + jitter_ms) * 1e-3}, at_s});
  };
  if (network.period_ms <= 0.0) {
    for (std::size_t row = 0; row < trace.time_s.size(); ++row) send(row, trace.time_s[row]);
  } else {
    const double start_s = trace.time_s.front();
    std::size_t row = 0;
    for (std::size_t n = 0;; ++n) {
      const double at_s = start_s + static_cast<double>(n) * network.period_ms * 1e-3;
      if (at_s > trace.time_s.back() + kSameTime_s) break;
      while (row + 1 < trace.time_s.size() && trace.time_s[row + 1] <= at_s + kSameTime_s) ++row;
      send(row, at_s);
    }
  }
  std::ranges::stable_sort(out, {}, [](const Sent& each) { return each.message.arrival_s; });
  return out;
}

/// Power of a motion's velocity between 20 and 200 Hz, times its number of samples.
double bandPower(std::span<const Position> motion, std::size_t axes, double rate_Hz) {
  if (motion.size() < 3) return 0.0;
  double power = 0.0;
  std::vector<double> velocity(motion.size() - 1);
  for (std::size_t a = 0; a < axes; ++a) {
    for (std::size_t i = 0; i < velocity.size(); ++i) velocity[i] = (motion[i + 1][a] - motion[i][a]) * rate_Hz;
    const signal::Spectrum spectrum = signal::welch(velocity, rate_Hz, kSegment);
    for (std::size_t k = 0; k < spectrum.density.size(); ++k) {
      if (spectrum.frequency_Hz(k) < kLow_Hz || spectrum.frequency_Hz(k) > kHigh_Hz) continue;
      power += spectrum.density[k] * spectrum.resolution_Hz;
    }
  }
  return power * static_cast<double>(velocity.size());
}

double jerkPower(std::span<const Position> motion, std::size_t axes) {
  double power = 0.0;
  for (std::size_t i = 3; i < motion.size(); ++i) {
    for (std::size_t a = 0; a < axes; ++a) {
      const double third = motion[i][a] - 3.0 * motion[i - 1][a] + 3.0 * motion[i - 2][a] - motion[i - 3][a];
      power += third * third;
    }
  }
  return power;
}

double ratio(double out, double truth) {
  return truth > 0.0 ? std::sqrt(out / truth) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

bool Trace::gap(std::size_t row) const {
  return std::ranges::any_of(position_mm[row], [](double x) { return std::isnan(x); });
}

double Trace::rate_Hz() const {
  std::vector<double> apart;
  for (std::size_t i = 1; i < time_s.size(); ++i) apart.push_back(time_s[i] - time_s[i - 1]);
  return 1.0 / median(std::move(apart));
}

Result<void> checkTrace(const Trace& trace) {
  if (trace.axes < 1 || trace.axes > kMostAxes) return fail("{} axes; expected 1 to {}", trace.axes, kMostAxes);
  if (trace.position_mm.size() != trace.time_s.size()) {
    return fail("{} positions for {} times; expected one for each", trace.position_mm.size(), trace.time_s.size());
  }
  if (trace.time_s.size() < 2) return fail("{} rows; expected two and more", trace.time_s.size());
  bool some = false;
  for (std::size_t i = 0; i < trace.time_s.size(); ++i) {
    if (!std::isfinite(trace.time_s[i]) || (i > 0 && !(trace.time_s[i] > trace.time_s[i - 1]))) {
      return fail("row {}: time {} s; expected one later than the row before", i + 1, trace.time_s[i]);
    }
    for (const double x : trace.position_mm[i]) {
      if (std::abs(x) > MotionHistory::kLargestCoordinate_mm) {
        return fail("row {}: position {} mm; expected one within ±{}, or NaN in a gap", i + 1, x,
                    MotionHistory::kLargestCoordinate_mm);
      }
    }
    some = some || !trace.gap(i);
  }
  if (!some) return fail("{} rows, none of them with a position; expected one and more", trace.time_s.size());
  return checkLength(trace, kLongestTrace_s);
}

Result<void> checkLength(const Trace& trace, double most_s) {
  if (trace.time_s.empty()) return {};
  return fyd::checkLength(trace.time_s.back() - trace.time_s.front(), most_s);
}

Result<void> checkNetwork(const TrialNetwork& network) {
  const auto within = [](double value, double least, double most) { return value >= least && value <= most; };
  if (network.period_ms != 0.0 && !within(network.period_ms, 0.1, kLongest_ms)) {
    return fail("period {} ms: expected 0 (each row) or 0.1 … {}", network.period_ms, kLongest_ms);
  }
  if (!within(network.delay_ms, 0.0, kLongest_ms)) {
    return fail("delay {} ms: expected 0 … {}", network.delay_ms, kLongest_ms);
  }
  if (!within(network.jitter_ms, 0.0, kLongest_ms)) {
    return fail("jitter {} ms: expected 0 … {}", network.jitter_ms, kLongest_ms);
  }
  if (!within(network.loss_percent, 0.0, 100.0)) {
    return fail("loss {} %: expected 0 … 100", network.loss_percent);
  }
  return {};
}

Result<void> checkMessages(const Trace& trace, const TrialNetwork& network) {
  if (network.period_ms <= 0.0) return {};  // as many as there are rows
  const double length_s = trace.time_s.back() - trace.time_s.front();
  const double messages = std::floor((length_s + kSameTime_s) / (network.period_ms * 1e-3)) + 1.0;
  const std::size_t most = std::max(kMostMessages, trace.time_s.size());
  if (messages > static_cast<double>(most)) {
    return fail("period {} ms: {:.0f} messages in {} s; expected at most {}: take a longer period or less of the trace",
                network.period_ms, messages, length_s, most);
  }
  return {};
}

TrialPlan planTrial(const Trace& trace, const TrialNetwork& network) {
  const std::vector<Sent> sent = sentMessages(trace, network);
  TrialPlan plan;
  std::size_t next = 0;
  double motion_from_s = trace.time_s.front();
  bool begun = false;
  for (std::size_t row = 0; row < trace.time_s.size(); ++row) {
    const double now_s = trace.time_s[row];
    if (trace.gap(row)) {
      motion_from_s = now_s;
      begun = false;
      continue;
    }
    TrialPlan::Tick tick{.row = row, .first = plan.messages.size(), .last = 0, .begins = !begun};
    for (; next < sent.size() && sent[next].message.arrival_s <= now_s + kSameTime_s; ++next) {
      if (sent[next].sent_s >= motion_from_s - kSameTime_s) plan.messages.push_back(sent[next].message);
    }
    tick.last = plan.messages.size();
    if (!begun && tick.last == tick.first) continue;
    begun = true;
    plan.ticks.push_back(tick);
  }
  return plan;
}

std::vector<Position> runTrial(const Trace& trace, const TrialPlan& plan, Predictor& predictor, double smooth_s) {
  std::vector<Position> out;
  out.reserve(plan.ticks.size());
  SmoothOutput smooth(smooth_s);
  for (const TrialPlan::Tick& tick : plan.ticks) {
    if (tick.begins) {
      predictor.endMotion();
      smooth.reset();
    }
    for (std::size_t m = tick.first; m < tick.last; ++m) {
      const std::size_t row = plan.messages[m].row;
      predictor.message(trace.time_s[row], trace.position_mm[row]);
    }
    const double now_s = trace.time_s[tick.row];
    const Position predicted = predictor.predict(now_s);
    out.push_back(smooth_s > 0.0 ? smooth.step(now_s, predicted, predictor.velocity(now_s)) : predicted);
  }
  return out;
}

TrialFigures trialFigures(const Trace& trace, const TrialPlan& plan, std::span<const Position> output) {
  TrialFigures out;
  out.ticks = plan.ticks.size();
  if (plan.ticks.empty()) {  // nothing was predicted, which is not the same as predicted without an error
    out.rms_mm = out.mean_mm = out.max_mm = out.largest_step_mm = out.vibration_ratio = out.jerk_ratio = std::nan("");
    return out;
  }
  const double rate_Hz = trace.rate_Hz();
  double squares = 0.0, vibration = 0.0, true_vibration = 0.0, jerk = 0.0, true_jerk = 0.0;
  std::vector<Position> truth;
  for (std::size_t begin = 0; begin < plan.ticks.size();) {
    std::size_t end = begin + 1;
    while (end < plan.ticks.size() && !plan.ticks[end].begins) ++end;
    truth.clear();
    for (std::size_t i = begin; i < end; ++i) {
      truth.push_back(trace.position_mm[plan.ticks[i].row]);
      const double error = distance(output[i], truth.back());
      squares += error * error;
      out.mean_mm += error;
      out.max_mm = std::max(out.max_mm, error);
      if (i > begin) out.largest_step_mm = std::max(out.largest_step_mm, distance(output[i], output[i - 1]));
    }
    const std::span<const Position> motion = output.subspan(begin, end - begin);
    vibration += bandPower(motion, trace.axes, rate_Hz);
    true_vibration += bandPower(truth, trace.axes, rate_Hz);
    jerk += jerkPower(motion, trace.axes);
    true_jerk += jerkPower(truth, trace.axes);
    begin = end;
  }
  const auto count = static_cast<double>(out.ticks);
  out.rms_mm = std::sqrt(squares / count);
  out.mean_mm /= count;
  out.vibration_ratio = rate_Hz >= kLeastVibrationRate_Hz ? ratio(vibration, true_vibration) : std::nan("");
  out.jerk_ratio = ratio(jerk, true_jerk);
  return out;
}

}  // namespace fyd::teleop
