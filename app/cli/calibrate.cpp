// fyd calibrate ir|load-cell|stiffness|cloth|camera|encoders|rest|texture SAMPLES.csv
//               [--profile P] [--who W] [--conditions C] [--report FILE] [--json]
#include <algorithm>
#include <filesystem>

#include "app/cli/calibrate_report.h"
#include "app/cli/sense_table.h"
#include "core/calibration/calibration_dependence.h"
#include "core/calibration/camera_calibration.h"
#include "core/calibration/cloth_calibration.h"
#include "core/calibration/encoder_calibration.h"
#include "core/calibration/ir_calibration.h"
#include "core/calibration/load_cell_calibration.h"
#include "core/calibration/rest_calibration.h"
#include "core/calibration/stiffness_map.h"
#include "core/calibration/texture_calibration.h"
#include "core/station/profile/calibration_file.h"

namespace fyd::cli {
namespace {

struct IrCommand : CalibrateOptions {
  int sensor = 1;
  bool without_outliers = false;
};

void calibrateIr(const IrCommand& options) {
  const CsvTable table = valueOrFail(readCsv(options.samples, {"adc", "distance_mm"}));
  const station::Profile profile = options.load();
  const auto found = calibration::calibrateIr(
      {.adc = table.values[0], .distance_mm = table.values[1]}, profile.step.sensing.indentation, profile.calibration,
      {.sensor = static_cast<std::size_t>(options.sensor - 1), .without_outliers = options.without_outliers});
  nlohmann::ordered_json json = calibrationJson(found.result, table);
  json["sensor"] = options.sensor;
  json["valid_from_mm"] = jsonNumber(found.valid_from_mm);
  json["valid_to_mm"] = jsonNumber(found.valid_to_mm);
  json["candidates"] = nlohmann::ordered_json::array();
  for (const calibration::IrAttempt& attempt : found.attempts) {
    json["candidates"].push_back({{"curve", calibration::toString(attempt.candidate)},
                                  {"rmse", jsonNumber(attempt.rmse_mm)},
                                  {"held_out_rmse", jsonNumber(attempt.held_out_rmse_mm)},
                                  {"condition_number", jsonNumber(attempt.condition_number)},
                                  {"problem", attempt.problem}});
  }
  finish(options, found.result, table, json, options.sensor);
}

void calibrateLoadCell(const CalibrateOptions& options) {
  const CsvTable table = valueOrFail(readCsv(options.samples, {"value", "force_N"}));
  const auto found = calibration::calibrateLoadCell({.value_mV_per_V = table.values[0], .force_N = table.values[1]},
                                                    options.load().calibration);
  nlohmann::ordered_json json = calibrationJson(found.result, table);
  json["drift_N"] = jsonNumber(found.drift_N);
  json["drift_error_N"] = jsonNumber(found.drift_error_N);
  json["hysteresis_N"] = jsonNumber(found.hysteresis_N);
  json["repeatability_N"] = jsonNumber(found.repeatability_N);
  finish(options, found.result, table, json);
}

/// Whether the profile's cloth was calibrated and its present parameters are those of the calibration.
bool clothProven(const CalibrateOptions& options) {
  if (options.profile.empty() || !std::filesystem::exists(options.profile)) return false;
  station::Profile profile = options.load();
  const auto records =
      station::recordsFor(valueOrFail(station::loadCalibrationRecords(options.profile)), options.touchpadOf());
  return calibration::clothProven(records, bindParameters(profile));
}

void calibrateStiffness(const CalibrateOptions& options) {
  const CsvTable table = valueOrFail(readCsv(options.samples, {"angle_deg", "indentation_mm", "force_N"}));
  auto found = calibration::calibrateStiffness(
      {.angle_deg = table.values[0], .indentation_mm = table.values[1], .force_N = table.values[2]},
      options.load().calibration);
  if (!clothProven(options)) calibration::sayIndentationUnproven(found.result);
  nlohmann::ordered_json json = calibrationJson(found.result, table);
  json["force_offset_N"] = jsonNumber(found.force_offset_N);
  json["force_offset_error_N"] = jsonNumber(found.force_offset_error_N);
  json["angles"] = nlohmann::ordered_json::array();
  for (const calibration::AngleStiffness& a : found.angles) {
    json["angles"].push_back({{"angle_deg", a.angle_deg},
                              {"stiffness_N_per_mm", jsonNumber(a.stiffness_N_per_mm)},
                              {"standard_error", jsonNumber(a.standard_error)},
                              {"low_95", jsonNumber(a.low_95)},
                              {"high_95", jsonNumber(a.high_95)},
                              {"points", a.points}});
  }
  json["law_angle_deg"] = found.law_angle_deg;
  json["law_stiffness_N_per_mm"] = found.law_stiffness_N_per_mm;
  finish(options, found.result, table, json);
}

void calibrateCamera(const CalibrateOptions& options) {
  const std::string text = readCsvText(options.samples);  // once: a pipe cannot be read again
  CsvTable table = valueOrFail(parseCsv(text, options.samples, {"x_px", "y_px", "x_mm", "y_mm"}));
  const bool with_depth = std::ranges::find(table.header, "depth_mm") != table.header.end();
  if (with_depth) {
    table = valueOrFail(parseCsv(text, options.samples, {"x_px", "y_px", "x_mm", "y_mm", "depth_mm"}));
  }
  const auto found = calibration::calibrateCamera({.x_px = table.values[0],
                                                   .y_px = table.values[1],
                                                   .x_mm = table.values[2],
                                                   .y_mm = table.values[3],
                                                   .depth_mm = with_depth ? table.values[4] : std::vector<double>{}},
                                                  options.load().calibration);
  nlohmann::ordered_json json = calibrationJson(found.result, table);
  json["rotation_deg"] = jsonNumber(found.rotation_deg);
  json["rotation_error_deg"] = jsonNumber(found.rotation_error_deg);
  json["rotation_used"] = found.rotated;
  json["shear_deg"] = jsonNumber(found.shear_deg);
  json["mirrored"] = found.mirrored;
  finish(options, found.result, table, json);
}

void calibrateEncoders(const CalibrateOptions& options) {
  const CsvTable table =
      valueOrFail(readCsv(options.samples, {"first_deg", "first_counts", "second_deg", "second_counts"}));
  const auto found = calibration::calibrateEncoders(
      {.command_deg = {table.values[0], table.values[2]}, .counts = {table.values[1], table.values[3]}},
      options.load().calibration);
  nlohmann::ordered_json json = calibrationJson(found.result, table);
  json["encoders"] = nlohmann::ordered_json::array();
  for (const calibration::EncoderFinding& encoder : found.encoders) {
    json["encoders"].push_back({{"inverted", encoder.inverted},
                                {"zero_counts", encoder.zero_counts},
                                {"counts_per_deg", jsonNumber(encoder.counts_per_deg)},
                                {"from_deg", jsonNumber(encoder.from_deg)},
                                {"to_deg", jsonNumber(encoder.to_deg)}});
  }
  finish(options, found.result, table, json);
}

void calibrateRest(const CalibrateOptions& options) {
  const CsvTable table = valueOrFail(readCsv(options.samples, {"x_g", "y_g", "z_g"}));
  const auto found =
      calibration::calibrateRest({{table.values[0], table.values[1], table.values[2]}}, options.load().calibration);
  nlohmann::ordered_json json = calibrationJson(found.result, table);
  json["sigma_g"] = found.sigma_g;
  json["magnitude_g"] = jsonNumber(found.magnitude_g);
  finish(options, found.result, table, json);
}

void calibrateCloth(const CalibrateOptions& options) {
  const station::Profile profile = options.load();
  const sensing::IndentationParameters& indentation = profile.step.sensing.indentation;
  const SenseTable table = readSenseTable(options.samples, indentation);
  const auto found = calibration::calibrateCloth(
      {.codes = table.codes, .x_mm = table.x_mm, .y_mm = table.y_mm, .area_mm2 = table.area_mm2}, indentation,
      profile.calibration);
  nlohmann::ordered_json json = calibrationJson(found.result, table.csv);
  json["edges"] = sensing::kClothEdgesNames[static_cast<std::size_t>(found.edges)];
  json["other_edges_rmse"] = jsonNumber(found.other_edges_rmse);
  json["share_sigma"] = jsonNumber(found.share_sigma);
  json["stiffness_error"] = jsonNumber(found.stiffness_error);
  json["sensors"] = nlohmann::ordered_json::array();
  for (const calibration::ClothSensor& sensor : found.sensors) {
    json["sensors"].push_back({{"presses", sensor.presses},
                               {"shallowest_mm", jsonNumber(sensor.shallowest_mm)},
                               {"deepest_mm", jsonNumber(sensor.deepest_mm)}});
  }
  finish(options, found.result, table.csv, json);
}

void calibrateTexture(const CalibrateOptions& options) {
  const auto sweep = valueOrFail(texture::parseSweep(readTextFile(options.samples), options.samples));
  const auto found = calibration::calibrateTexture(sweep, options.load().step.texture.plant);
  const CsvTable no_points;
  nlohmann::ordered_json json = calibrationJson(found.result, no_points);
  json["sliding_share"] = found.identified.sliding_share;
  finish(options, found.result, no_points, json);
}

template <class Options>
std::shared_ptr<Options> addPart(CLI::App& parent, const std::string& name, const std::string& help,
                                 const std::string& columns, void (*run)(const Options&)) {
  auto options = std::make_shared<Options>();
  CLI::App* command = parent.add_subcommand(name, help);
  options->addTo(*command, columns);
  if constexpr (std::is_same_v<Options, IrCommand>) {
    command->add_option("--sensor", options->sensor, "Which distance sensor, from 1")->transform(wholeNumberFrom(1, 8));
    command->add_flag("--without-outliers", options->without_outliers, "Fit without the points the others contradict");
  }
  command->callback([options, run] { run(*options); });
  return options;
}

}  // namespace

void add_calibrate(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("calibrate", "Fit a part's calibration from samples, judge it, write it into a profile");
  command->require_subcommand(1);
  addPart(*command, "ir", "A distance sensor at known distances", "adc,distance_mm", calibrateIr);
  addPart(*command, "load-cell", "The load cell under known weights", "value,force_N", calibrateLoadCell);
  addPart(*command, "stiffness", "Presses at known stretch angles", "angle_deg,indentation_mm,force_N",
          calibrateStiffness);
  addPart(*command, "cloth", "Presses over each distance sensor at two depths",
          "adc1,adc2,adc3,x_mm,y_mm,area_mm2,bridge_mV_per_V", calibrateCloth);
  addPart(*command, "camera", "A printed target, its marks on the cloth or pressed down",
          "x_px,y_px,x_mm,y_mm[,depth_mm]", calibrateCamera);
  addPart(*command, "encoders", "A commanded sweep of both motors", "first_deg,first_counts,second_deg,second_counts",
          calibrateEncoders);
  addPart(*command, "rest", "The accelerometer lying still", "x_g,y_g,z_g", calibrateRest);
  addPart(*command, "texture", "Duty ramps, and chirps with an accelerometer on the cloth",
          "t_s,part,stretch_deg,duty1_percent,duty2_percent,encoder1_counts,encoder2_counts,acceleration_g",
          calibrateTexture);
}

}  // namespace fyd::cli
