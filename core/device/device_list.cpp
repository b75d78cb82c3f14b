#include "core/device/device_list.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>

#include <unistd.h>

#include "core/device/serial_port.h"

namespace fyd::device {
namespace {

namespace fs = std::filesystem;

Message problemOf(const std::string& path) {
  return ::access(path.c_str(), R_OK | W_OK) == 0 ? Message{} : explainPort(path, errno);
}

std::vector<std::string> filesIn(const std::string& folder) {
  std::vector<std::string> out;
  std::error_code problem;
  for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end; entry.increment(problem)) {
    out.push_back(entry->path().string());
  }
  std::ranges::sort(out);
  return out;
}

bool isNode(const std::string& path, std::span<const std::string_view> prefixes) {
  const std::string name = fs::path(path).filename().string();
  return std::ranges::any_of(prefixes, [&](std::string_view prefix) { return name.starts_with(prefix); });
}

/// Stable names first; nodes that have none after them.
std::vector<FoundDevice> find(const std::string& dev, const std::string& by_id,
                              std::span<const std::string_view> prefixes) {
  std::vector<FoundDevice> out;
  for (const std::string& link : filesIn(dev + by_id)) {
    std::error_code problem;
    const fs::path node = fs::canonical(link, problem);
    if (problem) continue;  // unplugged in the meantime
    out.push_back({.path = link, .node = node.string(), .name = fs::path(link).filename().string(), .problem = {}});
  }
  for (const std::string& node : filesIn(dev)) {
    const bool known = std::ranges::any_of(out, [&](const FoundDevice& found) { return found.node == node; });
    if (!known && isNode(node, prefixes)) out.push_back({.path = node, .node = node, .name = {}, .problem = {}});
  }
  for (FoundDevice& found : out) found.problem = problemOf(found.node);
  return out;
}

}  // namespace

std::vector<FoundDevice> findSerialPorts(const std::string& dev) {
  static constexpr std::array<std::string_view, 4> kPrefixes = {"ttyUSB", "ttyACM", "ttyAMA", "fyd-"};
  return find(dev, "/serial/by-id", kPrefixes);
}

std::vector<FoundDevice> findCaptureDevices(const std::string& dev) {
  static constexpr std::array<std::string_view, 1> kPrefixes = {"video"};
  std::vector<FoundDevice> out = find(dev, "/v4l/by-id", kPrefixes);
  for (FoundDevice& found : out) {
    if (!found.name.empty()) continue;
    std::ifstream file("/sys/class/video4linux/" + fs::path(found.node).filename().string() + "/name");
    std::getline(file, found.name);
  }
  return out;
}

}  // namespace fyd::device
