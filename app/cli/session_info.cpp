// fyd session info FILE: what a recording is and holds.
#include "app/cli/session_cli.h"
#include "core/session/catalogue_types.h"

namespace fyd::cli {
namespace {

/// In a word, and why: what an operator wants to know of a file before trusting it.
std::pair<std::string, std::string> healthOf(const session::RecordingInfo& info) {
  if (info.wholeness == session::Wholeness::crashed) {
    return {"damaged", "its recorder is gone; make it whole with: fyd session recover"};
  }
  if (info.gaps > 0) return {"gaps", fmt::format("{} steps were lost while recording", info.gaps)};
  if (info.samples != info.committed_samples) {
    return {"growing", fmt::format("{} steps are not committed yet", info.samples - info.committed_samples)};
  }
  return {info.wholeness == session::Wholeness::growing ? "growing" : "good", ""};
}

nlohmann::ordered_json describe(const std::string& path, const session::Recording& recording) {
  const session::RecordingInfo& info = recording.info();
  const auto [health, why] = healthOf(info);
  const auto notes = valueOrFail(recording.notes());
  nlohmann::ordered_json out;
  out["path"] = path;
  out["duration_s"] = info.duration_s;
  out["samples"] = info.samples;
  out["committed_samples"] = info.committed_samples;
  out["frames"] = info.frames;
  out["gaps"] = info.gaps;
  out["events"] = info.events;
  out["health"] = health;
  out["health_reason"] = why;
  out["wholeness"] = session::toString(info.wholeness);
  out["bytes"] = info.bytes;
  out["id"] = info.header.id;
  out["started_utc"] = info.header.started_utc;
  out["operator"] = info.header.operator_name;
  out["subject"] = info.header.subject;
  out["notes"] = info.header.notes;
  out["tags"] = info.header.tags;
  out["touchpad"] = info.header.touchpad;
  out["camera"] = info.header.camera;
  out["robot"] = info.header.robot;
  out["version"] = info.header.version;
  out["replayable"] = !info.header.step_state.empty();
  out["log"] = nlohmann::ordered_json::array();
  for (const session::Note& note : notes) {
    static constexpr std::array<std::string_view, 5> kKinds{"note", "bookmark", "trial start", "trial end", "alarm"};
    const auto kind = static_cast<std::size_t>(note.kind);
    out["log"].push_back({{"time_s", secondsInto(info, note.when)},
                          {"kind", kind < kKinds.size() ? kKinds[kind] : "unknown"},
                          {"text", note.text}});
  }
  out["surface"] = info.header.surface;
  out["profile"] = info.header.profile;
  return out;
}

}  // namespace

void addSessionInfo(CLI::App& parent) {
  auto options = std::make_shared<SessionOptions>();
  CLI::App* command = parent.add_subcommand("info", "What a recording is and holds");
  addSessionOptions(*command, *options);
  command->callback([options] {
    auto json = describe(options->file, *openRecording(options->file));
    if (!options->json) {  // texts of many lines are for --json
      json.erase("profile");
      json.erase("surface");
    }
    printSession(json, options->json);
  });
}

}  // namespace fyd::cli
