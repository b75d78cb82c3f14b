// Which scene an end holds a copy of, as the last words of its self-description: "fyd robot 0.1.0 scene DIGEST".
//
// FYD Link carries it both ways (RobotHello::text, TouchpadHello::board_text). The classic protocol's robot describes
// itself with no words, and asks for the touchpad's with command 5 only.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/message.h"

namespace fyd::protocol {

/// @param digest of the scene (core/scene/scene_digest.h); empty: none is held
[[nodiscard]] inline std::string describedWith(std::string_view words, std::string_view digest) {
  std::string out(words);
  return digest.empty() ? out : out.append(" scene ").append(digest);
}

/// @return the digest; empty where none is described, or nothing that can be one
[[nodiscard]] inline std::string_view describedScene(std::string_view description) {
  constexpr std::string_view kMark = "scene ";
  constexpr std::size_t kDigits = 32;
  const std::size_t mark = description.rfind(kMark);
  if (mark == std::string_view::npos || (mark > 0 && description[mark - 1] != ' ')) return {};
  const std::string_view digest = description.substr(mark + kMark.size());
  const auto hexadecimal = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
  return digest.size() == kDigits && std::ranges::all_of(digest, hexadecimal) ? digest : std::string_view{};
}

enum class SceneCopies : std::uint8_t {
  none,       ///< neither end holds a scene, or the other end is not there
  same,       ///< both hold the same
  different,  ///< each holds one, and they are not the same
  only_here,  ///< the other end does not say that it holds one
  only_there,
};
/// For programs.
inline constexpr std::array<std::string_view, 5> kSceneCopies = {"none", "same", "different", "only here",
                                                                 "only there"};
/// For people.
[[nodiscard]] constexpr std::string_view toString(SceneCopies copies) {
  switch (copies) {
    case SceneCopies::none: return sentence("no scene is shared");
    case SceneCopies::same: return sentence("both ends hold the same scene");
    case SceneCopies::different: return sentence("the two ends hold different scenes: open copies of one file");
    case SceneCopies::only_here: return sentence("the other end does not say that it holds this scene");
    case SceneCopies::only_there: return sentence("the other end holds a scene, this one none");
  }
  return "";
}
[[nodiscard]] constexpr bool isWrong(SceneCopies copies) {
  return copies != SceneCopies::none && copies != SceneCopies::same;
}
[[nodiscard]] inline SceneCopies compareScenes(std::string_view here, std::string_view there) {
  if (here.empty() && there.empty()) return SceneCopies::none;
  if (there.empty()) return SceneCopies::only_here;
  if (here.empty()) return SceneCopies::only_there;
  return here == there ? SceneCopies::same : SceneCopies::different;
}

}  // namespace fyd::protocol
