#include "app/cli/calibrate_report.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <iostream>

#include "core/report/report.h"
#include "core/station/profile/calibrated_values.h"
#include "core/station/profile/calibration_file.h"
#include "core/station/profile/calibration_report.h"
#include "core/station/profile/touchpad_name.h"

namespace fyd::cli {
namespace {

std::string nowUtc() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[32];
  (void)std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

nlohmann::ordered_json numbers(const std::vector<double>& values) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const double value : values) out.push_back(jsonNumber(value));
  return out;
}

void printCalibrateReport(const nlohmann::ordered_json& json) {
  for (const auto& [key, value] : json.items()) {
    if (key == "residuals" || key == "accepted" || key == "reason") continue;
    const bool rows = value.is_array() && !value.empty() && value.front().is_object();
    if (!rows) {
      std::cout << fmt::format("{:<28}{}\n", key, textOf(value));
      continue;
    }
    std::cout << key << '\n';
    for (const auto& row : value) {
      std::cout << "   ";
      for (const auto& [name, cell] : row.items()) {
        std::cout << fmt::format(" {} {} ", name, textOf(cell));
      }
      std::cout << '\n';
    }
  }
  std::cout << (json["accepted"].get<bool>() ? "accepted: " : "refused: ") << json["reason"].get<std::string>() << '\n';
}

/// Records the profile has already, for the report's "before"; none without a report or a profile.
std::vector<calibration::CalibrationRecord> recordsBefore(const CalibrateOptions& options) {
  if (options.report.empty() || options.profile.empty()) return {};
  return station::recordsFor(valueOrFail(station::loadCalibrationRecords(options.profile)), options.touchpadOf());
}

}  // namespace

void CalibrateOptions::addTo(CLI::App& command, const std::string& columns) {
  command.add_option("samples", samples, fmt::format("CSV with the columns {}", columns))->required();
  command.add_option("--profile", profile,
                     "Profile to write an accepted result into; made from the defaults if it is new");
  command
      .add_option("--touchpad", touchpad,
                  "Touchpad that was measured: serial:NUMBER, its address, or simulated; default: the one that the "
                  "profile belongs to")
      ->check(goodFor(station::checkTouchpadName));
  command.add_option("--who", who, "Who measured, for the record");
  command.add_option("--conditions", conditions, "Light, temperature, target: for the record");
  command.add_option("--report", report, "Before and after as a new .pdf or .html file, of a refused fit too")
      ->check(goodFor(report::checkReportName));
  command.add_flag("--json", json, "As JSON; null stands for what is not known");
}

std::string CalibrateOptions::touchpadOf() const {
  if (!touchpad.empty() || profile.empty() || !std::filesystem::exists(profile)) return touchpad;
  return valueOrFail(station::loadProfile(profile)).calibrated_on;
}

station::Profile CalibrateOptions::load() const {
  station::TouchpadProfile loaded = valueOrFail(station::loadProfileFor(profile, touchpadOf()));
  if (!loaded.notice.empty()) std::cerr << fmt::format("warning: {}\n", loaded.notice.text());
  return std::move(loaded.profile);
}

