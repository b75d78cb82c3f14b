#include "core/export/export_words.h"

#include <algorithm>
#include <boost/locale/utf.hpp>
#include <cmath>

#include "core/pipeline/parameters.h"
#include "core/recording/reader/review_notes.h"
#include "core/sensing/tare.h"

namespace fyd::exports {
namespace {

using pipeline::EventKind;
using pipeline::SafetyState;

/// A parameter's change by its name and, for a choice, its word.
std::string describeChange(const pipeline::Event& event) {
  pipeline::Parameters parameters;
  const std::vector<Parameter> all = bindParameters(parameters);
  if (event.index >= all.size()) return fmt::format("parameter {} = {}", event.index, event.value);
  const Parameter& parameter = all[event.index];
  if (event.value >= 0.0 && event.value < static_cast<double>(parameter.choices.size())) {  // a file holds any number
    return fmt::format("{} = {}", parameter.id, parameter.choices[static_cast<std::size_t>(event.value)]);
  }
  const std::string unit = parameter.info.unit == "1" ? std::string() : fmt::format(" {}", parameter.info.unit);
  return fmt::format("{} = {}{}", parameter.id, event.value, unit);
}

std::string withFault(std::string_view text, const pipeline::Event& event) {
  if (event.fault == pipeline::Fault::none) return std::string(text);
  const bool known = static_cast<std::size_t>(event.fault) < pipeline::kFaultCount;
  const std::string code = known ? std::string() : fmt::format(" (code {})", static_cast<int>(event.fault));
  return fmt::format("{}: {}{}", text, pipeline::toString(event.fault), code);
}

LogWeight weigh(const pipeline::Event& e) {
  using enum LogWeight;
  // NOLINTBEGIN(bugprone-branch-clone): a row of the list has its own weight, whatever its neighbours have
  switch (e.kind) {
#define EVENT(name, number, label, severity, slides_in, weight, said, logged) \
  case EventKind::name:                                                       \
    return weight;
#include "core/pipeline/event_list.h"
#undef EVENT
  }
  // NOLINTEND(bugprone-branch-clone)
  return plain;
}

void addReviewNotes(const recording::RecordingInfo& info, double from_s, std::vector<LogLine>& lines) {
  if (info.path.empty()) return;
  const auto review = recording::readReviewNotes(info.path, info.header.id);
  if (!review) {
    lines.push_back({.time_s = std::max(0.0, from_s),
                     .kind = toString(recording::NoteKind::alarm),
                     .text = cleanText(review.error().text()),
                     .weight = LogWeight::serious});
    return;
  }
  for (const recording::ReviewNote& note : review->notes) {
    lines.push_back({.time_s = note.time_s,
                     .kind = note.kind == recording::NoteKind::bookmark ? "bookmark in review" : "note in review",
                     .text = cleanText(note.text),
                     .weight = LogWeight::marked});
  }
}

}  // namespace

std::string_view toString(EventKind kind) {
  switch (kind) {
#define EVENT(name, number, label, severity, slides_in, weight, said, logged) \
  case EventKind::name:                                                       \
    return label;
#include "core/pipeline/event_list.h"
#undef EVENT
  }
  return "unknown";
}

std::string_view toString(recording::NoteKind kind) {
  switch (kind) {
    case recording::NoteKind::note: return "note";
    case recording::NoteKind::bookmark: return "bookmark";
    case recording::NoteKind::trial_start: return "trial start";
    case recording::NoteKind::trial_end: return "trial end";
    case recording::NoteKind::alarm: return "alarm";
  }
  return "unknown";
}

std::string describeEvent(const pipeline::Event& e) {
  switch (e.kind) {
#define EVENT(name, number, label, severity, slides_in, weight, said, logged) \
  case EventKind::name:                                                       \
    return logged;
#include "core/pipeline/event_list.h"
#undef EVENT
  }
  return fmt::format("code {}, value {}", static_cast<int>(e.kind), e.value);
}

std::string cleanText(std::string_view text) {
  using Utf = boost::locale::utf::utf_traits<char>;
  std::string clean;
  for (auto at = text.begin(); at != text.end();) {
    const auto begin = at;
    const auto point = Utf::decode(at, text.end());
    const bool good = point != boost::locale::utf::illegal && point != boost::locale::utf::incomplete &&
                      ((point >= 0x20 && point != 0x7f) || point == '\n' || point == '\t');
    if (good) {
      clean.append(begin, at);
    } else {
      clean += "\xEF\xBF\xBD";
      at = begin + 1;
    }
  }
  return clean;
}

Result<std::vector<LogLine>> logLines(const recording::Recording& recording, double from_s) {
  const auto events = recording.events();
  if (!events) return tl::unexpected(events.error());
  const auto notes = recording.notes();
  if (!notes) return tl::unexpected(notes.error());
  std::vector<LogLine> lines;
  for (const recording::EventRow& row : *events) {
    lines.push_back({.time_s = secondsInto(recording.info(), row.when),
                     .kind = toString(row.event.kind),
                     .text = describeEvent(row.event),
                     .value = row.event.value,
                     .weight = weigh(row.event)});
  }
  for (const recording::Note& note : *notes) {
    lines.push_back({.time_s = secondsInto(recording.info(), note.when),
                     .kind = toString(note.kind),
                     .text = cleanText(note.text),
                     .weight = note.kind == recording::NoteKind::alarm ? LogWeight::serious : LogWeight::marked});
  }
  addReviewNotes(recording.info(), from_s, lines);
  std::ranges::stable_sort(lines, {}, &LogLine::time_s);
  return lines;
}

}  // namespace fyd::exports
