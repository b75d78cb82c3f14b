// fyd session replay FILE: runs the recorded inputs through the step again, with the same or other parameters.
#include "app/cli/parts/telemetry_csv.h"
#include "app/cli/session/session_cli.h"
#include "core/catalogue/catalogue_types.h"
#include "core/replay/replay.h"

namespace fyd::cli {
namespace {

struct SessionReplayOptions {
  SessionOptions session;
  replay::ReplayOptions replay;
  std::string telemetry;
};

nlohmann::ordered_json toJson(const replay::ReplayResult& result, const recording::RecordingInfo& info) {
  nlohmann::ordered_json out;
  out["wholeness"] = catalogue::toString(info.wholeness);
  out["lateness"] = info.header.lateness;
  out["identical"] = result.identical;
  out["what_if"] = result.what_if;
  out["loop"] = result.closed_loop ? "closed" : "open";
  out["start"] = result.from_rest ? "from rest" : "recorded state";
  out["samples"] = result.samples;
  out["of"] = result.of;
  out["gaps"] = result.gaps;
  out["why_not_exact"] = result.why_not_exact;
  out["different"] = result.different;
  out["arithmetic_recorded"] = result.arithmetic_recorded;
  out["arithmetic_replayed"] = pipeline::kArithmetic;
  if (result.tolerance) {
    out["tolerance"] = {{"since", result.tolerance->since},
                        {"changed", result.tolerance->name},
                        {"field", result.tolerance->of_a_field},
                        {"command", result.tolerance->of_a_command},
                        {"beyond", result.beyond_tolerance}};
  }
  out["out_of_range"] = result.out_of_range;
  out["unknown_changes"] = result.unknown_changes;
  out["first_difference_s"] = jsonNumber(result.first_difference_s);
  out["first_difference_field"] = result.first_difference_field;
  out["max_abs_difference"] = jsonNumber(result.max_abs_difference);
  out["max_difference_field"] = result.max_difference_field;
  out["stiffness_error_recorded_percent"] = jsonNumber(result.stiffness_error_recorded_percent);
  out["stiffness_error_replayed_percent"] = jsonNumber(result.stiffness_error_replayed_percent);
  out["duration_s"] = result.duration_s;
  out["speed_x"] = result.speed_x;
  if (result.cloth) {
    out["identified"] = {{"residual_relative", result.cloth->residual_rms_relative},
                         {"scale", result.cloth->scale},
                         {"shape_gain", result.cloth->shape_gain},
                         {"slope_N_per_mm_deg", result.cloth->slope_N_per_mm_deg},
                         {"delay_s", result.cloth->delay_s},
                         {"lag_s", result.cloth->lag_s}};
  }
  return out;
}

/// A recording of another arithmetic version cannot be reproduced bit for bit: this is reported, and is no failure as
/// long as no step lies beyond what is known of that arithmetic. Nothing is known of a later one.
void sayArithmetic(const std::string& file, const replay::ReplayResult& result) {
  std::string judged = "this program does not know that one";
  if (result.tolerance) {
    judged = fmt::format("{}; {} of the steps lie beyond the tolerance stated for that", result.tolerance->name,
                         result.beyond_tolerance == 0 ? "none" : fmt::format("{}", result.beyond_tolerance));
  }
  fmt::print(stderr,
             "fyd: {}: recorded with arithmetic {}, replayed with {}: {} of {} steps differ, by at most "
             "{:.3g} in {} ({})\n",
             file, result.arithmetic_recorded, pipeline::kArithmetic, result.different, result.samples,
             result.max_abs_difference, result.max_difference_field, judged);
}

Message whyNotIdentical(const replay::ReplayResult& result) {
  if (!result.why_not_exact.empty()) return say("cannot be proven bit for bit: {}", result.why_not_exact);
  if (result.different > 0)
    return say("{} of {} steps differ, the first at {:.3f} s in {}", result.different, result.samples,
               result.first_difference_s, result.first_difference_field);
  return say("only {} of {} steps could be replayed: after them steps were lost", result.samples, result.of);
}

}  // namespace

void addSessionReplay(CLI::App& parent) {
  auto options = std::make_shared<SessionReplayOptions>();
  CLI::App* command = parent.add_subcommand("replay", "Run a recording through the step again and compare");
  addSessionOptions(*command, options->session);
  command->add_option("--set", options->replay.settings, "What if: id=value of the step's parameters; may be repeated")
      ->allow_extra_args(false);
  command->add_flag("--closed-loop", options->replay.closed_loop,
                    "Motors and cloth answer, as identified from the recording");
  command->add_option("--telemetry", options->telemetry, "Write every replayed step's sample to this CSV file");
  command->callback([options] {
    if (const auto good = replay::checkSettings(options->replay.settings); !good) {
      throw UsageError(about("--set", good.error().message));
    }
    const auto recording = openRecording(options->session.file);
    std::unique_ptr<TelemetryCsv> csv;
    replay::ReplayObserver observer;
    if (!options->telemetry.empty()) {
      csv = std::make_unique<TelemetryCsv>(options->telemetry, std::vector{options->session.file}, Appears::whole);
      observer = [&csv](const pipeline::TelemetrySample& replayed, const pipeline::TelemetrySample&) {
        csv->write(replayed);
      };
    }
    const replay::ReplayResult result =
        valueOrFail(naming(options->session.file, replay::replay(*recording, options->replay, observer)));
    if (csv) csv->close();
    printValues(toJson(result, recording->info()), options->session.json);
    const bool proves = !result.what_if && !result.closed_loop;
    if (proves && result.different > 0 && result.arithmetic_recorded != pipeline::kArithmetic) {
      sayArithmetic(options->session.file, result);
      if (result.explained) return;
    }
    if (proves && !result.identical) {
      throw Failure(about(options->session.file, whyNotIdentical(result)));
    }
  });
}

}  // namespace fyd::cli
