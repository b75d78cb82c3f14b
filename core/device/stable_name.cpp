#include "core/device/stable_name.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <vector>

#include <fmt/ranges.h>

namespace fyd::device {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPrefix = "id=";
constexpr std::string_view kVideo = "-video-index";

bool isLetterOrDigit(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

/// 42 is in "Board_42-if00" and not in "Board_142".
bool containsWord(std::string_view name, std::string_view word) {
  for (std::size_t at = name.find(word); at != std::string_view::npos; at = name.find(word, at + 1)) {
    const std::size_t after = at + word.size();
    const bool begins = at == 0 || !isLetterOrDigit(name[at - 1]) || !isLetterOrDigit(word.front());
    const bool ends = after == name.size() || !isLetterOrDigit(name[after]) || !isLetterOrDigit(word.back());
    if (begins && ends) return true;
  }
  return false;
}

}  // namespace

Result<std::string> resolveDevice(const std::string& text, std::string_view folder) {
  if (!text.starts_with(kPrefix)) return text;
  const std::string_view id = std::string_view(text).substr(kPrefix.size());
  if (id.empty()) return fail("'{}': expected id=SERIAL, as it stands in {}", text, folder);
  std::vector<std::string> all;
  std::vector<std::string> fitting;
  std::error_code problem;
  for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end; entry.increment(problem)) {
    const std::string name = entry->path().filename().string();
    all.push_back(name);
    const bool other_node = name.find(kVideo) != std::string::npos && !name.ends_with("-video-index0") &&
                            id.find(kVideo) == std::string_view::npos;
    if (!other_node && containsWord(name, id)) fitting.push_back(entry->path().string());
  }
  if (fitting.size() == 1) return fitting.front();
  std::ranges::sort(all);
  std::ranges::sort(fitting);
  if (fitting.empty()) {
    return fail("device {}: none is plugged in; {} holds {}", text, folder,
                all.empty() ? say("nothing") : verbatim(fmt::format("{}", fmt::join(all, ", "))));
  }
  return fail("device {}: {} fit: {}; name more of the one that is meant", text, fitting.size(),
              fmt::join(fitting, ", "));
}

std::string withoutSecrets(std::string_view source) {
  const auto scheme = source.find("://");
  if (scheme == std::string_view::npos) return std::string(source);
  const auto host = scheme + 3;
  const auto at = source.substr(host, source.find_first_of("/?#", host) - host).rfind('@');
  if (at == std::string_view::npos) return std::string(source);
  return std::string(source.substr(0, host)) + std::string(source.substr(host + at + 1));
}

}  // namespace fyd::device
