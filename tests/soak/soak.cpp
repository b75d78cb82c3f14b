// Sessions in virtual time, one after the other, as fast as the machine computes them, with faults of every simulator at
// once at random moments: the touchpad over Modbus, its motor board, its camera, the robot and the network to it, the
// recorder's disk, and a late loop. It ends with exit code 1 at the first thing that does not hold:
//
//   no number beyond its limits, no NaN; nothing commanded moves outside Active; only an operator's arm leads into Active
//   and only an operator out of Held and Stopped; a fault that takes something needed ends Active in time; the
//   simulated firmware's motors are off without a living command; the arm rests when the touchpad is not Active; each
//   recording opens and is verified, that of a failed disk after its recovery; the recorder's second pipeline computes
//   the same; nothing hangs; neither memory nor open files grow.
//
//   soak [SECONDS [SEED [SESSION]]]     of the machine's time, from this session on; the hour: soak 3600 1
#include "tests/soak/soak.h"

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include <spdlog/spdlog.h>

#include "tests/soak/soak_session.h"
#include "tests/temporary_folder.h"

namespace fyd::soak {
namespace {

std::atomic<std::uint64_t> the_session{0};
std::atomic<double> the_time_s{0.0};

using Steady = std::chrono::steady_clock;
constexpr std::chrono::seconds kLongestSilence{120};  // of a machine that is busy with other things, too
constexpr std::uint64_t kWarmUp = 10;                 // sessions until memory is compared
constexpr double kMostGrowth_MB = 100.0;
// From so many sessions on, nothing was tried only if something is wrong. A session begins some 11 faults: 4.6 of the
// touchpad, 2.3 of the camera, 1.5 of the robot, 0.6 of the disk, 2.3 late loops. What a session has 0.6 times has not come
// once in 20 with a chance of e^-12, and the rarest kind of fault (a storm of one protocol, 0.09) in 300 with e^-25.
constexpr std::uint64_t kSomeOfAll = 20;
constexpr std::uint64_t kAllKinds = 300;

double memory_MB() {
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("VmRSS:")) return std::strtod(line.c_str() + 6, nullptr) / 1024.0;
  }
  return 0.0;
}

std::size_t openFiles() {
  std::size_t out = 0;
  for ([[maybe_unused]] const auto& each : std::filesystem::directory_iterator("/proc/self/fd")) ++out;
  return out;
}

void print(const Figures& figures, double seconds) {
  const double session_h = static_cast<double>(figures.steps) / 3.6e6;
  std::printf("%.0f s: %llu sessions of %.2f h together, %.0f %% of it Active, %llu arms, %llu refused\n", seconds,
              static_cast<unsigned long long>(figures.sessions), session_h,
              100.0 * static_cast<double>(figures.active_steps) /
                  static_cast<double>(std::max<std::uint64_t>(1, figures.steps)),
              static_cast<unsigned long long>(figures.arms), static_cast<unsigned long long>(figures.refused_arms));
  std::printf("%llu recordings whole, %llu recovered after their disk failed, %llu steps in them\n",
              static_cast<unsigned long long>(figures.recordings),
              static_cast<unsigned long long>(figures.failed_recordings),
              static_cast<unsigned long long>(figures.recorded_steps));
  std::printf("%llu faults had to end Active by a time, and had\n",
              static_cast<unsigned long long>(figures.checked_deadlines));
  std::printf("the arm crept %.3f mm at most, from 2.5 s after the end of Active on\n", figures.largest_creep_mm);
  std::uint64_t all = 0;
  for (const auto& [name, count] : figures.faults) {
    std::printf("  fault %-55s %llu\n", name.c_str(), static_cast<unsigned long long>(count));
    all += count;
  }
  for (const auto& [name, count] : figures.held) {
    std::printf("  Held  %-55s %llu\n", name.c_str(), static_cast<unsigned long long>(count));
  }
  std::printf("%llu faults; %.0f MB, %zu open files\n", static_cast<unsigned long long>(all), memory_MB(), openFiles());
  std::fflush(stdout);
}

/// A run that tried nothing would hold everything, too.
void expectTried(const Figures& figures) {
  if (figures.sessions >= 5 && figures.active_steps * 10 < figures.steps) {
    broken("less than a tenth was Active: it proves little");
  }
  if (figures.sessions < kSomeOfAll) return;
  std::map<std::string, std::uint64_t> tried = {{"checked deadlines", figures.checked_deadlines},
                                                {"recordings", figures.recordings},
                                                {"refused arms", figures.refused_arms}};
  for (const auto& [name, count] : figures.faults) {
    tried["faults of the " + name.substr(0, name.find(' '))] += count;
    if (figures.sessions >= kAllKinds) tried["faults '" + name + "'"] = count;
  }
  for (const auto& [what, count] : tried) {
    if (count == 0) broken(fmt::format("no {} in {} sessions: it proves little", what, figures.sessions));
  }
}

}  // namespace

void at(std::uint64_t session, double seconds) {
  the_session = session;
  the_time_s = seconds;
}

void broken(const std::string& what) {
  std::printf("BROKEN in session %llu at %.3f s: %s\n", static_cast<unsigned long long>(the_session.load()),
              the_time_s.load(), what.c_str());
  std::fflush(stdout);
  std::_Exit(1);
}

}  // namespace fyd::soak

int main(int argc, char** argv) {
  using namespace fyd::soak;
  const double seconds = argc > 1 ? std::atof(argv[1]) : 30.0;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  const std::uint64_t first = argc > 3 ? std::max(1ULL, std::strtoull(argv[3], nullptr, 10)) : 1;
  if (!(seconds > 0.0)) {
    std::fprintf(stderr, "soak: SECONDS is '%s', expected a number above 0\n", argv[1]);
    return 2;
  }
  spdlog::set_level(spdlog::level::off);  // it logs each failed disk, as it should
  const std::jthread watch([](const std::stop_token& stop) {
    double last = -1.0;
    std::uint64_t session = 0;
    for (auto since = Steady::now(); !stop.stop_requested();
         std::this_thread::sleep_for(std::chrono::milliseconds(200))) {
      if (the_time_s != last || the_session != session) since = Steady::now();
      last = the_time_s;
      session = the_session;
      if (Steady::now() - since > kLongestSilence) broken("it hangs");
    }
  });
  const auto began = Steady::now();
  const auto passed = [&] { return std::chrono::duration<double>(Steady::now() - began).count(); };
  Figures figures;
  nameFaults(figures);
  double first_MB = 0.0;
  std::size_t first_files = 0;
  double told = 0.0;
  for (std::uint64_t number = first; passed() < seconds; ++number) {
    Chance chance(seed * 1'000'003 + number);  // each session can be run again alone
    const fyd::Folder folder;
    runSession(number, chance, folder.path(), figures);
    if (number == first) first_files = openFiles();
    if (openFiles() > first_files)
      broken(fmt::format("{} files are open, {} after the first session", openFiles(), first_files));
    if (number == first + kWarmUp) first_MB = memory_MB();
    if (number > first + kWarmUp && memory_MB() > first_MB + kMostGrowth_MB) {
      broken(fmt::format("{:.0f} MB, {:.0f} MB after {} sessions", memory_MB(), first_MB, kWarmUp));
    }
    if (passed() > told + 300.0) {
      told = passed();
      print(figures, told);
    }
  }
  print(figures, passed());
  expectTried(figures);
  std::printf("seed %llu: everything held\n", static_cast<unsigned long long>(seed));
  return 0;
}
