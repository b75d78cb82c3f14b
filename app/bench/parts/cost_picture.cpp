#include "app/bench/parts/cost_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace fyd::bench {
namespace {

constexpr double kWide = 340.0, kHigh = 260.0, kLeft = 58.0, kTop = 28.0, kPanel = 412.0, kPanelHigh = 320.0;
constexpr std::size_t kInARow = 3;
constexpr double kLabelWide = 75.0;

double logShare(double value, double least, double most) {
  return std::log(std::clamp(value, least, most) / least) / std::log(most / least);
}
double across(double cost, const CostAxes& axes) { return kLeft + kWide * logShare(cost, axes.least, axes.most); }
std::string costWords(double cost, bool ratio) {
  if (ratio) return fmt::format("{:g} ×", cost);
  return cost < 1000.0 ? fmt::format("{:.0f} ns", cost) : fmt::format("{:.0f} µs", 1e-3 * cost);
}
double down(double error, const CostAxes& axes) {
  const double least = axes.errors.front(), most = axes.errors.back();
  const double part =
      axes.logarithmic ? logShare(error, least, most) : (std::clamp(error, least, most) - least) / (most - least);
  return kTop + kHigh * (1.0 - part);
}

std::string text(double x, double y, std::string_view anchor, std::string_view plain) {
  std::string words;
  for (const char c : plain) words += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
  return fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor, words);
}

std::string panel(const CostPanel& of, const CostAxes& axes) {
  std::string out = text(kLeft + kWide / 2, 16, "middle", of.title);
  for (int decade = axes.ratio ? -9 : 1; decade < 10; ++decade) {
    const double cost = std::pow(10.0, decade);
    if (cost < 0.999 * axes.least || cost > 1.001 * axes.most) continue;
    const double x = across(cost, axes);
    out += fmt::format("<path d=\"M{0:.0f} {1:.0f}V{2:.0f}\" stroke=\"#ddd\"/>\n", x, kTop, kTop + kHigh);
    out += text(x, kTop + kHigh + 15, "middle", costWords(cost, axes.ratio));
  }
  for (const double error : axes.errors) {
    const double y = down(error, axes);
    out += fmt::format("<path d=\"M{:.0f} {:.0f}h{:.0f}\" stroke=\"{}\"/>\n", kLeft, y, kWide,
                       error == axes.marked_error ? "#888" : "#ddd");
    out += text(kLeft - 5, y + 4, "end", fmt::format("{:g}{}", error, axes.unit));
  }
  struct Label {
    double x, y;
  };
  std::vector<Label> taken;
  for (const CostPoint& point : of.points) {
    const double x = across(point.cost, axes), y = down(point.error, axes);
    const auto free = [&](double at) {
      return std::ranges::none_of(
          taken, [&](const Label& other) { return std::abs(other.x - x) < kLabelWide && std::abs(other.y - at) < 12; });
    };
    double label = y + 4;
    for (int turn = 1; !free(label) && turn < 20; ++turn) label = y + 4 + (turn % 2 == 1 ? 6.5 : -6.5) * (turn + 1);
    taken.push_back({x, label});
    out += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"{}\"/>\n", x, y,
                       point.name == axes.marked ? "#b00" : "#246");
    const bool right = x > kLeft + kWide - 60;
    out += text(right ? x - 8 : x + 8, label, right ? "end" : "start",
                point.error > axes.errors.back() ? fmt::format("{} ({:.1f})", point.name, point.error) : point.name);
  }
  return out;
}

}  // namespace

std::string errorAgainstCost(const std::vector<CostPanel>& panels, const CostAxes& axes) {
  const std::size_t in_a_row = panels.size() == kInARow + 1 ? 2 : kInARow;  // no panel alone
  const std::size_t across_panels = std::min(panels.size(), in_a_row);
  const std::size_t down_panels = (panels.size() + in_a_row - 1) / in_a_row;
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" font-family=\"sans-serif\" "
      "font-size=\"11\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      kPanel * static_cast<double>(across_panels), kPanelHigh * static_cast<double>(down_panels));
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const std::size_t row = i / in_a_row, column = i % in_a_row;
    out += fmt::format("<g transform=\"translate({:.0f} {:.0f})\">\n{}</g>\n", kPanel * static_cast<double>(column),
                       kPanelHigh * static_cast<double>(row), panel(panels[i], axes));
  }
  return out + "</svg>\n";
}

}  // namespace fyd::bench
