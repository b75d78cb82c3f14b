#include "core/export/touch_gesture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include <boost/locale/encoding_utf.hpp>

namespace fyd::exports {
namespace {

constexpr std::size_t kBlock = 1000;      // rows at once
constexpr double kSamePicture_s = 0.002;  // a picture's time is computed from its age: smaller differences are rounding
constexpr double kLeastDepth_mm = 0.01;   // a finger that touches is not lifted

}  // namespace

std::string touchName(const std::string& recording_path, std::size_t number) {
  namespace utf = boost::locale::conv;
  const std::string file = std::filesystem::path(recording_path).filename().string();
  // A file's name may hold any byte but two; a card's what can be printed, in UTF-8.
  auto shown = utf::utf_to_utf<char32_t>(file.data(), file.data() + file.size(), utf::skip);
  std::erase_if(shown, [](char32_t c) { return c < 0x20 || c == 0x7f; });
  const std::string touch = fmt::format(", touch {}", number);
  std::string name = utf::utf_to_utf<char>(shown) + touch;
  while (!sim::isGestureName(name) && !shown.empty()) {
    shown.pop_back();
    name = utf::utf_to_utf<char>(shown) + "…" + touch;
  }
  return name;
}

Result<sim::GestureCard> gestureOf(const recording::Recording& recording, const Touch& touch, std::string name,
                                   std::string source) {
  sim::GestureCard card{.name = std::move(name), .source = std::move(source), .rows = {}};
  const auto first = recording.rowAt(touch.start_s);
  if (!first) return tl::unexpected(first.error());
  std::array<pipeline::TelemetrySample, kBlock> block;
  const std::uint64_t end = recording.info().committed_samples;
  double begins_s = 0.0;
  for (std::uint64_t row = *first; row < end;) {
    const std::span<pipeline::TelemetrySample> rows =
        std::span(block).first(static_cast<std::size_t>(std::min<std::uint64_t>(kBlock, end - row)));
    if (auto read = recording.telemetry(row, rows); !read) return tl::unexpected(read.error());
    row += rows.size();
    for (const pipeline::TelemetrySample& sample : rows) {
      const double now_s = secondsInto(recording.info(), sample.now);
      if (now_s > touch.end_s) {
        row = end;
        break;
      }
      const bool known = sample.contact && std::isfinite(sample.finger_x_mm) && std::isfinite(sample.finger_y_mm) &&
                         std::isfinite(sample.indentation_mm) && std::isfinite(sample.finger_age_ms);
      if (!known) continue;
      const double taken_s = now_s - 1e-3 * sample.finger_age_ms;
      if (card.rows.empty()) begins_s = taken_s;
      const double time_s = taken_s - begins_s;
      if (!card.rows.empty() && time_s < card.rows.back().time_s + kSamePicture_s) continue;
      card.rows.push_back(
          {.time_s = time_s,
           .state = {.x_mm = std::clamp(sample.finger_x_mm, -sim::kUsableHalfWidth_mm, sim::kUsableHalfWidth_mm),
                     .y_mm = std::clamp(sample.finger_y_mm, -sim::kUsableHalfDepth_mm, sim::kUsableHalfDepth_mm),
                     .indentation_mm = std::clamp(sample.indentation_mm, kLeastDepth_mm, sim::kDeepestPress_mm),
                     .lifted = false}});
    }
  }
  if (card.rows.size() < 2) {
    return fail("touch from {:.3f} to {:.3f} s: {} pictures show its finger; expected two and more", touch.start_s,
                touch.end_s, card.rows.size());
  }
  return card;
}

}  // namespace fyd::exports
