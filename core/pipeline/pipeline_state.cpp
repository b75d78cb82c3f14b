// The whole state of a pipeline as bytes, and back: parameters by their ids, then the modules that change between
// steps, each with a version of its own. Each class names its members itself (core/base/state.h); the list of modules
// is here.
#include <algorithm>
#include <bit>
#include <sstream>
#include <vector>

#include "core/pipeline/pipeline.h"
#include "core/pipeline/state_format.h"
#include "core/scene/felt_scene.h"

namespace fyd::pipeline {
namespace {

Digest digestOfLocalModel(const std::optional<texture::VirtualTexture>& surface, const scene::FeltScene* scene) {
  std::string text = surface ? formatSurface(surface->model()) : "";
  if (scene != nullptr) text += scene->digestOfState();
  return digestOf(text);
}

/// A class whose saved content has changed says `kStateVersion` and reads older content in `restore(archive, version)`.
template <class Module>
consteval std::uint16_t stateVersion() {
  if constexpr (requires { Module::kStateVersion; }) {
    return Module::kStateVersion;
  } else {
    return 1;
  }
}

template <class Module>
void readModule(StateReader& archive, Module& module, std::uint16_t version) {
  if constexpr (stateVersion<Module>() > 1) {
    if (version < stateVersion<Module>()) return module.restore(archive, version);
  }
  archive(module);
}

void writeParameters(StateWriter& archive, std::span<const Parameter> parameters) {
  archive(static_cast<std::uint16_t>(parameters.size()));
  for (const Parameter& p : parameters) {
    writeText(archive, p.id);
    if (p.kind == ParameterKind::list) {
      archive(static_cast<std::uint8_t>(p.list().size()));
      for (const double value : p.list()) archive(value);
    } else if (p.kind == ParameterKind::choice) {
      archive(kWordFollows);
      writeText(archive, formatParameter(p));
    } else {
      archive(std::uint8_t{1}, p.value());
    }
  }
}

/// A live parameter may take any value it could have been set to; any other must have the value this pipeline was made
/// with. Earlier versions saved a -0 where the profile beside it says 0.
Result<void> takeValue(const Parameter& parameter, double own, double saved) {
  if (own == saved || std::bit_cast<std::uint64_t>(own) == std::bit_cast<std::uint64_t>(saved)) return {};
  if (!parameter.info.live) {
    return fail("{} was {} when the state was saved, here it is {}; expected the same", parameter.id, saved, own);
  }
  return checkParameter(parameter, saved, Ranges::mark).map([](double) {});
}

Result<void> takeList(const Parameter& parameter, const ParameterList& saved) {
  if (!parameter.info.live && saved.count != parameter.list().count) {
    return fail("{} had {} values when the state was saved, here it has {}; expected the same", parameter.id,
                saved.count, parameter.list().count);
  }
  for (std::size_t i = 0; i < saved.size(); ++i) {
    if (auto taken = takeValue(parameter, parameter.list()[i], saved[i]); !taken) return taken;
  }
  parameter.list() = saved;
  return {};
}

Result<void> takeWord(const Parameter& parameter, const std::string& word) {
  const double own = parameter.value();
  if (auto assigned = assignParameter(parameter, word); !assigned) return assigned;
  const double saved = parameter.value();
  parameter.set(own);
  if (auto taken = takeValue(parameter, own, saved); !taken) return taken;
  parameter.set(saved);
  return {};
}

/// Parameters that the state does not name keep their value.
Result<void> readParameters(StateReader& archive, std::span<const Parameter> parameters) {
  std::uint16_t count = 0;
  archive(count);
  for (std::uint16_t k = 0; k < count; ++k) {
    const std::string id = readText(archive);
    const Parameter* parameter = findParameter(parameters, id);
    if (parameter == nullptr) return fail("'{}' is no parameter of this program's step", id);
    std::uint8_t values = 0;
    archive(values);
    if ((values == kWordFollows) != (parameter->kind == ParameterKind::choice) ||
        (values != kWordFollows && parameter->kind != ParameterKind::list && values != 1)) {
      return fail("{} is another kind of parameter in this program", id);
    }
    Result<void> taken;
    if (values == kWordFollows) {
      taken = takeWord(*parameter, readText(archive));
    } else if (parameter->kind == ParameterKind::list) {
      ParameterList saved;
      for (std::uint8_t i = 0; i < values; ++i) {
        double value = 0.0;
        archive(value);
        if (!saved.push(value)) return fail("{}: {} values; expected at most {}", id, values, saved.capacity());
      }
      taken = takeList(*parameter, saved);
    } else {
      double saved = 0.0;
      archive(saved);
      taken = takeValue(*parameter, parameter->value(), saved);
      if (taken) parameter->set(saved);
    }
    if (!taken) return taken;
  }
  return {};
}

/// Checks the header, also against this local model, and returns the content behind it.
Result<std::string_view> checkedContent(std::string_view state, const Digest& local_model) {
  StateHeader header;
  const std::array<char, 8> own_mark = header.mark;
  if (state.size() < StateHeader::kBytes) {
    return fail("state of {} bytes: expected at least {}", state.size(), StateHeader::kBytes);
  }
  std::istringstream stream{std::string(state.substr(0, StateHeader::kBytes))};
  StateReader archive(stream);
  archive(header);
  const std::string_view content = state.substr(StateHeader::kBytes);
  if (header.mark != own_mark) return fail("these {} bytes are not the state of a pipeline", state.size());
  if (header.content_bytes != content.size()) {
    return fail("state with {} bytes of content: expected {}", content.size(), header.content_bytes);
  }
  if (header.content != digestOf(content)) return fail("state of {} bytes: damaged", state.size());
  if (header.local_model != local_model) return fail("state saved with another surface or scene; expected the same");
  return content;
}

}  // namespace

/// What changes between steps and belongs to no module.
struct Pipeline::Between {
  Pipeline& p;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(p.started_, p.last_now_, p.steps_, p.missed_at_second_start_, p.second_start_, p.last_finger_,
            p.last_bridge_, within(p.last_phase_, LinkPhase::lost), p.target_by_hand_, p.target_was_clamped_,
            p.robot_sets_reference_, p.stretch_deg_, p.translation_deg_, p.newest_acceleration_g_, p.force_N_,
            p.outputs_.tare);
  }
};

