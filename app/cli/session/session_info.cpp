// fyd session info FILE: what a recording is and holds.
#include "app/cli/session/session_cli.h"
#include "core/catalogue/catalogue_types.h"
#include "core/recording/reader/recording_health.h"

namespace fyd::cli {
namespace {

nlohmann::ordered_json describe(const std::string& path, const recording::Recording& recording) {
  const recording::RecordingInfo& info = recording.info();
  auto [health, why] = recording::healthOf(info);
  if (health == "good") why = say("as far as opening it shows; fyd session verify reads every block");
  const auto notes = recording.notes();
  if (!notes) std::tie(health, why) = std::pair("damaged", notes.error().message);
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
  out["wholeness"] = catalogue::toString(info.wholeness);
  out["missing"] = nlohmann::ordered_json::array();
  for (const recording::MissingRows& rows : info.header.missing)
    out["missing"].push_back({{"table", rows.table},
                              {"first", rows.first},
                              {"count", rows.count},
                              {"why", rows.why},
                              {"words", recording::wordsOf(rows)}});
  out["lacking_columns"] = info.missing_columns;
  out["unknown_columns"] = info.unknown_columns;
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
  out["lateness"] = info.header.lateness;
  out["version"] = info.header.version;
  out["replayable"] = !info.header.step_state.empty();
  out["why_no_exact_replay"] = recording::whyNoExactReplay(info);
  out["log"] = nlohmann::ordered_json::array();
  for (const recording::Note& note : notes.value_or(std::vector<recording::Note>())) {
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
    const auto recording = openRecording(options->file);
    auto json = describe(recording::existingName(options->file), *recording);
    if (!options->json) {  // texts of many lines are for --json
      json.erase("profile");
      json.erase("surface");
    }
    printValues(json, options->json);
  });
}

}  // namespace fyd::cli
