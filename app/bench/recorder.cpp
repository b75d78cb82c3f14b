// What recording costs: the haptic loop's push against a plain copy, and a whole station with and without.
#include <algorithm>
#include <cstring>
#include <thread>

#include "app/bench/parts/bench_options.h"
#include "app/bench/parts/recorded_session.h"
#include "app/bench/parts/table.h"
#include "core/station/station.h"

namespace fyd::bench {
namespace {

double push_s() { return wholeOrQuick(6.0, 1.5); }
double station_s() { return wholeOrQuick(12.0, 3.0); }
constexpr double kPatience_s = 20.0;  // until the station is armed

/// Why no recording is under way; empty: one is.
std::string whyNotRecording(const recording::RecorderStatus& status) {
  if (status.state == recording::RecorderState::recording) return {};
  return status.problem.empty() ? "nothing is being recorded" : status.problem.text();
}

struct Push {
  Quantiles copy_ns;
  Quantiles push_ns;
  std::uint64_t lost = 0;
  std::string failed;  ///< why these are not the figures of a recording; empty: they are
};

/// At the haptic loop's rate, so that caches are as cold as in a session. What goes second finds the step in the cache:
/// the two take turns, and of each only the steps that it was first in count.
Push measurePush(const std::string& path) {
  recording::Recorder recorder({}, {}, {}, {}, {.profile = [](const auto&) { return std::string(); }, .link = {}});
  recorder.start();
  std::vector<double> copies;
  std::vector<double> pushes;
  std::vector<recording::StepRecord> slots(2000);
  Instant due = Clock::now();
  std::size_t number = 0;
  Result<void> begun;
  simulateSession(SessionKind::gesture, push_s(), [&](const recording::StepView& step) {
    std::this_thread::sleep_until(due += std::chrono::milliseconds(1));
    if (number == 500) begun = recorder.begin({.path = path});
    recording::StepRecord& slot = slots[number++ % slots.size()];
    const auto time = [](auto&& call) {
      const Instant before = Clock::now();
      call();
      return std::chrono::duration<double, std::nano>(Clock::now() - before).count();
    };
    const auto copy = [&] {
      slot.inputs = step.inputs;
      slot.motors = step.outputs.motors;
      slot.telemetry = step.outputs.telemetry;
      slot.events = step.outputs.events;
    };
    const auto push = [&] { recorder.push(step); };
    if (number % 2 == 0) {
      copies.push_back(time(copy));
      push();
    } else {
      pushes.push_back(time(push));
      copy();
    }
  });
  std::string failed = begun ? whyNotRecording(recorder.status()) : begun.error().text();
  if (failed.empty()) {
    if (const auto ended = recorder.end(); !ended) failed = ended.error().text();
  }
  return {.copy_ns = quantiles(copies),
          .push_ns = quantiles(pushes),
          .lost = recorder.status().lost,
          .failed = std::move(failed)};
}

struct Session {
  double missed_percent = 0.0;
  recording::RecorderStatus recorder;
  std::string failed;  ///< why these are not the figures of an armed station, recorded as asked for; empty: they are
};

Session runStation(const std::string& path) {
  station::StationOptions options{.real_time = true};  // what is judged is how late it is
  if (!path.empty()) options.record = recording::RecordingRequest{.path = path};
  auto opened = station::Station::open(options);
  if (!opened) return {.failed = opened.error().text()};
  std::vector<pipeline::TelemetrySample> batch(1000);
  (*opened)->start();
  Instant since = Clock::now();  // the start, then the arming
  bool armed = false;
  while (toSeconds(Clock::now() - since) < (armed ? station_s() : kPatience_s)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const std::size_t taken = (*opened)->takeTelemetry(batch);
    if (armed || taken == 0 || batch[taken - 1].state != pipeline::SafetyState::ready) continue;
    armed = (*opened)->command({.action = pipeline::OperatorAction::arm});
    since = Clock::now();
  }
  Session out{.recorder = (*opened)->recorderStatus()};
  const station::LoopStatus loop = (*opened)->status().loop;
  out.missed_percent =
      100.0 * static_cast<double>(loop.missed_cycles) / static_cast<double>(loop.missed_cycles + loop.steps);
  if (!armed) {
    out.failed = "the station did not become ready to be armed";
  } else if (!path.empty()) {
    out.failed = whyNotRecording(out.recorder);
  }
  (*opened)->shutDown();
  return out;
}

}  // namespace

Table bench_recorder() {
  const TemporaryFolder folder;
  const Push push = measurePush(folder.file("push.h5"));
  const Session without = runStation("");
  const Session with = runStation(folder.file("station.h5"));
  const auto pushRow = [&](const std::string& name, const Quantiles& ns, std::uint64_t lost) {
    return std::vector<std::string>{"a step",
                                    orFailed(name, push.failed),
                                    number(ns.p50),
                                    number(ns.p99),
                                    number(ns.p50 / push.copy_ns.p50),
                                    kNothing,
                                    kNothing,
                                    kNothing,
                                    kNothing,
                                    number(static_cast<double>(lost))};
  };
  const auto stationRow = [](const std::string& name, const Session& session) {
    const recording::RecorderStatus& status = session.recorder;
    return std::vector<std::string>{"a session",
                                    orFailed(name, session.failed),
                                    kNothing,
                                    kNothing,
                                    kNothing,
                                    number(session.missed_percent),
                                    number(status.processor_percent),
                                    number(status.commit_p99_ms),
                                    number(status.bytes_per_s * 1e-3),
                                    number(static_cast<double>(status.lost))};
  };
  return {
      .subject = "recorder",
      .title = "Recording",
      .columns = {{"part", Role::group},
                  {"what", Role::method},
                  {"p50", "ns", Role::cost},
                  {"p99", "ns"},
                  "p50 ratio",
                  {"cycles missed", "%"},
                  {"recorder's thread", "% of a core"},
                  {"commit p99", "ms"},
                  {"written", "kB/s"},
                  {"lost", "steps", Role::error}},
      .rows = {pushRow("copy of a whole StepRecord (baseline)", push.copy_ns, 0),
               pushRow("push to the recorder", push.push_ns, push.lost),
               stationRow("simulated station, not recorded (baseline)", without),
               stationRow("simulated station, recorded", with)},
      .notes = {
          "Pushes at 1 kHz from a simulated session with one acceleration a step; copy and push take turns in going "
          "first, and each is timed only there, where the step is not in the cache yet. The station runs some seconds "
          "each way, with pictures. What the recorder's thread takes while it does not record is the second "
          "pipeline that follows the step. The first seconds, in which the file is made, count as well."}};
}

}  // namespace fyd::bench