nlohmann::ordered_json calibrationJson(const calibration::CalibrationResult& result, const CsvTable& table) {
  nlohmann::ordered_json json;
  json["procedure"] = result.procedure;
  json["curve"] = result.curve;
  json["points"] = result.points;
  json["coefficients"] = nlohmann::ordered_json::array();
  json["standard_errors"] = nlohmann::ordered_json::array();
  json["coefficient_names"] = nlohmann::ordered_json::array();
  json["coefficient_units"] = nlohmann::ordered_json::array();
  for (const calibration::Coefficient& c : result.coefficients) {
    json["coefficients"].push_back(jsonNumber(c.value));
    json["standard_errors"].push_back(jsonNumber(c.standard_error));
    json["coefficient_names"].push_back(c.name);
    json["coefficient_units"].push_back(c.unit);
  }
  json["unit"] = result.unit;
  json["rmse"] = jsonNumber(result.rmse);
  json["held_out_rmse"] = jsonNumber(result.held_out_rmse);
  json["max_residual"] = jsonNumber(result.max_residual);
  json["condition_number"] = jsonNumber(result.condition_number);
  json["valid_from"] = jsonNumber(result.valid_from);
  json["valid_to"] = jsonNumber(result.valid_to);
  json["valid_unit"] = result.valid_unit;
  json["outliers"] = nlohmann::ordered_json::array();
  for (const std::size_t row : result.outliers) {
    nlohmann::ordered_json outlier = {{"line", table.lines[row]}};
    for (std::size_t c = 0; c < table.columns.size(); ++c) outlier[table.columns[c]] = jsonNumber(table.values[c][row]);
    outlier["residual"] = row < result.residuals.size() ? jsonNumber(result.residuals[row]) : nullptr;
    json["outliers"].push_back(outlier);
  }
  json["residuals"] = numbers(result.residuals);
  json["notes"] = result.notes;
  return json;
}

void finish(const CalibrateOptions& options, const calibration::CalibrationResult& result, const CsvTable& table,
            nlohmann::ordered_json json, int sensor) {
  Message reason = result.verdict.reason;
  if (result.bad_row < table.rows()) {
    reason = about(fmt::format("{}:{}", options.samples, table.lines[result.bad_row]), reason);
  }
  json["changes"] = nlohmann::ordered_json::array();
  for (const calibration::ParameterChange& change : result.changes) {
    json["changes"].push_back({{"id", change.id}, {"after", change.value}});
  }
  json["threshold"] = result.verdict.threshold;
  json["accepted"] = result.verdict.accepted;
  json["reason"] = reason;
  if (!options.report.empty()) valueOrFail(report::checkReportTarget(options.report, false));
  const auto former = recordsBefore(options);
  calibration::CalibrationRecord said;
  said.sensor = sensor;
  said.who = options.who;
  said.when = nowUtc();
  said.conditions = options.conditions;
  said.touchpad = options.touchpadOf();
  said.simulated = station::isSimulated(said.touchpad);
  auto record = calibration::makeRecord(result, {}, std::move(said));
  if (result.verdict.accepted && !options.profile.empty()) {
    station::Profile profile = options.load();
    record = valueOrFail(station::saveCalibration(result, record, profile, options.profile));
    json["changes"] = nlohmann::ordered_json::array();
    for (const calibration::AppliedChange& change : record.changes) {
      if (std::ranges::find(result.changes, change.id, &calibration::ParameterChange::id) == result.changes.end()) {
        continue;  // left behind as it was
      }
      json["changes"].push_back({{"id", change.id}, {"before", change.before}, {"after", change.after}});
    }
    json["to_do_again"] = nlohmann::ordered_json::array();
    for (const station::OutdatedPart& each : valueOrFail(station::outdatedParts(options.profile, profile))) {
      json["to_do_again"].push_back({{"part", each.part}, {"why", each.why}});
    }
    json["written_to"] = options.profile;
    json["record"] = station::calibrationFileOf(options.profile);
  }
  if (!options.report.empty()) {
    if (record.changes.empty() && result.verdict.accepted) {
      station::Profile defaults = options.load();
      record.changes = valueOrFail(calibration::applyChanges(bindParameters(defaults), result.changes));
    }
    const auto written = station::writeCalibrationReport(
        {.record = record, .accepted = result.verdict.accepted, .outliers = result.outliers},
        station::newestOf(former, record.procedure, sensor).newest, options.profile, options.report, false);
    if (!written) {
      const Message& why = written.error().message;
      throw Failure(json.contains("written_to") ? say("{}; the calibration is saved in {}", why, options.profile)
                                                : why);
    }
    json["report"] = options.report;
  }
  if (options.json) {
    printJson(json);
  } else {
    printCalibrateReport(json);
  }
  std::cout.flush();
  if (!result.verdict.accepted) {
    throw Failure(result.bad_row < table.rows() ? reason : about(options.samples, reason));
  }
}

}  // namespace fyd::cli
