#include "core/texture/surface_model.h"

#include <array>
#include <cmath>
#include <optional>

#include "core/base/toml_parameters.h"
#include "core/texture/surface_ranges.h"

namespace fyd::texture {
namespace {

struct Key {
  std::string_view name;
  SurfaceRange range;
  bool required;
};
constexpr std::array<Key, 4> kModelKeys = {{{"reference_speed_mm_s", {1, 1000}, true},
                                            {"reference_force_N", {0.01, 20}, true},
                                            {"speed_exponent", {0, 3}, true},
                                            {"force_exponent", {0, 3}, true}}};
constexpr std::array<Key, 4> kBandKeys = {{{"wavelength_mm", kWavelengths_mm, false},
                                           {"frequency_Hz", kFrequencies_Hz, false},
                                           {"quality", {0.1, 100}, true},
                                           {"rms_g", kBandRms_g, true}}};

// Strict reading of one table: every key known, of the right type and in range.
class TableReader {
 public:
  TableReader(const toml::table& table, std::string_view source, std::string_view what)
      : table_(table), source_(source), what_(what) {}

  template <std::size_t N>
  Result<std::array<double, N>> numbers(const std::array<Key, N>& keys) const {
    std::array<double, N> out{};
    for (std::size_t i = 0; i < N; ++i) {
      const toml::node* node = table_.get(keys[i].name);
      if (node == nullptr) {
        if (keys[i].required) return fail("{}: {} without '{}'", place(table_), what_, keys[i].name);
        continue;
      }
      const auto value = node->is_boolean() ? std::nullopt : node->value<double>();
      const SurfaceRange& range = keys[i].range;
      if (!value || !range.has(*value)) {
        return fail("{}: {}{}: expected a number from {} to {}", place(*node), keys[i].name,
                    value ? fmt::format(" = {}", *value) : "", range.minimum, range.maximum);
      }
      out[i] = *value;
    }
    return out;
  }

  Result<std::string> text(std::string_view key, bool required) const {
    const toml::node* node = table_.get(key);
    if (node == nullptr) {
      if (required) return fail("{}: {} without '{}'", place(table_), what_, key);
      return std::string();
    }
    const auto value = node->value_exact<std::string>();
    if (!value) return fail("{}: {}: expected a text in quotes", place(*node), key);
    return *value;
  }

  template <std::size_t N>
  Result<void> onlyKnown(const std::array<Key, N>& keys, std::initializer_list<std::string_view> more) const {
    for (const auto& [key, node] : table_) {
      bool known = false;
      for (const Key& k : keys) known = known || k.name == key.str();
      for (const std::string_view k : more) known = known || k == key.str();
      if (!known) return fail("{}: unknown key '{}' in {}", place(node), key.str(), what_);
    }
    return {};
  }

  [[nodiscard]] std::string place(const toml::node& node) const {
    return fmt::format("{}:{}", source_, std::max<toml::source_index>(node.source().begin.line, 1));
  }

 private:
  const toml::table& table_;
  std::string_view source_;
  std::string_view what_;
};

Result<SurfaceBand> readBand(const toml::table& table, std::string_view source) {
  const TableReader reader(table, source, "[[band]]");
  if (auto known = reader.onlyKnown(kBandKeys, {}); !known) return tl::unexpected(known.error());
  const auto values = reader.numbers(kBandKeys);
  if (!values) return tl::unexpected(values.error());
  const auto [wavelength_mm, frequency_Hz, quality, rms_g] = *values;
  if ((wavelength_mm > 0.0) == (frequency_Hz > 0.0)) {
    return fail("{}: [[band]]: expected either wavelength_mm or frequency_Hz", reader.place(table));
  }
  return SurfaceBand{wavelength_mm, frequency_Hz, quality, rms_g};
}

Result<std::vector<SurfaceBand>> readBands(const toml::table& root, std::string_view source) {
  const toml::array* array = root["band"].as_array();
  if (array == nullptr || array->empty() || !array->is_array_of_tables()) {
    return fail("{}: expected at least one [[band]]", source);
  }
  if (array->size() > kMaximumBands) return fail("{}: {} bands; at most {}", source, array->size(), kMaximumBands);
  std::vector<SurfaceBand> bands;
  for (const toml::node& node : *array) {
    auto band = readBand(*node.as_table(), source);
    if (!band) return tl::unexpected(band.error());
    bands.push_back(*band);
  }
  return bands;
}

}  // namespace

Result<SurfaceModel> parseSurface(std::string_view text, std::string_view source_name) {
  const auto parsed = parseToml(text, source_name);
  if (!parsed) return tl::unexpected(parsed.error());
  const toml::table& root = *parsed;
  const TableReader reader(root, source_name, "the surface");
  if (auto known = reader.onlyKnown(kModelKeys, {"name", "description", "band"}); !known) {
    return tl::unexpected(known.error());
  }
  auto name = reader.text("name", true);
  if (!name) return tl::unexpected(name.error());
  auto description = reader.text("description", false);
  if (!description) return tl::unexpected(description.error());
  const auto values = reader.numbers(kModelKeys);
  if (!values) return tl::unexpected(values.error());
  auto bands = readBands(root, source_name);
  if (!bands) return tl::unexpected(bands.error());
  const auto [speed, force, speed_exponent, force_exponent] = *values;
  return SurfaceModel{*name, *description, speed, force, speed_exponent, force_exponent, *bands};
}

std::string formatSurface(const SurfaceModel& model) {
  toml::table root;
  root.insert("name", model.name);
  root.insert("description", model.description);
  std::ostringstream head;
  head << root;
  std::string out = head.str() + "\n";
  out += fmt::format("reference_speed_mm_s = {}\nreference_force_N = {}\nspeed_exponent = {}\nforce_exponent = {}\n",
                     model.reference_speed_mm_s, model.reference_force_N, model.speed_exponent, model.force_exponent);
  for (const SurfaceBand& band : model.bands) {
    out += "\n[[band]]\n";  // both, or none, as it may be: parseSurface then refuses it
    if (band.wavelength_mm != 0.0) out += fmt::format("wavelength_mm = {}\n", band.wavelength_mm);
    if (band.frequency_Hz != 0.0) out += fmt::format("frequency_Hz = {}\n", band.frequency_Hz);
    out += fmt::format("quality = {}\nrms_g = {}\n", band.quality, band.rms_g);
  }
  return out;
}

}  // namespace fyd::texture
