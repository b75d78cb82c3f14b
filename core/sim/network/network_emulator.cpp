#include "core/sim/network/network_emulator.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/csv.h"
#include "core/base/whole_file.h"

namespace fyd::sim {
namespace {

constexpr double kHeaderBytes = 28.0;  // IPv4 and UDP
constexpr double kCut = 3.0;

Result<void> inRange(std::string_view name, double value, double most, std::string_view unit) {
  if (value >= 0.0 && value <= most) return {};
  return fail("network {} {} {}: expected 0 to {}", name, value, unit, most);
}

}  // namespace

Result<void> checkNetwork(const NetworkSettings& s) {
  const std::array checks = {
      inRange("delay", s.delay_ms, 60'000, "ms"),          inRange("jitter", s.jitter_ms, 10'000, "ms"),
      inRange("loss", s.loss_percent, 100, "%"),           inRange("reorder", s.reorder_percent, 100, "%"),
      inRange("duplicate", s.duplicate_percent, 100, "%"), inRange("rate", s.rate_bit_per_s, 1e12, "bit/s"),
      inRange("queue", s.queue_ms, 60'000, "ms"),          inRange("reorder-by", s.reorder_by_ms, 10'000, "ms")};
  for (const auto& check : checks) {
    if (!check) return check;
  }
  return {};
}

Result<NetworkProfile> networkProfile(std::string_view name) {
  NetworkProfile profile;
  const auto both = [&](const NetworkSettings& settings) {
    profile.forward = settings;
    profile.backward = settings;
  };
  if (name == "isdn") {
    both({.delay_ms = 15.0, .jitter_ms = 1.0, .rate_bit_per_s = 64e3});
  } else if (name == "adsl") {
    both({.delay_ms = 75.0, .jitter_ms = 5.0, .loss_percent = 0.1, .rate_bit_per_s = 1e6});
    profile.backward.rate_bit_per_s = 8e6;
  } else if (name == "lan") {
    both({.delay_ms = 5.0, .jitter_ms = 0.5, .rate_bit_per_s = 100e6});
  } else {
    return fail("network profile \"{}\": expected isdn, adsl, lan or a CSV file", name);
  }
  return profile;
}

Result<DelayTrace> readDelayTrace(const std::string& path) {
  const auto text = readWholeFile(path, kLargestCsv_bytes, FileKind::pipe_too);
  if (!text) return tl::unexpected(text.error());
  return parseDelayTrace(*text, path);
}

Result<DelayTrace> parseDelayTrace(std::string_view text, const std::string& source_name) {
  auto table = parseCsv(text, source_name, {"delay_ms"});
  if (!table) return tl::unexpected(table.error());
  const bool timed = std::ranges::find(table->header, "t_s") != table->header.end();
  if (timed) table = parseCsv(text, source_name, {"delay_ms", "t_s"});
  if (!table) return tl::unexpected(table.error());
  DelayTrace trace{.t_s = timed ? table->values[1] : std::vector<double>{}, .delay_ms = table->values[0]};
  for (std::size_t i = 0; i < table->rows(); ++i) {
    if (trace.delay_ms[i] < 0.0 || trace.delay_ms[i] > 60'000.0) {
      return fail("{}:{}: delay {} ms: expected 0 to 60000, or nan for a loss", source_name, table->lines[i],
                  trace.delay_ms[i]);
    }
    if (timed && !(i == 0 ? trace.t_s[i] == 0.0 : trace.t_s[i] > trace.t_s[i - 1] && std::isfinite(trace.t_s[i]))) {
      return fail("{}:{}: time {} s: expected times that start at 0 and rise", source_name, table->lines[i],
                  trace.t_s[i]);
    }
  }
  return trace;
}

NetworkEmulator::NetworkEmulator(NetworkSettings settings) : settings_(std::move(settings)), random_(settings_.seed) {}

Passage NetworkEmulator::pass(std::size_t bytes, Instant now) {
  if (!std::exchange(started_, true)) began_ = last_ = line_free_ = now;
  now = last_ = std::max(now, last_);
  const auto share = [&](double percent) { return std::generate_canonical<double, 53>(random_) < 0.01 * percent; };
  const double base_ms = baseDelay_ms(now);
  const bool lost = share(settings_.loss_percent) || std::isnan(base_ms);
  const double shake = std::clamp(normal_(random_), -kCut, kCut);
  Passage passage;
  passage.reordered = share(settings_.reorder_percent);
  const bool twice = share(settings_.duplicate_percent);

  Instant through = now;
  if (settings_.rate_bit_per_s > 0.0) {
    if (line_free_ - now > fromSeconds(0.001 * settings_.queue_ms)) {
      passage.fate = DatagramFate::queue_full;
      return passage;
    }
    line_free_ = std::max(line_free_, now) +
                 fromSeconds(8.0 * (static_cast<double>(bytes) + kHeaderBytes) / settings_.rate_bit_per_s);
    through = line_free_;
  }
  if (lost) {
    passage.fate = DatagramFate::lost;
    return passage;
  }
  Instant out = through + fromSeconds(0.001 * std::max(base_ms + settings_.jitter_ms * shake, 0.0));
  out = std::max(out, last_out_);
  if (passage.reordered) {
    out += fromSeconds(0.001 * settings_.reorder_by_ms);
  } else {
    last_out_ = out;
  }
  for (int i = 0; i < (twice ? 2 : 1); ++i) static_cast<void>(passage.out.push(out));
  return passage;
}

double NetworkEmulator::baseDelay_ms(Instant now) {
  const DelayTrace& trace = settings_.trace;
  if (trace.delay_ms.empty()) return settings_.delay_ms;
  if (trace.t_s.empty()) return trace.delay_ms[next_row_++ % trace.delay_ms.size()];
  // The last row is valid for as long as the one before it; then the trace begins anew.
  const std::size_t rows = trace.t_s.size();
  const double last_s = rows > 1 ? trace.t_s[rows - 1] - trace.t_s[rows - 2] : 1.0;
  const double t_s = std::fmod(toSeconds(now - began_), trace.t_s.back() + last_s);
  const auto after = std::ranges::upper_bound(trace.t_s, t_s);
  return trace.delay_ms[static_cast<std::size_t>(after - trace.t_s.begin()) - 1];
}

}  // namespace fyd::sim
