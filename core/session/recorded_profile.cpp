#include "core/session/recorded_profile.h"

#include <optional>
#include <sstream>

#include <toml++/toml.h>

#include "core/base/profile_text.h"

namespace fyd::session {
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
  std::ostringstream text;
  try {
    text << onlyKnown(toml::parse(header.profile, kSource), bound);
  } catch (const toml::parse_error& error) {
    return fail("{}:{}: {}", kSource, error.source().begin.line, error.description());
  }
  if (auto parsed = parseProfile(text.str(), kSource, bound); !parsed) return tl::unexpected(parsed.error());
  return out;
}

Result<std::optional<texture::SurfaceModel>> recordedSurface(const RecordingHeader& header) {
  if (header.surface.empty()) return std::nullopt;
  auto model = texture::parseSurface(header.surface, "the recording's surface");
  if (!model) return tl::unexpected(model.error());
  return std::move(*model);
}

}  // namespace fyd::session
