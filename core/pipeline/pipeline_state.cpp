// The whole state of a pipeline as bytes, and back: a seal that says what the bytes are, the parameters, then the
// members that change between steps. Each class names its own (core/base/state.h); here stands the step's list.
#include <bit>
#include <sstream>

#include <sodium/crypto_generichash.h>

#include "core/base/archive.h"
#include "core/pipeline/pipeline.h"

namespace fyd::pipeline {
namespace {

/// Raised whenever a class changes what its `serialize` names.
constexpr std::uint32_t kLayout = 1;

using Digest = std::array<std::uint8_t, crypto_generichash_BYTES_MIN>;

Digest digestOf(std::string_view text) {
  Digest digest{};
  crypto_generichash(digest.data(), digest.size(), reinterpret_cast<const unsigned char*>(text.data()), text.size(),
                     nullptr, 0);
  return digest;
}

/// Stands in front: who wrote the bytes, for which pipeline, and whether they are whole.
struct Seal {
  std::array<char, 8> mark{'F', 'Y', 'D', 's', 't', 'a', 't', 'e'};
  Digest program{};
  Digest surface{};
  Digest content{};
  std::uint64_t content_bytes = 0;

  static constexpr std::size_t kBytes = 8 + 3 * sizeof(Digest) + 8;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(mark, program, surface, content, content_bytes);
  }
};

Seal sealOf(std::span<const Parameter> parameters, const std::optional<texture::VirtualTexture>& surface) {
  std::string program = fmt::format("{} {} {}", FYD_VERSION, kLayout, sizeof(Pipeline));
  for (const Parameter& p : parameters) program += fmt::format(" {}:{}", p.id, static_cast<int>(p.kind));
  return {.program = digestOf(program), .surface = digestOf(surface ? formatSurface(surface->model()) : "")};
}

template <class... Items>
std::string write(const Items&... items) {
  std::ostringstream bytes;
  StateWriter archive(bytes);
  archive(items...);
  return std::move(bytes).str();
}

void writeParameters(StateWriter& archive, std::span<const Parameter> parameters) {
  for (const Parameter& p : parameters) {
    if (p.kind == ParameterKind::list) {
      archive(p.list());
    } else {
      archive(p.value());
    }
  }
}

/// A live parameter takes any value in its range; another must be the one this pipeline was made with.
Result<void> takeValue(const Parameter& parameter, double own, double saved) {
  if (std::bit_cast<std::uint64_t>(own) == std::bit_cast<std::uint64_t>(saved)) return {};
  if (!parameter.info.live) {
    return fail("{} was {} when the state was saved, here it is {}; expected the same", parameter.id, saved, own);
  }
  return checkParameter(parameter, saved).map([](double) {});
}

Result<void> readParameters(StateReader& archive, std::span<const Parameter> parameters) {
  for (const Parameter& p : parameters) {
    if (p.kind != ParameterKind::list) {
      double saved = 0.0;
      archive(saved);
      if (auto taken = takeValue(p, p.value(), saved); !taken) return taken;
      p.set(saved);
      continue;
    }
    ParameterList saved;
    archive(saved);
    if (!p.info.live && saved.count != p.list().count) {
      return fail("{} had {} values when the state was saved, here it has {}; expected the same", p.id, saved.count,
                  p.list().count);
    }
    for (std::size_t i = 0; i < saved.size(); ++i) {
      if (auto taken = takeValue(p, p.list()[i], saved[i]); !taken) return taken;
    }
    p.list() = saved;
  }
  return {};
}

/// The content behind a seal that fits `own`.
Result<std::string_view> openSeal(std::string_view state, const Seal& own) {
  Seal seal;
  if (state.size() < Seal::kBytes) return fail("state of {} bytes: expected at least {}", state.size(), Seal::kBytes);
  std::istringstream stream{std::string(state.substr(0, Seal::kBytes))};
  StateReader archive(stream);
  archive(seal);
  const std::string_view content = state.substr(Seal::kBytes);
  if (seal.mark != own.mark) return fail("these {} bytes are not the state of a pipeline", state.size());
  if (seal.content_bytes != content.size()) {
    return fail("state with {} bytes of content: expected {}", content.size(), seal.content_bytes);
  }
  if (seal.content != digestOf(content)) return fail("state of {} bytes: damaged", state.size());
  if (seal.program != own.program) return fail("state saved by another version; expected {}", FYD_VERSION);
  if (seal.surface != own.surface) return fail("state saved with another surface; expected the same");
  return content;
}

}  // namespace

template <class Archive>
void Pipeline::serialize(Archive& archive) {
  archive(indentation_, stiffness_, tare_, controller_, mixing_, renderer_, finger_speed_, health_, safety_, motion_);
  if (surface_) archive(*surface_);
  archive(started_, last_now_, steps_, missed_at_second_start_, second_start_, last_finger_, last_bridge_,
          within(last_phase_, LinkPhase::lost), target_by_hand_, target_was_clamped_, robot_sets_reference_,
          stretch_deg_, translation_deg_, newest_acceleration_g_, force_N_, outputs_.tare);
}

std::string Pipeline::saveState() const {
  std::ostringstream bytes;
  StateWriter archive(bytes);
  writeParameters(archive, bound_);
  archive(*this);
  const std::string content = std::move(bytes).str();
  Seal seal = sealOf(bound_, surface_);
  seal.content = digestOf(content);
  seal.content_bytes = content.size();
  return write(seal) + content;
}

Result<void> Pipeline::restoreState(std::string_view state) {
  const auto content = openSeal(state, sealOf(bound_, surface_));
  if (!content) return tl::unexpected(content.error());
  const Parameters old_parameters = parameters_;
  const std::string old_state = write(*this);
  const auto takeParameters = [this](const Parameters& parameters) {
    parameters_ = parameters;
    configure();
  };
  try {
    std::istringstream stream{std::string(*content)};
    StateReader archive(stream);
    Parameters parameters = parameters_;
    if (auto read = readParameters(archive, bindParameters(parameters)); !read) return read;
    takeParameters(parameters);
    archive(*this);
    if (stream.peek() == std::istringstream::traits_type::eof()) return {};
    throw std::out_of_range("more content than a state has");
  } catch (const std::exception& problem) {
    takeParameters(old_parameters);
    std::istringstream stream{old_state};
    StateReader archive(stream);
    archive(*this);
    return fail("state of {} bytes: {}", state.size(), problem.what());
  }
}

}  // namespace fyd::pipeline
