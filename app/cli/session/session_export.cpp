// fyd session export FILE OUT and fyd session report FILE OUT: a recording for other programs and for people.
#include <filesystem>
#include <limits>

#include "app/cli/parts/output_file.h"
#include "app/cli/session/session_cli.h"
#include "core/export/export_recording.h"
#include "core/recording/reader/recording_health.h"
#include "core/report/report.h"

namespace fyd::cli {
namespace {

struct ExportCommand {
  SessionOptions session;
  std::string out;
  exports::ExportOptions options;
};

/// A file to be replaced may be the recording itself, or another one.
void refuseToReplace(const ExportCommand& command, const std::vector<std::string>& files) {
  if (!command.options.replace) return;
  for (const std::string& file : files) refuseToDestroy(file, {command.session.file});
}

void runExport(const ExportCommand& command) {
  valueOrUsage(exports::checkExport(command.out, command.options));
  refuseToReplace(command, exports::exportFiles(command.out));
  const auto recording = openRecording(command.session.file);
  const exports::ExportResult result = valueOrFail(
      naming(command.session.file, exports::exportRecording(*recording, command.out, command.options), command.out));
  nlohmann::ordered_json json;
  json["files"] = result.files;
  for (const std::string& file : result.files) json["bytes"].push_back(std::filesystem::file_size(file));
  json["rows"] = result.rows;
  json["pictures"] = result.pictures;
  json["lines"] = result.lines;
  if (result.rate_Hz > 0.0) {
    json["rate_hz"] = result.rate_Hz;
    json["repeated"] = result.repeated;
    json["left_out"] = result.left_out;
  }
  if (result.messages > 0) json["messages"] = result.messages;
  if (const auto [health, reason] = recording::healthOf(recording->info()); health != "good") {
    json["health"] = health;
    json["health_reason"] = reason;
  }
  printValues(json, command.session.json);
}

void runReport(const ExportCommand& command) {
  refuseToReplace(command, {command.out});
  const auto recording = openRecording(command.session.file);
  valueOrFail(
      naming(command.session.file, report::writeReport(*recording, command.out, command.options.replace), command.out));
  nlohmann::ordered_json json;
  json["file"] = command.out;
  json["bytes"] = std::filesystem::file_size(command.out);
  printValues(json, command.session.json);
}

}  // namespace

void addSessionExport(CLI::App& parent) {
  auto options = std::make_shared<ExportCommand>();
  CLI::App* command = parent.add_subcommand("export", "Telemetry, pictures and events for other programs");
  addSessionOptions(*command, options->session);
  command
      ->add_option(
          "out", options->out,
          "OUT.csv telemetry, OUT.mat MATLAB, OUT.mkv pictures without loss, OUT.avi pictures small, OUT.mcap all")
      ->required();
  command->add_option("--from", options->options.from_s, "First second from the recording's start");
  command->add_option("--to", options->options.to_s, "Last second");
  addWords(*command, "--fields", options->options.fields, "Telemetry fields, with commas between; all when left out");
  command->add_flag("--region", options->options.region,
                    "Pictures: the finger detector's region of interest, exactly, instead of the whole picture");
  command->add_flag("--force", options->options.replace, "Replace files that exist");
  command->callback([options] { runExport(*options); });
}

void addSessionReport(CLI::App& parent) {
  auto options = std::make_shared<ExportCommand>();
  CLI::App* command = parent.add_subcommand("report", "One page for people: curves, touches, gains, events, health");
  addSessionOptions(*command, options->session);
  command->add_option("out", options->out, "OUT.html or OUT.pdf")->required()->check(goodFor(report::checkReportName));
  command->add_flag("--force", options->options.replace, "Replace a file that exists");
  command->callback([options] { runReport(*options); });
}

}  // namespace fyd::cli
