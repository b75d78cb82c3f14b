#include "core/calibration/calibration_part.h"

#include <algorithm>

namespace fyd::calibration {
namespace {

constexpr std::string_view kNoTouch = "no-touch";
constexpr std::string_view kStiffness = "stiffness";
constexpr std::string_view kDependentParts[] = {kNoTouch, kStiffness};

constexpr Dependence kDependences[] = {
    {kNoTouch, "ir", "sensing.ir_offset_mm"},
    {kNoTouch, "load-cell", "sensing.force_zero_N"},
    {kStiffness, "encoders", {}},
    {kStiffness, "load-cell", {}},
    {kStiffness, "ir", {}},
    {kStiffness, "cloth", {}},
};

// The no-touch offsets come with the new curves, and after the load cell, which begins with a zero of 0.
constexpr CalibrationPart kParts[] = {{"encoders"}, {"load-cell"}, {"ir"},        {"no-touch", true}, {"camera-region"},
                                      {"camera"},   {"cloth"},     {"stiffness"}, {"rest"},           {"texture"}};

// Beginnings of the ids of all values that a calibration or the tare writes, and the part whose values they are.
struct CalibratedValue {
  std::string_view begin;
  std::string_view procedure;
};
constexpr CalibratedValue kCalibrated[] = {
    {"control.encoder_", "encoders"},
    {"control.law", kStiffness},
    {"control.measurement_bias", "cloth"},
    {"sensing.camera_height_mm", "camera"},
    {"sensing.cloth_", "cloth"},
    {"sensing.contact_radius_share", "cloth"},
    {"sensing.finger_centre_", "camera"},
    {"sensing.finger_mirror", "camera"},
    {"sensing.finger_rotation_deg", "camera"},
    {"sensing.finger_scale_", "camera"},
    {"sensing.finger_threshold", "camera-region"},
    {"sensing.force_offset_g", "load-cell"},
    {"sensing.force_slope_g", "load-cell"},
    {"sensing.force_zero_N", kNoTouch},
    {"sensing.indentation_mode", "cloth"},
    {"sensing.ir1_", "ir"},
    {"sensing.ir2_", "ir"},
    {"sensing.ir3_", "ir"},
    {"sensing.ir4_", "ir"},
    {"sensing.ir5_", "ir"},
    {"sensing.ir6_", "ir"},
    {"sensing.ir7_", "ir"},
    {"sensing.ir8_", "ir"},
    {"sensing.ir_highest_code", "ir"},
    {"sensing.ir_lowest_code", "ir"},
    {"sensing.ir_offset_mm", kNoTouch},
    {"sensing.roi_", "camera-region"},
    {"texture.plant_", "texture"},
};

}  // namespace

std::string_view calibratedBy(std::string_view parameter_id) {
  for (const CalibratedValue& value : kCalibrated) {
    if (parameter_id.starts_with(value.begin)) return value.procedure;
  }
  return {};
}

std::span<const CalibrationPart> calibrationParts() { return kParts; }

Message partName(std::string_view procedure, int sensor) {
  if (procedure == "encoders") return say("Encoders: sign, zero, range");
  if (procedure == "load-cell") return say("Load cell");
  if (procedure == "ir") return say("Distance sensor {}", sensor);
  if (procedure == "no-touch") return say("No-touch offsets");
  if (procedure == "camera-region") return say("Camera: region, threshold");
  if (procedure == "camera") return say("Camera: scale");
  if (procedure == "cloth") return say("Cloth");
  if (procedure == "stiffness") return say("Stiffness map");
  if (procedure == "rest") return say("Accelerometer at rest");
  if (procedure == "texture") return say("Vibration: motors and cloth");
  return verbatim(std::string(procedure));
}

std::span<const Dependence> dependences() { return kDependences; }

std::span<const std::string_view> dependentParts() { return kDependentParts; }

Message remedyOf(std::string_view procedure) {
  return procedure == kNoTouch ? say("taken with another curve: take it again")
                               : say("measured with another calibration: measure it again");
}

bool isTared(std::string_view procedure, std::string_view parameter_id) {
  return std::ranges::any_of(kDependences, [&](const Dependence& rests) {
    return rests.basis == procedure && !rests.tared.empty() && rests.tared == parameter_id;
  });
}

}  // namespace fyd::calibration
