// fyd bench deadband: packets that a deadband saves on recorded forces, and the receiver's error at 20 % loss.
#include <cmath>
#include <filesystem>
#include <map>
#include <random>

#include "app/bench/parts/bench_options.h"
#include "app/bench/parts/table.h"
#include "app/cli/parts/command.h"
#include "app/cli/parts/trace_file.h"
#include "core/teleop/deadband.h"

namespace fyd::bench {
namespace {

using namespace teleop;

constexpr double kDelay_s = 0.020, kJitter_s = 0.030, kBack_s = 0.150;

struct Saved {
  double samples = 0.0, packets = 0.0, ticks = 0.0, known = 0.0, worst = 0.0;
};

void send(const Trace& force, const DeadbandChannel& channel, double loss, Saved& saved) {
  DeadbandChannels channels{};
  channels[0] = channel;
  DeadbandSender sender(channels);
  DeadbandReceiver receiver;
  std::mt19937_64 random(benchOptions().seed);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::multimap<double, DeadbandPacket> underway;
  std::size_t asked = 0;
  for (std::size_t i = 0; i < force.time_s.size(); ++i) {
    const double now_s = force.time_s[i];
    saved.samples += 1.0;
    if (const auto packet = sender.step(now_s, {force.position_mm[i][0]})) {
      saved.packets += 1.0;
      if (uniform() >= loss) underway.emplace(now_s + kDelay_s + kJitter_s * uniform(), *packet);
    }
    for (; !underway.empty() && underway.begin()->first <= now_s; underway.erase(underway.begin())) {
      receiver.receive(underway.begin()->second);
    }
    for (; force.time_s[asked] <= now_s - kBack_s; ++asked) {
      const DeadbandReceiver::Answer answer = receiver.at(force.time_s[asked]);
      saved.ticks += 1.0;
      if (!answer.known) continue;
      saved.known += 1.0;
      const double error = std::abs(force.position_mm[asked][0] - answer.value[0]);
      saved.worst = std::max(saved.worst, error / channel.band(answer.value[0], 0.0));
    }
  }
}

}  // namespace

Table bench_deadband() {
  const std::filesystem::path data = benchOptions().data.empty() ? "tests/data" : benchOptions().data;
  Table table;
  table.subject = "deadband";
  table.title = "Deadband: packets of recorded forces";
  table.columns = {{"sent when it changed by", Role::method},
                   {"loss", "%", Role::group},
                   "recordings",
                   {"packets", "%", Role::cost},
                   {"known 150 ms later", "%"},
                   {"worst error / band", "", Role::error}};
  std::vector<Trace> forces;
  std::error_code none;
  for (const auto& file : std::filesystem::directory_iterator(data / "teleop_1dof", none)) {
    if (file.path().extension() != ".csv") continue;
    for (const char* name : {"human_force_N", "environment_force_N"}) {
      forces.push_back(cli::readTrace(file.path(), {name}).trace);
    }
  }
  forces = wholeOrFirst(forces, 2);
  if (forces.empty()) {
    throw cli::Failure(verbatim(fmt::format("no recordings in {}", (data / "teleop_1dof").string())));
  }
  for (const double fraction : {0.0, 0.05, 0.10, 0.20}) {
    for (const double loss : {0.0, 0.2}) {
      Saved saved;
      for (const Trace& force : forces)
        send(force, {.fraction = fraction, .floor = fraction > 0.0 ? 0.1 : 0.0}, loss, saved);
      table.rows.push_back(
          {fraction > 0.0 ? fmt::format("{:.0f} %, at least 0.1 N", 100.0 * fraction) : "anything (baseline)",
           number(100.0 * loss), std::to_string(forces.size()), number(100.0 * saved.packets / saved.samples),
           number(100.0 * saved.known / saved.ticks, 4), fraction > 0.0 ? number(saved.worst) : "—"});
    }
  }
  table.notes.push_back(
      "Packets by samples of 1 kHz; the path takes 20 to 50 ms, uniform. Where the receiver says it knows, the "
      "error is within the band; elsewhere it says that it does not.");
  return table;
}

}  // namespace fyd::bench