template <class Visit>
void Pipeline::eachModule(Visit&& visit) {
  visit("indentation", indentation_);
  visit("stiffness", stiffness_);
  visit("tare", tare_);
  visit("coupling", coupling_);
  visit("controller", controller_);
  visit("mixing", mixing_);
  visit("renderer", renderer_);
  visit("finger_speed", finger_speed_);
  visit("finger_prediction", finger_prediction_);
  visit("health", health_);
  visit("safety", safety_);
  visit("motion", motion_);
  if (surface_) visit("surface", *surface_);
  if (scene_) visit("scene", *scene_);
  Between between{*this};
  visit("step", between);
}

std::string Pipeline::saveModules() {
  std::ostringstream bytes;
  StateWriter archive(bytes);
  std::uint16_t count = 0;
  eachModule([&count](const char*, auto&) { ++count; });
  archive(count);
  eachModule([&archive]<class Module>(const char* name, Module&) {
    writeText(archive, name);
    archive(stateVersion<Module>());
  });
  eachModule([&archive](const char*, auto& module) { archive(module); });
  return std::move(bytes).str();
}

void Pipeline::restoreModules(std::istream& bytes) {
  StateReader archive(bytes);
  std::uint16_t count = 0;
  archive(count);
  std::vector<std::pair<std::string, std::uint16_t>> saved;
  for (std::uint16_t i = 0; i < count; ++i) {
    std::string name = readText(archive);
    std::uint16_t version = 0;
    archive(version);
    if (std::ranges::any_of(saved, [&name](const auto& other) { return other.first == name; })) {
      throw std::out_of_range(fmt::format("the module '{}' twice", name));
    }
    saved.emplace_back(std::move(name), version);
  }
  for (const auto& [name, version] : saved) {
    bool known = false;
    eachModule([&, &name = name, version = version]<class Module>(const char* own, Module& module) {
      if (name != own) return;
      known = true;
      if (version == 0 || version > stateVersion<Module>()) {
        throw std::out_of_range(fmt::format("version {} of the module '{}'; this program knows 1 to {}", version, name,
                                            stateVersion<Module>()));
      }
      readModule(archive, module, version);
    });
    if (!known) throw std::out_of_range(fmt::format("'{}' is no module of this program's step", name));
  }
  if (bytes.peek() != std::istream::traits_type::eof()) throw std::out_of_range("more content than a state has");
}

std::string Pipeline::saveState() const {
  std::ostringstream bytes;
  StateWriter archive(bytes);
  writeParameters(archive, bound_);
  // saveModules only reads; it is not const because saving and restoring share one list of members.
  return withHeader(digestOfLocalModel(surface_, scene_.get()),
                    std::move(bytes).str() + const_cast<Pipeline*>(this)->saveModules());
}

Result<void> Pipeline::restoreState(std::string_view state) {
  const auto content = checkedContent(state, digestOfLocalModel(surface_, scene_.get()));
  if (!content) return tl::unexpected(content.error());
  const Parameters old_parameters = parameters_;
  const std::string old_modules = saveModules();
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
    restoreModules(stream);
    return {};
  } catch (const std::exception& problem) {
    takeParameters(old_parameters);
    std::istringstream stream{old_modules};
    restoreModules(stream);
    return fail("state of {} bytes: {}", state.size(), verbatim(problem.what()));
  }
}

}  // namespace fyd::pipeline
