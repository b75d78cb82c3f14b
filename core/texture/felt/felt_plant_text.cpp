// FeltPlant as TOML (plant.toml).
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/parameter.h"
#include "core/base/toml_parameters.h"
#include "core/texture/felt/felt_plant.h"

namespace fyd::texture {
namespace {

constexpr std::string_view kPrefix = "texture.plant_";
constexpr std::string_view kBreakaway = "breakaway_percent";
constexpr std::string_view kIdentified = "identified";
constexpr std::array<std::string_view, 2> kBreakaways = {"breakaway_first_percent", "breakaway_second_percent"};
constexpr std::array<std::string_view, 5> kRequired = {"free_speed_deg_s", "time_constant_ms", "roller_radius_mm",
                                                       "resonance_Hz", "damping"};

std::string place(std::string_view source, const toml::node& node) {
  return fmt::format("{}:{}", source, std::max<toml::source_index>(node.source().begin.line, 1));
}

Result<void> take(const Parameter& parameter, std::string_view key, const toml::node& node, std::string_view source) {
  const auto value = node.is_boolean() ? std::nullopt : node.value<double>();
  if (!value || !mayTake(parameter, *value)) {
    return fail("{}: {}{}: expected {}", place(source, node), key, value ? fmt::format(" = {}", *value) : "",
                describeRange(parameter));
  }
  parameter.set(*value);
  return {};
}

}  // namespace

Result<FeltPlant> parsePlant(std::string_view text, std::string_view source_name, std::vector<std::string>* unknown) {
  const auto parsed = parseToml(text, source_name);
  if (!parsed) return tl::unexpected(parsed.error());
  const toml::table& root = *parsed;
  FeltPlant plant;
  plant.identified = true;
  const std::vector<Parameter> parameters = bindParameters(plant);
  const auto find = [&parameters](std::string_view key) {
    return findParameter(parameters, std::string(kPrefix).append(key));
  };
  for (const std::string_view key : kRequired) {
    if (root.get(key) == nullptr) return fail("{}: no {}; expected {}", source_name, key, describeRange(*find(key)));
  }
  const toml::node* breakaway = root.get(kBreakaway);
  if (breakaway == nullptr) {
    return fail("{}: no {}; expected {}", source_name, kBreakaway, describeRange(*find(kBreakaways[0])));
  }
  const toml::array* both = breakaway->as_array();
  if (both != nullptr && both->size() != kBreakaways.size()) {
    return fail("{}: {} with {} values: expected one number, or one for each of {} motors",
                place(source_name, *breakaway), kBreakaway, both->size(), kBreakaways.size());
  }
  for (std::size_t i = 0; i < kBreakaways.size(); ++i) {
    const toml::node& node = both != nullptr ? *both->get(i) : *breakaway;
    if (auto taken = take(*find(kBreakaways[i]), kBreakaway, node, source_name); !taken) {
      return tl::unexpected(taken.error());
    }
  }
  for (const auto& [key, node] : root) {
    if (key.str() == kBreakaway) continue;
    if (key.str() == kIdentified) {
      const auto value = node.value_exact<bool>();
      if (!value) return fail("{}: {}: expected true or false", place(source_name, node), kIdentified);
      plant.identified = *value;
      continue;
    }
    const Parameter* parameter = find(key.str());
    if (parameter == nullptr) {
      if (unknown != nullptr) unknown->push_back(fmt::format("{}: '{}'", place(source_name, node), key.str()));
      continue;
    }
    if (auto taken = take(*parameter, key.str(), node, source_name); !taken) return tl::unexpected(taken.error());
  }
  return plant;
}

std::string formatPlant(const FeltPlant& plant) {
  FeltPlant copy = plant;
  std::string out = fmt::format("{} = [{}, {}]\n", kBreakaway, plant.breakaway_percent[0], plant.breakaway_percent[1]);
  for (const Parameter& parameter : bindParameters(copy)) {
    const std::string_view key = parameter.id.substr(kPrefix.size());
    if (std::find(kBreakaways.begin(), kBreakaways.end(), key) != kBreakaways.end()) continue;
    out += fmt::format("{} = {}\n", key, formatParameter(parameter));
  }
  return out;
}

}  // namespace fyd::texture
