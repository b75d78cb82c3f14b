#include "core/texture/recording.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/csv.h"
#include "core/base/median.h"

namespace fyd::texture {
namespace {

constexpr double kLongest_s = kDay_s;
constexpr double kSlowest_Hz = 10.0;  // nothing slower is a vibration: 1 kHz told in milliseconds looks like 1 Hz
constexpr double kMostSteps = 1e7;    // of 32 bytes: two rows may be as far apart as they like
constexpr double kLargestReduction = 100.0;  // of the rate; the stream's queue bounds it

/// As many as a table may have, and one more.
std::vector<std::string> fieldsOf(std::string_view line) {
  std::vector<std::string> out(1);
  for (const char c : line) {
    if (c == '\r' || c == '"' || c == ' ') continue;
    if (c == ',') {
      if (out.size() > kMostCsvColumns) break;
      out.emplace_back();
    } else {
      out.back() += c;
    }
  }
  return out;
}

bool startsLikeANumber(const std::string& field) {
  return !field.empty() && (std::isdigit(static_cast<unsigned char>(field[0])) != 0 || field[0] == '-' ||
                            field[0] == '+' || field[0] == '.');
}

Result<CsvTable> parseTable(std::string_view text, std::string_view source_name) {
  const std::vector<std::string> first = fieldsOf(text.substr(0, text.find('\n')));
  static const std::vector<std::string> kTimed = {"t_s", "ax", "ay", "az"};
  static const std::vector<std::string> kPlain = {"ax", "ay", "az"};
  if (startsLikeANumber(first[0]) && (first.size() == 3 || first.size() == 4)) {
    const std::string headed = (first.size() == 3 ? "ax,ay,az\n" : "t_s,ax,ay,az\n") + std::string(text);
    const std::string name = fmt::format("{} (with a header line put first)", source_name);
    return parseCsv(headed, name, first.size() == 3 ? kPlain : kTimed);
  }
  const bool timed = std::find(first.begin(), first.end(), "t_s") != first.end();
  if (!timed && first.size() == 3) return parseCsv(text, source_name, first);
  return parseCsv(text, source_name, kTimed);
}

/// Times closer than a nanosecond are one instant.
double medianSpacing(const std::vector<double>& times_s) {
  std::vector<double> spacings;
  for (std::size_t i = 1; i < times_s.size(); ++i) {
    if (const double spacing = times_s[i] - times_s[i - 1]; spacing >= 1e-9) spacings.push_back(spacing);
  }
  return median(std::move(spacings), Middle::lower);  // a gap beside one spacing does not count
}

Result<void> checkTimes(const CsvTable& table, std::string_view source_name) {
  const std::vector<double>& t = table.values[0];
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (!std::isfinite(t[i])) {
      return fail("{}:{}: t_s = {}: expected a finite time in seconds", source_name, table.lines[i], t[i]);
    }
    if (i > 0 && t[i] < t[i - 1]) {
      return fail("{}:{}: t_s = {} after {}: expected times that do not go backwards", source_name, table.lines[i],
                  t[i], t[i - 1]);
    }
  }
  if (auto good = checkLength(t.back() - t.front(), kLongest_s); !good) {
    return fail(about(source_name, std::move(good.error().message)));
  }
  return {};
}

}  // namespace

Result<Recording> parseRecording(std::string_view text, std::string_view source_name, double rate_Hz) {
  auto table = parseTable(text, source_name);
  if (!table) return tl::unexpected(table.error());
  const bool timed = table->values.size() == 4;
  if (timed) {
    if (auto checked = checkTimes(*table, source_name); !checked) return tl::unexpected(checked.error());
  } else if (!(rate_Hz > 0.0 && std::isfinite(rate_Hz))) {
    return fail("{}: without a column t_s the sample rate must be given", source_name);
  }
  Recording out;
  out.start_s = timed ? table->values[0].front() : 0.0;
  // To a millionth of a hertz: the differences of printed times are no more exact.
  out.rate_Hz = timed ? std::round(1e6 / medianSpacing(table->values[0])) * 1e-6 : rate_Hz;
  if (!(out.rate_Hz > 0.0)) {
    if (!(rate_Hz > 0.0)) return fail("{}: fewer than two different times: the sample rate is unknown", source_name);
    out.rate_Hz = rate_Hz;
  } else if (timed && out.rate_Hz < kSlowest_Hz) {
    return fail("{}: {} rows a second; expected {} and more: are the times in seconds?", source_name, out.rate_Hz,
                kSlowest_Hz);
  }
  const std::size_t first_axis = timed ? 1 : 0;
  out.samples.reserve(table->rows());
  for (std::size_t i = 0; i < table->rows(); ++i) {
    const double t_s = timed ? table->values[0][i] - out.start_s : static_cast<double>(i) / rate_Hz;
    const auto& v = table->values;
    out.samples.push_back({instantAt(t_s), {v[first_axis][i], v[first_axis + 1][i], v[first_axis + 2][i]}});
  }
  return out;
}

Result<void> checkSamples(double count, double span_s, double rate_Hz) {
  if (count <= kMostSteps) return {};
  return fail("{} s at {} Hz are {} samples: expected at most {}", span_s, rate_Hz, count, kMostSteps);
}

Result<UniformRecording> makeUniform(const Recording& recording, double rate_Hz) {
  UniformRecording out;
  if (recording.samples.empty()) return out;
  const double span_s = toSeconds(recording.samples.back().taken - recording.samples.front().taken);
  const double count = std::ceil(span_s * rate_Hz - 0.5 - 1e-6) + 1.0;  // the last one's period holds the last sample
  if (auto good = checkSamples(count, span_s, rate_Hz); !good) return tl::unexpected(good.error());
  if (recording.rate_Hz > kLargestReduction * rate_Hz) {
    return fail("recorded at {} Hz: {} Hz is less than 1/{} of that", recording.rate_Hz, rate_Hz, kLargestReduction);
  }
  UniformStream stream(rate_Hz);
  const double delay_s = 1.5 / recording.rate_Hz;  // so that the later sample of an interpolation has arrived
  stream.configure(1e3 * delay_s, 1.5e3 / std::min(rate_Hz, recording.rate_Hz));
  out.steps.reserve(static_cast<std::size_t>(count));
  std::size_t next = 0;
  const Instant first = recording.samples.front().taken;
  for (std::size_t n = 0; n < static_cast<std::size_t>(count); ++n) {
    // Asked three quarters of a period after the sample: its period is over then, with half a period of jitter allowed.
    const Instant now = first + fromSeconds((static_cast<double>(n) + 0.75) / rate_Hz + delay_s);
    const std::size_t from = next;
    while (next < recording.samples.size() && recording.samples[next].taken <= now) ++next;
    stream.push(now, std::span(recording.samples).subspan(from, next - from));
    out.steps.push_back(stream.step(now));
  }
  out.gaps = stream.gaps();
  out.refused = stream.refused();
  return out;
}

OfflineChain::OfflineChain(FilterChoice filter, double corner_Hz, double sample_rate_Hz, std::unique_ptr<Method> method)
    : remove_rest_(filter != FilterChoice::none), method_(std::move(method)) {
  chain_.select(filter, corner_Hz, sample_rate_Hz, *method_);
}

double OfflineChain::step(const UniformStream::Step& sample) {
  if (sample.gap) return chain_.stepGap();
  return chain_.step(remove_rest_ ? rest_.step(sample.acceleration_g) : sample.acceleration_g, sample.resumed);
}

}  // namespace fyd::texture
