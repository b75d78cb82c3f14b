#include "core/recording/reader/recorded_profile.h"

#include <algorithm>
#include <optional>
#include <sstream>

#include "core/base/profile_text.h"
#include "core/base/toml_parameters.h"
#include "core/pipeline/state_of_arithmetic_1.h"
#include "core/scene/scene_bytes.h"

namespace fyd::recording {
namespace {

constexpr std::string_view kSource = "the recording's profile";

toml::table onlyKnown(const toml::table& profile, std::span<const Parameter> parameters) {
  toml::table out;
  for (const auto& [room, node] : profile) {
    const toml::table* table = node.as_table();
    if (table == nullptr) continue;
    toml::table kept;
    for (const auto& [key, value] : *table) {
      if (findParameter(parameters, fmt::format("{}.{}", room.str(), key.str())) != nullptr) kept.insert(key, value);
    }
    if (!kept.empty()) out.insert(room, std::move(kept));
  }
  return out;
}

}  // namespace

Result<pipeline::Parameters> recordedParameters(const RecordingHeader& header) {
  pipeline::Parameters out;
  const std::vector<Parameter> bound = bindParameters(out);
  const auto profile = parseToml(header.profile, kSource);
  if (!profile) return tl::unexpected(profile.error());
  std::ostringstream text;
  text << onlyKnown(*profile, bound);
  const std::vector<ProfileEntry> listed = profileEntries(header.profile);
  for (const Parameter& parameter : bound) {
    const auto names = [&parameter](const ProfileEntry& entry) { return entry.id == parameter.id; };
    if (parameter.info.before_it_was && std::ranges::none_of(listed, names))
      parameter.set(*parameter.info.before_it_was);
  }
  if (auto parsed = parseProfile(text.str(), kSource, bound, Ranges::mark); !parsed) {
    return tl::unexpected(parsed.error());
  }
  return out;
}

Result<std::string> recordedState(const RecordingHeader& header) {
  if (!pipeline::isStateOfArithmetic1(header.step_state)) return header.step_state;
  return pipeline::convertStateOfArithmetic1(header.step_state, profileEntries(header.profile));
}

RecordedIndices::RecordedIndices(const RecordingHeader& header) {
  pipeline::Parameters today;
  const std::vector<Parameter> bound = bindParameters(today);
  for (const ProfileEntry& recorded : profileEntries(header.profile)) {
    Entry& entry = entries_.emplace_back();
    const Parameter* parameter = findParameter(bound, recorded.id);
    if (parameter == nullptr) continue;
    entry.index = static_cast<std::uint16_t>(parameter - bound.data());
    for (const std::string& word : recorded.choices) {
      const auto found = std::ranges::find(parameter->choices, word);
      entry.words.push_back(found == parameter->choices.end()
                                ? kUnknown
                                : static_cast<std::uint16_t>(found - parameter->choices.begin()));
    }
  }
}

void RecordedIndices::translate(std::uint16_t& index, double& value) const {
  if (entries_.empty()) return;
  if (index >= entries_.size()) {
    index = kUnknown;
    return;
  }
  const Entry& entry = entries_[index];
  index = entry.index;
  if (entry.words.empty() || !(value >= 0.0 && value < static_cast<double>(entry.words.size()))) return;
  const std::uint16_t word = entry.words[static_cast<std::size_t>(value)];
  if (word == kUnknown) {
    index = kUnknown;
  } else {
    value = word;
  }
}

Result<pipeline::LocalModel> recordedLocalModel(const RecordingHeader& header) {
  pipeline::LocalModel local;
  if (!header.surface.empty()) {
    auto model = texture::parseSurface(header.surface, "the recording's surface");
    if (!model) return tl::unexpected(model.error());
    local.surface = std::move(*model);
  }
  if (header.scene) {
    auto scene = scene::unpackScene(*header.scene);
    if (!scene) return fail(about("the recording's scene", scene.error().message));
    local.scene = std::make_shared<const scene::FeltScene>(std::move(*scene));
  }
  return local;
}

}  // namespace fyd::recording
