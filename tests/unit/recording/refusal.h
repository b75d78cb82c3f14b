// What a call that failed says, and what it leaves in its folder.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace fyd::recording {

/// Empty when it did not fail.
inline std::string refusal(const Result<void>& done) { return done ? "" : done.error().text(); }

/// Sorted.
inline std::vector<std::string> namesIn(const std::filesystem::path& folder) {
  std::vector<std::string> out;
  for (const auto& each : std::filesystem::directory_iterator(folder)) out.push_back(each.path().filename().string());
  std::ranges::sort(out);
  return out;
}

}  // namespace fyd::recording
