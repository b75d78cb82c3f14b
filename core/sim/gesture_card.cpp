#include "core/sim/gesture_card.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "core/base/csv.h"
#include "core/base/toml_parameters.h"
#include "core/base/whole_file.h"

namespace fyd::sim {
namespace {

constexpr std::string_view kFormat = "FYD gesture 1";
constexpr std::string_view kBegins = "format = \"FYD gesture";
constexpr std::size_t kLongestText = 200;
constexpr double kLongest_s = 600.0;
constexpr std::array<std::string_view, 5> kKeys = {"format", "name", "source", "speed", "loop"};

/// Where the rows begin: below the first line that is ---, whatever ends it; npos without one.
struct Rule {
  std::size_t begin = std::string_view::npos, rows = std::string_view::npos;
};

Rule findRule(std::string_view text) {
  constexpr std::string_view kLine = "\n---";
  for (std::size_t at = text.find(kLine); at != std::string_view::npos; at = text.find(kLine, at + 1)) {
    const std::string_view rest = text.substr(at + kLine.size());
    for (const std::string_view end : {"\n", "\r\n"}) {
      if (rest.starts_with(end)) return {.begin = at + 1, .rows = at + kLine.size() + end.size()};
    }
  }
  return {};
}

bool printable(std::string_view text) {
  return std::ranges::none_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
}

/// @param place of the row, for the message
Result<void> checkRow(const FingerPath::Knot& row, double before_s, bool first, const std::string& place) {
  const auto within = [](double value, double least, double most) { return value >= least && value <= most; };
  if (first && row.time_s != 0.0) return fail("{}: t_s is {}; expected 0 in the first row", place, row.time_s);
  if (!within(row.time_s, 0.0, kLongest_s)) {
    return fail("{}: t_s is {}; expected 0 to {} s", place, row.time_s, kLongest_s);
  }
  if (!first && !(row.time_s > before_s)) {
    return fail("{}: t_s is {} after {}; time must increase from row to row", place, row.time_s, before_s);
  }
  const FingerState& at = row.state;
  if (!within(at.x_mm, -kUsableHalfWidth_mm, kUsableHalfWidth_mm)) {
    return fail("{}: x_mm is {}; expected −{} to {}", place, at.x_mm, kUsableHalfWidth_mm, kUsableHalfWidth_mm);
  }
  if (!within(at.y_mm, -kUsableHalfDepth_mm, kUsableHalfDepth_mm)) {
    return fail("{}: y_mm is {}; expected −{} to {}", place, at.y_mm, kUsableHalfDepth_mm, kUsableHalfDepth_mm);
  }
  if (!within(at.indentation_mm, 0.0, kDeepestPress_mm)) {
    return fail("{}: depth_mm is {}; expected 0 to {}", place, at.indentation_mm, kDeepestPress_mm);
  }
  return {};
}

Result<void> checkHeader(const GestureCard& card, const std::string& place) {
  if (!isGestureName(card.name)) {
    return fail("{}: name of {} bytes: expected 1 to {} that can be printed", place, card.name.size(), kLongestText);
  }
  if (card.source.size() > kLongestText || !printable(card.source)) {
    return fail("{}: source of {} bytes: expected at most {} that can be printed", place, card.source.size(),
                kLongestText);
  }
  if (!(card.speed >= kSlowestGesture && card.speed <= kFastestGesture)) {
    return fail("{}: speed = {}: expected {} to {}", place, card.speed, kSlowestGesture, kFastestGesture);
  }
  return {};
}

Result<GestureCard> parseHeader(std::string_view text, const std::string& name) {
  const auto parsed = parseToml(text, name);
  if (!parsed) return tl::unexpected(parsed.error());
  const toml::table& root = *parsed;
  for (const auto& [key, node] : root) {
    if (std::ranges::find(kKeys, key.str()) == kKeys.end()) {
      return fail("{}:{}: {}: expected one of {}", name, node.source().begin.line, std::string(key.str()),
                  fmt::format("{}", fmt::join(kKeys, ", ")));
    }
  }
  const auto format = root["format"].value_exact<std::string>();
  if (!format || *format != kFormat) {
    return fail("{}:1: format = \"{}\": expected \"{}\"", name, format.value_or(""), kFormat);
  }
  const auto wrong = [&](std::string_view key, std::string_view expected) {
    const toml::node* node = root.get(key);
    return fail("{}:{}: {}: expected {}", name, node == nullptr ? 1U : node->source().begin.line, key, expected);
  };
  GestureCard card;
  const auto title = root["name"].value_exact<std::string>();
  if (!title) return wrong("name", "a text in quotes");
  card.name = *title;
  if (const auto node = root["source"]) {
    if (!node.is_string()) return wrong("source", "a text in quotes");
    card.source = *node.value_exact<std::string>();
  }
  if (const auto node = root["speed"]) {
    if (!node.is_number()) return wrong("speed", "a number");
    card.speed = *node.value<double>();
  }
  if (const auto node = root["loop"]) {
    if (!node.is_boolean()) return wrong("loop", "true or false");
    card.loop = *node.value_exact<bool>();
  }
  if (auto good = checkHeader(card, name); !good) return tl::unexpected(good.error());
  return card;
}

}  // namespace

FingerPath GestureCard::path() const { return FingerPath::fromKnots(rows).played(speed, loop); }

bool isGestureName(std::string_view name) { return !name.empty() && name.size() <= kLongestText && printable(name); }

bool isGestureCard(std::string_view text) {
  // A card may begin with a comment or another key; no recording has the line.
  return text.starts_with(kBegins) || findRule(text).begin != std::string_view::npos;
}

Result<GestureCard> parseGesture(std::string_view text, std::string_view source_name) {
  const std::string name(source_name);
  const Rule rule = findRule(text);
  if (rule.begin == std::string_view::npos) {
    return fail("{}: no line --- between the card's head and its rows; expected one", name);
  }
  auto card = parseHeader(text.substr(0, rule.begin), name);
  if (!card) return card;
  const std::string_view head = text.substr(0, rule.rows);
  const auto lines = static_cast<std::size_t>(std::ranges::count(head, '\n'));
  const auto table = parseCsv(text.substr(head.size()), name + ", below ---", {"t_s", "x_mm", "y_mm", "depth_mm"});
  if (!table) return tl::unexpected(table.error());
  if (table->rows() < 2) return fail("{}: {} rows: expected two and more", name, table->rows());
  for (std::size_t i = 0; i < table->rows(); ++i) {
    const double depth = table->values[3][i];
    const FingerPath::Knot row{.time_s = table->values[0][i],
                               .state = {.x_mm = table->values[1][i],
                                         .y_mm = table->values[2][i],
                                         .indentation_mm = depth,
                                         .lifted = !(depth > 0.0)}};
    const double before_s = i == 0 ? 0.0 : card->rows.back().time_s;
    const std::string place = fmt::format("{}:{}", name, table->lines[i] + lines);
    if (auto good = checkRow(row, before_s, i == 0, place); !good) return tl::unexpected(good.error());
    card->rows.push_back(row);
  }
  return card;
}

Result<std::string> formatGesture(const GestureCard& card) {
  if (auto good = checkHeader(card, "gesture"); !good) return tl::unexpected(good.error());
  if (card.rows.size() < 2) return fail("gesture: {} rows: expected two and more", card.rows.size());
  toml::table head{{"name", card.name}, {"source", card.source}, {"speed", card.speed}, {"loop", card.loop}};
  std::string out = fmt::format("format = \"{}\"\n", kFormat);
  for (const std::string_view key : kKeys) {
    if (const toml::node* node = head.get(key); node != nullptr) {
      std::ostringstream value;
      node->visit([&value](const auto& is) { value << is; });
      out += fmt::format("{} = {}\n", key, value.str());
    }
  }
  out += "---\nt_s,x_mm,y_mm,depth_mm\n";
  for (std::size_t i = 0; i < card.rows.size(); ++i) {
    const FingerPath::Knot& row = card.rows[i];
    const double before_s = i == 0 ? 0.0 : card.rows[i - 1].time_s;
    if (auto good = checkRow(row, before_s, i == 0, fmt::format("gesture, row {}", i + 1)); !good) {
      return tl::unexpected(good.error());
    }
    out += fmt::format("{},{},{},{}\n", row.time_s, row.state.x_mm, row.state.y_mm,
                       row.state.lifted ? 0.0 : row.state.indentation_mm);
  }
  return out;
}

Result<GestureCard> trimmed(const GestureCard& card, double from_s, double to_s) {
  GestureCard out = card;
  out.rows.clear();
  for (const FingerPath::Knot& row : card.rows) {
    if (row.time_s >= from_s && row.time_s <= to_s) out.rows.push_back(row);
  }
  if (out.rows.size() < 2) {
    return fail("gesture \"{}\": {} rows from {} to {} s: expected two and more of its {} s", card.name,
                out.rows.size(), from_s, to_s, card.duration_s());
  }
  const double begins_s = out.rows.front().time_s;
  for (FingerPath::Knot& row : out.rows) row.time_s -= begins_s;
  return out;
}

Result<GestureCard> readGestureFile(const std::string& path) {
  const auto text = readWholeFile(path, kLargestCard_bytes, FileKind::pipe_too);
  if (!text) return tl::unexpected(text.error());
  return parseGesture(*text, path);
}

Result<FingerPath> readFingerFile(const std::string& path) {
  const auto text = readWholeFile(path, kLargestCsv_bytes, FileKind::pipe_too);
  if (!text) return tl::unexpected(text.error());
  if (!isGestureCard(*text)) return FingerPath::fromCsvText(*text, path);
  auto card = parseGesture(*text, path);
  if (!card) return tl::unexpected(card.error());
  return card->path();
}

}  // namespace fyd::sim
