#include "app/cli/bench/predict_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace fyd::bench {
namespace {

constexpr double kWide = 340.0, kHigh = 260.0, kLeft = 46.0, kTop = 28.0, kPanel = 400.0, kPanelHigh = 320.0;
constexpr std::size_t kInARow = 3;
constexpr double kLeast_ns = 5.0, kMost_ns = 2000.0, kMost = 2.0;

double across(double ns) {
  const double part = std::log(std::clamp(ns, kLeast_ns, kMost_ns) / kLeast_ns) / std::log(kMost_ns / kLeast_ns);
  return kLeft + kWide * part;
}
double down(double relative) { return kTop + kHigh * (1.0 - std::clamp(relative, 0.0, kMost) / kMost); }

std::string text(double x, double y, std::string_view anchor, std::string_view words) {
  return fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor, words);
}

std::string panel(const PredictorPanel& of) {
  std::string out = text(kLeft + kWide / 2, 16, "middle", of.title);
  for (const double ns : {10.0, 100.0, 1000.0}) {
    out += fmt::format("<path d=\"M{0:.0f} {1:.0f}V{2:.0f}\" stroke=\"#ddd\"/>\n", across(ns), kTop, kTop + kHigh);
    out += text(across(ns), kTop + kHigh + 15, "middle", fmt::format("{:.0f} ns", ns));
  }
  for (const double relative : {0.0, 0.5, 1.0, 1.5, 2.0}) {
    out += fmt::format("<path d=\"M{:.0f} {:.0f}h{:.0f}\" stroke=\"{}\"/>\n", kLeft, down(relative), kWide,
                       relative == 1.0 ? "#888" : "#ddd");
    out += text(kLeft - 5, down(relative) + 4, "end", fmt::format("{:.1f}", relative));
  }
  std::vector<double> taken;
  for (const PredictorPoint& point : of.points) {
    const double x = across(point.ns), y = down(point.relative);
    double label = y + 4;
    while (std::ranges::any_of(taken, [&](double other) { return std::abs(other - label) < 12; })) label -= 4;
    taken.push_back(label);
    out += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"{}\"/>\n", x, y,
                       point.name == "default" ? "#b00" : "#246");
    const bool right = x > kLeft + kWide - 60;
    out += text(right ? x - 8 : x + 8, label, right ? "end" : "start",
                point.relative > kMost ? fmt::format("{} ({:.1f})", point.name, point.relative) : point.name);
  }
  return out;
}

}  // namespace

std::string errorAgainstCost(const std::vector<PredictorPanel>& panels) {
  const std::size_t across_panels = std::min(panels.size(), kInARow);
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" font-family=\"sans-serif\" "
      "font-size=\"11\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      kPanel * static_cast<double>(across_panels),
      kPanelHigh * static_cast<double>((panels.size() + kInARow - 1) / kInARow));
  for (std::size_t i = 0; i < panels.size(); ++i) {
    out +=
        fmt::format("<g transform=\"translate({:.0f} {:.0f})\">\n{}</g>\n", kPanel * static_cast<double>(i % kInARow),
                    kPanelHigh * static_cast<double>(i / kInARow), panel(panels[i]));
  }
  return out + "</svg>\n";
}

}  // namespace fyd::bench
