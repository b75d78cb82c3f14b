#include "app/cli/teleop/teleop_picture.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace fyd::cli {
namespace {

constexpr double kWide = 250.0, kHigh = 118.0, kName = 52.0, kBar = 130.0, kLine = 15.0, kTop = 20.0;

std::string panelText(const TeleopPanel& panel) {
  double longest = 0.0;
  for (const auto& [name, rms] : panel.rms_mm) longest = std::max(longest, rms);
  std::string out =
      fmt::format("<text x=\"0\" y=\"11\" font-weight=\"bold\">{}, {:.0f} ms</text>\n", panel.network, panel.period_ms);
  double y = kTop;
  for (const auto& [name, rms] : panel.rms_mm) {
    const double length = longest > 0.0 && std::isfinite(rms) ? kBar * rms / longest : 0.0;
    out += fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"end\">{}</text>", kName - 4, y + 9, name);
    out += fmt::format("<rect x=\"{:.0f}\" y=\"{:.0f}\" width=\"{:.1f}\" height=\"10\" fill=\"{}\"/>", kName, y, length,
                       name == "default" ? "#b00" : "#246");
    out += fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\">{:.3g} mm</text>\n", kName + length + 4, y + 9, rms);
    y += kLine;
  }
  return out;
}

}  // namespace

std::string teleopPicture(const std::vector<TeleopPanel>& panels) {
  std::size_t columns = 0;
  while (columns < panels.size() && panels[columns].network == panels.front().network) ++columns;
  columns = std::max<std::size_t>(columns, 1);
  const std::size_t rows = (panels.size() + columns - 1) / columns;
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" font-family=\"sans-serif\" "
      "font-size=\"10\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      kWide * static_cast<double>(columns) + 10, kHigh * static_cast<double>(rows) + 10);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const std::size_t row = i / columns, column = i % columns;
    out += fmt::format("<g transform=\"translate({:.0f} {:.0f})\">\n{}</g>\n", 10 + kWide * static_cast<double>(column),
                       5 + kHigh * static_cast<double>(row), panelText(panels[i]));
  }
  return out + "</svg>\n";
}

}  // namespace fyd::cli
