#include "core/pipeline/state_of_arithmetic_1.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "core/base/batch.h"
#include "core/base/parameter.h"
#include "core/pipeline/state_format.h"

namespace fyd::pipeline {
namespace {

constexpr std::string_view kMark = "FYDstate";
/// Digest of version, parameters and layout that revision a4d2b6a wrote into its states.
constexpr Digest kProgram{0x05, 0xee, 0xc1, 0x48, 0x11, 0xfb, 0xd2, 0xaa,
                          0xab, 0x63, 0x45, 0x54, 0xdf, 0x01, 0x42, 0x2e};
constexpr std::size_t kSealBytes = 64;  // mark, program, surface, content, u64 content's length
constexpr std::array<std::string_view, 4> kModulePrefixes{"pipeline.", "sensing.", "control.", "texture."};
constexpr std::array<std::string_view, 10> kModules{"indentation", "stiffness",    "tare",   "controller", "mixing",
                                                    "renderer",    "finger_speed", "health", "safety",     "motion"};

template <std::size_t N>
std::array<std::uint8_t, N> bytesAt(std::string_view state, std::size_t offset) {
  std::array<std::uint8_t, N> out{};
  std::copy_n(state.begin() + static_cast<std::ptrdiff_t>(offset), N, out.begin());
  return out;
}

void convertParameter(StateReader& from, StateWriter& to, const ProfileEntry& entry) {
  writeText(to, entry.id);
  if (entry.list) {
    ParameterList values;
    from(values);
    to(static_cast<std::uint8_t>(values.size()));
    for (const double value : values) to(value);
    return;
  }
  double value = 0.0;
  from(value);
  if (entry.choices.empty()) {
    to(std::uint8_t{1}, value);
    return;
  }
  if (!(value >= 0.0 && value < static_cast<double>(entry.choices.size()))) {
    throw std::out_of_range(fmt::format("choice {} of {}", value, entry.id));
  }
  to(kWordFollows);
  writeText(to, entry.choices[static_cast<std::size_t>(value)]);
}

}  // namespace

bool isStateOfArithmetic1(std::string_view state) { return state.starts_with(kMark); }

Result<std::string> convertStateOfArithmetic1(std::string_view state, std::span<const ProfileEntry> listed) {
  if (!isStateOfArithmetic1(state) || state.size() < kSealBytes) {
    return fail("these {} bytes are not a state of arithmetic 1", state.size());
  }
  if (bytesAt<16>(state, 8) != kProgram) return fail("a state of a program before revision a4d2b6a");
  const auto surface = bytesAt<16>(state, 24);
  const std::string_view content = state.substr(kSealBytes);
  if (bytesAt<16>(state, 40) != digestOf(content)) return fail("state of {} bytes: damaged", state.size());
  const auto steps = std::ranges::find_if_not(listed, [](const ProfileEntry& entry) {
    return std::ranges::any_of(kModulePrefixes, [&](std::string_view room) { return entry.id.starts_with(room); });
  });
  const std::span<const ProfileEntry> parameters{listed.begin(), steps};
  try {
    std::istringstream in{std::string(content)};
    StateReader from(in);
    std::ostringstream out;
    StateWriter to(out);
    to(static_cast<std::uint16_t>(parameters.size()));
    for (const ProfileEntry& entry : parameters) convertParameter(from, to, entry);
    const bool has_surface = surface != digestOf("");
    to(static_cast<std::uint16_t>(kModules.size() + (has_surface ? 2 : 1)));
    const auto name = [&to](std::string_view module) {
      writeText(to, module);
      to(std::uint16_t{1});
    };
    for (const std::string_view module : kModules) name(module);
    if (has_surface) name("surface");
    name("step");
    return withHeader(surface, std::move(out).str().append(content.substr(static_cast<std::size_t>(in.tellg()))));
  } catch (const std::exception& problem) {
    return fail("state of {} bytes: {}", state.size(), verbatim(problem.what()));
  }
}

}  // namespace fyd::pipeline
