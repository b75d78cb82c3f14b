#include "core/report/report_content.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "core/base/median.h"
#include "core/catalogue/catalogue_types.h"
#include "core/export/export_selection.h"
#include "core/recording/reader/recording_health.h"
#include "core/recording/reader/review_notes.h"

namespace fyd::report {
namespace {

constexpr std::size_t kLogLinesShown = 300;  ///< and more where more are serious

/// Figures that need a pass over every row.
struct RowFigures {
  std::vector<ChartSpan> gaps;  ///< as the figure can tell them apart
  std::uint64_t breaks = 0;     ///< stretches of lost samples
  std::uint64_t lost = 0;       ///< samples lost in them
  double missed_cycles = 0.0;   ///< of the haptic loop, while recording
};

Result<RowFigures> lookAtRows(const recording::Recording& recording, const recording::Progress& progress) {
  RowFigures figures;
  std::optional<pipeline::TelemetrySample> last;
  double missed_before = 0.0;
  // No finer than the curves: however many breaks there are, the figure's work is bounded, and it shows each of them.
  const double least_apart_s = recording.info().duration_s / static_cast<double>(kCurveBuckets);
  const exports::ExportSelection all{.end = recording.info().committed_samples, .progress = progress};
  const auto read = forEachBlock(recording, all, [&](std::span<const pipeline::TelemetrySample> rows) -> Result<void> {
    for (const pipeline::TelemetrySample& row : rows) {
      if (!last) missed_before = row.missed_cycles;
      if (last && row.step > last->step + 1) {
        ++figures.breaks;
        figures.lost += row.step - last->step - 1;
        const ChartSpan gap{secondsInto(recording.info(), last->now), secondsInto(recording.info(), row.now)};
        if (!figures.gaps.empty() && gap.from_s - figures.gaps.back().to_s < least_apart_s) {
          figures.gaps.back().to_s = gap.to_s;
        } else {
          figures.gaps.push_back(gap);
        }
      }
      last = row;
    }
    return {};
  });
  if (!read) return tl::unexpected(read.error());
  if (last) figures.missed_cycles = last->missed_cycles - missed_before;
  return figures;
}

std::vector<std::pair<std::string, std::string>> headerFacts(const recording::RecordingInfo& info) {
  const recording::RecordingHeader& header = info.header;
  std::string tags;
  for (const std::string& tag : recording::tagsInForce(info)) tags += (tags.empty() ? "" : ", ") + tag;
  std::vector<std::pair<std::string, std::string>> facts;
  const auto add = [&](const char* what, const std::string& text) {
    facts.emplace_back(what, text.empty() ? "–" : exports::cleanText(text));
  };
  add("Recording", header.id);
  add("Started", header.started_utc + " (UTC)");
  add("Duration", fmt::format("{:.1f} s, {} samples", info.duration_s, info.committed_samples));
  add("Operator", header.operator_name);
  add("Subject", header.subject);
  add("Tags", tags);
  add("Touchpad", header.touchpad);
  add("Camera", header.camera);
  add("Robot", header.robot);
  add("Recorded by", "FYD Console " + header.version);
  add("Notes", header.notes);
  return facts;
}

ReportTable touchTable(const std::vector<exports::Touch>& touches) {
  ReportTable table{.heading = "Touches",
                    .columns = {{"No.", 0.52, true},
                                {"Start, s", 0.9, true},
                                {"Length, s", 1.0, true},
                                {"Peak force, N", 1.0, true},
                                {"Peak indentation, mm", 1.25, true},
                                {"Stiffness, N/mm", 1.0, true},
                                {"Target, N/mm", 1.0, true},
                                {"Error, %", 0.8, true},
                                {"Settling, s", 1.0, true},
                                {"Vibration rms, %", 1.05, true},
                                {"Felt, dB", 0.8, true}}};
  if (touches.empty()) table.remark = "No touch: the finger never pressed the cloth in this recording.";
  for (std::size_t i = 0; i < touches.size(); ++i) {
    const exports::Touch& touch = touches[i];
    const double error = 100.0 * (touch.stiffness_N_per_mm - touch.target_N_per_mm) / touch.target_N_per_mm;
    table.rows.push_back({std::to_string(i + 1), reportNumber(touch.start_s, 2),
                          reportNumber(touch.end_s - touch.start_s, 2), reportNumber(touch.peak_force_N, 2),
                          reportNumber(touch.peak_indentation_mm, 2), reportNumber(touch.stiffness_N_per_mm, 3),
                          reportNumber(touch.target_N_per_mm, 3), reportNumber(error, 1),
                          std::isnan(touch.settling_s) ? "never" : reportNumber(touch.settling_s, 2),
                          reportNumber(touch.vibration_rms_percent, 1), reportNumber(touch.felt_level_dB, 1)});
  }
  return table;
}

ReportTable healthTable(const recording::RecordingInfo& info, const RowFigures& figures,
                        const std::vector<recording::LinkRow>& link) {
  ReportTable table{.heading = "Health", .columns = {{"What", 1.2}, {"Figure", 2.0}}};
  const auto add = [&](const char* what, std::string text) { table.rows.push_back({what, std::move(text)}); };
  add("File", fmt::format("{}, {:.1f} MB", catalogue::toString(info.wholeness), static_cast<double>(info.bytes) / 1e6));
  if (const auto [word, reason] = healthOf(info); !reason.empty())
    add("Health", fmt::format("{}: {}", word, reason.text()));
  const std::uint64_t outside = info.gaps - std::min(info.gaps, figures.lost);  // no sample follows these
  add("Samples lost", figures.lost + outside == 0 ? "none"
                      : outside == 0              ? fmt::format("{} (breaks: {})", figures.lost, figures.breaks)
                                                  : fmt::format("{} (breaks: {}; before or after the rest: {})",
                                                                figures.lost + outside, figures.breaks, outside));
  add("Missed cycles of the loop", reportNumber(figures.missed_cycles, 0));
  add("Pictures", std::to_string(info.frames));
  if (link.empty()) {
    add("Robot's link", "none recorded");
    return table;
  }
  const auto spread = [&](const char* what, double recording::LinkRow::*figure, const char* unit) {
    std::vector<double> values;
    for (const recording::LinkRow& row : link) {
      if (std::isfinite(row.*figure)) values.push_back(row.*figure);
    }
    if (values.empty()) return add(what, "–");
    const double worst = std::ranges::max(values);
    add(what,
        fmt::format("median {:.2f} {}, worst {:.2f} {}", median(std::move(values), Middle::upper), unit, worst, unit));
  };
  spread("Link: round trip", &recording::LinkRow::round_trip_ms, "ms");
  spread("Link: jitter", &recording::LinkRow::jitter_ms, "ms");
  spread("Link: loss", &recording::LinkRow::loss_percent, "%");
  const recording::LinkRow& first = link.front();
  const recording::LinkRow& last = link.back();
  // Counters count since the link's start, not the recording's: take the difference; a new link starts at 0 again.
  const auto added = [](std::uint64_t from, std::uint64_t to) { return to >= from ? to - from : to; };
  add("Link: messages",
      fmt::format("{} states in, {} touches out, {} refused", added(first.states_received, last.states_received),
                  added(first.touches_sent, last.touches_sent), added(first.refused, last.refused)));
  return table;
}

/// The lines of the log that find a place, in the order of time: the serious ones, then marked and then plain ones, the
/// first of each.
std::vector<std::size_t> shownLines(const std::vector<exports::LogLine>& lines) {
  std::vector<std::size_t> shown(lines.size());
  std::iota(shown.begin(), shown.end(), std::size_t{0});
  std::ranges::stable_sort(shown, std::greater{}, [&](std::size_t i) { return lines[i].weight; });
  const auto serious = std::ranges::count(lines, exports::LogWeight::serious, &exports::LogLine::weight);
  shown.resize(std::min(shown.size(), std::max(kLogLinesShown, static_cast<std::size_t>(serious))));
  std::ranges::sort(shown);
  return shown;
}

ReportTable logTable(const std::vector<exports::LogLine>& lines, const std::vector<std::size_t>& shown) {
  ReportTable table{.heading = "Events, parameter changes and notes",
                    .columns = {{"No.", 0.4, true}, {"Time, s", 0.75, true}, {"What", 1.3}, {"Text", 4.0}}};
  if (lines.empty()) table.remark = "None.";
  if (shown.size() < lines.size()) {
    table.remark =
        fmt::format("{} of {}, among them each hold and stop; an export holds all.", shown.size(), lines.size());
  }
  for (const std::size_t i : shown) {
    table.rows.push_back({std::to_string(i + 1), reportNumber(lines[i].time_s, 3), std::string(lines[i].kind),
                          lines[i].text.empty() ? "–" : lines[i].text});
  }
  return table;
}

/// Numbered as in the log's table.
std::vector<ChartMark> marksOf(const std::vector<exports::LogLine>& lines, const std::vector<std::size_t>& shown) {
  std::vector<ChartMark> marks;
  for (const std::size_t i : shown) {
    if (lines[i].weight == exports::LogWeight::plain) continue;
    marks.push_back({.time_s = lines[i].time_s,
                     .colour = lines[i].weight == exports::LogWeight::serious ? kDangerRgb : kMutedRgb,
                     .label = std::to_string(i + 1)});
  }
  return marks;
}

}  // namespace

std::string reportNumber(double value, int decimals) {
  if (!std::isfinite(value)) return "–";
  const std::string text = fmt::format("{:.{}f}", value, decimals);
  // Not "-0.00"; and a typographic minus sign.
  if (text.find_first_not_of("-0.") == std::string::npos) return fmt::format("{:.{}f}", 0.0, decimals);
  return text.front() == '-' ? "−" + text.substr(1) : text;
}

Result<ReportContent> gatherReport(const recording::Recording& recording, const recording::Progress& progress) {
  // Every row is read twice, which takes nearly all of the time.
  const auto touches = exports::findTouches(recording, recording::partOf(progress, 0.0, 0.5));
  if (!touches) return tl::unexpected(touches.error());
  const auto figures = lookAtRows(recording, recording::partOf(progress, 0.5, 1.0));
  if (!figures) return tl::unexpected(figures.error());
  const auto lines = exports::logLines(recording);
  if (!lines) return tl::unexpected(lines.error());
  const auto link = recording.linkRows();
  if (!link) return tl::unexpected(link.error());

  const recording::RecordingInfo& info = recording.info();
  ReportContent content{.title = "Session report", .facts = headerFacts(info)};
  if (auto strips = gatherStrips(recording, content); !strips) return tl::unexpected(strips.error());
  for (const exports::Touch& touch : *touches) content.time.touches.push_back({touch.start_s, touch.end_s});
  content.time.gaps = figures->gaps;
  const std::vector<std::size_t> shown = shownLines(*lines);
  content.time.marks = marksOf(*lines, shown);
  if (shown.size() < lines->size()) {
    content.legend += fmt::format(" {} lines of the log are left out, none of them red.", lines->size() - shown.size());
  }
  content.tables = {touchTable(*touches), healthTable(info, *figures, *link), profileTable(info.header.profile),
                    logTable(*lines, shown)};
  return content;
}

}  // namespace fyd::report
