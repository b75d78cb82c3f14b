#include "widgets/curves/curve_choice.h"

#include <QStringList>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "widgets/basics/words.h"

namespace fyd::widgets {
namespace {

using Json = nlohmann::json;

struct Wanted {
  bool shown = false;
  std::optional<Range> range;
};

std::optional<Wanted> wantedOf(const Json& entry) {
  if (!entry.is_object() || !entry.contains("shown") || !entry["shown"].is_boolean()) return std::nullopt;
  Wanted out{.shown = entry["shown"].get<bool>(), .range = {}};
  if (!entry.contains("range")) return out;
  const Json& ends = entry["range"];
  if (!ends.is_array() || ends.size() != 2 || !ends[0].is_number() || !ends[1].is_number()) return std::nullopt;
  out.range = Range{ends[0].get<double>(), ends[1].get<double>()};
  const bool possible = out.range->lower < out.range->upper && std::abs(out.range->lower) <= kLargestChosen &&
                        std::abs(out.range->upper) <= kLargestChosen;
  return possible ? std::optional(out) : std::nullopt;
}

}  // namespace

QByteArray choiceOf(const CurveStack& stack) {
  Json out{{"linked", stack.linked()}, {"curves", Json::object()}};
  for (std::size_t i = 0; i < stack.size(); ++i) {
    Json& strip = out["curves"][stack.setup(i).id.toStdString()];
    strip["shown"] = stack.shown(i);
    if (const auto& range = stack.strip(i)->chosenRange()) strip["range"] = {range->lower, range->upper};
  }
  return QByteArray::fromStdString(out.dump());
}

QString takeChoice(CurveStack& stack, const QByteArray& choice) {
  if (choice.isEmpty()) return tr("The layout says nothing of the curves: they stay as they are.");
  const Json read = Json::parse(choice.begin(), choice.end(), nullptr, false);
  if (!read.is_object() || !read.contains("curves") || !read["curves"].is_object()) {
    return tr("The layout's choice of curves cannot be read: the curves stay as they are.");
  }
  QStringList left_out;
  std::vector<std::pair<std::size_t, Wanted>> wanted;
  for (const auto& [id, entry] : read["curves"].items()) {
    const std::size_t index = stack.indexOf(QString::fromStdString(id));
    const auto good = index < stack.size() ? wantedOf(entry) : std::nullopt;
    if (good) {
      wanted.emplace_back(index, *good);
    } else {
      left_out << QString::fromStdString(id).left(40);
    }
  }
  // The last one shown cannot be hidden, so those to be shown are set first.
  for (const bool shown : {true, false}) {
    for (const auto& [index, each] : wanted) {
      if (each.shown == shown) stack.setShown(index, shown);
    }
  }
  for (const auto& [index, each] : wanted) stack.strip(index)->chooseRange(each.range);
  if (read.contains("linked") && read["linked"].is_boolean()) stack.setLinked(read["linked"].get<bool>());
  emit stack.moved();
  if (left_out.isEmpty()) return {};
  return tr("The layout's choice of these curves is not possible and was left out: %1.")
      .arg(left_out.mid(0, 10).join(QStringLiteral(", ")));
}

}  // namespace fyd::widgets
