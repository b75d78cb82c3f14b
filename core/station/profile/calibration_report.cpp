#include "core/station/profile/calibration_report.h"

#include <algorithm>
#include <cmath>

#include "core/base/whole_file.h"
#include "core/calibration/calibration_dependence.h"
#include "core/report/report.h"
#include "core/station/profile/profile.h"
#include "core/station/profile/touchpad_name.h"

namespace fyd::station {
namespace {

using calibration::CalibrationRecord;

constexpr int kDigits = 4;

std::string errorOf(double value, const std::string& unit) {
  return std::isfinite(value) ? calibration::errorWithUnit(value, unit).text() : report::reportNumber(value, kDigits);
}

std::string partOf(const CalibrationRecord& record) {
  return record.sensor > 0 ? fmt::format("{} {}", record.procedure, record.sensor) : record.procedure;
}

std::string orNothing(const std::string& text) { return text.empty() ? "not said" : text; }

/// A line for each point from 0 to its residual.
report::ChartStrip stems(const CalibrationRecord& record, const std::string& title, report::Rgb colour) {
  report::ChartCurve curve{.values = {}, .colour = colour};
  for (std::size_t i = 0; i < record.residuals.size(); ++i) {
    const double residual = record.residuals[i], number = static_cast<double>(i + 1);
    curve.values.time_s.insert(curve.values.time_s.end(), {number, number});
    curve.values.values.push_back({std::min(0.0, residual), std::max(0.0, residual)});
    curve.values.values.push_back({calibration::kUnknown, calibration::kUnknown});
  }
  return {.title = title, .colour = colour, .curves = {std::move(curve)}};
}

report::ReportTable errorsTable(const CalibrationRecord& record, const CalibrationRecord* former) {
  report::ReportTable out{.heading = "How well",
                          .remark = former == nullptr ? "There is no calibration of this part before this one." : "",
                          .columns = {{.title = "", .share = 2.0},
                                      {.title = "before", .share = 2.0, .number = true},
                                      {.title = "now", .share = 2.0, .number = true}},
                          .rows = {}};
  const auto row = [&](const char* what, auto text) {
    out.rows.push_back(
        {what, former != nullptr ? text(*former) : report::reportNumber(calibration::kUnknown, 0), text(record)});
  };
  row("when", [](const CalibrationRecord& r) { return r.when; });
  row("who", [](const CalibrationRecord& r) { return orNothing(r.who); });
  row("curve", [](const CalibrationRecord& r) { return r.curve; });
  row("points", [](const CalibrationRecord& r) { return fmt::format("{}", r.points); });
  row("points the others contradict", [](const CalibrationRecord& r) { return fmt::format("{}", r.outliers); });
  row("held-out error", [](const CalibrationRecord& r) { return errorOf(r.held_out_rmse, r.unit); });
  row("error of the fit", [](const CalibrationRecord& r) { return errorOf(r.rmse, r.unit); });
  row("largest residual", [](const CalibrationRecord& r) { return errorOf(r.max_residual, r.unit); });
  row("condition number", [](const CalibrationRecord& r) { return report::reportNumber(r.condition_number, 1); });
  return out;
}

report::ReportTable valuesTable(const CalibrationReport& report) {
  report::ReportTable out{.heading = "Values",
                          .remark = {},
                          .columns = {{.title = "parameter", .share = 3.0},
                                      {.title = "before", .share = 3.0},
                                      {.title = "after", .share = 3.0},
                                      {.title = "unit", .share = 1.0}},
                          .rows = {}};
  Profile described;
  const auto bound = bindParameters(described);
  for (const calibration::AppliedChange& change : report.record.changes) {
    const bool left = change.before == change.after && calibration::isTared(report.record.procedure, change.id);
    const Parameter* parameter = findParameter(bound, change.id);
    const bool has_unit = parameter != nullptr && parameter->info.unit != "1";
    out.rows.push_back({change.id, change.before, left ? "as before: to be taken again" : change.after,
                        has_unit ? std::string(parameter->info.unit) : std::string()});
  }
  if (!out.rows.empty()) return out;
  out.remark = report.accepted ? "This calibration is a check: it changes no value."
                               : "Refused: the values in force stay as they were.";
  return out;
}

report::ReportTable residualsTable(const CalibrationReport& report) {
  const CalibrationRecord& record = report.record;
  report::ReportTable out{.heading = "Residuals",
                          .remark = "Measured less fitted.",
                          .columns = {{.title = "point", .share = 1.0, .number = true},
                                      {.title = fmt::format("residual, {}", record.unit), .share = 2.0, .number = true},
                                      {.title = "", .share = 6.0}},
                          .rows = {}};
  constexpr std::size_t kMost = 200;
  for (std::size_t i = 0; i < std::min(record.residuals.size(), kMost); ++i) {
    const bool outlier = std::ranges::find(report.outliers, i) != report.outliers.end();
    out.rows.push_back({fmt::format("{}", i + 1), report::reportNumber(record.residuals[i], kDigits),
                        outlier ? "the others contradict it" : ""});
  }
  if (record.residuals.size() > kMost) {
    out.remark +=
        fmt::format(" The first {} of {}; the record beside the profile has all.", kMost, record.residuals.size());
  }
  return out;
}

/// What was fitted, each with its standard uncertainty where the fit gives one.
report::ReportTable coefficientsTable(const CalibrationRecord& record) {
  report::ReportTable out{.heading = "Coefficients",
                          .remark = "With their standard uncertainty (one standard deviation).",
                          .columns = {{.title = "coefficient", .share = 3.0},
                                      {.title = "value", .share = 2.0, .number = true},
                                      {.title = "uncertainty", .share = 2.0, .number = true},
                                      {.title = "unit", .share = 2.0}},
                          .rows = {}};
  for (const calibration::Coefficient& each : record.coefficients) {
    const bool known = std::isfinite(each.standard_error);
    out.rows.push_back({each.name, report::reportNumber(each.value, kDigits),
                        known ? fmt::format("± {:.2g}", each.standard_error) : "none: a mean, not a fit", each.unit});
  }
  return out;
}

/// The points as they were measured, every column with its unit.
report::ReportTable pointsTable(const CalibrationRecord& record) {
  report::ReportTable out{
      .heading = "Points", .remark = {}, .columns = {{.title = "point", .share = 1.0, .number = true}}, .rows = {}};
  constexpr std::size_t kMost = 200;
  const std::size_t count = record.samples.front().values.size();
  for (const calibration::SampleColumn& column : record.samples) {
    out.columns.push_back({.title = fmt::format("{}, {}", column.name, column.unit), .share = 2.0, .number = true});
  }
  for (std::size_t i = 0; i < std::min(count, kMost); ++i) {
    std::vector<std::string> row = {fmt::format("{}", i + 1)};
    for (const calibration::SampleColumn& column : record.samples) {
      row.push_back(report::reportNumber(i < column.values.size() ? column.values[i] : calibration::kUnknown, kDigits));
    }
    out.rows.push_back(std::move(row));
  }
  if (count > kMost) {
    out.remark = fmt::format("The first {} of {}; the record beside the profile has all.", kMost, count);
  }
  return out;
}

}  // namespace

RecordPair newestOf(const std::vector<CalibrationRecord>& records, const std::string& procedure, int sensor) {
  RecordPair out;
  for (const CalibrationRecord& record : records) {
    if (record.procedure != procedure || record.sensor != sensor) continue;
    out.former = out.newest;
    out.newest = &record;
  }
  return out;
}

report::ReportContent gatherCalibrationReport(const CalibrationReport& report, const CalibrationRecord* former,
                                              const std::string& profile) {
  const CalibrationRecord& record = report.record;
  report::ReportContent out;
  out.title = fmt::format("Calibration: {}", partOf(record));
  out.kind = "calibration report";
  out.facts = {{"part", partOf(record)},
               {"when", record.when},
               {"who", orNothing(record.who)},
               {"conditions", orNothing(record.conditions)},
               {"touchpad", describeTouchpad(record.touchpad).text()},
               {"profile", profile.empty() ? "none was written" : profile},
               {"curve", record.curve},
               {report.accepted ? "accepted" : "refused", record.verdict}};
  out.time.range = {0.0, static_cast<double>(record.residuals.size() + 1)};
  if (!record.residuals.empty()) {
    out.strips.push_back(stems(record, fmt::format("Residuals, {}", record.unit), report::kForceRgb));
  }
  if (former != nullptr && !former->residuals.empty()) {
    out.time.range.to_s = std::max(out.time.range.to_s, static_cast<double>(former->residuals.size() + 1));
    out.strips.push_back(stems(*former, fmt::format("Residuals before, {}", former->unit), report::kMutedRgb));
  }
  out.time.axis = "point";
  out.figure = "Residual of each point";
  out.legend = out.strips.empty() ? "" : "A line for each point, from 0 to its residual.";
  out.tables = {errorsTable(record, former), valuesTable(report), residualsTable(report)};
  if (!record.coefficients.empty()) out.tables.push_back(coefficientsTable(record));
  if (!record.samples.empty()) out.tables.push_back(pointsTable(record));
  return out;
}

Result<void> writeCalibrationReport(const CalibrationReport& report, const CalibrationRecord* former,
                                    const std::string& profile, const std::string& path, bool replace) {
  return report::writeReport(gatherCalibrationReport(report, former, profile), path, replace);
}

}  // namespace fyd::station
