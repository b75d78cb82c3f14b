// The parts of the touchpad that are calibrated, by the name of their procedure: what a person calls them, and the
// order in which they are best done.
#pragma once

#include <span>
#include <string_view>

#include "core/base/message.h"

namespace fyd::calibration {

struct CalibrationPart {
  std::string_view procedure;  ///< as in a record: "no-touch"
  bool tare_takes_it = false;  ///< a tare measures the same, without a record
};

[[nodiscard]] std::span<const CalibrationPart> calibrationParts();

/// "Distance sensor 2", "Load cell"; the procedure itself when it is none of the parts.
/// @param sensor counted from 1; 0: the part has one only
[[nodiscard]] Message partName(std::string_view procedure, int sensor);

/// The procedure that finds the parameter's value, "no-touch" also for those of the tare: such a value belongs to one
/// touchpad. Empty: it is a setting that any touchpad may have.
[[nodiscard]] std::string_view calibratedBy(std::string_view parameter_id);

/// A part that rests on another: a newer calibration of `basis` makes the values of `part` out of date.
struct Dependence {
  std::string_view part;
  std::string_view basis;
  std::string_view tared;  ///< the part's value that a tare changes too; empty: only its calibration does
};
[[nodiscard]] std::span<const Dependence> dependences();

/// The parts that rest on others.
[[nodiscard]] std::span<const std::string_view> dependentParts();

/// What is wrong with a part that has a newer basis, and what to do: "taken with another curve: take it again".
[[nodiscard]] Message remedyOf(std::string_view procedure);

/// Whether a tare may change the value without taking the calibration that it rests on out of force.
[[nodiscard]] bool isTared(std::string_view procedure, std::string_view parameter_id);

}  // namespace fyd::calibration
