// The log of a recording in words: events of the step, the operator's notes and those of a review, in the order of time.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/recording/reader/recording.h"

namespace fyd::exports {

enum class LogWeight : std::uint8_t { plain, marked, serious };  ///< marked: worth a line in a chart

struct LogLine {
  double time_s = 0.0;
  std::string_view kind;  ///< "parameter changed", "note", …
  std::string text;
  double value = pipeline::kNone;  ///< of the event, where it has one
  LogWeight weight = LogWeight::plain;
};

[[nodiscard]] std::string_view toString(pipeline::EventKind kind);
[[nodiscard]] std::string_view toString(recording::NoteKind kind);

/// An event in words: "control.kp = 0.5", "held: robot silent".
[[nodiscard]] std::string describeEvent(const pipeline::Event& event);

/// The whole log, as valid UTF-8. Notes of a review that cannot be read are a serious line that says why.
/// @param from_s of what is wanted of it: such a line has no time of its own
[[nodiscard]] Result<std::vector<LogLine>> logLines(const recording::Recording& recording, double from_s = 0.0);

/// Bytes that are no UTF-8 and control characters other than line ends and tabs become U+FFFD.
[[nodiscard]] std::string cleanText(std::string_view text);

}  // namespace fyd::exports
