#include "app/bench/parts/machine.h"

#include <sys/utsname.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "revision.inc"

namespace fyd::bench {
namespace {

/// What stands behind the colon of the first line that begins with `name`.
std::string lineOf(const char* path, const std::string& name) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(':');
    if (!line.starts_with(name) || colon == std::string::npos) continue;
    const std::size_t begin = line.find_first_not_of(" \t", colon + 1);
    return begin == std::string::npos ? std::string() : line.substr(begin);
  }
  return "unknown";
}

std::string memory() {
  const double kB = std::strtod(lineOf("/proc/meminfo", "MemTotal").c_str(), nullptr);
  return kB > 0.0 ? fmt::format("{:.1f} GB", 1.024e-6 * kB) : "unknown";
}

std::string system() {
  utsname name{};
  return ::uname(&name) == 0 ? fmt::format("{} {} {}", name.sysname, name.release, name.machine) : "unknown";
}

constexpr double kIdle = 0.25;  // programs at work for each core, at most

std::string load() {
  double minute = 0.0;
  if (::getloadavg(&minute, 1) != 1) return "unknown";
  const bool idle = minute <= kIdle * std::thread::hardware_concurrency();
  return fmt::format("{:.1f} programs at the beginning{}", minute,
                     idle ? "" : ": the machine was not idle, and the times are longer for it");
}

}  // namespace

std::vector<Fact> factsOfThisRun() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return {{"date", fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(now))},
          {"processor", lineOf("/proc/cpuinfo", "model name")},
          {"cores", std::to_string(std::thread::hardware_concurrency())},
          {"memory", memory()},
          {"others at work", load()},
          {"system", system()},
          {"version", "FYD Console " FYD_VERSION},
          {"revision", FYD_REVISION},
          {"compiler", FYD_BENCH_COMPILER},
          {"build type", FYD_BENCH_BUILD_TYPE},
          {"flags", FYD_BENCH_FLAGS}};
}

}  // namespace fyd::bench
