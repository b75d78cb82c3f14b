// Gains and calibration of a report, from the profile stored in a recording.
#include <algorithm>
#include <array>
#include <sstream>

#include "core/base/toml_parameters.h"
#include "core/pipeline/parameters.h"
#include "core/report/report_content.h"

namespace fyd::report {
namespace {

/// Shown also at their defaults.
constexpr auto kAlways = std::to_array<std::string_view>(
    {"control.mode", "control.law", "control.kp", "control.ki", "control.kd", "control.dead_band_N_per_mm",
     "sensing.finger_mode", "sensing.indentation_mode", "sensing.stiffness_mode", "sensing.finger_scale_x_mm_per_px",
     "sensing.finger_scale_y_mm_per_px", "sensing.ir_offset_mm", "sensing.force_slope_g", "sensing.force_offset_g",
     "sensing.force_zero_N", "texture.method", "texture.k_vib"});

/// A value as assignParameter reads it.
std::string textOf(const toml::node& node) {
  if (const auto* text = node.as_string()) return text->get();
  std::ostringstream out;
  toml::node_view<const toml::node>(node).visit([&](const auto& value) { out << value; });
  return out.str();
}

}  // namespace

ReportTable profileTable(const std::string& profile_toml) {
  ReportTable table{.heading = "Gains and calibration in use",
                    .columns = {{"Parameter", 2.2}, {"Value", 2.0}, {"Unit", 0.8}, {"Default", 1.6}}};
  if (profile_toml.empty()) {
    table.remark = "The recording carries no profile.";
    return table;
  }
  const auto parsed = parseToml(profile_toml, "profile");
  if (!parsed) {
    table.remark = fmt::format("The recording's profile cannot be read: {}.", parsed.error().text());
    return table;
  }
  pipeline::Parameters used;
  pipeline::Parameters defaults;
  const std::vector<Parameter> all = bindParameters(used);
  const std::vector<Parameter> originals = bindParameters(defaults);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::size_t point = all[i].id.find('.');
    const toml::node_view<const toml::node> node = (*parsed)[all[i].id.substr(0, point)][all[i].id.substr(point + 1)];
    if (!node && all[i].info.before_it_was) all[i].set(*all[i].info.before_it_was);  // of an older program
    std::string value = formatParameter(all[i]);
    if (node) {
      const std::string text = textOf(*node.node());
      value = assignParameter(all[i], text) ? formatParameter(all[i]) : exports::cleanText(text);
    }
    const std::string original = formatParameter(originals[i]);
    const bool changed = value != original;
    if (!changed && std::ranges::find(kAlways, all[i].id) == kAlways.end()) continue;
    const std::string unit = all[i].info.unit == "1" ? "" : std::string(all[i].info.unit);
    table.rows.push_back({std::string(all[i].id), value, unit, changed ? original : "="});
  }
  table.remark = "As at the recording's start: gains, calibration, and all else that is not at its default.";
  return table;
}

}  // namespace fyd::report
