// The haptic loop's period against a loop that sleeps for a millisecond each time.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <thread>

#include "app/bench/parts/bench_options.h"
#include "app/bench/parts/table.h"
#include "core/station/haptic_loop.h"
#include "core/station/real_time.h"
#include "core/station/station.h"

namespace fyd::bench {
namespace {

int cycles() { return wholeOrQuick(4000, 500); }

struct Periods {
  Quantiles deviation_us;  // of |period − 1 ms|
  double drift_ms = 0.0;   // of the last cycle against the ideal grid
  double missed_percent = 0.0;
};

Periods judge(const std::vector<Instant>& starts, double missed) {
  Periods out;
  std::vector<double> deviations;
  for (std::size_t i = 1; i < starts.size(); ++i) {
    deviations.push_back(std::abs(toMilliseconds(starts[i] - starts[i - 1]) - 1.0) * 1e3);
  }
  const double periods = static_cast<double>(starts.size() - 1);
  out.drift_ms = toMilliseconds(starts.back() - starts.front()) - periods - missed;
  out.missed_percent = 100.0 * missed / (periods + missed);
  out.deviation_us = quantiles(deviations);
  return out;
}

/// Each millisecond of the grid in which nothing began.
double skipped(const std::vector<Instant>& starts) {
  double out = 0.0;
  for (std::size_t i = 1; i < starts.size(); ++i) {
    out += std::max(0.0, std::floor(toMilliseconds(starts[i] - starts[i - 1])) - 1.0);
  }
  return out;
}

/// With the scheduling that the loop asks for. @param granted receives whether it was
Periods naive(bool& granted) {
  std::vector<Instant> starts;
  starts.reserve(static_cast<std::size_t>(cycles()));
  std::jthread thread([&] {
    granted = station::askForRealTime(station::Urgency::haptic);
    for (int i = 0; i < cycles(); ++i) {
      starts.push_back(Clock::now());
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  });
  thread.join();
  return judge(starts, skipped(starts));
}

Periods haptic() {
  std::vector<Instant> starts;
  const auto wanted = static_cast<std::size_t>(cycles());
  starts.reserve(wanted);
  station::HapticLoop loop;
  std::jthread thread([&](const std::stop_token&) {
    std::stop_source enough;
    loop.run(enough.get_token(), false, [&](Instant now, std::uint64_t) {
      starts.push_back(now);
      if (starts.size() == wanted) enough.request_stop();
    });
  });
  thread.join();
  return judge(starts, static_cast<double>(loop.missedCycles()));
}

Periods wholeStation() {
  auto opened = station::Station::open({.real_time = true});     // what is judged is how late it is
  if (!opened) throw std::runtime_error(opened.error().text());  // nothing is late where nothing runs
  std::vector<Instant> starts;
  std::vector<pipeline::TelemetrySample> batch(1000);
  (*opened)->start();
  while (starts.size() < static_cast<std::size_t>(cycles())) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const std::size_t taken = (*opened)->takeTelemetry(batch);
    for (std::size_t i = 0; i < taken; ++i) starts.push_back(batch[i].now);
  }
  const double missed = static_cast<double>((*opened)->status().loop.missed_cycles);
  (*opened)->shutDown();
  return judge(starts, missed);
}

std::vector<std::string> row(const std::string& name, const Periods& periods, const Periods& baseline) {
  return {name,
          number(periods.deviation_us.p50),
          number(periods.deviation_us.p99),
          number(periods.deviation_us.worst),
          number(periods.deviation_us.p50 / baseline.deviation_us.p50),
          number(periods.drift_ms),
          number(periods.missed_percent)};
}

}  // namespace

Table bench_loop() {
  bool real_time = false;
  const Periods sleeping = naive(real_time);
  const Periods alone = haptic();
  const Periods station = wholeStation();
  return {.subject = "loop",
          .title = "Period of the haptic loop",
          .columns = {{"loop", Role::method},
                      {"period's distance from 1 ms, p50", "µs", Role::error},
                      {"p99", "µs"},
                      {"worst", "µs"},
                      "p50 ratio",
                      {"drift over all cycles", "ms"},
                      {"missed", "%"}},
          .rows = {row("sleep for 1 ms (baseline)", sleeping, sleeping), row("haptic loop alone", alone, sleeping),
                   row("whole simulated station", station, sleeping)},
          .notes = {fmt::format(
              "{} cycles each, {} real-time scheduling. The drift is how far the last cycle lies from the ideal grid, "
              "missed cycles apart.",
              cycles(), real_time ? "all with" : "none of them was granted")}};
}

}  // namespace fyd::bench
